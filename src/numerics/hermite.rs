//! The cubic that has given values and slopes at two places (Hermite's interpolation).

use crate::number::{Arithmetic, Float, at, between};

/// `c₀ + c₁ u + c₂ u² + c₃ u³`.
#[derive(Clone, Copy, Debug)]
pub struct Cubic<T>(pub [T; 4]);

/// A number along a curve, with its first and second derivative.
#[derive(Clone, Copy, Debug)]
pub struct Along<T> {
    /// The number.
    pub value: T,
    /// Its first derivative.
    pub slope: T,
    /// Its second derivative.
    pub bend: T,
}

impl<T: Arithmetic> Cubic<T> {
    /// The cubic with these values and slopes at `u = 0` and `u = 1`.
    ///
    /// ```
    /// use kstrip::numerics::Cubic;
    /// let cubic = Cubic::new([0.0, 1.0], [0.0, 3.0]);
    /// assert_eq!(cubic.value_at(0.5), 0.125);
    /// let middle = cubic.along(0.5);
    /// assert_eq!([middle.value, middle.slope, middle.bend], [0.125, 0.75, 3.0]);
    /// ```
    #[inline]
    pub fn new([from, to]: [T; 2], [slope, last]: [T; 2]) -> Self {
        let rise = to - from;
        let cubic = slope + last - (rise + rise);
        Self([from, slope, rise - slope - cubic, cubic])
    }

    /// The cubic with these values and slopes at `u = 0` and at `u = length`.
    #[inline]
    pub fn over(length: T, values: [T; 2], slopes: [T; 2]) -> Self {
        let inverse = length.inverse();
        let Self([c0, c1, c2, c3]) = Self::new(values, slopes.map(|slope| slope * length));
        Self([c0, c1 * inverse, c2 * inverse.squared(), c3 * (inverse * inverse.squared())])
    }

    /// Its value.
    #[inline]
    pub fn value_at(&self, u: T) -> T {
        let Self([c0, c1, c2, c3]) = *self;
        c0 + u * (c1 + u * (c2 + u * c3))
    }

    /// Its derivative.
    #[inline]
    pub fn slope(&self, u: T) -> T {
        let Self([_, c1, c2, c3]) = *self;
        c1 + u * (c2 + c2 + (u * c3).times(3.0))
    }

    /// Its value with both derivatives.
    #[inline(always)]
    pub fn along(&self, u: T) -> Along<T> {
        let Self([c0, c1, c2, c3]) = *self;
        let (once, thrice) = (u * c3, (u * c3).times(3.0));
        Along {
            value: c0 + u * (c1 + u * (c2 + once)),
            slope: c1 + u * (c2 + c2 + thrice),
            bend: (c2 + thrice) + (c2 + thrice),
        }
    }
}

/// Numbers at a place between two points, on the cubic that has the slopes of the parabolas through
/// both and the next point on either side, where there is one.
///
/// ```text
/// p = p₁ + u (p₂ − p₁) − u (1 − u) h² ((1 − u) D₁ + u D₂)
/// D₂ = (p₃ − p₂ − (p₂ − p₁) d/h)/((h + d) max(d, least h)),   d = s₃ − s₂,   D₁ likewise
/// ```
///
/// A point beside that is closer than `least h` counts less, so that it may come out of an end.
/// Returned besides is `dp/du/h` of the last number.
#[inline]
pub(crate) fn between_parabolas<F: Float, const N: usize>(
    [(from, before), (to, after)]: [(F, [F; N]); 2], beside: [Option<(F, [F; N])>; 2], least: F,
    place: F,
) -> ([F; N], F) {
    let length = to - from + F::TINY;
    let share = ((place - from) / length).clamped(F::zero(), F::one());
    let rest = F::one() - share;
    let mut numbers = between(before, after, share);
    let mut rise = at(&after, N - 1) - at(&before, N - 1);
    // u (1 − u)² and u² (1 − u), and their derivatives
    let size = share * rest * length * length;
    let (falls, rises) = (rest * share.times(-3.0).plus(1.0), share * share.times(-3.0).plus(2.0));
    let ends = [(from, before, after, rest, falls), (to, after, before, share, rises)];
    for (beside, (end, near, far, weight, change)) in beside.into_iter().zip(ends) {
        let Some((place, outer)) = beside else { continue };
        let distance = (place - end).abs();
        let below = (length + distance) * distance.max(length * least);
        let weight = size * weight / below;
        let ratio = distance / length;
        let bend = |(outer, (near, far)): (F, (F, F))| outer - near - (near - far) * ratio;
        let pairs = outer.into_iter().zip(near.into_iter().zip(far));
        for (own, pair) in numbers.iter_mut().zip(pairs) {
            *own -= weight * bend(pair);
        }
        let last = [outer, near, far].map(|own| at(&own, N - 1));
        rise -= change * length * length / below * bend((last[0], (last[1], last[2])));
    }
    (numbers, rise / length)
}
