//! Deflection of a half-space under a strip of half-elliptic pressure.
//!
//! A strip of half length `a` carries `p √(1 − (x/a)²)`. Over its own width it acts at the distance `d` on the line `x = 0` of
//! another strip, by Boussinesq's `u = ∫∫ p/(π E* r) dA`. Both what it deflects there and how much it curves that deflection
//! along `x` are differences of one odd function of `t = d/a`, taken at the strip's two edges:
//!
//! ```text
//! π E* u      = p a [A(t)],    A(t) = ∫ √(1 − ξ²) arsinh(t/|ξ|) dξ,   −1 < ξ < 1
//! −π E* ∂²u/∂x² = (p/a) [C(t)],  C(t) = 2 k K(k'),   k = t/√(1 + t²),  k' = 1/√(1 + t²)
//! ```
//!
//! `A` grows like `(π/2) ln t`, `C` tends to `π`: of an infinitely wide strip the curvature is the plane problem's
//! `2 p/(a E*)`.

use crate::number::Real;

/// `A/k` in powers of `k²`, their products with `ln k²`, and the products of powers of `k'²` with `−ln k'²`: fitted to
/// the integral, relative error 2.1e-5 for every `t`.
const DEFLECTION: ([f64; 4], [f64; 3], [f64; 2]) = (
    [2.77251183, -0.49200352, 0.45801576, 0.22478577],
    [-1.00000504, -0.58883635, -0.41972511],
    [0.78537349, 0.36341111],
);
/// `C/k` in powers of `k²` and their products with `ln k²`: fitted to `2 K`, relative error 1.1e-5.
const CURVATURE: ([f64; 3], [f64; 3]) =
    ([2.77272009, 0.23162634, 0.13724359], [-0.99999129, -0.2395979, -0.05245207]);

/// `A(t)` and `C(t)` of a positive `t`.
pub(crate) fn edge<T: Real>(t: T) -> [T; 2] {
    let square = t * t;
    let rest = square.plus(1.0).inverse();
    // k² and k'²
    let m = (square * rest).max(T::tiny());
    let (log, log_rest) = (m.ln(), rest.max(T::tiny()).ln());
    let (plain, with_log, at_infinity) = DEFLECTION;
    let far = polynomial(rest, &at_infinity) * log_rest;
    let deflection = polynomial(m, &plain) + polynomial(m, &with_log) * log - far;
    let (plain, with_log) = CURVATURE;
    let curvature = polynomial(m, &plain) + polynomial(m, &with_log) * log;
    let k = m.sqrt();
    [k * deflection, k * curvature]
}

fn polynomial<T: Real>(x: T, coefficients: &[f64]) -> T {
    coefficients.iter().rev().fold(T::zero(), |sum, coefficient| (sum * x).plus(*coefficient))
}
