//! Totals against a second implementation of the theory that shares no code with the library.

use kstrip::strip_1967;
use kstrip_testing::prelude::*;
use kstrip_testing::theory::Law;

fn sample(random: &mut Random, psi: f64) -> Law {
    let parameter = |random: &mut Random| match random.bits() % 10 {
        0..=5 => random.between(-1.2, 1.2),
        6..=7 => random.log_between(1e-9, 1.0) * random.sign(),
        _ => random.between(-5.0, 5.0),
    };
    Law {
        xi: parameter(random),
        eta: parameter(random),
        psi,
        poisson_ratio: random.between(0.0, 0.5),
        axis_ratio: random.log_between(0.1, 10.0),
        continuous: random.unit() < 0.5,
    }
}

/// Numbers of single precision, a third of them with exact zeros.
fn inside_the_theory(random: &mut Random, i: usize) -> Law {
    let psi = match random.bits() % 5 {
        0 => random.log_between(1e-9, 0.95) * random.sign(),
        _ => random.between(-0.95, 0.95),
    };
    let mut law = sample(random, psi);
    if i.is_multiple_of(3) {
        let zero = 1 + random.bits() % 6;
        for (bit, parameter) in [&mut law.xi, &mut law.eta, &mut law.psi].into_iter().enumerate() {
            if zero >> bit & 1 == 1 {
                *parameter = 0.0;
            }
        }
    }
    for number in
        [&mut law.xi, &mut law.eta, &mut law.psi, &mut law.poisson_ratio, &mut law.axis_ratio]
    {
        *number = f64::from(*number as f32);
    }
    law
}

/// `F_x, F_y, M_z`, stick area.
fn totals<F: Float>(law: &Law) -> [f64; 4] {
    let Law { xi, eta, psi, poisson_ratio, axis_ratio, .. } = *law;
    let [xi, eta, psi, poisson_ratio, axis_ratio] =
        [xi, eta, psi, poisson_ratio, axis_ratio].map(F::of);
    let parameters = Parameters { xi, eta, psi, poisson_ratio, axis_ratio };
    let rule = if law.continuous { SlidingRule::Continuous } else { SlidingRule::RigidSlip };
    let Totals { fx, fy, mz, stick } = strip_1967::totals(&parameters, rule);
    [fx, fy, mz, stick].map(F::to_f64)
}

/// Sorted errors of `F`, `M_z` and the stick area.
fn errors<F: Float>(cases: &[(Law, [f64; 4])]) -> [Vec<f64>; 3] {
    let mut errors = [const { Vec::new() }; 3];
    for (law, exact) in cases {
        let got = totals::<F>(law);
        let error = |i: usize| (got[i] - exact[i]).abs();
        for (list, error) in errors.iter_mut().zip([error(0).max(error(1)), error(2), error(3)]) {
            assert!(error < 1e-2, "{law:?}\n exact {exact:?}\n got   {got:?}");
            list.push(error);
        }
    }
    for list in &mut errors {
        list.sort_by(f64::total_cmp);
    }
    errors
}

/// Laws with their totals by brute force.
fn cases(
    count: usize, seed: u64, next: impl Fn(&mut Random, usize) -> Law,
) -> Vec<(Law, [f64; 4])> {
    let mut random = Random::new(seed);
    (0..count)
        .map(|i| {
            let law = next(&mut random, i);
            let (exact, own) = law.totals();
            assert!(own < 1e-10, "the brute force is not converged: {own:e}, {law:?}");
            (law, exact)
        })
        .collect()
}

/// Median, 95th percentile and worst.
fn figures(errors: &[f64]) -> [f64; 3] {
    let n = errors.len();
    [errors[n / 2], errors[n * 95 / 100], errors[n - 1]]
}

/// The brute force itself, against what needs no quadrature.
#[test]
fn brute_force_has_the_limits_of_the_theory() {
    let law =
        Law { xi: 0.3, eta: 0.4, psi: 0.0, poisson_ratio: 0.28, axis_ratio: 0.7, continuous: true };
    let ([fx, fy, _, stick], error) = law.totals();
    // Section 8.15 with τ = 0.5, direction (0.6, 0.8)
    let force = 1.0 - (2.25 * 0.75_f64.sqrt() - 1.5 * 0.5_f64.acos()) / 2.0;
    assert!((fx - 0.6 * force).abs() < 1e-12 && (fy - 0.8 * force).abs() < 1e-12 && error < 1e-12);
    // Stick area: strips |Y| < √(1 − τ²), length 2 (C − τ)
    let angle = 0.5_f64.acos();
    let area = 2.0 / PI * (angle + 0.5 * angle.sin() - 2.0 * 0.5 * angle.sin());
    assert!((stick - area).abs() < 1e-12, "{stick} {area}");
}

