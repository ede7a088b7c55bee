//! Compares every model, and the other methods of `benches/peers`, with the reference data:
//! `cargo bench --bench accuracy` writes `docs/evidence/accuracy.md` and the pictures in
//! `docs/evidence/accuracy/`. The same build writes the same files, byte by byte.

#[path = "accuracy/feel.rs"]
mod feel;
#[path = "common/lines.rs"]
mod lines;
#[path = "common/peer_methods.rs"]
mod peer_methods;
#[path = "../benches/peers/mod.rs"]
mod peers;
#[path = "accuracy/pictures.rs"]
mod pictures;
#[path = "common/progress.rs"]
mod progress;

use kstrip::contact::totals::StripCount;
use kstrip::forces::Model;
use kstrip_testing::reference::*;
use kstrip_testing::toolchain::root;
use lines::Lines;
use peer_methods::*;
use peers::fastsim::{Bound, Flexibility, Layout};
use peers::{polach, shen_hedrick_elkins, vermeulen_johnson};
use pictures::*;
use plotters::style::RGBColor;
use std::path::Path;

/// A method and its errors on all cases of a set.
struct Method {
    name: String,
    remark: &'static str,
    open: Errors,
    validation: Errors,
}

/// A chapter of the report.
type Part = (&'static str, fn(&mut Report));

struct Report {
    open: Vec<Case>,
    validation: Vec<Case>,
    models: Vec<Method>,
    peers: Vec<Method>,
    text: String,
}

// --- methods ---------------------------------------------------------------------------------

fn other_methods() -> Vec<(String, Solver)> {
    use Bound::{Elliptic, Parabolic};
    use Flexibility::{Blended, Energy, Kalker, Three};
    use Layout::{Rectangle, StripCentres};
    vec![
        fastsim_on::<10, 10>(StripCentres, Three, Parabolic),
        fastsim_on::<20, 10>(StripCentres, Three, Parabolic),
        fastsim_on::<50, 10>(StripCentres, Three, Parabolic),
        fastsim_on::<10, 10>(StripCentres, Three, Elliptic),
        fastsim_on::<20, 10>(StripCentres, Three, Elliptic),
        fastsim_on::<50, 10>(StripCentres, Three, Elliptic),
        fastsim_on::<10, 10>(StripCentres, Kalker, Parabolic),
        fastsim_on::<20, 10>(StripCentres, Kalker, Parabolic),
        fastsim_on::<50, 10>(StripCentres, Kalker, Parabolic),
        fastsim_on::<10, 10>(StripCentres, Energy, Parabolic),
        fastsim_on::<20, 10>(StripCentres, Energy, Parabolic),
        fastsim_on::<50, 10>(StripCentres, Energy, Parabolic),
        fastsim_on::<10, 10>(Rectangle, Blended, Parabolic),
        fastsim_on::<20, 10>(Rectangle, Blended, Parabolic),
        fastsim_on::<50, 10>(Rectangle, Blended, Parabolic),
        fastrip_on::<20, 20>(Kalker),
        fastrip_on::<80, 50>(Kalker),
        fastrip_on::<20, 20>(Energy),
        fastrip_on::<80, 50>(Energy),
        fastrip_contact_on::<20>(),
        fastrip_contact_on::<50>(),
        ("Shen-Hedrick-Elkins".into(), Box::new(shen_hedrick_elkins::solve)),
        ("Polach".into(), Box::new(polach::solve)),
        ("Vermeulen-Johnson (spin ignored)".into(), Box::new(vermeulen_johnson::solve)),
    ]
}

/// FASTSIM as most programs have it.
const PLAIN_FASTSIM: &str = "FASTSIM 10x10, 3 flexibilities, parabolic";

/// The methods whose errors are shown by region and as pictures.
const COMPARED: [&str; 2] =
    ["FASTSIM 20x20, blended as in CONTACT, parabolic", "FaStrip 20x20, flexibility (energy)"];

fn has_strips(model: Model) -> bool {
    !matches!(model, Model::Total | Model::Linear)
}

fn model_method(open: &[Case], validation: &[Case], model: Model) -> Method {
    let options = options(model, StripCount::Sixteen);
    let mut name = name(model).to_owned();
    if has_strips(model) {
        name += ", 16 strips";
    }
    Method {
        name,
        remark: if model == Model::Linear { "its force has no bound" } else { "" },
        open: Errors::of_model::<f64>(open, &options),
        validation: Errors::of_model::<f64>(validation, &options),
    }
}

fn peer_method(
    open: &[Case], validation: &[Case], table: &[CoefficientCase], (name, solve): (String, Solver),
) -> Method {
    let errors = |cases| peer_errors(cases, table, &solve);
    Method { name, remark: "", open: errors(open), validation: errors(validation) }
}

// --- tables ----------------------------------------------------------------------------------

/// Four digits after the point, or a dash where there is no figure.
fn digits(value: f64) -> String {
    if value.is_nan() { "–".to_owned() } else { format!("{value:.4}") }
}

fn all_figures(errors: &Errors) -> [String; 7] {
    let (force, moment, stick) =
        (figures(&errors.force), figures(&errors.moment), figures(&errors.stick));
    [force.mean, force.p95, force.max, moment.mean, moment.p95, moment.max, stick.mean].map(digits)
}

/// Mean / 95th percentile / maximum of the force.
fn three(errors: &Errors) -> String {
    let Figures { mean, p95, max } = figures(&errors.force);
    format!("{mean:.4} / {p95:.4} / {max:.4}")
}

fn two(errors: &Errors) -> String {
    let Figures { mean, max, .. } = figures(&errors.moment);
    if mean.is_nan() { "–".to_owned() } else { format!("{mean:.4} / {max:.4}") }
}

/// Figures of methods on one of both sets of cases.
fn rows(methods: &[&Method], open: bool) -> Vec<Vec<String>> {
    let row = |method: &&Method| {
        let mut name = method.name.clone();
        if !method.remark.is_empty() {
            name = format!("{name} ({})", method.remark);
        }
        let mut cells = vec![name];
        cells.extend(all_figures(if open { &method.open } else { &method.validation }));
        cells
    };
    methods.iter().map(row).collect()
}

/// A part of the cases and its name.
type Named = (String, Box<dyn Fn(&Case) -> bool>);

struct Dimension {
    title: &'static str,
    regions: Vec<Named>,
}

/// Ranges between the borders, the lower one excluded; `0` alone is the first.
fn ranges(symbol: &str, borders: &[f64], value: fn(&Case) -> f64) -> Vec<Named> {
    let mut regions: Vec<Named> = Vec::new();
    if borders[0] == 0.0 {
        regions.push((format!("{symbol} = 0"), Box::new(move |case| value(case) <= 1e-9)));
    }
    for pair in borders.windows(2) {
        let (low, high) = (pair[0].max(1e-9), pair[1]);
        let name = if high.is_infinite() {
            format!("{symbol} > {low}")
        } else if pair[0] == 0.0 {
            format!("{symbol} up to {high}")
        } else {
            format!("{symbol} {low} to {high}")
        };
        let holds = move |case: &Case| value(case) > low && value(case) <= high;
        regions.push((name, Box::new(holds)));
    }
    regions
}

const PSI: [f64; 7] = [0.0, 0.3, 0.6, 0.999, 1.5, 2.25, f64::INFINITY];

fn dimensions() -> [Dimension; 3] {
    [
        Dimension {
            title: "by shape of the contact",
            // between the axis ratios of open.csv
            regions: ranges("a/b", &[0.05, 0.15, 0.35, 0.7, 1.5, 3.0, 7.0, 20.0], |case| {
                case.axis_ratio
            }),
        },
        Dimension { title: "by spin", regions: ranges("\\|ψ\\|", &PSI, |case| case.psi().abs()) },
        Dimension {
            title: "by creepage without spin, as the force `u = |(C11 vx, C22 vy)|` of linear \
                 theory",
            regions: ranges("u", &[0.0, 0.3, 0.6, 1.0, 2.0, 3.0, f64::INFINITY], Case::creep_force),
        },
    ]
}

impl Lines for Report {
    fn text(&mut self) -> &mut String {
        &mut self.text
    }
}

impl Report {
    fn compute() -> Self {
        let (open, validation) = (open(), validation());
        let table = coefficient_cases();
        let methods = other_methods();
        let bar = progress::bar((Model::ALL.len() + methods.len()) as u64);
        let done = |method: Method| {
            bar.set_message(method.name.clone());
            bar.inc(1);
            method
        };
        let models = Model::ALL.map(|model| done(model_method(&open, &validation, model))).into();
        let peers = methods
            .into_iter()
            .map(|method| done(peer_method(&open, &validation, &table, method)))
            .collect();
        bar.finish_and_clear();
        Self { open, validation, models, peers, text: String::new() }
    }

    fn compared(&self) -> Vec<&Method> {
        let others =
            COMPARED.iter().filter_map(|name| self.peers.iter().find(|peer| peer.name == *name));
        self.models.iter().chain(others).collect()
    }

    fn method(&self, name: &str) -> Option<&Method> {
        self.compared().into_iter().find(|method| method.name.starts_with(name))
    }

    fn introduction(&mut self) {
        self.line(include_str!("accuracy/introduction.txt").trim_end());
    }

    fn reference(&mut self) {
        self.line("");
        self.line(include_str!("accuracy/reference.txt").trim_end());
    }

    fn all_methods(&mut self) {
        self.line("\n## All methods, all cases\n");
        self.line(
            "The 854 cases of `open.csv` have ν = 0.28, a/b 0.1 to 10 and |ψ| up to 3. \
             Forces are in μ N, moments in μ N √(ab). The stick area is a share of the \
             contact area. The sign – means that the method has no such result.\n",
        );
        let main: Vec<&Method> = self.models.iter().chain(self.main_peers()).collect();
        let rows = [true, false].map(|open| rows(&main, open));
        self.error_table(&rows[0]);
        let largest =
            |value: fn(&Case) -> f64| self.validation.iter().map(value).fold(0.0, f64::max);
        let text = format!(
            "\nThe validation cases are the {} rows of the training files that no fit was trained \
             on. ν is 0 to 0.5, a/b is {:.2} to {:.1}, and |ψ| is up to {:.0}. Some of these rows \
             are beyond the range for which STRIP and TOTAL are meant. The reference is coarser \
             here.\n",
            self.validation.len(),
            1.0 / largest(|case| 1.0 / case.axis_ratio),
            largest(|case| case.axis_ratio),
            largest(|case| case.psi().abs()),
        );
        self.line(text);
        self.error_table(&rows[1]);
        self.line(
            "\nFASTSIM and FaStrip have [many variants](#variants-of-fastsim-and-fastrip).\n",
        );
        self.line(
            "![The same histogram for the validation cases](accuracy/histogram_validation.svg)",
        );
    }

    /// The other methods of the first tables: the plain FASTSIM, the better variants on 20x20
    /// cells, closed forms.
    fn main_peers(&self) -> impl Iterator<Item = &Method> {
        self.peers.iter().filter(|peer| {
            let fast = peer.name.starts_with("FASTSIM") || peer.name.starts_with("FaStrip");
            !fast || peer.name == PLAIN_FASTSIM || COMPARED.contains(&peer.name.as_str())
        })
    }

    fn error_table(&mut self, rows: &[Vec<String>]) {
        self.header(&[
            "method",
            "force, mean",
            "95th percentile",
            "max",
            "moment, mean",
            "95th percentile",
            "max",
            "stick area, mean",
        ]);
        for cells in rows {
            self.row(cells);
        }
    }

    fn variants(&mut self) {
        self.line("\n## Variants of FASTSIM and FaStrip\n");
        let all: Vec<&Method> = self.peers.iter().collect();
        let [open, validation] = [true, false].map(|open| rows(&all, open));
        self.line("`open.csv`:\n");
        self.error_table(&open);
        self.line("\nValidation:\n");
        self.error_table(&validation);
    }

    fn by_strip_count(&mut self) {
        self.line("\n## Strip count and precision\n");
        self.line(
            "The table has the cases of `open.csv` in double precision (`f64`) and single \
             precision (`f32`).\n",
        );
        self.header(&[
            "model",
            "strips",
            "force, f64: mean / 95th percentile / max",
            "force, f32",
            "moment, f64: mean / max",
            "moment, f32",
            "largest difference f32 to f64",
        ]);
        for model in Model::ALL {
            let counts =
                if has_strips(model) { &StripCount::ALL[..] } else { &[StripCount::Sixteen] };
            for count in counts {
                let options = options(model, *count);
                let double = Errors::of_model::<f64>(&self.open, &options);
                let single = Errors::of_model::<f32>(&self.open, &options);
                let difference = self.open.iter().fold(0.0_f64, |largest, case| {
                    let (p, q) = (answer::<f64>(case, &options), answer::<f32>(case, &options));
                    let force = (p.force[0] - q.force[0]).hypot(p.force[1] - q.force[1]);
                    largest.max(force)
                });
                let strips = (*count as i32).to_string();
                self.row([
                    name(model),
                    if has_strips(model) { &strips } else { "–" },
                    &three(&double),
                    &three(&single),
                    &two(&double),
                    &two(&single),
                    &format!("{difference:.1e}"),
                ]);
            }
        }
    }

    fn by_region(&mut self) {
        self.line("\n## By region\n");
        self.line(
            "The tables have mean / 95th percentile / max of `|f − f_ref|`. The last two \
             methods are the better variants of FASTSIM and FaStrip on 20x20 cells. LINEAR is \
             in the tables to show where it may be used.\n",
        );
        for (set, open) in [("open.csv", true), ("validation", false)] {
            for dimension in dimensions() {
                self.line(format!("\n### {set}, {}\n", dimension.title));
                let titles: Vec<String> = self.compared().iter().map(|m| m.name.clone()).collect();
                let mut header = vec!["region".to_owned(), "cases".to_owned()];
                header.extend(titles);
                self.header(&header);
                for (region, holds) in &dimension.regions {
                    let cases = if open { &self.open } else { &self.validation };
                    let count = cases.iter().filter(|case| holds(case)).count();
                    if count == 0 {
                        continue;
                    }
                    let mut cells = vec![region.clone(), count.to_string()];
                    for method in self.compared() {
                        let errors = if open { &method.open } else { &method.validation };
                        cells.push(three(&errors.only(cases, holds)));
                    }
                    self.row(cells);
                }
            }
        }
        self.line("\n### Moment, open.csv: mean / max\n");
        let mut header = vec!["region".to_owned(), "cases".to_owned()];
        header.extend(self.compared().iter().map(|m| m.name.clone()));
        self.header(&header);
        for dimension in dimensions() {
            for (region, holds) in &dimension.regions {
                let count = self.open.iter().filter(|case| holds(case)).count();
                let mut cells = vec![region.clone(), count.to_string()];
                for method in self.compared() {
                    cells.push(two(&method.open.only(&self.open, holds)));
                }
                if count > 0 {
                    self.row(cells);
                }
            }
        }
        self.line("\n![Mean force error against shape and spin](accuracy/map_shape_spin.svg)\n");
        self.line("![Force error against creepage and spin](accuracy/map_creepage_spin.svg)");
    }

    fn slender(&mut self) {
        self.line("\n## Slender contacts\n");
        self.line(
            "`open_slender.csv` has 140 cases beyond the axis ratios of `open.csv`. No fit uses \
             them. ν is 0 to 0.5. The table has mean / 95th percentile / max of the force, and \
             mean / max of the moment in μ N √(ab). FASTSIM and FaStrip use the linear \
             coefficients of the library. STRIP and TOTAL warn for `a/b` below 0.015 and above \
             60.\n",
        );
        self.by_axis_ratio(&slender(), &[0.015, 0.03, 0.06, 0.12, 8.0, 12.0, 20.0, 40.0, 60.1]);
    }

    fn turning(&mut self) {
        self.line("\n## Large creepage balanced by spin\n");
        self.line(
            "`boundary_elements.csv` has 576 cases of 24 contacts, with linear forces ≤ 100 and ψ \
             ≤ 5. In half of them the creepage balances the spin somewhere in the contact. All \
             were computed with this project's boundary elements (`fit/boundary_elements.py`). No \
             fit uses them.\n",
        );
        self.by_axis_ratio(&turning(), &[0.015, 0.12, 7.0, 20.0, 60.1]);
    }

    /// Errors of TOTAL, STRIP and other methods between these axis ratios.
    fn by_axis_ratio(&mut self, cases: &[Case], borders: &[f64]) {
        let peers =
            other_methods().into_iter().filter(|(name, _)| COMPARED.contains(&name.as_str()));
        let columns: Vec<(String, Errors)> = [Model::Total, Model::Strip]
            .into_iter()
            .map(|model| {
                let options = options(model, StripCount::Sixteen);
                (name(model).to_owned(), Errors::of_model::<f64>(cases, &options))
            })
            .chain(peers.map(|(name, solve)| (name, peer_errors(cases, &[], &solve))))
            .collect();
        let mut header = vec!["region".to_owned(), "cases".to_owned()];
        header.extend(columns.iter().map(|(name, _)| name.clone()));
        header.extend(columns.iter().map(|(name, _)| format!("{name}: moment")));
        self.header(&header);
        for (region, holds) in ranges("a/b", borders, |case| case.axis_ratio) {
            let count = cases.iter().filter(|case| holds(case)).count();
            if count == 0 {
                continue;
            }
            let mut cells = vec![region.replace("60.1", "60"), count.to_string()];
            cells.extend(columns.iter().map(|(_, errors)| three(&errors.only(cases, &holds))));
            cells.extend(columns.iter().map(|(_, errors)| two(&errors.only(cases, &holds))));
            self.row(cells);
        }
    }

    fn unlike(&mut self) {
        self.line("\n## Dissimilar materials\n");
        self.line(
            "`kappa.csv` has 170 pairs of results of CONTACT, with and without the mismatch `κ` of \
             the materials. Errors are of the force change due to `κ`, \
             `|(f − f₀) − (f − f₀)_ref|` in μ N. The table has mean / 95th percentile / max. \
             Ordinary pairs have `|κ|` up to 0.13 and μ from 0.3 on, such as steel on aluminium, \
             cast iron or bronze. FASTSIM, FaStrip and STRIP_1967 have no `κ`. Their errors are in \
             the first row.\n",
        );
        self.header(&["method", "all", "ordinary pairs"]);
        let pairs = unlike();
        let models = [Model::Total, Model::Strip, Model::Linear];
        for model in [None].into_iter().chain(models.map(Some)) {
            let mut errors = Errors::default();
            let mut ordinary = Errors::default();
            for pair in &pairs {
                let difference = model.map_or([0.0; 2], |model| pair.difference(model));
                let off =
                    (difference[0] - pair.difference[0]).hypot(difference[1] - pair.difference[1]);
                errors.force.push(off);
                if pair.is_ordinary() {
                    ordinary.force.push(off);
                }
            }
            let title = model.map_or("`κ` neglected", name);
            self.row([title.to_owned(), three(&errors), three(&ordinary)]);
        }
    }

    fn worst_cases(&mut self) {
        for (model, open) in [
            (Model::Strip, true),
            (Model::Total, true),
            (Model::Strip, false),
            (Model::Total, false),
        ] {
            let set = if open { "open.csv" } else { "validation" };
            self.line(format!("\n### The ten worst cases of {} on {set}\n", name(model)));
            self.header(&[
                "a/b",
                "ν",
                "vx",
                "vy",
                "φ",
                "ψ",
                "fx",
                "fy",
                "mz",
                "fx ref",
                "fy ref",
                "mz ref",
                "stick ref",
                "error",
            ]);
            let cases = if open { self.open.clone() } else { self.validation.clone() };
            let options = options(model, StripCount::Sixteen);
            let errors = Errors::of_model::<f64>(&cases, &options);
            let mut order: Vec<usize> = (0..cases.len()).collect();
            order.sort_by(|p, q| errors.force[*q].total_cmp(&errors.force[*p]));
            for index in order.into_iter().take(10) {
                let case = &cases[index];
                let ours = answer::<f64>(case, &options);
                let [vx, vy, phi] = case.creepage;
                let four = |x: f64| format!("{x:.4}").replace("-0.0000", "0.0000");
                self.row(
                    [case.axis_ratio, case.poisson_ratio, vx, vy, phi, case.psi()]
                        .into_iter()
                        .chain([ours.force[0], ours.force[1], ours.moment])
                        .chain([case.force[0], case.force[1], case.moment, case.stick])
                        .chain([errors.force[index]])
                        .map(four),
                );
            }
        }
    }

    fn fields(&mut self) {
        self.line("\n## Traction fields\n");
        self.line(
            "The table has the 11 fields in `tests/data/fields`. The error is the sum of `|p \
             − p_ref|` divided by the sum of `μ p_n`, both for the cells of the reference. \
             The stick area is the share of the cells that stick, minus the share in the \
             reference. A wrong state is a cell that sticks in one result and slips in the \
             other.\n",
        );
        self.header(&[
            "case",
            "a/b",
            "ν",
            "ξ, η, ψ",
            "STRIP: error",
            "stick area",
            "wrong state",
            "STRIP_1967: error",
            "stick area",
            "wrong state",
            "1967, continuous: error",
        ]);
        let cases = fields();
        let models = [Model::Strip, Model::Strip1967, Model::Strip1967Continuous];
        let mut sums = [[0.0; 3]; 3];
        let mut largest = [0.0_f64; 3];
        for case in &cases {
            let mut cells = vec![
                case.name.clone(),
                case.axis_ratio.to_string(),
                case.poisson_ratio.to_string(),
                case.parameters.map(|p| p.to_string()).join(", "),
            ];
            for (k, model) in models.into_iter().enumerate() {
                let e = case.errors::<f64>(model);
                sums[k][0] += e.traction;
                sums[k][1] += e.stick.abs();
                sums[k][2] += e.wrong_state;
                largest[k] = largest[k].max(e.traction);
                cells.push(format!("{:.3}", e.traction));
                if k < 2 {
                    cells.push(format!("{:+.3}", e.stick));
                    cells.push(format!("{:.3}", e.wrong_state));
                }
            }
            self.row(cells);
        }
        let count = cases.len() as f64;
        let mean = |k: usize, i: usize| format!("{:.3}", sums[k][i] / count);
        self.row([
            "mean (stick area: of its size)".to_owned(),
            String::new(),
            String::new(),
            String::new(),
            mean(0, 0),
            mean(0, 1),
            mean(0, 2),
            mean(1, 0),
            mean(1, 1),
            mean(1, 2),
            mean(2, 0),
        ]);
        self.row([
            "largest".to_owned(),
            String::new(),
            String::new(),
            String::new(),
            format!("{:.3}", largest[0]),
            String::new(),
            String::new(),
            format!("{:.3}", largest[1]),
            String::new(),
            String::new(),
            format!("{:.3}", largest[2]),
        ]);
        self.line("\n![Traction along strips](accuracy/fields.svg)");
    }

    fn coefficients(&mut self) {
        self.line("\n## Linear coefficients\n");
        self.line(
            "The table has the coefficients of the library divided by the coefficients of CONTACT, \
             minus one, in per cent, for four values of ν. The reference's error is about 0.3 %, \
             or about 1 % for `C33` at a/b ≥ 5. LINEAR uses these coefficients as they are. STRIP \
             and TOTAL have them as their derivatives at zero.\n",
        );
        self.header(&["a/b", "C11", "C22", "C23", "C33"]);
        let cases = coefficient_cases();
        let mut ratios: Vec<f64> = cases.iter().map(|c| c.axis_ratio).collect();
        ratios.sort_by(f64::total_cmp);
        ratios.dedup();
        let mut largest = [0.0_f64; 4];
        for ratio in ratios {
            let mut cells = vec![ratio.to_string()];
            for (k, largest) in largest.iter_mut().enumerate() {
                let errors: Vec<String> = cases
                    .iter()
                    .filter(|case| case.axis_ratio == ratio)
                    .map(|case| {
                        let error = case.errors::<f64>()[k];
                        *largest = largest.max(error.abs());
                        format!("{:+.2}", 100.0 * error).replace("-0.00", "+0.00")
                    })
                    .collect();
                cells.push(errors.join(", "));
            }
            self.row(cells);
        }
        let mut cells = vec!["largest".to_owned()];
        cells.extend(largest.map(|error| format!("{:.2}", 100.0 * error)));
        self.row(cells);
        self.line("\n![Errors of the linear coefficients](accuracy/coefficients.svg)");
    }
}

// --- pictures --------------------------------------------------------------------------------

const FORCE_ERROR: &str = "|f − f_ref| / (μ N)";

/// One row per method: how many cases have which error.
fn histogram(path: &Path, title: &str, rows: &[(&str, &[f64], RGBColor)]) -> Drawn {
    const BINS: usize = 40;
    let (low, high) = (1e-4_f64, 1.0_f64);
    let (left, width, height, step) = (60.0, 560.0, 74.0, 112.0);
    let size = (820, (70.0 + step * rows.len() as f64 + 24.0) as u32);
    picture(path, size, |canvas| {
        write(canvas, title, (left, 20.0), 17, Align::Left, INK)?;
        for (k, (name, errors, colour)) in rows.iter().enumerate() {
            let mut bins = [0_u32; BINS];
            for error in *errors {
                let share = (error.clamp(low, high * 0.999_999) / low).log10() / 4.0;
                bins[((share * BINS as f64) as usize).min(BINS - 1)] += 1;
            }
            let total = errors.len() as f64;
            let tallest = f64::from(bins.iter().copied().max().unwrap_or(1)) / total;
            let last = k + 1 == rows.len();
            let mut x = Axis::logarithmic(low, high, &[1e-4, 1e-3, 1e-2, 0.1, 1.0]);
            if !last {
                x.ticks.iter_mut().for_each(|tick| tick.1.clear());
            }
            let share = (tallest * 100.0 / 5.0).ceil() * 5.0;
            let y = Axis {
                low: 0.0,
                high: share,
                logarithmic: false,
                ticks: vec![(0.0, "0".into()), (share, format!("{share} %"))],
            };
            let plot = Plot { left, top: 62.0 + step * k as f64, width, height, x, y };
            plot.frame(canvas)?;
            plot.title(canvas, name)?;
            for (i, count) in bins.iter().enumerate() {
                let edge = |i: usize| low * 10f64.powf(4.0 * i as f64 / BINS as f64);
                let from = plot.at(edge(i), 100.0 * f64::from(*count) / total);
                let to = plot.at(edge(i + 1), 0.0);
                block(canvas, (from.0 + 1.0, from.1), (to.0, to.1), *colour)?;
            }
            let Figures { mean, p95, max } = figures(errors);
            for (value, ink) in [(mean, INK), (p95, GREY)] {
                plot.curve(canvas, &[(value, 0.0), (value, share)], ink, 1.5)?;
            }
            let right = left + width + 16.0;
            let middle = plot.top + 0.5 * height;
            for (k, (what, value)) in
                [("mean", mean), ("95 %", p95), ("max", max)].iter().enumerate()
            {
                let text = format!("{what} {value:.4}");
                let at = (right, middle + 18.0 * (k as f64 - 1.0));
                write(canvas, &text, at, 13, Align::Left, if k == 1 { GREY } else { INK })?;
            }
        }
        let below = 62.0 + step * (rows.len() - 1) as f64 + height + 34.0;
        let text = "error |f − f_ref| / (μ N); first bar: all below 0.0001; black line: mean, \
                    grey: 95 %";
        write(canvas, text, (left + 0.5 * width, below), 13, Align::Centre, INK)
    })
}

/// A grid of cells coloured by an error.
struct Map<'a> {
    title: String,
    columns: &'a [String],
    rows: &'a [String],
    /// Row by row from the bottom; NaN where there is no case.
    values: Vec<f64>,
}

