//! Cost against error of a wheel S1002 on a rail UIC60: `cargo bench --bench wheels` writes the
//! table of `docs/guide/9-real-time.md` and its picture `docs/figures/wheel_cost.svg`.
//!
//! Costs are instructions, counted by callgrind in a second run of this program, so that they do
//! not depend on the load of the machine. Errors are those of the horizontal force on the wheel,
//! divided by friction times vertical load, against the direct call with 64 strips.
//!
//! The usual way of a vehicle program is one ellipse for each contact: Hertz's theory for the
//! curvatures at the touch point, then FASTSIM. Here it takes the touch points, loads, planes and
//! creepages of the direct call, and their cost is not counted.

#[path = "common/clock.rs"]
mod clock;
#[allow(dead_code)]
#[path = "common/lines.rs"]
mod lines;
#[allow(dead_code)]
#[path = "common/peer_methods.rs"]
mod peer_methods;
#[path = "../benches/peers/mod.rs"]
mod peers;
#[allow(dead_code)]
#[path = "accuracy/pictures.rs"]
mod pictures;

use kstrip::ffi::double;
use kstrip::ffi::types::kstrip_table;
use kstrip::table::{TableSpec, fill_part, finish};
use kstrip_testing::patch_reference::{number, rows_of};
use kstrip_testing::prelude::*;
use lines::Lines;
use peer_methods::input_of;
use peers::fastsim::{Bound, Flexibility, Grid, Layout};
use pictures::{
    AMBER, Align, Axis, BLUE, Drawn, INK, PURPLE, Plot, VERMILION, dot, line, picture, write,
};
use std::hint::black_box;
use std::path::PathBuf;
use std::process::Command;

const POSES: usize = 500;
/// Poses whose instructions are counted.
const COUNTED: usize = 100;
/// Rounds of all poses of which the shortest gives the time.
const ROUNDS: usize = 40;
/// The place of the wheel's profile in a wheelset that is not shifted [m].
const OFFSET: f64 = 10.5325e-3;
const SPEED: f64 = 20.0;
const RADIUS: f64 = 0.46;
const FRICTION: f64 = 0.3;
/// The gap is fitted by a parabola over this distance to both sides of its minimum [m].
const CURVATURE_OVER: f64 = 1e-3;
/// A flatter gap than of this radius [m] counts as one of this radius.
const FLATTEST: f64 = 2.0;
/// Times that ORVD is said to take for a pose that it has met before [µs]. No error goes with them,
/// and the program was not run here.
const ORVD: [f64; 2] = [5.0, 9.0];
/// The way whose rate makes these times comparable: the time and the instructions of a lookup.
const AT_RATE_OF: Way = Way::Table(16);

/// A method, with its number of strips.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Way {
    Fastsim,
    Direct(i32),
    Table(i32),
}

const WAYS: [Way; 9] = [
    Way::Fastsim,
    Way::Table(12),
    Way::Table(16),
    Way::Table(32),
    Way::Direct(4),
    Way::Direct(8),
    Way::Direct(16),
    Way::Direct(32),
    Way::Direct(64),
];

/// An ellipse at a touch point: radii along and across, load, creepages.
type Touch = [f64; 6];

/// A position and a velocity of the wheel, and its ellipses.
#[derive(Clone)]
struct Pose {
    load: f64,
    state: BodyState<f64>,
    touches: Vec<Touch>,
}

struct Stand {
    rail: Box<PreparedProfile<f64>>,
    wheel: Box<PreparedProfile<f64>>,
    memory: Box<Workspace<f64>>,
    grid: Grid<10, 10>,
}

fn folder() -> PathBuf {
    root().join("target/wheels")
}

fn table_file(strips: i32) -> PathBuf {
    folder().join(format!("{strips}.table"))
}

fn pair(strips: i32) -> WheelPair<f64> {
    WheelPair { strips, ..manchester::steel(RADIUS) }
}

fn count(strips: i32) -> StripCount {
    StripCount::from_number(strips).expect("a strip count")
}

