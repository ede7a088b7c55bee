//! Case of the Manchester benchmark: a wheelset with wheels S1002 on rails 60E1 that shifts
//! and yaws, 10 kN on each wheel, 2 m/s.
//!
//! Roll is that of wheels on both rails, and the axle turns with the mean radius, as the benchmark
//! has it; its roll itself is not at hand, which counts where the flange begins to climb (6.5 to
//! 7.5 mm).

use crate::reference::numbers;
use crate::toolchain::root;
use kstrip::contact::totals::StripCount;
use kstrip::forces::Model;
use kstrip::wheel_rail::forces::wrench::Law;
use kstrip::wheel_rail::profile::PreparedProfile;
use kstrip::wheel_rail::scene::{Scene, Workspace};
use kstrip::wheel_rail::{BodyState, Position, Velocity, WheelPair};

/// Load of a wheel [N], speed [m/s], yaw over shift [rad/m].
const LOAD: f64 = 10e3;
const SPEED: f64 = 2.0;
const YAW: f64 = 2.4;
/// From the middle of the wheelset to y = 0 of a wheel's profile, and from the middle of the track
/// to a rail's origin [m].
const HALF_WIDTH: f64 = 0.75;
const HALF_GAUGE: f64 = 0.760_532_5;

/// What a wheel does: its contacts together, weighted with load; forces are those on the rail.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wheel {
    /// From the middle of the track [mm].
    pub y: f64,
    /// [degrees]
    pub angle: f64,
    /// [N]
    pub load: f64,
    /// [mm^2]
    pub area: f64,
    /// [MPa]
    pub peak: f64,
    /// [N]
    pub fx: f64,
    /// [N]
    pub fy: f64,
    radius: f64,
    /// Of its centre over the rail [m].
    pub vertical: f64,
}

/// CONTACT's figures: whether the wheel is the left one, shift [mm], and what it does.
pub fn contact() -> Vec<(bool, f64, Wheel)> {
    let path = root().join("tests/data/wheel_rail/manchester.csv");
    let row = |record: csv::StringRecord| {
        let number = |i: usize| record[i].parse::<f64>().unwrap();
        let [shift, fx, fy, load, y, angle, area, peak] = std::array::from_fn(|i| number(i + 1));
        let wheel = Wheel { y, angle, load, area, peak, fx, fy, ..Wheel::default() };
        (&record[0] == "left", shift, wheel)
    };
    csv::Reader::from_path(path).unwrap().records().map(|record| row(record.unwrap())).collect()
}

/// Zeroed memory of plain numbers, on the heap because it is large.
pub fn zeroed<T>() -> Box<T> {
    // SAFETY: all bits zero are a structure of numbers.
    unsafe { Box::new(std::mem::MaybeUninit::<T>::zeroed().assume_init()) }
}

/// Columns y and z of a file of `tests/data/wheel_rail` [m].
pub fn points(name: &str) -> [Vec<f64>; 2] {
    let rows = numbers::<2>(&format!("wheel_rail/{name}.csv"));
    [0, 1].map(|i| rows.iter().map(|row| 1e-3 * row[i]).collect())
}

/// The profile of such a file.
pub fn profile(name: &str) -> Box<PreparedProfile<f64>> {
    let [y, z] = points(name);
    prepared(&y, &z)
}

/// The same, turned about its origin from y to z [rad].
pub fn turned(name: &str, turn: f64) -> Box<PreparedProfile<f64>> {
    let [y, z] = points(name);
    let (sine, cosine) = turn.sin_cos();
    let (y, z): (Vec<f64>, Vec<f64>) =
        y.iter().zip(&z).map(|(y, z)| (y * cosine - z * sine, y * sine + z * cosine)).unzip();
    prepared(&y, &z)
}

pub fn prepared(y: &[f64], z: &[f64]) -> Box<PreparedProfile<f64>> {
    let mut surface = zeroed::<PreparedProfile<f64>>();
    surface.prepare(y, z, 0.0, 0.0).unwrap();
    surface
}

