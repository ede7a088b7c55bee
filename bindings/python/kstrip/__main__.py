"""kstrip on files, for those who do not write programs: python -m kstrip solve, wheel, conicity, fit; each has --help."""

from __future__ import annotations

import argparse
import csv
import sys
import warnings
from typing import Any, Optional, Sequence

import numpy as np

import kstrip

#: Columns of `solve`, and what stands for those that are missing; None: it is needed
_CONTACT: dict[str, Optional[float]] = {"a": None, "b": None, "normal_force": None, "shear_modulus": 82e9, "poisson_ratio": 0.28, "friction": None,
                                        "mismatch": 0.0}
_CREEPAGE: dict[str, Optional[float]] = {"longitudinal": 0.0, "lateral": 0.0, "spin": 0.0}
_RESULTS = ("fx", "fy", "mz", "power", "adhesion")


def _table(path: str) -> dict[str, Any]:
    """The columns of a CSV file by their names."""
    with open(path, newline="", encoding="utf-8-sig") as file:
        rows = list(csv.reader(file))
    if not rows:
        raise ValueError(f"{path}: the file is empty")
    names = [name.strip() for name in rows[0]]
    numbers = np.empty((len(rows) - 1, len(names)))
    for line, row in enumerate(rows[1:]):
        if len(row) != len(names):
            raise ValueError(f"{path}: line {line + 2} has {len(row)} columns, and the first line names {len(names)}")
        try:
            numbers[line] = [float(cell) if cell.strip() else np.nan for cell in row]
        except ValueError as error:
            raise ValueError(f"{path}: line {line + 2}: {error}") from None
    return dict(zip(names, numbers.T))


def _columns(table: dict[str, Any], wanted: dict[str, Optional[float]], options: argparse.Namespace) -> dict[str, Any]:
    """The columns of the file, else the numbers of the options, else the defaults."""
    found: dict[str, Any] = {}
    for name, default in wanted.items():
        given = getattr(options, name, None)
        value = table.get(name, default if given is None else given)
        if value is None:
            raise ValueError(f"{name}: neither a column of the file nor --{name.replace('_', '-')}")
        found[name] = value
    return found


def _write(columns: dict[str, Any], path: Optional[str]) -> None:
    """Columns as CSV into a file, or to the terminal."""
    rows = zip(*(np.atleast_1d(column).tolist() for column in columns.values()))
    file = sys.stdout if path is None else open(path, "w", newline="", encoding="utf-8")
    try:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows([[f"{cell:.9g}" if isinstance(cell, float) else cell for cell in row] for row in rows])
    finally:
        if path is not None:
            file.close()


def _solve(options: argparse.Namespace) -> None:
    table = _table(options.file)
    contacts = kstrip.contact(**_columns(table, _CONTACT, options))
    creepages = kstrip.creepage(**_columns(table, _CREEPAGE, options))
    found = kstrip.evaluate(contacts, creepages, model=options.model, strips=options.strips, derivatives=False, on_error="nan",
                            threads=options.threads)
    _write({**table, **{name: getattr(found.result, name) for name in _RESULTS}, "status": found.statuses}, options.output)


def _pair(options: argparse.Namespace, **more: Any) -> Any:
    return kstrip.wheel_pair(wheel_radius=options.radius, shear_modulus=options.shear_modulus, poisson_ratio=options.poisson_ratio,
                             friction=options.friction, **more)


def _prepared(options: argparse.Namespace) -> tuple[Any, Any]:
    """Rail and wheel from their files."""
    rail, wheel = (kstrip.read_profile(path, kind=kind).prepare(smoothing_length=options.smoothing_length)
                   for path, kind in ((options.rail, "rail"), (options.wheel, "wheel")))
    return rail, wheel


