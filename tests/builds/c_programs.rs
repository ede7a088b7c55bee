//! C programs against the header and the library: the examples with their numbers, the layout
//! of every structure, the answers to bad input, the language standards, threads.

use core::mem::{offset_of, size_of};
use kstrip::ffi;
use kstrip_testing::header::{Declared, Structure};
use kstrip_testing::names::*;
use kstrip_testing::prelude::*;
use kstrip_testing::toolchain::{
    build_c_with, check_header, compile_with, has_cpp, knows, run_c, run_c_with,
    symbols_of_library, write_scratch,
};
use std::process::Command;

/// The contact of examples 02 to 05 and 07.
const TOTAL: Options = Options { model: Model::Total, strips: StripCount::Sixteen };

const FRICTION_BOUND: f64 = 24e3;

/// All numbers of a line, in order.
fn numbers(line: &str) -> Vec<f64> {
    line.split(|c: char| c.is_whitespace() || c == ',')
        .filter_map(|word| word.parse().ok())
        .collect()
}

/// The numbers of the lines that start like this.
fn lines_of(text: &str, start: &str) -> Vec<Vec<f64>> {
    text.lines().filter(|line| line.trim_start().starts_with(start)).map(numbers).collect()
}

/// Those of the only one.
fn line_of(text: &str, start: &str) -> Vec<f64> {
    let lines: [Vec<f64>; 1] = lines_of(text, start).try_into().expect(start);
    let [line] = lines;
    line
}

/// A number that was printed with so many decimals.
#[track_caller]
fn assert_printed(printed: f64, exact: f64, decimals: i32, what: &str) {
    // Half a unit of the last place; the hair covers the conversion from text.
    let allowed = 0.5 * 10_f64.powi(-decimals) + 1e-13 * exact.abs();
    assert!((printed - exact).abs() <= allowed, "{what}: printed {printed}, should be {exact}");
}

#[track_caller]
fn assert_close(value: f64, exact: f64, tolerance: f64, what: &str) {
    assert!((value - exact).abs() <= tolerance, "{what}: {value}, should be {exact} ± {tolerance}");
}

#[test]
fn wheel_rail_prints_the_right_patch_forces_and_map() {
    let text = run_c("c_examples/01_wheel_rail.c");

    let ellipse = hertz(&radii([FLAT, 0.3, 0.46, FLAT]), 80e3, 82e9, 0.28).expect("an ellipse");
    let (a, b, p0, approach) = (ellipse.a, ellipse.b, ellipse.peak_pressure, ellipse.approach);
    let patch = line_of(&text, "a = ");
    assert_printed(patch[0], a * 1e3, 6, "a");
    assert_printed(patch[1], b * 1e3, 6, "b");
    let pressure = line_of(&text, "peak pressure");
    assert_printed(pressure[0], p0 / 1e6, 4, "peak pressure");
    assert_printed(pressure[1], approach * 1e6, 6, "approach");

    // The table, against the Rust interface with the default options
    let contact = Contact { a, b, ..C0 };
    let mut table = text.lines().skip_while(|line| !line.contains("long. [%]")).skip(1);
    let mut forces = BTreeMap::new();
    for row in table.by_ref().take_while(|line| !line.is_empty()).map(numbers) {
        let [longitudinal, lateral, spin, fx, fy, mz, stick] = row[..] else {
            panic!("seven columns: {row:?}")
        };
        let creepage = creep(longitudinal / 100.0, lateral / 100.0, spin);
        let exact = solved(&contact, &creepage, &Options::default());
        assert_printed(fx, exact.fx, 2, "Fx");
        assert_printed(fy, exact.fy, 2, "Fy");
        assert_printed(mz, exact.mz, 4, "Mz");
        assert_printed(stick, exact.adhesion * 100.0, 3, "stick");
        assert!(fx.hypot(fy) <= FRICTION_BOUND + 0.01, "|F| ≤ μ N: {row:?}");
        forces.insert([longitudinal, lateral, spin].map(|v| (v * 100.0).round() as i64), (fx, fy));
    }
    assert_eq!(forces.len(), 15, "rows of the table");
    // Full sliding, and the lateral force changes its sign with the lateral creepage
    assert_eq!(forces[&[10_000, 0, 0]], (FRICTION_BOUND, 0.0));
    assert_eq!(forces[&[0, 10, 0]].1, -forces[&[0, -10, 0]].1);
    // Positive spin pushes along +y, the more the larger
    assert!(0.0 < forces[&[0, 0, 10]].1 && forces[&[0, 0, 10]].1 < forces[&[0, 0, 50]].1);

    // The map, character by character, leading edge in the first line
    let map: Vec<Vec<char>> = text
        .lines()
        .filter_map(|line| line.strip_prefix("  |")?.split('|').next())
        .map(|line| line.chars().collect())
        .collect();
    let (rows, columns) = (25, 51);
    assert_eq!(map.len(), rows);
    let creepage = creep(1e-3, 0.0, 0.4);
    let options = Options::default();
    let field = Field::new(&contact, &creepage, &options).expect("a field");
    let step = 2.0 * a / rows as f64;
    let mut counts = BTreeMap::new();
    for (i, line) in map.iter().rev().enumerate() {
        assert_eq!(line.len(), columns);
        for (j, &character) in line.iter().enumerate() {
            let x = (i as f64 - 12.0) * step;
            let y = (j as f64 - 25.0) * step / 2.0;
            let state = match character {
                ' ' => State::Outside,
                '#' => State::Stick,
                '.' => State::Slip,
                '-' => State::SlipNegativeDissipation,
                other => panic!("{other:?} in the map"),
            };
            assert_eq!(state, field.at(x, y).state, "line {i}, column {j}");
            *counts.entry(character).or_insert(0_u32) += 1;
        }
    }
    // The area that the characters cover is that of the ellipse, and stick has its share of it
    let count = |character| f64::from(counts.get(&character).copied().unwrap_or(0));
    let inside = count('#') + count('.') + count('-');
    assert_close(inside * step * step / 2.0, PI * a * b, 0.02 * PI * a * b, "area of the map");
    let adhesion = solved(&contact, &creepage, &options).adhesion;
    assert_close(count('#') / inside, adhesion, 0.02, "stick in the map");
}

