"""Forces of contacts and patches in motion, their derivatives, strips and tractions."""

from __future__ import annotations

import dataclasses
import struct
import threading
from dataclasses import dataclass
from itertools import repeat
from typing import Any, Optional, Union, overload

import numpy as np
from numpy.typing import ArrayLike

from ._batch import Batch, layout_of
from ._calls import Elements, Sweep, address, call, optional, sweep_of, zeros
from ._inputs import Many, Model, Plain, array_of, count_of, floats, is_single, one, options, wrong
from ._library import constants, dtype_of, dtypes, lib
from ._group import Group
from ._status import KstripError, report
from ._value import Value
from .values import Contact, Creepage, Derivatives, Friction, LawDerivatives, Motion, MotionDerivatives, Patch, Point, Result, Strip

#: kstrip_outputs: addresses of result, derivatives, law_derivatives, friction, strips, count; capacity
_OUTPUTS = struct.Struct("6PII")
#: kstrip_motion_outputs: addresses of result, derivatives, friction
_MOTION_OUTPUTS = struct.Struct("3P")


@dataclass(slots=True, repr=False, eq=False)
class Evaluation(Group):
    """Result of evaluate(). Each member has the shape to which the inputs broadcast; None if it was not requested.

    result: fx, fy [N], mz [N m], power [N], adhesion, status_detail.
    friction: the coefficient of friction that agrees with the slip; of a patch the factor that its strips have in common.
    derivatives: jacobian, normal_force, load_through_hertz, friction.
    law_derivatives: ratio, decay, rolling_speed, slope_factor, slide_factor, layer.
    statuses: the status of each element.
    """

    result: Many[Result]
    friction: Any
    derivatives: Optional[Many[Derivatives]]
    law_derivatives: Optional[Many[LawDerivatives]]
    statuses: Any


@dataclass(slots=True, repr=False, eq=False)
class MotionEvaluation(Group):
    """Result of solve_motion(). Each member has the shape to which the inputs broadcast.

    result: fx, fy [N], mz [N m], power [W], adhesion, status_detail.
    friction: the coefficient of friction that agrees with the slip.
    derivatives: slip, rolling_speed, normal_force, load_through_hertz, friction, ratio, ...; None if they were not requested.
    statuses: the status of each element.
    """

    result: Many[Result]
    friction: Any
    derivatives: Optional[Many[MotionDerivatives]]
    statuses: Any


class _Memory(threading.local):
    """Memory of each thread for the results of one contact, and the structures that point to it."""

    def __init__(self) -> None:
        self.result, self.friction = bytearray(dtypes["result"].itemsize), bytearray(8)
        self.derivatives, self.laws = bytearray(dtypes["derivatives"].itemsize), bytearray(dtypes["law_derivatives"].itemsize)
        self.place = address(self.result)
        places = self.place, address(self.derivatives), address(self.laws), address(self.friction)
        #: by whether derivatives, and those of the law, are requested
        self.outputs = {(d, law): _OUTPUTS.pack(places[0], d * places[1], law * places[2], places[3], 0, 0, 0, 0)
                        for d in (False, True) for law in (False, True)}


_memory = _Memory()
_contact, _creepage, _friction, _result = layout_of(Contact), layout_of(Creepage), layout_of(Friction), layout_of(Result)


@overload
def solve(  # type: ignore[overload-overlap]  # pyright: ignore[reportOverlappingOverload]
        contacts: Union[Contact, Patch], creepages: Creepage, friction: Optional[Friction] = None, model: Model = "default",
        strips: int = 0, on_error: str = "raise", threads: int = 1, progress: bool = False) -> Result: ...
@overload
def solve(contacts: Union[Many[Contact], Patch], creepages: Many[Creepage], friction: Optional[Many[Friction]] = None,
          model: Model = "default", strips: int = 0, on_error: str = "raise", threads: int = 1, progress: bool = False) -> Batch[Result]: ...
