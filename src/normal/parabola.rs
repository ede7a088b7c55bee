//! The parabola that fits the points around a place best; the smoothed profile goes through it.
//!
//! The weight of a point is `(1 − x²)³`, where `x` is its distance over the smoothing length `s`,
//! times the length that it stands for.

use crate::normal::profile::Profile;
use crate::number::avx::with_avx;
use crate::number::{Arithmetic, Float, Strips};
use crate::numerics::parabola::NormalEquations;
use crate::numerics::smooth_step;
use core::ops::Range;

/// Smoothing length over the distance of neighbouring points, at least.
pub(crate) const LEAST_SPACINGS: f64 = 2.5;

/// The parabola about a place.
pub(super) struct Parabola<T: Arithmetic> {
    /// Above the lowest point of the profile \[m\].
    pub height: T,
    pub slope: T,
    /// Sum of the weights, over that of points all along the smoothing length that count fully.
    pub share: T::Value,
}

/// The parabola about a place; `next` is the number of the first point that is not before it.
pub(super) fn parabola<F: Float, T: Arithmetic<Value = F>>(
    profile: &Profile<F>, place: T, next: usize, length: T,
) -> Parabola<T> {
    // s² = s₀² + (2.5 steps)²
    let length = (length.squared() + spacing(profile, place, next).squared()).sqrt();
    let inverse = F::one() / length.value();
    let y = place.value();
    let is_inside =
        |k: usize| profile.y.get(k).is_some_and(|y_k| ((*y_k - y) * inverse).abs() < F::one());
    let (mut begin, mut end) = (next, next);
    while begin > 0 && is_inside(begin - 1) {
        begin -= 1;
    }
    while is_inside(end) {
        end += 1;
    }
    let (moments, sums) = Near { profile, y, inverse, points: begin..end }.moments();
    // w = (1 − x²)³ = (1 − x²)² − x² (1 − x²)²; by ln s and by the place over s, x^k being what it
    // was: dw = 6 x² (1 − x²)², 6 x (1 − x²)²
    let six = inverse.times(6.0);
    let of = |list: &[F], k: usize| {
        let at = |k: usize| list.get(k).copied().unwrap_or(F::zero());
        let (low, middle, high) = (at(k), at(k + 1), at(k + 2));
        T::composed(low - high, [high * six, middle * six], [length, place])
    };
    let m: [T; 5] = core::array::from_fn(|k| of(&moments, k));
    // ∫ (1 − x²)³ dx = 32/35, and a point's length is that between its neighbours
    let share = m[0].value() * inverse.times(35.0 / 64.0);
    let equations = with_ridge(m);
    let [height, slope, bend] = equations.coefficients([0, 1, 2].map(|k| of(&sums, k)));
    // the same parabola about the place that has moved
    let moved = |x: T, slope: F| T::composed(x.value(), [F::one(), slope * inverse], [x, place]);
    let (height, slope) =
        (moved(height, slope.value()), moved(slope, bend.value().times(2.0)).scale(inverse));
    Parabola { height, slope, share }
}

/// The normal equations; two points alone, where `x²` does not vary, make a line.
#[inline]
pub(super) fn with_ridge<F: Float, T: Arithmetic<Value = F>>(mut m: [T; 5]) -> NormalEquations<T> {
    let ridge = T::from_base(F::EPSILON.sqrt().times(0.1));
    let [m0, _, m2, _, m4] = &mut m;
    let varies = (*m0 * *m4 - m2.squared()).max(T::zero()) * m0.squared().inverse();
    *m4 += *m0 * ridge.squared() * (varies + ridge).inverse();
    NormalEquations::of_moments(m)
}

/// Height and slope of the curve: where hardly a point counts, by its share, it follows the points,
/// whose height is `above`.
#[inline]
pub(super) fn near_points<F: Float, T: Arithmetic<Value = F>>(
    share: T, [height, slope]: [T; 2], above: impl FnOnce() -> T,
) -> [T; 2] {
    let t = share.plus(-0.45).times(5.0).max(T::zero()).min(T::one());
    if t.value() >= F::one() {
        return [height, slope];
    }
    let (t, above) = (smooth_step(t), above());
    if t.value() > F::zero() {
        [above + (height - above) * t, slope * t]
    } else {
        [above, T::zero()]
    }
}

