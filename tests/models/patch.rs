//! Patches that are given by their strips: the ellipse as its strips, lobes, friction that varies,
//! places, fields, derivatives.

use crate::patches::motion;
use crate::prelude::*;
use kstrip::patch::friction::differentiate_patch;

const WITH_STRIPS: [Model; 3] = [Model::Strip1967, Model::Strip1967Continuous, Model::Strip];

fn solve(patch: &Full, motion: &Creepage<f64>, model: Model) -> Solution<f64> {
    solver::solve_patch(&patch.view().unwrap(), motion, model).unwrap()
}

fn jacobian(patch: &Full, motion: &Creepage<f64>, model: Model) -> [[f64; 3]; 3] {
    let view = patch.view().unwrap();
    differentiate_patch(&view, motion, None, model).unwrap().derivatives.jacobian
}

/// Irregular patches with motions, and models with strips.
fn states(seed: u64, count: usize) -> impl Iterator<Item = (Full, Creepage<f64>, Model)> {
    let mut random = Random::new(seed);
    let state = move |i| (irregular(&mut random), motion(&mut random), WITH_STRIPS[i % 3]);
    (0..count).map(state)
}

/// Forces and moment are these, but for a share of a unit.
#[track_caller]
fn assert_forces(found: &Solution<f64>, wanted: [f64; 3], allowed: [f64; 3]) {
    let found = force_and_moment(found);
    let near = (0..3).all(|i| (found[i] - wanted[i]).abs() < allowed[i]);
    assert!(near, "{found:?} {wanted:?}");
}

fn ellipse(contact: &Contact<f64>, count: StripCount) -> Full {
    Full::from_ellipse(contact, count).unwrap()
}

/// STRIP's strips of an ellipse are those of the model: the same forces, moment, stick area and
/// derivatives to rounding, from eight strips on (sums over the load of four are not exact).
#[test]
fn elliptic_strips_give_the_answer_of_the_ellipse() {
    let mut random = Random::new(401);
    for i in 0..600 {
        let c = any_contact(&mut random);
        let count = StripCount::ALL[1 + i % 4];
        let p: [f64; 3] = std::array::from_fn(|_| random.sign() * random.log_between(1e-6, 4.0));
        let motion = creepage(&c, p[0], p[1], p[2]);
        let patch = ellipse(&c, count);
        assert_relative_eq!(
            patch.view().unwrap().normal_force(),
            c.normal_force,
            max_relative = 1e-14
        );
        let model = options(Model::Strip, count);
        let (wanted, wanted_slopes) = forces::solve_jacobian(&c, &motion, &model).unwrap();
        let found = solve(&patch, &motion, Model::Strip);
        let unit = c.friction * c.normal_force;
        let allowed = [4e-15 * unit, 5e-15 * unit, 4e-15 * unit * (c.a + c.b)];
        assert_forces(&found, force_and_moment(&wanted), allowed);
        assert!((found.adhesion - wanted.adhesion).abs() < 4e-15, "{found:?} {wanted:?}");
        assert_eq!(found.warning, wanted.warning);
        let slopes = jacobian(&patch, &motion, Model::Strip);
        for (row, slopes) in slopes.iter().enumerate() {
            let slip = theory::slip_unit(&c);
            for (k, slope) in slopes.iter().enumerate() {
                // the force divided by the creepage that it takes
                let size = unit * [1.0, 1.0, c.a + c.b][row] / slip * [1.0, 1.0, c.a + c.b][k];
                let error = (slope - wanted_slopes[(row, k)]).abs();
                assert!(error <= 1e-11 * size, "{row} {k}: {slope} {wanted_slopes} {size}");
            }
        }
    }
}

