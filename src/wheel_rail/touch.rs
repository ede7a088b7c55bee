//! The gap between wheel and rail: the line of contact of the wheel (`line_of_contact`), and the distance of this line from the rail.
//!
//! The distance of a point is measured along the rail's normal, from the rail's point under it (`under`). No plane of contact needs to be chosen, and a
//! flange at 70 degrees is treated like a tread.

use super::line_of_contact::Wheel;
use super::surface::{Place, Surface};
use super::under::{Rail, Under};
use super::{KSTRIP_SURFACE_CAPACITY, Position};
use crate::number::registers::compiled_twice;
use crate::number::{Float, Strips};
use crate::status::Error;

/// Distance below which points are added \[m\], and the largest number of points for one of the wheel's.
const NEAR: f64 = 0.3e-3;
const FINEST: usize = 4;
/// Default of the distance above which points are left out \[m\].
const REACH: f64 = 2e-3;
/// Least cosine of the angle between two surfaces that face each other.
const FACING: f64 = 0.5;
/// Number of points that are looked at side by side.
const FOUR: usize = 4;

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

impl<F> Gap<F> {
    /// The members, in their order.
    pub(super) fn lists(&self) -> [&[F; KSTRIP_SURFACE_CAPACITY]; 7] {
        let Self { along, distance, x, y, z, angle, rolling_radius, .. } = self;
        [along, distance, x, y, z, angle, rolling_radius]
    }
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

/// A wheel over a rail.
struct Above<'a, F> {
    wheel: Wheel<F>,
    position: Position<F>,
    reach: F,
    rail: Rail<'a, F>,
    /// Whether a point of the wheel has faced the rail.
    faces: bool,
}

impl<F: Float> Above<'_, F> {
    /// Looks down from places of the wheel's profile, up to four. None where the rail is out of reach.
    fn look(&mut self, places: &[Place<F>; FOUR]) -> [Option<GapPoint<F>>; FOUR] {
        compiled_twice!(if 1 => <F: Float>(above: &mut Above<'_, F> = self, places: &[Place<F>; FOUR] = places) -> [Option<GapPoint<F>>; FOUR] {
            above.look_from::<F::Four>(places)
        } {
            above.look_from::<F::WideFour>(places)
        })
    }

    #[inline(always)]
    fn look_from<P: Strips<F>>(
        &mut self,
        places: &[Place<F>; FOUR],
    ) -> [Option<GapPoint<F>>; FOUR] {
        let Position { lateral, vertical, .. } = self.position;
        let places = Place {
            y: P::gather(|i| places.get(i).map_or(F::zero(), |place| place.y)),
            z: P::gather(|i| places.get(i).map_or(F::zero(), |place| place.z)),
            cosine: P::gather(|i| places.get(i).map_or(F::zero(), |place| place.cosine)),
            sine: P::gather(|i| places.get(i).map_or(F::zero(), |place| place.sine)),
        };
        let line = self.wheel.for_all::<P>().line_of_contact(places);
        let [wheel_y, wheel_z] = line.normal;
        let point = [P::all(lateral) + line.place[1], P::all(vertical) + line.below];
        let mut under = [Under::Nowhere; FOUR];
        for (i, under) in under.iter_mut().enumerate() {
            if line.can_touch.lane(i) > F::zero() {
                *under = self.rail.under([point[0].lane(i), point[1].lane(i)]);
            }
        }
        let foot = self.rail.feet(point, &under);
        let [rail_y, rail_z] = foot.normal;
        // the mean of both surfaces' angles is that of the sum of their unit normals
        let (sum_y, sum_z) = (wheel_y + rail_y * line.size, wheel_z + rail_z * line.size);
        let mut found = [const { None }; FOUR];
        for (i, (found, under)) in found.iter_mut().zip(under).enumerate() {
            let [rail_y, rail_z] = match under {
                Under::Nowhere => continue,
                Under::Far(normal) => normal,
                Under::Between(..) => [rail_y.lane(i), rail_z.lane(i)],
            };
            let facing = wheel_y.lane(i) * rail_y + wheel_z.lane(i) * rail_z;
            if !(facing > line.size.lane(i).times(FACING)) {
                continue;
            }
            self.faces = true;
            let (distance, sum_z) = (foot.distance.lane(i), sum_z.lane(i));
            let rolling_radius = line.rolling_radius.lane(i);
            let is_near = matches!(under, Under::Between(..)) && distance < self.reach;
            if is_near && sum_z > F::zero() && rolling_radius > F::zero() {
                *found = Some(GapPoint {
                    along: foot.along.lane(i),
                    distance,
                    place: [line.place[0].lane(i), line.place[1].lane(i), line.place[2].lane(i)],
                    angle: (-sum_y.lane(i) / sum_z).atan(),
                    rolling_radius,
                });
            }
        }
        found
    }
}

