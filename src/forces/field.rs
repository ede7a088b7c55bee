//! Pressure, traction and slip at points of the contact, in SI units.

use crate::contact::Contact;
use crate::contact::creepage::{Creepage, Parameters};
use crate::forces::check::check;
use crate::forces::options::{Model, Options};
use crate::forces::theory::{ScaledContact, sliding_rule};
use crate::forces::warning::warning_of;
use crate::number::Float;
use crate::status::{Error, Warning};
use crate::strip::{Distribution, Flexibilities, StripGeometry};
use crate::strip_1967::strip::{SlidingRule, State, Strip, StripPoint};

/// The state of a point of the contact plane. Tractions act on the lower body.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldPoint<F> {
    /// Pressure \[Pa\].
    pub pressure: F,
    /// Tangential traction along x \[Pa\].
    pub traction_x: F,
    /// Tangential traction along y \[Pa\].
    pub traction_y: F,
    /// Slip of the upper relative to the lower body along x, divided by the rolling speed \[-\].
    pub slip_x: F,
    /// Slip along y, divided by the rolling speed \[-\].
    pub slip_y: F,
    /// Traction times slip \[Pa\]: energy dissipated per area and metre rolled.
    pub dissipation: F,
    /// One of the KSTRIP_STATE constants.
    pub state: State,
    /// Reserved: zero.
    pub reserved: i32,
}

impl<F: Float> FieldPoint<F> {
    /// From the dimensionless point of a strip.
    #[must_use]
    pub fn new(contact: &Contact<F>, point: &StripPoint<F>) -> Self {
        if contact.is_lost() {
            return Self::in_units(F::zero(), F::zero(), F::zero(), point);
        }
        let p0 = contact.peak_pressure();
        Self::in_units(p0, contact.friction * p0, contact.slip_scale(), point)
    }

    /// From a point in units of pressure, traction and slip.
    pub(crate) fn in_units(p0: F, traction: F, slip: F, point: &StripPoint<F>) -> Self {
        let (traction_x, traction_y) = (traction * point.traction_x, traction * point.traction_y);
        let (slip_x, slip_y) = (slip * point.slip_x, slip * point.slip_y);
        Self {
            pressure: p0 * point.pressure,
            traction_x,
            traction_y,
            slip_x,
            slip_y,
            dissipation: traction_x * slip_x + traction_y * slip_y,
            state: point.state,
            reserved: 0,
        }
    }
}

/// The traction law of a field.
#[derive(Clone, Copy, Debug)]
enum Tractions<F: Float> {
    Strip1967(Parameters<F>, SlidingRule),
    Strip(Distribution<F>),
}

/// The tangential field of a contact, ready to be evaluated at points.
#[derive(Clone, Copy, Debug)]
pub struct Field<F: Float> {
    contact: Contact<F>,
    law: Tractions<F>,
    /// The warning of the solution, if there is one.
    pub warning: Warning,
}

/// A strip of a [`Field`].
#[derive(Clone, Copy, Debug)]
pub enum FieldStrip<F: Float> {
    /// A strip of the theory of 1967.
    Strip1967(Strip<F>),
    /// A strip of STRIP with the law of its tractions, and its half length `c` in the unit of `x`.
    Strip(Distribution<F>, StripGeometry<F>, F),
}

impl<F: Float> FieldStrip<F> {
    /// A point of the strip in the units of the theory of 1967, in which the pressure at its centre
    /// is its half length.
    pub(crate) fn at(&self, x: F) -> StripPoint<F> {
        let (strips, geometry, c) = match self {
            Self::Strip1967(strip) => return strip.at(x),
            Self::Strip(strips, geometry, c) => (strips, geometry, *c),
        };
        let (ahead, behind) = (c - x, c + x);
        if !(ahead >= F::zero() && behind >= F::zero()) {
            return StripPoint::outside();
        }
        let pressure = (ahead * behind).sqrt();
        let traction = strips.traction(geometry, x / c);
        // Creepages come in units of μ N/(G a b) = (2 μ p₀/G) π/3.
        let unit = F::constant(core::f64::consts::PI / 3.0);
        let point = StripPoint {
            pressure,
            traction_x: pressure * traction.x,
            traction_y: pressure * traction.y,
            slip_x: unit * traction.slip_x,
            slip_y: unit * traction.slip_y,
            state: State::Slip,
        };
        if traction.slips {
            point.classified()
        } else {
            StripPoint { slip_x: F::zero(), slip_y: F::zero(), state: State::Stick, ..point }
        }
    }
}

