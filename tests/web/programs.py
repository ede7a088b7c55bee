"""Runs the programs of the browser demo; adds to its C programs what its pictures show."""

import os
import pathlib
import re
import struct
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TARGET = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")).resolve()
LIBRARY = TARGET / "lib" / "libkstrip.a"

STRIP = ("y", "width", "half_length", "separatrix", "state")
POINT = ("pressure", "traction_x", "traction_y", "slip_x", "slip_y", "dissipation", "state")


def bits(value):
    return struct.pack("<d", float(value)).hex()


def numbers(line):
    return [float(word) for word in re.findall(r"(?<![\w.])-?(?:\d[\d.]*(?:e[-+]?\d+)?|inf|nan)(?![\w.])", line)]


def run_c(program, folder):
    """The lines that a C program prints."""
    source, binary = folder / "program.c", folder / "program"
    source.write_text(program)
    subprocess.run(["cc", "-std=c99", "-Wall", "-Wextra", "-Werror", str(source), f"-I{ROOT / 'include'}", str(LIBRARY), "-lm", "-o", str(binary)], check=True)
    return subprocess.run([str(binary)], check=True, capture_output=True, text=True).stdout.splitlines()


def run_python(program):
    """The lines that a Python program prints; None without numpy."""
    python = os.environ.get("PYTHON", sys.executable)
    if subprocess.run([python, "-c", "import numpy"], capture_output=True).returncode:
        return None
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "bindings" / "python"), "KSTRIP_LIBRARY": str(TARGET / "lib" / "libkstrip.so"), "PYTHONWARNINGS": "ignore"}
    return subprocess.run([python, "-c", program], check=True, capture_output=True, text=True, env=environment).stdout.splitlines()


def rows(found, kind, members):
    """Lines of a picture, as the C programs print them."""
    return [[kind, *(bits(one[member]) for member in members)] for one in found]


def printed(lines, kinds):
    """The lines of these kinds, with the bits of their numbers."""
    return [[line.split()[0], *map(bits, numbers(line))] for line in lines if line.split()[0] in kinds]


def array(name, values):
    return f"    static const double {name}[] = {{{', '.join(map(repr, values))}}};\n"


def printing(kind, of, members):
    places = " ".join("%d" if member == "state" else "%.17g" for member in members)
    return f'printf("{kind} {places}\\n", {", ".join(f"{of}.{member}" for member in members)});'


def grid(found, call):
    """Declares the points of a picture, and prints them after `call`, which fills them."""
    xs, ys = found["grid"]["xs"], found["grid"]["ys"]
    size = len(xs) * len(ys)
    return (
        array("xs", xs) + array("ys", ys) + f"    static kstrip_point points[{size}];\n    {call.format(f'xs, {len(xs)}, ys, {len(ys)}, points, {size}')}\n"
        f"    for (int i = 0; i < {size}; i++) {printing('point', 'points[i]', POINT)}\n"
    )


def contact_with_pictures(program, found, model, sweep):
    """The C program of the first view, which prints curves, strips and tractions too."""
    law = "&law" if "kstrip_friction law" in program else "NULL"
    places = found["curve"]["places"]
    more = (
        array("places", places) + f"""    for (int m = 0; m < 5; m++) for (int i = 0; i < {len(places)}; i++) {{
        kstrip_creepage moved = creepage;
        kstrip_options of = {{.model = models[m]}};
        kstrip_result at;
        kstrip_outputs to = {{.result = &at}};
        moved.{sweep} = places[i];
        check(kstrip_evaluate(&contact, &moved, {law}, &of, &to));
        printf("curve %.17g\\n", at.{found["curve"]["component"]});
    }}
""")
    if "strips" in found:
        more += f"""    kstrip_strip strips[KSTRIP_STRIPS_CAPACITY];
    uint32_t count;
    kstrip_options fine = {{.model = KSTRIP_MODEL_{model}, .strips = KSTRIP_STRIPS_CAPACITY}}, drawn = {{.model = KSTRIP_MODEL_{model}}};
    kstrip_outputs into = {{.strips = strips, .count = &count, .capacity = KSTRIP_STRIPS_CAPACITY}};
    check(kstrip_evaluate(&contact, &creepage, {law}, &fine, &into));
    for (uint32_t i = 0; i < count; i++) {printing("strip", "strips[i]", STRIP)}
""" + grid(found, f"check(kstrip_field(&contact, &creepage, {law}, &drawn, {{}}));")
    return program.replace("    return 0;\n", more + "    return 0;\n")


def wheel_with_pictures(program, found):
    """The C program of the second view, which prints strips and tractions of each contact too."""
    more = ""
    for i, contact in enumerate(found["contacts"]):
        more += f"""    {{
    kstrip_wheel_contact *contact = &workspace.contacts[{i}];
    kstrip_motion motion;
    check(kstrip_wheel_motion(contact, &velocity, &motion));
    double speed = motion.rolling_speed < 0 ? -motion.rolling_speed : motion.rolling_speed;
    kstrip_creepage creepage = {{motion.slip_x / speed, motion.slip_y / speed, motion.spin_rate / speed}};
    kstrip_strip strips[KSTRIP_PATCH_CAPACITY];
    uint32_t count;
    kstrip_outputs into = {{.strips = strips, .count = &count, .capacity = KSTRIP_PATCH_CAPACITY}};
    check(kstrip_patch_evaluate(&contact->patch, &creepage, NULL, NULL, &into));
    for (uint32_t i = 0; i < count; i++) {printing("strip", "strips[i]", STRIP)}
""" + grid(contact, "check(kstrip_patch_field(&contact->patch, &creepage, NULL, NULL, {}));") + "    }\n"
    return program.replace("    return 0;\n", more + "    return 0;\n")
