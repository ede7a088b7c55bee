//! C structures in double precision, and the options that both precisions share.

/// Which model, and with how many strips. Fill with kstrip_options_init().
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_options {
    /// One of the KSTRIP_MODEL constants.
    pub model: i32,
    /// Number of strips: 4, 8, 16, 32 or 64. Ignored by models without strips, but checked.
    pub strips: i32,
}

/// An isotropic elastic body.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_material {
    /// Shear modulus G [Pa], > 0. Steel: 82e9.
    pub shear_modulus: f64,
    /// Poisson's ratio [-], 0 to 0.5. Steel: 0.28.
    pub poisson_ratio: f64,
}

/// The combined elastic constants of two bodies: what the contact sees.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_combined_material {
    /// Combined shear modulus G [Pa], 1/G = (1/G_lower + 1/G_upper)/2.
    pub shear_modulus: f64,
    /// Combined Poisson's ratio [-], nu/G = (nu_lower/G_lower + nu_upper/G_upper)/2.
    pub poisson_ratio: f64,
    /// Mismatch kappa [-] of the two materials, which the theory neglects: 0 for like materials; an
    /// error of a few per cent is to be expected at 0.06 (steel on aluminium).
    pub mismatch: f64,
}

/// Radii of curvature of two bodies at the contact [m]: convex positive, flat infinite (INFINITY),
/// concave negative. Zero and NaN are errors.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_radii {
    /// Lower body in the plane of x and z (a straight rail: INFINITY).
    pub lower_x: f64,
    /// Lower body in the plane of y and z (a rail: radius of the head).
    pub lower_y: f64,
    /// Upper body in the plane of x and z (a wheel: rolling radius).
    pub upper_x: f64,
    /// Upper body in the plane of y and z (a wheel: radius of the profile, INFINITY if conical).
    pub upper_y: f64,
}

/// The contact ellipse of Hertz.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_hertz_contact {
    /// Semi-axis along the rolling direction x [m].
    pub a: f64,
    /// Semi-axis along y [m].
    pub b: f64,
    /// Pressure at the centre [Pa].
    pub peak_pressure: f64,
    /// Approach of distant points of the two bodies [m].
    pub approach: f64,
    /// Minor over major semi-axis [-], 0 to 1.
    pub axis_ratio: f64,
    /// Hertz's angle tau [rad], 0 to pi/2.
    pub hertz_angle: f64,
    /// Four over the sum of the four curvatures [m].
    pub rho: f64,
}

/// A loaded elliptic contact with Coulomb friction.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_contact {
    /// Semi-axis along the rolling direction x [m], > 0.
    pub a: f64,
    /// Semi-axis along y [m], > 0.
    pub b: f64,
    /// Normal force N [N], >= 0.
    pub normal_force: f64,
    /// Combined shear modulus G [Pa], > 0.
    pub shear_modulus: f64,
    /// Combined Poisson's ratio [-], 0 to 0.5.
    pub poisson_ratio: f64,
    /// Coefficient of friction mu [-], >= 0.
    pub friction: f64,
}

/// Rigid slip of the upper over the lower body, divided by the rolling speed.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_creepage {
    /// Longitudinal creepage [-], positive when the upper body slides in the rolling direction.
    pub longitudinal: f64,
    /// Lateral creepage [-], positive along y.
    pub lateral: f64,
    /// Spin [1/m], positive from x to y (about z).
    pub spin: f64,
}

/// Kalker's parameters (5.13) of a contact in motion, dimensionless.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_parameters {
    /// xi = longitudinal G/(2 (1 - nu) mu p0)
    pub xi: f64,
    /// eta = lateral G/(2 mu p0)
    pub eta: f64,
    /// psi = a spin G/(2 mu p0). The theory of 1967 is valid for |psi| < 1.
    pub psi: f64,
}

/// Velocity of a body's surface at the centre of the contact, seen from the contact.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_velocity {
    /// Along the rolling direction x [m/s]; about minus the rolling speed for both bodies.
    pub x: f64,
    /// Along y [m/s].
    pub y: f64,
    /// Angular velocity about z [rad/s].
    pub angular_z: f64,
}

/// Forces on the lower body.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_result {
    /// Longitudinal force [N].
    pub fx: f64,
    /// Lateral force [N].
    pub fy: f64,
    /// Moment about z at the centre of the contact [N m].
    pub mz: f64,
    /// Frictional power over rolling speed, fx longitudinal + fy lateral + mz spin [N]: energy
    /// dissipated per metre rolled.
    pub power: f64,
    /// Share of the contact area in adhesion [-], 0 to 1. KSTRIP_MODEL_TOTAL does not know it: -1.
    pub adhesion: f64,
    /// The status of this result: 0 or one of the KSTRIP_WARNING constants.
    pub status_detail: i32,
    /// Zero.
    pub reserved: i32,
}

/// One strip y = const of the contact: what it carries, on the lower body.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_strip {
    /// Centre line [m].
    pub y: f64,
    /// Width that the strip stands for [m].
    pub width: f64,
    /// Half of its length along x [m].
    pub half_length: f64,
    /// x of the separatrix [m]: slip behind it, adhesion ahead of it. Equal to half_length when the
    /// whole strip slides.
    pub separatrix: f64,
    /// Its share of the longitudinal force [N].
    pub fx: f64,
    /// Its share of the lateral force [N].
    pub fy: f64,
    /// Its share of the moment about the centre of the contact [N m].
    pub mz: f64,
    /// Its share of the frictional power [N].
    pub power: f64,
    /// KSTRIP_STATE_STICK if it has an adhesion area, else KSTRIP_STATE_SLIP.
    pub state: i32,
    /// Zero.
    pub reserved: i32,
}

/// The state of a point of the contact plane. Tractions act on the lower body.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_point {
    /// Pressure [Pa].
    pub pressure: f64,
    /// Tangential traction along x [Pa].
    pub traction_x: f64,
    /// Tangential traction along y [Pa].
    pub traction_y: f64,
    /// Slip of the upper over the lower body along x, over the rolling speed [-].
    pub slip_x: f64,
    /// Slip along y, over the rolling speed [-].
    pub slip_y: f64,
    /// traction . slip [Pa]: energy dissipated per area and metre rolled.
    pub dissipation: f64,
    /// One of the KSTRIP_STATE constants.
    pub state: i32,
    /// Zero.
    pub reserved: i32,
}
