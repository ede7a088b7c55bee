//! From contacts and velocities to force and moment on the wheel.
//!
//! The wheel may roll forward or backward, or stand still, as in [`motion`](crate::motion). Backward rolling is forward rolling in
//! a mirror across `x`: with `X = diag(−1, 1, −1)` and the strips' centres on the other side, `F₋(c) = X F₊(X c)`.
//!
//! ```text
//! W = −Bᵀ F − N n,   ∂W/∂v = −Bᵀ (∂F/∂slip B + ∂F/∂V ∂V/∂v)
//! ```

use super::contacts::WheelContact;
use super::{Velocity, dot};
use crate::contact::creepage::Creepage;
use crate::friction::SlipFriction;
use crate::friction::derivatives::{Differentiated, LawDerivatives};
use crate::motion::{MotionDerivatives, Rolling};
use crate::number::Float;
use crate::patch::{self, PatchView, StoredPatch, solver};
use crate::solve::derivatives::Derivatives;
use crate::solve::model::{Model, Precision, Solution};
use crate::status::{Error, Notice};

/// Speed below which any slip is plausible \[m/s\].
const JUDGED: f64 = 1.0;

/// Force and moment on a wheel. They are conjugate to the members of kstrip_wheel_velocity: the products add up to power.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrench<F> {
    /// Force on the wheel, axes of the track \[N\]: forward, lateral, vertical (down; the rail's support is negative).
    pub force: [F; 3],
    /// Moment on the wheel about its centre \[N m\] about the wheelset's own axes: roll, pitch (about the axle), yaw.
    pub moment: [F; 3],
    /// Frictional power \[W\], not negative: creep forces on the rail times slip. The power of the creep forces on the wheel is minus this.
    pub dissipation: F,
    /// Sum of the loads of all contacts \[N\], each along its own normal.
    pub normal_force: F,
    /// Number of contacts; 0: the wheel is lifted, and nothing acts.
    pub contacts: u32,
    /// The status of this result: 0 or one of the KSTRIP_WARNING constants.
    pub notice: Notice,
}

/// Exact derivatives of the wrench. The rows are the members of force and moment.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WrenchDerivatives<F> {
    /// By the members of kstrip_wheel_velocity \[N, N m over m/s, rad/s\].
    pub velocity: [[F; 6]; 6],
    /// By a factor on all coefficients of friction, at 1 \[N, N m\].
    pub friction: [F; 6],
}

/// Derivatives of the wrench by the wheel's position at constant velocity: central differences of complete computations.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WrenchByPosition<F> {
    /// By the lateral position \[N, N m over m\].
    pub lateral: [F; 6],
    /// By the vertical position \[N, N m over m\].
    pub vertical: [F; 6],
    /// By yaw \[N, N m over rad\].
    pub yaw: [F; 6],
    /// By roll \[N, N m over rad\].
    pub roll: [F; 6],
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
/// [`Error::NotFinite`]; those of [`solver::solve`], [`patch::friction::solve`] and [`StoredPatch::view`].
pub fn of_contacts<F: Precision>(
    contacts: &[WheelContact<F>],
    velocity: &Velocity<F>,
    law: Law<F>,
    mut derivatives: Option<&mut WrenchDerivatives<F>>,
) -> Result<Wrench<F>, Error> {
    let velocity = velocity.members();
    if !velocity.iter().all(|x| x.is_finite_number()) {
        return Err(Error::NotFinite);
    }
    let mut sums = [F::zero(); 6];
    let mut wrench = Wrench::nothing();
    wrench.contacts = contacts.len() as u32;
    if let Some(derivatives) = &mut derivatives {
        **derivatives = WrenchDerivatives::nothing();
    }
    for contact in contacts {
        let numbers = contact.normal.iter().chain([&contact.share, &contact.normal_force]);
        if !numbers.into_iter().all(|x| x.is_finite_number()) {
            return Err(Error::NotFinite);
        }
        let motion = contact.motion(&velocity);
        let rolling = Rolling::new(&motion)?;
        let carried = match &mut derivatives {
            None => carried(&contact.patch, &rolling, law)?,
            Some(sum) => {
                let (found, slopes, friction) = differentiated(&contact.patch, &rolling, law)?;
                sum.add(contact, &slopes, friction);
                found
            }
        };
        let force = [carried.fx, carried.fy, carried.mz].map(|force| force * contact.share);
        let load = contact.normal_force * contact.share;
        for (k, sum) in sums.iter_mut().enumerate() {
            let column = contact.rows().map(|row| entry(&row, k));
            *sum = *sum - dot(&column, &force) - load * entry(&contact.normal, k);
        }
        wrench.normal_force += load;
        wrench.dissipation += dot(&force, &[motion.slip_x, motion.slip_y, motion.spin_rate]);
        wrench.notice = wrench.notice.worse(carried.notice);
        if contact.is_conformal() {
            wrench.notice = wrench.notice.worse(Notice::AngleRange);
        }
    }
    let [a, b, c, d, e, f] = sums;
    (wrench.force, wrench.moment) = ([a, b, c], [d, e, f]);
    let [power, load] = [wrench.dissipation, wrench.normal_force];
    let finite = sums.iter().chain([&power, &load]).all(|x| x.is_finite_number());
    if finite { Ok(wrench) } else { Err(Error::Overflow) }
}

