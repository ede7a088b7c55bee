//! Two or four numbers side by side: what strips and layers of networks are computed in.

use super::{Arithmetic, Pair, Plain, Quad};
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// Two numbers of any kind, one after the other.
#[derive(Clone, Copy, Debug)]
pub struct Two<T>(T, T);

impl<T: Copy> Two<T> {
    /// Put two numbers side by side.
    #[inline(always)]
    pub(crate) fn side_by_side(first: T, second: T) -> Self {
        Self(first, second)
    }
    /// Take them apart.
    #[inline(always)]
    pub(crate) fn apart(self) -> [T; 2] {
        [self.0, self.1]
    }
}

/// Two doubles: one SSE2 register.
#[cfg(target_arch = "x86_64")]
#[derive(Clone, Copy, Debug)]
pub struct F64Pair(wide::f64x2);

/// Two doubles.
#[cfg(not(target_arch = "x86_64"))]
pub type F64Pair = Two<f64>;

/// Two single-precision numbers: half an SSE register, because that is what one instruction takes anyway.
#[cfg(target_arch = "x86_64")]
#[derive(Clone, Copy, Debug)]
pub struct F32Pair(wide::f32x4);

/// Two single-precision numbers.
#[cfg(not(target_arch = "x86_64"))]
pub type F32Pair = Two<f32>;

/// Four doubles: one register where the library is compiled for AVX, else two of SSE2.
#[cfg(target_arch = "x86_64")]
#[derive(Clone, Copy, Debug)]
pub struct F64Quad(wide::f64x4);

/// Four doubles.
#[cfg(not(target_arch = "x86_64"))]
pub type F64Quad = Two<F64Pair>;

/// Four single-precision numbers: one SSE register.
#[cfg(target_arch = "x86_64")]
#[derive(Clone, Copy, Debug)]
pub struct F32Quad(wide::f32x4);

/// Four single-precision numbers.
#[cfg(not(target_arch = "x86_64"))]
pub type F32Quad = Two<F32Pair>;

/// `2^(−1/3)`, to single precision.
pub(super) const NEWTON_START: f32 = 0.793_700_5;
/// `3 · 2^(−2/3)`
pub(super) const NEWTON: f64 = 1.889_881_574_842_309_7;

/// What [`F64Pair`] does to each of its numbers: the same operations, one by one.
///
/// `y ≈ 2^(−1/3)/√x` comes from single precision; `y (3 · 2^(−2/3) − x y²)` is then Newton's iteration for `1/√x`, never
/// above it but by rounding.
#[inline(always)]
pub(super) fn inverse_root_f64(x: f64) -> f64 {
    let y = f64::from(NEWTON_START / (x as f32).sqrt());
    y * (NEWTON - x * (y * y))
}

#[inline(always)]
pub(super) fn inverse_root_f32(x: f32) -> f32 {
    1.0 / x.sqrt()
}

macro_rules! operators {
    ([$($generics:tt)*] $pair:ty: |$a:ident, $b:ident| $add:expr, $sub:expr, $mul:expr, $div:expr, $neg:expr) => {
        impl<$($generics)*> Add for $pair {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                let ($a, $b) = (self, other);
                $add
            }
        }
        impl<$($generics)*> Sub for $pair {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                let ($a, $b) = (self, other);
                $sub
            }
        }
        impl<$($generics)*> Mul for $pair {
            type Output = Self;
            #[inline(always)]
            fn mul(self, other: Self) -> Self {
                let ($a, $b) = (self, other);
                $mul
            }
        }
        impl<$($generics)*> Div for $pair {
            type Output = Self;
            #[inline(always)]
            fn div(self, other: Self) -> Self {
                let ($a, $b) = (self, other);
                $div
            }
        }
        impl<$($generics)*> Neg for $pair {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                let $a = self;
                $neg
            }
        }
        impl<$($generics)*> AddAssign for $pair {
            #[inline(always)]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }
        impl<$($generics)*> SubAssign for $pair {
            #[inline(always)]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }
    };
}

#[cfg(target_arch = "x86_64")]
pub(super) use operators;

operators!([T: Arithmetic] Two<T>: |a, b|
    Two(a.0 + b.0, a.1 + b.1),
    Two(a.0 - b.0, a.1 - b.1),
    Two(a.0 * b.0, a.1 * b.1),
    Two(a.0 / b.0, a.1 / b.1),
    Two(-a.0, -a.1));

