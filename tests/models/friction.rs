//! Friction that falls with the slip, and reduced initial slope.

use crate::prelude::*;
use kstrip::friction::{self, FrictionSolution};

/// Under friction that falls with the slip, with the derivatives with respect to the creepages as a
/// matrix.
pub fn with_slopes_under(
    c: &Contact<f64>, m: &Creepage<f64>, law: &SlipFriction<f64>, o: &Options,
) -> Result<(FrictionSolution<f64>, Matrix3<f64>), Error> {
    let found = differentiate_with_law(c, m, Some(law), o)?;
    let solution = FrictionSolution { solution: found.solution, friction: found.friction };
    Ok((solution, Matrix3::from(found.derivatives.jacobian).transpose()))
}

/// Polach's dry rail at 20 m/s.
const DRY: SlipFriction<f64> = falling(0.55, 0.4, 0.6, 20.0, 1.0);

/// From nearly linear to full sliding.
pub fn any_motion(random: &mut Random, contact: &Contact<f64>, spin: f64) -> Creepage<f64> {
    let size = random.log_between(1e-2, 30.0);
    let [xi, eta, psi] = [0; 3].map(|_| size * random.between(-1.0, 1.0));
    theory::creepage(contact, xi, eta, (spin * psi).clamp(-2.0, 2.0))
}

fn any_options(n: usize) -> Options {
    options(
        [Model::Strip, Model::Total, Model::Strip1967, Model::Strip1967Continuous][n % 4],
        StripCount::Sixteen,
    )
}

/// `μ → g(μ)` straight from its definition.
fn next(c: &Contact<f64>, m: &Creepage<f64>, law: &SlipFriction<f64>, o: &Options, mu: f64) -> f64 {
    let shear_modulus = c.shear_modulus * law.slope_factor;
    let c = Contact { friction: mu, shear_modulus, ..*c };
    let slip = solved(&c, m, o).power / (mu * c.normal_force);
    // The theory of 1967 has a negative power in some contacts that spin; that is no slip.
    let w = law.rolling_speed * slip.max(0.0);
    law.friction * ((1.0 - law.ratio) * (-law.decay * w).exp() + law.ratio)
}

#[test]
fn constant_friction_is_the_plain_solution_to_the_bit() {
    let mut random = Random::new(71);
    for n in 0..300 {
        let c = any_contact(&mut random);
        let m = any_motion(&mut random, &c, 1.0);
        let o = options(Model::ALL[n % 5], StripCount::Eight);
        let plain = solved(&c, &m, &o);
        let with_slopes = forces::solve_jacobian(&c, &m, &o).unwrap();
        let law = SlipFriction { friction: c.friction, ..DRY };
        for law in [
            SlipFriction { ratio: 1.0, ..law },
            SlipFriction { decay: 0.0, ..law },
            SlipFriction { rolling_speed: 0.0, ..law },
        ] {
            // The contact's own friction does not matter
            let other = Contact { friction: f64::NAN, ..c };
            let found = friction::solve_with_law(&other, &m, &law, &o).unwrap();
            assert_eq!((found.solution, found.friction), (plain, c.friction));
            let (found, jacobian) = with_slopes_under(&other, &m, &law, &o).unwrap();
            assert_eq!((found.solution, jacobian), with_slopes);
        }
    }
}

#[test]
fn friction_agrees_with_the_slip() {
    let mut random = Random::new(72);
    for n in 0..2_000 {
        let c = any_contact(&mut random);
        let m = any_motion(&mut random, &c, 1.0);
        let o = any_options(n);
        let law = falling(
            random.between(0.1, 0.6),
            random.between(0.0, 1.0),
            random.log_between(0.05, 3.0),
            random.between(1.0, 80.0),
            random.between(0.2, 1.0),
        );
        let found = friction::solve_with_law(&c, &m, &law, &o).unwrap();
        if found.solution.warning == Warning::NotConverged {
            continue;
        }
        let mu = found.friction;
        assert!(mu <= law.friction && mu >= law.friction * law.ratio);
        let again = next(&c, &m, &law, &o, mu);
        assert!((again - mu).abs() < 2e-14, "{mu} {again} {law:?} {c:?} {m:?} {o:?}");
        let s = found.solution;
        assert!(s.fx.hypot(s.fy) <= mu * c.normal_force * (1.0 + 1e-12));
    }
}

/// Friction that falls by any number of decades is found.
#[test]
fn friction_that_all_but_vanishes_converges() {
    let mut random = Random::new(77);
    for n in 0..1_000 {
        let c = any_contact(&mut random);
        let m = any_motion(&mut random, &c, 1.0);
        let o = options([Model::Strip, Model::Total][n % 2], StripCount::Sixteen);
        let (decay, rolling_speed) =
            (random.log_between(1e-2, 1e3), random.log_between(0.1, 300.0));
        let law = SlipFriction { friction: 0.3, ratio: 0.0, decay, rolling_speed, ..DRY };
        let found = friction::solve_with_law(&c, &m, &law, &o).unwrap();
        assert_ne!(found.solution.warning, Warning::NotConverged, "{law:?} {c:?} {m:?} {o:?}");
    }
}

