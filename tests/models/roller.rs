//! Wheels on rollers: against Hertz, spheres, a search over both surfaces, and the wheel on a
//! straight rail.

use crate::prelude::*;
use crate::wheel_rail::{assert_derivatives, moved, power};

const RADIUS: f64 = 0.46;
/// Radius of a rail's head \[m\].
const HEAD: f64 = 0.3;
const LOAD: f64 = 60e3;

/// A wheel with a profile `z(y)` on a round head that is a roller of this radius; 0: straight.
fn on_roller(rail_radius: f64, wheel: impl Fn(f64) -> f64) -> Stand {
    on_head(HEAD, 0.25e-3, rail_radius, wheel)
}

/// The same on a head of another radius, with points at other distances.
fn on_head(head: f64, step: f64, rail_radius: f64, wheel: impl Fn(f64) -> f64) -> Stand {
    let (head, wheel) = (drawn(100, step, round_head(head)), drawn(100, step, wheel));
    let mut stand = Stand::new(head, wheel, RADIUS);
    stand.pair.rail_radius = rail_radius;
    stand
}

fn cone(y: f64) -> f64 {
    -0.05 * y
}

/// The position where pressure carries the load.
fn under_load(stand: &mut Stand, position: Position<f64>) -> Position<f64> {
    let (scene, memory) = stand.split();
    let (vertical, _) = scene.height_for_load(&position, LOAD, None, memory).unwrap();
    Position { vertical, ..position }
}

/// Half the length of the patch along the rail, and half its width.
fn half_axes(memory: &Workspace<f64>) -> [f64; 2] {
    let patch = &memory.found()[0].patch;
    let used = &patch.strips[..patch.count as usize];
    let longest = used.iter().map(|strip| strip.half_length).fold(0.0, f64::max);
    [longest, used.iter().map(|strip| strip.width).sum::<f64>() / 2.0]
}

/// Approach, load and ellipse of a cone on a roller are those of Hertz within half a per cent; a
/// roller of five wheel radii shortens the ellipse by 9 %.
#[test]
fn a_cone_on_a_roller_is_that_of_hertz() {
    let mut lengths = vec![];
    for rail_radius in [0.0, 5.0 * RADIUS, RADIUS, 0.2] {
        let mut stand = on_roller(rail_radius, cone);
        under_load(&mut stand, Position::default());
        let contact = &stand.memory.found()[0];
        let cosine = contact.angle.cos();
        let along = if rail_radius > 0.0 { rail_radius / cosine } else { FLAT };
        let radii = radii([along, HEAD, contact.radius / cosine, FLAT]);
        let exact = hertz(&radii, contact.normal_force, 82e9, 0.28).unwrap();
        let [a, b] = half_axes(&stand.memory);
        println!(
            "{rail_radius}: a {a:.6} {:.6}, b {b:.6} {:.6}, approach {:.4e} {:.4e}",
            exact.a, exact.b, contact.approach, exact.approach
        );
        assert_relative_eq!(a, exact.a, max_relative = 5e-3);
        assert_relative_eq!(contact.approach, exact.approach, max_relative = 5e-3);
        lengths.push(a);
    }
    assert!((lengths[1] / lengths[0] - 0.91).abs() < 5e-3, "{lengths:?}");
}

/// A ball beside the top of a roller is pressed along the line of both axes.
#[test]
fn a_ball_is_pushed_off_the_top() {
    let ball = |y: f64| (RADIUS * RADIUS - y * y).sqrt() - RADIUS;
    let mut stand = on_roller(0.9, ball);
    let straight = under_load(&mut stand, Position::default());
    let still = Velocity::default();
    for ahead in [0.0, 5e-3, -20e-3, 60e-3] {
        stand.pair.rail_ahead = -ahead;
        let between: f64 = RADIUS + 0.9 - straight.vertical;
        let height = (between * between - ahead * ahead).sqrt();
        let vertical = RADIUS + 0.9 - height;
        for yaw in [0.0, 0.02] {
            let wrench = stand.solve(&Position { vertical, yaw, ..Position::default() }, &still);
            assert_relative_eq!(wrench.normal_force, LOAD, max_relative = 2e-4);
            let [forward, _, down] = wrench.force;
            assert_relative_eq!(forward, LOAD * ahead / between, epsilon = 2.0);
            assert_relative_eq!(down, -LOAD * height / between, max_relative = 2e-4);
        }
    }
}

