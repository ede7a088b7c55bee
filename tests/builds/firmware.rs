//! The functions that are made for microcontrollers.

use crate::names::*;
use std::mem::MaybeUninit;

macro_rules! same_as_solve {
    ($solve:ident, $contact:ident, $creepage:ident, $result:ident,
     $total:ident, $linear:ident, $strip_1967:ident, $strip:ident) => {{
        for (ratio, x, y, s) in [
            (1.0, 0.0, 0.0, 0.0),
            (1.4, 1e-3, -2e-3, 0.3),
            (0.3, 1e-5, 1e-5, 1e-3),
            (3.0, 0.1, 0.2, 1.0),
            (1.0, 1e-3, -8e-3, 3.0),
            (20.0, 1e-3, 1e-3, 0.1),
        ] {
            let contact = $contact {
                a: 4e-3 * ratio,
                b: 4e-3,
                normal_force: 80e3,
                shear_modulus: 82e9,
                poisson_ratio: 0.28,
                friction: 0.3,
                mismatch: 0.0,
            };
            let creepage = $creepage { longitudinal: x, lateral: y, spin: s };
            let (contact, creepage) = (Some(&contact), Some(&creepage));
            let run = |solve: &dyn Fn(Option<&mut MaybeUninit<$result>>) -> i32| {
                let mut result = MaybeUninit::uninit();
                let status = solve(Some(&mut result));
                assert!(status >= 0, "status {status}");
                // SAFETY: written, as the status says.
                (status, unsafe { result.assume_init() })
            };
            let by_options = |model, strips| {
                let options = kstrip_options { model, strips };
                run(&|out| $solve(contact, creepage, Some(&options), out))
            };
            assert_eq!(
                run(&|out| $total(contact, creepage, out)),
                by_options(KSTRIP_MODEL_TOTAL, 16)
            );
            assert_eq!(
                run(&|out| $linear(contact, creepage, out)),
                by_options(KSTRIP_MODEL_LINEAR, 16)
            );
            for strips in [4, 8, 16, 32, 64] {
                assert_eq!(
                    run(&|out| $strip_1967(contact, creepage, strips, out)),
                    by_options(KSTRIP_MODEL_STRIP_1967, strips)
                );
                assert_eq!(
                    run(&|out| $strip(contact, creepage, strips, out)),
                    by_options(KSTRIP_MODEL_STRIP, strips)
                );
            }
            let mut result = MaybeUninit::uninit();
            assert_eq!($total(None, creepage, Some(&mut result)), KSTRIP_ERROR_NULL);
            assert_eq!($linear(contact, creepage, None), KSTRIP_ERROR_NULL);
            let wrong = $strip_1967(contact, creepage, 7, Some(&mut result));
            assert_eq!(wrong, KSTRIP_ERROR_STRIP_COUNT);
        }
    }};
}

/// To the bit, with the same statuses.
#[test]
fn functions_per_model_are_those_of_solve() {
    same_as_solve!(
        kstrip_solve,
        kstrip_contact,
        kstrip_creepage,
        kstrip_result,
        kstrip_solve_total,
        kstrip_solve_linear,
        kstrip_solve_strip_1967,
        kstrip_solve_strip
    );
    same_as_solve!(
        kstrip_solve_f32,
        kstrip_contact_f32,
        kstrip_creepage_f32,
        kstrip_result_f32,
        kstrip_solve_total_f32,
        kstrip_solve_linear_f32,
        kstrip_solve_strip_1967_f32,
        kstrip_solve_strip_f32
    );
}
