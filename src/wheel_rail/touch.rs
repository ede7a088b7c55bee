//! The gap between wheel and rail: the line of contact of the wheel (`line_of_contact`), and the
//! distance of this line from the rail.
//!
//! The distance of a point is measured along the rail's normal, from the rail's point under it
//! (`under`). No plane of contact needs to be chosen, and a flange at 70 degrees is treated like a
//! tread.

use super::line_of_contact::Wheel;
use super::surface::{Place, Surface};
use super::under::Rail;
use super::{KSTRIP_SURFACE_CAPACITY, Position};
use crate::number::avx::with_avx;
use crate::number::{Float, Strips, are_finite};
use crate::status::Error;

/// Distance below which points are added \[m\], and the largest number of points for one of the
/// wheel's.
const NEAR: f64 = 0.3e-3;
const FINEST: usize = 4;
/// Default of the distance above which points are left out \[m\].
const REACH: f64 = 2e-3;
/// Number of points that are looked at side by side.
const FOUR: usize = 4;

/// The gap between a wheel and a rail, point by point along the rail. A host with its own search of
/// contact fills it. The first count elements of each member are used.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap<F> {
    /// Length on the rail's surface from any origin \[m\], ascending. A host that works in a plane
    /// passes its coordinate in this plane.
    pub along: [F; KSTRIP_SURFACE_CAPACITY],
    /// Distance of the undeformed surfaces along the rail's normal \[m\]; negative where they would
    /// overlap.
    pub distance: [F; KSTRIP_SURFACE_CAPACITY],
    /// x of the point on the wheel's undeformed surface from the wheel's centre, axes of the track
    /// \[m\]: 0 without yaw.
    pub x: [F; KSTRIP_SURFACE_CAPACITY],
    /// y of this point \[m\].
    pub y: [F; KSTRIP_SURFACE_CAPACITY],
    /// z of this point \[m\], about the wheel's radius.
    pub z: [F; KSTRIP_SURFACE_CAPACITY],
    /// Angle of the tangent across x, mean of both surfaces \[rad\], positive from y to z; about
    /// -1.2 at the flange of a right wheel.
    pub angle: [F; KSTRIP_SURFACE_CAPACITY],
    /// Radius of curvature along x \[m\]: distance from the axle divided by the cosine of the angle
    /// between normal and radius.
    pub rolling_radius: [F; KSTRIP_SURFACE_CAPACITY],
    /// Number of points.
    pub count: u32,
    /// Reserved: zero.
    pub reserved: u32,
}

/// One point of a [`Gap`]: its members in their order.
type GapPoint<F> = [F; 7];

impl<F: Float> Gap<F> {
    /// The members, in their order.
    pub(super) fn lists(&self) -> [&[F; KSTRIP_SURFACE_CAPACITY]; 7] {
        let Self { along, distance, x, y, z, angle, rolling_radius, .. } = self;
        [along, distance, x, y, z, angle, rolling_radius]
    }

    fn get(&self, k: usize) -> GapPoint<F> {
        self.lists().map(|list| list.get(k).copied().unwrap_or(F::zero()))
    }

    fn set(&mut self, k: usize, point: &GapPoint<F>) {
        let Self { along, distance, x, y, z, angle, rolling_radius, .. } = self;
        let lists = [along, distance, x, y, z, angle, rolling_radius];
        for (list, value) in lists.into_iter().zip(point) {
            if let Some(place) = list.get_mut(k) {
                *place = *value;
            }
        }
    }
}

/// A wheel over a rail.
struct Above<'a, F> {
    wheel: Wheel<F>,
    position: Position<F>,
    reach: F,
    rail: Rail<'a, F>,
}

/// Up to four places of a profile.
type Places<F> = [Option<Place<F>>; FOUR];

