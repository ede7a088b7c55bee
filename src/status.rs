//! What can be wrong with an input, and what a caller should know about a result.

use core::ffi::CStr;
use core::fmt;

/// An input that has no answer. Nothing has been computed or written.
///
/// The number of each variant is its status in the C interface; numbers are never reused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
#[non_exhaustive]
pub enum Error {
    /// A pointer is NULL.
    NullPointer = -1,
    /// A number is infinite or NaN where only a finite one has a meaning.
    NotFinite = -2,
    /// A semi-axis of the contact ellipse is not positive.
    SemiAxis = -3,
    /// The normal force of a profile is negative, or the wanted support of a wheel is not positive.
    NormalForce = -4,
    /// A modulus of elasticity is not positive.
    Modulus = -5,
    /// Poisson's ratio is outside `[0, 1/2]`.
    PoissonRatio = -6,
    /// The coefficient of friction is negative.
    Friction = -7,
    /// There is no model of that number.
    Model = -8,
    /// The strip count is not one of 4, 8, 16, 32, 64.
    StripCount = -9,
    /// A radius of curvature is zero or NaN, or the summed curvature of the two bodies is not
    /// positive in both directions: no elliptic contact.
    Curvature = -10,
    /// The rolling speed is not positive.
    RollingSpeed = -11,
    /// The caller's array is too small, or a count exceeds the capacity of a structure.
    Capacity = -12,
    /// The model has no such result (a total-force model has no strips and no field).
    NotInModel = -13,
    /// The result is beyond the range of the floating-point type.
    Overflow = -14,
    /// The ratio of falling friction is outside `[0, 1]`.
    FrictionRatio = -15,
    /// The decay of falling friction is negative.
    FrictionDecay = -16,
    /// The rolling speed of falling friction is negative.
    NegativeSpeed = -17,
    /// The factor of the initial slope is outside `[0, 1]`.
    SlopeFactor = -18,
    /// No friction explains the measured force: it points against the slip, or there is no load.
    Unexplained = -19,
    /// The wanted force exceeds `mu N`.
    ForceBeyondFriction = -20,
    /// What was measured is none of the longitudinal force, the lateral force, and both.
    Measured = -21,
    /// A structure was not filled by preparing a contact or a profile.
    NotPrepared = -22,
    /// The floor of the speed is negative.
    FloorSpeed = -23,
    /// The distance between the outputs of two contacts is smaller than an output, or a distance is no multiple of the alignment.
    Stride = -24,
    /// A strip of a patch has a width or half length that is not positive.
    StripSize = -40,
    /// The peak pressure of a strip is negative.
    Pressure = -41,
    /// Strips of a patch overlap, or do not ascend in `y`.
    StripOrder = -42,
    /// There are more strips than a patch has room for, or more contacts than a wheel may have.
    PatchSize = -43,
    /// A profile has too few points, two of them coincide, or numbers that must ascend do not: its `y`, the lengths of a gap, or the places
    /// of friction.
    Profile = -44,
    /// A profile ends where the bodies would touch, or the wheel is beside the rail.
    ProfileEnd = -45,
    /// A rolling radius or the radius of a wheel is not positive.
    RollingRadius = -46,
    /// A smoothing length is negative.
    SmoothingLength = -47,
}

impl Error {
    /// The status of the C interface, negative.
    #[must_use]
    pub const fn code(self) -> i32 {
        self as i32
    }

    /// This error, unless a condition holds.
    pub(crate) const fn unless(self, holds: bool) -> Result<(), Self> {
        if holds { Ok(()) } else { Err(self) }
    }

    /// The one with the larger code.
    #[must_use]
    pub const fn worse(self, other: Self) -> Self {
        if other.code() > self.code() { other } else { self }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = advice(self.code()).and_then(|text| text.to_str().ok());
        out.write_str(text.unwrap_or("unknown error"))
    }
}

impl core::error::Error for Error {}

