//! The gap between wheel and rail: the line on the wheel where its normal is perpendicular to `x`, and the distance of this line from the rail.
//!
//! A wheel of radius `r(y)` that yaws touches ahead of its lowest line where it is steep. In the wheel's axes, `θ` about the axle
//! from below, `α` the angle of its profile and `R` the turn by roll and yaw,
//!
//! ```text
//! p = R (r sin θ, y, r cos θ),   n = R (cos α sin θ, −sin α, cos α cos θ),   n_x = 0:  sin θ = tan α R₀₁/R₀₀ = −tan α tan yaw
//! ```
//!
//! The distance of `p` is measured along the rail's normal, from the rail's point under `p`. No plane of contact needs to be chosen, and a
//! flange at 70 degrees is treated like a tread.

use super::surface::{Place, Surface};
use super::{KSTRIP_SURFACE_CAPACITY, Position, sine_cosine};
use crate::number::{Float, length};
use crate::status::Error;

/// Distance below which points are added \[m\], and the largest number of points for one of the wheel's.
const NEAR: f64 = 0.3e-3;
const FINEST: usize = 4;
/// Default of the distance above which points are left out \[m\].
const REACH: f64 = 2e-3;
/// Least cosine of the profile's angle, and largest sine of θ, at which a wheel can touch.
const STEEPEST: f64 = 0.06;
const FARTHEST: f64 = 0.9;
/// Least cosine of the angle between two surfaces that face each other.
const FACING: f64 = 0.5;
/// Number of corrections of the rail's point under the wheel's. Each doubles the number of correct digits.
const CORRECTIONS: u32 = 4;

/// The gap between a wheel and a rail, point by point along the rail. A host with its own search of contact fills it. The first
/// count elements of each member are used.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap<F> {
    /// Length on the rail's surface from any origin \[m\], ascending. A host that works in a plane passes its coordinate in this plane.
    pub along: [F; KSTRIP_SURFACE_CAPACITY],
    /// Distance of the undeformed surfaces along the rail's normal \[m\]; negative where they would overlap.
    pub distance: [F; KSTRIP_SURFACE_CAPACITY],
    /// x of the point on the wheel's undeformed surface from the wheel's centre, axes of the track \[m\]: 0 without yaw.
    pub x: [F; KSTRIP_SURFACE_CAPACITY],
    /// y of this point \[m\].
    pub y: [F; KSTRIP_SURFACE_CAPACITY],
    /// z of this point \[m\], about the wheel's radius.
    pub z: [F; KSTRIP_SURFACE_CAPACITY],
    /// Angle of the tangent across x, mean of both surfaces \[rad\], positive from y to z; about -1.2 at the flange of a right wheel.
    pub angle: [F; KSTRIP_SURFACE_CAPACITY],
    /// Radius of curvature along x \[m\]: distance from the axle over the cosine of the angle between normal and radius.
    pub rolling_radius: [F; KSTRIP_SURFACE_CAPACITY],
    /// Number of points.
    pub count: u32,
    /// Reserved: zero.
    pub reserved: u32,
}

/// One point of a [`Gap`].
#[derive(Clone, Copy, Debug)]
struct GapPoint<F> {
    along: F,
    distance: F,
    place: [F; 3],
    angle: F,
    rolling_radius: F,
}

impl<F: Float> Gap<F> {
    fn get(&self, k: usize) -> Option<GapPoint<F>> {
        Some(GapPoint {
            along: *self.along.get(k)?,
            distance: *self.distance.get(k)?,
            place: [*self.x.get(k)?, *self.y.get(k)?, *self.z.get(k)?],
            angle: *self.angle.get(k)?,
            rolling_radius: *self.rolling_radius.get(k)?,
        })
    }

    fn set(&mut self, k: usize, point: &GapPoint<F>) {
        let [x, y, z] = point.place;
        let members = [
            (&mut self.along, point.along),
            (&mut self.distance, point.distance),
            (&mut self.x, x),
            (&mut self.y, y),
            (&mut self.z, z),
            (&mut self.angle, point.angle),
            (&mut self.rolling_radius, point.rolling_radius),
        ];
        for (list, value) in members {
            if let Some(place) = list.get_mut(k) {
                *place = value;
            }
        }
    }
}

