//! What must hold whatever the constants are, and that the fit has the same formulas.

use approx::assert_relative_eq;
use kstrip::contact::forces::Totals;
use kstrip::linear::LinearCoefficients;
use kstrip::number::dual::Dual;
use kstrip::total::Total;

fn at(g: f64, nu: f64, v: [f64; 3]) -> [f64; 3] {
    let Totals { fx, fy, mz, .. } = Total::new(g, nu, &LinearCoefficients::at(g, nu)).totals(v);
    [fx, fy, mz]
}

/// Numbers between 0 and 1, the same in every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Both signs, evenly spread over the logarithm between two powers of ten; one in eight is zero.
    fn spread(&mut self, low: f64, high: f64) -> f64 {
        let size = 10_f64.powf(low + (high - low) * self.next());
        match (self.next() * 8.0) as u32 {
            0 => 0.0,
            1..=3 => -size,
            _ => size,
        }
    }
}

/// Printed by `fit/fit_total.py`, which evaluates the same formulas in Python.
#[test]
fn agrees_with_the_fit() {
    for (g, nu, v, expected) in [
        (1.0, 0.28, [0.1, 0.0, 0.0], [0.36923079240341944, 0.0, 0.0]),
        (
            1.0,
            0.28,
            [0.1, -0.05, 0.2],
            [0.3175812336722301, 0.12403686533136646, 0.20569784301075963],
        ),
        (1.0, 0.28, [-0.3, 0.2, 0.7], [-0.421471651535518, 0.7027871602779514, 0.2754787097627695]),
        (
            0.1,
            0.0,
            [0.05, 0.3, 0.1],
            [0.08829396909231568, 0.6056150763456796, 0.39073109548131935],
        ),
        (0.1, 0.5, [0.0, -0.2, 2.0], [0.0, 0.0477796575400405, 1.2000203107571779]),
        (10.0, 0.28, [0.0, 0.0, 0.09], [0.0, 0.8875557142052369, 0.2478771002166103]),
        (
            10.0,
            0.28,
            [0.05, -0.22, 0.18],
            [0.29852280356624306, 0.134871349716836, 1.080805776151635],
        ),
        (5.0, 0.1, [0.0, 0.1, -0.2], [0.0, -0.526587466134397, -0.49740183697692375]),
        (
            0.3,
            0.4,
            [3.0, -2.0, 1.0],
            [0.8237737008227396, -0.5547291037430355, 0.11698309144050821],
        ),
        (
            2.0,
            0.25,
            [0.0001, 0.0002, -0.0001],
            [0.0005093583965598906, 0.0007181110608360989, -0.0006070534392840828],
        ),
        (0.02, 0.3, [0.2, 0.2, 0.5], [0.08387553970140019, 0.2186632334794266, 2.5566022670629738]),
        (
            60.0,
            0.3,
            [0.01, 0.02, 0.03],
            [0.16856705271957131, 0.6967488164969886, 1.5020169472356348],
        ),
        (1.0, 0.5, [0.0, 0.0, 40.0], [0.0, 0.01811239579717903, 0.5795663475235916]),
        (
            20.0,
            0.3,
            [30.0, 90.0, 50.0],
            [0.3983810280137383, 0.5416134288876121, 1.1534145916093712],
        ),
    ] {
        for (value, expected) in at(g, nu, v).into_iter().zip(expected) {
            assert_relative_eq!(value, expected, max_relative = 1e-12, epsilon = 1e-14);
        }
    }
}

/// Relative error against the linear theory vanishes with the creepage, for each of the three outputs.
#[test]
fn starts_as_the_linear_theory() {
    for g in [0.01, 0.1, 0.5, 1.0, 3.0, 10.0, 100.0] {
        for nu in [0.0, 0.28, 0.5] {
            let LinearCoefficients { c11, c22, c23, c33 } = LinearCoefficients::at(g, nu);
            for (vx, vy, phi) in
                [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.3, -0.5, 0.7)]
            {
                let [vx, vy, phi] = [vx, vy, phi].map(|v| 1e-9 * v);
                let linear = [c11 * vx, c22 * vy + c23 * phi, c33 * phi - c23 * vy];
                for (value, linear) in at(g, nu, [vx, vy, phi]).into_iter().zip(linear) {
                    assert_relative_eq!(value, linear, max_relative = 1e-4);
                }
            }
        }
    }
}

/// `F → μ N` along the rigid slip, `Mz → 0`.
#[test]
fn ends_as_full_sliding() {
    for g in [0.01, 0.1, 1.0, 10.0, 100.0] {
        for nu in [0.0, 0.28, 0.5] {
            for angle in [0.0_f64, 0.4, 1.0, 1.57, 2.5] {
                for phi in [0.0, 0.5, -3.0] {
                    let v = 1e7;
                    let [fx, fy, mz] = at(g, nu, [v * angle.cos(), v * angle.sin(), phi]);
                    assert_relative_eq!(fx, angle.cos(), epsilon = 1e-4);
                    assert_relative_eq!(fy, angle.sin(), epsilon = 1e-4);
                    assert!(mz.abs() < 1e-2, "{g} {nu} {angle} {phi}: {mz}");
                }
            }
        }
    }
}

