//! The numbers that the theory is written in.
//!
//! The formulas of this crate are generic over [`Number`]: `f64`, `f32`, the forward-mode dual
//! numbers that carry exact derivatives through the same code, and the numbers of several contacts
//! side by side. What is asked about single contacts is generic over [`Float`].
//!
//! nalgebra's `RealField` would do for the first two, but a dual number cannot honestly provide its
//! eighty functions, and its square root goes through inline assembly that no compiler vectorises.
//! So the trait is as small as the theory: arithmetic, comparison, one square root, and four
//! elementary functions from libm that stay off the hot paths.

pub mod dual;

mod cube_root;
mod float;
pub mod lanes;
pub(crate) mod registers;
pub(crate) mod tables;

use self::float::even_polynomial;
pub use self::registers::InRegisters;
use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A number without derivatives: what constants and tables are made of. `f32`, `f64`, or the
/// numbers of several contacts side by side.
pub trait Real: Number<Base = Self> + InRegisters {
    /// Four strips side by side.
    type Four: Strips<Self>;
    /// Eight strips.
    type Eight: Strips<Self>;
    /// Four where registers are wide (`registers`).
    type WideFour: Strips<Self>;
    /// Eight there.
    type WideEight: Strips<Self>;
    /// Sixteen there: they do not wait for each other.
    type WideSixteen: Strips<Self>;
    /// As many as one register holds there.
    type WideRow: Strips<Self>;
    /// What tables are stored in.
    type Stored: Float;

    /// The nearest number to a constant written in double precision. Free when `x` is a literal.
    #[inline]
    fn of(x: f64) -> Self {
        Self::constant(x)
    }
    /// A number of a table, exactly.
    fn stored(x: Self::Stored) -> Self;
    /// `k` and `2^k` times the divisor, so that the quotient of two positive normal numbers by it
    /// is between 2^-0.59 and 2^0.59.
    fn binary_quotient(self, divisor: Self) -> (Self, Self);
    /// Whether it is at least `low` and at most `high`; of several side by side, whether all are.
    /// Not for NaN.
    fn lies_between(self, low: Self, high: Self) -> bool;
    /// Whether it is at least zero and at most `limit`, of which the bits tell in one comparison;
    /// of several side by side, whether all are. Not for NaN; negative zero may be refused.
    #[inline]
    fn lies_within(self, limit: Self) -> bool {
        self.lies_between(Self::zero(), limit)
    }

    /// `ln(self/divisor)` of two positive normal numbers, to rounding, without a branch.
    #[inline(always)]
    fn ln_quotient(self, divisor: Self) -> Self {
        let (k, divisor) = self.binary_quotient(divisor);
        // ln m = 2 artanh((m − 1)/(m + 1))
        let s = (self - divisor) / (self + divisor);
        let s2 = s * s;
        k.times(core::f64::consts::LN_2) + (s + s) * even_polynomial(Self::Stored::ARTANH, s2)
    }

    /// The same of numbers side by side.
    #[inline(always)]
    fn ln_quotients<P: Strips<Self>>(x: P, divisor: Self) -> P {
        let k = P::gather(|i| x.lane(i).binary_quotient(divisor).0);
        let divisors = P::gather(|i| x.lane(i).binary_quotient(divisor).1);
        let s = (x - divisors) / (x + divisors);
        let s2 = s.squared();
        let mut sum = P::zero();
        for coefficient in Self::Stored::ARTANH.iter().rev() {
            sum = sum * s2 + P::all(Self::stored(*coefficient));
        }
        k.times(core::f64::consts::LN_2) + (s + s) * sum
    }

    /// `arctan x` of a number between 0 and 1, to rounding, without a branch.
    #[inline(always)]
    fn atan_of_unit(self) -> Self {
        const EIGHTH: f64 = core::f64::consts::FRAC_PI_8;
        // from the nearer of π/16 and 3π/16, |u| ≤ tan(π/16)
        let upper = self.plus(-0.414_213_562_373_095_05);
        let tangent =
            upper.choose(Self::of(0.668_178_637_919_298_9), Self::of(0.198_912_367_379_658));
        let angle = upper.choose(Self::of(1.5 * EIGHTH), Self::of(0.5 * EIGHTH));
        let u = (self - tangent) / (self * tangent).plus(1.0);
        angle + u * even_polynomial(Self::Stored::ARCTAN, u * u)
    }
}

/// A plain floating-point number, `f32` or `f64`.
pub trait Float: Real<Stored = Self> + PartialOrd + nalgebra::Scalar {
    /// As many contacts side by side as fill a wide register.
    type Contacts: Real<Stored = Self> + Strips<Self>;

