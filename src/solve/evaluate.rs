//! Only what a scene needs: what is not wanted is not computed.
//!
//! Moment and stick area cost extra work in every strip, and TOTAL's moment two outputs of its network; what is not wanted is left
//! out. [`Model::Linear`] has them for next to nothing.
//!
//! Special motions take shorter paths by themselves where these give the same answer to rounding: rest, motion without spin or
//! without longitudinal creepage of [`Model::Strip`] (half of the strips), pure sliding of the theory of 1967. One more is known and left
//! out: for pure creepage the theory of 1967 has the closed form (8.15). The quadrature over strips, which it would stand in for, is within
//! 7e-13 `μ N` of it with 64 strips, but only within 3e-5 with 16 and 9e-4 with 8: there the force would jump at vanishing spin.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::solve::model::{self, Jacobian, Model, Options, Precision, Problem, Solution};
use crate::status::Error;

/// What is wanted besides the forces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wanted {
    /// The moment, and the power, which contains it.
    pub moment: bool,
    /// The share of the contact area in adhesion.
    pub adhesion: bool,
}

/// [`solve`](model::solve) without what is not wanted: moment and power are then 0, adhesion −1.
///
/// What is wanted is the same to the bit as that of [`solve`](model::solve).
///
/// # Errors
/// Those of [`solve`](model::solve).
///
/// # Example
/// ```
/// use kstrip::{contact::Contact, contact::creepage::Creepage, solve::evaluate::{evaluate, Wanted}, solve::model};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, shear_modulus: 82e9, poisson_ratio: 0.28, friction: 0.3,
/// };
/// let creepage = Creepage { longitudinal: 1e-3, lateral: 0.0, spin: 0.2 };
/// let options = model::Options::default();
/// let forces = evaluate(&contact, &creepage, &options, Wanted::default())?;
/// assert_eq!(forces.fx, model::solve(&contact, &creepage, &options)?.fx);
/// assert_eq!((forces.mz, forces.adhesion), (0.0, -1.0));
/// # Ok::<(), kstrip::status::Error>(())
/// ```
#[cfg_attr(target_os = "none", inline(always))]
pub fn evaluate<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
    wanted: Wanted,
) -> Result<Solution<F>, Error> {
    evaluate_inline(contact, creepage, options, wanted)
}

/// [`evaluate`] in the caller's own code, as [`model::solve_inline`].
#[inline(always)]
pub(crate) fn evaluate_inline<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
    wanted: Wanted,
) -> Result<Solution<F>, Error> {
    let mut solution = if options.model == Model::Linear || (wanted.moment && wanted.adhesion) {
        model::solve(contact, creepage, options)?
    } else {
        some(&Problem::new(contact, creepage, options)?, wanted)
    };
    leave_out(&mut solution, wanted);
    Ok(solution)
}

/// [`solve_jacobian`](model::solve_jacobian) without what is not wanted, as [`evaluate`] leaves it out. The derivatives are all there.
///
/// # Errors
/// Those of [`solve_jacobian`](model::solve_jacobian).
pub fn evaluate_jacobian<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
    wanted: Wanted,
) -> Result<(Solution<F>, Jacobian<F>), Error> {
    let (mut solution, jacobian) = if options.model == Model::Strip && !wanted.adhesion {
        model::jacobian_without_stick(contact, creepage, options)?
    } else {
        model::solve_jacobian(contact, creepage, options)?
    };
    leave_out(&mut solution, wanted);
    Ok((solution, jacobian))
}

/// What is not wanted, as it is reported: moment and power 0, adhesion −1.
pub fn leave_out<F: Precision>(solution: &mut Solution<F>, wanted: Wanted) {
    if !wanted.moment {
        (solution.mz, solution.power) = (F::zero(), F::zero());
    }
    if !wanted.adhesion {
        solution.adhesion = -F::one();
    }
}

/// (On a microcontroller its stack is free where all is wanted.)
#[cfg_attr(target_os = "none", inline(never))]
#[cfg_attr(not(target_os = "none"), inline(always))]
fn some<F: Precision>(problem: &Problem<F>, wanted: Wanted) -> Solution<F> {
    if let Some(rest) = problem.at_rest() {
        return rest;
    }
    let creepage = problem.creepage;
    let (forces, notice) = match (wanted.adhesion, wanted.moment) {
        (true, _) => problem.saturating_forces::<F, true, false>(creepage),
        (false, true) => problem.saturating_forces::<F, false, true>(creepage),
        (false, false) => problem.saturating_forces::<F, false, false>(creepage),
    };
    problem.solution(&forces, notice)
}
