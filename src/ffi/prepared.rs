//! A prepared contact as plain numbers that C stores.

use super::support::*;
use crate::solve::check::is_ordinary;
use crate::solve::frame::Frame;
use crate::solve::prepared::Known;
use crate::solve::theory::{Linear, Strip, Strip1967, Theory, Total};
use crate::strip;

/// How many numbers there is room for.
pub(super) const ROOM: usize = 96;
/// The numbers begin with a [`Head`], then a [`Frame`] and what the model knows.
const FRAME: usize = 3;
const KNOWN: usize = 20;

/// What model and strip count are told with where a contact has been prepared: no bits that come by chance.
const MARKS: [i32; 2] = [0x1967_1208, 0x0c52_e817];

/// What is looked at before the rest.
#[repr(C)]
#[derive(Clone, Copy)]
struct Head<F> {
    /// Model and strip count, each with the bits of its [`MARKS`] turned.
    marks: [i32; 2],
    /// `w`: where `|υx| + |υy| + w |φ| ≤ 10` no check of [`is_ordinary`] can fail; infinite where each has to be looked at.
    per_spin: F,
}

/// `|υ|` up to which no check can fail.
const QUICK: f64 = 10.0;

/// Structures that consist of numbers, so that any bits are a value of them.
///
/// # Safety
/// True of the implementor.
unsafe trait Numbers<F> {}
// SAFETY: so they are declared.
unsafe impl<F: Precision> Numbers<F> for Head<F> {}
unsafe impl<F: Precision> Numbers<F> for Frame<F> {}
unsafe impl<F: Precision> Numbers<F> for Total<F> {}
unsafe impl<F: Precision> Numbers<F> for strip::Prepared<F> {}
unsafe impl<F: Precision> Numbers<F> for Linear<F> {}

impl<F: Precision> PreparedNumbers<F> {
    pub(super) fn of(prepared: &Prepared<F>) -> Self {
        let Options { model, strips } = prepared.options;
        let numbers = MaybeUninit::new([F::zero(); ROOM]);
        let mut stored = Self { numbers, model: model as i32, strips: strips as i32 };
        let contact = &prepared.frame.contact;
        let spin = if contact.is_lost() { F::zero() } else { contact.ordinary_spin() };
        let per_spin = F::constant(QUICK) / spin;
        stored.put::<_, 0>(Head { marks: marks(stored.model, stored.strips), per_spin });
        stored.put::<_, FRAME>(prepared.frame);
        match &prepared.known {
            Known::Strip1967(_) | Known::Strip1967Continuous(_) => {}
            Known::Strip(strips) => stored.put::<_, KNOWN>(strips.contact),
            Known::Total(total) => stored.put::<_, KNOWN>(*total),
            Known::Linear(linear) => stored.put::<_, KNOWN>(*linear),
        }
        stored
    }

    #[inline(always)]
    pub(super) fn solve(&self, creepage: &Creepage<F>) -> Result<Solution<F>, Error> {
        let head: &Head<F> = self.part::<_, 0>();
        if head.marks != marks(self.model, self.strips) {
            return Err(Error::NotPrepared);
        }
        let Creepage { longitudinal, lateral, spin } = *creepage;
        let size = longitudinal.abs() + lateral.abs() + spin.abs() * head.per_spin;
        let quick = size <= F::constant(QUICK);
        if quick && self.model == Model::Linear as i32 {
            let linear: &Linear<F> = self.part::<_, KNOWN>();
            return Ok(linear.answer(self.part::<_, FRAME>(), creepage, true));
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
        let frame: &Frame<F> = self.part::<_, FRAME>();
        let ordinary = quick || is_ordinary(&frame.contact, creepage, model)?;
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
    #[inline(always)]
    fn part<T: Numbers<F>, const AT: usize>(&self) -> &T {
        const { assert!(size_of::<T>() <= (ROOM - AT) * size_of::<F>()) };
        const { assert!(align_of::<T>() <= align_of::<F>()) };
        // SAFETY: numbers, aligned and within the room as asserted; any bits are a value.
        unsafe { &*self.numbers.as_ptr().cast::<F>().add(AT).cast::<T>() }
    }

    #[inline(always)]
    fn copied(&self) -> strip::Prepared<F> {
        const { assert!(size_of::<strip::Prepared<F>>() <= (ROOM - KNOWN) * size_of::<F>()) };
        let numbers = self.numbers.as_ptr().cast::<F>();
        // SAFETY: numbers, within the room as asserted; any bits are a value.
        unsafe { numbers.add(KNOWN).cast::<strip::Prepared<F>>().read_unaligned() }
    }
}

fn marks(model: i32, strips: i32) -> [i32; 2] {
    let [of_model, of_strips] = MARKS;
    [model ^ of_model, strips ^ of_strips]
}
