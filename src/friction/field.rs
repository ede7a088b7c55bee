//! Pressure, traction and slip at points of a contact under a law of friction.
//!
//! The contact has the friction that agrees with the slip and the stiffness of the law. Behind a
//! layer traction and dissipation are the means of those of half-spaces and bristles, weighted as
//! their forces are, so that dissipation adds up to the power. The slip is the mean of theirs, with
//! what it lacks for that dissipation added along the traction:
//!
//! ```text
//! t = (1 − w) t_h + w t_b,   D = (1 − w) t_h·s_h + w t_b·s_b
//! m = (1 − w) s_h + w s_b,   s = m + t (D − t·m)/|t|²,   t·s = D
//! ```
//!
//! Half-spaces slip by that share of the rigid slip which they have at their own creepages, and
//! bristles likewise.

use super::layered::Behind;
use super::{InMotion, SlipFriction};
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::forces::field::{Field, FieldPoint, FieldStrip};
use crate::forces::options::Options;
use crate::layer::bristles::Rates;
use crate::number::{Float, between, length};
use crate::status::{Error, Warning};
use crate::strip_1967::strip::{State, StripPoint};

/// The field of a contact under a law, ready to be evaluated at points.
#[derive(Clone, Copy, Debug)]
pub struct LawField<F: Float> {
    contact: Contact<F>,
    half_spaces: Field<F>,
    behind: Option<Behind<F>>,
    /// The warning of the solution, if there is one.
    pub warning: Warning,
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
        contact: &Contact<F>, creepage: &Creepage<F>, law: Option<&SlipFriction<F>>,
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
        let behind = through.behind(&contact);
        let like = Contact { mismatch: F::zero(), ..contact };
        let half_spaces = Field::new(&like, &behind.half_spaces(), options)?;
        Ok(Self { behind: Some(behind), half_spaces, ..clean })
    }

    /// The strip through `y` \[m\].
    #[must_use]
    pub fn strip_at(&self, y: F) -> LawStrip<F> {
        let half_spaces = self.half_spaces.strip_at(y);
        let place = y / self.contact.b;
        let c = ((F::one() - place) * (F::one() + place)).max(F::zero()).sqrt();
        let behind = self.behind.as_ref().filter(|_| half_spaces.is_some());
        let behind = behind.map(|behind| {
            let Behind { layer, split, whole, has_bristles } = behind;
            let rigid = |of: &Creepage<F>| Rates {
                x: of.longitudinal - of.spin * y,
                y: of.lateral,
                spin: of.spin * (c * self.contact.a),
            };
            StripBehind {
                rigid: rigid(whole),
                half_spaces: rigid(&behind.half_spaces()),
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

/// The rigid slip of a strip, and what half-spaces and bristles have of it: at `x` half lengths
/// from the centre `(x, y + spin x)`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StripBehind<F> {
    pub rigid: Rates<F>,
    /// That of the half-spaces.
    pub half_spaces: Rates<F>,
    /// Bristles, unless there is no layer, in their own units.
    pub bristles: Option<Rates<F>>,
    /// Weight of the bristles.
    pub weight: F,
}

impl<F: Float> StripBehind<F> {
    /// The mean at `place` \[half lengths\]. Tractions count in units of which the strip has
    /// `bound` at its peak, slip in `unit`, at most [`Number::HUGE`](crate::number::Number::HUGE).
    pub fn mean(&self, point: &StripPoint<F>, place: F, [bound, unit]: [F; 2]) -> StripPoint<F> {
        if point.state == State::Outside {
            return *point;
        }
        let rigid = self.rigid.size_at(place);
        let of = |slip: [F; 2], stretch: F| {
            let stretch = stretch.min(F::LARGEST);
            slip.map(|slip| (slip * stretch).clamped(-F::HUGE, F::HUGE))
        };
        let stretch = rigid / (self.half_spaces.size_at(place) + F::TINY);
        let [slip_x, slip_y] = of([point.slip_x, point.slip_y], stretch);
        let of_half_spaces = StripPoint { slip_x, slip_y, ..*point };
        let Some(bristles) = &self.bristles else { return of_half_spaces };
        let found = bristles.at(place);
        let stretch = rigid / (bristles.size_at(place) + F::TINY) / (unit + F::TINY);
        let [traction_x, traction_y] = found.traction.map(|traction| traction * bound);
        let [slip_x, slip_y] = of(found.slip, stretch);
        let of_bristles = StripPoint { traction_x, traction_y, slip_x, slip_y, ..*point };
        self.between(&of_half_spaces, &of_bristles, found.slides)
    }

    fn between(
        &self, half: &StripPoint<F>, bristles: &StripPoint<F>, slides: bool,
    ) -> StripPoint<F> {
        let numbers = |of: &StripPoint<F>| {
            [of.traction_x, of.traction_y, of.slip_x, of.slip_y, of.dissipation()]
        };
        let [x, y, slip_x, slip_y, dissipation] =
            between(numbers(half), numbers(bristles), self.weight);
        let size = length(x, y) + F::TINY;
        let (along_x, along_y) = (x / size, y / size);
        let [of_half, of_bristles] =
            [half, bristles].map(|point| length(point.slip_x, point.slip_y));
        // Where their tractions cancel no slip is large enough.
        let fastest = of_half.max(of_bristles);
        let lacking = dissipation / size - (along_x * slip_x + along_y * slip_y);
        let lacking = lacking.clamped(-fastest, fastest);
        let state = if slides && half.state == State::Stick { State::Slip } else { half.state };
        StripPoint {
            pressure: half.pressure,
            traction_x: x,
            traction_y: y,
            slip_x: slip_x + along_x * lacking,
            slip_y: slip_y + along_y * lacking,
            state,
        }
    }
}
