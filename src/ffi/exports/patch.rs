//! Patches: contacts of any shape, given by their strips.

use super::F;
use super::inside::FieldGrid;
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::ffi::support::{for_strips, given, input, put, status_of, strip_count, write_result};
use crate::ffi::types::{Outputs, PatchSummary, ProfileOptions, ProfilePoints, kstrip_options};
use crate::forces::field::FieldPoint;
use crate::friction::SlipFriction;
use crate::normal::cells::Given;
use crate::normal::{Indentation, Profile, ProfileContact};
use crate::patch::field::PatchField;
use crate::patch::{self, KSTRIP_PATCH_CAPACITY, Patch, PatchStrip, solver};
use crate::status::{Error, Warning, kstrip_status};
use core::mem::MaybeUninit;

/// The patch of two profiles under a load, or at an approach.
///
/// Contact regions begin with zero width, grow and merge. The results are continuous in distances
/// and approach, and in the load unless it falls with the approach (rough profiles). The stiffness
/// is the derivative of the computed load. The approach is measured from the lowest point of the
/// smoothed profile: it has a kink when another point becomes the lowest.
///
/// @param profile         undeformed distance of the bodies at points in ascending y.
/// @param contact         rolling radius, load or approach, material, friction, number of strips.
/// @param[out] patch      receives the patch.
/// @param[out] result     receives approach, peak pressure and load; NULL: not needed.
/// @return usual statuses; statuses of kstrip_profile and kstrip_profile_contact;
///         KSTRIP_WARNING_PROFILE_END (a contact region ends with the profile);
///         KSTRIP_WARNING_ROUGH (a contact has more local minima than its strips resolve).
#[unsafe(export_name = symbol!("kstrip_patch_from_profile"))]
pub unsafe extern "C" fn kstrip_patch_from_profile(
    profile: Option<&ProfilePoints<F>>, contact: Option<&ProfileOptions<F>>,
    patch: Option<&mut MaybeUninit<Patch<F>>>, result: Option<&mut MaybeUninit<Indentation<F>>>,
) -> kstrip_status {
    status_of(|| {
        let (profile, contact, patch) = (given(profile)?, given(contact)?, given(patch)?);
        let ProfilePoints { y, distance, centre_x, rolling_radius, points, .. } = *profile;
        // SAFETY: NULL or as many elements as points says, says the header.
        let list = |pointer: *const F| unsafe { input(pointer, points) };
        let mut profile = Profile::new(list(y)?, list(distance)?)?;
        if !centre_x.is_null() {
            profile = profile.with_centre_x(list(centre_x)?)?;
        }
        if !rolling_radius.is_null() {
            profile = profile.with_rolling_radius(list(rolling_radius)?)?;
        }
        let ProfileOptions { rolling_radius, shear_modulus, poisson_ratio, friction, .. } =
            *contact;
        let ProfileOptions { normal_force, approach, smoothing_length, strips, .. } = *contact;
        // The approach counts only where there is no load.
        let by_load = normal_force != 0.0 || approach == 0.0;
        let given = if by_load { Given::Load(normal_force) } else { Given::Approach(approach) };
        let contact = &ProfileContact {
            rolling_radius,
            given,
            shear_modulus,
            poisson_ratio,
            friction,
            smoothing_length,
        };
        let width = match list(y)? {
            [first, .., last] => last - first,
            _ => 0.0,
        };
        let (built, found) = Patch::from_profile(&profile, contact, strip_count(strips)?)?;
        // Next to such an approach the shape of the surfaces is lost.
        let is_lost = approach > width && found.normal_force <= 0.0;
        Error::Overflow.when(!by_load && is_lost)?;
        patch.write(built);
        put(result, found);
        Ok(found.warning)
    })
}

/// A patch from strips of any origin, in any order of y.
///
/// Strips may overlap by up to half of the distance at which they touch (a quadrature rule does),
/// not by more. Strips that do not ascend are sorted in a copy on the stack (3 KiB; 2 KiB in single
/// precision).
///
/// @param strips, count   the strips, at most KSTRIP_PATCH_CAPACITY; 0 is allowed.
/// @param shear_modulus   combined shear modulus G [Pa], > 0.
/// @param poisson_ratio   combined Poisson's ratio [-], 0 to 0.5.
/// @param[out] patch      receives the patch.
/// @return usual statuses; statuses of kstrip_patch_strip; KSTRIP_ERROR_MODULUS (shear_modulus <=
///         0); KSTRIP_ERROR_POISSON_RATIO (outside 0 to 0.5); KSTRIP_ERROR_STRIP_ORDER (strips
///         overlap by more than that); KSTRIP_ERROR_PATCH_SIZE (count is above
///         KSTRIP_PATCH_CAPACITY).
#[unsafe(export_name = symbol!("kstrip_patch_from_strips"))]
pub unsafe extern "C" fn kstrip_patch_from_strips(
    strips: *const PatchStrip<F>, count: u32, shear_modulus: F, poisson_ratio: F,
    patch: Option<&mut MaybeUninit<Patch<F>>>,
) -> kstrip_status {
    // SAFETY: NULL or count elements, says the header.
    let strips = unsafe { input(strips, count) };
    write_result(patch, || Patch::from_strips(strips?, shear_modulus, poisson_ratio))
}

