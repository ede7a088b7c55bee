//! What a simulation feels: slopes, ripple, limits and power, and the picture of a sweep.

use crate::lines::Lines;
use crate::peer_methods::{Solver, fastrip_on, fastsim_on, input};
use crate::peers::fastsim::{Bound, Flexibility, Layout};
use crate::pictures::*;
use crate::{Report, digits, has_strips};
use kstrip::contact::totals::StripCount;
use kstrip::forces::Model;
use kstrip_testing::reference::*;
use kstrip_testing::slopes::*;
use plotters::style::RGBColor;
use std::path::Path;

/// A method that solves a case.
struct Felt {
    name: String,
    solve: Box<dyn Fn(&Case) -> Answer>,
}

fn of_model(model: Model, strips: StripCount) -> Felt {
    let options = options(model, strips);
    let mut name = name(model).to_owned();
    if has_strips(model) {
        name += &format!(", {} strips", strips as i32);
    }
    Felt { name, solve: Box::new(move |case| answer::<f64>(case, &options)) }
}

fn of_peer((name, solve): (String, Solver)) -> Felt {
    let solve = move |case: &Case| {
        let output = solve(&input(case, &[]));
        Answer { force: [output.fx, output.fy], moment: output.mz, stick: f64::NAN }
    };
    Felt { name, solve: Box::new(solve) }
}

fn fastsim() -> Felt {
    of_peer(fastsim_on::<10, 10>(Layout::StripCentres, Flexibility::Three, Bound::Parabolic))
}

fn methods() -> Vec<Felt> {
    use Flexibility::{Blended, Energy, Kalker, Three};
    use StripCount::{Eight, Sixteen, SixtyFour};
    let peers = [
        fastsim_on::<10, 10>(Layout::StripCentres, Three, Bound::Parabolic),
        fastsim_on::<50, 10>(Layout::StripCentres, Three, Bound::Parabolic),
        fastsim_on::<20, 10>(Layout::Rectangle, Blended, Bound::Parabolic),
        fastrip_on::<20, 20>(Kalker),
        fastrip_on::<20, 20>(Energy),
        fastrip_on::<80, 50>(Energy),
    ];
    let models = [
        (Model::Strip1967, Sixteen),
        (Model::Strip1967Continuous, Sixteen),
        (Model::Strip, Sixteen),
        (Model::Strip, Eight),
        (Model::Strip, SixtyFour),
        (Model::Total, Sixteen),
        (Model::Linear, Sixteen),
    ];
    let models = models.map(|(model, strips)| of_model(model, strips));
    models.into_iter().chain(peers.map(of_peer)).collect()
}

fn mean_p95_max(errors: &[f64]) -> String {
    let Figures { mean, p95, max } = figures(errors);
    format!("{} / {} / {}", digits(mean), digits(p95), digits(max))
}

