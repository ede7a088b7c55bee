"""Readers of the formats of programs and instruments: SIMPACK, MiniProf, Vampire, JSON and DXF."""

from __future__ import annotations

import importlib
import io
import json
import math
import pathlib
import re
from typing import Any, Callable, Optional, Sequence

import numpy as np

from ._files_points import UNITS, PlainLines, Points, ProfileError, Rows, Wanted
from ._files_table import is_number, read_table

_INCH = 0.0254
_KINDS = {".prw": "wheel", ".whl": "wheel", ".wheel": "wheel", ".whe": "wheel", ".prr": "rail", ".ban": "rail", ".rail": "rail", ".rai": "rail"}


def kind_of_extension(extension: str) -> Optional[str]:
    """The kind that an extension names."""
    return _KINDS.get(extension.lower())


def read_points(path: pathlib.Path, content: bytes, wanted: Wanted) -> Points:
    """The points of a file in any format."""
    if path.suffix.lower() == ".dxf" or re.match(rb"\s*(0\s*\r?\n\s*SECTION|AutoCAD Binary DXF|999\s*\r?\n)", content):
        return _dxf(path, content)
    text = _decoded(path, content)
    if text.lstrip()[:1] in ("{", "["):
        found = _json(path, text)
        if found is not None:
            return found
    # A file of DOS may end with a control character
    lines = text.split("\x1a", 1)[0].replace("\r\n", "\n").replace("\r", "\n").rstrip("\n").split("\n")
    head = [line.strip() for line in lines[:400] if line.strip()]
    return _format_of(path, head)(path, lines, wanted)


def _decoded(path: pathlib.Path, content: bytes) -> str:
    for mark, encoding in ((b"\xef\xbb\xbf", "utf-8-sig"), (b"\xff\xfe", "utf-16"), (b"\xfe\xff", "utf-16")):
        if content.startswith(mark):
            return content.decode(encoding, errors="replace")
    sample = content[:400]
    if len(sample) > 3 and sample[1::2].count(0) > len(sample) // 4:
        return content.decode("utf-16-le", errors="replace")
    if len(sample) > 3 and sample[::2].count(0) > len(sample) // 4:
        return content.decode("utf-16-be", errors="replace")
    if b"\0" in content:
        raise ProfileError(path, None, "this is no text: it contains bytes that are zero")
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError:
        return content.decode("latin-1")


def _format_of(path: pathlib.Path, head: list[str]) -> Callable[[pathlib.Path, list[str], Wanted], Points]:
    if any(re.match(r"(header|spline|point)\.begin\b", line) for line in head):
        return _simpack
    if head and head[0].upper() in ("WHEELPROFILE", "RAILPROFILE"):
        return _vampire
    # MiniProf: `Key=value`, also in quotation marks, [sections], or the title lines of old instruments
    is_miniprof = any(re.match(r'#?MINI(WHEEL|RAIL)?PROF', line, re.IGNORECASE) for line in head[:10]) or any(
        re.match(r'"?(Filename|ProgramName|XYPoints|ColumnDef|MPTypeNo|MPSerNo|RefPoint\d|SectionNo|Transform)\s*=', line, re.IGNORECASE)
        for line in head[:100]) or path.suffix.lower() in (".ban", ".whl", ".mpt") and head and re.match(r'"?[A-Za-z]\w*\s*=', head[0])
    return _miniprof if is_miniprof else read_table


def _pair(found: Points, number: int, words: Sequence[str], columns: tuple[int, int]) -> tuple[float, float]:
    if len(words) <= max(columns):
        raise found.error(number, f"two numbers are needed, and this line has {len(words)} columns")
    bad = next((words[column] for column in columns if not is_number(words[column])), None)
    if bad is not None:
        finite = "" if bad.lower() not in ("nan", "inf") else "finite "
        raise found.error(number, f"{finite}numbers are needed, not {bad[:40]!r}")
    y, z = (float(words[column].upper().replace("D", "E")) for column in columns)
    return y, z


