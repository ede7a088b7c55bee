//! The law of falling friction, `μ(w) = μ₀ ((1 − A) exp(−B w) + A)`, and its derivatives.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::number::{Float, are_finite};
use crate::status::Error;

/// Falling friction: the coefficient is friction ((1 - ratio) exp(-decay w) +
/// ratio), where w is the sliding velocity \[m/s\]. A layer between the bodies makes the creep
/// curve less steep: slope_factor and slide_factor describe it for a measured or published curve,
/// and layer is an elastic layer that is known.
///
/// Polach, Wear 258 (2005) 992, gives for locomotives: dry friction 0.55, ratio 0.4, decay 0.6 s/m;
/// wet 0.3, 0.4, 0.2 s/m. KSTRIP_ERROR_MODEL_LEFT_OUT if this build of the library has no laws.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SlipFriction<F> {
    /// Coefficient of friction without slip \[-\], >= 0, else KSTRIP_ERROR_FRICTION.
    pub friction: F,
    /// Friction at infinite sliding velocity divided by friction at zero velocity \[-\], 0 to 1,
    /// else KSTRIP_ERROR_FRICTION_RATIO; 1: friction is constant.
    pub ratio: F,
    /// How fast friction falls \[s/m\], >= 0, else KSTRIP_ERROR_FRICTION_DECAY; 0: it is constant.
    pub decay: F,
    /// Rolling speed \[m/s\], >= 0, else KSTRIP_ERROR_NEGATIVE_SPEED; the sliding velocity is slip
    /// times rolling speed. 0: friction is constant.
    pub rolling_speed: F,
    /// Initial slope of the creep curve divided by that of clean bodies \[-\], 0 to 1, else
    /// KSTRIP_ERROR_SLOPE_FACTOR; 0 stands for 1, clean.
    pub slope_factor: F,
    /// Stretch of the creep curve far in sliding divided by that at its start \[-\], 0 to 1, else
    /// KSTRIP_ERROR_SLIDE_FACTOR; 0 stands for 1: the whole curve is stretched alike.
    pub slide_factor: F,
    /// Thickness of an elastic layer between the bodies divided by its shear modulus \[m/Pa\],
    /// >= 0, else KSTRIP_ERROR_LAYER; 0: none.
    pub layer: F,
}

/// How friction `μ = g(s)` follows all that it depends on, by the implicit function theorem:
///
/// ```text
/// dμ/dp = (∂g/∂p + g' ∂s/∂p)/(1 − g' ∂s/∂μ)
/// ```
pub(crate) struct FrictionSlopes<F> {
    /// `∂g/∂p` at constant slip, for each parameter of the law.
    pub(crate) friction: F,
    pub(crate) ratio: F,
    pub(crate) decay: F,
    pub(crate) rolling_speed: F,
    /// `g'`
    slip: F,
    /// `1/(1 − g' ∂s/∂μ)`
    pub(crate) feedback: F,
}

impl<F: Float> FrictionSlopes<F> {
    /// `dμ/dp` from `∂g/∂p` and `∂s/∂p`.
    pub(crate) fn along(&self, direct: F, slip: F) -> F {
        (direct + self.slip * slip) * self.feedback
    }
}

impl<F: Float> SlipFriction<F> {
    /// Whether the library was built with laws of friction (feature `law`).
    pub const HAS_LAW: bool = cfg!(feature = "law");
    /// Whether the library was built with layers and slide factors (feature `layer`).
    pub const HAS_LAYER: bool = cfg!(feature = "layer");

