//! The smoothed distance of two surfaces that move: its derivatives in some directions.

use crate::normal::parabola::{around, near_points, spacings_at_ends, with_ridge};
use crate::normal::profile::Profile;
use crate::normal::profile::{Moves, TOGETHER};
use crate::normal::smooth::{SmoothedProfile, low_level};
use crate::number::avx::with_avx;
use crate::number::{Arithmetic, Dual, Float, add_at, at};
use core::cell::Cell;

/// A number with its derivatives.
pub(crate) type Directed<F> = Dual<F, TOGETHER>;

/// Points whose derivatives are kept while neighbouring knots need them.
const KEPT_POINTS: usize = 32;

/// The number of a point, with the derivatives of its place and distance.
type Kept<F> = (usize, [[F; TOGETHER]; 2]);

/// A profile that moves, and a smoothing length.
struct Moving<'a, F> {
    profile: &'a Profile<'a, F>,
    points: &'a dyn Moves<F>,
    /// Height from which a point does not count, and one over the distance over which it fades.
    none: F,
    per_fade: F,
    length: F,
    kept: [Cell<Option<Kept<F>>>; KEPT_POINTS],
}

impl<'a, F: Float> Moving<'a, F> {
    #[inline]
    fn new(profile: &'a Profile<'a, F>, points: &'a dyn Moves<F>, length: F) -> Self {
        let [full, none] = profile.fade.unwrap_or([F::zero(); 2]);
        Self {
            profile,
            points,
            none: none - profile.lowest,
            per_fade: F::one() / (none - full),
            length,
            kept: [const { Cell::new(None) }; KEPT_POINTS],
        }
    }

    /// The place of a point, and its distance above the lowest point, which does not move.
    #[inline]
    fn point(&self, k: usize) -> [Directed<F>; 2] {
        let Profile { y, distance, lowest, .. } = self.profile;
        let k = k.min(y.len().saturating_sub(1));
        let kept = self.kept.get(k % KEPT_POINTS);
        let [moved, lifted] = match kept.and_then(Cell::get) {
            Some((known, moves)) if known == k => moves,
            _ => {
                let [moved, lifted, ..] = self.points.moves_of_point(k);
                let moves = [moved, lifted];
                if let Some(kept) = kept {
                    kept.set(Some((k, moves)));
                }
                moves
            }
        };
        let height = at(distance, k) - *lowest;
        [Dual { value: at(y, k), gradient: moved }, Dual { value: height, gradient: lifted }]
    }

    #[inline]
    fn place_of_point(&self, k: usize) -> Directed<F> {
        let [place, _] = self.point(k);
        place
    }

    /// As the [`parabola`](super::parabola) has it.
    #[inline(always)]
    fn spacing(&self, place: Directed<F>, next: usize) -> Directed<F> {
        let y = around(next, self.profile.y.len().saturating_sub(1), |k| self.place_of_point(k));
        let [_, _, from, to, _, _] = y;
        let [before, after] = spacings_at_ends(y);
        before + (place - from) / (to - from) * (after - before)
    }

    /// Height and slope of the curve at a place.
    #[inline(always)]
    fn height_and_slope(&self, place: Directed<F>) -> [Directed<F>; 2] {
        let before = |y: F| self.profile.y.partition_point(|own| *own < y);
        let next = before(place.value);
        let spacing = self.spacing(place, next);
        let length = spacing.squared().shift(self.length * self.length).sqrt();
        let inverse = length.inverse();
        let [begin, end] = [place.value - length.value, place.value + length.value].map(before);
        let (mut m, mut s) = ([Directed::zero(); 5], [Directed::zero(); 3]);
        for k in begin..end {
            let [y, height] = self.point(k);
            let x = (y - place) * inverse;
            let width = self.place_of_point(k + 1) - self.place_of_point(k.saturating_sub(1));
            let counts = (-height).shift(self.none).scale(self.per_fade);
            // w = (1 − x²)³ width u² (3 − 2 u)
            let rest = (F::one() - x.value * x.value).max(F::zero());
            let u = counts.value.clamped(F::zero(), F::one());
            let (share, rise) = (u * u * (F::of(3.0) - u.times(2.0)), (u - u * u).times(6.0));
            let (square, wide) = (rest * rest, width.value * share);
            let slopes = [
                -(x.value * square * wide).times(6.0),
                square * rest * share,
                square * rest * width.value * rise,
            ];
            let weight = Directed::composed(square * rest * wide, slopes, [x, width, counts]);
            // xʲ and its derivative
            let (mut power, mut slope) = (F::one(), F::zero());
            for (j, m) in m.iter_mut().enumerate() {
                let value = weight.value;
                let term = Directed::composed(value * power, [power, value * slope], [weight, x]);
                *m += term;
                add_at(&mut s, j, term * height);
                (power, slope) = (power * x.value, slope * x.value + power);
            }
        }
        let share = m[0] * inverse.times(35.0 / 64.0);
        let [height, slope, _] = with_ridge(m).coefficients(s);
        near_points(share, [height, slope * inverse], || {
            let next = next.min(self.profile.y.len().saturating_sub(1)).max(1);
            let ([from, low], [to, high]) = (self.point(next - 1), self.point(next));
            low + (place - from) / (to - from) * (high - low)
        })
    }

    /// Derivatives of the logarithm of the length over which the profile is low.
    fn stretch(&self) -> [F; TOGETHER] {
        let inverse = F::one() / (low_level(self.profile) + F::TINY);
        let mut length = Directed::tiny();
        for k in 1..self.profile.y.len() {
            let ([from, low], [to, high]) = (self.point(k - 1), self.point(k));
            let height = (low + high).times(0.5).shift(self.profile.lowest);
            let share = Directed::constant(2.0) - height.scale(inverse);
            if share.value > F::zero() {
                length += share.min(Directed::one()) * (to - from);
            }
        }
        length.gradient.map(|rate| rate / length.value)
    }
}

impl<F: Float> SmoothedProfile<F, TOGETHER> {
    /// Gives a whole curve of surfaces the derivatives that it has as the points move.
    pub(crate) fn follow(&mut self, profile: &Profile<F>, points: &dyn Moves<F>, length: F) {
        let [first, last] = profile.ends;
        let length = length.min(last - first);
        (self.still, self.lowest) = (false, Directed::from_base(self.zero));
        with_avx!(if 1 => <F: Float>(
            curve: &mut SmoothedProfile<F, TOGETHER> = self,
            profile: &Profile<F>,
            points: &dyn Moves<F>,
            length: F
        ) -> () {
            curve.follow_points(&Moving::new(profile, points, length))
        })
    }

    #[inline(always)]
    fn follow_points(&mut self, moving: &Moving<'_, F>) {
        let Profile { ends, middle, y, .. } = moving.profile;
        let stretch = if self.is_wide { moving.stretch() } else { [F::zero(); TOGETHER] };
        for knot in &mut self.knots {
            let place = knot.y.value;
            knot.y.gradient = match ends.map(|end| end == place) {
                [true, _] => moving.place_of_point(0).gradient,
                [_, true] => moving.place_of_point(y.len()).gradient,
                _ => stretch.map(|rate| rate * (place - *middle)),
            };
            let [height, slope] = moving.height_and_slope(knot.y);
            (knot.height.gradient, knot.slope.gradient) = (height.gradient, slope.gradient);
        }
    }
}
