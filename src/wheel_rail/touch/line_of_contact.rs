//! The line of contact: the line on a wheel where its normal is perpendicular to `x`.
//!
//! A wheel of radius `r(y)` that yaws touches ahead of its lowest line where it is steep. In the
//! wheel's axes, `θ` about the axle from below, `α` the angle of its profile and `R` the turn by
//! roll and yaw,
//!
//! ```text
//! p = R (r sin θ, y, r cos θ),   n = R (cos α sin θ, −sin α, cos α cos θ)
//! n_x = 0:  sin θ = tan α R₀₁/R₀₀ = −tan α tan yaw
//! ```
//!
//! There `x` makes an angle with the wheel's circumference whose sine is `sin yaw/cos α`. By Euler,
//! with the radius of curvature `R₀ = r/cos α` along the circumference and the curvature `κ` of the
//! profile across it, the radius along `x` is
//!
//! ```text
//! R = R₀/(1 + (sin yaw/cos α)² (κ R₀ − 1))
//! ```

use super::roller::{Over, Roller};
use crate::number::{Arithmetic, Float, Strips};
use crate::wheel_rail::profile::CurvePoint;
use crate::wheel_rail::{Position, WheelPair, cross, sine_cosine};

/// Least cosine of the profile's angle, and largest sine of θ, at which a wheel can touch.
const LEAST_COSINE: f64 = 0.06;
const LARGEST_THETA: f64 = 0.9;
/// Bounds of the rolling radius over `r/cos α`.
pub(crate) const RADIUS_FACTORS: [f64; 2] = [0.2, 5.0];

/// Sines and cosines of the roll and the yaw of a wheel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turn<F> {
    roll: (F, F),
    pub yaw: (F, F),
}

impl<F: Float> Turn<F> {
    pub fn new(position: &Position<F>) -> Self {
        // denormal angles would lose their digits in quotients
        let clear = |angle: F| if angle.abs() < F::TINY { F::zero() } else { angle };
        let [roll, yaw] = [position.roll, position.yaw].map(|angle| sine_cosine(clear(angle)));
        Self { roll, yaw }
    }

    /// Turns vectors side by side from the wheelset's axes to the track's: by yaw, then by roll.
    #[inline]
    pub fn to_track<P: Strips<F>>(self, vectors: [P; 3]) -> [P; 3] {
        self.turned(vectors, P::all)
    }

    /// The same of numbers that `of` makes of plain ones.
    #[inline(always)]
    fn turned<P: Arithmetic>(self, [x, y, z]: [P; 3], of: impl Fn(F) -> P) -> [P; 3] {
        let [sin_roll, cos_roll] = [self.roll.0, self.roll.1].map(&of);
        let [sin_yaw, cos_yaw] = [self.yaw.0, self.yaw.1].map(of);
        let across = sin_yaw * x + cos_yaw * y;
        [
            cos_yaw * x - sin_yaw * y,
            cos_roll * across - sin_roll * z,
            sin_roll * across + cos_roll * z,
        ]
    }

