//! Contact tables: near the direct computation, continuous, the same bytes on any threads, and
//! never trusted.

use kstrip::ffi::types::kstrip_table;
use kstrip::ffi::*;
use kstrip::table::{ContactTable, TableReport, TableScene, TableSpec, fill_part, finish, source};
use kstrip::wheelset::forces::{Wheelset, WheelsetWorkspace};
use kstrip::wheelset::kinematics::Side;
use kstrip::wheelset::settle::WheelsetLoads;
use kstrip_testing::manchester::turned;
use kstrip_testing::prelude::*;
use std::sync::OnceLock;

const STRIP: Law<'static, f64> = Law { model: Model::Strip, falling: None };
/// A wheel that rolls freely.
const ROLLING: Velocity<f64> = Velocity {
    forward: 20.0,
    lateral: 0.0,
    vertical: 0.0,
    roll: 0.0,
    pitch: -20.0 / 0.46,
    yaw: 0.0,
};

const PAIR: WheelPair<f64> = WheelPair {
    wheel_radius: 0.46,
    shear_modulus: 82e9,
    poisson_ratio: 0.28,
    friction: 0.3,
    ..zero_pair()
};
/// From the tread to the root of the flange, for a test that is built in seconds.
const SPEC: TableSpec<f64> = TableSpec {
    lateral_from: -13e-3,
    lateral_to: -5.5e-3,
    yaw: 8e-3,
    roll: 0.0,
    load: 120e3,
    lateral_nodes: 32,
    levels: 14,
    yaw_nodes: 0,
    roll_nodes: 0,
    strips: 0,
    reserved: 0,
};

const fn zero_pair() -> WheelPair<f64> {
    WheelPair {
        wheel_radius: 0.0,
        shear_modulus: 0.0,
        poisson_ratio: 0.0,
        friction: 0.0,
        friction_y: [0.0; 4],
        friction_at: [0.0; 4],
        friction_points: 0,
        left: 0,
        smoothing_length: 0.0,
        strips: 0,
        model: 0,
        normal_damping: 0.0,
        floor_speed: 0.0,
        rail_radius: 0.0,
        rail_ahead: 0.0,
        rail_speed: 0.0,
    }
}

/// Profiles, and a table of them.
struct Built {
    rail: Box<PreparedProfile<f64>>,
    wheel: Box<PreparedProfile<f64>>,
    table: Vec<u8>,
    report: TableReport<f64>,
}

fn scene_of<'a>(
    rail: &'a PreparedProfile<f64>, wheel: &'a PreparedProfile<f64>, pair: &'a WheelPair<f64>,
) -> Scene<'a, f64> {
    Scene { rail, wheel, pair, strips: StripCount::Sixteen, law: STRIP, table: None }
}

/// A table of a spec, with its parts filled in reverse order or by two threads.
fn build(
    rail: &PreparedProfile<f64>, wheel: &PreparedProfile<f64>, spec: &TableSpec<f64>, in_c: bool,
) -> (Vec<u8>, TableReport<f64>) {
    let scene = scene_of(rail, wheel, &PAIR);
    let mut memory = zeroed::<Workspace<f64>>();
    let [bytes, parts] = spec.size(wheel).unwrap();
    let mut block = vec![0x5a; bytes as usize];
    spec.begin_table(&scene, &mut memory, &mut block).unwrap();
    if in_c {
        let place = block.as_mut_ptr() as usize;
        let fill = |first: u32, count: u32| {
            let mut memory = zeroed::<Workspace<f64>>();
            // SAFETY: other threads fill other parts.
            let status = unsafe {
                double::kstrip_table_fill(
                    Some(rail),
                    Some(wheel),
                    Some(&PAIR),
                    first,
                    count,
                    Some(&mut memory),
                    place as *mut u8,
                    bytes,
                )
            };
            assert_eq!(status, KSTRIP_OK);
        };
        let half = parts / 2;
        std::thread::scope(|scope| {
            scope.spawn(|| fill(half, parts - half));
            fill(0, half);
        });
    } else {
        for part in (0..parts).rev() {
            fill_part(&scene, part as usize, &mut memory, &mut block).unwrap();
        }
    }
    let report = finish(&scene, 200, &mut memory, &mut block).unwrap();
    block.truncate(report.bytes as usize);
    (block, report)
}