fn declared() -> Declared {
    header::declared(&(read("include/kstrip.h") + &read("include/kstrip_f32.h")))
}

/// The constants of the header whose names start like this.
fn constants_of_header(prefix: &str) -> BTreeMap<String, i64> {
    declared().constants.into_iter().filter(|(name, _)| name.starts_with(prefix)).collect()
}

#[test]
fn creep_curves_hold_every_model() {
    let text = run_c("c_examples/02_creep_curves.c");
    let mut listed = BTreeSet::new();
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    assert_eq!(
        reader.headers().expect("a header").iter().collect::<Vec<_>>().join(","),
        "model,number,curve,longitudinal,lateral,spin_1_per_m,fx_N,fy_N,mz_N_m,power_N,stick,status"
    );
    for record in reader.records() {
        let record = record.expect("as many columns as the header");
        let value = |column: usize| record[column].parse::<f64>().expect("a number");
        let number: i32 = record[1].parse().expect("a model number");
        let model = Model::from_number(number).expect("a model");
        let motion = creep(value(3), value(4), value(5));
        let options = Options { model, strips: StripCount::default() };
        let exact = solved(&C0, &motion, &options);
        // Ten digits are printed; the creepage in the table is rounded to ten as well.
        let columns =
            [exact.fx, exact.fy, exact.mz, exact.power, exact.adhesion].map(|v| (v, v.abs()));
        for (column, (exact, size)) in (6..).zip(columns) {
            assert_close(value(column), exact, 2e-9 * size + 1e-9, &format!("{record:?}"));
        }
        assert_eq!(record[11].parse(), Ok(exact.warning.code()), "status of {record:?}");
        if exact.warning != Warning::BeyondFriction {
            assert!(value(6).hypot(value(7)) <= FRICTION_BOUND * (1.0 + 1e-9), "{record:?}");
        }
        listed.insert(i64::from(number));
    }

    // No model of the header is missing
    let models = constants_of_header("KSTRIP_MODEL_").into_values();
    let known: BTreeSet<i64> = models.filter(|model| *model != 0).collect();
    assert_eq!(listed, known, "add a line per model to the table of 02_creep_curves.c");
}

#[test]
fn traction_field_adds_up_to_the_forces() {
    let text = run_c("c_examples/03_traction_field.c");
    let creepage = creep(0.0005, 0.001, 0.3);
    let options = Options { model: Model::Strip1967, strips: StripCount::ThirtyTwo };
    let exact = solved(&C0, &creepage, &options);

    // Strips, one by one and summed
    let mut strips: Vec<StripResult<f64>> = Vec::new();
    forces::strips(&C0, &creepage, &options, &mut |strip| strips.push(strip)).expect("strips");
    let printed: Vec<Vec<f64>> =
        text.lines().skip(1).take_while(|line| !line.is_empty()).map(numbers).collect();
    assert_eq!(printed.len(), strips.len());
    let (mut width, mut force) = (0.0, 0.0);
    for (row, strip) in printed.iter().zip(&strips) {
        let wanted = [strip.y, strip.width, strip.half_length, strip.separatrix].map(|v| v * 1e3);
        for (value, wanted) in row[1..5].iter().zip(wanted) {
            assert_printed(*value, wanted, 5, "geometry of a strip");
        }
        assert_printed(row[5], strip.fx, 4, "Fx of a strip");
        assert_printed(row[6], strip.fy, 4, "Fy of a strip");
        width += row[2];
        force += row[6];
    }
    let rounding = 0.5e-4 * strips.len() as f64;
    assert_close(width, 9.0, 0.1 * rounding, "widths of the strips cover the patch [mm]");
    assert_close(force, exact.fy, rounding, "Fy of the strips");

    let solve = line_of(&text, "solve ");
    let sums = line_of(&text, "sum of strips");
    let integral = line_of(&text, "integral");
    let totals = [exact.fx, exact.fy, exact.mz, exact.power];
    for (k, (&value, &wanted)) in solve[1..].iter().zip(&totals).enumerate() {
        let decimals = if k < 2 { 4 } else { 6 };
        assert_printed(value, wanted, decimals, "solve");
        assert_close(sums[k], value, 2.0 * 10_f64.powi(-decimals), "sum of strips");
    }
    // The square grid misses part of the rim: its error in the load, 3e-5, is that of the forces
    // too.
    assert_close(integral[0], C0.normal_force, 5e-5 * C0.normal_force, "∫ Z");
    assert_close(integral[1], exact.fx, 5e-5 * FRICTION_BOUND, "∫ X");
    assert_close(integral[2], exact.fy, 5e-5 * FRICTION_BOUND, "∫ Y");
    assert_close(integral[3], exact.mz, 5e-5 * FRICTION_BOUND * C0.a, "∫ (x Y − y X)");
    assert_close(integral[4], exact.power, 2e-4 * exact.power, "∫ P");

    // Points of the field
    let field = Field::new(&C0, &creepage, &options).expect("a field");
    let mut seen = BTreeMap::new();
    for line in text.lines().filter(|line| line.starts_with("point")) {
        let row = numbers(line);
        let [x, y, pressure, traction_x, traction_y, slip_x, slip_y] = row[..] else {
            panic!("seven numbers: {line}")
        };
        let point = field.at(x * 1e-3, y * 1e-3);
        let (name, state) = match line.split_whitespace().last() {
            Some(name @ "stick") => (name, State::Stick),
            Some(name @ "slip") => (name, State::Slip),
            Some(name @ "slip-") => (name, State::SlipNegativeDissipation),
            other => panic!("{other:?} is no state"),
        };
        *seen.entry(name).or_insert(0) += 1;
        assert_eq!(state, point.state, "{line}");
        // The printed place is exact: x is a multiple of 1/40 mm and y of 3/160 mm.
        assert_close(pressure, point.pressure / 1e6, 0.501e-4, line);
        assert_close(traction_x, point.traction_x / 1e6, 0.501e-4, line);
        assert_close(traction_y, point.traction_y / 1e6, 0.501e-4, line);
        assert_close(slip_x, point.slip_x, 0.501e-7, line);
        assert_close(slip_y, point.slip_y, 0.501e-7, line);
    }
    assert!(seen["stick"] > 20 && seen["slip"] > 5, "{seen:?}");
}

