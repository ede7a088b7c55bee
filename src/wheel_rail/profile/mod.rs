//! A profile at equal steps of its length, with its direction. It is cubic between the points, so
//! that distances have continuous slopes.

mod averaged_points;
pub(crate) mod between;
mod coarse_line;
mod curve;
pub(crate) mod plausibility;
mod prepare;

use crate::number::{Arithmetic, Float, Strips, are_finite, set_at};
use crate::numerics::hermite::{Along, Cubic};
use crate::status::Error;
use crate::wheel_rail::KSTRIP_SURFACE_CAPACITY;

/// A shorter step than that of the smallest profile that is prepared, 1 µm in 511 steps \[m\].
const SHORTEST_STEP: f64 = 1e-9;

/// A profile, prepared by kstrip_prepare_profile(): points at equal steps of its length, toward
/// larger y, and its direction. It holds plain numbers and may be copied.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PreparedProfile<F> {
    /// y \[m\], to the right: of a rail from its origin, of a wheel from its running circle, with
    /// the flange at small y.
    pub y: [F; KSTRIP_SURFACE_CAPACITY],
    /// z \[m\], down; of a wheel its radius minus wheel_radius.
    pub z: [F; KSTRIP_SURFACE_CAPACITY],
    /// Derivative of y with respect to the length: the cosine of the profile's angle.
    pub cosine: [F; KSTRIP_SURFACE_CAPACITY],
    /// Derivative of z with respect to the length: the sine of the profile's angle.
    pub sine: [F; KSTRIP_SURFACE_CAPACITY],
    /// Length between two points \[m\].
    pub step: F,
    /// Mean distance between the points that were given \[m\].
    pub spacing: F,
    /// Number of points, 4 to KSTRIP_SURFACE_CAPACITY.
    pub count: u32,
    /// The form of the profile: 0, or a sum of 1 (it is not that of a wheel), 2 (it is not that of
    /// a rail), 4 (it has few points, and is not smooth between them), 8 (it has the tip of a
    /// flange) and 16 (it goes down on both sides as the head of a rail).
    pub form: u32,
}

impl<F: Float> Default for PreparedProfile<F> {
    fn default() -> Self {
        Self::new()
    }
}

/// A point of a curve and its derivative with respect to the length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CurvePoint<F> {
    pub y: F,
    pub z: F,
    pub cosine: F,
    pub sine: F,
}

impl<F: Float> PreparedProfile<F> {
    /// A profile without points, which [`prepare`](Self::prepare) fills: for a static, for a field,
    /// or for the heap, as in `Box::new(PreparedProfile::new())`. Functions that take it before
    /// return [`Error::NotPrepared`].
    #[must_use]
    pub const fn new() -> Self {
        let none = [F::ZERO; KSTRIP_SURFACE_CAPACITY];
        Self {
            y: none,
            z: none,
            cosine: none,
            sine: none,
            step: F::ZERO,
            spacing: F::ZERO,
            count: 0,
            form: 0,
        }
    }

    /// Directions from five points, exact for polynomials of degree four; from three at the ends.
    pub(super) fn directions(&mut self) {
        let count = self.count as usize;
        for (list, slopes) in [(&self.y, &mut self.cosine), (&self.z, &mut self.sine)] {
            let at = |i: usize| list.get(i).copied().unwrap_or(F::zero());
            for (k, slope) in slopes.iter_mut().enumerate().take(count) {
                let rise = match (k, count - 1 - k) {
                    (0, _) => (at(1) - at(0)).times(2.0) - (at(2) - at(0)).times(0.5),
                    (_, 0) => (at(k) - at(k - 1)).times(2.0) - (at(k) - at(k - 2)).times(0.5),
                    (1, _) | (_, 1) => (at(k + 1) - at(k - 1)).times(0.5),
                    _ => {
                        let (near, far) = (at(k + 1) - at(k - 1), at(k + 2) - at(k - 2));
                        (near.times(8.0) - far).times(1.0 / 12.0)
                    }
                };
                *slope = rise / self.step;
            }
        }
    }

    pub(crate) fn check(&self) -> Result<(), Error> {
        let count = self.count as usize;
        let sound = (4..=KSTRIP_SURFACE_CAPACITY).contains(&count)
            && self.step.is_finite_number()
            && self.step >= F::of(SHORTEST_STEP)
            && self.spacing.is_finite_number();
        let lists = [&self.y, &self.z, &self.cosine, &self.sine];
        let finite = lists.iter().all(|list| list.get(..count).is_some_and(are_finite));
        if sound && finite { Ok(()) } else { Err(Error::NotPrepared) }
    }

