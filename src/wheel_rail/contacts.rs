//! Zones of contact in a gap: their patches, the direction of their pressure, and their motion as the wheel moves.
//!
//! **Zones** are where the undeformed surfaces overlap. Zones less than 4 mm apart are one contact, as in CONTACT, and one normal problem.
//! Contacts more than 8 mm apart do not depend on each other. Between these distances the nearness `w` falls from 1 at 4 mm to 0 at 8 mm: the
//! contact of both zones counts by a share of `w`, and each zone by itself by `1 − w`.
//!
//! **Each strip has a direction of its own**: at angle `a` the tangent `t = (0, cos a, sin a)` and the normal into the rail
//! `n = (0, −sin a, cos a)`; its point `p` is on the wheel's undeformed surface. With the wheel's velocity `v` and rates `ω`
//!
//! ```text
//! slip_x = (v + ω×p)·e_x,   slip_y = (v + ω×p)·t,   spin rate = ω·n;   V = (v_x − (ω×p)_x)/2
//! ```
//!
//! The patch has the mean of these, weighted with the strips' loads `N` and referred to its origin. The force of the pressure is `Σ N n`.

use super::line_of_contact::Turn;
use super::touch::Gap;
use super::{
    KSTRIP_CONTACTS_CAPACITY, KSTRIP_SURFACE_CAPACITY, Pair, Position, Velocity, cross, dot,
};
use crate::contact::forces::StripCount;
use crate::motion::Motion;
use crate::number::{Float, are_finite, length};
use crate::patch::normal::Given;
use crate::patch::profile::{Indentation, Profile, ProfileContact};
use crate::patch::{PatchStrip, StoredPatch};
use crate::solve::model::Precision;
use crate::status::{Error, Notice};
use core::ops::Range;
use heapless::Vec;

/// Free length between zones up to which they are one contact \[m\], and from which they do not depend on each other.
const ONE_CONTACT: f64 = 4e-3;
const APART: f64 = 8e-3;
/// Largest number of contacts that lie apart. With those that stand for two or three of them there may be more.
const APART_AT_MOST: usize = 4;
/// Distance of the surfaces up to which points belong to the profile of a contact: over its depth, and at least \[m\].
const SEES: f64 = 4.0;
const SEES_LEAST: f64 = 1e-4;
/// Upper bound of the angles of a gap \[rad\].
const STEEPEST: f64 = 1.6;
/// Turn of the normal over a contact \[rad\] from which one plane is not enough.
const FLAT: f64 = 30.0 * core::f64::consts::PI / 180.0;

/// One contact of a wheel. Its frame is (x, t, n): forward, across along the surface, into the rail.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelContact<F> {
    /// Point where the pressure acts, on the wheel's undeformed surface, from the wheel's centre \[m\], axes of the track.
    pub origin: [F; 3],
    /// Angle of the pressure \[rad\]: mean of the strips' angles, weighted with load. For a left wheel it is that of the mirrored right wheel.
    pub angle: F,
    /// By how much the angle turns over the patch \[rad\]; above 0.52 the status is KSTRIP_WARNING_ANGLE_RANGE.
    pub angle_range: F,
    /// Distance of the origin from the axle \[m\].
    pub radius: F,
    /// Load of the strips \[N\].
    pub normal_force: F,
    /// Factor of load and forces in the sum over the contacts \[-\]: 1, except for contacts 4 to 8 mm apart, which count partly by
    /// themselves and partly as one contact.
    pub share: F,
    /// Overlap of the undeformed, smoothed surfaces where it is deepest \[m\].
    pub approach: F,
    /// Derivative of the load by the distance by which the surfaces are moved into each other \[N/m\].
    pub stiffness: F,
    /// Length on the rail at y = 0 of the patch \[m\].
    pub along: F,
    /// Derivatives of the wheel's velocity into the rail, mean of the strips weighted with load, by the members of kstrip_wheel_velocity. The
    /// force and the moment of the pressure on the wheel are minus share times normal_force times these six numbers.
    pub normal: [F; 6],
    /// slip_x of kstrip_motion at the patch's origin, by the members of kstrip_wheel_velocity.
    pub slip_x: [F; 6],
    /// slip_y of kstrip_motion.
    pub slip_y: [F; 6],
    /// spin_rate of kstrip_motion.
    pub spin_rate: [F; 6],
    /// rolling_speed of kstrip_motion.
    pub rolling_speed: [F; 6],
    /// The strips; y along the rail's surface, x forward from the origin.
    pub patch: StoredPatch<F>,
}

