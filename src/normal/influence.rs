//! Deflection of a half-space under a strip of half-elliptic pressure.
//!
//! A strip of half length `a` carries `p √(1 − (x/a)²)`. Over its own width it acts at the distance
//! `d` on the line `x = 0` of another strip, by Boussinesq's `u = ∫∫ p/(π E* r) dA`. The deflection
//! there and its curvature along `x` are each the difference of an odd function of `t = d/a`
//! between the strip's two edges:
//!
//! ```text
//! π E* u      = p a [A(t)],    A(t) = ∫ √(1 − ξ²) arsinh(t/|ξ|) dξ,   −1 < ξ < 1
//! −π E* ∂²u/∂x² = (p/a) [C(t)],  C(t) = 2 k K(k'),   k = t/√(1 + t²),  k' = 1/√(1 + t²)
//! ```
//!
//! `A` grows like `(π/2) ln t`. `C` tends to `π`, so that the curvature of an infinitely wide strip
//! is that of the plane problem, `2 p/(a E*)`. Both are fitted as `v (P(v) + w^q Q(v) ln t)` with
//! `v = t/(1 + t)`, `w = 1/(1 + t)`, by `fit/fit_influence.py`. The slopes are the derivatives of
//! the fits.

use crate::number::Arithmetic;

/// `A` or `C`: the polynomials `P` and `Q` and the power `q`.
pub(crate) trait StripEdge {
    const PLAIN: [f64; 7];
    const WITH_LOG: [f64; 6];
    const FADING: u8;

    /// The value and `t` times its slope at `t > 0`, from `w = 1/(1 + t)` and the logarithm.
    #[inline(always)]
    fn kernel<T: Arithmetic>(t: T, w: T, log: T) -> [T; 2] {
        let v = t * w;
        let ([p, p_slope], [q, q_slope]) =
            (with_slope(&Self::PLAIN, v), with_slope(&Self::WITH_LOG, v));
        let mut faded = v;
        for _ in 0..Self::FADING {
            faded = faded * w;
        }
        // t dv/dt = v w, t dw/dt = −v w
        let slope = w * (q + v * q_slope) - (v * q).times(f64::from(Self::FADING));
        [v * p + faded * q * log, v * w * (p + v * p_slope) + faded * (slope * log + q)]
    }
}

/// `A`, with a relative error of 8.4e-6, and of 8.4e-5 in its slope, for every `t`.
pub(crate) struct Deflection;

impl StripEdge for Deflection {
    const PLAIN: [f64; 7] =
        [2.77389045, 3.86121876, 26.01948635, -32.33292577, -50.12357968, 79.0367212, -26.27037052];
    const WITH_LOG: [f64; 6] =
        [-1.99986933, -1.79288023, 7.15832449, 23.17904701, -41.44536733, 16.47140109];
    const FADING: u8 = 0;
}

/// `C`, with a relative error of 6.0e-6, and of 3.3e-5 in its slope.
pub(crate) struct Curvature;

impl StripEdge for Curvature {
    const PLAIN: [f64; 7] =
        [2.77402143, 4.12824714, 34.34429115, -109.0948159, 103.6252287, -32.63539871, 0.0];
    const WITH_LOG: [f64; 6] =
        [-1.9998635, -7.74797116, -6.06100968, 19.35389746, -27.06566125, 17.43714061];
    const FADING: u8 = 3;
}

/// `Σ c_i xⁱ` and its derivative.
#[inline(always)]
fn with_slope<T: Arithmetic, const N: usize>(coefficients: &[f64; N], x: T) -> [T; 2] {
    let (mut sum, mut slope) = (T::zero(), T::zero());
    for coefficient in coefficients.iter().rev() {
        slope = slope * x + sum;
        sum = (sum * x).plus(*coefficient);
    }
    [sum, slope]
}
