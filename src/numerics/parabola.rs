//! The parabola that fits points best in the sense of weighted least squares.

use crate::number::Arithmetic;

/// The normal equations of a fit `h(x) = p₀ + p₁ x + p₂ x²`: the cofactors of their matrix
/// `[[m₀, m₁, m₂], [m₁, m₂, m₃], [m₂, m₃, m₄]]`.
#[derive(Clone, Copy, Debug)]
pub struct NormalEquations<T> {
    cofactors: [[T; 3]; 3],
    /// The determinant of the matrix: zero if the weighted points have fewer than three places.
    pub determinant: T,
}

impl<T: Arithmetic> NormalEquations<T> {
    /// From the moments `mₖ = Σ w xᵏ` of the weights.
    ///
    /// ```
    /// use kstrip::numerics::parabola::NormalEquations;
    /// // three points with weight 1 at -1, 0, 1, with the heights 3, 1, 1
    /// let equations = NormalEquations::of_moments([3.0, 0.0, 2.0, 0.0, 2.0]);
    /// let [height, slope, square] = equations.coefficients([5.0, -2.0, 4.0]);
    /// assert!((height - 1.0_f64).abs() + (slope + 1.0).abs() + (square - 1.0).abs() < 1e-15);
    /// ```
    pub fn of_moments([m0, m1, m2, m3, m4]: [T; 5]) -> Self {
        let [c00, c01, c02] = [m2 * m4 - m3 * m3, m2 * m3 - m1 * m4, m1 * m3 - m2 * m2];
        let [c11, c12, c22] = [m0 * m4 - m2 * m2, m1 * m2 - m0 * m3, m0 * m2 - m1 * m1];
        Self {
            cofactors: [[c00, c01, c02], [c01, c11, c12], [c02, c12, c22]],
            determinant: m0 * c00 + m1 * c01 + m2 * c02,
        }
    }

    /// `p₀, p₁, p₂` from the sums `Σ w xᵏ h` of the heights.
    pub fn coefficients(&self, [s0, s1, s2]: [T; 3]) -> [T; 3] {
        let scale = self.determinant.inverse();
        self.cofactors.map(|[a, b, c]| (s0 * a + s1 * b + s2 * c) * scale)
    }
}