impl<F: Precision> WheelContact<F> {
    /// `B`: slip and spin rate by the wheel's velocity.
    pub(crate) fn rows(&self) -> [[F; 6]; 3] {
        [self.slip_x, self.slip_y, self.spin_rate]
    }

    /// The motion of the wheel over the rail at the contact.
    pub fn motion(&self, velocity: &[F; 6]) -> Motion<F> {
        let [slip_x, slip_y, spin_rate] = self.rows().map(|row| dot(&row, velocity));
        let rolling_speed = dot(&self.rolling_speed, velocity);
        Motion { slip_x, slip_y, spin_rate, rolling_speed, floor_speed: F::zero() }
    }

    /// The same, checked.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn checked_motion(&self, velocity: &Velocity<F>) -> Result<Motion<F>, Error> {
        let motion = self.motion(&velocity.members());
        let Motion { slip_x, slip_y, spin_rate, rolling_speed, .. } = motion;
        let finite =
            [slip_x, slip_y, spin_rate, rolling_speed].iter().all(|x| x.is_finite_number());
        if finite { Ok(motion) } else { Err(Error::NotFinite) }
    }

    fn is_finite(&self) -> bool {
        let rows = [self.normal, self.rolling_speed].into_iter().chain(self.rows()).flatten();
        let numbers = [self.radius, self.normal_force, self.approach, self.stiffness, self.along];
        rows.chain(numbers).all(F::is_finite_number)
    }

    /// Whether the normal turns by too much for one plane of contact.
    pub(crate) fn is_conformal(&self) -> bool {
        self.angle_range > F::of(FLAT)
    }
}

/// Sums over strips, weighted.
struct Means<F> {
    weight: F,
    /// Place from the wheel's centre.
    place: [F; 3],
    /// Tangent and normal, and their moments about the wheel's centre.
    tangent: [F; 6],
    normal: [F; 6],
    along: F,
    angle: F,
}

/// The place of a strip on the wheel and its direction.
#[derive(Clone, Copy)]
struct Seen<F> {
    place: [F; 3],
    tangent: [F; 3],
    normal: [F; 3],
    along: F,
    angle: F,
}

impl<F: Float> Means<F> {
    fn new() -> Self {
        let (zero, three, six) = (F::zero(), [F::zero(); 3], [F::zero(); 6]);
        Self { weight: zero, place: three, tangent: six, normal: six, along: zero, angle: zero }
    }

    fn add(&mut self, weight: F, strip: &Seen<F>) {
        let Seen { place, tangent, normal, along, angle } = *strip;
        self.weight += weight;
        self.along += weight * along;
        self.angle += weight * angle;
        add(&mut self.place, weight, place);
        add(&mut self.tangent, weight, with_moment(place, tangent));
        add(&mut self.normal, weight, with_moment(place, normal));
    }

    fn divided(mut self) -> Self {
        let share = F::one() / (self.weight + F::TINY);
        for sum in self.place.iter_mut().chain(&mut self.tangent).chain(&mut self.normal) {
            *sum = *sum * share;
        }
        (self.along, self.angle) = (self.along * share, self.angle * share);
        self
    }
}

fn add<F: Float, const N: usize>(sums: &mut [F; N], weight: F, terms: [F; N]) {
    for (sum, term) in sums.iter_mut().zip(terms) {
        *sum += weight * term;
    }
}

/// Turns a row for velocities in the track's axes into one for the members of [`Velocity`](super::Velocity), for a left wheel its own.
fn in_members<F: Float>([x, y, z, a, b, c]: [F; 6], turn: Turn<F>, left: bool) -> [F; 6] {
    let [roll, pitch, yaw] = turn.to_wheelset([a, b, c]);
    if left { [x, -y, z, -roll, pitch, -yaw] } else { [x, y, z, roll, pitch, yaw] }
}

/// A direction and its moment about the wheel's centre.
fn with_moment<F: Float>(place: [F; 3], direction: [F; 3]) -> [F; 6] {
    let ([a, b, c], [d, e, f]) = (direction, cross(place, direction));
    [a, b, c, d, e, f]
}

/// A checked gap.
struct View<'a, F> {
    gap: &'a Gap<F>,
    along: &'a [F],
    distance: &'a [F],
}

