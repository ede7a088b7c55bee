"""A wheel on a rail: from two profiles to the forces on the wheel."""

from __future__ import annotations

import ctypes
import struct
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Optional

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from ._batch import Batch
from ._calls import Elements, are_values, call, call_for_values, copy_of, memory, optional, sweep_of, zeros
from ._contacts import ContactLists, OfContacts, contacts_in
from ._group import Group
from ._inputs import Many, check, count_of, floats, is_single, number, precision
from ._library import dtype_of
from ._status import report
from .values import Friction, WheelContact, WheelPair, WheelPosition, WheelVelocity, Wrench, WrenchByPosition, WrenchDerivatives

if TYPE_CHECKING:
    from ._contact_table import ContactTable

#: The structure kstrip_table
_table = struct.Struct("PIi")


class PreparedProfile:
    """A profile of a rail or a wheel, prepared by prepare_profile() or Profile.prepare(): points at equal steps of its length.

    y, z: the points [m]. step: length between them [m]. count: their number. smoothing_length [m]: as given. single: whether they have single
    precision.
    """

    __slots__ = ("_bytes", "smoothing_length", "single")

    def __init__(self, raw: bytes, smoothing_length: float = 0.0, single: bool = False):
        self._bytes, self.smoothing_length, self.single = raw, smoothing_length, single

    def _member(self, name: str) -> Any:
        return np.frombuffer(self._bytes, dtype_of("surface", self.single))[0][name]

    @property
    def y(self) -> NDArray[np.float64]:
        points: NDArray[np.float64] = self._member("y")[: self.count]
        return points

    @property
    def z(self) -> NDArray[np.float64]:
        points: NDArray[np.float64] = self._member("z")[: self.count]
        return points

    @property
    def step(self) -> float:
        return float(self._member("step"))

    @property
    def count(self) -> int:
        return int(self._member("count"))

    def __bytes__(self) -> bytes:
        """The structure of the C library."""
        return self._bytes

    def __eq__(self, other: object) -> bool:
        return isinstance(other, PreparedProfile) and self._bytes == other._bytes and self.smoothing_length == other.smoothing_length

    def __hash__(self) -> int:
        return hash(self._bytes)

    def __repr__(self) -> str:
        spans = ", ".join(f"{name} {1e3 * v.min():.2f} to {1e3 * v.max():.2f} mm" for name, v in (("y", self.y), ("z", self.z)))
        smoothed = f", smoothing_length {1e3 * self.smoothing_length:g} mm" if self.smoothing_length else ""
        return f"PreparedProfile({self.count} points, {spans}, step {1e3 * self.step:.4f} mm{smoothed}{', single precision' * self.single})"

    def __dir__(self) -> list[str]:
        return ["y", "z", "step", "count", "smoothing_length", "single"]


def prepare_profile(y: ArrayLike, z: ArrayLike, step: float = 0.0, smoothing_length: float = 0.0,
                    dtype: DTypeLike = np.float64) -> PreparedProfile:
    """A prepared profile of a rail or a wheel from its points [m], z down, the gauge side or the flange at small y.

    y, z: the points in their order along the profile, either way. A file is read by read_profile(), which has `prepare()`.
    step: between prepared points [m]; 0: the library's choice. smoothing_length [m]: 2 to 4 mm suit measured profiles.

    >>> y = np.linspace(-12e-3, 12e-3, 241)
    >>> kstrip.prepare_profile(y, y**2 / 0.6)
    PreparedProfile(512 points, y -12.00 to 12.00 mm, z 0.00 to 0.24 mm, step 0.0470 mm)
    """
    single = precision(dtype, "prepare_profile")
    across, down = floats(y, "y", single), floats(z, "z", single)
    if across.shape != down.shape:
        raise ValueError(f"y and z have different shapes: y {across.shape}, z {down.shape}")
    made, length = zeros("surface", single), number(smoothing_length, "smoothing_length")
    call("kstrip_prepare_profile", single, across, down, count_of(across.size), number(step, "step"), length, made)
    return PreparedProfile(made.tobytes(), length, single)


