"""A wheelset on a track: loads, symmetry, curves, conicity."""

import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), os.pardir))

import numpy as np

import kstrip
import wheel_on_rail as scene

WHEELSET = kstrip.Wheelset(scene.WHEEL, scene.pair(), back_to_back=1.36)
TRACK = kstrip.Track(scene.RAIL, gauge=1.435)
ROLLING = kstrip.wheel_velocity(forward=20.0, pitch=-20.0 / 0.46)


class OnTrack(unittest.TestCase):
    def test_rails_carry_the_load_at_every_shift(self):
        still = kstrip.wheelset_settle(WHEELSET, TRACK, kstrip.wheel_position(lateral=np.linspace(-3e-3, 3e-3, 5)), ROLLING, 160e3)
        self.assertEqual((still.forces.shape, still.forces.rail.shape, still.forces.wheel.shape), ((5,), (5, 2, 3), (5, 2)))
        np.testing.assert_allclose(still.forces.rail[..., 2].sum(axis=-1), 160e3, rtol=1e-6)
        np.testing.assert_allclose(still.forces.wrench.force[:, 2], -160e3, rtol=1e-6)
        # The mirror image has the mirrored forces
        np.testing.assert_allclose(still.forces.wrench.force[::-1, 1], -still.forces.wrench.force[:, 1], atol=1.0)
        np.testing.assert_allclose(still.velocity.pitch, still.velocity.pitch[::-1], rtol=1e-9)
        again = kstrip.wheelset_on_track(WHEELSET, TRACK, still.position, still.velocity)
        self.assertEqual(again.forces.tobytes(), still.forces.tobytes())
        self.assertIsNone(again.by_position)
        self.assertEqual(again.derivatives.velocity.shape, (5, 10, 10))

    def test_many_wheelsets_are_single_ones(self):
        starts, loads = kstrip.wheel_position(lateral=np.linspace(0.0, 4e-3, 3)), np.array([[120e3], [160e3]])
        still = kstrip.wheelset_settle(WHEELSET, TRACK, starts, ROLLING, loads)
        found = kstrip.wheelset_on_track(WHEELSET, TRACK, still.position, still.velocity, by_position=True)
        for at in np.ndindex(2, 3):
            one = kstrip.wheelset_settle(WHEELSET, TRACK, starts[at[1]], ROLLING, loads[at[0], 0])
            self.assertEqual(still.position[at].tobytes() + still.forces[at].tobytes(), one.position.tobytes() + one.forces.tobytes())
            single = kstrip.wheelset_on_track(WHEELSET, TRACK, one.position, one.velocity, by_position=True)
            for many, alone in zip(found, single):
                self.assertEqual(many[at].tobytes(), alone.tobytes())

    def test_derivatives_are_those_of_differences(self):
        still = kstrip.wheelset_settle(WHEELSET, TRACK, kstrip.wheel_position(lateral=1e-3), ROLLING, 160e3)
        found = kstrip.wheelset_on_track(WHEELSET, TRACK, still.position, still.velocity, by_position=True)
        step = 1e-7
        moves = kstrip.wheel_velocity(forward=20.0, pitch=still.velocity.pitch, lateral=[-step, step])
        ahead = kstrip.wheelset_on_track(WHEELSET, TRACK, still.position, moves).forces.wrench.force[:, 1]
        slope = float(np.diff(ahead)[0]) / (2 * step)
        self.assertAlmostEqual(float(found.derivatives.velocity[1, 1]) / slope, 1.0, delta=1e-4)
        self.assertLess(float(found.by_position.position[2, 2]), -1e9)

    def test_rails_that_move_and_unlike_sides(self):
        down = kstrip.Track(scene.RAIL, gauge=1.435, motion=kstrip.rail_motion(vertical=[1e-3, 1e-3]))
        plain, moved = (kstrip.wheelset_settle(WHEELSET, track, kstrip.wheel_position(lateral=0.0), ROLLING, 160e3) for track in (TRACK, down))
        self.assertAlmostEqual(float(moved.position.vertical - plain.position.vertical), 1e-3, delta=1e-8)
        slippery = kstrip.wheel_pair(wheel_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, friction=0.1)
        unlike = kstrip.Wheelset(scene.WHEEL, scene.pair(), back_to_back=1.36, left_pair=slippery)
        fast = kstrip.wheel_velocity(forward=20.0, pitch=-48.0)
        right, left = kstrip.wheelset_on_track(unlike, TRACK, plain.position, fast).forces.wheel
        self.assertAlmostEqual(float(right.force[0] / left.force[0]), 3.0, delta=0.1)

    def test_geometry_of_s1002_on_60e1(self):
        self.assertAlmostEqual(kstrip.gauge_face(scene.RAIL) - 0.7175, -0.7605325, delta=1e-5)
        shifts = np.linspace(-6e-3, 6e-3, 121)
        differences = kstrip.rolling_radius_difference(WHEELSET, TRACK, shifts)
        np.testing.assert_allclose(differences, -differences[::-1], atol=2e-6)
        found = kstrip.equivalent_conicity(shifts, differences, [1e-3, 3e-3])
        self.assertTrue(0.1 < found.conicity[1] < 0.25, found)
        # Klingel
        np.testing.assert_allclose(found.wave_length, 2 * np.pi * np.sqrt(0.46 * 0.75 / found.conicity), rtol=1e-6)

    def test_balance_speed_has_no_lateral_weight(self):
        speed = np.sqrt(9.80665 * 300.0 * np.tan(0.1))
        bend = kstrip.curve(speed, 1 / 300.0, 0.1)
        velocity, weight = kstrip.curve_motion(bend, kstrip.wheel_position(lateral=0.0), kstrip.wheel_velocity(forward=0.0, pitch=0.0))
        self.assertAlmostEqual(weight[1], 0.0, delta=0.05)
        self.assertAlmostEqual(float(velocity.forward) / speed, 1.0, delta=1e-9)

    def test_bad_input_is_named(self):
        place = kstrip.wheel_position(lateral=[0.0, 0.0, 0.0])
        with self.assertRaisesRegex(kstrip.KstripError, "GAUGE"):
            kstrip.wheelset_on_track(WHEELSET, kstrip.Track(scene.RAIL), place, ROLLING)
        with self.assertRaisesRegex(ValueError, r"start \(3,\), velocity \(\), loads \(2,\)"):
            kstrip.wheelset_settle(WHEELSET, TRACK, place, ROLLING, [1e5, 1e5])
        with self.assertRaisesRegex(kstrip.KstripError, "at index 1"):
            kstrip.wheelset_settle(WHEELSET, TRACK, place[:2], ROLLING, [1e5, -1e5])
        with self.assertRaisesRegex(TypeError, "kstrip.Wheelset and a kstrip.Track"):
            kstrip.wheelset_on_track(TRACK, WHEELSET, place, ROLLING)
        with self.assertRaisesRegex(ValueError, r"motion has two elements"):
            kstrip.Track(scene.RAIL, gauge=1.435, motion=kstrip.rail_motion())


if __name__ == "__main__":
    unittest.main()
