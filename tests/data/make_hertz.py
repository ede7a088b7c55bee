"""Hertz's solution to 25 digits, from the classical formulas in K(e) and E(e), with mpmath.

Usage: python make_hertz.py > hertz.csv

Inputs are exactly representable in double precision; rows with single = 1 also in single precision.
Columns: radii (lower_x, lower_y, upper_x, upper_y), load N, shear modulus G, Poisson's ratio, then
semi-axes a (along x) and b, peak pressure, approach, axis ratio, Hertz's angle.
"""

import struct

from mpmath import mp, mpf, ellipe, ellipk, findroot, inf, pi, quad, sin, sqrt, acos, log, nstr

mp.dps = 60
GOLDEN_CHECK = mpf("0.3")
assert abs(ellipk(GOLDEN_CHECK) - quad(lambda t: 1 / sqrt(1 - GOLDEN_CHECK * sin(t) ** 2), [0, pi / 2])) < mpf(10) ** -40
assert abs(ellipe(GOLDEN_CHECK) - quad(lambda t: sqrt(1 - GOLDEN_CHECK * sin(t) ** 2), [0, pi / 2])) < mpf(10) ** -40


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def curvature_ratio(g):
    """B/A = [(l/s)^2 E - K]/[K - E]"""
    m = 1 - g * g
    k, e = ellipk(m), ellipe(m)
    return (e / g**2 - k) / (k - e)


def axis_ratio(ratio):
    if ratio == 1:
        return mpf(1)
    # ln(B/A) against ln g, by bisection
    low, high = log(mpf(10) ** -8), log(1 - mpf(10) ** -20)
    for _ in range(170):
        middle = (low + high) / 2
        if curvature_ratio(mp.e**middle) > ratio:
            low = middle
        else:
            high = middle
    return mp.e ** ((low + high) / 2)


def solve(radii, load, modulus, poisson):
    lx, ly, ux, uy = (mpf(r) for r in radii)
    inv = lambda r: mpf(0) if r in (inf, -inf) else 1 / r
    cx, cy = (inv(lx) + inv(ux)) / 2, (inv(ly) + inv(uy)) / 2
    small, large = min(cx, cy), max(cx, cy)
    assert small > 0
    g = axis_ratio(large / small)
    e_star = mpf(modulus) / (1 - mpf(poisson))
    if g == 1:
        major = (3 * mpf(load) / (8 * e_star * small)) ** (mpf(1) / 3)  # A = B = 1/(2 R)
        k = pi / 2
    else:
        m = 1 - g * g
        k, e = ellipk(m), ellipe(m)
        # sqrt(AB) = (p0/E*)(s/(l^2 e^2)) sqrt([(l/s)^2 E - K][K - E]),  p0 = 3N/(2 pi l s)
        cube = 3 * mpf(load) / (2 * pi * e_star * m * sqrt(small * large)) * sqrt((e / g**2 - k) * (k - e))
        major = cube ** (mpf(1) / 3)
    minor = g * major
    p0 = 3 * mpf(load) / (2 * pi * major * minor)
    approach = p0 / e_star * minor * k
    a, b = (major, minor) if cx < cy else (minor, major)
    angle = acos(abs(cx - cy) / (cx + cy))
    return a, b, p0, approach, g, angle


def main():
    g_steel, nu_steel = 82e9 - 82e9 % 8192, single(0.28)
    cases = []

    def case(radii, load=80000.0, modulus=g_steel, poisson=nu_steel):
        numbers = [*radii, load, modulus, poisson]
        ok = all(x in (float("inf"),) or single(x) == x for x in numbers)
        cases.append((int(ok), radii, load, modulus, poisson))

    flat = float("inf")
    # axis ratios 1e-4 .. 1, both orientations, plane lower body
    for target in ["1e-4", "2e-4", "5e-4", "1e-3", "3e-3", "0.01", "0.03", "0.1", "0.2", "0.35", "0.5", "0.7", "0.8", "0.9", "0.95", "0.99", "0.999", "0.9999", "0.99999"]:
        ratio = curvature_ratio(mpf(target))
        short = single(0.46)
        long = single(float(short * ratio))
        case((flat, flat, short, long))
        case((flat, flat, long, short))
        case((flat, long, short, flat), load=1.0, modulus=1048576.0, poisson=0.5)
    # the circle and its neighbourhood
    case((flat, flat, 1.0, 1.0))
    case((0.5, 0.5, 0.5, 0.5))
    case((flat, 0.25, 0.25, flat))
    for distance in [2.0**-23, -(2.0**-23), 2.0**-20]:
        case((flat, flat, 1.0, 1.0 + distance))
    for distance in [1.3e-12, -1.3e-12, 1e-15, -1e-15, 1e-13, 1e-10, 1e-9, 1e-8, -1e-8, 1e-7, 1e-6, -1e-5, 1e-4]:
        case((flat, flat, 1.0, 1.0 + distance))
    # wheel on rail, ball in a groove, pipe: concave profiles
    case((flat, single(0.3), single(0.46), flat))
    case((flat, single(0.3), single(0.46), -0.5))
    case((flat, -0.625, 0.5, 0.5))
    case((-0.5, 0.25, 0.25, 0.25))
    case((-1.0, -0.3125, 0.25, 0.25))
    case((2.0, -1.0, -4.0, 0.96875), load=5.0, modulus=3.0e9, poisson=0.125)
    case((-8.0, flat, 7.75, 0.015625), load=1e-3, modulus=65536.0, poisson=0.0)
    print("single,lower_x,lower_y,upper_x,upper_y,normal_force,shear_modulus,poisson_ratio,a,b,peak_pressure,approach,axis_ratio,hertz_angle")
    for ok, radii, load, modulus, poisson in cases:
        inputs = ",".join(repr(float(x)) for x in [*radii, load, modulus, poisson])
        results = ",".join(nstr(x, 25) for x in solve(radii, load, modulus, poisson))
        print(f"{ok},{inputs},{results}")


main()