impl<T: Arithmetic> Arithmetic for Two<T> {
    type Base = T::Base;
    type Bare = Two<T::Bare>;

    #[inline(always)]
    fn from_base(x: T::Base) -> Self {
        Self(T::from_base(x), T::from_base(x))
    }
    #[inline(always)]
    fn bare(self) -> Two<T::Bare> {
        Two(self.0.bare(), self.1.bare())
    }
    #[inline(always)]
    fn composed<const N: usize>(
        value: Two<T::Bare>,
        slopes: [Two<T::Bare>; N],
        inputs: [Self; N],
    ) -> Self {
        Self(
            T::composed(value.0, slopes.map(|slope| slope.0), inputs.map(|input| input.0)),
            T::composed(value.1, slopes.map(|slope| slope.1), inputs.map(|input| input.1)),
        )
    }
    #[inline(always)]
    fn scale(self, factor: T::Base) -> Self {
        Self(self.0.scale(factor), self.1.scale(factor))
    }
    #[inline(always)]
    fn shift(self, term: T::Base) -> Self {
        Self(self.0.shift(term), self.1.shift(term))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt(), self.1.sqrt())
    }
    #[inline(always)]
    fn inverse_root(self) -> Self {
        let [first, second] = T::inverse_roots([self.0, self.1]);
        Self(first, second)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs(), self.1.abs())
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0), self.1.max(other.1))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(self.0.min(other.0), self.1.min(other.1))
    }
    #[inline(always)]
    fn choose(self, yes: Self, no: Self) -> Self {
        Self(self.0.choose(yes.0, no.0), self.1.choose(yes.1, no.1))
    }
    #[inline(always)]
    fn squared(self) -> Self {
        Self(self.0.squared(), self.1.squared())
    }
}

impl<T: Plain> Pair<T> for Two<T> {
    #[inline(always)]
    fn of(first: T, second: T) -> Self {
        Self(first, second)
    }
    #[inline(always)]
    fn parts(self) -> (T, T) {
        (self.0, self.1)
    }
}

impl<T: Plain> Quad<T> for Two<Two<T>>
where
    T: super::Number<Pair = Two<T>>,
{
    #[inline(always)]
    fn of_halves(first: Two<T>, second: Two<T>) -> Self {
        Self(first, second)
    }
    #[inline(always)]
    fn halves(self) -> [Two<T>; 2] {
        [self.0, self.1]
    }
    #[inline(always)]
    fn all(x: T) -> Self {
        Self(Two(x, x), Two(x, x))
    }
    #[inline(always)]
    fn plain([a, b, c, d]: [T; 4]) -> Self {
        Self(Two(a, b), Two(c, d))
    }
}

