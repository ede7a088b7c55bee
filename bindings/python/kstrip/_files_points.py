"""What the readers of profile files return: points in the units of the file, and what its header says."""

from __future__ import annotations

import dataclasses
import pathlib
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
#: metres per unit
UNITS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "in": 0.0254}


class ProfileError(ValueError):
    """A profile file that cannot be read; `path`, and `line` if a line is at fault."""

    def __init__(self, path: Any, line: Optional[int], message: str):
        super().__init__(path, line, message)
        self.path, self.line, self.message = str(path), line, message

    def __str__(self) -> str:
        return f"{self.path}{'' if self.line is None else f', line {self.line}'}: {self.message}"


class ProfileWarning(UserWarning):
    """A profile whose direction, side, kind or units are guessed from weak evidence, or against what its file says."""


@dataclasses.dataclass(frozen=True)
class Wanted:
    """The arguments of read_profile() that concern the columns of a table."""

    columns: Optional[tuple[Union[int, str], Union[int, str]]] = None
    skip: int = 0
    missing: tuple[Union[str, float], ...] = ()
    decimal: Optional[str] = None


@dataclasses.dataclass
class Points:
    """The points of a file, in its own units, and what the file says about them."""

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
