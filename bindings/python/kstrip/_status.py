"""Statuses of the C library as exceptions and warnings."""

from __future__ import annotations

import os
import sys
import warnings
from typing import Any, Optional

from ._library import constants, lib

_package = os.path.dirname(os.path.abspath(__file__))
_names = {value: name for name, value in constants.items() if name.startswith(("KSTRIP_WARNING_", "KSTRIP_ERROR_"))}

#: Of several warnings the one with the largest number is reported: the order of kstrip.h.
_RANK = {
    "NOT_CONVERGED": 5,
    "SEVERAL_FRICTIONS": 4, "SUPPORT": 4,
    "FRICTION_AT_LEAST": 3, "CREEPAGE_AT_LEAST": 3, "UNDETERMINED": 3,
    "PRESSURE": 2, "CREEPAGE": 2, "SEMI_AXIS": 2, "SPIN_UNIT": 2, "FRICTION": 2, "RADIUS": 2, "ORIENTATION": 2, "PROFILE_SIZE": 2, "MODULUS": 2,
    "UNSET": 2, "CURVATURE": 2, "YOUNG": 2, "PER_CENT": 2, "DAMPING": 2, "PROFILE_GUESS": 2,
    "BEYOND_FRICTION": 1, "ANGLE_RANGE": 1, "PROFILE_END": 1, "PROFILE_COARSE": 1, "ROUGH": 1, "SECOND_MINIMUM": 1, "FIT_BOUND": 1,
}


def text_of(status: int, index: Optional[tuple[int, ...]] = None) -> str:
    """Name, index and meaning of a status."""
    at = ", ".join(str(i) for i in index or ())
    where = "" if not index else f" at index ({at})" if len(index) > 1 else f" at index {at}"
    return f"{_names.get(status, status)}{where}: {lib.kstrip_status_string(status).decode()}"


class KstripError(ValueError):
    """A negative status of the C library.

    status, name: its number, and its name in kstrip.h. index: of array calls the index of the first element that failed; None for one
    value. results: all results, NaN for failed elements. statuses: the status of each element.

    >>> shifts = kstrip.wheel_position(lateral=[-10e-3, 0.5])
    >>> try:
    ...     kstrip.height_for_load(rail, wheel, pair, shifts, 80e3)
    ... except kstrip.KstripError as error:
    ...     print(error.name, error.index, 1e3 * error.results.round(5))
    ...     caught = error
    KSTRIP_ERROR_PROFILE_END (1,) [0.23  nan]
    """

    def __init__(self, status: int, index: Optional[tuple[int, ...]] = None, results: Any = None, statuses: Any = None, arguments: str = ""):
        super().__init__(status, index, results, statuses, arguments)
        self.status, self.name, self.index = status, _names.get(status, ""), index
        self.results, self.statuses, self.arguments = results, statuses, arguments

    def __str__(self) -> str:
        return text_of(self.status, self.index) + (f"\n{self.arguments}" if self.arguments else "")


class KstripWarning(RuntimeWarning):
    """A positive status: the outputs are valid, and the message names what the caller should check."""


def gravity(status: int) -> tuple[int, int]:
    """How serious a status is: the largest of several is reported."""
    return (_RANK.get(_names.get(status, "").removeprefix("KSTRIP_WARNING_"), 0) if status > 0 else -1), status


def warn(status: int, index: Optional[tuple[int, ...]] = None) -> None:
    """A warning that names the line outside this package that made the call."""
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and os.path.dirname(os.path.abspath(frame.f_code.co_filename)) == _package:
        level, frame = level + 1, frame.f_back
    warnings.warn(KstripWarning(text_of(status, index)), stacklevel=level)


def report(status: int) -> None:
    """The status of a call for one value: raises an error, or warns."""
    if status < 0:
        raise KstripError(status)
    if status > 0:
        warn(status)
