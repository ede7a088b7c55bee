"""One value: a slotted dataclass with the members of a structure of the C library."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar, Iterator

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _show
from ._library import constants

Array = NDArray[np.float64]


class Brief(type):
    """Classes whose help() and dir() list the members, and not what Python adds to every class."""

    def __dir__(cls) -> list[str]:
        return [name for name in super().__dir__() if not name.startswith("_")]


class Value(metaclass=Brief):
    """One value: its members are attributes, and its `repr` has their names and units.

    Values compare by their members, and survive pickle and copy; dataclasses.replace() makes a changed one. `value["fx"]` is `value.fx`.
    As a mapping a value has one number for each column, so that `dict(value)` and `pandas.DataFrame([value])` work: the numbers of an
    array `force` are force_0, force_1, force_2.
    """

    __slots__ = ()
    #: the member names, set by dataclass
    __match_args__: ClassVar[tuple[str, ...]] = ()
    _structure: ClassVar[str] = ""
    _units: ClassVar[dict[str, str]] = {}

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return all(np.array_equal(getattr(self, name), getattr(other, name)) for name in self.__match_args__)

    __hash__ = None  # type: ignore[assignment]

    def _shown(self) -> list[tuple[str, str, str]]:
        """Name, number and unit of each member."""
        return [(name, _show.number(getattr(self, name)), self._units.get(name, "")) for name in self.__match_args__]

    def __repr__(self) -> str:
        title, shown = type(self).__name__, self._shown()
        if all(isinstance(getattr(self, name), (int, float)) for name, _, _ in shown):
            return f"{title}({', '.join(f'{name}={text} {unit}'.rstrip() for name, text, unit in shown)})"
        return _show.lines(title, shown)

    def _repr_html_(self) -> str:
        return _show.table(type(self).__name__, ("member", "value", "unit"), self._shown())

    def __dir__(self) -> list[str]:
        """The members; what all values have besides is found by help()."""
        return [name for name in super().__dir__() if not name.startswith("_") and name != "keys"]

    def __getitem__(self, name: str) -> Any:
        if name in self.__match_args__:
            return getattr(self, name)
        for member in self.__match_args__:
            if name.startswith(f"{member}_"):
                part, rest = getattr(self, member), name[len(member) + 1 :]
                if isinstance(part, Value):
                    return part[rest]
                if isinstance(part, np.ndarray):
                    return float(part[tuple(int(word) for word in rest.split("_"))])
                if hasattr(part, "columns"):
                    return part.columns()[rest]
        raise KeyError(name)

    def __setitem__(self, name: str, value: Any) -> None:
        setattr(self, name, value)

    def keys(self) -> list[str]:
        """The names of the columns."""
        return [column for name in self.__match_args__ for column in _columns(name, getattr(self, name))]

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __len__(self) -> int:
        return len(self.keys())


Mapping.register(Value)  # pyright: ignore[reportAttributeAccessIssue]


def _columns(name: str, part: Any) -> Iterator[str]:
    """The columns of a member: of a number its name, of an array and of a value one for each number."""
    if isinstance(part, Value):
        yield from (f"{name}_{column}" for column in part.keys())
    elif isinstance(part, np.ndarray):
        yield from ("_".join((name, *map(str, at))) for at in np.ndindex(part.shape))
    else:
        yield name


class FrictionPlaces(Value):
    """The places of friction on a rail, as pairs."""

    __slots__ = ()
    if TYPE_CHECKING:
        friction_y: Array
        friction_at: Array
        friction_points: int

    @property
    def friction_places(self) -> Array:
        """Pairs of y on the rail [m] and the coefficient of friction there [-]; none: `friction` is the same everywhere."""
        return np.stack((self.friction_y, self.friction_at), axis=-1)[: self.friction_points]

    @friction_places.setter
    def friction_places(self, places: ArrayLike) -> None:
        for name, value in zip(("friction_y", "friction_at", "friction_points"), friction_places(places)):
            setattr(self, name, value)


def friction_places(places: ArrayLike) -> tuple[Array, Array, int]:
    """Pairs of y and friction as the members of a pair of wheel and rail."""
    pairs, room = np.asarray(places, float), constants["KSTRIP_RAIL_FRICTION_CAPACITY"]
    if pairs.size == 0:
        pairs = np.zeros((0, 2))
    if pairs.ndim != 2 or pairs.shape[1] != 2 or len(pairs) > room:
        raise ValueError(f"friction_places: up to {room} pairs of y [m] and friction [-] are needed; this has the shape {pairs.shape}")
    padded = np.zeros((room, 2))
    padded[: len(pairs)] = pairs
    return padded[:, 0].copy(), padded[:, 1].copy(), len(pairs)