    /// Even powers of `artanh(s)/s` for `s² ≤ 0.0403`.
    const ARTANH: &'static [Self];
    /// Even powers of `arctan(u)/u` for `u² ≤ 0.0396`.
    const ARCTAN: &'static [Self];
    /// A single-precision number, exactly.
    fn widened(x: f32) -> Self;
    /// Its whole part, the nearest one that there is; 0 for NaN.
    fn whole(self) -> i32;
    /// The value in double precision, exactly.
    fn to_f64(self) -> f64;
    /// Neither infinite nor NaN.
    fn is_finite_number(self) -> bool;
    /// Cube root.
    fn cube_root(self) -> Self;
    /// Exponential function.
    fn exp(self) -> Self;
    /// Inverse tangent.
    fn atan(self) -> Self;
    /// Natural logarithm of a positive number.
    fn ln(self) -> Self;
    /// Of one table in both precisions, that in this one; the other is not even linked.
    fn table<const R: usize, const C: usize>(
        single: &'static [[f32; C]; R],
        double: &'static [[f64; C]; R],
    ) -> &'static [[Self; C]; R];
}

/// What formulas without a decision need: one number, or several side by side.
pub trait Arithmetic:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + 'static
{
    /// The same without derivatives: products and sums with it cost none.
    type Value: Arithmetic<Value = Self::Value>;

    /// A constant written in double precision. Free when `x` is a literal.
    fn constant(x: f64) -> Self;
    /// Smallest positive normal number: added to denominators that may vanish together with their
    /// numerators.
    fn tiny() -> Self;
    /// A number whose derivatives are zero.
    fn from_base(x: Self::Value) -> Self;
    /// Without derivatives.
    fn value(self) -> Self::Value;
    /// A function of some numbers from its value and its derivatives by them, worked out by hand.
    /// Without derivatives it is the value, and what leads to the slopes is left out by the
    /// compiler.
    #[inline]
    fn composed<const N: usize>(
        value: Self::Value,
        _slopes: [Self::Value; N],
        _inputs: [Self; N],
    ) -> Self {
        Self::from_base(value)
    }
    /// Product with a number without derivatives.
    #[inline]
    fn scale(self, factor: Self::Value) -> Self {
        self * Self::from_base(factor)
    }
    /// Sum with a number without derivatives.
    #[inline]
    fn shift(self, term: Self::Value) -> Self {
        self + Self::from_base(term)
    }
    /// Square root of a number that is not negative.
    fn sqrt(self) -> Self;
    /// `1/x`
    #[inline]
    fn inverse(self) -> Self {
        Self::one() / self
    }
    /// `1/√x` of numbers between 1e-30 and 1e30, to 1e-14 relative in double precision.
    #[inline]
    fn inverse_root(self) -> Self {
        Self::one() / self.sqrt()
    }
    /// Absolute value.
    fn abs(self) -> Self;
    /// The larger of two numbers.
    fn max(self, other: Self) -> Self;
    /// The smaller of two numbers.
    fn min(self, other: Self) -> Self;
    /// `yes` where this number is positive, else `no`.
    fn choose(self, yes: Self, no: Self) -> Self;
    /// The nearest number of at most this size.
    #[inline]
    fn within(self, size: f64) -> Self {
        self.min(Self::constant(size)).max(Self::constant(-size))
    }

    /// `array.map(function)`; the compiler leaves no call of it behind, whatever a number is made
    /// of.
    #[inline(always)]
    fn each<A, const N: usize>(array: &[A; N], function: impl Fn(&A) -> Self) -> [Self; N] {
        let mut mapped = [Self::zero(); N];
        for (place, x) in mapped.iter_mut().zip(array) {
            *place = function(x);
        }
        mapped
    }
    /// Zero.
    #[inline]
    fn zero() -> Self {
        Self::constant(0.0)
    }
    /// One.
    #[inline]
    fn one() -> Self {
        Self::constant(1.0)
    }
    /// Product with a literal.
    #[inline]
    fn times(self, factor: f64) -> Self {
        self.scale(Self::Value::constant(factor))
    }
    /// Sum with a literal.
    #[inline]
    fn plus(self, term: f64) -> Self {
        self.shift(Self::Value::constant(term))
    }
    /// Square.
    #[inline]
    fn squared(self) -> Self {
        self * self
    }
}

/// What tables for a kind of number are stored in.
pub(crate) type Stored<T> = <<T as Number>::Base as Real>::Stored;

