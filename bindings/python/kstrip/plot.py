"""Plots of contacts and wheels; needs matplotlib: pip install kstrip[plot].

    creep_curve          force against creepage, with its derivative, for several models
    traction_map         tractions inside a patch, with stick and slip
    patch_on_profiles    where a wheel touches a rail, and the pressure in its patches
    lateral_shift        contact angle, radius difference, load and forces of a wheelset against its lateral shift
    wheelset             both wheels of a wheelset on their rails, with the load and the angle of each contact
    wear                 T-gamma along the profiles of wheels
    conicity             radius difference against lateral shift, and equivalent conicity against amplitude
    measured_curve       measured forces against creepage, with curves of laws of friction

Each function returns a matplotlib figure: `figure.savefig("curve.svg")`, or `matplotlib.pyplot.show()`. `figure` is one to draw into,
or a subfigure. Colours differ for colour-blind readers too, and stand out from white and from black (`plt.style.use("dark_background")`).
"""

from __future__ import annotations

import dataclasses
from typing import Any, Iterator, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

try:
    import matplotlib.pyplot as plt
except ImportError as error:
    raise ImportError("kstrip.plot needs matplotlib: pip install 'kstrip[plot]'") from error

from ._batch import Batch
from ._inputs import Model, number as number_of
from ._solve import evaluate, field, solve
from ._structures import creepage as creepage_of, wheel_position, wheel_velocity
from ._contacts import OfContacts
from ._wheel import PreparedProfile, WheelOnRail, height_for_load, wheel_on_rail
from ._wheelset import Track, WheelOfWheelset, Wheelset, WheelsetOnTrack, equivalent_conicity, gauge_face, rolling_radius_difference
from .values import Contact, Creepage, Friction, Patch, WheelContact, WheelPair, WheelPosition, WheelVelocity

__all__ = ["creep_curve", "traction_map", "patch_on_profiles", "lateral_shift", "wheelset", "wear", "conicity", "measured_curve", "COLOURS"]

#: Blue, vermilion, green, purple of Okabe and Ito, as in all pictures of kstrip.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7")
_STYLES = ("-", "--", "-.", ":")
_PRESSURE = "cividis"


def _new(figure: Any, width: float, height: float) -> Any:
    return plt.figure(figsize=(width, height), layout="constrained") if figure is None else figure


def _label(axes: Any, x: str, y: str, title: str = "") -> None:
    axes.set(xlabel=x, ylabel=y, title=title)
    axes.grid(True, alpha=0.3)
    axes.set_axisbelow(True)


def _line(i: int) -> dict[str, Any]:
    """Lines differ in colour and in style."""
    return {"color": COLOURS[i % len(COLOURS)], "linestyle": _STYLES[i % len(_STYLES)]}


def creep_curve(contact: Contact, creepage: Optional[ArrayLike] = None, *, spin: float = 0.0, models: Sequence[Model] = ("total", "strip"),
                friction: Optional[Friction] = None, figure: Any = None) -> Any:
    """The longitudinal force [kN] against the longitudinal creepage [%], and its derivative below.

    contact: one contact(). creepage: array [-]; None: up to a linear force of four times the friction bound.
    spin: [1/m]. models: their names. friction: a law of friction() that falls with the slip.

    >>> figure = plot.creep_curve(contact, models=("total", "strip", "linear"))
    """
    bound = contact.friction * contact.normal_force
    if creepage is None:
        slope = evaluate(contact, creepage_of(0.0, 0.0, spin)).derivatives
        assert slope is not None
        creepage = np.linspace(0.0, 4.0 * bound / float(slope.jacobian[0, 0]), 201)
    places = np.asarray(creepage, float)
    drawn = _new(figure, 5.5, 5.5)
    above, below = drawn.subplots(2, 1, sharex=True, height_ratios=(3, 2))
    for i, model in enumerate(models):
        found = evaluate(contact, creepage_of(places, 0.0, spin), friction, model)
        assert found.derivatives is not None
        above.plot(100 * places, 1e-3 * found.result.fx, label=str(model).upper(), **_line(i))
        below.plot(100 * places, 1e-6 * found.derivatives.jacobian[..., 0, 0], **_line(i))
    above.axhline(1e-3 * bound, color="0.5", linewidth=0.8)
    above.annotate("friction times load", (1, 1e-3 * bound), xycoords=("axes fraction", "data"), xytext=(-4, -4), textcoords="offset points",
                   ha="right", va="top", color="0.5")
    _label(above, "", "force on the rail [kN]", "Creep curve" + (f", spin {spin:g} 1/m" if spin else ""))
    above.legend(loc="lower right")
    _label(below, "longitudinal creepage [%]", "derivative [MN]")
    return drawn


