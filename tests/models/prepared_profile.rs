//! Prepared profiles: whatever the order, density, scatter and size of the points, the profile is
//! whole, and its points are one step apart.

use crate::prelude::*;

const NAMES: [&str; 10] = [
    "avgHR", "avglow", "avgwhl", "car7216", "rail288", "s1002", "siteb", "uic60", "whl288",
    "wornhm",
];

type Points = Vec<[f64; 2]>;

fn prepared(
    points: &[[f64; 2]], step: f64, smoothing: f64,
) -> Result<Box<PreparedProfile<f64>>, Error> {
    let (y, z): (Vec<f64>, Vec<f64>) = points.iter().map(|&[y, z]| (y, z)).unzip();
    let mut surface = zeroed::<PreparedProfile<f64>>();
    surface.prepare(&y, &z, step, smoothing).map(|_| surface)
}

fn profile(name: &str) -> Points {
    let [y, z] = points(name);
    y.into_iter().zip(z).map(|(y, z)| [y, z]).collect()
}

fn nodes(surface: &PreparedProfile<f64>) -> Points {
    let count = surface.count as usize;
    (0..count).map(|k| [surface.y[k], surface.z[k]]).collect()
}

fn distance([y, z]: [f64; 2], [v, w]: [f64; 2]) -> f64 {
    (v - y).hypot(w - z)
}

