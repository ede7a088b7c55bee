//! Damping of the pressure, and the floor of the speed of a wheel.

use crate::prelude::*;
use crate::wheel_rail::{assert_derivatives, assert_near, by_position, dot, moved, power};

/// Damping \[s/m\].
const DAMPING: f64 = 0.8;

/// A wheel whose flange has begun to touch.
fn on_two_points() -> (Stand, Position<f64>) {
    let mut stand = Stand::new_profiles();
    let position = Position { yaw: 3e-3, ..stand.at(5.2e-3, 80e3) };
    stand.pair.normal_damping = DAMPING;
    (stand, position)
}

/// Velocity into the rail of each contact, with its share of the undamped load.
fn approach(stand: &Stand, velocity: &Velocity<f64>) -> Vec<[f64; 2]> {
    let found = stand.memory.found().iter();
    let speed = |contact: &WheelContact<f64>| dot(&contact.normal, &rates(velocity));
    found.map(|contact| [speed(contact), contact.share * contact.normal_force]).collect()
}

/// Hunt and Crossley's factor on the load of each contact; and the power of the wrench is that of
/// friction and of the damped pressure.
#[test]
fn pressure_grows_with_the_approach() {
    let (mut stand, position) = on_two_points();
    for vertical in [-3.0, -1.3, -0.2, 0.0, 0.05, 2.0] {
        let velocity = Velocity { lateral: 0.02, vertical, roll: 0.1, ..ROLLING };
        let wrench = stand.solve(&position, &velocity);
        let (mut load, mut taken) = (0.0, 0.0);
        for [speed, share] in approach(&stand, &velocity) {
            let damped = share * (1.0 + DAMPING * speed).max(0.0);
            load += damped;
            taken += damped * speed;
        }
        assert_relative_eq!(wrench.normal_force, load, max_relative = 1e-12);
        let rest = power(&wrench, &velocity) + wrench.dissipation + taken;
        assert!(rest.abs() <= 1e-9 * 0.3 * 80e3 * 20.0, "{vertical}: {rest}");
        // (creep forces follow the damped pressure)
        let [fx, fy, _] = wrench.force;
        assert!(fx.hypot(fy) <= 1.5 * wrench.normal_force && wrench.dissipation >= 0.0);
    }
}

/// The wheel is never pulled down, however fast it is lifted, and nothing jumps where the pressure
/// begins to act.
#[test]
fn nothing_pulls_and_nothing_jumps() {
    let (mut stand, position) = on_two_points();
    stand.solve(&position, &ROLLING);
    let at = |vertical: f64| {
        of_contacts(stand.memory.found(), &Velocity { vertical, ..ROLLING }, STRIP, None).unwrap()
    };
    let lifted = at(-20.0);
    assert_eq!((lifted.members(), lifted.normal_force), ([0.0; 6], 0.0));
    // (the loads of both contacts, and their friction, over levers below 1 m)
    let slope = DAMPING * 2.0 * 80e3;
    let wrenches: Vec<_> = (0..4000).map(|i| at(-6.0 + f64::from(i) * 1.5e-3).members()).collect();
    for pair in wrenches.windows(2) {
        for (a, b) in pair[0].iter().zip(pair[1]) {
            assert!((a - b).abs() < 1.5e-3 * slope, "{pair:?}");
        }
    }
    // from both sides of the velocity at which the pressure of the tread is taken away
    let all = approach(&stand, &Velocity { vertical: 1.0, ..Velocity::default() });
    let of_tread = all.into_iter().max_by(|[_, a], [_, b]| a.total_cmp(b)).unwrap()[0];
    let clamp = -1.0 / (DAMPING * of_tread);
    let [below, above] = [-1e-9, 1e-9].map(|step| at(clamp + step).members());
    for (below, above) in below.into_iter().zip(above) {
        assert!((below - above).abs() < 1e-2, "{below} {above}");
    }
}

