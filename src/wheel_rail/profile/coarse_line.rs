//! The order of a profile's points: a polyline past which all of them lie.

use super::curve::{Points, distance};
use crate::number::{Float, at, length};
use crate::status::Error;
use crate::wheel_rail::KSTRIP_SURFACE_CAPACITY;

/// Points of a polyline: as many as a prepared profile has.
pub(super) const LINE_CAPACITY: usize = KSTRIP_SURFACE_CAPACITY;
/// First radius of the line, as a share of the extent of the points.
const FINEST: f64 = 1.0 / (KSTRIP_SURFACE_CAPACITY as f64 - 1.0);
/// Growth of the radius from one attempt to the next. The last one is a twentieth of the extent.
const COARSER: f64 = 1.5;
const RADII: i32 = 9;
/// Largest sum of 1 − cos of the angles between neighbours: four right angles, and 11 degrees at
/// each node. Points that scatter by a tenth of the radius or more exceed it.
const CORNERS: f64 = 4.0;
const ROUGHNESS: f64 = 0.02;
/// Of so many points one may be a stray: lie beside the line, with its neighbours on it.
const STRAYS: usize = 128;

/// A polyline with the length up to each of its points.
pub(super) struct CoarseLine<F> {
    pub points: [[F; 2]; LINE_CAPACITY],
    /// Length up to the point \[m\], ascending.
    pub lengths: [F; LINE_CAPACITY],
    pub count: usize,
}

/// The point of a polyline that is nearest to another point.
pub(super) struct NearestPoint<F> {
    /// The segment, by the number of the point at which it begins.
    pub segment: usize,
    /// Length from the beginning \[m\]. The first and the last segment have no outer end.
    pub length: F,
    /// Square of its distance \[m²\]. Here all segments end.
    squared_distance: F,
}

/// The points of a profile, forward or backward.
fn in_order<F: Float>(y: &[F], z: &[F], backward: bool) -> impl Iterator<Item = [F; 2]> {
    let last = y.len().saturating_sub(1);
    (0..y.len()).map(move |k| if backward { last - k } else { k }).map(|k| [at(y, k), at(z, k)])
}

impl<F: Float> NearestPoint<F> {
    /// Whether the other point is nearer than a radius.
    pub(super) fn is_within(&self, radius: F) -> bool {
        self.squared_distance < radius * radius
    }
}

impl<F: Float> Points<F> for CoarseLine<F> {
    fn count(&self) -> usize {
        self.count
    }

    #[inline]
    fn get(&self, k: usize) -> Option<(F, [F; 2])> {
        Some((*self.lengths.get(k).filter(|_| k < self.count)?, *self.points.get(k)?))
    }
}

impl<F: Float> CoarseLine<F> {
    pub(super) fn new() -> Self {
        let none = F::zero();
        Self { points: [[none; 2]; LINE_CAPACITY], lengths: [none; LINE_CAPACITY], count: 0 }
    }

    /// Appends a point; false where there is no room.
    pub(super) fn push(&mut self, length: F, point: [F; 2]) -> bool {
        let k = self.count;
        let (Some(last), Some(place)) = (self.lengths.get_mut(k), self.points.get_mut(k)) else {
            return false;
        };
        (*last, *place) = (length, point);
        self.count += 1;
        true
    }

    /// Whether it ends at smaller y than it begins.
    pub(super) fn is_reversed(&self) -> bool {
        let [first, last] = [0, self.count.saturating_sub(1)].map(|k| self.get(k));
        last.map(|(_, [y, _])| y) < first.map(|(_, [y, _])| y)
    }

    /// The length up to the last point.
    pub(super) fn length(&self) -> F {
        self.get(self.count.saturating_sub(1)).map_or(F::zero(), |(length, _)| length)
    }

    /// Fills the polyline with some of the points of a profile, so that each of its points is at
    /// least one radius away from all of the line before it, and every other point of the profile
    /// is nearer to the line. Points that are scanned twice, lie behind their predecessor or
    /// scatter by less than the radius are skipped. The radius is the least one with which
    /// the line has room and is smooth. Returns it.
    pub(super) fn follow(&mut self, y: &[F], z: &[F], extent: F) -> Result<F, Error> {
        let mut radius = extent.times(FINEST);
        for _ in 0..RADII {
            // in the opposite order a stray at the beginning is one at the end
            for backward in [false, true] {
                let is_tried = !backward || y.len() >= STRAYS;
                if !(is_tried && self.cover(y, z, backward, radius) && self.is_smooth()) {
                    break;
                }
                if self.has_near(y, z, radius) {
                    return Ok(radius);
                }
            }
            radius = radius.times(COARSER);
        }
        Err(Error::Scatter)
    }

