//! From a contact and a creepage to forces: the models side by side.

use crate::contact::Contact;
use crate::creepage::{Creepage, Parameters};
use crate::dual::Dual;
use crate::field::FieldPoint;
use crate::quadrature::Tabulated;
use crate::real::{Arithmetic, Float, Real};
use crate::status::{Error, Notice};
use crate::strip::{SlidingRule, Strip};
use crate::totals::{PlacedStrip, StripCount, StripTheory, Totals};
use nalgebra::Matrix3;

/// Which traction law.
///
/// The number of each variant is its constant in the C interface; numbers are never reused.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(i32)]
#[non_exhaustive]
pub enum Model {
    /// The theory of 1967 with the sliding rule that the paper keeps for forces.
    #[default]
    Strip1967 = 1,
    /// The theory of 1967 with the sliding rule that joins the adhesion strips without a jump.
    Strip1967Continuous = 2,
}

impl Model {
    /// The model for a number, if there is one.
    #[must_use]
    pub const fn from_number(number: i32) -> Option<Self> {
        Some(match number {
            1 => Self::Strip1967,
            2 => Self::Strip1967Continuous,
            _ => return None,
        })
    }

    fn sliding_rule(self) -> SlidingRule {
        match self {
            Self::Strip1967 => SlidingRule::RigidSlip,
            Self::Strip1967Continuous => SlidingRule::Continuous,
        }
    }
}

/// Which model, and how many strips.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// The traction law.
    pub model: Model,
    /// How many strips share the patch; ignored by models without strips.
    pub strips: StripCount,
}

/// Forces of a rolling contact, on the lower body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Solution<F> {
    /// Longitudinal force `F_x` \[N\], positive along the rolling direction.
    pub fx: F,
    /// Lateral force `F_y` \[N\].
    pub fy: F,
    /// Spin moment `M_z = ∫ (x Y − y X)` about the centre of the ellipse \[N m\].
    pub mz: F,
    /// Frictional power over rolling speed `F_x υx + F_y υy + M_z φ` \[N\]: energy dissipated per
    /// metre rolled.
    pub power: F,
    /// Share of the contact area in adhesion, 0 to 1.
    pub adhesion: F,
    /// What the caller should know.
    pub notice: Notice,
}

impl<F: Float> Solution<F> {
    /// The same contact seen from the upper body: opposite forces and moment, same power.
    #[must_use]
    pub fn on_upper_body(&self) -> Self {
        Self { fx: -self.fx, fy: -self.fy, mz: -self.mz, ..*self }
    }
}

/// `d(F_x, F_y, M_z)/d(υx, υy, φ)`, row by row: N, N, N m over 1, 1, 1/m.
pub type Jacobian<F> = Matrix3<F>;

/// A checked contact ready to be solved for any creepage.
#[derive(Clone, Copy, Debug)]
struct Problem<'a, F> {
    contact: &'a Contact<F>,
    creepage: &'a Creepage<F>,
    options: &'a Options,
}

impl<'a, F: Tabulated> Problem<'a, F> {
    fn new(
        contact: &'a Contact<F>,
        creepage: &'a Creepage<F>,
        options: &'a Options,
    ) -> Result<Self, Error> {
        contact.check()?;
        creepage.check()?;
        let problem = Self { contact, creepage, options };
        problem.check_range()?;
        Ok(problem)
    }

    /// Every result is a number within `μ N` times these: check them before anything is computed.
    fn check_range(&self) -> Result<(), Error> {
        let Creepage { longitudinal, lateral, spin } = *self.creepage;
        let bound = self.contact.friction_bound();
        let moment = bound * (self.contact.a + self.contact.b);
        let power = bound * longitudinal.abs() + bound * lateral.abs() + moment * spin.abs();
        if power.is_finite_number() && moment.is_finite_number() {
            Ok(())
        } else {
            Err(Error::Overflow)
        }
    }

    /// Dimensionless totals of the chosen model.
    #[inline(always)]
    fn totals<T: Real<Base = F>>(&self, creepage: &Creepage<T>) -> (Totals<T>, Notice) {
        let theory = self.theory(creepage);
        let notice = if theory.spin_in_range() { Notice::None } else { Notice::SpinBeyondTheory };
        (theory.totals(self.options.strips), notice)
    }

