//! The properties of the fuzz targets without a fuzzer: random bytes, and what the fuzzer once found.
//!
//! `KSTRIP_FUZZ_CASES` sets the number of cases (docs/reliability.md: 1 000 000 in release).
//! `KSTRIP_FUZZ_REPLAY` names a file or folder of inputs to run instead, for example what libFuzzer left.

#[path = "common/entries.rs"]
mod entries;

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use std::path::Path;

fn cases() -> u32 {
    let text = std::env::var("KSTRIP_FUZZ_CASES").unwrap_or_default();
    text.parse().unwrap_or(20_000)
}

/// No failure file is kept: an input worth keeping goes to tests/data/fuzz.
fn random_bytes(check: fn(&[u8])) {
    let config = Config {
        cases: cases(),
        failure_persistence: None,
        max_shrink_iters: 300,
        ..Config::default()
    };
    let bytes = prop::collection::vec(any::<u8>(), 1..320);
    let outcome = TestRunner::new(config).run(&bytes, |bytes| {
        check(&bytes);
        Ok(())
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn every_function_keeps_its_promises_for_random_bytes() {
    random_bytes(entries::any_entry);
}

#[test]
fn solve_keeps_its_promises_for_random_bytes() {
    random_bytes(entries::solve_entry);
}

/// Inputs that a fuzzer left, if `KSTRIP_FUZZ_REPLAY` names a file or folder of them.
#[test]
fn inputs_of_a_fuzzer_replay() {
    let Some(path) = std::env::var_os("KSTRIP_FUZZ_REPLAY") else { return };
    let path = Path::new(&path);
    let files: Vec<_> = if path.is_dir() {
        let entries = std::fs::read_dir(path).expect("a folder of inputs");
        entries.map(|entry| entry.expect("an entry").path()).collect()
    } else {
        vec![path.to_owned()]
    };
    for file in files {
        println!("{}", file.display());
        entries::any_entry(&std::fs::read(&file).expect("an input"));
    }
}

/// What fuzzing found, with the status that each has since.
#[test]
fn what_was_found_stays_repaired() {
    use kstrip::contact::Contact;
    use kstrip::creepage::Creepage;
    use kstrip::model::{Field, Model, Options, solve, solve_jacobian};
    use kstrip::status::Error;
    use kstrip::totals::StripCount;

    let contact = |a, b, normal_force, shear_modulus, friction| Contact {
        a,
        b,
        normal_force,
        shear_modulus,
        poisson_ratio: 0.25,
        friction,
    };
    let creepage = |longitudinal, lateral, spin| Creepage { longitudinal, lateral, spin };
    let options = |model| Options { model, strips: StripCount::Sixteen };

    // The moment overflowed on its way to a number.
    let needle = contact(1.0, f64::MAX, 0.5, 0.5, 1.0);
    let turning = creepage(0.0, 0.0, -0.09);
    assert_eq!(solve(&needle, &turning, &options(Model::Strip1967)), Err(Error::Overflow));
    // Spin times semi-axis overflowed, and nothing is carried.
    let light = contact(1e150, 1e150, 1e5, 1e38, 5e-324);
    let fast = creepage(0.0, -1e-4, f64::MAX);
    assert_eq!(solve(&light, &fast, &options(Model::Strip)), Err(Error::Overflow));
    // Traction times slip overflowed.
    let tiny = contact(2e-168, 1e-45, 3e38, 1e150, 0.002);
    let rushing = creepage(1e150, 1e150, 0.0);
    assert_eq!(Field::new(&tiny, &rushing, &options(Model::Strip)).err(), Some(Error::Overflow));
    // Linear theory: an infinite creepage force times a stiffness of zero.
    let soft = Contact::<f32> {
        a: 3e-5,
        b: 0.016,
        normal_force: 5700.0,
        shear_modulus: 1e-45,
        poisson_ratio: 1e-4,
        friction: 1e-3,
    };
    let sliding = Creepage { longitudinal: f32::MAX, lateral: -3e-6, spin: -0.04 };
    assert_eq!(solve(&soft, &sliding, &options(Model::Linear)), Err(Error::Overflow));
    let needle = Contact { a: 0.5_f32, b: 3e-4, shear_modulus: 1e-41, poisson_ratio: 0.0, ..soft };
    let lateral = Creepage { longitudinal: 0.0, lateral: 4e34, spin: 0.0 };
    assert_eq!(solve(&needle, &lateral, &options(Model::Linear)), Err(Error::Overflow));
    // A moment of a needle far beyond the longer semi-axis
    let needle = contact(9.9e-84, 0.0127, 5231.0, 3.7e-37, 0.94);
    let turning = creepage(1e-5, 1.2e-4, -6.95e300);
    let result = solve(&needle, &turning, &options(Model::Strip1967)).unwrap();
    assert!(result.mz.abs() <= 0.94 * 5231.0 * 0.0127 * (1.0 + 1e-12), "{result:?}");
    // The weights of the strips add up to 1 + 2e-16.
    for i in 0..1000 {
        let shape = contact(1e-3 * (1.0 + 0.01 * f64::from(i)), 5e-3, 8e4, 82e9, 0.3);
        let (result, _) =
            solve_jacobian(&shape, &creepage(1e-30, 0.0, 0.0), &Options::default()).unwrap();
        assert!(result.adhesion <= 1.0, "{}", result.adhesion);
    }
}
