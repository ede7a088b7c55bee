//! Draws figures 7a, 7b, 8a, 8b, 9 and 10 of Kalker's paper of 1967 and a set of creep curves as
//! SVG under `docs/figures/`, and the pictures of the tour, of the models and of the cookbook:
//! `cargo bench --bench figures`. Points of CONTACT are those of `tests/data/open.csv`.

#[path = "common/palette.rs"]
mod palette;
#[path = "figures/panel.rs"]
mod panel;
#[path = "figures/runs.rs"]
mod runs;
#[path = "figures/scenes.rs"]
mod scenes;

use kstrip::contact::Contact;
use kstrip::contact::creepage::Parameters;
use kstrip::contact::totals::StripCount;
use kstrip::forces::{self, Field, Model, Options};
use kstrip::strip_1967::strip::State;
use palette::{BLUE, GREEN, PURPLE, VERMILION};
use plotters::coord::Shift;
use plotters::prelude::*;
use std::error::Error;
use std::f64::consts::PI;
use std::path::Path;

const OPTIONS: Options = Options { model: Model::Strip1967, strips: StripCount::SixtyFour };

/// plotters rounds to whole pixels: draw this much larger, and let the file say the true size.
const SCALE: u32 = 8;

const ADHESION: RGBColor = RGBColor(0xa6, 0xcb, 0xe8);
const SLIP: RGBColor = RGBColor(0xfb, 0xe3, 0xb8);
const NEGATIVE: RGBColor = RGBColor(0xe8, 0x8f, 0x86);
const INK: RGBColor = RGBColor(0x22, 0x22, 0x22);
/// Arrows of slip.
const OPEN: RGBColor = RGBColor(0xa8, 0x1e, 0x1e);

/// A figure of the paper.
struct Case {
    file: &'static str,
    title: &'static str,
    remark: &'static str,
    axis_ratio: f64,
    poisson_ratio: f64,
    eta: f64,
    psi: f64,
}

const CASES: [Case; 5] = [
    Case {
        file: "figure_07a.svg",
        title: "Figure 7a: pure spin, a/b = 1, ν = 0.5, ψ = 0.305",
        remark: "apex angle 76°, as Poon measured",
        axis_ratio: 1.0,
        poisson_ratio: 0.5,
        eta: 0.0,
        psi: 0.305,
    },
    Case {
        file: "figure_07b.svg",
        title: "Figure 7b: pure spin, a/b = 1, ν = 0.5, ψ = 0.8",
        remark: "",
        axis_ratio: 1.0,
        poisson_ratio: 0.5,
        eta: 0.0,
        psi: 0.8,
    },
    Case {
        file: "figure_08a.svg",
        title: "Figure 8a: pure spin, a/b = 0.2, ν = 0.5, ψ = 0.305",
        remark: "",
        axis_ratio: 0.2,
        poisson_ratio: 0.5,
        eta: 0.0,
        psi: 0.305,
    },
    Case {
        file: "figure_08b.svg",
        title: "Figure 8b: pure spin, a/b = 0.2, ν = 0.5, ψ = 0.8",
        remark: "",
        axis_ratio: 0.2,
        poisson_ratio: 0.5,
        eta: 0.0,
        psi: 0.8,
    },
    Case {
        file: "figure_10.svg",
        title: "Figure 10: a/b = 1, ν = 0.29, ξ = 0, η = −0.5, ψ = 1",
        remark: "an adhesion area remains at |ψ| = 1",
        axis_ratio: 1.0,
        poisson_ratio: 0.29,
        eta: -0.5,
        psi: 1.0,
    },
];

impl Case {
    fn contact(&self) -> Contact<f64> {
        contact(self.axis_ratio, self.poisson_ratio)
    }

    fn parameters(&self) -> Parameters<f64> {
        Parameters {
            xi: 0.0,
            eta: self.eta,
            psi: self.psi,
            poisson_ratio: self.poisson_ratio,
            axis_ratio: self.axis_ratio,
        }
    }
}

