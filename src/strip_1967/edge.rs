//! Where the separatrix meets the leading edge: the ends of the interval of strips with adhesion (Section 7.2).
//!
//! `K = C` is `ξ̄² + (η + ψ C)² = C²`, on the circle `Y² + C² = 1`: two conics with four common points, two of them with
//! `C > 0`. Of the three pairs of lines through the four points, the one that joins the upper two belongs to the smallest root `L`
//! of
//!
//! ```text
//! (L₀ − L)(ξ² − L)(p² − L) = (η² (L₀ − L) + η² ψ²) L,   L₀ = 1 − ψ² + p².
//! ```
//!
//! It is real, between 0 and `min(ξ², p²)`, and simple where an interval is born. With `d = L₀ − L`, `λ = ξ² − L` and
//! `M = λ + p² + η² + (ηψ)²/d`, for which `L M = p² ξ²`, the chord is
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
//! no strip adheres where this is not positive, and then `(sin θ, cos θ)` is the strip that comes nearest to it.

use crate::number::{Arithmetic, Number};
use crate::strip_1967::Motion;

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
    #[inline(always)]
    pub fn at(y: T) -> Self {
        Self { y, c: ((T::one() - y) * (T::one() + y)).sqrt() }
    }

    /// `yes` where a number is positive, else `no`.
    #[inline(always)]
    pub fn chosen(by: T, yes: Self, no: Self) -> Self {
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
    /// Between two points, not the whole edge.
    #[inline(always)]
    pub fn between(lower: Edge<T>, upper: Edge<T>) -> Self {
        let (y, c) = (lower.y + upper.y, lower.c + upper.c);
        let (dy, dc) = (upper.y - lower.y, upper.c - lower.c);
        // 2 cos β and 2 sin β
        let (sum, chord) = ((y * y + c * c).sqrt(), (dy * dy + dc * dc).sqrt());
        let middle = Edge { y: y / sum, c: c / sum };
        Self { lower, upper, middle, tangent: chord / sum.plus(2.0) }
    }
}

/// The arc of the strips with adhesion, of no length where there are none, and a number that is positive where there are.
#[inline(always)]
pub fn adhesion<T: Number>(motion: &Motion<T>) -> (Arc<T>, T) {
    let Motion { xi, eta, slope: p, q, eta_psi: m, .. } = *motion;
    let (xi2, p2, eta2, m2) = (xi * xi, p * p, eta * eta, m * m);
    // The root as its distance s from min(ξ², p²), which is positive: neither λ nor d cancels.
    let inside = p - xi;
    let least = inside.choose(xi2, p2);
    let gap = inside.choose(inside, -inside) * (p + xi);
    let (beside_p, beside_xi) = (inside.choose(gap, T::zero()), inside.choose(T::zero(), gap));
    let d0 = q + beside_p + T::from_base(T::ROOT_TINY);
    let cubic = Cubic { least, gap, d0, eta2, m2 };
    let s = cubic.root();
    let (d, lambda) = (d0 + s, beside_xi + s);
    let l0 = p2 + q + T::from_base(T::ROOT_TINY);
    // M = λ + p² + η² + m²/d
    let rest = lambda + p2 + eta2;
    let big = rest + m2 / (d + T::tiny()) + T::from_base(T::ROOT_TINY);
    let root = (d * big).sqrt();
    // D/d = (m + √(dM))/d = (λ + p² + η²)/(√(dM) − m)
    let ratio = m.choose((m + root) / d, rest / (root - m + T::tiny()));
    // (p ξ/√M, √d), whose square is L₀
    let normal = Edge { y: p * xi / big.sqrt(), c: d.sqrt() };
    let inverse = (normal.y * normal.y + d + T::tiny()).sqrt().inverse();
    let middle = Edge { y: normal.y * inverse, c: normal.c * inverse };
    let cosine = ratio * middle.c;
    // sin² β as a quotient by L₀, or where L₀ is small and the quotient not below zero as 1 − cos² β
    let pull = (m * ratio).times(2.0);
    let excess = q - lambda - eta2 - pull;
    let noise = (q + lambda + eta2 + m.choose(pull, -pull)).scale(T::EPSILON.times(4.0));
    let rest = (T::one() - cosine) * (T::one() + cosine);
    let quotient = excess / l0;
    let small = (excess + noise).choose(rest, quotient);
    // (what is narrower than rounding is none)
    let sine2 = (l0 - T::one()).choose(quotient, small) - T::from_base(T::EPSILON * T::EPSILON);
    let sine = sine2.choose(sine2.min(T::one()), T::zero()).sqrt();
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

/// The cubic for `s = min(ξ², p²) − L`: `d s (s + gap) = (η² d + m²)(min(ξ², p²) − s)` with `d = d₀ + s`, one positive root.
struct Cubic<T> {
    least: T,
    gap: T,
    d0: T,
    eta2: T,
    m2: T,
}

impl<T: Number> Cubic<T> {
    /// The root: two steps of Halley's for its value, one of Newton's that carries derivatives.
    #[inline(always)]
    fn root(&self) -> T {
        let plain = Cubic {
            least: self.least.value(),
            gap: self.gap.value(),
            d0: self.d0.value(),
            eta2: self.eta2.value(),
            m2: self.m2.value(),
        };
        let tiny = <T::Base as Arithmetic>::tiny();
        // For a given d it is a square root, now above and now below: the mean of two in turn is near wherever it lies.
        let below = plain.with(plain.d0 + plain.least);
        let above = plain.with(plain.d0 + below);
        let mut s = (above * plain.with(plain.d0 + above)).sqrt();
        for _ in 0..2 {
            let (value, slope) = plain.at(s);
            let bend = s.times(3.0) + (plain.d0 + plain.gap + plain.eta2);
            s -= value * slope / (slope * slope - value * bend + tiny);
        }
        let (_, slope) = plain.at(s);
        let (value, _) = self.at(T::from_base(s));
        let inverse = T::Base::one() / (slope + tiny);
        (T::from_base(s) - value.scale(inverse)).max(T::zero())
    }

    #[inline(always)]
    fn at(&self, s: T) -> (T, T) {
        let (d, other, left) = (self.d0 + s, s + self.gap, self.least - s);
        let pull = self.eta2 * d + self.m2;
        let value = d * s * other - pull * left;
        let slope = d * (s + other) + s * other + (pull - self.eta2 * left);
        (value, slope)
    }

    /// `s (s + gap) = E (least − s)`, `E = η² + m²/d`
    #[inline(always)]
    fn with(&self, d: T) -> T {
        let e = self.eta2 + self.m2 / (d + T::tiny());
        let sum = self.gap + e;
        let product = (e * self.least).times(2.0);
        product / (sum + (sum * sum + product.times(2.0)).sqrt() + T::tiny())
    }
}
