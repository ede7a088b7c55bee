//! What a vehicle feels of the slopes: the critical speed of the wheelset of
//! `c_examples/05_hunting.c`.

use crate::prelude::*;
use nalgebra::{Matrix3x4, Matrix4};

const MASS: f64 = 1800.0;
const INERTIA: f64 = 1100.0;
const LATERAL_SPRING: f64 = 400e3;
const YAW_SPRING: f64 = 3e6;
const RADIUS: f64 = 0.46;
const HALF_GAUGE: f64 = 0.75;
const CONTACT: Contact<f64> = Contact { friction: 0.2, ..C0 };

/// `d rate/d state` of the straight run; the state is place, yaw, and their rates.
fn linearised(model: Model, conicity: f64, speed: f64) -> Matrix4<f64> {
    let options = sixteen(model);
    let mut rates = Matrix4::zeros();
    rates[(0, 2)] = 1.0;
    rates[(1, 3)] = 1.0;
    rates[(2, 0)] = -LATERAL_SPRING / MASS;
    rates[(3, 1)] = -YAW_SPRING / INERTIA;
    for side in [-1.0, 1.0] {
        let (arm, cone) = (side * HALF_GAUGE, side * conicity / RADIUS);
        let straight = creep(0.0, 0.0, -cone);
        let (_, jacobian) = solve_jacobian(&CONTACT, &straight, &options).expect("forces");
        let jacobian: Matrix3<f64> = jacobian;
        #[rustfmt::skip]
        let creepage_by_state = Matrix3x4::new(
            -cone, 0.0, 0.0, -arm / speed,
            0.0, -1.0, 1.0 / speed, 0.0,
            0.0, 0.0, 0.0, 1.0 / speed,
        );
        let force_by_state = jacobian * creepage_by_state;
        for k in 0..4 {
            let [fx, fy, mz] = [0, 1, 2].map(|i| force_by_state[(i, k)]);
            rates[(2, k)] -= fy / MASS;
            rates[(3, k)] += (arm * fx - mz) / INERTIA;
        }
    }
    rates
}

/// Hurwitz: whether every eigenvalue has a negative real part.
fn is_stable(a: &Matrix4<f64>) -> bool {
    // characteristic polynomial by Faddeev and LeVerrier
    let mut c = [0.0; 4];
    let mut m = Matrix4::identity();
    for (k, c) in c.iter_mut().enumerate() {
        let product = a * m;
        *c = -product.trace() / (k as f64 + 1.0);
        m = product + Matrix4::identity() * *c;
    }
    let [c1, c2, c3, c4] = c;
    c1 > 0.0 && c3 > 0.0 && c4 > 0.0 && c1 * c2 * c3 > c3 * c3 + c1 * c1 * c4
}

fn critical_speed(model: Model, conicity: f64) -> f64 {
    bisect([5.0, 400.0], 1e-4, |speed| is_stable(&linearised(model, conicity, speed)))[0]
}

/// More conicity, less critical speed: a ripple of the slopes would turn that round.
#[test]
fn critical_speed_falls_with_conicity() {
    for model in [Model::Strip, Model::Total] {
        let speeds: Vec<f64> =
            (6..=60).map(|k| critical_speed(model, 0.005 * f64::from(k))).collect();
        println!("{model:?} {speeds:.1?}");
        for pair in speeds.windows(2) {
            assert!(pair[1] < pair[0], "{model:?} {speeds:.2?}");
        }
        assert!((20.0..200.0).contains(&speeds[14]), "{model:?} {}", speeds[14]);
    }
}
