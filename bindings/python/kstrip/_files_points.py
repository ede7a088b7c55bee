"""What the readers of profile files return: points in the units of the file, and the statements of its header."""

from __future__ import annotations

import dataclasses
import pathlib
from typing import Any, Callable, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
#: metres per unit
UNITS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "in": 0.0254}
#: Lines that are converted in one go, so that a long file needs little memory beside itself, and the fewest for which that pays.
_MANY, _FEW = 32768, 1000


class ProfileError(ValueError):
    """A profile file that cannot be read, with `path`, and with `line` if one line is the cause."""

    def __init__(self, path: Any, line: Optional[int], message: str):
        super().__init__(path, line, message)
        self.path, self.line, self.message = str(path), line, message

    def __str__(self) -> str:
        return f"{self.path}{'' if self.line is None else f', line {self.line}'}: {self.message}"


class ProfileWarning(UserWarning):
    """A profile whose direction, side, kind or units are guessed from weak evidence, or contradict its file."""


@dataclasses.dataclass(frozen=True)
class Wanted:
    """The arguments of read_profile() that concern the columns of a table."""

    columns: Optional[tuple[Union[int, str], Union[int, str]]] = None
    skip: int = 0
    missing: tuple[Union[str, float], ...] = ()
    decimal: Optional[str] = None


@dataclasses.dataclass
class Points:
    """The points of a file, in the units of the file, and the statements of the file about them."""

    path: pathlib.Path
    format: str
    y: Array = dataclasses.field(default_factory=lambda: np.zeros(0))
    z: Array = dataclasses.field(default_factory=lambda: np.zeros(0))
    #: line of each point, if the file has lines
    line: Optional[Any] = None
    notes: list[str] = dataclasses.field(default_factory=list)
    warnings: list[str] = dataclasses.field(default_factory=list)
    #: metres per unit, and how that is known
    unit: Optional[float] = None
    unit_source: str = ""
    kind: Optional[str] = None
    kind_source: str = "by its header"
    #: whether the format itself says which way y and z point
    has_convention: bool = False
    #: whether y = 0 is at the flange back of a wheel, by the format
    from_flange_back: bool = False
    #: applied after the change of units, in this order: shift [m], turn [rad], mirrors of y and z
    shift: tuple[float, float] = (0.0, 0.0)
    turn: float = 0.0
    mirror: tuple[bool, bool] = (False, False)

    def error(self, line: Optional[int], message: str) -> ProfileError:
        return ProfileError(self.path, line, message)

    def line_of(self, point: int) -> Optional[int]:
        return None if self.line is None else int(self.line[point])


class PlainLines:
    """Lines of a file that numpy converts, many at once: in each the same number of plain numbers."""

    def __init__(self, lines: list[str], separator: Optional[str] = None, change: Optional[Callable[[str], str]] = None):
        self.lines, self.separator, self.change = lines, separator, change
        self.next_try = 0

    def from_line(self, first: int) -> Optional[Array]:
        """The numbers of many lines from the index `first` on, shape (lines, columns); None if a line among them is none of numbers."""
        if first < self.next_try or len(self.lines) - first < _FEW:
            return None
        lines = self.lines[first : first + _MANY]
        self.next_try = first + len(lines)
        if self.change is not None:
            lines = [self.change(line) for line in lines]
        if "D" in lines[0]:
            lines = [line.replace("D", "E") for line in lines]
        try:
            found = np.loadtxt(lines, delimiter=self.separator, comments=None, ndmin=2)
        except ValueError:
            return None
        return found if len(found) == len(lines) and np.isfinite(found).all() else None


class Rows:
    """Rows of numbers with their lines, one by one or many at once."""

    def __init__(self, columns: int = 2) -> None:
        self._parts: list[Array] = []
        self._last: list[tuple[float, ...]] = []
        self._columns = columns + 1
        self.count = 0

    def add(self, row: Sequence[float], line: int) -> None:
        self._last.append((*row, line))
        self.count += 1

    def add_many(self, rows: Array, first_line: int) -> None:
        self._part()
        self._parts.append(np.column_stack((rows, first_line + np.arange(len(rows), dtype=float))))
        self.count += len(rows)

    def _part(self) -> None:
        if self._last:
            self._parts.append(np.array(self._last))
            self._last = []

    def arrays(self) -> tuple[Array, Any]:
        """The rows, shape (count, columns), and their lines."""
        self._part()
        found = np.concatenate((np.zeros((0, self._columns)), *self._parts))
        return found[:, :-1], found[:, -1].astype(np.int_)
