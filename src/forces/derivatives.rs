//! Derivatives with respect to everything that moves in a simulation: creepages, load and friction.
//!
//! Every model with a friction bound is homogeneous: with `M = μ N` at fixed `a`, `b`, `G`, `ν`,
//!
//! ```text
//! F(c, M) = M f(c/M)   ⇒   ∂F/∂M = f − (∂f/∂c) c      (Euler)
//! ```
//!
//! so the derivatives with respect to load and friction follow from those with respect to the
//! creepages `c = (υx, υy, φ)`, to rounding and without further dual numbers. Evaluated with `f`,
//! which is of size one, nothing is divided by `M`: without friction or load the result is the
//! limit of full sliding. The linear theory has no friction in it, and its derivatives with respect
//! to both are zero.
//!
//! **The load through Hertz.** In a contact of given curvatures `a` and `b` grow like `N^{1/3}` at
//! constant `a/b` (Section 2). In `f` creepages appear as `G a b υ/(μ N) ~ N^{−1/3}` and spin as
//! `G (ab)^{3/2} φ/(μ N) ~ N⁰`, so with `J_v` the part of the derivatives with respect to the
//! creepages
//!
//! ```text
//! dF/dN = (F − ⅓ J_v v)/N,   dM_z/dN = (4/3 M_z − ⅓ J_v v)/N,
//! ```
//!
//! also for the linear theory: no derivatives with respect to `a` and `b` are needed.
//!
//! **Dissimilar materials.** The creepage `Δ` that pressure adds depends on all inputs. With `w = c
//! + Δ(c, M, κ)` the derivatives with respect to `c` are `∂F/∂w (1 + ∂Δ/∂c)`. In units of `M`, `Δ`
//! is a function of `c/M` and `κ/μ` alone. Therefore the derivative with respect to load needs no
//! further term, and that with respect to friction is reduced by `κ ∂F/∂κ`. The power on the whole
//! slip, `P = F · w`, is homogeneous likewise.

use crate::contact::Contact;
use crate::contact::creepage::{Creepage, Parameters};
use crate::contact::totals::Totals;
use crate::forces::check::find_fault;
use crate::forces::options::{Options, Solution};
use crate::forces::theory::{Forces, ScaledContact, Theory, by_model};
use crate::number::{Dual, Float, Real, add, are_finite};
use crate::status::Error;
use nalgebra::Matrix3;

/// Derivatives of fx, fy, mz with respect to creepages, load and friction.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Derivatives<F> {
    /// With respect to longitudinal, lateral, spin, row by row \[N, N, N m per 1, 1, 1/m\]; at
    /// kinks of a model a one-sided value.
    pub jacobian: [[F; 3]; 3],
    /// With respect to the normal force at fixed a and b \[-, -, m\].
    pub normal_force: [F; 3],
    /// With respect to the normal force while a and b grow with its cube root, as in Hertz's theory
    /// \[-, -, m\].
    pub load_through_hertz: [F; 3],
    /// With respect to the coefficient of friction (of the law, if given) \[N, N, N m\].
    pub friction: [F; 3],
}

/// Forces and their exact derivatives with respect to creepages, load and friction.
///
/// The derivatives are those of the computed forces. Without load or friction the derivatives with
/// respect to them are one-sided: those of full sliding.
///
/// # Errors
/// Those of [`forces_of_contact`](crate::forces::forces_of_contact); [`Error::Overflow`] also
/// when a derivative does not fit the floating-point type.
///
/// # Example
/// A sliding wheel loses braking force in proportion to its load:
/// ```
/// use kstrip::contact::{Contact, creepage::Creepage};
/// use kstrip::forces::{Options, derivatives::forces_and_derivatives};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, friction: 0.3,
///     shear_modulus: 82e9, poisson_ratio: 0.28, mismatch: 0.0,
/// };
/// let sliding = Creepage { longitudinal: 0.1_f64, lateral: 0.0, spin: 0.0 };
/// let (_, derivatives) = forces_and_derivatives(&contact, &sliding, &Options::default())?;
/// assert!((derivatives.normal_force[0] - 0.3).abs() < 1e-9);
/// assert!((derivatives.friction[0] - 80e3).abs() < 1e-3);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn forces_and_derivatives<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, options: &Options,
) -> Result<(Solution<F>, Derivatives<F>), Error> {
    let (solution, slopes) = solve_with_slopes(contact, creepage, options)?;
    Ok((solution, slopes.derivatives))
}

