//! What a call costs, and what it is worth: `cargo bench --bench speed` writes
//! `docs/evidence/speed-vs-error.md` and `docs/evidence/speed-vs-error.svg`.
//!
//! Every model through the C interface and every method of `benches/peers`: nanoseconds (median of
//! rounds that take turns) and errors against CONTACT, all in one run.
//!
//! `cargo bench --bench speed -- print` writes nothing and prints the page: for builds of another
//! kind, as `RUSTFLAGS="-C target-cpu=x86-64-v3" cargo bench --bench speed -- print`.

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

use calls::{AVX2, BATCHES, CALLS, How, LANES, Row, SCALAR, SETS, Set};
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

/// Ratios to FASTSIM 10x10, scalar, random contacts with spin, of earlier states of the library: of
/// commits 5a9305f and 97d2727, the last before contacts, strips and pairs became one kind of
/// lanes, whose models are the same, and of a state before them. STRIP_1967, TOTAL, STRIP.
const EARLIER: [(&str, [f64; 3]); 4] = [
    ("commit 5a9305f, Intel Xeon, family 6, model 207", [0.303, 0.342, 0.677]),
    ("commit 97d2727, Intel Xeon, family 6, model 167", [0.308, 0.355, 0.668]),
    ("an earlier state, AMD EPYC, Zen 3", [0.304, 0.300, 0.542]),
    ("an earlier state, AMD EPYC, Zen 1", [0.243, 0.32, 0.76]),
];

/// The same ratios of other methods, whose code has not changed since, on an Intel Xeon, family 6,
/// model 167.
const UNCHANGED: [(&str, f64); 6] = [
    (LANES, 190.0 / 656.0),
    (AVX2, 205.0 / 656.0),
    ("FASTSIM 20x20, scalar", 3135.0 / 656.0),
    ("FASTSIM 20x20, ten lanes", 683.0 / 656.0),
    ("FaStrip 20x20, flexibility (energy)", 1332.0 / 656.0),
    ("Polach", 30.9 / 656.0),
];

/// Methods of which this implementation misses the largest error that was published for it on the
/// same cases (`tests/peers.rs`).
const MISSED: [(&str, f64); 3] = [
    ("FaStrip 20x20, flexibility (1982)", 0.18),
    ("FaStrip 80x50, flexibility (1982)", 0.16),
    ("FaStrip 20x20 as in CONTACT", 0.12),
];

