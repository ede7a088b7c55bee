//! A prepared contact as plain numbers that C stores.

use super::support::*;
use crate::solve::prepared::{Frame, Kernel};
use crate::strip::{self, PreparedStrips};
use crate::strip_1967::strip::SlidingRule;
use crate::total;
use core::ptr::{read_unaligned, write_unaligned};

/// How many numbers there is room for.
pub(super) const ROOM: usize = 96;

/// Where the numbers of the model begin: after those of the contact.
const fn kernel_at<F: Precision>() -> usize {
    size_of::<Frame<F>>() / size_of::<F>()
}

/// Structures that consist of numbers of one kind, so that any numbers are a value of them.
///
/// # Safety
/// True of the implementor.
unsafe trait Numbers<F> {}
// SAFETY: so they are declared.
unsafe impl<F: Precision> Numbers<F> for Frame<F> {}
unsafe impl<F: Precision> Numbers<F> for total::Prepared<F> {}
unsafe impl<F: Precision> Numbers<F> for strip::Prepared<F> {}
unsafe impl<F: Precision> Numbers<F> for [F; 4] {}

impl<F: Precision> PreparedNumbers<F> {
    pub(super) fn of(prepared: &Prepared<F>) -> Self {
        let Options { model, strips } = prepared.options;
        let numbers = MaybeUninit::new([F::zero(); ROOM]);
        let mut stored = Self { numbers, model: model as i32, strips: strips as i32 };
        stored.put(0, prepared.frame);
        let at = kernel_at::<F>();
        match &prepared.kernel {
            Kernel::Strip1967(_) => {}
            Kernel::Strip(strips) => stored.put(at, strips.contact),
            Kernel::Total(total) => stored.put(at, *total),
            Kernel::Linear(stiffness) => stored.put(at, *stiffness),
        }
        stored
    }

    #[inline(always)]
    pub(super) fn solve(&self, creepage: &Creepage<F>) -> Result<Solution<F>, Error> {
        let model = Model::from_number(self.model).ok_or(Error::NotPrepared)?;
        let strips = StripCount::from_number(self.strips).ok_or(Error::NotPrepared)?;
        let (at, options) = (kernel_at::<F>(), Options { model, strips });
        // Each model on its own: no kernel of another one is moved.
        match model {
            Model::Strip1967 => {
                self.by(Kernel::Strip1967(SlidingRule::RigidSlip), options, creepage)
            }
            Model::Strip1967Continuous => {
                self.by(Kernel::Strip1967(SlidingRule::Continuous), options, creepage)
            }
            Model::Strip => {
                let prepared = PreparedStrips::from_prepared(self.get(at), strips);
                self.by(Kernel::Strip(prepared), options, creepage)
            }
            Model::Total => self.by(Kernel::Total(self.get(at)), options, creepage),
            Model::Linear => self.by(Kernel::Linear(self.get(at)), options, creepage),
        }
    }

    #[inline(always)]
    fn by(
        &self,
        kernel: Kernel<F>,
        options: Options,
        creepage: &Creepage<F>,
    ) -> Result<Solution<F>, Error> {
        Prepared { frame: self.get(0), options, kernel }.solve(creepage)
    }

    fn put<T: Numbers<F>>(&mut self, at: usize, value: T) {
        const { assert!(size_of::<T>() <= (ROOM - 16) * size_of::<F>()) };
        // SAFETY: there is room, as asserted: no structure begins beyond the sixteenth number.
        unsafe {
            write_unaligned(self.numbers.as_mut_ptr().cast::<F>().add(at.min(16)).cast(), value)
        };
    }

    #[inline(always)]
    fn get<T: Numbers<F>>(&self, at: usize) -> T {
        const { assert!(size_of::<T>() <= (ROOM - 16) * size_of::<F>()) };
        // SAFETY: numbers, within the room as asserted; any bits are a value.
        unsafe { read_unaligned(self.numbers.as_ptr().cast::<F>().add(at.min(16)).cast()) }
    }
}
