//! The block of a table: little-endian, without pointers, at any address.
//!
//! ```text
//!   0  "kstriptb"            8  version, state          16  length, checksum of the rest
//!  32  five counts           64  twelve numbers
//! then in double precision: lateral nodes of each slab, loads to the power 2/3, places on the
//! wheel (y, z, cosine, sine), heights; of each node offset, first place, number of places and
//! three scales; then of each node l² and p² with a sign as integers of 16 bits, and half the angle
//! between the surfaces as integers of 8 bits
//! ```
//!
//! A slab has one yaw and one roll; its nodes are lateral positions, each with all levels.

use crate::contact::material::{check_modulus, check_poisson_ratio};
use crate::number::Float;
use crate::status::Error;
use crate::table::axis::Around;
use crate::wheel_rail::WheelPair;
use crate::wheel_rail::profile::CurvePoint;

const MAGIC: u64 = u64::from_le_bytes(*b"kstriptb");
const VERSION: u32 = 2;
/// States of a table.
pub(super) const BEGUN: u32 = 1;
pub(super) const FINISHED: u32 = 2;
const LENGTH_AT: usize = 16;
const CHECKSUM_AT: usize = 24;
const CHECKED_FROM: usize = 32;
const NUMBERS_AT: usize = 64;
const NUMBERS: usize = 12;
/// Bytes of a record of a node, of a place, and of the three numbers of a place in a node.
pub(super) const RECORD: usize = 20;
const PLACE: usize = 32;
pub(super) const FIELD: usize = 5;
/// Largest number of places on the wheel, and of nodes of each axis.
pub(super) const MOST_PLACES: usize = 1024;
const MOST_NODES: [u32; 4] = [256, 64, 33, 65];
/// `l²` that stands for all smaller ones \[m²\].
pub(super) const SQUARE_FLOOR: f64 = 8e-6;

/// Numbers of a header.
#[derive(Clone, Copy)]
pub(super) enum Quantity {
    WheelRadius,
    ShearModulus,
    PoissonRatio,
    SmoothingLength,
    /// Distance of the places on the wheel \[m\].
    Spacing,
    Yaw,
    Roll,
    Load,
    ForceUsual,
    ForceLargest,
    LoadUsual,
    LoadLargest,
}

/// How many nodes the axes have, and how many places the wheel has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Counts {
    pub lateral: usize,
    pub levels: usize,
    pub yaw: usize,
    pub roll: usize,
    pub places: usize,
}

impl Counts {
    pub const fn slabs(&self) -> usize {
        self.yaw * self.roll
    }

    /// Parts that are filled: a lateral position of a slab, with all levels.
    pub const fn all_parts(&self) -> usize {
        self.slabs() * self.lateral
    }

    pub const fn all_nodes(&self) -> usize {
        self.all_parts() * self.levels
    }

    /// Where lateral nodes, loads, places, heights, records and fields begin.
    pub const fn sections(&self) -> [usize; 6] {
        let lateral = NUMBERS_AT + 8 * NUMBERS;
        let loads = lateral + 8 * self.all_parts();
        let places = loads + 8 * self.levels;
        let heights = places + PLACE * self.places;
        let records = heights + 8 * self.all_nodes();
        [lateral, loads, places, heights, records, records + RECORD * self.all_nodes()]
    }

    /// Bytes of a table whose nodes have all places, if they can be counted.
    pub fn most_bytes(&self) -> Result<usize, Error> {
        let [.., fields] = self.sections();
        let of_fields = (self.all_nodes() as u64).saturating_mul((FIELD * self.places) as u64);
        let bytes = of_fields.saturating_add(fields as u64);
        u32::try_from(bytes).map(|bytes| bytes as usize).map_err(|_| Error::Capacity)
    }

    /// # Errors
    /// [`Error::Capacity`] for a count that is 0 or too large.
    pub fn checked(counts: [u32; 5]) -> Result<Self, Error> {
        let most = MOST_NODES.iter().chain([&(MOST_PLACES as u32)]);
        let in_range = counts.iter().zip(most).all(|(count, most)| count <= most && *count > 0);
        let [lateral, levels, yaw, roll, places] = counts.map(|count| count as usize);
        let counts = Self { lateral, levels, yaw, roll, places };
        Error::Capacity.unless(in_range && lateral > 1 && levels > 2 && places > 3)?;
        Ok(counts)
    }