/// The theory of 1967 on strips that do not move with the solution: a strip adheres or slides as a
/// whole, so the error is at most about what one strip carries, and mostly a third of it.
#[test]
fn elliptic_strips_of_the_theory_of_1967() {
    for model in MODELS {
        for count in [StripCount::Eight, StripCount::Sixteen, StripCount::SixtyFour] {
            let mut random = Random::new(402);
            let mut errors = Vec::new();
            let mut share = 0.0_f64;
            for _ in 0..400 {
                let c = any_contact(&mut random);
                let p: [f64; 3] = std::array::from_fn(|_| random.between(-0.95, 0.95));
                let motion = creepage(&c, p[0], p[1], p[2]);
                let many = options(model, StripCount::SixtyFour);
                let exact = solved(&c, &motion, &many);
                let patch = ellipse(&c, count);
                let loads = patch.used().iter().map(|strip| strip.load() / c.normal_force);
                share = loads.fold(share, f64::max);
                let found = solve(&patch, &motion, model);
                let unit = c.friction * c.normal_force;
                errors.push((found.fx - exact.fx).hypot(found.fy - exact.fy) / unit);
            }
            errors.sort_by(f64::total_cmp);
            let [median, most, worst] = [errors[200], errors[379], errors[399]];
            println!(
                "{model:?} {count:?}: median {median:.1e}, 95 % {most:.1e}, worst {worst:.1e}"
            );
            assert!(worst < share && most < share / 3.0, "{model:?} {count:?} {share}");
        }
    }
}

/// `|F| ≤ Σ μ N`, no energy is won, the shares of the strips are the totals, and opposite creepage
/// gives the opposite.
#[test]
fn irregular_patches_keep_the_bounds() {
    for (patch, motion, model) in states(403, 600) {
        let view = patch.view().unwrap();
        let found = solve(&patch, &motion, model);
        let bound = view.friction_bound();
        assert!(found.fx.hypot(found.fy) <= bound * (1.0 + 1e-12), "{found:?}");
        assert!((0.0..=1.0).contains(&found.adhesion), "{found:?}");
        if found.warning != Warning::SpinBeyondTheory {
            assert!(found.power >= -1e-12 * bound, "{found:?}");
        }
        let power = found.fx * motion.longitudinal + found.fy * motion.lateral;
        assert_relative_eq!(found.power, power + found.mz * motion.spin, max_relative = 1e-12);
        let strips = strips_of_patch(&view, &motion, model);
        assert_eq!(strips.len(), patch.used().len());
        let mut sums = [0.0; 4];
        for (strip, own) in strips.iter().zip(patch.used()) {
            let parts = [strip.fx, strip.fy, strip.mz, strip.power];
            sums.iter_mut().zip(parts).for_each(|(sum, part)| *sum += part);
            let geometry = [strip.y, strip.width, strip.half_length];
            assert_eq!(geometry, [own.y, own.width, own.half_length]);
            assert!(strip.fx.hypot(strip.fy) <= own.friction_bound() * (1.0 + 1e-12));
            let edge = (strip.separatrix - own.centre_x).abs();
            assert!(edge <= own.half_length * (1.0 + 1e-12), "{strip:?}");
        }
        for (sum, total) in sums.iter().zip([found.fx, found.fy, found.mz, found.power]) {
            let allowed = 1e-13 * bound * (1.0 + motion.spin.abs());
            assert!((sum - total).abs() <= allowed, "{sum} {total}");
        }
        let Creepage { longitudinal, lateral, spin } = motion;
        let opposite = creep(-longitudinal, -lateral, -spin);
        let opposite = solve(&patch, &opposite, model);
        assert_eq!(force_and_moment(&opposite), force_and_moment(&found).map(|x| -x));
        assert_eq!(opposite.power, found.power);
    }
}

/// Seen from the other side, `y → −y`: lateral creepage, spin, their force and moment
/// change their signs.
#[test]
fn a_mirrored_patch_gives_mirrored_forces() {
    for (patch, motion, model) in states(404, 300) {
        let strips: Vec<_> =
            patch.used().iter().map(|strip| PatchStrip { y: -strip.y, ..*strip }).collect();
        let mirrored = Full::from_strips(&strips, 82e9, 0.28).unwrap();
        let Creepage { longitudinal, lateral, spin } = motion;
        let other = creep(longitudinal, -lateral, -spin);
        let (found, other) = (solve(&patch, &motion, model), solve(&mirrored, &other, model));
        let unit = patch.view().unwrap().friction_bound();
        assert_forces(&found, [other.fx, -other.fy, -other.mz], [4e-15 * unit; 3]);
    }
}

