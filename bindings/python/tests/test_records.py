"""Named results with units, shapes in messages, arrays of wheels, and what a type checker sees."""

import importlib.util
import inspect
import io
import os
import pathlib
import pickle
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

sys.path.insert(0, os.path.join(os.path.dirname(__file__), os.pardir))

try:
    import fcntl
    import pty
    import termios
except ImportError:  # (Windows)
    pty = None

import numpy as np

import kstrip
import wheel_on_rail as scene
import write_types
from kstrip import _calls

FOLDER = pathlib.Path(__file__).resolve().parents[1]
STEEL = dict(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
CONTACT = kstrip.contact(**STEEL)


class Records(unittest.TestCase):
    def test_types_are_those_of_the_header(self):
        written = (FOLDER / "kstrip" / "_types.py").read_text(encoding="utf-8")
        expected = write_types.text((FOLDER.parents[1] / "include" / "kstrip.h").read_text(encoding="utf-8"))
        self.assertTrue(written == expected, "kstrip/_types.py is not what the header says: python bindings/python/write_types.py")
        for name, kind in kstrip.classes.items():
            members = [member for member in kstrip.dtypes[name].names if member != "reserved"]
            self.assertEqual(list(kind._members), members)
            self.assertTrue(kind.__doc__)
            self.assertFalse([member for member in members if hasattr(np.ndarray, member)])
        self.assertEqual([kstrip.Contact.a.unit, kstrip.Radii.lower_y.unit, kstrip.Wrench.moment.unit], ["m", "m", "N m"])
        self.assertIn("Semi-axis", kstrip.Contact.a.__doc__)

    def test_members_are_attributes(self):
        curve = kstrip.solve(CONTACT, kstrip.creepage([0.0, 1e-3, 2e-3]))
        self.assertIsInstance(curve, kstrip.Result)
        np.testing.assert_array_equal(curve.fx, curve["fx"])
        self.assertIs(type(curve.fx), np.ndarray)
        self.assertIsInstance(curve[1], kstrip.Result)
        self.assertEqual(curve[1].shape, ())
        self.assertEqual(curve[1:].fx.tolist(), curve.fx[1:].tolist())
        self.assertEqual([each.fx for each in curve], curve.fx.tolist())
        contacts = kstrip.contact(**{**STEEL, "a": [6e-3, 7e-3]})
        contacts.friction = [0.1, 0.2]
        contacts[1].a = 8e-3
        self.assertEqual((contacts.friction.tolist(), contacts.a.tolist()), ([0.1, 0.2], [6e-3, 8e-3]))
        patch = kstrip.patch_from_contact(CONTACT)
        self.assertIsInstance(patch.strips[0], kstrip.PatchStrip)
        self.assertEqual(patch.strips.y.shape, (64,))
        for wrong in (lambda: setattr(contacts, "frction", 0.1), lambda: contacts.frction):
            with self.assertRaisesRegex(AttributeError, "frction"):
                wrong()
        again = pickle.loads(pickle.dumps(contacts))
        self.assertIsInstance(again, kstrip.Contact)
        np.testing.assert_array_equal(again.a, contacts.a)

    def test_they_print_with_names_and_units(self):
        self.assertEqual(repr(CONTACT), "Contact(a=0.006 m, b=0.0045 m, normal_force=80000 N, shear_modulus=8.2e+10 Pa, "
                                        "poisson_ratio=0.28, friction=0.3, mismatch=0)")
        text = str(kstrip.solve(CONTACT, kstrip.creepage(np.linspace(0, 1e-2, 1000))))
        self.assertRegex(text, r"Result of shape \(1000,\)\n +fx +N +\[ *0\. .* \.\.\. .*\]\n +fy")
        self.assertNotIn("reserved", text)
        self.assertLess(len(text.splitlines()), 10)
        self.assertIn("PatchStrip of shape (64,)", str(kstrip.patch_from_contact(CONTACT)))

    def test_a_wrong_shape_names_argument_and_shape(self):
        two, three = kstrip.contact(**{**STEEL, "a": [1e-3, 2e-3]}), kstrip.creepage([0.0] * 3)
        place, velocity = kstrip.wheel_position(lateral=np.zeros((2, 1))), kstrip.wheel_velocity(forward=20.0, pitch=[-43.0] * 3)
        rails = np.stack([scene.RAIL, scene.RAIL])
        for call, words in [
            (lambda: kstrip.solve(two, three), "contacts (2,), creepages (3,)"),
            (lambda: kstrip.solve_motion(two, kstrip.motion([0.0] * 3)), "contacts (2,), motions (3,)"),
            (lambda: kstrip.creepage([1, 2], [1, 2, 3]), "creepage.longitudinal (2,), creepage.lateral (3,)"),
            (lambda: kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(left=[False] * 4), place, velocity),
             "pair (4,), position (2, 1), velocity (3,)"),
            (lambda: kstrip.height_for_load(scene.RAIL, scene.WHEEL, scene.pair(), place[0], [1.0, 2.0], velocity),
             "pair (), position (1,), velocity (3,), support (2,)"),
            (lambda: kstrip.wheel_on_rail(rails, scene.WHEEL, scene.pair(), place, velocity), "rail: one is needed, and this has the shape (2,)"),
            (lambda: kstrip.strips(two, three[0]), "contact: one is needed, and this has the shape (2,)"),
            (lambda: kstrip.prepare_profile([0.0, 1.0], [0.0]), "y (2,), z (1,)"),
            (lambda: kstrip.patch_from_profile([0.0, 1.0], [0.0, 0.0], rolling_radius=[1.0], shear_modulus=1.0, poisson_ratio=0.0, friction=0.0),
             "y (2,), rolling_radius (1,)"),
        ]:
            with self.assertRaises(ValueError) as caught:
                call()
            self.assertIn(words, str(caught.exception))

    def test_many_wheels_are_one_call(self):
        shifts, sides = np.linspace(-2e-3, 6e-3, 5), np.array([[False], [True]])
        wheels = scene.forces(shifts, sides)
        self.assertEqual((wheels.wrench.shape, wheels.wrench.force.shape, wheels.contacts.shape[:2]), ((2, 5), (2, 5, 3), (2, 5)))
        for i, left in enumerate((False, True)):
            for j, shift in enumerate(shifts):
                one = scene.forces(shift, left)
                self.assertEqual(one.wrench.tobytes(), wheels.wrench[i, j].tobytes())
                self.assertEqual(one.derivatives.tobytes(), wheels.derivatives[i, j].tobytes())
                count = len(one.contacts)
                self.assertEqual(one.contacts.tobytes(), wheels.contacts[i, j, :count].tobytes())
                self.assertFalse(one.contacts[0].patch.strips[int(one.contacts[0].patch.count) :].peak_pressure.any())
                self.assertFalse(wheels.contacts[i, j, count:].normal_force.any())
        place = scene.carried(shifts)
        velocity = kstrip.wheel_velocity(forward=20.0, pitch=-43.4)
        bare = kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, velocity, by_position=True, contacts=False)
        self.assertEqual((bare.contacts.shape, bare.by_position.shape), ((5, 0), (5,)))
        # in one call of C: the same bits
        full = kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, velocity, by_position=True)
        for name in ("wrench", "derivatives", "by_position"):
            self.assertEqual(getattr(full, name).tobytes(), getattr(bare, name).tobytes())
        # Each with its own law: the first one falls at once
        laws = kstrip.friction(0.3, [0.4, 1.0, 1.0, 1.0, 1.0], 0.6, 20.0)
        fast = kstrip.wheel_velocity(forward=20.0, pitch=-48.0)
        law, none = (kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, fast, each).wrench.force[:, 0] for each in (laws, None))
        self.assertLess(law[0], 0.8 * none[0])
        np.testing.assert_allclose(law[1:], none[1:], rtol=1e-12)
        place.lateral[3] = 0.3
        with self.assertRaisesRegex(kstrip.KstripError, "at index 3"):
            kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, velocity)
        with self.assertRaisesRegex(kstrip.KstripError, "at index 3"):
            kstrip.wheel_on_rail(scene.RAIL, scene.WHEEL, scene.pair(), place, velocity, contacts=False)
        self.assertEqual(kstrip.height_for_load(scene.RAIL, scene.WHEEL, scene.pair(), place[:0], 1e4).shape, (0,))

    def test_long_sweeps_have_a_progress_bar_on_a_terminal(self):
        if importlib.util.find_spec("tqdm") is None:
            self.skipTest("SKIPPED: the progress bar of the Python binding, because there is no tqdm")
        self.assertIsInstance(_calls.progress(10**6, "a file, not a terminal"), range)
        terminal = io.StringIO()
        terminal.isatty = lambda: True
        with unittest.mock.patch.object(sys, "stderr", terminal):
            self.assertIsInstance(_calls.progress(10, "a few"), range)
            bar = _calls.progress(5000, "a sweep")
            # (what takes less than two seconds shows nothing)
            self.assertEqual((sum(bar), bar.delay, terminal.getvalue()), (4999 * 2500, 2.0, ""))

    def on_a_terminal(self, program, until=None):
        """What a program writes to a terminal of its own, and its exit status; ended at once when that has appeared."""
        terminal, end = pty.openpty()
        fcntl.ioctl(end, termios.TIOCSWINSZ, struct.pack("4H", 24, 100, 0, 0))
        with subprocess.Popen([sys.executable, "-c", program], cwd=FOLDER, stdin=end, stdout=end, stderr=end,
                              env={**os.environ, "TERM": "xterm"}) as child:
            os.close(end)
            shown = b""
            try:
                while until is None or until not in shown:
                    shown += os.read(terminal, 4096)
            except OSError:
                # (a terminal that nobody writes to any more)
                pass
            else:
                child.kill()
            os.close(terminal)
        return shown.decode(errors="replace"), child.returncode

    @unittest.skipIf(pty is None, "SKIPPED: the progress bar on a terminal, because there are no pseudoterminals")
    def test_a_sweep_on_a_terminal_shows_its_bar_and_needs_no_tqdm(self):
        sweep = """
import sys
{before}
import numpy as np
import kstrip, wheel_on_rail as scene
place = kstrip.wheel_position(lateral=np.linspace(-0.011, -0.009, {count}))
heights = kstrip.height_for_load(scene.RAIL, scene.WHEEL, scene.pair(), place, 8e4)
print("answers:", np.isfinite(heights).sum())
"""
        # Without tqdm, and in less than two seconds: nothing but the result
        self.assertEqual(self.on_a_terminal(sweep.format(before="sys.modules['tqdm'] = None", count=1200)), ("answers: 1200\r\n", 0))
        if importlib.util.find_spec("tqdm") is None:
            self.skipTest("SKIPPED: the progress bar of the Python binding, because there is no tqdm")
        # So many that no machine is done before two seconds
        shown, _ = self.on_a_terminal(sweep.format(before="", count=100_000), b"it/s")
        self.assertRegex(shown, r"heights_for_loads: +\d+%.*\| \d+/1000 \[00:0[2-9]<")

    def test_help_is_a_page_and_everything_has_one(self):
        missing = [name for name in kstrip.__all__ if not hasattr(kstrip, name)]
        self.assertEqual(missing, [])
        public = {name for name, value in vars(kstrip).items() if not name.startswith("_") and not inspect.ismodule(value)}
        self.assertEqual(public - set(kstrip.__all__), set())
        for name in kstrip.__all__:
            value = getattr(kstrip, name)
            if inspect.isfunction(value) or inspect.isclass(value):
                self.assertGreater(len(inspect.getdoc(value) or ""), 20, name)
            if inspect.isfunction(value):
                self.assertIn(name, kstrip.__doc__)
        self.assertLess(len(kstrip.__doc__.splitlines()), 60)

    def test_examples_of_docstrings_print_what_they_say(self):
        shown = 0
        for name in kstrip.__all__:
            doc = inspect.getdoc(getattr(kstrip, name)) or ""
            examples = re.findall(r"^>>> (.*)\n((?!>>>).+)?", doc, re.M) if inspect.isfunction(getattr(kstrip, name)) else []
            scope = {"kstrip": kstrip, "np": np}
            if not any(output for _, output in examples):
                continue
            for code, output in examples:
                if output:
                    found = str(eval(code.removeprefix("print(").removesuffix(")"), scope)) if code.startswith("print(") else repr(eval(code, scope))
                    self.assertEqual(found, output.strip(), name)
                    shown += 1
                else:
                    exec(code, scope)
        self.assertGreater(shown, 5)

    def test_warning_names_the_line_of_the_user(self):
        for call in (lambda: kstrip.solve(CONTACT, kstrip.creepage(20.0)), lambda: kstrip.prepare(CONTACT).solve(kstrip.creepage([20.0]))):
            with self.assertWarns(kstrip.KstripWarning) as caught:
                call()
            self.assertEqual(os.path.basename(caught.filename), "test_records.py")


