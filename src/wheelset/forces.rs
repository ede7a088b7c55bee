//! Forces on a wheelset and on its rails, and their derivatives.

use super::KSTRIP_WHEELSET_FREEDOMS;
use super::kinematics::{Kinematics, Side, Ten, transposed_times};
use crate::number::{Float, add, add_at, are_finite};
use crate::status::Error;
use crate::wheel_rail::forces::wrench::{Wrench, WrenchByPosition, WrenchDerivatives};
use crate::wheel_rail::scene::{Scene, Workspace};
use crate::wheel_rail::{BodyState, Requested, dot};

/// Caller-provided memory for the computation of a wheelset: that of the right wheel and that of
/// the left one. It may hold anything before a call. After KSTRIP_OK or a warning it holds gap and
/// contacts of both wheels.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelsetWorkspace<F> {
    /// Right, left.
    pub wheel: [Workspace<F>; 2],
}

impl<F: Float> WheelsetWorkspace<F> {
    /// An empty workspace, as [`Workspace::new`].
    #[must_use]
    pub const fn new() -> Self {
        Self { wheel: [Workspace::new(); 2] }
    }
}

impl<F: Float> Default for WheelsetWorkspace<F> {
    fn default() -> Self {
        Self::new()
    }
}

/// Forces on a wheelset, on each wheel, and on each rail.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WheelsetForces<F> {
    /// Force on the wheelset \[N\], axes of the track, and moment about its centre \[N m\], its own
    /// axes; sums of dissipation, loads, contacts.
    pub wrench: Wrench<F>,
    /// Force and moment on the right and on the left wheel, about the wheel's centre.
    pub wheel: [Wrench<F>; 2],
    /// Force on the right and on the left rail \[N\], axes of the track: forward, lateral (Y, to
    /// the right), vertical (Q, down).
    pub rail: [[F; 3]; 2],
}

/// Exact derivatives of the forces on a wheelset and its two rails with respect to the velocities.
/// Rows are the ten forces: force and moment on the wheelset, then lateral and vertical force on
/// the right rail and on the left rail. Columns are the ten degrees of freedom
/// (KSTRIP_WHEELSET_FREEDOMS).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WheelsetDerivatives<F> {
    /// With respect to the velocities \[N, N m per m/s, rad/s\].
    pub velocity: [[F; KSTRIP_WHEELSET_FREEDOMS]; KSTRIP_WHEELSET_FREEDOMS],
    /// With respect to a factor on all coefficients of friction, at 1 \[N, N m\].
    pub friction: [F; KSTRIP_WHEELSET_FREEDOMS],
}

/// Derivatives of the same ten forces with respect to the positions of the ten degrees of freedom,
/// at constant velocities.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WheelsetByPosition<F> {
    /// With respect to the positions \[N, N m per m, rad\]; forward and pitch columns are zero.
    pub position: [[F; KSTRIP_WHEELSET_FREEDOMS]; KSTRIP_WHEELSET_FREEDOMS],
}

/// A wheelset on its rails: the right wheel and the left one.
#[derive(Clone, Copy)]
pub struct Wheelset<'a, F> {
    /// Profiles, materials, friction of each side.
    pub scenes: [Scene<'a, F>; 2],
    /// Where each side is.
    pub sides: [Side<F>; 2],
}

