//! The picture: two panels, error of the force and of the derivatives against cost, all
//! logarithmic.

use crate::pictures::*;
use plotters::style::RGBColor;
use std::path::Path;

/// A method in the picture.
pub struct Mark {
    /// Nanoseconds of a contact.
    pub time: f64,
    /// Mean errors: of the force, of the worst derivative.
    pub errors: [f64; 2],
    pub label: String,
    pub ink: RGBColor,
    /// Filled: one call for each contact.
    pub filled: bool,
    /// Marks with the same number, not 0, are joined by a line.
    pub line: usize,
}

/// A rectangle: left, top, right, bottom.
type Box4 = [f64; 4];

fn overlap(a: &Box4, b: &Box4) -> f64 {
    let width = a[2].min(b[2]) - a[0].max(b[0]);
    let height = a[3].min(b[3]) - a[1].max(b[1]);
    width.max(0.0) * height.max(0.0)
}

fn around((x, y): (f64, f64), radius: f64) -> Box4 {
    [x - radius, y - radius, x + radius, y + radius]
}

const SIZE: u32 = 11;

/// Where a label goes: the place near its point that covers least of the labels and points before.
fn place(point: (f64, f64), text: &str, frame: &Box4, taken: &[Box4]) -> Box4 {
    let (width, height) = (6.4 * text.chars().count() as f64 + 6.0, f64::from(SIZE) + 5.0);
    let mut best = ([0.0; 4], f64::INFINITY);
    for gap in [8.0, 14.0, 22.0, 32.0, 44.0, 58.0, 74.0, 92.0] {
        for step in 0..24 {
            let (sine, cosine) = (f64::from(step) * std::f64::consts::TAU / 24.0).sin_cos();
            let x = point.0 + gap * cosine + 0.5 * width * (cosine * 1.5).clamp(-1.0, 1.0);
            let y = point.1 + gap * sine + 0.5 * height * (sine * 1.5).clamp(-1.0, 1.0);
            let here = [x - width / 2.0, y - height / 2.0, x + width / 2.0, y + height / 2.0];
            let covered: f64 = taken.iter().map(|other| overlap(&here, other)).sum();
            let outside = width * height - overlap(&here, frame);
            let cost = 40.0 * covered + 100.0 * outside + gap;
            if cost < best.1 {
                best = (here, cost);
            }
        }
    }
    best.0
}

/// What no other method beats in both, as stairs: what is reached at a given cost.
fn stairs(points: &[(f64, f64)], plot: &Plot) -> Vec<(f64, f64)> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|p, q| p.0.total_cmp(&q.0));
    let (mut stairs, mut least) = (Vec::new(), plot.y.high);
    for (x, y) in sorted.into_iter().filter(|(_, y)| y.is_finite()) {
        if y < least {
            stairs.extend([(x, least), (x, y)]);
            least = y;
        }
    }
    stairs.push((plot.x.high, least));
    stairs
}

