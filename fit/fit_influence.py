"""Fit what one edge of a strip does to a half-space; print the constants of src/normal/influence.rs and their errors.

python fit_influence.py     (some seconds)

A(t) = integral of sqrt(1 - x^2) arsinh(t/|x|) over -1 < x < 1 and C(t) = 2 k K(k'), each as v (P(v) + w^q Q(v) ln t) with
v = t/(1 + t), w = 1/(1 + t); minimax of the relative error of the value and of a tenth of that of the slope t d/dt.
"""

import numpy as np
from scipy.integrate import quad
from scipy.special import ellipe, ellipkm1

ROUNDS = 600  # each weights the rows with large errors more: least squares becomes nearly minimax
SLOPE = 0.1  # weight of the slope
t = np.geomspace(1e-5, 1e5, 1201)
v, w, log = t / (1 + t), 1 / (1 + t), np.log(t)
rest = 1 / (1 + t * t)
k = t * np.sqrt(rest)


def deflection(t):
    kinks = [x for x in t * 10.0 ** np.arange(-3, 3) if 1e-12 < x < 1]
    return quad(lambda x: 2 * np.sqrt(1 - x * x) * np.arcsinh(t / x), 0, 1, points=kinks or None, limit=2000, epsrel=1e-11)[0]


def columns(plain, with_log, q):
    """Terms of the value, and t d/dt of them."""
    powers = [v ** (i + 1) for i in range(plain)]
    faded = [v ** (i + 1) * w**q for i in range(with_log)]
    slopes = [(i + 1) * w * x for i, x in enumerate(powers)]
    faded_slopes = [((i + 1) * w - q * v) * log * x + x for i, x in enumerate(faded)]
    return np.stack(powers + [x * log for x in faded], 1), np.stack(slopes + faded_slopes, 1)


def fit(name, value, slope, scale, plain, with_log, q):
    values, slopes = columns(plain, with_log, q)
    matrix = np.r_[values / value[:, None], SLOPE * slopes / scale[:, None]]
    wanted = np.r_[np.ones(len(t)), SLOPE * slope / scale]
    weight, best = np.ones(len(wanted)), (np.inf, None)
    for _ in range(ROUNDS):
        found = np.linalg.lstsq(matrix * weight[:, None], wanted * weight, rcond=None)[0]
        error = abs(matrix @ found - wanted)
        if error.max() < best[0]:
            best = (error.max(), found)
        weight *= np.sqrt(1 + error / error.max())
        weight /= weight.mean()
    found = best[1].round(8)
    error = abs(matrix @ found - wanted)
    print(f"{name}: {error[: len(t)].max():.1e} of the value, slope {error[len(t) :].max() / SLOPE:.1e} of it")
    print(f"    {list(map(float, found[:plain]))}\n    {list(map(float, found[plain:]))}")


K, E = ellipkm1(k * k), ellipe(rest)
S = np.where(rest < 1e-4, np.pi / 2 * (1 + 0.375 * rest), 2 * (K - E) / rest)
A, C = np.array([deflection(t) for t in t]), 2 * k * K
fit("DEFLECTION", A, k * S, k * S, 7, 6, 0)
fit("CURVATURE", C, k * rest * S, C, 6, 6, 3)
