//! Strips that follow the slip: bounds, limits, slopes, and the same bits in any registers.

use approx::assert_abs_diff_eq;
use core::f64::consts::PI;
use core::fmt::Debug;
use kstrip::contact::forces::{StripCount, Totals};
use kstrip::internals;
use kstrip::linear::LinearCoefficients;
use kstrip::number::dual::Dual;
use kstrip::number::{Float, Number};
use kstrip::strip::{Distribution, EllipseStrips, Flexibilities, Rule, Seen, StripGeometry};

fn prepared(g: f64, nu: f64) -> EllipseStrips<f64> {
    EllipseStrips::new(g, nu, &LinearCoefficients::at(g, nu), StripCount::Sixteen)
}

fn law([g, nu, vx, vy, phi]: [f64; 5], factors: [f64; 2]) -> Distribution<f64> {
    Flexibilities::new(g, nu, &LinearCoefficients::at(g, nu), factors).see([vx, vy, phi])
}

const COUNTS: [StripCount; 5] = [
    StripCount::Four,
    StripCount::Eight,
    StripCount::Sixteen,
    StripCount::ThirtyTwo,
    StripCount::SixtyFour,
];

fn totals([g, nu, vx, vy, phi]: [f64; 5]) -> [f64; 4] {
    let t = prepared(g, nu).totals([vx, vy, phi]);
    [t.fx, t.fy, t.mz, t.stick]
}

#[test]
fn agrees_with_the_fitting_script() {
    // fit/fit_strip.py --numbers: a/b, ν, vx, vy, φ; fx, fy, mz, stick
    let cases: [([f64; 5], [f64; 4]); 24] = include!("numbers.in");
    for (case, expected) in cases {
        let found = totals(case);
        for (value, expected) in found.iter().zip(&expected) {
            assert!((value - expected).abs() < 1e-12, "{case:?}: {found:?}, {expected:?}");
        }
    }
}

/// Contacts and creepages of every kind, from a small generator.
fn cases(count: u64) -> impl Iterator<Item = [f64; 5]> {
    (1..=count).map(|k| {
        // Weyl sequences: no seed, no state
        let u = |x: f64| (k as f64 * x).fract();
        let size = 10_f64.powf(4.0 * u(0.754_877_666) - 3.0);
        let angle = 2.0 * PI * u(0.569_840_291);
        let spin = if k % 5 == 0 { 0.0 } else { 10_f64.powf(4.0 * u(0.324_717_957) - 3.0) };
        [
            10_f64.powf(2.0 * u(0.618_033_989) - 1.0),
            0.5 * u(0.414_213_562),
            size * angle.cos(),
            size * angle.sin(),
            if k % 2 == 0 { spin } else { -spin },
        ]
    })
}

const GEOMETRY: StripGeometry<f64> =
    StripGeometry { y: 0.3, half_length: 0.9, bound: 0.9, width: 0.0 };

#[test]
fn rules_integrate_the_ellipse() {
    for count in COUNTS {
        let rule = Rule::<f64>::new(count);
        let sum = |f: fn([f64; 3]) -> f64| rule.places().map(f).sum::<f64>();
        let n = count as i32;
        assert_abs_diff_eq!(sum(|[_, _, w]| w), 2.0, epsilon = 1e-15 * f64::from(n));
        assert_abs_diff_eq!(sum(|[_, c, w]| 0.75 * c * c * w), 1.0, epsilon = 1e-15 * f64::from(n));
        // ∫ Y⁴ = 2/5: two Gauss nodes on each half are exact for cubics only
        let fourth = sum(|[y, _, w]| w * y * y * y * y);
        assert_abs_diff_eq!(fourth, 0.4, epsilon = if n == 4 { 0.012 } else { 1e-14 });
        for [y, c, _] in rule.places() {
            assert_abs_diff_eq!(y * y + c * c, 1.0, epsilon = 1e-15);
        }
        assert!(rule.places().zip(rule.places().skip(1)).all(|([a, ..], [b, ..])| a < b));
        assert!((rule.stretch - 1.0).abs() < 0.02 && (rule.lever - 1.0).abs() < 0.08);
    }
}

