#!/usr/bin/env python3
"""The page that computes, in headless Chromium: its numbers are those of the C library, bit for bit; inputs, keyboard, files, link.

    scripts/web.sh && scripts/library.sh && python3 tests/web/page.py
    scripts/web.sh && python3 tests/web/page.py --picture docs/figures/page.png

Needs Chromium and the package playwright. Exit status 77: something is missing (a line with SKIPPED says what).
Sizes and times of a slider's answer are printed, not tested: they depend on the machine.
"""

import csv
import gzip
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TARGET = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")).resolve()
PAGE = TARGET / "web" / "index.html"
LIBRARY = TARGET / "lib" / "libkstrip.a"
MODELS = ["TOTAL", "STRIP", "STRIP_1967", "STRIP_1967_CONTINUOUS", "LINEAR"]


def skip(what):
    print(f"SKIPPED: tests of the page that computes, because there is no {what}")
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

#: Ten states of the first view, and four of the second
CONTACTS = [
    "", "vx=-0.35&vy=0.2&phi=3", "vx=0&phi=0", "N=0", "N=3.7&ly=13&ux=420&uy=-200&phi=-8", "shape=axes&a=1.3&b=9&vy=0.07",
    "law=true&vx=1.2", "law=true&A=0.3&B=1.1&V=55&k=0.4&vx=0.9&vy=-0.4", "m1=steel&m2=aluminium&G2=26&nu2=0.34&mu=0.6",
    "model=STRIP_1967&sweep=spin&phi=11&mu=0.05&lx=400",
]
WHEELS = ["", "shift=5.9&yaw=-4&turn=0.4&drift=-30", "side=left&shift=-3.2&Q=55.5&v=44", "shift=-7&cant=12&smooth=2&R=400&f=0.45&m=TOTAL"]


def bits(value):
    return struct.pack("<d", float(value)).hex()


def numbers(line):
    return [float(word) for word in re.findall(r"(?<![\w.])-?(?:\d[\d.]*(?:e[-+]?\d+)?|inf|nan)(?![\w.])", line)]


def run_c(program, folder):
    source, binary = folder / "program.c", folder / "program"
    source.write_text(program)
    subprocess.run(["cc", "-std=c99", "-Wall", "-Wextra", "-Werror", str(source), f"-I{ROOT / 'include'}", str(LIBRARY), "-lm", "-o", str(binary)], check=True)
    return subprocess.run([str(binary)], check=True, capture_output=True, text=True).stdout.splitlines()


def run_python(program):
    """What the Python program prints; None without numpy."""
    python = os.environ.get("PYTHON", sys.executable)
    if subprocess.run([python, "-c", "import numpy"], capture_output=True).returncode:
        return None
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "bindings" / "python"), "KSTRIP_LIBRARY": str(TARGET / "lib" / "libkstrip.so"), "PYTHONWARNINGS": "ignore"}
    return subprocess.run([python, "-c", program], check=True, capture_output=True, text=True, env=environment).stdout.splitlines()


