//! Forward-mode differentiation: numbers that carry their derivatives.
//!
//! A [`Dual`] is a value with its derivatives with respect to `M` inputs. Run through the same
//! generic formulas as a plain number it returns the exact derivatives of those formulas, branch
//! by branch; there is no step size and no second implementation to keep in step.

use super::arithmetic::Arithmetic;
use super::traits::{Number, Pair, Real};
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A value and its derivatives with respect to `M` inputs: plain numbers, or pairs of them, so that
/// registers for pairs are full whatever `M` is.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Dual<P, const M: usize> {
    /// The value.
    pub value: P,
    /// Its derivatives.
    pub gradient: [P; M],
}

impl<F: Real, const M: usize> Dual<F, M> {
    /// The input number `index`: its derivative with respect to itself is one.
    #[must_use]
    pub fn input(value: F, index: usize) -> Self {
        let mut gradient = [F::zero(); M];
        if let Some(own) = gradient.get_mut(index) {
            *own = F::one();
        }
        Self { value, gradient }
    }
}

impl<P: Arithmetic<Value = P>, const M: usize> Dual<P, M> {
    /// A function of this number: its value, and its slope times the derivatives.
    #[inline]
    fn chain(self, value: P, slope: P) -> Self {
        Self { value, gradient: P::each(&self.gradient, |d| *d * slope) }
    }

    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn combine(self, other: Self, value: P, by_self: P, by_other: P) -> Self {
        let mut gradient = self.gradient;
        for (own, other) in gradient.iter_mut().zip(other.gradient) {
            *own = *own * by_self + other * by_other;
        }
        Self { value, gradient }
    }

    /// `yes` where the test is positive, else `no`.
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn pick(test: P, yes: Self, no: Self) -> Self {
        let mut gradient = no.gradient;
        for (own, other) in gradient.iter_mut().zip(yes.gradient) {
            *own = test.choose(other, *own);
        }
        Self { value: test.choose(yes.value, no.value), gradient }
    }
}

macro_rules! sums {
    ($($operator:ident $function:ident $assigned:ident $assign:ident)*) => {$(
        impl<P: Arithmetic<Value = P>, const M: usize> $assigned for Dual<P, M> {
            #[inline]
            fn $assign(&mut self, other: Self) {
                self.value.$assign(other.value);
                for (own, other) in self.gradient.iter_mut().zip(other.gradient) {
                    own.$assign(other);
                }
            }
        }

        impl<P: Arithmetic<Value = P>, const M: usize> $operator for Dual<P, M> {
            type Output = Self;
            #[inline]
            fn $function(mut self, other: Self) -> Self {
                self.$assign(other);
                self
            }
        }
    )*};
}
sums!(Add add AddAssign add_assign Sub sub SubAssign sub_assign);

impl<P: Arithmetic<Value = P>, const M: usize> Mul for Dual<P, M> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.combine(other, self.value * other.value, other.value, self.value)
    }
}

impl<P: Arithmetic<Value = P>, const M: usize> Div for Dual<P, M> {
    type Output = Self;
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline)]
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let inverse = P::one() / other.value;
        self.combine(other, quotient, inverse, -(quotient * inverse))
    }
}

impl<P: Arithmetic<Value = P>, const M: usize> Neg for Dual<P, M> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, gradient: P::each(&self.gradient, |d| -*d) }
    }
}

impl<P: Arithmetic<Value = P>, const M: usize> Arithmetic for Dual<P, M> {
    type Value = P;

    fn constant(x: f64) -> Self {
        Self::from_base(P::constant(x))
    }
    fn tiny() -> Self {
        Self::from_base(P::tiny())
    }
    fn from_base(value: P) -> Self {
        Self { value, gradient: [P::zero(); M] }
    }
    fn value(self) -> P {
        self.value
    }
    #[inline(always)]
    fn composed<const N: usize>(value: P, slopes: [P; N], inputs: [Self; N]) -> Self {
        let mut terms = slopes.into_iter().zip(inputs);
        let Some((slope, input)) = terms.next() else {
            return Self { value, gradient: [P::zero(); M] };
        };
        let mut gradient = P::each(&input.gradient, |d| *d * slope);
        for (slope, input) in terms {
            for (own, d) in gradient.iter_mut().zip(input.gradient) {
                *own += d * slope;
            }
        }
        Self { value, gradient }
    }
    #[inline(always)]
    fn inverse(self) -> Self {
        let inverse = P::one() / self.value;
        self.chain(inverse, -(inverse * inverse))
    }
    #[inline]
    fn scale(self, factor: P) -> Self {
        self.chain(self.value * factor, factor)
    }
    fn shift(mut self, term: P) -> Self {
        self.value += term;
        self
    }
    fn squared(self) -> Self {
        self.chain(self.value * self.value, self.value + self.value)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, P::constant(0.5) / root.max(P::tiny()))
    }
    #[inline]
    fn inverse_root(self) -> Self {
        let y = self.value.inverse_root();
        self.chain(y, (y * (y * y)).times(-0.5))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self::pick(-self.value, -self, self)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self::pick(self.value - other.value, self, other)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self::pick(other.value - self.value, self, other)
    }
    #[inline(always)]
    fn choose(self, yes: Self, no: Self) -> Self {
        Self::pick(self.value, yes, no)
    }
}

impl<F: Real, const M: usize> Pair<Dual<F, M>> for Dual<F::Pair, M> {
    #[inline]
    fn couple(first: Dual<F, M>, second: Dual<F, M>) -> Self {
        let mut gradient = [F::Pair::zero(); M];
        for (pair, (d, e)) in gradient.iter_mut().zip(first.gradient.iter().zip(second.gradient)) {
            *pair = F::Pair::couple(*d, e);
        }
        Self { value: F::Pair::couple(first.value, second.value), gradient }
    }
    #[inline]
    fn parts(self) -> (Dual<F, M>, Dual<F, M>) {
        let (first, second) = self.value.parts();
        (
            Dual { value: first, gradient: F::each(&self.gradient, |slope| slope.parts().0) },
            Dual { value: second, gradient: F::each(&self.gradient, |slope| slope.parts().1) },
        )
    }
    #[inline]
    fn both(x: Dual<F, M>) -> Self {
        Self {
            value: F::Pair::both(x.value),
            gradient: F::Pair::each(&x.gradient, |d| F::Pair::both(*d)),
        }
    }
}

impl<F: Real, const M: usize> Number for Dual<F, M> {
    type Base = F;
    type Pair = Dual<F::Pair, M>;
    const DIRECTIONS: usize = M;
    const LANES: usize = F::LANES;
    const LARGEST: F = F::LARGEST;
    const TINY: F = F::TINY;
    const ROOT_TINY: F = F::ROOT_TINY;
    const HUGE: F = F::HUGE;
    const EPSILON: F = F::EPSILON;

    fn derivative(&self, direction: usize) -> F {
        self.gradient.get(direction).copied().unwrap_or(F::zero())
    }
    fn set_derivative(&mut self, direction: usize, derivative: F) {
        if let Some(place) = self.gradient.get_mut(direction) {
            *place = derivative;
        }
    }
    #[inline]
    fn exceeds(self, other: Self) -> bool {
        self.value.exceeds(other.value)
    }
}