/// The strips of a contact's ellipse, at the places of KSTRIP_MODEL_STRIP. A lost contact has no
/// strips.
///
/// With KSTRIP_MODEL_STRIP and eight strips or more kstrip_patch_evaluate() has the result of
/// kstrip_solve() to rounding. For the models of 1967 the difference is less than the force of one
/// strip.
///
/// @param contact         the loaded contact.
/// @param options         strip count; its model is checked and otherwise ignored. NULL for the
///                        defaults.
/// @param[out] patch      receives the patch.
/// @return usual statuses; errors of kstrip_contact and kstrip_options.
#[unsafe(export_name = symbol!("kstrip_patch_from_contact"))]
pub extern "C" fn kstrip_patch_from_contact(
    contact: Option<&Contact<F>>, options: Option<&kstrip_options>,
    patch: Option<&mut MaybeUninit<Patch<F>>>,
) -> kstrip_status {
    write_result(patch, || Patch::from_ellipse(given(contact)?, for_strips(options)?.strips))
}

/// Load, friction bound, area and contact regions of a patch; checks it without solving.
///
/// @param patch           the patch.
/// @param[out] summary    receives the sums.
/// @return usual statuses; statuses of kstrip_patch.
#[unsafe(export_name = symbol!("kstrip_patch_summarize"))]
pub extern "C" fn kstrip_patch_summarize(
    patch: Option<&Patch<F>>, summary: Option<&mut MaybeUninit<PatchSummary<F>>>,
) -> kstrip_status {
    write_result(summary, || {
        let view = given(patch)?.view()?;
        Ok(PatchSummary {
            normal_force: view.normal_force(),
            friction_bound: view.friction_bound(),
            area: view.area() * view.quadrature().area,
            lobes: view.lobes().count() as u32,
            reserved: 0,
        })
    })
}

/// Computes, for a patch in motion, every output that is not NULL. Forces act on the lower body.
///
/// The creepage is that at the origin of the patch's coordinates, x = y = 0; the creepages of a
/// strip are (longitudinal - spin y, lateral + spin centre_x), and moments are about the origin.
/// |F| is at most the sum of friction times load over the strips. With KSTRIP_MODEL_STRIP the
/// flexibilities of a strip are those of an equivalent ellipse, fitted to the contact region that
/// contains the strip, or larger if the strip is long for its pressure. KSTRIP_MODEL_TOTAL adds the
/// forces of these ellipses. It is cheap and smooth, and has no strips and no share in adhesion.
///
/// The forces of KSTRIP_MODEL_STRIP and KSTRIP_MODEL_TOTAL are continuous in the widths and places
/// of strips that have one width or are narrower. That of KSTRIP_MODEL_STRIP_1967 jumps by up to
/// the force of one strip if a strip with spin stops adhering; that of
/// KSTRIP_MODEL_STRIP_1967_CONTINUOUS has a kink there.
///
/// For the derivatives with respect to load, all pressures grow by one factor; through Hertz, all
/// lengths grow with the load's cube root as well. The derivatives with respect to friction are
/// those with respect to the mean coefficient. If friction is given, the factor (1 - ratio)
/// exp(-decay w) + ratio multiplies the coefficients of all strips, and the law's own coefficient
/// is ignored. outputs->strips receives patch->count strips.
///
/// @param patch           the patch.
/// @param creepage        motion at the origin.
/// @param friction        falling friction; NULL: constant.
/// @param options         KSTRIP_MODEL_STRIP (the default here), KSTRIP_MODEL_TOTAL or one of the
///                        models of 1967; NULL for the default. The strip count is checked and
///                        otherwise ignored.
/// @param outputs         where the outputs go.
/// @return usual statuses; statuses of kstrip_patch, kstrip_friction and kstrip_options;
///         KSTRIP_WARNING_SEVERAL_FRICTIONS and KSTRIP_WARNING_NOT_CONVERGED, as in
///         kstrip_evaluate(); KSTRIP_ERROR_CAPACITY (outputs->capacity is below patch->count);
///         KSTRIP_ERROR_NOT_IN_MODEL for KSTRIP_MODEL_LINEAR (the linear theory of a patch is its
///         derivatives at zero creepage) and for the strips of KSTRIP_MODEL_TOTAL.
#[unsafe(export_name = symbol!("kstrip_patch_evaluate"))]
pub unsafe extern "C" fn kstrip_patch_evaluate(
    patch: Option<&Patch<F>>, creepage: Option<&Creepage<F>>, friction: Option<&SlipFriction<F>>,
    options: Option<&kstrip_options>, outputs: Option<&Outputs<F>>,
) -> kstrip_status {
    // SAFETY: every pointer is NULL or valid, says the header.
    status_of(|| unsafe {
        evaluate_patch(given(patch)?, (given(creepage)?, &[]), friction, options, given(outputs)?)
    })
}

