#!/usr/bin/env python3
"""The calls of the C library in the scripts of the browser demo, compared with the prototypes of kstrip.h.

    calls.py        checks the calls and prints the functions that the demo calls, one a line
"""

import pathlib
import re

import header

HERE = pathlib.Path(__file__).resolve().parent
SCRIPTS = ["library.js", "fastsim.js", "draw.js", "profiles.js", "programs.js", "contact.js", "wheel.js", "page.js"]
#: `library.call("name", arguments)`
CALL = re.compile(r'\.call\(\s*(?:"(?P<name>\w+)")?')
#: A string, a template, a bracket or a comma
TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|`(?:\\.|[^`\\])*`|[(\[{}\])]|,')


def arguments(script, start):
    """Start and end of each argument of the call whose opening bracket ends at `start`"""
    depth, begin, found = 0, start, []
    for token in TOKEN.finditer(script, start):
        if token[0] in "([{":
            depth += 1
        elif token[0] == "," and depth == 0:
            found.append((begin, token.start()))
            begin = token.end()
        elif token[0] in ")]}":
            depth -= 1
            if depth < 0:
                return [*found, (begin, token.start())] if script[begin : token.start()].strip() else found
    raise ValueError("a call without an end")


def calls(script):
    """(name, place, [(start, end) of each argument after the name]) of every call; the name is None if it is not written in the call"""
    for match in CALL.finditer(script):
        opening = script.index("(", match.start()) + 1
        name = f"kstrip_{match['name']}" if match["name"] else None
        yield name, match.start(), arguments(script, opening)[1:]


def checked(scripts, prototypes):
    """The names of the functions that the scripts, {file: text}, call. A call with an argument too many or too few is a ValueError."""
    used = set()
    for file, script in scripts.items():
        for name, place, given in calls(script):
            where = f"{file}:{script.count(chr(10), 0, place) + 1}"
            if name not in prototypes:
                raise ValueError(f"{where}: {name or 'the function of this call'} is not a function of kstrip.h")
            if any(script[start:end].strip().startswith("...") for start, end in given):
                raise ValueError(f"{where}: {name}() takes its arguments one by one")
            expected = len(prototypes[name]["parameters"])
            if len(given) != expected:
                raise ValueError(f"{where}: {name}() takes {expected} arguments, not {len(given)}")
            used.add(name)
    return sorted(used)


def scripts():
    """{file: text} of the scripts, in the order in which they are run"""
    return {name: (HERE / name).read_text(encoding="utf-8") for name in SCRIPTS}


if __name__ == "__main__":
    print("\n".join(checked(scripts(), header.prototypes(header.text()))))
