"""Fit the corrections of the model TOTAL; write src/total/constants.rs and print check values for its tests.

python fit_total.py                         the real fit (about 15 minutes on one core)
python fit_total.py --quick                 a few iterations only, to see that everything runs (constants not written)
python fit_total.py --evaluate [file.csv]   errors of the stored constants, by region

Levenberg-Marquardt on all residuals of 90 % of the rows of data/train.csv and data/train_fine.csv; the other 10 % are never
trained on and are what "validation" means. A network that is too large is trained first; then unit after unit is taken out,
always the one that is missed least, and what is left is trained to the end.
"""

import argparse
import os
import time

import common
import jax
import jax.numpy as jnp
import numpy as np
import rigid_slip
from scipy.linalg import blas, cho_factor, cho_solve, solve_triangular
from scipy.optimize import minimize

jax.config.update("jax_enable_x64", True)

# what the network is told: first what depends on the contact only, then in the order in which the library has them
FEATURES = [
    "slender", "poisson", "slender2", "slender3", "slender * poisson",
    "kappa", "kappa * slender", "f_y", "f_s", "f_s4", "f_u", "f_s * slender", "f_ys",
    "f_e", "f_ex", "f_es", "f_e * slender", "f_e * kappa", "f_e * f_s", "ix", "im",
]  # fmt: skip
FIXED = 5
START, WIDTHS = (28, 20), (22, 14)  # units of the two hidden layers, before and after those missed least are taken out
OUTPUTS = 6
CONSTANTS = os.path.join(common.SOURCE, "total", "constants.rs")
SCALE = np.array([1, 1, 0.55])  # weight of the moment's residual against the force's
# penalty on the square of the coefficients: weak while the way is found, stronger at the end, which takes a few per cent
# of accuracy on the training rows and gives back more on all others, at the edges above all
WEAK, STRONG = 5e-4, 1e-3
BLOCK = 2048
SHEAR = 0.04
LARGEST_ROOT = 4  # the network does not see that a contact is more slender than a/b = 16 or 1/16; no row of the data is


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
# size of the linear force where half of the answer is that of rigid slip: translation, and spin
TRANSLATION, SPIN = 20.0, 150.0


def frame(g, nu, v, c):
    """Of each contact: what the network is told, and what its corrections work on."""
    c11, c22, c23, c33 = c.T
    vx, vy, phi = v.T
    root = np.sqrt(g)
    inverse, both = root / g, g + 1 / g
    lx, ly, ls = c11 * vx, c22 * vy, c23 * phi
    u2, s2 = lx * lx + ly * ly, ls * ls
    ix = 1 / (1 + (c11 * (inverse + 0.27 * root) / 1.5 * phi) ** 2)
    iy = 1 / (1 + (c22 * (root + 0.27 * inverse) / 1.5 * phi) ** 2)
    moment = 1 / (0.1406 * (both + 0.467))
    tm2 = (c33 * phi) ** 2 * moment
    im = 1 / (1 + tm2 + u2)
    n2 = u2 + s2 + tm2
    w = n2 / (0.05 + n2)
    e2 = lx * lx * ix + ly * ly * iy
    de = 1 / (1 + 0.1 * e2 * e2)
    shape = np.clip(root, 1 / LARGEST_ROOT, LARGEST_ROOT)
    slender, poisson = (shape - 1) / (shape + 1), 4 * nu - 1
    rx, ry, rz, ra, rd, kappa = rigid_slip.parts(RIGID, g, vx, vy, phi)
    force = 1 / np.sqrt(rx * rx + ry * ry + rz + 1e-30)
    pole = (1 - kappa) ** 8
    far = n2 * n2 * (pole / TRANSLATION**4 + 1 / SPIN**4)
    far = far / (1 + far)
    fs, fe, lys, py2 = 1 / (1 + s2), 1 / (1 + e2), ly + ls, phi * phi * g
    features = {
        "slender": slender,
        "poisson": poisson,
        "slender2": slender * slender,
        "slender3": slender * slender * slender,
        "slender * poisson": slender * poisson,
        "kappa": kappa,
        "kappa * slender": kappa * slender,
        "f_y": py2 / (0.002 + vy * vy + py2),
        "f_s": fs,
        "f_s4": 1 / (1 + s2 * s2),
        "f_u": 1 / (1 + 0.5 * u2),
        "f_s * slender": fs * slender,
        "f_ys": lys * ls / (1 + lys * lys + s2),
        "f_e": fe,
        "f_ex": lx * lx * ix * fe,
        "f_es": ly * ls / (1 + e2 + s2),
        "f_e * slender": fe * slender,
        "f_e * kappa": fe * kappa,
        "f_e * f_s": fe * fs,
        "ix": ix,
        "im": im,
    }
    by = c22 * np.sqrt(iy)
    growth = c22 * GROWTH * e2**3 * pole
    places = (w, vx, vy, phi, by * (1 - de), c11 * np.sqrt(ix) * de, by, growth, c23 / (1 + s2 + 0.3 * u2), c33 * np.sqrt(im), kappa, de, moment, 1 - far, far * rx * force, far * ry * force, far * ra / np.sqrt(rd + 1e-30))
    return np.stack([features[name] for name in FEATURES], 1), np.stack(places, 1)


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


