"""Profile files: SIMPACK (.prw, .prr), MiniProf (.whl, .ban), columns of text and CSV."""

from __future__ import annotations

import dataclasses
import os
import pathlib
import re
from typing import Any, Callable, Optional, Sequence, Union

import numpy as np
from numpy.typing import DTypeLike, NDArray

from ._types import Surface
from ._wheel import prepare_profile

Array = NDArray[np.float64]
#: metres per unit
_UNITS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "in": 0.0254}
_KINDS = {".prw": "wheel", ".whl": "wheel", ".wheel": "wheel", ".prr": "rail", ".ban": "rail", ".rail": "rail"}
_COMMENT = "#!%*/"


class ProfileError(ValueError):
    """A profile file that cannot be read; `path`, and `line` where one is at fault."""

    def __init__(self, path: Any, line: Optional[int], message: str):
        super().__init__(f"{path}{'' if line is None else f', line {line}'}: {message}")
        self.path, self.line = str(path), line


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Profile:
    """The points of a wheel's or a rail's profile as the library takes them.

    y, z: in metres, shape (n,), toward larger y, z down; the flange of a wheel and the gauge side of a rail are at small y.
    kind: "wheel" or "rail". name: that of the file. notes: what the file contained and what was changed, a sentence each.
    """

    y: Array
    z: Array
    kind: str
    name: str = ""
    notes: tuple[str, ...] = ()

    def prepare(self, step: float = 0.0, smoothing_length: float = 0.0, dtype: DTypeLike = np.float64) -> Surface:
        """prepare_profile() of the points; smoothing_length [m]: 2 to 4 mm suit measured profiles."""
        return prepare_profile(self.y, self.z, step, smoothing_length, dtype)

    def __repr__(self) -> str:
        span = ", ".join(f"{name} {1e3 * v.min():.2f} to {1e3 * v.max():.2f} mm" for name, v in (("y", self.y), ("z", self.z)))
        return "\n  ".join((f"Profile of a {self.kind}, {self.y.size} points, {span}{self.name and f' ({self.name})'}", *self.notes))


@dataclasses.dataclass
class _Points:
    """What a file says: points in its own units, and what its header says."""

    format: str
    y: list[float] = dataclasses.field(default_factory=list)
    z: list[float] = dataclasses.field(default_factory=list)
    #: of each point
    line: list[int] = dataclasses.field(default_factory=list)
    notes: list[str] = dataclasses.field(default_factory=list)
    #: metres per unit, and how that is known
    unit: Optional[float] = None
    unit_source: str = ""
    kind: Optional[str] = None
    #: done after the change of units, in this order
    shift: tuple[float, float] = (0.0, 0.0)
    turn: float = 0.0
    mirror: tuple[bool, bool] = (False, False)

    def add(self, y: float, z: float, line: int) -> None:
        self.y.append(y)
        self.z.append(z)
        self.line.append(line)


