//! What a call costs, and what it is worth: `cargo run --release --example speed` writes
//! `docs/speed-vs-error.md` and `docs/speed-vs-error.svg`.
//!
//! Every model through the C interface and every method of `benches/peers`: nanoseconds (median of
//! rounds that take turns), instructions (callgrind, if there is valgrind) and errors on `open.csv`, all in one run.
//!
//! `cargo run --release --example speed -- short` prints the ratios to FASTSIM 10x10 and writes nothing: for builds of another kind, as
//! `RUSTFLAGS="-C target-cpu=x86-64-v3" cargo run --release --example speed -- short`.

#[path = "speed/calls.rs"]
mod calls;
#[path = "common/clock.rs"]
mod clock;
#[path = "speed/counts.rs"]
mod counts;
#[path = "speed/growth.rs"]
mod growth;
#[path = "speed/limit.rs"]
mod limit;
#[path = "common/lines.rs"]
mod lines;
#[path = "../tests/common/names.rs"]
mod names;
#[path = "common/peer_methods.rs"]
mod peer_methods;
#[path = "../benches/peers/mod.rs"]
mod peers;
#[path = "accuracy/pictures.rs"]
#[allow(dead_code)]
mod pictures;
#[path = "speed/plot.rs"]
mod plot;
#[path = "common/progress.rs"]
mod progress;
#[path = "../tests/common/reference.rs"]
mod reference;
#[path = "speed/together.rs"]
mod together;

use calls::{Family, Row, has_strips};
use kstrip::solve::model::Model;
use lines::Lines;
use pictures::*;
use plot::Mark;
use plotters::style::RGBColor;
use reference::{name, open, project};
use std::hint::black_box;
use std::process::Command;

/// Rounds over all rows, of which the median counts.
const ROUNDS: u64 = 61;

/// Times measured with CONTACT's own code (open-source release of July 2025), not in this run: nanoseconds, and
/// the errors that its results have on `open.csv`.
const ELSEWHERE: [(&str, f64, f64); 5] = [
    ("CONTACT's FASTSIM 10x10", 27e3, 0.029),
    ("CONTACT's FASTSIM 20x20", 48e3, 0.023),
    ("CONTACT's FASTSIM 50x50", 200e3, 0.025),
    ("CONTACT's FaStrip 20x20", 52e3, 0.031),
    ("CONTACT's FaStrip 50x50", 240e3, 0.027),
];
/// CONTACT at 100x50 cells; its error is the reference's own estimate.
const REFERENCE: (&str, f64, f64) = ("CONTACT 100x50", 5e8, 6e-4);

/// What was tried and what came of it: measured when it was tried, not in this run.
const TRIED: &str = include_str!("speed/tried.md");

struct Report {
    rows: Vec<Row>,
    text: String,
}

/// The first line of what a command says.
fn said(program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned());
    text.ok().and_then(|text| text.lines().next().map(str::to_owned)).unwrap_or("?".to_owned())
}

/// Processor, cores and load.
fn machine() -> String {
    let read = |path: &str| std::fs::read_to_string(path).unwrap_or_default();
    let processor = read("/proc/cpuinfo");
    let processor = processor
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(": "))
        .map_or("unknown processor", |(_, name)| name);
    let load = read("/proc/loadavg");
    let load = load.split(' ').next().filter(|load| !load.is_empty()).unwrap_or("unknown");
    let cores = std::thread::available_parallelism().map_or(0, usize::from);
    format!(
        "{processor}, {cores} cores, {}; {}, target {} {}, release with LTO. Load average at the start: {load}",
        std::env::consts::OS,
        said("rustc", &["--version"]),
        std::env::consts::ARCH,
        if cfg!(target_feature = "avx") {
            "compiled for processors with AVX"
        } else {
            "as it comes (SSE2 on x86-64)"
        },
    )
}

