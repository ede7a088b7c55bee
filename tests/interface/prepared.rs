//! A prepared contact gives the bits of `kstrip_solve`, and nothing that was not prepared is taken
//! for one.

use kstrip::forces::prepared::Prepared;
use kstrip_testing::in_c::{InC, bits_of};
use kstrip_testing::names::*;
use kstrip_testing::prelude::*;

fn same_bits<F: InC>() {
    let mut random = Random::new(7);
    for n in 0..4000 {
        let load = if n % 9 == 0 { 0.0 } else { random.log_between(1.0, 1e6) };
        let friction = if n % 11 == 0 { 0.0 } else { random.between(0.01, 0.6) };
        let mismatch = if n % 5 == 0 { random.between(-0.2, 0.2) } else { 0.0 };
        let (a, nu) = (4e-3 * random.log_between(0.02, 50.0), random.between(0.0, 0.5));
        let strips = [0, 4, 8, 16, 32, 64][(n / 6) as usize % 6];
        let options = kstrip_options { model: n % 6, strips };
        for k in 0..4 {
            let size = random.log_between(1e-7, 1.0);
            let mut part = |zero| if zero { 0.0 } else { size * random.between(-1.0, 1.0) };
            let [x, y, spin] = [part(k == 1), part(k == 2), 100.0 * part(k == 3)];
            let numbers = [a, 4e-3, load, 82e9, nu, friction, x, y, spin, mismatch];
            let (contact, creepage) = problem(numbers.map(F::of));
            let prepared = prepared(&contact, &options);
            let mut found = [MaybeUninit::<Solution<F>>::uninit(); 2];
            let [one, other] = &mut found;
            let status = F::solve((&contact, &creepage, &options), one);
            let same = F::solve_prepared(&prepared, &creepage, other);
            assert!(status >= 0 && status == same, "{status} {same}");
            // SAFETY: written.
            let [one, other] = found.map(|found| unsafe { found.assume_init() });
            let bits = |r: Solution<F>| (bits_of(&r), r.warning);
            assert_eq!(bits(one), bits(other), "{options:?} {contact:?} {creepage:?}");
        }
    }
}

#[test]
fn prepared_contacts_give_the_same_bits() {
    same_bits::<f64>();
    same_bits::<f32>();
}

fn prepared<F: InC>(contact: &Contact<F>, options: &kstrip_options) -> Prepared<F> {
    let mut prepared = MaybeUninit::uninit();
    assert_eq!(F::prepare(contact, options, &mut prepared), 0);
    // SAFETY: status 0.
    unsafe { prepared.assume_init() }
}

/// A prepared contact warns of a spin where `kstrip_solve` does, just above the limit as well: the
/// larger of `0.05/√(a b)` and `5 p₀/(G a)`.
#[test]
fn prepared_contacts_warn_of_spin_from_the_same_place_on() {
    let mut random = Random::new(8);
    for n in 0..400 {
        let (a, pressure) = (4e-3 * random.log_between(0.1, 10.0), random.log_between(1e7, 7e9));
        let load = pressure * PI * a * 4e-3 / 1.5;
        let limit = (0.05 / (a * 4e-3).sqrt()).max(5.0 * pressure / (82e9 * a));
        let (share, warns) = [(0.99, false), (1.01, true)][n as usize % 2];
        let numbers = [a, 4e-3, load, 82e9, 0.28, 0.3, 1e-4, 0.0, share * limit, 0.0];
        let (contact, creepage) = problem(numbers);
        let options = kstrip_options { model: [3, 4, 5][n as usize % 3], strips: 8 };
        let prepared = prepared(&contact, &options);
        let mut found = MaybeUninit::<Solution<f64>>::uninit();
        let status =
            kstrip_solve(Some(&contact), Some(&creepage), Some(&options), Some(&mut found));
        let same = kstrip_solve_prepared(Some(&prepared), Some(&creepage), Some(&mut found));
        assert_eq!(status, same, "{contact:?} {creepage:?}");
        assert_eq!(status == KSTRIP_WARNING_SPIN_UNIT, warns, "{contact:?} {creepage:?}");
    }
}

