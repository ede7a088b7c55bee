//! What a call costs, and what it is worth: `cargo bench --bench speed` writes
//! `docs/evidence/speed-vs-error.md` and `docs/evidence/speed-vs-error.svg`.
//!
//! Every model through the C interface and every method of `benches/peers`: nanoseconds (median of
//! rounds that take turns) and errors against CONTACT, all in one run.
//!
//! `cargo bench --bench speed -- print` writes nothing and prints the page: for builds of another
//! kind, as `RUSTFLAGS="-C target-cpu=x86-64-v3" cargo bench --bench speed -- print`.
//! `cargo bench --bench speed -- picture` draws the picture from the page, without measuring.

#[path = "speed/calls.rs"]
mod calls;
#[path = "common/clock.rs"]
mod clock;
#[path = "common/lines.rs"]
mod lines;
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

use calls::{AVX2, BATCHES, CALLS, How, LANES, Row, SCALAR, SETS, Set, Wrong};
use kstrip_testing::reference;
use kstrip_testing::toolchain::root;
use lines::Lines;
use pictures::*;
use plot::Mark;
use std::process::Command;

/// Rounds over all rows, of which the median counts.
const ROUNDS: u64 = 151;

/// Times measured with CONTACT's own code (open-source release of July 2025), not in this run, and
/// the errors of the force that its results have on `open.csv`.
const ELSEWHERE: [(&str, &str, f64); 6] = [
    ("CONTACT's FASTSIM 10x10", "27 µs", 0.029),
    ("CONTACT's FASTSIM 20x20", "48 µs", 0.023),
    ("CONTACT's FASTSIM 50x50", "200 µs", 0.025),
    ("CONTACT's FaStrip 20x20", "52 µs", 0.031),
    ("CONTACT's FaStrip 50x50", "240 µs", 0.027),
    ("CONTACT 100x50, the reference (its error estimated)", "0.5 s", 0.0006),
];

/// Ratios to FASTSIM 10x10, scalar, random contacts with spin, on other processors at two commits
/// whose models are the same. STRIP_1967, TOTAL, STRIP.
const ELSEWHERE_TIMES: [(&str, [f64; 3]); 2] = [
    ("commit 5a9305f, Intel Xeon, family 6, model 207", [0.303, 0.342, 0.677]),
    ("commit 97d2727, Intel Xeon, family 6, model 167", [0.308, 0.355, 0.668]),
];

/// The same ratios of other methods, on an Intel Xeon, family 6, model 167.
const UNCHANGED: [(&str, f64); 6] = [
    (LANES, 190.0 / 656.0),
    (AVX2, 205.0 / 656.0),
    ("FASTSIM 20x20, scalar", 3135.0 / 656.0),
    ("FASTSIM 20x20, ten lanes", 683.0 / 656.0),
    ("FaStrip 20x20, flexibility (energy)", 1332.0 / 656.0),
    ("Polach", 30.9 / 656.0),
];

/// Methods whose largest error here is above the published one on the same cases
/// (`tests/peers.rs`).
const PUBLISHED: [(&str, f64); 3] = [
    ("FaStrip 20x20, flexibility (1982)", 0.18),
    ("FaStrip 80x50, flexibility (1982)", 0.16),
    ("FaStrip 20x20 as in CONTACT", 0.12),
];

const PAGE: &str = "docs/evidence/speed-vs-error.md";
/// Headings of the tables that the picture plots.
const EVERY: &str = "## Every model and every other method";
const BATCHED: &str = "## Many contacts at once";

struct Report {
    rows: Vec<Row>,
    text: String,
}

/// Processor, cores, compiler and load.
fn machine() -> String {
    let read = |path: &str| std::fs::read_to_string(path).unwrap_or_default();
    let processor = read("/proc/cpuinfo");
    let of = |key: &str| {
        let found = processor.lines().find_map(|line| {
            let (name, value) = line.split_once(':')?;
            (name.trim() == key).then_some(value.trim())
        });
        found.unwrap_or("unknown").to_owned()
    };
    let cores = processor.lines().filter(|line| line.starts_with("processor")).count();
    let processor =
        format!("{} (family {}, model {})", of("model name"), of("cpu family"), of("model"));
    let load = read("/proc/loadavg");
    let load = load.split(' ').next().filter(|load| !load.is_empty()).unwrap_or("unknown");
    let says = |program: &str, arguments: &[&str]| {
        let output = Command::new(program).args(arguments).current_dir(root()).output();
        output.map_or("?".to_owned(), |output| {
            String::from_utf8_lossy(&output.stdout).trim().to_owned()
        })
    };
    let version = says("rustc", &["--version"]);
    let commit = says("git", &["log", "-1", "--format=%h", "--", "src"]);
    let target = if cfg!(target_feature = "avx2") {
        "compiled for AVX2"
    } else {
        "as it comes (SSE2 on x86-64)"
    };
    let (system, kind) = (std::env::consts::OS, std::env::consts::ARCH);
    format!(
        "{processor}, {cores} cores, {system}; {version}, target {kind} {target}, release with \
         LTO; sources of the library at {commit}. Load average at the start: {load}"
    )
}

