"""Profile files: reading them the right way round, and writing them."""

from __future__ import annotations

import dataclasses
import os
import pathlib
import warnings
from typing import Iterable, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, DTypeLike

from ._files_formats import kind_of_extension, read_points
from ._files_points import UNITS, Array, Points, ProfileError, ProfileWarning, Wanted
from ._files_table import as_missing
from ._group import Group
from ._library import constants, lib
from ._status import text_of
from ._wheel import PreparedProfile, prepare_profile

Path = Union[str, "os.PathLike[str]"]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Profile(Group):
    """The points of a wheel's or a rail's profile as the library takes them.

    y, z: in metres, shape (n,), toward larger y, z down; the flange of a wheel and the gauge side of a rail are at small y.
    kind: "wheel" or "rail". name: that of the file. notes: contents of the file and changes, a sentence each.
    source: the path of the file.
    """

    y: Array
    z: Array
    kind: str
    name: str = ""
    notes: tuple[str, ...] = ()
    source: str = ""

    def prepare(self, step: float = 0.0, smoothing_length: float = 0.0, dtype: DTypeLike = np.float64) -> PreparedProfile:
        """prepare_profile() of the points; smoothing_length [m]: 2 to 4 mm suit measured profiles."""
        return prepare_profile(self.y, self.z, step, smoothing_length, dtype)

    def __repr__(self) -> str:
        span = ", ".join(f"{name} {1e3 * v.min():.2f} to {1e3 * v.max():.2f} mm" for name, v in (("y", self.y), ("z", self.z)))
        return "\n  ".join((f"Profile of a {self.kind}, {self.y.size} points, {span}{self.name and f' ({self.name})'}", *self.notes))


def read_profile(path: Path, *, kind: Optional[str] = None, units: Union[str, float, None] = None,
                 mirror_y: Optional[bool] = None, mirror_z: Optional[bool] = None, shift: Sequence[float] = (0.0, 0.0),
                 columns: Optional[Sequence[Union[int, str]]] = None, skip: int = 0,
                 missing: Union[None, str, float, Sequence[Union[str, float]]] = None, decimal: Optional[str] = None) -> Profile:
    """Reads a profile file: a wheel or a rail the right way round, in metres.

    Formats: SIMPACK and CONTACT (.prw, .prr), MiniProf (.whl, .ban, .mpt), Vampire (.whe, .rai), DXF (with the package ezdxf), JSON
    with y and z, and tables of text and CSV. The convention of the format decides the directions of y and z. If it has none, or `kind`
    contradicts it, the shape of the tread or of the head decides. `notes` list findings and changes.

    kind: "wheel" or "rail"; None: from header, extension or shape.
    units: of the file: "mm", "m", "cm", "in" or metres per unit; None: from header, size or shape.
    mirror_y, mirror_z: whether to change the signs of the file's y and z; None: by convention or shape. The gauge side of a rail is the
        one farther from its top; of a symmetric rail y stays as it is.
    shift: added at the end [m, m]. y = 0 of a wheel is its running circle, z = 0 the height of its nominal radius.
    columns: the columns of y and z in a table, as numbers from 0 or as names; None: the columns that are named y and z, or the only two.
    skip: number of lines before a table. missing: a value or several, such as -9999 or "NaN", whose lines are left out.
    decimal: "." or ","; None: found from the table.
    Raises ProfileError with file and line for what cannot be read, OSError for a file that is not there. Warns with ProfileWarning if the
    evidence is weak, or if the shape contradicts the file.

    >>> profile = kstrip.read_profile("s1002.csv")
    >>> profile.kind, profile.y.shape, profile.notes[-1]
    ('wheel', (399,), 'wheel, by its shape')
    >>> wheel = profile.prepare()
    """
    wanted = _wanted(kind, units, columns, skip, missing, decimal)
    return _profiles([_points(path, wanted)], kind, units, mirror_y, mirror_z, shift, 3)[0]


