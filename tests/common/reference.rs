//! Cases computed with CONTACT, and how far a model is from them. Used by
//! `tests/models/accuracy.rs` and by `reports/accuracy.rs`.

pub use crate::theory::options;
use crate::toolchain::root;
use kstrip::contact::Contact;
use kstrip::contact::creepage::Creepage;
use kstrip::contact::totals::StripCount;
use kstrip::forces::{self, Field, Model, Options};
use kstrip::linear::LinearCoefficients;
use kstrip::number::Float;
use kstrip::strip_1967::strip::State;
use std::collections::HashSet;
use std::f64::consts::PI;
use std::ops::Range;
use std::path::PathBuf;

/// A contact of which only the dimensionless numbers matter: `√(ab)` \[m\], `G` \[Pa\], `N` \[N\],
/// `μ`.
pub const SIZE: f64 = 5e-3;
pub const SHEAR_MODULUS: f64 = 82e9;
pub const NORMAL_FORCE: f64 = 82e3;
pub const FRICTION: f64 = 0.3;
/// `μ N`
pub const BOUND: f64 = FRICTION * NORMAL_FORCE;
/// Creepage that makes `vx = 1`: `μ N/(G a b)`.
pub const UNIT: f64 = BOUND / (SHEAR_MODULUS * SIZE * SIZE);

/// One case of the reference, dimensionless as in `tests/data/README.md`.
#[derive(Clone, Debug)]
pub struct Case {
    /// `a/b`
    pub axis_ratio: f64,
    pub poisson_ratio: f64,
    /// `vx, vy, φ`
    pub creepage: [f64; 3],
    /// `Fx, Fy` in `μ N`.
    pub force: [f64; 2],
    /// In `μ N √(ab)`.
    pub moment: f64,
    /// Share of the contact in adhesion.
    pub stick: f64,
}

impl Case {
    /// A state without a reference.
    pub fn new(axis_ratio: f64, poisson_ratio: f64, creepage: [f64; 3]) -> Self {
        Self { axis_ratio, poisson_ratio, creepage, force: [0.0; 2], moment: 0.0, stick: 0.0 }
    }

    pub fn contact<F: Float>(&self) -> Contact<F> {
        contact(self.axis_ratio, self.poisson_ratio)
    }

    pub fn motion<F: Float>(&self) -> Creepage<F> {
        let [x, y, spin] = self.creepage;
        Creepage {
            longitudinal: F::of(x * UNIT),
            lateral: F::of(y * UNIT),
            spin: F::of(spin * UNIT / SIZE),
        }
    }

    /// `ψ = (π/3) √(a/b) φ`
    pub fn psi(&self) -> f64 {
        PI / 3.0 * self.axis_ratio.sqrt() * self.creepage[2]
    }

    /// `C11 vx, C22 vy, C23 φ`: the force of the linear theory in `μ N`, creepage and spin apart.
    pub fn linear_force(&self) -> [f64; 3] {
        let c = LinearCoefficients::at(self.axis_ratio, self.poisson_ratio);
        let [x, y, spin] = self.creepage;
        [c.c11 * x, c.c22 * y, c.c23 * spin]
    }

    /// Size of the creepage without spin: `|(C11 vx, C22 vy)|`.
    pub fn creep_force(&self) -> f64 {
        let [x, y, _] = self.linear_force();
        x.hypot(y)
    }

    /// Size of all of it, with the moment: `|(C11 vx, C22 vy, C23 φ, C33 φ)|`.
    pub fn linear_size(&self) -> f64 {
        let c33 = LinearCoefficients::at(self.axis_ratio, self.poisson_ratio).c33;
        self.creep_force().hypot(self.linear_force()[2]).hypot(c33 * self.creepage[2])
    }
}

pub fn contact<F: Float>(axis_ratio: f64, poisson_ratio: f64) -> Contact<F> {
    Contact {
        a: F::of(SIZE * axis_ratio.sqrt()),
        b: F::of(SIZE / axis_ratio.sqrt()),
        normal_force: F::of(NORMAL_FORCE),
        shear_modulus: F::of(SHEAR_MODULUS),
        poisson_ratio: F::of(poisson_ratio),
        friction: F::of(FRICTION),
        mismatch: F::zero(),
    }
}

