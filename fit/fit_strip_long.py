"""Corrections of STRIP for contacts that are long in the rolling direction, added to those of `fit_strip.py`; writes src/strip/long_constants.rs.

    python3 fit_strip_long.py                  fit, validate, write (seven minutes)
    python3 fit_strip_long.py --fold K         keep every fifth slender row from the Kth on back, print its errors, write nothing
    options: --minutes M  --seed S  --open FILE (reports only, never fitted)

Fit the strips and TOTAL first. The constants of `fit_strip.py` stay as they are: contacts with sqrt(a/b) below 2.65 do not have these corrections.
Fitted are the rows with a/b > 7, rigid slip, states near the slender rows whose values are those of TOTAL (which is fitted to the same rows and fills the gaps
between them), and differences of neighbouring states of TOTAL.
"""

import argparse
import functools
import os
import time

import common  # sets the thread counts: before jax
import fit_strip as strip
import jax
import jax.numpy as jnp
import numpy as np

LEAST, WIDEST = 7, 66  # axis ratios
UNITS, FIXED = 20, 5
PENALTY = 0.01
LIMITS, STATES, SLIDING, SLOPES = 300, 8000, 3000, 600  # rows of rigid slip, states of TOTAL, those on the way to sliding, states whose slopes are fitted
STATE_WEIGHT = 0.7
DENSER = 0.7  # below 1: more states of TOTAL where contacts are very long
BLOCK = 1000
KEYS = ("g", "v", "c", "z", "ob", "w", "f", "wt")
STORED = strip.read_back()
RULE, TABLE = strip.RULE, strip.TABLE


# --- rows --------------------------------------------------------------------------------------


def only_long(data):
    return strip.take(data, data["g"] > LEAST)


def joined(parts, keys):
    return {key: np.concatenate([part[key] for part in parts], -1) for key in keys}


def with_stored(data):
    """Beside each row the corrections of all contacts, and the weight of those that are fitted here."""
    return {**data, "ob": np.array(strip.corrections(STORED, data["x"])), "w": np.array(strip.share_of_long(data["g"]))}


def limit_rows(n, seed=77):
    """Far in sliding, any mix of translation and spin: rigid slip is the truth there."""
    r = np.random.default_rng(seed)
    g, nu = np.exp(r.uniform(np.log(LEAST), np.log(WIDEST), n)), r.uniform(0, 0.5, n)
    return strip.sliding(g, nu, r)


def states_of_total(rows, n, seed=3):
    """States around those of the rows, and a third of any kind; the values of TOTAL.

    Its moment is not taken where it is not known to be right: in very long contacts with much spin.
    """
    r = np.random.default_rng(seed)
    i = r.integers(0, len(rows["g"]), n)
    linear, psi = rows["v"][:, i] * rows["c"][:3, i], np.pi / 3 * np.sqrt(rows["g"][i]) * rows["v"][2, i]
    g = np.exp(np.log(LEAST) + np.log(64 / LEAST) * r.random(n) ** DENSER)
    nu = np.where(r.random(n) < 0.6, 0.28, r.uniform(0, 0.5, n))
    c, per_psi = np.stack(common.coefficients(g, nu)), 3 / np.pi / np.sqrt(g)
    v = linear / c[:3] * np.exp(r.normal(0, 0.25, (3, n))) * r.choice([-1, 1], (3, n))
    # half of them keep psi instead of the linear force
    same = psi * per_psi * np.sign(v[2]) * np.sign(psi) * np.exp(r.normal(0, 0.2, n))
    v[2] = np.where(r.random(n) < 0.5, same, v[2])
    m = n // 3
    force = np.exp(r.uniform(np.log(0.03), np.log(5), (2, m))) * r.choice([-1, 1], (2, m)) * (r.random((2, m)) > 0.15)
    v[:2, :m] = force / c[:2, :m]
    v[2, :m] = np.exp(r.uniform(np.log(0.01), np.log(3.1), m)) * r.choice([-1, 1], m) * per_psi[:m]
    kept = abs(v[2]) < 3.2 * per_psi
    return valued(strip.case(g[kept], nu[kept], v[:, kept]), 1)


