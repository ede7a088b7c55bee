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
use crate::number::Float;
use crate::solve::model::{self, Forces, Jacobian, Model, Options, Precision, Problem, Solution};
use crate::status::Error;
use nalgebra::{Matrix3, Vector3};

/// Derivatives of `(F_x, F_y, M_z)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derivatives<F: Float> {
    /// With respect to `(υx, υy, φ)`, row by row: N, N, N m over 1, 1, 1/m.
    pub jacobian: Jacobian<F>,
    /// With respect to the normal force `N` at fixed `a`, `b`: –, –, m.
    pub normal_force: Vector3<F>,
    /// With respect to the coefficient of friction `μ`: N, N, N m.
    pub friction: Vector3<F>,
    /// With respect to the normal force while `a` and `b` follow it as Hertz says, like `N^{1/3}`: –, –, m.
    /// Zero without load for [`Model::Linear`], where it has no bound.
    pub load_through_hertz: Vector3<F>,
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
/// assert!((derivatives.normal_force.x - 0.3).abs() < 1e-9);
/// assert!((derivatives.friction.x - 80e3).abs() < 1e-3);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn solve<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
) -> Result<(Solution<F>, Derivatives<F>), Error> {
    let problem = Problem::new(contact, creepage, options)?;
    let (solution, derivatives) = if options.model == Model::Linear {
        linear(contact, creepage, options)?
    } else if contact.friction_bound() > F::zero() {
        saturating(&problem)
    } else {
        sliding(&problem)
    };
    let Derivatives { jacobian, normal_force, friction, load_through_hertz } = &derivatives;
    let entries = jacobian.iter().chain(normal_force).chain(friction).chain(load_through_hertz);
    if entries.copied().all(F::is_finite_number) {
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
        // nalgebra counts columns first.
        jacobian: Matrix3::from(jacobian).transpose(),
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
        jacobian: Matrix3::from([[F::zero(); 3]; 3]),
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
    let mut hertz = Vector3::from([F::zero(); 3]);
    if load > F::zero() {
        let rows = hertz.iter_mut().zip(forces).zip(jacobian.row_iter());
        for ((derivative, (force, power)), row) in rows {
            // (power F − ⅓ J_v v)/N
            let [x, y] = [row[0] * creepage.longitudinal, row[1] * creepage.lateral];
            *derivative = (power * force - (x + y).times(1.0 / 3.0)) / load;
        }
    }
    let none = Vector3::from([F::zero(); 3]);
    let derivatives =
        Derivatives { jacobian, normal_force: none, friction: none, load_through_hertz: hertz };
    Ok((solution, derivatives))
}

fn scaled<F: Float>(vector: [F; 3], factor: F) -> Vector3<F> {
    Vector3::from(vector.map(|entry| entry * factor))
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
