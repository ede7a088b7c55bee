"""Fit the corrections of the model TOTAL; write src/total/constants.rs and print check values for its tests.

python fit_total.py                         the real fit, from random starts (80 minutes on one core)
python fit_total.py --from-stored           the stages on all rows alone, from the stored constants (70 minutes)
python fit_total.py --quick                 a few iterations only, to see that everything runs (constants not written)
python fit_total.py --evaluate [file.csv]   errors of the stored constants, by region

Least squares of all residuals of data/train_slender.csv and of 90 % of data/train.csv, data/train_fine.csv and data/boundary_elements.csv;
the other 10 % are never trained on and are what "validation" means. Of many random starts, each trained a little on a quarter of the rows, the best
is trained to the end, together with the constants of the formulas around the network: by Levenberg-Marquardt at first, then by a quasi-Newton descent.
Out of the minimum where this ends it comes to lower ones: the network grows, descends, and shrinks again, 24 times.
"""

import argparse
import os
import time

import common
import jax
import jax.numpy as jnp
import numpy as np
import rigid_slip
from scipy.linalg import blas, cho_factor, cho_solve, cholesky, solve_triangular
from scipy.optimize import minimize

jax.config.update("jax_enable_x64", True)

# what the network is told: first what depends on the contact only, then in the order in which the
# library has them
FEATURES = [
    "slender", "poisson", "slender2", "slender3", "slender * poisson",
    "kappa", "kappa * slender", "f_y", "f_s", "f_s4", "f_u", "f_s * slender", "f_ys",
    "f_e", "f_ex", "f_es", "f_e * slender", "f_e * kappa", "f_e * f_s", "ix", "im",
]  # fmt: skip
FIXED = 5
WIDTHS = (22, 14)  # units of the two hidden layers
STARTS, PART = 24, 4  # random starts, and the part of the rows that they are trained on
FEW, KEPT, MORE, LAST = 80, 8, 12, 80  # steps of each; how many go on, for how many cycles of `quasi_newton`; and cycles of the best on all rows
HOPS, ADDED = 24, (6, 3)  # how often the network grows and shrinks again, and by how many units of the two hidden layers
GROW, SETTLE, END = 10, 12, 30  # cycles of the larger network, of the smaller one after it, and of the last one
AMONG = 100  # random units that those to be added are the best of
FADING, FADE = (0.03, 0.1, 0.3, 1, 3, 10, 30, 100, 300), 50  # penalty of units that are to go, one cycle each; steps of such a cycle
OUTPUTS = 6
CONSTANTS = os.path.join(common.SOURCE, "total", "constants.rs")
SCALE = np.array([1, 1, 0.55])  # weight of the moment's residual against the force's
PENALTY = 6e-4  # on the square of the coefficients
PENALTY_FRAME = 0.03  # on the square of the logarithm of the change of a constant of the formulas
BLOCK = 2048
DESCENT, MEMORY, DAMPING = 100, 50, 1e-5  # of `quasi_newton`: steps of a cycle, those that it remembers, factor of the diagonal
LARGEST_ROOT = 8  # the network does not see that a contact is more slender than a/b = 64 or 1/64; no row of the data is
SLIDING = 4000  # rows of rigid slip
WIDEST = 70  # axis ratios of rigid slip, and their inverse
OWN = 0.04  # how often a row of boundary_elements.csv counts: they lie where little slip turns much, and the network is small
# in the last cycles: how often these rows count, the weight of their moments below a/b = 7, and
# PENALTY
OWN_LAST, MOMENT_LAST, PENALTY_LAST = 0.02, 2.5, 4e-4
STEP, SLOPE_WEIGHT = 0.04, 0.4  # of the differences of boundary_slopes.csv in linear force; weight of a slope's error over the linear slope
# of two creepages in one direction, the second FARTHER, beside the same spin: of the amount that the force
# lacks of the bound the second may lack HOLD
FALLS, FARTHER, HOLD, NEARLY, FALL_WEIGHT = 2000, 1.15, 0.9, 0.95, 40.0
GROWING = 2 / (1 - NEARLY)  # how fast that sets in
SLENDER = 3  # how often a row of train_slender.csv counts

# Constants of the formulas around the network, fitted with it: name in the library, what it is,
# first value.
FRAME = {
    "ONSET": ("Squared linear force at which corrections have half of their weight.", 0.05),
    "END_X": ("Share of the other axis in the slip that spin makes at the end of an axis: longitudinal.", 0.27),
    "END_Y": ("The same, lateral.", 0.27),
    "REACH_X": ("How much of that slip brakes the longitudinal slope.", 1 / 1.5),
    "REACH_Y": ("The same of the lateral slope.", 1 / 1.5),
    "SEEN_U": ("Inputs of the network, what is added or multiplied before the inverse: `u²`.", 0.5),
    "SEEN_Y": ("`φ² g` beside `vy²`.", 0.002),
    "SEEN_S": ("`s²`", 1.0),
    "SEEN_S4": ("`s⁴`", 1.0),
    "SEEN_E": ("`e²`", 1.0),
    "SEEN_ES": ("`e² + s²`", 1.0),
    "SEEN_YS": ("`(ly + ls)² + s²`", 1.0),
    "TURN": ("From elastic slopes to those of sliding: factor of `e⁴`.", 0.1),
    "BRAKE": ("What creepage takes from the spin's slope: factor of `u²`.", 0.3),
    "SHEAR": ("Share of the squared spin force in `|q|²`: spin shears the patch also where its force and that of the creepage cancel.", 0.04),
    "LOSS": ("What spin takes from the force in full sliding: factor of `κ`.", 0.3),
}


