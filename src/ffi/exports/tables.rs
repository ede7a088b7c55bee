//! Contact tables: a wheel in microseconds.

use super::F;
use super::scene::{WheelOutputs, law_of, scene_of, state_of};
use crate::ffi::support::{given, input, output, put, status_of, strip_count, write_result};
use crate::ffi::types::kstrip_table;
use crate::friction::SlipFriction;
use crate::status::{Error, Warning, kstrip_status};
use crate::table::{
    self, ContactTable, HEAD_START, TableReport, TableScene, TableSpec, fill_memory, head_length,
    memory_of_part,
};
use crate::wheel_rail::forces::wrench::{Wrench, WrenchByPosition, WrenchDerivatives};
use crate::wheel_rail::profile::PreparedProfile;
use crate::wheel_rail::scene::Workspace;
use crate::wheel_rail::{Position, Velocity, WheelPair};
use core::mem::MaybeUninit;

/// Size of a contact table, which holds contacts of kstrip_wheel_on_rail() at nodes;
/// kstrip_wheel_on_table() interpolates between them. docs/evidence/tables.md has its accuracy.
///
/// A table is caller-provided memory at any address, without pointers and little-endian. It may be
/// written to a file, and read or mapped again on another machine and by either precision. It is
/// begun, its parts are filled in any order and on any threads, and it is finished.
///
/// @param wheel           prepared profile.
/// @param spec            ranges and numbers of nodes.
/// @param[out] bytes      receives the length that a table needs while it is filled.
/// @param[out] parts      receives the number of its parts.
/// @return KSTRIP_OK; KSTRIP_ERROR_NULL; KSTRIP_ERROR_NOT_PREPARED (wheel); KSTRIP_ERROR_NOT_FINITE
///         and KSTRIP_ERROR_TABLE_SPEC (spec); KSTRIP_ERROR_CAPACITY (too many nodes, or 4 GB).
#[unsafe(export_name = symbol!("kstrip_table_size"))]
pub extern "C" fn kstrip_table_size(
    wheel: Option<&PreparedProfile<F>>, spec: Option<&TableSpec<F>>,
    bytes: Option<&mut MaybeUninit<u32>>, parts: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    status_of(|| {
        let (wheel, spec, bytes, parts) =
            (given(wheel)?, given(spec)?, given(bytes)?, given(parts)?);
        let [size, count] = spec.size(wheel)?;
        bytes.write(size);
        parts.write(count);
        Ok(Warning::None)
    })
}

/// Begins a table: it chooses lateral nodes for each pair of nodes of yaw and roll, in about the
/// time of one part for each pair.
///
/// @param rail, wheel, pair  as in kstrip_wheel_on_rail(), with a straight rail; side, friction,
///                        damping, strips and model do not matter.
/// @param spec            as in kstrip_table_size().
/// @param workspace       memory that may hold anything.
/// @param[out] table      memory of that many bytes.
/// @param bytes           at least the length that kstrip_table_size() returns.
/// @return KSTRIP_OK; a status of kstrip_table_size(); KSTRIP_ERROR_CAPACITY (bytes);
///         KSTRIP_ERROR_TABLE_PAIR (a roller); KSTRIP_ERROR_TABLE_SPEC (no lateral position of the
///         range has a contact); an error of kstrip_wheel_on_rail() about its arguments.
#[unsafe(export_name = symbol!("kstrip_table_begin"))]
pub unsafe extern "C" fn kstrip_table_begin(
    rail: Option<&PreparedProfile<F>>, wheel: Option<&PreparedProfile<F>>,
    pair: Option<&WheelPair<F>>, spec: Option<&TableSpec<F>>, workspace: Option<&mut Workspace<F>>,
    table: *mut u8, bytes: u32,
) -> kstrip_status {
    status_of(|| {
        let scene = scene_of(rail, wheel, pair, None)?;
        let (spec, memory) = (given(spec)?, given(workspace)?);
        // SAFETY: NULL or as many bytes as said, says the header.
        let block = unsafe { block_of(table, bytes)? };
        spec.begin_table(&scene, memory, block).map(|()| Warning::None)
    })
}

