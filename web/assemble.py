#!/usr/bin/env python3
"""Puts the page into one file: style, scripts, profiles, and the library in WebAssembly (gzip, base64).

    assemble.py KSTRIP.wasm OUT.html
"""

import base64
import csv
import gzip
import json
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
sys.path.insert(0, str(ROOT / "bindings" / "python" / "kstrip"))
import _header  # noqa: E402  (kstrip.h is read as the Python package reads it)

SCRIPTS = ["library.js", "fastsim.js", "draw.js", "profiles.js", "programs.js", "contact.js", "wheel.js", "page.js"]
#: What a member takes in the 32 bits of WebAssembly: type, bytes
SIZES = {"double": 8, "int32_t": 4, "uint32_t": 4, "kstrip_status": 4, "ptrdiff_t": 4}
PROFILES = {"60E1": "uic60", "S1002": "s1002"}


def layouts(header):
    """Size and members of every structure of the header, where addresses have 32 bits."""
    known, constants = {}, _header.constants(header)
    for match in _header.STRUCTURE.finditer(header):
        body = re.sub(r"/\*.*?\*/", "", match["body"], flags=re.S)
        members, offset, alignment = {}, 0, 4
        for kind, pointer, name, counts in _header.MEMBER.findall(body):
            size = 4 if pointer else SIZES.get(kind) or known[kind]["size"]
            align = size if pointer or kind in SIZES else known[kind]["align"]
            offset = -(-offset // align) * align
            plain = "uint32_t" if pointer else "int32_t" if kind in ("kstrip_status", "ptrdiff_t") else kind
            members[name] = {"type": plain, "offset": offset}
            count = 1
            for index in re.findall(r"\w+", counts):
                count *= int(constants.get(index, index))
            if counts:
                members[name]["count"] = count
            offset += size * count
            alignment = max(alignment, align)
        known[match["name"]] = {"size": -(-offset // alignment) * alignment, "align": alignment, "members": members}
    return {"structures": known, "constants": constants}


def profile(name):
    """Points [mm] of a profile of tests/data/wheel_rail."""
    with open(ROOT / "tests" / "data" / "wheel_rail" / f"{name}.csv", newline="") as file:
        rows = list(csv.reader(file))[1:]
    return {"y": [float(row[0]) for row in rows], "z": [float(row[1]) for row in rows]}


def assemble(wasm):
    def text(name):
        return (HERE / name).read_text(encoding="utf-8")

    header = (ROOT / "include" / "kstrip.h").read_text(encoding="utf-8")
    packed = gzip.compress(wasm, 9, mtime=0)
    data = {
        "LAYOUT": json.dumps(layouts(header), separators=(",", ":")),
        "PROFILES": json.dumps({name: profile(file) for name, file in PROFILES.items()}, separators=(",", ":")),
        "WASM": json.dumps(base64.b64encode(packed).decode()),
    }
    scripts = "\n".join(text(name) for name in SCRIPTS)
    constants = "\n".join(f"const {name} = {value};" for name, value in data.items())
    page = text("index.html")
    for mark, content in {"/* style */": text("style.css"), "/* scripts */": f'"use strict";\n{constants}\n{scripts}'}.items():
        assert page.count(mark) == 1, mark
        page = page.replace(mark, content)
    return page


if __name__ == "__main__":
    page = assemble(pathlib.Path(sys.argv[1]).read_bytes())
    pathlib.Path(sys.argv[2]).write_text(page, encoding="utf-8")
    size = len(page.encode())
    print(f"{sys.argv[2]}: {size} bytes, {len(gzip.compress(page.encode(), 9))} with gzip")
