//! The inverse for C: friction from a measured force, creepage from a wanted one.

use super::calls::{Out, given, inputs};
use super::types::{kstrip_contact, kstrip_creepage, kstrip_options};
use super::types_f32::{kstrip_contact_f32, kstrip_creepage_f32};
use super::{KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY, answer, checked_options, kstrip_status};
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::rig::{self, FrictionEstimate, Measured};
use crate::solve::model::Precision;
use crate::status::Error;
use core::mem::MaybeUninit;

/// A coefficient of friction from a measured force.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_friction_estimate {
    /// Coefficient of friction [-]; a lower bound with KSTRIP_WARNING_FRICTION_AT_LEAST.
    pub friction: f64,
    /// d(friction)/d(force) [1/N]: what an error of the measured force does to it; 0 for a lower bound.
    pub sensitivity: f64,
    /// Distance between the measured and the computed force [N], of the components that were measured.
    pub residual: f64,
    /// The status of this result: 0 or one of the KSTRIP_WARNING constants.
    pub status_detail: i32,
    /// Zero.
    pub reserved: i32,
}

/// A coefficient of friction from a measured force, single precision.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_friction_estimate_f32 {
    /// Coefficient of friction [-]; a lower bound with KSTRIP_WARNING_FRICTION_AT_LEAST.
    pub friction: f32,
    /// d(friction)/d(force) [1/N]: what an error of the measured force does to it; 0 for a lower bound.
    pub sensitivity: f32,
    /// Distance between the measured and the computed force [N], of the components that were measured.
    pub residual: f32,
    /// The status of this result: 0 or one of the KSTRIP_WARNING constants.
    pub status_detail: i32,
    /// Zero.
    pub reserved: i32,
}

macro_rules! conversion {
    ($float:ident, $c:ident) => {
        impl From<FrictionEstimate<$float>> for $c {
            fn from(core: FrictionEstimate<$float>) -> Self {
                let FrictionEstimate { friction, sensitivity, residual, notice } = core;
                let status_detail = notice.code();
                Self { friction, sensitivity, residual, status_detail, reserved: 0 }
            }
        }
    };
}

conversion!(f64, kstrip_friction_estimate);
conversion!(f32, kstrip_friction_estimate_f32);

fn estimate_friction<F: Precision, C: Copy, K: Copy, E: From<FrictionEstimate<F>>>(
    contact: Option<&C>,
    creepage: Option<&K>,
    options: Option<&kstrip_options>,
    measured: u32,
    force: [F; 2],
    out: Out<E>,
) -> kstrip_status
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
{
    const BOTH: u32 = KSTRIP_MEASURED_FX | KSTRIP_MEASURED_FY;
    answer(|| {
        let (contact, creepage) = inputs(contact, creepage)?;
        let (options, out) = (checked_options(options)?, given(out)?);
        // What was not measured may be anything.
        let [fx, fy] = force;
        let (measured, force) = match measured {
            KSTRIP_MEASURED_FX => (Measured::Fx, [fx, F::zero()]),
            KSTRIP_MEASURED_FY => (Measured::Fy, [F::zero(), fy]),
            BOTH => (Measured::Both, force),
            _ => return Err(Error::Measured),
        };
        let found = rig::estimate_friction(&contact, &creepage, &options, measured, force)?;
        let notice = found.notice;
        out.write(found.into());
        Ok(notice)
    })
}

fn creepage_for_force<F: Precision, C: Copy, K: From<Creepage<F>>>(
    contact: Option<&C>,
    force: [F; 2],
    spin: F,
    options: Option<&kstrip_options>,
    out: Out<K>,
) -> kstrip_status
where
    Contact<F>: From<C>,
{
    answer(|| {
        let contact = Contact::from(*given(contact)?);
        let (options, out) = (checked_options(options)?, given(out)?);
        let (creepage, notice) = rig::creepage_for_force(&contact, force, spin, &options)?;
        out.write(creepage.into());
        Ok(notice)
    })
}

