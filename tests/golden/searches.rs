//! The same bits of what searches find, and how many steps they take: Hertz's axis ratio, friction
//! and creepage for a force, fits, zones that have just begun, wheels, wheelsets in balance, and
//! profiles that scatter or are scanned twice. All inputs are quotients of whole numbers drawn at
//! random.

use crate::bits::{Bits, Hash, compare, draw, hash_indentation, inputs, law, part, pressed};
use crate::wheel::{PAIRS, Stand, hash_contacts, hash_surface};
use kstrip::friction::solve_with_law;
use kstrip::wheel_rail::contacts::from_gap;
use kstrip_testing::prelude::*;
use kstrip_testing::single::{converted, converted_motion};

/// A number from -1 to 1 in thousandths.
pub fn swing(i: u32, salt: u32) -> f64 {
    f64::from(draw(i, salt, 2001)) / 1000.0 - 1.0
}

/// One of three sizes, each a power of ten, times 1 to 9.
fn size(i: u32, salt: u32, powers: [f64; 3]) -> f64 {
    f64::from(1 + draw(i, salt, 9)) * powers[draw(i, salt + 1, 3) as usize]
}

/// Ellipses of bodies, nearly round ones, and needles.
fn hash_hertz<F: Bits>(hash: &mut Hash) {
    for i in 0..400 {
        let of = |salt| size(i, salt, [1e-3, 0.1, 10.0]);
        let [lower_x, lower_y, upper_x] = [of(1), of(3), of(5)];
        let round = 1.0 + size(i, 7, [1e-6, 1e-4, 1e-2]);
        let upper_y = if i % 4 == 0 { upper_x * round } else { of(9) };
        let lower_y = if i % 4 == 0 { lower_x } else { lower_y };
        let radii = radii([lower_x, lower_y, upper_x, upper_y].map(F::of));
        let pair = CombinedMaterial {
            shear_modulus: F::of(82e9),
            poisson_ratio: part(draw(i, 11, 50), 100.0),
            mismatch: F::zero(),
        };
        let load = F::of(size(i, 12, [1.0, 100.0, 1e4]));
        let found = from_hertz(&radii, &pair, load, F::of(0.3));
        let found = found.map(|(contact, ellipse, warning)| ((contact, ellipse), warning));
        let Some((contact, ellipse)) = hash.status(found) else { continue };
        hash.add(&[contact.a, contact.b, ellipse.peak_pressure, ellipse.approach]);
        hash.add(&[ellipse.axis_ratio, ellipse.hertz_angle, ellipse.rho]);
        let found = from_approach(&radii, &pair, ellipse.approach, F::of(0.3));
        let found = found.map(|(contact, stiffness, warning)| ((contact, stiffness), warning));
        if let Some((contact, stiffness)) = hash.status(found) {
            hash.add(&[contact.a, contact.b, contact.normal_force, stiffness]);
        }
    }
}

/// Frictions and creepages for a force, with the number of solutions; half of the motions have a
/// spin that opposes the lateral creepage, so that several frictions fit.
fn hash_rigs<F: Bits>(hash: &mut Hash) {
    for i in 0..2000 {
        let (contact, mut creepage, options) = inputs(i);
        if i % 2 == 0 {
            // (of the unit of slip, 2 μ p₀/G, with p₀ about N/(2 a b))
            let Contact { a, b, normal_force, shear_modulus, friction, .. } = contact;
            let unit = friction * normal_force / (a * b * shear_modulus);
            let of = |salt| f64::from(1 + draw(i, salt, 40)) / 10.0 * unit;
            let longitudinal = [0.0, 0.1, 1.0][draw(i, 24, 3) as usize] * of(21);
            creepage = creep(longitudinal, of(22), -of(23) / a);
        }
        let contact: Contact<F> = converted(&contact);
        let creepage: Creepage<F> = converted_motion(&creepage);
        let Ok(made) = forces::forces_of_contact(&contact, &creepage, &options) else { continue };
        for (measured, force) in [
            (Measured::Fx, [made.fx, F::zero()]),
            (Measured::Fy, [F::zero(), made.fy]),
            (Measured::Both, [made.fx, made.fy]),
        ] {
            let found = estimate_counted(&contact, &creepage, &options, measured, force);
            let found = found.map(|(used, found, count)| ((used, found, count), found.warning));
            if let Some((used, found, count)) = hash.status(found) {
                hash.add(&[used, found.friction, found.sensitivity, found.residual]);
                hash.mix(count as u64);
            }
        }
        for share in [0.2, 0.9, 1.0] {
            let force = [made.fx, made.fy].map(|force| force * F::of(share));
            let found = creepage_counted(&contact, force, creepage.spin, &options);
            let found = found.map(|found| (found, Warning::None));
            if let Some((motion, distance, count)) = hash.status(found) {
                hash.add(&[motion.longitudinal, motion.lateral, distance]);
                hash.mix(count as u64);
            }
        }
    }
}

