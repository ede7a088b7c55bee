//! Wrong units are named, ordinary contacts are not.

use kstrip::contact::implausibility;
use kstrip::status::advice;
use kstrip_testing::prelude::*;

const DEGREES: f64 = 180.0 / PI;

fn pair(shear_modulus: f64) -> CombinedMaterial<f64> {
    CombinedMaterial { shear_modulus, poisson_ratio: 0.28, mismatch: 0.0 }
}

/// Two bodies, a load, friction, and a spin \[1/m\] that belongs to them.
struct Case {
    what: &'static str,
    radii: [f64; 4],
    shear_modulus: f64,
    load: f64,
    friction: f64,
    spin: f64,
}

const fn case(what: &'static str, radii: [f64; 4], g: f64, load: f64, mu: f64, spin: f64) -> Case {
    Case { what, radii, shear_modulus: g, load, friction: mu, spin }
}

/// What rolls: sizes, loads and spins as they are published or follow from the geometry (spin sin
/// γ/r of a wheel whose contact is inclined by γ; in a bearing about one over the radius of the
/// ball).
const ORDINARY: [Case; 20] = [
    case("freight wheel, tread", [FLAT, 0.3, 0.46, FLAT], 82e9, 125e3, 0.35, 0.054),
    case("worn wheel, conformal", [FLAT, 0.3, 0.46, -0.33], 82e9, 80e3, 0.3, 0.3),
    case("flange of 70 degrees", [FLAT, 0.013, 0.47, -0.02], 82e9, 60e3, 0.4, 2.0),
    case("flange of 75 degrees, light", [FLAT, 0.013, 0.33, FLAT], 82e9, 5e3, 0.1, 2.93),
    case("tram wheel", [FLAT, 0.08, 0.3, FLAT], 82e9, 30e3, 0.5, 0.4),
    case("model railway", [FLAT, 0.001, 0.005, FLAT], 60e9, 0.5, 0.2, 10.0),
    case("crane wheel", [FLAT, 0.4, 0.5, FLAT], 80e9, 400e3, 0.2, 0.1),
    case("twin disc", [0.0235, FLAT, 0.0235, 0.2], 82e9, 7e3, 0.6, 0.0),
    case("scaled roller rig", [0.2, 0.06, 0.1, FLAT], 82e9, 800.0, 0.3, 1.5),
    case(
        "angular contact ball bearing",
        [-0.0371, -0.00655, 0.00635, 0.00635],
        80e9,
        400.0,
        0.08,
        90.0,
    ),
    case("the same at its limit", [0.025, -0.0066, 0.00635, 0.00635], 80e9, 5e3, 0.1, 157.0),
    case("miniature ball bearing", [0.002, -0.0006, 0.0005, 0.0005], 80e9, 2.0, 0.1, 1900.0),
    case("cylindrical roller, crowned", [0.05, FLAT, 0.01, 20.0], 80e9, 5e3, 0.05, 2.0),
    case("tapered roller", [0.06, 30.0, 0.012, 10.0], 80e9, 10e3, 0.05, 20.0),
    case("ball on disc rig", [FLAT, FLAT, 0.0095, 0.0095], 80e9, 50.0, 0.1, 25.0),
    case("toroidal drive", [-0.05, 0.045, 0.04, 0.03], 80e9, 20e3, 0.09, 12.0),
    case("polyurethane roller", [FLAT, FLAT, 0.1, 1.0], 30e6, 500.0, 1.0, 0.2),
    case("rubber ball", [FLAT, FLAT, 0.03, 0.03], 1e6, 0.3, 1.5, 5.0),
    case("kiln tyre", [2.5, FLAT, 0.7, 50.0], 80e9, 2e6, 0.2, 0.01),
    case("glass on glass", [FLAT, FLAT, 0.01, 0.02], 29e9, 5.0, 0.9, 10.0),
];

fn bodies(case: &Case, unit: f64) -> Radii<f64> {
    radii(case.radii.map(|radius| unit * radius))
}

fn contact(case: &Case) -> Contact<f64> {
    let (contact, ellipse, warning) =
        from_hertz(&bodies(case, 1.0), &pair(case.shear_modulus), case.load, case.friction)
            .unwrap();
    // a ball in its race at the limit of its load is ordinary, and wide for half-spaces
    let [_, lower_y, _, upper_y] = case.radii.map(f64::abs);
    let wide = ellipse.b > 0.3 * lower_y.min(upper_y);
    let expected = if wide { Warning::Conformal } else { Warning::None };
    assert_eq!(warning, expected, "{}: {ellipse:?}", case.what);
    let (_, _, warning) =
        from_approach(&bodies(case, 1.0), &pair(case.shear_modulus), ellipse.approach, 0.3)
            .unwrap();
    assert_eq!(warning, expected, "{}", case.what);
    contact
}

