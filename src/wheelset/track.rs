//! The track: the places of the rails, and motion and weight on a curve.

use crate::number::{Float, are_finite};
use crate::status::{Error, Warning};
use crate::wheel_rail::profile::PreparedProfile;
use crate::wheel_rail::{Position, Velocity, sine_cosine};

/// Default of the depth below the top of the rail down to which the gauge is measured \[m\] (EN
/// 13848-1).
const DEPTH: f64 = 14e-3;
/// Standard acceleration of gravity \[m/s²\] (ISO 80000-3).
const GRAVITY: f64 = 9.806_65;
/// Largest plausible curvature of a track \[1/m\].
const SHARPEST: f64 = 0.2;
/// A profile that ends less than this above the depth is complete \[m\].
const COMPLETE: f64 = 10e-6;

/// Displacement and velocity of a rail: irregularities of the track, or the motion of a flexible
/// rail. Axes of the track.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RailMotion<F> {
    /// Displacement to the right \[m\].
    pub lateral: F,
    /// Displacement downward \[m\].
    pub vertical: F,
    /// Velocity to the right \[m/s\].
    pub lateral_velocity: F,
    /// Velocity downward \[m/s\].
    pub vertical_velocity: F,
}

impl<F: Float> RailMotion<F> {
    pub(crate) fn check(&self) -> Result<(), Error> {
        let Self { lateral, vertical, lateral_velocity, vertical_velocity } = *self;
        let numbers = [lateral, vertical, lateral_velocity, vertical_velocity];
        Error::NotFinite.unless(are_finite(&numbers))
    }
}

/// The gauge face of a rail: its least `y` down to a depth below its top (0: 14 mm). The rail's
/// origin lies half the gauge minus this `y` from the middle of the track. [`Warning::ProfileEnd`]
/// where the profile ends above the depth.
///
/// # Errors
/// [`Error::NotPrepared`], [`Error::NotFinite`]; [`Error::Gauge`] for a negative depth.
pub fn gauge_face<F: Float>(rail: &PreparedProfile<F>, depth: F) -> Result<(F, Warning), Error> {
    rail.check()?;
    Error::NotFinite.unless(depth.is_finite_number())?;
    Error::Gauge.unless(depth >= F::zero())?;
    let depth = if depth > F::zero() { depth } else { F::of(DEPTH) };
    let points = || (0..rail.count as usize).filter_map(|k| rail.point(k));
    let top = points().fold(F::LARGEST, |top, point| top.min(point.z));
    let lowest = top + depth;
    let mut face = F::LARGEST;
    let mut before: Option<[F; 2]> = None;
    for point in points() {
        let inside = point.z <= lowest;
        // where a straight line between the points crosses the depth
        if let Some([y, z]) = before.filter(|[_, z]| (*z <= lowest) != inside) {
            face = face.min(y + (point.y - y) * ((lowest - z) / (point.z - z)));
        }
        if inside {
            face = face.min(point.y);
        }
        before = Some([point.y, point.z]);
    }
    let is_complete = points().next().is_some_and(|end| end.z >= lowest.plus(-COMPLETE));
    Ok((face, if is_complete { Warning::None } else { Warning::ProfileEnd }))
}

/// A curve that a vehicle runs through: the axes of the track move forward and turn with it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Curve<F> {
    /// Speed along the middle of the track, at the height of the wheelset's centre \[m/s\].
    pub speed: F,
    /// One divided by the radius of the curve \[1/m\]: positive to the right, 0: straight.
    /// KSTRIP_WARNING_CURVATURE if its size is above 0.2.
    pub curvature: F,
    /// Angle of cant \[rad\]: positive where the right rail is lower, between -1 and 1, else
    /// KSTRIP_ERROR_ANGLE. In a curve to the right it is positive.
    pub cant: F,
    /// Acceleration of gravity \[m/s^2\]; 0: 9.80665.
    pub gravity: F,
}

impl<F: Float> Curve<F> {
    /// The velocity relative to the momentary track of a body that moves with `relative` in the
    /// axes of the track, which run along the curve; and the weight per mass in these axes, its
    /// centrifugal part included.
    ///
    /// ```text
    /// v = v_rel + (V (1 − y κ cos c), 0, 0),   ω = ω_rel + Rᵀ κ V (0, sin c, cos c)
    /// g' = g (0, sin c, cos c) − V² κ (0, cos c, −sin c)
    /// ```
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Angle`] for angles of 1 or more, [`Error::Overflow`].
    pub fn motion(
        &self, position: &Position<F>, relative: &Velocity<F>,
    ) -> Result<(Velocity<F>, [F; 3], Warning), Error> {
        let Self { speed, curvature, cant, gravity } = *self;
        position.check()?;
        let members = relative.members();
        Error::NotFinite
            .unless(are_finite(&[speed, curvature, cant, gravity]) && are_finite(&members))?;
        Error::Angle.unless(cant.abs() < F::one())?;
        let gravity = if gravity == F::zero() { F::of(GRAVITY) } else { gravity };
        let (sine, cosine) = sine_cosine(cant);
        let turning = curvature * speed;
        let (across, down) = (turning * sine, turning * cosine);
        let ((sin_roll, cos_roll), (sin_yaw, cos_yaw)) =
            (sine_cosine(position.roll), sine_cosine(position.yaw));
        let level = cos_roll * across + sin_roll * down;
        let velocity = Velocity {
            forward: relative.forward + speed - position.lateral * down,
            roll: relative.roll + sin_yaw * level,
            pitch: relative.pitch + cos_yaw * level,
            yaw: relative.yaw + cos_roll * down - sin_roll * across,
            ..*relative
        };
        let outward = speed * turning;
        let weight =
            [F::zero(), gravity * sine - outward * cosine, gravity * cosine + outward * sine];
        Error::Overflow.unless(are_finite(&velocity.members()) && are_finite(&weight))?;
        let is_radius = curvature.abs() > F::of(SHARPEST);
        let warning = if is_radius { Warning::Curvature } else { Warning::None };
        Ok((velocity, weight, warning))
    }
}