/// Sines and cosines of the roll and the yaw of a wheel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turn<F> {
    roll: (F, F),
    yaw: (F, F),
}

impl<F: Float> Turn<F> {
    pub fn new(position: &Position<F>) -> Self {
        Self { roll: sine_cosine(position.roll), yaw: sine_cosine(position.yaw) }
    }

    /// Turns a vector from the wheelset's axes to the track's: by yaw, then by roll.
    pub fn to_track(self, [x, y, z]: [F; 3]) -> [F; 3] {
        let ((sin_roll, cos_roll), (sin_yaw, cos_yaw)) = (self.roll, self.yaw);
        let across = sin_yaw * x + cos_yaw * y;
        [
            cos_yaw * x - sin_yaw * y,
            cos_roll * across - sin_roll * z,
            sin_roll * across + cos_roll * z,
        ]
    }

    /// Turns a vector from the track's axes to the wheelset's.
    pub fn to_wheelset(self, [x, y, z]: [F; 3]) -> [F; 3] {
        let ((sin_roll, cos_roll), (sin_yaw, cos_yaw)) = (self.roll, self.yaw);
        let across = cos_roll * y + sin_roll * z;
        [
            cos_yaw * x + sin_yaw * across,
            cos_yaw * across - sin_yaw * x,
            cos_roll * z - sin_roll * y,
        ]
    }
}

/// A point of the wheel's line of contact.
struct Line<F> {
    /// Place from the wheel's centre, axes of the track \[m\].
    place: [F; 3],
    /// Depth below the place one wheel radius under the centre \[m\].
    below: F,
    /// Normal in the plane of y and z, out of the wheel.
    normal: [F; 2],
    /// Distance from the axle over the cosine of the angle between normal and radius.
    rolling_radius: F,
}

fn line_of_contact<F: Float>(point: Place<F>, wheel_radius: F, turn: Turn<F>) -> Option<Line<F>> {
    let Place { y, z, cosine, sine } = point;
    let size = length(cosine, sine);
    if !(cosine > size.times(STEEPEST)) {
        return None;
    }
    let ((sin_roll, cos_roll), (sin_yaw, cos_yaw)) = (turn.roll, turn.yaw);
    // sin θ = −tan α tan yaw
    let sin = -(sine * sin_yaw) / (cosine * cos_yaw);
    if !(sin.abs() < F::of(FARTHEST)) {
        return None;
    }
    let cos = (F::one() - sin * sin).sqrt();
    let radius = wheel_radius + z;
    let place = turn.to_track([radius * sin, y, radius * cos]);
    let [_, normal_y, normal_z] = turn.to_track([cosine * sin, -sine, cosine * cos]);
    // p_z − radius, without a difference of large numbers: cos roll cos θ − 1 = −sin² roll/(1 + cos roll) cos θ − sin² θ/(1 + cos θ)
    let less = (sin_roll * sin_roll) / cos_roll.plus(1.0) * cos + (sin * sin) / cos.plus(1.0);
    let across = sin_yaw * (radius * sin) + cos_yaw * y;
    let below = sin_roll * across + z * cos_roll * cos - wheel_radius * less;
    // the normal of the wheel makes the profile's angle with its radius
    Some(Line {
        place,
        below,
        normal: [normal_y, normal_z],
        rolling_radius: radius * size / cosine,
    })
}

/// Search for the point of a rail under another point.
struct Under<'a, F> {
    rail: &'a Surface<F>,
    /// The nearest of its points, where the search for the next one begins.
    nearest: Option<usize>,
}

