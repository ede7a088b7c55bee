#!/usr/bin/env python3
"""The browser demo in headless Chromium: its numbers and pictures are those of the C library, bit for bit; calls, errors, inputs, files, keyboard, link.

    scripts/web.sh && scripts/library.sh && python3 tests/web/page.py
    scripts/web.sh && python3 tests/web/page.py --picture docs/figures/page.png

Needs Chromium and the package playwright. Exit status 77: something is missing (a line with SKIPPED says what).
The sizes of the page and the times after a move of a slider are printed, not tested: they depend on the machine.
"""

import csv
import gzip
import math
import os
import pathlib
import re
import shutil
import sys
import tempfile

import pixels
from programs import LIBRARY, POINT, ROOT, STRIP, TARGET, bits, contact_with_pictures, numbers, printed, rows, run_c, run_python, wheel_with_pictures

HERE = pathlib.Path(__file__).resolve().parent
PAGE = TARGET / "web" / "index.html"
PICTURE = ROOT / "docs" / "figures" / "page.png"
MODELS = ["TOTAL", "STRIP", "STRIP_1967", "STRIP_1967_CONTINUOUS", "LINEAR"]


def skip(what):
    print(f"SKIPPED: tests of the browser demo, because there is no {what}")
    sys.exit(77)


BROWSER = os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
if not BROWSER:
    skip("Chromium")
try:
    from playwright.sync_api import sync_playwright
except ImportError:
    skip("package playwright for Python")
if not shutil.which("cc"):
    skip("C compiler (cc)")
for file, command in ((PAGE, "scripts/web.sh"), (LIBRARY, "scripts/library.sh")):
    assert file.exists(), f"{file} is missing: run {command}"

sys.path.insert(0, str(ROOT / "web"))
import calls  # noqa: E402
import header  # noqa: E402

#: Ten states of the first view, and four of the second
CONTACTS = [
    "", "vx=-0.35&vy=0.2&phi=3", "vx=0&phi=0", "N=0", "N=3.7&ly=13&ux=420&uy=-200&phi=-8", "shape=axes&a=1.3&b=9&vy=0.07",
    "law=true&vx=1.2", "law=true&A=0.3&B=1.1&V=55&k=0.4&vx=0.9&vy=-0.4", "m1=steel&m2=aluminium&G2=26&nu2=0.34&mu=0.6",
    "model=STRIP_1967&sweep=spin&phi=11&mu=0.05&lx=400",
]
WHEELS = ["", "shift=5.9&yaw=-4&turn=0.4&drift=-30", "side=left&shift=-3.2&Q=55.5&v=44", "shift=-7&cant=12&smooth=2&R=400&f=0.45&m=TOTAL"]
#: Inputs that are wrong: view, field, what is typed, a word of the message
WRONG = [
    ("contact", "N", "", "Load N"), ("contact", "mu", "-1", "friction"), ("contact", "ly", "0", "radius"), ("contact", "vx", "1e308", "infinite|range"),
    ("contact", "ux", "-100", "curvature"), ("wheel", "yaw", "", "Yaw"), ("wheel", "Q", "0", "load|force|support"), ("wheel", "Q", "-80", "load|force|support"),
    ("wheel", "R", "-460", "radius"), ("wheel", "smooth", "-1", "smoothing"), ("wheel", "origin", "500", "profile|rail"), ("wheel", "shift", "1e300", "."),
]


