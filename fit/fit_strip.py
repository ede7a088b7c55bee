"""Fit of the strips that follow the slip. See README.md in this folder; the formulas are those of `src/rolling_strip.rs`.

    python3 fit_strip.py                    fit, validate, write src/rolling_strip/constants.rs
    python3 fit_strip.py --check            validate the committed constants
    python3 fit_strip.py --numbers          totals printed for the test of the Rust code
    python3 fit_strip.py --nodes            write src/rolling_strip/nodes.rs, the places of the strips (needs mpmath)
    options: --minutes M  --rows R (0: all)  --seed S  --open FILE  --fields FOLDER (reports only, never fitted)
"""

import argparse
import csv
import os
import time

import common  # sets the thread counts: before jax
import jax
import jax.numpy as jnp
import numpy as np

jax.config.update("jax_enable_x64", True)

OUT = os.path.join(common.SOURCE, "rolling_strip", "constants.rs")
STRIPS, STEPS = 16, 7
FEATURES, UNITS, CORRECTIONS = 13, 20, 8
COUNT = FEATURES * UNITS + UNITS + UNITS * CORRECTIONS + CORRECTIONS

ROUNDING = np.float32(0.08).astype(float)  # half width of the rounded transition from stick to slip, in (|p|/B)^2
SATURATION = 12.0  # linear-theory force in mu N where the flexibilities become those of rigid slip

# residuals: fx, fy, mz, stick fraction; corrections are kept small so that the field stays physical
WEIGHTS = np.array([1.0, 1.0, 0.7, 0.2])
PENALTY, PRIOR = 0.02, 1e-6


# --- numerical tables ------------------------------------------------------------------------


def steps(n):
    """Ends of the steps x_j = cos((j - 1/2) pi/n), and the leading edge x_0 = 1."""
    x = np.cos((np.arange(n) + 0.5) * np.pi / n)
    return x, np.r_[1.0, x[:-1]]


