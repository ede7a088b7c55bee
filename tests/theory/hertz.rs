//! The contact ellipse against numbers computed outside with 60 digits, and published tables.

use kstrip_testing::prelude::*;

struct Row {
    single: bool,
    radii: [f64; 4],
    load: f64,
    modulus: f64,
    poisson: f64,
    /// a, b, p₀, approach, axis ratio, Hertz's angle
    expected: [f64; 6],
}

fn rows() -> Vec<Row> {
    let row = |[single, a, b, c, d, load, modulus, poisson, expected @ ..]: [f64; 14]| Row {
        single: single == 1.0,
        radii: [a, b, c, d],
        load,
        modulus,
        poisson,
        expected,
    };
    let rows = numbers("hertz.csv");
    assert!(rows.len() > 60);
    rows.into_iter().map(row).collect()
}

fn solved(of: [f64; 4]) -> HertzContact<f64> {
    hertz(&radii(of), 80e3, 82e9, 0.28).unwrap()
}

/// How much the summed curvature amplifies a rounding of one radius (concave profiles).
fn condition(r: [f64; 4]) -> f64 {
    let of = |p: f64, q: f64| (1.0 / p).abs().max((1.0 / q).abs()) / (1.0 / p + 1.0 / q).abs();
    of(r[0], r[2]).max(of(r[1], r[3]))
}

/// Axis ratios 1e-4 to 1, the circle within 1e-15, both orientations, concave profiles: a, b, p₀
/// and approach to 1e-12.
#[test]
fn ellipse_agrees_with_high_precision_in_double() {
    let mut smallest = 1.0_f64;
    for row in rows() {
        let h = hertz(&radii(row.radii), row.load, row.modulus, row.poisson).unwrap();
        let got = [h.a, h.b, h.peak_pressure, h.approach, h.axis_ratio, h.hertz_angle];
        smallest = smallest.min(h.axis_ratio);
        assert!(h.axis_ratio < 1.0 || h.axis_ratio == 1.0 && h.a == h.b);
        for (i, (got, expected)) in got.into_iter().zip(row.expected).enumerate() {
            // The angle is that of tan(τ/2) = √(A/B): as good as the others.
            let error = (got - expected).abs() / expected;
            assert!(error <= 1e-12, "result {i} of {:?}: {error:e}", row.radii);
        }
        // `1/ρ` is the mean of the four curvatures (2.3).
        let mean = row.radii.iter().map(|radius| 1.0 / radius).sum::<f64>() / 4.0;
        let error = (h.rho * mean - 1.0).abs();
        assert!(error <= 1e-14 * condition(row.radii), "{:?}: {error:e}", row.radii);
    }
    assert!(smallest < 1.1e-4);
}

/// The same rows in single precision, to 5e-6.
#[test]
fn ellipse_agrees_with_high_precision_in_single() {
    let mut tested = 0;
    for row in rows().iter().filter(|row| row.single) {
        let radii = radii(row.radii.map(|r| r as f32));
        let h = hertz(&radii, row.load as f32, row.modulus as f32, row.poisson as f32).unwrap();
        let got = [h.a, h.b, h.peak_pressure, h.approach, h.axis_ratio, h.hertz_angle];
        // Inputs are exact; a concave profile still cancels in 1/R⁺ + 1/R⁻.
        let allowed = 5e-6_f64.max(1e-7 * condition(row.radii));
        for (i, (got, expected)) in got.into_iter().zip(row.expected).enumerate() {
            let error = (f64::from(got) - expected).abs() / expected;
            assert!(error <= allowed, "result {i} of {:?}: {error:e}", row.radii);
        }
        tested += 1;
    }
    assert!(tested > 50);
}

/// The table of Hertz's coefficients m, n (Hertz 1881; Timoshenko & Goodier, Theory of Elasticity,
/// article 140): a = m [3 N/(4 E* (A + B))]^(1/3), b = n [...]^(1/3) for cos τ = (B − A)/(B + A).
#[test]
fn hertz_angle_table_is_reproduced() {
    for (degrees, m, n) in [
        (30.0_f64, 2.731, 0.493),
        (35.0, 2.397, 0.530),
        (40.0, 2.136, 0.567),
        (45.0, 1.926, 0.604),
        (50.0, 1.754, 0.641),
        (55.0, 1.611, 0.678),
        (60.0, 1.486, 0.717),
        (65.0, 1.378, 0.759),
        (70.0, 1.284, 0.802),
        (75.0, 1.202, 0.846),
        (80.0, 1.128, 0.893),
        (85.0, 1.061, 0.944),
        (90.0, 1.000, 1.000),
    ] {
        // A + B = 1: curvatures 1 ∓ cos τ
        let cosine = degrees.to_radians().cos();
        let h = solved([FLAT, FLAT, 1.0 / (1.0 - cosine), 1.0 / (1.0 + cosine)]);
        let unit = (3.0 * 80e3 * (1.0 - 0.28) / (4.0 * 82e9_f64)).cbrt();
        assert!((h.hertz_angle.to_degrees() - degrees).abs() < 8e-14);
        // The table is of 1881 and known to contain errors (D. H. Cooper, Journal of Applied
        // Mechanics 36 (1969) 296): up to three units of its last digit
        assert!((h.a / unit - m).abs() < 3e-3, "{degrees}: m {}", h.a / unit);
        assert!((h.b / unit - n).abs() < 3e-3, "{degrees}: n {}", h.b / unit);
    }
}