/// The origin of the coordinates does not matter: a patch moved by `(X, Y)`, its creepage told for
/// the new origin, has the same forces, and its moment the new arms.
#[test]
fn a_moved_patch_is_the_same_patch() {
    let mut random = Random::new(405);
    for (patch, motion, model) in states(405, 300) {
        let (x, y) = (random.between(-0.02, 0.02), random.between(-0.05, 0.05));
        let strips: Vec<_> = patch
            .used()
            .iter()
            .map(|strip| PatchStrip { y: strip.y + y, centre_x: strip.centre_x + x, ..*strip })
            .collect();
        let moved = Full::from_strips(&strips, 82e9, 0.28).unwrap();
        // υx − φ y and υy + φ x are the creepages at a point
        let Creepage { longitudinal, lateral, spin } = motion;
        let there = creep(longitudinal + spin * y, lateral - spin * x, spin);
        let (found, other) = (solve(&patch, &motion, model), solve(&moved, &there, model));
        let unit = patch.view().unwrap().friction_bound();
        // rounding of the creepages, as steep as the theory is
        let arms = found.mz + x * found.fy - y * found.fx;
        assert_forces(&other, [found.fx, found.fy, arms], [3e-14 * unit; 3]);
    }
}

/// Two ellipses side by side carry what each of them carries alone at the creepage of its centre.
#[test]
fn lobes_do_not_know_of_each_other() {
    let mut random = Random::new(406);
    for i in 0..300 {
        let [first, second] = [0; 2].map(|_| contact(random.log_between(0.2, 5.0), 0.28));
        let gap = random.between(4e-3, 2e-2);
        let pair = [(first, -first.b), (Contact { friction: 0.2, ..second }, second.b + gap)];
        let both = side_by_side(&pair, StripCount::Sixteen);
        assert_eq!(both.view().unwrap().lobes().count(), 2);
        let motion = motion(&mut random);
        let model = WITH_STRIPS[i % 3];
        let found = solve(&both, &motion, model);
        let (mut fx, mut fy, mut mz) = (0.0, 0.0, 0.0);
        for (contact, centre) in pair {
            let there =
                Creepage { longitudinal: motion.longitudinal - motion.spin * centre, ..motion };
            let own = solve(&ellipse(&contact, StripCount::Sixteen), &there, model);
            fx += own.fx;
            fy += own.fy;
            mz += own.mz - centre * own.fx;
        }
        let unit = both.view().unwrap().friction_bound();
        assert_forces(&found, [fx, fy, mz], [4e-15 * unit; 3]);
    }
}

/// A very narrow strip at the rim hardly changes the forces, also where most strips are a twentieth
/// narrower than the widest. (These strips do not count as a rule of Gauss, whose neighbours are of
/// two kinds, which an additional strip would swap.)
#[test]
fn a_narrow_strip_at_the_rim_changes_nothing() {
    let mut random = Random::new(409);
    for i in 0..30 {
        let (width, count) = (0.5e-3, 12);
        let mut y = 0.0;
        let mut strips: Vec<_> = (0..count)
            .map(|k| {
                let place = (f64::from(k) + 0.5) / f64::from(count) * 2.0 - 1.0;
                let round = (1.0 - place * place).sqrt();
                let width = width * if k == 3 { 1.0 } else { 0.95 };
                y += width;
                PatchStrip {
                    y: y - width / 2.0,
                    width,
                    half_length: 5e-3 * round,
                    centre_x: 0.0,
                    peak_pressure: 1e9 * round,
                    friction: 0.3,
                }
            })
            .collect();
        let motion = motion(&mut random);
        let alone = Full::from_strips(&strips, 82e9, 0.28).unwrap();
        let first = strips[0];
        strips.insert(0, PatchStrip { y: -5e-10, width: 1e-9, half_length: 1e-4, ..first });
        let other = Full::from_strips(&strips, 82e9, 0.28).unwrap();
        let [found, other] = [&alone, &other].map(|patch| solve(patch, &motion, Model::Strip));
        let unit = alone.view().unwrap().friction_bound();
        let off = (found.fx - other.fx).hypot(found.fy - other.fy) / unit;
        assert!(off < 1e-8, "{i}: {off:e}");
    }
}

