//! From contacts and velocities to force and moment on the wheel.
//!
//! The wheel may roll forward or backward, or stand still, as in [`motion`](crate::motion).
//! Backward rolling is forward rolling of the patch turned by 180 degrees: `F₋(c) = R F₊(R c)` with
//! `R = diag(−1, −1, 1)`.
//!
//! ```text
//! W = −Bᵀ F − m N n,   m = max(0, 1 + d n·v)
//! ∂W/∂v = −Bᵀ (∂F/∂slip B + ∂F/∂V ∂V/∂v + d ∂F/∂m n) − d N n n
//! ```
//!
//! The damping `d` multiplies the pressure by `m`, as Hunt and Crossley have it, and with the
//! pressure the friction bound of every strip. (The contact area stays that of the pressure alone.)

use super::contacts::WheelContact;
use super::{Velocity, dot};
use crate::contact::creepage::Creepage;
use crate::forces::{Model, Solution};
use crate::friction::SlipFriction;
use crate::motion::{MotionDerivatives, Rolling};
use crate::number::{Float, are_finite, reverse};
use crate::patch::{self, PatchView, StoredPatch, solver};
use crate::status::{Error, Warning};

/// Force and moment on a wheel. They are conjugate to the members of kstrip_wheel_velocity: the
/// products add up to power.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrench<F> {
    /// Force on the wheel, axes of the track \[N\]: forward, lateral, vertical (down; the rail's
    /// support is negative).
    pub force: [F; 3],
    /// Moment on the wheel about its centre \[N m\] about the wheelset's own axes: roll, pitch
    /// (about the axle), yaw.
    pub moment: [F; 3],
    /// Frictional power \[W\], not negative: creep forces on the rail times slip. The power of the
    /// creep forces on the wheel is minus this, but for contacts with a mismatch of the materials,
    /// where pressure adds to the slip.
    pub dissipation: F,
    /// Sum of the loads of all contacts \[N\], each along its own normal.
    pub normal_force: F,
    /// Number of contacts; 0: the wheel is lifted, and nothing acts.
    pub contacts: u32,
    /// The status of this result: 0 or one of the KSTRIP_WARNING constants.
    pub warning: Warning,
}

/// Exact derivatives of the wrench. The rows are the members of force and moment.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WrenchDerivatives<F> {
    /// With respect to the members of kstrip_wheel_velocity \[N, N m per m/s, rad/s\].
    pub velocity: [[F; 6]; 6],
    /// With respect to a factor on all coefficients of friction, at 1 \[N, N m\].
    pub friction: [F; 6],
}

/// Derivatives of the wrench with respect to the wheel's position at constant velocity: differences
/// of complete computations.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WrenchByPosition<F> {
    /// With respect to the lateral position \[N, N m per m\].
    pub lateral: [F; 6],
    /// With respect to the vertical position \[N, N m per m\].
    pub vertical: [F; 6],
    /// With respect to yaw \[N, N m per rad\].
    pub yaw: [F; 6],
    /// With respect to roll \[N, N m per rad\].
    pub roll: [F; 6],
}

impl<F> WrenchByPosition<F> {
    /// The columns, in the order of the members of a position.
    pub(super) fn columns(&mut self) -> [&mut [F; 6]; 4] {
        let Self { lateral, vertical, yaw, roll } = self;
        [lateral, vertical, yaw, roll]
    }
}

impl<F: Float> Wrench<F> {
    /// The wrench's six members.
    #[must_use]
    pub fn members(&self) -> [F; 6] {
        let ([a, b, c], [d, e, f]) = (self.force, self.moment);
        [a, b, c, d, e, f]
    }
}

/// The model of the creep forces, and the law of friction.
#[derive(Clone, Copy)]
pub struct Law<'a, F> {
    /// The model.
    pub model: Model,
    /// Friction that falls with the slip; its own coefficient and rolling speed are ignored.
    pub falling: Option<&'a SlipFriction<F>>,
}

