"""Several values together: the base of results with several parts, and of wheelsets and tracks."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

import numpy as np

from . import _show
from ._batch import Batch
from ._value import Brief, Value


G = TypeVar("G", bound="Group")


class Group(metaclass=Brief):
    """Several values together; its members are attributes."""

    __slots__ = ()
    if TYPE_CHECKING:
        #: the members, set by dataclass
        __dataclass_fields__: ClassVar[dict[str, Any]] = {}
    #: units of members that are numbers
    _units: ClassVar[dict[str, str]] = {}

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return all(_same(getattr(self, name), getattr(other, name)) for name in self._names())

    __hash__ = None  # type: ignore[assignment]

    @classmethod
    def _names(cls) -> list[str]:
        return [name for name in cls.__dataclass_fields__ if not name.startswith("_")]

    def _copy(self: G) -> G:
        """An object with the same members."""
        kind = type(self)
        made = object.__new__(kind)
        for slot in _slots(kind):
            slot.__set__(made, slot.__get__(self))
        return made

    def _shown(self) -> list[tuple[str, str, str]]:
        """Name, numbers and unit of each member."""
        members = [(name, getattr(self, name)) for name in self._names()]
        return [(name, repr(value) if isinstance(value, (Value, Batch, Group)) else _show.number(value), self._units.get(name, "")) for name, value in members]

    def __repr__(self) -> str:
        return _show.lines(type(self).__name__, self._shown())

    def _repr_html_(self) -> str:
        parts = [(name, getattr(self, name), unit) for name, _, unit in self._shown()]
        tables = [f"<tr><th>{name}</th><td>{value._repr_html_() if hasattr(value, '_repr_html_') else _show.number(value)} {unit}</td></tr>"
                  for name, value, unit in parts]
        return f"<table><caption>{type(self).__name__}</caption>{''.join(tables)}</table>"

    def __dir__(self) -> list[str]:
        """The members and methods; what every object has is left out."""
        return [name for name in super().__dir__() if not name.startswith("_")]


@cache
def _slots(kind: type[Group]) -> list[Any]:
    """The descriptors of the members of a class."""
    return [kind.__dict__[name] for name in kind._names()]


def _same(one: Any, other: Any) -> bool:
    return bool(np.array_equal(one, other)) if isinstance(one, np.ndarray) else bool(one == other)