fn built() -> &'static Built {
    static BUILT: OnceLock<Built> = OnceLock::new();
    BUILT.get_or_init(|| {
        let (rail, wheel) = (turned("uic60", 0.025), turned("s1002", 0.0));
        let (table, report) = build(&rail, &wheel, &SPEC, false);
        Built { rail, wheel, table, report }
    })
}

/// A wheel over a table.
fn on_table<'a>(table: &'a [u8], pair: &'a WheelPair<f64>) -> TableScene<'a, f64> {
    let table = ContactTable::new(table).unwrap();
    TableScene { table, pair, law: STRIP }
}

const NOTHING: fn() -> Requested<'static, WrenchDerivatives<f64>, WrenchByPosition<f64>> =
    || Requested { by_velocity: None, by_position: None };

/// A position at which the rail supports the wheel with a load.
fn loaded(lateral: f64, yaw: f64, load: f64) -> Position<f64> {
    let Built { rail, wheel, .. } = built();
    let mut memory = zeroed::<Workspace<f64>>();
    let position = Position { lateral, yaw, ..Position::default() };
    let found = scene_of(rail, wheel, &PAIR).height_for_load(&position, load, None, &mut memory);
    Position { vertical: found.unwrap().0, ..position }
}

#[test]
fn error_of_a_table_is_small_and_told() {
    let Built { report, table, .. } = built();
    println!("{report:?}");
    assert_eq!((report.empty, report.missing), (0, 0));
    assert!(report.poses == 200 && report.bytes as usize == table.len());
    assert!(report.force_usual < 0.015 && report.force_largest < 0.05, "{report:?}");
    assert!(report.load_usual < 0.008 && report.load_largest < 0.04, "{report:?}");
}

/// Two threads through C, and one in reverse order.
#[test]
fn bytes_of_a_table_do_not_depend_on_threads() {
    let Built { rail, wheel, .. } = built();
    let spec = TableSpec { lateral_nodes: 9, levels: 3, yaw: 0.0, ..SPEC };
    let tables = [false, true].map(|in_c| build(rail, wheel, &spec, in_c).0);
    assert!(tables[0] == tables[1]);
}

/// Steps in lateral and vertical position and in yaw, over regions that appear, merge and vanish:
/// the half with the larger change is taken until it is 1e-13 m long, where a slope of 1e9 N/m
/// changes the force by 2e-9 of the load, and a jump by its whole size.
#[test]
fn force_from_a_table_is_continuous() {
    let Built { table, .. } = built();
    let scene = on_table(table, &PAIR);
    let mut memory = zeroed::<Workspace<f64>>();
    let velocity = Velocity { lateral: 0.05, ..ROLLING };
    let mut force = |position: Position<f64>| {
        let state = BodyState { position, velocity };
        match scene.differentiate(&state, Some(&mut memory), NOTHING()) {
            Err(Error::TableRange) => None,
            found => Some(found.unwrap().members()),
        }
    };
    let mut worst = 0.0_f64;
    for lateral in [-12e-3, -9e-3, -7.5e-3, -6.5e-3] {
        let from = loaded(lateral, 1e-3, 60e3);
        for axis in 0..3 {
            let at = |share: f64| {
                let mut position = from;
                match axis {
                    0 => position.lateral += 0.4e-3 * share,
                    1 => position.vertical -= 0.15e-3 * share,
                    _ => position.yaw += 4e-3 * share,
                }
                position
            };
            let mut before = force(at(0.0)).unwrap();
            for k in 1..=200 {
                let (mut low, mut high) = (f64::from(k - 1) / 200.0, f64::from(k) / 200.0);
                let Some(next) = force(at(high)) else { break };
                let [mut one, mut two] = [before, next];
                before = next;
                let apart = |one: &[f64; 6], two: &[f64; 6]| {
                    one.iter().zip(two).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
                };
                // the half with the larger change
                while (high - low) * 0.4e-3 > 1e-13 {
                    let middle = 0.5 * (low + high);
                    let Some(between) = force(at(middle)) else { break };
                    if apart(&one, &between) > apart(&between, &two) {
                        (high, two) = (middle, between);
                    } else {
                        (low, one) = (middle, between);
                    }
                }
                worst = worst.max(apart(&one, &two) / 60e3);
            }
        }
    }
    println!("largest change over 1e-13 m, by the load: {worst:.1e}");
    assert!(worst < 3e-9, "{worst}");
}

