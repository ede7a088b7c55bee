//! Scenes of wheel on rail: the Manchester benchmark beside CONTACT, and the wheelset of
//! `examples/wheelset.rs`.

#[allow(dead_code)]
#[path = "../../examples/wheelset.rs"]
mod wheelset;

use super::palette::{BLUE, VERMILION};
use super::panel::{Axis, Panel};
use super::{Canvas, Drawn, Kind, picture, write};
use kstrip_testing::manchester::{self, Wheel, Wheelset};
use plotters::prelude::*;
use std::path::Path;

fn axis(label: &'static str, ticks: &[f64], decimals: usize) -> Axis {
    let limits = (ticks[0], ticks[ticks.len() - 1]);
    Axis { label, limits, ticks: ticks.to_vec(), decimals, logarithmic: false }
}

/// The panels of a picture beside and below each other: place, and its axes.
fn panel(column: f64, row: f64, x: Axis, y: Axis) -> Panel {
    Panel {
        left: 90.0 + 370.0 * column,
        top: 66.0 + 260.0 * row,
        width: 270.0,
        height: 180.0,
        x,
        y,
    }
}

/// What is shown of a wheel.
type Value = fn(&Wheel) -> f64;

fn draw_manchester(folder: &Path) -> Drawn {
    let theirs = manchester::contact();
    let mut wheelset = Wheelset::default();
    let shifts: Vec<f64> = (0..=100).map(|i| 0.1 * f64::from(i)).collect();
    let ours: Vec<[Wheel; 2]> = shifts.iter().map(|shift| wheelset.at(shift * 1e-3)).collect();
    let shift = || axis("lateral shift [mm]", &[0.0, 2.0, 4.0, 6.0, 8.0, 10.0], 0);
    picture(&folder.join("manchester.svg"), (760, 580), |canvas| {
        write(canvas, "Wheels S1002 on rails 60E1, Manchester benchmark A-2.2", (90.0, 10.0), 19)?;
        let remark = "lines: kstrip; dots: CONTACT; blue: right wheel, orange: left wheel; forces \
             on the rail";
        write(canvas, remark, (90.0, 38.0), 14)?;
        let panels: [(f64, f64, Axis, Value); 4] = [
            (0.0, 0.0, axis("angle [degrees]", &[-80.0, -60.0, -40.0, -20.0, 0.0], 0), |w| w.angle),
            (1.0, 0.0, axis("peak pressure [MPa]", &[0.0, 1000.0, 2000.0, 3000.0], 0), |w| w.peak),
            (0.0, 1.0, axis("force forward [kN]", &[-3.0, -1.5, 0.0, 1.5, 3.0], 1), |w| {
                w.fx * 1e-3
            }),
            (1.0, 1.0, axis("to the right [kN]", &[-5.0, 0.0, 5.0, 10.0, 15.0], 0), |w| {
                w.fy * 1e-3
            }),
        ];
        for (column, row, y, value) in panels {
            let panel = panel(column, row, shift(), y);
            panel.draw(canvas)?;
            for (side, colour) in [BLUE, VERMILION].into_iter().enumerate() {
                let curve: Vec<(f64, f64)> = shifts
                    .iter()
                    .zip(&ours)
                    .map(|(shift, both)| (*shift, value(&both[side])))
                    .collect();
                panel.curve(canvas, &curve, colour, Kind::Line)?;
                for (left, shift, wheel) in &theirs {
                    if usize::from(*left) == side {
                        let at = panel.at((*shift, value(wheel)));
                        let dot = Circle::new(
                            super::place(at.0, at.1),
                            3 * super::SCALE,
                            colour.filled(),
                        );
                        canvas.draw(&dot)?;
                    }
                }
            }
        }
        Ok(())
    })
}

/// Name, colour, points over time, and the time that the name stands beside.
type Curve<'a> = (&'a str, RGBColor, Vec<(f64, f64)>, f64);

