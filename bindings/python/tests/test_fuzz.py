"""Whatever comes in: an answer or an exception, never a crash or a read past a buffer. Needs hypothesis."""

import os
import sys
import unittest
import warnings

sys.path.insert(0, os.path.join(os.path.dirname(__file__), os.pardir))

import numpy as np

import kstrip

try:
    from hypothesis import given, settings
    from hypothesis import strategies as st
    from hypothesis.extra import numpy as hnp
except ImportError:
    raise unittest.SkipTest("SKIPPED: the fuzz test of the Python binding, because there is no hypothesis")

#: What an input may answer with: our errors, and what numpy says of shapes and types.
REFUSED = (kstrip.KstripError, TypeError, ValueError, OverflowError)

shapes = hnp.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=4)
anything = st.one_of(
    st.floats(),
    st.integers(),
    st.none(),
    st.text(max_size=3),
    st.complex_numbers(),
    hnp.arrays(hnp.scalar_dtypes(), shapes),
    hnp.arrays(st.sampled_from([np.float16, np.float32, np.float64, np.int8, np.uint64, ">f8", np.bool_]), shapes),
)
kinds = ["contact", "creepage", "friction", "motion", "radii", "combined_material", "velocity", "parameters", "result", "patch_strip"]
structures = sorted(name for name in kstrip.dtypes if "patch" != name.removesuffix("_f32"))


@st.composite
def records(draw):
    """Batches of a structure of the library, right or wrong: their bytes are anything, and so is their layout."""
    name = draw(st.sampled_from(structures))
    kind = kstrip.dtypes[name]
    shape = draw(shapes)
    size = int(np.prod(shape)) * kind.itemsize
    raw = np.frombuffer(draw(st.binary(min_size=16, max_size=64)) * (size // 16 + 2), np.uint8)
    made = raw[draw(st.integers(0, 7)) :][:size].view(kind).reshape(shape)
    made = draw(st.sampled_from([made, made.T, np.repeat(made[..., None], 2, -1)[..., ::2]]))
    values = kstrip.values.classes.get(name.removesuffix("_f32"))
    return made if values is None else kstrip.Batch(values, made)


@st.composite
def sensible(draw, kind):
    """Values and batches whose members are numbers that mean something, now and then one that does not."""
    number = st.one_of(st.floats(-10.0, 10.0), st.floats(1e-3, 1.0), st.sampled_from([0.0, -0.0, 1e5, 8e10, np.nan, np.inf, 1e300]))
    made = np.zeros(draw(st.sampled_from([(), (1,), (3,), (2, 1), (2, 3)])), kstrip.dtypes[kind + draw(st.sampled_from(["", "", "_f32"]))])
    with np.errstate(over="ignore"):
        for member in made.dtype.names:
            made[member] = draw(number)
    batch = kstrip.Batch(kstrip.values.classes[kind], made)
    return batch if made.ndim else batch[()]


@st.composite
def patches(draw):
    made = kstrip.patch_from_contact(kstrip.contact(a=6e-3, b=4e-3, normal_force=8e4, shear_modulus=8e10, poisson_ratio=0.28, friction=0.3))
    made["count"] = draw(st.integers(0, 2**32 - 1))
    made.strips[draw(st.sampled_from(["y", "width", "friction"]))][draw(st.integers(0, 63))] = draw(st.floats())
    return made if draw(st.booleans()) else kstrip.Batch(kstrip.Patch, [made])


model = st.one_of(st.sampled_from(list(kstrip.models)), st.integers(), st.text(max_size=2), st.floats())
strips = st.one_of(st.sampled_from([0, 4, 8, 16, 32, 64]), st.integers())


def argument(kind):
    return st.one_of(sensible(kind), sensible(kind), records(), anything)


def attempt(call, *arguments, **named):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return call(*arguments, **named)
        except REFUSED:
            return None


class Fuzz(unittest.TestCase):
    @settings(deadline=None, database=None, max_examples=200)
    @given(st.one_of(argument("contact"), patches()), argument("creepage"), st.none() | argument("friction"), model, strips)
    def test_evaluate(self, contact, creepage, law, model, strips):
        answer = attempt(kstrip.evaluate, contact, creepage, law, model, strips, law_derivatives=True)
        if answer is not None:
            # Results are finite, and has the broadcast shape
            self.assertTrue(np.isfinite(answer.result["fx"]).all())
            self.assertTrue(np.isfinite(answer.derivatives["jacobian"]).all())
        attempt(kstrip.strips, contact, creepage, law, model, strips)

    @settings(deadline=None, database=None, max_examples=100)
    @given(argument("contact"), argument("motion"), st.none() | argument("friction"), model, strips, argument("creepage"))
    def test_motion_and_prepared(self, contact, motion, law, model, strips, creepage):
        answer = attempt(kstrip.solve_motion, contact, motion, law, model, strips)
        if answer is not None:
            self.assertTrue(np.isfinite(answer.result["fx"]).all())
        prepared = attempt(kstrip.prepare, contact, model, strips)
        if prepared is not None:
            attempt(prepared.solve, creepage)

    @settings(deadline=None, database=None, max_examples=100)
    @given(st.one_of(argument("contact"), patches()), argument("creepage"), anything, anything, model, strips)
    def test_field_and_rig(self, area, creepage, x, y, model, strips):
        points = attempt(kstrip.field, area, creepage, x, y, model, strips)
        if points is not None:
            self.assertEqual(points.shape, (np.size(y), np.size(x)))
        attempt(kstrip.estimate_friction, area, creepage, fx=x, fy=y, model=model, strips=strips)
        attempt(kstrip.creepage_for_force, area, x, y, 0.0, model, strips)
        attempt(kstrip.patch_summary, area)
        attempt(kstrip.on_upper_body, creepage)

    @settings(deadline=None, database=None, max_examples=100)
    @given(anything, anything, anything, argument("radii"), argument("combined_material"), argument("patch_strip"))
    def test_bodies_and_patches(self, p, q, r, radii, pair, strip):
        attempt(kstrip.contact, a=p, b=q, normal_force=r, shear_modulus=1.0, poisson_ratio=0.3, friction=0.3)
        attempt(kstrip.contact_from_hertz, radii, pair, p, q)
        attempt(kstrip.contact_from_approach, radii, pair, p, q)
        attempt(kstrip.linear_coefficients, p, q)
        attempt(kstrip.patch_from_strips, strip, p, q)
        attempt(kstrip.patch_from_profile, p, q, rolling_radius=0.5, normal_force=r, shear_modulus=8e10, poisson_ratio=0.3, friction=0.3)
        attempt(kstrip.combine, (p, q), (q, p))
        attempt(kstrip.creepage_from_velocities, strip, pair, r)
        attempt(kstrip.parameters_from_creepage, radii, pair)

    def test_ten_million_numbers_are_no_creepages(self):
        contact = kstrip.contact(a=6e-3, b=4e-3, normal_force=8e4, shear_modulus=8e10, poisson_ratio=0.28, friction=0.3)
        for wrong in (np.zeros(10**7), np.zeros(10**7, np.float32), np.zeros(10**6, kstrip.dtypes["contact_f32"])):
            with self.assertRaises(TypeError):
                kstrip.solve(contact, wrong)


if __name__ == "__main__":
    unittest.main()
