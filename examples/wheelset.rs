//! A wheelset on real profiles (S1002 on 60E1): it hunts, brakes to a stop on a grade, rolls back,
//! and lifts one wheel.
//!
//!     cargo run --release --example wheelset
//!
//! The six velocities of the wheelset are integrated by the linearly implicit Euler rule,
//!
//! ```text
//! (M/h − ∂Q/∂u − h ∂Q/∂q) Δu = Q + h ∂Q/∂q u,
//! ```
//!
//! with the derivatives of the wrench that the library gives. One rule and one step serve rolling,
//! standstill and a lifted wheel.

use kstrip::contact::totals::StripCount;
use kstrip::forces::Model;
use kstrip::status::Error;
use kstrip::wheel_rail::forces::wrench::{Law, Wrench, WrenchByPosition, WrenchDerivatives};
use kstrip::wheel_rail::profile::PreparedProfile;
use kstrip::wheel_rail::scene::{Scene, Workspace};
use kstrip::wheel_rail::{BodyState, Position, Requested, Velocity, WheelPair};
use nalgebra::{Matrix6, Vector6};

/// From the middle of the wheelset to y = 0 of a wheel's profile, and from the middle of the track
/// to a rail's origin [m].
const HALF_WIDTH: f64 = 0.75;
const HALF_GAUGE: f64 = 0.760_532_5;
/// Radius of the wheels at y = 0 of their profile [m].
const RADIUS: f64 = 0.46;
/// From the middle of the wheelset to an axle box [m].
const BOX: f64 = 1.0;
/// Of the wheelset [kg], about its x, axle, and z [kg m^2]; load at its centre, its own weight
/// included [N].
const MASS: f64 = 1500.0;
const INERTIA: [f64; 3] = [800.0, 110.0, 800.0];
const LOAD: f64 = 100e3;

/// Zeroed memory of plain numbers, on the heap because it is large.
fn zeroed<T>() -> Box<T> {
    // SAFETY: all bits zero are a structure of numbers.
    unsafe { Box::new(std::mem::MaybeUninit::<T>::zeroed().assume_init()) }
}

