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
//! `2 p/(a E*)`. Both slopes follow from `S = 2 (K − E)/k'²`: `A' = k' S`, `C' = k'³ S`.

use crate::number::Float;

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

/// `S` in powers of `k²` and their products with `ln k²`, relative error 8e-5.
const SLOPE: ([f64; 3], [f64; 3]) =
    ([0.77346187, 0.29037413, 0.50695056], [-0.99994018, -0.69203219, -0.203429]);

/// What a strip does on one side of its edge.
#[derive(Clone, Copy)]
pub(crate) struct Edge<F> {
    /// `A`
    pub deflection: F,
    /// `C`
    pub curvature: F,
    /// `t A'`
    pub deflection_slope: F,
    /// `t C'`
    pub curvature_slope: F,
}

impl<F: Float> Edge<F> {
    pub(crate) fn none() -> Self {
        let zero = F::zero();
        Self { deflection: zero, curvature: zero, deflection_slope: zero, curvature_slope: zero }
    }

    /// At `−t`: all are odd.
    pub(crate) fn mirrored(self) -> Self {
        let Self { deflection, curvature, deflection_slope, curvature_slope } = self;
        Self {
            deflection: -deflection,
            curvature: -curvature,
            deflection_slope: -deflection_slope,
            curvature_slope: -curvature_slope,
        }
    }
}

/// For a positive `t`.
pub(crate) fn edge<F: Float>(t: F) -> Edge<F> {
    let square = t * t;
    // k'² and k²
    let rest = F::one() / square.plus(1.0);
    let m = (square * rest).max(F::tiny());
    let (k, root) = (m.sqrt(), rest.sqrt());
    let (log, log_rest) = (m.ln(), rest.max(F::tiny()).ln());
    let both = |(plain, with_log): &([f64; 3], [f64; 3])| {
        polynomial(m, plain) + polynomial(m, with_log) * log
    };
    let (plain, with_log, at_infinity) = &DEFLECTION;
    let far = polynomial(rest, at_infinity) * log_rest;
    let deflection = polynomial(m, plain) + polynomial(m, with_log) * log - far;
    // t = k/k'
    let slope = k * both(&SLOPE);
    Edge {
        deflection: k * deflection,
        curvature: k * both(&CURVATURE),
        deflection_slope: slope,
        curvature_slope: slope * root * root,
    }
}

fn polynomial<F: Float>(x: F, coefficients: &[f64]) -> F {
    coefficients.iter().rev().fold(F::zero(), |sum, coefficient| (sum * x).plus(*coefficient))
}