/// Two or three digits that count.
fn digits(value: f64) -> String {
    match value {
        x if !x.is_finite() => "–".to_owned(),
        x if x >= 100.0 => format!("{x:.0}"),
        x if x >= 10.0 => format!("{x:.1}"),
        x if x >= 0.1 => format!("{x:.2}"),
        x => format!("{x:.3}"),
    }
}

fn title(set: Set) -> &'static str {
    match set {
        Set::One => "one contact",
        Set::Spin => "random, spin",
        Set::NoSpin => "random, no spin",
        Set::Mixed => "mixed",
    }
}

fn manner(how: How) -> String {
    match how {
        How::Solve => "`kstrip_solve`".to_owned(),
        How::Forces => "`kstrip_evaluate`, forces alone".to_owned(),
        How::Derivatives => "`kstrip_evaluate`, with derivatives".to_owned(),
        How::Prepared => "prepared".to_owned(),
        How::Batch(count) => format!("batch of {count}"),
    }
}

impl Lines for Report {
    fn text(&mut self) -> &mut String {
        &mut self.text
    }
}

impl Report {
    /// Nanoseconds of a contact.
    fn time(&self, name: &str, precision: &str, how: How, set: Set) -> f64 {
        let of = |row: &&Row| {
            row.name == name && row.precision == precision && row.how == how && row.set == set
        };
        self.rows.iter().find(of).map_or(f64::NAN, Row::time)
    }

    /// Nanoseconds of a setting of FASTSIM.
    fn peer(&self, name: &str, set: Set) -> f64 {
        self.time(name, "f64", How::Solve, set)
    }

