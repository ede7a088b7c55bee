//! Batches for C: a pointer and a distance in bytes for each quantity.

use super::support::*;
use crate::batch::{differentiate_batch, solve_batch, solve_under_friction};

/// Contacts and the places of their results.
pub(super) struct Batch<'a, F: Float> {
    pub(super) inputs: &'a BatchInputs<F>,
    pub(super) count: u32,
    pub(super) outputs: &'a BatchOutputs<F>,
    pub(super) options: Options,
}

/// # Safety
/// `first` is NULL, or valid for writing at this index.
unsafe fn write<T>(first: *mut T, stride: isize, i: usize, value: T) {
    if !first.is_null() {
        // SAFETY: the caller's promise.
        unsafe { first.byte_offset(stride.wrapping_mul(i as isize)).write(value) };
    }
}

/// Whether outputs at this distance do not overlap, if they are requested.
fn lie_apart<T>(first: *mut T, stride: isize) -> bool {
    first.is_null() || (stride.unsigned_abs() >= size_of::<T>() && is_aligned(first, stride))
}

impl<F: Float> BatchInputs<F> {
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

    fn strides_fit(&self) -> bool {
        self.required().into_iter().all(|(first, stride)| is_aligned(first, stride))
            && (self.mismatch.is_null() || is_aligned(self.mismatch, self.mismatch_stride))
            && (self.law.is_null() || is_aligned(self.law, self.law_stride))
    }
}

impl<F: Float> BatchOutputs<F> {
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
}

impl<F: Float> Batch<'_, F> {
    /// # Safety
    /// Every pointer is NULL, or valid for `count` elements at its distances.
    pub(super) unsafe fn solve(&self, first_bad: Output<u32>) -> Result<Warning, Error> {
        let Self { inputs, outputs, .. } = self;
        let complete = !inputs.required().iter().any(|(first, _)| first.is_null());
        Error::NullPointer.unless(self.count == 0 || complete)?;
        let fit = self.count <= 1 || (inputs.strides_fit() && outputs.strides_fit());
        Error::Stride.unless(fit)?;
        let alone = inputs.law.is_null()
            && outputs.derivatives.is_null()
            && outputs.law_derivatives.is_null();
        let count = self.count as usize;
        // Read like the other inputs, without a branch for each contact.
        let none = F::zero();
        let mismatch = match inputs.mismatch.is_null() {
            true => (&raw const none, 0),
            false => (inputs.mismatch, inputs.mismatch_stride),
        };
        let get = |i| self.read(i, mismatch);
        let solved = if alone {
            // SAFETY: the promise of this function.
            let own = |i| unsafe { read(inputs.friction, inputs.friction_stride, i) };
            let put = |i, solution| self.put(i, &solution, || own(i));
            solve_batch(count, &self.options, get, put)
        } else {
            self.with_more(count, get)
        };
        put(first_bad, solved.err().map_or(self.count, |(i, _)| i as u32));
        solved.map_err(|(_, error)| error)
    }

    fn law(&self, i: usize) -> Option<SlipFriction<F>> {
        let BatchInputs { law, law_stride, .. } = *self.inputs;
        // SAFETY: the promise of `solve`.
        (!law.is_null()).then(|| unsafe { read(law, law_stride, i) })
    }

    /// Solves under falling friction, and with derivatives.
    fn with_more(
        &self,
        count: usize,
        get: impl Fn(usize) -> (Contact<F>, Creepage<F>),
    ) -> Result<Warning, (usize, Error)> {
        let to = self.outputs;
        let get = |i| {
            let (contact, creepage) = get(i);
            (contact, creepage, self.law(i))
        };
        if to.derivatives.is_null() && to.law_derivatives.is_null() {
            return solve_under_friction(count, &self.options, get, |i, found| {
                self.put(i, &found.solution, || found.friction);
            });
        }
        differentiate_batch(count, &self.options, get, |i, found| {
            self.put(i, found.solution, || found.friction);
            // SAFETY: the promise of `solve`.
            unsafe {
                write(to.derivatives, to.derivatives_stride, i, *found.derivatives);
                if !to.law_derivatives.is_null() {
                    write(to.law_derivatives, to.law_derivatives_stride, i, found.law());
                }
            }
        })
    }

    /// Contact and creepage of an index below the count, with the place and the stride of the
    /// mismatch.
    fn read(&self, i: usize, mismatch: (*const F, isize)) -> (Contact<F>, Creepage<F>) {
        let from = self.inputs;
        // SAFETY: the promise of `solve`.
        unsafe {
            let contact = Contact {
                a: read(from.a, from.a_stride, i),
                b: read(from.b, from.b_stride, i),
                normal_force: read(from.normal_force, from.normal_force_stride, i),
                shear_modulus: read(from.shear_modulus, from.shear_modulus_stride, i),
                poisson_ratio: read(from.poisson_ratio, from.poisson_ratio_stride, i),
                friction: read(from.friction, from.friction_stride, i),
                mismatch: read(mismatch.0, mismatch.1, i),
            };
            let creepage = Creepage {
                longitudinal: read(from.longitudinal, from.longitudinal_stride, i),
                lateral: read(from.lateral, from.lateral_stride, i),
                spin: read(from.spin, from.spin_stride, i),
            };
            (contact, creepage)
        }
    }

    fn put(&self, i: usize, solution: &Solution<F>, friction: impl FnOnce() -> F) {
        let Solution { fx, fy, mz, power, adhesion, warning, .. } = *solution;
        let to = self.outputs;
        // SAFETY: the promise of `solve`.
        unsafe {
            write(to.fx, to.fx_stride, i, fx);
            write(to.fy, to.fy_stride, i, fy);
            write(to.mz, to.mz_stride, i, mz);
            write(to.power, to.power_stride, i, power);
            write(to.adhesion, to.adhesion_stride, i, adhesion);
            write(to.status_detail, to.status_detail_stride, i, warning.code());
            if !to.friction.is_null() {
                write(to.friction, to.friction_stride, i, friction());
            }
        }
    }
}
