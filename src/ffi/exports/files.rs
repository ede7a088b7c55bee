//! Profiles from the text of a file, and between two slices.

use super::F;
use crate::ffi::support::{given, input, output, put, status_of};
use crate::profile_file::ProfileFile;
use crate::status::{Error, kstrip_status};
use crate::wheel_rail::profile::PreparedProfile;
use core::ffi::c_char;
use core::mem::MaybeUninit;

/// Reads the profile of a wheel or a rail from the text of a file, in metres and the right way
/// round: points toward larger y, z down, the flange or the gauge side at small y.
///
/// Formats: SIMPACK and CONTACT (.prw, .prr), MiniProf (.whl, .ban, .mpt), and columns of numbers
/// with or without names. The convention of SIMPACK's format decides which way its points stand.
/// For the other formats, or if the requested kind is not that of the header, the shape of the
/// tread or of the head decides. The wheel of a MiniProf file is moved from its flange back to its
/// running circle. docs/profile-files.md has the rules. The text is read several times, without a
/// copy.
///
/// @param text, length    the text of the file and its number of bytes. It need not end with 0.
/// @param format          KSTRIP_FORMAT_ANY or another one of these constants; the kind may be
///                        added, KSTRIP_FORMAT_WHEEL or KSTRIP_FORMAT_RAIL.
/// @param[out] y, z       arrays of `capacity` elements; receive the points [m].
/// @param capacity        number of elements of y and of z.
/// @param[out] count      receives the number of points.
/// @param[out] notes      receives findings and changes, a sum of KSTRIP_NOTE_; NULL: not needed.
/// @return KSTRIP_OK; KSTRIP_WARNING_PROFILE_GUESS (a note is a doubt: check notes);
///         KSTRIP_ERROR_NULL, KSTRIP_ERROR_FILE_FORMAT, KSTRIP_ERROR_FILE_LINE,
///         KSTRIP_ERROR_FILE_COLUMNS, KSTRIP_ERROR_FILE_COUNT, KSTRIP_ERROR_FILE_UNITS,
///         KSTRIP_ERROR_FILE_MISSING, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_PROFILE (fewer than
///         four points), KSTRIP_ERROR_CAPACITY, KSTRIP_ERROR_SCATTER (a closed outline).
#[unsafe(export_name = symbol!("kstrip_read_profile"))]
pub unsafe extern "C" fn kstrip_read_profile(
    text: *const c_char, length: u32, format: u32, y: *mut F, z: *mut F, capacity: u32,
    count: Option<&mut MaybeUninit<u32>>, notes: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    // SAFETY: NULL or as many elements as length and capacity say, says the header.
    let (text, y, z) =
        unsafe { (input(text.cast::<u8>(), length), output(y, capacity), output(z, capacity)) };
    status_of(|| {
        let (text, y, z, count) = (text?, y?, z?, given(count)?);
        let file = ProfileFile::<F>::open(text, format, capacity as usize)?;
        let cleared = [y, z].map(|list| {
            let list = list.get_mut(..file.point_count()).unwrap_or(&mut []);
            list.iter_mut().for_each(|place| {
                place.write(0.0);
            });
            // SAFETY: each element was written.
            unsafe { &mut *(core::ptr::from_mut(list) as *mut [F]) }
        });
        let [y, z] = cleared;
        let (found, warning) = file.read(y, z);
        count.write(file.point_count() as u32);
        put(notes, found);
        Ok(warning)
    })
}

/// The prepared profile at a place between two slices of a surface that varies along the track,
/// such as a switch or a crossing, or around a wheel. It is continuous in the share.
///
/// Points at the same share of the length of both profiles belong together: their coordinates are
/// interpolated, and the result is prepared. Both slices must begin and end at the same features,
/// and be near enough to each other that the features between them move in proportion. The slope of
/// the surface along the track is not a part of the result: wheels touch the profile at the place
/// as if it were that of a straight rail, and a rail that rises by 1 in 100 moves the contact ahead
/// by a hundredth of the radius of the wheel.
///
/// @param first, second   prepared profiles of the slices before and after the place.
/// @param share           0 at the place of the first to 1 at that of the second.
/// @param[out] between    receives the profile; it may be one of the slices.
/// @return KSTRIP_OK or a warning of kstrip_prepare_profile(); KSTRIP_ERROR_NULL,
///         KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_NOT_PREPARED, KSTRIP_ERROR_SLICE_SHARE, or an
///         error of kstrip_prepare_profile().
#[unsafe(export_name = symbol!("kstrip_profile_between"))]
pub unsafe extern "C" fn kstrip_profile_between(
    first: *const PreparedProfile<F>, second: *const PreparedProfile<F>, share: F,
    between: *mut PreparedProfile<F>,
) -> kstrip_status {
    // SAFETY: NULL or a profile, says the header.
    let line = unsafe {
        match (first.as_ref(), second.as_ref()) {
            (Some(first), Some(second)) => PreparedProfile::line_between(first, second, share),
            _ => Err(Error::NullPointer),
        }
    };
    // SAFETY: NULL or a profile, says the header; the slices are not used any more.
    let between = unsafe { between.as_mut() };
    status_of(|| {
        let between = given(between)?;
        line?.prepare(between)
    })
}
