"""The contacts of wheels: their motion and their forces."""

from __future__ import annotations

import math
import sys
from itertools import repeat
from typing import TYPE_CHECKING, Any, Optional

import numpy as np
from numpy.typing import NDArray

from ._batch import Batch
from ._calls import Elements, optional
from ._inputs import Many, is_single
from ._library import constants, dtype_of
from .values import Creepage, Friction, Motion, PatchStrip, StripPower, WheelContact, WheelPair, WheelVelocity, Wrench


class _Lists:
    """Where the workspace of a wheel has its contacts, and a contact the number of its strips and its lists of strips [bytes]."""

    def __init__(self, single: bool):
        contact, workspace = dtype_of("wheel_contact", single), dict(dtype_of("wheel_workspace", single).fields or {})
        fields, patch = dict(contact.fields or {}), dict(contact["patch"].fields or {})
        at = fields["patch"][1]
        self.begin, self.number_at = workspace["contacts"][1], workspace["count"][1]
        self.size, self.count_at = contact.itemsize, at + patch["count"][1]
        lists = [(at + patch["strips"][1], patch["strips"][0]), *((fields[name][1], fields[name][0]) for name in ("strip_rail_speed", "strip_y", "strip_z", "strip_angle", "strip_lean"))]
        #: of each list where it begins, the distance of two elements, and where it ends
        self.places = [(begin, kind.base.itemsize, begin + kind.itemsize) for begin, kind in lists]


_lists = {single: _Lists(single) for single in (False, True)}


