"""What the browser demo takes from kstrip.h: constants, layouts of the structures, prototypes of the functions."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "bindings" / "python"))
import read_header  # noqa: E402  (kstrip.h is read as for the Python package)

#: Bytes of a member in the 32 bits of WebAssembly
SIZES = {"double": 8, "int32_t": 4, "uint32_t": 4, "kstrip_status": 4, "ptrdiff_t": 4}
PARAMETER = re.compile(r"(?:const )?(?:struct )?(?P<type>\w+) (?P<pointer>\*?)(?P<name>\w+)")


def text():
    return (ROOT / "include" / "kstrip.h").read_text(encoding="utf-8")


def constants(header):
    return read_header.constants(header)


def structures(header):
    """{name: {"size", "align", "members"}} of every structure, with 32 bits for an address.

    members: {name: {"type", "offset"}}, with "count" for an array and "pointer" for an address.
    """
    known, numbers = {}, constants(header)
    for match in read_header.STRUCTURE.finditer(header):
        body = re.sub(r"/\*.*?\*/", "", match["body"], flags=re.S)
        members, offset, alignment = {}, 0, 4
        for kind, pointer, name, counts in read_header.MEMBER.findall(body):
            size = 4 if pointer else SIZES.get(kind) or known[kind]["size"]
            align = size if pointer or kind in SIZES else known[kind]["align"]
            offset = -(-offset // align) * align
            members[name] = {"type": kind, "offset": offset}
            if pointer:
                members[name]["pointer"] = True
            count = 1
            for index in re.findall(r"\w+", counts):
                count *= int(numbers.get(index, index))
            if counts:
                members[name]["count"] = count
            offset += size * count
            alignment = max(alignment, align)
        known[match["name"]] = {"size": -(-offset // alignment) * alignment, "align": alignment, "members": members}
    return known


def prototypes(header):
    """{name: {"parameters": [{"name", "type", "pointer"}], "text": whether it returns a text}} of every function"""
    found = {}
    for match in read_header.FUNCTION.finditer(header):
        parameters = [] if match["arguments"] == "void" else match["arguments"].split(",")
        parts = [PARAMETER.fullmatch(" ".join(one.split())) for one in parameters]
        found[match["name"]] = {
            "parameters": [{"name": one["name"], "type": one["type"], "pointer": one["pointer"] == "*"} for one in parts],
            "text": "char" in match["result"],
        }
    return found
