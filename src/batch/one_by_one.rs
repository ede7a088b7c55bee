//! Many contacts one after the other, and the inputs and results of one of them.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::forces;
use crate::forces::derivatives::{Derivatives, solve_with_slopes};
use crate::forces::options::{Options, Solution};
use crate::friction::derivatives::{self, Differentiated, LawDerivatives};
use crate::friction::{InMotion, SlipFriction};
use crate::number::Float;
use crate::status::{Error, Warning};

/// A result, or the first bad input and its number.
pub(crate) type Found<T> = Result<T, (usize, Error)>;

/// Largest number of contacts side by side.
pub(super) const MOST: usize = 16;

/// A contact in motion and, where friction falls with the slip, its law.
pub(crate) type Case<F> = (Contact<F>, Creepage<F>, Option<SlipFriction<F>>);

/// Forces and derivatives of a contact of a batch, by reference: of one without a law the
/// derivatives with respect to its parameters are computed only if they are requested.
pub(crate) struct DifferentiatedCase<'a, F: Float> {
    pub(crate) solution: &'a Solution<F>,
    /// The coefficient of friction that agrees with the slip.
    pub(crate) friction: F,
    pub(crate) derivatives: &'a Derivatives<F>,
    pub(super) creepage: &'a Creepage<F>,
    /// `κ dF/dκ` \[N, N, N m\], of dissimilar materials.
    pub(super) by_mismatch: Option<&'a [F; 3]>,
    /// By the parameters of the law where there is one.
    pub(super) law: Option<&'a LawDerivatives<F>>,
}

impl<F: Float> DifferentiatedCase<'_, F> {
    /// Derivatives with respect to the parameters of the law, or those of constant friction.
    pub(crate) fn law(&self) -> LawDerivatives<F> {
        self.law.copied().unwrap_or_else(|| {
            let by_mismatch = self.by_mismatch.copied().unwrap_or_default();
            derivatives::without_law(self.derivatives, by_mismatch, self.creepage)
        })
    }
}

/// Forces of checked contacts, one after the other.
#[inline(never)]
pub(crate) fn solve_each<F: Float>(
    numbers: core::ops::Range<usize>, options: &Options, get: &impl Fn(usize) -> Case<F>,
    put: &mut impl FnMut(usize, Solution<F>),
) -> Found<Warning> {
    let mut worst = Warning::None;
    for i in numbers {
        let (contact, creepage, _) = get(i);
        let solution = forces::forces_of_contact(&contact, &creepage, options);
        let solution = solution.as_ref().map_err(|error| (i, *error))?;
        worst = worst.worse(solution.warning);
        put(i, *solution);
    }
    Ok(worst)
}

/// Forces and derivatives of checked contacts, one after the other.
#[inline(never)]
pub(crate) fn differentiate_each<F: Float>(
    numbers: core::ops::Range<usize>, options: &Options, get: &impl Fn(usize) -> Case<F>,
    put: &mut impl FnMut(usize, &DifferentiatedCase<F>),
) -> Found<Warning> {
    let mut worst = Warning::None;
    try_each(numbers, |i| {
        let (contact, creepage, law) = get(i);
        let creepage = &creepage;
        // By reference: avoids a copy on the stack.
        let (plain, under);
        let found = if law.is_none() {
            plain = solve_with_slopes(&contact, creepage, options);
            let (solution, slopes) = plain.as_ref().map_err(|error| *error)?;
            let (friction, by_mismatch) = (contact.friction, Some(&slopes.by_mismatch.forces));
            let derivatives = &slopes.derivatives;
            DifferentiatedCase { solution, friction, derivatives, creepage, by_mismatch, law: None }
        } else {
            under = InMotion { creepage, law: law.as_ref(), options }.differentiate(&contact);
            let Differentiated { solution, friction, derivatives, law, .. } =
                under.as_ref().map_err(|error| *error)?;
            let (friction, law) = (*friction, Some(law));
            DifferentiatedCase { solution, friction, derivatives, creepage, by_mismatch: None, law }
        };
        put(i, &found);
        if found.solution.warning != Warning::None {
            worst = worst.worse(found.solution.warning);
        }
        Ok(())
    })?;
    Ok(worst)
}

/// Stops at the first error and returns it with its number.
pub(super) fn try_each(
    mut numbers: core::ops::Range<usize>, mut task: impl FnMut(usize) -> Result<(), Error>,
) -> Found<()> {
    numbers.try_for_each(|i| task(i).map_err(|error| (i, error)))
}
