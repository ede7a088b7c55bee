//! Falling friction, and reduced initial slope, on patches of strips.
//!
//! Every strip has its own coefficient of friction without slip, `μ₀(y)`. Polach's law multiplies
//! all of them with one number, the share `λ`, which follows from the mean slip `s` of the patch,
//! weighted with friction:
//!
//! ```text
//! μ(y) = λ μ₀(y),   λ = (1 − A) exp(−B V s) + A,   s = P/(λ Σ μ₀ N)
//! ```
//!
//! as in [`friction`](crate::friction), so that the strips of an ellipse give the result of the
//! ellipse. The `μ₀` of the law is not used. Forces of a patch are homogeneous in creepage and
//! friction, and the slope factor `k` multiplies the stiffness:
//!
//! ```text
//! F(c, κ; λ μ₀, k G) = λ F(k c/λ, k κ/λ; μ₀, G)
//! ```
//!
//! The patch need not be copied: it is solved at the scaled creepages. The derivatives follow from
//! this and from the implicit function theorem.

use crate::contact::creepage::Creepage;
use crate::contact::plausibility::LARGEST_MISMATCH;
use crate::forces::derivatives::{Derivatives, POWERS, Sensitivity, Slopes, by_size, scaled};
use crate::forces::{Model, Solution, StripResult};
use crate::friction::derivatives::{AtFriction, Differentiated, LawDerivatives, OwnSensitivities};
use crate::friction::layered::InterfaceSlopes;
use crate::friction::{FrictionEquation, FrictionSolution, SlipFriction};
use crate::layer::Interface;
use crate::number::{Float, are_finite, at, set_at};
use crate::patch::PatchView;
use crate::patch::solver::{self, Problem};
use crate::status::{Error, Warning};

/// Forces of a patch whose friction falls with the slip; `friction` is the share `λ`.
///
/// With `A = 1`, `B = 0` or `V = 0`, and `k = 1`, the result is that of [`solver::solve_patch`] to
/// the bit and costs no more.
///
/// # Errors
/// Those of [`solver::solve_patch`] and [`SlipFriction::check`]; `law.friction` is ignored.
///
/// # Example
/// A patch that slips more pulls less:
/// ```
/// use kstrip::contact::{Contact, creepage::Creepage};
/// use kstrip::{friction::SlipFriction, forces::Model};
/// use kstrip::{patch::Patch, patch::friction::solve_patch_with_law, contact::totals::StripCount};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, friction: 0.3,
///     shear_modulus: 82e9, poisson_ratio: 0.28, mismatch: 0.0,
/// };
/// let patch = Patch::from_ellipse(&contact, StripCount::Sixteen)?;
/// let wet = SlipFriction {
///     friction: 0.3, ratio: 0.4, decay: 0.6, rolling_speed: 20.0, slope_factor: 0.5,
///     slide_factor: 0.0, layer: 0.0,
/// };
/// let pull = |slip: f64| {
///     let creepage = Creepage { longitudinal: slip, lateral: 0.0, spin: 0.0 };
///     let found = solve_patch_with_law(&patch.view()?, &creepage, &wet, Model::Strip)?;
///     Ok::<_, kstrip::status::Error>(found.solution.fx)
/// };
/// assert!(pull(0.02)? > pull(0.005)? && pull(0.02)? > pull(0.1)?);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn solve_patch_with_law<F: Float>(
    patch: &PatchView<F>, creepage: &Creepage<F>, law: &SlipFriction<F>, model: Model,
) -> Result<FrictionSolution<F>, Error> {
    let problem = FrictionProblem::new(patch, creepage, Some(law), model)?;
    let (share, warning) = problem.agreement()?;
    let scaled = problem.scaled(share)?;
    let solution =
        problem.under_friction(share, scaled.factor, &scaled.problem()?.solution(), warning);
    Ok(FrictionSolution { solution, friction: share })
}

/// A patch and a scaled creepage, whose forces times `λ` are those under falling friction.
pub(super) struct Scaled<'a, F> {
    pub patch: PatchView<'a, F>,
    pub creepage: Creepage<F>,
    pub model: Model,
    pub behind: Option<Interface<F>>,
    /// `k/λ`
    pub factor: F,
}

impl<F: Float> Scaled<'_, F> {
    pub fn problem(&self) -> Result<Problem<'_, F>, Error> {
        let Self { patch, creepage, model, behind, .. } = self;
        Ok(Problem { behind: *behind, ..Problem::new(patch, creepage, *model)? })
    }
}

