//! Numerical methods that several folders use: the cubic through two values and two slopes, the
//! parabola that fits weighted points best, the bracket that guards a root search, and ramps.

pub mod bracket;
pub mod hermite;
pub mod parabola;

pub use self::bracket::Bracket;
pub use self::hermite::Cubic;

use crate::number::{Arithmetic, Number};

/// `t² (3 − 2 t)`, which rises smoothly from 0 to 1 between `t = 0` and `t = 1`.
#[inline]
pub(crate) fn smooth_step<T: Arithmetic>(t: T) -> T {
    t.squared() * (T::constant(3.0) - t.times(2.0))
}

/// 0 up to one number, 1 from another on, and linear between them.
#[inline]
pub(crate) fn ramp<T: Number>(x: T, [from, to]: [f64; 2]) -> T {
    x.plus(-from).times(1.0 / (to - from)).clamped(T::zero(), T::one())
}
