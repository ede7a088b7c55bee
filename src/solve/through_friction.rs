//! Derivatives through friction that falls with the slip.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::friction::{self, SlipFriction};
use crate::number::Float;
use crate::solve::derivatives::{Derivatives, solve};
use crate::solve::model;
use crate::solve::options::{Model, Options, Precision, Solution};
use crate::status::{Error, Notice};

/// Derivatives of fx, fy, mz by the parameters of falling friction.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LawDerivatives<F> {
    /// By the ratio \[N, N, N m\].
    pub ratio: [F; 3],
    /// By the decay \[N, N, N m over s/m\].
    pub decay: [F; 3],
    /// By the rolling speed of the law at constant creepages \[N, N, N m over m/s\].
    pub rolling_speed: [F; 3],
    /// By the factor of the initial slope, at 1 without a law \[N, N, N m\].
    pub slope_factor: [F; 3],
}

impl<F: Float> LawDerivatives<F> {
    /// Those of a contact that carries nothing.
    #[must_use]
    pub fn nothing() -> Self {
        let none = [F::zero(); 3];
        Self { ratio: none, decay: none, rolling_speed: none, slope_factor: none }
    }
}

/// Forces at the friction of a law, and their derivatives while friction stays.
pub(crate) struct AtFriction<F: Float> {
    /// `(F_x, F_y, M_z)` at friction `μ`
    pub force: [F; 3],
    /// Derivatives at constant `μ`
    pub derivatives: Derivatives<F>,
    /// `(υx, υy, φ)`
    pub motion: [F; 3],
    /// `μ`
    pub friction: F,
    /// `N`
    pub load: F,
}

impl<F: Float> AtFriction<F> {
    /// The derivatives through `μ = g(s)`, `s = P/(μ N)`, by the implicit function theorem:
    ///
    /// ```text
    /// dF/dp = ∂F/∂p + ∂F/∂μ dμ/dp,   dμ/dp = (∂g/∂p + g' ∂s/∂p)/(1 − g' ∂s/∂μ)
    /// ```
    pub(crate) fn through(
        &self,
        law: &SlipFriction<F>,
        falls: bool,
    ) -> (Derivatives<F>, LawDerivatives<F>) {
        let Self { force, derivatives, motion, friction, load } = self;
        let along = |by: &[F; 3]| by[0] * motion[0] + by[1] * motion[1] + by[2] * motion[2];
        let by_friction = derivatives.friction;
        let bound = *friction * *load;
        // s = P/(μ N), in the limit of full sliding (∂P/∂μ)/N
        let carries = bound > F::zero();
        let power = along(force);
        let slip = if carries { power / bound } else { along(&by_friction) / *load };
        // (what rounding leaves of a power of zero may be below zero, and is no slip)
        let slip = slip.max(F::zero());
        let by = law.slopes(slip);
        let moves = falls && slip > F::zero() && carries;
        let rate = if moves { by.slip } else { F::zero() };
        let over_bound = |power: F| if carries { power / bound } else { F::zero() };
        // ∂s/∂μ = (∂P/∂μ)/(μ N) − s/μ
        let slip_by_friction =
            over_bound(along(&by_friction)) - if carries { slip / *friction } else { F::zero() };
        let feedback = F::one() / (F::one() - rate * slip_by_friction);
        let shifted = |fixed: &[F; 3], friction_by: F| {
            let change = friction_by * feedback;
            let mut total = *fixed;
            for (entry, by_friction) in total.iter_mut().zip(by_friction) {
                *entry += by_friction * change;
            }
            total
        };
        let [row_x, row_y, row_z] = derivatives.jacobian;
        let mut jacobian = derivatives.jacobian;
        let columns: [[F; 3]; 3] = core::array::from_fn(|j| {
            [&row_x, &row_y, &row_z].map(|row| row.get(j).copied().unwrap_or(F::zero()))
        });
        for (j, (column, force)) in columns.iter().zip(force).enumerate() {
            // μ N ∂s/∂c = F + Jᵀ c
            let total = shifted(column, rate * over_bound(*force + along(column)));
            for (row, entry) in jacobian.iter_mut().zip(total) {
                if let Some(place) = row.get_mut(j) {
                    *place = entry;
                }
            }
        }
        // ∂s/∂N = (∂P/∂N)/(μ N) − s/N
        let by_load = |fixed: &[F; 3]| {
            let slip_by_load = over_bound(along(fixed)) - slip / *load;
            shifted(fixed, rate * slip_by_load)
        };
        // F = M f(k c/M):  k ∂F/∂k = J c
        let stiffness = law.stiffness();
        let by_stiffness = [row_x, row_y, row_z].map(|row| along(&row) / stiffness);
        let none = [F::zero(); 3];
        let through = Derivatives {
            jacobian,
            normal_force: by_load(&derivatives.normal_force),
            load_through_hertz: by_load(&derivatives.load_through_hertz),
            friction: shifted(&none, by.friction),
        };
        let law = LawDerivatives {
            ratio: shifted(&none, by.ratio),
            decay: shifted(&none, by.decay),
            rolling_speed: shifted(&none, by.rolling_speed),
            slope_factor: shifted(&by_stiffness, rate * over_bound(along(&by_stiffness))),
        };
        (through, law)
    }
}

