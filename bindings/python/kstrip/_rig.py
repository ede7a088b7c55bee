"""Test rigs: friction from a force, creepage from a force, a law of friction from a measured curve."""

from __future__ import annotations

import ctypes
from typing import Iterable, Optional, SupportsFloat

import numpy as np
from numpy.typing import ArrayLike

from ._calls import call
from ._inputs import Model, is_single, one, options
from ._library import constants, dtypes, function_of
from ._status import report
from ._types import Contact, Creepage, Friction, FrictionEstimate, FrictionFit

FX, FY = constants["KSTRIP_MEASURED_FX"], constants["KSTRIP_MEASURED_FY"]


def estimate_friction(contact: Contact, creepage: Creepage, *, fx: Optional[SupportsFloat] = None, fy: Optional[SupportsFloat] = None,
                      model: Model = "default", strips: int = 0, law: Optional[Friction] = None) -> FrictionEstimate:
    """The friction that explains a measured force [N] on the lower body: friction, sensitivity, residual, status_detail.

    Give fx, fy or both; the friction of the contact does not count, nor does that of a law.
    """
    single = is_single(contact, creepage)
    under = None if law is None else one("friction", law, single)
    made = np.zeros((), dtypes["friction_estimate" + "_f32" * single])
    measured = (FX if fx is not None else 0) | (FY if fy is not None else 0)
    call("kstrip_estimate_friction", single, one("contact", contact, single), one("creepage", creepage, single),
         under, ctypes.byref(options(model, strips)), measured, float(0.0 if fx is None else fx), float(0.0 if fy is None else fy), made)
    return made.view(FrictionEstimate)


def creepage_for_force(contact: Contact, fx: SupportsFloat, fy: SupportsFloat, spin: SupportsFloat = 0.0, model: Model = "default",
                       strips: int = 0, law: Optional[Friction] = None) -> Creepage:
    """The creepage at which a contact with a given spin [1/m] carries a requested force [N] on the lower body."""
    single = is_single(contact)
    made = np.zeros((), dtypes["creepage" + "_f32" * single])
    under = None if law is None else one("friction", law, single)
    call("kstrip_creepage_for_force", single, one("contact", contact, single), float(fx), float(fy), float(spin),
         under, ctypes.byref(options(model, strips)), made)
    return made.view(Creepage)


def fit_friction(creepage: ArrayLike, force: ArrayLike, contact: Contact, *, start: Optional[Friction] = None,
                 fit: Iterable[str] = ("friction", "slope_factor"), weight: ArrayLike = 1.0, model: Model = "default",
                 strips: int = 0) -> FrictionFit:
    """The law of friction that comes nearest to a measured creep curve: law, standard_errors, residual [N], steps, status_detail.

    creepage: longitudinal creepages, or creepages as kstrip.creepage() makes them.
    force: longitudinal forces on the lower body [N]; or n rows of longitudinal and lateral ones, NaN where not measured.
    start: where to begin, and the members that stay; friction that falls needs its rolling speed.
    fit: members of the law to be found: friction, ratio, decay, slope_factor, slide_factor, layer.
    weight: weight of the squared error of each point.
    Raises KstripError for bad input, with the index of the first bad point.
    """
    single = is_single(contact)
    motion = np.asarray(creepage)
    forces = np.asarray(force, float)
    count = len(forces)
    points = np.zeros(count, dtypes["measured_force" + "_f32" * single])
    if motion.dtype.names:
        for name in ("longitudinal", "lateral", "spin"):
            points[name] = motion[name]
    else:
        points["longitudinal"] = motion
    columns = forces[:, None] if forces.ndim == 1 else forces
    for k, (name, bit) in enumerate((("fx", FX), ("fy", FY))[:columns.shape[1]]):
        known = ~np.isnan(columns[:, k])
        points[name] = np.where(known, columns[:, k], 0.0)
        points["measured"] |= np.where(known, bit, 0).astype(np.uint32)
    points["weight"] = weight
    law = np.zeros((), dtypes["friction" + "_f32" * single]) if start is None else one("friction", start, single)
    if start is None:
        law["ratio"] = 1.0
    made = np.zeros((), dtypes["friction_fit" + "_f32" * single])
    which = sum(constants["KSTRIP_FIT_" + name.upper()] for name in set(fit))
    bad = np.array(count, np.uint32)
    status = function_of("kstrip_fit_friction", single)(
        *(a.ctypes.data for a in (one("contact", contact, single), points)), count, law.ctypes.data, which,
        ctypes.byref(options(model, strips)), made.ctypes.data, bad.ctypes.data)
    report(status, (int(bad),) if status < 0 and bad < count else None)
    return made.view(FrictionFit)