/// Computes the wrench of contacts, and its derivatives where they are wanted.
///
/// # Errors
/// [`Error::NotFinite`]; those of [`solver::solve`], [`patch::friction::solve`] and
/// [`StoredPatch::view`].
pub fn of_contacts<F: Float>(
    contacts: &[WheelContact<F>],
    velocity: &Velocity<F>,
    law: Law<F>,
    mut derivatives: Option<&mut WrenchDerivatives<F>>,
) -> Result<Wrench<F>, Error> {
    let (velocity, zero) = (velocity.members(), F::zero());
    if !are_finite(&velocity) {
        return Err(Error::NotFinite);
    }
    if let Some(sums) = &mut derivatives {
        **sums = WrenchDerivatives { velocity: [[zero; 6]; 6], friction: [zero; 6] };
    }
    let (mut sums, mut normal_force, mut dissipation) = ([zero; 6], zero, zero);
    let mut warning = Warning::None;
    for contact in contacts {
        if !(are_finite(&contact.normal) && are_finite(&[contact.share, contact.normal_force])) {
            return Err(Error::NotFinite);
        }
        if contact.share < zero || contact.normal_force < zero {
            return Err(Error::NormalForce);
        }
        if contact.is_conformal() {
            warning = warning.worse(Warning::AngleRange);
        }
        let motion = contact.motion(&velocity);
        let rolling = Rolling::new(&motion)?;
        let factor = contact.damping_factor(&velocity)?;
        if factor == zero {
            // the surfaces part faster than they push
            continue;
        }
        let pressed = Pressed { patch: &contact.patch, factor };
        let carried = match &mut derivatives {
            None => pressed.carried(&rolling, law)?,
            Some(sums) => {
                let (found, slopes) = pressed.differentiated(&rolling, law)?;
                sums.add(contact, &slopes, factor);
                found
            }
        };
        let force = forces(&carried).map(|force| force * contact.share);
        let load = contact.normal_force * contact.share * factor;
        for ((sum, column), normal) in sums.iter_mut().zip(contact.columns()).zip(contact.normal) {
            *sum = *sum - dot(&column, &force) - load * normal;
        }
        normal_force += load;
        // of unlike materials, pressure moves the surfaces as well
        dissipation += if contact.patch.mismatch == zero {
            dot(&force, &[motion.slip_x, motion.slip_y, motion.spin_rate])
        } else {
            carried.power * rolling.speed * contact.share
        };
        warning = warning.worse(carried.warning);
    }
    if !(are_finite(&sums) && are_finite(&[normal_force, dissipation])) {
        return Err(Error::Overflow);
    }
    if let Some(sums) = derivatives {
        let rows = sums.velocity.iter().flatten().chain(&sums.friction);
        Error::Overflow.unless(rows.into_iter().all(|entry| entry.is_finite_number()))?;
    }
    let ([a, b, c, d, e, f], contacts) = (sums, contacts.len() as u32);
    let (force, moment) = ([a, b, c], [d, e, f]);
    Ok(Wrench { force, moment, dissipation, normal_force, contacts, warning })
}

impl<F: Float> WrenchDerivatives<F> {
    /// Adds `−Bᵀ (∂F/∂slip B + ∂F/∂V ∂V/∂v + d ∂F/∂m n) − d N n n` and `−Bᵀ ∂F/∂friction` of a
    /// contact whose pressure has the factor `m`.
    fn add(&mut self, contact: &WheelContact<F>, slopes: &MotionDerivatives<F>, factor: F) {
        let (columns, damping) = (contact.columns(), contact.normal_damping);
        let mut by_velocity = columns;
        for (by, speed) in by_velocity.iter_mut().zip(contact.rolling_speed) {
            let [x, y, z] = slopes.slip.map(|row| dot(&row, by));
            let [a, b, c] = slopes.rolling_speed.map(|slope| slope * speed);
            *by = [x + a, y + b, z + c];
        }
        if damping > F::zero() {
            for (by, normal) in by_velocity.iter_mut().zip(contact.normal) {
                for (by, slope) in by.iter_mut().zip(slopes.friction) {
                    *by += slope / factor * damping * normal;
                }
            }
            let load = damping * contact.share * contact.normal_force;
            for (row, normal) in self.velocity.iter_mut().zip(contact.normal) {
                for (sum, other) in row.iter_mut().zip(contact.normal) {
                    *sum -= load * normal * other;
                }
            }
        }
        for ((row, by_friction), column) in
            self.velocity.iter_mut().zip(&mut self.friction).zip(columns)
        {
            let column = column.map(|entry| entry * contact.share);
            *by_friction -= dot(&column, &slopes.friction);
            for (sum, by) in row.iter_mut().zip(&by_velocity) {
                *sum -= dot(&column, by);
            }
        }
    }
}

fn forces<F: Float>(found: &Solution<F>) -> [F; 3] {
    [found.fx, found.fy, found.mz]
}

