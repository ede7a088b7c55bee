//! Points and directions of a wheel as derivatives with respect to its six velocities.

use super::line_of_contact::Turn;
use super::{cross, sine_cosine};
use crate::number::Float;

/// From the axes of the track to the members of the velocity.
pub(super) struct Axes<F> {
    pub turn: Turn<F>,
    pub left: bool,
}

impl<F: Float> Axes<F> {
    /// A direction and a moment as derivatives with respect to the wheel's own velocities.
    pub fn members(&self, [x, y, z, a, b, c]: [F; 6]) -> [F; 6] {
        let [roll, pitch, yaw] = self.turn.to_wheelset([a, b, c]);
        if self.left { [x, -y, z, -roll, pitch, -yaw] } else { [x, y, z, roll, pitch, yaw] }
    }

    /// `B` of a point of a surface with a tangent of this angle.
    pub fn rows(&self, place: [F; 3], angle: F) -> [[F; 6]; 3] {
        let ((sine, cosine), zero) = (sine_cosine(angle), F::zero());
        [
            with_moment(place, [F::one(), zero, zero]),
            with_moment(place, [zero, cosine, sine]),
            [zero, zero, zero, zero, -sine, cosine],
        ]
        .map(|row| self.members(row))
    }
}

/// A direction and its moment about the wheel's centre.
pub(super) fn with_moment<F: Float>(place: [F; 3], direction: [F; 3]) -> [F; 6] {
    let ([a, b, c], [d, e, f]) = (direction, cross(place, direction));
    [a, b, c, d, e, f]
}