impl<F: Float> Under<'_, F> {
    fn away(&self, k: usize, [y, z]: [F; 2]) -> Option<F> {
        let rail = self.rail.point(k)?;
        Some((y - rail.y).squared() + (z - rail.z).squared())
    }

    /// The nearest of the rail's points, and the square of its distance: of all for the first, then downhill from the last.
    fn find(&mut self, point: [F; 2]) -> Option<(usize, F)> {
        let count = self.rail.count as usize;
        let mut best = match self.nearest {
            Some(k) => (k, self.away(k, point)?),
            None => (0..count).fold((0, F::LARGEST), |best, k| match self.away(k, point) {
                Some(away) if away < best.1 => (k, away),
                _ => best,
            }),
        };
        for direction in [1, -1_isize] {
            let beside = |k: usize| {
                let next = k.checked_add_signed(direction).filter(|next| *next < count)?;
                Some((next, self.away(next, point)?))
            };
            while let Some(next) = beside(best.0).filter(|next| next.1 < best.1) {
                best = next;
            }
        }
        self.nearest = Some(best.0);
        Some(best)
    }

    /// The rail's point under another: place along the rail \[m\], distance along its normal, and the normal's direction, into the rail.
    fn foot(&mut self, point: [F; 2], reach: F) -> Option<(F, F, [F; 2])> {
        let (k, away) = self.find(point)?;
        let last = self.rail.count.saturating_sub(1) as i32;
        let mut s = F::widened(k as f32);
        // far away: no correction (the point is at most half a step from the nearest)
        let mut rail = self.rail.point(k)?;
        if away > (reach + self.rail.step).squared() {
            let is_end = k == 0 || k as i32 == last;
            let Place { y, z, cosine, sine } = rail;
            let [across, above] = [point[0] - y, point[1] - z].map(F::abs);
            // beside the rail rather than above it
            let is_beside = across > above.times(2.0) + reach;
            let normal = [-sine, cosine];
            return (!is_end && !is_beside).then_some((s * self.rail.step, F::LARGEST, normal));
        }
        let [y, z] = point;
        let (last, close) = (F::widened(last as f32), F::EPSILON.sqrt());
        for _ in 0..CORRECTIONS {
            let (e_y, e_z) = (y - rail.y, z - rail.z);
            let Place { cosine, sine, .. } = rail;
            let apart = e_y * sine - e_z * cosine;
            // e·t = 0 by Newton's step: −d(e·t)/ds = t·t + κ (e × t)
            let step = self.rail.step;
            let slope = (cosine.squared() + sine.squared()) * step + self.rail.bend(s)? * apart;
            let ahead = (e_y * cosine + e_z * sine) / slope.max(step.times(0.5));
            s = (s + ahead).clamped(F::zero(), last);
            rail = self.rail.at(s)?;
            // (the next step would be about the square of this one)
            if ahead.abs() <= close {
                break;
            }
        }
        let inside = s > F::zero() && s < last;
        let size = F::one() / length(rail.cosine, rail.sine);
        let (cosine, sine) = (rail.cosine * size, rail.sine * size);
        let distance = (y - rail.y) * sine - (z - rail.z) * cosine;
        inside.then_some((s * self.rail.step, distance, [-sine, cosine]))
    }
}

/// The rail's point under another: place along the rail \[m\], distance \[m\], normal.
type Foot<F> = (F, F, [F; 2]);

/// A wheel over a rail.
struct Above<'a, F> {
    wheel_radius: F,
    position: Position<F>,
    turn: Turn<F>,
    reach: F,
    under: Under<'a, F>,
}

impl<F: Float> Above<'_, F> {
    /// The wheel's line of contact at a place of its profile, and the rail's point under it.
    fn look(&mut self, place: Place<F>) -> Option<(Line<F>, Foot<F>)> {
        let line = line_of_contact(place, self.wheel_radius, self.turn)?;
        let [_, y, _] = line.place;
        let point = [self.position.lateral + y, self.position.vertical + line.below];
        let (along, distance, normal) = self.under.foot(point, self.reach)?;
        let ([wheel_y, wheel_z], [rail_y, rail_z]) = (line.normal, normal);
        let facing = wheel_y * rail_y + wheel_z * rail_z > length(wheel_y, wheel_z).times(FACING);
        facing.then_some((line, (along, distance, normal)))
    }

    /// The result of a look as a point of the gap, where the point is within reach.
    fn point(
        &self,
        (line, (along, distance, [normal_y, normal_z])): (Line<F>, Foot<F>),
    ) -> Option<GapPoint<F>> {
        let Line { place, normal: [wheel_y, wheel_z], rolling_radius, .. } = line;
        // the mean of both surfaces' angles is that of the sum of their unit normals
        let size = length(wheel_y, wheel_z);
        let (sum_y, sum_z) = (wheel_y + normal_y * size, wheel_z + normal_z * size);
        if !(distance < self.reach && sum_z > F::zero() && rolling_radius > F::zero()) {
            return None;
        }
        Some(GapPoint { along, distance, place, angle: (-sum_y / sum_z).atan(), rolling_radius })
    }
}

