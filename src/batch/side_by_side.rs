//! Many contacts at once where the processor has wide registers. In those of 256 bits (AVX) four
//! contacts stand side by side in double precision and eight in single precision, in those of
//! 512 bits (AVX-512) twice as many.
//!
//! The road is that of one contact ([`Theory`]), with [`Lanes`](crate::number::lanes::Lanes) for
//! numbers, whose bits are those of plain numbers; each model has code of its own, compiled for
//! these registers. What fills no group of the widest registers goes on to the narrower ones, and
//! from there one by one.

#![allow(unsafe_code)]

use crate::batch::one_by_one::{self, Case, DifferentiatedCase, Found, MOST};
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::forces::derivatives::{Derivatives, with_slopes};
use crate::forces::options::{Model, Options, Solution};
use crate::forces::theory::{Forces, ScaledContact, Theory, by_model};
use crate::forces::warning::{LARGEST_SPIN, RATIOS, linear_warning, model_warning};
use crate::friction::SlipFriction;
use crate::number::avx::{has_avx, has_avx512};
use crate::number::{Arithmetic, Float, Number, Real, Strips, length};
use crate::status::{Error, Warning};
use core::ops::Range;

/// [`solve_batch`](crate::batch::solve_batch) of checked contacts side by side, if the processor
/// has wide registers.
#[inline]
pub(super) fn solve_side_by_side<F: Float>(
    count: usize, options: &Options, get: &impl Fn(usize) -> Case<F>,
    put: &mut impl FnMut(usize, Solution<F>),
) -> Option<Found<Warning>> {
    // SAFETY: the processor was asked.
    if has_avx512() {
        return Some(unsafe { avx512::solve_each(0..count, options, get, put) });
    }
    has_avx().then(|| unsafe { avx::solve_each(0..count, options, get, put) })
}

/// [`differentiate_batch`](crate::batch::differentiate_batch) of checked contacts side by side, if
/// the processor has wide registers and no friction falls.
#[inline]
pub(super) fn differentiate_side_by_side<F: Float>(
    count: usize, options: &Options, get: &impl Fn(usize) -> Case<F>,
    put: &mut impl FnMut(usize, &DifferentiatedCase<F>),
) -> Option<Found<Warning>> {
    let together = has_avx() && (0..count).all(|i| get(i).2.is_none());
    // SAFETY: the processor was asked.
    if together && has_avx512() {
        return Some(unsafe { avx512::differentiate_each(0..count, options, get, put) });
    }
    together.then(|| unsafe { avx::differentiate_each(0..count, options, get, put) })
}

/// Checks inputs if the processor has wide registers; groups that are not ordinary go through the
/// other check.
#[inline]
pub(super) fn check_side_by_side<F: Float>(
    count: usize, get: &impl Fn(usize) -> Case<F>, check: &impl Fn(Range<usize>) -> Found<()>,
) -> Option<Found<()>> {
    // SAFETY: the processor was asked.
    has_avx().then(|| unsafe { check_groups(count, get, check) })
}

#[target_feature(enable = "avx")]
fn check_groups<F: Float>(
    count: usize, get: &impl Fn(usize) -> Case<F>, check: &impl Fn(Range<usize>) -> Found<()>,
) -> Found<()> {
    let (first, end) = whole_groups(&(0..count), F::Contacts::COUNT);
    for first in (first..end).step_by(F::Contacts::COUNT) {
        let numbers = first..first + F::Contacts::COUNT;
        if !are_ordinary(numbers.clone(), get) {
            check(numbers)?;
        }
    }
    check(end..count)
}

/// Most that the steepness of a law may be ([`SlipFriction::least`]) without a check of each
/// contact.
const MILD: f64 = 0.47;

