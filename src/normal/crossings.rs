//! Where a smoothed profile, or a function of it, is negative.

use crate::normal::density::Zones;
use crate::normal::extremes::{cuts, refined, zero_of};
use crate::normal::smooth::{Knot, SmoothedProfile};
use crate::number::{Arithmetic, Dual, Float, pairs, sort};
use crate::numerics::hermite::Cubic;

/// A part of a curve of surfaces where they overlap.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Overlap<F> {
    /// Where it begins and ends \[m\].
    pub ends: [F; 2],
    /// Largest overlap \[m\].
    pub depth: F,
}

impl<F: Float, const N: usize> SmoothedProfile<F, N> {
    /// Hands every zone of overlap to `take`, in ascending order, in the numbers of `number`.
    pub(crate) fn overlaps(
        &self, number: impl Fn(Dual<F, N>) -> F, mut take: impl FnMut(Overlap<F>),
    ) {
        let mut open: Option<Overlap<F>> = None;
        let of = |knot: &Knot<F, N>| {
            let [_, height, slope] = self.knot(knot);
            [height, slope]
        };
        self.pieces(of, |knot, cubic, length| {
            if let Some(zone) = open.take_if(|_| !knot.joined) {
                take(zone);
            }
            let cuts = cuts(cubic, length);
            for (&from, &to) in pairs(&cuts) {
                if !(to.value > from.value) {
                    continue;
                }
                let heights = [from, to].map(|t| cubic.value_at(t));
                let [begins, ends] = heights.map(|height| height.value < F::zero());
                let place = |t: Dual<F, N>| number(knot.y + t);
                let crossing = |inside: Dual<F, N>, outside: Dual<F, N>| {
                    let of = |t| [cubic.value_at(t), cubic.slope(t)];
                    place(zero_of(of, inside.value, outside.value))
                };
                if ends || begins {
                    let begin = if begins { place(from) } else { crossing(to, from) };
                    let none = Overlap { ends: [begin; 2], depth: F::zero() };
                    let zone = open.get_or_insert(none);
                    let [.., end] = &mut zone.ends;
                    *end = if ends { place(to) } else { crossing(from, to) };
                    zone.depth = heights.iter().fold(zone.depth, |depth, h| depth.max(-number(*h)));
                }
                if let Some(zone) = open.take_if(|_| !ends) {
                    take(zone);
                }
            }
        });
        if let Some(zone) = open {
            take(zone);
        }
    }

    /// The same curve, of which only a zone or a run of zones counts.
    pub(crate) fn restrict(&mut self, zone: &Overlap<F>) {
        let [begin, end] = zone.ends;
        self.lowest = Dual::from_base(self.zero - zone.depth);
        let first = self.knots.partition_point(|knot| knot.y.value <= begin);
        let last = self.knots.partition_point(|knot| knot.y.value < end);
        self.range = [first.saturating_sub(1), last + 1];
    }

    /// The depth of the zone that counts, with its derivatives; the curve is measured from there.
    pub(crate) fn depth(&mut self, zone: &Overlap<F>) -> Dual<F, N> {
        let [begin, end] = zone.ends;
        self.lowest.gradient = self.lowest_between(|y| y >= begin && y <= end).gradient;
        Dual::from_base(self.zero) - self.lowest
    }

    /// The zones where a function is negative; returns whether one of them ends with the profile.
    /// `of` gives the value and the slope of the function from a place, the height there and its
    /// slope. The zones are written in place, because a copy would take room on the stack.
    pub(super) fn zones(
        &self, zones: &mut Zones<F, N>,
        of: impl Fn(Dual<F, N>, Dual<F, N>, Dual<F, N>) -> [Dual<F, N>; 2],
    ) -> bool {
        let [start, finish] = self.ends;
        let mut at_end = false;
        let at = |knot: &Knot<F, N>| {
            let [y, height, slope] = self.knot(knot);
            of(y, height, slope)
        };
        let mut last: Option<(Dual<F, N>, [Dual<F, N>; 2])> = None;
        let [first, end] = self.range;
        let knots = self.knots.get(first..end.min(self.knots.len())).unwrap_or(&[]);
        let next = knots.iter().skip(1).map(Some).chain([None]);
        for (knot, next) in knots.iter().zip(next) {
            let own = match last {
                Some((_, own)) if knot.joined => own,
                _ => at(knot),
            };
            if !knot.joined {
                zones.end();
                if own[0].value < F::zero() {
                    zones.begin(self.without_slopes_if_still(knot.y), own);
                    at_end = at_end || knot.y.value <= start;
                }
            }
            last = Some((self.without_slopes_if_still(knot.y), own));
            let Some(next) = next.filter(|next| next.joined) else { continue };
            let end = at(next);
            last = Some((self.without_slopes_if_still(next.y), end));
            self.zones_of_piece(zones, [knot, next], [own, end], &of);
        }
        if let Some((end, _)) = last {
            at_end = at_end || (zones.begun.is_some() && end.value >= finish);
        }
        zones.end();
        at_end
    }

    /// The zones of the piece between two knots, at which the function has these values and slopes.
    fn zones_of_piece(
        &self, zones: &mut Zones<F, N>, [knot, next]: [&Knot<F, N>; 2],
        [own, end]: [[Dual<F, N>; 2]; 2],
        of: &impl Fn(Dual<F, N>, Dual<F, N>, Dual<F, N>) -> [Dual<F, N>; 2],
    ) {
        let ([y, height, slope], [next_y, high, steep]) = (self.knot(knot), self.knot(next));
        let step = next_y - y;
        // no cubic falls farther below its ends, nor does it rise farther above them
        let rise = (own[1].value.abs() + end[1].value.abs()) * step.value.times(0.15);
        let fall = (slope.value.abs() + steep.value.abs()) * step.value.times(0.15);
        let least = own[0].value.min(end[0].value);
        if least > fall.max(rise) {
            return;
        }
        if zones.are_deep(own[0].value.max(end[0].value) + rise) {
            zones.pass(next_y, end);
            return;
        }
        let heights = Cubic::over(step, [height, high], [slope, steep]);
        let exact = |t: Dual<F, N>| of(t + y, heights.value_at(t), heights.slope(t));
        // extremes of the profile, and those of the function as a cubic
        let function = Cubic::over(step, [own[0], end[0]], [own[1], end[1]]);
        let ([zero, a, b, _], [_, c, d, length]) = (cuts(&heights, step), cuts(&function, step));
        let [c, d] = [c, d].map(|cut| refined(&function, step.value, cut, exact));
        let mut cuts = [a, b, c, d, length];
        sort(&mut cuts, |cut, next| cut.value < next.value);
        let (mut from, mut before) = (zero, own[0]);
        for to in cuts {
            if to.value <= from.value {
                continue;
            }
            let after = if to.value < length.value { exact(to) } else { end };
            let (inside, stays) = (before.value < F::zero(), after[0].value < F::zero());
            if inside && !stays {
                let end = zero_of(exact, from.value, to.value);
                zones.pass(end + y, exact(end));
                zones.end();
            } else if stays && !inside {
                let begin = zero_of(exact, to.value, from.value);
                zones.begin(begin + y, exact(begin));
            }
            if stays {
                zones.pass(to + y, after);
            }
            (from, before) = (to, after[0]);
        }
    }
}
