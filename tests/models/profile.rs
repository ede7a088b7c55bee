//! Patches from profiles: Hertz's own, load and approach, zones, shapes that do not matter, noise,
//! bad input.

use crate::prelude::*;
use kstrip_testing::patch_reference::{Full, real};
use std::f64::consts::TAU;

const SIXTEEN: StripCount = StripCount::Sixteen;

/// A parabola `y²/(2 R)` at `2 n + 1` points.
fn parabola(radius: f64, half_width: f64, n: i32) -> (Vec<f64>, Vec<f64>) {
    drawn(n, half_width, |y| y * y / (2.0 * radius))
}

pub(crate) fn pressed(rolling_radius: f64, load: f64) -> ProfileContact<f64> {
    ProfileContact {
        rolling_radius,
        given: Given::Load(load),
        shear_modulus: 82e9,
        poisson_ratio: 0.28,
        friction: 0.3,
        smoothing_length: 0.0,
    }
}

fn built(
    y: &[f64], distance: &[f64], contact: &ProfileContact<f64>, count: StripCount,
) -> (Full, Indentation<f64>) {
    Full::from_profile(&Profile::new(y, distance).unwrap(), contact, count).unwrap()
}

fn found(y: &[f64], distance: &[f64], contact: &ProfileContact<f64>) -> Indentation<f64> {
    built(y, distance, contact, SIXTEEN).1
}

/// Places from -end to end, `n` to either side, and the heights there.
fn drawn(n: i32, end: f64, height: impl Fn(f64) -> f64) -> (Vec<f64>, Vec<f64>) {
    let y: Vec<f64> = (-n..=n).map(|i| end * f64::from(i) / f64::from(n)).collect();
    let distance = y.iter().map(|y| height(*y)).collect();
    (y, distance)
}

/// Paraboloids are Hertz's: semi-axes, pressure, approach, and `dN/dδ = 3 N/(2 δ)`.
#[test]
fn paraboloids_are_those_of_hertz() {
    for (rolling, across) in [(0.46, 0.3), (0.46, 0.46), (0.46, 0.05), (0.46, 3.0), (0.01, 0.5)] {
        for load in [1.0, 80e3] {
            let exact = hertz(&radii([FLAT, across, rolling, FLAT]), load, 82e9, 0.28).unwrap();
            let (y, distance) = parabola(across, 4.0 * exact.b, 200);
            let (patch, found) = built(&y, &distance, &pressed(rolling, load), SIXTEEN);
            let area = patch.view().unwrap().area();
            let longest = patch.used().iter().map(|s| s.half_length).fold(0.0, f64::max);
            let deviations = [
                longest / exact.a,
                area / (PI * exact.a * exact.b),
                found.peak_pressure / exact.peak_pressure,
                found.approach / exact.approach,
                found.stiffness * exact.approach / load / 1.5,
            ]
            .map(|ratio| 100.0 * (ratio - 1.0));
            println!("R {rolling} across {across} load {load}: {deviations:.2?} %");
            assert!(found.peak_y.abs() < exact.b / 8.0, "{found:?}");
            for (deviation, allowed) in deviations.into_iter().zip([2.0, 2.5, 0.8, 1.0, 1.0]) {
                assert!(deviation.abs() < allowed, "{deviations:?}");
            }
        }
    }
}

/// The strips carry the load, whatever their number; an approach gives the load that gave it, and
/// `dN/dδ` is the slope of that.
#[test]
fn load_and_approach_are_each_others_inverse() {
    let cases = profiles();
    for count in [StripCount::Eight, SIXTEEN, StripCount::ThirtyTwo] {
        let mut worst = [0.0_f64; 2];
        for case in &cases {
            let (patch, by_load) = case.patch(count);
            assert_relative_eq!(
                patch.view().unwrap().normal_force(),
                case.load,
                max_relative = 1e-12
            );
            let at = |approach: f64| {
                let contact = ProfileContact { given: Given::Approach(approach), ..case.contact() };
                built(&case.y, &case.distance, &contact, count).1
            };
            let by_approach = at(by_load.approach);
            assert_eq!(by_approach.approach, by_load.approach);
            let step = 0.01 * by_load.approach;
            let slope = (at(by_load.approach + step).normal_force
                - at(by_load.approach - step).normal_force)
                / (2.0 * step);
            let errors =
                [by_approach.normal_force / case.load - 1.0, by_approach.stiffness / slope - 1.0];
            for (worst, error) in worst.iter_mut().zip(errors) {
                *worst = worst.max(error.abs());
            }
            for (error, allowed) in errors.into_iter().zip([0.01, 2e-3]) {
                assert!(error.abs() < allowed, "{count:?} {} {errors:?}", case.name);
            }
        }
        println!("{count:?}: load {:.1e}, stiffness {:.1e}", worst[0], worst[1]);
    }
}

