//! Memory for outputs, filled with a pattern that no result has, and whether it still has it.

use std::mem::MaybeUninit;

const POISON: u8 = 0xA5;

/// A value filled with the pattern.
pub fn poisoned<T>() -> MaybeUninit<T> {
    let mut value = MaybeUninit::uninit();
    // SAFETY: any bytes are a MaybeUninit.
    unsafe { std::ptr::write_bytes(&mut value, POISON, 1) };
    value
}

/// Whether values still have the pattern in every byte. (The structures of the C interface have no
/// padding.)
pub fn untouched<T>(values: &[MaybeUninit<T>]) -> bool {
    const PATTERN: [u8; 256] = [POISON; 256];
    // SAFETY: every byte was set by `poisoned` or by a write of a structure without padding.
    let bytes =
        unsafe { std::slice::from_raw_parts(values.as_ptr().cast::<u8>(), size_of_val(values)) };
    bytes.chunks(PATTERN.len()).all(|chunk| *chunk == PATTERN[..chunk.len()])
}
