"""Profile files in the formats of other programs: any of them comes out as a wheel or a rail the right way round, in metres."""

import importlib.util
import json
import os
import pathlib
import pickle
import sys
import tempfile
import tracemalloc
import unittest
import warnings

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

    def read(self, name, lines, encoding="utf-8", **how):
        """Reads lines; the warnings are kept in self.warned."""
        path = self.folder / name
        path.write_text("\n".join(lines) + "\n", encoding=encoding)
        try:
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                found = kstrip.read_profile(path, **how)
        except kstrip.ProfileError:
            self.assertTrue(set(how) - {"kind"} or path.suffix in (".whe", ".json") or self.in_c(path, **how)[0] < 0)
            raise
        self.warned = [str(one.message) for one in caught if issubclass(one.category, kstrip.ProfileWarning)]
        is_of_c = found.notes[0].startswith(("SIMPACK", "MiniProf", "columns")) and "outline is closed" not in "".join(found.notes)
        if is_of_c and not set(how) - {"kind"} and not encoding.startswith("utf-16"):
            status, y, z, notes = self.in_c(path, **how)
            self.assertEqual((status > 0, notes & 1), (bool(self.warned), int(found.kind == "wheel")), (status, notes, found))
            np.testing.assert_allclose(y, found.y, rtol=0, atol=1e-14)
            np.testing.assert_allclose(z, found.z, rtol=0, atol=1e-14)
        self.assertEqual(len(self.warned), len(caught))
        self.assertTrue(all(one.filename == __file__ for one in caught))
        return found

    def in_c(self, path, kind=None):
        """Status, y, z and notes of kstrip_read_profile() with the kind of the extension, which a C program passes."""
        text = path.read_bytes()
        kind = kind or {".prw": "wheel", ".whl": "wheel", ".wheel": "wheel", ".prr": "rail", ".ban": "rail", ".rail": "rail"}.get(path.suffix)
        form = kstrip.constants[f"KSTRIP_FORMAT_{kind.upper()}"] if kind else 0
        room = len(text) // 3 + 4
        y, z, count, notes = np.zeros(room), np.zeros(room), np.zeros(1, np.uint32), np.zeros(1, np.uint32)
        buffer = np.frombuffer(text + b" ", np.uint8)
        status = kstrip.lib.kstrip_read_profile(buffer.ctypes.data, len(text), form, y.ctypes.data, z.ctypes.data, room, count.ctypes.data,
                                                notes.ctypes.data)
        return status, y[: count[0]], z[: count[0]], int(notes[0])

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
                self.assertGreater(found.prepare().count, 100)
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
        self.assertIn("not the running circle", self.warned[0])

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
            ("a.ban", miniprof([(0, 0)] * 5)[:-2], 11, "promises 5 points, and the file has 3"),
            ("a.txt", ["1 1"] * 6, None, "has 1 at different places"),
            ("a.txt", [f"{i} {row}" for i, row in enumerate(good)], 1, "columns=(i, j)"),
            ("a.csv", [f"{y:.3f},{z:.3f}".replace(".", ",") for y, z in points("s1002")], 1, "decimal=','"),
            ("a.txt", [*good[:6], "-9999 -9999", *good[6:]], 7, "missing=-9999"),
            ("a.csv", [row.replace(" ", ",") for row in good[:6]] + ["1.0,NA"] + [row.replace(" ", ",") for row in good[6:]], 7, "missing='NA'"),
            ("a.txt", [f"{1e3 * y:.1f} {1e3 * z:.1f}" for y, z in points("s1002")], None, "units="),
            ("a.whe", ["WHEELPROFILE", "title", "TREADDATUM MARS", "FLANGEBACK 1360", "0 0 0 0"], None, "TREADDATUM is EUROPEAN"),
            ("a.mpt", ["[Profile1Info]", "ProgramName=AutoCAD", "MPD1=A 0 0 1 1 2"], 3, "a segment 'A'"),
            ("a.json", ['{"y": [1, 2, 3], "z": [1, 2]}'], None, "lists y and z of one length"),
        ]:
            with self.subTest(words):
                with self.assertRaises(kstrip.ProfileError) as caught:
                    self.read(name, lines)
                self.assertIn(words, str(caught.exception))
                self.assertEqual(caught.exception.line, line)
                self.assertIn(name, str(caught.exception))
        with self.assertRaises(FileNotFoundError):
            kstrip.read_profile(self.folder / "nowhere.prw")

    def turns(self, found):
        return [note for note in found.notes if "mirrored" in note or "pointed up" in note or "turned" in note]

    def test_tables_of_spreadsheets_and_instruments(self):
        rail = points("uic60")
        plain = [f"{y:.4f} {z:.4f}" for y, z in rail]
        comma = [row.replace(" ", ",") for row in plain]
        german = [row.replace(".", ",") for row in plain]
        half = len(rail) // 2
        for name, lines, how in [
            ("quoted.csv", ['"y","z"', *('"' + row.replace(",", '","') + '"' for row in comma)], {}),
            ("quoted_german.csv", ['"y","z"', *('"' + row.replace(" ", '","') + '"' for row in german)], {}),
            ("units_line.csv", ["y,z", "mm,mm", *comma], {}),
            ("title.txt", ["Rail profile 60E1, depot 4", "y z", *plain], {}),
            ("skip.txt", ["12 34 5", "7 8 9", *plain], {"skip": 2}),
            ("count.txt", [str(len(rail)), *plain], {}),
            ("footer.txt", [*plain, "END", "of the measurement"], {}),
            ("matlab.m", ["data=[", *(row + ";" for row in plain), "];"], {}),
            ("list.txt", ["[", *(f"({row})," for row in comma), "]"], {}),
            ("empty_row.csv", [*comma[:half], ",", *comma[half:]], {}),
            ("blank_rows.txt", ["", *plain[:half], "", *plain[half:], ""], {}),
            ("mark.csv", [*comma[:half], "-9999.0,-9999.0", *comma[half:]], {"missing": -9999}),
            ("nan.csv", [*comma[:half], "NaN,1.0", *comma[half:]], {"missing": "nan"}),
            ("cell.csv", [*comma[:half], "1.0,", *comma[half:]], {"missing": ""}),
            ("fortran.txt", [f"{y:.9E} {z:.9E}".replace("E", "D") for y, z in rail], {}),
            ("tabs_german.txt", [row.replace(" ", "\t") for row in german], {}),
            ("spaces_german.txt", [row.replace(" ", "    ") for row in german], {}),
            ("semicolons_german.csv", ["y [mm];z [mm]", *(row.replace(" ", ";") for row in german)], {}),
            ("commas_german.csv", [row.replace(" ", ",") for row in german], {"decimal": ","}),
            ("number.txt", [f"{i} {row}" for i, row in enumerate(plain)], {"columns": (1, 2)}),
            ("number.csv", ["nr,y,z", *(f"{i},{row}" for i, row in enumerate(comma))], {}),
            ("xyz.txt", [f"0.0 {row}" for row in plain], {"columns": (1, 2)}),
            ("names.csv", ["a,b,c", *(f"{row},0" for row in comma)], {"columns": ("a", "b")}),
            ("numpy.txt", ["# x y z", *(f"0.0 {row}" for row in plain)], {}),
            ("inline.txt", [f"{row}   # point {i}" for i, row in enumerate(plain)], {}),
            ("dos.txt", [row + "\r" for row in plain] + ["\x1a"], {}),
            ("profile.json", [json.dumps({"y": list(rail[:, 0]), "z": list(rail[:, 1]), "units": "mm"})], {}),
            ("points.json", [json.dumps(rail.tolist())], {}),
            ("numpy.json", [repr({"y": list(rail[:, 0]), "z": list(rail[:, 1])}).replace("'", '"')], {}),
        ]:
            with self.subTest(name):
                found = self.read(name, lines, **how)
                self.assertEqual((found.kind, self.turns(found), self.warned), ("rail", [], []))
                self.same(found, rail, 6e-8)
        for encoding in ("utf-16", "utf-16-le", "utf-16-be", "utf-8-sig", "latin-1"):
            self.same(self.read("encoded.csv", ["Höhe,Länge" if encoding == "latin-1" else "y_mm,z_mm", *comma], encoding), rail, 6e-8)

    def test_arguments_are_checked(self):
        for wrong in ({"columns": 1}, {"columns": (0, 1, 2)}, {"skip": -1}, {"decimal": ";"}):
            with self.subTest(wrong), self.assertRaises((TypeError, ValueError)):
                self.read("a.txt", ["1 2"] * 6, **wrong)
        for how, words in (({"columns": (0, 5)}, "are not among the 2 columns"), ({"columns": ("a", "b")}, "no column is named 'a'")):
            with self.subTest(words), self.assertRaisesRegex(kstrip.ProfileError, words):
                self.read("a.txt", [f"{i} {i * i}" for i in range(9)], **how)

    def test_one_stray_turns_nothing(self):
        for name in RAILS:
            values = points(name)
            for at in (0.1, 0.3, 0.5, 0.9):
                for dz in (-5.0, 5.0, -20.0):
                    stray = values.copy()
                    stray[int(at * len(values)), 1] += dz
                    for y_sign, z_sign in ((1, 1), (-1, -1)):
                        found = self.read("stray.csv", ["y_mm,z_mm", *(f"{y_sign * y:.6f},{z_sign * z:.6f}" for y, z in stray)], kind="rail")
                        with self.subTest(name=name, at=at, dz=dz):
                            self.same(found, stray, 1e-8)

    def test_the_head_of_a_grooved_rail_decides(self):
        """A rail with a lean toward its gauge side, a groove of 45 mm and a guard, at either side, up or down."""
        head = points("uic60")
        head = head[head[:, 1] < 15.0]
        for groove_side in (-1, 1):
            groove = np.linspace(0.0, 1.0, 60)[1:]
            edge = head[-1] if groove_side > 0 else head[0]
            floor = np.c_[edge[0] + groove_side * 44.0 * groove, edge[1] * (1 - groove) + 2.0 * groove + 40.0 * np.sin(np.pi * groove)]
            guard = np.c_[floor[-1, 0] + groove_side * np.linspace(1.0, 30.0, 30), np.full(30, 2.0)]
            rail = np.vstack((head, floor, guard) if groove_side > 0 else (guard[::-1], floor[::-1], head))
            for z_sign in (1, -1):
                found = self.read("grooved.csv", ["y_mm,z_mm", *(f"{y:.6f},{z_sign * z:.6f}" for y, z in rail)])
                with self.subTest(groove_side=groove_side, z=z_sign):
                    self.assertEqual(found.kind, "rail")
                    self.same(found, rail, 1e-8)
                    self.assertEqual(any("pointed up" in note for note in found.notes), z_sign < 0)
                    self.assertTrue(any("more than one head" in warning for warning in self.warned))

    def crossing(self, width):
        """A wing rail, a flangeway with a round floor and a nose of a width, in mm, z down."""
        groove = np.linspace(0.0, 1.0, 60)[1:]
        wing = np.c_[np.linspace(-70.0, -50.0, 40), np.interp(np.linspace(-70.0, -50.0, 40), (-70, -66, -50), (30, 4, 4))]
        floor = np.c_[-50.0 + 44.0 * groove, 4.0 + 46.0 * np.sin(np.pi * groove)]
        nose = np.c_[np.linspace(-5.5, width, 40), np.full(40, 3.0)]
        side = np.c_[width + np.linspace(0.5, 4.0, 20), 3.0 + np.linspace(2.0, 40.0, 20)]
        field = np.c_[width + np.linspace(5.0, 40.0, 30), np.full(30, 43.0)]
        return np.vstack((wing, floor, nose, side, field))

    def test_slices_of_a_crossing_are_never_turned(self):
        widths = np.linspace(6.0, 70.0, 33)
        for width in widths:
            found = self.read("nose.prr", simpack(self.crossing(width), False))
            self.assertEqual(self.turns(found), [])
            self.same(found, self.crossing(width), 1e-8)
        paths = []
        for k, width in enumerate(widths):
            paths.append(self.folder / f"slice_{k}.txt")
            np.savetxt(paths[-1], self.crossing(width))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", kstrip.ProfileWarning)
            for found, width in zip(kstrip.read_profiles(paths), widths):
                self.assertEqual(found.kind, "rail")
                self.same(found, self.crossing(width), 1e-8)
                self.assertIn("those of the series", "\n".join(found.notes))

    def listed(self, name, head, places, profiles, form="txt"):
        """A list of slices with its files in a folder beside it."""
        (self.folder / "slices").mkdir(exist_ok=True)
        lines = ["% a list of slices", head, f"  {len(places)}   NSLC", "  0 0 0   NFEAT, NKINK, NACCEL", "  1   S_METHOD", ""]
        for k, (place, values) in enumerate(zip(places, profiles)):
            text = simpack(values, False) if form == "prr" else [f"{y:.9f} {z:.9f}" for y, z in values]
            (self.folder / "slices" / f"{k}.{form}").write_text("\n".join(text))
            lines.append(f"  {place:.6f}  'slices/{k}.{form}'   % a comment")
        path = self.folder / name
        path.write_text("\n".join(lines) + "\n")
        return path

    def test_lists_of_slices(self):
        widths = np.linspace(10.0, 30.0, 11)
        profiles = []
        for width in widths:
            values = self.crossing(width)
            length = np.concatenate(([0.0], np.hypot(*np.diff(values, axis=0).T).cumsum()))
            fine = np.linspace(0.0, length[-1], 1000)
            profiles.append(np.c_[np.interp(fine, length, values[:, 0]), np.interp(fine, length, values[:, 1])])
        for form, head in (("prr", " 0.0 1.0  S_OFFSET [mm], S_SCALE [mm/mm]"), ("txt", " -0.5 1000.0")):
            found = kstrip.read_slices(self.listed("a.slcs", head, np.linspace(0.5, 1.0, 11) if form == "txt" else np.linspace(0, 500, 11), profiles, form))
            np.testing.assert_allclose(found.places, np.linspace(0.0, 0.5, 11), atol=1e-12)
            self.assertEqual(repr(found), "Slices(11 profiles of a rail, 0 to 0.5 m)")
            for profile, values in zip(found.profiles, profiles):
                self.same(profile, values, 1e-8)
            # Between two slices the surface is nearly that of the slice that was left out
            coarse = kstrip.Slices(found.places[::2], found.profiles[::2])
            for k in (1, 5, 9):
                at, expected = coarse.at(found.places[k]), found.profiles[k].prepare()
                across = np.linspace(-3e-3, 1e-3 * widths[k] - 3e-3, 50)
                np.testing.assert_allclose(np.interp(across, at.y, at.z), np.interp(across, expected.y, expected.z), rtol=0, atol=2e-6)
            # It is continuous, at the slices too
            for place in (0.1, 0.123):
                one, other = found.at(place - 1e-9), found.at(place + 1e-9)
                np.testing.assert_allclose(one.y, other.y, rtol=0, atol=1e-8)
                np.testing.assert_allclose(one.z, other.z, rtol=0, atol=1e-8)
            for beyond in (-0.1, 0.6):
                with self.assertRaisesRegex(ValueError, "the slices reach from 0 to 0.5 m"):
                    found.at(beyond)

    def test_a_wheel_with_a_flat(self):
        wheel = points("s1002")
        angles = np.linspace(-3.0, 3.0, 25)
        flat = [wheel - np.c_[0 * wheel[:, :1], np.full((len(wheel), 1), 0.4 * max(0.0, 1 - (angle / 0.3) ** 2))] for angle in angles]
        found = kstrip.read_slices(self.listed("flat.slcw", " 0.0 1.0   TH_OFFSET", angles, flat))
        self.assertEqual((found.around, found.profiles[0].kind), (True, "wheel"))
        zero = [float(np.interp(0.0, found.at(angle).y, found.at(angle).z)) for angle in (0.0, 2 * np.pi, 1.0, 3.1, -3.1)]
        np.testing.assert_allclose(1e3 * np.array(zero), np.interp(0.0, *wheel.T) - np.array([0.4, 0.4, 0.0, 0.0, 0.0]), atol=1e-4)

    def test_between_slices_of_an_analytic_crossing_nose(self):
        """A nose that widens by 1 in 10 and rises by 1 in 66: between slices the surface, the wheel's height and the peak pressure are its own."""

        def nose(x):
            half, angle = 1e-3 * (6.0 + 50.0 * x), np.linspace(-0.98, 0.98, 400) * np.pi / 2
            return kstrip.Profile(half * (1 + np.sin(angle)), 6e-3 * (1 - x / 0.4) + 14e-3 * (1 - np.cos(angle)), "rail")

        pair = kstrip.wheel_pair(wheel_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
        wheel = kstrip.Profile(*1e-3 * points("s1002").T, "wheel").prepare()
        velocity = kstrip.wheel_velocity(forward=20.0, pitch=-20.0 / 0.46)

        def carried(rail):
            place = kstrip.wheel_position(lateral=-30e-3)
            place.vertical = kstrip.height_for_load(rail, wheel, pair, place, 80e3)
            found = kstrip.wheel_on_rail(rail, wheel, pair, place, velocity).contacts
            return float(place.vertical), float(found.patch.strips.peak_pressure.max())

        # Distance of the slices, and the largest differences: of z [m], of the wheel's height [m], of the peak pressure
        for distance, most_z, most_height, most_peak in ((0.01, 2e-6, 0.1e-6, 2e-3), (0.05, 50e-6, 2e-6, 0.05)):
            places = np.arange(0.0, 0.301, distance)
            slices = kstrip.Slices(places, [nose(x) for x in places])
            for x in (0.0561, 0.1062, 0.1834, 0.2217):
                between, own = slices.at(x), nose(x).prepare()
                across = own.y.min() + np.linspace(0.15, 0.85, 200) * np.ptp(own.y)
                with self.subTest(distance=distance, x=x):
                    np.testing.assert_allclose(np.interp(across, between.y, between.z), np.interp(across, own.y, own.z), rtol=0, atol=most_z)
                    (height, peak), (own_height, own_peak) = carried(between), carried(own)
                    self.assertLess(abs(height - own_height), most_height)
                    self.assertLess(abs(peak / own_peak - 1), most_peak)

    def test_faults_of_lists_of_slices(self):
        profiles = [self.crossing(10.0), self.crossing(12.0)]
        path = self.listed("a.slcs", "0 1", [0.0, 1.0], profiles)
        good = path.read_text()
        for change, words in (("no numbers at all", "begins with offset and scale"), (good.replace("  2   NSLC", " 3   NSLC"), "promises 3 slices"),
                              (good.replace("'slices/1.txt'", "slices/1.txt"), "a place and the name"), (good.replace("1.000000 ", "0.000000 "), "ascending")):
            path.write_text(change)
            with self.subTest(words), self.assertRaisesRegex(kstrip.ProfileError, words):
                kstrip.read_slices(path)
        profile = kstrip.read_profile(self.folder / "slices" / "0.txt", kind="rail", mirror_y=False)
        for places, around in (([0.0], False), ([0.0, 0.0], False), ([0.0, 7.0], True)):
            with self.assertRaises(ValueError):
                kstrip.Slices(places, [profile] * 2, around)
        with self.assertRaisesRegex(kstrip.KstripError, "share"):
            kstrip.profile_between(profile.prepare(), profile.prepare(), 1.5)

    def test_a_series_has_one_decision(self):
        """Slices that alone are symmetric or nearly flat stand as the clear ones."""
        rail = points("uic60")
        paths = [self.folder / f"{k}.txt" for k in range(3)]
        np.savetxt(paths[0], rail * [-1, -1])
        np.savetxt(paths[1], rail[rail[:, 1] < 14.0] * [-1, -1])
        np.savetxt(paths[2], rail[abs(rail[:, 0]) < 5.0] * [-1, -1])
        first, second, third = kstrip.read_profiles(paths)
        self.same(first, rail, 1e-8)
        self.same(second, rail[rail[:, 1] < 14.0], 1e-8)
        self.same(third, rail[abs(rail[:, 0]) < 5.0], 1e-8)

    def test_conventions_come_before_shapes(self):
        rail, wheel = points("uic60"), points("s1002")
        # A rail whose gauge side by its shape is at large y stays: the format says so
        found = self.read("field.prr", simpack(rail * [-1, 1], False))
        self.same(found, rail * [-1, 1])
        self.assertEqual((self.turns(found), self.warned), ([], []))
        # What cannot be: a flange at large y, a rail or a wheel upside down
        for name, lines, values, words in [
            ("left.prw", simpack(wheel * [-1, 1], True), wheel, "the flange is at large y, against the format"),
            ("up.prw", simpack(wheel * [1, -1], True), wheel, "z points up by the shape, against the format"),
            ("up.prr", simpack(rail * [1, -1], False), rail, "z points up by the shape, against the format"),
        ]:
            found = self.read(name, lines)
            self.same(found, values)
            self.assertTrue(any(words in warning for warning in self.warned), self.warned)
            self.assertTrue(any(words in note for note in found.notes))
        self.assertLess(self.read("up.prw", simpack(wheel * [1, -1], True), mirror_z=False).z.min(), -0.027)
        # A kind against the file
        found = self.read("r.prr", simpack(rail * [-1, -1], True), kind="rail")
        self.same(found, rail)
        self.assertIn("the file is that of a wheel", self.warned[0])
        found = self.read("r.prr", simpack(rail, True))
        self.assertEqual(found.kind, "rail")
        self.assertIn("the header says wheel and the extension rail", self.warned[0])

    def test_a_groove_for_a_ball_stands_as_its_format_has_it(self):
        y = np.linspace(-12.0, 12.0, 200)
        groove = np.column_stack((y, np.sqrt(20.0**2 - y**2) - 20.0))
        self.same(self.read("ring.prr", simpack(groove, False)), groove)
        self.assertEqual(self.warned, [])

    def test_wheel_of_miniprof_stands_at_its_running_circle(self):
        wheel = points("s1002")
        for y_sign in (1, -1):
            for z_sign in (1, -1):
                raised = (wheel + [70.0, 12.5]) * [y_sign, z_sign]
                found = self.read("a.whl", miniprof(raised))
                self.same(found, wheel - [0.0, np.interp(0.0, *wheel[wheel[:, 0] > -20].T)], 1e-8)
                self.assertIn("y = 0 was the flange back: moved by -70 mm", "\n".join(found.notes))
                self.assertEqual(self.warned, [])

    def test_headers_of_miniprof(self):
        rail = points("uic60")
        rows = [f"{y:.6f}\t{z:.6f}" for y, z in rail]
        segments = [f"MPD{k + 1}=L {a[0]:.6f} {a[1]:.6f} {b[0]:.6f} {b[1]:.6f}" for k, (a, b) in enumerate(zip(rail, rail[1:]))]
        for name, head in [
            ("classic.ban", ["#MINIRAILPROF", "name.ban", "MINIPROF 2020", "Stock.......:", "Rail ID....:", '" 32.58 37.11 14.71', "(Sd/Sh/qR)", ""]),
            ("old.ban", ["MINIPROF 101 1 1 24", "name.prd", "Stock.......:", "32.58 37.11 14.71  (Sd/Sh/qR)", ""]),
            ("quoted.ban", ["Filename=a.trc", "XYPoints=480", '"RefPoint1="', "SectionNo=", '"ColumnDef=X,Y,A"', ""]),
            ("sections.mpt", ["[FileInfo]", "ProgramName=MiniProf for Windows", "", "[Profile1Info]", "XYPoints=480", "[Profile1]"]),
            ("less.ban", ["Filename=a", "XYPoints=479", ""]),
            ("more.ban", ["Filename=a", "XYPoints=481", ""]),
            ("spaced.ban", ["Filename = a", "Some text of the operator", "ColumnDef = X, Y", ""]),
        ]:
            with self.subTest(name):
                self.same(self.read(name, head + rows), rail, 1e-8)
        self.same(self.read("drawn.mpt", ["[Profile1Info]", "ProgramName=AutoCAD", "MPDC=479", *segments]), rail, 1e-8)
        german = [row.replace(".", ",") for row in rows]
        self.same(self.read("german.ban", ["Filename=a", "ColumnDef=X,Y", "", *german]), rail, 1e-8)

    def test_simpack_bounds_weights_and_smoothing(self):
        rail = points("uic60")
        found = self.read("b.prr", simpack(rail, False, more=["bound.y.min = -20.0", "bound.y.max = 20.0"]))
        self.same(found, rail[abs(rail[:, 0]) <= 20.0])
        self.assertIn("beyond bound.y", "\n".join(found.notes))
        lines = simpack(rail, False, more=["approx.smooth = 0.3"])
        first = next(k for k, line in enumerate(lines) if line.strip().startswith("!"))
        lines = [line.replace("! comment", "0.0" if k == first + 100 else "1.0") for k, line in enumerate(lines)]
        found = self.read("w.prr", lines)
        self.same(found, np.delete(rail, 99, 0))
        self.assertIn("1 points of weight 0 are left out", found.notes)
        self.assertIn("approx.smooth = 0.3 is not applied", "\n".join(found.notes))

    def test_gensys(self):
        """Columns in mm with y toward the middle of the track, z down, from the field side, and comments after the numbers."""
        for name, extension, kind in (("s1002", "wheel", "wheel"), ("avgwhl", "wheel", "wheel"), ("uic60", "rail", "rail"), ("avgHR", "rail", "rail")):
            rows = [f"{y:10.5f} {z:10.5f}" for y, z in (points(name) * [-1, 1])[::-1]]
            rows[1] += "   # Start as far out as possible."
            with self.subTest(name):
                found = self.read(f"{name}.{extension}", ["# a tool", *rows])
                self.assertEqual(found.kind, kind)
                self.same(found, points(name), 6e-9)
                self.assertIn("mirrored", "".join(found.notes))

    def test_vampire(self):
        """Both sides across the track in mm: wheels with z down and the tread datum 70 mm from the flange back, rails with z up."""
        wheel, rail = points("s1002"), points("uic60")
        rows = [f"{-(y + 750.0):.6f}, {z:.6f}, {y + 750.0:.6f}, {z:.6f}" for y, z in wheel]
        self.same(self.read("a.whe", ["WHEELPROFILE", "S1002 of a wheelset", "TREADDATUM EUROPEAN", "FLANGEBACK 1360.0", *rows]), wheel, 1e-8)
        rows = [f"{-(y + 717.5):.6f} {-z - 3.0:.6f} {y + 717.5:.6f} {-z - 3.0:.6f}" for y, z in rail]
        found = self.read("a.rai", ["RAILPROFILE", "60E1", "GAUGEPOINT EUROPEAN", "GAUGE 1435.0", *rows])
        self.same(found, rail - [0.0, rail[:, 1].min()], 1e-8)
        self.assertEqual(self.warned, [])

    def test_outline_is_cut_to_its_head(self):
        """A whole rail: its head, a web and a foot of 150 mm, from any point of the outline, either way round."""
        head = points("uic60")
        head = np.vstack(([head[0, 0] + 8.0, 45.0], head, [head[-1, 0] - 8.0, 45.0]))
        below = [[8.0, 60.0], [8.0, 150.0], [75.0, 162.0], [75.0, 172.0], [-75.0, 172.0], [-75.0, 162.0], [-8.0, 150.0], [-8.0, 60.0]]
        outline = np.vstack((head, below))
        for start in (0, 100, 400, len(outline) - 3):
            for sign in (1, -1):
                for order in (1, -1):
                    turned = np.roll(outline, start, axis=0)[::order] * [1, sign]
                    turned = np.vstack((turned, turned[:1]))
                    found = self.read("outline.txt", [f"{y:.6f} {z:.6f}" for y, z in turned])
                    with self.subTest(start=start, sign=sign, order=order):
                        self.assertEqual(found.kind, "rail")
                        self.assertIn("outline is closed", "\n".join(found.notes))
                        self.assertLess(found.z.max(), 0.0455)
                        inner = head[1:-1]
                        np.testing.assert_allclose(np.interp(0.0, found.y, found.z), 1e-3 * np.interp(0.0, *inner.T), atol=1e-6)
                        self.assertLess(abs(found.y.min() - 1e-3 * inner[:, 0].min()), 1e-6)
                        found.prepare()

    @unittest.skipUnless(importlib.util.find_spec("ezdxf"), "SKIPPED: ezdxf is not installed")
    def test_drawings(self):
        import ezdxf

        rail = points("uic60")[::4]
        for kind in ("lwpolyline", "polyline", "lines", "spline", "halves"):
            drawing = ezdxf.new(units=4)
            space = drawing.modelspace()
            flipped = [tuple(point) for point in rail * [1, -1]]
            if kind == "lwpolyline":
                space.add_lwpolyline(flipped)
            elif kind == "polyline":
                space.add_polyline2d(flipped)
            elif kind == "spline":
                space.add_cad_spline_control_frame([(y, z, 0.0) for y, z in flipped])
            elif kind == "halves":
                space.add_lwpolyline(flipped[60:])
                space.add_lwpolyline(flipped[60::-1])
            else:
                for a, b in reversed(list(zip(flipped, flipped[1:]))):
                    space.add_line(a, b)
            space.add_line((0, 90), (5, 90))
            path = self.folder / f"{kind}.dxf"
            drawing.saveas(path)
            found = kstrip.read_profile(path, kind="rail")
            with self.subTest(kind):
                inside = 1e-3 * rail[abs(rail[:, 0]) < 25.0]
                order = np.argsort(found.y)
                np.testing.assert_allclose(np.interp(inside[:, 0], found.y[order], found.z[order]), inside[:, 1], atol=5e-6)
                self.assertIn("separate lines, of which the longest is read", "\n".join(found.notes))

    @unittest.skipUnless(importlib.util.find_spec("ezdxf"), "SKIPPED: ezdxf is not installed")
    def test_drawings_of_many_lines(self):
        """Lines in any order and direction, some of which meet in one point, and a number that is not finite."""
        import ezdxf

        random = np.random.default_rng(7)
        y = np.linspace(-35.0, 35.0, 2001)
        points = np.column_stack((y, -(y**2) / 300.0))
        drawing = ezdxf.new(units=4)
        space = drawing.modelspace()
        for k in random.permutation(2000):
            space.add_line(*(points[[k, k + 1]] if random.random() < 0.5 else points[[k + 1, k]]))
        for angle in np.linspace(0.0, 6.0, 500):
            space.add_line((0.0, 200.0), (np.cos(angle), 200.0 + np.sin(angle)))
        path = self.folder / "lines.dxf"
        drawing.saveas(path)
        found = kstrip.read_profile(path, kind="rail")
        self.same(found, points * [1, -1], 1e-8)
        space.add_line((0.0, 0.0), (np.inf, 0.0))
        drawing.saveas(path)
        with self.assertRaisesRegex(kstrip.ProfileError, "not a finite number"):
            kstrip.read_profile(path)

    def test_rollers_and_weak_shapes(self):
        y = np.linspace(-12.0, 12.0, 121)
        roller = np.c_[y, -(y**2) / 400.0]
        for z_sign in (1, -1):
            found = self.read("roller.txt", [f"{a:.6f} {z_sign * b:.6f}" for a, b in roller], kind="wheel", units="mm")
            self.same(found, roller, 1e-8)
        self.read("roller.txt", [f"{a:.6f} {b:.6f}" for a, b in roller], units="mm")
        self.assertTrue(any("kind= says which" in warning for warning in self.warned))
        flat = self.read("flat.txt", [f"{a:.6f} 0" for a in y], kind="wheel", units="mm")
        self.assertTrue(any("hardly says whether z points down" in warning for warning in self.warned))
        self.same(flat, np.c_[y, 0 * y])
        # A cone of 1:40 with a steep flange, as tests of conicity have it
        cone = np.array([[-70.0, 0.0], [-68.0, 20.0], [-62.0, 28.0], [-52.0, 25.0], [-40.0, 1.0], [60.0, -1.5]])
        line = np.linspace(0.0, 5.0, 301)
        cone = np.c_[np.interp(line, np.arange(6), cone[:, 0]), np.interp(line, np.arange(6), cone[:, 1])]
        for y_sign, z_sign in ((1, 1), (-1, 1), (1, -1), (-1, -1)):
            found = self.read("cone.txt", [f"{y_sign * a:.6f} {z_sign * b:.6f}" for a, b in cone])
            self.assertEqual(found.kind, "wheel")
            self.same(found, cone, 1e-8)

    def test_arrays_are_oriented_as_files(self):
        for name in WHEELS + RAILS:
            kind = "wheel" if name in WHEELS else "rail"
            for y_sign, z_sign, order in ((1, 1, 1), (-1, 1, -1), (1, -1, 1), (-1, -1, -1)):
                y, z = 1e-3 * (points(name) * [y_sign, z_sign])[::order].T
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore", kstrip.ProfileWarning)
                    found = kstrip.oriented(y, z, kind=kind)
                self.same(found, points(name))
                self.assertEqual(found.kind, kind)
        again = pickle.loads(pickle.dumps(found))
        np.testing.assert_array_equal(again.y, found.y)
        self.assertEqual((again.kind, again.notes, repr(again)), (found.kind, found.notes, repr(found)))
        for wrong in ((np.zeros(5), np.zeros(4)), (np.zeros((2, 2)), np.zeros((2, 2)))):
            with self.assertRaises(ValueError):
                kstrip.oriented(*wrong)
        with self.assertRaises(kstrip.ProfileError) as caught:
            kstrip.oriented([1.0, 2.0, np.nan, 3.0, 4.0], [0.0] * 5)
        self.assertIn("finite", str(pickle.loads(pickle.dumps(caught.exception))))

    def test_hostile_files(self):
        """Random bytes, files cut anywhere and huge numbers are read or refused, in Python and in C, within 200 MB."""
        random = np.random.default_rng(70)
        wheel = points("s1002")
        sources = ["\n".join(lines).encode() for lines in (
            simpack(wheel, True), miniprof(wheel), [f"{y},{z}" for y, z in wheel], ["y;z", *(f"{y};{z}".replace(".", ",") for y, z in wheel)],
            ["WHEELPROFILE", "t", "TREADDATUM EUROPEAN", "FLANGEBACK 1360", *(f"{y} {z} {y} {z}" for y, z in wheel)],
            [json.dumps(wheel.tolist())], ["[Profile1Info]", "MPDC=3", *(f"MPD{k}=L 1 2 3 {k}" for k in range(9))])]
        hostile = [b"", b"\n" * 1000, b"[" * 100000, b"{" * 100000, b'"' * 9999, b"1e999 1e999\n" * 9, b"1e308 1\n-1e308 2\n" * 9, b"9" * 100000,
                   (b"1" * 5000 + b" 2\n") * 9, b"XYPoints=99999999999999999999\n1 2\n", b"1,2,3,4\n" * 9, b"0\nSECTION\n", b"\xff\xfe1", b"1_0 2_0\n" * 9,
                   b"spline.end\n", b"header.begin\nheader.end\nheader.end\nheader.end\n", b"1 2\n" * 3, b"\x00" * 4096, b"1e-320 1e-320\n" * 9]
        for _ in range(150):
            source = bytearray(sources[random.integers(len(sources))])
            for _ in range(random.integers(1, 6)):
                at = int(random.integers(max(len(source), 1)))
                change = random.integers(4)
                if change == 0:
                    source = source[:at]
                elif change == 1:
                    source[at : at + 3] = random.bytes(int(random.integers(8)))
                elif change == 2:
                    source[at:at] = [b"1e999", b"-1e300", b"9999999999999999999999", b"\n", b"=", b'"', b",", b"nan", b"1e-400"][random.integers(9)]
                elif source:
                    del source[at : at + int(random.integers(200))]
            hostile.append(bytes(source))
        hostile += [random.bytes(2000) for _ in range(50)]
        # Words that may be units, in one long line: a search of the line for each word takes hours
        hostile += [line + b" " + b"in mm " * 300000 + b"\n1 2\n2 3\n3 5\n4 9\n" for line in (b"", b"#")]
        tracemalloc.start()
        self.addCleanup(tracemalloc.stop)
        read = 0
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            for k, content in enumerate(hostile):
                path = self.folder / ("a.prw", "a.whl", "a.txt", "a.csv", "a.json", "a.mpt")[k % 6]
                path.write_bytes(content)
                with self.subTest(content=content[:60]):
                    status, y, z, _ = self.in_c(path)
                    self.assertTrue(status < 0 or (y.size >= 4 and np.isfinite(y).all() and np.isfinite(z).all()), status)
                    try:
                        found = kstrip.read_profile(path)
                    except kstrip.ProfileError:
                        continue
                    read += 1
                    self.assertTrue(np.isfinite(found.y).all() and np.isfinite(found.z).all() and found.y.size >= 4)
        self.assertGreater(read, 5)
        self.assertLess(tracemalloc.get_traced_memory()[1], 200e6)

    def test_a_million_lines(self):
        """Long files of each format come out as short ones; most of their lines are converted many at once."""
        y = np.linspace(-70.0, 60.0, 1_000_000)
        values = np.c_[y, np.interp(y, *points("s1002").T)]
        plain = [f"{a:.6f} {b:.6f}" for a, b in values]
        for name, lines in (
            ("a.txt", ["y_mm z_mm", *plain]),
            ("a.csv", ["y_mm;z_mm", *(row.replace(" ", ";").replace(".", ",") for row in plain)]),
            ("a.prw", [*simpack(values[:1], True)[:-3], *plain[:-1], f"{plain[-1]}  ! the last one", "point.end", "spline.end"]),
            ("a.whl", [*miniprof(values[:1])[:-1], "Origin=running circle", *plain, "END"]),
        ):
            path = self.folder / name
            path.write_text("\n".join(lines) + "\n")
            found = kstrip.read_profile(path)
            with self.subTest(name):
                self.assertEqual(found.kind, "wheel")
                np.testing.assert_allclose(found.y, 1e-3 * y, atol=1e-9)
                np.testing.assert_allclose(found.z, 1e-3 * values[:, 1], atol=1e-9)

    def test_words_after_the_points_of_an_instrument(self):
        rail = points("uic60")
        for footer in (["END"], ["", "End of the file, 12:30", "(Sd/Sh/qR) 32.58 37.11"], ["[Profile1End]"]):
            found = self.read("a.ban", miniprof(rail) + footer)
            with self.subTest(footer):
                self.same(found, rail, 1e-8)
                self.assertEqual((self.warned, "stand after the points" in "".join(found.notes)), ([], footer[-1][0] != "["))
        for lines, line in ((miniprof(rail)[:50] + ["END"] + miniprof(rail)[50:], 51), (miniprof(rail) + ["12.5 abc"], 489)):
            with self.assertRaisesRegex(kstrip.ProfileError, "numbers are needed") as caught:
                self.read("a.ban", lines)
            self.assertEqual(caught.exception.line, line)

    def test_tables_without_unit_that_are_at_most_twelve_wide(self):
        """Wheels and rails of their size in inches are inches; rollers and grooves are mm. Both with a warning."""
        for name in WHEELS + RAILS:
            values = points(name)
            for sign in ((1, 1), (-1, -1)):
                for kind in (None, "wheel" if name in WHEELS else "rail"):
                    found = self.read("in.txt", [f"{y:.9f} {z:.9f}" for y, z in values * sign / 25.4], kind=kind)
                    with self.subTest(name=name, sign=sign, kind=kind):
                        self.same(found, values, 1e-8)
                        self.assertTrue(any("taken as inches" in warning for warning in self.warned))
        for width in (3.0, 8.0, 12.0):
            y = np.linspace(-width / 2, width / 2, 201)
            share = 2 * y / width
            groove = np.sqrt(4.0 * width**2 - y**2) - 2 * width
            for shape in (y**2 / 400, -0.005 * np.log(1 - 0.995 * share**2), 2.0 * np.maximum(0, abs(share) - 0.9), groove):
                for kind in ("wheel", "rail", None):
                    found = self.read("mm.txt", [f"{a:.9f} {b:.9f}" for a, b in np.c_[y, shape]], kind=kind)
                    with self.subTest(width=width, kind=kind):
                        self.assertAlmostEqual(np.ptp(found.y), 1e-3 * width, delta=1e-9)
                        self.assertTrue(any("taken as mm" in warning for warning in self.warned))

    def test_a_rail_that_may_be_a_groove_stands_as_the_caller_has_it(self):
        """Grooves for balls, whose shape is that of a rail upside down; a roller has no groove, and is turned with a warning."""
        for radius, half in ((5.2, 4.0), (10.1, 7.0), (10.1, 3.0), (40.0, 9.0)):
            y = np.linspace(-half, half, 201)
            groove = np.c_[y, np.sqrt(radius**2 - y**2) - radius]
            rows = [f"{a:.8f} {b:.8f}" for a, b in groove]
            with self.subTest(radius=radius, half=half):
                found = self.read("groove.txt", rows, kind="rail", units="mm")
                self.same(found, groove, 1e-8)
                self.assertTrue(any("mirror_z= says which" in warning for warning in self.warned))
                self.same(self.read("groove.txt", rows, kind="rail", units="mm", mirror_z=False), groove, 1e-8)
                self.assertEqual(self.warned, [])
                found = self.read("roller.txt", rows, kind="wheel", units="mm")
                self.same(found, groove, 1e-8)
                self.assertEqual(self.warned, [])
                found = self.read("roller.txt", [f"{a:.8f} {-b:.8f}" for a, b in groove], kind="wheel", units="mm")
                self.same(found, groove, 1e-8)
                self.assertTrue(any("mirror_z=False keeps it" in warning for warning in self.warned))
        # A head of a rail has the width or the depth of none
        y = np.linspace(-30.0, 30.0, 121)
        self.same(self.read("top.txt", [f"{a:.6f} {-(a**2) / 600:.8f}" for a in y], kind="rail"), np.c_[y, y**2 / 600], 1e-8)
        self.assertTrue(any("mirror_z=False keeps it" in warning for warning in self.warned))
        self.same(self.read("head.txt", [f"{a:.6f} {-(a**2) / 60:.8f}" for a in y], kind="rail"), np.c_[y, y**2 / 60], 1e-8)
        self.assertEqual(self.warned, [])

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
        wheel = kstrip.Profile(*1e-3 * points("avgwhl").T, "wheel")
        kstrip.write_profile(self.folder / "flange_back.whl", wheel)
        self.same(kstrip.read_profile(self.folder / "flange_back.whl"), points("avgwhl"))


if __name__ == "__main__":
    unittest.main()