    /// Names of the models with their strips.
    fn models(&self) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for row in self.rows.iter().filter(|row| row.how == How::Forces) {
            if !names.contains(&row.name) {
                names.push(row.name.clone());
            }
        }
        names
    }

    fn introduction(&mut self, machine: &str) {
        self.line("# Speed against error\n");
        self.line("Written by `cargo bench --bench speed` in one run; do not edit.\n");
        self.line("![Error against cost](speed-vs-error.svg)\n");
        self.line(
            "The picture plots the error against the time of one contact, for all models and \
             methods except FASTSIM in ten SIMD lanes. The best methods are at the lower left. \
             Times depend on the processor, and so do ratios of times. In the first table the \
             ratios differ by up to two fifths between processors. [Counts of \
             instructions](instructions.md) do not depend on the processor.\n",
        );
        self.processors(machine);
        self.line("\n## How it was measured\n");
        self.line(format!("* Machine: {machine}."));
        self.line(format!(
            "* Times are processor time of the thread in nanoseconds per contact. Each is \
             the median of {ROUNDS} rounds in which all rows take turns. Other programs are \
             not counted, but they share caches and clock rate. Ratios of two runs usually \
             differ by less than 3 %, in batches by up to 6 %. Models are called through the \
             C interface, by a pointer that the compiler cannot resolve. They check their \
             input and, unless prepared, compute the linear coefficients in every call. The \
             other methods are called in the same way. But they check nothing, and they are \
             given their coefficients and grids."
        ));
        self.line(format!(
            "* Each kind has {CALLS} inputs. *One contact* has a = 6 mm, b = 4 mm, 80 kN, \
             steel, μ = 0.3, and creepages from partial slip to sliding. *Random* contacts have \
             a/b 0.1 to 10 and ν 0 to 0.5. Linear forces are 0 to 3 μ N in any direction, |ψ| up \
             to 0.95 or none. *Mixed* contacts alternate: with spin, without spin, longitudinal, \
             lateral with spin, spin alone, and |ψ| from 1 to 3. Each random contact is prepared \
             separately, so that its numbers are not in the nearest cache."
        ));
        self.line(
            "* Errors are defined as in [accuracy.md](accuracy.md). The error of the force is \
             `|f − f_ref|` in units of `μ N`, for the 854 cases of `tests/data/open.csv`. The \
             error of the derivatives is the worst entry of `∂(fx, fy)/∂(vx, vy, φ)` divided \
             by the linear entry, in the 70 states of `tests/data/jacobians.csv`. In single \
             precision the derivatives of double precision are shown.",
        );
        self.line(
            "* FASTSIM 10x10 is the unit of the ratios. It has three flexibilities, a parabolic \
             bound and cell centres (`benches/peers/fastsim.rs`). *Scalar* is the classical loop \
             over strips, as in most programs. *Ten lanes* computes its strips in parallel without \
             branches, in registers of 128 bits. *AVX2* uses registers of 256 bits, if the \
             processor has them.",
        );
        for (name, published) in PUBLISHED {
            let row = self.rows.iter().find(|row| row.name == name);
            let found = row.map_or(f64::NAN, |row| row.wrong.force.max);
            self.line(format!(
                "* The largest error of {name} is {found:.4}. Its published value is \
                 {published}."
            ));
        }
    }

    /// Ratios on this processor and on others.
    fn processors(&mut self, machine: &str) {
        let here = machine.split("), ").next().unwrap_or(machine).replace(" (family", ", family");
        self.line(
            "The table has the time of one call of a model divided by the time of FASTSIM \
             10x10. The contacts are random, with spin, in double precision.\n",
        );
        let mut header = vec![
            "model".to_owned(),
            format!("{here}: of scalar"),
            "of ten lanes".to_owned(),
            "of AVX2".to_owned(),
        ];
        header.extend(ELSEWHERE_TIMES.map(|(name, _)| format!("{name}: of scalar")));
        self.header(&header);
        for (i, name) in ["STRIP_1967", "TOTAL", "STRIP, 16 strips"].into_iter().enumerate() {
            let time = self.time(name, "f64", How::Solve, Set::Spin);
            let mut cells = vec![name.to_owned()];
            cells.extend(
                [SCALAR, LANES, AVX2].map(|peer| digits(time / self.peer(peer, Set::Spin))),
            );
            cells.extend(ELSEWHERE_TIMES.map(|(_, ratios)| digits(ratios[i])));
            self.row(cells);
        }
        self.line(
            "\nThe columns of the first processor are from this run. The last two are from other \
             processors, at two commits whose models are the same. They compare two Intel \
             processors. For your processor, run `cargo bench --bench speed` on a machine that \
             does nothing else. This program writes this page. The other methods have the same \
             code in all runs, so their times compare an AMD and an Intel processor:\n",
        );
        self.header(&[
            "method",
            &format!("{here}: of scalar"),
            "Intel Xeon, family 6, model 167: of scalar",
        ]);
        for (name, there) in UNCHANGED {
            let ratio = self.peer(name, Set::Spin) / self.peer(SCALAR, Set::Spin);
            self.row([name.to_owned(), digits(ratio), digits(there)]);
        }
        self.line("");
        let of_lanes = |name, how| {
            digits(self.time(name, "f64", how, Set::Spin) / self.peer(LANES, Set::Spin))
        };
        let [single, strip] = ["TOTAL", "STRIP, 16 strips"].map(|name| of_lanes(name, How::Solve));
        let batch = of_lanes("TOTAL", How::Batch(100));
        self.line(format!(
            "The scalar FASTSIM, which most programs have, is slower than every model of this \
             table. Relative to FASTSIM in ten SIMD lanes, one call of TOTAL takes {single}, and \
             one call of STRIP takes {strip}. A contact of TOTAL in a batch of 100 takes {batch}."
        ));
    }

    fn fastsim(&mut self) {
        self.line("\n## FASTSIM 10x10\n");
        self.header(&[&["ns"][..], &SETS.map(title)].concat());
        for name in [SCALAR, LANES, AVX2] {
            let times = SETS.map(|set| self.peer(name, set));
            if times[0].is_nan() {
                let why = "SKIPPED: this processor has no AVX2".to_owned();
                self.row([name.to_owned(), why, String::new(), String::new(), String::new()]);
            } else {
                self.row([name.to_owned()].into_iter().chain(times.map(digits)));
            }
        }
    }

    fn everything(&mut self) {
        self.line(format!("\n{EVERY}\n"));
        self.line(
            "Times are nanoseconds. Ratios refer to FASTSIM 10x10 for random contacts with spin. \
             Errors are mean / 95th percentile / max, as described above.\n",
        );
        let mut header = vec!["method", "how", "precision"];
        header.extend(SETS.map(title));
        header.extend(["of scalar", "of ten lanes", "of AVX2", "force", "worst derivative"]);
        self.header(&header);
        let mut lines = Vec::new();
        for row in self.rows.iter().filter(|row| row.set == Set::One) {
            if matches!(row.how, How::Batch(_)) {
                continue;
            }
            let Row { name, precision, how, wrong, .. } = row;
            let is_model =
                self.rows.iter().any(|other| other.name == *name && other.how == How::Forces);
            let how_text = if is_model { manner(*how) } else { String::new() };
            let mut cells = vec![name.clone(), how_text, (*precision).to_owned()];
            let time = |set| self.time(name, precision, *how, set);
            cells.extend(SETS.map(|set| digits(time(set))));
            let over = |peer| digits(time(Set::Spin) / self.peer(peer, Set::Spin));
            cells.extend([SCALAR, LANES, AVX2].map(over));
            let all =
                |f: reference::Figures| format!("{:.4} / {:.4} / {:.4}", f.mean, f.p95, f.max);
            cells.extend([all(wrong.force), all(wrong.slope)]);
            lines.push(cells);
        }
        for cells in lines {
            self.row(cells);
        }
        self.line("\nThe next table was measured with CONTACT's own code, not in this run.\n");
        self.header(&["method", "time", "error of the force, mean"]);
        for (name, time, error) in ELSEWHERE {
            self.row([name.to_owned(), time.to_owned(), error.to_string()]);
        }
    }

    fn batches(&mut self) {
        self.line(format!("\n{BATCHED}\n"));
        self.line(
            "The second table compares a loop over `kstrip_solve` with `kstrip_evaluate_batch` on \
             one array for each quantity. Times are nanoseconds per contact, and the results have \
             the same bits. On x86-64 processors with AVX, four contacts in double precision or \
             eight in single precision share one register. With AVX-512, one register has twice as \
             many. The library checks once whether the processor has AVX and AVX-512. The first \
             table has the time with AVX-512 divided by the time with AVX, on an AMD EPYC of \
             family 26.\n",
        );
        self.header(&["calls", "with AVX-512"]);
        for (calls, ratio) in
            [("TOTAL", "0.62"), ("TOTAL with derivatives", "0.53"), ("STRIP", "0.60")]
        {
            self.row([calls, ratio]);
        }
        self.line("");
        let mut header = vec!["model".to_owned(), "precision".to_owned()];
        for set in [Set::Spin, Set::Mixed] {
            header.push(format!("{}: loop", title(set)));
            header.extend(BATCHES.map(|count| manner(How::Batch(count))));
        }
        self.header(&header);
        for name in self.models() {
            for precision in ["f64", "f32"] {
                let mut cells = vec![name.clone(), precision.to_owned()];
                for set in [Set::Spin, Set::Mixed] {
                    let alone = self.time(&name, precision, How::Solve, set);
                    cells.push(digits(alone));
                    cells.extend(BATCHES.map(|count| {
                        let time = self.time(&name, precision, How::Batch(count), set);
                        format!("{} ({}x)", digits(time), digits(alone / time))
                    }));
                }
                self.row(cells);
            }
        }
    }

    fn mark(&self, row: &Row) -> Option<Mark> {
        let ink = match row.name.split([' ', ',']).next() {
            Some("TOTAL") => BLUE,
            Some("STRIP") => VERMILION,
            Some("STRIP_1967") => GREEN,
            Some("STRIP_1967_CONTINUOUS") => PURPLE,
            Some("FASTSIM") => AMBER,
            Some("FaStrip") => SKY,
            _ => INK,
        };
        let shown = matches!(row.how, How::Solve | How::Prepared | How::Batch(100));
        if row.set != Set::Spin || row.precision != "f64" || !shown || row.name == "LINEAR" {
            return None;
        }
        // settings of one method, the first with its name, the others with their grid
        const LINES: [(&str, &str); 4] = [
            ("FASTSIM", "0, scalar"),
            ("FASTSIM", "0, lanes of AVX2"),
            ("FaStrip", "(energy)"),
            ("FaStrip", "as in CONTACT"),
        ];
        let line = LINES
            .iter()
            .position(|(first, last)| row.name.starts_with(first) && row.name.ends_with(last));
        let label = match (line, row.how) {
            (Some(_), _) if !row.name.contains("10x10") && !row.name.contains("FaStrip 20x20") => {
                row.name.split([' ', ',']).find(|word| word.contains('x')).unwrap_or("").to_owned()
            }
            (_, How::Prepared) => row.name.replace(", 16 strips", "") + " prepared",
            (_, How::Batch(_)) => row.name.replace(", 16 strips", "") + " batch",
            _ => row.name.replace(", flexibility", "").replace(" (spin ignored)", ""),
        };
        // side by side once a model; prepared where it is another cost; FASTSIM in registers once
        let twice = match row.how {
            How::Batch(_) => row.name.contains("8 strips") || row.name.contains("CONTINUOUS"),
            How::Prepared => row.name != "TOTAL",
            _ => row.name.contains("(1982)") || row.name.contains("ten lanes"),
        };
        if twice {
            return None;
        }
        Some(Mark {
            time: row.time(),
            errors: [row.wrong.force.mean, row.wrong.slope.mean],
            label,
            ink,
            filled: row.how == How::Solve,
            line: line.map_or(0, |line| line + 1),
        })
    }
}

