//! Patches computed with CONTACT (`tests/data/patches`), and how far ours are from them. Used by
//! `tests/models/patch_accuracy.rs` and by `reports/patches.rs`.

use crate::prelude;
use crate::toolchain::root;
use kstrip::contact::Contact;
use kstrip::contact::creepage::Creepage;
use kstrip::contact::totals::StripCount;
use kstrip::forces::Model;
use kstrip::friction::SlipFriction;
use kstrip::normal::cells::Given;
use kstrip::normal::{Indentation, Profile, ProfileContact};
use kstrip::patch::{Patch, PatchStrip, friction, solver};
use std::collections::HashMap;

pub type Full = Patch<f64>;

/// A row of a table, by the names of its columns.
pub type Row = HashMap<String, String>;

fn rows(file: &str) -> Vec<Row> {
    rows_of("patches", file)
}

/// Those of a file in a folder of `tests/data`.
pub fn rows_of(folder: &str, file: &str) -> Vec<Row> {
    let path = root().join("tests/data").join(folder).join(file);
    let mut reader = csv::Reader::from_path(path).unwrap();
    reader.deserialize().map(|row| row.unwrap()).collect()
}

pub fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|_| panic!("{column} of {row:?}"))
}

/// Creepages in units of `k`, and CONTACT's answer in units of `μ N` and `μ N c`.
#[derive(Clone, Copy, Debug)]
pub struct Motion {
    pub creepage: [f64; 3],
    pub force: [f64; 2],
    pub moment: f64,
}

impl Motion {
    fn of(row: &Row) -> Self {
        let number = |column| number(row, column);
        Self {
            creepage: ["vx", "vy", "phi"].map(number),
            force: ["fx", "fy"].map(number),
            moment: number("mz"),
        }
    }
}

/// A row of cells of the reference: `y`, half length, centre, load over the width.
#[derive(Clone, Copy, Debug)]
pub struct Outline {
    pub y: f64,
    pub half_length: f64,
    pub centre_x: f64,
    pub peak_pressure: f64,
    pub load: f64,
}

/// A patch of the reference, in m, N, Pa.
#[derive(Clone, Debug, Default)]
pub struct Case {
    pub name: String,
    pub family: String,
    pub rolling_radius: f64,
    pub load: f64,
    pub friction: f64,
    pub shear_modulus: f64,
    pub poisson_ratio: f64,
    pub size: f64,
    pub area: f64,
    pub peak_pressure: f64,
    pub approach: f64,
    pub cell: f64,
    pub y: Vec<f64>,
    pub distance: Vec<f64>,
    /// Of each point; empty: none.
    pub centre_x: Vec<f64>,
    pub radii: Vec<f64>,
    pub zones: usize,
    pub outline: Vec<Outline>,
    pub motions: Vec<Motion>,
}

/// Errors of force, moment; the latter in `μ N c`.
#[derive(Clone, Debug, Default)]
pub struct Errors {
    pub force: Vec<f64>,
    pub moment: Vec<f64>,
}

/// Mean, 95th percentile, maximum.
pub fn statistics(errors: &[f64]) -> [f64; 3] {
    let mut sorted = errors.to_vec();
    sorted.sort_by(f64::total_cmp);
    let at = |share: f64| sorted[((sorted.len() - 1) as f64 * share).round() as usize];
    [errors.iter().sum::<f64>() / errors.len() as f64, at(0.95), at(1.0)]
}

impl Errors {
    pub fn extend(&mut self, other: Self) {
        self.force.extend(other.force);
        self.moment.extend(other.moment);
    }
}

impl Case {
    pub fn contact(&self) -> ProfileContact<f64> {
        ProfileContact {
            rolling_radius: self.rolling_radius,
            given: Given::Load(self.load),
            shear_modulus: self.shear_modulus,
            poisson_ratio: self.poisson_ratio,
            friction: self.friction,
            smoothing_length: 0.0,
        }
    }