/// The coefficient of friction that explains a measured force at a known creepage.
///
/// Bounded iterations, about seventy solutions. The force grows with friction from full sliding, where it is
/// friction times load, to adhesion, where it does not depend on it: there (less than a twentieth of the
/// friction used, or more force than linear theory gives) the status is KSTRIP_WARNING_FRICTION_AT_LEAST and
/// the result is the used friction |force|/load, a lower bound. Where spin opposes the creepage more than one
/// friction may fit: KSTRIP_WARNING_SEVERAL_FRICTIONS, the result is the smallest. KSTRIP_MODEL_TOTAL suits best:
/// the force of KSTRIP_MODEL_STRIP has ripples over friction, up to 11 % of it where less than a third of friction is used,
/// 1 % up to one half, none above 0.7, within which several frictions fit: mostly said by that warning.
///
/// @param contact         ellipse, load, material; its friction is ignored.
/// @param creepage        motion.
/// @param options         model and strip count; NULL for the defaults. Not KSTRIP_MODEL_LINEAR.
/// @param measured        KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY, or both added: then the resultant counts.
/// @param fx, fy          measured forces on the lower body [N]; what was not measured is ignored.
/// @param[out] estimate   receives friction, its sensitivity, and how far the force is off.
/// @return as kstrip_solve(); KSTRIP_WARNING_FRICTION_AT_LEAST, KSTRIP_WARNING_SEVERAL_FRICTIONS,
///         KSTRIP_WARNING_NOT_CONVERGED;
///         KSTRIP_ERROR_NOT_IN_MODEL, KSTRIP_ERROR_MEASURED, KSTRIP_ERROR_UNEXPLAINED.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_estimate_friction(
    contact: Option<&kstrip_contact>,
    creepage: Option<&kstrip_creepage>,
    options: Option<&kstrip_options>,
    measured: u32,
    fx: f64,
    fy: f64,
    estimate: Option<&mut MaybeUninit<kstrip_friction_estimate>>,
) -> kstrip_status {
    estimate_friction(contact, creepage, options, measured, [fx, fy], estimate)
}

/// The creepage at which a contact with a given spin carries a wanted force.
///
/// Bounded iterations, about six solutions with derivatives. A force within 0.1 % of friction times load is that of
/// full sliding: the status is KSTRIP_WARNING_CREEPAGE_AT_LEAST, the result is the creepage that comes as near
/// as that, and larger ones do as well.
///
/// @param contact         ellipse, load, material, friction.
/// @param fx, fy          wanted force on the lower body [N].
/// @param spin            given spin [1/m].
/// @param options         model and strip count; NULL for the defaults.
/// @param[out] creepage   receives the creepages, and the given spin.
/// @return as kstrip_solve(); KSTRIP_WARNING_CREEPAGE_AT_LEAST, KSTRIP_WARNING_NOT_CONVERGED;
///         KSTRIP_ERROR_FORCE_BEYOND_FRICTION.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_creepage_for_force(
    contact: Option<&kstrip_contact>,
    fx: f64,
    fy: f64,
    spin: f64,
    options: Option<&kstrip_options>,
    creepage: Option<&mut MaybeUninit<kstrip_creepage>>,
) -> kstrip_status {
    creepage_for_force(contact, [fx, fy], spin, options, creepage)
}

/// kstrip_estimate_friction() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_estimate_friction_f32(
    contact: Option<&kstrip_contact_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    options: Option<&kstrip_options>,
    measured: u32,
    fx: f32,
    fy: f32,
    estimate: Option<&mut MaybeUninit<kstrip_friction_estimate_f32>>,
) -> kstrip_status {
    estimate_friction(contact, creepage, options, measured, [fx, fy], estimate)
}

/// kstrip_creepage_for_force() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_creepage_for_force_f32(
    contact: Option<&kstrip_contact_f32>,
    fx: f32,
    fy: f32,
    spin: f32,
    options: Option<&kstrip_options>,
    creepage: Option<&mut MaybeUninit<kstrip_creepage_f32>>,
) -> kstrip_status {
    creepage_for_force(contact, [fx, fy], spin, options, creepage)
}
