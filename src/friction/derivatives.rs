//! Derivatives through falling friction.
//!
//! A model gives the derivatives at constant friction: its `Slopes`, those with respect to the
//! layer (`InterfaceSlopes`) and, for patches, to the strips' own creepages
//! (`OwnSensitivities`), each of forces and power (`Sensitivity`). With the change of friction,
//! which `AtFriction::through` adds, they are [`Differentiated`].

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::forces::derivatives::{
    Derivatives, Sensitivity, Slopes, by_size, solve_with_slopes, transposed,
};
use crate::forces::options::{Model, Options, Solution};
use crate::friction::layered::{InterfaceSlopes, ThroughLayer};
use crate::friction::{InMotion, SlipFriction};
use crate::number::{Float, add, are_finite};
use crate::status::{Error, Warning};

/// Derivatives of fx, fy, mz with respect to the parameters of falling friction.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LawDerivatives<F> {
    /// With respect to the ratio \[N, N, N m\].
    pub ratio: [F; 3],
    /// With respect to the decay \[N, N, N m per s/m\].
    pub decay: [F; 3],
    /// With respect to the rolling speed of the law at constant creepages \[N, N, N m per m/s\].
    pub rolling_speed: [F; 3],
    /// With respect to the factor of the initial slope, at 1 without a law \[N, N, N m\].
    pub slope_factor: [F; 3],
    /// With respect to the slide factor \[N, N, N m\]; 0 where it is 0 in a law without a layer.
    pub slide_factor: [F; 3],
    /// With respect to the layer \[N, N, N m per m/Pa\]; 0 where there is none.
    pub layer: [F; 3],
}

/// Derivatives with respect to a factor of the creepages that the strips of a patch have besides
/// those of the patch: of all three, and of all but the spin.
pub(crate) type OwnSensitivities<F> = [Sensitivity<F>; 2];

/// A contact at the friction of a law, with its derivatives at constant friction.
pub(crate) struct AtFriction<F: Float> {
    /// Derivatives at constant `μ`
    pub slopes: Slopes<F>,
    /// `P`, over rolling speed
    pub power: F,
    /// `(υx, υy, φ)`
    pub motion: Creepage<F>,
    /// Derivatives with respect to creepages besides these.
    pub own: OwnSensitivities<F>,
    /// `μ`
    pub friction: F,
    /// `N`
    pub load: F,
}

impl<F: Float> AtFriction<F> {
    /// The derivatives through `μ = g(s)`, `s = P/(μ N)`:  `dF/dp = ∂F/∂p + ∂F/∂μ dμ/dp`.
    ///
    /// The last of them are `κ dF/dκ`. As `F = M f(c/M, κ/μ)`, the power is
    /// `P = M² p(c/M, κ/μ)/(G a b)`, which gives the change of the slip:
    ///
    /// ```text
    /// N ∂s/∂N = (P − (∂P/∂c) c)/M,   through Hertz ⅓ (P − (∂P/∂v) v)/M,
    /// μ ∂s/∂μ = N ∂s/∂N − κ (∂P/∂κ)/M = −k ∂s/∂k
    /// ```
    #[inline(always)]
    pub(crate) fn through(
        &self, law: &SlipFriction<F>, falls: bool, of_interface: Option<&InterfaceSlopes<F>>,
    ) -> (Derivatives<F>, LawDerivatives<F>, [F; 3]) {
        let Self { power, friction, load, .. } = *self;
        let Slopes { derivatives, seen, power_by_creepage, by_mismatch } = &self.slopes;
        let by_friction = derivatives.friction;
        let bound = friction * load;
        // s = P/(μ N), in the limit of full sliding (∂P/∂μ)/N
        let carries = bound > F::zero();
        let slip = if carries { power / bound } else { seen.power(by_friction) / load };
        // What rounding leaves of a power of zero may be below zero, and is no slip.
        let slip = slip.max(F::zero());
        let [slip_by_load, mut slip_through_hertz, slip_by_mismatch] = self.slip_by_size();
        let by_size = slip_by_load - slip_by_mismatch;
        let slip_by_friction = if carries { by_size / friction } else { F::zero() };
        let by = law.slopes(slip, falls && carries, slip_by_friction);
        let (zero, none) = (F::zero(), [F::zero(); 3]);
        let shifted = |fixed: &[F; 3], direct: F, slip: F| {
            let change = by.along(direct, slip);
            let mut total = *fixed;
            add(&mut total, by_friction.map(|slope| slope * change));
            total
        };
        let through_slip = |fixed: &[F; 3], slip: F| shifted(fixed, zero, slip);
        let directly = |direct: F| shifted(&none, direct, zero);
        let mut columns = transposed(derivatives.jacobian);
        for (column, power_by) in columns.iter_mut().zip(power_by_creepage) {
            *column = through_slip(column, self.over_bound(*power_by));
        }
        let stiffness = law.slope_or_one();
        let by_stiffness = self.by_stiffness().map(|force| force / stiffness);
        let (mut by_slide, mut by_layer) = (none, none);
        if let Some(interface) = of_interface {
            let [of_layer, of_slide] = [&interface.by_layer, &interface.by_slide];
            let [layer_power, slide_power] =
                [of_layer.power, of_slide.power].map(|power| self.over_bound(power));
            // λ ~ N^{−1/3} through Hertz
            slip_through_hertz -= (interface.layer * layer_power).times(1.0 / 3.0);
            by_layer = through_slip(&of_layer.forces, layer_power);
            by_slide = through_slip(&of_slide.forces, slide_power);
        }
        let Derivatives { normal_force, load_through_hertz, .. } = derivatives;
        let through = Derivatives {
            jacobian: transposed(columns),
            normal_force: through_slip(normal_force, slip_by_load / load),
            load_through_hertz: through_slip(load_through_hertz, slip_through_hertz / load),
            friction: directly(by.friction),
        };
        let law = LawDerivatives {
            ratio: directly(by.ratio),
            decay: directly(by.decay),
            rolling_speed: directly(by.rolling_speed),
            slope_factor: through_slip(&by_stiffness, -(by_size / stiffness)),
            slide_factor: by_slide,
            layer: by_layer,
        };
        (through, law, through_slip(&by_mismatch.forces, slip_by_mismatch))
    }