/// [`forces_and_derivatives`] with the intermediate results that other derivatives use.
pub(crate) fn solve_with_slopes<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, options: &Options,
) -> Result<(Solution<F>, Slopes<F>), Error> {
    let ordinary = contact.is_ordinary(creepage);
    if !ordinary {
        find_fault(contact, creepage, options.model)?;
    }
    if contact.is_lost() {
        return Ok((Solution::default(), Slopes::default()));
    }
    let frame = &ScaledContact::new(contact);
    let (solution, slopes) = by_model!(
        options.model,
        F,
        differentiated(frame, creepage, options, ordinary),
        return Err(Error::ModelLeftOut)
    );
    Error::Overflow.unless(are_finite(&slopes.derivatives.entries()))?;
    Ok((solution, slopes))
}

/// Derivatives of the forces \[N, N, N m\] and of the power divided by rolling speed \[N\] with
/// respect to one quantity.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sensitivity<F> {
    pub forces: [F; 3],
    pub power: F,
}

impl<F: Float> Sensitivity<F> {
    /// That of forces and power which have factors.
    pub(crate) fn scaled(&self, of_forces: F, of_power: F) -> Self {
        Self { forces: scaled(self.forces, of_forces), power: self.power * of_power }
    }
}

/// Derivatives at a constant coefficient of friction, and the intermediate results for those
/// through friction and motion.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Slopes<F> {
    pub derivatives: Derivatives<F>,
    /// The creepage of the contact with that of the pressure, `w`.
    pub seen: Creepage<F>,
    /// Derivatives of the power divided by rolling speed with respect to the creepages \[N\].
    pub power_by_creepage: [F; 3],
    /// `κ ∂/∂κ`
    pub by_mismatch: Sensitivity<F>,
}

impl<F: Float> Slopes<F> {
    /// From the derivatives with respect to `w`, and the forces.
    fn through_shift(
        mut derivatives: Derivatives<F>, shift: Option<Dual<F, 4>>, seen: &Creepage<F>,
        force: [F; 3],
    ) -> Self {
        let none = Sensitivity { forces: [F::zero(); 3], power: F::zero() };
        let mut found =
            Self { derivatives, seen: *seen, power_by_creepage: force, by_mismatch: none };
        if let Some(Dual { gradient: [a, b, c, by_mismatch], .. }) = shift {
            let by_creepage = [a, b, c];
            // κ ∂F/∂κ = ∂F/∂υx κ ∂Δ/∂κ,   ∂F/∂c = ∂F/∂w + ∂F/∂υx ∂Δ/∂c
            let [fx, ..] = force;
            let forces = derivatives.jacobian.map(|[by_x, ..]| by_x * by_mismatch);
            let power = seen.power(forces) + fx * by_mismatch;
            found.by_mismatch = Sensitivity { forces, power };
            for row in &mut derivatives.jacobian {
                let [by_x, ..] = *row;
                for (entry, moves) in row.iter_mut().zip(by_creepage) {
                    *entry += by_x * moves;
                }
            }
            for (entry, moves) in found.power_by_creepage.iter_mut().zip(by_creepage) {
                *entry += fx * moves;
            }
            found.derivatives = derivatives;
        }
        // ∂P/∂c = F ∂w/∂c + (∂F/∂c)ᵀ w
        let columns = transposed(derivatives.jacobian);
        add(&mut found.power_by_creepage, columns.map(|column| seen.power(column)));
        found
    }
}

/// [`forces_and_derivatives`] with the derivatives with respect to the creepages as a matrix, row
/// by row: N, N, N m per 1, 1, 1/m.
///
/// # Errors
/// Those of [`forces_and_derivatives`].
pub fn solve_jacobian<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, options: &Options,
) -> Result<(Solution<F>, Matrix3<F>), Error> {
    let (solution, Derivatives { jacobian, .. }) =
        forces_and_derivatives(contact, creepage, options)?;
    // nalgebra's index order is by columns.
    Ok((solution, Matrix3::from(jacobian).transpose()))
}