    fn theory<T: Real<Base = F>>(&self, creepage: &Creepage<T>) -> StripTheory<T> {
        let parameters = Parameters::new(self.contact, creepage);
        StripTheory::new(&parameters, self.options.model.sliding_rule())
    }

    /// `√(ab)` \[m\], without overflow.
    fn mean_radius(&self) -> F {
        self.contact.a.sqrt() * self.contact.b.sqrt()
    }

    /// From units of `μ N` to newtons.
    #[inline(always)]
    fn solution(&self, totals: &Totals<F>, notice: Notice) -> Solution<F> {
        let bound = self.contact.friction_bound();
        let (fx, fy) = (bound * totals.fx, bound * totals.fy);
        let mz = bound * self.mean_radius() * totals.mz;
        let Creepage { longitudinal, lateral, spin } = *self.creepage;
        Solution {
            fx,
            fy,
            mz,
            power: fx * longitudinal + fy * lateral + mz * spin,
            adhesion: totals.stick,
            notice,
        }
    }
}

/// Check the inputs of [`solve`] without solving.
///
/// # Errors
/// Those of [`solve`].
pub fn check<F: Tabulated>(contact: &Contact<F>, creepage: &Creepage<F>) -> Result<(), Error> {
    Problem::new(contact, creepage, &Options::default()).map(|_| ())
}

/// Forces for a contact and a creepage.
///
/// # Errors
/// Those of [`Contact::check`] and [`Creepage::check`]; [`Error::Overflow`] when a force or the power
/// does not fit the floating-point type.
///
/// # Example
/// A wheel on a rail, 0.1 % longitudinal creepage:
/// ```
/// use kstrip::{contact::Contact, creepage::Creepage, model::{solve, Options}};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, shear_modulus: 82e9, poisson_ratio: 0.28, friction: 0.3,
/// };
/// let creepage = Creepage { longitudinal: 1e-3, lateral: 0.0, spin: 0.0 };
/// let forces = solve(&contact, &creepage, &Options::default()).unwrap();
/// assert!(forces.fx > 0.0 && forces.fx < 24e3 && forces.fy == 0.0);
/// ```
pub fn solve<F: Tabulated>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
) -> Result<Solution<F>, Error> {
    let problem = Problem::new(contact, creepage, options)?;
    let (totals, notice) = problem.totals(creepage);
    Ok(problem.solution(&totals, notice))
}

/// Forces and their exact derivatives with respect to the creepages.
///
/// The derivatives are those of the computed forces, by forward-mode differentiation of the same
/// code: the linear slopes at zero creepage, zero along the slip direction in saturation, one-sided
/// values where a model has a kink.
///
/// # Errors
/// Those of [`solve`].
pub fn solve_jacobian<F: Tabulated>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
) -> Result<(Solution<F>, Jacobian<F>), Error> {
    let problem = Problem::new(contact, creepage, options)?;
    let inputs = Creepage {
        longitudinal: Dual::<F, 3>::input(creepage.longitudinal, 0),
        lateral: Dual::input(creepage.lateral, 1),
        spin: Dual::input(creepage.spin, 2),
    };
    let (totals, notice) = problem.totals(&inputs);
    let values = Totals {
        fx: totals.fx.value,
        fy: totals.fy.value,
        mz: totals.mz.value,
        stick: totals.stick.value,
    };
    let solution = problem.solution(&values, notice);
    let bound = contact.friction_bound();
    let moment = bound * problem.mean_radius();
    let jacobian = Matrix3::from([
        totals.fx.gradient.map(|d| d * bound),
        totals.fy.gradient.map(|d| d * bound),
        totals.mz.gradient.map(|d| d * moment),
    ])
    .transpose();
    if jacobian.iter().all(|entry| entry.is_finite_number()) {
        Ok((solution, jacobian))
    } else {
        Err(Error::Overflow)
    }
}