def read_profile(path: Union[str, os.PathLike[str]], *, kind: Optional[str] = None, units: Union[str, float, None] = None,
                 mirror_y: Optional[bool] = None, mirror_z: Optional[bool] = None, shift: Sequence[float] = (0.0, 0.0)) -> Profile:
    """Reads a profile file: a wheel or a rail the right way round, in metres.

    Formats: SIMPACK and CONTACT (.prw, .prr), MiniProf (.whl, .ban), columns y and z of text, slices among them, and CSV. Units,
    kind, order, side and direction of z are found in the header or from the shape, and told in `notes`.

    kind: "wheel" or "rail"; None: as header, extension or shape say.
    units: of the file: "mm", "m", "in" or metres per unit; None: as header or size say.
    mirror_y, mirror_z: whether to change the signs of the file's y and z; None: as the shape says: the flange of a wheel reaches
        below its tread, the flange and the gauge side come to small y. The gauge side of a rail is the one farther from its top;
        of a symmetric rail y stays as it is.
    shift: added at the end [m, m]. y = 0 of a wheel is its running circle, z = 0 the height of its nominal radius.
    Raises ProfileError with file and line for what cannot be read, OSError for a file that is not there.

    >>> wheel = kstrip.read_profile("s1002.prw")
    >>> wheel.kind, wheel.y.shape, wheel.notes
    >>> surface = wheel.prepare()
    """
    file = pathlib.Path(path)
    if kind not in (None, "wheel", "rail"):
        raise ValueError(f"kind is 'wheel', 'rail' or None, not {kind!r}")
    lines = file.read_text(encoding="utf-8-sig", errors="replace").splitlines()
    found = _format_of(lines)(file, lines)
    y, z = np.array(found.y), np.array(found.z)
    if y.size < 4:
        raise ProfileError(file, None, f"a profile needs 4 points, and this file has {y.size}")
    bad = ~(np.isfinite(y) & np.isfinite(z))
    if bad.any():
        raise ProfileError(file, found.line[int(np.argmax(bad))], "a coordinate is not a finite number")
    notes = [f"{found.format}, {y.size} points", *found.notes]
    unit = _unit(units, found, y, z, notes)
    y, z = _of_header(found, y * unit, z * unit, notes)
    kind = _kind(kind, found.kind, file.suffix.lower(), y, z, notes)
    y, z = _turned(kind, mirror_y, mirror_z, y, z, notes)
    keep = np.concatenate(([True], np.hypot(np.diff(y), np.diff(z)) > 1e-9))
    if not keep.all():
        notes.append(f"{np.count_nonzero(~keep)} points that coincide with the one before them are left out")
    y, z = y[keep] + float(shift[0]), z[keep] + float(shift[1])
    if any(shift):
        notes.append(f"moved by {1e3 * shift[0]:g} mm in y and {1e3 * shift[1]:g} mm in z, as asked")
    return Profile(y, z, kind, file.name, tuple(notes))


# Formats: lines to points


def _format_of(lines: list[str]) -> Callable[[pathlib.Path, list[str]], _Points]:
    head = [line.strip() for line in lines[:400] if line.strip()]
    if any(re.match(r"(header|spline|point)\.begin\b", line) for line in head):
        return _simpack
    return _miniprof if head and re.match(r"[A-Za-z]\w*\s*=", head[0]) else _columns


def _numbers(path: pathlib.Path, number: int, words: Sequence[str], columns: tuple[int, int]) -> tuple[float, float]:
    if len(words) <= max(columns):
        raise ProfileError(path, number, f"two numbers are needed, and this line has {len(words)} columns")
    try:
        return float(words[columns[0]].replace("D", "E").replace("d", "e")), float(words[columns[1]].replace("D", "E").replace("d", "e"))
    except ValueError as error:
        raise ProfileError(path, number, f"numbers are needed: {error}") from None


def _simpack(path: pathlib.Path, lines: list[str]) -> _Points:
    found, section = _Points("SIMPACK profile"), [""]
    keys: dict[str, float] = {}
    for number, line in enumerate(lines, 1):
        text = re.split(r"[!%]", line, maxsplit=1)[0].strip()
        if not text:
            continue
        if (mark := re.fullmatch(r"(\w+)\.(begin|end)", text)) is not None:
            if mark[2] == "begin":
                section.append(mark[1])
            elif section.pop() != mark[1]:
                raise ProfileError(path, number, f"{mark[1]}.end without {mark[1]}.begin")
        elif section[-1] == "point":
            y, z = _numbers(path, number, text.split(), (0, 1))
            found.add(y, z, number)
        elif (pair := re.fullmatch(r"([\w.]+)\s*=\s*(.*)", text)) is None:
            raise ProfileError(path, number, f"`keyword = value` is needed, not {text!r}")
        elif section[-1] == "header" and pair[1] == "type":
            found.kind = {"0": "rail", "1": "wheel"}.get(pair[2].strip())
        elif pair[1] in ("units.len.f", "units.ang.f", "shift.y", "shift.z", "rotate", "mirror.y", "mirror.z"):
            try:
                keys[pair[1]] = float(pair[2])
            except ValueError:
                raise ProfileError(path, number, f"{pair[1]} is not a number: {pair[2]!r}") from None
    if len(section) > 1:
        raise ProfileError(path, len(lines), f"the file ends within {section[-1]}.begin")
    length = keys.get("units.len.f", 1.0)
    if not (length > 0 and keys.get("units.ang.f", 1.0) > 0):
        raise ProfileError(path, None, "units.len.f and units.ang.f must be positive")
    # Factors are user's units per metre and per radian.
    found.unit, found.unit_source = 1.0 / length, f"units.len.f = {length:g}"
    found.shift = keys.get("shift.y", 0.0) / length, keys.get("shift.z", 0.0) / length
    found.turn = keys.get("rotate", 0.0) / keys.get("units.ang.f", 1.0)
    found.mirror = bool(keys.get("mirror.y")), bool(keys.get("mirror.z"))
    return found