    fn numbers(&self) -> [usize; 5] {
        [self.lateral, self.levels, self.yaw, self.roll, self.places]
    }
}

/// Some bytes of a block; zeros past its end.
fn bytes_at<const N: usize>(block: &[u8], at: usize) -> [u8; N] {
    let own = block.get(at..at.saturating_add(N));
    own.and_then(|own| own.try_into().ok()).unwrap_or([0; N])
}

pub(super) fn number_at(block: &[u8], at: usize) -> f64 {
    f64::from_le_bytes(bytes_at(block, at))
}

pub(super) fn write_bytes<const N: usize>(block: &mut [u8], at: usize, bytes: [u8; N]) {
    if let Some(own) = block.get_mut(at..at.saturating_add(N)) {
        own.iter_mut().zip(bytes).for_each(|(own, byte)| *own = byte);
    }
}

/// FNV-1a over words of eight bytes, and of the bytes that are left.
fn checksum(bytes: &[u8]) -> u64 {
    let (words, rest) = bytes.as_chunks::<8>();
    let words = words.iter().map(|word| u64::from_le_bytes(*word));
    let all = words.chain(rest.iter().map(|byte| u64::from(*byte)));
    all.fold(0xcbf2_9ce4_8422_2325, |sum, word| {
        (sum ^ word).wrapping_mul(0x0100_0000_01b3).rotate_left(23)
    })
}

/// What stands where for a node.
#[derive(Clone, Copy, Default)]
pub(super) struct Record {
    /// Bytes from the beginning of the fields.
    pub offset: u32,
    pub first: u16,
    pub count: u16,
    /// `l²`, `p²` and half angle of one step of their integers.
    pub scales: [f32; 3],
}

impl Record {
    pub fn bytes(self) -> [u8; RECORD] {
        let mut bytes = [0; RECORD];
        write_bytes(&mut bytes, 0, self.offset.to_le_bytes());
        write_bytes(&mut bytes, 4, self.first.to_le_bytes());
        write_bytes(&mut bytes, 6, self.count.to_le_bytes());
        for (k, scale) in self.scales.into_iter().enumerate() {
            write_bytes(&mut bytes, 8 + 4 * k, scale.to_le_bytes());
        }
        bytes
    }
}

/// How many bytes tell the length of a head.
pub(crate) const HEAD_START: u32 = NUMBERS_AT as u32;

/// The length of the part before the heights, which is only read while a table is filled.
pub(crate) fn head_length(start: &[u8]) -> Result<u32, Error> {
    let word = |at: usize| u32::from_le_bytes(bytes_at(start, at));
    let is_table = u64::from_le_bytes(bytes_at(start, 0)) == MAGIC && word(8) == VERSION;
    Error::Table.unless(is_table)?;
    let counts = Counts::checked(core::array::from_fn(|k| word(CHECKED_FROM + 4 * k)));
    let [.., heights, _, _] = counts.map_err(|_| Error::Table)?.sections();
    Ok(heights as u32)
}

/// A table that is read in place.
#[derive(Clone, Copy)]
pub struct ContactTable<'a> {
    bytes: &'a [u8],
    pub(super) counts: Counts,
    sections: [usize; 6],
}

impl<'a> ContactTable<'a> {
    /// The table in a block, if its header is that of one. Not all of it is read:
    /// [`ContactTable::check`] does that.
    ///
    /// # Errors
    /// [`Error::Table`], [`Error::TableUnfinished`].
    pub fn new(block: &'a [u8]) -> Result<Self, Error> {
        Self::in_state(block, FINISHED)
    }