#[test]
fn velocities_become_opposite_forces_on_the_two_bodies() {
    let text = run_c("c_examples/04_own_velocities.c");
    // Wheel: yaw 1 mrad, contact plane tilted by 50 mrad, circumference 0.1 % too fast
    let (yaw, tilt, radius, speed) = (1e-3_f64, 50e-3_f64, 0.46, 20.0);
    let creepage = creep(
        1.0 - 1.001 * yaw.cos(),
        -1.001 * yaw.sin() * tilt.cos(),
        1.001 * yaw.cos() * tilt.sin() / radius,
    );
    let printed = line_of(&text, "creepage:");
    assert_printed(printed[0], creepage.longitudinal, 9, "longitudinal creepage");
    assert_printed(printed[1], creepage.lateral, 9, "lateral creepage");
    assert_printed(printed[2], creepage.spin, 9, "spin");

    let forces = solved(&C0, &creepage, &TOTAL);
    let rail = line_of(&text, "force on the rail");
    let wheel = line_of(&text, "force on the wheel");
    let wanted = [forces.fx, forces.fy * tilt.cos(), forces.fy * tilt.sin(), forces.mz];
    for (k, (value, wanted)) in rail.iter().zip(wanted).enumerate() {
        assert_printed(*value, wanted, if k < 3 { 4 } else { 6 }, "force on the rail");
    }
    // Action and reaction, to the last printed digit
    assert_eq!(wheel, rail.iter().map(|value| -value).collect::<Vec<_>>());
    // The wheel pulls: forward on the wheel, and it goes where it points
    assert!(wheel[0] > 0.0 && wheel[1] > 0.0);

    let heat = line_of(&text, "frictional heat")[0];
    let work = line_of(&text, "power of the forces")[0];
    assert_printed(heat, forces.power * speed, 6, "heat");
    assert!(heat > 0.0);
    // The power is a difference of two large ones (135 kW each): 1e-11 of them is 1e-6 W.
    assert_close(work, -heat, 5e-6, "what the forces take from the bodies is the heat");
}

/// How much larger the radius of a wheel S1002 is at `s` \[mm\] from the running circle (EN 13715).
fn s1002(s: f64) -> f64 {
    let tread = [
        0.0,
        -3.358537058e-2,
        1.565681624e-3,
        -2.810427944e-5,
        5.844240864e-8,
        -1.562379023e-8,
        5.309217349e-15,
        -5.957839843e-12,
        2.646656573e-13,
    ];
    let root = [
        -4.320221063e3,
        -1.038384026e3,
        -1.065501873e2,
        -6.051367875,
        -2.054332446e-1,
        -4.169739389e-3,
        -4.687195829e-5,
        -2.252755540e-7,
    ];
    let polynomial =
        |c: &[f64]| c.iter().enumerate().map(|(i, c)| c * s.powi(i as i32)).sum::<f64>();
    if s > 32.15796 {
        1.364323640 - 0.066666667 * s
    } else if s < -26.0 {
        polynomial(&root)
    } else {
        polynomial(&tread)
    }
}

/// How far a rail head 60E1 is below its top at `s` \[mm\] from its middle: arcs of 300, 80 and 13
/// mm, whose centres lie on the normals at their joints (EN 13674-1).
fn rail_60e1(s: f64) -> f64 {
    let (mut across, mut below) = (0.0, 300.0);
    let mut radius = 300.0_f64;
    for (end, next) in [(10.297, 80.0), (26.05, 13.0)] {
        if s.abs() <= end {
            break;
        }
        let angle = ((end - across) / radius).asin();
        across += (radius - next) * angle.sin();
        below -= (radius - next) * angle.cos();
        radius = next;
    }
    below - (radius.powi(2) - (s.abs() - across).powi(2)).sqrt()
}

/// The arcs and the polynomials meet without a step or a corner.
#[test]
fn profiles_of_the_standards_are_smooth() {
    type Height = fn(f64) -> f64;
    for (height, joint) in [(rail_60e1 as Height, 10.297), (rail_60e1, 26.05), (s1002, -26.0)] {
        let slope = |from: f64| (height(from + 1e-3) - height(from)) / 1e-3;
        assert_close(height(joint + 1e-9), height(joint - 1e-9), 1e-3, "height");
        assert_close(slope(joint + 1e-6), slope(joint - 1e-3 - 1e-6), 1e-3, "slope");
    }
}

