//! Every model, alone and in a batch, says what is implausible about its contact.

use crate::C0;
use kstrip::batch::solve_batch;
use kstrip::contact::Contact;
use kstrip::contact::creepage::Creepage;
use kstrip::contact::forces::StripCount;
use kstrip::solve::derivatives;
use kstrip::solve::model::{self, Model, Options};
use kstrip::status::Notice;

/// A worn wheel in a curve.
const ROLLS: Creepage<f64> = Creepage { longitudinal: 1e-4, lateral: 1e-4, spin: 0.4 };

fn wrong_units() -> [(Contact<f64>, Creepage<f64>, Notice); 8] {
    [
        // GPa, MPa
        (Contact { shear_modulus: 82.0, ..C0 }, ROLLS, Notice::Pressure),
        (Contact { shear_modulus: 82e3, ..C0 }, ROLLS, Notice::Pressure),
        // mm
        (Contact { a: 6.0, b: 4.5, ..C0 }, ROLLS, Notice::SemiAxis),
        // per cent
        (C0, Creepage { longitudinal: 12.0, ..ROLLS }, Notice::Creepage),
        (C0, Creepage { lateral: -12.0, ..ROLLS }, Notice::Creepage),
        // degrees per metre
        (C0, Creepage { spin: ROLLS.spin.to_degrees(), ..ROLLS }, Notice::Spin),
        (C0, Creepage { spin: -ROLLS.spin.to_degrees(), ..ROLLS }, Notice::Spin),
        // friction in per cent
        (Contact { friction: 30.0, ..C0 }, ROLLS, Notice::Friction),
    ]
}

#[test]
fn wrong_units_are_named_by_every_model() {
    for model in Model::ALL {
        let options = Options { model, strips: StripCount::Sixteen };
        assert_eq!(model::solve(&C0, &ROLLS, &options).unwrap().notice, Notice::None);
        for (contact, creepage, notice) in wrong_units() {
            let solution = model::solve(&contact, &creepage, &options).unwrap();
            assert_eq!(solution.notice, notice, "{model:?} {contact:?} {creepage:?}");
            let (other, _) = model::solve_jacobian(&contact, &creepage, &options).unwrap();
            assert_eq!(other.notice, notice);
            let (other, _) = derivatives::solve(&contact, &creepage, &options).unwrap();
            assert_eq!(other.notice, notice);
        }
    }
}

/// One wrong contact, or one lost one, among ordinary ones: each gets in a batch what it gets alone, and the batch says the worst.
#[test]
fn in_a_batch_each_contact_gets_its_own() {
    let lost = Contact { normal_force: 0.0, ..C0 };
    let parted = Contact { a: 0.0, b: 0.0, normal_force: -1.0, ..C0 };
    let rare = wrong_units().map(|(contact, creepage, _)| (contact, creepage));
    for model in Model::ALL {
        let options = Options { model, strips: StripCount::Sixteen };
        for rare in rare.into_iter().chain([(lost, ROLLS), (parted, ROLLS)]) {
            for place in [0, 5, 16, 18] {
                let mut many = vec![(C0, ROLLS); 19];
                many[place] = rare;
                let mut found = [None; 19];
                let put = |i: usize, solution| found[i] = Some(solution);
                let worst = solve_batch(19, &options, |i| many[i], put).unwrap();
                let mut expected = Notice::None;
                for (found, (contact, creepage)) in found.into_iter().zip(many) {
                    let alone = model::solve(&contact, &creepage, &options).unwrap();
                    assert_eq!(found, Some(alone), "{model:?} {contact:?}");
                    expected = expected.worse(alone.notice);
                }
                assert_eq!(worst, expected);
            }
        }
    }
}
