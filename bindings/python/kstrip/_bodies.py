"""Bodies and their motion: materials, Hertz's ellipse, linear coefficients, creepages."""

from __future__ import annotations

from typing import Any, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from ._calls import Worst, call, each, out, real
from ._inputs import broadcast, flat, floats, is_single, one, record, records
from ._library import dtypes, function_of
from ._record import as_record
from ._types import CombinedMaterial, Contact, Creepage, HertzContact, Material, Parameters, Radii, Velocity


def combine(lower: Union[Sequence[float], Material], upper: Union[Sequence[float], Material],
            dtype: DTypeLike = np.float64) -> CombinedMaterial:
    """The combined elastic constants of two bodies, each (shear modulus [Pa], Poisson's ratio).

    >>> kstrip.combine((82e9, 0.28), (82e9, 0.28))
    CombinedMaterial(shear_modulus=8.2e+10 Pa, poisson_ratio=0.28, mismatch=0)
    """
    both = [record("material", dtype, shear_modulus=g, poisson_ratio=nu) for g, nu in (_pair(lower), _pair(upper))]
    single = is_single(*both)
    both = [one("material", body, single) for body in both]
    made = np.zeros((), dtypes["combined_material" + "_f32" * single])
    call("kstrip_material_combine", single, *both, made)
    return made.view(CombinedMaterial)


def _pair(material: Any) -> tuple[ArrayLike, ArrayLike]:
    if isinstance(material, Material):
        return material["shear_modulus"], material["poisson_ratio"]
    shear_modulus, poisson_ratio = material
    return shear_modulus, poisson_ratio


def _from_bodies(name: str, curvatures: Any, pair: Any, amount: ArrayLike, friction: ArrayLike, also: str) -> tuple[Any, Any]:
    single = is_single(curvatures, pair)
    curvatures, pair = records("radii", curvatures, single), records("combined_material", pair, single)
    amounts, frictions = floats(amount, "load or approach", single), floats(friction, "friction", single)
    shape = broadcast(radii=curvatures, pair=pair, load_or_approach=amounts, friction=frictions)
    curvatures, pair = flat(curvatures, shape), flat(pair, shape)
    amounts, frictions = (np.broadcast_to(v, shape).reshape(-1) for v in (amounts, frictions))
    contacts, seconds = out("contact", shape, single), out(also, shape, single) if also else real(shape, single)
    function, worst = function_of(name, single), Worst()
    for i in range(amounts.size):
        status = function(curvatures[0].ctypes.data + i * curvatures[1], pair[0].ctypes.data + i * pair[1], float(amounts[i]),
                          float(frictions[i]), contacts[0].ctypes.data + i * contacts[1], seconds[0].ctypes.data + i * seconds[1])
        if status and worst.add(status, i):
            break
    worst.report(shape)
    return as_record(contacts[0].reshape(shape)), as_record(seconds[0].reshape(shape))


def contact_from_hertz(radii: Radii, pair: CombinedMaterial, load: ArrayLike, friction: ArrayLike) -> tuple[Contact, HertzContact]:
    """Contacts of bodies that loads [N] press together, and their ellipses; all four arguments broadcast.

    >>> steel = kstrip.combine((82e9, 0.28), (82e9, 0.28))
    >>> contact, ellipse = kstrip.contact_from_hertz(kstrip.radii(lower_y=0.3, upper_x=0.46), steel, 80e3, 0.3)
    >>> print(f"{1e3 * contact.a:.2f} mm, {1e-6 * ellipse.peak_pressure:.0f} MPa")
    6.68 mm, 1139 MPa
    """
    return _from_bodies("kstrip_contact_from_hertz", radii, pair, load, friction, "hertz_contact")


def contact_from_approach(radii: Radii, pair: CombinedMaterial, approach: ArrayLike,
                          friction: ArrayLike) -> tuple[Contact, NDArray[np.float64]]:
    """Contacts of bodies that have approached each other [m], and their stiffness dN/d(approach) [N/m]; arguments broadcast."""
    return _from_bodies("kstrip_contact_from_approach", radii, pair, approach, friction, "")


def linear_coefficients(axis_ratio: float, poisson_ratio: float) -> NDArray[np.float64]:
    """Kalker's C11, C22, C23, C33 of the linear theory, shape (4,), for an axis ratio a/b."""
    made = np.zeros(4)
    call("kstrip_linear_coefficients", False, float(axis_ratio), float(poisson_ratio), made)
    return made


def creepage_from_velocities(lower: Velocity, upper: Velocity, rolling_speed: float) -> Creepage:
    """Creepages from the velocities of both bodies, (upper - lower)/rolling_speed, at a rolling speed [m/s] above zero."""
    single = is_single(lower, upper)
    first, second = records("velocity", lower, single), records("velocity", upper, single)
    shape = broadcast(lower=first, upper=second)
    made = out("creepage", shape, single)
    each("kstrip_creepage_from_velocities", single, shape, flat(first, shape), flat(second, shape), float(rolling_speed), made)
    return made[0].reshape(shape).view(Creepage)


def parameters_from_creepage(contacts: Contact, creepages: Creepage) -> Parameters:
    """Kalker's dimensionless xi, eta, psi (5.13); contacts and creepages broadcast."""
    single = is_single(contacts, creepages)
    first, second = records("contact", contacts, single), records("creepage", creepages, single)
    shape = broadcast(contacts=first, creepages=second)
    made = out("parameters", shape, single)
    each("kstrip_parameters_from_creepage", single, shape, flat(first, shape), flat(second, shape), made)
    return made[0].reshape(shape).view(Parameters)


def creepage_from_parameters(contacts: Contact, parameters: Parameters) -> Creepage:
    """The creepages that have the given xi, eta, psi; contacts and parameters broadcast."""
    single = is_single(contacts, parameters)
    first, second = records("contact", contacts, single), records("parameters", parameters, single)
    shape = broadcast(contacts=first, parameters=second)
    made = out("creepage", shape, single)
    each("kstrip_creepage_from_parameters", single, shape, flat(first, shape), flat(second, shape), made)
    return made[0].reshape(shape).view(Creepage)