/// Refining or shifting the table of points, or lifting all of it, changes nothing but rounding.
#[test]
fn a_profile_is_its_shape() {
    let points = [-9e-3, -6e-3, -4.5e-3, -2e-3, -0.3e-3, 1.1e-3, 2e-3, 4e-3, 5e-3, 7e-3, 9e-3];
    let heights = [200e-6, 90e-6, 31e-6, 12e-6, 1e-6, 0.0, 16e-6, 25e-6, 33e-6, 100e-6, 300e-6];
    let contact = ProfileContact { smoothing_length: 4e-3, ..pressed(0.46, 60e3) };
    let wanted = found(&points, &heights, &contact);
    let moved: Vec<f64> = points.iter().map(|y| y + 0.7).collect();
    let lifted: Vec<f64> = heights.iter().map(|z| z - 0.3).collect();
    let moved = found(&moved, &lifted, &contact);
    assert_relative_eq!(moved.approach, wanted.approach, max_relative = 9e-13);
    assert_relative_eq!(moved.peak_y, wanted.peak_y + 0.7, max_relative = 4e-15);
    assert_relative_eq!(moved.peak_pressure, wanted.peak_pressure, max_relative = 2e-12);
    // points where they are needed, and many
    let case = &profiles()[9];
    let even = case.patch(SIXTEEN).1;
    let mut random = Random::new(420);
    let at = |y: f64| {
        let n = case.y.partition_point(|x| *x < y).clamp(1, case.y.len() - 1);
        let share = (y - case.y[n - 1]) / (case.y[n] - case.y[n - 1]);
        case.distance[n - 1] + share * (case.distance[n] - case.distance[n - 1])
    };
    for many in [150, 100_000] {
        let ends = [case.y[0], case.y[case.y.len() - 1]];
        let mut y: Vec<f64> = (0..many).map(|_| random.between(ends[0], ends[1])).collect();
        y.extend(ends);
        y.sort_by(f64::total_cmp);
        y.dedup();
        let distance: Vec<f64> = y.iter().map(|y| at(*y)).collect();
        let uneven = found(&y, &distance, &case.contact());
        println!("{many} points: {:.1e}", uneven.peak_pressure / even.peak_pressure - 1.0);
        assert_relative_eq!(uneven.peak_pressure, even.peak_pressure, max_relative = 0.01);
        assert_relative_eq!(uneven.approach, even.approach, max_relative = 3e-3);
    }
}

/// Load and approach rise together, also where a second zone of contact comes in.
#[test]
fn two_zones_of_contact() {
    // a double bottom, the right one 10 µm higher
    let bottoms = |y: f64| f64::min((y + 5e-3).powi(2) / 0.3, (y - 5e-3).powi(2) / 0.2 + 10e-6);
    let (y, distance) = drawn(300, 12e-3, bottoms);
    let mut before = 0.0;
    let mut lobes = Vec::new();
    for load in [1e2, 1e3, 5e3, 1e4, 2e4, 4e4, 8e4] {
        let (patch, found) = built(&y, &distance, &pressed(0.46, load), StripCount::ThirtyTwo);
        assert!(found.approach > before, "{load} {found:?}");
        before = found.approach;
        let view = patch.view().unwrap();
        assert_relative_eq!(view.normal_force(), load, max_relative = 4e-15);
        lobes.push(view.lobes().count());
    }
    assert!(lobes.is_sorted() && lobes[0] == 1 && lobes[6] == 2, "{lobes:?}");
}

