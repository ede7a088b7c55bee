//! Sums of rows of weights on a Cortex-M4F: its unit for single precision loads many numbers by one
//! instruction, which no compiler makes of a loop.
//!
//! `vmla` rounds the product and then the sum, as two instructions do: the bits are those of the
//! plain loop. What is `unsafe`: instructions that read and write the arrays given.

#![allow(unsafe_code)]

use core::mem::transmute;

/// Sums of as many columns as there are weights in a row.
#[repr(C)]
struct RowSums<const W: usize>([f32; W]);

/// A function for so many columns.
type SumsOfRows<const W: usize> =
    unsafe extern "C" fn(*const f32, *const f32, *const f32, usize) -> RowSums<W>;

/// A function for chains of so many columns.
type Chains<const W: usize> =
    unsafe extern "C" fn(*const f32, *const f32, *const f32) -> RowSums<W>;

/// `name: sums, number, weights some after the other, each with its products`: a function that
/// returns `start + Σ xᵢ wᵢ` of `n` rows, all sums in registers. The products: sum, weight.
macro_rules! sums_of_rows {
    ($($name:ident $W:literal: $of_sums:literal, $x:literal,
        $($of_w:literal: $($sum:literal $weight:literal),*;)*)*) => {$(
        /// # Safety
        /// `start` is as many numbers as there are sums, `x` is `n` numbers and `w` as many rows
        /// of weights; `n > 0`.
        #[unsafe(naked)]
        unsafe extern "C" fn $name(
            start: *const f32,
            x: *const f32,
            w: *const f32,
            n: usize,
        ) -> RowSums<$W> {
            // r0 is the place for the result, r1 to r3 are the pointers, the count is on the stack
            core::arch::naked_asm!(
                "ldr r12, [sp]",
                "vpush {{d8-d15}}",
                concat!("vldmia r1, {{", $of_sums, "}}"),
                "2:",
                concat!("vldmia r2!, {{", $x, "}}"),
                $(
                    concat!("vldmia r3!, {{", $of_w, "}}"),
                    $(concat!("vmla.f32 s", $sum, ", ", $x, ", s", $weight),)*
                )*
                "subs r12, r12, #1",
                "bne 2b",
                concat!("vstmia r0, {{", $of_sums, "}}"),
                "vpop {{d8-d15}}",
                "bx lr",
            )
        }
    )*};
}

sums_of_rows!(
    sums_of_14 14: "s0-s13", "s14",
        "s15-s28": 0 15, 1 16, 2 17, 3 18, 4 19, 5 20, 6 21, 7 22, 8 23, 9 24, 10 25, 11 26,
            12 27, 13 28;
    sums_of_20 20: "s0-s19", "s20",
        "s21-s30": 0 21, 1 22, 2 23, 3 24, 4 25, 5 26, 6 27, 7 28, 8 29, 9 30;
        "s21-s30": 10 21, 11 22, 12 23, 13 24, 14 25, 15 26, 16 27, 17 28, 18 29, 19 30;
    sums_of_22 22: "s0-s21", "s22",
        "s23-s30": 0 23, 1 24, 2 25, 3 26, 4 27, 5 28, 6 29, 7 30;
        "s23-s30": 8 23, 9 24, 10 25, 11 26, 12 27, 13 28, 14 29, 15 30;
        "s23-s28": 16 23, 17 24, 18 25, 19 26, 20 27, 21 28;
    sums_of_24 24: "s0-s23", "s24",
        "s25-s30": 0 25, 1 26, 2 27, 3 28, 4 29, 5 30;
        "s25-s30": 6 25, 7 26, 8 27, 9 28, 10 29, 11 30;
        "s25-s30": 12 25, 13 26, 14 27, 15 28, 16 29, 17 30;
        "s25-s30": 18 25, 19 26, 20 27, 21 28, 22 29, 23 30;
);

