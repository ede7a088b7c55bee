"""A wheel on a rail: from two profiles to the forces on the wheel."""

from __future__ import annotations

from typing import Any, Callable, Iterable, NamedTuple, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from ._calls import PART, Strided, call, lazy, many, out, real, size_of
from ._inputs import Model, Plain, Shape, broadcast, count_of, flat, floats, is_single, one, options, record, records
from ._library import constants, dtypes
from ._types import Friction, Surface, WheelContact, WheelPair, WheelPosition, WheelVelocity, Wrench, WrenchByPosition, WrenchDerivatives


def prepare_profile(y: ArrayLike, z: ArrayLike, step: float = 0.0, smoothing_length: float = 0.0,
                    dtype: DTypeLike = np.float64) -> Surface:
    """A prepared profile of a rail or a wheel from its points [m], z down, the gauge side or the flange at small y.

    y, z: the points in their order along the profile, either way. A file is read by read_profile(), which has `prepare()`.
    step: between prepared points [m]; 0: the library's choice. smoothing_length [m]: 2 to 4 mm suit measured profiles.
    """
    single = np.dtype(dtype) == np.float32
    across, down = floats(y, "y", single), floats(z, "z", single)
    if across.shape != down.shape:
        raise ValueError(f"y and z have different shapes: y {across.shape}, z {down.shape}")
    made = np.zeros((), dtypes["surface" + "_f32" * single])
    call("kstrip_prepare_profile", single, across, down, count_of(across.size), float(step), float(smoothing_length), made)
    return made.view(Surface)


def wheel_pair(*, wheel_radius: ArrayLike, shear_modulus: ArrayLike, poisson_ratio: ArrayLike,
               friction: Union[ArrayLike, Sequence[tuple[float, float]]] = 0.0, left: ArrayLike = False,
               smoothing_length: ArrayLike = 0.0, strips: int = 0, model: Model = "default",
               normal_damping: ArrayLike = 0.0, floor_speed: ArrayLike = 0.0, rail_radius: ArrayLike = 0.0,
               rail_ahead: ArrayLike = 0.0, rail_speed: ArrayLike = 0.0,
               dtype: DTypeLike = np.float64) -> WheelPair:
    """Materials, side and friction of a wheel and a rail; numbers and arrays broadcast.

    wheel_radius: at z = 0 of its profile [m]. shear_modulus [Pa], poisson_ratio [-]: combined constants of both bodies.
    friction: one number, or up to four pairs (y on the rail [m], coefficient), linear between them.
    left: whether it is a left wheel; the profiles are always those of a right one. normal_damping: of the pressure [s/m].
    floor_speed: of the speed by which slip is divided [m/s]; 0: 0.02. rail_radius: of a roller [m]; 0: a straight rail; its axis is
    rail_ahead [m] ahead of the wheel's centre, and its surface moves backward with rail_speed [m/s].
    """
    places = np.asarray(friction, float) if np.ndim(friction) else np.zeros((0, 2))
    room = constants["KSTRIP_RAIL_FRICTION_CAPACITY"]
    if places.ndim != 2 or places.shape[1] != 2 or len(places) > room:
        raise ValueError(f"friction is one number, or up to {room} pairs of y and friction; this has the shape {places.shape}")
    chosen = options(model, strips)
    made: WheelPair = record("wheel_pair", dtype, wheel_radius=wheel_radius, shear_modulus=shear_modulus, poisson_ratio=poisson_ratio,
                             friction=0.0 if len(places) else friction, friction_points=len(places),
                             left=np.asarray(left, bool).astype(int), smoothing_length=smoothing_length, strips=chosen.strips,
                             model=chosen.model, normal_damping=normal_damping, floor_speed=floor_speed,
                             rail_radius=rail_radius, rail_ahead=rail_ahead, rail_speed=rail_speed)
    made["friction_y"][..., : len(places)], made["friction_at"][..., : len(places)] = places.T
    return made


def wheel_position(*, lateral: ArrayLike, vertical: ArrayLike = 0.0, yaw: ArrayLike = 0.0, roll: ArrayLike = 0.0,
                   dtype: DTypeLike = np.float64) -> WheelPosition:
    """Where a wheel's centre is over the rail [m, m, rad, rad]; numbers and arrays broadcast.

    `vertical` is zero when the centre is one wheel radius above the rail's origin; positive downward.
    """
    made: WheelPosition = record("wheel_position", dtype, lateral=lateral, vertical=vertical, yaw=yaw, roll=roll)
    return made