/// A contact of which only the dimensionless numbers matter here.
fn contact(axis_ratio: f64, poisson_ratio: f64) -> Contact<f64> {
    Contact {
        a: axis_ratio,
        b: 1.0,
        normal_force: 1e6,
        shear_modulus: 82e9,
        poisson_ratio,
        friction: 0.3,
        mismatch: 0.0,
    }
}

/// The parts of a strip `Y = y/b` in one state: intervals of `x/a`.
fn intervals(
    field: &Field<f64>, contact: &Contact<f64>, relative_y: f64, state: State,
) -> Vec<[f64; 2]> {
    const STEPS: i32 = 400;
    let strip = field.strip_at(relative_y * contact.b);
    let half_length = (1.0 - relative_y * relative_y).sqrt();
    let holds = |x: f64| field.along(strip.as_ref(), x * contact.a).state == state;
    let at = |i: i32| half_length * (f64::from(2 * i + 1) / f64::from(STEPS) - 1.0);
    // Where the state changes between two samples, by bisection
    let border = |mut low: f64, mut high: f64| {
        let below = holds(low);
        for _ in 0..30 {
            let middle = 0.5 * (low + high);
            if holds(middle) == below { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    };
    let mut found = Vec::new();
    let mut start = holds(at(0)).then_some(-half_length);
    for i in 1..STEPS {
        let now = holds(at(i));
        match start {
            None if now => start = Some(border(at(i - 1), at(i))),
            Some(from) if !now => {
                found.push([from, border(at(i - 1), at(i))]);
                start = None;
            }
            _ => {}
        }
    }
    found.extend(start.map(|from| [from, half_length]));
    found
}

/// A connected area: its lower and upper border, points `(y/b, x/a)` from left to right.
#[derive(Clone, Default)]
struct Area {
    lower: Vec<(f64, f64)>,
    upper: Vec<(f64, f64)>,
}

/// The areas in one state, joined from strip to strip.
fn areas(field: &Field<f64>, contact: &Contact<f64>, state: State) -> Vec<Area> {
    const STRIPS: i32 = 800;
    let mut areas: Vec<Area> = Vec::new();
    let mut open: Vec<Area> = Vec::new();
    for j in 1..STRIPS {
        let y = -(PI * f64::from(j) / f64::from(STRIPS)).cos();
        let parts = intervals(field, contact, y, state);
        if parts.len() != open.len() {
            areas.append(&mut open);
            open.resize(parts.len(), Area::default());
        }
        for (area, [low, high]) in open.iter_mut().zip(parts) {
            area.lower.push((y, low));
            area.upper.push((y, high));
        }
    }
    areas.append(&mut open);
    areas.retain(|area| area.lower.len() > 1);
    areas
}

/// Share of areas in that of the ellipse.
fn share(areas: &[Area]) -> f64 {
    let mut sum = 0.0;
    for Area { lower, upper } in areas {
        let heights: Vec<(f64, f64)> =
            lower.iter().zip(upper).map(|((y, low), (_, high))| (*y, high - low)).collect();
        sum += heights.windows(2).map(|w| (w[1].0 - w[0].0) * 0.5 * (w[0].1 + w[1].1)).sum::<f64>();
    }
    sum / PI
}

type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), Box<dyn Error>>;

fn font(size: u32) -> TextStyle<'static> {
    TextStyle::from(("sans-serif", size * SCALE).into_font()).color(&INK)
}

/// A place in pixels of the finished picture.
fn place(x: f64, y: f64) -> (i32, i32) {
    let scale = f64::from(SCALE);
    ((x * scale).round() as i32, (y * scale).round() as i32)
}

/// Writes text with its upper left corner at a place.
fn write(canvas: &Canvas, text: &str, at: (f64, f64), size: u32) -> Drawn {
    canvas.draw(&Text::new(text.to_owned(), place(at.0, at.1), font(size)))?;
    Ok(())
}

