use super::*;
use crate::number::dual::Dual;
use approx::assert_abs_diff_eq;

fn strips(case: [f64; 5]) -> RollingStrips<f64> {
    let [g, nu, vx, vy, phi] = case;
    RollingStrips::new(g, nu, &LinearCoefficients::at(g, nu), [vx, vy, phi])
}

fn totals(case: [f64; 5]) -> [f64; 4] {
    let t = strips(case).totals::<16, true>();
    [t.fx, t.fy, t.mz, t.stick]
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

const GEOMETRY: StripGeometry<f64> = StripGeometry { y: 0.3, half_length: 0.9, bound: 0.9 };

#[test]
fn agrees_with_the_fitting_script() {
    // fit/fit_strip.py --numbers: a/b, ν, vx, vy, φ; fx, fy, mz, stick
    let cases: [([f64; 5], [f64; 4]); 14] = include!("numbers.in");
    for (case, expected) in cases {
        for (value, expected) in totals(case).iter().zip(expected) {
            assert_abs_diff_eq!(*value, expected, epsilon = 1e-12);
        }
    }
}

#[test]
fn rules_integrate_the_ellipse() {
    fn check<const N: usize>()
    where
        f64: Placed<N>,
    {
        let rule = <f64 as Placed<N>>::RULE;
        assert_abs_diff_eq!(rule.width.iter().sum::<f64>(), 2.0, epsilon = 1e-15 * N as f64);
        assert_abs_diff_eq!(rule.load.iter().sum::<f64>(), 1.0, epsilon = 1e-15 * N as f64);
        assert_abs_diff_eq!(rule.area.iter().sum::<f64>(), 1.0, epsilon = 1e-15 * N as f64);
        assert_abs_diff_eq!(rule.moment_y.iter().sum::<f64>(), 0.0, epsilon = 1e-15);
        // ∫ Y⁴ = 2/5: two Gauss nodes on each half are exact for cubics only
        let fourth: f64 = rule.y.iter().zip(&rule.width).map(|(y, w)| w * y.powi(4)).sum();
        assert_abs_diff_eq!(fourth, 0.4, epsilon = if N == 4 { 0.012 } else { 1e-14 });
        for ((y, c), inverse) in rule.y.iter().zip(&rule.half_length).zip(&rule.inverse) {
            assert_abs_diff_eq!(y * y + c * c, 1.0, epsilon = 1e-15);
            assert_abs_diff_eq!(c * inverse, 1.0, epsilon = 1e-15);
        }
        assert!(rule.y.windows(2).all(|pair| pair[0] < pair[1]));
        assert!((rule.stretch - 1.0).abs() < 0.02 && (rule.lever - 1.0).abs() < 0.08);
    }
    check::<4>();
    check::<8>();
    check::<16>();
    check::<32>();
    check::<64>();
}

#[test]
fn zero_creepage_gives_zero() {
    assert_eq!(totals([1.0, 0.28, 0.0, 0.0, 0.0]), [0.0, 0.0, 0.0, 1.0]);
    assert_eq!(totals([10.0, 0.5, -0.0, 0.0, -0.0]).map(f64::abs), [0.0, 0.0, 0.0, 1.0]);
}

/// The forces of the linear theory, for every strip count, as the derivatives at rest.
#[test]
fn linear_slopes_are_kalkers() {
    fn check<const N: usize>(g: f64, nu: f64)
    where
        f64: Placed<N>,
    {
        let c = LinearCoefficients::at(g, nu);
        let v = [0, 1, 2].map(|i| Dual::<f64, 3>::input(0.0, i));
        let t = RollingStrips::new(g, nu, &c, v).totals::<N, false>();
        let expected = [[c.c11, 0.0, 0.0], [0.0, c.c22, c.c23]];
        for (force, expected) in [t.fx, t.fy].iter().zip(expected) {
            for (slope, expected) in force.gradient.iter().zip(expected) {
                assert_abs_diff_eq!(*slope, expected, epsilon = 2e-14 * (1.0 + c.c22.max(c.c11)));
            }
        }
    }
    for g in [0.03, 0.1, 0.5, 1.0, 3.0, 10.0, 40.0] {
        for nu in [0.0, 0.28, 0.5] {
            check::<4>(g, nu);
            check::<8>(g, nu);
            check::<16>(g, nu);
            check::<32>(g, nu);
            check::<64>(g, nu);
        }
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
        let solution = strips(case);
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
                let p = strips(case).traction(&GEOMETRY, 0.2);
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
            let solution = strips([g, 0.28, v[0], v[1], v[2]]);
            let (mut error, mut count) = (0.0, 0.0);
            for strip in <f64 as Placed<16>>::RULE.y {
                let c = (1.0 - strip * strip).sqrt();
                let geometry = StripGeometry { y: strip, half_length: c, bound: c };
                for step in &f64::STEPS {
                    let p = solution.traction(&geometry, step.x);
                    let sx = v[0] - v[2] * strip / g.sqrt();
                    let sy = v[1] + v[2] * g.sqrt() * c * step.x;
                    error += 1.0 - (p.x * sx + p.y * sy) / sx.hypot(sy);
                    count += 1.0;
                }
            }
            assert!(error / count < 0.01, "{g} {v:?}: {}", error / count);
        }
    }
    // without spin the whole friction bound
    let [fx, fy, mz, stick] = totals([2.0, 0.28, 30.0, -40.0, 0.0]);
    assert_abs_diff_eq!(fx, 0.6, epsilon = 2e-3);
    assert_abs_diff_eq!(fy, -0.8, epsilon = 2e-3);
    assert!(mz.abs() < 5e-3 && stick < 5e-3, "{mz} {stick}");
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
        let c = LinearCoefficients::at(g, nu);
        let at = |v: [f64; 3]| {
            let v = [Dual::<f64, 3>::input(v[0], 0), Dual::input(v[1], 1), Dual::input(v[2], 2)];
            RollingStrips::new(g, nu, &c, v).totals::<16, false>()
        };
        let here = at([vx, vy, phi]);
        let h = 1e-7 * (vx.abs() + vy.abs() + phi.abs());
        let there = at([vx + h, vy + h, phi + h]);
        for (a, b) in [(here.fx, there.fx), (here.fy, there.fy), (here.mz, there.mz)] {
            let slope: f64 = a.gradient.iter().sum();
            let size = a.gradient.iter().map(|d| d.abs()).sum::<f64>() + 1e-3;
            assert!(((b.value - a.value) / h - slope).abs() < 1e-4 * size + 1e-8 / h * 1e-7);
            for (d, e) in a.gradient.iter().zip(b.gradient) {
                assert!((d - e).abs() < 1e-3 * size, "{g} {nu} {vx} {vy} {phi}: {d} {e}");
            }
        }
    }
}