/// A part of the slope cases and its name.
type Part = (&'static str, fn(&Case) -> bool);

const PARTS: [Part; 8] = [
    ("all", |_| true),
    ("ψ = 0", |c| c.psi() == 0.0),
    ("\\|ψ\\| up to 0.5", |c| c.psi() != 0.0 && c.psi().abs() <= 0.5),
    ("\\|ψ\\| > 0.5", |c| c.psi().abs() > 0.5),
    ("a/b up to 0.5", |c| c.axis_ratio <= 0.5),
    ("a/b 0.5 to 2", |c| c.axis_ratio > 0.5 && c.axis_ratio < 2.0),
    ("a/b from 2", |c| c.axis_ratio >= 2.0),
    ("force of linear theory above 1", |c| {
        let [x, y, spin] = c.linear_force();
        x.hypot(y + spin) > 1.0
    }),
];

impl Report {
    /// The chapter on slopes, ripple, limits and power.
    pub fn feel(&mut self) {
        let methods = methods();
        let cases = slope_cases();
        self.line("\n## What a simulation uses\n");
        self.line(include_str!("feel.txt").trim_end());
        self.line("");
        self.header(&[
            "method",
            "derivatives",
            "rises of the slope without spin",
            "fall after the maximum",
            "ripple with spin, fx",
            "ripple, fy",
            "limit, force",
            "limit, moment",
            "least power",
            "states below zero",
        ]);
        for method in &methods {
            let solve = &*method.solve;
            let slopes: Vec<f64> = cases.iter().map(|case| case.error(solve).0).collect();
            let mut cells = vec![method.name.clone(), mean_p95_max(&slopes)];
            if method.name == "LINEAR" {
                cells.resize(10, "–".to_owned());
            } else {
                let (rises, fall) = rays(400, solve);
                let [fx, fy] = ripple(solve);
                let [force, moment] = limits(solve);
                let (least, below) = power(20_000, solve);
                cells.extend([mean_p95_max(&rises), format!("{fall:.4}")]);
                cells.extend([fx, fy, force, moment].map(|errors| mean_p95_max(&errors)));
                cells.extend([digits(least), format!("{:.2} %", 100.0 * below)]);
            }
            self.row(cells);
        }
        self.slopes_by_region(&methods, &cases);
        self.worst_slopes(&cases);
    }

    fn slopes_by_region(&mut self, methods: &[Felt], cases: &[SlopeCase]) {
        self.line("\n### Derivatives, region by region: mean / 95th percentile / max\n");
        let mut header = vec!["method".to_owned()];
        header.extend(PARTS.map(|(part, holds)| {
            format!("{part} ({} cases)", cases.iter().filter(|c| holds(&c.case)).count())
        }));
        self.header(&header);
        for method in methods {
            let mut cells = vec![method.name.clone()];
            cells.extend(PARTS.map(|(_, holds)| {
                let inside = cases.iter().filter(|c| holds(&c.case));
                let errors: Vec<f64> = inside.map(|c| c.error(&*method.solve).0).collect();
                mean_p95_max(&errors)
            }));
            self.row(cells);
        }
    }

    fn worst_slopes(&mut self, cases: &[SlopeCase]) {
        for model in [Model::Strip, Model::Total] {
            self.line(format!("\n### The five worst derivatives of {}\n", name(model)));
            self.header(&[
                "a/b",
                "ν",
                "vx",
                "vy",
                "φ",
                "ψ",
                "derivative",
                "model",
                "CONTACT",
                "error",
            ]);
            let method = of_model(model, StripCount::Sixteen);
            let mut worst: Vec<_> =
                cases.iter().map(|case| (case.error(&*method.solve), case)).collect();
            worst.sort_by(|p, q| q.0.0.total_cmp(&p.0.0));
            for ((error, force, axis, found), SlopeCase { case, slopes }) in worst.iter().take(5) {
                let [vx, vy, phi] = case.creepage;
                let state = [case.axis_ratio, case.poisson_ratio, vx, vy, phi, case.psi()];
                let mut cells: Vec<String> = state.map(|x| format!("{x:.4}")).into();
                cells.push(ENTRIES[*force][*axis].to_owned());
                cells.extend([*found, slopes[*force][*axis], *error].map(|x| format!("{x:.4}")));
                self.row(cells);
            }
        }
    }

    /// The creep curve and its slope along two sweeps of `open.csv`: longitudinal creepage, and
    /// spin.
    pub fn sweep(&self, path: &Path) -> Drawn {
        let curves: [(Felt, RGBColor, f64); 4] = [
            (of_model(Model::Strip1967, StripCount::Sixteen), GREEN, 1.5),
            (fastsim(), AMBER, 1.5),
            (of_model(Model::Strip, StripCount::Sixteen), VERMILION, 2.0),
            (of_model(Model::Total, StripCount::Sixteen), BLUE, 2.5),
        ];
        let sweeps = [(0, 0, 2.0, "longitudinal creepage"), (2, 1, 2.0, "spin")];
        picture(path, (860, 560), |canvas| {
            let title =
                "Creep force and its derivative against CONTACT: a circle (a/b = 1), ν = 0.28";
            write(canvas, title, (56.0, 20.0), 16, Align::Left, INK)?;
            for (column, (axis, force, end, what)) in sweeps.into_iter().enumerate() {
                let left = 56.0 + 410.0 * column as f64;
                let panel = |top: f64, height: f64, y: Axis| Plot {
                    left,
                    top,
                    width: 370.0,
                    height,
                    x: Axis::linear(0.0, end, &[0.0, 0.5, 1.0, 1.5, 2.0]),
                    y,
                };
                let curve =
                    panel(62.0, 190.0, Axis::linear(0.0, 1.05, &[0.0, 0.25, 0.5, 0.75, 1.0]));
                let slopes = panel(286.0, 190.0, Axis::linear(-0.6, 1.2, &[-0.5, 0.0, 0.5, 1.0]));
                curve.frame(canvas)?;
                slopes.frame(canvas)?;
                let component = ["fx", "fy"][force];
                curve.title(canvas, &format!("{component}/(μ N) against {what}"))?;
                slopes.title(canvas, "its derivative, divided by that at rest")?;
                slopes.curve(canvas, &[(0.0, 0.0), (end, 0.0)], GREY, 1.0)?;
                let unit = linear_steps(1.0, 0.28)[axis];
                let at = |u: f64| {
                    let mut creepage = [0.0; 3];
                    creepage[axis] = u * unit;
                    Case { axis_ratio: 1.0, poisson_ratio: 0.28, creepage, ..self.open[0].clone() }
                };
                for (method, ink, width) in &curves {
                    let solve = &*method.solve;
                    let places = (0..=400).map(|i| end * f64::from(i) / 400.0);
                    let force_at = |u| (u, solve(&at(u)).force[force]);
                    curve.curve(
                        canvas,
                        &places.clone().map(force_at).collect::<Vec<_>>(),
                        *ink,
                        *width,
                    )?;
                    let inside = |y: f64| y.clamp(slopes.y.low, slopes.y.high);
                    let slope_at = |u| (u, inside(slope(&at(u), axis, 1e-3, solve)[force]));
                    slopes.curve(
                        canvas,
                        &places.map(slope_at).collect::<Vec<_>>(),
                        *ink,
                        *width,
                    )?;
                }
                let mut family: Vec<(f64, f64)> = self
                    .open
                    .iter()
                    .filter(|case| case.axis_ratio == 1.0)
                    .filter(|case| (0..3).all(|k| (case.creepage[k] != 0.0) == (k == axis)))
                    .map(|case| (case.creepage[axis] / unit, case.force[force]))
                    .filter(|(u, _)| *u > 0.0 && *u <= end * 1.1)
                    .collect();
                family.push((0.0, 0.0));
                family.sort_by(|p, q| p.0.total_cmp(&q.0));
                for (u, force) in family.iter().filter(|(u, _)| *u <= end) {
                    dot(canvas, curve.at(*u, *force), 3.2, INK, true)?;
                }
                for pair in family.windows(2).filter(|pair| pair[1].0 <= end) {
                    let rise = (pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0);
                    slopes.curve(canvas, &[(pair[0].0, rise), (pair[1].0, rise)], INK, 1.0)?;
                    dot(canvas, slopes.at(0.5 * (pair[0].0 + pair[1].0), rise), 3.2, INK, true)?;
                }
                let middle = left + 185.0;
                let name = ["C11 vx", "C22 vy", "C23 φ"][axis];
                let text = format!("{what}: linear force {name} divided by μ N");
                write(canvas, &text, (middle, 504.0), 13, Align::Centre, INK)?;
            }
            let (y, mut x) = (538.0, 56.0);
            dot(canvas, (x + 8.0, y), 3.2, INK, true)?;
            write(
                canvas,
                "CONTACT (derivative: differences)",
                (x + 20.0, y),
                13,
                Align::Left,
                INK,
            )?;
            x += 270.0;
            for (ink, text, width) in [
                (BLUE, "TOTAL", 80.0),
                (VERMILION, "STRIP", 80.0),
                (GREEN, "STRIP_1967", 120.0),
                (AMBER, "FASTSIM 10x10", 120.0),
            ] {
                line(canvas, &[(x, y), (x + 24.0, y)], ink, 2.5)?;
                write(canvas, text, (x + 30.0, y), 13, Align::Left, INK)?;
                x += 36.0 + width;
            }
            Ok(())
        })
    }
}