#[cfg(target_arch = "x86_64")]
mod registers {
    use super::{F32Pair, F32Quad, F64Pair, F64Quad, NEWTON, NEWTON_START};
    use crate::number::{Arithmetic, Pair, Quad};
    use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};
    use wide::{f32x4, f64x2, f64x4};

    macro_rules! register {
        ($pair:ident, $vector:ident, $float:ident, { $($special:item)* }) => {
            operators!([] $pair: |a, b|
                $pair(a.0 + b.0), $pair(a.0 - b.0), $pair(a.0 * b.0), $pair(a.0 / b.0), $pair(-a.0));

            impl Arithmetic for $pair {
                type Base = $float;
                type Bare = Self;

                #[inline(always)]
                fn from_base(x: $float) -> Self {
                    Self($vector::splat(x))
                }
                #[inline(always)]
                fn bare(self) -> Self {
                    self
                }
                #[inline(always)]
                fn composed<const N: usize>(value: Self, _: [Self; N], _: [Self; N]) -> Self {
                    value
                }
                #[inline(always)]
                fn scale(self, factor: $float) -> Self {
                    Self(self.0 * $vector::splat(factor))
                }
                #[inline(always)]
                fn shift(self, term: $float) -> Self {
                    Self(self.0 + $vector::splat(term))
                }
                #[inline(always)]
                fn sqrt(self) -> Self {
                    Self(self.0.sqrt())
                }
                #[inline(always)]
                fn abs(self) -> Self {
                    Self(self.0.abs())
                }
                #[inline(always)]
                fn max(self, other: Self) -> Self {
                    // `maxpd`: the second one where they are equal or one is not a number, as everywhere here
                    Self(self.0.fast_max(other.0))
                }
                #[inline(always)]
                fn min(self, other: Self) -> Self {
                    Self(self.0.fast_min(other.0))
                }
                #[inline(always)]
                fn choose(self, yes: Self, no: Self) -> Self {
                    Self(self.0.simd_gt($vector::splat(0.0)).select(yes.0, no.0))
                }
                $($special)*
            }
        };
    }

    register!(F64Pair, f64x2, f64, {
        /// Root and quotient of four numbers at once in single precision, where they cost a third, and one
        /// step of Newton's iteration in double precision. Nothing but correctly rounded operations: the same
        /// bits on every machine.
        #[inline(always)]
        fn inverse_roots<const N: usize>(mut numbers: [Self; N]) -> [Self; N] {
            let newton = |x: f64x2, first: f32, second: f32| {
                let y = f64x2::new([f64::from(first), f64::from(second)]);
                Self(y * (f64x2::splat(NEWTON) - x * (y * y)))
            };
            let mut couples = numbers.chunks_exact_mut(2);
            for couple in &mut couples {
                if let [a, b] = couple {
                    let ([a0, a1], [b0, b1]) = (a.0.to_array(), b.0.to_array());
                    let x = f32x4::new([a0 as f32, a1 as f32, b0 as f32, b1 as f32]);
                    let [a0, a1, b0, b1] = (f32x4::splat(NEWTON_START) / x.sqrt()).to_array();
                    (*a, *b) = (newton(a.0, a0, a1), newton(b.0, b0, b1));
                }
            }
            for single in couples.into_remainder() {
                *single = single.inverse_root();
            }
            numbers
        }
        #[inline(always)]
        fn inverse_root(self) -> Self {
            let (first, second) = self.parts();
            Self::of(first.inverse_root(), second.inverse_root())
        }
    });
    register!(F64Quad, f64x4, f64, {
        /// As pairs.
        #[inline(always)]
        fn inverse_root(self) -> Self {
            let x = self.0;
            let root = f32x4::new(x.to_array().map(|x| x as f32)).sqrt();
            let y = f64x4::new((f32x4::splat(NEWTON_START) / root).to_array().map(f64::from));
            Self(y * (f64x4::splat(NEWTON) - x * (y * y)))
        }
    });
    register!(F32Pair, f32x4, f32, {});
    register!(F32Quad, f32x4, f32, {});

    impl Pair<f64> for F64Pair {
        #[inline(always)]
        fn of(first: f64, second: f64) -> Self {
            Self(f64x2::new([first, second]))
        }
        #[inline(always)]
        fn parts(self) -> (f64, f64) {
            let [first, second] = self.0.to_array();
            (first, second)
        }
        #[inline(always)]
        fn scale_each(self, factors: [f64; 2]) -> Self {
            Self(self.0 * f64x2::new(factors))
        }
    }

    impl Pair<f32> for F32Pair {
        #[inline(always)]
        fn of(first: f32, second: f32) -> Self {
            // harmless numbers in the half that is not used
            Self(f32x4::new([first, second, 1.0, 1.0]))
        }
        #[inline(always)]
        fn parts(self) -> (f32, f32) {
            let [first, second, ..] = self.0.to_array();
            (first, second)
        }
        #[inline(always)]
        fn scale_each(self, [first, second]: [f32; 2]) -> Self {
            Self(self.0 * f32x4::new([first, second, 1.0, 1.0]))
        }
    }

    macro_rules! quad {
        ($quad:ident, $vector:ident, $pair:ident, $float:ident) => {
            impl Quad<$float> for $quad {
                #[inline(always)]
                fn of_halves(first: $pair, second: $pair) -> Self {
                    let ((a, b), (c, d)) = (first.parts(), second.parts());
                    Self::plain([a, b, c, d])
                }
                #[inline(always)]
                fn halves(self) -> [$pair; 2] {
                    let [a, b, c, d] = self.0.to_array();
                    [$pair::of(a, b), $pair::of(c, d)]
                }
                #[inline(always)]
                fn all(x: $float) -> Self {
                    Self($vector::splat(x))
                }
                #[inline(always)]
                fn plain(values: [$float; 4]) -> Self {
                    Self($vector::new(values))
                }
            }
        };
    }

    quad!(F64Quad, f64x4, F64Pair, f64);
    quad!(F32Quad, f32x4, F32Pair, f32);
}

#[cfg(all(test, target_arch = "x86_64"))]
#[path = "../../tests/units/pairs.rs"]
mod tests;