    /// A point by its number.
    #[inline]
    pub(crate) fn point(&self, k: usize) -> Option<CurvePoint<F>> {
        Some(CurvePoint {
            y: *self.y.get(k)?,
            z: *self.z.get(k)?,
            cosine: *self.cosine.get(k)?,
            sine: *self.sine.get(k)?,
        })
    }

    /// Replaces a point.
    pub(super) fn set_point(&mut self, k: usize, place: CurvePoint<F>) {
        let Self { y, z, cosine, sine, .. } = self;
        let lists = [y, z, cosine, sine].into_iter();
        for (list, value) in lists.zip([place.y, place.z, place.cosine, place.sine]) {
            set_at(list, k, value);
        }
    }

    /// Points side by side, by their numbers.
    #[inline(always)]
    pub(crate) fn points<P: Strips<F>>(&self, numbers: impl Fn(usize) -> usize) -> CurvePoint<P> {
        let of = |list: &[F; KSTRIP_SURFACE_CAPACITY]| {
            P::gather(|i| list.get(numbers(i)).copied().unwrap_or(F::zero()))
        };
        CurvePoint {
            y: of(&self.y),
            z: of(&self.z),
            cosine: of(&self.cosine),
            sine: of(&self.sine),
        }
    }

    /// The curvature of a wheel's profile, positive where it is convex, at a share of the way from
    /// a point to the next: linear between the points, which have that of their neighbours'
    /// directions.
    pub(super) fn curvature(&self, k: usize, share: F) -> F {
        let last = (self.count as usize).saturating_sub(2);
        let [from, to] = [k, k + 1].map(|k| {
            let k = k.min(last).max(1);
            let (Some(before), Some(after)) = (self.point(k - 1), self.point(k + 1)) else {
                return F::zero();
            };
            (before.sine * after.cosine - before.cosine * after.sine) / self.step.times(2.0)
        });
        from + (to - from) * share
    }

    /// Whether the curve ends at a length from its first point, so close in steps.
    pub(super) fn ends_at(&self, length: F, close: F) -> bool {
        let steps = length / self.step;
        let last = F::widened(self.count.saturating_sub(1) as f32);
        steps <= close || steps >= last - close
    }

    /// The curve at a length from its first point, as a function of the length in steps.
    pub(super) fn along(&self, length: F) -> [Along<F>; 2] {
        let steps = length / self.step;
        let k = (steps.whole().max(0) as usize).min((self.count as usize).saturating_sub(2));
        let none = CurvePoint { y: F::zero(), z: F::zero(), cosine: F::one(), sine: F::zero() };
        let [from, to] = [k, k + 1].map(|k| self.point(k).unwrap_or(none));
        Piece::new(from, to, self.step).at(steps - F::widened(k as f32))
    }

    /// The curve at a share of the way from a point to the next; none past the last point.
    #[inline]
    pub(crate) fn curve_at(&self, k: usize, share: F) -> Option<CurvePoint<F>> {
        let from = self.point(k).filter(|_| k < self.count as usize)?;
        if share == F::zero() {
            return Some(from);
        }
        let [y, z] = Piece::new(from, self.point(k + 1)?, self.step).at(share);
        let per_step = F::one() / self.step;
        Some(CurvePoint {
            y: y.value,
            z: z.value,
            cosine: y.slope * per_step,
            sine: z.slope * per_step,
        })
    }
}

/// The curve between two points: cubics of the share of the way, with the directions of both.
pub(crate) struct Piece<T> {
    y: Cubic<T>,
    z: Cubic<T>,
}

impl<T: Arithmetic> Piece<T> {
    #[inline]
    pub(crate) fn new(from: CurvePoint<T>, to: CurvePoint<T>, step: T) -> Self {
        Self {
            y: Cubic::new([from.y, to.y], [from.cosine * step, to.cosine * step]),
            z: Cubic::new([from.z, to.z], [from.sine * step, to.sine * step]),
        }
    }

    /// y and z at a share of the way.
    #[inline]
    pub(crate) fn at(&self, u: T) -> [Along<T>; 2] {
        [self.y.along(u), self.z.along(u)]
    }
}