/// Maps side by side, three in a row, with a common colour scale.
fn maps(
    path: &Path, title: &str, (across, up): (&str, &str), per_row: usize, maps: &[Map],
) -> Drawn {
    let (cell_width, cell_height) = (44.0, 26.0);
    let columns = maps[0].columns.len() as f64;
    let rows = maps[0].rows.len() as f64;
    let (left, top) = (92.0, 74.0);
    let step_x = columns * cell_width + 92.0;
    let step_y = rows * cell_height + 74.0;
    let lines = maps.len().div_ceil(per_row);
    let width = left + step_x * per_row as f64 - 60.0;
    let height = top + step_y * lines as f64 + 40.0;
    picture(path, (width as u32, height as u32), |canvas| {
        write(canvas, title, (24.0, 22.0), 17, Align::Left, INK)?;
        for (k, map) in maps.iter().enumerate() {
            let x0 = left + step_x * (k % per_row) as f64;
            let y0 = top + step_y * (k / per_row) as f64;
            write(canvas, &map.title, (x0, y0 - 14.0), 14, Align::Left, INK)?;
            for (row, label) in map.rows.iter().enumerate() {
                let y = y0 + (rows - 1.0 - row as f64) * cell_height;
                write(canvas, label, (x0 - 6.0, y + 13.0), 12, Align::Right, INK)?;
                for column in 0..map.columns.len() {
                    let value = map.values[row * map.columns.len() + column];
                    let x = x0 + column as f64 * cell_width;
                    let corners = ((x, y), (x + cell_width - 1.0, y + cell_height - 1.0));
                    if value.is_nan() {
                        block(canvas, corners.0, corners.1, RGBColor(0xf3, 0xf3, 0xf3))?;
                        continue;
                    }
                    let (colour, ink) = heat(value);
                    block(canvas, corners.0, corners.1, colour)?;
                    let text = if value < 0.01 {
                        format!("{:.1}", 1e3 * value)
                    } else {
                        format!("{:.0}", 1e3 * value)
                    };
                    let centre = (x + 0.5 * cell_width, y + 0.5 * cell_height);
                    write(canvas, &text, centre, 12, Align::Centre, ink)?;
                }
            }
            let below = y0 + rows * cell_height;
            for (column, label) in map.columns.iter().enumerate() {
                let x = x0 + (column as f64 + 0.5) * cell_width;
                write(canvas, label, (x, below + 11.0), 11, Align::Centre, INK)?;
            }
            let middle = x0 + 0.5 * columns * cell_width;
            write(canvas, across, (middle, below + 31.0), 13, Align::Centre, INK)?;
            write(canvas, up, (x0 - 12.0, y0 - 14.0), 13, Align::Right, INK)?;
        }
        // the scale
        let y = height - 34.0;
        write(canvas, "thousandths of μ N:", (left, y + 9.0), 13, Align::Left, INK)?;
        for (k, value) in [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0].iter().enumerate()
        {
            let x = left + 140.0 + 46.0 * k as f64;
            let (colour, ink) = heat(value / 1e3);
            block(canvas, (x, y), (x + 45.0, y + 18.0), colour)?;
            write(canvas, &value.to_string(), (x + 22.0, y + 9.0), 12, Align::Centre, ink)?;
        }
        Ok(())
    })
}

