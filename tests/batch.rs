//! Batches give the bits of single solves, whatever the layout of the arrays; bad input touches nothing.

#[path = "common/random.rs"]
mod random;

use kstrip::ffi::batch::*;
use kstrip::ffi::double::{kstrip_solve, kstrip_solve_batch};
use kstrip::ffi::single::kstrip_solve_f32;
use kstrip::ffi::types::*;
use kstrip::ffi::types_f32::*;
use kstrip::ffi::{KSTRIP_ERROR_FRICTION, KSTRIP_ERROR_NULL, KSTRIP_OK};
use random::Random;
use std::mem::MaybeUninit;
use std::ptr::null_mut;

const COUNT: usize = 203;

/// Nine inputs of contacts of all kinds, array by array; the first is at rest, some have extreme spin.
fn inputs() -> [Vec<f64>; 9] {
    let mut random = Random::new(21);
    let mut arrays: [Vec<f64>; 9] = Default::default();
    for i in 0..COUNT {
        let b = 4e-3;
        let size = if i == 0 { 0.0 } else { random.log_between(1e-6, 0.1) };
        let values = [
            b * random.log_between(0.05, 20.0),
            b,
            if i == 1 { 0.0 } else { random.log_between(1e3, 2e5) },
            82e9,
            random.between(0.0, 0.5),
            random.between(0.05, 0.6),
            size * random.between(-1.0, 1.0),
            size * random.between(-1.0, 1.0),
            if i % 7 == 3 {
                0.0
            } else {
                random.between(-1.0, 1.0) * random.log_between(1e-3, 1e3)
            },
        ];
        for (array, value) in arrays.iter_mut().zip(values) {
            array.push(value);
        }
    }
    arrays
}

fn options() -> impl Iterator<Item = kstrip_options> {
    (1..=5).flat_map(|model| [4, 16].map(|strips| kstrip_options { model, strips }))
}

macro_rules! same_bits {
    ($name:ident, $float:ident, $inputs:ident, $outputs:ident, $contact:ident, $creepage:ident, $solve:ident, $batch:ident) => {
        #[test]
        fn $name() {
            let arrays = inputs().map(|a| a.iter().map(|x| *x as $float).collect::<Vec<_>>());
            let [a, b, n, g, nu, mu, vx, vy, phi] = arrays.each_ref().map(|array| array.as_ptr());
            let from = $inputs {
                a,
                b,
                normal_force: n,
                shear_modulus: g,
                poisson_ratio: nu,
                friction: mu,
                longitudinal: vx,
                lateral: vy,
                spin: phi,
            };
            for options in options() {
                let mut found: [Vec<$float>; 5] = std::array::from_fn(|_| vec![7.0; COUNT]);
                let mut details = vec![99; COUNT];
                let [fx, fy, mz, power, adhesion] =
                    found.each_mut().map(|array| array.as_mut_ptr());
                let to =
                    $outputs { fx, fy, mz, power, adhesion, status_detail: details.as_mut_ptr() };
                let status =
                    unsafe { $batch(COUNT as u32, Some(&from), Some(&options), Some(&to)) };
                let mut worst = KSTRIP_OK;
                for i in 0..COUNT {
                    let [a, b, normal_force, shear_modulus, poisson_ratio, friction, x, y, spin] =
                        arrays.each_ref().map(|array| array[i]);
                    let contact =
                        $contact { a, b, normal_force, shear_modulus, poisson_ratio, friction };
                    let creepage = $creepage { longitudinal: x, lateral: y, spin };
                    let mut result = MaybeUninit::uninit();
                    let single =
                        $solve(Some(&contact), Some(&creepage), Some(&options), Some(&mut result));
                    assert!(single >= KSTRIP_OK);
                    worst = worst.max(single);
                    let r = unsafe { result.assume_init() };
                    let expected = [r.fx, r.fy, r.mz, r.power, r.adhesion].map($float::to_bits);
                    let is = found.each_ref().map(|array| array[i].to_bits());
                    assert_eq!(is, expected, "{options:?} {contact:?} {creepage:?}");
                    assert_eq!(details[i], r.status_detail);
                }
                assert_eq!(status, worst);
            }
        }
    };
}

same_bits!(
    arrays_give_the_bits_of_single_solves,
    f64,
    kstrip_batch_inputs,
    kstrip_batch_outputs,
    kstrip_contact,
    kstrip_creepage,
    kstrip_solve,
    kstrip_solve_batch_arrays
);
same_bits!(
    single_precision_arrays_too,
    f32,
    kstrip_batch_inputs_f32,
    kstrip_batch_outputs_f32,
    kstrip_contact_f32,
    kstrip_creepage_f32,
    kstrip_solve_f32,
    kstrip_solve_batch_arrays_f32
);