/// What one strip carries, on the lower body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripResult<F> {
    /// Centre line `y` \[m\].
    pub y: F,
    /// Width that the strip stands for \[m\].
    pub width: F,
    /// Half length `c` \[m\].
    pub half_length: F,
    /// `x` of the separatrix \[m\]: slip behind, adhesion ahead; the leading edge `c` when the whole
    /// strip slides.
    pub separatrix: F,
    /// Its share of `F_x` \[N\].
    pub fx: F,
    /// Its share of `F_y` \[N\].
    pub fy: F,
    /// Its share of `M_z` about the centre of the contact \[N m\].
    pub mz: F,
    /// Its share of the frictional power \[N\].
    pub power: F,
    /// Whether it has an adhesion area.
    pub adheres: bool,
}

/// Every strip of the solution, handed to `visit`. Their shares add up to the totals of [`solve`]
/// (before the bound `|F| ≤ μ N` is applied, which matters only with few strips).
///
/// # Errors
/// Those of [`solve`].
pub fn strips<F: Tabulated>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
    visit: &mut dyn FnMut(StripResult<F>),
) -> Result<Notice, Error> {
    let problem = Problem::new(contact, creepage, options)?;
    let theory = problem.theory(creepage);
    let bound = contact.friction_bound();
    theory.strips(options.strips, &mut |strip: PlacedStrip<F>| {
        let (fx, fy) = (bound * strip.fx, bound * strip.fy);
        let mz = bound * contact.a * strip.mz;
        visit(StripResult {
            y: contact.b * strip.y,
            width: contact.b * strip.width,
            half_length: contact.a * strip.half_length,
            separatrix: contact.a * (strip.kappa + strip.kappa - strip.half_length),
            fx,
            fy,
            mz,
            power: fx * creepage.longitudinal + fy * creepage.lateral + mz * creepage.spin,
            adheres: strip.adheres,
        });
    });
    Ok(if theory.spin_in_range() { Notice::None } else { Notice::SpinBeyondTheory })
}

/// The tangential field of a contact, ready to be evaluated at points.
#[derive(Clone, Copy, Debug)]
pub struct Field<F: Real> {
    contact: Contact<F::Base>,
    parameters: Parameters<F>,
    rule: SlidingRule,
    /// What the caller should know.
    pub notice: Notice,
}

impl<F: Tabulated> Field<F> {
    /// Prepare the field of a contact and a creepage.
    ///
    /// # Errors
    /// Those of [`solve`].
    pub fn new(
        contact: &Contact<F>,
        creepage: &Creepage<F>,
        options: &Options,
    ) -> Result<Self, Error> {
        let problem = Problem::new(contact, creepage, options)?;
        let spin_in_range = problem.theory(creepage).spin_in_range();
        Ok(Self {
            contact: *contact,
            parameters: Parameters::new(contact, creepage),
            rule: options.model.sliding_rule(),
            notice: if spin_in_range { Notice::None } else { Notice::SpinBeyondTheory },
        })
    }

    /// The strip through `y` \[m\]; `None` outside the contact.
    #[must_use]
    pub fn strip_at(&self, y: F) -> Option<Strip<F>> {
        let relative = y / self.contact.b;
        let square = (F::one() - relative) * (F::one() + relative);
        if !(square > F::zero()) {
            return None;
        }
        let p = &self.parameters;
        Some(Strip::solve(
            square.sqrt(),
            p.xi - p.spin_slope() * relative,
            p.eta,
            p.psi,
            p.poisson_ratio,
            self.rule,
        ))
    }

    /// The state at a point of the contact plane (`x`, `y` in metres from the centre).
    #[must_use]
    pub fn at(&self, x: F, y: F) -> FieldPoint<F> {
        self.along(self.strip_at(y).as_ref(), x)
    }

    /// The state at `x` \[m\] of a strip of [`Field::strip_at`].
    #[must_use]
    pub fn along(&self, strip: Option<&Strip<F>>, x: F) -> FieldPoint<F> {
        FieldPoint::new(&self.contact, strip.map(|strip| strip.at(x / self.contact.a)))
    }
}
