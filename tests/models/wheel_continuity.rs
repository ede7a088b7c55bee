//! A wheel over real and drawn profiles: nothing jumps, contacts begin without load, no overlap is
//! lost, and the height for a load does not depend on where the search begins.

use crate::prelude::*;

/// Profiles that were drawn or measured, and angles by which rails are turned \[rad\].
pub(crate) const RAILS: [(&str, f64); 6] = [
    ("uic60", 0.025),
    ("rail288", 0.0),
    ("avgHR", 0.0),
    ("siteb", 0.025),
    ("wornhm", 0.0),
    ("avglow", 0.0),
];
pub(crate) const WHEELS: [&str; 4] = ["s1002", "whl288", "avgwhl", "car7216"];
const VELOCITY: Velocity<f64> = Velocity { lateral: 0.05, ..ROLLING };

/// A profile of the data, turned, with noise of a size across.
fn measured(name: &str, turn: f64, noise: f64, random: &mut Random) -> Box<PreparedProfile<f64>> {
    let [y, z] = points(name);
    let (sine, cosine) = turn.sin_cos();
    let (y, z): (Vec<f64>, Vec<f64>) = y
        .iter()
        .zip(&z)
        .map(|(y, z)| (*y, z + noise * random.between(-1.0, 1.0)))
        .map(|(y, z)| (y * cosine - z * sine, y * sine + z * cosine))
        .unzip();
    prepared(&y, &z)
}

/// A profile drawn between two places.
fn drawn(ends: f64, count: usize, height: impl Fn(f64) -> f64) -> Box<PreparedProfile<f64>> {
    let y: Vec<f64> =
        (0..count).map(|i| -ends + 2.0 * ends * i as f64 / (count - 1) as f64).collect();
    let z: Vec<f64> = y.iter().map(|y| height(*y)).collect();
    prepared(&y, &z)
}

/// A wheel over a rail.
struct Over<'a> {
    rail: &'a PreparedProfile<f64>,
    wheel: &'a PreparedProfile<f64>,
    pair: WheelPair<f64>,
    strips: StripCount,
    position: Position<f64>,
}

/// What is varied.
const NAMES: [&str; 5] = ["lateral", "vertical", "yaw", "roll", "smoothing length"];

impl Over<'_> {
    fn scene(&self) -> Scene<'_, f64> {
        let Self { rail, wheel, pair, strips, .. } = self;
        Scene { rail, wheel, pair, strips: *strips, law: STRIP, table: None }
    }

    fn solve(&self, memory: &mut Workspace<f64>) -> Option<Wrench<f64>> {
        let found =
            self.scene().solve(&BodyState { position: self.position, velocity: VELOCITY }, memory);
        found.inspect_err(|error| println!("{:?}: {error}", self.position)).ok()
    }

    fn load(&self, memory: &mut Workspace<f64>) -> Option<f64> {
        self.solve(memory).map(|wrench| wrench.normal_force)
    }

    fn varied(&mut self, which: usize) -> &mut f64 {
        let Self { position: Position { lateral, vertical, yaw, roll }, pair, .. } = self;
        [lateral, vertical, yaw, roll, &mut pair.smoothing_length][which]
    }

    fn at(&mut self, which: usize, value: f64, memory: &mut Workspace<f64>) -> Option<[f64; 7]> {
        *self.varied(which) = value;
        let wrench = self.solve(memory)?;
        let [x, y, z, roll, pitch, yaw] = wrench.members();
        let arm = self.pair.wheel_radius;
        Some([x, y, z, roll / arm, pitch / arm, yaw / arm, wrench.normal_force])
    }

    /// Lowers or lifts the wheel to where it touches: the last vertical position without load and
    /// the first with load, which are neighbours.
    fn first_touch(&mut self, memory: &mut Workspace<f64>) -> Option<[f64; 2]> {
        let height = self.scene().height_for_load(&self.position, 100.0, None, memory);
        let (height, _) = height.inspect_err(|error| println!("height: {error}")).ok()?;
        let (mut free, mut loaded) = (height - 1e-3, height);
        self.position.vertical = free;
        if self.load(memory)? > 0.0 {
            return None;
        }
        loop {
            let middle = free + 0.5 * (loaded - free);
            if middle <= free || middle >= loaded {
                return Some([free, loaded]);
            }
            self.position.vertical = middle;
            *(if self.load(memory)? > 0.0 { &mut loaded } else { &mut free }) = middle;
        }
    }
}