#[test]
fn structures_give_the_bits_of_single_solves() {
    let arrays = inputs();
    let of = |i: usize| arrays.each_ref().map(|array| array[i]);
    let contacts: Vec<_> = (0..COUNT)
        .map(|i| {
            let [a, b, normal_force, shear_modulus, poisson_ratio, friction, ..] = of(i);
            kstrip_contact { a, b, normal_force, shear_modulus, poisson_ratio, friction }
        })
        .collect();
    let creepages: Vec<_> = (0..COUNT)
        .map(|i| {
            let [.., longitudinal, lateral, spin] = of(i);
            kstrip_creepage { longitudinal, lateral, spin }
        })
        .collect();
    for options in options() {
        // every length up to a few registers, then all
        for count in (0..10).chain([COUNT]) {
            let mut results = vec![MaybeUninit::<kstrip_result>::uninit(); count];
            let status = unsafe {
                let out = results.as_mut_ptr().cast();
                let (contacts, creepages) = (contacts.as_ptr(), creepages.as_ptr());
                kstrip_solve_batch(contacts, creepages, count as u32, Some(&options), out)
            };
            assert!(status >= KSTRIP_OK);
            for i in 0..count {
                let mut single = MaybeUninit::uninit();
                kstrip_solve(
                    Some(&contacts[i]),
                    Some(&creepages[i]),
                    Some(&options),
                    Some(&mut single),
                );
                let (is, expected) = unsafe { (results[i].assume_init(), single.assume_init()) };
                let bits = |r: kstrip_result| {
                    ([r.fx, r.fy, r.mz, r.power, r.adhesion].map(f64::to_bits), r.status_detail)
                };
                assert_eq!(bits(is), bits(expected), "{options:?} {:?}", contacts[i]);
            }
        }
    }
}

#[test]
fn only_what_is_wanted_is_written_and_nothing_on_errors() {
    let mut arrays = inputs();
    let from = |arrays: &[Vec<f64>; 9]| {
        let [a, b, n, g, nu, mu, vx, vy, phi] = arrays.each_ref().map(|array| array.as_ptr());
        kstrip_batch_inputs {
            a,
            b,
            normal_force: n,
            shear_modulus: g,
            poisson_ratio: nu,
            friction: mu,
            longitudinal: vx,
            lateral: vy,
            spin: phi,
        }
    };
    let nothing = kstrip_batch_outputs {
        fx: null_mut(),
        fy: null_mut(),
        mz: null_mut(),
        power: null_mut(),
        adhesion: null_mut(),
        status_detail: null_mut(),
    };
    let count = COUNT as u32;
    let mut fy = vec![7.0; COUNT];
    let wanted = kstrip_batch_outputs { fy: fy.as_mut_ptr(), ..nothing };
    unsafe {
        assert!(kstrip_solve_batch_arrays(count, Some(&from(&arrays)), None, Some(&wanted)) >= 0);
        assert!(kstrip_solve_batch_arrays(count, Some(&from(&arrays)), None, Some(&nothing)) >= 0);
    }
    assert!(fy.iter().all(|fy| *fy != 7.0));
    // Whatever else is wanted, a quantity has the same bits
    let mut found: [Vec<f64>; 5] = std::array::from_fn(|_| vec![7.0; COUNT]);
    for options in options() {
        let mut whole: Option<[Vec<f64>; 5]> = None;
        for mask in (0..32_u32).rev() {
            let place = |i: usize, array: &mut Vec<f64>| {
                if mask >> i & 1 == 1 { array.as_mut_ptr() } else { null_mut() }
            };
            let [fx, fy, mz, power, adhesion] = &mut found;
            let wanted = kstrip_batch_outputs {
                fx: place(0, fx),
                fy: place(1, fy),
                mz: place(2, mz),
                power: place(3, power),
                adhesion: place(4, adhesion),
                ..nothing
            };
            let (from, options) = (from(&arrays), Some(&options));
            unsafe {
                assert!(kstrip_solve_batch_arrays(count, Some(&from), options, Some(&wanted)) >= 0);
            }
            let whole = whole.get_or_insert_with(|| found.clone());
            assert!(found == *whole, "{mask} {options:?}");
        }
    }

    arrays[5][COUNT - 1] = -0.1;
    fy.fill(7.0);
    let wanted = kstrip_batch_outputs { fy: fy.as_mut_ptr(), ..nothing };
    let solve = |from: Option<&kstrip_batch_inputs>, to: Option<&kstrip_batch_outputs>| unsafe {
        kstrip_solve_batch_arrays(count, from, None, to)
    };
    assert_eq!(solve(Some(&from(&arrays)), Some(&wanted)), KSTRIP_ERROR_FRICTION);
    let missing = kstrip_batch_inputs { spin: std::ptr::null(), ..from(&arrays) };
    assert_eq!(solve(Some(&missing), Some(&wanted)), KSTRIP_ERROR_NULL);
    assert_eq!(solve(None, Some(&wanted)), KSTRIP_ERROR_NULL);
    assert_eq!(solve(Some(&from(&arrays)), None), KSTRIP_ERROR_NULL);
    assert!(fy.iter().all(|fy| *fy == 7.0));
    let empty = kstrip_batch_inputs { a: std::ptr::null(), ..missing };
    assert_eq!(
        unsafe { kstrip_solve_batch_arrays(0, Some(&empty), None, Some(&wanted)) },
        KSTRIP_OK
    );
}