/// Points of a profile near a place `y`: `|x| < 1` for their distance `x` from it times `inverse`.
struct Near<'a, F> {
    profile: &'a Profile<'a, F>,
    y: F,
    inverse: F,
    points: Range<usize>,
}

impl<F: Float> Near<'_, F> {
    /// `Σ w (1 − x²)² xᵏ` with the length `w` that a point stands for, and the same sums with the
    /// heights of the points.
    fn moments(&self) -> ([F; 7], [F; 5]) {
        with_avx!(if 1 => <F: Float>(near: &Near<'_, F> = self) -> ([F; 7], [F; 5]) {
            near.in_fours::<F::Four>()
        } {
            near.in_fours::<F::WideFour>()
        })
    }

    /// The same, four points side by side.
    #[inline(always)]
    fn in_fours<P: Strips<F>>(&self) -> ([F; 7], [F; 5]) {
        let Self { profile, y, inverse, ref points } = *self;
        let (places, heights) = (profile.y, profile.distance);
        let (mut moments, mut sums) = ([P::zero(); 7], [P::zero(); 5]);
        let (y, inverse, lowest) = (P::all(y), P::all(inverse), P::all(profile.lowest));
        let (one, zero) = (P::one(), P::zero());
        let fade = profile.fade.map(|[full, none]| {
            let none = none - profile.lowest;
            [P::all(none), P::all(F::one() / (none + profile.lowest - full))]
        });
        for first in points.clone().step_by(4) {
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
}

/// Four numbers of a list; where it ends the last one again.
#[inline]
fn four<F: Float, P: Strips<F>>(list: &[F], first: usize) -> P {
    match list.get(first..first + 4) {
        Some(four) => P::gather(|k| four.get(k).copied().unwrap_or(F::zero())),
        None => P::gather(|k| list.get(first + k).or(list.last()).copied().unwrap_or(F::zero())),
    }
}

/// 2.5 steps of the profile, straight between its points; at least 1.25 times the gap at `place`.
fn spacing<F: Float, T: Arithmetic<Value = F>>(profile: &Profile<F>, place: T, next: usize) -> T {
    let last = profile.y.len().saturating_sub(1);
    let y = around(next, last, |k| profile.y.get(k).copied().unwrap_or(place.value()));
    let [_, _, from, to, _, _] = y;
    let [before, after] = spacings_at_ends(y);
    let share = place.shift(-from).scale(F::one() / (to - from));
    share.scale(after - before).shift(before)
}

/// Six points, from the third before the next one to the second after it, of a list with this last.
#[inline]
pub(super) fn around<T>(next: usize, last: usize, of: impl Fn(usize) -> T) -> [T; 6] {
    let next = next.min(last).max(1);
    core::array::from_fn(|k| of((next + k).saturating_sub(3).min(last)))
}

/// The spacing at the third and at the fourth of six points.
#[inline]
pub(super) fn spacings_at_ends<T: Arithmetic>(y: [T; 6]) -> [T; 2] {
    let gaps: [T; 5] = core::array::from_fn(|k| match y.get(k..k + 2) {
        Some([from, to]) => *to - *from,
        _ => T::zero(),
    });
    let [one, two, three, four, five] = gaps;
    [[one, two, three, four], [two, three, four, five]].map(|gaps| {
        // the mean of the gaps weighted with their lengths does not jump where two points merge
        let (mut squares, mut length) = (T::zero(), T::tiny());
        for gap in gaps {
            squares += gap.squared();
            length += gap;
        }
        let [_, before, after, _] = gaps;
        (squares / length).times(LEAST_SPACINGS).max(after.max(before).times(0.5 * LEAST_SPACINGS))
    })
}
