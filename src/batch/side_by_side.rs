//! Many contacts at once where the processor has registers of 256 bits (AVX): four contacts side by side in double
//! precision, eight in single precision.
//!
//! The road is that of one contact ([`Theory`]), with [`Lanes`](crate::number::lanes::Lanes) for numbers, whose bits are those of plain numbers;
//! each model has code of its own, compiled for these registers.

#![allow(unsafe_code)]

use crate::batch::{self, Case};
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::friction::derivatives::{Differentiated, without_law};
use crate::number::registers::are_wide;
use crate::number::{Plain, Strips, length};
use crate::solve::derivatives::{Derivatives, with_slopes};
use crate::solve::frame::{Forces, Frame};
use crate::solve::notice::{LARGEST_SPIN, RATIOS, linear_notice, notice};
use crate::solve::options::{Model, Options, Precision, Solution};
use crate::solve::theory::{Linear, Strip, Strip1967, Theory, Total};
use crate::status::{Error, Notice};

/// Contacts that stand side by side at most.
const MOST: usize = 8;

/// [`batch::solve_batch`] side by side, if the processor has wide registers.
#[inline(always)]
pub(super) fn solve<F: Precision>(
    count: usize,
    options: &Options,
    get: &impl Fn(usize) -> (Contact<F>, Creepage<F>),
    put: &mut impl FnMut(usize, Solution<F>),
) -> Option<Result<Notice, (usize, Error)>> {
    // SAFETY: the processor was asked.
    are_wide().then(|| unsafe { solve_groups(count, options, get, put) })
}

/// [`batch::differentiate_batch`] of checked contacts side by side, if the processor has wide registers; of models with strips these are
/// full with those of one contact.
#[inline(always)]
pub(super) fn differentiate<F: Precision>(
    count: usize,
    options: &Options,
    get: &impl Fn(usize) -> Case<F>,
    put: &mut impl FnMut(usize, &Differentiated<F>),
) -> Option<Result<Notice, (usize, Error)>> {
    let together = are_wide() && matches!(options.model, Model::Total | Model::Linear);
    // SAFETY: the processor was asked.
    together.then(|| unsafe { differentiate_groups(count, options, get, put) })
}

#[target_feature(enable = "avx")]
fn solve_groups<F: Precision>(
    count: usize,
    options: &Options,
    get: &impl Fn(usize) -> (Contact<F>, Creepage<F>),
    put: &mut impl FnMut(usize, Solution<F>),
) -> Result<Notice, (usize, Error)> {
    let whole = count - count % F::Contacts::COUNT;
    for first in (0..whole).step_by(F::Contacts::COUNT) {
        let (contact, creepage) = group(first, get);
        if !contact.is_ordinary(&creepage) {
            batch::check(first..first + F::Contacts::COUNT, options, get)?;
        }
    }
    batch::check(whole..count, options, get)?;
    let mut worst = Notice::None;
    for first in (0..whole).step_by(F::Contacts::COUNT) {
        let (contact, creepage) = group(first, get);
        // lost contacts, unlike materials, and those of which something must be said
        if !(is_alike(&contact)
            && contact.is_ordinary(&creepage)
            && contact.normal_force.is_positive_number())
        {
            let alone = first..first + F::Contacts::COUNT;
            worst = worst.worse(batch::solve(alone, options, get, put)?);
            continue;
        }
        let frame = &Frame::of(&contact);
        let (forces, psi) = match options.model {
            Model::Strip1967 => forces_of::<_, Strip1967<false>>(frame, &creepage, options),
            Model::Strip1967Continuous => {
                forces_of::<_, Strip1967<true>>(frame, &creepage, options)
            }
            Model::Strip => forces_of::<_, Strip<F::Contacts>>(frame, &creepage, options),
            Model::Total => forces_of::<_, Total<F::Contacts>>(frame, &creepage, options),
            Model::Linear => forces_of::<_, Linear<F::Contacts>>(frame, &creepage, options),
        };
        let together = Together::new(options.model, frame, &creepage, &forces, psi);
        for k in 0..F::Contacts::COUNT {
            let solution = together.solution(k);
            worst = worst.worse(solution.notice);
            put(first + k, solution);
        }
    }
    Ok(worst.worse(batch::solve(whole..count, options, get, put)?))
}