/// What [`differentiate`] answers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Differentiated<F: Float> {
    /// The forces.
    pub solution: Solution<F>,
    /// The coefficient of friction that agrees with the slip.
    pub friction: F,
    /// Derivatives by creepages, load, friction.
    pub derivatives: Derivatives<F>,
    /// Derivatives by the parameters of the law.
    pub law: LawDerivatives<F>,
}

/// Forces and all derivatives, under friction that falls with the slip or not.
///
/// # Errors
/// Those of [`solve`] and [`SlipFriction::check`].
pub fn differentiate<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    law: Option<&SlipFriction<F>>,
    options: &Options,
) -> Result<Differentiated<F>, Error> {
    let (contact, notice) = match law {
        Some(law) => friction::under(contact, creepage, law, options)?,
        None => (*contact, Notice::None),
    };
    let (mut solution, derivatives) = solve(&contact, creepage, options)?;
    solution.notice = solution.notice.worse(notice);
    let friction = contact.friction;
    let lost = contact.is_lost();
    let Some(law) = law.filter(|_| !lost) else {
        // F = M f(k c/M) at k = 1
        let along = |[x, y, z]: [F; 3]| {
            x * creepage.longitudinal + y * creepage.lateral + z * creepage.spin
        };
        let slope_factor = derivatives.jacobian.map(along);
        let law = LawDerivatives { slope_factor, ..LawDerivatives::nothing() };
        return if slope_factor.into_iter().all(F::is_finite_number) {
            Ok(Differentiated { solution, friction, derivatives, law })
        } else {
            Err(Error::Overflow)
        };
    };
    let at = AtFriction {
        force: [solution.fx, solution.fy, solution.mz],
        derivatives,
        motion: [creepage.longitudinal, creepage.lateral, creepage.spin],
        friction,
        load: contact.normal_force,
    };
    let falls = law.falls() && options.model != Model::Linear;
    let (derivatives, law) = at.through(law, falls);
    let entries = derivatives.entries().into_iter().chain(law.entries());
    if entries.into_iter().all(F::is_finite_number) {
        Ok(Differentiated { solution, friction, derivatives, law })
    } else {
        Err(Error::Overflow)
    }
}

/// Checks the inputs of [`differentiate`], without solving but where sizes are so unusual that a derivative might not fit.
///
/// # Errors
/// Those of [`differentiate`].
pub(crate) fn check<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    law: Option<&SlipFriction<F>>,
    options: &Options,
) -> Result<(), Error> {
    let (friction, steepness) = match law {
        Some(law) => {
            friction::check(contact, creepage, law, options)?;
            law.least(contact, creepage)
        }
        None => {
            model::check(contact, creepage, options)?;
            (contact.friction, F::zero())
        }
    };
    // Slopes are those of linear theory, over the bound at most so many, and grow tenfold through friction.
    let fit = contact.is_ordinary(creepage)
        && contact.stiffness() <= Contact { friction, ..*contact }.friction_bound().times(1e6)
        && steepness < F::constant(0.9);
    if fit || contact.is_lost() {
        return Ok(());
    }
    differentiate(contact, creepage, law, options).map(|_| ())
}

impl<F: Float> LawDerivatives<F> {
    /// All numbers.
    pub(crate) fn entries(&self) -> [F; 12] {
        let Self { ratio, decay, rolling_speed, slope_factor } = *self;
        let [[a, b, c], [d, e, f], [g, h, i], [j, k, l]] =
            [ratio, decay, rolling_speed, slope_factor];
        [a, b, c, d, e, f, g, h, i, j, k, l]
    }
}
