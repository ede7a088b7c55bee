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
use crate::number::{Arithmetic, Dual, Number, Pair, Real};

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
    /// `κ = T`. It stays out of line where code must be small.
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline(never))]
    pub(super) fn at<T: Number<Base = F>>(&self, v: [T; 3], squares: [T; 3]) -> ([T; 3], T) {
        let ([vx, vy, phi], [vx2, vy2, phi2]) = (v, squares);
        let spin2 = phi2.scale(self.both);
        // small terms: no quotient 0/0 at rest
        let n = (vx2 + vy2 + spin2).plus(1e-12);
        let share = n.inverse();
        let shares = [vx2 * share, vy2 * share, spin2 * share];
        let [u, v, t] = shares;
        let [x, y, z, d, arm] = self.polynomials(u.value(), v.value(), t.value());
        let of_shares = |f: OfShares<F>| T::composed(f.value, f.gradient, shares);
        let (x, y) = (of_shares(x) * vx, of_shares(y) * vy);
        let force = (x * x + y * y + n * of_shares(z)).plus(1e-30);
        let moment = (n * of_shares(d)).plus(1e-30);
        let (f, m) = T::Pair::couple(force, moment).sqrt().inverse().parts();
        ([x * f, y * f, phi * of_shares(arm) * m], t)
    }

    /// `bx, by`, `Z`, `D` and `(g + 1/g) A` for the shares `U, V, T`.
    #[inline(always)]
    fn polynomials(&self, u: F, v: F, t: F) -> [OfShares<F>; 5] {
        let (u2, uv, v2, w) = (u * u, u * v, v * v, u + v);
        let (w2, squares) = (w * w, [u2, uv, v2]);
        // bx = (U + V)² + T (p U + q V + r T), by with V and U across
        let [of_x, of_y] = self.slopes;
        let (p, q) = (mean(of_x, [u, v, t]), mean(of_y, [v, u, t]));
        let ([xu, xv, xt], [yv, yu, yt], double) = (of_x, of_y, w + w);
        let x =
            Dual { value: w2 + t * p, gradient: [double + t * xu, double + t * xv, p + t * xt] };
        let y =
            Dual { value: w2 + t * q, gradient: [double + t * yu, double + t * yv, q + t * yt] };
        let [k0, k1, k2, k3, k4, k5, k6, k7, k8, k9, k10, k11, k12, k13, k14] = self.spin;
        let second = Dual {
            value: mean([k3, k4, k5], squares),
            gradient: [k3 * (u + u) + k4 * v, k4 * u + k5 * (v + v), F::zero()],
        };
        let first = Dual { value: k0 * t + k1 * u + k2 * v, gradient: [k1, k2, k0] };
        let third = Dual {
            value: u * (u2 * k6 + uv * k7) + v * (uv * k8 + v2 * k9),
            gradient: [
                k6.times(3.0) * u2 + (k7 + k7) * uv + k8 * v2,
                k7 * u2 + (k8 + k8) * uv + k9.times(3.0) * v2,
                F::zero(),
            ],
        };
        let fourth = Dual {
            value: u2 * mean([k10, k11, k12], squares) + v2 * (uv * k13 + v2 * k14),
            gradient: [
                u * (k10.times(4.0) * u2 + k11.times(3.0) * uv + (k12 + k12) * v2) + v * v2 * k13,
                v * (k14.times(4.0) * v2 + k13.times(3.0) * uv + (k12 + k12) * u2) + u * u2 * k11,
                F::zero(),
            ],
        };
        let z = times_plus(&times_plus(&times_plus(&first, t, &second), t, &third), t, &fourth);
        let [by_u, by_v, by_t] = z.gradient;
        let z = Dual { value: t * z.value, gradient: [t * by_u, t * by_v, z.value + t * by_t] };
        let [d0, d1, d2, d3, d4, d5] = self.size;
        let size = Dual { value: t * d0 + u * d1 + v * d2, gradient: [d1, d2, d0] };
        let of_squares = Dual {
            value: mean([d3, d4, d5], squares),
            gradient: [d3 * (u + u) + d4 * v, d4 * u + d5 * (v + v), F::zero()],
        };
        // (U + V)³
        let cubed = w2.times(3.0);
        let cube = Dual { value: w * w2, gradient: [cubed, cubed, F::zero()] };
        let d = times_plus(&times_plus(&size, t, &of_squares), t, &cube);
        let [au, av, at] = self.arm;
        let arm = Dual { value: u * au + v * av + t * at, gradient: [au, av, at] };
        [x, y, z, d, arm]
    }
}

/// A function of `U, V, T` with its derivatives.
type OfShares<F> = Dual<F, 3>;

/// `t f + g`
#[inline(always)]
fn times_plus<F: Real>(f: &OfShares<F>, t: F, g: &OfShares<F>) -> OfShares<F> {
    let ([by_u, by_v, by_t], [of_u, of_v, of_t]) = (f.gradient, g.gradient);
    Dual {
        value: t * f.value + g.value,
        gradient: [t * by_u + of_u, t * by_v + of_v, f.value + t * by_t + of_t],
    }
}

/// `a x + b y + c z`
#[inline(always)]
fn mean<T: Number>([a, b, c]: [T::Base; 3], [x, y, z]: [T; 3]) -> T {
    x.scale(a) + y.scale(b) + z.scale(c)
}