fn entry<F: Float>(row: &[F; 6], k: usize) -> F {
    row.get(k).copied().unwrap_or(F::zero())
}

impl<F: Float> WrenchByPosition<F> {
    pub(crate) fn nothing() -> Self {
        let none = [F::zero(); 6];
        Self { lateral: none, vertical: none, yaw: none, roll: none }
    }
}

impl<F: Float> Wrench<F> {
    pub(crate) fn nothing() -> Self {
        let zero = F::zero();
        Self {
            force: [zero; 3],
            moment: [zero; 3],
            dissipation: zero,
            normal_force: zero,
            contacts: 0,
            notice: Notice::None,
        }
    }
}

impl<F: Precision> WrenchDerivatives<F> {
    pub(crate) fn nothing() -> Self {
        Self { velocity: [[F::zero(); 6]; 6], friction: [F::zero(); 6] }
    }

    /// Adds `−Bᵀ (∂F/∂slip B + ∂F/∂V ∂V/∂v)` and `−Bᵀ ∂F/∂friction` of a contact.
    fn add(&mut self, contact: &WheelContact<F>, slopes: &MotionDerivatives<F>, friction: [F; 3]) {
        let rows = slopes.slip.iter().zip(slopes.rolling_speed);
        let mut by_velocity = [[F::zero(); 6]; 3];
        for (by, (slope, by_speed)) in by_velocity.iter_mut().zip(rows) {
            for (k, by) in by.iter_mut().enumerate() {
                let column = contact.rows().map(|row| entry(&row, k));
                *by = dot(slope, &column) + by_speed * entry(&contact.rolling_speed, k);
            }
        }
        let members = self.velocity.iter_mut().zip(&mut self.friction).enumerate();
        for (k, (row, by_friction)) in members {
            let column = contact.rows().map(|row| entry(&row, k) * contact.share);
            *by_friction -= dot(&column, &friction);
            for (j, place) in row.iter_mut().enumerate() {
                *place -= dot(&column, &by_velocity.map(|by| entry(&by, j)));
            }
        }
    }
}

/// `X F` of forces that were computed in the mirror, in the turned axes that [`Rolling::each`] expects.
fn mirrored<F: Precision>(found: Solution<F>) -> Solution<F> {
    Solution { fy: -found.fy, mz: -found.mz, ..found }
}

fn in_mirror<F: Precision>(creepage: &Creepage<F>) -> Creepage<F> {
    Creepage { lateral: -creepage.lateral, spin: -creepage.spin, ..*creepage }
}

fn at_speed<F: Precision>(law: Law<F>, speed: F) -> Option<SlipFriction<F>> {
    law.falling.map(|law| SlipFriction { friction: F::one(), rolling_speed: speed, ..*law })
}

