//! What is implausible about a wheel on a rail: units, and profiles that stand upside down or the
//! wrong way round.
//!
//! The longest contiguous part of a profile that rises by less than 20 degrees is its flat part:
//! the tread of a wheel, the top of a rail. On either side of it, at smaller and at larger y, the
//! first part that is steeper than 45 degrees leads down or up. This tells how the profile stands:
//!
//! | | at small y | at large y |
//! |---|---|---|
//! | wheel | down to the flange | up to the rim, not measured, or down to a second flange |
//! | rail | down along the gauge side | down, or not measured |
//! | roller without flange | up round the edge, or not measured | the same |
//!
//! Everything else is no wheel, no rail, or neither; so is a profile with another flat part far
//! above: the top of a flange that is upside down. Profiles without steep parts may be both.

use super::{CurvePoint, PreparedProfile};
use crate::contact::plausibility::{
    LARGEST_FRICTION, LARGEST_MODULUS, LARGEST_MODULUS_OF_ANY_UNIT, LARGEST_PRESSURE,
    LARGEST_RADIUS,
};
use crate::number::Float;
use crate::status::{Error, Warning};
use crate::wheel_rail::Position;
use crate::wheel_rail::contacts::WheelContact;
use crate::wheel_rail::scene::Scene;

/// Sine of the angle below which a part is flat, and of that above which it is steep.
const FLAT_SINE: f64 = 0.342;
const STEEP_SINE: f64 = 0.7;
/// Steep parts that are nearer to the height of the flat part do not count \[m\].
const SHALLOW: f64 = 2e-3;
/// Largest height of the rounded edge of a roller, and of flat parts above the tread \[m\].
const ROUNDED_EDGE: f64 = 8e-3;
/// Least depth of the tip of a flange below the tread, and of the sides of a rail head \[m\].
const TIP: f64 = 15e-3;
const HEAD: f64 = 8e-3;
/// Largest distances of a wheel from its rail, and largest yaw or roll, of a wheel beside its rail
/// \[m, rad\].
const FARTHEST_WHEEL: [f64; 2] = [0.7, 5.0];
const LARGEST_TURN: f64 = 0.2;
/// Longest profile \[m\].
const LONGEST: f64 = 1.0;
/// Least shear modulus \[Pa\]: rubber has 5e5.
const LEAST_MODULUS: f64 = 1e5;
/// Least width of a contact over the distance of the points of a profile.
const NARROWEST: f64 = 4.0;
/// Largest angle of a contact of a right wheel \[rad\]: its flange has -1.2.
const LARGEST_CONTACT_ANGLE: f64 = 30.0 * core::f64::consts::PI / 180.0;

/// The profile cannot be that of a wheel.
const NO_WHEEL: u32 = 1;
/// The profile cannot be that of a rail.
const NO_RAIL: u32 = 2;
/// The profile has the tip of a flange, or a groove.
const HAS_FLANGE_TIP: u32 = 8;
/// The profile goes down on both sides, without the tip of a flange.
const IS_RAIL_HEAD: u32 = 16;
/// The profile has few points, and its shape is not smooth between them.
pub(super) const ROUGH_AND_COARSE: u32 = 4;

impl<F: Float> PreparedProfile<F> {
    /// What the shape tells: whether the profile may be that of a wheel, and that of a rail.
    pub(super) fn what_it_is(&self) -> u32 {
        let zero = F::zero();
        let point = |k: usize| self.point(k);
        let count = self.count as usize;
        let is_flat = |place: &CurvePoint<F>| place.sine.abs() < F::of(FLAT_SINE);
        let flat = || (0..count).filter_map(point).filter(is_flat);
        let Some((middle, z)) = self.longest_flat_part() else { return 0 };
        // height below the flat part, negative above; of the first steep place on each side
        let below = |place: CurvePoint<F>| place.z - z;
        let is_steep = |place: &CurvePoint<F>| {
            place.sine.abs() > F::of(STEEP_SINE) && below(*place).abs() > F::of(SHALLOW)
        };
        let left = || (0..middle).rev().filter_map(point).filter(is_steep).map(below);
        let right = || (middle..count).filter_map(point).filter(is_steep).map(below);
        let [first_left, first_right] =
            [left().next(), right().next()].map(|first| first.unwrap_or(zero));
        let highest = left().chain(right()).fold(zero, F::min);
        let has_top_above = flat().any(|place| below(place) < F::of(-ROUNDED_EDGE));
        let (is_down, is_up) = (|side: F| side > zero, |side: F| side < zero);
        let has_flange = is_down(first_left);
        let has_edges = !is_down(first_right)
            && is_up(first_left) == is_up(first_right)
            && highest > F::of(-ROUNDED_EDGE);
        let has_sides = !is_up(first_left)
            && !is_up(first_right)
            && (is_down(first_left) || !is_down(first_right));
        let no_wheel = has_top_above || !(has_flange || has_edges);
        let no_rail = has_top_above || !has_sides;
        let lowest = left().fold(zero, F::max);
        let has_tip = (0..middle)
            .filter_map(point)
            .any(|place| is_flat(&place) && place.cosine > zero && below(place) > F::of(TIP));
        let is_head = !has_tip && lowest > F::of(HEAD) && right().fold(zero, F::max) > F::of(HEAD);
        let flags = [
            (no_wheel, NO_WHEEL),
            (no_rail, NO_RAIL),
            (has_tip, HAS_FLANGE_TIP),
            (is_head, IS_RAIL_HEAD),
        ];
        flags.iter().fold(0, |form, (holds, flag)| if *holds { form | flag } else { form })
    }

