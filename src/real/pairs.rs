//! Two numbers side by side: what the strips of a panel are computed in.

use super::{Arithmetic, Pair, Plain};
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// Two numbers of any kind, one after the other.
#[derive(Clone, Copy, Debug)]
pub struct Two<T>(T, T);

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

/// What [`F64Pair`] does to each of four numbers: the same operations, one by one.
#[inline(always)]
pub(super) fn inverse_root_f64(x: f64) -> f64 {
    let y = f64::from(1.0 / (x as f32).sqrt());
    y * (1.5 - x * y * (y * 0.5))
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

operators!([T: Plain] Two<T>: |a, b|
    Two(a.0 + b.0, a.1 + b.1),
    Two(a.0 - b.0, a.1 - b.1),
    Two(a.0 * b.0, a.1 * b.1),
    Two(a.0 / b.0, a.1 / b.1),
    Two(-a.0, -a.1));

impl<T: Plain> Arithmetic for Two<T> {
    type Base = T;
    type Bare = Self;

    #[inline(always)]
    fn from_base(x: T) -> Self {
        Self::both(x)
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
    fn scale(self, factor: T) -> Self {
        Self(self.0.scale(factor), self.1.scale(factor))
    }
    #[inline(always)]
    fn shift(self, term: T) -> Self {
        Self(self.0.shift(term), self.1.shift(term))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt(), self.1.sqrt())
    }
    /// Two pairs at a time take the short way, one that is left the long one: as on machines with registers
    /// for two doubles, so that the bits are the same.
    #[inline(always)]
    fn inverse_roots<const N: usize>(mut numbers: [Self; N]) -> [Self; N] {
        let mut couples = numbers.chunks_exact_mut(2);
        for couple in &mut couples {
            for pair in couple {
                *pair = Self(pair.0.paired_inverse_root(), pair.1.paired_inverse_root());
            }
        }
        for single in couples.into_remainder() {
            *single = Self::one() / single.sqrt();
        }
        numbers
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

#[cfg(target_arch = "x86_64")]
mod sse2 {
    use super::{F32Pair, F64Pair};
    use crate::real::{Arithmetic, Pair};
    use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};
    use wide::{f32x4, f64x2};

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
                // y (3 − x y²)/2, never above the root's inverse but by rounding
                Self(y * (f64x2::splat(1.5) - x * y * (y * f64x2::splat(0.5))))
            };
            let mut couples = numbers.chunks_exact_mut(2);
            for couple in &mut couples {
                if let [a, b] = couple {
                    let ([a0, a1], [b0, b1]) = (a.0.to_array(), b.0.to_array());
                    let x = f32x4::new([a0 as f32, a1 as f32, b0 as f32, b1 as f32]);
                    let [a0, a1, b0, b1] = (f32x4::ONE / x.sqrt()).to_array();
                    (*a, *b) = (newton(a.0, a0, a1), newton(b.0, b0, b1));
                }
            }
            for single in couples.into_remainder() {
                *single = Self::one() / single.sqrt();
            }
            numbers
        }
    });
    register!(F32Pair, f32x4, f32, {});

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
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::*;

    macro_rules! agree {
        ($registers:ident, $float:ident) => {{
            let numbers: [$float; 12] = [
                0.0,
                -0.0,
                1.0,
                -1.0,
                0.3,
                -7.1e-5,
                2.9e11,
                3e-30,
                -3e-30,
                1e-45,
                1e30,
                -1.0 / 3.0,
            ];
            let bits = |(first, second): ($float, $float)| [first.to_bits(), second.to_bits()];
            for x in numbers {
                for y in numbers {
                    let (a, b) = ($registers::of(x, y), $registers::of(y, 0.7));
                    let (c, d) = (Two::of(x, y), Two::of(y, 0.7));
                    let registers =
                        [a + b, a - b, a * b, -a, a.abs(), a.max(b), a.min(b), a.choose(b, a)];
                    let plain =
                        [c + d, c - d, c * d, -c, c.abs(), c.max(d), c.min(d), c.choose(d, c)];
                    for (i, (one, two)) in registers.iter().zip(&plain).enumerate() {
                        assert_eq!(
                            bits(one.parts()),
                            bits(two.parts()),
                            "operation {i} of {x} {y}"
                        );
                    }
                    if x > 1e-30 && y > 1e-30 && x < 1e30 && y < 1e30 {
                        assert_eq!(bits((a / b).parts()), bits((c / d).parts()));
                        assert_eq!(bits(a.sqrt().parts()), bits(c.sqrt().parts()));
                        let one = $registers::inverse_roots([a, b, a]);
                        let two = Two::inverse_roots([c, d, c]);
                        for (one, two) in one.iter().zip(&two) {
                            assert_eq!(bits(one.parts()), bits(two.parts()), "roots of {x} {y}");
                        }
                    }
                }
            }
        }};
    }

    /// Registers and plain pairs give the same bits, signs of zeros included.
    #[test]
    fn registers_and_plain_pairs_agree() {
        agree!(F64Pair, f64);
        agree!(F32Pair, f32);
    }
}
