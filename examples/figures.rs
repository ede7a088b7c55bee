//! Draws figures 7a, 7b, 8a, 8b and 10 of Kalker's paper of 1967 and a set of creep curves as SVG
//! under `docs/figures/`: `cargo run --release --example figures`.

use kstrip::contact::Contact;
use kstrip::contact::creepage::Parameters;
use kstrip::contact::forces::StripCount;
use kstrip::solve::model::{self, Field, Model, Options};
use kstrip::strip_1967::strip::State;
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
        remark: "apex angle 76°, as Poon measured; slip against the traction only at the two corners",
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
        remark: "slip against the traction only at the two corners",
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
    }
}

/// The parts of a strip `Y = y/b` in one state: intervals of `x/a`.
fn intervals(
    field: &Field<f64>,
    contact: &Contact<f64>,
    relative_y: f64,
    state: State,
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
fn arrow(canvas: &Canvas, (x0, y0): (f64, f64), (x1, y1): (f64, f64), width: u32) -> Drawn {
    let length = (x1 - x0).hypot(y1 - y0);
    if length < 0.5 {
        return Ok(());
    }
    let (ux, uy) = ((x1 - x0) / length, (y1 - y0) / length);
    let head = (0.4 * length).min(8.0);
    let (bx, by) = (x1 - head * ux, y1 - head * uy);
    canvas.draw(&PathElement::new(vec![place(x0, y0), place(bx, by)], line(INK, width)))?;
    let half = 0.42 * head;
    let corners = vec![
        place(x1, y1),
        place(bx - half * uy, by + half * ux),
        place(bx + half * uy, by - half * ux),
    ];
    canvas.draw(&Polygon::new(corners, INK.filled()))?;
    Ok(())
}

/// Colour patches with their meaning, in a row.
fn legend(canvas: &Canvas, left: f64, top: f64) -> Drawn {
    let mut x = left;
    let entries = [
        (ADHESION, "adhesion", 95.0),
        (SLIP, "slip", 65.0),
        (NEGATIVE, "slip against the traction", 200.0),
    ];
    for (colour, text, width) in entries {
        let corners = [place(x, top), place(x + 16.0, top + 12.0)];
        canvas.draw(&Rectangle::new(corners, colour.filled()))?;
        canvas.draw(&Rectangle::new(corners, line(INK, 1)))?;
        write(canvas, text, (x + 22.0, top - 1.0), 14)?;
        x += width;
    }
    arrow(canvas, (x, top + 6.0), (x + 24.0, top + 6.0), 1)?;
    write(canvas, "traction", (x + 30.0, top - 1.0), 14)
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
    let totals = model::solve(&contact, &creepage, &OPTIONS)?;
    let bound = contact.friction_bound();
    let subtitle = format!(
        "adhesion on {:.0} % of the area, Fx = {} μN, Fy = {} μN",
        totals.adhesion * 100.0,
        number(totals.fx / bound, 3),
        number(totals.fy / bound, 3)
    );

    // Pixels per unit of y/b and of x/a: the same length in metres is as long both ways.
    let slender = case.axis_ratio < 0.5;
    let per_b = if slender { 400.0 } else { 225.0 };
    let per_a = per_b * case.axis_ratio;
    let (limit_y, limit_x) = if slender { (1.08, 1.5) } else { (1.12, 1.12) };
    let plot = ((2.0 * limit_y * per_b) as u32, (2.0 * limit_x * per_a) as u32);
    let top = if case.remark.is_empty() { 66 } else { 86 };
    let (left, right, bottom) = (74, 20, 76);
    let margin = f64::from(left);
    let size = (plot.0 + left + right, plot.1 + top + bottom);
    picture(&folder.join(case.file), size, |canvas| {
        write(canvas, case.title, (margin, 12.0), 19)?;
        write(canvas, &subtitle, (margin, 40.0), 14)?;
        write(canvas, case.remark, (margin, 60.0), 14)?;
        draw_patch(canvas, &field, &contact, (limit_y, limit_x), [left, right, top, bottom])?;
        draw_tractions(canvas, &field, &contact, (per_b, per_a), {
            (margin + limit_y * per_b, f64::from(top) + limit_x * per_a)
        })?;

        // Rolling direction, in the corner outside the ellipse
        let corner = (margin + 22.0, f64::from(top) + 12.0);
        arrow(canvas, (corner.0, corner.1 + 46.0), corner, 2)?;
        write(canvas, "rolling", (corner.0 + 10.0, corner.1 + 2.0), 14)?;
        let below = f64::from(top + plot.1);
        write(canvas, "y/b", (margin + limit_y * per_b - 10.0, below + 24.0), 16)?;
        write(canvas, "x/a", (12.0, f64::from(top) + limit_x * per_a - 8.0), 16)?;
        legend(canvas, margin, below + 52.0)
    })
}

/// Axes, ellipse, and the areas in it.
fn draw_patch(
    canvas: &Canvas,
    field: &Field<f64>,
    contact: &Contact<f64>,
    (limit_y, limit_x): (f64, f64),
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

/// Arrows on a square grid, as long as the traction over `μ p₀`.
fn draw_tractions(
    canvas: &Canvas,
    field: &Field<f64>,
    contact: &Contact<f64>,
    (per_b, per_a): (f64, f64),
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
    Ok(())
}

/// Longitudinal force over longitudinal creepage for several spins.
fn draw_creep_curves(folder: &Path) -> Drawn {
    let contact = contact(1.0, 0.28);
    let force = |xi: f64, psi: f64| -> Result<f64, Box<dyn Error>> {
        let parameters = Parameters { xi, eta: 0.0, psi, poisson_ratio: 0.28, axis_ratio: 1.0 };
        let forces = model::solve(&contact, &parameters.creepage(&contact), &OPTIONS)?;
        Ok(forces.fx / contact.friction_bound())
    };
    let colours = [(0x00, 0x45, 0x8b), (0x1b, 0x9e, 0x77), (0xd9, 0x5f, 0x02), (0xa0, 0x1c, 0x5b)];
    picture(&folder.join("creep_curves.svg"), (760, 480), |canvas| {
        let title = "Longitudinal force of a circular contact with spin";
        write(canvas, title, (72.0, 12.0), 19)?;
        write(canvas, "strip theory of 1967, ν = 0.28, no lateral creepage", (72.0, 38.0), 14)?;
        let inner = canvas.margin(66 * SCALE, 8 * SCALE, 4 * SCALE, 24 * SCALE);
        let mut chart = ChartBuilder::on(&inner)
            .x_label_area_size(52 * SCALE)
            .y_label_area_size(68 * SCALE)
            .build_cartesian_2d(0.0..1.4, 0.0..1.05)?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(line(RGBColor(0xdd, 0xdd, 0xdd), 1))
            .x_labels(8)
            .y_labels(6)
            .x_label_formatter(&|v| number(*v, 1))
            .y_label_formatter(&|v| number(*v, 1))
            .x_desc("ξ = υx G / (2 (1 − ν) μ p0)")
            .y_desc("Fx / (μ N)")
            .label_style(font(14))
            .axis_desc_style(font(16))
            .axis_style(line(INK, 1))
            .set_all_tick_mark_size(5 * SCALE)
            .draw()?;
        let sample = |x: i32, y: i32, style: ShapeStyle| {
            PathElement::new([(x, y), (x + 24 * SCALE as i32, y)], style)
        };
        for (psi, (r, g, b)) in [0.0, 0.3, 0.6, 0.9].into_iter().zip(colours) {
            let style = line(RGBColor(r, g, b), 3);
            let places = (0..=280).map(|i| f64::from(i) / 200.0);
            let points: Result<Vec<_>, _> = places.map(|xi| Ok((xi, force(xi, psi)?))).collect();
            chart
                .draw_series(LineSeries::new(points.map_err(|e: Box<dyn Error>| e)?, style))?
                .label(format!("spin ψ = {psi}"))
                .legend(move |(x, y)| sample(x, y, style));
        }
        let style = line(RGBColor(0x77, 0x77, 0x77), 2);
        // Fx = (3 π/4) ξ μ N
        let slope = [(0.0, 0.0), (4.0 / (3.0 * PI), 1.0)];
        chart
            .draw_series(DashedLineSeries::new(slope, 8 * SCALE, 6 * SCALE, style))?
            .label("initial slope at ψ = 0")
            .legend(move |(x, y)| sample(x, y, style));
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::LowerRight)
            .background_style(WHITE)
            .border_style(line(INK, 1))
            .margin(16 * SCALE)
            .legend_area_size(34 * SCALE)
            .label_font(font(15))
            .draw()?;
        Ok(())
    })
}

fn main() -> Drawn {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/figures");
    std::fs::create_dir_all(&folder)?;
    for case in &CASES {
        draw_case(&folder, case)?;
    }
    draw_creep_curves(&folder)?;
    println!("figures are in docs/figures");
    Ok(())
}
