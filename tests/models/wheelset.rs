//! The wheelset: balance, derivatives, power, Klingel's wave, EN 15302, Nadal, the Manchester
//! benchmark, and the curve.

use crate::prelude::*;
use crate::wheel_rail::assert_near;
use kstrip::wheelset::conicity::{RadiusDifference, Wave};
use kstrip::wheelset::forces::{WheelsetByPosition, WheelsetDerivatives, WheelsetForces};
use kstrip::wheelset::settle::Settled;
use kstrip::wheelset::track::{Curve, gauge_face};
use kstrip_testing::manchester::profile;
use nalgebra::{SMatrix, SVector};

type Ten = [f64; 10];

/// Profiles and pairs of both sides, and memory.
pub struct Stand {
    pub rails: [Box<PreparedProfile<f64>>; 2],
    pub wheels: [Box<PreparedProfile<f64>>; 2],
    pub pairs: [WheelPair<f64>; 2],
    pub origins: [f64; 2],
    /// Friction of both sides that falls.
    pub law: Option<SlipFriction<f64>>,
    memory: Box<WheelsetWorkspace<f64>>,
}

/// Half the distance of the running circles: half of 1360 mm between the flange backs, and 70 mm.
pub const HALF: f64 = 0.75;
pub const HALF_GAUGE: f64 = 0.7175;
pub const RADIUS: f64 = 0.46;
pub const LOAD: WheelsetLoads<f64> = WheelsetLoads { vertical: 100e3, roll: 0.0, pitch: 0.0 };
pub const ROLLS: Velocity<f64> =
    Velocity { forward: 20.0, lateral: 0.0, vertical: 0.0, roll: 0.0, pitch: 0.0, yaw: 0.0 };
pub const NOTHING: RailMotion<f64> =
    RailMotion { lateral: 0.0, vertical: 0.0, lateral_velocity: 0.0, vertical_velocity: 0.0 };

pub fn at(lateral: f64, yaw: f64) -> Position<f64> {
    Position { lateral, yaw, ..Position::default() }
}

impl Stand {
    pub fn new(
        rail: Box<PreparedProfile<f64>>, wheel: Box<PreparedProfile<f64>>, origin: f64,
    ) -> Self {
        let left = WheelPair { left: 1, ..steel(RADIUS) };
        Self {
            rails: [rail.clone(), rail],
            wheels: [wheel.clone(), wheel],
            pairs: [steel(RADIUS), left],
            origins: [origin; 2],
            law: None,
            memory: zeroed(),
        }
    }

    /// S1002 on 60E1.
    pub fn new_profiles() -> Self {
        let rail = profile("uic60");
        let (face, warning) = gauge_face(&rail, 0.0).unwrap();
        assert_eq!(warning, Warning::None);
        assert_relative_eq!(HALF_GAUGE - face, 0.760_532_5, epsilon = 1e-6);
        Self::new(rail, profile("s1002"), HALF_GAUGE - face)
    }

    /// Wheels with a cone on round rail heads.
    fn coned(cone: f64, head: f64) -> Self {
        let (head, cone) = (drawn(80, 0.4e-3, round_head(head)), drawn(80, 0.4e-3, |y| -y * cone));
        Self::new(head, cone, HALF)
    }

    fn split(
        &mut self, motion: [RailMotion<f64>; 2],
    ) -> (Wheelset<'_, f64>, &mut WheelsetWorkspace<f64>) {
        let Self { rails, wheels, pairs, origins, law, memory } = self;
        let law = Law { falling: law.as_ref(), model: Model::Strip };
        let scenes = [0, 1].map(|i| Scene { law, ..scene(&rails[i], &wheels[i], &pairs[i]) });
        let excess = (pairs[0].wheel_radius - pairs[1].wheel_radius) / 2.0;
        let sides = [(1.0, 0, 6), (-1.0, 1, 8)].map(|(sign, i, rail)| Side {
            arm: sign * HALF,
            origin: sign * origins[i],
            excess: sign * excess,
            rail,
            motion: motion[i],
        });
        (Wheelset { scenes, sides }, memory)
    }

    pub fn settle(
        &mut self, start: &Position<f64>, velocity: &Velocity<f64>, loads: &WheelsetLoads<f64>,
    ) -> Result<Settled<f64>, Error> {
        let (wheelset, memory) = self.split([NOTHING; 2]);
        wheelset.settle(&BodyState { position: *start, velocity: *velocity }, loads, memory)
    }