/// Fills parts of a table that is begun, each in about the time of 400 calls of
/// kstrip_wheel_on_rail(). Several threads may each fill other parts of one table, with separate
/// workspaces. Call it with few parts to show the progress.
///
/// @param rail, wheel, pair  those with which it was begun.
/// @param first, count    number of the first part, and how many.
/// @param workspace       memory that may hold anything.
/// @param[in,out] table, bytes  the table.
/// @return KSTRIP_OK; KSTRIP_ERROR_NULL; KSTRIP_ERROR_TABLE (no table, or bytes too few);
///         KSTRIP_ERROR_TABLE_UNFINISHED (it is finished already); KSTRIP_ERROR_TABLE_PAIR (another
///         pair); KSTRIP_ERROR_TABLE_SPEC (there are no such parts); an error of
///         kstrip_wheel_on_rail() about its arguments.
#[unsafe(export_name = symbol!("kstrip_table_fill"))]
pub unsafe extern "C" fn kstrip_table_fill(
    rail: Option<&PreparedProfile<F>>, wheel: Option<&PreparedProfile<F>>,
    pair: Option<&WheelPair<F>>, first: u32, count: u32, workspace: Option<&mut Workspace<F>>,
    table: *mut u8, bytes: u32,
) -> kstrip_status {
    status_of(|| {
        let scene = scene_of(rail, wheel, pair, None)?;
        let memory = given(workspace)?;
        // SAFETY: as many bytes as said, says the header. Nobody writes the head meanwhile.
        let head = unsafe {
            let start = input(table.cast_const(), bytes.min(HEAD_START))?;
            input(table.cast_const(), head_length(start)?.min(bytes))?
        };
        let end = first.checked_add(count).ok_or(Error::TableSpec)?;
        for part in first..end {
            let own = memory_of_part(head, part as usize)?.map(|[from, length]| {
                let inside = from.checked_add(length).is_some_and(|end| end <= bytes as usize);
                Error::Table.unless(inside)?;
                // SAFETY: parts do not overlap, and no other thread has this one.
                Ok(unsafe { core::slice::from_raw_parts_mut(table.wrapping_add(from), length) })
            });
            let [heights, records, fields] = own;
            fill_memory(&scene, head, part as usize, [heights?, records?, fields?], memory)?;
        }
        Ok(Warning::None)
    })
}

/// Finishes a table whose parts are filled: shortens it, measures its error against the direct call
/// with 64 strips, and adds a checksum. The positions of the measurement have 2.3 to 91 % of the
/// largest load and are spread over the ranges.
///
/// @param rail, wheel, pair  those with which it was begun.
/// @param poses           number of these positions: 500 are enough, and take about a second.
/// @param workspace       memory that may hold anything.
/// @param[in,out] table, bytes  the table.
/// @param[out] report     receives the length that the table has now, and its error.
/// @return as kstrip_table_fill(); KSTRIP_ERROR_TABLE_UNFINISHED where a part is not filled, after
///         which it must be begun again.
#[unsafe(export_name = symbol!("kstrip_table_finish"))]
pub unsafe extern "C" fn kstrip_table_finish(
    rail: Option<&PreparedProfile<F>>, wheel: Option<&PreparedProfile<F>>,
    pair: Option<&WheelPair<F>>, poses: u32, workspace: Option<&mut Workspace<F>>, table: *mut u8,
    bytes: u32, report: Option<&mut MaybeUninit<TableReport<F>>>,
) -> kstrip_status {
    write_result(report, || {
        let scene = scene_of(rail, wheel, pair, None)?;
        let memory = given(workspace)?;
        // SAFETY: NULL or as many bytes as said, says the header.
        let block = unsafe { block_of(table, bytes)? };
        table::finish(&scene, poses, memory, block)
    })
}

