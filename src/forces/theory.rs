//! From a contact and a creepage to forces: the contact in the units of the theory, the numbers
//! that a model computes from it, and its forces for a creepage. Each model has code of its own, so
//! that a program that calls one model links no other.

use crate::contact::Contact;
use crate::contact::creepage::{Creepage, Parameters, Units};
use crate::contact::mismatch::{linear_shift, shift_with_slopes};
use crate::contact::totals::Totals;
use crate::forces::check::find_fault;
use crate::forces::options::{Model, Options, Solution};
use crate::forces::warning::{linear_warning, saturating_warning, warned};
use crate::linear::LinearCoefficients;
use crate::number::{Arithmetic, Dual, Float, Number, Pair, Real, length};
use crate::status::Error;
use crate::strip_1967::{self, strip::SlidingRule};
use core::mem::MaybeUninit;

pub(crate) use crate::strip::EllipseStrips;
pub(crate) use crate::total::Total;

/// The one table of models: calls `function::<_, M>(arguments)` for the type `M` of a model with
/// numbers `F`. The last argument is the value for a model that this build of the library leaves
/// out.
macro_rules! by_model {
    ($model:expr, $F:ty, $function:ident($($argument:expr),*), $absent:expr) => {{
        use $crate::forces::options::Model;
        use $crate::forces::theory::{EllipseStrips, Linear, Strip1967, Total};
        match $model {
            Model::Strip1967 | Model::Strip1967Continuous if Model::HAS_STRIP_1967 => {
                $function::<_, Strip1967>($($argument),*)
            }
            Model::Strip if Model::HAS_STRIP => $function::<_, EllipseStrips<$F>>($($argument),*),
            Model::Total if Model::HAS_TOTAL => $function::<_, Total<$F>>($($argument),*),
            Model::Linear if Model::HAS_LINEAR => $function::<_, Linear<$F>>($($argument),*),
            _ => $absent,
        }
    }};
}
pub(crate) use by_model;

/// Forces for a contact and a creepage.
///
/// # Errors
/// Those of [`Contact::check`] and [`Creepage::check`]; [`Error::Overflow`] when a force or the
/// power does not fit the floating-point type.
///
/// # Example
/// A wheel on a rail, 0.1 % longitudinal creepage:
/// ```
/// use kstrip::contact::{Contact, creepage::Creepage};
/// use kstrip::forces::{Options, forces_of_contact};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, friction: 0.3,
///     shear_modulus: 82e9, poisson_ratio: 0.28, mismatch: 0.0,
/// };
/// let creepage = Creepage { longitudinal: 1e-3, lateral: 0.0, spin: 0.0 };
/// let forces = forces_of_contact(&contact, &creepage, &Options::default())?;
/// assert!(forces.fx > 0.0 && forces.fx < 24e3 && forces.fy == 0.0);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn forces_of_contact<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, options: &Options,
) -> Result<Solution<F>, Error> {
    let mut place = MaybeUninit::uninit();
    write_forces(contact, creepage, options, &mut place).copied()
}

/// The same, written where the caller wants it.
pub(crate) fn write_forces<'a, F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, options: &Options,
    place: &'a mut MaybeUninit<Solution<F>>,
) -> Result<&'a Solution<F>, Error> {
    let absent = Err(Error::ModelLeftOut);
    let found = by_model!(options.model, F, solution_of(contact, creepage, options), absent);
    found.map(|solution| &*place.write(solution))
}

/// The same as [`forces_of_contact`], inlined in each caller, which then links no other model.
#[inline(always)]
pub(crate) fn solution_of<F: Float, M: Theory<F>>(
    contact: &Contact<F>, creepage: &Creepage<F>, options: &Options,
) -> Result<Solution<F>, Error> {
    solution_by(contact, creepage, |frame| M::of_contact(frame, options))
}

/// Forces by a theory that is made for the contact, if it has a load.
#[inline(always)]
pub(crate) fn solution_by<F: Float, M: Theory<F>>(
    contact: &Contact<F>, creepage: &Creepage<F>, theory: impl FnOnce(&ScaledContact<F>) -> M,
) -> Result<Solution<F>, Error> {
    let ordinary = contact.is_ordinary(creepage);
    if !ordinary {
        find_fault(contact, creepage, M::MODEL)?;
    }
    if contact.is_lost() {
        return Ok(Solution::default());
    }
    let frame = &ScaledContact::new(contact);
    Ok(frame.solve_checked(&theory(frame), creepage, ordinary))
}

/// A contact in the units of the theory: numbers only.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScaledContact<F> {
    pub(crate) contact: Contact<F>,
    /// `√(ab)` \[m\]
    pub(crate) radius: F,
    pub(crate) units: Units<F>,
}