/// A CSV file with a header.
pub struct Table {
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    pub fn read(path: PathBuf) -> Self {
        let mut reader =
            csv::Reader::from_path(&path).unwrap_or_else(|error| panic!("{path:?}: {error}"));
        let columns = reader.headers().expect("a header").iter().map(str::to_owned).collect();
        let rows = reader
            .records()
            .map(|record| record.expect("a row").iter().map(str::to_owned).collect())
            .collect();
        Self { columns, rows }
    }

    pub fn rows(&self) -> Range<usize> {
        0..self.rows.len()
    }

    pub fn text(&self, row: usize, column: &str) -> &str {
        let found = self.columns.iter().position(|name| name == column);
        &self.rows[row][found.expect("a column of that name")]
    }

    pub fn number(&self, row: usize, column: &str) -> f64 {
        self.text(row, column).parse().expect("a number")
    }
}

/// The first columns of a file of `tests/data`, which are numbers.
pub fn numbers<const N: usize>(file: &str) -> Vec<[f64; N]> {
    let mut reader = csv::Reader::from_path(root().join("tests/data").join(file)).expect(file);
    let row = |record: Result<csv::StringRecord, _>| {
        let record = record.expect("a row");
        std::array::from_fn(|i| record[i].parse().expect("a number"))
    };
    reader.records().map(row).collect()
}

fn case(table: &Table, row: usize) -> Case {
    let at = |column| table.number(row, column);
    Case {
        axis_ratio: at("a_over_b"),
        poisson_ratio: at("nu"),
        creepage: ["vx", "vy", "phi"].map(at),
        force: ["fx", "fy"].map(at),
        moment: at("mz"),
        stick: at("stick"),
    }
}

fn cases(file: &str) -> Vec<Case> {
    let table = Table::read(root().join("tests/data").join(file));
    table.rows().map(|row| case(&table, row)).collect()
}

/// The 854 cases of `tests/data/open.csv`.
pub fn open() -> Vec<Case> {
    cases("open.csv")
}

/// The 140 slender cases of `tests/data/open_slender.csv`.
pub fn slender() -> Vec<Case> {
    cases("open_slender.csv")
}

/// The 576 cases of `tests/data/boundary_elements.csv`: large creepage that spin turns around
/// within the contact.
pub fn turning() -> Vec<Case> {
    cases("boundary_elements.csv")
}

/// The rows of the training files on which no model was trained (`fit/validation_rows.py`), or the
/// others.
fn training_files(validation: bool) -> Vec<Case> {
    let folder = root().join("fit/data");
    let kept = Table::read(folder.join("validation_rows.csv"));
    let kept: HashSet<(&str, usize)> =
        kept.rows().map(|row| (kept.text(row, "file"), kept.number(row, "row") as usize)).collect();
    let mut cases = Vec::new();
    for name in ["train.csv", "train_fine.csv"] {
        let table = Table::read(folder.join(name));
        cases.extend(
            table
                .rows()
                .filter(|row| kept.contains(&(name, *row)) == validation)
                .map(|row| case(&table, row)),
        );
    }
    cases
}

/// A contact of unlike materials, and the same of like ones.
pub struct UnlikePair {
    pub contact: Contact<f64>,
    pub motion: Creepage<f64>,
    /// Force of the first minus force of the second, in `μ N`.
    pub difference: [f64; 2],
}

impl UnlikePair {
    pub fn difference(&self, model: Model) -> [f64; 2] {
        let options = options(model, StripCount::Sixteen);
        let force = |mismatch| {
            let contact = Contact { mismatch, ..self.contact };
            let found =
                forces::forces_of_contact(&contact, &self.motion, &options).expect("valid input");
            [found.fx, found.fy].map(|force| force / contact.friction_bound())
        };
        let ([x, y], [x0, y0]) = (force(self.contact.mismatch), force(0.0));
        [x - x0, y - y0]
    }

    /// Steel on aluminium, cast iron or bronze, dry.
    pub fn is_ordinary(&self) -> bool {
        self.contact.mismatch.abs() <= 0.13 && self.contact.friction >= 0.3
    }
}

/// `tests/data/kappa.csv`.
pub fn unlike() -> Vec<UnlikePair> {
    let table = Table::read(root().join("tests/data/kappa.csv"));
    let pair = |row| {
        let at = |column| table.number(row, column);
        let unit = at("mu") * NORMAL_FORCE / (SHEAR_MODULUS * SIZE * SIZE);
        let like = contact(at("a_over_b"), at("nu"));
        UnlikePair {
            contact: Contact { friction: at("mu"), mismatch: at("kappa"), ..like },
            motion: Creepage {
                longitudinal: at("vx") * unit,
                lateral: at("vy") * unit,
                spin: at("phi") * unit / SIZE,
            },
            difference: [at("fx") - at("fx0"), at("fy") - at("fy0")],
        }
    };
    table.rows().map(pair).collect()
}