    /// `N ∂s/∂N`, the same through Hertz but for a layer, and `κ ∂s/∂κ`.
    fn slip_by_size(&self) -> [F; 3] {
        let Self { power, motion, own: [all, translation], .. } = self;
        let Slopes { power_by_creepage, by_mismatch, .. } = &self.slopes;
        let [power_by_x, power_by_y, _] = *power_by_creepage;
        let translation =
            power_by_x * motion.longitudinal + power_by_y * motion.lateral + translation.power;
        let all = motion.power(*power_by_creepage) + all.power;
        let [by_load, through_hertz] = by_size(*power, 1.0 / 3.0, all, translation);
        [by_load, through_hertz, by_mismatch.power].map(|power| self.over_bound(power))
    }

    /// `F = M f(k c/M, k κ/μ)`:  `k ∂F/∂k = (∂F/∂c) c + κ ∂F/∂κ`
    fn by_stiffness(&self) -> [F; 3] {
        let mut forces = self.slopes.derivatives.jacobian.map(|row| self.motion.power(row));
        let by_mismatch = self.slopes.by_mismatch.forces;
        let [all, _] = &self.own;
        for ((force, by_mismatch), own) in forces.iter_mut().zip(by_mismatch).zip(all.forces) {
            *force = *force + own + by_mismatch;
        }
        forces
    }

    /// A power divided by `μ N`; zero without a bound.
    fn over_bound(&self, power: F) -> F {
        let bound = self.friction * self.load;
        if bound > F::zero() { power / bound } else { F::zero() }
    }
}

/// Forces and all derivatives of a contact: the result of [`differentiate_with_law`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Differentiated<F: Float> {
    /// The forces.
    pub solution: Solution<F>,
    /// The coefficient of friction that agrees with the slip.
    pub friction: F,
    /// Derivatives with respect to creepages, load, friction.
    pub derivatives: Derivatives<F>,
    /// Derivatives with respect to the parameters of the law.
    pub law: LawDerivatives<F>,
    /// `κ dF/dκ` of dissimilar materials \[N, N, N m\].
    pub by_mismatch: [F; 3],
}

/// Forces and all derivatives, under falling friction or not.
///
/// # Errors
/// Those of `solve` and [`SlipFriction::check`].
pub fn differentiate_with_law<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, law: Option<&SlipFriction<F>>, options: &Options,
) -> Result<Differentiated<F>, Error> {
    let motion = InMotion { creepage, law, options };
    if law.is_some() {
        motion.check(contact)?;
    }
    motion.differentiate(contact)
}

