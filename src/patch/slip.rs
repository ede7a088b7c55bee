//! The motion of a patch, and the forces of a strip.

use crate::contact::creepage::Creepage;
use crate::number::{Float, Number};
use crate::patch::PatchStrip;
use crate::strip::StripForces;

/// Forces of a strip.
#[derive(Clone, Copy, Debug)]
pub(super) struct Share<T: Number> {
    pub fx: T,
    pub fy: T,
    /// Moment about the origin of the patch.
    pub mz: T,
    /// Power of the force on the creepage that pressure adds.
    pub of_pressure: T,
    /// Share of its length in adhesion, at the leading edge.
    pub stick: T::Base,
    pub adheres: bool,
}

impl<T: Number<Base: Float>> Share<T> {
    /// The forces of a strip, from its forces divided by the friction bound and its moment about
    /// its centre in half lengths.
    pub fn new(
        strip: &PatchStrip<T::Base>,
        carried: &StripForces<T>,
        stick: T::Base,
        adheres: bool,
    ) -> Self {
        let bound = strip.friction_bound();
        let StripForces { fx, fy, mx, .. } = *carried;
        let (fx, fy) = (fx.scale(bound), fy.scale(bound));
        // Mz = ∫ (x Y − y X)
        let mz = mx.scale(bound * strip.half_length) + fy.scale(strip.centre_x) - fx.scale(strip.y);
        Self { fx, fy, mz, of_pressure: T::zero(), stick, adheres }
    }
}

/// The motion of a patch: the creepage at its origin, and the factor of the creepage that pressure
/// adds in unlike bodies, which is one.
#[derive(Clone, Copy, Debug)]
pub(super) struct PatchSlip<T> {
    pub creepage: Creepage<T>,
    pub pressure: T,
}

impl<F: Float> PatchSlip<F> {
    pub fn new(creepage: &Creepage<F>) -> Self {
        Self { creepage: *creepage, pressure: F::one() }
    }
}

/// Rigid slip at the point `(x, y)` as creepage of a contact there: `(υx − φ y, υy + φ x, φ)`.
pub(super) fn creepage_at<T: Number>(
    creepage: &Creepage<T>,
    x: T::Base,
    y: T::Base,
) -> Creepage<T> {
    let Creepage { longitudinal, lateral, spin } = *creepage;
    Creepage { longitudinal: longitudinal - spin.scale(y), lateral: lateral + spin.scale(x), spin }
}

/// Upper bound of the rigid slip of all points within reach.
pub(super) fn rigid_slip<F: Float>(creepage: &Creepage<F>, reach: F) -> F {
    creepage.longitudinal.abs() + creepage.lateral.abs() + creepage.spin.abs() * reach
}
