//! From a contact and a creepage to forces: the models side by side.

use crate::contact::Contact;
use crate::contact::creepage::{Creepage, Parameters};
use crate::contact::forces::{StripCount, Totals};
use crate::contact::warning;
use crate::linear::LinearCoefficients;
use crate::number::dual::Dual;
use crate::number::{Arithmetic, Float, Number, Pair, Plain, Real};
use crate::solve::field::FieldPoint;
use crate::status::{Error, Notice};
use crate::strip::{Law as StripLaw, Prepared, PreparedStrips, Rule, StripGeometry};
use crate::strip_1967::strip::{SlidingRule, State, Strip, StripPoint};
use crate::strip_1967::{self, strips::PlacedStrip};
use crate::total;
use nalgebra::Matrix3;

/// Which traction law.
///
/// The number of each variant is its constant in the C interface; numbers are never reused.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(i32)]
#[non_exhaustive]
pub enum Model {
    /// The theory of 1967 itself, nothing fitted, with the sliding rule that the paper keeps for forces.
    Strip1967 = 1,
    /// The theory of 1967 with the sliding rule that joins the adhesion strips without a jump.
    Strip1967Continuous = 2,
    /// A strip theory in Kalker's sense: the half-ellipses of 1967 in adhesion, slip along the local rigid slip, flexibilities corrected by a
    /// small network fitted to CONTACT. Any spin: forces, moment, stick area and fields; the power is never negative.
    #[default]
    Strip = 3,
    /// A closed formula with a small network fitted to CONTACT. Total forces and moment only: the most accurate and, of those with
    /// saturation, the cheapest; the power is never negative.
    Total = 4,
    /// Linear theory: no saturation, for stability analysis.
    Linear = 5,
}

impl Model {
    /// The model for a number, if there is one.
    #[must_use]
    pub const fn from_number(number: i32) -> Option<Self> {
        Some(match number {
            1 => Self::Strip1967,
            2 => Self::Strip1967Continuous,
            3 => Self::Strip,
            4 => Self::Total,
            5 => Self::Linear,
            _ => return None,
        })
    }

    /// Every model.
    pub const ALL: [Self; 5] =
        [Self::Strip1967, Self::Strip1967Continuous, Self::Strip, Self::Total, Self::Linear];
}

/// Which model, and how many strips.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// The traction law.
    pub model: Model,
    /// How many strips share the patch; ignored by models without strips.
    pub strips: StripCount,
}

/// Forces on the lower body.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Solution<F> {
    /// Longitudinal force \[N\], positive along the rolling direction.
    pub fx: F,
    /// Lateral force \[N\].
    pub fy: F,
    /// Moment about z at the centre of the contact \[N m\].
    pub mz: F,
    /// Frictional power over rolling speed, fx longitudinal + fy lateral + mz spin \[N\]: energy dissipated per metre
    /// rolled.
    pub power: F,
    /// Share of the contact area in adhesion \[-\], 0 to 1. KSTRIP_MODEL_TOTAL does not know it: -1; KSTRIP_MODEL_LINEAR
    /// has adhesion everywhere: 1.
    pub adhesion: F,
    /// The status of this result: 0 or one of the KSTRIP_WARNING constants.
    pub notice: Notice,
    /// Zero.
    pub reserved: i32,
}

impl<F: Float> Solution<F> {
    /// A contact that carries nothing: no force, no adhesion.
    #[must_use]
    pub fn nothing() -> Self {
        let zero = F::zero();
        let notice = Notice::None;
        Self { fx: zero, fy: zero, mz: zero, power: zero, adhesion: zero, notice, reserved: 0 }
    }

    /// The same contact seen from the upper body: opposite forces and moment, same power.
    #[must_use]
    pub fn on_upper_body(&self) -> Self {
        Self { fx: -self.fx, fy: -self.fy, mz: -self.mz, ..*self }
    }
}

/// `d(F_x, F_y, M_z)/d(υx, υy, φ)`, row by row: N, N, N m over 1, 1, 1/m.
pub type Jacobian<F> = Matrix3<F>;

/// Floating-point types that every model can be computed in.
#[cfg(not(target_arch = "x86_64"))]
pub trait Precision: Float {}

/// Floating-point types that every model can be computed in.
#[cfg(target_arch = "x86_64")]
pub trait Precision: Float + crate::batch::side_by_side::Wide {}