/// Loads between which one friction becomes three and one again, of laws that fall.
fn hash_folds<F: Bits>(hash: &mut Hash) {
    for i in 0..120 {
        // (the numbers of one such contact, and others near it)
        let near = |size: f64, salt| F::of(size * (1.0 + 0.02 * swing(i, salt) * f64::from(i % 3)));
        let contact = Contact {
            a: near(1.895_987_803_9e-3, 1),
            b: near(12.213_934_758e-3, 2),
            normal_force: F::of(3780.0 + f64::from(i) * 0.5),
            ..converted(&C0)
        };
        let (friction, decay) = (near(0.270_816_316_4, 3), near(3.110_822_057, 4));
        let law = law([friction, F::of(0.313_705_792_6), decay, F::of(14.0), F::zero()]);
        let creepage = creep(near(-2.592_569e-3, 5), near(-8.262_624e-3, 6), near(-0.888_384, 7));
        let model = [Model::Total, Model::Total, Model::Strip][i as usize % 3];
        let options = Options { model, strips: StripCount::Eight };
        let found = solve_with_law(&contact, &creepage, &law, &options);
        let found = found.map(|found| (found, found.solution.warning));
        let Some(found) = hash.status(found) else { continue };
        hash.add(&[found.friction, found.solution.fx, found.solution.fy]);
    }
}

/// Contacts behind a layer, with rates of bristles up to those that slide and beyond.
fn hash_layers<F: Bits>(hash: &mut Hash) {
    for i in 0..200 {
        let (contact, _, options) = inputs(i);
        let contact: Contact<F> = converted(&contact);
        let [longitudinal, lateral, spin] =
            [1, 3, 5].map(|salt| F::of(size(i, salt, [1e-3, 1.0, 1e3]) * swing(i, salt + 30)));
        let law = SlipFriction {
            layer: F::of(size(i, 7, [1e-16, 1e-14, 1e-12])),
            slide_factor: if i % 2 == 0 { F::one() } else { F::zero() },
            ..SlipFriction::of_constant(F::of(0.3))
        };
        let creepage = Creepage { longitudinal, lateral, spin };
        hash.derivatives(&differentiate_with_law(&contact, &creepage, Some(&law), &options));
    }
}

/// Laws that are fitted to points that scatter.
fn hash_fits<F: Bits>(hash: &mut Hash) {
    let contact = Contact { a: 6.3e-3, b: 12.6e-3, normal_force: 106.7e3, friction: 0.33, ..C0 };
    let contact = converted(&contact);
    for i in 0..24 {
        let points: Vec<_> = (0..10)
            .map(|n| {
                // a curve that rises, and falls a little
                let c = f64::from(n + 1) * f64::from(n + 1);
                let rise = c / (c + f64::from(1 + draw(i, 1, 30))) * (1.0 - c / 800.0);
                let scatter = f64::from(draw(i, 2, 8)) / 100.0 * swing(i, 10 + n);
                let (at, fx) = (F::of(c * 5e-4), F::of(106.7e3 * 0.35 * (rise + scatter)));
                let weight = part(1 + draw(i, 30 + n, 3), 2.0);
                let at = creep(at, F::zero(), F::zero());
                MeasuredForce { weight, ..measured_force(at, [fx, F::zero()], 1) }
            })
            .collect();
        let start = law([0.0, 0.5, 0.3, 10.0, 0.5].map(F::of));
        let fitted = [0, 1, 2, 3, 4, 5].map(|k| k == 0 || draw(i, 50 + k, 2) == 1);
        let model = if i % 3 == 0 { Model::Strip } else { Model::Total };
        let options = Options { model, strips: StripCount::Eight };
        let found = fit_friction(&contact, &points, &start, fitted, &options);
        let found = found.map(|found| (found, found.warning)).map_err(|(_, error)| error);
        let Some(found) = hash.status(found) else { continue };
        for of in [&found.law, &found.standard_errors] {
            let SlipFriction { friction, ratio, decay, slope_factor, slide_factor, layer, .. } = of;
            hash.add(&[*friction, *ratio, *decay, *slope_factor, *slide_factor, *layer]);
        }
        hash.add(&[found.residual]);
        hash.mix(u64::from(found.steps));
    }
}

