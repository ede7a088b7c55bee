//! The functions in single precision under the names that they have in double precision.

use kstrip::ffi::batch::{
    kstrip_batch_inputs_f32 as kstrip_batch_inputs,
    kstrip_batch_outputs_f32 as kstrip_batch_outputs,
    kstrip_solve_batch_arrays_f32 as kstrip_solve_batch_arrays,
};
use kstrip::ffi::derivatives::{
    kstrip_derivatives_f32 as kstrip_derivatives,
    kstrip_solve_derivatives_f32 as kstrip_solve_derivatives,
    kstrip_solve_jacobian_batch_f32 as kstrip_solve_jacobian_batch,
};
use kstrip::ffi::evaluate::kstrip_evaluate_f32 as kstrip_evaluate;
use kstrip::ffi::friction::{
    kstrip_contact_under_friction_f32 as kstrip_contact_under_friction,
    kstrip_friction_f32 as kstrip_friction, kstrip_solve_friction_f32 as kstrip_solve_friction,
    kstrip_solve_friction_jacobian_f32 as kstrip_solve_friction_jacobian,
};
use kstrip::ffi::patch_friction::{
    kstrip_patch_solve_friction_f32 as kstrip_patch_solve_friction,
    kstrip_patch_solve_friction_jacobian_f32 as kstrip_patch_solve_friction_jacobian,
    kstrip_patch_under_friction_f32 as kstrip_patch_under_friction,
};
use kstrip::ffi::patch_single::{
    kstrip_patch_field_f32 as kstrip_patch_field,
    kstrip_patch_from_ellipse_f32 as kstrip_patch_from_ellipse,
    kstrip_patch_from_profile_f32 as kstrip_patch_from_profile,
    kstrip_patch_from_strips_f32 as kstrip_patch_from_strips,
    kstrip_patch_jacobian_f32 as kstrip_patch_jacobian,
    kstrip_patch_solve_f32 as kstrip_patch_solve, kstrip_patch_strips_f32 as kstrip_patch_strips,
    kstrip_patch_summarize_f32 as kstrip_patch_summarize,
    kstrip_patch_traction_at_f32 as kstrip_patch_traction_at,
};
use kstrip::ffi::patch_types::{
    kstrip_patch_f32 as kstrip_patch, kstrip_patch_strip_f32 as kstrip_patch_strip,
    kstrip_patch_summary_f32 as kstrip_patch_summary,
    kstrip_profile_contact_f32 as kstrip_profile_contact,
    kstrip_profile_result_f32 as kstrip_profile_result,
};
use kstrip::ffi::per_model::{
    kstrip_solve_linear_f32 as kstrip_solve_linear,
    kstrip_solve_strip_1967_f32 as kstrip_solve_strip_1967,
    kstrip_solve_strip_f32 as kstrip_solve_strip, kstrip_solve_total_f32 as kstrip_solve_total,
};
use kstrip::ffi::rig::{
    kstrip_creepage_for_force_f32 as kstrip_creepage_for_force,
    kstrip_estimate_friction_f32 as kstrip_estimate_friction,
    kstrip_friction_estimate_f32 as kstrip_friction_estimate,
};
use kstrip::ffi::single::{
    kstrip_creepage_from_parameters_f32 as kstrip_creepage_from_parameters,
    kstrip_creepage_from_velocities_f32 as kstrip_creepage_from_velocities,
    kstrip_field_f32 as kstrip_field, kstrip_hertz_f32 as kstrip_hertz,
    kstrip_material_combine_f32 as kstrip_material_combine,
    kstrip_material_from_youngs_modulus_f32 as kstrip_material_from_youngs_modulus,
    kstrip_parameters_from_creepage_f32 as kstrip_parameters_from_creepage,
    kstrip_result_on_upper_body_f32 as kstrip_result_on_upper_body,
    kstrip_solve_batch_f32 as kstrip_solve_batch, kstrip_solve_f32 as kstrip_solve,
    kstrip_solve_jacobian_f32 as kstrip_solve_jacobian, kstrip_strips_f32 as kstrip_strips,
    kstrip_traction_at_f32 as kstrip_traction_at,
};
use kstrip::ffi::types_f32::{
    kstrip_combined_material_f32 as kstrip_combined_material, kstrip_contact_f32 as kstrip_contact,
    kstrip_creepage_f32 as kstrip_creepage, kstrip_hertz_contact_f32 as kstrip_hertz_contact,
    kstrip_material_f32 as kstrip_material, kstrip_parameters_f32 as kstrip_parameters,
    kstrip_point_f32 as kstrip_point, kstrip_radii_f32 as kstrip_radii,
    kstrip_result_f32 as kstrip_result, kstrip_strip_f32 as kstrip_strip,
    kstrip_velocity_f32 as kstrip_velocity,
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
