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
fn trusted_differences(f: &dyn Fn(f64) -> [f64; 3], size: &[f64; 3]) -> Option<[f64; 3]> {
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

/// Derivatives of forces against differences: columns compared and left out, and the worst error.
#[derive(Default)]
pub struct Comparison {
    pub compared: usize,
    pub kinks: usize,
    pub worst: f64,
}

impl Comparison {
    /// Forces as a function of what they are differentiated by, from 0; their derivatives, whose
    /// errors are measured against `size`.
    pub fn column(
        &mut self, at: &dyn Fn(f64) -> [f64; 3], exact: [f64; 3], size: [f64; 3], allowed: f64,
        what: &dyn std::fmt::Debug,
    ) {
        let Some(found) = trusted_differences(at, &size) else {
            self.kinks += 1;
            return;
        };
        self.compared += 1;
        for i in 0..3 {
            let error = (found[i] - exact[i]).abs() / size[i];
            self.worst = self.worst.max(error);
            assert!(error < allowed, "row {i}: {error:e} {exact:?} {found:?} {what:?}");
        }
    }

    /// Of so many columns less than one was left out.
    #[track_caller]
    pub fn assert_few_kinks(&self, columns: usize) {
        let Self { compared, kinks, worst } = self;
        println!("{compared} compared, {kinks} left out, worst {worst:e}");
        assert!(kinks * columns < compared + kinks, "{compared} {kinks}");
    }

    /// One patch: `exact` row by row, `unit` its friction bound, in units of the force divided by
    /// the creepage that it takes.
    pub fn patch(
        &mut self, exact: impl Fn(usize, usize) -> f64, motion: &Creepage<f64>, unit: f64,
        forces: impl Fn(&Creepage<f64>) -> [f64; 3], what: &dyn std::fmt::Debug,
    ) {
        let size = motion.longitudinal.abs() + motion.lateral.abs() + motion.spin.abs() * 4e-3;
        let units = [unit, unit, unit * 4e-3];
        for (column, step) in [size, size, size * 250.0].into_iter().enumerate() {
            let at = |t: f64| {
                let mut inputs = [motion.longitudinal, motion.lateral, motion.spin];
                inputs[column] += t * step;
                let [x, y, spin] = inputs;
                let found = forces(&creep(x, y, spin));
                std::array::from_fn(|row| found[row] / units[row])
            };
            let exact = std::array::from_fn(|row| exact(row, column) * step / units[row]);
            self.column(&at, exact, [1.0; 3], 1e-8, &(column, what));
        }
    }
}
