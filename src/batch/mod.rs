//! Many contacts at once.

#[cfg(target_arch = "x86_64")]
pub(crate) mod side_by_side;

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::forces;
use crate::forces::derivatives::{Derivatives, Slopes, solve_with_slopes};
use crate::forces::options::{Options, Solution};
use crate::friction::derivatives::{self, Differentiated, LawDerivatives, differentiate_checked};
use crate::friction::{self, FrictionSolution, SlipFriction};
use crate::number::Float;
#[cfg(target_arch = "x86_64")]
use crate::number::avx::HAS_WIDE_CODE;
use crate::status::{Error, Warning};

/// Forces of many contacts: what [`forces::forces_of_contact`] gives for each of them, bit for bit.
/// Returns the warning with the largest code.
///
/// `get` tells contact and creepage number `i`, `put` takes its solution. Where the processor has
/// registers for several numbers, several contacts are solved side by side.
///
/// All inputs are checked before anything is handed out: with an error nothing is. A lost contact
/// is no error.
///
/// # Errors
/// Those of [`forces::forces_of_contact`], of the first bad input, with its number.
///
/// # Example
/// ```
/// use kstrip::{batch::solve_batch, forces::Options};
/// use kstrip::contact::{Contact, creepage::Creepage};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, friction: 0.3,
///     shear_modulus: 82e9, poisson_ratio: 0.28,
///     mismatch: 0.0,
/// };
/// let creepage = |i| Creepage { longitudinal: i as f64 * 1e-5, lateral: 0.0, spin: 0.0 };
/// let mut forces = [0.0; 100];
/// let options = Options::default();
/// solve_batch(100, &options, |i| (contact, creepage(i)), |i, found| forces[i] = found.fx)
///     .map_err(|(_, error)| error)?;
/// assert!(forces.is_sorted());
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn solve_batch<F: Float>(
    count: usize,
    options: &Options,
    get: impl Fn(usize) -> (Contact<F>, Creepage<F>),
    mut put: impl FnMut(usize, Solution<F>),
) -> Result<Warning, (usize, Error)> {
    if count == 1 {
        // (a bad input is found before anything is handed out)
        return solve(0..1, options, &get, &mut put);
    }
    let case = |i| {
        let (contact, creepage) = get(i);
        (contact, creepage, None)
    };
    check_each(count, &case, |(contact, creepage, _)| forces::check(contact, creepage, options))?;
    #[cfg(target_arch = "x86_64")]
    if HAS_WIDE_CODE && let Some(solved) = side_by_side::solve(count, options, &get, &mut put) {
        return solved;
    }
    solve(0..count, options, &get, &mut put)
}

/// One after the other.
///
/// # Errors
/// Those of the first bad input.
#[inline(never)]
pub(crate) fn solve<F: Float>(
    numbers: core::ops::Range<usize>,
    options: &Options,
    get: &impl Fn(usize) -> (Contact<F>, Creepage<F>),
    put: &mut impl FnMut(usize, Solution<F>),
) -> Result<Warning, (usize, Error)> {
    let mut worst = Warning::None;
    for i in numbers {
        let (contact, creepage) = get(i);
        let solution = forces::forces_of_contact(&contact, &creepage, options);
        let solution = solution.as_ref().map_err(|error| (i, *error))?;
        worst = worst.worse(solution.warning);
        put(i, *solution);
    }
    Ok(worst)
}

/// A contact in motion and, where friction falls with the slip, its law.
pub(crate) type Case<F> = (Contact<F>, Creepage<F>, Option<SlipFriction<F>>);

/// [`solve_batch`] with friction that falls with the slip.
///
/// # Errors
/// Those of [`friction::solve`], of the first bad input, with its number.
pub(crate) fn solve_under_friction<F: Float>(
    count: usize,
    options: &Options,
    get: impl Fn(usize) -> Case<F>,
    mut put: impl FnMut(usize, FrictionSolution<F>),
) -> Result<Warning, (usize, Error)> {
    check_each(count, &get, |(contact, creepage, law)| match law {
        Some(law) => friction::check(contact, creepage, law, options),
        None => forces::check(contact, creepage, options),
    })?;
    let mut worst = Warning::None;
    each(0..count, |i| {
        let (contact, creepage, law) = get(i);
        let found = match law {
            Some(law) => friction::solve_checked(&contact, &creepage, &law, options)?,
            None => FrictionSolution {
                solution: forces::forces_of_contact(&contact, &creepage, options)?,
                friction: contact.friction,
            },
        };
        if found.solution.warning != Warning::None {
            worst = worst.worse(found.solution.warning);
        }
        put(i, found);
        Ok(())
    })?;
    Ok(worst)
}