def _miniprof(path: pathlib.Path, lines: list[str]) -> _Points:
    found, header, columns = _Points("MiniProf profile", unit=1e-3, unit_source="MiniProf's"), {}, (0, 1)
    marked = 0
    for number, line in enumerate(lines, 1):
        text = line.strip()
        if not text or text[0] in _COMMENT:
            continue
        if not found.y and not marked and (pair := re.match(r"([A-Za-z]\w*)\s*=(.*)", text)) is not None:
            header[pair[1].lower()] = pair[2].strip()
            if pair[1].lower() == "columndef":
                names = [name.strip().upper() for name in pair[2].split(",")]
                if "X" not in names or "Y" not in names:
                    raise ProfileError(path, number, f"ColumnDef has no X and Y: {pair[2]}")
                columns = names.index("X"), names.index("Y")
        elif text.startswith('"'):
            marked += 1
        else:
            y, z = _numbers(path, number, re.split(r"[\s;,]+", text), columns)
            found.add(y, z, number)
    if marked:
        found.notes.append(f'{marked} points that the file marks by a leading " are left out')
    promised = header.get("xypoints", "")
    if promised.isdigit() and int(promised) != len(found.y) + marked:
        raise ProfileError(path, len(lines), f"XYPoints promises {promised} points, and the file has {len(found.y) + marked}")
    return found


def _columns(path: pathlib.Path, lines: list[str]) -> _Points:
    found, columns, names = _Points("columns of numbers"), (0, 1), ""
    for number, line in enumerate(lines, 1):
        text = line.split("#", 1)[0].strip()
        if not text or text[0] in _COMMENT:
            continue
        # A decimal comma goes with semicolons.
        words = [w for w in re.split(r"[;\t]", text.replace(",", "."))] if ";" in text else re.split(r"\s*,\s*|\s+", text)
        if not found.y and not _is_number(words[0]):
            if names:
                raise ProfileError(path, number, f"numbers are needed, not {text!r}")
            names, columns = text, _named([word.strip().strip('"') for word in re.split(r"[;,\t]", text)] if re.search(r"[;,\t]", text) else words)
            continue
        y, z = _numbers(path, number, [word.strip() for word in words], columns)
        found.add(y, z, number)
    if names:
        found.notes.append(f"columns {columns[0] + 1} and {columns[1] + 1} of {names!r}")
        unit = re.search(r"(?<![A-Za-z])(mm|cm|in|m)(?![A-Za-z])", names)
        if unit is not None:
            found.unit, found.unit_source = _UNITS[unit[1]], "the names of the columns say so"
    return found


def _is_number(word: str) -> bool:
    try:
        float(word.replace("D", "E"))
    except ValueError:
        return False
    return True


def _named(names: Sequence[str]) -> tuple[int, int]:
    """The columns of y and z by their names, else the first two."""
    letters = [re.split(r"[^A-Za-z]", name.strip().lower(), maxsplit=1)[0] for name in names]
    for pair in (("y", "z"), ("x", "z"), ("x", "y"), ("lateral", "vertical")):
        if set(pair) <= set(letters):
            return letters.index(pair[0]), letters.index(pair[1])
    return 0, 1


# What the points are


