//! A rail that is a roller: its profile turns about an axis along `y`.
//!
//! A point of the wheel at `q` ahead of the roller's axis and at the depth `d` above it is at the
//! distance `ρ` from the axis. In the plane through axis and point, which makes the angle `φ` with
//! the vertical, it is at the depth `R − ρ` of the rail's profile:
//!
//! ```text
//! ρ = √(q² + d²),   sin φ = q/ρ,   cos φ = d/ρ
//! ```
//!
//! The wheel is nearest to the roller where its normal lies in this plane: `n_x d + n_z q = 0`
//! instead of `n_x = 0`.

use crate::number::{Float, Strips, length};
use crate::wheel_rail::{Position, WheelPair};

/// Steps of Newton's method for the angle about the axle. Each doubles the number of digits.
const ANGLE_STEPS: u32 = 4;
/// Largest sine of this angle, and least depth of the axis below a point over the roller's radius.
const LARGEST_SINE: f64 = 0.9;
const LEAST_DEPTH: f64 = 0.1;

/// A roller under a wheel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Roller<F> {
    /// `R` \[m\]
    radius: F,
    /// x of its axis from the wheel's centre \[m\].
    ahead: F,
    /// Depth of the place one wheel radius under the wheel's centre \[m\].
    vertical: F,
    wheel_radius: F,
}

/// A direction of the plane through the axis and a point: sine and cosine of `φ`, and `ρ`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Over<F> {
    pub sine: F,
    pub cosine: F,
    pub distance: F,
}

impl<F: Float> Roller<F> {
    /// That of a pair; none where the rail is straight.
    pub fn new(pair: &WheelPair<F>, position: &Position<F>) -> Option<Self> {
        let WheelPair { rail_radius: radius, rail_ahead: ahead, wheel_radius, .. } = *pair;
        let vertical = position.vertical;
        (radius > F::zero()).then_some(Self { radius, ahead, vertical, wheel_radius })
    }

    /// Where a point of the wheel is, by its place from the wheel's centre.
    pub fn over(&self, x: F, z: F) -> Over<F> {
        Over::of_axis(self.axis(), x, z)
    }

    /// x and z of its axis from the wheel's centre \[m\].
    pub fn axis(&self) -> [F; 2] {
        [self.ahead, self.radius + (self.wheel_radius - self.vertical)]
    }

    /// The sine of the angle `θ` about the axle at which points of the wheel are nearest to the
    /// roller, from that over a straight rail. `turn` turns a direction from the wheelset's axes to
    /// the track's; the profile has a radius, a place along the axle, and a direction there.
    #[inline]
    pub fn sine<P: Strips<F>>(
        &self, turn: impl Fn([P; 3]) -> [P; 3], [radius, y]: [P; 2], [cosine, sine]: [P; 2],
        mut sin: P,
    ) -> P {
        let zero = P::zero();
        let [ahead, centre] = self.axis().map(P::all);
        for _ in 0..ANGLE_STEPS {
            let cos = (P::one() - sin.squared()).sqrt();
            let falls = -(sin * cos.inverse());
            let [x, _, z] = turn([radius * sin, y, radius * cos]);
            let [x_by, _, z_by] = turn([radius, zero, radius * falls]);
            let [n_x, _, n_z] = turn([cosine * sin, -sine, cosine * cos]);
            let [n_x_by, _, n_z_by] = turn([cosine, zero, cosine * falls]);
            let (q, d) = (x - ahead, centre - z);
            let rest = n_x * d + n_z * q;
            let slope = n_x_by * d - n_x * z_by + n_z_by * q + n_z * x_by;
            let least = P::all(self.radius.times(LEAST_DEPTH)) * cosine.abs();
            sin = (sin - rest * slope.max(least + P::tiny()).inverse()).within(LARGEST_SINE);
        }
        sin
    }

    /// Turns points into the plane of the rail's profile: their depths below the place one wheel
    /// radius under the centre, the depth of their normals, the curvature of the roller along the
    /// rail, and a number that is positive where the points are over the roller.
    #[inline]
    pub fn unrolled<P: Strips<F>>(&self, x: P, below: P, [n_x, n_z]: [P; 2], size: P) -> [P; 4] {
        let [radius, vertical, ahead] = [self.radius, self.vertical, self.ahead].map(P::all);
        // R − ρ = (R² − ρ²)/(R + ρ), without a difference of large numbers
        let (q, depth) = (x - ahead, vertical + below);
        let d = radius - depth;
        let rho = (q.squared() + d.squared()).sqrt() + P::tiny();
        let height = (depth * (radius + d) - q.squared()) * (radius + rho).inverse();
        let normal = (n_z * d - n_x * q) * rho.inverse();
        let curvature = normal * (size * rho).inverse();
        [height - vertical, normal, curvature, d - radius.times(LEAST_DEPTH)]
    }
}

impl<F: Float> Over<F> {
    /// That of a point over an axis.
    pub fn of_axis([ahead, down]: [F; 2], x: F, z: F) -> Self {
        let (across, depth) = (x - ahead, down - z);
        let distance = length(across, depth) + F::TINY;
        Self { sine: across / distance, cosine: depth / distance, distance }
    }

    /// That over a straight rail.
    pub fn straight() -> Self {
        Self { sine: F::zero(), cosine: F::one(), distance: F::zero() }
    }

    /// A direction with parts along `y` and into the rail, in the axes of the track.
    pub fn turned(&self, across: F, down: F) -> [F; 3] {
        [-self.sine * down, across, self.cosine * down]
    }
}
