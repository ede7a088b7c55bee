//! Forward-mode differentiation: numbers that carry their derivatives.
//!
//! A [`Dual`] is a value with its derivatives with respect to `M` inputs. Run through the same
//! generic formulas as a plain number it returns the exact derivatives of what those formulas
//! compute, branch by branch; there is no step size and no second implementation to keep in step.

use crate::number::{Arithmetic, Float, Map, Number, Pair, Quad};
use core::cmp::Ordering;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A value and its derivatives with respect to `M` inputs: plain numbers, or pairs of them, so that registers for pairs are
/// full whatever `M` is.
#[derive(Clone, Copy, Debug)]
pub struct Dual<P, const M: usize> {
    /// The value.
    pub value: P,
    /// Its derivatives.
    pub gradient: [P; M],
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
}

impl<P: Arithmetic<Bare = P>, const M: usize> Dual<P, M> {
    /// A function of this number: its value, and its slope times the derivatives.
    fn chain(self, value: P, slope: P) -> Self {
        Self { value, gradient: self.gradient.map(|d| d * slope) }
    }

    fn combine(self, other: Self, value: P, by_self: P, by_other: P) -> Self {
        let mut gradient = self.gradient;
        for (own, other) in gradient.iter_mut().zip(other.gradient) {
            *own = *own * by_self + other * by_other;
        }
        Self { value, gradient }
    }

    /// `yes` where the test is positive, else `no`.
    fn pick(test: P, yes: Self, no: Self) -> Self {
        let mut gradient = no.gradient;
        for (own, other) in gradient.iter_mut().zip(yes.gradient) {
            *own = test.choose(other, *own);
        }
        Self { value: test.choose(yes.value, no.value), gradient }
    }
}

impl<F: Float, const M: usize> PartialEq for Dual<F, M> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<F: Float, const M: usize> PartialOrd for Dual<F, M> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<P: Arithmetic<Bare = P>, const M: usize> Add for Dual<P, M> {
    type Output = Self;
    fn add(mut self, other: Self) -> Self {
        self += other;
        self
    }
}

impl<P: Arithmetic<Bare = P>, const M: usize> Sub for Dual<P, M> {
    type Output = Self;
    fn sub(mut self, other: Self) -> Self {
        self -= other;
        self
    }
}

impl<P: Arithmetic<Bare = P>, const M: usize> AddAssign for Dual<P, M> {
    fn add_assign(&mut self, other: Self) {
        self.value += other.value;
        for (own, other) in self.gradient.iter_mut().zip(other.gradient) {
            *own += other;
        }
    }
}

impl<P: Arithmetic<Bare = P>, const M: usize> SubAssign for Dual<P, M> {
    fn sub_assign(&mut self, other: Self) {
        self.value -= other.value;
        for (own, other) in self.gradient.iter_mut().zip(other.gradient) {
            *own -= other;
        }
    }
}

impl<P: Arithmetic<Bare = P>, const M: usize> Mul for Dual<P, M> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.combine(other, self.value * other.value, other.value, self.value)
    }
}

impl<P: Arithmetic<Bare = P>, const M: usize> Div for Dual<P, M> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let inverse = P::one() / other.value;
        self.combine(other, quotient, inverse, -(quotient * inverse))
    }
}

impl<P: Arithmetic<Bare = P>, const M: usize> Neg for Dual<P, M> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, gradient: self.gradient.map(|d| -d) }
    }
}

impl<P: Arithmetic<Bare = P>, const M: usize> Arithmetic for Dual<P, M> {
    type Base = P::Base;
    type Bare = P;

