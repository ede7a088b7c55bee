//! Wheel on rail: from two profiles and a position to the forces on the wheel.
//!
//! Axes of the track: `x` forward, `y` to the right, `z` down. The wheel is the right one; the left
//! one is its mirror image ([`WheelPair::left`]).
//!
//! 1. [`profile`] turns measured or drawn points into a profile at equal steps of its length.
//! 2. [`touch`] finds the line on the wheel where its normal is perpendicular to `x`, and its
//!    distance from the rail. All contacts lie on this line.
//! 3. [`contacts`] finds the zones of contact. Each has a [patch](crate::patch), the direction of
//!    its pressure, and rows that turn the velocity of the wheel into the motion of the patch.
//! 4. [`forces`] turns motion, creep forces and pressure into force and moment on the wheel, with
//!    their derivatives.
//! 5. [`scene`] does all of this for a position, and finds the height of the wheel for a load.
//!
//! Every step is linear in the velocities `v` of the wheel (three of its centre, and three rates).
//! One matrix `B` therefore describes the kinematics of a contact, and virtual power gives the
//! wrench without any further geometry:
//!
//! ```text
//! slip = B v,   W = −Bᵀ F − N n,   W·v = −F·slip − N n·v
//! ```

pub mod contacts;
pub mod forces;
mod height;
pub mod profile;
pub mod scene;
pub mod touch;
mod tried_heights;

use crate::number::{Float, are_finite, ascend};
use crate::status::Error;

/// Maximum number of points in a prepared profile or a gap.
pub const KSTRIP_SURFACE_CAPACITY: usize = 512;
/// Largest number of contacts of one wheel: four separate ones, and two that merge neighbours less
/// than 7 mm apart.
pub const KSTRIP_CONTACTS_CAPACITY: usize = 6;
/// Largest number of places along the rail at which friction is given.
pub const KSTRIP_RAIL_FRICTION_CAPACITY: usize = 4;

/// Position of the wheel on straight track. The flange of a right wheel touches the gauge side of
/// the rail, which is at small y.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Position<F> {
    /// y of the wheel's centre from the origin of the rail's profile \[m\], to the right. The
    /// centre is the point of the axle at y = 0 of the wheel's profile.
    pub lateral: F,
    /// Zero when the centre is one wheel radius above the rail's origin; positive downward \[m\].
    pub vertical: F,
    /// Turn about the vertical, which points down \[rad\]: positive from x to y, between -1 and 1,
    /// else KSTRIP_ERROR_ANGLE.
    pub yaw: F,
    /// Turn about x \[rad\]: positive from y to z, between -1 and 1, else KSTRIP_ERROR_ANGLE. Yaw
    /// turns about the axis that roll has turned.
    pub roll: F,
}

impl<F: Float> Position<F> {
    /// The position of the right wheel that is the mirror image of a left one.
    pub(crate) fn mirrored(self, left: bool) -> Self {
        let Self { lateral, yaw, roll, .. } = self;
        if left { Self { lateral: -lateral, yaw: -yaw, roll: -roll, ..self } } else { self }
    }

    pub(crate) fn members_mut(&mut self) -> [&mut F; 4] {
        let Self { lateral, vertical, yaw, roll } = self;
        [lateral, vertical, yaw, roll]
    }

    /// Checks the members.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let Self { lateral, vertical, yaw, roll } = *self;
        Error::NotFinite.unless(are_finite(&[lateral, vertical, yaw, roll]))?;
        Error::Angle.unless(yaw.abs() < F::one() && roll.abs() < F::one())
    }
}