class KeptContacts:
    """Collects the contacts that the calls for wheels leave in a workspace, which begins at a place of the memory [bytes]."""

    def __init__(self, single: bool, at: int = 0):
        self._lists, self._dtype = _lists[single], dtype_of("wheel_contact", single)
        self._begin, self._number_at = at + self._lists.begin, at + self._lists.number_at
        self._parts: list[bytearray] = []

    def take(self, workspace: bytearray, status: int) -> bytearray:
        """The contacts of a wheel, after the call with this status."""
        size, count_at = self._lists.size, self._lists.count_at
        number = int.from_bytes(workspace[self._number_at : self._number_at + 4], sys.byteorder) if status >= 0 else 0
        kept = workspace[self._begin : self._begin + size * number]
        for first in range(0, len(kept), size):
            # The library does not write the strips that a contact does not use.
            used = int.from_bytes(kept[first + count_at : first + count_at + 4], sys.byteorder)
            for begin, distance, end in self._lists.places:
                kept[first + begin + used * distance : first + end] = bytes(end - begin - used * distance)
        return kept

    def keep(self, parts: list[bytearray]) -> None:
        """Keeps the contacts of the next wheels."""
        self._parts += parts

    def batch(self, elements: Elements) -> Batch[WheelContact]:
        """The contacts of one wheel; or of many, with zeros behind those of a wheel that has fewer than another one."""
        most = max(map(len, self._parts), default=0)
        data = bytearray().join(part.ljust(most, b"\0") for part in self._parts)
        shape = (*elements.shape, most // self._dtype.itemsize)
        return Batch(WheelContact, np.frombuffer(data, self._dtype, math.prod(shape)).reshape(shape))


class ContactLists:
    """Memory for the contacts of many wheels, a part for each block of them."""

    def __init__(self, elements: Elements):
        self._shape, self._count = elements.shape, elements.count
        self._dtype, self._parts = dtype_of("wheel_contact", elements.single), dict[int, NDArray[np.void]]()

    def room(self, first: int, count: int) -> tuple[int, int]:
        """Memory for the contacts of some wheels: its address, and the number of contacts of a wheel for which it has room."""
        part = self._parts[first] = np.zeros((count, constants["KSTRIP_CONTACTS_CAPACITY"]), self._dtype)
        return part.ctypes.data, part.shape[1]

    def batch(self, most: int) -> Batch[WheelContact]:
        """The contacts, at most so many of a wheel, with zeros behind those of a wheel that has fewer than another one."""
        most = most if self._parts else 0
        listed = np.zeros((self._count, most), self._dtype)
        while self._parts:
            first, part = self._parts.popitem()
            listed[first : first + len(part)] = part[:, :most]
        return Batch(WheelContact, listed.reshape(*self._shape, most))


def contacts_in(memory: bytearray, requested: bool, at: int = 0) -> Batch[WheelContact]:
    """The contacts of one wheel in a workspace; none if they are not requested."""
    kept = KeptContacts(False, at).take(memory, 0 if requested else -1)
    return Batch(WheelContact, np.frombuffer(kept, dtype_of("wheel_contact", False)))


def wheel_motion(contacts: Many[WheelContact], velocity: Many[WheelVelocity], on_error: str = "raise") -> Any:
    """Slip, spin rate and rolling speed at contacts of wheels, for solve_motion(); contacts and velocity broadcast.

    Slip and spin rate divided by the rolling speed are the creepages: WheelOnRail has them as `creepages`.

    >>> position, velocity = kstrip.wheel_position(lateral=-6e-3, vertical=0.0), kstrip.wheel_velocity(forward=20.0, pitch=-43.3)
    >>> on = kstrip.wheel_on_rail(rail, wheel, pair, position, velocity)
    >>> print(kstrip.wheel_motion(on.contacts, velocity).slip_x.round(3))
    [0.023]
    """
    elements = Elements(is_single(contacts, velocity), on_error, contacts=(WheelContact, contacts), velocity=(WheelVelocity, velocity))
    made, places = elements.out("motion")
    found = elements.run("kstrip_wheel_motion", *elements.columns.values(), places)
    statuses = elements.statuses(found, made)
    return elements.report(elements.result(Motion, made, statuses), statuses)


class OfContacts:
    """Forces in each contact of wheels, for results that have contacts, pair, velocity and friction."""

    __slots__ = ()
    if TYPE_CHECKING:
        wrench: Many[Wrench]
        contacts: Batch[WheelContact]
        pair: Many[WheelPair]
        velocity: Many[WheelVelocity]
        friction: Optional[Many[Friction]]

    @property
    def counts(self) -> Any:
        """Number of contacts of each wheel."""
        return self.wrench.contacts

    @property
    def strips(self) -> Batch[PatchStrip]:
        """The strips of each contact: place, width, half length, pressure, friction. Shape (shape of `contacts`, most strips of a contact);
        those of a contact are its first `contacts.patch.count` ones, and the others are zero."""
        most = int(np.max(self.contacts.patch.count, initial=0))
        strips: Batch[PatchStrip] = self.contacts.patch.strips[..., :most]
        return strips

    @property
    def creepages(self) -> Batch[Creepage]:
        """The creepages of each contact: slip velocities and spin rate divided by the rolling speed, as in solve_motion(). Shape as `contacts`."""
        motion, speed = self._motion()
        data = np.zeros(motion.shape, dtype_of("creepage", is_single(motion)))
        for name, part in zip(Creepage.__match_args__, ("slip_x", "slip_y", "spin_rate")):
            np.divide(motion[part], speed, out=data[name], where=speed > 0.0)
        return Batch(Creepage, data)

    @property
    def wrenches(self) -> Batch[Wrench]:
        """Force and moment on the wheel by each contact alone, and its dissipation [W]. Shape as `contacts`."""
        contacts = self.contacts
        elements, models = self._given()
        made, places = elements.out("wrench")
        columns = elements.columns
        found = elements.run("kstrip_wrench_from_contacts", columns["contacts"], repeat(1), columns["velocity"], models, columns["friction"],
                             places, repeat(None))
        made[contacts.normal_force == 0.0] = np.zeros((), made.dtype)
        return Batch(Wrench, made, np.reshape(np.array(found, np.int32), made.shape))

    @property
    def power_across(self) -> Batch[StripPower]:
        """Load [N], sliding velocity [m/s] and frictional power [W] of each strip of each contact, and its y on the wheel's profile [m].

        Shape as `strips`. If the pair has the model "total", they are computed with the model "strip". kstrip.plot.wear() draws them."""
        contacts, most = self.contacts, self.strips.shape[-1]
        elements, models = self._given()
        made = np.zeros((*contacts.shape, most), dtype_of("strip_power", elements.single))
        counts = np.zeros(elements.count, np.uint32)
        places = (range(of.ctypes.data, of.ctypes.data + of.nbytes + 1, size) for of, size in ((made, most * made.itemsize or 1), (counts, 4)))
        columns = elements.columns
        elements.run("kstrip_contact_power_across", columns["contacts"], columns["velocity"], models, columns["friction"], next(places),
                     repeat(most), next(places))
        return Batch(StripPower, made)

    @property
    def t_gamma(self) -> NDArray[np.float64]:
        """Frictional power of each contact divided by its rolling speed [N]. Shape as `contacts`."""
        _, speed = self._motion()
        found = np.zeros(speed.shape)
        np.divide(self.wrenches.dissipation, speed, out=found, where=speed > 0.0)
        return found

    def _given(self) -> tuple[Elements, list[int]]:
        """Contacts, velocities and laws of friction as the C library takes them, and the model of each contact."""
        contacts, velocity, friction = self.contacts, _each(self.velocity), _each(self.friction)
        models = np.broadcast_to(np.asarray(self.pair.model)[..., None], contacts.shape).ravel().tolist()
        return Elements(is_single(contacts), "nan", contacts=(WheelContact, contacts), velocity=(WheelVelocity, velocity),
                        friction=optional(Friction, friction)), models

    def _motion(self) -> tuple[Batch[Motion], NDArray[np.float64]]:
        """Motion and speed at each contact."""
        motion = wheel_motion(self.contacts, _each(self.velocity))
        return motion, np.hypot(motion.rolling_speed, motion.floor_speed)


def _each(value: Any) -> Any:
    """Values of wheels as those of each of their contacts."""
    return value[..., None] if isinstance(value, Batch) else value
