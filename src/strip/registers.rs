//! Four strips in one register of 256 bits, where the processor has such registers: the same bits in half the
//! instructions.

#![allow(unsafe_code)]

use super::creepage::Law;
use super::totals::{Fours, PreparedStrips, StripSums, Sums};
use crate::number::Plain;
use crate::number::lanes::{F32x8, F64x4, Lanes};

impl StripSums for F64x4 {}
impl StripSums for F32x8 {}
impl StripSums for f64 {
    #[inline(always)]
    fn strip_sums(strips: &PreparedStrips<f64>, law: &Law<f64>, slopes: bool) -> Sums<f64> {
        sums(strips, law, slopes)
    }
}

struct Registers;

impl Fours<f64> for Registers {
    type Four = F64x4;
    #[inline(always)]
    fn all(x: f64) -> F64x4 {
        F64x4::stored(x)
    }
    #[inline(always)]
    fn of(numbers: [f64; 4]) -> F64x4 {
        F64x4::of_array(numbers)
    }
    #[inline(always)]
    fn sum(four: F64x4) -> f64 {
        let [a, b, c, d] = four.array();
        (a + c) + (b + d)
    }
}

/// Sums over the strips of a contact.
fn sums(strips: &PreparedStrips<f64>, law: &Law<f64>, slopes: bool) -> Sums<f64> {
    #[target_feature(enable = "avx")]
    fn alone(strips: &PreparedStrips<f64>, law: &Law<f64>) -> Sums<f64> {
        strips.sums_in::<Registers>(law, false)
    }
    #[target_feature(enable = "avx")]
    fn with_slopes(strips: &PreparedStrips<f64>, law: &Law<f64>) -> Sums<f64> {
        strips.sums_in::<Registers>(law, true)
    }
    #[inline(never)]
    fn without(strips: &PreparedStrips<f64>, law: &Law<f64>, slopes: bool) -> Sums<f64> {
        strips.sums(law, slopes)
    }
    if !crate::batch::side_by_side::available() {
        return without(strips, law, slopes);
    }
    // SAFETY: the processor was asked.
    unsafe { if slopes { with_slopes(strips, law) } else { alone(strips, law) } }
}
