//! Inputs and outputs of calls in C: where numbers lie.

use kstrip::contact::Contact;
use kstrip::contact::creepage::Creepage;
use kstrip::ffi::types::{BatchInputs, BatchOutputs, Outputs};
use kstrip::forces::Solution;

/// No output.
pub const fn nowhere<F>() -> Outputs<F> {
    // SAFETY: pointers that are NULL, and a capacity of zero.
    unsafe { std::mem::zeroed() }
}

pub const fn no_batch<F>() -> BatchOutputs<F> {
    // SAFETY: pointers that are NULL, and strides of zero.
    unsafe { std::mem::zeroed() }
}

/// A contact and its creepage from their numbers, the mismatch last.
pub fn problem<F>(numbers: [F; 10]) -> (Contact<F>, Creepage<F>) {
    let [a, b, normal_force, shear_modulus, poisson_ratio, friction, rest @ ..] = numbers;
    let [longitudinal, lateral, spin, mismatch] = rest;
    let contact = Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch };
    (contact, Creepage { longitudinal, lateral, spin })
}

/// Inputs of a batch by the first number of each quantity and its stride, the mismatch last.
pub fn batch_from<F>(mut quantity: impl FnMut(usize) -> (*const F, isize)) -> BatchInputs<F> {
    // SAFETY: pointers that are NULL, and strides of zero.
    let mut from: BatchInputs<F> = unsafe { std::mem::zeroed() };
    (from.a, from.a_stride) = quantity(0);
    (from.b, from.b_stride) = quantity(1);
    (from.normal_force, from.normal_force_stride) = quantity(2);
    (from.shear_modulus, from.shear_modulus_stride) = quantity(3);
    (from.poisson_ratio, from.poisson_ratio_stride) = quantity(4);
    (from.friction, from.friction_stride) = quantity(5);
    (from.longitudinal, from.longitudinal_stride) = quantity(6);
    (from.lateral, from.lateral_stride) = quantity(7);
    (from.spin, from.spin_stride) = quantity(8);
    (from.mismatch, from.mismatch_stride) = quantity(9);
    from
}

/// Inputs of a batch that lie in arrays of structures.
pub fn batch_inputs<F>(
    contacts: *const Contact<F>, creepages: *const Creepage<F>,
) -> BatchInputs<F> {
    let contact = size_of::<Contact<F>>() as isize;
    let creepage = size_of::<Creepage<F>>() as isize;
    batch_from(|i| match i {
        ..6 => (contacts.cast::<F>().wrapping_add(i), contact),
        6..9 => (creepages.cast::<F>().wrapping_add(i - 6), creepage),
        _ => (contacts.cast::<F>().wrapping_add(6), contact),
    })
}

/// Inputs of a batch that lie in one array for each quantity, the mismatch last.
pub fn batch_arrays<F>(arrays: [*const F; 10]) -> BatchInputs<F> {
    batch_from(|i| (arrays[i], size_of::<F>() as isize))
}

/// Results of a batch: fx, fy, mz, power, adhesion, by their first number; the statuses; strides.
fn results_at<F>(
    [fx, fy, mz, power, adhesion]: [*mut F; 5], stride: isize, status_detail: *mut i32,
    status_detail_stride: isize,
) -> BatchOutputs<F> {
    let mut to = no_batch();
    (to.fx, to.fx_stride) = (fx, stride);
    (to.fy, to.fy_stride) = (fy, stride);
    (to.mz, to.mz_stride) = (mz, stride);
    (to.power, to.power_stride) = (power, stride);
    (to.adhesion, to.adhesion_stride) = (adhesion, stride);
    BatchOutputs { status_detail, status_detail_stride, ..to }
}

pub fn batch_results<F>(results: *mut Solution<F>) -> BatchOutputs<F> {
    let stride = size_of::<Solution<F>>() as isize;
    let member = |i: usize| results.cast::<F>().wrapping_add(i);
    results_at(std::array::from_fn(member), stride, member(5).cast(), stride)
}

/// Results of a batch as one array for each quantity: fx, fy, mz, power, adhesion, status.
pub fn batch_results_arrays<F>(arrays: [*mut F; 5], details: *mut i32) -> BatchOutputs<F> {
    results_at(arrays, size_of::<F>() as isize, details, size_of::<i32>() as isize)
}
