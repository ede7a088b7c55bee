"""Values and batches: members, units, copies in other processes; shapes in messages, arrays of wheels, help, and what a type checker finds."""

import concurrent.futures
import contextlib
import copy
import dataclasses
import doctest
import gc
import importlib.util
import inspect
import io
import multiprocessing
import os
import pathlib
import pickle
import pydoc
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
import warnings

sys.path.insert(0, os.path.join(os.path.dirname(__file__), os.pardir))

import numpy as np

import kstrip
import wheel_on_rail as scene
import write_types

FOLDER = pathlib.Path(__file__).resolve().parents[1]
STEEL = dict(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
CONTACT = kstrip.contact(**STEEL)
VELOCITY = kstrip.wheel_velocity(forward=20.0, pitch=-20.0 / 0.46)

#: Public functions and classes
PUBLIC = {name: value for name, value in ((name, getattr(kstrip, name)) for name in dir(kstrip))
          if not name.startswith("_") and (inspect.isfunction(value) or inspect.isclass(value)) and value.__module__.startswith("kstrip")}


def run_examples(name, finder=doctest.DocTestFinder(recurse=False)):
    """The number of examples in the help of a public object, the failures, and the names that the examples define."""
    scope = {"kstrip": kstrip, "np": np, "pathlib": pathlib, "rail": scene.RAIL, "wheel": scene.WHEEL, "pair": scene.pair(), "velocity": VELOCITY}
    shown, runner = io.StringIO(), doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
    made, tests = {}, finder.find(PUBLIC[name], name, globs=scope)
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        for name in ("s1002.csv", "uic60.csv"):
            shutil.copy(FOLDER.parents[1] / "tests" / "data" / "wheel_rail" / name, name)
        for test in tests:
            runner.run(test, out=shown.write, clear_globs=False)
            made.update(test.globs)
    return sum(len(test.examples) for test in tests), shown.getvalue(), made


def parts_of(thing, known):
    """Objects of this package within another one, by class."""
    kind = type(thing)
    if isinstance(thing, type):
        return
    if kind.__module__.startswith("kstrip") and kind not in known:
        known[kind] = thing
        for name in dir(thing):
            part = getattr(thing, name)
            for each in part if isinstance(part, tuple) else (part,):
                parts_of(each, known)
    elif isinstance(thing, (tuple, list)):
        for each in thing:
            parts_of(each, known)


def numbered(kind):
    """A batch of values whose numbers all differ."""
    data = np.zeros(2, kstrip.dtypes[kind._structure])
    count = iter(range(1, 10**6))

    def fill(array):
        for name in array.dtype.names:
            if array[name].dtype.names:
                fill(array[name])
            elif name != "reserved":
                array[name] = np.reshape([next(count) for _ in range(array[name].size)], array[name].shape)

    fill(data)
    return kstrip.Batch(kind, data)


def public_objects():
    """An object of each public class: values, exceptions, and what the examples of the functions make."""
    found = {}
    for kind in kstrip.values.classes.values():
        parts_of(numbered(kind)[0], found)
    for name in PUBLIC:
        parts_of(tuple(run_examples(name)[2].values()), found)
    for kind in PUBLIC.values():
        if inspect.isclass(kind) and issubclass(kind, Exception) and kind not in found:
            initial = vars(kind).get("__init__")
            found[kind] = kind(*range(1, 2 if initial is None else initial.__code__.co_argcount - len(initial.__defaults__ or ())))
    return found


OBJECTS = public_objects()
#: Bases, which have no objects of their own
BASES = {kstrip.Value}


class PublicObjects(unittest.TestCase):
    """Each public class, found by itself: a class without an example that makes one fails."""

    def test_every_class_has_an_object(self):
        classes = {kind for kind in PUBLIC.values() if inspect.isclass(kind)} - BASES
        self.assertEqual(classes - set(OBJECTS), set())

    def test_they_print_with_names_and_units(self):
        for kind, thing in OBJECTS.items():
            text = repr(thing)
            self.assertNotRegex(text, r" at 0x|object at", kind)
            if not isinstance(thing, BaseException):
                self.assertIn(getattr(thing, "kind", kind).__name__ if isinstance(thing, kstrip.Batch) else kind.__name__, text)
            for name, unit in getattr(kind, "_units", {}).items():
                self.assertRegex(text, rf"{name}\b.*{re.escape(unit)}", kind)

    def test_they_keep_what_they_were_made_of(self):
        for kind, thing in OBJECTS.items():
            if isinstance(thing, BaseException) or kind in (kstrip.PreparedProfile, kstrip.ContactTable):
                continue
            for name in inspect.signature(kind).parameters:
                self.assertTrue(hasattr(thing, name), f"{kind}.{name}")
                self.assertTrue("__repr__" in vars(kind) or re.search(rf"\b{name}\b", repr(thing)), f"{kind}.{name} in {thing!r}")

    def test_they_survive_pickle_and_copy(self):
        for kind, thing in OBJECTS.items():
            for way in (lambda x: pickle.loads(pickle.dumps(x)), copy.copy, copy.deepcopy):
                again = way(thing)
                self.assertEqual((type(again), repr(again)), (kind, repr(thing)))
                if not isinstance(thing, BaseException):
                    self.assertTrue(again == thing, kind)

    def test_a_copy_lives_without_the_original(self):
        makers = {kind: pickle.dumps(thing) for kind, thing in OBJECTS.items()}
        for kind, raw in makers.items():
            original = pickle.loads(raw)
            shown, again = repr(original), copy.deepcopy(original)
            del original
            gc.collect()
            self.assertEqual(repr(again), shown)
        wheelset, track = copy.deepcopy((kstrip.Wheelset(scene.WHEEL, scene.pair(), back_to_back=1.36, friction=kstrip.friction(0.3)),
                                         kstrip.Track(kstrip.prepare_profile(scene.RAIL.y, scene.RAIL.z), gauge=1.435)))
        gc.collect()
        before = kstrip.wheelset_settle(wheelset, track, kstrip.wheel_position(lateral=3e-3), VELOCITY, 100e3)
        junk = [np.full(2100, 1e-3) for _ in range(200)]
        self.assertEqual(kstrip.wheelset_settle(wheelset, track, kstrip.wheel_position(lateral=3e-3), VELOCITY, 100e3), before)
        del junk

    def test_they_pass_through_other_processes(self):
        things = list(OBJECTS.values())
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            self.assertEqual(pool.map_async(repr, things).get(timeout=120), [repr(thing) for thing in things])
            wheelset, track = kstrip.Wheelset(scene.WHEEL, scene.pair(), back_to_back=1.36), kstrip.Track(scene.RAIL, gauge=1.435)
            task = (wheelset, track, kstrip.wheel_position(lateral=3e-3), VELOCITY, 100e3)
            self.assertEqual(pool.apply_async(kstrip.wheelset_settle, task).get(timeout=120), kstrip.wheelset_settle(*task))

    @unittest.skipIf(importlib.util.find_spec("joblib") is None, "SKIPPED: joblib with the Python binding, because there is no joblib")
    def test_they_pass_through_joblib(self):
        import joblib

        things = list(OBJECTS.values())
        self.assertEqual(joblib.Parallel(n_jobs=2)(joblib.delayed(repr)(thing) for thing in things), [repr(thing) for thing in things])

    def test_threads_have_their_own_results(self):
        """Also where a handler of warnings calls the library before the result is returned."""
        motions = kstrip.creepage(np.concatenate((np.linspace(1e-4, 1e-2, 40), np.full(10, 20.0))))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            expected = [kstrip.evaluate(CONTACT, motion) for motion in motions]
            heights = kstrip.wheel_position(lateral=np.linspace(-12e-3, -8e-3, 50), vertical=1e-4)
            wheels = [kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, VELOCITY) for place in heights]

        def work(i):
            motion, place = motions[i % 50], heights[i % 50]
            found = kstrip.evaluate(CONTACT, motion)
            return kstrip.solve(CONTACT, motion), found, kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, VELOCITY)

        with warnings.catch_warnings(), concurrent.futures.ThreadPoolExecutor(4) as threads:
            warnings.simplefilter("always")
            warnings.showwarning = lambda *given: kstrip.solve(CONTACT, kstrip.creepage(5e-5))
            for i, (result, found, wheel) in enumerate(threads.map(work, range(400))):
                self.assertEqual((result, found, wheel), (expected[i % 50].result, expected[i % 50], wheels[i % 50]))


