//! Many contacts at once where the processor has registers of 256 bits (AVX): four contacts side by side in double
//! precision, eight in single precision.
//!
//! The formulas are those of one contact, evaluated with the numbers of `real::lanes`, whose bits are
//! those of plain numbers. Contacts that need another branch than their neighbours are solved one by one.
//!
//! The processor is asked once (`cpuid`, which takes some 4 µs under a hypervisor), and the answer is remembered.

#![allow(unsafe_code)]

use crate::batch::{Problems, Solutions, check_one, evaluate_one};
use crate::contact::Contact;
use crate::contact::creepage::{Creepage, Parameters};
use crate::contact::forces::Totals;
use crate::linear::LinearCoefficients;
use crate::number::lanes::{F32x8, F64x4, Lanes};
use crate::number::{Arithmetic, Plain};
use crate::solve::evaluate::Wanted;
use crate::solve::model::{self, Forces, LARGEST_SPIN, Model, Options, Precision, Problem, RATIOS};
use crate::status::{Error, Notice};
use crate::strip_1967;
use crate::total;

/// Floating-point types that fill wide registers.
pub trait Wide: crate::number::Float {
    /// Sums over the strips of a contact in wide registers, if there are any.
    fn strip_sums(
        strips: &crate::strip::PreparedStrips<Self>,
        law: &crate::strip::Law<Self>,
        slopes: bool,
    ) -> crate::strip::Sums<Self>;

    /// [`evaluate_batch`](crate::batch::evaluate_batch) in wide registers.
    ///
    /// # Errors
    /// The same.
    fn evaluate_wide(
        problems: &impl Problems<Self>,
        options: &Options,
        wanted: Wanted,
        solutions: &mut impl Solutions<Self>,
    ) -> Result<Notice, Error>
    where
        Self: Precision;
}

/// Whether the wide registers are there, and worth the question.
pub(crate) fn pays(model: Model, count: usize) -> bool {
    let least = match model {
        Model::Strip => 16,
        Model::Total => 48,
        Model::Linear => 128,
        Model::Strip1967 | Model::Strip1967Continuous => 48,
    };
    count >= least && available()
}

/// Whether the processor has registers of 256 bits and the system keeps them. It is asked once.
#[inline]
pub(crate) fn available() -> bool {
    use core::sync::atomic::{AtomicU8, Ordering};
    static KNOWN: AtomicU8 = AtomicU8::new(0);
    if cfg!(target_feature = "avx") {
        return true;
    }
    match KNOWN.load(Ordering::Relaxed) {
        0 => {
            let found = ask();
            KNOWN.store(if found { 2 } else { 1 }, Ordering::Relaxed);
            found
        }
        known => known == 2,
    }
}

#[cold]
fn ask() -> bool {
    use core::arch::x86_64::{__cpuid, _xgetbv};
    #[target_feature(enable = "xsave")]
    fn kept() -> u64 {
        // SAFETY: the caller knows that the system has switched this instruction on.
        unsafe { _xgetbv(0) }
    }
    const SWITCHED_ON: u32 = 1 << 27;
    const AVX: u32 = 1 << 28;
    const REGISTERS: u64 = 0b110;
    // SAFETY: every x86-64 processor has this instruction and its leaf 1.
    #[allow(unused_unsafe)]
    let features = unsafe { __cpuid(1) }.ecx;
    // SAFETY: the instruction is there when the first flag says so.
    features & SWITCHED_ON != 0 && features & AVX != 0 && unsafe { kept() } & REGISTERS == REGISTERS
}

// The model as a constant, so that a piece of code has nothing of the other models in it.
const STRIP_1967: i32 = Model::Strip1967 as i32;
const CONTINUOUS: i32 = Model::Strip1967Continuous as i32;
const STRIP: i32 = Model::Strip as i32;
const TOTAL: i32 = Model::Total as i32;
const LINEAR: i32 = Model::Linear as i32;

