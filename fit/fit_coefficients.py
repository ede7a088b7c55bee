"""Fit the polynomials that join the slender asymptotes of C11, C22, C23, C33; write src/linear/constants.rs.

python fit_coefficients.py     (a minute)
"""

import sys
import time

import numpy as np
from scipy.optimize import least_squares

import common

data = common.read("kalker_coefficients.csv")
g, nu = data["a_over_b"], data["nu"]
ONE = np.ones(len(g))
# what is fitted for each coefficient: how many constants, the penalty on them, and whether slender
# limits are fitted too
PLAN = [
    (0, "c11", {"E11": 8}, 1e-4, False),
    (1, "c22", {"E22": 8}, 1e-4, False),
    (2, "c23", {"E23": 8, "N23": 8}, 1e-4, False),
    (3, "c33", {"E33": 6, "N33": 6, "M33": 4}, 1e-7, True),
]
ROUNDS = 30  # each doubles down on the rows with the largest error: least squares becomes nearly minimax


def unpack(p, sizes):
    """Polynomials with fewer than four pairs begin with a higher power of x: C33 reaches its limit for a >> b sooner."""
    out, k = {name: np.zeros(8) for name in ("E11", "E22", "E23", "N23", "E33", "N33", "M33")}, 0
    for name, n in sizes.items():
        out[name] = p[k : k + n] if name == "M33" else np.append(np.zeros(8 - n), p[k : k + n])
        k += n
    return out


def limits():
    """Slender contacts: axis ratio, Poisson's ratio, C33 there, and the weight.

    For a >> b the asymptote. For a << b what is left of the difference at a/b = 0.1 dies out as (a/b) ln(b/a).
    """
    nus = np.array([0, 0.15, 0.25, 0.28, 0.35, 0.5])
    long, long_nu = (grid.ravel() for grid in np.meshgrid([20, 30, 50, 100, 300, 1e3], nus))
    m = common.LN16 + 2 * np.log(long)
    asymptote = np.pi / 4 * ((1 - 2 * long_nu) * m - 2 + 6 * long_nu) / ((1 - long_nu) * m - 2 + 4 * long_nu)
    wide, wide_nu = (grid.ravel() for grid in np.meshgrid([1e-5, 1e-4, 1e-3, 3e-3, 0.01, 0.02, 0.03, 0.05, 0.07], nus))
    tenth = np.flatnonzero(abs(g - 0.1) < 1e-6)
    tenth = tenth[np.argsort(nu[tenth])]
    left = np.interp(wide_nu, nu[tenth], data["c33"][tenth] * 1.6 / np.pi**2 * (1 - nu[tenth])) - 1
    left = left * wide * np.log(wide) / (0.1 * np.log(0.1))
    limit = np.append(asymptote, np.pi**2 / 16 / (1 - wide_nu) / wide * (1 + left))
    weight = np.append(0.002 * (long / 10) ** 1.2, np.where(wide < 2e-3, 4, 0.5))
    return np.append(long, wide), np.append(long_nu, wide_nu), limit, weight


def fit(index, target, sizes, penalty, slender, start):
    p, w, best = start, ONE, (np.inf, start)
    far, far_nu, limit, weight = limits()
    for _ in range(ROUNDS):

        def residual(p, w=w):
            k = unpack(p, sizes)
            c = common.coefficients(g, nu, k)[index]
            parts = [(c / data[target] - 1) * w, penalty * p]
            if slender:
                parts.append(weight * (common.coefficients(far, far_nu, k)[index] / limit - 1))
            return np.concatenate(parts)

        p = least_squares(residual, p, max_nfev=300).x
        e = abs(residual(p, ONE)[: len(g)])
        if e.max() < best[0]:
            best = (e.max(), p.copy())
        w = w * (1 + 0.5 * (e / e.max()) ** 2)
        w /= w.mean()
    return best


def main():
    began, found = time.time(), {}
    for index, target, sizes, penalty, slender in PLAN:
        n = sum(sizes.values())
        starts = [np.zeros(n)] + [np.random.default_rng(k).normal(size=n) for k in range(1, 3 if target == "c33" else 1)]
        error, p = min((fit(index, target, sizes, penalty, slender, start) for start in starts), key=lambda b: b[0])
        fitted = unpack(p.astype(np.float32).astype(float), sizes)
        found.update({name: fitted[name] for name in sizes})
        e = 100 * (common.coefficients(g, nu, fitted)[index] / data[target] - 1)
        print(f"{target}: {n} constants, max |error| {abs(e).max():.3f} %, below a/b = 5 {abs(e[g < 4.9]).max():.3f} %, {time.time() - began:.0f} s", flush=True)
    wide = np.logspace(-6, 6, 2401)
    for index, name in enumerate(("c11", "c22", "c23", "c33")):
        v = np.array([common.coefficients(wide, n, found)[index] for n in np.linspace(0, 0.5, 21)])
        s = np.diff(np.log(v)) / np.diff(np.log(wide))
        print(f"{name}: smallest value {v.min():.4g} and logarithmic slopes {s.min():.3f} .. {s.max():.3f} for a/b 1e-6 .. 1e6")
    header = [
        "Polynomials in x = 1/(1 + a/b) that join the slender asymptotes of the linear coefficients.",
        "",
        "Written by `fit/fit_coefficients.py` from `fit/data/kalker_coefficients.csv` (computed with CONTACT,",
        "Vollebregt, Vtech CMCC, Apache-2.0). Two polynomials side by side, lowest power of x first: for each power",
        "both constant parts, then both factors of ν.",
    ]
    docs = ("Denominators of C11 and C22.", "Denominators of C23 and C33.", "Numerators of C23 and C33.")
    entries = [(doc, "_".join(names), common.couple(found, *names)) for doc, names in zip(docs, common.COUPLES)]
    entries.append(("Factors of x (1 - x) m in the denominator and in the numerator of C33.", "M33", found["M33"]))
    path = sys.argv[1] if len(sys.argv) > 1 else common.COEFFICIENTS
    common.write_constants(path, header, entries)
    print("wrote", path)


if __name__ == "__main__":
    main()
