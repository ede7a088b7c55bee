//! Position and velocity of a wheel over its rail.
//!
//! The wheelset turns by roll about `x` and by yaw about the axis that roll has turned: its axes in
//! the track are the columns `e₁, e₂, e₃` of `R = R_x(roll) R_z(yaw)`. A wheel at `y = s` of the
//! wheelset has its centre at `s e₂`, and with the rates `p` and `r` about `e₁` and `e₃`
//!
//! ```text
//! position = q + s e₂ − origin − rail,   velocity = v + s (p e₃ − r e₁) − rail's velocity
//! ```

use super::KSTRIP_WHEELSET_FREEDOMS;
use super::track::RailMotion;
use crate::number::{Float, add};
use crate::wheel_rail::{Position, Velocity, WheelPair, dot, sine_cosine};

/// The ten velocities, or ten forces.
pub(super) type Ten<F> = [F; KSTRIP_WHEELSET_FREEDOMS];

/// A side of a wheelset.
#[derive(Clone, Copy, Debug)]
pub struct Side<F> {
    /// From the middle of the wheelset to y = 0 of the wheel's profile \[m\]: negative on the left
    /// side.
    pub arm: F,
    /// y of the rail's origin from the middle of the track \[m\]: negative on the left side.
    pub origin: F,
    /// By how much the wheel's radius exceeds the mean of both wheels \[m\].
    pub excess: F,
    /// Number of the rail's lateral freedom: 6 on the right side, 8 on the left side.
    pub rail: usize,
    /// How the rail has moved and moves.
    pub motion: RailMotion<F>,
}

impl<F: Float> Side<F> {
    /// The right side of a wheelset with equal wheels over a rail at rest: distances \[m\], > 0,
    /// of the wheel's running circle from the middle of the wheelset, and of the rail's origin from
    /// the middle of the track.
    #[must_use]
    pub fn right(arm: F, origin: F) -> Self {
        Self { arm, origin, excess: F::ZERO, rail: 6, motion: RailMotion::default() }
    }

    /// The left side, with the same two distances, > 0.
    #[must_use]
    pub fn left(arm: F, origin: F) -> Self {
        Self { arm: -arm, origin: -origin, rail: 8, ..Self::right(arm, origin) }
    }
}

/// Kinematics of a wheel over its rail at a position of the wheelset.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kinematics<F> {
    side: Side<F>,
    position: Position<F>,
    /// The wheelset's first, second and third axis in the track's axes.
    axes: [[F; 3]; 3],
    roll: (F, F),
    yaw: (F, F),
}

impl<F: Float> Kinematics<F> {
    pub fn new(side: Side<F>, position: &Position<F>) -> Self {
        let (roll, yaw) = (sine_cosine(position.roll), sine_cosine(position.yaw));
        let ((sin_roll, cos_roll), (sin_yaw, cos_yaw)) = (roll, yaw);
        let axes = [
            [cos_yaw, cos_roll * sin_yaw, sin_roll * sin_yaw],
            [-sin_yaw, cos_roll * cos_yaw, sin_roll * cos_yaw],
            [F::zero(), -sin_roll, cos_roll],
        ];
        Self { side, position: *position, axes, roll, yaw }
    }

    /// Position of the wheel over its rail.
    pub fn position(&self) -> Position<F> {
        let Self { side: Side { arm, origin, excess, motion, .. }, position, axes, .. } = self;
        let [_, [_, across, down], _] = *axes;
        Position {
            lateral: position.lateral + *arm * across - *origin - motion.lateral,
            vertical: position.vertical + *arm * down + *excess - motion.vertical,
            ..*position
        }
    }

    /// The wheel's pair, with the place of a roller's axis from its centre.
    pub fn pair(&self, pair: &WheelPair<F>) -> WheelPair<F> {
        let Self { side: Side { arm, .. }, axes: [_, [ahead, ..], _], .. } = *self;
        WheelPair { rail_ahead: pair.rail_ahead - arm * ahead, ..*pair }
    }