macro_rules! wide {
    ($float:ident, $lanes:ident, $count:literal, $sums:path) => {
        impl Wide for $float {
            #[inline(always)]
            fn strip_sums(
                strips: &crate::strip::PreparedStrips<Self>,
                law: &crate::strip::Law<Self>,
                slopes: bool,
            ) -> crate::strip::Sums<Self> {
                $sums(strips, law, slopes)
            }
            fn evaluate_wide(
                problems: &impl Problems<Self>,
                options: &Options,
                wanted: Wanted,
                solutions: &mut impl Solutions<Self>,
            ) -> Result<Notice, Error> {
                /// One piece of code for each model.
                #[target_feature(enable = "avx")]
                fn with_avx<const MODEL: i32>(
                    problems: &impl Problems<$float>,
                    options: &Options,
                    wanted: Wanted,
                    solutions: &mut impl Solutions<$float>,
                ) -> Result<Notice, Error> {
                    let model = Model::from_number(MODEL).unwrap_or_default();
                    let options = Options { model, ..*options };
                    solve::<$lanes, $count, MODEL>(problems, &options, wanted, solutions)
                }
                // SAFETY: `pays` has asked the processor.
                unsafe {
                    match options.model {
                        Model::Total => with_avx::<TOTAL>(problems, options, wanted, solutions),
                        Model::Linear => with_avx::<LINEAR>(problems, options, wanted, solutions),
                        Model::Strip => with_avx::<STRIP>(problems, options, wanted, solutions),
                        Model::Strip1967 => {
                            with_avx::<STRIP_1967>(problems, options, wanted, solutions)
                        }
                        Model::Strip1967Continuous => {
                            with_avx::<CONTINUOUS>(problems, options, wanted, solutions)
                        }
                    }
                }
            }
        }
    };
}

wide!(f64, F64x4, 4, crate::strip::registers::sums);
wide!(f32, F32x8, 8, crate::strip::PreparedStrips::sums);

/// Contacts side by side.
type Group<L> = (Contact<L>, Creepage<L>);

#[inline(always)]
fn group<L: Lanes<N>, const N: usize>(
    problems: &impl Problems<L::Stored>,
    first: usize,
) -> Option<Group<L>> {
    let [a, b, normal_force, shear_modulus, poisson_ratio, friction, longitudinal, lateral, spin] =
        L::each(&problems.side_by_side::<N>(first)?, |numbers| L::of_array(*numbers));
    Some((
        Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction },
        Creepage { longitudinal, lateral, spin },
    ))
}

#[inline(always)]
fn solve<L: Lanes<N>, const N: usize, const MODEL: i32>(
    problems: &impl Problems<L::Stored>,
    options: &Options,
    wanted: Wanted,
    solutions: &mut impl Solutions<L::Stored>,
) -> Result<Notice, Error>
where
    L::Stored: Precision,
{
    let count = problems.count();
    for first in (0..count).step_by(N) {
        let mut sound = false;
        if let Some((contact, creepage)) = group::<L, N>(problems, first) {
            let problem = Problem::of(&contact, &creepage, options);
            sound = problem.is_sound();
        }
        if !sound {
            check_apart(problems, first, count.min(first + N), options)?;
        }
    }
    let mut worst = Notice::None;
    for first in (0..count).step_by(N) {
        // (no closures on this road: the compiler must inline all of it)
        let mut together = None;
        if let Some((contact, creepage)) = group::<L, N>(problems, first) {
            together = solve_group::<L, N, MODEL>(&contact, &creepage, options, wanted);
        }
        let Some(Together { quantities, notices, within }) = together else {
            let end = count.min(first + N);
            let notice = evaluate_apart(problems, first, end, options, wanted, solutions)?;
            worst = worst.worse(notice);
            continue;
        };
        solutions.put_side_by_side(first, &quantities.map(L::array), &notices);
        for (i, (notice, within)) in (first..).zip(notices.into_iter().zip(within.array())) {
            worst = worst.worse(if within > L::Stored::zero() {
                notice
            } else {
                evaluate_apart(problems, i, i + 1, options, wanted, solutions)?
            });
        }
    }
    Ok(worst)
}

#[cold]
#[inline(never)]
fn check_apart<F: Precision>(
    problems: &impl Problems<F>,
    first: usize,
    end: usize,
    options: &Options,
) -> Result<(), Error> {
    (first..end).try_for_each(|i| check_one(problems, i, options))
}

#[inline(never)]
fn evaluate_apart<F: Precision>(
    problems: &impl Problems<F>,
    first: usize,
    end: usize,
    options: &Options,
    wanted: Wanted,
    solutions: &mut impl Solutions<F>,
) -> Result<Notice, Error> {
    let mut worst = Notice::None;
    for i in first..end {
        worst = worst.worse(evaluate_one(problems, i, options, wanted, solutions)?);
    }
    Ok(worst)
}

/// What was found side by side.
struct Together<L, const N: usize> {
    /// `fx, fy, mz, power, adhesion`
    quantities: [L; 5],
    notices: [Notice; N],
    /// Not positive where the contact is to be solved by itself after all.
    within: L,
}