/// A patch, a creepage, a model and a law that fit together.
pub(super) struct FrictionProblem<'a, F: Float> {
    /// At the given creepage, with the layer of the law.
    problem: Problem<'a, F>,
    /// The law for friction in units of that without slip.
    pub law: SlipFriction<F>,
    /// `Σ μ₀ N`
    pub bound: F,
    /// Upper bound of the slip of all points, divided by the rolling speed.
    rigid_slip: F,
}

impl<'a, F: Float> FrictionProblem<'a, F> {
    /// Without a law friction is constant.
    pub fn new(
        patch: &'a PatchView<'a, F>, creepage: &'a Creepage<F>, law: Option<&SlipFriction<F>>,
        model: Model,
    ) -> Result<Self, Error> {
        let constant = SlipFriction::of_constant(F::one());
        let law = SlipFriction { friction: F::one(), ..*law.unwrap_or(&constant) };
        law.check()?;
        let problem = Problem::new(patch, creepage, model)?;
        let rigid_slip = problem.largest_rigid_slip();
        Error::Modulus.when(patch.shear_modulus() * law.slope_or_one() <= F::zero())?;
        let behind = law.has_interface().then(|| law.interface(patch.shear_modulus(), F::one()));
        let (problem, bound) = (Problem { behind, ..problem }, patch.friction_bound());
        Ok(Self { problem, law, bound, rigid_slip })
    }

    pub fn agreement(&self) -> Result<(F, Warning), Error> {
        if !self.law.falls() || self.bound <= F::zero() {
            return Ok((F::one(), Warning::None));
        }
        let next = |share| {
            let scaled = self.scaled(share)?;
            Ok(self.law.at(scaled.problem()?.solution().power / scaled.factor / self.bound))
        };
        let (law, rigid_slip, load) = (&self.law, self.rigid_slip, self.bound);
        FrictionEquation { law, rigid_slip, load, next }.largest_solution()
    }

    /// `k c/λ` and `k κ/λ`; where `λ` vanishes, creepages so large that the whole patch slides.
    pub fn scaled(&self, share: F) -> Result<Scaled<'a, F>, Error> {
        let factor = (self.law.slope_or_one() / share).max(F::one() / F::HUGE);
        let farthest = F::HUGE * (F::HUGE / (self.bound + F::one())) / (self.rigid_slip + F::TINY);
        let factor = factor.min(farthest.max(F::one()));
        let Problem { view, creepage, model, behind } = self.problem;
        let mut patch = view.scaled_own(factor);
        if patch.mismatch() != F::zero() {
            patch = patch.with_mismatch(patch.mismatch() * factor)?;
        }
        Ok(Scaled { patch, creepage: creepage.scaled(factor), model, behind, factor })
    }

    /// The warning of the patch from that at the scaled creepage and that of the friction.
    pub fn warning(&self, scaled: Warning, of_friction: Warning) -> Warning {
        let own = if scaled == Warning::Mismatch { Warning::None } else { scaled };
        let Problem { view, model, .. } = self.problem;
        let far = view.mismatch().abs() > F::constant(LARGEST_MISMATCH);
        let own = if far && !model.is_of_1967() { Warning::Mismatch } else { own };
        own.worse(of_friction)
    }

    /// The solution of the patch from that at the scaled creepage.
    fn under_friction(
        &self, share: F, factor: F, at_scaled: &Solution<F>, warning: Warning,
    ) -> Solution<F> {
        let [fx, fy, mz] = at_scaled.components().map(|force| force * share);
        let power = share * (at_scaled.power / factor);
        let warning = self.warning(at_scaled.warning, warning);
        Solution { fx, fy, mz, power, warning, ..*at_scaled }
    }
}

