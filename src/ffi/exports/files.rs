//! Profiles from the text of a file, the right way round, and between two slices.

use super::F;
use crate::ffi::support::{given, input, output, put, status_of};
use crate::profile_file::{ProfileFile, orient_points, unit_of_points};
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
/// running circle. docs/reference/profile-files.md has the rules. The text is read several times,
/// without a copy.
///
/// @param text, length    the text of the file and its number of bytes. It need not end with 0.
/// @param format          KSTRIP_FORMAT_ANY or another one of these constants; the kind may be
///                        added, KSTRIP_FORMAT_WHEEL or KSTRIP_FORMAT_RAIL, and directions that
///                        are known, KSTRIP_FORMAT_Z_DOWN and KSTRIP_FORMAT_SIDE.
/// @param[out] y, z       arrays of `capacity` elements; receive the points [m].
/// @param capacity        number of elements of y and of z.
/// @param[out] count      receives the number of points.
/// @param[out] notes      receives findings and changes, a sum of KSTRIP_NOTE_; NULL: not needed.
/// @return KSTRIP_OK; KSTRIP_WARNING_PROFILE_GUESS (a note is a doubt: check notes);
///         KSTRIP_ERROR_NULL (text, y, z or count); KSTRIP_ERROR_FILE_FORMAT (format is no sum of
///         these constants); KSTRIP_ERROR_FILE_LINE (a line is no point, keyword or title of the
///         format); KSTRIP_ERROR_FILE_COLUMNS (more than two columns, and no names);
///         KSTRIP_ERROR_FILE_COUNT (fewer points than the header promises); KSTRIP_ERROR_FILE_UNITS
///         (a unit is not positive, or the numbers are too large for millimetres);
///         KSTRIP_ERROR_FILE_MISSING (a number is far from all others); KSTRIP_ERROR_NOT_FINITE (a
///         number is infinite, NaN or immense); KSTRIP_ERROR_PROFILE (fewer than four points);
///         KSTRIP_ERROR_CAPACITY (more points than capacity); KSTRIP_ERROR_SCATTER (the points are
///         a closed outline).
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
        let [y, z] =
            [y, z].map(|list| zeroed(list.get_mut(..file.point_count()).unwrap_or(&mut [])));
        count.write(file.point_count() as u32);
        let (found, warning) = file.read(y, z);
        put(notes, found);
        Ok(warning)
    })
}

/// Turns profiles the right way round by their shape: points toward larger y, z down, the flange or
/// the gauge side at small y. kstrip_read_profile() includes this. Kind, unit and directions are
/// decided once for all profiles. docs/reference/profile-files.md has the rules.
///
/// @param y, z            the points of all profiles, one profile after the other.
/// @param counts, profile_count  number of the points of each profile, at least four; of profiles.
/// @param format          a sum of KSTRIP_FORMAT_ constants: the convention of the points.
/// @param unit            metres per unit of y and z; 0: size and shape decide.
/// @param[out] turned_y, turned_z  receive the points [m]; not y and z themselves.
/// @param[out] taken_unit, notes  receive the unit, and a sum of KSTRIP_NOTE_; NULL: not needed.
/// @return KSTRIP_OK; KSTRIP_WARNING_PROFILE_GUESS (a note is a doubt: check notes);
///         KSTRIP_ERROR_NULL (a required array); KSTRIP_ERROR_CAPACITY (2^32 points or more);
///         KSTRIP_ERROR_PROFILE (no profile, or fewer than four points in one);
///         KSTRIP_ERROR_NOT_FINITE (a number is infinite, NaN or immense); KSTRIP_ERROR_FILE_FORMAT
///         (format is no sum of the constants); KSTRIP_ERROR_FILE_UNITS (unit < 0, or 0 and the
///         numbers are too large for millimetres).
#[unsafe(export_name = symbol!("kstrip_orient_profiles"))]
pub unsafe extern "C" fn kstrip_orient_profiles(
    y: *const F, z: *const F, counts: *const u32, profile_count: u32, format: u32, unit: F,
    turned_y: *mut F, turned_z: *mut F, taken_unit: Option<&mut MaybeUninit<F>>,
    notes: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    // SAFETY: NULL or as many elements as profile_count and the counts say, says the header.
    let given = unsafe {
        input(counts, profile_count).and_then(|counts| {
            let count = counts.iter().map(|count| u64::from(*count)).sum::<u64>();
            let count = u32::try_from(count).map_err(|_| Error::Capacity)?;
            let turned = [output(turned_y, count)?, output(turned_z, count)?];
            Ok((counts, [input(y, count)?, input(z, count)?], turned))
        })
    };
    status_of(|| {
        let (counts, points, turned) = given?;
        let mut unit = unit_of_points(points, counts, format, unit)?;
        let (found, warning) = orient_points(points, turned.map(zeroed), counts, format, &mut unit);
        put(taken_unit, unit.metres);
        put(notes, found);
        Ok(warning)
    })
}

/// An output, filled with zeros.
fn zeroed(list: &mut [MaybeUninit<F>]) -> &mut [F] {
    list.iter_mut().for_each(|place| {
        place.write(0.0);
    });
    // SAFETY: each element was written.
    unsafe { &mut *(core::ptr::from_mut(list) as *mut [F]) }
}

/// The prepared profile at a place between two slices of a surface. The surface varies along the
/// track, as at a switch or a crossing, or around a wheel. It is continuous in the share.
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
/// @return as kstrip_prepare_profile() for the points between the slices; KSTRIP_ERROR_NOT_PREPARED
///         (first or second); KSTRIP_ERROR_SLICE_SHARE (share is outside 0 to 1).
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
