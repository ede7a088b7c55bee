//! A contact, ready for creepages: everything that does not depend on the motion, computed once.
//!
//! The one way from a contact and a creepage to forces, for numbers, their derivatives, and several contacts side by side:
//! `Prepared::of`, then `Prepared::forces`.

use crate::contact::creepage::{Creepage, Parameters, Units};
use crate::contact::forces::Totals;
use crate::contact::{Contact, warning};
use crate::linear::LinearCoefficients;
use crate::number::{Arithmetic, Float, Number, Pair, Plain};
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

impl<F: StripTotals> Prepared<F> {
    /// A checked contact.
    #[inline(always)]
    pub(crate) fn of(contact: &Contact<F>, options: &Options) -> Self {
        let Contact { a, b, shear_modulus, poisson_ratio, .. } = *contact;
        let (root_a, root_b) = F::Pair::of(a, b).sqrt().parts();
        let (radius, ratio) = (root_a * root_b, a / b);
        let linear = || LinearCoefficients::at_inline(ratio, poisson_ratio);
        let kernel = match options.model {
            Model::Strip1967 => Kernel::Strip1967(SlidingRule::RigidSlip),
            Model::Strip1967Continuous => Kernel::Strip1967(SlidingRule::Continuous),
            Model::Strip => {
                Kernel::Strip(PreparedStrips::new(ratio, poisson_ratio, &linear(), options.strips))
            }
            Model::Total => Kernel::Total(total::Prepared::new(ratio, poisson_ratio, &linear())),
            Model::Linear => {
                let LinearCoefficients { c11, c22, c23, c33 } = linear();
                let stiffness = shear_modulus * a * b;
                let lever = stiffness * radius;
                let entries = [stiffness * c11, stiffness * c22, lever * c23, lever * radius * c33];
                Kernel::Linear(F::each(&entries, |entry| entry.min(F::LARGEST)))
            }
        };
        let frame = Frame { contact: *contact, radius, units: Units::of(contact) };
        Self { frame, options: *options, kernel }
    }

    /// Forces, and the spin parameter `ψ`.
    #[inline(always)]
    pub(crate) fn forces<T: Number<Base = F>>(&self, creepage: &Creepage<T>) -> (Forces<T>, T) {
        if let Kernel::Linear([x, y, coupling, z]) = self.kernel {
            // F_x = G a b C11 υx, F_y = G a b (C22 υy + √(ab) C23 φ), M_z = G (ab)^{3/2} (√(ab) C33 φ − C23 υy)
            let Creepage { longitudinal, lateral, spin } = *creepage;
            let forces = Forces {
                fx: longitudinal.scale(x),
                fy: lateral.scale(y) + spin.scale(coupling),
                mz: spin.scale(z) - lateral.scale(coupling),
                adhesion: T::one(),
            };
            return (forces, T::zero());
        }
        let parameters = self.frame.units.parameters(creepage);
        let bound = self.frame.contact.friction_bound();
        let Totals { fx, fy, mz, stick } = self.totals(&parameters);
        let forces = Forces {
            fx: fx.scale(bound),
            fy: fy.scale(bound),
            mz: mz.scale(bound * self.frame.radius),
            adhesion: stick,
        };
        (forces, parameters.psi)
    }

    /// Forces of a model with a friction bound, in units of it: `F/(μ N)`, `M_z/(μ N √(ab))`.
    #[inline(always)]
    pub(crate) fn totals<T: Number<Base = F>>(&self, parameters: &Parameters<T>) -> Totals<T> {
        match &self.kernel {
            Kernel::Strip1967(rule) => strip_1967::totals(parameters, *rule),
            Kernel::Strip(strips) => {
                F::strip_totals(strips, self.frame.units.normalised(parameters))
            }
            Kernel::Total(total) => total.totals(self.frame.units.normalised(parameters)),
            Kernel::Linear(_) => Totals::nothing(),
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
        Ok(Self::of(contact, options))
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
        Ok(self.answer(creepage, ordinary))
    }

    /// Of a loaded contact and a creepage that have been checked.
    #[inline(always)]
    pub(crate) fn answer(&self, creepage: &Creepage<F>, ordinary: bool) -> Solution<F> {
        let zero = F::zero();
        let Creepage { longitudinal, lateral, spin } = *creepage;
        if longitudinal == zero && lateral == zero && spin == zero {
            // no force, adhesion everywhere
            let adhesion = if self.options.model == Model::Total { -F::one() } else { F::one() };
            let none = Forces { fx: zero, fy: zero, mz: zero, adhesion };
            return self.solution(creepage, &none, zero, ordinary);
        }
        let (forces, psi) = self.forces(creepage);
        self.solution(creepage, &forces, psi, ordinary)
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
        let of_model = if self.options.model == Model::Linear {
            linear_notice(linear_size(fx, fy), bound)
        } else {
            notice(self.options.model, bound, self.frame.contact.a / self.frame.contact.b, psi)
        };
        let notice =
            if ordinary { of_model } else { warned(&self.frame.contact, creepage, of_model) };
        Solution { fx, fy, mz, power, adhesion, notice, reserved: 0 }
    }
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
