"""python -m unittest discover bindings/python/tests; needs libkstrip (make) and numpy."""

import ctypes
import os
import re
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), os.pardir))

import numpy as np

import kstrip

STEEL = dict(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
BOUND = 0.3 * 80e3


class Binding(unittest.TestCase):
    def test_everything_of_the_header_is_there(self):
        header = kstrip._text
        code = re.sub(r"/\*.*?\*/", "", header, flags=re.S)
        declared = set(re.findall(r"\b(kstrip_\w+)\(", code))
        bound = {name for name, *_ in kstrip._header.functions(header, kstrip.structures)}
        self.assertEqual(declared, bound)
        self.assertEqual(set(re.findall(r"typedef struct (\w+)", code)), set(kstrip.structures))
        for name, structure in kstrip.structures.items():
            self.assertEqual(kstrip.dtypes[name.removeprefix("kstrip_")].itemsize, ctypes.sizeof(structure))
        self.assertIn(":param creepage", kstrip.lib.kstrip_solve.__doc__)

    def test_creep_curve_is_the_closed_form(self):
        # (8.15): 1 - ((2 + tau^2) sqrt(1 - tau^2) - 3 tau acos tau)/2
        creepage = np.linspace(0, 0.01, 200)
        curve = kstrip.solve(kstrip.contact(**STEEL), kstrip.creepage(longitudinal=creepage), "strip_1967", 64)
        pressure = 1.5 * 80e3 / (np.pi * 6e-3 * 4.5e-3)
        tau = np.minimum(creepage * 82e9 / (2 * 0.72 * 0.3 * pressure), 1)
        force = 1 - ((2 + tau**2) * np.sqrt(1 - tau**2) - 3 * tau * np.arccos(tau)) / 2
        np.testing.assert_allclose(curve["fx"] / BOUND, force, atol=1e-6)
        np.testing.assert_array_equal(curve["status_detail"], 0)

    def test_batch_is_the_scalar_call_and_broadcasts(self):
        contacts = kstrip.contact(**{**STEEL, "friction": np.array([[0.1], [0.3]])})
        motions = kstrip.creepage(longitudinal=np.array([0.0, 1e-3, 2e-3]), spin=0.2)
        results = kstrip.solve(contacts, motions, "total")
        self.assertEqual(results.shape, (2, 3))
        one = np.zeros((), kstrip.dtypes["result"])
        options = kstrip.structures["kstrip_options"](kstrip.models["total"], 16)
        for i in range(2):
            for j in range(3):
                contact, motion = contacts[i, :1].copy(), motions[j : j + 1].copy()
                status = kstrip.lib.kstrip_solve(contact.ctypes.data, motion.ctypes.data, ctypes.byref(options), one.ctypes.data)
                self.assertEqual(status, 0)
                self.assertEqual(one.tobytes(), results[i, j].tobytes())

    def test_single_precision(self):
        single = kstrip.solve(kstrip.contact(**STEEL, dtype=np.float32), kstrip.creepage(1e-3, dtype=np.float32))
        double = kstrip.solve(kstrip.contact(**STEEL), kstrip.creepage(1e-3))
        self.assertEqual(single["fx"].dtype, np.float32)
        self.assertLess(abs(single["fx"] - double["fx"]), 2e-6 * BOUND)

    def test_jacobian_is_the_slope(self):
        contact, h = kstrip.contact(**STEEL), 1e-7
        _, slopes = kstrip.solve_jacobian(contact, kstrip.creepage(1e-3, 5e-4, 0.1))
        for column, step in enumerate(np.eye(3) * h):
            two = [kstrip.solve(contact, kstrip.creepage(1e-3 + s * step[0], 5e-4 + s * step[1], 0.1 + s * step[2])) for s in (1, -1)]
            for row, force in enumerate(("fx", "fy", "mz")):
                slope = (two[0][force] - two[1][force]) / (2 * h)
                self.assertLess(abs(slope - slopes[row, column]), 1e-4 * abs(slopes[row]).max())

    def test_strips_and_field_add_up(self):
        contact, motion = kstrip.contact(**STEEL), kstrip.creepage(5e-4, 1e-3, 0.3)
        total = kstrip.solve(contact, motion, "strip_1967", 32)
        shares = kstrip.strips(contact, motion, "strip_1967", 32)
        self.assertLess(abs(shares["fy"].sum() - total["fy"]), 1e-9 * BOUND)
        n = 240
        grid = (2 * np.arange(n) + 1 - n) / n
        points = kstrip.field(contact, motion, 6e-3 * grid, 4.5e-3 * grid, "strip_1967", 32)
        cell = 4 * 6e-3 * 4.5e-3 / n**2
        self.assertLess(abs(points["pressure"].sum() * cell - 80e3), 5e-5 * 80e3)
        self.assertLess(abs(points["traction_y"].sum() * cell - total["fy"]), 5e-5 * BOUND)
        # Element [j, i] is the point (x[i], y[j]): the trailing half has slip, the rim of b has no pressure.
        self.assertGreater((points["state"][:, : n // 2] >= kstrip.SLIP).sum(), (points["state"][:, n // 2 :] >= kstrip.SLIP).sum())

    def test_friction_that_falls(self):
        contact, motions = kstrip.contact(**STEEL), kstrip.creepage(np.array([1e-4, 0.01, 0.1, 10.0]))
        constant, same = kstrip.solve_friction(contact, motions, kstrip.friction(0.3))
        self.assertEqual(constant.tobytes(), kstrip.solve(contact, motions).tobytes())
        np.testing.assert_array_equal(same, 0.3)
        wet, effective = kstrip.solve_friction(contact, motions, kstrip.friction(0.3, 0.4, 0.6, 20.0))
        # Full sliding: mu = mu0 ((1 - A) exp(-B V s) + A)
        self.assertLess(abs(effective[2] - 0.3 * (0.6 * np.exp(-0.6 * 20 * 0.1) + 0.4)), 1e-3)
        self.assertLess(abs(wet["fx"][3] - 0.4 * BOUND), 1e-6 * BOUND)
        self.assertGreater(wet["fx"][1], wet["fx"][2])

    def test_patch_from_profiles(self):
        y = np.linspace(-12e-3, 12e-3, 241)
        # Two bottoms: two lobes, whose bound no force exceeds and full sliding reaches
        distance = 70e-6 * ((y / 4.5e-3) ** 2 - 1) ** 2
        patch, found = kstrip.patch_from_profile(y, distance, rolling_radius=0.46, normal_force=80e3, shear_modulus=82e9,
                                                 poisson_ratio=0.28, friction=0.35)
        self.assertLess(abs(found["normal_force"] - 80e3), 1e-6 * 80e3)
        forces = kstrip.patch_solve(patch, kstrip.creepage(np.array([1e-4, 1.0])))
        self.assertLess(abs(forces["fx"][1] - 0.35 * 80e3), 1e-3 * 28e3)
        self.assertTrue(0 < forces["fx"][0] < forces["fx"][1])
        motions = kstrip.creepage(np.array([1e-4, 1.0]))
        wet, share = kstrip.patch_solve_friction(patch, motions, kstrip.friction(0.35, 0.4, 0.6, 20.0))
        self.assertAlmostEqual(share[1], 0.4 + 0.6 * np.exp(-12.0))
        self.assertAlmostEqual(wet["fx"][1] / forces["fx"][1], share[1])
        constant, share = kstrip.patch_solve_friction(patch, motions, kstrip.friction(0.0))
        self.assertTrue((constant == forces).all() and (share == 1).all())
        patch["strips"]["friction"] = 0.0
        self.assertEqual(kstrip.patch_solve(patch, kstrip.creepage(1.0))["fx"], 0)

    def test_hertz_and_upper_body(self):
        ellipse = kstrip.hertz(lower_x=np.inf, lower_y=np.inf, upper_x=0.1, upper_y=0.1, normal_force=1e3, shear_modulus=82e9, poisson_ratio=0.28)
        # Circle: a^3 = 3 N R/(4 E*)
        self.assertLess(abs(ellipse["a"] ** 3 / (0.75 * 1e3 * 0.1 * 0.72 / 82e9) - 1), 1e-9)
        forces = kstrip.solve(kstrip.contact(**STEEL), kstrip.creepage(1e-3, 2e-3))
        self.assertEqual(kstrip.on_upper_body(forces)["fy"], -forces["fy"])
        self.assertEqual(kstrip.combine((82e9, 0.28), (82e9, 0.28))[2], 0)

    def test_errors_have_their_status(self):
        with self.assertRaises(kstrip.Error) as caught:
            kstrip.solve(kstrip.contact(**{**STEEL, "friction": -1.0}), kstrip.creepage(1e-3))
        self.assertEqual(caught.exception.status, kstrip.constants["KSTRIP_ERROR_FRICTION"])
        self.assertIn("friction", str(caught.exception))
        with self.assertRaises(kstrip.Error):
            kstrip.field(kstrip.contact(**STEEL), kstrip.creepage(1e-3), [0.0], [0.0], "total")
        with self.assertRaises(TypeError):
            kstrip._record("contact", float, a=1)


if __name__ == "__main__":
    unittest.main()