/// More zones than are kept apart: the two beside the narrowest gap count as one, and none is lost,
/// wherever that gap is.
#[test]
fn a_corrugated_profile_loses_no_zone() {
    for narrow in 0..8 {
        // nine grooves 2.5 mm apart, two of them 2 mm
        let groove = |k: i32| 2.5e-3 * f64::from(k) - if k > narrow { 0.5e-3 } else { 0.0 };
        let y: Vec<f64> = (-50..=450).map(|i| 0.05e-3 * f64::from(i)).collect();
        let height = |y: f64| (0..9).map(|k| (y - groove(k)).powi(2) / 0.02).fold(1.0, f64::min);
        let distance: Vec<f64> = y.iter().map(|y| height(*y)).collect();
        let contact = ProfileContact { smoothing_length: 0.4e-3, ..pressed(0.46, 2e3) };
        let (patch, _) = built(&y, &distance, &contact, StripCount::SixtyFour);
        for k in 0..9 {
            let near = patch.used().iter().filter(|strip| (strip.y - groove(k)).abs() < 0.5e-3);
            let load: f64 = near.map(PatchStrip::load).sum();
            assert!(load > 100.0, "{narrow}: groove {k} carries {load} of 2000 N");
        }
    }
}

/// One bad point of 20 µm anywhere changes no force by 0.02 of `μ N`; noise of 5 µm rms less than
/// two in a hundred. Those that it does are where the noise tells another shape: in a wide patch
/// that spins it moves the middle by 0.1 mm.
#[test]
fn noise_and_bad_points_hardly_matter() {
    let mut random = Random::new(421);
    let (mut noisy, mut spoilt) = (Vec::new(), Vec::new());
    for case in profiles() {
        let clean = case.patch(SIXTEEN).0;
        for i in 0..8 {
            let bad = i % 2 == 1;
            let mut distance = case.distance.clone();
            if bad {
                let place = random.between(-5e-3, 5e-3);
                let i = case.y.partition_point(|y| *y < place);
                distance[i] += 20e-6 * random.sign();
            } else {
                for h in &mut distance {
                    // twelve uniform numbers make a normal one
                    let normal: f64 = (0..12).map(|_| random.between(-0.5, 0.5)).sum();
                    *h += 5e-6 * normal;
                }
            }
            let (patch, _) = built(&case.y, &distance, &case.contact(), SIXTEEN);
            for motion in &case.motions {
                let [clean, patch] = [&clean, &patch].map(|patch| {
                    let view = patch.view().unwrap();
                    let found =
                        solver::solve_patch(&view, &case.creepage(motion), Model::Strip).unwrap();
                    [found.fx, found.fy].map(|force| force / (case.friction * case.load))
                });
                let change = (clean[0] - patch[0]).hypot(clean[1] - patch[1]);
                if bad { &mut spoilt } else { &mut noisy }.push(change);
            }
        }
    }
    let large = noisy.iter().filter(|change| **change > 0.02).count();
    let (noise, bad) = (statistics(&noisy), statistics(&spoilt));
    println!("noise {noise:.4?}, {large} of {} above 0.02; bad points {bad:.4?}", noisy.len());
    assert!(50 * large < noisy.len(), "{large}");
    assert!(noise[0] < 0.005 && noise[1] < 0.015, "{noise:?}");
    assert!(bad[2] < 0.02, "{bad:?}");
}

/// Too little profile for the load, its deepest point at the end, or flat: the bodies end there.
#[test]
fn profiles_end_where_they_end() {
    let (y, distance) = parabola(0.3, 0.03, 20);
    let good = pressed(0.46, 80e3);
    let (narrow, low) = parabola(0.3, 2e-3, 20);
    let flat = vec![0.0; 41];
    let ends: [(&[f64], &[f64]); 4] =
        [(&narrow, &low), (&y[20..], &distance[20..]), (&y, &flat), (&y[..2], &distance[..2])];
    for (y, distance) in ends {
        let found = found(y, distance, &good);
        assert_eq!(found.warning, Warning::ProfileEnd);
        assert_relative_eq!(found.normal_force, 80e3, max_relative = 4e-15);
    }
    assert_eq!(found(&y, &distance, &good).warning, Warning::None);
    assert_eq!(Profile::new(&y, &distance[1..]).err(), Some(Error::Profile));
    let profile = Profile::new(&y, &distance).unwrap();
    // No load, no approach: no strips
    for given in [Given::Load(0.0), Given::Approach(0.0), Given::Approach(-1e-5)] {
        let contact = ProfileContact { given, ..good };
        let (empty, found) = Full::from_profile(&profile, &contact, SIXTEEN).unwrap();
        assert!(empty.used().is_empty() && found.normal_force == 0.0, "{found:?}");
        // (in the middle of the profile)
        assert_eq!(found.peak_y, 0.5 * (y[0] + y[y.len() - 1]));
    }
}