/// What the caller should know about a valid result.
///
/// The number of each variant is its status in the C interface; numbers are never reused.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(i32)]
#[non_exhaustive]
pub enum Notice {
    /// Nothing: the inputs are in the range of the model.
    #[default]
    None = 0,
    /// `|psi| >= 1`: beyond the spin for which the theory of 1967 is valid. The result is its
    /// continuation, bounded by `mu N`.
    SpinBeyondTheory = 1,
    /// An input is outside the range in which the model was compared with its reference. The result
    /// is finite and bounded by `mu N`.
    OutsideRange = 2,
    /// The linear model knows no friction bound, and its force exceeds `mu N`.
    BeyondFriction = 3,
    /// More than one coefficient of friction fits. Under falling friction the result has the largest, which is
    /// reached from adhesion; an estimate from a measured force is the smallest.
    SeveralFrictions = 4,
    /// A bounded iteration ended before its result was accurate to rounding.
    NotConverged = 5,
    /// The contact sticks: the measured force tells only that friction is not smaller than the result.
    FrictionAtLeast = 6,
    /// The wanted force is that of full sliding, which every larger creepage gives as well.
    CreepageAtLeast = 7,
    /// The peak pressure exceeds a tenth of the shear modulus. The modulus, the load or the semi-axes are probably in
    /// another unit.
    Pressure = 8,
    /// A creepage exceeds 10. It is probably in per cent, or the rolling speed is close to zero.
    Creepage = 9,
    /// A semi-axis exceeds 1 m. It is probably in mm.
    SemiAxis = 10,
    /// The spin is larger than rolling bodies of this curvature can have. It is probably in degrees per metre.
    Spin = 11,
    /// The coefficient of friction exceeds 5. It is probably in per cent.
    Friction = 12,
    /// Both summed curvatures are below 0.2/m. The radii are probably in mm.
    Radius = 13,
    /// The axis ratio a/b is outside 0.015 to 60, the range for which the model was made. The result is finite,
    /// bounded by `mu N`, and has the limits of slender contacts.
    AxisRatio = 14,
    /// The mismatch of the materials exceeds 0.25, where the model was not compared with its reference.
    Mismatch = 15,
    /// The theory of 1967 neglects the mismatch of the materials.
    MismatchNeglected = 16,
    /// A semi-axis exceeds 0.3 of the smaller radius in its direction: the bodies are no half-spaces there.
    Conformal = 17,
    /// The normal turns by more than 30 degrees over a contact: one plane of contact is not enough.
    AngleRange = 19,
    /// A zone of contact ends with the profile, as if the bodies ended there.
    ProfileEnd = 18,
}

impl Notice {
    /// Whether the notice says that an input is implausible, which is mostly because of another unit.
    #[must_use]
    pub const fn is_implausible(self) -> bool {
        self.code() >= Self::Pressure.code() && self.code() <= Self::Radius.code()
    }

    /// The status of the C interface, zero or positive.
    #[must_use]
    pub const fn code(self) -> i32 {
        self as i32
    }

    /// The graver one. A warning that the result may be another one is graver than one of implausible inputs, and that is graver than one of
    /// inputs outside the range of the model. Of two that are equally grave it is the one with the larger code.
    #[must_use]
    pub const fn worse(self, other: Self) -> Self {
        let (own, of_other) = (self.gravity(), other.gravity());
        let graver = of_other > own || (of_other == own && other.code() > self.code());
        if graver { other } else { self }
    }

    /// How grave the notice is. Of two notices the one with the larger number is returned.
    const fn gravity(self) -> i32 {
        match self {
            Self::NotConverged => 6,
            Self::SeveralFrictions => 5,
            Self::FrictionAtLeast | Self::CreepageAtLeast => 4,
            Self::Pressure
            | Self::Creepage
            | Self::SemiAxis
            | Self::Spin
            | Self::Friction
            | Self::Radius => 3,
            Self::BeyondFriction | Self::AngleRange | Self::ProfileEnd => 2,
            Self::OutsideRange
            | Self::SpinBeyondTheory
            | Self::AxisRatio
            | Self::Mismatch
            | Self::MismatchNeglected
            | Self::Conformal => 1,
            Self::None => 0,
        }
    }
}

