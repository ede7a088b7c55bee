//! Shared helpers of the exported functions.

use super::constants::KSTRIP_MODEL_DEFAULT;
use super::types::kstrip_options;
use crate::contact::totals::StripCount;
use crate::forces::{Model, Options, Solution};
use crate::number::Float;
use crate::status::{Error, Warning, kstrip_status};
use crate::wheel_rail::Requested;
use core::mem::MaybeUninit;

/// Runs a function that may fail, and returns its status.
pub(super) fn status_of(body: impl FnOnce() -> Result<Warning, Error>) -> kstrip_status {
    match body() {
        Ok(warning) => warning.code(),
        Err(error) => error.code(),
    }
}

/// Writes the result of a function to its one output, which is required.
pub(super) fn write_result<T>(
    place: Output<T>, find: impl FnOnce() -> Result<T, Error>,
) -> kstrip_status {
    status_of(|| {
        given(place)?.write(find()?);
        Ok(Warning::None)
    })
}

/// The same of a result with a warning, which is the status.
pub(super) fn write_warned<T>(
    place: Output<T>, find: impl FnOnce() -> Result<(T, Warning), Error>,
) -> kstrip_status {
    status_of(|| {
        let place = given(place)?;
        let (found, warning) = find()?;
        place.write(found);
        Ok(warning)
    })
}

/// The same for a solution, whose warning is the status.
pub(super) fn write_solution<F: Float>(
    place: Output<Solution<F>>, solve: impl FnOnce() -> Result<Solution<F>, Error>,
) -> kstrip_status {
    status_of(|| {
        let place = given(place)?;
        Ok(place.write(solve()?).warning)
    })
}

/// A required argument.
pub(super) fn given<T>(argument: Option<T>) -> Result<T, Error> {
    argument.ok_or(Error::NullPointer)
}

/// The caller's options for forces; NULL and zero mean the defaults.
pub(super) fn for_forces(options: Option<&kstrip_options>) -> Result<Options, Error> {
    with_default(options, Model::Total)
}

/// The caller's options for strips or fields.
pub(super) fn for_strips(options: Option<&kstrip_options>) -> Result<Options, Error> {
    with_default(options, Model::Strip)
}

fn with_default(options: Option<&kstrip_options>, default: Model) -> Result<Options, Error> {
    let kstrip_options { model, strips } = options.copied().unwrap_or_default();
    let is_default = model == KSTRIP_MODEL_DEFAULT;
    let model = if is_default { default as i32 } else { model };
    let missing = if Model::is_number(model) { Error::ModelLeftOut } else { Error::Model };
    let model = Model::from_number(model).ok_or(missing)?;
    Ok(Options { model, strips: strip_count(strips)? })
}

/// A number of strips; 0: the default.
pub(super) fn strip_count(strips: i32) -> Result<StripCount, Error> {
    if strips == 0 {
        Ok(StripCount::default())
    } else {
        StripCount::from_number(strips).ok_or(Error::StripCount)
    }
}

/// A result by reference.
pub(super) fn given_by<T>(found: &Result<T, Error>) -> Result<&T, Error> {
    found.as_ref().map_err(|error| *error)
}

pub(super) type Output<'a, T> = Option<&'a mut MaybeUninit<T>>;

/// Writes an output if it is requested.
pub(super) fn put<T>(place: Output<T>, value: T) {
    if let Some(place) = place {
        place.write(value);
    }
}

/// Runs a computation and writes the derivatives that are requested, if it has a result; `fits`
/// tells whether those with respect to the position are finite.
pub(super) fn with_requested<V: Default, P: Default, T>(
    by_velocity: Output<V>, by_position: Output<P>, fits: impl FnOnce(&P) -> bool,
    solve: impl FnOnce(Requested<V, P>) -> Result<T, Error>,
) -> Result<T, Error> {
    let (mut slopes, mut moved) = (V::default(), P::default());
    let found = solve(Requested {
        by_velocity: by_velocity.is_some().then_some(&mut slopes),
        by_position: by_position.is_some().then_some(&mut moved),
    })?;
    Error::Overflow.unless(fits(&moved))?;
    put(by_velocity, slopes);
    put(by_position, moved);
    Ok(found)
}

/// An input array; may be NULL when it is empty.
///
/// # Safety
/// `pointer` is NULL, or valid and aligned for `count` reads while the slice lives.
pub(super) unsafe fn input<'a, T>(pointer: *const T, count: u32) -> Result<&'a [T], Error> {
    if count == 0 {
        return Ok(&[]);
    }
    Error::NullPointer.when(pointer.is_null())?;
    // SAFETY: the caller's promise.
    Ok(unsafe { core::slice::from_raw_parts(pointer, count as usize) })
}

/// An output array, not yet initialised; may be NULL when it is empty.
///
/// # Safety
/// `pointer` is NULL, or valid and aligned for `count` writes while the slice lives, and nothing
/// else refers to that memory.
pub(super) unsafe fn output<'a, T>(
    pointer: *mut T, count: u32,
) -> Result<&'a mut [MaybeUninit<T>], Error> {
    if count == 0 {
        return Ok(&mut []);
    }
    Error::NullPointer.when(pointer.is_null())?;
    // SAFETY: the caller's promise.
    Ok(unsafe { core::slice::from_raw_parts_mut(pointer.cast(), count as usize) })
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

/// Calls a function for each of `count` elements and writes its statuses where they are requested.
/// The result is the first error, or the most serious warning.
///
/// # Safety
/// `statuses` is NULL or valid for `count` writes, and `one` does not write there.
pub(super) unsafe fn each_element(
    count: u32, statuses: *mut kstrip_status, mut one: impl FnMut(usize) -> kstrip_status,
) -> Result<Warning, Error> {
    let (mut bad, mut worst) = (None, Warning::None);
    for i in 0..count as usize {
        let status = one(i);
        // SAFETY: the caller's promise.
        put(unsafe { element(statuses, i) }, status);
        bad = bad.or(Error::from_code(status));
        worst = worst.worse(Warning::from_code(status).unwrap_or_default());
    }
    bad.map_or(Ok(worst), Err)
}
