//! The numbers that the theory is written in.
//!
//! The formulas of this crate are generic over [`Number`]: `f64`, `f32`, the forward-mode dual numbers that carry exact
//! derivatives through the same code, and the numbers of several contacts side by side. What is asked about single
//! contacts is generic over [`Float`] or [`Real`].
//!
//! nalgebra's `RealField` would do for the first two, but a dual number cannot honestly provide its
//! eighty functions, and its square root goes through inline assembly that no compiler vectorises.
//! So the trait is as small as the theory: arithmetic, comparison, one square root, and four
//! elementary functions from libm that stay off the hot paths.

pub mod dual;

mod cube_root;
mod float;
#[cfg(target_arch = "x86_64")]
pub(crate) mod lanes;
pub mod pairs;
mod square_root;

use self::float::even_polynomial;
use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A number without derivatives: what constants and tables are made of. `f32`, `f64`, or the numbers of several
/// contacts side by side.
pub trait Plain: Number<Base = Self> + Arithmetic<Bare = Self> {
    /// What tables are stored in.
    type Stored: Float;

    /// The nearest number to a constant written in double precision. Free when `x` is a literal.
    fn of(x: f64) -> Self;
    /// A number of a table, exactly.
    fn stored(x: Self::Stored) -> Self;
    /// `k` and `2^k` times the divisor, so that the quotient of two positive normal numbers by it is between
    /// 2^-0.59 and 2^0.59.
    fn binary_quotient(self, divisor: Self) -> (Self, Self);
    /// Whether it is at least `low` and at most `high`; of several side by side, whether all are. Not for NaN.
    fn lies_between(self, low: Self, high: Self) -> bool;
    /// Whether it is at least zero and at most `limit`, of which the bits tell in one comparison; of several side by
    /// side, whether all are. Not for NaN; negative zero may be refused.
    fn lies_within(self, limit: Self) -> bool;
    /// Whether it is positive and finite; of several side by side, whether all are. Not for NaN.
    fn is_positive_number(self) -> bool;

    /// `ln(self/divisor)` of two positive normal numbers, to rounding, without a branch.
    #[inline(always)]
    fn ln_quotient(self, divisor: Self) -> Self {
        let (k, divisor) = self.binary_quotient(divisor);
        // ln m = 2 artanh((m − 1)/(m + 1))
        let s = (self - divisor) / (self + divisor);
        let s2 = s * s;
        k.times(core::f64::consts::LN_2) + (s + s) * even_polynomial(Self::Stored::ARTANH, s2)
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

    /// A stored single-precision constant, exactly.
    #[inline(always)]
    fn of_f32(x: f32) -> Self {
        Self::stored(Self::Stored::widened(x))
    }
    /// Two numbers of a table.
    #[inline(always)]
    fn both_stored([first, second]: [Self::Stored; 2]) -> [Self; 2] {
        [Self::stored(first), Self::stored(second)]
    }
}

/// A plain floating-point number, `f32` or `f64`.
pub trait Float: Plain<Stored = Self> + PartialOrd + nalgebra::Scalar {
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
    fn table<const N: usize, const P: usize>(
        single: &'static [[[f32; 2]; P]; N],
        double: &'static [[[f64; 2]; P]; N],
    ) -> &'static [[[Self; 2]; P]; N];
}

/// What formulas without a decision need: one number, or two side by side in [`Number::Pair`].
///
/// `Base` is the plain number below a dual number or a pair, and a plain number itself; products and
/// sums with it cost no derivatives.
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
    /// The plain number: `f64` for `f64` and for dual numbers over `f64`.
    type Base: Plain;
    /// The same without derivatives: one plain number, or a pair of them.
    type Bare: Arithmetic<Base = Self::Base>;

    /// A plain number; its derivatives are zero.
    fn from_base(x: Self::Base) -> Self;
    /// Without derivatives.
    fn bare(self) -> Self::Bare;
    /// A function of some numbers from its value and its derivatives by them, worked out by hand. Without derivatives it
    /// is the value, and what leads to the slopes is left out by the compiler.
    fn composed<const N: usize>(
        value: Self::Bare,
        slopes: [Self::Bare; N],
        inputs: [Self; N],
    ) -> Self;
    /// Product with a plain number.
    fn scale(self, factor: Self::Base) -> Self;
    /// Product with numbers without derivatives, each with its own.
    #[inline(always)]
    fn weigh(self, factor: Self::Bare) -> Self {
        Self::composed(self.bare() * factor, [factor], [self])
    }
    /// Numbers without derivatives.
    #[inline(always)]
    fn fixed(x: Self::Bare) -> Self {
        Self::composed(x, [], [])
    }
    /// Sum with a plain number.
    fn shift(self, term: Self::Base) -> Self;
    /// Square root of a number that is not negative.
    fn sqrt(self) -> Self;
    /// `1/x`
    #[inline(always)]
    fn inverse(self) -> Self {
        Self::one() / self
    }
    /// `1/√x` of numbers between 1e-30 and 1e30, to 1e-14 relative in double precision.
    #[inline(always)]
    fn inverse_root(self) -> Self {
        Self::one() / self.sqrt()
    }
    /// The same of several, which may be quicker together.
    #[inline(always)]
    fn inverse_roots<const N: usize>(mut numbers: [Self; N]) -> [Self; N] {
        for x in &mut numbers {
            *x = x.inverse_root();
        }
        numbers
    }
    /// Absolute value.
    fn abs(self) -> Self;
    /// The larger of two numbers.
    fn max(self, other: Self) -> Self;
    /// The smaller of two numbers.
    fn min(self, other: Self) -> Self;
    /// `yes` where this number is positive, else `no`.
    fn choose(self, yes: Self, no: Self) -> Self;

