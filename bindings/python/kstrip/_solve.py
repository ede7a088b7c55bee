"""Forces of contacts and patches in motion, their derivatives, and what is inside."""

from __future__ import annotations

import ctypes
from typing import Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._calls import call, each, index_of, out, real, size_of
from ._inputs import Model, Plain, Shape, broadcast, count_of, flat, floats, is_patch, is_single, one, options, records
from ._library import constants, dtypes, function_of, structures
from ._record import as_record
from ._status import report
from ._types import Contact, Creepage, Derivatives, Friction, LawDerivatives, Motion, MotionDerivatives, Patch, Point, Result, Strip


class Evaluation(NamedTuple):
    """What evaluate() returns. Each member has the shape to which the inputs broadcast; None where it was not asked for."""

    #: fx, fy [N], mz [N m], power [N], adhesion, status_detail
    result: Result
    #: the coefficient of friction that agrees with the slip; of a patch the factor that its strips have in common
    friction: NDArray[np.float64]
    #: jacobian, normal_force, load_through_hertz, friction
    derivatives: Optional[Derivatives]
    #: ratio, decay, rolling_speed, slope_factor
    law_derivatives: Optional[LawDerivatives]


class MotionEvaluation(NamedTuple):
    """What solve_motion() returns. Each member has the shape to which the inputs broadcast."""

    #: fx, fy [N], mz [N m], power [W], adhesion, status_detail
    result: Result
    #: the coefficient of friction that agrees with the slip
    friction: NDArray[np.float64]
    #: slip, rolling_speed, normal_force, load_through_hertz, friction, ratio, ...; None where they were not asked for
    derivatives: Optional[MotionDerivatives]


def _batch(contacts: Any, creepages: Any, law: Any, model: Model, strips: int, wanted: tuple[str, ...]) -> dict[str, Plain]:
    """kstrip_evaluate_batch(): one call for all elements."""
    single = is_single(contacts, creepages, law)
    suffix = "_f32" * single
    ellipses, motions = records("contact", contacts, single), records("creepage", creepages, single)
    laws = None if law is None else records("friction", law, single)
    shape = broadcast(contacts=ellipses, creepages=motions, friction=laws)
    count = count_of(size_of(shape))
    inputs = structures["kstrip_batch_inputs" + suffix]()
    kept = [flat(ellipses, shape), flat(motions, shape)]
    for array, distance in kept:
        members: Any = array.dtype.fields
        for member in members:
            setattr(inputs, member, array.ctypes.data + members[member][1])
            setattr(inputs, f"{member}_stride", distance)
    if laws is not None:
        kept.append(flat(laws, shape))
        setattr(inputs, "law", kept[2][0].ctypes.data)
        setattr(inputs, "law_stride", kept[2][1])
    made: dict[str, Plain] = {"result": np.zeros(count, dtypes["result" + suffix])}
    if "friction" in wanted:
        made["friction"] = real(shape, single)[0]
    for name in ("derivatives", "law_derivatives"):
        if name in wanted:
            made[name] = np.zeros(count, dtypes[name + suffix])
    outputs = structures["kstrip_batch_outputs" + suffix]()
    fields: Any = made["result"].dtype.fields
    places = {member: (made["result"], fields[member][1]) for member in fields if member != "reserved"}
    places |= {name: (array, 0) for name, array in made.items() if name != "result"}
    for member, (array, offset) in places.items():
        setattr(outputs, member, array.ctypes.data + offset)
        setattr(outputs, f"{member}_stride", array.dtype.itemsize)
    bad = ctypes.c_uint32()
    status = function_of("kstrip_evaluate_batch", single)(
        ctypes.byref(inputs), count, ctypes.byref(options(model, strips)), ctypes.byref(outputs), ctypes.byref(bad))
    first = bad.value if status < 0 else int(np.argmax(made["result"]["status_detail"] == status)) if status else 0
    report(status, index_of(first, shape) if status and first < count else None)
    return {name: as_record(array.reshape(shape)) for name, array in made.items()}


def _outputs(kind: str, made: dict[str, tuple[Plain, int]], shape: Shape, suffix: str) -> tuple[Plain, int]:
    """A structure of pointers for each element."""
    outputs = np.zeros(size_of(shape), dtypes[kind + suffix])
    for name, (array, distance) in made.items():
        outputs[name] = array.ctypes.data + distance * np.arange(outputs.size)
    return outputs, outputs.dtype.itemsize


