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
use kstrip::profile_file::ProfileFile;
use kstrip::profile_file::notes::KSTRIP_FORMAT_ANY;
use kstrip::status::Error;
use kstrip::wheel_rail::forces::wrench::{Law, Wrench};
use kstrip::wheel_rail::profile::PreparedProfile;
use kstrip::wheel_rail::scene::Scene;
use kstrip::wheel_rail::{BodyState, Position, Requested, Velocity, WheelPair};
use kstrip::wheelset::forces::{
    Wheelset, WheelsetByPosition, WheelsetDerivatives, WheelsetWorkspace,
};
use kstrip::wheelset::kinematics::Side;
use kstrip::wheelset::settle::WheelsetLoads;
use nalgebra::{Matrix6, Vector6};

/// From the middle of the wheelset to y = 0 of a wheel's profile, and from the middle of the track
/// to a rail's origin [m].
const HALF_WIDTH: f64 = 0.75;
const HALF_GAUGE: f64 = 0.760_532_5;
/// Radius of the wheels at y = 0 of their profile [m].
const RADIUS: f64 = 0.46;
/// From the middle of the wheelset to an axle box [m].
const BOX: f64 = 1.0;
/// Mass of the wheelset [kg]; moments of inertia about its x, its axle and its z [kg m^2].
const MASS: f64 = 1500.0;
const INERTIA: [f64; 3] = [800.0, 110.0, 800.0];
/// Load at the centre of the wheelset, its weight included [N].
const LOAD: f64 = 100e3;

/// A prepared profile from a file of `tests/data/wheel_rail`.
fn profile(name: &str) -> Result<Box<PreparedProfile<f64>>, Error> {
    let path = format!("{}/tests/data/wheel_rail/{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("the profile is part of the sources");
    let file = ProfileFile::open(text.as_bytes(), KSTRIP_FORMAT_ANY, text.len())?;
    let [mut y, mut z] = [vec![0.0; file.point_count()], vec![0.0; file.point_count()]];
    file.read(&mut y, &mut z);
    let mut prepared = Box::new(PreparedProfile::new());
    prepared.prepare(&y, &z, 0.0, 0.0)?;
    Ok(prepared)
}

/// Forces at the wheelset's centre in the track's axes [N], moments about its own axes [N m], and
/// their derivatives with respect to the six velocities and the six positions.
pub struct Load {
    pub force: Vector6<f64>,
    by_velocity: Matrix6<f64>,
    by_position: Matrix6<f64>,
}

/// A wheelset with equal wheels on two equal rails, and its motion.
pub struct Run {
    rail: Box<PreparedProfile<f64>>,
    wheel: Box<PreparedProfile<f64>>,
    memory: Box<WheelsetWorkspace<f64>>,
    pub position: Position<f64>,
    /// Velocity of the centre along x, y and z [m/s], and rates about the wheelset's own x, axle
    /// and z [rad/s].
    pub velocity: Vector6<f64>,
    pub time: f64,
    /// Time step [s].
    step: f64,
    /// Forces of the right rail and of the left rail on their wheels.
    pub wheels: [Wrench<f64>; 2],
}

/// The right and the left wheel on their rails.
fn wheelset<'a>(
    rail: &'a PreparedProfile<f64>, wheel: &'a PreparedProfile<f64>,
    [right, left]: &'a [WheelPair<f64>; 2],
) -> Wheelset<'a, f64> {
    let law = Law { model: Model::Strip, falling: None };
    let scene = |pair| Scene { rail, wheel, pair, strips: StripCount::Sixteen, law, table: None };
    Wheelset {
        scenes: [scene(right), scene(left)],
        sides: [Side::right(HALF_WIDTH, HALF_GAUGE), Side::left(HALF_WIDTH, HALF_GAUGE)],
    }
}

/// Materials and friction of the right pair and of the left pair.
fn pairs() -> [WheelPair<f64>; 2] {
    let right = WheelPair {
        wheel_radius: RADIUS,
        shear_modulus: 82e9,
        poisson_ratio: 0.28,
        friction: 0.3,
        ..WheelPair::default()
    };
    [right, WheelPair { left: 1, ..right }]
}

impl Run {
    /// A wheelset at a lateral position [m] that is in balance and rolls at a speed [m/s]; time
    /// step [s].
    pub fn new(lateral: f64, speed: f64, step: f64) -> Result<Self, Error> {
        let (rail, wheel) = (profile("uic60")?, profile("s1002")?);
        let mut memory = Box::new(WheelsetWorkspace::new());
        let start = BodyState {
            position: Position { lateral, ..Position::default() },
            velocity: Velocity { forward: speed, ..Velocity::default() },
        };
        let loads = WheelsetLoads { vertical: LOAD, ..WheelsetLoads::default() };
        let found = wheelset(&rail, &wheel, &pairs()).settle(&start, &loads, &mut memory)?;
        let Velocity { forward, lateral, vertical, roll, pitch, yaw } = found.state.velocity;
        Ok(Self {
            rail,
            wheel,
            memory,
            position: found.state.position,
            velocity: Vector6::new(forward, lateral, vertical, roll, pitch, yaw),
            time: 0.0,
            step,
            wheels: found.forces.wheel,
        })
    }

