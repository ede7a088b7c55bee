//! A contact for which everything that does not depend on the motion has been computed, as plain
//! numbers that C stores: a mark, the scaled contact, and the numbers of the model.

#![allow(unsafe_code)]

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::contact::plausibility::LARGEST_CREEPAGE;
use crate::contact::totals::StripCount;
use crate::forces::check::find_fault;
use crate::forces::options::{Model, Options, Solution};
use crate::forces::theory::{
    EllipseStrips, Forces, Linear, ScaledContact, Strip1967, Theory, Total, sliding_rule,
};
use crate::number::Float;
use crate::status::Error;
use crate::strip::Flexibilities;
use core::mem::MaybeUninit;

/// A contact for which kstrip_prepare() has computed everything that does not depend on the motion.
/// The structure holds plain numbers and no pointers, so it may be copied and kept, for this
/// version of the library only. It begins with a mark: a structure that was never prepared, or was
/// prepared in the other precision, gives KSTRIP_ERROR_NOT_PREPARED.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Prepared<F: Copy> {
    /// For use by the library only.
    pub numbers: MaybeUninit<[F; 96]>,
    /// The model; 0: nothing prepared.
    pub model: i32,
    /// The strip count.
    pub strips: i32,
}

/// Capacity in numbers.
const ROOM: usize = 96;
/// Where the [`mark`] stands.
const MARK_AT: usize = 0;
/// Where `w` stands: no check of [`find_fault`] can fail where `|υx| + |υy| + w |φ| ≤ 10`. It is
/// infinite for a lost contact and for dissimilar materials, where pressure changes the creepage.
const PER_SPIN: usize = 1;
/// Where the [`ScaledContact`] begins, and then the coefficients of the model.
const FRAME: usize = 2;
const KNOWN: usize = 19;

/// Structures that consist of numbers, so that any bits are a value of them.
///
/// # Safety
/// True of the implementor.
unsafe trait Numbers<F> {}
// SAFETY: so they are declared.
unsafe impl<F: Float> Numbers<F> for F {}
unsafe impl<F: Float> Numbers<F> for ScaledContact<F> {}
unsafe impl<F: Float> Numbers<F> for Total<F> {}
unsafe impl<F: Float> Numbers<F> for Flexibilities<F> {}
unsafe impl<F: Float> Numbers<F> for Linear<F> {}

/// The first number of a prepared structure: it encodes the precision and the model.
fn mark<F: Float>(model: Model) -> F {
    F::constant(1.967 * size_of::<F>() as f64) + F::widened(model as i32 as f32)
}

impl<F: Float> Prepared<F> {
    /// Prepare a contact for [`Prepared::solve`].
    ///
    /// # Errors
    /// Those of [`Contact::check`].
    ///
    /// # Example
    /// ```
    /// use kstrip::contact::{Contact, creepage::Creepage};
    /// use kstrip::forces::{Options, forces_of_contact, prepared::Prepared};
    /// let contact = Contact {
    ///     a: 6e-3, b: 4e-3, normal_force: 80e3, friction: 0.3,
    ///     shear_modulus: 82e9, poisson_ratio: 0.28, mismatch: 0.0,
    /// };
    /// let disc = Prepared::new(&contact, &Options::default())?;
    /// for percent in 0..10 {
    ///     let longitudinal = f64::from(percent) / 100.0;
    ///     let creepage = Creepage { longitudinal, lateral: 0.0, spin: 0.0 };
    ///     let found = forces_of_contact(&contact, &creepage, &Options::default());
    ///     assert_eq!(disc.solve(&creepage), found);
    /// }
    /// # Ok::<(), kstrip::status::Error>(())
    /// ```
    pub fn new(contact: &Contact<F>, options: &Options) -> Result<Self, Error> {
        contact.check()?;
        let Options { model, strips } = *options;
        let numbers = MaybeUninit::new([F::zero(); ROOM]);
        let mut stored = Self { numbers, model: model as i32, strips: strips as i32 };
        let quick = !contact.is_lost() && contact.mismatch == F::zero();
        let spin = if quick { contact.ordinary_spin() } else { F::zero() };
        let frame = &ScaledContact::new(contact);
        stored.put::<_, MARK_AT>(mark::<F>(model));
        stored.put::<_, PER_SPIN>(F::constant(LARGEST_CREEPAGE) / spin);
        stored.put::<_, FRAME>(*frame);
        match model {
            Model::Strip1967 | Model::Strip1967Continuous if Model::HAS_STRIP_1967 => {}
            Model::Strip if Model::HAS_STRIP => {
                stored.put::<_, KNOWN>(EllipseStrips::of_contact(frame, options).contact);
            }
            Model::Total if Model::HAS_TOTAL => {
                stored.put::<_, KNOWN>(Total::of_contact(frame, options));
            }
            Model::Linear if Model::HAS_LINEAR => {
                stored.put::<_, KNOWN>(Linear::of_contact(frame, options));
            }
            _ => return Err(Error::ModelLeftOut),
        }
        Ok(stored)
    }