/// A number that formulas without a branch can be evaluated with.
pub trait Number: Arithmetic<Value = <Self as Number>::Base> {
    /// The plain number: itself, or that below a dual number.
    type Base: Real;
    /// Two numbers side by side, in one register where the machine has such registers.
    type Pair: Pair<Self> + Arithmetic<Value = <Self::Base as Number>::Pair>;

    /// How many derivatives it has.
    const DIRECTIONS: usize = 0;
    /// Whether there is more to it than a value.
    const HAS_DERIVATIVES: bool = Self::DIRECTIONS > 0;
    /// How many numbers stand side by side, each of another contact.
    const LANES: usize = 1;
    /// Largest finite number.
    const LARGEST: Self::Base;
    /// Smallest positive normal number.
    const TINY: Self::Base;
    /// Square root of [`Number::TINY`].
    const ROOT_TINY: Self::Base;
    /// Parameters beyond this are indistinguishable from sliding; their squares are still finite.
    const HUGE: Self::Base;
    /// Distance from 1 to the next number.
    const EPSILON: Self::Base;

    /// Whether it is larger than another number; of several side by side, whether one of them is.
    fn exceeds(self, other: Self) -> bool;

    /// Its derivative number `direction`, below [`Number::DIRECTIONS`].
    #[inline]
    fn derivative(&self, _direction: usize) -> Self::Base {
        Self::Base::zero()
    }
    /// Replaces a derivative.
    #[inline]
    fn set_derivative(&mut self, _direction: usize, _derivative: Self::Base) {}

    /// The nearest number in `[low, high]`.
    #[inline]
    fn clamped(self, low: Self, high: Self) -> Self {
        self.max(low).min(high)
    }
}

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

/// Whether none is infinite or NaN. (All are asked, several at once.)
pub(crate) fn are_finite<F: Float>(numbers: &[F]) -> bool {
    numbers.iter().fold(true, |finite, x| finite & x.is_finite_number())
}

/// Adds numbers to their sums.
#[inline(always)]
pub(crate) fn add<T: Arithmetic>(sums: &mut [T], numbers: impl IntoIterator<Item = T>) {
    for (sum, number) in sums.iter_mut().zip(numbers) {
        *sum += number;
    }
}

/// `yes` where a number is positive, else `no`.
#[inline(always)]
pub(crate) fn chosen<T: Number, const N: usize>(by: T, yes: [T; N], mut no: [T; N]) -> [T; N] {
    for (no, yes) in no.iter_mut().zip(yes) {
        *no = by.choose(yes, *no);
    }
    no
}

/// `branch_or_blend!(by, yes, no)`: as [`chosen`]; what no number needs is not computed.
///
/// (No function of closures: the code of numbers side by side must stand inside that of their
/// caller.)
macro_rules! branch_or_blend {
    ($by:expr, $yes:block, $no:block) => {{
        use crate::number::{Real as _, chosen};
        let by = $by;
        let some = by.exceeds(T::zero());
        if T::LANES == 1 {
            if some { $yes } else { $no }
        } else {
            let all = by.value().lies_between(T::TINY, T::LARGEST);
            let yes = if some { $yes } else { [T::zero(); _] };
            let no = if all { [T::zero(); _] } else { $no };
            chosen(by, yes, no)
        }
    }};
}
pub(crate) use branch_or_blend;

/// Two numbers side by side.
pub trait Pair<T: Number>: Arithmetic<Value = <T::Base as Number>::Pair> {
    /// Put two numbers side by side.
    fn of(first: T, second: T) -> Self;
    /// Take them apart.
    fn parts(self) -> (T, T);
    /// The same number twice.
    #[inline(always)]
    fn both(x: T) -> Self {
        Self::of(x, x)
    }
    /// Both multiplied by a plain number.
    #[inline(always)]
    fn by(self, factor: T::Base) -> Self {
        self.scale(<T::Base as Number>::Pair::both(factor))
    }
    /// A plain number added to both.
    #[inline(always)]
    fn more(self, term: T::Base) -> Self {
        self.shift(<T::Base as Number>::Pair::both(term))
    }
    /// Their sum.
    #[inline(always)]
    fn sum(self) -> T {
        let (first, second) = self.parts();
        first + second
    }
}

/// Strips side by side.
pub trait Strips<F>: InRegisters {
    /// How many.
    const COUNT: usize;
    /// The number of each.
    fn gather(of: impl Fn(usize) -> F) -> Self;
    /// The number of one.
    fn lane(&self, i: usize) -> F;
    /// The same number for all.
    #[inline]
    fn all(x: F) -> Self
    where
        F: Copy,
    {
        Self::gather(|_| x)
    }
    /// Their sum: of the halves, half by half.
    fn total(self) -> F;
}
