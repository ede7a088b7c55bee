//! A prepared contact as plain numbers that C stores.

use super::checksum::{Bits, checksum};
use super::support::*;
use crate::solve::check::find_fault;
use crate::solve::prepared::Known;
use crate::solve::theory::{Frame, Linear, Strip, Strip1967, Theory, Total};
use crate::strip;
use core::hint::black_box;
use core::mem::offset_of;

/// How many numbers there is room for.
pub(super) const ROOM: usize = 96;
/// Where the checksum of model, strip count and what the linear theory reads stands, as the bits of a number.
const QUICK_SUM: usize = 0;
/// Where that of everything from the frame on that the model reads stands.
const WHOLE_SUM: usize = 1;
/// Where `w` stands: where `|υx| + |υy| + w |φ| ≤ 10` no check of [`find_fault`] can fail; infinite where each has to be looked at, and of
/// unlike materials, whose pressure moves the creepage.
const PER_SPIN: usize = 2;
/// Where the [`Frame`] begins, and then what the model knows.
const FRAME: usize = 3;
const KNOWN: usize = 20;

/// `|υ|` up to which no check can fail.
const QUICK: f64 = 10.0;

/// Structures that consist of numbers, so that any bits are a value of them.
///
/// # Safety
/// True of the implementor.
unsafe trait Numbers<F> {}
// SAFETY: so they are declared.
unsafe impl<F: Precision> Numbers<F> for F {}
unsafe impl<F: Precision> Numbers<F> for Frame<F> {}
unsafe impl<F: Precision> Numbers<F> for Total<F> {}
unsafe impl<F: Precision> Numbers<F> for strip::Flexibilities<F> {}
unsafe impl<F: Precision> Numbers<F> for Linear<F> {}
// SAFETY: integers.
unsafe impl<F: Bits> Numbers<F> for [F::Word; 2] {}

impl<F: Bits> PreparedNumbers<F> {
    pub(super) fn of(prepared: &Prepared<F>) -> Self {
        let Options { model, strips } = prepared.options;
        let numbers = MaybeUninit::new([F::zero(); ROOM]);
        let mut stored = Self { numbers, model: model as i32, strips: strips as i32 };
        let contact = &prepared.frame.contact;
        let quick = !contact.is_lost() && contact.mismatch == F::zero();
        let spin = if quick { contact.ordinary_spin() } else { F::zero() };
        stored.put::<_, PER_SPIN>(F::constant(QUICK) / spin);
        stored.put::<_, FRAME>(prepared.frame);
        match &prepared.known {
            Known::Strip1967(_) | Known::Strip1967Continuous(_) => {}
            Known::Strip(strips) => stored.put::<_, KNOWN>(strips.contact),
            Known::Total(total) => stored.put::<_, KNOWN>(*total),
            Known::Linear(linear) => stored.put::<_, KNOWN>(*linear),
        }
        stored.put::<_, QUICK_SUM>([stored.quick_sum(), stored.whole_sum(model)]);
        stored
    }

    #[inline]
    pub(super) fn solve(&self, creepage: &Creepage<F>) -> Result<Solution<F>, Error> {
        Error::NotPrepared.unless(self.words()[QUICK_SUM] == self.quick_sum())?;
        let per_spin: &F = self.part::<_, PER_SPIN>();
        let Creepage { longitudinal, lateral, spin } = *creepage;
        let size = longitudinal.abs() + lateral.abs() + spin.abs() * *per_spin;
        let quick = size <= F::constant(QUICK);
        let frame: &Frame<F> = self.part::<_, FRAME>();
        if quick && self.model == Model::Linear as i32 {
            let linear: &Linear<F> = self.part::<_, KNOWN>();
            // (like materials see the creepage itself)
            let forces =
                Linear::at_rest(creepage).unwrap_or_else(|| linear.forces(frame, creepage).0);
            return Ok(Linear::solution(frame, creepage, &forces, F::zero(), true));
        }
        let mut found = Solution::nothing();
        self.solve_other(creepage, quick, &mut found)?;
        Ok(found)
    }

