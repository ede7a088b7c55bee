//! Errors in inputs, and warnings about results.

use core::ffi::CStr;
use core::fmt;

/// `Variant = number: "text"`: an enumeration of statuses. The text says what the status means and
/// what the caller must change; it is also the documentation of the variant.
macro_rules! statuses {
    ($(#[$about:meta])* $name:ident {
        $($(#[$variant_is:meta])* $variant:ident = $number:literal: $text:literal,)*
    }) => {
        $(#[$about])*
        ///
        /// The number of each variant is its status in the C interface; numbers are never reused.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(i32)]
        #[non_exhaustive]
        pub enum $name {
            $(#[doc = $text] $(#[$variant_is])* $variant = $number,)*
        }

        impl $name {
            /// The status of the C interface.
            #[must_use]
            pub const fn code(self) -> i32 {
                self as i32
            }

            /// The variant of a status of the C interface.
            pub(crate) const fn from_code(code: i32) -> Option<Self> {
                match code {
                    $($number => Some(Self::$variant),)*
                    _ => None,
                }
            }

            const fn advice(code: i32) -> Option<&'static CStr> {
                match code {
                    $($number => Some(const { c_string(concat!($text, "\0")) }),)*
                    _ => None,
                }
            }
        }
    };
}

statuses! {
    /// An input without a result, with a negative status. Nothing has been computed or written.
    Error {
        NullPointer = -1: "a required pointer is NULL: pass the address of a structure or array",
        NotFinite = -2: "an input is infinite or NaN: pass finite numbers",
        SemiAxis = -3:
            "a semi-axis of the contact ellipse is not positive: a and b must be > 0 (metres)",
        NormalForce = -4:
            "the normal force of a profile or of a contact of a wheel, or the share of such a \
             contact, is negative, or the requested support of a wheel is not positive (newtons): \
             compression is positive",
        Modulus = -5: "a modulus of elasticity is not positive: it must be > 0 (pascals)",
        PoissonRatio = -6: "Poisson's ratio is outside [0, 0.5]",
        Friction = -7: "the coefficient of friction is negative: it must be >= 0",
        Model = -8: "unknown model: use one of the KSTRIP_MODEL constants",
        StripCount = -9: "unknown strip count: use 4, 8, 16, 32 or 64",
        Curvature = -10:
            "no elliptic contact: radii must not be zero, and the summed curvatures must be \
             positive in both directions",
        RollingSpeed = -11:
            "the rolling speed is not positive: let x point in the rolling direction",
        /// Or a count exceeds the capacity of a structure.
        Capacity = -12:
            "the array is too small: pass the capacity that the documentation of the function \
             states",
        NotInModel = -13:
            "the model cannot compute this output: take STRIP for strips and fields, and any model \
             but LINEAR for patches",
        Overflow = -14:
            "the result is beyond the range of the floating-point type: check the units (N, m, Pa)",
        FrictionRatio = -15: "the ratio of falling friction is outside [0, 1]",
        FrictionDecay = -16: "the decay of falling friction is negative: it must be >= 0 (s/m)",
        NegativeSpeed = -17: "the rolling speed is negative: it must be >= 0 (m/s)",
        SlopeFactor = -18: "the factor of the initial slope must be >= 0 and <= 1 (0 stands for 1)",
        Unexplained = -19:
            "no friction explains the measured force: it points against the slip, or there is no \
             load; check signs (forces act on the lower body) and creepage",
        ForceBeyondFriction = -20: "the requested force exceeds mu N: no creepage gives it",
        Measured = -21:
            "unknown measurement: use KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY, or both added",
        NotPrepared = -22:
            "a contact or a profile is not prepared: fill the structure with kstrip_prepare() or \
             kstrip_prepare_profile() of the same precision",
        FloorSpeed = -23:
            "the floor of the speed is negative: it must be > 0 (m/s), or 0 for the default",
        Stride = -24:
            "a stride of the batch is smaller than an output, or no multiple of its alignment: \
             pass the distance in bytes between two elements",
        SlideFactor = -25:
            "the factor of the creep curve in sliding must be >= 0 and <= 1 (0 stands for 1)",
        Layer = -26:
            "the layer between the bodies is negative: thickness divided by shear modulus must be \
             >= 0 (m/Pa)",
        FewPoints = -27:
            "fewer measured forces than parameters to fit: pass more points, or fit fewer \
             parameters",
        FitParameters = -28:
            "nothing to fit, or an unknown parameter: use the KSTRIP_FIT constants, added",
        Weight = -29:
            "the weight of a measured point is negative: it must be >= 0, 0 for a point that does \
             not count",
        StripSize = -40:
            "a strip of the patch has a width or a half length that is not positive (metres)",
        Pressure = -41: "the peak pressure of a strip is negative: it must be >= 0 (pascals)",
        StripOrder = -42: "strips of the patch overlap, or are not in ascending order of y",
        PatchSize = -43:
            "more strips than a patch has room for, or more contacts than a wheel may have: use \
             fewer and wider strips, or a smoother profile",
        Profile = -44:
            "a profile has too few points, two that coincide, or y that does not ascend; or the \
             lengths of a gap or the places of friction do not ascend",
        ProfileEnd = -45:
            "a profile ends where the bodies would touch, or the wheel is beside the rail: pass \
             more of the profile, or its rounded edge where the body ends",
        RollingRadius = -46:
            "a rolling radius or the radius of a wheel is not positive: it must be > 0 (metres)",
        SmoothingLength = -47:
            "the smoothing length is negative: it must be >= 0 (metres), 0 for the default",
        Scatter = -48:
            "the points of a profile scatter or turn back so far that no line follows them: pass \
             them in their order along the profile",
        NormalDamping = -49: "the normal damping is negative: it must be >= 0 (s/m)",
        Gauge = -60:
            "the track has neither a gauge nor places of its rails, or the wheelset no distance of \
             its wheels: they must be > 0 (metres)",
        WheelLifted = -61:
            "no position of the wheelset balances the loads while both wheels touch: a wheel lifts",
        Conicity = -62:
            "no wave of this amplitude: it must be > 0 (metres), within the shifts, and the radii \
             must bring the wheelset back to the middle",
    }
}

impl Error {
    /// This error, unless a condition holds.
    pub(crate) const fn unless(self, holds: bool) -> Result<(), Self> {
        if holds { Ok(()) } else { Err(self) }
    }

    /// This error, where a condition holds.
    pub(crate) const fn when(self, holds: bool) -> Result<(), Self> {
        self.unless(!holds)
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

statuses! {
    /// A warning about a valid result: none, or a positive status.
    #[derive(Default)]
    Warning {
        #[default]
        None = 0: "ok",
        SpinBeyondTheory = 1:
            "spin parameter |psi| >= 1: beyond the strip theory of 1967, result is its bounded \
             continuation; use STRIP or TOTAL",
        OutsideRange = 2:
            "an input is outside the range in which the model was checked; result is finite and \
             bounded by mu N",
        BeyondFriction = 3: "the linear force exceeds mu N; use a model with saturation",
        SeveralFrictions = 4:
            "more than one coefficient of friction fits: falling friction gives the largest \
             (reached from adhesion), an estimate the smallest",
        NotConverged = 5: "a bounded iteration ended before its result was accurate to rounding",
        FrictionAtLeast = 6:
            "the contact sticks, so that its force does not determine the friction: result is a \
             lower bound; measure at larger creepage",
        CreepageAtLeast = 7:
            "the requested force is that of full sliding: the result is the creepage that reaches \
             it, any larger one gives it as well",
        Pressure = 8:
            "implausible pressure: the peak pressure exceeds a tenth of the shear modulus; check \
             the units of modulus (Pa), load (N) and semi-axes (m)",
        Creepage = 9:
            "implausible creepage: above 10; check that it is a ratio, not per cent, and that the \
             contact rolls (at low speed use slip velocities)",
        SemiAxis = 10: "implausible semi-axis: above 1 m; check its unit (m, not mm)",
        Spin = 11:
            "implausible spin: more than rolling bodies of this size have; check its unit (rad/m, \
             not degrees)",
        Friction = 12:
            "implausible coefficient of friction: above 5; check that it is not a percentage",
        Radius = 13:
            "implausible radii: a wheel's above 5 m, or flatter than that in both directions; \
             check their unit (m, not mm)",
        AxisRatio = 14:
            "the axis ratio a/b is outside 0.015 to 60, the range for which the model was made; \
             result is finite, bounded by mu N and has the right limits",
        Mismatch = 15:
            "the mismatch of the materials exceeds 0.25, where the model was not checked; result \
             is finite and bounded by mu N",
        MismatchNeglected = 16:
            "the theory of 1967 neglects the mismatch of the materials; use another model, or set \
             it to 0",
        Conformal = 17:
            "too conformal: a semi-axis exceeds 0.3 of the smaller radius in its direction, so \
             that the bodies are no half-spaces; result is that of half-spaces",
        AngleRange = 19:
            "the normal turns by more than 30 degrees over a contact of the wheel: one plane of \
             contact is not enough",
        Undetermined = 20:
            "the points do not determine each fitted parameter: some have large standard errors; \
             fit fewer, or measure at other creepages",
        ProfileEnd = 18:
            "a zone of contact ends with the profile, as if the bodies ended there: unless they \
             do, pass more of the profile",
        Orientation = 21:
            "implausible profile: it stands upside down or the wrong way round; z must point down, \
             and the flange of a wheel and the gauge side of a rail lie at small y",
        ProfileSize = 22: "implausible profile: longer than 1 m; check its unit (m, not mm)",
        Modulus = 23:
            "implausible modulus: the shear modulus is below 0.1 MPa; check its unit (Pa, not MPa \
             or GPa)",
        Unset = 24:
            "friction and Poisson's ratio are both 0: set them, or one of them if this is meant",
        Support = 25:
            "no ordinary contact supports the wheel: the support falls with depth on the way to \
             this height (friction pulls the wheel down), or the peak pressure exceeds a twentieth \
             of the shear modulus; check velocity, friction and load",
        ProfileCoarse = 26:
            "the points of a profile are too far apart for a contact, which is less than four of \
             their distances wide: pass more points",
    }
}

/// Seriousness of warnings of implausible inputs.
const IMPLAUSIBLE: i32 = 3;

impl Warning {
    /// Whether the warning says that an input is implausible, mostly because of a wrong unit.
    #[must_use]
    pub const fn is_implausible(self) -> bool {
        self.gravity() == IMPLAUSIBLE
    }

    /// The more serious one. A warning that the result may be another one is more serious than one
    /// of implausible inputs, and that is more serious than one of inputs outside the range of the
    /// model. Of two that are equally serious the one with the larger code is returned.
    #[must_use]
    pub const fn worse(self, other: Self) -> Self {
        let (own, of_other) = (self.gravity(), other.gravity());
        let graver = of_other > own || (of_other == own && other.code() > self.code());
        if graver { other } else { self }
    }

    /// Seriousness of the warning: of two warnings the one with the larger number is returned.
    const fn gravity(self) -> i32 {
        match self {
            Self::NotConverged => 6,
            Self::SeveralFrictions | Self::Support => 5,
            Self::FrictionAtLeast | Self::CreepageAtLeast | Self::Undetermined => 4,
            Self::Pressure
            | Self::Creepage
            | Self::SemiAxis
            | Self::Spin
            | Self::Friction
            | Self::Radius
            | Self::Orientation
            | Self::ProfileSize
            | Self::Modulus
            | Self::Unset => IMPLAUSIBLE,
            Self::BeyondFriction | Self::AngleRange | Self::ProfileEnd | Self::ProfileCoarse => 2,
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
    if code < 0 { Error::advice(code) } else { Warning::advice(code) }
}

/// A text that ends with its only zero byte, as a C string.
pub(crate) const fn c_string(text: &'static str) -> &'static CStr {
    match CStr::from_bytes_with_nul(text.as_bytes()) {
        Ok(text) => text,
        Err(_) => c"",
    }
}