#[test]
fn derivatives_from_a_table_are_those_of_its_forces() {
    let Built { table, .. } = built();
    let pair = WheelPair { normal_damping: 0.05, ..PAIR };
    let scene = on_table(table, &pair);
    let mut memory = zeroed::<Workspace<f64>>();
    let velocity = Velocity { lateral: 0.02, yaw: 1e-3, vertical: 0.1, ..ROLLING };
    for (lateral, yaw) in [(-12e-3, 0.0), (-9.3e-3, 2e-3), (-6e-3, -3e-3)] {
        let state = BodyState { position: loaded(lateral, yaw, 70e3), velocity };
        let (mut by, mut moved) = (WrenchDerivatives::default(), WrenchByPosition::default());
        let requested = Requested { by_velocity: Some(&mut by), by_position: Some(&mut moved) };
        let own = scene.differentiate(&state, Some(&mut memory), requested).unwrap();
        let mut at = |state: BodyState<f64>| {
            scene.differentiate(&state, Some(&mut memory), NOTHING()).unwrap().members()
        };
        let size = own.normal_force;
        let step = 1e-6;
        let [front, back] = [step, -step].map(|step| {
            let mut state = state;
            state.velocity.lateral += step;
            at(state)
        });
        for row in 0..3 {
            let slope = (front[row] - back[row]) / (2.0 * step);
            let error = (slope - by.velocity[row][1]).abs();
            assert!(error < 1e-4 * size / 0.1, "{row} {slope} {:?}", by.velocity[row]);
        }
        let [front, back] = [1e-6, -1e-6].map(|step| {
            let mut state = state;
            state.position.vertical += step;
            at(state)
        });
        for row in 0..3 {
            let slope = (front[row] - back[row]) / 2e-6;
            let error = (slope - moved.vertical[row]).abs();
            assert!(error < 0.02 * size / 5e-5, "{row} {slope} {:?}", moved.vertical);
        }
    }
}

#[test]
fn lost_contact_left_wheel_and_standstill() {
    let Built { table, .. } = built();
    let mut memory = zeroed::<Workspace<f64>>();
    let position = loaded(-9e-3, 2e-3, 80e3);
    let mut solve = |pair: &WheelPair<f64>, position, velocity| {
        on_table(table, pair).differentiate(
            &BodyState { position, velocity },
            Some(&mut memory),
            NOTHING(),
        )
    };
    let above = Position { vertical: position.vertical - 1e-3, ..position };
    let lifted = solve(&PAIR, above, ROLLING).unwrap();
    assert_eq!((lifted.contacts, lifted.members()), (0, [0.0; 6]));
    let velocity = Velocity { lateral: 0.03, yaw: 1e-3, roll: 2e-3, ..ROLLING };
    let right = solve(&PAIR, position, velocity).unwrap();
    let left = WheelPair { left: 1, ..PAIR };
    let Position { lateral, yaw, vertical, .. } = position;
    let mirrored = Position { lateral: -lateral, vertical, yaw: -yaw, roll: 0.0 };
    let Velocity { lateral, yaw, roll, .. } = velocity;
    let moves = Velocity { lateral: -lateral, yaw: -yaw, roll: -roll, ..velocity };
    let found = solve(&left, mirrored, moves).unwrap().members();
    let signs = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0];
    for ((own, other), sign) in right.members().iter().zip(found).zip(signs) {
        assert!((own - sign * other).abs() < 1e-9 * right.normal_force, "{own} {other}");
    }
    let still = solve(&PAIR, position, Velocity::default()).unwrap();
    assert!(still.normal_force > 70e3 && still.dissipation.abs() < 1e-6);
    for bad in
        [Position { lateral: f64::NAN, ..position }, Position { yaw: f64::INFINITY, ..position }]
    {
        assert_eq!(solve(&PAIR, bad, ROLLING), Err(Error::NotFinite));
    }
    for outside in [
        Position { lateral: -5.4e-3, ..position },
        Position { yaw: -9e-3, ..position },
        Position { roll: 1e-3, ..position },
        Position { vertical: vertical + 1e-3, ..position },
    ] {
        assert_eq!(solve(&PAIR, outside, ROLLING), Err(Error::TableRange));
    }
    for other in [
        WheelPair { wheel_radius: 0.45, ..PAIR },
        WheelPair { shear_modulus: 80e9, ..PAIR },
        WheelPair { rail_radius: 1.0, ..PAIR },
    ] {
        assert_eq!(solve(&other, position, ROLLING), Err(Error::TablePair));
    }
}

