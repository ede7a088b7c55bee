"""Calls of the C library: one for each element of arguments that broadcast."""

from __future__ import annotations

import ctypes
import math
import threading
from contextlib import contextmanager
from itertools import islice, repeat
from typing import Any, Callable, Iterable, Iterator, NamedTuple, Optional, Protocol, Sequence, TypeVar

import numpy as np
from numpy.typing import NDArray

from ._batch import Batch, layout_of
from ._inputs import Plain, Shape, array_of, broadcast, count_of, flat, floats, one
from ._library import dtype_of, function_of, lib
from ._status import KstripError, gravity, report, warn
from ._value import Value

#: Results of any kind
R = TypeVar("R")
S = TypeVar("S")

_start = ctypes.c_char.from_buffer


def address(array: Any) -> int:
    """The address of writable memory."""
    return ctypes.addressof(_start(array))


def zeros(structure: str, single: bool) -> NDArray[np.void]:
    """A structure of zeros for the output of one call."""
    return np.zeros((), dtype_of(structure, single))


def call(name: str, single: bool, *arguments: Any) -> None:
    """One call; arrays go as addresses."""
    report(function_of(name, single)(*(a.ctypes.data if isinstance(a, np.ndarray) else a for a in arguments)))


class Space:
    """Memory for a structure: as an array, as bytes, and its address."""

    def __init__(self, dtype: np.dtype[Any]):
        self.raw = bytearray(dtype.itemsize)
        self.array, self.address = np.frombuffer(self.raw, dtype).reshape(()), address(self.raw)


class Memory(threading.local):
    """Memory of each thread, which may hold anything before a call."""

    def __init__(self) -> None:
        self._spaces: dict[tuple[str, bool], Space] = {}

    def of(self, structure: str, single: bool) -> Space:
        """The thread's memory for a structure."""
        try:
            return self._spaces[structure, single]
        except KeyError:
            return self._spaces.setdefault((structure, single), Space(dtype_of(structure, single)))


memory = Memory()


def are_values(*arguments: Any) -> bool:
    """Whether all arguments are values or None, so that call_for_values() takes them."""
    return all(argument is None or isinstance(argument, Value) for argument in arguments)


def call_for_values(name: str, arguments: Sequence[Any], workspace: Space, *kinds: Optional[type[Value]]) -> tuple[int, list[Any]]:
    """One call in double precision, with less work around it than Elements: its status, and the values that it returned.

    arguments: values, and what the C library takes as it is. kinds: the classes of the outputs; None for an output that is not requested.
    """
    given = [layout_of(type(each)).pack(each) if isinstance(each, Value) else each for each in arguments]
    spaces = [None if kind is None else memory.of(kind._structure, False) for kind in kinds]
    status = getattr(lib, name)(*given, workspace.address, *(None if space is None else space.address for space in spaces))
    if status < 0:
        raise KstripError(status)
    return status, [None if kind is None or space is None else layout_of(kind).of_bytes(space.raw) for kind, space in zip(kinds, spaces)]


def copy_of(value: Any) -> Any:
    """A copy of an argument."""
    return layout_of(type(value)).copy(value) if isinstance(value, Value) else value.copy() if isinstance(value, Batch) else value


class Sweep(NamedTuple):
    """How the elements of a call are computed: in how many threads, and whether a bar shows the progress."""

    threads: int = 1
    progress: bool = False

    @contextmanager
    def bar(self, count: int, name: str) -> Iterator[Callable[[int], object]]:
        """A function that takes the number of elements that were computed last, and shows it if tqdm is installed."""
        shown: Any = None
        if self.progress:
            try:
                from tqdm import tqdm  # type: ignore[import-untyped, unused-ignore]

                shown = tqdm(desc=name.removeprefix("kstrip_"), total=count)
            except ImportError:
                pass
        try:
            yield int if shown is None else shown.update
        finally:
            if shown is not None:
                shown.close()

    def each(self, blocks: Iterable[R], work: Callable[[R], S], done: Callable[[S], object]) -> None:
        """work(block) for each block, in threads on request; done(result) in this thread, in the order of the blocks."""
        if self.threads == 1:
            for block in blocks:
                done(work(block))
            return
        # Imported here, because it takes a tenth of the time of `import kstrip`.
        from concurrent.futures import ThreadPoolExecutor

        waiting = iter(blocks)
        with ThreadPoolExecutor(self.threads) as pool:
            # Two blocks for each thread: the block that it computes, and the next one.
            futures = [pool.submit(work, block) for block in islice(waiting, 2 * self.threads)]
            while futures:
                done(futures.pop(0).result())
                futures += [pool.submit(work, block) for block in islice(waiting, 1)]