def solve(contacts: Union[Many[Contact], Patch], creepages: Many[Creepage], friction: Optional[Many[Friction]] = None,
          model: Model = "default", strips: int = 0, on_error: str = "raise", threads: int = 1, progress: bool = False) -> Any:
    """Forces on the lower body of contacts, or of one patch, in motion.

    contacts, creepages: of contact() and creepage(); they broadcast. One contact with one creepage has one result, arrays have a batch.
    friction: a law of friction() that falls with the slip, or many of them.
    model: "default", "total", "strip", "strip_1967", "strip_1967_continuous", "linear". strips: 4, 8, 16, 32 or 64; 0: 16.
    on_error: of arrays: "raise" raises KstripError, which has the results of the other elements; "nan" returns NaN for a bad element, and
        its status in `statuses`.
    threads: of arrays: the elements are computed in so many threads. The results have the same bits for any number, and other threads of
        the program run meanwhile. progress: a bar shows the progress if tqdm is installed.
    Warns by KstripWarning.

    >>> contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    >>> print(kstrip.solve(contact, kstrip.creepage([1e-3, 2e-3])).fx.round(-3))
    [ 9000. 15000.]
    """
    if type(contacts) is Contact and type(creepages) is Creepage and friction is None and on_error == "raise":
        place = _memory.place
        status = lib.kstrip_solve(_contact.pack(contacts), _creepage.pack(creepages), options(model, strips), place)
        result = _result.of_bytes(_memory.result)
        if status:
            report(status)
        return result
    try:
        return evaluate(contacts, creepages, friction, model, strips, derivatives=False, on_error=on_error, threads=threads,
                        progress=progress).result
    except KstripError as error:
        error.results = getattr(error.results, "result", None)
        raise


def evaluate(contacts: Union[Many[Contact], Patch], creepages: Many[Creepage], friction: Optional[Many[Friction]] = None,
             model: Model = "default", strips: int = 0, *, derivatives: bool = True, law_derivatives: bool = False,
             own: Optional[Batch[Creepage]] = None, on_error: str = "raise", threads: int = 1, progress: bool = False) -> Evaluation:
    """Forces, the friction that agrees with the slip, and derivatives; of contacts or of one patch.

    Arguments as in solve(). The derivatives have the shape of the results; `derivatives.jacobian` has (3, 3) behind it, the derivatives of
    fx, fy, mz with respect to longitudinal, lateral, spin.
    own: of one patch, a creepage for each of its strips, shape (number of strips,): the one that the strip has at its centre besides those
    of the patch, as on curved surfaces.

    >>> contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    >>> found = kstrip.evaluate(contact, kstrip.creepage(1e-3), kstrip.friction(0.3, 0.4, 0.6, rolling_speed=20.0))
    >>> print(f"fx {found.result.fx:.0f} N, friction {found.friction:.4f}, dfx/dlongitudinal {found.derivatives.jacobian[0, 0]:.2e} N")
    fx 8815 N, friction 0.2992, dfx/dlongitudinal 7.62e+06 N
    """
    if type(contacts) is Contact and type(creepages) is Creepage and (friction is None or type(friction) is Friction) and own is None and on_error == "raise":
        return _evaluate_one(contacts, creepages, friction, options(model, strips), bool(derivatives), bool(law_derivatives))
    wanted = ("result", *["derivatives"] * bool(derivatives), *["law_derivatives"] * bool(law_derivatives))
    if is_patch(contacts):
        return _evaluate_patch(contacts, creepages, friction, model, strips, wanted, own, on_error, sweep_of(threads, progress))
    if own is not None:
        raise ValueError("own is for one patch")
    return _evaluate_batch(contacts, creepages, friction, model, strips, wanted, on_error, sweep_of(threads, progress))


def _evaluate_one(contact: Contact, creepage: Creepage, law: Optional[Friction], chosen: Optional[bytes], derivatives: bool, laws: bool) -> Evaluation:
    """One contact: the results are in memory of the thread."""
    memory = _memory
    status = lib.kstrip_evaluate(_contact.pack(contact), _creepage.pack(creepage), None if law is None else _friction.pack(law), chosen,
                                 memory.outputs[derivatives, laws])
    made = Evaluation(_result.of_bytes(memory.result), struct.unpack("d", memory.friction)[0],
                      layout_of(Derivatives).of_bytes(memory.derivatives) if derivatives else None,
                      layout_of(LawDerivatives).of_bytes(memory.laws) if laws else None, status)
    if status:
        report(status)
    return made