impl<F: Float> Field<F> {
    /// Prepare the field of a contact and a creepage.
    ///
    /// # Errors
    /// Those of [`solve`](crate::forces::forces_of_contact); [`Error::NotInModel`] for models of
    /// totals only.
    pub fn new(
        contact: &Contact<F>, creepage: &Creepage<F>, options: &Options,
    ) -> Result<Self, Error> {
        check(contact, creepage, options)?;
        let frame = ScaledContact::new(contact);
        let lost = contact.is_lost();
        let creepage =
            &if lost { *creepage } else { frame.creepage_with_pressure(creepage, options.model).0 };
        let parameters = frame.units.parameters(creepage);
        // The dissipation of a point is traction times slip. Slip is of the size of the rigid slip,
        // which the checked parameters bound.
        let rigid = creepage.fastest_within(contact.a + contact.b);
        let slip = rigid.times(8.0).min(contact.slip_unit().min(F::HUGE) * F::HUGE);
        let dissipation = contact.friction * contact.peak_pressure() * slip;
        Error::Overflow.unless(lost || dissipation.is_finite_number())?;
        let law = match options.model {
            Model::Strip1967 | Model::Strip1967Continuous if Model::HAS_STRIP_1967 => {
                Tractions::Strip1967(parameters, sliding_rule(options.model))
            }
            Model::Strip if Model::HAS_STRIP => {
                let (axis_ratio, poisson_ratio, linear) = frame.shape();
                let flexibilities =
                    Flexibilities::new(axis_ratio, poisson_ratio, &linear, [F::one(); 2]);
                Tractions::Strip(flexibilities.see(frame.units.normalised(&parameters)))
            }
            _ => return Err(Error::NotInModel),
        };
        let warning = warning_of(contact, creepage, options.model, parameters.psi);
        Ok(Self { contact: *contact, law, warning })
    }

    /// The strip through `y` \[m\]; `None` outside the contact.
    #[must_use]
    pub fn strip_at(&self, y: F) -> Option<FieldStrip<F>> {
        if self.contact.is_lost() {
            return None;
        }
        let relative = y / self.contact.b;
        let square = (F::one() - relative) * (F::one() + relative);
        if !(square > F::zero()) {
            return None;
        }
        let half_length = square.sqrt();
        Some(match &self.law {
            Tractions::Strip1967(p, rule) => FieldStrip::Strip1967(Strip::solve(
                half_length,
                p.xi - p.spin_slope() * relative,
                p.eta,
                p.psi,
                p.poisson_ratio,
                *rule,
            )),
            Tractions::Strip(law) => {
                let (y, bound, width) = (relative, [half_length; 2], F::zero());
                FieldStrip::Strip(*law, StripGeometry { y, half_length, bound, width }, half_length)
            }
        })
    }

    /// The state at a point of the contact plane (`x`, `y` in metres from the centre).
    #[must_use]
    pub fn at(&self, x: F, y: F) -> FieldPoint<F> {
        self.along(self.strip_at(y).as_ref(), x)
    }

    /// The state at `x` \[m\] of a strip of [`Field::strip_at`].
    #[must_use]
    pub fn along(&self, strip: Option<&FieldStrip<F>>, x: F) -> FieldPoint<F> {
        FieldPoint::new(&self.contact, &self.point_along(strip, x))
    }

    /// The same without dimensions.
    pub(crate) fn point_along(&self, strip: Option<&FieldStrip<F>>, x: F) -> StripPoint<F> {
        strip.map_or_else(StripPoint::outside, |strip| strip.at(x / self.contact.a))
    }
}
