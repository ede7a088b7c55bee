//! A contact, ready for creepages: everything that does not depend on the motion, computed once.
//!
//! The one way from a contact and a creepage to forces, for numbers and their derivatives:
//! `with_view!`, then `View::answer`.

use crate::contact::creepage::{Creepage, Parameters, Units};
use crate::contact::forces::Totals;
use crate::contact::{Contact, warning};
use crate::linear::LinearCoefficients;
use crate::number::{Arithmetic, Float, Number, Pair, Plain, length};
use crate::solve::check::is_ordinary;
use crate::solve::model::{Model, Options, Precision, Solution};
use crate::status::{Error, Notice};
use crate::strip::{PreparedStrips, StripTotals};
use crate::strip_1967::{self, strip::SlidingRule};
use crate::total;

/// A contact and a model, ready for creepages.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<F: Plain> {
    pub(crate) frame: Frame<F>,
    pub(crate) options: Options,
    pub(crate) kernel: Kernel<F>,
}

/// What every model needs of a contact: numbers only.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame<F> {
    pub(crate) contact: Contact<F>,
    /// `√(ab)` \[m\]
    pub(crate) radius: F,
    pub(crate) units: Units<F>,
}

impl<F: Plain> Frame<F> {
    #[inline(always)]
    pub(crate) fn of(contact: &Contact<F>) -> Self {
        let (root_a, root_b) = F::Pair::of(contact.a, contact.b).sqrt().parts();
        Self { contact: *contact, radius: root_a * root_b, units: Units::of(contact) }
    }

    /// `a/b`
    #[inline(always)]
    pub(crate) fn axis_ratio(&self) -> F {
        self.units.axis_ratio()
    }

    /// From `F/(μ N)`, `M_z/(μ N √(ab))`.
    #[inline(always)]
    pub(crate) fn forces(&self, totals: Totals<F>) -> Forces<F> {
        let bound = self.contact.friction_bound();
        let Totals { fx, fy, mz, stick } = totals;
        Forces { fx: fx * bound, fy: fy * bound, mz: mz * (bound * self.radius), adhesion: stick }
    }

    /// `G a b C11`, `G a b C22`, `G (ab)^{3/2} C23`, `G (ab)² C33`
    #[inline(always)]
    pub(crate) fn stiffness(&self, linear: &LinearCoefficients<F>) -> [F; 4] {
        let LinearCoefficients { c11, c22, c23, c33 } = *linear;
        let stiffness = self.contact.shear_modulus * self.contact.a * self.contact.b;
        let lever = stiffness * self.radius;
        let entries = [stiffness * c11, stiffness * c22, lever * c23, lever * self.radius * c33];
        F::each(&entries, |entry| entry.min(F::LARGEST))
    }
}

/// Forces of the linear theory from `G a b C11`, `G a b C22`, `G (ab)^{3/2} C23`, `G (ab)² C33`.
#[inline(always)]
pub(crate) fn linear_forces<F: Plain>(
    [x, y, coupling, z]: &[F; 4],
    creepage: &Creepage<F>,
) -> Forces<F> {
    // F_x = G a b C11 υx, F_y = G a b (C22 υy + √(ab) C23 φ), M_z = G (ab)^{3/2} (√(ab) C33 φ − C23 υy)
    let Creepage { longitudinal, lateral, spin } = *creepage;
    Forces {
        fx: longitudinal * *x,
        fy: lateral * *y + spin * *coupling,
        mz: spin * *z - lateral * *coupling,
        adhesion: F::one(),
    }
}

/// What a model knows of a contact.
#[derive(Clone, Copy, Debug)]
#[allow(clippy::large_enum_variant)]
pub(crate) enum Kernel<F: Plain> {
    /// The theory of 1967: nothing.
    Strip1967(SlidingRule),
    /// Strips that follow the slip.
    Strip(PreparedStrips<F>),
    /// Total forces.
    Total(total::Prepared<F>),
    /// `G a b C11`, `G a b C22`, `G (ab)^{3/2} C23`, `G (ab)² C33`
    Linear([F; 4]),
}

/// Forces in newtons, moment in newton metres, share in adhesion.
pub(crate) struct Forces<T> {
    pub(crate) fx: T,
    pub(crate) fy: T,
    pub(crate) mz: T,
    pub(crate) adhesion: T,
}

impl<F: Plain> Prepared<F> {
    /// Where it stands.
    #[inline(always)]
    pub(crate) fn view(&self) -> View<'_, F> {
        let kernel = match &self.kernel {
            Kernel::Strip1967(rule) => KernelView::Strip1967(*rule),
            Kernel::Strip(strips) => KernelView::Strip(strips),
            Kernel::Total(total) => KernelView::Total(total),
            Kernel::Linear(stiffness) => KernelView::Linear(stiffness),
        };
        View { frame: &self.frame, model: self.options.model, kernel }
    }
}