def traction_map(area: Union[Contact, Patch], creepage: Creepage, *, model: Model = "default", strips: int = 64, figure: Any = None) -> Any:
    """Traction on the lower body [MPa] as colour and arrows, and the border of stick and slip; x, the rolling direction, points up.

    area: one contact(), or a patch of any shape. creepage: one creepage().

    >>> figure = plot.traction_map(contact, kstrip.creepage(3e-4, spin=0.6))
    """
    if isinstance(area, Patch):
        used = area.strips[: area.count]
        side, end = used.y + 0.5 * used.width, used.y - 0.5 * used.width
        y = np.linspace(1.02 * end.min() - 0.02 * side.max(), 1.02 * side.max() - 0.02 * end.min(), 241)
        half = float((used.half_length + abs(used.centre_x)).max())
    else:
        y, half = float(area.b) * np.linspace(-1.02, 1.02, 241), float(area.a)
    x = half * np.linspace(-1.04, 1.04, 241)
    points = field(area, creepage, x, y, model, strips)
    outside = points.state == 0
    size = np.ma.array(1e-6 * np.hypot(points.traction_x, points.traction_y), mask=outside)
    drawn = _new(figure, 5.2, 4.8)
    axes = drawn.subplots()
    shade = axes.pcolormesh(1e3 * y, 1e3 * x, size.T, cmap=_PRESSURE, shading="nearest", rasterized=True)
    drawn.colorbar(shade, label="traction [MPa]")
    stick = np.ma.array(np.where(points.state == 1, 1.0, 0.0), mask=outside)
    if 0.0 < stick.mean() < 1.0:
        axes.contour(1e3 * y, 1e3 * x, stick.T, [0.5], colors=COLOURS[0], linewidths=1.8)
    # Every twelfth point has an arrow.
    few = slice(6, None, 12)
    across, along = np.meshgrid(1e3 * y[few], 1e3 * x[few], indexing="ij")
    seen = ~outside[few, few]
    axes.quiver(across[seen], along[seen], points.traction_y[few, few][seen], points.traction_x[few, few][seen], color="white", width=0.0035)
    for state, name in ((1, "stick"), (2, "slip")):
        inside = np.argwhere(points.state == state)
        if len(inside) > 300:
            j, i = inside[np.argmin(np.hypot(*(inside - inside.mean(axis=0)).T))]
            axes.annotate(name, (1e3 * y[j], 1e3 * x[i]), color="black", ha="center", weight="bold", bbox={"facecolor": "white", "alpha": 0.75, "lw": 0})
    numbers = f"{100 * float(creepage.longitudinal):g} %, {100 * float(creepage.lateral):g} %, {float(creepage.spin):g} 1/m"
    _label(axes, "y [mm]", "x, rolling direction [mm]", f"Traction on the lower body\ncreepages {numbers}")
    axes.set_aspect("equal")
    axes.grid(False)
    return drawn