/// Patches with a second and a third zone that have begun by some micrometres or by much less,
/// near the first or far from it.
fn hash_young_zones<F: Bits>(hash: &mut Hash) {
    for i in 0..40 {
        // (a fifth of the profiles have many points)
        let (count, step) = if i % 5 == 0 { (1601, 1.25e-5) } else { (81, 2.5e-4) };
        let y: Vec<f64> =
            (0..count).map(|n| (f64::from(n) - f64::from(count / 2)) * step).collect();
        let apart =
            [1, 2].map(|k| f64::from(12 + draw(i, k, 80)) * 1e-4 * [-1.0, 1.0][k as usize - 1]);
        let overlap = F::of(f64::from(10 + draw(i, 3, 60)) * 1e-6);
        let [one, two] = [4, 6].map(|salt| size(i, salt, [1e-13, 1e-9, 1e-6]));
        let distance: Vec<f64> = y
            .iter()
            .map(|y| {
                let dip = |place: f64, depth: f64| {
                    (y - place) * (y - place) / 0.05 + overlap.to_f64() - depth
                };
                let main = y * y / 0.5;
                main.min(dip(apart[0], one)).min(dip(apart[1], two))
            })
            .collect();
        let [y, distance] =
            [y, distance].map(|list| list.into_iter().map(F::of).collect::<Vec<_>>());
        let Ok(profile) = Profile::new(&y, &distance) else { continue };
        for given in [Given::Approach(overlap), Given::Load(F::of(size(i, 8, [10.0, 1e3, 1e4])))] {
            let smoothing = [0.0, 2e-5, 3e-4, 1e-3][draw(i, 10, 4) as usize];
            let contact = pressed(given, [0.45, 82e9, 0.28, 0.3, smoothing].map(F::of));
            let strips = [StripCount::Four, StripCount::Eight, StripCount::Sixteen];
            let built =
                Patch::<F>::from_profile(&profile, &contact, strips[draw(i, 11, 3) as usize]);
            let built = built.map(|(patch, found)| ((patch, found), found.warning));
            let Some((patch, found)) = hash.status(built) else { continue };
            hash_indentation(hash, &found);
            for s in patch.used() {
                hash.add(&[s.y, s.width, s.half_length, s.centre_x, s.peak_pressure]);
            }
        }
    }
}

/// Ellipses cut in two, with gaps up to three strips wide.
fn hash_gaps<F: Bits>(hash: &mut Hash) {
    for i in 0..120 {
        let contact: Contact<F> = converted(&C0);
        let mut patch = Patch::from_ellipse(&contact, StripCount::Sixteen).expect("a patch");
        let gap = patch.strips[8].width * F::of(f64::from(i) / 40.0);
        let cut = patch.strips.iter_mut().skip(5 + draw(i, 1, 7) as usize);
        cut.for_each(|strip| strip.y += gap);
        let creepage = creep(F::of(2e-3 * swing(i, 2)), F::of(2e-3 * swing(i, 3)), F::of(0.3));
        let view = patch.view().expect("a patch");
        for model in [Model::Strip, Model::Total] {
            hash.derivatives(&patch_friction::differentiate_patch(&view, &creepage, None, model));
        }
    }
}

pub fn velocity<F: Bits>(i: u32) -> Velocity<F> {
    let rates = [20.0, 0.2, 0.02, 0.02, 0.5, 0.02];
    let [forward, lateral, vertical, roll, pitch, yaw] =
        [0, 1, 2, 3, 4, 5].map(|k| F::of(rates[k as usize] * swing(i, 20 + k)));
    Velocity { forward, lateral, vertical, roll, pitch: pitch - forward / F::of(0.46), yaw }
}