/// The statistic of the errors in a cell of a map, NaN without cases.
fn cell(
    cases: &[Case], errors: &Errors, holds: impl Fn(&Case) -> bool, statistic: fn(Figures) -> f64,
) -> f64 {
    let inside = errors.only(cases, holds);
    if inside.force.is_empty() { f64::NAN } else { statistic(figures(&inside.force)) }
}

impl Report {
    fn histograms(&self, folder: &Path) -> Drawn {
        let colours = [GREEN, AMBER, SKY, VERMILION, BLUE];
        let names = ["STRIP_1967,", "FASTSIM", "FaStrip", "STRIP,", "TOTAL"];
        for (file, title, open) in [
            ("histogram_open.svg", "Error of the force, open.csv (854 cases)", true),
            ("histogram_validation.svg", "Error of the force, validation (1784 cases)", false),
        ] {
            let rows: Vec<(&str, &[f64], RGBColor)> = names
                .iter()
                .zip(colours)
                .filter_map(|(name, colour)| {
                    let method = self.method(name)?;
                    let errors = if open { &method.open } else { &method.validation };
                    Some((method.name.as_str(), errors.force.as_slice(), colour))
                })
                .collect();
            histogram(&folder.join(file), title, &rows)?;
        }
        Ok(())
    }

    fn shape_spin_map(&self, folder: &Path) -> Drawn {
        let ratios = [0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0];
        let columns = ratios.map(|ratio| ratio.to_string());
        let rows =
            ["0", "0–0.3", "0.3–0.6", "0.6–1", "1–1.5", "1.5–2.25", "> 2.25"].map(str::to_owned);
        let spins = ranges("", &PSI, |case| case.psi().abs());
        let drawn: Vec<Map> = ["STRIP_1967,", "FASTSIM", "FaStrip", "STRIP,", "TOTAL", "LINEAR"]
            .iter()
            .filter_map(|name| self.method(name))
            .map(|method| Map {
                title: method.name.replace(", parabolic", ""),
                columns: &columns,
                rows: &rows,
                values: spins
                    .iter()
                    .flat_map(|(_, spin)| {
                        ratios.map(|ratio| {
                            let holds = |case: &Case| case.axis_ratio == ratio && spin(case);
                            cell(&self.open, &method.open, holds, |f| f.mean)
                        })
                    })
                    .collect(),
            })
            .collect();
        let title = "Mean error of the force by shape and spin, open.csv, thousandths of μ N";
        maps(&folder.join("map_shape_spin.svg"), title, ("a/b", "|ψ|"), 3, &drawn)
    }

