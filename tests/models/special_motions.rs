//! Motions without one of their parts: the same answers as beside them, without a jump.

use crate::prelude::*;
use kstrip_testing::single::single;

/// In units of `μ N`, `μ N √(ab)`, and the patch.
fn solve<F: Float>(c: &Contact<F>, m: &Creepage<F>, o: &Options) -> [F; 4] {
    let s = solved(c, m, o);
    let [fx, fy, mz] = normalised(c, &s);
    [fx, fy, mz, s.adhesion]
}

/// Beside each switch, so near that nothing but the path differs: the same numbers to rounding.
#[test]
fn short_paths_join_the_long_one() {
    let mut random = Random::new(92);
    let mut worst = 0.0_f64;
    // Far below rounding, far above underflow: squares are still normal
    let hair = 1e-140;
    for n in 0..6_000 {
        let c = any_contact(&mut random);
        let o = options(Model::ALL[n % 4], StripCount::ALL[n / 4 % 5]);
        let size = random.log_between(1e-3, 5.0);
        let [xi, eta, psi] = [0; 3].map(|_| random.between(-1.0, 1.0));
        let m = theory::creepage(&c, size * xi, size * eta, size.min(0.9) * psi);
        let (on, beside) = match n / 20 % 5 {
            0 => (Creepage { spin: 0.0, ..m }, Creepage { spin: hair, ..m }),
            1 => (Creepage { longitudinal: 0.0, ..m }, Creepage { longitudinal: hair, ..m }),
            2 => (creep(m.longitudinal, 0.0, 0.0), creep(m.longitudinal, hair, -hair)),
            3 => (creep(0.0, 0.0, m.spin), creep(-hair, hair, m.spin)),
            _ => (creep(0.0, 0.0, 0.0), creep(hair, -hair, hair)),
        };
        let [short, long] = [on, beside].map(|m| solve(&c, &m, &o));
        for i in 0..4 {
            let error = (short[i] - long[i]).abs();
            worst = worst.max(error);
            assert!(error < 2e-12, "{i}: {short:?} {long:?} {on:?} {o:?} {c:?}");
        }
    }
    println!("worst {worst:e}");
}

#[test]
fn short_paths_join_in_single_precision() {
    let mut random = Random::new(93);
    for n in 0..2_000 {
        let wide = contact(random.log_between(0.2, 5.0), random.between(0.0, 0.5));
        let c = single(&wide);
        let o = options(Model::ALL[n % 4], StripCount::ALL[n / 4 % 5]);
        let [xi, eta, psi] = [0; 3].map(|_| random.between(-1.5, 1.5));
        let m = theory::creepage(&wide, xi, eta, 0.6 * psi);
        let (x, y, s) = (m.longitudinal as f32, m.lateral as f32, m.spin as f32);
        let at = |x, y, s| solve(&c, &creep(x, y, s), &o);
        let hair = 1e-15;
        for (on, beside) in
            [(at(x, y, 0.0), at(x, y, hair)), (at(0.0, y, s), at(hair * 1e-3, y, s))]
        {
            for i in 0..4 {
                assert!((on[i] - beside[i]).abs() < 2e-6, "{i} {on:?} {beside:?} {o:?} {m:?}");
            }
        }
    }
}