# --- saturation curve ------------------------------------------------------------------------

FULL = 3 * np.pi / 4  # |q| of full sliding


def saturation_polynomial(degree=4):
    """S/|q| as a polynomial in |q| = 3 pi/4 d, lowest power first, and the largest error of S.

    S = 1 - (1 - d)^2 P(d) for S of Section 8.15; P(0) = 1 and P'(0) give S(0) = 0 and the exact slope 3 pi/4 there, the square gives
    slope 0 at d = 1. The other coefficients of P by least squares, repeated with more weight on the largest errors.
    """
    d = np.linspace(1e-4, 1, 2000)
    s = 1 - ((2 + d * d) * np.sqrt(1 - d * d) - 3 * d * np.arccos(d)) / 2
    slope = 2 - 0.75 * np.pi
    a = np.stack([-((1 - d) ** 2) * d**k for k in range(2, degree + 1)], 1)
    b = s - 1 + (1 - d) ** 2 * (1 + slope * d)
    weight = np.ones(len(d))
    for _ in range(200):
        p = np.linalg.lstsq(a * weight[:, None], b * weight, rcond=None)[0]
        error = abs(a @ p - b)
        weight *= 1 + 0.2 * (error / error.max()) ** 2
        weight /= weight.mean()
    p = np.round(p, 6)  # the same on every machine
    product = np.polymul([1, -2, 1], [*p[::-1], slope, 1])[::-1]
    return -product[1:] / FULL ** np.arange(1, len(product)), abs(a @ p - b).max()


SATURATION, SATURATION_ERROR = saturation_polynomial()


def saturation(q2):
    """S(|q|)/|q|."""
    q = jnp.sqrt(q2 + 1e-30)
    e = jnp.minimum(q, FULL)
    k = 0.0
    for c in SATURATION[::-1]:
        k = k * e + c
    return k * FULL / jnp.maximum(q, FULL)


# --- model: the same formulas as src/total/mod.rs ----------------------------------------------

GROWTH = 0.0003  # of the slope with e^6 beyond saturation: |q| of translation does not fall below that of full sliding again
# size of the linear force where half of the result is that of rigid slip: translation, and spin
TRANSLATION, SPIN = 20.0, 150.0


def states(g, nu, v, c):
    """What the formulas start from: contact, creepages, linear coefficients; rigid slip and the share of spin in it."""
    vx, vy, phi = v.T
    rx, ry, rz, ra, rd, kappa = rigid_slip.parts(RIGID, g, vx, vy, phi)
    force = 1 / np.sqrt(rx * rx + ry * ry + rz + 1e-30)
    return np.stack([g, nu, vx, vy, phi, *c.T, rx * force, ry * force, ra / np.sqrt(rd + 1e-30), kappa], 1)


def constants_of(logs):
    return {name: first * jnp.exp(log) for (name, (_, first)), log in zip(FRAME.items(), logs)}


def frame(k, state):
    """Of each contact: what the network is told, and what its corrections work on."""
    g, nu, vx, vy, phi, c11, c22, c23, c33, rx, ry, rm, kappa = state.T
    root = jnp.sqrt(g)
    inverse, both = root / g, g + 1 / g
    lx, ly, ls = c11 * vx, c22 * vy, c23 * phi
    u2, s2 = lx * lx + ly * ly, ls * ls
    ix = 1 / (1 + (c11 * (inverse + k["END_X"] * root) * k["REACH_X"] * phi) ** 2)
    iy = 1 / (1 + (c22 * (root + k["END_Y"] * inverse) * k["REACH_Y"] * phi) ** 2)
    moment = 1 / (0.1406 * (both + 0.467))
    tm2 = (c33 * phi) ** 2 * moment
    im = 1 / (1 + tm2 + u2)
    n2 = u2 + s2 + tm2
    w = n2 / (k["ONSET"] + n2)
    e2 = lx * lx * ix + ly * ly * iy
    de = 1 / (1 + k["TURN"] * e2 * e2)
    shape = jnp.clip(root, 1 / LARGEST_ROOT, LARGEST_ROOT)
    slender, poisson = (shape - 1) / (shape + 1), 4 * nu - 1
    pole = (1 - kappa) ** 8
    far = n2 * n2 * (pole / TRANSLATION**4 + 1 / SPIN**4)
    far = far / (1 + far)
    fs, fe, lys, py2 = 1 / (k["SEEN_S"] + s2), 1 / (k["SEEN_E"] + e2), ly + ls, phi * phi * g
    features = {
        "slender": slender,
        "poisson": poisson,
        "slender2": slender * slender,
        "slender3": slender * slender * slender,
        "slender * poisson": slender * poisson,
        "kappa": kappa,
        "kappa * slender": kappa * slender,
        "f_y": py2 / (k["SEEN_Y"] + vy * vy + py2),
        "f_s": fs,
        "f_s4": 1 / (k["SEEN_S4"] + s2 * s2),
        "f_u": 1 / (1 + k["SEEN_U"] * u2),
        "f_s * slender": fs * slender,
        "f_ys": lys * ls / (k["SEEN_YS"] + lys * lys + s2),
        "f_e": fe,
        "f_ex": lx * lx * ix * fe,
        "f_es": ly * ls / (k["SEEN_ES"] + e2 + s2),
        "f_e * slender": fe * slender,
        "f_e * kappa": fe * kappa,
        "f_e * f_s": fe * fs,
        "ix": ix,
        "im": im,
    }
    by = c22 * jnp.sqrt(iy)
    growth = c22 * GROWTH * e2**3 * pole
    spin = c23 / (1 + s2 + k["BRAKE"] * u2)
    places = (w, vx, vy, phi, by * (1 - de), c11 * jnp.sqrt(ix) * de, by, growth, spin, c33 * jnp.sqrt(im), kappa, de, moment, 1 - far, far * rx, far * ry, far * rm)
    return jnp.stack([features[name] for name in FEATURES], 1), places