    /// (Apart from the linear theory, which is done before much has been put on the stack.)
    #[inline(never)]
    fn solve_other(
        &self,
        creepage: &Creepage<F>,
        quick: bool,
        found: &mut Solution<F>,
    ) -> Result<(), Error> {
        let model = Model::from_number(self.model).ok_or(Error::NotPrepared)?;
        let strips = StripCount::from_number(self.strips).ok_or(Error::NotPrepared)?;
        Error::NotPrepared.unless(self.words()[WHOLE_SUM] == self.whole_sum(model))?;
        let frame: &Frame<F> = self.part::<_, FRAME>();
        let ordinary = quick || frame.contact.is_ordinary(creepage);
        if !ordinary {
            find_fault(&frame.contact, creepage, model)?;
        }
        if !quick && frame.contact.is_lost() {
            return Ok(());
        }
        *found = match model {
            Model::Linear => self.part::<Linear<F>, KNOWN>().answer(frame, creepage, ordinary),
            Model::Total => self.part::<Total<F>, KNOWN>().answer(frame, creepage, ordinary),
            // (strips alone are moved: their numbers may stand in wide registers)
            Model::Strip => {
                Strip::from_prepared(self.copied(), strips).answer(frame, creepage, ordinary)
            }
            Model::Strip1967 => Strip1967::<false>.answer(frame, creepage, ordinary),
            Model::Strip1967Continuous => Strip1967::<true>.answer(frame, creepage, ordinary),
        };
        Ok(())
    }

    fn put<T: Numbers<F>, const AT: usize>(&mut self, value: T) {
        const { assert!(size_of::<T>() <= (ROOM - AT) * size_of::<F>()) };
        // SAFETY: there is room, as asserted.
        unsafe { self.numbers.as_mut_ptr().cast::<F>().add(AT).cast::<T>().write_unaligned(value) };
    }

    /// Where they stand.
    #[inline]
    fn part<T: Numbers<F>, const AT: usize>(&self) -> &T {
        const { assert!(size_of::<T>() <= (ROOM - AT) * size_of::<F>()) };
        const { assert!(align_of::<T>() <= align_of::<F>()) };
        // SAFETY: numbers, aligned and within the room as asserted; any bits are a value.
        unsafe { &*self.numbers.as_ptr().cast::<F>().add(AT).cast::<T>() }
    }

    #[inline]
    fn copied(&self) -> strip::Flexibilities<F> {
        const { assert!(size_of::<strip::Flexibilities<F>>() <= (ROOM - KNOWN) * size_of::<F>()) };
        let numbers = self.numbers.as_ptr().cast::<F>();
        // SAFETY: numbers, within the room as asserted; any bits are a value.
        unsafe { numbers.add(KNOWN).cast::<strip::Flexibilities<F>>().read_unaligned() }
    }

    /// Of model, strips and what the linear theory of like bodies reads: `w`, `N`, `μ`, stiffness.
    #[inline]
    fn quick_sum(&self) -> F::Word {
        const { assert!(FRAME * size_of::<F>() + size_of::<Frame<F>>() <= KNOWN * size_of::<F>()) };
        let load = FRAME + offset_of!(Frame<F>, contact.normal_force) / size_of::<F>();
        let friction = FRAME + offset_of!(Frame<F>, contact.friction) / size_of::<F>();
        let places = [PER_SPIN, load, friction, KNOWN, KNOWN + 1, KNOWN + 2, KNOWN + 3];
        // (read apart from the forces, for which they would stay in registers that are saved first)
        let stored = black_box(self);
        let words = places.map(|i| stored.words().get(i).copied().unwrap_or_default());
        checksum(F::mark(stored.model, stored.strips), &words)
    }

    /// Of model, strips and everything from the frame on that a model reads.
    fn whole_sum(&self, model: Model) -> F::Word {
        let of_model = match model {
            Model::Strip1967 | Model::Strip1967Continuous => 0,
            Model::Strip => size_of::<strip::Flexibilities<F>>(),
            Model::Total => size_of::<Total<F>>(),
            Model::Linear => size_of::<Linear<F>>(),
        };
        let read = FRAME..KNOWN + of_model / size_of::<F>();
        let words = self.words().get(read).unwrap_or_default();
        checksum(F::mark(self.model, self.strips), words)
    }

    /// All numbers as words.
    #[inline]
    fn words(&self) -> &[F::Word; ROOM] {
        const { assert!(size_of::<F::Word>() == size_of::<F>()) };
        const { assert!(align_of::<F::Word>() == align_of::<F>()) };
        // SAFETY: words as large and aligned as the numbers, and any bits are a value.
        unsafe { &*self.numbers.as_ptr().cast() }
    }
}
