//! The linear theory: Kalker's creep coefficients as smooth functions of axis ratio and Poisson's ratio.
//!
//! For vanishing creepage, with `v = G a b/(μ N)` times creepage and `φ = G (a b)^{3/2}/(μ N)` times
//! spin, the forces in `μ N` and the moment in `μ N √(a b)` are
//! `fx = C11 vx`, `fy = C22 vy + C23 φ`, `mz = −C23 vy + C33 φ`.
//!
//! Kalker's table (Three-Dimensional Elastic Bodies in Rolling Contact, 1990, Table E.3) has three digits
//! between `a/b = 0.1` and 10, and does not meet the slender asymptotes printed around it. Here the
//! asymptotes are the frame: each coefficient is a quotient that becomes the asymptote at either end,
//! and a polynomial in `x = b/(a + b)`, weighted with `x (1 − x)`, is fitted in between to values
//! computed with CONTACT. There is no seam: every formula is one expression for all `a/b`.

mod constants;

use self::constants::{E11_E22, E23_E33, M33, N23_N33};
use crate::number::{Arithmetic, Float, Pair, Plain, once};
use core::f64::consts::{LN_2, PI};

/// Kalker's linear creep coefficients of one contact ellipse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearCoefficients<F> {
    /// Longitudinal creepage to longitudinal force, `C11`, positive.
    pub c11: F,
    /// Lateral creepage to lateral force, `C22`, positive.
    pub c22: F,
    /// Spin to lateral force, and with the sign reversed lateral creepage to moment, `C23`, positive.
    pub c23: F,
    /// Spin to moment, `C33`, positive.
    pub c33: F,
}

/// Axis ratios beyond `1/RATIO_LIMIT … RATIO_LIMIT` give the values at the limit.
const RATIO_LIMIT: f64 = 1e6;
/// `ln 16`.
const LN_16: f64 = 4.0 * LN_2;
/// `3 − ln 4`, the second order of the slender asymptotes of `C11` and `C22`.
const K: f64 = 3.0 - 2.0 * LN_2;

impl<F: Plain> LinearCoefficients<F> {
    /// Coefficients for the axis ratio `g = a/b`, positive, `a` along the rolling direction, and
    /// Poisson's ratio `ν`, 0 to 1/2.
    ///
    /// Within 0.16 % of values computed with CONTACT for `a/b` 0.1 to 10 (`C33`: 0.5 %,
    /// where the reference is known to about 1 %). Beyond that range the slender asymptotes
    /// take over.
    #[must_use]
    #[inline(always)]
    pub fn at(axis_ratio: F, poisson_ratio: F) -> Self {
        once!(F, Self::quotients(axis_ratio, poisson_ratio))
    }

