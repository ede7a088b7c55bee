//! The registers of the machine: what is computed side by side in one of them, and whether there
//! are wide ones.
//!
//! x86-64 has registers of 128 bits; those of 256 bits (AVX) are there on most processors, those of
//! 512 bits (AVX-512) on some, which are asked once. Everything here is the correctly rounded
//! operation of a plain number. What is `unsafe`: instructions on registers without memory access,
//! on machines that are known to have them.

#![allow(unsafe_code)]

#[inline]
fn one_exceeds<T: PartialOrd, const N: usize>(a: [T; N], b: [T; N]) -> bool {
    a.iter().zip(&b).fold(false, |any, (a, b)| any | (a > b))
}

#[inline]
fn each_between<T: PartialOrd, const N: usize>(a: [T; N], low: [T; N], high: [T; N]) -> bool {
    let bounds = low.iter().zip(&high);
    a.iter().zip(bounds).fold(true, |all, (a, (low, high))| all & (a >= low) & (a <= high))
}

#[cfg(not(target_arch = "x86_64"))]
impl<F: super::traits::Float> super::arithmetic::InRegisters for F {
    #[inline]
    fn any_exceeds<const N: usize>(a: [Self; N], b: [Self; N]) -> bool {
        one_exceeds(a, b)
    }
    #[inline]
    fn all_between<const N: usize>(a: [Self; N], low: [Self; N], high: [Self; N]) -> bool {
        each_between(a, low, high)
    }
}

/// Whether whole functions are compiled for wide registers too. Debug builds have only those for
/// narrow ones, with the same bits: both would take three times as long to compile. Release builds
/// prove what holds for wide registers.
#[cfg(target_arch = "x86_64")]
pub(crate) const HAS_WIDE_CODE: bool = cfg!(all(target_arch = "x86_64", not(debug_assertions)));

#[cfg(target_arch = "x86_64")]
cpufeatures::new!(avx, "avx");
#[cfg(target_arch = "x86_64")]
cpufeatures::new!(avx512, "avx512f", "avx512dq");

/// Whether the processor has registers of 256 bits and the system keeps them: asked once, because
/// under a hypervisor the question takes microseconds. This and [`has_avx512`] are all that the
/// library remembers, and no result depends on them.
#[cfg_attr(not(target_arch = "x86_64"), allow(dead_code))]
#[inline]
pub fn has_avx() -> bool {
    #[cfg(target_arch = "x86_64")]
    return avx::get();
    #[cfg(not(target_arch = "x86_64"))]
    false
}

/// The same of registers of 512 bits.
#[cfg_attr(not(target_arch = "x86_64"), allow(dead_code))]
#[inline]
pub fn has_avx512() -> bool {
    #[cfg(target_arch = "x86_64")]
    return avx512::get();
    #[cfg(not(target_arch = "x86_64"))]
    false
}

