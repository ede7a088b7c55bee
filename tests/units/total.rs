//! What must hold whatever the constants are, and that the fit has the same formulas.

use kstrip_testing::prelude::*;

fn at(g: f64, nu: f64, v: [f64; 3]) -> [f64; 3] {
    let Totals { fx, fy, mz, .. } =
        Total::new(g, nu, &LinearCoefficients::at(g, nu)).mean_totals(v);
    [fx, fy, mz]
}

/// Printed by `fit/fit_total.py`, which evaluates the same formulas in Python.
#[test]
fn agrees_with_the_fit() {
    let cases: [(f64, f64, [f64; 3], [f64; 3]); 14] = include!("total_numbers.in");
    for (g, nu, v, expected) in cases {
        for (value, expected) in at(g, nu, v).into_iter().zip(expected) {
            assert_relative_eq!(value, expected, max_relative = 1e-12, epsilon = 1e-14);
        }
    }
}

/// Beyond axis ratios of 1/1000 and 1000 the formulas are those of these.
#[test]
fn axis_ratios_count_up_to_their_limits() {
    for limit in [1e-3_f64, 1e3] {
        let linear = LinearCoefficients::at(limit, 0.28);
        let at = |power: f64| {
            let ratio = limit.powf(power);
            let Totals { fx, fy, mz, .. } =
                Total::new(ratio, 0.28, &linear).mean_totals([0.3, 0.2, 0.05]);
            [fx, fy, mz]
        };
        assert_eq!(at(1.2), at(1.0), "{limit}");
        assert_ne!(at(0.99), at(1.0), "{limit}");
    }
}

/// Central differences from both sides agree better and better with smaller steps: no kink where
/// creepages or spin change sign, nor where the saturation curve ends.
#[test]
fn is_smooth() {
    let mut random = Random::new(3);
    let mut spread = || match random.bits() % 8 {
        0 => 0.0,
        _ => random.sign() * random.log_between(1e-2, 3.0),
    };
    let mut shapes = Random::new(4);
    for _ in 0..20_000 {
        let (g, nu) = (shapes.log_between(0.1, 10.0), shapes.between(0.0, 0.5));
        let v = [spread(), spread(), spread()];
        for axis in 0..3 {
            let bend = |h: f64| {
                let shifted = |h: f64| {
                    let mut v = v;
                    v[axis] += h;
                    at(g, nu, v)
                };
                let (low, middle, high) = (shifted(-h), shifted(0.0), shifted(h));
                (0..3).map(|i| (high[i] - 2.0 * middle[i] + low[i]).abs() / h).fold(0.0, f64::max)
            };
            // change of slope over h: proportional to h, up to rounding, unless there is a kink
            let (coarse, fine) = (bend(1e-4), bend(1e-6));
            assert!(fine < 0.05 * coarse + 1e-3, "{g} {nu} {v:?} {axis}: {coarse} {fine}");
        }
    }
}

/// Derivatives are numbers at any creepage, in single precision too, and in full sliding those of
/// double precision.
#[test]
fn derivatives_are_finite_at_any_creepage() {
    let gradients = |g: f64, v: [f64; 3]| {
        let single = LinearCoefficients::at(g as f32, 0.28);
        let v = [0, 1, 2].map(|i| Dual::<f32, 3>::input(v[i] as f32, i));
        let t = Total::new(g as f32, 0.28, &single).mean_totals(v);
        [t.fx, t.fy, t.mz].map(|force| force.gradient)
    };
    for size in [1e-6, 1.0, 30.0, 100.0, 1e3, 3e3, 1e4, 1e5, 1e8, 1e15, 1e30] {
        for g in [0.05, 0.3, 1.0, 3.0, 20.0] {
            for [x, y, phi] in [
                [1.0, 0.087, 1e-4],
                [1.0, 0.0, 0.0],
                [0.0, -1.0, 0.0],
                [0.3, 0.3, 1.0],
                [0.0, 0.0, 1.0],
                [1.0, -1.0, 0.01],
            ] {
                let v = [size * x, size * y, size * phi];
                let all = gradients(g, v);
                assert!(all.as_flattened().iter().all(|d| d.is_finite()), "{g} {v:?}: {all:?}");
            }
        }
    }
    let double = LinearCoefficients::at(0.64, 0.28);
    let v = [3e3, 261.0, 0.3];
    let dual = [0, 1, 2].map(|i| Dual::<f64, 3>::input(v[i], i));
    let t = Total::new(0.64, 0.28, &double).mean_totals(dual);
    for (single, force) in gradients(0.64, v).iter().zip([t.fx, t.fy]) {
        for (single, double) in single.iter().zip(force.gradient) {
            assert!((f64::from(*single) - double).abs() < 1e-4 / 3e3, "{single} {double}");
        }
    }
}