def read_profiles(paths: Iterable[Path], *, kind: Optional[str] = None, units: Union[str, float, None] = None,
                  mirror_y: Optional[bool] = None, mirror_z: Optional[bool] = None, shift: Sequence[float] = (0.0, 0.0),
                  columns: Optional[Sequence[Union[int, str]]] = None, skip: int = 0,
                  missing: Union[None, str, float, Sequence[Union[str, float]]] = None, decimal: Optional[str] = None) -> list[Profile]:
    """Reads a series of files of one kind, such as the slices of a crossing or one wheel on many dates.

    As read_profile(), but units, kind, side and direction of z are decided once, from all of them together.

    >>> len(kstrip.read_profiles(sorted(pathlib.Path(".").glob("uic60*.csv")), kind="rail"))
    1
    """
    return read_series(paths, False, kind, units, mirror_y, mirror_z, shift, columns, skip, missing, decimal)


def read_series(paths: Iterable[Path], has_convention: bool, kind: Optional[str] = None, units: Union[str, float, None] = None,
                mirror_y: Optional[bool] = None, mirror_z: Optional[bool] = None, shift: Sequence[float] = (0.0, 0.0),
                columns: Optional[Sequence[Union[int, str]]] = None, skip: int = 0,
                missing: Union[None, str, float, Sequence[Union[str, float]]] = None, decimal: Optional[str] = None) -> list[Profile]:
    """read_profiles(); with has_convention the list of the files says that z points down and the flange or the gauge side is at small y."""
    wanted = _wanted(kind, units, columns, skip, missing, decimal)
    series = [_points(path, wanted) for path in paths]
    for found in series:
        found.has_convention |= has_convention
    return _profiles(series, kind, units, mirror_y, mirror_z, shift, 4)


def oriented(y: ArrayLike, z: ArrayLike, *, kind: Optional[str] = None, mirror_y: Optional[bool] = None,
             mirror_z: Optional[bool] = None, name: str = "") -> Profile:
    """A profile from arrays [m], in their order along the profile, the right way round by the shape of its tread or head.

    As read_profile() of a table. `notes` lists what was changed.

    >>> y = np.linspace(-0.03, 0.03, 61)
    >>> kstrip.oriented(y, -(y**2) / 0.06, kind="rail").z.max().round(5)
    np.float64(0.015)
    """
    _wanted(kind, None, None, 0, None, None)
    across, down = np.array(y, float), np.array(z, float)
    if across.ndim != 1 or across.shape != down.shape:
        raise ValueError(f"y and z have one dimension and one size: y {across.shape}, z {down.shape}")
    found = Points(pathlib.Path(name or "arrays"), "arrays", across, down, unit=1.0, unit_source="of arrays")
    _check(found)
    made = _profiles([found], kind, None, mirror_y, mirror_z, (0.0, 0.0), 3)[0]
    return dataclasses.replace(made, name=name, source="")


def _wanted(kind: Optional[str], units: Union[str, float, None], columns: Optional[Sequence[Union[int, str]]], skip: int,
            missing: Union[None, str, float, Sequence[Union[str, float]]], decimal: Optional[str]) -> Wanted:
    """The arguments, checked."""
    if kind not in (None, "wheel", "rail"):
        raise ValueError(f"kind is 'wheel', 'rail' or None, not {kind!r}")
    if isinstance(units, str) and units not in UNITS:
        raise ValueError(f"units are one of {', '.join(UNITS)} or metres per unit, not {units!r}")
    if units is not None and not isinstance(units, str) and not (0 < float(units) < np.inf):
        raise ValueError(f"metres per unit must be positive, not {units!r}")
    if columns is not None and (isinstance(columns, str) or len(columns) != 2):
        raise ValueError(f"columns are two numbers from 0, or two names, not {columns!r}")
    if decimal not in (None, ".", ","):
        raise ValueError(f"decimal is '.' or ',', not {decimal!r}")
    if skip < 0:
        raise ValueError(f"skip is a number of lines, not {skip!r}")
    return Wanted(None if columns is None else (columns[0], columns[1]), int(skip), as_missing(missing), decimal)