/// Checks all contacts, one by one unless they are ordinary in groups.
///
/// # Errors
/// Those of the check, of the first bad input.
#[inline]
fn check_each<F: Float>(
    count: usize,
    get: &impl Fn(usize) -> Case<F>,
    check: impl Fn(&Case<F>) -> Result<(), Error>,
) -> Result<(), (usize, Error)> {
    let check = |numbers| each(numbers, |i| check(&get(i)));
    #[cfg(target_arch = "x86_64")]
    if HAS_WIDE_CODE && let Some(checked) = side_by_side::check(count, get, &check) {
        return checked;
    }
    check(0..count)
}

/// Forces and derivatives of a contact, where they stand.
pub(crate) struct Gathered<'a, F: Float> {
    pub(crate) solution: &'a Solution<F>,
    /// The coefficient of friction that agrees with the slip.
    pub(crate) friction: F,
    pub(crate) derivatives: &'a Derivatives<F>,
    creepage: &'a Creepage<F>,
    /// `κ dF/dκ` \[N, N, N m\]
    by_mismatch: &'a [F; 3],
    /// By the parameters of the law where there is one.
    law: Option<&'a LawDerivatives<F>>,
}

impl<F: Float> Gathered<'_, F> {
    /// Derivatives by the parameters of the law, or those of constant friction.
    pub(crate) fn law(&self) -> LawDerivatives<F> {
        self.law.copied().unwrap_or_else(|| {
            derivatives::without_law(self.derivatives, *self.by_mismatch, self.creepage)
        })
    }
}

/// [`solve_batch`] with all derivatives, with or without friction that falls with the slip.
///
/// # Errors
/// Those of [`differentiate`](derivatives::differentiate), of the first bad input, with its number.
pub(crate) fn differentiate_batch<F: Float>(
    count: usize,
    options: &Options,
    get: impl Fn(usize) -> Case<F>,
    mut put: impl FnMut(usize, &Gathered<F>),
) -> Result<Warning, (usize, Error)> {
    check_each(count, &get, |(contact, creepage, law)| {
        derivatives::check(contact, creepage, law.as_ref(), options)
    })?;
    #[cfg(target_arch = "x86_64")]
    if HAS_WIDE_CODE
        && let Some(solved) = side_by_side::differentiate(count, options, &get, &mut put)
    {
        return solved;
    }
    differentiate_each(0..count, options, &get, &mut put)
}

/// Checked contacts one after the other.
#[inline(never)]
pub(crate) fn differentiate_each<F: Float>(
    numbers: core::ops::Range<usize>,
    options: &Options,
    get: &impl Fn(usize) -> Case<F>,
    put: &mut impl FnMut(usize, &Gathered<F>),
) -> Result<Warning, (usize, Error)> {
    let mut worst = Warning::None;
    each(numbers, |i| {
        let (contact, creepage, law) = get(i);
        let creepage = &creepage;
        // (what was found is read where it stands)
        let warning = match law {
            None => {
                let found = solve_with_slopes(&contact, creepage, options);
                let (solution, slopes) = found.as_ref().map_err(|error| *error)?;
                let Slopes { derivatives, by_mismatch, .. } = slopes;
                let friction = contact.friction;
                put(
                    i,
                    &Gathered { solution, friction, derivatives, creepage, by_mismatch, law: None },
                );
                solution.warning
            }
            Some(law) => {
                let found = differentiate_checked(&contact, creepage, Some(&law), options);
                let found = found.as_ref().map_err(|error| *error)?;
                let Differentiated { solution, friction, derivatives, law, by_mismatch } = found;
                let (friction, law) = (*friction, Some(law));
                put(i, &Gathered { solution, friction, derivatives, creepage, by_mismatch, law });
                solution.warning
            }
        };
        if warning != Warning::None {
            worst = worst.worse(warning);
        }
        Ok(())
    })?;
    Ok(worst)
}

/// Stops at the first error, and tells its number.
fn each(
    mut numbers: core::ops::Range<usize>,
    mut task: impl FnMut(usize) -> Result<(), Error>,
) -> Result<(), (usize, Error)> {
    numbers.try_for_each(|i| task(i).map_err(|error| (i, error)))
}
