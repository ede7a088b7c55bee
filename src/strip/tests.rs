use super::*;
use crate::contact::forces::StripCount;
use crate::linear::LinearCoefficients;
use crate::number::dual::Dual;
use approx::assert_abs_diff_eq;
use core::f64::consts::PI;

fn prepared(g: f64, nu: f64) -> PreparedStrips<f64> {
    PreparedStrips::new(g, nu, &LinearCoefficients::at(g, nu), StripCount::Sixteen)
}

fn totals([g, nu, vx, vy, phi]: [f64; 5]) -> [f64; 4] {
    let t = prepared(g, nu).totals([vx, vy, phi]);
    [t.fx, t.fy, t.mz, t.stick]
}

#[test]
fn agrees_with_the_fitting_script() {
    // fit/fit_strip.py --numbers: a/b, ν, vx, vy, φ; fx, fy, mz, stick
    let cases: [([f64; 5], [f64; 4]); 24] = include!("numbers.in");
    for (case, expected) in cases {
        let found = totals(case);
        for (value, expected) in found.iter().zip(&expected) {
            assert!((value - expected).abs() < 1e-12, "{case:?}: {found:?}, {expected:?}");
        }
    }
}