#[test]
fn keeps_the_symmetries_bounds_and_dissipation() {
    let mut random = Numbers(7);
    for _ in 0..200_000 {
        let g = 10_f64.powf(6.0 * random.next() - 3.0);
        let nu = 0.5 * random.next();
        let v @ [vx, vy, phi] =
            [random.spread(-6.0, 6.0), random.spread(-6.0, 6.0), random.spread(-6.0, 6.0)];
        let [fx, fy, mz] = at(g, nu, v);
        assert!(fx.hypot(fy) <= 1.0 + 1e-9 && mz.is_finite(), "{g} {nu} {v:?}");
        let power = fx * vx + fy * vy + mz * phi;
        let size = (fx * vx).abs() + (fy * vy).abs() + (mz * phi).abs();
        assert!(power >= -1e-13 * size, "{g} {nu} {v:?}: {power} of {size}");
        assert_eq!(at(g, nu, [-vx, vy, phi]), [-fx, fy, mz]);
        assert_eq!(at(g, nu, [-vx, -vy, -phi]), [-fx, -fy, -mz]);
    }
}

/// The moment of the fitted range is below that of the largest arm; far outside it stays bounded.
#[test]
fn moment_is_bounded() {
    let mut random = Numbers(11);
    for _ in 0..200_000 {
        let g = 10_f64.powf(2.0 * random.next() - 1.0);
        let nu = 0.5 * random.next();
        let v = [random.spread(-3.0, 3.0), random.spread(-3.0, 3.0), random.spread(-3.0, 3.0)];
        let [.., mz] = at(g, nu, v);
        assert!(mz.abs() < 2.0 * g.sqrt().max(1.0 / g.sqrt()), "{g} {nu} {v:?}: {mz}");
    }
}

/// Central differences from both sides agree better and better with smaller steps: no kink where
/// creepages or spin change sign, nor where the saturation curve ends.
#[test]
fn is_smooth() {
    let mut random = Numbers(3);
    for _ in 0..20_000 {
        let g = 10_f64.powf(2.0 * random.next() - 1.0);
        let nu = 0.5 * random.next();
        let v = [random.spread(-2.0, 0.5), random.spread(-2.0, 0.5), random.spread(-2.0, 0.5)];
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

#[test]
fn holds_for_hard_inputs() {
    for g in [1e-300, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e300] {
        for v in [0.0, 5e-324, 1e-300, 1e-150, 1e-30, 1e30, 1e150, 1e300] {
            for [x, y, z] in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, -1.0, 1.0]] {
                let [fx, fy, mz] = at(g, 0.3, [v * x, v * y, v * z]);
                assert!(fx.hypot(fy) <= 1.0 + 1e-9 && mz.is_finite(), "{g} {v} {fx} {fy} {mz}");
            }
        }
    }
    assert_eq!(at(1.0, 0.3, [0.0; 3]), [0.0; 3]);
}

#[test]
fn single_precision_follows() {
    let mut random = Numbers(5);
    for _ in 0..100_000 {
        let g = 10_f64.powf(2.0 * random.next() - 1.0) as f32;
        let nu = 0.5 * random.next() as f32;
        let v = [0; 3].map(|_| random.spread(-3.0, 1.0) as f32);
        let single = Total::new(g, nu, &LinearCoefficients::at(g, nu)).totals(v);
        let double = at(g.into(), nu.into(), v.map(f64::from));
        for (single, double) in [single.fx, single.fy, single.mz].into_iter().zip(double) {
            assert_relative_eq!(f64::from(single), double, epsilon = 2e-5);
        }
    }
    for v in [1e-38_f32, 1e-30, 1e12, 1e30, 3e38] {
        for g in [1e-30_f32, 0.1, 1.0, 10.0, 1e30] {
            let f = Total::new(g, 0.5, &LinearCoefficients::at(g, 0.5)).totals([v, -v, v]);
            assert!(f.fx.hypot(f.fy) <= 1.00001 && f.mz.is_finite(), "{g} {v} {f:?}");
        }
    }
}

/// Derivatives are numbers at any creepage, in single precision too, and in full sliding those of double precision.
#[test]
fn derivatives_are_finite_at_any_creepage() {
    let gradients = |g: f64, v: [f64; 3]| {
        let single = LinearCoefficients::at(g as f32, 0.28);
        let v = [0, 1, 2].map(|i| Dual::<f32, 3>::input(v[i] as f32, i));
        let t = Total::new(g as f32, 0.28, &single).totals(v);
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
    let t = Total::new(0.64, 0.28, &double).totals(dual);
    for (single, force) in gradients(0.64, v).iter().zip([t.fx, t.fy]) {
        for (single, double) in single.iter().zip(force.gradient) {
            assert!((f64::from(*single) - double).abs() < 1e-4 / 3e3, "{single} {double}");
        }
    }
}
