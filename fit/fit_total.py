"""Fit the corrections of the model TOTAL; write src/total/constants.rs and print check values for its tests.

python fit_total.py                         the real fit (12 to 15 minutes on one core)
python fit_total.py --quick                 a few iterations only, to see that everything runs (constants not written)
python fit_total.py --evaluate [file.csv]   errors of the stored constants, by region

Levenberg-Marquardt on all residuals of 90 % of the rows of data/train.csv and data/train_fine.csv; the other 10 % are never
trained on and are what "validation" means. Several random starts are followed for a while, the best one to the end.
"""

import argparse
import os
import time

import common
import jax
import jax.numpy as jnp
import numpy as np

jax.config.update("jax_enable_x64", True)

FEATURES, WIDTHS = 18, (20, 16)
OUTPUTS = 6
SIZES = (FEATURES, *WIDTHS, OUTPUTS)
SHAPES = [shape for a, b in zip(SIZES[:-1], SIZES[1:]) for shape in ((a, b), (b,))]
COUNT = sum(int(np.prod(shape)) for shape in SHAPES)
CONSTANTS = os.path.join(common.SOURCE, "total", "constants.rs")
MOMENT = 0.55  # weight of the moment's residual against the force's
# penalty on the square of the coefficients: weak while the way is found, stronger at the end, which takes a few per cent
# of accuracy on the training rows and gives back more on all others, at the edges above all
WEAK, STRONG = 1e-4, 2e-3
BLOCK = 2048


# --- saturation curve ------------------------------------------------------------------------


def saturation_polynomial(terms=9):
    """K(t) in S(d)/d = 1 + t^2 + t^4 + t^5 K(t), t = sqrt(1 - d), for S of (8.15), and its largest error."""
    import mpmath

    mpmath.mp.dps = 40
    nodes = [(1 - mpmath.cos(mpmath.pi * (k + 0.5) / 60)) / 2 for k in range(60)]
    rows, values = [], []
    for t in nodes:
        d = 1 - t * t
        s = 1 - ((2 + d * d) * mpmath.sqrt(1 - d * d) - 3 * d * mpmath.acos(d)) / 2
        rows.append([float(t ** (5 + j)) for j in range(terms)])
        values.append(float(s / d - (1 + t * t + t**4)))
    a, b = np.array(rows), np.array(values)
    k = np.linalg.lstsq(a, b, rcond=None)[0]
    k[-1] += 3 * np.pi / 4 - 3 - k.sum()  # exact slope 3 pi/4 at d = 0: the linear limit
    return k, abs(a @ k - b).max()


SATURATION, SATURATION_ERROR = saturation_polynomial()


def saturation(q2):
    """S(|q|)/|q|."""
    d = jnp.sqrt(q2 + 1e-30) * (4 / (3 * np.pi))
    t2 = jnp.maximum(1 - d, 1e-30)
    t = jnp.sqrt(t2)
    k = 0.0
    for c in SATURATION[::-1]:
        k = k * t + c
    return (1 + t2 + t2 * t2 * (1 + t * k)) / jnp.maximum(d, 1) * (4 / (3 * np.pi))


# --- model -----------------------------------------------------------------------------------


def activation(x):
    return 2 * x / (1 + x * x)


def positive(o):
    """1 at o = 0, never below 1/101."""
    return 1 + o * (2 + 1.01 * o)


def network(p, x):
    k = 0
    for i, (a, b) in enumerate(zip(SIZES[:-1], SIZES[1:])):
        x = x @ p[k : k + a * b].reshape(a, b) + p[k + a * b : k + a * b + b]
        k += a * b + b
        if i < len(SIZES) - 2:
            x = activation(x)
    return x


def within_spin(ls):
    """Factor for creepages and spin: 1 up to |Ls| = 16, and |Ls| to 32 at most. No row of the data is beyond 16."""
    size = jnp.sqrt(ls * ls + 1e-30)
    excess = jnp.maximum(size - 16, 0)
    return jnp.where(size > 16, (16 + excess / (1 + excess / 16)) / size, 1.0)


