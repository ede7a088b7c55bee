//! Many contacts at once.

#[cfg(target_arch = "x86_64")]
pub(crate) mod side_by_side;

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::number::Float;
use crate::solve::evaluate::{Wanted, evaluate};
use crate::solve::model::{self, Options, Precision, Solution};
use crate::status::{Error, Notice};

/// Contacts with their creepages, wherever they are stored.
pub trait Problems<F: Float> {
    /// How many.
    fn count(&self) -> usize;

    /// One of them; `None` from the count on.
    fn get(&self, i: usize) -> Option<(Contact<F>, Creepage<F>)>;

    /// `N` of them from `first` on, one array for each quantity, in the order of the structures' fields; `None` when
    /// there are fewer.
    #[inline(always)]
    fn side_by_side<const N: usize>(&self, first: usize) -> Option<[[F; N]; 9]> {
        let mut quantities = [[F::zero(); N]; 9];
        for lane in 0..N {
            let (contact, creepage) = self.get(first + lane)?;
            let Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction } = contact;
            let Creepage { longitudinal, lateral, spin } = creepage;
            let contact = [a, b, normal_force, shear_modulus, poisson_ratio, friction];
            let values = contact.into_iter().chain([longitudinal, lateral, spin]);
            for (quantity, value) in quantities.iter_mut().zip(values) {
                if let Some(place) = quantity.get_mut(lane) {
                    *place = value;
                }
            }
        }
        Some(quantities)
    }
}

/// Where solutions go, wherever that is.
pub trait Solutions<F: Float> {
    /// The solution of problem `i`.
    fn put(&mut self, i: usize, solution: Solution<F>);

    /// Those of `N` problems from `first` on: `fx, fy, mz, power, adhesion`, one array for each.
    #[inline(always)]
    fn put_side_by_side<const N: usize>(
        &mut self,
        first: usize,
        quantities: &[[F; N]; 5],
        notices: &[Notice; N],
    ) {
        let [fx, fy, mz, power, adhesion] = quantities;
        let forces = fx.iter().zip(fy).zip(mz);
        let rest = power.iter().zip(adhesion).zip(notices);
        for (lane, (((&fx, &fy), &mz), ((&power, &adhesion), &notice))) in
            forces.zip(rest).enumerate()
        {
            self.put(first + lane, Solution { fx, fy, mz, power, adhesion, notice, reserved: 0 });
        }
    }
}

/// Forces of many contacts: what [`model::solve`] gives for each of them, bit for bit. Returns the notice with the
/// largest code.
///
/// Where the processor has registers for several numbers, several contacts are solved side by side.
///
/// All inputs are checked before anything is handed out: with an error nothing is.
///
/// # Errors
/// Those of [`model::solve`], of the first bad input.
pub fn solve_batch<F: Precision>(
    problems: &impl Problems<F>,
    options: &Options,
    solutions: &mut impl Solutions<F>,
) -> Result<Notice, Error> {
    evaluate_batch(problems, options, Wanted { moment: true, adhesion: true }, solutions)
}

/// [`solve_batch`] without what is not wanted, as [`evaluate`] leaves it out.
///
/// # Errors
/// Those of [`solve_batch`].
pub fn evaluate_batch<F: Precision>(
    problems: &impl Problems<F>,
    options: &Options,
    wanted: Wanted,
    solutions: &mut impl Solutions<F>,
) -> Result<Notice, Error> {
    #[cfg(target_arch = "x86_64")]
    if crate::batch::side_by_side::pays(options.model, problems.count()) {
        return F::evaluate_wide(problems, options, wanted, solutions);
    }
    for i in 0..problems.count() {
        check_one(problems, i, options)?;
    }
    let mut worst = Notice::None;
    for i in 0..problems.count() {
        worst = worst.worse(evaluate_one(problems, i, options, wanted, solutions)?);
    }
    Ok(worst)
}

/// # Errors
/// Those of problem `i`.
#[inline(always)]
pub(crate) fn check_one<F: Precision>(
    problems: &impl Problems<F>,
    i: usize,
    options: &Options,
) -> Result<(), Error> {
    match problems.get(i) {
        Some((contact, creepage)) => model::check(&contact, &creepage, options),
        None => Ok(()),
    }
}

/// Problem `i`.
#[inline(always)]
pub(crate) fn evaluate_one<F: Precision>(
    problems: &impl Problems<F>,
    i: usize,
    options: &Options,
    wanted: Wanted,
    solutions: &mut impl Solutions<F>,
) -> Result<Notice, Error> {
    let Some((contact, creepage)) = problems.get(i) else {
        return Ok(Notice::None);
    };
    let solution = evaluate(&contact, &creepage, options, wanted)?;
    let notice = solution.notice;
    solutions.put(i, solution);
    Ok(notice)
}
