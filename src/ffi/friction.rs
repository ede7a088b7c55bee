//! Falling friction and reduced initial slope for C.

use super::calls::{Out, OutArray, given, inputs};
use super::types::{kstrip_contact, kstrip_creepage, kstrip_options, kstrip_result};
use super::types_f32::{kstrip_contact_f32, kstrip_creepage_f32, kstrip_result_f32};
use super::{answer, arrays, checked_options, kstrip_status};
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::friction::{self, SlipFriction};
use crate::solve::model::{Precision, Solution};
use core::mem::MaybeUninit;

/// Friction that falls with the slip, friction ((1 - ratio) exp(-decay w) + ratio) with the sliding
/// velocity w [m/s], and the stiffness of the layer between the bodies.
///
/// Polach, Wear 258 (2005) 992, gives for locomotives: dry friction 0.55, ratio 0.4, decay 0.6 s/m; wet 0.3,
/// 0.4, 0.2 s/m.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_friction {
    /// Coefficient of friction without slip [-], >= 0.
    pub friction: f64,
    /// Friction at infinite sliding velocity over that at none [-], 0 to 1; 1: friction is constant.
    pub ratio: f64,
    /// How fast friction falls [s/m], >= 0; 0: friction is constant.
    pub decay: f64,
    /// Rolling speed [m/s], >= 0: sliding velocity is slip times rolling speed.
    pub rolling_speed: f64,
    /// Initial slope of the creep curve over that of clean bodies [-], > 0 to 1; 1: clean.
    pub slope_factor: f64,
}

/// Friction that falls with the slip, and the stiffness of the layer, single precision.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_friction_f32 {
    /// Coefficient of friction without slip [-], >= 0.
    pub friction: f32,
    /// Friction at infinite sliding velocity over that at none [-], 0 to 1; 1: friction is constant.
    pub ratio: f32,
    /// How fast friction falls [s/m], >= 0; 0: friction is constant.
    pub decay: f32,
    /// Rolling speed [m/s], >= 0: sliding velocity is slip times rolling speed.
    pub rolling_speed: f32,
    /// Initial slope of the creep curve over that of clean bodies [-], > 0 to 1; 1: clean.
    pub slope_factor: f32,
}

macro_rules! conversion {
    ($float:ident, $c:ident) => {
        impl From<$c> for SlipFriction<$float> {
            fn from(c: $c) -> Self {
                let $c { friction, ratio, decay, rolling_speed, slope_factor } = c;
                Self { friction, ratio, decay, rolling_speed, slope_factor }
            }
        }
    };
}

conversion!(f64, kstrip_friction);
conversion!(f32, kstrip_friction_f32);

fn solve_friction<F: Precision, C: Copy, K: Copy, L: Copy, R: From<Solution<F>>>(
    contact: Option<&C>,
    creepage: Option<&K>,
    friction: Option<&L>,
    options: Option<&kstrip_options>,
    out: Out<R>,
    effective: Out<F>,
) -> kstrip_status
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
    SlipFriction<F>: From<L>,
{
    answer(|| {
        let (contact, creepage) = inputs(contact, creepage)?;
        let friction = SlipFriction::from(*given(friction)?);
        let (options, out) = (checked_options(options)?, given(out)?);
        let found = friction::solve(&contact, &creepage, &friction, &options)?;
        out.write(found.solution.into());
        if let Some(effective) = effective {
            effective.write(found.friction);
        }
        Ok(found.solution.notice)
    })
}

fn solve_friction_jacobian<F: Precision, C: Copy, K: Copy, L: Copy, R: From<Solution<F>>>(
    contact: Option<&C>,
    creepage: Option<&K>,
    friction: Option<&L>,
    options: Option<&kstrip_options>,
    out: Out<R>,
    entries: OutArray<F>,
    effective: Out<F>,
) -> kstrip_status
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
    SlipFriction<F>: From<L>,
{
    answer(|| {
        let (contact, creepage) = inputs(contact, creepage)?;
        let friction = SlipFriction::from(*given(friction)?);
        let (options, out, entries) = (checked_options(options)?, given(out)?, entries?);
        let (found, jacobian) = friction::solve_jacobian(&contact, &creepage, &friction, &options)?;
        out.write(found.solution.into());
        // nalgebra stores columns; C wants rows.
        for (entry, value) in entries.iter_mut().zip(jacobian.transpose().iter()) {
            entry.write(*value);
        }
        if let Some(effective) = effective {
            effective.write(found.friction);
        }
        Ok(found.solution.notice)
    })
}

fn contact_under_friction<F: Precision, C: Copy + From<Contact<F>>, K: Copy, L: Copy>(
    contact: Option<&C>,
    creepage: Option<&K>,
    friction: Option<&L>,
    options: Option<&kstrip_options>,
    out: Out<C>,
) -> kstrip_status
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
    SlipFriction<F>: From<L>,
{
    answer(|| {
        let (contact, creepage) = inputs(contact, creepage)?;
        let law = SlipFriction::from(*given(friction)?);
        let (options, out) = (checked_options(options)?, given(out)?);
        let (slipping, notice) = friction::under(&contact, &creepage, &law, &options)?;
        out.write(slipping.into());
        Ok(notice)
    })
}

