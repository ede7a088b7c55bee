//! The gap between wheel and rail: the line of contact of the wheel (`line_of_contact`), and the
//! distance of this line from the rail.
//!
//! The distance of a point is measured along the rail's normal, from the rail's point under it
//! (`foot`). No plane of contact needs to be chosen, and a flange at 70 degrees is treated like a
//! tread.

pub(super) mod foot;
mod gap;
pub(crate) mod line_of_contact;
pub(crate) mod roller;

use self::foot::{Rail, UNDERCUT};
pub use self::gap::Gap;
use self::gap::GapPoint;
use self::line_of_contact::Wheel;
use crate::number::avx::with_avx;
use crate::number::{Float, Strips, ascend};
use crate::status::Error;
use crate::wheel_rail::profile::{CurvePoint, PreparedProfile};
use crate::wheel_rail::{KSTRIP_SURFACE_CAPACITY, Position, WheelPair};
use core::f64::consts::PI;

/// Default of the distance above which points are left out \[m\].
pub(super) const DEFAULT_REACH: f64 = 2e-3;
/// Number of points that are searched side by side.
const FOUR: usize = 4;
/// Distance from which the end of a rail under the wheel has no effect, over the reach.
const MAY_COUNT: f64 = 0.75;
/// How often the part of a wheel's profile in which a rail ends is divided by five.
const PARTINGS: u32 = 22;

/// A right wheel over a rail, between which the gap is searched.
#[derive(Clone, Copy)]
pub struct GapSearch<'a, F> {
    rail: &'a PreparedProfile<F>,
    wheel: &'a PreparedProfile<F>,
    turned: Wheel<F>,
    position: Position<F>,
}

/// A search in progress, up to a distance.
struct Above<'a, F> {
    search: &'a GapSearch<'a, F>,
    reach: F,
    rail: Rail<'a, F>,
}

/// Four places of the wheel's profile: numbers of points, and shares of the way to the next.
type Places<F> = [(usize, F); FOUR];

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

    /// Of a point of the wheel over the rail and its neighbour that is not: the last place between
    /// them that is over the rail, if it is so near that it may count. The wheel's points `k` and
    /// `k + 1`, of which the former is over the rail or the latter.
    #[inline(never)]
    fn last(
        &mut self, k: usize, is_former: bool, inside: Option<&GapPoint<F>>,
    ) -> Option<GapPoint<F>> {
        let [_, distance, ..] = inside?;
        if *distance >= self.reach.times(MAY_COUNT) {
            return None;
        }
        let (mut over, mut beyond) =
            if is_former { (F::zero(), F::one()) } else { (F::one(), F::zero()) };
        let mut last = None;
        for _ in 0..PARTINGS {
            // the end is in one of five parts
            let part = (beyond - over).times(0.2);
            let shares: [F; FOUR] =
                core::array::from_fn(|i| over + part * F::widened(i as f32 + 1.0));
            let found = self.look(&shares.map(|share| (k, share)));
            for (share, point) in shares.into_iter().zip(found) {
                if point.is_none() {
                    beyond = share;
                    break;
                }
                (over, last) = (share, point);
            }
        }
        last
    }

    #[inline(always)]
    fn look_from<P: Strips<F>>(&mut self, places: &Places<F>) -> [Option<GapPoint<F>>; FOUR] {
        let GapSearch { wheel, turned, position, .. } = self.search;
        let Position { lateral, vertical, .. } = *position;
        let zero = F::zero();
        // a lane without a place has one at which no wheel touches
        let found = places.map(|(k, share)| wheel.curve_at(k, share));
        let of = |member: fn(&CurvePoint<F>) -> F| {
            P::gather(|i| found.get(i).and_then(Option::as_ref).map_or(zero, member))
        };
        let profile = CurvePoint {
            y: of(|place| place.y),
            z: of(|place| place.z),
            cosine: of(|place| place.cosine),
            sine: of(|place| place.sine),
        };
        let line = turned.line_of_contact(&profile);
        let [wheel_y, wheel_z] = line.normal;
        let point = [P::all(lateral) + line.place[1], P::all(vertical) + line.below];
        if self.rail.is_far(point) {
            return [None; FOUR];
        }
        let mut pieces = [None; FOUR];
        for (i, piece) in pieces.iter_mut().enumerate() {
            let own = |x: &P| x.lane(i);
            let ([y, z], [normal_y, normal_z]) = (&point, &line.normal);
            if own(&line.can_touch) > zero {
                let (point, normal) = ([own(y), own(z)], [own(normal_y), own(normal_z)]);
                *piece = self.rail.piece_below(point, normal, own(&line.size));
            }
        }
        if pieces.iter().all(Option::is_none) {
            self.rail.set_free();
            return [None; FOUR];
        }
        let curvature =
            P::gather(|i| places.get(i).map_or(zero, |(k, share)| wheel.curvature(*k, *share)));
        let of_wheel = turned.rolling_radius(&profile, curvature);
        // 1/R = 1/R_wheel + 1/R_roller
        let rolling_radius = of_wheel * (of_wheel * line.curvature).plus(1.0).inverse();
        let foot = self.rail.feet(point, &pieces);
        let [rail_y, rail_z] = foot.normal;
        // the mean of both surfaces' angles is that of the sum of their unit normals
        let (sum_y, sum_z) = (wheel_y + rail_y * line.size, wheel_z + rail_z * line.size);
        let mut found = [None; FOUR];
        for ((i, found), piece) in found.iter_mut().enumerate().zip(pieces) {
            if piece.is_none() {
                continue;
            }
            let own = |x: &P| x.lane(i);
            let (distance, radius) = (own(&foot.distance), own(&rolling_radius));
            if distance < self.reach && own(&rail_z) > F::of(UNDERCUT) && radius > zero {
                let ([x, y, z], along) = (&line.place, own(&foot.along));
                let angle = angle_of(-own(&sum_y), own(&sum_z));
                *found = Some([along, distance, own(x), own(y), own(z), angle, radius]);
            }
        }
        found
    }
}

