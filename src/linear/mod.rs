//! The linear theory: Kalker's creep coefficients as smooth functions of axis ratio and Poisson's
//! ratio.
//!
//! For vanishing creepage, with `v = G a b/(μ N)` times creepage and `φ = G (a b)^{3/2}/(μ N)`
//! times spin, the forces in `μ N` and the moment in `μ N √(a b)` are `fx = C11 vx`,
//! `fy = C22 vy + C23 φ`, `mz = −C23 vy + C33 φ`.
//!
//! Kalker's table (Three-Dimensional Elastic Bodies in Rolling Contact, 1990, Table E.3) has three
//! digits between `a/b = 0.1` and 10, and does not agree with the slender asymptotes printed beside
//! it. Here each coefficient is a quotient that becomes the asymptote at either end, and a
//! polynomial in `x = b/(a + b)`, weighted with `x (1 − x)`, is fitted in between to values
//! computed with CONTACT. Every formula is one expression for all `a/b`.

mod constants;

use self::constants::{E11_E22, E23_E33, M33, N23_N33};
use crate::number::avx::with_avx;
use crate::number::tables::{row, table, widen};
use crate::number::{Arithmetic, Pair, Real};
use core::f64::consts::{LN_2, PI};

/// Kalker's linear creep coefficients of one contact ellipse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearCoefficients<F> {
    /// Longitudinal creepage to longitudinal force, `C11`, positive.
    pub c11: F,
    /// Lateral creepage to lateral force, `C22`, positive.
    pub c22: F,
    /// Spin to lateral force, and with the sign reversed lateral creepage to moment, `C23`,
    /// positive.
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

impl<F: Real> LinearCoefficients<F> {
    /// Coefficients for the axis ratio `g = a/b`, positive, `a` along the rolling direction, and
    /// Poisson's ratio `ν`, 0 to 1/2.
    ///
    /// Within 0.16 % of values computed with CONTACT for `a/b` 0.1 to 10 (`C33`: 0.5 %,
    /// where the reference is known to about 1 %). Beyond that range the slender asymptotes
    /// take over.
    #[must_use]
    #[inline(always)]
    pub fn at(axis_ratio: F, poisson_ratio: F) -> Self {
        with_avx!(if F::LANES => <F: Real>(
            axis_ratio: F,
            poisson_ratio: F
        ) -> LinearCoefficients<F> {
            LinearCoefficients::quotients(axis_ratio, poisson_ratio)
        })
    }

    #[inline(always)]
    fn quotients(axis_ratio: F, poisson_ratio: F) -> Self {
        let one = F::one();
        let pair = |p: F, q: F| <F::Pair as Pair<F>>::couple(p, q);
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
        let cubic = |coefficients| cubic::<F>(coefficients, x, x2, nu);

        // Every denominator and numerator below has the form p + q m, so that the processor need
        // not wait for the logarithm m before the last operation.
        let line = |p: F::Pair, q: F::Pair| p + q * both(m);
        let w2 = w * w;
        let nz = n * z;
        let zl = z.times(LN_16);

        // a ≫ b: C11 = 2π g/(Λ − 2ν − k);  a ≪ b: C11 = π²/(4(1−ν))
        // a ≫ b: C22 = 2π g/((1−ν)(Λ − k) + 2ν);  a ≪ b: C22 = π²/4
        let fitted = cubic(table!(F, widen(&E11_E22))) * both(w);
        let near = pair(n, one) * both(y.times(8.0 / PI));
        let far = pair(one, n).times(LN_16 - K) + pair(-two_nu, two_nu);
        let denominators = line(far * both(z) + (near + fitted), pair(z + z, nz + nz));
        let (c11, c22) = (both(r.times(2.0 * PI)) / denominators).parts();
        // a ≫ b: e = (1−ν)Λ − 2 + 4ν;  a ≪ b: 2(1−ν)
        let e = n * zl + (z * (two_nu + two_nu).plus(-2.0) + y * (n + n));
        // a ≫ b: C23 = (2π/3) g^{3/2}/e;  a ≪ b: C23 = (π/3) √g (1 + ν(ln(16/g) − 5))/(1−ν)
        // a ≫ b: C33 = (π/4)((1−2ν)Λ − 2 + 6ν)/e;  a ≪ b: C33 = π²/(16(1−ν) g)
        let [m33] = table!(F, widen(&[M33]));
        let [e0, e1, n0, n1] = row::<F, 4>(m33);
        let linear = one - two_nu;
        let numerators = line(
            pair(
                (y * n + z) + (nu * y).times(LN_16 - 4.0),
                (linear * zl + z * nu.times(6.0).plus(-2.0)).times(PI / 4.0)
                    + y.times(PI * PI / 8.0),
            ) + cubic(table!(F, widen(&N23_N33))) * both(w),
            pair(nu * y, linear * z.times(PI / 2.0) + w2 * (n0 + n1 * nu)),
        );
        let denominators = line(
            both(e) + cubic(table!(F, widen(&E23_E33))) * both(w),
            both(nz + nz) + pair(F::zero(), w2 * (e0 + e1 * nu)),
        );
        let factors = pair(root.times(2.0 * PI / 3.0), one) * both(r);
        let (c23, c33) = (factors * numerators / (denominators * pair(one, g))).parts();
        Self { c11, c22, c23, c33 }
    }
}

/// Two cubic polynomials in `x` side by side, each coefficient a constant and a factor of `ν`.
#[inline(always)]
fn cubic<F: Real>([c0, c1, c2, c3]: &[[F::Stored; 4]; 4], x: F, x2: F, nu: F) -> F::Pair {
    let [nu, x, x2] = F::Pair::each(&[nu, x, x2], |x| <F::Pair as Pair<F>>::both(*x));
    let coefficient = |[c, d, by_nu, of_d]: &[F::Stored; 4]| {
        F::Pair::couple(F::stored(*c), F::stored(*d))
            + nu * F::Pair::couple(F::stored(*by_nu), F::stored(*of_d))
    };
    (coefficient(c0) + coefficient(c1) * x) + (coefficient(c2) + coefficient(c3) * x) * x2
}
