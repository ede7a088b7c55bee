//! The strip theory written a second time, straight from its equations, for the tests alone.
//!
//! Nothing here calls the library except to build its inputs. Integrals over the strips are
//! adaptive Gauss quadrature in the angle of `Y = sin θ`, cut where the law of the strips changes.

use crate::prelude::*;
use kstrip::forces::FieldStrip;

pub const MODELS: [Model; 2] = [Model::Strip1967, Model::Strip1967Continuous];

pub fn options(model: Model, strips: StripCount) -> Options {
    Options { model, strips }
}

/// A steel contact under 1 GPa with a given axis ratio and Poisson's ratio.
pub fn contact(axis_ratio: f64, poisson_ratio: f64) -> Contact<f64> {
    let mean = 5e-3;
    let (a, b) = (mean * axis_ratio.sqrt(), mean / axis_ratio.sqrt());
    // N = (2/3) π a b p₀
    Contact { a, b, normal_force: 1e9 * 2.0 * PI * a * b / 3.0, poisson_ratio, ..C0 }
}

/// Of any shape and any Poisson's ratio.
pub fn any_contact(random: &mut Random) -> Contact<f64> {
    contact(random.log_between(0.1, 10.0), random.between(0.0, 0.5))
}

/// The strip of a field of the 1967 theory.
pub fn strip_at(field: &Field<f64>, y: f64) -> Option<Strip<f64>> {
    match field.strip_at(y)? {
        FieldStrip::Strip1967(strip) => Some(strip),
        other => panic!("{other:?}"),
    }
}

/// `2 μ p₀/G`, the unit of slip.
pub fn slip_unit(contact: &Contact<f64>) -> f64 {
    let p0 = 3.0 * contact.normal_force / (2.0 * PI * contact.a * contact.b);
    2.0 * contact.friction * p0 / contact.shear_modulus
}

/// The creepage with Kalker's parameters `ξ`, `η`, `ψ`, (5.13) solved for the creepages.
pub fn creepage(contact: &Contact<f64>, xi: f64, eta: f64, psi: f64) -> Creepage<f64> {
    let unit = slip_unit(contact);
    creep(xi * unit * (1.0 - contact.poisson_ratio), eta * unit, psi * unit / contact.a)
}

/// Forces in units of `μ N`, the moment in units of `μ N √(ab)`, and the stick fraction.
pub fn solve(law: &Law) -> [f64; 4] {
    let contact = contact(law.axis_ratio, law.poisson_ratio);
    let motion = creepage(&contact, law.xi, law.eta, law.psi);
    let model = if law.continuous { Model::Strip1967Continuous } else { Model::Strip1967 };
    let s = solved(&contact, &motion, &sixteen(model));
    let [fx, fy, mz] = normalised(&contact, &s);
    let answer = [fx, fy, mz, s.adhesion];
    // Maxima of errors would pass over a NaN
    assert!(answer.iter().all(|v| v.is_finite()), "{law:?}: {answer:?}");
    answer
}

/// Parameters and sliding rule.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law {
    pub xi: f64,
    pub eta: f64,
    pub psi: f64,
    pub poisson_ratio: f64,
    pub axis_ratio: f64,
    /// The sliding rule that joins the adhesion strips; else the direction of the rigid slip.
    pub continuous: bool,
}

/// At rest.
pub const BASE: Law =
    Law { xi: 0.0, eta: 0.0, psi: 0.0, poisson_ratio: 0.28, axis_ratio: 1.0, continuous: false };

impl Law {
    /// `ξ̄ = ξ − ψ (y/a)/(1 − ν)`
    pub fn xi_bar(&self, y: f64) -> f64 {
        self.xi - self.psi * y / (self.axis_ratio * (1.0 - self.poisson_ratio))
    }