# SIMPACK


def _simpack(path: pathlib.Path, lines: list[str], wanted: Wanted) -> Points:
    found = Points(path, "SIMPACK profile", has_convention=True)
    sections, keys = [""], {}
    rows, plain = Rows(3), PlainLines(lines, change=lambda line: line.partition("!")[0])
    numeric = {"units.len.f", "units.ang.f", "shift.y", "shift.z", "rotate", "mirror.y", "mirror.z", "approx.smooth", "bound.y.min", "bound.y.max",
               "bound.z.min", "bound.z.max"}
    unused = []
    number = 0
    while number < len(lines):
        many = plain.from_line(number) if sections[-1] == "point" else None
        if many is not None and many.shape[1] in (2, 3):
            rows.add_many(many if many.shape[1] == 3 else np.column_stack((many, np.ones(len(many)))), number + 1)
            number += len(many)
            continue
        number += 1
        text = re.split(r"[!%]", lines[number - 1], maxsplit=1)[0].strip()
        if not text:
            continue
        if (mark := re.fullmatch(r"(\w+)\.(begin|end)", text)) is not None:
            if mark[2] == "begin":
                sections.append(mark[1])
            elif sections.pop() != mark[1]:
                raise found.error(number, f"{mark[1]}.end without {mark[1]}.begin")
            if not sections:
                raise found.error(number, f"{mark[1]}.end without {mark[1]}.begin")
        elif sections[-1] == "point":
            words = text.split()
            weight = float(words[2].upper().replace("D", "E")) if len(words) > 2 and is_number(words[2]) else 1.0
            rows.add((*_pair(found, number, words, (0, 1)), weight), number)
        elif (pair := re.fullmatch(r"([\w.]+)\s*=\s*(.*)", text)) is None:
            raise found.error(number, f"`keyword = value` is needed, not {text[:60]!r}")
        elif sections[-1] == "header" and pair[1] == "type":
            found.kind = {"0": "rail", "1": "wheel"}.get(pair[2].strip())
        elif pair[1] in numeric:
            value = pair[2].strip()
            if not is_number(value):
                raise found.error(number, f"{pair[1]} is not a number: {value[:40]!r}")
            keys[pair[1]] = float(value.upper().replace("D", "E"))
        elif pair[1] not in ("version", "comment", "file", "type"):
            unused.append(pair[1])
    if len(sections) > 1:
        raise found.error(len(lines), f"the file ends within {sections[-1]}.begin")
    length, angle = keys.get("units.len.f", 1.0), keys.get("units.ang.f", 1.0)
    if not (0 < length < math.inf and 0 < angle < math.inf):
        raise found.error(None, "units.len.f and units.ang.f must be positive")
    points, found.line = rows.arrays()
    found.y, found.z = points[:, 0], points[:, 1]
    _simpack_points(found, keys, points[:, 2])
    if keys.get("approx.smooth"):
        found.notes.append(f"approx.smooth = {keys['approx.smooth']:g} is not applied: prepare(smoothing_length=...) smooths")
    if unused:
        found.notes.append(f"not used: {', '.join(sorted(set(unused))[:6])}")
    # Factors are user's units per metre and per radian.
    found.unit, found.unit_source = 1.0 / length, f"units.len.f = {length:g}"
    found.shift = keys.get("shift.y", 0.0) / length, keys.get("shift.z", 0.0) / length
    found.turn = keys.get("rotate", 0.0) / angle
    found.mirror = bool(keys.get("mirror.y")), bool(keys.get("mirror.z"))
    return found