    fn creepage_spin_map(&self, folder: &Path) -> Drawn {
        let borders = [0.0, 0.1, 0.3, 0.6, 1.0, 2.0, 3.0, f64::INFINITY];
        let names =
            ["0", "0–0.1", "0.1–0.3", "0.3–0.6", "0.6–1", "1–2", "2–3", "> 3"].map(str::to_owned);
        let creepages = ranges("", &borders, Case::creep_force);
        let spins = ranges("", &borders, |case| case.linear_force()[2].abs());
        type Statistic = fn(Figures) -> f64;
        let kinds: [(&str, &str, Statistic); 4] = [
            ("STRIP,", "mean", |f| f.mean),
            ("TOTAL", "mean", |f| f.mean),
            ("STRIP,", "largest", |f| f.max),
            ("TOTAL", "largest", |f| f.max),
        ];
        let drawn: Vec<Map> = kinds
            .iter()
            .filter_map(|(name, what, statistic)| {
                let method = self.method(name)?;
                Some(Map {
                    title: format!("{}: {what}", method.name),
                    columns: &names,
                    rows: &names,
                    values: spins
                        .iter()
                        .flat_map(|(_, spin)| {
                            creepages.iter().map(move |(_, creepage)| {
                                let holds = |case: &Case| creepage(case) && spin(case);
                                cell(&self.validation, &method.validation, holds, *statistic)
                            })
                        })
                        .collect(),
                })
            })
            .collect();
        let title = format!("{FORCE_ERROR} by creepage and spin, validation, in thousandths");
        let axes = ("creepage |(C11 vx, C22 vy)|", "|C23 φ|");
        maps(&folder.join("map_creepage_spin.svg"), &title, axes, 2, &drawn)
    }
}