def total(p, g, nu, v, c):
    """(fx, fy, mz) of one contact: the same formulas, in the same order, as src/total.rs."""
    c11, c22, c23, c33 = c
    vx, vy, phi = v * within_spin(c23 * v[2])
    root = jnp.sqrt(g)
    inverse = root / g
    both = g + 1 / g
    lx, ly, ls = c11 * vx, c22 * vy, c23 * phi
    u2, s2, p2 = lx * lx + ly * ly, ls * ls, phi * phi
    tx = c11 * (inverse + 0.27 * root) / 1.5 * phi
    ty = c22 * (root + 0.27 * inverse) / 1.5 * phi
    tm2 = (c33 * phi) ** 2 / (0.1406 * (both + 0.467))
    dx, dy, dm, du = 1 / jnp.sqrt(1 + tx * tx), 1 / jnp.sqrt(1 + ty * ty), 1 / jnp.sqrt(1 + tm2 + u2), 1 / (1 + 4 * u2)
    n2 = u2 + s2 + tm2
    w = n2 / (0.05 + n2)
    ex, ey = lx * dx, ly * dy
    e2 = ex * ex + ey * ey
    de = 1 / (1 + 0.1 * e2 * e2)
    fe = 1 / (1 + e2)
    kappa = p2 * both / (1e-12 + vx * vx + vy * vy + p2 * both)
    px = 1 / (0.002 + vx * vx + p2 / g)
    py = 1 / (0.002 + vy * vy + p2 * g)
    x = jnp.stack([
        (root - 1) / (root + 1),
        4 * nu - 1,
        2 / (1 + s2) - 1,
        2 / (1 + s2 * s2) - 1,
        2 / (1 + 0.5 * u2) - 1,
        2 * du - 1,
        2 * kappa - 1,
        2 * lx * lx / (0.02 + u2 + s2) - 1,
        2 * vx * vx * px - 1,
        2 * p2 * g * py - 1,
        2 * vy * phi * root * py,
        2 * (ly + ls) * ls / (1 + (ly + ls) ** 2 + s2),
        2 * dx - 1,
        2 * dy - 1,
        2 * dm - 1,
        2 * fe - 1,
        2 * ex * ex * fe - 1,
        2 * ey * ls / (1 + e2 + s2),
    ])  # fmt: skip
    o = w * network(p, x)
    k1, k2, k3, k4, k6 = (positive(o[i]) for i in (0, 1, 2, 3, 5))
    by = c22 * dy
    bx = by * (1 - de) + c11 * dx * k1 * de
    spin = k3 * c23 / (1 + s2 + 0.3 * u2)
    qx, qy = k2 * bx * vx, k2 * by * vy + spin * phi
    sigma = saturation(qx * qx + qy * qy) / (1 + 0.3 * kappa * w * k6)
    epsilon = c33 * k4 * dm
    rho = activation(o[4]) * de
    mz = epsilon * phi + (2 * rho * jnp.sqrt(sigma * k2 * by * epsilon) - sigma * spin) * vy
    return jnp.stack([sigma * qx, sigma * qy, mz])


# --- fit -------------------------------------------------------------------------------------


def weighted_residual(p, g, nu, v, c, f, w):
    return (total(p, g, nu, v, c) - f) * w


ROWS = (0, 0, 0, 0, 0, 0)
RESIDUALS = jax.jit(jax.vmap(weighted_residual, in_axes=(None, *ROWS)))
JACOBIAN = jax.jit(jax.vmap(jax.jacrev(weighted_residual), in_axes=(None, *ROWS)))
PREDICT = jax.jit(jax.vmap(total, in_axes=(None, 0, 0, 0, 0)))


def predict(p, data):
    return np.array(PREDICT(p, data["g"], data["nu"], data["v"], data["c"]))


def row_weights(data):
    """Rows by their own error, with some emphasis on both ends of the axis ratio."""
    w = np.where(data["fine"], 1.0, 0.8) * 0.004 / np.hypot(0.003, 0.5 * np.minimum(data["err"], 0.01))
    return w * np.where((data["g"] > 6) | (data["g"] < 0.13), 1.3, 1.0)


