"""The model TOTAL as operations on whole arrays of NumPy, JAX, CuPy, PyTorch or any other library with Python's array API standard.

    import jax, jax.numpy as jnp
    from kstrip import arrays
    fx, fy, mz = jax.jit(arrays.total)(a, b, normal_force, shear_modulus, poisson_ratio, friction, longitudinal, lateral, spin)

Such functions run on a GPU, and jax.grad, jax.vmap or torch.autograd differentiate and map them. The results are those of kstrip.solve()
with model="total" to rounding: 1e-13 of friction times load in double precision, 2e-5 in single precision.

What it lacks, and the C library has: checks of the input and statuses; mismatch of the materials; laws of friction and layers; the models
STRIP, STRIP_1967 and LINEAR, strips, fields and patches; and the same bits on every machine. There are no matrix products. By default, a GPU rounds products of matrices in single precision to 10 bits
(TF32). The error would be 1.5e-3 of friction times load.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ._total import (
    BRAKE, E11_E22, E23_E33, END_X, END_Y, FIRST, FIXED, GROWTH, LARGEST_ROOT, LAST, LAST_BIAS, LOSS, M33, N23_N33, ONSET, RATIO_LIMIT, REACH_X,
    REACH_Y, RIGID_ARM, RIGID_ARM_EVEN, RIGID_SIZE, RIGID_SIZE_EVEN, RIGID_SLOPE, RIGID_SPIN, RIGID_SPIN_EVEN, SATURATION_SERIES, SECOND, SEEN_E,
    SEEN_ES, SEEN_S, SEEN_S4, SEEN_U, SEEN_Y, SEEN_YS, SHEAR, TURN,
)

__all__ = ["total"]
#: |q| of full sliding
_FULL = 3.0 * math.pi / 4.0


def _layer(rows: Any) -> list[list[float]]:
    """The weights of a layer: for each unit the bias and the factor of each input."""
    return [list(unit) for unit in zip(*rows)]


_LAYERS = _layer([*FIXED, *FIRST]), _layer(SECOND), [[bias, *row] for bias, row in zip(LAST_BIAS, LAST)]


def total(a: Any, b: Any, normal_force: Any, shear_modulus: Any, poisson_ratio: Any, friction: Any, longitudinal: Any = 0.0, lateral: Any = 0.0,
          spin: Any = 0.0, *, xp: Any = None) -> tuple[Any, Any, Any]:
    """Forces fx, fy [N] and moment mz [N m] on the lower body, as solve() with model="total".

    a, b: semi-axes along and across the rolling direction [m], above 0. normal_force [N], friction [-]: without one of them the forces
    are zero. shear_modulus [Pa], poisson_ratio [-]: combined. longitudinal, lateral [-], spin [1/m]: creepages of the upper body relative to
    the lower body. a must be an array of floating-point numbers; the others are arrays of its precision, or numbers, and all broadcast.
    xp: the library of the arrays, such as jax.numpy; None: the one of a, or NumPy.

    >>> from kstrip import arrays
    >>> fx, fy, mz = arrays.total(np.array([5e-3, 6e-3]), 4.5e-3, 80e3, 82e9, 0.28, 0.3, longitudinal=1e-3, spin=0.1)
    >>> print(1e-3 * fx.round(-2))
    [7.1 8.7]
    """
    xp = _namespace(a) if xp is None else xp
    bound, g, radius = friction * normal_force + 0.0 * a, a / b, xp.sqrt(a * b)
    acts = bound > 0.0
    bound = xp.where(acts, bound, 1.0 + 0.0 * a)
    # vx, vy = G a b (longitudinal, lateral)/(mu N), phi = G (a b)^(3/2) spin/(mu N)
    scale = shear_modulus * (a * b) / bound
    forces = _forces(g, poisson_ratio, longitudinal * scale, lateral * scale, spin * scale * radius, xp)
    fx, fy, mz = (xp.where(acts, bound * force, 0.0 * force) for force in forces)
    return fx, fy, mz * radius


def _namespace(array: Any) -> Any:
    """The library of an array."""
    return array.__array_namespace__() if hasattr(array, "__array_namespace__") else np


def _polynomial(coefficients: Any, x: Any) -> Any:
    """Powers of x, the lowest first."""
    found = coefficients[-1]
    for coefficient in coefficients[-2::-1]:
        found = found * x + coefficient
    return found


def _linear(g: Any, nu: Any, xp: Any) -> tuple[Any, Any, Any, Any]:
    """C11, C22, C23, C33 of the linear theory; src/linear/mod.rs has the formulas."""
    g2, h = g * g, g + 1.0
    m, x, y = xp.log(h * h / g), 1.0 / h, 1.0 / (g2 + 1.0)
    z, w = g2 * y, g * x * x
    r, n, line, ln16, k = xp.sqrt(g2 + 1.0), 1.0 - nu, 1.0 - 2.0 * nu, 4.0 * math.log(2.0), 3.0 - 2.0 * math.log(2.0)
    e0, e1, n0, n1 = M33

    def fitted(table: Any, i: int) -> Any:
        return w * _polynomial([row[i] + row[i + 2] * nu for row in table], x)

    d11 = z * (ln16 - k - 2.0 * nu) + y * n * (8.0 / math.pi) + fitted(E11_E22, 0) + 2.0 * z * m
    d22 = z * (n * (ln16 - k) + 2.0 * nu) + y * (8.0 / math.pi) + fitted(E11_E22, 1) + 2.0 * n * z * m
    e = n * z * ln16 + z * (4.0 * nu - 2.0) + 2.0 * y * n + 2.0 * n * z * m
    n23 = y * n + z + nu * y * (ln16 - 4.0) + fitted(N23_N33, 0) + nu * y * m
    n33 = ((line * ln16 + 6.0 * nu - 2.0) * z * (math.pi / 4.0) + y * (math.pi**2 / 8.0) + fitted(N23_N33, 1)
           + (line * z * (math.pi / 2.0) + w * w * (n0 + n1 * nu)) * m)
    d23, d33 = e + fitted(E23_E33, 0), e + fitted(E23_E33, 1) + w * w * (e0 + e1 * nu) * m
    return 2.0 * math.pi * r / d11, 2.0 * math.pi * r / d22, 2.0 * math.pi / 3.0 * xp.sqrt(g) * r * n23 / d23, r * n33 / (d33 * g)


def _rigid(g: Any, both: Any, vx: Any, vy: Any, phi: Any, xp: Any) -> tuple[Any, Any, Any, Any]:
    """Force and moment of rigid slip, and the share of spin in it; src/total/rigid_slip.rs has the formulas. both: g + 1/g."""
    s = (g - 1.0) / (g + 1.0)
    s2 = s * s

    def pairs(table: Any) -> Any:
        for row in table:
            even, odd = _polynomial(row[:3], s2), s * (row[3] + s2 * row[4])
            yield from (even + odd, even - odd)

    xu, yv, xv, yu, xt, yt = pairs(RIGID_SLOPE)
    k1, k2, k3, k5, k6, k9, k7, k8, k10, k14, k11, k13 = pairs(RIGID_SPIN)
    (au, av), (d1, d2, d3, d5) = pairs(RIGID_ARM), pairs(RIGID_SIZE)
    k0, k4, k12, at, d0, d4 = (_polynomial(row, s2) for row in (*RIGID_SPIN_EVEN, *RIGID_ARM_EVEN, *RIGID_SIZE_EVEN))
    n = vx * vx + vy * vy + phi * phi * both + 1e-12
    u, v, t = vx * vx / n, vy * vy / n, phi * phi * both / n
    u2, uv, v2, w2 = u * u, u * v, v * v, (u + v) * (u + v)
    x, y = (w2 + t * (xu * u + xv * v + xt * t)) * vx, (w2 + t * (yv * v + yu * u + yt * t)) * vy
    z = _polynomial([u2 * (k10 * u2 + k11 * uv + k12 * v2) + v2 * (k13 * uv + k14 * v2), u * (k6 * u2 + k7 * uv) + v * (k8 * uv + k9 * v2),
                     k3 * u2 + k4 * uv + k5 * v2, k0 * t + k1 * u + k2 * v], t) * t
    d = _polynomial([(u + v) * w2, d3 * u2 + d4 * uv + d5 * v2, d0 * t + d1 * u + d2 * v], t)
    size, arm = xp.sqrt(x * x + y * y + n * z + 1e-30), phi * both * (u * au + v * av + t * at)
    return x / size, y / size, arm / xp.sqrt(n * d + 1e-30), t


def _units(layer: list[list[float]], inputs: list[Any]) -> list[Any]:
    """Weighted sums of the inputs, one for each unit."""
    return [sum((weight * x for weight, x in zip(weights, inputs)), bias) for bias, *weights in layer]


def _forces(g: Any, nu: Any, vx: Any, vy: Any, phi: Any, xp: Any) -> tuple[Any, Any, Any]:
    """Force divided by mu N, moment divided by mu N sqrt(a b), for dimensionless creepages; src/total/mod.rs has the formulas."""
    single = xp.finfo(g.dtype).eps > 1e-10
    c11, c22, c23, c33 = _linear(g, nu, xp)
    g = xp.clip(g, 1.0 / RATIO_LIMIT, RATIO_LIMIT)
    root, both = xp.sqrt(g), g + 1.0 / g
    moment = 1.0 / (0.1406 * (both + 0.467))
    # Far beyond full sliding only the direction counts
    largest = 1e4 if single else 1e8
    spin_slope = xp.where(c23 > c33 * xp.sqrt(moment), c23, c33 * xp.sqrt(moment))
    factor = largest / xp.clip(abs(vx) * c11 + abs(vy) * c22 + abs(phi) * spin_slope, largest, None)
    vx, vy, phi = vx * factor, vy * factor, phi * factor
    # The linear force: u^2 of translation, s^2 of spin, m^2 its moment, n^2 their sum
    lx, ly, ls, p2 = c11 * vx, c22 * vy, c23 * phi, phi * phi
    u2, s2, m2 = lx * lx + ly * ly, ls * ls, c33 * c33 * moment * p2
    n2 = u2 + s2 + m2
    rx, ry, rm, kappa = _rigid(g, both, vx, vy, phi, xp)
    # Spin brakes the slopes
    end_x, end_y = c11 * (1.0 / root + END_X * root) * REACH_X, c22 * (root + END_Y / root) * REACH_Y
    ix, iy, im = 1.0 / (end_x * end_x * p2 + 1.0), 1.0 / (end_y * end_y * p2 + 1.0), 1.0 / (m2 + u2 + 1.0)
    ex2 = lx * lx * ix
    e2 = ex2 + ly * ly * iy
    # The network: what depends on the contact, then what depends on the creepages
    shape, lys, fs, fe = xp.clip(root, 1.0 / LARGEST_ROOT, LARGEST_ROOT), ly + ls, 1.0 / (s2 + SEEN_S), 1.0 / (e2 + SEEN_E)
    sl, po = (shape - 1.0) / (shape + 1.0), 4.0 * nu - 1.0
    inputs = [sl, po, sl * sl, sl**3, sl * po, kappa, kappa * sl, g * p2 / (vy * vy + g * p2 + SEEN_Y), fs, 1.0 / (s2 * s2 + SEEN_S4),
              1.0 / (u2 * SEEN_U + 1.0), fs * sl, lys * ls / (lys * lys + s2 + SEEN_YS), fe, ex2 * fe, ly * ls / (e2 + s2 + SEEN_ES), fe * sl,
              fe * kappa, fe * fs, ix, im]
    first, second, last = _LAYERS
    units = [2.0 * x / (1.0 + x * x) for x in _units(first, inputs)]
    units = [2.0 * x / (1.0 + x * x) for x in _units(second, units)]
    w = n2 / (n2 + ONSET)
    *o, o5, o6 = (w * x for x in _units(last, units))
    k1, k2, k3, k4, k6 = (1.0 + x * (2.0 + 1.01 * x) for x in (*o, o6))
    # Slopes of elastic bodies and of sliding ones
    d, pole = 1.0 / (TURN * e2 * e2 + 1.0), (1.0 - kappa) ** 8
    growth = xp.clip(e2 * e2 * e2, None, 1e12 if single else 1e100) * pole * c22 * GROWTH
    elastic = k2 * c22 * xp.sqrt(iy)
    bx = elastic * (1.0 - d) + k2 * k1 * c11 * xp.sqrt(ix) * d + growth
    slope = c23 / (s2 + BRAKE * u2 + 1.0)
    gamma = k3 * slope
    qx, qy = bx * vx, (elastic + growth) * vy + gamma * phi
    q = xp.sqrt(qx * qx + qy * qy + SHEAR * (slope * phi) ** 2 + 1e-30)
    sigma = _polynomial(SATURATION_SERIES, xp.clip(q, None, _FULL)) * _FULL / (xp.clip(q, _FULL, None) * (1.0 + LOSS * kappa * w * k6))
    # Spin's own moment, and how it couples with the lateral force
    epsilon = k4 * xp.sqrt(im) * c33
    epsilon = epsilon / (1.0 + ((epsilon * phi) ** 2 * moment) ** 2 / 16.0)
    coupling = 2.0 * o5 * d / (1.0 + o5 * o5) * xp.sqrt(elastic * epsilon)
    mz = epsilon * phi + sigma * (2.0 * coupling - gamma) * vy
    far = n2 * n2 * (pole / 20.0**4 + 1.0 / 150.0**4)
    near = 1.0 / (1.0 + far)
    return near * sigma * qx + far * near * rx, near * sigma * qy + far * near * ry, near * mz + far * near * rm
