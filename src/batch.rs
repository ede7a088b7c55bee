//! Many contacts at once.

use crate::contact::Contact;
use crate::creepage::Creepage;
use crate::evaluate::{Wanted, evaluate};
use crate::model::{self, Options, Precision, Solution};
use crate::status::{Error, Notice};

/// Forces of many contacts: `take` is handed what [`model::solve`] gives for each of them, in their order and
/// bit for bit. Returns the notice with the largest code.
///
/// All inputs are checked before anything is handed out: with an error nothing is.
///
/// # Errors
/// Those of [`model::solve`], of the first bad input.
pub fn solve_batch<F: Precision>(
    problems: impl Iterator<Item = (Contact<F>, Creepage<F>)> + Clone,
    options: &Options,
    take: impl FnMut(Solution<F>),
) -> Result<Notice, Error> {
    evaluate_batch(problems, options, Wanted { moment: true, adhesion: true }, take)
}

/// [`solve_batch`] without what is not wanted, as [`evaluate`] leaves it out.
///
/// # Errors
/// Those of [`solve_batch`].
pub fn evaluate_batch<F: Precision>(
    problems: impl Iterator<Item = (Contact<F>, Creepage<F>)> + Clone,
    options: &Options,
    wanted: Wanted,
    mut take: impl FnMut(Solution<F>),
) -> Result<Notice, Error> {
    for (contact, creepage) in problems.clone() {
        model::check(&contact, &creepage, options)?;
    }
    let mut worst = Notice::None;
    for (contact, creepage) in problems {
        let solution = evaluate(&contact, &creepage, options, wanted)?;
        if solution.notice.code() > worst.code() {
            worst = solution.notice;
        }
        take(solution);
    }
    Ok(worst)
}
