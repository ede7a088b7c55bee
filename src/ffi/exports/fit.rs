//! Test rigs: a law of friction from a measured creep curve.

use super::F;
use crate::contact::Contact;
use crate::ffi::constants::KSTRIP_FIT_LAYER;
use crate::ffi::support::{for_forces, given, input, put, status_of};
use crate::ffi::types::kstrip_options;
use crate::friction::SlipFriction;
use crate::rig;
use crate::rig::fit::{FrictionFit, MeasuredForce};
use crate::status::{Error, kstrip_status};
use core::mem::MaybeUninit;

/// The law of friction that fits a measured creep curve best.
///
/// It minimises the sum of the squared differences between measured and computed forces, each times
/// the weight of its point. The search begins at start and at other places, unless the points are
/// met exactly. Members of the law that are not fitted keep the values of start. A fitted member
/// that is 0 in start begins at a usual value; falling friction needs the rolling speed in start.
/// Bounds are those of the law: a member that ends at its bound has a standard error of 0, and the
/// status is KSTRIP_WARNING_FIT_BOUND. If another law has a residual that is at most 1 per cent
/// larger, the status is KSTRIP_WARNING_SECOND_MINIMUM.
///
/// Points that lie on one part of the curve do not determine each parameter. The status is then
/// KSTRIP_WARNING_UNDETERMINED: a parameter would be uncertain by more than half of its value with
/// errors of the forces of one per cent, or with their actual errors if these are larger. Layer
/// and slope factor have nearly the same effect; fit one of them.
///
/// @param contact         ellipse, load, material of all points; its friction is ignored.
/// @param points, count   the measured points.
/// @param start           where to begin, and the members that stay.
/// @param parameters      which members to fit: KSTRIP_FIT constants, added.
/// @param options         model and strip count; NULL for the defaults.
/// @param[out] fit        receives the law and its standard errors.
/// @param[out] first_bad  receives the index of the first bad point, or count where none is bad;
///                        NULL: not requested.
/// @return usual statuses; errors of kstrip_contact, kstrip_friction (start), kstrip_measured_force
///         and kstrip_options; KSTRIP_WARNING_FIT_BOUND, KSTRIP_WARNING_SECOND_MINIMUM and
///         KSTRIP_WARNING_UNDETERMINED (see above); KSTRIP_WARNING_NOT_CONVERGED (the last step
///         still changed the law); KSTRIP_WARNING_PER_CENT (the slope factor is below 0.05);
///         KSTRIP_ERROR_FEW_POINTS (fewer forces than parameters); KSTRIP_ERROR_FIT_PARAMETERS
///         (parameters is 0 or no sum of the constants); KSTRIP_ERROR_UNEXPLAINED (the contact is
///         lost).
#[unsafe(export_name = symbol!("kstrip_fit_friction"))]
pub unsafe extern "C" fn kstrip_fit_friction(
    contact: Option<&Contact<F>>, points: *const MeasuredForce<F>, count: u32,
    start: Option<&SlipFriction<F>>, parameters: u32, options: Option<&kstrip_options>,
    fit: Option<&mut MaybeUninit<FrictionFit<F>>>, first_bad: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    // SAFETY: NULL or count elements, says the header.
    let points = unsafe { input(points, count) };
    status_of(|| {
        let (contact, start, fit) = (given(contact)?, given(start)?, given(fit)?);
        let (points, options) = (points?, for_forces(options)?);
        // The KSTRIP_FIT constants are the bits in the order of the parameters.
        let fitted = [0, 1, 2, 3, 4, 5].map(|bit| parameters & (1 << bit) != 0);
        let found = if parameters < 2 * KSTRIP_FIT_LAYER {
            rig::fit::fit_friction(contact, points, start, fitted, &options)
        } else {
            Err((points.len(), Error::FitParameters))
        };
        put(first_bad, found.as_ref().err().map_or(count, |(i, _)| *i as u32));
        let found = found.map_err(|(_, error)| error)?;
        fit.write(found);
        Ok(found.warning)
    })
}
