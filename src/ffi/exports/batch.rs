//! Many contacts for C: a pointer and a distance in bytes for each quantity.

use super::F;
use crate::batch::{differentiate_batch, solve_batch, solve_under_friction};
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::ffi::support::{for_forces, given, is_aligned, put, read, status_of};
use crate::ffi::types::{BatchInputs, BatchOutputs, kstrip_options};
use crate::forces::Solution;
use crate::status::{Error, kstrip_status};
use core::mem::MaybeUninit;

/// kstrip_evaluate() for many contacts: the same results, bit for bit.
///
/// On processors with AVX several contacts are solved in parallel. All inputs are checked before
/// anything is written: if one is bad its status is returned, no output is touched, and first_bad
/// receives its index. A lost contact is not bad: its results are zero.
///
/// With more than one contact an output's stride is at least the size of the output, forward or
/// backward. Every stride is a multiple of the alignment of its type.
///
/// @param inputs          contacts, creepages, falling friction.
/// @param count           how many; 0 is allowed.
/// @param options         for all contacts; NULL for the defaults.
/// @param outputs         where the outputs go; they must not overlap the inputs or each other.
/// @param[out] first_bad  receives the index of the first bad contact, or count where none is bad;
///                        NULL: not needed.
/// @return as kstrip_evaluate(): the error of the first bad contact, or the most serious warning;
///         KSTRIP_ERROR_STRIDE (a stride is no multiple of the alignment, or that of an output is
///         smaller than the output).
#[unsafe(export_name = symbol!("kstrip_evaluate_batch"))]
pub unsafe extern "C" fn kstrip_evaluate_batch(
    inputs: Option<&BatchInputs<F>>, count: u32, options: Option<&kstrip_options>,
    outputs: Option<&BatchOutputs<F>>, first_bad: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    // SAFETY: every pointer is NULL, or valid for count elements at its distances, says the header.
    status_of(|| unsafe {
        let (inputs, outputs, options) = (given(inputs)?, given(outputs)?, &for_forces(options)?);
        let complete = inputs.required().iter().all(|(first, _)| !first.is_null());
        Error::NullPointer.unless(count == 0 || complete)?;
        Error::Stride.unless(count <= 1 || (inputs.strides_fit() && outputs.strides_fit()))?;
        // Read like the other inputs, without a branch for each contact.
        let none = 0.0;
        let mismatch = match inputs.mismatch.is_null() {
            true => (&raw const none, 0),
            false => (inputs.mismatch, inputs.mismatch_stride),
        };
        let get = |i| inputs.read(i, mismatch);
        let case = |i| {
            let (contact, creepage) = get(i);
            let law = (!inputs.law.is_null()).then(|| read(inputs.law, inputs.law_stride, i));
            (contact, creepage, law)
        };
        let number = count as usize;
        let solved = if !(outputs.derivatives.is_null() && outputs.law_derivatives.is_null()) {
            differentiate_batch(number, options, case, |i, found| {
                outputs.put(i, found.solution, || found.friction);
                write(outputs.derivatives, outputs.derivatives_stride, i, || *found.derivatives);
                write(outputs.law_derivatives, outputs.law_derivatives_stride, i, || found.law());
            })
        } else if !inputs.law.is_null() {
            solve_under_friction(number, options, case, |i, found| {
                outputs.put(i, &found.solution, || found.friction);
            })
        } else {
            let own = |i| read(inputs.friction, inputs.friction_stride, i);
            solve_batch(number, options, get, |i, solution| outputs.put(i, &solution, || own(i)))
        };
        put(first_bad, solved.err().map_or(count, |(i, _)| i as u32));
        solved.map_err(|(_, error)| error)
    })
}

/// # Safety
/// `first` is NULL, or valid for writing at this index.
unsafe fn write<T>(first: *mut T, stride: isize, i: usize, value: impl FnOnce() -> T) {
    if !first.is_null() {
        // SAFETY: the caller's promise.
        unsafe { first.byte_offset(stride.wrapping_mul(i as isize)).write(value()) };
    }
}

/// Whether outputs at this distance do not overlap, if they are requested.
fn lie_apart<T>(first: *mut T, stride: isize) -> bool {
    first.is_null() || (stride.unsigned_abs() >= size_of::<T>() && is_aligned(first, stride))
}

impl BatchInputs<F> {
    /// The numbers that are required, each with its stride.
    fn required(&self) -> [(*const F, isize); 9] {
        [
            (self.a, self.a_stride),
            (self.b, self.b_stride),
            (self.normal_force, self.normal_force_stride),
            (self.shear_modulus, self.shear_modulus_stride),
            (self.poisson_ratio, self.poisson_ratio_stride),
            (self.friction, self.friction_stride),
            (self.longitudinal, self.longitudinal_stride),
            (self.lateral, self.lateral_stride),
            (self.spin, self.spin_stride),
        ]
    }

    /// # Safety
    /// All required inputs and the mismatch, a place and its stride, are valid at this index.
    unsafe fn read(&self, i: usize, mismatch: (*const F, isize)) -> (Contact<F>, Creepage<F>) {
        // SAFETY: the caller's promise.
        let of = |(first, stride): (*const F, isize)| unsafe { read(first, stride, i) };
        let [a, b, normal_force, shear_modulus, poisson_ratio, friction, others @ ..] =
            self.required().map(of);
        let ([longitudinal, lateral, spin], mismatch) = (others, of(mismatch));
        (
            Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch },
            Creepage { longitudinal, lateral, spin },
        )
    }

    fn strides_fit(&self) -> bool {
        self.required().into_iter().all(|(first, stride)| is_aligned(first, stride))
            && (self.mismatch.is_null() || is_aligned(self.mismatch, self.mismatch_stride))
            && (self.law.is_null() || is_aligned(self.law, self.law_stride))
    }
}

impl BatchOutputs<F> {
    fn strides_fit(&self) -> bool {
        lie_apart(self.fx, self.fx_stride)
            && lie_apart(self.fy, self.fy_stride)
            && lie_apart(self.mz, self.mz_stride)
            && lie_apart(self.power, self.power_stride)
            && lie_apart(self.adhesion, self.adhesion_stride)
            && lie_apart(self.status_detail, self.status_detail_stride)
            && lie_apart(self.friction, self.friction_stride)
            && lie_apart(self.derivatives, self.derivatives_stride)
            && lie_apart(self.law_derivatives, self.law_derivatives_stride)
    }

    /// # Safety
    /// All outputs are NULL or valid at this index.
    unsafe fn put(&self, i: usize, solution: &Solution<F>, friction: impl FnOnce() -> F) {
        let Solution { fx, fy, mz, power, adhesion, warning, .. } = *solution;
        // SAFETY: the caller's promise.
        unsafe {
            write(self.fx, self.fx_stride, i, || fx);
            write(self.fy, self.fy_stride, i, || fy);
            write(self.mz, self.mz_stride, i, || mz);
            write(self.power, self.power_stride, i, || power);
            write(self.adhesion, self.adhesion_stride, i, || adhesion);
            write(self.status_detail, self.status_detail_stride, i, || warning.code());
            write(self.friction, self.friction_stride, i, friction);
        }
    }
}
