//! Derivatives of a wheel's forces with respect to its position against differences that converge,
//! on real profiles.

use crate::prelude::*;
use crate::wheel_continuity::{RAILS, WHEELS};
use crate::wheel_rail::{by_position, single};
use kstrip::patch::Patch;
use kstrip::wheel_rail::touch::Gap;

type Members = [f64; 6];

fn moved(position: &Position<f64>, k: usize, step: f64) -> Position<f64> {
    let mut moved = *position;
    let Position { lateral, vertical, yaw, roll } = &mut moved;
    *[lateral, vertical, yaw, roll][k] += step;
    moved
}

/// Differences to both sides with h and h/2, extrapolated, and how far both are apart, or those to
/// one side from those to the other: where there is a kink between, they converge too.
fn differences(at: &mut dyn FnMut(f64) -> Option<Members>, h: f64) -> Option<(Members, Members)> {
    let here = at(0.0)?;
    let [[a1, b1], [a2, b2]] = [[at(h)?, at(-h)?], [at(0.5 * h)?, at(-0.5 * h)?]];
    let central = |i: usize| [(a1[i] - b1[i]) / (2.0 * h), (a2[i] - b2[i]) / h];
    let found = std::array::from_fn(|i| (4.0 * central(i)[1] - central(i)[0]) / 3.0);
    let doubt = std::array::from_fn(|i| {
        let [d1, d2] = central(i);
        let [ahead, behind] =
            [(a2, a1), (b2, b1)].map(|(near, far)| (4.0 * near[i] - 3.0 * here[i] - far[i]) / h);
        (d2 - d1).abs().max((ahead + behind).abs())
    });
    Some((found, doubt))
}

/// Of each column of the derivatives the largest error over its largest entry; none where the
/// differences do not converge.
fn errors(
    scene: &Scene<f64>, position: &Position<f64>, velocity: &Velocity<f64>,
    memory: &mut Workspace<f64>,
) -> [Option<f64>; 4] {
    let (_, slopes) = by_position(scene, *position, *velocity, memory);
    let WrenchByPosition { lateral, vertical, yaw, roll } = slopes;
    let columns = [lateral, vertical, yaw, roll];
    std::array::from_fn(|k| {
        let mut at = |step: f64| {
            let state = BodyState { position: moved(position, k, step), velocity: *velocity };
            scene.solve(&state, memory).ok().map(|wrench| wrench.members())
        };
        let largest = |list: Members| list.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let best = [1e-6, 3e-7, 1e-7, 3e-8, 1e-8, 3e-9, 1e-9]
            .map(|h| if k == 2 { 3.0 * h } else { h })
            .into_iter()
            .filter_map(|h| differences(&mut at, h))
            .map(|(found, doubt)| (largest(doubt) / largest(found), found))
            .min_by(|one, other| one.0.total_cmp(&other.0));
        let (_, found) = best.filter(|(doubt, _)| *doubt < 1e-5)?;
        let off = std::array::from_fn(|i| columns[k][i] - found[i]);
        Some(largest(off) / largest(found))
    })
}

/// Random wheels at random positions and velocities, where the differences converge. (Of one in ten
/// the error is larger: those of a column that is small because much cancels, and differences over
/// a kink that do converge.)
#[test]
fn derivatives_by_position_are_those_of_differences() {
    let mut random = Random::new(5);
    let rails = RAILS.map(|(name, turn)| profile(name, turn));
    let wheels = WHEELS.map(|name| profile(name, 0.0));
    let pair = steel(0.46);
    let mut memory = zeroed::<Workspace<f64>>();
    let mut all = [const { Vec::<f64>::new() }; 4];
    let mut kinks = 0;
    for _ in 0..120 {
        let rail = &rails[random.bits() as usize % rails.len()];
        let wheel = &wheels[random.bits() as usize % wheels.len()];
        let scene = scene(rail, wheel, &pair);
        let position = placed([
            random.between(-0.018, -0.004),
            0.0,
            random.between(-0.02, 0.02),
            random.between(-0.01, 0.01),
        ]);
        let load = random.log_between(3e3, 150e3);
        let velocity = Velocity {
            forward: 20.0,
            lateral: random.between(-0.05, 0.05),
            pitch: -20.0 / 0.46 * random.between(0.997, 1.003),
            ..Velocity::default()
        };
        let Ok((vertical, _)) = scene.height_for_load(&position, load, None, &mut memory) else {
            continue;
        };
        let position = Position { vertical, ..position };
        for (all, off) in all.iter_mut().zip(errors(&scene, &position, &velocity, &mut memory)) {
            all.extend(off);
            kinks += usize::from(off.is_none());
        }
    }
    for (name, mut errors) in ["lateral", "vertical", "yaw", "roll"].into_iter().zip(all) {
        errors.sort_by(f64::total_cmp);
        let at = |share: f64| errors[((errors.len() - 1) as f64 * share) as usize];
        assert!(errors.len() > 80 && at(0.9) < 1e-6 && at(1.0) < 2e-5, "{name}: {errors:?}");
        println!("{name}: {} {:.1e} {:.1e} {:.1e}", errors.len(), at(0.5), at(0.9), at(1.0));
    }
    println!("kinks {kinks}");
    assert!(kinks < 4);
}