    pub fn profile(&self) -> Profile<'_, f64> {
        let mut profile = Profile::new(&self.y, &self.distance).unwrap();
        if !self.centre_x.is_empty() {
            profile = profile.with_centre_x(&self.centre_x).unwrap();
        }
        if !self.radii.is_empty() {
            profile = profile.with_rolling_radius(&self.radii).unwrap();
        }
        profile
    }

    pub fn patch(&self, count: StripCount) -> (Full, Indentation<f64>) {
        Full::from_profile(&self.profile(), &self.contact(), count).unwrap()
    }

    /// CONTACT's own outline and loads as strips.
    pub fn reference_patch(&self) -> Full {
        let strips: Vec<_> = self
            .outline
            .iter()
            .filter(|row| row.half_length > 0.0)
            .map(|row| PatchStrip {
                y: row.y,
                width: self.cell,
                half_length: row.half_length,
                centre_x: row.centre_x,
                peak_pressure: row.peak_pressure,
                friction: self.friction,
            })
            .collect();
        Full::from_strips(&strips, self.shear_modulus, self.poisson_ratio).unwrap()
    }

    pub fn creepage(&self, motion: &Motion) -> Creepage<f64> {
        let unit = self.friction * self.load / (self.shear_modulus * self.size * self.size);
        let [x, y, spin] = motion.creepage.map(|x| x * unit);
        Creepage { longitudinal: x, lateral: y, spin: spin / self.size }
    }

    pub fn errors(&self, patch: &Full, model: Model) -> Errors {
        self.errors_under(patch, None, model)
    }

    /// Under friction that falls with the slip, or not.
    pub fn errors_under(
        &self, patch: &Full, law: Option<&SlipFriction<f64>>, model: Model,
    ) -> Errors {
        let view = patch.view().unwrap();
        let bound = self.friction * self.load;
        let mut errors = Errors::default();
        for motion in &self.motions {
            let creepage = self.creepage(motion);
            let found = match law {
                Some(law) => {
                    friction::solve_patch_with_law(&view, &creepage, law, model).unwrap().solution
                }
                None => solver::solve_patch(&view, &creepage, model).unwrap(),
            };
            let [fx, fy] = motion.force;
            errors.force.push((found.fx / bound - fx).hypot(found.fy / bound - fy));
            errors.moment.push((found.mz / bound / self.size - motion.moment).abs());
        }
        errors
    }
}

/// The cases of a folder, their profiles and forces, and what only one of the folders has of a case
/// and of a point.
fn read(folder: &str, of_case: fn(&Row, &mut Case), of_point: fn(&Row, &mut Case)) -> Vec<Case> {
    let mut cases = Vec::new();
    let mut index = HashMap::new();
    for row in rows_of(folder, "cases.csv") {
        let number = |column| number(&row, column);
        let mut case = Case {
            name: row["case"].clone(),
            family: row["family"].clone(),
            load: number("normal_force_N"),
            friction: number("mu"),
            shear_modulus: number("G_MPa") * 1e6,
            poisson_ratio: number("nu"),
            size: number("c_mm") * 1e-3,
            area: number("area_mm2") * 1e-6,
            peak_pressure: number("pmax_MPa") * 1e6,
            ..Case::default()
        };
        of_case(&row, &mut case);
        index.insert(case.name.clone(), cases.len());
        cases.push(case);
    }
    for row in rows_of(folder, "profiles.csv") {
        let case = &mut cases[index[&row["case"]]];
        case.y.push(number(&row, "y_mm") * 1e-3);
        case.distance.push(number(&row, "h_um") * 1e-6);
        of_point(&row, case);
    }
    for row in rows_of(folder, "forces.csv") {
        cases[index[&row["case"]]].motions.push(Motion::of(&row));
    }
    cases
}

pub fn profiles() -> Vec<Case> {
    let of_case = |row: &Row, case: &mut Case| {
        case.rolling_radius = number(row, "rolling_radius_mm") * 1e-3;
        case.approach = number(row, "approach_mm") * 1e-3;
        case.cell = number(row, "dy_mm") * 1e-3;
    };
    let mut cases = read("patches", of_case, |_, _| ());
    let index: HashMap<_, _> =
        cases.iter().enumerate().map(|(i, case)| (case.name.clone(), i)).collect();
    for row in rows("outlines.csv") {
        let half_length = number(&row, "half_length_mm") * 1e-3;
        let load = number(&row, "load_N_per_mm") * 1e3;
        cases[index[&row["case"]]].outline.push(Outline {
            y: number(&row, "y_mm") * 1e-3,
            half_length,
            centre_x: number(&row, "centre_x_mm") * 1e-3,
            peak_pressure: load / (std::f64::consts::FRAC_PI_2 * half_length),
            load,
        });
    }
    cases
}

/// Patches of real wheels on real rails, with yaw.
pub fn real() -> Vec<Case> {
    let of_case = |row: &Row, case: &mut Case| {
        case.rolling_radius = 0.46;
        case.zones = number(row, "zones") as usize;
    };
    read("real", of_case, |row, case| {
        case.centre_x.push(number(row, "xcentre_mm") * 1e-3);
        case.radii.push(number(row, "R_mm") * 1e-3);
    })
}