/// The gap between a right wheel and a rail. Only points nearer to the rail than `reach` are written; zero: 2 mm. Where surfaces are
/// nearer than 0.3 mm there are up to four points for one of the wheel's profile, because the contact of a flange is one millimetre wide.
/// Returns the smallest distance of the points, or `reach` where all are farther.
///
/// # Errors
/// [`Error::NotPrepared`], [`Error::NotFinite`], [`Error::RollingRadius`]; [`Error::ProfileEnd`] when no point of the wheel is above the
/// rail; nothing has been written then.
pub fn touch<F: Float>(
    rail: &Surface<F>,
    wheel: &Surface<F>,
    wheel_radius: F,
    position: &Position<F>,
    reach: F,
    gap: &mut Gap<F>,
) -> Result<F, Error> {
    rail.check()?;
    wheel.check()?;
    position.check()?;
    if ![wheel_radius, reach].iter().all(|x| x.is_finite_number()) {
        return Err(Error::NotFinite);
    }
    if wheel_radius <= F::zero() {
        return Err(Error::RollingRadius);
    }
    let reach = if reach > F::zero() { reach } else { F::of(REACH) };
    let (position, turn) = (*position, Turn::new(position));
    let under = Under { rail, nearest: None };
    let mut above = Above { wheel_radius, position, turn, reach, under };
    let is_near = |point: &Option<GapPoint<F>>| {
        point.as_ref().is_some_and(|point| point.distance < F::of(NEAR))
    };
    // those of the wheel's own points, from the last to the first, at the end of the room
    let mut there = [false; KSTRIP_SURFACE_CAPACITY];
    let (mut first, mut near, mut is_last_near, mut faces) =
        (KSTRIP_SURFACE_CAPACITY, 0, false, false);
    for (k, there) in there.iter_mut().enumerate().take(wheel.count as usize).rev() {
        let seen = wheel.point(k).and_then(|place| above.look(place));
        faces |= seen.is_some();
        let here = seen.and_then(|seen| above.point(seen));
        if let Some(point) = &here {
            first = first.saturating_sub(1);
            gap.set(first, point);
            *there = true;
        }
        near += usize::from(is_last_near && is_near(&here));
        is_last_near = is_near(&here);
    }
    if !faces {
        return Err(Error::ProfileEnd);
    }
    let parts = (first / near.max(1) + 1).min(FINEST);
    // with those between them, in ascending order along the rail, from the first on: there is room before what is still to be read
    let (mut count, mut least) = (0, reach);
    let mut end: Option<F> = None;
    let mut write = |gap: &mut Gap<F>, point: GapPoint<F>| {
        if end.is_none_or(|end| point.along > end) {
            gap.set(count, &point);
            count += 1;
            least = least.min(point.distance);
            end = Some(point.along);
        }
    };
    let mut is_last_near = false;
    for (k, there) in there.iter().enumerate().take(wheel.count as usize) {
        let here = if *there { gap.get(first) } else { None };
        first += usize::from(*there);
        if is_last_near && is_near(&here) {
            for part in 1..parts {
                let share = F::widened(part as f32) / F::widened(parts as f32);
                let place = wheel.at(F::widened(k as f32) + (share - F::one()));
                let seen = place.and_then(|place| above.look(place));
                if let Some(point) = seen.and_then(|seen| above.point(seen)) {
                    write(gap, point);
                }
            }
        }
        is_last_near = is_near(&here);
        if let Some(point) = here {
            write(gap, point);
        }
    }
    gap.count = count as u32;
    gap.reserved = 0;
    Ok(least)
}