def activation(x):
    return 2 * x / (1 + x * x)


def network(layers, x):
    """The corrections; the units of both hidden layers and their slopes."""
    z = x @ layers[0][1:] + layers[0][0]
    h1, s1 = activation(z), 2 / (1 + z * z) - activation(z) ** 2
    z = h1 @ layers[1][1:] + layers[1][0]
    h2, s2 = activation(z), 2 / (1 + z * z) - activation(z) ** 2
    return h2 @ layers[2][1:] + layers[2][0], h1, s1, h2, s2


def positive(o):
    """1 at o = 0, never below 1/101."""
    return 1 + o * (2 + 1.01 * o)


def corrected(k, o, places):
    """(fx, fy, mz) of each contact."""
    w, vx, vy, phi, bx, bx1, by, growth, spin, em, kappa, de, moment, near, rx, ry, rm = places
    o = w[:, None] * o
    k1, k2, k3, k4, k6 = (positive(o[:, i]) for i in (0, 1, 2, 3, 5))
    qx, qy = (k2 * (bx + bx1 * k1) + growth) * vx, (k2 * by + growth) * vy + k3 * spin * phi
    q2 = qx * qx + qy * qy + k["SHEAR"] * (spin * phi) ** 2
    sigma = saturation(q2) / (1 + k["LOSS"] * kappa * w * k6)
    epsilon = em * k4
    epsilon = epsilon / (1 + (moment * (epsilon * phi) ** 2) ** 2 / 16)
    rho = activation(o[:, 4]) * de
    mz = epsilon * phi + sigma * (2 * rho * jnp.sqrt(k2 * by * epsilon) - k3 * spin) * vy
    return jnp.stack([near * sigma * qx + rx, near * sigma * qy + ry, near * mz + rm], 1)


@jax.jit
def answers(model, state):
    """Of a model: three layers, and the logarithms of its constants of the formulas over their first values."""
    k = constants_of(model[3])
    x, places = frame(k, state)
    return corrected(k, network(model, x)[0], places)


@jax.jit
def slopes(model, state):
    """The answers, the units and their slopes, the answers' slopes over corrections and over the logarithms of the constants."""
    k = constants_of(model[3])
    x, places = frame(k, state)
    o, *units = network(model, x)

    def along(f, at, directions):
        return jnp.moveaxis(jax.vmap(lambda d: jax.jvp(f, (at,), (d,))[1])(directions), 0, 2)

    by_o = along(lambda o: corrected(k, o, places), o, jnp.broadcast_to(jnp.eye(OUTPUTS)[:, None], (OUTPUTS, *o.shape)))
    by_k = along(lambda logs: answers([*model[:3], logs], state), model[3], jnp.eye(len(FRAME)))
    return corrected(k, o, places), [a.astype(jnp.float32) for a in (x, *units, by_o, by_k)]


def predict(model, data):
    return np.array(answers(model, states(data["g"], data["nu"], data["v"], data["c"])))


# --- rows ------------------------------------------------------------------------------------


def stored_rigid(path):
    """The closed form of rigid slip as the library has it."""
    found = common.read_constants(path)
    return {name: found[name].reshape(shape) for name, shape in zip(rigid_slip.NAMES, rigid_slip.SHAPES) if name in found}


RIGID = stored_rigid(CONSTANTS)


class Rows:
    """Rows to fit and, in `pairs` and `falls`, states of which two and two belong together."""

    def __init__(self, data, pairs=None, falls=None, own=OWN, own_moment=1.0):
        self.state = jnp.array(states(data["g"], data["nu"], data["v"], data["c"]))
        self.data, self.count = data, len(data["g"])
        self.pairs, self.falls = pairs, falls
        self.weight, self.own_moment = row_weights(data, own), own_moment

    def errors(self, model):
        return np.array(answers(model, self.state)) - self.data["f"]

    def parts(self):
        """What the sum of squares is taken over, as arguments of `squares`."""
        return [rows and (rows.state, rows.data["f"], weights(rows)) for rows in (self, self.pairs, self.falls)]

    def cost(self, model, penalty):
        return float(squares(model, *self.parts(), penalties(model, penalty))) / self.count