def corrected(o, place):
    """(fx, fy, mz) of one contact."""
    w, vx, vy, phi, bx, bx1, by, growth, spin, em, kappa, de, moment, near, rx, ry, rm = place
    o = w * o
    k1, k2, k3, k4, k6 = (positive(o[i]) for i in (0, 1, 2, 3, 5))
    qx, qy = (k2 * (bx + bx1 * k1) + growth) * vx, (k2 * by + growth) * vy + k3 * spin * phi
    q2 = qx * qx + qy * qy + SHEAR * (spin * phi) ** 2
    sigma = saturation(q2) / (1 + 0.3 * kappa * w * k6)
    epsilon = em * k4
    epsilon = epsilon / (1 + (moment * (epsilon * phi) ** 2) ** 2 / 16)
    rho = activation(o[4]) * de
    mz = epsilon * phi + sigma * (2 * rho * jnp.sqrt(k2 * by * epsilon) - k3 * spin) * vy
    return jnp.stack([near * sigma * qx + rx, near * sigma * qy + ry, near * mz + rm])


CORRECTED = jax.jit(jax.vmap(corrected))
SLOPES = jax.jit(jax.vmap(jax.jacfwd(corrected)))


# --- fit -------------------------------------------------------------------------------------


def stored_rigid(path):
    """The closed form of rigid slip as the library has it."""
    found = common.read_constants(path)
    return {name: found[name].reshape(shape) for name, shape in zip(rigid_slip.NAMES, rigid_slip.SHAPES) if name in found}


RIGID = stored_rigid(CONSTANTS)


class Rows:
    def __init__(self, data):
        self.x, self.places = frame(data["g"], data["nu"], data["v"], data["c"])
        self.data, self.count = data, len(data["g"])
        self.weight = row_weights(data)

    def predict(self, layers):
        return np.array(CORRECTED(network(layers, self.x)[0], self.places))

    def residuals(self, layers):
        return (self.predict(layers) - self.data["f"]) * self.weight[:, None] * SCALE


