"""Test rigs: friction from a force, creepage from a force."""

from __future__ import annotations

import ctypes
from typing import Optional, SupportsFloat

import numpy as np

from ._calls import call
from ._inputs import Model, is_single, one, options
from ._library import constants, dtypes
from ._types import Contact, Creepage, FrictionEstimate

FX, FY = constants["KSTRIP_MEASURED_FX"], constants["KSTRIP_MEASURED_FY"]


def estimate_friction(contact: Contact, creepage: Creepage, *, fx: Optional[SupportsFloat] = None, fy: Optional[SupportsFloat] = None,
                      model: Model = "default", strips: int = 0) -> FrictionEstimate:
    """The friction that explains a measured force [N] on the lower body: friction, sensitivity, residual, status_detail.

    Give fx, fy or both; the friction of the contact does not count.
    """
    single = is_single(contact, creepage)
    made = np.zeros((), dtypes["friction_estimate" + "_f32" * single])
    measured = (FX if fx is not None else 0) | (FY if fy is not None else 0)
    call("kstrip_estimate_friction", single, one("contact", contact, single), one("creepage", creepage, single),
         ctypes.byref(options(model, strips)), measured, float(0.0 if fx is None else fx), float(0.0 if fy is None else fy), made)
    return made.view(FrictionEstimate)


def creepage_for_force(contact: Contact, fx: SupportsFloat, fy: SupportsFloat, spin: SupportsFloat = 0.0, model: Model = "default",
                       strips: int = 0) -> Creepage:
    """The creepage at which a contact with a given spin [1/m] carries a wanted force [N] on the lower body."""
    single = is_single(contact)
    made = np.zeros((), dtypes["creepage" + "_f32" * single])
    call("kstrip_creepage_for_force", single, one("contact", contact, single), float(fx), float(fy), float(spin),
         ctypes.byref(options(model, strips)), made)
    return made.view(Creepage)
