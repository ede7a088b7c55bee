//! The statuses and constants of the C interface.

/// Result of a call: 0 ok; > 0 warning, outputs valid; < 0 error, outputs untouched.
pub type kstrip_status = i32;

/// Success.
pub const KSTRIP_OK: kstrip_status = 0;
/// Warning: the spin parameter |psi| is 1 or more, beyond the theory of 1967. The result is this
/// library's own continuation of that theory: finite, continuous and bounded by mu N.
pub const KSTRIP_WARNING_SPIN: kstrip_status = 1;
/// Warning: |psi| is above 3, where KSTRIP_MODEL_STRIP was not compared with CONTACT.
pub const KSTRIP_WARNING_RANGE: kstrip_status = 2;
/// Warning: the force of KSTRIP_MODEL_LINEAR exceeds mu N.
pub const KSTRIP_WARNING_BEYOND_FRICTION: kstrip_status = 3;
/// Warning: more than one coefficient of friction fits. Under falling friction the result has the
/// largest, which a contact has whose slip grows from rest. An estimate from a measured force is
/// the smallest.
pub const KSTRIP_WARNING_SEVERAL_FRICTIONS: kstrip_status = 4;
/// Warning: an iteration ended before its result was accurate to rounding.
pub const KSTRIP_WARNING_NOT_CONVERGED: kstrip_status = 5;
/// Warning: the contact sticks, so that the measured force gives only a lower bound of friction.
pub const KSTRIP_WARNING_FRICTION_AT_LEAST: kstrip_status = 6;
/// Warning: the requested force is that of full sliding, which every larger creepage gives as well.
pub const KSTRIP_WARNING_CREEPAGE_AT_LEAST: kstrip_status = 7;
/// Warning: the peak pressure exceeds a tenth of the shear modulus. The modulus, the load or the
/// semi-axes are probably in another unit.
pub const KSTRIP_WARNING_PRESSURE: kstrip_status = 8;
/// Warning: a creepage exceeds 10. It is probably in per cent, or the rolling speed is close to
/// zero.
pub const KSTRIP_WARNING_CREEPAGE: kstrip_status = 9;
/// Warning: a semi-axis exceeds 1 m. It is probably in mm.
pub const KSTRIP_WARNING_SEMI_AXIS: kstrip_status = 10;
/// Warning: the spin is larger than rolling bodies of this curvature can have. It is probably in
/// degrees per metre.
pub const KSTRIP_WARNING_SPIN_UNIT: kstrip_status = 11;
/// Warning: the coefficient of friction exceeds 5. It is probably in per cent.
pub const KSTRIP_WARNING_FRICTION: kstrip_status = 12;
/// Warning: the radii are larger than 5 m in both directions. They are probably in mm.
pub const KSTRIP_WARNING_RADIUS: kstrip_status = 13;
/// Warning: the axis ratio a/b is outside 0.015 to 60, the range for which the model was made.
pub const KSTRIP_WARNING_AXIS_RATIO: kstrip_status = 14;
/// Warning: the mismatch of the materials exceeds 0.25, where the model was not compared with its
/// reference.
pub const KSTRIP_WARNING_MISMATCH: kstrip_status = 15;
/// Warning: the theory of 1967 neglects the mismatch of the materials.
pub const KSTRIP_WARNING_MISMATCH_NEGLECTED: kstrip_status = 16;
/// Warning: a semi-axis exceeds 0.3 of the smaller radius in its direction, where the bodies are
/// not half-spaces.
pub const KSTRIP_WARNING_CONFORMAL: kstrip_status = 17;
/// Warning: the normal turns by more than 30 degrees over a contact of a wheel. One plane of
/// contact is then not enough: forces may be off by some tenths of mu N.
pub const KSTRIP_WARNING_ANGLE_RANGE: kstrip_status = 19;
/// Warning: a zone of contact ends with the profile, as if the bodies ended there.
pub const KSTRIP_WARNING_PROFILE_END: kstrip_status = 18;
/// Warning: the measured points do not determine each parameter of a law.
pub const KSTRIP_WARNING_UNDETERMINED: kstrip_status = 20;
/// Warning: a profile stands upside down or the wrong way round. z must point down, and the flange
/// of a wheel and the gauge side of a rail lie at small y. A contact of a wheel above 30 degrees
/// says so too.
pub const KSTRIP_WARNING_ORIENTATION: kstrip_status = 21;
/// Warning: a profile is longer than 1 m. It is probably in mm.
pub const KSTRIP_WARNING_PROFILE_SIZE: kstrip_status = 22;
/// Warning: the shear modulus is below 0.1 MPa. It is probably in MPa or GPa.
pub const KSTRIP_WARNING_MODULUS: kstrip_status = 23;
/// Warning: friction and Poisson's ratio of a wheel and a rail are both 0. They were probably
/// forgotten.
pub const KSTRIP_WARNING_UNSET: kstrip_status = 24;
/// Warning: no ordinary contact supports the wheel. The support falls with depth on the way to the
/// height that was found, because friction pulls the wheel down, or the peak pressure exceeds a
/// twentieth of the shear modulus.
pub const KSTRIP_WARNING_SUPPORT: kstrip_status = 25;
/// Warning: a contact of a wheel is less than four distances of the points of a profile wide. The
/// profile has few points and is not smooth between them, and the pressure depends on the shape
/// there.
pub const KSTRIP_WARNING_PROFILE_COARSE: kstrip_status = 26;
/// Error: a required pointer is NULL.
pub const KSTRIP_ERROR_NULL: kstrip_status = -1;
/// Error: an input is infinite or NaN.
pub const KSTRIP_ERROR_NOT_FINITE: kstrip_status = -2;
/// Error: a semi-axis is not positive.
pub const KSTRIP_ERROR_SEMI_AXIS: kstrip_status = -3;
/// Error: the normal force of a profile is negative, or the requested support of a wheel is not
/// positive.
pub const KSTRIP_ERROR_NORMAL_FORCE: kstrip_status = -4;
/// Error: a modulus of elasticity is not positive.
pub const KSTRIP_ERROR_MODULUS: kstrip_status = -5;
/// Error: Poisson's ratio is outside [0, 0.5].
pub const KSTRIP_ERROR_POISSON_RATIO: kstrip_status = -6;
/// Error: the coefficient of friction is negative.
pub const KSTRIP_ERROR_FRICTION: kstrip_status = -7;
/// Error: the model is not one of the KSTRIP_MODEL constants.
pub const KSTRIP_ERROR_MODEL: kstrip_status = -8;
/// Error: the strip count is not 4, 8, 16, 32 or 64.
pub const KSTRIP_ERROR_STRIP_COUNT: kstrip_status = -9;
/// Error: a radius is zero or NaN, or the summed curvature in a plane is not positive, so that the
/// bodies do not touch in an ellipse.
pub const KSTRIP_ERROR_CURVATURE: kstrip_status = -10;
/// Error: the rolling speed is not positive.
pub const KSTRIP_ERROR_ROLLING_SPEED: kstrip_status = -11;
/// Error: the caller's array is too small, or a count exceeds the capacity of a structure.
pub const KSTRIP_ERROR_CAPACITY: kstrip_status = -12;
/// Error: the model cannot compute a requested output: it has no strips, no field or no patches, or
/// its force does not depend on friction.
pub const KSTRIP_ERROR_NOT_IN_MODEL: kstrip_status = -13;
/// Error: a result is beyond the range of the floating-point type.
pub const KSTRIP_ERROR_OVERFLOW: kstrip_status = -14;
/// Error: the ratio of falling friction is outside [0, 1].
pub const KSTRIP_ERROR_FRICTION_RATIO: kstrip_status = -15;
/// Error: the decay of falling friction is negative.
pub const KSTRIP_ERROR_FRICTION_DECAY: kstrip_status = -16;
/// Error: the rolling speed of falling friction is negative.
pub const KSTRIP_ERROR_NEGATIVE_SPEED: kstrip_status = -17;
/// Error: the factor of the initial slope is outside [0, 1].
pub const KSTRIP_ERROR_SLOPE_FACTOR: kstrip_status = -18;
/// Error: no friction explains the measured force.
pub const KSTRIP_ERROR_UNEXPLAINED: kstrip_status = -19;
/// Error: the requested force exceeds mu N.
pub const KSTRIP_ERROR_FORCE_BEYOND_FRICTION: kstrip_status = -20;
/// Error: the measurement is not one of KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY, or their sum.
pub const KSTRIP_ERROR_MEASURED: kstrip_status = -21;
/// Error: a structure was not filled by kstrip_prepare() of the same precision, or a profile not by
/// kstrip_prepare_profile().
pub const KSTRIP_ERROR_NOT_PREPARED: kstrip_status = -22;
/// Error: the floor of the speed is negative.
pub const KSTRIP_ERROR_FLOOR_SPEED: kstrip_status = -23;
/// Error: the stride of an output of a batch is smaller than the output, or a stride is no multiple
/// of the alignment.
pub const KSTRIP_ERROR_STRIDE: kstrip_status = -24;
/// Error: the slide factor is outside [0, 1].
pub const KSTRIP_ERROR_SLIDE_FACTOR: kstrip_status = -25;
/// Error: the layer between the bodies is negative.
pub const KSTRIP_ERROR_LAYER: kstrip_status = -26;
/// Error: there are fewer measured forces than parameters to fit.
pub const KSTRIP_ERROR_FEW_POINTS: kstrip_status = -27;
/// Error: nothing is to be fitted, or not one of the KSTRIP_FIT constants.
pub const KSTRIP_ERROR_FIT_PARAMETERS: kstrip_status = -28;
/// Error: the weight of a measured point is negative.
pub const KSTRIP_ERROR_WEIGHT: kstrip_status = -29;
/// Error: a strip of a patch has a width or half length that is not positive.
pub const KSTRIP_ERROR_STRIP_SIZE: kstrip_status = -40;
/// Error: the peak pressure of a strip is negative.
pub const KSTRIP_ERROR_PRESSURE: kstrip_status = -41;
/// Error: strips of a patch overlap, or do not ascend in y.
pub const KSTRIP_ERROR_STRIP_ORDER: kstrip_status = -42;
/// Error: there are more strips than a patch can hold, or more contacts than a wheel may have.
pub const KSTRIP_ERROR_PATCH_SIZE: kstrip_status = -43;
/// Error: a profile has too few points (fewer than 2; for kstrip_prepare_profile() fewer than 4),
/// two of its points coincide, or numbers that must ascend do not: its y, the lengths of a gap, or
/// the places of friction.
pub const KSTRIP_ERROR_PROFILE: kstrip_status = -44;
/// Error: a profile ends where the bodies would touch, or the wheel is beside the rail.
pub const KSTRIP_ERROR_PROFILE_END: kstrip_status = -45;
/// Error: a rolling radius or the radius of a wheel is not positive.
pub const KSTRIP_ERROR_ROLLING_RADIUS: kstrip_status = -46;
/// Error: a smoothing length is negative.
pub const KSTRIP_ERROR_SMOOTHING_LENGTH: kstrip_status = -47;
/// Error: no line follows the points of a profile, because they scatter or turn back too far.
pub const KSTRIP_ERROR_SCATTER: kstrip_status = -48;
/// Error: the damping of the pressure is negative.
pub const KSTRIP_ERROR_NORMAL_DAMPING: kstrip_status = -49;
/// Error: a gauge, a place of a rail or a distance of wheels is missing or negative.
pub const KSTRIP_ERROR_GAUGE: kstrip_status = -60;
/// Error: no position of the wheelset balances the loads while both wheels touch.
pub const KSTRIP_ERROR_WHEEL_LIFTED: kstrip_status = -61;
/// Error: no wave has this amplitude: it is not positive or beyond the shifts, or the radii do not
/// bring the wheelset back.
pub const KSTRIP_ERROR_CONICITY: kstrip_status = -62;