def _simpack_points(found: Points, keys: dict[str, float], weights: Any) -> None:
    """Leaves out points without weight and beyond the bounds."""
    for name, values in (("y", found.y), ("z", found.z)):
        least, most = keys.get(f"bound.{name}.min", -math.inf), keys.get(f"bound.{name}.max", math.inf)
        if least < most and (least > -math.inf or most < math.inf):
            outside = (values < least) | (values > most)
            weights = np.where(outside, np.nan, weights)
            if outside.any():
                found.notes.append(f"{np.count_nonzero(outside)} points beyond bound.{name}, {least:g} to {most:g}, are left out")
    if (weights == 0.0).any():
        found.notes.append(f"{np.count_nonzero(weights == 0.0)} points of weight 0 are left out")
    if ((weights != 0.0) & (weights != 1.0) & np.isfinite(weights)).any():
        found.notes.append("weights other than 0 are not used: all points count alike")
    keep = np.isfinite(weights) & (weights != 0.0)
    if not keep.all():
        found.y, found.z = found.y[keep], found.z[keep]
        found.line = np.asarray(found.line)[keep]


# MiniProf


def _miniprof(path: pathlib.Path, lines: list[str], wanted: Wanted) -> Points:
    """Files of MiniProf instruments: `Key=value` lines, [sections], or the title lines of old instruments, and then the points."""
    found = Points(path, "MiniProf profile", unit=1e-3, unit_source="MiniProf's", from_flange_back=True)
    header, columns, marked, section = {}, (0, 1), [0, 0], ""
    profiles: dict[str, Rows] = {}
    sections: dict[str, dict[str, str]] = {}
    segments: dict[str, list[tuple[str, list[float], int]]] = {}
    previous: Optional[int] = None
    footers: dict[str, tuple[int, str]] = {}
    number, plain = 0, PlainLines(lines)
    while number < len(lines):
        many = plain.from_line(number) if previous is not None and section not in footers else None
        if many is not None and many.shape[1] > max(columns):
            profiles[section].add_many(many[:, columns], number + 1)
            number += len(many)
            continue
        number += 1
        text = lines[number - 1].strip()
        if not text:
            continue
        if (mark := re.fullmatch(r"\[([^\]]*)\]", text)) is not None:
            section, previous = mark[1], None
            continue
        if text[0] in "#!%*/" or re.match(r"MINI(WHEEL|RAIL)?PROF\b", text, re.IGNORECASE):
            title = re.match(r"#?MINI(WHEEL|RAIL)PROF", text, re.IGNORECASE)
            if title is not None and not profiles:
                found.kind, found.kind_source = title[1].lower(), "by its title"
            continue
        pair = re.fullmatch(r'"?([A-Za-z][\w .]*?)\s*=(.*)', text)
        if pair is not None:
            key, value = pair[1].lower(), pair[2].strip().rstrip('"').strip()
            if re.fullmatch(r"mpd\d+", key):
                words = value.split()
                if not words or not all(is_number(word) for word in words[1:]):
                    raise found.error(number, f"a segment is a letter and numbers, not {value[:60]!r}")
                segments.setdefault(section, []).append((words[0].upper(), [float(word) for word in words[1:]], number))
                continue
            header[key] = value
            sections.setdefault(section, {})[key] = value
            if key == "columndef" and not profiles.get(section):
                names = [name.strip().upper() for name in value.split(",")]
                if "X" not in names or "Y" not in names:
                    raise found.error(number, f"ColumnDef has no X and Y: {value[:60]}")
                columns = names.index("X"), names.index("Y")
            continue
        rows = profiles.setdefault(section, Rows())
        if text.startswith('"'):
            # Before the first point it may be a title
            marked[rows.count > 0] += 1
            continue
        words = _words(text)
        if len(words) >= 2 and all(is_number(word) for word in words):
            if section in footers:
                line, footer = footers[section]
                raise found.error(line, f"numbers are needed, not {footer[:60]!r}")
            rows.add(_pair(found, number, words, columns), number)
            previous = number
        elif rows.count < 3:
            # Title lines of old instruments: text, or numbers and text
            profiles[section] = Rows()
        elif re.match(r"[+-]*[.,]?[0-9]", text):
            _pair(found, number, words, columns)
            raise found.error(number, f"numbers are needed, not {text[:60]!r}")
        else:
            footers.setdefault(section, (number, text))
    return _miniprof_points(found, profiles, segments, sections, header, marked, footers, len(lines))


