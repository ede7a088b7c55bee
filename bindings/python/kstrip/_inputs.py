"""Inputs: numbers, values and batches as the C library takes them."""

from __future__ import annotations

import operator
import struct
from types import MappingProxyType
from typing import Any, Mapping, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, DTypeLike

from ._batch import Batch, V, layout_of
from ._library import dtype_of, models
from ._value import Value

Plain = np.ndarray[Any, np.dtype[Any]]
Model = Union[str, int]
Shape = tuple[int, ...]
#: One value, or many of them
Many = Union[V, Batch[V]]


def numbers(value: ArrayLike, what: str) -> Plain:
    """An array of real numbers."""
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise TypeError(f"{what}: an array of real numbers is needed: {error}") from None
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{what}: real numbers are needed, not {_described(value)}")
    return array


def number(value: Any, what: str) -> float:
    """One real number."""
    if type(value) is float:
        return value
    array = numbers(value, what)
    if array.size != 1:
        raise ValueError(f"{what}: one number is needed, and this has the shape {array.shape}")
    return float(array.reshape(()))


def floats(value: ArrayLike, what: str, single: bool = False) -> Plain:
    """A contiguous array of one precision."""
    with np.errstate(over="ignore"):
        return np.require(numbers(value, what), np.float32 if single else np.float64, ["C", "A"])


def broadcast(**arrays: Plain) -> Shape:
    """The common shape; an error names each argument with its shape."""
    try:
        return np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        listed = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise ValueError(f"these shapes do not broadcast: {listed}") from None


def precision(dtype: DTypeLike, what: str) -> bool:
    """Whether a dtype is that of single precision."""
    if np.dtype(dtype) not in (np.dtype(np.float64), np.dtype(np.float32)):
        raise TypeError(f"{what}: dtype is float64 or float32, not {np.dtype(dtype)}")
    return np.dtype(dtype) == np.float32


def make(kind: type[V], dtype: DTypeLike, shared: Mapping[str, Any] = MappingProxyType({}), **members: Any) -> Any:
    """A value from numbers, or a batch from arrays that broadcast; `shared` members are those of every value."""
    if dtype is np.float64 and all(isinstance(value, (float, int)) for value in members.values()):
        return kind(**shared, **members)
    single = precision(dtype, kind._structure)
    arrays = {f"{kind._structure}.{name}": numbers(value, f"{kind._structure}.{name}") for name, value in members.items()}
    shape = broadcast(**arrays)
    if shape == () and not single:
        return kind(**shared, **{name: array.item() for name, array in zip(members, arrays.values())})
    data = np.zeros(shape, dtype_of(kind._structure, single))
    for name, value in (*shared.items(), *zip(members, arrays.values())):
        with np.errstate(over="ignore"):
            data[name] = value
    return Batch(kind, data)


def is_single(*arguments: Any) -> bool:
    """Whether all arguments with a precision have single precision; a value has the precision of the arguments beside it."""
    found = False
    for argument in arguments:
        if isinstance(argument, Batch):
            found = bool(argument.data.dtype == dtype_of(argument.kind._structure, True))
        elif isinstance(argument, Value) or not hasattr(argument, "single"):
            continue
        else:
            found = argument.single
        if not found:
            break
    return found


def is_many(value: Any) -> bool:
    """Whether an argument has dimensions."""
    return value.ndim > 0 if isinstance(value, Batch) else not isinstance(value, (Value, float, int, type(None))) and np.ndim(value) > 0


def _described(value: Any) -> str:
    """What an argument is, for messages."""
    if isinstance(value, Batch):
        return f"a Batch of {value.kind.__name__}"
    if isinstance(value, np.ndarray):
        return f"an array of {value.dtype}"
    name = type(value).__name__
    return f"{'an' if name[0] in 'AEIOUaeiou' else 'a'} {name}"


#: Functions that make a value, where their name is not that of the structure
_MAKERS = {"combined_material": "combine(lower, upper)", "patch": "patch_from_profile(), patch_from_strips() or patch_from_contact()",
           "result": "solve()", "wheel_contact": "wheel_on_rail(...).contacts"}


def wrong(argument: str, kind: type[Value], value: Any) -> TypeError:
    """The error for an argument of another class."""
    maker = _MAKERS.get(kind._structure, f"{kind._structure}({', '.join(kind.__match_args__)})")
    return TypeError(f"{argument}: a {kind.__name__}, or a Batch of them, is needed: make it with kstrip.{maker}; this is {_described(value)}")


def check(**arguments: tuple[Any, Any]) -> None:
    """Whether arguments are values of their class, or None where that is their class."""
    for name, (kind, value) in arguments.items():
        if kind is not None and type(value) is not kind:
            raise wrong(name, kind, value)


def array_of(argument: str, kind: type[V], value: Any, single: bool) -> Plain:
    """A value or a batch as a contiguous structured array."""
    if type(value) is kind:
        data: Plain = layout_of(kind).array(value)
    elif type(value) is Batch and value.kind is kind:
        data = value.data
    else:
        raise wrong(argument, kind, value)
    with np.errstate(over="ignore", invalid="ignore"):
        return np.require(data.astype(dtype_of(kind._structure, single), copy=False), requirements=["C", "A"])


def one(argument: str, kind: type[V], value: Any, single: bool) -> bytes:
    """Exactly one value as bytes."""
    if type(value) is kind and not single:
        return layout_of(kind).pack(value)
    data = array_of(argument, kind, value, single)
    if data.size != 1:
        raise ValueError(f"{argument}: one {kind.__name__} is needed, and this has the shape {data.shape}")
    return data.tobytes()


def flat(array: Plain, shape: Shape) -> tuple[Plain, int]:
    """The elements one after the other, and the distance of two in bytes: 0 if there is one for all."""
    if array.size == 1 and array.shape != shape:
        return array.reshape(-1), 0
    return np.require(np.broadcast_to(array, shape), requirements=["C", "A"]).reshape(-1), array.dtype.itemsize


def count_of(size: int) -> int:
    if size > 0xFFFFFFFF:
        raise ValueError(f"{size} elements are more than 4294967295 in one call")
    return size


def choice(model: Model, strips: int) -> tuple[int, int]:
    """The numbers of a model and of its strips."""
    if isinstance(model, str) and model not in models:
        raise ValueError(f"model: {model!r} is none of {', '.join(models)}")
    try:
        chosen = models[model] if isinstance(model, str) else operator.index(model), operator.index(strips)
    except TypeError:
        raise TypeError(f"model is a name or a number of kstrip.models, and strips a whole number, not {model!r} and {strips!r}") from None
    # Numbers that 32 bits cannot hold are as unknown as -1.
    first, second = (number if abs(number) < 1 << 31 else -1 for number in chosen)
    return first, second


def options(model: Model, strips: int) -> Optional[bytes]:
    """Model and number of strips as the structure of the C library; None is the default."""
    return None if model == "default" and strips == 0 else struct.pack("ii", *choice(model, strips))
