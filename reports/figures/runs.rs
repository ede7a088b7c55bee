//! Pictures of the tour, of the page on models and of the cookbook: the wheel of these pages, of
//! 0.46 m on a rail head of 0.30 m, 80 kN.

use super::palette::{BLUE, VERMILION};
use super::panel::{Axis, Panel};
use super::{Drawn, INK, Kind, arrow, font, line, picture, place, write};
use kstrip::contact::Contact;
use kstrip::contact::creepage::Creepage;
use kstrip::contact::hertz::{self, Radii};
use kstrip::contact::totals::StripCount;
use kstrip::forces::field::Field;
use kstrip::forces::options::{Model, Options};
use kstrip::forces::{self, strips};
use kstrip::motion::{self, Motion};
use kstrip::status::Error;
use kstrip::strip_1967::strip::State;
use plotters::prelude::*;
use std::path::Path;

const GREY: RGBColor = RGBColor(0x66, 0x66, 0x66);

fn wheel_on_rail() -> Result<Contact<f64>, Error> {
    let radii =
        Radii { lower_x: f64::INFINITY, lower_y: 0.30, upper_x: 0.46, upper_y: f64::INFINITY };
    let ellipse = hertz::hertz(&radii, 80e3, 82e9, 0.28)?;
    Ok(Contact {
        a: ellipse.a,
        b: ellipse.b,
        normal_force: 80e3,
        shear_modulus: 82e9,
        poisson_ratio: 0.28,
        friction: 0.3,
        mismatch: 0.0,
    })
}

/// Colour between pale and dark, 0 to 1.
fn shade(share: f64) -> RGBColor {
    const STOPS: [[f64; 3]; 4] =
        [[255.0, 250.0, 225.0], [253.0, 190.0, 100.0], [215.0, 95.0, 25.0], [105.0, 30.0, 10.0]];
    let at = 3.0 * share.clamp(0.0, 1.0);
    let i = (at as usize).min(2);
    let part = at - i as f64;
    let mix = |k: usize| (STOPS[i][k] + part * (STOPS[i + 1][k] - STOPS[i][k])).round() as u8;
    RGBColor(mix(0), mix(1), mix(2))
}

