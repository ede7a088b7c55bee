//! Totals against a second implementation of the theory that shares no code with the library.

use crate::random;
use crate::theory;

use kstrip::contact::forces::StripCount;
use kstrip::strip_1967::strip::{Regime, SlidingRule, Strip};
use random::Random;
use theory::{Law, solve};

fn sample(random: &mut Random, psi: f64) -> Law {
    let parameter = |random: &mut Random| {
        if random.unit() < 0.7 {
            random.between(-1.2, 1.2)
        } else {
            random.log_between(1e-9, 1.0) * random.sign()
        }
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

/// Sorted errors of 64 strips, the largest component, and the largest error of the brute force.
fn errors(count: usize, mut next: impl FnMut(&mut Random) -> Law) -> (Vec<f64>, f64) {
    let mut random = Random::new(62);
    let mut own = 0.0_f64;
    let mut errors: Vec<f64> = (0..count)
        .map(|_| {
            let law = next(&mut random);
            let (exact, error) = law.totals();
            own = own.max(error);
            let got = solve(&law, StripCount::SixtyFour);
            let worst = (0..4).map(|i| (got[i] - exact[i]).abs()).fold(0.0, f64::max);
            assert!(worst < 2e-3, "{law:?}\n exact {exact:?}\n got   {got:?}");
            worst
        })
        .collect();
    errors.sort_by(f64::total_cmp);
    println!(
        "median {:.1e}, 95 % {:.1e}, worst {:.1e}; brute force {own:.1e}",
        errors[count / 2],
        errors[count * 95 / 100],
        errors[count - 1]
    );
    (errors, own)
}

/// The brute force itself, against what needs no quadrature.
#[test]
fn brute_force_has_the_limits_of_the_theory() {
    let law =
        Law { xi: 0.3, eta: 0.4, psi: 0.0, poisson_ratio: 0.28, axis_ratio: 0.7, continuous: true };
    let ([fx, fy, _, stick], error) = law.totals();
    // (8.15) with τ = 0.5, direction (0.6, 0.8)
    let force = 1.0 - (2.25 * 0.75_f64.sqrt() - 1.5 * 0.5_f64.acos()) / 2.0;
    assert!((fx - 0.6 * force).abs() < 1e-12 && (fy - 0.8 * force).abs() < 1e-12 && error < 1e-12);
    // Stick area: strips |Y| < √(1 − τ²), length 2 (C − τ)
    let angle = 0.5_f64.acos();
    let area = 2.0 / std::f64::consts::PI * (angle + 0.5 * angle.sin() - 2.0 * 0.5 * angle.sin());
    assert!((stick - area).abs() < 1e-12, "{stick} {area}");
}

/// Forces, moment and stick fraction for |ψ| < 1 at random creepages.
#[test]
fn sixty_four_strips_agree_with_brute_force_inside_the_theory() {
    let (errors, own) = errors(400, |random| {
        let psi = random.between(-0.999, 0.999);
        sample(random, psi)
    });
    assert!(own < 1e-11, "the brute force is not converged: {own:e}");
    // Geometric convergence of the panels; the tail is kinks narrower than the node distance.
    assert!(errors[200] < 1e-9 && errors[380] < 1e-5 && errors[399] < 5e-4);
}

/// The same beyond the theory, where strips leave the adhesion interval by the traction bound.
#[test]
fn sixty_four_strips_agree_with_brute_force_beyond_unit_spin() {
    let (errors, own) = errors(400, |random| {
        let size = if random.unit() < 0.5 {
            1.0 + random.log_between(1e-6, 0.3)
        } else {
            random.between(1.0, 3.0)
        };
        let psi = random.sign() * size;
        let mut law = sample(random, psi);
        // Only opposite signs of η and ψ leave any adhesion.
        law.eta = -psi.signum() * law.eta.abs();
        law
    });
    assert!(own < 1e-10, "the brute force is not converged: {own:e}");
    // κ ends in a square root where S = 0, which no panel is cut at
    assert!(errors[200] < 1e-6 && errors[380] < 5e-5 && errors[399] < 5e-4);
}

/// |ψ| = 1 within rounding and |ψ| just below: S loses the spin, κ does not.
#[test]
fn sixty_four_strips_agree_with_brute_force_at_unit_spin() {
    let (errors, own) = errors(200, |random| {
        let distance = match random.bits() % 4 {
            0 => 0.0,
            1 => random.log_between(1e-15, 1e-6),
            2 => -random.log_between(1e-15, 1e-6),
            _ => -random.log_between(1e-6, 1e-3),
        };
        let psi = random.sign() * (1.0 + distance);
        let mut law = sample(random, psi);
        if random.unit() < 0.8 {
            law.eta = -psi.signum() * law.eta.abs();
        }
        law
    });
    assert!(own < 1e-10, "the brute force is not converged: {own:e}");
    assert!(errors[100] < 1e-8 && errors[190] < 2e-5 && errors[199] < 5e-4);
}

/// Few strips: the errors fall with the count, and even four strips are no nonsense.
#[test]
fn error_against_brute_force_falls_with_the_strip_count() {
    let mut random = Random::new(4);
    let cases: Vec<_> = (0..150)
        .map(|_| {
            let psi = random.between(-0.95, 0.95);
            let law = sample(&mut random, psi);
            (law, law.totals().0)
        })
        .collect();
    let mut before = f64::INFINITY;
    // Four strips give the shape of the curve only.
    for (count, worst_allowed) in theory::COUNTS.into_iter().zip([0.35, 0.1, 0.02, 0.01, 1e-3]) {
        let mut errors: Vec<f64> = cases
            .iter()
            .map(|(law, exact)| {
                let got = solve(law, count);
                // The moment is in units of √(ab); its natural size is the larger semi-axis
                let arm = law.axis_ratio.sqrt().max(1.0 / law.axis_ratio.sqrt());
                let error = |i: usize| (got[i] - exact[i]).abs();
                error(0).max(error(1)).max(error(2) / arm)
            })
            .collect();
        errors.sort_by(f64::total_cmp);
        let (median, worst) = (errors[75], errors[149]);
        println!("{:>2} strips: median {median:.1e}, worst {worst:.1e}", count as i32);
        assert!(median < 0.5 * before, "{count:?}: median {median:e} after {before:e}");
        assert!(worst < worst_allowed, "{count:?}: worst {worst:e}");
        before = median;
    }
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
                assert!((kappa - expected).abs() <= 1e-7 * expected, "{law:?} {y}");
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
