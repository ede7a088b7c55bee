"""How a profile stands, from its shape: a wheel or a rail, z up or down, the flange or the gauge side at small or at large y.

The points are prepared first, as for a calculation: single strays are out, and scatter is smoothed. The prepared profile has flat parts,
where it rises by less than 20 degrees. The longest is the tread or the head. On either side of a flat part the profile falls, rises or ends:

* A wheel: beside the tread the flange reaches down to its tip and rises again. A roller without a flange has both edges up.
* A rail: beside a head the profile falls on both sides. A groove is a flat part that rises on both sides, and counts against a head of
  the same width only by its own width.
"""

from __future__ import annotations

import dataclasses
from typing import Optional

import numpy as np
from numpy.typing import NDArray

from ._library import dtypes, lib

Array = NDArray[np.float64]
#: Sine of the angle below which a part is flat.
_FLAT = 0.342
#: Strength of evidence, 0 to 1, below which it is weak, and from which it overrules the convention of a format.
WEAK, DECISIVE = 0.2, 0.6
#: Least depth of the sides of a rail's head [m]. A groove for a ball is less deep.
DEEP = 8e-3
#: Most points that are used.
_MOST = 500


@dataclasses.dataclass
class _Side:
    """How a profile goes on beside a flat part: z grows (1), falls (-1) or the profile ends (0)."""

    sign: int = 0
    #: height between the end of the flat part and the farthest point before the profile returns [m]
    depth: float = 0.0
    turns: bool = False
    #: y of the farthest point
    tip: float = 0.0
    #: whether another flat part follows near the height of this one
    returns: bool = False


@dataclasses.dataclass
class _Flat:
    """A flat part: its first and last point, its length along the profile, and its two sides."""

    first: int
    last: int
    length: float
    left: _Side = dataclasses.field(default_factory=_Side)
    right: _Side = dataclasses.field(default_factory=_Side)


@dataclasses.dataclass
class Evidence:
    """Evidence of one kind or of several profiles: `value` of at most `weight`, positive for yes."""

    value: float = 0.0
    weight: float = 0.0

    @property
    def strength(self) -> float:
        return abs(self.value) / self.weight if self.weight > 0 else 0.0

    def __add__(self, other: "Evidence") -> "Evidence":
        return Evidence(self.value + other.value, self.weight + other.weight)


@dataclasses.dataclass
class Shape:
    """What the shape of a profile says. `tip` is y of the flange's tip as the points stand, None without one."""

    is_wheel: Evidence
    #: of a wheel and of a rail: z points down
    wheel_down: Evidence
    rail_down: Evidence
    #: the flange, or the gauge side, is at small y; of the rail as it stands and of the rail upside down
    flange_left: Evidence
    gauge_left: tuple[Evidence, Evidence]
    #: number of heads of a rail as it stands, and upside down
    heads: tuple[int, int]
    #: depth of the sides of heads that are upside down [m]
    turned_depth: float = 0.0
    #: whether a line follows the points
    is_line: bool = True

    def __add__(self, other: "Shape") -> "Shape":
        return Shape(self.is_wheel + other.is_wheel, self.wheel_down + other.wheel_down, self.rail_down + other.rail_down,
                     self.flange_left + other.flange_left,
                     (self.gauge_left[0] + other.gauge_left[0], self.gauge_left[1] + other.gauge_left[1]),
                     (max(self.heads[0], other.heads[0]), max(self.heads[1], other.heads[1])),
                     max(self.turned_depth, other.turned_depth), self.is_line and other.is_line)


def prepared(y: Array, z: Array) -> Optional[tuple[Array, Array, Array, Array]]:
    """y, z and the direction of the profile at equal steps, without strays; None if no line follows the points."""
    surface = np.zeros((), dtypes["surface"])
    across, down = np.ascontiguousarray(y, float), np.ascontiguousarray(z, float)
    extent = float(np.hypot(np.ptp(across), np.ptp(down)))
    status = lib.kstrip_prepare_profile(across.ctypes.data, down.ctypes.data, across.size, 0.0, extent / 40.0, surface.ctypes.data)
    if status < 0:
        return None
    found = tuple(surface[name][: int(surface["count"])] for name in ("y", "z", "cosine", "sine"))
    return found  # type: ignore[return-value]