/// All four of Kalker's slopes, for every strip count, as the derivatives at rest.
#[test]
fn slopes_at_rest_are_kalkers() {
    for g in [0.03, 0.1, 0.5, 1.0, 3.0, 10.0, 40.0] {
        for nu in [0.0, 0.28, 0.5] {
            for count in COUNTS {
                let c = LinearCoefficients::at(g, nu);
                let v = [0, 1, 2].map(|i| Dual::<f64, 3>::input(0.0, i));
                let t = EllipseStrips::new(g, nu, &c, count).totals(v);
                let expected = [[c.c11, 0.0, 0.0], [0.0, c.c22, c.c23], [0.0, -c.c23, c.c33]];
                let size = 1.0 + c.c11 + c.c22 + c.c23 + c.c33;
                for (force, expected) in [t.fx, t.fy, t.mz].iter().zip(expected) {
                    for (slope, expected) in force.gradient.iter().zip(expected) {
                        assert_abs_diff_eq!(*slope, expected, epsilon = 1e-12 * size);
                    }
                }
            }
        }
    }
}

#[test]
fn zero_creepage_gives_zero() {
    for [g, nu, zero] in [[1.0, 0.28, 0.0], [10.0, 0.5, -0.0]] {
        let [fx, fy, mz, stick] = totals([g, nu, zero, 0.0, zero]);
        assert!(fx == 0.0 && fy == 0.0 && mz == 0.0);
        assert_abs_diff_eq!(stick, 1.0, epsilon = 1e-12);
    }
}

#[test]
fn symmetries_are_exact() {
    for [g, nu, vx, vy, phi] in cases(300) {
        let [fx, fy, mz, stick] = totals([g, nu, vx, vy, phi]);
        let reversed = totals([g, nu, -vx, -vy, -phi]);
        let mirrored = totals([g, nu, -vx, vy, phi]);
        for (value, other) in [-fx, -fy, -mz, stick].iter().zip(reversed) {
            assert_abs_diff_eq!(*value, other, epsilon = 1e-14);
        }
        for (value, other) in [-fx, fy, mz, stick].iter().zip(mirrored) {
            assert_abs_diff_eq!(*value, other, epsilon = 1e-13);
        }
    }
}

#[test]
fn bounded_by_friction() {
    for case in cases(2000) {
        let solution = law(case, [1.0, 1.0]);
        let [fx, fy, mz, stick] = totals(case);
        assert!(fx.hypot(fy) <= 1.0 + 1e-12, "{case:?}");
        // (3/4) ∫ (x̂² + ŷ²)^½ over an ellipse of axis ratio up to 10
        assert!(mz.abs() < 1.5 && (0.0..=1.0 + 1e-12).contains(&stick), "{case:?}");
        for i in 0..=40 {
            let p = solution.traction(&GEOMETRY, -1.0 + 0.05 * f64::from(i));
            assert!(p.x.hypot(p.y) <= 1.0 + 1e-12, "{case:?}");
            assert!(p.slip_x * p.x + p.slip_y * p.y >= 0.0, "{case:?}");
        }
    }
}

#[test]
fn any_size_of_creepage_is_finite() {
    for size in [1e-320, 1e-200, 1e-30, 1e-8, 1e4, 1e9, 1e200, 1.7e308] {
        for [vx, vy, phi] in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 1.0, -1.0]]
        {
            for g in [1e-9, 0.01, 1.0, 100.0, 1e9] {
                let case = [g, 0.3, size * vx, size * vy, size * phi];
                let [fx, fy, mz, stick] = totals(case);
                assert!(fx.hypot(fy) <= 1.0 + 1e-12, "{case:?}");
                assert!(mz.is_finite() && (0.0..=1.0 + 1e-12).contains(&stick), "{case:?}");
                let p = law(case, [1.0, 1.0]).traction(&GEOMETRY, 0.2);
                assert!(p.x.hypot(p.y) <= 1.0 + 1e-12 && p.slip_x.is_finite(), "{case:?}");
            }
        }
    }
}