/// The same of a pressure above `0.1 G`, whatever the spin is.
#[test]
fn prepared_contacts_warn_of_pressure_from_the_same_place_on() {
    for (share, warns) in [(0.99, false), (1.01, true)] {
        for spin in [0.0, 1e-3, -0.1] {
            let load = share * 0.1 * 82e9 * PI * 6e-3 * 4e-3 / 1.5;
            let (contact, creepage) =
                problem([6e-3, 4e-3, load, 82e9, 0.28, 0.3, 1e-4, 0.0, spin, 0.0]);
            let options = kstrip_options { model: 3, strips: 8 };
            let prepared = prepared(&contact, &options);
            let mut found = MaybeUninit::<Solution<f64>>::uninit();
            let status = kstrip_solve_prepared(Some(&prepared), Some(&creepage), Some(&mut found));
            assert_eq!(status == KSTRIP_WARNING_PRESSURE, warns, "{status} {share} {spin}");
        }
    }
}

/// Zero, and any other bits, with a model and without.
#[test]
fn what_is_not_prepared_is_refused() {
    let creepage = kstrip_creepage { longitudinal: 1e-3, lateral: 0.0, spin: 0.0 };
    let solve = |prepared: &kstrip_prepared, out: &mut MaybeUninit<kstrip_result>| {
        kstrip_solve_prepared(Some(prepared), Some(&creepage), Some(out))
    };
    // SAFETY: any bits are a value of the structure.
    let filled = |byte: u8| unsafe {
        let mut prepared = MaybeUninit::<kstrip_prepared>::uninit();
        prepared.as_mut_ptr().write_bytes(byte, 1);
        prepared.assume_init()
    };
    for byte in 0..=255 {
        let mut out = MaybeUninit::new(kstrip_result::default());
        let mut prepared = filled(byte);
        assert_eq!(solve(&prepared, &mut out), KSTRIP_ERROR_NOT_PREPARED);
        for model in 1..=5 {
            (prepared.model, prepared.strips) = (model, 16);
            assert_eq!(solve(&prepared, &mut out), KSTRIP_ERROR_NOT_PREPARED, "{byte} {model}");
        }
    }
}

/// A contact that is prepared for a model.
fn prepared_for(model: i32) -> kstrip_prepared {
    let (contact, _) = problem([6e-3, 4e-3, 80e3, 82e9, 0.28, 0.3, 0.0, 0.0, 0.0, 0.0]);
    prepared(&contact, &kstrip_options { model, strips: 16 })
}

/// A structure is refused whose mark has another bit, or that says it was made for another model.
#[test]
fn a_mark_tells_the_model() {
    let creepage = kstrip_creepage { longitudinal: 1e-3, lateral: -5e-4, spin: 0.1 };
    let solve = |prepared: &kstrip_prepared| {
        let mut out = MaybeUninit::new(kstrip_result::default());
        kstrip_solve_prepared(Some(prepared), Some(&creepage), Some(&mut out))
    };
    for model in 1..=5 {
        let whole = prepared_for(model);
        assert_eq!(solve(&whole), KSTRIP_OK);
        for other in (0..=6).filter(|other| *other != model) {
            let status = solve(&kstrip_prepared { model: other, ..whole });
            assert_eq!(status, KSTRIP_ERROR_NOT_PREPARED, "{model} {other}");
        }
        for bit in 0..64 {
            let mut damaged = whole;
            // SAFETY: a byte of the first number, of which any bits are a value.
            unsafe { *(&raw mut damaged).cast::<u8>().add(bit / 8) ^= 1 << (bit % 8) };
            assert_eq!(solve(&damaged), KSTRIP_ERROR_NOT_PREPARED, "{model} {bit}");
        }
    }
}

#[test]
fn the_other_precision_is_refused() {
    let creepage = Creepage::<f32> { longitudinal: 1e-3, lateral: 0.0, spin: 0.0 };
    for model in 1..=5 {
        let double = prepared_for(model);
        let mut single = MaybeUninit::<single::kstrip_prepared>::uninit();
        // SAFETY: the numbers fit, and any bits are a value.
        let mut single = unsafe {
            single
                .as_mut_ptr()
                .cast::<u8>()
                .copy_from((&raw const double).cast(), size_of::<single::kstrip_prepared>());
            single.assume_init()
        };
        (single.model, single.strips) = (model, 16);
        let mut out = MaybeUninit::uninit();
        let status = f32::solve_prepared(&single, &creepage, &mut out);
        assert_eq!(status, KSTRIP_ERROR_NOT_PREPARED, "{model}");
    }
}
