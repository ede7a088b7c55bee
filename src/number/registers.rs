//! The registers of the machine: what is computed side by side in one of them, and whether there
//! are wide ones.
//!
//! x86-64 has registers of 128 bits; those of 256 bits (AVX) are there on most processors, which
//! are asked once. Everything here is the correctly rounded operation of a plain number. What is
//! `unsafe`: instructions on registers without memory access, on machines that are known to have
//! them.

#![allow(unsafe_code)]

use super::Arithmetic;

pub(super) use self::root::{of_f32, of_f64};

/// `2^(−1/3)`, to single precision.
pub(super) const NEWTON_START: f32 = 0.793_700_5;
/// `3 · 2^(−2/3)`
pub(super) const NEWTON: f64 = 1.889_881_574_842_309_7;

/// Numbers that stand side by side in an array: one by one, and in a register where there is one
/// for so many.
pub trait InRegisters: Arithmetic<Value = Self> {
    /// `+ − × ÷` of each and its neighbour, the larger `>` or the smaller `<` of both; of the first
    /// alone its opposite `~`, its size `|` or its root `√`.
    #[inline(always)]
    fn apply<const OPERATION: char, const N: usize>(a: [Self; N], b: [Self; N]) -> [Self; N] {
        one_by_one::<Self, OPERATION, N>(a, b)
    }
    /// `1/√x`, as [`Arithmetic::inverse_root`].
    #[inline(always)]
    fn inverse_roots<const N: usize>(mut a: [Self; N]) -> [Self; N] {
        for a in &mut a {
            *a = a.inverse_root();
        }
        a
    }
    /// `yes` where a number is positive, else `no`.
    #[inline(always)]
    fn chosen<const N: usize>(by: [Self; N], yes: [Self; N], no: [Self; N]) -> [Self; N] {
        chosen_one_by_one(by, yes, no)
    }
    /// Whether one is larger than its neighbour.
    fn any_exceeds<const N: usize>(a: [Self; N], b: [Self; N]) -> bool;
    /// Whether all lie between others.
    fn all_between<const N: usize>(a: [Self; N], low: [Self; N], high: [Self; N]) -> bool;
}

/// [`InRegisters::apply`] without registers: pairs straight on, more in a loop. The second one is
/// the larger and the smaller where both are equal or one is not a number.
#[inline(always)]
fn one_by_one<T: Arithmetic, const OPERATION: char, const N: usize>(
    mut a: [T; N],
    b: [T; N],
) -> [T; N] {
    let of = |a: T, b: T| match OPERATION {
        '+' => a + b,
        '−' => a - b,
        '×' => a * b,
        '÷' => a / b,
        '>' => a.max(b),
        '<' => a.min(b),
        '~' => -a,
        '|' => a.abs(),
        _ => a.sqrt(),
    };
    if let ([a0, a1], [b0, b1]) = (&mut a[..], &b[..]) {
        (*a0, *a1) = (of(*a0, *b0), of(*a1, *b1));
        return a;
    }
    for (a, b) in a.iter_mut().zip(b) {
        *a = of(*a, b);
    }
    a
}

