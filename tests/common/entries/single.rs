//! The functions in single precision under the names that they have in double precision.

use kstrip::ffi::single::{
    kstrip_contact_from_approach_f32 as kstrip_contact_from_approach,
    kstrip_contact_from_hertz_f32 as kstrip_contact_from_hertz,
    kstrip_contacts_from_gap_f32 as kstrip_contacts_from_gap,
    kstrip_creepage_for_force_f32 as kstrip_creepage_for_force,
    kstrip_creepage_from_parameters_f32 as kstrip_creepage_from_parameters,
    kstrip_creepage_from_velocities_f32 as kstrip_creepage_from_velocities,
    kstrip_estimate_friction_f32 as kstrip_estimate_friction,
    kstrip_evaluate_batch_f32 as kstrip_evaluate_batch, kstrip_evaluate_f32 as kstrip_evaluate,
    kstrip_field_f32 as kstrip_field, kstrip_height_for_load_f32 as kstrip_height_for_load,
    kstrip_linear_coefficients_f32 as kstrip_linear_coefficients,
    kstrip_material_combine_f32 as kstrip_material_combine,
    kstrip_parameters_from_creepage_f32 as kstrip_parameters_from_creepage,
    kstrip_patch_evaluate_f32 as kstrip_patch_evaluate,
    kstrip_patch_field_f32 as kstrip_patch_field,
    kstrip_patch_from_contact_f32 as kstrip_patch_from_contact,
    kstrip_patch_from_profile_f32 as kstrip_patch_from_profile,
    kstrip_patch_from_strips_f32 as kstrip_patch_from_strips,
    kstrip_patch_summarize_f32 as kstrip_patch_summarize, kstrip_prepare_f32 as kstrip_prepare,
    kstrip_prepare_profile_f32 as kstrip_prepare_profile,
    kstrip_result_on_upper_body_f32 as kstrip_result_on_upper_body,
    kstrip_solve_f32 as kstrip_solve, kstrip_solve_linear_f32 as kstrip_solve_linear,
    kstrip_solve_motion_f32 as kstrip_solve_motion,
    kstrip_solve_prepared_f32 as kstrip_solve_prepared,
    kstrip_solve_strip_1967_f32 as kstrip_solve_strip_1967,
    kstrip_solve_strip_f32 as kstrip_solve_strip, kstrip_solve_total_f32 as kstrip_solve_total,
    kstrip_touch_f32 as kstrip_touch, kstrip_wheel_motion_f32 as kstrip_wheel_motion,
    kstrip_wheel_on_rail_f32 as kstrip_wheel_on_rail,
    kstrip_wrench_from_contacts_f32 as kstrip_wrench_from_contacts,
};

pub type Float = f32;

#[path = "arguments.rs"]
pub mod arguments;
#[path = "arrays.rs"]
pub mod arrays;
#[path = "contacts.rs"]
pub mod contacts;
#[path = "patches.rs"]
pub mod patches;
#[path = "wheels.rs"]
pub mod wheels;
use super::structures::single::*;
