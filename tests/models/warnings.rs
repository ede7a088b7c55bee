//! Every model, alone and in a batch, says what is implausible about its contact.

use crate::prelude::*;
use kstrip::batch::solve_batch;
use kstrip::forces::derivatives;

/// A worn wheel in a curve.
const ROLLS: Creepage<f64> = creep(1e-4, 1e-4, 0.4);

fn wrong_units() -> [(Contact<f64>, Creepage<f64>, Warning); 8] {
    [
        // GPa, MPa
        (Contact { shear_modulus: 82.0, ..C0 }, ROLLS, Warning::Pressure),
        (Contact { shear_modulus: 82e3, ..C0 }, ROLLS, Warning::Pressure),
        // mm
        (Contact { a: 6.0, b: 4.5, ..C0 }, ROLLS, Warning::SemiAxis),
        // per cent
        (C0, Creepage { longitudinal: 12.0, ..ROLLS }, Warning::Creepage),
        (C0, Creepage { lateral: -12.0, ..ROLLS }, Warning::Creepage),
        // degrees per metre
        (C0, Creepage { spin: ROLLS.spin.to_degrees(), ..ROLLS }, Warning::Spin),
        (C0, Creepage { spin: -ROLLS.spin.to_degrees(), ..ROLLS }, Warning::Spin),
        // friction in per cent
        (Contact { friction: 30.0, ..C0 }, ROLLS, Warning::Friction),
    ]
}

#[test]
fn wrong_units_are_named_by_every_model() {
    for model in Model::ALL {
        let options = sixteen(model);
        assert_eq!(solved(&C0, &ROLLS, &options).warning, Warning::None);
        for (contact, creepage, warning) in wrong_units() {
            let solution = solved(&contact, &creepage, &options);
            assert_eq!(solution.warning, warning, "{model:?} {contact:?} {creepage:?}");
            let (other, _) = forces::solve_jacobian(&contact, &creepage, &options).unwrap();
            assert_eq!(other.warning, warning);
            let (other, _) =
                derivatives::forces_and_derivatives(&contact, &creepage, &options).unwrap();
            assert_eq!(other.warning, warning);
        }
    }
}

/// One wrong contact, or one lost one, among ordinary ones: each gets in a batch what it gets
/// alone, and the batch says the worst.
#[test]
fn in_a_batch_each_contact_gets_its_own() {
    let lost = Contact { normal_force: 0.0, ..C0 };
    let parted = Contact { a: 0.0, b: 0.0, normal_force: -1.0, ..C0 };
    let rare = wrong_units().map(|(contact, creepage, _)| (contact, creepage));
    for model in Model::ALL {
        let options = sixteen(model);
        for rare in rare.into_iter().chain([(lost, ROLLS), (parted, ROLLS)]) {
            for place in [0, 5, 16, 18] {
                let mut many = vec![(C0, ROLLS); 19];
                many[place] = rare;
                let mut found = [None; 19];
                let put = |i: usize, solution| found[i] = Some(solution);
                let worst = solve_batch(19, &options, |i| many[i], put).unwrap();
                let mut expected = Warning::None;
                for (found, (contact, creepage)) in found.into_iter().zip(many) {
                    let alone = solved(&contact, &creepage, &options);
                    assert_eq!(found, Some(alone), "{model:?} {contact:?}");
                    expected = expected.worse(alone.warning);
                }
                assert_eq!(worst, expected);
            }
        }
    }
}
