"""Structures of the C library as arrays with named members: the base class of `kstrip.Contact` and its like."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, Generic, Iterator, Optional, SupportsIndex, TypeVar, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._library import dtypes

if TYPE_CHECKING:
    from types import EllipsisType

    from typing_extensions import Self

    Index = Union[SupportsIndex, slice, EllipsisType, None, NDArray[Any], list[Any], tuple[Any, ...]]

R = TypeVar("R", bound="Record")

#: The class of each structure by its name: "contact", ...
classes: dict[str, type[Record]] = {}
_by_dtype: dict[np.dtype[Any], type[Record]] = {}


class Record(np.ndarray[Any, np.dtype[np.void]]):
    """An array of structures of the C library, of any shape.

    `r.fx` and `r["fx"]` are the member `fx` of all elements, as an array of the same shape that may be assigned to. `r[0]` is a
    record again. It prints with the names and units of its members.
    """

    _name: ClassVar[str] = ""
    _members: ClassVar[dict[str, Member]] = {}

    def __init_subclass__(cls, name: str, **more: Any):
        super().__init_subclass__(**more)
        cls._name = name
        cls._members = {key: value for key, value in vars(cls).items() if isinstance(value, Member)}
        classes[name] = cls
        for kind in (name, f"{name}_f32"):
            if kind in dtypes:
                _by_dtype[dtypes[kind]] = cls

    @overload  # type: ignore[override]
    def __getitem__(self, key: str) -> NDArray[Any]: ...
    @overload
    def __getitem__(self, key: Index) -> Self: ...
    def __getitem__(self, key: Any) -> Any:  # pyright: ignore[reportIncompatibleMethodOverride]
        found = super().__getitem__(key)
        if isinstance(found, np.void):
            # One element: a view of it, of this class
            found = super().__getitem__((*(key if isinstance(key, tuple) else (key,)), ...))
        return as_record(found) if isinstance(found, np.ndarray) else found

    def __setattr__(self, name: str, value: Any) -> None:
        if self._members and name not in self._members and not hasattr(np.ndarray, name):
            raise AttributeError(f"{self._name} has no member {name!r}; its members are {', '.join(self._members)}")
        super().__setattr__(name, value)

    def __iter__(self) -> Iterator[Self]:  # type: ignore[override]  # pyright: ignore[reportIncompatibleMethodOverride]
        return (self[i] for i in range(len(self)))

    def __repr__(self) -> str:
        if self.dtype.names is None or not self._members:
            return repr(np.asarray(self))
        members = [(name, member) for name, member in self._members.items() if name in self.dtype.names]
        if self.ndim == 0 and all(np.asarray(self[name]).ndim == 0 for name, _ in members):
            return f"{type(self).__name__}({', '.join(f'{name}={_shown(self[name])}{member.after}' for name, member in members)})"
        widest = max(len(name) for name, _ in members)
        units = max(len(member.after) for _, member in members)
        head = type(self).__name__ + (f" of shape {self.shape}" if self.ndim else "")
        lines = (f"  {name:{widest}}{member.after:{units}}  {_shown(self[name])}" for name, member in members)
        return "\n".join((head, *lines))

    __str__ = __repr__


def as_record(array: np.ndarray[Any, np.dtype[Any]]) -> Any:
    """The array as an object of its structure's class, or as a plain array where it has none."""
    return array.view(_by_dtype.get(array.dtype, np.ndarray))


def _shown(value: Any) -> str:
    if isinstance(value, Record):
        return f"{type(value).__name__} of shape {value.shape}" if value.ndim else f"<{type(value).__name__}>"
    if value.ndim == 0:
        return f"{value[()]:.9g}" if value.dtype.kind == "f" else str(value)
    return str(np.array2string(np.asarray(value), threshold=8, edgeitems=3, precision=6).replace("\n", ""))


class Member:
    """A member of a record; `unit` is "" where it has none."""

    def __init__(self, unit: str = "", doc: str = ""):
        self.unit, self.__doc__ = unit, doc

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def _of(self, record: Any) -> Any:
        if record.dtype.names is None:
            raise AttributeError(f"these are numbers without members, not a record: no {self.name}")
        return record[self.name]

    def __set__(self, record: Any, value: ArrayLike) -> None:
        record[self.name] = value

    @property
    def after(self) -> str:
        """The unit behind a number."""
        return f" {self.unit}" if self.unit else ""


class Numbers(Member):
    """Real numbers."""

    @overload
    def __get__(self, record: None, owner: Any = None) -> Self: ...
    @overload
    def __get__(self, record: Record, owner: Any = None) -> NDArray[np.float64]: ...
    def __get__(self, record: Optional[Record], owner: Any = None) -> Union[Self, NDArray[np.float64]]:
        return self if record is None else self._of(record)


class Integers(Member):
    """Whole numbers."""

    @overload
    def __get__(self, record: None, owner: Any = None) -> Self: ...
    @overload
    def __get__(self, record: Record, owner: Any = None) -> NDArray[np.int32]: ...
    def __get__(self, record: Optional[Record], owner: Any = None) -> Union[Self, NDArray[np.int32]]:
        return self if record is None else self._of(record)


class Part(Member, Generic[R]):
    """A structure within a structure."""

    def __init__(self, kind: type[R], unit: str = "", doc: str = ""):
        super().__init__(unit, doc)
        self.kind = kind

    @overload
    def __get__(self, record: None, owner: Any = None) -> Self: ...
    @overload
    def __get__(self, record: Record, owner: Any = None) -> R: ...
    def __get__(self, record: Optional[Record], owner: Any = None) -> Union[Self, R]:
        return self if record is None else self._of(record)
