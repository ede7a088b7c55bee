//! Wheel on rail: against CONTACT on real profiles, exact cases, symmetry, power, slopes,
//! continuity, friction by place, bad input.

use crate::prelude::*;
use crate::warnings::OF_UNITS;
use kstrip::wheel_rail::contacts::from_gap;
use kstrip::wheel_rail::touch::{Gap, GapSearch};
use kstrip_testing::manchester::Wheelset;
use kstrip_testing::patch_reference::{Row, number, rows_of};

type Members = [f64; 6];

pub(crate) fn rows(name: &str) -> Vec<Row> {
    rows_of("wheel_rail", &format!("{name}.csv"))
}

/// A profile of the data, turned about its origin.
pub(crate) fn profile(name: &str, turn: f64) -> Box<PreparedProfile<f64>> {
    let [y, z] = points(name);
    let (sine, cosine) = turn.sin_cos();
    let turned =
        |along: f64, across: f64| (along * cosine - across * sine, along * sine + across * cosine);
    let (y, z): (Vec<f64>, Vec<f64>) = y.iter().zip(&z).map(|(y, z)| turned(*y, *z)).unzip();
    prepared(&y, &z)
}

/// A wheel, a rail, and memory.
pub(crate) struct Stand {
    rail: Box<PreparedProfile<f64>>,
    wheel: Box<PreparedProfile<f64>>,
    pub(crate) pair: WheelPair<f64>,
    pub(crate) model: Model,
    pub(crate) falling: Option<SlipFriction<f64>>,
    pub(crate) memory: Box<Workspace<f64>>,
}

impl Stand {
    pub(crate) fn new(
        rail: Box<PreparedProfile<f64>>, wheel: Box<PreparedProfile<f64>>, wheel_radius: f64,
    ) -> Self {
        let (pair, model) = (steel(wheel_radius), Model::Strip);
        Self { rail, wheel, pair, model, falling: None, memory: zeroed() }
    }

    /// S1002 on UIC60, both new; the wheel's centre is 10.5325 mm to the left of the rail's at y =
    /// 0 of the wheelset.
    pub(crate) fn new_profiles() -> Self {
        Self::new(profile("uic60", 0.0), profile("s1002", 0.0), 0.46)
    }

    pub(crate) fn split(&mut self) -> (Scene<'_, f64>, &mut Workspace<f64>) {
        let Self { rail, wheel, pair, model, falling, memory } = self;
        let law = Law { model: *model, falling: falling.as_ref() };
        (Scene { rail, wheel, pair, strips: StripCount::Sixteen, law, table: None }, memory)
    }

    pub(crate) fn solve(
        &mut self, position: &Position<f64>, velocity: &Velocity<f64>,
    ) -> Wrench<f64> {
        let (scene, memory) = self.split();
        scene.solve(&BodyState { position: *position, velocity: *velocity }, memory).unwrap()
    }

    /// Derivatives with respect to velocity.
    pub(crate) fn derivatives(
        &mut self, position: &Position<f64>, velocity: &Velocity<f64>,
    ) -> Box<WrenchDerivatives<f64>> {
        let (mut slopes, (scene, memory)) = (zeroed(), self.split());
        scene
            .differentiate(
                &BodyState { position: *position, velocity: *velocity },
                memory,
                Requested { by_velocity: Some(&mut slopes), by_position: None },
            )
            .unwrap();
        slopes
    }

    pub(crate) fn height(
        &mut self, position: &Position<f64>, load: f64, velocity: Option<&Velocity<f64>>,
    ) -> f64 {
        let (scene, memory) = self.split();
        let (height, warning) = scene.height_for_load(position, load, velocity, memory).unwrap();
        // only contacts pressed with more than a twentieth of the modulus are said to be none
        let strips = memory.found().iter().flat_map(|contact| contact.patch.used().iter());
        let most = strips.map(|strip| strip.peak_pressure).fold(0.0, f64::max);
        let expected =
            if most > scene.pair.shear_modulus / 20.0 { Warning::Support } else { Warning::None };
        assert_eq!(warning, expected, "{position:?} {most}");
        height
    }

    /// The position at a lateral shift of the wheelset where pressure carries a load.
    pub(crate) fn at(&mut self, shift: f64, load: f64) -> Position<f64> {
        let position = Position { lateral: shift - OFFSET, ..Position::default() };
        Position { vertical: self.height(&position, load, None), ..position }
    }
}

/// Wheel's centre 750 mm from the middle of the track, rail's origin 760.5325 mm.
const OFFSET: f64 = 10.5325e-3;
pub(crate) const ROLLING: Velocity<f64> =
    Velocity { forward: 20.0, lateral: 0.0, vertical: 0.0, roll: 0.0, pitch: -43.4, yaw: 0.0 };

/// The pair of a row of the data, at its position without a height, and its velocity.
pub(crate) fn stand(row: &Row) -> (Stand, Position<f64>, Velocity<f64>) {
    let rail = profile(&row["rail"], number(row, "rail_turn_rad"));
    let wheel = profile(&row["wheel"], 0.0);
    let stand = Stand::new(rail, wheel, number(row, "wheel_radius_mm") * 1e-3);
    let lateral = number(row, "lateral_mm") * 1e-3;
    let position = Position { lateral, yaw: number(row, "yaw_rad"), ..Position::default() };
    let (lateral, pitch) = (number(row, "lateral_mm_s") * 1e-3, number(row, "pitch_rad_s"));
    (stand, position, Velocity { lateral, pitch, ..ROLLING })
}

pub(crate) fn power(wrench: &Wrench<f64>, velocity: &Velocity<f64>) -> f64 {
    dot(&wrench.members(), &rates(velocity))
}

pub(crate) fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

pub(crate) fn mean_and_p95(mut errors: Vec<f64>) -> [f64; 2] {
    errors.iter_mut().for_each(|error| *error = error.abs());
    errors.sort_by(f64::total_cmp);
    let p95 = errors[(errors.len() * 95 / 100).min(errors.len() - 1)];
    [errors.iter().sum::<f64>() / errors.len() as f64, p95]
}