def _points(path: Path, wanted: Wanted) -> Points:
    file = pathlib.Path(path)
    found = read_points(file, file.read_bytes(), wanted)
    _check(found)
    return found


def _check(found: Points) -> None:
    if found.y.size < 4:
        raise found.error(None, f"a profile needs 4 points, and this file has {found.y.size}")
    bad = ~(np.isfinite(found.y) & np.isfinite(found.z))
    if bad.any():
        raise found.error(found.line_of(int(np.argmax(bad))), "a coordinate is not a finite number")
    if max(np.abs(found.y).max(), np.abs(found.z).max()) > 1e12:
        raise found.error(None, "a coordinate is larger than 1e12")


# What the points are


def _profiles(series: list[Points], kind: Optional[str], units: Union[str, float, None], mirror_y: Optional[bool], mirror_z: Optional[bool],
              shift: Sequence[float], depth: int) -> list[Profile]:
    """Profiles of a series of files; units, kind and direction are decided once. Warnings are those of the caller at a depth."""
    by_shape = _unit_by_shape(series, units)
    points, told = [], []
    for found in series:
        notes = [f"{found.format}, {found.y.size} points", *found.notes]
        unit = _unit(units, found, by_shape, notes)
        y, z = _of_header(found, found.y * unit, found.z * unit, notes)
        y, z = _head_of_outline(found, kind, y, z, notes)
        keep = np.concatenate(([True], np.hypot(np.diff(y), np.diff(z)) > 1e-9))
        if np.count_nonzero(keep) < 4:
            raise found.error(None, f"a profile needs 4 points, and this file has {np.count_nonzero(keep)} at different places")
        if not keep.all():
            notes.append(f"{np.count_nonzero(~keep)} points that coincide with the one before them are left out")
        points.append((y[keep], z[keep]))
        told.append((notes, list(found.warnings)))
    if not series:
        return []
    kinds = [_kind(kind, found, *lists) for found, lists in zip(series, told)]
    common = kinds[0][0] if len({kind for kind, _ in kinds}) == 1 else None
    has_convention = all(holds for _, holds in kinds)
    asked = _Asked(common, has_convention, mirror_y, mirror_z, (float(shift[0]), float(shift[1])), len(series) > 1)
    mirrored = [(-y if mirror_y else y, -z if mirror_z else z) for y, z in points]
    turned, bits, _ = _orient(series, mirrored, asked.format(all(found.from_flange_back for found in series)))
    made = []
    for found, before, after, (notes, doubts) in zip(series, points, turned, told):
        _tell(asked, bits, before, after, notes, doubts)
        y, z = after[0] + asked.shift[0], after[1] + asked.shift[1]
        if any(shift):
            notes.append(f"moved by {1e3 * shift[0]:g} mm in y and {1e3 * shift[1]:g} mm in z, as asked")
        notes.extend(doubt for doubt in doubts if doubt not in notes)
        made.append(Profile(y, z, "wheel" if bits & _bit("WHEEL") else "rail", found.path.name, tuple(notes), str(found.path)))
        for doubt in doubts:
            warnings.warn(f"{found.path}: {doubt}", ProfileWarning, stacklevel=depth)
    return made


@dataclasses.dataclass(frozen=True)
class _Asked:
    """What is known of points without their shape."""

    kind: Optional[str]
    has_convention: bool
    mirror_y: Optional[bool]
    mirror_z: Optional[bool]
    shift: tuple[float, float]
    is_series: bool

    def format(self, from_flange_back: bool) -> int:
        """The same as a format of kstrip_orient_profiles()."""
        names = ["SIMPACK" if self.has_convention else "MINIPROF" if from_flange_back else "ANY"]
        names += [] if self.kind is None else [self.kind.upper()]
        names += ["Z_DOWN"] * (self.mirror_z is not None) + ["SIDE"] * (self.mirror_y is not None)
        return sum(constants[f"KSTRIP_FORMAT_{name}"] for name in names)