/// In full sliding without spin the slip is the creepage, and the law is Polach's as he wrote it.
#[test]
fn full_sliding_is_polachs_law() {
    let c = contact(1.2, 0.28);
    for o in (0..4).map(any_options) {
        for slip in [0.05, 0.1, 0.3] {
            let found = friction::solve_with_law(&c, &creep(slip, 0.0, 0.0), &DRY, &o).unwrap();
            let mu = 0.55 * (0.6 * (-0.6 * 20.0 * slip).exp() + 0.4);
            assert!((found.friction - mu).abs() < 4e-15, "{o:?} {slip}");
            assert!((found.solution.fx - mu * c.normal_force).abs() < 6e-15 * c.normal_force);
        }
        // No slip: full friction
        let found = friction::solve_with_law(&c, &creep(0.0, 0.0, 0.0), &DRY, &o).unwrap();
        assert_eq!((found.friction, found.solution.fx), (0.55, 0.0));
    }
}

/// `k` multiplies the initial slope, stretches the curve, and leaves saturation alone.
#[test]
fn slope_factor_stretches_the_creep_curve() {
    let c = Contact { friction: 0.3, ..contact(0.8, 0.28) };
    for model in Model::ALL {
        let o = sixteen(model);
        for k in [0.1, 0.5, 0.9] {
            let law = SlipFriction { friction: 0.3, ratio: 1.0, slope_factor: k, ..DRY };
            for size in [1e-6, 1e-3, 3e-3, 1.0] {
                let m = creep(size, -0.4 * size, 30.0 * size);
                let stretched = creep(k * size, -0.4 * k * size, 30.0 * k * size);
                let found = friction::solve_with_law(&c, &m, &law, &o).unwrap().solution;
                let plain = solved(&c, &stretched, &o);
                let size = plain.fx.abs() + plain.fy.abs();
                assert!((found.fx - plain.fx).abs() < 5e-14 * size, "{model:?}");
                assert!((found.fy - plain.fy).abs() < 3e-14 * size);
                assert!((found.mz - plain.mz).abs() < 4e-13 * size * c.a);
            }
            let (_, j) = with_slopes_under(&c, &creep(0.0, 0.0, 0.0), &law, &o).unwrap();
            let (_, clean) = forces::solve_jacobian(&c, &creep(0.0, 0.0, 0.0), &o).unwrap();
            assert!((j[(0, 0)] / clean[(0, 0)] - k).abs() < 4e-15);
        }
    }
}

/// The derivatives are those of the computed forces: differences of the whole function,
/// extrapolated.
#[test]
fn derivatives_follow_friction_and_slip() {
    let mut random = Random::new(73);
    let mut comparison = Comparison::default();
    for n in 0..600 {
        let c = any_contact(&mut random);
        let m = any_motion(&mut random, &c, 0.3);
        let o = any_options(n);
        let law = falling(
            0.3,
            random.between(0.1, 0.9),
            random.log_between(0.1, 1.0),
            random.between(1.0, 50.0),
            random.between(0.3, 1.0),
        );
        let (found, exact) = with_slopes_under(&c, &m, &law, &o).unwrap();
        let same = friction::solve_with_law(&c, &m, &law, &o).unwrap();
        let bound = law.friction * c.normal_force;
        assert_eq!(found.friction, same.friction);
        assert!((found.solution.fx - same.solution.fx).abs() < 1e-13 * bound);
        if !matches!(found.solution.warning, Warning::None | Warning::SpinBeyondTheory) {
            continue;
        }
        let unit = theory::slip_unit(&c);
        let units = [unit, unit, unit / c.a];
        let rows = [bound, bound, bound * (c.a * c.b).sqrt()];
        let exact = |i: usize, k: usize| exact[(i, k)] * units[k] / rows[i];
        let size: [f64; 3] =
            std::array::from_fn(|i| (0..3).map(|k| exact(i, k).abs()).fold(0.1, f64::max));
        for k in 0..3 {
            let at = |t: f64| {
                let mut q = [m.longitudinal, m.lateral, m.spin];
                q[k] += t * units[k];
                let found = friction::solve_with_law(&c, &creep(q[0], q[1], q[2]), &law, &o);
                let s = found.unwrap().solution;
                [s.fx / rows[0], s.fy / rows[1], s.mz / rows[2]]
            };
            let exact = std::array::from_fn(|i| exact(i, k));
            comparison.column(&at, exact, size, 1e-7, &(k, law, c, m, o));
        }
    }
    comparison.assert_few_kinks(20);
}

