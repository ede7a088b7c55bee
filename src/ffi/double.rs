//! Exported functions in double precision.

use super::types::*;
use super::{arrays, calls, kstrip_status};
use core::mem::MaybeUninit;

/// Material from Young's modulus: G = E/(2 (1 + nu)).
///
/// @param youngs_modulus  E [Pa], > 0.
/// @param poisson_ratio   nu [-], 0 to 0.5.
/// @param[out] material   receives the material.
/// @return KSTRIP_OK, KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_MODULUS,
///         KSTRIP_ERROR_POISSON_RATIO.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_material_from_youngs_modulus(
    youngs_modulus: f64,
    poisson_ratio: f64,
    material: Option<&mut MaybeUninit<kstrip_material>>,
) -> kstrip_status {
    calls::material_from_youngs_modulus(youngs_modulus, poisson_ratio, material)
}

/// Combine the elastic constants of two bodies.
///
/// @param lower, upper    the two bodies.
/// @param[out] combined   receives the constants that kstrip_hertz() and kstrip_contact take.
/// @return KSTRIP_OK, KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_MODULUS,
///         KSTRIP_ERROR_POISSON_RATIO, KSTRIP_ERROR_OVERFLOW.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_material_combine(
    lower: Option<&kstrip_material>,
    upper: Option<&kstrip_material>,
    combined: Option<&mut MaybeUninit<kstrip_combined_material>>,
) -> kstrip_status {
    calls::material_combine(lower, upper, combined)
}

/// Contact ellipse, peak pressure and approach of two bodies pressed together (Hertz).
///
/// Relative error below 1e-12 (5e-6 in single precision) for axis ratios down to 1e-4; a handful of
/// iterations, at most 12. Without load the ellipse is a point, a = b = 0.
///
/// @param radii           curvatures of both bodies.
/// @param normal_force    N [N], >= 0.
/// @param material        combined constants.
/// @param[out] ellipse    receives the solution.
/// @return KSTRIP_OK, KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_NORMAL_FORCE,
///         KSTRIP_ERROR_MODULUS, KSTRIP_ERROR_POISSON_RATIO, KSTRIP_ERROR_CURVATURE,
///         KSTRIP_ERROR_OVERFLOW.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_hertz(
    radii: Option<&kstrip_radii>,
    normal_force: f64,
    material: Option<&kstrip_combined_material>,
    ellipse: Option<&mut MaybeUninit<kstrip_hertz_contact>>,
) -> kstrip_status {
    calls::hertz(radii, normal_force, material, ellipse)
}

/// Creepages from the velocities of both bodies: (upper - lower)/rolling_speed.
///
/// @param lower, upper    surface velocities at the centre of the contact, in one frame.
/// @param rolling_speed   V [m/s], > 0; x points in the rolling direction.
/// @param[out] creepage   receives the creepages.
/// @return KSTRIP_OK, KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_ROLLING_SPEED,
///         KSTRIP_ERROR_OVERFLOW.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_creepage_from_velocities(
    lower: Option<&kstrip_velocity>,
    upper: Option<&kstrip_velocity>,
    rolling_speed: f64,
    creepage: Option<&mut MaybeUninit<kstrip_creepage>>,
) -> kstrip_status {
    calls::creepage_from_velocities(lower, upper, rolling_speed, creepage)
}

/// Kalker's dimensionless parameters xi, eta, psi (5.13) of a contact in motion.
///
/// @return KSTRIP_OK or the errors of kstrip_solve() for the same contact and creepage.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_parameters_from_creepage(
    contact: Option<&kstrip_contact>,
    creepage: Option<&kstrip_creepage>,
    parameters: Option<&mut MaybeUninit<kstrip_parameters>>,
) -> kstrip_status {
    calls::parameters_from_creepage(contact, creepage, parameters)
}

/// The creepage that has the given parameters xi, eta, psi on a contact: the inverse of
/// kstrip_parameters_from_creepage().
///
/// @return KSTRIP_OK, KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_OVERFLOW or the errors
///         of kstrip_solve() for the same contact.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_creepage_from_parameters(
    contact: Option<&kstrip_contact>,
    parameters: Option<&kstrip_parameters>,
    creepage: Option<&mut MaybeUninit<kstrip_creepage>>,
) -> kstrip_status {
    calls::creepage_from_parameters(contact, parameters, creepage)
}

/// Forces of a contact in motion, on the lower body.
///
/// Continuous in all inputs; |F| <= mu N. Zero creepage and spin give zero; no load or no friction
/// give zero. Bounded time, no iteration that depends on convergence alone.
///
/// @param contact         ellipse, load, material, friction.
/// @param creepage        motion.
/// @param options         model and strip count; NULL for the defaults.
/// @param[out] result     receives forces, moment, power and stick area.
/// @return KSTRIP_OK; KSTRIP_WARNING_SPIN, KSTRIP_WARNING_RANGE, KSTRIP_WARNING_BEYOND_FRICTION;
///         KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_SEMI_AXIS,
///         KSTRIP_ERROR_NORMAL_FORCE, KSTRIP_ERROR_MODULUS, KSTRIP_ERROR_POISSON_RATIO,
///         KSTRIP_ERROR_FRICTION, KSTRIP_ERROR_MODEL, KSTRIP_ERROR_STRIP_COUNT,
///         KSTRIP_ERROR_OVERFLOW.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve(
    contact: Option<&kstrip_contact>,
    creepage: Option<&kstrip_creepage>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result>>,
) -> kstrip_status {
    calls::solve(contact, creepage, options, result)
}

