//! The points of a profile, averaged where they are crowded or scatter, in ascending order of their
//! length.

use super::coarse_line::{CoarseLine, LINE_CAPACITY};
use super::curve::{Points, distance};
use super::{CurvePoint, PreparedProfile};
use crate::number::{Float, add_at, between, set_at};
use crate::numerics::parabola::NormalEquations;

/// Cells of points that are averaged, where there are too many: with two ends they have room.
const AVERAGES: f64 = LINE_CAPACITY as f64 - 6.0;
/// Neighbours nearer than this share of a cell are averaged: their slope would be scatter.
const CROWDED: f64 = 0.2;
/// They are also averaged where their distance exceeds that of their feet by this factor: the line
/// between them leans by more than 25 degrees against the coarse line.
const LEANS: f64 = 1.1;
/// Averages that are this share of the smoothing length apart are different places.
const DISTINCT: f64 = 0.05;

/// The average of some points.
#[derive(Clone, Copy)]
struct AveragedPoint<F> {
    /// How many there are.
    weight: F,
    /// Their length along the coarse line \[m\].
    length: F,
    point: [F; 2],
    /// Sum of the squares of the differences of their lengths from the average \[m²\].
    spread: F,
}

impl<F: Float> AveragedPoint<F> {
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
pub(super) struct AveragedPoints<'a, F> {
    /// Where the points are stored. Weighted averages have their weight instead of the cosine and
    /// their spread in that of the sine; of single points a second half is stored there.
    store: &'a mut PreparedProfile<F>,
    lengths: [F; SINGLE],
    is_weighted: bool,
    count: usize,
}

/// Single points that there is room for.
pub(super) const SINGLE: usize = 2 * LINE_CAPACITY;

impl<F: Float> Points<F> for AveragedPoints<'_, F> {
    fn count(&self) -> usize {
        self.count
    }

    #[inline]
    fn get(&self, k: usize) -> Option<(F, [F; 2])> {
        self.average(k).map(|average| (average.length, average.point))
    }
}

impl<'a, F: Float> AveragedPoints<'a, F> {
    /// No averages; a surface where they are stored.
    pub(super) fn new(store: &'a mut PreparedProfile<F>) -> Self {
        Self { store, lengths: [F::zero(); SINGLE], is_weighted: false, count: 0 }
    }

    fn room(&self) -> usize {
        if self.is_weighted { LINE_CAPACITY } else { SINGLE }
    }