/// Wheels anywhere on rails, with derivatives of a few.
fn hash_wheels<F: Bits>(hash: &mut Hash) {
    let mut stands = PAIRS.map(Stand::<F>::new);
    for i in 0..360 {
        let Stand { rail, wheel, pair, memory } = &mut stands[i as usize % 4];
        let from = [-10e-3, -70e-3, 0.0, -77e-3][i as usize % 4];
        let pair = WheelPair {
            left: 0,
            normal_damping: F::of(0.1) * part(draw(i, 1, 3), 1.0),
            floor_speed: F::of(1e-3) * part(draw(i, 2, 3), 1.0),
            rail_radius: if i % 6 == 5 { F::of(1.5) } else { F::zero() },
            ..*pair
        };
        let law = Law { model: Model::Strip, falling: None };
        let scene = Scene { rail, wheel, pair: &pair, strips: StripCount::Eight, law, table: None };
        let place = [from + 9e-3 * swing(i, 3), 0.0, 0.02 * swing(i, 4), 0.01 * swing(i, 5)];
        let [lateral, vertical, yaw, roll] = place.map(F::of);
        let place = Position { lateral, vertical, yaw, roll };
        let load = F::of(size(i, 6, [1.0, 1e3, 1e4]));
        let found = scene.height_for_load(&place, load, None, memory);
        let Some(vertical) = hash.status(found) else { continue };
        hash.add(&[vertical]);
        // (much deeper as well)
        for deeper in [0.3e-3, 2e-3, 6e-3] {
            let position = Position { vertical: vertical + F::of(deeper), ..place };
            let found = scene.solve(&BodyState { position, velocity: Velocity::default() }, memory);
            if hash.wrench(found) {
                hash_contacts(hash, memory);
            }
        }
        if i % 15 > 0 {
            continue;
        }
        // (a gap that does not say how far its points are apart)
        let Workspace { gap, strips, contacts, .. } = &mut **memory;
        gap.step = F::zero();
        let found = from_gap(gap, &pair, &place, StripCount::Eight, strips, contacts);
        if let Some(count) = hash.status(found.map(|found| (found.written, found.warning))) {
            let listed = contacts.iter().take(count);
            listed.for_each(|own| hash.add(&[own.normal_force, own.approach, own.stiffness]));
        }
        // (TOTAL on every second of them)
        let model = if i % 2 == 0 { Model::Strip } else { Model::Total };
        let scene = Scene { law: Law { model, falling: None }, ..scene };
        let position = Position { vertical, ..place };
        let mut by_velocity = WrenchDerivatives::default();
        let mut by_position = WrenchByPosition::default();
        let rolls = velocity(i);
        let found = scene.differentiate(
            &BodyState { position, velocity: rolls },
            memory,
            Requested { by_velocity: Some(&mut by_velocity), by_position: Some(&mut by_position) },
        );
        if hash.wrench(found) {
            by_velocity.velocity.iter().for_each(|row| hash.add(row));
            let WrenchByPosition { lateral, vertical, yaw, roll } = by_position;
            [lateral, vertical, yaw, roll].iter().for_each(|slopes| hash.add(slopes));
        }
    }
}

/// Wheelsets in balance, whose loads lie aside and drive.
fn hash_wheelsets<F: Bits>(hash: &mut Hash) {
    let Stand { rail, wheel, pair, .. } = Stand::<F>::new(PAIRS[0]);
    let mut memory = zeroed::<WheelsetWorkspace<F>>();
    let pairs = [pair, WheelPair { left: 1, ..pair }];
    let law = Law { model: Model::Strip, falling: None };
    for i in 0..32 {
        let strips = StripCount::Eight;
        let scenes = [0, 1].map(|k| Scene {
            rail: &rail,
            wheel: &wheel,
            pair: &pairs[k],
            strips,
            law,
            table: None,
        });
        let still = RailMotion::default();
        let sides = [(1.0, 6), (-1.0, 8)].map(|(sign, rail)| Side {
            arm: F::of(sign * 0.75),
            origin: F::of(sign * 0.760_532_5),
            excess: F::zero(),
            rail,
            motion: still,
        });
        let spread = [7e-3, 1e-3, 0.01, 2e-3].into_iter().zip(1..);
        let mut spread = spread.map(|(size, salt)| F::of(size * swing(i, salt)));
        let [lateral, vertical, yaw, roll] = [0; 4].map(|_| spread.next().expect("four"));
        let start = Position { lateral, vertical, yaw, roll };
        let loads = [100e3, 60e3 * swing(i, 5), 8e3 * swing(i, 6)].map(F::of);
        let [vertical, roll, pitch] = loads;
        let loads = WheelsetLoads { vertical, roll, pitch };
        let found = Wheelset { scenes, sides }.settle(
            &BodyState { position: start, velocity: velocity(i) },
            &loads,
            &mut memory,
        );
        let Some(found) = hash.status(found.map(|found| (found, found.warning))) else { continue };
        let Position { vertical, roll, .. } = found.state.position;
        hash.add(&[vertical, roll, found.state.velocity.pitch]);
        hash.members(&found.forces.wrench);
    }
}

