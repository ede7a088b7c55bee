//! The functions that are made for microcontrollers.

use kstrip::forces::Solution;
use kstrip_testing::names::*;
use std::mem::MaybeUninit;

macro_rules! same_as_solve {
    ($float:ident, $functions:ident) => {{
        use kstrip::ffi::$functions::{
            kstrip_solve, kstrip_solve_linear, kstrip_solve_strip, kstrip_solve_strip_1967,
            kstrip_solve_total,
        };
        for (ratio, x, y, s) in [
            (1.0, 0.0, 0.0, 0.0),
            (1.4, 1e-3, -2e-3, 0.3),
            (0.3, 1e-5, 1e-5, 1e-3),
            (3.0, 0.1, 0.2, 1.0),
            (1.0, 1e-3, -8e-3, 3.0),
            (20.0, 1e-3, 1e-3, 0.1),
        ] {
            let numbers = [4e-3 * ratio, 4e-3, 80e3, 82e9, 0.28, 0.3, x, y, s, 0.0];
            let (contact, creepage) = problem::<$float>(numbers);
            let (contact, creepage) = (Some(&contact), Some(&creepage));
            let run = |solve: &dyn Fn(Option<&mut MaybeUninit<Solution<$float>>>) -> i32| {
                let mut result = MaybeUninit::uninit();
                let status = solve(Some(&mut result));
                assert!(status >= 0, "status {status}");
                // SAFETY: written, as the status says.
                (status, unsafe { result.assume_init() })
            };
            let by_options = |model, strips| {
                let options = kstrip_options { model, strips };
                run(&|out| kstrip_solve(contact, creepage, Some(&options), out))
            };
            let own = run(&|out| kstrip_solve_total(contact, creepage, out));
            assert_eq!(own, by_options(KSTRIP_MODEL_TOTAL, 16));
            let own = run(&|out| kstrip_solve_linear(contact, creepage, out));
            assert_eq!(own, by_options(KSTRIP_MODEL_LINEAR, 16));
            for strips in [4, 8, 16, 32, 64] {
                let own = run(&|out| kstrip_solve_strip_1967(contact, creepage, strips, out));
                assert_eq!(own, by_options(KSTRIP_MODEL_STRIP_1967, strips));
                let own = run(&|out| kstrip_solve_strip(contact, creepage, strips, out));
                assert_eq!(own, by_options(KSTRIP_MODEL_STRIP, strips));
            }
            let mut result = MaybeUninit::uninit();
            assert_eq!(kstrip_solve_total(None, creepage, Some(&mut result)), KSTRIP_ERROR_NULL);
            assert_eq!(kstrip_solve_linear(contact, creepage, None), KSTRIP_ERROR_NULL);
            let wrong = kstrip_solve_strip_1967(contact, creepage, 7, Some(&mut result));
            assert_eq!(wrong, KSTRIP_ERROR_STRIP_COUNT);
        }
    }};
}

/// To the bit, with the same statuses.
#[test]
fn functions_per_model_are_those_of_solve() {
    same_as_solve!(f64, double);
    same_as_solve!(f32, single);
}
