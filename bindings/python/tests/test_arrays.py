"""TOTAL in array operations against the C library: contacts of every kind, NumPy, JAX, and a library that has nothing but the standard."""

import doctest
import os
import sys
import unittest
import warnings

sys.path.insert(0, os.path.join(os.path.dirname(__file__), os.pardir))

import numpy as np

import kstrip
import write_constants
from kstrip import arrays

#: Largest errors of the forces divided by friction times load, and of the moment divided by that and sqrt(a b)
DOUBLE, SINGLE = 1e-13, 2e-5
NAMES = ("a", "b", "normal_force", "shear_modulus", "poisson_ratio", "friction")


def cases(count=10_000):
    """Contacts and creepages over the whole range of the model: from rest to far beyond sliding, with and without each creepage."""
    random = np.random.default_rng(69)

    def between(low, high):
        return np.exp(random.uniform(np.log(low), np.log(high), count))

    root, ratio = between(1e-3, 1e-2), np.sqrt(between(0.015, 60.0))
    contact = {"a": root * ratio, "b": root / ratio, "normal_force": between(1e2, 2e5), "shear_modulus": between(1e6, 2e11),
               "poisson_ratio": random.uniform(0.0, 0.5, count), "friction": random.uniform(0.01, 0.8, count)}
    bound = contact["friction"] * contact["normal_force"]
    directions = random.normal(size=(3, count)) * (random.uniform(size=(3, count)) < 0.8)
    vx, vy, spin = directions * between(1e-6, 1e4) * bound / (contact["shear_modulus"] * root**2)
    contact["normal_force"][:100], contact["friction"][100:200] = random.uniform(-1e4, 0.0, 100), 0.0
    return contact, (vx, vy, spin / root)


class Total(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.contact, cls.creepage = cases()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", kstrip.KstripWarning)
            found = kstrip.evaluate(kstrip.contact(**cls.contact), kstrip.creepage(*cls.creepage), model="total")
        cls.exact, cls.derivatives = [found.result.fx, found.result.fy, found.result.mz], found.derivatives.jacobian
        bound = np.maximum(cls.contact["normal_force"], 0.0) * cls.contact["friction"]
        radius = np.sqrt(cls.contact["a"] * cls.contact["b"])
        cls.units = [np.where(bound > 0.0, unit, 1.0) for unit in (bound, bound, bound * radius)]

    def arguments(self, convert=np.asarray):
        return [convert(column) for column in (*(self.contact[name] for name in NAMES), *self.creepage)]

    def check(self, found, dtype, allowed):
        for force, exact, unit in zip(found, self.exact, self.units):
            self.assertEqual(str(force.dtype), dtype)
            error = abs(np.asarray(force).astype(float) - exact) / unit
            self.assertTrue(np.isfinite(error).all() and error.max() <= allowed, error.max())
            self.assertTrue((np.asarray(force)[:200] == 0.0).all())

    def test_constants_are_those_of_the_sources(self):
        written = (write_constants.HERE / "kstrip" / "_total.py").read_text(encoding="utf-8")
        self.assertEqual(written, write_constants.module(), "run python bindings/python/write_constants.py")

    def test_numpy(self):
        self.check(arrays.total(*self.arguments()), "float64", DOUBLE)
        self.check(arrays.total(*self.arguments(np.float32)), "float32", SINGLE)

    def test_the_example_in_its_help_runs(self):
        found = doctest.testmod(arrays, extraglobs={"np": np})
        self.assertEqual((found.attempted, found.failed), (3, 0))

    def test_shapes_broadcast(self):
        fx, fy, mz = arrays.total(np.full((3, 1), 6e-3), 4.5e-3, 80e3, 82e9, 0.28, 0.3, lateral=np.linspace(0.0, 0.01, 4))
        contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
        exact = kstrip.solve(contact, kstrip.creepage(lateral=np.linspace(0.0, 0.01, 4)), model="total")
        self.assertEqual((fx.shape, fy.shape, mz.shape), ((3, 4),) * 3)
        np.testing.assert_allclose(fy, np.tile(exact.fy, (3, 1)), rtol=1e-12)

    def test_nothing_but_the_standard(self):
        try:
            import array_api_strict as strict
        except ImportError:
            self.skipTest("SKIPPED: arrays by the standard, because there is no array_api_strict")
        found = arrays.total(*self.arguments(strict.asarray))
        self.check([np.asarray(force) for force in found], "float64", DOUBLE)

    def test_jax(self):
        try:
            import jax
            import jax.numpy as jnp
        except ImportError:
            self.skipTest("SKIPPED: arrays of JAX, because there is no jax")
        self.check(arrays.total(*self.arguments(lambda column: jnp.asarray(column, jnp.float32))), "float32", SINGLE)
        # No matrix product, which a GPU would round to ten bits
        few = [column[:2] for column in self.arguments(lambda column: jnp.asarray(column, jnp.float32))]
        self.assertNotIn("dot_general", str(jax.make_jaxpr(arrays.total)(*few)))
        with jax.enable_x64(True):
            given = self.arguments(jnp.asarray)
            self.check(arrays.total(*given), "float64", DOUBLE)
            # How the forces of some contacts move with a direction of the creepages
            some, direction = [column[:1000] for column in given], (1.0, -0.5, 0.3)
            radius = np.sqrt(np.asarray(some[0] * some[1]))
            moves = np.stack([direction[0] + 0.0 * radius, direction[1] + 0.0 * radius, direction[2] / radius], axis=-1)
            still = [jnp.zeros_like(column) for column in some[:6]]
            _, moved = jax.jvp(arrays.total, some, [*still, *map(jnp.asarray, moves.T)])
            exact = np.einsum("irc,ic->ri", self.derivatives[:1000], moves)
            slope = self.contact["shear_modulus"][:1000] * radius**2
            for force, derivative, unit in zip(moved, exact, (slope, slope, slope * radius)):
                np.testing.assert_allclose(force / unit, derivative / unit, rtol=0.0, atol=1e-11)


if __name__ == "__main__":
    unittest.main()
