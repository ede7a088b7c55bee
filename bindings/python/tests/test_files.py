"""Profile files in the formats of other programs: any of them comes out as a wheel or a rail the right way round, in metres."""

import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), os.pardir))

import numpy as np

import kstrip

DATA = pathlib.Path(__file__).resolve().parents[3] / "tests" / "data" / "wheel_rail"
WHEELS, RAILS = ("s1002", "avgwhl", "car7216", "whl288", "wornhm"), ("uic60", "avgHR", "avglow", "rail288", "siteb")


def points(name):
    """y and z in mm, the right way round."""
    return np.loadtxt(DATA / f"{name}.csv", delimiter=",", skiprows=1)


def simpack(values, wheel, unit=1000.0, more=()):
    """A file as SIMPACK writes it."""
    rows = [f"    {y:.8f} {z:.8f}   ! comment" for y, z in values]
    return ["header.begin", "  version  = 1", f"  type     = {int(wheel)}", "header.end", "spline.begin", "  comment       = 'a = b'",
            "  approx.smooth = 0.0", f"  units.len.f   = {unit}", "  units.ang.f   = 1.", *more, "  point.begin", "  ! y  z", *rows,
            "  point.end", "spline.end"]


def miniprof(values, columns="X,Y", marked=()):
    """A file as MiniProf writes it; some of its points are marked by a leading quotation mark."""
    rows = [f"{chr(34) if i in marked else ' '}{y:14.7E}\t{z:14.7E}" for i, (y, z) in enumerate(values)]
    return ["Filename=PROFILE.BAN", "ProgramName=", "MPTypeNo=299", f"XYPoints={len(values)}", "Chars=Win",
            "RefPoint1=0.0000, 0.0000", f"ColumnDef={columns}", "", *rows]


