//! The parabola that fits the points around a place best; the smoothed profile goes through it.
//!
//! The weight of a point is `(1 − x²)³`, where `x` is its distance over the smoothing length `s`,
//! times the length that it stands for.

use crate::normal::profile::{Profile, WithSlope};
use crate::number::avx::with_avx;
use crate::number::{Arithmetic, Float, Strips};

/// Smoothing length over the distance of neighbouring points, at least.
pub(crate) const STEPS: f64 = 2.5;

/// The parabola about a place.
pub(super) struct Parabola<F> {
    /// Above the lowest point of the profile \[m\].
    pub height: WithSlope<F>,
    pub slope: WithSlope<F>,
    /// Sum of the weights, over that of points everywhere within the smoothing length that all
    /// count fully.
    pub share: F,
}

/// The parabola about a place.
pub(super) fn parabola<F: Float>(
    profile: &Profile<F>,
    place: WithSlope<F>,
    length: WithSlope<F>,
) -> Parabola<F> {
    // s² = s₀² + (2.5 steps)²
    let length = (length.squared() + spacing(profile, place).squared()).sqrt();
    let y = place.value;
    let inverse = F::one() / length.value;
    let (moments, sums) = moments(profile, y, inverse);
    let [relative] = length.gradient.map(|d| d * inverse);
    let [shifted] = place.gradient.map(|d| d * inverse);
    // w = (1 − x²)³ = (1 − x²)² − x² (1 − x²)²; by ln s and by the place over s, x^k being what it
    // was: dw = 6 x² (1 − x²)², 6 x (1 − x²)²
    let of = |list: &[F], k: usize| {
        let at = |k: usize| list.get(k).copied().unwrap_or(F::zero());
        let (low, middle, high) = (at(k), at(k + 1), at(k + 2));
        WithSlope { value: low - high, gradient: [(high * relative + middle * shifted).times(6.0)] }
    };
    let m: [WithSlope<F>; 5] = core::array::from_fn(|k| of(&moments, k));
    let s: [WithSlope<F>; 3] = core::array::from_fn(|k| of(&sums, k));
    let [m0, m1, m2, m3, m4] = m;
    let [s0, s1, s2] = s;
    // (two points alone, where x² does not vary, make a line)
    let ridge = WithSlope::from_base(F::EPSILON.sqrt().times(0.1));
    let varies = (m0 * m4 - m2.squared()).max(WithSlope::zero()) * m0.squared().inverse();
    let m4 = m4 + m0 * ridge.squared() * (varies + ridge).inverse();
    let [c00, c01, c02] = [m2 * m4 - m3 * m3, m2 * m3 - m1 * m4, m1 * m3 - m2 * m2];
    let [c11, c12] = [m0 * m4 - m2 * m2, m1 * m2 - m0 * m3];
    let scale = (m0 * c00 + m1 * c01 + m2 * c02).inverse();
    let height = (s0 * c00 + s1 * c01 + s2 * c02) * scale;
    let slope = (s0 * c01 + s1 * c11 + s2 * c12) * scale;
    let bend = (s0 * c02 + s1 * c12 + s2 * (m0 * m2 - m1 * m1)) * scale;
    // the same parabola about the place that has moved
    let moved =
        |x: WithSlope<F>, slope: F| x + WithSlope { value: F::zero(), gradient: [slope * shifted] };
    let (height, slope) =
        (moved(height, slope.value), moved(slope, bend.value.times(2.0)).scale(inverse));
    // ∫ (1 − x²)³ dx = 32/35, and a point's length is that between its neighbours
    let share = m0.value * inverse.times(35.0 / 64.0);
    Parabola { height, slope, share }
}