    pub fn solve(
        &mut self, position: &Position<f64>, velocity: &Velocity<f64>, rails: [RailMotion<f64>; 2],
    ) -> WheelsetForces<f64> {
        let (wheelset, memory) = self.split(rails);
        wheelset.solve(&BodyState { position: *position, velocity: *velocity }, memory).unwrap()
    }

    /// With respect to all velocities and by all positions.
    fn derivatives(
        &mut self, state: &BodyState<f64>, rails: [RailMotion<f64>; 2],
    ) -> (WheelsetDerivatives<f64>, WheelsetByPosition<f64>) {
        let (mut by, mut moved) = (WheelsetDerivatives::default(), WheelsetByPosition::default());
        let requested = Requested { by_velocity: Some(&mut by), by_position: Some(&mut moved) };
        let (wheelset, memory) = self.split(rails);
        wheelset.differentiate(state, memory, requested).unwrap();
        (by, moved)
    }

    fn differences(&mut self, shifts: &[f64], with_roll: bool) -> Vec<f64> {
        let (wheelset, memory) = self.split([NOTHING; 2]);
        let difference =
            |shift: &f64| wheelset.rolling_radius_difference(*shift, with_roll, memory).unwrap();
        shifts.iter().map(difference).collect()
    }
}

fn ten(forces: &WheelsetForces<f64>) -> Ten {
    let [a, b, c, d, e, f] = forces.wrench.members();
    let [[_, g, h], [_, i, j]] = forces.rail;
    [a, b, c, d, e, f, g, h, i, j]
}

/// The wheelset and its rails, moved from where they are.
#[derive(Clone, Copy)]
struct State {
    place: Ten,
    speed: Ten,
}

impl State {
    fn forces(&self, stand: &mut Stand) -> WheelsetForces<f64> {
        let (position, velocity, rails) = self.parts();
        stand.solve(&position, &velocity, rails)
    }

    fn parts(&self) -> (Position<f64>, Velocity<f64>, [RailMotion<f64>; 2]) {
        let [_, lateral, vertical, roll, _, yaw, ..] = self.place;
        let [forward, v, w, p, pitch, r, ..] = self.speed;
        let velocity = Velocity { forward, lateral: v, vertical: w, roll: p, pitch, yaw: r };
        let rails = [6, 8].map(|k| RailMotion {
            lateral: self.place[k],
            vertical: self.place[k + 1],
            lateral_velocity: self.speed[k],
            vertical_velocity: self.speed[k + 1],
        });
        (Position { lateral, vertical, yaw, roll }, velocity, rails)
    }
}

/// Wheelsets in balance on rails that have moved and move: in the middle, on the flange, in the
/// middle with unlike wheels.
fn states() -> Vec<(Stand, State)> {
    let mut unlike = Stand::new_profiles();
    unlike.pairs[1] = WheelPair { wheel_radius: 0.4605, friction: 0.2, ..unlike.pairs[1] };
    let cases = [
        (Stand::new_profiles(), 1e-3, 2e-3),
        (Stand::new_profiles(), 5.9e-3, 3e-3),
        (unlike, -2e-3, 1e-3),
    ];
    cases.map(|(stand, lateral, yaw)| moving(stand, lateral, yaw, 20.0)).into()
}

/// A damped wheelset on rollers that turn under it.
fn on_rollers() -> (Stand, State) {
    let mut stand = Stand::new_profiles();
    for pair in &mut stand.pairs {
        let (rail_radius, rail_speed, normal_damping) = (0.5, 20.0, 0.5);
        *pair = WheelPair { rail_radius, rail_speed, normal_damping, ..*pair };
    }
    moving(stand, 2e-3, 3e-3, 0.0)
}

fn moving(mut stand: Stand, lateral: f64, yaw: f64, forward: f64) -> (Stand, State) {
    let rolls = Velocity { forward, ..ROLLS };
    let settled = stand.settle(&at(lateral, yaw), &rolls, &LOAD).unwrap();
    let Position { vertical, roll, .. } = settled.state.position;
    let pitch = settled.state.velocity.pitch;
    let (across, down) = (0.2e-3, 30e-6);
    let place =
        [0.0, lateral + across, vertical + down, roll, 0.0, yaw, across, down, across, down];
    let speed = [forward, 0.02, 1e-3, 0.01, pitch, 0.02, 0.01, 2e-3, -0.005, -1e-3];
    (stand, State { place, speed })
}