def row_weights(data):
    """Rows by their own error, with emphasis on both ends of the axis ratio."""
    w = np.where(data["fine"], 1.0, 0.8) * 0.004 / np.hypot(0.003, 0.5 * np.minimum(data["err"], 0.01))
    # rows of rigid slip: over the moment of sliding by spin; nearly nothing where elasticity is still to be seen
    w = np.where(data["err"] < 0.1, w, np.where(data["err"] < 0.15, 0.5, 0.03) / np.sqrt(rigid_slip.spin_moment(data["g"])))
    # a little spin beside a creepage: the slope over spin is seen there only
    u, spin = np.hypot(data["c"][:, 0] * data["v"][:, 0], data["c"][:, 1] * data["v"][:, 1]), abs(data["c"][:, 2] * data["v"][:, 2])
    w = w * np.where((u > 0.3) & (u < 4) & (spin < 0.4) & ((spin > 0) | (data["g"] > 5)), np.where(spin < 0.15, 1.8, 1.4), 1.0)
    # spin against a lateral creepage in a long contact: the force turns over within the patch
    opposed = (data["g"] > 3) & (data["c"][:, 1] * data["v"][:, 1] < -0.3) & (spin > 0.3)
    w = w * np.where(opposed, 1.5, 1.0)
    return w * np.where(data["g"] > 6, 1.5, np.where(data["g"] < 0.13, 1.3, 1.0))


def sliding_rows(count=3000, seed=11):
    """Rows of rigid slip. Without spin it is the truth from saturation on, with a little from 6 times saturation; with a large share,
    and the spin's pole in the patch, 10 to 400 times saturation is no more than a hint (`err` .2)."""
    r = np.random.default_rng(seed)
    g, nu = np.exp(r.uniform(np.log(0.05), np.log(20), count)), 0.5 * r.random(count)
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
    return {"g": g, "nu": nu, "v": v, "c": c, "f": rigid_slip.sliding(g, v), "err": err, "fine": np.zeros(count, bool)}


def with_sliding(data):
    rows = sliding_rows()
    return {key: np.concatenate([value, rows[key]]) for key, value in data.items()}


def flat(layers):
    return np.concatenate([layer.ravel() for layer in layers])


def like(layers, p):
    """The coefficients in the shape of `layers`."""
    ends = np.cumsum([layer.size for layer in layers])
    return [part.reshape(layer.shape) for part, layer in zip(np.split(p, ends[:-1]), layers)]


def normal_equations(layers, rows, penalty):
    """J'J and J'r. J in single precision: an outer product per layer of its inputs and of the slopes behind it."""
    p = flat(layers)
    h, gradient = np.zeros((len(p), len(p)), order="F"), penalty * p
    out, h1, s1, h2, s2 = network(layers, rows.x)
    weight = rows.weight[:, None] * SCALE
    residuals = ((np.array(CORRECTED(out, rows.places)) - rows.data["f"]) * weight).astype(np.float32)
    slopes = np.array(SLOPES(out, rows.places)) * weight[:, :, None]
    single = lambda a: a.astype(np.float32)  # noqa: E731
    inputs = [single(np.concatenate([np.ones((rows.count, 1)), a], 1))[:, None, :, None] for a in (rows.x, h1, h2)]
    behind = [None, None, single(slopes)]
    behind[1] = behind[2] @ single(layers[2][1:].T) * single(s2)[:, None]
    behind[0] = behind[1] @ single(layers[1][1:].T) * single(s1)[:, None]
    for start in range(0, rows.count, BLOCK):
        s = slice(start, start + BLOCK)
        r = residuals[s].ravel()
        j = np.concatenate([(a[s] * b[s, :, None]).reshape(len(r), -1) for a, b in zip(inputs, behind)], 1)
        h += blas.ssyrk(1.0, j.T)  # the upper triangle
        gradient = gradient + j.T @ r
    h = np.triu(h) + np.triu(h, 1).T
    h[np.diag_indices(len(p))] += penalty
    return h, gradient


