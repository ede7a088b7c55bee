//! Sums of rows of weights on a Cortex-M4F: its unit for single precision loads many numbers by one
//! instruction, which no compiler makes of a loop.
//!
//! `vmla` rounds the product and then the sum, as two instructions do: the bits are those of the
//! plain loop. What is `unsafe`: instructions that read and write the arrays given.

#![allow(unsafe_code)]

use core::mem::MaybeUninit;

/// `start + Σ xᵢ wᵢ` row by row, all sums in registers: the registers of the sums, of the numbers
/// `x` of a row, and of its weights some after the other, each with its products: sum, number,
/// weight.
macro_rules! rows {
    ($start:ident, $sums:ident, $x:ident, $w:ident, $n:ident, $($stride:ident)?,
        $of_sums:literal, $of_x:literal,
        $($of_w:literal: $($sum:literal $by:literal $weight:literal),*;)*) => {
        core::arch::asm!(
            concat!("vldmia {start}, {{", $of_sums, "}}"),
            "2:",
            concat!("vldmia {x}!, {{", $of_x, "}}"),
            $(
                concat!("vldmia {w}!, {{", $of_w, "}}"),
                $(concat!("vmla.f32 s", $sum, ", s", $by, ", s", $weight),)*
            )*
            $(concat!("add {w}, {w}, {", stringify!($stride), "}"),)?
            "subs {n}, {n}, #1",
            "bne 2b",
            concat!("vstmia {sums}, {{", $of_sums, "}}"),
            start = in(reg) $start,
            sums = in(reg) $sums,
            x = inout(reg) $x => _,
            w = inout(reg) $w => _,
            n = inout(reg) $n => _,
            $($stride = in(reg) $stride,)?
            out("s0") _, out("s1") _, out("s2") _, out("s3") _, out("s4") _, out("s5") _,
            out("s6") _, out("s7") _, out("s8") _, out("s9") _, out("s10") _, out("s11") _,
            out("s12") _, out("s13") _, out("s14") _, out("s15") _, out("s16") _, out("s17") _,
            out("s18") _, out("s19") _, out("s20") _, out("s21") _, out("s22") _, out("s23") _,
            out("s24") _, out("s25") _, out("s26") _, out("s27") _, out("s28") _, out("s29") _,
            out("s30") _, out("s31") _,
            options(nostack),
        )
    };
}