/// Forces and their exact derivatives with respect to the creepages.
///
/// @param[out] jacobian   receives d(fx, fy, mz)/d(longitudinal, lateral, spin), row by row: nine
///                        numbers [N, N, N m over 1, 1, 1/m]. At kinks of a model, a one-sided value.
/// @return as kstrip_solve(); KSTRIP_ERROR_OVERFLOW also when a derivative is too large.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_solve_jacobian(
    contact: Option<&kstrip_contact>,
    creepage: Option<&kstrip_creepage>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result>>,
    jacobian: *mut f64,
) -> kstrip_status {
    // SAFETY: NULL or nine writable numbers, says the header.
    let jacobian = unsafe { arrays::output(jacobian, 9) };
    calls::solve_jacobian(contact, creepage, options, result, jacobian)
}

/// Forces of many contacts: the same as calling kstrip_solve() for each, bit for bit.
///
/// All inputs are checked before anything is written: if one is bad its status is returned and no
/// result is touched.
///
/// @param contacts, creepages  arrays of count elements.
/// @param count           number of contacts; 0 is allowed.
/// @param options         for all contacts; NULL for the defaults.
/// @param[out] results    array of count elements; status_detail tells each one's warning.
/// @return KSTRIP_OK, the largest warning, or the first error, as kstrip_solve().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_solve_batch(
    contacts: *const kstrip_contact,
    creepages: *const kstrip_creepage,
    count: u32,
    options: Option<&kstrip_options>,
    results: *mut kstrip_result,
) -> kstrip_status {
    // SAFETY: NULL or count elements each, says the header.
    let (contacts, creepages, results) = unsafe {
        (
            arrays::input(contacts, count),
            arrays::input(creepages, count),
            arrays::output(results, count),
        )
    };
    calls::solve_batch(contacts, creepages, options, results)
}

/// What each strip carries. The shares add up to the totals of kstrip_solve().
///
/// @param[out] strips     array that receives the strips.
/// @param capacity        its size; KSTRIP_STRIPS_CAPACITY is always enough, options->strips is when
///                        |psi| <= 1.
/// @param[out] count      receives how many were written. A patch that slides as a whole has fewer
///                        strips than asked for.
/// @return as kstrip_solve(); KSTRIP_ERROR_CAPACITY, KSTRIP_ERROR_NOT_IN_MODEL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_strips(
    contact: Option<&kstrip_contact>,
    creepage: Option<&kstrip_creepage>,
    options: Option<&kstrip_options>,
    strips: *mut kstrip_strip,
    capacity: u32,
    count: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    // SAFETY: NULL or capacity elements, says the header.
    let strips = unsafe { arrays::output(strips, capacity) };
    calls::strips(contact, creepage, options, strips, count)
}

/// Pressure, traction, slip and state at a point of the contact plane.
///
/// @param x, y            the point [m], from the centre of the ellipse; outside is allowed.
/// @param[out] point      receives the state.
/// @return as kstrip_solve(); KSTRIP_ERROR_NOT_IN_MODEL.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_traction_at(
    contact: Option<&kstrip_contact>,
    creepage: Option<&kstrip_creepage>,
    options: Option<&kstrip_options>,
    x: f64,
    y: f64,
    point: Option<&mut MaybeUninit<kstrip_point>>,
) -> kstrip_status {
    calls::traction_at(contact, creepage, options, x, y, point)
}

/// Pressure, traction, slip and state over a grid.
///
/// @param x, columns      array of x [m] and its size.
/// @param y, rows         array of y [m] and its size.
/// @param[out] points     array of rows * columns elements; the point (x[i], y[j]) is
///                        points[j * columns + i].
/// @param capacity        its size.
/// @return as kstrip_solve(); KSTRIP_ERROR_CAPACITY, KSTRIP_ERROR_NOT_IN_MODEL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_field(
    contact: Option<&kstrip_contact>,
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
    calls::field(contact, creepage, options, x, y, points)
}

/// The same result seen from the upper body: opposite forces and moment, same power and adhesion.
///
/// @param lower           result on the lower body.
/// @param[out] upper      receives the result on the upper body.
/// @return KSTRIP_OK or KSTRIP_ERROR_NULL.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_result_on_upper_body(
    lower: Option<&kstrip_result>,
    upper: Option<&mut MaybeUninit<kstrip_result>>,
) -> kstrip_status {
    calls::result_on_upper_body(lower, upper)
}
