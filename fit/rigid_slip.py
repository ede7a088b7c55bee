"""Force and moment of a patch that slides as a whole: quadrature, and a closed form fitted to it. Imported by fit_total.py.

python rigid_slip.py    fit the closed form (half a minute) and print its errors

With N = vx^2 + vy^2 + phi^2 (g + 1/g), U = vx^2/N, V = vy^2/N and T = phi^2 (g + 1/g)/N, so that U + V + T = 1:
  F = (bx vx, by vy)/sqrt((bx vx)^2 + (by vy)^2 + N Z),   M = phi (g + 1/g) A/sqrt(N D),
bx, by of degree 2, Z of degree 5 (zero without spin), A of degree 1, D of degree 3, all positive. Their coefficients are polynomials in
s = (g - 1)/(g + 1), which changes its sign with x <-> y.
"""

import numpy as np
from scipy.optimize import least_squares

# powers of T, U, V. Of each pair the other is found with U <-> V and s -> -s; the others are even
# in s.
SLOPE = ((1, 1, 0), (1, 0, 1), (2, 0, 0))
SPIN, SPIN_EVEN = ((4, 1, 0), (3, 2, 0), (2, 3, 0), (2, 2, 1), (1, 4, 0), (1, 3, 1)), ((5, 0, 0), (3, 1, 1), (1, 2, 2))
SIZE, SIZE_EVEN = ((2, 1, 0), (1, 2, 0)), ((3, 0, 0), (1, 1, 1))
NAMES = ("RIGID_SLOPE", "RIGID_SPIN", "RIGID_SPIN_EVEN", "RIGID_ARM", "RIGID_ARM_EVEN", "RIGID_SIZE", "RIGID_SIZE_EVEN")
SHAPES = ((len(SLOPE), 5), (len(SPIN), 5), (len(SPIN_EVEN), 3), (1, 5), (1, 3), (len(SIZE), 5), (len(SIZE_EVEN), 3))
FORCE = 3  # arrays of the force; the others are of the moment


def sliding(g, v, radii=64, angles=128):
    """fx, fy, mz of rigid slip by quadrature: midpoints in the share of the load within a radius, equal angles."""
    share, turn = (np.arange(radii) + 0.5) / radii, 2 * np.pi * (np.arange(angles) + 0.5) / angles
    radius = np.sqrt(1 - (1 - share) ** (2 / 3))
    x0, y0 = (radius[:, None] * np.cos(turn)).ravel(), (radius[:, None] * np.sin(turn)).ravel()
    found = []
    for k in range(0, len(g), 256):
        root = np.sqrt(g[k : k + 256, None])
        x, y = x0 * root, y0 / root
        vx, vy, phi = v[k : k + 256].T[:, :, None]
        sx, sy = vx - phi * y, vy + phi * x
        s = np.hypot(sx, sy) + 1e-12
        found.append(np.stack([(sx / s).mean(1), (sy / s).mean(1), ((x * sy - y * sx) / s).mean(1)], 1))
    return np.concatenate(found)


def spin_moment(g):
    """Moment of sliding by spin alone, within half a per cent."""
    return np.sqrt(0.1406 * (g + 1 / g + 0.467))


def even(c, s2):
    return c[0] + s2 * (c[1] + s2 * c[2])


def pair(c, s):
    """A polynomial at s and at -s."""
    e, o = even(c, s * s), s * (c[3] + s * s * c[4])
    return e + o, e - o


def polynomial(pairs, evens, c_pairs, c_evens, s, t, u, v):
    total = 0
    for (i, j, k), c in zip(pairs, c_pairs):
        a, b = pair(c, s)
        total = total + t**i * (a * u**j * v**k + b * u**k * v**j)
    for (i, j, k), c in zip(evens, c_evens):
        total = total + t**i * u**j * v**k * even(c, s * s)
    return total


def slopes(k, s, t, u, v):
    """bx and by."""
    (au, bu), (av, bv), (at, bt) = (pair(c, s) for c in k["RIGID_SLOPE"])
    w = u + v
    return w * w + t * (u * au + v * av + t * at), w * w + t * (v * bu + u * bv + t * bt)


def spin(k, s, t, u, v):
    """Z."""
    return polynomial(SPIN, SPIN_EVEN, k["RIGID_SPIN"], k["RIGID_SPIN_EVEN"], s, t, u, v)


def moment(k, s, t, u, v):
    """A and D."""
    a, b = pair(k["RIGID_ARM"][0], s)
    size = (u + v) ** 3 + polynomial(SIZE, SIZE_EVEN, k["RIGID_SIZE"], k["RIGID_SIZE_EVEN"], s, t, u, v)
    return u * a + v * b + t * even(k["RIGID_ARM_EVEN"][0], s * s), size


def parts(k, g, vx, vy, phi):
    """bx vx, by vy, N Z, phi (g + 1/g) A, N D, and the share of spin T."""
    both = g + 1 / g
    n = 1e-12 + vx * vx + vy * vy + phi * phi * both
    s, u, v, t = (g - 1) / (g + 1), vx * vx / n, vy * vy / n, phi * phi * both / n
    bx, by = slopes(k, s, t, u, v)
    arm, size = moment(k, s, t, u, v)
    return bx * vx, by * vy, n * spin(k, s, t, u, v), phi * both * arm, n * size, t