class Tests:
    def __init__(self, browser, folder):
        self.folder, self.requests, self.errors = folder, [], []
        context = browser.new_context(viewport={"width": 1280, "height": 900})
        context.grant_permissions(["clipboard-read", "clipboard-write"])
        self.page = context.new_page()
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.on("pageerror", lambda error: self.errors.append(str(error)))
        self.page.on("console", lambda message: self.errors.append(message.text) if message.type == "error" else None)
        self.skipped = False

    def open(self, state):
        self.page.goto("about:blank")
        self.page.goto(f"{PAGE.as_uri()}#{state}")
        self.page.evaluate("page.ready")

    def settle(self):
        """Waits until what was changed is computed and drawn."""
        self.page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def until(self, condition, argument=None):
        """(The page forbids what Playwright's own wait does: evaluating text.)"""
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

    # Numbers

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
            self.open(f"contact&{state}")
            shown = self.shown_contact()
            for lines in (run_c(self.copied("#copy-c"), self.folder), run_python(self.copied("#copy-python"))):
                if lines is None:
                    self.skipped = True
                    continue
                printed = {line.split()[0]: [bits(n) for n in numbers(line.split(" ", 1)[1])] for line in lines}
                assert printed == shown, f"{state}: {printed}, on the page {shown}"
        # The call in README.md: units, and which number is which
        self.open("contact&shape=axes&phi=0.1")
        total = self.page.evaluate("page.found.models[0]")
        assert [round(total["fx"]), round(total["fy"]), round(total["mz"], 1)] == [8731, 2072, 4.4], total

    def wheels_have_the_bits_of_c(self):
        for state in WHEELS:
            self.open(f"wheel&{state}")
            found = self.page.evaluate("page.found")
            assert not found.get("error"), (state, found)
            shown = [[found["position"]["vertical"]], found["wrench"]["force"], found["wrench"]["moment"]]
            shown += [[contact["normal_force"], contact["angle"]] for contact in found["contacts"]]
            assert len(shown) > 3, f"{state}: no contact"
            for lines in (run_c(self.copied("#copy-c"), self.folder), run_python(self.copied("#copy-python"))):
                if lines is not None:
                    assert [[bits(n) for n in numbers(line)] for line in lines] == [[bits(n) for n in row] for row in shown], state

        # A left wheel is the mirror image, and the rail carries the load
        wrench = lambda state: (self.open(f"wheel&{state}"), self.page.evaluate("page.found.wrench"))[1]  # noqa: E731
        right, left = wrench("shift=4&yaw=3&drift=20&Q=90"), wrench("shift=-4&yaw=-3&drift=-20&Q=90&side=left")
        assert left["force"] == [right["force"][0], -right["force"][1], right["force"][2]], (right, left)
        # The creep forces of the contacts are those of the wrench, where strips have their own slip too
        for state in ("shift=2&turn=0.2", "shift=6.2&turn=0.3&m=TOTAL", "shift=-6&yaw=-2&turn=0.1&side=left"):
            along = wrench(state)["force"][0]
            contacts = self.page.evaluate("page.found.contacts.map((contact) => contact.share * contact.result.fx)")
            assert abs(sum(contacts) + along) < 1e-9 * abs(along), (state, contacts, along)
        assert abs(right["force"][2] + 90e3) < 0.1 * 90e3 and right["force"][1] != 0, right

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
        # A number that is typed moves the slider; zero load is a lost contact, and a bad number has its message
        at = self.page.input_value("#contact-N")
        self.page.fill("#contact-N-number", "160")
        self.settle()
        assert self.page.input_value("#contact-N") != at
        self.page.fill("#contact-N-number", "0")
        self.settle()
        assert "lost" in self.page.inner_text("#view-contact .sentence")
        self.page.fill("#contact-N-number", "80")
        self.page.fill("#contact-mu-number", "-1")
        self.settle()
        problem = self.page.inner_text("#view-contact .problem")
        assert "friction" in problem and self.page.is_visible("#view-contact .problem"), problem
        assert self.page.is_disabled("#copy-c")
        # A warning is said in words
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
        self.page.click(".row.file[data-key=wheel] .builtin")
        self.settle()
        assert state() == built_in
        # Bad files: a message that names the fault, and the profile stays
        bad = {
            "empty.txt": ("", "no pairs of numbers"), "letter.csv": ("1,2\n3,4\n5,x\n7,8\n9,10", "Line 3"),
            "short.csv": ("1,2\n3,4\n5,6", "at least 4 points"), "same.csv": ("1,2\n1,2\n1,2\n1,2", "was not read. "),
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

    def nothing_leaves_the_page(self):
        foreign = [url for url in self.requests if url != "about:blank" and url.split("#")[0] != PAGE.as_uri() and not url.startswith(("data:", "blob:"))]
        assert self.requests and foreign == [], foreign
        assert self.errors == [], self.errors

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
            print(f"   answer to a slider, {view}: median {median:.1f} ms, 95th percentile {most:.1f} ms")


def draw(browser, file):
    """The picture of the README."""
    page = browser.new_context(viewport={"width": 1240, "height": 830}, color_scheme="light").new_page()
    page.goto(f"{PAGE.as_uri()}#contact&vx=0.12&phi=0.6")
    page.evaluate("page.ready")
    page.screenshot(path=file)


def main():
    with sync_playwright() as playwright, tempfile.TemporaryDirectory() as folder:
        browser = playwright.chromium.launch(executable_path=BROWSER, args=["--no-sandbox"])
        if sys.argv[1:2] == ["--picture"]:
            draw(browser, sys.argv[2])
            return
        tests = Tests(browser, pathlib.Path(folder))
        for name in ("contacts_have_the_bits_of_c", "wheels_have_the_bits_of_c", "fastsim_is_that_of_the_reports", "a_slider_moves_the_picture",
                     "the_wheel_moves_too", "keyboard_and_names", "the_link_keeps_the_state", "files_are_read", "narrow_and_dark",
                     "nothing_leaves_the_page", "print_sizes_and_times"):
            getattr(tests, name)()
            print(name, "ok", flush=True)
        browser.close()
        if tests.skipped:
            print("SKIPPED: the Python programs of the page, because there is no numpy")


if __name__ == "__main__":
    main()
