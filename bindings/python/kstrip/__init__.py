"""Creep forces of rolling contact by Kalker's strip theory, with numpy in and out.

    import numpy as np, kstrip
    contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    curve = kstrip.solve(contact, kstrip.creepage(longitudinal=np.linspace(0, 0.01, 200)))   # curve["fx"] in N

SI units; forces act on the LOWER body (the rail) and have the sense of the creepage: see kstrip.h, from which this module
makes itself when it is imported. Structures are numpy records with the members of their C namesakes; arrays of any shape
broadcast. Every input is checked and converted; single precision is used where all records are single. Errors raise
KstripError, warnings are Python warnings of the class KstripWarning, and in the member `status_detail` of each result.

The library is looked for at $KSTRIP_LIBRARY, next to this file, in target/lib of the repository, and where the system
finds libraries; the headers at $KSTRIP_HEADER, next to this file, and in the repository.
"""

from __future__ import annotations

import ctypes
import ctypes.util
import operator
import os
import pathlib
import sys
import warnings
from typing import Any, Callable, NamedTuple, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _header

_here = pathlib.Path(__file__).resolve().parent
_repository = _here.parents[2]


def _read_headers() -> str:
    places = [os.environ.get("KSTRIP_HEADER"), _here / "kstrip.h", _repository / "include" / "kstrip.h"]
    for place in places:
        if place and os.path.exists(place):
            first = pathlib.Path(place)
            return "".join(p.read_text(encoding="utf-8") for p in (first, first.with_name("kstrip_f32.h")))
    raise ImportError("kstrip.h was not found: set KSTRIP_HEADER")


def _load() -> ctypes.CDLL:
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


_text = _read_headers()
#: KSTRIP_NAME: value, of the header
constants: dict[str, int] = _header.constants(_text)
#: The C structures by name, as ctypes
structures: dict[str, type] = _header.structures(_text)
#: Their numpy types: `dtypes["contact"]`, `dtypes["contact_f32"]`
dtypes: dict[str, np.dtype] = {name.removeprefix("kstrip_"): np.dtype(s) for name, s in structures.items()}
#: The C library itself, unchecked; every function of the headers with its argument types: `lib.kstrip_solve`
lib = _load()
for _name, _result, _arguments, _doc in _header.functions(_text, structures):
    _function = getattr(lib, _name)
    _function.restype, _function.argtypes, _function.__doc__ = _result, _arguments, _doc
if lib.kstrip_abi_version() != constants["KSTRIP_ABI_VERSION"]:
    raise ImportError(f"libkstrip has ABI version {lib.kstrip_abi_version()}, not that of the header")

__version__: str = lib.kstrip_version_string().decode()
#: "total": 4, ... the numbers of the models
models: dict[str, int] = {
    k.removeprefix("KSTRIP_MODEL_").lower(): v for k, v in constants.items() if k.startswith("KSTRIP_MODEL_")
}
OUTSIDE, STICK, SLIP, SLIP_NEGATIVE_DISSIPATION = range(4)
FX, FY = constants["KSTRIP_MEASURED_FX"], constants["KSTRIP_MEASURED_FY"]
_statuses = {v: k for k, v in constants.items() if k.startswith(("KSTRIP_WARNING_", "KSTRIP_ERROR_"))}

Records = NDArray[np.void]
Model = Union[str, int]


# Errors and warnings


def _says(status: int, index: Optional[tuple]) -> str:
    where = f" at index {index if len(index) > 1 else index[0]}" if index else ""
    return f"{_statuses.get(status, status)}{where}: {lib.kstrip_status_string(status).decode()}"


class KstripError(ValueError):
    """A negative status: its number, its name in the header, and for arrays the index of the first bad input."""

    def __init__(self, status: int, index: Optional[tuple] = None):
        super().__init__(_says(status, index))
        self.status, self.name, self.index = status, _statuses.get(status, ""), index


class KstripWarning(RuntimeWarning):
    """A positive status: the outputs are valid, and the message says what the caller should know."""


def _gravity(status: int) -> tuple[int, int]:
    """Of several warnings the one with the largest gravity is told, in the order of kstrip.h."""
    rank = {"NOT_CONVERGED": 5, "SEVERAL_FRICTIONS": 4, "FRICTION_AT_LEAST": 3, "CREEPAGE_AT_LEAST": 3, "PRESSURE": 2, "CREEPAGE": 2,
            "SEMI_AXIS": 2, "SPIN_UNIT": 2, "FRICTION": 2, "RADIUS": 2, "BEYOND_FRICTION": 1, "ANGLE_RANGE": 1, "PROFILE_END": 1}
    return (rank.get(_statuses.get(status, "").removeprefix("KSTRIP_WARNING_"), 0) if status > 0 else -1), status


