//! A table is finished: what its nodes do not use is left out, and its error is measured at poses
//! that are spread over its ranges.

use super::block::{
    BEGUN, ContactTable, Counts, FIELD, Quantity, RECORD, Record, seal, write_bytes, write_number,
};
use super::fill::plain;
use super::lookup::TableScene;
use crate::contact::totals::StripCount;
use crate::forces::Model;
use crate::number::{Float, length};
use crate::status::Error;
use crate::wheel_rail::forces::wrench::Law;
use crate::wheel_rail::scene::{Scene, Workspace};
use crate::wheel_rail::{BodyState, Position, Requested, Velocity, WheelPair};

/// Supports of the poses over the largest of the table.
const SUPPORTS: [f64; 2] = [0.023, 0.91];
const FRICTION: f64 = 0.3;
const SPEED: f64 = 20.0;
/// Classes of errors: so many to a factor of e, from the least on.
const CLASSES: usize = 256;
const TO_E: f64 = 16.0;
const LEAST: f64 = 1e-6;

/// The size of a finished table, and its measured error.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TableReport<F> {
    /// Error of the horizontal force over friction times load \[-\]: not exceeded by 95 of 100
    /// poses.
    pub force_usual: F,
    /// The largest one \[-\].
    pub force_largest: F,
    /// Error of the vertical force over that force \[-\]: not exceeded by 95 of 100 poses.
    pub load_usual: F,
    /// The largest one \[-\].
    pub load_largest: F,
    /// Length of the table \[bytes\].
    pub bytes: u32,
    /// Number of poses that were compared.
    pub poses: u32,
    /// Number of poses that the direct computation has, and the table has not.
    pub missing: u32,
    /// Number of nodes without a contact.
    pub empty: u32,
}

/// Errors by their classes.
struct Errors<F> {
    classes: [u32; CLASSES],
    largest: F,
}

impl<F: Float> Errors<F> {
    const fn new() -> Self {
        Self { classes: [0; CLASSES], largest: F::ZERO }
    }

    fn count_error(&mut self, error: F) {
        self.largest = self.largest.max(error);
        let class = (error.times(1.0 / LEAST).max(F::one()).ln().times(TO_E)).whole();
        let class = (class.max(0) as usize).min(CLASSES - 1);
        if let Some(count) = self.classes.get_mut(class) {
            *count += 1;
        }
    }

    /// The upper bound of the class that 95 of 100 do not exceed.
    fn usual(&self) -> F {
        let all = self.classes.iter().sum::<u32>();
        let (mut sum, mut bound) = (0, F::zero());
        for (k, count) in self.classes.iter().enumerate() {
            if sum * 20 >= all * 19 {
                break;
            }
            sum += count;
            bound = F::widened((k + 1) as f32).times(1.0 / TO_E).exp().times(LEAST);
        }
        bound.min(self.largest)
    }
}

/// Moves the fields together. Returns the length of the table, and how many nodes have no contact.
fn compact(block: &mut [u8], counts: &Counts) -> Result<(usize, u32), Error> {
    let [.., heights, records, fields] = counts.sections();
    let (mut length, mut empty) = (0_usize, 0);
    for node in 0..counts.all_nodes() {
        let table = ContactTable::in_state(block, BEGUN)?;
        let is_filled = block.get(heights + 8 * node..).and_then(|own| own.get(..8));
        Error::TableUnfinished.when(is_filled.is_none_or(|own| own == [u8::MAX; 8]))?;
        let record = table.record(node);
        empty += u32::from(record.count == 0);
        let bytes = FIELD * record.count as usize;
        let (from, to) = (fields + record.offset as usize, fields + length);
        for k in 0..bytes {
            let byte = block.get(from + k).copied().ok_or(Error::Table)?;
            write_bytes(block, to + k, [byte]);
        }
        let moved = Record { offset: length as u32, ..record };
        write_bytes(block, records + RECORD * node, moved.bytes());
        length += bytes;
    }
    Ok((fields + length, empty))
}