/// The page with the errors of wheels.
pub(crate) const PAGE: &str = "docs/evidence/wheels.md";

/// 354 wheels on real rails, 345 of them under 30 degrees of range, loads with creep forces as
/// CONTACT's: heights in um, forces divided by mu N, number of contacts. Beyond 30 degrees only
/// forces against conformal CONTACT.
#[test]
fn forces_and_heights_are_those_of_contact() {
    let (mut heights, mut planar, mut same) = (vec![], vec![], 0);
    let mut conformal = [const { Vec::<f64>::new() }; 5];
    let runs = rows("runs");
    assert_eq!(runs.len(), 354);
    for row in &runs {
        let (mut stand, position, velocity) = stand(row);
        let vertical = stand.height(&position, number(row, "support_N"), Some(&velocity));
        let wrench = stand.solve(&Position { vertical, ..position }, &velocity);
        assert!(!OF_UNITS.contains(&wrench.warning), "{row:?}");
        let bound = 0.3 * number(row, "normal_force_N");
        let off = |x: &str, y: &str| {
            let [fx, fy, _] = wrench.force;
            (fx + number(row, x)).hypot(fy + number(row, y)) / bound
        };
        let range = number(row, "angle_range_deg");
        if range < 30.0 {
            heights.push(vertical * 1e6 - number(row, "vertical_mm") * 1e3);
            planar.push(off("FX_N", "FY_N"));
            same += usize::from(f64::from(wrench.contacts) == number(row, "contacts"));
        }
        if !row["conformal_FX_N"].is_empty() {
            let class = [5.0, 10.0, 20.0, 30.0].iter().filter(|&&end| range >= end).count();
            conformal[class].push(off("conformal_FX_N", "conformal_FY_N"));
        }
    }
    assert_eq!(heights.len(), 345);
    let share = same as f64 / heights.len() as f64;
    let [heights, planar] = [mean_and_p95(heights), mean_and_p95(planar)];
    let [least, most] = [f64::min, f64::max].map(|choose| {
        conformal[4].iter().copied().reduce(choose).expect("wheels beyond 30 degrees")
    });
    assert_eq!(conformal[4].len(), 3);
    let conformal = conformal.map(|errors| mean_and_p95(errors)[0]);
    println!(
        "heights {heights:.2?} um, planar {planar:.4?}, conformal {conformal:.4?}, same contacts \
         {share:.3}"
    );
    assert!(share >= 0.97 && heights[0] < 1.5 && heights[1] < 5.0);
    assert!(planar[0] < 0.030 && planar[1] < 0.10);
    let allowed = [0.022, 0.022, 0.025, 0.038, 0.2];
    assert!(conformal.iter().zip(allowed).all(|(error, allowed)| *error < allowed));
    assert_told(PAGE, &format!("with one plane of contact | {:.3} |", planar[0]));
    let [a, b, c, d, _] = conformal;
    assert_told(PAGE, &format!("20 to 30 degrees | {a:.3}, {b:.3}, {c:.3}, {d:.3} |"));
    let [mean, p95] = heights;
    assert_told(PAGE, &format!("mean and 95th percentile | {mean:.1} µm, {p95:.1} µm |"));
    assert_told(PAGE, &format!("as many contacts as in CONTACT | {:.0} % |", 100.0 * share));
    assert_told(PAGE, &format!("forces are off by {least:.2} to {most:.2} of μ N"));
}

/// A cone on a round head is Hertz's contact: radii `r/cos a` along and the head's across.
#[test]
fn a_cone_on_a_round_head_is_that_of_hertz() {
    let (angle, head) = (0.05_f64, 0.3);
    let cone = drawn(80, 0.4e-3, |y| -y * angle.tan());
    let mut stand = Stand::new(drawn(80, 0.4e-3, round_head(head)), cone, 0.46);
    for shift in [-3e-3, 0.0, 4.321e-3] {
        // contact where the head is as steep as the cone, at head sin a to the left of its middle
        let place = -head * angle.sin();
        let radius = 0.46 - (place - shift) * angle.tan();
        let radii = radii([FLAT, head, radius / angle.cos(), FLAT]);
        let exact = hertz(&radii, 80e3, 82e9, 0.28).unwrap();
        let position = Position { lateral: shift, ..Position::default() };
        let touches = (place - shift) * angle.tan() + head * (1.0 - angle.cos());
        let vertical = touches + exact.approach / angle.cos();
        stand.solve(&Position { vertical, ..position }, &ROLLING);
        let [contact] = stand.memory.found() else { panic!("one contact") };
        assert_relative_eq!(contact.normal_force, 80e3, max_relative = 2e-3);
        assert_relative_eq!(contact.approach, exact.approach, max_relative = 2e-7);
        assert_relative_eq!(contact.angle, -angle, max_relative = 5e-5);
        assert_relative_eq!(contact.radius, radius, max_relative = 3e-6);
        assert_relative_eq!(contact.origin[1] + shift, place, epsilon = 2e-5);
        // what the rate about the axle moves the surface with
        assert_relative_eq!(contact.slip_x[4], contact.radius, max_relative = 1e-3);
        // the mean of what rail and wheel run through the contact with
        assert_relative_eq!(contact.rolling_speed[0], 0.5, max_relative = 1e-12);
        assert_relative_eq!(contact.rolling_speed[4], -0.5 * radius, max_relative = 3e-6);
        // the head turns by 2 b over its radius below the patch, and the cone does not
        assert_relative_eq!(contact.angle_range, exact.b / head, max_relative = 0.1);
    }
}

