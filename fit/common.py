"""Shared by the fits: data, linear coefficients, error report, and the writer of constants files."""

import csv
import os
import re

os.environ.setdefault("XLA_FLAGS", "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1")
os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
DATA = os.path.join(HERE, "data")
SOURCE = os.path.join(HERE, os.pardir, "src")
OWN = "boundary_elements.csv"
COEFFICIENTS = os.path.join(SOURCE, "linear", "constants.rs")

LN16 = float(np.log(16.0))
K = 3 - float(np.log(4.0))


def read(name):
    """Columns of a CSV file in `data/` as float arrays."""
    path = name if os.path.isabs(name) else os.path.join(DATA, name)
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {key: np.array([float(row[key]) for row in rows]) for key in rows[0] if key != "tag"}


# --- constants files -------------------------------------------------------------------------


def number(x):
    """Shortest decimal that is this f32."""
    return np.format_float_positional(np.float32(x), unique=True, trim="0")


def write_constants(path, header, entries):
    """Rust file of f32 constants: `entries` are (doc, NAME, array or number), of two axes at most.

    A number becomes an f64 of which no more is written than a single precision has."""
    lines = [f"//! {line}".rstrip() for line in header] + ["// Generated: change the script, not this file.", ""]
    for doc, name, value in entries:
        value = np.asarray(value, dtype=np.float32)
        lines.append(f"/// {doc}")
        if value.ndim == 0:
            lines.append(f"pub(crate) const {name}: f64 = {number(value)};")
            continue
        kind = "".join(f"; {n}]" for n in value.shape[::-1])
        head = f"pub(crate) const {name}: {'[' * value.ndim}f32{kind} = "
        lines += ["#[rustfmt::skip]", *(listed(value, head, "", ";") if value.ndim == 1 else [head + "[", *rows_of(value), "];"])]
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


def rows_of(table):
    return [line for row in table for line in listed(row, "", "    ", ",")]


def listed(row, head, indent, end, width=100):
    """A list of numbers, on one line if there is room."""
    words = [number(value) for value in row]
    whole = f"{indent}{head}[{', '.join(words)}]{end}"
    if len(whole) <= width:
        return [whole]
    lines = [""]
    for word in words:
        if len(indent) + 4 + len(lines[-1]) + len(word) + 1 > width:
            lines.append("")
        lines[-1] += word + ", "
    return [f"{indent}{head}[", *(f"{indent}    {line.rstrip()}" for line in lines), f"{indent}]{end}"]


def read_constants(path):
    """The f32 arrays and the numbers of a constants file, by name."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    found = {}
    for name, shape, body in re.findall(r"const (\w+): (\[+f32[^=]*\]|f64) = ([^;]*);", text):
        values = [float(x) for x in re.findall(r"-?\d+\.\d*(?:e-?\d+)?", body)]
        sizes = [int(n) for n in re.findall(r"; (\d+)", shape)][::-1]
        found[name] = np.array(values, dtype=np.float32).astype(float).reshape(sizes) if sizes else values[0]
    return found


# --- linear coefficients ---------------------------------------------------------------------

COUPLES = (("E11", "E22"), ("E23", "E33"), ("N23", "N33"))


def couple(k, first, second):
    """Two polynomials side by side: for each power of x both constant parts, then both factors of nu."""
    columns = [np.append(k[name], np.zeros(8 - len(k[name]))).reshape(4, 2) for name in (first, second)]
    return np.stack(columns, 2).reshape(4, 4)


def stored_coefficients():
    found = read_constants(COEFFICIENTS)
    out = {"M33": found["M33"]}
    for first, second in COUPLES:
        out[first], out[second] = (found[f"{first}_{second}"][:, i::2].ravel() for i in (0, 1))
    return out


def polynomial(c, x, nu):
    """Sum over i of (c[2i] + c[2i + 1] nu) x^i."""
    p = 0.0
    for k in range(len(c) - 2, -1, -2):
        p = p * x + (c[k] + c[k + 1] * nu)
    return p


def coefficients(g, nu, constants=None, xp=np):
    """C11, C22, C23, C33 at axis ratio g = a/b: Kalker's slender asymptotes joined by polynomials in 1/(1 + g)."""
    k = constants or stored_coefficients()
    x = 1 / (1 + g)
    t = g * x
    w = x * t  # weight of the fitted part: 0 at both ends
    m = -xp.log(w)  # ln((1 + g)^2/g): ln(b/a) at one end, ln(a/b) at the other
    r = xp.sqrt(1 + g * g)
    y = 1 / (1 + g * g)
    z = g * g * y
    lam = 2 * m + LN16
    n = 1 - nu
    c11 = 2 * np.pi * r / (z * (lam - 2 * nu - K) + y * (8 / np.pi * n) + w * polynomial(k["E11"], x, nu))
    c22 = 2 * np.pi * r / (z * (n * (lam - K) + 2 * nu) + y * (8 / np.pi) + w * polynomial(k["E22"], x, nu))
    e = z * (n * lam - 2 + 4 * nu) + y * (2 * n)
    c23 = 2 * np.pi / 3 * xp.sqrt(g) * r
    c23 = c23 * (z + y * (n + nu * (m + LN16 - 4)) + w * polynomial(k["N23"], x, nu))
    c23 = c23 / (e + w * polynomial(k["E23"], x, nu))
    q = w * m
    c33 = np.pi / 4 * z * ((1 - 2 * nu) * lam - 2 + 6 * nu) + np.pi**2 / 8 * y
    c33 = r / g * (c33 + w * (polynomial(k["N33"], x, nu) + q * polynomial(k["M33"][2:], 0, nu)))
    c33 = c33 / (e + w * (polynomial(k["E33"], x, nu) + q * polynomial(k["M33"][:2], 0, nu)))
    return c11, c22, c23, c33