class Values(unittest.TestCase):
    def test_modules_are_those_of_the_header(self):
        header = (FOLDER.parents[1] / "include" / "kstrip.h").read_text(encoding="utf-8")
        for name, expected in (("_table", write_types.table(header)), ("values", write_types.values(header))):
            written = (FOLDER / "kstrip" / f"{name}.py").read_text(encoding="utf-8")
            self.assertTrue(written == expected, f"kstrip/{name}.py is not what the header says: python bindings/python/write_types.py")
        for name, kind in kstrip.values.classes.items():
            self.assertEqual(list(kind.__match_args__), [member for member in kstrip.dtypes[name].names if member != "reserved"])
        self.assertEqual([kstrip.Contact._units["a"], kstrip.Radii._units["lower_y"], kstrip.Wrench._units["moment"]], ["m", "m", "N m"])
        self.assertIn("Semi-axis", kstrip.Contact.__doc__)

    def test_layouts_are_those_of_c(self):
        """The bytes of each value, and of the structures that hold addresses."""
        for kind, thing in OBJECTS.items():
            if isinstance(thing, kstrip.Value):
                batch = numbered(kind)
                self.assertEqual(kstrip.Batch(kind, list(batch)), batch)
                self.assertEqual(kstrip.Batch(kind, [thing])[0], thing)
        for single in (False, True):
            rail, wheel = (kstrip.prepare_profile(given.y, given.z, dtype=np.float32 if single else np.float64) for given in (scene.RAIL, scene.WHEEL))
            suffix = "_f32" * single
            wheelset = kstrip.Wheelset(wheel, scene.pair(), left_pair=scene.pair(left=True), back_to_back=1.36, running_circles=1.5)
            raw = np.frombuffer(wheelset.structure(single)[0], kstrip.dtypes["wheelset" + suffix])[0]
            self.assertEqual((raw["pair"]["left"].tolist(), round(float(raw["back_to_back"]), 4), float(raw["running_circles"])), ([0, 1], 1.36, 1.5))
            track = kstrip.Track(rail, gauge=1.5, origin=(0.75, 0.5), motion=kstrip.rail_motion(lateral=[0.0, 0.25]))
            raw = np.frombuffer(track.structure(single)[0], kstrip.dtypes["track" + suffix])[0]
            self.assertEqual((float(raw["gauge"]), raw["origin"].tolist(), raw["motion"]["lateral"].tolist()), (1.5, [0.75, 0.5], [0.0, 0.25]))

    def test_members_are_attributes(self):
        curve = kstrip.solve(CONTACT, kstrip.creepage([0.0, 1e-3, 2e-3]))
        self.assertEqual((curve.kind, len(curve), curve.ndim, curve.size, curve.statuses.tolist()), (kstrip.Result, 3, 1, 3, [0, 0, 0]))
        np.testing.assert_array_equal(curve.fx, curve["fx"])
        self.assertIs(type(curve.fx), np.ndarray)
        self.assertIsInstance(curve[1], kstrip.Result)
        self.assertIs(type(curve[1].fx), float)
        self.assertEqual(curve[1:].fx.tolist(), curve.fx[1:].tolist())
        self.assertEqual([each.fx for each in curve], curve.fx.tolist())
        self.assertEqual(curve.reshape(3, 1).statuses.shape, (3, 1))
        contacts = kstrip.contact(**{**STEEL, "a": [6e-3, 7e-3]})
        contacts.friction = [0.1, 0.2]
        contacts[1] = dataclasses.replace(contacts[1], a=8e-3)
        self.assertEqual((contacts.friction.tolist(), contacts.a.tolist()), ([0.1, 0.2], [6e-3, 8e-3]))
        patch = kstrip.patch_from_contact(CONTACT)
        self.assertIsInstance(patch.strips[0], kstrip.PatchStrip)
        self.assertEqual(patch.strips.y.shape, (64,))
        one = kstrip.contact(**STEEL)
        one.a, one["b"] = 7e-3, 5e-3
        self.assertEqual((one.a, one["b"], one == CONTACT, dataclasses.replace(one, a=6e-3, b=4.5e-3) == CONTACT), (7e-3, 5e-3, False, True))
        match one:
            case kstrip.Contact(a=length):
                self.assertEqual(length, 7e-3)
        for wrong in (lambda: setattr(contacts, "frction", 0.1), lambda: contacts.frction, lambda: setattr(one, "frction", 0.1), lambda: one.frction):
            with self.assertRaisesRegex(AttributeError, "frction"):
                wrong()
        with self.assertRaises(TypeError):
            contacts[0] = kstrip.creepage(1e-3)

    def test_they_print_with_names_and_units(self):
        self.assertEqual(repr(CONTACT), "Contact(a=0.006 m, b=0.0045 m, normal_force=80000 N, shear_modulus=8.2e+10 Pa, "
                                        "poisson_ratio=0.28, friction=0.3, mismatch=0)")
        results = kstrip.solve(CONTACT, kstrip.creepage(np.linspace(0, 1e-2, 1000)))
        self.assertRegex(str(results), r"Result of shape \(1000,\)\n +fx +N +\[ *0\. .* \.\.\. .*\]\n +fy")
        self.assertNotIn("reserved", str(results))
        self.assertLess(len(str(results).splitlines()), 10)
        self.assertIn("PatchStrip of shape (64,)", str(kstrip.patch_from_contact(CONTACT)))
        self.assertRegex(results._repr_html_(), r"<th>fx \[N\]</th>.*<td>999</td>")
        self.assertIn("<td>fx</td><td>8", kstrip.solve(CONTACT, kstrip.creepage(1e-3))._repr_html_())
        self.assertIn("<td>N m</td>", kstrip.solve(CONTACT, kstrip.creepage(1e-3))._repr_html_())
        self.assertIn("jacobian", kstrip.evaluate(CONTACT, kstrip.creepage([1e-3, 2e-3]))._repr_html_())

    def test_dir_lists_members(self):
        result = kstrip.solve(CONTACT, kstrip.creepage(1e-3))
        self.assertEqual(dir(result), ["adhesion", "fx", "fy", "mz", "power", "status_detail"])
        self.assertEqual(set(dir(kstrip.solve(CONTACT, kstrip.creepage([1e-3])))) - set(dir(result)),
                         {"kind", "data", "statuses", "shape", "ndim", "size", "copy", "reshape", "columns"})

    @unittest.skipIf(importlib.util.find_spec("pandas") is None, "SKIPPED: tables of the Python binding, because there is no pandas")
    def test_results_are_tables(self):
        import pandas

        results = kstrip.solve(CONTACT, kstrip.creepage([0.0, 1e-3, 2e-3]))
        for table, rows in ((pandas.DataFrame(results), 3), (pandas.DataFrame(list(results)), 3), (pandas.DataFrame([results[2]]), 1),
                            (pandas.DataFrame(results.columns()), 3)):
            self.assertEqual((list(table.columns), len(table)), (["fx", "fy", "mz", "power", "adhesion", "status_detail"], rows))
            self.assertEqual(table.fx.tolist(), results.fx[-rows:].tolist())
        wheels = scene.forces(np.array([0.0, 1e-3])).wrench
        for table in (pandas.DataFrame(wheels), pandas.DataFrame(list(wheels)), pandas.DataFrame([wheels[0]])):
            self.assertEqual(list(table.columns)[:4], ["force_0", "force_1", "force_2", "moment_0"])
            self.assertEqual((table.force_1[0], table.contacts[0]), (wheels.force[0, 1], 1))
        self.assertEqual(dict(wheels[1])["moment_2"], wheels.moment[1, 2])
        nested = pandas.DataFrame([kstrip.fit_friction(np.linspace(1e-3, 1e-2, 9), np.linspace(7e3, 2e4, 9), CONTACT)])
        self.assertIn("law_slope_factor", nested.columns)

    def test_a_wrong_shape_names_argument_and_shape(self):
        two, three = kstrip.contact(**{**STEEL, "a": [1e-3, 2e-3]}), kstrip.creepage([0.0] * 3)
        place, velocity = kstrip.wheel_position(lateral=np.zeros((2, 1))), kstrip.wheel_velocity(forward=20.0, pitch=[-43.0] * 3)
        for call, words in [
            (lambda: kstrip.solve(two, three), "contacts (2,), creepages (3,)"),
            (lambda: kstrip.solve_motion(two, kstrip.motion([0.0] * 3)), "contacts (2,), motions (3,)"),
            (lambda: kstrip.creepage([1, 2], [1, 2, 3]), "creepage.longitudinal (2,), creepage.lateral (3,)"),
            (lambda: kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(left=[False] * 4), place, velocity),
             "pair (4,), position (2, 1), velocity (3,)"),
            (lambda: kstrip.height_for_load(scene.RAIL, scene.WHEEL, scene.pair(), place[0], [1.0, 2.0], velocity),
             "position (1,), support (2,), velocity (3,)"),
            (lambda: kstrip.strips(two, three[0]), "area: one Contact is needed, and this has the shape (2,)"),
            (lambda: kstrip.gauge_face(scene.RAIL, [0.01, 0.02]), "depth: one number is needed, and this has the shape (2,)"),
            (lambda: kstrip.fit_friction([1.0, 2.0], 1.0, CONTACT), "force: n numbers, or n rows of two, are needed, and this has the shape ()"),
            (lambda: kstrip.prepare_profile([0.0, 1.0], [0.0]), "y (2,), z (1,)"),
            (lambda: kstrip.patch_from_profile([0.0, 1.0], [0.0, 0.0], rolling_radius=[1.0], shear_modulus=1.0, poisson_ratio=0.0, friction=0.0),
             "y (2,), rolling_radius (1,)"),
        ]:
            with self.assertRaises(ValueError) as caught:
                call()
            self.assertIn(words, str(caught.exception))

    def test_arguments_of_wheels_broadcast(self):
        shifts, sides = np.linspace(-2e-3, 6e-3, 5), np.array([[False], [True]])
        wheels = scene.forces(shifts, sides)
        self.assertEqual((wheels.wrench.shape, wheels.wrench.force.shape, wheels.contacts.shape[:2]), ((2, 5), (2, 5, 3), (2, 5)))
        for i, left in enumerate((False, True)):
            for j, shift in enumerate(shifts):
                one = scene.forces(shift, left)
                self.assertEqual((one.wrench, one.derivatives), (wheels.wrench[i, j], wheels.derivatives[i, j]))
                count = len(one.contacts)
                self.assertEqual(one.contacts, wheels.contacts[i, j, :count])
                self.assertFalse(one.contacts[0].patch.strips[one.contacts[0].patch.count :].peak_pressure.any())
                self.assertFalse(wheels.contacts[i, j, count:].normal_force.any())
        place = scene.carried(shifts)
        # Each with its own law: the first one falls at once
        laws = kstrip.friction(0.3, [0.4, 1.0, 1.0, 1.0, 1.0], 0.6, 20.0)
        fast = kstrip.wheel_velocity(forward=20.0, pitch=-48.0)
        law, none = (kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, fast, each).wrench.force[:, 0] for each in (laws, None))
        self.assertLess(law[0], 0.8 * none[0])
        np.testing.assert_allclose(law[1:], none[1:], rtol=1e-12)
        # Friction is a number like the others: numbers in two dimensions are no places on the rail
        steel = dict(wheel_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28)
        self.assertEqual(kstrip.wheel_pair(**steel, friction=[[0.1, 0.2], [0.3, 0.4]]).shape, (2, 2))
        places = kstrip.wheel_pair(**steel, friction_places=[[0.1, 0.2], [0.3, 0.4]])
        self.assertEqual((places.friction_points, places.friction_places.tolist()), (2, [[0.1, 0.2], [0.3, 0.4]]))
        places.friction_places = [(0.0, 0.5)]
        self.assertEqual((places.friction_points, places.friction_at.tolist()), (1, [0.5, 0.0, 0.0, 0.0]))
        self.assertEqual(kstrip.height_for_load(scene.RAIL, scene.WHEEL, scene.pair(), place[:0], 1e4).shape, (0,))
        self.assertEqual(kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place[:0], fast).contacts.shape, (0, 0))

    def test_threads_and_progress_leave_the_bits(self):
        """Every function of arrays, with a bad element among them: one thread without a bar, and three with one."""
        contacts, creepages = kstrip.contact(**{**CONTACT, "friction": np.linspace(0.0, 0.5, 20_000)}), kstrip.creepage(1e-3, spin=0.2)
        contacts.friction[[5, 9000]] = -1.0
        place = kstrip.wheel_position(lateral=np.append(np.linspace(-14e-3, -4e-3, 199), 0.5))
        moves, steel = kstrip.wheel_velocity(forward=20.0, pitch=-43.3), scene.pair()
        place.vertical[:199] = kstrip.height_for_load(scene.RAIL, scene.WHEEL, steel, place[:199], 8e4)
        wheelset, track = kstrip.Wheelset(scene.WHEEL, steel, back_to_back=1.36), kstrip.Track(scene.RAIL, gauge=1.435)
        starts = kstrip.wheel_position(lateral=np.append(np.linspace(-3e-3, 3e-3, 69), 0.5))
        few = contacts[:200]
        for call in (
            lambda **how: kstrip.solve(contacts, creepages, **how),
            lambda **how: kstrip.evaluate(contacts, creepages, law_derivatives=True, **how),
            lambda **how: kstrip.evaluate(kstrip.patch_from_contact(CONTACT), kstrip.creepage(np.linspace(0.0, 0.01, 200)), **how),
            lambda **how: kstrip.solve_motion(few, kstrip.motion(1e-3, rolling_speed=1.0), **how),
            lambda **how: kstrip.estimate_friction(few, creepages, fx=1e3, **how),
            lambda **how: kstrip.creepage_for_force(few, 1e3, 0.0, **how),
            lambda **how: kstrip.height_for_load(scene.RAIL, scene.WHEEL, steel, place, 8e4, **how),
            lambda **how: kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, steel, place, moves, by_position=True, **how),
            lambda **how: kstrip.wheelset_settle(wheelset, track, starts, moves, 1e5, **how),
            lambda **how: kstrip.wheelset_on_track(wheelset, track, starts, moves, **how),
            lambda **how: kstrip.rolling_radius_difference(wheelset, track, np.linspace(-3e-3, 3e-3, 200), **how),
        ):
            with contextlib.redirect_stderr(io.StringIO()) as shown, warnings.catch_warnings():
                warnings.simplefilter("ignore", kstrip.KstripWarning)
                one, three = call(on_error="nan"), call(on_error="nan", threads=3, progress=True)
            self.assertEqual(pickle.dumps(one), pickle.dumps(three))
            if importlib.util.find_spec("tqdm") is not None:
                self.assertRegex(shown.getvalue(), r"\w+: +100%.*\| (\d+)/\1 \[")
        with self.assertRaises(kstrip.KstripError) as caught:
            kstrip.solve(contacts, creepages, threads=2)
        self.assertEqual(caught.exception.index, (5,))
        for threads in (0, 1.5, None):
            with self.assertRaisesRegex(ValueError, "threads: a whole number, 1 or more"):
                kstrip.solve(contacts, creepages, threads=threads)

    def test_progress_needs_no_tqdm(self):
        with unittest.mock.patch.dict(sys.modules, {"tqdm": None}), contextlib.redirect_stderr(io.StringIO()) as shown:
            self.assertTrue(np.isfinite(kstrip.solve(CONTACT, kstrip.creepage([1e-3, 2e-3]), progress=True).fx).all())
        self.assertEqual(shown.getvalue(), "")

    def test_help_is_short_and_begins_with_the_functions(self):
        self.assertEqual([name for name in kstrip.__all__ if not hasattr(kstrip, name)], [])
        self.assertEqual({name for name, value in PUBLIC.items() if inspect.isfunction(value)} - set(kstrip.__all__), set())
        for name, value in PUBLIC.items():
            self.assertGreater(len(inspect.getdoc(value) or ""), 20, name)
            if inspect.isfunction(value):
                self.assertIn(name, kstrip.__doc__)
        pages = {name: pydoc.render_doc(value, renderer=pydoc.plaintext) for name, value in {**PUBLIC, "kstrip": kstrip}.items()}
        self.assertIn("\n    solve(contacts", pages["kstrip"].split("FUNCTIONS")[1])
        self.assertNotIn("CLASSES", pages["kstrip"].split("FUNCTIONS")[0])
        for name, page in pages.items():
            self.assertLessEqual(len(page.splitlines()), 3000 if name == "kstrip" else 80 if name == "WheelPair" else 120, name)

    def test_every_function_has_an_example_that_runs(self):
        for name, value in PUBLIC.items():
            count, failures, _ = run_examples(name)
            with self.subTest(name=name):
                self.assertEqual(failures, "")
                self.assertTrue(count > 0 or inspect.isclass(value), f"{name}: no example")

    def test_warning_names_the_line_of_the_user(self):
        for call in (lambda: kstrip.solve(CONTACT, kstrip.creepage(20.0)), lambda: kstrip.prepare(CONTACT).solve(kstrip.creepage([20.0]))):
            with self.assertWarns(kstrip.KstripWarning) as caught:
                call()
            self.assertEqual(os.path.basename(caught.filename), "test_values.py")


