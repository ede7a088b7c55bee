//! Instructions of the C functions, counted by callgrind through gungraun: 512 calls each, the creepages of
//! `benches/instructions.c`. A count that has grown by more than 3 % since the last run fails. `scripts/gungraun.sh` runs it.

use gungraun::prelude::*;
use gungraun::{Callgrind, EventKind};
use kstrip::ffi::double::{kstrip_solve, kstrip_solve_batch, kstrip_solve_jacobian};
use kstrip::ffi::single::kstrip_solve_f32;
use kstrip::ffi::types::*;
use kstrip::ffi::types_f32::*;
use kstrip::ffi::{
    KSTRIP_MODEL_LINEAR as LINEAR, KSTRIP_MODEL_STRIP as STRIP,
    KSTRIP_MODEL_STRIP_1967 as STRIP_1967, KSTRIP_MODEL_TOTAL as TOTAL,
};
use std::hint::black_box;
use std::mem::MaybeUninit;

const CALLS: usize = 512;

/// Contacts, creepages and options.
struct Calls {
    contacts: Vec<kstrip_contact>,
    creepages: Vec<kstrip_creepage>,
    contact: kstrip_contact_f32,
    motions: Vec<kstrip_creepage_f32>,
    options: kstrip_options,
    results: Vec<MaybeUninit<kstrip_result>>,
}

/// The fraction of `i` steps, less a half: spread evenly whatever the count.
fn spread(i: usize, step: f64) -> f64 {
    (i as f64 * step).fract() - 0.5
}

fn calls(model: i32, strips: i32) -> Calls {
    let contact = kstrip_contact {
        a: 6e-3,
        b: 4e-3,
        normal_force: 80e3,
        shear_modulus: 82e9,
        poisson_ratio: 0.28,
        friction: 0.3,
    };
    let creepages: Vec<_> = (0..CALLS)
        .map(|i| kstrip_creepage {
            longitudinal: spread(i, 0.618034) * 8e-3,
            lateral: spread(i, 0.381966) * 8e-3,
            spin: spread(i, 0.271828) * 1.5,
        })
        .collect();
    let motions = creepages.iter().map(|motion| kstrip_creepage_f32 {
        longitudinal: motion.longitudinal as f32,
        lateral: motion.lateral as f32,
        spin: motion.spin as f32,
    });
    Calls {
        motions: motions.collect(),
        contacts: vec![contact; CALLS],
        creepages,
        contact: kstrip_contact_f32 {
            a: 6e-3,
            b: 4e-3,
            normal_force: 80e3,
            shear_modulus: 82e9,
            poisson_ratio: 0.28,
            friction: 0.3,
        },
        options: kstrip_options { model, strips },
        results: vec![MaybeUninit::uninit(); CALLS],
    }
}

#[library_benchmark(setup = calls)]
#[bench::strip_1967_8(STRIP_1967, 8)]
#[bench::strip_1967_16(STRIP_1967, 16)]
#[bench::strip_16(STRIP, 16)]
#[bench::total(TOTAL, 16)]
#[bench::linear(LINEAR, 16)]
fn solve(mut calls: Calls) -> Calls {
    for (motion, result) in calls.creepages.iter().zip(&mut calls.results) {
        black_box(kstrip_solve(
            calls.contacts.first(),
            Some(motion),
            Some(&calls.options),
            Some(result),
        ));
    }
    calls
}

#[library_benchmark(setup = calls)]
#[bench::strip_1967_8(STRIP_1967, 8)]
#[bench::strip_1967_16(STRIP_1967, 16)]
#[bench::strip_16(STRIP, 16)]
#[bench::total(TOTAL, 16)]
#[bench::linear(LINEAR, 16)]
fn solve_f32(calls: Calls) -> Calls {
    for motion in &calls.motions {
        let mut result = MaybeUninit::uninit();
        let (contact, options) = (Some(&calls.contact), Some(&calls.options));
        black_box(kstrip_solve_f32(contact, Some(motion), options, Some(&mut result)));
        black_box(&result);
    }
    calls
}

#[library_benchmark(setup = calls)]
#[bench::strip_1967_16(STRIP_1967, 16)]
#[bench::strip_16(STRIP, 16)]
#[bench::total(TOTAL, 16)]
#[bench::linear(LINEAR, 16)]
fn solve_jacobian(mut calls: Calls) -> Calls {
    for (motion, result) in calls.creepages.iter().zip(&mut calls.results) {
        let mut slopes = [0.0; 9];
        let (contact, options) = (calls.contacts.first(), Some(&calls.options));
        // SAFETY: nine numbers, as the function asks for.
        black_box(unsafe {
            kstrip_solve_jacobian(contact, Some(motion), options, Some(result), slopes.as_mut_ptr())
        });
        black_box(slopes);
    }
    calls
}

#[library_benchmark(setup = calls)]
#[bench::strip_1967_16(STRIP_1967, 16)]
#[bench::strip_16(STRIP, 16)]
#[bench::total(TOTAL, 16)]
#[bench::linear(LINEAR, 16)]
fn solve_batch(mut calls: Calls) -> Calls {
    // SAFETY: `CALLS` of each.
    black_box(unsafe {
        kstrip_solve_batch(
            calls.contacts.as_ptr(),
            calls.creepages.as_ptr(),
            CALLS as u32,
            Some(&calls.options),
            calls.results.as_mut_ptr().cast(),
        )
    });
    calls
}

library_benchmark_group!(
    name = c_interface,
    benchmarks = [solve, solve_f32, solve_jacobian, solve_batch]
);

main!(
    config = LibraryBenchmarkConfig::default()
        .tool(Callgrind::default().soft_limits([(EventKind::Ir, 3.0)])),
    library_benchmark_groups = c_interface
);
