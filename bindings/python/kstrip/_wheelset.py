"""The wheelset: two wheels on two rails."""

from __future__ import annotations

import ctypes
import struct
from dataclasses import KW_ONLY, dataclass
from functools import cache
from itertools import repeat
from typing import TYPE_CHECKING, Any, Iterator, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._batch import Batch
from ._calls import Elements, Workspace, are_values, call, call_for_values, copy_of, memory, sweep_of
from ._contacts import KeptContacts, OfContacts, contacts_in
from ._group import Group
from ._inputs import Many, array_of, check, count_of, floats, is_many, is_single, make, number, numbers, one
from ._library import dtype_of
from ._status import report
from ._wheel import PreparedProfile, prepared, structure_of
from .values import (
    Curve,
    Friction,
    RailMotion,
    WheelContact,
    WheelPair,
    WheelPosition,
    WheelsetByPosition,
    WheelsetDerivatives,
    WheelsetForces,
    WheelVelocity,
    Wrench,
)

if TYPE_CHECKING:
    from ._contact_table import ContactTable

#: Addresses of six, and of two, structures in memory that Python keeps
_Six, _Two = ctypes.c_char_p * 6, ctypes.c_char_p * 2
#: Two, and four, numbers of either precision
_two, _four = ({single: struct.Struct(f"{count}{'f' if single else 'd'}") for single in (False, True)} for count in (2, 4))


@dataclass(slots=True, repr=False, eq=False)
class Wheelset(Group):
    """Two wheels on an axle, for wheelset_on_track() and wheelset_settle().

    wheel, pair: the prepared profile and wheel_pair() of the right wheel; left_wheel, left_pair: None: as the right one.
    back_to_back: distance of the flange backs [m]; running_circles: of the running circles [m], 0: back_to_back and twice 70 mm.
    friction, left_friction: laws of friction() that fall with the slip; None: constant.
    table, left_table: each wheel's ContactTable on its rail, which may be the same; None: contacts are computed.
    All but profiles and tables broadcast with the other arguments of a call: many coefficients of friction are many wheelsets.

    >>> kstrip.Wheelset(wheel, pair, back_to_back=1.36).back_to_back
    1.36
    """

    wheel: PreparedProfile
    pair: Many[WheelPair]
    _: KW_ONLY
    back_to_back: ArrayLike = 0.0
    running_circles: ArrayLike = 0.0
    left_wheel: Optional[PreparedProfile] = None
    left_pair: Optional[Many[WheelPair]] = None
    friction: Optional[Many[Friction]] = None
    left_friction: Optional[Many[Friction]] = None
    table: Optional[ContactTable] = None
    left_table: Optional[ContactTable] = None

    @property
    def half_distance(self) -> Any:
        """Half the distance of the running circles [m]."""
        circles, backs = (numbers(getattr(self, name), name) for name in ("running_circles", "back_to_back"))
        return 0.5 * np.where(circles, circles, backs + 0.14)[()]

    def members(self) -> dict[str, tuple[Any, Any]]:
        """Class and value of the members that broadcast."""
        kinds = {"pair": WheelPair, "left_pair": WheelPair, "friction": Friction, "left_friction": Friction, "back_to_back": float, "running_circles": float}
        return {name: (kind, getattr(self, name)) for name, kind in kinds.items()}

    def structure(self, single: bool) -> tuple[bytes, Any]:
        """The structure of the C library for one call, where members with many values are zero, and what holds the memory to which it points."""
        left = None if self.left_wheel is None else prepared("left_wheel", self.left_wheel, single)
        laws = (None if law is None or is_many(law) else one(name, Friction, law, single)
                for name, law in (("friction", self.friction), ("left_friction", self.left_friction)))
        points = _Six(prepared("wheel", self.wheel, single), left, *laws, structure_of(self.table), structure_of(self.left_table))
        pairs = (bytes(dtype_of("wheel_pair", single).itemsize) if pair is None or is_many(pair) else one(name, WheelPair, pair, single)
                 for name, pair in (("pair", self.pair), ("left_pair", self.left_pair)))
        distances = _two[single].pack(*(0.0 if is_many(value) else number(value, name)
                                        for name, value in (("back_to_back", self.back_to_back), ("running_circles", self.running_circles))))
        return b"".join((points, *pairs, distances)).ljust(dtype_of("wheelset", single).itemsize, b"\0"), points


