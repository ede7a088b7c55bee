//! Forces of a contact and of one of its strips in units of the friction bound, and the number of
//! strips.

use crate::number::Number;

/// Force and moment of a contact on the lower body, and its stick area, dimensionless.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Totals<T> {
    /// `F_x/(μ N)`
    pub fx: T,
    /// `F_y/(μ N)`
    pub fy: T,
    /// `M_z/(μ N √(ab))`, about the centre
    pub mz: T,
    /// Share of the contact area in adhesion, 0 to 1; −1 for a model that does not compute it.
    pub stick: T,
}

impl<T: Number> Totals<T> {
    /// No forces; the whole contact slides.
    #[must_use]
    pub fn nothing() -> Self {
        Self { fx: T::zero(), fy: T::zero(), mz: T::zero(), stick: T::zero() }
    }
}

/// Forces of a strip, divided by its friction bound.
#[derive(Clone, Copy, Debug)]
pub struct StripForces<T> {
    /// Longitudinal force.
    pub fx: T,
    /// Lateral force.
    pub fy: T,
    /// `∫ x̂ Y dx̂`: moment of the lateral traction in half lengths.
    pub mx: T,
    /// Share of the length in adhesion.
    pub stick: T,
}

/// Number of strips of the patch.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[repr(i32)]
pub enum StripCount {
    /// 4 strips: shape of the creep curve only.
    Four = 4,
    /// 8 strips.
    Eight = 8,
    /// 16 strips: the recommended count.
    #[default]
    Sixteen = 16,
    /// 32 strips.
    ThirtyTwo = 32,
    /// 64 strips: reference quality.
    SixtyFour = 64,
}

impl StripCount {
    /// Every strip count.
    pub const ALL: [Self; 5] =
        [Self::Four, Self::Eight, Self::Sixteen, Self::ThirtyTwo, Self::SixtyFour];

    /// The strip count for a number; `None` if it is not one of these counts.
    #[must_use]
    pub const fn from_number(number: i32) -> Option<Self> {
        match number {
            4 => Some(Self::Four),
            8 => Some(Self::Eight),
            16 => Some(Self::Sixteen),
            32 => Some(Self::ThirtyTwo),
            64 => Some(Self::SixtyFour),
            _ => None,
        }
    }
}
