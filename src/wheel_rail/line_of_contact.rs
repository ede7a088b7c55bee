//! The line of contact: the line on a wheel where its normal is perpendicular to `x`.
//!
//! A wheel of radius `r(y)` that yaws touches ahead of its lowest line where it is steep. In the wheel's axes, `θ` about the axle
//! from below, `α` the angle of its profile and `R` the turn by roll and yaw,
//!
//! ```text
//! p = R (r sin θ, y, r cos θ),   n = R (cos α sin θ, −sin α, cos α cos θ),   n_x = 0:  sin θ = tan α R₀₁/R₀₀ = −tan α tan yaw
//! ```

use super::surface::Place;
use super::{Position, sine_cosine};
use crate::number::{Arithmetic, Float, Strips};

/// Least cosine of the profile's angle, and largest sine of θ, at which a wheel can touch.
const STEEPEST: f64 = 0.06;
const FARTHEST: f64 = 0.9;

/// Sines and cosines of the roll and the yaw of a wheel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turn<T> {
    roll: (T, T),
    yaw: (T, T),
}

impl<F: Float> Turn<F> {
    pub fn new(position: &Position<F>) -> Self {
        Self { roll: sine_cosine(position.roll), yaw: sine_cosine(position.yaw) }
    }
}

impl<T: Arithmetic> Turn<T> {
    /// Turns a vector from the wheelset's axes to the track's: by yaw, then by roll.
    #[inline(always)]
    pub fn to_track(self, [x, y, z]: [T; 3]) -> [T; 3] {
        let ((sin_roll, cos_roll), (sin_yaw, cos_yaw)) = (self.roll, self.yaw);
        let across = sin_yaw * x + cos_yaw * y;
        [
            cos_yaw * x - sin_yaw * y,
            cos_roll * across - sin_roll * z,
            sin_roll * across + cos_roll * z,
        ]
    }

    /// Turns a vector from the track's axes to the wheelset's.
    pub fn to_wheelset(self, [x, y, z]: [T; 3]) -> [T; 3] {
        let ((sin_roll, cos_roll), (sin_yaw, cos_yaw)) = (self.roll, self.yaw);
        let across = cos_roll * y + sin_roll * z;
        [
            cos_yaw * x + sin_yaw * across,
            cos_yaw * across - sin_yaw * x,
            cos_roll * z - sin_roll * y,
        ]
    }
}

/// A wheel that is turned.
#[derive(Clone, Copy)]
pub(super) struct Wheel<T> {
    radius: T,
    turn: Turn<T>,
    tan_yaw: T,
    /// `1 − cos roll`.
    less_by_roll: T,
}

/// Points of a wheel's line of contact.
pub(super) struct Line<T> {
    /// Places from the wheel's centre, axes of the track \[m\].
    pub place: [T; 3],
    /// Depth below the place one wheel radius under the centre \[m\].
    pub below: T,
    /// Normal in the plane of y and z, out of the wheel, and its length.
    pub normal: [T; 2],
    pub size: T,
    /// Distance from the axle over the cosine of the angle between normal and radius.
    pub rolling_radius: T,
    /// Positive where the wheel can touch: it is not too steep there.
    pub can_touch: T,
}

impl<F: Float> Wheel<F> {
    pub fn new(radius: F, position: &Position<F>) -> Self {
        let turn = Turn::new(position);
        let ((sin_roll, cos_roll), (sin_yaw, cos_yaw)) = (turn.roll, turn.yaw);
        let less_by_roll = (sin_roll * sin_roll) / cos_roll.plus(1.0);
        Self { radius, turn, tan_yaw: sin_yaw / cos_yaw, less_by_roll }
    }

    /// The same wheel for several points side by side.
    #[inline(always)]
    pub fn for_all<P: Strips<F>>(&self) -> Wheel<P> {
        let Self { radius, turn: Turn { roll, yaw }, tan_yaw, less_by_roll } = *self;
        let turn =
            Turn { roll: (P::all(roll.0), P::all(roll.1)), yaw: (P::all(yaw.0), P::all(yaw.1)) };
        let (tan_yaw, less_by_roll) = (P::all(tan_yaw), P::all(less_by_roll));
        Wheel { radius: P::all(radius), turn, tan_yaw, less_by_roll }
    }
}

impl<T: Arithmetic> Wheel<T> {
    /// The line of contact at a point of the profile.
    #[inline(always)]
    pub fn line_of_contact(&self, point: Place<T>) -> Line<T> {
        let Place { y, z, cosine, sine } = point;
        let size = (cosine.squared() + sine.squared()).sqrt();
        let per_cosine = cosine.inverse();
        // sin θ = −tan α tan yaw
        let sin = -(sine * per_cosine * self.tan_yaw);
        let steep = (cosine - size.times(STEEPEST)).min(T::constant(FARTHEST) - sin.abs());
        let cos = (T::one() - sin.squared()).sqrt();
        let radius = self.radius + z;
        let (ahead, turn) = (radius * sin, self.turn);
        let place = turn.to_track([ahead, y, radius * cos]);
        // the normal of the wheel makes the profile's angle with its radius
        let [_, normal_y, normal_z] = turn.to_track([cosine * sin, -sine, cosine * cos]);
        // p_z − radius, without a difference of large numbers: cos roll cos θ − 1 = −(1 − cos roll) cos θ − sin² θ/(1 + cos θ)
        let less = self.less_by_roll * cos + sin.squared() / cos.plus(1.0);
        let ((sin_roll, cos_roll), (sin_yaw, cos_yaw)) = (turn.roll, turn.yaw);
        let across = sin_yaw * ahead + cos_yaw * y;
        let below = sin_roll * across + z * cos_roll * cos - self.radius * less;
        Line {
            place,
            below,
            normal: [normal_y, normal_z],
            size,
            rolling_radius: radius * size * per_cosine,
            can_touch: steep,
        }
    }
}