def _unit(asked: Union[str, float, None], found: _Points, y: Array, z: Array, notes: list[str]) -> float:
    """Metres per unit."""
    if asked is not None:
        if isinstance(asked, str) and asked not in _UNITS:
            raise ValueError(f"units are one of {', '.join(_UNITS)} or metres per unit, not {asked!r}")
        unit, source = _UNITS[asked] if isinstance(asked, str) else float(asked), "as asked"
        if not (0 < unit < np.inf):
            raise ValueError(f"metres per unit must be positive, not {asked!r}")
    elif found.unit is not None:
        unit, source = found.unit, found.unit_source
    else:
        # Profiles are 30 to 250 mm wide: 0.03 to 0.25 m, 1.2 to 10 in
        width = max(np.ptp(y), np.ptp(z))
        unit, source = next((_UNITS[name] for name, most in (("m", 0.6), ("in", 12.0)) if width <= most), 1e-3), f"by the width of {width:g}"
    name = next((name for name, factor in _UNITS.items() if np.isclose(factor, unit, rtol=1e-12)), f"{unit:g} m")
    notes.append(f"units: {name}, {source}")
    return unit


def _of_header(found: _Points, y: Array, z: Array, notes: list[str]) -> tuple[Array, Array]:
    """Shift, turn and mirrors that a SIMPACK file requests."""
    if any(found.shift) or found.turn or any(found.mirror):
        notes.append(f"the header's shift ({found.shift[0]:g}, {found.shift[1]:g}) m, turn {found.turn:g} rad and mirrors {found.mirror} are applied")
    y, z = y + found.shift[0], z + found.shift[1]
    cosine, sine = np.cos(found.turn), np.sin(found.turn)
    y, z = cosine * y - sine * z, sine * y + cosine * z
    return -y if found.mirror[0] else y, -z if found.mirror[1] else z


def _kind(asked: Optional[str], header: Optional[str], extension: str, y: Array, z: Array, notes: list[str]) -> str:
    for kind, source in ((asked, "as asked"), (header, "by its header"), (_KINDS.get(extension), f"by its extension {extension}")):
        if kind is not None:
            notes.append(f"{kind}, {source}")
            return kind
    tip, _, inside = _flange(y, z)
    position = (y[tip] - y.min()) / np.ptp(y)
    if inside:
        kind = "wheel" if min(position, 1 - position) < 0.25 else "rail"
    else:
        # Without the tip of a flange: a rail's head is at most 80 mm wide, and both of its ends lie on one side of its middle.
        ends = np.array([z[0], z[-1]]) - np.interp(0.5 * (y.min() + y.max()), *_ascending(y, z))
        kind = "rail" if np.ptp(y) < 0.09 or ends.prod() > 0 and abs(ends).min() > 0.2 * abs(ends).max() else "wheel"
    notes.append(f"{kind}, by its shape")
    return kind


def _flange(y: Array, z: Array) -> tuple[int, int, bool]:
    """The point of a wheel's flange that is farthest from its tread; 1 where that is at larger z, -1 at smaller; whether it is a tip."""
    middle, best = np.median(z), []
    for sign in (1, -1):
        tip = int(np.argmax(sign * z))
        # A chamfer of the rim is extreme at the end of the profile, a flange before it.
        inside = min(sign * (z[tip] - z[0]), sign * (z[tip] - z[-1])) > 2e-4
        best.append((inside and sign * (z[tip] - middle) > 0.01, sign * (z[tip] - middle), tip, sign))
    inside, _, tip, sign = max(best)
    return tip, sign, bool(inside)


def _turned(kind: str, mirror_y: Optional[bool], mirror_z: Optional[bool], y: Array, z: Array, notes: list[str]) -> tuple[Array, Array]:
    """z down, the flange or the gauge side at small y, points toward larger y."""
    if y[0] > y[-1]:
        y, z = y[::-1], z[::-1]
        notes.append("order: the points ran toward smaller y and are reversed")
    upward = _flange(y, z)[1] < 0 if kind == "wheel" else 0.5 * (z[0] + z[-1]) < np.interp(0.5 * (y[0] + y[-1]), *_ascending(y, z))
    if mirror_z if mirror_z is not None else upward:
        z = -z
        notes.append("z: it pointed up and is turned" if mirror_z is None else "z: turned as asked")
    side = _flange_side(y, z) if kind == "wheel" else _gauge_side(y, z)
    if side == 0 and mirror_y is None:
        notes.append("side: this rail is as good as symmetric; y is taken as it is")
    if mirror_y if mirror_y is not None else side > 0:
        y, z = -y[::-1], z[::-1]
        feature = "flange" if kind == "wheel" else "gauge side"
        notes.append(f"side: the {feature} was at large y, and y is mirrored" if mirror_y is None else "side: y is mirrored as asked")
    if kind == "wheel" and (tip := y[int(np.argmax(z))]) > -0.02:
        notes.append(f"y = 0 is not the running circle: the flange's tip is at y = {1e3 * tip:.1f} mm; `shift` moves it")
    return np.ascontiguousarray(y), np.ascontiguousarray(z)