/// Columns y and z, in mm, of a file of `tests/data/wheel_rail`.
fn profile(name: &str) -> Result<Box<PreparedProfile<f64>>, Error> {
    let path = format!("{}/tests/data/wheel_rail/{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("the profile is part of the sources");
    let (mut y, mut z) = (vec![], vec![]);
    for line in text.lines().skip(1) {
        let mut numbers = line.split(',').filter_map(|number| number.parse::<f64>().ok());
        y.extend(numbers.next().map(|mm| mm * 1e-3));
        z.extend(numbers.next().map(|mm| mm * 1e-3));
    }
    let mut surface = zeroed::<PreparedProfile<f64>>();
    surface.prepare(&y, &z, 0.0, 0.0)?;
    Ok(surface)
}

/// Forces at the wheelset's centre in the track's axes [N], moments about its own axes [N m], and
/// their derivatives.
#[derive(Default)]
pub struct Load {
    pub force: Vector6<f64>,
    by_velocity: Matrix6<f64>,
    /// Lateral, vertical, roll and yaw stand in rows and columns 1, 2, 3 and 5, as in the
    /// velocities.
    by_place: Matrix6<f64>,
}

/// Where the wheelset is: lateral and vertical [m], roll and yaw [rad], and the distance that it
/// has rolled [m].
#[derive(Clone, Copy, Debug, Default)]
pub struct Place {
    pub forward: f64,
    pub lateral: f64,
    pub vertical: f64,
    pub roll: f64,
    pub yaw: f64,
}

/// A wheelset on two rails.
pub struct Wheelset {
    rail: Box<PreparedProfile<f64>>,
    wheel: Box<PreparedProfile<f64>>,
    /// The right wheel and the left one.
    pairs: [WheelPair<f64>; 2],
    memory: Box<Workspace<f64>>,
    pub place: Place,
    /// Of the centre along x, y and z [m/s], about the wheelset's own x, axle and z [rad/s].
    pub velocity: Vector6<f64>,
    pub time: f64,
    /// Time step [s].
    step: f64,
    /// What the right and the left rail do to their wheels.
    pub wheels: [Option<Wrench<f64>>; 2],
}

impl Wheelset {
    /// At a lateral position [m], carried by both rails, rolling forward at a speed [m/s]; time
    /// step [s].
    pub fn new(lateral: f64, speed: f64, step: f64) -> Result<Self, Error> {
        let right = WheelPair {
            wheel_radius: RADIUS,
            shear_modulus: 82e9,
            poisson_ratio: 0.28,
            friction: 0.3,
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
        };
        let mut new = Self {
            rail: profile("uic60")?,
            wheel: profile("s1002")?,
            pairs: [right, WheelPair { left: 1, ..right }],
            memory: zeroed(),
            place: Place { lateral, ..Place::default() },
            velocity: Vector6::new(speed, 0.0, 0.0, 0.0, -speed / RADIUS, 0.0),
            time: 0.0,
            step,
            wheels: [None; 2],
        };
        for _ in 0..8 {
            let [right, left] = [new.carried(0)?, new.carried(1)?];
            new.place.vertical += (right + left) / 2.0;
            new.place.roll += (right - left) / (2.0 * HALF_WIDTH);
        }
        Ok(new)
    }

    /// How far a wheel has to sink until pressure carries half of the load [m].
    fn carried(&mut self, side: usize) -> Result<f64, Error> {
        let position = self.position(side);
        let Self { rail, wheel, pairs, memory, .. } = self;
        let scene = scene(rail, wheel, &pairs[side]);
        let (height, _) = scene.height_for_load(&position, LOAD / 2.0, None, memory)?;
        Ok(height - position.vertical)
    }

    /// Where a wheel's centre is in the wheelset.
    fn arm(side: usize) -> f64 {
        if side == 0 { HALF_WIDTH } else { -HALF_WIDTH }
    }

    fn position(&self, side: usize) -> Position<f64> {
        let Place { lateral, vertical, roll, yaw, .. } = self.place;
        let (arm, rail) = (Self::arm(side), HALF_GAUGE.copysign(Self::arm(side)));
        Position {
            lateral: lateral + arm * yaw.cos() * roll.cos() - rail,
            vertical: vertical + arm * yaw.cos() * roll.sin(),
            yaw,
            roll,
        }
    }

    /// Velocity of a wheel by that of the wheelset: the centre of a wheel turns with roll and yaw
    /// about the wheelset's.
    fn transfer(&self, side: usize) -> Matrix6<f64> {
        let Place { roll, yaw, .. } = self.place;
        let (x, y) = ([yaw.cos(), roll.cos() * yaw.sin(), roll.sin() * yaw.sin()], Self::arm(side));
        let z = [0.0, -roll.sin(), roll.cos()];
        let mut transfer = Matrix6::identity();
        for i in 0..3 {
            transfer[(i, 3)] = y * z[i];
            transfer[(i, 5)] = -y * x[i];
        }
        transfer
    }

    /// Adds what a rail does to its wheel.
    fn add_wheel(&mut self, side: usize, load: &mut Load) -> Result<(), Error> {
        let (position, transfer) = (self.position(side), self.transfer(side));
        let [forward, lateral, vertical, roll, pitch, yaw] = (transfer * self.velocity).into();
        let velocity = Velocity { forward, lateral, vertical, roll, pitch, yaw };
        let Self { rail, wheel, pairs, memory, .. } = self;
        let scene = scene(rail, wheel, &pairs[side]);
        let mut slopes = WrenchDerivatives { velocity: [[0.0; 6]; 6], friction: [0.0; 6] };
        let none = [0.0; 6];
        let mut by_position =
            WrenchByPosition { lateral: none, vertical: none, yaw: none, roll: none };
        let requested =
            Requested { by_velocity: Some(&mut slopes), by_position: Some(&mut by_position) };
        let wrench = scene.differentiate(&BodyState { position, velocity }, memory, requested)?;
        load.force += transfer.transpose() * Vector6::from(wrench.members());
        let by_velocity = Matrix6::from_fn(|row, column| slopes.velocity[row][column]);
        load.by_velocity += transfer.transpose() * by_velocity * transfer;
        let mut by_place = Matrix6::zeros();
        let WrenchByPosition { lateral, vertical, yaw, roll } = by_position;
        for (column, slope) in [(1, lateral), (2, vertical), (3, roll), (5, yaw)] {
            by_place.set_column(column, &Vector6::from(slope));
        }
        // a wheel's centre rises and sinks with roll
        let mut moved = Matrix6::identity();
        moved[(2, 3)] = Self::arm(side);
        load.by_place += transfer.transpose() * by_place * moved;
        self.wheels[side] = Some(wrench);
        Ok(())
    }

    /// One time step under forces and moments of the vehicle, which may depend on time, place and
    /// velocity.
    pub fn advance(&mut self, vehicle: impl Fn(&Self, &mut Load)) -> Result<(), Error> {
        let mut load = Load::default();
        self.add_wheel(0, &mut load)?;
        self.add_wheel(1, &mut load)?;
        load.force[2] += LOAD;
        // the spinning axle turns with the wheelset
        let spin = INERTIA[1] * self.velocity[4];
        load.force[3] += spin * self.velocity[5];
        load.force[5] -= spin * self.velocity[3];
        load.by_velocity[(3, 5)] += spin;
        load.by_velocity[(5, 3)] -= spin;
        vehicle(self, &mut load);

        let [x, y, z] = INERTIA;
        let mass = Matrix6::from_diagonal(&Vector6::new(MASS, MASS, MASS, x, y, z));
        let system = mass / self.step - load.by_velocity - load.by_place * self.step;
        let right = load.force + load.by_place * self.velocity * self.step;
        self.velocity += system.lu().solve(&right).ok_or(Error::Overflow)?;

        let [forward, lateral, vertical, roll, _, yaw] = self.velocity.into();
        let (place, step) = (&mut self.place, self.step);
        place.forward += step * forward;
        place.lateral += step * lateral;
        place.vertical += step * vertical;
        place.roll += step * roll / place.yaw.cos();
        place.yaw += step * yaw;
        self.time += step;
        Ok(())
    }

    /// Vertical force of the rail on a wheel, upward [N].
    pub fn support(&self, side: usize) -> f64 {
        self.wheels[side].map_or(0.0, |wrench| 0.0 - wrench.force[2])
    }
}

fn scene<'a>(
    rail: &'a PreparedProfile<f64>,
    wheel: &'a PreparedProfile<f64>,
    pair: &'a WheelPair<f64>,
) -> Scene<'a, f64> {
    let law = Law { model: Model::Strip, falling: None };
    Scene { rail, wheel, pair, strips: StripCount::Sixteen, law }
}