    /// The middle point of the longest contiguous part that is flat, and its mean height.
    fn longest_flat_part(&self) -> Option<(usize, F)> {
        let (mut longest, mut own) = ((0, 0, F::zero()), (0, 0, F::zero()));
        for k in 0..self.count as usize {
            let place = self.point(k)?;
            let (first, points, sum) = own;
            own = if place.sine.abs() < F::of(FLAT_SINE) && place.cosine > F::zero() {
                (first, points + 1, sum + place.z)
            } else {
                (k + 1, 0, F::zero())
            };
            if own.1 > longest.1 {
                longest = own;
            }
        }
        let (first, points, sum) = longest;
        let size = F::widened(points as f32);
        (points > 0).then(|| (first + points / 2, sum / size))
    }

    /// What is implausible about the profile of a wheel or a rail.
    pub fn plausibility(&self) -> Warning {
        self.implausible(self.form & (NO_WHEEL | NO_RAIL) == (NO_WHEEL | NO_RAIL))
    }

    /// Whether there are too few points for a contact of a width.
    fn is_coarse_for(&self, width: F) -> bool {
        self.form & ROUGH_AND_COARSE != 0 && width < self.spacing.times(NARROWEST)
    }

    fn implausible(&self, stands_wrong: bool) -> Warning {
        if self.step * F::widened(self.count as f32) > F::of(LONGEST) {
            Warning::ProfileSize
        } else if stands_wrong {
            Warning::Orientation
        } else {
            Warning::None
        }
    }
}

/// What may be the cause of an error at a position, where the inputs are implausible.
pub(crate) struct Cause<'a, F> {
    pub rail: &'a PreparedProfile<F>,
    pub wheel: &'a PreparedProfile<F>,
    pub wheel_radius: F,
    pub shear_modulus: Option<F>,
}

impl<F: Float> Cause<'_, F> {
    /// The error that names the likely cause of an error where the surfaces do not meet or carry
    /// the loads, or the error itself. No input is refused that has a result.
    #[cold]
    pub fn named(&self, error: Error, position: &Position<F>) -> Error {
        let may_have_a_cause = matches!(
            error,
            Error::ProfileEnd | Error::PatchSize | Error::Overflow | Error::WheelLifted
        );
        if !may_have_a_cause {
            return error;
        }
        let Self { rail, wheel, wheel_radius, .. } = *self;
        let Position { lateral, vertical, yaw, roll } = *position;
        let is_long = |profile: &PreparedProfile<F>| profile.plausibility() == Warning::ProfileSize;
        let causes = [
            (yaw.abs().max(roll.abs()) > F::of(LARGEST_TURN), Error::Angle),
            (lateral.abs() > F::of(FARTHEST_WHEEL[0]), Error::LengthUnit),
            (vertical.abs() > F::of(FARTHEST_WHEEL[1]), Error::LengthUnit),
            (wheel_radius > F::of(LARGEST_RADIUS), Error::LengthUnit),
            (is_long(rail) || is_long(wheel), Error::LengthUnit),
            (
                self.shear_modulus.is_some_and(|modulus| modulus < F::of(LEAST_MODULUS)),
                Error::ModulusUnit,
            ),
            (rail.form & HAS_FLANGE_TIP != 0 && wheel.form & IS_RAIL_HEAD != 0, Error::Swapped),
            (rail.form & NO_RAIL != 0 || wheel.form & NO_WHEEL != 0, Error::Orientation),
        ];
        causes.iter().find(|(holds, _)| *holds).map_or(error, |(_, cause)| *cause)
    }
}

impl<F: Float> Scene<'_, F> {
    /// What may be the cause of an error.
    pub(crate) fn cause(&self) -> Cause<'_, F> {
        let Self { rail, wheel, pair, .. } = *self;
        let shear_modulus = Some(pair.shear_modulus);
        Cause { rail, wheel, wheel_radius: pair.wheel_radius, shear_modulus }
    }

    /// What is implausible about the scene and its contacts; the profiles are examined first.
    pub(crate) fn plausibility(&self, contacts: &[WheelContact<F>]) -> Warning {
        let Self { rail, wheel, pair, .. } = *self;
        let of_rail = rail.implausible(rail.form & NO_RAIL != 0);
        let of_profiles = of_rail.worse(wheel.implausible(wheel.form & NO_WHEEL != 0));
        let places = pair.friction_at.get(..pair.friction_points as usize).unwrap_or(&[]);
        let friction = if places.is_empty() { &[pair.friction] } else { places };
        let friction = friction.iter().fold(F::zero(), |most, friction| most.max(*friction));
        let pressure = pair.shear_modulus.times(LARGEST_PRESSURE);
        let is_coarse = |width| rail.is_coarse_for(width) || wheel.is_coarse_for(width);
        if of_profiles != Warning::None {
            of_profiles
        } else if pair.wheel_radius > F::of(LARGEST_RADIUS) {
            Warning::Radius
        } else if pair.shear_modulus < F::of(LEAST_MODULUS)
            || pair.shear_modulus > F::of(LARGEST_MODULUS_OF_ANY_UNIT)
        {
            Warning::Modulus
        } else if pair.shear_modulus > F::of(LARGEST_MODULUS) {
            Warning::Young
        } else if friction > F::of(LARGEST_FRICTION) {
            Warning::Friction
        } else if friction <= F::zero() && pair.poisson_ratio <= F::zero() {
            Warning::Unset
        } else if contacts.iter().any(|contact| contact.peak_pressure() > pressure) {
            Warning::Pressure
        } else if contacts.iter().any(|contact| contact.angle > F::of(LARGEST_CONTACT_ANGLE)) {
            Warning::Orientation
        } else if contacts.iter().map(WheelContact::width).any(is_coarse) {
            Warning::ProfileCoarse
        } else {
            Warning::None
        }
    }
}