impl Precision for f64 {}
impl Precision for f32 {}

/// Forces in newtons, with derivatives or without.
pub(crate) struct Forces<T> {
    pub(crate) fx: T,
    pub(crate) fy: T,
    pub(crate) mz: T,
    pub(crate) adhesion: T,
}

/// A checked contact and its creepage.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Problem<'a, F> {
    pub(crate) contact: &'a Contact<F>,
    pub(crate) creepage: &'a Creepage<F>,
    // By value, so that a model known to the compiler stays known and the others are not linked.
    pub(crate) options: Options,
    /// Whether nothing is to be checked or warned of, [`Contact::is_ordinary`].
    pub(crate) ordinary: bool,
}

impl<'a, F: Plain> Problem<'a, F> {
    /// Not checked yet.
    #[inline(always)]
    pub(crate) fn of(
        contact: &'a Contact<F>,
        creepage: &'a Creepage<F>,
        options: &Options,
    ) -> Self {
        let ordinary = contact.is_ordinary(creepage);
        Self { contact, creepage, options: *options, ordinary }
    }
}

impl<'a, F: Precision> Problem<'a, F> {
    #[inline(always)]
    pub(crate) fn new(
        contact: &'a Contact<F>,
        creepage: &'a Creepage<F>,
        options: &Options,
    ) -> Result<Self, Error> {
        let problem = Self::of(contact, creepage, options);
        if !problem.is_sound() {
            problem.find_fault()?;
        }
        Ok(problem)
    }

    #[cold]
    #[inline(never)]
    fn find_fault(&self) -> Result<(), Error> {
        self.contact.find_fault()?;
        self.creepage.check()?;
        if self.contact.is_lost() || self.range().iter().all(|number| number.is_finite_number()) {
            Ok(())
        } else {
            Err(Error::Overflow)
        }
    }

    /// Forces of the chosen model.
    #[inline(always)]
    fn forces<T: Real<Base = F>>(&self, creepage: &Creepage<T>) -> (Forces<T>, Notice) {
        if self.options.model == Model::Linear {
            return self.linear_forces(creepage);
        }
        self.saturating_forces::<T, true, true>(creepage)
    }

    /// Forces of a model with a friction bound; without the stick area or the moment these mean nothing.
    #[inline(always)]
    pub(crate) fn saturating_forces<T: Real<Base = F>, const STICK: bool, const MOMENT: bool>(
        &self,
        creepage: &Creepage<T>,
    ) -> (Forces<T>, Notice) {
        let parameters = Parameters::new(self.contact, creepage);
        let bound = self.contact.friction_bound();
        let Creepage { longitudinal, lateral, spin } = *creepage;
        let at_rest = [longitudinal, lateral, spin].iter().all(|part| part.value() == F::zero());
        let totals = match self.options.model {
            // Nothing is carried, and strips with adhesion would be looked for at a spin beyond all bounds.
            Model::Strip1967 | Model::Strip1967Continuous if !(bound > F::zero() || at_rest) => {
                let (force, stick) = (T::zero(), T::zero());
                Totals { fx: force, fy: force, mz: force, stick }
            }
            _ => self.wanted_totals::<T, STICK, MOMENT>(&parameters),
        };
        let forces = Forces {
            fx: totals.fx.scale(bound),
            fy: totals.fy.scale(bound),
            mz: totals.mz.scale(bound * self.mean_radius()),
            adhesion: totals.stick,
        };
        (forces, self.notice(parameters.psi.value()))
    }

    /// Forces of a model with a friction bound, in units of it: `F/(μ N)`, `M_z/(μ N √(ab))`.
    #[inline(always)]
    pub(crate) fn totals<T: Real<Base = F>>(&self, parameters: &Parameters<T>) -> Totals<T> {
        self.wanted_totals::<T, true, true>(parameters)
    }

    /// The same without the stick area or the moment, which mean nothing then.
    #[inline(always)]
    pub(crate) fn wanted_totals<T: Real<Base = F>, const STICK: bool, const MOMENT: bool>(
        &self,
        parameters: &Parameters<T>,
    ) -> Totals<T> {
        match self.options.model {
            Model::Strip1967 | Model::Strip1967Continuous | Model::Linear => {
                strip_1967::totals(parameters, self.sliding_rule())
            }
            Model::Strip => self.rolling_strips(parameters),
            Model::Total => self.total_force(parameters),
        }
    }

