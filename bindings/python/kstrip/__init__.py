"""Creep forces of rolling contact by Kalker's strip theory, with numpy in and out.

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

Units and signs: SI units. Forces act on the LOWER body (the rail) and have the sense of the creepage, but those of
wheel_on_rail() act on the wheel. See kstrip.h, from which this module makes itself when it is imported.

What goes in and comes out are arrays of structures with named members, of any shape: `forces.fx` or `forces["fx"]`. They print
with names and units. Arguments broadcast like numpy arrays. An argument of the wrong kind raises TypeError, one of the wrong shape
ValueError. Bad numbers raise KstripError with the index of the first one; warnings of the library are Python warnings of the class
KstripWarning, and in the member `status_detail` of each result. Single precision is used where all structures are single
(`dtype=np.float32`).

    contact, creepage, friction, motion, radii, velocity, parameters, patch_strip     structures from numbers and arrays
    solve, evaluate, solve_motion, prepare                                            forces, derivatives
    strips, field                                                                     inside a contact or a patch
    combine, contact_from_hertz, contact_from_approach, linear_coefficients           bodies
    creepage_from_velocities, parameters_from_creepage, creepage_from_parameters      their motion
    patch_from_profile, patch_from_strips, patch_from_contact, patch_summary          patches of any shape
    read_profile, write_profile                                                       profile files
    prepare_profile, wheel_pair, wheel_position, wheel_velocity                       a wheel on a rail
    height_for_load, wheel_on_rail                                                    its height and its forces
    Wheelset, Track, wheelset_settle, wheelset_on_track, rail_motion                  a wheelset on a track
    curve, curve_motion, gauge_face, rolling_radius_difference, equivalent_conicity   curves, gauge, conicity
    estimate_friction, creepage_for_force, fit_friction, on_upper_body                test rigs; forces on the wheel
    kstrip.plot                                                                       pictures; pip install kstrip[plot]
    lib, constants, structures, dtypes, models                                        the C library itself, unchecked
"""

from ._bodies import (
    combine,
    contact_from_approach,
    contact_from_hertz,
    creepage_from_parameters,
    creepage_from_velocities,
    linear_coefficients,
    parameters_from_creepage,
)
from ._files import Profile, oriented, read_profile, read_profiles, write_profile
from ._files_points import ProfileError, ProfileWarning
from ._inputs import Model
from ._library import constants, dtypes, lib, models, structures
from ._patches import patch_from_contact, patch_from_profile, patch_from_strips, patch_summary
from ._record import Record, classes
from ._rig import creepage_for_force, estimate_friction, fit_friction
from ._solve import Evaluation, MotionEvaluation, Prepared, evaluate, field, on_upper_body, prepare, solve, solve_motion, strips
from ._status import KstripError, KstripWarning
from ._structures import contact, creepage, friction, motion, parameters, patch_strip, radii, velocity
from ._types import (
    CombinedMaterial,
    Contact,
    Creepage,
    Curve,
    Derivatives,
    Friction,
    FrictionEstimate,
    HertzContact,
    LawDerivatives,
    Material,
    Motion,
    MotionDerivatives,
    Parameters,
    Patch,
    PatchStrip,
    PatchSummary,
    Point,
    ProfileResult,
    Radii,
    RailMotion,
    Result,
    Strip,
    Surface,
    Velocity,
    WheelContact,
    WheelPair,
    WheelPosition,
    WheelsetByPosition,
    WheelsetDerivatives,
    WheelsetForces,
    WheelVelocity,
    Wrench,
    WrenchByPosition,
    WrenchDerivatives,
)
from ._wheel import WheelOnRail, height_for_load, prepare_profile, wheel_on_rail, wheel_pair, wheel_position, wheel_velocity
from ._wheelset import (
    Conicity,
    Settled,
    Track,
    Wheelset,
    WheelsetOnTrack,
    curve,
    curve_motion,
    equivalent_conicity,
    gauge_face,
    rail_motion,
    rolling_radius_difference,
    wheelset_on_track,
    wheelset_settle,
)

__version__: str = lib.kstrip_version_string().decode()
#: States of the points of field()
OUTSIDE, STICK, SLIP, SLIP_NEGATIVE_DISSIPATION = range(4)

__all__ = [
    # structures from numbers and arrays
    "contact", "creepage", "friction", "motion", "radii", "velocity", "parameters", "patch_strip",
    # forces and derivatives; inside a contact
    "solve", "evaluate", "solve_motion", "prepare", "strips", "field", "OUTSIDE", "STICK", "SLIP", "SLIP_NEGATIVE_DISSIPATION",
    # bodies and their motion
    "combine", "contact_from_hertz", "contact_from_approach", "linear_coefficients",
    "creepage_from_velocities", "parameters_from_creepage", "creepage_from_parameters",
    # patches of any shape
    "patch_from_profile", "patch_from_strips", "patch_from_contact", "patch_summary",
    # a wheel on a rail
    "read_profile", "read_profiles", "oriented", "write_profile", "prepare_profile", "wheel_pair", "wheel_position", "wheel_velocity",
    "height_for_load", "wheel_on_rail",
    # a wheelset on a track
    "Wheelset", "Track", "rail_motion", "curve", "gauge_face", "curve_motion", "wheelset_settle", "wheelset_on_track",
    "rolling_radius_difference", "equivalent_conicity",
    # test rigs; forces on the upper body
    "estimate_friction", "creepage_for_force", "fit_friction", "on_upper_body",
    # types
    "Record", "CombinedMaterial", "Contact", "Conicity", "Creepage", "Curve", "Derivatives", "Evaluation", "Friction", "FrictionEstimate", "HertzContact",
    "LawDerivatives", "Material", "Model", "Motion", "MotionDerivatives", "MotionEvaluation", "Parameters", "Patch", "PatchStrip",
    "PatchSummary", "Point", "Prepared", "Profile", "ProfileResult", "Radii", "RailMotion", "Result", "Settled", "Strip",
    "Surface", "Velocity",
    "WheelContact", "WheelOnRail", "WheelPair", "WheelPosition", "WheelVelocity", "WheelsetByPosition", "WheelsetDerivatives",
    "WheelsetForces", "WheelsetOnTrack", "Wrench", "WrenchByPosition", "WrenchDerivatives",
    "KstripError", "KstripWarning", "ProfileError", "ProfileWarning",
    # the C library
    "lib", "constants", "structures", "dtypes", "models", "classes", "__version__",
]