/// Exact for creepage without spin: Carter's half-ellipses, up to the polynomial that stands for the root.
#[test]
fn pure_creepage_gives_half_ellipses() {
    let solution = strips([0.1, 0.28, 0.1, 0.0, 0.0]);
    let geometry = StripGeometry { y: 0.0, half_length: 1.0, bound: 1.0 };
    let two_kappa = solution.strip(&geometry).longitudinal;
    for i in 1..40 {
        let x = 1.0 - 0.05 * f64::from(i);
        let carter =
            if 1.0 + x > two_kappa { 1.0 - (1.0 - two_kappa / (1.0 + x)).sqrt() } else { 1.0 };
        let p = solution.traction(&geometry, x);
        assert_abs_diff_eq!(p.x, carter, epsilon = 0.09);
        assert_eq!(p.slips, 1.0 + x < two_kappa);
        assert_eq!(p.slip_x > 0.0, p.slips);
    }
}

/// Tractions at the quadrature points add up to the strip's force; slip and state fit each other.
#[test]
fn field_and_forces_agree() {
    for case in cases(200) {
        let solution = strips(case);
        let mut forces = [[0.0; 4]; 16];
        solution.each_strip::<16>(|i, found| forces[i] = found);
        let rule = <f64 as Placed<16>>::RULE;
        for (i, (y, c)) in rule.y.iter().zip(&rule.half_length).enumerate() {
            // the rule's factors for exact slopes belong to the sums only
            let mut scaled = solution;
            scaled.longitudinal *= rule.stretch;
            scaled.lateral *= rule.stretch;
            scaled.slope *= rule.lever;
            let geometry = StripGeometry { y: *y, half_length: *c, bound: *c };
            let (mut fx, mut fy) = (0.0, 0.0);
            for step in &f64::STEPS {
                let p = scaled.traction(&geometry, step.x);
                fx += 2.0 / STEPS as f64 * step.bound * p.x;
                fy += 2.0 / STEPS as f64 * step.bound * p.y;
            }
            assert_abs_diff_eq!(fx, forces[i][0], epsilon = 1e-12);
            assert_abs_diff_eq!(fy, forces[i][1], epsilon = 1e-12);
        }
    }
}

