//! Structures that only C has: options, and where outputs go.

use crate::forces::derivatives::Derivatives;
use crate::forces::{Solution, StripResult};
use crate::friction::SlipFriction;
use crate::friction::derivatives::LawDerivatives;
use crate::motion::MotionDerivatives;
pub use crate::patch::Patch;
use crate::wheel_rail::WheelPair;
use crate::wheel_rail::profile::PreparedProfile;
use crate::wheelset::track::RailMotion;

/// The model and the number of strips. All zero is the default. Outside the range of the model:
/// KSTRIP_WARNING_SPIN (1967, |psi| of 1 or more), KSTRIP_WARNING_RANGE (STRIP, |psi| above 3),
/// KSTRIP_WARNING_AXIS_RATIO (STRIP, TOTAL: a/b beyond 0.015 to 60), KSTRIP_WARNING_BEYOND_FRICTION
/// (LINEAR, more than mu N), KSTRIP_WARNING_MISMATCH_NEGLECTED (1967, a mismatch that is not 0).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct kstrip_options {
    /// One of the KSTRIP_MODEL constants, else KSTRIP_ERROR_MODEL; KSTRIP_ERROR_MODEL_LEFT_OUT if
    /// this build of the library has no such model.
    pub model: i32,
    /// Number of strips: 4, 8, 16, 32 or 64; 0 means 16; else KSTRIP_ERROR_STRIP_COUNT. Models
    /// without strips check it and ignore it otherwise.
    pub strips: i32,
}

/// Kalker's parameters (5.13) of a contact in motion, dimensionless.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct KalkerParameters<F> {
    /// xi = longitudinal G/(2 (1 - nu) mu p0)
    pub xi: F,
    /// eta = lateral G/(2 mu p0)
    pub eta: F,
    /// psi = a spin G/(2 mu p0). The theory of 1967 is valid for |psi| < 1.
    pub psi: F,
}

/// Where the outputs of kstrip_evaluate() and kstrip_patch_evaluate() go. An output that is NULL is
/// not computed and costs nothing.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outputs<F> {
    /// Forces, moment, power, adhesion: those of kstrip_solve() if friction is constant.
    pub result: *mut Solution<F>,
    /// Derivatives with respect to creepages, load and friction. Under falling friction they
    /// include the change of friction.
    pub derivatives: *mut Derivatives<F>,
    /// Derivatives with respect to the parameters of falling friction.
    pub law_derivatives: *mut LawDerivatives<F>,
    /// The coefficient of friction that agrees with the slip; the contact's own where friction is
    /// constant. For a patch it is the factor that multiplies the friction of all strips, 1 where
    /// friction is constant.
    pub friction: *mut F,
    /// The forces of each strip (capacity elements); they add up to the result of the model.
    pub strips: *mut StripResult<F>,
    /// Number of strips that were written; required with strips.
    pub count: *mut u32,
    /// Size of the array strips: at least the strip count of the options; for a patch, at least its
    /// number of strips. KSTRIP_STRIPS_CAPACITY is always enough.
    pub capacity: u32,
    /// Reserved: zero.
    pub reserved: u32,
}

/// Where the outputs of kstrip_solve_motion() go. An output that is NULL is not computed and costs
/// nothing.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionOutputs<F> {
    /// Forces and moment on the lower body, and adhesion. The power is in watts here: fx slip_x +
    /// fy slip_y + mz spin_rate.
    pub result: *mut Solution<F>,
    /// Derivatives with respect to motion, load and friction.
    pub derivatives: *mut MotionDerivatives<F>,
    /// The coefficient of friction that agrees with the slip.
    pub friction: *mut F,
}

