//! What every model answers, in units of the friction bound, and how many strips share it.

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
    /// Share of the contact area in adhesion, 0 to 1; −1 where a model does not know it.
    pub stick: T,
}

impl<T: Number> Totals<T> {
    /// Nothing is carried, everything slides.
    #[must_use]
    pub fn nothing() -> Self {
        Self { fx: T::zero(), fy: T::zero(), mz: T::zero(), stick: T::zero() }
    }
}

/// How many strips share the patch.
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
    /// The count for a number, if it is one of the fixed counts.
    #[must_use]
    pub const fn from_number(number: i32) -> Option<Self> {
        Some(match number {
            4 => Self::Four,
            8 => Self::Eight,
            16 => Self::Sixteen,
            32 => Self::ThirtyTwo,
            64 => Self::SixtyFour,
            _ => return None,
        })
    }
}
