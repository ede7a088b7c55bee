//! The points of a profile, averaged where they are crowded or scatter, in ascending order of their
//! length.

use super::coarse_line::{CAPACITY, Polyline};
use super::curve::{Points, distance};
use super::{CurvePoint, PreparedProfile};
use crate::number::{Float, add_at, between, set_at};
use crate::numerics::parabola::NormalEquations;

/// Cells of points that are averaged, where there are too many: with two ends they have room.
const CELLS: f64 = CAPACITY as f64 - 6.0;
/// Neighbours nearer than this share of a cell are averaged: their slope would be scatter.
const CROWDED: f64 = 0.2;
/// They are also averaged where their distance exceeds that of their feet by this factor: the line
/// between them leans by more than 25 degrees against the spine.
const STEEP: f64 = 1.1;
/// Knots that are this share of the smoothing length apart are different places.
const DISTINCT: f64 = 0.05;

/// The average of some points.
#[derive(Clone, Copy)]
struct PointAverage<F> {
    /// How many there are.
    weight: F,
    /// Their length along the spine \[m\].
    length: F,
    point: [F; 2],
    /// Sum of the squares of the differences of their lengths from the average \[m²\].
    spread: F,
}

impl<F: Float> PointAverage<F> {
    /// The average of the points of two averages.
    #[inline]
    fn with(self, other: Self) -> Self {
        let weight = self.weight + other.weight;
        let share = other.weight / weight;
        let apart = other.length - self.length;
        Self {
            weight,
            length: self.length + apart * share,
            point: between(self.point, other.point, share),
            spread: self.spread + other.spread + apart * apart * self.weight * share,
        }
    }
}

/// The averages, in ascending order of their length.
pub(super) struct Knots<'a, F> {
    /// Where the points are stored. Weighted knots have their weight instead of the cosine and
    /// their spread in that of the sine; of single points a second half is stored there.
    store: &'a mut PreparedProfile<F>,
    lengths: [F; SINGLE],
    is_weighted: bool,
    count: usize,
}

/// Single points that there is room for.
pub(super) const SINGLE: usize = 2 * CAPACITY;

impl<F: Float> Points<F> for Knots<'_, F> {
    fn count(&self) -> usize {
        self.count
    }

    #[inline]
    fn get(&self, k: usize) -> Option<(F, [F; 2])> {
        self.knot(k).map(|knot| (knot.length, knot.point))
    }
}

impl<'a, F: Float> Knots<'a, F> {
    /// No knots; a surface where they are stored.
    pub(super) fn new(store: &'a mut PreparedProfile<F>) -> Self {
        Self { store, lengths: [F::zero(); SINGLE], is_weighted: false, count: 0 }
    }

    fn room(&self) -> usize {
        if self.is_weighted { CAPACITY } else { SINGLE }
    }

    /// Gathers the points of a profile, but for strays: those farther from its spine than a radius.
    pub(super) fn collect_points(
        &mut self, is_weighted: bool, spine: &Polyline<F>, radius: F, y: &[F], z: &[F],
    ) {
        (self.is_weighted, self.count) = (is_weighted, 0);
        let cell = (spine.length() + radius.times(2.0)).times(1.0 / CELLS);
        let have_room = y.len() + 2 <= self.room();
        let (mut segment, mut near) = (0, 0);
        let mut ends: Option<[PointAverage<F>; 2]> = None;
        for point in y.iter().zip(z).map(|(y, z)| [*y, *z]) {
            let foot = spine.nearest(point, segment, radius);
            segment = foot.segment;
            if !foot.is_within(radius) {
                continue;
            }
            let knot =
                PointAverage { weight: F::one(), length: foot.length, point, spread: F::zero() };
            let [first, last] = ends.unwrap_or([knot; 2]);
            let first = if foot.length < first.length { knot } else { first };
            let last = if foot.length > last.length { knot } else { last };
            ends = Some([first, last]);
            // no foot lies before the spine by more than a radius
            let cell_of = |knot: PointAverage<F>| ((knot.length + radius) / cell).whole();
            near = if have_room { self.insert(knot) } else { self.add(knot, near, cell_of) };
        }
        for knot in ends.into_iter().flatten().filter(|_| !have_room) {
            self.insert(knot);
        }
        self.pool(cell.times(CROWDED));
        if self.is_weighted {
            self.straighten();
        }
        // the ends are not averaged away
        if let Some([first, last]) = ends.filter(|_| self.count >= 2) {
            self.extend(0, 1, first.length);
            self.extend(self.count - 1, self.count - 2, last.length);
        }
    }

