//! Derivatives of a wheel's forces with respect to its position against differences that converge,
//! on real profiles.

use crate::manchester::{steel, zeroed};
use crate::random::Random;
use crate::wheel_continuity::{RAILS, WHEELS};
use crate::wheel_rail::profile;
use kstrip::contact::totals::StripCount;
use kstrip::forces::Model;
use kstrip::wheel_rail::scene::{Scene, Workspace};
use kstrip::wheel_rail::wrench::{Law, WrenchByPosition};
use kstrip::wheel_rail::{Position, Velocity};

type Members = [f64; 6];

fn moved(position: &Position<f64>, k: usize, step: f64) -> Position<f64> {
    let mut moved = *position;
    let Position { lateral, vertical, yaw, roll } = &mut moved;
    *[lateral, vertical, yaw, roll][k] += step;
    moved
}

/// Differences to both sides with h and h/2, extrapolated, and how far both are apart.
fn differences(at: &mut dyn FnMut(f64) -> Option<Members>, h: f64) -> Option<(Members, Members)> {
    let mut central = |h: f64| {
        let (ahead, behind) = (at(h)?, at(-h)?);
        Some(std::array::from_fn::<f64, 6, _>(|i| (ahead[i] - behind[i]) / (2.0 * h)))
    };
    let (d1, d2) = (central(h)?, central(h / 2.0)?);
    let found = std::array::from_fn(|i| (4.0 * d2[i] - d1[i]) / 3.0);
    Some((found, std::array::from_fn(|i| (d2[i] - d1[i]).abs())))
}

/// Random wheels at random positions and velocities: of each column the largest error over its
/// largest entry, where the differences converge.
#[test]
fn derivatives_by_position_are_those_of_differences() {
    let mut random = Random::new(5);
    let rails = RAILS.map(|(name, turn)| profile(name, turn));
    let wheels = WHEELS.map(|name| profile(name, 0.0));
    let pair = steel(0.46);
    let mut memory = zeroed::<Workspace<f64>>();
    let mut errors = [const { Vec::<f64>::new() }; 4];
    let mut kinks = 0;
    for _ in 0..60 {
        let rail = &rails[random.bits() as usize % rails.len()];
        let wheel = &wheels[random.bits() as usize % wheels.len()];
        let law = Law { model: Model::Strip, falling: None };
        let scene = Scene { rail, wheel, pair: &pair, strips: StripCount::Sixteen, law };
        let position = Position {
            lateral: random.between(-0.018, -0.004),
            vertical: 0.0,
            yaw: random.between(-0.02, 0.02),
            roll: random.between(-0.01, 0.01),
        };
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
        let mut slopes = WrenchByPosition::default();
        scene.solve(&position, &velocity, &mut memory, None, Some(&mut slopes)).unwrap();
        let WrenchByPosition { lateral, vertical, yaw, roll } = slopes;
        for (k, column) in [lateral, vertical, yaw, roll].into_iter().enumerate() {
            let mut at = |step: f64| {
                let found =
                    scene.solve(&moved(&position, k, step), &velocity, &mut memory, None, None);
                found.ok().map(|wrench| wrench.members())
            };
            let best = [1e-6, 3e-7, 1e-7, 3e-8]
                .into_iter()
                .filter_map(|h| differences(&mut at, h))
                .map(|(found, doubt)| {
                    let size = found.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
                    let doubt = doubt.iter().fold(0.0, |most: f64, x| most.max(x.abs())) / size;
                    (doubt, found, size)
                })
                .min_by(|one, other| one.0.total_cmp(&other.0));
            let Some((_, found, size)) = best.filter(|(doubt, ..)| *doubt < 1e-5) else {
                kinks += 1;
                continue;
            };
            let off = column
                .iter()
                .zip(found)
                .fold(0.0, |most: f64, (own, found)| most.max((own - found).abs() / size));
            errors[k].push(off);
        }
    }
    for (name, mut errors) in ["lateral", "vertical", "yaw", "roll"].into_iter().zip(errors) {
        errors.sort_by(f64::total_cmp);
        let at = |share: f64| errors[((errors.len() - 1) as f64 * share) as usize];
        assert!(errors.len() > 40 && at(0.5) < 2e-6 && at(1.0) < 2e-4, "{name}: {errors:?}");
        println!("{name}: {} {:.1e} {:.1e} {:.1e}", errors.len(), at(0.5), at(0.9), at(1.0));
    }
    println!("kinks {kinks}");
}
