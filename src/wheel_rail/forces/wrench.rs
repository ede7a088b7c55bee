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
//! pressure the friction bound of every strip. The contact area stays that of the
//! pressure without damping.

use super::curved::{self, Creep};
pub use super::ends::Law;
use super::ends::{Pressed, at_speed};
use crate::contact::creepage::Creepage;
use crate::forces::{Model, Solution};
use crate::motion::{MotionDerivatives, Rolling};
use crate::number::{Float, add, are_finite};
use crate::patch::{self, Patch, PatchView, solver};
use crate::status::{Error, Warning};
use crate::wheel_rail::contacts::WheelContact;
use crate::wheel_rail::{Velocity, dot};

/// Factor of the damping above which it is implausible.
const LARGEST_DAMPING: f64 = 2.0;

/// Force and moment on a wheel. They are conjugate to the members of kstrip_wheel_velocity: the
/// products add up to power.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench<F> {
    /// Force on the wheel, axes of the track \[N\]: forward, lateral, vertical (down; the rail's
    /// support is negative).
    pub force: [F; 3],
    /// Moment on the wheel about its centre \[N m\] about the wheelset's own axes: roll, pitch
    /// (about the axle), yaw.
    pub moment: [F; 3],
    /// Frictional power \[W\], not negative: creep forces on the rail times slip. The power of the
    /// creep forces on the wheel is minus this. Only in contacts with a mismatch of the materials
    /// it differs, because pressure adds to the slip.
    pub dissipation: F,
    /// Sum of the loads of all contacts \[N\], each along its own normal: share times normal_force
    /// of kstrip_wheel_contact, times the factor of the damping.
    pub normal_force: F,
    /// Number of contacts, those that kstrip_wheel_workspace lists; of a wheelset those of both
    /// wheels. 0: the wheel is lifted, and nothing acts.
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

/// Derivatives of the wrench with respect to the wheel's position at constant velocity.
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
    pub(crate) fn columns(&mut self) -> [&mut [F; 6]; 4] {
        let Self { lateral, vertical, yaw, roll } = self;
        [lateral, vertical, yaw, roll]
    }
}

impl<F: Float> Wrench<F> {
    /// Whether all numbers fit the floating-point type, those of the derivatives as well.
    ///
    /// # Errors
    /// [`Error::Overflow`]
    pub(crate) fn check(&self, derivatives: Option<&WrenchDerivatives<F>>) -> Result<(), Error> {
        let sums = [self.normal_force, self.dissipation];
        Error::Overflow.unless(are_finite(&self.members()) && are_finite(&sums))?;
        let Some(slopes) = derivatives else { return Ok(()) };
        let mut rows = slopes.velocity.iter().flatten().chain(&slopes.friction);
        Error::Overflow.unless(rows.all(|entry| entry.is_finite_number()))
    }

    /// Adds the wrench of other contacts.
    pub(crate) fn add(&mut self, other: &Self) {
        add(&mut self.force, other.force);
        add(&mut self.moment, other.moment);
        self.dissipation += other.dissipation;
        self.normal_force += other.normal_force;
        self.contacts += other.contacts;
        self.warning = self.warning.worse(other.warning);
    }

    /// The wrench's six members.
    #[must_use]
    pub fn members(&self) -> [F; 6] {
        let ([a, b, c], [d, e, f]) = (self.force, self.moment);
        [a, b, c, d, e, f]
    }
}

/// Computes the wrench of contacts, and, on request, its derivatives.
///
/// # Errors
/// [`Error::NotFinite`]; those of [`solver::solve_patch`],
/// [`patch::friction::solve_patch_with_law`] and [`Patch::view`](patch::Patch::view).
pub fn of_contacts<F: Float>(
    contacts: &[WheelContact<F>], velocity: &Velocity<F>, law: Law<F>,
    derivatives: Option<&mut WrenchDerivatives<F>>,
) -> Result<Wrench<F>, Error> {
    let mut room = Patch::nothing();
    of_contacts_in(&mut room, contacts, velocity, law, derivatives)
}