/// `20x20` of the name of a method.
fn grid(name: &str) -> String {
    let sized = |word: &&str| word.contains('x') && word.starts_with(|c: char| c.is_ascii_digit());
    let words = name.split([' ', ',']).find(sized);
    words.unwrap_or("").to_owned()
}

/// Two or three digits that count.
fn digits(value: f64) -> String {
    if !value.is_finite() {
        "–".to_owned()
    } else if value >= 100.0 {
        format!("{value:.0}")
    } else if value >= 10.0 {
        format!("{value:.1}")
    } else if value >= 0.1 {
        format!("{value:.2}")
    } else {
        format!("{value:.3}")
    }
}

impl Lines for Report {
    fn text(&mut self) -> &mut String {
        &mut self.text
    }
}

impl Report {
    fn first(&self, family: Family) -> &Row {
        self.rows.iter().find(|row| row.family == family).expect("a row of every family")
    }

    fn found(&self, family: Family, strips: Option<i32>) -> &Row {
        let mut rows = self.rows.iter().filter(|row| row.family == family);
        rows.find(|row| row.strips == strips).expect("a row of every setting")
    }

    /// Nanoseconds of FASTSIM 10x10: the classical loop, and ten strips side by side.
    fn fastsim(&self) -> [f64; 2] {
        [Family::FastsimScalar, Family::FastsimLanes].map(|family| self.first(family).time())
    }

    /// Every model over FASTSIM 10x10, in one sentence.
    fn in_short(&mut self) {
        let [scalar, _] = self.fastsim();
        let per_call: Vec<String> = [
            (Model::Total, None),
            (Model::Strip, Some(16)),
            (Model::Strip1967, Some(16)),
            (Model::Linear, None),
        ]
        .into_iter()
        .map(|(model, strips)| {
            let ratio = |family| self.found(family, strips).time() / scalar;
            let [one, forces] = [Family::Double(model), Family::Forces(model)].map(ratio);
            let [batch, arrays] = [Family::Batch(model), Family::BatchSingle(model)].map(ratio);
            let of = strips.map_or(String::new(), |strips| format!(" ({strips} strips)"));
            format!(
                "{}{of} {} ({} forces alone through `kstrip_evaluate`; in a batch {}, in single precision {})",
                name(model),
                digits(one),
                digits(forces),
                digits(batch),
                digits(arrays)
            )
        })
        .collect();
        self.line(format!(
            "Time of a contact over that of FASTSIM 10x10 (classical loop, {} ns) in the same run: {}.\n",
            digits(scalar),
            per_call.join("; ")
        ));
    }

    fn introduction(&mut self, counted: &Result<String, String>, load: &str) {
        self.line("# Speed against error\n");
        self.line("Written by one command, one run: `cargo run --release --example speed`; do not edit.\n");
        self.in_short();
        self.line("![Error over cost](speed-vs-error.svg)\n");
        self.line(format!("* Machine: {load}."));
        self.line(format!(
            "* Times: one contact (a = 6 mm, b = 4 mm, 80 kN, steel, μ = 0.3), {} creepages from partial slip to sliding; the \
             median of {ROUNDS} rounds in which all rows take turns, and the quickest round, in processor time of \
             the thread: other programs do not count, though caches and clock rate are shared with them. Models are called through \
             the C interface by a pointer that the compiler cannot see through; they check their input and compute \
             the linear coefficients in every call. The other methods are called the same way but check \
             nothing, and are handed their coefficients and grids ready-made.",
            calls::CALLS
        ));
        self.line(match counted {
            Ok(version) => format!(
                "* Instructions: callgrind ({version}) on this very program, mean per call, the loop over the calls \
                 included (about ten)."
            ),
            Err(why) => format!("* SKIPPED: instructions, {why}."),
        });
        self.line(
            "* Errors: `|f − f_ref|` of the force in units of `μ N` over the 854 cases of `tests/data/open.csv`, as in \
             [accuracy.md](accuracy.md); the other methods get CONTACT's own linear coefficients there.",
        );
        self.line(
            "* Ratios: median over the median of **FASTSIM 10x10** (3 flexibilities, parabolic bound, cell centres; \
             `benches/peers/fastsim.rs`), first over the classical loop (*scalar*), then over ten strips side by side \
             (*ten lanes*), a faster way to write it than the ones in use.",
        );
    }

