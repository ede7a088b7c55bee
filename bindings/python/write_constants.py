#!/usr/bin/env python3
"""Writes kstrip/_total.py, the constants of the model TOTAL, from the sources of the library.

    python bindings/python/write_constants.py            (a test compares the file with the sources)
"""

import ast
import pathlib
import pprint
import re

HERE = pathlib.Path(__file__).resolve().parent
SOURCES = HERE.parents[1] / "src"
#: Constants of single precision, which the library keeps as such, and plain numbers, by their files
FILES = {"linear/constants.rs": None, "total/constants.rs": None, "total/mod.rs": ("RATIO_LIMIT", "LARGEST_ROOT", "GROWTH", "SATURATION_SERIES")}
HEAD = '''"""Constants of the model TOTAL. Written by write_constants.py from the sources of the library: do not edit."""

from typing import Any

import numpy as np


def _single(numbers: Any) -> Any:
    """Constants of single precision, as the library has them, in double precision."""
    return np.asarray(numbers, np.float32).astype(float).tolist()

'''


def constants(path, names):
    """Name, whether it has single precision, and value of each constant of a source file."""
    text = re.sub(r"//[^\n]*", "", (SOURCES / path).read_text(encoding="utf-8"))
    for name, kind, value in re.findall(r"\bconst (\w+): ([^=]*?) = ([^;]*(?:; \d+\])?[^;]*);", text):
        if names is None or name in names:
            yield name, "f32" in kind, ast.literal_eval("".join(value.split()))


def module():
    """The text of _total.py."""
    parts = []
    for path, names in FILES.items():
        for name, single, value in constants(path, names):
            shown = pprint.pformat(value, width=140, compact=True)
            parts.append(f"{name}: Any = _single({shown})\n" if single else f"{name}: Any = {shown}\n")
    return HEAD + "".join(parts)


if __name__ == "__main__":
    (HERE / "kstrip" / "_total.py").write_text(module(), encoding="utf-8")
