//! Forward-mode differentiation: numbers that carry their derivatives.
//!
//! A [`Dual`] is a value with its derivatives with respect to `M` inputs. Run through the same
//! generic formulas as a plain number it returns the exact derivatives of what those formulas
//! compute, branch by branch; there is no step size and no second implementation to keep in step.

use crate::real::pairs::Two;
use crate::real::{Arithmetic, Elementary, Float, Map, Number};
use core::cmp::Ordering;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A value and its derivatives with respect to `M` inputs.
#[derive(Clone, Copy, Debug)]
pub struct Dual<F, const M: usize> {
    /// The value.
    pub value: F,
    /// Its derivatives.
    pub gradient: [F; M],
}

impl<F: Float, const M: usize> Dual<F, M> {
    /// The input number `index`: its derivative with respect to itself is one.
    #[must_use]
    pub fn input(value: F, index: usize) -> Self {
        let mut gradient = [F::zero(); M];
        if let Some(own) = gradient.get_mut(index) {
            *own = F::one();
        }
        Self { value, gradient }
    }

    /// A function of this number: its value, and its slope times the derivatives.
    #[inline(always)]
    fn chain(self, value: F, slope: F) -> Self {
        Self { value, gradient: self.gradient.map(|d| d * slope) }
    }

    #[inline(always)]
    fn combine(self, other: Self, value: F, by_self: F, by_other: F) -> Self {
        let mut gradient = self.gradient;
        for (own, other) in gradient.iter_mut().zip(other.gradient) {
            *own = *own * by_self + other * by_other;
        }
        Self { value, gradient }
    }
}

impl<F: Float, const M: usize> PartialEq for Dual<F, M> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<F: Float, const M: usize> PartialOrd for Dual<F, M> {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<F: Float, const M: usize> Add for Dual<F, M> {
    type Output = Self;
    #[inline(always)]
    fn add(mut self, other: Self) -> Self {
        self += other;
        self
    }
}

impl<F: Float, const M: usize> Sub for Dual<F, M> {
    type Output = Self;
    #[inline(always)]
    fn sub(mut self, other: Self) -> Self {
        self -= other;
        self
    }
}

impl<F: Float, const M: usize> AddAssign for Dual<F, M> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        self.value += other.value;
        for (own, other) in self.gradient.iter_mut().zip(other.gradient) {
            *own += other;
        }
    }
}

impl<F: Float, const M: usize> SubAssign for Dual<F, M> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        self.value -= other.value;
        for (own, other) in self.gradient.iter_mut().zip(other.gradient) {
            *own -= other;
        }
    }
}

impl<F: Float, const M: usize> Mul for Dual<F, M> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.combine(other, self.value * other.value, other.value, self.value)
    }
}

impl<F: Float, const M: usize> Div for Dual<F, M> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let inverse = F::one() / other.value;
        self.combine(other, quotient, inverse, -(quotient * inverse))
    }
}

impl<F: Float, const M: usize> Neg for Dual<F, M> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { value: -self.value, gradient: self.gradient.map(|d| -d) }
    }
}

impl<F: Float, const M: usize> Arithmetic for Dual<F, M> {
    type Base = F;

    #[inline(always)]
    fn from_base(value: F) -> Self {
        Self { value, gradient: [F::zero(); M] }
    }
    #[inline(always)]
    fn scale(self, factor: F) -> Self {
        self.chain(self.value * factor, factor)
    }
    #[inline(always)]
    fn shift(mut self, term: F) -> Self {
        self.value += term;
        self
    }
    #[inline(always)]
    fn squared(self) -> Self {
        self.chain(self.value * self.value, self.value + self.value)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, F::of(0.5) / root.max(F::TINY))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        if self.value < F::zero() { -self } else { self }
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self.value > other.value { self } else { other }
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self.value < other.value { self } else { other }
    }
    #[inline(always)]
    fn choose(self, yes: Self, no: Self) -> Self {
        if self.value > F::zero() { yes } else { no }
    }
}

impl<F: Float, const M: usize> Number for Dual<F, M> {
    type Pair = Two<Self>;
    const HAS_DERIVATIVES: bool = true;
    const LARGEST: F = F::LARGEST;
    const TINY: F = F::TINY;
    const ROOT_TINY: F = F::ROOT_TINY;
    const HUGE: F = F::HUGE;
    const EPSILON: F = F::EPSILON;

    #[inline(always)]
    fn value(self) -> F {
        self.value
    }
    #[inline(always)]
    fn map<const N: usize, const K: usize>(
        map: &impl Map<F, N, K>,
        inputs: [Self; N],
    ) -> [Self; K] {
        let (values, place) = map.value(inputs.map(|x| x.value));
        let mut outputs = values.map(Self::from_base);
        for direction in 0..M {
            let along = |x: Self| x.gradient.get(direction).copied().unwrap_or(F::zero());
            let tangent = map.tangent(&place, inputs.map(along));
            for (output, own) in outputs.iter_mut().zip(tangent) {
                if let Some(derivative) = output.gradient.get_mut(direction) {
                    *derivative = own;
                }
            }
        }
        outputs
    }
    #[inline(always)]
    fn exceeds(self, other: Self) -> bool {
        self.value > other.value
    }
}

impl<F: Float, const M: usize> Elementary for Dual<F, M> {
    #[inline]
    fn atan(self) -> Self {
        self.chain(self.value.atan(), F::one() / (F::one() + self.value * self.value))
    }
    #[inline]
    fn ln(self) -> Self {
        self.chain(self.value.ln(), F::one() / self.value)
    }
    #[inline]
    fn asinh(self) -> Self {
        self.chain(self.value.asinh(), F::one() / (F::one() + self.value * self.value).sqrt())
    }
}