def is_patch(area: Any) -> bool:
    return type(area) is Patch or type(area) is Batch and area.kind is Patch


def _own(own: Any, patch: bytes, single: bool) -> Optional[bytes]:
    """The creepages of each strip."""
    if own is None:
        return None
    given, count = array_of("own", Creepage, own, single), int(np.frombuffer(patch, dtype_of("patch", single))["count"][0])
    if given.shape != (count,):
        raise ValueError(f"own: shape {given.shape}, and the patch has {count} strips")
    return given.tobytes()


def _evaluate_patch(area: Any, creepages: Any, law: Any, model: Model, strips: int, wanted: tuple[str, ...], own: Any, on_error: str,
                    sweep: Sweep) -> Evaluation:
    """One patch: a call for each creepage."""
    single = is_single(area, creepages, law, own)
    patch = one("contacts", Patch, area, single)
    elements = Elements(single, on_error, creepages=(Creepage, creepages), friction=optional(Friction, law))
    made = {name: elements.out(name) for name in wanted}
    shared, third = elements.real()
    places = [made[name][1] if name in made else repeat(0) for name in ("result", "derivatives", "law_derivatives")]
    outputs = map(_OUTPUTS.pack, *places, third, *[repeat(0)] * 4)
    found = elements.run("kstrip_patch_evaluate_strips", repeat(patch), elements.columns["creepages"], repeat(_own(own, patch, single)),
                         elements.columns["friction"], repeat(options(model, strips)), outputs, sweep=sweep)
    arrays = {name: array for name, (array, _) in made.items()}
    statuses = elements.statuses(found, *arrays.values(), shared)
    return elements.report(_evaluation(elements, arrays, shared, statuses), statuses)


def _evaluation(elements: Elements, arrays: dict[str, Any], friction: Plain, statuses: Any) -> Evaluation:
    kinds: dict[str, type[Value]] = {"result": Result, "derivatives": Derivatives, "law_derivatives": LawDerivatives}
    parts = {name: elements.result(kinds[name], array, statuses) for name, array in arrays.items()}
    return Evaluation(parts["result"], elements.numbers(friction), parts.get("derivatives"), parts.get("law_derivatives"), statuses)


#: Contacts that one thread computes before it takes others
_PART = 8192


def _evaluate_batch(contacts: Any, creepages: Any, law: Any, model: Model, strips: int, wanted: tuple[str, ...], on_error: str,
                    sweep: Sweep) -> Evaluation:
    """Many contacts: one call of kstrip_evaluate_batch() for all, or for each part, and more of them only where an element is bad."""
    elements = Elements(is_single(contacts, creepages, law), on_error, contacts=(Contact, contacts), creepages=(Creepage, creepages),
                        friction=optional(Friction, law))
    inputs = [word for name in ("contacts", "creepages") for word in _members(*elements.array(name))]
    inputs += [(0, 0)] if law is None else [(elements.array("friction")[0].ctypes.data, elements.array("friction")[1])]
    arrays = {name: elements.out(name)[0] for name in wanted}
    friction, _ = elements.real()
    outputs = _members(arrays["result"].reshape(-1), arrays["result"].itemsize)
    outputs += [(array.ctypes.data, array.itemsize) if array is not None else (0, 0)
                for array in (friction, arrays.get("derivatives"), arrays.get("law_derivatives"))]
    found = np.zeros(count_of(elements.count), np.int32)
    places, size = (np.array(inputs, np.intp), np.array(outputs, np.intp)), _PART if sweep != Sweep() else max(1, elements.count)

    def work(begin: int) -> int:
        end = min(begin + size, elements.count)
        _solve_all(elements.single, *places, options(model, strips), found, begin, end)
        return end - begin

    with sweep.bar(elements.count, "evaluate") as show:
        sweep.each(range(0, elements.count, size), work, show)
    found = np.where(found < 0, found, arrays["result"]["status_detail"].reshape(-1))
    statuses = elements.statuses(found, *arrays.values(), friction)
    return elements.report(_evaluation(elements, arrays, friction, statuses), statuses)