def _words(text: str) -> list[str]:
    """The words of a line of points, with decimal points."""
    words = [word for word in re.split(r"[\s;]+", text) if word]
    if "," not in text:
        return words
    if len(words) >= 2 and all(is_number(word.replace(",", ".", 1)) for word in words):
        return [word.replace(",", ".") for word in words]
    return [word for word in re.split(r"[\s;,]+", text) if word]


def _miniprof_points(found: Points, profiles: dict[str, Rows], segments: dict[str, list[tuple[str, list[float], int]]],
                     sections: dict[str, dict[str, str]], header: dict[str, str], marked: list[int], footers: dict[str, tuple[int, str]],
                     end: int) -> Points:
    for name, parts in segments.items():
        if name not in profiles or profiles[name].count == 0:
            profiles[name] = _segments(found, parts)
    filled = {name: rows for name, rows in profiles.items() if rows.count}
    section = next(iter(filled), "")
    if len(filled) > 1:
        found.warnings.append(f"this file has {len(filled)} profiles, of which that of [{section}] is read")
    points, found.line = filled.get(section, Rows()).arrays()
    count = len(points)
    header = {**header, **sections.get(section, {})} if section else header
    found.from_flange_back = header.get("origin", "").lower() != "running circle"
    if marked[1]:
        found.notes.append(f'{marked[1]} points that the file marks by a leading " are left out')
    if section in footers:
        found.notes.append(f"the lines from line {footers[section][0]} on, {footers[section][1][:40]!r}, stand after the points and are left out")
    promised, counts = header.get("xypoints", ""), {count, count + marked[1], count + sum(marked)}
    if promised.isdigit() and len(promised) < 10 and count and int(promised) not in counts:
        message = f"XYPoints promises {promised} points, and the file has {count + marked[1]}"
        if max(counts) < int(promised) - 1:
            raise found.error(end, message)
        found.notes.append(message)
    found.y, found.z = points[:, 0], points[:, 1]
    return found


def _segments(found: Points, parts: list[tuple[str, list[float], int]]) -> Rows:
    """The points of a drawn profile: lines from one point to the next."""
    rows, end = Rows(), None
    for letter, numbers, line in parts:
        if letter != "L" or len(numbers) != 4:
            raise found.error(line, f"a segment {letter!r} with {len(numbers)} numbers cannot be read; lines are `L y z y z`")
        if numbers[:2] != end:
            rows.add(numbers[:2], line)
        end = numbers[2:]
        rows.add(end, line)
    return rows


# Vampire


def _vampire(path: pathlib.Path, lines: list[str], wanted: Wanted) -> Points:
    """Both sides of a wheelset or a track in four columns; the right side is taken."""
    kind = "wheel" if lines and next(line for line in lines if line.strip()).strip().upper() == "WHEELPROFILE" else "rail"
    found = Points(path, "Vampire profile", unit=1e-3, unit_source="Vampire's", kind=kind, has_convention=True)
    rows, keys, plain = Rows(4), {}, PlainLines(lines)
    title = number = 0
    while number < len(lines):
        many = plain.from_line(number) if rows.count else None
        if many is not None and many.shape[1] == 4:
            rows.add_many(many, number + 1)
            number += len(many)
            continue
        number += 1
        text = re.split(r'["!%]', lines[number - 1], maxsplit=1)[0].strip()
        words = text.replace(",", " ").split()
        if not text:
            continue
        title += 1
        if title <= 2:
            continue
        key = words[0].upper()
        if key in ("TREADDATUM", "FLANGEBACK", "GAUGEPOINT", "GAUGE"):
            keys[key] = [word.upper() for word in words[1:]]
        elif all(is_number(word) for word in words):
            if len(words) != 4:
                raise found.error(number, f"four numbers are needed, y and z of the left and of the right side, and this line has {len(words)}")
            rows.add((*_pair(found, number, words, (0, 1)), *_pair(found, number, words, (2, 3))), number)
        else:
            raise found.error(number, f"numbers are needed, not {text[:60]!r}")
    points, found.line = rows.arrays()
    found.y, found.z = points[:, 2], points[:, 3]
    if not np.allclose(points[:, :2] * (-1, 1), points[:, 2:], atol=1e-6):
        found.notes.append("left and right differ: the right side is read")
    return _vampire_origin(found, keys)


