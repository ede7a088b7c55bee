//! Derivatives with respect to everything that moves in a simulation: creepages, load and friction.
//!
//! Every model with a friction bound is homogeneous: with `M = μ N` at fixed `a`, `b`, `G`, `ν`,
//!
//! ```text
//! F(c, M) = M f(c/M)   ⇒   ∂F/∂M = f − (∂f/∂c) c      (Euler)
//! ```
//!
//! so the derivatives with respect to load and friction follow from those with respect to the creepages
//! `c = (υx, υy, φ)`, to rounding and without further dual numbers. Evaluated with `f`, which is of size
//! one, nothing is divided by `M`: without friction or load the limit of full sliding comes out.
//! The linear theory has no friction in it, and its derivatives with respect to both are zero.
//!
//! **The load through Hertz.** In a contact of given curvatures `a` and `b` grow like `N^{1/3}` at constant `a/b`
//! (Section 2). In `f` creepages appear as `G a b υ/(μ N) ~ N^{−1/3}` and spin as
//! `G (ab)^{3/2} φ/(μ N) ~ N⁰`, so with `J_v` the part of the derivatives that belongs to the creepages
//!
//! ```text
//! dF/dN = (F − ⅓ J_v v)/N,   dM_z/dN = (4/3 M_z − ⅓ J_v v)/N,
//! ```
//!
//! also for the linear theory: no derivatives with respect to `a` and `b` are needed.

use crate::contact::Contact;
use crate::contact::creepage::{Creepage, Parameters};
use crate::contact::forces::Totals;
use crate::friction::{self, SlipFriction};
use crate::number::Float;
use crate::solve::model::{self, Forces, Model, Options, Precision, Problem, Solution};
use crate::status::{Error, Notice};

/// Derivatives of fx, fy, mz by creepages, load and friction.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derivatives<F> {
    /// By longitudinal, lateral, spin, row by row \[N, N, N m over 1, 1, 1/m\]; at kinks of a model a one-sided value.
    pub jacobian: [[F; 3]; 3],
    /// By the normal force at fixed a and b \[-, -, m\].
    pub normal_force: [F; 3],
    /// By the normal force while a and b follow it as Hertz says: both grow like its cube root \[-, -, m\].
    pub load_through_hertz: [F; 3],
    /// By the coefficient of friction, that of the law where there is one \[N, N, N m\].
    pub friction: [F; 3],
}

impl<F: Float> Derivatives<F> {
    /// Those of a contact that carries nothing.
    #[must_use]
    pub fn nothing() -> Self {
        let none = [F::zero(); 3];
        Self { jacobian: [none; 3], normal_force: none, load_through_hertz: none, friction: none }
    }
}

/// Forces and their exact derivatives with respect to creepages, load and friction.
///
/// The derivatives are those of the computed forces. Without load or friction the derivatives with
/// respect to them are one-sided: those of full sliding.
///
/// # Errors
/// Those of [`solve`](model::solve); [`Error::Overflow`] also when a derivative does not fit the
/// floating-point type.
///
/// # Example
/// A sliding wheel loses braking force in proportion to its load:
/// ```
/// use kstrip::{contact::Contact, contact::creepage::Creepage, solve::derivatives::solve, solve::model::Options};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, shear_modulus: 82e9, poisson_ratio: 0.28, friction: 0.3,
/// };
/// let sliding = Creepage { longitudinal: 0.1_f64, lateral: 0.0, spin: 0.0 };
/// let (_, derivatives) = solve(&contact, &sliding, &Options::default())?;
/// assert!((derivatives.normal_force[0] - 0.3).abs() < 1e-9);
/// assert!((derivatives.friction[0] - 80e3).abs() < 1e-3);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn solve<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
) -> Result<(Solution<F>, Derivatives<F>), Error> {
    let problem = Problem::new(contact, creepage, options)?;
    if contact.is_lost() {
        return Ok((Solution::nothing(), Derivatives::nothing()));
    }
    let (solution, derivatives) = if options.model == Model::Linear {
        linear(contact, creepage, options)?
    } else if contact.friction_bound() > F::zero() {
        saturating(&problem)
    } else {
        sliding(&problem)
    };
    if derivatives.entries().into_iter().all(F::is_finite_number) {
        Ok((solution, derivatives))
    } else {
        Err(Error::Overflow)
    }
}

fn saturating<F: Precision>(problem: &Problem<F>) -> (Solution<F>, Derivatives<F>) {
    let Problem { contact, creepage, .. } = *problem;
    let parameters = Parameters::new(contact, &creepage.inputs());
    let Totals { fx, fy, mz, stick } = problem.totals(&parameters);
    let (bound, radius) = (contact.friction_bound(), problem.mean_radius());
    let forces = Forces {
        fx: fx.value * bound,
        fy: fy.value * bound,
        mz: mz.value * (bound * radius),
        adhesion: stick.value,
    };
    let solution = problem.solution(&forces, problem.notice(parameters.psi.value));

    let Creepage { longitudinal, lateral, spin } = *creepage;
    let rows =
        [(fx, F::one(), F::one()), (fy, F::one(), F::one()), (mz, radius, F::constant(4.0 / 3.0))];
    let translation = |g: &[F; 3]| g[0] * longitudinal + g[1] * lateral;
    // f − (∂f/∂c) c
    let euler = rows
        .map(|(f, unit, _)| unit * (f.value - (translation(&f.gradient) + f.gradient[2] * spin)));
    // F: f − ⅓ (∂f/∂v) v,  M_z: (4/3) f − ⅓ (∂f/∂v) v
    let hertz = rows.map(|(f, unit, power)| {
        unit * (power * f.value - translation(&f.gradient).times(1.0 / 3.0))
    });
    let jacobian = rows.map(|(f, unit, _)| f.gradient.map(|slope| slope * (bound * unit)));
    let derivatives = Derivatives {
        jacobian,
        normal_force: scaled(euler, contact.friction),
        friction: scaled(euler, contact.normal_force),
        load_through_hertz: scaled(hertz, contact.friction),
    };
    (solution, derivatives)
}

