//! Numbers side by side: pairs, strips, the numbers of several contacts.
//!
//! One array with the operations of its numbers, each the correctly rounded one of a plain number,
//! so that the bits are those of plain numbers one after the other. Nothing here fuses a product
//! with a sum. Arrays that fill a register are computed in it ([`InRegisters`]): four doubles or
//! eight floats only where the processor has AVX, which the code that makes them has checked.

use super::arithmetic::{Arithmetic, InRegisters};
use super::elementary;
use super::traits::{Number, Pair, Real, Strips};
use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// `N` numbers side by side. `A` is their alignment in memory: `()` for none, or [`Wide`].
#[derive(Clone, Copy, Debug)]
pub struct Lanes<T, const N: usize, A = ()>([T; N], [A; 0]);

/// Where a register of 256 bits is read at once.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
pub struct Wide;

impl<T, const N: usize, A> Lanes<T, N, A> {
    /// Code that makes numbers for wide registers has checked that the processor has them.
    pub(crate) fn new(numbers: [T; N]) -> Self {
        Self(numbers, [])
    }
    pub(crate) fn numbers(self) -> [T; N] {
        self.0
    }
}

macro_rules! operators {
    ($(
        $operator:ident $function:ident($($other:ident)?) $of_arrays:ident
        $($assigned:ident $assign:ident)?
    ),*) => {$(
        impl<T: InRegisters, const N: usize, A: Copy + Debug + 'static> $operator
            for Lanes<T, N, A>
        {
            type Output = Self;
            #[inline(always)]
            fn $function(self $(, $other: Self)?) -> Self {
                Self(T::$of_arrays(self.0 $(, $other.0)?), [])
            }
        }

        $(impl<T: InRegisters, const N: usize, A: Copy + Debug + 'static> $assigned
            for Lanes<T, N, A>
        {
            #[inline]
            fn $assign(&mut self, other: Self) {
                *self = self.$function(other);
            }
        })?
    )*};
}
operators!(
    Add add(other) added AddAssign add_assign, Sub sub(other) subtracted SubAssign sub_assign,
    Mul mul(other) multiplied, Div div(other) divided, Neg neg() negated
);

impl<T: InRegisters, const N: usize, A: Copy + Debug + 'static> Arithmetic for Lanes<T, N, A> {
    type Value = Self;
    const BRANCHES: bool = N == 1 && T::BRANCHES;

    fn is_above(self, other: Self) -> bool {
        self.0.iter().zip(&other.0).all(|(x, other)| x.is_above(*other))
    }
    fn constant(x: f64) -> Self {
        Self([T::constant(x); N], [])
    }
    fn tiny() -> Self {
        Self([T::tiny(); N], [])
    }
    fn from_base(x: Self) -> Self {
        x
    }
    fn value(self) -> Self {
        self
    }
    #[inline]
    fn sqrt(self) -> Self {
        Self(T::roots(self.0), [])
    }
    #[inline]
    fn abs(self) -> Self {
        Self(T::sizes(self.0), [])
    }
    #[inline]
    fn max(self, other: Self) -> Self {
        Self(T::larger(self.0, other.0), [])
    }
    #[inline]
    fn min(self, other: Self) -> Self {
        Self(T::smaller(self.0, other.0), [])
    }
    #[inline(always)]
    fn inverse_root(self) -> Self {
        Self(T::inverse_roots(self.0), [])
    }
    #[inline(always)]
    fn choose(self, yes: Self, no: Self) -> Self {
        Self(T::chosen(self.0, yes.0, no.0), [])
    }
}

/// Numbers side by side that are side by side themselves: as many as fill several registers.
impl<T: InRegisters, const M: usize, A: Copy + Debug + 'static> InRegisters for Lanes<T, M, A> {
    #[inline]
    fn any_exceeds<const N: usize>(a: [Self; N], b: [Self; N]) -> bool {
        let mut pairs = a.into_iter().zip(b);
        pairs.any(|(a, b)| T::any_exceeds(a.numbers(), b.numbers()))
    }
    #[inline]
    fn all_between<const N: usize>(a: [Self; N], low: [Self; N], high: [Self; N]) -> bool {
        let mut all = a.into_iter().zip(low.into_iter().zip(high));
        all.all(|(a, (low, high))| T::all_between(a.numbers(), low.numbers(), high.numbers()))
    }
}

impl<T: Real, const N: usize> Number for Lanes<T, N> {
    type Base = Self;
    type Pair = Lanes<Self, 2>;
    const LANES: usize = N * T::LANES;
    const LARGEST: Self = Self([T::LARGEST; N], []);
    const TINY: Self = Self([T::TINY; N], []);
    const ROOT_TINY: Self = Self([T::ROOT_TINY; N], []);
    const HUGE: Self = Self([T::HUGE; N], []);
    const EPSILON: Self = Self([T::EPSILON; N], []);

    #[inline(always)]
    fn exceeds(self, other: Self) -> bool {
        T::any_exceeds(self.0, other.0)
    }
}