/// The wheels of a train over a table: all inside its ranges, and friction takes power.
#[test]
#[ignore = "a step of .ci/run: it fills a table"]
fn a_train_runs_on_a_table() {
    let folder = root().join("tests/data/wheel_rail");
    let text = run_c_with("c_examples/13_train.c", &[folder.to_str().expect("a path"), "20"]);
    let line = |start: &str| text.lines().find(|line| line.starts_with(start)).expect(start);
    let [forces, of_mu, ..] = numbers(line("forces within"))[..] else { panic!("{text}") };
    assert!(forces > 0.0 && forces < 0.02 && of_mu == 95.0, "{text}");
    assert!(text.contains("400 wheels, 20 steps of a millisecond: 0 outside the table"), "{text}");
    let [power, lateral] = numbers(line("friction takes"))[..] else { panic!("{text}") };
    assert!(power > 1.0 && (1.0..60.0).contains(&lateral), "{text}");
}

/// A bogie on flexible rails hunts in a limit cycle, leans on its flange in a curve with the
/// lateral forces that balance asks for, is held on a grade, and is lifted and set down.
#[test]
#[ignore = "a step of .ci/run: it takes a minute"]
fn a_bogie_hunts_curves_brakes_and_is_lifted() {
    let folder = root().join("tests/data/wheel_rail");
    let text = run_c_with("c_examples/12_bogie.c", &[folder.to_str().expect("a path")]);
    // time, y of both wheelsets, speed, Y right and left, Q right and left, sum of Y
    let run_of = |text: &str, name: &str| -> Vec<Vec<f64>> {
        let of_run = |line: &str| line.strip_prefix(name).map(numbers);
        text.lines().filter_map(of_run).collect()
    };
    let run = |name: &str| run_of(&text, name);
    let most = |hunts: &[Vec<f64>], from: f64, to: f64| {
        let part = hunts.iter().filter(|row| (from..to).contains(&row[0]));
        part.fold(0.0, |most: f64, row| most.max(row[1].abs()))
    };
    let hunts = run("hunt");
    let (before, after) = (most(&hunts, 2.0, 3.0), most(&hunts, 3.0, 4.1));
    assert!(
        (7.0..10.0).contains(&after) && (after / before - 1.0).abs() < 0.15,
        "{before} {after}"
    );
    let last = |name| run(name).pop().expect("the run");
    // the flange of the outer, left wheel leads; weight and centrifugal force cancel
    let balance = last("curve at balance speed");
    assert!(balance[1] < -6.0 && balance[5] < -10e3 && balance[8].abs() < 100.0, "{balance:?}");
    let fast = last("curve at 22 m/s");
    let missing = 20e3 * (9.80665 * 0.1_f64.sin() - 22.0 * 22.0 / 300.0 * 0.1_f64.cos());
    assert!((fast[8] / missing - 1.0).abs() < 0.02, "{fast:?} {missing}");
    // held: it creeps back by micrometres a second, and the rails do not tremble
    let braked = run("brake");
    let held: Vec<&Vec<f64>> = braked.iter().filter(|row| row[0] > 10.0).collect();
    assert!(braked[0][3] > 1.99 && held.len() > 40);
    for (row, next) in held.iter().zip(&held[1..]) {
        assert!((-5e-6..=0.0).contains(&row[3]), "{row:?}");
        assert!((4..8).all(|k| (row[k] - next[k]).abs() < 20.0), "{row:?} {next:?}");
    }
    let lift = run("lift");
    let lifted = lift.iter().filter(|row| row[6] == 0.0).count();
    let [first, last] = [&lift[0], &lift[lift.len() - 1]];
    assert!(
        lifted > lift.len() / 4 && (last[6] / first[6] - 1.0).abs() < 0.05,
        "{lifted} {last:?}"
    );
    // on a contact table: the limit cycle, and the forces in curves
    let folder = folder.to_str().expect("a path");
    let on_table = run_c_with("c_examples/12_bogie.c", &[folder, "hunt curve table"]);
    assert_relative_eq!(most(&run_of(&on_table, "hunt"), 3.0, 4.1), after, max_relative = 0.01);
    for (name, direct) in [("curve at balance speed", balance), ("curve at 22 m/s", fast)] {
        let own = run_of(&on_table, name).pop().expect("the run");
        for (own, direct) in own.iter().zip(&direct).skip(4).take(4) {
            assert_relative_eq!(own, direct, max_relative = 0.01);
        }
    }
}

/// Where the surfaces are parallel the wheel touches, as far off as an 80 kN patch is long; the
/// radius is the wheel's mean there.
#[test]
fn a_wheel_on_a_rail_of_the_standards() {
    let text = run_c("c_examples/06_worn_profile.c");
    let rows: Vec<Vec<f64>> = text.lines().map(numbers).filter(|row| row.len() == 8).collect();
    assert!((9..=12).contains(&rows.len()), "contacts of nine shifts: {}", rows.len());
    for shift in -3..=5 {
        let contacts = rows.iter().filter(|row| row[0] == f64::from(shift));
        let carried: f64 = contacts.map(|row| row[5] * row[3].cos()).sum();
        // the normals of the strips spread a little about the patch's
        assert_close(carried, 80.0, 0.25, "load");
    }
    for row in &rows {
        let [shift, y, radius, angle, range, load, area, peak] = row[..] else { panic!("{row:?}") };
        // y is from the middle of the rail, its running circle 3.15 mm away
        let wheel = |s: f64| s1002(y + 3.15 - shift + s);
        let rail = |s: f64| rail_60e1(y + s) - (y + s) / 40.0;
        // the mean over the patch's 10 mm is not the slope at one place
        let slope = (wheel(0.1) - wheel(-0.1) + rail(0.1) - rail(-0.1)) / 0.4;
        assert_close(angle, slope.atan(), 0.02 + 0.1 * angle.abs(), "angle");
        // the mean over a hollow is between the curve and its chord, which of 16 mm that turn by
        // the range is 2 mm times the range higher
        let curve = 460.0 + wheel(0.0);
        assert!((curve - 0.05..curve + 0.05 + 2.0 * range).contains(&radius), "radius: {row:?}");
        assert!(load * 1e3 < peak * area && peak * area < 4.0 * load * 1e3, "{row:?}");
    }
    let [conicity] = line_of(&text, "equivalent conicity")[1..] else { panic!("two numbers") };
    assert!((0.1..0.3).contains(&conicity), "{conicity}");
    let forces = |kind: &str| -> Vec<Vec<f64>> {
        text.lines().filter(|line| line.ends_with(kind)).map(numbers).collect()
    };
    for (dry, greasy) in forces("dry").iter().zip(forces("greasy")) {
        for row in [dry, &greasy] {
            assert!(
                row[1].hypot(row[2]) < 0.4 * 80e3 && (-90e3..-70e3).contains(&row[3]),
                "{row:?}"
            );
            // braked against forward is driven: the force on the rim has the moment's sense
            assert!(row[0].abs() < 0.5 || row[1] * row[0] > 0.0, "{row:?}");
            assert_close(row[4], 0.4604 * row[1], 0.02 * row[1].abs() + 40.0, "moment");
        }
        assert!(row_size(&greasy) <= row_size(dry), "{dry:?} {greasy:?}");
    }
    assert_eq!(forces("greasy").len(), 5);
}

