//! Falling friction, and reduced initial slope (Polach).
//!
//! O. Polach, *Creep forces in simulations of traction vehicles running on adhesion limit*, Wear
//! 258 (2005) 992: measured traction curves have a maximum, because friction falls with the sliding
//! velocity `w`, and a flatter start than clean contacts, because of the layer between the bodies.
//!
//! ```text
//! μ(w) = μ₀ ((1 − A) exp(−B w) + A),   w = V s
//! ```
//!
//! **The slip.** Polach takes the whole creepage for `s`, also where the contact sticks. Here `s`
//! is the slip that there is: the mean over the contact, weighted with friction, `s = P/(μ N)`, `P`
//! the frictional power over rolling speed. It is zero without slip and the creepage in full
//! sliding without spin, where both agree. `s` depends on the forces, hence on `μ`, and `μ` on `s`:
//! a scalar equation `μ = g(μ)`.
//!
//! **The solution.** `s` falls as `μ` grows (but for a hair in spin near full sliding), so `g`
//! increases: from `μ₀`, `μ ← g(μ)` falls monotonically to the largest solution, the one that is
//! reached from adhesion. With `−μ ds/dμ ≤ s_max`, the rigid slip, `g' < 1` everywhere for all but
//! extreme `B`; then the solution is unique and the secant method finds it in four to six solutions
//! of the contact. Otherwise the iteration goes down from `μ₀` and up from the smallest possible
//! `μ`, and a warning tells when they do not meet. The forces of the models of 1967 jump, or nearly
//! do, where adhesion is born, so that `g` may be steeper than that bound: for them another
//! solution may not be reported. Derivatives follow by the implicit function theorem, `∂s/∂μ` by
//! homogeneity ([`derivatives`]).
//!
//! **The slope factor** `k` multiplies the shear modulus: a contact with the layer is as stiff as
//! one of modulus `k G`. Forces depend on `G c/(μ N)` only, so the creep curve is stretched along
//! the creepage by `1/k` and keeps its shape and its saturation; patch and pressure stay.

mod agreement;
pub mod derivatives;
pub mod field;
mod law;
pub(crate) mod layered;
mod layered_strips;

pub(crate) use self::agreement::FrictionEquation;
pub use self::law::SlipFriction;
use self::layered::ThroughLayer;

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::forces::derivatives::solve_with_slopes;
use crate::forces::{self, Model, Options, Solution, StripResult};
use crate::number::Float;
use crate::status::{Error, Warning};

/// Forces under falling friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionSolution<F> {
    /// The forces; its warning is also that of the friction.
    pub solution: Solution<F>,
    /// The coefficient of friction that agrees with the slip \[-\]; of a patch the share `λ`, 0 to
    /// 1: friction at the slip over friction without slip, the same for all strips.
    pub friction: F,
}

/// Forces for a contact, a creepage and falling friction.
///
/// The contact's own coefficient of friction is ignored. With `A = 1`, `B = 0` or `V = 0`, and
/// `k = 1`, the result is that of [`forces::forces_of_contact`] to the bit and costs no more.
/// [`Model::Linear`] has no friction: only `k` counts.
///
/// # Errors
/// Those of [`forces::forces_of_contact`] and [`SlipFriction::check`].
///
/// # Example
/// A driven wheel that slips more pulls less:
/// ```
/// use kstrip::contact::{Contact, creepage::Creepage};
/// use kstrip::{friction::{SlipFriction, solve_with_law}, forces::Options};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, friction: 0.0,
///     shear_modulus: 82e9, poisson_ratio: 0.28,
///     mismatch: 0.0,
/// };
/// let wet = SlipFriction {
///     friction: 0.3, ratio: 0.4, decay: 0.6, rolling_speed: 20.0, slope_factor: 0.5,
///     slide_factor: 0.0, layer: 0.0,
/// };
/// let pull = |slip: f64| {
///     let creepage = Creepage { longitudinal: slip, lateral: 0.0, spin: 0.0 };
///     let found = solve_with_law(&contact, &creepage, &wet, &Options::default())?;
///     Ok::<_, kstrip::status::Error>(found.solution.fx)
/// };
/// assert!(pull(0.02)? > pull(0.005)? && pull(0.02)? > pull(0.1)?);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn solve_with_law<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, friction: &SlipFriction<F>, options: &Options,
) -> Result<FrictionSolution<F>, Error> {
    let motion = InMotion { creepage, law: Some(friction), options };
    motion.check(contact)?;
    motion.solve(contact)
}