/// Both rules and precisions, a/b .1 to 10, ν 0 to .5, |ψ| ≤ .95, a third with exact zeros.
/// `KSTRIP_CASES=100000` for more.
#[test]
fn totals_agree_with_brute_force() {
    let count = std::env::var("KSTRIP_CASES").map_or(600, |count| count.parse().unwrap());
    let cases = cases(count, 62, inside_the_theory);
    for (name, [force, moment, stick]) in
        [("f64", errors::<f64>(&cases)), ("f32", errors::<f32>(&cases))]
    {
        let [force, moment, stick] = [force, moment, stick].map(|list| figures(&list));
        println!("{name}: median, 95 %, worst of F {force:?}, Mz {moment:?}, stick {stick:?}");
        if name == "f64" {
            assert!(force[0] < 1e-12 && force[2] < 1e-8, "{force:?}");
            assert!(stick[2] < 1e-8, "{stick:?}");
        } else {
            assert!(force[2] < 2e-5 && stick[2] < 2e-5, "{force:?} {stick:?}");
        }
        assert!(moment[1] < 1e-5 && moment[2] < 5e-4, "{moment:?}");
    }
}

/// |ψ| = 1 within rounding, just below, and beyond, mostly where strips still adhere (Section
/// 8.26).
#[test]
fn totals_agree_with_brute_force_at_and_beyond_unit_spin() {
    let cases = cases(400, 63, |random, _| {
        let size = match random.bits() % 5 {
            0 => 1.0,
            1 => 1.0 + random.log_between(1e-15, 1e-6),
            2 => 1.0 - random.log_between(1e-15, 1e-6),
            3 => 1.0 - random.log_between(1e-6, 5e-2),
            _ => random.between(1.0, 3.0),
        };
        let psi = random.sign() * size;
        let mut law = sample(random, psi);
        if random.unit() < 0.8 {
            law.eta = -psi.signum() * law.eta.abs();
        }
        law
    });
    let [force, moment, stick] = errors::<f64>(&cases).map(|list| figures(&list));
    println!("median, 95 %, worst of F {force:?}, Mz {moment:?}, stick {stick:?}");
    assert!(
        force[0] < 1e-12 && force[1] < 1e-9 && force[2] < 1e-6 && stick[2] < 1e-6,
        "{force:?} {stick:?}"
    );
    assert!(moment[1] < 1e-5 && moment[2] < 5e-4, "{moment:?}");
}

/// One strip of the library is one strip of the theory: regime, κ and direction.
#[test]
fn single_strips_agree_with_the_second_implementation() {
    let mut random = Random::new(541);
    let mut adhering = 0;
    for _ in 0..100_000 {
        let psi = random.sign()
            * if random.unit() < 0.6 { random.unit() } else { random.between(1.0, 3.0) };
        let mut law = sample(&mut random, psi);
        if psi.abs() > 1.0 {
            law.eta = -psi.signum() * law.eta.abs();
        }
        let (y, c) = random.between(-1.5, 1.5).sin_cos();
        let rule = if law.continuous { SlidingRule::Continuous } else { SlidingRule::RigidSlip };
        let strip = Strip::solve(c, law.xi_bar(y), law.eta, psi, law.poisson_ratio, rule);
        match (strip.regime, law.adheres(y, c)) {
            (Regime::Adhesion { kappa, .. }, Some(expected)) => {
                adhering += 1;
                // S loses digits where η² ≈ (ψ² − 1) ξ̄²
                assert!((kappa - expected).abs() <= 4e-15 * expected, "{law:?} {y}");
            }
            (Regime::Sliding { direction_x, direction_y }, None) => {
                let (wx, wy) = law.direction(y, c);
                assert!((direction_x - wx).abs() < 1e-12 && (direction_y - wy).abs() < 1e-12);
            }
            (regime, expected) => {
                // Only where the strip is at the border of its regime may rounding decide.
                let border = [1.0 - 1e-9, 1.0 + 1e-9].map(|f| law.adheres(y, c * f).is_some());
                assert!(border[0] != border[1], "{law:?} y {y}: {regime:?}, {expected:?}");
            }
        }
    }
    assert!(adhering > 10_000);
}