@jax.jit
def squares(model, rows, pairs, falls, penalty):
    """The sum of squares: of the weighted errors, of their differences where two states make a slope, of the falls, of the coefficients."""

    def errors(part):
        state, f, weight = part
        return (answers(model, state) - f) * weight

    total = (errors(rows) ** 2).sum() + (penalty * jnp.concatenate([part.ravel() for part in model]) ** 2).sum()
    if pairs:
        total += (differences(errors(pairs)) ** 2).sum()
    if falls:
        beyond, counts = fall(answers(model, falls[0]))
        total += ((beyond * counts) ** 2).sum() * FALL_WEIGHT**2
    return total


slope_of_squares = jax.jit(jax.value_and_grad(squares))


def differences(a, _=None):
    return a[0::2] - a[1::2]


def fall(f):
    """By how much the second force of two lacks more of the bound than it may, and what that counts: where the first has nearly reached the bound."""
    size = jnp.sqrt(f[:, 0] ** 2 + f[:, 1] ** 2)
    near, far = size[0::2], size[1::2]
    # (from NEARLY on, fully from halfway to the bound on)
    return jnp.minimum(far - 1 - HOLD * (near - 1), 0), jnp.clip((near - NEARLY) * GROWING, 0, 1)


def fallen(a, f):
    """The falls; or, if `a` are slopes, those of the falls."""
    beyond, counts = map(np.array, fall(f))
    if a is f:
        return beyond * counts
    along = (f[:, :2] / np.hypot(f[:, 0], f[:, 1])[:, None])[:, :, None]
    by_size = (a[:, :2] * along).sum(1)
    slope = np.where(beyond[:, None] < 0, by_size[1::2] - HOLD * by_size[0::2], 0) * counts[:, None]
    return slope + (beyond * GROWING * ((counts > 0) & (counts < 1)))[:, None] * by_size[0::2]


def fall_rows(seed=13):
    """Creepages on the way to full sliding beside a spin of less than unit psi, and the same FARTHER."""
    r = np.random.default_rng(seed)
    g, nu = np.exp(r.uniform(-np.log(12), np.log(12), FALLS)), 0.5 * r.random(FALLS)
    angle, size = 2 * np.pi * r.random(FALLS), np.exp(r.uniform(0, np.log(12), FALLS))
    c = np.stack(common.coefficients(g, nu), 1)
    spin = r.uniform(-0.8, 0.8, FALLS) / (np.pi / 3 * np.sqrt(g))
    near = np.stack([size * np.cos(angle) / c[:, 0], size * np.sin(angle) / c[:, 1], spin], 1)
    v = np.stack([near, near * np.array([FARTHER, FARTHER, 1])], 1).reshape(-1, 3)
    none = np.zeros(2 * FALLS, bool)
    return Rows({"g": np.repeat(g, 2), "nu": np.repeat(nu, 2), "v": v, "c": np.repeat(c, 2, 0), "f": np.zeros((2 * FALLS, 3)), "err": none, "fine": none, "slender": none, "own": none})


def slope_rows():
    """The slopes of boundary_slopes.csv as neighbouring states: the first has the difference, the second zero."""
    k = common.read("boundary_slopes.csv")
    g, nu, v = k["a_over_b"], k["nu"], np.stack([k["vx"], k["vy"], k["phi"]], 1)
    c = np.stack(common.coefficients(g, nu), 1)
    moved = STEP / c[:, :3, None] * np.eye(3)
    v = v[:, None, None] + moved[:, :, None] * np.array([[1], [-1]])
    slopes = np.stack([np.stack([k[f"{f}_{by}"] for f in ("fx", "fy", "mz")], 1) for by in ("vx", "vy", "phi")], 1)
    f = np.zeros((len(g), 3, 2, 3))
    f[:, :, 0] = 2 * STEP * slopes / c[:, :3, None]
    count = 6 * len(g)
    data = {"g": np.repeat(g, 6), "nu": np.repeat(nu, 6), "v": v.reshape(count, 3), "c": np.repeat(c, 6, 0), "f": f.reshape(count, 3)}
    none = np.zeros(count, bool)
    pairs = Rows({**data, "err": np.zeros(count), "fine": none, "slender": none, "own": none})
    pairs.weight = np.full(count, SLOPE_WEIGHT / (2 * STEP))
    return pairs


def weights(rows):
    """Of force and moment: where a contact is long the moment is large, and may be wrong by more."""
    g = rows.data["g"]
    moment = np.where(g > 12, np.sqrt(12 / g), 1.0) * np.where(rows.data["own"] & (g < 7), rows.own_moment, 1.0)
    return rows.weight[:, None] * SCALE * np.stack([np.ones_like(g), np.ones_like(g), moment], 1)


