//! A prepared contact as plain numbers that C stores: a mark, the scaled contact, and the numbers
//! that the model computes from it.

use super::support::*;
use crate::forces::check::find_fault;
use crate::forces::prepared::ModelState;
use crate::forces::theory::{ScaledContact, sliding_rule};
use crate::strip;

/// Capacity in numbers.
pub(super) const ROOM: usize = 96;
/// Where the [`mark`] stands.
const MARK: usize = 0;
/// Where `w` stands: no check of [`find_fault`] can fail where `|υx| + |υy| + w |φ| ≤ 10`. It is
/// infinite for a lost contact and for unlike materials, where pressure changes the creepage.
const PER_SPIN: usize = 1;
/// Where the [`ScaledContact`] begins, and then the coefficients of the model.
const FRAME: usize = 2;
const KNOWN: usize = 19;

/// `|υ|` up to which no check can fail.
const QUICK: f64 = 10.0;

/// Structures that consist of numbers, so that any bits are a value of them.
///
/// # Safety
/// True of the implementor.
unsafe trait Numbers<F> {}
// SAFETY: so they are declared.
unsafe impl<F: Float> Numbers<F> for F {}
unsafe impl<F: Float> Numbers<F> for ScaledContact<F> {}
unsafe impl<F: Float> Numbers<F> for Total<F> {}
unsafe impl<F: Float> Numbers<F> for strip::Flexibilities<F> {}
unsafe impl<F: Float> Numbers<F> for Linear<F> {}

/// The first number of a prepared structure: it encodes the precision and the model.
#[inline]
fn mark<F: Float>(model: Model) -> F {
    F::constant(1.967 * size_of::<F>() as f64) + F::widened(model as i32 as f32)
}

impl<F: Float> PreparedNumbers<F> {
    pub(super) fn new(prepared: &Prepared<F>) -> Self {
        let Options { model, strips } = prepared.options;
        let numbers = MaybeUninit::new([F::zero(); ROOM]);
        let mut stored = Self { numbers, model: model as i32, strips: strips as i32 };
        let contact = &prepared.frame.contact;
        let quick = !contact.is_lost() && contact.mismatch == F::zero();
        let spin = if quick { contact.ordinary_spin() } else { F::zero() };
        stored.put::<_, MARK>(mark::<F>(model));
        stored.put::<_, PER_SPIN>(F::constant(QUICK) / spin);
        stored.put::<_, FRAME>(prepared.frame);
        match &prepared.known {
            ModelState::Strip1967(_) => {}
            ModelState::Strip(strips) => stored.put::<_, KNOWN>(strips.contact),
            ModelState::Total(total) => stored.put::<_, KNOWN>(*total),
            ModelState::Linear(linear) => stored.put::<_, KNOWN>(*linear),
        }
        stored
    }

    #[inline]
    pub(super) fn solve(&self, creepage: &Creepage<F>) -> Result<Solution<F>, Error> {
        let per_spin: &F = self.part::<_, PER_SPIN>();
        let Creepage { longitudinal, lateral, spin } = *creepage;
        let size = longitudinal.abs() + lateral.abs() + spin.abs() * *per_spin;
        let quick = size <= F::constant(QUICK);
        let frame: &ScaledContact<F> = self.part::<_, FRAME>();
        let found = *self.part::<F, MARK>();
        if Model::HAS_LINEAR && quick && self.model == Model::Linear as i32 {
            Error::NotPrepared.unless(found == mark(Model::Linear))?;
            let linear: &Linear<F> = self.part::<_, KNOWN>();
            let forces =
                Linear::at_rest(creepage).unwrap_or_else(|| linear.forces(frame, creepage).0);
            return Ok(Linear::solution(frame, creepage, &forces, F::zero(), true));
        }
        let mut solution = Solution::nothing();
        self.solve_by_model(creepage, quick, &mut solution)?;
        Ok(solution)
    }

    /// Separate from the linear theory, so that the latter needs little stack.
    #[inline(never)]
    fn solve_by_model(
        &self,
        creepage: &Creepage<F>,
        quick: bool,
        solution: &mut Solution<F>,
    ) -> Result<(), Error> {
        let model = Model::from_number(self.model).ok_or(Error::NotPrepared)?;
        let strips = StripCount::from_number(self.strips).ok_or(Error::NotPrepared)?;
        Error::NotPrepared.unless(*self.part::<F, MARK>() == mark(model))?;
        let frame: &ScaledContact<F> = self.part::<_, FRAME>();
        let ordinary = quick || frame.contact.is_ordinary(creepage);
        if !ordinary {
            find_fault(&frame.contact, creepage, model)?;
        }
        if !quick && frame.contact.is_lost() {
            return Ok(());
        }
        *solution = match model {
            Model::Linear if Model::HAS_LINEAR => {
                self.part::<Linear<F>, KNOWN>().answer(frame, creepage, ordinary)
            }
            Model::Total if Model::HAS_TOTAL => {
                self.part::<Total<F>, KNOWN>().answer(frame, creepage, ordinary)
            }
            Model::Strip if Model::HAS_STRIP => {
                let contact = *self.part::<strip::Flexibilities<F>, KNOWN>();
                EllipseStrips::from_prepared(contact, strips).answer(frame, creepage, ordinary)
            }
            Model::Strip1967 | Model::Strip1967Continuous if Model::HAS_STRIP_1967 => {
                Strip1967(sliding_rule(model)).answer(frame, creepage, ordinary)
            }
            _ => return Err(Error::NotPrepared),
        };
        Ok(())
    }

    fn put<T: Numbers<F>, const AT: usize>(&mut self, value: T) {
        const { assert!(size_of::<T>() <= (ROOM - AT) * size_of::<F>()) };
        // SAFETY: there is room, as asserted.
        unsafe { self.numbers.as_mut_ptr().cast::<F>().add(AT).cast::<T>().write_unaligned(value) };
    }

    /// Index of the first of them.
    #[inline]
    fn part<T: Numbers<F>, const AT: usize>(&self) -> &T {
        const { assert!(size_of::<T>() <= (ROOM - AT) * size_of::<F>()) };
        const { assert!(align_of::<T>() <= align_of::<F>()) };
        // SAFETY: numbers, aligned and within the room as asserted; any bits are a value.
        unsafe { &*self.numbers.as_ptr().cast::<F>().add(AT).cast::<T>() }
    }
}