/// A wheel of 0.46 m with 16 strips.
fn over<'a>(
    rail: &'a PreparedProfile<f64>, wheel: &'a PreparedProfile<f64>, smoothing_length: f64,
    position: Position<f64>,
) -> Over<'a> {
    let pair = WheelPair { smoothing_length, ..steel(0.46) };
    Over { rail, wheel, pair, strips: StripCount::Sixteen, position }
}

fn any_place(random: &mut Random) -> Position<f64> {
    let lateral = random.between(-15e-3, 12e-3);
    let [yaw, roll] = [0; 2].map(|_| random.between(-0.02, 0.02));
    placed([lateral, 0.0, yaw, roll])
}

fn distance(one: [f64; 7], other: [f64; 7]) -> f64 {
    one.into_iter().zip(other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The largest change between neighbouring numbers, over the load: of the places where the wrench
/// bends most over a range, each followed by halves to one rounding.
fn largest_jump(over: &mut Over, which: usize, from: f64, to: f64, steps: usize) -> (f64, f64) {
    let mut memory = zeroed::<Workspace<f64>>();
    let place = |k: usize| from + (to - from) * k as f64 / steps as f64;
    let found: Vec<_> = (0..=steps).map(|k| over.at(which, place(k), &mut memory)).collect();
    let mut bends: Vec<(f64, usize)> = (1..steps - 1)
        .filter_map(|k| {
            let [a, b, c, d] = [k - 1, k, k + 1, k + 2].map(|k| found.get(k).copied().flatten());
            let (a, b, c, d) = (a?, b?, c?, d?);
            let bend = |before: [f64; 2], own: [f64; 2], after: [f64; 2]| {
                let [before, own, after] = [before, own, after].map(|[from, to]| to - from);
                (own - before).abs().min((own - after).abs())
            };
            let most = (0..7).map(|i| bend([a[i], b[i]], [b[i], c[i]], [c[i], d[i]]));
            Some((most.fold(0.0, f64::max), k))
        })
        .collect();
    bends.sort_by(|one, other| other.0.total_cmp(&one.0));
    let mut worst = (0.0, 0.0);
    for &(_, k) in bends.iter().take(4) {
        let (ends, [Some(below), Some(above)]) = ([k, k + 1].map(place), [found[k], found[k + 1]])
        else {
            continue;
        };
        let at = |middle| over.at(which, middle, &mut memory);
        let (low, [below, above]) = steepest(ends, [below, above], 0.0, at, distance);
        let jump = distance(below, above) / below[6].max(above[6]).max(1e-3);
        if jump > worst.0 {
            worst = (jump, low);
        }
    }
    worst
}

/// Rail and wheels of EN 15302, which rough profiles of others touch in many zones.
const EN_RAILS: [(&str, f64); 2] = [("en_rail", 0.0), ("wornhm", 0.0)];
const EN_WHEELS: [&str; 2] = ["en_wheel_a", "en_wheel_h"];

/// Random wheels on real profiles, with and without noise of 3 and 5 um, smoothed or not, with any
/// number of strips: between neighbouring numbers no component of the wrench changes by more than
/// rounding.
#[test]
fn nothing_jumps_by_more_than_rounding() {
    let all = [(1, 0.0, 7, &RAILS[..], &WHEELS[..]), (2, 3e-6, 7, &RAILS, &WHEELS)];
    let noisy = (3, 5e-6, 5, &EN_RAILS[..], &EN_WHEELS[..]);
    for (seed, noise, wheels, names, wheel_names) in all.into_iter().chain([noisy]) {
        let mut random = Random::new(seed);
        let rails = names.iter().map(|(name, turn)| measured(name, *turn, noise, &mut random));
        let rails: Vec<_> = rails.collect();
        let wheels_of = wheel_names.iter().map(|name| measured(name, 0.0, noise, &mut random));
        let wheels_of: Vec<_> = wheels_of.collect();
        let pick = |random: &mut Random, count: usize| (random.unit() * count as f64) as usize;
        for trial in 0..wheels {
            let rail = pick(&mut random, rails.len());
            let wheel = pick(&mut random, wheels_of.len());
            let smoothing_length = [0.0, 0.0, 1e-3, 2e-3, 4e-3][pick(&mut random, 5)];
            let strips = [4, 8, 16, 16, 32, 64][pick(&mut random, 6)];
            let position = any_place(&mut random);
            let mut over = over(&rails[rail], &wheels_of[wheel], smoothing_length, position);
            over.strips = StripCount::from_number(strips).unwrap();
            let load = random.log_between(10.0, 2e5);
            let mut memory = zeroed::<Workspace<f64>>();
            let height = over.scene().height_for_load(&over.position, load, None, &mut memory);
            let Ok((height, _)) = height else { continue };
            over.position.vertical = height;
            let (position, pair) = (over.position, over.pair);
            for (which, span) in [200e-6, 40e-6, 2e-3, 2e-3, 1e-3].into_iter().enumerate() {
                (over.position, over.pair) = (position, pair);
                let middle = *over.varied(which);
                let from = middle - 0.5 * span;
                let from = if which == 4 { from.max(1e-5) } else { from };
                let (jump, place) = largest_jump(&mut over, which, from, from + span, 60);
                assert!(
                    jump < 1e-8,
                    "seed {seed}, trial {trial}: {jump:e} of N over {} at {place:e}: {} on {}, \
                     {position:?}, smoothing {smoothing_length}, strips {strips}",
                    NAMES[which],
                    wheel_names[wheel],
                    names[rail].0,
                );
            }
        }
    }
}

/// Wheels on profiles with noise of 20 um where a crest that hardly rises out of a zone divides it,
/// and where a sliver begins beside a contact.
#[test]
fn divided_zones_and_slivers_do_not_jump() {
    let noisy =
        |name: &str, number: u64| measured(name, 0.0, 20e-6, &mut Random::new(number * 7919 + 13));
    let cases = [
        (
            ("rail288", 17, "whl288", 67),
            (0.463_404_564_421_890_9, 2e-3, StripCount::Four),
            [
                0.005_717_441_677_266_712,
                -0.026_593_389_411_156_39,
                0.003_216_204_696_054_069,
                0.000_794_094_270_607_573_2,
            ],
        ),
        (
            ("avglow", 21, "en_wheel_a", 70),
            (0.46, 2e-3, StripCount::Eight),
            [
                0.000_348_075_915_699_882,
                0.000_355_929_853_450_008_2,
                0.002_272_889_811_961_325,
                0.013_875_667_545_049_476,
            ],
        ),
        (
            ("avglow", 109, "s1002", 154),
            (0.46, 0.0, StripCount::Sixteen),
            [
                0.010_748_902_050_895_748,
                0.000_275_806_826_650_278_25,
                -0.041_850_267_484_493_92,
                0.018_098_328_989_958_75,
            ],
        ),
    ];
    for ((rail, seed, wheel, other), (radius, smoothing_length, strips), place) in cases {
        let (on, above) = (noisy(rail, seed), noisy(wheel, other));
        let mut over = over(&on, &above, smoothing_length, placed(place));
        (over.pair.wheel_radius, over.strips) = (radius, strips);
        let [lateral, ..] = place;
        let (jump, at) = largest_jump(&mut over, 0, lateral - 1e-6, lateral + 1e-6, 40);
        assert!(jump < 1e-8, "{jump:e} of N at {at:e}: {wheel} on {rail}");
    }
}

/// A wheel that is lowered by 1 pm from where it touches carries less than 1 mN.
#[test]
fn contacts_begin_without_load() {
    let mut random = Random::new(3);
    let rails = RAILS.map(|(name, turn)| measured(name, turn, 0.0, &mut random));
    let wheels = WHEELS.map(|name| measured(name, 0.0, 0.0, &mut random));
    let mut memory = zeroed::<Workspace<f64>>();
    let mut touches = 0;
    for trial in 0..60 {
        let smoothing_length = [0.0, 2e-3, 4e-3][trial % 3];
        let (rail, wheel) = (&rails[trial % 6], &wheels[trial / 6 % 4]);
        let mut over = over(rail, wheel, smoothing_length, any_place(&mut random));
        let Some([free, loaded]) = over.first_touch(&mut memory) else { continue };
        touches += 1;
        for (vertical, allowed) in [(free, 0.0), (loaded, 1e-3), (loaded + 1e-12, 1e-3)] {
            over.position.vertical = vertical;
            let wrench = over.solve(&mut memory).unwrap();
            let load = wrench.normal_force;
            assert!(load <= allowed, "{trial}: {load} N at {:?}", over.position);
            // what counts as a contact carries something
            assert_eq!(wrench.contacts > 0, load > 0.0, "{trial}");
        }
    }
    assert!(touches > 30, "{touches}");
}

/// A third facet of a rail begins to touch between two others, or parts from one of them: the
/// number of contacts changes, and the wrench does not.
#[test]
fn a_zone_without_depth_changes_nothing() {
    let wheel = drawn(0.06, 600, |_| 0.0);
    let mut memory = zeroed::<Workspace<f64>>();
    let mut changes = 0;
    for (wave, hollow) in [(5e-3, 4e-6), (5e-3, 15e-6), (6e-3, 9e-6), (7e-3, 4e-6)] {
        let rail = drawn(0.03, 600, |y| {
            let beyond = (y.abs() - 1.2 * wave).max(0.0);
            let facets = 10e-6 * (2.0 * PI * y / wave).cos();
            beyond * beyond / 0.2 - hollow * (y / wave).powi(2) - facets
        });
        let mut over = over(&rail, &wheel, 0.0, placed([2e-5, 0.0, 2e-3, 0.0]));
        let [_, loaded] = over.first_touch(&mut memory).unwrap();
        let mut apart = |over: &mut Over, vertical: f64| {
            let found = over.at(1, vertical, &mut memory).unwrap();
            (memory.count, found)
        };
        let mut last = apart(&mut over, loaded);
        for k in 1..200 {
            let [high, low] = [k - 1, k].map(|k| loaded + 1e-7 * f64::from(k));
            let next = apart(&mut over, low);
            assert!(next.1[6] > last.1[6], "the load falls: {wave} {hollow} {low}");
            if next.0 != last.0 {
                let (mut before, mut after) = (last.1, next.1);
                let [high, _] = bisect([high, low], 0.0, |middle| {
                    let own = apart(&mut over, middle);
                    *(if own.0 == last.0 { &mut before } else { &mut after }) = own.1;
                    own.0 == last.0
                });
                changes += 1;
                let jump = distance(before, after) / before[6];
                assert!(jump < 1e-9, "{wave} {hollow} {high}: {jump}");
            }
            last = next;
        }
    }
    assert!(changes >= 4, "{changes}");
}

/// A ground rail, whose facets of 7 mm have edges that a hollow wheel touches in many places: what
/// there is no room for is part of its neighbours, with a warning, and no force jumps.
#[test]
fn a_ground_rail_is_never_refused() {
    let edge = 7e-3;
    let rail = drawn(0.042, 841, |y| {
        let facet = (y / edge).floor();
        let [from, to] = [facet, facet + 1.0].map(|k| (k * edge).powi(2) / 0.6);
        from + (to - from) * (y / edge - facet) + (y.abs() - 25e-3).max(0.0).powi(2) / 0.03
    });
    let wheel = drawn(0.0504, 841, |y| y * y / 0.62);
    let mut over = over(&rail, &wheel, 0.0, Position::default());
    let mut memory = zeroed::<Workspace<f64>>();
    let (mut many, mut most, mut jumps) = (0, 0, 0);
    for load in [2e3, 5e3, 10e3, 20e3, 80e3] {
        for k in 0..60 {
            let lateral = -3e-3 + 1e-4 * f64::from(k);
            over.position = placed([lateral, 0.0, 0.0, 0.0]);
            let found = over.scene().height_for_load(&over.position, load, None, &mut memory);
            over.position.vertical = found.unwrap().0;
            let wrench = over.solve(&mut memory).unwrap();
            many += usize::from(wrench.warning == Warning::Rough);
            most = most.max(memory.count);
            let listed: f64 =
                memory.found().iter().map(|contact| contact.share * contact.normal_force).sum();
            assert!((listed / wrench.normal_force - 1.0).abs() < 1e-9, "{load} {lateral}");
            if k % 12 == 5 {
                let (jump, at) = largest_jump(&mut over, 0, lateral - 5e-5, lateral + 5e-5, 40);
                // beside so many contacts a further one may begin with a jump
                let crowded = [at - 1e-6, at + 1e-6].into_iter().any(|place| {
                    over.position.lateral = place;
                    over.solve(&mut memory).unwrap().warning == Warning::Rough
                });
                jumps += usize::from(crowded && jump > 1e-8);
                assert!(jump < if crowded { 0.05 } else { 1e-8 }, "{load} {at:e}: {jump:e} of N");
            }
        }
    }
    println!("{many} of 300 with a warning, {most} contacts, {jumps} jumps");
    assert!(many > 0 && most > 4, "{many} {most}");
}

/// A flange and a tread 45 mm apart: while the wheel sinks into both, the load of the flange rises
/// evenly, whichever of them is deeper.
#[test]
fn contacts_far_apart_do_not_disturb_each_other() {
    let mut random = Random::new(1);
    let rail = measured("wornhm", 0.0, 0.0, &mut random);
    let wheel = measured("car7216", 0.0, 0.0, &mut random);
    let mut memory = zeroed::<Workspace<f64>>();
    for (smoothing_length, strips) in [(0.0, 16), (2e-3, 16), (2e-3, 64), (4e-3, 16)] {
        let position = placed([-5.5715e-3, 0.0, 1.359e-3, -4.781e-3]);
        let mut over = over(&rail, &wheel, smoothing_length, position);
        over.strips = StripCount::from_number(strips).unwrap();
        let loads: Vec<f64> = (0..60)
            .map(|k| {
                over.position.vertical = 3.8e-4 + 1e-6 * f64::from(k);
                over.solve(&mut memory).unwrap();
                let flange = memory.contacts[0];
                let whole = (flange.share - 1.0).abs() <= f64::EPSILON;
                assert!(flange.angle < -1.2 && whole, "{flange:?}");
                flange.normal_force
            })
            .collect();
        assert_eq!(memory.count, 2, "both touch in the end");
        let rises: Vec<f64> = loads.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let mean = rises.iter().sum::<f64>() / rises.len() as f64;
        for (k, rise) in rises.iter().enumerate() {
            assert!((rise / mean - 1.0).abs() < 0.35, "{smoothing_length} {k}: {rise} of {mean} N");
        }
    }
}

/// Flanges of 75 to 78 degrees overlap the side of a rail by more than points outside it are looked
/// for: every point of the wheel from the first to the last that overlap is there, and no force
/// jumps.
#[test]
fn deep_overlap_of_a_steep_side_does_not_jump() {
    let rail = profile("uic60", -0.025);
    let mut memory = zeroed::<Workspace<f64>>();
    for (name, lateral, vertical, yaw, depth) in [
        ("wornhm", -70e-3, -1.981e-3, 0.017, 1.08e-3),
        ("wornhm", -70e-3, -1.603e-3, -0.017, 1.16e-3),
        ("whl288", -74e-3, -7.5e-3, -0.017, 1.60e-3),
    ] {
        let wheel = profile(name, 0.0);
        let mut over = over(&rail, &wheel, 0.0, placed([lateral, vertical, yaw, 0.0]));
        over.solve(&mut memory).unwrap();
        let WheelContact { angle, approach, .. } = memory.contacts[0];
        assert!(angle < -75f64.to_radians(), "{name}: {angle}");
        assert_relative_eq!(approach, depth, max_relative = 5e-3);
        let gap = &memory.gap;
        let inside = (0..gap.count as usize).filter(|k| gap.distance[*k] < 0.0);
        let inside: Vec<f64> = inside.map(|k| gap.along[k]).collect();
        let farthest = inside.windows(2).map(|two| two[1] - two[0]).fold(0.0, f64::max);
        assert!(farthest < 2.0 * gap.step, "{name}: {farthest} m without a point");
        for (which, span) in [(1, 60e-6), (0, 20e-6), (2, 5e-4)] {
            over.position = placed([lateral, vertical, yaw, 0.0]);
            let from = *over.varied(which) - 0.5 * span;
            let (jump, place) = largest_jump(&mut over, which, from, from + span, 40);
            assert!(jump < 1e-8, "{name}: {jump:e} of N over {} at {place:e}", NAMES[which]);
        }
    }
}

/// A tyre of rubber on a flat road: overlap of 9 mm counts like overlap of 0.5 mm, as Hertz's
/// sphere.
#[test]
fn deep_overlap_counts() {
    let road = drawn(0.1, 101, |_| 0.0);
    let tyre = drawn(0.1, 101, |y| -y * y / 0.6);
    let mut over = over(&road, &tyre, 0.0, Position::default());
    over.pair = WheelPair { shear_modulus: 1e6, poisson_ratio: 0.5, ..steel(0.3) };
    let mut memory = zeroed::<Workspace<f64>>();
    for k in 1..=18 {
        let depth = 0.5e-3 * f64::from(k);
        over.position.vertical = depth;
        let load = over.load(&mut memory).unwrap();
        let hertz = 4.0 / 3.0 * 2e6 * 0.3_f64.sqrt() * depth.powf(1.5);
        assert!((load / hertz - 1.0).abs() < 0.02, "{depth}: {load} N for {hertz} N");
    }
}

/// Heights from random starts, far above and deep below, are the same to the bit, and the rail
/// supports the wheel with the load; also of a small roller.
#[test]
fn heights_do_not_depend_on_the_start() {
    let mut random = Random::new(4);
    let rails = RAILS.map(|(name, turn)| measured(name, turn, 0.0, &mut random));
    let wheels = WHEELS.map(|name| measured(name, 0.0, 0.0, &mut random));
    let (flat, roller) = (drawn(0.01, 101, |_| 0.0), drawn(5e-3, 101, |y| -y * y / 0.4));
    let mut memory = zeroed::<Workspace<f64>>();
    let mut found = 0;
    for trial in 0..40 {
        let small = trial >= 36;
        let between = |random: &mut Random, most: f64| {
            if small { 0.0 } else { random.between(-most, most) }
        };
        let [lateral, yaw, roll] = [12e-3, 0.01, 0.02].map(|most| between(&mut random, most));
        let place = placed([lateral, 0.0, yaw, roll]);
        let (rail, wheel) =
            if small { (&flat, &roller) } else { (&rails[trial % 6], &wheels[trial / 6 % 4]) };
        let mut over = over(rail, wheel, 0.0, place);
        over.pair.wheel_radius = if small { 5e-3 } else { 0.46 };
        let load =
            if small { [1.0, 10.0, 100.0, 1e3][trial - 36] } else { random.log_between(1e3, 2e5) };
        let mut heights = vec![];
        for start in [0.0, -0.06, 0.1, random.between(-1.0, 1.0), -10.0] {
            over.position.vertical = start;
            let height = over.scene().height_for_load(&over.position, load, None, &mut memory);
            let height = height.map(|(height, warning)| {
                // (200 kN press a flange with more than a twentieth of the modulus, and the worn
                // profile is that of a wheel)
                let expected = [Warning::None, Warning::Support, Warning::Orientation];
                assert!(expected.contains(&warning), "{warning:?}");
                height
            });
            heights.push(height);
        }
        assert!(heights.iter().all(|height| *height == heights[0]), "{trial}: {heights:?}");
        let Ok(height) = heights[0] else {
            assert!(!small, "{heights:?}");
            continue;
        };
        found += 1;
        over.position.vertical = height;
        over.solve(&mut memory).unwrap();
        let carried: f64 = memory
            .found()
            .iter()
            .map(|contact| contact.share * contact.normal_force * contact.normal[2])
            .sum();
        assert!((carried / load - 1.0).abs() < 1e-9, "{trial}: {carried} N for {load} N");
    }
    assert!(found > 25, "{found}");
}

/// A slight zone beside a contact appears within a nanometre of depth. It takes no cells from the
/// contact, and its strip carries no more than others that have just begun.
#[test]
fn a_slight_zone_changes_no_load() {
    let (rail, wheel) = (profile("wornhm", 0.0), profile("en_wheel_a", 0.0));
    let pair = WheelPair { smoothing_length: 4e-3, ..steel(0.46) };
    let scene = Scene { strips: StripCount::Four, ..scene(&rail, &wheel, &pair) };
    let mut memory = zeroed::<Workspace<f64>>();
    let mut zones = Vec::new();
    let mut loads = Vec::new();
    for k in -16..=16 {
        let vertical = 0.003_248_083_17 + 2.5e-10 * f64::from(k);
        let position = placed([-6.062_603_21e-4, vertical, -0.012_123_964_7, 0.016_817_782_1]);
        let state = BodyState { position, velocity: ROLLING };
        let wrench = scene.solve(&state, &mut memory).unwrap();
        let patch = &memory.contacts[0].patch;
        let strips = patch.strips[..patch.count as usize].iter();
        let slight = strips.filter(|strip| strip.width < 7e-6);
        let pressures = slight.clone().map(|strip| strip.peak_pressure);
        assert!(pressures.fold(0.0, f64::max) < 50e6, "{k}: {:?}", slight.collect::<Vec<_>>());
        zones.push(slight.count());
        loads.push(wrench.normal_force);
    }
    let [least, most] = [f64::min, f64::max].map(|of| loads.iter().copied().reduce(of).unwrap());
    assert!(zones[0] == 0 && zones[32] > 0, "{zones:?}");
    assert!(most / least - 1.0 < 2e-3, "{loads:?}");
}
