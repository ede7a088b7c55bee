//! A smoothed profile: local parabolas, and cubics between them.
//!
//! Each knot of an even grid has the value and the slope of the parabola that fits the points
//! around best. The weight of a point is `(1 − x²)³`, where `x` is its distance over the smoothing
//! length `s`, times the length that it stands for. A cubic joins two knots. A profile that is a
//! parabola is not changed, wherever its points lie.

use crate::normal::extremes::cuts;
use crate::normal::knot_grid::Grid;
use crate::normal::parabola::{LEAST_SPACINGS, Parabola, near_points, parabola};
use crate::normal::profile::Profile;
use crate::number::{Arithmetic, Dual, Float, pairs};
use crate::numerics::hermite::Cubic;
use heapless::Vec;

/// Largest number of knots.
const KNOTS: usize = if cfg!(target_os = "none") { 40 } else { 160 };
/// Largest number of pieces of a whole profile; the step of the knots is not smaller.
const PIECES: f64 = 4096.0;
/// Smoothing length of wide contacts \[m\].
const WIDE_LENGTH: f64 = 2e-3;
/// `1/(2√3)`
const GAUSS: f64 = 0.288_675_134_594_812_9;
/// Smoothing length of narrow contacts over their width.
const NARROW_LENGTH: f64 = 0.5;

/// Depth of the curve below the lowest of the points around, over the range of their distances.
const FALL: f64 = 0.35;

/// Share of the knots that the low part of a profile takes at most; others are for its margins.
const LOW_SHARE: f64 = 0.7;
/// Distance up to which surfaces are certainly low, over that from which points do not count.
const LOW_DISTANCE: f64 = 0.1;
/// Number of knots in a smoothing length.
const KNOTS_TO_A_LENGTH: f64 = 5.0;
/// The same of the distance of surfaces.
const KNOTS_OF_SURFACES: f64 = 2.8;

/// A place with the height and slope of the smoothed profile.
#[derive(Clone, Copy, Debug)]
pub(super) struct Knot<F, const N: usize> {
    /// Moves with the smoothing length.
    pub y: Dual<F, N>,
    pub height: Dual<F, N>,
    pub slope: Dual<F, N>,
    /// Whether a piece joins this knot to the one before.
    pub joined: bool,
}

/// The smoothed profile where contact is likely.
#[derive(Clone, Debug)]
pub(crate) struct SmoothedProfile<F, const N: usize> {
    pub(super) knots: Vec<Knot<F, N>, KNOTS>,
    /// Its lowest point.
    pub(super) lowest: Dual<F, N>,
    /// Where the distance is zero, above the lowest point of the profile.
    pub(super) zero: F,
    /// Numbers of the first knot that counts and of the one after the last.
    pub(super) range: [usize; 2],
    /// Ends of the profile.
    pub(super) ends: [F; 2],
    /// Smoothing length \[m\].
    pub(super) length: Dual<F, N>,
    /// Whether the steps of the knots are those of the length where the profile is low.
    pub(super) is_wide: bool,
    /// Whether the curve counts as constant, without derivatives.
    pub(super) still: bool,
}

/// The distance up to which surfaces are certainly low \[m\].
pub(super) fn low_level<F: Float>(profile: &Profile<F>) -> F {
    profile.fade.map_or(F::zero(), |[_, none]| none.times(LOW_DISTANCE))
}

/// The smoothing length: half the width of a narrow contact, 2 mm for a wide one.
pub(super) fn length_for<F: Float, const N: usize>(half_width: Dual<F, N>) -> Dual<F, N> {
    let narrow = half_width.times(2.0 * NARROW_LENGTH);
    let widest = Dual::from_base(F::of(WIDE_LENGTH));
    // (m⁻⁴ + c⁻⁴)^(−1/4)
    let (small, large) = (narrow.min(widest), narrow.max(widest));
    let ratio = (small / large).squared().squared();
    small / ratio.plus(1.0).sqrt().sqrt()
}

impl<F: Float, const N: usize> SmoothedProfile<F, N> {
    /// The curve of a profile smoothed over a length, where its points are less than `level` above
    /// the lowest.
    #[inline(never)]
    pub(super) fn new(profile: &Profile<F>, length: Dual<F, N>, level: Dual<F, N>) -> Self {
        let mut curve = Self::nothing(profile);
        let low = (level, profile.lowest);
        curve.choose_step(profile, length, KNOTS_TO_A_LENGTH, low, |curve, length, step| {
            curve.place_knots(profile, length, level.value, step)
        });
        curve.lowest = curve.lowest_between(|_| true);
        curve
    }