/// The 1784 cases kept for validation.
pub fn validation() -> Vec<Case> {
    training_files(true)
}

/// The 16 047 cases of the fit.
pub fn training() -> Vec<Case> {
    training_files(false)
}

/// What a method says about a case, dimensionless as the reference; NaN where it says nothing.
#[derive(Clone, Copy, Debug)]
pub struct Answer {
    pub force: [f64; 2],
    pub moment: f64,
    pub stick: f64,
}

/// The answer of a model of the library.
pub fn answer<F: Float>(case: &Case, options: &Options) -> Answer {
    let solution = forces::forces_of_contact(&case.contact::<F>(), &case.motion::<F>(), options)
        .unwrap_or_else(|error| panic!("{error} {case:?} {options:?}"));
    let adhesion = solution.adhesion.to_f64();
    Answer {
        force: [solution.fx.to_f64() / BOUND, solution.fy.to_f64() / BOUND],
        moment: solution.mz.to_f64() / (BOUND * SIZE),
        stick: if options.model == Model::Total { f64::NAN } else { adhesion },
    }
}

/// The errors of a method on some cases, in the order of the cases.
#[derive(Clone, Debug, Default)]
pub struct Errors {
    /// `|f − f_ref|` in `μ N`
    pub force: Vec<f64>,
    /// `|mz − mz_ref|` in `μ N √(ab)`
    pub moment: Vec<f64>,
    /// `|stick − stick_ref|`
    pub stick: Vec<f64>,
}

impl Errors {
    pub fn of(cases: &[Case], solve: impl Fn(&Case) -> Answer) -> Self {
        let mut errors = Self::default();
        for case in cases {
            let answer = solve(case);
            let [x, y] = answer.force;
            errors.force.push((x - case.force[0]).hypot(y - case.force[1]));
            errors.moment.push((answer.moment - case.moment).abs());
            errors.stick.push((answer.stick - case.stick).abs());
        }
        errors
    }

    pub fn of_model<F: Float>(cases: &[Case], options: &Options) -> Self {
        Self::of(cases, |case| answer::<F>(case, options))
    }

    /// The errors on the cases that satisfy `holds`.
    pub fn only(&self, cases: &[Case], holds: impl Fn(&Case) -> bool) -> Self {
        let pick = |all: &[f64]| {
            all.iter().zip(cases).filter(|(_, case)| holds(case)).map(|(e, _)| *e).collect()
        };
        Self { force: pick(&self.force), moment: pick(&self.moment), stick: pick(&self.stick) }
    }
}

/// Mean, 95th percentile (linear between order statistics) and maximum.
#[derive(Clone, Copy, Debug)]
pub struct Figures {
    pub mean: f64,
    pub p95: f64,
    pub max: f64,
}

pub fn figures(errors: &[f64]) -> Figures {
    let n = errors.len();
    if n == 0 || errors.iter().any(|error| error.is_nan()) {
        return Figures { mean: f64::NAN, p95: f64::NAN, max: f64::NAN };
    }
    let mut sorted = errors.to_vec();
    sorted.sort_by(f64::total_cmp);
    let place = 0.95 * (n - 1) as f64;
    let (low, high) = (sorted[place.floor() as usize], sorted[place.ceil() as usize]);
    Figures {
        mean: errors.iter().sum::<f64>() / n as f64,
        p95: low + place.fract() * (high - low),
        max: sorted[n - 1],
    }
}

/// The name of a model in reports.
pub fn name(model: Model) -> &'static str {
    match model {
        Model::Strip1967 => "STRIP_1967",
        Model::Strip1967Continuous => "STRIP_1967_CONTINUOUS",
        Model::Strip => "STRIP",
        Model::Total => "TOTAL",
        Model::Linear => "LINEAR",
        _ => "?",
    }
}

/// A traction field of the reference.
pub struct FieldCase {
    pub name: String,
    pub axis_ratio: f64,
    pub poisson_ratio: f64,
    /// `ξ, η, ψ`
    pub parameters: [f64; 3],
    pub cells: Vec<Cell>,
}

/// A cell of it: `x/a`, `y/b`, traction in `μ p₀`.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    pub x: f64,
    pub y: f64,
    pub traction: [f64; 2],
    pub sticks: bool,
}

