//! Contacts of a wheel: one count, that of the contacts that are listed, and their loads add up to
//! the load of the wheel.

use crate::prelude::*;
use kstrip::wheel_rail::touch::GapSearch;

/// Every rail of `tests/data/wheel_rail` with the turn that it has there, and every wheel.
pub(crate) const RAILS: [(&str, f64); 7] = [
    ("uic60", 0.025),
    ("rail288", 0.0),
    ("avgHR", 0.0),
    ("siteb", 0.025),
    ("wornhm", 0.0),
    ("avglow", 0.0),
    ("en_rail", 0.0),
];
pub(crate) const WHEELS: [&str; 7] =
    ["s1002", "whl288", "avgwhl", "car7216", "wornhm", "en_wheel_a", "en_wheel_h"];

/// The vertical position at which the undeformed surfaces touch.
fn first_touch(scene: &Scene<f64>, lateral: f64, memory: &mut Workspace<f64>) -> Option<f64> {
    let mut position = placed([lateral, 0.0, 0.0, 0.0]);
    for _ in 0..8 {
        let radius = scene.pair.wheel_radius;
        let search = GapSearch::new(scene.rail, scene.wheel, radius, &position).ok()?;
        let least = search.gap(0.02, &mut memory.gap).ok()?;
        position.vertical += least;
    }
    Some(position.vertical)
}

/// Asserts that a wheel lists as many contacts as it counts, and that they carry its load. Returns
/// whether some of them are weighted.
fn contacts_carry_the_load(wrench: &Wrench<f64>, memory: &Workspace<f64>) -> bool {
    let listed = memory.found();
    assert_eq!(wrench.contacts as usize, listed.len());
    assert_eq!(wrench.contacts, memory.count);
    let load: f64 = listed.iter().map(|contact| contact.share * contact.normal_force).sum();
    assert_relative_eq!(load, wrench.normal_force, max_relative = 1e-12);
    listed.iter().any(|contact| contact.share < 1.0)
}

#[test]
fn listed_contacts_carry_the_load_of_every_pair() {
    let pair = steel(0.46);
    let mut memory = zeroed::<Workspace<f64>>();
    let [mut solved, mut weighted] = [0; 2];
    for (rail, turn) in RAILS {
        let rail = profile(rail, turn);
        for wheel in WHEELS {
            let wheel = profile(wheel, 0.0);
            let scene = Scene { strips: StripCount::Four, ..scene(&rail, &wheel, &pair) };
            for k in 0..80 {
                let lateral = -20e-3 + 0.3e-3 * f64::from(k);
                let Some(touches) = first_touch(&scene, lateral, &mut memory) else { continue };
                let position = placed([lateral, touches + 0.15e-3, 0.0, 0.0]);
                let state = BodyState { position, velocity: ROLLING };
                let Ok(wrench) = scene.solve(&state, &mut memory) else { continue };
                solved += 1;
                weighted += i32::from(contacts_carry_the_load(&wrench, &memory));
            }
        }
    }
    println!("{solved} positions, {weighted} of them with weighted contacts");
    assert!(solved > 2400 && weighted > 1, "{solved} {weighted}");
}

/// A wheelset counts the contacts of both wheels.
#[test]
fn a_wheelset_counts_the_contacts_of_both_wheels() {
    let (rail, wheel) = (profile("en_rail", 0.0), profile("s1002", 0.0));
    let (right, left) = (steel(0.46), WheelPair { left: 1, ..steel(0.46) });
    let (scenes, motion) = ([&right, &left].map(|pair| scene(&rail, &wheel, pair)), NOTHING);
    let side = |arm: f64, origin: f64, rail: usize| Side { arm, origin, excess: 0.0, rail, motion };
    let sides = [side(0.75, 0.75, 6), side(-0.75, -0.75, 8)];
    let wheelset = Wheelset { scenes, sides };
    let mut memory = zeroed::<WheelsetWorkspace<f64>>();
    let mut most = 0;
    for k in 0..8 {
        let start = placed([1e-3 * f64::from(k), 0.0, 0.0, 0.0]);
        let start = BodyState { position: start, velocity: ROLLING };
        let loads = WheelsetLoads { vertical: 160e3, roll: 0.0, pitch: 0.0 };
        let Ok(settled) = wheelset.settle(&start, &loads, &mut memory) else { continue };
        let forces = wheelset.solve(&settled.state, &mut memory).unwrap();
        for (wrench, memory) in forces.wheel.iter().zip(&memory.wheel) {
            contacts_carry_the_load(wrench, memory);
        }
        let [right, left] = forces.wheel.map(|wrench| wrench.contacts);
        assert_eq!(forces.wrench.contacts, right + left);
        most = most.max(right + left);
    }
    assert!(most > 2, "{most}");
}

const NOTHING: RailMotion<f64> =
    RailMotion { lateral: 0.0, vertical: 0.0, lateral_velocity: 0.0, vertical_velocity: 0.0 };
