"""Creep forces of rolling contact by Kalker's strip theory.

A creep curve in three lines:

    import numpy as np, kstrip
    contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    forces = kstrip.solve(contact, kstrip.creepage(longitudinal=np.linspace(0, 0.01, 200)))      # forces.fx in N, shape (200,)

A wheel on a rail, from two files:

    rail, wheel = (kstrip.read_profile(path).prepare() for path in ("60e1.prr", "s1002.prw"))
    pair = kstrip.wheel_pair(wheel_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    position = kstrip.wheel_position(lateral=np.linspace(-0.015, -0.005, 50))
    position.vertical = kstrip.height_for_load(rail, wheel, pair, position, 80e3)
    wheels = kstrip.wheel_on_rail(rail, wheel, pair, position, kstrip.wheel_velocity(forward=20.0, pitch=-20.0 / 0.46))

Functions by subject:

    contact, creepage, friction, motion, radii, velocity, parameters, patch_strip     values from numbers, batches from arrays
    solve, evaluate, solve_motion, prepare                                            forces, derivatives
    strips, field                                                                     inside a contact or a patch
    combine, contact_from_hertz, contact_from_approach, linear_coefficients           bodies
    creepage_from_velocities, parameters_from_creepage, creepage_from_parameters      their motion
    patch_from_profile, patch_from_strips, patch_from_contact, patch_summary          patches of any shape
    read_profile, read_profiles, oriented, write_profile                              profile files
    Slices, read_slices, profile_between                                              crossings, wheels with flats
    prepare_profile, wheel_pair, wheel_position, wheel_velocity                       a wheel on a rail
    height_for_load, wheel_on_rail, wheel_motion                                      its height, its forces, its slip
    Wheelset, Track, wheelset_settle, wheelset_on_track, rail_motion                  a wheelset on a track
    curve, curve_motion, gauge_face, rolling_radius_difference, equivalent_conicity   curves, gauge, conicity
    estimate_friction, creepage_for_force, fit_friction, on_upper_body                test rigs; forces on the wheel
    kstrip.plot                                                                       plots; pip install kstrip[plot]
    kstrip.arrays                                                                     TOTAL for arrays of JAX, CuPy, PyTorch
    python -m kstrip                                                                  commands on files
    lib, constants, dtypes, models                                                    the C library itself, unchecked

Units and signs: SI units. Forces act on the LOWER body (the rail) and have the sense of the creepage, but those of wheels act on the wheel.
See kstrip.h.

One value, such as kstrip.Contact or kstrip.Result, is an object with numbers as its members: `result.fx`. Many values are a kstrip.Batch, whose
members are arrays: `results.fx` has the shape of the batch, `results[3]` is one value. They print with names and units, and survive pickle and
copy. help(kstrip.values) describes the classes. Arguments broadcast like numpy arrays; numbers alone give one value.

An argument of the wrong kind raises TypeError, one of the wrong shape ValueError. Bad numbers raise KstripError with the index of the first
one and the results of the others; with on_error="nan" they become NaN. Warnings of the library are Python warnings of the class KstripWarning,
and in the member `status_detail` of each result. Single precision is used if all batches and profiles are single (`dtype=np.float32`).
"""

import importlib
from typing import TYPE_CHECKING, Any

from ._batch import Batch as Batch
from ._bodies import (
    combine,
    contact_from_approach,
    contact_from_hertz,
    creepage_from_parameters,
    creepage_from_velocities,
    linear_coefficients,
    parameters_from_creepage,
)
from ._contacts import wheel_motion
from ._inputs import Model as Model
from ._library import constants, dtypes, lib, models
from ._patches import patch_from_contact, patch_from_profile, patch_from_strips, patch_summary
from ._rig import creepage_for_force, estimate_friction, fit_friction
from ._solve import (
    Evaluation as Evaluation,
    MotionEvaluation as MotionEvaluation,
    Prepared as Prepared,
    evaluate,
    field,
    on_upper_body,
    prepare,
    solve,
    solve_motion,
    strips,
)
from ._status import KstripError as KstripError, KstripWarning as KstripWarning
from ._structures import (
    contact,
    creepage,
    curve,
    friction,
    motion,
    parameters,
    patch_strip,
    radii,
    rail_motion,
    velocity,
    wheel_pair,
    wheel_position,
    wheel_velocity,
)
from ._value import Value as Value
from ._wheel import PreparedProfile as PreparedProfile, WheelOnRail as WheelOnRail, height_for_load, prepare_profile, wheel_on_rail
from ._wheelset import (
    Conicity as Conicity,
    Settled as Settled,
    Track as Track,
    WheelOfWheelset as WheelOfWheelset,
    Wheelset as Wheelset,
    WheelsetOnTrack as WheelsetOnTrack,
    curve_motion,
    equivalent_conicity,
    gauge_face,
    rolling_radius_difference,
    wheelset_on_track,
    wheelset_settle,
)
from .values import *  # noqa: F403

if TYPE_CHECKING:
    from ._contact_table import ContactTable as ContactTable
    from ._files import Profile as Profile, oriented, read_profile, read_profiles, write_profile
    from ._files_points import ProfileError as ProfileError, ProfileWarning as ProfileWarning
    from ._files_slices import Slices as Slices, profile_between, read_slices

__version__: str = lib.kstrip_version_string().decode()
#: States of the points of field()
OUTSIDE, STICK, SLIP, SLIP_NEGATIVE_DISSIPATION = range(4)

#: Functions and constants: help(kstrip) shows them first. The classes have pages of their own, such as help(kstrip.Wheelset).
__all__ = [
    # values and batches
    "contact", "creepage", "friction", "motion", "radii", "velocity", "parameters", "patch_strip",
    # forces and derivatives; inside a contact
    "solve", "evaluate", "solve_motion", "prepare", "strips", "field", "OUTSIDE", "STICK", "SLIP", "SLIP_NEGATIVE_DISSIPATION",
    # bodies and their motion
    "combine", "contact_from_hertz", "contact_from_approach", "linear_coefficients",
    "creepage_from_velocities", "parameters_from_creepage", "creepage_from_parameters",
    # patches of any shape
    "patch_from_profile", "patch_from_strips", "patch_from_contact", "patch_summary",
    # a wheel on a rail
    "read_profile", "read_profiles", "oriented", "write_profile", "read_slices", "profile_between",
    "prepare_profile", "wheel_pair", "wheel_position", "wheel_velocity",
    "height_for_load", "wheel_on_rail", "wheel_motion",
    # a wheelset on a track
    "rail_motion", "curve", "gauge_face", "curve_motion", "wheelset_settle", "wheelset_on_track",
    "rolling_radius_difference", "equivalent_conicity",
    # test rigs; forces on the upper body
    "estimate_friction", "creepage_for_force", "fit_friction", "on_upper_body",
    # the C library
    "lib", "constants", "dtypes", "models", "__version__",
]


#: What reads profile files is imported when it is used first: it would double the time of `import kstrip`.
_OF_FILES = {
    "ContactTable": "_contact_table",
    **dict.fromkeys(("Profile", "oriented", "read_profile", "read_profiles", "write_profile"), "_files"),
    **dict.fromkeys(("ProfileError", "ProfileWarning"), "_files_points"),
    **dict.fromkeys(("Slices", "profile_between", "read_slices"), "_files_slices"),
}


def __getattr__(name: str) -> Any:
    if name not in _OF_FILES:
        raise AttributeError(f"module 'kstrip' has no attribute {name!r}")
    return getattr(importlib.import_module(f".{_OF_FILES[name]}", __name__), name)


def __dir__() -> list[str]:
    return [*globals(), *_OF_FILES]