def strips(n):
    """Gauss-Legendre on either half of the contact (64 strips: on its quarters): Y = y/b, C = sqrt(1 - Y^2), widths W.

    The third and fourth numbers scale the creepages so that sum W C = pi/2 and sum W C Y^2 = pi/8 in effect:
    the linear forces are exact for every count.
    """
    panels = 2 if n < 64 else 4
    node, weight = np.polynomial.legendre.leggauss(n // panels)
    y = np.concatenate([(2 * k + 1 + node) / panels - 1 for k in range(panels)])
    w = np.tile(weight * (2 / panels / 2), panels)
    c = np.sqrt(1 - y * y)
    return y, c, w, np.pi / 2 / np.sum(w * c), np.pi / 8 / np.sum(w * c * y * y)


# --- the model -------------------------------------------------------------------------------


def features(g, nu, v, c):
    """Thirteen numbers in [-2, 2], even under both symmetries of the problem."""
    s = np.sqrt(g)
    lx, ly, ls = (v * c[:, :3]).T
    ax, ay, asp = (np.sqrt(x * x + 0.0009) - 0.03 for x in (lx, ly, ls))
    x2, px2 = v[:, 0] ** 2, v[:, 2] ** 2 / g
    y2, py2 = v[:, 1] ** 2, v[:, 2] ** 2 * g
    t2 = lx * lx + ly * ly
    q2 = t2 + ls * ls
    return np.stack(
        [
            (x2 - px2) / (x2 + px2 + 0.02),
            2 * v[:, 1] * v[:, 2] * s / (y2 + py2 + 0.02),
            (y2 - py2) / (y2 + py2 + 0.02),
            2 * (s - 1) / (s + 1),
            4 * nu - 1,
            (ax - 1) / (ax + 1),
            (ay - 1) / (ay + 1),
            (asp - 1) / (asp + 1),
            ls * ly / ((asp + 0.1) * (ay + 1)),
            (t2 - 0.1) / (t2 + 0.1),
            (asp - 0.3) / (asp + 0.3),
            (asp - 2) / (asp + 2),
            (q2 - 1) / (q2 + 1),
        ],
        1,
    )


def unpack(p):
    i, j = FEATURES * UNITS, FEATURES * UNITS + UNITS
    k = j + UNITS * CORRECTIONS
    return p[:i].reshape(FEATURES, UNITS), p[i:j], p[j:k].reshape(UNITS, CORRECTIONS), p[k:]


def corrections(p, x):
    m1, b1, m2, b2 = unpack(p)
    h = x @ m1 + b1
    return (h / jnp.sqrt(1 + h * h)) @ m2 + b2


def positive(o):
    return o + jnp.sqrt(1 + o * o)


def parameters(g, v, c, o):
    """Parameters of the strip law of one case: creepages a_x, a_y, slope rho of the spin over Y, spin ratio sigma, profile of rho."""
    force = v * c[:3]
    s = jnp.sqrt(g)
    q2 = jnp.sum(force * force)
    w = q2 / (0.05 + q2)  # no correction of the linear forces
    chi = q2 * q2 / (q2 * q2 + SATURATION**4)
    rigid = 4 / (3 * np.pi) * (c[0] + c[1])
    k = 8 / (3 * np.pi)
    size = jnp.sqrt(force[2] ** 2 + 0.0009) - 0.03

    def blend(elastic, common_flexibility):
        return (1 - chi) * elastic + chi * common_flexibility

    share_spin, share_lateral = o[5], o[6]
    lateral = positive(w * o[1])
    ax = blend(k * force[0] * positive(w * o[0]), rigid * v[0])
    ay = blend(
        k * force[1] * (1 + share_lateral) * lateral + k * share_spin * positive(w * o[4]) * force[2] / (1 + size),
        rigid * v[1],
    )
    sigma = blend(force[2] * (1 - share_spin) * positive(w * o[3]) - share_lateral * force[1] * lateral, rigid * s / 2 * v[2])
    rho = blend(32 / (3 * np.pi) * s * c[3] * v[2] * positive(o[2]), rigid / s * v[2])
    return ax, ay, rho, sigma, (1 - chi) * o[7] / jnp.sqrt(1 + o[7] * o[7])


def rounded(q):
    """max(1, q) with a parabola between 1 - d and 1 + d."""
    a = jnp.maximum(q, 1 - ROUNDING)
    z = jnp.maximum(1 + ROUNDING - a, 0.0)
    return a + z * z / (4 * ROUNDING)


def bounded(s):
    """s/(1 + s^4)^(1/4), inside (-1, 1)."""
    return s / jnp.sqrt(jnp.sqrt(1 + s**4))


def half_ellipses(q):
    """1/(1 + sqrt(1 - sqrt(q))), approximately."""
    return (1 + q * q) / 2


def strip_creepage(q, y, pressure):
    ax, ay, rho, _, profile = q
    return (ax - rho * y * (1 + profile * (0.4 - y * y))) / pressure, ay / pressure


def step(state, ax, ay, sigma, x0, x1):
    """One step from x0 to x1: the new state (px, py, slipped share), and (ratio x, ratio y, (|p|/B)^2 before and after the cut)."""
    px, py, slipped = state
    bound = jnp.maximum(1e-12, 1 - x1 * x1)
    dx = x0 - x1
    px = px + ax * dx
    py = py + ay * dx + sigma * ((x0 * x0 - x1 * x1) - slipped * dx * dx)
    trial = (px * px + py * py) / (bound * bound)
    m = 1 / jnp.sqrt(rounded(trial))
    reached = trial * m * m
    px, py = px * m, py * m
    e = half_ellipses(reached)
    r = bounded(sigma)
    return (px, py, 1 - m), (px / bound * e, r + (py / bound - r) * e, trial, reached)


def totals(g, v, c, o, rule=strips(STRIPS), n=STEPS):
    """fx, fy, mz, stick fraction of one case."""
    y, half, width, stretch, lever = rule
    q = parameters(g, v, c, o)
    q = (q[0] * stretch, q[1] * stretch, q[2] * lever, *q[3:])
    ax, ay = strip_creepage(q, y, half)
    s = jnp.sqrt(g)
    x, x0 = steps(n)
    state = (jnp.zeros_like(y),) * 3
    before = jnp.zeros_like(y)
    fx = fy = mx = stick = 0.0
    for j in range(n):
        state, (rx, ry, trial, reached) = step(state, ax, ay, q[3], x0[j], x[j])
        weight = 2 / n * (1 - x[j] ** 2)
        fx, fy, mx = fx + weight * rx, fy + weight * ry, mx + weight * x[j] * ry
        share = (1.04 - before) / (jnp.maximum(trial, 1.0) - before + 0.04)
        stick = stick + share * (x0[j] - x[j]) / 2
        before = reached
    stick = stick + share * (x[n - 1] + 1) / 2
    a = 0.75 * width * half * half
    return jnp.stack([jnp.sum(a * fx), jnp.sum(a * fy), jnp.sum(a * (s * half * mx - y / s * fx)), jnp.sum(width * half * stick) / jnp.sum(width * half)])


def field(q, x, y, n=STEPS):
    """Tractions in mu p0, stick, and pressure in p0 at points x/a, y/b: the step that reaches the point is cut short there."""
    half = jnp.sqrt(jnp.maximum(1e-9, 1 - y * y))
    place = jnp.clip(x / half, -1, 1)
    ax, ay = strip_creepage(q, y, half)
    state = (jnp.zeros_like(y),) * 3
    rx = ry = trial = jnp.zeros_like(y)
    ends = np.r_[1.0, steps(n)[0], -1.0]
    for x0, x1 in zip(ends[:-1], ends[1:]):
        inside = (place <= x0) & (place >= x1)
        _, here = step(state, ax, ay, q[3], x0, jnp.where(inside, place, x1))
        rx, ry, trial = (jnp.where(inside, new, old) for new, old in zip(here, (rx, ry, trial)))
        state, _ = step(state, ax, ay, q[3], x0, x1)
    pressure = half * jnp.sqrt(jnp.maximum(0, 1 - place * place))
    return pressure * rx, pressure * ry, trial <= 1, pressure


# --- the fit ---------------------------------------------------------------------------------

BLOCK = 500
ARRAYS = ("x", "g", "v", "c", "f")


def load(*names):
    data = common.load(*names)
    stick = np.concatenate([common.read(name)["stick"] for name in names])
    data["f"] = np.c_[data["f"], stick]
    data["x"] = features(data["g"], data["nu"], data["v"], data["c"])
    return data


def blocks(data):
    """The rows in equal blocks; the remainder is dropped."""
    n = len(data["g"]) // BLOCK * BLOCK
    return [tuple(jnp.array(data[key][i : i + BLOCK]) for key in ARRAYS) for i in range(0, n, BLOCK)]


@jax.jit
def normal_equations(p, x, g, v, c, f):
    """J'J, J'r and r'r of a block: derivatives by the eight corrections forward, by the coefficients of the net backward."""
    o = corrections(p, x)

    def case(o, g, v, c):
        value, push = jax.linearize(lambda z: totals(g, v, c, z), o)
        return value, jax.vmap(push)(jnp.eye(CORRECTIONS)).T

    value, by_o = jax.vmap(case)(o, g, v, c)
    by_p = jax.vmap(jax.jacrev(corrections), (None, 0))(p, x)
    r = (value - f) * WEIGHTS
    j = jnp.einsum("nrk,nkp->nrp", by_o * WEIGHTS[:, None], by_p).reshape(-1, len(p))
    k = (PENALTY * by_p).reshape(-1, len(p))
    return j.T @ j + k.T @ k, j.T @ r.ravel() + k.T @ (PENALTY * o).ravel(), jnp.sum(r * r) + jnp.sum((PENALTY * o) ** 2)


@jax.jit
def cost(p, x, g, v, c, f):
    o = corrections(p, x)
    r = (jax.vmap(totals)(g, v, c, o) - f) * WEIGHTS
    return jnp.sum(r * r) + jnp.sum((PENALTY * o) ** 2)


def start(seed):
    r = np.random.default_rng(seed)
    return np.concatenate(
        [
            r.standard_normal(FEATURES * UNITS) / np.sqrt(FEATURES),
            0.3 * r.standard_normal(UNITS),
            0.1 * r.standard_normal(UNITS * CORRECTIONS) / np.sqrt(UNITS),
            np.zeros(CORRECTIONS),
        ]
    )


def fit(p, parts, minutes, save=None):
    """Levenberg-Marquardt."""
    began, damping, gains, iteration = time.time(), 1e-2, [], 0
    n = sum(len(part[1]) for part in parts)
    prior = PRIOR * n
    while True:
        h, grad, before = prior * np.eye(len(p)), prior * p, prior * np.sum(p * p)
        for part in parts:
            hk, gk, ck = normal_equations(p, *part)
            h, grad, before = h + np.array(hk), grad + np.array(gk), before + float(ck)
        scale = np.diag(h) + 1e-9 * n
        for attempt in range(8):
            q = p - np.linalg.solve(h + damping * np.diag(scale), grad)
            after = sum(float(cost(q, *part)) for part in parts) + prior * np.sum(q * q)
            if after < before:
                break
            damping *= 4
        else:
            break
        iteration += 1
        p, gain = q, 1 - after / before
        damping = max(damping / (3 if attempt == 0 else 1), 1e-9)
        gains.append(gain)
        spent = (time.time() - began) / 60
        if iteration % 10 == 0 or iteration < 4:
            print(f"  iteration {iteration:4d} rms {np.sqrt(after / n):.5f} gain {gain:.1e}, {spent:.1f} min, at most {max(0, minutes - spent):.1f} min to go", flush=True)
            if save:
                np.save(save, p)
        if spent > minutes or (len(gains) > 20 and np.mean(gains[-15:]) < 2e-5):
            break
    return p


# --- reports ---------------------------------------------------------------------------------


def predict(p, data, count=STRIPS, n=STEPS):
    rule = tuple(map(jnp.array, strips(count)))
    run = jax.jit(lambda x, g, v, c: jax.vmap(lambda g, v, c, o: totals(g, v, c, o, rule, n))(g, v, c, corrections(p, x)))
    size = len(data["g"])
    index = np.r_[np.arange(size), np.zeros(-size % BLOCK, int)]
    return np.concatenate([np.array(run(*(jnp.array(data[key][i]) for key in ("x", "g", "v", "c")))) for i in index.reshape(-1, BLOCK)])[:size]


def report(label, p, data, regions=False):
    value = predict(p, data)
    common.report(label, value[:, :3], {**data, "f": data["f"][:, :3]}, regions)
    d = value[:, 3] - data["f"][:, 3]
    print(f"{'':24s} stick fraction: mean |error| {abs(d).mean():.4f}, bias {d.mean():+.4f}", flush=True)


def report_fields(p, folder):
    errors, sticks = [], []
    with open(os.path.join(folder, "index.csv"), newline="", encoding="utf-8") as file:
        cases = list(csv.DictReader(file))
    for case in cases:
        g, nu, xi, eta, psi = (float(case[key]) for key in ("a_over_b", "nu", "xi", "eta", "psi"))
        v = np.array([[3 * (1 - nu) / np.pi * xi, 3 / np.pi * eta, 3 / np.pi / np.sqrt(g) * psi]])
        c = np.stack(common.coefficients(np.array([g]), np.array([nu])), 1)
        o = corrections(p, jnp.array(features(np.array([g]), np.array([nu]), v, c)))[0]
        with open(os.path.join(folder, case["file"]), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        x, y, px, py = (np.array([float(row[key]) for row in rows]) for key in ("x_over_a", "y_over_b", "px", "py"))
        reference = np.array([row["state"] == "stick" for row in rows])
        tx, ty, stick, pressure = map(np.array, field(parameters(g, v[0], c[0], o), jnp.array(x), jnp.array(y)))
        errors.append(np.hypot(tx - px, ty - py).sum() / pressure.sum())
        sticks.append(stick.mean() - reference.mean())
        print(f"  {case['file']:32s} field error {errors[-1]:.4f}, stick {stick.mean():.3f} (reference {reference.mean():.3f}), wrong state {np.mean(stick != reference):.3f}")
    print(f"  fields: mean error {np.mean(errors):.4f}, largest {max(errors):.4f}, stick fraction off by {np.mean(np.abs(sticks)):.4f}", flush=True)


def write(p, note):
    m1, b1, m2, b2 = unpack(p)
    common.write_constants(
        OUT,
        [
            "Constants of the strips that follow the slip.",
            "",
            "Written by `fit/fit_strip.py` from `fit/data/train.csv` and `fit/data/train_fine.csv`",
            "(values computed with CONTACT, see `fit/data/README.md`).",
            *note,
        ],
        [
            ("Half width of the rounded transition from stick to slip, in `(|p|/B)²`.", "ROUNDING", ROUNDING),
            ("Fitted: one row of weights per feature.", "HIDDEN", m1),
            ("Fitted: offsets of the units.", "HIDDEN_OFFSET", b1),
            ("Fitted: one row of weights per unit.", "OUTPUT", m2),
            ("Fitted: offsets of the corrections.", "OUTPUT_OFFSET", b2),
        ],
    )


NODES = """//! Where the strips of the Hertz ellipse lie.
//!
//! Gauss-Legendre rules on either half of the contact (64 strips: on its quarters), because the
//! longitudinal slip of spin changes its sign near the middle: with 16 strips the totals are then three to seven
//! times closer to the limit of many strips than with one rule over the whole width.
//! Written by `fit/fit_strip.py --nodes`; a test checks the rules.
// Generated: change the script, not this file.

use super::{Marched, Strips};

/// Strips of the Hertz ellipse, ascending in `y`; all lengths dimensionless.
#[derive(Clone, Copy, Debug)]
pub struct Rule<F, const N: usize> {
    /// `Y = y/b` of the centre line.
    pub y: [F; N],
    /// Half length `C = √(1 − Y²)`.
    pub half_length: [F; N],
    /// Width in `Y`; their sum is 2.
    pub width: [F; N],
    /// `1/C`
    pub inverse: [F; N],
    /// `(0.4 − Y²) Y`
    pub bend: [F; N],
    /// Share of the friction bound `(3/4) C² ΔY`.
    pub load: [F; N],
    /// Share times `Y`.
    pub moment_y: [F; N],
    /// Share times `C`.
    pub moment_x: [F; N],
    /// Share of the area.
    pub area: [F; N],
    /// `(π/2)/Σ C ΔY`: makes the linear forces exact.
    pub stretch: F,
    /// `(π/8)/Σ C Y² ΔY`: makes the linear moment of spin exact.
    pub lever: F,
}

/// Strip counts that have a rule: 4, 8, 16, 32, 64.
pub trait Placed<const N: usize>: Marched {
    /// The rule, in the precision of the caller.
    const RULE: &'static Rule<Self, N>;
    /// Its strips, whose type does not know how many they are.
    const STRIPS: &'static Strips<'static, Self>;
}

/// The half of a rule with `Y > 0`: `Y`, `C`, width.
type Half<const H: usize> = [[f64; 3]; H];

macro_rules! placed {
    ($float:ident, $count:literal, $half:ident) => {
        #[allow(clippy::unnecessary_cast, clippy::indexing_slicing)]
        impl Placed<$count> for $float {
            const RULE: &'static Rule<Self, $count> = &{
                let zero = [0.0; $count];
                let mut rule = Rule {
                    y: zero,
                    half_length: zero,
                    width: zero,
                    inverse: zero,
                    bend: zero,
                    load: zero,
                    moment_y: zero,
                    moment_x: zero,
                    area: zero,
                    stretch: 0.0,
                    lever: 0.0,
                };
                let (mut stretch, mut lever) = (0.0, 0.0);
                let mut i = 0;
                while i < $count / 2 {
                    let [y, c, width] = $half[i];
                    stretch += 2.0 * width * c;
                    lever += 2.0 * width * c * (y * y);
                    i += 1;
                }
                let mut i = 0;
                while i < $count {
                    let upper = i >= $count / 2;
                    let [y, c, width] =
                        $half[if upper { i - $count / 2 } else { $count / 2 - 1 - i }];
                    let y = if upper { y } else { -y };
                    let load = 0.75 * width * (c * c);
                    rule.y[i] = y as $float;
                    rule.half_length[i] = c as $float;
                    rule.width[i] = width as $float;
                    rule.inverse[i] = (1.0 / c) as $float;
                    rule.bend[i] = ((0.4 - y * y) * y) as $float;
                    rule.load[i] = load as $float;
                    rule.moment_y[i] = (load * y) as $float;
                    rule.moment_x[i] = (load * c) as $float;
                    rule.area[i] = (width * c / stretch) as $float;
                    i += 1;
                }
                rule.stretch = (core::f64::consts::FRAC_PI_2 / stretch) as $float;
                rule.lever = (core::f64::consts::FRAC_PI_8 / lever) as $float;
                rule
            };
            const STRIPS: &'static Strips<'static, Self> = &<Self as Placed<$count>>::RULE.strips();
        }
    };
}

"""


def write_nodes():
    """The rules, computed with 40 digits."""
    import mpmath

    mpmath.mp.dps = 40
    text = NODES
    for n in (4, 8, 16, 32, 64):
        text += f"placed!(f64, {n}, HALF_OF_{n});\nplaced!(f32, {n}, HALF_OF_{n});\n"
    for n in (4, 8, 16, 32, 64):
        panels = 1 if n < 64 else 2
        m = n // 2 // panels
        guess = np.polynomial.legendre.leggauss(m)[0]
        rows = []
        for k in range(panels):
            for x in guess:
                x = mpmath.findroot(lambda z: mpmath.legendre(m, z), mpmath.mpf(float(x)))
                slope = m * (mpmath.legendre(m - 1, x) - x * mpmath.legendre(m, x)) / (1 - x * x)
                y = (2 * k + 1 + x) / (2 * panels)
                rows.append((y, mpmath.sqrt(1 - y * y), 2 / ((1 - x * x) * slope * slope) / (2 * panels)))
        text += f"\n#[rustfmt::skip]\nconst HALF_OF_{n}: Half<{n // 2}> = [\n"
        text += "".join("    [" + ", ".join(repr(float(z)) for z in row) + "],\n" for row in rows) + "];\n"
    with open(os.path.join(os.path.dirname(OUT), "nodes.rs"), "w", encoding="utf-8") as file:
        file.write(text)


def read_back():
    k = common.read_constants(OUT)
    return np.concatenate([k[name].ravel() for name in ("HIDDEN", "HIDDEN_OFFSET", "OUTPUT", "OUTPUT_OFFSET")])


def numbers(p):
    """Totals for the unit test of the Rust code: g, nu, vx, vy, phi, then fx, fy, mz, stick for 16 strips."""
    r = np.random.default_rng(5)
    n = 14
    g, nu = 10 ** r.uniform(-1, 1, n), r.uniform(0, 0.5, n)
    v = np.stack([r.normal(0, 0.3, n), r.normal(0, 0.3, n), r.normal(0, 0.5, n)], 1)
    v[0, 2], v[1, :2], v[2], v[3] = 0, 0, v[2] * 20, v[3] * 1e-3
    g, nu, v = g.round(3), nu.round(3), v.round(5)
    c = np.stack(common.coefficients(g, nu), 1)
    data = {"g": g, "v": v, "c": c, "x": features(g, nu, v, c)}
    for row in zip(g, nu, v, predict(p, data)):
        print(f"([{row[0]}, {row[1]}, {row[2][0]}, {row[2][1]}, {row[2][2]}], {[float(f'{x:.15g}') for x in row[3]]}),")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--numbers", action="store_true")
    parser.add_argument("--nodes", action="store_true")
    parser.add_argument("--minutes", type=float, default=12.0)
    parser.add_argument("--rows", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--open")
    parser.add_argument("--fields")
    parser.add_argument("--save", help="file for the state in between")
    parser.add_argument("--resume", help="file of an earlier --save")
    parser.add_argument("--dry", action="store_true", help="do not write the constants")
    args = parser.parse_args()

    if args.nodes:
        write_nodes()
        return
    if args.numbers:
        numbers(read_back())
        return
    training, validation = common.split(load("train.csv", "train_fine.csv"))
    if args.check:
        p = read_back()
    else:
        if args.rows:
            training = common.take(training, np.arange(min(args.rows, len(training["g"]))))
        parts = blocks(training)
        print(f"{COUNT} coefficients, {BLOCK * len(parts)} rows, {len(validation['g'])} rows for validation, at most {args.minutes:g} min", flush=True)
        p = np.load(args.resume) if args.resume else start(args.seed)
        p = fit(p, parts, args.minutes, args.save)
        p = p.astype(np.float32).astype(float)
        if not args.dry:
            write(p, [f"Trained on {BLOCK * len(parts)} rows; {len(validation['g'])} others were kept for validation."])
    report("validation", p, validation, regions=args.check)
    if args.open:
        data = load(args.open)
        report("open", p, data, regions=args.check)
        for count in (4, 8, 32, 64):
            common.report(f"  {count} strips", predict(p, data, count)[:, :3], {**data, "f": data["f"][:, :3]})
    if args.fields:
        report_fields(p, args.fields)


if __name__ == "__main__":
    main()