fn members(velocity: &Velocity<f64>) -> [f64; 6] {
    let Velocity { forward, lateral, vertical, roll, pitch, yaw } = *velocity;
    [forward, lateral, vertical, roll, pitch, yaw]
}

/// `1/R` of the gap across the rolling direction at a minimum of the gap, and its index.
fn curvature(memory: &Workspace<f64>, along: f64) -> (f64, usize) {
    let gap = &memory.gap;
    let used = 0..gap.count as usize;
    let near = used.filter(|i| (gap.along[*i] - along).abs() < 8e-3);
    let lowest = near.min_by(|i, j| gap.distance[*i].total_cmp(&gap.distance[*j]));
    let lowest = lowest.expect("points near a contact");
    let (mut sums, mut rights) = (Matrix3::zeros(), nalgebra::Vector3::zeros());
    for i in 0..gap.count as usize {
        let s = (gap.along[i] - gap.along[lowest]) / CURVATURE_OVER;
        if s.abs() <= 1.0 {
            let powers = nalgebra::Vector3::new(1.0, s, s * s);
            sums += powers * powers.transpose();
            rights += powers * gap.distance[i];
        }
    }
    let solved = sums.lu().solve(&rights).expect("points");
    (2.0 * solved[2] / (CURVATURE_OVER * CURVATURE_OVER), lowest)
}

impl Stand {
    fn new() -> Self {
        let [rail, wheel] = ["uic60", "s1002"].map(manchester::profile);
        Self { rail, wheel, memory: zeroed(), grid: Grid::new(Layout::StripCentres) }
    }

    fn direct(&mut self, state: &BodyState<f64>, strips: i32) -> Wrench<f64> {
        let mut wrench = MaybeUninit::zeroed();
        let status = double::kstrip_wheel_on_rail(
            Some(&self.rail),
            Some(&self.wheel),
            Some(&pair(strips)),
            Some(&state.position),
            Some(&state.velocity),
            None,
            Some(&mut self.memory),
            Some(&mut wrench),
            None,
            None,
        );
        assert!(status >= 0, "{status}");
        // SAFETY: written without an error, and a structure of numbers.
        unsafe { wrench.assume_init() }
    }

    fn on_table(&mut self, state: &BodyState<f64>, table: &[u8]) -> Option<Wrench<f64>> {
        let mut wrench = MaybeUninit::zeroed();
        // SAFETY: as many bytes as said.
        let status = unsafe {
            double::kstrip_wheel_on_table(
                Some(&kstrip_table { data: table.as_ptr(), bytes: table.len() as u32, only: 0 }),
                Some(&pair(0)),
                Some(&state.position),
                Some(&state.velocity),
                None,
                Some(&mut self.memory),
                Some(&mut wrench),
                None,
                None,
            )
        };
        // SAFETY: a structure of numbers.
        (status >= 0).then_some(unsafe { wrench.assume_init() })
    }

    /// The force of FASTSIM on an ellipse of Hertz.
    fn fastsim(&self, touch: &Touch) -> [f64; 2] {
        let [along, across, load, longitudinal, lateral, spin] = *touch;
        let steel = Material { shear_modulus: 82e9, poisson_ratio: 0.28 };
        let radii = Radii {
            lower_x: f64::INFINITY,
            lower_y: f64::INFINITY,
            upper_x: along,
            upper_y: across,
        };
        let pair = combine(&steel, &steel).expect("steel");
        let (contact, ..) = from_hertz(&radii, &pair, load, FRICTION).expect("an ellipse");
        let input = input_of(&contact, &Creepage { longitudinal, lateral, spin });
        let found = peers::fastsim::solve::<10, 10, 10>(
            &self.grid,
            &input,
            Flexibility::Three,
            Bound::Parabolic,
        );
        [found.fx, found.fy].map(|force| force * FRICTION * load)
    }