    /// `array.map(function)`; the compiler leaves no call of it behind, whatever a number is made of.
    #[inline(always)]
    fn each<A, const N: usize>(array: &[A; N], function: impl Fn(&A) -> Self) -> [Self; N] {
        let mut mapped = [Self::zero(); N];
        for (place, x) in mapped.iter_mut().zip(array) {
            *place = function(x);
        }
        mapped
    }
    /// A constant written in double precision.
    #[inline(always)]
    fn constant(x: f64) -> Self {
        Self::from_base(Self::Base::of(x))
    }
    /// Zero.
    #[inline(always)]
    fn zero() -> Self {
        Self::constant(0.0)
    }
    /// One.
    #[inline(always)]
    fn one() -> Self {
        Self::constant(1.0)
    }
    /// Smallest positive normal number: added to denominators that may vanish together with their
    /// numerators.
    #[inline(always)]
    fn tiny() -> Self {
        Self::from_base(<Self::Base as Number>::TINY)
    }
    /// Product with a literal.
    #[inline(always)]
    fn times(self, factor: f64) -> Self {
        self.scale(Self::Base::of(factor))
    }
    /// Sum with a literal.
    #[inline(always)]
    fn plus(self, term: f64) -> Self {
        self.shift(Self::Base::of(term))
    }
    /// Square.
    #[inline(always)]
    fn squared(self) -> Self {
        self * self
    }
}

/// A rule of integration, in both precisions: no number is converted at run time.
pub(crate) struct Nodes<const N: usize> {
    single: [[[f32; 2]; N]; 1],
    double: [[[f64; 2]; N]; 1],
}

impl<const N: usize> Nodes<N> {
    /// Nodes and weights.
    pub(crate) const fn new(double: [[f64; 2]; N]) -> Self {
        let mut single = [[0.0; 2]; N];
        let mut i = 0;
        while i < N {
            single[i] = [double[i][0] as f32, double[i][1] as f32];
            i += 1;
        }
        Self { single: [single], double: [double] }
    }

    /// Nodes and weights for numbers of a kind.
    #[inline(always)]
    pub(crate) fn of<T: Number>(&'static self) -> impl Iterator<Item = [T::Base; 2]> {
        let [list] = Stored::<T>::table(&self.single, &self.double);
        list.iter().map(|pair| T::Base::both_stored(*pair))
    }
}

/// What tables for a kind of number are stored in.
pub(crate) type Stored<T> = <<T as Arithmetic>::Base as Plain>::Stored;

/// A number that formulas without a branch can be evaluated with.
pub trait Number: Arithmetic {
    /// Two numbers side by side, in one register where the machine has such registers.
    type Pair: Pair<Self> + Arithmetic<Bare = <Self::Base as Number>::Pair>;
    /// Four numbers side by side, in as many registers as the machine needs for them.
    type Quad: Quad<Self> + Arithmetic<Bare = <Self::Base as Number>::Quad>;

    /// Whether there is more to it than a value.
    const HAS_DERIVATIVES: bool = false;
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

    /// The value without derivatives.
    fn value(self) -> Self::Base;
    /// The outputs of a map of plain numbers that brings its own derivatives.
    fn map<const N: usize, const M: usize>(
        map: &impl Map<Self::Base, N, M>,
        inputs: [Self; N],
    ) -> [Self; M];
    /// A function of some numbers from its value and its derivatives by them.
    #[inline(always)]
    fn follow<const N: usize>(
        value: Self::Base,
        slopes: [Self::Base; N],
        inputs: [Self; N],
    ) -> Self {
        let bare = |x: &Self::Base| Self::from_base(*x).bare();
        Self::composed(bare(&value), slopes.each_ref().map(bare), inputs)
    }
    /// Whether it is larger than another number; of several side by side, whether one of them is.
    fn exceeds(self, other: Self) -> bool;