def _only_of_patch(own: Any, area: Any) -> None:
    if own is not None and not is_patch(area):
        raise ValueError("own is for one patch; these are contacts")


def _own(own: Any, patch: Plain, single: bool) -> Optional[Plain]:
    """The creepages of a patch's strips, one for each."""
    if own is None:
        return None
    made, count = np.ascontiguousarray(records("creepage", own, single)), int(patch.reshape(-1)["count"][0])
    if made.shape != (count,):
        raise ValueError(f"own: shape {made.shape}, and the patch has {count} strips")
    return made


def _of_patch(area: Any, creepages: Any, law: Any, model: Model, strips: int, wanted: tuple[str, ...],
              own: Any = None) -> dict[str, Plain]:
    """kstrip_patch_evaluate_strips() for each creepage."""
    single = is_single(area, creepages, law)
    patch, motions = one("patch", area, single), records("creepage", creepages, single)
    laws = None if law is None else records("friction", law, single)
    shape = broadcast(creepages=motions, friction=laws)
    made: dict[str, tuple[Plain, int]] = {"result": out("result", shape, single)}
    if "friction" in wanted:
        made["friction"] = real(shape, single)
    for name in ("derivatives", "law_derivatives"):
        if name in wanted:
            made[name] = out(name, shape, single)
    outputs = _outputs("outputs", made, shape, "_f32" * single)
    besides = _own(own, patch, single)
    each("kstrip_patch_evaluate_strips", single, shape, patch.ctypes.data, flat(motions, shape), None if besides is None else besides.ctypes.data,
         None if laws is None else flat(laws, shape), ctypes.byref(options(model, strips)), outputs)
    return {name: as_record(array.reshape(shape)) for name, (array, _) in made.items()}


def solve(contacts: Union[Contact, Patch], creepages: Creepage, friction: Optional[Friction] = None, model: Model = "default",
          strips: int = 0) -> Result:
    """Forces on the lower body: fx, fy [N], mz [N m], power [N], adhesion, status_detail.

    contacts: contact(), or one patch of any shape. creepages: creepage(). Both broadcast, and friction with them.
    friction: a law of friction() that falls with the slip; None: constant.
    model: a name of kstrip.models; "default" is "total", and "strip" for patches. strips: 4, 8, 16, 32 or 64; 0: 16.
    Raises KstripError for bad input, with the index of the first one; warns by KstripWarning.

    >>> contact = kstrip.contact(a=6e-3, b=4.5e-3, normal_force=80e3, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3)
    >>> print(kstrip.solve(contact, kstrip.creepage([1e-3, 2e-3])).fx.round(-3))
    [ 9000. 15000.]
    """
    solved = (_of_patch if is_patch(contacts) else _batch)(contacts, creepages, friction, model, strips, ())
    return solved["result"].view(Result)


def evaluate(contacts: Union[Contact, Patch], creepages: Creepage, friction: Optional[Friction] = None, model: Model = "default",
             strips: int = 0, *, derivatives: bool = True, law_derivatives: bool = False, own: Optional[Creepage] = None) -> Evaluation:
    """Forces, the friction that agrees with the slip, and derivatives; of contacts or of one patch.

    Arguments as in solve(). The derivatives have the shape of the results; `derivatives.jacobian` has (3, 3) behind it, the
    derivatives of fx, fy, mz with respect to longitudinal, lateral, spin.
    own: of one patch, a creepage for each of its strips, shape (number of strips,): that which the strip has at its centre
    besides those of the patch, as on curved surfaces.
    """
    _only_of_patch(own, contacts)
    wanted = ("friction",) + ("derivatives",) * bool(derivatives) + ("law_derivatives",) * bool(law_derivatives)
    arguments = (contacts, creepages, friction, model, strips, wanted)
    made: dict[str, Any] = dict(_of_patch(*arguments, own) if is_patch(contacts) else _batch(*arguments))
    return Evaluation(made["result"], made["friction"], made.get("derivatives"), made.get("law_derivatives"))