/// Rails whose side leans back below: the gap ends at a place of the rail, between two points of a
/// wheel, and is near enough there to count.
#[test]
fn derivatives_by_position_where_a_rail_leans_back() {
    let rail = profile("avglow", 0.0);
    let pair = WheelPair { smoothing_length: 2e-3, ..steel(0.46) };
    let velocity = Velocity { lateral: 0.05, ..ROLLING };
    let mut memory = zeroed::<Workspace<f64>>();
    for (lateral, name) in [(9.4e-3, "en_wheel_h"), (9e-3, "en_wheel_a"), (8e-3, "s1002")] {
        let wheel = profile(name, 0.0);
        let scene = scene(&rail, &wheel, &pair);
        let position = placed([lateral, 0.0, -0.0175, -0.0094]);
        let (vertical, _) = scene.height_for_load(&position, 130e3, None, &mut memory).unwrap();
        let position = Position { vertical, ..position };
        let errors = errors(&scene, &position, &velocity, &mut memory);
        let Gap { along, distance, .. } = &memory.gap;
        let steepest =
            (0..rail.count as usize / 2).rfind(|&k| 3.0 * rail.cosine[k] < -1.0).unwrap() as f64;
        let ends = |along: f64| (0.0..1.0).contains(&(along / rail.step - steepest));
        let first = (0..2).find(|&k| ends(along[k])).unwrap();
        println!("{name}: {errors:?}, {} {}", along[first] / rail.step, distance[first]);
        assert!(distance[first] < 1e-3, "{name}: {}", distance[first]);
        assert!(errors.iter().all(|off| off.is_some_and(|off| off < 1e-6)), "{name}: {errors:?}");
        // as it rolls, points of the wheel pass the part of the side that leans back
        let (mut before, step) = (None, 2.5e-6);
        for k in -400..=0 {
            let position = moved(&position, 3, step * f64::from(k));
            let (wrench, slopes) = by_position(&scene, position, velocity, &mut memory);
            let here = (wrench.force[1], slopes.roll[1]);
            if let Some((force, slope)) = before {
                let jump: f64 = here.0 - force - 0.5 * step * (here.1 + slope);
                assert!(jump.abs() < 40.0, "{name} {k}: {jump} of {force}");
            }
            before = Some(here);
        }
    }
}

/// As a wheel shifts, its strips pass the points of the gap: S1002 on 60E1 at 80 kN.
#[test]
fn derivatives_by_position_have_no_steps_where_strips_pass_points() {
    let (rail, wheel, pair) = (profile("uic60", 0.025), profile("s1002", 0.0), steel(0.46));
    let (scene, mut memory) = (scene(&rail, &wheel, &pair), zeroed::<Workspace<f64>>());
    let velocity = Velocity { lateral: 0.05, yaw: 0.02, ..ROLLING };
    for (lateral, yaw) in [(-0.010, 0.0), (-0.012, 0.0), (-0.010, 0.008), (-0.006, 0.008)] {
        let start = placed([lateral, 0.0, yaw, 0.0]);
        let (vertical, _) = scene.height_for_load(&start, 80e3, None, &mut memory).unwrap();
        let columns: Vec<[f64; 24]> = (-200..=200)
            .map(|k| {
                let lateral = lateral + 5e-7 * f64::from(k);
                let position = Position { lateral, vertical, ..start };
                let (_, slopes) = by_position(&scene, position, velocity, &mut memory);
                let WrenchByPosition { lateral, vertical, yaw, roll } = slopes;
                let of = |k: usize| [lateral, vertical, yaw, roll][k / 6][k % 6];
                std::array::from_fn(of)
            })
            .collect();
        for entry in 0..24 {
            let all: Vec<f64> = columns.iter().map(|own| own[entry]).collect();
            let largest = all.iter().fold(0.0, |most: f64, own| most.max(own.abs()));
            for four in all.windows(4) {
                let [before, own, after] = [1, 2, 3].map(|k| (four[k] - four[k - 1]).abs());
                let step = own - before.max(after);
                assert!(step < 5e-3 * largest, "{lateral} {yaw}, {entry}: {step} of {largest}");
            }
        }
    }
}

