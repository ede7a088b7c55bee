//! The limit: operations that a solve cannot avoid without other formulas, and what they cost at the throughput of
//! this machine.

use crate::clock;
use kstrip::solve::model::Model;
use std::hint::black_box;

/// Numbers of operations, one number at a time.
#[derive(Clone, Copy)]
pub struct Work {
    pub roots: f64,
    pub quotients: f64,
    /// `1/√x`
    pub inverse_roots: f64,
    /// Half the number of multiplications and additions; comparisons count as additions.
    pub multiply_adds: f64,
}

impl Work {
    const fn of(roots: f64, quotients: f64, inverse_roots: f64, multiply_adds: f64) -> Self {
        Self { roots, quotients, inverse_roots, multiply_adds }
    }

    fn plus(self, other: Self, times: f64) -> Self {
        Self {
            roots: self.roots + times * other.roots,
            quotients: self.quotients + times * other.quotients,
            inverse_roots: self.inverse_roots + times * other.inverse_roots,
            multiply_adds: self.multiply_adds + times * other.multiply_adds,
        }
    }
}

/// `C11, C22, C23, C33` (`coefficients.rs`): √(1 + g²) and √g; 1/(1 + g), 1/(1 + g²) and four quotients; six
/// polynomials of three or four pairs, one logarithm (a quotient, ten multiply-adds) and the slender limits.
const COEFFICIENTS: Work = Work::of(2.0, 7.0, 0.0, 85.0);
/// `ξ, η, ψ` in and newtons out (`creepage.rs`, `model.rs`): √a √b; G/(2 μ p₀), 1/(1 − ν), a/b and the scale back;
/// checks of nine inputs and of the range.
const FRAME: Work = Work::of(2.0, 5.0, 0.0, 35.0);

/// Theory of 1967, per contact: both ends of the adhesion interval by three tangent steps (two roots and a quotient
/// each, `leading_edge.rs`), 1/(1 − ψ²), two roots and three quotients of the arc, one root and two quotients of
/// the sliding panels, two of the scales, the arc tangent, and the bound on the sum.
const ENDS: Work = Work::of(17.0, 15.0, 0.0, 190.0);
/// A sliding strip: its direction, 1/√(x² + y²), a root and a quotient (`panels.rs`).
const SLIDING: Work = Work::of(1.0, 1.0, 0.0, 16.5);
/// A strip with adhesion: the root S of (5.41), and half a quotient of the arc, which serves two strips.
const ADHESION: Work = Work::of(1.0, 0.5, 0.0, 19.5);

/// Strips that follow the slip, per contact (`rolling_strip.rs`): 13 features, a network of 13, 20 and 8 numbers
/// (420 multiply-adds, 20 inverse roots), five numbers of the patch.
const ROLLING: Work = Work::of(13.0, 16.0, 20.0, 560.0);
/// Per strip and step: p and |p|²/B² (5.5), the cut (3 and an inverse root), the tractions (6.5), the share in
/// adhesion (3 and a quotient).
const STEP: Work = Work::of(0.0, 1.0, 1.0, 18.0);
/// Per strip: what it sees of the creepages, and its place in the sums.
const STRIP: Work = Work::of(0.0, 0.0, 0.0, 12.0);
const STEPS: f64 = 7.0;

/// Total forces (`total.rs`): a network of 18, 22, 14 and 6 numbers (788 multiply-adds; 36 units of three, a quotient
/// for two of them), 20 quotients of the features and the last formulas, six roots.
const TOTAL: Work = Work::of(6.0, 40.0, 0.0, 1005.0);
/// Linear theory: three sums.
const LINEAR: Work = Work::of(1.0, 1.0, 0.0, 12.0);