def prepared(argument: str, profile: Any, single: bool) -> bytes:
    """The structure of a prepared profile."""
    if not isinstance(profile, PreparedProfile):
        how = f"{argument}.prepare() makes it of a Profile" if hasattr(profile, "prepare") else "read_profile(path).prepare() or prepare_profile(y, z) makes it"
        raise TypeError(f"{argument}: a prepared profile is needed, and this is a {type(profile).__name__}: {how}")
    if profile.single != single:
        raise TypeError(f"{argument}: it has {'single' if profile.single else 'double'} precision, and other arguments have another one")
    return profile._bytes


@dataclass(slots=True, repr=False, eq=False)
class WheelOnRail(OfContacts, Group):
    """Forces on wheels. Each member has the shape to which pair, position, velocity and friction broadcast.

    wrench: force [N], moment [N m], dissipation [W], normal_force [N], contacts, status_detail.
    derivatives: with respect to velocity and to a factor of friction.
    by_position: with respect to lateral, vertical, yaw, roll; None if it was not requested.
    contacts: of one wheel its contacts, shape (count,). Of several wheels shape (..., most contacts of a wheel): those of a wheel are its
        first `counts` ones, the others are zero.
    pair, position, velocity, friction: as they were given.
    statuses: the status of each wheel.

    creepages, wrenches, t_gamma: of each contact, in the shape of `contacts`.
    """

    wrench: Many[Wrench]
    derivatives: Many[WrenchDerivatives]
    by_position: Optional[Many[WrenchByPosition]]
    contacts: Batch[WheelContact]
    pair: Many[WheelPair]
    position: Many[WheelPosition]
    velocity: Many[WheelVelocity]
    friction: Optional[Many[Friction]]
    statuses: Any


def _elements(rail: Any, wheel: Any, on_error: str, friction: Any, **given: tuple[Any, Any]) -> tuple[Elements, list[bytes]]:
    """Elements, and rail and wheel as the C library takes them."""
    single = is_single(rail, wheel, friction, *(value for _, value in given.values()))
    profiles = [prepared("rail", rail, single), prepared("wheel", wheel, single)]
    return Elements(single, on_error, **given, friction=optional(Friction, friction)), profiles


def wheel_on_rail(rail: PreparedProfile, wheel: PreparedProfile, pair: Many[WheelPair], position: Many[WheelPosition],
                  velocity: Many[WheelVelocity], friction: Optional[Many[Friction]] = None, by_position: bool = False, contacts: bool = True,
                  on_error: str = "raise", threads: int = 1, progress: bool = False, table: Optional[ContactTable] = None) -> WheelOnRail:
    """Force and moment on wheels of prepared profiles, their derivatives and their contacts.

    rail, wheel: one each, by prepare_profile() or Profile.prepare(). pair: wheel_pair(). position: wheel_position(), whose
    `vertical` height_for_load() finds. velocity: wheel_velocity(). friction: a law of friction() that falls with the slip.
    pair, position, velocity and friction broadcast: two wheels at all positions are one call.
    by_position: also the derivatives with respect to the position. contacts: False leaves them out, for many wheels.
    on_error, threads, progress: as in solve(). table: a ContactTable of all pairs, from which the contacts come.

    >>> position = kstrip.wheel_position(lateral=-6e-3)
    >>> position.vertical = kstrip.height_for_load(rail, wheel, pair, position, 80e3)
    >>> on = kstrip.wheel_on_rail(rail, wheel, pair, position, kstrip.wheel_velocity(forward=20.0, pitch=-20.0 / 0.46))
    >>> print(f"{1e-3 * on.wrench.force[1]:.1f} kN, {len(on.contacts)} contact at {np.degrees(on.contacts[0].angle):.1f} degrees")
    -3.8 kN, 1 contact at -6.8 degrees
    >>> print(f"creepage {100 * on.creepages[0].longitudinal:.2f} %, T-gamma {on.t_gamma[0]:.0f} N")
    creepage -0.25 %, T-gamma 52 N
    """
    if on_error == "raise" and table is None and are_values(pair, position, velocity, friction) and not is_single(rail):
        return _one_wheel(rail, wheel, pair, position, velocity, friction, by_position, contacts)
    sweep = sweep_of(threads, progress)
    elements, profiles = _elements(rail, wheel, on_error, friction, pair=(WheelPair, pair), position=(WheelPosition, position),
                                   velocity=(WheelVelocity, velocity))
    wrenches, slopes = elements.out("wrench")[0], elements.out("wrench_derivatives")[0]
    moved = elements.out("wrench_by_position")[0] if by_position else None
    lists = ContactLists(elements)

    def outputs(first: int, count: int) -> list[Any]:
        arrays = [None if array is None else array.ctypes.data + first * array.itemsize for array in (wrenches, slopes, moved)]
        return [*arrays, *(lists.room(first, count) if contacts else (None, 0))]

    inputs = ["pair", "position", "velocity", "friction"]
    found = elements.run_many("kstrip_wheels_on_rails", profiles, inputs, "wheel_workspace", outputs, sweep, [structure_of(table)])
    listed = lists.batch(int(np.where(np.array(found) >= 0, wrenches["contacts"].reshape(-1), 0).max(initial=0)))
    statuses = elements.statuses(found, wrenches, slopes, moved)
    made = WheelOnRail(elements.result(Wrench, wrenches, statuses), elements.result(WrenchDerivatives, slopes, statuses),
                       None if moved is None else elements.result(WrenchByPosition, moved, statuses), listed,
                       elements.given("pair"), elements.given("position"), elements.given("velocity"), elements.given("friction"), statuses)
    return elements.report(made, statuses)