/// Derivatives with respect to all ten velocities and by all ten positions against differences.
#[test]
fn derivatives_are_those_of_differences() {
    for (mut stand, state) in states().into_iter().chain([on_rollers()]) {
        let (position, velocity, rails) = state.parts();
        let (by, moved) = stand.derivatives(&BodyState { position, velocity }, rails);
        let mut compare = |k: usize, step: f64, is_place: bool, allowed: f64| {
            let mut at = |step: f64| {
                let mut changed = state;
                let list = if is_place { &mut changed.place } else { &mut changed.speed };
                list[k] += step;
                ten(&changed.forces(&mut stand))
            };
            let (plus, minus) = (at(step), at(-step));
            let slopes = if is_place { &moved.position } else { &by.velocity };
            let expected: Ten = std::array::from_fn(|i| (plus[i] - minus[i]) / (2.0 * step));
            assert_near(&slopes.map(|row| row[k]), &expected, (allowed, 1e-9));
        };
        for k in 0..10 {
            compare(k, 4e-6, false, 1e-6);
            if k != 0 && k != 4 {
                compare(k, 0.7e-6, true, 1e-3);
            }
        }
        // on a factor of friction
        let friction = stand.pairs.map(|pair| pair.friction);
        let mut at = |factor: f64| {
            for (pair, friction) in stand.pairs.iter_mut().zip(friction) {
                pair.friction = friction * factor;
            }
            ten(&state.forces(&mut stand))
        };
        let (plus, minus) = (at(1.0 + 1e-5), at(1.0 - 1e-5));
        let expected: Ten = std::array::from_fn(|i| (plus[i] - minus[i]) / 2e-5);
        assert_near(&by.friction, &expected, (1e-7, 0.0));
    }
}

/// What the forces do on the wheelset and on both rails is lost by friction and goes into pressure.
#[test]
fn power_is_that_of_friction_and_pressure() {
    for (mut stand, state) in states() {
        let forces = state.forces(&mut stand);
        let power: f64 =
            ten(&forces).iter().zip(state.speed).map(|(force, speed)| force * speed).sum();
        // the wheel's velocity over its rail: the mean velocity of both surfaces into each other
        let mut pressed = 0.0;
        for (i, memory) in stand.memory.wheel.iter().enumerate() {
            let arm = [HALF, -HALF][i];
            let (Position { yaw, roll, .. }, _, rails) = state.parts();
            let [forward, lateral, vertical, p, pitch, r, ..] = state.speed;
            let over = [
                forward - arm * r * yaw.cos(),
                lateral
                    - arm * (p * roll.sin() + r * roll.cos() * yaw.sin())
                    - rails[i].lateral_velocity,
                vertical + arm * (p * roll.cos() - r * roll.sin() * yaw.sin())
                    - rails[i].vertical_velocity,
                p,
                pitch,
                r,
            ];
            for contact in memory.found() {
                let speed: f64 = contact.normal.iter().zip(over).map(|(n, v)| n * v).sum();
                pressed += contact.share * contact.normal_force * speed;
            }
        }
        let rest = power + forces.wrench.dissipation + pressed;
        assert!(forces.wrench.dissipation > 0.0);
        // the numbers that cancel are those of force times rolling speed
        assert!(rest.abs() < 1e-9 * 0.3 * 100e3 * 20.0, "{rest}");
    }
}

/// A rail that ends 10 um above the depth of its gauge face, or deeper, is complete.
#[test]
fn a_rail_that_ends_above_its_gauge_face_is_told() {
    let rail = profile("uic60");
    let top = rail.z[..rail.count as usize].iter().copied().fold(f64::INFINITY, f64::min);
    let told = |above: f64| gauge_face(&rail, rail.z[0] - top + above).unwrap().1;
    let warnings = [-500e-6, 9e-6, 11e-6].map(told);
    assert_eq!(warnings, [Warning::None, Warning::None, Warning::ProfileEnd]);
}

