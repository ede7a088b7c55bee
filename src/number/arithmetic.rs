//! The operations of formulas, for one number and for those of a whole register.

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
