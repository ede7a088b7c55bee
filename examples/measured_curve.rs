//! From measured points to a law of friction: a locomotive's creep curve on a wet rail. Prints the
//! fitted parameters with their standard errors, and the curves as columns: clean bodies, the
//! fitted law, and what CONTACT computes with an elastic layer and falling friction.
//!
//!     cargo run --example measured_curve
//!
//! The points: Engel, Beck, Alders 1998, as CONTACT's user guide shows them; CONTACT's curve: its
//! example tractcurv (tests/data/README.md).

use kstrip::contact::Contact;
use kstrip::contact::creepage::Creepage;
use kstrip::forces::options::{Model, Options};
use kstrip::friction::{self, SlipFriction};
use kstrip::rig::fit::{FrictionFit, MeasuredForce, fit_friction};
use kstrip::status::Error;
use std::path::Path;

const CONTACT: Contact<f64> = Contact {
    a: 6.304e-3,
    b: 12.61e-3,
    normal_force: 106.7e3,
    shear_modulus: 82e9,
    poisson_ratio: 0.28,
    friction: 0.33,
    mismatch: 0.0,
};

/// Rows of numbers of a file of `tests/data`.
fn rows(name: &str) -> Result<Vec<csv::StringRecord>, csv::Error> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name);
    csv::Reader::from_path(path)?.into_records().collect()
}

fn number(row: &csv::StringRecord, column: usize) -> f64 {
    row.get(column).and_then(|text| text.parse().ok()).unwrap_or(f64::NAN)
}

/// Creepage in per cent and force divided by load.
fn measured() -> Result<Vec<MeasuredForce<f64>>, csv::Error> {
    let point = |row: &csv::StringRecord| MeasuredForce {
        longitudinal: number(row, 0) / 100.0,
        lateral: 0.0,
        spin: 0.0,
        fx: number(row, 1) * CONTACT.normal_force,
        fy: 0.0,
        weight: 1.0,
        measured: 1,
        reserved: 0,
    };
    Ok(rows("eurosprinter_measured.csv")?.iter().map(point).collect())
}

fn model() -> Options {
    Options { model: Model::Total, ..Options::default() }
}

/// Force divided by load.
fn force(longitudinal: f64, law: &SlipFriction<f64>) -> Result<f64, Error> {
    let creepage = Creepage { longitudinal, lateral: 0.0, spin: 0.0 };
    let found = friction::solve_with_law(&CONTACT, &creepage, law, &model())?;
    Ok(found.solution.fx / CONTACT.normal_force)
}

/// All but the layer, which is nearly the same as a slope factor. Zero means a usual start; only
/// the rolling speed stays.
fn fit(points: &[MeasuredForce<f64>]) -> Result<FrictionFit<f64>, (usize, Error)> {
    let start = SlipFriction { ratio: 0.0, rolling_speed: 10.0, ..SlipFriction::of_constant(0.0) };
    fit_friction(&CONTACT, points, &start, [true, true, true, true, true, false], &model())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let points = measured()?;
    let found = fit(&points).map_err(|(i, error)| format!("point {i}: {error}"))?;
    let (law, error) = (found.law, found.standard_errors);
    println!("{} points, {} steps, {:?}", points.len(), found.steps, found.warning);
    for (name, value, error) in [
        ("friction", law.friction, error.friction),
        ("ratio", law.ratio, error.ratio),
        ("decay [s/m]", law.decay, error.decay),
        ("slope factor", law.slope_factor, error.slope_factor),
        ("slide factor", law.slide_factor, error.slide_factor),
    ] {
        println!("{name:13} {value:.4} +- {error:.4}");
    }
    println!("rms           {:.5} of the load", found.residual / CONTACT.normal_force);
    println!("\ncreepage_percent, clean, fitted, contact");
    let clean = SlipFriction::of_constant(CONTACT.friction);
    for row in rows("traction_curves.csv")? {
        if row.get(0) == Some("contact_layer_falling") {
            let (creepage, contact) = (number(&row, 1), number(&row, 2) / CONTACT.normal_force);
            let [clean, fitted] = [force(creepage, &clean)?, force(creepage, &law)?];
            println!("{:.4},{clean:.5},{fitted:.5},{contact:.5}", 100.0 * creepage);
        }
    }
    Ok(())
}

/// The fitted law is nearer to the points than extended CONTACT (0.0262 of the load) and modified
/// FASTSIM (0.0259) are.
#[test]
fn measured_points_are_met() {
    let points = measured().expect("the file");
    assert_eq!(points.len(), 89);
    let found = fit(&points).expect("a law");
    assert!(found.residual < 0.0243 * CONTACT.normal_force, "{found:?}");
    let squares = points.iter().map(|point| {
        let computed = force(point.longitudinal, &found.law).expect("a force");
        (computed - point.fx / CONTACT.normal_force).powi(2)
    });
    let rms = (squares.sum::<f64>() / 89.0).sqrt();
    assert!((rms * CONTACT.normal_force / found.residual - 1.0).abs() < 1e-9, "{rms}");
}