def totals(k, g, v):
    """fx, fy, mz of the closed form."""
    x, y, z, arm, size, _ = parts(k, g, *v.T)
    f = 1 / np.sqrt(x * x + y * y + np.maximum(z, 0) + 1e-30)
    return np.stack([x * f, y * f, arm / np.sqrt(np.maximum(size, 0) + 1e-30)], 1)


def cases(count, seed, widest):
    """Axis ratios to `widest` both ways; pole of the spin from the centre to far outside, one case in five on an axis."""
    r = np.random.default_rng(seed)
    g = np.exp(r.uniform(-np.log(widest), np.log(widest), count))
    far = 10 ** r.uniform(-1.6, 1.6, count) * np.where(r.random(count) < 0.5, 1, 0.5 * np.sqrt(g + 1 / g))
    angle = r.uniform(0, np.pi / 2, count)
    angle[: count // 10], angle[count // 10 : count // 5] = 0, np.pi / 2
    return g, np.stack([far * np.cos(angle), far * np.sin(angle), np.ones(count)], 1)


def everywhere(count, seed):
    """Places s, T, U, V, needles included, where the polynomials must be positive."""
    r = np.random.default_rng(seed)
    s = np.where(r.random(count) < 0.3, r.choice([-1, 1], count) * (1 - 10 ** r.uniform(-4, -1, count)), r.uniform(-1, 1, count))
    far, angle = 10 ** r.uniform(-4, 4, count), r.uniform(0, np.pi / 2, count)
    angle[: count // 4], angle[count // 4 : count // 2] = 0, np.pi / 2
    w = far / (1 + far)
    return s, 1 - w, w * np.cos(angle) ** 2, w * np.sin(angle) ** 2


def like(p, names, shapes):
    ends = np.cumsum([a * b for a, b in shapes])
    return {name: part.reshape(shape) for name, shape, part in zip(names, shapes, np.split(p, ends[:-1]))}


def fit(widest):
    """The constants by name, as the library stores them, for axis ratios to `widest` both ways."""
    g, v = cases(6000, 1, widest)
    f, most, places = sliding(g, v, 96, 128), spin_moment(g), everywhere(5000, 5)

    def force_residuals(p):
        k = like(p, NAMES[:FORCE], SHAPES[:FORCE])
        x, y, z, *_ = parts({**k, **no_moment}, g, *v.T)
        size = 1 / np.sqrt(x * x + y * y + np.maximum(z, 1e-9))
        s, t, u, w = places
        least = 0.01 * t * ((u + w) ** 4 + 0.05 * t**4)
        short = [2.0 * np.minimum(spin(k, *places) / least - 1.5, 0), *(np.minimum(b - 0.02, 0) for b in slopes(k, *places))]
        return np.concatenate([weight * (x * size - f[:, 0]), weight * (y * size - f[:, 1]), *short, 3e-4 * p])

    def moment_residuals(p):
        k = like(p, NAMES[FORCE:], SHAPES[FORCE:])
        *_, arm, size, _ = parts({**no_force, **k}, g, *v.T)
        short = [10 * np.minimum(x - 0.01, 0) for x in moment(k, *places)]
        return np.concatenate([weight * (arm / np.sqrt(np.maximum(size, 1e-9)) - f[:, 2]) / most, *short, 3e-4 * p])

    zero = {name: np.zeros(shape) for name, shape in zip(NAMES, SHAPES)}
    no_force, no_moment = ({name: zero[name] for name in part} for part in (NAMES[:FORCE], NAMES[FORCE:]))
    start = {name: value.copy() for name, value in zero.items()}
    for name, first in zip(NAMES, ((1, 1, 0.4), 0.3, 0.2, 0.3, 0.15, 0.5, (0.1, 0.5))):
        start[name][:, 0] = first
    found, count = {}, len(g)
    for residuals, names, shapes in ((force_residuals, NAMES[:FORCE], SHAPES[:FORCE]), (moment_residuals, NAMES[FORCE:], SHAPES[FORCE:])):
        p, weight = np.concatenate([start[name].ravel() for name in names]), np.ones(count)
        for _ in range(3):  # more weight on what is far off
            p = least_squares(residuals, p, max_nfev=40).x
            errors = residuals(p)[: 2 * count if names[0] == "RIGID_SLOPE" else count].reshape(-1, count) / weight
            weight = np.sqrt(1 + (errors**2).sum(0) / 0.015**2)
        found |= like(p, names, shapes)
    return {name: np.float32(value).astype(float) for name, value in found.items()}


def report(k, widest):
    g, v = cases(4000, 2, widest)
    d = totals(k, g, v) - sliding(g, v, 96, 192)
    for name, e in (("force", np.hypot(d[:, 0], d[:, 1])), ("moment over that of spin", abs(d[:, 2]) / spin_moment(g))):
        print(f"rigid slip, {name}: {e.mean():.4f} / {np.percentile(e, 95):.4f} / {e.max():.4f}")
    places = everywhere(10**6, 9)
    least = [(spin(k, *places) / places[1]).min(), *(b.min() for b in slopes(k, *places)), *(x.min() for x in moment(k, *places))]
    print("least Z/T, bx, by, A, D:", " ".join(f"{x:.4f}" for x in least))


if __name__ == "__main__":
    report(fit(70), 70)
