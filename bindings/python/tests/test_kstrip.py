"""python -m unittest discover bindings/python/tests; needs libkstrip (make) and numpy."""

import dataclasses
import os
import pathlib
import pickle
import re
import sys
import unittest
import warnings

sys.path.insert(0, os.path.join(os.path.dirname(__file__), os.pardir))

import numpy as np

import kstrip
from kstrip._status import gravity
import platform_tag
import read_header
import wheel_on_rail as scene

STEEL = dict(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
CONTACT = kstrip.contact(**STEEL)
BOUND = 0.3 * 80e3
WET = kstrip.friction(0.3, 0.4, 0.6, 20.0)


def quiet(test):
    """Without the warnings that a test is not about."""

    def run(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", kstrip.KstripWarning)
            test(self)

    return run


class Binding(unittest.TestCase):
    def test_everything_of_the_headers_is_there(self):
        folder = pathlib.Path(__file__).resolve().parents[3] / "include"
        code, single = (re.sub(r"/\*.*?\*/", "", (folder / name).read_text(encoding="utf-8"), flags=re.S) for name in ("kstrip.h", "kstrip_f32.h"))
        declared = set(re.findall(r"\b(kstrip_\w+)\(", code + single))
        self.assertEqual(declared, {name for name in declared if getattr(kstrip.lib, name).argtypes is not None})
        named = set(re.findall(r"typedef struct kstrip_(\w+)", code + single))
        self.assertEqual(named | {"options_f32", "table_f32"}, set(kstrip.dtypes))
        self.assertEqual(read_header.constants(code), kstrip.constants)
        self.assertEqual(np.zeros(2, kstrip.dtypes["derivatives"])["jacobian"][0].shape, (3, 3))
        self.assertIn("contact, creepage", kstrip.lib.kstrip_solve.__doc__)

    @quiet
    def test_creep_curve_is_the_closed_form(self):
        # Section 8.15: 1 - ((2 + tau^2) sqrt(1 - tau^2) - 3 tau acos tau)/2
        creepage = np.linspace(0, 0.01, 200)
        curve = kstrip.solve(CONTACT, kstrip.creepage(longitudinal=creepage), model="strip_1967", strips=64)
        pressure = 1.5 * 80e3 / (np.pi * 6e-3 * 4.5e-3)
        tau = np.minimum(creepage * 82e9 / (2 * 0.72 * 0.3 * pressure), 1)
        force = 1 - ((2 + tau**2) * np.sqrt(1 - tau**2) - 3 * tau * np.arccos(tau)) / 2
        np.testing.assert_allclose(curve["fx"] / BOUND, force, atol=1e-6)
        np.testing.assert_array_equal(curve["status_detail"], 0)

    def test_batch_is_the_scalar_call_and_broadcasts(self):
        contacts = kstrip.contact(**{**STEEL, "friction": np.array([[0.1], [0.3]])})
        motions = kstrip.creepage(longitudinal=np.array([0.0, 1e-3, 2e-3]), spin=0.2)
        results = kstrip.solve(contacts, motions)
        self.assertEqual(results.shape, (2, 3))
        one = np.zeros((), kstrip.dtypes["result"])
        for i in range(2):
            for j in range(3):
                contact, motion = contacts.data[i, 0].tobytes(), motions.data[j].tobytes()
                status = kstrip.lib.kstrip_solve(contact, motion, None, one.ctypes.data)
                self.assertEqual(status, 0)
                self.assertEqual(one.tobytes(), results.data[i, j].tobytes())
                self.assertEqual(kstrip.solve(contacts[i, 0], motions[j]), results[i, j])
        # One contact for all, by distance zero
        self.assertEqual(kstrip.solve(contacts[1, 0], motions), results[1])
        self.assertEqual(kstrip.solve(CONTACT, kstrip.creepage(np.zeros((0, 4)))).shape, (0, 4))

    def test_any_dtype_and_shape_is_converted(self):
        motions = kstrip.creepage(np.linspace(0, 2e-3, 5), 1e-4, 0.2)
        expected = kstrip.solve(CONTACT, motions)
        # Mixed precision is double, another order of elements a copy
        mixed = kstrip.solve(CONTACT, kstrip.creepage(np.linspace(0, 2e-3, 5), 1e-4, 0.2, dtype=np.float32))
        np.testing.assert_allclose(mixed["fx"], expected["fx"], atol=1e-5 * BOUND)
        self.assertEqual(kstrip.solve(CONTACT, motions[::-1])[::-1], expected)
        self.assertEqual(kstrip.solve(CONTACT, kstrip.Batch(kstrip.Creepage, list(motions))), expected)
        for wrong in (np.zeros(10**7), 1e-3, "creepage", None, CONTACT, motions.data, motions["spin"]):
            with self.assertRaises(TypeError):
                kstrip.solve(CONTACT, wrong)
        with self.assertRaises(ValueError):
            kstrip.solve(kstrip.contact(**{**STEEL, "a": [1e-3, 2e-3]}), kstrip.creepage([0.0] * 3))
        # One is one: nothing is taken silently from several
        for call in (kstrip.strips, lambda c, m: kstrip.field(c, m, [0.0], [0.0])):
            with self.assertRaises(ValueError):
                call(CONTACT, motions)
        with self.assertRaises(TypeError):
            kstrip.creepage(1j)

    def test_messages_name_argument_and_kind(self):
        motion, radii = kstrip.creepage(1e-3), kstrip.radii()
        for call, kind, words in [
            (lambda: kstrip.solve(CONTACT, CONTACT), TypeError, ["creepages: a Creepage", "kstrip.creepage(longitudinal", "this is a Contact"]),
            (lambda: kstrip.solve((6e-3, 4e-3), motion), TypeError, ["contacts: a Contact", "kstrip.contact(a, b", "this is a tuple"]),
            (lambda: kstrip.solve(CONTACT, [1e-3, [0]]), TypeError, ["creepages: a Creepage", "this is a list"]),
            (lambda: kstrip.solve(np.float32([1, 2]), motion), TypeError, ["contacts: a Contact", "an array of float32"]),
            (lambda: kstrip.solve(CONTACT, motion, 0.3), TypeError, ["friction: a Friction", "kstrip.friction(", "this is a float"]),
            (lambda: kstrip.contact(**{**STEEL, "a": "6 mm"}), TypeError, ["contact.a: real numbers are needed"]),
            (lambda: kstrip.solve(dataclasses.replace(CONTACT, a="6 mm"), motion), TypeError, ["contact.a: a real number is needed, not '6 mm'"]),
            (lambda: kstrip.solve(dataclasses.replace(CONTACT, a=None), motion), TypeError, ["contact.a: a real number is needed, not None"]),
            (lambda: kstrip.solve(dataclasses.replace(CONTACT, a=np.ones(3)), motion), ValueError, ["contact.a: one number is needed", "(3,)"]),
            (lambda: kstrip.wheel_motion(dataclasses.replace(CONTACT), motion), TypeError, ["contacts: a WheelContact"]),
            (lambda: kstrip.contact_from_hertz(radii, (82e9, 0.28), 1.0, 0.3), TypeError, ["pair: a CombinedMaterial", "kstrip.combine("]),
            (lambda: kstrip.contact_from_hertz(radii, kstrip.combine((1.0, 0.3), (1.0, 0.3)), "1 kN", 0.3), TypeError, ["load: real numbers are needed"]),
            (lambda: kstrip.combine((82e9,), (82e9, 0.28)), ValueError, ["lower: the shear modulus"]),
            (lambda: kstrip.solve(CONTACT, motion, model=1.5), TypeError, ["model is a name or a number"]),
            (lambda: kstrip.solve(CONTACT, motion, on_error="ignore"), ValueError, ["on_error: 'raise' or 'nan'"]),
            (lambda: kstrip.prepare_profile([0, 1, 2, "x"], [0] * 4), TypeError, ["y: real numbers"]),
            (lambda: kstrip.gauge_face(scene.RAIL, "deep"), TypeError, ["depth: real numbers"]),
            (lambda: kstrip.fit_friction([1e-3], [1e3], CONTACT, fit=("speed",)), ValueError, ["fit: speed is none of"]),
        ]:
            with self.assertRaises(kind) as raised:
                call()
            for word in words:
                self.assertIn(word, str(raised.exception))

    @quiet
    def test_single_and_double_go_together(self):
        single, double = kstrip.creepage([1e-3], dtype=np.float32), kstrip.contact(**{**STEEL, "a": [6e-3]})
        mixed = kstrip.solve(double, single).fx
        self.assertEqual((mixed.dtype, mixed[0]), (np.float64, kstrip.solve(CONTACT, kstrip.creepage(float(np.float32(1e-3)))).fx))
        # A value has the precision of the batch beside it.
        self.assertEqual(kstrip.solve(CONTACT, single).fx.dtype, np.float32)

    def test_single_precision(self):
        single = kstrip.solve(kstrip.contact(**STEEL, dtype=np.float32), kstrip.creepage(1e-3, dtype=np.float32))
        double = kstrip.solve(CONTACT, kstrip.creepage(1e-3))
        self.assertEqual((single["fx"].dtype, single.shape), (np.float32, ()))
        self.assertLess(abs(single["fx"] - double["fx"]), 2e-6 * BOUND)

    def test_derivatives_are_those_of_differences(self):
        h = 1e-7
        answer = kstrip.evaluate(CONTACT, kstrip.creepage(1e-3, 5e-4, 0.3), law_derivatives=True)
        for column, step in enumerate(np.eye(3) * [h, h, h * 100]):
            ahead, behind = (kstrip.solve(CONTACT, kstrip.creepage(*(np.array([1e-3, 5e-4, 0.3]) + s))) for s in (step, -step))
            for row, force in enumerate(("fx", "fy", "mz")):
                slope = (ahead[force] - behind[force]) / (2 * step[column])
                self.assertLess(abs(answer.derivatives["jacobian"][row, column] - slope), 1e-5 * abs(slope) + 1.0)
        self.assertEqual(answer.result, kstrip.solve(CONTACT, kstrip.creepage(1e-3, 5e-4, 0.3)))
        self.assertEqual(answer.friction, 0.3)
        self.assertIsNone(kstrip.evaluate(CONTACT, kstrip.creepage(1e-3), derivatives=False).derivatives)

    def test_falling_friction(self):
        wet = kstrip.evaluate(CONTACT, kstrip.creepage([1e-3, 0.1, 1.0]), WET, law_derivatives=True)
        self.assertTrue((np.diff(wet.friction) < 0).all())
        self.assertLess(abs(wet.result["fx"][2] - wet.friction[2] * 80e3), 1e-3 * BOUND)
        self.assertEqual(wet.law_derivatives["ratio"].shape, (3, 3))

    def test_inside(self):
        motion = kstrip.creepage(3e-4, 0.0, 0.6)
        found = kstrip.strips(CONTACT, motion, strips=32)
        self.assertEqual(len(found), 32)
        total = kstrip.solve(CONTACT, motion, model="strip", strips=32)
        self.assertLess(abs(found["fy"].sum() - total["fy"]), 1e-6 * BOUND)
        points = kstrip.field(CONTACT, motion, [0.0, 1e-3, 7e-3], [0.0, 2e-3])
        self.assertEqual(points.shape, (2, 3))
        self.assertTrue((points["state"][:, 2] == kstrip.OUTSIDE).all())
        self.assertAlmostEqual(points["pressure"][0, 0] / (1.5 * 80e3 / (np.pi * 6e-3 * 4.5e-3)), 1.0, places=2)

    def test_fields_behind_a_layer_add_up_to_the_forces(self):
        law = kstrip.friction(0.35, 0.5, 0.3, 10.0, slope_factor=0.8, slide_factor=0.6, layer=2e-14)
        motion = kstrip.creepage(2e-3, 1e-3, 0.2)
        x, y = np.linspace(-6.2e-3, 6.2e-3, 249), np.linspace(-4.7e-3, 4.7e-3, 189)
        cell = (x[1] - x[0]) * (y[1] - y[0])
        for area in (CONTACT, kstrip.patch_from_contact(CONTACT, strips=32)):
            found = kstrip.evaluate(area, motion, law, model="strip", strips=32).result
            points = kstrip.field(area, motion, x, y, model="strip", strips=32, friction=law)
            for force, traction in (("fx", "traction_x"), ("fy", "traction_y")):
                self.assertLess(abs(points[traction].sum() * cell - found[force]), 0.02 * BOUND)
            self.assertTrue((points["dissipation"] >= 0).all())
            clean = kstrip.field(area, motion, x, y, model="strip", strips=32)
            self.assertGreater((clean["traction_x"] - points["traction_x"]).sum() * cell, 0.05 * BOUND)

    def test_motion_stops_and_reverses(self):
        speeds = np.array([-10.0, 0.0, 10.0])
        answer = kstrip.solve_motion(CONTACT, kstrip.motion(slip_x=[1e-3, 1e-5, 1e-3], rolling_speed=speeds))
        self.assertTrue((answer.result["power"] > 0).all())
        self.assertAlmostEqual(answer.result["fx"][0], answer.result["fx"][2])
        self.assertEqual(answer.derivatives["slip"].shape, (3, 3, 3))
        self.assertTrue((answer.derivatives["slip"][:, 0, 0] > 0).all())

    def test_prepared_contact_has_the_same_bits(self):
        motions = kstrip.creepage(np.linspace(-1e-3, 1e-3, 7), 2e-4, 0.1)
        for model in ("default", "strip", "linear"):
            prepared = kstrip.prepare(CONTACT, model)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                self.assertEqual(prepared.solve(motions), kstrip.solve(CONTACT, motions, model=model))
                self.assertEqual(prepared.solve(motions[2]), kstrip.solve(CONTACT, motions[2], model=model))

    def test_patches(self):
        y = np.linspace(-12e-3, 12e-3, 241)
        # Two bottoms: two lobes, whose bound no force exceeds and full sliding reaches
        distance = 70e-6 * ((y / 4.5e-3) ** 2 - 1) ** 2
        steel = dict(rolling_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, friction=0.35)
        patch, found = kstrip.patch_from_profile(y, distance, normal_force=80e3, **steel)
        self.assertLess(abs(found["normal_force"] - 80e3), 1e-6 * 80e3)
        self.assertEqual(kstrip.patch_summary(patch)["lobes"], 2)
        motions = kstrip.creepage([1e-4, 1.0])
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            forces = kstrip.solve(patch, motions)
            wet = kstrip.evaluate(patch, motions, kstrip.friction(0.35, 0.4, 0.6, 20.0))
        self.assertLess(abs(forces["fx"][1] - 0.35 * 80e3), 1e-3 * 28e3)
        self.assertTrue(0 < forces["fx"][0] < forces["fx"][1])
        self.assertAlmostEqual(wet.friction[1], 0.4 + 0.6 * np.exp(-12.0))
        self.assertAlmostEqual(wet.result["fx"][1] / forces["fx"][1], wet.friction[1])
        self.assertEqual(len(kstrip.strips(patch, motions[0])), patch["count"])
        self.assertEqual(kstrip.field(patch, motions[0], [0.0], y).shape, (241, 1))
        ellipse = kstrip.patch_from_contact(CONTACT)
        same = kstrip.solve(CONTACT, kstrip.creepage(1e-3), model="strip")
        self.assertLess(abs(kstrip.solve(ellipse, kstrip.creepage(1e-3))["fx"] - same["fx"]), 1e-9 * BOUND)
        # Strips with all of a rigid motion as their own; one with more
        places = ellipse["strips"][: ellipse["count"]]
        own = kstrip.creepage(1e-3 - 0.2 * places["y"], 2e-4, 0.2)
        rest, rigid = kstrip.creepage(0.0), kstrip.creepage(1e-3, 2e-4, 0.2)
        wet_law = kstrip.friction(0.3, 0.4, 0.6, 20.0)
        expected, found = kstrip.evaluate(ellipse, rigid, wet_law), kstrip.evaluate(ellipse, rest, wet_law, own=own)
        self.assertLess(np.abs(found.result["fx"] - expected.result["fx"]), 1e-9 * BOUND)
        np.testing.assert_allclose(found.derivatives.jacobian, expected.derivatives.jacobian, rtol=1e-6, atol=1e-3)
        own["longitudinal"][8] += 1e-3
        moved = kstrip.strips(ellipse, rest, own=own)
        self.assertLess(abs(moved["fx"].sum() - kstrip.evaluate(ellipse, rest, own=own).result["fx"]), 1e-9 * BOUND)
        self.assertGreater(moved["fx"].sum() - kstrip.solve(ellipse, rigid)["fx"], 1.0)
        with self.assertRaisesRegex(ValueError, "own: shape .3,., and the patch has 16 strips"):
            kstrip.evaluate(ellipse, rest, own=own[:3])
        with self.assertRaisesRegex(ValueError, "own is for one patch"):
            kstrip.evaluate(CONTACT, rest, own=own)
        copied = kstrip.patch_from_strips(ellipse["strips"][: ellipse["count"]], 82e9, 0.28)
        self.assertEqual(copied["count"], 16)
        patch["strips"]["friction"] = 0.0
        self.assertEqual(kstrip.solve(patch, kstrip.creepage(1e-3))["fx"], 0)
        patch["count"] = 1000
        with self.assertRaises(kstrip.KstripError):
            kstrip.strips(patch, motions[0])
        with self.assertRaises(kstrip.KstripError) as caught:
            kstrip.solve(ellipse, kstrip.creepage([1e-3, np.nan, 2e-3]))
        self.assertEqual((caught.exception.index, caught.exception.statuses.tolist()), ((1,), [0, -2, 0]))
        self.assertEqual(caught.exception.results.fx[2], kstrip.solve(ellipse, kstrip.creepage(2e-3)).fx)

    def test_bodies(self):
        pair = kstrip.combine((82e9, 0.28), (82e9, 0.28))
        self.assertEqual(pair["mismatch"], 0)
        balls = kstrip.radii(upper_x=0.1, upper_y=0.1)
        contacts, ellipses = kstrip.contact_from_hertz(balls, pair, [1e3, 2e3, 0.0], 0.3)
        # Circle: a^3 = 3 N R/(4 E*)
        self.assertLess(abs(contacts["a"][0] ** 3 / (0.75 * 1e3 * 0.1 * 0.72 / 82e9) - 1), 1e-9)
        back, stiffness = kstrip.contact_from_approach(balls, pair, ellipses["approach"], 0.3)
        np.testing.assert_allclose(back["normal_force"], [1e3, 2e3, 0.0], rtol=1e-9)
        self.assertAlmostEqual(stiffness[0] / (1.5 * 1e3 / ellipses["approach"][0]), 1.0)
        # A lost contact is an ordinary input
        self.assertEqual(kstrip.solve(contacts, kstrip.creepage(1e-3))["fx"][2], 0)
        self.assertAlmostEqual(kstrip.linear_coefficients(1.0, 0.25)[0], 4.12, places=1)

    def test_motion_and_parameters(self):
        lower, upper = kstrip.velocity(-20.0), kstrip.velocity(-19.98, 0.01, 2.0)
        creepage = kstrip.creepage_from_velocities(lower, upper, 20.0)
        self.assertAlmostEqual(creepage["longitudinal"], 1e-3)
        numbers = kstrip.parameters_from_creepage(CONTACT, creepage)
        self.assertAlmostEqual(kstrip.creepage_from_parameters(CONTACT, numbers)["spin"], creepage["spin"])

    def test_rig(self):
        motion = kstrip.creepage(1e-3, 5e-4, 0.2)
        forces = kstrip.solve(CONTACT, motion)
        found = kstrip.estimate_friction(CONTACT, motion, fx=forces["fx"], fy=forces["fy"])
        self.assertAlmostEqual(float(found["friction"]), 0.3)
        back = kstrip.creepage_for_force(CONTACT, forces["fx"], forces["fy"], 0.2)
        self.assertAlmostEqual(float(back["lateral"]), 5e-4)

    def test_measured_curve_becomes_a_law(self):
        path = os.path.join(os.path.dirname(__file__), *[os.pardir] * 3, "tests", "data", "eurosprinter_measured.csv")
        percent, share = np.loadtxt(path, delimiter=",", skiprows=1, usecols=(0, 1)).T
        load = 106.7e3
        locomotive = kstrip.contact(a=6.304e-3, b=12.61e-3, normal_force=load, shear_modulus=82e9, poisson_ratio=0.28, friction=0.33)
        start = kstrip.friction(0.35, 0.5, 0.3, 10.0, slope_factor=0.3)
        members = ("friction", "ratio", "decay", "slope_factor", "slide_factor")
        found = kstrip.fit_friction(percent / 100, share * load, locomotive, start=start, fit=members)
        self.assertAlmostEqual(float(found.residual) / load, 0.0241, delta=0.0005)
        again = kstrip.solve(locomotive, kstrip.creepage(percent / 100), found.law).fx - share * load
        self.assertAlmostEqual(float(np.sqrt(np.mean(again**2)) / found.residual), 1.0, delta=1e-9)
        self.assertTrue(0.0 < found.standard_errors.friction < 0.01 and found.law.rolling_speed == 10.0, found)
        self.assertEqual(found.standard_errors.layer, 0.0)

    def test_law_is_found_from_both_forces(self):
        law = kstrip.friction(0.3, layer=1.2e-13)
        motion = kstrip.creepage(2e-4 * np.arange(1, 13) ** 2, 1e-4 * np.arange(1, 13) ** 2, 0.1)
        made = kstrip.solve(CONTACT, motion, law)
        forces = np.stack([made.fx, made.fy], axis=-1)
        forces[3, 0] = np.nan
        found = kstrip.fit_friction(motion, forces, CONTACT, fit=("friction", "layer"))
        self.assertAlmostEqual(float(found.law.friction), 0.3, delta=1e-6)
        self.assertAlmostEqual(float(found.law.layer) / 1.2e-13, 1.0, delta=1e-4)
        place = kstrip.creepage(2e-3)
        one = kstrip.estimate_friction(CONTACT, place, fx=kstrip.solve(CONTACT, place, law).fx, law=law)
        self.assertAlmostEqual(float(one.friction), 0.3, delta=1e-5)

    def test_bad_measured_points_are_named(self):
        creepage, force = np.linspace(1e-4, 1e-2, 8), np.linspace(1e3, 2e4, 8)
        with self.assertRaises(kstrip.KstripError) as caught:
            kstrip.fit_friction(creepage[:1], force[:1], CONTACT)
        self.assertEqual(caught.exception.name, "KSTRIP_ERROR_FEW_POINTS")
        for bad, name in ((np.inf, "KSTRIP_ERROR_NOT_FINITE"), (np.nan, "KSTRIP_ERROR_MEASURED")):
            with self.assertRaises(kstrip.KstripError) as caught:
                kstrip.fit_friction(creepage, np.where(np.arange(8) == 5, bad, force), CONTACT)
            self.assertEqual((caught.exception.name, caught.exception.index), (name, (5,)))

    def test_upper_body(self):
        forces = kstrip.solve(CONTACT, kstrip.creepage(1e-3, 2e-3))
        self.assertEqual(kstrip.on_upper_body(forces)["fy"], -forces["fy"])

    def test_errors_have_status_name_and_index(self):
        friction = np.full((2, 3), 0.3)
        friction[1, 2] = -1.0
        with self.assertRaises(kstrip.KstripError) as caught:
            kstrip.solve(kstrip.contact(**{**STEEL, "friction": friction}), kstrip.creepage(1e-3))
        self.assertEqual(caught.exception.status, kstrip.constants["KSTRIP_ERROR_FRICTION"])
        self.assertEqual((caught.exception.name, caught.exception.index), ("KSTRIP_ERROR_FRICTION", (1, 2)))
        self.assertIn("KSTRIP_ERROR_FRICTION at index (1, 2)", str(caught.exception))
        self.assertIn("contacts: Contact(a=0.006 m, b=0.0045 m, normal_force=80000 N, shear_modulus=8.2e+10 Pa, poisson_ratio=0.28, friction=-1", str(caught.exception))
        with self.assertRaises(kstrip.KstripError):
            kstrip.field(CONTACT, kstrip.creepage(1e-3), [0.0], [0.0], "total")
        with self.assertRaises(ValueError):
            kstrip.solve(CONTACT, kstrip.creepage(1e-3), model="best")
        for number in (99, 1 << 32, -(1 << 70)):
            with self.assertRaises(kstrip.KstripError):
                kstrip.solve(CONTACT, kstrip.creepage(1e-3), model=number)

    def test_the_most_serious_warning_is_told(self):
        page = os.path.join(os.path.dirname(__file__), *[os.pardir] * 3, "docs", "maintain", "bad-input.md")
        with open(page, encoding="utf-8") as text:
            order = text.read().split("## Which warning is returned")[1].split("\nThe status of a batch")[0]
        lines = [re.findall(r"`(KSTRIP_WARNING_\w+)`", line) for line in re.split(r"\n\d\. ", order)[1:]]
        named = [name for line in lines for name in line]
        self.assertEqual(set(named), {name for name in kstrip.constants if name.startswith("KSTRIP_WARNING_")})
        told = sorted(named, key=lambda name: gravity(kstrip.constants[name]), reverse=True)
        self.assertEqual(told, [name for line in lines for name in sorted(line, key=lambda name: -kstrip.constants[name])])
        self.assertTrue(all(gravity(1) > gravity(status) for status in (0, -1)))

    def test_warnings_are_warnings(self):
        with self.assertWarnsRegex(kstrip.KstripWarning, "KSTRIP_WARNING_CREEPAGE at index 1") as caught:
            kstrip.solve(CONTACT, kstrip.creepage([1e-3, 20.0]))
        self.assertEqual(os.path.basename(caught.filename), "test_kstrip.py")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            kstrip.solve(CONTACT, kstrip.creepage(1e-3))
            with self.assertRaises(kstrip.KstripWarning):
                kstrip.solve(kstrip.contact(**{**STEEL, "shear_modulus": 82.0}), kstrip.creepage(1e-3))


class Packaging(unittest.TestCase):
    def test_platform_tags_of_linux(self):
        glibc = ["manylinux_2_36_x86_64", "manylinux_2_17_x86_64", "linux_x86_64"]
        musl = ["musllinux_1_2_x86_64", "musllinux_1_1_x86_64", "linux_x86_64"]
        for needed, versions, accepted, tag in [
            ({"libc.so.6"}, ["GLIBC_2.2.5"], glibc, "manylinux_2_17_x86_64"),
            ({"libc.so.6"}, ["GLIBC_2.2.5", "GLIBC_2.29"], glibc, "manylinux_2_29_x86_64"),
            ({"libc.so.6", "libgcc_s.so.1"}, [], glibc, "linux_x86_64"),
            ({"libc.musl-x86_64.so.1"}, [], musl, "musllinux_1_2_x86_64"),
            (set(), [], musl, "musllinux_1_2_x86_64"),
            ({"libc.so"}, [], musl, "musllinux_1_2_x86_64"),
            ({"libc.musl-x86_64.so.1", "libgcc_s.so.1"}, [], musl, "linux_x86_64"),
        ]:
            self.assertEqual(platform_tag.linux("linux_x86_64", needed, versions, accepted), tag)


class WheelOnRail(unittest.TestCase):
    """The functions of the scene, and the example bindings/python/wheel_on_rail.py."""

    VELOCITY = kstrip.wheel_velocity(forward=20.0, pitch=-43.6, lateral=0.02)

    def test_rail_carries_the_load_and_friction_bounds_the_rest(self):
        found = kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), scene.carried(1e-3), self.VELOCITY, by_position=True)
        contact, wrench = found.contacts[0], found.wrench
        self.assertEqual((len(found.contacts), int(wrench["contacts"])), (1, 1))
        self.assertAlmostEqual(float(contact["normal_force"] * contact["normal"][2]), scene.LOAD, delta=1e-6 * scene.LOAD)
        fx, fy, _ = wrench["force"]
        self.assertGreater(fx, 0.0)
        self.assertLess(np.hypot(fx, fy), 0.32 * scene.LOAD)
        # creep forces take from the wheel what friction dissipates; pressure does no work but by the normal velocity
        velocity = np.array([self.VELOCITY[name] for name in ("forward", "lateral", "vertical", "roll", "pitch", "yaw")], float)
        given = float(np.concatenate([wrench["force"], wrench["moment"]]) @ velocity)
        pressed = -float(contact["normal_force"] * (contact["normal"] @ velocity))
        self.assertAlmostEqual(given - pressed, -float(wrench["dissipation"]), delta=1e-9 * abs(given) + 1e-3)
        # derivatives with respect to height: differences
        place = scene.carried(1e-3)
        sides = []
        for step in (-1e-6, 1e-6):
            moved = dataclasses.replace(place, vertical=place.vertical + step)
            sides.append(kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), moved, self.VELOCITY).wrench["force"][2])
        slope = (sides[1] - sides[0]) / 2e-6
        self.assertAlmostEqual(float(found.by_position["vertical"][2]) / slope, 1.0, delta=1e-3)

    def test_many_wheels_are_single_ones(self):
        self.enterContext(warnings.catch_warnings(action="ignore", category=kstrip.KstripWarning))
        # a yawed wheel has two contacts at some of these positions
        place = kstrip.wheel_position(lateral=np.linspace(-5.3e-3, -4.7e-3, 60).reshape(3, 20), yaw=0.04)
        loads = np.linspace(140e3, 150e3, 20)
        place.vertical = kstrip.height_for_load(scene.RAIL, scene.WHEEL, scene.pair(), place, loads)
        many = kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, self.VELOCITY, by_position=True)
        most = many.contacts.shape[-1]
        self.assertEqual((many.contacts.shape, many.statuses.shape), ((3, 20, most), (3, 20)))
        self.assertGreater(most, 1)
        without = kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, self.VELOCITY, contacts=False)
        self.assertEqual((without.wrench, without.contacts.shape), (many.wrench, (3, 20, 0)))
        found = set()
        for at in np.ndindex(3, 20):
            one = kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place[at], self.VELOCITY, by_position=True)
            self.assertEqual((many.wrench[at], many.derivatives[at], many.by_position[at]), (one.wrench, one.derivatives, one.by_position))
            count = len(one.contacts)
            found.add(count)
            self.assertEqual((many.counts[at], one.counts), (count, count))
            self.assertEqual(many.contacts[at][:count], one.contacts)
            self.assertEqual(many.creepages[at][:count], one.creepages)
            self.assertFalse(many.contacts[at][count:].normal_force.any() or many.t_gamma[at][count:].any())
            height = kstrip.height_for_load(scene.RAIL, scene.WHEEL, scene.pair(), kstrip.wheel_position(lateral=place[at].lateral, yaw=0.04), loads[at[1]])
            self.assertEqual((type(height), height), (float, place[at].vertical))
        self.assertGreater(len(found), 1)

    def test_contacts_of_a_wheel_add_up_to_its_wrench(self):
        self.enterContext(warnings.catch_warnings(action="ignore", category=kstrip.KstripWarning))
        place = kstrip.wheel_position(lateral=np.linspace(-5.3e-3, -3.2e-3, 22), yaw=0.02)
        place.vertical = kstrip.height_for_load(scene.RAIL, scene.WHEEL, scene.pair(), place, 140e3)
        on = kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, self.VELOCITY)
        np.testing.assert_allclose(on.wrenches.force.sum(axis=1), on.wrench.force, rtol=1e-9, atol=1e-6)
        np.testing.assert_allclose(on.wrenches.dissipation.sum(axis=1), on.wrench.dissipation, rtol=1e-9)
        np.testing.assert_allclose((on.contacts.share * on.contacts.normal_force).sum(axis=1), on.wrench.normal_force, rtol=1e-9)
        one = kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place[-1], self.VELOCITY)
        contact, creepage = one.contacts[0], one.creepages[0]
        # T-gamma is the power that evaluate() has for the patch in motion, but for the slip of the strips of a curved contact
        power = kstrip.evaluate(contact.patch, creepage).result.power
        self.assertAlmostEqual(one.t_gamma[0] / power, 1.0, delta=0.02)

    def test_the_first_bad_wheel_of_many_is_named(self):
        place = kstrip.wheel_position(lateral=np.zeros((2, 150)))
        place.lateral[1, 120] = 0.5
        with self.assertRaisesRegex(kstrip.KstripError, r"\(1, 120\)"):
            kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, self.VELOCITY)

    def test_no_wheel_loses_the_others(self):
        place = scene.carried(np.zeros(3))
        place.lateral[1] = 0.5
        alone = kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place[0], self.VELOCITY)
        with self.assertRaises(kstrip.KstripError) as caught:
            kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, self.VELOCITY)
        quiet = kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, self.VELOCITY, on_error="nan")
        for on in (quiet, caught.exception.results):
            self.assertEqual(on.statuses.tolist(), [0, kstrip.constants["KSTRIP_ERROR_PROFILE_END"], 0])
            self.assertEqual((on.wrench[0], on.wrench[2], on.contacts[0, 0]), (alone.wrench, alone.wrench, alone.contacts[0]))
            self.assertTrue(np.isnan(on.wrench.force[1]).all() and np.isnan(on.derivatives.velocity[1]).all())
            self.assertEqual((on.wrench.status_detail[1], on.wrench.statuses.tolist()), (on.statuses[1], on.statuses.tolist()))
        statuses = np.zeros(3, np.int32)
        heights = kstrip.height_for_load(scene.RAIL, scene.WHEEL, scene.pair(), place, 80e3, on_error="nan", statuses=statuses)
        self.assertEqual((np.isnan(heights).tolist(), statuses.tolist()), ([False, True, False], quiet.statuses.tolist()))
        beside = kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place[1], self.VELOCITY, on_error="nan")
        self.assertTrue(np.isnan(beside.wrench.normal_force) and beside.statuses < 0 and len(beside.contacts) == 0)

    def test_left_wheel_is_the_mirror_image(self):
        right, left = scene.forces(2e-3), scene.forces(-2e-3, left=True)
        mirrored = np.array([1.0, -1.0, 1.0]) * left.wrench["force"]
        np.testing.assert_array_equal(right.wrench["force"], mirrored)

    def test_lifted_wheel_has_no_force(self):
        place = scene.carried(0.0)
        place["vertical"] -= 5e-3
        found = kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, self.VELOCITY)
        self.assertEqual((len(found.contacts), int(found.wrench["contacts"])), (0, 0))
        self.assertFalse(np.any(found.wrench["force"]) or np.any(found.wrench["moment"]))

    def test_friction_differs_along_the_rail_and_falls(self):
        place, fast = scene.carried(0.0), kstrip.wheel_velocity(forward=20.0, pitch=-48.0)
        forces = []
        for friction, law in ((0.3, None), ([(-0.05, 0.3), (0.05, 0.3)], None), ([(-0.02, 0.1), (0.0, 0.3)], None), (0.3, WET)):
            given = {"friction_places": friction} if isinstance(friction, list) else {"friction": friction}
            pair = kstrip.wheel_pair(wheel_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, **given)
            forces.append(float(kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, pair, place, fast, law).wrench["force"][0]))
        even, places, greased, falling = forces
        self.assertAlmostEqual(places / even, 1.0, delta=1e-12)
        self.assertTrue(0.4 * even < greased < 0.9 * even, greased / even)
        # the wheel slides at 2 m/s: friction is 0.6 exp(-0.6 * 2) ... of itself
        self.assertAlmostEqual(falling / even, 0.4 + 0.6 * np.exp(-0.6 * 2.0), delta=0.03)

    def test_single_precision(self):
        rail, wheel = (kstrip.prepare_profile(given.y, given.z, dtype=np.float32)
                       for given in (scene.RAIL, scene.WHEEL))
        pair = kstrip.wheel_pair(wheel_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
        place = kstrip.wheel_position(lateral=scene.carried(0.0).lateral)
        place["vertical"] = kstrip.height_for_load(rail, wheel, pair, place, scene.LOAD)
        velocity = kstrip.wheel_velocity(forward=20.0, pitch=-43.6)
        single = kstrip.wheel_on_rail(rail, wheel, pair, place, velocity).wrench
        double = scene.forces(0.0, pitch=-43.6).wrench
        self.assertEqual(single["force"].dtype, np.float32)
        with self.assertRaisesRegex(TypeError, "rail: it has single precision"):
            kstrip.wheel_on_rail(rail, scene.WHEEL, pair, place, velocity)
        np.testing.assert_allclose(single["force"], double["force"], atol=0.01 * scene.LOAD)

    def test_bad_input_is_named(self):
        beside = kstrip.wheel_position(lateral=0.3)
        profile = kstrip.Profile(scene.RAIL.y, scene.RAIL.z, "rail")
        with self.assertRaisesRegex(kstrip.KstripError, "profile"):
            kstrip.prepare_profile([0.0, 1e-3, 2e-3], [0.0, 0.0, 0.0])
        with self.assertRaisesRegex(ValueError, "up to 4 pairs"):
            kstrip.wheel_pair(wheel_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, friction_places=[(0.0, 0.3)] * 5)
        with self.assertRaisesRegex(ValueError, "one of them"):
            kstrip.wheel_pair(wheel_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3, friction_places=[(0.0, 0.3)])
        for wrong in (lambda: kstrip.gauge_face(profile), lambda: kstrip.wheel_on_rail(profile, scene.WHEEL, scene.pair(), beside, self.VELOCITY)):
            with self.assertRaisesRegex(TypeError, r"rail: a prepared profile is needed, and this is a Profile: rail.prepare\(\) makes it"):
                wrong()
        with self.assertRaisesRegex(TypeError, r"left_wheel: .* left_wheel.prepare\(\)"):
            kstrip.wheelset_on_track(kstrip.Wheelset(scene.WHEEL, scene.pair(), left_wheel=profile), kstrip.Track(scene.RAIL), beside, self.VELOCITY)
        with self.assertRaises(kstrip.KstripError):
            kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), beside, self.VELOCITY)

    def test_curve_steers_and_table_converges(self):
        # a wheelset to the outside of a curve: the outer wheel runs ahead in straight track, and no more where the curve requires its radius
        outer, inner = scene.curve(np.inf, -4e-3)
        self.assertTrue(outer > 5e3 and inner < -5e3)
        difference = scene.rolling_radius(-4e-3, left=True) - scene.rolling_radius(-4e-3)
        radial = 2.0 * scene.HALF_WIDTH * scene.RADIUS / difference
        balanced, _ = scene.curve(radial, -4e-3)
        self.assertLess(abs(balanced), 0.12 * outer)
        between = np.linspace(-2.9e-3, 2.9e-3, 11)
        means = [scene.Table(np.linspace(-3e-3, 3e-3, count), self.VELOCITY).error(between, self.VELOCITY)[0] for count in (7, 25)]
        self.assertTrue(means[1] < 0.5 * means[0] and means[1] < 0.002, means)
        self.assertAlmostEqual(scene.equivalent_conicity(3e-3), 0.1743, delta=0.002)


