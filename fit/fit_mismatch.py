"""Fit of c' between adhesion and slip, what unlike materials add to the longitudinal creepage (`src/contact/mismatch.rs`).

python3 fit_mismatch.py     (half a minute; prints the errors of the stored constants, constants fitted anew, and their errors)

The forces are those of TOTAL's stored constants: unlike minus like, against CONTACT's (`data/kappa.csv`). Rows of ordinary pairs,
|kappa| <= .13 and mu >= .3, count 1.8 times.
"""

import os
import re

import common
import fit_total
import numpy as np
from scipy.optimize import least_squares

rows = common.read("kappa.csv")
g, nu, kappa, mu = (rows[key] for key in ("a_over_b", "nu", "kappa", "mu"))
v = np.stack([rows[key] for key in ("vx", "vy", "phi")], 1)
c = np.stack(common.coefficients(g, nu), 1)
MODEL = fit_total.stored(fit_total.CONSTANTS)
WANTED = np.stack([rows[key] - rows[key + "0"] for key in ("fx", "fy", "mz")], 1)
ORDINARY = (abs(kappa) <= 0.13) & (mu >= 0.3)
ADHESION, SLIP = 16 / np.pi**3 - 0.057 * g / (g + 0.45), 9 / (4 * np.pi)
STRAIN = kappa / mu / (1 + g)
X, Y, SPIN = (c[:, i] * v[:, i] for i in range(3))
PRESSURE = c[:, 0] * ADHESION * STRAIN
NAMES = ("HALF", "PRESSURE", "SPIN", "REAR[0]", "REAR[1]", "SATURATED", "REAR[2]")
FIRST = np.array([4.5, 2.7, 6.7, 1.2, 0.7, 0.3, 2.4])


def predict(v):
    return fit_total.predict(MODEL, {"g": g, "nu": nu, "v": v, "c": c})


LIKE = predict(v)
PLACES = np.linspace(-0.8, 2, 113)
TABLE = np.stack([predict(v - (place * STRAIN)[:, None] * [1, 0, 0]) - LIKE for place in PLACES])


def share(p):
    half, pressure, spin, rear_pressure, rear_creepage, saturated, rear_spin = p
    slip = ((X**2 + Y**2 + (spin * SPIN) ** 2 + (pressure * PRESSURE) ** 2) / half**2) ** 2
    rear = (rear_pressure * PRESSURE - rear_creepage * X) ** 2 + (rear_spin * SPIN) ** 2
    return (ADHESION + SLIP * slip + saturated * rear) / (1 + slip + rear)


def errors(p):
    at = (share(p) - PLACES[0]) / (PLACES[1] - PLACES[0])
    i = np.clip(at, 0, len(PLACES) - 2).astype(int)
    part, n = (at - i)[:, None], np.arange(len(g))
    return TABLE[i, n] * (1 - part) + TABLE[i + 1, n] * part - WANTED


def residuals(p, used, first=FIRST):
    weight = np.where(ORDINARY, 1.8, 1.0)[:, None] * [1, 1, 0.5]
    return np.concatenate([(errors(p) * weight)[used].ravel(), 1e-3 * (p - first)])


def stored():
    """The constants in `src/contact/mismatch.rs`."""
    with open(os.path.join(common.SOURCE, "contact", "mismatch.rs"), encoding="utf-8") as file:
        found = dict(re.findall(r"const (HALF|PRESSURE|SPIN|REAR|SATURATED): [^=]*= ([^;]*);", file.read()))
    rear = [float(x) for x in found["REAR"].strip("[]").split(",")]
    return np.array([*(float(found[name]) for name in NAMES[:3]), *rear[:2], float(found["SATURATED"]), rear[2]])


def figures(e):
    return f"{e.mean():.4f} / {np.percentile(e, 95):.4f} / {e.max():.4f}"


def main():
    def fit(used):
        return least_squares(residuals, FIRST, diff_step=1e-2, args=(used,)).x

    def force(p):
        return np.hypot(*errors(p)[:, :2].T)

    p = stored()
    print(f"stored: force, all {figures(force(p))}, ordinary pairs {figures(force(p)[ORDINARY])}")
    p = fit(np.ones(len(g), bool))
    print(", ".join(f"{name} {value:.3f}" for name, value in zip(NAMES, p)))
    print(f"force, all {figures(force(p))}, ordinary pairs {figures(force(p)[ORDINARY])}")
    fifth, held = np.arange(len(g)) % 5, np.zeros(len(g))
    for k in range(5):
        held[fifth == k] = force(fit(fifth != k))[fifth == k]
    print(f"each fifth held back, all {figures(held)}, ordinary pairs {figures(held[ORDINARY])}")


if __name__ == "__main__":
    main()