    fn against_fastsim(&mut self) {
        use Model::{Linear, Strip, Strip1967, Total};
        self.line("\n## Against FASTSIM 10x10\n");
        let [scalar, lanes] = self.fastsim();
        self.line(format!(
            "FASTSIM 10x10 takes {} ns as the classical loop and {} ns with ten lanes. Double precision, forces alone.\n",
            digits(scalar),
            digits(lanes)
        ));
        self.header(&[
            "model",
            "ns",
            "of the scalar loop",
            "of ten lanes",
            "aim",
            "scalar loop over the aim",
        ]);
        let aims = [
            (Strip1967, Some(16), 0.05),
            (Strip1967, Some(8), 0.03),
            (Total, None, 0.08),
            (Strip, Some(16), 0.7),
            (Linear, None, 0.02),
        ];
        for (model, strips, aim) in aims {
            let time = self.found(Family::Double(model), strips).time();
            let of = strips.map_or(String::new(), |strips| format!(", {strips} strips"));
            self.row([
                format!("{}{of}", name(model)),
                digits(time),
                digits(time / scalar),
                digits(time / lanes),
                digits(aim),
                digits(time / scalar / aim),
            ]);
        }
        self.line("\nForces with their derivatives, over the forces alone (aim: 2.5):\n");
        self.header(&[
            "model",
            "precision",
            "ns",
            "instructions",
            "over forces: ns",
            "instructions",
        ]);
        for model in Model::ALL {
            let strips = has_strips(model).then_some(16);
            let pairs = [
                ("f64", Family::Jacobian(model), Family::Double(model)),
                ("f32", Family::JacobianSingle(model), Family::Single(model)),
            ];
            for (precision, slopes, forces) in pairs {
                let (slopes, forces) = (self.found(slopes, strips), self.found(forces, strips));
                let instructions = slopes.instructions.unwrap_or(f64::NAN);
                let cells = [
                    name(model).to_owned(),
                    precision.to_owned(),
                    digits(slopes.time()),
                    digits(instructions),
                    digits(slopes.time() / forces.time()),
                    digits(instructions / forces.instructions.unwrap_or(f64::NAN)),
                ];
                self.row(cells);
            }
        }
    }

    fn everything(&mut self) {
        self.line("\n## Every model, every setting, every other method\n");
        self.header(&[
            "method",
            "precision",
            "strips",
            "ns, median",
            "least",
            "instructions",
            "of FASTSIM 10x10 scalar",
            "of ten lanes",
            "error, mean",
            "95 %",
            "max",
        ]);
        let [scalar, lanes] = self.fastsim();
        let rows: Vec<[String; 11]> = self
            .rows
            .iter()
            .filter(|row| !matches!(row.family, Family::Jacobian(_) | Family::JacobianSingle(_)))
            .map(|row| {
                let time = row.time();
                let precision = match row.family {
                    Family::Single(_)
                    | Family::ForcesSingle(_)
                    | Family::BatchSingle(_)
                    | Family::ArraysSingle(_) => "f32",
                    _ => "f64",
                };
                [
                    row.name.clone(),
                    precision.to_owned(),
                    row.strips.map_or("–".to_owned(), |strips| strips.to_string()),
                    digits(time),
                    digits(row.least()),
                    row.instructions.map_or("–".to_owned(), digits),
                    digits(time / scalar),
                    digits(time / lanes),
                    format!("{:.4}", row.errors.mean),
                    format!("{:.4}", row.errors.p95),
                    format!("{:.4}", row.errors.max),
                ]
            })
            .collect();
        for row in rows {
            self.row(row);
        }
        self.line("\nMeasured with CONTACT's own code, earlier and not in this run:\n");
        self.header(&["method", "time", "error, mean"]);
        for (name, time, error) in ELSEWHERE {
            self.row([name.to_owned(), format!("{:.0} µs", time * 1e-3), error.to_string()]);
        }
        let (name, time, error) = REFERENCE;
        let error = format!("the reference; estimated {error}");
        self.row([name.to_owned(), format!("{} s", time * 1e-9), error]);
    }