/// The loads are carried; loads that cannot be carried are named.
#[test]
fn settles_under_loads() {
    let mut stand = Stand::new_profiles();
    for (lateral, yaw, forward, vertical, roll, pitch) in [
        (0.0, 0.0, 20.0, 100e3, 0.0, 0.0),
        (1e-3, 1e-3, 20.0, 120e3, 10e3, -2e3),
        (5.5e-3, 5e-3, 20.0, 100e3, 10e3, 3e3),
        (0.0, 0.0, 0.0, 100e3, 0.0, 500.0),
        (1e-3, 0.0, -5.0, 100e3, 5e3, 500.0),
        (0.0, 0.0, 20.0, 100e3, 0.0, -13e3),
        (1e-3, 0.0, 20.0, 100.0, 0.0, 0.0),
        (1e-3, 0.0, 20.0, 100e3, 37e3, 0.0),
    ] {
        let loads = WheelsetLoads { vertical, roll, pitch };
        let velocity = Velocity { forward, ..ROLLS };
        let found = stand.settle(&at(lateral, yaw), &velocity, &loads).unwrap();
        assert_eq!(found.warning, Warning::None);
        let wrench = found.forces.wrench;
        assert_relative_eq!(wrench.force[2], -vertical, max_relative = 1e-9);
        assert_relative_eq!(wrench.moment[0], -roll, epsilon = 1e-9 * vertical);
        assert_relative_eq!(wrench.moment[1], -pitch, epsilon = 1e-9 * vertical);
        let again = stand.solve(&found.state.position, &found.state.velocity, [NOTHING; 2]);
        assert_eq!(ten(&again), ten(&found.forces));
    }
    let mut refused = |vertical: f64, roll: f64, pitch: f64| {
        stand.settle(&at(0.0, 0.0), &ROLLS, &WheelsetLoads { vertical, roll, pitch }).unwrap_err()
    };
    assert_eq!(refused(100e3, 80e3, 0.0), Error::WheelLifted);
    assert_eq!(refused(100e3, 0.0, -16e3), Error::ForceBeyondFriction);
    assert_eq!(refused(0.0, 0.0, 0.0), Error::Support);
}

/// A wheelset that rolls slowly swings with the wave length that the geometry of its wheels has,
/// and a slightly coned one with that of Klingel: lateral force, roll and yaw moment stay in
/// balance.
#[test]
fn a_coned_wheelset_has_the_wave_of_klingel() {
    for (cone, head) in [(0.01, 0.3), (0.05, 0.3), (0.1, 0.08)] {
        let mut stand = Stand::coned(cone, head);
        let settled = stand.settle(&at(0.0, 0.0), &ROLLS, &LOAD).unwrap();
        let (by, moved) = stand.derivatives(&settled.state, [NOTHING; 2]);
        // rates of y and yaw, pitch rate, height and roll that balance a change of y or of yaw
        let columns = [by.velocity, by.velocity, by.velocity, moved.position, moved.position];
        let freedoms = [1, 5, 4, 2, 3];
        let system = SMatrix::<f64, 5, 5>::from_fn(|i, j| columns[j][i + 1][freedoms[j]]);
        let [by_y, by_yaw] = [1, 5].map(|k| {
            let rest = SVector::<f64, 5>::from_fn(|i, _| -moved.position[i + 1][k]);
            system.lu().solve(&rest).unwrap()
        });
        let rates = Matrix2::new(by_y[0], by_yaw[0], by_y[1], by_yaw[1]);
        let length = 20.0 / rates.determinant().sqrt() * std::f64::consts::TAU;
        // the wheels touch nearer to the middle of the track by the slope of the head
        let between = 2.0 * (HALF - head * cone);
        let klingel = |cone: f64| std::f64::consts::TAU * (between / 2.0 * RADIUS / cone).sqrt();
        let shifts: Vec<f64> = (-50..=50).map(|i| f64::from(i) * 0.1e-3).collect();
        let [flat, rolled] = [false, true].map(|with_roll| {
            let differences = stand.differences(&shifts, with_roll);
            let radii = RadiusDifference::new(&shifts, &differences).unwrap();
            let [small, large] =
                [1e-3, 5e-3].map(|amplitude| radii.wave(amplitude, between, RADIUS).unwrap());
            assert_relative_eq!(small.length, large.length, max_relative = 2e-3);
            small
        });
        println!(
            "cone {cone}: wave {length:.4} m, geometry {:.4} and {:.4} m, Klingel {:.4} m",
            flat.length,
            rolled.length,
            klingel(cone)
        );
        assert_relative_eq!(flat.conicity, cone, max_relative = 2e-3);
        assert_relative_eq!(length, rolled.length, max_relative = 1e-2);
        assert_relative_eq!(rolled.length, klingel(rolled.conicity), max_relative = 1e-9);
        if cone < 0.02 {
            assert_relative_eq!(length, klingel(cone), max_relative = 1e-2);
        }
    }
}