def levenberg_marquardt(layers, rows, iterations, label, damping=1e-3, penalty=WEAK, tolerance=2e-6):
    began = time.time()

    def cost(layers):
        return ((rows.residuals(layers) ** 2).sum() + penalty * (flat(layers) ** 2).sum()) / rows.count

    current = cost(layers)
    history = [current]
    for step in range(1, iterations + 1):
        h, gradient = normal_equations(layers, rows, penalty)
        diagonal = np.diag(h)
        for attempt in range(10):
            try:
                change = cho_solve(cho_factor(h + damping * np.diag(diagonal + 1e-6 * diagonal.max())), gradient)
            except np.linalg.LinAlgError:
                damping *= 4
                continue
            trial = like(layers, flat(layers) - change)
            new = cost(trial)
            if new < current:
                break
            damping *= 4
        else:
            break
        layers, current = trial, new
        if attempt == 0:
            damping = max(damping / 3, 1e-8)
        history.append(current)
        if step % 20 == 0:
            spent = time.time() - began
            print(f"  {label} step {step}/{iterations} cost {current:.4g} damping {damping:.0e}, {spent:.0f} s, at most {spent / step * (iterations - step):.0f} s more", flush=True)
        if len(history) > 15 and history[-15] / current - 1 < 15 * tolerance:
            break
    return layers


def start(seed):
    random = np.random.default_rng(seed)
    sizes = (len(FEATURES), *START, OUTPUTS)
    layers = []
    for i, (a, b) in enumerate(zip(sizes[:-1], sizes[1:])):
        last = i == len(sizes) - 2
        size = 0.2 if last else 1.5 if i == 0 else 1.0
        bias = (0 if last else 0.5) * random.standard_normal((1, b))
        layers.append(np.vstack([bias, size * random.standard_normal((a, b)) / np.sqrt(a)]))
    return layers


def without_one_unit(layers, rows, penalty):
    """Take out the hidden unit that is missed least when all other coefficients make up for it (Hassibi and Stork 1993)."""
    h, _ = normal_equations(layers, rows, penalty)
    inverse = np.linalg.inv(h + 1e-3 * np.diag(np.diag(h)))
    p, best = flat(layers), None
    indices = like(layers, np.arange(len(p)))
    for k in (0, 1):
        for unit in range(layers[k].shape[1] if layers[k].shape[1] > WIDTHS[k] else 0):
            cut = indices[k + 1][1 + unit]
            change = np.linalg.solve(inverse[np.ix_(cut, cut)], p[cut])
            # what it saves: products of pairs in the layers before and after it
            missed = p[cut] @ change / (layers[k].shape[0] + layers[k + 1].shape[1])
            if best is None or missed < best[0]:
                best = missed, k, unit, inverse[:, cut] @ change
    _, k, unit, change = best
    layers = like(layers, p - change)
    layers[k] = np.delete(layers[k], unit, 1)
    layers[k + 1] = np.delete(layers[k + 1], 1 + unit, 0)
    return layers


def widths(layers):
    return layers[0].shape[1], layers[1].shape[1]


def polish(layers, rows, iterations, label, penalty=WEAK):
    """L-BFGS on all coefficients, in coordinates in which the Gauss-Newton matrix of the start is one: a step costs a twentieth of one
    of Levenberg-Marquardt's."""
    began, p, single = time.time(), flat(layers), [jnp.array(rows.x), jnp.array(rows.places), jnp.array(rows.data["f"]), jnp.array(rows.weight[:, None] * SCALE)]
    ends = np.cumsum([layer.size for layer in layers])[:-1]

    @jax.jit
    def cost(p, x, places, f, weight):
        first, second, last = (part.reshape(layer.shape) for part, layer in zip(jnp.split(p, ends), layers))
        h = activation(x @ first[1:] + first[0])
        h = activation(h @ second[1:] + second[0])
        r = (jax.vmap(corrected)(h @ last[1:] + last[0], places) - f) * weight
        return (r * r).sum() + penalty * (p * p).sum()

    h, _ = normal_equations(layers, rows, penalty)
    factor = np.linalg.cholesky(h + 1e-7 * np.diag(np.diag(h) + 1e-6 * np.diag(h).max()))
    slope = jax.jit(jax.value_and_grad(cost))

    def scaled(z):
        value, gradient = slope(p + solve_triangular(factor, z, lower=True, trans="T"), *single)
        return float(value) / 2, solve_triangular(factor, np.array(gradient) / 2, lower=True)

    found = minimize(scaled, np.zeros(len(p)), jac=True, method="L-BFGS-B", options={"maxiter": iterations, "maxfun": 2 * iterations, "maxcor": 40, "ftol": 1e-9, "gtol": 1e-10})
    print(f"  {label} {found.nit} steps, cost {2 * found.fun / rows.count:.4g}, {time.time() - began:.0f} s", flush=True)
    return like(layers, p + solve_triangular(factor, found.x, lower=True, trans="T"))