/// The rows of the picture, from the page of an earlier run.
fn rows_of_page() -> Vec<Row> {
    let page = std::fs::read_to_string(root().join(PAGE)).unwrap_or_default();
    let cells = |line: &str| -> Vec<String> {
        line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()
    };
    let number = |cell: &str| -> f64 {
        cell.split(' ').next().and_then(|word| word.parse().ok()).unwrap_or(f64::NAN)
    };
    let figures = |cell: &str| {
        let [mean, p95, max] = [0, 1, 2].map(|i| number(cell.split(" / ").nth(i).unwrap_or("")));
        reference::Figures { mean, p95, max }
    };
    let row = |name: &str, how: How, time: f64, wrong: Wrong| Row {
        name: name.to_owned(),
        precision: "f64",
        how,
        set: Set::Spin,
        wrong,
        calls: Box::new(|| ()),
        count: 1,
        times: vec![time],
    };
    let table = |heading: &str| {
        let after = page.split(heading).nth(1).unwrap_or_default();
        let lines = after.lines().skip_while(|line| !line.contains("| precision |")).skip(2);
        let lines = lines.take_while(|line| line.starts_with('|'));
        lines.map(cells).collect::<Vec<_>>()
    };
    let mut rows = vec![];
    for cells in table(EVERY) {
        let how = match cells[1].as_str() {
            "" => How::Solve,
            how if how == manner(How::Solve) => How::Solve,
            how if how == manner(How::Prepared) => How::Prepared,
            _ => continue,
        };
        if cells[2] == "f64" {
            let wrong = Wrong { force: figures(&cells[10]), slope: figures(&cells[11]) };
            rows.push(row(&cells[0], how, number(&cells[4]), wrong));
        }
    }
    for cells in table(BATCHED).iter().filter(|cells| cells[1] == "f64") {
        let wrong = rows.iter().find(|row| row.name == cells[0]).map(|row| row.wrong);
        let wrong = wrong.expect("the errors of a model");
        rows.push(row(&cells[0], How::Batch(100), number(&cells[4]), wrong));
    }
    rows
}

