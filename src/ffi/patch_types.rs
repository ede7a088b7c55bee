//! C structures of patches that are given by their strips, in both precisions.

use crate::ffi::KSTRIP_PATCH_CAPACITY;

/// One strip of a patch, along the rolling direction. Its pressure is a half-ellipse in x,
/// p = peak_pressure sqrt(1 - (x - centre_x)^2/half_length^2), and does not vary over its width.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_patch_strip {
    /// Centre line y [m].
    pub y: f64,
    /// Width [m], > 0.
    pub width: f64,
    /// Half length along x [m], > 0.
    pub half_length: f64,
    /// Centre along x [m]; 0 for most contacts.
    pub centre_x: f64,
    /// Pressure at the centre [Pa], >= 0.
    pub peak_pressure: f64,
    /// Coefficient of friction [-], >= 0. May be changed from strip to strip after a patch is built.
    pub friction: f64,
}

/// A contact patch of any shape: its strips, in ascending y. Filled by kstrip_patch_from_ellipse(),
/// kstrip_patch_from_strips() or kstrip_patch_from_profile(); the members may then be changed.
/// All functions check it again.
///
/// Where the distance of two neighbours is more than one and a half times that at which they touch,
/// there is a gap: what lies on either side is a lobe of its own.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_patch {
    /// The strips; the first count are used.
    pub strips: [kstrip_patch_strip; KSTRIP_PATCH_CAPACITY],
    /// Combined shear modulus G [Pa], > 0.
    pub shear_modulus: f64,
    /// Combined Poisson's ratio [-], 0 to 0.5.
    pub poisson_ratio: f64,
    /// Factor [-], > 0, that makes the sum of the strips' areas the patch's area: 1 unless the strips
    /// are a quadrature rule (kstrip_patch_from_ellipse()).
    pub area_scale: f64,
    /// The same for the moment of the area about x, the sum of y^2 times area.
    pub lever_scale: f64,
    /// Number of strips, 0 to KSTRIP_PATCH_CAPACITY. None: no load.
    pub count: u32,
    /// Zero.
    pub reserved: u32,
}

/// What a patch carries.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_patch_summary {
    /// Normal force [N].
    pub normal_force: f64,
    /// Sum of friction times load over the strips [N]: no tangential force exceeds it.
    pub friction_bound: f64,
    /// Contact area [m^2].
    pub area: f64,
    /// Number of lobes.
    pub lobes: u32,
    /// Zero.
    pub reserved: u32,
}

/// What presses two profiles together.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_profile_contact {
    /// Rolling radius [m], > 0; of two rolling bodies 1/R = 1/R_lower + 1/R_upper.
    pub rolling_radius: f64,
    /// Normal force [N], >= 0.
    pub normal_force: f64,
    /// Combined shear modulus G [Pa], > 0.
    pub shear_modulus: f64,
    /// Combined Poisson's ratio [-], 0 to 0.5.
    pub poisson_ratio: f64,
    /// Coefficient of friction of every strip [-], >= 0.
    pub friction: f64,
}

/// How two profiles meet under a load.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_profile_result {
    /// Approach of distant points of the two bodies [m].
    pub penetration: f64,
    /// Largest pressure [Pa], at the deepest point.
    pub peak_pressure: f64,
    /// Normal force reached [N]: the one asked for, to rounding.
    pub normal_force: f64,
    /// y of the deepest point [m].
    pub deepest_y: f64,
    /// Evaluations of the load, at most 60.
    pub iterations: u32,
    /// Zero.
    pub reserved: u32,
}

/// kstrip_patch_strip in single precision.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_patch_strip_f32 {
    /// Centre line y [m].
    pub y: f32,
    /// Width [m], > 0.
    pub width: f32,
    /// Half length along x [m], > 0.
    pub half_length: f32,
    /// Centre along x [m]; 0 for most contacts.
    pub centre_x: f32,
    /// Pressure at the centre [Pa], >= 0.
    pub peak_pressure: f32,
    /// Coefficient of friction [-], >= 0. May be changed from strip to strip after a patch is built.
    pub friction: f32,
}

/// kstrip_patch in single precision.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_patch_f32 {
    /// The strips; the first count are used.
    pub strips: [kstrip_patch_strip_f32; KSTRIP_PATCH_CAPACITY],
    /// Combined shear modulus G [Pa], > 0.
    pub shear_modulus: f32,
    /// Combined Poisson's ratio [-], 0 to 0.5.
    pub poisson_ratio: f32,
    /// Factor [-], > 0, that makes the sum of the strips' areas the patch's area: 1 unless the strips
    /// are a quadrature rule (kstrip_patch_from_ellipse()).
    pub area_scale: f32,
    /// The same for the moment of the area about x, the sum of y^2 times area.
    pub lever_scale: f32,
    /// Number of strips, 0 to KSTRIP_PATCH_CAPACITY. None: no load.
    pub count: u32,
    /// Zero.
    pub reserved: u32,
}

/// kstrip_patch_summary in single precision.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_patch_summary_f32 {
    /// Normal force [N].
    pub normal_force: f32,
    /// Sum of friction times load over the strips [N]: no tangential force exceeds it.
    pub friction_bound: f32,
    /// Contact area [m^2].
    pub area: f32,
    /// Number of lobes.
    pub lobes: u32,
    /// Zero.
    pub reserved: u32,
}

/// kstrip_profile_contact in single precision.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_profile_contact_f32 {
    /// Rolling radius [m], > 0; of two rolling bodies 1/R = 1/R_lower + 1/R_upper.
    pub rolling_radius: f32,
    /// Normal force [N], >= 0.
    pub normal_force: f32,
    /// Combined shear modulus G [Pa], > 0.
    pub shear_modulus: f32,
    /// Combined Poisson's ratio [-], 0 to 0.5.
    pub poisson_ratio: f32,
    /// Coefficient of friction of every strip [-], >= 0.
    pub friction: f32,
}

/// kstrip_profile_result in single precision.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_profile_result_f32 {
    /// Approach of distant points of the two bodies [m].
    pub penetration: f32,
    /// Largest pressure [Pa], at the deepest point.
    pub peak_pressure: f32,
    /// Normal force reached [N]: the one asked for, to rounding.
    pub normal_force: f32,
    /// y of the deepest point [m].
    pub deepest_y: f32,
    /// Evaluations of the load, at most 60.
    pub iterations: u32,
    /// Zero.
    pub reserved: u32,
}