/// Whether a few comparisons show that no check of these contacts fails, and that no derivative is
/// too large.
#[inline(always)]
fn are_ordinary<F: Float>(numbers: Range<usize>, get: &impl Fn(usize) -> Case<F>) -> bool {
    let first = numbers.start;
    let (mut contact, creepage) = group::<F, F::Contacts>(first, get);
    let zero = F::Contacts::zero();
    let mut steepness = zero;
    if numbers.into_iter().any(|i| get(i).2.is_some()) {
        let [friction, ratio, decay, rolling_speed, slope_factor, slide_factor, layer] =
            together::<_, F::Contacts, _>(first, &|i| {
                let (contact, _, law) = get(i);
                let law = law.unwrap_or(SlipFriction::of_constant(contact.friction));
                let SlipFriction { friction, ratio, decay, rolling_speed, slope_factor, .. } = law;
                [friction, ratio, decay, rolling_speed, slope_factor, law.slide_factor, law.layer]
            });
        let (one, largest) = (F::Contacts::one(), F::Contacts::of(1e6));
        let is_usual = ratio.lies_between(zero, one)
            && decay.lies_within(largest)
            && rolling_speed.lies_within(largest)
            && slope_factor.lies_within(one)
            && slide_factor.lies_within(one)
            && layer.lies_within(largest);
        if !is_usual {
            return false;
        }
        let stiffness = slope_factor.choose(slope_factor, one);
        contact.friction = friction;
        contact.shear_modulus = contact.shear_modulus * stiffness;
        contact.mismatch = contact.mismatch * stiffness;
        // B V s_max (1 − A)
        let slip = contact.fastest_slip(&creepage);
        steepness = (one - ratio) * (decay * (rolling_speed * slip));
    }
    // μ ≥ μ₀ (1 − steepness), because exp(−x) ≥ 1 − x
    contact.is_ordinary(&creepage)
        && !steepness.exceeds(F::Contacts::of(MILD))
        && !contact
            .tangential_stiffness()
            .exceeds(contact.friction_bound().times(1e6 * (1.0 - MILD)))
}