/// A unit's number and its six weights, and their products, added to or put into six sums.
macro_rules! unit {
    ($operation:literal: $($sum:literal)*) => {
        unit!(@ $operation: $($sum)*; 25 26 27 28 29 30)
    };
    (@ $operation:literal: $a:literal $b:literal $c:literal $d:literal $e:literal $f:literal;
        $($weight:literal)*) => {
        concat!(
            "vldmia r2!, {{s24}}\n vldmia r3!, {{s25-s30}}\n",
            $operation, ".f32 s", $a, ", s24, s25\n", $operation, ".f32 s", $b, ", s24, s26\n",
            $operation, ".f32 s", $c, ", s24, s27\n", $operation, ".f32 s", $d, ", s24, s28\n",
            $operation, ".f32 s", $e, ", s24, s29\n", $operation, ".f32 s", $f, ", s24, s30",
        )
    };
}

/// `start + Σ xᵢ wᵢ` of 14 units with six weights each, in four chains as `(c₀ + c₂) + (c₁ + c₃)`.
///
/// # Safety
/// `start` is six numbers, `x` is 14 and `w` as many rows of six.
#[unsafe(naked)]
unsafe extern "C" fn chains_of_14(start: *const f32, x: *const f32, w: *const f32) -> RowSums<6> {
    core::arch::naked_asm!(
        "vpush {{d8-d15}}",
        "vldmia r1, {{s0-s5}}",
        unit!("vmla": 0 1 2 3 4 5),
        unit!("vmul": 6 7 8 9 10 11),
        unit!("vmul": 12 13 14 15 16 17),
        unit!("vmul": 18 19 20 21 22 23),
        "mov r12, #2",
        "2:",
        unit!("vmla": 0 1 2 3 4 5),
        unit!("vmla": 6 7 8 9 10 11),
        unit!("vmla": 12 13 14 15 16 17),
        unit!("vmla": 18 19 20 21 22 23),
        "subs r12, r12, #1",
        "bne 2b",
        unit!("vmla": 0 1 2 3 4 5),
        unit!("vmla": 6 7 8 9 10 11),
        "vadd.f32 s0, s0, s12",
        "vadd.f32 s6, s6, s18",
        "vadd.f32 s0, s0, s6",
        "vadd.f32 s1, s1, s13",
        "vadd.f32 s7, s7, s19",
        "vadd.f32 s1, s1, s7",
        "vadd.f32 s2, s2, s14",
        "vadd.f32 s8, s8, s20",
        "vadd.f32 s2, s2, s8",
        "vadd.f32 s3, s3, s15",
        "vadd.f32 s9, s9, s21",
        "vadd.f32 s3, s3, s9",
        "vadd.f32 s4, s4, s16",
        "vadd.f32 s10, s10, s22",
        "vadd.f32 s4, s4, s10",
        "vadd.f32 s5, s5, s17",
        "vadd.f32 s11, s11, s23",
        "vadd.f32 s5, s5, s11",
        "vstmia r0, {{s0-s5}}",
        "vpop {{d8-d15}}",
        "bx lr",
    )
}

/// What `Real::chains_at_once` does.
#[inline]
pub(super) fn chains<const C: usize, const R: usize>(
    start: &[f32; C],
    inputs: &[f32; R],
    rows: &[[f32; C]; R],
) -> [f32; C] {
    const { assert!(C == 6 && R == 14) };
    // SAFETY: the function is that for these sizes; it reads all of the arrays.
    unsafe {
        let chains = transmute::<*const (), Chains<C>>(chains_of_14 as *const ());
        chains(start.as_ptr(), inputs.as_ptr(), rows.as_ptr().cast()).0
    }
}

