//! The point of a rail under another point: where the rail's normal leads to it.

use crate::number::{Float, Strips};
use crate::wheel_rail::profile::{Piece, PreparedProfile};

/// Number of corrections of a place on the rail. Each doubles the number of correct digits. The
/// last is smaller than this share of the way between two points.
const FOOT_STEPS: u32 = 4;
const FOOT_FOUND: f64 = 1e-5;

/// Number of the rail's points from which the nearest is looked for.
const SAMPLES: usize = 32;

/// Least cosine of the angle between two surfaces that face each other.
const FACING: f64 = 0.5;
/// Least cosine of a rail's angle: a side that leans back by more, and what is below it, is left
/// out.
pub(crate) const UNDERCUT: f64 = -1.0 / 3.0;

/// A rail, and where the search for the next point begins.
pub(super) struct Rail<'a, F> {
    surface: &'a PreparedProfile<F>,
    /// First and last of the points around the highest one between which it does not lean back.
    upright: [usize; 2],
    /// Distance from the rail above which only the nearest of its points is looked for \[m\].
    reach: F,
    /// The nearest of its points to the last point.
    nearest: Option<usize>,
    /// The last point if it was outside the rail, and its distance from the nearest of the rail's.
    outside: Option<([F; 2], F)>,
    /// A place outside the rail, and the square of a distance within which no point is in reach.
    free: ([F; 2], F),
    /// Whether a point has faced the rail.
    pub faced: bool,
    /// Whether no point is passed.
    pub looks_at_all: bool,
}

/// The points of a rail below other points.
pub(super) struct Foot<P> {
    /// Places along the rail \[m\].
    pub along: P,
    /// Distances along its normal \[m\].
    pub distance: P,
    /// Unit normals into the rail, in the plane of y and z.
    pub normal: [P; 2],
}

impl<'a, F: Float> Rail<'a, F> {
    pub fn new(surface: &'a PreparedProfile<F>, reach: F) -> Self {
        let free = ([F::zero(); 2], F::zero());
        let (faced, looks_at_all) = (false, false);
        let upright = upright(surface);
        Self { surface, upright, reach, nearest: None, outside: None, free, faced, looks_at_all }
    }

    /// Whether the rail is certainly out of reach of points side by side, and there is no need to
    /// look for what is under them: they are so near to a place outside the rail that the rail's
    /// points are still too far away (by the triangle's inequality).
    #[inline]
    pub fn is_far<P: Strips<F>>(&self, [y, z]: [P; 2]) -> bool {
        let ([from_y, from_z], square) = self.free;
        let moved = (y - P::all(from_y)).squared() + (z - P::all(from_z)).squared();
        let passes = square > F::zero() && !self.looks_at_all;
        passes && !P::any_exceeds([moved], [P::all(square)])
    }

    /// The rail was out of reach of the last points.
    pub fn set_free(&mut self) {
        let Some((place, away)) = self.outside.take() else { return };
        let free = away.sqrt().times(1.0 - 1e-3) - self.reach - self.surface.step;
        self.free = (place, free.max(F::zero()).squared());
        // the nearest point of the rail is searched from the beginning
        if free > F::zero() {
            self.nearest = None;
        }
    }

    fn away(&self, k: usize, [y, z]: [F; 2]) -> Option<F> {
        let rail = self.surface.point(k)?;
        Some((y - rail.y).squared() + (z - rail.z).squared())
    }

    /// The nearest of the rail's points, and the square of its distance: downhill from the last,
    /// and at first from the nearest of some points.
    fn nearest_point(&mut self, point: [F; 2]) -> Option<(usize, F)> {
        let count = self.surface.count as usize;
        let closer = |k: usize, best: F| {
            let away = self.away(k, point).filter(|away| k < count && *away < best)?;
            Some((k, away))
        };
        let mut best = match self.nearest {
            Some(k) => (k, self.away(k, point)?),
            None => {
                let some = (0..count).step_by((count / SAMPLES).max(1));
                some.fold((0, F::LARGEST), |best, k| closer(k, best.1).unwrap_or(best))
            }
        };
        for direction in [1, -1_isize] {
            while let Some(next) =
                best.0.checked_add_signed(direction).and_then(|k| closer(k, best.1))
            {
                best = next;
            }
        }
        self.nearest = Some(best.0);
        Some(best)
    }