/// `with_view!(contact, options, |view| …)`: what is made of a checked contact, prepared where it stands. Written once for each
/// kind of kernel, so that a model that the compiler knows is the only one there. (A function of a closure brings all models to
/// firmware that calls one.)
macro_rules! with_view {
    ($contact:expr, $options:expr, |$view:ident| $take:expr) => {{
        use crate::linear::LinearCoefficients;
        use crate::solve::prepared::{Frame, KernelView, View, sliding_rule};
        use crate::strip::PreparedStrips;
        use crate::total;
        let (contact, options): (&Contact<_>, &Options) = ($contact, $options);
        let (frame, model) = (&Frame::of(contact), options.model);
        let (ratio, poisson_ratio) = (frame.axis_ratio(), contact.poisson_ratio);
        match model {
            Model::Strip1967 | Model::Strip1967Continuous => {
                let kernel = KernelView::Strip1967(sliding_rule(model));
                let $view = View { frame, model, kernel };
                $take
            }
            Model::Strip => {
                let linear = LinearCoefficients::at(ratio, poisson_ratio);
                let strips = PreparedStrips::new(ratio, poisson_ratio, &linear, options.strips);
                let $view = View { frame, model, kernel: KernelView::Strip(&strips) };
                $take
            }
            Model::Total => {
                let linear = LinearCoefficients::at(ratio, poisson_ratio);
                let total = total::Prepared::new(ratio, poisson_ratio, &linear);
                let $view = View { frame, model, kernel: KernelView::Total(&total) };
                $take
            }
            Model::Linear => {
                let linear = LinearCoefficients::at(ratio, poisson_ratio);
                let stiffness = frame.stiffness(&linear);
                let $view = View { frame, model, kernel: KernelView::Linear(&stiffness) };
                $take
            }
        }
    }};
}
pub(crate) use with_view;

/// Of a model of the theory of 1967.
#[inline(always)]
pub(crate) fn sliding_rule(model: Model) -> SlidingRule {
    if model == Model::Strip1967Continuous {
        SlidingRule::Continuous
    } else {
        SlidingRule::RigidSlip
    }
}

/// A prepared contact where it stands: nothing of it is moved.
#[derive(Clone, Copy)]
pub(crate) struct View<'a, F: Plain> {
    pub(crate) frame: &'a Frame<F>,
    pub(crate) model: Model,
    pub(crate) kernel: KernelView<'a, F>,
}

/// A [`Kernel`] where it stands.
#[derive(Clone, Copy)]
pub(crate) enum KernelView<'a, F: Plain> {
    Strip1967(SlidingRule),
    Strip(&'a PreparedStrips<F>),
    Total(&'a total::Prepared<F>),
    Linear(&'a [F; 4]),
}

impl<F: Plain> KernelView<'_, F> {
    /// To be kept.
    fn kept(self) -> Kernel<F> {
        match self {
            Self::Strip1967(rule) => Kernel::Strip1967(rule),
            Self::Strip(strips) => Kernel::Strip(*strips),
            Self::Total(total) => Kernel::Total(*total),
            Self::Linear(stiffness) => Kernel::Linear(*stiffness),
        }
    }
}

impl<F: StripTotals> View<'_, F> {
    /// Forces of a model with a friction bound, in units of it: `F/(μ N)`, `M_z/(μ N √(ab))`.
    #[inline(always)]
    pub(crate) fn totals<T: Number<Base = F>>(&self, parameters: &Parameters<T>) -> Totals<T> {
        match self.kernel {
            KernelView::Strip1967(rule) => strip_1967::totals(parameters, rule),
            KernelView::Strip(strips) => {
                F::strip_totals(strips, self.frame.units.normalised(parameters))
            }
            KernelView::Total(total) => total.totals(self.frame.units.normalised(parameters)),
            KernelView::Linear(_) => Totals::nothing(),
        }
    }
}