/// A patch whose pressure has a factor.
#[derive(Clone, Copy)]
struct Pressed<'a, F> {
    patch: &'a StoredPatch<F>,
    factor: F,
}

impl<F: Float> Pressed<'_, F> {
    /// Creep forces on the rail.
    fn carried(self, rolling: &Rolling<F>, law: Law<F>) -> Result<Solution<F>, Error> {
        let falling = at_speed(law, rolling.speed);
        let ratio = rolling.speed_by_rolling;
        let [forward, backward] =
            self.each_end(rolling, ratio, |patch, creepage| match &falling {
                Some(falling) => {
                    Ok(patch::friction::solve(patch, creepage, falling, law.model)?.solution)
                }
                None => solver::solve(patch, creepage, law.model),
            })?;
        Ok(joined(rolling, forward, backward))
    }

    /// The same with their derivatives by motion. The derivative by friction is that by a factor of
    /// all coefficients.
    fn differentiated(
        self,
        rolling: &Rolling<F>,
        law: Law<F>,
    ) -> Result<(Solution<F>, MotionDerivatives<F>), Error> {
        let falling = at_speed(law, rolling.speed);
        let differentiate = |patch: &PatchView<F>, creepage: &Creepage<F>| {
            let mut found =
                patch::friction::differentiate(patch, creepage, falling.as_ref(), law.model)?;
            let (load, bound) = (patch.normal_force(), patch.friction_bound());
            let mean = if load > F::zero() { bound / load } else { F::zero() };
            found.derivatives.friction = found.derivatives.friction.map(|slope| slope * mean);
            Ok(found)
        };
        let ends = |ratio: F| self.each_end(rolling, ratio, differentiate);
        let [forward, backward] = ends(rolling.speed_by_rolling)?;
        let by_mismatch = rolling.through_mismatch(self.patch.mismatch, ends)?;
        let slopes = rolling.slopes(&forward, &backward, by_mismatch);
        if !slopes.entries().all(F::is_finite_number) {
            return Err(Error::Overflow);
        }
        Ok((joined(rolling, forward.solution, backward.solution), slopes))
    }

    /// The results of a patch that rolls forward, and of one that is turned by 180 degrees. The
    /// ends have the mismatch `±κ V/V_f`, of this ratio.
    fn each_end<S: Copy>(
        self,
        rolling: &Rolling<F>,
        ratio: F,
        solve: impl Fn(&PatchView<F>, &Creepage<F>) -> Result<S, Error>,
    ) -> Result<[S; 2], Error> {
        let Self { patch, factor } = self;
        rolling.each_end(|creepage, is_turned| {
            let solve = |view: &PatchView<F>| {
                if patch.mismatch == F::zero() {
                    return solve(view, creepage);
                }
                let ratio = if is_turned { -ratio } else { ratio };
                solve(&view.with_mismatch(patch.mismatch * ratio)?, creepage)
            };
            if is_turned || factor != F::one() {
                self.copied(is_turned, solve)
            } else {
                solve(&patch.view()?)
            }
        })
    }

    /// The answer of a patch that is turned, or whose friction follows the pressure. Out of line,
    /// because of the copy on the stack (3 KiB).
    #[inline(never)]
    fn copied<S>(
        self,
        is_turned: bool,
        solve: impl FnOnce(&PatchView<F>) -> Result<S, Error>,
    ) -> Result<S, Error> {
        let mut copy = *self.patch;
        let count = copy.count as usize;
        let used = copy.strips.get_mut(..count).unwrap_or(&mut []);
        for strip in used.iter_mut() {
            strip.friction = strip.friction * self.factor;
        }
        if is_turned {
            reverse(used);
            for strip in used {
                (strip.y, strip.centre_x) = (-strip.y, -strip.centre_x);
            }
        }
        solve(&copy.view()?)
    }
}

fn at_speed<F: Float>(law: Law<F>, speed: F) -> Option<SlipFriction<F>> {
    law.falling.map(|law| SlipFriction { friction: F::one(), rolling_speed: speed, ..*law })
}

fn joined<F: Float>(rolling: &Rolling<F>, ahead: Solution<F>, behind: Solution<F>) -> Solution<F> {
    let [fx, fy, mz] = rolling.both(forces(&ahead), forces(&behind));
    let warning = ahead.warning.worse(behind.warning);
    let power = rolling.mean(ahead.power, behind.power);
    Solution { fx, fy, mz, power, warning, ..ahead }
}
