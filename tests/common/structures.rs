//! The structures of the C interface under their names in C, in each precision.
#![allow(non_camel_case_types)]

macro_rules! structures {
    ($float:ident) => {
        pub type kstrip_contact = kstrip::contact::Contact<$float>;
        pub type kstrip_creepage = kstrip::contact::creepage::Creepage<$float>;
        pub type kstrip_velocity = kstrip::contact::creepage::SurfaceVelocity<$float>;
        pub type kstrip_parameters = kstrip::ffi::types::KalkerParameters<$float>;
        pub type kstrip_material = kstrip::contact::material::Material<$float>;
        pub type kstrip_combined_material = kstrip::contact::material::CombinedMaterial<$float>;
        pub type kstrip_radii = kstrip::contact::hertz::Radii<$float>;
        pub type kstrip_hertz_contact = kstrip::contact::hertz::HertzContact<$float>;
        pub type kstrip_friction = kstrip::friction::SlipFriction<$float>;
        pub type kstrip_result = kstrip::forces::Solution<$float>;
        pub type kstrip_strip = kstrip::forces::StripResult<$float>;
        pub type kstrip_point = kstrip::forces::field::FieldPoint<$float>;
        pub type kstrip_derivatives = kstrip::forces::derivatives::Derivatives<$float>;
        pub type kstrip_law_derivatives = kstrip::friction::derivatives::LawDerivatives<$float>;
        pub type kstrip_outputs = kstrip::ffi::types::Outputs<$float>;
        pub type kstrip_batch_inputs = kstrip::ffi::types::BatchInputs<$float>;
        pub type kstrip_batch_outputs = kstrip::ffi::types::BatchOutputs<$float>;
        pub type kstrip_prepared = kstrip::forces::prepared::Prepared<$float>;
        pub type kstrip_motion = kstrip::motion::Motion<$float>;
        pub type kstrip_motion_derivatives = kstrip::motion::MotionDerivatives<$float>;
        pub type kstrip_motion_outputs = kstrip::ffi::types::MotionOutputs<$float>;
        pub type kstrip_patch_strip = kstrip::patch::PatchStrip<$float>;
        pub type kstrip_patch = kstrip::ffi::types::Patch<$float>;
        pub type kstrip_patch_summary = kstrip::ffi::types::PatchSummary<$float>;
        pub type kstrip_profile = kstrip::ffi::types::ProfilePoints<$float>;
        pub type kstrip_profile_contact = kstrip::ffi::types::ProfileOptions<$float>;
        pub type kstrip_profile_result = kstrip::normal::Indentation<$float>;
        pub type kstrip_friction_estimate = kstrip::rig::FrictionEstimate<$float>;
        pub type kstrip_measured_force = kstrip::rig::fit::MeasuredForce<$float>;
        pub type kstrip_friction_fit = kstrip::rig::fit::FrictionFit<$float>;
        pub type kstrip_surface = kstrip::wheel_rail::profile::PreparedProfile<$float>;
        pub type kstrip_wheel_position = kstrip::wheel_rail::Position<$float>;
        pub type kstrip_wheel_velocity = kstrip::wheel_rail::Velocity<$float>;
        pub type kstrip_wheel_pair = kstrip::wheel_rail::WheelPair<$float>;
        pub type kstrip_gap = kstrip::wheel_rail::touch::Gap<$float>;
        pub type kstrip_strip_power = kstrip::wheel_rail::forces::across::StripPower<$float>;
        pub type kstrip_wheel_contact = kstrip::wheel_rail::contacts::WheelContact<$float>;
        pub type kstrip_wheel_workspace = kstrip::wheel_rail::scene::Workspace<$float>;
        pub type kstrip_wrench = kstrip::wheel_rail::forces::wrench::Wrench<$float>;
        pub type kstrip_table_spec = kstrip::table::TableSpec<$float>;
        pub type kstrip_table_report = kstrip::table::TableReport<$float>;
        pub type kstrip_wrench_derivatives =
            kstrip::wheel_rail::forces::wrench::WrenchDerivatives<$float>;
        pub type kstrip_wrench_by_position =
            kstrip::wheel_rail::forces::wrench::WrenchByPosition<$float>;
        pub type kstrip_rail_motion = kstrip::wheelset::track::RailMotion<$float>;
        pub type kstrip_track = kstrip::ffi::types::Track<$float>;
        pub type kstrip_curve = kstrip::wheelset::track::Curve<$float>;
        pub type kstrip_wheelset = kstrip::ffi::types::WheelsetParts<$float>;
        pub type kstrip_wheelset_workspace = kstrip::wheelset::forces::WheelsetWorkspace<$float>;
        pub type kstrip_wheelset_forces = kstrip::wheelset::forces::WheelsetForces<$float>;
        pub type kstrip_wheelset_derivatives =
            kstrip::wheelset::forces::WheelsetDerivatives<$float>;
        pub type kstrip_wheelset_by_position = kstrip::wheelset::forces::WheelsetByPosition<$float>;
        pub type kstrip_wheelset_loads = kstrip::wheelset::settle::WheelsetLoads<$float>;
    };
}

pub mod double {
    structures!(f64);
}

/// Those whose names end with `_f32` in C.
pub mod single {
    structures!(f32);
}