def thinned(values, least):
    """The points that have at least this distance from the one before, as files of drawn profiles have them."""
    kept = [values[0]]
    for point in values[1:]:
        if np.hypot(*(point - kept[-1])) >= least:
            kept.append(point)
    return np.array(kept)


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def read(self, name, lines, **how):
        path = self.folder / name
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return kstrip.read_profile(path, **how)

    def same(self, found, expected, tolerance=1e-9):
        if expected[0, 0] > expected[-1, 0]:
            expected = expected[::-1]
        np.testing.assert_allclose(found.y, 1e-3 * expected[:, 0], rtol=0, atol=tolerance)
        np.testing.assert_allclose(found.z, 1e-3 * expected[:, 1], rtol=0, atol=tolerance)

    def test_every_direction_of_every_profile_is_found_from_its_shape(self):
        for name in WHEELS + RAILS:
            kind = "wheel" if name in WHEELS else "rail"
            for y_sign in (1, -1):
                for z_sign in (1, -1):
                    for order in (1, -1):
                        turned = (points(name) * [y_sign, z_sign])[::order]
                        found = self.read("profile.txt", [f"{y:.7f} {z:.7f}" for y, z in turned])
                        with self.subTest(name=name, y=y_sign, z=z_sign, order=order):
                            self.assertEqual(found.kind, kind)
                            self.same(found, points(name))
                            told = "\n".join(found.notes)
                            self.assertEqual("mirrored" in told, y_sign < 0)
                            self.assertEqual("z: it pointed up" in told, z_sign < 0)

    def test_known_contact_from_the_files_of_three_programs(self):
        wheel, rail = points("s1002"), points("uic60")
        wheels = [self.read("a.prw", simpack(wheel[::-1], True)), self.read("a.whl", miniprof(wheel * [1, -1])),
                  self.read("a.wheel", ["# a tool", "#BP 101204", *(f"{y:16.5f} {z:15.5f}" for y, z in wheel * [-1, 1])])]
        rails = [self.read("a.prr", simpack(rail, False)), self.read("a.ban", miniprof((rail * [-1, 1])[::-1], marked=(3, 5))),
                 self.read("a.csv", ["y [m];z [m]", *(f"{1e-3 * y:.8f};{1e-3 * z:.8f}".replace(".", ",") for y, z in rail)])]
        for w in wheels:
            for r in rails:
                # .6 % below CONTACT's: peak pressures of real patches differ by .9 % in the mean
                self.has_the_known_contact(w, r, 1.0, peak=872.7)

    def has_the_known_contact(self, wheel, rail, tolerance, smoothing=0.0, turn=0.006, peak=878.0):
        """S1002 on 60E1 at 80 kN, radius .46 m, as CONTACT has it: y -10.34 mm, -2.04 degrees, 878 MPa, or another peak, within a tolerance [MPa]."""
        pair = kstrip.wheel_pair(wheel_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
        self.assertEqual((wheel.kind, rail.kind), ("wheel", "rail"))
        surfaces = rail.prepare(smoothing_length=smoothing), wheel.prepare(smoothing_length=smoothing)
        place = kstrip.wheel_position(lateral=-10.5325e-3)
        place.vertical = kstrip.height_for_load(*surfaces, pair, place, 80e3)
        found = kstrip.wheel_on_rail(*surfaces, pair, place, kstrip.wheel_velocity(forward=20.0, pitch=-20.0 / 0.46)).contacts
        self.assertEqual(found.shape, (1,))
        # 8 um from CONTACT's place, which has two digits
        self.assertAlmostEqual(1e3 * float(found.origin[0, 1] + place.lateral), -10.332, delta=0.002)
        self.assertAlmostEqual(float(np.degrees(found.angle[0])), -2.04, delta=turn)
        self.assertAlmostEqual(1e-6 * float(found.patch.strips.peak_pressure.max()), peak, delta=tolerance)

    def test_files_like_six_that_the_field_publishes(self):
        """The format, order, side, direction of z, distance and number of digits of each are those of a public file of that name."""
        s1002, uic60, wheel_a, rail_a = (points(name) for name in ("s1002", "uic60", "en_wheel_a", "en_rail"))
        coarse = thinned(s1002[abs(s1002[:, 0] + 10) <= 50], 0.7), thinned(uic60[uic60[:, 1] <= 15], 0.7)
        slice_y = np.concatenate((np.linspace(-69.5, 35, 105), np.linspace(36, 59.9, 25)))
        rough = np.interp(slice_y, *s1002.T) + 0.1 * np.sin(np.arange(slice_y.size) ** 2)
        corner = [[-65.0, -20.0], [-65.0, -7.63568], [-61.0, -3.63568]]
        cornered = np.concatenate((corner, (s1002 * [-1, 1])[::-1]))
        six = [
            # SIMPACK: a wheel from the field side, a rail from the gauge side, both with z down
            ("S1002_coars.prw", simpack(coarse[0][::-1], True), "wheel", coarse[0], ("reversed",)),
            ("UIC60_coars.prr", simpack(coarse[1], False), "rail", coarse[1], ()),
            # MiniProf: the gauge side at large y, some points marked
            ("UIC60_v3.ban", miniprof((uic60 * [-1, 1]), marked=(4, 5, 6)), "rail", np.delete(uic60, (4, 5, 6), 0), ("reversed", "mirrored", "3 points")),
            # a slice as CONTACT has them, rough, from the field side
            ("Wheel_section_1.txt", [f"{y:10.4f}{z:11.4f}" for y, z in zip(slice_y, rough)][::-1], "wheel", np.column_stack((slice_y, rough)), ("reversed",)),
            # a tool's file: the flange at large y, a corner that hangs down from the rim
            ("pk_S1002.wheel", ["# nominal S1002 with added corner", "#BP 101204", *(f"{y:16.5f}{z:15.5f}" for y, z in cornered)], "wheel",
             cornered * [-1, 1], ("mirrored",)),
            # tables of a norm: z up, columns of changing form, no end of the last line
            ("RUIC519A.dat", [f"{y:11.5f}{-z:11.5f}" if y < 0 else f"{y:13.7f}{-z:13.7f}" for y, z in wheel_a], "wheel", wheel_a, ("pointed up",)),
            ("SUIC519A.dat", [f"{y:g}\t{-z:.7g}" if i % 2 else f"{y:g} {-z:.7g}" for i, (y, z) in enumerate(rail_a)], "rail", rail_a, ("pointed up",)),
        ]
        read = {}
        for name, lines, kind, expected, told in six:
            with self.subTest(name=name):
                path = self.folder / name
                path.write_text("\n".join(lines), encoding="utf-8")
                read[name] = found = kstrip.read_profile(path)
                self.assertEqual(found.kind, kind, found)
                self.same(found, expected, 6e-8)
                for word in ("reversed", "mirrored", "pointed up"):
                    self.assertEqual(word in "\n".join(found.notes), word in told, (word, found))
                self.assertTrue(all(word in "\n".join(found.notes) for word in told), found)
                self.assertTrue(found.prepare().shape == ())
                if kind == "wheel":
                    self.assertTrue(found.z.max() > 0.026 and found.y[np.argmax(found.z)] < -0.05, found)
        for wheel in ("S1002_coars.prw", "pk_S1002.wheel"):
            for rail in ("UIC60_coars.prr", "UIC60_v3.ban"):
                # Some points are 1 mm apart: within 1 % of 878 MPa and 0.01 degrees, with the default and through all points
                for smoothing in (0.0, 1e-6):
                    self.has_the_known_contact(read[wheel], read[rail], 8.8, smoothing, 0.01)

    def test_header_of_simpack(self):
        wheel = points("s1002")
        self.same(self.read("m.prw", simpack(1e-3 * wheel, True, 1.0)), wheel)
        self.same(self.read("s.prw", simpack(wheel - [5.0, -2.0], True, more=["shift.y = 5.0", "shift.z = -2.0"])), wheel)
        self.same(self.read("r.prw", simpack(wheel * [-1, 1], True, more=["mirror.y = 1"])), wheel)
        turned = self.read("t.prr", simpack(points("uic60"), False, more=["rotate = 0.025"]))
        self.assertIn("turn 0.025 rad", "\n".join(turned.notes))
        self.assertAlmostEqual(turned.y[0], 1e-3 * (points("uic60")[0] @ [np.cos(0.025), -np.sin(0.025)]))

    def test_columns(self):
        wheel = points("s1002")
        for unit, factor in (("mm", 1.0), ("m", 1e-3), ("in", 1 / 25.4)):
            by_size = self.read("size.dat", [f"{factor * y:.9f}\t{factor * z:.9f}" for y, z in wheel])
            self.assertIn(f"units: {unit}, by the width", by_size.notes[1])
            self.same(by_size, wheel)
            named = self.read("named.csv", [f"s_{unit},z_{unit},y_{unit}", *(f"0,{factor * z:.9f},{factor * y:.9f}" for y, z in wheel)])
            self.assertIn("columns 3 and 2", named.notes[1])
            self.same(named, wheel)
        self.same(self.read("fortran.txt", [f"{y:.7E}".replace("E", "D") + f" {z:.7E}".replace("E", "D") for y, z in wheel]), wheel)
        self.same(self.read("x.ban", miniprof(np.c_[points("uic60")[:, 1], np.arange(480.0)[:, None], points("uic60")[:, 0]][:, [2, 0]])), points("uic60"))

    def test_overrides(self):
        lines = [f"{y:.7f} {z:.7f}" for y, z in points("s1002")]
        self.same(self.read("a.txt", lines, units=1e-3), points("s1002"))
        self.same(self.read("a.txt", lines, shift=(1e-3, -2e-3)), points("s1002") + [1.0, -2.0])
        mirrored = self.read("a.txt", lines, mirror_y=True)
        self.assertGreater(mirrored.y[np.argmax(mirrored.z)], 0.05)
        self.assertLess(self.read("a.txt", lines, mirror_z=True).z.min(), -0.027)
        self.assertEqual(self.read("a.txt", lines, kind="rail").kind, "rail")
        for wrong in ({"kind": "track"}, {"units": "furlong"}, {"units": -1.0}):
            with self.assertRaises(ValueError):
                self.read("a.txt", lines, **wrong)

    def test_symmetric_rail_stays_and_says_so(self):
        y = np.linspace(-35.0, 35.0, 141)
        for sign in (1, -1):
            found = self.read("a.txt", [f"{sign * a:.4f} {a * a / 100:.6f}" for a in y])
            self.assertEqual(found.kind, "rail")
            self.assertIn("symmetric", "\n".join(found.notes))

    def test_measured_from_the_flange_back_is_told(self):
        self.assertIn("not the running circle", self.read("a.txt", [f"{y + 70:.4f} {z:.4f}" for y, z in points("s1002")]).notes[-1])

    def test_points_that_coincide_are_left_out(self):
        found = self.read("a.txt", [f"{y:.7f} {z:.7f}" for y, z in np.repeat(points("s1002"), 2, axis=0)])
        self.same(found, points("s1002"))
        self.assertIn("399 points that coincide", "\n".join(found.notes))
        found.prepare()

    def test_errors_name_file_and_line(self):
        good = [f"{y:.4f} {z:.4f}" for y, z in points("s1002")]
        for name, lines, line, words in [
            ("a.txt", [*good[:6], "1.0 abc", *good[7:]], 7, "numbers are needed"),
            ("a.txt", [*good[:6], "1.0", *good[7:]], 7, "two numbers are needed"),
            ("a.txt", [*good[:6], "1.0 nan", *good[7:]], 7, "not a finite number"),
            ("a.txt", ["# nothing"], None, "needs 4 points, and this file has 0"),
            ("a.csv", ["y,z", "in words"], 2, "numbers are needed"),
            ("a.prw", simpack([(0, 0)] * 5, True)[:-1], 17, "ends within spline.begin"),
            ("a.prw", simpack([(0, 0)] * 5, True, "x"), 8, "units.len.f is not a number"),
            ("a.prw", simpack([(0, 0)] * 5, True, more=["nonsense"]), 10, "`keyword = value` is needed"),
            ("a.prw", ["header.begin", "spline.end"], 2, "spline.end without spline.begin"),
            ("a.prw", simpack([(0, 0)] * 5, True, -1.0), None, "must be positive"),
            ("a.ban", miniprof([(0, 0)] * 5, "A,B"), 7, "ColumnDef has no X and Y"),
            ("a.ban", miniprof([(0, 0)] * 5)[:-1], 12, "promises 5 points, and the file has 4"),
        ]:
            with self.subTest(words):
                with self.assertRaises(kstrip.ProfileError) as caught:
                    self.read(name, lines)
                self.assertIn(words, str(caught.exception))
                self.assertEqual(caught.exception.line, line)
                self.assertIn(name, str(caught.exception))
        with self.assertRaises(FileNotFoundError):
            kstrip.read_profile(self.folder / "nowhere.prw")

    def test_round_trip(self):
        for name in WHEELS + RAILS:
            values = points(name)
            profile = kstrip.Profile(1e-3 * values[:, 0], 1e-3 * values[:, 1], "wheel" if name in WHEELS else "rail", name)
            for extension in (".prw", ".whl", ".csv", ".txt") if name in WHEELS else (".prr", ".ban", ".csv", ".dat"):
                path = self.folder / f"copy{extension}"
                kstrip.write_profile(path, profile)
                back = kstrip.read_profile(path)
                self.assertEqual(back.kind, profile.kind)
                self.same(back, values)
        with self.assertRaisesRegex(ValueError, "file of a wheel"):
            kstrip.write_profile(self.folder / "rail.prw", profile)
        self.assertIn("Profile of a rail, 493 points", repr(profile))


if __name__ == "__main__":
    unittest.main()
