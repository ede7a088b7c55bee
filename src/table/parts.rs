//! The parts of a table, and their memory.

use super::block::{BEGUN, ContactTable, FIELD, RECORD};
use super::fill::{Part, fill};
use crate::number::Float;
use crate::status::Error;
use crate::wheel_rail::scene::{Scene, Workspace};

/// Where the heights, the records and the fields of a part are in a block: beginnings and lengths.
/// Parts do not overlap, and nothing of them is in the head, the bytes before.
pub(crate) fn memory_of_part(head: &[u8], part: usize) -> Result<[[usize; 2]; 3], Error> {
    let counts = ContactTable::in_state(head, BEGUN)?.counts;
    Error::TableSpec.unless(part < counts.all_parts())?;
    let [.., heights, records, fields] = counts.sections();
    let sizes = [8, RECORD, FIELD * counts.places];
    let mut all = [heights, records, fields].into_iter().zip(sizes);
    Ok(core::array::from_fn(|_| {
        let (from, size) = all.next().unwrap_or((0, 0));
        let length = size * counts.levels;
        [from + part * length, length]
    }))
}

/// Fills a part of a table that is begun. Functions for several threads are those of the C
/// interface: each part has memory of its own.
///
/// # Errors
/// [`Error::Table`], [`Error::TablePair`], [`Error::TableSpec`] for a part that there is not; those
/// of the profiles and of the pair.
pub fn fill_part<F: Float>(
    scene: &Scene<F>, part: usize, memory: &mut Workspace<F>, block: &mut [u8],
) -> Result<(), Error> {
    let [heights, records, fields] = memory_of_part(block, part)?;
    let (head, rest) = block.split_at_mut_checked(heights[0]).ok_or(Error::Table)?;
    // what is before a section is left out, then the section is taken
    let mut own = [heights, records, fields].map(|_| <&mut [u8]>::default());
    let (mut rest, mut at) = (rest, heights[0]);
    for (place, [from, length]) in own.iter_mut().zip([heights, records, fields]) {
        let (_, after) = rest.split_at_mut_checked(from - at).ok_or(Error::Table)?;
        let (taken, after) = after.split_at_mut_checked(length).ok_or(Error::Table)?;
        (*place, rest, at) = (taken, after, from + length);
    }
    fill_memory(scene, head, part, own, memory)
}

/// Fills a part whose heights, records and fields are given.
pub(crate) fn fill_memory<F: Float>(
    scene: &Scene<F>, head: &[u8], number: usize, [heights, records, fields]: [&mut [u8]; 3],
    memory: &mut Workspace<F>,
) -> Result<(), Error> {
    let counts = ContactTable::in_state(head, BEGUN)?.counts;
    let offset = number * counts.levels * FIELD * counts.places;
    fill(scene, head, number, &mut Part { heights, records, fields, offset }, memory)
}
