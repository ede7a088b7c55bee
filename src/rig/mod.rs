//! The inverse, for test rigs: from a measured force to friction, from a requested force to
//! creepage.
//!
//! **Friction.** By homogeneity (see [`derivatives`](crate::forces::derivatives)) the force at a
//! known creepage depends on `M = μ N` as `F = M f(c/M)`. In full sliding it is `|F| = M`. As `M`
//! grows the contact begins to adhere, and the force tends to that of linear theory, which does not
//! depend on `M`. So `M` lies between `|F|` and, unless the contact sticks, `20 |F|`. Where spin
//! and translation oppose each other the force may fall again and equal the measured one more than
//! once; `search` finds all of these places. The sensitivity to the force, which grows without
//! bound towards adhesion, is part of the result.
//!
//! **Creepage.** Newton's method with exact derivatives is applied to the force that there would be
//! without saturation, which is nearly proportional to the creepage (`creepage`).

pub(crate) mod creepage;
pub mod fit;
pub(crate) mod friction;
mod measured;
mod search;
mod sums;

pub use self::creepage::creepage_for_force;
pub use self::friction::estimate_friction;

use crate::number::{Real, length};
use crate::status::Warning;

/// Which forces were measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measured {
    /// The longitudinal force only.
    Fx,
    /// The lateral force only.
    Fy,
    /// Both: their resultant counts.
    Both,
}

impl Measured {
    /// The part of a force that is measured.
    fn component<F: Real>(self, [fx, fy]: [F; 2]) -> F {
        match self {
            Self::Fx => fx,
            Self::Fy => fy,
            Self::Both => length(fx, fy),
        }
    }
}

/// A coefficient of friction from a measured force.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionEstimate<F> {
    /// Coefficient of friction \[-\]; a lower bound with KSTRIP_WARNING_FRICTION_AT_LEAST.
    pub friction: F,
    /// d(friction)/d(force) \[1/N\]: change of the coefficient for an error of 1 N in the measured
    /// force; 0 for a lower bound.
    pub sensitivity: F,
    /// Distance between the measured and the computed force \[N\] in the components that were
    /// measured. For one component it is rounding; for both it is the part that friction
    /// cannot explain, because the directions of the forces differ.
    pub residual: F,
    /// The status of this result: 0 or one of the KSTRIP_WARNING constants.
    pub warning: Warning,
    /// Reserved: zero.
    pub reserved: i32,
}