    /// [`forces_of_contact`](crate::forces::forces_of_contact) for this contact: the same result,
    /// to the bit.
    ///
    /// # Errors
    /// Those of [`forces_of_contact`](crate::forces::forces_of_contact); [`Error::NotPrepared`].
    pub fn solve(&self, creepage: &Creepage<F>) -> Result<Solution<F>, Error> {
        let per_spin: &F = self.part::<_, PER_SPIN>();
        let quick = creepage.fastest_within(*per_spin) <= F::constant(LARGEST_CREEPAGE);
        let frame: &ScaledContact<F> = self.part::<_, FRAME>();
        let found = *self.part::<F, MARK_AT>();
        if Model::HAS_LINEAR && quick && self.model == Model::Linear as i32 {
            Error::NotPrepared.unless(found == mark(Model::Linear))?;
            let linear: &Linear<F> = self.part::<_, KNOWN>();
            let forces = Forces::at_rest(creepage, Model::Linear)
                .unwrap_or_else(|| linear.forces(frame, creepage).0);
            return Ok(frame.solution(Model::Linear, creepage, &forces, F::zero(), true));
        }
        let mut solution = Solution::default();
        self.solve_by_model(creepage, quick, &mut solution)?;
        Ok(solution)
    }

    /// Separate from the linear theory, so that the latter needs little stack.
    #[inline(never)]
    fn solve_by_model(
        &self, creepage: &Creepage<F>, quick: bool, solution: &mut Solution<F>,
    ) -> Result<(), Error> {
        let model = Model::from_number(self.model).ok_or(Error::NotPrepared)?;
        let strips = StripCount::from_number(self.strips).ok_or(Error::NotPrepared)?;
        Error::NotPrepared.unless(*self.part::<F, MARK_AT>() == mark(model))?;
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
                frame.solve_checked(self.part::<Linear<F>, KNOWN>(), creepage, ordinary)
            }
            Model::Total if Model::HAS_TOTAL => {
                frame.solve_checked(self.part::<Total<F>, KNOWN>(), creepage, ordinary)
            }
            Model::Strip if Model::HAS_STRIP => {
                let contact = *self.part::<Flexibilities<F>, KNOWN>();
                let theory = EllipseStrips::from_prepared(contact, strips);
                frame.solve_checked(&theory, creepage, ordinary)
            }
            Model::Strip1967 | Model::Strip1967Continuous if Model::HAS_STRIP_1967 => {
                frame.solve_checked(&Strip1967(sliding_rule(model)), creepage, ordinary)
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
    fn part<T: Numbers<F>, const AT: usize>(&self) -> &T {
        const { assert!(size_of::<T>() <= (ROOM - AT) * size_of::<F>()) };
        const { assert!(align_of::<T>() <= align_of::<F>()) };
        // SAFETY: numbers, aligned and within the room as asserted; any bits are a value.
        unsafe { &*self.numbers.as_ptr().cast::<F>().add(AT).cast::<T>() }
    }
}
