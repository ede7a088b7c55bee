//! C arrays as slices.

use crate::status::Error;
use core::mem::MaybeUninit;

/// An input array; may be NULL when it is empty.
///
/// # Safety
/// `pointer` is NULL, or valid and aligned for `count` reads while the slice lives.
pub(super) unsafe fn input<'a, T>(pointer: *const T, count: u32) -> Result<&'a [T], Error> {
    let count = count as usize;
    if count == 0 {
        Ok(&[])
    } else if pointer.is_null() {
        Err(Error::NullPointer)
    } else {
        // SAFETY: the caller's promise.
        Ok(unsafe { core::slice::from_raw_parts(pointer, count) })
    }
}

/// An output array, not yet initialised; may be NULL when it is empty.
///
/// # Safety
/// `pointer` is NULL, or valid and aligned for `count` writes while the slice lives, and nothing
/// else refers to that memory.
pub(super) unsafe fn output<'a, T>(
    pointer: *mut T,
    count: u32,
) -> Result<&'a mut [MaybeUninit<T>], Error> {
    let count = count as usize;
    if count == 0 {
        Ok(&mut [])
    } else if pointer.is_null() {
        Err(Error::NullPointer)
    } else {
        // SAFETY: the caller's promise.
        Ok(unsafe { core::slice::from_raw_parts_mut(pointer.cast(), count) })
    }
}

/// The place of an output; `None` if it is not requested.
///
/// # Safety
/// `pointer` is NULL, or valid and aligned for one write while the place lives, and nothing else
/// refers to it.
pub(super) unsafe fn place<'a, T>(pointer: *mut T) -> Option<&'a mut MaybeUninit<T>> {
    // SAFETY: the caller's promise.
    unsafe { pointer.cast::<MaybeUninit<T>>().as_mut() }
}
