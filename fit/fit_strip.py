"""Fit of STRIP. See README.md in this folder; the formulas are those of `src/strip`.

    python3 fit_strip.py --seed S           fit from random starts, validate, write src/strip/constants.rs (then fit_strip_long.py)
    python3 fit_strip.py --from-stored      the same without random starts, from the stored constants
    python3 fit_strip.py --check            validate the committed constants
    python3 fit_strip.py --numbers          totals printed for the test of the Rust code
    python3 fit_strip.py --nodes            write src/strip/nodes.rs, the places of the strips (needs mpmath)
    options: --minutes M (at most, of each round after the random starts)  --rows R (0: all)  --save FILE  --resume FILE
             --open FILE  --slopes FILE  --fields FOLDER (reports only, never fitted)
"""

import argparse
import csv
import functools
import os
import time

import common  # sets the thread counts: before jax
import jax
import jax.numpy as jnp
import numpy as np

jax.config.update("jax_enable_x64", True)

FOLDER = os.path.join(common.SOURCE, "strip")
OUT = os.path.join(FOLDER, "constants.rs")
LONG = os.path.join(FOLDER, "long_constants.rs")
STRIPS = 16
FEATURES, UNITS, CORRECTIONS = 13, 20, 8
CONTACT = [3, 4]  # features of the contact alone
COUNT = FEATURES * UNITS + UNITS + UNITS * CORRECTIONS + CORRECTIONS

# The kernel: nodes on the slip part of a strip, their stagger from strip to strip, and smoothing
NODES, STAGGER = 4, 0.3
NODE = 0.04  # softening of the cut by the node's own cell
AVERAGE = 0.35  # share of the square of the strip's own spread in q: 1/3 is its mean square
ROUND, ROUND_SPIN = 0.2, 0.3  # half width of the rounded cut in q, and what it grows by with r^4
BLEND = (0.8, 1.3)  # spins between which the slip part grows over the whole strip
EDGE = 0.4  # the separatrix meets the leading edge smoothly over this length
# Linear forces squared from which on corrections act; linear force where the flexibilities are
# those of rigid slip
WIDTH, WIDTH2, SATURATION = 0.05, 0.15, 40.0
# Long contacts: sqrt(a/b) from which on, and over which distance, the corrections of
# `fit_strip_long.py` set in
LONG_FROM, LONG_OVER = 2.65, 1.1

# residuals: fx, fy, mz, stick fraction; corrections are kept small so that the field stays physical
WEIGHTS = np.array([1.0, 1.0, 0.8, 0.2])
PENALTY, PRIOR, TAIL = 0.02, 1e-7, 0.3
WIDEST = 64  # axis ratios of the rows of rigid slip, and their inverse
LONGEST = 9  # axis ratio of the rows; those of longer contacts are for fit_strip_long.py
OWN, OWN_LONGEST = 0.15, 7  # how often a row of boundary_elements.csv counts, and the axis ratio where those of fit_strip_long.py begin
STARTS, FIRST = 3, 50  # random starts, and steps of each on every third block
STEPS = 50  # steps of the best one on all rows
ROUNDS, RENEWED = 2, 20  # rounds and steps of each in which rows with large errors weigh more
GROWTH = 1.15  # of the weight of slopes with each round, which keeps their balance with the rows
SLENDER = 3  # how often a row of train_slender.csv counts
SLOPES, STEP, SLOPE_WEIGHT = 1030, 0.03, 0.25  # states whose slopes are fitted too: central differences with this step of linear force
OWN_STEP, OWN_SLOPE_WEIGHT = 0.04, 0.4  # the same of the 304 states of boundary_slopes.csv
BLOCK = 1000  # rows side by side
TINY = 1e-24


# --- numerical tables ------------------------------------------------------------------------