def solve_motion(contacts: Contact, motions: Motion, friction: Optional[Friction] = None, model: Model = "default",
                 strips: int = 0, *, derivatives: bool = True) -> MotionEvaluation:
    """Forces of contacts that roll forward, backward or not at all, with derivatives; contacts, motions and friction broadcast."""
    single = is_single(contacts, motions, friction)
    ellipses, moving = records("contact", contacts, single), records("motion", motions, single)
    laws = None if friction is None else records("friction", friction, single)
    shape = broadcast(contacts=ellipses, motions=moving, friction=laws)
    made: dict[str, tuple[Plain, int]] = {"result": out("result", shape, single), "friction": real(shape, single)}
    if derivatives:
        made["derivatives"] = out("motion_derivatives", shape, single)
    outputs = _outputs("motion_outputs", made, shape, "_f32" * single)
    each("kstrip_solve_motion", single, shape, flat(ellipses, shape), flat(moving, shape),
         None if laws is None else flat(laws, shape), ctypes.byref(options(model, strips)), outputs)
    answers: dict[str, Any] = {name: as_record(array.reshape(shape)) for name, (array, _) in made.items()}
    return MotionEvaluation(answers["result"], answers["friction"], answers.get("derivatives"))


class Prepared:
    """A contact of which everything that does not depend on the motion has been computed: kstrip_prepare()."""

    def __init__(self, contact: Contact, model: Model = "default", strips: int = 0):
        self._single = is_single(contact)
        only = one("contact", contact, self._single)
        self._numbers = np.zeros((), dtypes["prepared" + "_f32" * self._single])
        call("kstrip_prepare", self._single, only, ctypes.byref(options(model, strips)), self._numbers)

    def solve(self, creepages: Creepage) -> Result:
        """The results of kstrip.solve(), bit for bit."""
        motions = records("creepage", creepages, self._single)
        made = out("result", motions.shape, self._single)
        each("kstrip_solve_prepared", self._single, motions.shape, self._numbers.ctypes.data, flat(motions, motions.shape), made)
        return made[0].reshape(motions.shape).view(Result)


def prepare(contact: Contact, model: Model = "default", strips: int = 0) -> Prepared:
    """One contact, for rigs in which it is constant and for iterations on the creepage: `prepare(contact).solve(creepages)`."""
    return Prepared(contact, model, strips)


def strips(area: Union[Contact, Patch], creepage: Creepage, friction: Optional[Friction] = None, model: Model = "default",
           strips: int = 0, *, own: Optional[Creepage] = None) -> Strip:
    """What each strip of one contact or one patch carries, shape (number of strips,). own: as in evaluate()."""
    _only_of_patch(own, area)
    kind, name = ("patch", "kstrip_patch_evaluate_strips") if is_patch(area) else ("contact", "kstrip_evaluate")
    single = is_single(area, creepage, friction)
    only, motion = one(kind, area, single), one("creepage", creepage, single)
    law = None if friction is None else one("friction", friction, single)
    capacity, count = constants["KSTRIP_STRIPS_CAPACITY"], np.zeros((), np.uint32)
    found = np.zeros(capacity, dtypes["strip" + "_f32" * single])
    outputs = structures["kstrip_outputs" + "_f32" * single](
        strips=found.ctypes.data, count=count.ctypes.data, capacity=capacity)
    besides = (_own(own, only, single),) if is_patch(area) else ()
    call(name, single, only, motion, *besides, law, ctypes.byref(options(model, strips)), ctypes.byref(outputs))
    return found[: int(count)].view(Strip)


def field(area: Union[Contact, Patch], creepage: Creepage, x: ArrayLike, y: ArrayLike, model: Model = "default",
          strips: int = 0, friction: Optional[Friction] = None) -> Point:
    """Pressure, traction, slip, dissipation and state of one contact or patch at all (x[i], y[j]) [m].

    friction: a law of friction() that falls with the slip, or has a layer.

    Returns points of shape (y.size, x.size): element [j, i]. States: OUTSIDE, STICK, SLIP, SLIP_NEGATIVE_DISSIPATION.
    """
    kind, name = ("patch", "kstrip_patch_field") if is_patch(area) else ("contact", "kstrip_field")
    single = is_single(area, creepage, friction)
    only, motion = one(kind, area, single), one("creepage", creepage, single)
    law = None if friction is None else one("friction", friction, single)
    across, along = floats(x, "x", single).reshape(-1), floats(y, "y", single).reshape(-1)
    count_of(across.size * along.size)
    points = np.zeros((along.size, across.size), dtypes["point" + "_f32" * single])
    call(name, single, only, motion, law, ctypes.byref(options(model, strips)), across, across.size, along, along.size, points, points.size)
    return points.view(Point)


def on_upper_body(results: Result) -> Result:
    """The same results seen from the upper body (the wheel): opposite forces and moment."""
    turned = records("result", results, is_single(results)).copy()
    for member in ("fx", "fy", "mz"):
        turned[member] = -turned[member]
    return turned.view(Result)
