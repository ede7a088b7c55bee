//! The measured points of a creep curve.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::forces::Options;
use crate::friction::{InMotion, SlipFriction};
use crate::number::{Float, are_finite};
use crate::status::Error;

/// One measured point of a creep curve.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredForce<F> {
    /// Longitudinal creepage \[-\].
    pub longitudinal: F,
    /// Lateral creepage \[-\].
    pub lateral: F,
    /// Spin \[1/m\].
    pub spin: F,
    /// Longitudinal force on the lower body \[N\]; ignored unless it was measured.
    pub fx: F,
    /// Lateral force on the lower body \[N\]; ignored unless it was measured.
    pub fy: F,
    /// Weight of the squared error of a force, >= 0, else KSTRIP_ERROR_WEIGHT. It is 1 for points
    /// of equal accuracy, 1/error^2 otherwise; 0: the point does not count.
    pub weight: F,
    /// KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY, or both added; else KSTRIP_ERROR_MEASURED.
    pub measured: u32,
    /// Reserved: zero.
    pub reserved: u32,
}

impl<F: Float> MeasuredForce<F> {
    pub(super) fn creepage(&self) -> Creepage<F> {
        let Self { longitudinal, lateral, spin, .. } = *self;
        Creepage { longitudinal, lateral, spin }
    }

    /// The forces that were measured.
    pub(super) fn measured_forces(&self) -> [Option<F>; 2] {
        [(1, self.fx), (2, self.fy)].map(|(bit, force)| (self.measured & bit != 0).then_some(force))
    }

    fn check(&self) -> Result<(), Error> {
        let Self { longitudinal, lateral, spin, weight, .. } = *self;
        Error::NotFinite.unless(are_finite(&[longitudinal, lateral, spin, weight]))?;
        let forces = self.measured_forces();
        let finite = forces.iter().flatten().all(|force| force.is_finite_number());
        Error::NotFinite.unless(finite)?;
        Error::Measured.unless(self.measured >= 1 && self.measured <= 3)?;
        Error::Weight.unless(weight >= F::zero())
    }
}

/// What the measured forces have in common.
pub(super) struct MeasuredSums<F> {
    /// How many forces count, the sum of their weights, and that of their weighted squares over
    /// `N²`.
    pub count: usize,
    pub weights: F,
    pub squares: F,
    /// The largest force divided by the load.
    pub used: F,
    /// The fastest slip over the rolling speed.
    pub fastest: F,
}

impl<F: Float> MeasuredSums<F> {
    /// # Errors
    /// Those of the first bad point, with its number.
    pub fn at_points(
        contact: &Contact<F>, points: &[MeasuredForce<F>], start: &SlipFriction<F>,
        options: &Options,
    ) -> Result<Self, (usize, Error)> {
        let zero = F::zero();
        let mut all = Self { count: 0, weights: zero, squares: zero, used: zero, fastest: zero };
        for (i, point) in points.iter().enumerate() {
            point.check().map_err(|error| (i, error))?;
            let creepage = point.creepage();
            let motion = InMotion { creepage: &creepage, law: Some(start), options };
            motion.check(contact).map_err(|error| (i, error))?;
            for force in point.measured_forces().into_iter().flatten() {
                if point.weight > zero {
                    all.count += 1;
                    all.weights += point.weight;
                    let over = force / contact.normal_force;
                    all.squares += point.weight * over * over;
                    all.used = all.used.max(over.abs());
                    all.fastest = all.fastest.max(contact.fastest_slip(&creepage));
                }
            }
        }
        Ok(all)
    }
}