/// Adds `n` rows of weights to `W` columns of `K` sums each.
///
/// # Safety
/// `start` and `sums` are `W` columns of `K` numbers, `x` is `n` times `K` numbers, and `w` the
/// first of `n` rows of `W` weights with `stride` bytes between them, none where `K = 1`; `n > 0`.
/// `start` and `sums` may be the same.
#[inline(never)]
unsafe fn add_block<const K: usize, const W: usize>(
    start: *const f32,
    sums: *mut f32,
    x: *const f32,
    w: *const f32,
    n: usize,
    stride: usize,
) {
    // SAFETY: the caller's promise; each register is declared.
    unsafe {
        match (K, W) {
            (1, 14) => rows!(
                start, sums, x, w, n, , "s0-s13", "s14",
                "s15-s28": 0 14 15, 1 14 16, 2 14 17, 3 14 18, 4 14 19, 5 14 20, 6 14 21, 7 14 22,
                    8 14 23, 9 14 24, 10 14 25, 11 14 26, 12 14 27, 13 14 28;
            ),
            (1, 20) => rows!(
                start, sums, x, w, n, , "s0-s19", "s20",
                "s21-s30": 0 20 21, 1 20 22, 2 20 23, 3 20 24, 4 20 25, 5 20 26, 6 20 27, 7 20 28,
                    8 20 29, 9 20 30;
                "s21-s30": 10 20 21, 11 20 22, 12 20 23, 13 20 24, 14 20 25, 15 20 26, 16 20 27,
                    17 20 28, 18 20 29, 19 20 30;
            ),
            (1, 22) => rows!(
                start, sums, x, w, n, , "s0-s21", "s22",
                "s23-s30": 0 22 23, 1 22 24, 2 22 25, 3 22 26, 4 22 27, 5 22 28, 6 22 29, 7 22 30;
                "s23-s30": 8 22 23, 9 22 24, 10 22 25, 11 22 26, 12 22 27, 13 22 28, 14 22 29,
                    15 22 30;
                "s23-s28": 16 22 23, 17 22 24, 18 22 25, 19 22 26, 20 22 27, 21 22 28;
            ),
            (1, 24) => rows!(
                start, sums, x, w, n, , "s0-s23", "s24",
                "s25-s30": 0 24 25, 1 24 26, 2 24 27, 3 24 28, 4 24 29, 5 24 30;
                "s25-s30": 6 24 25, 7 24 26, 8 24 27, 9 24 28, 10 24 29, 11 24 30;
                "s25-s30": 12 24 25, 13 24 26, 14 24 27, 15 24 28, 16 24 29, 17 24 30;
                "s25-s30": 18 24 25, 19 24 26, 20 24 27, 21 24 28, 22 24 29, 23 24 30;
            ),
            (4, 5) => rows!(
                start, sums, x, w, n, stride, "s0-s19", "s20-s23",
                "s24-s28": 0 20 24, 1 21 24, 2 22 24, 3 23 24, 4 20 25, 5 21 25, 6 22 25, 7 23 25,
                    8 20 26, 9 21 26, 10 22 26, 11 23 26, 12 20 27, 13 21 27, 14 22 27, 15 23 27,
                    16 20 28, 17 21 28, 18 22 28, 19 23 28;
            ),
            (4, 4) => rows!(
                start, sums, x, w, n, stride, "s0-s15", "s20-s23",
                "s24-s27": 0 20 24, 1 21 24, 2 22 24, 3 23 24, 4 20 25, 5 21 25, 6 22 25, 7 23 25,
                    8 20 26, 9 21 26, 10 22 26, 11 23 26, 12 20 27, 13 21 27, 14 22 27, 15 23 27;
            ),
            _ => {}
        }
    }
}

/// What `Real::rows_at_once` does.
#[inline(always)]
pub(super) fn sums<const C: usize, const R: usize>(
    start: &[f32; C],
    inputs: &[f32; R],
    rows: &[[f32; C]; R],
) -> [f32; C] {
    const { assert!(R > 0 && matches!(C, 14 | 20 | 22 | 24)) };
    let mut sums = MaybeUninit::<[f32; C]>::uninit();
    // SAFETY: all columns of the arrays, which initialises the sums.
    unsafe {
        let to = sums.as_mut_ptr().cast();
        add_block::<1, C>(start.as_ptr(), to, inputs.as_ptr(), rows.as_ptr().cast(), R, 0);
        sums.assume_init()
    }
}

/// What `Real::add_rows_beside` does.
#[inline(always)]
pub(super) fn add_beside<const C: usize, const R: usize>(
    sums: &mut [[f32; 4]; C],
    inputs: &[[f32; 4]; R],
    rows: &[[f32; C]; R],
) {
    // Fours from the left, until what is left are fives
    const { assert!(R > 0 && C >= 4 * ((5 - C % 5) % 5)) };
    let fours = const { (5 - C % 5) % 5 };
    let (sums, x) = (sums.as_mut_ptr().cast::<f32>(), inputs.as_ptr().cast());
    let rows = rows.as_ptr().cast::<f32>();
    // SAFETY: the columns lie within the arrays.
    unsafe {
        for first in (0..4 * fours).step_by(4) {
            let sums = sums.add(4 * first);
            add_block::<4, 4>(sums, sums, x, rows.add(first), R, 4 * (C - 4));
        }
        for first in (4 * fours..C).step_by(5) {
            let sums = sums.add(4 * first);
            add_block::<4, 5>(sums, sums, x, rows.add(first), R, 4 * (C - 5));
        }
    }
}

/// Numbers with three derivatives, each a structure of four numbers in the layout of C.
#[inline(always)]
pub(super) fn beside<D, F, const N: usize>(numbers: &[D; N]) -> &[[F; 4]; N] {
    const { assert!(size_of::<D>() == 4 * size_of::<F>() && align_of::<D>() == align_of::<F>()) };
    // SAFETY: both have the same size, and nothing but the four numbers.
    unsafe { &*core::ptr::from_ref(numbers).cast() }
}