/// What is compiled for registers of one width, `$narrower` of the next narrower ones, and as many
/// contacts as fill one of them.
macro_rules! compiled_for {
    ($width:ident, $features:literal, $contacts:ident, $narrower:ident) => {
        mod $width {
            use crate::batch::side_by_side::*;

            #[target_feature(enable = $features)]
            pub fn solve_each<F: Float>(
                numbers: Range<usize>, options: &Options, get: &impl Fn(usize) -> Case<F>,
                put: &mut impl FnMut(usize, Solution<F>),
            ) -> Found<Warning> {
                let mut worst = Warning::None;
                let (first, end) = whole_groups(&numbers, F::$contacts::COUNT);
                for first in (first..end).step_by(F::$contacts::COUNT) {
                    let (contact, creepage) = group::<F, F::$contacts>(first, get);
                    if !go_together(&contact, &creepage) {
                        let alone = first..first + F::$contacts::COUNT;
                        worst = worst.worse($narrower::solve_each(alone, options, get, put)?);
                        continue;
                    }
                    let frame = &ScaledContact::new(&contact);
                    let (forces, psi) = by_model!(
                        options.model,
                        F::$contacts,
                        forces(frame, &creepage, options),
                        return Err((first, Error::ModelLeftOut))
                    );
                    let together = GroupResult::new(options.model, frame, &creepage, &forces, psi);
                    for k in 0..F::$contacts::COUNT {
                        let solution = together.solution_of(k);
                        worst = worst.worse(solution.warning);
                        put(first + k, solution);
                    }
                }
                Ok(worst.worse($narrower::solve_each(end..numbers.end, options, get, put)?))
            }

            #[target_feature(enable = $features)]
            pub fn differentiate_each<F: Float>(
                numbers: Range<usize>, options: &Options, get: &impl Fn(usize) -> Case<F>,
                put: &mut impl FnMut(usize, &DifferentiatedCase<F>),
            ) -> Found<Warning> {
                let mut worst = Warning::None;
                let (first, end) = whole_groups(&numbers, F::$contacts::COUNT);
                for first in (first..end).step_by(F::$contacts::COUNT) {
                    let numbers = first..first + F::$contacts::COUNT;
                    let (contact, creepage) = group::<F, F::$contacts>(first, get);
                    if !go_together(&contact, &creepage) {
                        let found = $narrower::differentiate_each(numbers, options, get, put);
                        worst = worst.worse(found?);
                        continue;
                    }
                    let frame = &ScaledContact::new(&contact);
                    let (forces, psi, slopes) = by_model!(
                        options.model,
                        F::$contacts,
                        slopes(frame, &creepage, options),
                        return Err((first, Error::ModelLeftOut))
                    );
                    let together = GroupResult::new(options.model, frame, &creepage, &forces, psi);
                    for (k, i) in numbers.enumerate() {
                        let (Contact { friction, .. }, creepage, _) = get(i);
                        let (creepage, derivatives) = (&creepage, &lane_of(&slopes, k));
                        let solution = &together.solution_of(k);
                        worst = worst.worse(solution.warning);
                        let (by_mismatch, law) = (None, None);
                        let found = DifferentiatedCase {
                            solution,
                            friction,
                            derivatives,
                            creepage,
                            by_mismatch,
                            law,
                        };
                        put(i, &found);
                    }
                }
                Ok(worst.worse($narrower::differentiate_each(end..numbers.end, options, get, put)?))
            }

            #[target_feature(enable = $features)]
            #[inline(never)]
            fn forces<L: Real, M: Theory<L>>(
                frame: &ScaledContact<L>, creepage: &Creepage<L>, options: &Options,
            ) -> (Forces<L>, L) {
                M::of_contact(frame, options).forces(frame, creepage)
            }

            #[target_feature(enable = $features)]
            #[inline(never)]
            fn slopes<L: Real, M: Theory<L>>(
                frame: &ScaledContact<L>, creepage: &Creepage<L>, options: &Options,
            ) -> (Forces<L>, L, Derivatives<L>) {
                with_slopes(&M::of_contact(frame, options), frame, creepage)
            }
        }
    };
}
compiled_for!(avx, "avx", Contacts, one_by_one);
compiled_for!(avx512, "avx,avx512f,avx512dq", WideContacts, avx);

/// The first of the contacts, and the end of those that fill groups.
#[inline]
fn whole_groups(numbers: &Range<usize>, count: usize) -> (usize, usize) {
    let Range { start, end } = *numbers;
    (start, end - (end - start) % count)
}

/// Whether contacts may be solved in parallel: none is lost, without friction or of dissimilar
/// materials, and none needs a warning about its size.
#[inline(always)]
fn go_together<L: Real>(contact: &Contact<L>, creepage: &Creepage<L>) -> bool {
    contact.mismatch.lies_within(L::zero())
        && contact.is_ordinary(creepage)
        && contact.friction_bound().lies_between(L::TINY, L::LARGEST)
}

/// Contacts side by side.
#[inline(always)]
fn group<F: Float, L: Strips<F>>(
    first: usize, get: &impl Fn(usize) -> Case<F>,
) -> (Contact<L>, Creepage<L>) {
    let [a, b, n, g, nu, mu, kappa, vx, vy, spin] = together(first, &|i| {
        let (contact, Creepage { longitudinal, lateral, spin }, _) = get(i);
        let Contact { a, b, normal_force, shear_modulus, .. } = contact;
        let Contact { poisson_ratio, friction, mismatch, .. } = contact;
        let [g, nu, mu, kappa] = [shear_modulus, poisson_ratio, friction, mismatch];
        [a, b, normal_force, g, nu, mu, kappa, longitudinal, lateral, spin]
    });
    let [normal_force, shear_modulus, poisson_ratio, friction, mismatch] = [n, g, nu, mu, kappa];
    (
        Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch },
        Creepage { longitudinal: vx, lateral: vy, spin },
    )
}

