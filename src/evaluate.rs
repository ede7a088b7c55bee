//! Only what a scene needs: what is not wanted is not computed.
//!
//! The moment and the stick area of [`Model::Strip`] cost extra work in every strip, which can be left out. The other models
//! have them for next to nothing.

use crate::contact::Contact;
use crate::creepage::{Creepage, Parameters};
use crate::model::{self, Forces, Model, Options, Precision, Problem, Solution};
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
/// use kstrip::{contact::Contact, creepage::Creepage, evaluate::{evaluate, Wanted}, model};
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
pub fn evaluate<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
    wanted: Wanted,
) -> Result<Solution<F>, Error> {
    let everything = wanted.moment && wanted.adhesion;
    let mut solution = if options.model == Model::Strip && !everything {
        strips(&Problem::new(contact, creepage, options)?, wanted)
    } else {
        model::solve(contact, creepage, options)?
    };
    leave_out(&mut solution, wanted);
    Ok(solution)
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

fn strips<F: Precision>(problem: &Problem<F>, wanted: Wanted) -> Solution<F> {
    if let Some(rest) = problem.at_rest() {
        return rest;
    }
    let contact = problem.contact;
    let parameters = Parameters::new(contact, problem.creepage);
    let totals = match (wanted.adhesion, wanted.moment) {
        (true, _) => problem.strip_totals::<true, false>(&parameters),
        (false, true) => problem.strip_totals::<false, true>(&parameters),
        (false, false) => problem.strip_totals::<false, false>(&parameters),
    };
    let bound = contact.friction_bound();
    let forces = Forces {
        fx: totals.fx * bound,
        fy: totals.fy * bound,
        mz: totals.mz * (bound * problem.mean_radius()),
        adhesion: totals.stick.max(F::zero()).min(F::one()),
    };
    problem.solution(&forces, problem.notice(parameters.psi))
}
