"""Contact tables: wheels on a rail in microseconds."""

from __future__ import annotations

import pathlib
from itertools import repeat
from typing import Any, Optional

import numpy as np

from ._calls import Elements, Workspace, address, call, memory, optional, sweep_of, zeros
from ._contacts import KeptContacts
from ._files import Path
from ._inputs import Many, is_single, number, one
from ._library import function_of
from ._status import KstripError
from ._wheel import PreparedProfile, WheelOnRail, prepared, structure_of
from .values import Friction, WheelPair, WheelPosition, WheelVelocity, Wrench, WrenchByPosition, WrenchDerivatives

#: Parts that one call fills
_PARTS = 4


class ContactTable:
    """The contacts of a wheel on a straight rail by lateral position, height, yaw and roll: wheels in about a quarter of the time.

    rail, wheel, pair: as in wheel_on_rail(). Side, friction, damping, strips and model of the pair do not matter.
    lateral: the first and the last lateral position without yaw and roll [m]. load: largest support of the wheel [N].
    yaw, roll: largest to both sides [rad]. lateral_nodes, levels, yaw_nodes, roll_nodes: 0: the library's choice.
    strips: in 8 mm of a contact, 12 to 32.
    poses: at how many positions the error is measured. threads, progress: as in solve().

    only: whether a position outside the table is an error in functions that take a table; False: its contacts are computed there.

    raw: the bytes of the table, as every language has them. report: with which it was made; None for one that was read: its length, and the error
    `force_usual`, `force_largest` of the horizontal force over friction times load, `load_usual`, `load_largest` of the load over itself.

    >>> table = kstrip.ContactTable(rail, wheel, pair, lateral=(-7e-3, -5e-3), load=120e3, lateral_nodes=9, levels=8, poses=20)
    >>> table.report["poses"], table.report["missing"]
    (20, 0)
    >>> position = kstrip.wheel_position(lateral=-6e-3)
    >>> position.vertical = kstrip.height_for_load(rail, wheel, pair, position, 80e3)
    >>> on = table.wheel(pair, position, kstrip.wheel_velocity(forward=20.0, pitch=-20.0 / 0.46))
    >>> print(f"{1e-3 * on.wrench.force[1]:.1f} kN")
    -3.8 kN
    """

    __slots__ = ("only", "raw", "report")

    only: bool
    raw: bytes
    report: Optional[dict[str, float]]

    def __init__(self, rail: PreparedProfile, wheel: PreparedProfile, pair: WheelPair, lateral: tuple[float, float], load: float, yaw: float = 0.0,
                 roll: float = 0.0, lateral_nodes: int = 0, levels: int = 0, yaw_nodes: int = 0, roll_nodes: int = 0, strips: int = 16, poses: int = 500,
                 threads: int = 1, progress: bool = False, only: bool = False):
        sweep, single = sweep_of(threads, progress), is_single(rail)
        spec = zeros("table_spec", single)
        ends = [number(end, "lateral") for end in lateral]
        numbers = {"lateral_from": ends[0], "lateral_to": ends[-1], "yaw": number(yaw, "yaw"), "roll": number(roll, "roll"),
                   "load": number(load, "load"), "lateral_nodes": lateral_nodes, "levels": levels, "yaw_nodes": yaw_nodes, "roll_nodes": roll_nodes, "strips": strips}
        for name, value in numbers.items():
            spec[name] = value
        given = (prepared("rail", rail, single), prepared("wheel", wheel, single), one("pair", WheelPair, pair, single))
        size, parts = np.zeros((), np.uint32), np.zeros((), np.uint32)
        call("kstrip_table_size", single, given[1], spec, size, parts)
        made = bytearray(int(size))
        place, length = address(made), len(made)
        call("kstrip_table_begin", single, *given, spec, memory.of("wheel_workspace", single).address, place, length)
        fill = function_of("kstrip_table_fill", single)

        def work(first: int) -> tuple[int, int]:
            count = min(_PARTS, int(parts) - first)
            return fill(*given, first, count, memory.of("wheel_workspace", single).address, place, length), count

        with sweep.bar(int(parts), "kstrip_table") as show:

            def done(result: tuple[int, int]) -> None:
                if result[0] < 0:
                    raise KstripError(result[0])
                show(result[1])

            sweep.each(range(0, int(parts), _PARTS), work, done)
        report = zeros("table_report", single)
        call("kstrip_table_finish", single, *given, poses, memory.of("wheel_workspace", single).address, place, length, report)
        names = report.dtype.names or ()
        self.raw, self.report = bytes(made[: int(report["bytes"])]), {name: report[name].item() for name in names}
        self.only = only

    @classmethod
    def of_bytes(cls, raw: bytes, only: bool = False) -> ContactTable:
        """The table of these bytes. KstripError if they are damaged, or not those of a table."""
        length = np.zeros((), np.uint32)
        call("kstrip_table_check", False, bytes(raw), len(raw), length)
        made = cls.__new__(cls)
        made.raw, made.report, made.only = bytes(raw[: int(length)]), None, only
        return made

    def save(self, path: Path) -> None:
        """Writes a file, which ContactTable.read() and every other language can read."""
        pathlib.Path(path).write_bytes(self.raw)

    @classmethod
    def read(cls, path: Path, only: bool = False) -> ContactTable:
        """The table in a file. KstripError if it is damaged, or not that of a table."""
        return cls.of_bytes(pathlib.Path(path).read_bytes(), only)

    def wheel(self, pair: Many[WheelPair], position: Many[WheelPosition], velocity: Many[WheelVelocity],
              friction: Optional[Many[Friction]] = None, by_position: bool = False, contacts: bool = True, on_error: str = "raise",
              threads: int = 1, progress: bool = False) -> WheelOnRail:
        """Force and moment on wheels, as wheel_on_rail() has them; arguments as there.

        pair: with the radius, the materials and the smoothing length of the table. A position outside the table is an error
        (constants["KSTRIP_ERROR_TABLE_RANGE"]).
        """
        elements = Elements(is_single(pair, position, velocity, friction), on_error, pair=(WheelPair, pair), position=(WheelPosition, position),
                            velocity=(WheelVelocity, velocity), friction=optional(Friction, friction))
        (wrenches, first), (slopes, second) = elements.out("wrench"), elements.out("wrench_derivatives")
        moved, third = elements.out("wrench_by_position") if by_position else (None, repeat(None))
        kept = KeptContacts(elements.single)
        found = elements.run("kstrip_wheel_on_table", repeat(structure_of(self)), *elements.columns.values(),
                             Workspace("wheel_workspace"), first, second, third, kept=[kept] if contacts else [],
                             sweep=sweep_of(threads, progress))
        statuses = elements.statuses(found, wrenches, slopes, moved)
        made = WheelOnRail(elements.result(Wrench, wrenches, statuses), elements.result(WrenchDerivatives, slopes, statuses),
                           None if moved is None else elements.result(WrenchByPosition, moved, statuses), kept.batch(elements),
                           elements.given("pair"), elements.given("position"), elements.given("velocity"), elements.given("friction"), statuses)
        return elements.report(made, statuses)

    def __reduce__(self) -> Any:
        return ContactTable.of_bytes, (self.raw, self.only)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ContactTable) and self.raw == other.raw

    def __hash__(self) -> int:
        return hash(self.raw)

    def __repr__(self) -> str:
        return f"ContactTable({len(self.raw) / 1e3:.0f} kB)"