/// Derivatives with respect to velocity, friction and position against differences, with one law
/// and another.
#[test]
fn derivatives_are_those_of_differences() {
    let (mut stand, position) = on_two_points();
    let falling = SlipFriction { ratio: 0.4, decay: 0.6, ..SlipFriction::of_constant(0.3) };
    for (law, forward, vertical) in
        [(None, 20.0, 0.3), (Some(falling), 20.0, -0.4), (None, 0.0, 0.1), (None, -5.0, -0.2)]
    {
        stand.falling = law;
        let pitch = -forward / 0.4603;
        let velocity = Velocity { forward, lateral: 1e-3, vertical, pitch, ..Velocity::default() };
        let slopes = stand.derivatives(&position, &velocity);
        let (scene, memory) = stand.split();
        let (_, by) = by_position(&scene, position, velocity, memory);
        let scale = (forward * forward + 4e-4_f64).sqrt();
        assert_derivatives(&slopes.velocity, 0..6, (2e-7 * scale, 1e-3 / scale), |k, step| {
            stand.solve(&position, &moved(&velocity, k, step))
        });
        let [plus, minus] = [2e-7, -2e-7].map(|step| {
            let at = Position { vertical: position.vertical + step, ..position };
            stand.solve(&at, &velocity)
        });
        assert_near(&by.vertical, &difference(&plus, &minus, 2e-7), (1e-3, 0.0));
    }
}

/// A floor of the speed multiplies a slow wheel's slope at rest by the ratio of the floors.
#[test]
fn the_floor_of_the_speed_is_that_of_the_pair() {
    let mut stand = Stand::new_profiles();
    let position = stand.at(0.0, 80e3);
    let mut resistance = |floor_speed: f64| {
        stand.pair.floor_speed = floor_speed;
        let slopes = stand.derivatives(&position, &Velocity::default());
        slopes.velocity[1][1]
    };
    let [default, same, larger] = [0.0, 0.02, 0.2].map(&mut resistance);
    assert_relative_eq!(default, same, max_relative = 1e-12);
    assert_relative_eq!(default, 10.0 * larger, max_relative = 1e-9);
}

#[test]
fn negative_numbers_are_named() {
    let mut stand = Stand::new_profiles();
    let position = stand.at(0.0, 80e3);
    let mut status = |normal_damping: f64, floor_speed: f64| {
        (stand.pair.normal_damping, stand.pair.floor_speed) = (normal_damping, floor_speed);
        let (scene, memory) = stand.split();
        scene.solve(&BodyState { position, velocity: ROLLING }, memory).err()
    };
    assert_eq!(status(-0.1, 0.0), Some(Error::NormalDamping));
    assert_eq!(status(0.0, -0.1), Some(Error::FloorSpeed));
    assert_eq!(status(f64::NAN, 0.0), Some(Error::NotFinite));
    assert_eq!(status(0.1, 0.1), None);
}

/// Contacts that count partly carry a part of the damping.
#[test]
fn damping_of_contacts_that_count_partly_has_the_slope_of_differences() {
    let surface = |name: &str| {
        let [y, z] = points(name);
        let mut surface = zeroed::<PreparedProfile<f64>>();
        surface.prepare(&y, &z, 0.0, 2e-3).unwrap();
        surface
    };
    let mut stand = Stand::new(surface("rail288"), surface("whl288"), 0.46);
    stand.pair.smoothing_length = 2e-3;
    let is_part = |contact: &WheelContact<f64>| (0.02..0.98).contains(&contact.share);
    let position = (0..80)
        .map(|k| Position { lateral: -72e-3 + 1e-4 * f64::from(k), ..Position::default() })
        .find_map(|place| {
            let place = Position { vertical: stand.height(&place, 80e3, None), ..place };
            stand.solve(&place, &ROLLING);
            stand.memory.found().iter().any(is_part).then_some(place)
        })
        .expect("contacts that count partly");
    stand.pair.normal_damping = DAMPING;
    let velocity = Velocity { vertical: 0.2, ..ROLLING };
    let slopes = stand.derivatives(&position, &velocity);
    assert!(stand.memory.found().iter().any(is_part));
    assert_derivatives(&slopes.velocity, 0..6, (1e-6, 1e-4), |k, step| {
        stand.solve(&position, &moved(&velocity, k, step))
    });
}
