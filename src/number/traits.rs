//! The traits of numbers; [`number`](super) says which of them a formula needs. Those of their
//! operations are in `arithmetic`.

use super::arithmetic::{Arithmetic, InRegisters};

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