#[test]
fn power_of_the_strips_is_the_power_of_the_contact() {
    for case in cases(100) {
        let solution = strips(case);
        let total = solution.totals::<8, false>();
        let rule = <f64 as Placed<8>>::RULE;
        let mut power = 0.0;
        solution.each_strip::<8>(|i, [fx, fy, mx, _]| {
            let c = rule.half_length[i];
            let geometry = StripGeometry { y: rule.y[i], half_length: c, bound: c };
            power += rule.load[i] * solution.power(&geometry, fx, fy, mx);
        });
        let [vx, vy, phi] = solution.creepage;
        let expected = total.fx * vx + total.fy * vy + total.mz * phi;
        assert_abs_diff_eq!(power, expected, epsilon = 1e-12 * (1.0 + expected.abs()));
    }
}

#[test]
fn strip_counts_converge() {
    fn distance<const N: usize>() -> f64
    where
        f64: Placed<N>,
    {
        let distances = cases(500).map(|case| {
            let solution = strips(case);
            let (a, b) = (solution.totals::<N, false>(), solution.totals::<64, false>());
            (a.fx - b.fx).hypot(a.fy - b.fy)
        });
        distances.sum::<f64>() / 500.0
    }
    let errors = [distance::<4>(), distance::<8>(), distance::<16>(), distance::<32>()];
    for (error, allowed) in errors.iter().zip([0.02, 0.006, 0.002, 0.0007]) {
        assert!(*error < allowed, "{errors:?}");
    }
}

#[test]
fn callers_strips_follow_the_same_law() {
    let solution = strips([2.0, 0.3, 0.05, -0.1, 0.2]);
    let rule = <f64 as Placed<16>>::RULE;
    let mut creepages = [[0.0; 16]; 3];
    for (i, (y, c)) in rule.y.iter().zip(&rule.half_length).enumerate() {
        let strip = solution.strip(&StripGeometry { y: *y, half_length: *c, bound: *c });
        creepages[0][i] = strip.longitudinal;
        creepages[1][i] = strip.lateral;
        creepages[2][i] = strip.spin;
    }
    let [ax, ay, spin] = &creepages;
    let own = march::<f64, 16, true>(ax, ay, *spin);
    solution.each_strip::<16>(|i, [fx, fy, _, stick]| {
        assert_abs_diff_eq!(own.fx[i], fx, epsilon = 2e-3);
        assert_abs_diff_eq!(own.fy[i], fy, epsilon = 2e-3);
        assert_abs_diff_eq!(own.stick[i], stick, epsilon = 2e-3);
    });
}

#[test]
fn single_precision_agrees() {
    for [g, nu, vx, vy, phi] in cases(500) {
        let t = totals([g, nu, vx, vy, phi]);
        let [g, nu, vx, vy, phi] = [g, nu, vx, vy, phi].map(|x| x as f32);
        let s = RollingStrips::new(g, nu, &LinearCoefficients::at(g, nu), [vx, vy, phi])
            .totals::<16, true>();
        for (value, expected) in [s.fx, s.fy, s.mz].iter().zip(t) {
            assert_abs_diff_eq!(f64::from(*value), expected, epsilon = 2e-4);
        }
    }
}

