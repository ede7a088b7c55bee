//! What a simulation feels of a model besides its values: slopes against CONTACT's own, ripple,
//! limits, power. Each figure of any method that solves a [`Case`]. Used by
//! `tests/models/accuracy.rs` and by `reports/accuracy.rs`.

use crate::random::Random;
use crate::reference::{Answer, Case, Table};
use crate::toolchain::root;
use kstrip::linear::LinearCoefficients;
use std::f64::consts::PI;

/// A method.
pub type Solve<'a> = &'a dyn Fn(&Case) -> Answer;

/// `1/C11, 1/C22, 1/C23`: the creepage for which linear theory has the force `μ N`.
pub fn linear_steps(axis_ratio: f64, poisson_ratio: f64) -> [f64; 3] {
    let c = LinearCoefficients::at(axis_ratio, poisson_ratio);
    [1.0 / c.c11, 1.0 / c.c22, 1.0 / c.c23]
}

/// `d(fx, fy)/d creepage` along one axis by central differences of this step, in units of the
/// linear slope.
pub fn slope(case: &Case, axis: usize, step: f64, solve: Solve) -> [f64; 2] {
    let unit = linear_steps(case.axis_ratio, case.poisson_ratio)[axis];
    let [low, high] = [-step, step].map(|step| {
        let mut moved = case.clone();
        moved.creepage[axis] += step * unit;
        solve(&moved).force
    });
    std::array::from_fn(|i| (high[i] - low[i]) / (2.0 * step))
}

/// A row of `tests/data/jacobians.csv`.
pub struct SlopeCase {
    pub case: Case,
    /// `d(fx, fy)/d(vx, vy, φ)` in units of the linear derivatives `C11, C22, C23`.
    pub slopes: [[f64; 3]; 2],
}

/// The 70 states whose slopes CONTACT computed.
pub fn slope_cases() -> Vec<SlopeCase> {
    let table = Table::read(root().join("tests/data/jacobians.csv"));
    let row = |row| {
        let at = |column: &str| table.number(row, column);
        let mut case = Case::new(at("a_over_b"), at("nu"), ["vx", "vy", "phi"].map(at));
        (case.force, case.moment, case.stick) = (["fx", "fy"].map(at), at("mz"), f64::NAN);
        let units = linear_steps(case.axis_ratio, case.poisson_ratio);
        let slopes = ["fx", "fy"].map(|force| {
            let of = |axis: usize| at(&format!("{force}_{}", ["vx", "vy", "phi"][axis]));
            std::array::from_fn(|axis| of(axis) * units[axis])
        });
        SlopeCase { case, slopes }
    };
    table.rows().map(row).collect()
}

/// The names of the entries whose errors [`SlopeCase::error`] returns.
pub const ENTRIES: [[&str; 3]; 2] =
    [["∂fx/∂vx", "∂fx/∂vy", "∂fx/∂φ"], ["∂fy/∂vx", "∂fy/∂vy", "∂fy/∂φ"]];

impl SlopeCase {
    /// The worst of the six derivatives of the force: `|slope − slope_ref|` in units of the linear
    /// slope, force, axis, slope.
    pub fn error(&self, solve: Solve) -> (f64, usize, usize, f64) {
        let mut worst = (0.0, 0, 0, 0.0);
        for axis in 0..3 {
            let found = slope(&self.case, axis, 1e-4, solve);
            for (force, found) in found.into_iter().enumerate() {
                let error = (found - self.slopes[force][axis]).abs();
                if error > worst.0 {
                    worst = (error, force, axis, found);
                }
            }
        }
        worst
    }
}

/// Without spin, along random rays (a/b 0.25 to 4) to a linear force of 2.6: the sum of the rises
/// of the slope over the first slope, and by how much the force's size falls after its maximum.
/// (Along the ray it falls where the force turns from the direction of the linear theory into that
/// of the slip.)
pub fn rays(count: usize, solve: Solve) -> (Vec<f64>, f64) {
    const STEPS: usize = 120;
    let mut random = Random::new(12);
    let mut fall = 0.0_f64;
    let rises = (0..count).map(|_| {
        let (g, nu) = (random.log_between(0.25, 4.0), random.between(0.2, 0.4));
        let (turn, [x, y, _]) = (random.between(0.0, PI / 2.0), linear_steps(g, nu));
        let mut most = 0.0_f64;
        let force: Vec<f64> = (0..=STEPS)
            .map(|i| {
                let u = 2.6 * i as f64 / STEPS as f64;
                let at = Case::new(g, nu, [u * turn.cos() * x, u * turn.sin() * y, 0.0]);
                let [fx, fy] = solve(&at).force;
                most = most.max(fx.hypot(fy));
                fall = fall.max(most - fx.hypot(fy));
                fx * turn.cos() + fy * turn.sin()
            })
            .collect();
        let slopes: Vec<f64> = force.windows(2).map(|f| f[1] - f[0]).collect();
        slopes.windows(2).map(|s| (s[1] - s[0]).max(0.0)).sum::<f64>() / slopes[0]
    });
    (rises.collect(), fall)
}

