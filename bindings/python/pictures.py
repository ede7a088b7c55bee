#!/usr/bin/env python3
"""Writes the pictures of docs/reference/python.md and docs/guide/7-adhesion.md, the kinds of kstrip.plot; and the runs of two examples in C.

    make && python bindings/python/pictures.py [FOLDER]            (needs matplotlib; FOLDER is docs/figures/python otherwise)
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
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
WHEELSET, TRACK = kstrip.Wheelset(WHEEL, PAIR, back_to_back=1.36), kstrip.Track(RAIL, gauge=1.435)
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
    return plot.lateral_shift(WHEELSET, TRACK, np.linspace(-6e-3, 6e-3, 61), load=50e3)


def wheelset():
    position = kstrip.wheel_position(lateral=5e-3, yaw=2e-3)
    still = kstrip.wheelset_settle(WHEELSET, TRACK, position, kstrip.wheel_velocity(forward=20.0, pitch=0.0), 100e3)
    return plot.wheelset(kstrip.wheelset_on_track(WHEELSET, TRACK, still.position, still.velocity))


def wear():
    shifts = 5e-3 * np.sin(np.linspace(0.0, 2 * np.pi, 200, endpoint=False))
    rolling = kstrip.wheel_velocity(forward=20.0, pitch=0.0)
    still = kstrip.wheelset_settle(WHEELSET, TRACK, kstrip.wheel_position(lateral=shifts, yaw=1e-3), rolling, 100e3)
    return plot.wear(kstrip.wheelset_on_track(WHEELSET, TRACK, still.position, still.velocity))


def conicity():
    return plot.conicity(WHEELSET, TRACK)


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


def of_page(page):
    """The picture of a page, by the program of that page."""
    program = re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "cookbook" / page).read_text(encoding="utf-8"), re.S)[0]
    names = {}
    os.chdir(ROOT)
    exec(program, names)
    return names["figure"]


def crossing():
    return of_page("crossing.md")


def worn_profile():
    return of_page("wear.md")


def printed_by(example, *words):
    """The lines of an example in C, compiled here with cc."""
    with tempfile.TemporaryDirectory() as scratch:
        program = f"{scratch}/program"
        subprocess.run([os.environ.get("CC", "cc"), "-std=c99", "-O2", "-fopenmp", "-I", ROOT / "include", ROOT / "c_examples" / example,
                        ROOT / "target" / "lib" / "libkstrip.a", "-lm", "-o", program], check=True)
        return subprocess.run([program, DATA / "wheel_rail", *words], check=True, capture_output=True, text=True).stdout.splitlines()


def train():
    """The wheels of 13_train.c after a tenth of a second."""
    lines = printed_by("13_train.c", "100", "wheels")
    rows = np.array([[float(word) for word in re.findall(r"-?[0-9.]+", line.split(":")[1])] for line in lines if line.startswith("wheel ")])
    drawn, axes = plt.subplots(2, 1, figsize=(8.0, 4.5), sharex=True, layout="constrained")
    for side, name in enumerate(("right wheels", "left wheels")):
        behind, lateral, force, _ = rows[side::2].T
        for axis, values in zip(axes, (lateral, force)):
            axis.plot(behind, values, ".", markersize=3, color=plot.COLOURS[side], label=name)
    axes[0].set(ylabel="lateral position [mm]", title="fifty cars on an irregular track")
    axes[1].set(xlabel="distance behind the first axle [m]", ylabel="lateral force [kN]")
    axes[0].legend(loc="center right")
    for axis in axes:
        axis.grid(True, alpha=0.3)
    return drawn


def bogie():
    """What 12_bogie.c prints."""
    lines = printed_by("12_bogie.c")
    # y of both wheelsets [mm], speed [m/s], Y and Q of the front wheels [N]
    columns = {"y": 1, "speed": 3, "Y": 5, "Q": 6}
    panels = (("hunt", "y", "y, front wheelset [mm]", 1.0, "hunting at 80 m/s"),
              ("curve at 22 m/s", "Y", "Y, outer front wheel [kN]", 1e-3, "into a curve of 300 m"),
              ("brake", "speed", "speed [m/s]", 1.0, "braked to a hold on 1:50"),
              ("lift", "Q", "Q, right front wheel [kN]", 1e-3, "lifted by a jack"))
    drawn, axes = plt.subplots(2, 2, figsize=(8.0, 5.0), layout="constrained")
    for (run, name, label, scale, title), axis in zip(panels, axes.flat):
        rows = [[float(word) for word in re.findall(r"-?[0-9]+\.[0-9]+", line[len(run):])] for line in lines if line.startswith(run)]
        time, values = np.array([(row[0], scale * row[columns[name]]) for row in rows]).T
        axis.plot(time, values, color=plot.COLOURS[0], linewidth=1.0)
        axis.set(xlabel="time [s]", ylabel=label, title=title)
        axis.grid(True, alpha=0.3)
    return drawn


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs" / "figures" / "python"
    folder.mkdir(parents=True, exist_ok=True)
    for draw in (creep_curve, traction_map, patch_on_profiles, lateral_shift, wheelset, wear, worn_profile, conicity, measured_curve, crossing, bogie, train):
        with warnings.catch_warnings():
            # STRIP_1967 is shown beyond the range that its theory is for.
            warnings.simplefilter("ignore", kstrip.KstripWarning)
            figure = draw()
        figure.savefig(folder / f"{draw.__name__}.svg", metadata={"Date": None, "Creator": None})
        plt.close(figure)
        print(f"wrote {folder / draw.__name__}.svg")


if __name__ == "__main__":
    main()