def _bit(name: str) -> int:
    return constants[f"KSTRIP_NOTE_{name}"]


def _orient(series: list[Points], points: list[tuple[Array, Array]], form: int, unit: float = 1.0) -> tuple[list[tuple[Array, Array]], int, float]:
    """The points of profiles the right way round, notes, and the unit, which is found if it is 0."""
    counts = np.array([y.size for y, _ in points], np.uint32)
    y, z = (np.concatenate([pair[k] for pair in points]) for k in (0, 1))
    turned = np.zeros((2, y.size))
    units, notes = np.zeros(1), np.zeros(1, np.uint32)
    status = lib.kstrip_orient_profiles(y.ctypes.data, z.ctypes.data, counts.ctypes.data, counts.size, form, unit, turned[0].ctypes.data,
                                        turned[1].ctypes.data, units.ctypes.data, notes.ctypes.data)
    if status < 0:
        raise series[0].error(None, f"{text_of(status)}; units= says what the numbers are")
    return list(zip(*(np.split(row, np.cumsum(counts)[:-1]) for row in turned))), int(notes[0]), float(units[0])


def _unit_by_shape(series: list[Points], units: Union[str, float, None]) -> tuple[float, float, bool]:
    """Metres per unit of the files that name none, from size and shape of all of them; their width, and whether that is a doubt."""
    unknown = [found for found in series if units is None and found.unit is None]
    if not unknown:
        return 1.0, 0.0, False
    width = float(max(max(np.ptp(found.y), np.ptp(found.z)) for found in unknown))
    _, notes, unit = _orient(unknown, [(found.y, found.z) for found in unknown], constants["KSTRIP_FORMAT_ANY"], 0.0)
    return unit, width, bool(notes & _bit("DOUBT_UNIT"))


def _unit(asked: Union[str, float, None], found: Points, by_shape: tuple[float, float, bool], notes: list[str]) -> float:
    """Metres per unit."""
    unit, width, is_doubtful = by_shape
    source = f"by the width of {width:g}"
    if asked is not None:
        unit, source, is_doubtful = UNITS[asked] if isinstance(asked, str) else float(asked), "as asked", False
    elif found.unit is not None:
        unit, source, is_doubtful = found.unit, found.unit_source, False
    name = next((name for name, factor in UNITS.items() if np.isclose(factor, unit, rtol=1e-12)), f"{unit:g} m")
    notes.append(f"units: {name}, {source}")
    if is_doubtful:
        taken = "inches" if name == "in" else name
        found.warnings.append(f"the units are taken as {taken}, by the width of {width:g} and the shape; units= says what they are")
    return unit


def _of_header(found: Points, y: Array, z: Array, notes: list[str]) -> tuple[Array, Array]:
    """Shift, turn and mirrors that a file requests."""
    if any(found.shift) or found.turn or any(found.mirror):
        notes.append(f"the header's shift ({found.shift[0]:g}, {found.shift[1]:g}) m, turn {found.turn:g} rad and mirrors {found.mirror} are applied")
    y, z = y + found.shift[0], z + found.shift[1]
    cosine, sine = np.cos(found.turn), np.sin(found.turn)
    y, z = cosine * y - sine * z, sine * y + cosine * z
    return -y if found.mirror[0] else y, -z if found.mirror[1] else z