/// Every rule of an ellipse is one lobe, however its strips are spaced.
#[test]
fn an_ellipse_is_one_lobe() {
    for count in &StripCount::ALL[1..] {
        for ratio in [1e-3, 0.1, 1.0, 10.0, 1e3] {
            let c = contact(ratio, 0.28);
            let patch = ellipse(&c, *count);
            let view = patch.view().unwrap();
            assert_eq!(view.lobes().count(), 1);
            for i in 0..patch.used().len() {
                let zone = view.zone(i).unwrap();
                assert_relative_eq!(zone.contact.a, c.a, max_relative = 4e-15);
                assert_relative_eq!(zone.contact.b, c.b, max_relative = 4e-15);
                assert!(zone.y.abs() < 1e-15 * c.b);
                assert_relative_eq!(zone.contact.friction, c.friction, max_relative = 4e-15);
            }
        }
    }
}

/// A greasy band: its strips carry no more than their own bound, the force lies between those of
/// the two frictions, and the difference of both sides turns the patch.
#[test]
fn a_contaminated_band_carries_less() {
    let c = contact(1.5, 0.28);
    let dry = ellipse(&c, StripCount::ThirtyTwo);
    let mut band = dry;
    for strip in band.used_mut().iter_mut().filter(|strip| strip.y > 0.2 * c.b) {
        strip.friction = 0.05;
    }
    let mut clean = dry;
    clean.used_mut().iter_mut().for_each(|strip| strip.friction = 0.05);
    for model in WITH_STRIPS {
        for size in [0.3, 1.0, 3.0, 30.0] {
            let motion = creepage(&c, size, 0.0, 0.0);
            let [most, some, least] =
                [&dry, &band, &clean].map(|patch| solve(patch, &motion, model));
            assert!(least.fx < some.fx && some.fx < most.fx, "{model:?} {size}");
            // Mz = ∫ (x Y − y X): less X on the side of positive y
            assert!(some.mz > 0.0 && most.mz.abs() < 1e-12 * c.a * most.fx, "{model:?} {some:?}");
        }
        // Full sliding: Σ μ N
        let sliding = solve(&band, &creepage(&c, 1e3, 0.0, 0.0), model);
        let bound = band.view().unwrap().friction_bound();
        assert_relative_eq!(sliding.fx, bound, max_relative = 4e-15);
        // No creepage to speak of: friction does not matter, the slopes are those of the dry
        // ellipse
        let (banded, uniform) = (
            jacobian(&band, &Creepage::default(), model),
            jacobian(&dry, &Creepage::default(), model),
        );
        for (banded, uniform) in banded.iter().flatten().zip(uniform.iter().flatten()) {
            assert!((banded - uniform).abs() <= 1e-9 * uniform.abs() + 1e-6, "{banded} {uniform}");
        }
    }
}

#[test]
fn strips_without_friction_or_load() {
    let mut random = Random::new(407);
    for i in 0..200 {
        let mut patch = irregular(&mut random);
        let motion = motion(&mut random);
        let model = WITH_STRIPS[i % 3];
        let number = patch.used().len() / 2;
        for (friction, pressure) in [(0.0, 1e9), (0.3, 0.0), (1e-300, 1e9)] {
            (patch.strips[number].friction, patch.strips[number].peak_pressure) =
                (friction, pressure);
            let found = solve(&patch, &motion, model);
            assert!(force_and_moment(&found).iter().all(|x| x.is_finite()));
            let strip = strips_of_patch(&patch.view().unwrap(), &motion, model)[number];
            assert!(strip.fx.abs() + strip.fy.abs() < 1e-200, "{strip:?}");
            let slopes = jacobian(&patch, &motion, model);
            assert!(slopes.iter().flatten().all(|slope| slope.is_finite()));
        }
        patch.used_mut().iter_mut().for_each(|strip| strip.friction = 0.0);
        let found = solve(&patch, &motion, model);
        assert_eq!([found.fx, found.fy, found.mz, found.power], [0.0; 4]);
        patch.count = 0;
        let found = solve(&patch, &motion, model);
        assert_eq!([found.fx, found.fy, found.mz, found.power, found.adhesion], [0.0; 5]);
    }
}