@dataclass(slots=True, repr=False, eq=False)
class Track(Group):
    """Two rails, for wheelset_on_track() and wheelset_settle().

    rail: the prepared profile of the right rail; left_rail: None: as the right one. gauge: distance of the gauge faces [m], measured down
    to gauge_depth below the top [m], 0: 14 mm. origin: distances of the rails' origins from the middle of the track, right and left [m];
    0: from the gauge. motion: rail_motion() of shape (..., 2), right and left; None: at rest.
    gauge, gauge_depth and the dimensions of motion before the last broadcast with the other arguments of a call, so that each wheelset has
    rails of its own.

    >>> kstrip.Track(rail, gauge=1.435).gauge
    1.435
    """

    rail: PreparedProfile
    _: KW_ONLY
    gauge: ArrayLike = 0.0
    gauge_depth: ArrayLike = 0.0
    origin: Sequence[float] = (0.0, 0.0)
    left_rail: Optional[PreparedProfile] = None
    motion: Optional[Batch[RailMotion]] = None

    def members(self) -> dict[str, tuple[Any, Any]]:
        """Class and value of the members that broadcast."""
        found: dict[str, tuple[Any, Any]] = {name: (float, getattr(self, name)) for name in ("gauge", "gauge_depth")}
        if self.motion is not None and self.motion.ndim > 1:
            found |= {name: (RailMotion, self.motion[..., k]) for k, name in enumerate(("right_motion", "left_motion"))}
        return found

    def structure(self, single: bool) -> tuple[bytes, Any]:
        """The structure of the C library for one call, where members with many values are zero, and what holds the memory to which it points."""
        left = None if self.left_rail is None else prepared("left_rail", self.left_rail, single)
        points = _Two(prepared("rail", self.rail, single), left)
        if not isinstance(self.origin, (tuple, list, np.ndarray)) or len(self.origin) != 2:
            raise ValueError(f"origin: two numbers are needed, right and left, not {self.origin!r}")
        right_y, left_y = self.origin
        gauges = (0.0 if is_many(value) else number(value, name) for name, value in (("gauge", self.gauge), ("gauge_depth", self.gauge_depth)))
        places = _four[single].pack(*gauges, number(right_y, "origin"), number(left_y, "origin"))
        moves = b""
        if self.motion is not None:
            given = array_of("motion", RailMotion, self.motion, single)
            if given.shape[-1:] != (2,):
                raise ValueError(f"motion: two elements are needed in the last dimension, right and left, and this has the shape {given.shape}")
            moves = given.tobytes() if given.ndim == 1 else b""
        return b"".join((points, places, moves)).ljust(dtype_of("track", single).itemsize, b"\0"), points


@cache
def _wheels_at(single: bool) -> tuple[int, int]:
    """Where the workspace of a wheelset has those of the right and the left wheel [bytes]."""
    wheel, begin = dict(dtype_of("wheelset_workspace", single).fields or {})["wheel"][:2]
    return begin, begin + wheel.base.itemsize


def _structures(wheelset: Any, track: Any) -> tuple[bool, tuple[Any, Any], Any]:
    """Precision, both structures as columns of a call, and what holds their memory."""
    for name, kind, value in (("wheelset", Wheelset, wheelset), ("track", Track, track)):
        if not isinstance(value, kind):
            raise TypeError(f"{name}: a kstrip.{kind.__name__} is needed, not {type(value).__name__}")
    single = is_single(wheelset.wheel, track.rail)
    (first, kept), (second, also) = wheelset.structure(single), track.structure(single)
    return single, (repeat(first), repeat(second)), (kept, also)


#: Where a member that broadcasts is in the structures: its member, and its place there
_PLACES = {"pair": ("pair", 0), "left_pair": ("pair", 1), "friction": ("friction", 0), "left_friction": ("friction", 1), "right_motion": ("motion", 0),
           "left_motion": ("motion", 1)}


def _many(*parts: Any) -> dict[str, tuple[Any, Any]]:
    """The members of wheelset and track that have many values, as arguments that broadcast."""
    return {name: member for part in parts for name, member in part.members().items() if is_many(member[1])}


