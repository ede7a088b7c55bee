//! Numbers of several contacts side by side, in registers of 256 bits (AVX): four doubles or eight floats.
//!
//! Every operation is the correctly rounded one of a plain number, lane by lane, so the bits are those of the plain
//! number. Nothing here fuses a product with a sum.
//!
//! The compiler does not know that the processor has these registers: the file has `unsafe` code, which is sound where
//! AVX is there. Nobody makes such a number but `batch::side_by_side` and `strip::registers`,
//! which ask the processor first.

#![allow(unsafe_code)]

use super::pairs::{NEWTON, NEWTON_START, Two, operators};
use super::{Arithmetic, Map, Number, Plain};
use core::arch::x86_64::*;
use core::mem::transmute;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// `N` plain numbers side by side.
pub(crate) trait Lanes<const N: usize>: Plain {
    /// Side by side.
    fn of_array(numbers: [Self::Stored; N]) -> Self;
    /// One by one.
    fn array(self) -> [Self::Stored; N];
}

/// Four doubles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct F64x4(__m256d);

/// Eight single-precision numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct F32x8(__m256);

macro_rules! lanes {
    (
        $lanes:ident, $register:ident, $float:ident, $count:literal, $splat:ident, $add:ident, $sub:ident, $mul:ident, $div:ident,
        $sqrt:ident, $max:ident, $min:ident, $xor:ident, $andnot:ident, $compare:ident, $blend:ident, $mask:ident,
        |$x:ident| $inverse_root:expr, { $($special:item)* }
    ) => {
        // SAFETY (of this whole macro): arithmetic on registers, no memory access; with AVX, see above. The
        // registers have the layout of arrays.
        operators!([] $lanes: |a, b|
            $lanes(unsafe { $add(a.0, b.0) }),
            $lanes(unsafe { $sub(a.0, b.0) }),
            $lanes(unsafe { $mul(a.0, b.0) }),
            $lanes(unsafe { $div(a.0, b.0) }),
            $lanes(unsafe { $xor(a.0, $splat(-0.0)) }));

        impl $lanes {
            const fn splat(x: $float) -> Self {
                Self(unsafe { transmute::<[$float; $count], $register>([x; $count]) })
            }
        }

        impl Lanes<$count> for $lanes {
            #[inline(always)]
            fn of_array(numbers: [$float; $count]) -> Self {
                Self(unsafe { transmute::<[$float; $count], $register>(numbers) })
            }
            #[inline(always)]
            fn array(self) -> [$float; $count] {
                unsafe { transmute::<$register, [$float; $count]>(self.0) }
            }
        }

        impl Arithmetic for $lanes {
            type Base = Self;
            type Bare = Self;

            #[inline(always)]
            fn from_base(x: Self) -> Self {
                x
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
            fn scale(self, factor: Self) -> Self {
                self * factor
            }
            #[inline(always)]
            fn shift(self, term: Self) -> Self {
                self + term
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(unsafe { $sqrt(self.0) })
            }
            #[inline(always)]
            fn inverse_root(self) -> Self {
                let $x = self;
                $inverse_root
            }
            $($special)*
            #[inline(always)]
            fn abs(self) -> Self {
                Self(unsafe { $andnot($splat(-0.0), self.0) })
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                // the second one where they are equal or one is not a number, as everywhere here
                Self(unsafe { $max(self.0, other.0) })
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                Self(unsafe { $min(self.0, other.0) })
            }
            #[inline(always)]
            fn choose(self, yes: Self, no: Self) -> Self {
                Self(unsafe {
                    $blend(no.0, yes.0, $compare::<_CMP_GT_OQ>(self.0, $splat(0.0)))
                })
            }
        }

        impl Number for $lanes {
            type Pair = Two<Self>;
            type Quad = Two<Two<Self>>;
            const LANES: usize = $count;
            const LARGEST: Self = Self::splat(<$float as Number>::LARGEST);
            const TINY: Self = Self::splat(<$float as Number>::TINY);
            const ROOT_TINY: Self = Self::splat(<$float as Number>::ROOT_TINY);
            const HUGE: Self = Self::splat(<$float as Number>::HUGE);
            const EPSILON: Self = Self::splat(<$float as Number>::EPSILON);

            #[inline(always)]
            fn value(self) -> Self {
                self
            }
            #[inline(always)]
            fn map<const N: usize, const M: usize>(
                map: &impl Map<Self, N, M>,
                inputs: [Self; N],
            ) -> [Self; M] {
                map.value(inputs).0
            }
            #[inline(always)]
            fn exceeds(self, other: Self) -> bool {
                unsafe { $mask($compare::<_CMP_GT_OQ>(self.0, other.0)) != 0 }
            }
        }

        impl Plain for $lanes {
            type Stored = $float;

            #[inline(always)]
            fn of(x: f64) -> Self {
                Self::stored(x as $float)
            }
            #[inline(always)]
            fn stored(x: $float) -> Self {
                Self(unsafe { $splat(x) })
            }
            #[inline(always)]
            fn binary_quotient(self, divisor: Self) -> (Self, Self) {
                let (mut k, mut divisors) = (self.array(), divisor.array());
                for (k, divisor) in k.iter_mut().zip(&mut divisors) {
                    (*k, *divisor) = k.binary_quotient(*divisor);
                }
                (Self::of_array(k), Self::of_array(divisors))
            }
            #[inline(always)]
            fn lies_between(self, low: Self, high: Self) -> bool {
                const ALL: i32 = (1 << $count) - 1;
                let low = unsafe { $mask($compare::<_CMP_GE_OQ>(self.0, low.0)) };
                let high = unsafe { $mask($compare::<_CMP_LE_OQ>(self.0, high.0)) };
                (low & high) == ALL
            }
            #[inline(always)]
            fn lies_within(self, limit: Self) -> bool {
                self.lies_between(Self::splat(0.0), limit)
            }
            #[inline(always)]
            fn is_positive_number(self) -> bool {
                // (the smallest positive number, a subnormal one)
                self.lies_between(Self::splat($float::from_bits(1)), Self::splat($float::MAX))
            }
        }
    };
}

lanes!(
    F64x4,
    __m256d,
    f64,
    4,
    _mm256_set1_pd,
    _mm256_add_pd,
    _mm256_sub_pd,
    _mm256_mul_pd,
    _mm256_div_pd,
    _mm256_sqrt_pd,
    _mm256_max_pd,
    _mm256_min_pd,
    _mm256_xor_pd,
    _mm256_andnot_pd,
    _mm256_cmp_pd,
    _mm256_blendv_pd,
    _mm256_movemask_pd,
    |x| {
        let y = Self(unsafe {
            let root = _mm_sqrt_ps(_mm256_cvtpd_ps(x.0));
            _mm256_cvtps_pd(_mm_div_ps(_mm_set1_ps(NEWTON_START), root))
        });
        x.newton(y)
    },
    {
        /// Root and quotient of eight numbers at once: they take as long as those of four.
        #[inline(always)]
        fn inverse_roots<const N: usize>(mut numbers: [Self; N]) -> [Self; N] {
            let mut couples = numbers.chunks_exact_mut(2);
            for couple in &mut couples {
                if let [a, b] = couple {
                    let (first, second) = unsafe {
                        let x = _mm256_set_m128(_mm256_cvtpd_ps(b.0), _mm256_cvtpd_ps(a.0));
                        let y = _mm256_div_ps(_mm256_set1_ps(NEWTON_START), _mm256_sqrt_ps(x));
                        let (low, high) =
                            (_mm256_castps256_ps128(y), _mm256_extractf128_ps::<1>(y));
                        (_mm256_cvtps_pd(low), _mm256_cvtps_pd(high))
                    };
                    (*a, *b) = (a.newton(Self(first)), b.newton(Self(second)));
                }
            }
            for single in couples.into_remainder() {
                *single = single.inverse_root();
            }
            numbers
        }
    }
);
lanes!(
    F32x8,
    __m256,
    f32,
    8,
    _mm256_set1_ps,
    _mm256_add_ps,
    _mm256_sub_ps,
    _mm256_mul_ps,
    _mm256_div_ps,
    _mm256_sqrt_ps,
    _mm256_max_ps,
    _mm256_min_ps,
    _mm256_xor_ps,
    _mm256_andnot_ps,
    _mm256_cmp_ps,
    _mm256_blendv_ps,
    _mm256_movemask_ps,
    |x| Self::one() / x.sqrt(),
    {}
);

impl F64x4 {
    /// `1/√x` from that of single precision times `2^(−1/3)`, as `pairs::inverse_root_f64`.
    #[inline(always)]
    fn newton(self, y: Self) -> Self {
        y * (Self::of(NEWTON) - self * (y * y))
    }
}
