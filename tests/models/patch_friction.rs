//! Friction that falls with the slip, and reduced initial slope, on patches of strips.

use crate::patches::motion;
use crate::prelude::*;
use kstrip::friction::FrictionSolution;
use kstrip::patch::friction::{differentiate_patch, solve_patch_with_law};

/// Polach's dry rail at 20 m/s; friction is that of the strips.
const DRY: SlipFriction<f64> = falling(f64::NAN, 0.4, 0.6, 20.0, 1.0);

/// Models without a jump on strips that do not move with the solution.
const SMOOTH: [Model; 2] = [Model::Strip, Model::Strip1967Continuous];

/// Forces, and derivatives with respect to the creepages.
fn solve_jacobian(
    view: &PatchView<f64>, motion: &Creepage<f64>, law: &SlipFriction<f64>, model: Model,
) -> Result<(FrictionSolution<f64>, Matrix3<f64>), Error> {
    let found = differentiate_patch(view, motion, Some(law), model)?;
    let jacobian = Matrix3::from(found.derivatives.jacobian).transpose();
    Ok((FrictionSolution { solution: found.solution, friction: found.friction }, jacobian))
}

fn any_law(random: &mut Random) -> SlipFriction<f64> {
    SlipFriction {
        ratio: random.between(0.1, 1.0),
        decay: random.log_between(0.1, 1.0),
        rolling_speed: random.between(1.0, 60.0),
        slope_factor: random.between(0.2, 1.0),
        ..DRY
    }
}

/// From the patch of an ellipse the forces, the friction and the derivatives of the ellipse under
/// the same law.
#[test]
fn elliptic_strips_give_the_answer_of_the_ellipse() {
    let mut random = Random::new(421);
    for i in 0..250 {
        let c = any_contact(&mut random);
        let count = StripCount::ALL[1 + i % 4];
        let p: [f64; 3] = std::array::from_fn(|_| random.sign() * random.log_between(1e-3, 4.0));
        let m = theory::creepage(&c, p[0], p[1], p[2].clamp(-2.0, 2.0));
        let law = SlipFriction { friction: c.friction, ..any_law(&mut random) };
        let o = options(Model::Strip, count);
        let (wanted, slopes) = crate::friction::with_slopes_under(&c, &m, &law, &o).unwrap();
        let patch = Full::from_ellipse(&c, count).unwrap();
        let view = patch.view().unwrap();
        let (found, j) = solve_jacobian(&view, &m, &law, Model::Strip).unwrap();
        let plain = solve_patch_with_law(&view, &m, &law, Model::Strip).unwrap();
        let unit = c.friction * c.normal_force;
        for found in [found, plain] {
            let (s, w) = (found.solution, wanted.solution);
            assert!((found.friction * c.friction - wanted.friction).abs() < 4e-15, "{law:?} {m:?}");
            assert!((s.fx - w.fx).abs() < 1e-12 * unit && (s.fy - w.fy).abs() < 1e-12 * unit);
            assert!((s.mz - w.mz).abs() < 4e-15 * unit * (c.a + c.b));
            assert!((s.adhesion - w.adhesion).abs() < 8e-15);
            assert_eq!(s.warning, w.warning);
        }
        let slip = theory::slip_unit(&c);
        let arms = [1.0, 1.0, c.a + c.b];
        for row in 0..3 {
            for column in 0..3 {
                let size = unit / slip * arms[row] * arms[column];
                let error = (j[(row, column)] - slopes[(row, column)]).abs();
                assert!(error < 1e-10 * size, "{row} {column} {j} {slopes} {law:?} {m:?}");
            }
        }
    }
}

#[test]
fn constant_friction_is_the_plain_solution_to_the_bit() {
    let mut random = Random::new(422);
    for i in 0..200 {
        let (patch, m) = (irregular(&mut random), motion(&mut random));
        let model = [Model::Strip, Model::Strip1967, Model::Strip1967Continuous][i % 3];
        let view = patch.view().unwrap();
        let plain = differentiate_patch(&view, &m, None, model).unwrap();
        let only = solver::solve_patch(&view, &m, model).unwrap();
        for law in [
            SlipFriction { ratio: 1.0, ..DRY },
            SlipFriction { decay: 0.0, ..DRY },
            SlipFriction { rolling_speed: 0.0, ..DRY },
        ] {
            let found = solve_patch_with_law(&view, &m, &law, model).unwrap();
            assert_eq!((found.solution, found.friction), (only, 1.0));
            let found = differentiate_patch(&view, &m, Some(&law), model).unwrap();
            assert_eq!(found.solution, plain.solution);
            assert_eq!(found.derivatives, plain.derivatives);
        }
    }
}