    pub(super) fn in_state(block: &'a [u8], state: u32) -> Result<Self, Error> {
        let word = |at: usize| u32::from_le_bytes(bytes_at(block, at));
        let is_table = u64::from_le_bytes(bytes_at(block, 0)) == MAGIC && word(8) == VERSION;
        Error::Table.unless(is_table)?;
        let length = u64::from_le_bytes(bytes_at(block, LENGTH_AT));
        let length = usize::try_from(length).map_err(|_| Error::Table)?;
        let counts = Counts::checked(core::array::from_fn(|k| word(CHECKED_FROM + 4 * k)));
        let counts = counts.map_err(|_| Error::Table)?;
        let sections = counts.sections();
        let [.., heights, _, fields] = sections;
        let is_possible = counts.most_bytes().is_ok_and(|most| length <= most);
        Error::Table.unless(length >= fields && is_possible)?;
        // of a table that is being filled other threads may have the rest
        let needed = if state == BEGUN { heights } else { length };
        let bytes = block.get(..needed.max(block.len().min(length))).ok_or(Error::Table)?;
        let found = word(12);
        Error::Table.unless(found == BEGUN || found == FINISHED)?;
        Error::TableUnfinished.unless(found == state)?;
        Ok(Self { bytes, counts, sections })
    }

    /// Its length \[bytes\].
    #[must_use]
    pub const fn byte_count(&self) -> u32 {
        self.bytes.len() as u32
    }

    /// Reads all of it.
    ///
    /// # Errors
    /// [`Error::Table`] where a bit is not as it was written.
    pub fn check(&self) -> Result<(), Error> {
        let written = u64::from_le_bytes(bytes_at(self.bytes, CHECKSUM_AT));
        let rest = self.bytes.get(CHECKED_FROM..).unwrap_or(&[]);
        Error::Table.unless(written == checksum(rest))
    }

    pub(super) fn quantity(&self, number: Quantity) -> f64 {
        number_at(self.bytes, NUMBERS_AT + 8 * number as usize)
    }

    fn number_of<F: Float>(&self, section: usize, k: usize) -> F {
        let from = self.sections.get(section).copied().unwrap_or(usize::MAX / 2);
        F::of(number_at(self.bytes, from + 8 * k))
    }

    /// The lateral position of a part \[m\].
    pub(super) fn lateral<F: Float>(&self, part: usize) -> F {
        self.number_of(0, part)
    }

    /// The lateral node `k` between slabs \[m\].
    pub(super) fn lateral_between<F: Float>(
        &self, [of_roll, of_yaw]: &[Around<F>; 2], k: usize,
    ) -> F {
        let Counts { lateral, yaw, .. } = self.counts;
        of_roll.blend(|r| of_yaw.blend(|a| self.lateral((r * yaw + a) * lateral + k)))
    }

    /// Supports of the levels, to the power 2/3.
    pub(super) fn load<F: Float>(&self, level: usize) -> F {
        self.number_of(1, level)
    }

    /// Length on the wheel of a place, from the first point of its profile \[m\].
    pub(super) fn along<F: Float>(&self, k: usize) -> F {
        F::of(self.quantity(Quantity::Spacing)) * F::widened(k as f32)
    }

    /// The wheel's profile at a place.
    pub(super) fn point<F: Float>(&self, k: usize) -> CurvePoint<F> {
        let [y, z, cosine, sine] = [0, 1, 2, 3].map(|member| self.number_of(2, 4 * k + member));
        CurvePoint { y, z, cosine, sine }
    }

