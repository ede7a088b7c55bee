//! What comes before and after a contact is solved: materials, Hertz, creepages, the upper body, texts.

use super::super::*;
use super::contacts::{contact, creepage};
use super::*;

fn material(bytes: &mut Bytes) {
    let (modulus, ratio) = (positive(bytes, 82e9), positive(bytes, 0.06));
    let given = bytes.given();
    let mut out = poisoned::<kstrip_material>();
    let status = kstrip_material_from_youngs_modulus(modulus, ratio, given.output(0, &mut out));
    if answered(status, untouched(&out)) {
        let m = written(&out);
        assert!(finite(&[m.shear_modulus, m.poisson_ratio]) && m.shear_modulus > 0.0, "{m:?}");
    }
}

fn combine(bytes: &mut Bytes) {
    let mut material = || kstrip_material {
        shear_modulus: positive(bytes, 82e9),
        poisson_ratio: positive(bytes, 0.06),
    };
    let (lower, upper) = (material(), material());
    let given = bytes.given();
    let mut out = poisoned::<kstrip_combined_material>();
    let status = kstrip_material_combine(
        given.input(0, &lower),
        given.input(1, &upper),
        given.output(2, &mut out),
    );
    if answered(status, untouched(&out)) {
        assert!(given.all(3));
        let m = written(&out);
        assert!(
            finite(&[m.shear_modulus, m.poisson_ratio, m.mismatch]),
            "{lower:?} {upper:?} {m:?}"
        );
        let in_range = m.shear_modulus > 0.0
            && (0.0..=0.5).contains(&m.poisson_ratio)
            && m.mismatch.abs() <= 0.5;
        assert!(in_range, "{lower:?} {upper:?} {m:?}");
    }
}

fn hertz(bytes: &mut Bytes) {
    let mut radius = || Number::of(bytes, 10.0);
    let radii =
        kstrip_radii { lower_x: radius(), lower_y: radius(), upper_x: radius(), upper_y: radius() };
    let load = positive(bytes, 1e5);
    let material = kstrip_combined_material {
        shear_modulus: positive(bytes, 82e9),
        poisson_ratio: positive(bytes, 0.06),
        mismatch: Number::of(bytes, 0.1),
    };
    let given = bytes.given();
    let mut out = poisoned::<kstrip_hertz_contact>();
    let status = kstrip_hertz(
        given.input(0, &radii),
        load,
        given.input(1, &material),
        given.output(2, &mut out),
    );
    if answered(status, untouched(&out)) {
        assert!(given.all(3));
        let h = written(&out);
        let context = || format!("{radii:?} {load} {material:?} {h:?}");
        let numbers = [h.a, h.b, h.peak_pressure, h.approach, h.hertz_angle, h.rho];
        assert!(finite(&numbers), "{}", context());
        let in_range = h.a >= 0.0 && h.b >= 0.0 && h.axis_ratio > 0.0 && h.axis_ratio <= 1.0;
        assert!(in_range, "{}", context());
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
    let given = bytes.given();
    let mut out = poisoned::<kstrip_creepage>();
    let status = kstrip_creepage_from_velocities(
        given.input(0, &lower),
        given.input(1, &upper),
        speed,
        given.output(2, &mut out),
    );
    if answered(status, untouched(&out)) {
        assert!(given.all(3));
        let k = written(&out);
        assert!(finite(&[k.longitudinal, k.lateral, k.spin]), "{lower:?} {upper:?} {speed} {k:?}");
    }
}

fn parameters_from_creepage(bytes: &mut Bytes) {
    let (contact, k) = (contact(bytes), creepage(bytes));
    let given = bytes.given();
    let mut out = poisoned::<kstrip_parameters>();
    let status = kstrip_parameters_from_creepage(
        given.input(0, &contact),
        given.input(1, &k),
        given.output(2, &mut out),
    );
    if answered(status, untouched(&out)) {
        assert!(given.all(3));
        let p = written(&out);
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
    let given = bytes.given();
    let mut out = poisoned::<kstrip_creepage>();
    let status = kstrip_creepage_from_parameters(
        given.input(0, &contact),
        given.input(1, &wanted),
        given.output(2, &mut out),
    );
    if answered(status, untouched(&out)) {
        assert!(given.all(3));
        let k = written(&out);
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
        status_detail: bytes.integer(),
        reserved: bytes.integer(),
    };
    let given = bytes.given();
    let mut out = poisoned::<kstrip_result>();
    let status = kstrip_result_on_upper_body(given.input(0, &lower), given.output(1, &mut out));
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
        assert!((1..=5).contains(&model) && [4, 8, 16, 32, 64].contains(&strips));
    }
}

pub const ENTRIES: &[Entry] = &[
    ("material", material),
    ("combine", combine),
    ("hertz", hertz),
    ("velocities", velocities),
    ("parameters_from_creepage", parameters_from_creepage),
    ("creepage_from_parameters", creepage_from_parameters),
    ("upper_body", upper_body),
    ("texts", texts),
];
