//! A creep curve: force and derivative against creepage, by the default model, by strips and by
//! linear theory.
//!
//!     cargo run --example creep_curve

use kstrip::contact::creepage::Creepage;
use kstrip::contact::hertz::{self, Radii};
use kstrip::contact::{Contact, material};
use kstrip::forces::derivatives;
use kstrip::forces::options::{Model, Options};
use kstrip::status::Error;

/// A steel wheel of 0.46 m radius on a rail head of 0.30 m, under 80 kN.
fn wheel_on_rail() -> Result<Contact<f64>, Error> {
    let steel = material::Material { shear_modulus: 82e9, poisson_ratio: 0.28 };
    let pair = material::combine(&steel, &steel)?;
    let radii =
        Radii { lower_x: f64::INFINITY, lower_y: 0.30, upper_x: 0.46, upper_y: f64::INFINITY };
    let ellipse = hertz::hertz(&radii, 80e3, pair.shear_modulus, pair.poisson_ratio)?;
    Ok(Contact {
        a: ellipse.a,
        b: ellipse.b,
        normal_force: 80e3,
        shear_modulus: pair.shear_modulus,
        poisson_ratio: pair.poisson_ratio,
        friction: 0.3,
        mismatch: 0.0,
    })
}

/// Longitudinal force [N] and its slope [N over a creepage of 1].
fn force(contact: &Contact<f64>, longitudinal: f64, model: Model) -> Result<[f64; 2], Error> {
    let creepage = Creepage { longitudinal, lateral: 0.0, spin: 0.1 };
    let options = Options { model, ..Options::default() };
    let (forces, slopes) = derivatives::forces_and_derivatives(contact, &creepage, &options)?;
    Ok([forces.fx, slopes.jacobian[0][0]])
}

fn main() -> Result<(), Error> {
    let contact = wheel_on_rail()?;
    println!("creepage     TOTAL [kN]  slope [MN]   STRIP [kN]  slope [MN]  LINEAR [kN]");
    for step in 0..=10 {
        let longitudinal = 5e-4 * f64::from(step);
        let [total, total_slope] = force(&contact, longitudinal, Model::Total)?;
        let [strip, strip_slope] = force(&contact, longitudinal, Model::Strip)?;
        let [linear, _] = force(&contact, longitudinal, Model::Linear)?;
        println!(
            "{longitudinal:.4} {:14.2} {:11.2} {:12.2} {:11.2} {:12.2}",
            total / 1e3,
            total_slope / 1e6,
            strip / 1e3,
            strip_slope / 1e6,
            linear / 1e3
        );
    }
    Ok(())
}

/// The curve rises from zero to the friction bound, and its slopes are those of its values.
#[test]
fn creep_curve_saturates() -> Result<(), Error> {
    let contact = wheel_on_rail()?;
    let bound = contact.friction * contact.normal_force;
    for model in [Model::Total, Model::Strip] {
        let mut last = -f64::EPSILON;
        for step in 0..=50 {
            let longitudinal = 2e-4 * f64::from(step);
            let [fx, slope] = force(&contact, longitudinal, model)?;
            assert!(fx > last && fx <= bound, "{model:?} {longitudinal} {fx}");
            let [above, _] = force(&contact, longitudinal + 1e-8, model)?;
            let [below, _] = force(&contact, longitudinal - 1e-8, model)?;
            let difference = (above - below) / 2e-8;
            assert!((slope - difference).abs() < 1e-4 * slope.abs() + 1e3, "{slope} {difference}");
            last = fx;
        }
        assert!(last > 0.97 * bound, "{last} of {bound}");
    }
    Ok(())
}
