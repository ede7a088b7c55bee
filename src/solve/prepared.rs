//! A contact for which everything that does not depend on the motion has been computed.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::number::{Float, Real};
use crate::solve::check::find_fault;
use crate::solve::options::{Model, Options, Solution};
use crate::solve::theory::{Frame, Linear, Strip, Strip1967, Theory, Total};
use crate::status::Error;

/// A contact and a model, ready for creepages.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<F: Real> {
    pub(crate) frame: Frame<F>,
    pub(crate) options: Options,
    pub(crate) known: Known<F>,
}

/// What a model knows of a contact.
#[derive(Clone, Copy, Debug)]
#[allow(clippy::large_enum_variant)]
pub(crate) enum Known<F: Real> {
    Strip1967(Strip1967<false>),
    Strip1967Continuous(Strip1967<true>),
    Strip(Strip<F>),
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
    /// use kstrip::{contact::Contact, contact::creepage::Creepage, solve::model::{solve, Options}};
    /// use kstrip::solve::prepared::Prepared;
    /// let contact = Contact {
    ///     a: 6e-3, b: 4e-3, normal_force: 80e3, shear_modulus: 82e9, poisson_ratio: 0.28, friction: 0.3,
    ///     mismatch: 0.0,
    /// };
    /// let disc = Prepared::new(&contact, &Options::default())?;
    /// for percent in 0..10 {
    ///     let creepage = Creepage { longitudinal: f64::from(percent) / 100.0, lateral: 0.0, spin: 0.0 };
    ///     assert_eq!(disc.solve(&creepage), solve(&contact, &creepage, &Options::default()));
    /// }
    /// # Ok::<(), kstrip::status::Error>(())
    /// ```
    pub fn new(contact: &Contact<F>, options: &Options) -> Result<Self, Error> {
        contact.check()?;
        let frame = Frame::of(contact);
        let known = match options.model {
            Model::Strip1967 => Known::Strip1967(Theory::of_contact(&frame, options)),
            Model::Strip1967Continuous => {
                Known::Strip1967Continuous(Theory::of_contact(&frame, options))
            }
            Model::Strip => Known::Strip(Theory::of_contact(&frame, options)),
            Model::Total => Known::Total(Theory::of_contact(&frame, options)),
            Model::Linear => Known::Linear(Theory::of_contact(&frame, options)),
        };
        Ok(Self { frame, options: *options, known })
    }

    /// [`solve`](crate::solve::model::solve) for this contact: the same result, to the bit.
    ///
    /// # Errors
    /// Those of [`solve`](crate::solve::model::solve).
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
            Known::Strip1967(theory) => theory.answer(frame, creepage, ordinary),
            Known::Strip1967Continuous(theory) => theory.answer(frame, creepage, ordinary),
            Known::Strip(strips) => strips.answer(frame, creepage, ordinary),
            Known::Total(total) => total.answer(frame, creepage, ordinary),
            Known::Linear(linear) => linear.answer(frame, creepage, ordinary),
        })
    }
}
