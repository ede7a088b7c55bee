"""Reference values in 200-bit arithmetic for tests/numbers/numerics.rs: python3 make_numerics.py > numerics.csv

Every input is a number of single precision, so that one reference serves both precisions. Needs mpmath.
Columns: what, region, six inputs, four results as pairs of doubles (sum of the two is good to 106 bits).

kappa    inputs xi_bar, eta, psi                result kappa/a, by the quadratic that both forms of (5.41) solve
hertz    inputs A, B (curvatures), N, G, nu     result axis ratio, major semi-axis, peak pressure, approach
force    inputs xi, eta, psi, nu, a/b           result fx, fy over mu N: strip theory of 1967, sliding by the
                                                rule of the rigid slip
slope    the same inputs                        result d fx/d xi, d fy/d eta, d fx/d eta
"""
import random
import struct
import sys
from mpmath import mp, mpf, sqrt, quad, findroot, ellipk, ellipe, cbrt, pi, diff

mp.prec = 200
random.seed(1967)
FEW = "--few" in sys.argv


def single(x):
    return struct.unpack("f", struct.pack("f", float(x)))[0]


def log_uniform(low, high):
    return single(random.choice([-1, 1]) * low * (high / low) ** random.random())


def pair(x):
    high = float(x)
    return f"{high!r},{float(x - mpf(high))!r}"


def row(what, region, inputs, results):
    inputs = [repr(float(x)) for x in inputs] + ["0"] * (6 - len(inputs))
    results = [pair(x) for x in results] + ["0,0"] * (4 - len(results))
    print(",".join([what, region] + inputs + results))


def kappa(x, e, p):
    # (1 - psi^2) k^2 - 2 eta psi k - (xi_bar^2 + eta^2) = 0, the root that stays finite at |psi| = 1
    x, e, p = mpf(x), mpf(e), mpf(p)
    s2 = e * e + (1 - p) * (1 + p) * x * x
    if s2 < 0:
        return None
    s = sqrt(s2)
    if e * p < 0:
        return (x * x + e * e) / (s - e * p)
    return (s + e * p) / ((1 - p) * (1 + p)) if abs(p) < 1 else None


def rows_of_kappa():
    regions = {
        "ordinary": lambda: (log_uniform(1e-3, 1), log_uniform(1e-3, 1), single(random.uniform(-0.95, 0.95))),
        "psi near 1": lambda: (log_uniform(1e-3, 1), log_uniform(1e-3, 1),
                               single(random.choice([-1, 1]) * (1 - 2 ** -random.uniform(4, 23)))),
        "xi >> eta": lambda: (log_uniform(1e-3, 1), log_uniform(1e-12, 1e-6), single(random.uniform(-0.99, 0.99))),
        "eta >> xi": lambda: (log_uniform(1e-12, 1e-6), log_uniform(1e-3, 1), single(random.uniform(-0.99, 0.99))),
        "tiny": lambda: (log_uniform(1e-18, 1e-12), log_uniform(1e-18, 1e-12), single(random.uniform(-0.99, 0.99))),
        "psi beyond 1": lambda: (log_uniform(1e-3, 1e-1), log_uniform(0.2, 1), single(random.choice([-1, 1]) * random.uniform(1.001, 1.5))),
    }
    for region, draw in regions.items():
        done = 0
        while done < 60:
            x, e, p = draw()
            k = kappa(x, e, p)
            if k is not None and k > 0:
                row("kappa", region, (x, e, p), [k])
                done += 1


