//! A smoothed profile: local parabolas, and cubics between them.
//!
//! Each knot of an even grid has the value and the slope of the parabola that fits the points
//! around best. The weight of a point is `(1 − x²)³`, where `x` is its distance over the smoothing
//! length `s`, times the length that it stands for. A cubic joins two knots. A profile that is a
//! parabola is not changed, wherever its points lie.

use crate::normal::density::Zones;
use crate::normal::parabola::{STEPS, parabola};
use crate::normal::profile::{Profile, WithSlope};
use crate::number::{Arithmetic, Float};
use heapless::Vec;

/// Largest number of knots.
const KNOTS: usize = if cfg!(target_os = "none") { 40 } else { 160 };
/// Largest number of pieces of a whole profile; the step of the knots is not smaller.
const PIECES: f64 = 4096.0;
/// Smoothing length of wide contacts \[m\].
const WIDEST: f64 = 2e-3;
/// Smoothing length of narrow contacts over their width.
const SHARE: f64 = 0.5;

/// Number of knots in a smoothing length.
const KNOTS_TO_A_LENGTH: f64 = 5.0;
/// Where the last piece is shorter than this share of the others, the one before ends the profile.
const STUB: f64 = 1e-3;

/// A place with the height and slope of the smoothed profile.
#[derive(Clone, Copy, Debug)]
pub(super) struct Knot<F> {
    /// Moves with the smoothing length.
    pub y: WithSlope<F>,
    pub height: WithSlope<F>,
    pub slope: WithSlope<F>,
    /// Whether a piece joins this knot to the one before.
    joined: bool,
}

/// `c₀ + c₁ t + c₂ t² + c₃ t³` over `t` from 0 to a length.
#[derive(Clone, Copy)]
struct Cubic<F> {
    c: [WithSlope<F>; 4],
    length: WithSlope<F>,
}

impl<F: Float> Cubic<F> {
    fn new(
        length: WithSlope<F>,
        [from, slope]: [WithSlope<F>; 2],
        [to, end]: [WithSlope<F>; 2],
    ) -> Self {
        let inverse = length.inverse();
        let rise = (to - from) * inverse;
        let c2 = (rise.times(3.0) - slope.times(2.0) - end) * inverse;
        let c3 = (slope + end - rise.times(2.0)) * inverse.squared();
        Self { c: [from, slope, c2, c3], length }
    }

    fn at(&self, t: WithSlope<F>) -> WithSlope<F> {
        let [c0, c1, c2, c3] = self.c;
        c0 + t * (c1 + t * (c2 + t * c3))
    }

    fn slope(&self, t: WithSlope<F>) -> WithSlope<F> {
        let [_, c1, c2, c3] = self.c;
        c1 + t * (c2.times(2.0) + t * c3.times(3.0))
    }

    /// The places of the beginning, the two extremes and the end.
    fn cuts(&self) -> [WithSlope<F>; 4] {
        let (length, zero) = (self.length, WithSlope::zero());
        let [_, c1, c2, c3] = self.c;
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
                let t = WithSlope::from_base(moves);
                let [moved] = self.slope(t).gradient;
                WithSlope { value: moves, gradient: [-(moved * steep)] }
            };
            let (one, two) = (inside(c1.value / q), inside(q / c3.value.times(3.0)));
            cuts = [zero, one.min(two), one.max(two), length];
        }
        cuts
    }
}

/// The smoothed profile where contact is likely.
#[derive(Clone, Debug)]
pub(super) struct Curve<F> {
    pub knots: Vec<Knot<F>, KNOTS>,
    /// Its lowest point.
    pub lowest: WithSlope<F>,
    /// Ends of the profile.
    ends: [F; 2],
    /// Smoothing length \[m\].
    length: WithSlope<F>,
    /// Whether the curve counts as constant, without its derivatives by load or approach.
    pub still: bool,
}

/// The smoothing length without regard to the points: half the width of a narrow contact, 2 mm of a
/// wide one.
pub(super) fn length_for<F: Float>(half_width: WithSlope<F>) -> WithSlope<F> {
    let narrow = half_width.times(2.0 * SHARE);
    let widest = WithSlope::from_base(F::of(WIDEST));
    // (m⁻⁴ + c⁻⁴)^(−1/4)
    let (small, large) = (narrow.min(widest), narrow.max(widest));
    let ratio = (small / large).squared().squared();
    small / ratio.plus(1.0).sqrt().sqrt()
}