def row_weights(data, own):
    """Rows by their own error, with emphasis on both ends of the axis ratio and on much spin beside a large creepage."""
    w = np.where(data["fine"], 1.0, 0.8) * 0.004 / np.hypot(0.003, 0.5 * np.minimum(data["err"], 0.01))
    # rows of rigid slip: over the moment of sliding by spin; nearly nothing where elasticity is
    # still to be seen
    row = data["err"] < 0.1
    w = np.where(row, w, np.where(data["err"] < 0.15, 0.3, 0.018) / np.sqrt(rigid_slip.spin_moment(data["g"])))
    u, spin = np.hypot(data["c"][:, 0] * data["v"][:, 0], data["c"][:, 1] * data["v"][:, 1]), abs(data["c"][:, 2] * data["v"][:, 2])
    # a little spin beside a creepage: only there the derivative with respect to spin counts
    w = w * np.where((u > 0.3) & (u < 4) & (spin < 0.4) & ((spin > 0) | (data["g"] > 5)), np.where(spin < 0.15, 1.3, 1.21), 1.0)
    psi = np.pi / 3 * np.sqrt(data["g"]) * abs(data["v"][:, 2])
    w = w * np.where(row & (u > 0.5) & (u < 4) & (psi > 0.15) & (psi < 1.3), 1.4, 1.0)
    # spin against a lateral creepage in a long contact: the force turns over within the patch
    opposed = (data["g"] > 3) & (data["c"][:, 1] * data["v"][:, 1] < -0.3) & (spin > 0.3)
    w = w * np.where(opposed, 1.5, 1.0) * np.where(row & (data["g"] > 4), 1.25, 1.0)
    w = w * np.where(data["own"], np.sqrt(own), 1.0)
    w = w * np.where(data["slender"], np.where(data["g"] > 30, 1.3, 1.0) * np.sqrt(SLENDER), 1.0)
    return w * np.where(data["g"] > 6, 1.5, np.where(data["g"] < 0.13, 1.3, 1.0))


def sliding_rows(count=SLIDING, seed=11):
    """Rows of rigid slip. Without spin it is the truth from saturation on, with a little from 6 times saturation; with a large share,
    and the spin's pole in the patch, 10 to 400 times saturation is no more than a hint (`err` .2)."""
    r = np.random.default_rng(seed)
    g, nu = np.exp(r.uniform(-np.log(WIDEST), np.log(WIDEST), count)), 0.5 * r.random(count)
    c = np.stack(common.coefficients(g, nu), 1)
    x, y, axis = 10 ** r.uniform(-2, 2, count), 10 ** r.uniform(-2, 2, count), r.random(count)
    x, y = np.where(axis < 0.08, 1e-9, x), np.where((axis > 0.08) & (axis < 0.16), 1e-9, y)
    size = 0.5 * np.sqrt(g + 1 / g)
    v = np.stack([x * size, y * size * r.choice([-1, 1], count), np.ones(count)], 1)
    n = np.sqrt(((c[:, :3] * v) ** 2).sum(1) + (c[:, 3] / rigid_slip.spin_moment(g)) ** 2)
    kappa = 4 / (4 + x * x + y * y)
    hint = kappa > 0.3
    times = np.where(hint, 10 ** np.where(r.random(count) < 0.3, r.uniform(1, 2.6, count), r.uniform(2.6, 3.6, count)), np.where(kappa > 0.05, 10 ** r.uniform(1.48, 3, count), 10 ** r.uniform(0.78, 2, count)))
    alone = r.random(count) < 0.2
    times, hint = np.where(alone, r.uniform(1.4, 6, count), times), hint & ~alone
    v[alone, 2] = 0
    n = np.where(alone, np.hypot(c[:, 0] * v[:, 0], c[:, 1] * v[:, 1]), n)
    v = v * (times * FULL / n)[:, None]
    err = np.where(hint & (times < 400), 0.2, 0.1)
    return {"g": g, "nu": nu, "v": v, "c": c, "f": rigid_slip.sliding(g, v), "err": err, "fine": np.zeros(count, bool), "slender": np.zeros(count, bool), "own": np.zeros(count, bool)}


def joined(*parts):
    return {key: np.concatenate([part[key] for part in parts]) for key in parts[0]}


# --- fit -------------------------------------------------------------------------------------


def flat(model):
    return np.concatenate([part.ravel() for part in model])


def like(model, p):
    """The coefficients in the shape of `model`."""
    ends = np.cumsum([part.size for part in model])
    return [part.reshape(one.shape) for part, one in zip(np.split(p, ends[:-1]), model)]


def penalties(model, penalty):
    """Of each coefficient; `penalty` may be that already."""
    if np.ndim(penalty):
        return penalty
    return np.concatenate([np.full(sum(layer.size for layer in model[:3]), penalty), np.full(len(FRAME), PENALTY_FRAME)])


def normal_equations(model, rows, penalty):
    """J'J and J'r."""
    p, penalty = flat(model), penalties(model, penalty)
    h, gradient = products(model, rows)
    if rows.pairs:
        of_pairs = products(model, rows.pairs, differences)
        h, gradient = h + of_pairs[0], gradient + of_pairs[1]
    if rows.falls:
        of_falls = products(model, rows.falls, fallen)
        h, gradient = h + FALL_WEIGHT**2 * of_falls[0], gradient + FALL_WEIGHT**2 * of_falls[1]
    h = np.triu(h) + np.triu(h, 1).T
    h[np.diag_indices(len(p))] += penalty
    return h, gradient + penalty * p


