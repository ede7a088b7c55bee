//! Exported functions of patches in double precision.

use super::patch_types::*;
use super::types::{
    kstrip_contact, kstrip_creepage, kstrip_options, kstrip_point, kstrip_result, kstrip_strip,
};
use super::{arrays, kstrip_status, patch_calls};
use core::mem::MaybeUninit;

/// The strips of a Hertz ellipse, where KSTRIP_MODEL_STRIP places them.
///
/// kstrip_patch_solve() with KSTRIP_MODEL_STRIP gives the answer of kstrip_solve() with the same strip count,
/// to rounding. The strips of the models of 1967 move with the solution in kstrip_solve(), here they do not: the
/// forces differ by a part of what one strip carries.
///
/// @param contact         the loaded contact.
/// @param strips          number of strips: 4, 8, 16, 32 or 64.
/// @param[out] patch      receives the patch.
/// @return KSTRIP_OK; KSTRIP_ERROR_STRIP_COUNT, or one of the errors of kstrip_solve() for the contact.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_patch_from_ellipse(
    contact: Option<&kstrip_contact>,
    strips: i32,
    patch: Option<&mut MaybeUninit<kstrip_patch>>,
) -> kstrip_status {
    patch_calls::from_ellipse(contact, strips, patch)
}

/// A patch from strips of any origin, in any order of y.
///
/// Strips may overlap by up to half of the distance at which they touch (a quadrature rule does), not by
/// more. Strips that do not ascend are sorted in a copy on the stack (7 KiB).
///
/// @param strips, count   the strips, at most KSTRIP_PATCH_CAPACITY; 0 is allowed.
/// @param shear_modulus   combined shear modulus G [Pa], > 0.
/// @param poisson_ratio   combined Poisson's ratio [-], 0 to 0.5.
/// @param[out] patch      receives the patch.
/// @return KSTRIP_OK; KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_MODULUS,
///         KSTRIP_ERROR_POISSON_RATIO, KSTRIP_ERROR_FRICTION, KSTRIP_ERROR_OVERFLOW,
///         KSTRIP_ERROR_STRIP_SIZE, KSTRIP_ERROR_PRESSURE, KSTRIP_ERROR_STRIP_ORDER (overlap),
///         KSTRIP_ERROR_PATCH_SIZE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_patch_from_strips(
    strips: *const kstrip_patch_strip,
    count: u32,
    shear_modulus: f64,
    poisson_ratio: f64,
    patch: Option<&mut MaybeUninit<kstrip_patch>>,
) -> kstrip_status {
    // SAFETY: NULL or count elements, says the header.
    let strips = unsafe { arrays::input(strips, count) };
    patch_calls::from_strips(strips, shear_modulus, poisson_ratio, patch)
}

/// The patch of two profiles under a load, by the construction of Kik and Piotrowski (1996): virtual
/// penetration 0.55 delta, half lengths sqrt(2 R g), pressure a half-ellipse along x, delta from the
/// deflection at the deepest point.
///
/// No elastic problem is solved: for the circle of Hertz the patch is 3 % too large and the peak pressure 6 %
/// too low; for an ellipse whose curvatures are as 1 to 9, one axis is 27 % too long. Zones of contact that
/// are apart become lobes. Bounded time: at most 60 evaluations of the load, usually below ten, each
/// proportional to the number of points in contact. Uses 7 KiB of stack.
///
/// @param y, distance, points  undeformed distance of the bodies [m] on the line x = 0 at y [m], which ascends;
///                        at least 3 points, straight between them. What is added to all distances
///                        does not matter.
/// @param contact         rolling radius, load, material, friction.
/// @param strips          number of strips, 4, 8, 16, 32 or 64; with several zones of contact the patch may
///                        have a few less.
/// @param[out] patch      receives the patch.
/// @param[out] result     receives approach, peak pressure, and the load reached.
/// @return KSTRIP_OK; KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_PROFILE,
///         KSTRIP_ERROR_PROFILE_END, KSTRIP_ERROR_ROLLING_RADIUS, KSTRIP_ERROR_NORMAL_FORCE,
///         KSTRIP_ERROR_MODULUS, KSTRIP_ERROR_POISSON_RATIO, KSTRIP_ERROR_FRICTION,
///         KSTRIP_ERROR_STRIP_COUNT, KSTRIP_ERROR_PATCH_SIZE, KSTRIP_ERROR_OVERFLOW.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_patch_from_profile(
    y: *const f64,
    distance: *const f64,
    points: u32,
    contact: Option<&kstrip_profile_contact>,
    strips: i32,
    patch: Option<&mut MaybeUninit<kstrip_patch>>,
    result: Option<&mut MaybeUninit<kstrip_profile_result>>,
) -> kstrip_status {
    // SAFETY: NULL or as many elements as points says, says the header.
    let (y, distance) = unsafe { (arrays::input(y, points), arrays::input(distance, points)) };
    patch_calls::from_profile(y, distance, contact, strips, patch, result)
}