    fn limit(&mut self) {
        self.line("\n## The limit\n");
        let single = limit::single();
        let double = limit::double(&single);
        self.line(
            "What a solve cannot avoid with these formulas: its square roots, quotients, inverse roots (`1/√x`) and \
             multiply-adds (half the number of multiplications and additions), counted by hand from the sources (`examples/speed/limit.rs` says what is counted where), \
             times what each costs on this machine when nothing waits for anything. Roots and quotients share one \
             unit that works beside those that multiply and add, so the limit is the longer of the two sums. It leaves out loads, \
             stores, branches, the waiting of one result for another, and the moving of numbers into pairs.\n",
        );
        self.header(&["ns per number", "√", "quotient", "1/√x", "multiply-add"]);
        for (precision, t) in [("f64", &double), ("f32", &single)] {
            let cells = [t.root, t.quotient, t.inverse_root, t.multiply_add];
            self.row(
                [vec![precision.to_owned()], cells.map(|x| format!("{x:.3}")).to_vec()].concat(),
            );
        }
        self.line("\nDouble precision takes `1/√x` from single precision and improves it by one of Newton's steps (two multiply-adds).\n");
        self.header(&[
            "model",
            "strips",
            "√",
            "quotients",
            "1/√x",
            "multiply-adds",
            "bound by",
            "limit, f64 \\[ns\\]",
            "reached (least)",
            "ratio",
            "limit, f32",
            "reached (least)",
            "ratio",
        ]);
        let mut worst = (0.0_f64, String::new());
        for model in Model::ALL {
            for strips in [8, 16, 64] {
                if !has_strips(model) && strips != 16 {
                    continue;
                }
                let of = has_strips(model).then_some(strips);
                let work = limit::work(model, strips);
                // the inverse roots' step of Newton's
                let newton = limit::Work {
                    multiply_adds: work.multiply_adds + 2.0 * work.inverse_roots,
                    ..work
                };
                let limits = [double.limit(&newton), single.limit(&work)];
                let reached = [Family::Double(model), Family::Single(model)]
                    .map(|family| self.found(family, of).least());
                let ratios = [reached[0] / limits[0], reached[1] / limits[1]];
                if ratios[0] > worst.0 {
                    worst = (ratios[0], name(model).to_owned());
                }
                let counts = [work.roots, work.quotients, work.inverse_roots, work.multiply_adds];
                let mut cells = vec![
                    name(model).to_owned(),
                    of.map_or("–".to_owned(), |strips| strips.to_string()),
                ];
                cells.extend(counts.map(|count| format!("{count:.0}")));
                let [divider, sums] = double.sides(&newton);
                cells.push(
                    if divider > sums { "√ and quotients" } else { "multiply-adds" }.to_owned(),
                );
                for k in 0..2 {
                    cells.extend([limits[k], reached[k], ratios[k]].map(digits));
                }
                self.row(cells);
            }
        }
        self.line(format!(
            "\nThe aim is a ratio of 2. The largest in double precision is {} ({}). The theory of 1967 waits: each tangent \
             step towards the ends of its adhesion interval needs the one before, a root and a quotient after a \
             root, and the panels need the ends.",
            digits(worst.0),
            worst.1
        ));
        let slower: Vec<String> = Model::ALL
            .into_iter()
            .filter_map(|model| {
                let strips = has_strips(model).then_some(16);
                let [double, single] = [Family::Double(model), Family::Single(model)]
                    .map(|family| self.found(family, strips).time());
                (single > 1.02 * double)
                    .then(|| format!("{} ({})", name(model), digits(single / double)))
            })
            .collect();
        if !slower.is_empty() {
            self.line(format!(
                "\nFour floats fit where two doubles do, but single precision is not quicker: over double precision it \
                 takes {}. It has been written for processors that have no double precision at all.",
                slower.join(", ")
            ));
        }
    }