#[test]
fn profiles_in_single_precision() {
    for case in profiles() {
        let narrow = |list: &[f64]| -> Vec<f32> { list.iter().map(|x| *x as f32).collect() };
        let contact = ProfileContact {
            rolling_radius: case.rolling_radius as f32,
            given: Given::Load(case.load as f32),
            shear_modulus: case.shear_modulus as f32,
            poisson_ratio: case.poisson_ratio as f32,
            friction: case.friction as f32,
            smoothing_length: 0.0,
        };
        let (y, distance) = (narrow(&case.y), narrow(&case.distance));
        let (patch, found) =
            Patch::<f32>::from_profile(&Profile::new(&y, &distance).unwrap(), &contact, SIXTEEN)
                .unwrap();
        let wanted = case.patch(SIXTEEN).1;
        let load = f64::from(patch.view().unwrap().normal_force());
        assert_relative_eq!(load, case.load, max_relative = 1e-6);
        let (peak, approach) = (f64::from(found.peak_pressure), f64::from(found.approach));
        assert_relative_eq!(peak, wanted.peak_pressure, max_relative = 2e-4);
        assert_relative_eq!(approach, wanted.approach, max_relative = 2e-6);
    }
}

/// Zones that appear, grow, touch and merge: the forces follow the load without a jump. A tenth of
/// the step is a tenth of the change, to the noise of strips that begin to touch, also where two
/// zones become one.
#[test]
fn zones_merge_without_a_jump() {
    let motion = creep(3e-4, 5e-4, 0.1);
    for (crest, merging, zones) in
        [(70e-6, [150e3, 160e3], [true, false]), (30e-6, [76e3, 84e3], [true, true])]
    {
        let (y, distance) = drawn(1000, 20e-3, |y| crest * ((y / 4.5e-3).powi(2) - 1.0).powi(2));
        // largest steps of the force with STRIP and TOTAL and of the approach; whether two lobes
        // were seen, and one
        let steps = |[mut load, end]: [f64; 2], share: f64| {
            let (mut steps, mut seen) = ([0.0_f64; 3], [false; 2]);
            let mut last = None::<([[f64; 2]; 2], f64)>;
            while load < end {
                let contact = pressed(0.46, load);
                let (patch, found) = built(&y, &distance, &contact, SIXTEEN);
                let view = patch.view().unwrap();
                let both = [Model::Strip, Model::Total].map(|model| {
                    let found = solver::solve_patch(&view, &motion, model).unwrap();
                    [found.fx / (0.3 * load), found.fy / (0.3 * load)]
                });
                if let Some((before, approach)) = last {
                    for ((step, [x, y]), [fx, fy]) in steps.iter_mut().zip(before).zip(both) {
                        *step = step.max((fx - x).hypot(fy - y));
                    }
                    steps[2] = steps[2].max((found.approach / approach - 1.0).abs());
                }
                let lobes = view.lobes().count();
                seen = [seen[0] || lobes == 2, seen[1] || lobes == 1];
                last = Some((both, found.approach));
                load *= 1.0 + share;
            }
            (steps, seen)
        };
        let (coarse, seen) = steps([60e3, 200e3], 1e-3);
        let (fine, _) = steps(merging, 1e-4);
        println!("crest {crest}: largest steps {coarse:?}, of a tenth of the load {fine:?}");
        assert_eq!(seen, zones);
        assert!(coarse[0] < 1.5e-3 && coarse[1] < 1.5e-3 && coarse[2] < 1.5e-3, "{coarse:?}");
        assert!(fine.iter().all(|step| *step < 3e-4), "{fine:?}");
    }
}

/// The largest change between neighbouring numbers, over the value: of the places where a function
/// bends most over a range, each followed by halves to one rounding.
fn largest_jump(of: impl Fn(f64) -> f64, [from, to]: [f64; 2], steps: usize) -> f64 {
    let place = |k: usize| from + (to - from) * k as f64 / steps as f64;
    let found: Vec<f64> = (0..=steps).map(|k| of(place(k))).collect();
    let rise = |k: usize| found[k + 1] - found[k];
    let bend = |k: usize| (rise(k) - rise(k - 1)).abs().min((rise(k) - rise(k + 1)).abs());
    let mut bends: Vec<usize> = (1..steps - 1).collect();
    bends.sort_by(|one, other| bend(*other).total_cmp(&bend(*one)));
    let jumps = bends.iter().take(3).map(|&k| {
        let (ends, values) = ([place(k), place(k + 1)], [found[k], found[k + 1]]);
        let distance = |one: f64, other: f64| (one - other).abs();
        let (_, [below, above]) = steepest(ends, values, 0.0, |x| Some(of(x)), distance);
        (above / below - 1.0).abs()
    });
    jumps.fold(0.0, f64::max)
}

