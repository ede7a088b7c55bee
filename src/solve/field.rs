//! Pressure, traction and slip at points of the contact, in SI units.

use crate::contact::Contact;
use crate::number::Float;
use crate::strip_1967::strip::{State, StripPoint};

/// The state of a point of the contact plane. Tractions act on the lower body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldPoint<F> {
    /// Pressure `Z` \[Pa\].
    pub pressure: F,
    /// Traction `X` along the rolling direction \[Pa\].
    pub traction_x: F,
    /// Traction `Y` \[Pa\].
    pub traction_y: F,
    /// Slip `s_x` of the upper over the lower body, relative to the rolling speed \[–\].
    pub slip_x: F,
    /// Slip `s_y` \[–\].
    pub slip_y: F,
    /// `X s_x + Y s_y` \[Pa\]: energy dissipated per area and metre rolled.
    pub dissipation: F,
    /// Outside, stick, slip, or slip against the traction.
    pub state: State,
}

impl<F: Float> FieldPoint<F> {
    /// From the dimensionless point of a strip.
    #[must_use]
    pub fn new(contact: &Contact<F>, point: &StripPoint<F>) -> Self {
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
        }
    }
}