/// The patch with the friction that was found carries what was found, and leaves the slip that the
/// friction belongs to: forces, stick area, strips and the field are all of one patch.
#[test]
fn the_slipping_patch_has_the_friction_of_its_slip() {
    let mut random = Random::new(423);
    for i in 0..250 {
        let (patch, m) = (irregular(&mut random), motion(&mut random));
        let (law, model) = (any_law(&mut random), SMOOTH[i % 2]);
        let view = patch.view().unwrap();
        let found = solve_patch_with_law(&view, &m, &law, model).unwrap();
        let (share, warning) = (found.friction, found.solution.warning);
        let mut slipping = patch;
        slipping.used_mut().iter_mut().for_each(|strip| strip.friction *= share);
        slipping.shear_modulus *= law.slope_factor;
        let slipping_view = slipping.view().unwrap();
        let (s, again) = (found.solution, solver::solve_patch(&slipping_view, &m, model).unwrap());
        let unit = view.friction_bound();
        assert!((s.fx - again.fx).abs() < 4e-15 * unit, "{s:?} {again:?}");
        assert!((s.fy - again.fy).abs() < 1e-11 * unit && (s.mz - again.mz).abs() < 1e-13 * unit);
        assert!((s.adhesion - again.adhesion).abs() < 4e-15);
        if warning != Warning::NotConverged {
            // λ = (1 − A) exp(−B V s) + A, s the mean slip
            let slip = (again.power / slipping_view.friction_bound()).max(0.0);
            let w = law.rolling_speed * slip;
            let own = (1.0 - law.ratio) * (-law.decay * w).exp() + law.ratio;
            assert!((share - own).abs() < 4e-15, "{share} {own} {law:?}");
        }
        let strips = strips_of_patch(&slipping_view, &m, model);
        let [fx, fy] =
            [strips.iter().map(|s| s.fx).sum::<f64>(), strips.iter().map(|s| s.fy).sum()];
        assert!((fx - s.fx).abs() < 1e-11 * unit && (fy - s.fy).abs() < 1e-11 * unit);
        let field = PatchField::new(&slipping_view, &m, None, model).unwrap();
        for own in patch.used() {
            let point = field.at(own.centre_x - 0.4 * own.half_length, own.y);
            let traction = point.traction_x.hypot(point.traction_y);
            assert!(traction <= share * own.friction * point.pressure * (1.0 + 1e-9) + 1e-3);
        }
    }
}

/// Everything slides alike: the slip is the creepage, and friction is Polach's law as he wrote it.
#[test]
fn full_sliding_is_polachs_law() {
    let mut random = Random::new(424);
    for i in 0..60 {
        let patch = irregular(&mut random);
        let view = patch.view().unwrap();
        for slip in [0.2, 0.5, 2.0] {
            let m = creep(slip, 0.0, 0.0);
            let found = solve_patch_with_law(&view, &m, &DRY, SMOOTH[i % 2]).unwrap();
            let share = 0.6 * (-0.6 * 20.0 * slip).exp() + 0.4;
            assert!((found.friction - share).abs() < 4e-15, "{slip} {found:?}");
            let bound = share * view.friction_bound();
            assert!((found.solution.fx - bound).abs() < 2e-14 * bound);
        }
    }
}

/// The derivatives are those of the computed forces: extrapolated differences of the whole
/// function.
#[test]
fn derivatives_follow_friction_and_slip() {
    let mut random = Random::new(426);
    let mut comparison = Comparison::default();
    for i in 0..250 {
        let (patch, m, law) = (irregular(&mut random), motion(&mut random), any_law(&mut random));
        let model = SMOOTH[i % 2];
        let view = patch.view().unwrap();
        let (found, exact) = solve_jacobian(&view, &m, &law, model).unwrap();
        if matches!(found.solution.warning, Warning::NotConverged | Warning::SeveralFrictions) {
            continue;
        }
        let forces = |motion: &Creepage<f64>| {
            let found = solve_patch_with_law(&view, motion, &law, model).unwrap();
            force_and_moment(&found.solution)
        };
        let entry = |row, column| exact[(row, column)];
        comparison.patch(entry, &m, view.friction_bound(), forces, &(model, law, found));
    }
    comparison.assert_few_kinks(101);
}

