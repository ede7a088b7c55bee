//! The picture: error over cost, both logarithmic, with labels that keep out of each other's way.

use crate::pictures::*;
use plotters::style::RGBColor;
use std::path::Path;

/// A method in the picture.
pub struct Mark {
    /// Nanoseconds per call.
    pub time: f64,
    /// Mean error, `μ N`.
    pub error: f64,
    /// Empty: none.
    pub label: String,
    pub ink: RGBColor,
    pub filled: bool,
}

/// A rectangle: left, top, right, bottom.
type Box4 = [f64; 4];

fn overlap(a: &Box4, b: &Box4) -> f64 {
    let width = a[2].min(b[2]) - a[0].max(b[0]);
    let height = a[3].min(b[3]) - a[1].max(b[1]);
    width.max(0.0) * height.max(0.0)
}

const SIZE: u32 = 11;

/// Where a label goes: the place near its point that covers least of what is there already.
fn place(point: (f64, f64), text: &str, frame: &Box4, taken: &[Box4]) -> (Box4, f64) {
    let (width, height) = (5.9 * text.chars().count() as f64, f64::from(SIZE) + 1.0);
    let mut best = ([0.0; 4], 0.0, f64::INFINITY);
    for ring in 0..9 {
        let gap = 7.0 + 7.0 * f64::from(ring);
        for step in 0..24 {
            let (sine, cosine) = (f64::from(step) * std::f64::consts::TAU / 24.0).sin_cos();
            let x = point.0 + gap * cosine + 0.5 * width * (cosine * 1.5).clamp(-1.0, 1.0);
            let y = point.1 + gap * sine + 0.5 * height * (sine * 1.5).clamp(-1.0, 1.0);
            let here = [x - width / 2.0, y - height / 2.0, x + width / 2.0, y + height / 2.0];
            let covered: f64 = taken.iter().map(|other| overlap(&here, other)).sum();
            let outside = width * height - overlap(&here, frame);
            let crossed: f64 = leader(point, &here)
                .iter()
                .filter(|at| (at[0] - point.0).hypot(at[1] - point.1) > 7.0)
                .map(|at| taken.iter().filter(|other| overlap(at, other) > 0.0).count() as f64)
                .sum();
            let cost = 4.0 * covered + 100.0 * outside + 10.0 * crossed + gap;
            if cost < best.2 {
                best = (here, gap, cost);
            }
        }
    }
    (best.0, best.1)
}

/// The line from a point to its label, as a row of small boxes.
fn leader(point: (f64, f64), label: &Box4) -> Vec<Box4> {
    let end = (point.0.clamp(label[0], label[2]), point.1.clamp(label[1], label[3]));
    (0..10)
        .map(|k| {
            let t = f64::from(k) / 10.0;
            around((point.0 + t * (end.0 - point.0), point.1 + t * (end.1 - point.1)), 1.0)
        })
        .collect()
}

fn around((x, y): (f64, f64), radius: f64) -> Box4 {
    [x - radius, y - radius, x + radius, y + radius]
}

/// The methods that no other beats in both, from the quickest on.
pub fn front(marks: &[Mark]) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = marks.iter().map(|mark| (mark.time, mark.error)).collect();
    points.sort_by(|p, q| p.0.total_cmp(&q.0).then(p.1.total_cmp(&q.1)));
    let mut least = f64::INFINITY;
    points.retain(|point| {
        let better = point.1 < least;
        least = least.min(point.1);
        better
    });
    points
}