/// A cylinder that swings about the centre of a round head keeps its contact, which is that of
/// Hertz: roll moves the wheel's centre by `(R + r) sin φ` across and by `(R + r)(1 − cos φ)` down.
#[test]
fn a_rolled_cylinder_touches_where_geometry_says() {
    let (head, radius) = (0.3, 0.46);
    let cylinder = drawn(80, 0.4e-3, |_| 0.0);
    let mut stand = Stand::new(drawn(80, 0.4e-3, round_head(head)), cylinder, radius);
    let radii = radii([FLAT, head, radius, FLAT]);
    for roll in [-0.06, 0.0, 0.03, 0.07_f64] {
        let load = 80e3;
        let exact = hertz(&radii, load, 82e9, 0.28).unwrap();
        let lateral = (head + radius) * roll.sin();
        let position = Position { lateral, roll, ..Position::default() };
        let vertical = stand.height(&position, load * roll.cos(), None);
        let touches = (head + radius) * (1.0 - roll.cos());
        let approach = (vertical - touches) * roll.cos();
        assert_relative_eq!(approach, exact.approach, max_relative = 1e-3);
    }
}

/// Along `x` a yawed wheel is curved as the slope of its line of contact says:
/// `R = r/cos a (1 − dx/ds tan(yaw)/cos a)`. On a flange that is far from `r/cos a`.
#[test]
fn the_rolling_radius_of_a_yawed_wheel_is_that_of_its_line_of_contact() {
    let stand = Stand::new_profiles();
    let Stand { rail, wheel, pair, .. } = &stand;
    let mut gap = zeroed::<Gap<f64>>();
    let (mut compared, mut farthest) = (0, 1.0_f64);
    for yaw in [-0.03, 0.0, 0.0236] {
        let position = Position { lateral: 6.7e-3 - OFFSET, vertical: 0.0, yaw, roll: 0.0 };
        let search = GapSearch::new(rail, wheel, pair.wheel_radius, &position).unwrap();
        search.gap(4e-3, &mut gap).unwrap();
        let count = gap.count as usize;
        for k in (1..count - 1).filter(|k| gap.along[k + 1] - gap.along[k - 1] < 1e-3) {
            // (where the curvature jumps, two points say little)
            let radii = [k - 1, k + 1].map(|k| gap.rolling_radius[k]);
            if (radii[1] / radii[0] - 1.0).abs() > 0.3 {
                continue;
            }
            let across = |list: &[f64]| list[k + 1] - list[k - 1];
            let [dx, dy, dz] = [&gap.x, &gap.y, &gap.z].map(|list| across(&list[..count]));
            let cosine = dy / dy.hypot(dz);
            let [x, y, z] = [gap.x[k], gap.y[k], gap.z[k]];
            // across the axle, whose direction is (-sin yaw, cos yaw, 0)
            let ahead = x * yaw.cos() + y * yaw.sin();
            let theta = (ahead / ahead.hypot(z)).asin();
            let unyawed = ahead.hypot(z) * theta.cos() / cosine;
            let factor = 1.0 - dx / dy.hypot(dz) * yaw.tan() / cosine;
            let factor = factor.clamp(0.2, 5.0);
            assert_relative_eq!(gap.rolling_radius[k], unyawed * factor, max_relative = 0.03);
            compared += 1;
            farthest = farthest.max((factor - 1.0).abs() + 1.0);
        }
    }
    assert!(compared > 300 && farthest > 1.3, "{compared} {farthest}");
}

/// No rolling radius is less than a fifth of `r/cos a`: that of a yawed narrow arc would be.
#[test]
fn the_rolling_radius_of_a_narrow_arc_is_a_fifth() {
    let y: [f64; 161] = std::array::from_fn(|i| (i as f64 - 80.0) * 50e-6);
    let wheel = prepared(&y, &y.map(|y| (25e-6 - y * y).sqrt()));
    let rail = prepared(&y.map(|y| 5.0 * y), &y.map(|_| 0.0));
    let mut gap = zeroed::<Gap<f64>>();
    let position = placed([0.0, 0.0, 0.15, 0.0]);
    GapSearch::new(&rail, &wheel, 0.46, &position).unwrap().gap(4e-3, &mut gap).unwrap();
    let mut compared = 0;
    for k in 0..gap.count as usize {
        let across = gap.y[k] * 0.15_f64.cos() - gap.x[k] * 0.15_f64.sin();
        let depth = (25e-6 - across * across).sqrt();
        if depth < 3.7e-3 {
            let fifth = 0.2 * (0.46 + depth) / (depth / 5e-3);
            assert_relative_eq!(gap.rolling_radius[k], fifth, max_relative = 5e-3);
            compared += 1;
        }
    }
    assert!(compared > 10, "{compared}");
}

/// A gap of a host that says nothing of the wheel's points has the contacts of one that does; its
/// own points are as far apart where the surfaces are near.
#[test]
fn a_gap_without_a_step_has_that_of_its_points() {
    let mut stand = Stand::new_profiles();
    let position = stand.at(-1e-3, 80e3);
    let Stand { pair, memory, .. } = &mut stand;
    let Workspace { gap, strips, contacts, .. } = &mut **memory;
    let mut found = |gap: &Gap<f64>| {
        let count = StripCount::Sixteen;
        from_gap(gap, pair, &position, count, strips, contacts).map(|_| contacts[0].normal_force)
    };
    let whole = found(gap).unwrap();
    let step = gap.step;
    gap.step = 0.0;
    let own = found(gap).unwrap();
    gap.step = 1.5 * step;
    let wider = found(gap).unwrap();
    assert!((own / whole - 1.0).abs() < 3e-6, "{own} for {whole} N");
    assert!((wider / whole - 1.0).abs() > 1e-4, "{wider} for {whole} N");
    gap.step = -step;
    assert_eq!(found(gap), Err(Error::SmoothingLength));
    gap.step = f64::NAN;
    assert_eq!(found(gap), Err(Error::NotFinite));
}

