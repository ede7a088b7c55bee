//! Many contacts for C: a pointer and a distance in bytes for each quantity.

use super::support::*;
use crate::batch::{Problems, Solutions, evaluate_batch};
use crate::solve::evaluate::Wanted;

/// kstrip_evaluate() for many contacts: the same results, bit for bit.
///
/// Where the processor has AVX several contacts are solved side by side. All inputs are checked before anything is
/// written: if one is bad its status is returned, no output is touched, and first_bad receives its index. A lost contact
/// is not bad: its results are zero.
///
/// @param inputs          contacts, creepages, falling friction.
/// @param count           how many; 0 is allowed.
/// @param options         for all contacts; NULL for the defaults.
/// @param outputs         where the outputs go; they must not overlap the inputs or each other.
/// @param[out] first_bad  receives the index of the first bad input, count without one; NULL: not wanted.
/// @return KSTRIP_OK, the largest warning, or the first error, as kstrip_evaluate().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_evaluate_batch(
    inputs: Option<&BatchInputs<f64>>,
    count: u32,
    options: Option<&kstrip_options>,
    outputs: Option<&BatchOutputs<f64>>,
    first_bad: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    // SAFETY: every pointer is NULL, or valid for count elements at its distances, says the header.
    answer(|| unsafe {
        Batch {
            inputs: given(inputs)?,
            count,
            outputs: given(outputs)?,
            options: for_forces(options)?,
        }
        .solve(first_bad)
    })
}

/// Contacts and the places of their results.
pub(super) struct Batch<'a, F: Precision> {
    pub(super) inputs: &'a BatchInputs<F>,
    pub(super) count: u32,
    pub(super) outputs: &'a BatchOutputs<F>,
    pub(super) options: Options,
}

/// # Safety
/// `first` is valid for reading at this index.
#[inline(always)]
unsafe fn read<T: Copy>(first: *const T, stride: isize, i: usize) -> T {
    // SAFETY: the caller's promise.
    unsafe { first.byte_offset(stride.wrapping_mul(i as isize)).read() }
}

/// # Safety
/// `first` is NULL, or valid for writing at this index.
#[inline(always)]
unsafe fn write<T>(first: *mut T, stride: isize, i: usize, value: T) {
    if !first.is_null() {
        // SAFETY: the caller's promise.
        unsafe { first.byte_offset(stride.wrapping_mul(i as isize)).write(value) };
    }
}

impl<F: Precision> Batch<'_, F> {
    /// # Safety
    /// Every pointer is NULL, or valid for `count` elements at its distances.
    pub(super) unsafe fn solve(&self, first_bad: Place<u32>) -> Result<Notice, Error> {
        let Self { inputs, outputs, .. } = self;
        let required = [
            inputs.a,
            inputs.b,
            inputs.normal_force,
            inputs.shear_modulus,
            inputs.poisson_ratio,
            inputs.friction,
            inputs.longitudinal,
            inputs.lateral,
            inputs.spin,
        ];
        if self.count > 0 && required.iter().any(|pointer| pointer.is_null()) {
            return Err(Error::NullPointer);
        }
        let solved = if inputs.law.is_null()
            && outputs.derivatives.is_null()
            && outputs.law_derivatives.is_null()
        {
            let wanted = Wanted {
                moment: !outputs.mz.is_null() || !outputs.power.is_null(),
                adhesion: !outputs.adhesion.is_null(),
            };
            evaluate_batch(self, &self.options, wanted, &mut Outputs(self))
        } else {
            self.one_by_one()
        };
        let bad = match solved {
            Ok(_) => self.count,
            Err(_) => (0..self.count).find(|i| self.check(*i).is_err()).unwrap_or(self.count),
        };
        put(first_bad, bad);
        solved
    }

    fn law(&self, i: usize) -> Option<SlipFriction<F>> {
        let BatchInputs { law, law_stride, .. } = *self.inputs;
        // SAFETY: the promise of `solve`.
        (!law.is_null()).then(|| unsafe { read(law, law_stride, i) })
    }

    fn check(&self, i: u32) -> Result<(), Error> {
        let i = i as usize;
        let Some((contact, creepage)) = self.get(i) else {
            return Ok(());
        };
        let law = self.law(i);
        let BatchOutputs { derivatives, law_derivatives, .. } = self.outputs;
        if !derivatives.is_null() || !law_derivatives.is_null() {
            differentiate(&contact, &creepage, law.as_ref(), &self.options).map(|_| ())
        } else if let Some(law) = law {
            friction::solve(&contact, &creepage, &law, &self.options).map(|_| ())
        } else {
            model::check(&contact, &creepage, &self.options)
        }
    }

    /// Under falling friction, and with derivatives.
    fn one_by_one(&self) -> Result<Notice, Error> {
        for i in 0..self.count {
            self.check(i)?;
        }
        let mut worst = Notice::None;
        let Self { outputs, .. } = self;
        for i in 0..self.count as usize {
            let Some((contact, creepage)) = self.get(i) else {
                continue;
            };
            let law = self.law(i);
            let found = differentiate(&contact, &creepage, law.as_ref(), &self.options)?;
            worst = worst.worse(found.solution.notice);
            Outputs(self).put(i, found.solution);
            // SAFETY: the promise of `solve`.
            unsafe {
                write(outputs.friction, outputs.friction_stride, i, found.friction);
                write(outputs.derivatives, outputs.derivatives_stride, i, found.derivatives);
                write(outputs.law_derivatives, outputs.law_derivatives_stride, i, found.law);
            }
        }
        Ok(worst)
    }
}

impl<F: Precision> Problems<F> for Batch<'_, F> {
    #[inline(always)]
    fn count(&self) -> usize {
        self.count as usize
    }
    #[inline(always)]
    fn get(&self, i: usize) -> Option<(Contact<F>, Creepage<F>)> {
        if i >= self.count as usize {
            return None;
        }
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
            };
            let creepage = Creepage {
                longitudinal: read(from.longitudinal, from.longitudinal_stride, i),
                lateral: read(from.lateral, from.lateral_stride, i),
                spin: read(from.spin, from.spin_stride, i),
            };
            Some((contact, creepage))
        }
    }
}

/// The places of the results.
struct Outputs<'a, F: Precision>(&'a Batch<'a, F>);

impl<F: Precision> Solutions<F> for Outputs<'_, F> {
    #[inline(always)]
    fn put(&mut self, i: usize, solution: Solution<F>) {
        let Solution { fx, fy, mz, power, adhesion, notice, .. } = solution;
        let Batch { inputs, outputs: to, .. } = *self.0;
        // SAFETY: the promise of `solve`.
        unsafe {
            write(to.fx, to.fx_stride, i, fx);
            write(to.fy, to.fy_stride, i, fy);
            write(to.mz, to.mz_stride, i, mz);
            write(to.power, to.power_stride, i, power);
            write(to.adhesion, to.adhesion_stride, i, adhesion);
            write(to.status_detail, to.status_detail_stride, i, notice.code());
            if !to.friction.is_null() {
                let own = read(inputs.friction, inputs.friction_stride, i);
                write(to.friction, to.friction_stride, i, own);
            }
        }
    }
}