/// Size and direction of the traction inside the patch, by STRIP, one colour for each piece of a
/// strip.
fn draw_traction_map(folder: &Path) -> Drawn {
    let contact = wheel_on_rail()?;
    let creepage = Creepage { longitudinal: 3e-4, lateral: 0.0, spin: 0.6 };
    let options = Options { model: Model::Strip, strips: StripCount::ThirtyTwo };
    let field = Field::new(&contact, &creepage, &options)?;
    let mut strips = Vec::new();
    strips::strips(&contact, &creepage, &options, &mut |strip| strips.push(strip))?;
    let most = 330e6;
    let panel = Panel {
        left: 90.0,
        top: 66.0,
        width: 430.0,
        height: 560.0,
        x: Axis {
            label: "y, to the right [mm]",
            limits: (-5.4, 5.4),
            ticks: vec![-4.0, -2.0, 0.0, 2.0, 4.0],
            decimals: 0,
            logarithmic: false,
        },
        y: Axis {
            label: "x, rolling direction [mm]",
            limits: (-7.03, 7.03),
            ticks: vec![-6.0, -4.0, -2.0, 0.0, 2.0, 4.0, 6.0],
            decimals: 0,
            logarithmic: false,
        },
    };
    let at = |x: f64, y: f64| {
        let (h, v) = panel.at((1e3 * y, 1e3 * x));
        place(h, v)
    };
    picture(&folder.join("traction_map.svg"), (640, 690), |canvas| {
        write(canvas, "Traction on the rail", (90.0, 10.0), 19)?;
        write(canvas, "STRIP, longitudinal creepage 0.03 %, spin 0.6 /m", (90.0, 38.0), 14)?;
        panel.draw(canvas)?;
        for strip in &strips {
            const PIECES: i32 = 48;
            // A piece reaches under the next one, in x and y, so that no seam shows. Both of its
            // sides follow the edge of the ellipse.
            let (low, high) = (strip.y - 0.5 * strip.width, strip.y + 0.7 * strip.width);
            let half = |y: f64| contact.a * (1.0 - (y / contact.b).powi(2)).max(0.0).sqrt();
            for i in 0..PIECES {
                let from = f64::from(2 * i - PIECES) / f64::from(PIECES);
                let middle = from + 1.0 / f64::from(PIECES);
                let to = (from + 3.0 / f64::from(PIECES)).min(1.0);
                let point = field.at(middle * half(strip.y), strip.y);
                let size = point.traction_x.hypot(point.traction_y);
                let edges = [low, 0.5 * (low + high), high];
                let mut corners: Vec<(i32, i32)> =
                    edges.iter().map(|y| at(from * half(*y), *y)).collect();
                corners.extend(edges.iter().rev().map(|y| at(to * half(*y), *y)));
                canvas.draw(&Polygon::new(corners, shade(size / most).filled()))?;
            }
        }
        let rim = (0..=360).map(|i| f64::from(i).to_radians());
        let rim = rim.map(|t| at(contact.a * t.sin(), contact.b * t.cos())).collect::<Vec<_>>();
        canvas.draw(&PathElement::new(rim, line(INK, 1)))?;
        // The border of stick and slip, by bisection in x on lines of constant y
        let mut border = Vec::new();
        for i in 1..400 {
            let y = contact.b * (f64::from(i) / 200.0 - 1.0);
            let half = contact.a * (1.0 - (y / contact.b).powi(2)).sqrt();
            let sticks = |x: f64| field.at(x, y).state == State::Stick;
            if !sticks(0.999 * half) {
                continue;
            }
            let (mut low, mut high) = (-half, 0.999 * half);
            for _ in 0..40 {
                let middle = 0.5 * (low + high);
                if sticks(middle) { high = middle } else { low = middle }
            }
            border.push(at(high, y));
        }
        canvas.draw(&PathElement::new(border, line(BLUE, 3)))?;
        let spacing = 0.8e-3;
        for column in -6..=6 {
            for row in -8..=8 {
                let (y, x) = (f64::from(column) * spacing, f64::from(row) * spacing);
                let point = field.at(x, y);
                if point.state == State::Outside || (x / contact.a).hypot(y / contact.b) > 0.96 {
                    continue;
                }
                let (h, v) = panel.at((1e3 * y, 1e3 * x));
                let half = 0.5 * 30.0 / most;
                let (dh, dv) = (half * point.traction_y, -half * point.traction_x);
                arrow(canvas, (h - dh, v - dv), (h + dh, v + dv), 1)?;
            }
        }
        for (text, (y, x), colour) in [("stick", (-0.5, 3.75), BLUE), ("slip", (-0.35, -4.75), INK)]
        {
            let (h, v) = panel.at((y, x));
            let box_of = [place(h - 7.0, v - 3.0), place(h + 43.0, v + 20.0)];
            canvas.draw(&Rectangle::new(box_of, WHITE.mix(0.85).filled()))?;
            let bold = font(16).color(&colour);
            canvas.draw(&Text::new(text, place(h, v), bold))?;
        }
        // Scale of colours
        for i in 0..110 {
            let top = 66.0 + 560.0 * (1.0 - f64::from(i + 1) / 110.0);
            let corners = [place(545.0, top), place(563.0, top + 560.0 / 110.0 + 0.3)];
            let colour = shade((f64::from(i) + 0.5) / 110.0);
            canvas.draw(&Rectangle::new(corners, colour.filled()))?;
        }
        for mega in [0, 100, 200, 300] {
            let v = 66.0 + 560.0 * (1.0 - f64::from(mega) * 1e6 / most);
            write(canvas, &format!("{mega}"), (569.0, v - 8.0), 14)?;
        }
        let upright = font(16).transform(FontTransform::Rotate270);
        canvas.draw(&Text::new("traction [MPa]", place(606.0, 400.0), upright))?;
        Ok(())
    })
}

