//! The square root instruction of the machine.
//!
//! The theory is made of square roots, and stable Rust has none in `core`. libm's is inline
//! assembly on x86-64, which no compiler vectorises, and software on a Cortex-M with a
//! floating-point unit (66 instructions instead of one). What is `unsafe`: instructions on
//! registers without memory access.

#![allow(unsafe_code)]

/// Square root in double precision.
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
#[inline]
pub(super) fn of_f64(x: f64) -> f64 {
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
pub(super) fn of_f32(x: f32) -> f32 {
    use core::arch::x86_64::{_mm_cvtss_f32, _mm_set_ss, _mm_sqrt_ss};
    // SAFETY: `sqrtss` belongs to SSE, which SSE2 implies; compiled only with it.
    unsafe { _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(x))) }
}

/// Square root in single precision: VSQRT of the Cortex-M4F and its successors.
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[inline]
pub(super) fn of_f32(x: f32) -> f32 {
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
pub(super) use libm::sqrtf as of_f32;

#[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
pub(super) use libm::sqrt as of_f64;