    /// Gathers the points of a profile, but for strays: those farther from its coarse line than a
    /// radius.
    pub(super) fn collect_points(
        &mut self, is_weighted: bool, line: &CoarseLine<F>, radius: F, y: &[F], z: &[F],
    ) {
        (self.is_weighted, self.count) = (is_weighted, 0);
        let cell = (line.length() + radius.times(2.0)).times(1.0 / AVERAGES);
        let have_room = y.len() + 2 <= self.room();
        let (mut segment, mut near) = (0, 0);
        let mut ends: Option<[AveragedPoint<F>; 2]> = None;
        for point in y.iter().zip(z).map(|(y, z)| [*y, *z]) {
            let foot = line.nearest(point, segment, radius);
            segment = foot.segment;
            if !foot.is_within(radius) {
                continue;
            }
            let average =
                AveragedPoint { weight: F::one(), length: foot.length, point, spread: F::zero() };
            let [first, last] = ends.unwrap_or([average; 2]);
            let first = if foot.length < first.length { average } else { first };
            let last = if foot.length > last.length { average } else { last };
            ends = Some([first, last]);
            // no foot lies before the coarse line by more than a radius
            let cell_of = |average: AveragedPoint<F>| ((average.length + radius) / cell).whole();
            near = if have_room { self.insert(average) } else { self.add(average, near, cell_of) };
        }
        for average in ends.into_iter().flatten().filter(|_| !have_room) {
            self.insert(average);
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
    fn average(&self, k: usize) -> Option<AveragedPoint<F>> {
        let length = *self.lengths.get(k).filter(|_| k < self.count)?;
        let (weight, spread) = (F::one(), F::zero());
        let Some(CurvePoint { y, z, cosine, sine }) = self.store.point(k) else {
            let CurvePoint { cosine, sine, .. } = self.store.point(k - LINE_CAPACITY)?;
            return Some(AveragedPoint { weight, length, point: [cosine, sine], spread });
        };
        let (weight, spread) = if self.is_weighted { (cosine, sine) } else { (weight, spread) };
        Some(AveragedPoint { weight, length, point: [y, z], spread })
    }

    #[inline]
    fn set(&mut self, k: usize, average: AveragedPoint<F>) {
        set_at(&mut self.lengths, k, average.length);
        let [y, z] = average.point;
        if self.is_weighted {
            self.store
                .set_point(k, CurvePoint { y, z, cosine: average.weight, sine: average.spread });
            return;
        }
        let second = k.wrapping_sub(LINE_CAPACITY);
        let half = if k < LINE_CAPACITY { k } else { second };
        let Some(place) = self.store.point(half) else { return };
        let place = if k < LINE_CAPACITY {
            CurvePoint { y, z, ..place }
        } else {
            CurvePoint { cosine: y, sine: z, ..place }
        };
        self.store.set_point(half, place);
    }

    /// Adds a point to the average of its cell, searched from an average on; returns the average
    /// of the cell.
    fn add(
        &mut self, average: AveragedPoint<F>, mut near: usize,
        cell_of: impl Fn(AveragedPoint<F>) -> i32,
    ) -> usize {
        let cell = cell_of(average);
        while near > 0 && self.average(near).is_some_and(|other| cell_of(other) > cell) {
            near -= 1;
        }
        while self.average(near + 1).is_some_and(|other| cell_of(other) <= cell) {
            near += 1;
        }
        let is_full = self.count + 2 >= self.room();
        if let Some(other) = self.average(near).filter(|other| is_full || cell_of(*other) == cell) {
            self.set(near, other.with(average));
            return near;
        }
        self.insert(average)
    }

    /// Inserts an average at its place, and returns it.
    fn insert(&mut self, average: AveragedPoint<F>) -> usize {
        let mut k = self.count.min(self.room() - 1);
        self.count = k + 1;
        while let Some(before) = self.average(k.wrapping_sub(1)).filter(|_| k > 0) {
            if before.length <= average.length {
                break;
            }
            self.set(k, before);
            k -= 1;
        }
        self.set(k, average);
        k
    }

    /// Averages neighbours that are nearer than a length, or lie beside each other.
    fn pool(&mut self, least: F) {
        let (mut kept, mut held) = (0_usize, None::<AveragedPoint<F>>);
        for k in 0..self.count {
            let Some(mut average) = self.average(k) else { break };
            while let Some(before) = held {
                let apart = average.length - before.length;
                if apart > least && distance(before.point, average.point) < apart.times(LEANS) {
                    break;
                }
                average = before.with(average);
                held = if kept > 0 { self.average(kept - 1) } else { None };
                kept = kept.saturating_sub(1);
            }
            if let Some(before) = held.replace(average) {
                self.set(kept, before);
                kept += 1;
            }
        }
        if let Some(last) = held {
            self.set(kept, last);
            self.count = kept + 1;
        }
    }

    /// Moves an average along the line to another one, to a length.
    fn extend(&mut self, k: usize, other: usize, length: F) {
        if let (Some(average), Some(other)) = (self.average(k), self.average(other)) {
            let share = (length - average.length) / (other.length - average.length);
            let point = between(average.point, other.point, share);
            self.set(k, AveragedPoint { length, point, ..average });
        }
    }

    /// The average of points of a parabola lies beside it, by half the second derivative times the
    /// variance of their lengths. Moves all averages back.
    fn straighten(&mut self) {
        let mut last: Option<AveragedPoint<F>> = None;
        for k in 0..self.count {
            let Some(here) = self.average(k) else { break };
            if let (Some(last), Some(next)) = (last, self.average(k + 1)) {
                let [from, to] = [here.length - last.length, next.length - here.length];
                let half = here.spread / (here.weight * (from + to));
                let [[a, b], [c, d], [e, f]] = [last.point, here.point, next.point];
                let bend = |a: F, c: F, e: F| half * ((e - c) / to - (c - a) / from);
                let point = [c - bend(a, c, e), d - bend(b, d, f)];
                self.set(k, AveragedPoint { point, ..here });
            }
            last = Some(here);
        }
    }

    /// Fills a polyline with the averages. Smoothing replaces each by the point of the parabola
    /// through the averages up to the smoothing length away, least squares weighted with `(1 −
    /// (d/s)²)³` and with their spacing.
    pub(super) fn smooth(&self, smoothing: F, line: &mut CoarseLine<F>) {
        line.count = 0;
        for (k, average) in (0..self.count).filter_map(|k| Some((k, self.average(k)?))) {
            let smooth = if smoothing > F::zero() { self.parabola(k, smoothing) } else { None };
            line.push(average.length, smooth.unwrap_or(average.point));
        }
    }

    /// The mean and the largest distance of the averages from their smoothed places.
    pub(super) fn distances(&self, line: &CoarseLine<F>) -> [F; 2] {
        let (mut sum, mut most, mut count) = (F::zero(), F::zero(), 0_u16);
        let averages = (0..self.count).filter_map(|k| self.average(k));
        for (average, place) in averages.zip(line.points.iter().take(line.count)) {
            let apart = distance(average.point, *place);
            (sum, most, count) = (sum + apart, most.max(apart), count + 1);
        }
        [sum / F::widened(f32::from(count.max(1))), most]
    }

    /// The parabola about an average.
    fn parabola(&self, centre: usize, smoothing: F) -> Option<[F; 2]> {
        let AveragedPoint { length: origin, point: middle, .. } = self.average(centre)?;
        let away = |average: AveragedPoint<F>| (average.length - origin) / smoothing;
        let mut first = centre;
        while first > 0 && away(self.average(first - 1)?) > -F::one() {
            first -= 1;
        }
        let mut m = [F::zero(); 5];
        let mut sums = [[F::zero(); 3]; 2];
        let (mut count, mut last) = (0, F::constant(-2.0));
        for k in first..self.count {
            let average = self.average(k)?;
            let x = away(average);
            if x >= F::one() {
                break;
            }
            // points at nearly the same place count once
            if x > last.plus(DISTINCT) {
                (count, last) = (count + 1, x);
            }
            let [from, to] =
                [k.saturating_sub(1), k + 1].map(|k| self.average(k).unwrap_or(average).length);
            let rest = F::one() - x * x;
            let mut weight = rest * rest * rest * (to - from);
            for (j, m) in m.iter_mut().enumerate() {
                *m += weight;
                for ((sum, value), middle) in sums.iter_mut().zip(average.point).zip(middle) {
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