/// Of the wheelset that hunts and of the one that is lifted [m/s].
const SPEED: f64 = 5.0;

/// A free wheelset, moved to the side by 3 mm, rolls at 5 m/s: `t`, `y` and yaw.
pub fn hunting(duration: f64) -> Result<Vec<[f64; 3]>, Error> {
    let mut wheelset = Wheelset::new(3e-3, SPEED, 4e-3)?;
    let mut history = vec![];
    while wheelset.time < duration {
        wheelset.advance(|_, _| {})?;
        history.push([wheelset.time, wheelset.place.lateral, wheelset.place.yaw]);
    }
    Ok(history)
}

/// Weight of the wheelset along a grade of 3 %, and the moment of its brake [N, N m].
const GRADE: f64 = 0.03 * LOAD;
const BRAKE: f64 = 3000.0;
/// The brake holds up to this speed of the axle [rad/s].
const HOLD: f64 = 3e-3;
/// It is put on and taken off at these times [s].
pub const BRAKED: [f64; 2] = [0.2, 1.6];

/// A wheelset that rolls uphill at 1 m/s brakes to a stop, stands, and rolls back when the brake is
/// released: `t`, speed, speed of the rim, force of both rails along x.
pub fn stop_and_roll_back(duration: f64) -> Result<Vec<[f64; 4]>, Error> {
    let mut wheelset = Wheelset::new(0.0, 1.0, 2.5e-3)?;
    let mut history = vec![];
    while wheelset.time < duration {
        wheelset.advance(|wheelset, load| {
            load.force[0] -= GRADE;
            if wheelset.time > BRAKED[0] && wheelset.time < BRAKED[1] {
                let speed = wheelset.velocity[4] / HOLD;
                let slope = 1.0 / (1.0 + speed * speed).sqrt();
                load.force[4] -= BRAKE * speed * slope;
                load.by_velocity[(4, 4)] -= BRAKE / HOLD * slope * slope * slope;
            }
        })?;
        let along = wheelset.wheels.iter().flatten().map(|wrench| wrench.force[0]).sum();
        let [speed, rim] = [wheelset.velocity[0], -RADIUS * wheelset.velocity[4]];
        history.push([wheelset.time, speed, rim, along]);
    }
    Ok(history)
}

/// A jack under the right axle box of a wheelset that rolls at 5 m/s lifts it by 20 mm and sets it
/// down again within 1 s: `t`, height of the box over its first one, support of the right wheel, of
/// the left one.
pub fn lift() -> Result<Vec<[f64; 4]>, Error> {
    let (stiffness, damping) = (1e7, 1e5);
    let mut wheelset = Wheelset::new(0.0, SPEED, 4e-3)?;
    let height = |wheelset: &Wheelset| -wheelset.place.vertical - BOX * wheelset.place.roll;
    let first = height(&wheelset);
    let mut history = vec![];
    while wheelset.time < 1.2 {
        wheelset.advance(|wheelset, load| {
            let phase = std::f64::consts::TAU * wheelset.time;
            let wanted = 10e-3 * (1.0 - phase.cos());
            let rate = -wheelset.velocity[2] - BOX * wheelset.velocity[3];
            let push = stiffness * (wanted - height(wheelset) + first) - damping * rate;
            if push > 0.0 && wheelset.time < 1.0 {
                load.force[2] -= push;
                load.force[3] -= BOX * push;
                let arm = Vector6::new(0.0, 0.0, 1.0, BOX, 0.0, 0.0);
                load.by_velocity -= arm * arm.transpose() * damping;
                load.by_place -= arm * arm.transpose() * stiffness;
            }
        })?;
        let [right, left] = [wheelset.support(0), wheelset.support(1)];
        history.push([wheelset.time, height(&wheelset) - first, right, left]);
    }
    Ok(history)
}