/// Load, friction bound, area and lobes of a patch; checks it without solving.
///
/// @param patch           the patch.
/// @param[out] summary    receives the sums.
/// @return KSTRIP_OK; KSTRIP_ERROR_NULL or one of the errors of kstrip_patch_from_strips(), here
///         KSTRIP_ERROR_STRIP_ORDER also when the strips do not ascend.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_patch_summarize(
    patch: Option<&kstrip_patch>,
    summary: Option<&mut MaybeUninit<kstrip_patch_summary>>,
) -> kstrip_status {
    patch_calls::summary(patch, summary)
}

/// Forces of a patch in motion, on the lower body.
///
/// The creepage is that at the origin of the patch's coordinates, x = y = 0; a strip sees
/// (longitudinal - spin y, lateral + spin centre_x), and the moment is about the origin. |F| is at
/// most the sum of friction times load over the strips. KSTRIP_MODEL_STRIP solves each lobe
/// with an equivalent ellipse: as wide as the lobe's strips together, with their mean squared half length
/// (two thirds of a squared), their load and their mean friction.
///
/// @param patch           the patch.
/// @param creepage        motion at the origin.
/// @param options         KSTRIP_MODEL_STRIP or one of the models of 1967; NULL for the default. The
///                        strip count is checked and otherwise ignored.
/// @param[out] result     receives forces, moment, power and stick area.
/// @return KSTRIP_OK, KSTRIP_WARNING_SPIN, KSTRIP_WARNING_RANGE (of a lobe's ellipse);
///         KSTRIP_ERROR_NOT_IN_MODEL for KSTRIP_MODEL_TOTAL and KSTRIP_MODEL_LINEAR (the linear theory
///         of a patch is kstrip_patch_jacobian() at zero creepage); KSTRIP_ERROR_MODEL,
///         KSTRIP_ERROR_STRIP_COUNT, or one of the errors of kstrip_patch_summarize().
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_patch_solve(
    patch: Option<&kstrip_patch>,
    creepage: Option<&kstrip_creepage>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result>>,
) -> kstrip_status {
    patch_calls::solve(patch, creepage, options, result)
}

/// Forces of a patch and their exact derivatives with respect to the creepages.
///
/// @param[out] jacobian   receives d(fx, fy, mz)/d(longitudinal, lateral, spin), row by row: nine
///                        numbers [N, N, N m over 1, 1, 1/m]. At kinks of a model, a one-sided value.
/// @return as kstrip_patch_solve(); KSTRIP_ERROR_OVERFLOW also when a derivative is too large.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_patch_jacobian(
    patch: Option<&kstrip_patch>,
    creepage: Option<&kstrip_creepage>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result>>,
    jacobian: *mut f64,
) -> kstrip_status {
    // SAFETY: NULL or nine writable numbers, says the header.
    let jacobian = unsafe { arrays::output(jacobian, 9) };
    patch_calls::jacobian(patch, creepage, options, result, jacobian)
}

/// What each strip of a patch carries, ascending in y. The shares add up to the totals of
/// kstrip_patch_solve(); each moment is about the origin.
///
/// @param[out] strips     array that receives the strips.
/// @param capacity        its size, at least patch->count.
/// @param[out] count      receives how many were written: patch->count.
/// @return as kstrip_patch_solve(); KSTRIP_ERROR_CAPACITY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_patch_strips(
    patch: Option<&kstrip_patch>,
    creepage: Option<&kstrip_creepage>,
    options: Option<&kstrip_options>,
    strips: *mut kstrip_strip,
    capacity: u32,
    count: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    // SAFETY: NULL or capacity elements, says the header.
    let strips = unsafe { arrays::output(strips, capacity) };
    patch_calls::strips(patch, creepage, options, strips, count)
}

/// Pressure, traction, slip and state at a point of a patch. They do not vary over the width of a strip.
///
/// @param x, y            the point [m]; outside is allowed.
/// @param[out] point      receives the state.
/// @return as kstrip_patch_solve().
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_patch_traction_at(
    patch: Option<&kstrip_patch>,
    creepage: Option<&kstrip_creepage>,
    options: Option<&kstrip_options>,
    x: f64,
    y: f64,
    point: Option<&mut MaybeUninit<kstrip_point>>,
) -> kstrip_status {
    patch_calls::traction_at(patch, creepage, options, x, y, point)
}

/// Pressure, traction, slip and state of a patch over a grid.
///
/// @param x, columns      array of x [m] and its size.
/// @param y, rows         array of y [m] and its size.
/// @param[out] points     array of rows * columns elements; the point (x[i], y[j]) is
///                        points[j * columns + i].
/// @param capacity        its size.
/// @return as kstrip_patch_solve(); KSTRIP_ERROR_CAPACITY.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_patch_field(
    patch: Option<&kstrip_patch>,
    creepage: Option<&kstrip_creepage>,
    options: Option<&kstrip_options>,
    x: *const f64,
    columns: u32,
    y: *const f64,
    rows: u32,
    points: *mut kstrip_point,
    capacity: u32,
) -> kstrip_status {
    // SAFETY: NULL or as many elements as the counts say, says the header.
    let (x, y, points) = unsafe {
        (arrays::input(x, columns), arrays::input(y, rows), arrays::output(points, capacity))
    };
    patch_calls::field(patch, creepage, options, x, y, points)
}