/// Distance of a point from a polyline.
fn from_line(line: &[[f64; 2]], point: [f64; 2]) -> f64 {
    let each = line.windows(2).map(|ends| {
        let [from, to] = [ends[0], ends[1]];
        let along = [to[0] - from[0], to[1] - from[1]];
        let square = along[0] * along[0] + along[1] * along[1];
        let dot = (point[0] - from[0]) * along[0] + (point[1] - from[1]) * along[1];
        let share = (dot / square.max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        distance(point, [from[0] + share * along[0], from[1] + share * along[1]])
    });
    each.fold(f64::INFINITY, f64::min)
}

/// The curve of a surface at eight places between its points.
fn curve(surface: &PreparedProfile<f64>) -> Points {
    let PreparedProfile { y, z, cosine, sine, step, .. } = surface;
    let place = |i: usize| {
        let (k, u) = (i / 8, (i % 8) as f64 / 8.0);
        let cubic = |value: &[f64], slope: &[f64]| {
            let rise = value[k + 1] - value[k];
            let (from, to) = (slope[k] * step, slope[k + 1] * step);
            let (square, cube) = (3.0 * rise - 2.0 * from - to, from + to - 2.0 * rise);
            value[k] + u * (from + u * (square + u * cube))
        };
        [cubic(&y[..], &cosine[..]), cubic(&z[..], &sine[..])]
    };
    let count = surface.count as usize;
    let mut places: Points = (0..8 * (count - 1)).map(place).collect();
    places.push([y[count - 1], z[count - 1]]);
    places
}

/// The largest distance of two curves from each other: of the points of each from the other.
fn apart(one: &PreparedProfile<f64>, other: &PreparedProfile<f64>) -> f64 {
    let largest = |of: &PreparedProfile<f64>, from: &PreparedProfile<f64>| {
        let (line, nodes) = (curve(from), nodes(of));
        let near = |k: usize| {
            let middle = k * (line.len() - 1) / (nodes.len() - 1);
            &line[middle.saturating_sub(64)..(middle + 65).min(line.len())]
        };
        let each = nodes.iter().enumerate().map(|(k, &point)| from_line(near(k), point));
        each.fold(0.0, f64::max)
    };
    largest(one, other).max(largest(other, one))
}

/// Largest difference of the distances of neighbours from the step, as a share.
fn unequal(surface: &PreparedProfile<f64>) -> f64 {
    let steps =
        nodes(surface).windows(2).map(|ends| distance(ends[0], ends[1])).collect::<Vec<_>>();
    steps.iter().map(|step| (step / surface.step - 1.0).abs()).fold(0.0, f64::max)
}

fn jitter(random: &mut Random, [y, z]: [f64; 2], size: f64) -> [f64; 2] {
    [y + random.between(-size, size), z + random.between(-size, size)]
}

/// Points between those of a profile, in its order, at equal shares.
fn dense(profile: &[[f64; 2]], times: usize) -> Points {
    let count = (profile.len() - 1) * times;
    let at = |i: usize| {
        let (k, u) = (i / times, (i % times) as f64 / times as f64);
        let [[y, z], [v, w]] = [profile[k], profile[(k + 1).min(profile.len() - 1)]];
        [y + u * (v - y), z + u * (w - z)]
    };
    (0..=count).map(at).collect()
}

/// A profile with a disorder of one kind, and the scatter of its points.
fn disorder(kind: usize, profile: &[[f64; 2]], random: &mut Random) -> (Points, f64) {
    let mut points = profile.to_vec();
    let count = points.len();
    let scan = |random: &mut Random, most: f64| {
        let length = random.log_between(1.0, most) as usize;
        let from = (random.unit() * (count - length - 1) as f64) as usize;
        from..from + length + 1
    };
    match kind {
        // some points are scanned twice or three times
        0 => {
            let range = scan(random, 60.0);
            for _ in 0..1 + random.bits() % 2 {
                let again: Points =
                    profile[range.clone()].iter().map(|&p| jitter(random, p, 2e-6)).collect();
                points.splice(range.end..range.end, again);
            }
            (points, 3e-6)
        }
        // one point lies some millimetres behind its place, on the profile
        1 => {
            let k = 1 + (random.unit() * (count - 2) as f64) as usize;
            let mut rest = random.log_between(1e-5, 3e-3);
            let mut from = k;
            while from > 0 && rest > distance(profile[from], profile[from - 1]) {
                rest -= distance(profile[from], profile[from - 1]);
                from -= 1;
            }
            if from > 0 {
                let [to, at] = [profile[from - 1], profile[from]];
                let share = rest / distance(to, at);
                let back = [at[0] + share * (to[0] - at[0]), at[1] + share * (to[1] - at[1])];
                points[k] = jitter(random, back, 2e-6);
            }
            (points, 3e-6)
        }
        // all points scatter in both axes
        2 => {
            let size = random.log_between(1e-6, 5e-5);
            points.iter_mut().for_each(|point| *point = jitter(random, *point, size));
            (points, size * 2_f64.sqrt())
        }
        // many points, which scatter
        3 => {
            let times = random.log_between(2.0, 40.0) as usize;
            let size = random.log_between(1e-7, 5e-6);
            let points = dense(profile, times);
            (points.into_iter().map(|p| jitter(random, p, size)).collect(), size * 2_f64.sqrt())
        }
        // the whole profile is scanned there and back
        _ => {
            let back: Points = profile.iter().rev().map(|&p| jitter(random, p, 2e-6)).collect();
            points.extend(back);
            (points, 3e-6)
        }
    }
}

#[test]
fn disorder_scatter_and_density_leave_the_profile_whole() {
    for (name, seed) in NAMES.iter().zip(1_u64..) {
        let profile = profile(name);
        let smoothings = [0.0, 1e-3, 3e-3];
        let clean = smoothings.map(|smoothing| prepared(&profile, 0.0, smoothing).unwrap());
        for (kind, case) in (0..5).flat_map(|kind| (0..6_u64).map(move |case| (kind, case))) {
            let seed = 1000 * seed + 100 * kind as u64 + case;
            let mut random = Random::new(seed);
            let (mut points, scatter) = disorder(kind, &profile, &mut random);
            let which = (random.bits() % 3) as usize;
            if random.bits().is_multiple_of(2) {
                points.reverse();
            }
            let surface = prepared(&points, 0.0, smoothings[which]).unwrap();
            let (apart, unequal) = (apart(&surface, &clean[which]), unequal(&surface));
            let case = format!("{name}, kind {kind}, smoothing {which}, seed {seed}");
            // interpolation between points that scatter swings out by a third more
            assert!(apart < 1.34 * scatter + 1e-5, "{case}: {apart} m apart, scatter {scatter}");
            assert!(unequal < 0.03, "{case}: steps differ by {unequal}");
            assert!(surface.y[0] < surface.y[surface.count as usize - 1], "{case}");
        }
    }
}

/// Without smoothing the profile goes through all points that are a fifth of a step or more apart.
#[test]
fn a_profile_in_order_goes_through_its_points() {
    for name in NAMES {
        let profile = profile(name);
        let surface = prepared(&profile, 0.0, 0.0).unwrap();
        let line = curve(&surface);
        let far = profile.iter().map(|&point| from_line(&line, point)).fold(0.0, f64::max);
        assert!(far < 2e-5 && unequal(&surface) < 1e-5, "{name}: {far} m, {}", unequal(&surface));
        let ends = [profile[0], profile[profile.len() - 1]];
        for end in ends {
            let nodes = nodes(&surface);
            let off = distance(nodes[0], end).min(distance(nodes[nodes.len() - 1], end));
            assert!(off < 1e-6, "{name}: {off}");
        }
    }
}

#[test]
fn a_profile_of_any_size_has_the_same_shape() {
    for name in NAMES {
        let profile = profile(name);
        let surface = prepared(&profile, 0.0, 2e-3).unwrap();
        for scale in [20.0, 0.2, 1.0 / 87.0, 1e-4] {
            let scaled: Points = profile.iter().map(|[y, z]| [y * scale, z * scale]).collect();
            let other = prepared(&scaled, 0.0, 2e-3 * scale).unwrap();
            assert_eq!(other.count, surface.count, "{name}, {scale}");
            let pairs = nodes(&other).into_iter().zip(nodes(&surface));
            let off = pairs.map(|([y, z], own)| distance([y / scale, z / scale], own));
            let off = off.fold(0.0, f64::max);
            assert!(off < 1e-9, "{name}, {scale}: {off}");
        }
    }
}

#[test]
fn many_points_are_averaged() {
    let profile = dense(&profile("uic60"), 50);
    let clean = prepared(&profile, 0.0, 0.0).unwrap();
    let mut random = Random::new(5);
    let scattered: Points = profile.iter().map(|&p| jitter(&mut random, p, 20e-6)).collect();
    let surface = prepared(&scattered, 0.0, 0.0).unwrap();
    let line = curve(&clean);
    let off: Vec<f64> = nodes(&surface)[2..509].iter().map(|&p| from_line(&line, p)).collect();
    let mean = off.iter().sum::<f64>() / off.len() as f64;
    // uniform scatter of 20 um: 12 um rms, 46 points in each step
    assert!(mean < 3e-6, "{mean}");
}

/// Points at any distances stand for the length between them: a dense half has no more weight.
#[test]
fn smoothing_weighs_points_with_their_spacing() {
    let wave = |y: f64| 2e-5 * (y * 900.0).sin();
    let even: Points = (0..400).map(|i| f64::from(i) * 1e-4).map(|y| [y, wave(y)]).collect();
    // between every other pair of points there are two more
    let uneven: Points = even
        .iter()
        .enumerate()
        .flat_map(|(i, &[y, z])| {
            let more = if i % 2 == 0 { vec![0.0, 0.25e-4, 0.5e-4] } else { vec![0.0] };
            more.into_iter().map(move |d| if d == 0.0 { [y, z] } else { [y + d, wave(y + d)] })
        })
        .collect();
    let [even, uneven] = [even, uneven].map(|points| prepared(&points, 0.0, 3e-3).unwrap());
    let apart = apart(&even, &uneven);
    assert!(apart < 1.5e-8, "{apart}");
}

/// A step of more than a third of the length leads to three chords of equal length, also where the
/// ends are near to each other; a step that needs too many is refused.
#[test]
fn chords_are_equal_for_every_step() {
    let arc: Points = (0..100)
        .map(|i| f64::from(i) * 0.055)
        .map(|angle| [-0.02 * angle.cos(), 0.02 * angle.sin()])
        .collect();
    for (step, count) in [(1.0, 4), (22e-3, 6), (5e-3, 23)] {
        let surface = prepared(&arc, step, 0.0).unwrap();
        assert_eq!(surface.count, count, "{step}");
        assert!(unequal(&surface) < 1e-4, "{step}: {}", unequal(&surface));
    }
    assert_eq!(prepared(&arc, 0.2e-3, 0.0).err(), Some(Error::Capacity));
    // a right angle
    let corner: Points =
        (0..300)
            .map(|i| {
                if i < 150 {
                    [f64::from(i) * 1e-4, 0.0]
                } else {
                    [149e-4, f64::from(i - 149) * 1e-4]
                }
            })
            .collect();
    let surface = prepared(&corner, 0.0, 0.0).unwrap();
    assert!(unequal(&surface) < 1e-4, "{}", unequal(&surface));
    let far = corner.iter().map(|&p| from_line(&nodes(&surface), p)).fold(0.0, f64::max);
    assert!(far < 0.5 * surface.step, "{far}");
}

#[test]
fn only_points_without_order_are_refused() {
    let mut random = Random::new(9);
    let mut points = profile("s1002");
    let first = [points[0]; 3];
    points.splice(0..0, first);
    assert!(prepared(&points, 0.0, 0.0).is_ok());
    for i in (1..points.len()).rev() {
        points.swap(i, (random.unit() * (i + 1) as f64) as usize);
    }
    let (y, z): (Vec<f64>, Vec<f64>) = points.iter().map(|&[y, z]| (y, z)).unzip();
    let mut surface = zeroed::<PreparedProfile<f64>>();
    surface.step = 3.0;
    let before = surface.clone();
    assert_eq!(surface.prepare(&y, &z, 0.0, 0.0), Err(Error::Scatter));
    assert!(surface == before);
    let line = [[0.0, 0.0], [0.01, 0.001], [0.01, 0.001], [0.02, 0.0]];
    assert!(prepared(&line, 0.0, 0.0).is_ok());
    // a point beside the profile, with which the line of the others would begin
    let arc = (0..24).map(|i| f64::from(i) * 1.8e-3 - 0.0207).map(|y| [y, y * y / 0.15]);
    let points: Points = [[6.25e-4, 2.9e-3], [-0.0189, 0.0]].into_iter().chain(arc).collect();
    let refused = prepared(&points, 0.0, 0.0);
    assert!(matches!(refused, Err(Error::Scatter)), "{refused:?}");
}

/// A profile with a point that is moved along it, and across.
fn with_stray(profile: &[[f64; 2]], k: usize, [along, across]: [f64; 2]) -> Points {
    let mut points = profile.to_vec();
    let [from, to] = [profile[k.max(1) - 1], profile[k.max(1)]];
    let [cosine, sine] = [0, 1].map(|i| (to[i] - from[i]) / distance(from, to));
    points[k][0] += along * cosine - across * sine;
    points[k][1] += along * sine + across * cosine;
    points
}

/// Strays, one or two, cost neither an end of a profile nor the equality of its steps.
#[test]
fn strays_leave_the_profile_whole() {
    let mut cases: Vec<(&str, bool, [usize; 2], [f64; 2])> = Vec::new();
    for k in [4, 17, 18, 19, 25, 134, 552, 561] {
        cases.extend([2e-3, 3e-3, 4e-3].map(|back| ("avglow", false, [k; 2], [-back, 0.0])));
        cases.push(("avglow", false, [k; 2], [4e-3, 0.0]));
    }
    for (name, k, across) in [
        ("avglow", 417, 2e-4),
        ("avglow", 685, 2e-4),
        ("avglow", 687, 2e-4),
        ("s1002", 392, 1e-3),
        ("en_wheel_h", 316, 1e-3),
        ("rail288", 269, 5e-4),
        ("uic60", 122, 2e-4),
        ("siteb", 127, 5e-4),
        ("wornhm", 637, 2e-4),
        ("en_rail", 334, 2e-4),
    ] {
        for backward in [false, true] {
            cases.extend([-across, across].map(|by| (name, backward, [k; 2], [0.0, by])));
        }
    }
    for (name, seed) in NAMES.iter().zip(1_u64..) {
        let mut random = Random::new(seed);
        let count = profile(name).len();
        for _ in 0..12 {
            let strays = [8, 8].map(|_| 8 + (random.unit() * (count - 16) as f64) as usize);
            let along = random.between(-5e-3, 5e-3);
            cases.push((name, random.bits().is_multiple_of(2), strays, [along, 0.0]));
            let across = random.log_between(5e-5, 2e-3);
            cases.push((name, random.bits().is_multiple_of(2), strays, [0.0, across]));
        }
    }
    for (name, backward, strays, moved) in cases {
        let clean = profile(name);
        let mut points = with_stray(&clean, strays[0], moved);
        if strays[1] != strays[0] {
            points = with_stray(&points, strays[1], moved);
        }
        let off = strays.map(|k| from_line(&clean, points[k])).into_iter().fold(0.0, f64::max);
        if backward {
            points.reverse();
        }
        let surface = prepared(&points, 0.0, 0.0).unwrap();
        let found = nodes(&surface);
        let case = format!("{name}, backward {backward}, points {strays:?}, moved by {moved:?}");
        let others = clean.iter().enumerate().filter(|(k, _)| !strays.contains(k));
        let lost = others.map(|(_, &point)| from_line(&found, point)).fold(0.0, f64::max);
        let made = found.iter().map(|&point| from_line(&clean, point)).fold(0.0, f64::max);
        let bound = 6e-5 + 1.1 * off;
        assert!(lost < bound && made < bound, "{case}: {lost} m lost, {made} m made, off by {off}");
        assert!(unequal(&surface) < 0.2, "{case}: steps differ by {}", unequal(&surface));
    }
}