/// Wide contacts, hardly wavy, that are smoothed over 1 mm, so that there would be more knots than
/// room: between neighbouring numbers neither the load of an approach nor the approach of a load
/// jumps.
#[test]
fn wide_contacts_do_not_jump() {
    let mut random = Random::new(441);
    for trial in 0..8 {
        let (radius, step) = (random.between(0.8, 1.6), random.between(0.1e-3, 0.15e-3));
        let (height, length) = (random.between(0.1e-6, 0.4e-6), random.between(5e-3, 8e-3));
        let shift = random.between(-1e-3, 1e-3);
        let h = |y: f64| (y - shift).powi(2) / (2.0 * radius) + height * (TAU * y / length).cos();
        let (y, distance) = drawn(300, 300.0 * step, h);
        let count = [SIXTEEN, StripCount::Eight][trial % 2];
        let of = |given: Given<f64>| {
            let contact = ProfileContact { given, smoothing_length: 1e-3, ..pressed(0.46, 80e3) };
            built(&y, &distance, &contact, count).1
        };
        // (without the powers by which a parabola's load and approach grow)
        let by_approach =
            |approach: f64| of(Given::Approach(approach)).normal_force / approach.powf(1.5);
        let by_approach = largest_jump(by_approach, [50e-6, 150e-6], 60);
        let by_load = |load: f64| of(Given::Load(load)).approach / load.powf(2.0 / 3.0);
        let by_load = largest_jump(by_load, [50e3, 500e3], 60);
        println!("trial {trial}: {by_approach:e} {by_load:e}");
        assert!(by_approach.max(by_load) < 1e-9, "trial {trial}: {by_approach:e} {by_load:e}");
        // a constant that is added to the distance moves no knot
        let lifted: Vec<f64> = distance.iter().map(|distance| distance + 1e-3).collect();
        let contact = ProfileContact { smoothing_length: 1e-3, ..pressed(0.46, 80e3) };
        let [plain, lifted] = [&distance, &lifted].map(|h| built(&y, h, &contact, count).1);
        assert_relative_eq!(lifted.approach, plain.approach, max_relative = 1e-9);
    }
}

/// Two bottoms with flanks slide under a load, in steps of 1 µm: a second zone appears, and the gap
/// between the zones closes. The second differences are those of kinks where strips begin to touch,
/// not those of cells that move at once: of the way of the bodies toward each other over the mean
/// approach, of the force divided by `μ N`.
#[test]
fn a_zone_appears_and_a_gap_closes_slowly() {
    let motion = creep(1e-3, 5e-4, 0.3);
    let at = |shift: f64| {
        let (y, mut distance) = two_bottoms(shift);
        for (y, distance) in y.iter().zip(&mut distance) {
            *distance += (y.abs() - 10e-3).max(0.0).powi(2) / 0.2;
        }
        let (patch, found) = built(&y, &distance, &pressed(0.46, 80e3), SIXTEEN);
        let forces = solver::solve_patch(&patch.view().unwrap(), &motion, Model::Strip).unwrap();
        [(found.approach + found.lowest) / 110e-6, forces.fx / 24e3, forces.fy / 24e3]
    };
    // (the lowest point changes from one bottom to the other at 0)
    for begin in [-2960, -2475, -90] {
        let [largest, quarter] = [1, 4].map(|parts| {
            let places =
                (0..180 * parts).map(|k| f64::from(begin) + f64::from(k) / f64::from(parts));
            let found: Vec<_> = places.map(|shift| at(1e-6 * shift)).collect();
            let mut largest = [0.0_f64; 3];
            for three in found.windows(3) {
                for (k, largest) in largest.iter_mut().enumerate() {
                    *largest = largest.max((three[0][k] - 2.0 * three[1][k] + three[2][k]).abs());
                }
            }
            largest
        });
        println!("largest second differences {largest:?}, over a quarter of the step {quarter:?}");
        assert!(largest.iter().all(|difference| *difference < 1.5e-4), "{largest:?}");
        // those of a kink fall with the step, those of a jump do not
        for (quarter, largest) in quarter.iter().zip(largest) {
            assert!(*quarter < 0.35 * largest, "{quarter:e} {largest:e}");
        }
    }
}