/// Tractions along one strip of four of the fields.
fn field_picture(path: &Path) -> Drawn {
    let names = [
        ("g1_nu028_xi03", "a/b = 1, ξ = 0.3"),
        ("g1_nu05_spin0305", "a/b = 1, ν = 0.5, ψ = 0.305"),
        ("g1_nu029_psi1_eta-05", "a/b = 1, η = −0.5, ψ = 1"),
        ("g2_nu028_xi01_eta-01_psi06", "a/b = 2, ξ = 0.1, η = −0.1, ψ = 0.6"),
    ];
    let cases = fields();
    let (width, height) = (270.0, 180.0);
    picture(path, (2 * 320 + 40, 1064), |canvas| {
        write(
            canvas,
            "Traction at y ≈ 0.4 b [μ p0]: along rolling, lateral below",
            (40.0, 22.0),
            17,
            Align::Left,
            INK,
        )?;
        for (k, (name, title)) in names.iter().enumerate() {
            let Some(case) = cases.iter().find(|case| case.name == *name) else {
                return Err("no such field".into());
            };
            let nearest = case
                .cells
                .iter()
                .map(|cell| cell.y)
                .min_by(|p, q| (p - 0.4).abs().total_cmp(&(q - 0.4).abs()))
                .unwrap_or(0.0);
            let end = (1.0 - nearest * nearest).sqrt();
            for component in 0..2 {
                let plot = Plot {
                    left: 52.0 + 320.0 * (k % 2) as f64,
                    top: 70.0 + 240.0 * component as f64 + 480.0 * (k / 2) as f64,
                    width,
                    height,
                    x: Axis::linear(-1.0, 1.0, &[-1.0, -0.5, 0.0, 0.5, 1.0]),
                    y: Axis::linear(-1.0, 1.0, &[-1.0, -0.5, 0.0, 0.5, 1.0]),
                };
                plot.frame(canvas)?;
                if component == 0 {
                    plot.title(canvas, title)?;
                }
                let place = |i: i32| end * (std::f64::consts::PI * f64::from(i) / 200.0).cos();
                for sign in [-1.0, 1.0] {
                    let bound: Vec<_> = (0..=200)
                        .map(|i| {
                            (place(i), sign * (end * end - place(i) * place(i)).max(0.0).sqrt())
                        })
                        .collect();
                    plot.curve(canvas, &bound, GREY, 1.0)?;
                }
                for (model, ink) in [(Model::Strip1967, GREEN), (Model::Strip, VERMILION)] {
                    let (contact, field) = case.solve::<f64>(model);
                    let unit = FRICTION * contact.peak_pressure();
                    let curve: Vec<_> = (0..=200)
                        .map(|i| {
                            let point = field.at(contact.a * place(i), contact.b * nearest);
                            let traction = [point.traction_x, point.traction_y][component];
                            (place(i), traction / unit)
                        })
                        .collect();
                    plot.curve(canvas, &curve, ink, 2.0)?;
                }
                for cell in case.cells.iter().filter(|cell| cell.y == nearest) {
                    let at = plot.at(cell.x, cell.traction[component]);
                    dot(canvas, at, 2.4, INK, cell.sticks)?;
                }
            }
        }
        let mut y = 1014.0;
        write(canvas, "x/a, rolling to the right", (40.0, y), 13, Align::Left, INK)?;
        let mut x = 260.0;
        for (ink, text) in [(VERMILION, "STRIP"), (GREEN, "STRIP_1967"), (GREY, "bound")] {
            line(canvas, &[(x, y), (x + 26.0, y)], ink, 2.0)?;
            write(canvas, text, (x + 32.0, y), 13, Align::Left, INK)?;
            x += 150.0;
        }
        (x, y) = (260.0, y + 26.0);
        for (filled, text) in [(true, "CONTACT, sticks"), (false, "CONTACT, slips")] {
            dot(canvas, (x + 10.0, y), 2.4, INK, filled)?;
            write(canvas, text, (x + 22.0, y), 13, Align::Left, INK)?;
            x += 150.0;
        }
        Ok(())
    })
}

