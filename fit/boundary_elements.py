"""Rows for the fits where CONTACT's rows end, and slopes: steady rolling of an elastic ellipse by boundary elements.

    python3 boundary_elements.py               # write data/boundary_elements.csv (40 minutes)
    python3 boundary_elements.py --slopes      # write data/boundary_slopes.csv (ten minutes)
    python3 boundary_elements.py --check N     # compare every Nth row of the files of CONTACT with this script, write nothing

The problem is Kalker's (1990, Chapter 4): two half-spaces of one material, the pressure of Hertz, Coulomb friction. Tractions are constant in each
cell of a rectangular grid. Units: G = 1, mu N = 1, a b = 1; signs as in `data/README.md`.
"""

import argparse
import csv
import os
import time

import common
import numpy as np

CELLS, CELLS_OF_SLOPES = 1400, 1200  # of the rectangle around the ellipse, on the finer grid
MOTIONS = 24  # of each contact
GROUPS = 4  # motions of like size are solved together
LONG, MIDDLE, WIDE, BALANCED, OPPOSED, FLANGE = 170, 50, 24, 64, 48, 50  # contacts
SLOPES, STATES, STEP = 76, 4, 0.04  # contacts, states of each, and the step of the linear force in their central differences
TOLERANCE, STEPS = 2e-4, 600
NAMES = ("a_over_b", "nu", "vx", "vy", "phi", "fx", "fy", "mz", "stick", "err")


def corners(x, y, nu):
    """Integrals of the displacement by a unit traction over a quadrant that ends at (x, y): xx, yy, xy (times pi)."""
    along, across = x * np.arcsinh(y / abs(x)), y * np.arcsinh(x / abs(y))
    return np.stack([(1 - nu) * along + across, along + (1 - nu) * across, -nu * np.hypot(x, y)])


class Contact:
    """An ellipse of axis ratio g on nx by ny cells. `m`: the slip that tractions take away, -d(displacement)/dx, upwind over one cell."""

    def __init__(self, g, nu, nx, ny):
        a, b = np.sqrt(g), 1 / np.sqrt(g)
        dx, dy = 2 * a / nx, 2 * b / ny
        x, y = np.meshgrid((np.arange(nx) + 0.5) * dx - a, (np.arange(ny) + 0.5) * dy - b, indexing="ij")
        inside = 1 - (x / a) ** 2 - (y / b) ** 2
        i, j = np.nonzero(inside > 0)
        self.x, self.y, self.cell = x[i, j], y[i, j], dx * dy
        self.rigid_at = self.x + dx / 2  # the slip belongs to the way from one cell to the next
        bound = np.sqrt(inside[i, j])
        self.bound = (bound / (bound.sum() * self.cell))[:, None]
        edges = np.meshgrid((np.arange(2 * nx + 1) - nx + 0.5) * dx, (np.arange(2 * ny) - ny + 0.5) * dy, indexing="ij")
        c = corners(*edges, nu)
        displacement = (c[:, 1:, 1:] - c[:, :-1, 1:] - c[:, 1:, :-1] + c[:, :-1, :-1]) / np.pi
        slope = (displacement[:, :-1] - displacement[:, 1:]) / dx
        m = slope[:, i[:, None] - i + nx - 1, j[:, None] - j + ny - 1]
        self.m = np.block([[m[0], m[2]], [m[2], m[1]]])

    def limited(self, q):
        """Nearest tractions within Coulomb's bound."""
        n = len(self.x)
        q = q.reshape(2, n, -1)
        return (q * np.minimum(1, self.bound / np.maximum(np.hypot(q[0], q[1]), 1e-30))).reshape(2 * n, -1)

    def solve(self, v, size):
        """Forces (3, k) and stick fraction (k) of the motions v (3, k), whose slip is about `size`.

        Tractions q with slip w - M q along q where |q| is at its bound, and no slip elsewhere: a monotone problem, because rolling dissipates.
        Douglas and Rachford's splitting (1956; over-relaxed) converges from any start; tau balances tractions and slip.
        """
        n, tau = len(self.x), 0.33 / size
        w = np.concatenate([v[0] - np.outer(self.y, v[2]), v[1] + np.outer(self.rigid_at, v[2])])
        resolvent = np.linalg.inv(np.eye(2 * n) + tau * self.m).astype(np.float32)
        tau_w = (tau * w).astype(np.float32)
        z = np.zeros_like(tau_w)
        for step in range(STEPS):
            q = self.limited(z).astype(np.float32)
            change = resolvent @ (2 * q - z + tau_w) - q
            z += 1.6 * change
            if step % 10 == 9 and abs(change).max() < TOLERANCE:
                break
        else:
            print(f"not converged: {abs(change).max():.1e}", flush=True)
        q = q.reshape(2, n, -1)
        stick = (np.hypot(q[0], q[1]) < self.bound * (1 - 1e-5)).mean(0)
        return np.stack([q[0].sum(0), q[1].sum(0), (self.x[:, None] * q[1] - self.y[:, None] * q[0]).sum(0)]) * self.cell, stick


