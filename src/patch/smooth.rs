//! A smoothed profile: local parabolas, and cubics between them.
//!
//! Each knot of an even grid has the value and the slope of the parabola that fits the points around best. The weight of a point is
//! `(1 − x²)³`, where `x` is its distance over the smoothing length `s`, times the length that it stands for. A cubic joins two
//! knots. A profile that is a parabola is not changed, wherever its points lie.

use crate::number::{Arithmetic, Float};
use crate::patch::parabola::{STEPS, parabola};
use crate::patch::section::{Moving, Profile};
use heapless::Vec;

/// Largest number of knots.
const KNOTS: usize = if cfg!(target_os = "none") { 40 } else { 160 };
/// Largest number of zones of contact; further zones are joined with their neighbours.
pub(super) const ZONES: usize = if cfg!(target_os = "none") { 4 } else { 8 };
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

/// Depth of a zone over the approach, from which its cells are as narrow as those of other zones.
const WHOLE_ZONE: f64 = 0.075;
/// Height of a gap over the approach, from which it divides two deep zones entirely.
const WHOLE_GAP: f64 = 0.03;
/// Depth over the approach, of both zones together, at which half this height divides them.
const HALF_GAP: f64 = 0.03;

/// A place with the height and slope of the smoothed profile.
#[derive(Clone, Copy, Debug)]
pub(super) struct Knot<F> {
    /// Moves with the smoothing length.
    pub y: Moving<F>,
    pub height: Moving<F>,
    pub slope: Moving<F>,
    /// Whether a piece joins this knot to the one before.
    joined: bool,
}

/// A zone where a function is negative.
#[derive(Clone, Copy, Debug)]
pub(super) struct Zone<F> {
    /// Where it begins \[m\].
    pub from: Moving<F>,
    /// Where it ends \[m\].
    pub to: Moving<F>,
    /// How closely cells lie, between 0 where the zone has just appeared and 1.
    pub density: Moving<F>,
    /// By how much the function is less than 0, at most.
    depth: Moving<F>,
    /// Height of the gap before.
    gap: Moving<F>,
}

impl<F: Float> Zone<F> {
    pub fn width(&self) -> Moving<F> {
        self.to - self.from
    }
}

pub(super) type Zones<F> = Vec<Zone<F>, ZONES>;

/// `c₀ + c₁ t + c₂ t² + c₃ t³` over `t` from 0 to a length.
#[derive(Clone, Copy)]
struct Cubic<F> {
    c: [Moving<F>; 4],
    length: Moving<F>,
}

impl<F: Float> Cubic<F> {
    fn new(length: Moving<F>, [from, slope]: [Moving<F>; 2], [to, end]: [Moving<F>; 2]) -> Self {
        let inverse = length.inverse();
        let rise = (to - from) * inverse;
        let c2 = (rise.times(3.0) - slope.times(2.0) - end) * inverse;
        let c3 = (slope + end - rise.times(2.0)) * inverse.squared();
        Self { c: [from, slope, c2, c3], length }
    }

    fn at(&self, t: Moving<F>) -> Moving<F> {
        let [c0, c1, c2, c3] = self.c;
        c0 + t * (c1 + t * (c2 + t * c3))
    }

    fn slope(&self, t: Moving<F>) -> Moving<F> {
        let [_, c1, c2, c3] = self.c;
        c1 + t * (c2.times(2.0) + t * c3.times(3.0))
    }