fn row_size(row: &[f64]) -> f64 {
    row[1].abs()
}

/// Largest real part of the eigenvalues of the wheelset of example 05 under linear creep forces.
fn wheelset_growth(speed: f64) -> f64 {
    let (mass, inertia, lateral, yaw) = (1800.0, 1100.0, 400e3, 3e6);
    let (radius, half_gauge, conicity) = (0.46, 0.75, 0.1);
    let linear = kstrip::linear::LinearCoefficients::at(C0.a / C0.b, 0.28);
    let Contact { a, b, shear_modulus: g, .. } = C0;
    let f11 = g * a * b * linear.c11;
    let f22 = g * a * b * linear.c22;
    let f23 = g * (a * b).powf(1.5) * linear.c23;
    let f33 = g * (a * b).powi(2) * linear.c33;
    // Two wheels; the spin of the cones pushes them apart and cancels.
    let matrix = nalgebra::Matrix4::from_rows(&[
        [0.0, 0.0, 1.0, 0.0].into(),
        [0.0, 0.0, 0.0, 1.0].into(),
        [-lateral / mass, 2.0 * f22 / mass, -2.0 * f22 / speed / mass, -2.0 * f23 / speed / mass]
            .into(),
        [
            -2.0 * half_gauge * f11 * conicity / radius / inertia,
            (-yaw - 2.0 * f23) / inertia,
            2.0 * f23 / speed / inertia,
            -2.0 * (half_gauge * half_gauge * f11 + f33) / speed / inertia,
        ]
        .into(),
    ]);
    matrix.complex_eigenvalues().iter().map(|value| value.re).fold(f64::MIN, f64::max)
}

#[test]
#[ignore = "a step of .ci/run: long runs of examples"]
fn hunting_starts_at_the_eigenvalue_and_ends_in_a_cycle() {
    let text = run_c("c_examples/05_hunting.c");
    let [low, _] = bisect([5.0, 150.0], 0.0, |speed| wheelset_growth(speed) <= 0.0);
    let linear = line_of(&text, "critical speed, linear:")[0];
    assert_close(linear, low, 1e-3 * low, "critical speed of the linear model");
    // The spin of the cones takes a little of the slopes
    let total = line_of(&text, "critical speed, total:")[0];
    assert_close(total, low, 0.1 * low, "critical speed of the total-force model");
    // From inside and from outside to the same cycle, which lasts
    let [inside, outside] = ["limit cycle from 1 mm", "limit cycle from 20 mm"].map(|start| {
        let row = line_of(&text, start);
        let [amplitude, growth] = row[row.len() - 2..] else { panic!("{row:?}") };
        assert_close(growth, 1.0, 1e-4, "growth in the cycle");
        amplitude
    });
    assert_close(inside, outside, 1e-3 * inside, "one limit cycle");
    assert!(inside > 1.0 && inside < 20.0, "between the two starts: {inside} mm");
    let calls = line_of(&text, "calls with Jacobian");
    assert!(calls[0] > 1e5 && calls[1] == 3.0 * calls[0], "{calls:?}");
}

/// Brake to rest, hold on a slope, roll back, drive off: the program checks itself and ends with 0;
/// its figures are those of a body on a slope.
#[test]
fn standstill_holds_and_reverses() {
    let text = run_c("c_examples/10_standstill.c");
    let held = lines_of(&text, "held:");
    assert_eq!(held.len(), 2, "{text}");
    for drift in held.iter().flatten() {
        assert!(*drift > 0.0 && *drift < 10.0, "{text}");
    }
    let last = lines_of(&text, "20 s:").pop().unwrap();
    // (6000 - 8150 9.81/50)/(8150 + 400) over four seconds
    assert!((last[2] / 2.0589 - 1.0).abs() < 2e-3, "{text}");
}

