//! Wheels on rollers: against Hertz, spheres, a search over both surfaces, and the wheel on a
//! straight rail.

use crate::prelude::*;
use crate::wheel_rail::{assert_derivatives, mean_and_p95, moved, power};
use kstrip_testing::patch_reference::{number, rows_of};

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

/// A left wheel on a roller, moved and turned to the other side, has the mirror image of the forces
/// on a right one, to the bit.
#[test]
fn a_left_wheel_on_a_roller_is_a_mirror_image() {
    for (radius, ahead) in [(0.5, 0.0), (0.5, 4e-3), (3.0, -8e-3)] {
        let mut stand = on_roller(radius, cone);
        (stand.pair.rail_speed, stand.pair.rail_ahead) = (10.0, ahead);
        let Position { lateral, vertical, yaw, roll } = under_load(
            &mut stand,
            Position { lateral: 1e-3, yaw: 3e-3, roll: 2e-3, ..Position::default() },
        );
        let right = Position { lateral, vertical, yaw, roll };
        let left = Position { lateral: -lateral, vertical, yaw: -yaw, roll: -roll };
        let moves = Velocity { lateral: 0.01, yaw: 0.02, roll: 1e-3, ..Velocity::default() };
        let moves = Velocity { pitch: -21.7, vertical: 1e-3, ..moves };
        let Velocity { lateral, yaw, roll, .. } = moves;
        let mirrored = Velocity { lateral: -lateral, yaw: -yaw, roll: -roll, ..moves };
        let own = stand.solve(&right, &moves);
        stand.pair.left = 1;
        let other = stand.solve(&left, &mirrored);
        let signs = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0];
        for ((own, other), sign) in own.members().iter().zip(other.members()).zip(signs) {
            assert_eq!(*own, sign * other, "{radius} {ahead}");
        }
        assert!(own.force[1].abs() > 100.0, "{own:?}");
        assert_eq!(own.dissipation, other.dissipation);
    }
}