def blocks(data, weight):
    w = weight[:, None] * np.array([1, 1, MOMENT])
    columns = (data["g"], data["nu"], data["v"], data["c"], data["f"], w)
    n = len(weight)
    edges = list(range(0, n - BLOCK + 1, BLOCK)) + ([n - BLOCK] if n % BLOCK else [])
    out = []
    for i, start in enumerate(edges):
        part = [jnp.array(column[start : start + BLOCK]) for column in columns]
        if i and start < edges[i - 1] + BLOCK:  # the last block overlaps its neighbour: count its rows once
            part[5] = part[5] * (np.arange(BLOCK) >= edges[i - 1] + BLOCK - start)[:, None]
        out.append(part)
    return out


def levenberg_marquardt(p, data, weight, iterations, label, damping=1e-2, regularisation=WEAK, tolerance=2e-6):
    parts, n, began = blocks(data, weight), len(weight), time.time()

    def cost(p):
        return (sum(float((RESIDUALS(p, *part) ** 2).sum()) for part in parts) + regularisation * float(p @ p)) / n

    current = cost(p)
    history = [current]
    for step in range(1, iterations + 1):
        h, gradient = regularisation * np.eye(len(p)), regularisation * p
        for part in parts:
            j = np.asarray(JACOBIAN(p, *part)).reshape(-1, len(p))
            r = np.asarray(RESIDUALS(p, *part)).reshape(-1)
            h += j.T @ j
            gradient += j.T @ r
        diagonal = np.diag(h)
        for attempt in range(12):
            trial = p - np.linalg.solve(h + damping * np.diag(diagonal + 1e-6 * diagonal.max()), gradient)
            new = cost(trial)
            if new < current:
                break
            damping *= 4
        else:
            break
        p, current = trial, new
        if attempt == 0:
            damping = max(damping / 3, 1e-9)
        history.append(current)
        if step % 20 == 0:
            spent = time.time() - began
            print(f"  {label} step {step}/{iterations} cost {current:.4g} damping {damping:.0e}, {spent:.0f} s, at most {spent / step * (iterations - step):.0f} s more", flush=True)
        if len(history) > 15 and history[-15] / current - 1 < 15 * tolerance:
            break
    return p, current


def start(seed):
    random, out = np.random.default_rng(seed), []
    for i, (a, b) in enumerate(zip(SIZES[:-1], SIZES[1:])):
        last = i == len(SIZES) - 2
        size = 0.2 if last else 1.5 if i == 0 else 1.0
        out += [(size * random.standard_normal((a, b)) / np.sqrt(a)).ravel(), (0 if last else 0.5) * random.standard_normal(b)]
    return np.concatenate(out)


def fit(quick, starts):
    began = time.time()
    train, validation = common.split(common.load("train.csv", "train_fine.csv"))
    weight = row_weights(train)
    print(f"{COUNT} coefficients, {len(weight)} rows to train on, {len(validation['g'])} to validate; saturation curve within {SATURATION_ERROR:.1e}", flush=True)
    first, second, third, tail = (5, 5, 5, 5) if quick else (60, 40, 250, 40)
    tries = []
    for seed in starts[:1] if quick else starts:
        few = common.take(train, slice(0, 4096))
        p, _ = levenberg_marquardt(start(seed), few, weight[:4096], first, f"start {seed}, few rows:")
        p, value = levenberg_marquardt(p, train, weight, second, f"start {seed}, all rows:")
        print(f"start {seed}: cost {value:.4g} after {time.time() - began:.0f} s", flush=True)
        common.report("  validation", predict(p, validation), validation)
        tries.append((value, seed, p))
    value, seed, p = min(tries, key=lambda t: t[0])
    p, value = levenberg_marquardt(p, train, weight, third, f"best start {seed}:", damping=1e-4)
    save(p)
    common.report("  validation", predict(p, validation), validation)
    for k in range(5):  # more weight on rows that are still far off: the tail counts, not only the mean
        d = (predict(p, train) - train["f"]) * np.array([1, 1, MOMENT])
        more = (1 + (np.sqrt((d * d).sum(1)) / 0.006) ** 2) ** 0.25
        p, value = levenberg_marquardt(p, train, weight * more, tail, f"tail {k + 1}:", damping=1e-3, regularisation=WEAK if k < 2 else STRONG)
        save(p)
    print(f"fitted in {time.time() - began:.0f} s")
    return p, train, validation


