//! Every model, alone and in a batch, says what is implausible about its contact.

use crate::prelude::*;
use kstrip::batch::solve_batch;
use kstrip::forces::derivatives;
use kstrip::forces::prepared::Prepared;
use kstrip::patch::solver::solve_patch;
use kstrip_testing::patch_reference::{self, banded, falling, given, real};
use kstrip_testing::reference::{open, slender, training, turning, unlike, validation};

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

/// A prepared contact does without the checks below a spin that it computes once: its warnings are
/// those of a single call on both sides of every spin at which one begins, also in contacts under
/// high pressure and in needles.
#[test]
fn prepared_contacts_warn_of_spin_as_single_calls_do() {
    let mut warned = [0; 2];
    for (a, b, normal_force) in [(6e-3, 4e-3, 80e3), (0.3e-3, 10e-3, 20e3), (9e-3, 0.2e-3, 9e3)] {
        let contact = Contact { a, b, normal_force, ..C0 };
        let options = sixteen(Model::Total);
        let prepared = Prepared::new(&contact, &options).unwrap();
        for k in 0..4000 {
            let spin = 10.0_f64.powf(f64::from(k) * 1e-3);
            let creepage = Creepage { longitudinal: 1e-4, lateral: 0.0, spin };
            let alone = solved(&contact, &creepage, &options);
            assert_eq!(prepared.solve(&creepage), Ok(alone), "{contact:?} {spin}");
            warned[usize::from(alone.warning == Warning::Spin)] += 1;
        }
    }
    assert!(warned.iter().all(|count| *count > 1000), "{warned:?}");
}

/// Warnings about an input in another unit that real contacts must never get.
pub(crate) const OF_UNITS: [Warning; 5] =
    [Warning::Curvature, Warning::Young, Warning::PerCent, Warning::Damping, Warning::Modulus];

/// The contacts and patches of `tests/data`; its wheels are asserted where they are compared with
/// CONTACT.
#[test]
fn no_contact_of_the_reference_is_taken_for_one_in_other_units() {
    let mut found = 0;
    let mut check = |name: &str, warning: Warning| {
        assert!(!OF_UNITS.contains(&warning), "{name}: {warning:?}");
        found += 1;
    };
    for case in [open(), slender(), turning(), training(), validation()].concat() {
        let solution = solved::<f64>(&case.contact(), &case.motion(), &sixteen(Model::Strip));
        check("a contact", solution.warning);
    }
    for pair in unlike() {
        check("unlike", solved(&pair.contact, &pair.motion, &sixteen(Model::Strip)).warning);
    }
    let mut patch = |case: &patch_reference::Case, patch: &Full| {
        let view = patch.view().unwrap();
        for motion in &case.motions {
            let solution = solve_patch(&view, &case.creepage(motion), Model::Strip);
            check(&case.name, solution.unwrap().warning);
        }
    };
    for case in [profiles(), real()].concat() {
        let (strips, _) = case.patch(StripCount::Sixteen);
        patch(&case, &strips);
    }
    for (case, strips) in given().into_iter().chain(banded(StripCount::Sixteen)) {
        patch(&case, &strips);
    }
    for (case, strips, _) in falling() {
        patch(&case, &strips);
    }
    println!("{found} contacts");
    assert!(found > 2500, "{found}");
}
