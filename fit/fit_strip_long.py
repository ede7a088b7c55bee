"""Corrections of STRIP for contacts that are long in the rolling direction, added to those of `fit_strip.py`; writes src/strip/long_constants.rs.

    python3 fit_strip_long.py                  fit from a random start (`--seed`), validate, write (four minutes)
    python3 fit_strip_long.py --from-stored    the same, from the stored constants
    python3 fit_strip_long.py --fold K         keep every fifth slender row from the Kth on back, print its errors, write nothing
    options: --minutes M  --seed S  --open FILE (reports only, never fitted)

Fit the strips and TOTAL first. The constants of `fit_strip.py` stay as they are: contacts with sqrt(a/b) below 2.65 do not have these corrections.
Fitted are the rows with a/b > 7, rigid slip, and differences of neighbouring states of TOTAL.
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
UNITS, FIXED = 24, 5
PENALTY, PRIOR = 0.01, 5e-7
SLENDER, OWN = 8, 0.5  # how often a row of train_slender.csv and of boundary_elements.csv counts
LIMITS, SLOPES = 300, 600  # rows of rigid slip, states whose slopes are fitted
STEPS = 300
BLOCK = 1000
KEYS = ("g", "v", "c", "z", "ob", "w", "f", "wt")
STORED = strip.read_back()
RULE, TABLE = strip.RULE, strip.TABLE


# --- rows --------------------------------------------------------------------------------------


def only_long(data):
    return strip.take(data, data["g"] > LEAST)


def with_stored(data):
    """Beside each row the corrections of all contacts, and the weight of those that are fitted here."""
    return {**data, "ob": np.array(strip.corrections(STORED, data["x"])), "w": np.array(strip.share_of_long(data["g"]))}


def limit_rows(n, seed=77):
    """Far in sliding, any mix of translation and spin: rigid slip is the truth there."""
    r = np.random.default_rng(seed)
    g, nu = np.exp(r.uniform(np.log(LEAST), np.log(WIDEST), n)), r.uniform(0, 0.5, n)
    return strip.sliding(g, nu, r)


def weighted(data):
    """As the rows of the other strips, with more weight for slender rows and at both ends of the range."""
    data, g = strip.weighted(data), data["g"]
    often = np.where(data["slender"], np.sqrt(SLENDER / strip.SLENDER), np.where(data["own"], np.sqrt(OWN / strip.OWN), 1.0))
    data["wt"] = data["wt"] * often * np.where(g < 14, 1.6, np.where(g > 30, 1.3, 1.0))
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
    own, own_validation = map(only_long, strip.own_rows())
    training, validation, slender = only_long(training), only_long(validation), only_long(strip.load("train_slender.csv"))
    if fold is not None:
        held = np.arange(len(slender["g"])) % 5 == fold % 5
        validation, slender = strip.take(slender, held), strip.take(slender, ~held)
    rows = strip.joined(training, slender, own)
    keys = ("g", "v", "c", "x", "z", "f", "wt")
    parts = [weighted(rows), limit_rows(LIMITS)]
    pairs = with_stored(strip.neighbours(rows, SLOPES))
    pairs = [{key: jnp.asarray(pairs[key][..., k : k + BLOCK], jnp.float32) for key in KEYS} for k in range(0, pairs["g"].size // BLOCK * BLOCK, BLOCK)]
    return blocks(with_stored(strip.joined(*({key: part[key] for key in keys} for part in parts)))), pairs, validation, own_validation


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
    return strip.levenberg_marquardt(p, parts, pairs, (normal_equations, cost, None), STEPS, minutes, prior=PRIOR)[0]


def write(p):
    m1, m2, b2 = unpack(p)
    header = [
        "Constants of the corrections of long contacts.",
        "",
        "Written by `fit/fit_strip_long.py` from rows with `a/b` above 7 of `fit/data/train.csv`, `train_fine.csv`,",
        "`train_slender.csv` (values computed with CONTACT, see `fit/data/README.md`) and `boundary_elements.csv`.",
    ]
    entries = [
        ("Fitted: offsets of the units, and weights of the features of the contact.", "FIXED", m1[:FIXED]),
        ("Fitted: one row of weights per feature.", "INPUT", m1[FIXED:]),
        ("Fitted: one row of weights per unit.", "OUTPUT", m2),
        ("Fitted: offsets of the corrections.", "OFFSET", b2),
    ]
    common.write_constants(strip.LONG, header, entries)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--fold", type=int)
    parser.add_argument("--minutes", type=float, default=30.0)
    parser.add_argument("--seed", type=int, default=4)
    parser.add_argument("--from-stored", action="store_true")
    parser.add_argument("--open")
    args = parser.parse_args()
    parts, pairs, validation, own_validation = load(args.fold)
    print(f"{COUNT} coefficients, {BLOCK * len(parts)} rows, at most {args.minutes:g} min", flush=True)
    first = np.concatenate([np.ravel(part) for part in strip.read_long()]) if args.from_stored else start(args.seed)
    p = fit(first, parts, pairs, args.minutes).astype(np.float32).astype(float)
    if args.fold is None:
        write(p)
    report = functools.partial(strip.report, p=STORED, regions=True, long=unpack(p))
    report("validation" if args.fold is None else "held back", data=validation)
    report("own rows, validation", data=own_validation)
    if args.open:
        report("open", data=strip.load(os.path.abspath(args.open)))


if __name__ == "__main__":
    main()
