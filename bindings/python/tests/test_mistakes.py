"""Typical mistakes of tests/data/mistakes.csv: the text of the exception or of the warning names the cause. tests/interface runs the same rows in C and C++."""

import csv
import dataclasses
import os
import pathlib
import sys
import types
import unittest
import warnings

sys.path.insert(0, os.path.join(os.path.dirname(__file__), os.pardir))

import numpy as np

import kstrip

DATA = pathlib.Path(__file__).resolve().parents[3] / "tests" / "data"
TABLE = DATA / "mistakes.csv"
DRAWN = {name: 1e-3 * np.loadtxt(DATA / "wheel_rail" / f"{name}.csv", delimiter=",", skiprows=1).T for name in ("uic60", "s1002")}
RAIL, WHEEL = (kstrip.prepare_profile(*DRAWN[name]) for name in ("uic60", "s1002"))
PAIR = kstrip.wheel_pair(wheel_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
#: Lateral position of a right wheel in the middle of the track
MIDDLE = -10.5325e-3


class Case:
    """The good case: its members are changed by the rows of the table."""

    def __init__(self):
        self.contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
        self.creepage = kstrip.creepage(1e-3, 0.0, 0.1)
        self.radii, self.steel = kstrip.radii(lower_y=0.3, upper_x=0.46), kstrip.combine((82e9, 0.28), (82e9, 0.28))
        self.curve = kstrip.curve(20.0, 1 / 300.0, 0.1)
        self.pair = dataclasses.replace(PAIR)
        self.position, self.velocity = kstrip.wheel_position(lateral=0.0), kstrip.wheel_velocity(forward=20.0, pitch=-43.4)
        self.track, self.set = kstrip.Track(RAIL, gauge=1.435), kstrip.Wheelset(WHEEL, self.pair, back_to_back=1.36)
        self.options, self.loads = types.SimpleNamespace(model=0, strips=0), types.SimpleNamespace(vertical=160e3)
        self.support, self.force, self.amplitude = 80e3, 10e3, 3e-3
        self.unit = self.down = self.across = self.creepage_factor = self.sense = 1.0
        self.swapped = self.rail_upside_down = 0

    def change(self, member, value):
        *owners, name = member.split(".")
        owner = self
        for each in owners:
            owner = getattr(owner, each)
        getattr(owner, name)  # (a member that does not exist is no change)
        setattr(owner, name, int(value) if name in ("model", "swapped", "rail_upside_down") else float(value))

    def profiles(self):
        """Rail and wheel."""
        if self.swapped:
            return WHEEL, RAIL
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return (kstrip.prepare_profile(DRAWN["uic60"][0], -DRAWN["uic60"][1]) if self.rail_upside_down else RAIL), WHEEL

    def solve(self):
        kstrip.solve(self.contact, self.creepage, model=self.options.model)

    def hertz(self):
        kstrip.contact_from_hertz(self.radii, self.steel, 80e3, 0.3)

    def curve_motion(self):
        kstrip.curve_motion(self.curve, self.position, self.velocity)

    def prepare(self):
        y, z = DRAWN["s1002"]
        kstrip.prepare_profile(y * self.unit * self.across, z * self.unit * self.down)

    def height(self):
        self.position.lateral += MIDDLE
        kstrip.height_for_load(*self.profiles(), self.pair, self.position, self.support)

    def wheel(self):
        found = kstrip.height_for_load(RAIL, WHEEL, PAIR, kstrip.wheel_position(lateral=MIDDLE), 80e3)
        self.position.lateral += MIDDLE
        self.position.vertical = self.position.vertical or found
        kstrip.wheel_on_rail(*self.profiles(), self.pair, self.position, self.velocity)

    def settle(self):
        self.track.rail, self.set.wheel = self.profiles()
        kstrip.wheelset_settle(self.set, self.track, self.position, self.velocity, self.loads.vertical)

    def fit(self):
        law, slips = kstrip.friction(0.35, slope_factor=0.4, slide_factor=1.0), 0.5e-3 * 2.0 ** np.arange(6)
        forces = kstrip.solve(self.contact, kstrip.creepage(slips), law).fx
        kstrip.fit_friction(slips * self.creepage_factor, forces, self.contact, start=law)

    def conicity(self):
        shifts = np.array([-5e-3, 5e-3])
        kstrip.equivalent_conicity(shifts, 0.1 * self.sense * shifts, self.amplitude)

    def for_force(self):
        kstrip.creepage_for_force(self.contact, self.force, 0.0)


CALLS = {"curve": Case.curve_motion, "force": Case.for_force}


def text_of(function, changes=()):
    """What a call writes: the text of its exception or of its warnings."""
    case = Case()
    for member, value in changes:
        case.change(member, value)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            CALLS.get(function, getattr(Case, function, None))(case)
        except kstrip.KstripError as error:
            return str(error)
    return "\n".join(str(each.message) for each in caught)


class Mistakes(unittest.TestCase):
    def test_texts_name_the_cause(self):
        rows = list(csv.DictReader(TABLE.read_text(encoding="utf-8").splitlines()))
        self.assertGreaterEqual(len(rows), 40)
        for function in {row["function"] for row in rows}:
            self.assertEqual(text_of(function), "", f"the good case of {function}")
        for row in rows:
            with self.subTest(row["name"]):
                text = text_of(row["function"], [change.split("=") for change in row["changes"].split(";")])
                for word in row["words"].split("|"):
                    self.assertIn(word, text)


if __name__ == "__main__":
    unittest.main()