/// The same with memory for a patch.
pub(crate) fn of_contacts_in<F: Float>(
    room: &mut Patch<F>, contacts: &[WheelContact<F>], velocity: &Velocity<F>, law: Law<F>,
    derivatives: Option<&mut WrenchDerivatives<F>>,
) -> Result<Wrench<F>, Error> {
    match derivatives {
        None => sum_of_contacts::<F, false>(room, contacts, velocity, law, None),
        derivatives => sum_of_contacts::<F, true>(room, contacts, velocity, law, derivatives),
    }
}

/// The same; without `SLOPES` no derivatives, which takes less than half of the stack.
#[inline(never)]
pub(crate) fn sum_of_contacts<F: Float, const SLOPES: bool>(
    room: &mut Patch<F>, contacts: &[WheelContact<F>], velocity: &Velocity<F>, law: Law<F>,
    derivatives: Option<&mut WrenchDerivatives<F>>,
) -> Result<Wrench<F>, Error> {
    let mut derivatives = derivatives.filter(|_| SLOPES);
    let (velocity, zero) = (velocity.members(), F::zero());
    Error::NotFinite.unless(are_finite(&velocity))?;
    if let Some(sums) = &mut derivatives {
        **sums = WrenchDerivatives::default();
    }
    let (mut sums, mut normal_force, mut dissipation) = ([zero; 6], zero, zero);
    let mut warning = Warning::None;
    for contact in contacts {
        contact.check()?;
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
        if factor > F::of(LARGEST_DAMPING) {
            warning = warning.worse(Warning::Damping);
        }
        let mut pressed = Pressed { patch: &contact.patch, factor, room: &mut *room };
        // creep forces on the rail, conjugate to the wheel's velocities, and frictional power
        let (creep, power, told) = if law.model != Model::Total {
            let found = curved::creep::<F, SLOPES>(contact, pressed, &velocity, &rolling, law)?;
            if let Some(sums) = &mut derivatives {
                sums.add_creep(contact, &found, factor);
            }
            let wrench = found.wrench.map(|force| force * contact.share);
            (wrench, found.power * rolling.speed * contact.share, found.warning)
        } else {
            let carried = match &mut derivatives {
                None => pressed.carried(&rolling, law)?,
                Some(sums) => {
                    let (found, slopes) = pressed.differentiated(&rolling, law)?;
                    sums.add(contact, &slopes, factor);
                    found
                }
            };
            let force = carried.components().map(|force| force * contact.share);
            // of dissimilar materials, pressure moves the surfaces as well
            let dissipation = if contact.patch.mismatch == zero {
                dot(&force, &[motion.slip_x, motion.slip_y, motion.spin_rate])
            } else {
                carried.power * rolling.speed * contact.share
            };
            let wrench = contact.columns().map(|column| dot(&column, &force));
            (wrench, dissipation, carried.warning)
        };
        let load = contact.normal_force * contact.share * factor;
        for ((sum, creep), normal) in sums.iter_mut().zip(creep).zip(contact.normal) {
            *sum = *sum - creep - load * normal;
        }
        normal_force += load;
        dissipation += power;
        warning = warning.worse(told);
    }
    let ([a, b, c, d, e, f], contacts) = (sums, contacts.len() as u32);
    let (force, moment) = ([a, b, c], [d, e, f]);
    let wrench = Wrench { force, moment, dissipation, normal_force, contacts, warning };
    wrench.check(derivatives.as_deref()).map(|()| wrench)
}

impl<F: Float> WrenchDerivatives<F> {
    /// Adds the derivatives of other contacts.
    pub(crate) fn add_other(&mut self, other: &Self) {
        self.velocity.iter_mut().zip(other.velocity).for_each(|(row, other)| add(row, other));
        add(&mut self.friction, other.friction);
    }

