"""Adhesion length and amplitudes of single strips to 25 digits, with mpmath.

Usage: python make_strip.py > strip.csv

The length solves xi_bar^2 + (eta + psi kappa)^2 = kappa^2, the condition alpha^2 + (beta + psi)^2 = 1
(Kalker 1967, 5.40, 5.41). Roots of the polynomial at 60 digits; of two positive ones (|psi| > 1) the
smaller, which continues the only one of |psi| < 1. Inputs are exact doubles.
Columns: xi_bar, eta, psi, kappa/a, alpha, beta + psi, condition (how strongly the inputs' last digits
act on kappa: 1 is harmless, large only where S^2 = eta^2 - (psi^2 - 1) xi_bar^2 is a small difference).
"""

import random

from mpmath import mp, mpf, nstr, sqrt

mp.dps = 60


def solve(x, e, p):
    x, e, p = mpf(x), mpf(e), mpf(p)
    a, b, c = 1 - p * p, -e * p, -(x * x + e * e)
    if a == 0:
        roots = [-c / (2 * b)] if b > 0 else []
    else:
        d = b * b - a * c
        if d < 0:
            return None
        # 60 digits leave more than 25 after any cancellation here
        roots = [(-b + s * sqrt(d)) / a for s in (1, -1)]
    roots = [k for k in roots if k > 0]
    if not roots:
        return None
    k = min(roots)
    s2 = e * e + a * x * x
    condition = (e * e + abs(a) * x * x) / s2 if s2 > 0 else mpf("inf")
    assert abs((x / k) ** 2 + (e / k + p) ** 2 - 1) < mpf(10) ** -25
    return k, x / k, e / k + p, condition


def main():
    rng = random.Random(1967)
    cases = []
    for _ in range(60):
        cases.append((rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)))
    # eta psi -> S: both signs of eta psi, psi towards one from below
    for k in range(1, 17):
        for sign in (1, -1):
            psi = sign * (1 - 10.0**-k)
            cases += [(0.3, -sign * 0.5, psi), (1e-6, -sign * 0.5, psi), (0.3, sign * 0.5, psi), (1e-3, sign * 1e-9, psi)]
    for sign in (1, -1):
        for e in (0.5, 1e-8, 3e-200):
            cases += [(0.25, -sign * e, float(sign)), (0.0, -sign * e, float(sign)), (e, -sign * e, float(sign))]
    # beyond unit spin
    for k in range(1, 16):
        cases += [(0.3, -0.5, 1 + 10.0**-k), (0.01, 0.5, -1 - 10.0**-k), (-0.4, -0.41, 1 + 10.0**-k)]
    cases += [(0.1, -0.5, 2.0), (0.01, 0.5, -3.0), (0.0, -0.3, 5.0)]
    # small and large
    for size in (1e-300, 1e-155, 1e-30, 1e30, 1e90):
        cases += [(size, size / 3, 0.25), (size, -size / 3, 0.875), (-size / 7, size, 0.0)]
    # widely different sizes
    cases += [(1e-12, 0.5, 0.9), (1e-12, -0.5, 0.9), (0.5, 1e-12, 0.9), (0.5, -1e-12, 0.9), (1.0, 0.0, 0.5), (0.0, 1.0, 0.5), (0.0, -1.0, 0.5)]
    print("xi_bar,eta,psi,kappa,alpha,beta_plus_psi,condition")
    for case in cases:
        result = solve(*case)
        if result is None:
            continue
        print(",".join([repr(v) for v in case] + [nstr(v, 25, strip_zeros=False, min_fixed=0, max_fixed=0) for v in result[:3]] + [nstr(result[3], 3)]))


main()
