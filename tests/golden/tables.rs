//! The same bits of a contact table, of its report, and of wheels on it:
//! `tests/data/golden_tables.txt`, written like the others.

use crate::bits::{Bits, Hash, compare, draw};
use crate::searches::{swing, velocity};
use crate::wheel::{PAIRS, Stand, hash_contacts};
use kstrip::table::{ContactTable, TableReport, TableScene, TableSpec, fill_part, finish};
use kstrip_testing::prelude::*;

/// A table from the tread to the flange, with yaw and roll.
fn table<F: Bits>(stand: &mut Stand<F>) -> (Vec<u8>, TableReport<F>) {
    let spec = TableSpec {
        lateral_from: F::of(-13e-3),
        lateral_to: F::of(-3e-3),
        yaw: F::of(8e-3),
        roll: F::of(2.5e-3),
        load: F::of(120e3),
        lateral_nodes: 12,
        levels: 6,
        yaw_nodes: 2,
        roll_nodes: 3,
        strips: 16,
        reserved: 0,
    };
    let Stand { rail, wheel, pair, memory } = stand;
    let law = Law { model: Model::Strip, falling: None };
    let scene = Scene { rail, wheel, pair, strips: StripCount::Sixteen, law, table: None };
    let [bytes, parts] = spec.size(wheel).expect("a size");
    let mut block = vec![0; bytes as usize];
    spec.begin_table(&scene, memory, &mut block).expect("a table that is begun");
    for part in 0..parts {
        fill_part(&scene, part as usize, memory, &mut block).expect("a part");
    }
    let report = finish(&scene, 20, memory, &mut block).expect("a table");
    block.truncate(report.bytes as usize);
    (block, report)
}

/// Wheels on a table: forces and their derivatives, and the contacts.
fn hash_wheels<F: Bits>(hash: &mut Hash, stand: &mut Stand<F>, block: &[u8]) {
    let Stand { pair, memory, .. } = stand;
    let law = Law { model: Model::Strip, falling: None };
    let scene = TableScene { table: ContactTable::new(block).expect("a table"), pair, law };
    for i in 0..1000 {
        let place = [8e-3 * swing(i, 1) - 9e-3, 0.3e-3 * swing(i, 2), 9e-3 * swing(i, 3)];
        let [lateral, vertical, yaw] = place.map(F::of);
        // (some lie outside the table)
        let roll = F::of(2.6e-3 * swing(i, 4));
        let position = Position { lateral, vertical, yaw, roll };
        let state = BodyState { position, velocity: velocity(i) };
        let (mut by_velocity, mut by_position) = Default::default();
        let slopes = draw(i, 5, 4) == 0;
        let requested = Requested {
            by_velocity: slopes.then_some(&mut by_velocity),
            by_position: slopes.then_some(&mut by_position),
        };
        if !hash.wrench(scene.differentiate(&state, Some(memory), requested)) {
            continue;
        }
        hash_contacts(hash, memory);
        let WrenchDerivatives { velocity, friction } = by_velocity;
        velocity.iter().chain([&friction]).for_each(|row| hash.add(row));
        let WrenchByPosition { lateral, vertical, yaw, roll } = by_position;
        [lateral, vertical, yaw, roll].iter().for_each(|slopes| hash.add(slopes));
    }
}

fn hashes<F: Bits>(precision: &str) -> String {
    let mut stand = Stand::<F>::new(PAIRS[0]);
    let (block, report) = table(&mut stand);
    let [mut bytes, mut wheels] = [Hash::START; 2];
    block.iter().for_each(|byte| bytes.mix(u64::from(*byte)));
    let TableReport { force_usual, force_largest, load_usual, load_largest, .. } = report;
    bytes.add(&[force_usual, force_largest, load_usual, load_largest]);
    [report.missing, report.empty].iter().for_each(|count| bytes.mix(u64::from(*count)));
    hash_wheels(&mut wheels, &mut stand, &block);
    let [bytes, wheels] = [bytes, wheels].map(|hash| hash.value());
    format!("{precision} table {bytes:016x}\n{precision} wheels on it {wheels:016x}\n")
}

/// (In builds without optimisation, `KSTRIP_GOLDEN_FEW`, this would take a minute.)
#[test]
fn tables_give_the_golden_bits() {
    if std::env::var_os("KSTRIP_GOLDEN_FEW").is_some() {
        return;
    }
    compare("golden_tables.txt", hashes::<f64>, hashes::<f32>);
}
