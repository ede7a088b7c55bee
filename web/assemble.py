#!/usr/bin/env python3
"""Puts the browser demo into one file: style, scripts, profiles, and the library in WebAssembly (gzip, base64).

    assemble.py KSTRIP.wasm OUT.html

The calls of the library are checked against kstrip.h: one with a wrong number of arguments ends the build.
"""

import base64
import csv
import gzip
import json
import pathlib
import sys

import calls
import header

PROFILES = {"60E1": "uic60", "S1002": "s1002"}


def profile(name):
    """Points [mm] of a profile of tests/data/wheel_rail."""
    with open(header.ROOT / "tests" / "data" / "wheel_rail" / f"{name}.csv", newline="") as file:
        rows = list(csv.reader(file))[1:]
    return {"y": [float(row[0]) for row in rows], "z": [float(row[1]) for row in rows]}


def interface(scripts):
    """The part of kstrip.h that the scripts need"""
    text = header.text()
    prototypes = header.prototypes(text)
    functions = {name: prototypes[name] for name in calls.checked(scripts, prototypes)}
    return {"constants": header.constants(text), "structures": header.structures(text), "functions": functions}


def assemble(wasm):
    def text(name):
        return (calls.HERE / name).read_text(encoding="utf-8")

    scripts = calls.scripts()
    data = {
        "HEADER": json.dumps(interface(scripts), separators=(",", ":")),
        "PROFILES": json.dumps({name: profile(file) for name, file in PROFILES.items()}, separators=(",", ":")),
        "WASM": json.dumps(base64.b64encode(gzip.compress(wasm, 9, mtime=0)).decode()),
    }
    constants = [f"const {name} = {value};" for name, value in data.items()]
    page = text("index.html")
    for mark, content in {"/* style */": text("style.css"), "/* scripts */": "\n".join(['"use strict";', *constants, *scripts.values()])}.items():
        assert page.count(mark) == 1, mark
        page = page.replace(mark, content)
    return page


if __name__ == "__main__":
    page = assemble(pathlib.Path(sys.argv[1]).read_bytes())
    pathlib.Path(sys.argv[2]).write_text(page, encoding="utf-8")
    size = len(page.encode())
    print(f"{sys.argv[2]}: {size} bytes, {len(gzip.compress(page.encode(), 9))} with gzip")