#[target_feature(enable = "avx")]
fn differentiate_groups<F: Precision>(
    count: usize,
    options: &Options,
    get: &impl Fn(usize) -> Case<F>,
    put: &mut impl FnMut(usize, &Differentiated<F>),
) -> Result<Notice, (usize, Error)> {
    let whole = count - count % F::Contacts::COUNT;
    let mut worst = Notice::None;
    for first in (0..whole).step_by(F::Contacts::COUNT) {
        let numbers = first..first + F::Contacts::COUNT;
        let (contact, creepage) = group(first, &|i| {
            let (contact, creepage, _) = get(i);
            (contact, creepage)
        });
        let free = numbers.clone().all(|i| get(i).2.is_none());
        if !(free
            && is_alike(&contact)
            && contact.is_ordinary(&creepage)
            && contact.friction_bound().is_positive_number())
        {
            let found = batch::differentiate_each(numbers, options, get, put);
            worst = worst.worse(found?);
            continue;
        }
        let frame = &Frame::of(&contact);
        let (forces, psi, slopes) = if options.model == Model::Linear {
            slopes_of::<_, Linear<F::Contacts>>(frame, &creepage, options)
        } else {
            slopes_of::<_, Total<F::Contacts>>(frame, &creepage, options)
        };
        let together = Together::new(options.model, frame, &creepage, &forces, psi);
        for (k, i) in numbers.enumerate() {
            let (contact, creepage, _) = get(i);
            let derivatives = lane_of(&slopes, k);
            let solution = together.solution(k);
            worst = worst.worse(solution.notice);
            let (friction, by_mismatch) = (contact.friction, [F::zero(); 3]);
            let law = without_law(&derivatives, by_mismatch, &creepage);
            put(i, &Differentiated { solution, friction, derivatives, law, by_mismatch });
        }
    }
    Ok(worst.worse(batch::differentiate_each(whole..count, options, get, put)?))
}

/// Whether no pressure adds to the creepage of any.
#[inline(always)]
fn is_alike<L: Plain>(contact: &Contact<L>) -> bool {
    contact.mismatch.lies_within(L::zero())
}

/// Contacts side by side.
#[inline(always)]
fn group<F: Precision>(
    first: usize,
    get: &impl Fn(usize) -> (Contact<F>, Creepage<F>),
) -> (Contact<F::Contacts>, Creepage<F::Contacts>) {
    let mut quantities = [[F::zero(); MOST]; 10];
    for lane in 0..F::Contacts::COUNT {
        let (contact, creepage) = get(first + lane);
        let Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch } =
            contact;
        let Creepage { longitudinal, lateral, spin } = creepage;
        let contact = [a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch];
        let values = contact.into_iter().chain([longitudinal, lateral, spin]);
        for (quantity, value) in quantities.iter_mut().zip(values) {
            if let Some(place) = quantity.get_mut(lane) {
                *place = value;
            }
        }
    }
    let [
        a,
        b,
        normal_force,
        shear_modulus,
        poisson_ratio,
        friction,
        mismatch,
        longitudinal,
        lateral,
        spin,
    ] = quantities
        .each_ref()
        .map(|numbers| F::Contacts::gather(|lane| numbers.get(lane).copied().unwrap_or(F::zero())));
    (
        Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch },
        Creepage { longitudinal, lateral, spin },
    )
}

#[target_feature(enable = "avx")]
#[inline(never)]
fn forces_of<L: Plain, M: Theory<L>>(
    frame: &Frame<L>,
    creepage: &Creepage<L>,
    options: &Options,
) -> (Forces<L>, L) {
    M::of_contact(frame, options).forces(frame, creepage)
}

