"""The pictures: labelled axes with units, colours that stand out, the numbers of the library. Needs matplotlib."""

import contextlib
import dataclasses
import doctest
import io
import os
import pathlib
import sys
import tempfile
import unittest
import warnings

sys.path.insert(0, os.path.join(os.path.dirname(__file__), os.pardir))

try:
    import matplotlib
except ImportError:
    raise unittest.SkipTest("SKIPPED: the pictures of the Python binding, because there is no matplotlib")
matplotlib.use("svg")

import matplotlib.pyplot as plt
import numpy as np

import kstrip
import pictures
from kstrip import plot

ROOT = pathlib.Path(__file__).resolve().parents[3]
ALL = ("creep_curve", "traction_map", "patch_on_profiles", "lateral_shift", "wheelset", "wear", "conicity", "measured_curve")


def luminance(colour):
    """Relative luminance of sRGB, as the guidelines for web content define it."""
    channels = (int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5))
    return sum(w * (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4) for w, c in zip((0.2126, 0.7152, 0.0722), channels))


class Pictures(unittest.TestCase):
    def tearDown(self):
        plt.close("all")

    def test_axes_have_labels_with_units(self):
        for name in ALL:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", kstrip.KstripWarning)
                figure = getattr(pictures, name)()
            for axes in figure.axes:
                bottom = [other for other in figure.axes if other is not axes and other.get_shared_x_axes().joined(axes, other)]
                labels = [axes.get_ylabel()] + [axes.get_xlabel()] * (not bottom and axes.get_label() != "<colorbar>")
                for label in labels:
                    self.assertRegex(label, r"\[[^]]+\]$", name)

    def test_colours_stand_out_from_white_and_black(self):
        for colour in plot.COLOURS:
            self.assertGreater((1.05) / (luminance(colour) + 0.05), 2.9)
            self.assertGreater((luminance(colour) + 0.05) / 0.05, 2.9)
        # Readers who see no red or no green tell them apart by lightness or by blue.
        for i, one in enumerate(plot.COLOURS):
            for other in plot.COLOURS[:i]:
                blue = abs(int(one[5:], 16) - int(other[5:], 16)) / 255
                self.assertGreater(max(blue, 5 * abs(luminance(one) - luminance(other))), 0.2)

    def test_curves_have_the_numbers_of_the_library(self):
        curve = plot.creep_curve(pictures.CONTACT, [0.0, 1e-3, 2e-3], spin=0.1, models=["strip"])
        forces = kstrip.solve(pictures.CONTACT, kstrip.creepage([0.0, 1e-3, 2e-3], 0.0, 0.1), model="strip")
        np.testing.assert_allclose(curve.axes[0].lines[0].get_ydata(), 1e-3 * forces.fx)
        shifted = pictures.lateral_shift()
        difference = shifted.axes[1].lines[0]
        np.testing.assert_allclose(difference.get_ydata(), -difference.get_ydata()[::-1], atol=1e-9)
        at = np.interp(3.0, difference.get_xdata(), difference.get_ydata())
        self.assertAlmostEqual(at, 0.976, delta=0.01)
        measured = pictures.measured_curve()
        self.assertIn("clean, rms 0.06", [text.get_text() for text in measured.axes[0].get_legend().get_texts()][1])

    def test_patches_of_every_kind(self):
        y = np.linspace(-12e-3, 12e-3, 241)
        steel = dict(rolling_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, friction=0.35)
        patch, _ = kstrip.patch_from_profile(y, 70e-6 * ((y / 4.5e-3) ** 2 - 1) ** 2, normal_force=40e3, **steel)
        plot.traction_map(patch, kstrip.creepage(3e-4, spin=0.6))
        plot.traction_map(pictures.CONTACT, kstrip.creepage(0.1))
        lifted = kstrip.wheel_position(lateral=-5e-3, vertical=-5e-3)
        plot.patch_on_profiles(pictures.RAIL, pictures.WHEEL, pictures.PAIR, lifted)
        pair = dataclasses.replace(pictures.PAIR, left=1)
        mirrored = kstrip.wheel_position(lateral=5.2e-3)
        mirrored.vertical = kstrip.height_for_load(pictures.RAIL, pictures.WHEEL, pair, mirrored, 80e3)
        left = plot.patch_on_profiles(pictures.RAIL, pictures.WHEEL, pair, mirrored)
        right = pictures.patch_on_profiles()
        np.testing.assert_allclose(left.axes[0].lines[2].get_xydata(), right.axes[0].lines[2].get_xydata(), atol=1e-9)
        self.assertIn("mirrored", left.axes[0].get_title())
        # Patches lie on both profiles, which overlap by less than .2 mm
        contact, rail = right.axes[0].lines[2].get_xydata().mean(axis=0), right.axes[0].lines[0]
        self.assertLess(abs(np.interp(contact[0], *rail.get_xydata().T) - contact[1]), 1.0)

    def test_every_function_has_an_example_that_runs(self):
        scope = {"kstrip": kstrip, "np": np, "plot": plot, "contact": pictures.CONTACT, "rail": pictures.RAIL, "wheel": pictures.WHEEL,
                 "pair": pictures.PAIR, "wheelset": pictures.WHEELSET, "track": pictures.TRACK,
                 "velocity": kstrip.wheel_velocity(forward=20.0, pitch=-20.0 / 0.46)}
        found = {test.name.split(".")[-1]: test for test in doctest.DocTestFinder().find(plot, globs=scope)}
        for name in ALL:
            with self.subTest(name=name), contextlib.redirect_stdout(io.StringIO()) as said:
                result = doctest.DocTestRunner().run(found[name])
                self.assertTrue(result.attempted > 0 and result.failed == 0, said.getvalue())

    def test_a_figure_to_draw_into(self):
        figure = plt.figure(layout="constrained")
        for part in figure.subfigures(1, 2):
            self.assertIs(plot.creep_curve(pictures.CONTACT, figure=part), part)
        with tempfile.TemporaryDirectory() as folder:
            figure.savefig(os.path.join(folder, "two.svg"))
        with self.assertRaisesRegex(ValueError, r"creepage \(1,\), force \(2,\)"):
            plot.measured_curve(pictures.CONTACT, [1.0], [1.0, 2.0], kstrip.friction(0.3))

    def test_the_page_shows_all(self):
        pages = (ROOT / "docs" / folder / "python.md" for folder in ("start", "reference"))
        page = "".join(page.read_text(encoding="utf-8") for page in pages)
        for name in ALL:
            picture = (ROOT / "docs" / "figures" / "python" / f"{name}.svg").read_text(encoding="utf-8")
            self.assertIn("fill: #ffffff", picture.split('<g id="axes_1">')[0], "a background, for dark pages too")
            self.assertIn(f"figures/python/{name}.svg", page)
            self.assertIn(f"plot.{name}(", page)
        self.assertEqual(sorted(plot.__all__), sorted((*ALL, "COLOURS")))


if __name__ == "__main__":
    unittest.main()