    /// The ellipses at the touch points of the contacts of the last direct call, and the
    /// horizontal force on the wheel from FASTSIM on them.
    fn usual(&self, velocity: &Velocity<f64>) -> (Vec<Touch>, [f64; 2]) {
        let (mut touches, mut force) = (vec![], [0.0; 2]);
        for contact in self.memory.found() {
            let (curvature, lowest) = curvature(&self.memory, contact.along);
            let radius = 1.0 / curvature.max(1.0 / FLATTEST);
            let motion = contact.motion(&members(velocity));
            let slip = [motion.slip_x, motion.slip_y, motion.spin_rate];
            let [vx, vy, spin] = slip.map(|slip| slip / motion.rolling_speed);
            let load = contact.normal_force;
            let touch = [self.memory.gap.rolling_radius[lowest], radius, load, vx, vy, spin];
            let [fx, fy] = self.fastsim(&touch);
            for (k, sum) in force.iter_mut().enumerate() {
                let here =
                    load * contact.normal[k] + fx * contact.slip_x[k] + fy * contact.slip_y[k];
                *sum -= contact.share * here;
            }
            touches.push(touch);
        }
        (touches, force)
    }

    fn poses(&mut self) -> Vec<Pose> {
        let mut random = Random::new(71);
        let bar = |k: usize| {
            if k.is_multiple_of(100) {
                println!("{k} of {POSES} poses")
            }
        };
        let mut pose = |k: usize| {
            bar(k);
            let load = random.between(5e3, 200e3);
            let lateral = random.between(-8e-3, 8e-3) - OFFSET;
            let pitch = -SPEED / RADIUS * (1.0 + random.between(-4e-3, 4e-3));
            let velocity = Velocity {
                forward: SPEED,
                pitch,
                lateral: random.between(-0.08, 0.08),
                ..Velocity::default()
            };
            let position = Position { lateral, ..Position::default() };
            let mut vertical = MaybeUninit::zeroed();
            // SAFETY: without a table nothing is read but these.
            let status = unsafe {
                double::kstrip_height_for_load(
                    Some(&self.rail),
                    Some(&self.wheel),
                    Some(&pair(64)),
                    Some(&position),
                    load,
                    None,
                    None,
                    None,
                    Some(&mut self.memory),
                    Some(&mut vertical),
                )
            };
            assert!(status >= 0, "{status}");
            // SAFETY: a number.
            let vertical = unsafe { vertical.assume_init() };
            let state = BodyState { position: Position { vertical, ..position }, velocity };
            Pose { load, state, touches: vec![] }
        };
        (0..POSES).map(&mut pose).collect()
    }
}

/// Fills a table, and writes it for the run that counts.
fn fill(stand: &mut Stand, strips: i32) -> Vec<u8> {
    println!("a table of {strips} strips");
    let spec = TableSpec {
        lateral_from: -8.1e-3 - OFFSET,
        lateral_to: 8.1e-3 - OFFSET,
        load: 220e3,
        strips: strips as u32,
        ..*zeroed()
    };
    let pair = pair(0);
    let scene = Scene {
        rail: &*stand.rail,
        wheel: &*stand.wheel,
        pair: &pair,
        strips: StripCount::Sixteen,
        law: Law { model: Model::Strip, falling: None },
        table: None,
    };
    let memory = &mut stand.memory;
    let [bytes, parts] = spec.size(&stand.wheel).expect("a size");
    let mut block = vec![0; bytes as usize];
    spec.begin_table(&scene, memory, &mut block).expect("a table");
    for part in 0..parts as usize {
        fill_part(&scene, part, memory, &mut block).expect("a part");
    }
    let report = finish(&scene, 20, memory, &mut block).expect("a table");
    block.truncate(report.bytes as usize);
    std::fs::write(table_file(strips), &block).expect("target/ is writable");
    block
}

/// What callgrind counts: it sets its counter to zero on entry and writes it on return.
#[inline(never)]
#[unsafe(no_mangle)]
fn counted_wheels(stand: &mut Stand, way: &Way, poses: &[Pose], table: &[u8]) {
    for Pose { state, touches, .. } in poses {
        match way {
            Way::Fastsim => touches.iter().for_each(|touch| {
                black_box(stand.fastsim(touch));
            }),
            Way::Direct(strips) => {
                black_box(stand.direct(state, *strips));
            }
            Way::Table(_) => {
                black_box(stand.on_table(state, table));
            }
        }
    }
}