    /// Adds the derivatives of creep forces on the rail.
    fn add_creep(&mut self, contact: &WheelContact<F>, creep: &Creep<F>, factor: F) {
        let (share, damping) = (contact.share, contact.normal_damping);
        let rows = self.velocity.iter_mut().zip(&mut self.friction);
        for (((row, by_friction), creep), by) in rows.zip(creep.by_velocity).zip(creep.by_friction)
        {
            *by_friction -= share * by;
            for ((sum, creep), normal) in row.iter_mut().zip(creep).zip(contact.normal) {
                *sum -= share * (creep + by / factor * damping * normal);
            }
        }
        if damping > F::zero() {
            self.add_damping(contact);
        }
    }

    /// Adds `−d N n n`.
    fn add_damping(&mut self, contact: &WheelContact<F>) {
        let load = contact.normal_damping * contact.share * contact.normal_force;
        for (row, normal) in self.velocity.iter_mut().zip(contact.normal) {
            add(row, contact.normal.map(|other| -(load * normal * other)));
        }
    }

    /// Adds what [the module](self) says, and `−Bᵀ ∂F/∂friction`; the pressure has the factor `m`.
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
                add(by, slopes.friction.map(|slope| slope / factor * damping * normal));
            }
            self.add_damping(contact);
        }
        for ((row, by_friction), column) in
            self.velocity.iter_mut().zip(&mut self.friction).zip(columns)
        {
            let column = column.map(|entry| entry * contact.share);
            *by_friction -= dot(&column, &slopes.friction);
            add(row, by_velocity.map(|by| -dot(&column, &by)));
        }
    }
}

impl<F: Float> Pressed<'_, F> {
    /// Creep forces on the rail.
    fn carried(&mut self, rolling: &Rolling<F>, law: Law<F>) -> Result<Solution<F>, Error> {
        let falling = at_speed(law, rolling.speed);
        let ratio = rolling.speed_by_rolling;
        let [forward, backward] =
            self.each_end(rolling, ratio, |patch, creepage, _| match &falling {
                Some(falling) => {
                    Ok(patch::friction::solve_patch_with_law(patch, creepage, falling, law.model)?
                        .solution)
                }
                None => solver::solve_patch(patch, creepage, law.model),
            })?;
        Ok(joined_solutions(rolling, forward, backward))
    }

    /// The same with their derivatives with respect to motion. The derivative with respect to
    /// friction is that with respect to a factor of all coefficients.
    fn differentiated(
        &mut self, rolling: &Rolling<F>, law: Law<F>,
    ) -> Result<(Solution<F>, MotionDerivatives<F>), Error> {
        let falling = at_speed(law, rolling.speed);
        let differentiate = |patch: &PatchView<F>, creepage: &Creepage<F>, _: bool| {
            let mut found =
                patch::friction::differentiate_patch(patch, creepage, falling.as_ref(), law.model)?;
            let (load, bound) = (patch.normal_force(), patch.friction_bound());
            let mean = if load > F::zero() { bound / load } else { F::zero() };
            found.derivatives.friction = found.derivatives.friction.map(|slope| slope * mean);
            Ok(found)
        };
        let mismatch = self.patch.mismatch;
        let mut ends = |ratio: F| self.each_end(rolling, ratio, differentiate);
        let [forward, backward] = ends(rolling.speed_by_rolling)?;
        let by_mismatch = rolling.through_mismatch(mismatch, ends)?;
        let slopes = rolling.slopes(&forward, &backward, by_mismatch);
        Error::Overflow.unless(slopes.entries().all(F::is_finite_number))?;
        Ok((joined_solutions(rolling, forward.solution, backward.solution), slopes))
    }
}

fn joined_solutions<F: Float>(
    rolling: &Rolling<F>, ahead: Solution<F>, behind: Solution<F>,
) -> Solution<F> {
    let [fx, fy, mz] = rolling.both_ends(ahead.components(), behind.components());
    let warning = ahead.warning.worse(behind.warning);
    let power = rolling.mean(ahead.power, behind.power);
    Solution { fx, fy, mz, power, warning, ..ahead }
}