/// The default, 0: forces and derivatives from KSTRIP_MODEL_TOTAL; fields, strips and patches from
/// KSTRIP_MODEL_STRIP.
pub const KSTRIP_MODEL_DEFAULT: i32 = 0;
/// The strip theory of Kalker's paper of 1967. It has no fitted constants. It has the sliding rule
/// that the paper keeps for forces: strips without adhesion slide along the rigid slip of their
/// centre line. The paper made it for slender ellipses, a/b up to 0.2, and |psi| < 1. Its mean
/// error against CONTACT is 5 % of mu N there, and 15 % over a/b 0.1 to 10.
pub const KSTRIP_MODEL_STRIP_1967: i32 = 1;
/// The same theory with the sliding rule that joins adhesion strips without a jump. Its forces have
/// a mean error of 18 % of mu N.
pub const KSTRIP_MODEL_STRIP_1967_CONTINUOUS: i32 = 2;
/// A strip theory in Kalker's sense: the half-ellipses of 1967 where a strip adheres, slip along
/// the local rigid slip where it does not, and flexibilities corrected by a small network fitted to
/// CONTACT. It has forces, moment, stick area and fields. The mean error of the force against
/// CONTACT is 0.6 % of mu N, that of the derivatives 3 % of the linear ones. Its derivatives at
/// rest are those of linear theory, and its power is never negative.
pub const KSTRIP_MODEL_STRIP: i32 = 3;
/// A closed formula with a small network fitted to CONTACT. It has forces and moment, and is the
/// most accurate model. The mean error of the force against CONTACT is 0.3 % of mu N, that of the
/// derivatives 3 % of the linear ones. Far in sliding it is rigid slip, and its power is never
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
