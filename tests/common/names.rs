//! The structures and functions of the C interface under their names in C.
#![allow(dead_code, non_camel_case_types, unused_imports)]

pub use kstrip::ffi::batch::*;
pub use kstrip::ffi::bodies::*;
pub use kstrip::ffi::inside::*;
pub use kstrip::ffi::motion::*;
pub use kstrip::ffi::patch::*;
pub use kstrip::ffi::rig::*;
pub use kstrip::ffi::single::*;
pub use kstrip::ffi::solve::*;
pub use kstrip::ffi::types::kstrip_options;
pub use kstrip::ffi::wheel_rail::*;
pub use kstrip::ffi::*;

pub type kstrip_contact = kstrip::contact::Contact<f64>;
pub type kstrip_contact_f32 = kstrip::contact::Contact<f32>;
pub type kstrip_creepage = kstrip::contact::creepage::Creepage<f64>;
pub type kstrip_creepage_f32 = kstrip::contact::creepage::Creepage<f32>;
pub type kstrip_velocity = kstrip::contact::creepage::SurfaceVelocity<f64>;
pub type kstrip_velocity_f32 = kstrip::contact::creepage::SurfaceVelocity<f32>;
pub type kstrip_parameters = kstrip::ffi::types::KalkerParameters<f64>;
pub type kstrip_parameters_f32 = kstrip::ffi::types::KalkerParameters<f32>;
pub type kstrip_material = kstrip::contact::material::Material<f64>;
pub type kstrip_material_f32 = kstrip::contact::material::Material<f32>;
pub type kstrip_combined_material = kstrip::contact::material::CombinedMaterial<f64>;
pub type kstrip_combined_material_f32 = kstrip::contact::material::CombinedMaterial<f32>;
pub type kstrip_radii = kstrip::contact::hertz::Radii<f64>;
pub type kstrip_radii_f32 = kstrip::contact::hertz::Radii<f32>;
pub type kstrip_hertz_contact = kstrip::contact::hertz::HertzContact<f64>;
pub type kstrip_hertz_contact_f32 = kstrip::contact::hertz::HertzContact<f32>;
pub type kstrip_friction = kstrip::friction::SlipFriction<f64>;
pub type kstrip_friction_f32 = kstrip::friction::SlipFriction<f32>;
pub type kstrip_result = kstrip::solve::model::Solution<f64>;
pub type kstrip_result_f32 = kstrip::solve::model::Solution<f32>;
pub type kstrip_strip = kstrip::solve::model::StripResult<f64>;
pub type kstrip_strip_f32 = kstrip::solve::model::StripResult<f32>;
pub type kstrip_point = kstrip::solve::field::FieldPoint<f64>;
pub type kstrip_point_f32 = kstrip::solve::field::FieldPoint<f32>;
pub type kstrip_derivatives = kstrip::solve::derivatives::Derivatives<f64>;
pub type kstrip_derivatives_f32 = kstrip::solve::derivatives::Derivatives<f32>;
pub type kstrip_law_derivatives = kstrip::solve::derivatives::LawDerivatives<f64>;
pub type kstrip_law_derivatives_f32 = kstrip::solve::derivatives::LawDerivatives<f32>;
pub type kstrip_outputs = kstrip::ffi::types::Outputs<f64>;
pub type kstrip_outputs_f32 = kstrip::ffi::types::Outputs<f32>;
pub type kstrip_batch_inputs = kstrip::ffi::types::BatchInputs<f64>;
pub type kstrip_batch_inputs_f32 = kstrip::ffi::types::BatchInputs<f32>;
pub type kstrip_batch_outputs = kstrip::ffi::types::BatchOutputs<f64>;
pub type kstrip_batch_outputs_f32 = kstrip::ffi::types::BatchOutputs<f32>;
pub type kstrip_prepared = kstrip::ffi::types::PreparedNumbers<f64>;
pub type kstrip_prepared_f32 = kstrip::ffi::types::PreparedNumbers<f32>;
pub type kstrip_motion = kstrip::solve::motion::Motion<f64>;
pub type kstrip_motion_f32 = kstrip::solve::motion::Motion<f32>;
pub type kstrip_motion_derivatives = kstrip::solve::motion::MotionDerivatives<f64>;
pub type kstrip_motion_derivatives_f32 = kstrip::solve::motion::MotionDerivatives<f32>;
pub type kstrip_motion_outputs = kstrip::ffi::types::MotionOutputs<f64>;
pub type kstrip_motion_outputs_f32 = kstrip::ffi::types::MotionOutputs<f32>;
pub type kstrip_patch_strip = kstrip::patch::PatchStrip<f64>;
pub type kstrip_patch_strip_f32 = kstrip::patch::PatchStrip<f32>;
pub type kstrip_patch = kstrip::ffi::types::StoredPatch<f64>;
pub type kstrip_patch_f32 = kstrip::ffi::types::StoredPatch<f32>;
pub type kstrip_patch_summary = kstrip::ffi::types::PatchSummary<f64>;
pub type kstrip_patch_summary_f32 = kstrip::ffi::types::PatchSummary<f32>;
pub type kstrip_profile = kstrip::ffi::types::ProfilePoints<f64>;
pub type kstrip_profile_f32 = kstrip::ffi::types::ProfilePoints<f32>;
pub type kstrip_profile_contact = kstrip::ffi::types::ProfileOptions<f64>;
pub type kstrip_profile_contact_f32 = kstrip::ffi::types::ProfileOptions<f32>;
pub type kstrip_profile_result = kstrip::patch::profile::Indentation<f64>;
pub type kstrip_profile_result_f32 = kstrip::patch::profile::Indentation<f32>;
pub type kstrip_friction_estimate = kstrip::rig::FrictionEstimate<f64>;
pub type kstrip_surface = kstrip::wheel_rail::surface::Surface<f64>;
pub type kstrip_wheel_position = kstrip::wheel_rail::Position<f64>;
pub type kstrip_wheel_velocity = kstrip::wheel_rail::Velocity<f64>;
pub type kstrip_wheel_pair = kstrip::wheel_rail::Pair<f64>;
pub type kstrip_gap = kstrip::wheel_rail::touch::Gap<f64>;
pub type kstrip_wheel_contact = kstrip::wheel_rail::contacts::WheelContact<f64>;
pub type kstrip_wheel_workspace = kstrip::wheel_rail::scene::Workspace<f64>;
pub type kstrip_wrench = kstrip::wheel_rail::wrench::Wrench<f64>;
pub type kstrip_wrench_derivatives = kstrip::wheel_rail::wrench::WrenchDerivatives<f64>;
pub type kstrip_wrench_by_position = kstrip::wheel_rail::wrench::WrenchByPosition<f64>;
pub type kstrip_friction_estimate_f32 = kstrip::rig::FrictionEstimate<f32>;
pub type kstrip_surface_f32 = kstrip::wheel_rail::surface::Surface<f32>;
pub type kstrip_wheel_position_f32 = kstrip::wheel_rail::Position<f32>;
pub type kstrip_wheel_velocity_f32 = kstrip::wheel_rail::Velocity<f32>;
pub type kstrip_wheel_pair_f32 = kstrip::wheel_rail::Pair<f32>;
pub type kstrip_gap_f32 = kstrip::wheel_rail::touch::Gap<f32>;
pub type kstrip_wheel_contact_f32 = kstrip::wheel_rail::contacts::WheelContact<f32>;
pub type kstrip_wheel_workspace_f32 = kstrip::wheel_rail::scene::Workspace<f32>;
pub type kstrip_wrench_f32 = kstrip::wheel_rail::wrench::Wrench<f32>;
pub type kstrip_wrench_derivatives_f32 = kstrip::wheel_rail::wrench::WrenchDerivatives<f32>;
pub type kstrip_wrench_by_position_f32 = kstrip::wheel_rail::wrench::WrenchByPosition<f32>;