/// Two bottoms, 12 mm apart.
fn two_bottoms(shift: f64) -> (Vec<f64>, Vec<f64>) {
    let y: Vec<f64> = (0..304).map(|i| 50e-3 * (f64::from(i) / 303.0 - 0.5)).collect();
    let distance =
        y.iter().map(|y| 90e-6 * (((y - shift) / 6e-3).powi(2) - 1.0).powi(2) + y * y / 0.6);
    let distance = distance.collect();
    (y, distance)
}

fn flat_with_shoulders(half_width: f64) -> (Vec<f64>, Vec<f64>) {
    drawn(200, 40e-3, |y| (y.abs() - half_width).max(0.0).powi(2) / 0.6)
}

/// From 1e-12 m on, within one step of the points: no contact is refused, and a parabola's load
/// goes with `δ^1.5`.
#[test]
fn light_contacts_are_ordinary() {
    let shapes = [parabola(0.3, 40e-3, 100), parabola(0.3, 40e-3, 1001), two_bottoms(0.0)];
    for (i, (y, distance)) in shapes.iter().chain([&flat_with_shoulders(8e-3)]).enumerate() {
        let mut scaled = Vec::new();
        for power in 0..14 {
            let approach = 1e-12 * 4_f64.powi(power);
            let contact = ProfileContact { given: Given::Approach(approach), ..pressed(0.46, 0.0) };
            let light = found(y, distance, &contact);
            scaled.push(light.normal_force / approach.powf(1.5));
            let back = found(y, distance, &pressed(0.46, light.normal_force));
            assert!(i > 1 || (back.approach / approach - 1.0).abs() < 2e-3, "{approach} {back:?}");
        }
        for next in &scaled {
            assert!(*next > 0.0, "{scaled:?}");
            assert!(i > 1 || (next / scaled[0] - 1.0).abs() < 1e-6, "{i} {scaled:?}");
        }
        for power in 0..20 {
            found(y, distance, &pressed(0.46, 1e-6 * 4_f64.powi(power)));
        }
    }
}

/// Short smoothing, many strips: never refused.
#[test]
fn refining_never_fails() {
    for count in [4, 8, 16, 32, 64].map(|n| StripCount::from_number(n).unwrap()) {
        for shift in [-2.9e-3, -2e-3, 0.0, 1.5e-3] {
            for smoothing_length in [0.0, 0.2e-3, 1e-3, 4e-3] {
                let (y, distance) = two_bottoms(shift);
                let contact = ProfileContact { smoothing_length, ..pressed(0.46, 80e3) };
                let (patch, _) = built(&y, &distance, &contact, count);
                let load = patch.view().unwrap().normal_force();
                assert_relative_eq!(load, 80e3, max_relative = 4e-15);
            }
        }
    }
}

/// `dN/dδ` is the derivative of what is computed: by approach and by load, for smooth shapes, two
/// zones and shoulders.
#[test]
fn stiffness_is_the_slope_of_the_load() {
    let shapes = [
        parabola(0.3, 40e-3, 200),
        flat_with_shoulders(4e-3),
        two_bottoms(0.0),
        two_bottoms(1.7e-3),
    ];
    for (y, distance) in shapes {
        for approach in [5e-6, 20e-6, 70e-6] {
            let at = |given| found(&y, &distance, &ProfileContact { given, ..pressed(0.46, 0.0) });
            let middle = at(Given::Approach(approach));
            let [low, high] = [-1e-4, 1e-4].map(|x| at(Given::Approach(approach * (1.0 + x))));
            let slope = (high.normal_force - low.normal_force) / (2e-4 * approach);
            assert_relative_eq!(middle.stiffness, slope, max_relative = 1e-6);
            let load = middle.normal_force;
            let [low, high] = [-1e-4, 1e-4].map(|x| at(Given::Load(load * (1.0 + x))));
            let slope = 2e-4 * load / (high.approach - low.approach);
            assert_relative_eq!(at(Given::Load(load)).stiffness, slope, max_relative = 1e-6);
        }
    }
}

