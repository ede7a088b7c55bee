"""Statuses of the C library as exceptions and warnings."""

from __future__ import annotations

import os
import sys
import warnings
from typing import Optional

from ._library import constants, lib

_package = os.path.dirname(os.path.abspath(__file__))
_statuses = {v: k for k, v in constants.items() if k.startswith(("KSTRIP_WARNING_", "KSTRIP_ERROR_"))}

#: Of several warnings the one with the largest number is told: the order of kstrip.h.
_RANK = {"NOT_CONVERGED": 5, "SEVERAL_FRICTIONS": 4, "SUPPORT": 4, "FRICTION_AT_LEAST": 3, "CREEPAGE_AT_LEAST": 3, "UNDETERMINED": 3, "PRESSURE": 2, "CREEPAGE": 2,
         "SEMI_AXIS": 2, "SPIN_UNIT": 2, "FRICTION": 2, "RADIUS": 2,
         "ORIENTATION": 2, "PROFILE_SIZE": 2, "MODULUS": 2, "UNSET": 2, "BEYOND_FRICTION": 1, "ANGLE_RANGE": 1, "PROFILE_END": 1, "PROFILE_COARSE": 1,
         "ROUGH": 1}


def _says(status: int, index: Optional[tuple[int, ...]]) -> str:
    at = ", ".join(str(i) for i in index or ())
    where = "" if not index else f" at index ({at})" if len(index) > 1 else f" at index {at}"
    return f"{_statuses.get(status, status)}{where}: {lib.kstrip_status_string(status).decode()}"


class KstripError(ValueError):
    """A negative status of the C library.

    Attributes: `status` (its number), `name` (its name in kstrip.h) and, for arrays, `index`: that of the first bad input.
    """

    def __init__(self, status: int, index: Optional[tuple[int, ...]] = None):
        super().__init__(_says(status, index))
        self.status, self.name, self.index = status, _statuses.get(status, ""), index


class KstripWarning(RuntimeWarning):
    """A positive status: the outputs are valid, and the message says what the caller should know."""


def gravity(status: int) -> tuple[int, int]:
    """How serious a status is: the largest of several is told."""
    return (_RANK.get(_statuses.get(status, "").removeprefix("KSTRIP_WARNING_"), 0) if status > 0 else -1), status


def report(status: int, index: Optional[tuple[int, ...]] = None) -> None:
    """Raises an error or warns; a warning names the line outside this package that called it."""
    if status < 0:
        raise KstripError(status, index)
    if status > 0:
        level, frame = 1, sys._getframe()
        while frame.f_back is not None and os.path.dirname(os.path.abspath(frame.f_code.co_filename)) == _package:
            level, frame = level + 1, frame.f_back
        warnings.warn(KstripWarning(_says(status, index)), stacklevel=level)
