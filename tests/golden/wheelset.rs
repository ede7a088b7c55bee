//! The same bits of wheelsets, settled ones included, of fits, and of layers on rollers:
//! `tests/data/golden_wheelset.txt`, written like the others. Derivatives with respect to position
//! are in lines of their own, and so are settles, which use them.

use crate::bits::{Bits, Hash, compare, law};
use crate::wheel::Stand;
use kstrip::wheelset::forces::{WheelsetByPosition, WheelsetDerivatives, WheelsetForces};
use kstrip_testing::prelude::*;
use kstrip_testing::single::converted;

/// Name; shift, vertical, yaw and roll of the wheelset; excess of the right wheel's radius over the
/// mean; radius of the rollers, 0: rails.
type Case = (&'static str, [f64; 4], f64, f64);

const CASES: [Case; 5] = [
    ("middle", [0.5e-3, 0.15e-3, 1e-3, 0.0], 0.0, 0.0),
    ("unequal wheels", [-1e-3, 0.2e-3, -2e-3, 1e-5], 40e-6, 0.0),
    ("flange", [6.3e-3, -0.1e-3, 4e-3, -2e-4], 0.0, 0.0),
    ("lifted wheel", [1e-3, 0.0, 2e-3, 6e-4], 0.0, 0.0),
    ("rollers", [1e-3, 0.2e-3, -3e-3, 1e-5], -30e-6, 0.5),
];

fn add_forces<F: Bits>(hash: &mut Hash, found: &WheelsetForces<F>) {
    hash.members(&found.wrench);
    found.wheel.iter().for_each(|wheel| hash.members(wheel));
    found.rail.iter().for_each(|rail| hash.add(rail));
}

struct Two<F> {
    stand: Stand<F>,
    pairs: [WheelPair<F>; 2],
    memory: Box<WheelsetWorkspace<F>>,
}

impl<F: Bits> Two<F> {
    fn new(excess: f64, rail_radius: f64, friction: f64) -> Self {
        let stand = Stand::<F>::new(("uic60", "s1002", 0.0));
        let pairs = [(1.0, 0), (-1.0, 1)].map(|(sign, left)| {
            let mut pair = stand.pair;
            (pair.left, pair.friction) = (left, F::of(friction));
            pair.wheel_radius = F::of(0.46 + sign * excess);
            pair.rail_radius = F::of(rail_radius);
            pair.rail_speed = F::of(if rail_radius > 0.0 { 15.0 } else { 0.0 });
            pair.normal_damping = F::of(0.1);
            pair
        });
        Self { stand, pairs, memory: zeroed() }
    }

    fn wheelset<'a>(
        &'a self, excess: f64, falling: Option<&'a SlipFriction<F>>,
    ) -> Wheelset<'a, F> {
        let law = Law { model: Model::Strip, falling };
        let Stand { rail, wheel, .. } = &self.stand;
        let of = |pair| Scene { rail, wheel, pair, strips: StripCount::Sixteen, law, table: None };
        let [right, left] = &self.pairs;
        let motion = [0.1e-3, 20e-6, 1e-3, -2e-3].map(F::of);
        let [lateral, vertical, lateral_velocity, vertical_velocity] = motion;
        let side = |sign: f64, rail: usize| Side {
            arm: F::of(sign * 0.75),
            origin: F::of(sign * 0.760_532_5),
            excess: F::of(sign * excess),
            rail,
            motion: RailMotion { lateral, vertical, lateral_velocity, vertical_velocity },
        };
        Wheelset { scenes: [of(right), of(left)], sides: [side(1.0, 6), side(-1.0, 8)] }
    }
}

fn velocity<F: Bits>(forward: f64) -> Velocity<F> {
    let rates = [forward, 0.02, 1e-3, 2e-3, -15.0 / 0.46, 4e-3].map(F::of);
    let [forward, lateral, vertical, roll, pitch, yaw] = rates;
    Velocity { forward, lateral, vertical, roll, pitch, yaw }
}

/// Forces and derivatives with respect to velocity; and those with respect to position.
fn hash_wheelset<F: Bits>([hash, by_place]: [&mut Hash; 2], case: Case, with_law: bool) {
    let (_, place, excess, rail_radius) = case;
    let soft = SlipFriction { layer: F::of(3e-14), ..law([0.35, 0.4, 0.6, 1.0, 1.0].map(F::of)) };
    let mut two = Two::<F>::new(excess, rail_radius, 0.3);
    let mut memory = std::mem::replace(&mut two.memory, zeroed());
    let [lateral, vertical, yaw, roll] = place.map(F::of);
    let position = Position { lateral, vertical, yaw, roll };
    let velocity = velocity(if rail_radius > 0.0 { 0.0 } else { 15.0 });
    let state = BodyState { position, velocity };
    let mut by_velocity = WheelsetDerivatives::default();
    let mut by_position = WheelsetByPosition::default();
    let wheelset = two.wheelset(excess, with_law.then_some(&soft));
    let found = wheelset.differentiate(
        &state,
        &mut memory,
        Requested { by_velocity: Some(&mut by_velocity), by_position: Some(&mut by_position) },
    );
    if let Some(found) = hash.status(found.map(|found| (found, found.wrench.warning))) {
        add_forces(hash, &found);
        by_velocity.velocity.iter().for_each(|row| hash.add(row));
        hash.add(&by_velocity.friction);
        by_position.position.iter().for_each(|row| by_place.add(row));
    }
}