    /// (A function of its own: on a microcontroller the other models do not share its stack, elsewhere not its
    /// registers.)
    #[inline(never)]
    fn total_force<T: Real<Base = F>>(&self, parameters: &Parameters<T>) -> Totals<T> {
        // (a microcontroller has them in flash once)
        let linear = if cfg!(target_os = "none") {
            self.linear_coefficients()
        } else {
            LinearCoefficients::at_inline(parameters.axis_ratio, parameters.poisson_ratio)
        };
        total::Prepared::new(parameters.axis_ratio, parameters.poisson_ratio, &linear)
            .totals(parameters.normalised())
    }

    pub(crate) fn notice(&self, psi: F) -> Notice {
        let Contact { a, b, .. } = *self.contact;
        let of_model = notice(self.options.model, self.contact.friction_bound(), a / b, psi);
        self.with_warning(of_model)
    }

    /// Or that an input is implausible.
    fn with_warning(&self, notice: Notice) -> Notice {
        if self.ordinary { notice } else { self.warned(notice) }
    }

    #[cold]
    #[inline(never)]
    fn warned(&self, notice: Notice) -> Notice {
        notice.worse(warning(self.contact, self.creepage))
    }

    fn linear_coefficients(&self) -> LinearCoefficients<F> {
        LinearCoefficients::at(self.contact.a / self.contact.b, self.contact.poisson_ratio)
    }

    /// Forces of the linear theory.
    pub(crate) fn linear_forces<T: Real<Base = F>>(
        &self,
        creepage: &Creepage<T>,
    ) -> (Forces<T>, Notice) {
        let forces = self.linear(&self.linear_coefficients(), creepage);
        let size = linear_size(forces.fx.value(), forces.fy.value());
        (forces, self.with_warning(linear_notice(size, self.contact.friction_bound())))
    }

    /// (On a microcontroller the other models do not share its stack.)
    #[cfg_attr(target_os = "none", inline(never))]
    #[cfg_attr(not(target_os = "none"), inline(always))]
    fn rolling_strips<T: Real<Base = F>>(&self, parameters: &Parameters<T>) -> Totals<T> {
        let Parameters { axis_ratio, poisson_ratio, .. } = *parameters;
        let linear = self.linear_coefficients();
        let strips = PreparedStrips::new(axis_ratio, poisson_ratio, &linear, self.options.strips);
        #[cfg(target_arch = "x86_64")]
        return strips.totals_by(parameters.normalised(), F::strip_sums);
        #[cfg(not(target_arch = "x86_64"))]
        strips.totals(parameters.normalised())
    }

    /// Without creepage and spin every model has zero forces and, if it knows, adhesion everywhere.
    #[inline(always)]
    pub(crate) fn at_rest(&self) -> Option<Solution<F>> {
        let Creepage { longitudinal, lateral, spin } = *self.creepage;
        let (zero, one) = (F::zero(), F::one());
        if self.contact.is_lost() {
            return Some(Solution::nothing());
        }
        if longitudinal != zero || lateral != zero || spin != zero {
            return None;
        }
        let adhesion = if self.options.model == Model::Total { -one } else { one };
        let notice = self.notice(zero);
        Some(Solution { fx: zero, fy: zero, mz: zero, power: zero, adhesion, notice, reserved: 0 })
    }

    #[inline(always)]
    pub(crate) fn solution(&self, forces: &Forces<F>, notice: Notice) -> Solution<F> {
        let Forces { fx, fy, mz, adhesion } = *forces;
        let power = self.creepage.power([fx, fy, mz]);
        Solution { fx, fy, mz, power, adhesion, notice, reserved: 0 }
    }
}