fn differentiated<F: Float, M: Theory<F>>(
    frame: &ScaledContact<F>, creepage: &Creepage<F>, options: &Options, ordinary: bool,
) -> (Solution<F>, Slopes<F>) {
    let theory = M::of_contact(frame, options);
    differentiated_by(&theory, frame, creepage, ordinary, |seen| with_slopes(&theory, frame, seen))
}

/// The same by a theory, with the forces, `ψ` and the derivatives that `differentiate` computes for
/// a contact with load and friction.
#[inline(always)]
pub(crate) fn differentiated_by<F: Float, M: Theory<F>>(
    theory: &M, frame: &ScaledContact<F>, creepage: &Creepage<F>, ordinary: bool,
    differentiate: impl FnOnce(&Creepage<F>) -> (Forces<F>, F, Derivatives<F>),
) -> (Solution<F>, Slopes<F>) {
    let (seen, shift) = frame.creepage_with_pressure(creepage, M::MODEL);
    let bound = frame.contact.friction_bound();
    let (forces, psi, mut derivatives) = if theory.stiffness().is_none() && bound <= F::zero() {
        let (forces, psi) = theory.forces(frame, &seen);
        (forces, psi, without_friction(theory, frame, &seen))
    } else {
        differentiate(&seen)
    };
    let forces = Forces::at_rest(&seen, M::MODEL).unwrap_or(forces);
    let solution = frame.solution(M::MODEL, &seen, &forces, psi, ordinary);
    if let Some(shift) = shift {
        through_shift(&mut derivatives, &shift, creepage, &frame.contact);
    }
    (solution, Slopes::through_shift(derivatives, shift, &seen, solution.components()))
}

/// Adds the derivatives of the shift with respect to load and friction: in units of `M` it is a
/// function of `c/M` and `κ/μ`.
#[cold]
fn through_shift<F: Float>(
    derivatives: &mut Derivatives<F>, shift: &Dual<F, 4>, creepage: &Creepage<F>,
    contact: &Contact<F>,
) {
    let [by_x, by_y, by_spin, by_mismatch] = shift.gradient;
    let translation = by_x * creepage.longitudinal + by_y * creepage.lateral;
    // N ∂Δ/∂N = Δ − (∂Δ/∂c) c,  through Hertz ⅓ (Δ − (∂Δ/∂v) v),  μ ∂Δ/∂μ = N ∂Δ/∂N − κ ∂Δ/∂κ
    let along = translation + by_spin * creepage.spin;
    let [by_load, through_hertz] = by_size(shift.value, 1.0 / 3.0, along, translation);
    let by_friction = by_load - by_mismatch;
    let columns = [
        (&mut derivatives.normal_force, by_load, contact.normal_force),
        (&mut derivatives.load_through_hertz, through_hertz, contact.normal_force),
        (&mut derivatives.friction, by_friction, contact.friction),
    ];
    for (entries, moves, by) in columns {
        if by > F::zero() {
            add(entries, derivatives.jacobian.map(|[by_x, ..]| by_x * (moves / by)));
        }
    }
}

/// Forces of a contact with load and friction, `ψ`, and the derivatives of forces.
#[inline(always)]
pub(crate) fn with_slopes<F: Real, M: Theory<F>>(
    theory: &M, frame: &ScaledContact<F>, creepage: &Creepage<F>,
) -> (Forces<F>, F, Derivatives<F>) {
    match theory.stiffness() {
        Some(stiffness) => {
            let (forces, psi) = theory.forces(frame, creepage);
            let derivatives = linear_with_slopes(stiffness, frame, creepage, &forces);
            (forces, psi, derivatives)
        }
        None => saturating(theory, frame, creepage),
    }
}

/// Exponents of `N` with which forces and moment grow where the slip does not change.
pub(crate) const POWERS: [f64; 3] = [1.0, 1.0, 4.0 / 3.0];

/// `∂F/∂M = f − (∂f/∂c) c`, and `dF/dN/μ = p f − ⅓ (∂f/∂v) v` through Hertz, of a force `F = M f`
/// with an exponent `p`. The last two arguments are `(∂f/∂c) c` and `(∂f/∂v) v`.
#[inline(always)]
pub(crate) fn by_size<F: Real>(f: F, power: f64, along: F, translation: F) -> [F; 2] {
    [f - along, f.times(power) - translation.times(1.0 / 3.0)]
}