def products(model, rows, of=lambda a, _: a):
    """Upper triangle of J'J, and J'r. J in single precision: an outer product per layer of its inputs and of the slopes behind it."""
    p = flat(model)
    h, gradient = np.zeros((len(p), len(p)), order="F"), np.zeros(len(p))
    f, arrays = slopes(model, rows.state)
    x, h1, s1, h2, s2, by_o, by_k = map(np.array, arrays)
    weight = (np.ones((rows.count, 3)) if of is fallen else weights(rows)).astype(np.float32)
    residuals = (np.array(f) - rows.data["f"]).astype(np.float32) * weight
    inputs = [np.concatenate([np.ones((rows.count, 1), np.float32), a], 1)[:, None, :, None] for a in (x, h1, h2)]
    last, second = (model[k][1:].T.astype(np.float32) for k in (2, 1))
    behind = [None, None, by_o * weight[:, :, None]]
    behind[1] = behind[2] @ last * s2[:, None]
    behind[0] = behind[1] @ second * s1[:, None]
    by_k = by_k * weight[:, :, None]
    for start in range(0, rows.count, BLOCK):
        s = slice(start, start + BLOCK)
        r = residuals[s]
        j = np.concatenate([(a[s] * b[s, :, None]).reshape(*r.shape, -1) for a, b in zip(inputs, behind)] + [by_k[s]], 2)
        j, r = of(j, r), of(r, r).ravel()
        j = j.reshape(r.size, -1)
        h += blas.ssyrk(1.0, j.T)
        gradient = gradient + j.T @ r
    return h, gradient


def levenberg_marquardt(model, rows, iterations, label, penalty, damping=1e-4):
    began, current = time.time(), rows.cost(model, penalty)
    for step in range(1, iterations + 1):
        h, gradient = normal_equations(model, rows, penalty)
        diagonal = np.diag(h)
        for attempt in range(10):
            try:
                change = cho_solve(cho_factor(h + damping * np.diag(diagonal + 1e-6 * diagonal.max())), gradient)
            except np.linalg.LinAlgError:
                damping *= 4
                continue
            trial = like(model, flat(model) - change)
            new = rows.cost(trial, penalty)
            if new < current:
                break
            damping *= 4
        else:
            break
        model, current = trial, new
        if attempt == 0:
            damping = max(damping / 3, 1e-9)
        if step % 20 == 0 or step == iterations:
            spent = time.time() - began
            print(f"  {label} step {step}/{iterations} cost {current:.4g} damping {damping:.0e}, {spent:.0f} s, at most {spent / step * (iterations - step):.0f} s more", flush=True)
    return model


def quasi_newton(model, rows, cycles, label, penalty, steps=DESCENT):
    """Descent along the slope, in coordinates in which the matrix of Levenberg and Marquardt is the identity, formed anew in every cycle.

    A slope costs a fortieth of that matrix. The descent learns the curvature that the matrix lacks from the last MEMORY steps.
    """
    began, p, parts, penalized = time.time(), flat(model), rows.parts(), penalties(model, penalty)
    for cycle in range(1, cycles + 1):
        h = normal_equations(like(model, p), rows, penalty)[0]
        diagonal = np.diag(h)
        root = cholesky(2 * (h + DAMPING * np.diag(diagonal + 1e-6 * diagonal.max())), lower=True)

        def value(y, p=p, root=root):
            total, by_part = slope_of_squares(like(model, p + solve_triangular(root, y, lower=True, trans="T")), *parts, penalized)
            return float(total), solve_triangular(root, flat([np.array(part) for part in by_part]), lower=True)

        found = minimize(value, np.zeros(len(p)), jac=True, method="L-BFGS-B", options={"maxcor": MEMORY, "maxiter": steps, "ftol": 1e-10, "gtol": 1e-9})
        p = p + solve_triangular(root, found.x, lower=True, trans="T")
        if cycle % 4 == 0 or cycle == cycles:
            spent = time.time() - began
            print(f"  {label} cycle {cycle}/{cycles} cost {found.fun / rows.count:.4g}, {spent:.0f} s, at most {spent / cycle * (cycles - cycle):.0f} s more", flush=True)
    return like(model, p)


def enlarged(model, rows, hidden, count, random):
    """With `count` more units of a hidden layer: of many random ones, those whose work in the next layer would lower the sum of squares fastest."""

    def with_units(incoming, outgoing):
        layers = list(model)
        layers[hidden] = np.hstack([layers[hidden], incoming])
        layers[hidden + 1] = np.vstack([layers[hidden + 1], outgoing])
        return layers

    inputs, following = len(model[hidden]) - 1, model[hidden + 1].shape[1]
    size = (1.5 if hidden == 0 else 1.0) / np.sqrt(inputs)
    incoming = np.vstack([0.5 * random.standard_normal((1, AMONG)), size * random.standard_normal((inputs, AMONG))])
    trial = with_units(incoming, np.zeros((AMONG, following)))
    slope = np.array(slope_of_squares(trial, *rows.parts(), penalties(trial, PENALTY))[1][hidden + 1][-AMONG:])
    best = np.argsort(-(slope**2).sum(1))[:count]
    return with_units(incoming[:, best], 1e-3 * random.standard_normal((count, following)))


def outgoing(model, hidden):
    """Of each unit of a hidden layer: where its coefficients in the next layer are among all."""
    return list(like(model, np.arange(len(flat(model))))[hidden + 1][1:])


def inverse(model, rows):
    h = normal_equations(model, rows, PENALTY)[0]
    diagonal = np.diag(h)
    return np.linalg.inv(h + DAMPING * np.diag(diagonal + 1e-6 * diagonal.max()))