/// What a status means and what the caller must change; `None` for a number that is no status.
#[must_use]
pub const fn advice(code: i32) -> Option<&'static CStr> {
    Some(match code {
        0 => c"ok",
        1 => {
            c"spin parameter |psi| >= 1: beyond the strip theory of 1967, result is its bounded continuation; use STRIP or TOTAL"
        }
        2 => {
            c"an input is outside the range in which the model was checked; result is finite and bounded by mu N"
        }
        3 => c"the linear force exceeds mu N; use a model with saturation",
        4 => {
            c"more than one coefficient of friction fits: falling friction gives the largest (reached from adhesion), an estimate the smallest"
        }
        5 => c"a bounded iteration ended before its result was accurate to rounding",
        6 => {
            c"the contact sticks, so that its force does not tell the friction: result is a lower bound; measure at more creepage"
        }
        7 => {
            c"the wanted force is that of full sliding: result is the creepage that reaches it, any larger one gives it as well"
        }
        8 => {
            c"implausible pressure: the peak pressure exceeds a tenth of the shear modulus; check the units of modulus (Pa), load (N) and semi-axes (m)"
        }
        9 => {
            c"implausible creepage: above 10; check that it is a ratio, not per cent, and that the contact rolls (at low speed use slip velocities)"
        }
        10 => c"implausible semi-axis: above 1 m; check its unit (m, not mm)",
        11 => {
            c"implausible spin: more than rolling bodies of this size have; check its unit (rad/m, not degrees)"
        }
        12 => c"implausible coefficient of friction: above 5; check that it is no percentage",
        13 => c"implausible radii: flatter than a radius of 5 m in both directions; check their unit (m, not mm)",
        14 => {
            c"the axis ratio a/b is outside 0.015 to 60, the range for which the model was made; result is finite, bounded by mu N and has the right limits"
        }
        15 => c"the mismatch of the materials exceeds 0.25, where the model was not checked; result is finite and bounded by mu N",
        16 => {
            c"the theory of 1967 neglects the mismatch of the materials; use another model, or set it to 0"
        }
        17 => {
            c"too conformal: a semi-axis exceeds 0.3 of the smaller radius in its direction, so that the bodies are no half-spaces; result is that of half-spaces"
        }
        19 => {
            c"the normal turns by more than 30 degrees over a contact of the wheel: one plane of contact is not enough"
        }
        18 => c"a zone of contact ends with the profile, as if the bodies ended there: pass more of the profile",
        -1 => c"a required pointer is NULL: pass the address of a structure or array",
        -2 => c"an input is infinite or NaN: pass finite numbers",
        -3 => c"a semi-axis of the contact ellipse is not positive: a and b must be > 0 (metres)",
        -4 => {
            c"the normal force of a profile is negative, or the wanted support of a wheel is not positive (newtons): compression is positive"
        }
        -5 => c"a modulus of elasticity is not positive: it must be > 0 (pascals)",
        -6 => c"Poisson's ratio is outside [0, 0.5]",
        -7 => c"the coefficient of friction is negative: it must be >= 0",
        -8 => c"unknown model: use one of the KSTRIP_MODEL constants",
        -9 => c"unknown strip count: use 4, 8, 16, 32 or 64",
        -10 => {
            c"no elliptic contact: radii must not be zero, and the summed curvatures must be positive in both directions"
        }
        -11 => c"the rolling speed is not positive: let x point in the rolling direction",
        -12 => {
            c"the array is too small: pass the capacity that the documentation of the function asks for"
        }
        -13 => c"the model cannot compute this output: take STRIP for strips and fields, and any model but LINEAR for patches",
        -14 => {
            c"the result is beyond the range of the floating-point type: check the units (N, m, Pa)"
        }
        -15 => c"the ratio of falling friction is outside [0, 1]",
        -16 => c"the decay of falling friction is negative: it must be >= 0 (s/m)",
        -17 => c"the rolling speed is negative: it must be >= 0 (m/s)",
        -18 => c"the factor of the initial slope must be >= 0 and <= 1 (0 stands for 1)",
        -19 => {
            c"no friction explains the measured force: it points against the slip, or there is no load; check signs (forces act on the lower body) and creepage"
        }
        -20 => c"the wanted force exceeds mu N: no creepage gives it",
        -22 => c"the contact is not prepared: fill the structure with kstrip_prepare() of the same precision",
        -23 => c"the floor of the speed is negative: it must be > 0 (m/s), or 0 for the default",
        -24 => {
            c"a stride of the batch is smaller than an output, or no multiple of its alignment: pass the distance in bytes between two elements"
        }
        -21 => c"unknown measurement: use KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY, or both added",
        -40 => c"a strip of the patch has a width or a half length that is not positive (metres)",
        -41 => c"the peak pressure of a strip is negative: it must be >= 0 (pascals)",
        -42 => c"strips of the patch overlap, or are not in ascending order of y",
        -43 => {
            c"more strips than a patch has room for, or more contacts than a wheel may have: use fewer and wider strips, or a smoother profile"
        }
        -44 => {
            c"a profile has too few points, two that coincide, or y that does not ascend; or the lengths of a gap or the places of friction do not ascend"
        }
        -45 => c"a profile ends where the bodies would touch, or the wheel is beside the rail: pass more of the profile",
        -46 => c"a rolling radius or the radius of a wheel is not positive: it must be > 0 (metres)",
        -47 => c"the smoothing length is negative: it must be >= 0 (metres), 0 for the default",
        _ => return None,
    })
}