impl<F: Real> ScaledContact<F> {
    #[inline(always)]
    pub(crate) fn new(contact: &Contact<F>) -> Self {
        let (root_a, root_b) = F::Pair::couple(contact.a, contact.b).sqrt().parts();
        Self { contact: *contact, radius: root_a * root_b, units: Units::new(contact) }
    }

    /// `a/b` and `ν`, and the coefficients for them.
    #[inline(always)]
    pub(crate) fn shape(&self) -> (F, F, LinearCoefficients<F>) {
        let (ratio, poisson_ratio) = (self.units.axis_ratio, self.contact.poisson_ratio);
        (ratio, poisson_ratio, LinearCoefficients::at(ratio, poisson_ratio))
    }

    /// Forces in newtons from `F/(μ N)` and `M_z/(μ N √(ab))`.
    #[inline(always)]
    pub(crate) fn in_newtons(&self, totals: Totals<F>) -> Forces<F> {
        let bound = self.contact.friction_bound();
        let Totals { fx, fy, mz, stick } = totals;
        Forces { fx: fx * bound, fy: fy * bound, mz: mz * (bound * self.radius), adhesion: stick }
    }
}

impl<F: Float> ScaledContact<F> {
    /// The creepage with the part that pressure adds in dissimilar bodies, and that part. It is
    /// zero in like bodies and in the theory of 1967.
    #[inline(always)]
    pub(crate) fn creepage_with_pressure(
        &self, creepage: &Creepage<F>, model: Model,
    ) -> (Creepage<F>, Option<Dual<F, 4>>) {
        if self.contact.mismatch == F::zero() || model.is_of_1967() {
            return (*creepage, None);
        }
        // Copies are taken here and below, because otherwise all numbers of the frame are stored.
        let (contact, units) = (self.contact, self.units);
        let shift = match model {
            Model::Linear => linear_shift(&contact),
            _ => shift_with_slopes(&contact, &units, creepage),
        };
        let longitudinal = creepage.longitudinal + shift.value;
        (Creepage { longitudinal, ..*creepage }, Some(shift))
    }

    /// The solution for a loaded contact and a creepage that have been checked.
    #[inline(always)]
    pub(crate) fn solve_checked<M: Theory<F>>(
        &self, theory: &M, creepage: &Creepage<F>, ordinary: bool,
    ) -> Solution<F> {
        let (creepage, _) = &self.creepage_with_pressure(creepage, M::MODEL);
        let (forces, psi) = match Forces::at_rest(creepage, M::MODEL) {
            Some(none) => (none, F::zero()),
            None => theory.forces(self, creepage),
        };
        self.solution(M::MODEL, creepage, &forces, psi, ordinary)
    }

    /// Forces with power and warning.
    #[inline(always)]
    pub(crate) fn solution(
        &self, model: Model, creepage: &Creepage<F>, forces: &Forces<F>, psi: F, ordinary: bool,
    ) -> Solution<F> {
        let of_model = if model == Model::Linear {
            linear_warning(length(forces.fx, forces.fy), self.contact.friction_bound())
        } else {
            saturating_warning(model, &self.contact, self.units.axis_ratio, psi)
        };
        let warning = if ordinary {
            of_model
        } else {
            let (contact, creepage) = (self.contact, *creepage);
            warned(&contact, &creepage, of_model)
        };
        let Forces { fx, fy, mz, adhesion } = *forces;
        let power = creepage.power([fx, fy, mz]);
        Solution { fx, fy, mz, power, adhesion, warning, reserved: 0 }
    }
}

/// Forces in newtons, moment in newton metres, share in adhesion.
pub(crate) struct Forces<T> {
    pub(crate) fx: T,
    pub(crate) fy: T,
    pub(crate) mz: T,
    pub(crate) adhesion: T,
}

impl<F: Float> Forces<F> {
    /// The forces without creepage: zero, with adhesion everywhere, which TOTAL does not compute.
    /// `None` if there is creepage.
    #[inline(always)]
    pub(crate) fn at_rest(creepage: &Creepage<F>, model: Model) -> Option<Self> {
        let zero = F::zero();
        let Creepage { longitudinal, lateral, spin } = *creepage;
        let rests = longitudinal == zero && lateral == zero && spin == zero;
        let adhesion = if model == Model::Total { -F::one() } else { F::one() };
        rests.then_some(Self { fx: zero, fy: zero, mz: zero, adhesion })
    }
}

/// A model, ready for the creepages of one contact.
pub(crate) trait Theory<F: Real>: Copy {
    /// The number of the model; in the theory of 1967 that of one rule stands for both.
    const MODEL: Model;

    /// Computes everything that depends on the contact alone.
    fn of_contact(frame: &ScaledContact<F>, options: &Options) -> Self;

    /// `F/(μ N)`, `M_z/(μ N √(ab))` and the share in adhesion. The linear theory has no bound `μ N`
    /// and does not use this function.
    fn model_totals<T: Number<Base = F>>(
        &self, frame: &ScaledContact<F>, parameters: &Parameters<T>,
    ) -> Totals<T>;