impl<F: Float> InMotion<'_, F> {
    /// [`differentiate_with_law`] of a contact, which was checked if there is a law.
    pub fn differentiate(&self, contact: &Contact<F>) -> Result<Differentiated<F>, Error> {
        let under;
        let (contact, warning) = match self.law {
            None => (contact, Warning::None),
            Some(_) => {
                under = self.with_friction(contact)?;
                (&under.0, under.1)
            }
        };
        self.at_friction(contact, warning)
    }

    /// The same for a contact with the friction of the law, and the warning of that friction. (Out
    /// of line where the stack is short: the search for it needs no room for these results.)
    #[cfg_attr(target_arch = "x86_64", inline)]
    #[cfg_attr(not(target_arch = "x86_64"), inline(never))]
    fn at_friction(&self, contact: &Contact<F>, of: Warning) -> Result<Differentiated<F>, Error> {
        if let Some(through) = self.behind_layer() {
            return self.at_layer(&through, contact, of);
        }
        // A reference saves a copy of the results.
        let solved = solve_with_slopes(contact, self.creepage, self.options);
        let (solution, slopes) = solved.as_ref().map_err(|error| *error)?;
        self.through_law(contact, (solution, slopes, None), of)
    }

    /// The same of a law with a layer or a slide factor.
    #[inline(never)]
    fn at_layer(
        &self, through: &ThroughLayer<F>, contact: &Contact<F>, of: Warning,
    ) -> Result<Differentiated<F>, Error> {
        let solved = through.differentiate(contact);
        let (solution, slopes, of_interface) = solved.as_ref().map_err(|error| *error)?;
        self.through_law(contact, (solution, slopes, Some(of_interface)), of)
    }

    /// All derivatives from those at constant friction.
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline(never))]
    fn through_law(
        &self, contact: &Contact<F>,
        found: (&Solution<F>, &Slopes<F>, Option<&InterfaceSlopes<F>>), of_friction: Warning,
    ) -> Result<Differentiated<F>, Error> {
        let (solution, slopes, of_interface) = found;
        let solution = Solution { warning: solution.warning.worse(of_friction), ..*solution };
        let (friction, motion) = (contact.friction, *self.creepage);
        let has_law = SlipFriction::<F>::HAS_LAW && !contact.is_lost();
        let Some(law) = self.law.filter(|_| has_law) else {
            let (derivatives, by_mismatch) = (slopes.derivatives, slopes.by_mismatch.forces);
            let law = without_law(&derivatives, by_mismatch, &motion);
            Error::Overflow.unless(are_finite(&law.slope_factor))?;
            return Ok(Differentiated { solution, friction, derivatives, law, by_mismatch });
        };
        let (power, load) = (solution.power, contact.normal_force);
        let own = OwnSensitivities::default();
        let at = AtFriction { slopes: *slopes, power, motion, own, friction, load };
        let falls = self.options.model != Model::Linear && law.falls();
        let (derivatives, law, by_mismatch) = at.through(law, falls, of_interface);
        let fit = are_finite(&derivatives.entries()) && are_finite(&law.entries());
        Error::Overflow.unless(fit)?;
        Ok(Differentiated { solution, friction, derivatives, law, by_mismatch })
    }

    /// Checks the inputs of [`differentiate_with_law`], without solving but where sizes are so
    /// unusual that a derivative might not fit.
    pub fn check_differentiable(&self, contact: &Contact<F>) -> Result<(), Error> {
        self.check(contact)?;
        let (friction, steepness) = match self.law {
            Some(law) => law.least_friction(contact, self.creepage),
            None => (contact.friction, F::zero()),
        };
        // Slopes are those of linear theory, over the bound at most so many, and grow tenfold
        // through friction.
        let fit = contact.is_ordinary(self.creepage)
            && contact.tangential_stiffness()
                <= Contact { friction, ..*contact }.friction_bound().times(1e6)
            && steepness < F::constant(0.9);
        if fit || contact.is_lost() {
            return Ok(());
        }
        self.differentiate(contact).map(|_| ())
    }
}

/// Friction that is constant: of the law there is the slope factor alone, `F = M f(k c/M, k κ/μ)`
/// at `k = 1`.
pub(crate) fn without_law<F: Float>(
    derivatives: &Derivatives<F>, by_mismatch: [F; 3], creepage: &Creepage<F>,
) -> LawDerivatives<F> {
    let mut slope_factor = derivatives.jacobian.map(|row| creepage.power(row));
    for (entry, by_mismatch) in slope_factor.iter_mut().zip(by_mismatch) {
        *entry += by_mismatch;
    }
    LawDerivatives { slope_factor, ..LawDerivatives::default() }
}

impl<F: Float> LawDerivatives<F> {
    /// All derivatives in one array.
    pub(crate) fn entries(&self) -> [F; 18] {
        let Self { ratio: [a, b, c], decay: [d, e, f], .. } = *self;
        let Self { rolling_speed: [g, h, i], slope_factor: [j, k, l], .. } = *self;
        let Self { slide_factor: [m, n, o], layer: [p, q, r], .. } = *self;
        [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r]
    }
}
