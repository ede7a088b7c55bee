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
        self.assertEqual(again.forces, still.forces)
        self.assertIsNone(again.by_position)
        self.assertEqual(again.derivatives.velocity.shape, (5, 10, 10))

    def test_many_wheelsets_are_single_ones(self):
        starts, loads = kstrip.wheel_position(lateral=np.linspace(0.0, 4e-3, 3)), np.array([[120e3], [160e3]])
        still = kstrip.wheelset_settle(WHEELSET, TRACK, starts, ROLLING, loads)
        found = kstrip.wheelset_on_track(WHEELSET, TRACK, still.position, still.velocity, by_position=True)
        for at in np.ndindex(2, 3):
            one = kstrip.wheelset_settle(WHEELSET, TRACK, starts[at[1]], ROLLING, loads[at[0], 0])
            self.assertEqual((still.position[at], still.forces[at]), (one.position, one.forces))
            single = kstrip.wheelset_on_track(WHEELSET, TRACK, one.position, one.velocity, by_position=True)
            for name in ("forces", "derivatives", "by_position"):
                self.assertEqual(getattr(found, name)[at], getattr(single, name))
            for side in ("right", "left"):
                self.assertEqual(getattr(found, side).contacts[at][: single.forces.wheel.contacts[0]], getattr(single, side).contacts)

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
        # Radii that do not differ within the motion do not steer, and one amplitude does not lose the others
        dead = np.where(abs(shifts) < 2e-3, 0.0, np.sign(shifts) * (abs(shifts) - 2e-3))
        straight = kstrip.equivalent_conicity(shifts, dead, [1e-3, 3e-3, 0.1], on_error="nan")
        self.assertEqual((straight.conicity[0], straight.wave_length[0], straight.statuses.tolist()), (0.0, np.inf, [0, 0, kstrip.constants["KSTRIP_ERROR_CONICITY"]]))
        self.assertTrue(straight.conicity[1] > 0.0 and np.isnan(straight.conicity[2]))
        with self.assertRaisesRegex(kstrip.KstripError, "at index 2") as caught:
            kstrip.equivalent_conicity(shifts, dead, [1e-3, 3e-3, 0.1])
        self.assertEqual(caught.exception.results.conicity[1], straight.conicity[1])
        # Klingel
        np.testing.assert_allclose(found.wave_length, 2 * np.pi * np.sqrt(0.46 * 0.75 / found.conicity), rtol=1e-6)

    def test_each_wheel_has_its_contacts_and_their_power(self):
        """The wheels of a wheelset that yaws and rolls over rails that move."""
        moves = kstrip.wheel_velocity(forward=20.0, pitch=-43.3, yaw=0.05, roll=0.02, lateral=0.1, vertical=0.01)
        track = kstrip.Track(scene.RAIL, gauge=1.435, motion=kstrip.rail_motion(lateral_velocity=[1e-3, 2e-3], vertical_velocity=[-1e-4, 3e-4]))
        starts = kstrip.wheel_position(lateral=[4e-3, 5e-3], yaw=0.01)
        still = kstrip.wheelset_settle(WHEELSET, TRACK, starts, moves, 100e3)
        on = kstrip.wheelset_on_track(WHEELSET, track, still.position, moves)
        for i, side in enumerate((on.right, on.left)):
            np.testing.assert_allclose(side.wrenches.dissipation.sum(axis=-1), on.forces.wheel.dissipation[:, i], rtol=1e-12)
            np.testing.assert_allclose(side.wrenches.force.sum(axis=-2), on.forces.wheel.force[:, i], rtol=1e-9, atol=1e-6)
            self.assertTrue((side.t_gamma > 1.0).all() and side.creepages.shape == side.contacts.shape)
        one = kstrip.wheelset_on_track(WHEELSET, track, still.position[1], moves)
        self.assertEqual((one.right.contacts, one.right.velocity), (on.right.contacts[1, : len(one.right.contacts)], on.right.velocity[1]))
        track.motion = None
        self.assertNotEqual(one.track.motion, None)

    def test_each_wheelset_has_rails_that_move(self):
        """Irregularities at several places of the track, and several wheelsets: as one call for each."""
        places = kstrip.rail_motion(lateral=[[1e-3, 0.0], [0.0, -5e-4], [0.0, 0.0]], vertical=[[0.0, 2e-4], [1e-4, 0.0], [0.0, 0.0]],
                                    vertical_velocity=[[1e-3, 0.0], [0.0, 0.0], [0.0, 0.0]])
        track = kstrip.Track(scene.RAIL, gauge=1.435, motion=places)
        start = kstrip.wheel_position(lateral=[[1e-3], [3e-3]])
        still = kstrip.wheelset_settle(WHEELSET, track, start, ROLLING, 100e3)
        on = kstrip.wheelset_on_track(WHEELSET, track, still.position, still.velocity, by_position=True)
        radii = kstrip.rolling_radius_difference(WHEELSET, track, [[1e-3], [3e-3]])
        self.assertEqual((still.position.shape, on.forces.shape, radii.shape), ((2, 3), (2, 3), (2, 3)))
        for i in range(2):
            for j in range(3):
                own = kstrip.Track(scene.RAIL, gauge=1.435, motion=places[j])
                alone = kstrip.wheelset_settle(WHEELSET, own, start[i, 0], ROLLING, 100e3)
                self.assertEqual((alone.position, alone.velocity, alone.forces), (still.position[i, j], still.velocity[i, j], still.forces[i, j]))
                one = kstrip.wheelset_on_track(WHEELSET, own, alone.position, alone.velocity, by_position=True)
                self.assertEqual((one.forces, one.by_position, one.right.velocity), (on.forces[i, j], on.by_position[i, j], on.right.velocity[i, j]))
                self.assertEqual(radii[i, j], kstrip.rolling_radius_difference(WHEELSET, own, 1e-3 * (1 + 2 * i)))
        self.assertNotEqual(still.position[0, 0], still.position[0, 2])
        # One position on several tracks
        self.assertEqual(kstrip.wheelset_on_track(WHEELSET, track, still.position[0, 2], ROLLING).forces.shape, (3,))
        with self.assertRaisesRegex(ValueError, r"position \(2,\), right_motion \(3,\)"):
            kstrip.wheelset_on_track(WHEELSET, track, start[:, 0], ROLLING)

    def test_each_wheelset_has_members_of_its_own(self):
        """Friction, laws of friction, distances and gauges of each wheelset, on rails that move: as one call for each."""
        friction = np.array([0.1, 0.2, 0.4])
        pairs = kstrip.wheel_pair(wheel_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, friction=friction)
        laws = kstrip.friction(0.3, [0.3, 0.6, 1.0], 0.4)
        many = kstrip.Wheelset(scene.WHEEL, pairs, back_to_back=[1.36, 1.359, 1.358], left_friction=laws)
        gauges = np.array([[1.435], [1.440]])
        moved = kstrip.rail_motion(vertical=[1e-3, 0.0])
        track, fast = kstrip.Track(scene.RAIL, gauge=gauges, motion=moved), kstrip.wheel_velocity(forward=20.0, pitch=-44.0, yaw=0.02)
        start = kstrip.wheel_position(lateral=1e-3)
        still = kstrip.wheelset_settle(many, track, start, ROLLING, 1e5)
        on = kstrip.wheelset_on_track(many, track, still.position, fast)
        radii = kstrip.rolling_radius_difference(many, track, 1e-3)
        self.assertEqual((still.position.shape, on.forces.shape, radii.shape), ((2, 3), (2, 3), (2, 3)))
        for i, j in np.ndindex(2, 3):
            one = kstrip.Wheelset(scene.WHEEL, pairs[j], back_to_back=many.back_to_back[j], left_friction=laws[j])
            own = kstrip.Track(scene.RAIL, gauge=gauges[i, 0], motion=moved)
            alone = kstrip.wheelset_settle(one, own, start, ROLLING, 1e5)
            self.assertEqual((alone.position, alone.forces), (still.position[i, j], still.forces[i, j]))
            single = kstrip.wheelset_on_track(one, own, alone.position, fast)
            self.assertEqual((single.forces, single.right.velocity), (on.forces[i, j], on.right.velocity[i, j]))
            self.assertEqual(radii[i, j], kstrip.rolling_radius_difference(one, own, 1e-3))
            for side, alike in ((single.left, on.left), (single.right, on.right)):
                number = len(side.contacts)
                np.testing.assert_array_equal(side.t_gamma, alike.t_gamma[i, j, :number])
                self.assertEqual(side.strips, alike.strips[i, j, :number, : side.strips.shape[-1]])
        # Each strip has its place and pressure, and they carry the load
        strips = single.right.strips[0]
        loads = np.pi / 2 * strips.half_length * strips.width * strips.peak_pressure
        self.assertAlmostEqual(loads.sum() / single.right.contacts.normal_force[0], 1.0, delta=1e-9)
        with self.assertRaisesRegex(ValueError, r"position \(2, 2\), .*pair \(3,\)"):
            kstrip.wheelset_on_track(many, TRACK, still.position[:, :2], fast)

    def test_a_thousand_wheelsets_lose_one(self):
        shifts = np.linspace(-4e-3, 4e-3, 1000)
        starts, lifting = kstrip.wheel_position(lateral=shifts), np.where(np.arange(1000) == 377, 1e5, 0.0)
        still = kstrip.wheelset_settle(WHEELSET, TRACK, starts, ROLLING, 1e5, roll=lifting, on_error="nan", threads=2)
        failed = still.statuses < 0
        self.assertEqual(np.flatnonzero(failed).tolist(), [377])
        self.assertEqual(still.statuses[377], kstrip.constants["KSTRIP_ERROR_WHEEL_LIFTED"])
        on = kstrip.wheelset_on_track(WHEELSET, TRACK, still.position, still.velocity, on_error="nan", threads=2)
        for array in (still.position.vertical, on.forces.rail[:, 0, 2], on.derivatives.velocity[:, 1, 1]):
            np.testing.assert_array_equal(np.isnan(array), failed)
        self.assertTrue(on.statuses[377] < 0 and (np.delete(on.statuses, 377) >= 0).all())

    def test_one_wheelset_does_not_lose_the_others(self):
        starts = kstrip.wheel_position(lateral=np.linspace(-8e-3, 8e-3, 81))
        lifting = np.where(np.abs(starts.lateral) < 1e-3, 1e5, 0.0)
        still = kstrip.wheelset_settle(WHEELSET, TRACK, starts, ROLLING, 100e3, roll=lifting, on_error="nan")
        failed = still.statuses < 0
        self.assertTrue(0 < failed.sum() < 20, failed.sum())
        np.testing.assert_array_equal(np.isnan(still.position.vertical), failed)
        np.testing.assert_allclose(still.forces.rail[~failed][:, :, 2].sum(axis=-1), 100e3, rtol=1e-6)
        with self.assertRaises(kstrip.KstripError) as caught:
            kstrip.wheelset_settle(WHEELSET, TRACK, starts, ROLLING, 100e3, roll=lifting)
        self.assertEqual((caught.exception.index, caught.exception.results), ((int(np.argmax(failed)),), still))
        shifts = [0.0, 0.2, 1e-3]
        statuses = np.zeros(3, np.int32)
        differences = kstrip.rolling_radius_difference(WHEELSET, TRACK, shifts, on_error="nan", statuses=statuses)
        self.assertEqual((np.isnan(differences).tolist(), (statuses < 0).tolist()), ([False, True, False], [False, True, False]))

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
        with self.assertRaisesRegex(ValueError, r"start \(3,\), vertical \(2,\)"):
            kstrip.wheelset_settle(WHEELSET, TRACK, place, ROLLING, [1e5, 1e5])
        with self.assertRaisesRegex(kstrip.KstripError, "at index 1"):
            kstrip.wheelset_settle(WHEELSET, TRACK, place[:2], ROLLING, [1e5, -1e5])
        with self.assertRaisesRegex(TypeError, "wheelset: a kstrip.Wheelset is needed, not Track"):
            kstrip.wheelset_on_track(TRACK, WHEELSET, place, ROLLING)
        with self.assertRaisesRegex(ValueError, r"motion: two elements are needed"):
            kstrip.wheelset_on_track(WHEELSET, kstrip.Track(scene.RAIL, gauge=1.435, motion=kstrip.rail_motion()), place[0], ROLLING)


if __name__ == "__main__":
    unittest.main()
