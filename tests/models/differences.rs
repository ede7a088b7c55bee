//! Differences of functions that have kinks here and there.

use crate::prelude::*;

/// Central differences with h, h/2, h/4, extrapolated; and how far the last two extrapolations
/// differ: an error of the order h or h² betrays a kink within the stencil.
fn differences(f: &dyn Fn(f64) -> [f64; 3], h: f64) -> ([f64; 3], [f64; 3]) {
    let central = |h: f64| {
        let (ahead, behind) = (f(h), f(-h));
        std::array::from_fn::<f64, 3, _>(|i| (ahead[i] - behind[i]) / (2.0 * h))
    };
    let (d1, d2, d4) = (central(h), central(h / 2.0), central(h / 4.0));
    let (mut result, mut doubt) = ([0.0; 3], [0.0; 3]);
    for i in 0..3 {
        let (r1, r2) = ((4.0 * d2[i] - d1[i]) / 3.0, (4.0 * d4[i] - d2[i]) / 3.0);
        result[i] = (16.0 * r2 - r1) / 15.0;
        doubt[i] = (r2 - r1).abs();
    }
    (result, doubt)
}

/// Differences that converged: over the largest stencil with a doubt below 1e-9 of `size`, else
/// over the one with the smallest doubt, if that is below 1e-8. Rounding is 1e-16/h/4, 1e-11 at the
/// smallest; a breakpoint of a slope inside the stencil makes the doubt a few times smaller than
/// the error.
pub fn trusted_differences(f: &dyn Fn(f64) -> [f64; 3], size: &[f64; 3]) -> Option<[f64; 3]> {
    let mut best = (1e-8, None);
    for h in [1e-3, 1e-4, 1e-5] {
        let (got, doubt) = differences(f, h);
        let doubt = (0..3).map(|i| doubt[i] / size[i]).fold(0.0, f64::max);
        if doubt < best.0 {
            best = (doubt, Some(got));
        }
        if doubt < 1e-9 {
            break;
        }
    }
    best.1
}

/// Derivatives of the forces of patches against differences: columns compared and left out, and the
/// worst error in units of the force divided by the creepage that it takes.
#[derive(Default)]
pub struct Comparison {
    pub compared: usize,
    pub kinks: usize,
    pub worst: f64,
}

impl Comparison {
    /// One patch: `exact` row by row, `unit` its friction bound.
    pub fn add(
        &mut self,
        exact: impl Fn(usize, usize) -> f64,
        motion: &Creepage<f64>,
        unit: f64,
        forces: impl Fn(&Creepage<f64>) -> [f64; 3],
        what: &dyn std::fmt::Debug,
    ) {
        let size = motion.longitudinal.abs() + motion.lateral.abs() + motion.spin.abs() * 4e-3;
        let units = [unit, unit, unit * 4e-3];
        for (column, step) in [size, size, size * 250.0].into_iter().enumerate() {
            let at = |t: f64| {
                let mut inputs = [motion.longitudinal, motion.lateral, motion.spin];
                inputs[column] += t * step;
                let [longitudinal, lateral, spin] = inputs;
                let found = forces(&Creepage { longitudinal, lateral, spin });
                std::array::from_fn(|row| found[row] / units[row])
            };
            let Some(found) = trusted_differences(&at, &[1.0; 3]) else {
                self.kinks += 1;
                continue;
            };
            self.compared += 1;
            for row in 0..3 {
                let error = (exact(row, column) * step / units[row] - found[row]).abs();
                self.worst = self.worst.max(error);
                assert!(error <= 1e-8, "{row} {column}: {error:e} {found:?} {what:?}");
            }
        }
    }
}