/// Checked contacts; `None` when they are to be solved one by one.
#[inline(always)]
fn solve_group<L: Lanes<N>, const N: usize, const MODEL: i32>(
    contact: &Contact<L>,
    creepage: &Creepage<L>,
    options: &Options,
    wanted: Wanted,
) -> Option<Together<L, N>>
where
    L::Stored: Precision,
{
    let problem = Problem::of(contact, creepage, options);
    if !problem.ordinary {
        return None;
    }
    let load = contact.normal_force;
    let (forces, notices, within) = if MODEL == LINEAR {
        let linear = coefficients(contact);
        let forces = problem.linear(&linear, creepage);
        let size = load.choose(model::linear_size(forces.fx, forces.fy), L::zero());
        let bound = load.choose(contact.friction_bound(), L::zero());
        (forces, linear_notices(size, bound), L::one())
    } else {
        let parameters = Parameters::new_inline(contact, creepage);
        let bound = contact.friction_bound();
        let [fx, fy, mz, adhesion, within] = totals::<L, N, MODEL>(&problem, &parameters)?;
        let forces = Forces {
            fx: fx.scale(bound),
            fy: fy.scale(bound),
            mz: mz.scale(bound * problem.mean_radius()),
            adhesion,
        };
        let carried = load.choose(bound, L::zero());
        let notices = notices(options.model, carried, parameters.axis_ratio, parameters.psi);
        (forces, notices, within)
    };
    let Creepage { longitudinal, lateral, spin } = *creepage;
    let Forces { fx, fy, mz, adhesion } = forces;
    let power = creepage.power([fx, fy, mz]);
    // at rest: no force, and adhesion everywhere
    let zero = L::zero();
    let motion = longitudinal.abs() + lateral.abs() + spin.abs();
    let resting = if MODEL == TOTAL { adhesion } else { L::one() };
    let [fx, fy, mut mz, mut power] =
        L::each(&[fx, fy, mz, power], |x| load.choose(motion.choose(*x, zero), zero));
    let mut adhesion = load.choose(motion.choose(adhesion, resting), zero);
    // as `evaluate::leave_out`
    if !wanted.moment {
        (mz, power) = (zero, zero);
    }
    if !wanted.adhesion {
        adhesion = -L::one();
    }
    Some(Together { quantities: [fx, fy, mz, power, adhesion], notices, within })
}

/// `Fx/(μ N)`, `Fy/(μ N)`, `Mz/(μ N √(ab))`, the share in adhesion, and a number that is not positive where a contact
/// is to be solved by itself.
#[inline(always)]
fn totals<L: Lanes<N>, const N: usize, const MODEL: i32>(
    problem: &Problem<L>,
    parameters: &Parameters<L>,
) -> Option<[L; 5]>
where
    L::Stored: Precision,
{
    let Parameters { axis_ratio, poisson_ratio, .. } = *parameters;
    let creepage = parameters.normalised();
    match MODEL {
        TOTAL => {
            let linear = &coefficients(problem.contact);
            let prepared = total::Prepared::new(axis_ratio, poisson_ratio, linear);
            let Totals { fx, fy, mz, stick } = prepared.totals(creepage);
            Some([fx, fy, mz, stick, L::one()])
        }
        STRIP => {
            let linear = &coefficients(problem.contact);
            let strips = crate::strip::PreparedStrips::new(
                axis_ratio,
                poisson_ratio,
                linear,
                problem.options.strips,
            );
            let found = strips.totals(creepage);
            Some([found.fx, found.fy, found.mz, found.stick, L::one()])
        }
        STRIP_1967 | CONTINUOUS => {
            let Totals { fx, fy, mz, stick } =
                strip_1967::totals(parameters, problem.sliding_rule());
            // (without friction or load the spin is beyond all bounds)
            let within = problem.contact.friction_bound().choose(L::one(), -L::one());
            Some([fx, fy, mz, stick, within])
        }
        _ => None,
    }
}

#[inline(always)]
fn coefficients<L: Plain>(contact: &Contact<L>) -> LinearCoefficients<L> {
    LinearCoefficients::at_inline(contact.a / contact.b, contact.poisson_ratio)
}

#[inline(always)]
fn linear_notices<L: Lanes<N>, const N: usize>(size: L, bound: L) -> [Notice; N] {
    let mut notices = [Notice::None; N];
    if size.exceeds(bound) {
        let numbers = size.array().into_iter().zip(bound.array());
        for (notice, (size, bound)) in notices.iter_mut().zip(numbers) {
            *notice = model::linear_notice(size, bound);
        }
    }
    notices
}

#[inline(always)]
fn notices<L: Lanes<N>, const N: usize>(model: Model, bound: L, ratio: L, psi: L) -> [Notice; N] {
    let mut notices = [Notice::None; N];
    let usual = psi.abs().lies_between(L::zero(), L::of(LARGEST_SPIN))
        & ratio.lies_between(L::of(RATIOS[0]), L::of(RATIOS[1]));
    if !usual {
        let numbers = bound.array().into_iter().zip(ratio.array()).zip(psi.array());
        for (notice, ((bound, ratio), psi)) in notices.iter_mut().zip(numbers) {
            *notice = model::notice(model, bound, ratio, psi);
        }
    }
    notices
}