def _members(array: Plain, distance: int) -> list[tuple[int, int]]:
    """Address and distance of each member of structures."""
    first, fields = array.ctypes.data, dict(array.dtype.fields or {})
    return [(first + field[1], distance) for name, field in fields.items() if name != "reserved"]


def _solve_all(single: bool, inputs: Plain, outputs: Plain, chosen: Optional[bytes], found: Plain, begin: int, end: int) -> None:
    """Solves the elements of a part but the bad ones, whose statuses it writes: the library solves none if one is bad."""
    function, bad = (lib.kstrip_evaluate_batch_f32 if single else lib.kstrip_evaluate_batch), np.zeros((), np.uint32)
    while True:
        moved = inputs.copy(), outputs.copy()
        for words in moved:
            words[:, 0] += begin * words[:, 1]
        status = function(moved[0].ctypes.data, end - begin, chosen, moved[1].ctypes.data, bad.ctypes.data)
        if status >= 0:
            return
        if int(bad) >= end - begin:
            raise KstripError(status)
        first = begin + int(bad)
        if first > begin:
            _solve_all(single, inputs, outputs, chosen, found, begin, first)
        found[first], begin = status, first + 1


def solve_motion(contacts: Many[Contact], motions: Many[Motion], friction: Optional[Many[Friction]] = None, model: Model = "default",
                 strips: int = 0, *, derivatives: bool = True, on_error: str = "raise", threads: int = 1, progress: bool = False) -> MotionEvaluation:
    """Forces of contacts that roll forward, backward or not at all, with derivatives; contacts, motions and friction broadcast.

    on_error, threads, progress: as in solve().

    >>> contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    >>> found = kstrip.solve_motion(contact, kstrip.motion(slip_x=1e-3, rolling_speed=[-10.0, 0.0, 10.0]))
    >>> found.result.fx.round()
    array([  994., 24000.,   994.])
    """
    sweep = sweep_of(threads, progress)
    elements = Elements(is_single(contacts, motions, friction), on_error, contacts=(Contact, contacts), motions=(Motion, motions),
                        friction=optional(Friction, friction))
    (results, first), (shared, third) = elements.out("result"), elements.real()
    slopes, second = elements.out("motion_derivatives") if derivatives else (None, repeat(0))
    found = elements.run("kstrip_solve_motion", *elements.columns.values(), repeat(options(model, strips)),
                         map(_MOTION_OUTPUTS.pack, first, second, third), sweep=sweep)
    statuses = elements.statuses(found, results, slopes, shared)
    made = MotionEvaluation(elements.result(Result, results, statuses), elements.numbers(shared),
                            None if slopes is None else elements.result(MotionDerivatives, slopes, statuses), statuses)
    return elements.report(made, statuses)


@dataclass(slots=True, repr=False, eq=False, init=False)
class Prepared(Group):
    """A contact for which everything that does not depend on the motion has been computed: kstrip.prepare().

    contact, model, strips: the inputs.
    """

    contact: Many[Contact]
    model: Model
    strips: int
    _numbers: bytes = dataclasses.field(init=False)

    def __init__(self, contact: Many[Contact], model: Model = "default", strips: int = 0):
        self.contact, self.model, self.strips = contact, model, strips
        made = zeros("prepared", is_single(contact))
        call("kstrip_prepare", is_single(contact), one("contact", Contact, contact, is_single(contact)), options(model, strips), made)
        self._numbers = made.tobytes()

    def solve(self, creepages: Many[Creepage], on_error: str = "raise") -> Any:
        """The results of kstrip.solve(), bit for bit."""
        elements = Elements(is_single(self.contact), on_error, creepages=(Creepage, creepages))
        results, places = elements.out("result")
        found = elements.run("kstrip_solve_prepared", repeat(self._numbers), elements.columns["creepages"], places)
        statuses = elements.statuses(found, results)
        return elements.report(elements.result(Result, results, statuses), statuses)