/// What is left of values at equal steps without their best polynomial of degree 11: root of the
/// mean square.
fn high_pass(values: &mut [f64]) -> f64 {
    let last = (values.len() - 1) as f64;
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for _ in 0..12 {
        // x times the one before, made orthogonal to all before; twice, for rounding
        let mut next: Vec<f64> = (0..values.len())
            .map(|i| basis.last().map_or(1.0, |q| q[i] * (2.0 * i as f64 / last - 1.0)))
            .collect();
        for q in basis.iter().chain(&basis) {
            let share: f64 = q.iter().zip(&next).map(|(q, x)| q * x).sum();
            next.iter_mut().zip(q).for_each(|(x, q)| *x -= share * q);
        }
        let size = next.iter().map(|x| x * x).sum::<f64>().sqrt();
        next.iter_mut().for_each(|x| *x /= size);
        let share: f64 = next.iter().zip(values.iter()).map(|(q, v)| q * v).sum();
        values.iter_mut().zip(&next).for_each(|(v, q)| *v -= share * q);
        basis.push(next);
    }
    (values.iter().map(|v| v * v).sum::<f64>() / values.len() as f64).sqrt()
}

/// With spin `ψ` 0.8 to 2 (ν 0.28, a/b 0.4 to 2.5), along sweeps of longitudinal (fx, 0 to 3 in
/// linear force) and of lateral creepage (fy, −3 to 3): ripple of the slope in units of the linear
/// slope, 25 sweeps each. The slope is a central difference of step 0.001.
pub fn ripple(solve: Solve) -> [Vec<f64>; 2] {
    const POINTS: usize = 241;
    [0, 1].map(|axis| {
        let mut found = Vec::new();
        for psi in [0.8, 1.0, 1.3, 1.6, 2.0] {
            for g in [0.4, 0.7, 1.0, 1.6, 2.5_f64] {
                let units = linear_steps(g, 0.28);
                let mut slopes: Vec<f64> = (0..POINTS)
                    .map(|i| {
                        let share = i as f64 / (POINTS - 1) as f64;
                        let u = if axis == 0 { 3.0 * share } else { 6.0 * share - 3.0 };
                        let mut creepage = [0.0, 0.0, 3.0 / PI * psi / g.sqrt()];
                        creepage[axis] = u * units[axis];
                        slope(&Case::new(g, 0.28, creepage), axis, 1e-3, solve)[axis]
                    })
                    .collect();
                found.push(high_pass(&mut slopes));
            }
        }
        found
    })
}

/// `Fx, Fy, Mz` of a patch that slides as a whole, in `μ N` and `μ N √(ab)`: equal areas of a disk,
/// weighted with the pressure.
fn rigid_slip(g: f64, [vx, vy, phi]: [f64; 3]) -> [f64; 3] {
    const RINGS: usize = 60;
    let (a, b) = (g.sqrt(), 1.0 / g.sqrt());
    let (mut sums, mut load) = ([0.0; 3], 0.0);
    for i in 0..RINGS {
        let r = ((i as f64 + 0.5) / RINGS as f64).sqrt();
        let pressure = (1.0 - r * r).sqrt();
        for j in 0..2 * RINGS {
            let turn = PI * (j as f64 + 0.5) / RINGS as f64;
            let (x, y) = (a * r * turn.cos(), b * r * turn.sin());
            let (sx, sy) = (vx - phi * y, vy + phi * x);
            let unit = pressure / sx.hypot(sy).max(1e-300);
            load += pressure;
            sums[0] += unit * sx;
            sums[1] += unit * sy;
            sums[2] += unit * (x * sy - y * sx);
        }
    }
    sums.map(|sum| sum / load)
}

/// Far in sliding, where rigid slip is the truth (100 contacts, a/b 0.05 to 20, any mix of
/// translation and spin): error of the force, error of the moment over the moment of sliding by
/// spin alone.
pub fn limits(solve: Solve) -> [Vec<f64>; 2] {
    let mut random = Random::new(18);
    let (mut forces, mut moments) = (Vec::new(), Vec::new());
    for _ in 0..100 {
        let (g, nu) = (random.log_between(0.05, 20.0), random.between(0.0, 0.5));
        let (turn, share) = (random.between(0.0, 2.0 * PI), random.log_between(0.1, 20.0));
        let v = [share * turn.cos(), share * turn.sin(), 1.0];
        let [fx, fy, mz] = rigid_slip(g, v);
        let [.., most] = rigid_slip(g, [0.0, 0.0, 1.0]);
        let far = if share < 3.0 { 2000.0 } else { 60.0 / share };
        let found = solve(&Case::new(g, nu, v.map(|v| far * v)));
        forces.push((found.force[0] - fx).hypot(found.force[1] - fy));
        moments.push((found.moment - mz).abs() / most);
    }
    [forces, moments]
}

/// Least frictional power over `count` random states (a/b 0.05 to 20, ν 0 to 0.5), in `μ N` times a
/// slip, and the share of states below zero.
pub fn power(count: usize, solve: Solve) -> (f64, f64) {
    let mut random = Random::new(19);
    let (mut least, mut below) = (f64::INFINITY, 0);
    for n in 0..count {
        let (g, nu) = (random.log_between(0.05, 20.0), random.between(0.0, 0.5));
        let size = random.log_between(0.01, 4.0) * [0.0, 1e-3, 0.1, 1.0][n % 4];
        let turn = random.between(0.0, 2.0 * PI);
        let spin = random.sign() * random.log_between(0.01, 6.3) / g.sqrt();
        let v = [size * turn.cos(), size * turn.sin(), spin];
        let Answer { force: [fx, fy], moment, .. } = solve(&Case::new(g, nu, v));
        let slip = size + spin.abs() * g.max(1.0 / g).sqrt();
        let power = (fx * v[0] + fy * v[1] + moment * v[2]) / slip;
        least = least.min(power);
        below += usize::from(power < -1e-9);
    }
    (least, below as f64 / count as f64)
}
