"""Test rigs: friction from a force, creepage from a force, a law of friction from a measured curve."""

from __future__ import annotations

from itertools import repeat
from typing import Any, Iterable, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from ._batch import Batch, layout_of
from ._calls import Elements, optional, sweep_of, zeros
from ._inputs import Many, Model, array_of, count_of, is_single, numbers, one, options
from ._library import constants, dtype_of, function_of
from ._status import KstripError, report
from .values import Contact, Creepage, Friction, FrictionEstimate, FrictionFit

_FX, _FY = constants["KSTRIP_MEASURED_FX"], constants["KSTRIP_MEASURED_FY"]


def estimate_friction(contact: Many[Contact], creepage: Many[Creepage], *, fx: Optional[ArrayLike] = None, fy: Optional[ArrayLike] = None,
                      model: Model = "default", strips: int = 0, law: Optional[Many[Friction]] = None, on_error: str = "raise",
                      threads: int = 1, progress: bool = False) -> Any:
    """The friction that explains a measured force [N] on the lower body: friction, sensitivity, residual, status_detail.

    Pass fx, fy or both; the coefficients of the contact and of the law are ignored. All arguments broadcast.
    on_error, threads, progress: as in solve().

    >>> contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.0)
    >>> kstrip.estimate_friction(contact, kstrip.creepage(3e-3), fx=[10e3, 15e3]).friction.round(3)
    array([0.125, 0.192])
    """
    sweep = sweep_of(threads, progress)
    elements = Elements(is_single(contact, creepage, law), on_error, contact=(Contact, contact), creepage=(Creepage, creepage),
                        law=optional(Friction, law), fx=(float, 0.0 if fx is None else fx), fy=(float, 0.0 if fy is None else fy))
    made, places = elements.out("friction_estimate")
    measured = (_FX if fx is not None else 0) | (_FY if fy is not None else 0)
    columns = elements.columns
    found = elements.run("kstrip_estimate_friction", columns["contact"], columns["creepage"], columns["law"], repeat(options(model, strips)),
                         repeat(measured), columns["fx"], columns["fy"], places, sweep=sweep)
    statuses = elements.statuses(found, made)
    return elements.report(elements.result(FrictionEstimate, made, statuses), statuses)


def creepage_for_force(contact: Many[Contact], fx: ArrayLike, fy: ArrayLike, spin: ArrayLike = 0.0, model: Model = "default",
                       strips: int = 0, law: Optional[Many[Friction]] = None, on_error: str = "raise", threads: int = 1,
                       progress: bool = False) -> Any:
    """The creepage at which a contact with a given spin [1/m] carries a requested force [N] on the lower body; all arguments broadcast.

    on_error, threads, progress: as in solve().

    >>> contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    >>> print(f"{kstrip.creepage_for_force(contact, 12e3, 0.0).longitudinal:.5f}")
    0.00145
    """
    sweep = sweep_of(threads, progress)
    elements = Elements(is_single(contact, law), on_error, contact=(Contact, contact), fx=(float, fx), fy=(float, fy), spin=(float, spin),
                        law=optional(Friction, law))
    made, places = elements.out("creepage")
    found = elements.run("kstrip_creepage_for_force", *elements.columns.values(), repeat(options(model, strips)), places, sweep=sweep)
    statuses = elements.statuses(found, made)
    return elements.report(elements.result(Creepage, made, statuses), statuses)


def _measured_forces(creepage: Any, force: ArrayLike, weight: ArrayLike, single: bool) -> np.ndarray[Any, Any]:
    """Measured points as the C library takes them."""
    forces = numbers(force, "force").astype(float)
    if forces.ndim == 0 or forces.ndim > 2:
        raise ValueError(f"force: n numbers, or n rows of two, are needed, and this has the shape {forces.shape}")
    columns = forces[:, None] if forces.ndim == 1 else forces
    if columns.shape[1] > 2:
        raise ValueError(f"force: rows of a longitudinal and a lateral force are needed, and this has the shape {forces.shape}")
    points = np.zeros(len(forces), dtype_of("measured_force", single))
    if isinstance(creepage, (Batch, Creepage)):
        given = array_of("creepage", Creepage, creepage, single)
        for member in ("longitudinal", "lateral", "spin"):
            points[member] = given[member]
    else:
        points["longitudinal"] = numbers(creepage, "creepage")
    for k, (name, bit) in enumerate((("fx", _FX), ("fy", _FY))[: columns.shape[1]]):
        known = ~np.isnan(columns[:, k])
        points[name] = np.where(known, columns[:, k], 0.0)
        points["measured"] |= np.where(known, bit, 0).astype(np.uint32)
    points["weight"] = numbers(weight, "weight")
    return points


def fit_friction(creepage: Union[ArrayLike, Batch[Creepage]], force: ArrayLike, contact: Many[Contact], *, start: Optional[Many[Friction]] = None,
                 fit: Iterable[str] = ("friction", "slope_factor"), weight: ArrayLike = 1.0, model: Model = "default",
                 strips: int = 0) -> FrictionFit:
    """The law of friction that fits a measured creep curve best: law, standard_errors, residual [N], steps, status_detail.

    creepage: longitudinal creepages, or creepages as kstrip.creepage() makes them.
    force: longitudinal forces on the lower body [N]; or n rows of longitudinal and lateral ones, NaN where not measured.
    start: where to begin, and the members that stay; falling friction needs its rolling speed.
    fit: members of the law to be found: friction, ratio, decay, slope_factor, slide_factor, layer.
    weight: weight of the squared error of each point.
    Raises KstripError for bad input, with the index of the first bad point.

    >>> contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    >>> creepages = kstrip.creepage(np.linspace(1e-3, 0.02, 20))
    >>> forces = kstrip.solve(contact, creepages, kstrip.friction(0.25, slope_factor=0.5)).fx
    >>> found = kstrip.fit_friction(creepages, forces, contact)
    >>> print(f"{found.law.friction:.3f} {found.law.slope_factor:.3f}")
    0.250 0.500
    """
    single = is_single(contact)
    points = _measured_forces(creepage, force, weight, single)
    unknown = set(fit) - set(Friction.__match_args__[:3] + Friction.__match_args__[4:])
    if unknown:
        raise ValueError(f"fit: {', '.join(sorted(unknown))} is none of friction, ratio, decay, slope_factor, slide_factor, layer")
    law = one("start", Friction, Friction(0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0) if start is None else start, single)
    made, bad = zeros("friction_fit", single), np.array(len(points), np.uint32)
    which = sum(constants["KSTRIP_FIT_" + name.upper()] for name in set(fit))
    status = function_of("kstrip_fit_friction", single)(
        one("contact", Contact, contact, single), points.ctypes.data, count_of(len(points)), law, which, options(model, strips),
        made.ctypes.data, bad.ctypes.data)
    if status < 0 and bad < len(points):
        raise KstripError(status, (int(bad),))
    report(status)
    return layout_of(FrictionFit).value(made)
