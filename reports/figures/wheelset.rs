//! A wheel S1002 on a rail 60E1, moved sideways under 80 kN: the forces on the wheel against its
//! lateral shift.

use super::panel::{Axis, Panel};
use super::{Drawn, Kind, picture, write};
use kstrip::contact::totals::StripCount;
use kstrip::forces::options::Model;
use kstrip::wheel_rail::forces::wrench::Law;
use kstrip::wheel_rail::scene::{Scene, Workspace};
use kstrip::wheel_rail::{BodyState, Position, Velocity};
use kstrip_testing::manchester::{profile, steel, zeroed};
use plotters::prelude::*;
use std::path::Path;

/// Radius of the wheel [m], speed [m/s], load [N].
const RADIUS: f64 = 0.46;
const SPEED: f64 = 20.0;
const LOAD: f64 = 80e3;
/// The wheel's centre is 750 mm from the middle of the track, the rail's origin 760.5325 mm.
const OFFSET: f64 = 10.5325e-3;

pub fn draw(folder: &Path) -> Drawn {
    let (rail, wheel) = (profile("uic60"), profile("s1002"));
    let pair = steel(RADIUS);
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
        let wrench = scene.solve(&BodyState { position, velocity }, &mut memory)?;
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
        let remark = "80 kN, 20 m/s, the axle turns at the speed divided by 0.46 m; creep forces \
             and pressure together";
        write(canvas, remark, (90.0, 38.0), 14)?;
        panel.draw(canvas)?;
        panel.curve(canvas, &along, blue, Kind::Line)?;
        panel.curve(canvas, &across, orange, Kind::Line)?;
        panel.name(canvas, "forward", along[8], (0.0, 8.0), blue)?;
        panel.name(canvas, "to the right", across[8], (0.0, -24.0), orange)
    })
}