# --- total forces ----------------------------------------------------------------------------


def load(*names):
    """Rows of total-force files: g, nu, v = (vx, vy, phi), c = C11..C33, f = (fx, fy, mz), err, fine."""
    parts = [read(name) for name in names]

    def column(key):
        return np.concatenate([part[key] for part in parts])

    g, nu = column("a_over_b"), column("nu")
    f = np.stack([column(key) for key in ("fx", "fy", "mz")], 1)
    f[:, :2] /= np.maximum(1, np.hypot(f[:, 0], f[:, 1]))[:, None]  # extrapolation overshoots mu N by .0015 at most
    fine, slender, own = (np.concatenate([np.full(len(part["err"]), word in name) for part, name in zip(parts, names)]) for word in ("fine", "slender", OWN))
    return {
        "g": g,
        "nu": nu,
        "v": np.stack([column(key) for key in ("vx", "vy", "phi")], 1),
        "c": np.stack(coefficients(g, nu), 1),
        "f": f,
        "err": column("err"),
        "fine": fine,
        "slender": slender,
        "own": own,
    }


def take(data, index):
    return {key: value[index] for key, value in data.items()}


def split(data, seed=0, part=0.9):
    """Training and validation rows."""
    order = np.random.default_rng(seed).permutation(len(data["g"]))
    cut = int(part * len(order))
    return take(data, order[:cut]), take(data, order[cut:])


def own_rows():
    """Rows of `boundary_elements.py`: those of nine contacts in ten, and the others, which no fit uses."""
    data = load(OWN)
    held = of_held_contacts(data["g"])
    return take(data, ~held), take(data, held)


def of_held_contacts(g):
    """Every tenth contact of rows in which those of one contact follow each other."""
    contact = np.cumsum(np.diff(g, prepend=0) != 0) - 1
    return contact % 10 == 9


def report(label, p, data, regions=False):
    """Print mean, 95th percentile and maximum of |f - f_ref| and |mz - mz_ref|."""
    d = p - data["f"]
    e, m = np.hypot(d[:, 0], d[:, 1]), abs(d[:, 2])

    def line(name, s):
        print(
            f"{name:24s} n={s.sum():5d} force {e[s].mean():.4f} {np.percentile(e[s], 95):.4f} {e[s].max():.4f}"
            f" | mz {m[s].mean():.4f} {np.percentile(m[s], 95):.4f} {m[s].max():.4f}",
            flush=True,
        )

    line(label, np.ones(len(e), bool))
    if not regions:
        return
    psi = np.pi / 3 * np.sqrt(data["g"]) * abs(data["v"][:, 2])
    u = np.hypot(data["c"][:, 0] * data["v"][:, 0], data["c"][:, 1] * data["v"][:, 1])
    for name, x, edges in (
        ("a/b", data["g"], (0, 0.03, 0.06, 0.15, 0.35, 0.7, 1.5, 3, 7, 12, 20, 40, 61)),
        ("psi", psi, (-1, 1e-9, 0.3, 1, 2, 3.01, 20)),
        ("creep force", u, (-1, 1e-9, 0.3, 1, 2, 3, 20)),
    ):
        for low, high in zip(edges[:-1], edges[1:]):
            s = (x > low) & (x <= high)
            if s.any():
                line(f"  {name} ({max(low, 0):g}, {high:g}]", s)