    /// # Errors
    /// [`Error::NotFinite`], [`Error::Friction`], [`Error::FrictionRatio`],
    /// [`Error::FrictionDecay`], [`Error::NegativeSpeed`], [`Error::SlopeFactor`],
    /// [`Error::SlideFactor`], [`Error::Layer`]; [`Error::ModelLeftOut`] for a law, a layer or a
    /// slide factor that the library was built without.
    pub fn check(&self) -> Result<(), Error> {
        Error::ModelLeftOut.unless(Self::HAS_LAW)?;
        let Self { friction, ratio, decay, rolling_speed, .. } = *self;
        let Self { slope_factor, slide_factor, layer, .. } = *self;
        let inputs = [friction, ratio, decay, rolling_speed, slope_factor, slide_factor, layer];
        let (zero, one) = (F::zero(), F::one());
        Error::NotFinite.unless(are_finite(&inputs))?;
        Error::Friction.unless(friction >= zero)?;
        Error::FrictionRatio.unless(ratio >= zero && ratio <= one)?;
        Error::FrictionDecay.unless(decay >= zero)?;
        Error::NegativeSpeed.unless(rolling_speed >= zero)?;
        Error::SlopeFactor.unless(slope_factor >= zero && slope_factor <= one)?;
        Error::SlideFactor.unless(slide_factor >= zero && slide_factor <= one)?;
        Error::Layer.unless(layer >= zero)?;
        let beyond = layer > zero || slide_factor > zero;
        Error::ModelLeftOut.unless(Self::HAS_LAYER || !beyond)
    }

    /// `μ` for a slip `s` over rolling speed.
    #[must_use]
    pub fn at(&self, slip: F) -> F {
        self.friction * (self.falling_share(slip) + self.ratio)
    }

    /// `(1 − A) exp(−B V s)`
    fn falling_share(&self, slip: F) -> F {
        // Two factors: B V may overflow where B V s does not.
        let exponent = self.decay * (self.rolling_speed * slip.max(F::zero()));
        (F::one() - self.ratio) * (-exponent).exp()
    }

    /// Constant friction, clean bodies.
    #[must_use]
    pub fn of_constant(friction: F) -> Self {
        Self { friction, ratio: F::one(), ..Self::default() }
    }

    /// The derivatives of `μ = μ₀ ((1 − A) exp(−B V s) + A)` at a slip, from `∂s/∂μ`; without
    /// `moves` friction does not follow the slip.
    pub(crate) fn slopes(&self, slip: F, moves: bool, slip_by_friction: F) -> FrictionSlopes<F> {
        let Self { friction, decay, rolling_speed, .. } = *self;
        // (1 − A) exp(−B V s), and without the factor
        let share = self.falling_share(slip);
        let whole = Self { ratio: F::zero(), ..*self }.falling_share(slip);
        let falling = -(friction * share);
        let moves = moves && slip > F::zero();
        let by_slip = if moves { falling * rolling_speed * decay } else { F::zero() };
        FrictionSlopes {
            friction: share + self.ratio,
            ratio: friction * (F::one() - whole),
            decay: falling * rolling_speed * slip,
            rolling_speed: falling * decay * slip,
            slip: by_slip,
            feedback: F::one() / (F::one() - by_slip * slip_by_friction),
        }
    }

    /// Whether friction depends on the slip.
    pub(crate) fn falls(&self) -> bool {
        self.ratio < F::one() && self.decay > F::zero() && self.rolling_speed > F::zero()
    }

    /// `k`, or 1 where `k` is zero.
    pub(crate) fn slope_or_one(&self) -> F {
        if self.slope_factor > F::zero() { self.slope_factor } else { F::one() }
    }

    /// The contact at the largest friction, with the stiffness of the layer.
    pub(crate) fn contact(&self, contact: &Contact<F>) -> Contact<F> {
        // The layer takes its share of every slip, also of that which the pressure of the solids
        // makes: κ/G stays.
        let [shear_modulus, mismatch] =
            [contact.shear_modulus, contact.mismatch].map(|number| number * self.slope_or_one());
        Contact { friction: self.friction, shear_modulus, mismatch, ..*contact }
    }

    /// The least friction that the law can give a contact in motion, and an upper bound of `g'`
    /// there: `g' ≤ B V s_max (1 − A) μ₀/μ`.
    pub(crate) fn least_friction(&self, contact: &Contact<F>, creepage: &Creepage<F>) -> (F, F) {
        if !self.falls() {
            return (self.friction, F::zero());
        }
        let slip = contact.fastest_slip(creepage);
        let least = self.at(slip);
        let falling = (F::one() - self.ratio) * self.friction;
        (least, self.decay * (self.rolling_speed * slip) * (falling / (least + F::TINY)))
    }
}
