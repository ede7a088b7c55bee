"""The wheelset: two wheels on two rails."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional, Sequence

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from ._calls import call, many, out, real
from ._inputs import Plain, broadcast, count_of, flat, floats, is_single, one, record, records
from ._library import dtypes
from ._types import (
    Curve,
    Friction,
    RailMotion,
    Surface,
    WheelPair,
    WheelPosition,
    WheelsetByPosition,
    WheelsetDerivatives,
    WheelsetForces,
    WheelVelocity,
)


def rail_motion(lateral: ArrayLike = 0.0, vertical: ArrayLike = 0.0, lateral_velocity: ArrayLike = 0.0,
                vertical_velocity: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> RailMotion:
    """Displacement [m] and velocity [m/s] of rails: irregularities of the track, or flexible rails; to the right and down."""
    made: RailMotion = record("rail_motion", dtype, lateral=lateral, vertical=vertical, lateral_velocity=lateral_velocity,
                              vertical_velocity=vertical_velocity)
    return made


def curve(speed: ArrayLike, curvature: ArrayLike = 0.0, cant: ArrayLike = 0.0, gravity: ArrayLike = 0.0,
          dtype: DTypeLike = np.float64) -> Curve:
    """A curve: speed [m/s], curvature [1/m] to the right, cant [rad] where the right rail is lower, gravity [m/s^2] (0: 9.80665)."""
    made: Curve = record("curve", dtype, speed=speed, curvature=curvature, cant=cant, gravity=gravity)
    return made


class Wheelset:
    """Two wheels on an axle, for wheelset_on_track() and wheelset_settle().

    wheel, pair: prepare_profile() and wheel_pair() of the right wheel; left_wheel, left_pair: None: as the right one.
    back_to_back: distance of the flange backs [m]; running_circles: of the running circles [m], 0: back_to_back and twice 70 mm.
    friction, left_friction: laws of friction() that fall with the slip; None: constant.
    """

    def __init__(self, wheel: Surface, pair: WheelPair, *, back_to_back: float = 0.0, running_circles: float = 0.0,
                 left_wheel: Optional[Surface] = None, left_pair: Optional[WheelPair] = None, friction: Optional[Friction] = None,
                 left_friction: Optional[Friction] = None):
        self.single = is_single(wheel, pair, left_wheel, left_pair, friction, left_friction)
        wheels = [None if each is None else one("surface", each, self.single, "wheel") for each in (wheel, left_wheel)]
        laws = [None if each is None else one("friction", each, self.single) for each in (friction, left_friction)]
        # (the structure points to them)
        self._kept = [wheels, laws]
        self.structure = np.zeros((), dtypes["wheelset" + "_f32" * self.single])
        for i in range(2):
            self.structure["wheel"][i] = _address(wheels[i])
            self.structure["friction"][i] = _address(laws[i])
        self.structure["pair"][0] = one("wheel_pair", pair, self.single, "pair")
        if left_pair is not None:
            self.structure["pair"][1] = one("wheel_pair", left_pair, self.single, "left_pair")
        self.structure["back_to_back"], self.structure["running_circles"] = float(back_to_back), float(running_circles)


class Track:
    """Two rails, for wheelset_on_track() and wheelset_settle().

    rail: prepare_profile() of the right rail; left_rail: None: as the right one. gauge: distance of the gauge faces [m], measured down
    to gauge_depth below the top [m], 0: 14 mm. origin: distances of the rails' origins from the middle of the track, right and left [m];
    0: from the gauge. motion: rail_motion() of shape (2,), right and left; None: at rest.
    """

    def __init__(self, rail: Surface, *, gauge: float = 0.0, gauge_depth: float = 0.0, origin: Sequence[float] = (0.0, 0.0),
                 left_rail: Optional[Surface] = None, motion: Optional[RailMotion] = None):
        self.single = is_single(rail, left_rail, motion)
        rails = [None if each is None else one("surface", each, self.single, "rail") for each in (rail, left_rail)]
        self._kept = rails
        self.structure = np.zeros((), dtypes["track" + "_f32" * self.single])
        for i in range(2):
            self.structure["rail"][i] = _address(rails[i])
        self.structure["gauge"], self.structure["gauge_depth"] = float(gauge), float(gauge_depth)
        if np.shape(origin) != (2,):
            raise ValueError(f"origin has two numbers, right and left, and this has the shape {np.shape(origin)}")
        self.structure["origin"] = origin
        if motion is not None:
            moves = records("rail_motion", motion, self.single)
            if moves.shape != (2,):
                raise ValueError(f"motion has two elements, right and left, and this has the shape {moves.shape}")
            self.structure["motion"] = moves


def _address(array: Optional[Plain]) -> int:
    return 0 if array is None else array.ctypes.data


def _precision(wheelset: Wheelset, track: Track) -> bool:
    if not isinstance(wheelset, Wheelset) or not isinstance(track, Track):
        raise TypeError(f"a kstrip.Wheelset and a kstrip.Track are needed, not {type(wheelset).__name__} and {type(track).__name__}")
    if wheelset.single != track.single:
        raise TypeError("wheelset and track have different precisions")
    return wheelset.single


class WheelsetOnTrack(NamedTuple):
    """What acts on wheelsets and rails. Each member has the shape to which position and velocity broadcast."""

    #: wrench on the wheelset, wheel: on the right and the left wheel, rail: forces on the rails
    forces: WheelsetForces
    #: with respect to the ten velocities and to friction; exact
    derivatives: WheelsetDerivatives
    #: with respect to the ten positions; None where not asked for
    by_position: Optional[WheelsetByPosition]


def wheelset_on_track(wheelset: Wheelset, track: Track, position: WheelPosition, velocity: WheelVelocity,
                      by_position: bool = False) -> WheelsetOnTrack:
    """Forces on a wheelset and its rails, with derivatives.

    position: wheel_position() of the wheelset's centre in the axes of the track; vertical is zero when the centre is the mean of the
    radii above the rails' origins. velocity: wheel_velocity() of the centre relative to the momentary track: curve_motion().
    position and velocity broadcast.

    >>> wheelset = kstrip.Wheelset(wheel, pair, back_to_back=1.36)
    >>> track = kstrip.Track(rail, gauge=1.435)
    >>> still = kstrip.wheelset_settle(wheelset, track, kstrip.wheel_position(lateral=3e-3), velocity, 160e3)
    >>> kstrip.wheelset_on_track(wheelset, track, still.position, still.velocity).forces.wrench
    """
    single = _precision(wheelset, track)
    places, moves = records("wheel_position", position, single), records("wheel_velocity", velocity, single)
    shape = broadcast(position=places, velocity=moves)
    forces, slopes = out("wheelset_forces", shape, single), out("wheelset_derivatives", shape, single)
    moved = out("wheelset_by_position", shape, single) if by_position else None
    memory = np.zeros((), dtypes["wheelset_workspace" + "_f32" * single])
    many("kstrip_wheelsets_on_track", single, shape, (wheelset.structure.ctypes.data, track.structure.ctypes.data),
         (flat(places, shape), flat(moves, shape)), memory, (forces, slopes, moved))
    return WheelsetOnTrack(forces[0].reshape(shape).view(WheelsetForces), slopes[0].reshape(shape).view(WheelsetDerivatives),
                           None if moved is None else moved[0].reshape(shape).view(WheelsetByPosition))


class Settled(NamedTuple):
    """Wheelsets in balance. Each member has the shape to which the inputs broadcast."""

    position: WheelPosition
    #: with the pitch rate
    velocity: WheelVelocity
    forces: WheelsetForces


def wheelset_settle(wheelset: Wheelset, track: Track, start: WheelPosition, velocity: WheelVelocity, vertical: ArrayLike,
                    roll: ArrayLike = 0.0, pitch: ArrayLike = 0.0) -> Settled:
    """Height, roll and pitch rate at which the rails carry given loads, at given lateral position, yaw and speed.

    vertical: downward force at the centre, weight included [N]. roll: moment onto the right rail [N m]. pitch: torque about the axle
    [N m], negative where it drives forward. start, velocity and loads broadcast.
    """
    single = _precision(wheelset, track)
    places, moves = records("wheel_position", start, single), records("wheel_velocity", velocity, single)
    loads = records("wheelset_loads", record("wheelset_loads", np.float32 if single else np.float64, vertical=vertical, roll=roll,
                                             pitch=pitch), single)
    shape = broadcast(start=places, velocity=moves, loads=loads)
    position, rates, forces = (out(name, shape, single) for name in ("wheel_position", "wheel_velocity", "wheelset_forces"))
    memory = np.zeros((), dtypes["wheelset_workspace" + "_f32" * single])
    many("kstrip_wheelsets_settle", single, shape, (wheelset.structure.ctypes.data, track.structure.ctypes.data),
         (flat(places, shape), flat(moves, shape), flat(loads, shape)), memory, (position, rates, forces))
    return Settled(position[0].reshape(shape).view(WheelPosition), rates[0].reshape(shape).view(WheelVelocity),
                   forces[0].reshape(shape).view(WheelsetForces))


def rolling_radius_difference(wheelset: Wheelset, track: Track, shifts: ArrayLike, with_roll: bool = False) -> NDArray[np.float64]:
    """The difference of the rolling radii, right minus left [m], at each lateral shift [m] of a wheelset without yaw.

    with_roll: False: without roll, as EN 15302 has it.
    """
    single = _precision(wheelset, track)
    given = floats(shifts, "shifts", single)
    made = np.zeros(given.shape, given.dtype)
    memory = np.zeros((), dtypes["wheelset_workspace" + "_f32" * single])
    call("kstrip_rolling_radius_difference", single, wheelset.structure, track.structure, given, count_of(given.size), int(bool(with_roll)),
         memory, made, None)
    return made


class Conicity(NamedTuple):
    """What equivalent_conicity() returns: arrays of the shape of the amplitudes."""

    conicity: NDArray[np.float64]
    #: [m]
    wave_length: NDArray[np.float64]


def equivalent_conicity(shifts: ArrayLike, differences: ArrayLike, amplitudes: ArrayLike, *, running_circles: float = 1.5,
                        wheel_radius: float = 0.46) -> Conicity:
    """Equivalent conicity after EN 15302, and the wave length [m], at amplitudes [m] of the motion.

    shifts, differences: lateral shifts [m], ascending, and rolling_radius_difference() there [m]. running_circles: their distance [m].
    """
    across, radii, wanted = (floats(v, name, False) for v, name in ((shifts, "shifts"), (differences, "differences"), (amplitudes, "amplitudes")))
    if across.shape != radii.shape:
        raise ValueError(f"shifts and differences have different shapes: shifts {across.shape}, differences {radii.shape}")
    conicities, lengths = real(wanted.shape, False)[0], real(wanted.shape, False)[0]
    call("kstrip_equivalent_conicity", False, across, radii, count_of(across.size), float(running_circles), float(wheel_radius), wanted,
         count_of(wanted.size), conicities, lengths, None)
    return Conicity(conicities.reshape(wanted.shape), lengths.reshape(wanted.shape))


def gauge_face(rail: Surface, depth: float = 0.0) -> float:
    """y of a rail's gauge face from the rail's origin [m], down to a depth below its top [m]; 0: 14 mm."""
    single = is_single(rail)
    made = np.zeros((), np.float32 if single else np.float64)
    call("kstrip_gauge_face", single, one("surface", rail, single, "rail"), float(depth), made)
    return float(made)


def curve_motion(curve: Curve, position: WheelPosition, relative: WheelVelocity) -> tuple[WheelVelocity, NDArray[np.float64]]:
    """The velocity relative to the momentary track of a body in a curve, and the weight per mass [m/s^2]: forward, lateral, vertical.

    curve: one curve(). position, relative: where the body is and how it moves in the axes that run along the curve.
    """
    single = is_single(curve, position, relative)
    velocity = np.zeros((), dtypes["wheel_velocity" + "_f32" * single])
    weight: Any = np.zeros(3, np.float32 if single else np.float64)
    call("kstrip_curve_motion", single, one("curve", curve, single), one("wheel_position", position, single, "position"),
         one("wheel_velocity", relative, single, "relative"), velocity, weight)
    return velocity.view(WheelVelocity), weight