impl<F: Plain> Problem<'_, F> {
    /// Every result is a number within its bound times these: check them before anything is
    /// computed.
    fn range(&self) -> [F; 4] {
        let Creepage { longitudinal, lateral, spin } = *self.creepage;
        let Contact { a, b, .. } = *self.contact;
        let bound = self.force_limit();
        let moment = bound * (a + b);
        let power = bound * longitudinal.abs() + bound * lateral.abs() + moment * spin.abs();
        // The velocity that spin causes at the edge, also where nothing is carried
        let edge_slip = (a + b) * spin.abs();
        // (a hair above the bounds, because forces round)
        [power, moment, bound, edge_slip].map(|number| number.times(1.001))
    }

    /// Whether all is well, told by few comparisons; of several contacts side by side, with all of them. Rarely all is
    /// well also where this says no: [`check`] looks closer.
    #[inline(always)]
    pub(crate) fn is_sound(&self) -> bool {
        if self.ordinary {
            return true;
        }
        let Creepage { longitudinal, lateral, spin } = *self.creepage;
        let size = self.contact.a + self.contact.b;
        let edge_slip = size * spin.abs();
        let slip = longitudinal.abs() + lateral.abs() + edge_slip;
        // No less than any of `range`, and not finite if a creepage is not
        let sum = self.force_limit() * (slip + size.plus(1.0)) + edge_slip;
        self.contact.is_sound() & sum.times(1.01).lies_within(F::LARGEST)
    }

    /// What no force of the model exceeds \[N\].
    #[inline(always)]
    fn force_limit(&self) -> F {
        let Creepage { longitudinal, lateral, spin } = *self.creepage;
        let Contact { a, b, .. } = *self.contact;
        match self.options.model {
            Model::Linear => {
                let creepage = longitudinal.abs() + lateral.abs() + (a + b) * spin.abs();
                // No coefficient exceeds this: C23 grows like (a/b)^(3/2). At least one, because stiffness times lever
                // is a factor of the moment.
                let ratio = a / b + b / a;
                let size = creepage * (ratio * ratio.sqrt()).plus(100.0);
                self.linear_stiffness() * size.max(F::one())
            }
            _ => self.contact.friction_bound(),
        }
    }

    #[inline(always)]
    pub(crate) fn sliding_rule(&self) -> SlidingRule {
        match self.options.model {
            Model::Strip1967Continuous => SlidingRule::Continuous,
            _ => SlidingRule::RigidSlip,
        }
    }

    /// `G a b` \[N\]
    #[inline(always)]
    fn linear_stiffness(&self) -> F {
        self.contact.shear_modulus * self.contact.a * self.contact.b
    }

    /// `√(ab)` \[m\], without overflow.
    #[inline(always)]
    pub(crate) fn mean_radius(&self) -> F {
        let (a, b) = F::Pair::of(self.contact.a, self.contact.b).sqrt().parts();
        a * b
    }

    /// `F_x = G a b C11 υx`, `F_y = G a b (C22 υy + √(ab) C23 φ)`,
    /// `M_z = G (ab)^{3/2} (−C23 υy + √(ab) C33 φ)`
    #[inline(always)]
    pub(crate) fn linear<T: Number<Base = F>>(
        &self,
        coefficients: &LinearCoefficients<F>,
        creepage: &Creepage<T>,
    ) -> Forces<T> {
        let LinearCoefficients { c11, c22, c23, c33 } = *coefficients;
        let (stiffness, radius) = (self.linear_stiffness(), self.mean_radius());
        let spin = creepage.spin.scale(radius);
        Forces {
            fx: creepage.longitudinal.scale(c11).scale(stiffness),
            fy: (creepage.lateral.scale(c22) + spin.scale(c23)).scale(stiffness),
            mz: (spin.scale(c33) - creepage.lateral.scale(c23)).scale(stiffness * radius),
            adhesion: T::one(),
        }
    }
}

/// `|F|` without squares, which may overflow: it lies between the larger component and their sum.
#[inline(always)]
pub(crate) fn linear_size<F: Plain>(fx: F, fy: F) -> F {
    let (x, y) = (fx.abs(), fy.abs());
    let (larger, smaller) = (x.max(y), x.min(y));
    let ratio = smaller / (larger + F::TINY);
    larger * (F::one() + ratio * ratio).sqrt()
}

/// What the caller of the linear theory should know.
#[inline(always)]
pub(crate) fn linear_notice<F: Float>(size: F, friction_bound: F) -> Notice {
    if size > friction_bound { Notice::BeyondFriction } else { Notice::None }
}