def _each(elements: Elements, structure: str, given: Any, first: Iterator[bytes]) -> Iterator[Any]:
    """The structure of each element: the same one, with the members of the element."""
    names = _many(given)
    if not names:
        return first
    made: Any = np.frombuffer(next(first), dtype_of(structure, elements.single)).repeat(elements.count)
    for name, (kind, _) in names.items():
        array, distance = elements.array(name)
        member, k = _PLACES.get(name, (name, ...))
        made[member][:, k] = array.ctypes.data + distance * np.arange(elements.count) if kind is Friction else array
    # The generator keeps the structures as long as their addresses are used
    return (made.ctypes.data + k * made.itemsize for k in range(elements.count))


@dataclass(slots=True, repr=False, eq=False)
class WheelOfWheelset(OfContacts, Group):
    """One wheel of a wheelset on a track.

    wrench: force on the wheel [N], moment about its centre [N m], dissipation [W], normal_force [N], contacts, status_detail.
    contacts, creepages, wrenches, t_gamma: of each contact, as in wheel_on_rail().
    pair, friction: of the wheelset. velocity: of this wheel relative to its rail.
    """

    wrench: Many[Wrench]
    contacts: Batch[WheelContact]
    pair: Many[WheelPair]
    velocity: Many[WheelVelocity]
    friction: Optional[Many[Friction]]


@dataclass(slots=True, repr=False, eq=False)
class WheelsetOnTrack(Group):
    """Forces on wheelsets and rails. Each member has the shape to which position and velocity broadcast.

    forces: wrench on the wheelset, wheel: on the right and the left wheel, rail: forces on the rails.
    derivatives: with respect to the ten velocities and to friction.
    by_position: with respect to the ten positions; None if it was not requested.
    contacts: of the right and of the left wheel.
    wheelset, track, position, velocity: as they were given.
    statuses: the status of each wheelset.

    right, left: each wheel with its contacts, their creepages and T-gamma.
    """

    forces: Many[WheelsetForces]
    derivatives: Many[WheelsetDerivatives]
    by_position: Optional[Many[WheelsetByPosition]]
    contacts: tuple[Batch[WheelContact], Batch[WheelContact]]
    wheelset: Wheelset
    track: Track
    position: Many[WheelPosition]
    velocity: Many[WheelVelocity]
    statuses: Any

    @property
    def right(self) -> WheelOfWheelset:
        """The right wheel."""
        return self._wheel(0, 1.0, self.wheelset.pair, self.wheelset.friction)

    @property
    def left(self) -> WheelOfWheelset:
        """The left wheel."""
        pair = self.wheelset.pair if self.wheelset.left_pair is None else self.wheelset.left_pair
        return self._wheel(1, -1.0, pair, self.wheelset.left_friction)

    def _wheel(self, number: int, side: float, pair: Many[WheelPair], friction: Optional[Many[Friction]]) -> WheelOfWheelset:
        return WheelOfWheelset(self.forces.wheel[..., number], self.contacts[number], pair, self._velocity(number, side), friction)

    def _velocity(self, number: int, side: float) -> Any:
        """The velocity of a wheel's centre relative to its rail: that of the wheelset's centre and that of its turning."""
        at, moves, arm = self.position, self.velocity, side * self.wheelset.half_distance
        rail = None if self.track.motion is None else self.track.motion[..., number]
        # Components along the wheelset's own x and z, which roll turns about x and then yaw about z
        along, down = -arm * np.asarray(moves.yaw), arm * np.asarray(moves.roll)
        roll, yaw = np.asarray(at.roll), np.asarray(at.yaw)
        return make(WheelVelocity, np.float64, forward=moves.forward + along * np.cos(yaw),
                    lateral=moves.lateral + along * np.cos(roll) * np.sin(yaw) - down * np.sin(roll) - (0.0 if rail is None else rail.lateral_velocity),
                    vertical=moves.vertical + along * np.sin(roll) * np.sin(yaw) + down * np.cos(roll) - (0.0 if rail is None else rail.vertical_velocity),
                    roll=moves.roll, pitch=moves.pitch, yaw=moves.yaw)