    /// `G a b C11`, `G a b C22`, `G (ab)^{3/2} C23`, `G (ab)² C33` for the linear theory; `None`
    /// for all other models.
    fn stiffness(&self) -> Option<&[F; 4]> {
        None
    }

    /// The forces of a loaded contact with creepage, and `ψ`.
    #[inline(always)]
    fn forces(&self, frame: &ScaledContact<F>, creepage: &Creepage<F>) -> (Forces<F>, F) {
        let parameters = frame.units.parameters(creepage);
        (frame.in_newtons(self.model_totals(frame, &parameters)), parameters.psi)
    }
}

/// The theory of 1967 with either rule of sliding, which uses only the parameters of a contact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Strip1967(pub(crate) SlidingRule);

impl<F: Real> Theory<F> for Strip1967 {
    const MODEL: Model = Model::Strip1967;

    #[inline(always)]
    fn of_contact(_: &ScaledContact<F>, options: &Options) -> Self {
        Self(sliding_rule(options.model))
    }
    #[inline(always)]
    fn model_totals<T: Number<Base = F>>(
        &self, _: &ScaledContact<F>, parameters: &Parameters<T>,
    ) -> Totals<T> {
        strip_1967::totals(parameters, self.0)
    }
}

/// The sliding rule of a model of the theory of 1967.
pub(crate) fn sliding_rule(model: Model) -> SlidingRule {
    if model == Model::Strip1967Continuous {
        SlidingRule::Continuous
    } else {
        SlidingRule::RigidSlip
    }
}

impl<F: Real> Theory<F> for EllipseStrips<F> {
    const MODEL: Model = Model::Strip;

    #[inline(always)]
    fn of_contact(frame: &ScaledContact<F>, options: &Options) -> Self {
        let (ratio, poisson_ratio, linear) = frame.shape();
        Self::new(ratio, poisson_ratio, &linear, options.strips)
    }
    #[inline(always)]
    fn model_totals<T: Number<Base = F>>(
        &self, frame: &ScaledContact<F>, parameters: &Parameters<T>,
    ) -> Totals<T> {
        self.totals_of_strips(frame.units.normalised(parameters))
    }
}

impl<F: Real> Theory<F> for Total<F> {
    const MODEL: Model = Model::Total;

    #[inline(always)]
    fn of_contact(frame: &ScaledContact<F>, _: &Options) -> Self {
        let (ratio, poisson_ratio, linear) = frame.shape();
        Self::new(ratio, poisson_ratio, &linear)
    }
    #[inline(always)]
    fn model_totals<T: Number<Base = F>>(
        &self, frame: &ScaledContact<F>, parameters: &Parameters<T>,
    ) -> Totals<T> {
        self.mean_totals(frame.units.normalised(parameters))
    }
}

/// The linear theory: `G a b C11`, `G a b C22`, `G (ab)^{3/2} C23`, `G (ab)² C33`.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub(crate) struct Linear<F>(pub(crate) [F; 4]);

impl<F: Real> Theory<F> for Linear<F> {
    const MODEL: Model = Model::Linear;

    #[inline(always)]
    fn of_contact(frame: &ScaledContact<F>, _: &Options) -> Self {
        let (_, _, LinearCoefficients { c11, c22, c23, c33 }) = frame.shape();
        let Contact { a, b, shear_modulus, .. } = frame.contact;
        let stiffness = shear_modulus * a * b;
        let lever = stiffness * frame.radius;
        let [x, y] = [stiffness * c11, stiffness * c22];
        let [coupling, z] = [lever * c23, lever * frame.radius * c33];
        let mut entries = [x, y, coupling, z];
        // No coefficient is negative.
        if !(x + y + (coupling + z)).lies_within(F::LARGEST) {
            entries = F::each(&entries, |entry| entry.min(F::LARGEST));
        }
        Self(entries)
    }
    #[inline(always)]
    fn model_totals<T: Number<Base = F>>(
        &self, _: &ScaledContact<F>, _: &Parameters<T>,
    ) -> Totals<T> {
        Totals::nothing()
    }
    fn stiffness(&self) -> Option<&[F; 4]> {
        Some(&self.0)
    }
    /// `F_x = G a b C11 υx`, `F_y = G a b (C22 υy + √(ab) C23 φ)`,
    /// `M_z = G (ab)^{3/2} (√(ab) C33 φ − C23 υy)`
    #[inline(always)]
    fn forces(&self, _: &ScaledContact<F>, creepage: &Creepage<F>) -> (Forces<F>, F) {
        let Self([x, y, coupling, z]) = *self;
        let Creepage { longitudinal, lateral, spin } = *creepage;
        let forces = Forces {
            fx: longitudinal * x,
            fy: lateral * y + spin * coupling,
            mz: spin * z - lateral * coupling,
            adhesion: F::one(),
        };
        (forces, F::zero())
    }
}