/// Points farther away than the reach that the header says have no effect; others have. No reach
/// leaves out points that overlap.
#[test]
fn a_gap_needs_the_reach_that_the_header_says() {
    let mut stand = Stand::new_profiles();
    let position = stand.at(-1e-3, 80e3);
    let Stand { rail, wheel, pair, memory, .. } = &mut stand;
    let Workspace { gap, strips, contacts, .. } = &mut **memory;
    let step = wheel.step;
    for smoothing in [0.0, 1e-3, 4e-3] {
        pair.smoothing_length = smoothing;
        let mut found = |reach: f64| {
            let search = GapSearch::new(rail, wheel, pair.wheel_radius, &position).unwrap();
            search.gap(reach, gap).unwrap();
            from_gap(gap, pair, &position, StripCount::Sixteen, strips, contacts).unwrap();
            let distances = &gap.distance[..gap.count as usize];
            let overlaps = distances.iter().filter(|distance| **distance < 0.0).count();
            (contacts[0].normal_force.to_bits(), overlaps)
        };
        let smoothed = (smoothing * smoothing + 6.25 * step * step).sqrt();
        let least = (3.0 * step + (0.5 * smoothed).min(1e-3)).min(2e-3);
        let (whole, overlaps) = found(4e-3);
        assert_eq!(found(least), (whole, overlaps), "{smoothing}");
        let (cut, still) = found(0.05 * least);
        assert_ne!(cut, whole, "{smoothing}");
        assert_eq!(still, overlaps, "{smoothing}");
    }
}

/// Extreme numbers that are finite are never called infinite.
#[test]
fn extreme_numbers_are_finite() {
    let mut stand = Stand::new_profiles();
    let position = stand.at(-1e-3, 80e3);
    for support in [1e30, 1e160, 1e300] {
        let (scene, memory) = stand.split();
        let found = scene.height_for_load(&position, support, None, memory);
        assert_eq!(found, Err(Error::Overflow), "{support} N");
    }
    for yaw in [1e-320, -1e-320, 1e-200] {
        let state = BodyState { position: Position { yaw, ..position }, velocity: ROLLING };
        let (scene, memory) = stand.split();
        let found = scene.solve(&state, memory).unwrap();
        let straight = BodyState { position: Position { yaw: 0.0, ..position }, ..state };
        let exact = scene.solve(&straight, memory).unwrap();
        assert_relative_eq!(found.normal_force, exact.normal_force, max_relative = 1e-12);
    }
}

#[test]
fn left_is_the_mirror_of_right() {
    let mut stand = Stand::new_profiles();
    let right = Position { yaw: 4e-3, roll: 1e-3, ..stand.at(2.3e-3, 80e3) };
    let velocity = Velocity { lateral: 0.03, roll: 0.1, yaw: 0.05, ..ROLLING };
    let a = stand.solve(&right, &velocity);
    stand.pair.left = 1;
    let left = Position { lateral: -right.lateral, yaw: -right.yaw, roll: -right.roll, ..right };
    let mirrored = Velocity { lateral: -0.03, roll: -0.1, yaw: -0.05, ..velocity };
    let b = stand.solve(&left, &mirrored);
    let [fx, fy, fz, mx, my, mz] = a.members();
    assert_eq!([fx, -fy, fz, -mx, my, -mz], b.members());
}

/// Creep forces take as much power from the wheel as friction dissipates; pressure takes the rest.
#[test]
fn power_is_dissipation() {
    let mut stand = Stand::new_profiles();
    for (shift, yaw) in [(0.0, 0.0), (3e-3, 5e-3), (5.2e-3, -4e-3), (6.5e-3, 0.01)] {
        let position = Position { yaw, ..stand.at(shift, 80e3) };
        let velocity = Velocity { lateral: 0.02, vertical: 1e-3, roll: 0.1, yaw: 0.04, ..ROLLING };
        for model in [Model::Strip, Model::Total] {
            stand.model = model;
            let wrench = stand.solve(&position, &velocity);
            let of_pressure = |contact: &WheelContact<f64>| {
                contact.share * contact.normal_force * dot(&contact.normal, &rates(&velocity))
            };
            let pressure: f64 = stand.memory.found().iter().map(of_pressure).sum();
            let rest = power(&wrench, &velocity) + wrench.dissipation + pressure;
            // the numbers that cancel are those of force times rolling speed
            assert!(
                rest.abs() < 1e-9 * 0.3 * wrench.normal_force * 20.0,
                "{shift} {model:?} {rest}"
            );
            assert!(wrench.dissipation > 0.0);
        }
    }
}

pub(crate) fn moved(velocity: &Velocity<f64>, k: usize, step: f64) -> Velocity<f64> {
    let mut velocity = *velocity;
    let Velocity { forward, lateral, vertical, roll, pitch, yaw } = &mut velocity;
    *[forward, lateral, vertical, roll, pitch, yaw][k] += step;
    velocity
}

pub(crate) fn difference(plus: &Wrench<f64>, minus: &Wrench<f64>, step: f64) -> Members {
    let (plus, minus) = (plus.members(), minus.members());
    std::array::from_fn(|i| (plus[i] - minus[i]) / (2.0 * step))
}

/// Derivatives with respect to these rates are those of differences of this step, but for a share
/// of the largest of each column, at least `least`.
pub(crate) fn assert_derivatives(
    slopes: &[[f64; 6]; 6], rates: impl IntoIterator<Item = usize>, (step, least): (f64, f64),
    mut at: impl FnMut(usize, f64) -> Wrench<f64>,
) {
    for k in rates {
        let (plus, minus) = (at(k, step), at(k, -step));
        assert_near(&slopes.map(|row| row[k]), &difference(&plus, &minus, step), (1e-4, least));
    }
}

/// Derivatives are those of differences, but for a share of the largest, at least `least`.
#[track_caller]
pub(crate) fn assert_near(slopes: &[f64], expected: &[f64], (share, least): (f64, f64)) {
    assert_eq!(slopes.len(), expected.len());
    let largest = slopes.iter().fold(least, |most, slope| most.max(slope.abs()));
    for (slope, own) in slopes.iter().zip(expected) {
        assert!((slope - own).abs() < share * largest, "{slopes:?} {expected:?}");
    }
}

