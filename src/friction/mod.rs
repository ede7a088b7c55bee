//! Friction that falls with the slip, and reduced initial slope (Polach).
//!
//! O. Polach, *Creep forces in simulations of traction vehicles running on adhesion limit*, Wear 258 (2005) 992:
//! measured traction curves have a maximum, because friction falls with the sliding velocity `w`, and a
//! flatter start than clean contacts, because of the layer between the bodies.
//!
//! ```text
//! μ(w) = μ₀ ((1 − A) exp(−B w) + A),   w = V s
//! ```
//!
//! **The slip.** Polach takes the whole creepage for `s`, also where the contact sticks. Here `s` is the slip that there is:
//! the mean over the contact, weighted with friction, `s = P/(μ N)`, `P` the frictional power over rolling speed.
//! It is zero without slip and the creepage in full sliding without spin, where both agree.
//! `s` depends on the forces, hence on `μ`, and `μ` on `s`: a scalar equation `μ = g(μ)`.
//!
//! **The solution.** `s` falls as `μ` grows (but for a hair in spin near full sliding), so `g` increases: from
//! `μ₀`, `μ ← g(μ)` falls monotonically to the largest solution, the one that is reached from adhesion. With `−μ ds/dμ ≤ s_max`, the rigid slip, `g' < 1`
//! everywhere for all but extreme `B`; then the solution is unique and the secant method finds
//! it in four to six solutions of the contact. Otherwise the iteration
//! goes down from `μ₀` and up from the smallest possible `μ`, and a notice tells when they do not meet.
//! The forces of the models of 1967 jump, or nearly do, where adhesion is born, so that `g` may be steeper than that bound: for them
//! another solution may not be reported.
//! Derivatives follow by the implicit function theorem, `∂s/∂μ` by homogeneity ([`derivatives`]).
//!
//! **The slope factor** `k` multiplies the shear modulus: a contact with the layer is as stiff as one of
//! modulus `k G`. Forces depend on `G c/(μ N)` only, so the creep curve is stretched along the creepage by
//! `1/k` and keeps its shape and its saturation; patch and pressure stay.

mod agreement;

pub(crate) use self::agreement::Agreement;

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::number::Float;
use crate::solve::derivatives;
use crate::solve::model::{self, Model, Options, Precision, Solution};
use crate::status::{Error, Notice};

/// Friction that falls with the slip: the coefficient is friction ((1 - ratio) exp(-decay w) + ratio), where w is the sliding velocity
/// \[m/s\]. A factor reduces the initial slope of the creep curve, for the layer between the bodies.
///
/// Polach, Wear 258 (2005) 992, gives for locomotives: dry friction 0.55, ratio 0.4, decay 0.6 s/m; wet 0.3, 0.4, 0.2 s/m.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlipFriction<F> {
    /// Coefficient of friction without slip \[-\], >= 0.
    pub friction: F,
    /// Friction at infinite sliding velocity over friction at zero velocity \[-\], 0 to 1; 1: friction is constant.
    pub ratio: F,
    /// How fast friction falls \[s/m\], >= 0; 0: friction is constant.
    pub decay: F,
    /// Rolling speed \[m/s\], >= 0: sliding velocity is slip times rolling speed; 0: friction is constant.
    pub rolling_speed: F,
    /// Initial slope of the creep curve over that of clean bodies \[-\], 0 to 1; 0 stands for 1, clean.
    pub slope_factor: F,
}

/// Derivatives of the law at constant slip, and by the slip.
pub(crate) struct FrictionSlopes<F> {
    pub(crate) friction: F,
    pub(crate) ratio: F,
    pub(crate) decay: F,
    pub(crate) rolling_speed: F,
    pub(crate) slip: F,
}

/// Forces under friction that falls with the slip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionSolution<F> {
    /// The forces; its notice is also that of the friction.
    pub solution: Solution<F>,
    /// The coefficient of friction that agrees with the slip.
    pub friction: F,
}