    /// The heights of the levels of a part \[m\].
    pub(super) fn heights<F: Float>(&self, part: usize) -> impl Iterator<Item = F> + '_ {
        let ([.., heights, _, _], levels) = (self.sections, self.counts.levels);
        let from = heights + 8 * levels * part;
        let own = self.bytes.get(from..from + 8 * levels).unwrap_or(&[]);
        own.as_chunks::<8>().0.iter().map(|bytes| F::of(f64::from_le_bytes(*bytes)))
    }

    /// The yaw squared of a slab, of its number among yaws.
    pub(super) fn yaw_squared<F: Float>(&self, k: usize) -> F {
        let last = (self.counts.yaw - 1).max(1) as f32;
        let largest = F::of(self.quantity(Quantity::Yaw));
        largest * largest * F::widened(k as f32 / last)
    }

    pub(super) fn roll<F: Float>(&self, k: usize) -> F {
        let last = (self.counts.roll - 1) as f32;
        if last == 0.0 {
            return F::zero();
        }
        F::of(self.quantity(Quantity::Roll)) * F::widened(2.0 * k as f32 / last - 1.0)
    }

    /// The roll and the yaw of a slab.
    pub(super) fn roll_and_yaw<F: Float>(&self, slab: usize) -> [F; 2] {
        let yaws = self.counts.yaw.max(1);
        [self.roll(slab / yaws), self.yaw_squared::<F>(slab % yaws).sqrt()]
    }

    /// The nodes around a roll and a yaw.
    pub(super) fn slabs_around<F: Float>(&self, roll: F, yaw: F) -> [Around<F>; 2] {
        let Counts { yaw: yaws, roll: rolls, .. } = self.counts;
        [
            Around::new(|k| self.roll(k), rolls, roll),
            Around::new(|k| self.yaw_squared(k), yaws, yaw * yaw),
        ]
    }

    pub(super) fn record(&self, node: usize) -> Record {
        let [.., records, _] = self.sections;
        let at = records + RECORD * node;
        Record {
            offset: u32::from_le_bytes(bytes_at(self.bytes, at)),
            first: u16::from_le_bytes(bytes_at(self.bytes, at + 4)),
            count: u16::from_le_bytes(bytes_at(self.bytes, at + 6)),
            scales: [8, 12, 16].map(|own| f32::from_le_bytes(bytes_at(self.bytes, at + own))),
        }
    }

    /// `l²` and `p²` of a node, and its half angles, in the steps of its scales.
    pub(super) fn fields(&self, record: &Record) -> ([&'a [[u8; 2]]; 2], &'a [u8]) {
        let [.., fields] = self.sections;
        let (from, count) = (fields.saturating_add(record.offset as usize), record.count as usize);
        let bytes = self.bytes.get(from..from.saturating_add(FIELD * count)).unwrap_or(&[]);
        let (squares, angles) = bytes.split_at(bytes.len().min(4 * count));
        let (lengths, pressures) = squares.split_at(squares.len().min(2 * count));
        ([lengths, pressures].map(|list| list.as_chunks::<2>().0), angles)
    }

    /// Whether it is that of these materials and this radius.
    ///
    /// # Errors
    /// [`Error::TablePair`]; those of the pair.
    pub(super) fn check_pair<F: Float>(&self, pair: &WheelPair<F>) -> Result<(), Error> {
        check_pair(pair)?;
        let WheelPair { wheel_radius, shear_modulus, poisson_ratio, .. } = *pair;
        let same = [
            (Quantity::WheelRadius, wheel_radius),
            (Quantity::ShearModulus, shear_modulus),
            (Quantity::PoissonRatio, poisson_ratio),
            (Quantity::SmoothingLength, pair.smoothing_length),
        ];
        let same = same.iter().all(|(number, own)| F::of(self.quantity(*number)) == *own);
        Error::TablePair.unless(same && pair.rail_radius <= F::zero())
    }
}

/// Checks a pair and its materials.
///
/// # Errors
/// Those of the pair; [`Error::Modulus`], [`Error::PoissonRatio`].
pub(super) fn check_pair<F: Float>(pair: &WheelPair<F>) -> Result<(), Error> {
    pair.check()?;
    check_modulus(pair.shear_modulus)?;
    check_poisson_ratio(pair.poisson_ratio)
}

/// Writes the header of a table that is begun.
pub(super) fn write_header(block: &mut [u8], counts: &Counts, length: usize) {
    write_bytes(block, 0, MAGIC.to_le_bytes());
    write_bytes(block, 8, VERSION.to_le_bytes());
    write_bytes(block, 12, BEGUN.to_le_bytes());
    write_bytes(block, LENGTH_AT, (length as u64).to_le_bytes());
    write_bytes(block, CHECKSUM_AT, [0; 8]);
    write_bytes(block, CHECKED_FROM, [0; NUMBERS_AT - CHECKED_FROM]);
    for (k, count) in counts.numbers().into_iter().enumerate() {
        write_bytes(block, CHECKED_FROM + 4 * k, (count as u32).to_le_bytes());
    }
}

pub(super) fn write_number(block: &mut [u8], number: Quantity, value: f64) {
    write_bytes(block, NUMBERS_AT + 8 * number as usize, value.to_le_bytes());
}

/// Writes length, state and checksum of a table that is complete.
pub(super) fn seal(block: &mut [u8], length: usize) {
    let sum = checksum(block.get(CHECKED_FROM..length).unwrap_or(&[]));
    write_bytes(block, LENGTH_AT, (length as u64).to_le_bytes());
    write_bytes(block, 12, FINISHED.to_le_bytes());
    write_bytes(block, CHECKSUM_AT, sum.to_le_bytes());
}
