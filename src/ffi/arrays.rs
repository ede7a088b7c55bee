//! C arrays as slices.

use crate::status::{Error, Warning, kstrip_status};
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

/// The place of an element of an output array; `None` if it is not requested.
///
/// # Safety
/// `first` is NULL, or valid and aligned for writing at this index while the place lives, and
/// nothing else refers to that element.
pub(super) unsafe fn element<'a, T>(first: *mut T, i: usize) -> Option<&'a mut MaybeUninit<T>> {
    // SAFETY: the caller's promise.
    (!first.is_null()).then(|| unsafe { place(first.wrapping_add(i)) }).flatten()
}

/// # Safety
/// `first` is valid for reading at this index.
pub(super) unsafe fn read<T: Copy>(first: *const T, stride: isize, i: usize) -> T {
    // SAFETY: the caller's promise.
    unsafe { first.byte_offset(stride.wrapping_mul(i as isize)).read() }
}

/// Whether elements at this distance are aligned, if the first one is.
pub(super) const fn is_aligned<T>(_: *const T, stride: isize) -> bool {
    stride % align_of::<T>() as isize == 0
}

/// An input array in which the next element is a stride away; `None` in place of each element if it
/// is NULL.
#[derive(Clone, Copy)]
pub(super) struct Strided<T> {
    first: *const T,
    stride: isize,
}

impl<T: Copy> Strided<T> {
    pub(super) fn new(first: *const T, stride: u32, count: u32) -> Result<Self, Error> {
        let stride = stride as isize;
        Error::Stride.unless(count <= 1 || is_aligned(first, stride))?;
        Ok(Self { first, stride })
    }

    /// An array that must be given unless it is empty.
    pub(super) fn required(first: *const T, stride: u32, count: u32) -> Result<Self, Error> {
        Error::NullPointer.unless(count == 0 || !first.is_null())?;
        Self::new(first, stride, count)
    }

    /// # Safety
    /// The array is NULL, or valid for reading at this index.
    pub(super) unsafe fn at(self, i: usize) -> Option<T> {
        // SAFETY: the caller's promise.
        (!self.first.is_null()).then(|| unsafe { read(self.first, self.stride, i) })
    }
}

/// Calls a function for each of `count` elements and writes its statuses. The result is the first
/// error, or the most serious warning.
///
/// # Safety
/// `statuses` is NULL or valid for `count` writes, and `one` does not write there.
pub(super) unsafe fn each_element(
    count: u32,
    statuses: *mut kstrip_status,
    mut one: impl FnMut(usize) -> kstrip_status,
) -> Result<Warning, Error> {
    let (mut bad, mut worst) = (None, Warning::None);
    // SAFETY: the caller's promise.
    let statuses = unsafe { output(statuses, count) }?;
    for (i, place) in statuses.iter_mut().enumerate() {
        let status = *place.write(one(i));
        bad = bad.or(Error::from_code(status));
        worst = worst.worse(Warning::from_code(status).unwrap_or_default());
    }
    bad.map_or(Ok(worst), Err)
}
