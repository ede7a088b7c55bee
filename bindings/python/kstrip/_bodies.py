"""Bodies and their motion: materials, Hertz's ellipse, linear coefficients, creepages."""

from __future__ import annotations

from typing import Any, Iterable, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._calls import Elements, call
from ._inputs import Many, is_single, make, number
from .values import CombinedMaterial, Contact, Creepage, HertzContact, Material, Parameters, Radii, Velocity


def _answer(elements: Elements, name: str, kind: Any, *columns: Iterable[Any]) -> Any:
    """The results of one call for each element that has one output."""
    made, places = elements.out(kind._structure)
    found = elements.run(name, *columns, places)
    statuses = elements.statuses(found, made)
    return elements.report(elements.result(kind, made, statuses), statuses)


def combine(lower: Union[Sequence[ArrayLike], Many[Material]], upper: Union[Sequence[ArrayLike], Many[Material]],
            on_error: str = "raise") -> Any:
    """The combined elastic constants of two bodies, each (shear modulus [Pa], Poisson's ratio); numbers and arrays broadcast.

    >>> kstrip.combine((82e9, 0.28), (82e9, 0.28))
    CombinedMaterial(shear_modulus=8.2e+10 Pa, poisson_ratio=0.28, mismatch=0)
    """
    first, second = _material(lower, "lower"), _material(upper, "upper")
    elements = Elements(is_single(first, second), on_error, lower=(Material, first), upper=(Material, second))
    return _answer(elements, "kstrip_material_combine", CombinedMaterial, *elements.columns.values())


def _material(given: Any, name: str) -> Any:
    """A material, or one from its shear modulus and Poisson's ratio."""
    if not isinstance(given, (tuple, list)):
        return given
    if len(given) != 2:
        raise ValueError(f"{name}: the shear modulus [Pa] and Poisson's ratio are needed, and these are {len(given)} numbers")
    return make(Material, np.float64, shear_modulus=given[0], poisson_ratio=given[1])


def _of_bodies(radii: Any, pair: Any, amount: Any, friction: Any, on_error: str, name: str) -> Elements:
    return Elements(is_single(radii, pair), on_error, radii=(Radii, radii), pair=(CombinedMaterial, pair), **{name: (float, amount)},
                    friction=(float, friction))


def contact_from_hertz(radii: Many[Radii], pair: Many[CombinedMaterial], load: ArrayLike, friction: ArrayLike,
                       on_error: str = "raise") -> tuple[Any, Any]:
    """Contacts of bodies that loads [N] press together, and their ellipses; all four arguments broadcast.

    >>> steel = kstrip.combine((82e9, 0.28), (82e9, 0.28))
    >>> contact, ellipse = kstrip.contact_from_hertz(kstrip.radii(lower_y=0.3, upper_x=0.46), steel, 80e3, 0.3)
    >>> print(f"{1e3 * contact.a:.2f} mm, {1e-6 * ellipse.peak_pressure:.0f} MPa")
    6.68 mm, 1139 MPa
    """
    elements = _of_bodies(radii, pair, load, friction, on_error, "load")
    (contacts, first), (ellipses, second) = elements.out("contact"), elements.out("hertz_contact")
    found = elements.run("kstrip_contact_from_hertz", *elements.columns.values(), first, second)
    statuses = elements.statuses(found, contacts, ellipses)
    return elements.report((elements.result(Contact, contacts, statuses), elements.result(HertzContact, ellipses, statuses)), statuses)


def contact_from_approach(radii: Many[Radii], pair: Many[CombinedMaterial], approach: ArrayLike, friction: ArrayLike,
                          on_error: str = "raise") -> tuple[Any, Any]:
    """Contacts of bodies that have approached each other [m], and their stiffness dN/d(approach) [N/m]; arguments broadcast.

    >>> balls = kstrip.radii(upper_x=0.1, upper_y=0.1)
    >>> contact, stiffness = kstrip.contact_from_approach(balls, kstrip.combine((82e9, 0.28), (82e9, 0.28)), 50e-6, 0.3)
    >>> print(f"{contact.normal_force:.0f} N, {1e-6 * stiffness:.0f} N/um")
    16978 N, 509 N/um
    """
    elements = _of_bodies(radii, pair, approach, friction, on_error, "approach")
    (contacts, first), (stiffness, second) = elements.out("contact"), elements.real()
    found = elements.run("kstrip_contact_from_approach", *elements.columns.values(), first, second)
    statuses = elements.statuses(found, contacts, stiffness)
    return elements.report((elements.result(Contact, contacts, statuses), elements.numbers(stiffness)), statuses)


def linear_coefficients(axis_ratio: float, poisson_ratio: float) -> NDArray[np.float64]:
    """Kalker's C11, C22, C23, C33 of the linear theory, shape (4,), for an axis ratio a/b.

    >>> kstrip.linear_coefficients(1.0, 0.25).round(2)
    array([4.11, 3.67, 1.46, 1.19])
    """
    made = np.zeros(4)
    call("kstrip_linear_coefficients", False, number(axis_ratio, "axis_ratio"), number(poisson_ratio, "poisson_ratio"), made)
    return made


def creepage_from_velocities(lower: Many[Velocity], upper: Many[Velocity], rolling_speed: ArrayLike, on_error: str = "raise") -> Any:
    """Creepages from the velocities of both bodies, (upper - lower)/rolling_speed, at rolling speeds [m/s] above zero; arguments broadcast.

    >>> kstrip.creepage_from_velocities(kstrip.velocity(-20.0), kstrip.velocity(-19.98, 0.01), 20.0)
    Creepage(longitudinal=0.001, lateral=0.0005, spin=0 1/m)
    """
    elements = Elements(is_single(lower, upper), on_error, lower=(Velocity, lower), upper=(Velocity, upper), rolling_speed=(float, rolling_speed))
    return _answer(elements, "kstrip_creepage_from_velocities", Creepage, *elements.columns.values())


def parameters_from_creepage(contacts: Many[Contact], creepages: Many[Creepage], on_error: str = "raise") -> Any:
    """Kalker's dimensionless xi, eta, psi (5.13); contacts and creepages broadcast.

    >>> contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    >>> print(f"psi = {kstrip.parameters_from_creepage(contact, kstrip.creepage(spin=1.0)).psi:.3f}")
    psi = 0.580
    """
    elements = Elements(is_single(contacts, creepages), on_error, contacts=(Contact, contacts), creepages=(Creepage, creepages))
    return _answer(elements, "kstrip_parameters_from_creepage", Parameters, *elements.columns.values())


def creepage_from_parameters(contacts: Many[Contact], parameters: Many[Parameters], on_error: str = "raise") -> Any:
    """The creepages that have the given xi, eta, psi; contacts and parameters broadcast.

    >>> contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    >>> print(f"{kstrip.creepage_from_parameters(contact, kstrip.parameters(xi=1.0)).longitudinal:.5f}")
    0.00745
    """
    elements = Elements(is_single(contacts, parameters), on_error, contacts=(Contact, contacts), parameters=(Parameters, parameters))
    return _answer(elements, "kstrip_creepage_from_parameters", Creepage, *elements.columns.values())