impl<'a, F: Precision> View<'a, F> {
    fn new(gap: &'a Gap<F>) -> Result<Self, Error> {
        let count = gap.count as usize;
        let along = gap.along.get(..count).ok_or(Error::Capacity)?;
        let distance = gap.distance.get(..count).ok_or(Error::Capacity)?;
        let others = [&gap.x, &gap.y, &gap.z, &gap.angle, &gap.rolling_radius];
        let others = others.map(|list| list.get(..count).unwrap_or(&[]));
        if !(others.into_iter().all(are_finite) && are_finite(along) && are_finite(distance)) {
            return Err(Error::NotFinite);
        }
        if gap.rolling_radius.iter().take(count).any(|radius| *radius <= F::zero()) {
            return Err(Error::RollingRadius);
        }
        let ascends = along.iter().zip(along.iter().skip(1)).all(|(along, next)| along < next);
        let upright = gap.angle.iter().take(count).all(|angle| angle.abs() < F::of(STEEPEST));
        if ascends && upright { Ok(Self { gap, along, distance }) } else { Err(Error::Profile) }
    }

    /// Middle of an overlap, and distance between its points: means weighted with the overlap. Points enter with weight zero, and points
    /// around the overlap do not count, so that both are continuous while points come and go.
    fn middle_and_step(&self, own: Range<usize>) -> [F; 2] {
        let at = |k: usize| self.along.get(k).copied();
        let [mut weights, mut middle, mut step] = [F::zero(); 3];
        for k in own {
            let (Some(here), Some(distance)) = (at(k), self.distance.get(k)) else { break };
            let before = k.checked_sub(1).and_then(at).unwrap_or(here);
            let half = (at(k + 1).unwrap_or(here) - before).times(0.5);
            let weight = (-*distance).max(F::zero()) * half;
            weights += weight;
            middle += weight * here;
            step += weight * half;
        }
        [middle, step].map(|sum| sum / (weights + F::TINY))
    }

    /// The profile of a contact: its points, and those around.
    fn profile(&self, own: Range<usize>, window: Range<usize>) -> Result<Profile<'a, F>, Error> {
        let part = |list: &'a [F]| list.get(window.clone()).unwrap_or(&[]);
        let [middle, step] = self.middle_and_step(own);
        Profile::new(part(self.along), part(self.distance))?
            .part_of_longer(middle, step)
            .with_centre_x(part(&self.gap.x))?
            .with_rolling_radius(part(&self.gap.rolling_radius))
    }

    /// The number of the first point behind a place, at least 1, and the share of the way from the point before it.
    fn between(&self, along: F) -> (usize, F) {
        let last = self.along.len().saturating_sub(1);
        let next = self.along.partition_point(|place| *place < along).min(last).max(1);
        let at = |k: usize| self.along.get(k).copied().unwrap_or(F::zero());
        let (from, to) = (at(next - 1), at(next));
        (next, ((along - from) / (to - from + F::TINY)).clamped(F::zero(), F::one()))
    }

    fn strip(&self, along: F) -> Seen<F> {
        let (next, share) = self.between(along);
        let mean = |list: &[F; KSTRIP_SURFACE_CAPACITY]| {
            let at = |k: usize| list.get(k).copied().unwrap_or(F::zero());
            at(next - 1) + (at(next) - at(next - 1)) * share
        };
        let gap = self.gap;
        let angle = mean(&gap.angle);
        let (sine, cosine) = super::sine_cosine(angle);
        let zero = F::zero();
        Seen {
            place: [mean(&gap.x), mean(&gap.y), mean(&gap.z)],
            tangent: [zero, cosine, sine],
            normal: [zero, -sine, cosine],
            along,
            angle,
        }
    }

    /// Hands every zone of overlap to `take`: the numbers of its points, and the free length before it (none before the first).
    fn zones(
        &self,
        mut take: impl FnMut(Range<usize>, Option<F>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let mut last_end: Option<F> = None;
        let mut begun: Option<(usize, Option<F>)> = None;
        let mut before: Option<(F, F)> = None;
        for (k, (&along, &distance)) in self.along.iter().zip(self.distance).enumerate() {
            // where a straight line between the points crosses zero
            let crossing = before.map_or(along, |(place, above)| {
                along - (along - place) * (distance / (distance - above))
            });
            if distance < F::zero() {
                if begun.is_none() {
                    begun = Some((k, last_end.map(|end| crossing - end)));
                }
            } else if let Some((first, free)) = begun.take() {
                take(first..k, free)?;
                last_end = Some(crossing);
            }
            before = Some((along, distance));
        }
        if let Some((first, free)) = begun {
            take(first..self.along.len(), free)?;
        }
        Ok(())
    }

    /// The points around a contact, up to the crests between it and its neighbours, and as far as distances are small.
    fn window(&self, own: &Range<usize>, before: usize, after: usize) -> Range<usize> {
        let at = |k: usize| self.distance.get(k).copied().unwrap_or(F::zero());
        let depth = own.clone().fold(F::zero(), |depth, k| depth.max(-at(k)));
        let level = depth.times(SEES).plus(SEES_LEAST);
        let crest = |points: Range<usize>| {
            points.fold((0, -F::LARGEST), |top, k| if at(k) > top.1 { (k, at(k)) } else { top }).0
        };
        let count = self.distance.len();
        let low = if before > 0 { crest(before..own.start) } else { 0 };
        let high = if after < count { crest(own.end..after) + 1 } else { count };
        let mut window = own.clone();
        while window.start > low && at(window.start) < level {
            window.start -= 1;
        }
        while window.end < high && at(window.end - 1) < level {
            window.end += 1;
        }
        window
    }
}