impl<F: Float> Curve<F> {
    /// The curve of a profile smoothed over a length, where its points are less than `level` above
    /// the lowest.
    #[inline(never)]
    pub fn new(profile: &Profile<F>, length: WithSlope<F>, level: F) -> Self {
        let [first, last] = profile.ends;
        let whole = last - first;
        let length = length.min(WithSlope::from_base(whole));
        let floor = profile.step.times(STEPS);
        // s² = s₀² + (2.5 steps)², about as the parabolas have it
        let smooth = length.squared().shift(floor * floor).sqrt();
        let mut step = smooth.times(1.0 / KNOTS_TO_A_LENGTH);
        let least = WithSlope::from_base(whole.times(1.0 / PIECES));
        step = step.max(least);
        let lowest = WithSlope::from_base(F::zero());
        let mut curve =
            Self { knots: Vec::new(), lowest, ends: profile.ends, length: smooth, still: false };
        while !curve.fill(profile, length, level, step) && step.value < whole {
            step = step.times(2.0);
        }
        let mut lowest = WithSlope::from_base(F::LARGEST);
        curve.pieces(
            |knot| [knot.height, knot.slope],
            |_, cubic| {
                for t in cubic.cuts() {
                    lowest = lowest.min(cubic.at(t));
                }
            },
        );
        curve.lowest = lowest;
        curve
    }

    /// Places knots where the profile is low: at equal steps to both sides of its middle, and at
    /// its ends. Returns whether there was room.
    fn fill(
        &mut self,
        profile: &Profile<F>,
        length: WithSlope<F>,
        level: F,
        step: WithSlope<F>,
    ) -> bool {
        self.knots.clear();
        let ([from, to], middle) = (profile.ends, profile.middle);
        // numbers of the knots next to the ends, which are knots themselves
        let number = |end: F, outward: f64| {
            let steps = (end - middle) / step.value;
            let inside = steps.plus(-STUB * outward);
            let whole = F::widened(inside.whole() as f32);
            // (the whole part is rounded toward zero)
            let short = (inside - whole).times(outward) < F::zero();
            inside.whole() + if short { 0 } else { outward as i32 }
        };
        let (low_end, high_end) = (number(from, -1.0), number(to, 1.0));
        let at = |knot: i32| {
            if knot <= low_end {
                WithSlope::from_base(from)
            } else if knot >= high_end {
                WithSlope::from_base(to)
            } else {
                step.scale(F::widened(knot as f32)).shift(middle)
            }
        };
        // of each piece the lowest and the highest point, with the points beside it
        let ranges = |take: &mut dyn FnMut(i32, F, F) -> bool| {
            let mut from = 0;
            for piece in low_end..high_end {
                let (begin, end) = (at(piece).value, at(piece + 1).value);
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
                let y = at(knot);
                let (height, slope) = parabola(profile, y, length);
                if knots.push(Knot { y, height, slope, joined }).is_err() {
                    return false;
                }
                joined = true;
                next = knot + 1;
            }
            true
        })
    }

    /// Hands every piece to `take`, with the cubic through the value and the slope that `of` gives
    /// at its knots.
    fn pieces(
        &self,
        of: impl Fn(&Knot<F>) -> [WithSlope<F>; 2],
        mut take: impl FnMut(&Knot<F>, &Cubic<F>),
    ) {
        for (knot, next) in self.knots.iter().zip(self.knots.iter().skip(1)) {
            if next.joined {
                take(knot, &Cubic::new(next.y - knot.y, of(knot), of(next)));
            }
        }
    }

    fn seen(&self, x: WithSlope<F>) -> WithSlope<F> {
        if self.still { WithSlope::from_base(x.value) } else { x }
    }

    /// Place, height above the lowest point, and slope of a knot.
    fn knot(&self, Knot { y, height, slope, .. }: &Knot<F>) -> [WithSlope<F>; 3] {
        [self.seen(*y), self.seen(*height - self.lowest), self.seen(*slope)]
    }

    /// Height above the lowest point.
    pub fn at(&self, y: WithSlope<F>) -> WithSlope<F> {
        let next = self.knots.partition_point(|knot| knot.y.value < y.value);
        let next = next.min(self.knots.len().saturating_sub(1)).max(1);
        match self.knots.get(next - 1..=next) {
            Some([knot, end]) => {
                let ([from, height, slope], [to, high, steep]) = (self.knot(knot), self.knot(end));
                Cubic::new(to - from, [height, slope], [high, steep]).at(y - from)
            }
            _ => WithSlope::from_base(F::zero()),
        }
    }

    /// The zones where a function is negative; returns whether one of them ends with the profile.
    /// `of` gives the value and the slope of the function from a place, the height there and its
    /// slope. Depths are measured with the approach. (The zones are written where they stay: a copy
    /// would take room on the stack.)
    pub fn zones(
        &self,
        approach: WithSlope<F>,
        zones: &mut Zones<F>,
        of: impl Fn(WithSlope<F>, WithSlope<F>, WithSlope<F>) -> [WithSlope<F>; 2],
    ) -> bool {
        zones.clear(approach, self.seen(self.length));
        let [start, finish] = self.ends;
        let mut at_end = false;
        let at = |knot: &Knot<F>| {
            let [y, height, slope] = self.knot(knot);
            of(y, height, slope)
        };
        let mut last: Option<(WithSlope<F>, [WithSlope<F>; 2])> = None;
        let next = self.knots.iter().skip(1).map(Some).chain([None]);
        for (knot, next) in self.knots.iter().zip(next) {
            let own = match last {
                Some((_, own)) if knot.joined => own,
                _ => at(knot),
            };
            if !knot.joined {
                zones.end();
                if own[0].value < F::zero() {
                    zones.begin(self.seen(knot.y), own);
                    at_end = at_end || knot.y.value <= start;
                }
            }
            last = Some((self.seen(knot.y), own));
            let Some(next) = next.filter(|next| next.joined) else { continue };
            let end = at(next);
            last = Some((self.seen(next.y), end));
            // no cubic falls farther below its ends
            let ([y, height, slope], [next_y, high, steep]) = (self.knot(knot), self.knot(next));
            let step = next_y - y;
            let fall = (slope.value.abs() + steep.value.abs()) * step.value.times(0.15);
            let least = own[0].value.min(end[0].value);
            if least > fall {
                continue;
            }
            // nor does it rise farther above them
            let rise = (own[1].value.abs() + end[1].value.abs()) * step.value.times(0.15);
            if zones.are_deep(own[0].value.max(end[0].value) + rise) {
                zones.pass(next_y, end);
                continue;
            }
            let heights = Cubic::new(step, [height, slope], [high, steep]);
            let exact = |t: WithSlope<F>| of(t + y, heights.at(t), heights.slope(t));
            // extremes of the profile, and those of the function as a cubic
            let ([zero, a, b, _], [_, c, d, length]) =
                (heights.cuts(), Cubic::new(step, own, end).cuts());
            let mut cuts = [a, b, c, d, length];
            for i in 1..cuts.len() {
                for k in (0..i).rev() {
                    if let Some([one, two]) = cuts.get_mut(k..k + 2)
                        && two.value < one.value
                    {
                        core::mem::swap(one, two);
                    }
                }
            }
            let (mut from, mut before) = (zero, own[0]);
            for to in cuts {
                if to.value <= from.value {
                    continue;
                }
                let after = if to.value < length.value { exact(to) } else { end };
                let (inside, stays) = (before.value < F::zero(), after[0].value < F::zero());
                if inside && !stays {
                    let end = root(exact, from.value, to.value);
                    zones.pass(end + y, exact(end));
                    zones.end();
                } else if stays && !inside {
                    let begin = root(exact, to.value, from.value);
                    zones.begin(begin + y, exact(begin));
                }
                if stays {
                    zones.pass(to + y, after);
                }
                (from, before) = (to, after[0]);
            }
        }
        if let Some((end, _)) = last {
            at_end = at_end || (zones.is_open() && end.value >= finish);
        }
        zones.end();
        at_end
    }
}