/// A second bottom, 12 um higher, begins to touch: the load goes on with its stiffness, step by
/// step.
#[test]
fn a_second_zone_begins_with_nothing() {
    let bottom = |y: f64| ((y - 6.213e-3).powi(2) / 0.3).min((y + 4.787e-3).powi(2) / 0.2 + 12e-6);
    let (y, distance) = drawn(400, 40e-3, bottom);
    let mut last = None::<(f64, Indentation<f64>)>;
    for i in 0..400 {
        let approach = 12.2e-6 + 2.5e-9 * f64::from(i);
        let contact = ProfileContact { given: Given::Approach(approach), ..pressed(0.46, 0.0) };
        let next = found(&y, &distance, &contact);
        if let Some((before, last)) = last {
            let mean = 0.5 * (last.stiffness + next.stiffness);
            let jump = next.normal_force - last.normal_force - mean * (approach - before);
            assert!(jump.abs() < 1e-4 * next.normal_force, "{approach} {next:?}");
        }
        last = Some((approach, next));
    }
}

/// A wavy profile: its radius, and height, length and phase of the waves, with 801 points.
fn wavy(radius: f64, [height, length, phase]: [f64; 3]) -> (Vec<f64>, Vec<f64>) {
    let end = (4.0 * (2.0 * radius * 100e-6_f64).sqrt()).min(0.04);
    drawn(400, end, |y| y * y / (2.0 * radius) + height * (TAU * y / length + phase).sin())
}

fn pressed_by(approach: f64) -> ProfileContact<f64> {
    let given = Given::Approach(approach);
    ProfileContact { given, smoothing_length: 1e-3, ..pressed(0.46, 0.0) }
}

/// Strips begin to touch one after another while wavy bodies approach: the stiffness has no step of
/// a fiftieth.
#[test]
fn a_strip_begins_without_a_step_of_the_stiffness() {
    let mut random = Random::new(461);
    for trial in 0..8 {
        let wave =
            [random.between(1e-6, 4e-6), random.between(3e-3, 8e-3), random.between(0.0, TAU)];
        let (y, distance) = wavy(1.0, wave);
        let of = |approach: f64| found(&y, &distance, &pressed_by(approach)).stiffness;
        let jump = largest_jump(of, [10e-6, 60e-6], 400);
        println!("{trial}: {jump:e}");
        assert!(jump < 0.02, "{trial}: {jump}");
    }
}

/// Waves of 1 to 30 um on wide contacts: the load does not fall while the bodies approach, or there
/// are more lobes than strips can tell apart, which the warning says.
#[test]
fn the_load_of_wavy_bodies_does_not_fall() {
    let mut random = Random::new(462);
    let (mut falls, mut steps, mut rough) = (0, 0, 0);
    for trial in 0..120 {
        let wave = [
            random.log_between(1e-6, 30e-6),
            random.log_between(2e-3, 16e-3),
            random.between(0.0, TAU),
        ];
        let (y, distance) = wavy([0.3, 1.0, 9.0][trial % 3], wave);
        let mut last = 0.0;
        for step in 1..=30 {
            let next = found(&y, &distance, &pressed_by(3e-6 * f64::from(step)));
            if next.warning == Warning::Rough {
                (rough, last) = (rough + 1, 0.0);
                continue;
            }
            falls += usize::from(next.normal_force < last * (1.0 - 1e-12));
            (steps, last) = (steps + 1, next.normal_force);
        }
    }
    println!("{falls} of {steps}, {rough} rough");
    assert!(falls == 0 && rough > 0 && 10 * rough < steps, "{falls} of {steps}, {rough} rough");
}

/// Sixteen lobes on eight cells are rough, one or three are not.
#[test]
fn more_lobes_than_strips_resolve_are_rough() {
    for (length, count, warning) in [
        (2.4e-3, StripCount::Sixteen, Warning::Rough),
        (2.4e-3, StripCount::Four, Warning::Rough),
        (16e-3, StripCount::Four, Warning::None),
        (16e-3, StripCount::SixtyFour, Warning::None),
    ] {
        let (y, distance) = wavy(9.0, [20e-6, length, 0.3]);
        let (_, found) = built(&y, &distance, &pressed_by(20e-6), count);
        assert_eq!(found.warning, warning, "{length} {count:?}");
    }
}

