//! Calls for many contacts at once, and calls that want the forces alone.

use crate::calls::{CONTACT, creepages};
use crate::clock;
use kstrip::ffi::{
    KSTRIP_WANT_FORCES, batch::*, double, evaluate::*, single, types::*, types_f32::*,
};
use kstrip::solve::model::Model;
use std::cell::RefCell;
use std::hint::black_box;
use std::ptr::null_mut;

/// How many contacts a batch is measured with.
pub const CONTACTS: [usize; 5] = [100, 1000, 10_000, 100_000, 1_000_000];

/// How many contacts are solved.
#[derive(Clone, Copy)]
pub enum How {
    /// A loop over `kstrip_solve`.
    OneByOne,
    /// `kstrip_solve_batch`
    Structures,
    /// `kstrip_solve_batch_arrays`
    Arrays,
    /// A loop over `kstrip_evaluate` that wants the forces alone.
    ForcesAlone,
}

macro_rules! contacts {
    (
        $module:ident, $float:ty, $contact:ident, $creepage:ident, $result:ident, $inputs:ident, $outputs:ident,
        $solve:path, $batch:path, $arrays:ident, $evaluate:ident
    ) => {
        /// In this precision.
        pub mod $module {
            use super::*;

            /// Contacts and room for their results, as structures and as arrays.
            pub struct Contacts {
                contacts: Vec<$contact>,
                creepages: Vec<$creepage>,
                results: Vec<$result>,
                inputs: [Vec<$float>; 9],
                outputs: [Vec<$float>; 5],
                details: Vec<i32>,
            }

            impl Contacts {
                pub fn new(count: usize) -> Self {
                    let [a, b, normal_force, shear_modulus, poisson_ratio, friction] =
                        CONTACT.map(|x| x as $float);
                    let contact =
                        $contact { a, b, normal_force, shear_modulus, poisson_ratio, friction };
                    let motion: Vec<[$float; 3]> =
                        creepages().iter().map(|k| k.map(|x| x as $float)).collect();
                    let motion: Vec<_> = motion.into_iter().cycle().take(count).collect();
                    let mut inputs: [Vec<$float>; 9] = Default::default();
                    for (array, value) in inputs.iter_mut().zip(CONTACT) {
                        *array = vec![value as $float; count];
                    }
                    for (k, array) in inputs[6..].iter_mut().enumerate() {
                        *array = motion.iter().map(|motion| motion[k]).collect();
                    }
                    let creepage = |[longitudinal, lateral, spin]: &[$float; 3]| $creepage {
                        longitudinal: *longitudinal,
                        lateral: *lateral,
                        spin: *spin,
                    };
                    let zero = 0.0;
                    let result = $result {
                        fx: zero,
                        fy: zero,
                        mz: zero,
                        power: zero,
                        adhesion: zero,
                        status_detail: 0,
                        reserved: 0,
                    };
                    Self {
                        contacts: vec![contact; count],
                        creepages: motion.iter().map(creepage).collect(),
                        results: vec![result; count],
                        inputs,
                        outputs: std::array::from_fn(|_| vec![0.0; count]),
                        details: vec![0; count],
                    }
                }

                /// The first `count` of them.
                pub fn solve(&mut self, count: usize, model: Model, how: How) {
                    assert!(count <= self.contacts.len());
                    let options = kstrip_options { model: model as i32, strips: 16 };
                    let (contacts, creepages) = (&self.contacts[..count], &self.creepages[..count]);
                    let places = self.results.as_mut_ptr();
                    // SAFETY: every array has at least `count` elements.
                    let status = unsafe {
                        match how {
                            How::OneByOne => {
                                let solve = black_box(
                                    $solve
                                        as extern "C" fn(
                                            Option<&$contact>,
                                            Option<&$creepage>,
                                            Option<&kstrip_options>,
                                            Option<&mut std::mem::MaybeUninit<$result>>,
                                        ) -> i32,
                                );
                                let mut worst = 0;
                                for (i, (c, k)) in contacts.iter().zip(creepages).enumerate() {
                                    let place = places.add(i).cast();
                                    let found =
                                        solve(Some(c), Some(k), Some(&options), Some(&mut *place));
                                    worst = found.min(worst);
                                }
                                worst
                            }
                            How::ForcesAlone => {
                                let mut worst = 0;
                                for (i, (c, k)) in contacts.iter().zip(creepages).enumerate() {
                                    let place = places.add(i).cast();
                                    let found = $evaluate(
                                        Some(c),
                                        Some(k),
                                        Some(&options),
                                        KSTRIP_WANT_FORCES,
                                        Some(&mut *place),
                                        null_mut(),
                                        null_mut(),
                                        0,
                                        None,
                                    );
                                    worst = found.min(worst);
                                }
                                worst
                            }
                            How::Structures => $batch(
                                contacts.as_ptr(),
                                creepages.as_ptr(),
                                count as u32,
                                Some(&options),
                                places,
                            ),
                            How::Arrays => {
                                let [a, b, n, g, nu, mu, x, y, spin] =
                                    self.inputs.each_ref().map(|array| array.as_ptr());
                                let [fx, fy, mz, power, adhesion] =
                                    self.outputs.each_mut().map(|array| array.as_mut_ptr());
                                let inputs = $inputs {
                                    a,
                                    b,
                                    normal_force: n,
                                    shear_modulus: g,
                                    poisson_ratio: nu,
                                    friction: mu,
                                    longitudinal: x,
                                    lateral: y,
                                    spin,
                                };
                                let status_detail = self.details.as_mut_ptr();
                                let outputs =
                                    $outputs { fx, fy, mz, power, adhesion, status_detail };
                                $arrays(count as u32, Some(&inputs), Some(&options), Some(&outputs))
                            }
                        }
                    };
                    assert!(status >= 0, "{status}");
                }
            }

            /// The calls of a row of the report.
            pub fn calls(count: usize, model: Model, how: How) -> Box<dyn Fn() -> f64> {
                let contacts = RefCell::new(Contacts::new(count));
                Box::new(move || {
                    contacts.borrow_mut().solve(count, model, how);
                    black_box(&contacts);
                    0.0
                })
            }

            /// Nanoseconds per contact for each of [`CONTACTS`]: one by one, structures, arrays, in turns.
            pub fn by_count(model: Model) -> Vec<[f64; 3]> {
                let mut contacts = Contacts::new(CONTACTS[CONTACTS.len() - 1]);
                CONTACTS
                    .iter()
                    .map(|&count| {
                        let repetitions = (2000 / count).max(1);
                        let rounds = (100_000 / count).clamp(5, 41);
                        let mut times: [Vec<f64>; 3] = Default::default();
                        for _ in 0..rounds {
                            let hows = [How::OneByOne, How::Structures, How::Arrays];
                            for (how, times) in hows.into_iter().zip(&mut times) {
                                let run = || {
                                    (0..repetitions).for_each(|_| contacts.solve(count, model, how))
                                };
                                times.push(clock::took(run) / (repetitions * count) as f64);
                            }
                        }
                        times.map(|times| crate::calls::median(&times))
                    })
                    .collect()
            }
        }
    };
}

