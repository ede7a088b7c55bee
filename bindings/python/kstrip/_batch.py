"""Many values of one class, and their layout in the memory of the C library."""

from __future__ import annotations

import math
import struct
from operator import attrgetter, itemgetter
from typing import Any, Generic, Iterator, Optional, Sequence, SupportsIndex, TypeVar, Union, overload

import numpy as np
from numpy.typing import NDArray

from . import _show
from ._library import dtypes
from ._value import Value
from .values import classes

V = TypeVar("V", bound=Value)
Statuses = NDArray[np.int32]
Index = Union[slice, None, NDArray[Any], Sequence[Any]]


def members_of(dtype: np.dtype[Any]) -> tuple[str, ...]:
    """The names of a structure's members."""
    return dtype.names or ()


class Layout(Generic[V]):
    """The layout of the values of a class in memory: as bytes, as a structured array."""

    def __init__(self, kind: type[V]):
        self.kind, self.dtype = kind, dtypes[kind._structure]
        fields = [(name, self.dtype[name]) for name in members_of(self.dtype)]
        at = [place for place, (name, _) in enumerate(fields) if name != "reserved"]
        names = [fields[place][0] for place in at]
        # With one name these would return a member instead of a tuple.
        self._take = itemgetter(*at) if len(at) > 1 else itemgetter(slice(1))
        self._get = attrgetter(*names) if len(names) > 1 else lambda value: (getattr(value, names[0]),)
        #: place, class and whether it is an array, of each member that has members itself
        self._parts = [(i, part_of(kind, name), field.shape != ()) for i, (name, field) in enumerate(fields[k] for k in at) if field.base.names]
        #: for structures of numbers only: their format; and whether each member is one number
        self._numbers = None if self._parts else struct.Struct("@" + "".join(_format(name, field) for name, field in fields))
        #: the places of members that are arrays, the last one first
        self._arrays = [place for place, k in reversed(list(enumerate(at))) if fields[k][1].shape]
        self._plain = not self._arrays

    def pack(self, value: V) -> bytes:
        """The bytes of a value."""
        if self._numbers is None:
            return self.array(value).tobytes()
        members = self._get(value)
        try:
            return self._numbers.pack(*(members if self._plain else self._numbers_of(members)))
        except (struct.error, TypeError, ValueError, OverflowError):
            raise self._wrong(value) from None

    def _numbers_of(self, members: tuple[Any, ...]) -> list[Any]:
        """The numbers of members one after the other."""
        numbers = list(members)
        for place in self._arrays:
            numbers[place : place + 1] = np.asarray(numbers[place]).ravel().tolist()
        return numbers

    def array(self, value: V) -> NDArray[np.void]:
        """A value as a structured array without dimensions."""
        if self._numbers is not None:
            return np.frombuffer(self.pack(value), self.dtype).reshape(())
        members = dict(zip(self.kind.__match_args__, self._get(value)))
        for place, part, many in self._parts:
            name = self.kind.__match_args__[place]
            if not isinstance(members[name], Batch if many else part) or many and members[name].kind is not part:
                raise TypeError(f"{self.kind._structure}.{name}: a {'Batch of ' * many}{part.__name__} is needed, not {members[name]!r}")
            members[name] = members[name].data if many else layout_of(part).array(members[name])[()]
        try:
            return np.array(tuple(members.get(name, 0) for name in members_of(self.dtype)), self.dtype)
        except (TypeError, ValueError, OverflowError):
            raise self._wrong(value) from None

    def value(self, array: NDArray[np.void]) -> V:
        """The value of a structured array without dimensions; its arrays are views."""
        items: Any = array.item()
        return self.of_items(items)

    def of_bytes(self, raw: Any) -> V:
        """The value of bytes."""
        if self._numbers is not None and self._plain:
            return self.kind(*self._numbers.unpack(raw))
        return self.value(np.frombuffer(bytearray(raw), self.dtype)[0])

    def copy(self, value: V) -> V:
        """A value with the same members."""
        return self.kind(*self._get(value))

    def of_items(self, items: tuple[Any, ...]) -> V:
        members = self._take(items)
        if self._parts:
            members = list(members)
            for place, part, many in self._parts:
                members[place] = Batch(part, members[place]) if many else layout_of(part).of_items(members[place])
        return self.kind(*members)

    def _wrong(self, value: V) -> Exception:
        """The error for a member that is no number, or of another shape."""
        for name in self.kind.__match_args__:
            given, field = getattr(value, name), self.dtype[name]
            at, whole = f"{self.kind._structure}.{name}", field.base.kind in "iu"
            try:
                array = np.asarray(given)
            except ValueError:
                return TypeError(f"{at}: numbers are needed, not {given!r}")
            if array.shape != field.shape:
                expected = f"an array of shape {field.shape}" if field.shape else "one number"
                return ValueError(f"{at}: {expected} is needed, not an array of shape {array.shape}; arrays of values are made by "
                                  f"kstrip.{self.kind._structure}()")
            if not field.base.names and array.dtype.kind not in ("biu" if whole else "biuf"):
                return TypeError(f"{at}: a {'whole' if whole else 'real'} number is needed, not {given!r}")
            if whole and not np.iinfo(field.base).min <= int(array) <= np.iinfo(field.base).max:
                return ValueError(f"{at}: {given} is beyond 32 bits")
        return TypeError(f"{self.kind._structure}: real numbers are needed, not {value!r}")