fn coefficient_picture(path: &Path) -> Drawn {
    let cases = coefficient_cases();
    let ratios = [(0.0, BLUE), (0.25, GREEN), (0.28, VERMILION), (0.5, PURPLE)];
    picture(path, (880, 620), |canvas| {
        let title = "Linear coefficients against CONTACT";
        write(canvas, title, (50.0, 22.0), 17, Align::Left, INK)?;
        for (k, name) in ["C11", "C22", "C23", "C33"].iter().enumerate() {
            let (limit, ticks) = if k == 3 {
                (3.0, vec![-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0])
            } else {
                (0.5, vec![-0.5, -0.25, 0.0, 0.25, 0.5])
            };
            let plot = Plot {
                left: 58.0 + 430.0 * (k % 2) as f64,
                top: 66.0 + 270.0 * (k / 2) as f64,
                width: 350.0,
                height: 200.0,
                x: Axis::logarithmic(0.08, 12.5, &[0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0]),
                y: Axis::linear(-limit, limit, &ticks),
            };
            plot.frame(canvas)?;
            plot.title(canvas, &format!("{name}: deviation [%]"))?;
            write(canvas, "a/b", (plot.left + 175.0, plot.top + 226.0), 12, Align::Centre, INK)?;
            for (nu, ink) in ratios {
                let mut points: Vec<(f64, f64)> = cases
                    .iter()
                    .filter(|case| case.poisson_ratio == nu)
                    .map(|case| (case.axis_ratio, 100.0 * case.errors::<f64>()[k]))
                    .collect();
                points.sort_by(|p, q| p.0.total_cmp(&q.0));
                plot.curve(canvas, &points, ink, 1.0)?;
                for (x, y) in points {
                    dot(canvas, plot.at(x, y), 3.0, ink, true)?;
                }
            }
        }
        let (y, mut x) = (596.0, 58.0);
        for (nu, ink) in ratios {
            dot(canvas, (x, y), 3.0, ink, true)?;
            write(canvas, &format!("ν = {nu}"), (x + 10.0, y), 13, Align::Left, INK)?;
            x += 90.0;
        }
        write(
            canvas,
            "the frames of C11, C22 and C23 end at the required 0.5 %",
            (x + 20.0, y),
            13,
            Align::Left,
            INK,
        )
    })
}