def patch_on_profiles(rail: PreparedProfile, wheel: PreparedProfile, pair: WheelPair, position: WheelPosition, *, figure: Any = None) -> Any:
    """Where a wheel touches a rail: both profiles with the patches on them, and below the pressure [MPa] in each patch.

    rail, wheel, pair, position: of one wheel, as in wheel_on_rail(). A left wheel is drawn as its mirror image, a right one.

    >>> position = kstrip.wheel_position(lateral=-5.2e-3)
    >>> position.vertical = kstrip.height_for_load(rail, wheel, pair, position, 80e3)
    >>> figure = plot.patch_on_profiles(rail, wheel, pair, position)
    """
    still = wheel_velocity(forward=1.0, pitch=-1.0 / pair.wheel_radius)
    contacts = list(wheel_on_rail(rail, wheel, pair, position, still).contacts)
    sign = -1.0 if pair.left else 1.0
    lateral, vertical, roll, radius = sign * position.lateral, position.vertical, sign * position.roll, pair.wheel_radius
    drawn = _new(figure, 6.4, 6.0)
    grid = drawn.add_gridspec(2, max(1, len(contacts)), height_ratios=(3, 2))
    above = drawn.add_subplot(grid[0, :])
    ry, rz, wy, wz = 1e3 * rail.y, 1e3 * rail.z, wheel.y, wheel.z
    # About the wheel's centre, one radius above z = 0 of its profile
    py = lateral + np.cos(roll) * wy - np.sin(roll) * (wz + radius)
    pz = vertical - radius + np.sin(roll) * wy + np.cos(roll) * (wz + radius)
    above.plot(ry, rz, label="rail", **_line(1))
    above.plot(1e3 * py, 1e3 * pz, label="wheel", **_line(0))
    for i, contact in enumerate(contacts):
        used = contact.patch.strips[: contact.patch.count]
        y0, z0 = 1e3 * (sign * float(contact.origin[1]) + lateral), 1e3 * (float(contact.origin[2]) + vertical - radius)
        angle = float(contact.angle)
        s = 1e3 * np.array([(used.y - 0.5 * used.width).min(), (used.y + 0.5 * used.width).max()])
        above.plot(y0 + np.cos(angle) * s, z0 + np.sin(angle) * s, color=COLOURS[3], linewidth=5, solid_capstyle="butt",
                   label="contact" if i == 0 else None)
        above.annotate(f"{np.degrees(angle):.1f}°, {1e-3 * float(contact.normal_force):.1f} kN", (y0, z0), xytext=(0, -24), textcoords="offset points",
                       ha="center", arrowprops={"arrowstyle": "-", "color": "0.5"})
        axes = drawn.add_subplot(grid[1, i])
        x = np.linspace(-1.05, 1.05, 161) * float((used.half_length + abs(used.centre_x)).max())
        inside = 1.0 - ((x[:, None] - used.centre_x) / used.half_length) ** 2
        # A column for each strip and an empty one after it, which has a width where a patch has separate zones
        edges = 1e3 * np.stack((used.y - 0.5 * used.width, used.y + 0.5 * used.width), axis=-1).ravel()
        pressure = np.ma.masked_equal(np.zeros((x.size, edges.size - 1)), 0.0)
        pressure[:, ::2] = np.ma.masked_less_equal(1e-6 * used.peak_pressure * np.sqrt(np.maximum(inside, 0.0)), 0.0)
        shade = axes.pcolormesh(np.maximum.accumulate(edges), 1e3 * np.append(x, 2 * x[-1] - x[-2]), pressure, cmap=_PRESSURE, rasterized=True)
        drawn.colorbar(shade, label="pressure [MPa]")
        _label(axes, "along the surface [mm]", "x, forward [mm]", f"peak {1e-6 * float(used.peak_pressure.max()):.0f} MPa")
        axes.grid(False)
    low, high = np.nanmin(rz), np.nanmax(rz)
    above.set_ylim(min(high, 20.0 + low), low - 12.0)
    above.set_xlim(ry.min() - 5.0, ry.max() + 5.0)
    above.set_aspect("equal")
    _label(above, "y from the rail's origin [mm]", "z, down [mm]", "A wheel on a rail" + (" (left, mirrored)" if sign < 0 else ""))
    above.legend(loc="lower right")
    return drawn


def _mean(contacts: Batch[WheelContact], name: str) -> NDArray[np.float64]:
    """A member of the contacts of each wheel, weighted with load; NaN for a wheel without contact."""
    weights = contacts.share * contacts.normal_force
    with np.errstate(invalid="ignore"):
        found: NDArray[np.float64] = np.sum(weights * contacts[name], axis=-1) / np.sum(weights, axis=-1)
    return found


def _origin(track: Track, rail: PreparedProfile, number: int) -> float:
    """Distance of a rail's origin from the middle of the track [m]."""
    given = float(track.origin[number])
    return given or 0.5 * number_of(track.gauge, "gauge") - gauge_face(rail, number_of(track.gauge_depth, "gauge_depth"))


