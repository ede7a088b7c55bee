//! Errors in inputs, and warnings about results.

use core::ffi::CStr;
use core::fmt;

/// Result of a call: 0 ok; > 0 warning, outputs valid; < 0 error, outputs untouched.
#[allow(non_camel_case_types)]
pub type kstrip_status = i32;

/// The statuses of a kind, each with its names in C and in Rust, its number, which is never reused,
/// what it means (the comment of the header), and what else a caller should know.
macro_rules! statuses {
    ($(#[$about:meta])* $name:ident { $($(#[$is:meta])*
        $constant:ident $variant:ident = $number:literal $(gravity $gravity:tt)?:
            $means:literal $(, $remedy:literal)?;
    )* }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(i32)]
        #[non_exhaustive]
        pub enum $name {
            $(#[doc = $means] $(#[$is])* $variant = $number,)*
        }
        $(
            #[doc = $means]
            pub const $constant: kstrip_status = $number;
        )*

        impl $name {
            /// The status of the C interface.
            #[must_use]
            pub const fn code(self) -> i32 {
                self as i32
            }

            /// The one of the larger gravity, of two that are equally serious the one of the larger
            /// code.
            #[must_use]
            pub const fn worse(self, other: Self) -> Self {
                let (own, of_other) = (self.gravity(), other.gravity());
                let graver = of_other > own || (of_other == own && other.code() > self.code());
                if graver { other } else { self }
            }

            const fn gravity(self) -> i32 {
                match self {
                    $(Self::$variant => 0 $(+ $gravity)?,)*
                }
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
                    $($number => {
                        Some(const { c_string(concat!($means, $(": ", $remedy,)? "\0")) })
                    })*
                    _ => None,
                }
            }
        }
    };
}

