//! Numerical methods that several folders use: the cubic through two values and two slopes, the
//! parabola that fits weighted points best, and the bracket that guards a root search.

pub mod bracket;
pub mod hermite;
pub mod parabola;

pub use self::bracket::Bracket;
pub use self::hermite::Cubic;

use crate::number::Arithmetic;

/// `t² (3 − 2 t)`, which rises smoothly from 0 to 1 between `t = 0` and `t = 1`.
#[inline]
pub(crate) fn smooth_step<T: Arithmetic>(t: T) -> T {
    t.squared() * (T::constant(3.0) - t.times(2.0))
}