/// The wave of a wheelset whose middle is elsewhere is the same, also where the shifts just reach.
#[test]
fn conicity_does_not_depend_on_where_shifts_are_counted_from() {
    // difference of radii of a cone that grows steeper outward
    let difference = |y: f64| 0.1 * y * (1.0 + (y / 4e-3).powi(2));
    let wave = |from: f64, count: i32, amplitude: f64| {
        let around: Vec<f64> = (-count..=count).map(|k| 0.5e-3 * f64::from(k)).collect();
        let shifts: Vec<f64> = around.iter().map(|y| y + from).collect();
        let differences: Vec<f64> = around.into_iter().map(difference).collect();
        RadiusDifference::new(&shifts, &differences).unwrap().wave(amplitude, 1.5, 0.46).unwrap()
    };
    for (count, amplitude) in [(6, 3e-3), (12, 3e-3), (8, 4e-3)] {
        let known = wave(0.0, count, amplitude);
        for from in [1e-3, -2.5e-3, 7e-3] {
            let found = wave(from, count, amplitude);
            assert_relative_eq!(found.conicity, known.conicity, max_relative = 1e-9);
            assert_relative_eq!(found.length, known.length, max_relative = 1e-9);
        }
    }
}

/// S1002 on 60E1, 120 kN: the curve in which a wheelset 1 mm from the middle has no yaw moment.
#[test]
fn conicity_under_load_is_that_of_zero_moment() {
    let mut stand = Stand::new_profiles();
    let (shift, loads) = (1e-3, WheelsetLoads { vertical: 120e3, ..LOAD });
    let mut moment = |curvature: f64| {
        let curve = Curve { speed: 20.0, curvature, cant: 0.0, gravity: 0.0 };
        let (velocity, ..) = curve.motion(&at(shift, 0.0), &Velocity::default()).unwrap();
        stand.settle(&at(shift, 0.0), &velocity, &loads).unwrap().forces.wrench.moment[2]
    };
    let ends = [-2e-3, 0.0];
    let [first, last] = ends.map(&mut moment);
    assert!(first * last < 0.0);
    let [low, _] = bisect(ends, 2e-9, |curvature| moment(curvature) * first > 0.0);
    let conicity = -HALF * RADIUS * low / shift;
    let length = std::f64::consts::TAU * (HALF * RADIUS / conicity).sqrt();
    println!("zero moment: conicity {conicity:.4}, wave {length:.3} m");
    assert_relative_eq!(conicity, 0.185, max_relative = 0.03);
    assert_relative_eq!(length, 8.6, max_relative = 0.03);
}

/// EN 15302: the integral of the norm's radius differences gives the norm's conicity, and kstrip's
/// own geometry is within the limits but where the wheel jumps from tread to flange.
#[test]
fn conicity_is_within_the_limits_of_the_norm() {
    let limits = numbers::<7>("wheel_rail/en_conicity.csv");
    let norm = numbers::<3>("wheel_rail/en_difference.csv");
    let metres = |column: usize| norm.iter().map(|row| row[column] * 1e-3).collect::<Vec<f64>>();
    let shifts: Vec<f64> = (-78..=78).map(|i| f64::from(i) * 0.1e-3).collect();
    for (wheel, column, wanted) in [("en_wheel_a", 1, 66), ("en_wheel_h", 4, 62)] {
        let mut stand = Stand::new(profile("en_rail"), profile(wheel), HALF_GAUGE + 32.5e-3);
        let own = stand.differences(&shifts, false);
        let given = [metres(0), metres(1 + column / 4)];
        let (given, own) = (
            RadiusDifference::new(&given[0], &given[1]).unwrap(),
            RadiusDifference::new(&shifts, &own).unwrap(),
        );
        let mut within = 0;
        for row in &limits {
            let (amplitude, [exact, upper, lower]) = (row[0], [0, 1, 2].map(|k| row[column + k]));
            let wave = own.wave(amplitude * 1e-3, 2.0 * HALF, RADIUS).unwrap();
            if (lower..=upper).contains(&wave.conicity) {
                within += 1;
            } else {
                println!("{wheel} {amplitude} mm: {:.4}, {lower} to {upper}", wave.conicity);
            }
            if amplitude < 6.75 {
                let wave = given.wave(amplitude * 1e-3, 2.0 * HALF, RADIUS).unwrap();
                assert!((wave.conicity - exact).abs() < 0.0011, "{amplitude} {wave:?} {exact}");
            }
        }
        println!("{wheel}: {within} of {}", limits.len());
        assert!(within >= wanted, "{wheel}: {within}");
    }
    let radii = RadiusDifference::new(&[-1e-3, 1e-3], &[-1e-4, 1e-4]).unwrap();
    assert_eq!(radii.wave(1.1e-3, 1.5, 0.46), Err(Error::Conicity));
    let against = RadiusDifference::new(&[-1e-3, 1e-3], &[1e-4, -1e-4]).unwrap();
    assert_eq!(against.wave(0.5e-3, 1.5, 0.46), Err(Error::Conicity));
}

