//! What every model needs of a contact, and how its answers become newtons.

use crate::contact::Contact;
use crate::contact::creepage::{Creepage, Units};
use crate::contact::forces::Totals;
use crate::contact::mismatch::Shift;
use crate::linear::LinearCoefficients;
use crate::number::{Arithmetic, Float, Pair, Plain};
use crate::solve::options::Model;

/// A contact in the units of the theory: numbers only.
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

    /// The creepage that pressure adds to the longitudinal one in unlike bodies; `None` for like bodies and in the theory of 1967.
    #[inline(always)]
    pub(crate) fn shift(&self, creepage: &Creepage<F>, model: Model) -> Option<Shift<F>>
    where
        F: Float,
    {
        let none = self.contact.mismatch == F::zero() || model.is_of_1967();
        (!none).then(|| match model {
            Model::Linear => Shift::linear(&self.contact),
            _ => Shift::new(&self.contact, &self.units, creepage),
        })
    }

    /// The creepage that the contact sees.
    #[inline(always)]
    pub(crate) fn seen(&self, creepage: &Creepage<F>, model: Model) -> Creepage<F>
    where
        F: Float,
    {
        self.shift(creepage, model).map_or(*creepage, |shift| shift.seen(creepage))
    }

    /// `a/b` and `ν`, and the coefficients for them.
    #[inline(always)]
    pub(crate) fn shape(&self) -> (F, F, LinearCoefficients<F>) {
        let (ratio, poisson_ratio) = (self.units.axis_ratio, self.contact.poisson_ratio);
        (ratio, poisson_ratio, LinearCoefficients::at(ratio, poisson_ratio))
    }

    /// Forces in newtons from `F/(μ N)` and `M_z/(μ N √(ab))`.
    #[inline(always)]
    pub(crate) fn forces(&self, totals: Totals<F>) -> Forces<F> {
        let bound = self.contact.friction_bound();
        let Totals { fx, fy, mz, stick } = totals;
        Forces { fx: fx * bound, fy: fy * bound, mz: mz * (bound * self.radius), adhesion: stick }
    }
}

/// Forces in newtons, moment in newton metres, share in adhesion.
pub(crate) struct Forces<T> {
    pub(crate) fx: T,
    pub(crate) fy: T,
    pub(crate) mz: T,
    pub(crate) adhesion: T,
}
