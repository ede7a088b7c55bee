//! Patches of no particular shape.
#![allow(dead_code)]

use super::random::Random;
use kstrip::contact::creepage::Creepage;
use kstrip::patch::{Patch, PatchStrip};

pub type Full = Patch<f64, 64>;

/// An irregular patch: one to three lobes, random lengths, pressures, frictions, centres.
pub fn irregular(random: &mut Random) -> Full {
    let mut strips = Vec::new();
    let mut y = random.between(-8e-3, 0.0);
    for _ in 0..1 + random.bits() % 3 {
        for _ in 0..2 + random.bits() % 12 {
            let width = random.between(0.2e-3, 0.8e-3);
            strips.push(PatchStrip {
                y: y + width / 2.0,
                width,
                half_length: random.between(2e-3, 7e-3),
                centre_x: random.between(-1e-3, 1e-3),
                peak_pressure: random.between(0.2e9, 1.5e9),
                friction: random.between(0.05, 0.5),
            });
            y += width;
        }
        y += random.between(1e-3, 4e-3);
    }
    Full::from_strips(&strips, 82e9, 0.28).unwrap()
}

/// From adhesion to sliding.
pub fn motion(random: &mut Random) -> Creepage<f64> {
    let size = random.log_between(1e-5, 1e-1);
    Creepage {
        longitudinal: size * random.between(-1.0, 1.0),
        lateral: size * random.between(-1.0, 1.0),
        spin: size * random.between(-300.0, 300.0),
    }
}

/// Derivatives of forces against extrapolated differences of the forces. A kink within the stencil shows itself by
/// differences that do not agree; it is left out and counted.
#[derive(Default)]
pub struct Comparison {
    pub compared: usize,
    pub kinks: usize,
    /// In units of the force over the creepage it takes.
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
        for column in 0..3 {
            let at = |step: f64| {
                let mut inputs = [motion.longitudinal, motion.lateral, motion.spin];
                inputs[column] += step;
                let [longitudinal, lateral, spin] = inputs;
                forces(&Creepage { longitudinal, lateral, spin })
            };
            let difference = |h: f64| {
                let [a, b, c, d] = [at(h), at(-h), at(h / 2.0), at(-h / 2.0)];
                std::array::from_fn::<f64, 3, _>(|i| {
                    (8.0 * (c[i] - d[i]) - (a[i] - b[i])) / (6.0 * h)
                })
            };
            let step = size * [1.0, 1.0, 250.0][column];
            let (coarse, fine) = (difference(step * 2e-3), difference(step * 1e-3));
            for row in 0..3 {
                // scale of the row: the force over the creepage it takes
                let scale = unit * [1.0, 1.0, 4e-3][row] / step;
                if (coarse[row] - fine[row]).abs() > 1e-9 * scale {
                    self.kinks += 1;
                    continue;
                }
                self.compared += 1;
                let error = (exact(row, column) - fine[row]).abs() / scale;
                self.worst = self.worst.max(error);
                assert!(
                    error <= 1e-7,
                    "{row} {column}: {} {fine:?} {scale} {what:?}",
                    exact(row, column)
                );
            }
        }
    }
}