/// The profile that is prepared from points `y, z`, with a step and a smoothing length.
fn hash_points<F: Bits>(hash: &mut Hash, points: &[[f64; 2]], lengths: [f64; 2]) {
    let [y, z] = [0, 1].map(|k| points.iter().map(|of| F::of(of[k])).collect::<Vec<_>>());
    let [step, smoothing] = lengths.map(F::of);
    let mut surface = zeroed::<PreparedProfile<F>>();
    let found = surface.prepare(&y, &z, step, smoothing);
    if hash.status(found.map(|warning| ((), warning))).is_some() {
        hash_surface(hash, &surface);
    }
}

/// Profiles that scatter in both axes, of which a part may be scanned twice.
fn hash_scans<F: Bits>(hash: &mut Hash) {
    for i in 0..24 {
        let count = 100 + draw(i, 1, 400);
        let noise = size(i, 2, [1e-7, 1e-6, 1e-5]);
        let (from, twice) = (draw(i, 4, count - 20), if i % 2 == 0 { draw(i, 5, 12) } else { 0 });
        let mut points = Vec::new();
        for (n, k) in (0..).zip((0..from + twice).chain(from..count)) {
            let y = (f64::from(k) / f64::from(count) - 0.5) * 0.07 + noise * swing(i, 1000 + n);
            points.push([y, y * y / 0.6 + noise * swing(i, 3000 + n)]);
        }
        hash_points::<F>(hash, &points, [0.0, [0.0, 1e-3][draw(i, 6, 2) as usize]]);
    }
    // (from a smooth line to one that turns too much)
    for i in 0..36 {
        let height = (60.0 + 2.0 * f64::from(i)) * 1e-3 * 2e-4;
        let point = |n| [(f64::from(n) - 200.0) * 2e-4, if n % 2 == 0 { height } else { -height }];
        hash_points::<F>(hash, &(0..400).map(point).collect::<Vec<_>>(), [0.0; 2]);
    }
}

/// Few points with noise, some nearly twice, some scanned again, one far away in a tenth of them.
fn hash_few_points<F: Bits>(hash: &mut Hash) {
    let mut random = Random::new(7);
    for _ in 0..150 {
        let mut u = || random.unit();
        let count = 5 + (u() * 40.0) as usize;
        let [width, curvature, noise] = [0.02 + 0.1 * u(), 3.0 * u(), 1e-3 * u() * u() * u()];
        let twice = u();
        let mut points = Vec::new();
        for k in 0..count {
            let y = (k as f64 / count as f64 - 0.5) * width + 0.3 * noise * (u() - 0.5);
            let z = curvature * y * y + noise * (u() - 0.5);
            points.push([y, z]);
            if u() < twice * 0.5 {
                points.push([y + 1e-4 * u() * u(), z + 1e-5 * u()]);
            }
            if u() < 0.02 {
                let from = points.len().saturating_sub(1 + (u() * 6.0) as usize);
                points.extend_from_within(from..);
            }
        }
        if u() < 0.1 {
            let k = (u() * points.len() as f64) as usize;
            points[k][1] += 0.02 * u();
        }
        let step = if u() < 0.5 { 0.0 } else { 2e-4 + 2e-3 * u() };
        let smoothing = if u() < 0.4 { 0.0 } else { 4e-3 * u() };
        hash_points::<F>(hash, &points, [step, smoothing]);
    }
}

fn hashes<F: Bits>(precision: &str) -> String {
    let mut text = String::new();
    let mut part = |name: &str, add: fn(&mut Hash)| {
        let mut hash = Hash::START;
        add(&mut hash);
        text += &format!("{precision} {name} {:016x}\n", hash.value());
    };
    part("ellipses of bodies", hash_hertz::<F>);
    part("searches of rigs", hash_rigs::<F>);
    part("several frictions", hash_folds::<F>);
    part("layers", hash_layers::<F>);
    part("fits", hash_fits::<F>);
    part("young zones", hash_young_zones::<F>);
    part("gaps", hash_gaps::<F>);
    part("wheels anywhere", hash_wheels::<F>);
    part("wheelsets in balance", hash_wheelsets::<F>);
    part("scans", hash_scans::<F>);
    part("few points", hash_few_points::<F>);
    text
}

/// (In builds without optimisation, `KSTRIP_GOLDEN_FEW`, this would take a minute.)
#[test]
fn searches_give_the_golden_bits() {
    if std::env::var_os("KSTRIP_GOLDEN_FEW").is_some() {
        return;
    }
    compare("golden_searches.txt", hashes::<f64>, hashes::<f32>);
}
