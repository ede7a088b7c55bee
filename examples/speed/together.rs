//! Calls for many contacts at once, and calls that want the forces alone.

use crate::calls::{CONTACT, creepages};
use crate::clock;
use crate::names::*;
use kstrip::solve::model::Model;
use kstrip::status::Notice;
use std::cell::RefCell;
use std::hint::black_box;
use std::ptr::null;

/// How many contacts a batch is measured with.
pub const CONTACTS: [usize; 5] = [100, 1000, 10_000, 100_000, 1_000_000];

/// How many contacts are solved.
#[derive(Clone, Copy)]
pub enum How {
    /// A loop over `kstrip_solve`.
    OneByOne,
    /// `kstrip_evaluate_batch` with arrays of structures.
    Structures,
    /// `kstrip_evaluate_batch` with one array for each quantity.
    Arrays,
    /// A loop over `kstrip_evaluate` that wants the result alone.
    ForcesAlone,
}

macro_rules! contacts {
    (
        $module:ident, $float:ty, $contact:ident, $creepage:ident, $result:ident, $inputs:ident, $outputs:ident,
        $all:ident, $solve:path, $batch:path, $evaluate:ident
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
                        notice: Notice::None,
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
                                    let outputs = $all { result: places.add(i), ..nowhere() };
                                    let found = $evaluate(
                                        Some(c),
                                        Some(k),
                                        None,
                                        Some(&options),
                                        Some(&outputs),
                                    );
                                    worst = found.min(worst);
                                }
                                worst
                            }
                            How::Structures => {
                                let (c, k) = (contacts.as_ptr(), creepages.as_ptr());
                                let (contact, creepage) = (
                                    size_of::<$contact>() as isize,
                                    size_of::<$creepage>() as isize,
                                );
                                let result = size_of::<$result>() as isize;
                                let inputs = $inputs {
                                    a: &raw const (*c).a,
                                    a_stride: contact,
                                    b: &raw const (*c).b,
                                    b_stride: contact,
                                    normal_force: &raw const (*c).normal_force,
                                    normal_force_stride: contact,
                                    shear_modulus: &raw const (*c).shear_modulus,
                                    shear_modulus_stride: contact,
                                    poisson_ratio: &raw const (*c).poisson_ratio,
                                    poisson_ratio_stride: contact,
                                    friction: &raw const (*c).friction,
                                    friction_stride: contact,
                                    longitudinal: &raw const (*k).longitudinal,
                                    longitudinal_stride: creepage,
                                    lateral: &raw const (*k).lateral,
                                    lateral_stride: creepage,
                                    spin: &raw const (*k).spin,
                                    spin_stride: creepage,
                                    law: null(),
                                    law_stride: 0,
                                };
                                let outputs = $outputs {
                                    fx: &raw mut (*places).fx,
                                    fx_stride: result,
                                    fy: &raw mut (*places).fy,
                                    fy_stride: result,
                                    mz: &raw mut (*places).mz,
                                    mz_stride: result,
                                    power: &raw mut (*places).power,
                                    power_stride: result,
                                    adhesion: &raw mut (*places).adhesion,
                                    adhesion_stride: result,
                                    status_detail: (&raw mut (*places).notice).cast(),
                                    status_detail_stride: result,
                                    ..no_batch()
                                };
                                let count = count as u32;
                                $batch(Some(&inputs), count, Some(&options), Some(&outputs), None)
                            }
                            How::Arrays => {
                                let [a, b, n, g, nu, mu, x, y, spin] =
                                    self.inputs.each_ref().map(|array| array.as_ptr());
                                let [fx, fy, mz, power, adhesion] =
                                    self.outputs.each_mut().map(|array| array.as_mut_ptr());
                                let each = size_of::<$float>() as isize;
                                let inputs = $inputs {
                                    a,
                                    a_stride: each,
                                    b,
                                    b_stride: each,
                                    normal_force: n,
                                    normal_force_stride: each,
                                    shear_modulus: g,
                                    shear_modulus_stride: each,
                                    poisson_ratio: nu,
                                    poisson_ratio_stride: each,
                                    friction: mu,
                                    friction_stride: each,
                                    longitudinal: x,
                                    longitudinal_stride: each,
                                    lateral: y,
                                    lateral_stride: each,
                                    spin,
                                    spin_stride: each,
                                    law: null(),
                                    law_stride: 0,
                                };
                                let outputs = $outputs {
                                    fx,
                                    fx_stride: each,
                                    fy,
                                    fy_stride: each,
                                    mz,
                                    mz_stride: each,
                                    power,
                                    power_stride: each,
                                    adhesion,
                                    adhesion_stride: each,
                                    status_detail: self.details.as_mut_ptr(),
                                    status_detail_stride: size_of::<i32>() as isize,
                                    ..no_batch()
                                };
                                let count = count as u32;
                                $batch(Some(&inputs), count, Some(&options), Some(&outputs), None)
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
    kstrip_outputs,
    kstrip_solve,
    kstrip_evaluate_batch,
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
    kstrip_outputs_f32,
    kstrip_solve_f32,
    kstrip_evaluate_batch_f32,
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