/// The poses as numbers, for the run that counts.
fn write_poses(poses: &[Pose]) {
    let mut text = String::new();
    for Pose { load, state, touches } in poses {
        let BodyState { position, velocity } = state;
        let head = [*load, position.lateral, position.vertical, velocity.lateral, velocity.pitch];
        let all = head.into_iter().chain(touches.iter().flatten().copied());
        text += &all.map(|x| format!("{x:e}")).collect::<Vec<_>>().join(" ");
        text.push('\n');
    }
    std::fs::write(folder().join("poses"), text).expect("target/ is writable");
}

fn read_poses() -> Vec<Pose> {
    let text = std::fs::read_to_string(folder().join("poses")).expect("poses");
    let pose = |line: &str| {
        let numbers: Vec<f64> = line.split(' ').map(|x| x.parse().expect("a number")).collect();
        let (head, touches) = numbers.split_at(5);
        let position = Position { lateral: head[1], vertical: head[2], ..Position::default() };
        let velocity =
            Velocity { forward: SPEED, lateral: head[3], pitch: head[4], ..Velocity::default() };
        let touches = touches.chunks(6).map(|touch| touch.try_into().expect("six")).collect();
        Pose { load: head[0], state: BodyState { position, velocity }, touches }
    };
    text.lines().map(pose).collect()
}

/// Instructions of a wheel by each way, from a run of this program under callgrind.
fn instructions() -> Vec<f64> {
    let counts = folder().join("counts");
    let done = Command::new("valgrind")
        .args(["--quiet", "--tool=callgrind"])
        .arg(format!("--callgrind-out-file={}", counts.display()))
        .args(["--zero-before=counted_wheels", "--dump-after=counted_wheels"])
        .arg(std::env::current_exe().expect("this program"))
        .arg("count")
        .status()
        .expect("valgrind");
    assert!(done.success(), "{done}");
    let count = |k: usize| {
        let text = std::fs::read_to_string(counts.with_extension(k.to_string())).expect("a count");
        let total = text.lines().find_map(|line| {
            line.strip_prefix("totals: ").or_else(|| line.strip_prefix("summary: "))
        });
        total.expect("a total").trim().parse::<f64>().expect("a number") / COUNTED as f64
    };
    (1..=WAYS.len()).map(count).collect()
}

/// Mean and 95th percentile.
fn figures(mut errors: Vec<f64>) -> [f64; 2] {
    errors.sort_by(f64::total_cmp);
    let p95 = errors[(errors.len() * 95 / 100).min(errors.len() - 1)];
    [errors.iter().sum::<f64>() / errors.len() as f64, p95]
}

fn horizontal(wrench: &Wrench<f64>) -> [f64; 2] {
    [wrench.force[0], wrench.force[1]]
}

/// Mean error of a way against conformal CONTACT: S1002 on UIC60 without yaw.
fn against_contact(stand: &mut Stand, way: Way, table: &[u8]) -> f64 {
    let mut errors = vec![];
    for row in rows_of("wheel_rail", "runs.csv") {
        let is_pair = &row["rail"] == "uic60" && &row["wheel"] == "s1002";
        let is_conformal = !row["conformal_FX_N"].is_empty();
        if !is_pair || !is_conformal || number(&row, "yaw_rad") != 0.0 {
            continue;
        }
        let position =
            Position { lateral: number(&row, "lateral_mm") * 1e-3, ..Position::default() };
        let velocity = Velocity {
            forward: SPEED,
            lateral: number(&row, "lateral_mm_s") * 1e-3,
            pitch: number(&row, "pitch_rad_s"),
            ..Velocity::default()
        };
        let strips = if let Way::Direct(strips) = way { strips } else { 64 };
        let pair = pair(strips);
        let scene = Scene {
            rail: &*stand.rail,
            wheel: &*stand.wheel,
            pair: &pair,
            strips: count(strips),
            law: Law { model: Model::Strip, falling: None },
            table: None,
        };
        let support = number(&row, "support_N");
        let found = scene.height_for_load(&position, support, Some(&velocity), &mut stand.memory);
        let vertical = found.expect("a height").0;
        let state = BodyState { position: Position { vertical, ..position }, velocity };
        let force = match way {
            Way::Direct(_) => horizontal(&stand.direct(&state, strips)),
            Way::Table(_) => horizontal(&stand.on_table(&state, table).expect("in the table")),
            Way::Fastsim => {
                stand.direct(&state, strips);
                stand.usual(&velocity).1
            }
        };
        let [fx, fy] = ["conformal_FX_N", "conformal_FY_N"].map(|name| number(&row, name));
        let bound = FRICTION * number(&row, "normal_force_N");
        errors.push((force[0] + fx).hypot(force[1] + fy) / bound);
    }
    assert_eq!(errors.len(), 15);
    figures(errors)[0]
}