/// Every sign change of `g(μ) − μ` on a fine grid, from above.
fn solutions(
    c: &Contact<f64>, m: &Creepage<f64>, law: &SlipFriction<f64>, o: &Options, step: f64,
) -> Vec<f64> {
    let at = |i: i32| law.friction * ((1.0 - step).powi(i)).max(1e-9);
    let error = |i: i32| next(c, m, law, o, at(i)) - at(i);
    let mut found = Vec::new();
    let mut before = -1.0;
    for i in 1..(13.7 / step) as i32 {
        let now = error(i);
        if (now > 0.0) != (before > 0.0) {
            let above = before > 0.0;
            let is_low = |mu| (next(c, m, law, o, mu) > mu) != above;
            found.push(bisect([at(i), at(i - 1)], 0.0, is_low)[0]);
        }
        before = now;
    }
    found
}

/// Friction that falls as steeply as no pair of bodies does: the largest solution is found, and
/// several are told from one, both against a search over all frictions.
#[test]
fn several_solutions_are_noticed_and_the_largest_is_taken() {
    let mut random = Random::new(74);
    let (mut several, mut single, mut folds) = (0, 0, 0);
    for n in 0..240 {
        let c = any_contact(&mut random);
        // Little slip at full friction, so that falling friction has far to fall
        let size = random.log_between(1e-3, 0.1);
        let [xi, eta, psi] = [0; 3].map(|_| size * random.between(-1.0, 1.0));
        let m = theory::creepage(&c, xi, eta, 0.3 * psi);
        let o = any_options(n);
        let rolling_speed = random.log_between(10.0, 100.0);
        let law = falling(
            0.3,
            random.between(0.0, 0.2),
            random.log_between(0.02, 0.3)
                / size
                / (rolling_speed * m.longitudinal.hypot(m.lateral)),
            rolling_speed,
            1.0,
        );
        let found = friction::solve_with_law(&c, &m, &law, &o).unwrap();
        let all = solutions(&c, &m, &law, &o, 0.03);
        if found.solution.warning == Warning::NotConverged {
            folds += 1;
            continue;
        }
        let largest = all[0];
        assert!(
            (found.friction / largest - 1.0).abs() < 1e-6,
            "{} {all:?} {:?} {law:?} {c:?} {m:?} {o:?}",
            found.friction,
            found.solution.warning
        );
        let apart = all[all.len() - 1] < 0.99 * largest;
        let noticed = found.solution.warning == Warning::SeveralFrictions;
        assert_eq!(apart, noticed, "{all:?} {law:?} {c:?} {m:?} {o:?}");
        if noticed { several += 1 } else { single += 1 }
    }
    println!("{several} with several solutions, {single} with one, {folds} near a fold");
    assert!(several > 10 && single > 100 && folds * 20 < 240);
}

/// TOTAL's slip may fall faster with friction than that of strips: of three frictions that agree in
/// a narrow contact that turns, the largest is taken, and the status says that there are several.
#[test]
fn several_solutions_of_total_are_noticed() {
    let (longitudinal, lateral, spin) = (-3.6296e-2, -1.15674e-1, -12.437376);
    let law = falling(0.270_816_31, 0.313_705_79, 3.110_822_06, 14.0424, 1.0);
    let [longitudinal, lateral, spin] =
        [longitudinal, lateral, spin].map(|slip| slip / law.rolling_speed);
    let m = Creepage { longitudinal, lateral, spin };
    let o = sixteen(Model::Total);
    let mut noticed = 0;
    for step in 0..16 {
        let normal_force = 3.782e3 + 3.0 * f64::from(step);
        let c = Contact { a: 1.896e-3, b: 1.221_394e-2, normal_force, friction: 0.3, ..C0 };
        let found = friction::solve_with_law(&c, &m, &law, &o).unwrap();
        let all = solutions(&c, &m, &law, &o, 2e-3);
        assert!((found.friction / all[0] - 1.0).abs() < 1e-6, "{} {all:?}", found.friction);
        let several = found.solution.warning == Warning::SeveralFrictions;
        // (two that are nearly one may be passed)
        let apart = all.len() > 2 && all.windows(2).all(|pair| pair[1] < 0.99 * pair[0]);
        assert!(several || !apart, "{normal_force} {all:?}");
        assert!(!several || all.len() > 2, "{normal_force} {all:?}");
        noticed += usize::from(several);
    }
    assert!((8..11).contains(&noticed), "{noticed}");
}

/// Without load, without friction, without anything left of friction: zero forces, no NaN.
#[test]
fn limits_are_answered() {
    let c = contact(1.0, 0.28);
    let m = creep(0.01, 0.002, 0.3);
    for o in (0..4).map(any_options) {
        for (c, law) in [
            (Contact { normal_force: 0.0, ..c }, DRY),
            (c, SlipFriction { friction: 0.0, ..DRY }),
            (c, SlipFriction { ratio: 0.0, decay: 1e300, ..DRY }),
        ] {
            let (found, j) = with_slopes_under(&c, &m, &law, &o).unwrap();
            let s = found.solution;
            assert!(j.iter().all(|v| v.is_finite()), "{j:?}");
            assert!(s.fx.hypot(s.fy) <= 1e-9 * 0.55 * c.normal_force.max(1.0), "{s:?} {law:?}");
        }
    }
}