/// Without memory for contacts: the same forces and derivatives, with one contact and with several;
/// under falling friction and behind a layer, where they are those of the contacts that are listed.
#[test]
fn contacts_need_not_be_listed() {
    let Built { table, .. } = built();
    let wet = SlipFriction {
        friction: 1.0,
        ratio: 0.4,
        decay: 0.6,
        slope_factor: 0.5,
        layer: 2e-14,
        ..SlipFriction::default()
    };
    let (mut memory, mut counts) = (zeroed::<Workspace<f64>>(), [0; 4]);
    let velocity = Velocity { lateral: 0.03, yaw: 1e-3, ..ROLLING };
    for k in 0..60 {
        let load = [1.5e3, 3e3, 90e3][k as usize % 3];
        let position = loaded(-7.3e-3 + 1e-5 * f64::from(k), 1e-3, load);
        for falling in [None, Some(&wet)] {
            let law = Law { falling, ..STRIP };
            let scene = TableScene { law, ..on_table(table, &PAIR) };
            let state = BodyState { position, velocity };
            let solve = |memory: Option<&mut Workspace<f64>>| {
                let (mut by, mut moved) =
                    (WrenchDerivatives::default(), WrenchByPosition::default());
                let requested =
                    Requested { by_velocity: Some(&mut by), by_position: Some(&mut moved) };
                let found = scene.differentiate(&state, memory, requested).unwrap();
                (found, by, moved)
            };
            let listed = solve(Some(&mut memory));
            let alone = solve(None);
            let count = listed.0.contacts;
            assert_eq!((count, listed.0.warning), (alone.0.contacts, alone.0.warning));
            counts[count as usize] += 1;
            let size = listed.0.normal_force;
            let apart = |one: &[f64], two: &[f64], size: f64| {
                let near = one.iter().zip(two).all(|(a, b)| (a - b).abs() <= size);
                assert!(near && (count > 1 || one == two), "{one:?} {two:?}");
            };
            apart(&listed.0.members(), &alone.0.members(), 1e-12 * size);
            apart(&[listed.0.dissipation], &[alone.0.dissipation], 1e-12 * size);
            let rows = listed.1.velocity.iter().zip(&alone.1.velocity);
            rows.for_each(|(one, two)| apart(one, two, 1e-9 * size));
            // differences of forces over a step of 1e-8
            apart(&listed.2.yaw, &alone.2.yaw, 1e-3 * size);
            let direct = of_contacts(memory.found(), &velocity, law, None).unwrap();
            assert_eq!(direct.members(), listed.0.members());
        }
    }
    assert!(counts[1] > 40 && counts[2] + counts[3] > 10, "{counts:?}");
}

/// A force from C, or its status.
fn in_c(table: *const u8, bytes: usize, position: &Position<f64>) -> Result<Wrench<f64>, i32> {
    let mut memory = zeroed::<Workspace<f64>>();
    let mut wrench = MaybeUninit::<Wrench<f64>>::uninit();
    let poison = [0xa5_u8; size_of::<Wrench<f64>>()];
    // SAFETY: both have as many bytes.
    unsafe { wrench.as_mut_ptr().cast::<[u8; size_of::<Wrench<f64>>()]>().write(poison) };
    // SAFETY: as many bytes as said.
    let status = unsafe {
        double::kstrip_wheel_on_table(
            Some(&kstrip_table { data: table, bytes: bytes as u32, only: 0 }),
            Some(&PAIR),
            Some(position),
            Some(&ROLLING),
            None,
            Some(&mut memory),
            Some(&mut wrench),
            None,
            None,
        )
    };
    // SAFETY: all bytes were written.
    let bytes = unsafe { wrench.as_ptr().cast::<[u8; size_of::<Wrench<f64>>()]>().read() };
    if status < 0 {
        assert!(bytes == poison, "status {status} and something written");
        return Err(status);
    }
    // SAFETY: it was written.
    Ok(unsafe { wrench.assume_init() })
}

