#!/usr/bin/env python3
"""Writes kstrip/_table.py and kstrip/values.py from include/kstrip.h: the table of the C library, and a class for each structure.

    python bindings/python/write_types.py            (a test compares the files with the header)
"""

import pathlib
import pprint
import re

import read_header

HERE = pathlib.Path(__file__).resolve().parent
#: Structures that are made for one call, or have a class of their own
INTERNAL = {"options", "surface", "gap", "wheel_workspace", "wheelset_workspace", "prepared", "profile_contact", "measured_force", "wheelset_loads", "table_spec", "table_report"}
#: Classes with more members than those of the structure
BASES = {"wheel_pair": "FrictionPlaces"}
SCALARS = {"double": "float", "int32_t": "int", "uint32_t": "int", "kstrip_status": "int"}


def class_of(structure):
    return "".join(word.capitalize() for word in structure.split("_"))


def unit_of(comment, structure):
    """The first [...] of a comment, else that of the structure's; "" for numbers without a unit."""
    found = re.search(r"\[([^\]]+)\]", comment) or re.search(r"\[([^\]]+)\]", structure)
    return "" if found is None or set(found[1]) <= set("-, ") else found[1]


def table(header):
    """The module _table.py."""
    structures = {name.removeprefix("kstrip_"): tuple((member.name, member.kind, member.counts) for member in members)
                  for name, _, members in read_header.structures(header)}
    functions = {name: (result, tuple(arguments)) for name, result, arguments in read_header.functions(header)}
    parts = [
        ("CONSTANTS", "KSTRIP_NAME: value", "int", read_header.constants(header)),
        ("STRUCTURES", "name without kstrip_: (member, C type, counts of its elements) of each member", "tuple[tuple[str, str, tuple[int, ...]], ...]",
         structures),
        ("FUNCTIONS", "name: (C type of the result, (C type, name) of each argument)", "tuple[str, tuple[tuple[str, str], ...]]", functions),
    ]
    lines = ['"""Constants, structures and functions of kstrip.h. Written by write_types.py: do not edit."""']
    for name, about, kind, value in parts:
        lines += ["", f"#: {about}", f"{name}: dict[str, {kind}] = {pprint.pformat(value, width=150, sort_dicts=False)}"]
    return "\n".join(lines) + "\n"


def annotation(member):
    if member.kind in SCALARS:
        return "Array" if member.counts else SCALARS[member.kind]
    name = class_of(member.kind.removeprefix("kstrip_"))
    return f"Batch[{name}]" if member.counts else name


def value_class(structure, about, members):
    """The lines of one class."""
    kept = [member for member in members if member.name != "reserved"]
    units = {member.name: unit_of(member.comment, about) for member in kept if member.kind == "double"}
    units = {name: unit for name, unit in units.items() if unit}
    lines = ["", "", "@dataclass(slots=True, init=False, repr=False, eq=False)", f"class {class_of(structure)}({BASES.get(structure, 'Value')}):",
             f'    """{about}', "", *(f"    {member.name}: {member.comment}" for member in kept), '    """', "",
             f'    _structure: ClassVar[str] = "{structure}"', f"    _units: ClassVar[dict[str, str]] = {units!r}", ""]
    lines += [f"    {member.name}: {annotation(member)}" for member in kept]
    arguments = ", ".join(f"{member.name}: {annotation(member)}" for member in kept)
    lines += ["", f"    def __init__(self, {arguments}) -> None:"]
    return lines + [f"        self.{member.name} = {member.name}" for member in kept]


def values(header):
    """The module values.py."""
    lines = [
        '"""Values: a class for each structure of kstrip.h. Written by write_types.py: do not edit.',
        "",
        "The members of each class are numbers in SI units, numpy arrays and other values. The functions of kstrip make them, and take them",
        'one by one or many in a kstrip.Batch."""',
        "",
        "from __future__ import annotations",
        "",
        "from dataclasses import dataclass",
        "from typing import TYPE_CHECKING, ClassVar",
        "",
        "from ._value import Array, FrictionPlaces, Value",
        "",
        "if TYPE_CHECKING:",
        "    from ._batch import Batch",
        "",
    ]
    classes, names = [], []
    for name, about, members in read_header.structures(header):
        structure = name.removeprefix("kstrip_")
        # A structure of pointers is formed for each call.
        if structure not in INTERNAL and all(member.kind != "pointer" for member in members):
            names.append(class_of(structure))
            classes += value_class(structure, about, members)
    lines += [f"__all__ = {pprint.pformat(names, width=150, compact=True)}"]
    classes += ["", "", "#: The class of each structure by its name", "classes: dict[str, type[Value]] = {",
                "    kind._structure: kind for kind in (", *(f"        {name}," for name in names), "    )", "}"]
    return "\n".join(lines + classes) + "\n"


if __name__ == "__main__":
    text = (HERE.parents[1] / "include" / "kstrip.h").read_text(encoding="utf-8")
    for module, made in (("_table", table(text)), ("values", values(text))):
        (HERE / "kstrip" / f"{module}.py").write_text(made, encoding="utf-8")