/// The derivatives are those of the forces. A kink of the fixed strips within the stencil shows
/// itself by differences that do not agree; there are few.
#[test]
fn derivatives_are_those_of_the_forces() {
    let mut comparison = Comparison::default();
    for (patch, motion, model) in states(408, 900) {
        let exact = jacobian(&patch, &motion, model);
        let forces = |motion: &Creepage<f64>| force_and_moment(&solve(&patch, motion, model));
        let unit = patch.view().unwrap().friction_bound();
        comparison.patch(|row, column| exact[row][column], &motion, unit, forces, &model);
    }
    comparison.assert_few_kinks(101);
}

/// The field of the theory of 1967 integrates to the forces, the pressure of all models to the
/// load; inside `|traction| ≤ μ Z`, outside and in the gaps nothing.
#[test]
fn fields_integrate_to_the_forces() {
    for (patch, motion, model) in states(409, 12) {
        let view = patch.view().unwrap();
        let field = PatchField::new(&view, &motion, None, model).unwrap();
        let n = 2000;
        let (mut load, mut fx, mut fy, mut mz) = (0.0, 0.0, 0.0, 0.0);
        for own in patch.used() {
            // strips touch here, so the middle of each belongs to it
            let strip = field.strip_at(own.y);
            for k in 0..n {
                // x = l cos θ
                let angle = PI * (k as f64 + 0.5) / n as f64;
                let x = own.centre_x + own.half_length * angle.cos();
                let area = own.width * own.half_length * angle.sin() * PI / n as f64;
                let point = PatchField::along(strip.as_ref(), x);
                load += area * point.pressure;
                fx += area * point.traction_x;
                fy += area * point.traction_y;
                mz += area * (x * point.traction_y - own.y * point.traction_x);
                let traction = point.traction_x.hypot(point.traction_y);
                assert!(traction <= own.friction * point.pressure * (1.0 + 1e-9) + 1e-3);
            }
        }
        let unit = view.friction_bound();
        assert_relative_eq!(load, view.normal_force(), max_relative = 5e-14);
        let found = solve(&patch, &motion, model);
        // The forces of STRIP's strips are sums over a few nodes of their slip part, its field lies
        // between them.
        let allowed = if model == Model::Strip { 0.01 } else { 1e-4 } * unit;
        assert_forces(&found, [fx, fy, mz], [allowed, allowed, allowed * 2e-2]);
        let (first, last) = (patch.strips[0], patch.strips[patch.used().len() - 1]);
        for (x, y) in [
            (0.0, first.y - 0.51 * first.width),
            (0.0, last.y + 0.51 * last.width),
            (first.centre_x + 1.01 * first.half_length, first.y),
        ] {
            assert_eq!(field.at(x, y).pressure, 0.0);
        }
        for (strip, next) in patch.used().iter().zip(patch.used().iter().skip(1)) {
            let gap = (next.y - next.width / 2.0) - (strip.y + strip.width / 2.0);
            if gap > 1e-4 {
                assert!(field.strip_at(strip.y + strip.width / 2.0 + gap / 2.0).is_none());
            }
        }
    }
}

#[test]
fn fields_of_elliptic_strips() {
    let c = contact(1.3, 0.28);
    let motion = creepage(&c, 0.3, -0.2, 0.4);
    let patch = ellipse(&c, StripCount::Sixteen);
    for model in WITH_STRIPS {
        let view = patch.view().unwrap();
        let field = PatchField::new(&view, &motion, None, model).unwrap();
        let wanted = forces::Field::new(&c, &motion, &sixteen(model)).unwrap();
        for strip in patch.used() {
            for k in -9..10 {
                let x = strip.half_length * f64::from(k) / 10.0;
                let (found, wanted) = (field.at(x, strip.y), wanted.at(x, strip.y));
                let p0 = c.peak_pressure();
                assert!((found.pressure - wanted.pressure).abs() < 4e-15 * p0);
                assert!((found.traction_x - wanted.traction_x).abs() < 4e-15 * p0);
                assert!((found.traction_y - wanted.traction_y).abs() < 5e-15 * p0);
                assert!((found.slip_x - wanted.slip_x).abs() < 4e-15);
                assert!((found.slip_y - wanted.slip_y).abs() < 4e-15);
                assert_eq!(found.state, wanted.state, "{model:?} {x} {}", strip.y);
            }
        }
    }
}

