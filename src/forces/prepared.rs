//! A contact for which everything that does not depend on the motion has been computed.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::forces::check::find_fault;
use crate::forces::options::{Model, Options, Solution};
use crate::forces::theory::{EllipseStrips, Linear, ScaledContact, Strip1967, Theory, Total};
use crate::number::{Float, Real};
use crate::status::Error;

/// A contact and a model, ready for creepages.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<F: Real> {
    pub(crate) frame: ScaledContact<F>,
    pub(crate) options: Options,
    pub(crate) known: ModelState<F>,
}

/// The numbers that a model computes from a contact.
#[derive(Clone, Copy, Debug)]
#[allow(clippy::large_enum_variant)]
pub(crate) enum ModelState<F: Real> {
    Strip1967(Strip1967),
    Strip(EllipseStrips<F>),
    Total(Total<F>),
    Linear(Linear<F>),
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
    ///     shear_modulus: 82e9, poisson_ratio: 0.28,
    ///     mismatch: 0.0,
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
        let frame = ScaledContact::new(contact);
        let known = match options.model {
            Model::Strip1967 | Model::Strip1967Continuous if Model::HAS_STRIP_1967 => {
                ModelState::Strip1967(Theory::of_contact(&frame, options))
            }
            Model::Strip if Model::HAS_STRIP => {
                ModelState::Strip(Theory::of_contact(&frame, options))
            }
            Model::Total if Model::HAS_TOTAL => {
                ModelState::Total(Theory::of_contact(&frame, options))
            }
            Model::Linear if Model::HAS_LINEAR => {
                ModelState::Linear(Theory::of_contact(&frame, options))
            }
            _ => return Err(Error::Model),
        };
        Ok(Self { frame, options: *options, known })
    }

    /// [`solve`](crate::forces::forces_of_contact) for this contact: the same result, to the bit.
    ///
    /// # Errors
    /// Those of [`solve`](crate::forces::forces_of_contact).
    pub fn solve(&self, creepage: &Creepage<F>) -> Result<Solution<F>, Error> {
        let frame = &self.frame;
        let ordinary = frame.contact.is_ordinary(creepage);
        if !ordinary {
            find_fault(&frame.contact, creepage, self.options.model)?;
        }
        if frame.contact.is_lost() {
            return Ok(Solution::nothing());
        }
        Ok(match &self.known {
            ModelState::Strip1967(theory) => theory.answer(frame, creepage, ordinary),
            ModelState::Strip(strips) => strips.answer(frame, creepage, ordinary),
            ModelState::Total(total) => total.answer(frame, creepage, ordinary),
            ModelState::Linear(linear) => linear.answer(frame, creepage, ordinary),
        })
    }
}