/// Adds `n` rows of weights to `W` columns of four sums each: the registers of the sums, of the
/// four numbers of a row, and of its weights; the products: sum, number, weight.
macro_rules! rows {
    ($sums:ident, $x:ident, $w:ident, $n:ident, $stride:ident,
        $of_sums:literal, $of_x:literal,
        $of_w:literal: $($sum:literal $by:literal $weight:literal),*) => {
        core::arch::asm!(
            concat!("vldmia {sums}, {{", $of_sums, "}}"),
            "2:",
            concat!("vldmia {x}!, {{", $of_x, "}}"),
            concat!("vldmia {w}!, {{", $of_w, "}}"),
            $(concat!("vmla.f32 s", $sum, ", s", $by, ", s", $weight),)*
            "add {w}, {w}, {stride}",
            "subs {n}, {n}, #1",
            "bne 2b",
            concat!("vstmia {sums}, {{", $of_sums, "}}"),
            sums = in(reg) $sums,
            x = inout(reg) $x => _,
            w = inout(reg) $w => _,
            n = inout(reg) $n => _,
            stride = in(reg) $stride,
            out("s0") _, out("s1") _, out("s2") _, out("s3") _, out("s4") _, out("s5") _,
            out("s6") _, out("s7") _, out("s8") _, out("s9") _, out("s10") _, out("s11") _,
            out("s12") _, out("s13") _, out("s14") _, out("s15") _, out("s16") _, out("s17") _,
            out("s18") _, out("s19") _, out("s20") _, out("s21") _, out("s22") _, out("s23") _,
            out("s24") _, out("s25") _, out("s26") _, out("s27") _, out("s28") _,
            options(nostack),
        )
    };
}

/// # Safety
/// `sums` is `W` columns of four numbers, `x` is `n` times four numbers, and `w` the first of `n`
/// rows of `W` weights with `stride` bytes between them; `n > 0`.
#[inline(never)]
unsafe fn add_block<const W: usize>(
    sums: *mut f32,
    x: *const f32,
    w: *const f32,
    n: usize,
    stride: usize,
) {
    // SAFETY: the caller's promise; each register is declared.
    unsafe {
        match W {
            5 => rows!(
                sums, x, w, n, stride, "s0-s19", "s20-s23",
                "s24-s28": 0 20 24, 1 21 24, 2 22 24, 3 23 24, 4 20 25, 5 21 25, 6 22 25, 7 23 25,
                    8 20 26, 9 21 26, 10 22 26, 11 23 26, 12 20 27, 13 21 27, 14 22 27, 15 23 27,
                    16 20 28, 17 21 28, 18 22 28, 19 23 28
            ),
            4 => rows!(
                sums, x, w, n, stride, "s0-s15", "s20-s23",
                "s24-s27": 0 20 24, 1 21 24, 2 22 24, 3 23 24, 4 20 25, 5 21 25, 6 22 25, 7 23 25,
                    8 20 26, 9 21 26, 10 22 26, 11 23 26, 12 20 27, 13 21 27, 14 22 27, 15 23 27
            ),
            _ => {}
        }
    }
}

/// What `Real::rows_at_once` does.
#[inline]
pub(super) fn sums<const C: usize, const R: usize>(
    start: &[f32; C],
    inputs: &[f32; R],
    rows: &[[f32; C]; R],
) -> [f32; C] {
    const { assert!(R > 0 && matches!(C, 14 | 20 | 22 | 24)) };
    let of_rows = match C {
        14 => sums_of_14 as *const (),
        20 => sums_of_20 as *const (),
        22 => sums_of_22 as *const (),
        _ => sums_of_24 as *const (),
    };
    // SAFETY: the function is that for `C` columns; it reads all of the arrays.
    unsafe {
        let of_rows = transmute::<*const (), SumsOfRows<C>>(of_rows);
        of_rows(start.as_ptr(), inputs.as_ptr(), rows.as_ptr().cast(), R).0
    }
}

/// What `Real::add_rows_beside` does.
#[inline]
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
            add_block::<4>(sums, x, rows.add(first), R, 4 * (C - 4));
        }
        for first in (4 * fours..C).step_by(5) {
            let sums = sums.add(4 * first);
            add_block::<5>(sums, x, rows.add(first), R, 4 * (C - 5));
        }
    }
}

/// Numbers with three derivatives, each a structure of four numbers in the layout of C.
#[inline]
pub(super) fn beside<D, F, const N: usize>(numbers: &[D; N]) -> &[[F; 4]; N] {
    const { assert!(size_of::<D>() == 4 * size_of::<F>() && align_of::<D>() == align_of::<F>()) };
    // SAFETY: both have the same size, and nothing but the four numbers.
    unsafe { &*core::ptr::from_ref(numbers).cast() }
}
