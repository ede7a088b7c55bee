//! Test rigs: friction from a measured force, creepage from a requested one.

use super::F;
use crate::ffi::rig::*;
use crate::ffi::support::*;

/// The coefficient of friction that explains a measured force at a known creepage.
///
/// The search needs at most 90 solutions with derivatives, and 35 to 45 on average. In full sliding
/// the force is friction times load. As friction grows the contact begins to adhere, and the force
/// depends on friction less and less. Where the contact adheres (less than a twentieth of the
/// friction is used, or the force is larger than linear theory gives) the status is
/// KSTRIP_WARNING_FRICTION_AT_LEAST, and the result is the used friction |force|/load, a lower
/// bound. Where spin opposes the creepage, more than one friction may explain the force: the status
/// is KSTRIP_WARNING_SEVERAL_FRICTIONS, and the result is the smallest. KSTRIP_MODEL_TOTAL suits
/// best. The force of KSTRIP_MODEL_STRIP_1967 jumps where a first strip begins to adhere. A jump
/// across the measured force counts there as one of several solutions, and is returned only with
/// KSTRIP_WARNING_NOT_CONVERGED. An estimate may miss a friction, most often where the force is
/// nearly zero: this happened to up to one of ten thousand estimates with each of the models of
/// 1967, to one of a hundred thousand with KSTRIP_MODEL_STRIP, and to none with KSTRIP_MODEL_TOTAL.
///
/// Under a law the result is its friction, without slip: a force that was computed with the law
/// gives the law's coefficient. If the actual law is another one, each creepage gives another
/// friction; kstrip_fit_friction() finds the law.
///
/// @param contact         ellipse, load, material; its friction is ignored.
/// @param creepage        motion.
/// @param friction        law of friction, whose own coefficient is ignored; NULL: clean bodies,
///                        constant friction.
/// @param options         model and strip count; NULL for the defaults. Not KSTRIP_MODEL_LINEAR.
/// @param measured        KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY, or both added: then the resultant
///                        counts.
/// @param fx, fy          measured forces on the lower body [N]; what was not measured is ignored.
/// @param[out] estimate   receives friction, its sensitivity, and how far the force is off.
/// @return as kstrip_solve(); KSTRIP_WARNING_FRICTION_AT_LEAST, KSTRIP_WARNING_SEVERAL_FRICTIONS,
///         KSTRIP_WARNING_NOT_CONVERGED; KSTRIP_ERROR_NOT_IN_MODEL, KSTRIP_ERROR_MEASURED,
///         KSTRIP_ERROR_UNEXPLAINED (a lost contact too), or an error of the law as
///         kstrip_evaluate().
#[unsafe(export_name = symbol!("kstrip_estimate_friction"))]
pub extern "C" fn kstrip_estimate_friction(
    contact: Option<&Contact<F>>,
    creepage: Option<&Creepage<F>>,
    friction: Option<&SlipFriction<F>>,
    options: Option<&kstrip_options>,
    measured: u32,
    fx: F,
    fy: F,
    estimate: Option<&mut MaybeUninit<FrictionEstimate<F>>>,
) -> kstrip_status {
    answer(|| {
        let (contact, creepage, estimate) = (given(contact)?, given(creepage)?, given(estimate)?);
        let options = for_forces(options)?;
        // What was not measured may be anything.
        let (measured, force) = match measured {
            KSTRIP_MEASURED_FX => (Measured::Fx, [fx, 0.0]),
            KSTRIP_MEASURED_FY => (Measured::Fy, [0.0, fy]),
            BOTH => (Measured::Both, [fx, fy]),
            _ => return Err(Error::Measured),
        };
        let found =
            rig::estimate_friction_under(contact, creepage, friction, &options, measured, force)?;
        estimate.write(found);
        Ok(found.warning)
    })
}