fn main() -> Drawn {
    let docs = root().join("docs/evidence");
    let folder = docs.join("accuracy");
    std::fs::create_dir_all(&folder)?;
    let mut report = Report::compute();
    let parts: [Part; 13] = [
        ("introduction", Report::introduction),
        ("all methods", Report::all_methods),
        ("reference", Report::reference),
        ("what a simulation feels", Report::feel),
        ("by strip count", Report::by_strip_count),
        ("by region", Report::by_region),
        ("slender contacts", Report::slender),
        ("large creepage that spin turns around", Report::turning),
        ("dissimilar materials", Report::unlike),
        ("worst cases", Report::worst_cases),
        ("fields", Report::fields),
        ("coefficients", Report::coefficients),
        ("variants", Report::variants),
    ];
    let bar = progress::bar(parts.len() as u64 + 2);
    for (name, part) in parts {
        bar.set_message(name);
        part(&mut report);
        bar.inc(1);
    }
    bar.inc(1);
    bar.set_message("pictures");
    std::fs::write(docs.join("accuracy.md"), &report.text)?;
    report.sweep(&folder.join("sweep.svg"))?;
    report.histograms(&folder)?;
    report.shape_spin_map(&folder)?;
    report.creepage_spin_map(&folder)?;
    field_picture(&folder.join("fields.svg"))?;
    coefficient_picture(&folder.join("coefficients.svg"))?;
    bar.finish_and_clear();
    println!("wrote docs/evidence/accuracy.md and docs/evidence/accuracy/*.svg");
    Ok(())
}