fn draw(report: &Report) -> Drawn {
    let marks: Vec<Mark> = report.rows.iter().filter_map(|row| report.mark(row)).collect();
    plot::draw(&root().join("docs/evidence/speed-vs-error.svg"), &marks)
}

fn main() -> Drawn {
    if std::env::args().nth(1).as_deref() == Some("picture") {
        return draw(&Report { rows: rows_of_page(), text: String::new() });
    }
    let print = std::env::args().nth(1).as_deref() == Some("print");
    let machine = machine();
    let mut report = Report { rows: calls::rows(), text: String::new() };
    let bar = progress::bar(ROUNDS);
    // calls that are too short for the clock are repeated
    let repetitions: Vec<usize> =
        report.rows.iter().map(|row| (50e3 / clock::took(&row.calls)).ceil() as usize).collect();
    for _ in 0..ROUNDS {
        for (row, times) in report.rows.iter_mut().zip(&repetitions) {
            let time = clock::took(|| (0..*times).for_each(|_| (row.calls)()));
            row.times.push(time / (times * row.count) as f64);
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    report.introduction(&machine);
    report.fastsim();
    report.batches();
    report.everything();
    if print {
        print!("{}", report.text);
        return Ok(());
    }
    std::fs::write(root().join(PAGE), &report.text)?;
    draw(&report)?;
    println!("wrote docs/evidence/speed-vs-error.md and docs/evidence/speed-vs-error.svg");
    Ok(())
}