def structure_of(table: Optional[ContactTable]) -> Optional[bytes]:
    """The structure of the C library that refers to a table; the table must outlive it."""
    if table is None:
        return None
    place = ctypes.cast(ctypes.c_char_p(table.raw), ctypes.c_void_p).value
    return _table.pack(place, len(table.raw), table.only)


def _one_wheel(rail: PreparedProfile, wheel: PreparedProfile, pair: Any, position: Any, velocity: Any, friction: Any, by_position: bool,
               contacts: bool) -> WheelOnRail:
    """One wheel in double precision."""
    check(pair=(WheelPair, pair), position=(WheelPosition, position), velocity=(WheelVelocity, velocity), friction=optional(Friction, friction))
    space = memory.of("wheel_workspace", False)
    status, (wrench, slopes, moved) = call_for_values(
        "kstrip_wheel_on_rail", (prepared("rail", rail, False), prepared("wheel", wheel, False), pair, position, velocity, friction), space,
        Wrench, WrenchDerivatives, WrenchByPosition if by_position else None)
    made = WheelOnRail(wrench, slopes, moved, contacts_in(space.raw, contacts), copy_of(pair), copy_of(position), copy_of(velocity),
                       copy_of(friction), status)
    report(status)
    return made


def height_for_load(rail: PreparedProfile, wheel: PreparedProfile, pair: Many[WheelPair], position: Many[WheelPosition], support: ArrayLike,
                    velocity: Optional[Many[WheelVelocity]] = None, friction: Optional[Many[Friction]] = None, on_error: str = "raise",
                    statuses: Optional[NDArray[np.int32]] = None, threads: int = 1, progress: bool = False,
                    table: Optional[ContactTable] = None) -> Any:
    """The vertical positions [m] at which the rail supports wheels with a force [N].

    Arguments as in wheel_on_rail(); all but rail and wheel broadcast. The search begins at position's `vertical`.
    velocity: None: the pressure alone carries the load.
    on_error, threads, progress: as in solve(). statuses: an array in the shape of the results that receives the status of each.
    table: a ContactTable of all pairs, from which the contacts come.

    >>> positions = kstrip.wheel_position(lateral=[-12e-3, -10e-3, -8e-3])
    >>> positions.vertical = kstrip.height_for_load(rail, wheel, pair, positions, 80e3)
    >>> print(1e3 * positions.vertical.round(5))
    [0.29 0.23 0.1 ]
    """
    sweep = sweep_of(threads, progress)
    elements, profiles = _elements(rail, wheel, on_error, friction, pair=(WheelPair, pair), position=(WheelPosition, position),
                                   support=(float, support), velocity=optional(WheelVelocity, velocity))
    heights, _ = elements.real()
    inputs = ["pair", "position", "support", "velocity", "friction"]
    found = elements.run_many("kstrip_heights_for_loads", profiles, inputs, "wheel_workspace",
                              lambda first, _: [heights.ctypes.data + first * heights.itemsize], sweep, [structure_of(table)])
    told = elements.statuses(found, heights)
    if statuses is not None:
        statuses[...] = told
    return elements.report(elements.numbers(heights), told)
