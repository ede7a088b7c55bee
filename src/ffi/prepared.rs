//! A prepared contact as plain numbers that C stores.

use super::checksum::checksum;
use super::support::*;
use crate::solve::check::is_ordinary;
use crate::solve::frame::Frame;
use crate::solve::prepared::Known;
use crate::solve::theory::{Linear, Strip, Strip1967, Theory, Total};
use crate::strip;
use core::hint::black_box;
use core::mem::offset_of;
use core::num::Wrapping;

/// How many numbers there is room for.
pub(super) const ROOM: usize = 96;
/// The numbers begin with a [`Head`], then a [`Frame`] and what the model knows.
const FRAME: usize = 3;
const KNOWN: usize = 20;
/// Where the checksums stand.
const QUICK_SUM: usize = 0;
const WHOLE_SUM: usize = 1;
/// Where `w` stands.
const PER_SPIN: usize = 2;

/// What the checksums of each precision start with: no bits that come by chance, and not those of the other precision.
const MARKS: [u64; 2] = [0x1967_1208_0c52_e817, 0x2b7e_1516_28ae_d2a6];

/// What is looked at before the rest.
#[repr(C)]
#[derive(Clone, Copy)]
struct Head<F> {
    /// Checksum of model, strip count and what the linear theory reads, as the bits of a number.
    quick: F,
    /// Checksum of everything from the frame on that the model reads.
    whole: F,
    /// `w`: where `|υx| + |υy| + w |φ| ≤ 10` no check of [`is_ordinary`] can fail; infinite where each has to be looked at, and of unlike
    /// materials, whose pressure moves the creepage.
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
unsafe impl<F: Precision> Numbers<F> for strip::Flexibilities<F> {}
unsafe impl<F: Precision> Numbers<F> for Linear<F> {}
// SAFETY: integers.
unsafe impl<F: Precision> Numbers<F> for u64 {}
// SAFETY: integers.
unsafe impl<F: Precision> Numbers<F> for u32 {}

impl<F: Precision> PreparedNumbers<F> {
    pub(super) fn of(prepared: &Prepared<F>) -> Self {
        let Options { model, strips } = prepared.options;
        let numbers = MaybeUninit::new([F::zero(); ROOM]);
        let mut stored = Self { numbers, model: model as i32, strips: strips as i32 };
        let contact = &prepared.frame.contact;
        let quick = !contact.is_lost() && contact.mismatch == F::zero();
        let spin = if quick { contact.ordinary_spin() } else { F::zero() };
        let per_spin = F::constant(QUICK) / spin;
        let none = F::zero();
        stored.put::<_, 0>(Head { quick: none, whole: none, per_spin });
        stored.put::<_, FRAME>(prepared.frame);
        match &prepared.known {
            Known::Strip1967(_) | Known::Strip1967Continuous(_) => {}
            Known::Strip(strips) => stored.put::<_, KNOWN>(strips.contact),
            Known::Total(total) => stored.put::<_, KNOWN>(*total),
            Known::Linear(linear) => stored.put::<_, KNOWN>(*linear),
        }
        let (quick, whole) = (stored.quick_sum(), stored.whole_sum(model));
        stored.put_sum::<QUICK_SUM>(quick);
        stored.put_sum::<WHOLE_SUM>(whole);
        stored
    }

    #[inline]
    pub(super) fn solve(&self, creepage: &Creepage<F>) -> Result<Solution<F>, Error> {
        if self.stored_sum::<QUICK_SUM>() != self.quick_sum() {
            return Err(Error::NotPrepared);
        }
        let head: &Head<F> = self.part::<_, 0>();
        let Creepage { longitudinal, lateral, spin } = *creepage;
        let size = longitudinal.abs() + lateral.abs() + spin.abs() * head.per_spin;
        let quick = size <= F::constant(QUICK);
        let frame: &Frame<F> = self.part::<_, FRAME>();
        if quick && self.model == Model::Linear as i32 {
            let linear: &Linear<F> = self.part::<_, KNOWN>();
            return Ok(linear.answer_seen(frame, creepage, true));
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
        if self.stored_sum::<WHOLE_SUM>() != self.whole_sum(model) {
            return Err(Error::NotPrepared);
        }
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
    fn quick_sum(&self) -> u64 {
        const { assert!(FRAME * size_of::<F>() + size_of::<Frame<F>>() <= KNOWN * size_of::<F>()) };
        let load = FRAME + offset_of!(Frame<F>, contact.normal_force) / size_of::<F>();
        let friction = FRAME + offset_of!(Frame<F>, contact.friction) / size_of::<F>();
        let places = [PER_SPIN, load, friction, KNOWN, KNOWN + 1, KNOWN + 2, KNOWN + 3];
        // (read apart from the forces, for which they would stay in registers that are saved first)
        let stored = black_box(self);
        match stored.words() {
            Words::Double(words, mark) => {
                checksum(mark, &places.map(|i| words.get(i).copied().unwrap_or_default())).0
            }
            Words::Single(words, mark) => {
                checksum(mark, &places.map(|i| words.get(i).copied().unwrap_or_default())).0.into()
            }
        }
    }

    /// Of model, strips and everything from the frame on that a model reads.
    fn whole_sum(&self, model: Model) -> u64 {
        let of_model = match model {
            Model::Strip1967 | Model::Strip1967Continuous => 0,
            Model::Strip => size_of::<strip::Flexibilities<F>>(),
            Model::Total => size_of::<Total<F>>(),
            Model::Linear => size_of::<Linear<F>>(),
        };
        let read = FRAME..KNOWN + of_model / size_of::<F>();
        match self.words() {
            Words::Double(words, mark) => checksum(mark, words.get(read).unwrap_or_default()).0,
            Words::Single(words, mark) => {
                checksum(mark, words.get(read).unwrap_or_default()).0.into()
            }
        }
    }

    /// All numbers as words, with what a sum of them starts with.
    #[inline]
    fn words(&self) -> Words<'_> {
        let [model, strips] = [self.model, self.strips].map(i32::cast_unsigned);
        let numbers = self.numbers.as_ptr();
        let [double, single] = MARKS;
        if size_of::<F>() == size_of::<u64>() {
            let mark = double ^ (u64::from(model) << 32) ^ u64::from(strips);
            // SAFETY: words as large and aligned as the numbers, and any bits are a value.
            Words::Double(unsafe { &*numbers.cast() }, Wrapping(mark))
        } else {
            let mark = single as u32 ^ (model << 16) ^ strips;
            // SAFETY: as before.
            Words::Single(unsafe { &*numbers.cast() }, Wrapping(mark))
        }
    }

    fn put_sum<const AT: usize>(&mut self, sum: u64) {
        if size_of::<F>() == size_of::<u64>() {
            self.put::<_, AT>(sum);
        } else {
            self.put::<_, AT>(sum as u32);
        }
    }

    /// A stored sum.
    #[inline]
    fn stored_sum<const AT: usize>(&self) -> u64 {
        match self.words() {
            Words::Double(words, _) => words.get(AT).map_or(0, |word| word.0),
            Words::Single(words, _) => words.get(AT).map_or(0, |word| word.0.into()),
        }
    }
}

/// The numbers of a structure as words of their size.
enum Words<'a> {
    Double(&'a [Wrapping<u64>; ROOM], Wrapping<u64>),
    Single(&'a [Wrapping<u32>; ROOM], Wrapping<u32>),
}