def wheel_velocity(*, forward: ArrayLike, pitch: ArrayLike, lateral: ArrayLike = 0.0, vertical: ArrayLike = 0.0,
                   roll: ArrayLike = 0.0, yaw: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> WheelVelocity:
    """How a wheel moves over the rail [m/s; rad/s about its wheelset's own axes]; numbers and arrays broadcast.

    `pitch` is about -forward/radius.
    """
    made: WheelVelocity = record("wheel_velocity", dtype, forward=forward, lateral=lateral, vertical=vertical, roll=roll,
                                 pitch=pitch, yaw=yaw)
    return made


class WheelOnRail(NamedTuple):
    """What acts on wheels. Each member has the shape to which pair, position, velocity and friction broadcast."""

    #: force [N], moment [N m], dissipation [W], normal_force [N], contacts, status_detail
    wrench: Wrench
    #: with respect to velocity and to a factor of friction; exact
    derivatives: WrenchDerivatives
    #: with respect to lateral, vertical, yaw, roll: None where not asked for
    by_position: Optional[WrenchByPosition]
    #: of one wheel its contacts, shape (count,). Of several wheels shape (..., most contacts of a wheel); unused ones are zero.
    contacts: WheelContact


class _Wheels:
    """The inputs of many wheels: prepared profiles, and records that broadcast."""

    def __init__(self, rail: Any, wheel: Any, law: Any, support: Any = None, **given: Any):
        self.single = is_single(rail, wheel, law, *given.values())
        self.profiles = one("surface", rail, self.single, "rail"), one("surface", wheel, self.single, "wheel")
        kinds = {"friction": "friction", **{name: f"wheel_{name}" for name in given}}
        found: dict[str, Optional[Plain]] = {name: None if value is None else records(kinds[name], value, self.single)
                                             for name, value in (*given.items(), ("friction", law))}
        found["support"] = None if support is None else floats(support, "support", self.single)
        self.shape: Shape = broadcast(**found)
        self.flats = {name: None if value is None else flat(value, self.shape) for name, value in found.items()}
        self.memory = np.zeros((), dtypes["wheel_workspace" + "_f32" * self.single])

    def call(self, name: str, inputs: Iterable[str], outputs: Iterable[Optional[Strided]], to: Sequence[Any] = (),
             after: Optional[Callable[[int, int], None]] = None) -> None:
        profiles = [profile.ctypes.data for profile in self.profiles]
        many(name, self.single, self.shape, profiles, [self.flats[each] for each in inputs], self.memory, outputs, to, after)


def wheel_on_rail(rail: Surface, wheel: Surface, pair: WheelPair, position: WheelPosition, velocity: WheelVelocity,
                  friction: Optional[Friction] = None, by_position: bool = False, contacts: bool = True) -> WheelOnRail:
    """Force and moment on wheels of prepared profiles, their derivatives and their contacts.

    rail, wheel: one each, by prepare_profile() or Profile.prepare(). pair: wheel_pair(). position: wheel_position(), whose
    `vertical` height_for_load() finds. velocity: wheel_velocity(). friction: a law of friction() that falls with the slip.
    pair, position, velocity and friction broadcast: two wheels at all positions are one call.
    by_position: also the derivatives with respect to the position. contacts: False leaves them out, for many wheels.

    >>> wheels = kstrip.wheel_on_rail(rail, wheel, pair, kstrip.wheel_position(lateral=shifts, vertical=heights), velocity)
    >>> wheels.wrench.force[..., 1]                     # lateral force on the wheel [N] at each shift
    """
    wheels = _Wheels(rail, wheel, friction, pair=pair, position=position, velocity=velocity)
    single, shape = wheels.single, wheels.shape
    wrench, slopes = out("wrench", shape, single), out("wrench_derivatives", shape, single)
    moved = out("wrench_by_position", shape, single) if by_position else None
    room = constants["KSTRIP_CONTACTS_CAPACITY"] if contacts else 0
    of_contact = wheels.memory.dtype["contacts"].base
    # (numpy copies memory faster than structures)
    met: Plain = np.zeros((PART, room), np.dtype((np.void, of_contact.itemsize)))
    kept: Plain = np.zeros((size_of(shape), 0), met.dtype)

    def keep(first: int, size: int) -> None:
        nonlocal kept
        counts = wrench[0]["contacts"][first : first + size]
        most = int(counts.max(initial=0))
        if most > kept.shape[1]:
            before, kept = kept, lazy((len(kept), most), met.dtype)
            kept[:first, : before.shape[1]] = before[:first]
        for number in range(most):
            has = counts > number
            if has.all():
                kept[first : first + size, number] = met[:size, number]
            else:
                kept[first : first + size, number][has] = met[:size, number][has]

    wheels.call("kstrip_wheels_on_rails", ("pair", "position", "velocity", "friction"), (wrench, slopes, moved),
                (met.ctypes.data if contacts else None, room), keep if contacts else None)
    return WheelOnRail(wrench[0].reshape(shape).view(Wrench), slopes[0].reshape(shape).view(WrenchDerivatives),
                       None if moved is None else moved[0].reshape(shape).view(WrenchByPosition),
                       kept.view(of_contact).reshape((*shape, kept.shape[1])).view(WheelContact))


def height_for_load(rail: Surface, wheel: Surface, pair: WheelPair, position: WheelPosition, support: ArrayLike,
                    velocity: Optional[WheelVelocity] = None, friction: Optional[Friction] = None) -> NDArray[np.float64]:
    """The vertical positions [m] at which the rail supports wheels with a force [N].

    Arguments as in wheel_on_rail(); all but rail and wheel broadcast. The search begins at position's `vertical`.
    velocity: None: the pressure alone carries the load.

    >>> position.vertical = kstrip.height_for_load(rail, wheel, pair, position, 80e3)
    """
    wheels = _Wheels(rail, wheel, friction, support, pair=pair, position=position, velocity=velocity)
    heights = real(wheels.shape, wheels.single)
    wheels.call("kstrip_heights_for_loads", ("pair", "position", "support", "velocity", "friction"), (heights,))
    found: NDArray[np.float64] = heights[0].reshape(wheels.shape)[()]
    return found