def shape_of(y: Array, z: Array) -> Shape:
    """The evidence of a profile's shape; its points [m] in their order, either way along y."""
    none = Shape(Evidence(), Evidence(), Evidence(), Evidence(), (Evidence(), Evidence()), (0, 0), is_line=False)
    # A few thousand points tell the shape
    every = 1 + y.size // _MOST
    points = prepared(_without_strays(y[::every]), _without_strays(z[::every]))
    if points is None:
        return none
    none.is_line = True
    flats = _flats(*points)
    if not flats:
        return none
    main = max(flats, key=lambda flat: flat.length)
    down = _wheel_down(main, *points[:2])
    rails = tuple(_rail_head(flats, points[0], sign * points[1], sign) for sign in (1, -1))
    return Shape(_is_wheel(main, flats, points[0]), down, _rail_down(flats, *points[:2]), _flange_left(main, 1 if down.value >= 0 else -1),
                 (rails[0][0], rails[1][0]), (rails[0][1], rails[1][1]), rails[1][2])


def _without_strays(values: Array) -> Array:
    """The running median of five, which one or two strays do not move."""
    if values.size < 20:
        return values
    middle = np.median(np.stack([values[k : values.size - 4 + k] for k in range(5)]), axis=0)
    return np.concatenate((values[:2], middle, values[-2:]))