/// The contact with the friction that agrees with the slip and with the stiffness of the layer.
/// Strips and fields are computed from this contact.
///
/// # Errors
/// Those of [`solve_with_law`].
pub fn contact_with_law<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, friction: &SlipFriction<F>, options: &Options,
) -> Result<(Contact<F>, Warning), Error> {
    let motion = InMotion { creepage, law: Some(friction), options };
    motion.check(contact)?;
    motion.with_friction(contact)
}

/// Every strip of the solution, handed to `visit`, of a contact with the friction that agrees and
/// the stiffness of the law, as [`contact_with_law`] gives it. Their shares add up to the forces.
///
/// # Errors
/// Those of [`forces::strips()`].
pub fn strips_with_law<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, law: Option<&SlipFriction<F>>, options: &Options,
    visit: &mut dyn FnMut(StripResult<F>),
) -> Result<Warning, Error> {
    match (InMotion { creepage, law, options }).behind_layer() {
        Some(through) => through.strips(contact, visit),
        None => forces::strips(contact, creepage, options, visit),
    }
}

/// How a contact moves, under which law of friction, if any, and what is to be computed of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InMotion<'a, F> {
    pub creepage: &'a Creepage<F>,
    pub law: Option<&'a SlipFriction<F>>,
    pub options: &'a Options,
}

impl<'a, F: Float> InMotion<'a, F> {
    /// Checks all inputs without solving. A smaller friction than that of the law without slip
    /// causes no other error.
    pub fn check(&self, contact: &Contact<F>) -> Result<(), Error> {
        let Some(law) = self.law else {
            return forces::check(contact, self.creepage, self.options);
        };
        law.check()?;
        forces::check(&law.contact(contact), self.creepage, self.options)
    }

    /// Forces of a contact, which was checked if there is a law.
    pub fn solve(&self, contact: &Contact<F>) -> Result<FrictionSolution<F>, Error> {
        let (contact, warning) = self.with_friction(contact)?;
        let mut solution = self.forces_at_friction(&contact)?;
        solution.warning = solution.warning.worse(warning);
        Ok(FrictionSolution { solution, friction: contact.friction })
    }

    /// The checked contact with the stiffness of the law and the largest friction `μ` that agrees
    /// with the slip that it causes.
    pub fn with_friction(&self, contact: &Contact<F>) -> Result<(Contact<F>, Warning), Error> {
        // A library without laws has accepted none.
        let Some(law) = self.law.filter(|_| SlipFriction::<F>::HAS_LAW) else {
            return Ok((*contact, Warning::None));
        };
        let contact = law.contact(contact);
        let nothing = contact.friction_bound() <= F::zero();
        if self.options.model == Model::Linear || !law.falls() || nothing {
            return Ok((contact, Warning::None));
        }
        // The closure takes a reference. Otherwise it takes the members of the structure one by
        // one, and what is stored so is read slowly as pairs.
        let of_largest = &contact;
        let next = |friction| {
            let contact = Contact { friction, ..*of_largest };
            let bound = contact.friction_bound();
            if bound > F::zero() {
                return Ok(law.at(self.forces_at_friction(&contact)?.power / bound));
            }
            // The limit of full sliding: s = (∂P/∂μ)/N
            let slopes = match self.behind_layer() {
                Some(through) => through.differentiate(&contact)?.1,
                None => solve_with_slopes(&contact, self.creepage, self.options)?.1,
            };
            let power = slopes.seen.power(slopes.derivatives.friction);
            Ok(law.at(power / contact.normal_force))
        };
        let rigid_slip = contact.fastest_slip(self.creepage);
        let equation = FrictionEquation { law, rigid_slip, load: contact.normal_force, next };
        let (friction, warning) = equation.largest_solution()?;
        Ok((Contact { friction, ..contact }, warning))
    }

    /// The model behind the layer of the law, if there is one.
    pub fn behind_layer(&self) -> Option<ThroughLayer<'a, F>> {
        let law = self.law.filter(|law| law.has_interface())?;
        Some(ThroughLayer { law, creepage: self.creepage, options: self.options })
    }

    /// Forces of a contact that has the stiffness and the friction of the law, behind its layer.
    #[inline(always)]
    fn forces_at_friction(&self, contact: &Contact<F>) -> Result<Solution<F>, Error> {
        match self.behind_layer() {
            Some(through) => through.solve(contact),
            None => forces::forces_of_contact(contact, self.creepage, self.options),
        }
    }
}
