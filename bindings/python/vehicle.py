#!/usr/bin/env python3
"""A wagon runs into a curve of 500 m: two wheelsets and a body with six degrees of freedom each, integrated by SciPy.

    make && python bindings/python/vehicle.py            (needs numpy and scipy)

The degrees of freedom are in the order of kstrip: forward, lateral, vertical, roll, pitch, yaw. Axes run along the track with the wagon.
"""

import pathlib

import numpy as np
from scipy.integrate import solve_ivp

import kstrip

DATA = pathlib.Path(__file__).resolve().parents[2] / "tests" / "data" / "wheel_rail"
SPEED, CURVATURE, GRAVITY = 20.0, 1 / 500.0, 9.81  # m/s, 1/m, m/s^2
AHEAD, HEIGHT = (2.5, -2.5), 0.8  # of the wheelsets ahead of the body's centre, and of that centre above them [m]

# Masses [kg] and moments of inertia [kg m^2] of both wheelsets and the body; the load of each wheelset on its rails [N]
MASS = np.array([1500, 1500, 1500, 800, 110, 800] * 2 + [17e3, 17e3, 17e3, 20e3, 80e3, 80e3])
LOAD = (MASS[0] + MASS[12] / 2) * GRAVITY

rail, wheel = (kstrip.read_profile(DATA / name).prepare() for name in ("uic60.csv", "s1002.csv"))
pair = kstrip.wheel_pair(wheel_radius=0.46, shear_modulus=82e9, poisson_ratio=0.28, friction=0.3, normal_damping=0.1)
wheelset, track = kstrip.Wheelset(wheel, pair, back_to_back=1.36), kstrip.Track(rail, gauge=1.435)


def motion_of_point(body, x, y, z):
    """The displacement of a point of a body by each degree of freedom: 3 rows, 18 columns."""
    rows = np.zeros((3, 18))
    rows[:, 6 * body : 6 * body + 6] = np.hstack([np.eye(3), [[0, z, -y], [-z, 0, x], [y, -x, 0]]])
    return rows


# Springs [N/m] and dampers [N s/m] along x, y and z between wheelsets and body, 1 m to the right and to the left
stiffness, damping = np.zeros((18, 18)), np.zeros((18, 18))
for i, x in enumerate(AHEAD):
    for y in (1.0, -1.0):
        stretch = motion_of_point(i, 0.0, y, 0.0) - motion_of_point(2, x, y, HEIGHT)
        stiffness += stretch.T @ np.diag([4e6, 2e6, 0.6e6]) @ stretch
        damping += stretch.T @ np.diag([10e3, 20e3, 15e3]) @ stretch
# In a curve the axes at a wheelset turn against those at the body: lateral x^2/2 and yaw x for each unit of curvature
bend = np.concatenate([[0, x**2 / 2, 0, 0, 0, x] for x in AHEAD] + [np.zeros(6)])

# Balance on straight track
still = kstrip.wheelset_settle(wheelset, track, kstrip.wheel_position(lateral=0.0), kstrip.wheel_velocity(forward=SPEED, pitch=0.0), LOAD)
balance, rolling = np.zeros(18), np.zeros(18)
balance[[2, 8]], rolling[[4, 10]] = still.position.vertical, still.velocity.pitch


def curvature_at(time):
    """The transition into the curve takes one second."""
    return CURVATURE * np.clip(time, 0.0, 1.0)


def wheelsets_on_track(time, q, v, by_position=False):
    """What acts on both wheelsets, and the lateral weight per mass."""
    (_, lateral, vertical, roll, _, yaw), moves = q[:12].reshape(2, 6).T, v[:12].reshape(2, 6).T
    position = kstrip.wheel_position(lateral=lateral, vertical=vertical, roll=roll, yaw=yaw)
    relative = kstrip.wheel_velocity(**dict(zip(("forward", "lateral", "vertical", "roll", "pitch", "yaw"), moves)))
    velocity, weight = kstrip.curve_motion(kstrip.curve(SPEED, curvature_at(time), gravity=GRAVITY), position, relative)
    return kstrip.wheelset_on_track(wheelset, track, position, velocity, by_position, contacts=False), weight[0, 1]


def rate(time, state):
    """Velocities and accelerations."""
    q, v = state.reshape(2, 18)
    on, weight = wheelsets_on_track(time, q, v)
    force = -stiffness @ (q - balance + curvature_at(time) * bend) - damping @ v
    force[:12] += np.concatenate([on.forces.wrench.force, on.forces.wrench.moment], axis=-1).ravel()
    force[[2, 8]] += LOAD
    force[[1, 7, 13]] += MASS[[1, 7, 13]] * weight
    return np.concatenate([v, force / MASS])


def jacobian(time, state):
    """The derivatives of rate() with respect to the state."""
    on, _ = wheelsets_on_track(time, *state.reshape(2, 18), by_position=True)
    assert on.by_position is not None
    by_position, by_velocity = -stiffness, -damping
    for i, part in enumerate((slice(0, 6), slice(6, 12))):
        by_position[part, part] += on.by_position.position[i, :6, :6]
        by_velocity[part, part] += on.derivatives.velocity[i, :6, :6]
    return np.block([[np.zeros((18, 18)), np.eye(18)], [by_position / MASS[:, None], by_velocity / MASS[:, None]]])


def run(until=4.0):
    """The solution of SciPy, errors below 0.01 mm and 1 mm/s."""
    errors = np.repeat([1e-5, 1e-3], 18)
    return solve_ivp(rate, (0.0, until), np.concatenate([balance, rolling]), "BDF", jac=jacobian, atol=errors, max_step=0.05)


def main():
    run_in = run()
    print("time [s]   lateral, front and rear [mm]   Y of the front wheels, right and left [kN]")
    for i in range(0, run_in.t.size, 10):
        q, v = run_in.y[:, i].reshape(2, 18)
        right, left = 1e-3 * wheelsets_on_track(run_in.t[i], q, v)[0].forces.rail[0, :, 1]
        print(f"{run_in.t[i]:8.2f} {1e3 * q[1]:18.2f} {1e3 * q[7]:9.2f} {right:22.1f} {left:9.1f}")


if __name__ == "__main__":
    main()