#[inline(always)]
fn chosen_one_by_one<T: Arithmetic, const N: usize>(
    by: [T; N],
    yes: [T; N],
    mut no: [T; N],
) -> [T; N] {
    for ((no, by), yes) in no.iter_mut().zip(by).zip(yes) {
        *no = by.choose(yes, *no);
    }
    no
}

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
impl<F: super::Float> InRegisters for F {
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

/// Whether there are registers of 256 bits.
#[cfg_attr(not(target_arch = "x86_64"), allow(dead_code))]
#[inline]
pub(crate) fn has_avx() -> bool {
    #[cfg(target_arch = "x86_64")]
    return x86::has_avx();
    #[cfg(not(target_arch = "x86_64"))]
    false
}

/// `with_avx!(if N => <T: Number>(a: A, b: B = value) -> R { code })`: code that is there once for
/// each kind of number `T`, whoever calls it, and once more for wide registers. With
/// `{ code } { other }` the other is that for wide registers. The code sees its arguments only: `a`
/// is the caller's variable of this name. Code of contacts side by side, `N` of them, stands inside
/// their caller, who knows the registers.
macro_rules! with_avx {
    (@ $name:ident) => { $name };
    (@ $name:ident $value:expr) => { $value };
    (if $lanes:expr => <$($T:ident: $bound:path),*$(; $($N:ident),*)?>(
        $($name:ident: $type:ty $(= $value:expr)?),*
    ) -> $result:ty $code:block) => {
        $crate::number::registers::with_avx!(if $lanes => <$($T: $bound),*$(; $($N),*)?>(
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
            $(let $name: $type = $crate::number::registers::with_avx!(@ $name $($value)?);)*
            return $code;
        }
        // (one call for both, which writes its result where the caller wants it)
        #[allow(unused_mut)]
        let mut code: unsafe fn($($type),*) -> $result = narrow;
        #[cfg(target_arch = "x86_64")]
        if $crate::number::registers::HAS_WIDE_CODE && $crate::number::registers::has_avx() {
            code = wide;
        }
        // SAFETY: the processor was asked.
        #[allow(unsafe_code)]
        unsafe {
            code($($crate::number::registers::with_avx!(@ $name $($value)?)),*)
        }
    }};
}
pub(crate) use with_avx;

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::{
        InRegisters, NEWTON, NEWTON_START, chosen_one_by_one, each_between, one_by_one, one_exceeds,
    };
    use crate::number::Arithmetic;
    use core::arch::x86_64::*;

    cpufeatures::new!(avx, "avx");

    /// Whether the processor has registers of 256 bits and the system keeps them: asked once,
    /// because under a hypervisor the question takes microseconds. It is the only thing that the
    /// library remembers, and no result depends on it.
    #[inline]
    pub fn has_avx() -> bool {
        avx::get()
    }

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

