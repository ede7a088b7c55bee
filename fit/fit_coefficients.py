"""Fit the polynomials that join the slender asymptotes of C11, C22, C23, C33; write src/coefficients/constants.rs.

python fit_coefficients.py     (about a minute)
"""

import sys
import time

import numpy as np
from scipy.optimize import least_squares

import common

data = common.read("kalker_coefficients.csv")
g, nu = data["a_over_b"], data["nu"]
ONE = np.ones(len(g))
# what is fitted for each coefficient, and the weight of its rows: C33 is known to about 1 % for a/b >= 5 and to .3 % below
PLAN = [
    (0, "c11", {"E11": 8}, ONE),
    (1, "c22", {"E22": 8}, ONE),
    (2, "c23", {"E23": 8, "N23": 8}, ONE),
    (3, "c33", {"E33": 6, "N33": 6, "M33": 4}, np.where(g > 9, 0.2, np.where(g > 4, 0.5, 1.0))),
]
REGULARISATION = 1e-4
ROUNDS = 30  # each doubles down on the rows with the largest error: least squares becomes nearly minimax


def unpack(p, sizes):
    out, k = {name: np.zeros(8) for name in ("E11", "E22", "E23", "N23", "E33", "N33", "M33")}, 0
    for name, n in sizes.items():
        out[name] = p[k : k + n]
        k += n
    return out


def fit(index, target, sizes, weight, start):
    p, w, best = start, weight.copy(), (np.inf, start)
    for _ in range(ROUNDS):

        def residual(p, w=w):
            c = common.coefficients(g, nu, unpack(p, sizes))[index]
            return np.r_[(c / data[target] - 1) * w, REGULARISATION * p]

        p = least_squares(residual, p, max_nfev=300).x
        e = abs(residual(p, weight)[: len(g)])
        if e.max() < best[0]:
            best = (e.max(), p.copy())
        w = w * (1 + 0.5 * (e / e.max()) ** 2)
        w *= weight.mean() / w.mean()
    return best


def main():
    began, found = time.time(), {}
    for index, target, sizes, weight in PLAN:
        n = sum(sizes.values())
        starts = [np.zeros(n)] + [np.random.default_rng(k).normal(size=n) for k in range(1, 4 if target == "c33" else 1)]
        error, p = min((fit(index, target, sizes, weight, start) for start in starts), key=lambda b: b[0])
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
        "the pair of constant parts, then the pair of factors of ν.",
    ]
    docs = ("Denominators of C11 and C22.", "Denominators of C23 and C33.", "Numerators of C23 and C33.")
    entries = [(doc, "_".join(names), common.couple(found, *names)) for doc, names in zip(docs, common.COUPLES)]
    entries.append(("Factors of (1 - x) m in the denominator and in the numerator of C33.", "M33", found["M33"]))
    path = sys.argv[1] if len(sys.argv) > 1 else common.COEFFICIENTS
    common.write_constants(path, header, entries)
    print("wrote", path)


if __name__ == "__main__":
    main()