/// Two discs turn with one speed of their surfaces: no creepage but the spin of the cone, which is
/// the sum of both curvatures; and the rig's power is dissipated.
#[test]
fn the_roller_turns_under_the_wheel() {
    let mut stand = on_roller(0.5, cone);
    stand.pair.rail_speed = 10.0;
    let position = under_load(&mut stand, Position::default());
    let contact = stand.memory.found()[0];
    // the roller's own surface under the strips
    let used = contact.patch.used().iter().zip(contact.strip_y);
    let passed = used.map(|(strip, y)| strip.load() * (0.5 - round_head(HEAD)(y)));
    let speed = 10.0 * passed.sum::<f64>() / contact.normal_force / 0.5;
    assert_relative_eq!(contact.at_rest.slip_x, speed, max_relative = 1e-6);
    let speed = contact.at_rest.slip_x;
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

/// A disc on a roller, both with these radii and profiles `z(y)`, whose rims move at 5 m/s at
/// `y = 0`.
fn discs(
    [wheel_radius, roller_radius]: [f64; 2], wheel: impl Fn(f64) -> f64,
    roller: impl Fn(f64) -> f64,
) -> (Stand, Velocity<f64>) {
    let mut stand = Stand::new(drawn(120, 0.1e-3, roller), drawn(120, 0.1e-3, wheel), wheel_radius);
    (stand.pair.rail_radius, stand.pair.rail_speed) = (roller_radius, 5.0);
    (stand, Velocity { pitch: -5.0 / wheel_radius, ..Velocity::default() })
}

/// Discs whose rims have one speed at every place have no longitudinal force: equal ones by
/// symmetry, and others whose crowns make them equal. What is left of STRIP's is that points of
/// the wheel lie above those of the roller along the roller's normals: this moves the patch of
/// cones by about 1 µm, of which their spin makes slip.
#[test]
fn discs_with_equal_rim_speeds_have_no_force() {
    let crown = |radius: f64, cone: f64| move |y: f64| -round_head(radius)(y) - cone * y;
    let rail = |radius: f64, cone: f64| move |y: f64| round_head(radius)(y) - cone * y;
    for (radii, crowns, cone, load) in [
        ([0.035; 2], [0.08; 2], 0.0, 2e3),
        ([0.2; 2], [0.08; 2], 0.0, 20e3),
        ([0.46; 2], [0.3; 2], 0.0, 80e3),
        ([0.2; 2], [0.08; 2], 0.05, 20e3),
        ([0.46; 2], [0.3; 2], -0.1, 80e3),
        ([0.46, 0.92], [0.3, 0.15], 0.0, 80e3),
        ([0.3, 0.1], [0.08, 0.24], 0.0, 10e3),
    ] {
        let (mut stand, turns) = discs(radii, crown(crowns[0], cone), rail(crowns[1], cone));
        let vertical = stand.height(&Position::default(), load, None);
        for model in [Model::Strip, Model::Total, Model::Strip1967Continuous] {
            stand.model = model;
            let position = Position { vertical, ..Position::default() };
            let wrench = stand.solve(&position, &turns);
            let pull = wrench.force[0] / (0.3 * load);
            println!("{radii:?} {crowns:?} {cone} {model:?}: {pull:.2e}");
            let most = match (crowns[0] == crowns[1], cone == 0.0) {
                (true, true) => 2e-6,
                (false, _) => 1e-5,
                _ => 2e-4,
            };
            assert!(pull.abs() < most, "{radii:?} {crowns:?} {cone} {model:?}: {pull}");
        }
    }
}

/// A wheel on a roller, turned by 180 degrees about `x`, is a roller under a wheel.
#[test]
fn wheel_and_roller_change_places() {
    let (cone, round, worn) = (|y: f64| -0.03 * y, round_head(0.1), |y: f64| y * y);
    let radii = [0.3, 0.5];
    for (lateral, slip, across) in [(0.0, 2e-3, 0.0), (2e-3, -1e-3, 0.01), (-1e-3, 0.0, -0.02)] {
        let upper = |y: f64| cone(y) + worn(y);
        let image = |y: f64| -round(-y);
        let lower = |y: f64| -(cone(-y) + worn(-y));
        let (mut one, turns) = discs(radii, upper, round_head(0.1));
        let vertical = one.height(&Position { lateral, ..Position::default() }, 20e3, None);
        let position = Position { lateral, vertical, ..Position::default() };
        let turns = Velocity { pitch: turns.pitch * (1.0 + slip), lateral: across, ..turns };
        let [x, y, z] = one.solve(&position, &turns).force;
        let (mut other, turns) = discs([radii[1], radii[0]], image, lower);
        other.pair.rail_speed *= 1.0 + slip;
        let exchanged = other.solve(&position, &Velocity { lateral: across, ..turns });
        let off = [exchanged.force[0] + x, exchanged.force[1] - y, exchanged.force[2] - z];
        println!("{lateral} {slip} {across}: {:?} {:?}", [x, y, z], exchanged.force);
        assert!(off.iter().all(|off| off.abs() < 1e-3 * 0.3 * 20e3), "{off:?}");
    }
}

/// Forces, heights and pressures of 18 runs of CONTACT; creep forces divided by mu N.
#[test]
fn forces_on_rollers_are_those_of_contact() {
    let drawn = |name: &str| {
        let rows = numbers::<2>(&format!("rollers/{name}.csv"));
        let [y, z] = [0, 1].map(|i| rows.iter().map(|row| 1e-3 * row[i]).collect::<Vec<_>>());
        prepared(&y, &z)
    };
    for model in [Model::Strip, Model::Total] {
        let (mut forces, mut heights) = (vec![], vec![]);
        for row in rows_of("rollers", "runs.csv") {
            let number = |column: &str| number(&row, column);
            let (rail, wheel) = (drawn(&row["rail"]), drawn(&row["wheel"]));
            let mut stand = Stand::new(rail, wheel, 1e-3 * number("wheel_radius_mm"));
            stand.model = model;
            stand.pair.friction = number("friction");
            stand.pair.rail_radius = 1e-3 * number("roller_radius_mm");
            stand.pair.rail_speed = 1e-3 * number("forward_mm_s");
            let (lateral, yaw) = (1e-3 * number("lateral_mm"), number("yaw_rad"));
            let position = Position { lateral, yaw, ..Position::default() };
            let (across, pitch) = (1e-3 * number("lateral_mm_s"), number("pitch_rad_s"));
            let velocity = Velocity { lateral: across, pitch, ..Velocity::default() };
            let vertical = stand.height(&position, number("support_N"), Some(&velocity));
            let wrench = stand.solve(&Position { vertical, ..position }, &velocity);
            // of the pressure ahead of the axis, which CONTACT leaves out
            let pressure: f64 = stand
                .memory
                .found()
                .iter()
                .map(|contact| contact.share * contact.normal_force * contact.normal[0])
                .sum();
            let [x, y, _] = wrench.force;
            let bound = number("friction") * number("normal_force_N");
            let off = (x + pressure + number("FX_N")).hypot(y + number("FY_N")) / bound;
            println!("{model:?} {} {lateral:.6} {yaw} {off:.4}", row["pair"]);
            forces.push(off);
            heights.push(vertical * 1e6 - 1e3 * number("vertical_mm"));
        }
        let [forces, heights] = [mean_and_p95(forces), mean_and_p95(heights)];
        println!("{model:?}: forces {forces:.4?}, heights {heights:.2?} um");
        assert!(forces[0] < 0.02 && heights[0] < 1.0);
    }
}