/// Nearness of two contacts over the free length between them: 1 up to 4 mm, 0 from 8 mm on, smooth between.
fn nearness<F: Float>(free: F) -> F {
    let t =
        (free.plus(-ONE_CONTACT).times(1.0 / (APART - ONE_CONTACT))).clamped(F::zero(), F::one());
    F::one() - t * t * (F::constant(3.0) - t.times(2.0))
}

/// The strips of a contact with its own points, between the end of the one before and the start of the one after, at the approach at
/// which the surfaces overlap as they do.
fn press<F: Precision>(
    view: &View<F>,
    own: Range<usize>,
    [before, after]: [usize; 2],
    pair: &Pair<F>,
    count: StripCount,
    strips: &mut StoredPatch<F>,
) -> Result<Option<Indentation<F>>, Error> {
    strips.clear(pair.shear_modulus, pair.poisson_ratio);
    let window = view.window(&own, before, after);
    let profile = view.profile(own, window)?;
    let contact = ProfileContact {
        rolling_radius: pair.wheel_radius,
        given: Given::Overlap(profile.overlap()),
        shear_modulus: pair.shear_modulus,
        poisson_ratio: pair.poisson_ratio,
        friction: pair.friction,
        smoothing_length: pair.smoothing_length,
    };
    let found = Indentation::new(&profile, &contact, count, |strip| strips.push(strip))?;
    if found.notice == Notice::ProfileEnd {
        return Err(Error::ProfileEnd);
    }
    Ok((strips.count > 0).then_some(found))
}

/// Contacts that lie apart: the numbers of their points, and the nearness of each to the next.
struct Groups<F> {
    points: Vec<Range<usize>, APART_AT_MOST>,
    near: Vec<F, APART_AT_MOST>,
}

impl<F: Precision> Groups<F> {
    fn new(view: &View<F>) -> Result<Self, Error> {
        let mut groups = Self { points: Vec::new(), near: Vec::new() };
        view.zones(|zone, free| {
            match (groups.points.last_mut(), free) {
                (Some(last), Some(free)) if free <= F::of(ONE_CONTACT) => last.end = zone.end,
                (_, free) => {
                    if let Some(free) = free {
                        groups.near.push(nearness(free)).map_err(|_| Error::PatchSize)?;
                    }
                    groups.points.push(zone).map_err(|_| Error::PatchSize)?;
                }
            }
            Ok(())
        })?;
        Ok(groups)
    }

    /// Share by which the contacts from one to another count as one contact.
    fn share(&self, first: usize, last: usize) -> F {
        let near = |k: usize| self.near.get(k).copied().unwrap_or(F::zero());
        let inside = (first..last).fold(F::one(), |product, k| product * near(k));
        let before = first.checked_sub(1).map_or(F::zero(), near);
        inside * (F::one() - before) * (F::one() - near(last))
    }
}

/// The result of [`from_gap`].
#[derive(Clone, Copy, Debug)]
pub struct Found {
    /// Contacts that were written.
    pub written: usize,
    /// Contacts more than 4 mm apart.
    pub apart: u32,
    /// The warning, if there is one.
    pub notice: Notice,
}

