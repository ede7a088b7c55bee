//! Exported functions of patches in single precision.

use super::patch_types::*;
use super::types::kstrip_options;
use super::types_f32::{
    kstrip_contact_f32, kstrip_creepage_f32, kstrip_point_f32, kstrip_result_f32, kstrip_strip_f32,
};
use super::{arrays, kstrip_status, patch_calls};
use core::mem::MaybeUninit;

/// kstrip_patch_from_ellipse() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_patch_from_ellipse_f32(
    contact: Option<&kstrip_contact_f32>,
    strips: i32,
    patch: Option<&mut MaybeUninit<kstrip_patch_f32>>,
) -> kstrip_status {
    patch_calls::from_ellipse(contact, strips, patch)
}

/// kstrip_patch_from_strips() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_patch_from_strips_f32(
    strips: *const kstrip_patch_strip_f32,
    count: u32,
    shear_modulus: f32,
    poisson_ratio: f32,
    patch: Option<&mut MaybeUninit<kstrip_patch_f32>>,
) -> kstrip_status {
    // SAFETY: NULL or count elements, says the header.
    let strips = unsafe { arrays::input(strips, count) };
    patch_calls::from_strips(strips, shear_modulus, poisson_ratio, patch)
}

/// kstrip_patch_from_profile() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_patch_from_profile_f32(
    y: *const f32,
    distance: *const f32,
    points: u32,
    contact: Option<&kstrip_profile_contact_f32>,
    strips: i32,
    patch: Option<&mut MaybeUninit<kstrip_patch_f32>>,
    result: Option<&mut MaybeUninit<kstrip_profile_result_f32>>,
) -> kstrip_status {
    // SAFETY: NULL or as many elements as points says, says the header.
    let (y, distance) = unsafe { (arrays::input(y, points), arrays::input(distance, points)) };
    patch_calls::from_profile(y, distance, contact, strips, patch, result)
}

/// kstrip_patch_summarize() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_patch_summarize_f32(
    patch: Option<&kstrip_patch_f32>,
    summary: Option<&mut MaybeUninit<kstrip_patch_summary_f32>>,
) -> kstrip_status {
    patch_calls::summary(patch, summary)
}

/// kstrip_patch_solve() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_patch_solve_f32(
    patch: Option<&kstrip_patch_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result_f32>>,
) -> kstrip_status {
    patch_calls::solve(patch, creepage, options, result)
}

/// kstrip_patch_jacobian() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_patch_jacobian_f32(
    patch: Option<&kstrip_patch_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result_f32>>,
    jacobian: *mut f32,
) -> kstrip_status {
    // SAFETY: NULL or nine writable numbers, says the header.
    let jacobian = unsafe { arrays::output(jacobian, 9) };
    patch_calls::jacobian(patch, creepage, options, result, jacobian)
}

/// kstrip_patch_strips() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_patch_strips_f32(
    patch: Option<&kstrip_patch_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    options: Option<&kstrip_options>,
    strips: *mut kstrip_strip_f32,
    capacity: u32,
    count: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    // SAFETY: NULL or capacity elements, says the header.
    let strips = unsafe { arrays::output(strips, capacity) };
    patch_calls::strips(patch, creepage, options, strips, count)
}

/// kstrip_patch_traction_at() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_patch_traction_at_f32(
    patch: Option<&kstrip_patch_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    options: Option<&kstrip_options>,
    x: f32,
    y: f32,
    point: Option<&mut MaybeUninit<kstrip_point_f32>>,
) -> kstrip_status {
    patch_calls::traction_at(patch, creepage, options, x, y, point)
}

/// kstrip_patch_field() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_patch_field_f32(
    patch: Option<&kstrip_patch_f32>,
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
    patch_calls::field(patch, creepage, options, x, y, points)
}