/// No friction or no load: no force, and no dependence on the creepage until there is some.
fn sliding<F: Precision>(problem: &Problem<F>) -> (Solution<F>, Derivatives<F>) {
    let Problem { contact, creepage, .. } = *problem;
    let parameters = Parameters::new(contact, creepage);
    let Totals { stick, .. } = problem.totals(&parameters);
    let none = Forces { fx: F::zero(), fy: F::zero(), mz: F::zero(), adhesion: stick };
    let solution = problem.solution(&none, problem.notice(parameters.psi));
    let radius = problem.mean_radius();
    let Totals { fx, fy, mz, .. } = problem.totals(&Parameters::sliding(contact, creepage));
    let limit = [fx, fy, mz * radius];
    let hertz = [fx, fy, mz * radius.times(4.0 / 3.0)];
    let derivatives = Derivatives {
        jacobian: [[F::zero(); 3]; 3],
        normal_force: scaled(limit, contact.friction),
        friction: scaled(limit, contact.normal_force),
        load_through_hertz: scaled(hertz, contact.friction),
    };
    (solution, derivatives)
}

fn linear<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
) -> Result<(Solution<F>, Derivatives<F>), Error> {
    let (solution, jacobian) = model::solve_jacobian(contact, creepage, options)?;
    let Solution { fx, fy, mz, .. } = solution;
    let load = contact.normal_force;
    let forces = [(fx, F::one()), (fy, F::one()), (mz, F::constant(4.0 / 3.0))];
    let mut hertz = [F::zero(); 3];
    if load > F::zero() {
        let rows = hertz.iter_mut().zip(forces).zip(jacobian.row_iter());
        for ((derivative, (force, power)), row) in rows {
            // (power F − ⅓ J_v v)/N
            let [x, y] = [row[0] * creepage.longitudinal, row[1] * creepage.lateral];
            *derivative = (power * force - (x + y).times(1.0 / 3.0)) / load;
        }
    }
    let none = [F::zero(); 3];
    let j = jacobian;
    let jacobian = [[j.m11, j.m12, j.m13], [j.m21, j.m22, j.m23], [j.m31, j.m32, j.m33]];
    let derivatives =
        Derivatives { jacobian, normal_force: none, friction: none, load_through_hertz: hertz };
    Ok((solution, derivatives))
}

fn scaled<F: Float>(vector: [F; 3], factor: F) -> [F; 3] {
    vector.map(|entry| entry * factor)
}

/// Check the inputs of [`model::solve_jacobian`]: what it would answer, mostly without solving.
///
/// # Errors
/// Those of [`model::solve_jacobian`].
pub fn check_jacobian<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
) -> Result<(), Error> {
    model::check(contact, creepage, options)?;
    let Contact { a, b, normal_force, shear_modulus, friction, .. } = *contact;
    let within = |x: F, low: f64, high: f64| x >= F::constant(low) && x <= F::constant(high);
    let nothing_or = |x: F, low: f64, high: f64| x == F::zero() || within(x.abs(), low, high);
    let Parameters { xi, eta, psi, .. } = Parameters::new(contact, creepage);
    let Creepage { longitudinal, lateral, spin } = *creepage;
    // No derivative of such a contact exceeds G a b (a + b + 1)² times 1e6, and no square on the way to it vanishes, in
    // single precision either.
    let ordinary = within(a, 1e-6, 1.0)
        && within(b, 1e-6, 1.0)
        && within(a / b, 1e-2, 1e2)
        && within(shear_modulus, 1.0, 1e15)
        && within(normal_force, 1e-3, 1e9)
        && within(friction, 1e-3, 1e2)
        && within(contact.stiffness_ratio(), 1e-6, 1e6)
        && [xi, eta, psi].iter().all(|parameter| nothing_or(*parameter, 1e-9, 1e3))
        && [longitudinal, lateral, spin].iter().all(|part| nothing_or(*part, 1e-12, 1e9));
    if ordinary { Ok(()) } else { model::solve_jacobian(contact, creepage, options).map(|_| ()) }
}

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
        // (a power below zero, as the theory of 1967 has it in some contacts that spin, is no slip)
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
    if contact.is_lost() {
        let law = LawDerivatives::nothing();
        return Ok(Differentiated { solution, friction, derivatives, law });
    }
    let at = AtFriction {
        force: [solution.fx, solution.fy, solution.mz],
        derivatives,
        motion: [creepage.longitudinal, creepage.lateral, creepage.spin],
        friction,
        load: contact.normal_force,
    };
    let constant = SlipFriction::constant(friction);
    let law = law.unwrap_or(&constant);
    let falls = law.falls() && options.model != Model::Linear;
    let (derivatives, law) = at.through(law, falls);
    let entries = derivatives.entries().into_iter().chain(law.entries());
    if entries.into_iter().all(F::is_finite_number) {
        Ok(Differentiated { solution, friction, derivatives, law })
    } else {
        Err(Error::Overflow)
    }
}

impl<F: Float> Derivatives<F> {
    /// All numbers.
    pub(crate) fn entries(&self) -> [F; 18] {
        let Self { jacobian: [[a, b, c], [d, e, f], [g, h, i]], .. } = *self;
        let Self { normal_force, load_through_hertz, friction, .. } = *self;
        let [[j, k, l], [m, n, o], [p, q, r]] = [normal_force, load_through_hertz, friction];
        [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r]
    }
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