def on_the_way_to_sliding(n, seed=5):
    """Linear forces from 4 on, where no row of CONTACT is, with any spin; the values of TOTAL, which knows the limit."""
    r = np.random.default_rng(seed)
    g, nu = np.exp(r.uniform(np.log(LEAST), np.log(64), n)), np.where(r.random(n) < 0.6, 0.28, r.uniform(0, 0.5, n))
    c, force, angle = np.stack(common.coefficients(g, nu)), np.exp(r.uniform(np.log(4), np.log(300), n)), r.uniform(0, 2 * np.pi, n)
    psi = np.exp(r.uniform(np.log(0.005), np.log(3), n)) * r.choice([-1, 1], n)
    v = np.stack([force * np.cos(angle) / c[0], force * np.sin(angle) / c[1], psi * 3 / np.pi / np.sqrt(g)])
    return valued(strip.case(g, nu, v), 4 / force)


def valued(data, doubt):
    """With the values and weights of TOTAL, whose moment is doubtful in very long contacts with much spin."""
    f = strip.of_total(data)
    data["f"] = np.r_[f, np.zeros((1, f.shape[1]))]
    g, psi = data["g"], np.pi / 3 * np.sqrt(data["g"]) * data["v"][2]
    moment = strip.WEIGHTS[2] * np.minimum(12 / g, 1) / (1 + (np.maximum(g / 20, 1) * psi * doubt) ** 2)
    data["wt"] = STATE_WEIGHT * np.stack([np.ones_like(g), np.ones_like(g), moment, np.zeros_like(g)])
    return data


def blocks(data, seed=1):
    """Equal blocks in random order; the last one is filled with rows of no weight."""
    order = np.random.default_rng(seed).permutation(len(data["g"]))
    missing = -len(order) % BLOCK
    weight = np.concatenate([np.ones(len(order)), np.zeros(missing)])
    order, parts = np.concatenate([order, order[:missing]]), []
    for k in range(0, len(order), BLOCK):
        part = {key: data[key][..., order[k : k + BLOCK]] for key in KEYS}
        part["wt"] = part["wt"] * weight[k : k + BLOCK]
        parts.append({key: jnp.asarray(value, jnp.float32) for key, value in part.items()})
    return parts