/// kstrip_patch_evaluate() with creepages of each strip, as on curved surfaces: own is added to the
/// creepages that the motion has at the strip's centre. Derivatives are with respect to the motion.
///
/// @param patch, creepage, friction, options, outputs  as in kstrip_patch_evaluate().
/// @param own             array of patch->count creepages, one for each strip; NULL: all zero.
/// @return as kstrip_patch_evaluate(); KSTRIP_ERROR_NOT_IN_MODEL also for KSTRIP_MODEL_TOTAL.
#[unsafe(export_name = symbol!("kstrip_patch_evaluate_strips"))]
pub unsafe extern "C" fn kstrip_patch_evaluate_strips(
    patch: Option<&Patch<F>>, creepage: Option<&Creepage<F>>, own: *const Creepage<F>,
    friction: Option<&SlipFriction<F>>, options: Option<&kstrip_options>,
    outputs: Option<&Outputs<F>>,
) -> kstrip_status {
    let strips = patch.map_or(0, |patch| patch.count.min(KSTRIP_PATCH_CAPACITY as u32));
    // SAFETY: NULL or as many elements as the patch has strips, says the header.
    let own = if own.is_null() { Ok(&[][..]) } else { unsafe { input(own, strips) } };
    // SAFETY: every pointer is NULL or valid, says the header.
    status_of(|| unsafe {
        evaluate_patch(given(patch)?, (given(creepage)?, own?), friction, options, given(outputs)?)
    })
}

/// Pressure, traction, slip and state of a patch over a grid. They do not vary over the width of a
/// strip.
///
/// The tractions add up to the forces of kstrip_patch_evaluate(), and the dissipation to its power,
/// as those of kstrip_field() do.
///
/// @param patch, creepage, friction  as in kstrip_patch_evaluate().
/// @param options         as in kstrip_patch_evaluate(), but not KSTRIP_MODEL_TOTAL; NULL for the
///                        default.
/// @param x, columns      array of x [m] and its size; places outside of the patch are allowed.
/// @param y, rows         array of y [m] and its size.
/// @param[out] points     array of rows * columns elements; the point (x[i], y[j]) is
///                        points[j * columns + i].
/// @param capacity        size of points, at least rows * columns.
/// @return as kstrip_patch_evaluate(); KSTRIP_ERROR_CAPACITY (capacity is below rows * columns);
///         KSTRIP_ERROR_NOT_IN_MODEL also for KSTRIP_MODEL_TOTAL.
#[unsafe(export_name = symbol!("kstrip_patch_field"))]
pub unsafe extern "C" fn kstrip_patch_field(
    patch: Option<&Patch<F>>, creepage: Option<&Creepage<F>>, friction: Option<&SlipFriction<F>>,
    options: Option<&kstrip_options>, x: *const F, columns: u32, y: *const F, rows: u32,
    points: *mut FieldPoint<F>, capacity: u32,
) -> kstrip_status {
    // SAFETY: NULL or as many elements as the counts say, says the header.
    let grid = unsafe { FieldGrid::new((x, columns), (y, rows), (points, capacity)) };
    status_of(|| {
        let (patch, creepage, options) = (given(patch)?, given(creepage)?, for_strips(options)?);
        let view = patch.view()?;
        let field = PatchField::new(&view, creepage, friction, options.model)?;
        grid?.write(|y| field.strip_at(y), |strip, x| PatchField::along(strip.as_ref(), x))?;
        Ok(field.warning)
    })
}

/// # Safety
/// Every pointer of the outputs is NULL, or valid and aligned for one write, that of the strips for
/// `capacity`; no two overlap.
unsafe fn evaluate_patch(
    patch: &Patch<F>, (creepage, own): (&Creepage<F>, &[Creepage<F>]),
    law: Option<&SlipFriction<F>>, options: Option<&kstrip_options>, outputs: &Outputs<F>,
) -> Result<Warning, Error> {
    let model = for_strips(options)?.model;
    let mut view = patch.view()?;
    if !own.is_empty() {
        view = view.with_own_creepages(own)?;
    }
    let differentiated;
    let (solution, share, slopes) = if outputs.differentiates() {
        differentiated = patch::friction::differentiate_patch(&view, creepage, law, model)?;
        let found = &differentiated;
        (found.solution, found.friction, Some((&found.derivatives, &found.law)))
    } else if let Some(law) = law {
        let found = patch::friction::solve_patch_with_law(&view, creepage, law, model)?;
        (found.solution, found.friction, None)
    } else {
        (solver::solve_patch(&view, creepage, model)?, 1.0, None)
    };
    // SAFETY: the caller's promise.
    unsafe {
        if !outputs.strips.is_null() {
            outputs.write_strips(view.strips().len(), |mut visit| {
                patch::friction::patch_strips_with_law(
                    &view, creepage, law, share, model, &mut visit,
                )
            })?;
        }
        outputs.write(&solution, share, slopes);
    }
    Ok(solution.warning)
}
