"""Patches of any shape; solve(), evaluate(), strips() and field() take them."""

from __future__ import annotations

import struct
from typing import Optional

import numpy as np
from numpy.typing import ArrayLike

from ._batch import layout_of
from ._calls import call, zeros
from ._inputs import Many, array_of, choice, count_of, floats, is_single, number, one, options
from .values import Contact, Patch, PatchStrip, PatchSummary, ProfileResult


def patch_from_profile(y: ArrayLike, distance: ArrayLike, *, rolling_radius: ArrayLike, shear_modulus: float,
                       poisson_ratio: float, friction: float, normal_force: float = 0.0, approach: float = 0.0,
                       smoothing_length: float = 0.0, strips: int = 0,
                       centre_x: Optional[ArrayLike] = None) -> tuple[Patch, ProfileResult]:
    """A patch from the distance [m] of two undeformed profiles along y [m], under a load [N] or at an approach [m].

    y, distance: one after the other, in ascending y. rolling_radius [m]: one number or one for each point.
    centre_x [m]: where along x the distance is least (yaw), one for each point.
    shear_modulus [Pa], poisson_ratio, friction [-]; smoothing_length [m], 0: the library's choice.
    Returns the patch, whose members may be changed (friction per strip), and how the profiles meet.

    >>> y = np.linspace(-12e-3, 12e-3, 241)
    >>> steel = dict(rolling_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, friction=0.35)
    >>> patch, met = kstrip.patch_from_profile(y, y**2 / 0.6, normal_force=80e3, **steel)
    >>> print(f"{patch.count} strips, {1e-6 * met.peak_pressure:.0f} MPa")
    16 strips, 1139 MPa
    """
    places = floats(y, "y").reshape(-1)
    lists = {"distance": floats(distance, "distance").reshape(-1)}
    radius = 0.0 if np.ndim(rolling_radius) else number(rolling_radius, "rolling_radius")
    for name, given in (("centre_x", centre_x), ("rolling_radius", rolling_radius if np.ndim(rolling_radius) else None)):
        if given is not None:
            lists[name] = floats(given, name).reshape(-1)
    for name, found in lists.items():
        if found.size != places.size:
            raise ValueError(f"the arrays of a profile have different sizes: y {places.shape}, {name} {found.shape}")
    addresses = [places.ctypes.data, *(lists[name].ctypes.data if name in lists else 0 for name in ("distance", "centre_x", "rolling_radius"))]
    # kstrip_profile, kstrip_profile_contact
    profile = struct.pack("4PII", *addresses, count_of(places.size), 0)
    numbers = {"normal_force": normal_force, "approach": approach, "smoothing_length": smoothing_length, "shear_modulus": shear_modulus,
               "poisson_ratio": poisson_ratio, "friction": friction}
    load = struct.pack("7dii", radius, *(number(value, name) for name, value in numbers.items()), choice(0, strips)[1], 0)
    patch, met = zeros("patch", False), zeros("profile_result", False)
    call("kstrip_patch_from_profile", False, profile, load, patch, met)
    return layout_of(Patch).value(patch), layout_of(ProfileResult).value(met)


def patch_from_strips(strips: Many[PatchStrip], shear_modulus: float, poisson_ratio: float) -> Patch:
    """A patch from patch_strip() of any origin, at most 64, in any order of y; shear modulus [Pa].

    >>> strips = kstrip.patch_strip(y=[-1e-3, 0.0, 1e-3], width=1e-3, half_length=5e-3, peak_pressure=800e6, friction=0.3)
    >>> kstrip.patch_from_strips(strips, 82e9, 0.28).count
    3
    """
    single = is_single(strips)
    given, patch = array_of("strips", PatchStrip, strips, single).reshape(-1), zeros("patch", single)
    call("kstrip_patch_from_strips", single, given, count_of(given.size), number(shear_modulus, "shear_modulus"),
         number(poisson_ratio, "poisson_ratio"), patch)
    return layout_of(Patch).value(patch)


def patch_from_contact(contact: Many[Contact], strips: int = 0) -> Patch:
    """The strips of one contact's ellipse, at the places that the model STRIP uses; `strips` as in solve().

    >>> contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    >>> kstrip.patch_from_contact(contact, strips=8).strips.y[:8].round(5)
    array([-0.00419, -0.00301, -0.00149, -0.00031,  0.00031,  0.00149,
            0.00301,  0.00419])
    """
    single = is_single(contact)
    patch = zeros("patch", single)
    call("kstrip_patch_from_contact", single, one("contact", Contact, contact, single), options(0, strips), patch)
    return layout_of(Patch).value(patch)


def patch_summary(patch: Many[Patch]) -> PatchSummary:
    """Load [N], friction bound [N], area [m^2] and lobes of a patch.

    >>> contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    >>> summary = kstrip.patch_summary(kstrip.patch_from_contact(contact))
    >>> print(f"{summary.normal_force:.0f} N, {1e6 * summary.area:.1f} mm^2, {summary.lobes} lobe")
    80000 N, 84.8 mm^2, 1 lobe
    """
    single = is_single(patch)
    made = zeros("patch_summary", single)
    call("kstrip_patch_summarize", single, one("patch", Patch, patch, single), made)
    return layout_of(PatchSummary).value(made)
