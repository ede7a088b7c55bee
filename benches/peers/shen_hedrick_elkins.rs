//! Shen, Hedrick and Elkins: the cubic saturation of Vermeulen and Johnson applied to the force of
//! Kalker's linear theory, spin included.
//!
//! Source: Z. Y. Shen, J. K. Hedrick, J. A. Elkins, *A comparison of alternative creep force models
//! for rail vehicle dynamic analysis*, Proc. 8th IAVSD Symposium, Cambridge, Mass., 1983, 591-605.
//! The paper gives no spin moment.

use super::{Input, Output};

/// Creep force.
#[inline]
pub fn solve(input: &Input) -> Output {
    let (lx, ly, ls) = input.linear();
    let (x, y) = (lx, ly + ls);
    let r = (x * x + y * y).sqrt();
    // |F|/(µN) = R − R²/3 + R³/27 for R ≤ 3, else 1; as a factor on the linear force
    let f = if r < 3.0 { 1.0 - r * (1.0 / 3.0 - r * (1.0 / 27.0)) } else { 1.0 / r };
    Output { fx: f * x, fy: f * y, mz: f64::NAN }
}
