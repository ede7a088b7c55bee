//! What is implausible about a wheel on a rail: units, and profiles that stand upside down or the
//! wrong way round.
//!
//! A profile has a flat part, where it rises by less than 20 degrees: the tread of a wheel, the top
//! of a rail. On either side of it, at smaller and at larger y, the first part that is steeper than
//! 45 degrees leads down or up. This tells how the profile stands:
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
use crate::contact::plausibility::{LARGEST_FRICTION, LARGEST_PRESSURE, LARGEST_RADIUS};
use crate::number::Float;
use crate::status::Warning;
use crate::wheel_rail::contacts::WheelContact;
use crate::wheel_rail::scene::Scene;

/// Sine of the angle below which a part is flat, and of that above which it is steep.
const FLAT: f64 = 0.342;
const STEEP: f64 = 0.7;
/// Steep parts that are nearer to the height of the flat part do not count \[m\].
const SHALLOW: f64 = 2e-3;
/// Largest height of the rounded edge of a roller, and of flat parts above the tread \[m\].
const EDGE: f64 = 8e-3;
/// Longest profile \[m\].
const LONGEST: f64 = 1.0;
/// Least shear modulus \[Pa\]: rubber has 5e5.
const SOFTEST: f64 = 1e5;
/// Least width of a contact over the distance of the points of a profile.
const NARROWEST: f64 = 4.0;
/// Largest angle of a contact of a right wheel \[rad\]: its flange has -1.2.
const LARGEST_ANGLE: f64 = 30.0 * core::f64::consts::PI / 180.0;

/// The profile cannot be that of a wheel.
const NO_WHEEL: u32 = 1;
/// The profile cannot be that of a rail.
const NO_RAIL: u32 = 2;
/// The profile has few points, and its shape is not smooth between them.
pub(super) const ROUGH_AND_COARSE: u32 = 4;

impl<F: Float> PreparedProfile<F> {
    /// What the shape tells: whether the profile may be that of a wheel, and that of a rail.
    pub(super) fn what_it_is(&self) -> u32 {
        let zero = F::zero();
        let point = |k: usize| self.point(k);
        let count = self.count as usize;
        let flat = || (0..count).filter_map(point).filter(|place| place.sine.abs() < F::of(FLAT));
        let [parts, y, z] = flat()
            .fold([zero; 3], |[parts, y, z], place| [parts.plus(1.0), y + place.y, z + place.z]);
        if parts <= zero {
            return 0;
        }
        let [y, z] = [y / parts, z / parts];
        let middle = (0..count).find(|k| point(*k).is_some_and(|place| place.y >= y));
        let middle = middle.unwrap_or(count);
        // height below the flat part, negative above; of the first steep place on each side
        let below = |place: CurvePoint<F>| place.z - z;
        let is_steep = |place: &CurvePoint<F>| {
            place.sine.abs() > F::of(STEEP) && below(*place).abs() > F::of(SHALLOW)
        };
        let left = || (0..middle).rev().filter_map(point).filter(is_steep).map(below);
        let right = || (middle..count).filter_map(point).filter(is_steep).map(below);
        let [first_left, first_right] =
            [left().next(), right().next()].map(|first| first.unwrap_or(zero));
        let highest = left().chain(right()).fold(zero, F::min);
        let has_top_above = flat().any(|place| below(place) < F::of(-EDGE));
        let (is_down, is_up) = (|side: F| side > zero, |side: F| side < zero);
        let has_flange = is_down(first_left);
        let has_edges = !is_down(first_right)
            && is_up(first_left) == is_up(first_right)
            && highest > F::of(-EDGE);
        let has_sides = !is_up(first_left)
            && !is_up(first_right)
            && (is_down(first_left) || !is_down(first_right));
        let no_wheel = has_top_above || !(has_flange || has_edges);
        let no_rail = has_top_above || !has_sides;
        (if no_wheel { NO_WHEEL } else { 0 }) | (if no_rail { NO_RAIL } else { 0 })
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

impl<F: Float> Scene<'_, F> {
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
        } else if pair.shear_modulus < F::of(SOFTEST) {
            Warning::Modulus
        } else if friction > F::of(LARGEST_FRICTION) {
            Warning::Friction
        } else if friction <= F::zero() && pair.poisson_ratio <= F::zero() {
            Warning::Unset
        } else if contacts.iter().any(|contact| contact.peak_pressure() > pressure) {
            Warning::Pressure
        } else if contacts.iter().any(|contact| contact.angle > F::of(LARGEST_ANGLE)) {
            Warning::Orientation
        } else if contacts.iter().map(WheelContact::width).any(is_coarse) {
            Warning::ProfileCoarse
        } else {
            Warning::None
        }
    }
}