def save(p):
    np.save(os.environ.get("KSTRIP_FIT_STATE", os.path.join(common.HERE, "total_state.npy")), p)


# --- constants -------------------------------------------------------------------------------


def layers(p):
    """Per layer: bias in the first row, then one row per input."""
    out, k = [], 0
    for a, b in zip(SIZES[:-1], SIZES[1:]):
        out.append(np.vstack([p[k + a * b : k + a * b + b], p[k : k + a * b].reshape(a, b)]))
        k += a * b + b
    return out


def write(p, path):
    header = [
        "Corrections of the model TOTAL: a network of two hidden layers; and the saturation curve.",
        "",
        "Written by `fit/fit_total.py` from `fit/data/train.csv` and `fit/data/train_fine.csv` (computed with CONTACT,",
        "Vollebregt, Vtech CMCC, Apache-2.0). First row of a layer: bias; then one row per input.",
    ]
    docs = (
        ("First hidden layer.", "HIDDEN_1"),
        ("Second hidden layer.", "HIDDEN_2"),
        ("Corrections.", "OUTPUT"),
    )
    common.write_constants(path, header, [(doc, name, layer) for (doc, name), layer in zip(docs, layers(p))])


def stored(path):
    found = common.read_constants(path)
    parts = []
    for name in ("HIDDEN_1", "HIDDEN_2", "OUTPUT"):
        parts += [found[name][1:].ravel(), found[name][0]]
    return np.concatenate(parts)


def check_values(p):
    """Inputs and outputs for the unit test of src/total.rs."""
    cases = [
        (1.0, 0.28, 0.1, 0.0, 0.0), (1.0, 0.28, 0.1, -0.05, 0.2), (1.0, 0.28, -0.3, 0.2, 0.7), (0.1, 0.0, 0.05, 0.3, 0.1), (0.1, 0.5, 0.0, -0.2, 2.0),
        (10.0, 0.28, 0.0, 0.0, 0.09), (10.0, 0.28, 0.05, -0.22, 0.18), (5.0, 0.1, 0.0, 0.1, -0.2), (0.3, 0.4, 3.0, -2.0, 1.0), (2.0, 0.25, 1e-4, 2e-4, -1e-4),
        (0.02, 0.3, 0.2, 0.2, 0.5), (60.0, 0.3, 0.01, 0.02, 0.03), (1.0, 0.5, 0.0, 0.0, 40.0),
    ]  # fmt: skip
    print("check values: a/b, nu, vx, vy, phi -> fx, fy, mz")
    for g, nu, *v in cases:
        f = np.array(total(p, g, nu, np.array(v), common.coefficients(g, nu)))
        print(f"        ({g!r}, {nu!r}, {v!r}, [{', '.join(repr(float(x)) for x in f)}]),")
    print("saturation polynomial:", ", ".join(repr(float(k)) for k in SATURATION))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--evaluate", nargs="*", default=None)
    parser.add_argument("--resume", help="state file to write constants from, without fitting")
    parser.add_argument("--starts", type=int, nargs="*", default=[0, 1])
    parser.add_argument("--output", default=CONSTANTS)
    options = parser.parse_args()
    if options.evaluate is None:
        if options.resume:
            p = np.load(options.resume)
        else:
            p, _, _ = fit(options.quick, options.starts)
        if not options.quick:
            write(p, options.output)
            print("wrote", options.output)
    if options.evaluate is not None or not options.quick:
        p = stored(options.output)  # what the library will use: rounded to single precision
    train, validation = common.split(common.load("train.csv", "train_fine.csv"))
    common.report("training", predict(p, train), train)
    common.report("validation", predict(p, validation), validation, regions=True)
    for path in options.evaluate or []:
        data = common.load(os.path.abspath(path))
        common.report(os.path.basename(path), predict(p, data), data, regions=True)
    check_values(p)


if __name__ == "__main__":
    main()