/// `measured` were timed in this run; `lines` join settings of one method; `elsewhere` are times of CONTACT's own
/// code, `reference` that of CONTACT itself.
pub fn draw(
    path: &Path,
    measured: &[Mark],
    lines: &[(RGBColor, Vec<(f64, f64)>)],
    elsewhere: &[Mark],
    reference: &Mark,
) -> Drawn {
    let time = |low: f64, high: f64, ticks: &[(f64, &str)]| Axis {
        low,
        high,
        logarithmic: true,
        ticks: ticks.iter().map(|(tick, text)| (*tick, (*text).to_owned())).collect(),
    };
    let least = measured.iter().map(|mark| mark.time).fold(f64::INFINITY, f64::min);
    let low = if least < 10.0 { 3.0 } else { 10.0 };
    let errors = Axis::logarithmic(4e-4, 3.0, &[0.001, 0.01, 0.1, 1.0]);
    let ticks =
        [(10.0, "10 ns"), (100.0, "100 ns"), (1e3, "1 µs"), (1e4, "10 µs"), (1e5, "100 µs")];
    let plot = Plot {
        left: 64.0,
        top: 66.0,
        width: 760.0,
        height: 580.0,
        x: time(low, 4e5, &ticks),
        y: errors.clone(),
    };
    let aside = Plot {
        left: 850.0,
        width: 100.0,
        x: time(1e8, 2.5e9, &[(5e8, "0.5 s")]),
        y: Axis { ticks: vec![], ..errors },
        ..Plot { x: plot.x.clone(), y: plot.y.clone(), ..plot }
    };
    picture(path, (980, 730), |canvas| {
        let title = "Error over cost: forces of one contact";
        write(canvas, title, (64.0, 22.0), 17, Align::Left, INK)?;
        let text = "mean error of the force against CONTACT on open.csv, in μ N";
        write(canvas, text, (64.0, 48.0), 13, Align::Left, INK)?;
        plot.frame(canvas)?;
        aside.frame(canvas)?;

        // the front as stairs: what is reached at a given cost
        let mut stairs = Vec::new();
        let mut before: Option<f64> = None;
        for (x, y) in front(measured) {
            stairs.push((x, before.unwrap_or(3.0)));
            stairs.push((x, y));
            before = Some(y);
        }
        if let Some(y) = before {
            stairs.push((4e5, y));
        }
        plot.curve(canvas, &stairs, RGBColor(0xf0, 0xc4, 0xa0), 5.0)?;
        for (ink, points) in lines {
            plot.curve(canvas, points, *ink, 1.0)?;
        }

        let frame = [
            plot.left + 2.0,
            plot.top + 2.0,
            plot.left + plot.width - 2.0,
            plot.top + plot.height - 2.0,
        ];
        let all = || measured.iter().chain(elsewhere);
        let mut taken: Vec<Box4> =
            all().map(|mark| around(plot.at(mark.time, mark.error), 4.0)).collect();
        // lines between settings and the front, as rows of small boxes, so that labels keep off them
        for points in lines.iter().map(|(_, points)| points).chain([&stairs]) {
            for pair in points.windows(2) {
                let (p, q) = (plot.at(pair[0].0, pair[0].1), plot.at(pair[1].0, pair[1].1));
                for k in 1..24 {
                    let t = f64::from(k) / 24.0;
                    let at = (p.0 + t * (q.0 - p.0), p.1 + t * (q.1 - p.1));
                    taken.push(around(at, 1.5));
                }
            }
        }
        for mark in all() {
            let at = plot.at(mark.time, mark.error);
            dot(canvas, at, 4.0, mark.ink, mark.filled)?;
        }
        // long labels first: they find room hardest
        let mut labelled: Vec<&Mark> = all().filter(|mark| !mark.label.is_empty()).collect();
        labelled.sort_by_key(|mark| std::cmp::Reverse(mark.label.chars().count()));
        for mark in labelled {
            let at = plot.at(mark.time, mark.error);
            let (here, gap) = place(at, &mark.label, &frame, &taken);
            let middle = ((here[0] + here[2]) / 2.0, (here[1] + here[3]) / 2.0);
            if gap > 15.0 {
                let end = (at.0.clamp(here[0], here[2]), at.1.clamp(here[1], here[3]));
                line(canvas, &[at, end], GREY, 0.7)?;
                taken.extend(leader(at, &here));
            }
            write(canvas, &mark.label, middle, SIZE, Align::Centre, mark.ink)?;
            taken.push(here);
        }

        let at = aside.at(reference.time, reference.error);
        dot(canvas, at, 4.0, reference.ink, true)?;
        write(canvas, &reference.label, (at.0, at.1 - 14.0), SIZE, Align::Centre, reference.ink)?;
        let legend = [
            "Filled: double precision; open: single precision, and times of CONTACT's own code from another \
             run. Orange band: the Pareto front, what no other method beats in both.",
            "CONTACT is the reference; its point stands at its own estimated error. Numbers along a line: strips or grid. \
             Batch: per contact of 512. LINEAR has no saturation.",
        ];
        for (k, text) in legend.iter().enumerate() {
            write(canvas, text, (64.0, 684.0 + 20.0 * k as f64), 12, Align::Left, INK)?;
        }
        Ok(())
    })
}
