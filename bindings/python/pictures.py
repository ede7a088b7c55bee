#!/usr/bin/env python3
"""Writes the pictures of docs/python.md and docs/adhesion.md: the five kinds of kstrip.plot.

    make && python bindings/python/pictures.py [FOLDER]            (needs matplotlib; FOLDER is docs/figures/python otherwise)
"""

import pathlib
import sys
import warnings

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
import kstrip
from kstrip import plot

DATA = ROOT / "tests" / "data"

# The same file from the same numbers, and letters as text
plt.rcParams.update({"svg.hashsalt": "kstrip", "svg.fonttype": "none", "font.family": "sans-serif", "font.size": 9})

RAIL, WHEEL = (kstrip.read_profile(DATA / "wheel_rail" / f"{name}.csv").prepare() for name in ("uic60", "s1002"))
PAIR = kstrip.wheel_pair(wheel_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
CONTACT = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)


def creep_curve():
    return plot.creep_curve(CONTACT, models=("total", "strip", "strip_1967"))


def traction_map():
    return plot.traction_map(CONTACT, kstrip.creepage(3e-4, spin=0.6))


def patch_on_profiles():
    position = kstrip.wheel_position(lateral=-5.2e-3)
    position.vertical = kstrip.height_for_load(RAIL, WHEEL, PAIR, position, 80e3)
    return plot.patch_on_profiles(RAIL, WHEEL, PAIR, position)


def lateral_shift():
    return plot.lateral_shift(RAIL, WHEEL, PAIR, np.linspace(-6e-3, 6e-3, 61), load=50e3, offset=0.75 - 0.7605325)


def measured_curve():
    creepage, force = np.loadtxt(DATA / "eurosprinter_measured.csv", delimiter=",", skiprows=1, usecols=(0, 1)).T
    contact = kstrip.contact(a=6.304e-3, b=12.61e-3, normal_force=106.7e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.33)
    start = kstrip.friction(0.35, 0.5, 0.3, 10.0, slope_factor=0.3)
    fit = kstrip.fit_friction(creepage / 100, force * 106.7e3, contact, start=start, fit=("friction", "ratio", "decay", "slope_factor", "slide_factor"))
    drawn = plot.measured_curve(contact, creepage / 100, force * 106.7e3, {"clean": None, "fitted law": fit.law})
    # What CONTACT computes with a layer and falling friction
    rows = np.loadtxt(DATA / "traction_curves.csv", delimiter=",", skiprows=1, dtype=str)
    places, forces = rows[rows[:, 0] == "contact_layer_falling", 1:].astype(float).T
    axes = drawn.axes[0]
    shown = 100 * places <= creepage.max()
    axes.plot(100 * places[shown], forces[shown] / 106.7e3, color="0.3", linestyle=":", label="CONTACT, layer, falling friction")
    axes.legend(loc="lower right")
    return drawn


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs" / "figures" / "python"
    folder.mkdir(parents=True, exist_ok=True)
    for draw in (creep_curve, traction_map, patch_on_profiles, lateral_shift, measured_curve):
        with warnings.catch_warnings():
            # STRIP_1967 is shown beyond the range that its theory is for.
            warnings.simplefilter("ignore", kstrip.KstripWarning)
            figure = draw()
        figure.savefig(folder / f"{draw.__name__}.svg", metadata={"Date": None, "Creator": None})
        plt.close(figure)
        print(f"wrote {folder / draw.__name__}.svg")


if __name__ == "__main__":
    main()