def _wheel(options: argparse.Namespace) -> None:
    rail, wheel = _prepared(options)
    pair = _pair(options, left=options.left)
    position = kstrip.wheel_position(lateral=np.asarray(options.lateral), yaw=options.yaw)
    position.vertical = kstrip.height_for_load(rail, wheel, pair, position, options.load)
    pitch = -options.speed / options.radius if options.pitch is None else options.pitch
    on = kstrip.wheel_on_rail(rail, wheel, pair, position, kstrip.wheel_velocity(forward=options.speed, pitch=pitch))
    places = np.argwhere(on.contacts.normal_force > 0.0)
    contacts, creepages, at = on.contacts[tuple(places.T)], on.creepages[tuple(places.T)], places[:, 0]
    _write({"lateral": position.lateral[at], "vertical": position.vertical[at], "contact": places[:, 1], "angle": contacts.angle,
            "normal_force": contacts.normal_force, "radius": contacts.radius, "longitudinal": creepages.longitudinal, "lateral_creepage": creepages.lateral,
            "spin": creepages.spin, "t_gamma": on.t_gamma[tuple(places.T)], "wheel_fx": on.wrench.force[at, 0], "wheel_fy": on.wrench.force[at, 1],
            "wheel_fz": on.wrench.force[at, 2], "status": on.statuses[at]}, options.output)
    if options.plot:
        from . import plot

        plot.patch_on_profiles(rail, wheel, pair, position[0]).savefig(options.plot)


def _conicity(options: argparse.Namespace) -> None:
    rail, wheel = _prepared(options)
    wheelset = kstrip.Wheelset(wheel, _pair(options), back_to_back=options.back_to_back)
    track = kstrip.Track(rail, gauge=options.gauge)
    amplitudes = np.asarray(options.amplitude)
    shifts = np.linspace(-1.4, 1.4, 281) * amplitudes.max()
    differences = kstrip.rolling_radius_difference(wheelset, track, shifts, on_error="nan")
    reached = np.isfinite(differences)
    found = kstrip.equivalent_conicity(shifts[reached], differences[reached], amplitudes, running_circles=2.0 * wheelset.half_distance,
                                       wheel_radius=options.radius, on_error="nan")
    _write({"amplitude": amplitudes, "conicity": found.conicity, "wave_length": found.wave_length, "status": found.statuses}, options.output)
    if options.plot:
        from . import plot

        plot.conicity(wheelset, track).savefig(options.plot)


def _fit(options: argparse.Namespace) -> None:
    table = _table(options.file)
    for name in ("creepage", "force"):
        if name not in table:
            raise ValueError(f"{options.file}: no column {name}; the columns are {', '.join(table)}")
    contact = kstrip.contact(**_columns({}, {**_CONTACT, "friction": 0.3}, options))
    start = kstrip.friction(options.friction or 0.3, options.ratio, options.decay, options.rolling_speed, options.slope_factor)
    found = kstrip.fit_friction(table["creepage"], table["force"], contact, start=start, fit=options.fit, model=options.model)
    names = found.law.__match_args__
    _write({"name": np.array([*names, "residual"]), "value": np.array([*(getattr(found.law, name) for name in names), found.residual]),
            "standard_error": np.array([*(getattr(found.standard_errors, name) for name in names), np.nan])}, options.output)
    if options.plot:
        from . import plot

        plot.measured_curve(contact, table["creepage"], table["force"], {"clean": None, "fitted law": found.law}).savefig(options.plot)


def _number(parser: Any, name: str, default: Optional[float], text: str) -> None:
    parser.add_argument(f"--{name}", type=float, default=default, metavar="X", help=text + ("" if default is None else f"; {default:g}"))