/// Axis ratios that [`Model::Strip`] is made for, a hair more.
pub(crate) const RATIOS: [f64; 2] = [0.099_999, 10.000_1];
/// Spins `|ψ|` that it is made for.
pub(crate) const LARGEST_SPIN: f64 = 3.0;
/// Axis ratios that [`Model::Total`] is made for, a hair more; it knows the limit of large spin.
const RATIOS_OF_TOTAL: [f64; 2] = [0.049_999, 20.000_1];

/// What the caller of a model with a friction bound should know.
#[inline(always)]
pub(crate) fn notice<F: Float>(model: Model, friction_bound: F, ratio: F, psi: F) -> Notice {
    if friction_bound <= F::zero() {
        // Nothing to carry: zero forces are right in every model with a friction bound.
        return Notice::None;
    }
    match model {
        Model::Strip1967 | Model::Strip1967Continuous if psi.abs() >= F::one() => {
            Notice::SpinBeyondTheory
        }
        Model::Total
            if ratio < F::constant(RATIOS_OF_TOTAL[0])
                || ratio > F::constant(RATIOS_OF_TOTAL[1]) =>
        {
            Notice::OutsideRange
        }
        Model::Strip
            if psi.abs() > F::constant(LARGEST_SPIN)
                || ratio < F::constant(RATIOS[0])
                || ratio > F::constant(RATIOS[1]) =>
        {
            Notice::OutsideRange
        }
        _ => Notice::None,
    }
}

/// Check the inputs of [`solve`] without solving.
///
/// (On a microcontroller its stack is free when a batch is solved.)
///
/// # Errors
/// Those of [`solve`].
#[cfg_attr(target_os = "none", inline(never))]
pub fn check<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
) -> Result<(), Error> {
    Problem::new(contact, creepage, options).map(|_| ())
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
/// use kstrip::{contact::Contact, contact::creepage::Creepage, solve::model::{solve, Options}};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, shear_modulus: 82e9, poisson_ratio: 0.28, friction: 0.3,
/// };
/// let creepage = Creepage { longitudinal: 1e-3, lateral: 0.0, spin: 0.0 };
/// let forces = solve(&contact, &creepage, &Options::default())?;
/// assert!(forces.fx > 0.0 && forces.fx < 24e3 && forces.fy == 0.0);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn solve<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
) -> Result<Solution<F>, Error> {
    solve_inline(contact, creepage, options)
}

/// [`solve`] with [`Model::Total`]; a program that calls only this links no other model.
///
/// # Errors
/// Those of [`solve`].
pub fn solve_total<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
) -> Result<Solution<F>, Error> {
    let options = Options { model: Model::Total, strips: StripCount::Sixteen };
    solve_inline(contact, creepage, &options)
}

/// [`solve`] with [`Model::Linear`]; a program that calls only this links no other model.
///
/// # Errors
/// Those of [`solve`].
pub fn solve_linear<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
) -> Result<Solution<F>, Error> {
    let options = Options { model: Model::Linear, strips: StripCount::Sixteen };
    solve_inline(contact, creepage, &options)
}

/// [`solve`] with [`Model::Strip1967`]; a program that calls only this links no other model.
///
/// # Errors
/// Those of [`solve`].
pub fn solve_strip_1967<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    strips: StripCount,
) -> Result<Solution<F>, Error> {
    solve_inline(contact, creepage, &Options { model: Model::Strip1967, strips })
}

/// [`solve`] with [`Model::Strip`]; a program that calls only this links no other model.
///
/// # Errors
/// Those of [`solve`].
pub fn solve_strip<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    strips: StripCount,
) -> Result<Solution<F>, Error> {
    solve_inline(contact, creepage, &Options { model: Model::Strip, strips })
}

/// [`solve`] in the caller's own code: a solution that goes through memory once more, in pieces of other sizes, is
/// waited for.
#[inline(always)]
pub(crate) fn solve_inline<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
) -> Result<Solution<F>, Error> {
    let problem = Problem::new(contact, creepage, options)?;
    if let Some(rest) = problem.at_rest() {
        return Ok(rest);
    }
    let (forces, notice) = problem.forces(creepage);
    Ok(problem.solution(&forces, notice))
}