/// `kstrip_evaluate` may cost this much of `kstrip_solve` where the forces alone are requested.
const ALONE: f64 = 1.05;

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

    /// Over the classical loop of FASTSIM 10x10 on the same inputs, double precision.
    fn ratio(&self, name: &str, how: How, set: Set) -> f64 {
        self.time(name, "f64", how, set) / self.peer(SCALAR, set)
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
            "The picture plots the error against the time of one contact, for every model and \
             every other method: the best are at the lower left. Times depend on the",
        );
        self.line(
            "processor, and so do ratios of times: in the first table they differ by up to \
             two fifths between processors. Counts of instructions do not depend on",
        );
        self.line("the processor.\n");
        self.processors(machine);
        self.line("\n## How it was measured\n");
        self.line(format!("* Machine: {machine}."));
        self.line(format!(
            "* Times are nanoseconds of a contact: the median of {ROUNDS} rounds in which all rows \
             take turns, in processor time of the thread. Other programs are not counted, though \
             caches and clock rate are shared with them: ratios of two runs differ by less than 3 \
             % as a rule, and by up to 6 % in batches. Models are called through the C interface \
             by a pointer that the compiler cannot see through. They check their input and, unless \
             prepared, compute the linear coefficients in every call. The other methods are called \
             the same way, but they check nothing, and they are given their coefficients and grids."
        ));
        self.line(format!(
            "* Inputs: {CALLS} of each kind. *One contact*: a = 6 mm, b = 4 mm, 80 kN, steel, μ = \
             0.3, creepages from partial slip to sliding, |ψ| up to 0.5. *Random*: a/b 0.1 to 10, \
             ν 0 to 0.5, linear force 0 to 3 μ N in any direction, |ψ| up to 0.95, or no spin. \
             *Mixed*: the same, in turns with spin, without, longitudinal alone, lateral with \
             spin, spin alone, and |ψ| from 1 to 3. Each random contact is prepared by itself, so \
             that its numbers (776 bytes) are not in the nearest cache."
        ));
        self.line(
            "* Errors: of the force, `|f − f_ref|` in units of `μ N`, for the 854 cases of \
             `tests/data/open.csv`; of the derivatives, the worst entry of `∂(fx, fy)/∂(vx, vy, \
             φ)` divided by the linear one, in the 70 states of `tests/data/jacobians.csv`; both \
             as in [accuracy.md](accuracy.md). In single precision the derivatives are those of \
             double precision.",
        );
        self.line(
            "* FASTSIM 10x10 (3 flexibilities, parabolic bound, cell centres; \
             `benches/peers/fastsim.rs`) is the unit of the ratios. *Scalar* is the classical \
             loop, strip after strip, as most programs have it. *Ten lanes* computes its strips \
             side by side without branches, in registers of 128 bits. *AVX2* uses those of 256 \
             bits, where the processor has them.",
        );
        for (name, published) in MISSED {
            let row = self.rows.iter().find(|row| row.name == name);
            let found = row.map_or(f64::NAN, |row| row.wrong.force.max);
            self.line(format!(
                "* {name} misses its published figures: largest error {found:.4} here, {published} \
                 there."
            ));
        }
    }

    /// Ratios on this processor and on others, and counts of instructions.
    fn processors(&mut self, machine: &str) {
        let counts = std::fs::read_to_string(root().join("benches/instructions.txt"));
        let counts = counts.unwrap_or_default();
        let instructions = |start: &str| {
            let count = counts.lines().find_map(|line| line.strip_prefix(start));
            count.unwrap_or("–").to_owned()
        };
        let here = machine.split("), ").next().unwrap_or(machine).replace(" (family", ", family");
        self.line(
            "Time of one call of a model divided by that of FASTSIM 10x10, for random \
             contacts with spin in double precision:\n",
        );
        let mut header = vec![
            "model".to_owned(),
            "instructions".to_owned(),
            format!("{here}: of scalar"),
            "of ten lanes".to_owned(),
            "of AVX2".to_owned(),
        ];
        header.extend(EARLIER.map(|(name, _)| format!("{name}: of scalar")));
        self.header(&header);
        let rows = [
            ("STRIP_1967", "STRIP_1967 f64 solve 16 "),
            ("TOTAL", "TOTAL f64 solve 0 "),
            ("STRIP, 16 strips", "STRIP f64 solve 16 "),
        ];
        for (i, (name, start)) in rows.into_iter().enumerate() {
            let time = self.time(name, "f64", How::Solve, Set::Spin);
            let mut cells = vec![name.to_owned(), instructions(start)];
            cells.extend(
                [SCALAR, LANES, AVX2].map(|peer| digits(time / self.peer(peer, Set::Spin))),
            );
            cells.extend(EARLIER.map(|(_, ratios)| digits(ratios[i])));
            self.row(cells);
        }
        self.line(
            "\nThe columns of the first processor are those of this run. The last four were \
             measured on other processors, with earlier states of the library that were not run \
             again. Its models are the same in the two commits that are named, which",
        );
        self.line(
            "therefore compare two Intel processors. For your processor, run `cargo bench --bench \
             speed` on a machine that does nothing else: it writes this page. The code of the \
             other methods is the same in all runs, and compares an AMD and an Intel processor:\n",
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
        let error = |name: &str| {
            let row = self.rows.iter().find(|row| row.name == name);
            row.map_or(f64::NAN, |row| row.wrong.force.mean)
        };
        let [ours, theirs] = ["TOTAL", LANES].map(error);
        self.line(format!(
            "The scalar FASTSIM, which most programs have, is slower than every model of this \
             table. Of the time of FASTSIM in ten lanes one call of TOTAL takes {single}, a \
             contact of TOTAL in a batch of 100 {batch}, and one call of STRIP {strip}. The mean \
             error of the force is {ours:.4} of `μ N` with TOTAL and {theirs:.4} with FASTSIM."
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

    fn wanted(&mut self) {
        use How::{Batch, Derivatives, Forces, Prepared, Solve};
        let scalar = "of FASTSIM 10x10, scalar";
        let mut rows: Vec<(String, &str, Set, f64, f64)> = Vec::new();
        for (name, how, set, aim) in [
            ("STRIP_1967", Solve, Set::Spin, 0.2),
            ("STRIP_1967", Solve, Set::NoSpin, 0.08),
            ("STRIP, 16 strips", Solve, Set::Spin, 0.6),
            ("STRIP, 8 strips", Solve, Set::Spin, 0.45),
            ("TOTAL", Solve, Set::Spin, 0.22),
            ("TOTAL", Prepared, Set::One, 0.165),
            ("LINEAR", Prepared, Set::One, 0.008),
            ("STRIP_1967", Batch(100), Set::Spin, 0.08),
            ("STRIP, 16 strips", Batch(100), Set::Spin, 0.25),
            ("TOTAL", Batch(100), Set::Spin, 0.1),
        ] {
            let what = format!("{name}, {}", manner(how));
            rows.push((what, scalar, set, self.ratio(name, how, set), aim));
        }
        for (name, aim) in [("STRIP_1967", 2.2), ("STRIP, 16 strips", 2.5), ("TOTAL", 2.5)] {
            let of = |how| self.time(name, "f64", how, Set::Spin);
            let what = format!("{name}, with derivatives");
            rows.push((what, "of its forces", Set::Spin, of(Derivatives) / of(Solve), aim));
        }
        // the worst of all models and precisions
        let worst = |of: &dyn Fn(&str, &str) -> f64| {
            let mut worst = (String::new(), 0.0);
            for name in self.models() {
                for precision in ["f64", "f32"] {
                    let found = of(&name, precision);
                    if found > worst.1 {
                        worst = (format!("{name}, {precision}"), found);
                    }
                }
            }
            worst
        };
        let (name, found) = worst(&|name, precision| {
            let of = |how| self.time(name, precision, how, Set::Spin);
            of(Forces) / of(Solve)
        });
        let what = format!("forces alone, the most expensive model ({name})");
        rows.push((what, "of `kstrip_solve`", Set::Spin, found, ALONE));
        for count in [100, 1000] {
            let (name, found) = worst(&|name, precision| {
                let of = |how| self.time(name, precision, how, Set::Mixed);
                of(Batch(count)) / of(Solve)
            });
            let what = format!("batch of {count}, the most expensive model ({name})");
            rows.push((what, "of a loop over `kstrip_solve`", Set::Mixed, found, 1.0));
        }
        self.line("\n## Targets\n");
        self.line(
            "These ratios were aims of the design. They are in double precision unless \
             another one is named.\n",
        );
        self.header(&["what", "inputs", "ratio", "measured", "target", ""]);
        for (what, ratio, set, found, aim) in rows {
            let short = |x: f64| format!("{x:.3}");
            let verdict = if found <= aim { "met" } else { "missed" };
            let inputs = title(set).to_owned();
            self.row([
                what,
                inputs,
                ratio.to_owned(),
                short(found),
                short(aim),
                verdict.to_owned(),
            ]);
        }
    }

    fn everything(&mut self) {
        self.line("\n## Every model and every other method\n");
        self.line(
            "Nanoseconds; ratios to FASTSIM 10x10 for random contacts with spin; errors \
             (mean / 95th percentile / max) as described above.\n",
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
        self.line("\nMeasured with CONTACT's own code, earlier and not in this run:\n");
        self.header(&["method", "time", "error of the force, mean"]);
        for (name, time, error) in ELSEWHERE {
            self.row([name.to_owned(), time.to_owned(), error.to_string()]);
        }
    }

    fn batches(&mut self) {
        self.line("\n## Many contacts at once\n");
        self.line(
            "`kstrip_evaluate_batch` with one array for each quantity against a loop over \
             `kstrip_solve`, nanoseconds of a contact; the results are the same bits. On x86-64 \
             processors with AVX, four contacts in double precision or eight in single precision \
             stand side by side in one register; with AVX-512 twice as many. The library checks \
             once whether the processor has AVX and AVX-512, and remembers it. AVX-512 takes 0.62 \
             of the time of AVX for TOTAL, 0.53 with derivatives, 0.60 for STRIP (AMD EPYC, \
             family 26).\n",
        );
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
        const LINES: [(&str, &str); 5] = [
            ("FASTSIM", "0, scalar"),
            ("FASTSIM", "0, ten lanes"),
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
        // side by side once a model; prepared where it is another cost
        let twice = match row.how {
            How::Batch(_) => row.name.contains("8 strips") || row.name.contains("CONTINUOUS"),
            How::Prepared => row.name != "TOTAL",
            _ => row.name.contains("(1982)"),
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

fn main() -> Drawn {
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
    report.wanted();
    report.batches();
    report.everything();
    if print {
        print!("{}", report.text);
        return Ok(());
    }
    let marks: Vec<Mark> = report.rows.iter().filter_map(|row| report.mark(row)).collect();
    std::fs::write(root().join("docs/evidence/speed-vs-error.md"), &report.text)?;
    plot::draw(&root().join("docs/evidence/speed-vs-error.svg"), &marks)?;
    println!("wrote docs/evidence/speed-vs-error.md and docs/evidence/speed-vs-error.svg");
    Ok(())
}
