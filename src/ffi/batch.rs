//! Many contacts for C, one array for each quantity.

use super::calls::OutArray;
use super::{answer, arrays, checked_options, kstrip_status, types::kstrip_options};
use crate::batch::{Problems, Solutions, evaluate_batch};
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::number::Float;
use crate::solve::evaluate::Wanted;
use crate::solve::model::{Precision, Solution};
use crate::status::{Error, Notice};
use core::mem::MaybeUninit;

/// Contacts and creepages as one array for each quantity.
///
/// Arrays of as many elements as there are contacts; none may be NULL unless there are no contacts.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_batch_inputs {
    /// Semi-axes along the rolling direction x [m], > 0.
    pub a: *const f64,
    /// Semi-axes along y [m], > 0.
    pub b: *const f64,
    /// Normal forces N [N], >= 0.
    pub normal_force: *const f64,
    /// Combined shear moduli G [Pa], > 0.
    pub shear_modulus: *const f64,
    /// Combined Poisson's ratios [-], 0 to 0.5.
    pub poisson_ratio: *const f64,
    /// Coefficients of friction mu [-], >= 0.
    pub friction: *const f64,
    /// Longitudinal creepages [-].
    pub longitudinal: *const f64,
    /// Lateral creepages [-].
    pub lateral: *const f64,
    /// Spins [1/m].
    pub spin: *const f64,
}

/// Where the results of many contacts go, one array for each quantity.
///
/// Arrays of as many elements as there are contacts; NULL for what is not wanted.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_batch_outputs {
    /// Longitudinal forces on the lower bodies [N].
    pub fx: *mut f64,
    /// Lateral forces [N].
    pub fy: *mut f64,
    /// Moments about z at the centres of the contacts [N m].
    pub mz: *mut f64,
    /// Frictional powers over rolling speed [N].
    pub power: *mut f64,
    /// Shares of the contact areas in adhesion [-], 0 to 1, or -1 for unknown.
    pub adhesion: *mut f64,
    /// The status of each result: 0 or one of the KSTRIP_WARNING constants.
    pub status_detail: *mut i32,
}

/// Contacts and creepages as one array for each quantity, single precision.
///
/// Arrays of as many elements as there are contacts; none may be NULL unless there are no contacts.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_batch_inputs_f32 {
    /// Semi-axes along the rolling direction x [m], > 0.
    pub a: *const f32,
    /// Semi-axes along y [m], > 0.
    pub b: *const f32,
    /// Normal forces N [N], >= 0.
    pub normal_force: *const f32,
    /// Combined shear moduli G [Pa], > 0.
    pub shear_modulus: *const f32,
    /// Combined Poisson's ratios [-], 0 to 0.5.
    pub poisson_ratio: *const f32,
    /// Coefficients of friction mu [-], >= 0.
    pub friction: *const f32,
    /// Longitudinal creepages [-].
    pub longitudinal: *const f32,
    /// Lateral creepages [-].
    pub lateral: *const f32,
    /// Spins [1/m].
    pub spin: *const f32,
}

/// Where the results of many contacts go, one array for each quantity, single precision.
///
/// Arrays of as many elements as there are contacts; NULL for what is not wanted.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_batch_outputs_f32 {
    /// Longitudinal forces on the lower bodies [N].
    pub fx: *mut f32,
    /// Lateral forces [N].
    pub fy: *mut f32,
    /// Moments about z at the centres of the contacts [N m].
    pub mz: *mut f32,
    /// Frictional powers over rolling speed [N].
    pub power: *mut f32,
    /// Shares of the contact areas in adhesion [-], 0 to 1, or -1 for unknown.
    pub adhesion: *mut f32,
    /// The status of each result: 0 or one of the KSTRIP_WARNING constants.
    pub status_detail: *mut i32,
}

macro_rules! arrays {
    ($inputs:ident, $outputs:ident, $float:ident) => {
        impl $inputs {
            /// # Safety
            /// As [`Self::slices`], and the outputs likewise.
            unsafe fn solve(
                &self,
                count: u32,
                options: Option<&kstrip_options>,
                to: &$outputs,
            ) -> kstrip_status {
                let quantities = [to.fx, to.fy, to.mz, to.power, to.adhesion];
                // SAFETY: the caller's promise.
                let (inputs, quantities, details) = unsafe {
                    (
                        self.slices(count),
                        quantities.map(|array| arrays::output(array, count)),
                        arrays::output(to.status_detail, count),
                    )
                };
                solve_batch_arrays(inputs, options, quantities, details)
            }

            /// # Safety
            /// The pointers are NULL or valid for `count` elements.
            unsafe fn slices<'a>(&self, count: u32) -> Result<[&'a [$float]; 9], Error> {
                let Self { a, b, normal_force, shear_modulus, poisson_ratio, .. } = *self;
                let Self { friction, longitudinal, lateral, spin, .. } = *self;
                let contact = [a, b, normal_force, shear_modulus, poisson_ratio, friction];
                let creepage = [longitudinal, lateral, spin];
                let mut slices: [&[$float]; 9] = [&[]; 9];
                for (slice, pointer) in slices.iter_mut().zip(contact.into_iter().chain(creepage)) {
                    // SAFETY: the caller's promise.
                    *slice = unsafe { arrays::input(pointer, count) }?;
                }
                Ok(slices)
            }
        }
    };
}