/// Any damage is found, nothing is read past the end, and any address will do.
#[test]
fn a_table_is_never_trusted() {
    let Built { table, .. } = built();
    let position = loaded(-9e-3, 2e-3, 80e3);
    let expected = in_c(table.as_ptr(), table.len(), &position).unwrap();
    // at an odd address
    let shifted: Vec<u8> = [0].into_iter().chain(table.iter().copied()).collect();
    let own = in_c(shifted[1..].as_ptr(), table.len(), &position);
    assert_eq!(own, Ok(expected));
    assert_eq!(in_c(std::ptr::null(), table.len(), &position), Err(KSTRIP_ERROR_NULL));
    // SAFETY: as many bytes as said.
    let check = |table: &[u8]| unsafe {
        double::kstrip_table_check(table.as_ptr(), table.len() as u32, None)
    };
    assert_eq!(check(table), KSTRIP_OK);
    for length in (0..table.len()).step_by(997).chain(0..300) {
        assert_eq!(check(&table[..length]), KSTRIP_ERROR_TABLE, "{length}");
        let own = table[..length].to_vec();
        assert_eq!(in_c(own.as_ptr(), length, &position), Err(KSTRIP_ERROR_TABLE), "{length}");
    }
    let mut random = Random::new(7);
    for k in 0..4000 {
        let mut damaged = table.clone();
        let at = if k < 400 { k } else { (random.between(0.0, 1.0) * table.len() as f64) as usize };
        let bit = (random.between(0.0, 8.0) as u32).min(7);
        damaged[at] ^= 1 << bit;
        let status = check(&damaged);
        assert!(status < 0, "byte {at}, bit {bit}: {status}");
        // a force that may be wrong, or a status, but no wrong access
        if let Ok(found) = in_c(damaged.as_ptr(), damaged.len(), &position) {
            assert!(found.members().iter().all(|own| own.is_finite()));
        }
    }
}

#[test]
fn single_precision_reads_the_same_table() {
    let Built { table, .. } = built();
    let position = loaded(-9e-3, 2e-3, 80e3);
    let expected = in_c(table.as_ptr(), table.len(), &position).unwrap().members();
    let pair = WheelPair::<f32> {
        wheel_radius: 0.46,
        shear_modulus: 82e9,
        poisson_ratio: 0.28,
        friction: 0.3,
        ..WheelPair::default()
    };
    let Position { lateral, vertical, yaw, roll } = position;
    let [lateral, vertical, yaw, roll] = [lateral, vertical, yaw, roll].map(|own| own as f32);
    let position = Position { lateral, vertical, yaw, roll };
    let velocity = Velocity::<f32> {
        forward: ROLLING.forward as f32,
        pitch: ROLLING.pitch as f32,
        ..Velocity::default()
    };
    let law = Law { model: Model::Strip, falling: None };
    let table = ContactTable::new(table).unwrap();
    let scene = TableScene { table, pair: &pair, law };
    let mut memory = zeroed::<Workspace<f32>>();
    let requested = Requested { by_velocity: None, by_position: None };
    let found =
        scene.differentiate(&BodyState { position, velocity }, Some(&mut memory), requested);
    for (own, expected) in found.unwrap().members().into_iter().zip(expected) {
        assert!((f64::from(own) - expected).abs() < 3e-3 * 80e3, "{own} {expected}");
    }
}

/// For wheelsets, which roll.
const ROLLED: TableSpec<f64> = TableSpec {
    lateral_from: -12.5e-3,
    lateral_to: -8.5e-3,
    yaw: 2e-3,
    roll: 1e-3,
    lateral_nodes: 9,
    levels: 8,
    ..SPEC
};

fn rolled() -> &'static Built {
    static BUILT: OnceLock<Built> = OnceLock::new();
    BUILT.get_or_init(|| {
        let (rail, wheel) = (turned("uic60", 0.025), turned("s1002", 0.0));
        let (table, report) = build(&rail, &wheel, &ROLLED, false);
        Built { rail, wheel, table, report }
    })
}