def _parser() -> argparse.ArgumentParser:
    main = argparse.ArgumentParser(prog="python -m kstrip", description="Creep forces of rolling contact. All numbers are in SI units; tables are CSV.")
    commands = main.add_subparsers(required=True, metavar="COMMAND")

    def command(name: str, run: Any, text: str, plot: bool = True) -> Any:
        parser = commands.add_parser(name, help=text, description=text)
        parser.set_defaults(run=run)
        parser.add_argument("-o", "--output", metavar="FILE", help="the table goes into this file, otherwise to the terminal")
        if plot:
            parser.add_argument("--plot", metavar="FILE", help="draws a picture into this file: svg, png or pdf")
        return parser

    def material(parser: Any, friction: Optional[float]) -> None:
        _number(parser, "shear-modulus", 82e9, "combined shear modulus [Pa]")
        _number(parser, "poisson-ratio", 0.28, "combined Poisson's ratio [-]")
        _number(parser, "friction", friction, "coefficient of friction [-]")

    def ellipse(parser: Any) -> None:
        for name, text in (("a", "semi-axis along the rolling direction [m]"), ("b", "semi-axis across [m]"), ("normal-force", "load [N]")):
            _number(parser, name, None, text)

    def profiles(parser: Any) -> None:
        parser.add_argument("rail", help="file with the profile of the rail")
        parser.add_argument("wheel", help="file with the profile of the wheel")
        _number(parser, "radius", 0.46, "radius of the wheel [m]")
        _number(parser, "smoothing-length", 0.0, "smoothing of both profiles [m]")
        material(parser, 0.3)

    solve = command("solve", _solve, "Forces of contacts: a table with columns a, b, normal_force, friction, longitudinal, lateral, spin; an option stands "
                    "for a missing column.", plot=False)
    solve.add_argument("file", help="CSV with the names of the columns in its first line")
    ellipse(solve)
    material(solve, None)
    for name, text in (("longitudinal", "creepage [-]"), ("lateral", "creepage [-]"), ("spin", "[1/m]")):
        _number(solve, name, None, text)
    wheel = command("wheel", _wheel, "A wheel on a rail under its load: contacts, creepages, T-gamma and forces at lateral positions.")
    profiles(wheel)
    _number(wheel, "load", 80e3, "vertical force [N]")
    wheel.add_argument("--lateral", type=float, nargs="+", default=[-10e-3], metavar="Y", help="of the wheel's centre from the rail's origin [m]; -0.01")
    _number(wheel, "speed", 20.0, "forward [m/s]")
    _number(wheel, "pitch", None, "rate about the axle [rad/s]; without it the wheel rolls at its nominal radius")
    _number(wheel, "yaw", 0.0, "angle [rad]")
    wheel.add_argument("--left", action="store_true", help="a left wheel")
    conicity = command("conicity", _conicity, "Equivalent conicity of a wheelset on a track, EN 15302.")
    profiles(conicity)
    _number(conicity, "gauge", 1.435, "of the track [m]")
    _number(conicity, "back-to-back", 1.36, "distance of the flange backs [m]")
    conicity.add_argument("--amplitude", type=float, nargs="+", default=[1e-3, 2e-3, 3e-3, 4e-3, 5e-3], metavar="Y", help="of the motion [m]; 0.001 to 0.005")
    fit = command("fit", _fit, "The law of friction that fits measured forces best: a table with columns creepage [-] and force [N], both longitudinal.")
    fit.add_argument("file", help="CSV with the names of the columns in its first line")
    ellipse(fit)
    material(fit, None)
    for name, default, text in (("ratio", 1.0, "start: friction far in sliding, divided by friction [-]"), ("decay", 0.0, "start: fall of friction [s/m]"),
                                ("rolling-speed", 0.0, "[m/s]"), ("slope-factor", 1.0, "start: initial slope, divided by that of clean bodies [-]")):
        _number(fit, name, default, text)
    fit.add_argument("--fit", nargs="+", default=["friction", "slope_factor"], choices=("friction", "ratio", "decay", "slope_factor", "slide_factor", "layer"),
                     metavar="NAME", help="members of the law that are found, of friction, ratio, decay, slope_factor, slide_factor, layer; friction slope_factor")
    for parser in (solve, fit):
        parser.add_argument("--model", choices=sorted(kstrip.models), default="default", help="model of the contact")
    solve.add_argument("--strips", type=int, default=0, metavar="N", help="4, 8, 16, 32 or 64")
    solve.add_argument("--threads", type=int, default=1, metavar="N", help="threads; 1")
    return main


def main(words: Optional[Sequence[str]] = None) -> int:
    """Runs a command; 1 if its input is wrong."""
    options = _parser().parse_args(words)
    with warnings.catch_warnings():
        warnings.showwarning = lambda message, *_: print(f"warning: {message}", file=sys.stderr)
        try:
            options.run(options)
        except (ValueError, TypeError, OSError, ImportError) as error:
            print(f"error: {error}", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