    /// `κ` from `ξ̄² + (η + ψκ)² = κ²`, which is `α² + (β + ψ)² = 1` times `κ²`.
    pub fn kappa(&self, y: f64) -> Option<f64> {
        let x = self.xi_bar(y);
        // A κ² + 2 B κ + C = 0
        let (a, b, c) = (
            (1.0 - self.spin()) * (1.0 + self.spin()),
            -self.eta * self.spin(),
            -(x * x + self.eta.powi(2)),
        );
        if a <= 0.0 && b <= 0.0 {
            return None;
        }
        // B² − A C, multiplied out
        let discriminant = self.eta * self.eta + a * x * x;
        if discriminant < 0.0 {
            return None;
        }
        let root = discriminant.sqrt();
        Some(if b > 0.0 { -c / (b + root) } else { (root - b) / a })
    }

    /// `κ` if the strip adheres.
    pub fn adheres(&self, y: f64, c: f64) -> Option<f64> {
        self.kappa(y).filter(|kappa| *kappa < c)
    }

    /// `ψ` as it counts within a strip: ±1 at most.
    fn spin(&self) -> f64 {
        self.psi.clamp(-1.0, 1.0)
    }

    /// Direction of a sliding strip.
    pub fn direction(&self, y: f64, c: f64) -> (f64, f64) {
        let x = self.xi_bar(y);
        let (wx, wy) = if self.continuous {
            (x, self.eta + self.spin() * c)
        } else {
            ((1.0 - self.poisson_ratio) * x, self.eta)
        };
        let length = wx.hypot(wy);
        if length == 0.0 { (0.0, 0.0) } else { (wx / length, wy / length) }
    }

    /// Per unit of angle: `F_x`, `F_y`, `M_z/√(ab)`, stick fraction, power (Section 7).
    fn integrand(&self, theta: f64) -> [f64; 4] {
        let (y, c) = theta.sin_cos();
        let (fx, fy, mx, stick) = match self.adheres(y, c) {
            Some(k) => {
                let reach = 2.0 * c - k;
                (
                    self.xi_bar(y) * reach,
                    self.spin() * c * c + self.eta * reach,
                    -self.eta * (c - k).powi(2),
                    c - k,
                )
            }
            None => {
                let (wx, wy) = self.direction(y, c);
                (c * c * wx, c * c * wy, 0.0, 0.0)
            }
        };
        let ratio = self.axis_ratio.sqrt();
        [
            0.75 * fx * c,
            0.75 * fy * c,
            0.75 * (ratio * mx - y * fx / ratio) * c,
            2.0 / PI * stick * c,
        ]
    }

    /// Angles between which the law of the strips is smooth.
    pub fn pieces(&self) -> Vec<f64> {
        let end = PI / 2.0;
        const SCAN: usize = 600;
        let at = |i: usize| -end + 2.0 * end * i as f64 / SCAN as f64;
        let mut cuts = vec![-end, end];
        cuts.extend((1..24).map(|i| at(i * SCAN / 24)));
        let slope = self.psi / (self.axis_ratio * (1.0 - self.poisson_ratio));
        if self.xi.abs() < slope.abs() {
            // ξ̄ = 0, and points ever nearer to it: directions turn over a distance η
            let turn = (self.xi / slope).asin();
            cuts.push(turn);
            for k in 1..16 {
                for side in [-1.0, 1.0] {
                    cuts.push(turn + side * 10f64.powi(-k));
                }
            }
        }
        let fit = |t: f64| {
            let (y, c) = t.sin_cos();
            self.kappa(y).map_or(10.0, |kappa| (kappa - c).min(10.0))
        };
        // Turning points of it, so that no sign change hides between two samples
        let mut samples: Vec<f64> = (0..=SCAN).map(at).collect();
        for i in 1..SCAN {
            let (l, m, r) = (fit(at(i - 1)), fit(at(i)), fit(at(i + 1)));
            for sign in [1.0, -1.0] {
                if sign * m <= sign * l && sign * m <= sign * r && !(l == m && m == r) {
                    samples.push(golden(|t| sign * fit(t), at(i - 1), at(i + 1)));
                }
            }
        }
        samples.extend(cuts.iter());
        samples.retain(|t| (-end..=end).contains(t));
        samples.sort_by(f64::total_cmp);
        for pair in samples.windows(2) {
            let is_above = |t| fit(t) > 0.0;
            let sign = is_above(pair[0]);
            if sign != is_above(pair[1]) {
                cuts.push(bisect([pair[0], pair[1]], 1e-18, |t| is_above(t) == sign)[0]);
            }
        }
        cuts.retain(|t| (-end..=end).contains(t));
        cuts.sort_by(f64::total_cmp);
        cuts
    }