/// On a table a wheel is lowered until the table's own force is the load. Beside the table the
/// height is that of the profiles, or a status.
#[test]
fn height_on_a_table_carries_the_load() {
    let Built { rail, wheel, table, .. } = rolled();
    let mut memory = zeroed::<Workspace<f64>>();
    let plain = scene_of(rail, wheel, &PAIR);
    let [on, only] = [false, true].map(|only| Scene { table: Some(source(table, only)), ..plain });
    for lateral in [-12e-3, -10e-3, -9e-3] {
        for (yaw, roll) in [(0.0, 0.0), (1.5e-3, -0.7e-3)] {
            let place = Position { lateral, yaw, roll, vertical: 0.0 };
            for velocity in [None, Some(&ROLLING)] {
                let mut of = |scene: &Scene<f64>| {
                    scene.height_for_load(&place, 60e3, velocity, &mut memory).unwrap()
                };
                let ((vertical, warning), (direct, _)) = (of(&on), of(&plain));
                assert_eq!(warning, Warning::None);
                assert_eq!(of(&only).0.to_bits(), vertical.to_bits());
                assert!((vertical - direct).abs() < 2e-6, "{vertical} {direct}");
                let state =
                    BodyState { position: Position { vertical, ..place }, velocity: ROLLING };
                let found = on.solve(&state, &mut memory).unwrap();
                let load = match velocity {
                    Some(_) => -found.force[2],
                    None => memory
                        .found()
                        .iter()
                        .map(|contact| contact.share * contact.normal_force * contact.normal[2])
                        .sum(),
                };
                assert_relative_eq!(load, 60e3, max_relative = 1e-9);
            }
        }
    }
    let beside = Position { lateral: -7e-3, ..Position::default() };
    let mut of = |scene: &Scene<f64>| scene.height_for_load(&beside, 60e3, None, &mut memory);
    assert_eq!(of(&on).unwrap(), of(&plain).unwrap());
    assert_eq!(of(&only), Err(Error::TableRange));
}

/// A wheelset on two tables settles under its loads, near the one on profiles, and its derivatives
/// are those of its forces.
#[test]
fn wheelset_settles_on_tables() {
    let Built { rail, wheel, table, report } = rolled();
    let pairs = [0, 1].map(|left| WheelPair { left, ..PAIR });
    let plain = [0, 1].map(|side| scene_of(rail, wheel, &pairs[side]));
    let on = plain.map(|scene| Scene { table: Some(source(table, true)), ..scene });
    let right = Side::right(0.75, 0.7605);
    let sides = [right, Side { arm: -0.75, origin: -0.7605, rail: 8, ..right }];
    let loads = WheelsetLoads { vertical: 130e3, roll: 4e3, pitch: -200.0 };
    let velocity = Velocity { pitch: 0.0, ..ROLLING };
    let mut memory = zeroed::<WheelsetWorkspace<f64>>();
    for (lateral, yaw) in [(0.0, 0.0), (1e-3, 1e-3), (-1.5e-3, -0.5e-3)] {
        let start =
            BodyState { position: Position { lateral, yaw, ..Position::default() }, velocity };
        let [of_table, direct] = [on, plain]
            .map(|scenes| Wheelset { scenes, sides }.settle(&start, &loads, &mut memory).unwrap());
        assert_eq!(of_table.warning, Warning::None);
        let [force, moment] = [of_table.forces.wrench.force, of_table.forces.wrench.moment];
        assert_relative_eq!(-force[2], loads.vertical, max_relative = 1e-8);
        assert!((moment[0] + loads.roll).abs() < 1e-4 && (moment[1] + loads.pitch).abs() < 1e-4);
        let apart = of_table.state.position.vertical - direct.state.position.vertical;
        assert!(apart.abs() < 2e-6, "{apart}");
        for (one, two) in of_table.forces.wheel.iter().zip(&direct.forces.wheel) {
            for axis in [0, 1] {
                let error = (one.force[axis] - two.force[axis]) / (0.3 * two.normal_force);
                assert!(error.abs() < 2.0 * report.force_largest, "{lateral} {axis} {error}");
            }
        }
        let settled = of_table.state;
        let wheelset = Wheelset { scenes: on, sides };
        let (mut by, mut moved) = (Default::default(), Default::default());
        let requested = Requested { by_velocity: Some(&mut by), by_position: Some(&mut moved) };
        wheelset.differentiate(&settled, &mut memory, requested).unwrap();
        let mut force_at = |lateral: f64| {
            let mut state = settled;
            state.position.lateral += lateral;
            wheelset.solve(&state, &mut memory).unwrap().wrench.force[1]
        };
        let slope = (force_at(1e-7) - force_at(-1e-7)) / 2e-7;
        assert_relative_eq!(moved.position[1][1], slope, max_relative = 1e-2);
    }
}