/// The wrench, and its derivatives with respect to the position.
pub(crate) fn by_position<F: Float>(
    scene: &Scene<F>, position: Position<F>, velocity: Velocity<F>, memory: &mut Workspace<F>,
) -> (Wrench<F>, WrenchByPosition<F>) {
    let mut slopes = WrenchByPosition::default();
    let requested = Requested { by_velocity: None, by_position: Some(&mut slopes) };
    let state = BodyState { position, velocity };
    (scene.differentiate(&state, memory, requested).unwrap(), slopes)
}

/// Exact derivatives with respect to velocity and friction against differences, forward, backward
/// and at rest.
#[test]
fn derivatives_by_velocity_are_those_of_differences() {
    let mut stand = Stand::new_profiles();
    let position = Position { yaw: 3e-3, ..stand.at(4.8e-3, 80e3) };
    for speed in [20.0, 0.03, 0.0, -0.02, -5.0] {
        let velocity = Velocity {
            forward: speed,
            lateral: 1e-4 * speed + 1e-5,
            pitch: -speed / 0.4603,
            ..Velocity::default()
        };
        let slopes = stand.derivatives(&position, &velocity);
        let scale = (speed * speed + 4e-4_f64).sqrt();
        let ends = (2e-7 * scale, 1e-3 / scale);
        assert_derivatives(&slopes.velocity, 0..6, ends, |k, step| {
            stand.solve(&position, &moved(&velocity, k, step))
        });
        let [plus, minus] = [1e-5, -1e-5].map(|step| {
            stand.pair.friction = 0.3 * (1.0 + step);
            stand.solve(&position, &velocity)
        });
        stand.pair.friction = 0.3;
        assert_near(&slopes.friction, &difference(&plus, &minus, 1e-5), (1e-8, 1e-9));
    }
}

/// Friction that falls with the slip: a locked wheel is held by the law's friction at its speed,
/// and slopes are those of differences.
#[test]
fn friction_falls_with_the_slip() {
    let law = falling(0.3, 0.4, 0.6, 0.0, 0.8);
    for model in [Model::Strip, Model::Total] {
        let mut stand = Stand::new_profiles();
        let position = stand.at(1e-3, 80e3);
        (stand.model, stand.falling) = (model, Some(law));
        for speed in [0.3, 1.0, 3.0, 10.0] {
            let velocity = Velocity { forward: speed, ..Velocity::default() };
            let wrench = stand.solve(&position, &velocity);
            let expected = 0.3 * (0.4 + 0.6 * (-0.6 * speed).exp());
            let [forward, ..] = wrench.force;
            let found = -forward / wrench.normal_force;
            assert!((found / expected - 1.0).abs() < 9e-15, "{model:?} {speed} {found} {expected}");
            assert!((wrench.dissipation / (speed * -forward) - 1.0).abs() < 1e-2, "{speed}");
        }
        let velocity = Velocity { lateral: 0.05, ..ROLLING };
        let slopes = stand.derivatives(&position, &velocity);
        assert_derivatives(&slopes.velocity, [0, 1, 4], (4e-6, 0.0), |k, step| {
            stand.solve(&position, &moved(&velocity, k, step))
        });
    }
}

/// A wheel that carries 80 kN shifts over a rail, inclined or not, in small steps, where the tread
/// ends, where the flange begins to touch and where it climbs: forces have no steps. (Points of the
/// profile enter and leave the surroundings of the contact on the way, zones of contact part and
/// merge, and strips begin to touch.)
#[test]
fn forces_are_continuous_under_a_shift() {
    let velocity = Velocity { lateral: -0.02, pitch: -43.6, ..ROLLING };
    let [micrometre, four] = [1e-6, 4e-6];
    for (turn, first, step, allowed) in [
        (0.025, 3.65e-3, micrometre, 1e-3),
        (0.025, 6.15e-3, micrometre, 1e-3),
        (0.0, 4.4e-3, four, 2e-3),
        (0.0, 5.4e-3, four, 2e-3),
    ] {
        let mut stand = Stand::new(profile("uic60", turn), profile("s1002", 0.0), 0.46);
        let at = |i: i32| {
            let position = stand.at(first + step * f64::from(i), 80e3);
            stand.solve(&position, &velocity)
        };
        let most = assert_smooth(&(0..200).map(at).collect::<Vec<_>>(), allowed);
        println!("from {first}: bends of {most}");
    }
}

/// Second differences of the forces along a way are a small share of `μ N`: the largest.
#[track_caller]
fn assert_smooth(wrenches: &[Wrench<f64>], allowed: f64) -> f64 {
    let mut most = 0.0_f64;
    for (i, three) in wrenches.windows(3).enumerate() {
        let [before, here, next] = [0, 1, 2].map(|i| three[i].force);
        let [x, y] = [0, 1].map(|k| next[k] - 2.0 * here[k] + before[k]);
        let bend = x.hypot(y) / (0.3 * three[1].normal_force);
        assert!(bend < allowed, "{i}: {bend}");
        most = most.max(bend);
    }
    most
}

/// A wheel that climbs with its flange at a constant height, by 0.5 um a step: forces bend as
/// little as Hertz's load does, although points of the gap come and go around the contact.
#[test]
fn forces_are_smooth_while_points_of_the_gap_come_and_go() {
    let mut stand = Stand::new(profile("uic60", 0.025), profile("s1002", 0.0), 0.46);
    let position = stand.at(6.768e-3, 80e3);
    let at = |i: i32| {
        let lateral = position.lateral + 0.5e-6 * f64::from(i);
        stand.solve(&Position { lateral, ..position }, &ROLLING)
    };
    assert_smooth(&(-102..=0).map(at).collect::<Vec<_>>(), 1e-4);
}

