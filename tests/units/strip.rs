//! Strips that follow the slip: bounds, limits, slopes, and the same bits in any registers.

use approx::assert_abs_diff_eq;
use core::fmt::Debug;
use kstrip::internals;
use kstrip::number::Number;
use kstrip::strip::{
    Distribution, EllipseStrips, Flexibilities, Rule, StripCreepage, StripGeometry,
};
use kstrip_testing::prelude::*;

fn prepared(g: f64, nu: f64) -> EllipseStrips<f64> {
    EllipseStrips::new(g, nu, &LinearCoefficients::at(g, nu), StripCount::Sixteen)
}

fn law([g, nu, vx, vy, phi]: [f64; 5], factors: [f64; 2]) -> Distribution<f64> {
    Flexibilities::new(g, nu, &LinearCoefficients::at(g, nu), factors).see([vx, vy, phi])
}

fn totals([g, nu, vx, vy, phi]: [f64; 5]) -> [f64; 4] {
    let t = prepared(g, nu).totals_of_strips([vx, vy, phi]);
    [t.fx, t.fy, t.mz, t.stick]
}

#[test]
fn agrees_with_the_fitting_script() {
    // fit/fit_strip.py --numbers: a/b, ν, vx, vy, φ; fx, fy, mz, stick
    let cases: [([f64; 5], [f64; 4]); 24] = include!("strip_numbers.in");
    for (case, expected) in cases {
        let found = totals(case);
        for (value, expected) in found.iter().zip(&expected) {
            assert!((value - expected).abs() < 1e-12, "{case:?}: {found:?}, {expected:?}");
        }
    }
}

#[test]
fn rules_integrate_the_ellipse() {
    for count in StripCount::ALL {
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
            for count in StripCount::ALL {
                let c = LinearCoefficients::at(g, nu);
                let v = [0, 1, 2].map(|i| Dual::<f64, 3>::input(0.0, i));
                let t = EllipseStrips::new(g, nu, &c, count).totals_of_strips(v);
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
        let t = prepared(g, nu).totals_of_strips(v);
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
        let t = single.totals_of_strips(v);
        assert!(t.fx * v[0] + t.fy * v[1] + t.mz * v[2] >= 0.0, "{g} {nu} {v:?} {t:?}");
    }
    assert!(least > 0.19, "{least}");
}

/// Exact for creepage without spin: Carter's half-ellipses.
#[test]
fn pure_creepage_gives_half_ellipses() {
    let solution = law([0.1, 0.28, 0.1, 0.0, 0.0], [1.0, 1.0]);
    let geometry = StripGeometry { y: 0.0, half_length: 1.0, bound: [1.0; 2], width: 0.0 };
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

/// The derivatives taken back through a strip by hand are those of dual numbers through its
/// formulas.
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
        let seen = StripCreepage { x, y, spread, start };
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

/// Strips one after the other, as on a microcontroller, give the bits of strips side by side, and
/// so do any eight. (Builds with debug assertions have no code for wide registers; `.ci/run` has a
/// step without.)
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
        for (k, count) in StripCount::ALL.into_iter().enumerate() {
            for g in [0.2, 1.0, 4.0] {
                let (ratio, nu) = (F::of(g), F::of(0.28));
                let linear = LinearCoefficients::at(ratio, nu);
                let strips = EllipseStrips::new(ratio, nu, &linear, count);
                for v in [[0.3, 0.1, 0.2], [0.0, 2.0, -3.0], [-0.05, 0.0, 0.0], [40.0, 1.0, 9.0]] {
                    let v = [0, 1, 2].map(|i| input(F::of(v[i]), i));
                    same(&strips.totals_of_strips(v), &strips.totals_one_by_one(v));
                }
            }
            let number = |i: usize| F::of(((i * 37 + k * 11) % 97) as f64 / 40.0 - 1.0);
            let seen = core::array::from_fn(|i| {
                let [x, y, sigma, spread] = [0, 8, 16, 24].map(|row| number(row + i));
                let [x, y, sigma] = [input(x, 0), input(y, 1), input(sigma, 2)];
                let [spread, start] = [spread, number(32 + i)].map(T::from_base);
                (StripCreepage { x, y, spread, start }, sigma)
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

/// Forces that would give power are moved by one factor along `h K v`, `h = (1 − |F|²)/10` on the
/// force and 1 on the moment.
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

/// The corrections of long contacts set in with two continuous derivatives with respect to the axis
/// ratio, and nothing of them is left below.
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