/// Creep forces on the rail.
fn carried<F: Precision>(
    patch: &StoredPatch<F>,
    rolling: &Rolling<F>,
    law: Law<F>,
) -> Result<Solution<F>, Error> {
    let falling = at_speed(law, rolling.speed);
    let solve = |view: &PatchView<F>, creepage: &Creepage<F>| match &falling {
        Some(falling) => Ok(patch::friction::solve(view, creepage, falling, law.model)?.solution),
        None => solver::solve(view, creepage, law.model),
    };
    let [forward, backward] = rolling.each_end(|creepage, backward| {
        if backward {
            through_mirror(patch, |view| solve(view, &in_mirror(creepage)).map(mirrored))
        } else {
            solve(&patch.view()?, creepage)
        }
    })?;
    Ok(joined(rolling, forward, backward))
}

fn joined<F: Precision>(
    rolling: &Rolling<F>,
    ahead: Solution<F>,
    behind: Solution<F>,
) -> Solution<F> {
    let forces = |found: Solution<F>| [found.fx, found.fy, found.mz];
    let [fx, fy, mz] = rolling.both(forces(ahead), forces(behind));
    let notice = ahead.notice.worse(behind.notice);
    let slow = rolling.speed < F::of(JUDGED) && notice.is_implausible();
    Solution { fx, fy, mz, notice: if slow { Notice::None } else { notice }, ..ahead }
}

/// The patch in a mirror across `x`, with the strips' centres on the other side. Out of line, because of the copy on the stack (3 KiB).
#[inline(never)]
fn through_mirror<F: Precision, S>(
    patch: &StoredPatch<F>,
    solve: impl FnOnce(&PatchView<F>) -> Result<S, Error>,
) -> Result<S, Error> {
    let strips = patch.strips.get(..patch.count as usize).unwrap_or(&[]);
    if strips.iter().all(|strip| strip.centre_x == F::zero()) {
        return solve(&patch.view()?);
    }
    let mut mirrored = *patch;
    for strip in &mut mirrored.strips {
        strip.centre_x = -strip.centre_x;
    }
    solve(&mirrored.view()?)
}

/// Creep forces on the rail, their derivatives by motion, and by a factor of all friction.
type Sloped<F> = (Solution<F>, MotionDerivatives<F>, [F; 3]);

/// Forces of a patch in motion, with their derivatives.
fn differentiated<F: Precision>(
    patch: &StoredPatch<F>,
    rolling: &Rolling<F>,
    law: Law<F>,
) -> Result<Sloped<F>, Error> {
    let falling = at_speed(law, rolling.speed);
    let solve = |view: &PatchView<F>, creepage: &Creepage<F>| {
        patch::friction::differentiate(view, creepage, falling.as_ref(), law.model)
    };
    let view = patch.view()?;
    let [forward, backward] = rolling.each_end(|creepage, backward| {
        if backward {
            through_mirror(patch, |view| solve(view, &in_mirror(creepage)).map(mirrored_slopes))
        } else {
            solve(&view, creepage)
        }
    })?;
    let slopes = rolling.slopes(&forward, &backward, [F::zero(); 3]);
    if !slopes.entries().all(F::is_finite_number) {
        return Err(Error::Overflow);
    }
    let (load, bound) = (view.normal_force(), view.friction_bound());
    let mean = if load > F::zero() { bound / load } else { F::zero() };
    let friction = slopes.friction.map(|slope| slope * mean);
    Ok((joined(rolling, forward.solution, backward.solution), slopes, friction))
}

/// The same in the turned axes. The entries of a row that are lateral or spin, but not both, change their signs.
fn mirrored_slopes<F: Precision>(found: Differentiated<F>) -> Differentiated<F> {
    let three = |[x, y, z]: [F; 3]| [x, -y, -z];
    let [x, y, z] = found.derivatives.jacobian.map(three);
    let Derivatives { normal_force, load_through_hertz, friction, .. } = found.derivatives;
    let LawDerivatives { ratio, decay, rolling_speed, slope_factor } = found.law;
    Differentiated {
        solution: mirrored(found.solution),
        derivatives: Derivatives {
            jacobian: [x, y.map(|slope| -slope), z.map(|slope| -slope)],
            normal_force: three(normal_force),
            load_through_hertz: three(load_through_hertz),
            friction: three(friction),
        },
        law: LawDerivatives {
            ratio: three(ratio),
            decay: three(decay),
            rolling_speed: three(rolling_speed),
            slope_factor: three(slope_factor),
        },
        ..found
    }
}