def _head_of_outline(found: Points, kind: Optional[str], y: Array, z: Array, notes: list[str]) -> tuple[Array, Array]:
    """The head of a rail whose outline is closed: the end that is narrower near its top, as far as it widens."""
    height = float(np.ptp(z))
    is_closed = np.hypot(y[0] - y[-1], z[0] - z[-1]) < 0.02 * height and height > 0.25 * float(np.ptp(y)) and y.size > 8
    if not is_closed or (kind or found.kind) == "wheel":
        return y, z
    near = 0.03 * height
    widths = {sign: np.ptp(y[sign * z <= np.min(sign * z) + near]) for sign in (1, -1)}
    sign = min(widths, key=lambda s: float(widths[s]))
    # Begin at the other end, so that the head is in one piece
    start = int(np.argmax(sign * z))
    y, z = np.roll(y[:-1] if y[0] == y[-1] and z[0] == z[-1] else y, -start), np.roll(z[:-1] if y[0] == y[-1] and z[0] == z[-1] else z, -start)
    top = int(np.argmin(sign * z))
    left = right = top
    for step in (1, -1):
        at, farthest = top, top
        direction = np.sign(y[(top + 3 * step) % y.size] - y[top]) or 1.0
        while 0 < at < y.size - 1:
            at += step
            if direction * (y[at] - y[farthest]) >= -1e-6:
                farthest = at
            elif direction * (y[farthest] - y[at]) > 1e-3 or sign * (z[at] - z[top]) > 0.5 * height:
                break
        left, right = (left, farthest) if step > 0 else (farthest, right)
    notes.append(f"the outline is closed: {right - left + 1} points of its head are taken")
    return y[left : right + 1], z[left : right + 1]


def _kind(asked: Optional[str], found: Points, notes: list[str], doubts: list[str]) -> tuple[Optional[str], bool]:
    """Wheel or rail, None if the shape decides, and whether the convention of the format holds for it."""
    extension = found.path.suffix.lower()
    by_extension = kind_of_extension(extension)
    said = found.kind or by_extension
    if asked is not None:
        if said not in (None, asked):
            doubts.append(f"{asked}, as asked, but the file is that of a {said}: the shape says how it stands")
        notes.append(f"{asked}, as asked")
        return asked, found.has_convention and said in (None, asked)
    if found.kind is not None and by_extension not in (None, found.kind):
        doubts.append(f"the header says {found.kind} and the extension {by_extension}: its shape decides; kind= says which")
        return None, False
    if said is not None:
        notes.append(f"{said}, {found.kind_source if found.kind else f'by its extension {extension}'}")
    return said, found.has_convention


def _tell(asked: _Asked, bits: int, before: tuple[Array, Array], after: tuple[Array, Array], notes: list[str], doubts: list[str]) -> None:
    """What the library found and changed, in sentences."""
    kind = "wheel" if bits & _bit("WHEEL") else "rail"
    if asked.kind is None:
        notes.append(f"{kind}, by its shape")
    if bits & _bit("DOUBT_KIND"):
        doubts.append(f"the shape hardly says whether this is a wheel or a rail; taken as a {kind}, and kind= says which")
    _tell_z(asked, bits, notes, doubts)
    _tell_side(asked, bits, kind, notes, doubts)
    if before[0][0] > before[0][-1]:
        notes.append("order: the points ran toward smaller y and are reversed")
    if asked.is_series:
        notes.append("kind, side and direction of z are those of the series")
    across, down = (float(np.mean(new) - sign * np.mean(old)) for new, old, sign in (
        (after[0], before[0], -1 if asked.mirror_y or bits & _bit("Y_MIRRORED") else 1),
        (after[1], before[1], -1 if asked.mirror_z or bits & _bit("Z_TURNED") else 1)))
    tip = float(after[0][int(np.argmax(after[1]))])
    if bits & _bit("RUNNING_CIRCLE") and across < -0.01:
        notes.append(f"y = 0 was the flange back: moved by {1e3 * across:g} mm to the running circle, and z by {1e3 * down:.3f} mm to zero there")
    elif bits & _bit("DOUBT_ORIGIN") and tip > -0.02:
        message = f"y = 0 is not the running circle: the flange's tip is at y = {1e3 * tip:.1f} mm; `shift` moves it"
        (notes if any(asked.shift) else doubts).append(message)
    if bits & _bit("DOUBT_POINTS"):
        doubts.append("no line follows the points: they scatter, turn back or belong to two profiles")


