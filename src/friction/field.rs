//! Pressure, traction and slip at points of a contact under a law of friction.
//!
//! The contact has the friction that agrees with the slip and the stiffness of the law. Behind a
//! layer traction and slip are the means of those of half-spaces and of bristles. The half-spaces
//! have the creepages times a factor each, hence their slip has it as well. A bristle that slides
//! keeps the bound `g`:
//!
//! ```text
//! t = n g,   slip = n (s·n − dg/du),   dg/du = x/g
//! ```

use super::layered::ThroughLayer;
use super::{SlipFriction, check_with_law, contact_with_law_checked};
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::forces::field::{Field, FieldPoint, FieldStrip};
use crate::forces::options::Options;
use crate::layer::bristles::Rates;
use crate::layer::{Layer, Split};
use crate::number::Float;
use crate::status::{Error, Warning};
use crate::strip_1967::strip::State;

/// The field of a contact under a law, ready to be evaluated at points.
///
/// Behind a layer the dissipation of a point is the product of two means, so that its sum over the
/// contact differs from the power of the solution, by up to 0.22 of friction times load times rigid
/// slip. The tractions add up to the forces within 0.01 of friction times load.
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
    /// Creepage divided by its rate.
    units: [F; 2],
    /// Whether there are bristles, or a slide factor only.
    has_bristles: bool,
}

/// A strip of a [`LawField`].
#[derive(Clone, Copy, Debug)]
pub struct LawStrip<F: Float> {
    half_spaces: Option<FieldStrip<F>>,
    /// Rates, and half length divided by that of the contact, of its bristles.
    bristles: Option<(Rates<F>, F)>,
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
        let Some(law) = law else {
            let half_spaces = Field::new(contact, creepage, options)?;
            let warning = half_spaces.warning;
            return Ok(Self { contact: *contact, half_spaces, behind: None, warning });
        };
        check_with_law(contact, creepage, law, options)?;
        let (contact, of_friction) = contact_with_law_checked(contact, creepage, law, options)?;
        let whole = Field::new(&contact, creepage, options)?;
        let warning = whole.warning.worse(of_friction);
        let clean = Self { contact, half_spaces: whole, behind: None, warning };
        if !law.has_interface() || contact.is_lost() {
            return Ok(clean);
        }
        let through = ThroughLayer { law, creepage, options };
        let (layer, split, seen, has_bristles) = through.split_of(&contact);
        let like = Contact { mismatch: F::zero(), ..contact };
        let half_spaces = Field::new(&like, &split.half_spaces(&seen), options)?;
        let scale = contact.slip_scale().times(core::f64::consts::PI / 3.0);
        let [x, y, _] = split.bend;
        let units = [scale / x, scale / y];
        Ok(Self {
            behind: Some(Behind { layer, split, units, has_bristles }),
            half_spaces,
            ..clean
        })
    }

    /// The strip through `y` \[m\].
    #[must_use]
    pub fn strip_at(&self, y: F) -> LawStrip<F> {
        let half_spaces = self.half_spaces.strip_at(y);
        let place = y / self.contact.b;
        let c = ((F::one() - place) * (F::one() + place)).max(F::zero()).sqrt();
        let bristles = self.behind.as_ref().filter(|behind| behind.has_bristles);
        let bristles = bristles.filter(|_| half_spaces.is_some());
        let bristles = bristles.map(|of| (of.layer.rates_at(of.split.rates, place, c), c));
        LawStrip { half_spaces, bristles }
    }

    /// The state at `x` \[m\] of a strip.
    #[must_use]
    pub fn along(&self, strip: &LawStrip<F>, x: F) -> FieldPoint<F> {
        let mut point = self.half_spaces.along(strip.half_spaces.as_ref(), x);
        let Some(behind) = self.behind.as_ref().filter(|_| point.state != State::Outside) else {
            return point;
        };
        let [by_x, by_y, _] = behind.split.factors;
        (point.slip_x, point.slip_y) = (point.slip_x / by_x, point.slip_y / by_y);
        if let Some((rates, c)) = &strip.bristles {
            let bound = self.contact.friction * self.contact.peak_pressure() * *c;
            let found = rates.at(x / (self.contact.a * *c));
            let [to_x, to_y] = behind.units;
            let mean = |of: F, bristles: F| of + (bristles - of) * behind.split.weight;
            point.traction_x = mean(point.traction_x, found.traction[0] * bound);
            point.traction_y = mean(point.traction_y, found.traction[1] * bound);
            point.slip_x = mean(point.slip_x, found.slip[0] * to_x);
            point.slip_y = mean(point.slip_y, found.slip[1] * to_y);
            if found.slides && point.state == State::Stick {
                point.state = State::Slip;
            }
        }
        point.dissipation = point.traction_x * point.slip_x + point.traction_y * point.slip_y;
        point
    }
}
