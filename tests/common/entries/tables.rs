//! Contact tables: ranges near those of a wheel on a rail, bytes of tables with any changes.

use super::super::*;
use super::contacts::friction_of;
use super::wheels::{Scene, plausible};
use super::*;
use crate::manchester::zeroed;
use std::sync::OnceLock;

/// A wheel on a rail, both round.
fn round() -> Scene {
    let mut scene = Scene::new(&mut Bytes(&[]));
    let y: [Float; 41] = std::array::from_fn(|k| (k as Float - 20.0) * 1e-3);
    for (surface, bend) in [(&mut scene.rail, 1.0), (&mut scene.wheel, -0.5)] {
        let z = y.map(|y| bend * y * y);
        // SAFETY: as many points as said.
        let status =
            unsafe { kstrip_prepare_profile(y.as_ptr(), z.as_ptr(), 41, 0.0, 0.0, Some(surface)) };
        assert_eq!(status, 0);
    }
    scene.pair = kstrip_wheel_pair {
        wheel_radius: 0.46,
        shear_modulus: 82e9,
        poisson_ratio: 0.28,
        friction: 0.3,
        ..*zeroed()
    };
    scene
}

const SMALL: kstrip_table_spec = kstrip_table_spec {
    lateral_from: -1e-3,
    lateral_to: 1e-3,
    yaw: 0.0,
    roll: 0.0,
    load: 2e5,
    lateral_nodes: 9,
    levels: 3,
    yaw_nodes: 0,
    roll_nodes: 0,
    strips: 12,
    reserved: 0,
};

/// A small table, one of whose members may be anything.
fn spec(bytes: &mut Bytes) -> kstrip_table_spec {
    let mut spec = SMALL;
    match bytes.byte() {
        0..=31 => spec.lateral_from = Number::of(bytes, 1e-3),
        32..=63 => spec.lateral_to = Number::of(bytes, 1e-3),
        64..=95 => spec.yaw = Number::of(bytes, 1e-2),
        96..=127 => spec.roll = Number::of(bytes, 1e-3),
        128..=159 => spec.load = Number::of(bytes, 1e5),
        160..=175 => spec.levels = bytes.integer() as u32,
        176..=191 => spec.lateral_nodes = bytes.integer() as u32,
        192..=207 => spec.strips = bytes.integer() as u32,
        208..=223 => spec.yaw_nodes = bytes.integer() as u32,
        224..=239 => spec.roll_nodes = bytes.integer() as u32,
        _ => {}
    }
    spec
}

/// A table that is begun, that is filled, and that is finished.
fn tables() -> &'static [Vec<u8>; 3] {
    static TABLES: OnceLock<[Vec<u8>; 3]> = OnceLock::new();
    TABLES.get_or_init(|| {
        let (scene, mut memory) = (round(), zeroed::<kstrip_wheel_workspace>());
        let (rail, wheel, pair) = (Some(&*scene.rail), Some(&*scene.wheel), Some(&scene.pair));
        let (mut size, mut parts) = (poisoned::<u32>(), poisoned::<u32>());
        let status = kstrip_table_size(wheel, Some(&SMALL), Some(&mut size), Some(&mut parts));
        assert_eq!(status, 0);
        let (size, parts) = (written(&size), written(&parts));
        let mut begun = vec![0x5a_u8; size as usize];
        let place = begun.as_mut_ptr();
        // SAFETY: as many bytes as said.
        let status = unsafe {
            kstrip_table_begin(rail, wheel, pair, Some(&SMALL), Some(&mut memory), place, size)
        };
        assert_eq!(status, 0);
        let mut filled = begun.clone();
        let place = filled.as_mut_ptr();
        // SAFETY: as many bytes as said.
        let status = unsafe {
            kstrip_table_fill(rail, wheel, pair, 0, parts, Some(&mut memory), place, size)
        };
        assert_eq!(status, 0);
        let (mut finished, mut report) = (filled.clone(), poisoned::<kstrip_table_report>());
        let place = finished.as_mut_ptr();
        // SAFETY: as many bytes as said.
        let status = unsafe {
            let (memory, report) = (Some(&mut *memory), Some(&mut report));
            kstrip_table_finish(rail, wheel, pair, 2, memory, place, size, report)
        };
        assert_eq!(status, 0);
        finished.truncate(written(&report).bytes as usize);
        [begun, filled, finished]
    })
}

/// A copy of a table, some of whose bytes may be others.
fn damaged(bytes: &mut Bytes, table: &[u8]) -> Vec<u8> {
    let mut copy = table.to_vec();
    for _ in 0..bytes.below(4) {
        let at = usize::from(u16::from_le_bytes(bytes.take())) % copy.len();
        copy[at] ^= bytes.byte();
    }
    copy
}

fn table_size(bytes: &mut Bytes) {
    let (scene, spec, given) = (Scene::new(bytes), spec(bytes), bytes.given());
    let (mut size, mut parts) = (poisoned::<u32>(), poisoned::<u32>());
    let status = kstrip_table_size(
        given.input(0, &scene.wheel),
        given.input(1, &spec),
        given.output(2, &mut size),
        given.output(3, &mut parts),
    );
    if answered(status, untouched(&size) && untouched(&parts)) {
        assert!(written(&parts) >= 9 && written(&size) > 32 * written(&parts));
    }
}