class Tests:
    def __init__(self, browser, folder):
        self.browser, self.folder, self.requests, self.errors = browser, folder, [], []
        context = browser.new_context(viewport={"width": 1280, "height": 900})
        context.grant_permissions(["clipboard-read", "clipboard-write"])
        context.add_init_script(path=HERE / "calls.js")
        self.page = context.new_page()
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.on("pageerror", lambda error: self.errors.append(str(error)))
        self.page.on("console", lambda message: self.errors.append(message.text) if message.type == "error" else None)
        self.skipped, self.called = False, set()

    def open(self, state):
        self.page.goto("about:blank")
        self.page.goto(f"{PAGE.as_uri()}#{state}")
        self.page.evaluate("page.ready")

    def show(self, state):
        """Opens a state that is right: no call of the library fails, and no error is shown. Returns page.found."""
        self.open(state)
        assert self.page.evaluate("failures") == [], (state, self.page.evaluate("failures"))
        assert self.errors == [], (state, self.errors)
        assert not self.page.is_visible(".problem"), (state, self.page.inner_text(".problem"))
        self.called |= set(self.page.evaluate("[...called]"))
        return self.page.evaluate("page.found")

    def drawn(self, view):
        return self.page.evaluate((HERE / "drawn.js").read_text(), view)

    def settle(self):
        """Waits until what was changed is computed and drawn."""
        self.page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def until(self, condition, argument=None):
        """Waits for a condition. (The page forbids the evaluation of text, by which Playwright waits.)"""
        for _ in range(200):
            if self.page.evaluate(condition, argument):
                return
            self.page.wait_for_timeout(50)
        raise AssertionError(f"never: {condition}")

    def copied(self, button):
        self.page.click(button)
        self.until("document.getElementById('copied').textContent.endsWith('in the clipboard.')")
        text = self.page.evaluate("navigator.clipboard.readText()")
        self.page.evaluate("document.getElementById('copied').textContent = ''")
        return text

    # Numbers and pictures

    def shown_contact(self):
        cell = lambda model, of: self.page.get_attribute(f"#view-contact tr[data-model={model}] [data-of={of}] data", "value")  # noqa: E731
        found = {}
        for model in MODELS:
            values = self.page.evaluate("(name) => page.found.models.find((model) => model.name === name)", model)
            # The table has the numbers of the library
            for of in ("fx", "fy", "mz", "power", "friction"):
                assert bits(cell(model, of)) == bits(values[of]), (model, of)
            found[model] = [bits(values[of]) for of in ("fx", "fy", "mz", "power", "adhesion", "friction")]
        return found

    def contacts_have_the_bits_of_c(self):
        for state in CONTACTS:
            found = self.show(f"contact&{state}")
            values = self.page.evaluate("valuesOf(contactView)")
            shown = self.shown_contact()
            program = contact_with_pictures(self.copied("#copy-c"), found, values["model"], values["sweep"])
            lines = run_c(program, self.folder)
            tables = [[line for line in lines if line.split()[0] in MODELS]]
            python = run_python(self.copied("#copy-python"))
            if python is None:
                self.skipped = True
            else:
                tables.append(python)
            for table in tables:
                assert {line.split()[0]: [bits(n) for n in numbers(line.split(" ", 1)[1])] for line in table} == shown, f"{state}: {table}, on the page {shown}"
            curves = [["curve", bits(force)] for curve in found["curves"] for _, force in curve["points"]]
            assert printed(lines, ["curve"]) == curves and len(curves) >= 5 * 49, state
            strips, points = rows(found.get("strips", []), "strip", STRIP), rows(found.get("field", []), "point", POINT)
            assert printed(lines, ["strip", "point"]) == strips + points, state
        # The call in README.md: units, and which number is which
        self.show("contact&shape=axes&phi=0.1")
        total = self.page.evaluate("page.found.models[0]")
        assert [round(total["fx"]), round(total["fy"]), round(total["mz"], 1)] == [8731, 2072, 4.4], total

    def contacts_are_drawn(self):
        for state in CONTACTS:
            found = self.show(f"contact&{state}")
            drawn = self.drawn("contact")
            contact = found["contact"]
            assert len(drawn["curves"]) == 5 and min(drawn["curves"]) >= 49, (state, drawn)
            if contact["normal_force"] == 0:
                assert drawn["arrows"] == [] and "no contact" in self.page.inner_html("#view-contact [data-at=patch]"), drawn
                continue
            assert drawn["rings"] == (0 if "law" in state else 21), (state, drawn)
            # The stick area is the library's share of adhesion, and the rest slips
            stick, slip, share = drawn["stick"][0], drawn["slip"][0], found["patch"]["adhesion"]
            assert abs(stick - share) < 0.03 and abs(stick + slip - 1) < 0.02, (state, stick, slip, share)
            inside = [point for point in found["field"] if point["state"] != 0 and math.hypot(point["traction_x"], point["traction_y"]) > 0]
            arrows = drawn["arrows"][0]
            assert len(inside) >= 0.75 * arrows["count"] + drawn["faulty"] >= 0.75 * 0.9 * len(inside), (state, drawn, len(inside))
            assert len(inside) >= (60 if state == "" else 0 if state == "vx=0&phi=0" else 15), (state, len(inside))
            self.sums_up(state, arrows, found["patch"], contact["friction"] * contact["normal_force"], 1)

    def sums_up(self, state, arrows, force, bound, side):
        """The arrows, up the page forward, add up to the direction of the force on the rail."""
        size, length = math.hypot(force["fx"], force["fy"]), math.hypot(arrows["x"], arrows["y"])
        if size < 0.3 * bound:
            return
        cosine = (-arrows["y"] * force["fx"] + side * arrows["x"] * force["fy"]) / (size * length)
        assert cosine > 0.97, (state, cosine, arrows, force)

    def wheels_have_the_bits_of_c(self):
        for state in WHEELS:
            found = self.show(f"wheel&{state}")
            wrench, contacts, height = found["wrench"], found["contacts"], found["position"]["vertical"]
            assert contacts, f"{state}: no contact"
            displayed = self.page.eval_on_selector_all("#view-wheel [data-at=wrench] data", "(all) => all.map((one) => one.value)")
            assert list(map(bits, displayed)) == list(map(bits, [*wrench["force"], *wrench["moment"], height * 1e3, wrench["dissipation"]])), state
            shown = [[height], wrench["force"], wrench["moment"], *([contact["normal_force"], contact["angle"]] for contact in contacts)]
            shown = [[bits(n) for n in row] for row in shown]
            lines = run_c(wheel_with_pictures(self.copied("#copy-c"), found), self.folder)
            tables = [[line for line in lines if line.split()[0] not in ("strip", "point")]]
            python = run_python(self.copied("#copy-python"))
            tables += [] if python is None else [python]
            for table in tables:
                assert [[bits(n) for n in numbers(line)] for line in table] == shown, state
            pictures = [row for one in contacts for row in rows(one["forces"], "strip", STRIP) + rows(one["field"], "point", POINT)]
            assert printed(lines, ["strip", "point"]) == pictures and len(pictures) > 40 * len(contacts), (state, len(pictures))

    def wheels_are_drawn(self):
        for state in WHEELS:
            found = self.show(f"wheel&{state}")
            drawn, contacts = self.drawn("wheel"), found["contacts"]
            assert len(drawn["arrows"]) == len(drawn["stick"]) == len(contacts), (state, drawn)
            assert len(drawn["profiles"]) == 2 and min(drawn["profiles"]) > 80 and drawn["shades"] >= 6, (state, drawn)
            for contact, arrows, stick in zip(contacts, drawn["arrows"], drawn["stick"]):
                inside = [point for point in contact["field"] if point["state"] != 0]
                assert len(inside) >= arrows["count"] >= 0.9 * len(inside) >= 15, (state, arrows, len(inside))
                assert abs(stick - contact["result"]["adhesion"]) < 0.04, (state, stick, contact["result"])
                self.sums_up(state, arrows, contact["result"], contact["summary"]["friction_bound"], -1 if "left" in state else 1)
        # Strips of the default state stick
        self.show("wheel")
        assert 0.1 < self.drawn("wheel")["stick"][0] < 0.4

    def the_rail_supports_the_load(self):
        """The load is that of the input, creep forces included."""
        for state in [*WHEELS, "shift=6.4&drift=200", "shift=6.4&drift=-200&f=0.5", "turn=2&yaw=-20&Q=150"]:
            found = self.show(f"wheel&{state}")
            load = found["inputs"]["load"]
            assert abs(found["wrench"]["force"][2] + load) < 1e-9 * load, (state, found["wrench"]["force"])
            assert f"{load:,.0f}".replace(",", "\u202f") + " N up" in self.page.inner_text("#view-wheel .sentence"), state

    def a_left_wheel_is_the_mirror_image(self):
        wrench = lambda state: self.show(f"wheel&{state}")["wrench"]  # noqa: E731
        right, left = wrench("shift=4&yaw=3&drift=20&Q=90"), wrench("shift=-4&yaw=-3&drift=-20&Q=90&side=left")
        assert left["force"] == [right["force"][0], -right["force"][1], right["force"][2]], (right, left)
        assert right["force"][1] != 0, right
        # The creep forces of the contacts are those of the wrench, where strips have their own slip too
        for state in ("shift=2&turn=0.2", "shift=6.2&turn=0.3&m=TOTAL", "shift=-6&yaw=-2&turn=0.1&side=left"):
            along = wrench(state)["force"][0]
            contacts = self.page.evaluate("page.found.contacts.map((contact) => contact.share * contact.result.fx)")
            assert abs(sum(contacts) + along) < 1e-9 * abs(along), (state, contacts, along)

    # Calls

    def every_call_has_the_arguments_of_the_header(self):
        """Without any one of its arguments each call in the scripts is an error: of the build and, for each function, on the page."""
        scripts, prototypes = calls.scripts(), header.prototypes(header.text())
        names, places = calls.checked(scripts, prototypes), 0
        for file, script in scripts.items():
            for name, _, given in calls.calls(script):
                for start, end in given:
                    places += 1
                    mutant = script[: script.rindex(",", 0, start)] + script[end:]
                    try:
                        calls.checked({**scripts, file: mutant}, prototypes)
                    except ValueError as error:
                        assert name in str(error), error
                    else:
                        raise AssertionError(f"{file}: {name}() without {script[start:end]}")
        assert places > 80, places
        for view, state in (("contact", "law=true&vx=1.2"), ("wheel", "")):
            self.show(f"{view}&{state}")
            wrong = self.page.evaluate("""(view) => {
                const call = page.library.call, { functions } = page.library, silent = [], used = new Set();
                window.reportError = () => undefined;
                page.library.call = function (name, ...values) { used.add(name); return call.call(this, name, ...values); };
                const profiles = () => { if (wheelView.memory) wheelView.memory.of = {}; };
                profiles();
                update();
                for (const name of used) functions[`kstrip_${name}`].parameters.forEach((parameter, i) => {
                    const kinds = { missing: [], kind: [parameter.pointer ? 0 : null], number: [parameter.pointer ? new Pointer("char", 0) : "1"] };
                    for (const [key, instead] of Object.entries(kinds)) {
                        page.library.call = function (one, ...values) {
                            if (one === name) values.splice(i, 1, ...instead);
                            return call.call(this, one, ...values);
                        };
                        profiles();
                        update();
                        const shown = document.querySelector(`#view-${view} .problem`);
                        if (!shown.textContent.includes(`kstrip_${name}()`) || !shown.checkVisibility()) silent.push([name, parameter.name, key]);
                    }
                });
                page.library.call = call;
                profiles();
                update();
                return { silent, used: [...used], after: page.found.error ?? null };
            }""", view)
            assert wrong["silent"] == [] and wrong["after"] is None and len(wrong["used"]) >= 5, wrong
        assert set(names) == self.called | {"kstrip_status_string"}, (names, self.called)

    def errors_are_sentences_and_nothing_stale_stays(self):
        for view, key, typed, word in WRONG:
            self.show(view)
            self.page.click("#show summary")
            before = self.page.inner_text(f"#view-{view} .results")
            right = self.page.input_value(f"#{view}-{key}-number")
            self.page.fill(f"#{view}-{key}-number", typed)
            self.settle()
            problem = self.page.inner_text(f"#view-{view} .problem")
            assert re.search(word, problem) and re.fullmatch(r"[A-Z“].{12,}\.", problem, re.S), (key, typed, problem)
            visible = self.page.evaluate("""(view) => [...document.querySelectorAll(`#view-${view} :is(.computed *, .pictures figure *, .sentence, .warnings)`)]
                .filter((one) => one.checkVisibility({ visibilityProperty: true })).map((one) => one.outerHTML.slice(0, 80))""", view)
            assert visible == [] and self.page.inner_text("#program") == "", (key, typed, visible)
            assert self.page.is_disabled("#copy-c") and self.page.is_disabled("#copy-python")
            self.page.fill(f"#{view}-{key}-number", right)
            self.settle()
            assert self.page.inner_text(f"#view-{view} .results") == before and not self.page.is_visible(".problem"), key

    def fastsim_is_that_of_the_reports(self):
        """tests/web/fastsim.csv: computed by tests/peers.rs with the method that the reports use."""
        with open(ROOT / "tests" / "web" / "fastsim.csv", newline="") as file:
            rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        assert len(rows) >= 8
        for row in rows:
            found = self.page.evaluate("(r) => fastsim(r, [r.longitudinal, r.lateral, r.spin], [r.c11, r.c22, r.c23])", row)
            scale = row["friction"] * row["normal_force"]
            for key in ("fx", "fy"):
                # the sums run in another order
                assert abs(found[key] - row[key]) < 1e-12 * scale, (row, found)

    # Inputs

    def a_slider_moves_the_picture(self):
        self.open("contact")
        before = self.page.inner_html("[data-at=patch]"), self.page.inner_html("[data-at=curves]"), self.page.inner_text("#view-contact .sentence")
        self.page.focus("#contact-vx")
        for _ in range(30):
            self.page.keyboard.press("ArrowRight")
        self.settle()
        after = self.page.inner_html("[data-at=patch]"), self.page.inner_html("[data-at=curves]"), self.page.inner_text("#view-contact .sentence")
        assert all(one != other for one, other in zip(before, after))
        value = float(self.page.input_value("#contact-vx-number"))
        assert 0.1 < value < 3, value
        assert re.fullmatch(r"[\d.]+ %", self.page.get_attribute("#contact-vx", "aria-valuetext"))
        # A number that is typed moves the slider; zero load is a lost contact
        at = self.page.input_value("#contact-N")
        self.page.fill("#contact-N-number", "160")
        self.settle()
        assert self.page.input_value("#contact-N") != at
        self.page.fill("#contact-N-number", "0")
        self.settle()
        assert "lost" in self.page.inner_text("#view-contact .sentence")
        self.page.fill("#contact-N-number", "80")
        # A warning is shown in words
        self.page.fill("#contact-mu-number", "30")
        self.settle()
        warnings = self.page.inner_text("#view-contact .warnings")
        assert "Hertz" in warnings and "friction" in warnings, warnings

    def the_wheel_moves_too(self):
        self.open("wheel")
        before = self.page.inner_html("[data-at=section]"), self.page.inner_html("[data-at=patches]")
        self.page.focus("#wheel-shift")
        self.page.keyboard.press("PageUp")
        self.settle()
        after = self.page.inner_html("[data-at=section]"), self.page.inner_html("[data-at=patches]")
        assert all(one != other for one, other in zip(before, after))

    def keyboard_and_names(self):
        self.open("contact")
        self.page.focus("#tab-contact")
        self.page.keyboard.press("ArrowRight")
        assert self.page.is_visible("#view-wheel") and not self.page.is_visible("#view-contact")
        assert self.page.evaluate("document.activeElement.id") == "tab-wheel"
        # Everything that can be focused has a name, and every picture a description
        for view in ("contact", "wheel"):
            self.open(view)
            nameless = self.page.evaluate("""() => [...document.querySelectorAll("input, select, button")].filter((one) => one.checkVisibility()
                && !one.textContent.trim() && !one.labels?.length && !one.getAttribute("aria-label")).map((one) => one.outerHTML)""")
            assert nameless == [], nameless
            pictures = self.page.evaluate("[...document.querySelectorAll('svg')].filter((s) => s.closest('section').checkVisibility()).map((s) => s.getAttribute('aria-label'))")
            assert len(pictures) == 2 and all(len(text) > 40 for text in pictures), pictures
            # Tab reaches every visible input, and the copies
            wanted = self.page.evaluate("[...document.querySelectorAll('input, select, button, summary')].filter((one) => one.checkVisibility() && one.tabIndex >= 0 && !one.disabled).length")
            self.page.evaluate("document.activeElement.blur()")
            reached = set()
            for _ in range(wanted + 40):
                self.page.keyboard.press("Tab")
                reached.add(self.page.evaluate("(window.order ??= [...document.querySelectorAll('*')]).indexOf(document.activeElement)"))
            assert len(reached) >= wanted, (view, len(reached), wanted)
        self.until("document.getElementById('spoken').textContent.length > 40")

    def the_link_keeps_the_state(self):
        self.open("wheel&shift=3.3&yaw=-2&m=TOTAL")
        link = self.copied("#copy-link")
        assert link.endswith("#wheel&shift=3.3&yaw=-2&m=TOTAL"), link
        self.open("contact")
        self.page.fill("#contact-uy-number", "900")
        self.page.fill("#contact-ly-number", "")
        self.settle()
        link = self.copied("#copy-link")
        force = self.page.evaluate("page.found.models[0].fx")
        self.open(link.split("#")[1])
        assert self.page.evaluate("page.found.models[0].fx") == force
        assert self.page.input_value("#contact-ly-number") == "" and self.page.input_value("#contact-uy-number") == "900"

    # Files

    def drop(self, row, name, text):
        transfer = self.page.evaluate_handle("([name, text]) => { const t = new DataTransfer(); t.items.add(new File([text], name)); return t; }", [name, text])
        self.page.dispatch_event(row, "drop", {"dataTransfer": transfer})
        self.until("(name) => [...document.querySelectorAll('.row.file .notes')].some((n) => n.textContent.includes(name)) || Object.values(page.shown.wheel).includes(name)", name)
        self.settle()

    def files_are_read(self):
        def profile(name):
            with open(ROOT / "tests" / "data" / "wheel_rail" / f"{name}.csv", newline="") as file:
                return [(float(y), float(z)) for y, z in list(csv.reader(file))[1:]]

        state = lambda: self.page.evaluate("[page.found.wrench.force, page.found.position.vertical]")  # noqa: E731
        self.open("wheel&shift=1")
        built_in = state()
        worn = profile("avgwhl")
        self.drop(".row.file[data-key=wheel]", "worn.csv", "y,z\n" + "\n".join(f"{y},{z}" for y, z in worn))
        assert "points in mm" in self.page.inner_text("#wheel-wheel-notes"), self.page.inner_text("#wheel-wheel-notes")
        assert self.page.evaluate("page.shown.wheel.wheel") == "worn.csv" and state() != built_in
        # The built-in wheel from a file: in m, z up, flange at large y, in the format of Simpack, decimal commas
        lines = "\n".join(f"{-y:.5f}\t{-z:.5f}" for y, z in profile("s1002"))
        self.drop(".row.file[data-key=wheel]", "turned.prw", f"header.begin\n version = 1\nheader.end\nspline.begin\n point.begin\n{lines}\n point.end\nspline.end\n")
        notes = self.page.inner_text("#wheel-wheel-notes")
        assert "turned" in notes and "mirrored" in notes and state() == built_in, notes
        self.drop(".row.file[data-key=wheel]", "metres.txt", "\n".join(f"{y * 1e-3:.8f} {z * 1e-3:.8f}".replace(".", ",") for y, z in profile("s1002")))
        assert "points in m" in self.page.inner_text("#wheel-wheel-notes")
        assert all(abs(one - other) < 1e-6 * 8e4 for one, other in zip(state()[0], built_in[0]))
        # Tables: quoted, with a running number and names, with missing points, exponents of Fortran
        table = profile("s1002")
        tables = {
            "quoted.csv": '"y","z"\n' + "\n".join(f'"{y}","{z}"' for y, z in table),
            "named.csv": "n,z,y\n" + "\n".join(f"{n},{z},{y}" for n, (y, z) in enumerate(table)),
            "missing.txt": "\n".join(f"{y} {z}" for y, z in [*table[:50], (-9999, -9999), *table[50:]]),
            "fortran.txt": "\n".join(f"{y!r}D+00 {z!r}d0" for y, z in table),
        }
        for name, text in tables.items():
            self.drop(".row.file[data-key=wheel]", name, text)
            assert state() == built_in, (name, self.page.inner_text("#wheel-wheel-notes"))
        self.page.click(".row.file[data-key=wheel] .builtin")
        self.settle()
        assert state() == built_in
        # Bad files: a message that names the fault, and the profile stays
        bad = {
            "empty.txt": ("", "no pairs of numbers"), "letter.csv": ("1,2\n3,4\n5,x\n7,8\n9,10", "Line 3"),
            "short.csv": ("1,2\n3,4\n5,6", "at least 4 points"), "three.csv": ("1,2,3\n2,3,4\n3,4,5\n4,5,6", "has 3 numbers"), "same.csv": ("1,2\n1,2\n1,2\n1,2", "was not read. "),
            "picture.png": ("\x89PNG\r\n\x1a\n\0\0", "no pairs of numbers"),
        }
        for name, (text, message) in bad.items():
            self.drop(".row.file[data-key=rail]", name, text)
            notes = self.page.inner_text("#wheel-rail-notes")
            assert message in notes and name in notes, f"{name}: {notes}"
            assert self.page.evaluate("page.shown.wheel.rail") == "60E1" and state() == built_in
        # A link to a file says so
        self.open("wheel&rail=mine.csv")
        assert "mine.csv" in self.page.inner_text("#wheel-rail-notes")

    # Widths and colours

    def narrow_and_dark(self):
        for view in ("contact", "wheel"):
            colours = set()
            for scheme in ("light", "dark"):
                self.page.emulate_media(color_scheme=scheme)
                for width in (360, 768, 1280):
                    self.page.set_viewport_size({"width": width, "height": 800})
                    self.open(view)
                    assert self.page.evaluate("document.documentElement.scrollWidth") <= width, (view, width)
                    box = self.page.locator(f"#view-{view} figure.first").bounding_box()
                    assert box["y"] < 800 and box["width"] > 300, (view, width, box)
                colours.add(self.page.evaluate("getComputedStyle(document.documentElement).backgroundColor"))
            assert len(colours) == 2, colours
        self.page.emulate_media(color_scheme="light")
        self.page.set_viewport_size({"width": 1280, "height": 900})

    def stronger_blue_is_higher_pressure(self):
        """In light and in dark: the colours of the scale differ more and more from the ground, and the caption is true of both."""
        for scheme in ("light", "dark"):
            self.page.emulate_media(color_scheme=scheme)
            self.show("wheel")
            caption = self.page.inner_text("#view-wheel figcaption")
            assert "stronger the blue" in caption and not re.search("dark|light|bright", caption), caption
            boxes = self.page.eval_on_selector_all("#view-wheel .key rect.pressure", """(all) => all.map((one) => {
                const { x, y, width, height } = one.getBoundingClientRect(); return [x + width / 2, y + height / 2]; })""")
            ground = [boxes[0][0] - 60, boxes[0][1]]
            place, *scale = pixels.colours_at(self.page, self.page.screenshot(), [ground, *boxes])
            away = [sum(abs(one - other) for one, other in zip(colour, place)) for colour in scale]
            blue = [colour[2] - colour[0] for colour in scale]
            assert len(away) == 8 and away[0] > 10 and away == sorted(set(away)) and blue == sorted(set(blue)), (scheme, place, scale)
        self.page.emulate_media(color_scheme="light")

    def nothing_leaves_the_page(self):
        foreign = [url for url in self.requests if url != "about:blank" and url.split("#")[0] != PAGE.as_uri() and not url.startswith(("data:", "blob:"))]
        assert self.requests and foreign == [], foreign
        assert self.errors == [], self.errors

    # The picture of the README

    def the_picture_shows_the_demo(self):
        """docs/figures/page.png and a new picture both have areas, arrows, curves and numbers, about as much of each."""
        fresh = TARGET / "web" / "page.png"
        page = draw(self.browser, fresh)
        colours = lambda *names: {name: page.evaluate("(name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`)", name) for name in names}  # noqa: E731
        box = lambda selector: page.locator(selector).first.bounding_box()  # noqa: E731
        rim = box("#view-contact .rim")
        inner = {"x": rim["x"] + 0.2 * rim["width"], "y": rim["y"] + 0.2 * rim["height"], "width": 0.6 * rim["width"], "height": 0.6 * rim["height"]}
        regions = {
            "patch": {"box": inner, "colours": colours("stick", "slip", "arrow")},
            "curves": {"box": box("[data-at=curves] svg"), "colours": colours("total", "strip", "s1967", "continuous", "linear", "fastsim")},
            "inputs": {"box": box("#controls-contact"), "colours": colours("accent", "ink")},
            "table": {"box": box("[data-at=models]"), "colours": colours("ink", "total", "strip", "s1967", "continuous", "linear", "fastsim")},
        }
        regions["inputs"]["box"]["height"] = 900 - regions["inputs"]["box"]["y"]
        (size, new), (committed_size, committed) = (pixels.counted(self.page, file.read_bytes(), regions) for file in (fresh, PICTURE))
        assert size == committed_size == [1240, 900], (size, committed_size)
        area = inner["width"] * inner["height"]
        assert new["patch: stick"] > 0.15 * area and new["patch: slip"] > 0.15 * area and new["patch: arrow"] > 0.02 * area, (new, area)
        for key, count in new.items():
            assert count >= 20, (key, count)
            assert 0.5 * count < committed[key] < 2 * count, f"{PICTURE}: {key}: {committed[key]} pixels, {count} in {fresh}; scripts/pictures.sh draws it"

    # Figures

    def print_sizes_and_times(self):
        page, wasm = PAGE.read_bytes(), PAGE.with_name("kstrip.wasm").read_bytes()
        for name, content in (("page", page), ("library in it, as WebAssembly", wasm)):
            print(f"   {name}: {len(content) / 1e3:.0f} kB, {len(gzip.compress(content, 9)) / 1e3:.0f} kB with gzip")
        assert len(page) <= 1.2e6 and len(gzip.compress(page, 9)) <= 350e3, "the page is too large"
        for view, key, values in (("contact", "vx", "0.01 * i"), ("contact&law=true", "vx", "0.01 * i"), ("wheel", "shift", "-7 + 0.14 * i")):
            self.open(view)
            name = view.split("&")[0]
            median, most = self.page.evaluate(f"""() => {{ const times = []; for (let i = 0; i < 100; i++) {{ page.shown.{name}.{key} = {values}; update(); times.push(page.milliseconds); }}
                times.sort((a, b) => a - b); return [times[50], times[94]]; }}""")
            print(f"   after a move of a slider, {view}: median {median:.1f} ms, 95th percentile {most:.1f} ms")


