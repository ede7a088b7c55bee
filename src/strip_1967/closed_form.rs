//! Total force of the strip theory of 1967 by its primitives (7.1).
//!
//! Every integral over the strips is elementary under the rigid-slip rule: `asin` from the width of
//! the ellipse, `asinh` from `S` and from the sliding direction, and powers. Evaluated as
//! differences between the ends of an interval `[Y₁, Y₂]`, in forms that do not cancel when the
//! creepage hardly varies along the strip direction (`p → 0`). Independent of the quadrature in
//! [`totals`](crate::strip_1967::totals), which is checked against it.
//!
//! The moment is left out: its term `η C κ` multiplies two square roots of different quadratics,
//! an elliptic integral.

use crate::contact::creepage::Parameters;
use crate::number::Float;
use crate::strip_1967::leading_edge::{AdhesionInterval, EdgePoint, StripFamily};
use crate::strip_1967::quadrature::Tabulated;

/// `(F_x, F_y)/(μ N)` under the rigid-slip rule for `|ψ| < 1`; `None` for larger spin, where the
/// bound of the traction adds crossings without elementary form.
///
/// Relative to `μ N` the rounding error is about `ε/(1 − ψ²)`.
///
/// # Example
/// Pure longitudinal creepage, (8.15):
/// ```
/// use kstrip::{strip_1967::closed_form, contact::creepage::Parameters};
/// let parameters = Parameters { xi: 0.5, eta: 0.0, psi: 0.0, poisson_ratio: 0.28, axis_ratio: 1.0 };
/// let (fx, fy) = closed_form::force(&parameters).ok_or("|ψ| ≥ 1")?;
/// let exact = 1.0 - (2.25 * 0.75_f64.sqrt() - 1.5 * 0.5_f64.acos()) / 2.0;
/// assert!((fx - exact).abs() < 1e-15 && fy == 0.0);
/// # Ok::<(), &str>(())
/// ```
#[must_use]
pub fn force<F: Tabulated>(parameters: &Parameters<F>) -> Option<(F, F)> {
    if !(parameters.psi.abs() < F::one()) {
        return None;
    }
    let family = StripFamily {
        xi: parameters.xi,
        slope: parameters.spin_slope(),
        eta: parameters.eta,
        psi: parameters.psi,
    };
    let compliance = F::one() - parameters.poisson_ratio;
    let edges = [EdgePoint { y: -F::one(), c: F::zero() }, EdgePoint { y: F::one(), c: F::zero() }];
    let (fx, fy) = match family.adhesion_interval() {
        Ok(AdhesionInterval { lower, upper }) => {
            let parts = [
                sliding(&family, compliance, edges[0].y, lower.y),
                adhesion(&family, &lower, &upper),
                sliding(&family, compliance, upper.y, edges[1].y),
            ];
            parts.iter().fold((F::zero(), F::zero()), |sum, part| (sum.0 + part.0, sum.1 + part.1))
        }
        Err(_) => sliding(&family, compliance, edges[0].y, edges[1].y),
    };
    Some((fx.times(0.75), fy.times(0.75)))
}

/// `∫ ξ̄ (2C − K) dY` and `∫ [ψ C² + η (2C − K)] dY`.
fn adhesion<F: Float>(
    family: &StripFamily<F>,
    lower: &EdgePoint<F>,
    upper: &EdgePoint<F>,
) -> (F, F) {
    let StripFamily { xi, slope, eta, psi } = *family;
    let q = (F::one() - psi) * (F::one() + psi);
    let width = upper.y - lower.y;
    // ∫ C dY = (asin Y + Y C)/2,  ∫ Y C dY = −C³/3,  ∫ C² dY = Y − Y³/3
    let angle = angle_between(lower, upper);
    let c1 = (angle + (upper.y * upper.c - lower.y * lower.c)).times(0.5);
    let yc = (lower.c * lower.c * lower.c - upper.c * upper.c * upper.c).times(1.0 / 3.0);
    let c2 = width
        * (F::one() - (lower.y * lower.y + lower.y * upper.y + upper.y * upper.y).times(1.0 / 3.0));

    let (x1, x2) = (family.xi_bar(lower.y), family.xi_bar(upper.y));
    let s_of = |x: F| (eta * eta + q * x * x).sqrt();
    let (s1, s2) = (s_of(x1), s_of(x2));
    let sum = s1 + s2 + F::TINY;
    // ∫ ξ̄ S dY = −S³/(3 p q), with the difference of the cubes divided through by p q
    let xi_s = width * (x1 + x2) * (s1 * s1 + s1 * s2 + s2 * s2) / sum.times(3.0);
    // ∫ S dY = ½ [ξ̄ S + (η²/√q) asinh(√q ξ̄/|η|)]/(−p), mean values over the interval
    let mean_product = (s1 + s2).times(0.5) + (x1 + x2).times(0.5) * q * (x1 + x2) / sum;
    let s = width.times(0.5) * (mean_product + eta * eta * mean_inverse(x1, x2, s1, s2, eta, q));
    let eta_psi = eta * psi;
    // ∫ ξ̄ K dY and ∫ K dY with K = (S + ηψ)/q   (5.41)
    let xi_k = (xi_s + eta_psi * width * (x1 + x2).times(0.5)) / q;
    let k = (s + eta_psi * width) / q;
    let xi_c = xi * c1 - slope * yc;
    (xi_c.times(2.0) - xi_k, psi * c2 + eta * (c1.times(2.0) - k))
}