/// No load, no friction, nothing left of friction, strips without friction: zero forces, no NaN.
/// Where the forces jump over the slip the warning says so, and the answer stays within its bounds.
#[test]
fn limits_are_answered() {
    let mut random = Random::new(427);
    for i in 0..60 {
        let (mut patch, m) = (irregular(&mut random), motion(&mut random));
        let model = [Model::Strip, Model::Strip1967, Model::Strip1967Continuous][i % 3];
        let gone = SlipFriction { ratio: 0.0, decay: 1e300, ..DRY };
        for (case, law) in [(0, gone), (1, DRY), (2, DRY), (3, DRY)] {
            match case {
                1 => patch.strips[0].friction = 0.0,
                2 => patch.used_mut().iter_mut().for_each(|strip| strip.peak_pressure = 0.0),
                3 => patch.count = 0,
                _ => {}
            }
            let view = patch.view().unwrap();
            let (found, j) = solve_jacobian(&view, &m, &law, model).unwrap();
            let s = found.solution;
            assert!(j.iter().all(|entry| entry.is_finite()), "{model:?} {case} {j}");
            let bound = found.friction * view.friction_bound();
            assert!(s.fx.hypot(s.fy) <= bound * (1.0 + 1e-9) + 1e-9, "{model:?} {case} {found:?}");
            assert!(found.friction >= 0.0 && found.friction <= 1.0);
        }
    }
    for i in 0..300 {
        let (patch, m, law) = (irregular(&mut random), motion(&mut random), any_law(&mut random));
        let view = patch.view().unwrap();
        let found = solve_patch_with_law(&view, &m, &law, Model::Strip1967).unwrap();
        assert!(found.friction >= law.ratio && found.friction <= 1.0, "{i} {found:?}");
    }
}

#[test]
fn friction_of_each_strip_falls_alike() {
    let c = contact(1.0, 0.28);
    let mut patch = Patch::<f64>::from_ellipse(&c, StripCount::Sixteen).unwrap();
    let greasy = |strip: &&mut PatchStrip<f64>| strip.y > 0.0;
    patch.used_mut().iter_mut().filter(greasy).for_each(|strip| strip.friction = 0.05);
    let m = creep(0.05, 0.0, 0.0);
    let view = patch.view().unwrap();
    let found = solve_patch_with_law(&view, &m, &DRY, Model::Strip).unwrap();
    assert!(found.friction < 0.9 && found.solution.mz > 0.0);
}

/// A patch whose pressures, whose lengths and pressures, or whose friction are multiplied.
fn multiplied(patch: &Full, pressure: f64, length: f64, friction: f64) -> Full {
    let mut patch = *patch;
    for strip in patch.used_mut() {
        strip.peak_pressure *= pressure;
        strip.friction *= friction;
        for size in [&mut strip.y, &mut strip.width, &mut strip.half_length, &mut strip.centre_x] {
            *size *= length;
        }
    }
    patch
}

/// A patch for a factor, the derivatives with respect to what is multiplied, and its size.
type Way<'a> = (&'a dyn Fn(f64) -> Full, [f64; 3], f64);

/// Derivatives with respect to load (pressures grow; through Hertz lengths grow with them) and by
/// friction are the derivatives of the forces, also under friction that falls with the slip.
#[test]
fn derivatives_by_load_and_friction() {
    let mut random = Random::new(428);
    let mut comparison = Comparison::default();
    for i in 0..120 {
        let (patch, m, law) = (irregular(&mut random), motion(&mut random), any_law(&mut random));
        let law = if i % 2 == 0 { Some(&law) } else { None };
        let view = patch.view().unwrap();
        let found = differentiate_patch(&view, &m, law, Model::Strip).unwrap();
        let bound = view.friction_bound();
        let load = view.normal_force();
        let ways: [Way; 3] = [
            (&|t| multiplied(&patch, t, 1.0, 1.0), found.derivatives.normal_force, load),
            (
                &|t: f64| multiplied(&patch, t.cbrt(), t.cbrt(), 1.0),
                found.derivatives.load_through_hertz,
                load,
            ),
            (&|t| multiplied(&patch, 1.0, 1.0, t), found.derivatives.friction, bound / load),
        ];
        if matches!(found.solution.warning, Warning::NotConverged | Warning::SeveralFrictions) {
            continue;
        }
        for (number, (way, exact, size)) in ways.into_iter().enumerate() {
            let units = [bound, bound, bound * 8e-3];
            let forces = |t: f64| {
                let patch = way(1.0 + t);
                let view = patch.view().unwrap();
                let s = match law {
                    Some(law) => {
                        solve_patch_with_law(&view, &m, law, Model::Strip).unwrap().solution
                    }
                    None => solver::solve_patch(&view, &m, Model::Strip).unwrap(),
                };
                [s.fx / units[0], s.fy / units[1], s.mz / units[2]]
            };
            let exact = std::array::from_fn(|k| exact[k] * size / units[k]);
            comparison.column(&forces, exact, [1.0; 3], 1e-10, &(number, law));
        }
    }
    comparison.assert_few_kinks(51);
}
