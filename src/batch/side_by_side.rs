//! Many contacts at once where the processor has registers of 256 bits (AVX): four contacts side by side in double
//! precision, eight in single precision.
//!
//! The road is that of one contact ([`Theory`]), with the numbers of `number::lanes`, whose bits are those of plain numbers;
//! each model has code of its own, compiled for these registers.

#![allow(unsafe_code)]

use crate::batch::{self, check};
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::number::lanes::{F32x8, F64x4, Lanes};
use crate::number::{Arithmetic, length};
use crate::solve::frame::{Forces, Frame};
use crate::solve::notice::{LARGEST_SPIN, RATIOS, linear_notice, notice};
use crate::solve::options::{Model, Options, Precision, Solution};
use crate::solve::theory::{Linear, Strip, Strip1967, Theory, Total};
use crate::status::{Error, Notice};
use crate::strip::StripTotals;
use core::sync::atomic::{AtomicU8, Ordering};

/// Floating-point types that may fill wide registers.
pub trait Wide: Sized {
    /// [`solve_batch`](crate::batch::solve_batch) in wide registers, or one after the other.
    ///
    /// # Errors
    /// The same.
    fn solve_wide(
        count: usize,
        options: &Options,
        get: impl Fn(usize) -> (Contact<Self>, Creepage<Self>),
        mut put: impl FnMut(usize, Solution<Self>),
    ) -> Result<Notice, (usize, Error)>
    where
        Self: Precision,
    {
        check(0..count, options, &get)?;
        batch::solve(0..count, options, &get, &mut put)
    }
}

