//! A checksum of numbers, for little more than one instruction each.

use core::num::Wrapping;
use core::ops::{Add, BitXor};

/// The bits of a number.
pub(super) trait Word: Copy + Default + Add<Output = Self> + BitXor<Output = Self> {}
impl Word for Wrapping<u32> {}
impl Word for Wrapping<u64> {}

/// Words added and exclusive-ored by turns: what changes one of them, changes the sum.
#[inline]
pub(super) fn checksum<W: Word>(start: W, words: &[W]) -> W {
    let (fours, rest) = words.as_chunks::<4>();
    let sum = fours.iter().fold(start, |sum, [a, b, c, d]| (((sum + *a) ^ *b) + *c) ^ *d);
    rest.iter().fold(sum, |sum, word| sum + *word)
}