def _flange_side(y: Array, z: Array) -> int:
    return 1 if y[int(np.argmax(z))] > 0.5 * (y.min() + y.max()) else -1


def _ascending(y: Array, z: Array) -> tuple[Array, Array]:
    order = np.argsort(y, kind="stable")
    return y[order], z[order]


def _gauge_side(y: Array, z: Array) -> int:
    """-1: the gauge side is at small y, 1: at large y, 0: the rail is symmetric. Rails lean toward the gauge side, and they wear there:
    their top lies away from it."""
    top = int(np.argmin(z))

    def reach(depth: float) -> tuple[float, ...]:
        level = z[top] + depth
        below = np.flatnonzero(z > level)
        left, right = below[below < top], below[below > top]
        if not left.size or not right.size:
            return y[0], y[-1]
        a, b = left[-1], right[0]
        return tuple(y[i] + (level - z[i]) * (y[j] - y[i]) / (z[j] - z[i]) for i, j in ((a, a + 1), (b, b - 1)))

    lowest = min(z[0], z[-1]) - z[top]
    centre = 0.5 * sum(reach(min(1e-4, 0.1 * lowest)))
    left, right = reach(min(0.014, 0.9 * lowest))
    difference = (centre - left) - (right - centre)
    return 0 if abs(difference) < 0.04 * (right - left) else -1 if difference > 0 else 1


# Writing


def write_profile(path: Union[str, os.PathLike[str]], profile: Profile) -> None:
    """Writes a profile that read_profile() reads again, in the format of the extension, in mm to the nanometre.

    .prw and .prr: SIMPACK; .whl and .ban: MiniProf; .csv: with the names y_mm, z_mm; any other: two columns.
    The flange or the gauge side is at small y, and z points down.
    """
    file = pathlib.Path(path)
    extension = file.suffix.lower()
    if _KINDS.get(extension, profile.kind) != profile.kind:
        raise ValueError(f"{file}: {extension} is a file of a {_KINDS[extension]}, and this is a {profile.kind}")
    y, z = 1e3 * np.asarray(profile.y, float), 1e3 * np.asarray(profile.z, float)
    if y.ndim != 1 or y.shape != z.shape:
        raise ValueError(f"y and z have one dimension and one size: y {y.shape}, z {z.shape}")
    comment = profile.name.replace("'", "").replace("\n", " ")
    if extension in (".prw", ".prr"):
        if profile.kind == "wheel":
            y, z = y[::-1], z[::-1]
        head = ["header.begin", "  version  = 1", f"  type     = {int(profile.kind == 'wheel')}", "header.end", "spline.begin",
                f"  comment       = '{comment}'", "  units.len.f   = 1000.", "  units.ang.f   =    1.", "  point.begin"]
        rows, tail = [f"    {a:.6f} {b:.6f}" for a, b in zip(y, z)], ["  point.end", "spline.end"]
    elif extension in (".whl", ".ban"):
        head = [f"Filename={file.name}", f"XYPoints={y.size}", "ColumnDef=X,Y", ""]
        rows, tail = [f"{a:.6f}\t{b:.6f}" for a, b in zip(y, z)], []
    elif extension == ".csv":
        head, rows, tail = ["y_mm,z_mm"], [f"{a:.6f},{b:.6f}" for a, b in zip(y, z)], []
    else:
        head, rows, tail = [f"# {profile.kind}: y and z in mm, z down {comment}".rstrip()], [f"{a:14.6f} {b:14.6f}" for a, b in zip(y, z)], []
    file.write_text("\n".join((*head, *rows, *tail)) + "\n", encoding="utf-8")