/// What a solve cannot avoid.
pub fn work(model: Model, strips: i32) -> Work {
    let strips = f64::from(strips);
    match model {
        Model::Strip1967 | Model::Strip1967Continuous => {
            // ten of sixteen strips slide, six have adhesion; half of them have it with 32 and 64
            let slide = if strips > 16.0 { 0.5 } else { 0.625 } * strips;
            let plain = FRAME.plus(ENDS, 1.0).plus(ADHESION, strips - slide).plus(SLIDING, slide);
            // the continuous rule needs C, another root
            let root = if model == Model::Strip1967Continuous { slide } else { 0.0 };
            plain.plus(Work::of(1.0, 0.0, 0.0, 1.0), root)
        }
        Model::Strip => FRAME
            .plus(COEFFICIENTS, 1.0)
            .plus(ROLLING, 1.0)
            .plus(STRIP, strips)
            .plus(STEP, STEPS * strips),
        Model::Total => FRAME.plus(COEFFICIENTS, 1.0).plus(TOTAL, 1.0),
        _ => FRAME.plus(COEFFICIENTS, 1.0).plus(LINEAR, 1.0),
    }
}

/// Nanoseconds per number when nothing else is done.
pub struct Throughput {
    pub root: f64,
    pub quotient: f64,
    pub inverse_root: f64,
    pub multiply_add: f64,
}

impl Throughput {
    /// Roots and quotients share one unit, which works beside those that multiply and add: what each side takes.
    pub fn sides(&self, work: &Work) -> [f64; 2] {
        let divider = work.roots * self.root
            + work.quotients * self.quotient
            + work.inverse_roots * self.inverse_root;
        [divider, work.multiply_adds * self.multiply_add]
    }

    pub fn limit(&self, work: &Work) -> f64 {
        let [divider, sums] = self.sides(work);
        divider.max(sums)
    }
}

const NUMBERS: usize = 256;
const REPETITIONS: usize = 40;
const ROUNDS: usize = 2000;

/// The quickest of many short rounds, so that other programs do not count.
fn least(mut round: impl FnMut(), numbers: usize) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..ROUNDS {
        least = least.min(clock::took(&mut round) / numbers as f64);
    }
    least
}

/// Loops that the compiler turns into the vectors of the target: two doubles or four floats with SSE2.
macro_rules! measured {
    ($name:ident, $float:ty, $chains:literal) => {
        pub fn $name() -> Throughput {
            let mut x: [$float; NUMBERS] =
                std::array::from_fn(|i| 1.0 + (i as $float * 0.618_034).fract());
            let mut y = [0.0; NUMBERS];
            let mut each = |of: fn(&[$float; NUMBERS], &mut [$float; NUMBERS])| {
                let round = || {
                    for _ in 0..REPETITIONS {
                        of(black_box(&mut x), black_box(&mut y));
                    }
                };
                least(round, NUMBERS * REPETITIONS)
            };
            let root = each(|x, y| {
                for (y, x) in y.iter_mut().zip(x) {
                    *y = x.sqrt();
                }
            });
            let quotient = each(|x, y| {
                for (y, x) in y.iter_mut().zip(x) {
                    *y = 1.0 / x;
                }
            });
            // independent chains that stay in registers
            let mut chains: [$float; $chains] = std::array::from_fn(|i| i as $float);
            let multiply_add = least(
                || {
                    let (factor, term) = (black_box(0.999), black_box(0.001));
                    let mut sums = *black_box(&mut chains);
                    for _ in 0..1000 {
                        for sum in &mut sums {
                            *sum = *sum * factor + term;
                        }
                    }
                    chains = black_box(sums);
                },
                1000 * $chains,
            );
            Throughput { root, quotient, inverse_root: root + quotient, multiply_add }
        }
    };
}

measured!(single, f32, 56);
measured!(double_plain, f64, 28);

/// Double precision takes an inverse root from single precision, improved by one step of Newton's.
pub fn double(single: &Throughput) -> Throughput {
    let plain = double_plain();
    Throughput { inverse_root: single.root + single.quotient, ..plain }
}