    fn growth(&mut self) {
        self.line("\n## How cost grows\n");
        self.header(&["what", "", "", "", "", "", "", ""]);
        let strips = [4, 8, 16, 32, 64];
        let pad = |mut cells: Vec<String>| {
            cells.resize(8, String::new());
            cells
        };
        self.row(pad(["strips".to_owned()]
            .into_iter()
            .chain(strips.map(|n| format!("**{n}**")))
            .collect()));
        let mut slopes = Vec::new();
        for model in [Model::Strip1967, Model::Strip1967Continuous, Model::Strip] {
            let times = strips.map(|n| self.found(Family::Double(model), Some(n)).time());
            slopes.push((name(model), (times[4] - times[2]) / 48.0));
            let mut cells = vec![format!("{}, ns", name(model))];
            cells.extend(times.map(digits));
            self.row(pad(cells));
        }
        self.row(pad(["contacts in a batch".to_owned()]
            .into_iter()
            .chain(growth::CONTACTS.map(|n| format!("**{n}**")))
            .collect()));
        for model in [Model::Strip, Model::Total, Model::Strip1967] {
            let times = growth::batch(model);
            let strips = if has_strips(model) { ", 16 strips" } else { "" };
            let mut cells = vec![format!("{}{strips}, ns per contact", name(model))];
            cells.extend(times.iter().copied().map(digits));
            self.row(pad(cells));
        }
        self.row(pad(["points of a field".to_owned()]
            .into_iter()
            .chain(growth::SIDES.map(|n| format!("**{n}x{n}**")))
            .collect()));
        for model in [Model::Strip, Model::Strip1967] {
            let mut cells = vec![format!("{}, ns per point", name(model))];
            cells.extend(growth::field(model).into_iter().map(digits));
            self.row(pad(cells));
        }
        let slopes: Vec<String> =
            slopes.iter().map(|(name, slope)| format!("{name} {} ns", digits(*slope))).collect();
        self.line(format!(
            "\n* Strips: linear, a fixed part for the contact and then so much per strip (between 16 and 64): {}.",
            slopes.join(", ")
        ));
        self.line(
            "* Contacts: linear: nothing is kept from one to the next. A batch of few contacts goes one by one; a larger one asks \
             the processor once (next section).",
        );
        self.line(
            "* Field: linear in the points inside the ellipse; the contact is solved once, a point costs the march along its strip \
             (STRIP) or the closed form of its strip (1967), and points outside cost nothing.",
        );
    }