/// The creepage at which a contact with a given spin carries a requested force.
///
/// The search usually needs five solutions with derivatives. Of ten thousand plausible contacts
/// about one needs more than 12 (14 with KSTRIP_MODEL_STRIP_1967, whose force jumps). The requested
/// forces of these contacts are near friction times load, where the force falls before it grows
/// further. The search ends after 40 with KSTRIP_WARNING_NOT_CONVERGED and the creepage that comes
/// nearest; a force within a jump of STRIP_1967 has no creepage, which happens to seven of a
/// thousand forces with spin. Where spin keeps the force from growing with the creepage, more than
/// one creepage may give the force; the result is one of them. A force within 0.1 % of friction
/// times load is that of full sliding. The status is then KSTRIP_WARNING_CREEPAGE_AT_LEAST, and
/// every creepage larger than the result gives the force as well. A lost contact carries no force
/// at any creepage; the result is zero.
///
/// @param contact         ellipse, load, material, friction.
/// @param fx, fy          requested force on the lower body [N].
/// @param spin            given spin [1/m].
/// @param friction        law of friction; NULL: clean bodies, the contact's own friction. A force
///                        that falling friction does not reach is KSTRIP_WARNING_NOT_CONVERGED.
/// @param options         model and strip count; NULL for the defaults.
/// @param[out] creepage   receives the creepages, and the given spin.
/// @return as kstrip_solve(); KSTRIP_WARNING_CREEPAGE_AT_LEAST, KSTRIP_WARNING_NOT_CONVERGED;
///         KSTRIP_ERROR_FORCE_BEYOND_FRICTION, or an error of the law as kstrip_evaluate().
#[unsafe(export_name = symbol!("kstrip_creepage_for_force"))]
pub extern "C" fn kstrip_creepage_for_force(
    contact: Option<&Contact<F>>,
    fx: F,
    fy: F,
    spin: F,
    friction: Option<&SlipFriction<F>>,
    options: Option<&kstrip_options>,
    creepage: Option<&mut MaybeUninit<Creepage<F>>>,
) -> kstrip_status {
    answer(|| {
        let (contact, creepage) = (given(contact)?, given(creepage)?);
        let (found, warning) = rig::creepage_for_force_under(
            contact,
            [fx, fy],
            spin,
            friction,
            &for_forces(options)?,
        )?;
        creepage.write(found);
        Ok(warning)
    })
}

/// The law of friction that comes nearest to a measured creep curve.
///
/// The sum of the squared differences between measured and computed forces, each times the weight
/// of its point, is minimised by at most 80 damped Gauss-Newton steps with exact derivatives;
/// measured curves need 6 to 20. Each step costs one solution with derivatives for every point.
/// Members of the law that are not fitted keep the values of start. A fitted member that is 0 in
/// start begins at a usual value; friction that falls needs the rolling speed in start. Bounds
/// are those of the law: a member that ends at its bound has a standard error of 0.
///
/// Points that lie on one part of the curve do not determine each parameter: creepages below one
/// per cent only bound friction from below, and without the start of the curve slope factor and
/// layer are unknown. The status is then KSTRIP_WARNING_UNDETERMINED: with errors of the forces of
/// one per cent, or their actual errors if these are larger, a parameter would be uncertain by more
/// than half of its value. Layer and slope factor have nearly the same effect; fit one of them.
///
/// @param contact         ellipse, load, material of all points; its friction is ignored.
/// @param points, count   the measured points.
/// @param start           where to begin, and the members that stay.
/// @param parameters      which members to fit: KSTRIP_FIT constants, added.
/// @param options         model and strip count; NULL for the defaults.
/// @param[out] fit        receives the law and its standard errors.
/// @param[out] first_bad  receives the index of the first bad point, or count where none is bad;
///                        NULL: not requested.
/// @return KSTRIP_OK, KSTRIP_WARNING_UNDETERMINED, KSTRIP_WARNING_NOT_CONVERGED;
///         KSTRIP_ERROR_FEW_POINTS, KSTRIP_ERROR_FIT_PARAMETERS, KSTRIP_ERROR_MEASURED,
///         KSTRIP_ERROR_WEIGHT, KSTRIP_ERROR_UNEXPLAINED (a lost contact), or an error of
///         kstrip_evaluate().
#[unsafe(export_name = symbol!("kstrip_fit_friction"))]
pub unsafe extern "C" fn kstrip_fit_friction(
    contact: Option<&Contact<F>>,
    points: *const MeasuredForce<F>,
    count: u32,
    start: Option<&SlipFriction<F>>,
    parameters: u32,
    options: Option<&kstrip_options>,
    fit: Option<&mut MaybeUninit<FrictionFit<F>>>,
    first_bad: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    // SAFETY: NULL or count elements, says the header.
    let points = unsafe { input(points, count) };
    answer(|| {
        let (contact, start, fit) = (given(contact)?, given(start)?, given(fit)?);
        let (points, options) = (points?, for_forces(options)?);
        let found = fitted(parameters)
            .map_err(|error| (points.len(), error))
            .and_then(|fitted| rig::fit::fit_friction(contact, points, start, fitted, &options));
        put(first_bad, found.as_ref().err().map_or(count, |(i, _)| *i as u32));
        let found = found.map_err(|(_, error)| error)?;
        fit.write(found);
        Ok(found.warning)
    })
}