#[test]
fn single_precision() {
    let mut random = Random::new(410);
    for i in 0..300 {
        let patch = irregular(&mut random);
        let motion = motion(&mut random);
        let narrow: Vec<PatchStrip<f32>> = patch
            .used()
            .iter()
            .map(|strip| PatchStrip {
                y: strip.y as f32,
                width: strip.width as f32,
                half_length: strip.half_length as f32,
                centre_x: strip.centre_x as f32,
                peak_pressure: strip.peak_pressure as f32,
                friction: strip.friction as f32,
            })
            .collect();
        let single = Patch::<f32>::from_strips(&narrow, 82e9, 0.28).unwrap();
        let slow = single_motion(&motion);
        // the sliding rule of the paper jumps: a strip on the other side of its jump is no error
        let model = [Model::Strip1967Continuous, Model::Strip][i % 2];
        let found = solver::solve_patch(&single.view().unwrap(), &slow, model).unwrap();
        let wanted = solve(&patch, &motion, model);
        let unit = patch.view().unwrap().friction_bound();
        if wanted.warning == Warning::SpinBeyondTheory {
            continue;
        }
        let found = force_and_moment(&found).map(f64::from);
        // (the flexibility of a strip has roundings of its own)
        assert_forces(&wanted, found, [8e-7, 2e-6, 5e-9].map(|share| share * unit));
        let view = single.view().unwrap();
        let slopes = differentiate_patch(&view, &slow, None, model).unwrap().derivatives.jacobian;
        assert!(slopes.as_flattened().iter().all(|slope| slope.is_finite()));
    }
}

/// Far outside of every range the answer is a finite one within the bound, or a named error.
#[test]
fn hard_inputs() {
    let values = [0.0, 1e-300, 1e-30, 1e-9, 1.0, 1e9, 1e30, 1e150, 1e300];
    let mut random = Random::new(411);
    let mut pick = || values[(random.bits() % 9) as usize];
    let (mut answers, mut refusals) = (0, 0);
    for i in 0..4000 {
        let width = pick();
        let strip = |k: f64, half_length, peak_pressure, friction, centre_x| PatchStrip {
            y: k * width,
            width,
            half_length,
            centre_x,
            peak_pressure,
            friction,
        };
        let strips = [
            strip(0.0, pick(), pick(), pick(), pick()),
            strip(1.0, pick(), pick(), pick(), pick()),
            strip(5.0, pick(), pick(), pick(), pick()),
        ];
        let motion = creep(pick(), -pick(), pick());
        let model = WITH_STRIPS[i % 3];
        let Ok(patch) = Full::from_strips(&strips, 82e9, 0.28) else {
            refusals += 1;
            continue;
        };
        let view = patch.view().unwrap();
        match solver::solve_patch(&view, &motion, model) {
            Ok(found) => {
                answers += 1;
                let numbers = [found.fx, found.fy, found.mz, found.power, found.adhesion];
                assert!(numbers.iter().all(|x| x.is_finite()), "{strips:?} {motion:?} {found:?}");
                let bound = view.friction_bound() * (1.0 + 1e-12);
                assert!(found.fx.abs() <= bound && found.fy.abs() <= bound, "{found:?}");
            }
            Err(error) => {
                assert_eq!(error, Error::Overflow);
                refusals += 1;
            }
        }
        match differentiate_patch(&view, &motion, None, model) {
            Ok(Differentiated { derivatives, .. }) => {
                let slopes = derivatives.jacobian;
                assert!(slopes.as_flattened().iter().all(|slope| slope.is_finite()));
            }
            Err(error) => assert_eq!(error, Error::Overflow),
        }
        if let Ok(field) = PatchField::new(&view, &motion, None, model) {
            for strip in patch.used() {
                let point = field.at(strip.centre_x + 0.3 * strip.half_length, strip.y);
                assert!(
                    !point.traction_x.is_nan() && !point.traction_y.is_nan(),
                    "{point:?} {model:?} {strip:?} {motion:?} {field:?}"
                );
                assert!(
                    !point.slip_x.is_nan() && !point.slip_y.is_nan(),
                    "{point:?} {strips:?} {motion:?}"
                );
            }
        }
    }
    println!("{answers} answers, {refusals} refusals");
    assert!(answers > 100);
}

