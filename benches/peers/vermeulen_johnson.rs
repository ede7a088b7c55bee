//! Vermeulen and Johnson: closed form for creepage without spin.
//!
//! Source: P. J. Vermeulen, K. L. Johnson, *Contact of nonspherical elastic bodies transmitting
//! tangential forces*, J. Appl. Mech. 31 (1964) 338-340. The traction is the difference of two
//! semi-ellipsoids; the smaller stands on a similar adhesion ellipse that touches the leading edge.
//! With `λ` the ratio of the ellipses, `|F| = µ N (1 − λ³)` and `λ = 1 − τ/3`, where `τ` is the
//! length of `(C11 vx, C22 vy) G ab/(µ N)`. Spin is ignored and there is no moment.
//!
//! The paper's own coefficients follow from the curvature of the surface displacement under a
//! semi-ellipsoidal traction. Integrating the half-space solution along chords gives
//! `∂u/∂x = −(x q0/2G) ∫₀^π f(θ) sin²θ/(a²b²α³) dθ`, `α² = cos²θ/a² + sin²θ/b²`, with
//! `f = 1 − ν sin²θ` for a longitudinal and `f = 1 − ν cos²θ` for a lateral traction (two equal
//! bodies double it), hence [`own_coefficients`]. On a circle they are `4/(1 − 3ν/4)` and
//! `4/(1 − ν/4)`: 4.92 and 4.27 for ν = 1/4, where the exact ones are 4.12 and 3.67. Since 1967 the
//! method is used with Kalker's exact coefficients instead; [`solve`] takes whichever the input
//! holds.

use super::{Input, Output};

/// The paper's own `(C11, C22)` for the axis ratio `a/b` and Poisson's ratio `ν`.
///
/// A periodic integrand: the trapezoidal rule converges geometrically. Not part of a solve.
pub fn own_coefficients(a_over_b: f64, nu: f64) -> (f64, f64) {
    const STEPS: u32 = 4096;
    let g2 = a_over_b * a_over_b;
    let (mut jx, mut jy) = (0.0, 0.0);
    for k in 0..STEPS {
        let (s, c) = (core::f64::consts::PI * f64::from(k) / f64::from(STEPS)).sin_cos();
        let (s2, c2) = (s * s, c * c);
        let d = c2 + g2 * s2;
        let w = s2 / (d * d.sqrt());
        jx += (1.0 - nu * s2) * w;
        jy += (1.0 - nu * c2) * w;
    }
    // C = 2π/J, J = (a/b)² (π/steps) Σ
    let k = 2.0 * f64::from(STEPS) / g2;
    (k / jx, k / jy)
}

/// Creep force without spin.
#[inline]
pub fn solve(input: &Input) -> Output {
    let (x, y, _) = input.linear();
    let t = (x * x + y * y).sqrt();
    // |F|/(µN) = 1 − (1 − τ/3)³ for τ ≤ 3, else 1; as a factor on (x, y)
    let f = if t < 3.0 { 1.0 - t * (1.0 / 3.0 - t * (1.0 / 27.0)) } else { 1.0 / t };
    Output { fx: f * x, fy: f * y, mz: f64::NAN }
}