def extrapolated(g, nu, v, cells=CELLS):
    """Forces, stick fractions and the distance to the finer grid: two grids, extrapolated to zero cell size (first order)."""
    size = np.sqrt(v[0] ** 2 + v[1] ** 2 + v[2] ** 2 * (g + 1 / g) / 5)
    groups = np.array_split(np.argsort(size), min(GROUPS, len(size)))
    f, stick = np.zeros((2, *v.shape)), np.zeros(len(size))
    fine = [max(10, round(np.sqrt(cells) * g**power)) for power in (0.22, -0.22)]
    grids = [[round(2 / 3 * n) for n in fine], fine]
    for k, grid in enumerate(grids):
        contact = Contact(g, nu, *grid)
        for group in groups:
            f[k][:, group], stick[group] = contact.solve(v[:, group], np.exp(np.log(size[group]).mean()))
    h = [1 / grid[0] for grid in grids]
    step = (f[1] - f[0]) * h[1] / (h[0] - h[1])
    return f[1] + step, stick, np.hypot(step[0], step[1])


def motions(g, nu, n, least, r, most=100):
    """Creepages by their linear force (from `least` to `most`) beside spin, creepages that balance the spin somewhere in the contact, and spin alone."""

    def log_uniform(low, high, k=n):
        return np.exp(r.uniform(np.log(low), np.log(high), k))

    c = common.coefficients(g, nu)
    phi = log_uniform(0.02, 5) * 3 / np.pi / np.sqrt(g) * (r.random(n) > 0.08)
    force, angle = log_uniform(least, most), r.uniform(-np.pi / 2, np.pi / 2, n)
    angle = np.where(r.random(n) < 0.15, r.choice([-np.pi / 2, 0, np.pi / 2], n), angle)
    vx, vy = force * np.cos(angle) / c[0], force * np.sin(angle) / c[1]
    balanced = (r.random(n) < 0.45) & (phi > 0)
    vx = np.where(balanced, phi * np.sqrt(g) * r.uniform(0, 1.3, n) * r.choice([0, 0.05, 0.3, 1], n), vx)
    vy = np.where(balanced, phi * np.sqrt(g) * r.uniform(-1.3, 1.3, n), vy)
    alone = (r.random(n) < 0.06) & (phi > 0)
    return np.stack([np.where(alone, 0, vx), np.where(alone, 0, vy), phi])


def opposed(g, nu, n, _, r):
    """A lateral creepage against spin, of .7 to 5 and .6 to 4 in linear force, with little or no longitudinal creepage: the force turns over within the contact."""

    def log_uniform(low, high):
        return np.exp(r.uniform(np.log(low), np.log(high), n))

    c = common.coefficients(g, nu)
    lateral = -log_uniform(0.7, 5)
    return np.stack([lateral * r.choice([0, 0, 0.1, 0.4], n) / c[0], lateral / c[1], log_uniform(0.6, 4) / c[2]])