impl<T: Real, const N: usize> Real for Lanes<T, N> {
    type Stored = T::Stored;
    type Four = Lanes<Lanes<Self, 2>, 2>;
    type Eight = Lanes<Self::Four, 2>;
    type WideFour = Self::Four;
    type WideEight = Self::Eight;
    type WideSixteen = Self::Eight;
    type WideRow = Lanes<Self, 1>;

    #[inline]
    fn stored(x: T::Stored) -> Self {
        Self([T::stored(x); N], [])
    }
    #[inline]
    fn binary_quotient(self, divisor: Self) -> (Self, Self) {
        let (mut k, mut divisors) = (self.0, divisor.0);
        for (k, divisor) in k.iter_mut().zip(&mut divisors) {
            (*k, *divisor) = k.binary_quotient(*divisor);
        }
        (Self(k, []), Self(divisors, []))
    }
    #[inline(always)]
    fn ln_quotient(self, divisor: Self) -> Self {
        elementary::ln_quotient(self, divisor)
    }
    #[inline]
    fn ln_quotients<P: Strips<Self>>(x: P, divisor: Self) -> P {
        elementary::ln_quotients(x, divisor)
    }
    #[inline(always)]
    fn atan_of_unit(self) -> Self {
        elementary::atan_of_unit(self)
    }
    #[inline]
    fn lies_between(self, low: Self, high: Self) -> bool {
        T::all_between(self.0, low.0, high.0)
    }
}

impl<T: Real<Pair = Self>> Pair<T> for Lanes<T, 2> {
    fn couple(first: T, second: T) -> Self {
        Self([first, second], [])
    }
    fn parts(self) -> (T, T) {
        self.0.into()
    }
}

/// Two in half a register of four, because that is what one instruction takes anyway; harmless
/// numbers in the other half.
#[cfg(target_arch = "x86_64")]
pub type F32Pair = Lanes<f32, 4>;

/// Two of them.
#[cfg(not(target_arch = "x86_64"))]
pub type F32Pair = Lanes<f32, 2>;

#[cfg(target_arch = "x86_64")]
impl Pair<f32> for Lanes<f32, 4> {
    fn couple(first: f32, second: f32) -> Self {
        Self([first, second, 1.0, 1.0], [])
    }
    fn parts(self) -> (f32, f32) {
        let [first, second, ..] = self.0;
        (first, second)
    }
}

/// As many strips as there are numbers.
impl<F: Real, const N: usize, A: Copy + Debug + 'static> Strips<F> for Lanes<F, N, A> {
    const COUNT: usize = N;
    #[inline(always)]
    fn gather(of: impl Fn(usize) -> F) -> Self {
        let mut numbers = [F::zero(); N];
        for (i, place) in numbers.iter_mut().enumerate() {
            *place = of(i);
        }
        Self(numbers, [])
    }
    #[inline]
    fn of_list(list: &[F::Stored]) -> Self {
        let mut numbers = [F::zero(); N];
        for (place, x) in numbers.iter_mut().zip(list) {
            *place = F::stored(*x);
        }
        Self(numbers, [])
    }
    fn all(x: F) -> Self {
        Self([x; N], [])
    }
    fn lane(&self, i: usize) -> F {
        self.0.get(i).copied().unwrap_or(F::zero())
    }
    #[inline]
    fn total(self) -> F {
        let (mut sums, mut half) = (self.0, N / 2);
        while half > 0 {
            let (first, second) = sums.split_at_mut(half);
            for (sum, other) in first.iter_mut().zip(second) {
                *sum += *other;
            }
            half /= 2;
        }
        sums.first().copied().unwrap_or(F::zero())
    }
}

macro_rules! twice {
    ($(<$N:ident, $A:ident> $half:ty: $count:expr),*) => {$(
        /// Twice as many.
        impl<F: Real, const $N: usize, $A: Copy + Debug + 'static> Strips<F> for Lanes<$half, 2> {
            const COUNT: usize = 2 * $count;
            #[inline(always)]
            fn gather(of: impl Fn(usize) -> F) -> Self {
                Self([Strips::gather(&of), Strips::gather(|i| of(i + $count))], [])
            }
            #[inline]
            fn of_list(list: &[F::Stored]) -> Self {
                let (first, second) = list.split_at($count.min(list.len()));
                Self([Strips::of_list(first), Strips::of_list(second)], [])
            }
            fn all(x: F) -> Self {
                Self([Strips::all(x); 2], [])
            }
            fn lane(&self, i: usize) -> F {
                let [first, second] = &self.0;
                if i < $count { first.lane(i) } else { second.lane(i - $count) }
            }
            #[inline]
            fn total(self) -> F {
                let [first, second] = self.0;
                (first + second).total()
            }
        }
    )*};
}
twice!(<N, A> Lanes<F, N, A>: N, <N, A> Lanes<Lanes<F, N, A>, 2>: 2 * N);
