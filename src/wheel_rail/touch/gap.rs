//! The gap between wheel and rail as a list of points.

use crate::number::{Float, set_at};
use crate::wheel_rail::KSTRIP_SURFACE_CAPACITY;

/// The gap between a wheel and a rail, point by point along the rail. A host with its own search of
/// contact fills it. The first count elements of each member are used.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap<F> {
    /// Length on the rail's surface from any origin \[m\], ascending, else KSTRIP_ERROR_PROFILE. A
    /// host that works in a plane passes its coordinate in this plane.
    pub along: [F; KSTRIP_SURFACE_CAPACITY],
    /// Undeformed gap along the rail's normal \[m\]; negative where the surfaces overlap.
    pub distance: [F; KSTRIP_SURFACE_CAPACITY],
    /// x of the point on the wheel's undeformed surface from the wheel's centre, axes of the track
    /// \[m\]: 0 without yaw.
    pub x: [F; KSTRIP_SURFACE_CAPACITY],
    /// y of this point \[m\].
    pub y: [F; KSTRIP_SURFACE_CAPACITY],
    /// z of this point \[m\], about the wheel's radius.
    pub z: [F; KSTRIP_SURFACE_CAPACITY],
    /// Angle of the tangent across x, mean of both surfaces \[rad\], positive from y to z; about
    /// -1.2 at the flange of a right wheel. Its size is below 2.3, else KSTRIP_ERROR_PROFILE.
    pub angle: [F; KSTRIP_SURFACE_CAPACITY],
    /// Radius of curvature of the wheel along x \[m\], > 0, else KSTRIP_ERROR_ROLLING_RADIUS. It is
    /// R0 = r/cos a without yaw: distance from the axle divided by the cosine of the angle between
    /// normal and radius. A wheel that yaws has
    /// R0/(1 + (sin yaw/cos a)^2 (k R0 - 1)), with the curvature k of its profile; this is R0 (1 -
    /// dx/ds tan(yaw)/cos a) where x changes by dx/ds along the line of these points. Over a
    /// roller the curvatures of both add up, and angle and distance are those in the plane through
    /// the roller's axis and the point.
    pub rolling_radius: [F; KSTRIP_SURFACE_CAPACITY],
    /// Point spacing of the wheel \[m\], >= 0, else KSTRIP_ERROR_SMOOTHING_LENGTH: the gap is
    /// smoothed over at least 2.5 of it. 0: the spacing of the gap's points near the contact.
    pub step: F,
    /// Number of points, at most KSTRIP_SURFACE_CAPACITY, else KSTRIP_ERROR_CAPACITY.
    pub count: u32,
    /// Reserved: zero.
    pub reserved: u32,
}

/// One point of a [`Gap`]: its members in their order.
pub(super) type GapPoint<F> = [F; 7];

impl<F: Float> Gap<F> {
    /// A gap without points.
    pub(in crate::wheel_rail) const fn nothing() -> Self {
        let none = [F::ZERO; KSTRIP_SURFACE_CAPACITY];
        Self {
            along: none,
            distance: none,
            x: none,
            y: none,
            z: none,
            angle: none,
            rolling_radius: none,
            step: F::ZERO,
            count: 0,
            reserved: 0,
        }
    }

    /// The members, in their order.
    pub(in crate::wheel_rail) fn lists(&self) -> [&[F; KSTRIP_SURFACE_CAPACITY]; 7] {
        let Self { along, distance, x, y, z, angle, rolling_radius, .. } = self;
        [along, distance, x, y, z, angle, rolling_radius]
    }

    pub(super) fn set(&mut self, k: usize, point: &GapPoint<F>) {
        let Self { along, distance, x, y, z, angle, rolling_radius, .. } = self;
        let lists = [along, distance, x, y, z, angle, rolling_radius];
        for (list, value) in lists.into_iter().zip(point) {
            set_at(list, k, *value);
        }
    }
}