    #[inline]
    fn knot(&self, k: usize) -> Option<PointAverage<F>> {
        let length = *self.lengths.get(k).filter(|_| k < self.count)?;
        let (weight, spread) = (F::one(), F::zero());
        let Some(CurvePoint { y, z, cosine, sine }) = self.store.point(k) else {
            let CurvePoint { cosine, sine, .. } = self.store.point(k - CAPACITY)?;
            return Some(PointAverage { weight, length, point: [cosine, sine], spread });
        };
        let (weight, spread) = if self.is_weighted { (cosine, sine) } else { (weight, spread) };
        Some(PointAverage { weight, length, point: [y, z], spread })
    }

    #[inline]
    fn set(&mut self, k: usize, knot: PointAverage<F>) {
        set_at(&mut self.lengths, k, knot.length);
        let [y, z] = knot.point;
        if self.is_weighted {
            self.store.set_point(k, CurvePoint { y, z, cosine: knot.weight, sine: knot.spread });
            return;
        }
        let second = k.wrapping_sub(CAPACITY);
        let half = if k < CAPACITY { k } else { second };
        let Some(place) = self.store.point(half) else { return };
        let place = if k < CAPACITY {
            CurvePoint { y, z, ..place }
        } else {
            CurvePoint { cosine: y, sine: z, ..place }
        };
        self.store.set_point(half, place);
    }

    /// Adds a point to the average of its cell, searched from a knot on; returns the cell's knot.
    fn add(
        &mut self, knot: PointAverage<F>, mut near: usize, cell_of: impl Fn(PointAverage<F>) -> i32,
    ) -> usize {
        let cell = cell_of(knot);
        while near > 0 && self.knot(near).is_some_and(|other| cell_of(other) > cell) {
            near -= 1;
        }
        while self.knot(near + 1).is_some_and(|other| cell_of(other) <= cell) {
            near += 1;
        }
        let is_full = self.count + 2 >= self.room();
        if let Some(other) = self.knot(near).filter(|other| is_full || cell_of(*other) == cell) {
            self.set(near, other.with(knot));
            return near;
        }
        self.insert(knot)
    }

    /// Inserts a knot at its place, and returns it.
    fn insert(&mut self, knot: PointAverage<F>) -> usize {
        let mut k = self.count.min(self.room() - 1);
        self.count = k + 1;
        while let Some(before) = self.knot(k.wrapping_sub(1)).filter(|_| k > 0) {
            if before.length <= knot.length {
                break;
            }
            self.set(k, before);
            k -= 1;
        }
        self.set(k, knot);
        k
    }

    /// Averages neighbours that are nearer than a length, or lie beside each other.
    fn pool(&mut self, least: F) {
        let (mut kept, mut held) = (0_usize, None::<PointAverage<F>>);
        for k in 0..self.count {
            let Some(mut knot) = self.knot(k) else { break };
            while let Some(before) = held {
                let apart = knot.length - before.length;
                if apart > least && distance(before.point, knot.point) < apart.times(STEEP) {
                    break;
                }
                knot = before.with(knot);
                held = if kept > 0 { self.knot(kept - 1) } else { None };
                kept = kept.saturating_sub(1);
            }
            if let Some(before) = held.replace(knot) {
                self.set(kept, before);
                kept += 1;
            }
        }
        if let Some(last) = held {
            self.set(kept, last);
            self.count = kept + 1;
        }
    }

