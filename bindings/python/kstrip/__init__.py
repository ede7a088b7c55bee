"""Creep forces of rolling contact by Kalker's strip theory, with numpy in and out.

    import numpy as np, kstrip
    contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    curve = kstrip.solve(contact, kstrip.creepage(longitudinal=np.linspace(0, 0.01, 200)))   # curve["fx"] in N

SI units; forces act on the LOWER body (the rail) and have the sense of the creepage: see kstrip.h, from which this module
makes itself when it is imported. Structures are numpy records with the members of their C namesakes; arrays of any shape
broadcast. Errors raise kstrip.Error; warnings are in the member `status_detail` of a result.

The library is looked for at $KSTRIP_LIBRARY, next to this file, in target/lib of the repository, and where the system
finds libraries; the header at $KSTRIP_HEADER, next to this file, and in the repository.
"""

import ctypes
import ctypes.util
import os
import pathlib
import sys

import numpy as np

from . import _header

_here = pathlib.Path(__file__).resolve().parent
_repository = _here.parents[2]


def _read_header():
    places = [os.environ.get("KSTRIP_HEADER"), _here / "kstrip.h", _repository / "include" / "kstrip.h"]
    for place in places:
        if place and os.path.exists(place):
            return pathlib.Path(place).read_text(encoding="utf-8")
    raise ImportError("kstrip.h was not found: set KSTRIP_HEADER")


def _load():
    name = {"darwin": "libkstrip.dylib", "win32": "kstrip.dll"}.get(sys.platform, "libkstrip.so")
    places = [
        os.environ.get("KSTRIP_LIBRARY"),
        _here / name,
        _repository / "target" / "lib" / name,
        f"{name}.{constants['KSTRIP_ABI_VERSION']}",
        ctypes.util.find_library("kstrip"),
    ]
    for place in places:
        # A bare name is the linker's to find.
        if place and (os.path.exists(place) or os.sep not in str(place)):
            try:
                return ctypes.CDLL(str(place))
            except OSError:
                continue
    raise ImportError("libkstrip was not found: run `make` in the repository, `make install`, or set KSTRIP_LIBRARY")


_text = _read_header()
#: KSTRIP_NAME: value, of the header
constants = _header.constants(_text)
#: The C structures by name, as ctypes
structures = _header.structures(_text)
#: Their numpy types: `dtypes["contact"]`, `dtypes["contact_f32"]`
dtypes = {name.removeprefix("kstrip_"): np.dtype(structure) for name, structure in structures.items()}
#: The C library; every function of the header with its argument types: `lib.kstrip_solve`
lib = _load()
for _name, _result, _arguments, _doc in _header.functions(_text, structures):
    _function = getattr(lib, _name)
    _function.restype, _function.argtypes, _function.__doc__ = _result, _arguments, _doc
if lib.kstrip_abi_version() != constants["KSTRIP_ABI_VERSION"]:
    raise ImportError(f"libkstrip has ABI version {lib.kstrip_abi_version()}, not that of the header")

__version__ = lib.kstrip_version_string().decode()
#: "strip": 3, ... the numbers of the models
models = {k.removeprefix("KSTRIP_MODEL_").lower(): v for k, v in constants.items() if k.startswith("KSTRIP_MODEL_")}
OUTSIDE, STICK, SLIP, SLIP_NEGATIVE_DISSIPATION = range(4)


class Error(ValueError):
    """A negative status; `status` is its number."""

    def __init__(self, status):
        super().__init__(lib.kstrip_status_string(status).decode())
        self.status = status


def _check(status):
    if status < 0:
        raise Error(status)
    return status


def _record(name, dtype, **members):
    """An array of structures from numbers and arrays that broadcast."""
    kind = dtypes[name if np.dtype(dtype) == np.float64 else f"{name}_f32"]
    unknown = set(members) - set(kind.names)
    missing = set(kind.names) - set(members)
    if unknown or missing:
        raise TypeError(f"{name}: unknown {sorted(unknown)}, missing {sorted(missing)}")
    made = np.zeros(np.broadcast_shapes(*(np.shape(value) for value in members.values())), kind)
    for member, value in members.items():
        made[member] = value
    return made