    /// Where the rail is under a point of a surface that faces it: between which point and the
    /// next, nearest to the share 0 or 1 of the way. None where the rail is out of reach. The
    /// normal of the surface has a length.
    pub fn piece_below(
        &mut self, [y, z]: [F; 2], [normal_y, normal_z]: [F; 2], length: F,
    ) -> Option<(usize, F)> {
        let (k, away) = self.nearest_point([y, z])?;
        let rail = self.surface.point(k)?;
        let [e_y, e_z] = [y - rail.y, z - rail.z];
        let is_inside = e_z * rail.cosine - e_y * rail.sine > F::zero();
        self.outside = if is_inside { None } else { Some(([y, z], away)) };
        // the next point on this side is not nearer, so that e·t = 0 before it
        let is_ahead = e_y * rail.cosine + e_z * rail.sine > F::zero();
        let piece = if is_ahead { (k, F::zero()) } else { (k.checked_sub(1)?, F::one()) };
        let [first, last] = self.upright;
        let leans_back = piece.0 + 1 < first || piece.0 > last;
        let is_beyond = leans_back || piece.0 + 1 >= self.surface.count as usize;
        // beside the rail rather than above it; a point inside is neither
        let is_beside = !is_inside && e_y.abs() > e_z.abs().times(2.0) + self.reach;
        let faces = normal_z * rail.cosine - normal_y * rail.sine > length.times(FACING);
        if is_beyond || is_beside || !faces {
            return None;
        }
        self.faced = true;
        // A point inside the rail counts at any depth. Deeper than a radius of the rail it has
        // several nearest points, between which the place under it jumps.
        let is_near = away <= (self.reach + self.surface.step).squared();
        (is_near || is_inside).then_some(piece)
    }

    /// The rail's points under others, side by side; numbers without a meaning where there is none.
    #[inline(always)]
    pub fn feet<P: Strips<F>, const N: usize>(
        &self, [y, z]: [P; 2], pieces: &[Option<(usize, F)>; N],
    ) -> Foot<P> {
        let start = |i: usize| pieces.get(i).copied().flatten().unwrap_or((0, F::zero()));
        let step = P::all(self.surface.step);
        let first = P::gather(|i| F::widened(start(i).0 as u32 as f32));
        let from = self.surface.points(|i| start(i).0);
        let to = self.surface.points(|i| start(i).0 + 1);
        let piece = Piece::new(from, to, step);
        let mut u: P = P::gather(|i| start(i).1);
        for _ in 0..FOOT_STEPS {
            let [rail_y, rail_z] = piece.at(u);
            let (e_y, e_z) = (y - rail_y.value, z - rail_z.value);
            // Newton's step of e·t = 0: −d(e·t)/du = t·t − e·t'
            let square = rail_y.slope.squared() + rail_z.slope.squared();
            let slope = square - (e_y * rail_y.bend + e_z * rail_z.bend);
            let ahead = (e_y * rail_y.slope + e_z * rail_z.slope) / slope.max(square.times(0.5));
            u = (u + ahead).max(P::zero()).min(P::one());
            // the next step would be less than the square of this one
            if !P::any_exceeds([ahead.abs()], [P::constant(FOOT_FOUND)]) {
                break;
            }
        }
        let [rail_y, rail_z] = piece.at(u);
        let size = (rail_y.slope.squared() + rail_z.slope.squared()).sqrt().inverse();
        let (cosine, sine) = (rail_y.slope * size, rail_z.slope * size);
        let distance = (y - rail_y.value) * sine - (z - rail_z.value) * cosine;
        Foot { along: (first + u) * step, distance, normal: [-sine, cosine] }
    }
}

/// First and last of the points around a rail's highest one between which no cosine is below
/// [`UNDERCUT`].
fn upright<F: Float>(rail: &PreparedProfile<F>) -> [usize; 2] {
    let count = rail.count as usize;
    let [z, cosine] = [&rail.z, &rail.cosine].map(|list| list.get(..count).unwrap_or(&[]));
    let lower = |(highest, least), (k, z): (usize, &F)| {
        if *z < least { (k, *z) } else { (highest, least) }
    };
    let (highest, _) = z.iter().enumerate().fold((0, F::LARGEST), lower);
    let leans_back = |cosine: &F| *cosine <= F::of(UNDERCUT);
    let (before, after) = cosine.split_at_checked(highest).unwrap_or((&[], cosine));
    let first = before.iter().rposition(leans_back).map_or(0, |k| k + 1);
    let last = after.iter().position(leans_back).map_or(count, |k| highest + k);
    [first, last.saturating_sub(1)]
}