def wheelset_on_track(wheelset: Wheelset, track: Track, position: Many[WheelPosition], velocity: Many[WheelVelocity], by_position: bool = False,
                      contacts: bool = True, on_error: str = "raise", threads: int = 1, progress: bool = False) -> WheelsetOnTrack:
    """Forces on a wheelset and its rails, with derivatives and the contacts of both wheels.

    position: wheel_position() of the wheelset's centre in the axes of the track; vertical is zero when the centre is the mean of the
    radii above the rails' origins. velocity: wheel_velocity() of the centre relative to the momentary track: curve_motion().
    position, velocity and the members of wheelset and track broadcast.
    by_position: also the derivatives with respect to the position. contacts: False leaves them out. on_error, threads, progress: as in solve().

    >>> wheelset, track = kstrip.Wheelset(wheel, pair, back_to_back=1.36), kstrip.Track(rail, gauge=1.435)
    >>> still = kstrip.wheelset_settle(wheelset, track, kstrip.wheel_position(lateral=3e-3), velocity, 160e3)
    >>> on = kstrip.wheelset_on_track(wheelset, track, still.position, still.velocity)
    >>> print(f"Y {1e-3 * on.forces.rail[0, 1]:.1f} kN and {1e-3 * on.forces.rail[1, 1]:.1f} kN")
    Y 1.8 kN and -0.2 kN
    >>> print(f"T-gamma of the right wheel {on.right.t_gamma.sum():.0f} N")
    T-gamma of the right wheel 15 N
    """
    single, structures, kept = _structures(wheelset, track)
    sweep, many = sweep_of(threads, progress), _many(wheelset, track)
    if on_error == "raise" and are_values(position, velocity) and not single and not many:
        return _one_wheelset(wheelset, track, [next(each) for each in structures], position, velocity, by_position, contacts)
    elements = Elements(single, on_error, position=(WheelPosition, position), velocity=(WheelVelocity, velocity), **many)
    (forces, first), (slopes, second) = elements.out("wheelset_forces"), elements.out("wheelset_derivatives")
    moved, third = elements.out("wheelset_by_position") if by_position else (None, repeat(None))
    right, left = (KeptContacts(single, at) for at in _wheels_at(single))
    found = elements.run("kstrip_wheelset_on_track", _each(elements, "wheelset", wheelset, structures[0]), _each(elements, "track", track, structures[1]),
                         elements.columns["position"], elements.columns["velocity"], Workspace("wheelset_workspace"), first, second, third,
                         kept=[right, left] if contacts else [], sweep=sweep)
    del kept
    statuses = elements.statuses(found, forces, slopes, moved)
    made = WheelsetOnTrack(elements.result(WheelsetForces, forces, statuses), elements.result(WheelsetDerivatives, slopes, statuses),
                           None if moved is None else elements.result(WheelsetByPosition, moved, statuses),
                           (right.batch(elements), left.batch(elements)),
                           wheelset._copy(), track._copy(), elements.given("position"), elements.given("velocity"), statuses)
    return elements.report(made, statuses)


def _one_wheelset(wheelset: Wheelset, track: Track, structures: list[bytes], position: Any, velocity: Any, by_position: bool,
                  contacts: bool) -> WheelsetOnTrack:
    """One wheelset in double precision."""
    check(position=(WheelPosition, position), velocity=(WheelVelocity, velocity))
    space = memory.of("wheelset_workspace", False)
    status, (forces, slopes, moved) = call_for_values("kstrip_wheelset_on_track", (*structures, position, velocity), space, WheelsetForces,
                                                      WheelsetDerivatives, WheelsetByPosition if by_position else None)
    right, left = (contacts_in(space.raw, contacts, at) for at in _wheels_at(False))
    made = WheelsetOnTrack(forces, slopes, moved, (right, left), wheelset._copy(), track._copy(), copy_of(position), copy_of(velocity), status)
    report(status)
    return made


@dataclass(slots=True, repr=False, eq=False)
class Settled(Group):
    """Wheelsets in balance. Each member has the shape to which the inputs broadcast.

    position: with height and roll. velocity: with the pitch rate. forces: there. statuses: the status of each wheelset.
    """

    position: Many[WheelPosition]
    velocity: Many[WheelVelocity]
    forces: Many[WheelsetForces]
    statuses: Any