/// The place where a function is zero between two places of different sign, by Newton's steps
/// between brackets.
fn root<F: Float>(
    of: impl Fn(WithSlope<F>) -> [WithSlope<F>; 2],
    mut negative: F,
    mut positive: F,
) -> WithSlope<F> {
    let mut t = negative.times(0.5) + positive.times(0.5);
    let small = (positive - negative).abs() * F::EPSILON.times(4.0);
    for _ in 0..60 {
        let [value, slope] = of(WithSlope::from_base(t)).map(|x| x.value);
        if value < F::zero() {
            negative = t
        } else {
            positive = t
        }
        let next = t - value / slope;
        let between = (next - negative) * (next - positive) < F::zero();
        let next = if between { next } else { negative.times(0.5) + positive.times(0.5) };
        let moved = (next - t).abs();
        t = next;
        // (the step after this one would be as small as the square of it)
        if moved <= small.max((positive - negative).abs() * F::EPSILON.sqrt()) {
            break;
        }
    }
    let [value, slope] = of(WithSlope::from_base(t));
    // (the width of a zone that just appears grows infinitely fast, and carries nothing)
    let steep = if slope.value.abs() > F::TINY { F::one() / slope.value } else { F::zero() };
    WithSlope { value: t, gradient: value.gradient.map(|d| -(d * steep)) }
}