def _vampire_origin(found: Points, keys: dict[str, list[str]]) -> Points:
    """y from the running circle of a wheel, and from the middle of a rail's head; z down."""

    def number(name: str, of: Sequence[str]) -> float:
        if not of or not is_number(of[0]):
            raise found.error(None, f"{name} needs a number")
        return float(of[0])

    if found.kind == "wheel":
        datum = keys.get("TREADDATUM", ["EUROPEAN"]) or ["EUROPEAN"]
        inches = {"US1": 2 + 27 / 32, "US2": 3 + 1 / 16}
        if datum[0] == "CUSTOM":
            back = number("TREADDATUM CUSTOM", datum[1:])
        elif datum[0] == "EUROPEAN" or datum[0] in inches:
            back = 1e3 * _INCH * inches[datum[0]] if datum[0] in inches else 70.0
        else:
            raise found.error(None, f"TREADDATUM is EUROPEAN, US1, US2 or CUSTOM, not {datum[0][:20]}")
        if "FLANGEBACK" in keys:
            half = 0.5 * number("FLANGEBACK", keys["FLANGEBACK"])
            found.shift = -1e-3 * (half + back), 0.0
            found.notes.append(f"y = 0 is the tread datum, {back:g} mm from the flange back, {half:g} mm from the middle of the wheelset")
    else:
        # Heights point up
        found.mirror = False, True
        half = 0.5 * number("GAUGE", keys.get("GAUGE", ["0"]))
        if found.y.size:
            found.shift = -1e-3 * half, -1e-3 * float(found.z.max())
            found.notes.append(f"y = 0 is {half:g} mm from the middle of the track, z = 0 the top of the rail")
    return found


# JSON


def _json(path: pathlib.Path, text: str) -> Optional[Points]:
    """Objects with y and z, or a list of points; None for a text that is no JSON, such as a matrix in brackets."""
    try:
        # numpy writes the numbers of lists as np.float64(1.0)
        value = json.loads(re.sub(r"\bnp\.float\d+\(([^()]*)\)", r"\1", text) if "np.float" in text else text)
    except (ValueError, RecursionError):
        return None
    found = Points(path, "JSON")
    if isinstance(value, dict):
        lower = {str(key).lower(): item for key, item in value.items()}
        unit = lower.get("units", lower.get("unit"))
        if isinstance(unit, str) and unit in UNITS:
            found.unit, found.unit_source = UNITS[unit], "units of the file"
        if lower.get("kind") in ("wheel", "rail"):
            found.kind = lower["kind"]
        for unit in UNITS:
            if f"y_{unit}" in lower and f"z_{unit}" in lower:
                lower["y"], lower["z"] = lower[f"y_{unit}"], lower[f"z_{unit}"]
                found.unit, found.unit_source = UNITS[unit], "the names say so"
        value = list(zip(lower["y"], lower["z"])) if _are_lists(lower) else lower.get("points", lower.get("profile"))
    if isinstance(value, list) and any(isinstance(point, dict) for point in value):
        value = [(point.get("y"), point.get("z")) if isinstance(point, dict) else point for point in value]
    try:
        points = np.array(value, float)
    except (TypeError, ValueError, OverflowError, RecursionError):
        points = np.zeros(0)
    if points.ndim != 2 or points.shape[-1] != 2:
        if isinstance(value, list) and text.lstrip()[0] == "[":
            return None
        raise found.error(None, "JSON needs lists y and z of one length, or points [[y, z], ...]")
    found.y, found.z = points[:, 0].copy(), points[:, 1].copy()
    return found