    /// The lowest value of the curve at its extremes and knots that count by their places.
    pub(super) fn lowest_between(&self, counts: impl Fn(F) -> bool) -> Dual<F, N> {
        let mut lowest = Dual::from_base(F::LARGEST);
        let of = |knot: &Knot<F, N>| [knot.height, knot.slope];
        self.pieces(of, |knot, cubic, length| {
            for t in cuts(cubic, length) {
                if counts(knot.y.value + t.value) {
                    lowest = lowest.min(cubic.value_at(t));
                }
            }
        });
        lowest
    }

    /// The curve of the distance of two surfaces, smoothed over a length, wherever they overlap. It
    /// does not move with the approach. (Out of line, and written where it stays: a copy would take
    /// room on the stack.)
    #[inline(never)]
    pub(crate) fn of_surfaces(profile: &Profile<F>, length: F) -> Self {
        let mut curve = Self::nothing(profile);
        let length = Dual::from_base(length);
        let low = (Dual::from_base(low_level(profile)), F::zero());
        curve.choose_step(profile, length, KNOTS_OF_SURFACES, low, |curve, length, step| {
            curve.place_knots_of_surfaces(profile, length, step)
        });
        (curve.still, curve.lowest) = (true, Dual::from_base(curve.zero));
        curve
    }

    /// A curve without knots.
    #[inline]
    fn nothing(profile: &Profile<F>) -> Self {
        Self {
            knots: Vec::new(),
            lowest: Dual::zero(),
            zero: -profile.lowest,
            range: [0, KNOTS],
            ends: profile.ends,
            length: Dual::zero(),
            is_wide: false,
            still: false,
        }
    }

    /// Has `place` set the knots for a smoothing length and a step; it returns whether there was
    /// room. The steps are wider where much of the profile is low, by a level above a distance,
    /// so that they need not be doubled at once.
    #[inline]
    fn choose_step(
        &mut self, profile: &Profile<F>, length: Dual<F, N>, knots: f64,
        (level, from): (Dual<F, N>, F),
        mut place: impl FnMut(&mut Self, Dual<F, N>, Dual<F, N>) -> bool,
    ) {
        let [first, last] = profile.ends;
        let whole = last - first;
        let length = length.min(Dual::from_base(whole));
        let floor = profile.step.times(LEAST_SPACINGS);
        // s² = s₀² + (2.5 steps)², about as the parabolas have it
        self.length = length.squared().shift(floor * floor).sqrt();
        let mut step = self.length.times(1.0 / knots);
        let least = Dual::from_base(whole.times(1.0 / PIECES));
        // a profile at the ends of the number range may be narrower than the least step
        step = step.max(least).max(Dual::tiny());
        let share = 1.0 / (KNOTS as f64 * LOW_SHARE);
        if whole.times(share) > step.value {
            let low = profile.low_length(level, from).times(share);
            self.is_wide = low.value > step.value;
            step = step.max(low);
        }
        while !place(self, length, step) && step.value < whole {
            step = step.times(2.0);
        }
    }

    /// Places knots where the profile is low. Returns whether there was room.
    fn place_knots(
        &mut self, profile: &Profile<F>, length: Dual<F, N>, level: F, step: Dual<F, N>,
    ) -> bool {
        self.knots.clear();
        let grid = Grid::new(profile, step);
        let [low_end, high_end] = grid.numbers;
        // of each piece the lowest and the highest point, with the points beside it
        let ranges = |take: &mut dyn FnMut(i32, F, F) -> bool| {
            let mut from = 0;
            for piece in low_end..high_end {
                let (begin, end) = (grid.knot_at(piece).value, grid.knot_at(piece + 1).value);
                let (mut low, mut high) = (F::LARGEST, -F::LARGEST);
                let mut k = from;
                while let (Some(y), Some(h)) = (profile.y.get(k), profile.distance.get(k)) {
                    if *y <= begin {
                        from = k;
                        (low, high) = (*h, *h);
                    } else {
                        low = low.min(*h);
                        high = high.max(*h);
                    }
                    if *y >= end {
                        break;
                    }
                    k += 1;
                }
                if !take(piece, low - profile.lowest, high - profile.lowest) {
                    return false;
                }
            }
            true
        };
        let mut bottom = F::LARGEST;
        ranges(&mut |_, _, high| {
            bottom = bottom.min(high);
            true
        });
        let mut next = low_end;
        let mut joined = false;
        let knots = &mut self.knots;
        ranges(&mut |piece, low, _| {
            if low > bottom + level {
                return true;
            }
            let wanted = (piece - 2).max(low_end);
            joined = joined && wanted <= next;
            for knot in wanted.max(next)..=(piece + 3).min(high_end) {
                let y = grid.knot_at(knot);
                let after = profile.y.partition_point(|place| *place < y.value);
                let Parabola { height, slope, .. } = parabola(profile, y, after, length);
                if knots.push(Knot { y, height, slope, joined }).is_err() {
                    return false;
                }
                joined = true;
                next = knot + 1;
            }
            true
        })
    }