statuses! {
    /// An input without a result, with a negative status. Nothing has been computed or written.
    Error {
        KSTRIP_ERROR_NULL NullPointer = -1:
            "a required pointer is NULL", "pass the address of a structure or array";
        KSTRIP_ERROR_NOT_FINITE NotFinite = -2:
            "an input is infinite or NaN", "pass finite numbers";
        KSTRIP_ERROR_SEMI_AXIS SemiAxis = -3:
            "a semi-axis is not positive", "a and b must be > 0 (metres)";
        KSTRIP_ERROR_NORMAL_FORCE NormalForce = -4:
            "the normal force of two profiles or of a contact of a wheel is negative",
            "compression is positive (newtons), so its sign is probably reversed";
        KSTRIP_ERROR_MODULUS Modulus = -5:
            "a modulus of elasticity is not positive", "it must be > 0 (pascals)";
        KSTRIP_ERROR_POISSON_RATIO PoissonRatio = -6:
            "Poisson's ratio is outside [0, 0.5]", "steel has 0.28";
        KSTRIP_ERROR_FRICTION Friction = -7:
            "the coefficient of friction is negative", "it must be >= 0";
        KSTRIP_ERROR_MODEL Model = -8:
            "the model is not one of the KSTRIP_MODEL constants", "0 is the default";
        KSTRIP_ERROR_STRIP_COUNT StripCount = -9:
            "the strip count is not 4, 8, 16, 32 or 64", "0 stands for 16";
        KSTRIP_ERROR_CURVATURE Curvature = -10:
            "a radius is zero or NaN, or the summed curvature in a plane is not positive",
            "a flat body has the radius INFINITY, and a concave one a negative radius";
        KSTRIP_ERROR_ROLLING_SPEED RollingSpeed = -11:
            "the rolling speed is not positive", "let x point in the rolling direction";
        KSTRIP_ERROR_CAPACITY Capacity = -12:
            "the caller's array is too small, or a count exceeds the capacity of a structure",
            "pass the capacity that the documentation of the function states";
        KSTRIP_ERROR_NOT_IN_MODEL NotInModel = -13:
            "the model cannot compute a requested output, because it has no strips, no field or no \
             patches, or its force does not depend on friction",
            "take STRIP for strips and fields, and any model but LINEAR for patches";
        KSTRIP_ERROR_OVERFLOW Overflow = -14:
            "a result is beyond the range of the floating-point type",
            "check the units (N, m, Pa)";
        KSTRIP_ERROR_FRICTION_RATIO FrictionRatio = -15:
            "the ratio of falling friction is outside [0, 1]", "1 stands for constant friction";
        KSTRIP_ERROR_FRICTION_DECAY FrictionDecay = -16:
            "the decay of falling friction is negative", "it must be >= 0 (s/m)";
        KSTRIP_ERROR_NEGATIVE_SPEED NegativeSpeed = -17:
            "the rolling speed of falling friction is negative", "it must be >= 0 (m/s)";
        KSTRIP_ERROR_SLOPE_FACTOR SlopeFactor = -18:
            "the factor of the initial slope is outside [0, 1]", "0 stands for 1";
        KSTRIP_ERROR_UNEXPLAINED Unexplained = -19:
            "no friction explains the measured force",
            "check signs (forces act on the lower body) and creepage";
        KSTRIP_ERROR_FORCE_BEYOND_FRICTION ForceBeyondFriction = -20:
            "the requested force exceeds mu N, or the torque about an axle exceeds the torque that \
             friction carries at any pitch rate",
            "request less: a force below mu N, or a torque below friction times load times rolling \
             radius of both wheels together";
        KSTRIP_ERROR_MEASURED Measured = -21:
            "the measurement is not one of KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY, or their sum",
            "name the components that were measured";
        KSTRIP_ERROR_NOT_PREPARED NotPrepared = -22:
            "a structure was not filled by kstrip_prepare() of the same precision, or a profile \
             not by kstrip_prepare_profile()",
            "fill it first";
        KSTRIP_ERROR_FLOOR_SPEED FloorSpeed = -23:
            "the floor of the speed is negative", "it must be > 0 (m/s), or 0 for the default";
        KSTRIP_ERROR_STRIDE Stride = -24:
            "the stride of an output of a batch is smaller than the output, or a stride is not a \
             multiple of the alignment",
            "pass the distance in bytes between two elements";
        KSTRIP_ERROR_SLIDE_FACTOR SlideFactor = -25:
            "the slide factor is outside [0, 1]", "0 stands for 1";
        KSTRIP_ERROR_LAYER Layer = -26:
            "the layer between the bodies is negative",
            "thickness divided by shear modulus must be >= 0 (m/Pa)";
        KSTRIP_ERROR_FEW_POINTS FewPoints = -27:
            "there are fewer measured forces than parameters to fit",
            "pass more points, or fit fewer parameters";
        KSTRIP_ERROR_FIT_PARAMETERS FitParameters = -28:
            "no parameter is to be fitted, or the number is not a sum of KSTRIP_FIT constants",
            "add the constants of the parameters to fit";
        KSTRIP_ERROR_WEIGHT Weight = -29:
            "the weight of a measured point is negative",
            "it must be >= 0, 0 for a point that is ignored";
        KSTRIP_ERROR_MODEL_LEFT_OUT ModelLeftOut = -30:
            "the model, or its falling friction or layer, was left out of this build of the \
             library",
            "take another model, or build the library with this feature";
        KSTRIP_ERROR_MODULUS_UNIT ModulusUnit = -31:
            "the wheel finds no support, and the shear modulus is below 0.1 MPa: it is probably in \
             MPa or GPa",
            "pass it in pascals, 82e9 for steel";
        KSTRIP_ERROR_STRIP_SIZE StripSize = -40:
            "a strip of a patch has a width or half length that is not positive",
            "they must be > 0 (metres)";
        KSTRIP_ERROR_PRESSURE Pressure = -41:
            "the peak pressure of a strip is negative", "it must be >= 0 (pascals)";
        KSTRIP_ERROR_STRIP_ORDER StripOrder = -42:
            "strips of a patch overlap, or do not ascend in y",
            "kstrip_patch_from_strips() sorts them; narrow the strips that overlap";
        KSTRIP_ERROR_PATCH_SIZE PatchSize = -43:
            "there are more strips than a patch can hold, or more contacts than a wheel may have",
            "use fewer and wider strips, or a smoother profile";
        KSTRIP_ERROR_PROFILE Profile = -44:
            "a profile has too few points or a negative step, or numbers that must ascend do not",
            "pass at least 2 points, 4 for kstrip_prepare_profile(), and sort the y of a patch, \
             gap lengths, friction places and shifts";
        KSTRIP_ERROR_PROFILE_END ProfileEnd = -45:
            "a profile ends where the bodies would touch, or the wheel is beside the rail",
            "pass more of the profile, or its rounded edge where the body ends";
        KSTRIP_ERROR_ROLLING_RADIUS RollingRadius = -46:
            "a rolling radius or the radius of a wheel is not positive",
            "it must be > 0 (metres)";
        KSTRIP_ERROR_SMOOTHING_LENGTH SmoothingLength = -47:
            "a smoothing length is negative", "it must be >= 0 (metres), 0 for the default";
        KSTRIP_ERROR_SCATTER Scatter = -48:
            "no line follows the points of a profile, because they scatter or turn back too far",
            "pass them in their order along the profile";
        KSTRIP_ERROR_NORMAL_DAMPING NormalDamping = -49:
            "the damping of the pressure is negative", "it must be >= 0 (s/m)";
        KSTRIP_ERROR_SHARE Share = -50:
            "the share of a contact of a wheel is negative", "it must be 0 to 1";
        KSTRIP_ERROR_SUPPORT Support = -51:
            "the requested support of a wheel, or the vertical load of a wheelset, is not positive",
            "it must be > 0 (newtons); the support points up and the load down";
        KSTRIP_ERROR_ANGLE Angle = -52:
            "a yaw, roll or cant is 1 rad or more, or a wheel beside the rail has a yaw or roll \
             above 0.2 rad",
            "it is probably in degrees: multiply it by 0.01745 to have it in radians";
        KSTRIP_ERROR_LENGTH_UNIT LengthUnit = -53:
            "the wheel is over 0.7 m beside or 5 m above or below the rail, its radius exceeds 5 \
             m, or a profile 1 m",
            "lengths are in metres, and a position, a gauge, a distance of the wheels or a profile \
             is probably in mm";
        KSTRIP_ERROR_SWAPPED Swapped = -54:
            "the wheel is beside the rail, the rail's profile has a flange, and the wheel's \
             profile has the head of a rail",
            "they are probably swapped: pass the rail before the wheel";
        KSTRIP_ERROR_ORIENTATION Orientation = -55:
            "the wheel is beside the rail, and a profile is upside down, the wrong way round, or \
             neither a wheel nor a rail",
            "z must point down, and the flange of a wheel and the gauge side of a rail lie at \
             small y";
        KSTRIP_ERROR_GAUGE Gauge = -60:
            "a gauge, a place of a rail or a distance of wheels is missing or negative",
            "they must be > 0 (metres)";
        KSTRIP_ERROR_WHEEL_LIFTED WheelLifted = -61:
            "no position of the wheelset balances the loads, because a wheel lifts",
            "reduce the roll moment, or increase the vertical load";
        KSTRIP_ERROR_CONICITY Conicity = -62:
            "no wave has this amplitude: it is not positive or beyond the shifts, or the radii \
             turn the wheelset away from the middle",
            "pass amplitudes within the shifts (metres), and differences of the radii that grow \
             with the shift";
        KSTRIP_ERROR_FILE_FORMAT FileFormat = -70:
            "the format of a profile file is not one of the constants",
            "pass KSTRIP_FORMAT_ANY";
        KSTRIP_ERROR_FILE_LINE FileLine = -71:
            "a line of a profile file is not a point, a keyword or a title of its format",
            "check that the file is text in UTF-8, and that its format is the one that is passed";
        KSTRIP_ERROR_FILE_COLUMNS FileColumns = -72:
            "a table has more than two columns, and no line before it names y and z",
            "name its columns, or leave out the others";
        KSTRIP_ERROR_FILE_COUNT FileCount = -73:
            "a profile file has fewer points than its header promises",
            "the file is probably cut: copy it again, or correct the number in its header";
        KSTRIP_ERROR_FILE_UNITS FileUnits = -74:
            "the unit of a profile file is not positive, or its numbers are too large for a \
             profile in millimetres",
            "name the unit in the line with the names of the columns";
        KSTRIP_ERROR_FILE_MISSING FileMissing = -75:
            "a number of a table is far from all others, and probably marks a missing number",
            "leave out its line";
        KSTRIP_ERROR_SLICE_SHARE SliceShare = -76:
            "the share of a profile between two slices is not in 0 to 1",
            "pass the distance from the first slice divided by the distance between both";
        KSTRIP_ERROR_TABLE Table = -80:
            "the memory is not a contact table of this version: it is damaged, cut off, or \
             something else",
            "build the table again";
        KSTRIP_ERROR_TABLE_UNFINISHED TableUnfinished = -81:
            "a contact table is not finished, or a finished table is to be filled",
            "fill all parts, and then finish it";
        KSTRIP_ERROR_TABLE_PAIR TablePair = -82:
            "a contact table was made for another radius, material or smoothing length, or the \
             rail is a roller",
            "pass the pair that the table was made for, with a straight rail";
        KSTRIP_ERROR_TABLE_SPEC TableSpec = -83:
            "a contact table's range is empty, negative or without contact, nodes are too few, \
             strips are not 12 to 32, or no such part exists",
            "pass ranges with contacts, and the parts that kstrip_table_size() counts";
        KSTRIP_ERROR_TABLE_RANGE TableRange = -84:
            "a position is outside the ranges of a contact table, or its load is above the \
             largest",
            "call kstrip_wheel_on_rail() there";
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
}

impl fmt::Display for Error {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = advice(self.code()).and_then(|text| text.to_str().ok());
        out.write_str(text.unwrap_or("unknown error"))
    }
}