struct Row {
    way: Way,
    instructions: f64,
    microseconds: f64,
    errors: [f64; 2],
    contact: f64,
}

impl Row {
    fn name(&self) -> String {
        match self.way {
            Way::Fastsim => "ellipse at the touch point, FASTSIM 10 x 10".to_owned(),
            Way::Direct(strips) => format!("`kstrip_wheel_on_rail`, {strips} strips"),
            Way::Table(strips) => format!("`kstrip_wheel_on_table`, {strips} strips"),
        }
    }
}

struct Page(String);

impl Lines for Page {
    fn text(&mut self) -> &mut String {
        &mut self.0
    }
}

fn write_page(rows: &[Row]) {
    let mut page = Page(String::new());
    page.header(&[
        "method",
        "thousand instructions",
        "µs",
        "95th percentile",
        "mean against CONTACT",
    ]);
    for row in rows {
        let is_reference = row.way == Way::Direct(64);
        let p95 = if is_reference { "–".to_owned() } else { format!("{:.3}", row.errors[1]) };
        let thousands = row.instructions / 1e3;
        let cost =
            if thousands < 100.0 { format!("{thousands:.1}") } else { format!("{thousands:.0}") };
        let time = if row.microseconds < 10.0 { 1 } else { 0 };
        let time = format!("{:.time$}", row.microseconds);
        page.row([row.name(), cost, time, p95, format!("{:.3}", row.contact)]);
    }
    let path = root().join("docs/guide/9-real-time.md");
    let [begin, end] = ["begin", "end"].map(|which| format!("<!-- wheels: {which} -->\n"));
    let whole = read(&path);
    let (head, rest) = whole.split_once(&begin).expect("the place of the table");
    let (_, tail) = rest.split_once(&end).expect("the end of the table");
    std::fs::write(&path, format!("{head}{begin}{}{end}{tail}", page.0)).expect("a page");
}

/// Instructions that a lookup executes in the times of ORVD.
fn orvd(rows: &[Row]) -> [f64; 2] {
    let lookup = rows.iter().find(|row| row.way == AT_RATE_OF).expect("the table");
    ORVD.map(|time| time * lookup.instructions / lookup.microseconds)
}