/// A wheelset whose radii do not differ within the amplitude has the conicity 0 and no wave, as
/// wheel I of EN 15302. The conicity grows from 0 with the amplitude, without a step.
#[test]
fn conicity_is_zero_where_the_radii_do_not_differ() {
    let shifts: Vec<f64> = (-80..=80).map(|i| f64::from(i) * 1e-4).collect();
    let beyond = |shift: &f64| (shift.abs() - 2e-3).max(0.0) * 0.5 * shift.signum();
    let differences: Vec<f64> = shifts.iter().map(beyond).collect();
    let radii = RadiusDifference::new(&shifts, &differences).unwrap();
    let none = Wave { conicity: 0.0, length: f64::INFINITY };
    for amplitude in [1e-6, 0.3e-3, 1e-3, 1.99e-3] {
        assert_eq!(radii.wave(amplitude, 1.5, 0.46), Ok(none), "{amplitude}");
    }
    let mut last = 0.0;
    for k in 1..=60 {
        let wave = radii.wave(2e-3 + 1e-4 * f64::from(k), 1.5, 0.46).unwrap();
        assert!(wave.conicity > last && wave.conicity < last + 0.01 && wave.length.is_finite());
        last = wave.conicity;
    }
    assert!(last > 0.1 && last < 0.25, "{last}");
    // a cylinder, and radii that turn the wheelset away from the middle
    let cylinder = RadiusDifference::new(&[-1e-3, 1e-3], &[0.0, 0.0]).unwrap();
    assert_eq!(cylinder.wave(0.5e-3, 1.5, 0.46), Ok(none));
    let inverse: Vec<f64> = differences.iter().map(|difference| -difference).collect();
    let inverse = RadiusDifference::new(&shifts, &inverse).unwrap();
    assert_eq!(inverse.wave(3e-3, 1.5, 0.46), Err(Error::Conicity));
}

/// A cone has its own conicity however flat it is; what is too flat for the numbers has none.
#[test]
fn conicity_of_any_cone_is_a_number() {
    let shifts = [-4e-3, -2e-3, 0.0, 2e-3, 4e-3];
    for exponent in -330..300 {
        let slope = 10.0_f64.powi(exponent);
        let differences = shifts.map(|shift| 2.0 * slope * shift);
        let radii = RadiusDifference::new(&shifts, &differences).unwrap();
        match radii.wave(1e-3, 1.5, 0.46) {
            Ok(wave) if exponent > -300 => {
                assert_relative_eq!(wave.conicity, slope, max_relative = 1e-3);
            }
            Ok(wave) => assert_eq!(wave.conicity > 0.0, wave.length.is_finite(), "{wave:?}"),
            Err(error) => panic!("{exponent}: {error:?}"),
        }
    }
    // (one that rounds to nothing)
    let single = [-4e-3_f32, -2e-3, 0.0, 2e-3, 4e-3];
    for exponent in -45..30 {
        let slope = 10.0_f32.powi(exponent);
        let differences = single.map(|shift| 2.0 * slope * shift);
        let radii = RadiusDifference::new(&single, &differences).unwrap();
        let wave = radii.wave(1e-3, 1e20, 1e18);
        let has_length = |wave: &Wave<f32>| (wave.conicity > 0.0) == wave.length.is_finite();
        assert!(wave.as_ref().is_ok_and(has_length) || wave == Err(Error::Overflow), "{wave:?}");
    }
}

