//! The traits of numbers; [`number`](super) says which of them a formula needs.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

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

    /// Whether a branch costs less than both of its sides: one number without derivatives, on a
    /// processor without wide registers.
    const BRANCHES: bool = false;

    /// A constant written in double precision. Free when `x` is a literal.
    fn constant(x: f64) -> Self;
    /// Smallest positive normal number: added to denominators that may vanish together with their
    /// numerators.
    fn tiny() -> Self;
    /// A number whose derivatives are zero.
    fn from_base(x: Self::Value) -> Self;
    /// Without derivatives.
    fn value(self) -> Self::Value;
    /// A function of some numbers from its value and its derivatives with respect to them, worked
    /// out by hand. Without derivatives it is the value, and what leads to the slopes is left out
    /// by the compiler.
    #[inline]
    fn composed<const N: usize>(
        value: Self::Value, _slopes: [Self::Value; N], _inputs: [Self; N],
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
    /// Whether it is above another one; asked only where [`Arithmetic::BRANCHES`].
    #[inline]
    fn is_above(self, _: Self) -> bool {
        false
    }
    /// The nearest number of at most this size.
    #[inline]
    fn within(self, size: f64) -> Self {
        if Self::BRANCHES && Self::constant(size).is_above(self.abs()) {
            return self;
        }
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
    fn ln_quotient(self, divisor: Self) -> Self;
    /// The same of numbers side by side.
    fn ln_quotients<P: Strips<Self>>(x: P, divisor: Self) -> P;
    /// `arctan x` of a number between 0 and 1, to rounding, without a branch.
    fn atan_of_unit(self) -> Self;
}

/// A plain floating-point number, `f32` or `f64`.
pub trait Float: Real<Stored = Self> + PartialOrd + Default + nalgebra::Scalar {
    /// As many contacts side by side as fill a register of 256 bits.
    type Contacts: Real<Stored = Self> + Strips<Self>;
    /// As many as fill one of 512 bits.
    type WideContacts: Real<Stored = Self> + Strips<Self>;

    /// Zero, for constants.
    const ZERO: Self;
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
    /// The inverse of a symmetric matrix, none where it is not positive definite to rounding.
    fn inverse_of_normal(matrix: nalgebra::Matrix6<Self>) -> Option<nalgebra::Matrix6<Self>>;
    /// Of one table in both precisions, that in this one; the other is not even linked.
    fn table<const R: usize, const C: usize>(
        single: &'static [[f32; C]; R], double: &'static [[f64; C]; R],
    ) -> &'static [[Self; C]; R];
}

/// What tables for a kind of number are stored in.
pub(crate) type Stored<T> = <<T as Number>::Base as Real>::Stored;

/// Two numbers side by side.
pub trait Pair<T: Number>: Arithmetic<Value = <T::Base as Number>::Pair> {
    /// Put two numbers side by side.
    fn couple(first: T, second: T) -> Self;
    /// Separate them.
    fn parts(self) -> (T, T);
    /// The same number twice.
    #[inline]
    fn both(x: T) -> Self {
        Self::couple(x, x)
    }
    /// Both multiplied by a plain number.
    #[inline]
    fn by(self, factor: T::Base) -> Self {
        self.scale(<T::Base as Number>::Pair::both(factor))
    }
    /// A plain number added to both.
    #[inline]
    fn more(self, term: T::Base) -> Self {
        self.shift(<T::Base as Number>::Pair::both(term))
    }
    /// Their sum.
    #[inline]
    fn sum(self) -> T {
        let (first, second) = self.parts();
        first + second
    }
}

/// Strips side by side.
pub trait Strips<F: Real>: InRegisters {
    /// How many.
    const COUNT: usize;
    /// The number of each.
    fn gather(of: impl Fn(usize) -> F) -> Self;
    /// The numbers of a list in their order, zeros after its end.
    fn of_list(list: &[F::Stored]) -> Self;
    /// The number of one.
    fn lane(&self, i: usize) -> F;
    /// The same number for all.
    fn all(x: F) -> Self;
    /// Their sum: of the halves, half by half.
    fn total(self) -> F;
}

/// An operation of one number after the other: of two without a loop.
#[inline(always)]
pub(super) fn each<T: Copy, const N: usize>(mut a: [T; N], of: impl Fn(T) -> T) -> [T; N] {
    if let [a0, a1] = &mut a[..] {
        (*a0, *a1) = (of(*a0), of(*a1));
        return a;
    }
    for a in &mut a {
        *a = of(*a);
    }
    a
}

/// An operation of one number and its neighbour after the other.
#[inline]
pub(super) fn each_pair<T: Copy, const N: usize>(
    mut a: [T; N], b: [T; N], of: impl Fn(T, T) -> T,
) -> [T; N] {
    if let ([a0, a1], [b0, b1]) = (&mut a[..], &b[..]) {
        (*a0, *a1) = (of(*a0, *b0), of(*a1, *b1));
        return a;
    }
    for (a, b) in a.iter_mut().zip(b) {
        *a = of(*a, b);
    }
    a
}

/// `yes` where a number is positive, else `no`, one after the other.
#[inline]
pub(super) fn each_chosen<T: Arithmetic, const N: usize>(
    by: [T; N], yes: [T; N], mut no: [T; N],
) -> [T; N] {
    for ((no, by), yes) in no.iter_mut().zip(by).zip(yes) {
        *no = by.choose(yes, *no);
    }
    no
}

/// Methods of [`InRegisters`] for arrays that fill no register.
macro_rules! one_by_one {
    ($($(#[$doc:meta])* $name:ident($a:ident $(, $b:ident)?) $each:ident $of:expr;)*) => {$(
        $(#[$doc])*
        #[inline(always)]
        fn $name<const N: usize>($a: [Self; N] $(, $b: [Self; N])?) -> [Self; N] {
            $each($a $(, $b)?, |$a $(, $b)?| $of)
        }
    )*};
}

/// Numbers that stand side by side in an array: one by one, and in a register where there is one
/// for so many.
pub trait InRegisters: Arithmetic<Value = Self> {
    one_by_one! {
        /// `a + b` of each and its neighbour.
        added(a, b) each_pair a + b;
        /// `a − b`
        subtracted(a, b) each_pair a - b;
        /// `a b`
        multiplied(a, b) each_pair a * b;
        /// `a/b`
        divided(a, b) each_pair a / b;
        /// The larger one; `b` if both are equal or one is not a number.
        larger(a, b) each_pair a.max(b);
        /// The smaller one; `b` if both are equal or one is not a number.
        smaller(a, b) each_pair a.min(b);
        /// `−a`
        negated(a) each -a;
        /// `|a|`
        sizes(a) each a.abs();
        /// `√a`
        roots(a) each a.sqrt();
    }
    /// `1/√a`, as [`Arithmetic::inverse_root`].
    #[inline(always)]
    fn inverse_roots<const N: usize>(mut a: [Self; N]) -> [Self; N] {
        for a in &mut a {
            *a = a.inverse_root();
        }
        a
    }
    /// `yes` where a number is positive, else `no`.
    #[inline]
    fn chosen<const N: usize>(by: [Self; N], yes: [Self; N], no: [Self; N]) -> [Self; N] {
        each_chosen(by, yes, no)
    }
    /// Whether one is larger than its neighbour.
    fn any_exceeds<const N: usize>(a: [Self; N], b: [Self; N]) -> bool;
    /// Whether all lie between others.
    fn all_between<const N: usize>(a: [Self; N], low: [Self; N], high: [Self; N]) -> bool;
}
