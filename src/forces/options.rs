//! Options, the model and the number of strips, and results.

use crate::contact::totals::StripCount;
use crate::number::Float;
use crate::status::Warning;

/// The traction law.
///
/// The number of each variant is its constant in the C interface; numbers are never reused.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(i32)]
#[non_exhaustive]
pub enum Model {
    /// The theory of 1967 itself, nothing fitted, with the sliding rule that the paper keeps for
    /// forces.
    Strip1967 = 1,
    /// The theory of 1967 with the sliding rule that joins the adhesion strips without a jump.
    Strip1967Continuous = 2,
    /// A strip theory in Kalker's sense: the half-ellipses of 1967 in adhesion, slip along the
    /// local rigid slip, flexibilities corrected by a small network fitted to CONTACT. Any spin:
    /// forces, moment, stick area and fields; the power is never negative.
    #[default]
    Strip = 3,
    /// A closed formula with a small network fitted to CONTACT. It computes total forces and moment
    /// only. No other model here is as accurate for its cost. The power
    /// is never negative.
    Total = 4,
    /// The linear theory, without saturation, for stability analysis.
    Linear = 5,
}

impl Model {
    /// Whether the library was built with the theory of 1967 (feature `strip-1967`).
    pub const HAS_STRIP_1967: bool = cfg!(feature = "strip-1967");
    /// Whether the library was built with [`Model::Strip`] (feature `strip`).
    pub const HAS_STRIP: bool = cfg!(feature = "strip");
    /// Whether the library was built with [`Model::Total`] (feature `total`).
    pub const HAS_TOTAL: bool = cfg!(feature = "total");
    /// Whether the library was built with [`Model::Linear`] (feature `linear`).
    pub const HAS_LINEAR: bool = cfg!(feature = "linear");

    /// The model for a number; `None` if there is no such model, or if the library was built
    /// without it.
    #[must_use]
    pub const fn from_number(number: i32) -> Option<Self> {
        Some(match number {
            1 if Self::HAS_STRIP_1967 => Self::Strip1967,
            2 if Self::HAS_STRIP_1967 => Self::Strip1967Continuous,
            3 if Self::HAS_STRIP => Self::Strip,
            4 if Self::HAS_TOTAL => Self::Total,
            5 if Self::HAS_LINEAR => Self::Linear,
            _ => return None,
        })
    }

    /// Whether a number is that of a model, which the library may have been built without.
    #[must_use]
    pub const fn is_number(number: i32) -> bool {
        matches!(number, 1..=5)
    }

    /// Whether the model has no fitted constants, and neglects dissimilar materials as the paper
    /// does.
    #[must_use]
    pub const fn is_of_1967(self) -> bool {
        matches!(self, Self::Strip1967 | Self::Strip1967Continuous)
    }

    /// Every model.
    pub const ALL: [Self; 5] =
        [Self::Strip1967, Self::Strip1967Continuous, Self::Strip, Self::Total, Self::Linear];
}

/// The model and the number of strips.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// The traction law.
    pub model: Model,
    /// Number of strips of the patch; ignored by models without strips.
    pub strips: StripCount,
}

/// Forces on the lower body.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Solution<F> {
    /// Longitudinal force \[N\], positive along the rolling direction.
    pub fx: F,
    /// Lateral force \[N\].
    pub fy: F,
    /// Moment about z at the centre of the contact \[N m\].
    pub mz: F,
    /// Frictional power divided by rolling speed, fx longitudinal + fy lateral + mz spin \[N\]:
    /// energy dissipated per metre rolled. For dissimilar bodies the creepage that pressure makes
    /// is added to the longitudinal one.
    pub power: F,
    /// Share of the contact area in adhesion \[-\], 0 to 1. It is -1 with KSTRIP_MODEL_TOTAL, which
    /// does not compute it, and 1 with KSTRIP_MODEL_LINEAR, which has adhesion everywhere.
    pub adhesion: F,
    /// The status of this result: 0 or one of the KSTRIP_WARNING constants.
    pub warning: Warning,
    /// Reserved: zero.
    pub reserved: i32,
}

impl<F: Float> Solution<F> {
    /// `fx, fy, mz`
    pub(crate) fn components(&self) -> [F; 3] {
        [self.fx, self.fy, self.mz]
    }
}