def _report(status: int, index: Optional[tuple] = None) -> None:
    """Raises or warns; the warning names the line of the user that called the binding."""
    if status < 0:
        raise KstripError(status, index)
    if status > 0:
        warnings.warn(KstripWarning(_says(status, index)), stacklevel=4)


# Inputs: whatever comes in leaves as aligned, contiguous records of one precision


def _numbers(value: ArrayLike, what: str) -> np.ndarray:
    array = np.asarray(value)
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{what}: real numbers are needed, not {array.dtype}")
    return array


def _floats(value: ArrayLike, what: str, single: bool) -> np.ndarray:
    with np.errstate(over="ignore"):
        return np.require(_numbers(value, what), np.float32 if single else np.float64, ["C", "A"])


def _record(name: str, dtype: DTypeLike, **members: ArrayLike) -> Records:
    """An array of structures from numbers and arrays that broadcast."""
    if np.dtype(dtype) not in (np.dtype(np.float64), np.dtype(np.float32)):
        raise TypeError(f"{name}: dtype is float64 or float32, not {np.dtype(dtype)}")
    kind = dtypes[name if np.dtype(dtype) == np.float64 else f"{name}_f32"]
    values = {member: _numbers(value, f"{name}.{member}") for member, value in members.items()}
    made = np.zeros(np.broadcast_shapes(*(value.shape for value in values.values())), kind)
    for member, value in values.items():
        with np.errstate(over="ignore"):
            made[member] = value
    return made


def _array(value: Any) -> np.ndarray:
    """An array of whatever it is; of objects where numpy makes nothing of it."""
    try:
        return np.asarray(value)
    except ValueError:
        return np.asarray(None)


def _single(*values: Any) -> bool:
    """Whether all records have the structure of single precision."""
    singles = [dtype for name, dtype in dtypes.items() if name.endswith("_f32")]
    return all(_array(value).dtype in singles for value in values if value is not None)


def _seen(value: Any) -> str:
    """What an argument is, for messages."""
    dtype = _array(value).dtype
    for name, kind in dtypes.items():
        if kind == dtype:
            return f"kstrip.{name.removesuffix('_f32')}()"
    if dtype.names is not None:
        return f"a record of {', '.join(dtype.names)}"
    return f"an array of {dtype}" if isinstance(value, np.ndarray) else f"a {type(value).__name__}"


def _maker(name: str, members: str) -> str:
    """Where records of a structure come from, for messages."""
    makers = {"combined_material": "combine()", "patch": "patch_from_profile(), patch_from_strips() or patch_from_contact()",
              "prepared": "prepare()"}
    return f"kstrip.{makers.get(name, f'{name}({members})')}"


def _records(name: str, value: Any, single: bool) -> Records:
    """Records of this structure and precision; a copy if anything about them differs."""
    kind, given = dtypes[name + "_f32" * single], _array(value)
    if given.dtype == kind:
        return np.require(given, requirements=["C", "A"])
    members, seen = ", ".join(kind.names), _seen(value)
    if given.dtype.names is None or seen.startswith("kstrip.") and seen != f"kstrip.{name}()":
        raise TypeError(f"{name}: make it with {_maker(name, members)}; this is {seen}")
    for member in kind.names:
        if member not in given.dtype.names:
            raise TypeError(f"{name}: the field {member} is missing; this is {seen}")
    for member in given.dtype.names:
        if member not in kind.names:
            raise TypeError(f"{name}: there is no field {member}; the fields are {members}")
    made = np.zeros(given.shape, kind)
    for member in kind.names:
        if kind[member].base.names:
            made[member] = _records("patch_strip", given[member], single)
        else:
            part = _numbers(given[member], f"{name}.{member}")
            if part.shape != made[member].shape:
                raise TypeError(f"{name}.{member}: each has the shape {part.shape[given.ndim:]}, not {kind[member].shape}")
            with np.errstate(over="ignore", invalid="ignore"):
                made[member] = part
    return made


def _flat(value: np.ndarray, shape: tuple) -> tuple[np.ndarray, int]:
    """The elements one after the other, and the distance of two in bytes: 0 if there is one for all."""
    if value.size == 1 and value.shape != shape:
        return value.reshape(-1), 0
    return np.require(np.broadcast_to(value, shape), requirements=["C", "A"]).reshape(-1), value.dtype.itemsize


def _one(name: str, value: Any, single: bool) -> Records:
    record = _records(name, value, single)
    if record.size != 1:
        raise ValueError(f"{name}: one is needed, not {record.size}")
    return record.reshape(())


def _count(size: int) -> int:
    if size > 0xFFFFFFFF:
        raise ValueError(f"{size} elements are more than 4294967295 in one call")
    return size


def _options(model: Model, strips: int) -> Any:
    if isinstance(model, str) and model not in models:
        raise ValueError(f"unknown model {model!r}: one of {', '.join(models)}")
    numbers = [models[model] if isinstance(model, str) else operator.index(model), operator.index(strips)]
    # Numbers that 32 bits cannot hold are as unknown as -1
    return structures["kstrip_options"](*(n if abs(n) < 1 << 31 else -1 for n in numbers))