def _flats(y: Array, z: Array, cosine: Array, sine: Array) -> list[_Flat]:
    step = float(np.hypot(np.diff(y), np.diff(z)).mean())
    level = (np.abs(sine) < _FLAT) & (cosine > 0)
    edges = np.flatnonzero(np.diff(np.concatenate(([False], level, [False])).astype(int)))
    runs = [[int(a), int(b) - 1] for a, b in zip(edges[::2], edges[1::2])]
    if not runs:
        return []
    longest = max(last - first for first, last in runs) * step
    joined = [runs[0]]
    for run in runs[1:]:
        before = joined[-1]
        # A narrow dent divides no flat part
        if (run[0] - before[1]) * step < 0.06 * longest and abs(z[run[0]] - z[before[1]]) < 0.03 * longest:
            before[1] = run[1]
        else:
            joined.append(run)
    longest = max(last - first for first, last in joined) * step
    flats = [_Flat(first, last, (last - first) * step) for first, last in joined if (last - first) * step >= 0.03 * longest]
    for number, flat in enumerate(flats):
        least = 0.05 * longest
        flat.left = _side(y[: flat.first + 1][::-1], z[: flat.first + 1][::-1], least)
        flat.right = _side(y[flat.last:], z[flat.last:], least)
        middle = z[(flat.first + flat.last) // 2]
        near = [abs(z[(f.first + f.last) // 2] - middle) < 0.3 * longest and f.length >= 0.1 * longest for f in flats]
        flat.left.returns, flat.right.returns = flat.left.turns and any(near[:number]), flat.right.turns and any(near[number + 1:])
    return flats


def _side(y: Array, z: Array, least: float) -> _Side:
    """The way of a profile from the end of a flat part, over heights of at least `least`."""
    rise = z - z[0]
    away = np.flatnonzero(np.abs(rise) > least)
    if not away.size:
        return _Side()
    sign = int(np.sign(rise[away[0]]))
    most = np.maximum.accumulate(sign * rise)
    back = np.flatnonzero(most - sign * rise > least)
    back = back[back > away[0]]
    end = int(back[0]) if back.size else rise.size
    tip = int(np.argmax(sign * rise[:end]))
    return _Side(sign, float(sign * rise[tip]), bool(back.size), float(y[tip]))


def _reach(side: _Side, length: float) -> float:
    """How far a side reaches as the flange of a tread: one with a tip counts in full."""
    return min(side.depth, 0.4 * length) * (1.0 if side.turns and not side.returns else 0.4)


def _wheel_down(tread: _Flat, y: Array, z: Array) -> Evidence:
    sides = tread.left, tread.right
    if sides[0].sign == sides[1].sign and not any(side.turns for side in sides):
        # No flange: the edges of a roller are up, and between them it is as good as flat or crowned.
        if sides[0].sign:
            depth = min(side.depth for side in sides)
            return Evidence(-sides[0].sign * depth, depth)
        return _crown(y, z, -1)
    values = [side.sign * _reach(side, tread.length) for side in sides]
    return Evidence(sum(values), sum(map(abs, values)))


def _crown(y: Array, z: Array, sign: int) -> Evidence:
    """Whether the middle of a profile is higher than its ends (sign 1), or lower (sign -1); weak where it is nearly straight."""
    half = y.size // 2
    sagitta = 0.5 * (z[0] + z[-1]) - z[half]
    return Evidence(sign * float(sagitta), max(abs(float(sagitta)), 1e-3 * float(np.ptp(y))))


def _flange_left(tread: _Flat, sign: int) -> Evidence:
    left, right = (_reach(side, tread.length) if side.sign == sign else 0.0 for side in (tread.left, tread.right))
    return Evidence(left - right, left + right)


def _rail_down(flats: list[_Flat], y: Array, z: Array) -> Evidence:
    value = sum(flat.length * 0.5 * (flat.left.sign + flat.right.sign) for flat in flats)
    weight = sum(flat.length * 0.5 * (abs(flat.left.sign) + abs(flat.right.sign)) for flat in flats)
    return Evidence(value, weight) if weight > 0 else _crown(y, z, 1)


def _rail_head(flats: list[_Flat], y: Array, z: Array, sign: int) -> tuple[Evidence, int, float]:
    """Whether the gauge side of a rail is at small y, from its head alone, the number of heads, and the depth of their sides, with z down."""
    falls = [sum(side.sign == sign for side in (flat.left, flat.right)) for flat in flats]
    longest = max(flat.length for flat in flats)
    rises = [sum(side.sign == -sign for side in (flat.left, flat.right)) for flat in flats]
    heads = [flat for flat, fall, rise in zip(flats, falls, rises) if fall and not rise and flat.length > 0.1 * longest]
    if not heads:
        return Evidence(), 0, 0.0
    head = max(heads, key=lambda flat: flat.length)
    first, last = head.first, head.last
    # Down each side, until it rises again, and at most 25 mm below the head
    while first > 0 and z[first - 1] > z[first] - 1e-4 and z[first] < z[head.first] + 0.025:
        first -= 1
    while last < z.size - 1 and z[last + 1] > z[last] - 1e-4 and z[last] < z[head.last] + 0.025:
        last += 1
    depth = max(side.depth for flat in heads for side in (flat.left, flat.right))
    return _gauge_left(y[first : last + 1], z[first : last + 1]), len(heads), depth


def _gauge_left(y: Array, z: Array) -> Evidence:
    """Rails lean toward the gauge side, and they wear there: their top lies away from it."""
    top = int(np.argmin(z))

    def reach(depth: float) -> tuple[float, float]:
        level = z[top] + depth
        below = np.flatnonzero(z > level)
        left, right = below[below < top], below[below > top]
        if not left.size or not right.size:
            return float(y[0]), float(y[-1])
        (a, b), (c, d) = (left[-1], left[-1] + 1), (right[0] - 1, right[0])
        return tuple(float(y[i] + (level - z[i]) * (y[j] - y[i]) / (z[j] - z[i])) for i, j in ((a, b), (c, d)))  # type: ignore[return-value]

    lowest = float(min(z[0], z[-1]) - z[top])
    centre = 0.5 * sum(reach(min(1e-4, 0.1 * lowest)))
    left, right = reach(min(0.014, 0.9 * lowest))
    return Evidence((centre - left) - (right - centre), 0.2 * (right - left))


def _is_wheel(main: _Flat, flats: list[_Flat], y: Array) -> Evidence:
    sides = main.left, main.right
    flanges = [side.turns and not side.returns and 0.1 * main.length < side.depth < 0.9 * main.length for side in sides]
    others = [flat for flat in flats if flat is not main and flat.length > 0.25 * main.length]
    if any(flanges) and not others:
        same = sides[0].sign == sides[1].sign
        return Evidence(1.0 if not same or all(flanges) else 0.3, 1.0)
    if others or (sides[0].sign and sides[0].sign == sides[1].sign):
        return Evidence(-1.0, 1.0)
    # One side, or none: a rail's head is at most 80 mm wide.
    return Evidence(0.1 if np.ptp(y) > 0.09 else -0.1, 1.0)