/// Checks all of a finished table. Call it once if a table comes from a file: the other functions
/// read no more than they need, and compute wrong numbers from a damaged table, but never access
/// memory outside it.
///
/// @param table, bytes    the table, or more bytes than it has.
/// @param[out] length     receives its length [bytes]; NULL: not needed.
/// @return KSTRIP_OK; KSTRIP_ERROR_NULL; KSTRIP_ERROR_TABLE (damaged, cut off, of another version,
///         or something else); KSTRIP_ERROR_TABLE_UNFINISHED (it is begun only).
#[unsafe(export_name = symbol!("kstrip_table_check"))]
pub unsafe extern "C" fn kstrip_table_check(
    table: *const u8, bytes: u32, length: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    status_of(|| {
        // SAFETY: NULL or as many bytes as said, says the header.
        let found = ContactTable::new(unsafe { input(table, bytes)? })?;
        found.check()?;
        put(length, found.byte_count());
        Ok(Warning::None)
    })
}

/// kstrip_wheel_on_rail() from a table alone: it needs no profiles, and computes no gap. Force and
/// moment are continuous inside the table.
///
/// @param table           a finished table; its member only does not matter.
/// @param pair            friction, side, model, damping, floor_speed and rail_speed. The radius,
///                        the materials and the smoothing length are those of the table, the number
///                        of strips is that of its spec, and the rail is straight.
/// @param position, velocity  as in kstrip_wheel_on_rail().
/// @param friction        falling friction (not its friction and rolling_speed); NULL: constant.
/// @param workspace       memory that may hold anything; receives the contacts; NULL: not needed.
///                        With several contacts a call without it takes longer, and the sums have
///                        another rounding.
/// @param[out] wrench     receives force and moment.
/// @param[out] derivatives  receives their exact derivatives with respect to velocity and friction;
///                          NULL: not needed.
/// @param[out] by_position  receives the derivatives of the interpolated wrench with respect to
///                        position: one-sided differences; NULL: not needed.
/// @return KSTRIP_OK; KSTRIP_WARNING_ANGLE_RANGE or KSTRIP_WARNING_ROUGH as there;
///         KSTRIP_ERROR_NULL; KSTRIP_ERROR_TABLE_RANGE (outside the table, where
///         kstrip_wheel_on_rail() takes over); KSTRIP_ERROR_TABLE (no table, or bytes too few);
///         KSTRIP_ERROR_TABLE_UNFINISHED (it is begun only); KSTRIP_ERROR_TABLE_PAIR (another
///         pair); an error of kstrip_wheel_on_rail() about its arguments.
#[unsafe(export_name = symbol!("kstrip_wheel_on_table"))]
pub unsafe extern "C" fn kstrip_wheel_on_table(
    table: Option<&kstrip_table>, pair: Option<&WheelPair<F>>, position: Option<&Position<F>>,
    velocity: Option<&Velocity<F>>, friction: Option<&SlipFriction<F>>,
    workspace: Option<&mut Workspace<F>>, wrench: Option<&mut MaybeUninit<Wrench<F>>>,
    derivatives: Option<&mut MaybeUninit<WrenchDerivatives<F>>>,
    by_position: Option<&mut MaybeUninit<WrenchByPosition<F>>>,
) -> kstrip_status {
    status_of(|| {
        let (table, pair) = (given(table)?, given(pair)?);
        // SAFETY: NULL or as many bytes as said, says the header.
        let table = ContactTable::new(unsafe { input(table.data, table.bytes)? })?;
        let (_, law) = (strip_count(pair.strips)?, law_of(pair.model, friction)?);
        let state = state_of(position, velocity)?;
        let scene = TableScene { table, pair, law };
        WheelOutputs { wrench, derivatives, by_position }
            .write(|requested| scene.differentiate(&state, workspace, requested))
    })
}

/// The bytes of a table that is written.
///
/// # Safety
/// `table` is NULL, or valid for `bytes` reads and writes, and nothing else refers to them.
unsafe fn block_of<'a>(table: *mut u8, bytes: u32) -> Result<&'a mut [u8], Error> {
    // SAFETY: the caller's promise.
    let block = unsafe { output(table, bytes)? };
    // SAFETY: any bytes are bytes, also those that nobody has written.
    Ok(unsafe { &mut *(core::ptr::from_mut(block) as *mut [u8]) })
}
