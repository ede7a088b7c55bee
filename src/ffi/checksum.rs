//! A checksum of numbers, for little more than one instruction each.

use crate::solve::model::Precision;
use core::num::Wrapping;
use core::ops::{Add, BitXor};

/// The bits of a number.
pub trait Word: Copy + Default + PartialEq + Add<Output = Self> + BitXor<Output = Self> {}
impl Word for Wrapping<u32> {}
impl Word for Wrapping<u64> {}

/// Numbers as words of their size.
pub trait Bits: Precision {
    type Word: Word;
    /// What a checksum starts with for a model and a strip count: no bits that come by chance, and not those of the other precision.
    fn mark(model: i32, strips: i32) -> Self::Word;
}

impl Bits for f64 {
    type Word = Wrapping<u64>;
    #[inline]
    fn mark(model: i32, strips: i32) -> Self::Word {
        let [model, strips] = [model, strips].map(|number| u64::from(number.cast_unsigned()));
        Wrapping(0x1967_1208_0c52_e817 ^ (model << 32) ^ strips)
    }
}

impl Bits for f32 {
    type Word = Wrapping<u32>;
    #[inline]
    fn mark(model: i32, strips: i32) -> Self::Word {
        let [model, strips] = [model, strips].map(i32::cast_unsigned);
        Wrapping(0x28ae_d2a6 ^ (model << 16) ^ strips)
    }
}

/// Words added and exclusive-ored by turns: what changes one of them, changes the sum.
#[inline]
pub(super) fn checksum<W: Word>(start: W, words: &[W]) -> W {
    let (fours, rest) = words.as_chunks::<4>();
    let sum = fours.iter().fold(start, |sum, [a, b, c, d]| (((sum + *a) ^ *b) + *c) ^ *d);
    rest.iter().fold(sum, |sum, word| sum + *word)
}
