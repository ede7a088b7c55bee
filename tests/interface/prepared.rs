//! A prepared contact gives the bits of `kstrip_solve`, and nothing that was not prepared is taken for one.

use crate::names::*;
use crate::random::Random;

use std::mem::MaybeUninit;

macro_rules! same_bits {
    ($name:ident, $float:ident, $contact:ident, $creepage:ident, $result:ident, $solve:ident, $prepare:ident,
     $prepared:ident) => {
        #[test]
        fn $name() {
            let mut random = Random::new(7);
            for n in 0..4000 {
                let contact = $contact {
                    a: (4e-3 * random.log_between(0.02, 50.0)) as $float,
                    b: 4e-3,
                    normal_force: if n % 9 == 0 {
                        0.0
                    } else {
                        random.log_between(1.0, 1e6) as $float
                    },
                    shear_modulus: 82e9,
                    poisson_ratio: random.between(0.0, 0.5) as $float,
                    friction: if n % 11 == 0 { 0.0 } else { random.between(0.01, 0.6) as $float },
                    mismatch: if n % 5 == 0 { random.between(-0.2, 0.2) as $float } else { 0.0 },
                };
                let options = kstrip_options {
                    model: n % 6,
                    strips: [0, 4, 8, 16, 32, 64][(n / 6) as usize % 6],
                };
                let mut prepared = MaybeUninit::uninit();
                assert_eq!($prepare(Some(&contact), Some(&options), Some(&mut prepared)), 0);
                // SAFETY: status 0.
                let prepared = unsafe { prepared.assume_init() };
                for k in 0..4 {
                    let size = random.log_between(1e-7, 1.0);
                    let mut part = |zero| {
                        if zero { 0.0 } else { (size * random.between(-1.0, 1.0)) as $float }
                    };
                    let creepage = $creepage {
                        longitudinal: part(k == 1),
                        lateral: part(k == 2),
                        spin: part(k == 3) * 100.0,
                    };
                    let (mut one, mut other) = (MaybeUninit::uninit(), MaybeUninit::uninit());
                    let status =
                        $solve(Some(&contact), Some(&creepage), Some(&options), Some(&mut one));
                    let same = $prepared(Some(&prepared), Some(&creepage), Some(&mut other));
                    assert!(status >= 0 && status == same, "{status} {same}");
                    // SAFETY: written.
                    let (one, other): ($result, $result) =
                        unsafe { (one.assume_init(), other.assume_init()) };
                    let bits =
                        |r: $result| [r.fx, r.fy, r.mz, r.power, r.adhesion].map($float::to_bits);
                    assert_eq!(bits(one), bits(other), "{options:?} {contact:?} {creepage:?}");
                    assert_eq!(one.notice, other.notice);
                }
            }
        }
    };
}

same_bits!(
    prepared_contacts_give_the_same_bits,
    f64,
    kstrip_contact,
    kstrip_creepage,
    kstrip_result,
    kstrip_solve,
    kstrip_prepare,
    kstrip_solve_prepared
);
same_bits!(
    prepared_contacts_give_the_same_bits_in_single_precision,
    f32,
    kstrip_contact_f32,
    kstrip_creepage_f32,
    kstrip_result_f32,
    kstrip_solve_f32,
    kstrip_prepare_f32,
    kstrip_solve_prepared_f32
);

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
        let mut out = MaybeUninit::new(kstrip_result::nothing());
        let mut prepared = filled(byte);
        assert_eq!(solve(&prepared, &mut out), KSTRIP_ERROR_NOT_PREPARED);
        for model in 1..=5 {
            (prepared.model, prepared.strips) = (model, 16);
            assert_eq!(solve(&prepared, &mut out), KSTRIP_ERROR_NOT_PREPARED, "{byte} {model}");
        }
    }
}

/// Prepared for each model, as numbers and as the structure again.
fn prepared_for(model: i32) -> kstrip_prepared {
    let contact = kstrip_contact {
        a: 6e-3,
        b: 4e-3,
        normal_force: 80e3,
        shear_modulus: 82e9,
        poisson_ratio: 0.28,
        friction: 0.3,
        mismatch: 0.0,
    };
    let options = kstrip_options { model, strips: 16 };
    let mut prepared = MaybeUninit::uninit();
    assert_eq!(kstrip_prepare(Some(&contact), Some(&options), Some(&mut prepared)), 0);
    // SAFETY: status 0.
    unsafe { prepared.assume_init() }
}

/// A structure with one bit changed is refused, or the bit is one that the answer does not depend on.
#[test]
fn a_damaged_structure_is_refused() {
    for model in 1..=5 {
        let whole = prepared_for(model);
        for creepage in [[1e-3, -5e-4, 0.1], [30.0, 0.0, 200.0]] {
            let [longitudinal, lateral, spin] = creepage;
            let creepage = kstrip_creepage { longitudinal, lateral, spin };
            let solve = |prepared: &kstrip_prepared| {
                let mut out = MaybeUninit::new(kstrip_result::nothing());
                let status = kstrip_solve_prepared(Some(prepared), Some(&creepage), Some(&mut out));
                // SAFETY: written at the start.
                (status, unsafe { out.assume_init() })
            };
            let right = solve(&whole);
            let (mut refused, bits) = (0, 8 * size_of::<kstrip_prepared>());
            for bit in 0..bits {
                let mut damaged = whole;
                // SAFETY: a byte of the structure, of which any bits are a value.
                unsafe { *(&raw mut damaged).cast::<u8>().add(bit / 8) ^= 1 << (bit % 8) };
                let found = solve(&damaged);
                refused += usize::from(found.0 == KSTRIP_ERROR_NOT_PREPARED);
                assert!(found.0 == KSTRIP_ERROR_NOT_PREPARED || found == right, "{model} {bit}");
            }
            println!(
                "model {model}: {refused} of {bits} single bit flips refused, no answer changed"
            );
            assert!(refused >= 64 * 8);
        }
    }
}

/// What was prepared in one precision is refused by the other.
#[test]
fn the_other_precision_is_refused() {
    let creepage = kstrip_creepage_f32 { longitudinal: 1e-3, lateral: 0.0, spin: 0.0 };
    for model in 1..=5 {
        let double = prepared_for(model);
        let mut single = MaybeUninit::<kstrip_prepared_f32>::uninit();
        // SAFETY: the numbers fit, and any bits are a value.
        let mut single = unsafe {
            single
                .as_mut_ptr()
                .cast::<u8>()
                .copy_from((&raw const double).cast(), size_of::<kstrip_prepared_f32>());
            single.assume_init()
        };
        (single.model, single.strips) = (model, 16);
        let mut out = MaybeUninit::uninit();
        let status = kstrip_solve_prepared_f32(Some(&single), Some(&creepage), Some(&mut out));
        assert_eq!(status, KSTRIP_ERROR_NOT_PREPARED, "{model}");
    }
}