/// The 11 fields of `tests/data/fields`.
pub fn fields() -> Vec<FieldCase> {
    let folder = root().join("tests/data/fields");
    let index = Table::read(folder.join("index.csv"));
    index
        .rows()
        .map(|case| {
            let file = index.text(case, "file");
            let table = Table::read(folder.join(file));
            let cell = |row| Cell {
                x: table.number(row, "x_over_a"),
                y: table.number(row, "y_over_b"),
                traction: ["px", "py"].map(|column| table.number(row, column)),
                sticks: table.text(row, "state") == "stick",
            };
            FieldCase {
                name: file.trim_end_matches(".csv").to_owned(),
                axis_ratio: index.number(case, "a_over_b"),
                poisson_ratio: index.number(case, "nu"),
                parameters: ["xi", "eta", "psi"].map(|column| index.number(case, column)),
                cells: table.rows().map(cell).collect(),
            }
        })
        .collect()
}

impl FieldCase {
    /// The field of a model in the units of the reference: contact and field.
    pub fn solve<F: Float>(&self, model: Model) -> (Contact<F>, Field<F>) {
        let contact = contact::<F>(self.axis_ratio, self.poisson_ratio);
        let [xi, eta, psi] = self.parameters;
        let creepage = [(1.0 - self.poisson_ratio) * xi, eta, psi / self.axis_ratio.sqrt()]
            .map(|x| 3.0 / PI * x);
        let case = Case::new(self.axis_ratio, self.poisson_ratio, creepage);
        let options = options(model, StripCount::Sixteen);
        let field = Field::new(&contact, &case.motion(), &options);
        (contact, field.unwrap_or_else(|error| panic!("{error} {}", self.name)))
    }

    /// `Σ |p − p_ref|/Σ μ p_n`, and by how much the share of sticking cells is off.
    pub fn errors<F: Float>(&self, model: Model) -> FieldErrors {
        let (contact, field) = self.solve::<F>(model);
        let unit = contact.peak_pressure().to_f64();
        let (mut off, mut bound) = (0.0, 0.0);
        let (mut sticks, mut reference, mut wrong) = (0.0, 0.0, 0.0);
        for cell in &self.cells {
            let point = field.at(contact.a * F::of(cell.x), contact.b * F::of(cell.y));
            let traction =
                [point.traction_x, point.traction_y].map(|p| p.to_f64() / (FRICTION * unit));
            off += (traction[0] - cell.traction[0]).hypot(traction[1] - cell.traction[1]);
            bound += point.pressure.to_f64() / unit;
            let stick = point.state == State::Stick;
            sticks += f64::from(u8::from(stick));
            reference += f64::from(u8::from(cell.sticks));
            wrong += f64::from(u8::from(stick != cell.sticks));
        }
        let cells = self.cells.len() as f64;
        FieldErrors {
            traction: off / bound,
            stick: (sticks - reference) / cells,
            wrong_state: wrong / cells,
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub struct FieldErrors {
    /// `Σ |p − p_ref|/Σ μ p_n` over the cells
    pub traction: f64,
    /// Share of cells that stick, minus the reference's.
    pub stick: f64,
    /// Share of cells whose state differs from the reference's.
    pub wrong_state: f64,
}

/// A row of `tests/data/kalker_coefficients.csv`.
pub struct CoefficientCase {
    pub axis_ratio: f64,
    pub poisson_ratio: f64,
    /// `C11, C22, C23, C33`
    pub reference: [f64; 4],
}

pub fn coefficient_cases() -> Vec<CoefficientCase> {
    let table = Table::read(root().join("tests/data/kalker_coefficients.csv"));
    table
        .rows()
        .map(|row| CoefficientCase {
            axis_ratio: table.number(row, "a_over_b"),
            poisson_ratio: table.number(row, "nu"),
            reference: ["c11", "c22", "c23", "c33"].map(|column| table.number(row, column)),
        })
        .collect()
}

impl CoefficientCase {
    /// Ours over the reference's, minus one.
    pub fn errors<F: Float>(&self) -> [f64; 4] {
        let c = LinearCoefficients::at(F::of(self.axis_ratio), F::of(self.poisson_ratio));
        let ours = [c.c11, c.c22, c.c23, c.c33].map(|c| c.to_f64());
        std::array::from_fn(|i| ours[i] / self.reference[i] - 1.0)
    }
}

/// A part of the cases.
pub struct Region {
    pub name: &'static str,
    pub holds: fn(&Case) -> bool,
}
