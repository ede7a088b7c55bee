//! Where the separatrix meets the leading edge: the ends of the interval of strips with adhesion
//! (Section 7.2).
//!
//! `K = C` is `ξ̄² + (η + ψ C)² = C²`, on the circle `Y² + C² = 1`: two conics with four common
//! points, two of them with `C > 0`. Of the three pairs of lines through the four points, the one
//! that joins the upper two belongs to the smallest root `L` of
//!
//! ```text
//! (L₀ − L)(ξ² − L)(p² − L) = (η² (L₀ − L) + η² ψ²) L,   L₀ = 1 − ψ² + p².
//! ```
//!
//! It is real, between 0 and `min(ξ², p²)`, and simple where an interval is born. With
//! `d = L₀ − L`, `λ = ξ² − L` and `M = λ + p² + η² + (ηψ)²/d`, for which `L M = p² ξ²`, the chord
//! is
//!
//! ```text
//! p ξ √(d/M) Y + d C = D,   D = ηψ + √(d M).
//! ```
//!
//! Its normal `(sin θ, cos θ)` points to the middle of the arc, and half the arc is `β` with
//!
//! ```text
//! cos β = D/√(d L₀),   sin² β = (1 − ψ² − λ − η² − 2 ηψ D/d)/L₀:
//! ```
//!
//! no strip adheres where this is not positive, and then `(sin θ, cos θ)` is the strip that is
//! nearest to adhesion.

use crate::number::{Arithmetic, Number};
use crate::strip_1967::reduced::ReducedCreepage;

/// A point `(Y, C)` of the leading edge, `Y² + C² = 1`, `C ≥ 0`, in units of the semi-axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge<T> {
    /// `Y = y/b`
    pub y: T,
    /// `C = c/a`
    pub c: T,
}

impl<T: Number> Edge<T> {
    /// The point with `Y` between −1 and 1.
    #[inline]
    pub fn at(y: T) -> Self {
        Self { y, c: ((T::one() - y) * (T::one() + y)).sqrt() }
    }

    /// Without derivatives.
    #[inline]
    pub fn values(&self) -> Edge<T::Base> {
        Edge { y: self.y.value(), c: self.c.value() }
    }

    /// `yes` where a number is positive, else `no`.
    #[inline]
    pub fn chosen_edge(by: T, yes: Self, no: Self) -> Self {
        Self { y: by.choose(yes.y, no.y), c: by.choose(yes.c, no.c) }
    }
}

/// A piece of the leading edge.
#[derive(Clone, Copy, Debug)]
pub struct Arc<T> {
    /// End at smaller `Y`.
    pub lower: Edge<T>,
    /// End at larger `Y`.
    pub upper: Edge<T>,
    /// Its middle `(sin θ, cos θ)`.
    pub middle: Edge<T>,
    /// `tan(β/2)`, `β` half its angle.
    pub tangent: T,
}

impl<T: Number> Arc<T> {
    /// Without derivatives.
    #[inline]
    pub fn values(&self) -> Arc<T::Base> {
        let (lower, upper, middle) =
            (self.lower.values(), self.upper.values(), self.middle.values());
        Arc { lower, upper, middle, tangent: self.tangent.value() }
    }
}