/// Whether the processor has registers of 256 bits and the system keeps them.
///
/// The answer is remembered, because under a hypervisor the question takes microseconds. It is the only thing that the library
/// remembers, and no result depends on it: lanes have the bits of plain numbers. Every thread that asks at the same time
/// writes the same answer, so no order between them is needed.
pub(crate) fn available() -> bool {
    const UNKNOWN: u8 = 0;
    const YES: u8 = 1;
    const NO: u8 = 2;
    static KNOWN: AtomicU8 = AtomicU8::new(UNKNOWN);
    if cfg!(target_feature = "avx") {
        return true;
    }
    match KNOWN.load(Ordering::Relaxed) {
        YES => true,
        NO => false,
        _ => {
            let found = ask();
            KNOWN.store(if found { YES } else { NO }, Ordering::Relaxed);
            found
        }
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

macro_rules! wide {
    ($float:ident, $lanes:ident, $count:literal) => {
        impl Wide for $float {
            fn solve_wide(
                count: usize,
                options: &Options,
                get: impl Fn(usize) -> (Contact<Self>, Creepage<Self>),
                put: impl FnMut(usize, Solution<Self>),
            ) -> Result<Notice, (usize, Error)> {
                // SAFETY: the processor has been asked.
                unsafe { solve::<$lanes, $count>(count, options, get, put) }
            }
        }
    };
}

wide!(f64, F64x4, 4);
wide!(f32, F32x8, 8);

/// Contacts side by side.
#[inline(always)]
fn group<L: Lanes<N>, const N: usize>(
    first: usize,
    get: &impl Fn(usize) -> (Contact<L::Stored>, Creepage<L::Stored>),
) -> (Contact<L>, Creepage<L>) {
    let mut quantities = [[L::Stored::zero(); N]; 10];
    for lane in 0..N {
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
    ] = L::each(&quantities, |numbers| L::of_array(*numbers));
    (
        Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch },
        Creepage { longitudinal, lateral, spin },
    )
}

#[target_feature(enable = "avx")]
fn solve<L: Lanes<N> + StripTotals, const N: usize>(
    count: usize,
    options: &Options,
    get: impl Fn(usize) -> (Contact<L::Stored>, Creepage<L::Stored>),
    mut put: impl FnMut(usize, Solution<L::Stored>),
) -> Result<Notice, (usize, Error)>
where
    L::Stored: Precision,
{
    let whole = count - count % N;
    for first in (0..whole).step_by(N) {
        let (contact, creepage) = group::<L, N>(first, &get);
        if !contact.is_ordinary(&creepage) {
            check(first..first + N, options, &get)?;
        }
    }
    check(whole..count, options, &get)?;
    let mut worst = Notice::None;
    for first in (0..whole).step_by(N) {
        let (contact, creepage) = group::<L, N>(first, &get);
        // lost contacts, unlike materials, and those of which something must be said
        let alike = contact.mismatch.lies_within(L::zero());
        if !(alike && contact.is_ordinary(&creepage) && contact.normal_force.is_positive_number()) {
            worst = worst.worse(batch::solve(first..first + N, options, &get, &mut put)?);
            continue;
        }
        let Together { quantities, notices } = solve_group::<L, N>(&contact, &creepage, options);
        let [fx, fy, mz, power, adhesion] = quantities.map(L::array);
        let forces = fx.into_iter().zip(fy).zip(mz);
        let rest = power.into_iter().zip(adhesion).zip(notices);
        for (i, (((fx, fy), mz), ((power, adhesion), notice))) in (first..).zip(forces.zip(rest)) {
            worst = worst.worse(notice);
            put(i, Solution { fx, fy, mz, power, adhesion, notice, reserved: 0 });
        }
    }
    Ok(worst.worse(batch::solve(whole..count, options, &get, &mut put)?))
}

/// What was found side by side.
struct Together<L, const N: usize> {
    /// `fx, fy, mz, power, adhesion`
    quantities: [L; 5],
    notices: [Notice; N],
}

/// Checked contacts that are loaded and plausible.
#[target_feature(enable = "avx")]
fn solve_group<L: Lanes<N> + StripTotals, const N: usize>(
    contact: &Contact<L>,
    creepage: &Creepage<L>,
    options: &Options,
) -> Together<L, N>
where
    L::Stored: Precision,
{
    let (model, frame) = (options.model, &Frame::of(contact));
    let (Forces { fx, fy, mz, adhesion }, psi) = match model {
        Model::Strip1967 => forces_of::<L, Strip1967<false>>(frame, creepage, options),
        Model::Strip1967Continuous => forces_of::<L, Strip1967<true>>(frame, creepage, options),
        Model::Strip => forces_of::<L, Strip<L>>(frame, creepage, options),
        Model::Total => forces_of::<L, Total<L>>(frame, creepage, options),
        Model::Linear => forces_of::<L, Linear<L>>(frame, creepage, options),
    };
    let bound = contact.friction_bound();
    let notices = if model == Model::Linear {
        linear_notices(length(fx, fy), bound)
    } else {
        notices(model, bound, frame.axis_ratio(), psi)
    };
    let Creepage { longitudinal, lateral, spin } = *creepage;
    let power = creepage.power([fx, fy, mz]);
    // at rest: no force, and adhesion everywhere
    let zero = L::zero();
    let motion = longitudinal.abs() + lateral.abs() + spin.abs();
    let resting = if model == Model::Total { adhesion } else { L::one() };
    let [fx, fy, mz, power] = L::each(&[fx, fy, mz, power], |x| motion.choose(*x, zero));
    let adhesion = motion.choose(adhesion, resting);
    Together { quantities: [fx, fy, mz, power, adhesion], notices }
}

#[target_feature(enable = "avx")]
#[inline(never)]
fn forces_of<L: StripTotals, M: Theory<L>>(
    frame: &Frame<L>,
    creepage: &Creepage<L>,
    options: &Options,
) -> (Forces<L>, L) {
    M::of_contact(frame, options).forces(frame, creepage)
}

#[inline(always)]
fn linear_notices<L: Lanes<N>, const N: usize>(size: L, bound: L) -> [Notice; N] {
    let mut notices = [Notice::None; N];
    if size.exceeds(bound) {
        let numbers = size.array().into_iter().zip(bound.array());
        for (notice, (size, bound)) in notices.iter_mut().zip(numbers) {
            *notice = linear_notice(size, bound);
        }
    }
    notices
}

#[inline(always)]
fn notices<L: Lanes<N>, const N: usize>(model: Model, bound: L, ratio: L, psi: L) -> [Notice; N] {
    let mut notices = [Notice::None; N];
    let largest = if matches!(model, Model::Strip | Model::Total) { LARGEST_SPIN } else { 0.999 };
    // (for all models alike: those that it holds up are looked at one by one)
    let usual = psi.abs().lies_between(L::zero(), L::of(largest))
        & ratio.lies_between(L::of(RATIOS[0]), L::of(RATIOS[1]));
    if !usual {
        let numbers = bound.array().into_iter().zip(ratio.array()).zip(psi.array());
        for (of_one, ((bound, ratio), psi)) in notices.iter_mut().zip(numbers) {
            *of_one = notice(model, bound, ratio, psi);
        }
    }
    notices
}