/// A profile of `2 n + 1` points at these distances [m] across.
pub fn drawn(n: i32, step: f64, height: impl Fn(f64) -> f64) -> Box<PreparedProfile<f64>> {
    let y: Vec<f64> = (-n..=n).map(|i| f64::from(i) * step).collect();
    let z: Vec<f64> = y.iter().map(|y| height(*y)).collect();
    prepared(&y, &z)
}

/// The height of a round rail head of a radius [m].
pub fn round_head(radius: f64) -> impl Fn(f64) -> f64 {
    move |y| radius - (radius * radius - y * y).sqrt()
}

/// A right wheel of a radius [m], of steel on steel, with friction 0.3.
pub fn steel(wheel_radius: f64) -> WheelPair<f64> {
    let (shear_modulus, poisson_ratio, friction) = (82e9, 0.28, 0.3);
    WheelPair { wheel_radius, shear_modulus, poisson_ratio, friction, ..*zeroed() }
}

pub struct Wheelset {
    rail: Box<PreparedProfile<f64>>,
    wheel: Box<PreparedProfile<f64>>,
    memory: Box<Workspace<f64>>,
}

impl Default for Wheelset {
    fn default() -> Self {
        Self { rail: profile("uic60"), wheel: profile("s1002"), memory: zeroed() }
    }
}

impl Wheelset {
    /// The right wheel and the left one at a shift [m].
    pub fn at(&mut self, shift: f64) -> [Wheel; 2] {
        self.with_position(shift).0
    }

    /// The same, with the position of the wheelset and its pitch rate. (Its height and roll follow
    /// the wheels within some micrometres: each wheel has the height at which it carries its load.)
    pub fn with_position(&mut self, shift: f64) -> ([Wheel; 2], Position<f64>, f64) {
        let (mut roll, mut pitch) = (0.0, -SPEED / 0.46);
        let mut found = ([Wheel::default(); 2], Position::default(), pitch);
        for _ in 0..7 {
            let wheels = [false, true].map(|left| self.wheel(left, shift, roll, pitch));
            let [right, left] = wheels;
            let vertical = (right.vertical + left.vertical) / 2.0;
            let position = Position { lateral: shift, vertical, yaw: YAW * shift, roll };
            found = (wheels, position, pitch);
            roll = (right.vertical - left.vertical) / (2.0 * HALF_WIDTH);
            pitch = -2.0 * SPEED / (right.radius + left.radius);
        }
        found
    }

    fn wheel(&mut self, left: bool, shift: f64, roll: f64, pitch: f64) -> Wheel {
        let (side, yaw) = (if left { -1.0 } else { 1.0 }, YAW * shift);
        let pair = WheelPair { left: i32::from(left), ..steel(0.46) };
        let Self { rail, wheel, memory } = self;
        let law = Law { model: Model::Strip, falling: None };
        let scene =
            Scene { rail, wheel, pair: &pair, strips: StripCount::Sixteen, law, table: None };
        let lateral = shift + side * (HALF_WIDTH * yaw.cos() * roll.cos() - HALF_GAUGE);
        let position = Position { lateral, yaw, roll, ..Position::default() };
        let velocity = Velocity { forward: SPEED, pitch, ..Velocity::default() };
        let (vertical, _) =
            scene.height_for_load(&position, LOAD, Some(&velocity), memory).unwrap();
        let position = Position { vertical, ..position };
        let wrench = scene.solve(&BodyState { position, velocity }, memory).unwrap();
        let [fx, fy, _] = wrench.force;
        let mut sum = Wheel { fx: -fx, fy: -fy, vertical, ..Wheel::default() };
        for contact in memory.found() {
            let strips = contact.patch.view().unwrap();
            let weight = contact.share * contact.normal_force;
            let y = contact.origin[1] + lateral + side * HALF_GAUGE;
            sum.load += weight;
            sum.y += weight * y * 1e3;
            sum.angle += weight * contact.angle.to_degrees();
            sum.radius += weight * contact.radius;
            sum.area += contact.share * strips.area() * 1e6;
            let peaks = strips.strips().iter().map(|strip| strip.peak_pressure * 1e-6);
            sum.peak = peaks.fold(sum.peak, f64::max);
        }
        let load = sum.load;
        Wheel { y: sum.y / load, angle: sum.angle / load, radius: sum.radius / load, ..sum }
    }
}