fn line(colour: RGBColor, width: u32) -> ShapeStyle {
    colour.stroke_width(width * SCALE)
}

/// Lets `draw` fill a picture of this size, and writes the file.
fn picture(path: &Path, (width, height): (u32, u32), draw: impl Fn(&Canvas) -> Drawn) -> Drawn {
    let (large_width, large_height) = (width * SCALE, height * SCALE);
    let mut svg = String::new();
    {
        let canvas = SVGBackend::with_string(&mut svg, (large_width, large_height));
        let canvas = canvas.into_drawing_area();
        canvas.fill(&WHITE)?;
        draw(&canvas)?;
        canvas.present()?;
    }
    let size = |w: u32, h: u32| format!("<svg width=\"{w}\" height=\"{h}\" viewBox");
    let (large, true_size) = (size(large_width, large_height), size(width, height));
    if !svg.contains(&large) {
        return Err("the picture does not begin as expected".into());
    }
    std::fs::write(path, svg.replacen(&large, &true_size, 1))?;
    Ok(())
}

/// Shaft and head of an arrow from one place to another.
fn arrow(canvas: &Canvas, from: (f64, f64), to: (f64, f64), width: u32) -> Drawn {
    drawn_arrow(canvas, from, to, INK, width, true)
}

/// An arrow of slip: its head is open.
fn slip_arrow(canvas: &Canvas, from: (f64, f64), to: (f64, f64)) -> Drawn {
    drawn_arrow(canvas, from, to, OPEN, 1, false)
}

fn drawn_arrow(
    canvas: &Canvas, (x0, y0): (f64, f64), (x1, y1): (f64, f64), colour: RGBColor, width: u32,
    closed: bool,
) -> Drawn {
    let length = (x1 - x0).hypot(y1 - y0);
    if length < 0.5 {
        return Ok(());
    }
    let (ux, uy) = ((x1 - x0) / length, (y1 - y0) / length);
    let head = (0.4 * length).min(8.0);
    let (bx, by) = (x1 - head * ux, y1 - head * uy);
    canvas.draw(&PathElement::new(vec![place(x0, y0), place(bx, by)], line(colour, width)))?;
    let half = 0.42 * head;
    let corners = vec![
        place(x1, y1),
        place(bx - half * uy, by + half * ux),
        place(bx + half * uy, by - half * ux),
        place(x1, y1),
    ];
    if closed {
        canvas.draw(&Polygon::new(corners, colour.filled()))?;
    } else {
        canvas.draw(&Polygon::new(corners.clone(), WHITE.filled()))?;
        canvas.draw(&PathElement::new(corners, line(colour, width)))?;
    }
    Ok(())
}

/// Colour patches and arrows with their meaning, in a row.
fn legend(canvas: &Canvas, left: f64, top: f64, against: bool) -> Drawn {
    let mut x = left;
    let entries = [
        (ADHESION, "adhesion", 88.0),
        (SLIP, "slip", 58.0),
        (NEGATIVE, "slip against the traction", 186.0),
    ];
    for (colour, text, width) in entries.into_iter().filter(|entry| against || entry.0 != NEGATIVE)
    {
        let corners = [place(x, top), place(x + 16.0, top + 12.0)];
        canvas.draw(&Rectangle::new(corners, colour.filled()))?;
        canvas.draw(&Rectangle::new(corners, line(INK, 1)))?;
        write(canvas, text, (x + 22.0, top - 1.0), 14)?;
        x += width;
    }
    arrow(canvas, (x, top + 6.0), (x + 20.0, top + 6.0), 1)?;
    write(canvas, "traction", (x + 25.0, top - 1.0), 14)?;
    x += 84.0;
    slip_arrow(canvas, (x, top + 6.0), (x + 20.0, top + 6.0))?;
    write(canvas, "slip", (x + 25.0, top - 1.0), 14)
}

/// A number without a sign before zero, and with a true minus sign.
fn number(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let is_zero = text.chars().all(|c| !c.is_ascii_digit() || c == '0');
    if is_zero { text.replace('-', "") } else { text.replace('-', "−") }
}