    // SAFETY (of the macro): arithmetic on registers, no memory access; arrays of so many numbers
    // have their size. Those of 256 bits belong to callers who have asked.
    macro_rules! registers {
        ($float:ident, $n:literal: $add:ident $sub:ident $mul:ident $div:ident $sqrt:ident
            $max:ident $min:ident $and:ident $andnot:ident $or:ident $xor:ident $greater:ident
            $set:ident;
            $w:literal: $wadd:ident $wsub:ident $wmul:ident $wdiv:ident $wsqrt:ident $wmax:ident
            $wmin:ident $wandnot:ident $wxor:ident $compare:ident $blend:ident $mask:ident
            $wset:ident; { $($inverse_roots:item)* }) => {
            impl InRegisters for $float {
                $($inverse_roots)*
                #[inline(always)]
                fn apply<const OPERATION: char, const N: usize>(
                    a: [Self; N],
                    b: [Self; N],
                ) -> [Self; N] {
                    match N {
                        $n => unsafe {
                            let (a, b) = (cast(a), cast(b));
                            cast(match OPERATION {
                                '+' => $add(a, b),
                                '−' => $sub(a, b),
                                '×' => $mul(a, b),
                                '÷' => $div(a, b),
                                '>' => $max(a, b),
                                '<' => $min(a, b),
                                '~' => $xor(a, $set(-0.0)),
                                '|' => $andnot($set(-0.0), a),
                                _ => $sqrt(a),
                            })
                        },
                        $w => unsafe {
                            let (a, b) = (cast(a), cast(b));
                            cast(match OPERATION {
                                '+' => $wadd(a, b),
                                '−' => $wsub(a, b),
                                '×' => $wmul(a, b),
                                '÷' => $wdiv(a, b),
                                '>' => $wmax(a, b),
                                '<' => $wmin(a, b),
                                '~' => $wxor(a, $wset(-0.0)),
                                '|' => $wandnot($wset(-0.0), a),
                                _ => $wsqrt(a),
                            })
                        },
                        _ => one_by_one::<Self, OPERATION, N>(a, b),
                    }
                }
                #[inline(always)]
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
                        _ => chosen_one_by_one(by, yes, no),
                    }
                }
                #[inline(always)]
                fn any_exceeds<const N: usize>(a: [Self; N], b: [Self; N]) -> bool {
                    if N == $w {
                        return unsafe { $mask($compare::<_CMP_GT_OQ>(cast(a), cast(b))) != 0 };
                    }
                    one_exceeds(a, b)
                }
                #[inline(always)]
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
                    each_between(a, low, high)
                }
            }
        };
    }

    registers!(f64, 2: _mm_add_pd _mm_sub_pd _mm_mul_pd _mm_div_pd _mm_sqrt_pd _mm_max_pd
    _mm_min_pd _mm_and_pd _mm_andnot_pd _mm_or_pd _mm_xor_pd _mm_cmpgt_pd _mm_set1_pd;
    4: _mm256_add_pd _mm256_sub_pd _mm256_mul_pd _mm256_div_pd _mm256_sqrt_pd _mm256_max_pd
    _mm256_min_pd _mm256_andnot_pd _mm256_xor_pd _mm256_cmp_pd _mm256_blendv_pd
    _mm256_movemask_pd _mm256_set1_pd; {
        #[inline(always)]
        fn inverse_roots<const N: usize>(mut a: [Self; N]) -> [Self; N] {
            match N {
                2 => unsafe {
                    // (twice in one register: nothing is divided by the zeros of an empty half)
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
    _mm256_movemask_ps _mm256_set1_ps; {
        #[inline(always)]
        fn inverse_roots<const N: usize>(a: [Self; N]) -> [Self; N] {
            Self::apply::<'÷', N>([1.0; N], Self::apply::<'√', N>(a, a))
        }
    });

    /// `2^(−1/3)/√x` of four.
    #[inline]
    fn started(x: __m128) -> __m128 {
        // SAFETY: SSE2 is there.
        unsafe { _mm_div_ps(_mm_set1_ps(NEWTON_START), _mm_sqrt_ps(x)) }
    }
}

/// The square root instruction of the machine.
///
/// The theory is made of square roots, and stable Rust has none in `core`. libm's is inline
/// assembly on x86-64, which no compiler vectorises, and software on a Cortex-M with a
/// floating-point unit (66 instructions instead of one).
mod root {
    /// Square root in double precision.
    #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
    #[inline]
    pub(in crate::number) fn of_f64(x: f64) -> f64 {
        use core::arch::x86_64::{_mm_cvtsd_f64, _mm_set_sd, _mm_sqrt_sd};
        // SAFETY: `sqrtsd` belongs to SSE2, which this function is compiled only with.
        unsafe {
            let x = _mm_set_sd(x);
            _mm_cvtsd_f64(_mm_sqrt_sd(x, x))
        }
    }

    /// Square root in single precision.
    #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
    #[inline]
    pub(in crate::number) fn of_f32(x: f32) -> f32 {
        use core::arch::x86_64::{_mm_cvtss_f32, _mm_set_ss, _mm_sqrt_ss};
        // SAFETY: `sqrtss` belongs to SSE, which SSE2 implies; compiled only with it.
        unsafe { _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(x))) }
    }

    /// Square root in single precision: VSQRT of the Cortex-M4F and its successors.
    #[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
    #[inline]
    pub(in crate::number) fn of_f32(x: f32) -> f32 {
        let root: u32;
        // SAFETY: the hard-float ABI implies a single-precision unit; registers only, no memory.
        unsafe {
            core::arch::asm!(
                "vmov s0, {x}",
                "vsqrt.f32 s0, s0",
                "vmov {root}, s0",
                x = in(reg) x.to_bits(),
                root = lateout(reg) root,
                out("s0") _,
                options(nomem, nostack, pure),
            );
        }
        f32::from_bits(root)
    }

    #[cfg(not(any(
        all(target_arch = "x86_64", target_feature = "sse2"),
        all(target_arch = "arm", target_abi = "eabihf")
    )))]
    pub(in crate::number) use libm::sqrtf as of_f32;

    #[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
    pub(in crate::number) use libm::sqrt as of_f64;
}