/// A flat bottom that moves sideways under the points.
#[test]
fn no_sample_anchors_anything() {
    let y: Vec<f64> = (0..304).map(|i| 50e-3 * (f64::from(i) / 303.0 - 0.5)).collect();
    let at = |shift: f64| {
        let shape = |y: &f64| 1e-4 * ((y - shift) / 6e-3).powi(6) + 1.23e-3 * y;
        let distance: Vec<f64> = y.iter().map(shape).collect();
        found(&y, &distance, &pressed(0.46, 109e3)).approach
    };
    let values: Vec<f64> = (0..60).map(|i| at(-2.3e-3 + 10e-6 * f64::from(i))).collect();
    for three in values.windows(3) {
        let bend = (three[2] - 2.0 * three[1] + three[0]).abs();
        assert!(bend < 1.5e-4 * three[1], "{three:?}");
    }
}

/// Mirrored, and with a constant added, rough shapes give the same answer, or are too rough.
#[test]
fn rough_shapes_in_the_mirror() {
    let (mut random, mut definite) = (Random::new(712), 0);
    for _ in 0..100 {
        let y: Vec<f64> = (-90..=90).map(|i| 0.2e-3 * f64::from(i)).collect();
        let rough = |random: &mut Random| random.between(0.0, 20e-6);
        let distance: Vec<f64> = y.iter().map(|y| y * y / 0.5 + rough(&mut random)).collect();
        let contact = pressed(0.46, 10_f64.powf(random.between(0.0, 5.0)));
        let wanted = found(&y, &distance, &contact);
        // (too rough for a definite answer)
        if wanted.warning == Warning::Rough {
            continue;
        }
        definite += 1;
        let mirrored: Vec<f64> = distance.iter().rev().copied().collect();
        let lifted: Vec<f64> = distance.iter().map(|h| h + 1e-3).collect();
        for (other, allowed) in [(mirrored, 1e-9), (lifted, 1e-7)] {
            let other = found(&y, &other, &contact);
            assert_relative_eq!(other.approach, wanted.approach, max_relative = allowed);
            assert_relative_eq!(
                other.peak_pressure,
                wanted.peak_pressure,
                max_relative = 100.0 * allowed
            );
        }
    }
    assert!(definite > 50, "{definite}");
}

/// Real wheels on real rails against CONTACT: peak pressure, area, force, moment; zones that yaw
/// shifts along `x`, about the origin of the profile.
#[test]
fn real_patches_are_those_of_contact() {
    let [mut pressures, mut areas, mut forces, mut moments] = [const { Vec::new() }; 4];
    for case in real() {
        let (patch, found) = case.patch(SIXTEEN);
        pressures.push((found.peak_pressure / case.peak_pressure - 1.0).abs());
        areas.push((patch.view().unwrap().area() / case.area - 1.0).abs());
        let errors = case.errors(&patch, Model::Strip);
        if case.zones > 1 {
            assert!(errors.moment.iter().all(|error| *error < 0.05), "{} {errors:?}", case.name);
        }
        forces.extend(errors.force);
        moments.extend(errors.moment);
    }
    let [pressure, area, force, moment] =
        [&pressures, &areas, &forces, &moments].map(|errors| statistics(errors));
    println!("pressure {pressure:.4?} area {area:.4?} force {force:.4?} moment {moment:.4?}");
    assert!(pressure[0] < 0.015 && pressure[1] < 0.05, "{pressure:?}");
    assert!(area[0] < 0.03 && area[1] < 0.08, "{area:?}");
    assert!(force[0] < 0.02 && force[1] < 0.05, "{force:?}");
    assert!(moment[1] < 0.05, "{moment:?}");
}

#[test]
fn radii_of_the_profile_replace_that_of_the_contact() {
    let (y, distance) = parabola(0.3, 10e-3, 20);
    let radii: Vec<f64> = y.iter().map(|y| 0.46 + y).collect();
    let profile = Profile::new(&y, &distance).unwrap().with_rolling_radius(&radii).unwrap();
    for given in [Given::Load(80e3), Given::Approach(9e-5)] {
        let solve = |radius: f64| {
            let contact = ProfileContact { given, ..pressed(radius, 1.0) };
            let (patch, found) = Patch::<f64>::from_profile(&profile, &contact, SIXTEEN).unwrap();
            (patch.strips, found)
        };
        let expected = solve(0.46);
        assert!(expected.1.normal_force > 7e4, "{expected:?}");
        for radius in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-300, 1e300] {
            assert_eq!(solve(radius), expected, "{radius}");
        }
    }
}