    /// The nearest number in `[low, high]`.
    #[inline(always)]
    fn clamped(self, low: Self, high: Self) -> Self {
        self.max(low).min(high)
    }
}

/// `√(x² + y²)` without squares, which may overflow: it lies between the larger one and the sum of both.
#[inline(always)]
pub(crate) fn length<F: Plain>(x: F, y: F) -> F {
    let (x, y) = (x.abs(), y.abs());
    let (larger, smaller) = (x.max(y), x.min(y));
    let ratio = smaller / (larger + F::TINY);
    larger * (F::one() + ratio * ratio).sqrt()
}

/// `yes` where a number is positive, else `no`.
#[inline(always)]
pub(crate) fn chosen<T: Number, const N: usize>(by: T, yes: [T; N], mut no: [T; N]) -> [T; N] {
    for (no, yes) in no.iter_mut().zip(yes) {
        *no = by.choose(yes, *no);
    }
    no
}

/// `either!(by, yes, no)`: as [`chosen`]; what no number needs is not computed.
///
/// (No function of closures: the code of numbers side by side must stand inside that of their caller.)
macro_rules! either {
    ($by:expr, $yes:block, $no:block) => {{
        use crate::number::{Plain as _, chosen};
        let by = $by;
        let some = by.exceeds(T::zero());
        if T::LANES == 1 {
            if some { $yes } else { $no }
        } else {
            let all = by.value().is_positive_number();
            let yes = if some { $yes } else { [T::zero(); _] };
            let no = if all { [T::zero(); _] } else { $no };
            chosen(by, yes, no)
        }
    }};
}
pub(crate) use either;

/// `once!(T, code)`: code that is there once for each kind of number `T`, whoever calls it. That of numbers side by side stands
/// inside their caller, who alone may use their registers.
macro_rules! once {
    ($T:ident, $code:expr) => {{
        #[inline(never)]
        fn apart<R>(code: impl FnOnce() -> R) -> R {
            code()
        }
        if <$T as crate::number::Number>::LANES > 1 { $code } else { apart(|| $code) }
    }};
}
pub(crate) use once;

/// A number that the theory can be evaluated with. Comparisons look at the value only.
pub trait Real: Number<Base: Float> + PartialEq + PartialOrd {}

impl<T: Number<Base: Float> + PartialEq + PartialOrd> Real for T {}

/// A differentiable map of plain numbers.
pub trait Map<F, const N: usize, const M: usize> {
    /// What [`Map::tangent`] needs to know of the place where the map was evaluated.
    type Place;
    /// The outputs.
    fn value(&self, inputs: [F; N]) -> ([F; M], Self::Place);
    /// How the outputs move when the inputs do.
    fn tangent(&self, place: &Self::Place, inputs: [F; N]) -> [F; M];
}

/// Two numbers side by side.
pub trait Pair<T: Number>: Arithmetic<Base = T::Base> {
    /// Put two numbers side by side.
    fn of(first: T, second: T) -> Self;
    /// Take them apart.
    fn parts(self) -> (T, T);
    /// The same number twice.
    #[inline(always)]
    fn both(x: T) -> Self {
        Self::of(x, x)
    }
    /// Each multiplied by its own plain number.
    #[inline(always)]
    fn scale_each(self, factors: [T::Base; 2]) -> Self {
        let [p, q] = factors;
        let (first, second) = self.parts();
        Self::of(first.scale(p), second.scale(q))
    }
    /// A plain number for each.
    #[inline(always)]
    fn plain(values: [T::Base; 2]) -> Self {
        let [first, second] = values;
        Self::of(T::from_base(first), T::from_base(second))
    }
    /// Their sum.
    #[inline(always)]
    fn sum(self) -> T {
        let (first, second) = self.parts();
        first + second
    }
}

/// Four numbers side by side.
pub trait Quad<T: Number>: Arithmetic<Base = T::Base> {
    /// Put two pairs side by side.
    fn of_halves(first: T::Pair, second: T::Pair) -> Self;
    /// Take them apart.
    fn halves(self) -> [T::Pair; 2];
    /// The same number four times.
    fn all(x: T) -> Self;
    /// A plain number for each.
    fn plain(values: [T::Base; 4]) -> Self;
    /// Put four numbers side by side.
    #[inline(always)]
    fn of([a, b, c, d]: [T; 4]) -> Self {
        Self::of_halves(T::Pair::of(a, b), T::Pair::of(c, d))
    }
    /// Take them apart.
    #[inline(always)]
    fn parts(self) -> [T; 4] {
        let [first, second] = self.halves();
        let ((a, b), (c, d)) = (first.parts(), second.parts());
        [a, b, c, d]
    }
    /// Their sum: that of the sums of the first and third, and of the second and fourth.
    #[inline(always)]
    fn sum(self) -> T {
        let [first, second] = self.halves();
        (first + second).sum()
    }
}