fn draw(rows: &[Row]) -> Drawn {
    picture(&root().join("docs/figures/wheel_cost.svg"), (640, 480), |canvas| {
        let title = "Error against cost: a wheel S1002 on a rail UIC60";
        write(canvas, title, (60.0, 22.0), 17, Align::Left, INK)?;
        let ticks = [1e3, 1e4, 1e5, 1e6].map(|at: f64| (at, format!("{} thousand", at / 1e3)));
        let plot = Plot {
            left: 60.0,
            top: 66.0,
            width: 540.0,
            height: 340.0,
            x: Axis { low: 1e3, high: 4e6, logarithmic: true, ticks: ticks.to_vec() },
            y: Axis::logarithmic(2e-3, 1.0, &[0.003, 0.01, 0.03, 0.1, 0.3, 1.0]),
        };
        plot.frame(canvas)?;
        plot.title(canvas, "error of the force [μ times load], not exceeded by 95 % of the poses")?;
        for row in rows.iter().filter(|row| row.way != Way::Direct(64)) {
            let (ink, label) = match row.way {
                Way::Fastsim => (AMBER, "FASTSIM".to_owned()),
                Way::Direct(strips) => (VERMILION, strips.to_string()),
                Way::Table(strips) => (BLUE, strips.to_string()),
            };
            let (x, y) = plot.at(row.instructions, row.errors[1]);
            dot(canvas, (x, y), 4.5, ink, true)?;
            write(canvas, &label, (x + 9.0, y - 8.0), 13, Align::Left, ink)?;
        }
        // without an error: at the lower edge
        let [from, to] = orvd(rows).map(|cost| plot.at(cost, 2.2e-3));
        line(canvas, &[from, to], PURPLE, 4.0)?;
        write(canvas, "ORVD", (to.0 + 8.0, to.1), 13, Align::Left, PURPLE)?;
        let middle = plot.left + 0.5 * plot.width;
        write(canvas, "instructions of a wheel", (middle, 438.0), 13, Align::Centre, INK)?;
        let keys = [
            (AMBER, "an ellipse at each touch point"),
            (BLUE, "contact table, by strips"),
            (VERMILION, "direct call, by strips"),
        ];
        for (x, (ink, text)) in [66.0, 290.0, 466.0].into_iter().zip(keys) {
            dot(canvas, (x, 462.0), 4.5, ink, true)?;
            write(canvas, text, (x + 10.0, 462.0), 13, Align::Left, INK)?;
        }
        Ok(())
    })
}

fn main() -> Drawn {
    let mut stand = Stand::new();
    if std::env::args().nth(1).as_deref() == Some("count") {
        let poses: Vec<Pose> = read_poses().into_iter().take(COUNTED).collect();
        for way in &WAYS {
            let table = match way {
                Way::Table(strips) => std::fs::read(table_file(*strips))?,
                _ => vec![],
            };
            counted_wheels(&mut stand, way, &poses, &table);
        }
        return Ok(());
    }
    std::fs::create_dir_all(folder())?;
    let mut poses = stand.poses();
    let mut errors = WAYS.map(|_| vec![]);
    let tables = WAYS.map(|way| match way {
        Way::Table(strips) => fill(&mut stand, strips),
        _ => vec![],
    });
    for pose in &mut poses {
        let reference = horizontal(&stand.direct(&pose.state, 64));
        let (touches, usual) = stand.usual(&pose.state.velocity);
        pose.touches = touches;
        for ((way, table), errors) in WAYS.iter().zip(&tables).zip(&mut errors) {
            let force = match way {
                Way::Fastsim => usual,
                Way::Direct(strips) => horizontal(&stand.direct(&pose.state, *strips)),
                Way::Table(_) => match stand.on_table(&pose.state, table) {
                    Some(wrench) => horizontal(&wrench),
                    None => return Err("a pose outside the table".into()),
                },
            };
            let off = (force[0] - reference[0]).hypot(force[1] - reference[1]);
            errors.push(off / (FRICTION * pose.load));
        }
    }
    write_poses(&poses);
    let rows: Vec<Row> = instructions()
        .into_iter()
        .zip(WAYS.iter().zip(&tables).zip(errors))
        .map(|(instructions, ((way, table), errors))| {
            let microseconds = (0..ROUNDS)
                .map(|_| clock::took(|| counted_wheels(&mut stand, way, &poses, table)))
                .fold(f64::INFINITY, f64::min)
                * (1e-3 / POSES as f64);
            let contact = against_contact(&mut stand, *way, table);
            Row { way: *way, instructions, microseconds, errors: figures(errors), contact }
        })
        .collect();
    for row in &rows {
        let Row { instructions, microseconds, errors, contact, .. } = row;
        println!(
            "{}: {instructions:.0}, {microseconds:.1} µs, {errors:.4?}, {contact:.4}",
            row.name()
        );
    }
    println!("ORVD: {:.0?} instructions at the rate of a lookup", orvd(&rows));
    write_page(&rows);
    draw(&rows)
}