/// Full sliding: each point's traction has the direction of the local rigid slip.
#[test]
fn large_creepage_slides_along_the_rigid_slip() {
    for g in [0.1, 0.5, 1.0, 3.0, 10.0_f64] {
        for [vx, vy, phi] in [[3.0, 1.0, 0.0], [0.5, -2.0, 0.4], [1.0, 1.0, 2.0]] {
            let v = [vx, vy, phi].map(|v| 3000.0 * v);
            let solution = law([g, 0.28, v[0], v[1], v[2]], [1.0, 1.0]);
            let (mut error, mut count) = (0.0, 0.0);
            for [y, c, _] in Rule::<f64>::new(StripCount::Sixteen).places() {
                let geometry = StripGeometry { y, half_length: c, bound: c, width: 0.0 };
                for k in -9..=9 {
                    let x = f64::from(k) / 10.0;
                    let p = solution.traction(&geometry, x);
                    let (sx, sy) = (v[0] - v[2] * y / g.sqrt(), v[1] + v[2] * g.sqrt() * c * x);
                    error += 1.0 - (p.x * sx + p.y * sy) / sx.hypot(sy);
                    count += 1.0;
                }
            }
            assert!(error / count < 0.01, "{g} {v:?}: {}", error / count);
        }
    }
    // without spin the whole friction bound
    let [fx, fy, mz, stick] = totals([2.0, 0.28, 300.0, -400.0, 0.0]);
    assert_abs_diff_eq!(fx, 0.6, epsilon = 1e-4);
    assert_abs_diff_eq!(fy, -0.8, epsilon = 1e-4);
    assert!(mz.abs() < 1e-3 && stick < 1e-6, "{mz} {stick}");
}

/// Steps of 1e-7 between two cases never move a result by more than a slope of 400 allows: no jumps above 4e-5.
#[test]
fn forces_are_continuous() {
    for (case, other) in cases(40).zip(cases(80).skip(40)) {
        for part in 0..200 {
            let at = |t: f64| {
                let mut point = [0.0; 5];
                for ((p, a), b) in point.iter_mut().zip(case).zip(other) {
                    *p = a + t * (b - a);
                }
                totals(point)
            };
            let t = f64::from(part) / 200.0;
            let length = case.iter().zip(other).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
            for (before, after) in at(t).iter().zip(at(t + 1e-7)) {
                assert!(
                    (before - after).abs() < 1e-7 * (1.0 + length) * 400.0,
                    "{case:?} {other:?} {t}"
                );
            }
        }
    }
}

/// The derivatives of the dual numbers are those of the function, and do not jump.
#[test]
fn forces_are_once_differentiable() {
    for [g, nu, vx, vy, phi] in cases(400) {
        let at = |v: [f64; 3]| {
            let v = [Dual::<f64, 3>::input(v[0], 0), Dual::input(v[1], 1), Dual::input(v[2], 2)];
            prepared(g, nu).totals(v)
        };
        let here = at([vx, vy, phi]);
        let moved = |h: f64| at([vx + h, vy + h, phi + h]);
        let size = vx.abs() + vy.abs() + phi.abs();
        let h = 1e-7 * size;
        let (near, there, back) = (moved(1e-3 * h), moved(h), moved(-h));
        let all = [
            (here.fx, near.fx, there.fx, back.fx),
            (here.fy, near.fy, there.fy, back.fy),
            (here.mz, near.mz, there.mz, back.mz),
        ];
        for (a, b, c, d) in all {
            let slope: f64 = a.gradient.iter().sum();
            let size = a.gradient.iter().map(|d| d.abs()).sum::<f64>() + 1e-3;
            let found = (c.value - d.value) / (2.0 * h);
            // (rounding of the forces over the step)
            let allowed = 1e-4 * size + 1e-13 / h;
            assert!((found - slope).abs() < allowed, "{g} {nu} {vx} {vy} {phi}: {found} {slope}");
            for (d, e) in a.gradient.iter().zip(b.gradient) {
                assert!((d - e).abs() < 1e-4 * size, "{g} {nu} {vx} {vy} {phi}: {d} {e}");
            }
        }
    }
}

