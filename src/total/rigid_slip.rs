//! A patch that slides as a whole: the integrals of `μ p s/|s|` over the ellipse, as roots of
//! rational functions.
//!
//! With `N = vx² + vy² + φ² (g + 1/g)` and the shares `U = vx²/N`, `V = vy²/N`,
//! `T = φ² (g + 1/g)/N`
//!
//! `F = (bx vx, by vy)/√((bx vx)² + (by vy)² + N Z)`, `M = φ (g + 1/g) A/√(N D)`,
//!
//! `bx, by` of degree 2 in `U, V, T`, `Z` of degree 5, `A` of degree 1 and `D` of degree 3, all
//! positive; `Z` vanishes without spin. Their coefficients are polynomials in
//! `s = (g − 1)/(g + 1)`, and `x ↔ y` is `U ↔ V`, `s ↔ −s`. Fitted by `fit/rigid_slip.py` to
//! quadrature for `g` 1/70 to 70: within 0.0035 of `F` in the mean, 0.011 at the 95th percentile,
//! 0.033 at worst (there the pole of the spin lies at the edge of the patch).

use super::constants::*;
use crate::number::tables::{row, table, widen};
use crate::number::{Arithmetic, Number, Pair, Real};

/// Coefficients for one axis ratio.
#[derive(Clone, Copy, Debug)]
pub(super) struct RigidSlip<F> {
    /// `g + 1/g`
    both: F,
    /// Of `T U`, `T V` and `T²` in `bx`; of `T V`, `T U` and `T²` in `by`
    slopes: [[F; 3]; 2],
    /// `Z/T`: of `T⁴`; `T³ (U, V)`; `T² (U², U V, V²)`; `T (U³, U² V, U V², V³)`;
    /// `(U⁴, U³ V, U² V², U V³, V⁴)`
    spin: [F; 15],
    /// `(g + 1/g) A`: of `U`, `V` and `T`
    arm: [F; 3],
    /// `(D − (U + V)³)/T`: of `T²`; `T (U, V)`; `(U², U V, V²)`
    size: [F; 6],
}

/// Polynomials in `s`.
struct Polynomials<F> {
    s: F,
    s2: F,
}

impl<F: Real> Polynomials<F> {
    /// `c₀ + c₁ s² + c₂ s⁴`
    #[inline]
    fn even(&self, [c0, c1, c2]: [F; 3]) -> F {
        c0 + self.s2 * (c1 + self.s2 * c2)
    }

    #[inline]
    fn evens<const N: usize>(&self, all: &[[F::Stored; 3]; N]) -> [F; N] {
        F::each(all, |c| self.even(row(c)))
    }

    /// The same with the odd part `(c₃ + c₄ s²) s`, at `s` and `−s`.
    #[inline(always)]
    fn pairs<const N: usize>(&self, all: &[[F::Stored; 5]; N]) -> [[F; 2]; N] {
        let mut pairs = [[F::zero(); 2]; N];
        for (pair, c) in pairs.iter_mut().zip(all) {
            let [c0, c1, c2, c3, c4] = row(c);
            let even = self.even([c0, c1, c2]);
            let odd = self.s * (c3 + self.s2 * c4);
            *pair = [even + odd, even - odd];
        }
        pairs
    }
}

impl<F: Real> RigidSlip<F> {
    /// For `g` and `g + 1/g`.
    #[inline(always)]
    pub(super) fn new(g: F, both: F) -> Self {
        let s = g.plus(-1.0) / g.plus(1.0);
        let s2 = s * s;
        let polynomials = Polynomials { s, s2 };
        let [[xu, yv], [xv, yu], [xt, yt]] = polynomials.pairs(table!(F, widen(&RIGID_SLOPE)));
        let [[k1, k2], [k3, k5], [k6, k9], [k7, k8], [k10, k14], [k11, k13]] =
            polynomials.pairs(table!(F, widen(&RIGID_SPIN)));
        let [k0, k4, k12] = polynomials.evens(table!(F, widen(&RIGID_SPIN_EVEN)));
        let [[au, av]] = polynomials.pairs(table!(F, widen(&RIGID_ARM)));
        let [at] = polynomials.evens(table!(F, widen(&RIGID_ARM_EVEN)));
        let [[d1, d2], [d3, d5]] = polynomials.pairs(table!(F, widen(&RIGID_SIZE)));
        let [d0, d4] = polynomials.evens(table!(F, widen(&RIGID_SIZE_EVEN)));
        Self {
            both,
            slopes: [[xu, xv, xt], [yv, yu, yt]],
            spin: [k0, k1, k2, k3, k4, k5, k6, k7, k8, k9, k10, k11, k12, k13, k14],
            arm: [au * both, av * both, at * both],
            size: [d0, d1, d2, d3, d4, d5],
        }
    }

    /// `(Fx, Fy)/(μ N)` and `Mz/(μ N √(ab))` for creepages and their squares, and the share of spin
    /// `κ = T`.
    #[inline(always)]
    pub(super) fn at<T: Number<Base = F>>(&self, v: [T; 3], squares: [T; 3]) -> ([T; 3], T) {
        let ([vx, vy, phi], [vx2, vy2, phi2]) = (v, squares);
        let spin2 = phi2.scale(self.both);
        // small terms: no quotient 0/0 at rest
        let n = (vx2 + vy2 + spin2).plus(1e-12);
        let share = T::one() / n;
        let (u, v, t) = (vx2 * share, vy2 * share, spin2 * share);
        let (u2, uv, v2, w) = (u * u, u * v, v * v, u + v);
        let w2 = w * w;
        // bx = (U + V)² + T (p U + q V + r T), by with V and U across
        let [of_x, of_y] = self.slopes;
        let x = (w2 + t * mean(of_x, [u, v, t])) * vx;
        let y = (w2 + t * mean(of_y, [v, u, t])) * vy;
        let [k0, k1, k2, k3, k4, k5, k6, k7, k8, k9, k10, k11, k12, k13, k14] = self.spin;
        let squares = [u2, uv, v2];
        let third = u * (u2.scale(k6) + uv.scale(k7)) + v * (uv.scale(k8) + v2.scale(k9));
        let fourth = u2 * mean([k10, k11, k12], squares) + v2 * (uv.scale(k13) + v2.scale(k14));
        let z = t * (t.scale(k0) + u.scale(k1) + v.scale(k2)) + mean([k3, k4, k5], squares);
        let z = t * (fourth + t * (third + t * z));
        let [d0, d1, d2, d3, d4, d5] = self.size;
        let d = t * (t * (t.scale(d0) + u.scale(d1) + v.scale(d2)) + mean([d3, d4, d5], squares));
        let (force, moment) = ((x * x + y * y + n * z).plus(1e-30), (n * (w * w2 + d)).plus(1e-30));
        let (f, m) = T::Pair::couple(force, moment).sqrt().inverse().parts();
        let [au, av, at] = self.arm;
        let arm = u.scale(au) + v.scale(av) + t.scale(at);
        ([x * f, y * f, phi * arm * m], t)
    }
}

/// `a x + b y + c z`
#[inline(always)]
fn mean<T: Number>([a, b, c]: [T::Base; 3], [x, y, z]: [T; 3]) -> T {
    x.scale(a) + y.scale(b) + z.scale(c)
}