def _are_lists(value: dict[str, Any]) -> bool:
    y, z = value.get("y"), value.get("z")
    return isinstance(y, list) and isinstance(z, list) and len(y) == len(z)


# DXF


def _dxf(path: pathlib.Path, content: bytes) -> Points:
    """The longest chain of lines, polylines, arcs and splines of a drawing, within 2 um of a drawing in mm."""
    try:
        flat, recover = importlib.import_module("ezdxf.path"), importlib.import_module("ezdxf.recover")
    except ImportError:
        raise ProfileError(path, None, "DXF files need the package ezdxf: pip install kstrip[dxf]") from None
    found = Points(path, "DXF drawing")
    try:
        drawing, _ = recover.read(io.BytesIO(content))
    except Exception as error:
        raise found.error(None, f"this is no DXF file that ezdxf reads: {error}") from None
    unit = {1: "in", 4: "mm", 5: "cm", 6: "m"}.get(drawing.header.get("$INSUNITS", 0))
    if unit is not None:
        found.unit, found.unit_source = UNITS[unit], "the drawing's"
    pieces = []
    for entity in drawing.modelspace().query("LWPOLYLINE POLYLINE LINE ARC SPLINE ELLIPSE"):
        points = np.array([(p.x, p.y) for p in flat.make_path(entity).flattening(2e-3 * 1e-3 / (found.unit or 1e-3))]).reshape(-1, 2)
        if not np.isfinite(points).all():
            raise found.error(None, "a coordinate of the drawing is not a finite number")
        if len(points) > 1:
            pieces.append(points)
    chains = _chains(pieces)
    if not chains:
        raise found.error(None, "the drawing has no lines, polylines, arcs or splines")
    lengths = [float(np.hypot(*np.diff(chain, axis=0).T).sum()) for chain in chains]
    chosen = chains[int(np.argmax(lengths))]
    if len(chains) > 1:
        rest = sorted(lengths)[-2]
        message = f"the drawing has {len(chains)} separate lines, of which the longest is read"
        (found.warnings if rest > 0.3 * max(lengths) else found.notes).append(message)
    found.y, found.z = chosen[:, 0].copy(), chosen[:, 1].copy()
    return found


def _chains(pieces: list[Any]) -> list[Any]:
    """Pieces whose ends meet, joined."""
    near = max(1e-5 * float(np.ptp(np.concatenate(pieces), axis=0).max()), 1e-300) if pieces else 0.0
    # Numbers of the pieces with an end in each cell of a grid, in ascending order
    ends: dict[tuple[int, int], dict[int, None]] = {}
    rest = dict.fromkeys(range(len(pieces)))

    def cell(point: Any) -> tuple[int, int]:
        return math.floor(point[0] / near), math.floor(point[1] / near)

    def take(k: int) -> Any:
        del rest[k]
        for point in (pieces[k][0], pieces[k][-1]):
            ends[cell(point)].pop(k, None)
        return pieces[k]

    def from_point(point: Any) -> Any:
        """The first piece with an end at a point, beginning there; None without one."""
        column, row = cell(point)
        around = (ends.get((column + i, row + j), {}) for i in (-1, 0, 1) for j in (-1, 0, 1))
        for k in sorted(set().union(*around)):
            for turn in (1, -1):
                if np.abs(pieces[k][::turn][0] - point).max() < near:
                    return take(k)[::turn]
        return None

    def grown(point: Any) -> list[Any]:
        """The pieces that follow a point, without the points where they begin."""
        parts = []
        while (piece := from_point(point)) is not None:
            parts.append(piece[1:])
            point = piece[-1]
        return parts

    for k, piece in enumerate(pieces):
        for point in (piece[0], piece[-1]):
            ends.setdefault(cell(point), {})[k] = None
    chains = []
    while rest:
        first = take(next(iter(rest)))
        after, before = grown(first[-1]), grown(first[0])
        chains.append(np.concatenate([part[::-1] for part in reversed(before)] + [first] + after))
    return chains