def strips(n):
    """Gauss-Legendre on either half of the contact (64 strips: on its quarters): Y = y/b, C = sqrt(1 - Y^2), widths W.

    The fourth and fifth numbers scale the creepages so that sum W C = pi/2 and sum W C Y^2 = pi/8 in effect:
    the linear forces are exact for every count.
    """
    panels = 2 if n < 64 else 4
    node, weight = np.polynomial.legendre.leggauss(n // panels)
    y = np.concatenate([(2 * k + 1 + node) / panels - 1 for k in range(panels)])
    w = np.tile(weight * (2 / panels / 2), panels)
    c = np.sqrt(1 - y * y)
    return y, c, w, float(np.pi / 2 / np.sum(w * c)), float(np.pi / 8 / np.sum(w * c * y * y))


def nodes(stagger):
    """Places t_k = tau_k/s, half cells, and weights W_k(u) = u^2 (c_0 + .. c_3 u^3), u = s/2, of one kind of strips.

    W_k is the integral over the slip part of the polynomial that is 1 at t_k and 0 at the other nodes and, for short slip
    parts, at the separatrix t = 1; weight (2/pi) sqrt(tau (2 - tau)).
    """
    t = (1 + np.cos((np.arange(1, NODES + 1) + stagger) * np.pi / (NODES + 1))) / 2
    u = (1 - np.cos(np.linspace(0, np.pi, 61))) / 2
    z, gauss = np.polynomial.legendre.leggauss(200)
    z = (z + 1) / 2
    place, gauss = z * z * (3 - 2 * z), 3 * z * (1 - z) * gauss  # roots at both ends

    def weight(k, points, u):
        others = np.delete(points, k)
        lagrange = np.prod([(place - other) / (points[k] - other) for other in others], axis=0)
        tau = 2 * u * place
        return np.sum(gauss * lagrange * 2 / np.pi * np.sqrt(tau * (2 - tau))) * 2 * u

    powers = np.stack([u**p for p in range(2, 6)], 1)
    table = np.zeros((NODES, 4))
    for k in range(NODES):
        exact = np.array([(1 - v**4) * weight(k, np.r_[t, 1.0], v) + v**4 * weight(k, t, v) for v in u])
        free = np.linalg.lstsq(powers[:, :-1] - powers[:, -1:], exact - powers[:, -1] * exact[-1], rcond=None)[0]
        table[k] = np.r_[free, exact[-1] - free.sum()]  # exact in full sliding
    angle = np.linspace(0, np.pi, 4001)
    filled = np.clip(np.r_[0, np.cumsum(table.sum(1))], 0, 1)
    edges = np.cos(np.interp(filled, (angle - np.sin(2 * angle) / 2) / np.pi, angle))
    return t, (edges[:-1] - edges[1:]) / 4, table


KINDS = [nodes(-STAGGER), nodes(STAGGER)]  # on the outermost strips and every second one, and on the others


def table_of(n):
    """For each node, one column over the strips: t, t_0 - t, (2 cell (t_0 - t))^2 NODE, c_0 .. c_3."""
    columns = []
    for i in range(n):
        t, cell, c = KINDS[min(i, n - 1 - i) % 2]
        length = np.r_[1.0, t[:-1]] - t
        columns.append(np.concatenate([np.stack([t, length, NODE * (2 * cell * length) ** 2], 1), c], 1))
    return np.stack(columns, 2)  # (NODES, 7, n)


# --- the model: rows on the last axis, strips before it -----------------------------------------


def features(g, nu, v, c):
    """Thirteen numbers in [-2, 2], even under both symmetries of the problem."""
    s = np.sqrt(g)
    lx, ly, ls = v * c[:3]
    ax, ay, asp = (np.sqrt(x * x + 0.0009) - 0.03 for x in (lx, ly, ls))
    x2, px2 = v[0] ** 2, v[2] ** 2 / g
    y2, py2 = v[1] ** 2, v[2] ** 2 * g
    t2 = lx * lx + ly * ly
    q2 = t2 + ls * ls
    return np.stack(
        [
            (x2 - px2) / (x2 + px2 + 0.02),
            2 * v[1] * v[2] * s / (y2 + py2 + 0.02),
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
        ]
    )


def share_of_long(g):
    """Weight of the corrections of long contacts, 0 to 1, with two continuous derivatives."""
    z = jnp.clip((jnp.sqrt(g) - LONG_FROM) / LONG_OVER, 0, 1)
    return z**3 * (10 - 15 * z + 6 * z * z)


def long_features(g, nu, v, c):
    """Five numbers of the contact, ten of long contacts alone and the last eight of `features`."""
    s = np.sqrt(g)
    length, poisson = 4 * (s - 1) / (s + 1) - 2.4, 4 * nu - 1
    fixed = [np.ones_like(g), length, length * length, poisson, poisson * length]
    x2, y2, p2 = v[0] ** 2, v[1] ** 2, v[2] ** 2 * g
    lx2, ly2, ls2 = (v * c[:3]) ** 2
    small, psi = 0.1 / g**2, np.sqrt((np.pi / 3) ** 2 * p2 + 0.0009) - 0.03
    own = [
        (x2 - p2) / (x2 + p2 + small),
        2 * v[1] * v[2] * s / (y2 + p2 + small),
        (y2 - p2) / (y2 + p2 + small),
        v[1] * v[2] * c[1] * c[2] / (ly2 + ls2 + 0.01),
        (ly2 - ls2) / (ly2 + ls2 + 0.01),
        (lx2 - ls2) / (lx2 + ls2 + 0.01),
        (lx2 - ly2) / (lx2 + ly2 + 0.01),
        (psi - 0.3) / (psi + 0.3),
        (psi - 1) / (psi + 1),
        (lx2 + ly2 + ls2 - 300) / (lx2 + ly2 + ls2 + 300),
    ]
    return np.concatenate([np.stack(fixed + own), features(g, nu, v, c)[5:]])


def of_long(long, x):
    """Corrections of long contacts: weights (FIXED and INPUT together), OUTPUT, OFFSET."""
    m1, m2, b2 = long
    h = m1.T @ x
    return m2.T @ (h / jnp.sqrt(1 + h * h)) + b2[:, None]


def read_long():
    k = common.read_constants(LONG)
    return np.concatenate([k["FIXED"], k["INPUT"]]), k["OUTPUT"], k["OFFSET"]


def unpack(p):
    i, j = FEATURES * UNITS, FEATURES * UNITS + UNITS
    k = j + UNITS * CORRECTIONS
    return p[:i].reshape(FEATURES, UNITS), p[i:j], p[j:k].reshape(UNITS, CORRECTIONS), p[k:]


def units(p, x):
    m1, b1, _, _ = unpack(p)
    h = m1.T @ x + b1[:, None]
    return h, 1 / jnp.sqrt(1 + h * h)


def corrections(p, x):
    _, _, m2, b2 = unpack(p)
    h, inverse = units(p, x)
    return m2.T @ (h * inverse) + b2[:, None]


def positive(o):
    return o + jnp.sqrt(1 + o * o)


def parameters(g, v, c, o, rule):
    """Parameters of the strip law: creepages a_x, a_y, slope rho of the spin over Y, spin sigma, profile of rho, elastic share."""
    stretch, lever = rule[3:]
    force, s = v * c[:3], jnp.sqrt(g)
    q2 = force[0] ** 2 + force[1] ** 2 + force[2] ** 2
    w, w2 = q2 / (WIDTH + q2), q2 / (WIDTH2 + q2)  # no correction at rest
    # the linear force of a spin grows with the contact's length, its slip does not
    of_spin = 1 / jnp.sqrt(1 + share_of_long(g) * ((g / 10) ** 3 - 1))
    m2 = force[0] ** 2 + force[1] ** 2 + of_spin * force[2] ** 2
    chi = m2 * m2 / (m2 * m2 + SATURATION**4)
    rigid = 4 / (3 * np.pi) * (c[0] + c[1])
    k = 8 / (3 * np.pi)
    size = jnp.sqrt(force[2] ** 2 + 0.0009) - 0.03

    def blend(elastic, common_flexibility):
        return (1 - chi) * elastic + chi * common_flexibility

    # at rest the lateral creepage makes Kalker's moment -C23
    rest = c[2] / (4 / (3 * np.pi) * stretch * s * c[1]) - 1
    share_spin, share_lateral = w2 * o[5], rest + w2 * (o[6] - rest)
    lateral = positive(w * o[1])
    ax = blend(k * force[0] * positive(w * o[0]), rigid * v[0])
    ay = blend(
        k * force[1] * (1 + share_lateral) * lateral + k * share_spin * positive(w * o[4]) * force[2] / (1 + size),
        rigid * v[1],
    )
    sigma = blend(force[2] * (1 - share_spin) * positive(w * o[3]) - share_lateral * force[1] * lateral, rigid * s / 2 * v[2])
    rho = blend(32 / (3 * np.pi) * s * c[3] * v[2] * positive(w2 * o[2]), rigid / s * v[2])
    return jnp.stack([ax * stretch, ay * stretch, rho * lever, sigma, (1 - chi) * w2 * o[7] / jnp.sqrt(1 + o[7] ** 2), 1 - chi])


def rounded(q, d):
    """max(1, q) with a parabola between 1 - d and 1 + d."""
    a = jnp.maximum(q, 1 - d)
    z = jnp.maximum(1 + d - a, 0)
    return a + z * z / (4 * d)


def separatrix(ax, ay, sigma):
    """r, A_y + sigma - r, separatrix s, and its blend to the whole strip."""
    r = sigma / jnp.sqrt(jnp.sqrt(1 + sigma**4))
    by, room = ay + (sigma - r), 1 - r * r
    root = jnp.sqrt(room * ax * ax + by * by + TINY)
    turned = r * by
    ahead = turned > 0
    s = jnp.where(ahead, root + turned, ax * ax + by * by) / jnp.where(ahead, jnp.maximum(room, 1e-3), root - turned)
    s = jnp.clip(s, 1e-12, 2.0)
    z = jnp.maximum(s - (2 - EDGE), 0) / EDGE
    s = s + EDGE * z * z * (1 - z)
    blend = jnp.clip((abs(sigma) - BLEND[0]) / (BLEND[1] - BLEND[0]), 0, 1)
    blend = blend * blend * (3 - 2 * blend)
    return r, by, s + blend * (2 - s), blend


def step(state, ax, ay, sigma, spread, r, d, length, tau, soft):
    """A step of this length to tau = 1 + x: the new state (px, py, wide, kept), traction over the bound, and q before the cut."""
    px, py, wide, kept = state
    x, inverse = tau - 1, 1 / (tau * (2 - tau))
    px = px + length * ax
    py = py + length * (ay + sigma * (2 * x + kept * length))
    wide = wide + length * spread / 2  # half of the variation of px over the strip's width
    q = (px * px + py * py + AVERAGE * wide * wide + soft) * inverse * inverse
    m = 1 / jnp.sqrt(rounded(q, d))
    px, py, e = px * m, py * m, (1 + q * m * m) / 2
    return (px, py, wide * m, m), (px * inverse * e, r + (py * inverse - r) * e), q


def law(ax, ay, sigma, spread, kept, table):
    """f_x, f_y, m_x and share in adhesion of strips, over their friction bounds."""
    r, by, s, blend = separatrix(ax, ay, sigma)
    d, u, g = ROUND + ROUND_SPIN * r**4, s / 2, by + s * r
    table = jnp.asarray(table, ax.dtype)[..., None]

    def weight(c):
        return u * u * (c[0] + u * (c[1] + u * (c[2] + u * c[3])))

    def node(state, row):
        march, fx, fy, mx, stick, v, vx = state
        tau, length, w = s * row[0], s * row[1], weight(row[3:])
        march, (tx, ty), _ = step(march, ax, ay, sigma, spread, r, d, length, tau, row[2] * (sigma * s * s) ** 2)
        x = tau - 1
        stick = stick + blend * length / 2 * march[3] ** 8
        return (march, fx + w * tx, fy + w * ty, mx + w * x * ty, stick, v + w, vx + w * x), None

    zero = jnp.zeros_like(s)
    first = (((2 - s) * ax, (2 - s) * g, (2 - s) * spread / 2, kept + zero), zero, zero, zero, 1 - u, zero, zero)
    (_, fx, fy, mx, stick, v, vx), _ = jax.lax.scan(node, first, table)
    v, vx = v / s, vx / s
    fx = fx + ax * (1 - s / 4 - v)
    fy = fy + by * (1 - s / 4) + r - v * g
    mx = mx - by / 2 * (1 - u) ** 2 - vx * g
    return fx, fy, mx, stick


def from_parameters(q, g, rule, table):
    """fx, fy, mz, stick fraction."""
    y, half, width = (jnp.asarray(a[:, None], q.dtype) for a in rule[:3])
    ax, ay, rho, sigma, bend, kept = q
    sigma = jnp.broadcast_to(sigma, (len(y),) + sigma.shape)
    spread = rho * width * (len(y) / 16) / half  # of one of sixteen strips, whatever their count
    fx, fy, mx, stick = law((ax - rho * y * (1 + bend * (0.4 - y * y))) / half, ay / half, sigma, spread, kept, table)
    a, s = 0.75 * width * half * half, jnp.sqrt(g)
    return jnp.stack(
        [
            jnp.sum(a * fx, 0),
            jnp.sum(a * fy, 0),
            jnp.sum(a * (s * half * mx - y / s * fx), 0),
            jnp.sum(width * half * stick, 0) / jnp.sum(width * half),
        ]
    )


def totals(g, v, c, o, count=STRIPS):
    rule = strips(count)
    return from_parameters(parameters(g, v, c, o, rule), g, rule, table_of(count))


def dissipative(f, v, c, floor=0.2, eps=0.2):
    """Moved so that the power is at least `floor` times that of linear theory, divided by (1 + n^2)^(1/2); nothing happens above floor + eps."""
    k = jnp.stack([c[0], c[1], c[3]])
    room = 0.1 * (1 - jnp.minimum(1.0, f[0] ** 2 + f[1] ** 2))
    h = jnp.stack([room, room, jnp.ones_like(room)])
    d, dh = jnp.sum(k * v * v, 0) + 1e-30, jnp.sum(h * k * v * v, 0) + 1e-30
    n = jnp.sqrt(1 + jnp.sum((k * v) ** 2, 0) + (c[2] * v[2]) ** 2)
    x = jnp.sum(f[:3] * v, 0) * n / d - floor
    lift = jnp.where(x < -eps, -x, jnp.maximum(eps - x, 0) ** 2 / (4 * eps))
    moved = f[:3] + lift / n * d / dh * h * k * v
    return jnp.concatenate([moved / jnp.sqrt(jnp.maximum(1.0, moved[0] ** 2 + moved[1] ** 2)), f[3:]])


def traction(q, x, y):
    """Tractions in mu p0, stick, and pressure in p0 at points x/a, y/b: the step that reaches the point is cut short there; nothing is averaged."""
    half = np.sqrt(np.maximum(1e-9, 1 - y * y))
    place = np.clip(x / half, -1, 1)
    ax = (q[0] - q[2] * y * (1 + q[4] * (0.4 - y * y))) / half
    ay, sigma = q[1] / half, q[3] + 0 * y
    r, by, s, blend = map(np.array, separatrix(jnp.array(ax), jnp.array(ay), jnp.array(sigma)))
    d, g = ROUND + ROUND_SPIN * r**4, by + s * r
    tau = np.clip(1 + place, 1e-6, 2 - 1e-9)
    share = 1 - np.sqrt(np.maximum(1 - s / tau, 0))
    tx, ty, stick = ax / s * share, r + by / s * share, tau >= s
    state, high = ((2 - s) * ax, (2 - s) * g, 0 * s, q[5] + 0 * s), s
    for to in np.r_[KINDS[0][0], 0.0]:
        low = s * to
        inside = (tau < high) & (tau >= low)
        at = np.where(inside, tau, np.maximum(low, 1e-9))
        new, here, trial = step(state, ax, ay, sigma, 0.0, r, d, high - at, at, 0.0)
        tx, ty = (np.where(inside, now, old) for now, old in zip(here, (tx, ty)))
        stick = np.where(inside, (trial <= 1) & (blend > 0), stick)
        state, high = new, low
    pressure = half * np.sqrt(np.maximum(0, 1 - place * place))
    return pressure * tx, pressure * ty, stick, pressure


# --- rows --------------------------------------------------------------------------------------


def case(g, nu, v):
    c = np.stack(common.coefficients(g, nu))
    return {"g": g, "nu": nu, "v": v, "c": c, "x": features(g, nu, v, c), "z": long_features(g, nu, v, c)}


def load(*names):
    data = common.load(*names)
    stick = np.concatenate([common.read(name)["stick"] for name in names])
    return {**case(data["g"], data["nu"], data["v"].T), "f": np.r_[data["f"].T, stick[None]], "err": data["err"], "fine": data["fine"], "slender": data["slender"], "own": data["own"]}


def take(data, index):
    return {key: value[..., index] for key, value in data.items()}


def split(data, part=0.9):
    """Training and validation rows: those of common.split."""
    order = np.random.default_rng(0).permutation(len(data["g"]))
    cut = int(part * len(order))
    return take(data, order[:cut]), take(data, order[cut:])


def own_rows():
    """Those of common.own_rows."""
    data = load(common.OWN)
    held = common.of_held_contacts(data["g"])
    return take(data, ~held), take(data, held)


def joined(*parts):
    return {key: np.concatenate([part[key] for part in parts], -1) for key in parts[0]}


def rigid_slip(g, vx, vy, phi, n=60):
    """Force and moment of full sliding with the local rigid slip."""
    a, b = np.sqrt(g), 1 / np.sqrt(g)
    r = np.sqrt((np.arange(n) + 0.5) / n)[:, None]
    angle = np.pi * (np.arange(2 * n) + 0.5) / n
    x, y = a * r * np.cos(angle), b * r * np.sin(angle)
    p = np.sqrt(1 - r * r) * np.ones_like(angle)
    sx, sy = vx - phi * y, vy + phi * x
    s = np.maximum(np.hypot(sx, sy), 1e-300)
    return np.array([(p * sx / s).sum(), (p * sy / s).sum(), (p * (x * sy - y * sx) / s).sum()]) / p.sum()


def limit_rows(n, seed=77):
    """Far in sliding, any mix of translation and spin."""
    r = np.random.default_rng(seed)
    return sliding(WIDEST ** r.uniform(-1, 1, n), r.uniform(0, 0.5, n), r)


def sliding(g, nu, r):
    """Rows far in sliding: rigid slip is the truth there."""
    n = len(g)
    angle, k = r.uniform(0, 2 * np.pi, n), 10 ** r.uniform(-1.1, 1.4, n)
    far = np.where(k < 3, 2000, 60 / k) * 10 ** r.uniform(-0.1, 1, n)
    data = case(g, nu, far * np.stack([k * np.cos(angle), k * np.sin(angle), np.ones(n)]))
    data["f"] = np.zeros((4, n))
    data["wt"] = np.ones((4, n)) * np.array([1, 1, 0.8, 0])[:, None]
    for i in range(n):
        data["f"][:3, i] = rigid_slip(g[i], k[i] * np.cos(angle[i]), k[i] * np.sin(angle[i]), 1.0)
        data["wt"][2, i] /= max(0.5, rigid_slip(g[i], 0.0, 0.0, 1.0, 30)[2])
    return data


def of_total(data):
    """What TOTAL's stored constants have for these states."""
    import fit_total

    model = fit_total.stored(fit_total.CONSTANTS)
    return fit_total.predict(model, {"g": data["g"], "nu": data["nu"], "v": data["v"].T, "c": data["c"].T}).T


ARRAYS = ("x", "g", "v", "c", "f", "wt")


def weighted(data):
    """Less for rows of uncertain reference, more for fine grids and a/b > 4."""
    w = np.where(data["fine"], 1.25, 1.0) * (1 + 0.5 * (data["g"] > 4)) / np.sqrt(1 + (data["err"] / 0.012) ** 2)
    w = w * np.where(data["slender"], np.sqrt(SLENDER), np.where(data["own"], np.sqrt(OWN), 1.0))
    # where a contact is long the moment is large, and may be wrong by more
    w = w * np.stack([np.ones_like(w), np.ones_like(w), np.where(data["g"] > 12, np.sqrt(12 / data["g"]), 1.0), np.ones_like(w)])
    return {**data, "wt": WEIGHTS[:, None] * w * np.array([[1.0], [1.0], [1.0], [0.0]]) + np.array([[0.0], [0.0], [0.0], [WEIGHTS[3]]])}


def blocks(training):
    """Rows in equal blocks in random order; the remainder is dropped.

    Rigid slip is not among them: no correction is left there."""
    data = weighted(training)
    order = np.random.default_rng(1).permutation(len(data["g"]))
    order = order[: len(order) // BLOCK * BLOCK]
    return [{key: jnp.asarray(data[key][..., part], jnp.float32) for key in ARRAYS} for part in order.reshape(-1, BLOCK)]


def neighbours(training, count, seed=8):
    """Neighbouring states, three pairs for each of `count` training states, mirrored at random: their differences are fitted.

    The values are those of TOTAL's stored constants, which are fitted to the same rows: it tells what rows one by one do not.
    """
    r = np.random.default_rng(seed)
    order = r.permutation(len(training["g"]))
    d = take(training, order)
    n = np.sqrt(((d["v"] * d["c"][:3]) ** 2).sum(0))
    d = take(d, np.flatnonzero((n > 0.1) & (n < 3) & (d["g"] >= 0.02) & (d["g"] <= 50))[:count])
    v = d["v"] * r.choice([-1, 1], (3, d["g"].size))
    steps = (STEP / d["c"][:3])[:, :, None] * np.eye(3)[:, None, :]
    v = (v[:, :, None, None] + steps[:, :, :, None] * np.array([1, -1])).reshape(3, -1)
    rows = case(np.repeat(d["g"], 6), np.repeat(d["nu"], 6), v)
    f = of_total(rows)
    rows["f"] = np.r_[f, np.zeros((1, f.shape[1]))]
    rows["wt"] = np.ones((4, f.shape[1])) * np.array([[1], [1], [0.5], [0]]) * SLOPE_WEIGHT / (2 * STEP)
    return rows


def known_slopes():
    """The slopes of boundary_slopes.csv as neighbouring states, the first of two has the difference, the second zero."""
    k = common.read("boundary_slopes.csv")
    g, nu, v = k["a_over_b"], k["nu"], np.stack([k["vx"], k["vy"], k["phi"]])
    c = np.stack(common.coefficients(g, nu))
    # slopes over vx, vy, phi (first axis) of fx, fy, mz, of states
    slopes = np.stack([np.stack([k[f"{f}_{by}"] for f in ("fx", "fy", "mz")]) for by in ("vx", "vy", "phi")])
    steps = (OWN_STEP / c[:3])[:, :, None] * np.eye(3)[:, None, :]
    moved = (v[:, :, None, None] + steps[:, :, :, None] * np.array([1, -1])).reshape(3, -1)
    rows = case(np.repeat(g, 6), np.repeat(nu, 6), moved)
    f = np.zeros((4, len(g), 3, 2))
    f[:3, :, :, 0] = (2 * OWN_STEP * slopes / c[:3, None]).transpose(1, 2, 0)
    rows["f"] = f.reshape(4, -1)
    rows["wt"] = np.ones_like(rows["f"]) * np.array([[1], [1], [0.5], [0]]) * OWN_SLOPE_WEIGHT / (2 * OWN_STEP)
    return rows


def slope_blocks(training):
    near, known = neighbours(training, SLOPES), known_slopes()
    rows = joined(*({key: rows[key] for key in ARRAYS} for rows in (known, near)))
    count = len(rows["g"]) // BLOCK * BLOCK
    return [{key: jnp.asarray(rows[key][..., i : i + BLOCK], jnp.float32) for key in ARRAYS} for i in range(0, count, BLOCK)]


# --- the fit -----------------------------------------------------------------------------------

RULE, TABLE = strips(STRIPS), table_of(STRIPS)


def penalised(o):
    """One correction of each row, in turn, with eight times the weight."""
    return jax.nn.one_hot(jnp.arange(o.shape[1]) % CORRECTIONS, CORRECTIONS, dtype=o.dtype).T * PENALTY * CORRECTIONS**0.5


def differences(a):
    return a[..., 0::2] - a[..., 1::2]


@functools.partial(jax.jit, static_argnums=2)
def normal_equations(p, d, pairs=False):
    """J'J, J'r and r'r of a block: derivatives with respect to the parameters of the law forward, those with respect to the coefficients of the network by hand."""
    _, _, m2, _ = unpack(p)
    x = d["x"]
    h, inverse = units(p, x)
    a, o = h * inverse, corrections(p, x)

    def ones(n):
        return jnp.broadcast_to(jnp.eye(n, dtype=o.dtype)[:, :, None], (n, n, o.shape[1]))

    def to_q(o):
        return parameters(d["g"], d["v"], d["c"], o, RULE)

    def to_f(q):
        return from_parameters(q, d["g"], RULE, TABLE)

    q = to_q(o)
    q_by_o = jax.vmap(lambda t: jax.jvp(to_q, (o,), (t,))[1])(ones(CORRECTIONS))
    f_by_q = jax.vmap(lambda t: jax.jvp(to_f, (q,), (t,))[1])(ones(6))
    by_o = jnp.concatenate([jnp.einsum("kqn,qrn->rkn", q_by_o, f_by_q) * d["wt"][:, None], penalised(o)[None]])
    r = jnp.concatenate([(to_f(q) - d["f"]) * d["wt"], jnp.sum(penalised(o) * o, 0)[None]])
    by_h = jnp.einsum("uk,rkn->run", m2, by_o) * inverse**3
    n, rows = len(r), x.shape[1]
    by_p = [(x[None, :, None] * by_h[:, None]).reshape(n, -1, rows), by_h, (a[None, :, None] * by_o[:, None]).reshape(n, -1, rows), by_o]
    j = jnp.concatenate(by_p, 1)
    if pairs:
        j, r = differences(j[:4]), differences(r[:4])
    j = j.transpose(1, 0, 2).reshape(COUNT, -1)
    return j @ j.T, j @ r.ravel(), jnp.sum(r * r)


@functools.partial(jax.jit, static_argnums=2)
def cost(p, d, pairs=False):
    o = corrections(p, d["x"])
    r = (from_parameters(parameters(d["g"], d["v"], d["c"], o, RULE), d["g"], RULE, TABLE) - d["f"]) * d["wt"]
    if pairs:
        return jnp.sum(differences(r) ** 2)
    return jnp.sum(r * r) + jnp.sum(jnp.sum(penalised(o) * o, 0) ** 2)


@jax.jit
def heavier(p, d, weight):
    """Weights of the second part: rows with large errors count up to four times."""
    d_ = from_parameters(parameters(d["g"], d["v"], d["c"], corrections(p, d["x"]), RULE), d["g"], RULE, TABLE) - d["f"]
    force = jnp.minimum(jnp.sqrt(1 + TAIL * (d_[0] ** 2 + d_[1] ** 2) / 0.01**2), 4.0)
    moment = jnp.minimum(jnp.sqrt(1 + TAIL * d_[2] ** 2 / 0.014**2), 4.0)
    return weight * jnp.stack([force, force, moment, jnp.ones_like(force)])


def start(r):
    """Small weights: the answers are nearly those without corrections."""
    return np.concatenate(
        [
            r.standard_normal(FEATURES * UNITS) / np.sqrt(FEATURES),
            0.3 * r.standard_normal(UNITS),
            0.1 * r.standard_normal(UNITS * CORRECTIONS) / np.sqrt(UNITS),
            np.zeros(CORRECTIONS),
        ]
    )


FUNCTIONS = (normal_equations, cost, heavier)


def best_start(seed, parts, slopes):
    """The best of some random starts after a few steps on every third block."""
    r, best = np.random.default_rng(seed), (None, np.inf)
    for k in range(STARTS):
        print(f"start {k + 1} of {STARTS}", flush=True)
        best = min(best, levenberg_marquardt(start(r), parts[::3], slopes[::3], FUNCTIONS, FIRST), key=lambda found: found[1])
    return best[0]


def fit(p, parts, slopes, minutes, save=None):
    print("all rows", flush=True)
    p, _ = levenberg_marquardt(p, parts, slopes, FUNCTIONS, STEPS, minutes, save=save)
    for k in range(ROUNDS):
        print(f"rows with large errors weigh more, round {k + 1} of {ROUNDS}", flush=True)
        slopes = [{**part, "wt": part["wt"] * GROWTH} for part in slopes]
        p, _ = levenberg_marquardt(p, parts, slopes, FUNCTIONS, RENEWED, minutes, renew=True, save=save)
    return p


def levenberg_marquardt(p, parts, slopes, functions, steps, minutes=np.inf, renew=False, prior=PRIOR, save=None):
    """Levenberg-Marquardt, products in single precision: coefficients and sum of squares for a row; `renew`: rows with large errors weigh more, renewed every ten steps."""
    normal_equations, cost, heavier = functions
    began, damping, gains = time.time(), 1e-2, []
    n = BLOCK * len(parts)
    plain, prior = [part["wt"] for part in parts], prior * n
    both = [(part, False) for part in parts] + [(part, True) for part in slopes]

    def total(p):
        return sum(float(cost(jnp.float32(p), part, pairs)) for part, pairs in both) + prior * np.sum(p * p)

    for iteration in range(1, steps + 1):
        if renew and iteration % 10 == 1:
            for part, weight in zip(parts, plain):
                part["wt"] = heavier(jnp.float32(p), part, weight)
        h, grad, before = prior * np.eye(len(p)), prior * p, total(p)
        for part, pairs in both:
            hk, gk, _ = normal_equations(jnp.float32(p), part, pairs)
            h, grad = h + np.array(hk), grad + np.array(gk)
        scale = np.diag(h) + 1e-9 * n
        for attempt in range(8):
            q = p - np.linalg.solve(h + damping * np.diag(scale), grad)
            after = total(q)
            if after < before:
                break
            damping *= 4
        else:
            break
        p = q
        damping = max(damping / (3 if attempt == 0 else 1), 1e-8)
        gains.append(1 - after / before)
        spent = (time.time() - began) / 60
        if iteration % 10 == 0 or iteration < 4:
            left = min(minutes - spent, spent / iteration * (steps - iteration))
            print(f"  iteration {iteration:4d} rms {np.sqrt(after / n):.5f} gain {gains[-1]:.1e}, {spent:.1f} min, at most {max(0, left):.1f} min to go", flush=True)
            if save:
                np.save(save, p)
        if spent > minutes or (len(gains) > 40 and np.mean(gains[-20:]) < 1e-5):
            break
    value = total(p) / n
    for part, weight in zip(parts, plain):
        part["wt"] = weight
    return p, value


# --- reports -----------------------------------------------------------------------------------


def corrected(p, x, z, g, long=None):
    """All corrections; those of long contacts are the stored ones unless others are given."""
    return corrections(p, x) + share_of_long(g) * of_long(long or read_long(), z)


def predict(p, data, count=STRIPS, power=True, long=None):
    long = long or read_long()

    def run(x, z, g, v, c):
        f = totals(g, v, c, corrected(p, x, z, g, long), count)
        return dissipative(f, v, c) if power else f

    run, size = jax.jit(run), len(data["g"])
    block = min(BLOCK, size)
    index = np.r_[np.arange(size), np.zeros(-size % block, int)]
    return np.concatenate([np.array(run(*(jnp.array(data[key][..., i]) for key in ("x", "z", "g", "v", "c")))) for i in index.reshape(-1, block)], 1)[:, :size]


def report(label, p, data, regions=False, count=STRIPS, long=None):
    value = predict(p, data, count, long=long)
    plain = {"g": data["g"], "v": data["v"].T, "c": data["c"].T, "f": data["f"][:3].T}
    common.report(label, value[:3].T, plain, regions)
    d = value[3] - data["f"][3]
    print(f"{'':24s} stick fraction: mean |error| {abs(d).mean():.4f}, bias {d.mean():+.4f}", flush=True)


def figures(e):
    return f"{e.mean():.4f} {np.percentile(e, 95):.4f} {e.max():.4f}"


def report_slopes(p, file):
    """Worst entry of d(fx, fy)/d(vx, vy, phi) of each state divided by the linear derivatives, against CONTACT's differences."""
    k = common.read(os.path.abspath(file))
    g, nu, v = k["a_over_b"], k["nu"], np.stack([k["vx"], k["vy"], k["phi"]])
    c, worst = np.stack(common.coefficients(g, nu)), []
    for j, by in enumerate(("vx", "vy", "phi")):
        e = np.zeros_like(v)
        e[j] = 1e-4 / c[j]
        slope = (predict(p, case(g, nu, v + e)) - predict(p, case(g, nu, v - e))) / (2 * e[j])
        worst += [abs(slope[i] - k[f"{f}_{by}"]) / c[j] for i, f in enumerate(("fx", "fy"))]
    print(f"  slopes: worst entry over the linear slope {figures(np.max(worst, 0))}", flush=True)


def report_limits(p):
    """Rigid slip: other rows than those fitted."""
    data = limit_rows(300, seed=5)
    d = predict(p, data)[:3] - data["f"][:3]
    moment = np.array([rigid_slip(g, 0.0, 0.0, 1.0, 30)[2] for g in data["g"]])
    print(f"  limits: force {figures(np.hypot(d[0], d[1]))} moment over that of spin alone {figures(abs(d[2]) / moment)}", flush=True)


def report_fields(p, folder):
    errors, sticks = [], []
    with open(os.path.join(folder, "index.csv"), newline="", encoding="utf-8") as file:
        cases = list(csv.DictReader(file))
    for row in cases:
        g, nu, xi, eta, psi = (float(row[key]) for key in ("a_over_b", "nu", "xi", "eta", "psi"))
        data = case(np.array([g]), np.array([nu]), np.array([[3 * (1 - nu) / np.pi * xi], [3 / np.pi * eta], [3 / np.pi / np.sqrt(g) * psi]]))
        with open(os.path.join(folder, row["file"]), newline="", encoding="utf-8") as file:
            points = list(csv.DictReader(file))
        x, y, px, py = (np.array([float(point[key]) for point in points]) for key in ("x_over_a", "y_over_b", "px", "py"))
        reference = np.array([point["state"] == "stick" for point in points])
        q = np.array(parameters(data["g"], data["v"], data["c"], corrected(p, data["x"], data["z"], data["g"]), RULE))[:, 0]
        tx, ty, stick, pressure = map(np.array, traction(q, x, y))
        errors.append(np.hypot(tx - px, ty - py).sum() / pressure.sum())
        sticks.append(stick.mean() - reference.mean())
        print(f"  {row['file']:32s} field error {errors[-1]:.4f}, stick {stick.mean():.3f} (reference {reference.mean():.3f}), wrong state {np.mean(stick != reference):.3f}")
    print(f"  fields: mean error {np.mean(errors):.4f}, largest {max(errors):.4f}, stick fraction off by {np.mean(np.abs(sticks)):.4f}", flush=True)


# --- files -------------------------------------------------------------------------------------


def list_of(values):
    return "[" + ", ".join(repr(float(x)) for x in values) + "]"


def write(p, note):
    m1, b1, m2, b2 = unpack(p)
    common.write_constants(
        OUT,
        [
            "Constants of the strips of STRIP.",
            "",
            "Written by `fit/fit_strip.py` from `fit/data/train.csv`, `train_fine.csv` and `train_slender.csv`",
            "(values computed with CONTACT, see `fit/data/README.md`) and `boundary_elements.csv`.",
            *note,
        ],
        [
            ("Fitted: offsets of the units, and weights of the features of the contact.", "FIXED", np.vstack([b1, m1[CONTACT]])),
            ("Fitted: one row of weights per feature.", "INPUT", np.delete(m1, CONTACT, 0)),
            ("Fitted: one row of weights per unit.", "OUTPUT", m2),
            ("Fitted: offsets of the corrections.", "OFFSET", b2),
        ],
    )
    lines = ["/// Nodes on the slip part of a strip.", f"pub(crate) const NODES: usize = {NODES};"]
    for doc, name, value in (
        ("Half width of the rounded cut at the friction bound, in `q`, without spin.", "ROUND", ROUND),
        ("What it grows by with `r⁴`.", "ROUND_SPIN", ROUND_SPIN),
        ("Softening of the cut by the node's own cell.", "NODE", NODE),
        ("Share of the square of the strip's own spread in `q`.", "AVERAGE", AVERAGE),
        ("Spins `|σ|` between which the slip part grows over the whole strip.", "BLEND", BLEND),
        ("The separatrix meets the leading edge smoothly over this length.", "EDGE", EDGE),
        ("Squared linear force from which on forces are corrected.", "WIDTH", WIDTH),
        ("The same for the correction of forces and moments together.", "WIDTH2", WIDTH2),
        ("Linear force in `μ N` where the flexibilities have become those of the rigid slip, half and half.", "SATURATION", SATURATION),
    ):
        kind, text = (f"[f64; {len(value)}]", list_of(value)) if np.ndim(value) else ("f64", repr(value))
        lines += [f"/// {doc}", f"pub(crate) const {name}: {kind} = {text};"]
    for doc, name, i in (
        ("Places `t` of the nodes: on the outermost strips and every second one, and on the others.", "PLACES", 0),
        ("Their half cells in `t`.", "CELLS", 1),
    ):
        lines += [f"/// {doc}", "#[rustfmt::skip]", f"pub(crate) const {name}: [[f64; NODES]; 2] = ["]
        lines += [f"    {list_of(kind[i])}," for kind in KINDS] + ["];"]
    lines += ["/// Their weights: coefficients of `u², u³, u⁴, u⁵`.", "#[rustfmt::skip]", "pub(crate) const WEIGHTS: [[[f64; 4]; NODES]; 2] = ["]
    for kind in KINDS:
        lines += ["    ["] + [f"        {list_of(c)}," for c in kind[2]] + ["    ],"]
    lines += ["];"]
    with open(OUT, encoding="utf-8") as file:
        head, body = file.read().split("\n\n", 1)
    with open(OUT, "w", encoding="utf-8") as file:
        file.write(head + "\n\n" + "\n".join(lines) + "\n" + body)


HEAD_OF_NODES = """//! Where the strips of the Hertz ellipse lie.
//!
//! Gauss-Legendre rules on either half of the contact (64 strips: on its quarters), because the
//! longitudinal slip of spin changes its sign near the middle: with 16 strips the totals are then three to seven
//! times closer to the limit of many strips than with one rule over the whole width.
//! Written by `fit/fit_strip.py --nodes`; a test checks the rules.
// Generated: change the script, not this file.

/// The half of a rule with `Y > 0`: `Y`, `C = √(1 − Y²)`, width.
type Half<const H: usize> = [[f64; 3]; H];
"""


def write_nodes():
    """The rules, computed with 40 digits."""
    import mpmath

    mpmath.mp.dps = 40
    text = HEAD_OF_NODES
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
        text += f"\n#[rustfmt::skip]\npub(super) const HALF_OF_{n}: Half<{n // 2}> = [\n"
        text += "".join("    [" + ", ".join(repr(float(z)) for z in row) + "],\n" for row in rows) + "];\n"
    with open(os.path.join(FOLDER, "nodes.rs"), "w", encoding="utf-8") as file:
        file.write(text)


def read_back():
    k = common.read_constants(OUT)
    m1 = np.insert(k["INPUT"], CONTACT[0], k["FIXED"][1:], 0)
    return np.concatenate([part.ravel() for part in (m1, k["FIXED"][0], k["OUTPUT"], k["OFFSET"])])


def numbers(p):
    """Totals for the unit test of the Rust code: g, nu, vx, vy, phi, then fx, fy, mz, stick for 16 strips."""
    r = np.random.default_rng(5)
    n = 24
    g, nu = 10 ** r.uniform(-1, 1.8, n), r.uniform(0, 0.5, n)
    v = np.stack([r.normal(0, 0.3, n), r.normal(0, 0.3, n), r.normal(0, 0.5, n)], 1)
    v[0, 2], v[1, :2], v[2], v[3] = 0, 0, v[2] * 20, v[3] * 1e-3
    g, nu, v = g.round(3), nu.round(3), v.round(5)
    print("[")
    for row in zip(g, nu, v, predict(p, case(g, nu, v.T)).T):
        print(f"([{row[0]}, {row[1]}, {row[2][0]}, {row[2][1]}, {row[2][2]}], {[float(f'{x:.15g}') for x in row[3]]}),")
    print("]")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--numbers", action="store_true")
    parser.add_argument("--nodes", action="store_true")
    parser.add_argument("--minutes", type=float, default=30.0)
    parser.add_argument("--rows", type=int, default=0)
    parser.add_argument("--seed", type=int, default=2)
    parser.add_argument("--open")
    parser.add_argument("--slopes")
    parser.add_argument("--fields")
    parser.add_argument("--save", help="file for the state in between")
    parser.add_argument("--from-stored", action="store_true", help="start from the constants in src/strip")
    parser.add_argument("--resume", help="file of an earlier --save")
    parser.add_argument("--dry", action="store_true", help="do not write the constants")
    args = parser.parse_args()

    if args.nodes:
        write_nodes()
        return
    if args.numbers:
        numbers(read_back())
        return
    training, validation = split(load("train.csv", "train_fine.csv"))
    own, held = own_rows()
    slender = load("train_slender.csv")
    training = joined(training, slender)
    training = joined(take(training, training["g"] < LONGEST), take(own, own["g"] < OWN_LONGEST))
    if args.check:
        p = read_back()
    else:
        if args.rows:
            training = take(training, np.arange(min(args.rows, len(training["g"]))))
        parts = blocks(training)
        slopes = slope_blocks(training)
        print(f"{COUNT} coefficients, {BLOCK * len(parts)} rows, {len(validation['g'])} rows for validation", flush=True)
        p = read_back() if args.from_stored else np.load(args.resume) if args.resume else best_start(args.seed, parts, slopes)
        p = fit(p, parts, slopes, args.minutes, args.save)
        p = p.astype(np.float32).astype(float)
        if not args.dry:
            write(p, [f"Trained on {len(training['g'])} rows; {len(validation['g'])} others of CONTACT were kept for validation."])
    report("validation", p, validation, regions=args.check)
    report("boundary_elements.csv", p, joined(own, held), regions=args.check)
    report("  held back, a/b < 7", p, take(held, held["g"] < OWN_LONGEST))
    report_limits(p)
    if args.open:
        data = load(os.path.abspath(args.open))
        report("open", p, data, regions=args.check)
        for count in (4, 8, 32, 64):
            report(f"  {count} strips", p, data, count=count)
    if args.slopes:
        report_slopes(p, args.slopes)
    if args.fields:
        report_fields(p, args.fields)


if __name__ == "__main__":
    main()