    /// `F_x`, `F_y` divided by `μ N`, `M_z` over `μ N √(ab)`, stick fraction; and the error left,
    /// as the sum of the differences between the two finest levels.
    pub fn totals(&self) -> ([f64; 4], f64) {
        adaptive(&|t| self.integrand(t), &self.pieces(), 1e-13)
    }
}

/// Least value of a function with one minimum between two points.
fn golden(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..60 {
        let span = (high - low) * 0.618_033_988_749_895;
        if f(high - span) < f(low + span) { high = low + span } else { low = high - span }
    }
    0.5 * (low + high)
}

/// Gauss–Legendre nodes and weights on [-1, 1] by Newton's method.
pub fn gauss(n: usize) -> Vec<(f64, f64)> {
    (0..n)
        .map(|i| {
            let mut x = (PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
            let mut slope = 1.0;
            for _ in 0..100 {
                let (mut p0, mut p1) = (1.0, x);
                for k in 2..=n {
                    let k = k as f64;
                    (p0, p1) = (p1, ((2.0 * k - 1.0) * x * p1 - (k - 1.0) * p0) / k);
                }
                slope = n as f64 * (x * p1 - p0) / (x * x - 1.0);
                x -= p1 / slope;
                if (p1 / slope).abs() < 1e-16 {
                    break;
                }
            }
            (x, 2.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

/// `∫ f` over consecutive pieces, and an estimate of the error left.
pub fn adaptive<const M: usize>(
    f: &dyn Fn(f64) -> [f64; M], cuts: &[f64], tolerance: f64,
) -> ([f64; M], f64) {
    thread_local! { static RULE: Vec<(f64, f64)> = gauss(10); }
    fn panel<const M: usize>(
        f: &dyn Fn(f64) -> [f64; M], rule: &[(f64, f64)], low: f64, high: f64,
    ) -> [f64; M] {
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        let mut sum = [0.0; M];
        for &(x, w) in rule {
            for (s, v) in sum.iter_mut().zip(f(middle + half * x)) {
                *s += w * half * v;
            }
        }
        sum
    }
    RULE.with(|rule| {
        let (mut sum, mut error) = ([0.0; M], 0.0);
        let mut todo: Vec<(f64, f64, [f64; M], u32)> = cuts
            .windows(2)
            .filter(|p| p[1] > p[0])
            .map(|p| (p[0], p[1], panel(f, rule, p[0], p[1]), 0))
            .collect();
        while let Some((low, high, whole, depth)) = todo.pop() {
            let middle = 0.5 * (low + high);
            let (left, right) = (panel(f, rule, low, middle), panel(f, rule, middle, high));
            let difference =
                (0..M).map(|i| (left[i] + right[i] - whole[i]).abs()).fold(0.0, f64::max);
            if difference <= tolerance || depth >= 44 {
                for i in 0..M {
                    sum[i] += left[i] + right[i];
                }
                // The halves are 2²⁰ times better than the whole where the integrand is smooth
                error += if difference <= tolerance { difference * 1e-3 } else { difference };
            } else {
                todo.push((low, middle, left, depth + 1));
                todo.push((middle, high, right, depth + 1));
            }
        }
        (sum, error)
    })
}

/// `∫ f dx` between two points where `f` may have square-root ends: `x` runs like a cosine.
pub fn between(f: impl Fn(f64) -> f64, low: f64, high: f64, nodes: usize) -> f64 {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    gauss(nodes)
        .into_iter()
        .map(|(t, w)| {
            let (sine, cosine) = (0.5 * PI * t).sin_cos();
            f(middle + half * sine) * half * cosine * 0.5 * PI * w
        })
        .sum()
}