def fit(quick, seed, start_from=None):
    began = time.time()
    if start_from is None or len(RIGID) < len(rigid_slip.NAMES):
        RIGID.update(rigid_slip.fit())
    rigid_slip.report(RIGID)
    train, validation = common.split(common.load("train.csv", "train_fine.csv"))
    train, validation = Rows(with_sliding(train)), Rows(validation)
    print(f"{train.count} rows to train on, the last 3000 of them of rigid slip, {validation.count} to validate; saturation curve within {SATURATION_ERROR:.1e}", flush=True)
    first, second, wide, between, rounds, steps = (5, 5, 5, 5, 1, 5) if quick else (60, 40, 1000, 150, 12, 300)

    def report():
        common.report(f"  {widths(layers)} after {time.time() - began:.0f} s", validation.predict(layers), validation.data)
        save(layers)

    if start_from is None:
        index = np.random.default_rng(5).permutation(train.count)[:4096]
        few = Rows(common.take(train.data, index))
        layers = levenberg_marquardt(start(seed), few, first, "few rows:", damping=1e-2)
        layers = levenberg_marquardt(layers, train, second, "all rows:")
        layers = polish(layers, train, wide, "all rows:")
        report()
        while widths(layers) != WIDTHS:
            layers = polish(without_one_unit(layers, train, WEAK), train, between, "one unit less:")
            report()
    else:
        layers = start_from
    for k in range(rounds):
        layers = polish(layers, train, steps, f"round {k + 1} of {rounds}:", penalty=STRONG)
        report()
    print(f"fitted in {time.time() - began:.0f} s")
    return layers


def save(layers):
    path = os.environ.get("KSTRIP_FIT_STATE", os.path.join(common.HERE, "total_state.npz"))
    np.savez(path, *layers)


# --- constants -------------------------------------------------------------------------------


def pairs(layer):
    return layer.reshape(len(layer), -1, 2)


def write(layers, path):
    header = [
        "Constants of the model TOTAL: rigid slip, and a network of two hidden layers, its units side by side in pairs.",
        "",
        "Written by `fit/fit_total.py` from `fit/data/train.csv` and `fit/data/train_fine.csv` (computed with CONTACT,",
        "Vollebregt, Vtech CMCC, Apache-2.0).",
    ]
    first, second, last = layers
    common.write_constants(path, header, [
        ("Rigid slip, slopes of the force: polynomials in s = (g - 1)/(g + 1), powers 0, 2, 4, 1, 3.", "RIGID_SLOPE", RIGID["RIGID_SLOPE"]),
        ("Rigid slip: what spin takes from the force.", "RIGID_SPIN", RIGID["RIGID_SPIN"]),
        ("The part of it that is even in s, powers 0, 2, 4.", "RIGID_SPIN_EVEN", RIGID["RIGID_SPIN_EVEN"]),
        ("Rigid slip: arm of the moment.", "RIGID_ARM", RIGID["RIGID_ARM"]),
        ("The part of it that is even in s.", "RIGID_ARM_EVEN", RIGID["RIGID_ARM_EVEN"]),
        ("Rigid slip: size of the slip in the moment.", "RIGID_SIZE", RIGID["RIGID_SIZE"]),
        ("The part of it that is even in s.", "RIGID_SIZE_EVEN", RIGID["RIGID_SIZE_EVEN"]),
        ("First hidden layer: bias, then a row for each input that depends on the contact only.", "FIXED", pairs(first[: 1 + FIXED])),
        ("First hidden layer: a row for each other input.", "FIRST", pairs(first[1 + FIXED :])),
        ("Second hidden layer: bias, then a row for each unit of the first.", "SECOND", pairs(second)),
        ("Corrections: a row for each, over the units of the second hidden layer.", "LAST", pairs(last[1:].T)),
        ("Corrections: bias.", "LAST_BIAS", last[0]),
    ])  # fmt: skip