/// Velocity of the wheel relative to the rail. The axes are at rest; in a curve they are those of
/// the momentary track. Lateral, roll and yaw have the track's signs for a left wheel too.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Velocity<F> {
    /// Velocity of the wheel's centre along x \[m/s\].
    pub forward: F,
    /// Velocity of the centre along y \[m/s\].
    pub lateral: F,
    /// Velocity of the centre along z, down \[m/s\].
    pub vertical: F,
    /// Rate about the wheelset's own x \[rad/s\]; these axes do not spin with the axle.
    pub roll: F,
    /// Rate about the axle \[rad/s\]: about minus forward divided by radius.
    pub pitch: F,
    /// Rate about the wheelset's own z \[rad/s\].
    pub yaw: F,
}

impl<F: Float> Velocity<F> {
    pub(crate) fn members(&self) -> [F; 6] {
        let Self { forward, lateral, vertical, roll, pitch, yaw } = *self;
        [forward, lateral, vertical, roll, pitch, yaw]
    }
}

/// Where a body is, and how it moves: a wheel, or the centre of a wheelset.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyState<F> {
    /// Where it is.
    pub position: Position<F>,
    /// How it moves.
    pub velocity: Velocity<F>,
}

/// Derivatives that are requested, and where they go: those with respect to a [`Velocity`] and
/// those with respect to a [`Position`].
#[derive(Debug)]
pub struct Requested<'a, V, P> {
    /// With respect to velocity and friction.
    pub by_velocity: Option<&'a mut V>,
    /// With respect to position.
    pub by_position: Option<&'a mut P>,
}

/// Materials and friction of a wheel and a rail, and options of the computation. Zero is the
/// default of every member but wheel_radius and shear_modulus.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WheelPair<F> {
    /// Radius of the wheel at z = 0 of its profile \[m\], > 0, else KSTRIP_ERROR_ROLLING_RADIUS.
    pub wheel_radius: F,
    /// Combined shear modulus G \[Pa\], > 0, else KSTRIP_ERROR_MODULUS.
    pub shear_modulus: F,
    /// Combined Poisson's ratio \[-\], 0 to 0.5, else KSTRIP_ERROR_POISSON_RATIO.
    pub poisson_ratio: F,
    /// Coefficient of friction \[-\], >= 0, else KSTRIP_ERROR_FRICTION; if friction_points is 0.
    pub friction: F,
    /// Places on the rail, y of its profile \[m\], ascending, else KSTRIP_ERROR_PROFILE.
    pub friction_y: [F; KSTRIP_RAIL_FRICTION_CAPACITY],
    /// Coefficients there \[-\], as friction; linear between the places, constant beyond.
    pub friction_at: [F; KSTRIP_RAIL_FRICTION_CAPACITY],
    /// How many of these places there are, at most KSTRIP_RAIL_FRICTION_CAPACITY, else
    /// KSTRIP_ERROR_CAPACITY; 0: friction is the same everywhere.
    pub friction_points: u32,
    /// 0: a right wheel; any other number: a left wheel. The profiles are always those of a right
    /// wheel; position, velocity and wrench are the wheel's own.
    pub left: i32,
    /// Length over which the undeformed gap is smoothed \[m\], >= 0, else
    /// KSTRIP_ERROR_SMOOTHING_LENGTH. It is always at least 2.5 steps of the wheel's profile. For
    /// rough profiles set it to 2 mm.
    pub smoothing_length: F,
    /// Strips of a contact, about: 4, 8, 16, 32 or 64, else KSTRIP_ERROR_STRIP_COUNT; 0: 16.
    pub strips: i32,
    /// KSTRIP_MODEL_STRIP (the default here), KSTRIP_MODEL_TOTAL or one of the models of 1967.
    pub model: i32,
    /// Damping d \[s/m\], >= 0, else KSTRIP_ERROR_NORMAL_DAMPING (Hunt and Crossley): the pressure
    /// is multiplied by 1 + d times the velocity at which the surfaces approach each other, or by 0
    /// if this factor is negative; the bound of friction changes with it.
    pub normal_damping: F,
    /// Floor of the speed \[m/s\], as in kstrip_motion; 0 stands for 0.02, and a negative one is
    /// KSTRIP_ERROR_FLOOR_SPEED.
    pub floor_speed: F,
    /// Radius of the rail at z = 0 of its profile \[m\], >= 0, else KSTRIP_ERROR_ROLLING_RADIUS: of
    /// a roller rig or of the lower of two discs, whose axis is along y; 0: a straight rail.
    pub rail_radius: F,
    /// x of the roller's axis from the wheel's centre \[m\]; not used for a straight rail.
    pub rail_ahead: F,
    /// Speed at which the surface of the rail moves backward under the wheel \[m/s\], that of a
    /// roller at rail_radius: a wheel whose centre is at rest rolls on it like a wheel that moves
    /// forward on a rail at rest.
    pub rail_speed: F,
}

