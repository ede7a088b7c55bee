"""The commands of python -m kstrip on files: the numbers of the library, and messages instead of tracebacks."""

import contextlib
import csv
import io
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), os.pardir))

import numpy as np

import kstrip
import wheel_on_rail as scene
from kstrip.__main__ import main

DATA = pathlib.Path(__file__).resolve().parents[3] / "tests" / "data"
PROFILES = [str(DATA / "wheel_rail" / name) for name in ("uic60.csv", "s1002.csv")]


def run(*words):
    """Exit status, table, and what stands on the terminal besides it."""
    with contextlib.redirect_stdout(io.StringIO()) as told, contextlib.redirect_stderr(io.StringIO()) as said:
        status = main([str(word) for word in words])
    return status, list(csv.DictReader(io.StringIO(told.getvalue()))), said.getvalue()


def column(rows, name):
    return np.array([float(row[name]) for row in rows])


class Commands(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        return self.folder / name

    def test_solve(self):
        table = self.write("contacts.csv", "\ufeffa, b,normal_force,longitudinal\n6e-3,4.5e-3,80e3,1e-3\n6e-3,4.5e-3,80e3,2e-3\n6e-3,-1,80e3,2e-3\n")
        status, rows, _ = run("solve", table, "--friction", 0.3, "--model", "strip", "--threads", 2)
        contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
        np.testing.assert_allclose(column(rows, "fx"), [*kstrip.solve(contact, kstrip.creepage([1e-3, 2e-3]), model="strip").fx, np.nan], rtol=1e-8)
        self.assertEqual((status, [row["a"] for row in rows], rows[2]["status"]), (0, ["0.006"] * 3, str(kstrip.constants["KSTRIP_ERROR_SEMI_AXIS"])))
        self.assertEqual(run("solve", table, "--friction", 0.3, "-o", self.folder / "out.csv"), (0, [], ""))
        self.assertEqual(len((self.folder / "out.csv").read_text(encoding="utf-8").splitlines()), 4)

    def test_wheel_and_conicity(self):
        status, rows, _ = run("wheel", *PROFILES, "--lateral", -0.01, -0.008, "--load", 50e3)
        place = kstrip.wheel_position(lateral=[-0.01, -0.008])
        place.vertical = kstrip.height_for_load(scene.RAIL, scene.WHEEL, scene.pair(), place, 50e3)
        on = kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, kstrip.wheel_velocity(forward=20.0, pitch=-20.0 / 0.46))
        self.assertEqual((status, len(rows)), (0, int(on.counts.sum())))
        np.testing.assert_allclose(column(rows, "t_gamma").sum(), on.t_gamma.sum(), rtol=1e-7)
        status, rows, _ = run("conicity", *PROFILES, "--amplitude", 0.002, 0.003)
        self.assertTrue(status == 0 and (0.1 < column(rows, "conicity")).all() and (column(rows, "conicity") < 0.3).all(), rows)

    def test_fit(self):
        contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
        places = np.linspace(1e-3, 0.02, 20)
        forces = kstrip.solve(contact, kstrip.creepage(places), kstrip.friction(0.25, slope_factor=0.5)).fx
        table = self.write("measured.csv", "creepage,force\n" + "\n".join(f"{x},{y}" for x, y in zip(places, forces)))
        status, rows, _ = run("fit", table, "--a", 6e-3, "--b", 4.5e-3, "--normal-force", 80e3)
        found = {row["name"]: float(row["value"]) for row in rows}
        self.assertEqual((status, round(found["friction"], 4), round(found["slope_factor"], 4)), (0, 0.25, 0.5))

    def test_pictures(self):
        try:
            import matplotlib
        except ImportError:
            self.skipTest("SKIPPED: pictures of python -m kstrip, because there is no matplotlib")
        matplotlib.use("svg")
        self.assertEqual(run("conicity", *PROFILES, "--amplitude", 0.003, "--plot", self.folder / "conicity.svg")[0], 0)
        self.assertEqual(run("wheel", *PROFILES, "--plot", self.folder / "wheel.svg")[0], 0)
        self.assertTrue(all((self.folder / f"{name}.svg").stat().st_size > 5000 for name in ("conicity", "wheel")))

    def test_wrong_input_has_one_line(self):
        short = self.write("short.csv", "a,b\n1\n")
        for words, said in (
            (("solve", self.folder / "none.csv"), "No such file"),
            (("solve", self.write("empty.csv", "")), "the file is empty"),
            (("solve", short), "line 2 has 1 columns, and the first line names 2"),
            (("solve", self.write("word.csv", "a\nsix\n")), "line 2: could not convert"),
            (("solve", self.write("few.csv", "a,b\n1,1\n")), "normal_force: neither a column of the file nor --normal-force"),
            (("fit", short), "line 2 has 1 columns"),
            (("fit", self.write("other.csv", "x,force\n1,1\n")), "no column creepage; the columns are x, force"),
            (("wheel", *PROFILES, "--load", -1), "KSTRIP_ERROR_SUPPORT"),
        ):
            status, rows, message = run(*words)
            self.assertEqual((status, rows, message.count("\n")), (1, [], message.count("\n") if "KSTRIP" in said else 1), message)
            self.assertTrue(message.startswith("error: ") and said in message, message)

    def test_module_runs(self):
        shown = subprocess.run([sys.executable, "-m", "kstrip", "--help"], capture_output=True, text=True, check=True).stdout
        for name in ("solve", "wheel", "conicity", "fit"):
            self.assertIn(f"    {name} ", shown)


if __name__ == "__main__":
    unittest.main()
