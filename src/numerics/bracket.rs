//! The interval that contains a root, and the guard of a root search in it.
//!
//! A search by Newton's method, by secants or by false position proposes its next place; the
//! bracket takes the proposal if it lies inside, and halves the interval otherwise. So a search
//! converges as fast as its method near the root, and never worse than bisection leaves it.

use crate::number::Float;

/// Two places between which a function changes its sign: in either order.
#[derive(Clone, Copy, Debug)]
pub struct Bracket<F> {
    /// Where the function is negative.
    pub negative: F,
    /// Where the function is zero or positive.
    pub positive: F,
}

impl<F: Float> Bracket<F> {
    /// Moves one of its ends to a place inside, at which the function has this value.
    ///
    /// ```
    /// use kstrip::numerics::Bracket;
    /// // the square root of 2 by bisection
    /// let mut bracket = Bracket { negative: 1.0, positive: 2.0 };
    /// for _ in 0..40 {
    ///     let x = bracket.middle();
    ///     bracket.narrow(x, x * x - 2.0);
    /// }
    /// assert!((bracket.middle() - 2.0_f64.sqrt()).abs() < 1e-12);
    /// ```
    pub fn narrow(&mut self, x: F, value: F) {
        if value < F::zero() {
            self.negative = x;
        } else {
            self.positive = x;
        }
    }

    /// The distance of its ends.
    pub fn width(&self) -> F {
        (self.positive - self.negative).abs()
    }

    /// The middle of its ends.
    pub fn middle(&self) -> F {
        self.negative.times(0.5) + self.positive.times(0.5)
    }

    /// The middle of two positive ends of which one is more than ten times the other is that of
    /// their logarithms, so that a root of any size is found in a few steps; that of others as
    /// [`middle`](Self::middle).
    ///
    /// ```
    /// use kstrip::numerics::Bracket;
    /// assert_eq!(Bracket { negative: 1e-100, positive: 1.0 }.ratio_middle(), 1e-50);
    /// assert_eq!(Bracket { negative: 2.0, positive: 1.0 }.ratio_middle(), 1.5);
    /// ```
    pub fn ratio_middle(&self) -> F {
        let Self { negative, positive } = *self;
        let (low, high) = (negative.min(positive), negative.max(positive));
        let far = low > F::zero() && low < high.times(0.1);
        if far { low.sqrt() * high.sqrt() } else { self.middle() }
    }

    /// Whether a place lies between its ends, or is one of them. No NaN does.
    pub fn holds(&self, x: F) -> bool {
        x >= self.negative.min(self.positive) && x <= self.negative.max(self.positive)
    }

    /// A proposed place if the bracket holds it, else the middle.
    pub fn guarded(&self, proposed: F) -> F {
        if self.holds(proposed) { proposed } else { self.middle() }
    }
}

/// The root of a function between two places of different sign, by Newton's method guarded by a
/// [`Bracket`]. `of` gives the value and the derivative of the function.
///
/// The search ends when a step is shorter than `4 ε` of the interval at the beginning, or than `√ε`
/// of the present one, because the next step would be as small as the square of this one, or when
/// it leads to an end of the present one; after 60 steps at the latest.
///
/// ```
/// use kstrip::numerics::bracket::{Bracket, root};
/// let between = Bracket { negative: 0.0, positive: 2.0 };
/// let x: f64 = root(between, |x| [x * x * x - 5.0, 3.0 * x * x]);
/// assert!((x - 5.0_f64.cbrt()).abs() < 1e-15);
/// ```
pub fn root<F: Float>(mut bracket: Bracket<F>, mut of: impl FnMut(F) -> [F; 2]) -> F {
    let mut x = bracket.middle();
    let small = bracket.width() * F::EPSILON.times(4.0);
    for _ in 0..60 {
        let [value, slope] = of(x);
        bracket.narrow(x, value);
        let next = bracket.guarded(x - value / slope);
        let moved = (next - x).abs();
        x = next;
        // At the other end the sign is known: steps of rounding would go to and fro.
        let known = next == bracket.negative || next == bracket.positive;
        if known || moved <= small.max(bracket.width() * F::EPSILON.sqrt()) {
            break;
        }
    }
    x
}