/// `with_avx!(if N => <T: Number>(a: A, b: B = value) -> R { code })`: code that is there once for
/// each kind of number `T`, for all callers, and once more for wide registers. With
/// `{ code } { other }` the other is that for wide registers. The code uses its arguments only: `a`
/// is the caller's variable of this name. Code of contacts side by side, `N` of them, stands inside
/// their caller, which is compiled for the registers.
macro_rules! with_avx {
    (@ $name:ident) => { $name };
    (@ $name:ident $value:expr) => { $value };
    (if $lanes:expr => <$($T:ident: $bound:path),*$(; $($N:ident),*)?>(
        $($name:ident: $type:ty $(= $value:expr)?),*
    ) -> $result:ty $code:block) => {
        $crate::number::avx::with_avx!(if $lanes => <$($T: $bound),*$(; $($N),*)?>(
            $($name: $type $(= $value)?),*
        ) -> $result $code $code)
    };
    (if $lanes:expr => <$($T:ident: $bound:path),*$(; $($N:ident),*)?>(
        $($name:ident: $type:ty $(= $value:expr)?),*
    ) -> $result:ty $code:block $wide:block) => {{
        #[cfg(target_arch = "x86_64")]
        #[target_feature(enable = "avx")]
        fn wide<$($T: $bound,)* $($(const $N: usize),*)?>($($name: $type),*) -> $result $wide
        #[inline(never)]
        fn narrow<$($T: $bound,)* $($(const $N: usize),*)?>($($name: $type),*) -> $result $code
        if $lanes > 1 {
            $(let $name: $type = $crate::number::avx::with_avx!(@ $name $($value)?);)*
            return $code;
        }
        // There is one call for both, which writes its result where the caller wants it.
        #[allow(unused_mut)]
        let mut code: unsafe fn($($type),*) -> $result = narrow;
        #[cfg(target_arch = "x86_64")]
        if $crate::number::avx::HAS_WIDE_CODE && $crate::number::avx::has_avx() {
            code = wide;
        }
        // SAFETY: the processor was asked.
        #[allow(unsafe_code)]
        unsafe {
            code($($crate::number::avx::with_avx!(@ $name $($value)?)),*)
        }
    }};
}
pub(crate) use with_avx;

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::{each_between, one_exceeds};
    use crate::number::arithmetic::{Arithmetic, InRegisters, each, each_chosen, each_pair};
    use crate::number::elementary::{NEWTON, NEWTON_START};
    use core::arch::x86_64::*;

    /// An array and a register of the same size.
    #[repr(C)]
    union Either<T: Copy, R: Copy> {
        from: T,
        to: R,
    }

    /// An array as a register of the same size, or back.
    ///
    /// # Safety
    /// Both have one size, or this is not reached.
    #[inline]
    unsafe fn cast<T: Copy, R: Copy>(from: T) -> R {
        // SAFETY: as said; any bits are a value of either.
        unsafe { Either { from }.to }
    }

    // SAFETY (of both macros): arithmetic on registers, no memory access; arrays of so many numbers
    // have their size. Those of 256 and 512 bits belong to callers who have asked.
    macro_rules! in_registers {
        ($n:literal $w:literal $v:literal $(
            $name:ident($a:ident $(, $b:ident)?)
            $narrow:expr, $wide:expr, $widest:expr, $each:ident $of:expr;
        )*) => {$(
            #[inline(always)]
            fn $name<const N: usize>($a: [Self; N] $(, $b: [Self; N])?) -> [Self; N] {
                match N {
                    $n => unsafe {
                        let ($a $(, $b)?,) = (cast($a) $(, cast($b))?,);
                        cast($narrow)
                    },
                    $w => unsafe {
                        let ($a $(, $b)?,) = (cast($a) $(, cast($b))?,);
                        cast($wide)
                    },
                    $v => unsafe {
                        let ($a $(, $b)?,) = (cast($a) $(, cast($b))?,);
                        cast($widest)
                    },
                    _ => $each($a $(, $b)?, |$a $(, $b)?| $of),
                }
            }
        )*};
    }

    macro_rules! registers {
        ($float:ident, $n:literal: $add:ident $sub:ident $mul:ident $div:ident $sqrt:ident
            $max:ident $min:ident $and:ident $andnot:ident $or:ident $xor:ident $greater:ident
            $set:ident;
            $w:literal: $wadd:ident $wsub:ident $wmul:ident $wdiv:ident $wsqrt:ident $wmax:ident
            $wmin:ident $wandnot:ident $wxor:ident $compare:ident $blend:ident $mask:ident
            $wset:ident;
            $v:literal: $vadd:ident $vsub:ident $vmul:ident $vdiv:ident $vsqrt:ident $vmax:ident
            $vmin:ident $vandnot:ident $vxor:ident $vcompare:ident $vblend:ident $vset:ident;
            { $($inverse_roots:item)* }) => {
            impl InRegisters for $float {
                $($inverse_roots)*
                in_registers! { $n $w $v
                    added(a, b) $add(a, b), $wadd(a, b), $vadd(a, b), each_pair a + b;
                    subtracted(a, b) $sub(a, b), $wsub(a, b), $vsub(a, b), each_pair a - b;
                    multiplied(a, b) $mul(a, b), $wmul(a, b), $vmul(a, b), each_pair a * b;
                    divided(a, b) $div(a, b), $wdiv(a, b), $vdiv(a, b), each_pair a / b;
                    larger(a, b) $max(a, b), $wmax(a, b), $vmax(a, b),
                        each_pair Arithmetic::max(a, b);
                    smaller(a, b) $min(a, b), $wmin(a, b), $vmin(a, b),
                        each_pair Arithmetic::min(a, b);
                    negated(a) $xor(a, $set(-0.0)), $wxor(a, $wset(-0.0)), $vxor(a, $vset(-0.0)),
                        each -a;
                    sizes(a) $andnot($set(-0.0), a), $wandnot($wset(-0.0), a),
                        $vandnot($vset(-0.0), a), each a.abs();
                    roots(a) $sqrt(a), $wsqrt(a), $vsqrt(a), each Arithmetic::sqrt(a);
                }
                #[inline]
                fn chosen<const N: usize>(
                    by: [Self; N],
                    yes: [Self; N],
                    no: [Self; N],
                ) -> [Self; N] {
                    match N {
                        $n => unsafe {
                            let mask = $greater(cast(by), $set(0.0));
                            cast($or($and(mask, cast(yes)), $andnot(mask, cast(no))))
                        },
                        $w => unsafe {
                            let mask = $compare::<_CMP_GT_OQ>(cast(by), $wset(0.0));
                            cast($blend(cast(no), cast(yes), mask))
                        },
                        $v => unsafe {
                            let mask = $vcompare::<_CMP_GT_OQ>(cast(by), $vset(0.0));
                            cast($vblend(mask, cast(no), cast(yes)))
                        },
                        _ => each_chosen(by, yes, no),
                    }
                }
                #[inline]
                fn any_exceeds<const N: usize>(a: [Self; N], b: [Self; N]) -> bool {
                    if N == $w {
                        return unsafe { $mask($compare::<_CMP_GT_OQ>(cast(a), cast(b))) != 0 };
                    }
                    if N == $v {
                        return unsafe { $vcompare::<_CMP_GT_OQ>(cast(a), cast(b)) != 0 };
                    }
                    one_exceeds(a, b)
                }
                #[inline]
                fn all_between<const N: usize>(
                    a: [Self; N],
                    low: [Self; N],
                    high: [Self; N],
                ) -> bool {
                    if N == $w {
                        const ALL: i32 = (1 << $w) - 1;
                        let low = unsafe { $mask($compare::<_CMP_GE_OQ>(cast(a), cast(low))) };
                        let high = unsafe { $mask($compare::<_CMP_LE_OQ>(cast(a), cast(high))) };
                        return (low & high) == ALL;
                    }
                    if N == $v {
                        let low = unsafe { $vcompare::<_CMP_GE_OQ>(cast(a), cast(low)) };
                        let high = unsafe { $vcompare::<_CMP_LE_OQ>(cast(a), cast(high)) };
                        return (low & high).count_ones() == $v;
                    }
                    each_between(a, low, high)
                }
            }
        };
    }

    registers!(f64, 2: _mm_add_pd _mm_sub_pd _mm_mul_pd _mm_div_pd _mm_sqrt_pd _mm_max_pd
    _mm_min_pd _mm_and_pd _mm_andnot_pd _mm_or_pd _mm_xor_pd _mm_cmpgt_pd _mm_set1_pd;
    4: _mm256_add_pd _mm256_sub_pd _mm256_mul_pd _mm256_div_pd _mm256_sqrt_pd _mm256_max_pd
    _mm256_min_pd _mm256_andnot_pd _mm256_xor_pd _mm256_cmp_pd _mm256_blendv_pd
    _mm256_movemask_pd _mm256_set1_pd;
    8: _mm512_add_pd _mm512_sub_pd _mm512_mul_pd _mm512_div_pd _mm512_sqrt_pd _mm512_max_pd
    _mm512_min_pd _mm512_andnot_pd _mm512_xor_pd _mm512_cmp_pd_mask _mm512_mask_blend_pd
    _mm512_set1_pd; {
        #[inline(always)]
        fn inverse_roots<const N: usize>(mut a: [Self; N]) -> [Self; N] {
            match N {
                2 => unsafe {
                    // Numbers fill both halves: nothing is divided by zeros of an empty one.
                    let x = cast(a);
                    let single = _mm_cvtpd_ps(x);
                    let y = _mm_cvtps_pd(started(_mm_movelh_ps(single, single)));
                    let rest = _mm_sub_pd(_mm_set1_pd(NEWTON), _mm_mul_pd(x, _mm_mul_pd(y, y)));
                    cast(_mm_mul_pd(y, rest))
                },
                4 => unsafe {
                    let x = cast(a);
                    let y = _mm256_cvtps_pd(started(_mm256_cvtpd_ps(x)));
                    let square = _mm256_mul_pd(y, y);
                    let rest = _mm256_sub_pd(_mm256_set1_pd(NEWTON), _mm256_mul_pd(x, square));
                    cast(_mm256_mul_pd(y, rest))
                },
                8 => unsafe {
                    let x = cast(a);
                    let single = _mm512_cvtpd_ps(x);
                    let start = _mm256_set1_ps(NEWTON_START);
                    let y = _mm512_cvtps_pd(_mm256_div_ps(start, _mm256_sqrt_ps(single)));
                    let square = _mm512_mul_pd(y, y);
                    let rest = _mm512_sub_pd(_mm512_set1_pd(NEWTON), _mm512_mul_pd(x, square));
                    cast(_mm512_mul_pd(y, rest))
                },
                _ => {
                    for a in &mut a {
                        *a = Arithmetic::inverse_root(*a);
                    }
                    a
                }
            }
        }
    });
    registers!(f32, 4: _mm_add_ps _mm_sub_ps _mm_mul_ps _mm_div_ps _mm_sqrt_ps _mm_max_ps
    _mm_min_ps _mm_and_ps _mm_andnot_ps _mm_or_ps _mm_xor_ps _mm_cmpgt_ps _mm_set1_ps;
    8: _mm256_add_ps _mm256_sub_ps _mm256_mul_ps _mm256_div_ps _mm256_sqrt_ps _mm256_max_ps
    _mm256_min_ps _mm256_andnot_ps _mm256_xor_ps _mm256_cmp_ps _mm256_blendv_ps
    _mm256_movemask_ps _mm256_set1_ps;
    16: _mm512_add_ps _mm512_sub_ps _mm512_mul_ps _mm512_div_ps _mm512_sqrt_ps _mm512_max_ps
    _mm512_min_ps _mm512_andnot_ps _mm512_xor_ps _mm512_cmp_ps_mask _mm512_mask_blend_ps
    _mm512_set1_ps; {
        #[inline(always)]
        fn inverse_roots<const N: usize>(a: [Self; N]) -> [Self; N] {
            Self::divided([1.0; N], Self::roots(a))
        }
    });

    /// `2^(−1/3)/√x` of four.
    #[inline]
    fn started(x: __m128) -> __m128 {
        // SAFETY: SSE2 is there.
        unsafe { _mm_div_ps(_mm_set1_ps(NEWTON_START), _mm_sqrt_ps(x)) }
    }
}