    /// Derivative of the place of a roller's axis with respect to the position of a freedom.
    pub fn rail_ahead_by(&self, freedom: usize) -> F {
        let (_, cos_yaw) = self.yaw;
        if freedom == 5 { self.side.arm * cos_yaw } else { F::zero() }
    }

    /// Velocity of the wheel over its rail.
    pub fn velocity(&self, own: &[F; 6]) -> Velocity<F> {
        let columns = self.columns();
        let mut sums = [F::zero(); 6];
        for (column, own) in columns.iter().zip(own) {
            add(&mut sums, column.map(|entry| entry * *own));
        }
        let [forward, lateral, vertical, roll, pitch, yaw] = sums;
        let RailMotion { lateral_velocity, vertical_velocity, .. } = self.side.motion;
        let (lateral, vertical) = (lateral - lateral_velocity, vertical - vertical_velocity);
        Velocity { forward, lateral, vertical, roll, pitch, yaw }
    }

    /// The columns of `A`: the wheel's velocity over its rail by the ten velocities.
    pub fn columns(&self) -> [[F; 6]; KSTRIP_WHEELSET_FREEDOMS] {
        let Self { side: Side { arm, rail, .. }, axes: [ahead, _, down], .. } = *self;
        let unit = |place: usize, size: F| {
            core::array::from_fn(|i| if i == place { size } else { F::zero() })
        };
        core::array::from_fn(|k| match k {
            3 => add_turned(unit(3, F::one()), arm, down),
            5 => add_turned(unit(5, F::one()), -arm, ahead),
            0..6 => unit(k, F::one()),
            _ if k == rail => unit(1, -F::one()),
            _ if k == rail + 1 => unit(2, -F::one()),
            _ => [F::zero(); 6],
        })
    }

    /// `∂A/∂q`: derivatives of the columns of the roll rate and of the yaw rate with respect to a
    /// freedom's position; only roll and yaw have some.
    pub fn columns_by(&self, freedom: usize) -> [[F; 6]; 2] {
        let Self { side: Side { arm, .. }, axes: [_, across, _], .. } = *self;
        let ((sin_roll, cos_roll), (sin_yaw, _)) = (self.roll, self.yaw);
        let zero = [F::zero(); 6];
        match freedom {
            3 => [
                add_turned(zero, arm, [F::zero(), -cos_roll, -sin_roll]),
                add_turned(zero, -arm, [F::zero(), -sin_roll * sin_yaw, cos_roll * sin_yaw]),
            ],
            5 => [zero, add_turned(zero, -arm, across)],
            _ => [zero; 2],
        }
    }

    /// Derivatives of the wheel's lateral, vertical, yaw and roll with respect to a freedom.
    pub fn position_by(&self, freedom: usize) -> [F; 4] {
        let Side { arm, rail, .. } = self.side;
        let ((sin_roll, cos_roll), (sin_yaw, cos_yaw)) = (self.roll, self.yaw);
        let (zero, one) = (F::zero(), F::one());
        match freedom {
            1 => [one, zero, zero, zero],
            2 => [zero, one, zero, zero],
            3 => [-arm * cos_yaw * sin_roll, arm * cos_yaw * cos_roll, zero, one],
            5 => [-arm * sin_yaw * cos_roll, -arm * sin_yaw * sin_roll, one, zero],
            _ if freedom == rail => [-one, zero, zero, zero],
            _ if freedom == rail + 1 => [zero, -one, zero, zero],
            _ => [zero; 4],
        }
    }
}

/// Adds a share of a direction to the velocity of the centre.
fn add_turned<F: Float>(column: [F; 6], share: F, [x, y, z]: [F; 3]) -> [F; 6] {
    let [a, b, c, roll, pitch, yaw] = column;
    [a + share * x, b + share * y, c + share * z, roll, pitch, yaw]
}

/// `Aᵀ W`: the ten forces of a wheel's wrench.
pub(super) fn transposed_times<F: Float>(
    columns: &[[F; 6]; KSTRIP_WHEELSET_FREEDOMS], wrench: &[F; 6],
) -> Ten<F> {
    columns.map(|column| dot(&column, wrench))
}
