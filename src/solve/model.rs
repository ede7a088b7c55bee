//! From a contact and a creepage to forces.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::solve::check::is_ordinary;
use crate::solve::frame::Frame;
use crate::solve::theory::{Linear, Strip, Strip1967, Theory, Total};
use crate::status::Error;

pub use crate::solve::check::check;
pub use crate::solve::derivatives::solve_jacobian;
pub use crate::solve::field::{Field, FieldStrip};
pub use crate::solve::options::{Model, Options, Precision, Solution};
pub use crate::solve::strips::{StripResult, strips, strips_of};

/// Forces for a contact and a creepage.
///
/// # Errors
/// Those of [`Contact::check`] and [`Creepage::check`]; [`Error::Overflow`] when a force or the power
/// does not fit the floating-point type.
///
/// # Example
/// A wheel on a rail, 0.1 % longitudinal creepage:
/// ```
/// use kstrip::{contact::Contact, contact::creepage::Creepage, solve::model::{solve, Options}};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, shear_modulus: 82e9, poisson_ratio: 0.28, friction: 0.3,
///     mismatch: 0.0,
/// };
/// let creepage = Creepage { longitudinal: 1e-3, lateral: 0.0, spin: 0.0 };
/// let forces = solve(&contact, &creepage, &Options::default())?;
/// assert!(forces.fx > 0.0 && forces.fx < 24e3 && forces.fy == 0.0);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn solve<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
) -> Result<Solution<F>, Error> {
    solve_inline(contact, creepage, options)
}

/// [`solve`] in the code of each caller, so that a model that the compiler knows is the only one there.
#[inline(always)]
pub(crate) fn solve_inline<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
) -> Result<Solution<F>, Error> {
    let ordinary = is_ordinary(contact, creepage, options.model)?;
    if contact.is_lost() {
        return Ok(Solution::nothing());
    }
    let frame = &Frame::of(contact);
    Ok(match options.model {
        Model::Strip1967 => {
            Strip1967::<false>::of_contact(frame, options).answer(frame, creepage, ordinary)
        }
        Model::Strip1967Continuous => {
            Strip1967::<true>::of_contact(frame, options).answer(frame, creepage, ordinary)
        }
        Model::Strip => Strip::of_contact(frame, options).answer(frame, creepage, ordinary),
        Model::Total => Total::of_contact(frame, options).answer(frame, creepage, ordinary),
        Model::Linear => Linear::of_contact(frame, options).answer(frame, creepage, ordinary),
    })
}
