//! A gap for the normal problem: the distance of its surfaces as a profile, and its members at a
//! place.

use super::moves::{Lists, PointMoves};
use crate::contact::totals::StripCount;
use crate::normal::cells::{Cells, Given};
use crate::normal::parabola::LEAST_SPACINGS;
use crate::normal::smooth::SmoothedProfile;
use crate::normal::{Indentation, Profile, ProfileContact};
use crate::number::{Dual, Float, add, are_finite, ascend, at};
use crate::numerics::hermite::between_parabolas;
use crate::patch::Patch;
use crate::status::{Error, Warning};
use crate::wheel_rail::profile::PreparedProfile;
use crate::wheel_rail::touch::roller::{Over, Roller};
use crate::wheel_rail::touch::{self, Gap};
use crate::wheel_rail::{KSTRIP_SURFACE_CAPACITY, Position, WheelPair, sine_cosine};

/// Height above the lowest point of points that tell how far apart points are \[m\].
const LOW: f64 = 1e-4;
/// Distance from which points do not count: over the smoothing length, and at most \[m\].
const FADES: f64 = 0.5;
const REACH: f64 = 1e-3;
/// Rise of the surfaces' distance over the points that are needed beyond, over the points' step.
const MARGIN: f64 = 0.75;
/// Upper bound of the angles of a gap \[rad\].
const LARGEST_ANGLE: f64 = 2.3;

/// Distance of the surfaces from which points do not count \[m\].
fn counting<F: Float>(step: F, smoothing: F) -> F {
    let length = step.times(LEAST_SPACINGS).squared() + smoothing.squared();
    length.sqrt().times(FADES).min(F::of(REACH))
}

/// Distance of the surfaces from which points have no effect, at most: some points beyond the last
/// one that counts are needed, because the smoothing length follows from their spacing \[m\].
pub(crate) fn reach<F: Float>(step: F, smoothing: F) -> F {
    (counting(step, smoothing) + step.times(MARGIN)).min(F::of(touch::DEFAULT_REACH))
}

/// A place on the undeformed surfaces.
#[derive(Clone, Copy)]
pub(crate) struct Place<F> {
    /// On the wheel, from its centre \[m\].
    pub point: [F; 3],
    /// Mean of the angles of both surfaces \[rad\].
    pub angle: F,
    /// Tangent of half the angle from the wheel's to the rail's.
    pub lean: F,
    /// Where the point is over the rail.
    pub over: Over<F>,
    /// Speed of the rail's surface, backward \[m/s\].
    pub rail_speed: F,
}

/// A checked gap, with the position of the wheel or of the mirror image of a left one.
pub(super) struct View<'a, F> {
    pub lists: Lists<'a, F>,
    pub pair: &'a WheelPair<F>,
    pub position: Position<F>,
    /// The gap's distance of the wheel's points; 0 where it has none \[m\].
    pub given_step: F,
    /// How the points move, in which direction, and how far.
    pub moved: Option<(PointMoves<'a, F>, usize, F)>,
}

impl<'a, F: Float> View<'a, F> {
    pub fn new(
        gap: &'a Gap<F>, pair: &'a WheelPair<F>, position: &Position<F>,
    ) -> Result<Self, Error> {
        pair.check()?;
        position.check()?;
        let position = position.mirrored(pair.left != 0);
        let count = gap.count as usize;
        Error::Capacity.when(count > KSTRIP_SURFACE_CAPACITY)?;
        let lists = gap.lists().map(|list| list.get(..count).unwrap_or(&[]));
        let [along, .., angle, rolling_radius] = lists;
        Error::NotFinite
            .unless(lists.into_iter().all(are_finite) && gap.step.is_finite_number())?;
        Error::SmoothingLength.unless(gap.step >= F::zero())?;
        Error::RollingRadius.when(rolling_radius.iter().any(|radius| *radius <= F::zero()))?;
        let in_range = angle.iter().all(|angle| angle.abs() < F::of(LARGEST_ANGLE));
        if ascend(along) && in_range {
            Ok(Self { lists, pair, position, given_step: gap.step, moved: None })
        } else {
            Err(Error::Profile)
        }
    }