/// A flange that carries the whole wheel and slides down the rail has Nadal's ratio of Y to Q: the
/// least that holds it there.
#[test]
fn a_sliding_flange_has_the_limit_of_nadal() {
    let mut stand = Stand::new_profiles();
    let (wheelset, memory) = stand.split([NOTHING; 2]);
    let ([scene, _], memory) = (wheelset.scenes, &mut memory.wheel[0]);
    let (yaw, friction, flange) = (0.03, 0.3, 70f64.to_radians().tan());
    let nadal = (flange - friction) / (1.0 + friction * flange);
    for lateral in [-4.2e-3, -4.0e-3, -3.8e-3] {
        // (the flange does not slip along x)
        let mut velocity = Velocity { pitch: -20.0 / 0.47, ..ROLLS };
        let mut position = at(lateral, yaw);
        for _ in 0..4 {
            let found = scene.height_for_load(&position, 50e3, Some(&velocity), memory);
            position.vertical = found.unwrap().0;
            velocity.pitch = -20.0 / memory.found()[0].radius;
        }
        let wrench = scene.solve(&BodyState { position, velocity }, memory).unwrap();
        assert_eq!(wrench.contacts, 1);
        let [_, y, q] = wrench.force;
        let angle = memory.found()[0].angle.to_degrees();
        println!("Y/Q {:.4}, Nadal {nadal:.4}, {angle:.2} degrees", y / q);
        assert_relative_eq!(angle, -70.0, max_relative = 2e-3);
        assert_relative_eq!(y / q, nadal, max_relative = 0.015);
    }
}

/// Balance speed: weight and centrifugal force have no lateral part in the axes of the track.
#[test]
fn a_curve_has_its_balance_speed() {
    let (radius, cant) = (300.0, 0.1_f64);
    let speed = (9.806_65 * radius * cant.tan()).sqrt();
    for (curvature, cant) in [(1.0 / radius, cant), (-1.0 / radius, -cant)] {
        let curve = Curve { speed, curvature, cant, gravity: 0.0 };
        let here = Position { lateral: 2e-3, roll: 0.01, yaw: 0.02, ..Position::default() };
        let relative = Velocity { pitch: -37.0, ..Velocity::default() };
        let (velocity, weight, _) = curve.motion(&here, &relative).unwrap();
        assert!(weight[1].abs() < 1e-12, "{weight:?}");
        assert_relative_eq!(weight[2], 9.806_65 / cant.cos(), max_relative = 1e-12);
        let turning =
            (velocity.roll.powi(2) + (velocity.pitch + 37.0).powi(2) + velocity.yaw.powi(2)).sqrt();
        assert_relative_eq!(turning, speed / radius, max_relative = 1e-9);
        assert_relative_eq!(velocity.forward, speed - 2e-3 * speed * curvature * cant.cos());
    }
}

/// Where a wheelset runs freely through a curve, its lateral forces are those that weight and
/// centrifugal force ask for.
#[test]
fn lateral_forces_balance_a_curve() {
    let mut stand = Stand::new_profiles();
    let (cant, curvature) = (0.1_f64, 1.0 / 300.0);
    let balance = (9.806_65 * cant.tan() / curvature).sqrt();
    let mass = 10e3;
    for (speed, lateral) in [(balance, -5e-3), (22.0, -5e-3)] {
        let curve = Curve { speed, curvature, cant, gravity: 0.0 };
        // the yaw at which the lateral force is the one that is missing
        let mut rest = |yaw: f64| {
            let still = Velocity::default();
            let (velocity, weight, _) = curve.motion(&at(lateral, yaw), &still).unwrap();
            let loads = WheelsetLoads { vertical: mass * weight[2], ..LOAD };
            let found = stand.settle(&at(lateral, yaw), &velocity, &loads).unwrap();
            (found.forces, mass * weight[1])
        };
        let [low, _] = bisect([-8e-3, 8e-3], 1.5e-11, |yaw| {
            let (forces, weight) = rest(yaw);
            forces.wrench.force[1] + weight <= 0.0
        });
        let (forces, weight) = rest(low);
        let sum: f64 = forces.rail.iter().map(|force| force[1]).sum();
        println!("{speed:.3} m/s: sum of Y {sum:.1} N, weight {weight:.1} N, yaw {low:.5}");
        assert!((sum - weight).abs() < 1.0);
    }
}