/// Forces of a patch and all derivatives, under falling friction or not; `friction` is the share
/// `λ`.
///
/// For the derivatives with respect to load, all pressures grow by one factor; through Hertz, all
/// lengths also grow like the cube root of the load. For those with respect to friction, the
/// friction of all strips grows by one factor, and the derivative is with respect to its mean
/// without slip.
///
/// # Errors
/// Those of [`solve_patch_with_law`]; [`Error::Overflow`] also when a derivative does not fit.
pub fn differentiate_patch<F: Float>(
    patch: &PatchView<F>, creepage: &Creepage<F>, law: Option<&SlipFriction<F>>, model: Model,
) -> Result<Differentiated<F>, Error> {
    let (load, bound) = (patch.normal_force(), patch.friction_bound());
    let problem = FrictionProblem::new(patch, creepage, law, model)?;
    let (share, warning) = problem.agreement()?;
    let at_share = problem.scaled(share)?;
    let ((found, slopes, interface), own) = at_share.problem()?.with_slopes()?;
    let Scaled { creepage: at, factor, behind, .. } = at_share;
    let solution = problem.under_friction(share, factor, &found, warning);
    if bound <= F::zero() {
        let (derivatives, law) = (Derivatives::default(), LawDerivatives::default());
        let by_mismatch = [F::zero(); 3];
        return Ok(Differentiated { solution, friction: share, derivatives, law, by_mismatch });
    }
    let mean = bound / load;
    // F = λ f(k c/λ):  ∂F/∂c = k J
    let derivatives = Derivatives {
        jacobian: slopes.derivatives.jacobian.map(|row| scaled(row, share * factor)),
        ..size_derivatives(&found, &slopes, &interface, &own, [share, load, mean], &at)
    };
    let friction = share * mean;
    // F = λ f(k c/λ),  P = λ²/k P(k c/λ)
    let under = |of: &Sensitivity<F>| of.scaled(share, share / factor);
    let slopes = Slopes {
        derivatives,
        seen: *creepage,
        power_by_creepage: scaled(slopes.power_by_creepage, share),
        by_mismatch: under(&slopes.by_mismatch),
    };
    let interface = InterfaceSlopes {
        layer: interface.layer,
        by_layer: under(&interface.by_layer),
        by_slide: under(&interface.by_slide),
    };
    // The forces are homogeneous: those of the creepages times k/λ.
    let own = own.each_ref().map(under);
    let (power, motion) = (solution.power, *creepage);
    let at_friction = AtFriction { slopes, power, motion, own, friction, load };
    let law = SlipFriction { friction: mean, ..problem.law };
    let (derivatives, law, by_mismatch) =
        at_friction.through(&law, law.falls(), behind.is_some().then_some(&interface));
    let fit = are_finite(&derivatives.entries()) && are_finite(&law.entries());
    Error::Overflow.unless(fit)?;
    Ok(Differentiated { solution, friction: share, derivatives, law, by_mismatch })
}

/// The derivatives with respect to load, load through Hertz, and friction, for a share `λ` of the
/// friction, a load, and the mean friction without slip.
fn size_derivatives<F: Float>(
    found: &Solution<F>, slopes: &Slopes<F>, interface: &InterfaceSlopes<F>,
    [own, moved]: &OwnSensitivities<F>, [share, load, mean]: [F; 3], at_scaled: &Creepage<F>,
) -> Derivatives<F> {
    // in f creepages are k c/λ;  μ ∂F/∂μ = N ∂F/∂N − λ κ ∂f/∂κ
    let mut found_by = Derivatives::default();
    let Derivatives { normal_force, load_through_hertz, friction, .. } = &mut found_by;
    let by_layer = scaled(interface.by_layer.forces, interface.layer);
    let rows = slopes.derivatives.jacobian.into_iter().zip(found.components()).zip(POWERS);
    for (k, (([x, y, z], force), power)) in rows.enumerate() {
        let of = |list: &[F; 3]| at(list, k);
        let translation = x * at_scaled.longitudinal + y * at_scaled.lateral;
        let along = translation + z * at_scaled.spin + of(&own.forces);
        let moved = translation + of(&moved.forces) + of(&by_layer);
        let [rest, hertz] = by_size(force, power, along, moved);
        set_at(normal_force, k, share * rest / load);
        set_at(load_through_hertz, k, share * hertz / load);
        set_at(friction, k, (rest - of(&slopes.by_mismatch.forces)) / mean);
    }
    found_by
}

/// Passes every strip of the solution at a share `λ` of friction to `visit`, as
/// [`solver::patch_strips`] does.
///
/// # Errors
/// Those of [`solve_patch_with_law`].
pub fn patch_strips_with_law<F: Float>(
    patch: &PatchView<F>, creepage: &Creepage<F>, law: Option<&SlipFriction<F>>, share: F,
    model: Model, visit: &mut impl FnMut(StripResult<F>),
) -> Result<Warning, Error> {
    if law.is_none() {
        return solver::patch_strips(patch, creepage, model, visit);
    }
    let problem = FrictionProblem::new(patch, creepage, law, model)?;
    Error::NotInModel.unless(model != Model::Total)?;
    let at_share = problem.scaled(share)?;
    Ok(at_share.problem()?.strips(&mut |strip| {
        let [fx, fy, mz] = scaled([strip.fx, strip.fy, strip.mz], share);
        visit(StripResult { fx, fy, mz, power: share * (strip.power / at_share.factor), ..strip });
    }))
}
