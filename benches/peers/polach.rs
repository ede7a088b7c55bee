//! Polach: closed form with spin.
//!
//! Source: O. Polach, *A fast wheel-rail forces calculation computer code*, Vehicle System Dynamics
//! 33 (Suppl., 1999) 728-739; the form without spin is kept in his 2005 paper (Wear 258, 992-1000),
//! whose reduction factors for adhesion and slip are 1 for dry, clean contact and are left out
//! here. The paper gives no moment, and its force is on the other body (opposite sign).

use super::{Input, Output};
use core::f64::consts::{FRAC_2_PI, PI};

/// `1 + 6.3 (1 − e^{−a/b})`, Polach's fit of the spin force for the shape of the ellipse.
/// Depends on the ellipse only, so a caller may keep it.
#[inline]
pub fn shape(input: &Input) -> f64 {
    1.0 + 6.3 * (1.0 - (-input.a / input.b).exp())
}

/// Creep force.
#[inline]
pub fn solve(input: &Input) -> Output {
    solve_with_shape(input, shape(input))
}

/// Creep force, with [`shape`] computed beforehand.
#[inline]
pub fn solve_with_shape(input: &Input, shape: f64) -> Output {
    let &Input { a, b, longitudinal: sx, lateral: sy, spin, .. } = input;
    // s_yC = s_y + ω a where |s_y + ω a| > |s_y|, else s_y
    let sum = sy + spin * a;
    let syc = if sum.abs() > sy.abs() { sum } else { sy };
    // s_C = √(s_x² + s_yC²)
    let sc = (sx * sx + syc * syc).sqrt();
    if sc == 0.0 {
        return Output { fx: 0.0, fy: 0.0, mz: f64::NAN };
    }
    let stiffness = input.shear_modulus * a * b / input.bound();
    // c_jj = √((c11 s_x/s)² + (c22 s_y/s)²)
    let s2 = sx * sx + sy * sy;
    let cjj = if s2 > 0.0 {
        (((input.c11 * sx).powi(2) + (input.c22 * sy).powi(2)) / s2).sqrt()
    } else {
        0.0
    };
    // ε = (π/4) G ab c_jj s_C/(Q µ),  F/(Q µ) = (2/π)(ε/(1 + ε²) + atan ε)
    let e = 0.25 * PI * stiffness * cjj * sc;
    let f = FRAC_2_PI * (e / (1.0 + e * e) + e.atan());
    let mut fy = f * sy / sc;
    if spin != 0.0 {
        // ε_S = (8/3) G b √(ab) c23 |s_yC|/(Q µ (1 + 6.3(1 − e^{−a/b})))
        let es = 8.0 / 3.0 * stiffness * (b / a).sqrt() * input.c23 * syc.abs() / shape;
        // δ = (ε_S² − 1)/(ε_S² + 1)
        let d = (es * es - 1.0) / (es * es + 1.0);
        let q = 1.0 - d * d;
        // −K_M = ε_S (−δ³/3 + δ²/2 − 1/6) + ⅓ (1 − δ²)^{3/2}
        let km = es * (d * d * (0.5 - d * (1.0 / 3.0)) - 1.0 / 6.0) + q * q.sqrt() * (1.0 / 3.0);
        // F_yS/(Q µ) = (9/16) a K_M (1 + 6.3(1 − e^{−a/b})), added as F_yS ω/s_C
        fy += 0.5625 * a * km * shape * spin / sc;
    }
    Output { fx: f * sx / sc, fy, mz: f64::NAN }
}