def _sides(wheelset: Wheelset, track: Track) -> Iterator[tuple[PreparedProfile, PreparedProfile, Any, Any, float]]:
    """Rail, wheel, pair, law of friction and `lateral` in the middle of the track, of the right and of the left wheel."""
    rights = track.rail, wheelset.wheel, wheelset.pair, wheelset.friction
    lefts = track.left_rail or track.rail, wheelset.left_wheel or wheelset.wheel, wheelset.left_pair or wheelset.pair, wheelset.left_friction
    pair: Any
    for number, (rail, wheel, pair, friction) in enumerate((rights, lefts)):
        side = -1.0 if number else 1.0
        yield rail, wheel, dataclasses.replace(pair, left=number), friction, side * (wheelset.half_distance - _origin(track, rail, number))


def lateral_shift(wheelset: Wheelset, track: Track, shifts: ArrayLike, load: float, *, velocity: Optional[WheelVelocity] = None,
                  figure: Any = None) -> Any:
    """A wheelset against its lateral shift: contact angle, radius difference, load and forces of both wheels.

    wheelset, track: Wheelset and Track; the rails are at rest. shifts: to the right [m]. load: vertical force that each rail carries [N].
    velocity: of both wheels; None: 20 m/s, rolling at the nominal radius. The curves have a gap if a wheel has no position that carries the load.

    >>> figure = plot.lateral_shift(wheelset, track, np.linspace(-6e-3, 6e-3, 5), load=50e3)
    """
    across = np.asarray(shifts, float)
    moves = wheel_velocity(forward=20.0, pitch=-20.0 / wheelset.pair.wheel_radius) if velocity is None else velocity
    wheels, radius, angle = [], [], []
    for side, (rail, wheel, pair, friction, middle) in zip((1.0, -1.0), _sides(wheelset, track)):
        place = wheel_position(lateral=across + middle)
        place.vertical = height_for_load(rail, wheel, pair, place, load, None, friction, on_error="nan")
        found = wheel_on_rail(rail, wheel, pair, place, moves, friction, on_error="nan")
        wheels.append(found)
        radius.append(_mean(found.contacts, "radius"))
        angle.append(side * _mean(found.contacts, "angle"))
    drawn = _new(figure, 8.0, 6.0)
    (first, second), (third, fourth) = drawn.subplots(2, 2, sharex=True)
    millimetres = 1e3 * across
    for i, name in enumerate(("right", "left")):
        first.plot(millimetres, np.degrees(angle[i]), label=name, **_line(i))
        third.plot(millimetres, 1e-3 * wheels[i].wrench.normal_force, **_line(i))
        for k, way in enumerate(("forward", "to the right")):
            fourth.plot(millimetres, 1e-3 * wheels[i].wrench.force[:, k], color=COLOURS[i], linestyle=_STYLES[k], label=f"{name}, {way}")
    second.plot(millimetres, 1e3 * (radius[0] - radius[1]), color=COLOURS[2])
    _label(first, "", "contact angle [degrees]")
    first.legend()
    _label(second, "", "radius difference, right - left [mm]")
    _label(third, "shift to the right [mm]", "normal force [kN]")
    _label(fourth, "shift to the right [mm]", "force on the wheel [kN]")
    fourth.legend(fontsize="small")
    drawn.suptitle(f"A wheelset against its lateral shift, {1e-3 * load:g} kN on each rail")
    return drawn


