#!/usr/bin/env python3
"""S1002 on 60E1: contact, conicity and forces against the lateral shift, a curve, and a table for real time.

    make && python bindings/python/wheel_on_rail.py            (needs numpy)
"""

import pathlib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]

import numpy as np

import kstrip

#: from the middle of the wheelset to y = 0 of a wheel's profile, and from the middle of the track to a rail's origin [m]
HALF_WIDTH, HALF_GAUGE = 0.75, 0.7605325
RADIUS, LOAD, SPEED = 0.46, 50e3, 20.0


def profile(name):
    """A prepared profile from a file of tests/data/wheel_rail."""
    return kstrip.read_profile(ROOT / "tests" / "data" / "wheel_rail" / f"{name}.csv").prepare()


RAIL, WHEEL = profile("uic60"), profile("s1002")


def pair(left=False, model="default"):
    return kstrip.wheel_pair(wheel_radius=RADIUS, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3, left=left, model=model)


def carried(shift, left=False):
    """Where wheels are that carry their load by pressure, when the wheelset stands `shift` to the right: numbers or arrays."""
    side = np.where(left, -1.0, 1.0)
    place = kstrip.wheel_position(lateral=shift + side * (HALF_WIDTH - HALF_GAUGE))
    place.vertical = kstrip.height_for_load(RAIL, WHEEL, pair(left), place, LOAD)
    return place


def forces(shift, left=False, forward=SPEED, yaw=0.0, pitch=-SPEED / RADIUS, model="default"):
    """Force and moment on wheels, and their contacts."""
    velocity = kstrip.wheel_velocity(forward=forward, pitch=pitch, yaw=yaw)
    return kstrip.wheel_on_rail(RAIL, WHEEL, pair(left, model), carried(shift, left), velocity)


def rolling_radius(shift, left=False):
    """Mean of the contacts, weighted with load [m]."""
    found = forces(shift, left).contacts
    weights = found.share * found.normal_force
    return np.sum(weights * found.radius, axis=-1) / np.sum(weights, axis=-1)


def equivalent_conicity(amplitude):
    """After EN 15302, with the radii under load."""
    shifts = np.linspace(-1.1 * amplitude, 1.1 * amplitude, 45)
    differences = rolling_radius(shifts) - rolling_radius(shifts, left=True)
    found = kstrip.equivalent_conicity(shifts, differences, [amplitude], running_circles=2.0 * HALF_WIDTH, wheel_radius=RADIUS)
    return float(found.conicity[0])


def curve(radius, shift):
    """Longitudinal forces [N] on the outer and inner wheel of a free wheelset in a curve to the right, whose radius may be infinite.

    Over the track, whose axes are at rest, the wheel at y = +-b from the middle goes forward with V (1 -+ b/R), and both turn with V/R.
    The outer (left) wheel has the larger radius where the wheelset stands to the left.
    """
    turn = SPEED / radius
    pitch = -2.0 * SPEED / (rolling_radius(shift) + rolling_radius(shift, left=True))
    wheels = [forces(shift, left, SPEED + (turn if left else -turn) * HALF_WIDTH, turn, pitch) for left in (True, False)]
    return [float(wheel.wrench.force[0]) for wheel in wheels]


class Table:
    """Wrenches of a right wheel over lateral shift at one height, made offline; straight between its entries."""

    def __init__(self, shifts, velocity):
        self.shifts, self.entries = shifts, self.exact(shifts, velocity)

    @staticmethod
    def exact(shifts, velocity):
        """Force and moment, shape (number of shifts, 6)."""
        found = kstrip.wheel_on_rail(RAIL, WHEEL, pair(), carried(shifts), velocity, contacts=False).wrench
        return np.concatenate([found.force, found.moment], axis=-1)

    def __call__(self, shifts):
        return np.stack([np.interp(shifts, self.shifts, column) for column in self.entries.T], axis=-1)

    def error(self, shifts, velocity):
        """Mean and largest error of the creep force divided by mu N, between the entries."""
        off = np.hypot(*(self(shifts) - self.exact(shifts, velocity)).T[:2]) / (0.3 * LOAD)
        return float(np.mean(off)), float(np.max(off))


def main():
    print("shift [mm]   contact y [mm]   angle [deg]   radius difference [mm]   Fx [kN]   Fy [kN]")
    shifts = np.linspace(0.0, 6e-3, 7)
    right, lateral = forces(shifts), carried(shifts).lateral
    difference = rolling_radius(shifts) - rolling_radius(shifts, left=True)
    for i, shift in enumerate(shifts):
        contact = right.contacts[i, int(np.argmax(right.contacts.normal_force[i]))]
        place = float(contact.origin[1] + lateral[i])
        fx, fy, _ = right.wrench.force[i] * 1e-3
        print(f"{shift * 1e3:9.1f} {place * 1e3:15.2f} {np.degrees(contact.angle):14.2f} {difference[i] * 1e3:19.3f} {fx:16.2f} {fy:9.2f}")
    print(f"equivalent conicity at 3 mm: {equivalent_conicity(3e-3):.3f}")
    for radius in (np.inf, 2000.0, 500.0):
        outer, inner = curve(radius, -4e-3)
        print(f"curve of {radius:6.0f} m, wheelset 4 mm to the outside: outer {outer * 1e-3:6.2f} kN, inner {inner * 1e-3:6.2f} kN")
    velocity = kstrip.wheel_velocity(forward=SPEED, pitch=-1.001 * SPEED / RADIUS)
    between = np.linspace(-4.9e-3, 4.9e-3, 50)
    for count in (11, 41, 161):
        mean, largest = Table(np.linspace(-5e-3, 5e-3, count), velocity).error(between, velocity)
        print(f"table of {count:3} shifts: error {mean:.4f} in the mean, {largest:.4f} at most, of mu N")


if __name__ == "__main__":
    main()
