//! The constants of the C interface besides the statuses.

/// The default, 0: forces and derivatives from KSTRIP_MODEL_TOTAL; fields, strips and patches from
/// KSTRIP_MODEL_STRIP.
pub const KSTRIP_MODEL_DEFAULT: i32 = 0;
/// The strip theory of Kalker's paper of 1967. It has no fitted constants. It has the sliding rule
/// that the paper keeps for forces: strips without adhesion slide along the rigid slip of their
/// centre line. The paper made it for slender ellipses, a/b up to 0.2, and |psi| < 1.
pub const KSTRIP_MODEL_STRIP_1967: i32 = 1;
/// The same theory with the sliding rule that joins adhesion strips without a jump.
pub const KSTRIP_MODEL_STRIP_1967_CONTINUOUS: i32 = 2;
/// A strip theory in Kalker's sense: the half-ellipses of 1967 where a strip adheres, slip along
/// the local rigid slip if it does not. A small network, fitted to CONTACT, corrects the
/// flexibilities. It has forces, moment, stick area and fields. Its derivatives at rest are those
/// of linear theory, and its power is never negative.
pub const KSTRIP_MODEL_STRIP: i32 = 3;
/// A closed formula with a small network fitted to CONTACT. It has forces and moment, and is the
/// most accurate model for ellipses. Far in sliding it is rigid slip, and its power is never
/// negative. It has no strips and no field; adhesion is reported as -1 (unknown).
pub const KSTRIP_MODEL_TOTAL: i32 = 4;
/// Kalker's linear theory, for stability analysis. Its force grows with the creepage without a
/// limit. Adhesion is 1.
pub const KSTRIP_MODEL_LINEAR: i32 = 5;

/// The longitudinal force was measured.
pub const KSTRIP_MEASURED_FX: u32 = 1;
/// The lateral force was measured.
pub const KSTRIP_MEASURED_FY: u32 = 2;

/// Fit the coefficient of friction without slip.
pub const KSTRIP_FIT_FRICTION: u32 = 1;
/// Fit the ratio of falling friction.
pub const KSTRIP_FIT_RATIO: u32 = 2;
/// Fit the decay of falling friction.
pub const KSTRIP_FIT_DECAY: u32 = 4;
/// Fit the slope factor.
pub const KSTRIP_FIT_SLOPE_FACTOR: u32 = 8;
/// Fit the slide factor.
pub const KSTRIP_FIT_SLIDE_FACTOR: u32 = 16;
/// Fit the layer.
pub const KSTRIP_FIT_LAYER: u32 = 32;

/// State of a point: outside the contact.
pub const KSTRIP_STATE_OUTSIDE: i32 = 0;
/// State of a point: adhesion, no slip.
pub const KSTRIP_STATE_STICK: i32 = 1;
/// State of a point: slip.
pub const KSTRIP_STATE_SLIP: i32 = 2;
/// State of a point: slip against the traction (negative local dissipation). This is an error of
/// the strip theory near the leading edge of sliding strips.
pub const KSTRIP_STATE_SLIP_NEGATIVE_DISSIPATION: i32 = 3;

/// Largest number of strips that kstrip_evaluate() writes.
pub const KSTRIP_STRIPS_CAPACITY: u32 = 64;

/// Version of the library, major.
pub const KSTRIP_VERSION_MAJOR: i32 = 0;
/// Version of the library, minor.
pub const KSTRIP_VERSION_MINOR: i32 = 2;
/// Version of the library, patch.
pub const KSTRIP_VERSION_PATCH: i32 = 0;
/// Changes whenever a structure or function changes incompatibly.
pub const KSTRIP_ABI_VERSION: i32 = 1;