    fn batches(&mut self) {
        self.line("\n## Many contacts at once\n");
        let question = together::question();
        self.line(format!(
            "`kstrip_solve_batch` (structures) and `kstrip_solve_batch_arrays` (one array for each quantity) against a loop over \
             `kstrip_solve` over the same contacts, in turns, nanoseconds per contact, 16 strips where there are strips; the results \
             are the same bits. On x86-64 processors with AVX, four contacts in double precision or eight in single precision stand side \
             by side in one register. The library is compiled for every x86-64 processor and asks once per batch (`cpuid`), which \
             took {} ns here, under a hypervisor that intercepts it (without one it is an instruction like others): that is what the first \
             column has more. Nothing is remembered between calls; compiled with `-C target-feature=+avx` nothing is asked.",
            digits(question)
        ));
        let mut header = vec!["model".to_owned(), "precision".to_owned(), "how".to_owned()];
        header.extend(together::CONTACTS.map(|count| format!("{count} contacts")));
        self.line("");
        self.header(&header.iter().map(String::as_str).collect::<Vec<_>>());
        let mut least: Vec<String> = Vec::new();
        for model in Model::ALL {
            let measured = [
                ("f64", together::in_double::by_count(model)),
                ("f32", together::in_single::by_count(model)),
            ];
            for (precision, times) in measured {
                for (k, how) in ["one by one", "structures", "arrays"].into_iter().enumerate() {
                    let mut cells =
                        vec![name(model).to_owned(), precision.to_owned(), how.to_owned()];
                    cells.extend(times.iter().map(|times| match k {
                        0 => digits(times[0]),
                        _ => format!("{} ({}x)", digits(times[k]), digits(times[0] / times[k])),
                    }));
                    self.row(cells);
                }
                let gain = |times: &[f64; 3]| times[0] / times[1].max(times[2]);
                let worst = times.iter().map(gain).fold(f64::INFINITY, f64::min);
                let later = times[1..].iter().map(gain).fold(f64::INFINITY, f64::min);
                least.push(format!(
                    "{} {precision} {}, {} from 1000 contacts on",
                    name(model),
                    digits(worst),
                    digits(later)
                ));
            }
        }
        self.line(format!(
            "\nThe aim is 2. The least gain of either layout: {}. In the theory of 1967 contacts that reach unit spin go one by \
             one, wherever they stand; these have less.",
            least.join("; ")
        ));
    }

    fn mark(&self, row: &Row) -> Option<Mark> {
        let (ink, filled) = match row.family {
            Family::Jacobian(_) | Family::JacobianSingle(_) => return None,
            Family::Double(model) => (Self::ink(model), true),
            Family::Forces(_)
            | Family::ForcesSingle(_)
            | Family::Arrays(_)
            | Family::ArraysSingle(_) => return None,
            Family::Batch(model) => (Self::ink(model), true),
            Family::Single(model) | Family::BatchSingle(model) => (Self::ink(model), false),
            Family::Fastrip | Family::FastripBlended => (PURPLE, true),
            Family::ClosedForm => (RGBColor(0x66, 0x66, 0x66), true),
            _ => (ORANGE, true),
        };
        let label = match (row.family, row.strips) {
            (Family::Double(_), Some(16)) => format!("{} 16", row.name),
            (Family::Double(Model::Strip), Some(strips)) => strips.to_string(),
            (Family::Double(Model::Strip1967), Some(strips @ (4 | 64))) => strips.to_string(),
            (Family::Double(_), Some(_)) => String::new(),
            (Family::Double(_), None) => row.name.clone(),
            (Family::Batch(_), Some(16)) => format!("{} 16", row.name.replace(", ", " ")),
            (Family::Batch(_), _) => row.name.replace(", ", " "),
            (Family::Single(_) | Family::BatchSingle(_), _) => String::new(),
            (Family::ClosedForm, _) => row.name.clone(),
            // the name at the first of a line, the grid alone at the others
            _ if self.first(row.family).name != row.name => grid(&row.name),
            _ => row
                .name
                .replace(", 3 flexibilities, parabolic", "")
                .replace(", 3 flexibilities", "")
                .replace(", 1 flexibility (1982), parabolic", ", 1 flexibility")
                .replace(", blended as in CONTACT, parabolic", ", blended")
                .replace(", flexibility (energy)", "")
                .replace(" as in CONTACT", ", blended"),
        };
        Some(Mark { time: row.time(), error: row.errors.mean, label, ink, filled })
    }

    fn ink(model: Model) -> RGBColor {
        match model {
            Model::Strip => BLUE,
            Model::Total => RGBColor(0xb8, 0x1f, 0x3a),
            Model::Linear => INK,
            Model::Strip1967Continuous => RGBColor(0x6f, 0x8f, 0x1a),
            _ => GREEN,
        }
    }