/// The angle from y to z of a vector: beyond ±π/2 where the second is negative.
pub(crate) fn angle_of<F: Float>(sine: F, cosine: F) -> F {
    let angle = (sine / cosine).atan();
    let half_turn = if cosine >= F::zero() { F::zero() } else { F::of(PI) };
    if sine < F::zero() { angle - half_turn } else { angle + half_turn }
}

impl<'a, F: Float> GapSearch<'a, F> {
    /// A wheel of a radius over a straight rail.
    ///
    /// # Errors
    /// [`Error::NotPrepared`], [`Error::NotFinite`], [`Error::RollingRadius`];
    /// [`Error::Angle`] for an angle of one or more.
    pub fn new(
        rail: &'a PreparedProfile<F>, wheel: &'a PreparedProfile<F>, wheel_radius: F,
        position: &Position<F>,
    ) -> Result<Self, Error> {
        Error::NotFinite.unless(wheel_radius.is_finite_number())?;
        Error::RollingRadius.when(wheel_radius <= F::zero())?;
        Self::of_turned(rail, wheel, Wheel::new(wheel_radius, position), position)
    }

    /// The wheel of a pair that was checked, at the position of a right wheel, or of the mirror
    /// image of a left one.
    pub(super) fn of_pair(
        rail: &'a PreparedProfile<F>, wheel: &'a PreparedProfile<F>, pair: &WheelPair<F>,
        right: &Position<F>,
    ) -> Result<Self, Error> {
        Self::of_turned(rail, wheel, Wheel::of_pair(pair, right), right)
    }

    fn of_turned(
        rail: &'a PreparedProfile<F>, wheel: &'a PreparedProfile<F>, turned: Wheel<F>,
        position: &Position<F>,
    ) -> Result<Self, Error> {
        position.check()?;
        rail.check()?;
        wheel.check()?;
        Ok(Self { rail, wheel, turned, position: *position })
    }

