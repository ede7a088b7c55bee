//! Many contacts at once.

#[cfg(target_arch = "x86_64")]
pub(crate) mod side_by_side;

#[cfg(target_arch = "x86_64")]
pub use side_by_side::Wide;

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::solve::model::{self, Options, Precision, Solution};
use crate::status::{Error, Notice};

/// Forces of many contacts: what [`model::solve`] gives for each of them, bit for bit. Returns the notice with the
/// largest code.
///
/// `get` tells contact and creepage number `i`, `put` takes its solution. Where the processor has registers for several
/// numbers, several contacts are solved side by side.
///
/// All inputs are checked before anything is handed out: with an error nothing is. A lost contact is no error.
///
/// # Errors
/// Those of [`model::solve`], of the first bad input, with its number.
///
/// # Example
/// ```
/// use kstrip::{batch::solve_batch, contact::Contact, contact::creepage::Creepage, solve::model::Options};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, shear_modulus: 82e9, poisson_ratio: 0.28, friction: 0.3,
/// };
/// let creepage = |i| Creepage { longitudinal: i as f64 * 1e-5, lateral: 0.0, spin: 0.0 };
/// let mut forces = [0.0; 100];
/// solve_batch(100, &Options::default(), |i| (contact, creepage(i)), |i, found| forces[i] = found.fx)
///     .map_err(|(_, error)| error)?;
/// assert!(forces.is_sorted());
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn solve_batch<F: Precision>(
    count: usize,
    options: &Options,
    get: impl Fn(usize) -> (Contact<F>, Creepage<F>),
    mut put: impl FnMut(usize, Solution<F>),
) -> Result<Notice, (usize, Error)> {
    if count == 1 {
        // (a bad input is found before anything is handed out)
        return solve(0..1, options, &get, &mut put);
    }
    #[cfg(target_arch = "x86_64")]
    if side_by_side::available() {
        return F::solve_wide(count, options, get, put);
    }
    check(0..count, options, &get)?;
    solve(0..count, options, &get, &mut put)
}

/// # Errors
/// Those of the first bad input.
#[inline(never)]
pub(crate) fn check<F: Precision>(
    numbers: core::ops::Range<usize>,
    options: &Options,
    get: &impl Fn(usize) -> (Contact<F>, Creepage<F>),
) -> Result<(), (usize, Error)> {
    for i in numbers {
        let (contact, creepage) = get(i);
        model::check(&contact, &creepage, options).map_err(|error| (i, error))?;
    }
    Ok(())
}

/// One after the other.
///
/// # Errors
/// Those of the first bad input.
#[inline(never)]
pub(crate) fn solve<F: Precision>(
    numbers: core::ops::Range<usize>,
    options: &Options,
    get: &impl Fn(usize) -> (Contact<F>, Creepage<F>),
    put: &mut impl FnMut(usize, Solution<F>),
) -> Result<Notice, (usize, Error)> {
    let mut worst = Notice::None;
    for i in numbers {
        let (contact, creepage) = get(i);
        let solution = model::solve(&contact, &creepage, options).map_err(|error| (i, error))?;
        worst = worst.worse(solution.notice);
        put(i, solution);
    }
    Ok(worst)
}