/// Forces under friction that falls with the slip, solved consistently with the slip.
///
/// The slip is the mean over the contact, weighted with friction: power/(friction N), which is 0 where
/// everything sticks and the creepage in full sliding without spin. The coefficient of friction of the
/// contact is ignored. The slope factor stands for a layer that makes the contact softer: it multiplies the shear
/// modulus and stretches the creep curve without changing its shape. With constant friction
/// (ratio 1, decay 0 or rolling_speed 0) and slope_factor 1 the result is that of kstrip_solve(), bit for bit and
/// at its cost; otherwise some six solutions, 260 at most. For KSTRIP_MODEL_LINEAR only the slope factor
/// counts.
///
/// @param contact         ellipse, load, material; its friction is ignored.
/// @param creepage        motion.
/// @param friction        how friction falls.
/// @param options         model and strip count; NULL for the defaults.
/// @param[out] result     receives what kstrip_solve() gives.
/// @param[out] effective  receives the coefficient of friction [-] that agrees with the slip; may be NULL.
/// @return as kstrip_solve(); KSTRIP_WARNING_SEVERAL_FRICTIONS, KSTRIP_WARNING_NOT_CONVERGED for
///         friction that falls steeply; KSTRIP_ERROR_FRICTION_RATIO, KSTRIP_ERROR_FRICTION_DECAY,
///         KSTRIP_ERROR_NEGATIVE_SPEED, KSTRIP_ERROR_SLOPE_FACTOR.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_friction(
    contact: Option<&kstrip_contact>,
    creepage: Option<&kstrip_creepage>,
    friction: Option<&kstrip_friction>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result>>,
    effective: Option<&mut MaybeUninit<f64>>,
) -> kstrip_status {
    solve_friction(contact, creepage, friction, options, result, effective)
}

/// kstrip_solve_friction() with the exact derivatives with respect to the creepages.
///
/// @param[out] jacobian   receives d(fx, fy, mz)/d(longitudinal, lateral, spin), row by row, friction
///                        following the slip: nine numbers [N, N, N m over 1, 1, 1/m]. On the falling branch
///                        of a traction curve the entry on the diagonal is negative.
/// @return as kstrip_solve_friction(); KSTRIP_ERROR_OVERFLOW also when a derivative is too large.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_solve_friction_jacobian(
    contact: Option<&kstrip_contact>,
    creepage: Option<&kstrip_creepage>,
    friction: Option<&kstrip_friction>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result>>,
    jacobian: *mut f64,
    effective: Option<&mut MaybeUninit<f64>>,
) -> kstrip_status {
    // SAFETY: NULL or nine writable numbers, says the header.
    let jacobian = unsafe { arrays::output(jacobian, 9) };
    solve_friction_jacobian(contact, creepage, friction, options, result, jacobian, effective)
}

/// The contact as it is while it slips: friction that falls with the slip has become a constant coefficient of
/// friction, and the slope factor part of the shear modulus.
///
/// kstrip_evaluate(), kstrip_strips(), kstrip_traction_at(), kstrip_field() and kstrip_solve() of that contact at the same
/// creepage and with the same options are those under falling friction. (Derivatives are not: use
/// kstrip_solve_friction_jacobian(), where friction follows the slip.)
///
/// @param contact, creepage, friction, options  as kstrip_solve_friction().
/// @param[out] slipping   receives the contact; not the contact itself.
/// @return as kstrip_solve_friction().
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_contact_under_friction(
    contact: Option<&kstrip_contact>,
    creepage: Option<&kstrip_creepage>,
    friction: Option<&kstrip_friction>,
    options: Option<&kstrip_options>,
    slipping: Option<&mut MaybeUninit<kstrip_contact>>,
) -> kstrip_status {
    contact_under_friction(contact, creepage, friction, options, slipping)
}

/// kstrip_contact_under_friction() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_contact_under_friction_f32(
    contact: Option<&kstrip_contact_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    friction: Option<&kstrip_friction_f32>,
    options: Option<&kstrip_options>,
    slipping: Option<&mut MaybeUninit<kstrip_contact_f32>>,
) -> kstrip_status {
    contact_under_friction(contact, creepage, friction, options, slipping)
}

/// kstrip_solve_friction() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_friction_f32(
    contact: Option<&kstrip_contact_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    friction: Option<&kstrip_friction_f32>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result_f32>>,
    effective: Option<&mut MaybeUninit<f32>>,
) -> kstrip_status {
    solve_friction(contact, creepage, friction, options, result, effective)
}

/// kstrip_solve_friction_jacobian() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_solve_friction_jacobian_f32(
    contact: Option<&kstrip_contact_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    friction: Option<&kstrip_friction_f32>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result_f32>>,
    jacobian: *mut f32,
    effective: Option<&mut MaybeUninit<f32>>,
) -> kstrip_status {
    // SAFETY: NULL or nine writable numbers, says the header.
    let jacobian = unsafe { arrays::output(jacobian, 9) };
    solve_friction_jacobian(contact, creepage, friction, options, result, jacobian, effective)
}