fn draw_case(folder: &Path, case: &Case) -> Drawn {
    let contact = case.contact();
    let creepage = case.parameters().creepage(&contact);
    let field = Field::new(&contact, &creepage, &OPTIONS)?;
    let totals = forces::forces_of_contact(&contact, &creepage, &OPTIONS)?;
    let bound = contact.friction_bound();
    let against = share(&areas(&field, &contact, State::SlipNegativeDissipation));
    let subtitle = format!(
        "adhesion on {:.0} % of the area, slip against the traction on {:.2} %",
        totals.adhesion * 100.0,
        against * 100.0,
    );
    let remark = format!(
        "Fx = {} μN, Fy = {} μN{}{}",
        number(totals.fx / bound, 3),
        number(totals.fy / bound, 3),
        if case.remark.is_empty() { "" } else { "; " },
        case.remark
    );

    // Pixels per unit of y/b and of x/a: the same length in metres is as long both ways.
    let slender = case.axis_ratio < 0.5;
    let per_b = if slender { 400.0 } else { 225.0 };
    let per_a = per_b * case.axis_ratio;
    let (limit_y, limit_x) = if slender { (1.08, 1.5) } else { (1.12, 1.12) };
    let plot = ((2.0 * limit_y * per_b) as u32, (2.0 * limit_x * per_a) as u32);
    let top = 86;
    let (left, right, bottom) = (74, 20, 76);
    let margin = f64::from(left);
    let size = (plot.0 + left + right, plot.1 + top + bottom);
    picture(&folder.join(case.file), size, |canvas| {
        write(canvas, case.title, (margin, 12.0), 19)?;
        write(canvas, &subtitle, (margin, 40.0), 14)?;
        write(canvas, &remark, (margin, 60.0), 14)?;
        draw_patch(canvas, &field, &contact, (limit_y, limit_x), [left, right, top, bottom])?;
        draw_arrows(canvas, &field, &contact, (per_b, per_a), {
            (margin + limit_y * per_b, f64::from(top) + limit_x * per_a)
        })?;

        // Rolling direction, in the corner outside the ellipse
        let corner = (margin + 22.0, f64::from(top) + 12.0);
        arrow(canvas, (corner.0, corner.1 + 46.0), corner, 2)?;
        write(canvas, "rolling", (corner.0 + 10.0, corner.1 + 2.0), 14)?;
        let below = f64::from(top + plot.1);
        write(canvas, "y/b", (margin + limit_y * per_b - 10.0, below + 24.0), 16)?;
        write(canvas, "x/a", (12.0, f64::from(top) + limit_x * per_a - 8.0), 16)?;
        legend(canvas, margin, below + 52.0, against > 1e-3)
    })
}

/// Axes, ellipse, and the areas in it.
fn draw_patch(
    canvas: &Canvas, field: &Field<f64>, contact: &Contact<f64>, (limit_y, limit_x): (f64, f64),
    margins: [u32; 4],
) -> Drawn {
    let [left, right, top, bottom] = margins.map(|margin| margin * SCALE);
    let inner = canvas.margin(top, 0, 0, right);
    let mut chart = ChartBuilder::on(&inner)
        .x_label_area_size(bottom)
        .y_label_area_size(left)
        .build_cartesian_2d(-limit_y..limit_y, -limit_x..limit_x)?;
    chart
        .configure_mesh()
        .disable_mesh()
        .x_labels(9)
        .y_labels(5)
        .x_label_formatter(&|v| number(*v, 1))
        .y_label_formatter(&|v| number(*v, 1))
        .label_style(font(14))
        .axis_style(line(INK, 1))
        .set_all_tick_mark_size(5 * SCALE)
        .draw()?;

    let rim: Vec<(f64, f64)> = (0..=360)
        .map(|degree| f64::from(degree).to_radians())
        .map(|angle| (angle.cos(), angle.sin()))
        .collect();
    chart.draw_series([Polygon::new(rim.clone(), SLIP.filled())])?;
    let adhesion = areas(field, contact, State::Stick);
    let negative = areas(field, contact, State::SlipNegativeDissipation);
    for (areas, colour) in [(&adhesion, ADHESION), (&negative, NEGATIVE)] {
        for area in areas {
            let mut border = area.lower.clone();
            border.extend(area.upper.iter().rev());
            chart.draw_series([Polygon::new(border, colour.filled())])?;
        }
    }
    for area in adhesion {
        // The separatrix ends at the leading edge.
        let ends = [area.upper.first(), area.upper.last()].map(|end| end.copied());
        let separatrix = ends[0].into_iter().chain(area.lower).chain(ends[1]);
        chart.draw_series([PathElement::new(separatrix.collect::<Vec<_>>(), line(INK, 2))])?;
    }
    chart.draw_series([PathElement::new(rim, line(INK, 2))])?;
    Ok(())
}

