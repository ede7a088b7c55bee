"""The wagon of vehicle.py in its curve: forces, derivatives, a steady end. Needs scipy."""

import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), os.pardir))

try:
    import scipy  # noqa: F401
except ImportError:
    raise unittest.SkipTest("SKIPPED: the wagon in Python, because there is no scipy")

import numpy as np

import vehicle


class Wagon(unittest.TestCase):
    def test_runs_into_its_curve(self):
        solution = vehicle.run()
        self.assertTrue(solution.success and solution.t.size < 500, solution)
        q, v = solution.y[:, -1].reshape(2, 18)
        rails = vehicle.wheelsets_on_track(4.0, q, v)[0].forces.rail
        # Lateral forces turn the wagon, and vertical ones carry it
        self.assertAlmostEqual(rails[..., 1].sum() / (-vehicle.MASS[[1, 7, 13]].sum() * vehicle.SPEED**2 * vehicle.CURVATURE), 1.0, delta=1e-2)
        self.assertAlmostEqual(rails[..., 2].sum() / (2 * vehicle.LOAD), 1.0, delta=1e-3)
        # In a curve to the right the front wheelset runs on its left flange, and the wagon is steady
        self.assertTrue(-7e-3 < q[1] < -5.5e-3 and rails[0, 1, 1] < -10e3, (q, rails))
        self.assertLess(abs(v[[1, 2, 3, 5, 7, 8, 9, 11, 14, 15, 17]]).max(), 1e-3)

    def test_derivatives_are_those_of_differences(self):
        """On the flange too; columns of displacements along the track and about the axle are zero, or of springs alone."""
        solution = vehicle.run(0.6)
        time, state = solution.t[-1], solution.y[:, -1]
        exact = vehicle.jacobian(time, state)
        for k in range(36):
            step = 1e-8 * (np.arange(36) == k)
            difference = (vehicle.rate(time, state + step) - vehicle.rate(time, state - step)) / 2e-8
            np.testing.assert_allclose(exact[:, k], difference, rtol=0.0, atol=2e-3 * abs(difference).max() + 1e-3, err_msg=str(k))


if __name__ == "__main__":
    unittest.main()