/// What `docs/maintain/bad-input.md` cannot say, because C has one capacity and its own order of
/// strips.
#[test]
fn patches_have_their_order_and_capacity() {
    let (y, width, half_length, centre_x) = (0.0, 1e-3, 5e-3, 0.0);
    let (peak_pressure, friction) = (1e9, 0.3);
    let good = PatchStrip { y, width, half_length, centre_x, peak_pressure, friction };
    let of = |strips: &[PatchStrip<f64>]| Patch::<f64>::from_strips(strips, 82e9, 0.28);
    assert!(of(&[]).unwrap().used().is_empty());
    let next = PatchStrip { y: 1e-3, ..good };
    assert_eq!(of(&[next, good]).unwrap().used(), [good, next]);
    let near = PatchStrip { y: 0.51e-3, ..good };
    assert_eq!(of(&[near, good]).unwrap().used(), [good, near]);
    let overlap = PatchStrip { y: 0.49e-3, ..good };
    for (strips, error) in [
        (vec![good, overlap], Error::StripOrder),
        (vec![good; 2], Error::StripOrder),
        (
            (0..65).map(|k| PatchStrip { y: f64::from(k) * 1e-3, ..good }).collect(),
            Error::PatchSize,
        ),
        (vec![PatchStrip { half_length: 1e300, ..good }], Error::Overflow),
        (vec![PatchStrip { peak_pressure: 1e308, friction: 10.0, ..good }], Error::Overflow),
    ] {
        assert_eq!(of(&strips).err(), Some(error), "{strips:?}");
    }
    let view = |strips: &[PatchStrip<f64>], area| {
        PatchView::new(strips, 82e9, 0.28, QuadratureScale { area, lever: 1.0 }).err()
    };
    assert_eq!(view(&[good, next], 1.0), None);
    assert_eq!(view(&[next, good], 1.0), Some(Error::StripOrder));
    assert_eq!(view(&[good], 0.0), Some(Error::NotFinite));
    for (area, error) in [
        (0.99e-6, Some(Error::Overflow)),
        (1.01e-6, None),
        (0.99e6, None),
        (1.01e6, Some(Error::Overflow)),
    ] {
        assert_eq!(view(&[good], area), error, "{area}");
        let scale = QuadratureScale { area: 1.0, lever: area };
        assert_eq!(PatchView::new(&[good], 82e9, 0.28, scale).err(), error, "{area}");
    }
    // the field of a strip ends with its width
    let (patch, rest) = (of(&[good]).unwrap(), Creepage::default());
    let view_of_one = patch.view().unwrap();
    let field = PatchField::new(&view_of_one, &rest, None, Model::Strip).unwrap();
    for (share, inside) in [(0.499, true), (0.501, false)] {
        for side in [1.0, -1.0] {
            let y = good.y + side * share * good.width;
            assert_eq!(field.strip_at(y).is_some(), inside, "{side} {share}");
        }
    }
    let patch = of(&[good]).unwrap();
    let (view, rest) = (patch.view().unwrap(), Creepage::default());
    assert_eq!(solver::solve_patch(&view, &rest, Model::Linear), Err(Error::NotInModel));
    for model in [Model::Total, Model::Linear] {
        let strips = solver::patch_strips(&view, &rest, model, &mut |_| ());
        assert_eq!(strips, Err(Error::NotInModel));
        assert!(PatchField::new(&view, &rest, None, model).is_err());
    }
    let far = Creepage { longitudinal: 1e308, ..rest };
    assert_eq!(solver::solve_patch(&view, &far, Model::Strip), Err(Error::Overflow));
}
