//! TOTAL at its limits: slopes against CONTACT, rigid slip, saturation, and what a prepared contact answers.

use crate::random::Random;
use crate::reference::{self, figures};

use kstrip::contact::forces::Totals;
use kstrip::linear::LinearCoefficients;
use kstrip::solve::model::{self, Model, Options};
use kstrip::total::Total;
use std::f64::consts::PI;

fn prepared(g: f64, nu: f64) -> (Total<f64>, LinearCoefficients<f64>) {
    let linear = LinearCoefficients::at(g, nu);
    (Total::new(g, nu, &linear), linear)
}

/// The worst entry of each Jacobian of the force, in units of the linear slopes, against CONTACT's own differences: mean, 95th
/// percentile.
#[test]
fn slopes_are_those_of_the_reference() {
    let text = include_str!("../data/jacobians.csv");
    let mut worst = Vec::new();
    for line in text.lines().skip(1) {
        let row: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
        let (contact, LinearCoefficients { c11, c22, c23, .. }) = prepared(row[0], row[1]);
        let mut entries = Vec::new();
        for (axis, c) in [c11, c22, c23].into_iter().enumerate() {
            let h = 1e-4 / c;
            let at = |h: f64| {
                let mut v = [row[2], row[3], row[4]];
                v[axis] += h;
                contact.totals(v)
            };
            let (high, low) = (at(h), at(-h));
            for (i, slope) in [high.fx - low.fx, high.fy - low.fy].into_iter().enumerate() {
                entries.push((slope / (2.0 * h) - row[8 + 3 * i + axis]).abs() / c);
            }
        }
        worst.push(entries.into_iter().fold(0.0, f64::max));
    }
    let found = figures(&worst);
    println!("{} cases: {:.4} / {:.4} / {:.4}", worst.len(), found.mean, found.p95, found.max);
    assert!(worst.len() == 70 && found.mean <= 0.031 && found.p95 <= 0.080);
}

/// `Fx, Fy, Mz` of a patch that slides as a whole: equal areas of a disk, weighted with the pressure.
fn rigid_slip(g: f64, [vx, vy, phi]: [f64; 3]) -> [f64; 3] {
    const RINGS: usize = 120;
    let (a, b) = (g.sqrt(), 1.0 / g.sqrt());
    let mut sums = [0.0; 3];
    let mut load = 0.0;
    for i in 0..RINGS {
        let r = ((i as f64 + 0.5) / RINGS as f64).sqrt();
        let p = (1.0 - r * r).sqrt();
        for j in 0..2 * RINGS {
            let t = PI * (j as f64 + 0.5) / RINGS as f64;
            let (x, y) = (a * r * t.cos(), b * r * t.sin());
            let (sx, sy) = (vx - phi * y, vy + phi * x);
            let s = sx.hypot(sy).max(1e-300);
            let (tx, ty) = (p * sx / s, p * sy / s);
            load += p;
            sums[0] += tx;
            sums[1] += ty;
            sums[2] += x * ty - y * tx;
        }
    }
    sums.map(|sum| sum / load)
}

/// Far in sliding, for any ratio of spin to translation, force and moment are those of rigid slip: a/b .05 to 20.
#[test]
fn rigid_slip_is_the_limit() {
    let mut random = Random::new(18);
    let (mut forces, mut moments) = (Vec::new(), Vec::new());
    for _ in 0..100 {
        let g = random.log_between(0.05, 20.0);
        let (turn, share) = (random.between(0.0, 2.0 * PI), random.log_between(0.1, 20.0));
        let v = [share * turn.cos(), share * turn.sin(), 1.0];
        let [fx, fy, mz] = rigid_slip(g, v);
        let [.., most] = rigid_slip(g, [0.0, 0.0, 1.0]);
        let far = if share < 3.0 { 2000.0 } else { 60.0 / share };
        let found = prepared(g, random.between(0.0, 0.5)).0.totals(v.map(|v| far * v));
        forces.push((found.fx - fx).hypot(found.fy - fy));
        moments.push((found.mz - mz).abs() / most);
    }
    for (name, errors, p95) in [("force", forces, 0.03), ("moment", moments, 0.022)] {
        let found = figures(&errors);
        println!("{name}: {:.4} / {:.4} / {:.4}", found.mean, found.p95, found.max);
        assert!(found.p95 <= p95 && found.max <= 0.07, "{name}");
    }
}

/// Without spin the force neither falls once it has reached `μ N`, nor does its slope rise again on the way there.
#[test]
fn translation_saturates_once() {
    let mut random = Random::new(19);
    let (mut fall, mut rises) = (0.0_f64, 0.0_f64);
    for _ in 0..1_000 {
        let (g, nu) = (random.log_between(0.05, 20.0), random.between(0.0, 0.5));
        let turn = random.between(0.0, PI / 2.0);
        let (contact, linear) = prepared(g, nu);
        let size = |u: f64| {
            let v = [u * turn.cos() / linear.c11, u * turn.sin() / linear.c22, 0.0];
            let Totals { fx, fy, .. } = contact.totals(v);
            fx.hypot(fy)
        };
        let steps: Vec<f64> = (0..=400).map(|i| size(0.05 * f64::from(i))).collect();
        let mut most = 0.0_f64;
        for force in &steps {
            most = most.max(*force);
            fall = fall.max(most - force);
        }
        if (0.25..4.0).contains(&g) {
            let slopes: Vec<f64> = steps[..52].windows(2).map(|w| w[1] - w[0]).collect();
            let rise: f64 = slopes.windows(2).map(|w| (w[1] - w[0]).max(0.0)).sum();
            rises = rises.max(rise / slopes[0]);
        }
    }
    println!("fall {fall:.1e}, rises of the slope {rises:.1e} of the first");
    assert!(fall <= 1e-4 && rises <= 1e-3);
}

/// A prepared contact has the bits of the call that prepares for itself.
#[test]
fn prepared_contacts_have_the_same_bits() {
    let options = Options { model: Model::Total, ..Options::default() };
    let mut random = Random::new(20);
    for _ in 0..1_000 {
        let (g, nu) = (random.log_between(0.05, 20.0), random.between(0.0, 0.5));
        let contact = reference::contact::<f64>(g, nu);
        let motion = kstrip::contact::creepage::Creepage {
            longitudinal: random.between(-0.01, 0.01),
            lateral: random.between(-0.01, 0.01),
            spin: random.between(-1.0, 1.0),
        };
        let solved = model::solve(&contact, &motion, &options).unwrap();
        let parameters = kstrip::contact::creepage::Parameters::new(&contact, &motion);
        let found = prepared(parameters.axis_ratio, nu).0.totals(parameters.normalised());
        let bound = contact.friction * contact.normal_force;
        assert_eq!([solved.fx, solved.fy], [found.fx * bound, found.fy * bound]);
    }
}