/// Case of the Manchester benchmark by one call for both sides, beside CONTACT's figures, but
/// where the flange begins to climb.
#[test]
fn both_sides_are_those_of_the_manchester_benchmark() {
    let mut single = manchester::Wheelset::default();
    let mut stand = Stand::new_profiles();
    stand.origins = [0.760_532_5; 2];
    let (mut errors, mut loads) = (vec![], vec![]);
    for (left, shift, theirs) in manchester::contact() {
        if !left && (6.4..7.6).contains(&shift) {
            continue;
        }
        let (wheels, position, pitch) = single.with_position(shift * 1e-3);
        let velocity = Velocity { forward: 2.0, pitch, ..Velocity::default() };
        // the wheelset at the height at which this wheel carries its load
        let side = usize::from(left);
        let down = [HALF, -HALF][side] * position.roll.sin() * position.yaw.cos();
        let position = Position { vertical: wheels[side].vertical - down, ..position };
        let forces = stand.solve(&position, &velocity, [NOTHING; 2]);
        let [fx, fy, _] = forces.rail[side];
        errors.push((fx - theirs.fx).hypot(fy - theirs.fy) / (0.3 * theirs.load));
        loads.push((forces.wheel[side].normal_force / theirs.load - 1.0).abs());
    }
    let [error, load] = [&errors, &loads].map(|list| list.iter().sum::<f64>() / list.len() as f64);
    println!("forces {error:.4} of mu N, loads {load:.5}, {} wheels", errors.len());
    assert_eq!(errors.len(), 39);
    assert!(error < 0.02 && load < 2e-3);
}

/// Yaw moves the wheels of a wheelset off the tops of rollers, which push them farther: the moment
/// of a wheelset without friction is the load times the arm squared over the sum of the radii.
#[test]
fn rollers_push_a_yawed_wheelset_farther() {
    let moment = |rail_radius: f64, yaw: f64| {
        // (friction, and the cones' own stiffness, would hide it)
        let mut stand = Stand::coned(0.0, 0.3);
        for pair in &mut stand.pairs {
            *pair = WheelPair { rail_radius, friction: 0.0, ..*pair };
        }
        let still = Velocity { forward: 0.0, ..ROLLS };
        let [_, _, _, _, _, moment] =
            stand.settle(&at(0.0, yaw), &still, &LOAD).unwrap().forces.wrench.members();
        moment
    };
    let expected = 100e3 * HALF * HALF * 0.01 / (RADIUS + 0.5);
    let [straight, on_roller] = [0.0, 0.5].map(|rail_radius| moment(rail_radius, 0.01));
    assert!(straight.abs() < 1e-4 * expected, "{straight}");
    assert_relative_eq!(on_roller, expected, max_relative = 1e-3);
}

/// While the flange of one wheel climbs, the other wheel is lifted from the place where it has lost
/// its load to that where it carries again: the flange alone balances load and moment.
#[test]
fn a_wheel_lifts_over_the_whole_climb_of_the_other() {
    let mut stand = Stand::new_profiles();
    let loads = WheelsetLoads { vertical: 160e3, ..LOAD };
    let mut carried = Vec::new();
    for k in [61, 64, 66, 70, 74, 78, 82, 86, 88, 89] {
        let lateral = -1e-4 * f64::from(k);
        let found = stand.settle(&at(lateral, 0.01), &ROLLS, &loads).unwrap();
        let [[_, _, right], [_, _, left]] = found.forces.rail;
        assert_relative_eq!(right + left, 160e3, max_relative = 1e-6);
        assert!(found.forces.wrench.moment[0].abs() < 1e-6 * 160e3, "{lateral}");
        assert!(found.warning != Warning::NotConverged, "{lateral}");
        carried.push((k, right));
    }
    let lifted: Vec<i32> =
        carried.iter().filter(|(_, right)| *right == 0.0).map(|(k, _)| *k).collect();
    assert_eq!(lifted, [64, 66, 70, 74, 78, 82, 86, 88, 89], "{carried:?}");
    assert!(carried.iter().all(|(_, right)| *right >= 0.0), "{carried:?}");
}