def wheelset_settle(wheelset: Wheelset, track: Track, start: Many[WheelPosition], velocity: Many[WheelVelocity], vertical: ArrayLike,
                    roll: ArrayLike = 0.0, pitch: ArrayLike = 0.0, on_error: str = "raise", threads: int = 1, progress: bool = False) -> Settled:
    """Height, roll and pitch rate at which the rails carry given loads, at given lateral position, yaw and speed.

    vertical: downward force at the centre, weight included [N]. roll: moment onto the right rail [N m]. pitch: torque about the axle
    [N m], negative where it drives forward. start, velocity, loads and the members of wheelset and track broadcast.
    on_error, threads, progress: as in solve().

    >>> wheelset, track = kstrip.Wheelset(wheel, pair, back_to_back=1.36), kstrip.Track(rail, gauge=1.435)
    >>> starts = kstrip.wheel_position(lateral=np.linspace(-3e-3, 3e-3, 5))
    >>> still = kstrip.wheelset_settle(wheelset, track, starts, velocity, 160e3)
    >>> print(1e-3 * still.forces.rail[:, 0, 2].round(-2))
    [78.3 78.9 80.  81.1 81.7]
    """
    single, structures, kept = _structures(wheelset, track)
    sweep = sweep_of(threads, progress)
    elements = Elements(single, on_error, start=(WheelPosition, start), velocity=(WheelVelocity, velocity), vertical=(float, vertical),
                        roll=(float, roll), pitch=(float, pitch), **_many(wheelset, track))
    (positions, first), (rates, second), (forces, third) = (elements.out(name) for name in ("wheel_position", "wheel_velocity", "wheelset_forces"))
    loads = map(struct.Struct("3f" if single else "3d").pack, *(elements.columns[name] for name in ("vertical", "roll", "pitch")))
    found = elements.run("kstrip_wheelset_settle", _each(elements, "wheelset", wheelset, structures[0]), _each(elements, "track", track, structures[1]),
                         elements.columns["start"], elements.columns["velocity"], loads, Workspace("wheelset_workspace"), first, second, third, sweep=sweep)
    del kept
    statuses = elements.statuses(found, positions, rates, forces)
    made = Settled(elements.result(WheelPosition, positions, statuses), elements.result(WheelVelocity, rates, statuses),
                   elements.result(WheelsetForces, forces, statuses), statuses)
    return elements.report(made, statuses)


def rolling_radius_difference(wheelset: Wheelset, track: Track, shifts: ArrayLike, with_roll: bool = False, on_error: str = "raise",
                              statuses: Optional[NDArray[np.int32]] = None, threads: int = 1, progress: bool = False) -> Any:
    """The difference of the rolling radii, right minus left [m], at each lateral shift [m] of a wheelset without yaw.

    with_roll: False: without roll, as EN 15302 has it. shifts and the members of wheelset and track broadcast.
    on_error, threads, progress: as in solve(). statuses: an array in the shape of the results that receives the status of each.

    >>> wheelset, track = kstrip.Wheelset(wheel, pair, back_to_back=1.36), kstrip.Track(rail, gauge=1.435)
    >>> print(1e3 * kstrip.rolling_radius_difference(wheelset, track, [-3e-3, 0.0, 3e-3]).round(5))
    [-0.97  0.    0.97]
    """
    single, structures, kept = _structures(wheelset, track)
    sweep = sweep_of(threads, progress)
    elements = Elements(single, on_error, shifts=(float, shifts), **_many(wheelset, track))
    differences, places = elements.real()
    given = map(struct.Struct("f" if single else "d").pack, elements.columns["shifts"])
    found = elements.run("kstrip_rolling_radius_difference", _each(elements, "wheelset", wheelset, structures[0]), _each(elements, "track", track, structures[1]),
                         given, repeat(1), repeat(int(bool(with_roll))), Workspace("wheelset_workspace"), places, repeat(None), sweep=sweep)
    del kept
    told = elements.statuses(found, differences)
    if statuses is not None:
        statuses[...] = told
    return elements.report(elements.numbers(differences), told)