/// Friction never drives: at least a fifth of what linear theory says, over `√(1 + n²)`.
#[test]
fn power_is_never_negative() {
    let mut least = 1.0_f64;
    for k in 1..=40_000_u64 {
        let u = |x: f64| (k as f64 * x).fract();
        let g = 10_f64.powf(2.8 * u(0.618_033_989) - 1.4);
        let nu = 0.5 * u(0.414_213_562);
        let size = 10_f64.powf(4.0 * u(0.754_877_666) - 3.0);
        let angle = 2.0 * PI * u(0.569_840_291);
        let part = [0.0, 1e-3, 0.1, 1.0][k as usize % 4];
        let phi = 10_f64.powf(3.0 * u(0.324_717_957) - 2.0) / g.sqrt();
        let v = [part * size * angle.cos(), part * size * angle.sin(), phi];
        let c = LinearCoefficients::at(g, nu);
        let t = prepared(g, nu).totals(v);
        let linear = [c.c11 * v[0], c.c22 * v[1], c.c33 * phi];
        let whole: f64 = linear.iter().zip(v).map(|(k, v)| k * v).sum();
        let n2 = linear.iter().map(|k| k * k).sum::<f64>() + (c.c23 * phi).powi(2);
        let power = t.fx * v[0] + t.fy * v[1] + t.mz * v[2];
        least = least.min(power * (1.0 + n2).sqrt() / whole);
        let single = EllipseStrips::new(
            g as f32,
            nu as f32,
            &LinearCoefficients::at(g as f32, nu as f32),
            StripCount::Sixteen,
        );
        let v = v.map(|v| v as f32);
        let t = single.totals(v);
        assert!(t.fx * v[0] + t.fy * v[1] + t.mz * v[2] >= 0.0, "{g} {nu} {v:?} {t:?}");
    }
    assert!(least > 0.19, "{least}");
}

/// Exact for creepage without spin: Carter's half-ellipses.
#[test]
fn pure_creepage_gives_half_ellipses() {
    let solution = law([0.1, 0.28, 0.1, 0.0, 0.0], [1.0, 1.0]);
    let geometry = StripGeometry { y: 0.0, half_length: 1.0, bound: 1.0, width: 0.0 };
    let two_kappa = solution.strip(&geometry).0.x;
    for i in 1..40 {
        let x = 1.0 - 0.05 * f64::from(i);
        let carter =
            if 1.0 + x > two_kappa { 1.0 - (1.0 - two_kappa / (1.0 + x)).sqrt() } else { 1.0 };
        let p = solution.traction(&geometry, x);
        // (the cut is rounded just behind the separatrix)
        let allowed = if p.slips { 0.06 } else { 1e-12 };
        assert_abs_diff_eq!(p.x, carter, epsilon = allowed);
        assert_eq!(p.slips, 1.0 + x < two_kappa);
        assert_eq!(p.slip_x > 0.0, p.slips);
    }
}

#[test]
fn strips_add_up_to_the_contact() {
    for case in cases(100) {
        let [g, nu, vx, vy, phi] = case;
        let mut sums = [0.0; 4];
        prepared(g, nu).each([vx, vy, phi], |strip, area| {
            let own = [strip.fx, strip.fy, strip.mz, area * strip.stick];
            sums.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
        });
        for (sum, total) in sums.iter().zip(totals(case)) {
            assert_abs_diff_eq!(*sum, total, epsilon = 1e-14);
        }
    }
}

#[test]
fn strip_counts_converge() {
    let distance = |count| {
        let distances = cases(500).map(|[g, nu, vx, vy, phi]| {
            let c = LinearCoefficients::at(g, nu);
            let at = |count| EllipseStrips::new(g, nu, &c, count).totals([vx, vy, phi]);
            let (a, b) = (at(count), at(StripCount::SixtyFour));
            (a.fx - b.fx).hypot(a.fy - b.fy)
        });
        distances.sum::<f64>() / 500.0
    };
    let [four, eight, sixteen, thirty_two, _] = COUNTS.map(distance);
    let errors = [four, eight, sixteen, thirty_two];
    for (error, allowed) in errors.iter().zip([0.02, 0.006, 0.002, 0.0007]) {
        assert!(*error < allowed, "{errors:?}");
    }
}

