//! The wheelset for C: from structures of pointers to the two sides of the core.

use super::support::*;
use super::wheel_rail::scene_of;
use crate::wheel_rail::scene::Scene;
use crate::wheelset::forces::Wheelset;
use crate::wheelset::kinematics::Side;
use crate::wheelset::track::{RailMotion, gauge_face};

/// From the back of a flange to the running circle of its wheel \[m\].
const CIRCLE_FROM_BACK: f64 = 70e-3;

/// The structures of a wheelset and its track, checked: profiles, pairs and laws of both sides.
pub(super) struct Sides<'a, F> {
    rails: [&'a Surface<F>; 2],
    wheels: [&'a Surface<F>; 2],
    laws: [Option<&'a SlipFriction<F>>; 2],
    pairs: [WheelPair<F>; 2],
    sides: [Side<F>; 2],
    /// Whether a rail ends above the depth at which its gauge is measured.
    warning: Warning,
}

impl<'a, F: Float> Sides<'a, F> {
    /// # Safety
    /// The pointers in both structures are NULL or valid.
    pub(super) unsafe fn new(
        set: Option<&WheelsetParts<F>>,
        track: Option<&Track<F>>,
    ) -> Result<Self, Error> {
        let (set, track) = (given(set)?, given(track)?);
        // SAFETY: the promise of this function.
        let (rails, wheels, laws) = unsafe {
            let both = |[right, left]: [*const Surface<F>; 2]| {
                let right = given(right.as_ref())?;
                Ok([right, left.as_ref().unwrap_or(right)])
            };
            (both(track.rail)?, both(set.wheel)?, set.friction.map(|law| law.as_ref()))
        };
        let [right, left] = set.pair;
        let left = if left.wheel_radius == F::zero() { right } else { left };
        let pairs = [WheelPair { left: 0, ..right }, WheelPair { left: 1, ..left }];
        pairs.iter().try_for_each(WheelPair::check)?;
        track.motion.iter().try_for_each(RailMotion::check)?;
        let half = half_distance(set)?;
        let ([right, left], mut warning) = (&pairs, Warning::None);
        let excess = (right.wheel_radius - left.wheel_radius).times(0.5);
        let mut origin = |given: F, rail: &Surface<F>| {
            let (origin, of_rail) = origin(track, given, rail)?;
            warning = warning.worse(of_rail);
            Ok(origin)
        };
        let [[right, left], [on_right, on_left]] = [track.origin, [excess, -excess]];
        let [rail, other] = rails;
        let (right, left) = (origin(right, rail)?, origin(left, other)?);
        let [motion, of_left] = track.motion;
        let sides = [
            Side { arm: half, origin: right, excess: on_right, rail: 6, motion },
            Side { arm: -half, origin: -left, excess: on_left, rail: 8, motion: of_left },
        ];
        Ok(Self { rails, wheels, laws, pairs, sides, warning })
    }

    /// The wheelset on its rails, and the warning of the rails.
    pub(super) fn wheelset(&self) -> Result<(Wheelset<'_, F>, Warning), Error> {
        let Self { rails, wheels, laws, pairs, sides, warning } = self;
        let [right, left] = pairs;
        let ([rail, other_rail], [wheel, other_wheel], [law, other_law]) = (rails, wheels, laws);
        let scenes: [Scene<'_, F>; 2] = [
            scene_of(Some(rail), Some(wheel), Some(right), *law)?,
            scene_of(Some(other_rail), Some(other_wheel), Some(left), *other_law)?,
        ];
        Ok((Wheelset { scenes, sides: *sides }, *warning))
    }
}

/// Half the distance of the running circles.
fn half_distance<F: Float>(set: &WheelsetParts<F>) -> Result<F, Error> {
    let WheelsetParts { back_to_back, running_circles, .. } = *set;
    Error::NotFinite.unless(are_finite(&[back_to_back, running_circles]))?;
    let known = running_circles > F::zero() && back_to_back >= F::zero();
    let from_backs = running_circles == F::zero() && back_to_back > F::zero();
    Error::Gauge.unless(known || from_backs)?;
    Ok(if known {
        running_circles.times(0.5)
    } else {
        back_to_back.times(0.5).plus(CIRCLE_FROM_BACK)
    })
}

/// The distance of a rail's origin from the middle of the track.
fn origin<F: Float>(track: &Track<F>, given: F, rail: &Surface<F>) -> Result<(F, Warning), Error> {
    Error::NotFinite.unless(are_finite(&[track.gauge, given]))?;
    if given > F::zero() {
        return Ok((given, Warning::None));
    }
    Error::Gauge.unless(given == F::zero() && track.gauge > F::zero())?;
    let (face, warning) = gauge_face(rail, track.gauge_depth)?;
    Ok((track.gauge.times(0.5) - face, warning))
}
