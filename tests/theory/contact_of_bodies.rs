//! Contacts from two bodies: from the load, from the approach, and lost ones.

use kstrip_testing::prelude::*;

const STEEL: CombinedMaterial<f64> =
    CombinedMaterial { shear_modulus: 82e9, poisson_ratio: 0.28, mismatch: 0.0 };
const WHEEL: Radii<f64> = radii([FLAT, 0.3, 0.46, FLAT]);

/// A body of radii 1 m and `ratio` on a plane, either way round.
fn body(ratio: f64) -> [Radii<f64>; 2] {
    [[FLAT, FLAT, ratio, 1.0], [FLAT, FLAT, 1.0, ratio]].map(radii)
}

#[test]
fn a_contact_of_a_load_is_that_of_hertz() {
    for load in [1e-300, 1e-3, 1.0, 80e3, 1e7] {
        let (contact, ellipse, warning) = from_hertz(&WHEEL, &STEEL, load, 0.3).unwrap();
        assert_eq!(Ok(ellipse), hertz(&WHEEL, load, 82e9, 0.28));
        let Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, .. } = contact;
        assert_eq!((a, b, normal_force), (ellipse.a, ellipse.b, load));
        assert_eq!((shear_modulus, poisson_ratio, friction), (82e9, 0.28, 0.3));
        let crushed = ellipse.peak_pressure > 8.2e9;
        assert_eq!(warning, if crushed { Warning::Pressure } else { Warning::None }, "{load}");
        contact.check().unwrap();
    }
}

/// Load to approach and back, for axis ratios from needles to the circle and any size of load: to a
/// few roundings, and the stiffness is 3N/(2δ).
#[test]
fn the_approach_gives_the_load_back() {
    let mut slenderest = 1.0_f64;
    for ratio in [1.0, 1.0 + 1e-15, 1.0 + 1e-9, 1.001, 1.5, 3.0, 40.0, 1e3, 1e5, 1e7, 1e9] {
        for radii in body(ratio) {
            for load in [1e-250, 1e-9, 1.0, 80e3, 1e12] {
                let (contact, ellipse, _) = from_hertz(&radii, &STEEL, load, 0.3).unwrap();
                let (back, stiffness, _) =
                    from_approach(&radii, &STEEL, ellipse.approach, 0.3).unwrap();
                slenderest = slenderest.min(ellipse.axis_ratio);
                for (got, expected) in [
                    (back.a, contact.a),
                    (back.b, contact.b),
                    (back.normal_force, contact.normal_force),
                    (stiffness * ellipse.approach, 1.5 * load),
                ] {
                    let error = (got / expected - 1.0).abs();
                    assert!(error <= 4e-15, "{ratio:e} {load:e}: {got:e} {expected:e} {error:e}");
                }
            }
        }
    }
    assert!(slenderest < 1e-4);
}

/// Bodies that part: no ellipse, no load, no stiffness; and contact begins without a jump.
#[test]
fn without_load_or_approach_contact_is_lost() {
    for nothing in [0.0, -0.0, -1e-300, -1e-12, -80e3, f64::MIN] {
        let (contact, ellipse, warning) = from_hertz(&WHEEL, &STEEL, nothing, 0.3).unwrap();
        let (apart, stiffness, warning_apart) =
            from_approach(&WHEEL, &STEEL, nothing, 0.3).unwrap();
        assert_eq!((ellipse.a, ellipse.peak_pressure, ellipse.approach), (0.0, 0.0, 0.0));
        assert_eq!((stiffness, warning, warning_apart), (0.0, Warning::None, Warning::None));
        for contact in [contact, apart] {
            let Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, .. } =
                contact;
            assert_eq!([a, b, normal_force], [0.0; 3]);
            assert!(a.is_sign_positive() && normal_force.is_sign_positive());
            assert_eq!((shear_modulus, poisson_ratio, friction), (82e9, 0.28, 0.3));
            assert!(contact.is_lost());
        }
    }
    let (touching, stiffness, _) = from_approach(&WHEEL, &STEEL, 1e-30, 0.3).unwrap();
    assert!(!touching.is_lost() && touching.normal_force < 1e-30 && stiffness < 1e-3);
    // one that has parted is lost whatever else it says; NaN is no load
    assert!(Contact { normal_force: -1.0, ..touching }.is_lost());
}

#[test]
fn single_precision_follows() {
    let radii = radii([f32::INFINITY, 0.3, 0.46, f32::INFINITY]);
    let pair = CombinedMaterial { shear_modulus: 82e9_f32, poisson_ratio: 0.28, mismatch: 0.0 };
    for load in [1e-20_f32, 1.0, 80e3] {
        let (_, ellipse, _) = from_hertz(&radii, &pair, load, 0.3).unwrap();
        let (back, stiffness, _) = from_approach(&radii, &pair, ellipse.approach, 0.3).unwrap();
        assert!((back.normal_force / load - 1.0).abs() < 2e-6);
        assert!((stiffness * ellipse.approach / (1.5 * load) - 1.0).abs() < 2e-6);
    }
}