    /// The gap, at the points of the wheel's profile. Only those nearer to the rail than `reach`
    /// are written; zero: 2 mm. Returns the smallest distance of the points, or `reach` where all
    /// are farther.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::ProfileEnd`] when no point of the wheel is above the rail;
    /// nothing has been written then.
    pub fn gap(&self, reach: F, gap: &mut Gap<F>) -> Result<F, Error> {
        Error::NotFinite.unless(reach.is_finite_number())?;
        let Self { rail, wheel, .. } = *self;
        let reach = if reach > F::zero() { reach } else { F::of(DEFAULT_REACH) };
        let rail = Rail::new(rail, reach);
        let mut above = Above { search: self, reach, rail };
        let points = wheel.count as usize;
        let (mut count, mut least) = (0, reach);
        let mut end: Option<F> = None;
        let mut write = |point: &GapPoint<F>| {
            let [along, distance, ..] = *point;
            if end.is_none_or(|end| along > end) && count < KSTRIP_SURFACE_CAPACITY {
                gap.set(count, point);
                count += 1;
                least = least.min(distance);
                end = Some(along);
            }
        };
        let mut before: Option<GapPoint<F>> = None;
        let places = |first: usize| core::array::from_fn(|i| (first + i, F::zero()));
        for first in (0..points).step_by(FOUR) {
            let found = above.look(&places(first));
            for (i, point) in found.iter().enumerate().take(points - first) {
                if let Some(k) = (first + i).checked_sub(1)
                    && before.is_some() != point.is_some()
                {
                    // where the rail ends under the wheel
                    let inside = before.as_ref().or(point.as_ref());
                    if let Some(last) = above.last(k, before.is_some(), inside) {
                        write(&last);
                    }
                }
                if let Some(point) = point {
                    write(point);
                }
                before = *point;
            }
        }
        // Points that were passed may face the rail.
        above.rail.looks_at_all = true;
        let mut groups = (0..points).step_by(FOUR);
        while !above.rail.faced {
            let first = groups.next().ok_or(Error::ProfileEnd)?;
            above.look(&places(first));
        }
        gap.count = count as u32;
        (gap.step, gap.reserved) = (wheel.step, 0);
        Ok(least)
    }

    /// The vertical position at which the wheel, when it is lowered, meets the rail with a point of
    /// its line of contact, and the cosine of the rail's angle there. None where no point of the
    /// wheel is over the rail.
    pub(super) fn lowered(&self) -> Option<[F; 2]> {
        let points = self.rail.count as usize;
        let groups = (self.wheel.count as usize).div_ceil(FOUR);
        let mut least = None;
        let mut piece = 0;
        (0..groups).for_each(|group| self.lower(group, &mut piece, &mut least));
        // an overhang hides what is below it from one of both ends
        if !ascend(self.rail.y.get(..points).unwrap_or(&[])) {
            piece = points.saturating_sub(2);
            (0..groups).rev().for_each(|group| self.lower(group, &mut piece, &mut least));
        }
        least
    }

    /// Lowers four points of the wheel onto the next pieces of the rail that are under them, from
    /// the piece of the point before.
    fn lower(&self, group: usize, piece: &mut usize, least: &mut Option<[F; 2]>) {
        let Self { rail, wheel, turned, position } = *self;
        let points = rail.count as usize;
        let y_of = |k: usize| rail.y.get(k).copied().filter(|_| k < points);
        let (first, mut k) = (FOUR * group, *piece);
        let line = turned.line_of_contact(&wheel.points::<F::Four>(|i| first + i));
        let [_, across, _] = &line.place;
        for i in (0..FOUR).take(wheel.count as usize - first) {
            let (y, below) = (position.lateral + across.lane(i), line.below.lane(i));
            if !(line.can_touch.lane(i) > F::zero()) {
                continue;
            }
            while y_of(k + 2).is_some() && y_of(k + 1).is_some_and(|next| next <= y) {
                k += 1;
            }
            while k > 0 && y_of(k).is_some_and(|from| from > y) {
                k -= 1;
            }
            let (Some(from), Some(to)) = (rail.point(k), rail.point(k + 1)) else { continue };
            let share = (y - from.y) / (to.y - from.y);
            if share >= F::zero() && share <= F::one() {
                let left = from.z + (to.z - from.z) * share - below;
                if least.is_none_or(|[least, _]| left < least) {
                    *least = Some([left, from.cosine]);
                }
            }
        }
        *piece = k;
    }
}