/// `dF_z/dz` of a rolling wheel at lateral, vertical, yaw and roll.
fn stiffness<F: Float>(scene: &Scene<F>, [lateral, vertical, yaw, roll]: [F; 4]) -> F {
    let position = Position { lateral, vertical, yaw, roll };
    let [forward, lateral, pitch, yaw] = [20.0, 0.05, -43.4, 0.02].map(F::of);
    let velocity = Velocity { forward, lateral, pitch, yaw, ..Velocity::default() };
    by_position(scene, position, velocity, &mut zeroed()).1.vertical[2]
}

/// Cells that touch by less than the step of single precision: their pressures keep the whole of
/// their derivatives.
#[test]
fn derivatives_of_slight_pressures_are_those_of_double_precision() {
    let narrow = |surface: &PreparedProfile<f64>| {
        let PreparedProfile { y, z, cosine, sine, step, spacing, count, form } = *surface;
        let [y, z, cosine, sine] = [y, z, cosine, sine].map(|list| list.map(|x| x as f32));
        PreparedProfile {
            y,
            z,
            cosine,
            sine,
            step: step as f32,
            spacing: spacing as f32,
            count,
            form,
        }
    };
    let (rail, wheel) = (profile("wornhm", 0.0), profile("en_wheel_a", 0.0));
    let pair = WheelPair { smoothing_length: 2e-3, ..steel(0.46) };
    let narrow_pair = WheelPair { smoothing_length: 2e-3, ..single(&pair) };
    for (strips, position) in [
        (
            StripCount::SixtyFour,
            [-0.005_150_327_f32, 0.003_896_082, -0.009_268_816, -0.014_159_497],
        ),
        (StripCount::Four, [0.002_467_777_8, 0.003_207_147_6, 0.016_837_627, -0.008_922_612]),
    ] {
        let exact = Scene { strips, ..scene(&rail, &wheel, &pair) };
        let exact = stiffness(&exact, position.map(f64::from));
        let law = Law { model: Model::Strip, falling: None };
        let (rail, wheel) = (&narrow(&rail), &narrow(&wheel));
        let scene = Scene { rail, wheel, pair: &narrow_pair, strips, law, table: None };
        let off = f64::from(stiffness(&scene, position)) / exact - 1.0;
        assert!(off.abs() < 8e-3, "{strips:?} {off:.1e}");
    }
}

/// Two bottoms so far apart that both are one contact and two, each by a share, which changes as
/// the wheel moves. (As it moves across, one contact rises and the other falls, so that most of the
/// column cancels.)
#[test]
fn derivatives_by_position_follow_the_shares_of_contacts() {
    let y: [f64; 200] = std::array::from_fn(|i| (i as f64 - 99.5) * 100e-6);
    let (mut rail, mut wheel) =
        (zeroed::<PreparedProfile<f64>>(), zeroed::<PreparedProfile<f64>>());
    rail.prepare(&y, &y.map(|y| y * y / 0.6), 0.0, 0.0).unwrap();
    let bumps = y.map(|y| -(180e-6 + 0.008 * y) * ((y / 4.5e-3).powi(2) - 1.0).powi(2));
    wheel.prepare(&y, &bumps, 0.0, 0.0).unwrap();
    let pair = steel(0.46);
    let (rail, wheel) = (&*rail, &*wheel);
    let scene = scene(rail, wheel, &pair);
    let mut memory = zeroed::<Workspace<f64>>();
    for (lateral, load) in [(1e-5, 30e3), (-4e-5, 45e3), (2e-5, 20e3)] {
        let position = Position { lateral, vertical: 0.0, yaw: 0.002, roll: 1e-4 };
        let (vertical, _) = scene.height_for_load(&position, load, None, &mut memory).unwrap();
        let position = Position { vertical, ..position };
        let found = errors(&scene, &position, &ROLLING, &mut memory);
        println!("{found:?} {:?}", memory.found().iter().map(|one| one.share).collect::<Vec<_>>());
        assert!(memory.found().iter().any(|one| one.share > 0.0 && one.share < 1.0));
        assert!(found.iter().all(|off| off.is_some_and(|off| off < 2e-5)), "{found:?}");
    }
}