#[test]
fn any_strips_follow_the_same_law() {
    for [g, nu, vx, vy, phi] in cases(50) {
        let prepared = prepared(g, nu);
        let rule = Rule::<f64>::new(StripCount::Sixteen);
        let law = law([g, nu, vx, vy, phi], [rule.stretch, rule.lever]);
        let mut seen = [(Seen { x: 0.0, y: 0.0, spread: 0.0, start: 1.0 }, 0.0); 16];
        let mut loads = [0.0; 16];
        for (i, [y, c, width]) in rule.places().enumerate() {
            seen[i] = law.strip(&StripGeometry { y, half_length: c, bound: c, width });
            loads[i] = 0.75 * c * c * width;
        }
        let (mut fx, mut fy) = (0.0, 0.0);
        for (k, eight) in seen.as_chunks::<8>().0.iter().enumerate() {
            let inner =
                [0, 1, 2, 3, 4, 5, 6, 7].map(|i| ((8 * k + i).min(15 - 8 * k - i) % 2) as f64);
            for (i, found) in internals::eight_strips(eight, inner).iter().enumerate() {
                fx += loads[8 * k + i] * found.fx;
                fy += loads[8 * k + i] * found.fy;
            }
        }
        let (mut sum_x, mut sum_y) = (0.0, 0.0);
        prepared.each([vx, vy, phi], |strip, _| {
            (sum_x, sum_y) = (sum_x + strip.fx, sum_y + strip.fy);
        });
        // (where nothing was moved for the power's sake)
        if phi == 0.0 || vx.hypot(vy) > phi.abs() {
            assert_abs_diff_eq!(fx, sum_x, epsilon = 1e-12);
            assert_abs_diff_eq!(fy, sum_y, epsilon = 1e-12);
        }
    }
}

#[test]
fn single_precision_agrees() {
    for [g, nu, vx, vy, phi] in cases(500) {
        let t = totals([g, nu, vx, vy, phi]);
        let [g, nu, vx, vy, phi] = [g, nu, vx, vy, phi].map(|x| x as f32);
        let c = LinearCoefficients::at(g, nu);
        let s = EllipseStrips::new(g, nu, &c, StripCount::Sixteen).totals([vx, vy, phi]);
        for (value, expected) in [s.fx, s.fy, s.mz].iter().zip(t) {
            assert_abs_diff_eq!(f64::from(*value), expected, epsilon = 2e-4);
        }
    }
}

#[test]
fn any_size_of_creepage_is_finite_in_single_precision() {
    for size in [1e-38, 1e-8, 1.0, 1e4, 1e9, 1e38_f32] {
        for [vx, vy, phi] in
            [[1.0, 0.0, 0.0], [0.1, -0.05, 1.0], [0.0, 0.0, 1.0], [-1.0, 1.0, -1.0]]
        {
            for g in [1e-9, 1e-6, 0.01, 1.0, 100.0, 1e6, 1e9_f32] {
                for nu in [0.0, 0.5] {
                    let c = LinearCoefficients::at(g, nu);
                    let v = [size * vx, size * vy, size * phi];
                    let solution = Flexibilities::new(g, nu, &c, [1.0, 1.0]).see(v);
                    let t = EllipseStrips::new(g, nu, &c, StripCount::Sixteen).totals(v);
                    assert!(t.fx.hypot(t.fy) <= 1.0 + 1e-5, "{size} {g} {nu} {t:?}");
                    assert!(t.mz.is_finite() && (0.0..=1.00001).contains(&t.stick), "{t:?}");
                    let geometry =
                        StripGeometry { y: 0.3, half_length: 0.9, bound: 0.9, width: 0.0 };
                    for place in [-1.0, -0.99, 0.2, 0.999, 1.0] {
                        let p = solution.traction(&geometry, place);
                        assert!(p.x.hypot(p.y) <= 1.0 + 1e-5, "{size} {g} {nu} {place} {p:?}");
                        assert!(p.slip_x.is_finite() && p.slip_y.is_finite(), "{size} {g} {p:?}");
                    }
                }
            }
        }
    }
}

