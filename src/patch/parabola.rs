//! The parabola that fits the points around a place best; the smoothed profile goes through it.
//!
//! The weight of a point is `(1 − x²)³`, where `x` is its distance over the smoothing length `s`, times the length that it stands for.

use crate::number::{Arithmetic, Float};
use crate::patch::section::{Moving, Profile};

/// Smoothing length over the distance of neighbouring points, at least.
pub(super) const STEPS: f64 = 2.5;

/// Height and slope of the parabola about a place.
pub(super) fn parabola<F: Float>(
    profile: &Profile<F>,
    place: Moving<F>,
    length: Moving<F>,
) -> (Moving<F>, Moving<F>) {
    // s² = s₀² + (2.5 steps)²
    let length = (length.squared() + spacing(profile, place).squared()).sqrt();
    let y = place.value;
    let inverse = F::one() / length.value;
    let (places, heights) = (profile.y, profile.distance);
    // Σ (1 − x²)² x^k over the points, and with their heights
    let mut moments = [F::zero(); 7];
    let mut sums = [F::zero(); 5];
    let begin = places.partition_point(|place| *place <= y - length.value);
    let first = places.get(begin.saturating_sub(1)).or(places.first());
    let mut before = first.copied().unwrap_or(y);
    let points = places.iter().zip(heights).enumerate().skip(begin);
    for (i, (place, height)) in points {
        let x = (*place - y) * inverse;
        if x >= F::one() {
            break;
        }
        let after = places.get(i + 1).copied().unwrap_or(*place);
        let width = after - before;
        before = *place;
        let rest = F::one() - x * x;
        let mut power = rest * rest * width;
        let height = *height - profile.lowest;
        for (moment, sum) in moments.iter_mut().zip(&mut sums) {
            *moment += power;
            *sum += power * height;
            power = power * x;
        }
        let [.., fifth, sixth] = &mut moments;
        *fifth += power;
        *sixth += power * x;
    }
    let [relative] = length.gradient.map(|d| d * inverse);
    let [shifted] = place.gradient.map(|d| d * inverse);
    // w = (1 − x²)³ = (1 − x²)² − x² (1 − x²)²; by ln s and by the place over s, x^k being what it was:
    // dw = 6 x² (1 − x²)², 6 x (1 − x²)²
    let of = |list: &[F], k: usize| {
        let at = |k: usize| list.get(k).copied().unwrap_or(F::zero());
        let (low, middle, high) = (at(k), at(k + 1), at(k + 2));
        Moving { value: low - high, gradient: [(high * relative + middle * shifted).times(6.0)] }
    };
    let m: [Moving<F>; 5] = core::array::from_fn(|k| of(&moments, k));
    let s: [Moving<F>; 3] = core::array::from_fn(|k| of(&sums, k));
    let [m0, m1, m2, m3, m4] = m;
    let [s0, s1, s2] = s;
    // (two points alone, where x² does not vary, make a line)
    let ridge = Moving::from_base(F::EPSILON.sqrt().times(0.1));
    let varies = (m0 * m4 - m2.squared()).max(Moving::zero()) * m0.squared().inverse();
    let m4 = m4 + m0 * ridge.squared() * (varies + ridge).inverse();
    let [c00, c01, c02] = [m2 * m4 - m3 * m3, m2 * m3 - m1 * m4, m1 * m3 - m2 * m2];
    let [c11, c12] = [m0 * m4 - m2 * m2, m1 * m2 - m0 * m3];
    let scale = (m0 * c00 + m1 * c01 + m2 * c02).inverse();
    let height = (s0 * c00 + s1 * c01 + s2 * c02) * scale;
    let slope = (s0 * c01 + s1 * c11 + s2 * c12) * scale;
    let bend = (s0 * c02 + s1 * c12 + s2 * (m0 * m2 - m1 * m1)) * scale;
    // the same parabola about the place that has moved
    let moved =
        |x: Moving<F>, slope: F| x + Moving { value: F::zero(), gradient: [slope * shifted] };
    let (height, slope) =
        (moved(height, slope.value), moved(slope, bend.value.times(2.0)).scale(inverse));
    (height, slope)
}

/// 2.5 steps of the profile at `y`, straight between its points; at least 1.25 times the gap that `y` lies in.
fn spacing<F: Float>(profile: &Profile<F>, place: Moving<F>) -> Moving<F> {
    let (places, y) = (profile.y, place.value);
    let last = places.len().saturating_sub(1);
    let next = places.partition_point(|place| *place < y).min(last).max(1);
    let at = |i: usize| places.get(i.min(last)).copied().unwrap_or(y);
    let of = |i: usize| {
        let (low, high) = (i.saturating_sub(2), (i + 2).min(last));
        let gaps = F::widened((high - low).max(1) as f32);
        let even = (at(high) - at(low)) / gaps;
        let gap = (at(i + 1) - at(i)).max(at(i) - at(i.saturating_sub(1)));
        even.times(STEPS).max(gap.times(0.5 * STEPS))
    };
    let (from, to) = (at(next - 1), at(next));
    let share = place.shift(-from).scale(F::one() / (to - from));
    let (before, after) = (of(next - 1), of(next));
    share.scale(after - before).shift(before)
}