def draw(browser, file):
    """The picture of the README. Returns its page."""
    page = browser.new_context(viewport={"width": 1240, "height": 900}, color_scheme="light").new_page()
    page.goto(f"{PAGE.as_uri()}#contact&vx=0.12&phi=0.6")
    page.evaluate("page.ready")
    page.screenshot(path=file)
    return page


def main():
    with sync_playwright() as playwright, tempfile.TemporaryDirectory() as folder:
        browser = playwright.chromium.launch(executable_path=BROWSER, args=["--no-sandbox"])
        if sys.argv[1:2] == ["--picture"]:
            draw(browser, sys.argv[2])
            return
        tests = Tests(browser, pathlib.Path(folder))
        for name in ("contacts_have_the_bits_of_c", "contacts_are_drawn", "wheels_have_the_bits_of_c", "wheels_are_drawn", "the_rail_supports_the_load",
                     "a_left_wheel_is_the_mirror_image", "every_call_has_the_arguments_of_the_header", "errors_are_sentences_and_nothing_stale_stays",
                     "fastsim_is_that_of_the_reports", "a_slider_moves_the_picture", "the_wheel_moves_too", "keyboard_and_names", "the_link_keeps_the_state",
                     "files_are_read", "narrow_and_dark", "stronger_blue_is_higher_pressure", "the_picture_shows_the_demo", "nothing_leaves_the_page",
                     "print_sizes_and_times"):
            if len(sys.argv) > 1 and name not in sys.argv[1:]:
                continue
            getattr(tests, name)()
            print(name, "ok", flush=True)
        browser.close()
        if tests.skipped:
            print("SKIPPED: the Python programs of the browser demo, because there is no numpy")


if __name__ == "__main__":
    main()