def wheelset(on: WheelsetOnTrack, *, figure: Any = None) -> Any:
    """Both wheels of one wheelset on their rails, seen in the direction of travel, with the load and the angle of each contact.

    on: of wheelset_on_track(), for one wheelset with its contacts.

    >>> still = kstrip.wheelset_settle(wheelset, track, kstrip.wheel_position(lateral=3e-3), velocity, 100e3)
    >>> figure = plot.wheelset(kstrip.wheelset_on_track(wheelset, track, still.position, still.velocity))
    """
    if isinstance(on.position, Batch) or on.forces.wheel.ndim != 1:
        raise ValueError("on: one wheelset is needed, not many of them")
    mean = float(np.mean([side[2].wheel_radius for side in _sides(on.wheelset, on.track)]))
    drawn = _new(figure, 9.0, 3.6)
    panels = drawn.subplots(1, 2)
    for number, (rail, wheel, pair, _, _) in enumerate(_sides(on.wheelset, on.track)):
        axes, side, wheels = panels[1 - number], -1.0 if number else 1.0, on.left if number else on.right
        motion = None if on.track.motion is None else on.track.motion[number]
        shift, drop = (0.0, 0.0) if motion is None else (motion.lateral, motion.vertical)
        origin, roll = side * _origin(on.track, rail, number), float(on.position.roll)
        axes.plot(1e3 * (origin + shift + side * rail.y), 1e3 * (drop + rail.z), label="rail", **_line(1))
        # The wheel's centre, and the profile about it
        arm = side * on.wheelset.half_distance
        centre_y, centre_z = on.position.lateral + arm * np.cos(roll), on.position.vertical - mean + arm * np.sin(roll)
        along, down = side * wheel.y, wheel.z + pair.wheel_radius
        axes.plot(1e3 * (centre_y + np.cos(roll) * along - np.sin(roll) * down), 1e3 * (centre_z + np.sin(roll) * along + np.cos(roll) * down),
                  label="wheel", **_line(0))
        for contact in wheels.contacts:
            y, z = 1e3 * (centre_y + contact.origin[1]), 1e3 * (centre_z + contact.origin[2])
            axes.plot(y, z, "o", color=COLOURS[3])
            axes.annotate(f"{1e-3 * contact.normal_force:.1f} kN, {np.degrees(contact.angle):.1f}°", (y, z), xytext=(0, -28), textcoords="offset points",
                          ha="center", arrowprops={"arrowstyle": "-", "color": "0.5"})
        middle, top = 1e3 * (origin + shift), 1e3 * (drop + float(np.nanmin(rail.z)))
        axes.set(xlim=(middle - 60.0, middle + 60.0), ylim=(top + 35.0, top - 25.0), aspect="equal")
        _label(axes, "y from the middle of the track [mm]", "z, down [mm]", "left" if number else "right")
    panels[1].legend(loc="lower right")
    drawn.suptitle(f"Wheelset, {1e3 * on.position.lateral:.1f} mm to the right, yaw {1e3 * on.position.yaw:.1f} mrad")
    return drawn


def wear(on: Union[WheelOnRail, WheelOfWheelset, WheelsetOnTrack], *, width: float = 1e-3, figure: Any = None) -> Any:
    """T-gamma along the profiles of wheels: frictional work for each metre of the way and each millimetre of the profile [N/mm].

    on: of wheel_on_rail() or wheelset_on_track(), with its contacts; of many positions the mean is drawn. width: of the parts of the
    profile [m]. Each strip has the T-gamma of its own slip, which kstrip_contact_power_across() computes.

    >>> starts = kstrip.wheel_position(lateral=np.linspace(-3e-3, 3e-3, 5), yaw=1e-3)
    >>> still = kstrip.wheelset_settle(wheelset, track, starts, velocity, 100e3)
    >>> figure = plot.wear(kstrip.wheelset_on_track(wheelset, track, still.position, still.velocity))
    """
    wheels: list[tuple[str, OfContacts]] = [("right", on.right), ("left", on.left)] if isinstance(on, WheelsetOnTrack) else [("wheel", on)]
    drawn = _new(figure, 6.0, 3.6)
    axes = drawn.subplots()
    for i, (name, of) in enumerate(wheels):
        places, work, count = _work(of)
        edges = width * np.arange(np.floor(places.min(initial=0.0) / width) - 1, np.ceil(places.max(initial=0.0) / width) + 2)
        parts, _ = np.histogram(places, edges, weights=work)
        axes.stairs(1e-3 * parts / (width * count), 1e3 * edges, label=f"{name}, T-gamma {work.sum() / count:.0f} N", linewidth=1.5, **_line(i))
    _label(axes, "y on the wheel's profile, flange at small y [mm]", "T-gamma per length [N/mm]", "Wear along the profile")
    axes.legend()
    return drawn