#[target_feature(enable = "avx")]
#[inline(never)]
fn slopes_of<L: Plain, M: Theory<L>>(
    frame: &Frame<L>,
    creepage: &Creepage<L>,
    options: &Options,
) -> (Forces<L>, L, Derivatives<L>) {
    with_slopes(&M::of_contact(frame, options), frame, creepage)
}

/// The derivatives of one contact.
#[inline(always)]
fn lane_of<L: Plain + Strips<L::Stored>>(
    slopes: &Derivatives<L>,
    k: usize,
) -> Derivatives<L::Stored> {
    let row = |row: &[L; 3]| row.each_ref().map(|slope| slope.lane(k));
    Derivatives {
        jacobian: slopes.jacobian.each_ref().map(row),
        normal_force: row(&slopes.normal_force),
        load_through_hertz: row(&slopes.load_through_hertz),
        friction: row(&slopes.friction),
    }
}

/// What was found side by side.
struct Together<L> {
    /// `fx, fy, mz, power, adhesion`
    quantities: [L; 5],
    notices: [Notice; MOST],
}

impl<L: Plain + Strips<L::Stored>> Together<L>
where
    L::Stored: Precision,
{
    #[inline(always)]
    fn new(
        model: Model,
        frame: &Frame<L>,
        creepage: &Creepage<L>,
        forces: &Forces<L>,
        psi: L,
    ) -> Self {
        let Forces { fx, fy, mz, adhesion } = *forces;
        let notices = notices(model, frame, forces, psi);
        let Creepage { longitudinal, lateral, spin } = *creepage;
        let power = creepage.power([fx, fy, mz]);
        // at rest: no force, and adhesion everywhere
        let zero = L::zero();
        let motion = longitudinal.abs() + lateral.abs() + spin.abs();
        let resting = if model == Model::Total { adhesion } else { L::one() };
        let [fx, fy, mz, power] = L::each(&[fx, fy, mz, power], |x| motion.choose(*x, zero));
        let adhesion = motion.choose(adhesion, resting);
        Self { quantities: [fx, fy, mz, power, adhesion], notices }
    }

    #[inline(always)]
    fn solution(&self, k: usize) -> Solution<L::Stored> {
        let [fx, fy, mz, power, adhesion] = self.quantities.each_ref().map(|of| of.lane(k));
        let notice = self.notices.get(k).copied().unwrap_or_default();
        Solution { fx, fy, mz, power, adhesion, notice, reserved: 0 }
    }
}

/// What the callers should know.
#[inline(always)]
fn notices<L: Plain + Strips<L::Stored>>(
    model: Model,
    frame: &Frame<L>,
    forces: &Forces<L>,
    psi: L,
) -> [Notice; MOST] {
    let mut notices = [Notice::None; MOST];
    let (bound, ratio) = (frame.contact.friction_bound(), frame.axis_ratio());
    if model == Model::Linear {
        let size = length(forces.fx, forces.fy);
        if size.exceeds(bound) {
            for (k, notice) in notices.iter_mut().enumerate().take(L::COUNT) {
                *notice = linear_notice(size.lane(k), bound.lane(k));
            }
        }
        return notices;
    }
    let largest = if matches!(model, Model::Strip | Model::Total) { LARGEST_SPIN } else { 0.999 };
    // (for all models alike: those that it holds up are looked at one by one)
    let usual = psi.abs().lies_between(L::zero(), L::of(largest))
        & ratio.lies_between(L::of(RATIOS[0]), L::of(RATIOS[1]));
    if !usual {
        for (k, of_one) in notices.iter_mut().enumerate().take(L::COUNT) {
            *of_one = notice(model, bound.lane(k), ratio.lane(k), psi.lane(k));
        }
    }
    notices
}