/// The cases of a table of motions: the first row of each makes it.
fn grouped<T>(
    file: &str, make: impl Fn(&Row) -> T, motions: impl Fn(&mut T) -> (&str, &mut Vec<Motion>),
) -> Vec<T> {
    let mut cases: Vec<T> = Vec::new();
    for row in rows(file) {
        let place = cases.iter_mut().position(|case| motions(case).0 == row["case"]);
        let place = place.unwrap_or_else(|| {
            cases.push(make(&row));
            cases.len() - 1
        });
        motions(&mut cases[place]).1.push(Motion::of(&row));
    }
    cases
}

/// A case of steel on steel whose load and size are told, without its profile.
fn steel(row: &Row, family: &str, friction: &str, size: f64) -> Case {
    Case {
        name: row["case"].clone(),
        family: family.into(),
        load: number(row, "normal_force_N"),
        friction: number(row, friction),
        shear_modulus: 82e9,
        poisson_ratio: 0.28,
        size,
        ..Case::default()
    }
}

/// Such a case whose patch is the strips of an ellipse.
fn elliptic(row: &Row, family: &str, friction: &str, count: StripCount) -> (Case, Full) {
    let (a, b) = (number(row, "a_mm") * 1e-3, number(row, "b_mm") * 1e-3);
    let case = steel(row, family, friction, (a * b).sqrt());
    let Case { load: normal_force, friction, shear_modulus, poisson_ratio, .. } = case;
    let contact =
        Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch: 0.0 };
    (case, Full::from_ellipse(&contact, count).unwrap())
}

/// Patches whose strips are given, some with their centres off `x = 0`; a half-ellipse in `x`.
pub fn given() -> Vec<(Case, Full)> {
    let mut strips: HashMap<String, Vec<PatchStrip<f64>>> = HashMap::new();
    for row in rows("given_strips.csv") {
        let number = |column| number(&row, column);
        strips.entry(row["case"].clone()).or_default().push(PatchStrip {
            y: number("y_mm") * 1e-3,
            width: number("width_mm") * 1e-3,
            half_length: number("half_length_mm") * 1e-3,
            centre_x: number("centre_x_mm") * 1e-3,
            peak_pressure: number("p0_MPa") * 1e6,
            friction: 0.3,
        });
    }
    let make = |row: &Row| {
        let case = steel(row, "given", "mu", number(row, "c_mm") * 1e-3);
        let patch = Full::from_strips(&strips[&row["case"]], 82e9, 0.28).unwrap();
        (Case { area: number(row, "area_mm2") * 1e-6, ..case }, patch)
    };
    grouped("given.csv", make, |(case, _)| (&case.name, &mut case.motions))
}

/// Friction that varies over `y` on an ellipse.
pub fn banded(count: StripCount) -> Vec<(Case, Full)> {
    let make = |row: &Row| {
        let (case, mut patch) = elliptic(row, &row["band"], "mu_ref", count);
        for strip in patch.used_mut() {
            strip.friction = band(&row["band"], strip.y / (number(row, "b_mm") * 1e-3));
        }
        (case, patch)
    };
    grouped("banded.csv", make, |(case, _)| (&case.name, &mut case.motions))
}

/// Friction that falls with the slip, on ellipses of 16 strips: the case, the patch, the law, and
/// its creepages.
pub fn falling() -> Vec<(Case, Full, SlipFriction<f64>)> {
    let make = |row: &Row| {
        let (case, patch) = elliptic(row, "falling", "mu0", StripCount::Sixteen);
        let [ratio, decay, speed] = ["A", "B_s_per_m", "speed_m_per_s"].map(|of| number(row, of));
        let law = prelude::falling(case.friction, ratio, decay, speed, 1.0);
        (case, patch, law)
    };
    grouped("falling.csv", make, |(case, ..)| (&case.name, &mut case.motions))
}

/// Friction at `y/b`.
fn band(name: &str, y: f64) -> f64 {
    let pick = |inside: bool, yes, no| if inside { yes } else { no };
    match name {
        "half" => pick(y > 0.0, 0.1, 0.4),
        "middle" => pick(y.abs() < 1.0 / 3.0, 0.08, 0.4),
        "edge" => pick(y > 0.5, 0.05, 0.4),
        "linear" => 0.25 + 0.15 * y,
        "two" => pick(y.abs() > 0.5, 0.1, 0.35),
        _ => panic!("no such band: {name}"),
    }
}