/// The derivatives taken by hand through the march and the network are those of the same formulas run with
/// dual numbers.
#[test]
fn derivatives_are_those_of_dual_numbers() {
    fn close(a: Dual<f64, 3>, b: Dual<f64, 3>, case: &[f64; 5]) {
        assert_abs_diff_eq!(a.value, b.value, epsilon = 1e-12 * (1.0 + b.value.abs()));
        let size = b.gradient.iter().fold(1e-3, |size: f64, d| size.max(d.abs()));
        for (d, e) in a.gradient.iter().zip(b.gradient) {
            assert!((d - e).abs() < 1e-10 * size, "{case:?}: {d} {e}");
        }
    }
    for case in cases(2000) {
        let [g, nu, vx, vy, phi] = case;
        let c = LinearCoefficients::at(g, nu);
        let v = [Dual::<f64, 3>::input(vx, 0), Dual::input(vy, 1), Dual::input(phi, 2)];
        let by_hand = RollingStrips::new(g, nu, &c, v);
        let [longitudinal, lateral, slope, profile, spin] =
            parameters::<_, Forward>((g.sqrt(), nu, &c), v);
        close(by_hand.longitudinal, longitudinal, &case);
        close(by_hand.lateral, lateral, &case);
        close(by_hand.slope, slope, &case);
        close(by_hand.profile, profile, &case);
        close(by_hand.spin, spin, &case);
        let totals = by_hand.totals::<16, true>();
        let expected = by_hand.sum::<true, true>(&<f64 as Placed<16>>::RULE.strips());
        close(totals.fx, expected.fx, &case);
        close(totals.fy, expected.fy, &case);
        close(totals.mz, expected.mz, &case);
        assert_abs_diff_eq!(totals.stick.value, expected.stick.value, epsilon = 1e-12);
        // and the values those of the forces alone
        let plain = strips(case).totals::<16, true>();
        assert_abs_diff_eq!(totals.fx.value, plain.fx, epsilon = 1e-13);
        assert_abs_diff_eq!(totals.fy.value, plain.fy, epsilon = 1e-13);
        assert_abs_diff_eq!(totals.mz.value, plain.mz, epsilon = 1e-13);
    }
}

/// Differences of sixth order, where no strip comes near a change of formula: the derivatives to 1e-7.
#[test]
fn derivatives_are_those_of_differences() {
    let (mut tight, mut worst) = (0, 0.0_f64);
    for case in cases(1000) {
        let [g, nu, vx, vy, phi] = case;
        let c = LinearCoefficients::at(g, nu);
        let v = [Dual::<f64, 3>::input(vx, 0), Dual::input(vy, 1), Dual::input(phi, 2)];
        let totals = RollingStrips::new(g, nu, &c, v).totals::<16, false>();
        let h = 2e-4 * (vx.abs() + vy.abs() + phi.abs());
        for k in 0..3 {
            let at = |n: f64| {
                let mut v = [vx, vy, phi];
                v[k] += n * h;
                let t = RollingStrips::new(g, nu, &c, v).totals::<16, false>();
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
                worst = worst.max(error);
            }
        }
    }
    assert!(tight > 9000 / 4 && worst < 0.02, "{tight} {worst}");
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
                    let solution =
                        RollingStrips::new(g, nu, &c, [size * vx, size * vy, size * phi]);
                    let t = solution.totals::<16, true>();
                    assert!(t.fx.hypot(t.fy) <= 1.0 + 1e-5, "{size} {g} {nu} {t:?}");
                    assert!(t.mz.is_finite() && (0.0..=1.00001).contains(&t.stick), "{t:?}");
                    let geometry = StripGeometry { y: 0.3, half_length: 0.9, bound: 0.9 };
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