/// No output.
pub const fn nowhere<F>() -> kstrip::ffi::types::Outputs<F> {
    use std::ptr::null_mut;
    kstrip::ffi::types::Outputs {
        result: null_mut(),
        derivatives: null_mut(),
        law_derivatives: null_mut(),
        friction: null_mut(),
        strips: null_mut(),
        count: null_mut(),
        capacity: 0,
        reserved: 0,
    }
}

/// No output of a batch.
pub const fn no_batch<F>() -> kstrip::ffi::types::BatchOutputs<F> {
    use std::ptr::null_mut;
    kstrip::ffi::types::BatchOutputs {
        fx: null_mut(),
        fx_stride: 0,
        fy: null_mut(),
        fy_stride: 0,
        mz: null_mut(),
        mz_stride: 0,
        power: null_mut(),
        power_stride: 0,
        adhesion: null_mut(),
        adhesion_stride: 0,
        status_detail: null_mut(),
        status_detail_stride: 0,
        friction: null_mut(),
        friction_stride: 0,
        derivatives: null_mut(),
        derivatives_stride: 0,
        law_derivatives: null_mut(),
        law_derivatives_stride: 0,
    }
}

/// A contact and its creepage from their numbers, the mismatch last.
pub fn problem<F>(
    numbers: [F; 10],
) -> (kstrip::contact::Contact<F>, kstrip::contact::creepage::Creepage<F>) {
    let [
        a,
        b,
        normal_force,
        shear_modulus,
        poisson_ratio,
        friction,
        longitudinal,
        lateral,
        spin,
        mismatch,
    ] = numbers;
    (
        kstrip::contact::Contact {
            a,
            b,
            normal_force,
            shear_modulus,
            poisson_ratio,
            friction,
            mismatch,
        },
        kstrip::contact::creepage::Creepage { longitudinal, lateral, spin },
    )
}