/// From a thousandth of the load to twice it with Hertz's ellipse, of wheels also with that of the
/// full load, from rest to a locked wheel and to one that turns six times too fast.
#[test]
fn ordinary_contacts_are_not_warned_of() {
    for case in &ORDINARY {
        let full = contact(case);
        for share in [1e-3, 0.1, 1.0, 2.0] {
            let load = share * case.load;
            let hertz =
                from_hertz(&bodies(case, 1.0), &pair(case.shear_modulus), load, case.friction);
            let constant = Contact { normal_force: load, ..full };
            let wheel = case.spin < 3.0 || share >= 0.5;
            for contact in [hertz.unwrap().0, if wheel { constant } else { full }] {
                for [x, y] in [[0.0, 0.0], [1e-3, 2e-3], [-1.0, 0.0], [5.0, 1.0]] {
                    for spin in [0.0, case.spin, -case.spin] {
                        let said = implausibility(&contact, &creep(x, y, spin));
                        assert_eq!(said, Warning::None, "{} {share} {x} {spin}", case.what);
                    }
                }
            }
        }
    }
}

#[test]
fn wrong_units_are_named() {
    for case in &ORDINARY {
        let right = contact(case);
        let slips = creep(1e-3, 1e-3, case.spin);
        let said = |contact: Contact<f64>| implausibility(&contact, &slips);
        // GPa and MPa for Pa
        for unit in [1e-9, 1e-6] {
            let soft = Contact { shear_modulus: right.shear_modulus * unit, ..right };
            assert_eq!(said(soft), Warning::Pressure, "{}", case.what);
        }
        // mm for m, where the contact is longer than 1 mm (a contact of 0.1 mm is then one of 10
        // cm)
        let long = Contact { a: 1e3 * right.a, b: 1e3 * right.b, ..right };
        if right.a.max(right.b) > 1e-3 {
            assert_eq!(said(long), Warning::SemiAxis, "{}", case.what);
        }
        // radii in mm, where the smallest is longer than 5 mm
        let (_, _, warning) =
            from_hertz(&bodies(case, 1e3), &pair(case.shear_modulus), case.load, 0.3).unwrap();
        let roundest = case.radii.map(f64::abs).into_iter().fold(FLAT, f64::min);
        if roundest > 0.012 {
            assert_eq!(warning, Warning::Radius, "{}", case.what);
        }
        // friction in per cent
        let rough = Contact { friction: 100.0 * case.friction, ..right };
        assert_eq!(
            said(rough),
            if case.friction > 0.05 { Warning::Friction } else { Warning::None }
        );
        // a creep curve to 20 %, in per cent
        for motion in [creep(20.0, 0.0, 0.0), creep(0.0, -20.0, case.spin)] {
            assert_eq!(implausibility(&right, &motion), Warning::Creepage, "{}", case.what);
        }
    }
}

/// Degrees per metre for radians per metre: every contact that is inclined to its axis by 10
/// degrees or more, of a wheel and of a bearing; a tread contact in degrees is a flange contact in
/// radians.
#[test]
fn degrees_are_named() {
    let mut found = 0;
    for case in ORDINARY.iter().filter(|case| case.spin > 0.0) {
        let contact = contact(case);
        let radius = case.radii[2];
        // tan γ at least of the spin
        if case.spin * radius < 0.17 || (contact.a * contact.b).sqrt() * case.spin < 1.2e-3 {
            continue;
        }
        found += 1;
        let degrees = creep(1e-3, 0.0, DEGREES * case.spin);
        assert_eq!(implausibility(&contact, &degrees), Warning::Spin, "{}", case.what);
    }
    assert!(found >= 8, "{found}");
}

