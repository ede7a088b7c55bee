//! Exported functions in single precision, for controllers without a double-precision unit.

use super::types::kstrip_options;
use super::types_f32::*;
use super::{arrays, calls, kstrip_status};
use core::mem::MaybeUninit;

/// kstrip_material_from_youngs_modulus() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_material_from_youngs_modulus_f32(
    youngs_modulus: f32,
    poisson_ratio: f32,
    material: Option<&mut MaybeUninit<kstrip_material_f32>>,
) -> kstrip_status {
    calls::material_from_youngs_modulus(youngs_modulus, poisson_ratio, material)
}

/// kstrip_material_combine() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_material_combine_f32(
    lower: Option<&kstrip_material_f32>,
    upper: Option<&kstrip_material_f32>,
    combined: Option<&mut MaybeUninit<kstrip_combined_material_f32>>,
) -> kstrip_status {
    calls::material_combine(lower, upper, combined)
}

/// kstrip_hertz() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_hertz_f32(
    radii: Option<&kstrip_radii_f32>,
    normal_force: f32,
    material: Option<&kstrip_combined_material_f32>,
    ellipse: Option<&mut MaybeUninit<kstrip_hertz_contact_f32>>,
) -> kstrip_status {
    calls::hertz(radii, normal_force, material, ellipse)
}

/// kstrip_creepage_from_velocities() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_creepage_from_velocities_f32(
    lower: Option<&kstrip_velocity_f32>,
    upper: Option<&kstrip_velocity_f32>,
    rolling_speed: f32,
    creepage: Option<&mut MaybeUninit<kstrip_creepage_f32>>,
) -> kstrip_status {
    calls::creepage_from_velocities(lower, upper, rolling_speed, creepage)
}

/// kstrip_parameters_from_creepage() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_parameters_from_creepage_f32(
    contact: Option<&kstrip_contact_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    parameters: Option<&mut MaybeUninit<kstrip_parameters_f32>>,
) -> kstrip_status {
    calls::parameters_from_creepage(contact, creepage, parameters)
}

/// kstrip_creepage_from_parameters() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_creepage_from_parameters_f32(
    contact: Option<&kstrip_contact_f32>,
    parameters: Option<&kstrip_parameters_f32>,
    creepage: Option<&mut MaybeUninit<kstrip_creepage_f32>>,
) -> kstrip_status {
    calls::creepage_from_parameters(contact, parameters, creepage)
}

/// kstrip_solve() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_f32(
    contact: Option<&kstrip_contact_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result_f32>>,
) -> kstrip_status {
    calls::solve(contact, creepage, options, result)
}

/// kstrip_solve_jacobian() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_solve_jacobian_f32(
    contact: Option<&kstrip_contact_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result_f32>>,
    jacobian: *mut f32,
) -> kstrip_status {
    // SAFETY: NULL or nine writable numbers, says the header.
    let jacobian = unsafe { arrays::output(jacobian, 9) };
    calls::solve_jacobian(contact, creepage, options, result, jacobian)
}

/// kstrip_solve_batch() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_solve_batch_f32(
    contacts: *const kstrip_contact_f32,
    creepages: *const kstrip_creepage_f32,
    count: u32,
    options: Option<&kstrip_options>,
    results: *mut kstrip_result_f32,
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

/// kstrip_strips() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_strips_f32(
    contact: Option<&kstrip_contact_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    options: Option<&kstrip_options>,
    strips: *mut kstrip_strip_f32,
    capacity: u32,
    count: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    // SAFETY: NULL or capacity elements, says the header.
    let strips = unsafe { arrays::output(strips, capacity) };
    calls::strips(contact, creepage, options, strips, count)
}

/// kstrip_traction_at() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_traction_at_f32(
    contact: Option<&kstrip_contact_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    options: Option<&kstrip_options>,
    x: f32,
    y: f32,
    point: Option<&mut MaybeUninit<kstrip_point_f32>>,
) -> kstrip_status {
    calls::traction_at(contact, creepage, options, x, y, point)
}

/// kstrip_field() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_field_f32(
    contact: Option<&kstrip_contact_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    options: Option<&kstrip_options>,
    x: *const f32,
    columns: u32,
    y: *const f32,
    rows: u32,
    points: *mut kstrip_point_f32,
    capacity: u32,
) -> kstrip_status {
    // SAFETY: NULL or as many elements as the counts say, says the header.
    let (x, y, points) = unsafe {
        (arrays::input(x, columns), arrays::input(y, rows), arrays::output(points, capacity))
    };
    calls::field(contact, creepage, options, x, y, points)
}

/// kstrip_result_on_upper_body() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_result_on_upper_body_f32(
    lower: Option<&kstrip_result_f32>,
    upper: Option<&mut MaybeUninit<kstrip_result_f32>>,
) -> kstrip_status {
    calls::result_on_upper_body(lower, upper)
}