def _work(of: OfContacts) -> tuple[NDArray[np.float64], NDArray[np.float64], int]:
    """y on the profile [m] and T-gamma [N] of each strip of wheels, and the number of wheels with a result."""
    strips, (_, speed) = of.power_across, of._motion()
    work = np.zeros(strips.shape)
    np.divide(strips.power, speed[..., None], out=work, where=speed[..., None] > 0.0)
    carries = strips.normal_force > 0.0
    results = np.isfinite(np.atleast_1d(np.asarray(of.wrench.normal_force)))
    return strips.wheel_y[carries], work[carries], max(1, int(results.sum()))


def conicity(wheelset: Wheelset, track: Track, amplitudes: Optional[ArrayLike] = None, *, figure: Any = None) -> Any:
    """The difference of the rolling radii against the lateral shift, and the equivalent conicity after EN 15302 against the amplitude.

    wheelset, track: Wheelset and Track; one of each. amplitudes: [m]; None: 0.5 to 8 mm. Amplitudes that the profiles do not reach have
    no conicity.

    >>> figure = plot.conicity(wheelset, track, [1e-3, 3e-3, 5e-3])
    """
    places = np.linspace(0.5e-3, 8e-3, 76) if amplitudes is None else np.asarray(amplitudes, float)
    shifts = np.linspace(-1.4, 1.4, 281) * float(places.max())
    differences = rolling_radius_difference(wheelset, track, shifts, on_error="nan")
    reached = np.isfinite(differences)
    found = equivalent_conicity(shifts[reached], differences[reached], places, running_circles=2.0 * wheelset.half_distance,
                                wheel_radius=float(wheelset.pair.wheel_radius), on_error="nan")
    drawn = _new(figure, 8.0, 3.6)
    first, second = drawn.subplots(1, 2)
    first.plot(1e3 * shifts, 1e3 * differences, **_line(1))
    _label(first, "shift to the right [mm]", "radius difference, right - left [mm]", "Rolling radii")
    second.plot(1e3 * places, found.conicity, **_line(0))
    second.set_ylim(bottom=0.0)
    _label(second, "amplitude [mm]", "equivalent conicity [-]", "Equivalent conicity, EN 15302")
    return drawn


def measured_curve(contact: Contact, creepage: ArrayLike, force: ArrayLike, laws: Union[Friction, dict[str, Optional[Friction]]], *,
                   lateral: bool = False, model: Model = "default", figure: Any = None) -> Any:
    """Measured forces divided by the load against creepage [%], with the curves of one or several laws of friction.

    contact: one contact(). creepage [-] and force [N]: the measured points, one after the other. lateral: they are lateral.
    laws: a law of friction(), or laws by the names of their curves; None is clean and constant friction.
    The legend has the root mean square of the distance to the points, divided by the load.

    >>> figure = plot.measured_curve(contact, [1e-3, 2e-3, 4e-3], [8e3, 14e3, 19e3], {"clean": None, "wet": kstrip.friction(0.25)})
    """
    places, forces = np.ravel(np.asarray(creepage, float)), np.ravel(np.asarray(force, float))
    if places.shape != forces.shape:
        raise ValueError(f"creepage and force have different shapes: creepage {places.shape}, force {forces.shape}")
    load, name = float(contact.normal_force), "fy" if lateral else "fx"
    drawn = _new(figure, 6.0, 4.2)
    axes = drawn.subplots()
    axes.plot(100 * places, forces / load, "o", markersize=4, markerfacecolor="none", color="0.5", label="measured")
    fine = np.linspace(min(0.0, places.min()), places.max(), 400)
    for i, (label, law) in enumerate(laws.items() if isinstance(laws, dict) else [("law", laws)]):
        at, line = (solve(contact, creepage_of(*((0.0, v) if lateral else (v, 0.0))), law, model)[name] / load for v in (places, fine))
        error = float(np.sqrt(np.mean((at - forces / load) ** 2)))
        axes.plot(100 * fine, line, label=f"{label}, rms {error:.4f}", **_line(i))
    _label(axes, f"{'lateral' if lateral else 'longitudinal'} creepage [%]", "force / load [-]", "Measured creep forces")
    axes.legend(loc="lower right")
    return drawn