    /// The same of one vector.
    pub fn vector_to_track(self, vector: [F; 3]) -> [F; 3] {
        self.turned(vector, |own| own)
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

/// From the axes of the track to the members of the velocity.
pub(crate) struct Axes<F> {
    pub turn: Turn<F>,
    pub left: bool,
}

impl<F: Float> Axes<F> {
    /// A direction and a moment as derivatives with respect to the wheel's own velocities.
    pub fn members(&self, [x, y, z, a, b, c]: [F; 6]) -> [F; 6] {
        let [roll, pitch, yaw] = self.turn.to_wheelset([a, b, c]);
        if self.left { [x, -y, z, -roll, pitch, -yaw] } else { [x, y, z, roll, pitch, yaw] }
    }

    /// `B` of a point of the wheel: slip along tangents with the mean angle of both surfaces, spin
    /// about the wheel's own normal; of both angles the sine and the cosine.
    pub fn rows(
        &self, place: [F; 3], [sine, cosine]: [F; 2], [wheel_sine, wheel_cosine]: [F; 2],
        over: &Over<F>,
    ) -> [[F; 6]; 3] {
        let zero = F::zero();
        let [a, b, c] = over.turned(-wheel_sine, wheel_cosine);
        [
            with_moment(place, [over.cosine, zero, over.sine]),
            with_moment(place, over.turned(cosine, sine)),
            [zero, zero, zero, a, b, c],
        ]
        .map(|row| self.members(row))
    }
}

/// A direction and its moment about the wheel's centre.
pub(crate) fn with_moment<F: Float>(place: [F; 3], direction: [F; 3]) -> [F; 6] {
    let ([a, b, c], [d, e, f]) = (direction, cross(place, direction));
    [a, b, c, d, e, f]
}

#[derive(Clone, Copy)]
pub(crate) struct Wheel<F> {
    radius: F,
    turn: Turn<F>,
    tan_yaw: F,
    /// `1 − cos roll`.
    less_by_roll: F,
    /// The roller under it, if the rail is one.
    roller: Option<Roller<F>>,
}

/// Points of a wheel's line of contact, side by side.
pub(crate) struct Line<P> {
    /// Places from the wheel's centre, axes of the track \[m\].
    pub place: [P; 3],
    /// Depth below the place one wheel radius under the centre \[m\].
    pub below: P,
    /// Normal in the plane of y and z, out of the wheel, and its length. Over a roller this plane,
    /// and the depth above, are those through its axis and the place.
    pub normal: [P; 2],
    pub size: P,
    /// Curvature of a roller along the rail \[1/m\]; 0 over a straight rail.
    pub curvature: P,
    /// Positive where the wheel can touch: it is not too steep there.
    pub can_touch: P,
}

impl<F: Float> Wheel<F> {
    pub fn new(radius: F, position: &Position<F>) -> Self {
        let turn = Turn::new(position);
        let ((sin_roll, cos_roll), (sin_yaw, cos_yaw)) = (turn.roll, turn.yaw);
        let less_by_roll = (sin_roll * sin_roll) / cos_roll.plus(1.0);
        Self { radius, turn, tan_yaw: sin_yaw / cos_yaw, less_by_roll, roller: None }
    }

    /// That of a pair, over its rail.
    pub fn of_pair(pair: &WheelPair<F>, position: &Position<F>) -> Self {
        let roller = Roller::new(pair, position);
        Self { roller, ..Self::new(pair.wheel_radius, position) }
    }

    /// The line of contact at points of the profile.
    #[inline(always)]
    pub fn line_of_contact<P: Strips<F>>(&self, point: &CurvePoint<P>) -> Line<P> {
        let CurvePoint { y, z, cosine, sine } = *point;
        let size = (cosine.squared() + sine.squared()).sqrt();
        let per_cosine = cosine.inverse();
        // sin θ = −tan α tan yaw
        let mut sin = -(sine * per_cosine * P::all(self.tan_yaw));
        if let Some(roller) = &self.roller {
            let turn = |vector| self.turn.to_track(vector);
            sin = roller.sine(turn, [P::all(self.radius) + z, y], [cosine, sine], sin);
        }
        let steep = (cosine - size.times(LEAST_COSINE)).min(P::constant(LARGEST_THETA) - sin.abs());
        let cos = (P::one() - sin.squared()).sqrt();
        let (whole, turn) = (P::all(self.radius), self.turn);
        let radius = whole + z;
        let ahead = radius * sin;
        let place = turn.to_track([ahead, y, radius * cos]);
        // the normal of the wheel makes the profile's angle with its radius
        let [normal_x, normal_y, normal_z] = turn.to_track([cosine * sin, -sine, cosine * cos]);
        // p_z − radius: cos roll cos θ − 1 = −(1 − cos roll) cos θ − sin² θ/(1 + cos θ)
        let less = P::all(self.less_by_roll) * cos + sin.squared() / cos.plus(1.0);
        let [_, _, below] = turn.to_track([ahead, y, z * cos]);
        let mut line = Line {
            place,
            below: below - whole * less,
            normal: [normal_y, normal_z],
            size,
            curvature: P::zero(),
            can_touch: steep,
        };
        if let Some(roller) = &self.roller {
            let [x, ..] = place;
            let [below, normal_z, curvature, is_over] =
                roller.unrolled(x, line.below, [normal_x, normal_z], size);
            line.can_touch = steep.min(is_over);
            (line.below, line.normal, line.curvature) = (below, [normal_y, normal_z], curvature);
        }
        line
    }

    /// The radius of curvature along `x` at points of the profile with these convex curvatures.
    #[inline]
    pub fn rolling_radius<P: Strips<F>>(&self, point: &CurvePoint<P>, curvature: P) -> P {
        let CurvePoint { z, cosine, sine, .. } = *point;
        let per_cosine = cosine.inverse();
        let size = (cosine.squared() + sine.squared()).sqrt();
        let radius = (P::all(self.radius) + z) * size * per_cosine;
        let square = (P::all(self.turn.yaw.0) * size * per_cosine).squared();
        let more = square * (curvature * radius - P::one());
        let curved = more.plus(1.0).max(P::constant(1.0 / RADIUS_FACTORS[1]));
        radius * curved.min(P::constant(1.0 / RADIUS_FACTORS[0])).inverse()
    }
}