/// The least distance of a steep cone that yaws beside the top of a roller is that of a search over
/// all of its surface.
#[test]
fn the_least_distance_is_that_of_both_surfaces() {
    let (head, steep) = (0.02, 40.0_f64.to_radians());
    let profile = |y: f64| -steep.tan() * y;
    for (rail_radius, rail_ahead, yaw, roll) in [
        (2.0, 0.0, 0.02, 0.0),
        (0.9, 0.015, -0.02, 0.01),
        (0.5, -0.02, 0.04, -0.01),
        (0.4, 0.03, 0.0, 0.0),
    ] {
        let mut stand = on_head(head, 0.17e-3, rail_radius, profile);
        stand.pair.rail_ahead = rail_ahead;
        let lateral = -head * steep.sin();
        let position = under_load(&mut stand, Position { lateral, yaw, roll, vertical: 0.0 });
        let gap = &stand.memory.gap;
        let least = gap.distance[..gap.count as usize].iter().fold(1.0, |a: f64, b| a.min(*b));
        let (sin_roll, cos_roll) = roll.sin_cos();
        let (sin_yaw, cos_yaw) = yaw.sin_cos();
        // signed distance of a point of the wheel from the torus of the rail's head
        let distance = |theta: f64, y: f64| {
            let radius = RADIUS + profile(y);
            let [x, z] = [radius * theta.sin(), radius * theta.cos()];
            let across = sin_yaw * x + cos_yaw * y;
            let point = [
                cos_yaw * x - sin_yaw * y - rail_ahead,
                position.lateral + cos_roll * across - sin_roll * z,
                position.vertical + sin_roll * across + cos_roll * z - RADIUS,
            ];
            let from_axis = point[0].hypot(rail_radius - point[2]);
            (from_axis - (rail_radius - head)).hypot(point[1]) - head
        };
        let mut best = (f64::INFINITY, 0.0, 0.0);
        let (mut middle, mut size) = ([0.0, 0.0], [0.15, 20e-3]);
        for _ in 0..12 {
            for i in -60..=60 {
                for k in -60..=60 {
                    let at = [
                        middle[0] + size[0] * f64::from(i) / 60.0,
                        middle[1] + size[1] * f64::from(k) / 60.0,
                    ];
                    let found = distance(at[0], at[1]);
                    if found < best.0 {
                        best = (found, at[0], at[1]);
                    }
                }
            }
            middle = [best.1, best.2];
            size = size.map(|size| size / 5.0);
        }
        println!(
            "{rail_radius}: {:.3} um, {:.3} um at {:.4} rad",
            least * 1e6,
            best.0 * 1e6,
            best.1
        );
        // (the points of the gap are 0.1 mm apart)
        assert!((least - best.0).abs() < 0.15e-6, "{least} {best:?}");
    }
}

/// A wheel at rest on a rail that moves backward is one that moves forward on a rail at rest, and
/// on a roller of 100 km it is nearly this.
#[test]
fn a_moving_rail_is_a_moving_wheel() {
    let mut stand = on_roller(0.0, cone);
    let position = under_load(&mut stand, Position { yaw: 2e-3, ..Position::default() });
    let rolls = Velocity { forward: 20.0, pitch: -43.5, lateral: 0.01, ..Velocity::default() };
    let expected = stand.solve(&position, &rolls);
    let stays = Velocity { forward: 0.0, ..rolls };
    stand.pair.rail_speed = 20.0;
    let moved = stand.solve(&position, &stays);
    stand.pair.rail_radius = 1e5;
    let far = stand.solve(&position, &stays);
    for ((moved, far), expected) in
        moved.members().iter().zip(far.members()).zip(expected.members())
    {
        assert!((moved - expected).abs() < 1e-6 && (far - expected).abs() < 2.0, "{expected}");
    }
    assert_relative_eq!(moved.dissipation, expected.dissipation, max_relative = 1e-9);
}

/// Two discs turn with one speed of their surfaces: no creepage but the spin of the cone, which is
/// the sum of both curvatures; and the rig's power is dissipated.
#[test]
fn the_roller_turns_under_the_wheel() {
    let mut stand = on_roller(0.5, cone);
    stand.pair.rail_speed = 10.0;
    let position = under_load(&mut stand, Position::default());
    let contact = stand.memory.found()[0];
    let over = 0.5 - (contact.origin[2] - RADIUS + position.vertical);
    let speed = 10.0 * over / 0.5;
    let rolls = Velocity { pitch: -speed / contact.radius, ..Velocity::default() };
    let motion = contact.checked_motion(&rolls).unwrap();
    assert!(motion.slip_x.abs() < 1e-12 && motion.slip_y.abs() < 1e-12, "{motion:?}");
    assert_relative_eq!(motion.rolling_speed, speed, max_relative = 1e-12);
    let spin = contact.angle.sin() * (speed / contact.radius + 10.0 / 0.5);
    assert_relative_eq!(motion.spin_rate, spin, max_relative = 1e-4);
    // braked by 0.2 %
    let braked = Velocity { pitch: rolls.pitch * 0.998, yaw: 0.02, ..rolls };
    let wrench = stand.solve(&position, &braked);
    let contact = stand.memory.found()[0];
    let motion = contact.checked_motion(&braked).unwrap();
    let rest = contact.at_rest;
    let force = wrench.force[0] / -1.0;
    let by_rig = power(&wrench, &braked) + wrench.dissipation;
    assert!(wrench.force[0] < 0.0 && wrench.moment[1] < 0.0);
    let spin = (by_rig - force * rest.slip_x) / rest.spin_rate;
    assert!(spin.abs() < 60.0 && motion.slip_x > 0.0, "moment {spin}");
}

/// Derivatives with respect to velocity and by position, beside the top and yawed.
#[test]
fn derivatives_are_those_of_differences() {
    let mut stand = on_roller(0.5, cone);
    (stand.pair.rail_speed, stand.pair.rail_ahead) = (20.0, 0.01);
    let position = under_load(&mut stand, Position { yaw: 5e-3, ..Position::default() });
    let velocity = Velocity { pitch: -43.4, lateral: 0.02, ..Velocity::default() };
    let slopes = stand.derivatives(&position, &velocity);
    assert_derivatives(&slopes.velocity, 0..6, (4e-6, 1e-3), |k, step| {
        stand.solve(&position, &moved(&velocity, k, step))
    });
}