impl core::error::Error for Error {}

statuses! {
    /// A warning about a valid result: none, or a positive status. A warning that the result may be
    /// another one is more serious than one of implausible inputs, and that is more serious than
    /// one of inputs outside the range of the model.
    #[derive(Default)]
    Warning {
        #[default]
        KSTRIP_OK None = 0: "ok";
        KSTRIP_WARNING_SPIN SpinBeyondTheory = 1 gravity 1:
            "the spin parameter |psi| is 1 or more, which is beyond the theory of 1967",
            "the result is a continuation by this library, bounded by mu N: use STRIP or TOTAL";
        KSTRIP_WARNING_RANGE OutsideRange = 2 gravity 1:
            "|psi| is above 3, beyond the comparison of KSTRIP_MODEL_STRIP with CONTACT",
            "the result is bounded by mu N";
        KSTRIP_WARNING_BEYOND_FRICTION BeyondFriction = 3 gravity 2:
            "the force of KSTRIP_MODEL_LINEAR exceeds mu N", "use a model with saturation";
        KSTRIP_WARNING_SEVERAL_FRICTIONS SeveralFrictions = 4 gravity 5:
            "more than one coefficient of friction fits: with falling friction the result has the \
             largest, reached from rest; an estimate is the smallest";
        KSTRIP_WARNING_NOT_CONVERGED NotConverged = 5 gravity 6:
            "an iteration ended before its result was accurate to rounding",
            "the result is the nearest that was found";
        KSTRIP_WARNING_FRICTION_AT_LEAST FrictionAtLeast = 6 gravity 4:
            "the contact sticks, so that the result is only a lower bound of friction",
            "measure at larger creepage";
        KSTRIP_WARNING_CREEPAGE_AT_LEAST CreepageAtLeast = 7 gravity 4:
            "the requested force is that of full sliding, and every larger creepage has it as well",
            "request less force, if one creepage is needed";
        KSTRIP_WARNING_PRESSURE Pressure = 8 gravity IMPLAUSIBLE:
            "implausible pressure, above a tenth of the shear modulus: the modulus (Pa), the \
             load (N) or the semi-axes (m) are probably in another unit";
        KSTRIP_WARNING_CREEPAGE Creepage = 9 gravity IMPLAUSIBLE:
            "implausible creepage, above 10: it is probably in per cent, or the contact hardly \
             rolls (at low speed use slip velocities)";
        KSTRIP_WARNING_SEMI_AXIS SemiAxis = 10 gravity IMPLAUSIBLE:
            "implausible semi-axis, above 1 m: it is probably in mm";
        KSTRIP_WARNING_SPIN_UNIT Spin = 11 gravity IMPLAUSIBLE:
            "implausible spin, larger than rolling bodies of this curvature can have: it is \
             probably in degrees per metre";
        KSTRIP_WARNING_FRICTION Friction = 12 gravity IMPLAUSIBLE:
            "implausible coefficient of friction, above 5: it is probably in per cent";
        KSTRIP_WARNING_RADIUS Radius = 13 gravity IMPLAUSIBLE:
            "implausible radii, larger than 5 m in both directions: they are probably in mm";
        KSTRIP_WARNING_AXIS_RATIO AxisRatio = 14 gravity 1:
            "the axis ratio a/b is outside 0.015 to 60, the range for which the model was made",
            "the result is bounded by mu N and has the right limits";
        KSTRIP_WARNING_MISMATCH Mismatch = 15 gravity 1:
            "the mismatch of the materials exceeds 0.25, and the model was not compared with its \
             reference there",
            "the result is bounded by mu N";
        KSTRIP_WARNING_MISMATCH_NEGLECTED MismatchNeglected = 16 gravity 1:
            "the theory of 1967 neglects the mismatch of the materials",
            "use another model, or set it to 0";
        KSTRIP_WARNING_CONFORMAL Conformal = 17 gravity 1:
            "a semi-axis exceeds 0.3 of the smaller radius in its direction, so that the bodies \
             are not half-spaces",
            "the result is for half-spaces";
        KSTRIP_WARNING_ANGLE_RANGE AngleRange = 19 gravity 2:
            "the normal turns by more than 30 degrees over a contact of a wheel: forces may be off \
             by some tenths of mu N";
        KSTRIP_WARNING_PROFILE_END ProfileEnd = 18 gravity 2:
            "a contact region ends with the profile, as if the bodies ended there",
            "unless they do, pass more of the profile";
        KSTRIP_WARNING_UNDETERMINED Undetermined = 20 gravity 4:
            "the measured points do not determine each parameter of a law",
            "fit fewer parameters, or measure at other creepages";
        KSTRIP_WARNING_ORIENTATION Orientation = 21 gravity IMPLAUSIBLE:
            "implausible profile, upside down or the wrong way round, or a contact of a wheel \
             above 30 degrees",
            "z must point down, and the flange of a wheel and the gauge side of a rail lie at \
             small y";
        KSTRIP_WARNING_PROFILE_SIZE ProfileSize = 22 gravity IMPLAUSIBLE:
            "implausible profile, longer than 1 m: it is probably in mm";
        KSTRIP_WARNING_MODULUS Modulus = 23 gravity IMPLAUSIBLE:
            "implausible shear modulus, below 0.1 MPa or above 10 TPa: it is probably in another \
             unit than Pa";
        KSTRIP_WARNING_UNSET Unset = 24 gravity IMPLAUSIBLE:
            "friction and Poisson's ratio of a wheel and a rail are both 0",
            "set both, or one of them if the other is meant to be 0";
        KSTRIP_WARNING_SUPPORT Support = 25 gravity 5:
            "no ordinary contact supports the wheel: its support falls with depth, or its peak \
             pressure exceeds a twentieth of the shear modulus",
            "friction may pull the wheel down: check lateral position, velocity, friction and load";
        KSTRIP_WARNING_PROFILE_COARSE ProfileCoarse = 26 gravity 2:
            "a contact of a wheel is narrower than four point spacings of a profile, so that the \
             pressure depends on the shape between the points",
            "pass more points";
        KSTRIP_WARNING_ROUGH Rough = 27 gravity 2:
            "a contact has more local minima than its strips resolve, or a wheel has more than \
             four contacts: the load may jump",
            "smooth the profile, or take more strips";
        KSTRIP_WARNING_CURVATURE Curvature = 28 gravity IMPLAUSIBLE:
            "implausible curvature of the track, above 0.2 per m: it is probably the radius of \
             the curve",
            "pass 1 divided by the radius";
        KSTRIP_WARNING_YOUNG Young = 29 gravity IMPLAUSIBLE:
            "implausible shear modulus, above 150 GPa: it is probably Young's modulus E",
            "the shear modulus is E/(2 (1 + nu)), 82e9 for steel";
        KSTRIP_WARNING_PER_CENT PerCent = 30 gravity IMPLAUSIBLE:
            "implausible slope factor, fitted below 0.05: the creepages are probably in per cent",
            "divide them by 100";
        KSTRIP_WARNING_DAMPING Damping = 31 gravity IMPLAUSIBLE:
            "implausible damping, which more than doubles the pressure: it is probably in N s/m",
            "pass the damping divided by the load, in s/m";
        KSTRIP_WARNING_SECOND_MINIMUM SecondMinimum = 32 gravity 2:
            "another law fits the measured points as well: its residual is at most 1 per cent \
             larger",
            "fit fewer parameters, or measure at other creepages";
        KSTRIP_WARNING_FIT_BOUND FitBound = 33 gravity 2:
            "a fitted parameter of a law is at its bound, and beyond it the law would fit the \
             measured points better",
            "check the units of the points, or fit other parameters";
        KSTRIP_WARNING_PROFILE_GUESS ProfileGuess = 34 gravity IMPLAUSIBLE:
            "kind, side, direction of z, origin or unit of a profile file are guessed from weak \
             evidence, or contradict the file",
            "check the notes";
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

    /// The first one whose condition holds, or none.
    pub(crate) fn first(of: &[(bool, Self)]) -> Self {
        of.iter().find(|(holds, _)| *holds).map_or(Self::None, |(_, warning)| *warning)
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