/// A wheel that rolls with its contact inclined by γ, from tread to flange: radians never, degrees
/// from 5 degrees on.
#[test]
fn a_wheel_is_told_from_tread_to_flange() {
    let wheel = radii([FLAT, 0.3, 0.46, FLAT]);
    let (contact, _, _) = from_hertz(&wheel, &pair(82e9), 80e3, 0.3).unwrap();
    for degrees in 0..=75 {
        let spin = f64::from(degrees).to_radians().tan() / 0.46;
        let said = |unit: f64| implausibility(&contact, &creep(0.0, 0.0, unit * spin));
        assert_eq!(said(1.0), Warning::None);
        assert_eq!(said(DEGREES) == Warning::Spin, degrees >= 5, "{degrees}");
    }
}

/// Every limit of the table holds within a hundredth, from both sides.
#[test]
fn limits_are_where_the_table_has_them() {
    let contact = contact(&ORDINARY[0]);
    let still = creep(0.0, 0.0, 0.0);
    let Contact { a, b, shear_modulus, friction, .. } = contact;
    // N of p₀ = 0.1 G
    let pressed = |a: f64, b: f64| 0.1 * shear_modulus * (2.0 / 3.0) * PI * a * b;
    let inclined = 5.0 * contact.peak_pressure() / (shear_modulus * a);
    assert!(inclined > 0.05 / (a * b).sqrt());
    // (a contact of little load, whose spin is limited by the slip at its edge)
    let light = Contact { normal_force: 10.0, ..contact };
    for (share, over) in [(0.99, false), (1.01, true)] {
        let of = |warning| if over { warning } else { Warning::None };
        let said = |contact: Contact<f64>| implausibility(&contact, &still);
        let load = share * pressed(a, b);
        assert_eq!(said(Contact { normal_force: load, ..contact }), of(Warning::Pressure));
        assert_eq!(said(Contact { a: share, ..contact }), of(Warning::SemiAxis));
        assert_eq!(said(Contact { b: share, ..contact }), of(Warning::SemiAxis));
        assert_eq!(said(Contact { friction: 5.0 * share, ..contact }), of(Warning::Friction));
        assert_eq!(said(Contact { mismatch: -0.25 * share, ..contact }), of(Warning::Mismatch));
        for sign in [1.0, -1.0] {
            let said = |x, y, spin| implausibility(&contact, &creep(x, y, spin));
            let size = 10.0 * share * sign;
            assert_eq!(said(size, 0.0, 0.0), of(Warning::Creepage));
            assert_eq!(said(0.0, size, 0.0), of(Warning::Creepage));
            assert_eq!(said(0.0, 0.0, share * sign * inclined), of(Warning::Spin));
            let edge = creep(0.0, 0.0, share * sign * 0.05 / (a * b).sqrt());
            assert_eq!(implausibility(&light, &edge), of(Warning::Spin));
        }
        let warned =
            |of: [f64; 4]| from_hertz(&radii(of), &pair(shear_modulus), 1e3, friction).unwrap().2;
        let radius = 5.0 * share;
        assert_eq!(warned([FLAT, FLAT, radius, radius]), of(Warning::Radius));
        assert_eq!(warned([FLAT, FLAT, radius, 10.0 * radius]), of(Warning::Radius));
    }
}

/// The first cause is named: of a contact in millimetres the semi-axis, not the spin or the
/// pressure that follow from it.
#[test]
fn the_cause_is_named_and_not_what_follows() {
    let contact = contact(&ORDINARY[0]);
    let spins = creep(0.0, 0.0, 0.5);
    let millimetres = Contact { a: 6.0, b: 4.0, ..contact };
    assert_eq!(implausibility(&millimetres, &spins), Warning::SemiAxis);
    assert_eq!(implausibility(&millimetres, &creep(20.0, 0.0, 0.5)), Warning::SemiAxis);
    let soft = Contact { shear_modulus: 82.0, ..contact };
    assert_eq!(implausibility(&soft, &creep(20.0, 0.0, 500.0)), Warning::Pressure);
    // a lost contact has no pressure, and nothing slips in it
    let lost = Contact { normal_force: -1.0, shear_modulus: 82.0, ..contact };
    assert_eq!(implausibility(&lost, &creep(20.0, 0.0, 500.0)), Warning::None);
    for (warning, name) in [
        (Warning::Pressure, "pressure"),
        (Warning::Creepage, "creepage"),
        (Warning::SemiAxis, "semi-axis"),
        (Warning::Spin, "spin"),
        (Warning::Friction, "friction"),
        (Warning::Radius, "radii"),
    ] {
        let text = advice(warning.code()).unwrap().to_str().unwrap();
        assert!(text.contains("implausible") && text.contains(name), "{text}");
    }
}