def missed_least(model, rows, hidden, count):
    """Units of a hidden layer, one after the other that without which the sum of squares rises least if all other coefficients follow."""
    p, h, units, found = flat(model), inverse(model, rows), outgoing(model, hidden), []
    for _ in range(count):
        loss = {k: p[at] @ np.linalg.solve(h[np.ix_(at, at)], p[at]) for k, at in enumerate(units) if k not in found}
        found.append(min(loss, key=loss.get))
        at = units[found[-1]]
        follow = np.linalg.solve(h[np.ix_(at, at)], h[at]).T
        p, h = p - follow @ p[at], h - follow @ h[at]
        h[at, at] += 1e-12
    return found


def reduced(model, rows, counts, label):
    """Without those units of the hidden layers that are missed least: a penalty that grows makes their work nearly vanish first."""
    going = [missed_least(model, rows, hidden, count) for hidden, count in enumerate(counts)]
    at = np.concatenate([outgoing(model, hidden)[k] for hidden in (0, 1) for k in going[hidden]])
    penalty = penalties(model, PENALTY)
    for more in FADING:
        penalty[at] = PENALTY + more
        model = quasi_newton(model, rows, 1, f"{label} fading at {more},", penalty, FADE)
    # the other coefficients follow when the rest of them goes
    p, h = flat(model), inverse(model, rows)
    layers = like(model, p - h[:, at] @ np.linalg.solve(h[np.ix_(at, at)], p[at]))
    for hidden, units in enumerate(going):
        layers[hidden] = np.delete(layers[hidden], units, 1)
        layers[hidden + 1] = np.delete(layers[hidden + 1], 1 + np.array(units), 0)
    return layers


def hops(model, rows, count, seed, quick):
    """Out of one minimum into a lower one: the network grows, descends, and shrinks again; the better of before and after goes on."""
    random = np.random.default_rng(seed)
    grow, settle = (1, 1) if quick else (GROW, SETTLE)
    for k in range(count):
        label, larger = f"hop {k + 1} of {count}:", model
        for hidden, added in enumerate(ADDED):
            larger = enlarged(larger, rows, hidden, added, random)
        larger = quasi_newton(larger, rows, grow, f"{label} larger,", PENALTY)
        again = quasi_newton(reduced(larger, rows, ADDED, label), rows, settle, f"{label} as before,", PENALTY)
        model = min(model, again, key=lambda model: rows.cost(model, PENALTY))
    return model


def start(seed):
    random = np.random.default_rng(seed)
    sizes = (len(FEATURES), *WIDTHS, OUTPUTS)
    layers = []
    for i, (a, b) in enumerate(zip(sizes[:-1], sizes[1:])):
        last = i == len(sizes) - 2
        size = 0.2 if last else 1.5 if i == 0 else 1.0
        bias = (0 if last else 0.5) * random.standard_normal((1, b))
        layers.append(np.vstack([bias, size * random.standard_normal((a, b)) / np.sqrt(a)]))
    return [*layers, np.zeros(len(FRAME))]


