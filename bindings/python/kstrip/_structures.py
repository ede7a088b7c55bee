"""Values from numbers, and batches of values from arrays that broadcast."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, DTypeLike

from ._inputs import Model, choice, make, numbers
from ._value import friction_places as places_of
from .values import Contact, Creepage, Curve, Friction, Motion, Parameters, PatchStrip, Radii, RailMotion, Velocity, WheelPair, WheelPosition, WheelVelocity


def contact(*, a: ArrayLike, b: ArrayLike, normal_force: ArrayLike, shear_modulus: ArrayLike, poisson_ratio: ArrayLike,
            friction: ArrayLike, mismatch: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Any:
    """An elliptic contact; many contacts from arrays of any shape that broadcast.

    a, b: semi-axes along and across the rolling direction [m].
    normal_force: load [N]; 0 or less: the contact is lost.
    shear_modulus, poisson_ratio: combined G [Pa] and nu [-] of both bodies: combine().
    friction: coefficient of friction [-].
    mismatch: of the materials [-]: combine(); 0 for like ones.
    dtype: np.float64, or np.float32 for a batch in single precision.

    >>> kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    Contact(a=0.006 m, b=0.0045 m, normal_force=80000 N, shear_modulus=8.2e+10 Pa, poisson_ratio=0.28, friction=0.3, mismatch=0)
    """
    return make(Contact, dtype, a=a, b=b, normal_force=normal_force, shear_modulus=shear_modulus, poisson_ratio=poisson_ratio,
                friction=friction, mismatch=mismatch)


def creepage(longitudinal: ArrayLike = 0.0, lateral: ArrayLike = 0.0, spin: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Any:
    """Creepages [-, -] and spin [1/m] of the upper body relative to the lower body; numbers and arrays broadcast.

    >>> kstrip.creepage(1e-3, spin=0.1)
    Creepage(longitudinal=0.001, lateral=0, spin=0.1 1/m)
    >>> kstrip.creepage(np.linspace(0.0, 0.01, 200)).shape
    (200,)
    """
    return make(Creepage, dtype, longitudinal=longitudinal, lateral=lateral, spin=spin)


def friction(friction: ArrayLike, ratio: ArrayLike = 1.0, decay: ArrayLike = 0.0, rolling_speed: ArrayLike = 0.0,
             slope_factor: ArrayLike = 1.0, slide_factor: ArrayLike = 0.0, layer: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Any:
    """A law of falling friction; numbers and arrays broadcast.

    friction: coefficient of friction without slip [-].
    ratio: friction at infinite sliding velocity, divided by that without slip [-], 0 to 1.
    decay: how fast friction falls [s/m].
    rolling_speed: [m/s]; sliding velocity is slip times rolling speed.
    slope_factor: initial slope of the creep curve, divided by that of clean bodies [-], 0 to 1.
    slide_factor: stretch of the curve far in sliding, divided by that at its start [-], 0 to 1; 0 stands for 1.
    layer: thickness of a layer between the bodies, divided by its shear modulus [m/Pa].

    >>> kstrip.friction(0.3, 0.4, 0.6, rolling_speed=20.0)
    Friction(friction=0.3, ratio=0.4, decay=0.6 s/m, rolling_speed=20 m/s, slope_factor=1, slide_factor=0, layer=0 m/Pa)
    """
    return make(Friction, dtype, friction=friction, ratio=ratio, decay=decay, rolling_speed=rolling_speed, slope_factor=slope_factor,
                slide_factor=slide_factor, layer=layer)


def motion(slip_x: ArrayLike = 0.0, slip_y: ArrayLike = 0.0, spin_rate: ArrayLike = 0.0, rolling_speed: ArrayLike = 0.0,
           floor_speed: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Any:
    """How the upper body moves relative to the lower body, for solve_motion(); numbers and arrays broadcast.

    slip_x, slip_y: velocities [m/s]. spin_rate: [rad/s]. rolling_speed: signed [m/s].
    floor_speed: creepages are slip divided by sqrt(rolling_speed^2 + floor_speed^2) [m/s]; 0 stands for 0.02.

    >>> kstrip.motion(slip_x=1e-3, rolling_speed=-5.0)
    Motion(slip_x=0.001 m/s, slip_y=0 m/s, spin_rate=0 rad/s, rolling_speed=-5 m/s, floor_speed=0 m/s)
    """
    return make(Motion, dtype, slip_x=slip_x, slip_y=slip_y, spin_rate=spin_rate, rolling_speed=rolling_speed, floor_speed=floor_speed)


def radii(lower_x: ArrayLike = np.inf, lower_y: ArrayLike = np.inf, upper_x: ArrayLike = np.inf, upper_y: ArrayLike = np.inf,
          dtype: DTypeLike = np.float64) -> Any:
    """Radii of curvature [m]: convex positive, flat infinite, concave negative; numbers and arrays broadcast.

    A wheel of 0.46 m on a rail head of 0.3 m:

    >>> kstrip.radii(lower_y=0.3, upper_x=0.46)
    Radii(lower_x=inf m, lower_y=0.3 m, upper_x=0.46 m, upper_y=inf m)
    """
    return make(Radii, dtype, lower_x=lower_x, lower_y=lower_y, upper_x=upper_x, upper_y=upper_y)


def velocity(x: ArrayLike = 0.0, y: ArrayLike = 0.0, angular_z: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Any:
    """Velocity of a body's material at the contact [m/s, m/s, rad/s], for creepage_from_velocities().

    >>> kstrip.velocity(x=-20.0)
    Velocity(x=-20 m/s, y=0 m/s, angular_z=0 rad/s)
    """
    return make(Velocity, dtype, x=x, y=y, angular_z=angular_z)


def parameters(xi: ArrayLike = 0.0, eta: ArrayLike = 0.0, psi: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Any:
    """Kalker's dimensionless parameters (5.13), for creepage_from_parameters().

    >>> kstrip.parameters(xi=0.5)
    Parameters(xi=0.5, eta=0, psi=0)
    """
    return make(Parameters, dtype, xi=xi, eta=eta, psi=psi)


def patch_strip(*, y: ArrayLike, width: ArrayLike, half_length: ArrayLike, peak_pressure: ArrayLike, friction: ArrayLike,
                centre_x: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Any:
    """Strips of a patch of any shape, for patch_from_strips(): y, width, half_length [m], peak_pressure [Pa], friction [-], centre_x [m].

    >>> kstrip.patch_strip(y=[-1e-3, 0.0, 1e-3], width=1e-3, half_length=5e-3, peak_pressure=800e6, friction=0.3).y
    array([-0.001,  0.   ,  0.001])
    """
    return make(PatchStrip, dtype, y=y, width=width, half_length=half_length, centre_x=centre_x, peak_pressure=peak_pressure, friction=friction)


def wheel_pair(*, wheel_radius: ArrayLike, shear_modulus: ArrayLike, poisson_ratio: ArrayLike, friction: ArrayLike = 0.0,
               friction_places: Optional[ArrayLike] = None, left: ArrayLike = False, smoothing_length: ArrayLike = 0.0, strips: int = 0,
               model: Model = "default", normal_damping: ArrayLike = 0.0, floor_speed: ArrayLike = 0.0, rail_radius: ArrayLike = 0.0,
               rail_ahead: ArrayLike = 0.0, rail_speed: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Any:
    """Materials, side and friction of a wheel and a rail; numbers and arrays broadcast.

    wheel_radius: at z = 0 of its profile [m]. shear_modulus [Pa], poisson_ratio [-]: combined constants of both bodies.
    friction: coefficient of friction [-]. friction_places: instead of it up to four pairs (y on the rail [m], coefficient of friction),
        linear between them, for all pairs.
    left: whether it is a left wheel; the profiles are always those of a right one. normal_damping: of the pressure [s/m].
    smoothing_length: of the undeformed gap [m]. strips, model: as in solve(), for all pairs.
    floor_speed: of the speed by which slip is divided [m/s]; 0: 0.02.
    rail_radius: of a roller [m]; 0: a straight rail; its axis is rail_ahead [m] ahead of the wheel's centre, and its surface moves backward
        with rail_speed [m/s].

    >>> steel = dict(wheel_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28)
    >>> kstrip.wheel_pair(**steel, friction=np.linspace(0.1, 0.4, 7)).shape
    (7,)
    >>> kstrip.wheel_pair(**steel, friction_places=[(-0.02, 0.1), (0.0, 0.3)]).friction_places
    array([[-0.02,  0.1 ],
           [ 0.  ,  0.3 ]])
    """
    chosen, count = choice(model, strips)
    y, at, points = places_of(() if friction_places is None else friction_places)
    if points and np.any(friction):
        raise ValueError("friction and friction_places: one of them is needed, not both")
    shared = {"friction_y": y, "friction_at": at, "friction_points": points, "strips": count, "model": chosen}
    return make(WheelPair, dtype, shared, wheel_radius=wheel_radius, shear_modulus=shear_modulus, poisson_ratio=poisson_ratio, friction=friction,
                left=int(left) if isinstance(left, bool) else numbers(left, "wheel_pair.left").astype(int), smoothing_length=smoothing_length,
                normal_damping=normal_damping, floor_speed=floor_speed, rail_radius=rail_radius, rail_ahead=rail_ahead, rail_speed=rail_speed)


def wheel_position(*, lateral: ArrayLike, vertical: ArrayLike = 0.0, yaw: ArrayLike = 0.0, roll: ArrayLike = 0.0,
                   dtype: DTypeLike = np.float64) -> Any:
    """Where a wheel's centre is relative to the rail [m, m, rad, rad]; numbers and arrays broadcast.

    `vertical` is zero when the centre is one wheel radius above the rail's origin; positive downward.

    >>> kstrip.wheel_position(lateral=-10e-3)
    WheelPosition(lateral=-0.01 m, vertical=0 m, yaw=0 rad, roll=0 rad)
    """
    return make(WheelPosition, dtype, lateral=lateral, vertical=vertical, yaw=yaw, roll=roll)


def wheel_velocity(*, forward: ArrayLike, pitch: ArrayLike, lateral: ArrayLike = 0.0, vertical: ArrayLike = 0.0, roll: ArrayLike = 0.0,
                   yaw: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Any:
    """How a wheel moves relative to the rail [m/s; rad/s about its wheelset's own axes]; numbers and arrays broadcast.

    `pitch` is about -forward/radius.

    >>> kstrip.wheel_velocity(forward=20.0, pitch=-20.0 / 0.46).pitch
    -43.47826086956522
    """
    return make(WheelVelocity, dtype, forward=forward, lateral=lateral, vertical=vertical, roll=roll, pitch=pitch, yaw=yaw)


def rail_motion(lateral: ArrayLike = 0.0, vertical: ArrayLike = 0.0, lateral_velocity: ArrayLike = 0.0,
                vertical_velocity: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Any:
    """Displacement [m] and velocity [m/s] of a rail, to the right and down: irregularities of the track, or flexible rails.

    >>> kstrip.rail_motion(vertical=[1e-3, 0.0]).vertical
    array([0.001, 0.   ])
    """
    return make(RailMotion, dtype, lateral=lateral, vertical=vertical, lateral_velocity=lateral_velocity, vertical_velocity=vertical_velocity)


def curve(speed: ArrayLike, curvature: ArrayLike = 0.0, cant: ArrayLike = 0.0, gravity: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Any:
    """A curve: speed [m/s], curvature [1/m] to the right, cant [rad] where the right rail is lower, gravity [m/s^2] (0: 9.80665).

    >>> kstrip.curve(22.0, 1 / 300.0, cant=0.1)
    Curve(speed=22 m/s, curvature=0.00333333333 1/m, cant=0.1 rad, gravity=0 m/s^2)
    """
    return make(Curve, dtype, speed=speed, curvature=curvature, cant=cant, gravity=gravity)
