//! The numbers that the theory is written in, and which trait a formula needs.
//!
//! nalgebra's `RealField` would do for `f64` and `f32`, but a dual number cannot honestly provide
//! its eighty functions, and its square root goes through inline assembly that no compiler
//! vectorises. So the traits are as small as the theory.
//!
//! * [`Arithmetic`]: a formula without a decision, for one number or several side by side.
//! * [`Number`]: a formula of a model, which chooses or compares: for `f64`, `f32`, numbers with
//!   derivatives ([`dual::Dual`]), and contacts side by side ([`lanes::Lanes`]).
//! * [`Real`]: a formula with tables or logarithms, without derivatives: for `f64`, `f32`, and
//!   contacts side by side.
//! * [`Float`]: a function for one contact, an interface: for `f64` and `f32`.
//! * [`Pair`] of a [`Number`]: two values of one formula in one register.
//! * [`Strips`] of a [`Real`]: many values of one formula, as of strips; `Real::Four` and others.
//! * [`InRegisters`]: an operation of a whole register, by which [`lanes::Lanes`] compute.
//!
//! `Number::Base` is the number below derivatives, a [`Real`]; `Arithmetic::Value` is the same for
//! numbers of which nothing else is known; `Real::Stored` is what its tables are made of, a
//! [`Float`].
//!
//! **A formula** with a decision, for plain numbers, derivatives and contacts side by side. It does
//! not branch: it [chooses](Arithmetic::choose).
//! ```
//! use kstrip::number::{Number, dual::Dual};
//! /// `√x`, continued by a straight line below 1.
//! fn softened<T: Number>(x: T) -> T {
//!     x.plus(-1.0).choose(x.sqrt(), x.plus(1.0).times(0.5))
//! }
//! assert_eq!(softened(4.0_f32), 2.0);
//! assert_eq!(softened(Dual::<f64, 1>::input(4.0, 0)).gradient, [0.25]);
//! ```
//!
//! **A table** is stored in one precision, and read by a [`Real`]. (`table!` chooses the precision
//! when the program is compiled.)
//! ```
//! use kstrip::number::Real;
//! /// `c₀ + c₁ x`
//! fn line<F: Real>([c0, c1]: [F::Stored; 2], x: F) -> F {
//!     F::stored(c0) + F::stored(c1) * x
//! }
//! assert_eq!(line([1.0, 2.0], 3.0_f64), 7.0);
//! ```
//!
//! **Lanes**: four strips of one contact at once, with the bits of one after the other.
//! ```
//! use kstrip::number::{Arithmetic, Float, Strips};
//! /// `Σ √xᵢ` of four.
//! fn sum_of_roots<F: Float>(x: [F; 4]) -> F {
//!     let four = F::Four::gather(|i| x.get(i).copied().unwrap_or(F::zero()));
//!     four.sqrt().total()
//! }
//! assert_eq!(sum_of_roots([1.0, 4.0, 9.0, 16.0]), 10.0);
//! ```

pub mod dual;

mod arithmetic;
pub(crate) mod avx;
mod elementary;
mod float;
pub mod lanes;
mod root;
pub(crate) mod tables;
mod traits;

pub use self::arithmetic::{Arithmetic, InRegisters};
pub use self::dual::Dual;
pub(crate) use self::traits::Stored;
pub use self::traits::{Float, Number, Pair, Real, Strips};

/// `√(x² + y²)` without squares, which may overflow: it lies between the larger one and the sum of
/// both.
#[inline(always)]
pub(crate) fn length<F: Real>(x: F, y: F) -> F {
    let (x, y) = (x.abs(), y.abs());
    let (larger, smaller) = (x.max(y), x.min(y));
    let ratio = smaller / (larger + F::TINY);
    larger * (F::one() + ratio * ratio).sqrt()
}

/// Numbers scaled down together where one exceeds a limit.
#[inline(always)]
pub(crate) fn scaled_down<T: Number, const N: usize>(numbers: [T; N], limit: T::Base) -> [T; N] {
    let mut size = T::Base::zero();
    for number in &numbers {
        size = size.max(number.value().abs());
    }
    if !size.exceeds(limit) {
        return numbers;
    }
    // Divide first: limit/size may underflow the ratio of very different numbers, never overflow.
    let factor = (size - limit).choose(limit / size, T::Base::one());
    T::each(&numbers, |number| number.scale(factor))
}