    /// Places knots around wherever the curve may be negative. Returns whether there was room.
    fn place_knots_of_surfaces(
        &mut self, profile: &Profile<F>, length: Dual<F, N>, step: Dual<F, N>,
    ) -> bool {
        self.knots.clear();
        let grid = Grid::new(profile, step);
        let [low_end, high_end] = grid.numbers;
        // points may be farther apart than the steps
        let reach = step.value.times(KNOTS_OF_SURFACES * 1.25);
        let [.., none] = profile.fade.unwrap_or([F::zero(); 2]);
        // the first point from a number on that is not before a place
        let after = |mut k: usize, place: F| {
            while profile.y.get(k).is_some_and(|y| *y < place) {
                k += 1;
            }
            k
        };
        let mut from = 0;
        let mut may_be_below = |knot: i32| {
            let place = grid.knot_at(knot).value;
            from = after(from, place);
            let near = profile.distance.get(from.saturating_sub(1)..=from).unwrap_or(&[]);
            if near.iter().all(|distance| *distance > none) {
                return false;
            }
            let [low, high] = profile.range_near([place, reach, none], from);
            low - (high - low).times(FALL) < F::zero()
        };
        let mut first = 0;
        let (mut last, mut next) = (low_end - 1, low_end);
        for knot in low_end..=high_end {
            if !may_be_below(knot) {
                continue;
            }
            // with those before and after
            for own in (knot - 1).max(next)..=(knot + 1).min(high_end) {
                let (y, joined) = (grid.knot_at(own), last == own - 1 && own > low_end);
                first = after(first, y.value);
                let Parabola { height, slope, share } =
                    parabola(profile, y.value, first, length.value);
                let above = || profile.distance_at(y.value) - profile.lowest;
                let [height, slope] =
                    near_points(share, [height, slope], above).map(Dual::from_base);
                if self.knots.push(Knot { y, height, slope, joined }).is_err() {
                    return false;
                }
                (last, next) = (own, own + 1);
            }
        }
        true
    }

    /// Hands every piece to `take`, with the cubic of the value and slope that `of` gives at knots.
    pub(super) fn pieces(
        &self, of: impl Fn(&Knot<F, N>) -> [Dual<F, N>; 2],
        mut take: impl FnMut(&Knot<F, N>, &Cubic<Dual<F, N>>, Dual<F, N>),
    ) {
        for (knot, next) in pairs(&self.knots) {
            if next.joined {
                let ([from, slope], [to, end]) = (of(knot), of(next));
                let length = next.y - knot.y;
                take(knot, &Cubic::over(length, [from, to], [slope, end]), length);
            }
        }
    }

    /// Smoothing length \[m\].
    pub(super) fn smoothing(&self) -> Dual<F, N> {
        self.without_slopes_if_still(self.length)
    }

    pub(super) fn without_slopes_if_still(&self, x: Dual<F, N>) -> Dual<F, N> {
        if self.still { Dual::from_base(x.value) } else { x }
    }

    /// Place, height above the lowest point, and slope of a knot.
    pub(super) fn knot(&self, Knot { y, height, slope, .. }: &Knot<F, N>) -> [Dual<F, N>; 3] {
        [
            self.without_slopes_if_still(*y),
            self.without_slopes_if_still(*height - self.lowest),
            self.without_slopes_if_still(*slope),
        ]
    }

    /// Height over the inner part of a width: the mean of that of the middle and that over the
    /// width, which is the mean at both points of Gauss's rule.
    pub(super) fn over(&self, y: Dual<F, N>, width: Dual<F, N>) -> Dual<F, N> {
        let beside = width.times(GAUSS);
        (self.at(y - beside) + self.at(y + beside)).times(0.25) + self.at(y).times(0.5)
    }

    /// Height above the lowest point.
    pub(super) fn at(&self, y: Dual<F, N>) -> Dual<F, N> {
        let next = self.knots.partition_point(|knot| knot.y.value < y.value);
        let next = next.min(self.knots.len().saturating_sub(1)).max(1);
        match self.knots.get(next - 1..=next) {
            Some([knot, end]) => {
                let ([from, height, slope], [to, high, steep]) = (self.knot(knot), self.knot(end));
                Cubic::over(to - from, [height, high], [slope, steep]).value_at(y - from)
            }
            _ => Dual::from_base(F::zero()),
        }
    }
}