    /// The places of the beginning, the two extremes and the end.
    fn cuts(&self) -> [F; 4] {
        let (length, zero) = (self.length.value, F::zero());
        let [_, c1, c2, c3] = self.c.map(|c| c.value);
        // c₁ + 2 c₂ t + 3 c₃ t² = 0 without cancellation
        let root = c2 * c2 - c1 * c3.times(3.0);
        let mut cuts = [zero, zero, length, length];
        if root > zero {
            let root = root.sqrt();
            let q = if c2 < zero { root - c2 } else { -root - c2 };
            let inside = |t: F| if t > zero && t < length { t } else { zero };
            let (one, two) = (inside(c1 / q), inside(q / c3.times(3.0)));
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
    pub lowest: Moving<F>,
    /// Ends of the profile.
    ends: [F; 2],
    /// Whether the curve counts as constant, without its derivatives by load or approach.
    pub still: bool,
}

/// The smoothing length without regard to the points: half the width of a narrow contact, 2 mm of a wide one.
pub(super) fn length_for<F: Float>(half_width: Moving<F>) -> Moving<F> {
    let narrow = half_width.times(2.0 * SHARE);
    let widest = Moving::from_base(F::of(WIDEST));
    // (m⁻⁴ + c⁻⁴)^(−1/4)
    let (small, large) = (narrow.min(widest), narrow.max(widest));
    let ratio = (small / large).squared().squared();
    small / ratio.plus(1.0).sqrt().sqrt()
}

impl<F: Float> Curve<F> {
    /// The curve of a profile smoothed over a length, where its points are less than `level` above the lowest.
    #[inline(never)]
    pub fn new(profile: &Profile<F>, length: Moving<F>, level: F) -> Self {
        let [first, last] = profile.ends;
        let whole = last - first;
        let length = length.min(Moving::from_base(whole));
        let floor = profile.step.times(STEPS);
        // s² = s₀² + (2.5 steps)², about as the parabolas have it
        let smooth = length.squared().shift(floor * floor).sqrt();
        let mut step = smooth.times(1.0 / KNOTS_TO_A_LENGTH);
        let least = Moving::from_base(whole.times(1.0 / PIECES));
        step = step.max(least);
        let lowest = Moving::from_base(F::zero());
        let mut curve = Self { knots: Vec::new(), lowest, ends: profile.ends, still: false };
        while !curve.fill(profile, length, level, step) && step.value < whole {
            step = step.times(2.0);
        }
        let mut lowest = Moving::from_base(F::LARGEST);
        curve.pieces(
            |knot| [knot.height, knot.slope],
            |_, cubic| {
                for t in cubic.cuts() {
                    lowest = lowest.min(cubic.at(Moving::from_base(t)));
                }
            },
        );
        curve.lowest = lowest;
        curve
    }

    /// Places knots where the profile is low: at equal steps to both sides of its middle, and at its ends. Returns whether there was room.
    fn fill(&mut self, profile: &Profile<F>, length: Moving<F>, level: F, step: Moving<F>) -> bool {
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
                Moving::from_base(from)
            } else if knot >= high_end {
                Moving::from_base(to)
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

    /// Hands every piece to `take`, with the cubic through the value and the slope that `of` gives at its knots.
    fn pieces(
        &self,
        of: impl Fn(&Knot<F>) -> [Moving<F>; 2],
        mut take: impl FnMut(&Knot<F>, &Cubic<F>),
    ) {
        for (knot, next) in self.knots.iter().zip(self.knots.iter().skip(1)) {
            if next.joined {
                take(knot, &Cubic::new(next.y - knot.y, of(knot), of(next)));
            }
        }
    }

    fn seen(&self, x: Moving<F>) -> Moving<F> {
        if self.still { Moving::from_base(x.value) } else { x }
    }

    /// Place, height above the lowest point, and slope of a knot.
    fn knot(&self, Knot { y, height, slope, .. }: &Knot<F>) -> [Moving<F>; 3] {
        [self.seen(*y), self.seen(*height - self.lowest), self.seen(*slope)]
    }

    /// Height above the lowest point.
    pub fn at(&self, y: Moving<F>) -> Moving<F> {
        let next = self.knots.partition_point(|knot| knot.y.value < y.value);
        let next = next.min(self.knots.len().saturating_sub(1)).max(1);
        match self.knots.get(next - 1..=next) {
            Some([knot, end]) => {
                let ([from, height, slope], [to, high, steep]) = (self.knot(knot), self.knot(end));
                Cubic::new(to - from, [height, slope], [high, steep]).at(y - from)
            }
            _ => Moving::from_base(F::zero()),
        }
    }

    /// The zones where a function is negative; returns whether one of them ends with the profile. `of` gives the value and the slope of the
    /// function from a place, the height there and its slope. Which zones and gaps are whole is measured with the approach. (The zones are
    /// written where they stay: a copy would take room on the stack.)
    pub fn zones(
        &self,
        approach: Moving<F>,
        zones: &mut Zones<F>,
        of: impl Fn(Moving<F>, Moving<F>, Moving<F>) -> [Moving<F>; 2],
    ) -> bool {
        let mut found = Found::new(zones, approach);
        let [start, finish] = self.ends;
        let mut at_end = false;
        let at = |knot: &Knot<F>| {
            let [y, height, slope] = self.knot(knot);
            of(y, height, slope)
        };
        let mut last: Option<(Moving<F>, [Moving<F>; 2])> = None;
        let next = self.knots.iter().skip(1).map(Some).chain([None]);
        for (knot, next) in self.knots.iter().zip(next) {
            let own = match last {
                Some((_, own)) if knot.joined => own,
                _ => at(knot),
            };
            if !knot.joined {
                if let Some((end, _)) = last {
                    found.end(end);
                }
                found.highest = Moving::from_base(F::LARGEST);
                if own[0].value < F::zero() {
                    found.begin(self.seen(knot.y));
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
            if least > fall.max(approach.value.times(WHOLE_GAP)) {
                found.highest = found.highest.max(own[0]).max(end[0]);
                continue;
            }
            let heights = Cubic::new(step, [height, slope], [high, steep]);
            let exact = |t: Moving<F>| of(t + y, heights.at(t), heights.slope(t));
            // extremes of the profile, and those of the function as a cubic
            let ([zero, a, b, _], [_, c, d, length]) =
                (heights.cuts(), Cubic::new(step, own, end).cuts());
            let mut cuts = [a, b, c, d, length];
            for i in 1..cuts.len() {
                for k in (0..i).rev() {
                    if let Some([one, two]) = cuts.get_mut(k..k + 2)
                        && *two < *one
                    {
                        core::mem::swap(one, two);
                    }
                }
            }
            let (mut from, mut before) = (zero, own[0]);
            for to in cuts {
                if to <= from {
                    continue;
                }
                let after = if to < length { exact(Moving::from_base(to))[0] } else { end[0] };
                found.lowest = found.lowest.min(before).min(after);
                found.highest = found.highest.max(before).max(after);
                let (inside, stays) = (before.value < F::zero(), after.value < F::zero());
                if inside && !stays {
                    found.end(root(exact, from, to) + y);
                } else if stays && !inside {
                    found.begin(root(exact, to, from) + y);
                }
                (from, before) = (to, after);
            }
        }
        if let Some((end, _)) = last {
            at_end = at_end || (found.begun.is_some() && end.value >= finish);
            found.end(end);
        }
        join(found.zones, approach);
        at_end
    }
}

/// Zones with hardly a gap between them share the gap and the closer cells of the two. So zones part and merge without a jump, although the
/// width of a gap grows infinitely fast at first. What is hardly a gap depends on the depth of the zones beside it, lest a zone that has
/// just appeared is joined at once.
fn join<F: Float>(zones: &mut [Zone<F>], approach: Moving<F>) {
    // 1 where the gap has just appeared
    let closed = |before: &Zone<F>, next: &Zone<F>| {
        let both = (before.depth + next.depth).shift(F::TINY);
        let depth = before.depth * next.depth / both;
        let whole = depth * approach.times(WHOLE_GAP) / (depth + approach.times(HALF_GAP));
        Moving::one() - step(next.gap / whole.shift(F::TINY))
    };
    let mut rest = &mut *zones;
    while let [before, after @ ..] = rest {
        if let [next, ..] = after {
            let closed = closed(before, next);
            let half = (next.from - before.to).times(0.5) * closed;
            before.to += half;
            next.from -= half;
            next.density = next.density.max(before.density * closed);
        }
        rest = after;
    }
    let mut rest = zones;
    while let [before @ .., last] = rest {
        if let [.., own] = before {
            own.density = own.density.max(last.density * closed(own, last));
        }
        rest = before;
    }
}

/// `3 x² − 2 x³`, 1 beyond 1
fn step<F: Float>(x: Moving<F>) -> Moving<F> {
    let x = x.min(Moving::one());
    x.squared() * (Moving::constant(3.0) - x.times(2.0))
}

/// Zones on the way along the profile.
struct Found<'a, F> {
    zones: &'a mut Zones<F>,
    approach: Moving<F>,
    /// Where a zone has begun, and the height of the gap before.
    begun: Option<[Moving<F>; 2]>,
    /// Lowest value since the last zone, highest since this one began.
    lowest: Moving<F>,
    highest: Moving<F>,
}

impl<'a, F: Float> Found<'a, F> {
    fn new(zones: &'a mut Zones<F>, approach: Moving<F>) -> Self {
        zones.clear();
        let (zero, far) = (Moving::zero(), Moving::from_base(F::LARGEST));
        Self { zones, approach, begun: None, lowest: zero, highest: far }
    }

    fn begin(&mut self, from: Moving<F>) {
        self.begun = Some([from, self.highest]);
    }

    /// Makes room for one more zone: the two zones beside the narrowest gap become one.
    fn close_a_gap(&mut self, next: Zone<F>) {
        let after = self.zones.iter().skip(1).chain([&next]);
        let gaps = self.zones.iter().zip(after).map(|(zone, next)| (next.from - zone.to).value);
        let least = gaps
            .enumerate()
            .fold((0, F::LARGEST), |least, (i, gap)| if gap < least.1 { (i, gap) } else { least });
        let mut carried = next;
        // each zone after the gap moves back by one place
        for (i, zone) in self.zones.iter_mut().enumerate().rev() {
            if i > least.0 {
                core::mem::swap(zone, &mut carried);
            } else {
                zone.to = carried.to;
                zone.density = zone.density.max(carried.density);
                zone.depth = zone.depth.max(carried.depth);
                break;
            }
        }
    }

    /// The zone that has begun ends.
    fn end(&mut self, to: Moving<F>) {
        let depth = -self.lowest;
        let density = step(depth / self.approach.times(WHOLE_ZONE));
        self.lowest = Moving::zero();
        let Some([from, gap]) = self.begun.take() else { return };
        self.highest = Moving::zero();
        let zone = Zone { from, to, density, depth, gap };
        if !(to.value > from.value) {
            return;
        }
        if self.zones.is_full() {
            self.close_a_gap(zone);
        } else {
            let _ = self.zones.push(zone);
        }
    }
}

/// The place where a function is zero between two places of different sign, by Newton's steps between brackets.
fn root<F: Float>(
    of: impl Fn(Moving<F>) -> [Moving<F>; 2],
    mut negative: F,
    mut positive: F,
) -> Moving<F> {
    let mut t = negative.times(0.5) + positive.times(0.5);
    let small = (positive - negative).abs() * F::EPSILON.times(4.0);
    for _ in 0..60 {
        let [value, slope] = of(Moving::from_base(t)).map(|x| x.value);
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
    let [value, slope] = of(Moving::from_base(t));
    // (the width of a zone that just appears grows infinitely fast, and carries nothing)
    let steep = if slope.value.abs() > F::TINY { F::one() / slope.value } else { F::zero() };
    Moving { value: t, gradient: value.gradient.map(|d| -(d * steep)) }
}
