//! Combined elastic constants (2.6), (4.3).

use kstrip_testing::prelude::*;
use proptest::prelude::*;

fn material(shear_modulus: f64, poisson_ratio: f64) -> Material<f64> {
    Material { shear_modulus, poisson_ratio }
}

// N. E. Dowling, Mechanical Behavior of Materials, Table 5.2: Young's modulus and Poisson's ratio
// of mild steel, brass (70 Cu 30 Zn), aluminium and glass (type E).
const STEEL: (f64, f64) = (212e9, 0.293);
const BRASS: (f64, f64) = (101e9, 0.350);
const ALUMINIUM: (f64, f64) = (70.3e9, 0.345);
const GLASS: (f64, f64) = (72.4e9, 0.22);

/// Table 2, upper over lower body, and its value there.
///
/// The paper does not state its constants, and no four materials like these give all six numbers to
/// two decimals: a search over moduli and ratios around them leaves one entry at least 0.008 off
/// (brass/glass 0.10 and aluminium/glass 0.03 do not go together). Handbook values come within
/// 0.025 of each entry and within 0.01 of the three pairs of metals and of brass/glass; a wrong
/// sign, a missing factor 2 or exchanged bodies would be off by 0.02 to 0.3 in most.
#[test]
fn mismatch_of_table_2_from_handbook_constants() {
    for (upper, lower, table, ours) in [
        (STEEL, BRASS, 0.03, 0.04),
        (STEEL, ALUMINIUM, 0.06, 0.07),
        (STEEL, GLASS, 0.13, 0.15),
        (BRASS, ALUMINIUM, 0.02, 0.03),
        (BRASS, GLASS, 0.10, 0.09),
        (ALUMINIUM, GLASS, 0.03, 0.05),
    ] {
        let body = |(e, nu)| Material::from_youngs_modulus(e, nu);
        let pair = combine(&body(lower), &body(upper)).unwrap();
        assert!((pair.mismatch - table).abs() <= 0.025, "{} against {table}", pair.mismatch);
        // To two decimals what the formula gives by hand with these constants
        assert!((pair.mismatch - ours).abs() <= 0.005, "{} against {ours}", pair.mismatch);
    }
}

proptest! {
    /// The formulas as they stand in the paper, for any two bodies.
    #[test]
    fn combined_constants_follow_the_formulas(
        g1 in 1e6..1e12_f64, nu1 in 0.0..=0.5_f64, g2 in 1e6..1e12_f64, nu2 in 0.0..=0.5_f64,
    ) {
        let pair = combine(&material(g1, nu1), &material(g2, nu2)).unwrap();
        let g = 2.0 / (1.0 / g1 + 1.0 / g2);
        // A handful of roundings each
        prop_assert!((pair.shear_modulus - g).abs() <= 1e-15 * g);
        prop_assert!((pair.poisson_ratio - g * (nu1 / g1 + nu2 / g2) / 2.0).abs() <= 1e-15);
        let kappa = g * ((1.0 - 2.0 * nu1) / g1 - (1.0 - 2.0 * nu2) / g2) / 4.0;
        prop_assert!((pair.mismatch - kappa).abs() <= 1e-15);
        // Hertz's modulus comes out of them: (1 − ν)/G = ((1 − ν⁺)/G⁺ + (1 − ν⁻)/G⁻)/2
        let compliance = ((1.0 - nu1) / g1 + (1.0 - nu2) / g2) / 2.0;
        let combined = (1.0 - pair.poisson_ratio) / pair.shear_modulus;
        prop_assert!((combined - compliance).abs() <= 1e-15 * compliance);
        // A mean stays between its parts
        prop_assert!(pair.poisson_ratio >= nu1.min(nu2) * (1.0 - 1e-15));
        prop_assert!(pair.poisson_ratio <= nu1.max(nu2) * (1.0 + 1e-15));
    }
}

#[test]
fn like_bodies_combine_to_themselves_without_mismatch() {
    for (g, nu) in [STEEL, BRASS, ALUMINIUM, GLASS, (1.0, 0.0), (3e-3, 0.5), (0.1, 0.1)] {
        let pair = combine(&material(g, nu), &material(g, nu)).unwrap();
        assert_eq!((pair.shear_modulus, pair.poisson_ratio, pair.mismatch), (g, nu, 0.0));
    }
}

/// G = E/(2(1 + ν)).
#[test]
fn youngs_modulus_becomes_shear_modulus() {
    let steel = Material::from_youngs_modulus(210e9, 0.28);
    assert_relative_eq!(steel.shear_modulus, 82.031_25e9, max_relative = 1e-15);
    assert_eq!(steel.poisson_ratio, 0.28);
    assert_eq!(Material::from_youngs_modulus(3.0_f64, 0.5).shear_modulus, 1.0);
    assert_eq!(Material::from_youngs_modulus(2.0_f32, 0.0).shear_modulus, 1.0);
}

/// Moduli near the ends of the range do not overflow on the way.
#[test]
fn extreme_moduli_combine_without_overflow() {
    let huge = material(1.7e308, 0.25);
    let pair = combine(&huge, &huge).unwrap();
    assert_eq!((pair.shear_modulus, pair.poisson_ratio), (1.7e308, 0.25));
    let small = material(f64::MIN_POSITIVE, 0.25);
    let pair = combine(&small, &huge).unwrap();
    assert_relative_eq!(pair.shear_modulus, 2.0 * f64::MIN_POSITIVE, max_relative = 1e-15);
    // The combination of a rigid and an almost rigid body has no finite modulus.
    let result = combine(&material(1e308, 0.25), &material(f64::MAX, 0.25));
    assert!(result == Err(Error::Overflow) || result.unwrap().shear_modulus.is_finite());
}

/// Single precision differs by rounding only.
#[test]
fn single_precision_agrees() {
    let (lower, upper) = (material(BRASS.0, BRASS.1), material(STEEL.0, STEEL.1));
    let double = combine(&lower, &upper).unwrap();
    let narrow = |m: &Material<f64>| Material {
        shear_modulus: m.shear_modulus as f32,
        poisson_ratio: m.poisson_ratio as f32,
    };
    let single = combine(&narrow(&lower), &narrow(&upper)).unwrap();
    assert_relative_eq!(f64::from(single.shear_modulus), double.shear_modulus, max_relative = 5e-7);
    assert_relative_eq!(f64::from(single.poisson_ratio), double.poisson_ratio, max_relative = 5e-7);
    assert_relative_eq!(f64::from(single.mismatch), double.mismatch, epsilon = 1e-7);
}
