//! A wheelset is two wheels that are placed by hand: centre, velocity and axis of the roller of
//! each wheel, and the sum of their forces and moments, with matrices of rotation.

use crate::prelude::*;
use crate::wheelset::{HALF, LOAD, NOTHING, RADIUS, ROLLS, Stand, at};
use kstrip::wheel_rail::touch::GapSearch;
use kstrip::wheelset::track::Curve;
use nalgebra::Vector3;

/// The axes of the wheelset: columns of the product of the turns about x (roll) and z (yaw).
fn axes(roll: f64, yaw: f64) -> Matrix3<f64> {
    let (s, c) = roll.sin_cos();
    let about_x = Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c);
    let (s, c) = yaw.sin_cos();
    about_x * Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0)
}

/// Wheels of different radii on rails that have moved and move, with roll and yaw of both signs, on
/// rails and on rollers.
#[test]
fn a_wheelset_is_two_wheels_placed_by_hand() {
    let rails = [
        RailMotion {
            lateral: 0.3e-3,
            vertical: 40e-6,
            lateral_velocity: 0.01,
            vertical_velocity: 2e-3,
        },
        RailMotion {
            lateral: -0.2e-3,
            vertical: 10e-6,
            lateral_velocity: -0.02,
            vertical_velocity: 1e-3,
        },
    ];
    for (roll, yaw, larger, rail_radius) in [
        (1e-4, 4e-3, 30e-6, 0.0),
        (-1e-4, 4e-3, -30e-6, 0.0),
        (1e-4, -4e-3, -30e-6, 0.5),
        (-1e-4, -4e-3, 30e-6, 0.5),
    ] {
        let mut stand = Stand::new_profiles();
        for (pair, sign) in stand.pairs.iter_mut().zip([1.0, -1.0]) {
            pair.wheel_radius = RADIUS + sign * larger;
            (pair.rail_radius, pair.rail_ahead) = (rail_radius, 1e-3);
            pair.rail_speed = if rail_radius > 0.0 { 3.0 } else { 0.0 };
        }
        // in balance, and then lower: by what the rails have sunk, and a little more
        let still = Velocity { forward: 3.0, ..ROLLS };
        let flat = stand.settle(&at(1e-3, yaw), &still, &LOAD).unwrap().state.position;
        let vertical = flat.vertical + 60e-6;
        let roll = flat.roll + 0.2 * roll;
        let position = Position { vertical, roll, ..flat };
        let velocity = Velocity {
            forward: 17.0,
            lateral: 0.02,
            vertical: 1e-3,
            roll: 0.02,
            pitch: -43.5,
            yaw: -0.03,
        };
        let found = stand.solve(&position, &velocity, rails);
        let axes = axes(roll, yaw);
        let centre = Vector3::new(0.0, position.lateral, position.vertical);
        let speed = Vector3::new(velocity.forward, velocity.lateral, velocity.vertical);
        let rate = axes.column(0) * velocity.roll + axes.column(2) * velocity.yaw;
        let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
        for k in [0, 1] {
            let (side, motion) = ([1.0, -1.0][k], rails[k]);
            let arm = axes.column(1) * (side * HALF);
            let place = centre + arm;
            let moves = speed + rate.cross(&arm);
            let own = Position {
                lateral: place.y - side * stand.origins[k] - motion.lateral,
                // the centre of a larger wheel is nearer to the rail than its radius
                vertical: place.z + side * larger - motion.vertical,
                yaw,
                roll,
            };
            let own_velocity = Velocity {
                forward: moves.x,
                lateral: moves.y - motion.lateral_velocity,
                vertical: moves.z - motion.vertical_velocity,
                ..velocity
            };
            let pair = WheelPair { rail_ahead: 1e-3 - place.x, ..stand.pairs[k] };
            let mut memory = zeroed();
            let wheel = scene(&stand.rails[k], &stand.wheels[k], &pair)
                .solve(&BodyState { position: own, velocity: own_velocity }, &mut memory)
                .unwrap();
            assert!(wheel.contacts > 0 && wheel.normal_force > 1e3, "{wheel:?}");
            for (own, other) in wheel.members().iter().zip(found.wheel[k].members()) {
                assert_relative_eq!(*own, other, max_relative = 1e-7, epsilon = 1e-2);
            }
            let on_wheel = Vector3::from(wheel.force);
            force += on_wheel;
            moment += Vector3::from(wheel.moment) + axes.transpose() * arm.cross(&on_wheel);
            for (rail, own) in found.rail[k].iter().zip(wheel.force) {
                assert_relative_eq!(*rail, -own, max_relative = 1e-7, epsilon = 1e-2);
            }
        }
        let expected = force.iter().chain(&moment);
        for (own, expected) in found.wrench.members().iter().zip(expected) {
            assert_relative_eq!(*own, *expected, max_relative = 1e-7, epsilon = 0.1);
        }
    }
}