def load(fold):
    """Blocks of rows, blocks of differences, rows for validation."""
    training, validation = strip.split(strip.load("train.csv", "train_fine.csv"))
    training, validation, slender = only_long(training), only_long(validation), only_long(strip.load("train_slender.csv"))
    if fold is not None:
        held = np.arange(len(slender["g"])) % 5 == fold % 5
        validation, slender = strip.take(slender, held), strip.take(slender, ~held)
    rows = joined([training, slender], training)
    keys = ("g", "v", "c", "x", "z", "f", "wt")
    parts = [strip.weighted(rows), limit_rows(LIMITS), states_of_total(slender, STATES), on_the_way_to_sliding(SLIDING)]
    pairs = with_stored(strip.neighbours(rows, SLOPES))
    pairs = [{key: jnp.asarray(pairs[key][..., k : k + BLOCK], jnp.float32) for key in KEYS} for k in range(0, pairs["g"].size // BLOCK * BLOCK, BLOCK)]
    return blocks(with_stored(joined(parts, keys))), pairs, validation


# --- the fit -----------------------------------------------------------------------------------

INPUTS = FIXED + 18
COUNT = INPUTS * UNITS + UNITS * strip.CORRECTIONS + strip.CORRECTIONS


def unpack(p):
    i, j = INPUTS * UNITS, COUNT - strip.CORRECTIONS
    return p[:i].reshape(INPUTS, UNITS), p[i:j].reshape(UNITS, strip.CORRECTIONS), p[j:]


def penalised(o):
    return strip.penalised(o) * (PENALTY / strip.PENALTY)


def forces(o, d):
    return strip.from_parameters(strip.parameters(d["g"], d["v"], d["c"], o, RULE), d["g"], RULE, TABLE)


def corrections(p, d):
    return d["ob"] + d["w"] * strip.of_long(unpack(p), d["z"])


@functools.partial(jax.jit, static_argnums=2)
def normal_equations(p, d, pairs=False):
    """J'J, J'r and r'r of a block."""
    m1, m2, _ = unpack(p)
    x, o, n = d["z"], corrections(p, d), strip.CORRECTIONS
    h = m1.T @ x
    inverse = 1 / jnp.sqrt(1 + h * h)

    def ones(k):
        return jnp.broadcast_to(jnp.eye(k, dtype=o.dtype)[:, :, None], (k, k, o.shape[1]))

    def to_q(o):
        return strip.parameters(d["g"], d["v"], d["c"], o, RULE)

    def to_f(q):
        return strip.from_parameters(q, d["g"], RULE, TABLE)

    q = to_q(o)
    q_by_o = jax.vmap(lambda t: jax.jvp(to_q, (o,), (t,))[1])(ones(n))
    f_by_q = jax.vmap(lambda t: jax.jvp(to_f, (q,), (t,))[1])(ones(6))
    by_o = jnp.concatenate([jnp.einsum("kqn,qrn->rkn", q_by_o, f_by_q) * d["wt"][:, None], penalised(o)[None]]) * d["w"]
    r = jnp.concatenate([(to_f(q) - d["f"]) * d["wt"], jnp.sum(penalised(o) * o, 0)[None]])
    by_h = jnp.einsum("uk,rkn->run", m2, by_o) * inverse**3
    k, rows = len(r), x.shape[1]
    by_p = [(x[None, :, None] * by_h[:, None]).reshape(k, -1, rows), ((h * inverse)[None, :, None] * by_o[:, None]).reshape(k, -1, rows), by_o]
    j = jnp.concatenate(by_p, 1)
    if pairs:
        j, r = strip.differences(j[:4]), strip.differences(r[:4])
    j = j.transpose(1, 0, 2).reshape(COUNT, -1)
    return j @ j.T, j @ r.ravel(), jnp.sum(r * r)


@functools.partial(jax.jit, static_argnums=2)
def cost(p, d, pairs=False):
    o = corrections(p, d)
    r = (forces(o, d) - d["f"]) * d["wt"]
    if pairs:
        return jnp.sum(strip.differences(r) ** 2)
    return jnp.sum(r * r) + jnp.sum(jnp.sum(penalised(o) * o, 0) ** 2)


def start(seed):
    """Small weights of the last layer: the answers are those without these corrections."""
    r = np.random.default_rng(seed)
    first = r.standard_normal(INPUTS * UNITS) / np.sqrt(INPUTS)
    return np.concatenate([first, 0.02 * r.standard_normal(UNITS * strip.CORRECTIONS) / np.sqrt(UNITS), np.zeros(strip.CORRECTIONS)])


def fit(p, parts, pairs, minutes):
    return strip.levenberg_marquardt(p, parts, pairs, minutes, (normal_equations, cost, None), 1)


def write(p):
    m1, m2, b2 = unpack(p)
    header = [
        "Constants of the corrections of long contacts.",
        "",
        "Written by `fit/fit_strip_long.py` from rows with `a/b` above 7 of `fit/data/train.csv`, `train_fine.csv` and",
        "`train_slender.csv` (values computed with CONTACT, see `fit/data/README.md`) and from TOTAL's constants.",
    ]
    entries = [
        ("Fitted: offsets of the units, and weights of what the contact decides.", "FIXED", m1[:FIXED]),
        ("Fitted: one row of weights per feature.", "INPUT", m1[FIXED:]),
        ("Fitted: one row of weights per unit.", "OUTPUT", m2),
        ("Fitted: offsets of the corrections.", "OFFSET", b2),
    ]
    common.write_constants(strip.LONG, header, entries)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--fold", type=int)
    parser.add_argument("--minutes", type=float, default=7.0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--open")
    args = parser.parse_args()
    strip.SHARE_OF_ALL = True  # (real patches are better with the constants that were fitted so)
    parts, pairs, validation = load(args.fold)
    print(f"{COUNT} coefficients, {BLOCK * len(parts)} rows, at most {args.minutes:g} min", flush=True)
    p = fit(start(args.seed), parts, pairs, args.minutes).astype(np.float32).astype(float)
    strip.SHARE_OF_ALL = False
    jax.clear_caches()
    if args.fold is None:
        write(p)
    report = functools.partial(strip.report, p=STORED, regions=True, long=unpack(p))
    report("validation" if args.fold is None else "held back", data=validation)
    if args.open:
        report("open", data=strip.load(os.path.abspath(args.open)))


if __name__ == "__main__":
    main()