    /// Whether there is room.
    fn cover(&mut self, y: &[F], z: &[F], backward: bool, radius: F) -> bool {
        self.count = 0;
        let mut segment = 0;
        for point in in_order(y, z, backward) {
            if self.count >= 2 {
                let foot = self.nearest(point, segment, radius);
                segment = foot.segment;
                if foot.is_within(radius) {
                    continue;
                }
                // the first two may be in the wrong order
                if self.count == 2 && foot.length < F::zero() {
                    let [first, second, ..] = &mut self.points;
                    core::mem::swap(first, second);
                }
            }
            if self.turns_back(point) {
                self.count -= 1;
            }
            let last = self.get(self.count.wrapping_sub(1));
            let (length, last) = last.unwrap_or((F::zero(), point));
            let step = distance(last, point);
            if self.count == 1 && step < radius {
                continue;
            }
            segment = self.count.saturating_sub(1);
            if !self.push(length + step, point) {
                return false;
            }
        }
        let all = self.count;
        while let Some((_, last)) = self.get(self.count.wrapping_sub(1)) {
            self.count -= 1;
            if !self.turns_back(last) {
                self.count += 1;
                break;
            }
        }
        // strays at the end have taken the place of the points before them
        self.count >= 2 && (self.count == all || self.extend(y, z, backward, radius))
    }

    /// Appends points that lie beyond the end. Returns whether there is room.
    fn extend(&mut self, y: &[F], z: &[F], backward: bool, radius: F) -> bool {
        in_order(y, z, backward).all(|point| {
            let foot = self.nearest(point, self.count.saturating_sub(2), radius);
            let Some((end, last)) = self.get(self.count.wrapping_sub(1)) else { return false };
            let is_beyond = foot.length > end && !foot.is_within(radius);
            !is_beyond || self.turns_back(point) || self.push(end + distance(last, point), point)
        })
    }

    /// Whether no points but a few strays are farther from the line than the radius: those that
    /// were passed over may be.
    fn has_near(&self, y: &[F], z: &[F], radius: F) -> bool {
        let (most, mut segment, mut strays) = (y.len() / STRAYS, 0, 0);
        y.iter().zip(z).all(|(y, z)| {
            let foot = self.nearest([*y, *z], segment, radius);
            segment = foot.segment;
            strays += usize::from(!foot.is_within(radius));
            strays <= most
        })
    }

    /// Whether the line would turn by more than 120 degrees at its last point, which then lies
    /// ahead of its successors or beside the profile.
    fn turns_back(&self, [v, w]: [F; 2]) -> bool {
        let count = self.count;
        let [Some((_, before)), Some((_, last))] = [2, 1].map(|k| self.get(count.wrapping_sub(k)))
        else {
            return false;
        };
        let [[a, b], [c, d]] =
            [[last[0] - before[0], last[1] - before[1]], [v - last[0], w - last[1]]];
        a * c + b * d < -(length(a, b) * length(c, d)).times(0.5)
    }

    fn is_smooth(&self) -> bool {
        let count = self.count;
        let limit = F::widened(count as f32).times(ROUGHNESS).plus(CORNERS);
        let mut rough = F::zero();
        let mut last: Option<[F; 2]> = None;
        for k in 1..count {
            let (Some((from, [y, z])), Some((to, [v, w]))) = (self.get(k - 1), self.get(k)) else {
                break;
            };
            let width = to - from;
            let [cosine, sine] = [(v - y) / width, (w - z) / width];
            if let Some([c, s]) = last {
                rough += F::one() - (c * cosine + s * sine);
            }
            last = Some([cosine, sine]);
        }
        rough <= limit
    }

    #[inline]
    fn foot(&self, segment: usize, point: [F; 2]) -> Option<NearestPoint<F>> {
        let (from, [y, z]) = self.get(segment)?;
        let (to, [v, w]) = self.get(segment + 1)?;
        let width = to - from;
        let [cosine, sine] = [(v - y) / width, (w - z) / width];
        let [across, down] = [point[0] - y, point[1] - z];
        let length = across * cosine + down * sine;
        let within = length.clamped(F::zero(), width);
        let [across, down] = [across - within * cosine, down - within * sine];
        let is_outside =
            (segment == 0 && length < F::zero()) || (segment + 2 == self.count && length > width);
        let length = from + if is_outside { length } else { within };
        Some(NearestPoint { segment, length, squared_distance: across.squared() + down.squared() })
    }

    /// The foot of a point. The search begins at a segment and goes downhill; where this leads to
    /// none within the radius, all segments are compared.
    pub(super) fn nearest(&self, point: [F; 2], segment: usize, radius: F) -> NearestPoint<F> {
        let far = NearestPoint { segment: 0, length: F::zero(), squared_distance: F::LARGEST };
        let mut best = self.foot(segment, point).unwrap_or(far);
        let segments = self.count.saturating_sub(1);
        for _ in 0..segments {
            let k = best.segment;
            let before = if k > 0 { self.foot(k - 1, point) } else { None };
            let after = if k + 1 < segments { self.foot(k + 1, point) } else { None };
            for other in [before, after].into_iter().flatten() {
                if other.squared_distance < best.squared_distance {
                    best = other;
                }
            }
            if best.segment == k {
                break;
            }
        }
        if best.squared_distance >= radius * radius {
            for other in (0..segments).filter_map(|k| self.foot(k, point)) {
                if other.squared_distance < best.squared_distance {
                    best = other;
                }
            }
        }
        best
    }
}