    fn picture(&self) -> Drawn {
        let measured: Vec<Mark> = self.rows.iter().filter_map(|row| self.mark(row)).collect();
        let mut lines = Vec::new();
        let mut join = |family: Family, ink: RGBColor| {
            let of = self.rows.iter().filter(|row| row.family == family);
            lines.push((ink, of.map(|row| (row.time(), row.errors.mean)).collect::<Vec<_>>()));
        };
        for model in Model::ALL {
            join(Family::Double(model), Self::ink(model));
            join(Family::Single(model), Self::ink(model));
        }
        for family in [
            Family::FastsimScalar,
            Family::FastsimLanes,
            Family::FastsimElliptic,
            Family::FastsimBlended,
        ] {
            join(family, ORANGE);
        }
        join(Family::Fastrip, PURPLE);
        join(Family::FastripBlended, PURPLE);
        for name in ["CONTACT's FASTSIM", "CONTACT's FaStrip"] {
            let of = ELSEWHERE.iter().filter(|(label, ..)| label.starts_with(name));
            let ink = if name.contains("FaStrip") { PURPLE } else { ORANGE };
            lines.push((ink, of.map(|(_, time, error)| (*time, *error)).collect()));
        }
        let other = |(label, time, error): (&str, f64, f64), filled| Mark {
            time,
            error,
            label: label.to_owned(),
            ink: INK,
            filled,
        };
        let mut elsewhere = ELSEWHERE.map(|mark| other(mark, false));
        for (k, mark) in elsewhere.iter_mut().enumerate() {
            mark.ink = if mark.label.contains("FaStrip") { PURPLE } else { ORANGE };
            if !matches!(k, 0 | 3) {
                mark.label = grid(&mark.label);
            }
        }
        let path = project().join("docs/speed-vs-error.svg");
        plot::draw(&path, &measured, &lines, &elsewhere, &other(REFERENCE, true))
    }
}

fn call(row: &Row) {
    black_box((row.calls)());
}

fn main() -> Drawn {
    if std::env::args().nth(1).as_deref() == Some(counts::ARGUMENT) {
        // under callgrind: the calls, once each
        for row in calls::rows(&open()[..1]) {
            black_box(counts::counted_calls(&row.calls));
        }
        return Ok(());
    }
    let short = std::env::args().nth(1).as_deref() == Some("short");
    let machine = machine();
    let mut report = Report { rows: calls::rows(&open()), text: String::new() };
    let bar = progress::bar(ROUNDS + 5);
    let mut counted = Err("in short".to_owned());
    if short {
        report.rows.retain(Row::is_short);
    } else {
        bar.set_message("instructions");
        counted = counts::count(&mut report.rows);
    }
    bar.inc(1);
    bar.set_message("rounds");
    // calls that are too short for the clock are repeated
    let repetitions: Vec<usize> =
        report.rows.iter().map(|row| (50e3 / clock::took(|| call(row))).ceil() as usize).collect();
    for _ in 0..ROUNDS {
        for (row, times) in report.rows.iter_mut().zip(&repetitions) {
            let run = || (0..*times).for_each(|_| call(row));
            let time = clock::took(run) / (times * calls::CALLS) as f64;
            row.times.push(time);
        }
        bar.inc(1);
    }
    if short {
        report.line(format!("Machine: {machine}.\n"));
        report.in_short();
        report.against_fastsim();
        bar.finish_and_clear();
        print!("{}", report.text);
        return Ok(());
    }
    report.introduction(&counted, &machine);
    report.against_fastsim();
    report.everything();
    bar.set_message("limit");
    report.limit();
    bar.inc(1);
    bar.set_message("growth");
    report.growth();
    bar.inc(1);
    bar.set_message("batches");
    report.batches();
    report.line(TRIED);
    bar.inc(1);
    bar.set_message("picture");
    std::fs::write(project().join("docs/speed-vs-error.md"), &report.text)?;
    report.picture()?;
    bar.finish_and_clear();
    println!("wrote docs/speed-vs-error.md and docs/speed-vs-error.svg");
    Ok(())
}
