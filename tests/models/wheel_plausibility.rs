//! Wheels on rails that no railway has: wrong units, profiles upside down or the wrong way round,
//! members forgotten, and wheels that friction pulls down. Ordinary ones come without a warning.

use crate::prelude::*;

const WHEELS: [&str; 7] =
    ["s1002", "whl288", "avgwhl", "car7216", "wornhm", "en_wheel_a", "en_wheel_h"];
const RAILS: [&str; 6] = ["uic60", "rail288", "avgHR", "siteb", "avglow", "en_rail"];

const ROLLS: Velocity<f64> = Velocity { pitch: -43.48, ..ROLLING };

type Prepared = (Box<PreparedProfile<f64>>, Warning);

/// A profile of the data whose coordinates are multiplied by factors.
fn scaled(name: &str, [across, down]: [f64; 2]) -> Prepared {
    let [y, z] = points(name);
    let y: Vec<f64> = y.iter().map(|y| y * across).collect();
    let z: Vec<f64> = z.iter().map(|z| z * down).collect();
    prepared(&y, &z)
}

fn prepared(y: &[f64], z: &[f64]) -> Prepared {
    let mut surface = zeroed::<PreparedProfile<f64>>();
    let warning = surface.prepare(y, z, 0.0, 0.0).unwrap();
    (surface, warning)
}

/// A profile drawn at places from -end to end.
fn drawn(end: f64, height: impl Fn(f64) -> f64) -> Prepared {
    let y: Vec<f64> = (0..=200).map(|i| end * (f64::from(i) / 100.0 - 1.0)).collect();
    let z: Vec<f64> = y.iter().map(|y| height(*y)).collect();
    prepared(&y, &z)
}

/// The warning of a wheel pressed 0.1 mm into a rail.
fn on_rail(
    rail: &PreparedProfile<f64>, wheel: &PreparedProfile<f64>, pair: &WheelPair<f64>,
) -> Option<Warning> {
    let scene = Scene { strips: StripCount::Eight, ..scene(rail, wheel, pair) };
    let mut memory = zeroed::<Workspace<f64>>();
    let position = Position::default();
    let (vertical, _) = scene.height_for_load(&position, 40e3, None, &mut memory).ok()?;
    let position = Position { vertical, ..position };
    Some(scene.solve(&BodyState { position, velocity: ROLLS }, &mut memory).ok()?.warning)
}