    /// Moves a knot along the line to another one, to a length.
    fn extend(&mut self, k: usize, other: usize, length: F) {
        if let (Some(knot), Some(other)) = (self.knot(k), self.knot(other)) {
            let share = (length - knot.length) / (other.length - knot.length);
            let point = between(knot.point, other.point, share);
            self.set(k, PointAverage { length, point, ..knot });
        }
    }

    /// The average of points of a parabola lies beside it, by half the second derivative times the
    /// variance of their lengths. Moves all knots back.
    fn straighten(&mut self) {
        let mut last: Option<PointAverage<F>> = None;
        for k in 0..self.count {
            let Some(here) = self.knot(k) else { break };
            if let (Some(last), Some(next)) = (last, self.knot(k + 1)) {
                let [from, to] = [here.length - last.length, next.length - here.length];
                let half = here.spread / (here.weight * (from + to));
                let [[a, b], [c, d], [e, f]] = [last.point, here.point, next.point];
                let bend = |a: F, c: F, e: F| half * ((e - c) / to - (c - a) / from);
                let point = [c - bend(a, c, e), d - bend(b, d, f)];
                self.set(k, PointAverage { point, ..here });
            }
            last = Some(here);
        }
    }

    /// Fills a polyline with the knots. Smoothing replaces each by the point of the parabola
    /// through the knots up to the smoothing length away, least squares weighted with `(1 −
    /// (d/s)²)³` and with their spacing.
    pub(super) fn smooth(&self, smoothing: F, line: &mut Polyline<F>) {
        line.count = 0;
        for (k, knot) in (0..self.count).filter_map(|k| Some((k, self.knot(k)?))) {
            let smooth = if smoothing > F::zero() { self.parabola(k, smoothing) } else { None };
            line.push(knot.length, smooth.unwrap_or(knot.point));
        }
    }

    /// The mean and the largest distance of the knots from their smoothed places.
    pub(super) fn distances(&self, line: &Polyline<F>) -> [F; 2] {
        let (mut sum, mut most, mut count) = (F::zero(), F::zero(), 0_u16);
        let knots = (0..self.count).filter_map(|k| self.knot(k));
        for (knot, place) in knots.zip(line.points.iter().take(line.count)) {
            let apart = distance(knot.point, *place);
            (sum, most, count) = (sum + apart, most.max(apart), count + 1);
        }
        [sum / F::widened(f32::from(count.max(1))), most]
    }

    /// The parabola about a knot.
    fn parabola(&self, centre: usize, smoothing: F) -> Option<[F; 2]> {
        let PointAverage { length: origin, point: middle, .. } = self.knot(centre)?;
        let away = |knot: PointAverage<F>| (knot.length - origin) / smoothing;
        let mut first = centre;
        while first > 0 && away(self.knot(first - 1)?) > -F::one() {
            first -= 1;
        }
        let mut m = [F::zero(); 5];
        let mut sums = [[F::zero(); 3]; 2];
        let (mut count, mut last) = (0, F::constant(-2.0));
        for k in first..self.count {
            let knot = self.knot(k)?;
            let x = away(knot);
            if x >= F::one() {
                break;
            }
            // points at nearly the same place count once
            if x > last.plus(DISTINCT) {
                (count, last) = (count + 1, x);
            }
            let [from, to] =
                [k.saturating_sub(1), k + 1].map(|k| self.knot(k).unwrap_or(knot).length);
            let rest = F::one() - x * x;
            let mut weight = rest * rest * rest * (to - from);
            for (j, m) in m.iter_mut().enumerate() {
                *m += weight;
                for ((sum, value), middle) in sums.iter_mut().zip(knot.point).zip(middle) {
                    add_at(sum, j, weight * (value - middle));
                }
                weight = weight * x;
            }
        }
        let [m0, ..] = m;
        let equations = NormalEquations::of_moments(m);
        if count < 4 || !(equations.determinant > m0 * m0 * m0.times(1e-6)) {
            return None;
        }
        let [[across, ..], [down, ..]] = sums.map(|sums| equations.coefficients(sums));
        Some([middle[0] + across, middle[1] + down])
    }
}