/// Many contacts with their motion and their friction: for each quantity a pointer to the first one
/// and the distance to the next in bytes, its stride. An input with stride 0 is the same for all
/// contacts.
///
/// Arrays of structures (&contacts[0].a, sizeof(kstrip_contact)) and one array for each quantity
/// (a, sizeof(double)) are both possible. All members but mismatch and law are required, unless
/// there are no contacts.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BatchInputs<F> {
    /// Semi-axes along x [m].
    pub a: *const F,
    /// Stride [bytes]: distance from one semi-axis to the next. The other strides are those of the
    /// inputs before them.
    pub a_stride: isize,
    /// Semi-axes along y [m].
    pub b: *const F,
    /// Stride [bytes].
    pub b_stride: isize,
    /// Normal forces [N]; a contact whose force is not positive is lost.
    pub normal_force: *const F,
    /// Stride [bytes].
    pub normal_force_stride: isize,
    /// Combined shear moduli G [Pa].
    pub shear_modulus: *const F,
    /// Stride [bytes].
    pub shear_modulus_stride: isize,
    /// Combined Poisson's ratios [-].
    pub poisson_ratio: *const F,
    /// Stride [bytes].
    pub poisson_ratio_stride: isize,
    /// Coefficients of friction [-].
    pub friction: *const F,
    /// Stride [bytes].
    pub friction_stride: isize,
    /// Mismatches of the materials [-]; NULL: like materials.
    pub mismatch: *const F,
    /// Stride [bytes].
    pub mismatch_stride: isize,
    /// Longitudinal creepages [-].
    pub longitudinal: *const F,
    /// Stride [bytes].
    pub longitudinal_stride: isize,
    /// Lateral creepages [-].
    pub lateral: *const F,
    /// Stride [bytes].
    pub lateral_stride: isize,
    /// Spins [1/m].
    pub spin: *const F,
    /// Stride [bytes].
    pub spin_stride: isize,
    /// Falling friction; NULL: constant.
    pub law: *const SlipFriction<F>,
    /// Stride [bytes].
    pub law_stride: isize,
}

/// Where the results of many contacts go: for each quantity a pointer to the first one and the
/// distance to the next in bytes. An output that is NULL is not computed and costs nothing.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BatchOutputs<F> {
    /// Longitudinal forces on the lower bodies [N].
    pub fx: *mut F,
    /// Stride [bytes]: distance from one force to the next, forward or backward. With more than one
    /// contact a stride is at least the size of its output.
    pub fx_stride: isize,
    /// Lateral forces [N].
    pub fy: *mut F,
    /// Stride [bytes].
    pub fy_stride: isize,
    /// Moments about z at the centres of the contacts [N m].
    pub mz: *mut F,
    /// Stride [bytes].
    pub mz_stride: isize,
    /// Frictional powers divided by rolling speed [N].
    pub power: *mut F,
    /// Stride [bytes].
    pub power_stride: isize,
    /// Shares of the contact areas in adhesion [-], 0 to 1, or -1 for unknown.
    pub adhesion: *mut F,
    /// Stride [bytes].
    pub adhesion_stride: isize,
    /// The status of each result: 0 or one of the KSTRIP_WARNING constants.
    pub status_detail: *mut i32,
    /// Stride [bytes].
    pub status_detail_stride: isize,
    /// Coefficients of friction that agree with the slip [-].
    pub friction: *mut F,
    /// Stride [bytes].
    pub friction_stride: isize,
    /// Derivatives with respect to creepages, load and friction.
    pub derivatives: *mut Derivatives<F>,
    /// Stride [bytes].
    pub derivatives_stride: isize,
    /// Derivatives with respect to the parameters of falling friction.
    pub law_derivatives: *mut LawDerivatives<F>,
    /// Stride [bytes].
    pub law_derivatives_stride: isize,
}

/// Load, friction bound and area of a patch.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchSummary<F> {
    /// Normal force [N].
    pub normal_force: F,
    /// Sum of friction times load over the strips [N]: no tangential force exceeds it.
    pub friction_bound: F,
    /// Contact area [m^2].
    pub area: F,
    /// Number of contact regions.
    pub lobes: u32,
    /// Reserved: zero.
    pub reserved: u32,
}

/// The undeformed distance of two bodies across the rolling direction, at points in ascending y.
/// The points are smoothed over the length that kstrip_profile_contact gives.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfilePoints<F> {
    /// Places y [m], ascending, else KSTRIP_ERROR_PROFILE.
    pub y: *const F,
    /// Distance of the bodies there [m], the least along x. A constant added to all distances
    /// changes nothing.
    pub distance: *const F,
    /// Place along x [m] where the distance is least; bodies that yaw touch ahead on one side and
    /// behind on the other. NULL: at 0.
    pub centre_x: *const F,
    /// Rolling radius [m] of each point, > 0, else KSTRIP_ERROR_ROLLING_RADIUS; it replaces that of
    /// the contact. NULL: the contact's own.
    pub rolling_radius: *const F,
    /// Number of points, at least 2, else KSTRIP_ERROR_PROFILE.
    pub points: u32,
    /// Reserved: zero.
    pub reserved: u32,
}