    fn from_base(value: P::Base) -> Self {
        Self { value: P::from_base(value), gradient: [P::zero(); M] }
    }
    fn bare(self) -> P {
        self.value
    }
    fn composed<const N: usize>(value: P, slopes: [P; N], inputs: [Self; N]) -> Self {
        let mut terms = slopes.into_iter().zip(inputs);
        let Some((slope, input)) = terms.next() else {
            return Self { value, gradient: [P::zero(); M] };
        };
        let mut gradient = input.gradient.map(|d| d * slope);
        for (slope, input) in terms {
            for (own, d) in gradient.iter_mut().zip(input.gradient) {
                *own += d * slope;
            }
        }
        Self { value, gradient }
    }
    fn inverse(self) -> Self {
        let inverse = P::one() / self.value;
        self.chain(inverse, -(inverse * inverse))
    }
    fn scale(self, factor: P::Base) -> Self {
        Self { value: self.value.scale(factor), gradient: self.gradient.map(|d| d.scale(factor)) }
    }
    fn shift(mut self, term: P::Base) -> Self {
        self.value = self.value.shift(term);
        self
    }
    fn squared(self) -> Self {
        self.chain(self.value * self.value, self.value + self.value)
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, P::constant(0.5) / root.max(P::tiny()))
    }
    fn inverse_root(self) -> Self {
        let y = self.value.inverse_root();
        self.chain(y, (y * (y * y)).times(-0.5))
    }
    fn abs(self) -> Self {
        let negative = -self.value;
        let value = negative.choose(negative, self.value);
        Self { value, gradient: self.gradient.map(|d| negative.choose(-d, d)) }
    }
    fn max(self, other: Self) -> Self {
        Self::pick(self.value - other.value, self, other)
    }
    fn min(self, other: Self) -> Self {
        Self::pick(other.value - self.value, self, other)
    }
    fn choose(self, yes: Self, no: Self) -> Self {
        Self::pick(self.value, yes, no)
    }
}

impl<F: Float, const M: usize> Pair<Dual<F, M>> for Dual<F::Pair, M> {
    fn of(first: Dual<F, M>, second: Dual<F, M>) -> Self {
        let mut gradient = [F::Pair::zero(); M];
        for (pair, (d, e)) in gradient.iter_mut().zip(first.gradient.iter().zip(second.gradient)) {
            *pair = F::Pair::of(*d, e);
        }
        Self { value: F::Pair::of(first.value, second.value), gradient }
    }
    fn parts(self) -> (Dual<F, M>, Dual<F, M>) {
        let (first, second) = self.value.parts();
        let slopes = self.gradient.map(F::Pair::parts);
        (
            Dual { value: first, gradient: slopes.map(|slope| slope.0) },
            Dual { value: second, gradient: slopes.map(|slope| slope.1) },
        )
    }
    fn both(x: Dual<F, M>) -> Self {
        Self { value: F::Pair::both(x.value), gradient: x.gradient.map(F::Pair::both) }
    }
    fn scale_each(self, factors: [F; 2]) -> Self {
        Self {
            value: self.value.scale_each(factors),
            gradient: self.gradient.map(|d| d.scale_each(factors)),
        }
    }
    fn plain([first, second]: [F; 2]) -> Self {
        Self { value: F::Pair::of(first, second), gradient: [F::Pair::zero(); M] }
    }
}

impl<F: Float, const M: usize> Quad<Dual<F, M>> for Dual<F::Quad, M> {
    fn of_halves(first: Dual<F::Pair, M>, second: Dual<F::Pair, M>) -> Self {
        let mut gradient = [F::Quad::zero(); M];
        for (quad, (d, e)) in gradient.iter_mut().zip(first.gradient.iter().zip(second.gradient)) {
            *quad = F::Quad::of_halves(*d, e);
        }
        Self { value: F::Quad::of_halves(first.value, second.value), gradient }
    }
    fn halves(self) -> [Dual<F::Pair, M>; 2] {
        let slopes = self.gradient.map(F::Quad::halves);
        let [first, second] = self.value.halves();
        [
            Dual { value: first, gradient: slopes.map(|[slope, _]| slope) },
            Dual { value: second, gradient: slopes.map(|[_, slope]| slope) },
        ]
    }
    fn all(x: Dual<F, M>) -> Self {
        Self { value: F::Quad::all(x.value), gradient: x.gradient.map(F::Quad::all) }
    }
    fn plain(values: [F; 4]) -> Self {
        Self { value: F::Quad::plain(values), gradient: [F::Quad::zero(); M] }
    }
}

impl<F: Float, const M: usize> Number for Dual<F, M> {
    type Pair = Dual<F::Pair, M>;
    type Quad = Dual<F::Quad, M>;
    const HAS_DERIVATIVES: bool = true;
    const LARGEST: F = F::LARGEST;
    const TINY: F = F::TINY;
    const ROOT_TINY: F = F::ROOT_TINY;
    const HUGE: F = F::HUGE;
    const EPSILON: F = F::EPSILON;

    fn value(self) -> F {
        self.value
    }
    /// (In the code of the caller, which may have wide registers.)
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
    fn exceeds(self, other: Self) -> bool {
        self.value > other.value
    }
}
