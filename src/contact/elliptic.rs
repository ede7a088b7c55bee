//! Complete elliptic integrals in the combinations that Hertz's solution needs.
//!
//! With `Δ = √(cos²θ + g² sin²θ)` and integrals over `0 … π/2`:
//! `B = ∫ cos²θ/Δ`, `D = ∫ sin²θ/Δ`, `K = B + D`, `E = B + g² D`.
//! Hertz's formulas in K and E are 0/0 for a circle; in B and D nothing cancels.

use crate::number::Float;

/// `B`, `D` for the complementary modulus `g = s/l` in `(0, 1]`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Integrals<F> {
    /// `∫ cos²θ/Δ dθ`
    pub b: F,
    /// `∫ sin²θ/Δ dθ`
    pub d: F,
}

impl<F: Float> Integrals<F> {
    /// Gauss's arithmetic-geometric mean, carried through a linear integrand.
    ///
    /// All terms are positive, so the relative error is a few units in the last place for any `g`
    /// (after Bulirsch, Numerische Mathematik 7 (1965) 78).
    pub(crate) fn at(g: F) -> Self {
        Self { b: elliptic_sum(g, F::one(), F::zero()), d: elliptic_sum(g, F::zero(), F::one()) }
    }

    /// `K = B + D`.
    pub(crate) fn k(&self) -> F {
        self.b + self.d
    }

    /// `∫ sin²θ cos²θ/Δ³ dθ = (D − B)/m`, `m = 1 − g²`: needed only for a derivative, so the digits
    /// that cancel near the circle do not matter; `π/16` at the circle.
    pub(crate) fn c(&self, g: F) -> F {
        let m = (F::one() - g) * (F::one() + g);
        if m < F::constant(1e-3) {
            F::constant(core::f64::consts::PI / 16.0)
        } else {
            (self.d - self.b) / m
        }
    }
}

/// Landen steps; quadratic, so a fixed small number serves every `g` down to 1e-30.
const LANDEN_STEPS: usize = 12;

/// `∫ (p cos²θ + q sin²θ)/√(cos²θ + g² sin²θ) dθ`.
fn elliptic_sum<F: Float>(g: F, p: F, q: F) -> F {
    // ∫ (p cos²θ + q sin²θ)/√(m² cos²θ + n² sin²θ) dθ keeps its value under
    //     p → (p + q)/2,  q → (p n + q m)/(m + n),  m → (m + n)/2,  n → √(m n).
    let (mut m, mut n, mut p, mut q) = (F::one(), g, p, q);
    for _ in 0..LANDEN_STEPS {
        let mean = (m + n).times(0.5);
        if (m - n).abs() <= F::EPSILON * mean {
            break;
        }
        let (old_p, old_q) = (p, q);
        p = (old_p + old_q).times(0.5);
        q = (old_p * n + old_q * m) / (m + n);
        n = (m * n).sqrt();
        m = mean;
    }
    (p + q).times(0.25 * core::f64::consts::PI) / ((m + n).times(0.5))
}