/// Whether none is infinite or NaN, without an early end. On a microcontroller one sum shows it:
/// `0 x` is 0 or NaN.
#[inline]
pub(crate) fn are_finite<F: Float>(numbers: &[F]) -> bool {
    if cfg!(target_os = "none") {
        let sum = numbers.iter().fold(F::zero(), |sum, x| sum + *x * F::zero());
        return sum.is_finite_number();
    }
    numbers.iter().fold(true, |finite, x| finite & x.is_finite_number())
}

/// Adds numbers to their sums.
#[inline(always)]
pub(crate) fn add<T: Arithmetic>(sums: &mut [T], numbers: impl IntoIterator<Item = T>) {
    for (sum, number) in sums.iter_mut().zip(numbers) {
        *sum += number;
    }
}

/// A number of a list; zero past its end.
#[inline]
pub(crate) fn at<F: Float>(list: &[F], k: usize) -> F {
    list.get(k).copied().unwrap_or(F::zero())
}

/// Numbers at a share of the way from some to others.
#[inline]
pub(crate) fn between<F: Float, const N: usize>(mut from: [F; N], to: [F; N], share: F) -> [F; N] {
    for (from, to) in from.iter_mut().zip(to) {
        *from += (to - *from) * share;
    }
    from
}

/// Replaces a number of a list; past its end there is none.
#[inline]
pub(crate) fn set_at<F>(list: &mut [F], k: usize, value: F) {
    if let Some(place) = list.get_mut(k) {
        *place = value;
    }
}

/// Adds to a number of a list.
#[inline]
pub(crate) fn add_at<T: Arithmetic>(list: &mut [T], k: usize, term: T) {
    if let Some(sum) = list.get_mut(k) {
        *sum += term;
    }
}

/// Successive items of a list.
#[inline]
pub(crate) fn pairs<T>(list: &[T]) -> impl ExactSizeIterator<Item = (&T, &T)> + Clone {
    list.iter().zip(list.get(1..).unwrap_or(&[]))
}

/// Whether each number is larger than the one before.
pub(crate) fn ascend<F: Float>(list: &[F]) -> bool {
    pairs(list).all(|(x, next)| x < next)
}

/// Sorts a short list, in place. One that is in order already takes one pass. (That of `core` can
/// panic.)
pub(crate) fn sort<T>(list: &mut [T], is_before: impl Fn(&T, &T) -> bool) {
    for end in 1..list.len() {
        for i in (0..end).rev() {
            match list.get_mut(i..i + 2) {
                Some([item, next]) if is_before(next, item) => core::mem::swap(item, next),
                _ => break,
            }
        }
    }
}

/// Reverses the order. (That of `core` contains a panic that the linker does not remove.)
pub(crate) fn reverse<T>(mut slice: &mut [T]) {
    while let [first, inner @ .., last] = slice {
        core::mem::swap(first, last);
        slice = inner;
    }
}

/// `1/x` of each, two at a time; an even number of them.
#[inline(always)]
pub(crate) fn inverses<T: Number, const N: usize>(mut numbers: [T; N]) -> [T; N] {
    for two in numbers.chunks_exact_mut(2) {
        if let [p, q] = two {
            (*p, *q) = T::Pair::couple(*p, *q).inverse().parts();
        }
    }
    numbers
}

/// `yes` where a number is positive, else `no`.
#[inline(always)]
pub(crate) fn choose_each<T: Number, const N: usize>(by: T, yes: [T; N], mut no: [T; N]) -> [T; N] {
    for (no, yes) in no.iter_mut().zip(yes) {
        *no = by.choose(yes, *no);
    }
    no
}

/// `branch_or_blend!(by, yes, no)`: as [`chosen`]; what no number needs is not computed.
///
/// No function of closures: the code of numbers side by side must stand inside that of their
/// caller.
macro_rules! branch_or_blend {
    ($by:expr, $yes:block, $no:block) => {{
        use crate::number::{Real as _, choose_each};
        let by = $by;
        let some = by.exceeds(T::zero());
        if T::LANES == 1 {
            if some { $yes } else { $no }
        } else {
            let all = by.value().lies_between(T::TINY, T::LARGEST);
            let yes = if some { $yes } else { [T::zero(); _] };
            let no = if all { [T::zero(); _] } else { $no };
            choose_each(by, yes, no)
        }
    }};
}
pub(crate) use branch_or_blend;