fn table_begin(bytes: &mut Bytes) {
    let (scene, spec, given) = (round(), spec(bytes), bytes.given());
    // what can be made takes its time
    let is_good = spec == SMALL && given.all(4);
    let mut block = vec![0x5a_u8; if is_good && bytes.byte() > 8 { 1000 } else { 1 << 20 }];
    let (mut memory, length) = (zeroed::<kstrip_wheel_workspace>(), block.len() as u32);
    // SAFETY: as many bytes as said.
    let status = unsafe {
        kstrip_table_begin(
            given.input(0, &*scene.rail),
            given.input(1, &*scene.wheel),
            given.input(2, &scene.pair),
            given.input(3, &spec),
            Some(&mut memory),
            block.as_mut_ptr(),
            length,
        )
    };
    answered(status, block.iter().all(|byte| *byte == 0x5a));
}

fn table_fill(bytes: &mut Bytes) {
    let (scene, [begun, ..]) = (round(), tables());
    let mut block = damaged(bytes, begun);
    let (first, count) = (bytes.integer() as u32 % 16, u32::from(bytes.byte() % 2));
    let length = block.len() as u32 - u32::from(bytes.byte() / 128);
    let mut memory = zeroed::<kstrip_wheel_workspace>();
    // SAFETY: no more bytes than there are.
    let status = unsafe {
        let (rail, wheel) = (Some(&*scene.rail), Some(&*scene.wheel));
        let (pair, place) = (Some(&scene.pair), block.as_mut_ptr());
        kstrip_table_fill(rail, wheel, pair, first, count, Some(&mut memory), place, length)
    };
    assert!(known(status));
}

fn table_finish(bytes: &mut Bytes) {
    let (scene, [_, filled, _]) = (round(), tables());
    let mut block = damaged(bytes, filled);
    let mut memory = zeroed::<kstrip_wheel_workspace>();
    let (length, mut report) = (block.len() as u32, poisoned::<kstrip_table_report>());
    // SAFETY: as many bytes as said.
    let status = unsafe {
        let (rail, wheel, pair) = (Some(&*scene.rail), Some(&*scene.wheel), Some(&scene.pair));
        let (memory, report) = (Some(&mut *memory), Some(&mut report));
        kstrip_table_finish(rail, wheel, pair, 2, memory, block.as_mut_ptr(), length, report)
    };
    if answered(status, untouched(&report)) {
        let report = written(&report);
        assert!(report.bytes <= length && report.poses <= 2);
        assert!(finite(&[report.force_usual, report.force_largest]));
        assert!(finite(&[report.load_usual, report.load_largest]));
    }
}

fn table_check(bytes: &mut Bytes) {
    let [.., finished] = tables();
    let block = damaged(bytes, finished);
    let given = bytes.given();
    let mut length = poisoned::<u32>();
    // SAFETY: as many bytes as said.
    let status = unsafe {
        let table = given.array(0, &block);
        kstrip_table_check(table, block.len() as u32, given.output(1, &mut length))
    };
    if answered(status, untouched(&length)) && given.has(1) {
        assert!(written(&length) as usize <= block.len());
    }
}

fn wheel_on_table(bytes: &mut Bytes) {
    let mut scene = Scene::new(bytes);
    let [.., finished] = tables();
    if bytes.byte() < 200 {
        // those of the table
        let kstrip_wheel_pair { wheel_radius, shear_modulus, poisson_ratio, .. } = round().pair;
        scene.pair = kstrip_wheel_pair {
            wheel_radius,
            shear_modulus,
            poisson_ratio,
            rail_radius: 0.0,
            ..scene.pair
        };
    }
    let block = damaged(bytes, finished);
    let only = i32::from(bytes.byte() % 2);
    let table = kstrip_table { data: block.as_ptr(), bytes: block.len() as u32, only };
    let (law, with_law, given) = (friction_of(bytes), bytes.byte() < 64, bytes.given());
    let mut memory = zeroed::<kstrip_wheel_workspace>();
    let (mut out, mut slopes, mut moved) = (poisoned::<kstrip_wrench>(), poisoned(), poisoned());
    let wanted = bytes.byte();
    // SAFETY: as many bytes as said.
    let status = unsafe {
        kstrip_wheel_on_table(
            given.input(0, &table),
            given.input(1, &scene.pair),
            given.input(2, &scene.position),
            given.input(3, &scene.velocity),
            with_law.then_some(&law),
            given.has(4).then_some(&mut memory),
            given.output(5, &mut out),
            (wanted < 32).then_some(&mut slopes),
            (wanted < 8).then_some(&mut moved),
        )
    };
    let slopes_untouched = untouched::<kstrip_wrench_derivatives>(&slopes)
        && untouched::<kstrip_wrench_by_position>(&moved);
    if answered(status, untouched(&out) && slopes_untouched) {
        plausible(&written(&out), status);
    }
    let mut height = poisoned::<Float>();
    // SAFETY: as many bytes as said.
    let status = unsafe {
        kstrip_height_for_load(
            Some(&*scene.rail),
            Some(&*scene.wheel),
            Some(&scene.pair),
            Some(&scene.position),
            Number::of(bytes, 1e4),
            None,
            None,
            Some(&table),
            Some(&mut memory),
            Some(&mut height),
        )
    };
    if answered(status, untouched(&height)) {
        assert!(written(&height).is_finite());
    }
}

pub const ENTRIES: &[Entry] = &[
    ("table_size", table_size),
    ("table_begin", table_begin),
    ("table_fill", table_fill),
    ("table_finish", table_finish),
    ("table_check", table_check),
    ("wheel_on_table", wheel_on_table),
];