def _tell_z(asked: _Asked, bits: int, notes: list[str], doubts: list[str]) -> None:
    if asked.mirror_z:
        notes.append("z: turned as asked")
    elif bits & _bit("Z_TURNED"):
        notes.append("z: it pointed up and is turned")
        if bits & _bit("DOUBT_Z"):
            doubts.append(f"z points up by the shape, {'against the format' if asked.has_convention else 'which is weak'}; mirror_z=False keeps it")
    elif asked.has_convention and asked.mirror_z is None:
        notes.append("z: down, by the format")
    elif bits & _bit("DOUBT_Z"):
        doubts.append("the shape hardly says whether z points down; it is taken as it stands, and mirror_z= says which")


def _tell_side(asked: _Asked, bits: int, kind: str, notes: list[str], doubts: list[str]) -> None:
    feature = "flange" if kind == "wheel" else "gauge side"
    has_convention = asked.has_convention and not bits & _bit("Z_TURNED")
    if asked.mirror_y:
        notes.append("side: y is mirrored as asked")
    elif bits & _bit("Y_MIRRORED"):
        notes.append(f"side: the {feature} was at large y, and y is mirrored")
        if has_convention:
            doubts.append(f"the {feature} is at large y, against the format; mirror_y=False keeps it")
    elif has_convention and asked.mirror_y is None:
        notes.append(f"side: the {feature} is at small y, by the format")
    elif bits & _bit("DOUBT_SIDE"):
        why = "the head is as good as symmetric, and there is another beside it" if bits & _bit("SYMMETRIC") else "this rail has more than one head"
        doubts.append(f"side: {why}; y is taken as it is, and mirror_y= says which")
    elif bits & _bit("SYMMETRIC"):
        notes.append(f"side: {'there is no flange' if kind == 'wheel' else 'this rail is as good as symmetric'}; y is taken as it is")


# Writing


def write_profile(path: Union[str, os.PathLike[str]], profile: Profile) -> None:
    """Writes a profile that read_profile() reads again, in the format of the extension, in mm to the nanometre.

    .prw and .prr: SIMPACK; .whl and .ban: MiniProf; .csv: with the names y_mm, z_mm; any other: two columns.
    The flange or the gauge side is at small y, and z points down. A .whl file has the y of the profile, and `Origin=running circle` in its
    header; instruments have y = 0 at the flange back.

    >>> kstrip.write_profile("s1002.prw", kstrip.read_profile("s1002.csv"))
    >>> kstrip.read_profile("s1002.prw").notes[0]
    'SIMPACK profile, 399 points'
    """
    file = pathlib.Path(path)
    extension = file.suffix.lower()
    by_extension = kind_of_extension(extension)
    if by_extension not in (None, profile.kind):
        raise ValueError(f"{file}: {extension} is a file of a {by_extension}, and this is a {profile.kind}")
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
        head = [f"Filename={file.name}", f"XYPoints={y.size}", "ColumnDef=X,Y", *(["Origin=running circle"] if profile.kind == "wheel" else []), ""]
        rows, tail = [f"{a:.6f}\t{b:.6f}" for a, b in zip(y, z)], []
    elif extension == ".csv":
        head, rows, tail = ["y_mm,z_mm"], [f"{a:.6f},{b:.6f}" for a, b in zip(y, z)], []
    else:
        head, rows, tail = [f"# {profile.kind}: y and z in mm, z down {comment}".rstrip()], [f"{a:14.6f} {b:14.6f}" for a, b in zip(y, z)], []
    file.write_text("\n".join((*head, *rows, *tail)) + "\n", encoding="utf-8")