/// Mean error of the force against the instructions of one call, 16 strips, double precision.
fn draw_models(folder: &Path) -> Drawn {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let counts = std::fs::read_to_string(root.join("benches/instructions.txt"))?;
    let report = std::fs::read_to_string(root.join("docs/evidence/accuracy.md"))?;
    let mean = |method: &str| -> Result<f64, Box<dyn std::error::Error>> {
        let start = format!("| {method} | ");
        let row = report.lines().find_map(|line| line.strip_prefix(&start)).ok_or("no row")?;
        Ok(row.split(" | ").next().ok_or("no cell")?.parse()?)
    };
    let instructions = |model: &str,
                        what: &str,
                        strips: u32|
     -> Result<f64, Box<dyn std::error::Error>> {
        let start = format!("{model} f64 {what} {strips} ");
        Ok(counts.lines().find_map(|line| line.strip_prefix(&start)).ok_or("no count")?.parse()?)
    };
    let panel = Panel {
        left: 90.0,
        top: 66.0,
        width: 610.0,
        height: 340.0,
        x: Axis {
            label: "instructions of one call, x86-64, double precision",
            limits: (1000.0, 30000.0),
            ticks: vec![1000.0, 2000.0, 5000.0, 10000.0, 20000.0],
            decimals: 0,
            logarithmic: true,
        },
        y: Axis {
            label: "mean error of the force / (μ N)",
            limits: (0.002, 0.4),
            ticks: vec![0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2],
            decimals: 3,
            logarithmic: true,
        },
    };
    let rows = [
        ("STRIP_1967", "STRIP_1967, 16 strips", 16, GREY),
        ("STRIP_1967_CONTINUOUS", "STRIP_1967_CONTINUOUS, 16 strips", 16, GREY),
        ("STRIP", "STRIP, 16 strips", 16, VERMILION),
        ("TOTAL", "TOTAL", 0, BLUE),
    ];
    let mut found = Vec::new();
    for (model, row, strips, colour) in rows {
        let count = |what| instructions(model, what, strips);
        found.push((model, count("solve")?, count("derivatives")?, mean(row)?, colour));
    }
    let fastsim = mean("FASTSIM 10x10, 3 flexibilities, parabolic")?;
    picture(&folder.join("models.svg"), (730, 470), |canvas| {
        write(canvas, "Error of the force against the cost of one call", (90.0, 10.0), 19)?;
        let remark =
            "filled: forces; open: with derivatives; against CONTACT, 854 ellipses, a/b 0.1 to 10";
        write(canvas, remark, (90.0, 38.0), 14)?;
        panel.draw(canvas)?;
        let across = [(1000.0, fastsim), (30000.0, fastsim)];
        panel.curve(canvas, &across, GREY, Kind::Dashed)?;
        let text = "error of FASTSIM, 10 x 10 cells";
        panel.name(canvas, text, (1000.0, fastsim), (8.0, -20.0), GREY)?;
        for (model, forces, derivatives, error, colour) in &found {
            let ends = [(*forces, *error), (*derivatives, *error)];
            panel.curve(canvas, &ends, *colour, Kind::Line)?;
            panel.curve(canvas, &ends[..1], *colour, Kind::Circles)?;
            let (h, v) = panel.at(ends[1]);
            canvas.draw(&Circle::new(place(h, v), 5 * super::SCALE, WHITE.filled()))?;
            canvas.draw(&Circle::new(place(h, v), 5 * super::SCALE, line(*colour, 2)))?;
            let down = if *model == "STRIP_1967" { 9.0 } else { -24.0 };
            panel.name(canvas, model, ends[0], (-4.0, down), *colour)?;
        }
        Ok(())
    })
}

/// A wheelset in a frame that runs at a constant speed: lateral place [mm] over time [s], as in the
/// cookbook.
fn hunting(contact: &Contact<f64>, speed: f64) -> Result<Vec<(f64, f64)>, Error> {
    let (mass, inertia, lateral_spring, yaw_spring) = (1800.0, 1100.0, 400e3, 3e6);
    let (radius, half_gauge, conicity, h) = (0.46, 0.75, 0.1, 1e-4);
    let (mut y, mut yaw, mut y_rate, mut yaw_rate) = (1e-3, 0.0, 0.0, 0.0);
    let mut found = Vec::new();
    for n in 0..20_000 {
        if n % 20 == 0 {
            found.push((f64::from(n) * h, 1e3 * y));
        }
        let (mut force, mut moment) = (-lateral_spring * y, -yaw_spring * yaw);
        for side in [-1.0, 1.0] {
            let creepage = Creepage {
                longitudinal: -side * (conicity * y / radius + half_gauge * yaw_rate / speed),
                lateral: y_rate / speed - yaw,
                spin: -side * conicity / radius + yaw_rate / speed,
            };
            let on_rail = forces::forces_of_contact(contact, &creepage, &Options::default())?;
            force -= on_rail.fy;
            moment += side * half_gauge * on_rail.fx - on_rail.mz;
        }
        y_rate += h * force / mass;
        yaw_rate += h * moment / inertia;
        y += h * y_rate;
        yaw += h * yaw_rate;
    }
    Ok(found)
}

