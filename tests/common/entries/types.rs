//! The structures of the C interface under their names in C, in the precision of the module around.
#![allow(dead_code, non_camel_case_types)]

use super::Float;

pub type kstrip_contact = kstrip::contact::Contact<Float>;
pub type kstrip_creepage = kstrip::contact::creepage::Creepage<Float>;
pub type kstrip_velocity = kstrip::contact::creepage::SurfaceVelocity<Float>;
pub type kstrip_parameters = kstrip::ffi::types::KalkerParameters<Float>;
pub type kstrip_material = kstrip::contact::material::Material<Float>;
pub type kstrip_combined_material = kstrip::contact::material::CombinedMaterial<Float>;
pub type kstrip_radii = kstrip::contact::hertz::Radii<Float>;
pub type kstrip_hertz_contact = kstrip::contact::hertz::HertzContact<Float>;
pub type kstrip_friction = kstrip::friction::SlipFriction<Float>;
pub type kstrip_result = kstrip::solve::model::Solution<Float>;
pub type kstrip_strip = kstrip::solve::model::StripResult<Float>;
pub type kstrip_point = kstrip::solve::field::FieldPoint<Float>;
pub type kstrip_derivatives = kstrip::solve::derivatives::Derivatives<Float>;
pub type kstrip_law_derivatives = kstrip::solve::derivatives::LawDerivatives<Float>;
pub type kstrip_outputs = kstrip::ffi::types::Outputs<Float>;
pub type kstrip_batch_inputs = kstrip::ffi::types::BatchInputs<Float>;
pub type kstrip_batch_outputs = kstrip::ffi::types::BatchOutputs<Float>;
pub type kstrip_prepared = kstrip::ffi::types::PreparedNumbers<Float>;
pub type kstrip_motion = kstrip::solve::motion::Motion<Float>;
pub type kstrip_motion_derivatives = kstrip::solve::motion::MotionDerivatives<Float>;
pub type kstrip_motion_outputs = kstrip::ffi::types::MotionOutputs<Float>;
pub type kstrip_patch_strip = kstrip::patch::PatchStrip<Float>;
pub type kstrip_patch = kstrip::ffi::types::StoredPatch<Float>;
pub type kstrip_patch_summary = kstrip::ffi::types::PatchSummary<Float>;
pub type kstrip_profile = kstrip::ffi::types::ProfilePoints<Float>;
pub type kstrip_profile_contact = kstrip::ffi::types::ProfileOptions<Float>;
pub type kstrip_profile_result = kstrip::patch::profile::Indentation<Float>;
pub type kstrip_friction_estimate = kstrip::rig::FrictionEstimate<Float>;
pub type kstrip_surface = kstrip::wheel_rail::surface::Surface<Float>;
pub type kstrip_wheel_position = kstrip::wheel_rail::Position<Float>;
pub type kstrip_wheel_velocity = kstrip::wheel_rail::Velocity<Float>;
pub type kstrip_wheel_pair = kstrip::wheel_rail::Pair<Float>;
pub type kstrip_gap = kstrip::wheel_rail::touch::Gap<Float>;
pub type kstrip_wheel_contact = kstrip::wheel_rail::contacts::WheelContact<Float>;
pub type kstrip_wheel_workspace = kstrip::wheel_rail::scene::Workspace<Float>;
pub type kstrip_wrench = kstrip::wheel_rail::wrench::Wrench<Float>;
pub type kstrip_wrench_derivatives = kstrip::wheel_rail::wrench::WrenchDerivatives<Float>;
pub type kstrip_wrench_by_position = kstrip::wheel_rail::wrench::WrenchByPosition<Float>;