def _function_of(name: str, single: bool) -> Callable[..., int]:
    return getattr(lib, name + "_f32" * single)


def _call(name: str, single: bool, *arguments: Any) -> None:
    """One call: arrays go as addresses."""
    _report(_function_of(name, single)(*(a.ctypes.data if isinstance(a, np.ndarray) else a for a in arguments)))


def _each(name: str, single: bool, shape: tuple, *arguments: Any) -> None:
    """A call for each element of the arrays in the tuples (array, distance in bytes); other arguments are for all."""
    call, worst, at = _function_of(name, single), 0, 0
    for i in range(int(np.prod(shape))):
        status = call(*(a[0].ctypes.data + i * a[1] if isinstance(a, tuple) else a for a in arguments))
        if status < 0 or _gravity(status) > _gravity(worst):
            worst, at = status, i
        if status < 0:
            break
    _report(worst, tuple(int(k) for k in np.unravel_index(at, shape)) if shape and worst else None)


def _out(name: str, shape: tuple, single: bool) -> tuple[np.ndarray, int]:
    made = np.zeros(int(np.prod(shape)), dtypes[name + "_f32" * single])
    return made, made.dtype.itemsize


# Structures


def contact(*, a: ArrayLike, b: ArrayLike, normal_force: ArrayLike, shear_modulus: ArrayLike, poisson_ratio: ArrayLike,
            friction: ArrayLike, mismatch: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Records:
    """Contacts: semi-axes a along and b across the rolling direction [m], load [N], combined G [Pa], nu, mu, mismatch of the materials."""
    return _record("contact", dtype, a=a, b=b, normal_force=normal_force, shear_modulus=shear_modulus,
                   poisson_ratio=poisson_ratio, friction=friction, mismatch=mismatch)


def creepage(longitudinal: ArrayLike = 0.0, lateral: ArrayLike = 0.0, spin: ArrayLike = 0.0,
             dtype: DTypeLike = np.float64) -> Records:
    """Creepages [-] and spin [1/m] of the upper over the lower body."""
    return _record("creepage", dtype, longitudinal=longitudinal, lateral=lateral, spin=spin)


def friction(friction: ArrayLike, ratio: ArrayLike = 1.0, decay: ArrayLike = 0.0, rolling_speed: ArrayLike = 0.0,
             slope_factor: ArrayLike = 1.0, dtype: DTypeLike = np.float64) -> Records:
    """Friction that falls with the slip: mu0, A, B [s/m], rolling speed [m/s]; and the factor of the initial slope."""
    return _record("friction", dtype, friction=friction, ratio=ratio, decay=decay, rolling_speed=rolling_speed,
                   slope_factor=slope_factor)


def motion(slip_x: ArrayLike = 0.0, slip_y: ArrayLike = 0.0, spin_rate: ArrayLike = 0.0, rolling_speed: ArrayLike = 0.0,
           floor_speed: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Records:
    """Slip [m/s], spin rate [rad/s], signed rolling speed and floor of the speed [m/s], for solve_motion()."""
    return _record("motion", dtype, slip_x=slip_x, slip_y=slip_y, spin_rate=spin_rate, rolling_speed=rolling_speed,
                   floor_speed=floor_speed)


def radii(lower_x: ArrayLike = np.inf, lower_y: ArrayLike = np.inf, upper_x: ArrayLike = np.inf,
          upper_y: ArrayLike = np.inf, dtype: DTypeLike = np.float64) -> Records:
    """Radii of curvature [m]: convex positive, flat infinite, concave negative."""
    return _record("radii", dtype, lower_x=lower_x, lower_y=lower_y, upper_x=upper_x, upper_y=upper_y)


def velocity(x: ArrayLike = 0.0, y: ArrayLike = 0.0, angular_z: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Records:
    """Velocity of a body's material at the contact [m/s, m/s, rad/s]."""
    return _record("velocity", dtype, x=x, y=y, angular_z=angular_z)


def parameters(xi: ArrayLike = 0.0, eta: ArrayLike = 0.0, psi: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Records:
    """Kalker's dimensionless parameters (5.13)."""
    return _record("parameters", dtype, xi=xi, eta=eta, psi=psi)


def patch_strip(*, y: ArrayLike, width: ArrayLike, half_length: ArrayLike, peak_pressure: ArrayLike, friction: ArrayLike,
                centre_x: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Records:
    """Strips of a patch of any shape [m, m, m, Pa, -, m]."""
    return _record("patch_strip", dtype, y=y, width=width, half_length=half_length, centre_x=centre_x,
                   peak_pressure=peak_pressure, friction=friction)


# Bodies


def combine(lower: Sequence[float], upper: Sequence[float], dtype: DTypeLike = np.float64) -> Records:
    """Combined shear_modulus [Pa], poisson_ratio, mismatch of two bodies (shear modulus, Poisson's ratio)."""
    both = [_record("material", dtype, shear_modulus=g, poisson_ratio=nu) for g, nu in (lower, upper)]
    single = _single(*both)
    both = [_one("material", body, single) for body in both]
    made = np.zeros((), dtypes["combined_material" + "_f32" * single])
    _call("kstrip_material_combine", single, *both, made)
    return made


def _from_bodies(name: str, curvatures: Any, pair: Any, amount: ArrayLike, friction: ArrayLike, also: str) -> tuple:
    single = _single(curvatures, pair)
    curvatures, pair = _records("radii", curvatures, single), _records("combined_material", pair, single)
    amount, friction = (np.broadcast_arrays(_floats(amount, "load or approach", single), _floats(friction, "friction", single)))
    shape = np.broadcast_shapes(curvatures.shape, pair.shape, amount.shape)
    curvatures, pair = _flat(curvatures, shape), _flat(pair, shape)
    amount, friction = (np.broadcast_to(v, shape).reshape(-1) for v in (amount, friction))
    contacts = _out("contact", shape, single)
    seconds = _out(also, shape, single) if also else (np.zeros(amount.size, amount.dtype), amount.itemsize)
    call, worst, at = _function_of(name, single), 0, 0
    for i in range(amount.size):
        status = call(curvatures[0].ctypes.data + i * curvatures[1], pair[0].ctypes.data + i * pair[1], float(amount[i]),
                      float(friction[i]), contacts[0].ctypes.data + i * contacts[1], seconds[0].ctypes.data + i * seconds[1])
        if status < 0 or _gravity(status) > _gravity(worst):
            worst, at = status, i
        if status < 0:
            break
    _report(worst, tuple(int(k) for k in np.unravel_index(at, shape)) if shape and worst else None)
    return contacts[0].reshape(shape), seconds[0].reshape(shape)


def contact_from_hertz(radii: Records, pair: Records, load: ArrayLike, friction: ArrayLike) -> tuple[Records, Records]:
    """Contacts of two bodies that loads [N] press together, and their ellipses: peak_pressure, approach, ..."""
    return _from_bodies("kstrip_contact_from_hertz", radii, pair, load, friction, "hertz_contact")


def contact_from_approach(radii: Records, pair: Records, approach: ArrayLike,
                          friction: ArrayLike) -> tuple[Records, np.ndarray]:
    """Contacts of two bodies that have approached each other [m], and their stiffness dN/d(approach) [N/m]."""
    return _from_bodies("kstrip_contact_from_approach", radii, pair, approach, friction, "")


def linear_coefficients(axis_ratio: float, poisson_ratio: float) -> np.ndarray:
    """Kalker's C11, C22, C23, C33."""
    made = np.zeros(4)
    _call("kstrip_linear_coefficients", False, float(axis_ratio), float(poisson_ratio), made)
    return made


# Motion


def creepage_from_velocities(lower: Records, upper: Records, rolling_speed: float) -> Records:
    """Creepages from the velocities of both bodies at a rolling speed [m/s] above zero."""
    single = _single(lower, upper)
    lower, upper = _records("velocity", lower, single), _records("velocity", upper, single)
    shape = np.broadcast_shapes(lower.shape, upper.shape)
    made = _out("creepage", shape, single)
    _each("kstrip_creepage_from_velocities", single, shape, _flat(lower, shape), _flat(upper, shape), float(rolling_speed), made)
    return made[0].reshape(shape)


def parameters_from_creepage(contacts: Records, creepages: Records) -> Records:
    """Kalker's xi, eta, psi (5.13)."""
    single = _single(contacts, creepages)
    contacts, creepages = _records("contact", contacts, single), _records("creepage", creepages, single)
    shape = np.broadcast_shapes(contacts.shape, creepages.shape)
    made = _out("parameters", shape, single)
    _each("kstrip_parameters_from_creepage", single, shape, _flat(contacts, shape), _flat(creepages, shape), made)
    return made[0].reshape(shape)


def creepage_from_parameters(contacts: Records, parameters: Records) -> Records:
    """The creepages that have the given xi, eta, psi."""
    single = _single(contacts, parameters)
    contacts, numbers = _records("contact", contacts, single), _records("parameters", parameters, single)
    shape = np.broadcast_shapes(contacts.shape, numbers.shape)
    made = _out("creepage", shape, single)
    _each("kstrip_creepage_from_parameters", single, shape, _flat(contacts, shape), _flat(numbers, shape), made)
    return made[0].reshape(shape)


# Solve


class Evaluation(NamedTuple):
    """The results of evaluate() and solve_motion(); None where one was not asked for."""

    #: fx, fy [N], mz [N m], power [N; of a motion W], adhesion, status_detail
    result: Records
    #: the coefficient of friction that agrees with the slip; of a patch the factor that its strips have in common
    friction: np.ndarray
    #: jacobian, normal_force, load_through_hertz, friction; of a motion slip, rolling_speed, ...
    derivatives: Optional[Records]
    #: ratio, decay, rolling_speed, slope_factor; of a motion they are in `derivatives`
    law_derivatives: Optional[Records]


def _is_patch(area: Any) -> bool:
    return _array(area).dtype in (dtypes["patch"], dtypes["patch_f32"])


def _batch(contacts: Any, creepages: Any, law: Any, model: Model, strips: int, wanted: tuple) -> dict[str, np.ndarray]:
    """kstrip_evaluate_batch(): one call for all elements."""
    single, suffix = _single(contacts, creepages, law), "_f32" * _single(contacts, creepages, law)
    records = [_records("contact", contacts, single), _records("creepage", creepages, single)]
    if law is not None:
        records.append(_records("friction", law, single))
    shape = np.broadcast_shapes(*(record.shape for record in records))
    count = _count(int(np.prod(shape)))
    kept = [_flat(record, shape) for record in records]
    inputs = structures["kstrip_batch_inputs" + suffix]()
    for array, distance in kept[:2]:
        for member in array.dtype.names:
            setattr(inputs, member, array.ctypes.data + array.dtype.fields[member][1])
            setattr(inputs, f"{member}_stride", distance)
    if law is not None:
        inputs.law, inputs.law_stride = kept[2][0].ctypes.data, kept[2][1]
    made = {"result": np.zeros(count, dtypes["result" + suffix])}
    if "friction" in wanted:
        made["friction"] = np.zeros(count, np.float32 if single else np.float64)
    for name in ("derivatives", "law_derivatives"):
        if name in wanted:
            made[name] = np.zeros(count, dtypes[name + suffix])
    outputs = structures["kstrip_batch_outputs" + suffix]()
    places = {m: (made["result"], made["result"].dtype.fields[m][1]) for m in made["result"].dtype.names if m != "reserved"}
    places |= {name: (array, 0) for name, array in made.items() if name != "result"}
    for member, (array, offset) in places.items():
        setattr(outputs, member, array.ctypes.data + offset)
        setattr(outputs, f"{member}_stride", array.dtype.itemsize)
    bad = ctypes.c_uint32()
    status = _function_of("kstrip_evaluate_batch", single)(
        ctypes.byref(inputs), count, ctypes.byref(_options(model, strips)), ctypes.byref(outputs), ctypes.byref(bad))
    first = bad.value if status < 0 else int(np.argmax(made["result"]["status_detail"] == status)) if status else 0
    index = tuple(int(k) for k in np.unravel_index(first, shape)) if shape and status and first < count else None
    _report(status, index)
    return {name: array.reshape(shape) for name, array in made.items()}


def solve(contacts: Records, creepages: Records, friction: Optional[Records] = None, model: Model = "default",
          strips: int = 0) -> Records:
    """Forces on the lower body: fx, fy [N], mz [N m], power [N], adhesion, status_detail.

    `friction`: a law of friction() that falls with the slip. For a patch the results are those of kstrip_patch_evaluate().
    """
    if _is_patch(contacts):
        return _of_patch(contacts, creepages, friction, model, strips, ())["result"]
    return _batch(contacts, creepages, friction, model, strips, ())["result"]


def evaluate(contacts: Records, creepages: Records, friction: Optional[Records] = None, model: Model = "default",
             strips: int = 0, *, derivatives: bool = True, law_derivatives: bool = False) -> Evaluation:
    """Forces, the friction that agrees with the slip, and derivatives; of contacts or of one patch."""
    wanted = ("friction",) + ("derivatives",) * bool(derivatives) + ("law_derivatives",) * bool(law_derivatives)
    made = (_of_patch if _is_patch(contacts) else _batch)(contacts, creepages, friction, model, strips, wanted)
    return Evaluation(made["result"], made["friction"], made.get("derivatives"), made.get("law_derivatives"))


def _outputs(kind: str, made: dict[str, tuple[np.ndarray, int]], shape: tuple, suffix: str) -> tuple[np.ndarray, int]:
    """A structure of pointers for each element."""
    outputs = np.zeros(int(np.prod(shape)), dtypes[kind + suffix])
    for name, (array, distance) in made.items():
        outputs[name] = array.ctypes.data + distance * np.arange(outputs.size)
    return outputs, outputs.dtype.itemsize


def _of_patch(patch: Any, creepages: Any, law: Any, model: Model, strips: int, wanted: tuple) -> dict[str, np.ndarray]:
    """kstrip_patch_evaluate() for each creepage."""
    single = _single(patch, creepages, law)
    patch, creepages = _one("patch", patch, single), _records("creepage", creepages, single)
    law = None if law is None else _records("friction", law, single)
    shape = creepages.shape if law is None else np.broadcast_shapes(creepages.shape, law.shape)
    made = {"result": _out("result", shape, single)}
    number = np.dtype(np.float32 if single else np.float64)
    if "friction" in wanted:
        made["friction"] = np.zeros(int(np.prod(shape)), number), number.itemsize
    for name in ("derivatives", "law_derivatives"):
        if name in wanted:
            made[name] = _out(name, shape, single)
    outputs = _outputs("outputs", made, shape, "_f32" * single)
    _each("kstrip_patch_evaluate", single, shape, patch.ctypes.data, _flat(creepages, shape),
          None if law is None else _flat(law, shape), ctypes.byref(_options(model, strips)), outputs)
    return {name: array.reshape(shape) for name, (array, _) in made.items()}


def solve_motion(contacts: Records, motions: Records, friction: Optional[Records] = None, model: Model = "default",
                 strips: int = 0, *, derivatives: bool = True) -> Evaluation:
    """Forces of contacts that roll forward, backward or not at all, with derivatives by motion, load and friction."""
    single = _single(contacts, motions, friction)
    records = [_records("contact", contacts, single), _records("motion", motions, single)]
    records += [] if friction is None else [_records("friction", friction, single)]
    shape = np.broadcast_shapes(*(record.shape for record in records))
    flat = [_flat(record, shape) for record in records] + [None] * (friction is None)
    number = np.dtype(np.float32 if single else np.float64)
    made = {"result": _out("result", shape, single), "friction": (np.zeros(int(np.prod(shape)), number), number.itemsize)}
    if derivatives:
        made["derivatives"] = _out("motion_derivatives", shape, single)
    outputs = _outputs("motion_outputs", made, shape, "_f32" * single)
    _each("kstrip_solve_motion", single, shape, *flat, ctypes.byref(_options(model, strips)), outputs)
    answers = {name: array.reshape(shape) for name, (array, _) in made.items()}
    return Evaluation(answers["result"], answers["friction"], answers.get("derivatives"), None)


class Prepared:
    """A contact of which everything that does not depend on the motion has been computed: kstrip_prepare()."""

    def __init__(self, contact: Records, model: Model = "default", strips: int = 0):
        self._single = _single(contact)
        one = _one("contact", contact, self._single)
        self._numbers = np.zeros((), dtypes["prepared" + "_f32" * self._single])
        _call("kstrip_prepare", self._single, one, ctypes.byref(_options(model, strips)), self._numbers)

    def solve(self, creepages: Records) -> Records:
        """The results of kstrip.solve(), bit for bit."""
        creepages = _records("creepage", creepages, self._single)
        made = _out("result", creepages.shape, self._single)
        _each("kstrip_solve_prepared", self._single, creepages.shape, self._numbers.ctypes.data,
              _flat(creepages, creepages.shape), made)
        return made[0].reshape(creepages.shape)


def prepare(contact: Records, model: Model = "default", strips: int = 0) -> Prepared:
    """One contact, for rigs in which it is constant and for iterations on the creepage."""
    return Prepared(contact, model, strips)


def strips(area: Records, creepage: Records, friction: Optional[Records] = None, model: Model = "default",
           strips: int = 0) -> Records:
    """What each strip of one contact or one patch carries."""
    kind, name = ("patch", "kstrip_patch_evaluate") if _is_patch(area) else ("contact", "kstrip_evaluate")
    single = _single(area, creepage, friction)
    area, creepage = _one(kind, area, single), _one("creepage", creepage, single)
    law = None if friction is None else _one("friction", friction, single)
    capacity, count = constants["KSTRIP_STRIPS_CAPACITY"], np.zeros((), np.uint32)
    found = np.zeros(capacity, dtypes["strip" + "_f32" * single])
    outputs = structures["kstrip_outputs" + "_f32" * single](
        strips=found.ctypes.data, count=count.ctypes.data, capacity=capacity)
    _call(name, single, area, creepage, law, ctypes.byref(_options(model, strips)), ctypes.byref(outputs))
    return found[: int(count)]


def field(area: Records, creepage: Records, x: ArrayLike, y: ArrayLike, model: Model = "default", strips: int = 0) -> Records:
    """Pressure, traction, slip, dissipation and state of one contact or patch at all (x[i], y[j]) [m]; element [j, i]."""
    kind, name = ("patch", "kstrip_patch_field") if _is_patch(area) else ("contact", "kstrip_field")
    single = _single(area, creepage)
    area, creepage = _one(kind, area, single), _one("creepage", creepage, single)
    x, y = _floats(x, "x", single).reshape(-1), _floats(y, "y", single).reshape(-1)
    _count(x.size * y.size)
    points = np.zeros((y.size, x.size), dtypes["point" + "_f32" * single])
    _call(name, single, area, creepage, ctypes.byref(_options(model, strips)), x, x.size, y, y.size, points, points.size)
    return points


# Patches of any shape: give them to solve(), evaluate(), strips() and field()


def patch_from_profile(y: ArrayLike, distance: ArrayLike, *, rolling_radius: ArrayLike, shear_modulus: float,
                       poisson_ratio: float, friction: float, normal_force: float = 0.0, approach: float = 0.0,
                       smoothing_length: float = 0.0, strips: int = 0, centre_x: ArrayLike | None = None) -> tuple[Records, Records]:
    """A patch from the distance [m] of two undeformed profiles over y [m], under a load [N] or at an approach [m].

    rolling_radius [m] is one number or one for each point; centre_x [m] is where along x the distance is least (yaw), one
    for each point. Returns the patch, whose members may be changed (friction per strip), and how the profiles meet.
    """
    y, distance = _floats(y, "y", False).reshape(-1), _floats(distance, "distance", False).reshape(-1)
    lists = [y, distance]
    for values in (centre_x, rolling_radius if np.ndim(rolling_radius) else None):
        lists.append(None if values is None else _floats(values, "centre_x, rolling_radius", False).reshape(-1))
    if any(values is not None and values.size != y.size for values in lists):
        raise ValueError("the arrays of a profile have different sizes")
    pointers = [0 if values is None else values.ctypes.data for values in lists]
    profile = structures["kstrip_profile"](*pointers, _count(y.size), 0)
    load = structures["kstrip_profile_contact"](
        rolling_radius=0.0 if np.ndim(rolling_radius) else float(rolling_radius), normal_force=float(normal_force), approach=float(approach),
        smoothing_length=float(smoothing_length), shear_modulus=float(shear_modulus), poisson_ratio=float(poisson_ratio),
        friction=float(friction), strips=_options(0, strips).strips)
    patch, found = np.zeros((), dtypes["patch"]), np.zeros((), dtypes["profile_result"])
    _call("kstrip_patch_from_profile", False, ctypes.byref(profile), ctypes.byref(load), patch, found)
    return patch, found


def patch_from_strips(strips: Records, shear_modulus: float, poisson_ratio: float) -> Records:
    """A patch from patch_strip() of any origin, at most 64, in any order of y."""
    single = _single(strips)
    strips = _records("patch_strip", strips, single).reshape(-1)
    patch = np.zeros((), dtypes["patch" + "_f32" * single])
    _call("kstrip_patch_from_strips", single, strips, _count(strips.size), float(shear_modulus), float(poisson_ratio), patch)
    return patch


def patch_from_contact(contact: Records, strips: int = 0) -> Records:
    """The strips of one contact's ellipse."""
    single = _single(contact)
    patch = np.zeros((), dtypes["patch" + "_f32" * single])
    _call("kstrip_patch_from_contact", single, _one("contact", contact, single), ctypes.byref(_options(0, strips)), patch)
    return patch


def patch_summary(patch: Records) -> Records:
    """Load, friction bound, area and lobes of a patch."""
    single = _single(patch)
    made = np.zeros((), dtypes["patch_summary" + "_f32" * single])
    _call("kstrip_patch_summarize", single, _one("patch", patch, single), made)
    return made


# Wheel on rail


def prepare_profile(y: ArrayLike, z: ArrayLike, step: float = 0.0, smoothing_length: float = 0.0, dtype: DTypeLike = np.float64) -> Records:
    """A profile of a rail or a wheel from its points [m], z down, the gauge side or the flange at small y."""
    single = np.dtype(dtype) == np.float32
    y, z = _floats(y, "y", single).reshape(-1), _floats(z, "z", single).reshape(-1)
    if y.size != z.size:
        raise ValueError("y and z have different sizes")
    made = np.zeros((), dtypes["surface" + "_f32" * single])
    _call("kstrip_prepare_profile", single, y, z, _count(y.size), float(step), float(smoothing_length), made)
    return made


def wheel_pair(*, wheel_radius: float, shear_modulus: float, poisson_ratio: float, friction: Union[float, Sequence] = 0.0, left: bool = False,
               smoothing_length: float = 0.0, strips: int = 0, model: Model = "default", dtype: DTypeLike = np.float64) -> Records:
    """Materials, side and friction: one number, or up to four pairs (y on the rail [m], friction)."""
    places = np.atleast_2d(np.asarray(friction, float)) if np.ndim(friction) else np.zeros((0, 2))
    room = constants["KSTRIP_RAIL_FRICTION_CAPACITY"]
    if places.shape[1:] != (2,) or len(places) > room:
        raise ValueError(f"friction is one number, or up to {room} pairs of y and friction")
    made = _record("wheel_pair", dtype, wheel_radius=wheel_radius, shear_modulus=shear_modulus, poisson_ratio=poisson_ratio,
                   friction=0.0 if len(places) else friction, friction_points=len(places), left=int(left), smoothing_length=smoothing_length)
    chosen = _options(model, strips)
    made["friction_y"][: len(places)], made["friction_at"][: len(places)] = places.T
    made["strips"], made["model"] = chosen.strips, chosen.model
    return made


def wheel_position(*, lateral: ArrayLike, vertical: ArrayLike = 0.0, yaw: ArrayLike = 0.0, roll: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Records:
    """Where a wheel's centre is over the rail [m, m, rad, rad]: vertical 0 is one wheel radius over the rail's origin, down is positive."""
    return _record("wheel_position", dtype, lateral=lateral, vertical=vertical, yaw=yaw, roll=roll)


def wheel_velocity(*, forward: ArrayLike, pitch: ArrayLike, lateral: ArrayLike = 0.0, vertical: ArrayLike = 0.0, roll: ArrayLike = 0.0,
                   yaw: ArrayLike = 0.0, dtype: DTypeLike = np.float64) -> Records:
    """How a wheel moves over the rail [m/s; rad/s about its wheelset's own axes]; pitch is about -forward/radius."""
    return _record("wheel_velocity", dtype, forward=forward, lateral=lateral, vertical=vertical, roll=roll, pitch=pitch, yaw=yaw)


class WheelOnRail(NamedTuple):
    """What acts on a wheel."""

    wrench: Records
    #: by velocity and by a factor of friction; exact
    derivatives: Records
    #: by lateral, vertical, yaw, roll; central differences
    by_position: Optional[Records]
    #: records of kstrip_wheel_contact
    contacts: Records


def wheel_on_rail(rail: Records, wheel: Records, pair: Records, position: Records, velocity: Records, friction: Optional[Records] = None,
                  by_position: bool = False) -> WheelOnRail:
    """Force and moment on a wheel of prepared profiles at one position and velocity. `friction`: a law of friction() that falls with the slip."""
    single = _single(rail, wheel, pair, position, velocity, friction)
    given = [_one(name, value, single) for name, value in zip(("surface", "surface", "wheel_pair", "wheel_position", "wheel_velocity"),
                                                              (rail, wheel, pair, position, velocity))]
    law = None if friction is None else _one("friction", friction, single)
    memory, wrench, slopes, moved = (np.zeros((), dtypes[name + "_f32" * single])
                                     for name in ("wheel_workspace", "wrench", "wrench_derivatives", "wrench_by_position"))
    _call("kstrip_wheel_on_rail", single, *given, law, memory, wrench, slopes, moved if by_position else None)
    return WheelOnRail(wrench, slopes, moved if by_position else None, memory["contacts"][: int(memory["count"])])


def height_for_load(rail: Records, wheel: Records, pair: Records, position: Records, support: float, velocity: Optional[Records] = None,
                    friction: Optional[Records] = None) -> float:
    """The vertical position [m] at which the rail supports a wheel with a force [N]; without velocity by pressure alone."""
    single = _single(rail, wheel, pair, position, velocity, friction)
    given = [_one(name, value, single) for name, value in zip(("surface", "surface", "wheel_pair", "wheel_position"), (rail, wheel, pair, position))]
    motion = None if velocity is None else _one("wheel_velocity", velocity, single)
    law = None if friction is None else _one("friction", friction, single)
    memory, found = np.zeros((), dtypes["wheel_workspace" + "_f32" * single]), np.zeros((), np.float32 if single else np.float64)
    _call("kstrip_height_for_load", single, *given, float(support), motion, law, memory, found)
    return float(found)


# Test rigs


def estimate_friction(contact: Records, creepage: Records, *, fx: Optional[float] = None, fy: Optional[float] = None,
                      model: Model = "default", strips: int = 0) -> Records:
    """The friction that explains a measured force [N]: friction, sensitivity, residual, status_detail."""
    single = _single(contact, creepage)
    made = np.zeros((), dtypes["friction_estimate" + "_f32" * single])
    measured = (FX if fx is not None else 0) | (FY if fy is not None else 0)
    _call("kstrip_estimate_friction", single, _one("contact", contact, single), _one("creepage", creepage, single),
          ctypes.byref(_options(model, strips)), measured, float(fx or 0.0), float(fy or 0.0), made)
    return made


def creepage_for_force(contact: Records, fx: float, fy: float, spin: float = 0.0, model: Model = "default",
                       strips: int = 0) -> Records:
    """The creepage at which a contact with a given spin [1/m] carries a wanted force [N]."""
    single = _single(contact)
    made = np.zeros((), dtypes["creepage" + "_f32" * single])
    _call("kstrip_creepage_for_force", single, _one("contact", contact, single), float(fx), float(fy), float(spin),
          ctypes.byref(_options(model, strips)), made)
    return made


def on_upper_body(results: Records) -> Records:
    """The same results seen from the upper body (the wheel): opposite forces and moment."""
    turned = _records("result", results, _single(results)).copy()
    for member in ("fx", "fy", "mz"):
        turned[member] = -turned[member]
    return turned