/// A contact so wide that the steps of its knots follow the length over which the surfaces are low,
/// with waves so short that it matters where the knots are. (Lateral and roll hardly change the
/// force of a wheel that is even but for its waves.)
#[test]
fn derivatives_by_position_of_a_wide_contact() {
    let y: [f64; 400] = std::array::from_fn(|i| (i as f64 - 199.5) * 100e-6);
    let rail = prepared(&y, &y.map(|y| y * y / 0.6));
    let wheel = prepared(&y, &y.map(|y| 2e-6 * (y / 120e-6).sin()));
    let pair = steel(0.46);
    let scene = scene(&rail, &wheel, &pair);
    let (mut memory, position) = (zeroed::<Workspace<f64>>(), placed([1e-4, 0.0, 0.002, 1e-4]));
    for load in [60e3, 100e3, 150e3] {
        let (vertical, _) = scene.height_for_load(&position, load, None, &mut memory).unwrap();
        let position = Position { vertical, ..position };
        let found = errors(&scene, &position, &ROLLING, &mut memory);
        println!("{found:?}");
        assert!(found.iter().all(|off| off.is_some_and(|off| off < 5e-5)), "{found:?}");
    }
}

fn zones(memory: &Workspace<f64>) -> usize {
    let of_contact = |contact: &WheelContact<f64>| {
        let Patch { strips, count, .. } = &contact.patch;
        let strips = &strips[..*count as usize];
        let apart = |pair: &[PatchStrip<f64>]| {
            pair[1].y - pair[0].y > 0.5 * (pair[0].width + pair[1].width) + 1e-12
        };
        usize::from(!strips.is_empty()) + strips.windows(2).filter(|pair| apart(pair)).count()
    };
    memory.found().iter().map(of_contact).sum()
}

/// Where a zone has just begun its strips change by more than their size over any step.
#[test]
fn derivatives_by_position_are_there_where_zones_begin() {
    let mut random = Random::new(8);
    let rails = RAILS.map(|(name, turn)| profile(name, turn));
    let wheels = WHEELS.map(|name| profile(name, 0.0));
    let mut memory = zeroed::<Workspace<f64>>();
    let velocity = Velocity { lateral: 0.02, ..ROLLING };
    let mut begun = 0;
    for trial in 0..48 {
        let pair = WheelPair { smoothing_length: [0.0, 2e-3, 4e-3][trial % 3], ..steel(0.46) };
        let (rail, wheel) = (&rails[trial % 6], &wheels[trial / 6 % 4]);
        let scene = scene(rail, wheel, &pair);
        let [lateral, yaw] = [random.between(-15e-3, 5e-3), random.between(-0.02, 0.02)];
        let start = Position { lateral, yaw, vertical: 0.0, roll: 0.0 };
        let Ok((deep, _)) = scene.height_for_load(&start, 150e3, None, &mut memory) else {
            continue;
        };
        let mut count = |vertical: f64| {
            let position = Position { vertical, ..start };
            scene.solve(&BodyState { position, velocity }, &mut memory).unwrap();
            zones(&memory)
        };
        let mut begins = Vec::new();
        for k in 0..40 {
            let ends = [k, k + 1].map(|k| deep - 4e-4 + 1e-5 * f64::from(k));
            let few = count(ends[0]);
            if count(ends[1]) > few {
                begins.push(bisect(ends, 0.0, |vertical| count(vertical) <= few)[1]);
            }
        }
        begun += begins.len();
        for (begin, deeper) in begins.iter().flat_map(|begin| {
            [0.0, 1e-18, 1e-16, 1e-14, 1e-12, 1e-10, 1e-8].map(|deeper| (begin, deeper))
        }) {
            let position = Position { vertical: begin + deeper, ..start };
            let (_, slopes) = by_position(&scene, position, velocity, &mut memory);
            let WrenchByPosition { lateral, vertical, yaw, roll } = slopes;
            let all = [lateral, vertical, yaw, roll];
            assert!(all.as_flattened().iter().all(|slope| slope.is_finite()), "{all:?}");
            assert!(deeper < 1e-15 || vertical[2].abs() < 1e10, "{vertical:?} {position:?}");
        }
    }
    assert!(begun > 20, "{begun}");
}