def stored(path):
    found = common.read_constants(path)
    single = {name: found[name].reshape(len(found[name]), -1) for name in ("FIXED", "FIRST", "SECOND", "LAST")}
    return [
        np.vstack([single["FIXED"], single["FIRST"]]),
        single["SECOND"],
        np.vstack([found["LAST_BIAS"], single["LAST"].T]),
    ]


def check_values(layers):
    """Inputs and outputs for tests/units/total.rs."""
    cases = np.array([
        (1.0, 0.28, 0.1, 0.0, 0.0), (1.0, 0.28, 0.1, -0.05, 0.2), (1.0, 0.28, -0.3, 0.2, 0.7), (0.1, 0.0, 0.05, 0.3, 0.1), (0.1, 0.5, 0.0, -0.2, 2.0),
        (10.0, 0.28, 0.0, 0.0, 0.09), (10.0, 0.28, 0.05, -0.22, 0.18), (5.0, 0.1, 0.0, 0.1, -0.2), (0.3, 0.4, 3.0, -2.0, 1.0), (2.0, 0.25, 1e-4, 2e-4, -1e-4),
        (0.02, 0.3, 0.2, 0.2, 0.5), (60.0, 0.3, 0.01, 0.02, 0.03), (1.0, 0.5, 0.0, 0.0, 40.0), (20.0, 0.3, 30.0, 90.0, 50.0),
    ])  # fmt: skip
    g, nu, v = cases[:, 0], cases[:, 1], cases[:, 2:]
    x, places = frame(g, nu, v, np.stack(common.coefficients(g, nu), 1))
    forces = np.array(CORRECTED(network(layers, x)[0], places)).tolist()
    print("check values: a/b, nu, (vx, vy, phi) -> fx, fy, mz")
    for (g, nu, *v), force in zip(cases.tolist(), forces):
        print(f"            ({g!r}, {nu!r}, {v!r}, {force!r}),")
    print("saturation polynomial:", ", ".join(repr(float(k)) for k in SATURATION))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--evaluate", nargs="*", default=None)
    parser.add_argument("--resume", help="state file to go on from with the last stage")
    parser.add_argument("--seed", type=int, default=1, help="of the random start")
    parser.add_argument("--output", default=CONSTANTS)
    options = parser.parse_args()
    rows = common.split(common.load("train.csv", "train_fine.csv"))
    if options.evaluate is None:
        layers = None
        if options.resume:
            with np.load(options.resume) as state:
                layers = [state[name] for name in sorted(state.files)]
        layers = fit(options.quick, options.seed, layers)
        if not options.quick:
            write(layers, options.output)
            print("wrote", options.output)
    if options.evaluate is not None or not options.quick:
        layers = stored(options.output)  # what the library will use: rounded to single precision
    for label, data in zip(("training", "validation"), rows):
        common.report(label, Rows(data).predict(layers), data, regions=label == "validation")
    for path in options.evaluate or []:
        data = common.load(os.path.abspath(path))
        common.report(os.path.basename(path), Rows(data).predict(layers), data, regions=True)
    check_values(layers)


if __name__ == "__main__":
    main()
