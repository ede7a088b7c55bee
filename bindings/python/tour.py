#!/usr/bin/env python3
"""A tour of kstrip in pictures: creep curves, a traction map, speed against error. Writes target/tour/*.svg.

    make && python bindings/python/tour.py            (needs requirements.txt)

Read it from top to bottom like a notebook: each picture is one function.
"""

import csv
import pathlib
import time
import warnings

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
import kstrip

# Linear theory beyond friction, the theory of 1967 beyond its spin: that is what the pictures show.
warnings.simplefilter("ignore", kstrip.KstripWarning)

# The same file from the same numbers
plt.rcParams.update({"svg.hashsalt": "kstrip", "font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "axes.axisbelow": True})

# A wheel of 0.46 m on a rail head of 0.30 m, 80 kN
RADII = kstrip.radii(lower_y=0.30, upper_x=0.46)
CONTACT, ELLIPSE = kstrip.contact_from_hertz(RADII, kstrip.combine((82e9, 0.28), (82e9, 0.28)), 80e3, 0.3)
BOUND = 0.3 * 80e3


def creep_curves():
    """Force against creepage for every model, and what spin does to the lateral force."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    creepage = np.linspace(0, 0.006, 200)
    for name, label in [("linear", "LINEAR"), ("strip_1967", "STRIP_1967"), ("strip", "STRIP"), ("total", "TOTAL")]:
        forces = kstrip.solve(CONTACT, kstrip.creepage(longitudinal=creepage), model=name)
        left.plot(100 * creepage, forces.fx / 1e3, "--" if name == "linear" else "-", label=label)
    left.set(ylim=(0, 28), xlabel="longitudinal creepage [%]", ylabel="force on the rail [kN]", title="Models, no spin")
    left.axhline(BOUND / 1e3, color="grey", lw=0.8)
    left.text(0.02, BOUND / 1e3 + 0.4, "μ N", color="grey")
    left.legend(loc="lower right")
    lateral = np.linspace(-0.006, 0.006, 400)
    for spin in (0.0, 0.25, 0.5, 1.0):
        forces = kstrip.solve(CONTACT, kstrip.creepage(lateral=lateral, spin=spin))
        right.plot(100 * lateral, forces.fy / 1e3, label=f"spin {spin:g} /m")
    right.set(xlabel="lateral creepage [%]", ylabel="force on the rail [kN]", title="TOTAL, with spin")
    right.legend(loc="lower right")
    return figure


def traction_map():
    """Traction as arrows and colour, the border of stick and slip."""
    motion = kstrip.creepage(longitudinal=3e-4, lateral=0.0, spin=0.6)
    n = 241
    x, y = ELLIPSE.a * np.linspace(-1, 1, n), ELLIPSE.b * np.linspace(-1, 1, n)
    points = kstrip.field(CONTACT, motion, x, y, strips=64)
    size = np.hypot(points.traction_x, points.traction_y) / 1e6
    outside = points.state == kstrip.OUTSIDE
    figure, axes = plt.subplots(figsize=(5.2, 5.0), layout="constrained")
    # x, the rolling direction, points up
    shade = axes.pcolormesh(1e3 * y, 1e3 * x, np.ma.array(size, mask=outside).T, cmap="YlOrBr", shading="nearest", rasterized=True)
    figure.colorbar(shade, label="traction [MPa]")
    stick = np.ma.array(np.where(points.state == kstrip.STICK, 1.0, 0.0), mask=outside)
    axes.contour(1e3 * y, 1e3 * x, stick.T, [0.5], colors="tab:blue", linewidths=1.5)
    k = slice(6, None, 12)
    row, column = np.meshgrid(y[k], x[k], indexing="ij")
    seen = ~outside[k, k]
    axes.quiver(1e3 * row[seen], 1e3 * column[seen], points.traction_y[k, k][seen], points.traction_x[k, k][seen], width=0.003)
    angle = np.linspace(0, 2 * np.pi, 200)
    axes.plot(1e3 * ELLIPSE.b * np.cos(angle), 1e3 * ELLIPSE.a * np.sin(angle), color="black", lw=0.8)
    axes.text(0, 1e3 * float(ELLIPSE.a) * 0.55, "stick", color="tab:blue", ha="center", weight="bold", backgroundcolor="#ffffffb0")
    axes.text(0, -1e3 * float(ELLIPSE.a) * 0.75, "slip", ha="center", weight="bold", backgroundcolor="#ffffffb0")
    axes.set(aspect="equal", xlabel="y [mm]", ylabel="x, rolling direction [mm]",
             title="Traction on the rail\nlongitudinal creepage 0.03 %, spin 0.6 /m")
    axes.grid(False)
    return figure


def reference_cases():
    """The cases of tests/data/open.csv (CONTACT) as contacts with a b = 1, mu N = 1, and their forces."""
    with open(ROOT / "tests" / "data" / "open.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    column = {key: np.array([float(row[key]) for row in rows]) for key in rows[0] if key != "tag"}
    # vx = G a b longitudinal/(mu N) and phi = G (a b)^(3/2) spin/(mu N), with G = a b = mu N = 1
    root = np.sqrt(column["a_over_b"])
    contacts = kstrip.contact(a=root, b=1 / root, normal_force=2.0, shear_modulus=1.0, poisson_ratio=column["nu"], friction=0.5)
    return contacts, kstrip.creepage(column["vx"], column["vy"], column["phi"]), column["fx"], column["fy"]


def speed_error():
    """Mean error against CONTACT over time per contact, batch call, one thread of this machine."""
    contacts, motions, fx, fy = reference_cases()
    figure, axes = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
    for name, counts in [("strip_1967", (16,)), ("strip", (4, 8, 16, 32, 64)), ("total", (16,)), ("linear", (16,))]:
        times, errors = [], []
        for count in counts:
            forces = kstrip.solve(contacts, motions, model=name, strips=count)
            errors.append(np.hypot(forces.fx - fx, forces.fy - fy).mean())
            # Processor time, the shortest of many short rounds: other programs on this machine hardly count.
            rounds = []
            for _ in range(100):
                began = time.process_time_ns()
                kstrip.solve(contacts, motions, model=name, strips=count)
                rounds.append(time.process_time_ns() - began)
            times.append(min(rounds) / contacts.size)
        axes.plot(times, errors, "o-", label=name.upper())
        for count, t, e in zip(counts, times, errors):
            if len(counts) > 1:
                axes.annotate(str(count), (t, e), textcoords="offset points", xytext=(4, 4), fontsize=7)
        print(f"{name:12s} strips {counts}: ns {[round(t) for t in times]}, mean error {[f'{e:.4f}' for e in errors]}")
    axes.set(xscale="log", yscale="log", xlabel="time per contact, batch, one thread [ns]", ylabel="mean force error against CONTACT [μ N]",
             title="Speed against error, 854 cases, |ψ| up to 3 (numbers: strips)")
    axes.grid(which="both", alpha=0.2)
    axes.legend()
    return figure


def main():
    folder = ROOT / "target" / "tour"
    folder.mkdir(parents=True, exist_ok=True)
    for draw in (creep_curves, traction_map, speed_error):
        figure = draw()
        figure.savefig(folder / f"{draw.__name__}.svg", metadata={"Date": None})
        print(f"wrote target/tour/{draw.__name__}.svg")


if __name__ == "__main__":
    main()