def prepare(contact: Many[Contact], model: Model = "default", strips: int = 0) -> Prepared:
    """One contact, for rigs in which it is constant and for iterations on the creepage: `prepare(contact).solve(creepages)`.

    >>> contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    >>> prepared = kstrip.prepare(contact)
    >>> prepared.solve(kstrip.creepage(1e-3)) == kstrip.solve(contact, kstrip.creepage(1e-3))
    True
    """
    return Prepared(contact, model, strips)


def strips(area: Union[Contact, Patch], creepage: Creepage, friction: Optional[Friction] = None, model: Model = "default",
           strips: int = 0, *, own: Optional[Batch[Creepage]] = None) -> Batch[Strip]:
    """The forces of each strip of one contact or one patch, shape (number of strips,). own: as in evaluate().

    >>> contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    >>> found = kstrip.strips(contact, kstrip.creepage(1e-3), strips=8)
    >>> print(f"{len(found)} strips, {found.fx.sum():.0f} N")
    8 strips, 8756 N
    """
    single, kind = is_single(area, creepage, friction), Patch if is_patch(area) else Contact
    name = "kstrip_patch_evaluate_strips" if kind is Patch else "kstrip_evaluate"
    body = one("area", kind, area, single)
    capacity, count = constants["KSTRIP_STRIPS_CAPACITY"], np.zeros((), np.uint32)
    found = np.zeros(capacity, dtype_of("strip", single))
    outputs = _OUTPUTS.pack(0, 0, 0, 0, address(found), address(count), capacity, 0)
    if kind is Contact and own is not None:
        raise ValueError("own is for one patch")
    besides = (_own(own, body, single),) if kind is Patch else ()
    call(name, single, body, one("creepage", Creepage, creepage, single), *besides, _law(friction, single), options(model, strips), outputs)
    return Batch(Strip, found[: int(count)])


def _law(friction: Optional[Friction], single: bool) -> Optional[bytes]:
    return None if friction is None else one("friction", Friction, friction, single)


def field(area: Union[Contact, Patch], creepage: Creepage, x: ArrayLike, y: ArrayLike, model: Model = "default",
          strips: int = 0, friction: Optional[Friction] = None) -> Batch[Point]:
    """Pressure, traction, slip, dissipation and state of one contact or patch at all (x[i], y[j]) [m].

    friction: a law of friction() that falls with the slip, or has a layer.

    Returns points of shape (y.size, x.size): element [j, i]. States: OUTSIDE, STICK, SLIP, SLIP_NEGATIVE_DISSIPATION.

    >>> contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    >>> points = kstrip.field(contact, kstrip.creepage(1e-3), x=[-5e-3, 0.0, 7e-3], y=[0.0])
    >>> points.state, points.pressure.round(-6)
    (array([[2, 1, 0]], dtype=int32), array([[7.820e+08, 1.415e+09, 0.000e+00]]))
    """
    single, kind = is_single(area, creepage, friction), Patch if is_patch(area) else Contact
    name = "kstrip_patch_field" if kind is Patch else "kstrip_field"
    across, along = floats(x, "x", single).reshape(-1), floats(y, "y", single).reshape(-1)
    points = np.zeros((along.size, across.size), dtype_of("point", single))
    call(name, single, one("area", kind, area, single), one("creepage", Creepage, creepage, single), _law(friction, single),
         options(model, strips), across, across.size, along, along.size, points, count_of(points.size))
    return Batch(Point, points)


def on_upper_body(results: Many[Result]) -> Any:
    """The same results seen from the upper body (the wheel): opposite forces and moment.

    >>> contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    >>> kstrip.on_upper_body(kstrip.solve(contact, kstrip.creepage(1e-3))).fx < 0.0
    True
    """
    if type(results) is not Result and not (type(results) is Batch and results.kind is Result):
        raise wrong("results", Result, results)
    turned: Any = dataclasses.replace(results) if isinstance(results, Result) else results.copy()
    for member in ("fx", "fy", "mz"):
        turned[member] = -turned[member]
    return turned