#[test]
#[ignore = "a step of .ci/run: long runs of examples"]
fn falling_friction_has_a_maximum_and_sticks_and_slips() {
    let text = run_c("c_examples/07_falling_friction.c");
    let law = falling(0.4, 0.4, 0.6, 10.0, 0.5);
    let options = Options { model: Model::Total, strips: StripCount::default() };
    let curve = lines_of(&text, "curve ");
    assert!(curve.len() > 40);
    for row in &curve {
        let [slip, force, slope, friction] = row[..] else { panic!("{row:?}") };
        let motion = creep(-slip, 0.0, 0.0);
        let found = differentiate_with_law(&C0, &motion, Some(&law), &options).expect("forces");
        let by_slip = found.derivatives.jacobian[0][0];
        // Seven digits of the slip are printed
        let allowed = 1e-6 * slip * by_slip.abs() + 1e-4;
        assert_close(force, -found.solution.fx, allowed, "traction");
        assert_close(friction, found.friction, 1e-7, "friction");
        assert_close(slope, by_slip, 1e-4 * 5e6, "slope");
        // Eight digits of the friction are printed
        assert!(force <= friction * C0.normal_force * (1.0 + 1e-7));
    }
    let turns = curve.windows(2).filter(|rows| (rows[1][2] > 0.0) != (rows[0][2] > 0.0)).count();
    assert_eq!(turns, 1, "one maximum");

    let runs: Vec<Vec<f64>> =
        text.lines().filter(|line| line.contains(" friction, mean slip ")).map(numbers).collect();
    let [steady, cycle, constant] = &runs[..] else { panic!("{text}") };
    // amplitude in the third quarter, in the last, frequency
    let amplitudes = |row: &[f64]| {
        let row = &row[row.len() - 3..];
        (row[0], row[1], row[2])
    };
    // Before the maximum, and with constant friction, oscillations die
    assert_eq!(amplitudes(steady).1, 0.0);
    let (before, after, _) = amplitudes(constant);
    assert!(after < 0.5 * before && after < 1e-3, "{constant:?}");
    // Beyond it they last: the wheel swings until it almost sticks, a little slower than freely
    let (before, after, frequency) = amplitudes(cycle);
    assert_close(after, before, 1e-3 * before, "amplitude of the stick-slip");
    assert!(after > 0.095 && after < 0.2, "{cycle:?}");
    let natural = (500e3_f64 / 50.0).sqrt() / (2.0 * PI);
    assert!(frequency > 0.8 * natural && frequency < natural, "{frequency} Hz of {natural}");
}

/// A locomotive's measured points become a law, and the columns of the picture are its curves.
#[test]
fn a_measured_curve_is_fitted() {
    let folder = root().join("tests/data");
    let text = run_c_with("c_examples/11_measured_curve.c", &[folder.to_str().expect("a path")]);
    let rows = |title: &str| -> Vec<Vec<f64>> {
        let part = text.lines().skip_while(|line| !line.starts_with(title)).skip(1);
        part.take_while(|line| !line.is_empty()).map(numbers).collect()
    };
    let rms = line_of(&text, "rms")[0];
    assert_close(rms, 0.0241, 0.0005, "rms");
    let points = rows("measured:");
    assert_eq!(points.len(), 89);
    let squares: f64 = points.iter().map(|row| (row[1] - row[2]).powi(2)).sum();
    assert_close((squares / 89.0).sqrt(), rms, 2e-5, "rms of the columns");

    let member = |name: &str| {
        let [value, error] = line_of(&text, name)[..] else { panic!("{text}") };
        assert!((0.0..0.4 * value).contains(&error) || value == 0.0, "{name} {value} {error}");
        value
    };
    let law = SlipFriction {
        friction: member("friction"),
        ratio: member("ratio"),
        decay: member("decay"),
        rolling_speed: 10.0,
        slope_factor: member("slope factor"),
        slide_factor: member("slide factor"),
        layer: 0.0,
    };
    let contact = Contact { a: 6.304e-3, b: 12.61e-3, normal_force: 106.7e3, friction: 0.33, ..C0 };
    let options = Options { model: Model::Total, ..Options::default() };
    let curves = rows("curves:");
    assert_eq!(curves.len(), 30);
    for row in &curves {
        let [creepage, clean, fitted, by_contact] = row[..] else { panic!("{row:?}") };
        let motion = creep(creepage / 100.0, 0.0, 0.0);
        let force = |law| {
            let found = differentiate_with_law(&contact, &motion, law, &options).expect("forces");
            found.solution.fx / contact.normal_force
        };
        assert_printed(clean, force(None), 5, "clean bodies");
        // Four digits of the law are printed
        assert_close(fitted, force(Some(&law)), 2e-4, "the fitted law");
        // Clean bodies need a quarter of the creepage at the start. C0's layer and falling
        // friction were chosen for these points too.
        assert!(clean > by_contact - 1e-3, "{row:?}");
        assert_close(fitted, by_contact, 0.07, "C0");
    }
}

#[test]
fn batches_on_threads_have_the_bits_of_single_calls() {
    let source = "c_examples/08_batch_openmp.c";
    let Some(program) = build_c_with(None, "omp.h", &["-fopenmp"], source) else {
        say(&format!("SKIPPED: {source}: this compiler has no -fopenmp with omp.h"));
        return;
    };
    // The last piece is shorter than the others.
    let text = output_of(Command::new(program).arg("3501"));
    assert!(line_of(&text, "threads 0:")[0] > 0.0);
    for threads in ["threads 1:", "threads 2:"] {
        let [per_second, differing] = line_of(&text, threads)[..] else { panic!("{text}") };
        assert!(per_second > 0.0);
        assert_eq!(differing, 0.0);
    }
}