/// The contacts of a gap, in ascending y; none where the wheel is lifted. `strips` is memory for the normal problem of each.
///
/// # Errors
/// [`Error::Profile`] for a gap that does not ascend, or an angle beyond 1.6; [`Error::PatchSize`] for more than four contacts apart, or more than
/// [`KSTRIP_CONTACTS_CAPACITY`] in all; [`Error::Capacity`]; those of `Pair::check` and of
/// [`Patch::from_profile`](crate::patch::Patch::from_profile).
pub fn from_gap<F: Precision>(
    gap: &Gap<F>,
    pair: &Pair<F>,
    position: &Position<F>,
    count: StripCount,
    strips: &mut StoredPatch<F>,
    contacts: &mut [WheelContact<F>; KSTRIP_CONTACTS_CAPACITY],
) -> Result<Found, Error> {
    pair.check()?;
    position.check()?;
    let left = pair.left != 0;
    let position = position.mirrored(left);
    let view = View::new(gap)?;
    let groups = Groups::new(&view)?;
    let number = groups.points.len();
    let mut found = Found { written: 0, apart: number as u32, notice: Notice::None };
    let end_of = |k: usize| groups.points.get(k).map_or(0, |points| points.end);
    let start_of = |k: usize| groups.points.get(k).map_or(view.along.len(), |points| points.start);
    for first in 0..number {
        for last in first..number {
            let share = groups.share(first, last);
            if !(share > F::zero()) {
                continue;
            }
            let own = start_of(first)..end_of(last);
            let before = first.checked_sub(1).map_or(0, end_of);
            let after = start_of(last + 1);
            let pressed = press(&view, own, [before, after], pair, count, strips)?;
            let Some(pressed) = pressed else { continue };
            let contact = contacts.get_mut(found.written).ok_or(Error::PatchSize)?;
            contact.fill(&view, pair, &position, strips, &pressed);
            contact.share = share;
            if !contact.is_finite() {
                return Err(Error::Overflow);
            }
            found.written += 1;
            if contact.is_conformal() {
                found.notice = Notice::AngleRange;
            }
        }
    }
    Ok(found)
}

impl<F: Precision> WheelContact<F> {
    /// Fills the contact from the strips of a patch along the rail; the position is that of a right wheel.
    fn fill(
        &mut self,
        view: &View<F>,
        pair: &Pair<F>,
        position: &Position<F>,
        strips: &StoredPatch<F>,
        found: &Indentation<F>,
    ) {
        let (left, turn) = (pair.left != 0, Turn::new(position));
        let strips = strips.strips.get(..strips.count as usize).unwrap_or(&[]);
        let (mut means, mut lowest, mut highest) = (Means::new(), F::LARGEST, -F::LARGEST);
        for strip in strips {
            let seen = view.strip(strip.y);
            means.add(strip.load(), &seen);
            (lowest, highest) = (lowest.min(seen.angle), highest.max(seen.angle));
        }
        let load = means.weight;
        let means = means.divided();
        let [x, y, z] = means.place;
        let [a, b, c, ..] = means.normal;
        // (x, 0, 0) and its moment about the centre
        let forward = with_moment(means.place, [F::one(), F::zero(), F::zero()]);
        let spin = [F::zero(), F::zero(), F::zero(), a, b, c];
        let mut rolling = forward.map(|entry| entry.times(-0.5));
        let [speed, ..] = &mut rolling;
        *speed = speed.plus(1.0);
        let own_axes = |row: [F; 6]| in_members(row, turn, left);
        (self.slip_x, self.slip_y) = (own_axes(forward), own_axes(means.tangent));
        (self.spin_rate, self.rolling_speed) = (own_axes(spin), own_axes(rolling));
        self.normal = own_axes(means.normal);
        self.origin = [x, if left { -y } else { y }, z];
        self.angle = means.angle;
        self.angle_range = highest - lowest;
        let [in_x, _, in_z] = turn.to_wheelset(means.place);
        self.radius = length(in_x, in_z);
        (self.normal_force, self.share) = (load, F::one());
        (self.approach, self.stiffness) = (found.approach, found.stiffness);
        self.along = means.along;
        self.patch.clear(pair.shear_modulus, pair.poisson_ratio);
        for strip in strips {
            let [_, across, _] = view.strip(strip.y).place;
            self.patch.push(PatchStrip {
                y: strip.y - means.along,
                centre_x: strip.centre_x - x,
                friction: pair.friction_at_rail(position.lateral + across),
                ..*strip
            });
        }
    }
}
