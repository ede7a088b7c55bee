//! A wheel S1002 on a rail 60E1, moved sideways under 80 kN: the forces on the wheel over its lateral shift.

use super::panel::{Axis, Panel};
use super::{Drawn, Kind, picture, write};
use kstrip::contact::forces::StripCount;
use kstrip::solve::options::Model;
use kstrip::wheel_rail::scene::{Scene, Workspace};
use kstrip::wheel_rail::surface::Surface;
use kstrip::wheel_rail::wrench::Law;
use kstrip::wheel_rail::{Pair, Position, Velocity};
use plotters::prelude::*;
use std::error::Error;
use std::path::Path;

/// Radius of the wheel [m], speed [m/s], load [N].
const RADIUS: f64 = 0.46;
const SPEED: f64 = 20.0;
const LOAD: f64 = 80e3;
/// The wheel's centre is 750 mm from the middle of the track, the rail's origin 760.5325 mm.
const OFFSET: f64 = 10.5325e-3;

/// Memory of plain numbers, on the heap because it is large.
fn zeroed<T>() -> Box<T> {
    // SAFETY: all bits zero are a structure of numbers.
    unsafe { Box::new(std::mem::MaybeUninit::<T>::zeroed().assume_init()) }
}

fn profile(name: &str) -> Result<Box<Surface<f64>>, Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut points = [Vec::new(), Vec::new()];
    for record in
        csv::Reader::from_path(root.join(format!("tests/data/wheel_rail/{name}.csv")))?.records()
    {
        let record = record?;
        for (i, column) in points.iter_mut().enumerate() {
            column.push(1e-3 * record[i].parse::<f64>()?);
        }
    }
    let mut surface = zeroed::<Surface<f64>>();
    surface.prepare(&points[0], &points[1], 0.0, 0.0)?;
    Ok(surface)
}

pub fn draw(folder: &Path) -> Drawn {
    let (rail, wheel) = (profile("uic60")?, profile("s1002")?);
    let pair = Pair {
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
    };
    let law = Law { model: Model::Strip, falling: None };
    let scene = Scene { rail: &rail, wheel: &wheel, pair: &pair, strips: StripCount::Sixteen, law };
    let velocity = Velocity {
        forward: SPEED,
        lateral: 0.0,
        vertical: 0.0,
        roll: 0.0,
        pitch: -SPEED / RADIUS,
        yaw: 0.0,
    };
    let mut memory = zeroed::<Workspace<f64>>();
    let (mut along, mut across) = (Vec::new(), Vec::new());
    for i in -60..=60 {
        let shift = f64::from(i) * 1e-4;
        let position = Position { lateral: shift - OFFSET, ..Position::default() };
        let (vertical, _) = scene.height_for_load(&position, LOAD, None, &mut memory)?;
        let position = Position { vertical, ..position };
        let wrench = scene.solve(&position, &velocity, &mut memory, None, None)?;
        along.push((1e3 * shift, 1e-3 * wrench.force[0]));
        across.push((1e3 * shift, 1e-3 * wrench.force[1]));
    }
    let panel = Panel {
        left: 90.0,
        top: 66.0,
        width: 610.0,
        height: 340.0,
        x: Axis {
            label: "lateral shift of the wheel, toward its flange [mm]",
            limits: (-6.0, 6.0),
            ticks: vec![-6.0, -4.0, -2.0, 0.0, 2.0, 4.0, 6.0],
            decimals: 0,
            logarithmic: false,
        },
        y: Axis {
            label: "force on the wheel [kN]",
            limits: (-30.0, 30.0),
            ticks: vec![-30.0, -20.0, -10.0, 0.0, 10.0, 20.0, 30.0],
            decimals: 0,
            logarithmic: false,
        },
    };
    let (blue, orange) = (RGBColor(0x00, 0x45, 0x8b), RGBColor(0xc8, 0x50, 0x00));
    picture(&folder.join("lateral_shift.svg"), (730, 470), |canvas| {
        write(canvas, "A wheel S1002 on a rail 60E1, moved sideways", (90.0, 10.0), 19)?;
        let remark = "80 kN, 20 m/s, the axle turns at the speed over 0.46 m; creep forces and pressure together";
        write(canvas, remark, (90.0, 38.0), 14)?;
        panel.draw(canvas)?;
        panel.curve(canvas, &along, blue, Kind::Line)?;
        panel.curve(canvas, &across, orange, Kind::Line)?;
        panel.name(canvas, "forward", along[8], (0.0, 8.0), blue)?;
        panel.name(canvas, "to the right", across[8], (0.0, -24.0), orange)
    })
}
