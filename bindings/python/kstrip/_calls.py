"""Calls of the C library: one, and one for each element."""

from __future__ import annotations

import mmap
import sys
from typing import Any, Callable, Iterable, Optional, Sequence

import numpy as np
from numpy.typing import NDArray

from ._inputs import Plain, Shape
from ._library import dtypes, function_of
from ._status import gravity, report

#: Elements one after the other, and the distance of two in bytes
Strided = tuple[Plain, int]


def call(name: str, single: bool, *arguments: Any) -> None:
    """One call: arrays go as addresses."""
    report(function_of(name, single)(*(a.ctypes.data if isinstance(a, np.ndarray) else a for a in arguments)))


def size_of(shape: Shape) -> int:
    return int(np.prod(shape))


def index_of(at: int, shape: Shape) -> Optional[tuple[int, ...]]:
    """The index of an element, by its number."""
    return tuple(int(k) for k in np.unravel_index(at, shape)) if shape else None


class Worst:
    """The most serious status of many calls, and the number of its element."""

    def __init__(self) -> None:
        self.status, self.at = 0, 0

    def add(self, status: int, at: int) -> bool:
        """Whether this one is an error."""
        if status < 0 or gravity(status) > gravity(self.status):
            self.status, self.at = status, at
        return status < 0

    def report(self, shape: Shape) -> None:
        report(self.status, index_of(self.at, shape) if self.status else None)


def progress(count: int, what: str, part: int = 1) -> Iterable[int]:
    """0, 1, ..., count - 1, each for a part of this many elements; with a bar on a terminal where tqdm is installed and the sweep takes more than two seconds."""
    if count * part > 1000 and sys.stderr is not None and sys.stderr.isatty():
        try:
            from tqdm import tqdm  # type: ignore[import-untyped, unused-ignore]
        except ImportError:
            return range(count)
        bar: Iterable[int] = tqdm(range(count), desc=what, delay=2.0, leave=False)
        return bar
    return range(count)


def each(name: str, single: bool, shape: Shape, *arguments: Any) -> None:
    """A call for each element of the arrays in the tuples (array, distance in bytes); other arguments are for all."""
    function, worst = function_of(name, single), Worst()
    begins = [(a[0].ctypes.data, a[1]) if isinstance(a, tuple) else None for a in arguments]
    for i in progress(size_of(shape), name):
        status = function(*(a if begin is None else begin[0] + i * begin[1] for a, begin in zip(arguments, begins)))
        if status and worst.add(status, i):
            break
    worst.report(shape)


#: Elements of one call, between two states of the progress bar
PART = 100


def many(name: str, single: bool, shape: Shape, fixed: Iterable[Any], inputs: Iterable[Optional[Strided]], memory: Plain,
         outputs: Iterable[Optional[Strided]], to: Sequence[Any] = (), after: Optional[Callable[[int, int], None]] = None) -> None:
    """Calls a function that takes many elements, a part of them at a time.

    fixed: addresses of structures that all elements share. inputs: arrays with the distance of their elements in bytes; None: NULL. outputs: the
    same, without distance. to: more arguments. after: called with the first element and the size of each part.
    """
    function, worst, count = function_of(name, single), Worst(), size_of(shape)
    ins, outs = ([None if a is None else (a[0].ctypes.data, a[1]) for a in arrays] for arrays in (inputs, outputs))
    statuses = np.zeros(PART, np.int32)
    for part in progress(-(-count // PART), name.removeprefix("kstrip_"), PART):
        first = part * PART
        size = min(PART, count - first)
        given = [word for a in ins for word in ((None, 0) if a is None else (a[0] + first * a[1], a[1]))]
        places = [None if a is None else a[0] + first * a[1] for a in outs]
        status = function(*fixed, size, *given, memory.ctypes.data, *places, *to, statuses.ctypes.data)
        if status:
            for i in np.flatnonzero(statuses[:size]):
                if worst.add(int(statuses[i]), first + int(i)):
                    worst.report(shape)
        if after is not None:
            after(first, size)
    worst.report(shape)


def lazy(shape: Shape, dtype: np.dtype[Any]) -> Plain:
    """Zeros, of which only what is written to takes memory and time: where the system can, in small pages (numpy requests large ones, and the
    system then clears 2 MiB at a time)."""
    size = size_of(shape) * dtype.itemsize
    if not size or not hasattr(mmap, "MADV_NOHUGEPAGE"):
        return np.zeros(shape, dtype)
    memory = mmap.mmap(-1, size, flags=mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS)
    try:
        memory.madvise(mmap.MADV_NOHUGEPAGE)
    except OSError:
        pass
    return np.frombuffer(memory, dtype).reshape(shape)


def out(name: str, shape: Shape, single: bool) -> tuple[NDArray[np.void], int]:
    """Zeroed structures for results, one after the other, and their distance in bytes."""
    made = np.zeros(size_of(shape), dtypes[name + "_f32" * single])
    return made, made.dtype.itemsize


def real(shape: Shape, single: bool) -> tuple[Plain, int]:
    """The same for numbers."""
    made = np.zeros(size_of(shape), np.float32 if single else np.float64)
    return made, made.dtype.itemsize
