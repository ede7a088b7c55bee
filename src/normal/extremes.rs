//! Extremes and roots of the cubics that a smoothed profile consists of, with their derivatives.

use crate::number::{Arithmetic, Dual, Float};
use crate::numerics::bracket::{Bracket, root};
use crate::numerics::hermite::Cubic;

/// Share of the larger of a cubic's ends below which its extremes are those of the function that it
/// stands for; from twice this share on they are its own.
const NEAR_ZERO: f64 = 0.1;
/// Rounds that find an extreme, and how far it is from its place at last, over the length.
const EXTREME_ROUNDS: u32 = 20;
const EXTREME_FOUND: f64 = 1e-9;

/// An extreme of the function that the cubic stands for where its value is near zero, where its
/// sign depends on how exactly its place is known; that of the cubic elsewhere, and between both a
/// place between them. The extreme of the function is sought half way to the cubic's inflection, so
/// that it moves without a jump from where the cubic has one.
pub(super) fn refined<F: Float, const N: usize>(
    cubic: &Cubic<Dual<F, N>>, length: F, mut cut: Dual<F, N>,
    exact: impl Fn(Dual<F, N>) -> [Dual<F, N>; 2],
) -> Dual<F, N> {
    let Cubic(c) = cubic;
    let [c0, .., c2, c3] = c.map(|c| c.value);
    let (value, end) = (cubic.value_at(cut).value, cubic.value_at(Dual::from_base(length)).value);
    let near = value.abs() / ((c0.abs() + end.abs()).times(NEAR_ZERO) + F::TINY);
    let share = (F::constant(2.0) - near).clamped(F::zero(), F::one());
    let bend = c2.times(2.0) + (c3 * cut.value).times(6.0);
    if !(share > F::zero() && cut.value > F::zero() && cut.value < length && bend != F::zero()) {
        return cut;
    }
    // rises through the extreme
    let steepness = |t: F| {
        let [_, slope] = exact(Dual::from_base(t));
        if bend < F::zero() { -slope.value } else { slope.value }
    };
    let from = cut.value;
    let reach = (bend / c3).abs().times(1.0 / 12.0).min(length);
    let mut before = steepness(from);
    let mut t =
        if before < F::zero() { (from + reach).min(length) } else { (from - reach).max(F::zero()) };
    let mut slope = steepness(t);
    if (before < F::zero()) != (slope < F::zero()) {
        let close = length * F::of(EXTREME_FOUND).max(F::EPSILON.times(8.0));
        let mut last = from;
        let mut bracket = Bracket { negative: from, positive: from };
        for (place, slope) in [(from, before), (t, slope)] {
            bracket.narrow(place, slope);
        }
        for _ in 0..EXTREME_ROUNDS {
            let ahead = slope * ((t - last) / (slope - before));
            if !ahead.is_finite_number() || ahead.abs() <= close {
                break;
            }
            (last, before, t) = (t, slope, bracket.guarded(t - ahead));
            slope = steepness(t);
            bracket.narrow(t, slope);
        }
    }
    cut.value = from + (t - from) * share;
    cut
}

/// The places of the beginning, the two extremes and the end of a cubic of some length. In the
/// place of extremes that are none there is twice the point of inflection, from which they come.
pub(super) fn cuts<F: Float, const N: usize>(
    cubic: &Cubic<Dual<F, N>>, length: Dual<F, N>,
) -> [Dual<F, N>; 4] {
    let zero = Dual::zero();
    let Cubic([_, c1, c2, c3]) = *cubic;
    // c₁ + 2 c₂ t + 3 c₃ t² = 0 without cancellation
    let root = (c2.squared() - c1 * c3.times(3.0)).value;
    let mut cuts = [zero, zero, length, length];
    if root > F::zero() {
        let root = root.sqrt();
        let half = c2.value;
        let q = if half < F::zero() { root - half } else { -root - half };
        let inside = |t: F| {
            let moves = if t > F::zero() && t < length.value { t } else { return zero };
            // dt = −(dc₁ + 2 t dc₂ + 3 t² dc₃)/(2 c₂ + 6 c₃ t)
            let bend = half.times(2.0) + (c3.value * t).times(6.0);
            let steep = if bend.abs() > F::TINY { F::one() / bend } else { F::zero() };
            let t = Dual::from_base(moves);
            let moved = cubic.slope(t).gradient;
            Dual { value: moves, gradient: moved.map(|moved| -(moved * steep)) }
        };
        let (one, two) = (inside(c1.value / q), inside(q / c3.value.times(3.0)));
        cuts = [zero, one.min(two), one.max(two), length];
    } else if c3.value.abs() > F::TINY {
        let inflection = -(c2 / c3.times(3.0));
        if inflection.value > F::zero() && inflection.value < length.value {
            cuts = [zero, inflection, inflection, length];
        }
    }
    cuts
}

/// The place where a function is zero between two places of different sign, with its derivative.
pub(super) fn zero_of<F: Float, const N: usize>(
    of: impl Fn(Dual<F, N>) -> [Dual<F, N>; 2], negative: F, positive: F,
) -> Dual<F, N> {
    let plain = |t: F| of(Dual::from_base(t)).map(|x| x.value);
    let t = root(Bracket { negative, positive }, plain);
    let [value, slope] = of(Dual::from_base(t));
    // the width of a zone that just appears grows infinitely fast, and the zone carries nothing
    let steep = if slope.value.abs() > F::TINY { F::one() / slope.value } else { F::zero() };
    Dual { value: t, gradient: value.gradient.map(|d| -(d * steep)) }
}