/// A roller and the wheel above it exchange their parts: the forward force turns round if the slip
/// does. A wheel whose rim is faster than the roller is driven forward.
#[test]
fn a_rim_that_is_faster_than_its_roller_is_driven_forward() {
    for (rail_radius, rail_speed) in [(0.0, 0.0), (0.5, 10.0), (0.5, -10.0), (0.0, 10.0)] {
        let mut stand = Stand::new_profiles();
        for pair in &mut stand.pairs {
            (pair.rail_radius, pair.rail_speed) = (rail_radius, rail_speed);
        }
        let forward = if rail_speed == 0.0 { 10.0 } else { 0.0 };
        let speed = forward + rail_speed;
        let position = Position { vertical: 0.25e-3, ..Position::default() };
        for more in [0.01, -0.01] {
            let pitch = -speed / RADIUS * (1.0 + more);
            let velocity = Velocity { forward, pitch, ..ROLLS };
            let wrench = stand.solve(&position, &velocity, [NOTHING; 2]).wrench;
            let [ahead, ..] = wrench.force;
            assert!(ahead * more * speed > 0.0, "{rail_speed} {more} {ahead}");
            assert!(wrench.moment[1] * ahead > 0.0, "{:?}", wrench.moment);
        }
    }
}

/// The turn of the track in the axes of a wheelset that rolls and yaws, in curves and with cant of
/// both signs.
#[test]
fn the_track_turns_about_its_normal() {
    for (curvature, cant, roll, yaw) in [
        (1.0 / 300.0, 0.1, 0.02, 0.03),
        (-1.0 / 300.0, 0.1, -0.02, 0.03),
        (0.01, -0.1, 0.02, -0.03),
    ] {
        let curve = Curve { speed: 20.0, curvature, cant, gravity: 9.81 };
        let here = Position { lateral: 2e-3, roll, yaw, ..Position::default() };
        let (velocity, weight, _) = curve.motion(&here, &Velocity::default()).unwrap();
        let (sine, cosine) = f64::sin_cos(cant);
        let turn = Vector3::new(0.0, sine, cosine) * (20.0 * curvature);
        let own = axes(roll, yaw).transpose() * turn;
        for (rate, expected) in [velocity.roll, velocity.pitch, velocity.yaw].iter().zip(own.iter())
        {
            assert_relative_eq!(*rate, *expected, max_relative = 1e-9);
        }
        let outward = 20.0 * 20.0 * curvature;
        assert_relative_eq!(weight[1], 9.81 * sine - outward * cosine, max_relative = 1e-9);
        assert_relative_eq!(weight[2], 9.81 * cosine + outward * sine, max_relative = 1e-9);
    }
}

/// A flange without its tread, 8 mm beside the head of the rail, is not over the rail: a search for
/// the gap refuses it, and one above the head finds the rail out of reach.
#[test]
fn a_flange_beside_the_rail_is_not_over_it() {
    let [y, z] = points("s1002");
    let flange = y.iter().zip(&z).filter(|(y, _)| (-44e-3..-32e-3).contains(*y));
    let (y, z): (Vec<f64>, Vec<f64>) = flange.unzip();
    let (wheel, rail) = (prepared(&y, &z), manchester::profile("uic60"));
    let mut gap = zeroed();
    let mut search = |vertical: f64| {
        let position = Position { lateral: -22e-3, vertical, ..Position::default() };
        GapSearch::new(&rail, &wheel, RADIUS, &position).unwrap().gap(0.0, &mut gap)
    };
    for vertical in [8e-3, 12e-3, 16e-3] {
        assert_eq!(search(vertical), Err(Error::ProfileEnd), "{vertical}");
    }
    assert_eq!(search(-16e-3), Ok(2e-3));
}