@dataclass(slots=True, repr=False, eq=False)
class Conicity(Group):
    """Result of equivalent_conicity(): arrays in the shape of the amplitudes.

    conicity: [-]; 0: the wheelset does not steer. wave_length: [m]; infinite if the conicity is 0. statuses: of each amplitude.
    """

    conicity: Any
    wave_length: Any
    statuses: Any


def equivalent_conicity(shifts: ArrayLike, differences: ArrayLike, amplitudes: ArrayLike, *, running_circles: float = 1.5,
                        wheel_radius: float = 0.46, on_error: str = "raise") -> Conicity:
    """Equivalent conicity after EN 15302, and the wave length [m], at amplitudes [m] of the motion.

    shifts, differences: lateral shifts [m], ascending, and rolling_radius_difference() there [m]. running_circles: their distance [m].
    on_error: "raise" or "nan", as in solve().

    >>> shifts = np.linspace(-8e-3, 8e-3, 161)
    >>> found = kstrip.equivalent_conicity(shifts, 0.1 * shifts, [1e-3, 3e-3])          # a cone of 1:20
    >>> found.conicity.round(4), found.wave_length.round(2)
    (array([0.05, 0.05]), array([16.5, 16.5]))
    """
    across, radii = floats(shifts, "shifts"), floats(differences, "differences")
    if across.shape != radii.shape:
        raise ValueError(f"shifts and differences have different shapes: shifts {across.shape}, differences {radii.shape}")
    elements = Elements(False, on_error, amplitudes=(float, amplitudes))
    (conicities, first), (lengths, second) = elements.real(), elements.real()
    shared = across.ctypes.data, radii.ctypes.data, count_of(across.size), number(running_circles, "running_circles"), number(wheel_radius, "wheel_radius")
    found = elements.run("kstrip_equivalent_conicity", *map(repeat, shared), map(struct.Struct("d").pack, elements.columns["amplitudes"]), repeat(1),
                         first, second, repeat(None))
    statuses = elements.statuses(found, conicities, lengths)
    return elements.report(Conicity(elements.numbers(conicities), elements.numbers(lengths), statuses), statuses)


def gauge_face(rail: PreparedProfile, depth: float = 0.0) -> float:
    """y of a rail's gauge face from the rail's origin [m], down to a depth below its top [m]; 0: 14 mm.

    >>> round(kstrip.gauge_face(rail), 4)
    -0.043
    """
    single = is_single(rail)
    made = np.zeros((), np.float32 if single else np.float64)
    call("kstrip_gauge_face", single, prepared("rail", rail, single), number(depth, "depth"), made)
    return float(made)


def curve_motion(curve: Many[Curve], position: Many[WheelPosition], relative: Many[WheelVelocity], on_error: str = "raise") -> tuple[Any, NDArray[np.float64]]:
    """The velocity relative to the momentary track of a body in a curve, and the weight per mass [m/s^2]: forward, lateral, vertical.

    curve: of curve(). position, relative: where the body is and how it moves in the axes that run along the curve. All broadcast; the
    weights have the shape (..., 3).

    >>> rest = kstrip.wheel_velocity(forward=0.0, pitch=-47.8)
    >>> moves, weight = kstrip.curve_motion(kstrip.curve(22.0, 1 / 300.0), kstrip.wheel_position(lateral=0.0), rest)
    >>> print(f"yaw rate {moves.yaw:.4f} rad/s, weight to the left {-weight[1]:.2f} m/s^2")
    yaw rate 0.0733 rad/s, weight to the left 1.61 m/s^2
    """
    elements = Elements(is_single(curve, position, relative), on_error, curve=(Curve, curve), position=(WheelPosition, position),
                        relative=(WheelVelocity, relative))
    velocities, first = elements.out("wheel_velocity")
    weights: Any = np.zeros((*elements.shape, 3), np.float32 if elements.single else np.float64)
    begin = weights.ctypes.data
    found = elements.run("kstrip_curve_motion", *elements.columns.values(), first, range(begin, begin + weights.nbytes, 3 * weights.itemsize))
    statuses = elements.statuses(found, velocities)
    weights[np.asarray(statuses) < 0] = np.nan
    return elements.report((elements.result(WheelVelocity, velocities, statuses), weights), statuses)
