//! What comes before and after a contact is solved: materials, Hertz, creepages, the upper body,
//! texts.

use super::super::*;
use super::contacts::{contact, creepage};
use super::*;

fn combine(bytes: &mut Bytes) {
    let mut material = || kstrip_material {
        shear_modulus: positive(bytes, 82e9),
        poisson_ratio: positive(bytes, 0.06),
    };
    let (lower, upper) = (material(), material());
    let answer = asked::<kstrip_combined_material>(bytes, 2, |given, out| {
        kstrip_material_combine(given.input(0, &lower), given.input(1, &upper), out)
    });
    if let Some((_, m)) = answer {
        let numbers = [m.shear_modulus, m.poisson_ratio, m.mismatch];
        let plausible = (0.0..=0.5).contains(&m.poisson_ratio) && m.mismatch.abs() <= 0.5;
        let in_range = finite(&numbers) && m.shear_modulus > 0.0 && plausible;
        assert!(in_range, "{lower:?} {upper:?} {m:?}");
    }
}

fn radii(bytes: &mut Bytes) -> kstrip_radii {
    let mut radius = || Number::of(bytes, 10.0);
    kstrip_radii { lower_x: radius(), lower_y: radius(), upper_x: radius(), upper_y: radius() }
}

fn pair(bytes: &mut Bytes) -> kstrip_combined_material {
    kstrip_combined_material {
        shear_modulus: positive(bytes, 82e9),
        poisson_ratio: positive(bytes, 0.06),
        mismatch: Number::of(bytes, 0.1),
    }
}

/// A contact of Hertz is one that can be solved, or lost.
fn accepted(contact: &kstrip_contact) -> bool {
    contact.check().is_ok() && (contact.is_lost() || contact.normal_force > 0.0)
}

fn from_hertz(bytes: &mut Bytes) {
    let (radii, pair) = (radii(bytes), pair(bytes));
    let (load, friction) = (Number::of(bytes, 1e5), positive(bytes, 0.3));
    let given = bytes.given();
    let mut out = poisoned::<kstrip_contact>();
    let mut ellipse = poisoned::<kstrip_hertz_contact>();
    let status = kstrip_contact_from_hertz(
        given.input(0, &radii),
        given.input(1, &pair),
        load,
        friction,
        given.output(2, &mut out),
        given.output(3, &mut ellipse),
    );
    if answered(status, untouched(&out) && untouched(&ellipse)) {
        assert!(given.all(3));
        let contact = written(&out);
        let context = || format!("{radii:?} {load} {pair:?} {contact:?}");
        assert!(accepted(&contact), "{}", context());
        assert_eq!(untouched(&ellipse), !given.has(3));
        if given.has(3) {
            let h = written(&ellipse);
            let numbers = [h.a, h.b, h.peak_pressure, h.approach, h.hertz_angle, h.rho];
            assert!(finite(&numbers), "{} {h:?}", context());
            let in_range = h.a >= 0.0 && h.b >= 0.0 && h.axis_ratio > 0.0 && h.axis_ratio <= 1.0;
            assert!(in_range && (h.a, h.b) == (contact.a, contact.b), "{} {h:?}", context());
        }
    }
}

fn from_approach(bytes: &mut Bytes) {
    let (radii, pair) = (radii(bytes), pair(bytes));
    let (approach, friction) = (Number::of(bytes, 1e-4), positive(bytes, 0.3));
    let given = bytes.given();
    let mut out = poisoned::<kstrip_contact>();
    let mut slope = poisoned::<Float>();
    let status = kstrip_contact_from_approach(
        given.input(0, &radii),
        given.input(1, &pair),
        approach,
        friction,
        given.output(2, &mut out),
        given.output(3, &mut slope),
    );
    if answered(status, untouched(&out) && untouched(&slope)) {
        assert!(given.all(3));
        let contact = written(&out);
        assert!(accepted(&contact), "{radii:?} {pair:?} {approach} {contact:?}");
        if given.has(3) {
            let slope = written(&slope);
            assert!(slope.is_finite() && slope >= 0.0, "{radii:?} {pair:?} {approach} {slope}");
        }
    }
}

fn coefficients(bytes: &mut Bytes) {
    let (ratio, nu) = (positive(bytes, 1.0), positive(bytes, 0.06));
    let given = bytes.given();
    let mut out = poisoned_array::<Float, 4>();
    // SAFETY: NULL or four numbers.
    let status = unsafe { kstrip_linear_coefficients(ratio, nu, given.places(0, &mut out)) };
    if answered(status, all_untouched(&out)) {
        let c = out.map(|c| written(&c));
        assert!(finite(&c) && c.iter().all(|&c| c > 0.0), "{ratio} {nu} {c:?}");
    }
}