/// Forces and their exact derivatives with respect to the creepages.
///
/// The derivatives are those of the computed forces, by forward-mode differentiation of the same
/// code: the linear slopes at zero creepage, zero along the slip direction in saturation, one-sided
/// values where a model has a kink.
///
/// # Errors
/// Those of [`solve`].
pub fn solve_jacobian<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
) -> Result<(Solution<F>, Jacobian<F>), Error> {
    let problem = Problem::new(contact, creepage, options)?;
    if contact.is_lost() {
        return Ok((Solution::nothing(), Matrix3::from([[F::zero(); 3]; 3])));
    }
    jacobian_of(&problem, problem.forces(&creepage.inputs()))
}

/// [`solve_jacobian`] of a model with a friction bound, without the stick area, which means nothing then.
pub(crate) fn jacobian_without_stick<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
) -> Result<(Solution<F>, Jacobian<F>), Error> {
    let problem = Problem::new(contact, creepage, options)?;
    if contact.is_lost() {
        return Ok((Solution::nothing(), Matrix3::from([[F::zero(); 3]; 3])));
    }
    jacobian_of(&problem, problem.saturating_forces::<_, false, true>(&creepage.inputs()))
}

fn jacobian_of<F: Precision>(
    problem: &Problem<F>,
    (forces, notice): (Forces<Dual<F, 3>>, Notice),
) -> Result<(Solution<F>, Jacobian<F>), Error> {
    let Forces { fx, fy, mz, adhesion } = forces;
    let mut values = Forces { fx: fx.value, fy: fy.value, mz: mz.value, adhesion: adhesion.value };
    // nalgebra counts columns first.
    let mut jacobian = Matrix3::from([fx.gradient, fy.gradient, mz.gradient]).transpose();
    if problem.options.model != Model::Linear && problem.contact.friction_bound() <= F::zero() {
        // Nothing is carried, however fast `f` changes: its slopes may be beyond the number range.
        jacobian.fill(F::zero());
        let none = F::zero();
        values = Forces { fx: none, fy: none, mz: none, adhesion: values.adhesion };
    }
    if jacobian.iter().all(|entry| entry.is_finite_number()) {
        Ok((problem.solution(&values, notice), jacobian))
    } else {
        Err(Error::Overflow)
    }
}

/// One strip y = const of a contact or a patch: what it carries, on the lower body.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripResult<F> {
    /// Centre line \[m\].
    pub y: F,
    /// Width that the strip stands for \[m\].
    pub width: F,
    /// Half of its length along x \[m\].
    pub half_length: F,
    /// x of the separatrix \[m\]: slip behind it, adhesion ahead of it; the leading edge where the whole strip slides.
    pub separatrix: F,
    /// Its share of the longitudinal force \[N\].
    pub fx: F,
    /// Its share of the lateral force \[N\].
    pub fy: F,
    /// Its share of the moment about the centre of the contact \[N m\].
    pub mz: F,
    /// Its share of the frictional power \[N\].
    pub power: F,
    /// KSTRIP_STATE_STICK if it has an adhesion area, else KSTRIP_STATE_SLIP.
    pub state: State,
    /// Zero.
    pub reserved: i32,
}

/// How many strips [`strips`] hands out at most, without solving.
///
/// # Errors
/// Those of [`strips`].
pub fn most_strips<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
) -> Result<usize, Error> {
    check(contact, creepage, options)?;
    match options.model {
        Model::Strip | Model::Strip1967 | Model::Strip1967Continuous => Ok(options.strips as usize),
        Model::Total | Model::Linear => Err(Error::NotInModel),
    }
}