#[test]
fn profiles_are_told_when_they_stand_wrong() {
    for name in WHEELS.into_iter().chain(RAILS) {
        assert_eq!(scaled(name, [1.0, 1.0]).1, Warning::None, "{name}");
        assert_eq!(scaled(name, [1e3, 1e3]).1, Warning::ProfileSize, "{name} in mm");
    }
    for name in WHEELS {
        for factors in [[-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
            assert_eq!(scaled(name, factors).1, Warning::Orientation, "{name} {factors:?}");
        }
    }
    for name in RAILS {
        assert_eq!(scaled(name, [1.0, -1.0]).1, Warning::Orientation, "{name}");
    }
    // cones, discs and a roller with rounded edges
    let cone = drawn(0.05, |y| -y / 20.0);
    let crowned = drawn(0.01, |y| -y * y / 0.6);
    let rounded = drawn(0.01, |y| {
        let beyond = (y.abs() - 8e-3).max(0.0);
        -(2e-3 - (2e-3_f64.powi(2) - beyond * beyond).sqrt())
    });
    for (_, warning) in [cone, crowned, rounded] {
        assert_eq!(warning, Warning::None);
    }
}

#[test]
fn wheels_on_rails_are_told_what_is_implausible() {
    let [rail, wheel] = ["uic60", "s1002"].map(manchester::profile);
    let pair = steel(0.46);
    assert_eq!(on_rail(&rail, &wheel, &pair), Some(Warning::None));
    let vertical = {
        let scene = Scene { strips: StripCount::Eight, ..scene(&rail, &wheel, &pair) };
        let mut memory = zeroed::<Workspace<f64>>();
        scene.height_for_load(&Position::default(), 40e3, None, &mut memory).unwrap().0
    };
    let cases = [
        (WheelPair { friction: 30.0, ..pair }, Warning::Friction),
        (WheelPair { shear_modulus: 82.0, ..pair }, Warning::Modulus),
        (WheelPair { shear_modulus: 82e3, ..pair }, Warning::Modulus),
        (WheelPair { wheel_radius: 460.0, ..pair }, Warning::Radius),
        (WheelPair { friction: 0.0, poisson_ratio: 0.0, ..pair }, Warning::Unset),
        (WheelPair { friction: 0.0, ..pair }, Warning::None),
        (WheelPair { friction: 4.95, ..pair }, Warning::None),
        (WheelPair { friction: 5.05, ..pair }, Warning::Friction),
        (WheelPair { shear_modulus: 1.01e5, ..pair }, Warning::None),
        (WheelPair { shear_modulus: 0.99e5, ..pair }, Warning::Modulus),
        (WheelPair { shear_modulus: 0.99e13, ..pair }, Warning::Young),
        (WheelPair { shear_modulus: 1.01e13, ..pair }, Warning::Modulus),
        (WheelPair { wheel_radius: 4.95, ..pair }, Warning::AxisRatio),
        (WheelPair { wheel_radius: 5.05, ..pair }, Warning::Radius),
        (WheelPair { poisson_ratio: 0.0, ..pair }, Warning::None),
    ];
    for (pair, expected) in cases {
        let scene = Scene { strips: StripCount::Eight, ..scene(&rail, &wheel, &pair) };
        let mut memory = zeroed::<Workspace<f64>>();
        let position = Position { vertical, ..Position::default() };
        let found = scene.solve(&BodyState { position, velocity: ROLLS }, &mut memory);
        assert_eq!(found.map(|found| found.warning), Ok(expected), "{pair:?}");
    }
    let pair = steel(0.46);
    for factors in [[-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
        let (wrong, _) = scaled("s1002", factors);
        let found = on_rail(&rail, &wrong, &pair);
        assert_eq!(found, Some(Warning::Orientation), "wheel {factors:?}");
    }
    let (wrong, _) = scaled("uic60", [1.0, -1.0]);
    assert_eq!(on_rail(&wrong, &wheel, &pair), None, "no load is carried by a rail upside down");
    let none = zeroed::<PreparedProfile<f64>>();
    assert_eq!(none.clone().prepare(&[], &[], 0.0, 0.0), Err(Error::Profile));
    let text = Error::NotPrepared.to_string();
    assert!(text.contains("kstrip_prepare_profile()"), "{text}");
}

/// Friction of a flange that slides upward carries the wheel down: the first heights support
/// nothing, and where the support is reached at last the contact is crushed.
#[test]
fn a_wheel_that_friction_pulls_down_is_told() {
    let (rail, wheel) = (profile("uic60", -0.025), profile("car7216", 0.0));
    let pair = WheelPair { friction: 0.4, ..steel(0.4318) };
    let scene = scene(&rail, &wheel, &pair);
    let mut memory = zeroed::<Workspace<f64>>();
    let mut told = 0;
    for shift in 0..60 {
        let lateral = -0.05 - 5e-4 * f64::from(shift);
        let position = Position { lateral, yaw: -0.0269, ..Position::default() };
        let up = Velocity { forward: 20.0, lateral: -0.451, pitch: -44.93, ..Velocity::default() };
        let Ok((_, warning)) = scene.height_for_load(&position, 24_426.0, Some(&up), &mut memory)
        else {
            continue;
        };
        let load: f64 = memory.found().iter().map(|c| c.share * c.normal_force).sum();
        // (four times the support presses on no flange that friction of 0.4 carries)
        assert!(load < 100e3 || warning == Warning::Support, "{lateral} {load}");
        told += i32::from(warning == Warning::Support);
    }
    assert!(told > 0);
}

/// A wheel with points 1.1 mm apart, as drawn or with 20 um of shape between them: it is smoothed,
/// unless a smoothing length says otherwise. With points 2.3 mm apart a narrow contact is told.
#[test]
fn coarse_profiles_are_smoothed_or_told() {
    let rail = manchester::profile("uic60");
    let [y, z] = points("s1002");
    let mut random = Random::new(5);
    let shape: Vec<f64> = y.iter().map(|_| random.between(-20e-6, 20e-6)).collect();
    let thinned = |every: usize, shape: &[f64], smoothing: f64| {
        let [y, z] = [&y, &z].map(|list| list.iter().step_by(every).copied().collect::<Vec<_>>());
        let z: Vec<f64> = z.iter().zip(shape).map(|(z, shape)| z + shape).collect();
        let mut surface = zeroed::<PreparedProfile<f64>>();
        surface.prepare(&y, &z, 0.0, smoothing).unwrap();
        surface
    };
    let none = vec![0.0; y.len()];
    let pair = steel(0.46);
    let mut memory = zeroed::<Workspace<f64>>();
    let mut pressed = |wheel: &PreparedProfile<f64>, lateral: f64| {
        let scene = scene(&rail, wheel, &pair);
        let position = Position { lateral, ..Position::default() };
        let (vertical, _) = scene.height_for_load(&position, 80e3, None, &mut memory).unwrap();
        let position = Position { vertical, ..position };
        let state = BodyState { position, velocity: ROLLS };
        let warning = scene.solve(&state, &mut memory).unwrap().warning;
        let strips = memory.found().iter().flat_map(|contact| &contact.patch.strips);
        (strips.fold(0.0, |most, strip| strip.peak_pressure.max(most)), warning)
    };
    let (whole, drawn) = (thinned(1, &none, 0.0), thinned(3, &none, 0.0));
    let (shaped, through) = (thinned(3, &shape, 0.0), thinned(3, &shape, 1e-6));
    let (mut worst, mut worst_through) = (0.0_f64, 0.0_f64);
    for k in 0..8 {
        let lateral = -13e-3 + 1e-3 * f64::from(k);
        let (right, _) = pressed(&whole, lateral);
        let off = |(peak, warning): (f64, Warning)| {
            assert_eq!(warning, Warning::None);
            (peak / right - 1.0).abs()
        };
        let of_drawn = off(pressed(&drawn, lateral));
        assert!(of_drawn < 0.01, "{lateral}: {of_drawn}");
        worst = worst.max(off(pressed(&shaped, lateral)));
        worst_through = worst_through.max(off(pressed(&through, lateral)));
    }
    println!("smoothed {worst:.3}, through all points {worst_through:.3}");
    assert!(worst < 0.35 && worst_through > 1.0, "{worst} {worst_through}");
    // what is drawn is not smoothed at all; between drawn and rough nothing jumps
    assert_eq!(drawn.z, thinned(3, &none, 1e-9).z);
    let mut at = |share: f64| {
        let shape: Vec<f64> = shape.iter().map(|shape| shape * share).collect();
        pressed(&thinned(3, &shape, 0.0), -10e-3).0
    };
    let peaks: Vec<f64> = (0..=100).map(|i| at(f64::from(i) * 4e-3)).collect();
    let steps = peaks.windows(2).map(|pair| (pair[1] / pair[0] - 1.0).abs());
    let most = steps.fold(0.0, f64::max);
    println!("largest step {most:.4}, from {:.3e} to {:.3e}", peaks[0], peaks[100]);
    assert!(most < 0.03, "{most}");
    let coarse = thinned(6, &none, 0.0);
    let warnings = [-8e-3, 0.0].map(|lateral| pressed(&coarse, lateral).1);
    assert_eq!(warnings, [Warning::None, Warning::ProfileCoarse]);
}

#[test]
fn support_ends_at_a_twentieth_of_the_shear_modulus() {
    let [rail, wheel] = ["uic60", "s1002"].map(manchester::profile);
    let pair = steel(0.46);
    let scene = Scene { strips: StripCount::Eight, ..scene(&rail, &wheel, &pair) };
    let mut memory = zeroed::<Workspace<f64>>();
    // warning and largest peak pressure over the shear modulus
    let mut under = |load: f64| {
        let (_, warning) =
            scene.height_for_load(&Position::default(), load, None, &mut memory).unwrap();
        let peaks = memory.found().iter().map(|contact| contact.patch.view().unwrap());
        let peaks = peaks.map(|view| view.strips().iter().map(|strip| strip.peak_pressure));
        let peak = peaks.flatten().fold(0.0, f64::max);
        (warning, peak / pair.shear_modulus)
    };
    let ends = [1e3, 1e6];
    assert_eq!(ends.map(|load| under(load).0), [Warning::None, Warning::Support]);
    let ends = bisect(ends, 1.0, |load| under(load).0 == Warning::None);
    let [below, above] = ends.map(|load| under(load).1);
    assert!(below <= 0.05 && above > 0.05 && above < 1.01 * below, "{below} {above}");
}