impl<F: Float> WheelPair<F> {
    /// Checks the members but for the materials, which are checked with the patch.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let places = self.friction_points as usize;
        let (Some(y), Some(at)) = (self.friction_y.get(..places), self.friction_at.get(..places))
        else {
            return Err(Error::Capacity);
        };
        let friction = if places == 0 { self.friction } else { F::zero() };
        let Self { wheel_radius, smoothing_length, normal_damping, floor_speed, .. } = *self;
        let Self { rail_radius, rail_ahead, rail_speed, .. } = *self;
        let numbers = [wheel_radius, friction, smoothing_length, normal_damping, floor_speed];
        let of_rail = [rail_radius, rail_ahead, rail_speed];
        Error::NotFinite
            .unless([numbers.as_slice(), &of_rail, y, at].into_iter().all(are_finite))?;
        Error::RollingRadius.when(wheel_radius <= F::zero() || rail_radius < F::zero())?;
        Error::Friction.when(at.iter().chain([&friction]).any(|friction| *friction < F::zero()))?;
        Error::SmoothingLength.when(smoothing_length < F::zero())?;
        Error::NormalDamping.unless(normal_damping >= F::zero())?;
        Error::FloorSpeed.unless(floor_speed >= F::zero())?;
        Error::Profile.unless(ascend(y))
    }

    /// Coefficient of friction at a place of the rail.
    pub(crate) fn friction_at_rail(&self, y: F) -> F {
        let places = self.friction_y.iter().zip(&self.friction_at);
        let mut last: Option<(F, F)> = None;
        for (&place, &friction) in places.take(self.friction_points as usize) {
            if y < place {
                let Some((before, from)) = last else { return friction };
                return from + (friction - from) * ((y - before) / (place - before));
            }
            last = Some((place, friction));
        }
        last.map_or(self.friction, |(_, friction)| friction)
    }
}

/// Sine and cosine of an angle up to 2.3 in size.
pub(crate) fn sine_cosine<F: Float>(angle: F) -> (F, F) {
    // half the angle by Taylor's series, then sin 2x = 2 sin x cos x,  1 − cos 2x = 2 sin² x
    let x = angle.times(0.5);
    let square = x * x;
    let (mut sine, mut cosine) = (F::zero(), F::zero());
    for k in (1..=9_i32).rev() {
        let [odd, even] = [(2 * k) * (2 * k + 1), (2 * k) * (2 * k - 1)]
            .map(|product| -F::one() / F::widened(product as f32));
        sine = square * odd * sine.plus(1.0);
        cosine = square * even * cosine.plus(1.0);
    }
    let (sine, cosine) = (x * sine.plus(1.0), cosine.plus(1.0));
    ((sine * cosine).times(2.0), F::one() - (sine * sine).times(2.0))
}

/// The vector product.
pub(crate) fn cross<F: Float>([a, b, c]: [F; 3], [x, y, z]: [F; 3]) -> [F; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// `a·b` of vectors of any length.
pub(crate) fn dot<F: Float, const N: usize>(a: &[F; N], b: &[F; N]) -> F {
    a.iter().zip(b).fold(F::zero(), |sum, (a, b)| sum + *a * *b)
}