/// Inputs of a batch by the first number of each quantity and its stride, the mismatch last.
pub fn batch_from<F>(
    quantity: impl FnMut(usize) -> (*const F, isize),
) -> kstrip::ffi::types::BatchInputs<F> {
    let [
        (a, a_stride),
        (b, b_stride),
        (normal_force, normal_force_stride),
        (shear_modulus, shear_modulus_stride),
        (poisson_ratio, poisson_ratio_stride),
        (friction, friction_stride),
        (longitudinal, longitudinal_stride),
        (lateral, lateral_stride),
        (spin, spin_stride),
        (mismatch, mismatch_stride),
    ] = std::array::from_fn(quantity);
    kstrip::ffi::types::BatchInputs {
        a,
        a_stride,
        b,
        b_stride,
        normal_force,
        normal_force_stride,
        shear_modulus,
        shear_modulus_stride,
        poisson_ratio,
        poisson_ratio_stride,
        friction,
        friction_stride,
        mismatch,
        mismatch_stride,
        longitudinal,
        longitudinal_stride,
        lateral,
        lateral_stride,
        spin,
        spin_stride,
        law: std::ptr::null(),
        law_stride: 0,
    }
}

/// Inputs of a batch that lie in arrays of structures.
pub fn batch_inputs<F>(
    contacts: *const kstrip::contact::Contact<F>,
    creepages: *const kstrip::contact::creepage::Creepage<F>,
) -> kstrip::ffi::types::BatchInputs<F> {
    let contact = size_of::<kstrip::contact::Contact<F>>() as isize;
    let creepage = size_of::<kstrip::contact::creepage::Creepage<F>>() as isize;
    batch_from(|i| match i {
        ..6 => (contacts.cast::<F>().wrapping_add(i), contact),
        6..9 => (creepages.cast::<F>().wrapping_add(i - 6), creepage),
        _ => (contacts.cast::<F>().wrapping_add(6), contact),
    })
}

/// Inputs of a batch that lie in one array for each quantity, the mismatch last.
pub fn batch_arrays<F>(arrays: [*const F; 10]) -> kstrip::ffi::types::BatchInputs<F> {
    batch_from(|i| (arrays[i], size_of::<F>() as isize))
}

/// Results of a batch: fx, fy, mz, power, adhesion, by their first number; the statuses; strides.
fn results_at<F>(
    [fx, fy, mz, power, adhesion]: [*mut F; 5],
    stride: isize,
    details: *mut i32,
    details_stride: isize,
) -> kstrip::ffi::types::BatchOutputs<F> {
    kstrip::ffi::types::BatchOutputs {
        fx,
        fx_stride: stride,
        fy,
        fy_stride: stride,
        mz,
        mz_stride: stride,
        power,
        power_stride: stride,
        adhesion,
        adhesion_stride: stride,
        status_detail: details,
        status_detail_stride: details_stride,
        ..no_batch()
    }
}

/// Results of a batch as an array of structures.
pub fn batch_results<F>(
    results: *mut kstrip::solve::model::Solution<F>,
) -> kstrip::ffi::types::BatchOutputs<F> {
    let stride = size_of::<kstrip::solve::model::Solution<F>>() as isize;
    let member = |i: usize| results.cast::<F>().wrapping_add(i);
    results_at(std::array::from_fn(member), stride, member(5).cast(), stride)
}

/// Results of a batch as one array for each quantity: fx, fy, mz, power, adhesion, status.
pub fn batch_results_arrays<F>(
    arrays: [*mut F; 5],
    details: *mut i32,
) -> kstrip::ffi::types::BatchOutputs<F> {
    results_at(arrays, size_of::<F>() as isize, details, size_of::<i32>() as isize)
}