impl<F: Float> Above<'_, F> {
    /// Looks down from places of the wheel's profile. None where the rail is out of reach.
    fn look(&mut self, places: &Places<F>) -> [Option<GapPoint<F>>; FOUR] {
        with_avx!(if 1 => <F: Float>(
            above: &mut Above<'_, F> = self,
            places: &Places<F> = places
        ) -> [Option<GapPoint<F>>; FOUR] {
            above.look_from::<F::Four>(places)
        } {
            above.look_from::<F::WideFour>(places)
        })
    }

    #[inline(always)]
    fn look_from<P: Strips<F>>(&mut self, places: &Places<F>) -> [Option<GapPoint<F>>; FOUR] {
        let Position { lateral, vertical, .. } = self.position;
        let zero = F::zero();
        // (where there is no place, one at which no wheel touches)
        let at = |i: usize| places.get(i).and_then(Option::as_ref);
        let line = self.wheel.line_of_contact(Place {
            y: P::gather(|i| at(i).map_or(zero, |place| place.y)),
            z: P::gather(|i| at(i).map_or(zero, |place| place.z)),
            cosine: P::gather(|i| at(i).map_or(zero, |place| place.cosine)),
            sine: P::gather(|i| at(i).map_or(zero, |place| place.sine)),
        });
        let [wheel_y, wheel_z] = line.normal;
        let point = [P::all(lateral) + line.place[1], P::all(vertical) + line.below];
        let mut under = [None; FOUR];
        for (i, under) in under.iter_mut().enumerate() {
            let own = |x: &P| x.lane(i);
            let ([y, z], [normal_y, normal_z]) = (&point, &line.normal);
            if own(&line.can_touch) > zero {
                let (point, normal) = ([own(y), own(z)], [own(normal_y), own(normal_z)]);
                *under = self.rail.under(point, normal, own(&line.size));
            }
        }
        let foot = self.rail.feet(point, &under);
        let [rail_y, rail_z] = foot.normal;
        // the mean of both surfaces' angles is that of the sum of their unit normals
        let (sum_y, sum_z) = (wheel_y + rail_y * line.size, wheel_z + rail_z * line.size);
        let mut found = [None; FOUR];
        for ((i, found), under) in found.iter_mut().enumerate().zip(under) {
            if under.is_none() {
                continue;
            }
            let own = |x: &P| x.lane(i);
            let (distance, sum_z) = (own(&foot.distance), own(&sum_z));
            let radius = own(&line.rolling_radius);
            if distance < self.reach && sum_z > zero && radius > zero {
                let ([x, y, z], angle) = (&line.place, (-own(&sum_y) / sum_z).atan());
                let along = own(&foot.along);
                *found = Some([along, distance, own(x), own(y), own(z), angle, radius]);
            }
        }
        found
    }
}

/// The gap between a right wheel and a rail. Only points nearer to the rail than `reach` are
/// written; zero: 2 mm. Where surfaces are nearer than 0.3 mm there are up to four points for one
/// of the wheel's profile, because the contact of a flange is one millimetre wide. Returns the
/// smallest distance of the points, or `reach` where all are farther.
///
/// # Errors
/// [`Error::NotPrepared`], [`Error::NotFinite`], [`Error::RollingRadius`]; [`Error::ProfileEnd`]
/// when no point of the wheel is above the rail; nothing has been written then.
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
    if !are_finite(&[wheel_radius, reach]) {
        return Err(Error::NotFinite);
    }
    if wheel_radius <= F::zero() {
        return Err(Error::RollingRadius);
    }
    let reach = if reach > F::zero() { reach } else { F::of(REACH) };
    let (turned, rail) = (Wheel::new(wheel_radius, position), Rail::new(rail, reach));
    let mut above = Above { wheel: turned, position: *position, reach, rail };
    // the wheel's own points, from the last to the first, at the end of the room; for each its
    // number if it and the one before are near, else 0
    let points = wheel.count as usize;
    let mut numbers = [0_u16; KSTRIP_SURFACE_CAPACITY];
    let (mut first, mut near, mut is_next_near) = (KSTRIP_SURFACE_CAPACITY, 0, false);
    for group in (0..points).step_by(FOUR) {
        let number = |i: usize| points.checked_sub(group + i + 1);
        let found = above.look(&core::array::from_fn(|i| wheel.point(number(i)?)));
        for (i, point) in found.iter().enumerate() {
            let is_near = point.is_some_and(|[_, distance, ..]| distance < F::of(NEAR));
            if let Some(next) = numbers.get_mut(first).filter(|_| is_near && is_next_near) {
                *next = number(i).map_or(0, |before| before as u16 + 1);
                near += 1;
            }
            if let Some(point) = point {
                first = first.saturating_sub(1);
                gap.set(first, point);
            }
            is_next_near = is_near;
        }
    }
    if !above.rail.faced {
        return Err(Error::ProfileEnd);
    }
    let parts = (first / near.max(1) + 1).min(FINEST);
    // with those between them, in ascending order along the rail, from the first on: there is room
    // before what is still to be read
    let (mut count, mut least) = (0, reach);
    let mut end: Option<F> = None;
    let mut write = |gap: &mut Gap<F>, point: &GapPoint<F>| {
        let [along, distance, ..] = *point;
        if end.is_none_or(|end| along > end) {
            gap.set(count, point);
            count += 1;
            least = least.min(distance);
            end = Some(along);
        }
    };
    // all places between, in their order: four of them are looked at together
    let divided = numbers.iter().map(|number| usize::from(*number)).filter(|number| *number > 0);
    let mut places = divided.flat_map(|number| (1..parts).map(move |part| (number - 1, part)));
    let (mut looked, mut next) = ([None; FOUR], FOUR);
    for (own, number) in numbers.iter().enumerate().skip(first) {
        let divisions = if *number > 0 { parts } else { 1 };
        for _ in 1..divisions {
            if next == FOUR {
                looked = above.look(&core::array::from_fn(|_| {
                    let (before, part) = places.next()?;
                    wheel.at(before, F::widened(part as f32) / F::widened(parts as f32))
                }));
                next = 0;
            }
            if let Some(Some(point)) = looked.get(next) {
                write(gap, point);
            }
            next += 1;
        }
        let own = gap.get(own);
        write(gap, &own);
    }
    gap.count = count as u32;
    gap.reserved = 0;
    Ok(least)
}