    /// How the points of the gap move over a rail.
    pub fn moves(&self, rail: &'a PreparedProfile<F>) -> PointMoves<'a, F> {
        let WheelPair { left, smoothing_length, .. } = *self.pair;
        let reach = reach(self.given_step, smoothing_length);
        PointMoves::new(self.lists, rail, &self.position, left != 0, reach)
    }

    /// `x`, `y`, `z`, the angle and the distance of the gap at a place, on [`between_parabolas`]:
    /// their derivatives are continuous too. A point at the end grows its parabola with its
    /// distance from the next. Returns also the slope of the distance.
    fn at(&self, place: F) -> ([F; 5], F) {
        let [along, ..] = self.lists;
        let last = along.len().saturating_sub(1);
        let next = along.partition_point(|along| *along < place).min(last).max(1);
        let ends = [next - 1, next].map(|k| self.point(k));
        let beside = [next.checked_sub(2), Some(next + 1).filter(|k| *k <= last)];
        between_parabolas(ends, beside.map(|k| Some(self.point(k?))), F::of(0.25), place)
    }

    /// Length, and these members, of a point where it has moved.
    fn point(&self, k: usize) -> (F, [F; 5]) {
        let mut members = self.lists.map(|list| at(list, k));
        if let Some((moves, direction, step)) = &self.moved {
            add(&mut members, moves.in_direction(k, *direction).map(|slope| *step * slope));
        }
        let [along, distance, x, y, z, angle, _] = members;
        (along, [x, y, z, angle, distance])
    }

    /// Where a point of the wheel is over the rail.
    pub fn over(&self, x: F, z: F) -> Over<F> {
        Roller::new(self.pair, &self.position).map_or(Over::straight(), |roller| roller.over(x, z))
    }

    /// A place on the undeformed surfaces. They make the angle `2 β` with each other, whose tangent
    /// is the slope of their distance `g`, and `β` with their mean tangent. A point of the wheel at
    /// the radius `ρ` over a roller is `g/cos β` above it along their mean normal, so that the
    /// surface of the roller moves with
    ///
    /// ```text
    /// V (ρ − g cos a/cos β)/R,   tan β = g'/2
    /// ```
    pub fn place(&self, along: F) -> Place<F> {
        let ([x, y, z, angle, distance], slope) = self.at(along);
        let (over, lean) = (self.over(x, z), slope.times(0.5));
        let WheelPair { rail_speed, rail_radius, .. } = *self.pair;
        let rail_speed = if rail_radius > F::zero() {
            let (_, cosine) = sine_cosine(angle);
            let above = distance * cosine * lean.squared().plus(1.0).sqrt();
            rail_speed * ((over.distance - above) / rail_radius)
        } else {
            rail_speed
        };
        Place { point: [x, y, z], angle, lean, over, rail_speed }
    }

    /// The distance between the wheel's points, or, where it is not given, that between points of
    /// the gap where the surfaces are near \[m\]: the mean over the points that are less than
    /// 0.1 mm above the lowest, so that it is continuous while points come and go.
    fn step(&self) -> F {
        if self.given_step > F::zero() {
            return self.given_step;
        }
        let [along, distance, ..] = self.lists;
        let lowest = distance.iter().fold(F::LARGEST, |lowest, distance| lowest.min(*distance));
        let [mut weights, mut step] = [F::zero(); 2];
        for (k, (&here, &distance)) in along.iter().zip(distance).enumerate() {
            let before = k.checked_sub(1).and_then(|k| along.get(k)).unwrap_or(&here);
            let half = (*along.get(k + 1).unwrap_or(&here) - *before).times(0.5);
            let rest = (F::one() - (distance - lowest).times(1.0 / LOW)).max(F::zero());
            let weight = rest * rest * half;
            weights += weight;
            step += weight * half;
        }
        step / (weights + F::TINY)
    }

    /// The undeformed gap as a profile. None for a gap without points.
    pub fn profile(&self) -> Result<Option<Profile<'a, F>>, Error> {
        let [along, distance, x, .., rolling_radius] = self.lists;
        if along.len() < 2 {
            return Ok(None);
        }
        let step = self.step();
        let none = counting(step, self.pair.smoothing_length);
        Profile::new(along, distance)?
            .of_surfaces(step, [none.times(0.5), none])
            .with_centre_x(x)?
            .with_rolling_radius(rolling_radius)
            .map(Some)
    }

    /// Presses a part of the curve together as far as the surfaces overlap; fills the cells.
    pub fn press<const N: usize>(
        &self, profile: &Profile<F>, curve: &SmoothedProfile<F, N>, approach: Dual<F, N>,
        count: StripCount, cells: &mut Cells<F, N>,
    ) -> Result<Indentation<F>, Error> {
        let contact = self.contact(approach.value);
        let found = Indentation::of_surfaces(profile, curve, &contact, approach, count, cells)?;
        if found.warning == Warning::ProfileEnd { Err(Error::ProfileEnd) } else { Ok(found) }
    }

    /// The strips of cells, made of the numbers that `of` makes; completes the result.
    pub fn strips<const N: usize>(
        &self, cells: &Cells<F, N>, of: impl Fn(Dual<F, N>) -> F, found: &mut Indentation<F>,
        strips: &mut Patch<F>,
    ) -> Result<(), Error> {
        let contact = self.contact(found.approach);
        strips.clear(contact.shear_modulus, contact.poisson_ratio);
        found.strips(&contact, cells, of, |strip| strips.push(strip))
    }

    /// What the normal problem needs to know besides the surfaces.
    fn contact(&self, approach: F) -> ProfileContact<F> {
        let WheelPair { shear_modulus, poisson_ratio, smoothing_length, .. } = *self.pair;
        ProfileContact {
            rolling_radius: self.pair.wheel_radius,
            given: Given::Approach(approach),
            shear_modulus,
            poisson_ratio,
            // each strip gets the friction at its place on the rail
            friction: F::zero(),
            smoothing_length,
        }
    }
}