/// Curves over time.
fn history(canvas: &Canvas, panel: &Panel, curves: [Curve; 2]) -> Drawn {
    panel.draw(canvas)?;
    for (name, colour, points, beside) in curves {
        panel.curve(canvas, &points, colour, Kind::Line)?;
        let last = points.iter().find(|(t, _)| *t >= beside).copied().unwrap_or_default();
        panel.name(canvas, name, last, (4.0, -20.0), colour)?;
    }
    Ok(())
}

fn draw_wheelset(folder: &Path) -> Drawn {
    let failed = |error| format!("{error:?}");
    let hunting = wheelset::hunting(4.0).map_err(failed)?;
    let stop = wheelset::stop_and_roll_back(2.4).map_err(failed)?;
    let lift = wheelset::lift().map_err(failed)?;
    let time = |ticks: &[f64], decimals| axis("time [s]", ticks, decimals);
    let below = |row: usize, x: Axis, y: Axis| Panel {
        left: 90.0,
        top: 96.0 + 265.0 * row as f64,
        width: 640.0,
        height: 170.0,
        x,
        y,
    };
    picture(&folder.join("wheelset.svg"), (760, 860), |canvas| {
        write(canvas, "A wheelset S1002 on rails 60E1 (examples/wheelset.rs)", (90.0, 10.0), 19)?;
        let remark = "one implicit rule with the derivatives of the library for rolling, \
             standstill and lift";
        write(canvas, remark, (90.0, 38.0), 14)?;
        let titles = [
            "displaced by 3 mm at 5 m/s: it hunts",
            "uphill on a grade of 3 %: the brake stops and holds it, and it rolls back when the \
             brake opens",
            "a jack under the right axle box lifts one wheel and sets it down, at 5 m/s",
        ];
        for (row, title) in titles.into_iter().enumerate() {
            write(canvas, title, (90.0, 72.0 + 265.0 * row as f64), 14)?;
        }
        let x = time(&[0.0, 1.0, 2.0, 3.0, 4.0], 0);
        let shown = below(0, x, axis("shift [mm], yaw [mrad]", &[-4.0, -2.0, 0.0, 2.0, 4.0], 0));
        let lateral = hunting.iter().map(|[t, y, _]| (*t, y * 1e3)).collect();
        let yaw = hunting.iter().map(|[t, _, yaw]| (*t, yaw * 1e3)).collect();
        history(canvas, &shown, [("shift", BLUE, lateral, 1.85), ("yaw", VERMILION, yaw, 1.25)])?;
        let x = time(&[0.0, 0.6, 1.2, 1.8, 2.4], 1);
        let shown = below(
            1,
            x,
            axis("speed [m/s], force [10 kN]", &[-1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5], 1),
        );
        let speed = stop.iter().map(|[t, speed, ..]| (*t, *speed)).collect();
        let force = stop.iter().map(|[t, _, _, force]| (*t, force * 1e-4)).collect();
        history(
            canvas,
            &shown,
            [
                ("speed", BLUE, speed, 0.05),
                ("force of the rails on the wheels", VERMILION, force, 0.7),
            ],
        )?;
        let x = time(&[0.0, 0.3, 0.6, 0.9, 1.2], 1);
        let shown =
            below(2, x, axis("support of the rail [kN]", &[0.0, 50.0, 100.0, 150.0, 200.0], 0));
        let right = lift.iter().map(|[t, _, right, _]| (*t, right * 1e-3)).collect();
        let left = lift.iter().map(|[t, _, _, left]| (*t, left * 1e-3)).collect();
        history(
            canvas,
            &shown,
            [("right wheel", BLUE, right, 0.4), ("left wheel", VERMILION, left, 0.4)],
        )
    })
}

pub fn draw(folder: &Path) -> Drawn {
    draw_manchester(folder)?;
    draw_wheelset(folder)
}
