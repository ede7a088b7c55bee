//! Patches whose strips have creepages of their own: `kstrip_patch_evaluate_strips`.

use kstrip_testing::names::*;
use kstrip_testing::poison::{poisoned, untouched};
use kstrip_testing::prelude::*;

const MOTION: kstrip_creepage = creep(8e-4, -6e-4, 0.1);
const REST: kstrip_creepage = creep(0.0, 0.0, 0.0);
const STRIP: kstrip_options = kstrip_options { model: KSTRIP_MODEL_STRIP, strips: 16 };

fn patch() -> kstrip_patch {
    let contact = kstrip_contact { b: 4e-3, ..C0 };
    let mut patch = MaybeUninit::uninit();
    assert_eq!(kstrip_patch_from_contact(Some(&contact), Some(&STRIP), Some(&mut patch)), 0);
    // SAFETY: status 0.
    unsafe { patch.assume_init() }
}

type Answer = (kstrip_result, kstrip_derivatives);

/// Status, and result and derivatives where it is not an error; else these keep their bytes. Of
/// kstrip_patch_evaluate without creepages of strips.
fn evaluate(
    patch: &kstrip_patch, motion: &kstrip_creepage, own: Option<&[kstrip_creepage]>,
    law: Option<&kstrip_friction>, options: &kstrip_options,
) -> (i32, Option<Answer>) {
    let (mut result, mut by) = ([poisoned()], [poisoned()]);
    let outputs = kstrip_outputs {
        result: result[0].as_mut_ptr(),
        derivatives: by[0].as_mut_ptr(),
        ..nowhere()
    };
    let (patch, motion) = (Some(patch), Some(motion));
    let (options, outputs) = (Some(options), Some(&outputs));
    // SAFETY: each pointer is NULL or valid, and there are as many creepages as strips.
    let status = unsafe {
        match own.map(<[_]>::as_ptr) {
            None => kstrip_patch_evaluate(patch, motion, law, options, outputs),
            Some(own) => kstrip_patch_evaluate_strips(patch, motion, own, law, options, outputs),
        }
    };
    if status < 0 {
        assert!(untouched(&result) && untouched(&by));
        return (status, None);
    }
    // SAFETY: no error: both are written.
    (status, Some(unsafe { (result[0].assume_init(), by[0].assume_init()) }))
}

fn found(
    patch: &kstrip_patch, motion: &kstrip_creepage, own: Option<&[kstrip_creepage]>,
    law: Option<&kstrip_friction>,
) -> Answer {
    evaluate(patch, motion, own, law, &STRIP).1.expect("no error")
}

/// All numbers: forces, moment, power; derivatives with respect to the motion, load and friction.
fn numbers((result, by): &Answer) -> Vec<f64> {
    let rows = [by.normal_force, by.load_through_hertz, by.friction];
    let forces = [result.fx, result.fy, result.mz, result.power];
    [&forces[..], by.jacobian.as_flattened(), rows.as_flattened()].concat()
}

fn falling() -> kstrip_friction {
    kstrip_testing::prelude::falling(0.3, 0.4, 0.6, 20.0, 0.8)
}

/// What each strip sees of a rigid motion, as its own.
fn of_rigid(patch: &kstrip_patch, motion: &kstrip_creepage) -> Vec<kstrip_creepage> {
    let kstrip_creepage { longitudinal, lateral, spin } = *motion;
    let own = |strip: &kstrip_patch_strip| {
        creep(longitudinal - spin * strip.y, lateral + spin * strip.centre_x, spin)
    };
    patch.used().iter().map(own).collect()
}

#[test]
fn creepages_of_strips_that_are_zero_change_no_bit() {
    let patch = patch();
    let none = vec![REST; patch.count as usize];
    let law = falling();
    for law in [None, Some(&law)] {
        let plain = numbers(&found(&patch, &MOTION, None, law));
        assert_eq!(numbers(&found(&patch, &MOTION, Some(&none), law)), plain);
        // the motion may also be all the strips' own
        let own = of_rigid(&patch, &MOTION);
        let numbers = numbers(&found(&patch, &REST, Some(&own), law));
        for (number, expected) in numbers.iter().zip(&plain) {
            let off = (number - expected).abs();
            assert!(off < 1e-9 * (expected.abs() + 1.0), "{number} {expected}");
        }
    }
}