/// The row of a cell of `09_sweep_mpi.c`: shape, spin and size of the creepage, then force (mean,
/// least, most), moment and stick area over its directions.
fn swept_cell(cell: i32, directions: i32) -> [f64; 8] {
    let share = |i: i32, of: i32| f64::from(i) / f64::from(of - 1);
    let shape = 10_f64.powf(2.0 * share(cell % 20, 20) - 1.0);
    let psi = 3.0 * share(cell / 20 % 20, 20);
    let size = 10_f64.powf(3.0 * share(cell / 400, 25) - 2.0);
    let (a, b) = (5e-3 * shape.sqrt(), 5e-3 / shape.sqrt());
    let contact = Contact { a, b, ..C0 };
    let mut row = [shape, psi, size, 0.0, 1.0, 0.0, 0.0, 0.0];
    for i in 0..directions {
        let (sine, cosine) = (2.0 * PI * f64::from(i) / f64::from(directions)).sin_cos();
        let (xi, eta, poisson_ratio) = (size * cosine, size * sine, contact.poisson_ratio);
        let parameters = Parameters { xi, eta, psi, poisson_ratio, axis_ratio: a / b };
        let creepage = parameters.creepage(&contact);
        let f = solved(&contact, &creepage, &Options::default());
        let force = f.fx.hypot(f.fy) / FRICTION_BOUND;
        row[3] += force / f64::from(directions);
        row[4] = row[4].min(force);
        row[5] = row[5].max(force);
        row[6] += f.mz.abs() / (FRICTION_BOUND * 5e-3) / f64::from(directions);
        row[7] += f.adhesion / f64::from(directions);
    }
    row
}

#[test]
fn sweep_over_processes_writes_the_same_bits() {
    let source = "c_examples/09_sweep_mpi.c";
    let Some(program) = build_c_with(Some("mpicc"), "mpi.h", &["-lm"], source) else {
        say(&format!("SKIPPED: {source}: no mpicc on this machine"));
        return;
    };
    if !has("mpirun") {
        say(&format!("SKIPPED: {source}: compiled, but there is no mpirun to start it"));
        return;
    }
    let map = |processes: &str| {
        let path = scratch().join(format!("map_{processes}.csv"));
        let mut command = Command::new("mpirun");
        command.args(["-n", processes]).arg(&program).arg(&path).arg("6");
        // Open MPI, versions 4 and 5: as root in a container, with more processes than cores
        command.env("OMPI_ALLOW_RUN_AS_ROOT", "1").env("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1");
        command.env("OMPI_MCA_rmaps_base_oversubscribe", "1");
        command.env("PRTE_MCA_rmaps_default_mapping_policy", ":oversubscribe");
        let told = output_of(&mut command);
        assert!(told.starts_with(&format!("60000 cases, {processes} processes, ")), "{told}");
        read(path)
    };
    let one = map("1");
    for processes in ["2", "3"] {
        assert!(map(processes) == one, "{processes} processes write another file");
    }
    assert_eq!(one.lines().count(), 10_001);
    let titles = "a_over_b,psi,creepage,force,force_least,force_most,moment,stick";
    assert_eq!(one.lines().next(), Some(titles));
    for (cell, line) in (0..).zip(one.lines().skip(1)).step_by(53) {
        let row = numbers(line);
        for (k, exact) in swept_cell(cell, 6).into_iter().enumerate() {
            // Powers and sines of two libraries; the force is smooth in them.
            assert_close(row[k], exact, 1e-11 * exact.max(1.0), &format!("cell {cell}, {k}"));
        }
    }
}

#[test]
fn header_compiles_under_every_standard() {
    for standard in ["c99", "c11", "c17"] {
        check_known(false, &[standard]);
    }
    check_known(false, &["c23", "c2x"]);
    assert!(knows(false, "c99"), "no compiler for the examples");
    if !has_cpp() {
        say("skipped: the header under C++98 to C++20, because there is no C++ compiler");
        return;
    }
    for standard in ["c++98", "c++11", "c++14", "c++17"] {
        check_known(true, &[standard]);
    }
    check_known(true, &["c++20", "c++2a"]);
}

/// Check the header under the first of these names that the compiler knows.
fn check_known(cpp: bool, names: &[&str]) {
    match names.iter().find(|name| knows(cpp, name)) {
        Some(standard) => check_header(cpp, standard),
        None => {
            let names = names.join(" or ");
            say(&format!("skipped: the header under {names}, which this compiler does not know"));
        }
    }
}

/// Sizes and offsets as Rust has them, under the names that C prints.
macro_rules! layouts {
    ($($name:ident { $($field:ident),+ })+) => {{
        let mut layouts = BTreeMap::new();
        $(
            layouts.insert(format!("size {}", stringify!($name)), size_of::<$name>());
            $(layouts.insert(
                format!("offset {}.{}", stringify!($name), stringify!($field)),
                offset_of!($name, $field),
            );)+
        )+
        layouts
    }};
}

fn rust_layouts() -> BTreeMap<String, usize> {
    let double: BTreeMap<String, usize> = include!("../c/layout.rs");
    let single: BTreeMap<String, usize> = {
        use kstrip_testing::names::single::*;
        include!("../c/layout.rs")
    };
    let named = |key: String| {
        let (structure, member) =
            key.split_once('.').map_or((&*key, ""), |(s, _)| (s, &key[s.len()..]));
        format!("{structure}_f32{member}")
    };
    // Structures without numbers of either precision.
    let is_shared = |key: &str| {
        let name = key.split(['.', ' ']).nth(1);
        ["kstrip_options", "kstrip_table"].map(Some).contains(&name)
    };
    let single = single.into_iter().filter(|(key, _)| !is_shared(key));
    let mut layouts = double;
    layouts.extend(single.map(|(key, number)| (named(key), number)));
    layouts.insert("size kstrip_status".to_owned(), size_of::<ffi::kstrip_status>());
    // The one member that has another name in Rust
    let c_name =
        |(key, number): (String, usize)| (key.replace(".warning", ".status_detail"), number);
    layouts.into_iter().map(c_name).collect()
}

/// What the header says by the rule of natural alignment: the numbers of `docs/maintain/abi.txt`.
fn layouts_of_header(declared: &Declared) -> BTreeMap<String, usize> {
    let mut numbers = BTreeMap::from([("size kstrip_status".to_owned(), 4)]);
    let layouts = declared.layouts();
    for Structure { name, members } in &declared.structures {
        let layout = &layouts[name.as_str()];
        numbers.insert(format!("size {name}"), layout.size);
        for (member, offset) in members.iter().zip(&layout.offsets) {
            numbers.insert(format!("offset {name}.{}", member.name), *offset);
        }
    }
    numbers
}