/// The arc of the strips with adhesion, of no length where there are none, and a number that is
/// positive where there are.
#[inline(always)]
pub fn adhesion<T: Number>(motion: &ReducedCreepage<T>) -> (Arc<T>, T) {
    let ReducedCreepage { xi, eta, slope: p, q, eta_psi: m, .. } = *motion;
    let (p2, eta2, none, least) = (p * p, eta * eta, T::zero(), T::from_base(T::ROOT_TINY));
    // The root as its distance s from min(ξ², p²), which is positive: neither λ nor d cancels.
    let inside = p - xi;
    let more = inside * (p + xi);
    // Where both are equal, derivatives are those of the one that min(ξ, p) returns.
    let (beside_p, beside_xi) = (inside.choose(more, none), inside.choose(none, -more));
    let gap = beside_p + beside_xi;
    let d0 = q + beside_p + least;
    let s = root_of_cubic(motion, xi.min(p).squared(), gap, d0);
    let (d, lambda) = (d0 + s, beside_xi + s);
    let scale = (p2 + q + least).inverse();
    // d M, M = λ + p² + η² + m²/d
    let rest = lambda + p2 + eta2;
    // The squares below the root may underflow, so that nothing is divided by the root alone.
    let root = (d * rest + m * m).sqrt();
    // D/d = (m + √(dM))/d = (λ + p² + η²)/(√(dM) − m)
    let ratio = m.choose(m + root, rest) / m.choose(d, root - m + least);
    // (p ξ/√M, √d)/√L₀
    let c = (d * scale).sqrt();
    let middle = Edge { y: p * xi * c / (root + least), c };
    let cosine = ratio * c;
    // sin² β as a quotient with L₀, or as 1 − cos² β where the quotient loses more digits and is
    // not below zero.
    let pull = (m * ratio).times(2.0);
    let sum = q + lambda + eta2;
    let quotient = (q - lambda - eta2 - pull) * scale;
    let size = (sum + pull.abs()) * scale;
    let likely = quotient + size.scale(T::EPSILON.times(4.0));
    let exact = (T::one() - cosine) * (T::one() + cosine);
    let sine2 = (size - T::one()).choose(likely.choose(exact, quotient), quotient);
    // An arc narrower than rounding counts as none.
    let sine2 = sine2 - T::from_base(T::EPSILON * T::EPSILON);
    let sine = sine2.min(T::one()).max(none).sqrt();
    let cosine = sine2.choose(cosine, T::one());
    let (across, along) = (middle.c * sine, middle.y * sine);
    let (y, c) = (middle.y * cosine, middle.c * cosine);
    let arc = Arc {
        lower: Edge { y: y - across, c: c + along },
        upper: Edge { y: y + across, c: c - along },
        middle,
        tangent: sine / (T::one() + cosine),
    };
    (arc, sine2)
}

/// The positive root of the cubic for `s = least − L`, `least = min(ξ², p²)`:
/// `d s (s + gap) = (η² d + m²)(least − s)` with `d = d₀ + s`.
#[inline(always)]
fn root_of_cubic<T: Number>(motion: &ReducedCreepage<T>, least: T, gap: T, d0: T) -> T {
    let (eta2, m2) = (motion.eta * motion.eta, motion.eta_psi * motion.eta_psi);
    let inputs = [least, gap, d0, eta2, m2];
    let (least, gap, d0) = (least.value(), gap.value(), d0.value());
    let (eta2, m2, eta) = (eta2.value(), m2.value(), motion.eta.value().abs());
    // For a given d it is a square root: s (s + gap) = E (least − s), E = η² + m²/d, d ≈ d₀ + least
    // |η|/(|η| + max(ξ, p))
    let weight = eta + motion.xi.value().max(motion.slope.value());
    let e = eta2 + m2 * weight / (d0 * weight + least * eta + T::TINY);
    let sum = gap + e;
    let product = (e * least).times(2.0);
    let mut s = product / (sum + (sum * sum + product.times(2.0)).sqrt() + T::TINY);
    // Halley's steps: two in nearly all cases; of several contacts side by side, as many as the
    // slowest needs.
    let mut open = T::Base::one();
    for i in 0..16 {
        let (d, other, left) = (d0 + s, s + gap, least - s);
        let pull = eta2 * d + m2;
        let slope = d * (s + other) + s * other + (pull - eta2 * left);
        let value = d * s * other - pull * left;
        let bend = s.times(3.0) + (d0 + gap + eta2);
        let step = value * slope / (slope * slope - value * bend + T::TINY);
        s = if T::LANES == 1 { s - step } else { open.choose(s - step, s) };
        if i > 0 {
            // The error is about the cube of the step.
            let more = step.abs() * (step * step) - T::EPSILON * s * (s * s);
            open = open.choose(more, T::Base::zero());
            if !open.exceeds(T::Base::zero()) {
                break;
            }
        }
    }
    let s = s.max(T::Base::zero());
    let (d, other, left) = (d0 + s, s + gap, least - s);
    let pull = eta2 * d + m2;
    let slope = d * (s + other) + s * other + (pull - eta2 * left);
    let by = -(slope + T::TINY).inverse();
    let slopes = [-pull, d * s, s * other - eta2 * left, -(d * left), -left];
    T::composed(s, T::Base::each(&slopes, |part| *part * by), inputs)
}