def moderate(*of):
    """Creepages before full sliding."""
    return motions(*of, most=5)


def contacts(r):
    """Axis ratio, Poisson's ratio, and motions: all forces in slender contacts and in a part of the others, large ones in the rest."""
    for count, low, high, least, of in (
        (LONG, 7, 66, 0.1, motions),
        (MIDDLE, 0.07, 7, 3, motions),
        (WIDE, 0.013, 0.07, 0.1, motions),
        (BALANCED, 1, 12, 0.3, motions),
        (OPPOSED, 0.5, 14, None, opposed),
        (FLANGE, 28, 66, 0.1, moderate),
    ):
        for _ in range(count):
            g, nu = np.exp(r.uniform(np.log(low), np.log(high))), 0.28 if r.random() < 0.6 else r.uniform(0, 0.5)
            yield g, nu, of(g, nu, MOTIONS, least, r)


def write(path):
    r, begin = np.random.default_rng(1), time.time()
    cases = list(contacts(r))
    with open(path, "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(NAMES)
        for k, (g, nu, v) in enumerate(cases):
            f, stick, err = extrapolated(g, nu, v)
            for row in np.vstack([np.full(MOTIONS, g), np.full(MOTIONS, nu), v, f, stick, err]).T:
                out.writerow([f"{x:.5g}" for x in row])
            file.flush()
            print(f"{k + 1} of {len(cases)} contacts, {time.time() - begin:.0f} s", flush=True)


def write_slopes(path):
    """d(fx, fy, mz)/d(vx, vy, phi) at states of partial slip: linear forces of the creepage .15 to 2.5, of the spin to 2.5."""
    r, begin = np.random.default_rng(2), time.time()
    with open(path, "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow([*NAMES[:5], *(f"{f}_{v}" for v in ("vx", "vy", "phi") for f in ("fx", "fy", "mz")), "err"])
        for k in range(SLOPES):
            g, nu = np.exp(r.uniform(np.log(0.1), np.log(10))), 0.28 if r.random() < 0.6 else r.uniform(0, 0.5)
            c = np.array(common.coefficients(g, nu))[:3]
            force = np.exp(r.uniform(np.log(0.15), np.log(2.5), STATES))
            spin = np.exp(r.uniform(np.log(0.05), np.log(2.5), STATES)) * (r.random(STATES) > 0.2)
            angle = r.uniform(-np.pi / 2, np.pi / 2, STATES)
            angle = np.where(r.random(STATES) < 0.2, r.choice([0, np.pi / 2], STATES), angle)
            v = np.stack([force * np.cos(angle), force * np.sin(angle), spin]) / c[:, None]
            moved = v[:, :, None, None] + (STEP / c)[:, None, None, None] * np.eye(3)[:, None, :, None] * np.array([1, -1])
            f, _, err = extrapolated(g, nu, moved.reshape(3, -1), CELLS_OF_SLOPES)
            f = f.reshape(3, STATES, 3, 2)
            slopes = (f[..., 0] - f[..., 1]) / (2 * STEP) * c
            for i in range(STATES):
                out.writerow([f"{x:.5g}" for x in [g, nu, *v[:, i], *slopes[:, i].T.ravel(), err.reshape(STATES, 6)[i].mean()]])
            file.flush()
            print(f"{k + 1} of {SLOPES} contacts, {time.time() - begin:.0f} s", flush=True)


def check(step):
    for name in ("train.csv", "train_fine.csv", "train_slender.csv"):
        data = common.take(common.load(name), slice(None, None, step))
        f = np.stack([extrapolated(g, nu, v[:, None])[0][:, 0] for g, nu, v in zip(data["g"], data["nu"], data["v"])])
        common.report(name, f, data, regions=True)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--check", type=int)
    parser.add_argument("--slopes", action="store_true")
    args = parser.parse_args()
    if args.check:
        check(args.check)
    elif args.slopes:
        write_slopes(os.path.join(common.DATA, "boundary_slopes.csv"))
    else:
        write(os.path.join(common.DATA, "boundary_elements.csv"))