fn panel(canvas: &Canvas, plot: &Plot, marks: &[Mark], which: usize) -> Drawn {
    plot.frame(canvas)?;
    let shown: Vec<(&Mark, (f64, f64))> = marks
        .iter()
        .filter(|mark| mark.errors[which] < plot.y.high)
        .map(|mark| (mark, (mark.time, mark.errors[which])))
        .collect();
    let points: Vec<(f64, f64)> = shown.iter().map(|(_, point)| *point).collect();
    let mut curves = vec![(RGBColor(0xf0, 0xc4, 0xa0), 5.0, stairs(&points, plot))];
    for number in 1..=shown.iter().map(|(mark, _)| mark.line).max().unwrap_or(0) {
        let of: Vec<_> = shown.iter().filter(|(mark, _)| mark.line == number).collect();
        let ink = of.first().map_or(GREY, |(mark, _)| mark.ink);
        curves.push((ink, 1.0, of.iter().map(|(_, point)| *point).collect()));
    }
    // what labels keep off: marks, and lines as rows of small boxes
    let mut taken: Vec<Box4> = points.iter().map(|p| around(plot.at(p.0, p.1), 4.0)).collect();
    for (ink, width, curve) in &curves {
        plot.curve(canvas, curve, *ink, *width)?;
        for pair in curve.windows(2) {
            let (p, q) = (plot.at(pair[0].0, pair[0].1), plot.at(pair[1].0, pair[1].1));
            let steps = ((p.0 - q.0).hypot(p.1 - q.1) / 4.0).ceil();
            for k in 0..steps as usize {
                let t = k as f64 / steps;
                taken.push(around((p.0 + t * (q.0 - p.0), p.1 + t * (q.1 - p.1)), 1.5));
            }
        }
    }
    for (mark, (x, y)) in &shown {
        dot(canvas, plot.at(*x, *y), 4.0, mark.ink, mark.filled)?;
    }
    let (right, bottom) = (plot.left + plot.width, plot.top + plot.height);
    let frame = [plot.left + 4.0, plot.top + 4.0, right - 4.0, bottom - 4.0];
    // long labels first: they find room hardest
    let mut labelled = shown;
    labelled.sort_by_key(|(mark, _)| std::cmp::Reverse(mark.label.chars().count()));
    for (mark, (x, y)) in labelled.into_iter().filter(|(mark, _)| !mark.label.is_empty()) {
        let at = plot.at(x, y);
        let here = place(at, &mark.label, &frame, &taken);
        let end = (at.0.clamp(here[0], here[2]), at.1.clamp(here[1], here[3]));
        if (end.0 - at.0).hypot(end.1 - at.1) > 5.0 {
            line(canvas, &[at, end], GREY, 0.7)?;
        }
        let middle = ((here[0] + here[2]) / 2.0, (here[1] + here[3]) / 2.0);
        write(canvas, &mark.label, middle, SIZE, Align::Centre, mark.ink)?;
        taken.push(here);
    }
    Ok(())
}

pub fn draw(path: &Path, marks: &[Mark]) -> Drawn {
    let ticks = [(10.0, "10 ns"), (100.0, "100 ns"), (1e3, "1 µs"), (1e4, "10 µs")];
    let ticks: Vec<_> = ticks.into_iter().map(|(at, text)| (at, text.to_owned())).collect();
    let panels = [
        (
            "mean error of the force [μ N]",
            Axis::logarithmic(2e-3, 0.6, &[0.003, 0.01, 0.03, 0.1, 0.3]),
        ),
        (
            "mean error of the worst derivative, divided by the linear one",
            Axis::logarithmic(0.02, 0.6, &[0.03, 0.1, 0.3]),
        ),
    ];
    picture(path, (760, 1300), |canvas| {
        let title = "Error against CONTACT, by cost: forces of one contact";
        write(canvas, title, (56.0, 20.0), 17, Align::Left, INK)?;
        for (which, (title, y)) in panels.iter().enumerate() {
            let plot = Plot {
                left: 56.0,
                top: 66.0 + 590.0 * which as f64,
                width: 660.0,
                height: 510.0,
                x: Axis { low: 2.5, high: 1e5, logarithmic: true, ticks: ticks.clone() },
                y: y.clone(),
            };
            panel(canvas, &plot, marks, which)?;
            plot.title(canvas, title)?;
            let at = (plot.left + plot.width / 2.0, plot.top + plot.height + 32.0);
            write(canvas, "processor time of a contact", at, 12, Align::Centre, INK)?;
        }
        let legend = [
            "Random contacts with spin, double precision. Filled: one call for each contact. Open: \
             a contact of a",
            "batch of 100, or prepared beforehand. Lines join settings of one method. Pale band: \
             no other method",
            "is better in both. Larger errors lie outside: LINEAR, which has no saturation; \
             derivatives of",
            "FaStrip 50x50 and Vermeulen-Johnson.",
        ];
        for (k, text) in legend.iter().enumerate() {
            write(canvas, text, (56.0, 1230.0 + 18.0 * k as f64), 12, Align::Left, INK)?;
        }
        Ok(())
    })
}