/// Slip that varies as over a surface whose normal turns: the jacobian is that of differences, and
/// the power is that of each strip's force and creepage.
#[test]
fn slip_that_varies_has_the_slopes_of_differences() {
    let patch = patch();
    let strips = &patch.strips[..patch.count as usize];
    let varied = |strip: &kstrip_patch_strip| creep(0.2 * strip.y, -3e-2 * strip.y, 40.0 * strip.y);
    let own: Vec<_> = strips.iter().map(varied).collect();
    let law = falling();
    for law in [None, Some(&law)] {
        let (here, by) = found(&patch, &MOTION, Some(&own), law);
        let (uniform, _) = found(&patch, &MOTION, None, law);
        assert!((here.fx - uniform.fx).hypot(here.fy - uniform.fy) > 100.0);
        for k in 0..3 {
            let step = [1e-8, 1e-8, 1e-6][k];
            let [after, before] = [step, -step].map(|step| {
                let mut moved = MOTION;
                let kstrip_creepage { longitudinal, lateral, spin } = &mut moved;
                *[longitudinal, lateral, spin][k] += step;
                force_and_moment(&found(&patch, &moved, Some(&own), law).0)
            });
            let largest = by.jacobian.iter().map(|row| row[k].abs()).fold(0.0, f64::max);
            for (row, (after, before)) in by.jacobian.iter().zip(after.iter().zip(before)) {
                let slope = (after - before) / (2.0 * step);
                assert!((row[k] - slope).abs() < 1e-5 * largest, "{k}: {} {slope}", row[k]);
            }
        }
        assert!(here.power > 0.0);
    }
}

#[test]
fn bad_creepages_of_strips_are_refused() {
    let good = patch();
    let mut own = vec![creep(1e-3, 0.0, 0.0); good.count as usize];
    assert_eq!(evaluate(&good, &MOTION, Some(&own), None, &STRIP).0, 0);
    let total = kstrip_options { model: KSTRIP_MODEL_TOTAL, strips: 0 };
    let (status, _) = evaluate(&good, &MOTION, Some(&own), None, &total);
    assert_eq!(status, KSTRIP_ERROR_NOT_IN_MODEL);
    let crowded = kstrip_patch { count: u32::MAX, ..good };
    let many = vec![REST; kstrip::patch::KSTRIP_PATCH_CAPACITY];
    assert!(evaluate(&crowded, &MOTION, Some(&many), None, &STRIP).0 < 0);
    for bad in [f64::NAN, f64::INFINITY] {
        for k in 0..3 {
            let [x, y, spin] = std::array::from_fn(|i| if i == k { bad } else { 0.0 });
            *own.last_mut().expect("strips") = creep(x, y, spin);
            let (status, _) = evaluate(&good, &MOTION, Some(&own), None, &STRIP);
            assert_eq!(status, KSTRIP_ERROR_NOT_FINITE);
        }
    }
}

/// The strips of unlike bodies with a layer between them add up to the forces: the law multiplies
/// stiffness and mismatch alike.
#[test]
fn strips_of_unlike_bodies_under_a_law_add_up() {
    let contact = kstrip_contact { b: 4e-3, mismatch: 0.3, ..C0 };
    for layer in [0.0, 1e-14] {
        let law = kstrip_friction { slope_factor: 0.4, layer, ..falling() };
        let (mut result, mut count) = (MaybeUninit::uninit(), MaybeUninit::uninit());
        let mut strips = [const { MaybeUninit::<kstrip_strip>::uninit() }; 16];
        let outputs = kstrip_outputs {
            result: result.as_mut_ptr(),
            strips: strips[0].as_mut_ptr(),
            capacity: 16,
            count: count.as_mut_ptr(),
            ..nowhere()
        };
        let (motion, law) = (Some(&MOTION), Some(&law));
        // SAFETY: each pointer is NULL or valid.
        let (status, result, count, strips) = unsafe {
            let to = Some(&outputs);
            let status = kstrip_evaluate(Some(&contact), motion, law, Some(&STRIP), to);
            assert!(status >= 0, "{status}");
            (status, result.assume_init(), count.assume_init(), strips.map(|s| s.assume_init()))
        };
        assert_eq!(count, 16, "{status}");
        let sum = |of: fn(&kstrip_strip) -> f64| strips.iter().map(of).sum::<f64>();
        assert_relative_eq!(sum(|s| s.fx), result.fx, max_relative = 1e-12);
        assert_relative_eq!(sum(|s| s.fy), result.fy, max_relative = 1e-12);
        assert_relative_eq!(sum(|s| s.power), result.power, max_relative = 1e-12);
    }
}