def _format(name: str, field: np.dtype[Any]) -> str:
    """The letters of a member for struct."""
    return f"{field.itemsize}x" if name == "reserved" else f"{math.prod(field.shape)}{field.base.char}"


_layouts: dict[type[Value], Layout[Any]] = {}


def layout_of(kind: type[V]) -> Layout[V]:
    try:
        return _layouts[kind]
    except KeyError:
        return _layouts.setdefault(kind, Layout(kind))


def part_of(kind: type[Value], name: str) -> type[Value]:
    """The class of a member that has members itself."""
    base = dtypes[kind._structure][name].base
    return next(part for structure, part in classes.items() if dtypes[structure] == base)


class Batch(Generic[V]):
    """Many values of one class in one structured array.

    kind: the class of the values. data: the array, of any shape. statuses: of results the status of each element, in the shape of the
    batch: 0, or one of the numbers in kstrip.constants; None for inputs.

    The members are attributes: `batch.fx`, or `batch["fx"]`, is the array of all fx and may be assigned to. `batch[3]` is a copy of one
    value, `batch[2:5]` a part of the batch that shares its memory. `batch.columns()` is a dict of columns for tables and plots, and
    `pandas.DataFrame(batch)` has the same columns.

    >>> contacts = kstrip.contact(a=[5e-3, 6e-3], b=4e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    >>> contacts.friction = [0.1, 0.2]
    >>> contacts[1].friction, len(contacts), list(contacts.columns())[:2]
    (0.2, 2, ['a', 'b'])
    """

    __slots__ = ("kind", "data", "statuses")
    kind: type[V]
    data: NDArray[np.void]
    statuses: Optional[Statuses]

    def __init__(self, kind: type[V], data: Union[NDArray[np.void], Sequence[V]], statuses: Optional[Statuses] = None):
        double = dtypes[kind._structure]
        if not isinstance(data, np.ndarray):
            data = np.array([layout_of(kind).array(value) for value in data], double)
        elif data.dtype is not double and data.dtype not in (double, dtypes[f"{kind._structure}_f32"]):
            raise TypeError(f"Batch: data is an array of structures {kind.__name__}, not of {data.dtype}")
        object.__setattr__(self, "kind", kind)
        object.__setattr__(self, "data", data)
        object.__setattr__(self, "statuses", statuses)

    def __reduce__(self) -> Any:
        return Batch, (self.kind, self.data, self.statuses)

    @property
    def shape(self) -> tuple[int, ...]:
        return self.data.shape

    @property
    def ndim(self) -> int:
        return self.data.ndim

    @property
    def size(self) -> int:
        return self.data.size

    def __len__(self) -> int:
        return len(self.data)

    def __getattr__(self, name: str) -> Any:
        if name not in self.kind.__match_args__:
            raise AttributeError(f"{self.kind.__name__} has no member {name!r}; its members are {', '.join(self.kind.__match_args__)}")
        member = self.data[name]
        return Batch(part_of(self.kind, name), member) if member.dtype.names else member

    def __setattr__(self, name: str, value: Any) -> None:
        if name not in self.kind.__match_args__:
            raise AttributeError(f"{self.kind.__name__} has no member {name!r}; its members are {', '.join(self.kind.__match_args__)}")
        self.data[name] = value.data if isinstance(value, Batch) else layout_of(type(value)).array(value) if isinstance(value, Value) else value

    @overload
    def __getitem__(self, key: str) -> Any: ...
    @overload
    def __getitem__(self, key: SupportsIndex) -> V: ...
    @overload
    def __getitem__(self, key: Index) -> Any: ...
    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, str):
            return getattr(self, key)
        part, statuses = self.data[key], self.statuses
        if isinstance(part, np.void):
            return layout_of(self.kind).value(np.array(part))
        return Batch(self.kind, part, None if statuses is None else np.asarray(statuses[key]))

    def __setitem__(self, key: Any, value: Any) -> None:
        if isinstance(key, str):
            setattr(self, key, value)
        elif isinstance(value, (Batch, self.kind)):
            self.data[key] = value.data if isinstance(value, Batch) else layout_of(self.kind).array(value)
        else:
            raise TypeError(f"a {self.kind.__name__} is needed, not {value!r}")

    def __iter__(self) -> Iterator[V]:
        return (self[i] for i in range(len(self)))

    def __eq__(self, other: object) -> bool:
        """Whether class, shape and all numbers are the same, bit for bit."""
        if not isinstance(other, Batch):
            return NotImplemented
        return self.kind is other.kind and self.shape == other.shape and self.data.tobytes() == other.data.tobytes()

    __hash__ = None  # type: ignore[assignment]

    def copy(self) -> Batch[V]:
        """A batch that owns its memory."""
        return Batch(self.kind, self.data.copy(), None if self.statuses is None else self.statuses.copy())

    def reshape(self, *shape: Any) -> Batch[V]:
        """The same values in another shape."""
        return Batch(self.kind, self.data.reshape(*shape), None if self.statuses is None else self.statuses.reshape(*shape))

    def columns(self) -> dict[str, Any]:
        """The numbers of each member, and of each place of an array, by name: fx, or force_0, force_1, force_2."""
        return dict(_columns(self.data, ""))

    def _shown(self) -> list[tuple[str, str, str]]:
        """Name, numbers and unit of each member."""
        parts = ((name, getattr(self, name)) for name in self.kind.__match_args__)
        return [(name, part._title() if isinstance(part, Batch) else _show.number(part), self.kind._units.get(name, "")) for name, part in parts]

    def _title(self) -> str:
        return f"{self.kind.__name__} of shape {self.shape}"

    def __repr__(self) -> str:
        return _show.lines(self._title(), self._shown())

    def _repr_html_(self) -> str:
        """The first values and the last one; members with more than twelve numbers are left out."""
        small = self.kind.__match_args__
        data = self.data.reshape(-1)
        columns = [(name, values) for name in small if data.dtype[name].itemsize <= 12 * 8 for name, values in _columns(data[[name]], "")]
        units = [next((unit for member, unit in self.kind._units.items() if name == member or name.startswith(f"{member}_")), "") for name, _ in columns]
        rows = range(data.size) if data.size <= 10 else [*range(9), data.size - 1]
        header = ["", *(f"{name} [{unit}]" if unit else name for (name, _), unit in zip(columns, units))]
        return _show.table(self._title(), header, ([str(i), *(_show.number(values[i]) for _, values in columns)] for i in rows))

    def __dir__(self) -> list[str]:
        """The members, then what a batch has besides."""
        return [*self.kind.__match_args__, "kind", "data", "statuses", "shape", "ndim", "size", "copy", "reshape", "columns"]


def _columns(array: NDArray[Any], prefix: str) -> Iterator[tuple[str, NDArray[Any]]]:
    """Name and numbers of each number in structures."""
    for name in members_of(array.dtype):
        if name == "reserved":
            continue
        for at in np.ndindex(array.dtype[name].shape):
            part, column = array[name][(..., *at)], "_".join((prefix + name, *map(str, at)))
            if part.dtype.names:
                yield from _columns(part, f"{column}_")
            else:
                yield column, part