contacts!(
    in_double,
    f64,
    kstrip_contact,
    kstrip_creepage,
    kstrip_result,
    kstrip_batch_inputs,
    kstrip_batch_outputs,
    double::kstrip_solve,
    double::kstrip_solve_batch,
    kstrip_solve_batch_arrays,
    kstrip_evaluate
);
contacts!(
    in_single,
    f32,
    kstrip_contact_f32,
    kstrip_creepage_f32,
    kstrip_result_f32,
    kstrip_batch_inputs_f32,
    kstrip_batch_outputs_f32,
    single::kstrip_solve_f32,
    single::kstrip_solve_batch_f32,
    kstrip_solve_batch_arrays_f32,
    kstrip_evaluate_f32
);

/// Nanoseconds that the question for the processor's registers takes.
pub fn question() -> f64 {
    #[cfg(target_arch = "x86_64")]
    {
        let ask = || {
            for _ in 0..1000 {
                // SAFETY: every x86-64 processor has this instruction.
                #[allow(unused_unsafe)]
                black_box(unsafe { std::arch::x86_64::__cpuid(1) });
            }
        };
        let times: Vec<f64> = (0..11).map(|_| clock::took(ask) / 1000.0).collect();
        crate::calls::median(&times)
    }
    #[cfg(not(target_arch = "x86_64"))]
    0.0
}