/// Four places of a profile; where there is none, one at which no wheel touches.
fn four<F: Float>(place: impl Fn(usize) -> Option<Place<F>>) -> [Place<F>; FOUR] {
    let zero = F::zero();
    let none = Place { y: zero, z: zero, cosine: zero, sine: zero };
    core::array::from_fn(|i| place(i).unwrap_or(none))
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
    let (turned, rail) = (Wheel::new(wheel_radius, position), Rail::new(rail, reach));
    let mut above = Above { wheel: turned, position: *position, reach, rail, faces: false };
    // those of the wheel's own points, from the last to the first, at the end of the room
    let points = wheel.count as usize;
    let mut is_there = [false; KSTRIP_SURFACE_CAPACITY];
    // whether a point and the one before it are near
    let mut are_near = [false; KSTRIP_SURFACE_CAPACITY];
    let (mut first, mut near, mut is_next_near) = (KSTRIP_SURFACE_CAPACITY, 0, false);
    for group in (0..points).step_by(FOUR) {
        let number = |i: usize| points.checked_sub(group + i + 1);
        let found = above.look(&four(|i| wheel.point(number(i)?)));
        for (i, point) in found.iter().enumerate() {
            let Some(k) = number(i) else { break };
            let is_near = point.as_ref().is_some_and(|point| point.distance < F::of(NEAR));
            if let Some(point) = point {
                first = first.saturating_sub(1);
                gap.set(first, point);
            }
            if let Some(is_there) = is_there.get_mut(k) {
                *is_there = point.is_some();
            }
            if let Some(are_near) = are_near.get_mut(k + 1) {
                *are_near = is_near && is_next_near;
                near += usize::from(*are_near);
            }
            is_next_near = is_near;
        }
    }
    if !above.faces {
        return Err(Error::ProfileEnd);
    }
    let parts = (first / near.max(1) + 1).min(FINEST);
    // with those between them, in ascending order along the rail, from the first on: there is room before what is still to be read
    let (mut count, mut least) = (0, reach);
    let mut end: Option<F> = None;
    let mut write = |gap: &mut Gap<F>, point: &GapPoint<F>| {
        if end.is_none_or(|end| point.along > end) {
            gap.set(count, point);
            count += 1;
            least = least.min(point.distance);
            end = Some(point.along);
        }
    };
    for group in (0..points).step_by(FOUR) {
        let mut between = [[const { None }; FOUR]; FINEST - 1];
        let is_near = |i: usize| are_near.get(group + i).is_some_and(|near| *near);
        if (0..FOUR).any(is_near) {
            for (part, found) in between.iter_mut().enumerate().take(parts - 1) {
                let share = F::widened((part + 1) as f32) / F::widened(parts as f32);
                let at = |i: usize| wheel.at((group + i).checked_sub(1)?, share);
                *found = above.look(&four(|i| if is_near(i) { at(i) } else { None }));
            }
        }
        for i in 0..FOUR {
            for point in between.iter().filter_map(|found| found.get(i)?.as_ref()) {
                write(gap, point);
            }
            if is_there.get(group + i).is_some_and(|there| *there) {
                if let Some(point) = gap.get(first) {
                    write(gap, &point);
                }
                first += 1;
            }
        }
    }
    gap.count = count as u32;
    gap.reserved = 0;
    Ok(least)
}