arrays!(kstrip_batch_inputs, kstrip_batch_outputs, f64);
arrays!(kstrip_batch_inputs_f32, kstrip_batch_outputs_f32, f32);

/// Problems as one array for each quantity.
struct Inputs<'a, F>([&'a [F]; 9]);

impl<F: Float> Problems<F> for Inputs<'_, F> {
    #[inline(always)]
    fn count(&self) -> usize {
        self.0[0].len()
    }
    #[inline(always)]
    fn get(&self, i: usize) -> Option<(Contact<F>, Creepage<F>)> {
        let [
            a,
            b,
            normal_force,
            shear_modulus,
            poisson_ratio,
            friction,
            longitudinal,
            lateral,
            spin,
        ] = self.0.map(|array| array.get(i).copied().unwrap_or(F::zero()));
        Some((
            Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction },
            Creepage { longitudinal, lateral, spin },
        ))
    }
    #[inline(always)]
    fn side_by_side<const N: usize>(&self, first: usize) -> Option<[[F; N]; 9]> {
        let mut quantities = [[F::zero(); N]; 9];
        for (quantity, array) in quantities.iter_mut().zip(self.0) {
            *quantity = *array.get(first..)?.first_chunk()?;
        }
        Some(quantities)
    }
}

/// Solutions as one array for each quantity: `fx, fy, mz, power, adhesion` and the status; empty ones are not wanted.
struct Outputs<'a, F> {
    quantities: [&'a mut [MaybeUninit<F>]; 5],
    details: &'a mut [MaybeUninit<i32>],
}

impl<F: Float> Solutions<F> for Outputs<'_, F> {
    #[inline(always)]
    fn put(&mut self, i: usize, solution: Solution<F>) {
        let Solution { fx, fy, mz, power, adhesion, notice } = solution;
        for (array, value) in self.quantities.iter_mut().zip([fx, fy, mz, power, adhesion]) {
            if let Some(place) = array.get_mut(i) {
                place.write(value);
            }
        }
        if let Some(place) = self.details.get_mut(i) {
            place.write(notice.code());
        }
    }
    #[inline(always)]
    fn put_side_by_side<const N: usize>(
        &mut self,
        first: usize,
        quantities: &[[F; N]; 5],
        notices: &[Notice; N],
    ) {
        for (array, values) in self.quantities.iter_mut().zip(quantities) {
            write(array, first, values);
        }
        write(self.details, first, &notices.map(|notice| notice.code()));
    }
}

#[inline(always)]
fn write<T: Copy, const N: usize>(array: &mut [MaybeUninit<T>], first: usize, values: &[T; N]) {
    let places = array.get_mut(first..).and_then(|rest| rest.first_chunk_mut::<N>());
    if let Some(places) = places {
        *places = values.map(MaybeUninit::new);
    }
}

fn solve_batch_arrays<F: Precision>(
    inputs: Result<[&[F]; 9], Error>,
    options: Option<&kstrip_options>,
    quantities: [OutArray<F>; 5],
    details: OutArray<i32>,
) -> kstrip_status {
    answer(|| {
        let inputs = Inputs(inputs?);
        let options = checked_options(options)?;
        // NULL is an empty array here.
        let quantities = quantities.map(|array| array.unwrap_or(&mut []));
        let details = details.unwrap_or(&mut []);
        let [_, _, mz, power, adhesion] = &quantities;
        let wanted =
            Wanted { moment: !mz.is_empty() || !power.is_empty(), adhesion: !adhesion.is_empty() };
        evaluate_batch(&inputs, &options, wanted, &mut Outputs { quantities, details })
    })
}

/// kstrip_solve_batch() for one array for each quantity, as vector codes and data frames have them.
///
/// The same results as kstrip_solve() for each contact, bit for bit. All inputs are checked before
/// anything is written: if one is bad its status is returned and no output is touched.
///
/// @param count           number of contacts; 0 is allowed.
/// @param inputs          arrays of count elements.
/// @param options         for all contacts; NULL for the defaults.
/// @param outputs         arrays of count elements; NULL where a quantity is not wanted: moment (with the power) and
///                        adhesion are then left out where that saves time. They must not
///                        overlap the inputs or each other.
/// @return KSTRIP_OK, the largest warning, or the first error, as kstrip_solve().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_solve_batch_arrays(
    count: u32,
    inputs: Option<&kstrip_batch_inputs>,
    options: Option<&kstrip_options>,
    outputs: Option<&kstrip_batch_outputs>,
) -> kstrip_status {
    match (inputs, outputs) {
        // SAFETY: NULL or count elements each, says the header.
        (Some(from), Some(to)) => unsafe { from.solve(count, options, to) },
        _ => Error::NullPointer.code(),
    }
}

/// kstrip_solve_batch_arrays() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_solve_batch_arrays_f32(
    count: u32,
    inputs: Option<&kstrip_batch_inputs_f32>,
    options: Option<&kstrip_options>,
    outputs: Option<&kstrip_batch_outputs_f32>,
) -> kstrip_status {
    match (inputs, outputs) {
        // SAFETY: NULL or count elements each, says the header.
        (Some(from), Some(to)) => unsafe { from.solve(count, options, to) },
        _ => Error::NullPointer.code(),
    }
}
