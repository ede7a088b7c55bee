"""Fit how Hertz's contact changes with the ratio of the principal curvatures; print the constants of src/normal/skew.rs and their
errors.

python fit_skew.py     (some seconds)

With the ratio of the principal curvatures e^(2 L) and that of the axes e^K, C = cosh L and c = cosh K: the logarithms of approach and
pressure under a given load, at a given product of the curvatures, and that of (c - 1)/(C - 1), over ln C and ln c. Each is its value
for a circle and x (s + x (a + x b))/(1 + x (d + x e)), s the exact slope for a circle.
"""

import numpy as np
from scipy.optimize import least_squares
from scipy.special import ellipe, ellipkm1

g = np.exp(-np.geomspace(0.02, 8.0, 400))  # minor over major axis
K, E = ellipkm1(g * g), ellipe(1 - g * g)
ratio = (E / g**2 - K) / (K - E)
# (C - 1)/(c - 1) without a difference of ones
root = np.sqrt(ratio)
C, c = (root + 1 / root) / 2, (g + 1 / g) / 2
quotient = (c - 1) / ((1 - 1 / root) ** 2 * root / 2)
# of curvatures 1/root and root: half of the smaller is (p b/a^2)(K - E)/(1 - g^2); load and modulus are 1
share = (K - E) / (1 - g * g)
a = (3 * share * root / np.pi) ** (1 / 3)
pressure = a / (2 * g * share * root)
approach = pressure * g * a * K
circle = 0.75 ** (1 / 3)
start = circle * 2 / np.pi  # pressure; that of the approach is circle times pi/2 times the pressure


def fit(name, x, value, slope):
    def of(f):
        return x * (slope + x * (f[0] + x * f[1])) / (1 + x * (f[2] + x * f[3]))

    best = min((least_squares(lambda f: of(f) - value, np.full(4, s), xtol=1e-15, ftol=1e-15) for s in (0.05, 0.2, 0.5)), key=lambda s: s.cost)
    found = best.x.round(8)
    print(f"{name}: {abs(of(found) - value).max():.1e}\n    [{slope!r}, {', '.join(map(str, map(float, found)))}]")


fit("APPROACH, of ln C", np.log(C), np.log(approach / (start * circle * np.pi / 2)), -1 / 9)
fit("PRESSURE, of ln C", np.log(C), np.log(pressure / start), 2 / 9)
fit("AXES, of ln c", np.log(c), np.log(quotient / (16 / 9)), 1 / 32)
