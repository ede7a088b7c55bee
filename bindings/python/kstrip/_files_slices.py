"""Surfaces that vary along the track or around a wheel: profiles at places, and the profile between two of them."""

from __future__ import annotations

import dataclasses
import functools
import math
import pathlib
import re
from typing import Any, Optional

import numpy as np

from ._calls import call, zeros
from ._files import Path, Profile, read_series
from ._files_points import Array, ProfileError
from ._files_table import is_number
from ._group import Group
from ._inputs import number
from ._wheel import PreparedProfile, prepared

_MILLIMETRE = 1e-3


def profile_between(first: PreparedProfile, second: PreparedProfile, share: float) -> PreparedProfile:
    """The prepared profile between two slices of a switch, a crossing or a wheel with a flat; continuous in `share`.

    share: 0 at the place of the first to 1 at that of the second. Points at the same share of the length belong together, so that both
        slices must begin and end at the same features. The slope of the surface along the track is not a part of the result.

    >>> y = np.linspace(-12e-3, 12e-3, 241)
    >>> low, high = (kstrip.prepare_profile(y, y**2 / 0.6 - height) for height in (0.0, 1e-3))
    >>> print(f"{1e3 * kstrip.profile_between(low, high, 0.25).z.min():.2f} mm")
    -0.25 mm
    """
    made = zeros("surface", first.single)
    call("kstrip_profile_between", first.single, prepared("first", first, first.single), prepared("second", second, first.single),
         number(share, "share"), made)
    return PreparedProfile(made.tobytes(), max(first.smoothing_length, second.smoothing_length), first.single)


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Slices(Group):
    """Profiles of a surface that varies along the track, or around a wheel.

    places: of the profiles, ascending, shape (n,): along the track [m], or angles of the wheel [rad].
    profiles: Profile of each. around: whether the places are angles, so that the last profile is followed by the first.
    smoothing_length: with which the profiles are prepared [m].

    >>> profile = kstrip.read_profile("uic60.csv")
    >>> slices = kstrip.Slices([0.0, 0.1], [profile, profile])
    >>> slices
    Slices(2 profiles of a rail, 0 to 0.1 m)
    >>> rail = slices.at(0.03)
    """

    places: Array
    profiles: tuple[Profile, ...]
    around: bool = False
    smoothing_length: float = 0.0

    def __post_init__(self) -> None:
        places = np.array(self.places, float)
        if places.ndim != 1 or places.size != len(self.profiles) or places.size < 2 or not (np.diff(places) > 0).all():
            raise ValueError(f"places are at least two ascending numbers, one for each profile: {places.size} places, {len(self.profiles)} profiles")
        if self.around and places[-1] - places[0] >= 2 * math.pi:
            raise ValueError("the angles of a wheel lie within one turn")
        object.__setattr__(self, "places", places)
        object.__setattr__(self, "profiles", tuple(self.profiles))

    @functools.cached_property
    def _prepared(self) -> list[PreparedProfile]:
        return [profile.prepare(smoothing_length=self.smoothing_length) for profile in self.profiles]

    def at(self, place: float) -> PreparedProfile:
        """The prepared profile at a place [m], or at an angle [rad]; continuous. ValueError for a place beyond the slices."""
        where = number(place, "place")
        count = self.places.size
        if self.around:
            turn = 2 * math.pi
            where = self.places[0] + (where - self.places[0]) % turn
            ends = np.append(self.places, self.places[0] + turn)
        else:
            ends = self.places
            if not ends[0] <= where <= ends[-1]:
                raise ValueError(f"the slices reach from {ends[0]:g} to {ends[-1]:g} m, and the place is {where:g} m")
        k = int(np.clip(np.searchsorted(ends, where, side="right") - 1, 0, ends.size - 2))
        share = float(np.clip((where - ends[k]) / (ends[k + 1] - ends[k]), 0.0, 1.0))
        return profile_between(self._prepared[k], self._prepared[(k + 1) % count], share)

    def __repr__(self) -> str:
        unit = "rad" if self.around else "m"
        return f"Slices({len(self.profiles)} profiles of a {self.profiles[0].kind}, {self.places[0]:g} to {self.places[-1]:g} {unit})"


def read_slices(path: Path, *, smoothing_length: float = 0.0, **how: Any) -> Slices:
    """Reads the slices of a rail along the track (.slcs) or of a wheel around its axle (.slcw), as CONTACT has them.

    The file lists places and the names of profile files, relative to its folder. z of the profiles points down, and the gauge side or the
    flange is at small y. how: as in read_profiles(), for instance units="m". Features of the slices are not used.
    Raises ProfileError and OSError as read_profile().

    >>> lines = ["0.0 1.0", "2", "0", "0", "0.0 'uic60.csv'", "100.0 'uic60.csv'"]
    >>> np.savetxt("rail.slcs", lines, fmt="%s")
    >>> kstrip.read_slices("rail.slcs")
    Slices(2 profiles of a rail, 0 to 0.1 m)
    """
    file = pathlib.Path(path)
    around = file.suffix.lower() == ".slcw"
    places, names = _listed(file, around)
    files = [file.parent / name.replace("\\", "/") for name in names]
    kind: Optional[str] = how.pop("kind", "wheel" if around else "rail")
    profiles = read_series(files, has_convention=True, kind=kind, **how)
    try:
        return Slices(places, tuple(profiles), around, smoothing_length)
    except ValueError as error:
        raise ProfileError(file, None, str(error)) from None


def _listed(file: pathlib.Path, around: bool) -> tuple[Array, list[str]]:
    """Places [m or rad] and names of files: offset and scale, the number of slices, two lines of settings, then a line for each slice."""
    rows = []
    for line_number, line in enumerate(file.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
        text = line.split("%", 1)[0].strip()
        if text:
            rows.append((line_number, text))
    numbers = [re.split(r"[\s,]+", text) for _, text in rows[:4]]
    if len(rows) < 5 or not all(is_number(word) for row, least in zip(numbers, (2, 1, 1, 1)) for word in row[:least]) or len(numbers[0]) < 2:
        raise ProfileError(file, rows[0][0] if rows else None, "a file of slices begins with offset and scale, the number of slices, and two lines more")
    offset, scale, count = float(numbers[0][0]), float(numbers[0][1]), int(float(numbers[1][0]))
    places, names = [], []
    for line_number, text in rows[4 : 4 + max(count, 0)]:
        found = re.fullmatch(r"(\S+?)\s*,?\s*(['\"])(.+)\2.*", text)
        if found is None or not is_number(found[1]):
            raise ProfileError(file, line_number, f"a place and the name of a file in quotation marks are needed, not {text[:60]!r}")
        places.append(float(found[1]))
        names.append(found[3])
    if len(names) != count:
        raise ProfileError(file, None, f"the file promises {count} slices, and has {len(names)}")
    unit = 1.0 if around else _MILLIMETRE
    return unit * scale * (np.array(places) + offset), names