/// Sizes and offsets of every structure: as C prints them, as Rust has them, as
/// `docs/maintain/abi.txt` has them.
#[test]
fn structures_have_one_layout() {
    let declared = declared();
    let text = run_c(&write_scratch("layout_printer.c", &declared.c_printer()));
    let of_c: BTreeMap<String, usize> = text
        .lines()
        .filter_map(|line| line.rsplit_once(' '))
        .map(|(name, value)| (name.to_owned(), value.parse().expect("a size")))
        .collect();
    assert_eq!(of_c, rust_layouts());
    assert_eq!(of_c, layouts_of_header(&declared));
}

/// The same layout for other compilers and for the microcontroller, proved by compiling.
#[test]
fn other_compilers_lay_structures_out_alike() {
    let assertions = write_scratch("layout_assertions.c", &declared().c_assertions());
    for compiler in ["gcc", "clang", "arm-none-eabi-gcc"] {
        match compile_with(compiler, &assertions) {
            None => say(&format!("SKIPPED: layouts as {compiler} sees them: it is not installed")),
            Some(Ok(())) => {}
            Some(Err(message)) => panic!("{compiler}: {message}"),
        }
    }
}

#[test]
fn library_exports_what_the_header_declares() {
    let declared = declared();
    let functions: BTreeSet<&str> = declared.functions.iter().map(|f| f.name.as_str()).collect();
    let Some(symbols) = symbols_of_library() else {
        say("SKIPPED: symbols of the library against the header: no nm on this machine");
        return;
    };
    let exported: BTreeSet<&str> =
        symbols.iter().map(String::as_str).filter(|name| name.starts_with("kstrip_")).collect();
    assert_eq!(exported, functions);
}

#[test]
fn statuses_have_texts_in_c() {
    let text = run_c("tests/c/abi.c");

    // Every status of the header has a text of its own, other numbers have none
    let known: BTreeMap<i64, String> = constants_of_header("KSTRIP_OK")
        .into_iter()
        .chain(constants_of_header("KSTRIP_WARNING_"))
        .chain(constants_of_header("KSTRIP_ERROR_"))
        .map(|(name, value)| (value, name))
        .collect();
    assert!(known.len() >= 18, "{known:?}");
    let mut texts = BTreeSet::new();
    for line in text.lines().filter_map(|line| line.strip_prefix("text ")) {
        let (number, text) = line.split_once(' ').expect("number and text");
        let number: i64 = number.parse().expect("a number");
        match known.get(&number) {
            Some(name) => assert!(
                text != "unknown status" && texts.insert(text),
                "{name} = {number} has no text of its own: {text}"
            ),
            None => assert_eq!(text, "unknown status", "{number}"),
        }
    }
    assert_eq!(texts.len(), known.len());
    let version = format!("version {} abi {}", env!("CARGO_PKG_VERSION"), ffi::KSTRIP_ABI_VERSION);
    assert!(text.lines().any(|line| line == version), "{version}");
}

#[test]
fn threads_and_rust_see_the_same_bits() {
    let text = run_c("tests/c/threads.c");
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for i in 0..4096_i32 {
        let contact = Contact {
            b: f64::from(1 + i % 7) / 700.0,
            poisson_ratio: f64::from(i % 6) / 10.0,
            ..C0
        };
        let creepage = creep(
            f64::from(i % 16 - 7) / 4000.0,
            f64::from(i / 16 % 16 - 7) / 4000.0,
            f64::from(i / 256 - 7) / 8.0,
        );
        let options = Options {
            model: Model::from_number(1 + i % 5).expect("a model"),
            strips: StripCount::from_number(4 << (i / 5 % 5)).expect("a count"),
        };
        let r = solved(&contact, &creepage, &options);
        for number in [r.fx, r.fy, r.mz, r.power, r.adhesion] {
            // FNV-1a
            hash = (hash ^ number.to_bits()).wrapping_mul(0x0100_0000_01b3);
        }
    }
    // Four threads of a C program, and one of this test
    assert_eq!(text.trim(), format!("threads 4 cases 4096 differing 0 hash {hash:016x}"));
}

/// The page's stack is what calls change of a painted one, and about a quarter more. (With
/// the library as `cargo test` compiles it frames are up to twice as large.)
#[test]
#[cfg(all(target_arch = "x86_64", target_os = "linux"))]
fn calls_need_the_stack_that_the_page_says() {
    let page = read("docs/reference/building.md");
    let row = |line: &str| {
        let (name, rest) = line.strip_prefix("| `")?.split_once("` | ")?;
        Some((name.to_owned(), rest.strip_suffix(" |")?.parse::<f64>().ok()?))
    };
    let mut said: BTreeMap<String, f64> = page.lines().filter_map(row).collect();
    let is_released = std::env::var_os("KSTRIP_RELEASE_LIBRARY").is_some();
    for line in run_c("tests/c/stack.c").lines() {
        let (name, bytes) = line.split_once(' ').expect("a name and a number");
        let needed = bytes.parse::<f64>().expect("a number") / 1e3;
        let limit = said.remove(name).unwrap_or_else(|| panic!("{name} is not on the page"));
        let share = limit / needed;
        let range = if is_released { 1.1..1.5 } else { 0.5..5.0 };
        assert!(range.contains(&share), "{name}: {needed} kB, on the page {limit} kB");
    }
    assert_eq!(said.into_keys().collect::<Vec<_>>(), Vec::<String>::new(), "not measured");
}