/// Arrows of traction on a square grid, as long as the traction over `μ p₀`, and of slip between
/// them.
fn draw_arrows(
    canvas: &Canvas, field: &Field<f64>, contact: &Contact<f64>, (per_b, per_a): (f64, f64),
    centre: (f64, f64),
) -> Drawn {
    let spacing = if per_a < 100.0 { 26.0 } else { 30.0 };
    let unit = contact.friction * contact.peak_pressure();
    let (columns, rows) = ((per_b / spacing) as i32, (per_a / spacing) as i32);
    for column in -columns..=columns {
        for row in -rows - 1..=rows {
            let across = f64::from(column) * spacing;
            let along = (f64::from(row) + 0.5) * spacing;
            let (x, y) = (along / per_a * contact.a, across / per_b * contact.b);
            let point = field.at(x, y);
            let half = 0.5 * 0.95 * spacing / unit;
            let (dh, dv) = (half * point.traction_y, -half * point.traction_x);
            let (h, v) = (centre.0 + across, centre.1 - along);
            arrow(canvas, (h - dh, v - dv), (h + dh, v + dv), 1)?;
        }
    }
    // Slip between them, the longest as long as the distance of two arrows
    let mut slips = Vec::new();
    for column in -columns - 1..=columns {
        for row in -rows - 1..=rows + 1 {
            let (across, along) = ((f64::from(column) + 0.5) * spacing, f64::from(row) * spacing);
            let point = field.at(along / per_a * contact.a, across / per_b * contact.b);
            if matches!(point.state, State::Slip | State::SlipNegativeDissipation) {
                slips.push((across, along, point.slip_x, point.slip_y));
            }
        }
    }
    let longest = slips.iter().map(|(_, _, x, y)| x.hypot(*y)).fold(0.0, f64::max);
    for (across, along, slip_x, slip_y) in slips {
        let half = 0.5 * 1.3 * spacing / longest;
        let (dh, dv) = (half * slip_y, -half * slip_x);
        let (h, v) = (centre.0 + across, centre.1 - along);
        slip_arrow(canvas, (h - dh, v - dv), (h + dh, v + dv))?;
    }
    Ok(())
}

/// A case of CONTACT, `tests/data/open.csv`: `a/b`, `ξ, η, ψ`, `Fx, Fy` in `μ N`.
struct Reference {
    axis_ratio: f64,
    xi: f64,
    eta: f64,
    psi: f64,
    fx: f64,
    fy: f64,
}

/// All cases, `ν = 0.28`.
fn references() -> Result<Vec<Reference>, Box<dyn Error>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/open.csv");
    let mut found = Vec::new();
    for record in csv::Reader::from_path(path)?.records() {
        let record = record?;
        let number = |i: usize| record[i].parse::<f64>();
        found.push(Reference {
            axis_ratio: number(0)?,
            xi: number(5)?,
            eta: number(6)?,
            psi: number(7)?,
            fx: number(8)?,
            fy: number(9)?,
        });
    }
    Ok(found)
}

