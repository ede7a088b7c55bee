//! Checks of the inputs before anything is computed, so that bad input leaves outputs untouched.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::forces::options::{Model, Options};
use crate::number::{Float, Real};
use crate::status::Error;

/// Check the inputs of [`solve`](crate::forces::forces_of_contact) without solving.
///
/// # Errors
/// Those of [`Contact::check`] and [`Creepage::check`]; [`Error::Overflow`] when a force, the
/// moment or the power could be beyond the floating-point type.
#[cfg_attr(target_arch = "x86_64", inline)]
#[cfg_attr(not(target_arch = "x86_64"), inline(never))]
pub fn check<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, options: &Options,
) -> Result<(), Error> {
    if contact.is_ordinary(creepage) {
        return Ok(());
    }
    find_fault(contact, creepage, options.model)
}

/// The complete check, for inputs that are not [ordinary](Contact::is_ordinary).
#[cold]
#[inline(never)]
pub(crate) fn find_fault<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, model: Model,
) -> Result<(), Error> {
    contact.check()?;
    creepage.check()?;
    let range = range(contact, creepage, model);
    let fits = contact.is_lost() || range.iter().all(|number| number.is_finite_number());
    Error::Overflow.unless(fits)
}

/// Upper bounds of power, moment, force and the slip by spin: every result is finite if these are.
fn range<F: Real>(contact: &Contact<F>, creepage: &Creepage<F>, model: Model) -> [F; 4] {
    let Creepage { longitudinal, lateral, spin } = *creepage;
    let Contact { a, b, .. } = *contact;
    let bound = force_limit(contact, creepage, model);
    let moment = bound * (a + b);
    let longitudinal = longitudinal.abs() + contact.strain().abs();
    let power = bound * longitudinal + bound * lateral.abs() + moment * spin.abs();
    // The slip by spin at the edge, also of a contact without forces.
    let edge_slip = (a + b) * spin.abs();
    // Slightly above the bounds, because forces are rounded.
    [power, moment, bound, edge_slip].map(|number| number.times(1.001))
}

/// Upper bound of the forces of the model \[N\].
fn force_limit<F: Real>(contact: &Contact<F>, creepage: &Creepage<F>, model: Model) -> F {
    if model != Model::Linear {
        return contact.friction_bound();
    }
    let Contact { a, b, shear_modulus, .. } = *contact;
    // No coefficient exceeds this: C23 grows like (a/b)^(3/2). At least one, because stiffness
    // times lever is a factor of the moment.
    let ratio = a / b + b / a;
    let size = contact.fastest_slip(creepage) * (ratio * ratio.sqrt()).plus(100.0);
    shear_modulus * a * b * size.max(F::one())
}
