//! The same bits of prepared profiles, of wheels on rails, and of the patch of a profile between
//! unlike materials, in both precisions: `tests/data/golden_wheel.txt`, written like the others.

use crate::bits::{Bits, Hash, compare, hash_indentation, law, pressed};
use kstrip_testing::prelude::*;
use kstrip_testing::single::converted;

/// Name; profiles of rail and wheel, and the length over which they are smoothed; lateral position,
/// yaw and roll; load \[N\]; whether the wheel is the left one.
type Case = (&'static str, Pair, [f64; 3], f64, bool);
pub type Pair = (&'static str, &'static str, f64);

const DRAWN: Pair = ("uic60", "s1002", 0.0);
const WORN: Pair = ("rail288", "whl288", 2e-3);
const GROUND: Pair = ("siteb", "s1002", 0.0);
const MEAN: Pair = ("avgHR", "car7216", 1e-3);
/// All of them.
pub const PAIRS: [Pair; 4] = [DRAWN, WORN, GROUND, MEAN];
const CASES: [Case; 15] = [
    ("tread", DRAWN, [-10.5e-3, 0.0, 0.0], 80e3, false),
    ("light contact", DRAWN, [-12e-3, 0.0, 1e-3], 30.0, false),
    ("flange", DRAWN, [-3.5e-3, 4e-3, 0.0], 60e3, false),
    ("fillet", DRAWN, [-4.6e-3, 0.0, 0.0], 60e3, false),
    ("left wheel", DRAWN, [12e-3, -3e-3, 2e-3], 70e3, true),
    ("left light contact", DRAWN, [12e-3, -3e-3, 4e-3], 30.0, true),
    ("left flange", DRAWN, [3e-3, -8e-3, -2e-3], 50e3, true),
    ("yaw", DRAWN, [-9e-3, 0.03, 0.0], 100e3, false),
    ("end of the wheel", DRAWN, [38e-3, 0.0, -0.03], 20e3, false),
    ("two contacts", GROUND, [7.93e-3, 0.0, 0.0], 33.7e3, false),
    ("contacts far apart", MEAN, [-76.92e-3, 2e-3, 0.0], 35e3, false),
    ("worn two contacts", WORN, [-64.99e-3, 0.0, 0.0], 103e3, false),
    ("worn shares", WORN, [-68.2e-3, 0.0, 0.0], 80e3, false),
    ("worn small share", WORN, [-79.5e-3, 1e-3, -0.02], 80e3, false),
    ("worn yaw", WORN, [-60e-3, 0.01, 0.0], 75e3, false),
];

/// A rail, a wheel, and memory.
pub struct Stand<F> {
    pub rail: Box<PreparedProfile<F>>,
    pub wheel: Box<PreparedProfile<F>>,
    pub pair: WheelPair<F>,
    pub memory: Box<Workspace<F>>,
}

fn surface<F: Bits>(name: &str, smoothing_length: f64) -> Box<PreparedProfile<F>> {
    let [y, z] = points(name).map(|list| list.into_iter().map(F::of).collect::<Vec<_>>());
    let mut surface = zeroed::<PreparedProfile<F>>();
    surface.prepare(&y, &z, F::zero(), F::of(smoothing_length)).expect("a profile");
    surface
}

pub fn hash_surface<F: Bits>(hash: &mut Hash, surface: &PreparedProfile<F>) {
    let PreparedProfile { y, z, cosine, sine, step, count, .. } = surface;
    let count = *count as usize;
    hash.mix(count as u64);
    hash.add(&[*step]);
    [y, z, cosine, sine].into_iter().for_each(|list| hash.add(&list[..count]));
}

impl<F: Bits> Stand<F> {
    pub fn new((rail, wheel, smoothing_length): Pair) -> Self {
        let places = [-0.02, -0.005, 0.01, 0.03].map(F::of);
        let pair = WheelPair {
            wheel_radius: F::of(0.46),
            shear_modulus: F::of(82e9),
            poisson_ratio: F::of(0.28),
            friction: F::of(0.3),
            friction_y: places,
            friction_at: [0.2, 0.3, 0.4, 0.1].map(F::of),
            smoothing_length: F::of(smoothing_length),
            ..*zeroed()
        };
        let [rail, wheel] = [rail, wheel].map(|name| surface(name, smoothing_length));
        Self { rail, wheel, pair, memory: zeroed() }
    }

    /// The height for the load, and at it forces, their derivatives and the contacts; the same of
    /// a slower wheel with less and more depth, with friction that falls, and between unlike
    /// materials.
    fn hash(&mut self, hash: &mut Hash, (_, _, place, load, is_left): Case) {
        let Self { rail, wheel, pair, memory } = self;
        (pair.left, pair.friction_points) = (i32::from(is_left), 0);
        let [lateral, yaw, roll] = place.map(F::of);
        let position = Position { lateral, vertical: F::zero(), yaw, roll };
        let velocity = |size: f64| {
            let rates = [20.0, 0.03, 1e-3, 2e-3, -43.4, -4e-3].map(|rate| F::of(rate * size));
            let [forward, lateral, vertical, roll, pitch, yaw] = rates;
            Velocity { forward, lateral, vertical, roll, pitch, yaw }
        };
        let falling = law([1.0, 0.4, 0.6, 1.0, 0.7].map(F::of));
        let scene = |pair, model, falling| {
            let law = Law { model, falling };
            Scene { rail, wheel, pair, strips: StripCount::Sixteen, law, table: None }
        };
        let strip = scene(pair, Model::Strip, None);
        let found = strip.height_for_load(&position, F::of(load), None, memory);
        let Some(vertical) = hash.status(found) else { return };
        hash.add(&[vertical]);
        let rolls = velocity(1.0);
        let carried = strip.height_for_load(&position, F::of(load), Some(&rolls), memory);
        hash.status(carried).into_iter().for_each(|height| hash.add(&[height]));
        let position = Position { vertical, ..position };
        let mut by_velocity = WrenchDerivatives::default();
        let mut by_position = WrenchByPosition::default();
        let found = strip.differentiate(
            &BodyState { position, velocity: rolls },
            memory,
            Requested { by_velocity: Some(&mut by_velocity), by_position: Some(&mut by_position) },
        );
        if hash.wrench(found) {
            hash_slopes(hash, &by_velocity);
            let WrenchByPosition { lateral, vertical, yaw, roll } = by_position;
            [lateral, vertical, yaw, roll].iter().for_each(|slopes| hash.add(slopes));
            hash_contacts(hash, memory);
        }
        // unlike materials, forward, backward and nearly at rest
        let mut contacts = memory.found().to_vec();
        contacts.iter_mut().for_each(|contact| contact.patch.mismatch = F::of(0.15));
        for speed in [1.0, -0.7, 1e-4] {
            let mut slopes = WrenchDerivatives::default();
            let law = Law { model: Model::Strip, falling: Some(&falling) };
            let found = of_contacts(&contacts, &velocity(speed), law, Some(&mut slopes));
            if hash.wrench(found) {
                hash_slopes(hash, &slopes);
            }
        }
        let places = WheelPair { friction_points: 4, ..*pair };
        let depth = F::of(20e-6);
        for (model, deeper) in [(Model::Strip, depth), (Model::Total, -depth)] {
            let position = Position { vertical: vertical + deeper, ..position };
            let found = scene(&places, model, Some(&falling))
                .solve(&BodyState { position, velocity: velocity(0.02) }, memory);
            if hash.wrench(found) {
                hash_contacts(hash, memory);
            }
        }
    }
}

fn hash_slopes<F: Bits>(hash: &mut Hash, slopes: &WrenchDerivatives<F>) {
    slopes.velocity.iter().for_each(|row| hash.add(row));
    hash.add(&slopes.friction);
}

pub fn hash_contacts<F: Bits>(hash: &mut Hash, memory: &Workspace<F>) {
    hash.mix(u64::from(memory.gap.count));
    for contact in memory.found() {
        let [x, y, z] = contact.origin;
        hash.add(&[x, y, z, contact.angle, contact.angle_range, contact.radius]);
        hash.add(&[contact.normal_force, contact.share, contact.approach, contact.stiffness]);
        hash.add(&[contact.along]);
        let rows = [contact.normal, contact.slip_x, contact.slip_y, contact.spin_rate];
        rows.iter().chain([&contact.rolling_speed]).for_each(|row| hash.add(row));
        for s in contact.patch.used() {
            hash.add(&[s.y, s.width, s.half_length, s.centre_x, s.peak_pressure, s.friction]);
        }
    }
}

/// Creepages of patches and ellipses.
const MOTIONS: [[f64; 3]; 3] = [[1e-3, 4e-4, 0.1], [-2e-4, 0.0, 0.5], [0.0; 3]];

/// A patch of a profile with two zones between unlike materials: by load and by approach, with
/// friction that falls and without.
fn hash_profile<F: Bits>(hash: &mut Hash) {
    let y: Vec<F> = (0..61).map(|n| F::of(f64::from(n - 30) * 4e-4)).collect();
    let distance = y.iter().map(|y| {
        let y = y.to_f64() * 1e3;
        F::of((y * y * (y - 4.0) * (y - 4.0) / 900.0 + 0.02 * (y + 12.0)) * 1e-3 / 12.0)
    });
    let distance: Vec<F> = distance.collect();
    let radii: Vec<F> = (0..61).map(|n| F::of(0.4 + f64::from(n) * 2e-3)).collect();
    let centre: Vec<F> = (0..61).map(|n| F::of(f64::from(n) * 2e-5)).collect();
    let profile = Profile::new(&y, &distance).expect("a profile");
    let skewed = profile.with_centre_x(&centre).and_then(|own| own.with_rolling_radius(&radii));
    let waves: Vec<F> = y
        .iter()
        .map(|y| {
            // (a wave of triangles: no library's cosine)
            let y = y.to_f64();
            F::of(y * y / 0.6 + 4e-6 * ((y / 2.3e-3).rem_euclid(1.0) - 0.5).abs())
        })
        .collect();
    let waves = Profile::new(&y, &waves).expect("a profile");
    let many = StripCount::ThirtyTwo;
    let skewed = skewed.expect("a profile");
    let profiles = [(profile, many), (skewed, many), (waves, many), (waves, StripCount::Four)];
    for (profile, count) in profiles {
        for given in
            [Given::Load(F::of(90e3)), Given::Load(F::of(300.0)), Given::Approach(F::of(60e-6))]
        {
            let smoothing = if count == many { 0.0 } else { 5e-4 };
            let contact = pressed(given, [0.45, 40e9, 0.3, 0.35, smoothing].map(F::of));
            let built = Patch::<F>::from_profile(&profile, &contact, count);
            let built = built.map(|(patch, found)| ((patch, found), found.warning));
            let Some((mut patch, found)) = hash.status(built) else { continue };
            hash_indentation(hash, &found);
            patch.mismatch = F::of(-0.2);
            let Some(view) = hash.status(patch.view().map(|view| (view, Warning::None))) else {
                continue;
            };
            let law = law([1.0, 0.3, 0.8, 20.0, 0.8].map(F::of));
            for creepage in MOTIONS {
                let [x, y, spin] = creepage.map(F::of);
                let creepage = creep(x, y, spin);
                for law in [None, Some(&law)] {
                    let found =
                        patch_friction::differentiate_patch(&view, &creepage, law, Model::Strip);
                    hash.derivatives(&found);
                }
            }
        }
    }
}

/// Ellipses of unlike materials: forces and derivatives, with friction that falls and without.
fn hash_ellipses<F: Bits>(hash: &mut Hash) {
    let law = law([0.4, 0.3, 0.8, 20.0, 0.8].map(F::of));
    for model in [Model::Strip, Model::Total, Model::Linear] {
        for (axis_ratio, mismatch) in [(0.3, 0.2), (1.0, -0.1), (4.0, 0.25)] {
            let (a, b, shear_modulus, poisson_ratio) = (5e-3 * axis_ratio, 5e-3, 40e9, 0.3);
            let contact = Contact { a, b, shear_modulus, poisson_ratio, mismatch, ..C0 };
            let contact = Contact { mismatch: F::of(mismatch), ..converted(&contact) };
            for creepage in MOTIONS {
                let [x, y, spin] = creepage.map(F::of);
                let creepage = creep(x, y, spin);
                let options = sixteen(model);
                for law in [None, Some(&law)] {
                    hash.derivatives(&differentiate_with_law(&contact, &creepage, law, &options));
                }
            }
        }
    }
}

fn hashes<F: Bits>(precision: &str) -> String {
    let mut text = String::new();
    let mut line = |name: &str, hash: Hash| {
        text += &format!("{precision} {name} {:016x}\n", hash.value());
    };
    let mut hash = Hash::START;
    for pair in PAIRS {
        let Stand { rail, wheel, .. } = Stand::<F>::new(pair);
        hash_surface(&mut hash, &rail);
        hash_surface(&mut hash, &wheel);
    }
    line("surfaces", hash);
    for case in CASES {
        let mut hash = Hash::START;
        Stand::<F>::new(case.1).hash(&mut hash, case);
        line(case.0, hash);
    }
    let mut hash = Hash::START;
    hash_profile::<F>(&mut hash);
    line("patch of a profile with mismatch", hash);
    let mut hash = Hash::START;
    hash_ellipses::<F>(&mut hash);
    line("ellipses with mismatch", hash);
    text
}

#[test]
fn wheels_and_profiles_give_the_golden_bits() {
    compare("golden_wheel.txt", hashes::<f64>, hashes::<f32>);
}
