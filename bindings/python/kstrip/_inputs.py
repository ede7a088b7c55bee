"""Inputs: whatever comes in leaves as aligned, contiguous records of one precision."""

from __future__ import annotations

import operator
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from ._library import dtypes, models, structures
from ._record import as_record

Plain = np.ndarray[Any, np.dtype[Any]]
Model = Union[str, int]
Shape = tuple[int, ...]


def numbers(value: ArrayLike, what: str) -> Plain:
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise TypeError(f"{what}: an array of real numbers is needed: {error}") from None
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{what}: real numbers are needed, not {array.dtype}")
    return array


def floats(value: ArrayLike, what: str, single: bool) -> Plain:
    with np.errstate(over="ignore"):
        return np.require(numbers(value, what), np.float32 if single else np.float64, ["C", "A"])


def broadcast(**arrays: Optional[Plain]) -> Shape:
    """The common shape; an error names each argument with its shape."""
    shapes = {name: array.shape for name, array in arrays.items() if array is not None}
    try:
        return np.broadcast_shapes(*shapes.values())
    except ValueError:
        listed = ", ".join(f"{name} {shape}" for name, shape in shapes.items())
        raise ValueError(f"these shapes do not broadcast: {listed}") from None


def record(name: str, dtype: DTypeLike, **members: ArrayLike) -> Any:
    """An array of structures from numbers and arrays that broadcast."""
    if np.dtype(dtype) not in (np.dtype(np.float64), np.dtype(np.float32)):
        raise TypeError(f"{name}: dtype is float64 or float32, not {np.dtype(dtype)}")
    kind = dtypes[name if np.dtype(dtype) == np.float64 else f"{name}_f32"]
    values = {member: numbers(value, f"{name}.{member}") for member, value in members.items()}
    made = np.zeros(broadcast(**{f"{name}.{member}": value for member, value in values.items()}), kind)
    for member, value in values.items():
        with np.errstate(over="ignore"):
            made[member] = value
    return as_record(made)


def array_of(value: Any) -> Plain:
    """An array of whatever it is; of objects where numpy makes nothing of it."""
    try:
        return np.asarray(value)
    except ValueError:
        return np.asarray(None)


_singles = [dtype for name, dtype in dtypes.items() if name.endswith("_f32")]


def is_single(*values: Any) -> bool:
    """Whether all records have the structure of single precision."""
    return all(array_of(value).dtype in _singles for value in values if value is not None)


def is_patch(area: Any) -> bool:
    return array_of(area).dtype in (dtypes["patch"], dtypes["patch_f32"])


def _seen(value: Any) -> str:
    """What an argument is, for messages."""
    dtype = array_of(value).dtype
    for name, kind in dtypes.items():
        if kind == dtype:
            return f"kstrip.{name.removesuffix('_f32')}()"
    if dtype.names is not None:
        return f"a record of {', '.join(dtype.names)}"
    return f"an array of {dtype}" if isinstance(value, np.ndarray) else f"a {type(value).__name__}"


def _maker(name: str, members: str) -> str:
    """Where records of a structure come from, for messages."""
    makers = {"combined_material": "combine()", "patch": "patch_from_profile(), patch_from_strips() or patch_from_contact()",
              "prepared": "prepare()", "surface": "prepare_profile()"}
    return f"kstrip.{makers.get(name, f'{name}({members})')}"


def records(name: str, value: Any, single: bool) -> NDArray[np.void]:
    """Records of this structure and precision; a copy if anything about them differs."""
    kind, given = dtypes[name + "_f32" * single], array_of(value)
    if given.dtype == kind:
        return np.require(given, requirements=["C", "A"])
    names = kind.names or ()
    members, seen = ", ".join(names), _seen(value)
    if given.dtype.names is None or seen.startswith("kstrip.") and seen != f"kstrip.{name}()":
        raise TypeError(f"{name}: make it with {_maker(name, members)}; this is {seen}")
    for member in names:
        if member not in given.dtype.names:
            raise TypeError(f"{name}: the field {member} is missing; this is {seen}")
    for member in given.dtype.names:
        if member not in names:
            raise TypeError(f"{name}: there is no field {member}; the fields are {members}")
    made = np.zeros(given.shape, kind)
    for member in names:
        if kind[member].base.names:
            made[member] = records("patch_strip", given[member], single)
        else:
            part = numbers(given[member], f"{name}.{member}")
            if part.shape != made[member].shape:
                raise TypeError(f"{name}.{member}: each has the shape {part.shape[given.ndim:]}, not {kind[member].shape}")
            with np.errstate(over="ignore", invalid="ignore"):
                made[member] = part
    return made


def flat(value: Plain, shape: Shape) -> tuple[Plain, int]:
    """The elements one after the other, and the distance of two in bytes: 0 if there is one for all."""
    if value.size == 1 and value.shape != shape:
        return value.reshape(-1), 0
    return np.require(np.broadcast_to(value, shape), requirements=["C", "A"]).reshape(-1), value.dtype.itemsize


def one(name: str, value: Any, single: bool, argument: str = "") -> NDArray[np.void]:
    """Exactly one record."""
    found = records(name, value, single)
    if found.size != 1:
        raise ValueError(f"{argument or name}: one is needed, and this has the shape {found.shape}")
    return found.reshape(())


def count_of(size: int) -> int:
    if size > 0xFFFFFFFF:
        raise ValueError(f"{size} elements are more than 4294967295 in one call")
    return size


def options(model: Model, strips: int) -> Any:
    if isinstance(model, str) and model not in models:
        raise ValueError(f"unknown model {model!r}: one of {', '.join(models)}")
    chosen = [models[model] if isinstance(model, str) else operator.index(model), operator.index(strips)]
    # Numbers that 32 bits cannot hold are as unknown as -1
    return structures["kstrip_options"](*(n if abs(n) < 1 << 31 else -1 for n in chosen))