/// In C many wheels and heights take a table as well, and have the bits of one wheel on it.
#[test]
fn many_wheels_take_a_table() {
    let Built { rail, wheel, table, .. } = rolled();
    let places = [-12e-3, -9.5e-3].map(|lateral| Position { lateral, ..Position::default() });
    let from = kstrip_table { data: table.as_ptr(), bytes: table.len() as u32, only: 1 };
    let stride = size_of::<Position<f64>>() as u32;
    let mut memory = zeroed::<Workspace<f64>>();
    let (mut heights, mut statuses) = ([0.0; 2], [77; 2]);
    let none = core::ptr::null();
    // SAFETY: arrays have two elements, or one for all.
    let status = unsafe {
        double::kstrip_heights_for_loads(
            Some(rail),
            Some(wheel),
            2,
            core::ptr::from_ref(&PAIR),
            0,
            places.as_ptr(),
            stride,
            core::ptr::from_ref(&LOAD),
            0,
            none,
            0,
            core::ptr::null(),
            0,
            Some(&from),
            Some(&mut memory),
            heights.as_mut_ptr(),
            statuses.as_mut_ptr(),
        )
    };
    assert_eq!((status, statuses), (KSTRIP_OK, [KSTRIP_OK; 2]));
    let placed = [0, 1].map(|k| Position { vertical: heights[k], ..places[k] });
    let mut wrenches = [Wrench::default(); 2];
    // SAFETY: arrays have two elements, or one for all.
    let status = unsafe {
        double::kstrip_wheels_on_rails(
            Some(rail),
            Some(wheel),
            2,
            core::ptr::from_ref(&PAIR),
            0,
            placed.as_ptr(),
            stride,
            core::ptr::from_ref(&ROLLING),
            0,
            core::ptr::null(),
            0,
            Some(&from),
            Some(&mut memory),
            wrenches.as_mut_ptr(),
            core::ptr::null_mut(),
            core::ptr::null_mut(),
            core::ptr::null_mut(),
            0,
            statuses.as_mut_ptr(),
        )
    };
    assert_eq!(status, KSTRIP_OK);
    for ((place, height), wrench) in placed.iter().zip(heights).zip(&wrenches) {
        let scene = Scene { table: Some(source(table, true)), ..scene_of(rail, wheel, &PAIR) };
        let found = scene.height_for_load(place, LOAD, None, &mut memory).unwrap().0;
        assert_eq!(found.to_bits(), height.to_bits());
        assert_eq!(in_c(table.as_ptr(), table.len(), place).unwrap(), *wrench);
    }
}

/// Load of each of many wheels \[N\].
const LOAD: f64 = 70e3;

/// A table of a scene with a table is that of its profiles.
#[test]
fn table_is_filled_from_profiles_alone() {
    let Built { rail, wheel, table, .. } = built();
    let spec = TableSpec { lateral_nodes: 9, levels: 3, yaw: 0.0, ..SPEC };
    let plain = scene_of(rail, wheel, &PAIR);
    let [of_profiles, of_table] = [None, Some(source(table, false))].map(|table| {
        let scene = Scene { table, ..plain };
        let mut memory = zeroed::<Workspace<f64>>();
        let [bytes, parts] = spec.size(wheel).unwrap();
        let mut block = vec![0; bytes as usize];
        spec.begin_table(&scene, &mut memory, &mut block).unwrap();
        for part in 0..parts {
            fill_part(&scene, part as usize, &mut memory, &mut block).unwrap();
        }
        let report = finish(&scene, 20, &mut memory, &mut block).unwrap();
        (block, report.force_largest.to_bits())
    });
    assert!(of_profiles == of_table);
}