def fit(quick, seed, from_stored):
    began = time.time()
    RIGID.update(rigid_slip.fit(WIDEST))
    rigid_slip.report(RIGID, WIDEST)
    train, validation = common.split(common.load("train.csv", "train_fine.csv"))
    own, own_validation = common.own_rows()
    parts = joined(train, common.load("train_slender.csv"), own, sliding_rows()), slope_rows(), fall_rows()
    rows, last_rows = Rows(*parts), Rows(*parts, OWN_LAST, MOMENT_LAST)
    print(f"{rows.count} rows to train on, the last {SLIDING} of them of rigid slip, {len(validation['g'])} to validate; saturation curve within {SATURATION_ERROR:.1e}", flush=True)
    starts, few, kept, more, last, times, end = (3, 1, 2, 1, 1, 1, 1) if quick else (STARTS, FEW, KEPT, MORE, LAST, HOPS, END)

    def report():
        common.report(f"  after {time.time() - began:.0f} s", predict(model, validation), validation)
        common.report("  own rows", predict(model, own_validation), own_validation)
        np.savez(os.environ.get("KSTRIP_FIT_STATE", os.path.join(common.HERE, "total_state.npz")), *model)

    if from_stored:
        model = stored(CONSTANTS)
    else:
        index = np.random.default_rng(5).permutation(rows.count)[: rows.count // PART]
        quarter, penalty = Rows(common.take(rows.data, index)), PENALTY / PART
        models = [levenberg_marquardt(start(seed + k), quarter, few, f"start {k + 1} of {starts}:", penalty, damping=1e-2) for k in range(starts)]
        models = sorted(models, key=lambda model: quarter.cost(model, penalty))[:kept]
        models = [quasi_newton(model, quarter, more, f"{k + 1} of the best {kept}:", penalty) for k, model in enumerate(models)]
        model = min(models, key=lambda model: quarter.cost(model, penalty))
        report()
    model = quasi_newton(model, rows, last, "all rows:", PENALTY)
    report()
    model = hops(model, rows, times, seed, quick)
    report()
    model = quasi_newton(model, last_rows, end, "the end:", PENALTY_LAST)
    report()
    print(f"fitted in {time.time() - began:.0f} s")
    return model


# --- constants -------------------------------------------------------------------------------


def write(model, path):
    header = [
        "Constants of the model TOTAL: rigid slip, and a network of two hidden layers.",
        "",
        "Written by `fit/fit_total.py` from `fit/data/train.csv`, `train_fine.csv` and `train_slender.csv` (computed with CONTACT,",
        "Vollebregt, Vtech CMCC, Apache-2.0) and `boundary_elements.csv`.",
    ]
    first, second, last, _ = model
    common.write_constants(path, header, [
        ("Rigid slip, derivatives of the force: polynomials in s = (g - 1)/(g + 1), powers 0, 2, 4, 1, 3.", "RIGID_SLOPE", RIGID["RIGID_SLOPE"]),
        ("Rigid slip: what spin takes from the force.", "RIGID_SPIN", RIGID["RIGID_SPIN"]),
        ("The part of it that is even in s, powers 0, 2, 4.", "RIGID_SPIN_EVEN", RIGID["RIGID_SPIN_EVEN"]),
        ("Rigid slip: arm of the moment.", "RIGID_ARM", RIGID["RIGID_ARM"]),
        ("The part of it that is even in s.", "RIGID_ARM_EVEN", RIGID["RIGID_ARM_EVEN"]),
        ("Rigid slip: size of the slip in the moment.", "RIGID_SIZE", RIGID["RIGID_SIZE"]),
        ("The part of it that is even in s.", "RIGID_SIZE_EVEN", RIGID["RIGID_SIZE_EVEN"]),
        ("First hidden layer: bias, then a row for each input that depends on the contact only.", "FIXED", first[: 1 + FIXED]),
        ("First hidden layer: a row for each other input.", "FIRST", first[1 + FIXED :]),
        ("Second hidden layer: bias, then a row for each unit of the first.", "SECOND", second),
        ("Corrections: a row for each, over the units of the second hidden layer.", "LAST", last[1:].T),
        ("Corrections: bias.", "LAST_BIAS", last[0]),
        *((doc, name, float(value)) for (name, (doc, _)), value in zip(FRAME.items(), constants_of(model[3]).values())),
    ])  # fmt: skip


def stored(path):
    found = common.read_constants(path)
    return [
        np.vstack([found["FIXED"], found["FIRST"]]),
        found["SECOND"],
        np.vstack([found["LAST_BIAS"], found["LAST"].T]),
        np.log([found[name] / first for name, (_, first) in FRAME.items()]),
    ]


def check_values(model):
    """Inputs and outputs for tests/units/total.rs."""
    cases = np.array([
        (1.0, 0.28, 0.1, 0.0, 0.0), (1.0, 0.28, 0.1, -0.05, 0.2), (1.0, 0.28, -0.3, 0.2, 0.7), (0.1, 0.0, 0.05, 0.3, 0.1), (0.1, 0.5, 0.0, -0.2, 2.0),
        (10.0, 0.28, 0.0, 0.0, 0.09), (10.0, 0.28, 0.05, -0.22, 0.18), (5.0, 0.1, 0.0, 0.1, -0.2), (0.3, 0.4, 3.0, -2.0, 1.0), (2.0, 0.25, 1e-4, 2e-4, -1e-4),
        (0.02, 0.3, 0.2, 0.2, 0.5), (60.0, 0.3, 0.01, 0.02, 0.03), (1.0, 0.5, 0.0, 0.0, 40.0), (20.0, 0.3, 30.0, 90.0, 50.0),
    ])  # fmt: skip
    g, nu, v = cases[:, 0], cases[:, 1], cases[:, 2:]
    forces = predict(model, {"g": g, "nu": nu, "v": v, "c": np.stack(common.coefficients(g, nu), 1)}).tolist()
    print("check values: a/b, nu, (vx, vy, phi) -> fx, fy, mz")
    for (g, nu, *v), force in zip(cases.tolist(), forces):
        print(f"            ({g!r}, {nu!r}, {v!r}, {force!r}),")
    print("saturation polynomial:", ", ".join(repr(float(k)) for k in SATURATION))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--evaluate", nargs="*", default=None)
    parser.add_argument("--from-stored", action="store_true", help="the stages on all rows from the constants in src/total")
    parser.add_argument("--seed", type=int, default=23, help="of the random starts, and of the units added later")
    parser.add_argument("--output", default=CONSTANTS)
    options = parser.parse_args()
    if options.evaluate is None:
        model = fit(options.quick, options.seed, options.from_stored)
        if not options.quick:
            write(model, options.output)
            print("wrote", options.output)
    if options.evaluate is not None or not options.quick:
        model = stored(options.output)  # what the library will use: rounded to single precision
    for label, data in zip(("training", "validation"), common.split(common.load("train.csv", "train_fine.csv"))):
        common.report(label, predict(model, data), data, regions=label == "validation")
    for label, data in zip(("own rows, training", "own rows, validation"), common.own_rows()):
        common.report(label, predict(model, data), data, regions=label.endswith("validation"))
    for path in options.evaluate or []:
        data = common.load(os.path.abspath(path))
        common.report(os.path.basename(path), predict(model, data), data, regions=True)
    check_values(model)


if __name__ == "__main__":
    main()