def contact(*, a, b, normal_force, shear_modulus, poisson_ratio, friction, dtype=np.float64):
    """Contacts: semi-axes a along and b across the rolling direction [m], load [N], combined G [Pa], nu, mu."""
    return _record("contact", dtype, a=a, b=b, normal_force=normal_force, shear_modulus=shear_modulus,
                   poisson_ratio=poisson_ratio, friction=friction)


def creepage(longitudinal=0.0, lateral=0.0, spin=0.0, dtype=np.float64):
    """Creepages [-] and spin [1/m] of the upper over the lower body."""
    return _record("creepage", dtype, longitudinal=longitudinal, lateral=lateral, spin=spin)


def _options(model, strips):
    number = models[model] if isinstance(model, str) else model
    return ctypes.byref(structures["kstrip_options"](number, strips))


def _function_for(name, array):
    single = array.dtype.names and array.dtype in (dtypes["contact_f32"], dtypes["creepage_f32"])
    return getattr(lib, f"{name}_f32" if single else name), "_f32" if single else ""


def _pairs(contacts, creepages):
    contacts, creepages = np.broadcast_arrays(contacts, creepages)
    return contacts.shape, np.ascontiguousarray(contacts).ravel(), np.ascontiguousarray(creepages).ravel()


def solve(contacts, creepages, model="strip", strips=16):
    """Forces on the lower body, by kstrip_solve_batch(): fx, fy [N], mz [N m], power [N], adhesion, status_detail."""
    shape, contacts, creepages = _pairs(contacts, creepages)
    call, suffix = _function_for("kstrip_solve_batch", contacts)
    results = np.zeros(contacts.size, dtypes["result" + suffix])
    _check(call(contacts.ctypes.data, creepages.ctypes.data, contacts.size, _options(model, strips), results.ctypes.data))
    return results.reshape(shape)


def solve_jacobian(contacts, creepages, model="strip", strips=16):
    """Forces, and d(fx, fy, mz)/d(longitudinal, lateral, spin) with shape (..., 3, 3)."""
    shape, contacts, creepages = _pairs(contacts, creepages)
    call, suffix = _function_for("kstrip_solve_jacobian_batch", contacts)
    results = np.zeros(contacts.size, dtypes["result" + suffix])
    slopes = np.zeros((contacts.size, 3, 3), np.float32 if suffix else np.float64)
    _check(call(contacts.ctypes.data, creepages.ctypes.data, contacts.size, _options(model, strips), results.ctypes.data,
                slopes.ctypes.data))
    return results.reshape(shape), slopes.reshape(*shape, 3, 3)


def friction(friction, ratio=1.0, decay=0.0, rolling_speed=0.0, slope_factor=1.0, dtype=np.float64):
    """Friction that falls with the slip: mu0, A, B [s/m], rolling speed [m/s]; and the factor of the initial slope."""
    return _record("friction", dtype, friction=friction, ratio=ratio, decay=decay, rolling_speed=rolling_speed, slope_factor=slope_factor)


def solve_friction(contacts, creepages, frictions, model="strip", strips=16):
    """Forces under friction(), and the coefficient of friction that agrees with the slip."""
    contacts, creepages, frictions = np.broadcast_arrays(contacts, creepages, frictions)
    shape = contacts.shape
    contacts, creepages, frictions = (np.ascontiguousarray(v).ravel() for v in (contacts, creepages, frictions))
    call, suffix = _function_for("kstrip_solve_friction", contacts)
    results = np.zeros(contacts.size, dtypes["result" + suffix])
    effective = np.zeros(contacts.size, np.float32 if suffix else np.float64)
    options = _options(model, strips)
    for i in range(contacts.size):
        _check(call(contacts[i:].ctypes.data, creepages[i:].ctypes.data, frictions[i:].ctypes.data, options, results[i:].ctypes.data,
                    effective[i:].ctypes.data))
    return results.reshape(shape), effective.reshape(shape)


def strips(one_contact, one_creepage, model="strip", strips=16):
    """What each strip of one contact carries."""
    _, contacts, creepages = _pairs(one_contact, one_creepage)
    call, suffix = _function_for("kstrip_strips", contacts)
    capacity = constants["KSTRIP_STRIPS_CAPACITY"]
    found = np.zeros(capacity, dtypes["strip" + suffix])
    count = ctypes.c_uint32()
    _check(call(contacts.ctypes.data, creepages.ctypes.data, _options(model, strips), found.ctypes.data, capacity, ctypes.byref(count)))
    return found[: count.value]


