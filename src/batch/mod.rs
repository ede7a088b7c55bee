//! Many contacts at once.

pub(crate) mod one_by_one;
#[cfg(target_arch = "x86_64")]
pub(crate) mod side_by_side;

use crate::batch::one_by_one::{
    Case, DifferentiatedCase, Found, differentiate_each, solve_each, try_each,
};
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::forces;
use crate::forces::options::{Options, Solution};
use crate::friction::{FrictionSolution, InMotion};
use crate::number::Float;
#[cfg(target_arch = "x86_64")]
use crate::number::avx::HAS_WIDE_CODE;
use crate::status::{Error, Warning};

/// Forces of many contacts: what [`forces::forces_of_contact`] gives for each of them, bit for bit.
/// Returns the warning with the largest code.
///
/// `get` returns contact and creepage number `i`, `put` receives its solution. Where the processor
/// has registers for several numbers, several contacts are solved side by side.
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
///     shear_modulus: 82e9, poisson_ratio: 0.28, mismatch: 0.0,
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
    count: usize, options: &Options, get: impl Fn(usize) -> (Contact<F>, Creepage<F>),
    mut put: impl FnMut(usize, Solution<F>),
) -> Result<Warning, (usize, Error)> {
    let get = |i| {
        let (contact, creepage) = get(i);
        (contact, creepage, None)
    };
    check_each(count, &get, |(contact, creepage, _)| forces::check(contact, creepage, options))?;
    #[cfg(target_arch = "x86_64")]
    if HAS_WIDE_CODE
        && let Some(solved) = side_by_side::solve_side_by_side(count, options, &get, &mut put)
    {
        return solved;
    }
    solve_each(0..count, options, &get, &mut put)
}

/// [`solve_batch`] with falling friction.
pub(crate) fn solve_under_friction<F: Float>(
    count: usize, options: &Options, get: impl Fn(usize) -> Case<F>,
    mut put: impl FnMut(usize, FrictionSolution<F>),
) -> Found<Warning> {
    check_each(count, &get, |(contact, creepage, law)| {
        InMotion { creepage, law: law.as_ref(), options }.check(contact)
    })?;
    let mut worst = Warning::None;
    try_each(0..count, |i| {
        let (contact, creepage, law) = get(i);
        let motion = InMotion { creepage: &creepage, law: law.as_ref(), options };
        let found = motion.solve(&contact)?;
        if found.solution.warning != Warning::None {
            worst = worst.worse(found.solution.warning);
        }
        put(i, found);
        Ok(())
    })?;
    Ok(worst)
}

/// Checks all contacts, one by one unless they are ordinary in groups.
#[inline]
fn check_each<F: Float>(
    count: usize, get: &impl Fn(usize) -> Case<F>, check: impl Fn(&Case<F>) -> Result<(), Error>,
) -> Found<()> {
    let check = |numbers| try_each(numbers, |i| check(&get(i)));
    #[cfg(target_arch = "x86_64")]
    if HAS_WIDE_CODE && let Some(checked) = side_by_side::check_side_by_side(count, get, &check) {
        return checked;
    }
    check(0..count)
}

/// [`solve_batch`] with all derivatives, with or without falling friction.
pub(crate) fn differentiate_batch<F: Float>(
    count: usize, options: &Options, get: impl Fn(usize) -> Case<F>,
    mut put: impl FnMut(usize, &DifferentiatedCase<F>),
) -> Found<Warning> {
    check_each(count, &get, |(contact, creepage, law)| {
        InMotion { creepage, law: law.as_ref(), options }.check_differentiable(contact)
    })?;
    #[cfg(target_arch = "x86_64")]
    if HAS_WIDE_CODE
        && let Some(solved) =
            side_by_side::differentiate_side_by_side(count, options, &get, &mut put)
    {
        return solved;
    }
    differentiate_each(0..count, options, &get, &mut put)
}