/// e → 0 is 0/0 in the classical formulas; here the ellipse passes through the circle smoothly:
/// ln(a/b) = (2/3) ln(Ry/Rx) there, and a·b, the approach and p₀ have no first-order change from
/// it.
#[test]
fn ellipse_passes_smoothly_through_the_circle() {
    let circle = solved([FLAT, FLAT, 1.0, 1.0]);
    for exponent in 1..=15 {
        for sign in [1.0, -1.0] {
            // Rx = 1/(1 − d), Ry = 1/(1 + d), A + B constant
            let d = sign * 10f64.powi(-exponent);
            let h = solved([FLAT, FLAT, 1.0 / (1.0 - d), 1.0 / (1.0 + d)]);
            let slope = (h.a / h.b).ln();
            // ln(a/b) is odd in d; d³ and the rounding of 1/(1 ∓ d) remain
            let expected = 4.0 / 3.0 * d;
            let allowed = 2.0 * d.abs().powi(3) + 1e-15;
            assert!((slope - expected).abs() <= allowed, "{d:e}: {slope:e} {expected:e}");
            for (got, at_circle) in [
                (h.peak_pressure, circle.peak_pressure),
                (h.approach, circle.approach),
                (h.a * h.b, circle.a * circle.b),
            ] {
                let change = (got / at_circle - 1.0).abs();
                assert!(change <= 0.5 * d * d + 5e-15, "{d:e}: {change:e}");
            }
        }
    }
}

/// Turning the bodies by 90 degrees exchanges a and b to the last bit; the longer semi-axis belongs
/// to the smaller curvature (2.4).
#[test]
fn exchanging_directions_exchanges_the_axes() {
    for [lx, ly, ux, uy] in
        [[FLAT, 0.3, 0.46, FLAT], [2.0, -1.0, -4.0, 0.9], [FLAT, FLAT, 1.0, 1e6]]
    {
        let (one, two) = (solved([lx, ly, ux, uy]), solved([ly, lx, uy, ux]));
        assert_eq!((one.a, one.b), (two.b, two.a));
        assert_eq!((one.peak_pressure, one.approach), (two.peak_pressure, two.approach));
        assert_eq!(one.a > one.b, 1.0 / lx + 1.0 / ux < 1.0 / ly + 1.0 / uy);
        // and the bodies may be exchanged
        assert_eq!(solved([ux, uy, lx, ly]), one);
    }
}

/// p₀ = 3N/(2πab), a ~ N^(1/3), δ ~ N^(2/3), from 1e-300 to 1e9 newtons.
#[test]
fn load_scales_the_ellipse() {
    let radii = radii([FLAT, 0.3, 0.46, FLAT]);
    let one = hertz(&radii, 1.0, 82e9, 0.28).unwrap();
    for load in [1e-300_f64, 1e-30, 1e-3, 1.0, 80e3, 1e9] {
        let h = hertz(&radii, load, 82e9, 0.28).unwrap();
        let scale = load.cbrt();
        for (got, expected) in [
            (h.a, one.a * scale),
            (h.b, one.b * scale),
            (h.peak_pressure, one.peak_pressure * scale),
            (h.approach, one.approach * scale * scale),
            (h.peak_pressure * h.a * h.b, 3.0 * load / (2.0 * PI)),
        ] {
            assert!((got - expected).abs() <= 4e-15 * expected, "{load:e}: {got:e} {expected:e}");
        }
    }
}

/// Without load, and with less, the ellipse is a point; a subnormal load gives a finite ellipse.
#[test]
fn unloaded_contact_is_a_point_and_subnormal_loads_count() {
    let radii = radii([FLAT, 0.3, 0.46, FLAT]);
    let h = hertz(&radii, 0.0, 82e9, 0.28).unwrap();
    assert_eq!((h.a, h.b, h.peak_pressure, h.approach), (0.0, 0.0, 0.0, 0.0));
    assert!(h.axis_ratio > 0.0 && h.axis_ratio < 1.0);
    assert_eq!(hertz(&radii, -1.0, 82e9, 0.28), Ok(h));
    // a ~ N^(1/3) is far from subnormal when N is
    let one = hertz(&radii, 1.0, 82e9, 0.28).unwrap();
    for load in [1e-310_f64, 1e-322, 5e-324] {
        let h = hertz(&radii, load, 82e9, 0.28).unwrap();
        for (got, unit) in [(h.a, one.a), (h.b, one.b), (h.peak_pressure, one.peak_pressure)] {
            assert!((got / (unit * load.cbrt()) - 1.0).abs() < 4e-15, "{load:e}: {got:e}");
        }
    }
}

/// Needles far beyond 1e-4 still answer, quickly and in order: nothing diverges or loops.
#[test]
fn extreme_axis_ratios_stay_finite_and_ordered() {
    let mut before = 2.0;
    for exponent in 0..=200 {
        let long = 10f64.powi(exponent);
        match hertz(&radii([FLAT, FLAT, 1.0, long]), 80e3, 82e9, 0.28) {
            Ok(h) => {
                assert!(h.axis_ratio < before && h.axis_ratio > 0.0, "1e{exponent}");
                assert!((h.axis_ratio * h.b / h.a - 1.0).abs() < 1e-14);
                before = h.axis_ratio;
            }
            Err(error) => assert_eq!(error, Error::Overflow, "1e{exponent}"),
        }
    }
    assert!(before < 1e-15);
}
