//! Directions in which the points of a profile move.

use core::fmt::{Debug, Formatter, Result};

/// Number of directions.
pub(crate) const DIRECTIONS: usize = 4;
/// Number of directions of the derivatives that numbers carry at once: on a microcontroller and in
/// a browser one, which takes the least memory and code.
pub(crate) const TOGETHER: usize =
    if cfg!(any(target_os = "none", target_family = "wasm")) { 1 } else { DIRECTIONS };

/// How points move.
pub(crate) trait Moves<F> {
    /// Derivatives of place, distance, centre along `x` and rolling radius of a point.
    fn moves_of_point(&self, k: usize) -> [[F; TOGETHER]; 4];
}

// (derived, it would be part of every table of methods, with what can panic in it)
impl<F> Debug for dyn Moves<F> + '_ {
    fn fmt(&self, to: &mut Formatter<'_>) -> Result {
        to.write_str("Moves")
    }
}