/// Makes a table that is filled compact, and measures its error at so many poses, with 16 strips
/// against the direct computation with 64.
///
/// # Errors
/// [`Error::TableUnfinished`] where a part was not filled; [`Error::Table`], [`Error::TablePair`].
pub fn finish<F: Float>(
    scene: &Scene<F>, poses: u32, memory: &mut Workspace<F>, block: &mut [u8],
) -> Result<TableReport<F>, Error> {
    let table = ContactTable::in_state(block, BEGUN)?;
    table.check_pair(scene.pair)?;
    scene.rail.check()?;
    scene.wheel.check()?;
    let counts = table.counts;
    let most = counts.most_bytes()?;
    Error::Table.when(block.len() < most)?;
    let (bytes, empty) = compact(block, &counts)?;
    seal(block, bytes);
    let mut report = TableReport { bytes: bytes as u32, empty, ..TableReport::default() };
    report.measure_errors(scene, poses, memory, &ContactTable::new(block)?)?;
    for (number, value) in [
        (Quantity::ForceUsual, report.force_usual),
        (Quantity::ForceLargest, report.force_largest),
        (Quantity::LoadUsual, report.load_usual),
        (Quantity::LoadLargest, report.load_largest),
    ] {
        write_number(block, number, value.to_f64());
    }
    seal(block, bytes);
    Ok(report)
}

impl<F: Float> TableReport<F> {
    fn measure_errors(
        &mut self, scene: &Scene<F>, poses: u32, memory: &mut Workspace<F>, table: &ContactTable,
    ) -> Result<(), Error> {
        let pair = WheelPair { friction: F::of(FRICTION), ..plain(scene.pair) };
        let law = Law { model: Model::Strip, falling: None };
        let direct =
            Scene { pair: &pair, strips: StripCount::SixtyFour, law, table: None, ..*scene };
        let by_table = TableScene { table: *table, pair: &pair, law };
        let (mut forces, mut loads) = (Errors::new(), Errors::new());
        for number in 1..=poses {
            let (position, support, velocity) = pose(table, &pair, number);
            let found = direct.height_for_load(&position, support, None, memory);
            let Ok((vertical, _)) = found else { continue };
            let position = Position { vertical, ..position };
            let state = BodyState { position, velocity };
            let Ok(own) = direct.solve(&state, memory) else { continue };
            let none = Requested { by_velocity: None, by_position: None };
            match by_table.differentiate(&state, Some(memory), none) {
                Ok(found) if own.contacts > 0 => {
                    let [x, y, z] = own.force;
                    let [a, b, c] = found.force;
                    let bound = own.normal_force * pair.friction;
                    forces.count_error(length(x - a, y - b) / bound);
                    loads.count_error((c / z - F::one()).abs());
                    self.poses += 1;
                }
                Err(Error::TableRange) => self.missing += 1,
                Err(error) => return Err(error),
                Ok(_) => {}
            }
        }
        (self.force_usual, self.force_largest) = (forces.usual(), forces.largest);
        (self.load_usual, self.load_largest) = (loads.usual(), loads.largest);
        Ok(())
    }
}

/// A position without its height, a support and a velocity: the fractions of multiples of
/// irrational numbers spread them evenly.
fn pose<F: Float>(
    table: &ContactTable, pair: &WheelPair<F>, number: u32,
) -> (Position<F>, F, Velocity<F>) {
    let fraction = |step: f64| {
        let product = f64::from(number) * step;
        F::of(product - f64::from(product as u32))
    };
    let both = |step: f64| fraction(step).times(2.0).plus(-1.0);
    let [lateral, load, yaw, roll] = [
        0.618_033_988_749_894_9,
        0.819_172_513_396_164_5,
        0.754_877_666_246_692_7,
        0.569_840_290_998_053_2,
    ];
    let yaw = both(yaw) * F::of(table.quantity(Quantity::Yaw));
    let roll = both(roll) * F::of(table.quantity(Quantity::Roll));
    let slabs = table.slabs_around(roll, yaw);
    let [least, most] =
        [0, table.counts.lateral - 1].map(|k| table.lateral_between::<F>(&slabs, k));
    let lateral = least + (most - least) * fraction(lateral);
    let [low, high] = SUPPORTS.map(F::of);
    let largest = F::of(table.quantity(Quantity::Load));
    let support = largest * low * ((high / low).ln() * fraction(load)).exp();
    let speed = F::of(SPEED);
    let velocity = Velocity {
        forward: speed,
        lateral: speed * yaw + both(0.671_043_606_703_789_3).times(0.12),
        pitch: -(speed / pair.wheel_radius) * both(0.549_700_477_901_970_3).times(4e-3).plus(1.0),
        yaw: both(0.414_213_562_373_095).times(0.02),
        ..Velocity::default()
    };
    (Position { lateral, vertical: F::zero(), yaw, roll }, support, velocity)
}