/// Load or approach, material and friction of two profiles that are pressed together. Zero is the
/// default of every member but rolling_radius, shear_modulus and one of normal_force and approach.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileOptions<F> {
    /// Rolling radius [m], > 0, else KSTRIP_ERROR_ROLLING_RADIUS; of two rolling bodies 1/R =
    /// 1/R_lower + 1/R_upper. It is ignored where the profile has its own radii.
    pub rolling_radius: F,
    /// Normal force N [N], >= 0, else KSTRIP_ERROR_NORMAL_FORCE; 0: approach decides.
    pub normal_force: F,
    /// Approach of distant points of the bodies [m], >= 0; only where normal_force is 0.
    pub approach: F,
    /// Length over which the profile is smoothed [m], >= 0, else KSTRIP_ERROR_SMOOTHING_LENGTH. 0
    /// stands for half the width of the contact, at most 2 mm. The length is always at least 2.5
    /// steps of the profile. For rough profiles set it to 4 mm.
    pub smoothing_length: F,
    /// Combined shear modulus G [Pa], > 0, else KSTRIP_ERROR_MODULUS.
    pub shear_modulus: F,
    /// Combined Poisson's ratio [-], 0 to 0.5, else KSTRIP_ERROR_POISSON_RATIO.
    pub poisson_ratio: F,
    /// Coefficient of friction of every strip [-], >= 0, else KSTRIP_ERROR_FRICTION.
    pub friction: F,
    /// About how many strips all zones have together: 4, 8, 16, 32 or 64, of which 40 are given,
    /// on a microcontroller 16; 0: 16;
    /// else KSTRIP_ERROR_STRIP_COUNT.
    pub strips: i32,
    /// Reserved: zero.
    pub reserved: i32,
}

/// A finished contact table, from which a function takes the contacts of wheels
/// (kstrip_table_finish()). All zero: no table.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_table {
    /// The bytes of the table, at any address, else KSTRIP_ERROR_TABLE.
    pub data: *const u8,
    /// Their number, or a larger one; else KSTRIP_ERROR_TABLE.
    pub bytes: u32,
    /// 0: outside the table the contacts are computed from the profiles, and at its ends force and
    /// moment jump by its error. Any other number: KSTRIP_ERROR_TABLE_RANGE outside.
    pub only: i32,
}

/// A track: two rails, and where they are. Axes: x forward, y to the right, z down; the middle of
/// the track is midway between the gauge faces. Cant and inclination of the track are those of
/// these axes; the inclination of the rails is in their profiles. Number 0 is the right side,
/// number 1 the left side. KSTRIP_ERROR_GAUGE if gauge, gauge_depth or an origin is negative, or if
/// the gauge is 0 and used; KSTRIP_WARNING_PROFILE_END if a rail ends above gauge_depth.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Track<F> {
    /// Prepared profiles, both of a right rail: right, left; left NULL: as the right one.
    pub rail: [*const PreparedProfile<F>; 2],
    /// Gauge [m]: distance of the gauge faces, 1.435 for standard gauge; not used where both
    /// origins are given.
    pub gauge: F,
    /// Depth below the top of the rails down to which the gauge is measured [m], >= 0; 0: 14 mm.
    pub gauge_depth: F,
    /// Distances of the rails' origins from the middle of the track [m], >= 0: right, left; 0: from
    /// the gauge.
    pub origin: [F; 2],
    /// Displacements and velocities of the rails, right and left: irregularities, flexible rails.
    pub motion: [RailMotion<F>; 2],
}

/// A wheelset: two wheels on an axle. Number 0 is the right wheel, number 1 the left one.
/// KSTRIP_ERROR_GAUGE if back_to_back and running_circles are both 0, or one of them is negative.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelsetParts<F> {
    /// Prepared profiles, both of a right wheel: right, left; left NULL: as the right one.
    pub wheel: [*const PreparedProfile<F>; 2],
    /// Falling friction, as in kstrip_patch_evaluate(): right, left; NULL: constant.
    pub friction: [*const SlipFriction<F>; 2],
    /// Contact tables of each wheel on its rail: right, left; NULL: contacts are computed.
    pub table: [*const kstrip_table; 2],
    /// Radius, materials, friction and options of each wheel; if the left wheel_radius is 0, the
    /// left wheel has all values of the right one. The member left is not used.
    pub pair: [WheelPair<F>; 2],
    /// Distance of the backs of the flanges [m], 1.360 for standard gauge; not used where
    /// running_circles is given.
    pub back_to_back: F,
    /// Distance of the running circles, which are at y = 0 of the wheels' profiles [m]; 0:
    /// back_to_back and twice 70 mm.
    pub running_circles: F,
}
