//! Parts of the integrals over strips: nodes of Gauss, common parts of the primitives, and the
//! pieces of the arc that adheres.

use crate::number::{Arithmetic, Number, Pair, Real, Stored};
use crate::strip_1967::edge::{Arc, Edge};
use crate::strip_1967::reduced::ReducedCreepage;

/// The positive two of the four nodes of Gauss on `[-1, 1]`, with their weights.
pub(super) const GAUSS_4: [[f64; 2]; 2] =
    [[0.33998104358485626, 0.6521451548625461], [0.8611363115940526, 0.34785484513745385]];
/// Six nodes of Gauss, for `∫ C K dY` on either side of the strip with `ξ̄ = 0`.
pub(super) const GAUSS_6: [[f64; 2]; 6] = [
    [-0.932469514203152, 0.17132449237917036],
    [-0.6612093864662645, 0.3607615730481386],
    [-0.2386191860831969, 0.46791393457269104],
    [0.2386191860831969, 0.46791393457269104],
    [0.6612093864662645, 0.3607615730481386],
    [0.932469514203152, 0.17132449237917036],
];
/// Distance of the zero of the square root from the middle of a piece, in half lengths, beyond
/// which four nodes give all digits.
#[inline]
pub(super) fn far<T: Number>() -> f64 {
    if size_of::<Stored<T>>() == 4 { 3.5 } else { 16.0 }
}

/// Two real numbers side by side.
pub(super) type Both<T> = <<T as Number>::Base as Number>::Pair;

/// Integrals over strips: `∫ f_x dY`, `∫ f_y dY`, `∫ m_x dY`, `∫ Y f_x dY`, `∫ (C − K) dY`.
pub(super) type Shares<T> = [T; 5];

/// `ε²`, and the square of some roundings of `Y`: where `η = 0` the direction of the slip turns
/// abruptly in the strip `ξ̄ = 0`, and a derivative with respect to `η` would be infinite.
#[inline]
pub(super) fn rounded<F: Real>(e: F) -> F {
    let rounding = F::EPSILON.times(4.0);
    e * e + rounding * rounding
}

/// `asinh(u₁/ε) − asinh(u₂/ε)` for `u₁ ≥ u₂` is the logarithm of this quotient; `d = √(u² + ε²)`.
#[inline(always)]
pub(super) fn arcsinh<A: Arithmetic>(u1: A, u2: A, d1: A, d2: A, e2: A) -> (A, A) {
    let (a1, a2) = (u1.abs() + d1 + A::tiny(), u2.abs() + d2 + A::tiny());
    let above = u1.choose(u2.choose(a1, a1 * a2), a2);
    let below = u2.choose(a2, u1.choose(e2 + A::tiny(), a1));
    (above, below)
}

/// `∫ C² uⁿ … du` with `C² = k₀ + k₁ u − u²`, from the integrals with `uⁿ`, `uⁿ⁺¹`, `uⁿ⁺²`.
#[inline]
pub(super) fn moment<F: Real>([k0, k1]: [F; 2], [one, u, uu]: [F; 3]) -> F {
    k0 * one + k1 * u - uu
}

/// The two pieces of an arc side by side: `Y = sin(θ + φ)`, with the tangent `t` of `φ/2` from
/// `−t₁` to the parting and on to `t₁`.
pub(super) struct Pieces<F: Real> {
    motion: ReducedCreepage<F>,
    middle: Edge<F>,
    /// Middle and half length of each piece in `t`.
    centre: F::Pair,
    pub half: F::Pair,
    /// `K` at the parting.
    pub least: F,
}

/// Numbers of a node in each piece.
pub(super) struct GaussNode<P> {
    pub t: P,
    /// `D = 1 + t²`
    pub d: P,
    /// `D C`, `D ξ̄`, `D S` and `K` as a quotient
    pub c: P,
    pub x: P,
    pub s: P,
    pub above: P,
    pub below: P,
    /// `C² D² w` and its share of the integral
    pub bound: P,
    pub share: P,
}

impl<F: Real> Pieces<F> {
    #[inline(always)]
    pub fn new(motion: ReducedCreepage<F>, arc: Arc<F>, parting: F, least: F) -> Self {
        let (from, to) =
            (F::Pair::couple(-arc.tangent, parting), F::Pair::couple(parting, arc.tangent));
        let (centre, half) = ((from + to).times(0.5), (to - from).times(0.5));
        Self { motion, middle: arc.middle, centre, half, least }
    }

    #[inline(always)]
    pub fn at(&self, node: F, weight: F) -> GaussNode<F::Pair> {
        let ReducedCreepage { xi, eta, slope: p, q, eta_psi: m, .. } = self.motion;
        let (Edge { y: y0, c: c0 }, both) = (self.middle, <F::Pair as Pair<F>>::both);
        let t = self.centre + self.half.by(node);
        let d = (t * t).plus(1.0);
        // D C = c₀ − t (2 y₀ + t c₀),  D ξ̄ = ξ − p y₀ − t (2 p c₀ − t (ξ + p y₀))
        let c = both(c0) - t * (t.by(c0) + both(y0.times(2.0)));
        let x = both(xi - p * y0) + t * (t.by(xi + p * y0) + both(-(p * c0).times(2.0)));
        let (square, flat) = (x * x, (d * d).by(eta * eta));
        let s = (flat + square.by(q)).sqrt();
        // (5.41) by the form that does not cancel
        let (big, positive) = (s + both(m.abs()) * d, both(m));
        let above = positive.choose(big, square + flat);
        let below = positive.choose(both(q), big + F::Pair::tiny()) * d;
        let bound = c * c.by(weight);
        let share = (above - below.by(self.least)) * bound / (below * (d * d * d));
        GaussNode { t, d, c, x, s, above, below, bound, share }
    }
}
