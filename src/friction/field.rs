//! Pressure, traction and slip at points of a contact under a law of friction.
//!
//! The contact has the friction that agrees with the slip and the stiffness of the law. Behind a
//! layer points are those between half-spaces and bristles (`friction::behind`).

use super::behind::StripBehind;
use super::{InMotion, SlipFriction};
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::forces::field::{Field, FieldPoint, FieldStrip};
use crate::forces::options::Options;
use crate::layer::bristles::Rates;
use crate::layer::{Layer, Split};
use crate::number::Float;
use crate::status::{Error, Warning};

/// The field of a contact under a law, ready to be evaluated at points.
#[derive(Clone, Copy, Debug)]
pub struct LawField<F: Float> {
    contact: Contact<F>,
    half_spaces: Field<F>,
    behind: Option<Behind<F>>,
    /// The warning of the solution, if there is one.
    pub warning: Warning,
}

/// What lies between the bodies.
#[derive(Clone, Copy, Debug)]
struct Behind<F> {
    layer: Layer<F>,
    split: Split<F>,
    /// The creepage of both, and that of the half-spaces.
    whole: Creepage<F>,
    seen: Creepage<F>,
    /// Whether there are bristles, or a slide factor only.
    has_bristles: bool,
}

/// A strip of a [`LawField`].
#[derive(Clone, Copy, Debug)]
pub struct LawStrip<F: Float> {
    half_spaces: Option<FieldStrip<F>>,
    /// Half length divided by that of the contact.
    c: F,
    behind: Option<StripBehind<F>>,
}

impl<F: Float> LawField<F> {
    /// Prepare the field of a contact and a creepage, under a law unless it is `None`.
    ///
    /// # Errors
    /// Those of [`Field::new`] and [`SlipFriction::check`].
    pub fn new(
        contact: &Contact<F>,
        creepage: &Creepage<F>,
        law: Option<&SlipFriction<F>>,
        options: &Options,
    ) -> Result<Self, Error> {
        let motion = InMotion { creepage, law, options };
        motion.check(contact)?;
        let (contact, of_friction) = motion.with_friction(contact)?;
        let half_spaces = Field::new(&contact, creepage, options)?;
        let warning = half_spaces.warning.worse(of_friction);
        let clean = Self { contact, half_spaces, behind: None, warning };
        let Some(through) = motion.behind_layer().filter(|_| !contact.is_lost()) else {
            return Ok(clean);
        };
        let (layer, split, whole, has_bristles) = through.split_of(&contact);
        let like = Contact { mismatch: F::zero(), ..contact };
        let seen = split.half_spaces(&whole);
        let half_spaces = Field::new(&like, &seen, options)?;
        let behind = Some(Behind { layer, split, whole, seen, has_bristles });
        Ok(Self { behind, half_spaces, ..clean })
    }

    /// The strip through `y` \[m\].
    #[must_use]
    pub fn strip_at(&self, y: F) -> LawStrip<F> {
        let half_spaces = self.half_spaces.strip_at(y);
        let place = y / self.contact.b;
        let c = ((F::one() - place) * (F::one() + place)).max(F::zero()).sqrt();
        let behind = self.behind.as_ref().filter(|_| half_spaces.is_some());
        let behind = behind.map(|behind| {
            let Behind { layer, split, whole, seen, has_bristles } = behind;
            let rigid = |of: &Creepage<F>| Rates {
                x: of.longitudinal - of.spin * y,
                y: of.lateral,
                spin: of.spin * (c * self.contact.a),
            };
            StripBehind {
                rigid: rigid(whole),
                half_spaces: rigid(seen),
                bristles: has_bristles.then(|| layer.rates_at(split.rates, place, c)),
                weight: split.weight,
            }
        });
        LawStrip { half_spaces, c, behind }
    }

    /// The state at `x` \[m\] of a strip.
    #[must_use]
    pub fn along(&self, strip: &LawStrip<F>, x: F) -> FieldPoint<F> {
        let point = self.half_spaces.point_along(strip.half_spaces.as_ref(), x);
        let point = strip.behind.as_ref().map_or(point, |behind| {
            let units = [strip.c, self.contact.slip_scale()];
            behind.mean(&point, x / (self.contact.a * strip.c), units)
        });
        FieldPoint::new(&self.contact, &point)
    }
}