#[inline(always)]
fn saturating<F: Real, M: Theory<F>>(
    theory: &M, frame: &ScaledContact<F>, creepage: &Creepage<F>,
) -> (Forces<F>, F, Derivatives<F>) {
    let ScaledContact { contact, radius, units } = frame;
    let parameters = units.parameters(&creepage.inputs());
    let Totals { fx, fy, mz, stick } = theory.model_totals(frame, &parameters);
    let bound = contact.friction_bound();
    let [of_x, of_y, of_z, stick] = [fx.value, fy.value, mz.value, stick.value];
    let forces = frame.in_newtons(Totals { fx: of_x, fy: of_y, mz: of_z, stick });

    let Creepage { longitudinal, lateral, spin } = *creepage;
    let [by_x, by_y, by_z] = POWERS;
    let rows = [(fx, F::one(), by_x), (fy, F::one(), by_y), (mz, *radius, by_z)];
    let sizes = rows.map(|(f, unit, power)| {
        let [x, y, z] = f.gradient;
        let translation = x * longitudinal + y * lateral;
        by_size(f.value, power, translation + z * spin, translation).map(|slope| unit * slope)
    });
    let [euler, hertz] = [sizes.map(|[euler, _]| euler), sizes.map(|[_, hertz]| hertz)];
    let derivatives = Derivatives {
        jacobian: rows.map(|(f, unit, _)| f.gradient.map(|slope| slope * (bound * unit))),
        normal_force: scaled(euler, contact.friction),
        friction: scaled(euler, contact.normal_force),
        load_through_hertz: scaled(hertz, contact.friction),
    };
    (forces, parameters.psi.value, derivatives)
}

/// Without friction there is no force and no dependence on the creepage.
fn without_friction<F: Float, M: Theory<F>>(
    theory: &M, frame: &ScaledContact<F>, creepage: &Creepage<F>,
) -> Derivatives<F> {
    let ScaledContact { contact, radius, .. } = frame;
    let parameters = Parameters::sliding(contact, creepage);
    let Totals { fx, fy, mz, .. } = theory.model_totals(frame, &parameters);
    let limit = [fx, fy, mz * *radius];
    let mut hertz = limit;
    hertz.iter_mut().zip(POWERS).for_each(|(of, power)| *of = of.times(power));
    Derivatives {
        jacobian: [[F::zero(); 3]; 3],
        normal_force: scaled(limit, contact.friction),
        friction: scaled(limit, contact.normal_force),
        load_through_hertz: scaled(hertz, contact.friction),
    }
}

/// The linear theory: the derivatives are its coefficients.
#[inline(always)]
fn linear_with_slopes<F: Real>(
    [x, y, coupling, z]: &[F; 4], frame: &ScaledContact<F>, creepage: &Creepage<F>,
    forces: &Forces<F>,
) -> Derivatives<F> {
    let none = F::zero();
    let jacobian = [[*x, none, none], [none, *y, *coupling], [none, -*coupling, *z]];
    let mut hertz = [forces.fx, forces.fy, forces.mz];
    for ((force, power), [by_x, by_y, _]) in hertz.iter_mut().zip(POWERS).zip(jacobian) {
        let translation = by_x * creepage.longitudinal + by_y * creepage.lateral;
        let [_, through_hertz] = by_size(*force, power, none, translation);
        *force = through_hertz / frame.contact.normal_force;
    }
    let none = [none; 3];
    Derivatives { jacobian, normal_force: none, load_through_hertz: hertz, friction: none }
}

pub(crate) fn transposed<F>([[a, b, c], [d, e, f], [g, h, i]]: [[F; 3]; 3]) -> [[F; 3]; 3] {
    [[a, d, g], [b, e, h], [c, f, i]]
}

#[inline]
pub(crate) fn scaled<F: Real>(vector: [F; 3], factor: F) -> [F; 3] {
    vector.map(|entry| entry * factor)
}

impl<F: Float> Derivatives<F> {
    /// All derivatives in one array, whose test for infinite numbers takes vectors.
    pub(crate) fn entries(&self) -> [F; 18] {
        let Self { jacobian: [[a, b, c], [d, e, f], [g, h, i]], .. } = *self;
        let Self { normal_force, load_through_hertz, friction, .. } = *self;
        let [[j, k, l], [m, n, o], [p, q, r]] = [normal_force, load_through_hertz, friction];
        [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r]
    }
}