impl<F: Float> Wheelset<'_, F> {
    /// Forces at a position and a velocity of the wheelset.
    ///
    /// # Errors
    /// Those of [`Scene::solve`].
    pub fn solve(
        &self, state: &BodyState<F>, memory: &mut WheelsetWorkspace<F>,
    ) -> Result<WheelsetForces<F>, Error> {
        self.differentiate(state, memory, Requested { by_velocity: None, by_position: None })
    }

    /// [`Wheelset::solve`] with the derivatives that are requested.
    ///
    /// # Errors
    /// Those of [`Scene::solve`].
    pub fn differentiate(
        &self, state: &BodyState<F>, memory: &mut WheelsetWorkspace<F>,
        requested: Requested<WheelsetDerivatives<F>, WheelsetByPosition<F>>,
    ) -> Result<WheelsetForces<F>, Error> {
        let BodyState { position, velocity } = state;
        let Requested { mut by_velocity, mut by_position } = requested;
        position.check()?;
        let own = velocity.members();
        Error::NotFinite.unless(are_finite(&own))?;
        if let Some(sums) = &mut by_velocity {
            **sums = WheelsetDerivatives::default();
        }
        if let Some(sums) = &mut by_position {
            **sums = WheelsetByPosition::default();
        }
        let mut found = WheelsetForces::default();
        let WheelsetForces { wrench: sum, wheel, rail } = &mut found;
        let outputs = memory.wheel.iter_mut().zip(wheel).zip(rail);
        for ((scene, side), ((memory, wheel), rail)) in
            self.scenes.iter().zip(&self.sides).zip(outputs)
        {
            side.motion.check()?;
            let kinematics = Kinematics::new(*side, position);
            let requested = Requested {
                by_velocity: by_velocity.as_deref_mut(),
                by_position: by_position.as_deref_mut(),
            };
            *wheel = one_wheel(scene, &kinematics, &own, memory, requested)?;
            let ten = transposed_times(&kinematics.columns(), &wheel.members());
            add(&mut sum.force, ten);
            add(&mut sum.moment, ten.into_iter().skip(3));
            sum.dissipation += wheel.dissipation;
            sum.normal_force += wheel.normal_force;
            sum.contacts += wheel.contacts;
            sum.warning = sum.warning.worse(wheel.warning);
            *rail = wheel.force.map(|force| -force);
        }
        let Wrench { dissipation, normal_force, .. } = *sum;
        let slopes =
            by_velocity.iter().flat_map(|sums| sums.velocity.iter().chain([&sums.friction]));
        let moves = by_position.iter().flat_map(|sums| &sums.position);
        Error::Overflow
            .unless(are_finite(&sum.members()) && are_finite(&[dissipation, normal_force]))?;
        Error::Overflow.unless(slopes.chain(moves).all(|row| are_finite(row))).map(|()| found)
    }
}

/// The wrench of a wheel; adds to the derivatives what it contributes.
fn one_wheel<F: Float>(
    scene: &Scene<'_, F>, kinematics: &Kinematics<F>, own: &[F; 6], memory: &mut Workspace<F>,
    requested: Requested<WheelsetDerivatives<F>, WheelsetByPosition<F>>,
) -> Result<Wrench<F>, Error> {
    let Requested { by_velocity, by_position } = requested;
    let state = &BodyState { position: kinematics.position(), velocity: kinematics.velocity(own) };
    let pair = kinematics.pair(scene.pair);
    let scene = &Scene { pair: &pair, ..*scene };
    if by_velocity.is_none() && by_position.is_none() {
        return scene.solve(state, memory);
    }
    let (mut by, mut moved) = (WrenchDerivatives::default(), WrenchByPosition::default());
    let wanted = by_position.is_some().then_some(&mut moved);
    let by_ahead = match &wanted {
        Some(_) => scene.by_rail_ahead(state, memory)?,
        None => [F::zero(); 6],
    };
    let requested = Requested { by_velocity: Some(&mut by), by_position: wanted };
    let wrench = scene.differentiate(state, memory, requested)?;
    let columns = kinematics.columns();
    if let Some(sums) = by_velocity {
        add(&mut sums.friction, transposed_times(&columns, &by.friction));
        for (k, column) in columns.iter().enumerate() {
            let change = by.velocity.map(|row| dot(&row, column));
            add_column(&mut sums.velocity, k, &transposed_times(&columns, &change));
        }
    }
    if let Some(sums) = by_position {
        let members = wrench.members();
        let [_, _, _, roll_rate, _, yaw_rate] = *own;
        for k in 0..KSTRIP_WHEELSET_FREEDOMS {
            // Aᵀ (∂W/∂q + ∂W/∂w ∂A/∂q u) + ∂Aᵀ/∂q W
            let mut change = [F::zero(); 6];
            for (slopes, share) in moved.columns().into_iter().zip(kinematics.position_by(k)) {
                add(&mut change, slopes.map(|slope| slope * share));
            }
            add(&mut change, by_ahead.map(|slope| slope * kinematics.rail_ahead_by(k)));
            let turned = kinematics.columns_by(k);
            for (column, rate) in turned.iter().zip([roll_rate, yaw_rate]) {
                add(&mut change, by.velocity.map(|row| dot(&row, column) * rate));
            }
            let mut column = transposed_times(&columns, &change);
            let [in_roll, in_yaw] = turned.map(|column| dot(&column, &members));
            let [_, _, _, roll, _, yaw, ..] = &mut column;
            *roll += in_roll;
            *yaw += in_yaw;
            add_column(&mut sums.position, k, &column);
        }
    }
    Ok(wrench)
}

fn add_column<F: Float>(
    matrix: &mut [Ten<F>; KSTRIP_WHEELSET_FREEDOMS], column: usize, entries: &Ten<F>,
) {
    for (row, entry) in matrix.iter_mut().zip(entries) {
        add_at(row, column, *entry);
    }
}
