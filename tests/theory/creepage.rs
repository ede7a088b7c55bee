//! Creepages from velocities (3.3), parameters (5.13) and their inverse.

use kstrip::contact::creepage::SurfaceVelocity;
use kstrip_testing::prelude::*;
use kstrip_testing::single::single;

fn at(x: f64, y: f64, angular_z: f64) -> SurfaceVelocity<f64> {
    SurfaceVelocity { x, y, angular_z }
}

/// (5.13) with p₀ = 3N/(2πab), for random contacts.
#[test]
fn parameters_follow_their_definitions() {
    let mut random = Random::new(513);
    for _ in 0..10_000 {
        let sizes = [(1e-6, 1.0), (1e-6, 1.0), (1e-6, 1e7), (1e4, 1e12), (1e-3, 2.0)];
        let [a, b, normal_force, shear_modulus, friction] =
            sizes.map(|(low, high)| random.log_between(low, high));
        let poisson_ratio = random.between(0.0, 0.5);
        let c = Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, ..C0 };
        let [x, y, spin] = [0.1, 0.1, 50.0].map(|size| random.between(-size, size));
        let motion = creep(x, y, spin);
        let p0 = 3.0 * c.normal_force / (2.0 * PI * c.a * c.b);
        let ratio = c.shear_modulus / (2.0 * c.friction * p0);
        let p = Parameters::new(&c, &motion);
        for (got, expected) in [
            (p.xi, motion.longitudinal * ratio / (1.0 - c.poisson_ratio)),
            (p.eta, motion.lateral * ratio),
            (p.psi, c.a * motion.spin * ratio),
            (p.spin_slope(), p.psi * c.b / (c.a * (1.0 - c.poisson_ratio))),
            (c.slip_unit(), 1.0 / ratio),
            (c.peak_pressure(), p0),
            (c.friction_bound(), c.friction * c.normal_force),
        ] {
            // About ten roundings
            assert!((got - expected).abs() <= 3e-15 * expected.abs(), "{c:?} {motion:?}");
        }
        assert_eq!((p.poisson_ratio, p.axis_ratio), (c.poisson_ratio, c.a / c.b));
        let back = p.creepage(&c);
        for (got, expected) in [
            (back.longitudinal, motion.longitudinal),
            (back.lateral, motion.lateral),
            (back.spin, motion.spin),
        ] {
            assert!((got - expected).abs() <= 4e-15 * expected.abs(), "{c:?} {motion:?}");
        }
    }
}

/// From tiny to huge the parameters keep their sign, their order and (until they are beyond any
/// meaning) their ratio; no infinity, no NaN, no square that overflows.
#[test]
fn tiny_and_huge_creepages_keep_their_direction() {
    let c = theory::contact(1.0, 0.28);
    for exponent in -300..=300 {
        let size = 10f64.powi(exponent);
        let motion = creep(3.0 * size, -4.0 * size, 0.0);
        let p = Parameters::new(&c, &motion);
        assert!((p.xi * p.xi).is_finite() && (p.eta * p.eta).is_finite(), "1e{exponent}");
        assert!(p.xi > 0.0 && p.eta < 0.0 && p.psi == 0.0);
        let ratio = p.xi / p.eta;
        assert!((ratio + 0.75 / 0.72).abs() < 4e-15, "1e{exponent}: {ratio}");
        if exponent < 90 {
            let back = p.creepage(&c);
            assert!((back.longitudinal / motion.longitudinal - 1.0).abs() < 4e-15);
            assert!((back.lateral / motion.lateral - 1.0).abs() < 4e-15);
        }
        let spin = creep(0.0, 0.0, -size);
        let p = Parameters::new(&c, &spin);
        assert!(p.psi < 0.0 && (p.psi * p.psi).is_finite() && p.xi == 0.0 && p.eta == 0.0);
    }
}

/// The same in single precision, 1e-30 to 1e30.
#[test]
fn tiny_and_huge_creepages_in_single_precision() {
    let wide = theory::contact(1.0, 0.28);
    let c = single(&wide);
    for exponent in -30..=30 {
        let size = 10f32.powi(exponent);
        let motion = creep(3.0 * size, -4.0 * size, size);
        let p = Parameters::new(&c, &motion);
        assert!([p.xi, p.eta, p.psi].iter().all(|x| (x * x).is_finite()), "1e{exponent}");
        assert!(p.xi > 0.0 && p.eta < 0.0 && p.psi > 0.0);
        assert!((p.xi / p.eta + 0.75 / 0.72).abs() < 6e-7, "1e{exponent}");
    }
}

/// (3.3): upper minus lower, over the rolling speed.
#[test]
fn creepage_is_the_velocity_of_the_upper_over_the_lower_body() {
    // A braked wheel (upper) turns too slowly: its surface lags behind the ground that streams
    // backwards, so it slides forwards over the rail.
    let rail = at(-20.0, 0.0, 0.0);
    let wheel = at(-19.9, 0.04, -0.6);
    let c = Creepage::from_velocities(&rail, &wheel, 20.0).unwrap();
    assert!((c.longitudinal - 0.005).abs() < 1e-15);
    assert!((c.lateral - 0.002).abs() < 1e-15);
    assert!((c.spin + 0.03).abs() < 1e-15);
    // Exchanging the bodies reverses it; a common velocity changes nothing.
    let reverse = Creepage::from_velocities(&wheel, &rail, 20.0).unwrap();
    assert_eq!(reverse.longitudinal, -c.longitudinal);
    assert_eq!((reverse.lateral, reverse.spin), (-c.lateral, -c.spin));
    let moved = Creepage::from_velocities(&at(0.0, 1.0, 8.0), &at(0.1, 1.04, 7.4), 20.0).unwrap();
    assert!((moved.longitudinal - c.longitudinal).abs() < 1e-15);
    assert!((moved.lateral - c.lateral).abs() < 1e-15 && (moved.spin - c.spin).abs() < 1e-15);
    // A quotient that does not fit
    let faint = Creepage::from_velocities(&rail, &at(1e10, 0.0, 0.0), 1e-300);
    assert_eq!(faint, Err(kstrip::status::Error::Overflow));
}

/// A braked wheel is pushed backwards: the force on the lower body is along +x.
#[test]
fn braked_wheel_is_held_back() {
    let c = theory::contact(1.0, 0.28);
    let motion =
        Creepage::from_velocities(&at(-20.0, 0.0, 0.0), &at(-19.98, 0.0, 0.0), 20.0).unwrap();
    let on_rail = solved(&c, &motion, &kstrip::forces::Options::default());
    assert!(on_rail.fx > 0.0 && on_rail.power > 0.0);
}