fn hash_settles<F: Bits>(hash: &mut Hash) {
    for (excess, rail_radius, friction, forward, vertical, roll, pitch) in [
        (0.0, 0.0, 0.3, 15.0, 120e3, 10e3, 500.0),
        (0.0, 0.0, 0.0, 15.0, 80e3, -5e3, 0.0),
        (40e-6, 0.0, 0.1, 0.01, 60e3, 0.0, 0.0),
        (0.0, 0.5, 0.2, 0.0, 100e3, 3e3, -200.0),
        (0.0, 0.0, 0.3, 15.0, 100e3, 0.0, 30e3),
    ] {
        let mut two = Two::<F>::new(excess, rail_radius, friction);
        let mut memory = std::mem::replace(&mut two.memory, zeroed());
        let [lateral, yaw] = [1e-3, 1e-3].map(F::of);
        let position = Position { lateral, yaw, ..Position::default() };
        let start = BodyState { position, velocity: velocity(forward) };
        let [vertical, roll, pitch] = [vertical, roll, pitch].map(F::of);
        let loads = WheelsetLoads { vertical, roll, pitch };
        let found = two.wheelset(excess, None).settle(&start, &loads, &mut memory);
        if let Some(found) = hash.status(found.map(|found| (found, found.warning))) {
            let Position { vertical, roll, .. } = found.state.position;
            hash.add(&[vertical, roll, found.state.velocity.pitch]);
            add_forces(hash, &found.forces);
        }
    }
}

/// Forces of a law at twelve creepages, with an error of two per cent of either sign or without.
fn hash_fits<F: Bits>(hash: &mut Hash) {
    let contact: Contact<F> = converted(&C0);
    let options = sixteen(Model::Strip);
    let own = law([0.3, 0.4, 0.5, 20.0, 0.6].map(F::of));
    for (error, fitted) in [(0.0, [true, true, true, true]), (0.02, [true, false, true, true])] {
        let points: Vec<MeasuredForce<F>> = (1..=12)
            .map(|k| {
                let creepage = creep(F::of(1.5e-3 * f64::from(k)), F::zero(), F::zero());
                let found = differentiate_with_law(&contact, &creepage, Some(&own), &options);
                let sign = if k % 3 == 0 { 1.0 } else { -1.0 };
                let fx = found.expect("forces").solution.fx.times(1.0 + sign * error);
                let Creepage { longitudinal, lateral, spin } = creepage;
                let (fy, weight) = (F::zero(), F::one());
                let (measured, reserved) = (1, 0);
                MeasuredForce { longitudinal, lateral, spin, fx, fy, weight, measured, reserved }
            })
            .collect();
        let [friction, ratio, decay, slope] = fitted;
        let which = [friction, ratio, decay, slope, false, false];
        let found = fit_friction(&contact, &points, &own, which, &options);
        let found = found.map_err(|(_, error)| error).map(|found| (found, found.warning));
        if let Some(found) = hash.status(found) {
            for law in [found.law, found.standard_errors] {
                hash.add(&[law.friction, law.ratio, law.decay, law.slope_factor]);
            }
            hash.add(&[found.residual]);
        }
    }
}

/// Contacts behind a layer, with spin and without, with a slide factor.
fn hash_layers<F: Bits>(hash: &mut Hash) {
    let contact: Contact<F> = converted(&C0);
    for layer in [1e-14, 2e-13] {
        for slide in [0.0, 0.4] {
            let own = law([0.3, 1.0, 0.0, 20.0, 1.0].map(F::of));
            let (layer, slide_factor) = (F::of(layer), F::of(slide));
            let own = SlipFriction { layer, slide_factor, ..own };
            for [x, y, spin] in [[1e-3, 4e-4, 0.4], [2e-3, 0.0, 0.0], [0.0, 3e-3, -0.8]] {
                let creepage = creep(F::of(x), F::of(y), F::of(spin));
                let options = sixteen(Model::Strip);
                hash.derivatives(&differentiate_with_law(
                    &contact,
                    &creepage,
                    Some(&own),
                    &options,
                ));
            }
        }
    }
}

fn hashes<F: Bits>(precision: &str) -> String {
    let mut text = String::new();
    let mut line = |name: &str, hash: Hash| {
        text += &format!("{precision} {name} {:016x}\n", hash.value());
    };
    for case in CASES {
        let [mut forces, mut by_place] = [Hash::START; 2];
        for with_law in [false, true] {
            hash_wheelset::<F>([&mut forces, &mut by_place], case, with_law);
        }
        line(case.0, forces);
        line(&format!("{} with respect to position", case.0), by_place);
    }
    let mut hash = Hash::START;
    hash_settles::<F>(&mut hash);
    line("settles", hash);
    let mut hash = Hash::START;
    hash_fits::<F>(&mut hash);
    line("fits", hash);
    let mut hash = Hash::START;
    hash_layers::<F>(&mut hash);
    line("layers", hash);
    text
}

#[test]
fn wheelsets_and_fits_give_the_golden_bits() {
    compare("golden_wheelset.txt", hashes::<f64>, hashes::<f32>);
}
