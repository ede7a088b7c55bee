//! What is let through without a look passes every check.

use kstrip::internals::quick_and_full_check;
use kstrip_testing::prelude::*;

/// No check can fail for the sizes that are let through without: at every corner of them, in both
/// precisions.
#[test]
fn usual_sizes_pass_every_check() {
    fn corners<F: Float>() -> usize {
        let ends = [
            [1e-6, 1.0],
            [1e-6, 1.0],
            [0.0, 1e9],
            [1.0, 1.5e11],
            [0.0, 0.5],
            [0.0, 5.0],
            [-10.0, 10.0],
            [-10.0, 10.0],
            [-1e4, 1e4],
        ];
        let mut usual = 0;
        for corner in 0..1 << ends.len() {
            let mut k = 0;
            let numbers = ends.map(|ends: [f64; 2]| {
                k += 1;
                F::of(ends[(corner >> (k - 1)) & 1])
            });
            let [a, b, normal_force, shear_modulus, poisson_ratio, friction, x, y, spin] = numbers;
            let mismatch = F::zero();
            let contact =
                Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch };
            let creepage = creep(x, y, spin);
            for model in Model::ALL {
                let (passes, found) = quick_and_full_check(&contact, &creepage, model);
                assert!(passes && found.is_ok(), "{model:?} {contact:?} {creepage:?}");
                usual += 1;
            }
        }
        usual
    }
    assert_eq!((corners::<f64>(), corners::<f32>()), (512 * 5, 512 * 5));
}