    /// Forces of both rails on the wheelset, with derivatives.
    fn forces_of_rails(&mut self) -> Result<Load, Error> {
        let [forward, lateral, vertical, roll, pitch, yaw] = self.velocity.into();
        let velocity = Velocity { forward, lateral, vertical, roll, pitch, yaw };
        let state = BodyState { position: self.position, velocity };
        let (mut by_velocity, mut by_position) =
            (WheelsetDerivatives::default(), WheelsetByPosition::default());
        let requested =
            Requested { by_velocity: Some(&mut by_velocity), by_position: Some(&mut by_position) };
        let pairs = pairs();
        let wheelset = wheelset(&self.rail, &self.wheel, &pairs);
        let found = wheelset.differentiate(&state, &mut self.memory, requested)?;
        self.wheels = found.wheel;
        // of the ten degrees of freedom the six of the wheelset: its rails do not move
        Ok(Load {
            force: Vector6::from(found.wrench.members()),
            by_velocity: Matrix6::from_fn(|row, column| by_velocity.velocity[row][column]),
            by_position: Matrix6::from_fn(|row, column| by_position.position[row][column]),
        })
    }

    /// One time step under forces and moments of the vehicle, which may depend on time, position
    /// and velocity.
    pub fn advance(&mut self, vehicle: impl Fn(&Self, &mut Load)) -> Result<(), Error> {
        let mut load = self.forces_of_rails()?;
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
        let system = mass / self.step - load.by_velocity - load.by_position * self.step;
        let right = load.force + load.by_position * self.velocity * self.step;
        self.velocity += system.lu().solve(&right).ok_or(Error::Overflow)?;

        let [_, lateral, vertical, roll, _, yaw] = self.velocity.into();
        let (position, step) = (&mut self.position, self.step);
        position.lateral += step * lateral;
        position.vertical += step * vertical;
        position.roll += step * roll / position.yaw.cos();
        position.yaw += step * yaw;
        self.time += step;
        Ok(())
    }

    /// Upward force of the rail on the right wheel (0) or on the left wheel (1) [N].
    pub fn support(&self, side: usize) -> f64 {
        0.0 - self.wheels[side].force[2]
    }
}

/// Of the wheelset that hunts and of the one that is lifted [m/s].
const SPEED: f64 = 5.0;

/// A free wheelset, moved to the side by 3 mm, rolls at 5 m/s: `t`, `y` and yaw.
pub fn hunting(duration: f64) -> Result<Vec<[f64; 3]>, Error> {
    let mut run = Run::new(3e-3, SPEED, 4e-3)?;
    let mut history = vec![];
    while run.time < duration {
        run.advance(|_, _| {})?;
        history.push([run.time, run.position.lateral, run.position.yaw]);
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
    let mut run = Run::new(0.0, 1.0, 2.5e-3)?;
    let mut history = vec![];
    while run.time < duration {
        run.advance(|run, load| {
            load.force[0] -= GRADE;
            if run.time > BRAKED[0] && run.time < BRAKED[1] {
                let speed = run.velocity[4] / HOLD;
                let slope = 1.0 / (1.0 + speed * speed).sqrt();
                load.force[4] -= BRAKE * speed * slope;
                load.by_velocity[(4, 4)] -= BRAKE / HOLD * slope * slope * slope;
            }
        })?;
        let along = run.wheels.iter().map(|wrench| wrench.force[0]).sum();
        let [speed, rim] = [run.velocity[0], -RADIUS * run.velocity[4]];
        history.push([run.time, speed, rim, along]);
    }
    Ok(history)
}

/// A jack under the right axle box of a wheelset that rolls at 5 m/s lifts it by 20 mm and sets it
/// down again within 1 s: `t`, height of the box over its first one, support of the right wheel, of
/// the left one.
pub fn lift() -> Result<Vec<[f64; 4]>, Error> {
    let (stiffness, damping) = (1e7, 1e5);
    let mut run = Run::new(0.0, SPEED, 4e-3)?;
    let height = |run: &Run| -run.position.vertical - BOX * run.position.roll;
    let first = height(&run);
    let mut history = vec![];
    while run.time < 1.2 {
        run.advance(|run, load| {
            let phase = std::f64::consts::TAU * run.time;
            let wanted = 10e-3 * (1.0 - phase.cos());
            let rate = -run.velocity[2] - BOX * run.velocity[3];
            let push = stiffness * (wanted - height(run) + first) - damping * rate;
            if push > 0.0 && run.time < 1.0 {
                load.force[2] -= push;
                load.force[3] -= BOX * push;
                let arm = Vector6::new(0.0, 0.0, 1.0, BOX, 0.0, 0.0);
                load.by_velocity -= arm * arm.transpose() * damping;
                load.by_position -= arm * arm.transpose() * stiffness;
            }
        })?;
        let [right, left] = [run.support(0), run.support(1)];
        history.push([run.time, height(&run) - first, right, left]);
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
    let moved = Run::new(3e-3, 0.0, 1.0)?;
    let radius = |side: usize| moved.memory.wheel[side].found().first().map(|found| found.radius);
    let (right, left) = (radius(0).unwrap_or_default(), radius(1).unwrap_or_default());
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
