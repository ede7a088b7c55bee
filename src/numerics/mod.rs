//! Numerical methods that several folders use: the cubic through two values and two slopes, the
//! parabola that fits weighted points best, and the bracket that guards a root search.

pub mod bracket;
pub mod hermite;
pub mod parabola;

pub use self::bracket::Bracket;
pub use self::hermite::Cubic;