fn velocities(bytes: &mut Bytes) {
    let mut velocity = || kstrip_velocity {
        x: Number::of(bytes, -20.0),
        y: Number::of(bytes, 1.0),
        angular_z: Number::of(bytes, 1.0),
    };
    let (lower, upper) = (velocity(), velocity());
    let speed = positive(bytes, 20.0);
    let answer = asked::<kstrip_creepage>(bytes, 2, |given, out| {
        kstrip_creepage_from_velocities(given.input(0, &lower), given.input(1, &upper), speed, out)
    });
    if let Some((_, k)) = answer {
        assert!(finite(&[k.longitudinal, k.lateral, k.spin]), "{lower:?} {upper:?} {speed} {k:?}");
    }
}

fn parameters_from_creepage(bytes: &mut Bytes) {
    let (contact, k) = (contact(bytes), creepage(bytes));
    let answer = asked::<kstrip_parameters>(bytes, 2, |given, out| {
        kstrip_parameters_from_creepage(given.input(0, &contact), given.input(1, &k), out)
    });
    if let Some((_, p)) = answer {
        assert!(finite(&[p.xi, p.eta, p.psi]), "{contact:?} {k:?} {p:?}");
    }
}

fn creepage_from_parameters(bytes: &mut Bytes) {
    let contact = contact(bytes);
    let wanted = kstrip_parameters {
        xi: Number::of(bytes, 1.0),
        eta: Number::of(bytes, 1.0),
        psi: Number::of(bytes, 1.0),
    };
    let answer = asked::<kstrip_creepage>(bytes, 2, |given, out| {
        kstrip_creepage_from_parameters(given.input(0, &contact), given.input(1, &wanted), out)
    });
    if let Some((_, k)) = answer {
        assert!(finite(&[k.longitudinal, k.lateral, k.spin]), "{contact:?} {wanted:?} {k:?}");
    }
}

/// No number is computed: any bits pass through.
fn upper_body(bytes: &mut Bytes) {
    let lower = kstrip_result {
        fx: Number::of(bytes, 1e3),
        fy: Number::of(bytes, 1e3),
        mz: Number::of(bytes, 1e3),
        power: Number::of(bytes, 1e3),
        adhesion: Number::of(bytes, 1.0),
        warning: Warning::None,
        reserved: bytes.integer(),
    };
    let given = bytes.given();
    let mut out = poisoned::<kstrip_result>();
    let input = MaybeUninit::new(lower);
    let status = kstrip_result_on_upper_body(given.input(0, &input), given.output(1, &mut out));
    assert_eq!(status == 0, given.all(2));
    if answered(status, status != 0 && untouched(&out)) {
        // SAFETY: every byte has been set; by bytes that may well be those of the pattern.
        let u = unsafe { out.assume_init_read() };
        for (upper, lower) in [(u.fx, lower.fx), (u.fy, lower.fy), (u.mz, lower.mz)] {
            assert_eq!((-upper).bits(), lower.bits());
        }
        assert_eq!(u.power.bits(), lower.power.bits());
    }
}

/// What has no numbers in it.
fn texts(bytes: &mut Bytes) {
    let status = if bytes.byte() < 128 { bytes.integer() } else { i32::from(bytes.byte()) - 100 };
    // SAFETY: texts of C that live as long as the program.
    let texts = [kstrip_status_string(status), kstrip_version_string()]
        .map(|text| unsafe { std::ffi::CStr::from_ptr(text) });
    assert!(texts.iter().all(|text| !text.is_empty() && text.to_str().is_ok()));
    assert_eq!(kstrip_abi_version(), KSTRIP_ABI_VERSION);
    let given = bytes.given();
    let mut out = poisoned::<kstrip_options>();
    let status = kstrip_options_init(given.output(0, &mut out));
    assert_eq!(status == 0, given.all(1));
    if answered(status, untouched(&out)) {
        let kstrip_options { model, strips } = written(&out);
        assert_eq!((model, strips), (0, 0));
    }
}

pub const ENTRIES: &[Entry] = &[
    ("combine", combine),
    ("from_hertz", from_hertz),
    ("from_approach", from_approach),
    ("coefficients", coefficients),
    ("velocities", velocities),
    ("parameters_from_creepage", parameters_from_creepage),
    ("creepage_from_parameters", creepage_from_parameters),
    ("upper_body", upper_body),
    ("texts", texts),
];