    #[inline(always)]
    fn quotients(axis_ratio: F, poisson_ratio: F) -> Self {
        let one = F::one();
        let pair = |p: F, q: F| <F::Pair as Pair<F>>::of(p, q);
        let both = |x: F| <F::Pair as Pair<F>>::both(x);
        let g = axis_ratio.clamped(F::of(1.0 / RATIO_LIMIT), F::of(RATIO_LIMIT));
        let nu = poisson_ratio;
        let h = g.plus(1.0);
        // m = ln((1 + g)²/g): ln(b/a) at one end, ln(a/b) at the other
        let m = (h * h).ln_quotient(g);
        let (x, y) = (both(one) / pair(h, (g * g).plus(1.0))).parts();
        let t = g * x;
        // weight of the fitted part, 0 at both ends
        let w = x * t;
        let z = g * g * y;
        let (r, root) = pair((g * g).plus(1.0), g).sqrt().parts();
        // Λ = 2 m + ln 16: ln(16 (a/b)²) at the slender end a ≫ b
        let n = one - nu;
        let two_nu = nu + nu;
        let x2 = x * x;
        let cubic = |single, double| Cubic::<F>(F::Stored::table(single, double)).at(x, x2, nu);

        // every denominator and numerator below is p + q m: m comes late, and is waited for in
        // nothing but p + q m
        let line = |p: F::Pair, q: F::Pair| p + q.scale(m);
        let w2 = w * w;
        let nz = n * z;
        let zl = z.times(LN_16);

        // a ≫ b: C11 = 2π g/(Λ − 2ν − k);  a ≪ b: C11 = π²/(4(1−ν))
        // a ≫ b: C22 = 2π g/((1−ν)(Λ − k) + 2ν);  a ≪ b: C22 = π²/4
        let fitted = cubic(&E11_E22, &WIDE_E11_E22).scale(w);
        let near = pair(n, one).scale(y.times(8.0 / PI));
        let far = pair(one, n).scale(F::of(LN_16 - K)) + pair(-two_nu, two_nu);
        let denominators = line(far.scale(z) + (near + fitted), pair(z + z, nz + nz));
        let (c11, c22) = (both(r.times(2.0 * PI)) / denominators).parts();
        // a ≫ b: e = (1−ν)Λ − 2 + 4ν;  a ≪ b: 2(1−ν)
        let e = n * zl + (z * (two_nu + two_nu).plus(-2.0) + y * (n + n));
        // a ≫ b: C23 = (2π/3) g^{3/2}/e;  a ≪ b: C23 = (π/3) √g (1 + ν(ln(16/g) − 5))/(1−ν)
        // a ≫ b: C33 = (π/4)((1−2ν)Λ − 2 + 6ν)/e;  a ≪ b: C33 = π²/(16(1−ν) g)
        let [e0, e1, n0, n1] = F::each(&M33, |x| F::of_f32(*x));
        let linear = one - two_nu;
        let numerators = line(
            pair(
                (y * n + z) + (nu * y).times(LN_16 - 4.0),
                (linear * zl + z * nu.times(6.0).plus(-2.0)).times(PI / 4.0)
                    + y.times(PI * PI / 8.0),
            ) + cubic(&N23_N33, &WIDE_N23_N33).scale(w),
            pair(nu * y, linear * z.times(PI / 2.0) + w2 * (n0 + n1 * nu)),
        );
        let denominators = line(
            both(e) + cubic(&E23_E33, &WIDE_E23_E33).scale(w),
            both(nz + nz) + pair(F::zero(), w2 * (e0 + e1 * nu)),
        );
        let factors = pair(root.times(2.0 * PI / 3.0), one).scale(r);
        let (c23, c33) = (factors * numerators / (denominators * pair(one, g))).parts();
        Self { c11, c22, c23, c33 }
    }
}

/// Two cubic polynomials in `x` side by side, each coefficient a constant and a factor of `ν`.
struct Cubic<F: Plain>(&'static [[[F::Stored; 2]; 2]; 4]);

impl<F: Plain> Cubic<F> {
    #[inline(always)]
    fn at(&self, x: F, x2: F, nu: F) -> F::Pair {
        let [c0, c1, c2, c3] = self.0;
        let nu = <F::Pair as Pair<F>>::both(nu);
        (Self::coefficient(c0, nu) + Self::coefficient(c1, nu).scale(x))
            + (Self::coefficient(c2, nu) + Self::coefficient(c3, nu).scale(x)).scale(x2)
    }

    #[inline(always)]
    fn coefficient([constant, factor]: &[[F::Stored; 2]; 2], nu: F::Pair) -> F::Pair {
        <F::Pair as Pair<F>>::plain(F::both_stored(*constant))
            + nu.scale_each(F::both_stored(*factor))
    }
}

static WIDE_E11_E22: [[[f64; 2]; 2]; 4] = widen(&E11_E22);
static WIDE_E23_E33: [[[f64; 2]; 2]; 4] = widen(&E23_E33);
static WIDE_N23_N33: [[[f64; 2]; 2]; 4] = widen(&N23_N33);

/// The constants in double precision: converted once by the compiler, not in every call.
#[allow(clippy::indexing_slicing)]
pub(crate) const fn widen<const N: usize, const P: usize>(
    narrow: &[[[f32; 2]; P]; N],
) -> [[[f64; 2]; P]; N] {
    let mut wide = [[[0.0; 2]; P]; N];
    let mut i = 0;
    while i < N {
        let mut j = 0;
        while j < P {
            wide[i][j] = [narrow[i][j][0] as f64, narrow[i][j][1] as f64];
            j += 1;
        }
        i += 1;
    }
    wide
}

#[cfg(test)]
#[path = "../../tests/units/linear.rs"]
mod tests;
