"""Reads kstrip.h and kstrip_f32.h and makes ctypes of it: constants, structures, functions with their comments.

Its only syntax is what cbindgen writes for this library.
"""

from __future__ import annotations

import ctypes
import re
from typing import Any, Iterator, Optional

#: Type, pointer, name, counts, comment of a member
Member = tuple[str, str, str, str, str]

SCALARS = {
    "double": ctypes.c_double,
    "float": ctypes.c_float,
    "int32_t": ctypes.c_int32,
    "uint32_t": ctypes.c_uint32,
    "kstrip_status": ctypes.c_int32,
    "ptrdiff_t": ctypes.c_ssize_t,
}

# A comment, and what it stands before.
COMMENT = r"(?:/\*\*(?P<comment>(?:(?!\*/).)*)\*/\s*)?"
CONSTANT = re.compile(r"^#define (KSTRIP_\w+) (-?\d+)", re.M)
STRUCTURE = re.compile(COMMENT + r"typedef struct (?P<name>kstrip_\w+) \{(?P<body>.*?)\n\}", re.S)
MEMBER = re.compile(r"^\s*(?:const )?(?:struct )?(\w+) (\*?)(\w+)((?:\[\w+\])*);", re.M)
FUNCTION = re.compile(
    COMMENT + r"^(?P<result>kstrip_status|int32_t|const char \*)\s*(?P<name>kstrip_\w+)\((?P<arguments>[^)]*)\);",
    re.S | re.M,
)


def text_of(comment: Optional[str]) -> str:
    """A comment without its stars."""
    lines = re.sub(r"^\s*\* ?", "", comment or "", flags=re.M).strip()
    return lines.replace("@param[out]", ":param").replace("@param[in]", ":param").replace("@param", ":param")


def constants(header: str) -> dict[str, int]:
    """KSTRIP_NAME: value"""
    return {name: int(value) for name, value in CONSTANT.findall(header)}


def structures(header: str) -> dict[str, Any]:
    """kstrip_name: ctypes structure with the comment of the header"""
    found: dict[str, Any] = {}
    known = constants(header)
    for match in STRUCTURE.finditer(header):
        body = re.sub(r"/\*.*?\*/", "", match["body"], flags=re.S)
        fields = []
        for kind, pointer, name, counts in MEMBER.findall(body):
            # Pointers are addresses.
            member: Any = ctypes.c_size_t if pointer else SCALARS.get(kind) or found[kind]
            # Numbers, or constants of the header; the last index runs first
            for count in reversed(re.findall(r"\w+", counts)):
                member = member * (known[count] if count in known else int(count))
            fields.append((name, member))
        doc = text_of(match["comment"])
        found[match["name"]] = type(match["name"], (ctypes.Structure,), {"_fields_": fields, "__doc__": doc})
    return found


def members(header: str) -> Iterator[tuple[str, str, list[Member]]]:
    """(kstrip_name, comment, [(type, pointer, name, counts, comment), ...]) of every structure; comments in one line"""
    one = re.compile(r"(?:/\*\*(?P<comment>(?:(?!\*/).)*)\*/\s*)?(?P<member>[^/;]+;)", re.S)
    for match in STRUCTURE.finditer(header):
        found = []
        for part in one.finditer(match["body"]):
            for kind, pointer, name, counts in MEMBER.findall(part["member"]):
                found.append((kind, pointer, name, counts, " ".join(text_of(part["comment"]).split())))
        yield match["name"], text_of(match["comment"]), found


def functions(header: str, known: dict[str, Any]) -> Iterator[tuple[str, Any, list[Any], str]]:
    """(name, result, arguments, comment) of every function, as ctypes"""
    for match in FUNCTION.finditer(header):
        arguments = []
        for argument in match["arguments"].split(","):
            argument = " ".join(argument.replace("const ", "").replace("struct ", "").split())
            if argument == "void":
                continue
            kind = argument.rsplit(" ", 1)[0]
            base = SCALARS.get(kind) or known[kind]
            # Pointers go as addresses: arrays of numpy and structures alike.
            arguments.append(ctypes.c_void_p if "*" in argument else base)
        result = ctypes.c_char_p if "char" in match["result"] else ctypes.c_int32
        yield match["name"], result, arguments, text_of(match["comment"])