def sweep_of(threads: int, progress: bool) -> Sweep:
    """The arguments threads and progress of functions for arrays."""
    if not isinstance(threads, (int, np.integer)) or threads < 1:
        raise ValueError(f"threads: a whole number, 1 or more, is needed, not {threads!r}")
    return Sweep(int(threads), bool(progress))


class Workspace(NamedTuple):
    """Stands in a column for the workspace of the thread that makes the call."""

    structure: str


class Keeper(Protocol):
    """Keeps a part of the workspace after each call."""

    def take(self, workspace: bytearray, status: int) -> bytearray:
        """What is kept after a call with this status."""
        ...

    def keep(self, parts: list[bytearray]) -> None:
        """Keeps what take() returned for the next elements."""
        ...


#: Elements that one thread computes before it takes others
_BLOCK = 64


class Elements:
    """Arguments that broadcast, element by element.

    Each argument is given as its class and a value, a batch or None; the class `float` stands for a number or an array of numbers.
    columns: for each argument what the C library takes, one after the other: bytes, addresses or numbers.
    """

    def __init__(self, single: bool, on_error: str, **arguments: tuple[Any, Any]):
        if on_error not in ("raise", "nan"):
            raise ValueError(f"on_error: 'raise' or 'nan' is needed, not {on_error!r}")
        self.single, self._on_error, self._arguments = single, on_error, arguments
        self.columns: dict[str, Iterable[Any]] = dict.fromkeys(arguments, repeat(None))
        arrays: dict[str, Plain] = {}
        for name, (kind, value) in arguments.items():
            if kind is None:
                continue
            if type(value) is kind:
                self.columns[name] = repeat(value if kind is float else one(name, kind, value, single))
            else:
                arrays[name] = floats(value, name, single) if kind is float else array_of(name, kind, value, single)
        #: Whether the results are batches
        self.many = any(array.ndim or arguments[name][0] is not float for name, array in arrays.items())
        self.shape: Shape = broadcast(**arrays) if arrays else ()
        self.count = math.prod(self.shape)
        #: The elements of arrays one after the other, and their distance in bytes
        self._flat = {name: flat(array, self.shape) for name, array in arrays.items()}
        for name, (elements, distance) in self._flat.items():
            if arguments[name][0] is float:
                self.columns[name] = elements.tolist() if distance else repeat(float(elements[0]))
            else:
                first = elements.ctypes.data
                self.columns[name] = range(first, first + self.count * distance, distance) if distance else repeat(first)

    def array(self, name: str) -> tuple[Plain, int]:
        """The elements of an argument one after the other, and their distance in bytes: 0 if there is one for all."""
        if name not in self._flat:
            kind, value = self._arguments[name]
            array = floats(value, name, self.single) if kind is float else array_of(name, kind, value, self.single)
            self._flat[name] = flat(array, self.shape)
        return self._flat[name]

    def out(self, structure: str) -> tuple[NDArray[np.void], Iterable[int]]:
        """Structures for the results, and their addresses; for one value they are those of the thread."""
        if not self.many:
            space = memory.of(structure, self.single)
            return space.array, (space.address,)
        return self._out(dtype_of(structure, self.single))

    def real(self) -> tuple[Plain, Iterable[int]]:
        """The same for numbers."""
        return self._out(np.dtype(np.float32 if self.single else np.float64))

    def _out(self, dtype: np.dtype[Any]) -> tuple[Any, Iterable[int]]:
        made = np.zeros(self.shape, dtype)
        if not self.many:
            return made, (address(made),)
        first = made.ctypes.data
        return made, range(first, first + self.count * dtype.itemsize, dtype.itemsize)

    def run(self, name: str, *columns: Any, kept: Sequence[Keeper] = (), sweep: Sweep = Sweep()) -> list[int]:
        """A call for each element, and the status of each. One of the columns may be a Workspace, of which `kept` keep parts."""
        function, single, found = function_of(name, self.single), self.single, []
        place = next((k for k, column in enumerate(columns) if isinstance(column, Workspace)), None)
        structure = "" if place is None else columns[place].structure
        calls = islice(zip(*(repeat(None) if k == place else column for k, column in enumerate(columns))), self.count)
        size = _BLOCK if sweep.threads > 1 or sweep.progress else self.count

        def work(block: list[tuple[Any, ...]]) -> tuple[list[int], list[list[bytearray]]]:
            if place is None:
                return [function(*each) for each in block], []
            space = memory.of(structure, single)
            statuses: list[int] = []
            parts: list[list[bytearray]] = [[] for _ in kept]
            for each in block:
                status = function(*each[:place], space.address, *each[place + 1 :])
                statuses.append(status)
                for part, keeper in zip(parts, kept):
                    part.append(keeper.take(space.raw, status))
            return statuses, parts

        with sweep.bar(self.count, name) as show:

            def done(result: tuple[list[int], list[list[bytearray]]]) -> None:
                found.extend(result[0])
                for keeper, part in zip(kept, result[1]):
                    keeper.keep(part)
                show(len(result[0]))

            sweep.each(iter(lambda: list(islice(calls, size)), []), work, done)
        return found

    def run_many(self, name: str, shared: Sequence[Any], inputs: Sequence[str], structure: str, outputs: Callable[[int, int], Sequence[Any]],
                 sweep: Sweep, further: Sequence[Any] = ()) -> list[int]:
        """Calls of a C function for many elements, one for each block of them, and the status of each element.

        shared: the first arguments. inputs: the names of the arguments that follow the count. further: the arguments after them.
        outputs(first, count): the arguments between the workspace, which is a `structure`, and the statuses.
        """
        function, found = function_of(name, self.single), np.zeros(count_of(self.count), np.int32)
        arrays = [self._begin(each) for each in inputs]

        def work(first: int) -> int:
            place = found[first : first + _BLOCK]
            count = len(place)
            given = [word for begin, stride in arrays for word in (begin and begin + first * stride, stride)]
            space = memory.of(structure, self.single)
            status = function(*shared, count, *given, *further, space.address, *outputs(first, count), place.ctypes.data)
            if status < 0 <= place.min():
                raise KstripError(status)
            return count

        with sweep.bar(self.count, name) as show:
            sweep.each(range(0, self.count, _BLOCK), work, show)
        statuses: list[int] = found.tolist()
        return statuses

    def _begin(self, name: str) -> tuple[Optional[int], int]:
        """Where the elements of an argument begin, and their distance in bytes."""
        if self._arguments[name][0] is None:
            return None, 0
        elements, distance = self.array(name)
        return elements.ctypes.data, distance

    def given(self, name: str) -> Any:
        """A copy of an argument."""
        return copy_of(self._arguments[name][1])

    def result(self, kind: type[Value], array: NDArray[np.void], statuses: Any) -> Any:
        """A batch, or a value if all arguments are values."""
        if self.many:
            return Batch(kind, array, statuses)
        if self.single:
            return layout_of(kind).value(np.array(array))
        return layout_of(kind).of_bytes(memory.of(kind._structure, False).raw)

    def numbers(self, array: Plain) -> Any:
        """An array, or a number if all arguments are values."""
        return array if self.many else float(array)

    def statuses(self, found: Any, *outputs: Optional[Plain]) -> Any:
        """Statuses in the shape of the elements, or that of one value; the outputs of elements that failed become NaN."""
        array = np.array(found, np.int32) if self.many else found
        for i in np.flatnonzero(array < 0) if self.many else range(found[0] < 0):
            for output in outputs:
                if output is not None:
                    blank(output.reshape(-1)[i : i + 1], int(array[i]))
        return array.reshape(self.shape) if self.many else found[0]

    def report(self, results: R, statuses: Any) -> R:
        """The results; raises the first error, or warns of the most serious warning."""
        if np.any(statuses) if self.many else statuses:
            self._report(results, np.reshape(statuses, -1))
        return results

    def _report(self, results: Any, found: Any) -> None:
        first = int(np.argmax(found < 0))
        if found[first] < 0 and self._on_error == "raise":
            raise KstripError(int(found[first]), self.index(first), results, found.reshape(self.shape)[()], self._shown(first))
        worst = max(np.unique(found).tolist(), key=gravity)
        if worst > 0:
            warn(worst, self.index(int(np.argmax(found == worst))))

    def index(self, i: int) -> Optional[tuple[int, ...]]:
        """The index of an element by its number; None for one value."""
        return tuple(int(k) for k in np.unravel_index(i, self.shape)) if self.shape else None

    def _shown(self, i: int) -> str:
        """The arguments of an element by name; those that all elements share are left out."""
        lines = []
        for name, (kind, value) in self._arguments.items():
            if isinstance(value, Batch):
                lines.append(f"{name}: {Batch(value.kind, np.broadcast_to(value.data, self.shape).reshape(-1))[i]}")
            elif kind is float and np.ndim(value):
                lines.append(f"{name}: {np.broadcast_to(value, self.shape).reshape(-1)[i]}")
        return "\n".join(lines)


def optional(kind: Any, value: Any) -> tuple[Any, Any]:
    """An argument that may be None."""
    return (None, None) if value is None else (kind, value)


def blank(element: Plain, status: int) -> None:
    """Fills structures with NaN, whole numbers with 0 and their status with a status."""
    if element.dtype.names is None:
        element[...] = np.nan if element.dtype.kind == "f" else 0
        return
    for name in element.dtype.names:
        blank(element[name], status)
        if name == "status_detail":
            element[name] = status