/// A wheel that is lowered by 10 nm a step carries more with every step, at least half as much more
/// as with the first, also where the bodies come close 7 mm beside the contact, right beside it, or
/// over 5 mm at once.
#[test]
fn the_load_rises_while_another_zone_appears() {
    let mut stand = Stand::new_profiles();
    for (shift, from, steps) in
        [(5.65875e-3, -325e-6, 120), (6.0611e-3, -362e-6, 120), (6.0525e-3, -360.5e-6, 500)]
    {
        let position = Position { lateral: shift - OFFSET, ..Position::default() };
        let mut load = |i: i32| {
            let vertical = from + 1e-8 * f64::from(i);
            stand.solve(&Position { vertical, ..position }, &ROLLING).normal_force
        };
        let first = load(0);
        let (mut last, usual) = (first, load(1) - first);
        for i in 1..=steps {
            let now = load(i);
            let rise = (now - last) / usual;
            assert!((0.5..1.4).contains(&rise), "{shift}, {i}: {rise}");
            last = now;
        }
    }
}

/// Standstill, backward rolling and lift-off are ordinary: forces pass through them without a jump.
#[test]
fn rest_reversal_and_lift_off_are_continuous() {
    let mut stand = Stand::new_profiles();
    let position = stand.at(1e-3, 80e3);
    let at = |i: i32| {
        let forward = f64::from(i) * 1e-3;
        let (lateral, pitch) = (2e-5, -forward / 0.4605);
        let velocity = Velocity { forward, lateral, pitch, ..Velocity::default() };
        stand.solve(&position, &velocity).force
    };
    for pair in (-100..=100).map(at).collect::<Vec<_>>().windows(2) {
        let step = (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
        assert!(step < 0.02 * 0.3 * 80e3, "{pair:?}: {step}");
    }
    let touching = stand.height(&position, 1.0, None);
    for (below, most) in
        [(1e-6, 1e3), (1e-8, 2.0), (0.0, 1.1), (-1e-6, 0.0), (-1e-3, 0.0), (-0.1, 0.0)]
    {
        let wrench = stand.solve(&Position { vertical: touching + below, ..position }, &ROLLING);
        assert!(wrench.normal_force <= most, "{below} {wrench:?}");
        if below < -1e-7 {
            assert_eq!((wrench.contacts, wrench.members()), (0, [0.0; 6]));
        }
    }
}

#[test]
fn a_skewed_patch_rolls_backward_as_its_mirror_image_forward() {
    let mut stand = Stand::new_profiles();
    let position = Position { yaw: 0.03, ..stand.at(6e-3, 80e3) };
    stand.solve(&position, &ROLLING);
    let contact = stand.memory.found().last().expect("a contact");
    // strips in one plane, and velocities that are slip, spin and rolling speed themselves
    let [slip_x, slip_y, rolling_speed, spin_rate] =
        [0, 1, 4, 5].map(|k| std::array::from_fn(|i| f64::from(u8::from(i == k))));
    let rows = WheelContact { slip_x, slip_y, rolling_speed, spin_rate, ..*contact };
    let strip_y = contact.patch.strips.map(|strip| strip.y);
    let none = [0.0; kstrip::patch::KSTRIP_PATCH_CAPACITY];
    let angles = WheelContact { strip_angle: none, strip_lean: none, ..rows };
    let plane = WheelContact { strip_y, strip_z: none, ..angles };
    let ahead = WheelContact { origin: [0.0; 3], normal: [0.0; 6], turned: [0.0; 2], ..plane };
    let mut image = ahead;
    image.patch.used_mut().iter_mut().for_each(|strip| strip.centre_x = -strip.centre_x);
    let skew = contact.patch.used().iter().map(|strip| strip.centre_x.abs()).fold(0.0, f64::max);
    assert!(skew > 1e-3, "{skew}");
    let forward =
        Velocity { forward: 0.02, lateral: 0.01, pitch: 20.0, yaw: 4.0, ..Velocity::default() };
    let backward = Velocity { forward: -0.02, pitch: -20.0, yaw: -4.0, ..forward };
    for model in [Model::Strip, Model::Strip1967Continuous] {
        let law = Law { model, falling: None };
        let found = of_contacts(&[ahead], &forward, law, None).unwrap();
        let mirrored = of_contacts(&[image], &backward, law, None).unwrap();
        let [x, y, _] = found.force;
        assert!(x.hypot(y) > 1e3, "{found:?}");
        let expected = [-x, y, -found.moment[2]];
        for (is, expected) in
            [mirrored.force[0], mirrored.force[1], mirrored.moment[2]].iter().zip(expected)
        {
            assert_relative_eq!(*is, expected, max_relative = 1e-9);
        }
    }
}

/// Smoothing leaves a parabola, wherever its points lie, and takes out points that are off.
#[test]
fn smoothing_leaves_parabolas() {
    let across = |i: i32| 0.25e-3 * f64::from(i) + 0.06e-3 * f64::from(i * i * 7 % 3 - 1);
    let y: Vec<f64> = (-100..=100).map(across).collect();
    let z: Vec<f64> = y.iter().map(|y| y * y / 0.6).collect();
    let mut smooth = zeroed::<PreparedProfile<f64>>();
    smooth.prepare(&y, &z, 0.0, 2e-3).unwrap();
    let points = smooth.y.iter().zip(&smooth.z).take(smooth.count as usize);
    let inside: Vec<_> = points.filter(|(y, _)| y.abs() < 22e-3).collect();
    assert!(inside.len() > 100);
    for (y, z) in inside {
        assert!((z - y * y / 0.6).abs() < 2e-11, "{y}: {z}");
    }
}

/// A wheel that is greasy on the gauge side pulls less there; friction of one number is that number
/// everywhere.
#[test]
fn friction_varies_along_the_rail() {
    let mut stand = Stand::new_profiles();
    let position = stand.at(0.0, 80e3);
    let velocity = Velocity { pitch: -44.0, ..ROLLING };
    let dry = stand.solve(&position, &velocity);
    stand.pair.friction_points = 2;
    (stand.pair.friction_y, stand.pair.friction_at) = ([-0.1, 0.1, 0.0, 0.0], [0.3; 4]);
    assert_eq!(stand.solve(&position, &velocity), dry);
    stand.pair.friction_at = [0.1, 0.5, 0.0, 0.0];
    let place = {
        let [contact] = stand.memory.found() else { panic!("one contact") };
        contact.origin[1] + position.lateral
    };
    let expected = (0.1 + (place + 0.1) * 2.0) / 0.3;
    let mixed = stand.solve(&position, &velocity);
    assert_relative_eq!(mixed.force[0] / dry.force[0], expected, max_relative = 5e-6);
}

/// Both wheels of a wheelset over lateral shift and yaw: place of contact, angle, load, area, peak
/// pressure and creep forces beside CONTACT's, but where the flange begins to climb.
#[test]
fn manchester_benchmark_is_that_of_contact() {
    let mut wheelset = Wheelset::default();
    let mut errors: [Vec<f64>; 6] = Default::default();
    for (left, shift, theirs) in manchester::contact() {
        if !left && (6.4..7.6).contains(&shift) {
            continue;
        }
        let ours = wheelset.at(shift * 1e-3)[usize::from(left)];
        let forces = (ours.fx - theirs.fx).hypot(ours.fy - theirs.fy);
        errors[0].push(ours.y - theirs.y);
        errors[1].push(ours.angle - theirs.angle);
        errors[2].push(ours.load / theirs.load - 1.0);
        errors[3].push(ours.area / theirs.area - 1.0);
        errors[4].push(ours.peak / theirs.peak - 1.0);
        errors[5].push(forces / (0.3 * theirs.load));
    }
    let [y, angle, load, area, peak, forces] = errors.map(mean_and_p95);
    println!(
        "y {y:.3?} mm, angle {angle:.3?} deg, load {load:.4?}, area {area:.3?}, peak {peak:.3?}"
    );
    println!("forces {forces:.4?} of mu N");
    assert!(y[0] < 0.15 && angle[0] < 0.15 && load[0] < 2e-3);
    assert!(area[0] < 0.03 && peak[0] < 0.015 && forces[0] < 0.02);
    let [load, area, peak] = [load, area, peak].map(|[mean, _]| 100.0 * mean);
    let words = format!(
        "place of contact {:.2} mm, angle {:.2} degrees, load {load:.2} %, area {area:.1} %, peak \
         pressure {peak:.1} %, forces {:.3} of μ N",
        y[0], angle[0], forces[0]
    );
    assert_told(PAGE, &words);
}

/// A wheel pair in single precision.
pub(crate) fn single(pair: &WheelPair<f64>) -> WheelPair<f32> {
    WheelPair {
        wheel_radius: pair.wheel_radius as f32,
        shear_modulus: pair.shear_modulus as f32,
        poisson_ratio: pair.poisson_ratio as f32,
        friction: pair.friction as f32,
        ..*zeroed()
    }
}

/// The derivative of the support with respect to depth in both precisions, light contacts and zones
/// that have just begun included: cells of these change by much over a step.
#[test]
fn derivatives_by_depth_are_those_of_double_precision() {
    let mut stand = Stand::new_profiles();
    let [rail, wheel] = ["uic60", "s1002"].map(|name| {
        let [y, z] = points(name).map(|list| list.iter().map(|&x| x as f32).collect::<Vec<_>>());
        let mut surface = zeroed::<PreparedProfile<f32>>();
        surface.prepare(&y, &z, 0.0, 0.0).unwrap();
        surface
    });
    let pair = single(&stand.pair);
    let (strips, law) = (StripCount::Sixteen, Law { model: Model::Strip, falling: None });
    let scene = Scene { rail: &rail, wheel: &wheel, pair: &pair, strips, law, table: None };
    let mut memory = zeroed::<Workspace<f32>>();
    let (still, rolls) = ((0.0, 0.0), (20.0, -43.4));
    let young = [(5.97079, 177_443.0), (5.7775, 113_678.0), (5.47298, 44_318.0)];
    let lightest = [15, 95, 208].map(f64::from);
    let lightest = lightest.map(|k| (9.0 + 0.011 * k, 25.0 + 0.1 * k, rolls));
    let light = [30.0, 1e3, 1e5].map(|load| (0.0, load, still));
    let young = young.map(|(lateral, load)| (lateral, load, rolls));
    for (lateral, load, (forward, pitch)) in light.into_iter().chain(young).chain(lightest) {
        let position = stand.at(lateral * 1e-3, load);
        let velocity = Velocity { forward, pitch, ..Velocity::default() };
        let (double, own) = stand.split();
        let (_, slopes) = by_position(&double, position, velocity, own);
        let exact = {
            let h = 0.01 * load.powf(2.0 / 3.0) * 4e-8;
            let at = |d: f64| Position { vertical: position.vertical + d, ..position };
            let [more, less] = [h, -h].map(|d| stand.solve(&at(d), &velocity).force[2]);
            (more - less) / (2.0 * h)
        };
        // (where a zone begins the derivative changes by much over the step of these differences)
        let exact = if lateral == 0.0 { exact } else { slopes.vertical[2] };
        assert_relative_eq!(slopes.vertical[2], exact, max_relative = 1e-3);
        // the height at which single precision has the same load
        let lateral = position.lateral as f32;
        let position = Position { lateral, vertical: 0.0, yaw: 0.0, roll: 0.0 };
        let (vertical, _) =
            scene.height_for_load(&position, load as f32, None, &mut memory).unwrap();
        let position = Position { vertical, ..position };
        let [forward, pitch] = [forward as f32, pitch as f32];
        let velocity = Velocity { forward, pitch, ..Velocity::default() };
        let (_, slopes) = by_position(&scene, position, velocity, &mut memory);
        let off = f64::from(slopes.vertical[2]) / exact - 1.0;
        assert!(off.abs() < 0.02, "{load}: {} against {exact}", slopes.vertical[2]);
    }
}

/// A patch of unlike materials: friction dissipates, and forces and derivatives are continuous
/// through standstill, as those of an ellipse are.
#[test]
fn a_mismatch_of_the_materials_dissipates_and_fades_at_standstill() {
    let mut stand = Stand::new_profiles();
    let position = stand.at(0.0, 80e3);
    stand.solve(&position, &ROLLING);
    let mut contacts = stand.memory.contacts[..stand.memory.count as usize].to_vec();
    let mut random = Random::new(3);
    for _ in 0..300 {
        contacts
            .iter_mut()
            .for_each(|contact| contact.patch.mismatch = random.between(-0.25, 0.25));
        let forward = random.sign() * random.log_between(1e-3, 20.0);
        let pitch = -forward / 0.4608 * (1.0 + random.between(-3e-3, 3e-3));
        let velocity = Velocity { forward, pitch, ..Velocity::default() };
        let wrench = of_contacts(&contacts, &velocity, STRIP, None).unwrap();
        assert!(wrench.dissipation >= 0.0, "{velocity:?}: {}", wrench.dissipation);
    }
    contacts.iter_mut().for_each(|contact| contact.patch.mismatch = 0.2);
    for speed in [0.0, 0.01, -0.03, 0.2, -3.0] {
        let velocity =
            Velocity { forward: speed, pitch: -speed / 0.4608 + 1e-6, ..Velocity::default() };
        let mut slopes = WrenchDerivatives::default();
        of_contacts(&contacts, &velocity, STRIP, Some(&mut slopes)).unwrap();
        let step = 1e-7 * (speed * speed + 4e-4_f64).sqrt();
        for k in [0, 4] {
            let at =
                |step| of_contacts(&contacts, &moved(&velocity, k, step), STRIP, None).unwrap();
            let expected = difference(&at(step), &at(-step), step);
            assert_near(&[slopes.velocity[0][k]], &expected[..1], (1e-4, 0.0));
        }
    }
    let still = of_contacts(&contacts, &Velocity::default(), STRIP, None).unwrap();
    assert_eq!(still.force[0], 0.0);
}

/// Loads and shares of contacts are not negative, and derivatives that do not fit are an error.
/// Numbers that do not count are not checked.
#[test]
fn contacts_of_a_table_are_checked_where_they_count() {
    let mut stand = Stand::new_profiles();
    let position = stand.at(0.0, 80e3);
    stand.solve(&position, &ROLLING);
    let contact = stand.memory.contacts[0];
    let solve = |contact: WheelContact<f64>| {
        let mut slopes = WrenchDerivatives::default();
        of_contacts(&[contact], &ROLLING, STRIP, Some(&mut slopes)).map(|_| slopes)
    };
    assert!(solve(contact).is_ok());
    assert_eq!(solve(WheelContact { share: -1.0, ..contact }).err(), Some(Error::Share));
    let pulled = WheelContact { normal_force: -5e4, ..contact };
    assert_eq!(solve(pulled).err(), Some(Error::NormalForce));
    let mut huge = contact;
    (huge.normal_damping, huge.normal[3]) = (0.1, 1e200);
    assert_eq!(solve(huge).err(), Some(Error::Overflow));
    stand.pair.friction_points = 1;
    stand.pair.friction_at[0] = 0.3;
    let expected = stand.solve(&position, &ROLLING);
    for friction in [f64::NAN, -1.0] {
        stand.pair.friction = friction;
        assert_eq!(stand.solve(&position, &ROLLING), expected);
    }
}

/// docs/evidence/models.md sends wheels to STRIP: the errors of both models on S1002, 1 mm from the
/// middle of 60E1, are those of the page.
#[test]
fn a_wheel_needs_strip() {
    let runs = rows("runs");
    let row = runs
        .iter()
        .find(|row| row["wheel"] == "s1002" && row["kin"] == "A" && row["lateral_mm"] == "-9.53251")
        .expect("the position of the page");
    let (mut stand, position, velocity) = stand(row);
    let [strip, total] = [Model::Strip, Model::Total].map(|model| {
        stand.model = model;
        let vertical = stand.height(&position, number(row, "support_N"), Some(&velocity));
        let [fx, fy, _] = stand.solve(&Position { vertical, ..position }, &velocity).force;
        let (x, y) = (fx + number(row, "FX_N"), fy + number(row, "FY_N"));
        x.hypot(y) / (0.3 * number(row, "normal_force_N"))
    });
    let words = format!("TOTAL is off by {total:.2} of μ N, that of STRIP by {strip:.2}");
    assert_told("docs/evidence/models.md", &words);
    assert!(strip < 0.03 && total > 2.0 * strip, "{strip} {total}");
}

/// A contact whose normal turns by more than 0.52 has a warning, as its member says, and so has
/// one that spins by more than its model is made for. Only points nearer than the reach are
/// written.
#[test]
fn warnings_and_reach_have_their_bounds() {
    let mut stand = Stand::new_profiles();
    let position = stand.at(0.0, 80e3);
    stand.solve(&position, &ROLLING);
    let contact = stand.memory.contacts[0];
    let warning = |angle_range: f64, yaw: f64| {
        let velocity = Velocity { yaw, ..ROLLING };
        let mut contact = contact;
        contact.angle_range = angle_range;
        of_contacts(&[contact], &velocity, STRIP, None).unwrap().warning
    };
    assert_eq!(warning(0.52, 0.0), Warning::None);
    assert_eq!(warning(0.53, 0.0), Warning::AngleRange);
    assert_eq!(warning(0.1, 100.0), Warning::OutsideRange);
    let mut gap = zeroed::<Gap<f64>>();
    let Stand { rail, wheel, pair, .. } = &stand;
    let search = GapSearch::new(rail, wheel, pair.wheel_radius, &position).unwrap();
    let mut written = |reach: f64| {
        search.gap(reach, &mut gap).unwrap();
        let distances = &gap.distance[..gap.count as usize];
        (distances.len(), distances.iter().fold(0.0, |most: f64, own| most.max(*own)))
    };
    let (few, farthest) = written(3e-4);
    assert!((2e-4..3e-4).contains(&farthest), "{farthest}");
    let (more, farthest) = written(0.0);
    assert!((1.5e-3..2e-3).contains(&farthest) && more > few, "{farthest}: {more}, {few}");
}
