//! TOTAL saturates once.

use crate::prelude::*;

/// Without spin the force neither falls once it has reached `μ N`, nor does its slope rise again on
/// the way there.
#[test]
fn translation_saturates_once() {
    let mut random = Random::new(19);
    let (mut fall, mut rises) = (0.0_f64, 0.0_f64);
    for _ in 0..1_000 {
        let (g, nu) = (random.log_between(0.05, 20.0), random.between(0.0, 0.5));
        let turn = random.between(0.0, PI / 2.0);
        let linear = LinearCoefficients::at(g, nu);
        let contact = Total::new(g, nu, &linear);
        let size = |u: f64| {
            let v = [u * turn.cos() / linear.c11, u * turn.sin() / linear.c22, 0.0];
            let Totals { fx, fy, .. } = contact.mean_totals(v);
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