/// Every strip of the solution, handed to `visit`. Their shares add up to the totals of [`solve`].
///
/// # Errors
/// Those of [`solve`].
pub fn strips<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
    visit: &mut dyn FnMut(StripResult<F>),
) -> Result<Notice, Error> {
    let problem = Problem::new(contact, creepage, options)?;
    if contact.is_lost() && !matches!(options.model, Model::Total | Model::Linear) {
        return Ok(Notice::None);
    }
    let parameters = Parameters::new(contact, creepage);
    let bound = contact.friction_bound();
    let mut share = |strip: PlacedStrip<F>| {
        let (fx, fy) = (bound * strip.fx, bound * strip.fy);
        let mz = bound * problem.mean_radius() * strip.mz;
        visit(StripResult {
            y: contact.b * strip.y,
            width: contact.b * strip.width,
            half_length: contact.a * strip.half_length,
            separatrix: contact.a * (strip.kappa + strip.kappa - strip.half_length),
            fx,
            fy,
            mz,
            power: fx * creepage.longitudinal + fy * creepage.lateral + mz * creepage.spin,
            state: if strip.adheres { State::Stick } else { State::Slip },
            reserved: 0,
        });
    };
    match options.model {
        Model::Strip1967 | Model::Strip1967Continuous => {
            let rule = problem.sliding_rule();
            strip_1967::strips::strips(&parameters, rule, options.strips, &mut share);
        }
        Model::Strip => {
            let Parameters { axis_ratio, poisson_ratio, .. } = parameters;
            let linear = problem.linear_coefficients();
            let law = PreparedStrips::new(axis_ratio, poisson_ratio, &linear, options.strips);
            place_rolling(&law, parameters.normalised(), options.strips, &mut share);
        }
        Model::Total | Model::Linear => return Err(Error::NotInModel),
    }
    Ok(problem.notice(parameters.psi))
}

/// The corrected strips in the form of those of the theory of 1967.
#[inline(never)]
fn place_rolling<F: Precision>(
    strips: &PreparedStrips<F>,
    creepage: [F; 3],
    count: StripCount,
    visit: &mut dyn FnMut(PlacedStrip<F>),
) {
    let rule = Rule::<F>::new(count);
    let mut places = rule.places();
    strips.each(creepage, &mut |carried, area| {
        let Some([y, c, width]) = places.next() else { return };
        let Totals { fx, fy, mz, stick } = carried;
        visit(PlacedStrip {
            y,
            half_length: c,
            width,
            // The adhesion length as one interval at the leading edge
            kappa: c * (F::one() - stick),
            adheres: stick > F::zero(),
            fx,
            fy,
            mz,
            stick: area * stick,
        });
    });
}

/// The traction law of a field.
#[derive(Clone, Copy, Debug)]
enum Law<F: Real> {
    Theory(Parameters<F>, SlidingRule),
    Rolling(StripLaw<F>),
}

/// The tangential field of a contact, ready to be evaluated at points.
#[derive(Clone, Copy, Debug)]
pub struct Field<F: Real<Base = F>> {
    contact: Contact<F>,
    law: Law<F>,
    /// What the caller should know.
    pub notice: Notice,
}

/// A strip of a [`Field`].
#[derive(Clone, Copy, Debug)]
pub enum FieldStrip<F: Real<Base = F>> {
    /// Of the theory of 1967.
    Theory(Strip<F>),
    /// Of the corrected strips.
    Rolling(StripGeometry<F>),
}

impl<F: Precision> Field<F> {
    /// Prepare the field of a contact and a creepage.
    ///
    /// # Errors
    /// Those of [`solve`]; [`Error::NotInModel`] for models of totals only.
    pub fn new(
        contact: &Contact<F>,
        creepage: &Creepage<F>,
        options: &Options,
    ) -> Result<Self, Error> {
        let problem = Problem::new(contact, creepage, options)?;
        let parameters = Parameters::new(contact, creepage);
        // What a point dissipates: traction times slip, which is of the size of the rigid slip, and as
        // bounded as the parameters are.
        let rigid = creepage.longitudinal.abs()
            + creepage.lateral.abs()
            + (contact.a + contact.b) * creepage.spin.abs();
        let slip = rigid.times(8.0).min(contact.slip_unit().min(F::HUGE) * F::HUGE);
        if !contact.is_lost()
            && !(contact.friction * contact.peak_pressure() * slip).is_finite_number()
        {
            return Err(Error::Overflow);
        }
        let law = match options.model {
            Model::Strip1967 | Model::Strip1967Continuous => {
                Law::Theory(parameters, problem.sliding_rule())
            }
            Model::Strip => {
                let Parameters { axis_ratio, poisson_ratio, .. } = parameters;
                let linear = problem.linear_coefficients();
                let prepared =
                    Prepared::new(axis_ratio, poisson_ratio, &linear, [F::one(), F::one()]);
                Law::Rolling(prepared.see(parameters.normalised()))
            }
            Model::Total | Model::Linear => return Err(Error::NotInModel),
        };
        Ok(Self { contact: *contact, law, notice: problem.notice(parameters.psi) })
    }

