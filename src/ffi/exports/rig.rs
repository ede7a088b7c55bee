//! Test rigs: friction from a measured force, creepage from a requested one.

use super::F;
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::ffi::constants::{KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY};
use crate::ffi::support::{for_forces, given, write_warned};
use crate::ffi::types::kstrip_options;
use crate::friction::SlipFriction;
use crate::rig::{self, FrictionEstimate, Measured};
use crate::status::{Error, kstrip_status};
use core::mem::MaybeUninit;

/// Both force components were measured.
const BOTH: u32 = KSTRIP_MEASURED_FX | KSTRIP_MEASURED_FY;

/// The coefficient of friction that explains a measured force at a known creepage.
///
/// The contact adheres if less than a twentieth of the friction is used, or if the force is larger
/// than in linear theory. Then the status is KSTRIP_WARNING_FRICTION_AT_LEAST, and the result is
/// the used friction |force|/load, a lower bound. If spin opposes the creepage, more than one
/// friction may explain the force: the status is KSTRIP_WARNING_SEVERAL_FRICTIONS, and the result
/// is the smallest. KSTRIP_MODEL_TOTAL suits best. The force of KSTRIP_MODEL_STRIP_1967 jumps when
/// a first strip begins to adhere. A jump across the measured force is one of several solutions
/// there, and is returned only with KSTRIP_WARNING_NOT_CONVERGED. With the models of 1967 an
/// estimate may miss a friction, most often if the force is nearly zero.
///
/// Under a law the result is its friction, without slip: a force that was computed with the law
/// has the law's coefficient. If the actual law is another one, each creepage has another
/// friction; kstrip_fit_friction() finds the law.
///
/// @param contact         ellipse, load, material; its friction is ignored.
/// @param creepage        motion.
/// @param friction        law of friction, whose own coefficient is ignored; NULL: clean bodies,
///                        constant friction.
/// @param options         model and strip count; NULL for the defaults. Not KSTRIP_MODEL_LINEAR.
/// @param measured        KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY, or both added, for the
///                        magnitude of the force.
/// @param fx, fy          measured forces on the lower body [N]; others are ignored.
/// @param[out] estimate   receives friction, its sensitivity, and how far the force is off.
/// @return as kstrip_solve(); statuses of kstrip_friction; KSTRIP_WARNING_FRICTION_AT_LEAST,
///         KSTRIP_WARNING_SEVERAL_FRICTIONS and KSTRIP_WARNING_NOT_CONVERGED (see above);
///         KSTRIP_ERROR_NOT_IN_MODEL (KSTRIP_MODEL_LINEAR); KSTRIP_ERROR_MEASURED (measured is
///         another number); KSTRIP_ERROR_UNEXPLAINED (no friction gives the force, or the contact
///         is lost).
#[unsafe(export_name = symbol!("kstrip_estimate_friction"))]
pub extern "C" fn kstrip_estimate_friction(
    contact: Option<&Contact<F>>, creepage: Option<&Creepage<F>>,
    friction: Option<&SlipFriction<F>>, options: Option<&kstrip_options>, measured: u32, fx: F,
    fy: F, estimate: Option<&mut MaybeUninit<FrictionEstimate<F>>>,
) -> kstrip_status {
    write_warned(estimate, || {
        let (contact, creepage) = (given(contact)?, given(creepage)?);
        let options = for_forces(options)?;
        // What was not measured may be anything.
        let (measured, force) = match measured {
            KSTRIP_MEASURED_FX => (Measured::Fx, [fx, 0.0]),
            KSTRIP_MEASURED_FY => (Measured::Fy, [0.0, fy]),
            BOTH => (Measured::Both, [fx, fy]),
            _ => return Err(Error::Measured),
        };
        let found = rig::estimate_friction(contact, creepage, friction, &options, measured, force)?;
        Ok((found, found.warning))
    })
}

/// The creepage at which a contact with a given spin carries a requested force.
///
/// If no creepage has the force to rounding, such as a force within a jump of STRIP_1967, the
/// result is the nearest, with KSTRIP_WARNING_NOT_CONVERGED. If spin keeps the force from growing
/// with the creepage, more than one creepage may have it; the result is one of them. A force within
/// 0.1 % of friction times load is that of full sliding. The status is then
/// KSTRIP_WARNING_CREEPAGE_AT_LEAST, and every larger creepage has the force as well. A lost
/// contact carries no force.
///
/// @param contact         ellipse, load, material, friction.
/// @param fx, fy          requested force on the lower body [N].
/// @param spin            given spin [1/m].
/// @param friction        law of friction; NULL: clean bodies, the contact's own friction. A force
///                        that falling friction does not reach is KSTRIP_WARNING_NOT_CONVERGED.
/// @param options         model and strip count; NULL for the defaults.
/// @param[out] creepage   receives the creepages, and the given spin.
/// @return as kstrip_solve(); statuses of kstrip_friction; KSTRIP_WARNING_CREEPAGE_AT_LEAST and
///         KSTRIP_WARNING_NOT_CONVERGED (see above); KSTRIP_WARNING_SEVERAL_FRICTIONS, as in
///         kstrip_evaluate(); KSTRIP_ERROR_FORCE_BEYOND_FRICTION (the force exceeds mu N).
#[unsafe(export_name = symbol!("kstrip_creepage_for_force"))]
pub extern "C" fn kstrip_creepage_for_force(
    contact: Option<&Contact<F>>, fx: F, fy: F, spin: F, friction: Option<&SlipFriction<F>>,
    options: Option<&kstrip_options>, creepage: Option<&mut MaybeUninit<Creepage<F>>>,
) -> kstrip_status {
    write_warned(creepage, || {
        rig::creepage_for_force(given(contact)?, [fx, fy], spin, friction, &for_forces(options)?)
    })
}