fn main() -> Result<(), Error> {
    println!("hunting at 5 m/s:   t [s]   y [mm]   yaw [mrad]");
    for [t, y, yaw] in hunting(4.0)?.iter().skip(24).step_by(50) {
        println!("{t:25.1} {:8.2} {:12.2}", y * 1e3, yaw * 1e3);
    }
    println!("stop on a grade:    t [s]   speed [m/s]   rim [m/s]   force [kN]");
    for [t, speed, rim, force] in stop_and_roll_back(2.2)?.iter().skip(39).step_by(80) {
        println!("{t:25.1} {speed:13.4} {rim:11.4} {:12.2}", force / 1e3);
    }
    println!("lift at 5 m/s:      t [s]   box [mm]   right [kN]   left [kN]");
    for [t, height, right, left] in lift()?.iter().skip(24).step_by(25) {
        println!("{t:25.1} {:10.2} {:12.1} {:11.1}", height * 1e3, right / 1e3, left / 1e3);
    }
    Ok(())
}

/// The wheelset swings as long as Klingel's formula says, with the radii where its wheels touch 3
/// mm to the side.
#[test]
fn hunting_has_the_wave_of_klingel() -> Result<(), Error> {
    let mut moved = Wheelset::new(3e-3, 0.0, 1.0)?;
    let mut radius = |side| {
        moved.carried(side).map(|_| moved.memory.found().first().map_or(0.0, |found| found.radius))
    };
    let [right, left] = [radius(0)?, radius(1)?];
    let conicity = (right - left) / (2.0 * 3e-3);
    let half_wave = std::f64::consts::PI * (HALF_WIDTH * RADIUS / conicity).sqrt();

    let history = hunting(1.8)?;
    let crossings: Vec<f64> = history
        .windows(2)
        .filter(|pair| pair[0][1] * pair[1][1] < 0.0)
        .map(|pair| pair[0][0])
        .collect();
    assert_eq!(crossings.len(), 2);
    let rolled = SPEED * (crossings[1] - crossings[0]);
    assert!((rolled / half_wave - 1.0).abs() < 0.05, "{rolled} {half_wave}");
    // neither damped out nor growing
    let last = history.iter().skip(300).fold(0.0, |most: f64, [_, y, _]| most.max(y.abs()));
    assert!(last > 2e-3 && last < 3e-3, "{last}");
    Ok(())
}

/// It stands while the brake holds, both rails carrying the weight along the grade, and then rolls
/// back as a body of its inertia does.
#[test]
fn stops_stands_and_rolls_back() -> Result<(), Error> {
    let history = stop_and_roll_back(2.0)?;
    let at = |time: f64| history[(time / 2.5e-3).round() as usize - 1];
    let [_, speed, rim, force] = at(1.5);
    assert!(speed.abs() < 1e-3 && (speed - rim).abs() < 1e-5, "{speed} {rim}");
    assert!((force - GRADE).abs() < 1.0, "{force}");
    let expected = -GRADE / (MASS + INERTIA[1] / (RADIUS * RADIUS));
    let acceleration = (at(2.0)[1] - at(1.8)[1]) / 0.2;
    assert!((acceleration / expected - 1.0).abs() < 5e-3, "{acceleration} {expected}");
    Ok(())
}

/// A lifted wheel has no force, the other one carries what the jack leaves, and both carry about
/// half when it is down again.
#[test]
fn lifts_one_wheel_and_sets_it_down() -> Result<(), Error> {
    let history = lift()?;
    let highest = history.iter().copied().max_by(|a, b| a[1].total_cmp(&b[1])).unwrap_or_default();
    let [_, height, right, left] = highest;
    let carried = LOAD * BOX / (BOX + HALF_WIDTH);
    assert!(height > 14e-3 && right == 0.0, "{height} {right}");
    assert!((left / carried - 1.0).abs() < 0.02, "{left} {carried}");
    // (the wheelset still swings back from the flange to the middle)
    let [_, _, right, left] = history[history.len() - 1];
    assert!((right / left - 1.0).abs() < 0.1, "{right} {left}");
    assert!((right + left - LOAD).abs() < 0.02 * LOAD, "{right} {left}");
    Ok(())
}