/// `Fx, Fy` in `μ N` of a model, `ν = 0.28`.
fn force(
    model: Model, axis_ratio: f64, [xi, eta, psi]: [f64; 3],
) -> Result<[f64; 2], Box<dyn Error>> {
    let contact = contact(axis_ratio, 0.28);
    let parameters = Parameters { xi, eta, psi, poisson_ratio: 0.28, axis_ratio };
    let options = Options { model, ..OPTIONS };
    let forces = forces::forces_of_contact(&contact, &parameters.creepage(&contact), &options)?;
    let bound = contact.friction_bound();
    Ok([forces.fx / bound, forces.fy / bound])
}

/// One curve of a diagram.
struct Curve {
    label: String,
    points: Vec<(f64, f64)>,
    colour: RGBColor,
    kind: Kind,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Line,
    Dashed,
    Circles,
    /// Circles on a thin line.
    Joined,
}

/// Where a diagram's legend stands: the upper left corner of its first line.
struct Diagram<'a> {
    file: &'a str,
    title: &'a str,
    subtitle: &'a str,
    limits: (f64, f64),
    labels: (&'a str, &'a str),
    ticks: (usize, usize),
    legend: (f64, f64),
}

/// Points that follow a line, dash by dash. (plotters' dashed series leaves its legend solid.)
fn dashes(points: &[(i32, i32)], dash: f64, gap: f64) -> Vec<Vec<(i32, i32)>> {
    let (mut found, mut current) = (Vec::new(), Vec::new());
    let (mut left, mut on) = (dash, true);
    for pair in points.windows(2) {
        let ([x0, y0], [x1, y1]) = (
            [f64::from(pair[0].0), f64::from(pair[0].1)],
            [f64::from(pair[1].0), f64::from(pair[1].1)],
        );
        let length = (x1 - x0).hypot(y1 - y0);
        let mut done = 0.0;
        while done < length {
            let at = |s: f64| {
                let t = s / length;
                ((x0 + t * (x1 - x0)).round() as i32, (y0 + t * (y1 - y0)).round() as i32)
            };
            if on && current.is_empty() {
                current.push(at(done));
            }
            let step = left.min(length - done);
            done += step;
            left -= step;
            if on {
                current.push(at(done));
            }
            if left <= 0.0 {
                if on {
                    found.push(std::mem::take(&mut current));
                }
                on = !on;
                left = if on { dash } else { gap };
            }
        }
    }
    found.push(current);
    found.retain(|piece| piece.len() > 1);
    found
}

fn draw_curve(canvas: &Canvas, curve: &Curve, places: &[(i32, i32)]) -> Drawn {
    let scale = f64::from(SCALE);
    match curve.kind {
        Kind::Line => {
            canvas.draw(&PathElement::new(places.to_vec(), line(curve.colour, 2)))?;
        }
        Kind::Dashed => {
            for piece in dashes(places, 7.0 * scale, 5.0 * scale) {
                canvas.draw(&PathElement::new(piece, line(curve.colour, 1)))?;
            }
        }
        Kind::Circles | Kind::Joined => {
            if curve.kind == Kind::Joined {
                canvas.draw(&PathElement::new(places.to_vec(), line(curve.colour, 1)))?;
            }
            for at in places {
                canvas.draw(&Circle::new(*at, 4 * SCALE, WHITE.filled()))?;
                canvas.draw(&Circle::new(*at, 4 * SCALE, line(curve.colour, 2)))?;
            }
        }
    }
    Ok(())
}

