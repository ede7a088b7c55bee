"""Patches of any shape; solve(), evaluate(), strips() and field() take them."""

from __future__ import annotations

import ctypes
from typing import Optional

import numpy as np
from numpy.typing import ArrayLike

from ._calls import call
from ._inputs import count_of, floats, is_single, one, options, records
from ._library import dtypes, structures
from ._types import Contact, Patch, PatchStrip, PatchSummary, ProfileResult


def patch_from_profile(y: ArrayLike, distance: ArrayLike, *, rolling_radius: ArrayLike, shear_modulus: float,
                       poisson_ratio: float, friction: float, normal_force: float = 0.0, approach: float = 0.0,
                       smoothing_length: float = 0.0, strips: int = 0,
                       centre_x: Optional[ArrayLike] = None) -> tuple[Patch, ProfileResult]:
    """A patch from the distance [m] of two undeformed profiles over y [m], under a load [N] or at an approach [m].

    y, distance: one after the other, in ascending y. rolling_radius [m]: one number or one for each point.
    centre_x [m]: where along x the distance is least (yaw), one for each point.
    shear_modulus [Pa], poisson_ratio, friction [-]; smoothing_length [m], 0: the library's choice.
    Returns the patch, whose members may be changed (friction per strip), and how the profiles meet.
    """
    places, gap = floats(y, "y", False).reshape(-1), floats(distance, "distance", False).reshape(-1)
    lists = {"y": places, "distance": gap}
    for name, values in (("centre_x", centre_x), ("rolling_radius", rolling_radius if np.ndim(rolling_radius) else None)):
        if values is not None:
            lists[name] = floats(values, name, False).reshape(-1)
    for name, found in lists.items():
        if found.size != places.size:
            raise ValueError(f"the arrays of a profile have different sizes: y {places.shape}, {name} {found.shape}")
    profile = structures["kstrip_profile"](points=count_of(places.size), **{name: values.ctypes.data for name, values in lists.items()})
    load = structures["kstrip_profile_contact"](
        rolling_radius=0.0 if np.ndim(rolling_radius) else float(rolling_radius), normal_force=float(normal_force),  # type: ignore[arg-type]
        approach=float(approach), smoothing_length=float(smoothing_length), shear_modulus=float(shear_modulus),
        poisson_ratio=float(poisson_ratio), friction=float(friction), strips=options(0, strips).strips)
    patch, met = np.zeros((), dtypes["patch"]), np.zeros((), dtypes["profile_result"])
    call("kstrip_patch_from_profile", False, ctypes.byref(profile), ctypes.byref(load), patch, met)
    return patch.view(Patch), met.view(ProfileResult)


def patch_from_strips(strips: PatchStrip, shear_modulus: float, poisson_ratio: float) -> Patch:
    """A patch from patch_strip() of any origin, at most 64, in any order of y; shear modulus [Pa]."""
    single = is_single(strips)
    given = records("patch_strip", strips, single).reshape(-1)
    patch = np.zeros((), dtypes["patch" + "_f32" * single])
    call("kstrip_patch_from_strips", single, given, count_of(given.size), float(shear_modulus), float(poisson_ratio), patch)
    return patch.view(Patch)


def patch_from_contact(contact: Contact, strips: int = 0) -> Patch:
    """The strips of one contact's ellipse, at the places that the model STRIP uses; `strips` as in solve()."""
    single = is_single(contact)
    patch = np.zeros((), dtypes["patch" + "_f32" * single])
    call("kstrip_patch_from_contact", single, one("contact", contact, single), ctypes.byref(options(0, strips)), patch)
    return patch.view(Patch)


def patch_summary(patch: Patch) -> PatchSummary:
    """Load [N], friction bound [N], area [m^2] and lobes of a patch."""
    single = is_single(patch)
    made = np.zeros((), dtypes["patch_summary" + "_f32" * single])
    call("kstrip_patch_summarize", single, one("patch", patch, single), made)
    return made.view(PatchSummary)