fn draw_hunting(folder: &Path) -> Drawn {
    let contact = wheel_on_rail()?;
    let (slow, fast) = (hunting(&contact, 40.0)?, hunting(&contact, 120.0)?);
    let panel = |top: f64, limit: f64, ticks: Vec<f64>, decimals, label| Panel {
        left: 90.0,
        top,
        width: 640.0,
        height: 150.0,
        x: Axis {
            label,
            limits: (0.0, 2.0),
            ticks: vec![0.0, 0.5, 1.0, 1.5, 2.0],
            decimals: 1,
            logarithmic: false,
        },
        y: Axis { label: "y [mm]", limits: (-limit, limit), ticks, decimals, logarithmic: false },
    };
    picture(&folder.join("hunting.svg"), (760, 490), |canvas| {
        write(canvas, "A wheelset displaced by 1 mm, at two speeds", (90.0, 10.0), 19)?;
        let above = panel(72.0, 1.2, vec![-1.0, 0.0, 1.0], 0, "");
        above.draw(canvas)?;
        above.curve(canvas, &slow, BLUE, Kind::Line)?;
        write(canvas, "40 m/s: it comes to rest", (90.0, 44.0), 16)?;
        let below = panel(276.0, 32.0, vec![-30.0, -15.0, 0.0, 15.0, 30.0], 0, "time [s]");
        below.draw(canvas)?;
        below.curve(canvas, &fast, VERMILION, Kind::Line)?;
        let text = "120 m/s: it hunts, and grows into a limit cycle";
        write(canvas, text, (90.0, 248.0), 16)
    })
}

/// Time [s], speed of the vehicle [m/s] and force on the rail [kN] of a wheel that brakes to rest
/// on a slope of 1:50 and holds.
fn stop_and_hold(contact: &Contact<f64>) -> Result<Vec<[f64; 3]>, Error> {
    let (mass, rim, brake, step) = (8150.0, 400.0, 6e3_f64, 1.0 / 60.0);
    let weight = mass * 9.81 / 50.0;
    let (mut vehicle, mut wheel) = (2.0_f64, 2.0_f64);
    let mut found = Vec::new();
    for n in 0..300 {
        let motion = Motion {
            slip_x: vehicle - wheel,
            slip_y: 0.0,
            spin_rate: 0.0,
            rolling_speed: vehicle,
            floor_speed: 0.0,
        };
        let (force, _, by) =
            motion::differentiate_motion(contact, &motion, None, &Options::default())?;
        found.push([f64::from(n) * step, vehicle, force.fx / 1e3]);
        let (by_vehicle, by_wheel) = (by.slip[0][0] + by.rolling_speed[0], -by.slip[0][0]);
        let (p, q) = (mass + step * by_vehicle, step * by_wheel);
        let (r, u) = (-step * by_vehicle, rim - step * by_wheel);
        let on_vehicle = -step * (force.fx + weight);
        let on_rim = step * (force.fx - brake.copysign(wheel));
        let determinant = p * u - q * r;
        let mut dv = (on_vehicle * u - on_rim * q) / determinant;
        let mut dw = (p * on_rim - r * on_vehicle) / determinant;
        if wheel * (wheel + dw) <= 0.0 {
            dw = -wheel;
            dv = (on_vehicle - q * dw) / p;
        }
        vehicle += dv;
        wheel += dw;
    }
    Ok(found)
}

fn draw_stop_and_hold(folder: &Path) -> Drawn {
    let run = stop_and_hold(&wheel_on_rail()?)?;
    let panel = |top: f64, label, y: Axis| Panel {
        left: 90.0,
        top,
        width: 640.0,
        height: 150.0,
        x: Axis {
            label,
            limits: (0.0, 5.0),
            ticks: vec![0.0, 1.0, 2.0, 3.0, 4.0, 5.0],
            decimals: 0,
            logarithmic: false,
        },
        y,
    };
    picture(&folder.join("standstill.svg"), (760, 490), |canvas| {
        write(canvas, "Braking to a standstill on a slope of 1 in 50", (90.0, 10.0), 19)?;
        let above = panel(
            72.0,
            "",
            Axis {
                label: "v [m/s]",
                limits: (-0.2, 2.2),
                ticks: vec![0.0, 1.0, 2.0],
                decimals: 0,
                logarithmic: false,
            },
        );
        above.draw(canvas)?;
        let speed: Vec<_> = run.iter().map(|[t, v, _]| (*t, *v)).collect();
        above.curve(canvas, &speed, BLUE, Kind::Line)?;
        write(canvas, "speed of the vehicle", (90.0, 44.0), 16)?;
        let below = panel(
            276.0,
            "time [s]",
            Axis {
                label: "Fx [kN]",
                limits: (-3.0, 7.0),
                ticks: vec![-2.0, 0.0, 2.0, 4.0, 6.0],
                decimals: 0,
                logarithmic: false,
            },
        );
        below.draw(canvas)?;
        let force: Vec<_> = run.iter().map(|[t, _, f]| (*t, *f)).collect();
        below.curve(canvas, &force, VERMILION, Kind::Line)?;
        let text = "creep force on the rail: it brakes, then it holds the vehicle";
        write(canvas, text, (90.0, 248.0), 16)
    })
}

pub fn draw(folder: &Path) -> Drawn {
    draw_models(folder)?;
    draw_traction_map(folder)?;
    draw_hunting(folder)?;
    draw_stop_and_hold(folder)
}