/// Curves over axes from 0.
fn draw_diagram(folder: &Path, diagram: &Diagram, curves: &[Curve]) -> Drawn {
    let size = (760, 480);
    let (left, right, top, bottom) = (76.0, 24.0, 70.0, 60.0);
    let (limit_x, limit_y) = diagram.limits;
    let (width, height) = (f64::from(size.0) - left - right, f64::from(size.1) - top - bottom);
    let at =
        |(x, y): (f64, f64)| place(left + x / limit_x * width, top + height - y / limit_y * height);
    picture(&folder.join(diagram.file), size, |canvas| {
        write(canvas, diagram.title, (left, 12.0), 19)?;
        write(canvas, diagram.subtitle, (left, 40.0), 14)?;
        let grid = line(RGBColor(0xdd, 0xdd, 0xdd), 1);
        for i in 0..=diagram.ticks.0 {
            let x = limit_x * i as f64 / diagram.ticks.0 as f64;
            canvas.draw(&PathElement::new(vec![at((x, 0.0)), at((x, limit_y))], grid))?;
            let label = number(x, 1);
            write(canvas, &label, (left + x / limit_x * width - 10.0, top + height + 8.0), 14)?;
        }
        for i in 0..=diagram.ticks.1 {
            let y = limit_y * i as f64 / diagram.ticks.1 as f64;
            canvas.draw(&PathElement::new(vec![at((0.0, y)), at((limit_x, y))], grid))?;
            let label = number(y, 1);
            write(canvas, &label, (left - 30.0, top + height - y / limit_y * height - 8.0), 14)?;
        }
        let axes = vec![at((0.0, limit_y)), at((0.0, 0.0)), at((limit_x, 0.0))];
        canvas.draw(&PathElement::new(axes, line(INK, 1)))?;
        let (label_x, label_y) = diagram.labels;
        let middle = left + 0.5 * width - 3.7 * label_x.chars().count() as f64;
        write(canvas, label_x, (middle, top + height + 32.0), 16)?;
        let upright = font(16).transform(FontTransform::Rotate270);
        let middle = top + 0.5 * height + 3.7 * label_y.chars().count() as f64;
        canvas.draw(&Text::new(label_y.to_owned(), place(18.0, middle), upright))?;
        for curve in curves {
            let inside = curve.points.iter().filter(|(x, y)| *x <= limit_x && *y <= limit_y);
            let places: Vec<(i32, i32)> = inside.map(|point| at(*point)).collect();
            draw_curve(canvas, curve, &places)?;
        }
        let (x, mut y) = diagram.legend;
        let named: Vec<&Curve> = curves.iter().filter(|curve| !curve.label.is_empty()).collect();
        let longest = named.iter().map(|curve| curve.label.chars().count()).max().unwrap_or(0);
        let corner = (x + 60.0 + 6.8 * longest as f64, y + 24.0 * named.len() as f64 + 4.0);
        let frame = [place(x - 12.0, y - 6.0), place(corner.0, corner.1)];
        canvas.draw(&Rectangle::new(frame, WHITE.filled()))?;
        canvas.draw(&Rectangle::new(frame, line(INK, 1)))?;
        for curve in named {
            let sample: Vec<(i32, i32)> = match curve.kind {
                Kind::Circles => vec![place(x + 17.0, y + 9.0)],
                _ => vec![place(x, y + 9.0), place(x + 34.0, y + 9.0)],
            };
            if curve.kind == Kind::Joined {
                let line =
                    Curve { kind: Kind::Line, label: String::new(), points: Vec::new(), ..*curve };
                draw_curve(canvas, &line, &sample)?;
                draw_curve(canvas, curve, &[place(x + 17.0, y + 9.0)])?;
            } else {
                draw_curve(canvas, curve, &sample)?;
            }
            write(canvas, &curve.label, (x + 44.0, y + 1.0), 14)?;
            y += 24.0;
        }
        Ok(())
    })
}