class OnTables(unittest.TestCase):
    """Heights, wheels and wheelsets whose contacts come from a table."""

    TABLE = None

    @classmethod
    def setUpClass(cls):
        cls.TABLE = kstrip.ContactTable(scene.RAIL, scene.WHEEL, scene.pair(), lateral=(-11e-3, -9e-3), load=120e3, yaw=1e-3, roll=1e-3, lateral_nodes=9,
                                        levels=6, poses=20, only=True)

    def test_a_height_carries_its_load_on_the_table(self):
        place = kstrip.wheel_position(lateral=[-10.5e-3, -9.5e-3])
        place.vertical = kstrip.height_for_load(scene.RAIL, scene.WHEEL, scene.pair(), place, 80e3, table=self.TABLE)
        moves = kstrip.wheel_velocity(forward=20.0, pitch=-20.0 / 0.46)
        found = kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, moves, table=self.TABLE)
        same = self.TABLE.wheel(scene.pair(), place, moves)
        np.testing.assert_array_equal(found.wrench.force, same.wrench.force)
        loads = [sum(c.share * c.normal_force * c.normal[2] for c in contacts) for contacts in found.contacts]
        np.testing.assert_allclose(loads, 80e3, rtol=1e-9)

    def test_beside_the_table(self):
        place, moves = kstrip.wheel_position(lateral=-6e-3, vertical=1e-4), kstrip.wheel_velocity(forward=20.0, pitch=-20.0 / 0.46)
        given = (scene.RAIL, scene.WHEEL, scene.pair(), place, moves)
        with self.assertRaises(kstrip.KstripError) as caught:
            kstrip.wheel_on_rail(*given, table=self.TABLE)
        self.assertEqual(caught.exception.status, kstrip.constants["KSTRIP_ERROR_TABLE_RANGE"])
        computed = kstrip.ContactTable.of_bytes(self.TABLE.raw)
        np.testing.assert_array_equal(kstrip.wheel_on_rail(*given, table=computed).wrench.force, kstrip.wheel_on_rail(*given).wrench.force)

    def test_a_wheelset_settles_on_tables(self):
        track = kstrip.Track(scene.RAIL, origin=(0.760, 0.760))
        direct, on = (kstrip.wheelset_settle(kstrip.Wheelset(scene.WHEEL, scene.pair(), running_circles=1.5, table=table, left_table=table), track,
                                             kstrip.wheel_position(lateral=0.3e-3), kstrip.wheel_velocity(forward=20.0, pitch=-20.0 / 0.46), 160e3)
                      for table in (None, self.TABLE))
        self.assertAlmostEqual(-on.forces.wrench.force[2], 160e3, delta=1e-3)
        self.assertAlmostEqual(1e6 * on.position.vertical, 1e6 * direct.position.vertical, delta=3)

    def test_pickled(self):
        again = pickle.loads(pickle.dumps(self.TABLE))
        self.assertTrue(again == self.TABLE and again.only)


if __name__ == "__main__":
    unittest.main()
