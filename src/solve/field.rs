//! Pressure, traction and slip at points of the contact, in SI units.

use crate::contact::Contact;
use crate::number::Float;
use crate::strip_1967::strip::{State, StripPoint};

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
    /// Slip of the upper over the lower body along x, over the rolling speed \[-\].
    pub slip_x: F,
    /// Slip along y, over the rolling speed \[-\].
    pub slip_y: F,
    /// Traction times slip \[Pa\]: energy dissipated per area and metre rolled.
    pub dissipation: F,
    /// One of the KSTRIP_STATE constants.
    pub state: State,
    /// Zero.
    pub reserved: i32,
}

impl<F: Float> FieldPoint<F> {
    /// From the dimensionless point of a strip.
    #[must_use]
    pub fn new(contact: &Contact<F>, point: &StripPoint<F>) -> Self {
        if contact.is_lost() {
            let zero = F::zero();
            return Self::in_units(zero, zero, zero, point);
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