/// Differences of sixth order, where no strip comes near a change of formula: the derivatives to 1e-7.
#[test]
fn derivatives_are_those_of_differences() {
    let (mut tight, mut worst) = (0, (0.0_f64, [0.0; 5]));
    for case in cases(1000) {
        let [g, nu, vx, vy, phi] = case;
        let v = [Dual::<f64, 3>::input(vx, 0), Dual::input(vy, 1), Dual::input(phi, 2)];
        let totals = prepared(g, nu).totals(v);
        // (what depends on the size of the spin is rounded over 0.03 of its linear force)
        let h = (2e-4 * (vx.abs() + vy.abs() + phi.abs())).min(1e-4);
        for k in 0..3 {
            let at = |n: f64| {
                let mut v = [vx, vy, phi];
                v[k] += n * h;
                let t = prepared(g, nu).totals(v);
                [t.fx, t.fy, t.mz]
            };
            let points = [1.0, 2.0, 3.0].map(|n| (at(n), at(-n)));
            for (i, total) in [totals.fx, totals.fy, totals.mz].iter().enumerate() {
                let d = [0, 1, 2].map(|n| points[n].0[i] - points[n].1[i]);
                let slope = (45.0 * d[0] - 9.0 * d[1] + d[2]) / (60.0 * h);
                let size = total.gradient.iter().fold(1e-3, |size: f64, d| size.max(d.abs()));
                let error = (slope - total.gradient[k]).abs() / size;
                // second derivatives jump where a strip's bound is met
                if error < 1e-7 {
                    tight += 1;
                }
                if error > worst.0 {
                    worst = (error, case);
                }
            }
        }
    }
    assert!(tight > 8500 && worst.0 < 0.02, "{tight} {worst:?}");
}

/// The derivatives taken back through a strip by hand are those of dual numbers through its formulas.
#[test]
fn derivatives_are_those_of_dual_numbers() {
    type D = Dual<f64, 5>;
    for k in 1..=4000_u64 {
        let u = |x: f64| (k as f64 * x).fract() * 2.0 - 1.0;
        let size = 10_f64.powf(2.0 * u(0.754_877_666) - 0.5);
        let sigma = [0.0, 0.3, 0.9, 1.1, 3.0, 30.0][k as usize % 6] * u(0.324_717_957);
        let x = if k % 7 == 0 { 0.0 } else { size * u(0.569_840_291) };
        let inputs =
            [x, size * u(0.618_033_989), sigma, 0.3 * size * u(0.236_067_977), u(0.445).abs()];
        let [x, y, sigma, spread, start] = [0, 1, 2, 3, 4].map(|i| D::input(inputs[i], i));
        let seen = Seen { x, y, spread, start };
        let kind = (k % 2) as usize;
        let [found, ..] = internals::eight_strips(&[(seen, sigma); 8], [kind as f64; 8]);
        let dual = internals::strip_forces(&seen, sigma, kind == 1);
        for (a, b) in [(found.fx, dual.fx), (found.fy, dual.fy), (found.mx, dual.mx)] {
            assert_abs_diff_eq!(a.value, b.value, epsilon = 1e-12);
            let size = b.gradient.iter().fold(1e-3, |size: f64, d| size.max(d.abs()));
            for (d, e) in a.gradient.iter().zip(b.gradient) {
                assert!((d - e).abs() < 1e-9 * size, "{inputs:?}: {a:?} {b:?}");
            }
        }
        assert_abs_diff_eq!(found.stick.value, dual.stick.value, epsilon = 1e-12);
    }
}