class Typed(unittest.TestCase):
    """mypy and pyright pass the package and the examples, and find an argument that stands for another."""

    RIGHT = """
import numpy as np
import kstrip
contact = kstrip.contact(a=6e-3, b=[4e-3, 5e-3], normal_force=8e4, shear_modulus=8e10, poisson_ratio=0.28, friction=0.3)
result = kstrip.solve(contact, kstrip.creepage(1e-3), kstrip.friction(0.3, 0.4))
print(float(result[0].fx) + result.fy.sum(), result["mz"].mean(), contact[1].a * 2)
contact.friction = 0.2
contact[0].a = 1e-3
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
        "result.fz",
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
            runs = {name: self.run_checker(name, [FOLDER / "kstrip", right, wrong, *(examples if name == "pyright" else [])]) for name in names}
            said_by = {name: run.communicate()[0] for name, run in runs.items()}
            for name, said in said_by.items():
                at = {int(line) for file, line in re.findall(r"(\w+)\.py:(\d+):[\d: -]*error", said) if file == "wrong"}
                elsewhere = [line for line in said.splitlines() if re.search(r"\.py:\d+.*error", line) and "wrong.py" not in line]
                self.assertEqual(elsewhere, [], said)
                self.assertEqual(at, set(range(first, first + len(self.WRONG))), said)


if __name__ == "__main__":
    unittest.main()
