#!/usr/bin/env python3
"""Writes kstrip/_types.py from include/kstrip.h: a class with units and comments for each structure.

    python bindings/python/write_types.py            (a test compares the file with the header)
"""

import importlib.util
import pathlib
import re

HERE = pathlib.Path(__file__).resolve().parent


def _header():
    """kstrip/_header.py by itself: the package needs the file that is written here."""
    spec = importlib.util.spec_from_file_location("header", HERE / "kstrip" / "_header.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def name_of(structure):
    return "".join(word.capitalize() for word in structure.removeprefix("kstrip_").split("_"))


def unit_of(comment, structure):
    """The first [...] of a comment, else that of the structure's; "" for numbers without a unit."""
    found = re.search(r"\[([^\]]+)\]", comment) or re.search(r"\[([^\]]+)\]", structure)
    return "" if found is None or set(found[1]) <= set("-, ") else found[1]


def text(header):
    """The module."""
    lines = [
        '"""Structures of kstrip.h as numpy records. Written by write_types.py: do not edit."""',
        "",
        "from ._record import Integers, Numbers, Part, Record",
    ]
    for structure, about, members in _header().members(header):
        # What points to memory of the caller is made where it is passed.
        if any(pointer for _, pointer, _, _, _ in members):
            continue
        lines += ["", "", f'class {name_of(structure)}(Record, name="{structure.removeprefix("kstrip_")}"):',
                  f'    """{" ".join(about.split())}"""', ""]
        for kind, _, name, _, comment in members:
            if name == "reserved":
                continue
            unit = unit_of(comment, about) if kind in ("double", "float") else ""
            arguments = f"{unit!r}, {comment!r}"
            if kind.startswith("kstrip_") and kind != "kstrip_status":
                lines.append(f"    {name} = Part({name_of(kind)}, {arguments})")
            else:
                lines.append(f"    {name} = {'Numbers' if kind in ('double', 'float') else 'Integers'}({arguments})")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    header = (HERE.parents[1] / "include" / "kstrip.h").read_text(encoding="utf-8")
    (HERE / "kstrip" / "_types.py").write_text(text(header), encoding="utf-8")