/// Strips one after the other, as on a microcontroller, give the bits of strips side by side, and so do any eight. (Builds with debug
/// assertions have no code for wide registers; `.ci/run` has a step without.)
#[test]
fn strips_have_the_same_bits_one_by_one_and_side_by_side() {
    // (what is printed tells the bits of a number)
    fn agree<F: Float, T: Number<Base = F>>(input: fn(F, usize) -> T) {
        let mut before = String::new();
        let mut same = |side_by_side: &dyn Debug, one_by_one: &dyn Debug| {
            let own = format!("{one_by_one:?}");
            assert_eq!(format!("{side_by_side:?}"), own);
            assert_ne!(own, before);
            before = own;
        };
        for (k, count) in COUNTS.into_iter().enumerate() {
            for g in [0.2, 1.0, 4.0] {
                let (ratio, nu) = (F::of(g), F::of(0.28));
                let linear = LinearCoefficients::at(ratio, nu);
                let strips = EllipseStrips::new(ratio, nu, &linear, count);
                for v in [[0.3, 0.1, 0.2], [0.0, 2.0, -3.0], [-0.05, 0.0, 0.0], [40.0, 1.0, 9.0]] {
                    let v = [0, 1, 2].map(|i| input(F::of(v[i]), i));
                    same(&strips.totals(v), &internals::totals_one_by_one(&strips, v));
                }
            }
            let number = |i: usize| F::of(((i * 37 + k * 11) % 97) as f64 / 40.0 - 1.0);
            let seen = core::array::from_fn(|i| {
                let [x, y, sigma, spread] = [0, 8, 16, 24].map(|row| number(row + i));
                let [x, y, sigma] = [input(x, 0), input(y, 1), input(sigma, 2)];
                let [spread, start] = [spread, number(32 + i)].map(T::from_base);
                (Seen { x, y, spread, start }, sigma)
            });
            let inner = core::array::from_fn(|i| F::of(i as f64 / 7.0));
            let one_by_one = internals::eight_one_by_one(&seen, inner);
            same(&internals::eight_strips(&seen, inner), &one_by_one);
        }
    }
    agree::<f64, f64>(|x, _| x);
    agree::<f32, f32>(|x, _| x);
    agree::<f64, Dual<f64, 3>>(Dual::input);
    agree::<f32, Dual<f32, 3>>(Dual::input);
}

/// Forces that would give power are moved by one factor along `h K v`, `h = (1 − |F|²)/10` on the force and 1 on the moment.
#[test]
fn forces_are_lifted_along_the_linear_ones() {
    let linear = LinearCoefficients::<f64>::at(1.4, 0.28);
    let before = Totals { fx: -0.3, fy: 0.1, mz: 0.02, stick: 0.5 };
    let creepage = [0.4, -0.2, 0.3];
    let after = internals::power_projected(before, creepage, &linear);
    let share = (1.0 - (before.fx * before.fx + before.fy * before.fy)) / 10.0;
    let factors = [
        (after.fx - before.fx) / (share * linear.c11 * creepage[0]),
        (after.fy - before.fy) / (share * linear.c22 * creepage[1]),
        (after.mz - before.mz) / (linear.c33 * creepage[2]),
    ];
    assert!(factors[2] > 0.01 && after.fx.hypot(after.fy) < 1.0, "{after:?}");
    for factor in factors {
        assert_abs_diff_eq!(factor, factors[2], epsilon = 1e-12);
    }
}

/// The corrections of long contacts set in with two continuous derivatives by the axis ratio, and nothing of them is left below.
#[test]
fn long_contacts_are_reached_smoothly() {
    let share = |root: f64| internals::long_contact(root)[0];
    for root in [0.1, 1.0, 2.65] {
        assert_eq!(share(root), 0.0);
        assert_eq!(internals::long_contact(root)[1], 1.0);
    }
    assert_abs_diff_eq!(share(3.75), 1.0, epsilon = 1e-14);
    assert_abs_diff_eq!(share(1e3), 1.0, epsilon = 1e-14);
    let step = 1e-3;
    let mut before: Option<f64> = None;
    for k in 0..1400 {
        let root = 2.5 + step * f64::from(k);
        let [low, here, high] = [root - step, root, root + step].map(share);
        assert!(low <= here && here <= high && (0.0..=1.0).contains(&here));
        // w'' is at most 5.8/1.1², its slope 60/1.1³ at the ends
        let curvature = (low - here - here + high) / (step * step);
        assert!(before.is_none_or(|before| (curvature - before).abs() < 0.05), "{root}");
        before = Some(curvature);
    }
    // and so do forces: no step, and no kink, at either end
    for root in [2.65_f64, 3.75] {
        for v in [[0.03, 0.02, 0.05], [0.0, 0.05, 0.1], [0.01, -0.04, -0.2]] {
            let [a, b, c, d] = [-1.5, -0.5, 0.5, 1.5].map(|k| {
                let g = (root + 1e-4 * k).powi(2);
                totals([g, 0.28, v[0], v[1], v[2]])
            });
            for i in 0..4 {
                let slopes = [b[i] - a[i], c[i] - b[i], d[i] - c[i]];
                assert!(slopes.iter().all(|slope| slope.abs() < 1e-3));
                assert_abs_diff_eq!(slopes[0], slopes[2], epsilon = 2e-7);
            }
        }
    }
}