def field(one_contact, one_creepage, x, y, model="strip", strips=16):
    """Pressure, traction, slip, dissipation and state of one contact at all (x[i], y[j]) [m]; element [j, i]."""
    _, contacts, creepages = _pairs(one_contact, one_creepage)
    call, suffix = _function_for("kstrip_field", contacts)
    x, y = (np.ascontiguousarray(v, np.float32 if suffix else np.float64).ravel() for v in (x, y))
    points = np.zeros((y.size, x.size), dtypes["point" + suffix])
    _check(call(contacts.ctypes.data, creepages.ctypes.data, _options(model, strips), x.ctypes.data, x.size, y.ctypes.data, y.size,
                points.ctypes.data, points.size))
    return points


def patch_from_profile(y, distance, *, rolling_radius, normal_force, shear_modulus, poisson_ratio, friction, strips=32):
    """A patch of any shape, from the distance [m] of two undeformed profiles over y [m] (Kik and Piotrowski).

    Returns the patch, whose members may be changed (friction per strip), and how the profiles meet.
    """
    y, distance = (np.ascontiguousarray(v, np.float64).ravel() for v in (y, distance))
    load = structures["kstrip_profile_contact"](rolling_radius, normal_force, shear_modulus, poisson_ratio, friction)
    patch, found = np.zeros((), dtypes["patch"]), np.zeros((), dtypes["profile_result"])
    if y.size != distance.size:
        raise ValueError("y and distance have different sizes")
    _check(lib.kstrip_patch_from_profile(y.ctypes.data, distance.ctypes.data, y.size, ctypes.byref(load), strips, patch.ctypes.data, found.ctypes.data))
    return patch, found


def patch_solve(patch, creepages, model="strip"):
    """Forces of one patch for one or many creepages."""
    creepages = np.asarray(creepages)
    flat = np.ascontiguousarray(creepages).ravel()
    results = np.zeros(flat.size, dtypes["result"])
    options = _options(model, 16)
    for i in range(flat.size):
        _check(lib.kstrip_patch_solve(patch.ctypes.data, flat[i:].ctypes.data, options, results[i:].ctypes.data))
    return results.reshape(creepages.shape)


def patch_solve_friction(patch, creepages, law, model="strip"):
    """Forces of one patch whose friction falls with the slip (friction(), its own mu0 unused), for one or many creepages; and the
    share of the strips' friction that is left."""
    creepages = np.asarray(creepages)
    flat, law = np.ascontiguousarray(creepages).ravel(), np.ascontiguousarray(law)
    results, shares = np.zeros(flat.size, dtypes["result"]), np.zeros(flat.size)
    options = _options(model, 16)
    for i in range(flat.size):
        _check(lib.kstrip_patch_solve_friction(patch.ctypes.data, flat[i:].ctypes.data, law.ctypes.data, options, results[i:].ctypes.data,
                                               shares[i:].ctypes.data))
    return results.reshape(creepages.shape), shares.reshape(creepages.shape)


def combine(lower, upper):
    """Combined (shear modulus [Pa], Poisson's ratio, mismatch) of two bodies (shear modulus, Poisson's ratio)."""
    made = structures["kstrip_combined_material"]()
    material = structures["kstrip_material"]
    _check(lib.kstrip_material_combine(ctypes.byref(material(*lower)), ctypes.byref(material(*upper)), ctypes.byref(made)))
    return made.shear_modulus, made.poisson_ratio, made.mismatch


def hertz(*, lower_x, lower_y, upper_x, upper_y, normal_force, shear_modulus, poisson_ratio):
    """Contact ellipse of Hertz from radii [m], load [N] and combined constants: a, b, peak_pressure, approach, ..."""
    radii = structures["kstrip_radii"](lower_x, lower_y, upper_x, upper_y)
    pair = structures["kstrip_combined_material"](shear_modulus, poisson_ratio, 0.0)
    ellipse = np.zeros((), dtypes["hertz_contact"])
    _check(lib.kstrip_hertz(ctypes.byref(radii), normal_force, ctypes.byref(pair), ellipse.ctypes.data))
    return ellipse


def on_upper_body(results):
    """The same results seen from the upper body (the wheel): opposite forces and moment."""
    turned = np.array(results)
    for member in ("fx", "fy", "mz"):
        turned[member] = -turned[member]
    return turned
