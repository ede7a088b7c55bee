"""Structures from numbers and arrays that broadcast."""

from __future__ import annotations


import numpy as np
from numpy.typing import ArrayLike, DTypeLike

from ._inputs import record
from ._types import Contact, Creepage, Friction, Motion, Parameters, PatchStrip, Radii, Velocity


def contact(*, a: ArrayLike, b: ArrayLike, normal_force: ArrayLike, shear_modulus: ArrayLike, poisson_ratio: ArrayLike,
            friction: ArrayLike, mismatch: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Contact:
    """Elliptic contacts, from numbers and arrays of any shape that broadcast.

    a, b: semi-axes along and across the rolling direction [m].
    normal_force: load [N]; 0 or less: the contact is lost.
    shear_modulus, poisson_ratio: combined G [Pa] and nu [-] of both bodies: combine().
    friction: coefficient of friction [-].
    mismatch: of the materials [-]: combine(); 0 for like ones.
    dtype: np.float64, or np.float32 for single precision.

    >>> kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    Contact(a=0.006 m, b=0.0045 m, normal_force=80000 N, shear_modulus=8.2e+10 Pa, poisson_ratio=0.28, friction=0.3, mismatch=0)
    """
    made: Contact = record("contact", dtype, a=a, b=b, normal_force=normal_force, shear_modulus=shear_modulus,
                           poisson_ratio=poisson_ratio, friction=friction, mismatch=mismatch)
    return made


def creepage(longitudinal: ArrayLike = 0.0, lateral: ArrayLike = 0.0, spin: ArrayLike = 0.0,
             dtype: DTypeLike = np.float64) -> Creepage:
    """Creepages [-, -] and spin [1/m] of the upper over the lower body; numbers and arrays broadcast.

    >>> kstrip.creepage(1e-3, spin=0.1)
    Creepage(longitudinal=0.001, lateral=0, spin=0.1 1/m)
    """
    made: Creepage = record("creepage", dtype, longitudinal=longitudinal, lateral=lateral, spin=spin)
    return made


def friction(friction: ArrayLike, ratio: ArrayLike = 1.0, decay: ArrayLike = 0.0, rolling_speed: ArrayLike = 0.0,
             slope_factor: ArrayLike = 1.0, slide_factor: ArrayLike = 0.0, layer: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Friction:
    """A law of friction that falls with the slip; numbers and arrays broadcast.

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
    made: Friction = record("friction", dtype, friction=friction, ratio=ratio, decay=decay, rolling_speed=rolling_speed,
                            slope_factor=slope_factor, slide_factor=slide_factor, layer=layer)
    return made


def motion(slip_x: ArrayLike = 0.0, slip_y: ArrayLike = 0.0, spin_rate: ArrayLike = 0.0, rolling_speed: ArrayLike = 0.0,
           floor_speed: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Motion:
    """How the upper body moves over the lower one, for solve_motion(); numbers and arrays broadcast.

    slip_x, slip_y: velocities [m/s]. spin_rate: [rad/s]. rolling_speed: signed [m/s].
    floor_speed: creepages are slip over sqrt(rolling_speed^2 + floor_speed^2) [m/s]; 0 stands for 0.02.
    """
    made: Motion = record("motion", dtype, slip_x=slip_x, slip_y=slip_y, spin_rate=spin_rate, rolling_speed=rolling_speed,
                          floor_speed=floor_speed)
    return made


def radii(lower_x: ArrayLike = np.inf, lower_y: ArrayLike = np.inf, upper_x: ArrayLike = np.inf,
          upper_y: ArrayLike = np.inf, dtype: DTypeLike = np.float64) -> Radii:
    """Radii of curvature [m]: convex positive, flat infinite, concave negative; numbers and arrays broadcast.

    A wheel of 0.46 m on a rail head of 0.3 m: `kstrip.radii(lower_y=0.3, upper_x=0.46)`.
    """
    made: Radii = record("radii", dtype, lower_x=lower_x, lower_y=lower_y, upper_x=upper_x, upper_y=upper_y)
    return made


def velocity(x: ArrayLike = 0.0, y: ArrayLike = 0.0, angular_z: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Velocity:
    """Velocity of a body's material at the contact [m/s, m/s, rad/s], for creepage_from_velocities()."""
    made: Velocity = record("velocity", dtype, x=x, y=y, angular_z=angular_z)
    return made


def parameters(xi: ArrayLike = 0.0, eta: ArrayLike = 0.0, psi: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Parameters:
    """Kalker's dimensionless parameters (5.13), for creepage_from_parameters()."""
    made: Parameters = record("parameters", dtype, xi=xi, eta=eta, psi=psi)
    return made


def patch_strip(*, y: ArrayLike, width: ArrayLike, half_length: ArrayLike, peak_pressure: ArrayLike, friction: ArrayLike,
                centre_x: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> PatchStrip:
    """Strips of a patch of any shape, for patch_from_strips(): y, width, half_length [m], peak_pressure [Pa], friction [-], centre_x [m]."""
    made: PatchStrip = record("patch_strip", dtype, y=y, width=width, half_length=half_length, centre_x=centre_x,
                              peak_pressure=peak_pressure, friction=friction)
    return made