/// Figure 9: the lateral force of pure spin by both sliding rules, and CONTACT's.
fn draw_figure_9(folder: &Path) -> Drawn {
    let references = references()?;
    let mut curves = Vec::new();
    for (axis_ratio, colour) in [(1.0, BLUE), (0.2, VERMILION)] {
        for (model, rule, kind) in [
            (Model::Strip1967, "rule of the rigid slip, as in the paper", Kind::Line),
            (Model::Strip1967Continuous, "continuous rule", Kind::Dashed),
        ] {
            let places = (0..=400).map(|i| f64::from(i) / 400.0);
            let points: Result<Vec<_>, Box<dyn Error>> = places
                .map(|psi| Ok((psi, force(model, axis_ratio, [0.0, 0.0, psi])?[1])))
                .collect();
            let label = format!("a/b = {axis_ratio}, {rule}");
            curves.push(Curve { label, points: points?, colour, kind });
        }
        let own = references
            .iter()
            .filter(|r| r.axis_ratio == axis_ratio && r.xi == 0.0 && r.eta == 0.0 && r.psi <= 1.0);
        let mut points = vec![(0.0, 0.0)];
        points.extend(own.map(|r| (r.psi, r.fy)));
        let label = format!("a/b = {axis_ratio}, CONTACT");
        curves.push(Curve { label, points, colour, kind: Kind::Joined });
    }
    let diagram = Diagram {
        file: "figure_09.svg",
        title: "Figure 9: lateral force in pure spin, ν = 0.28",
        subtitle: "strip theory of 1967; CONTACT stands where the paper has Kalker's numerical \
             theory of 1966",
        limits: (1.0, 1.2),
        labels: ("|ψ| = a |φ| G / (2 μ p0)", "|Fy| / (μ N)"),
        ticks: (5, 6),
        legend: (104.0, 84.0),
    };
    draw_diagram(folder, &diagram, &curves)
}

/// Longitudinal force over longitudinal creepage for several spins: the default model, CONTACT, and
/// the theory of 1967.
fn draw_creep_curves(folder: &Path) -> Drawn {
    let references = references()?;
    let colours = [BLUE, GREEN, VERMILION, PURPLE];
    let grey = RGBColor(0x77, 0x77, 0x77);
    let mut curves = Vec::new();
    for (psi, colour) in [0.0, 0.3, 0.6, 0.9].into_iter().zip(colours) {
        let curve = |model| -> Result<Vec<(f64, f64)>, Box<dyn Error>> {
            let places = (0..=280).map(|i| f64::from(i) / 200.0);
            places.map(|xi| Ok((xi, force(model, 1.0, [xi, 0.0, psi])?[0]))).collect()
        };
        let label = format!("TOTAL, the default, spin ψ = {psi}");
        curves.push(Curve { label, points: curve(Model::Total)?, colour, kind: Kind::Line });
        let points = curve(Model::Strip1967)?;
        curves.push(Curve { label: String::new(), points, colour, kind: Kind::Dashed });
        let own = references
            .iter()
            .filter(|r| r.axis_ratio == 1.0 && r.eta == 0.0 && r.psi == psi && r.xi > 0.0);
        let points = own.map(|r| (r.xi, r.fx)).collect();
        curves.push(Curve { label: String::new(), points, colour, kind: Kind::Circles });
    }
    for (label, kind) in [("strip theory of 1967", Kind::Dashed), ("CONTACT", Kind::Circles)] {
        curves.push(Curve { label: label.to_owned(), points: Vec::new(), colour: grey, kind });
    }
    let diagram = Diagram {
        file: "creep_curves.svg",
        title: "Longitudinal force of a circular contact with spin",
        subtitle: "ν = 0.28, no lateral creepage",
        limits: (1.4, 1.0),
        labels: ("ξ = υx G / (2 (1 − ν) μ p0)", "Fx / (μ N)"),
        ticks: (7, 5),
        legend: (448.0, 250.0),
    };
    draw_diagram(folder, &diagram, &curves)
}

fn main() -> Drawn {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/figures");
    std::fs::create_dir_all(&folder)?;
    for case in &CASES {
        draw_case(&folder, case)?;
    }
    draw_figure_9(&folder)?;
    draw_creep_curves(&folder)?;
    runs::draw(&folder)?;
    scenes::draw(&folder)?;
    println!("figures are in docs/figures");
    Ok(())
}