/// Mean of `1/√(e² + q x²)` over `x` between `x₁` and `x₂`: a difference of `asinh`, over `x₂ − x₁`.
fn mean_inverse<F: Float>(x1: F, x2: F, r1: F, r2: F, e: F, q: F) -> F {
    // asinh(u₁) − asinh(u₂) = asinh(u₁ r₂ − u₂ r₁) for u = √q x/|e|, r = √(1 + u²). For equal signs the
    // argument is √q (x₁ − x₂)(x₁ + x₂)/(x₁ r₂ + x₂ r₁); for opposite signs as it stands.
    let root = q.sqrt();
    let difference = x1 - x2;
    if x1 * x2 > F::zero() {
        let per_difference = (x1 + x2)
            / (x1 * r2 + x2 * r1 + F::TINY.times(if x1 > F::zero() { 1.0 } else { -1.0 }));
        let z = root * difference * per_difference;
        asinh_over_argument(z) * per_difference
    } else if difference == F::zero() {
        F::one() / (r1 + F::TINY)
    } else {
        let z = root * (x1 * r2 - x2 * r1) / (e * e + F::TINY);
        z.asinh() / (root * difference)
    }
}

/// `asinh(z)/z`, 1 at 0.
fn asinh_over_argument<F: Float>(z: F) -> F {
    if z.abs() < F::constant(1e-4) { F::one() - (z * z).times(1.0 / 6.0) } else { z.asinh() / z }
}

/// `asin Y₂ − asin Y₁`.
fn angle_between<F: Float>(lower: &EdgePoint<F>, upper: &EdgePoint<F>) -> F {
    let (dy, dc) = (upper.y - lower.y, upper.c - lower.c);
    let (sy, sc) = (upper.y + lower.y, upper.c + lower.c);
    let (chord, along) = ((dy * dy + dc * dc).sqrt(), (sy * sy + sc * sc).sqrt());
    (chord / (along.plus(2.0))).atan().times(4.0)
}

/// `∫ (1 − Y²) ((1 − ν) ξ̄, η)/D dY` with `D = √((1 − ν)² ξ̄² + η²)`.
fn sliding<F: Tabulated>(family: &StripFamily<F>, compliance: F, from: F, to: F) -> (F, F) {
    // Everything is homogeneous of degree zero in (ξ̄, η): work at size one.
    let size = family.xi.abs().max(family.slope.abs()).max(family.eta.abs());
    if size <= F::TINY || !(to > from) {
        return (F::zero(), F::zero());
    }
    let scale = compliance / size;
    let (z0, p) = (family.xi * scale, family.slope * scale);
    let e = family.eta / size;
    // Expand about the middle of the interval, u = Y − m: z = z_m − p u, 1 − Y² = w₀ + w₁ u + w₂ u²
    let (middle, half) = ((from + to).times(0.5), (to - from).times(0.5));
    let z_m = z0 - p * middle;
    let (w0, w1) = ((F::one() - middle) * (F::one() + middle), -middle.times(2.0));
    let d_m = (z_m * z_m + e * e).sqrt();
    if (p * half).abs() < d_m.times(0.25) {
        // The direction hardly turns: the integrand is analytic far beyond the interval, and 16
        // nodes give all digits where the primitives would cancel like (D/p)³.
        let (mut fx, mut fy) = (F::zero(), F::zero());
        for &(node, weight) in F::GAUSS_16 {
            let u = half * node;
            let z = z_m - p * u;
            let force = (w0 + u * (w1 - u)) * weight * half / (z * z + e * e).sqrt();
            fx += force * z;
            fy += force * e;
        }
        return (fx, fy);
    }
    // In z: u = (z_m − z)/p, so 1 − Y² is a quadratic c₀ + c₁ z + c₂ z² and
    // J_n = ∫ zⁿ/D dz has J₀ = asinh(z/e), J₁ = D, J₂ = (z D − e² J₀)/2, J₃ = D³/3 − e² D.
    let inverse = F::one() / p;
    let c2 = -(inverse * inverse);
    let c1 = -(w1 * inverse) + (z_m * inverse * inverse).times(2.0);
    let c0 = w0 + z_m * inverse * (w1 - z_m * inverse);
    let (z_from, z_to) = (z_m + p * half, z_m - p * half);
    let d = |z: F| (z * z + e * e).sqrt();
    let (d_from, d_to) = (d(z_from), d(z_to));
    let j0 = -(z_from - z_to) * mean_inverse(z_from, z_to, d_from, d_to, e, F::one());
    let j1 = d_to - d_from;
    let j2 = ((z_to * d_to - z_from * d_from) - e * e * j0).times(0.5);
    let j3 = (d_to * d_to * d_to - d_from * d_from * d_from).times(1.0 / 3.0) - e * e * j1;
    // dY = −dz/p
    let fx = -(c0 * j1 + c1 * j2 + c2 * j3) * inverse;
    let fy = -(c0 * j0 + c1 * j1 + c2 * j2) * inverse * e;
    (fx, fy)
}