impl<F: Precision> Prepared<F> {
    /// Prepare a contact for [`Prepared::solve`].
    ///
    /// # Errors
    /// Those of [`Contact::check`].
    ///
    /// # Example
    /// ```
    /// use kstrip::{contact::Contact, contact::creepage::Creepage, solve::model::{solve, Options}};
    /// use kstrip::solve::prepared::Prepared;
    /// let contact = Contact {
    ///     a: 6e-3, b: 4e-3, normal_force: 80e3, shear_modulus: 82e9, poisson_ratio: 0.28, friction: 0.3,
    /// };
    /// let disc = Prepared::new(&contact, &Options::default())?;
    /// for percent in 0..10 {
    ///     let creepage = Creepage { longitudinal: f64::from(percent) / 100.0, lateral: 0.0, spin: 0.0 };
    ///     assert_eq!(disc.solve(&creepage), solve(&contact, &creepage, &Options::default()));
    /// }
    /// # Ok::<(), kstrip::status::Error>(())
    /// ```
    pub fn new(contact: &Contact<F>, options: &Options) -> Result<Self, Error> {
        contact.check()?;
        Ok(with_view!(contact, options, |view| Self {
            frame: *view.frame,
            options: *options,
            kernel: view.kernel.kept(),
        }))
    }

    /// [`solve`](crate::solve::model::solve) for this contact: the same result, to the bit.
    ///
    /// # Errors
    /// Those of [`solve`](crate::solve::model::solve).
    #[inline(always)]
    pub fn solve(&self, creepage: &Creepage<F>) -> Result<Solution<F>, Error> {
        let contact = &self.frame.contact;
        let ordinary = is_ordinary(contact, creepage, self.options.model)?;
        if contact.is_lost() {
            return Ok(Solution::nothing());
        }
        Ok(self.view().answer(creepage, ordinary))
    }
}

impl<F: Precision> View<'_, F> {
    /// Of a loaded contact and a creepage that have been checked.
    #[inline(always)]
    pub(crate) fn answer(&self, creepage: &Creepage<F>, ordinary: bool) -> Solution<F> {
        if let Some(none) = self.at_rest(creepage) {
            return self.solution(creepage, &none, F::zero(), ordinary);
        }
        let (forces, psi) = if let KernelView::Linear(stiffness) = self.kernel {
            (linear_forces(stiffness, creepage), F::zero())
        } else {
            let parameters = self.frame.units.parameters(creepage);
            (self.frame.forces(self.totals(&parameters)), parameters.psi)
        };
        self.solution(creepage, &forces, psi, ordinary)
    }

    /// Without creepage no force, and adhesion everywhere.
    #[inline(always)]
    pub(crate) fn at_rest(&self, creepage: &Creepage<F>) -> Option<Forces<F>> {
        let zero = F::zero();
        let Creepage { longitudinal, lateral, spin } = *creepage;
        let adhesion = if self.model == Model::Total { -F::one() } else { F::one() };
        let rests = longitudinal == zero && lateral == zero && spin == zero;
        rests.then_some(Forces { fx: zero, fy: zero, mz: zero, adhesion })
    }

    #[inline(always)]
    pub(crate) fn solution(
        &self,
        creepage: &Creepage<F>,
        forces: &Forces<F>,
        psi: F,
        ordinary: bool,
    ) -> Solution<F> {
        let Forces { fx, fy, mz, adhesion } = *forces;
        let power = creepage.power([fx, fy, mz]);
        let bound = self.frame.contact.friction_bound();
        let of_model = if self.model == Model::Linear {
            linear_notice_of(fx, fy, bound)
        } else {
            notice(self.model, bound, self.frame.axis_ratio(), psi)
        };
        let notice =
            if ordinary { of_model } else { warned(&self.frame.contact, creepage, of_model) };
        Solution { fx, fy, mz, power, adhesion, notice, reserved: 0 }
    }
}

/// A bound whose square has all its digits \[N\].
const TOLD_BY_SQUARES: f64 = 1e-12;

/// [`linear_notice`] of a force, without its root and quotient where the squares tell.
#[inline(always)]
fn linear_notice_of<F: Float>(fx: F, fy: F, bound: F) -> Notice {
    let (square, limit) = (fx * fx + fy * fy, bound * bound);
    if bound > F::constant(TOLD_BY_SQUARES) {
        if square < limit.times(0.9999) {
            return Notice::None;
        }
        if square > limit.times(1.0001) {
            return Notice::BeyondFriction;
        }
    }
    linear_notice(length(fx, fy), bound)
}

/// What the caller of a model with a friction bound should know, and whether an input is implausible.
pub(crate) fn notice_of<F: Float>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    model: Model,
    psi: F,
) -> Notice {
    let of_model = notice(model, contact.friction_bound(), contact.a / contact.b, psi);
    warned(contact, creepage, of_model)
}

/// Or that an input is implausible.
#[cold]
#[inline(never)]
fn warned<F: Float>(contact: &Contact<F>, creepage: &Creepage<F>, notice: Notice) -> Notice {
    notice.worse(warning(contact, creepage))
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