/// Some numbers of each contact, side by side.
#[inline(always)]
fn together<F: Float, L: Strips<F>, const N: usize>(
    first: usize, of: &impl Fn(usize) -> [F; N],
) -> [L; N] {
    let mut quantities = [[F::zero(); MOST]; N];
    for lane in 0..L::COUNT {
        for (quantity, value) in quantities.iter_mut().zip(of(first + lane)) {
            if let Some(place) = quantity.get_mut(lane) {
                *place = value;
            }
        }
    }
    quantities
        .each_ref()
        .map(|numbers| L::gather(|lane| numbers.get(lane).copied().unwrap_or(F::zero())))
}

/// The derivatives of one contact.
#[inline]
fn lane_of<L: Real + Strips<L::Stored>>(
    slopes: &Derivatives<L>, k: usize,
) -> Derivatives<L::Stored> {
    let row = |row: &[L; 3]| row.each_ref().map(|slope| slope.lane(k));
    Derivatives {
        jacobian: slopes.jacobian.each_ref().map(row),
        normal_force: row(&slopes.normal_force),
        load_through_hertz: row(&slopes.load_through_hertz),
        friction: row(&slopes.friction),
    }
}

/// Results of the contacts of a group.
struct GroupResult<L> {
    /// `fx, fy, mz, power, adhesion`
    quantities: [L; 5],
    notices: [Warning; MOST],
}

impl<L: Real + Strips<L::Stored>> GroupResult<L>
where
    L::Stored: Float,
{
    #[inline(always)]
    fn new(
        model: Model, frame: &ScaledContact<L>, creepage: &Creepage<L>, forces: &Forces<L>, psi: L,
    ) -> Self {
        let Forces { fx, fy, mz, adhesion } = *forces;
        let notices = notices(model, frame, forces, psi);
        let Creepage { longitudinal, lateral, spin } = *creepage;
        let power = creepage.power([fx, fy, mz]);
        // At rest there is no force, and adhesion everywhere.
        let zero = L::zero();
        let motion = longitudinal.abs() + lateral.abs() + spin.abs();
        let resting = if model == Model::Total { adhesion } else { L::one() };
        let [fx, fy, mz, power] = L::each(&[fx, fy, mz, power], |x| motion.choose(*x, zero));
        let adhesion = motion.choose(adhesion, resting);
        Self { quantities: [fx, fy, mz, power, adhesion], notices }
    }

    #[inline]
    fn solution_of(&self, k: usize) -> Solution<L::Stored> {
        let [fx, fy, mz, power, adhesion] = self.quantities.each_ref().map(|of| of.lane(k));
        let warning = self.notices.get(k).copied().unwrap_or_default();
        Solution { fx, fy, mz, power, adhesion, warning, reserved: 0 }
    }
}

#[inline(always)]
fn notices<L: Real + Strips<L::Stored>>(
    model: Model, frame: &ScaledContact<L>, forces: &Forces<L>, psi: L,
) -> [Warning; MOST] {
    let mut notices = [Warning::None; MOST];
    let (bound, ratio) = (frame.contact.friction_bound(), frame.units.axis_ratio);
    if model == Model::Linear {
        let size = length(forces.fx, forces.fy);
        if size.exceeds(bound) {
            for (k, warning) in notices.iter_mut().enumerate().take(L::COUNT) {
                *warning = linear_warning(size.lane(k), bound.lane(k));
            }
        }
        return notices;
    }
    let largest = if matches!(model, Model::Strip | Model::Total) { LARGEST_SPIN } else { 0.999 };
    // The same for all models: a group that is outside is classified one by one.
    let usual = psi.abs().lies_between(L::zero(), L::of(largest))
        & ratio.lies_between(L::of(RATIOS[0]), L::of(RATIOS[1]));
    if !usual {
        for (k, of_one) in notices.iter_mut().enumerate().take(L::COUNT) {
            *of_one = model_warning(model, bound.lane(k), ratio.lane(k), psi.lane(k));
        }
    }
    notices
}
