"""Reads kstrip.h: constants, structures with their comments, functions. Its only syntax is what cbindgen writes for this library."""

from __future__ import annotations

import re
from typing import Iterator, NamedTuple, Optional

# A comment, and the declaration after it
COMMENT = r"(?:/\*\*(?P<comment>(?:(?!\*/).)*)\*/\s*)?"
CONSTANT = re.compile(r"^#define (KSTRIP_\w+) (-?\d+)", re.M)
STRUCTURE = re.compile(COMMENT + r"typedef struct (?P<name>kstrip_\w+) \{(?P<body>.*?)\n\}", re.S)
MEMBER = re.compile(r"^\s*(?:const )?(?:struct )?(\w+) (\*?)(\w+)((?:\[\w+\])*);", re.M)
FUNCTION = re.compile(r"^(?P<result>kstrip_status|int32_t|const char \*)\s*(?P<name>kstrip_\w+)\((?P<arguments>[^)]*)\);", re.S | re.M)


class Member(NamedTuple):
    """A member of a structure; `kind` is its C type, "pointer" for every pointer."""

    kind: str
    name: str
    counts: tuple[int, ...]
    comment: str


def text_of(comment: Optional[str]) -> str:
    """A comment in one line."""
    return " ".join(re.sub(r"^\s*\* ?", "", comment or "", flags=re.M).split())


def constants(header: str) -> dict[str, int]:
    """KSTRIP_NAME: value"""
    return {name: int(value) for name, value in CONSTANT.findall(header)}


def structures(header: str) -> Iterator[tuple[str, str, list[Member]]]:
    """(kstrip_name, comment, members) of each structure"""
    known = constants(header)
    part = re.compile(COMMENT + r"(?P<member>[^/;]+;)", re.S)
    for match in STRUCTURE.finditer(header):
        found = []
        for each in part.finditer(match["body"]):
            for kind, pointer, name, counts in MEMBER.findall(each["member"]):
                sizes = tuple(known[word] if word in known else int(word) for word in re.findall(r"\w+", counts))
                found.append(Member("pointer" if pointer else kind, name, sizes, text_of(each["comment"])))
        yield match["name"], text_of(match["comment"]), found


def functions(header: str) -> Iterator[tuple[str, str, list[tuple[str, str]]]]:
    """(kstrip_name, type of the result, [(type, name) of each argument]) of each function; "pointer" for every pointer"""
    for match in FUNCTION.finditer(header):
        arguments = []
        for argument in match["arguments"].split(","):
            words = argument.replace("const ", "").replace("struct ", "").split()
            if words != ["void"]:
                arguments.append(("pointer" if "*" in argument else words[0], words[-1].lstrip("*")))
        yield match["name"], "pointer" if "*" in match["result"] else match["result"], arguments