/// `Σ w (1 − x²)² xᵏ` over the points with `|x| < 1`, `x` the distance from `y` times `inverse` and
/// `w` the length that a point stands for; and the same sums with the heights of the points.
fn moments<F: Float>(profile: &Profile<F>, y: F, inverse: F) -> ([F; 7], [F; 5]) {
    with_avx!(if 1 => <F: Float>(
        profile: &Profile<F> = profile,
        y: F = y,
        inverse: F = inverse
    ) -> ([F; 7], [F; 5]) {
        moments_in_fours::<F, F::Four>(profile, y, inverse)
    } {
        moments_in_fours::<F, F::WideFour>(profile, y, inverse)
    })
}

/// The same, four points side by side.
#[inline(always)]
fn moments_in_fours<F: Float, P: Strips<F>>(
    profile: &Profile<F>,
    y: F,
    inverse: F,
) -> ([F; 7], [F; 5]) {
    let (places, heights) = (profile.y, profile.distance);
    let (mut moments, mut sums) = ([P::zero(); 7], [P::zero(); 5]);
    let begin = places.partition_point(|place| (*place - y) * inverse <= -F::one());
    let end = places.partition_point(|place| (*place - y) * inverse < F::one());
    let (y, inverse, lowest) = (P::all(y), P::all(inverse), P::all(profile.lowest));
    let (one, zero) = (P::one(), P::zero());
    let fade = profile.fade.map(|[full, none]| {
        let none = none - profile.lowest;
        [P::all(none), P::all(F::one() / (none + profile.lowest - full))]
    });
    for first in (begin..end).step_by(4) {
        let x = (four::<F, P>(places, first) - y) * inverse;
        let before = if first > 0 {
            four::<F, P>(places, first - 1)
        } else {
            P::gather(|k| places.get(k.saturating_sub(1)).copied().unwrap_or(F::zero()))
        };
        let width = four::<F, P>(places, first + 1) - before;
        let height = four::<F, P>(heights, first) - lowest;
        let rest = (one - x.squared()).max(zero);
        let mut power = rest.squared() * width;
        if let Some([none, inverse]) = fade {
            let u = ((none - height) * inverse).max(zero).min(one);
            power = power * u.squared() * (P::constant(3.0) - u.times(2.0));
        }
        for (moment, sum) in moments.iter_mut().zip(&mut sums) {
            *moment += power;
            *sum += power * height;
            power = power * x;
        }
        let [.., fifth, sixth] = &mut moments;
        *fifth += power;
        *sixth += power * x;
    }
    (moments.map(P::total), sums.map(P::total))
}

/// Four numbers of a list; where it ends the last one again.
#[inline(always)]
fn four<F: Float, P: Strips<F>>(list: &[F], first: usize) -> P {
    match list.get(first..first + 4) {
        Some(four) => P::gather(|k| four.get(k).copied().unwrap_or(F::zero())),
        None => P::gather(|k| list.get(first + k).or(list.last()).copied().unwrap_or(F::zero())),
    }
}

/// 2.5 steps of the profile at `y`, straight between its points; at least 1.25 times the gap that
/// `y` lies in.
fn spacing<F: Float>(profile: &Profile<F>, place: WithSlope<F>) -> WithSlope<F> {
    let (places, y) = (profile.y, place.value);
    let last = places.len().saturating_sub(1);
    let next = places.partition_point(|place| *place < y).min(last).max(1);
    let at = |i: usize| places.get(i.min(last)).copied().unwrap_or(y);
    let of = |i: usize| {
        // (the mean of the gaps weighted with their lengths does not jump where two points merge)
        let (mut squares, mut length) = (F::zero(), F::TINY);
        for k in i.saturating_sub(2)..(i + 2).min(last) {
            let gap = at(k + 1) - at(k);
            squares += gap * gap;
            length += gap;
        }
        let even = squares / length;
        let gap = (at(i + 1) - at(i)).max(at(i) - at(i.saturating_sub(1)));
        even.times(STEPS).max(gap.times(0.5 * STEPS))
    };
    let (from, to) = (at(next - 1), at(next));
    let share = place.shift(-from).scale(F::one() / (to - from));
    let (before, after) = (of(next - 1), of(next));
    share.scale(after - before).shift(before)
}