class Typed(unittest.TestCase):
    """mypy and pyright pass the package and the examples, and find an argument that stands for another."""

    RIGHT = """
import numpy as np
import kstrip
contact = kstrip.contact(a=6e-3, b=[4e-3, 5e-3], normal_force=8e4, shear_modulus=8e10, poisson_ratio=0.28, friction=0.3)
result = kstrip.solve(contact, kstrip.creepage(1e-3), kstrip.friction(0.3, 0.4))
print(float(result[0].fx) + result.fy.sum(), result["mz"].mean(), contact[1].a * 2)
contact.friction = 0.2
contact[0] = kstrip.contact(a=6e-3, b=4e-3, normal_force=8e4, shear_modulus=8e10, poisson_ratio=0.28, friction=0.3)
place = kstrip.wheel_position(lateral=np.zeros(3))
place.vertical = np.ones(3)
print(kstrip.evaluate(contact, kstrip.creepage()).result.fx, kstrip.patch_from_contact(contact[0]).strips[:3].friction)
found = kstrip.estimate_friction(contact[0], kstrip.creepage(1e-3), fx=result.fx[0])
"""
    WRONG = [
        "kstrip.solve(kstrip.creepage(1e-3), contact)",
        "kstrip.solve(contact, contact)",
        "kstrip.solve(contact, 1e-3)",
        "kstrip.wheel_on_rail(place, place, place, place, place)",
        "kstrip.solve(contact, kstrip.motion())",
        "kstrip.solve(contact[0], kstrip.creepage(1e-3)).fz",
    ]

    @staticmethod
    def run_checker(name, files):
        command = [sys.executable, "-m", name]
        command += ["--strict", "--python-executable", sys.executable] if name == "mypy" else ["--pythonpath", sys.executable]
        # So that both work at the same time
        return subprocess.Popen([*command, *map(str, files)], cwd=FOLDER, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                env={**os.environ, "MYPYPATH": str(FOLDER), "PYTHONPATH": str(FOLDER), "PYRIGHT_PYTHON_IGNORE_WARNINGS": "1",
                                     "MYPY_CACHE_DIR": os.path.join(tempfile.gettempdir(), "kstrip_mypy")})

    def test_checkers(self):
        names = [name for name in ("mypy", "pyright") if importlib.util.find_spec(name) is not None]
        if not names or importlib.util.find_spec("matplotlib") is None:
            self.skipTest("SKIPPED: types of the Python binding, because mypy and pyright, or matplotlib, are missing")
        with tempfile.TemporaryDirectory() as folder:
            right, wrong = pathlib.Path(folder) / "right.py", pathlib.Path(folder) / "wrong.py"
            right.write_text(self.RIGHT, encoding="utf-8")
            wrong.write_text(self.RIGHT + "\n".join(self.WRONG) + "\n", encoding="utf-8")
            first = len(self.RIGHT.splitlines()) + 1
            examples = [FOLDER / name for name in ("tour.py", "wheel_on_rail.py", "pictures.py")]
            if importlib.util.find_spec("scipy") is not None:
                examples.append(FOLDER / "vehicle.py")
            runs = {name: self.run_checker(name, [FOLDER / "kstrip", right, wrong, *(examples if name == "pyright" else [])]) for name in names}
            said_by = {name: run.communicate()[0] for name, run in runs.items()}
            for name, said in said_by.items():
                at = {int(line) for file, line in re.findall(r"(\w+)\.py:(\d+):[\d: -]*error", said) if file == "wrong"}
                elsewhere = [line for line in said.splitlines() if re.search(r"\.py:\d+.*error", line) and "wrong.py" not in line]
                self.assertEqual(elsewhere, [], said)
                self.assertEqual(at, set(range(first, first + len(self.WRONG))), said)


if __name__ == "__main__":
    unittest.main()