def rows_of_hertz():
    regions = {"circle": (0, 0.02), "near circle": (1e-7, 1e-3), "ellipse": (0.1, 3), "needle": (5, 18)}
    for region, (low, high) in regions.items():
        for i in range(20):
            tilt = random.uniform(low, high) if region != "circle" or i else 0
            a = single(random.uniform(0.2, 5))
            b = single(a * mp.exp(tilt))
            n, g, nu = single(80e3 * random.uniform(0.1, 3)), single(82e9 * random.uniform(0.2, 2)), single(random.uniform(0, 0.5))
            small, large = mpf(a), mpf(b)
            es = mpf(g) / (1 - mpf(nu))
            if small == large:
                ratio, k_of, root = mpf(1), pi / 2, pi / 4
            else:
                def curve(u):
                    r = mp.exp(u)
                    m = 1 - r * r
                    kk, ee = ellipk(m), ellipe(m)
                    return mp.log((ee / (r * r) - kk) / (kk - ee)) - mp.log(large / small)
                guess = mp.log(small / large) * mpf(5) / 8
                u = findroot(curve, (guess * mpf("0.9"), guess * mpf("1.1")), tol=mpf(10) ** -100)
                ratio = mp.exp(u)
                m = 1 - ratio * ratio
                kk, ee = ellipk(m), ellipe(m)
                k_of = kk
                # sqrt(AB) = (p0/E*)(s/(l^2 e^2)) sqrt{[(l/s)^2 E - K][K - E]}, p0 = 3N/(2 pi l s)
                root = sqrt((ee / ratio ** 2 - kk) * (kk - ee)) / m
            major = cbrt(3 * mpf(n) / (2 * pi * es) * root / sqrt(small * large))
            p0 = 3 * mpf(n) / (2 * pi * major * major * ratio)
            row("hertz", region, (a, b, n, g, nu), [ratio, major, p0, p0 / es * major * ratio * k_of])


def force(xi, eta, psi, nu, g):
    """fx, fy over mu N by integration over the angle of Y, cut where the law of the strips changes."""
    slope = psi / (g * (1 - nu))

    def law(t):
        y, c = mp.sin(t), mp.cos(t)
        x = xi - slope * y
        k = (sqrt(eta ** 2 + (1 - psi ** 2) * x * x) + eta * psi) / (1 - psi ** 2)
        return y, c, x, k

    def f(t):
        y, c, x, k = law(t)
        if k < c:
            return x * (2 * c - k) * c, (psi * c * c + eta * (2 * c - k)) * c
        w = sqrt(((1 - nu) * x) ** 2 + eta ** 2)
        return (c ** 3 * (1 - nu) * x / w, c ** 3 * eta / w) if w else (mpf(0), mpf(0))

    gap = lambda t: law(t)[3] - law(t)[1]
    cuts = [-pi / 2, pi / 2]
    grid = [-pi / 2 + pi * i / 64 for i in range(65)]
    for l, r in zip(grid, grid[1:]):
        if gap(l) * gap(r) < 0:
            cuts.append(findroot(gap, (l, r), solver="anderson", tol=mpf(10) ** -100))
    if slope and abs(xi) < abs(slope):
        cuts.append(mp.asin(xi / slope))
    cuts = sorted(cuts)
    return [mpf(3) / 4 * quad(lambda t: f(t)[i], cuts) for i in (0, 1)]


def rows_of_force():
    regions = {
        "no spin": lambda: (log_uniform(0.05, 0.8), log_uniform(0.05, 0.8), 0.0),
        "small": lambda: (log_uniform(1e-6, 1e-4), log_uniform(1e-6, 1e-4), single(random.uniform(0.001, 0.01))),
        "combined": lambda: (log_uniform(0.05, 0.5), log_uniform(0.1, 0.5), single(random.uniform(-0.6, 0.6))),
        "sliding": lambda: (log_uniform(1.5, 10), log_uniform(1, 10), single(random.uniform(-0.8, 0.8))),
    }
    for region, draw in regions.items():
        for i in range(3 if FEW else 6):
            values = [*draw(), single(random.uniform(0, 0.5)), single(random.choice([0.5, 1, 2]))]
            exact = [mpf(v) for v in values]
            row("force", region, values, force(*exact))
            # (small creepages turn over a short distance, where differences of a quadrature lose digits)
            if i < 3 and region in ("no spin", "combined"):
                nudge = mpf(2) ** -60

                def slope_of(which, by):
                    ends = []
                    for side in (1, -1):
                        moved = list(exact)
                        moved[by] += side * nudge
                        ends.append(force(*moved)[which])
                    return (ends[0] - ends[1]) / (2 * nudge)

                row("slope", region, values, [slope_of(0, 0), slope_of(1, 1), slope_of(0, 1)])


rows_of_kappa()
rows_of_hertz()
rows_of_force()