impl<F: Float> SlipFriction<F> {
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Friction`], [`Error::FrictionRatio`], [`Error::FrictionDecay`],
    /// [`Error::NegativeSpeed`], [`Error::SlopeFactor`].
    pub fn check(&self) -> Result<(), Error> {
        let Self { friction, ratio, decay, rolling_speed, slope_factor } = *self;
        let inputs = [friction, ratio, decay, rolling_speed, slope_factor];
        if !inputs.iter().all(|input| input.is_finite_number()) {
            return Err(Error::NotFinite);
        }
        if friction < F::zero() {
            return Err(Error::Friction);
        }
        if ratio < F::zero() || ratio > F::one() {
            return Err(Error::FrictionRatio);
        }
        if decay < F::zero() {
            return Err(Error::FrictionDecay);
        }
        if rolling_speed < F::zero() {
            return Err(Error::NegativeSpeed);
        }
        if slope_factor < F::zero() || slope_factor > F::one() {
            return Err(Error::SlopeFactor);
        }
        Ok(())
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
        (F::one() - self.ratio) * (-exponent.min(F::constant(1e4))).exp()
    }

    /// Constant friction, clean bodies.
    #[must_use]
    pub fn constant(friction: F) -> Self {
        let zero = F::zero();
        Self { friction, ratio: F::one(), decay: zero, rolling_speed: zero, slope_factor: zero }
    }

    /// The derivatives of `μ = μ₀ ((1 − A) exp(−B V s) + A)`.
    pub(crate) fn slopes(&self, slip: F) -> FrictionSlopes<F> {
        let Self { friction, decay, rolling_speed, .. } = *self;
        // (1 − A) exp(−B V s), and without the factor
        let share = self.falling_share(slip);
        let whole = Self { ratio: F::zero(), ..*self }.falling_share(slip);
        let falling = -(friction * share);
        FrictionSlopes {
            friction: share + self.ratio,
            ratio: friction * (F::one() - whole),
            decay: falling * rolling_speed * slip,
            rolling_speed: falling * decay * slip,
            slip: falling * rolling_speed * decay,
        }
    }

    /// Whether friction depends on the slip.
    pub(crate) fn falls(&self) -> bool {
        self.ratio < F::one() && self.decay > F::zero() && self.rolling_speed > F::zero()
    }

    /// `k`, or 1 where `k` is zero.
    pub(crate) fn stiffness(&self) -> F {
        if self.slope_factor > F::zero() { self.slope_factor } else { F::one() }
    }

    /// The contact at the largest friction, with the stiffness of the layer.
    fn contact(&self, contact: &Contact<F>) -> Contact<F> {
        // The layer takes its share of every slip, also of that which the pressure of the solids makes: κ/G stays.
        let [shear_modulus, mismatch] =
            [contact.shear_modulus, contact.mismatch].map(|number| number * self.stiffness());
        Contact { friction: self.friction, shear_modulus, mismatch, ..*contact }
    }
}

/// Forces for a contact, a creepage and friction that falls with the slip.
///
/// The contact's own coefficient of friction is ignored. With `A = 1`, `B = 0` or `V = 0`, and `k = 1`, the result is that of
/// [`model::solve`] to the bit and costs no more. [`Model::Linear`] knows no friction: only `k` counts.
///
/// # Errors
/// Those of [`model::solve`] and [`SlipFriction::check`].
///
/// # Example
/// A driven wheel that slips more pulls less:
/// ```
/// use kstrip::{contact::Contact, contact::creepage::Creepage, friction::{solve, SlipFriction}, solve::model::Options};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, shear_modulus: 82e9, poisson_ratio: 0.28, friction: 0.0,
///     mismatch: 0.0,
/// };
/// let wet = SlipFriction {
///     friction: 0.3, ratio: 0.4, decay: 0.6, rolling_speed: 20.0, slope_factor: 0.5,
/// };
/// let pull = |slip: f64| {
///     let creepage = Creepage { longitudinal: slip, lateral: 0.0, spin: 0.0 };
///     solve(&contact, &creepage, &wet, &Options::default()).map(|found| found.solution.fx)
/// };
/// assert!(pull(0.02)? > pull(0.005)? && pull(0.02)? > pull(0.1)?);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn solve<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    friction: &SlipFriction<F>,
    options: &Options,
) -> Result<FrictionSolution<F>, Error> {
    let (contact, notice) = under(contact, creepage, friction, options)?;
    let mut solution = model::solve(&contact, creepage, options)?;
    solution.notice = solution.notice.worse(notice);
    Ok(FrictionSolution { solution, friction: contact.friction })
}

/// The contact with the friction that agrees with the slip and with the stiffness of the layer. Strips and fields are computed from
/// this contact.
///
/// # Errors
/// Those of [`solve`].
pub fn under<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    friction: &SlipFriction<F>,
    options: &Options,
) -> Result<(Contact<F>, Notice), Error> {
    friction.check()?;
    let contact = friction.contact(contact);
    let (friction, notice) = agreement(&contact, creepage, friction, options)?;
    Ok((Contact { friction, ..contact }, notice))
}

/// No point of the contact slips faster than this, over rolling speed.
fn fastest_slip<F: Float>(contact: &Contact<F>, creepage: &Creepage<F>) -> F {
    creepage.longitudinal.abs()
        + contact.strain().abs()
        + creepage.lateral.abs()
        + (contact.a + contact.b) * creepage.spin.abs()
}

impl<F: Float> SlipFriction<F> {
    /// The least friction that the law can give a contact in motion, and an upper bound of `g'` there: `g' ≤ B V s_max (1 − A) μ₀/μ`.
    pub(crate) fn least(&self, contact: &Contact<F>, creepage: &Creepage<F>) -> (F, F) {
        if !self.falls() {
            return (self.friction, F::zero());
        }
        let slip = fastest_slip(contact, creepage);
        let least = self.at(slip);
        let falling = (F::one() - self.ratio) * self.friction;
        (least, self.decay * (self.rolling_speed * slip) * (falling / (least + F::TINY)))
    }
}

/// Checks the inputs of [`solve`] without solving.
///
/// # Errors
/// Those of [`solve`]: no smaller friction brings another.
pub fn check<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    friction: &SlipFriction<F>,
    options: &Options,
) -> Result<(), Error> {
    friction.check()?;
    model::check(&friction.contact(contact), creepage, options)
}

/// The largest `μ` that agrees with the slip that it causes. `contact` has `μ₀`.
fn agreement<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    friction: &SlipFriction<F>,
    options: &Options,
) -> Result<(F, Notice), Error> {
    model::check(contact, creepage, options)?;
    let nothing = contact.friction_bound() <= F::zero();
    if options.model == Model::Linear || !friction.falls() || nothing {
        return Ok((friction.friction, Notice::None));
    }
    Agreement::new(
        friction,
        fastest_slip(contact, creepage),
        contact.normal_force,
        |friction_now| {
            let contact = Contact { friction: friction_now, ..*contact };
            let bound = contact.friction_bound();
            if bound > F::zero() {
                let solution = model::solve(&contact, creepage, options)?;
                return Ok(friction.at(solution.power / bound));
            }
            // The limit of full sliding: s = (∂P/∂μ)/N
            let (_, slopes) = derivatives::solve_with_slopes(&contact, creepage, options)?;
            let power = slopes.seen.power(slopes.derivatives.friction);
            Ok(friction.at(power / contact.normal_force))
        },
    )
    .largest_solution()
}