    /// The strip through `y` \[m\]; `None` outside the contact.
    #[must_use]
    pub fn strip_at(&self, y: F) -> Option<FieldStrip<F>> {
        if self.contact.is_lost() {
            return None;
        }
        let relative = y / self.contact.b;
        let square = (F::one() - relative) * (F::one() + relative);
        if !(square > F::zero()) {
            return None;
        }
        let half_length = square.sqrt();
        Some(match &self.law {
            Law::Theory(p, rule) => FieldStrip::Theory(Strip::solve(
                half_length,
                p.xi - p.spin_slope() * relative,
                p.eta,
                p.psi,
                p.poisson_ratio,
                *rule,
            )),
            Law::Rolling(_) => FieldStrip::Rolling(StripGeometry {
                y: relative,
                half_length,
                bound: half_length,
                width: F::zero(),
            }),
        })
    }

    /// The state at a point of the contact plane (`x`, `y` in metres from the centre).
    #[must_use]
    pub fn at(&self, x: F, y: F) -> FieldPoint<F> {
        self.along(self.strip_at(y).as_ref(), x)
    }

    /// The state at `x` \[m\] of a strip of [`Field::strip_at`].
    #[must_use]
    pub fn along(&self, strip: Option<&FieldStrip<F>>, x: F) -> FieldPoint<F> {
        let x = x / self.contact.a;
        let point = match (strip, &self.law) {
            (Some(FieldStrip::Theory(strip)), _) => strip.at(x),
            (Some(FieldStrip::Rolling(geometry)), Law::Rolling(strips)) => {
                rolling_point(strips, geometry, geometry.half_length, x)
            }
            _ => StripPoint::outside(),
        };
        FieldPoint::new(&self.contact, &point)
    }
}

/// A point of a corrected strip in the units of the theory of 1967; the strip's half length `c` and `x` in any
/// one unit, pressure in that in which its peak is `c`.
pub(crate) fn rolling_point<F: Precision>(
    strips: &StripLaw<F>,
    geometry: &StripGeometry<F>,
    c: F,
    x: F,
) -> StripPoint<F> {
    let (ahead, behind) = (c - x, c + x);
    if !(ahead >= F::zero() && behind >= F::zero()) {
        return StripPoint::outside();
    }
    let pressure = (ahead * behind).sqrt();
    let traction = strips.traction(geometry, x / c);
    // Creepages come in units of μ N/(G a b) = (2 μ p₀/G) π/3.
    let unit = F::constant(core::f64::consts::PI / 3.0);
    let point = StripPoint {
        pressure,
        traction_x: pressure * traction.x,
        traction_y: pressure * traction.y,
        slip_x: unit * traction.slip_x,
        slip_y: unit * traction.slip_y,
        state: State::Slip,
    };
    if traction.slips {
        point.judged()
    } else {
        StripPoint { slip_x: F::zero(), slip_y: F::zero(), state: State::Stick, ..point }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No check can fail for the sizes that are let through without: at every corner of them, in both precisions.
    #[test]
    fn usual_sizes_pass_every_check() {
        fn corners<F: Precision>() -> usize {
            let ends = [
                [1e-6, 1.0],
                [1e-6, 1.0],
                [0.0, 1e9],
                [1.0, 1e12],
                [0.0, 0.5],
                [0.0, 5.0],
                [-10.0, 10.0],
                [-10.0, 10.0],
                [-1e4, 1e4],
            ];
            let mut usual = 0;
            for corner in 0..1 << ends.len() {
                let mut k = 0;
                let numbers = ends.map(|ends: [f64; 2]| {
                    k += 1;
                    F::of(ends[(corner >> (k - 1)) & 1])
                });
                let [a, b, normal_force, shear_modulus, poisson_ratio, friction, x, y, spin] =
                    numbers;
                let contact =
                    Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction };
                let creepage = Creepage { longitudinal: x, lateral: y, spin };
                usual += usize::from(contact.is_usual() && creepage.is_usual());
                for model in Model::ALL {
                    let options = Options { model, strips: StripCount::Sixteen };
                    let problem = Problem::of(&contact, &creepage, &options);
                    assert!(problem.find_fault().is_ok(), "{model:?} {contact:?} {creepage:?}");
                }
            }
            usual
        }
        assert_eq!((corners::<f64>(), corners::<f32>()), (512, 512));
    }
}
