//! The properties of the fuzz targets without a fuzzer: random bytes, and what the fuzzer once found.
//!
//! `KSTRIP_FUZZ_CASES` sets the number of cases, 5000 otherwise (`.ci/run`: 20 000; docs/reliability.md: 1 000 000 in release).
//! `KSTRIP_FUZZ_REPLAY` names a file or folder of inputs to run instead, for example what libFuzzer left.

use crate::entries;

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use std::collections::BTreeSet;
use std::path::Path;

fn cases() -> u32 {
    let text = std::env::var("KSTRIP_FUZZ_CASES").unwrap_or_default();
    text.parse().unwrap_or(5_000)
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

/// No function of the header is left out, and none is chosen by no first byte.
#[test]
fn every_function_of_the_header_is_called() {
    const LISTS: [&str; 6] = [
        include_str!("../common/entries/arguments.rs"),
        include_str!("../common/entries/arrays.rs"),
        include_str!("../common/entries/contacts.rs"),
        include_str!("../common/entries/patches.rs"),
        include_str!("../common/entries/single.rs"),
        include_str!("../common/entries/wheels.rs"),
    ];
    let header =
        concat!(include_str!("../../include/kstrip.h"), include_str!("../../include/kstrip_f32.h"));
    let functions: BTreeSet<&str> = header
        .lines()
        .filter(|line| {
            line.starts_with("kstrip_status ") || line.contains("kstrip_abi_version(void")
        })
        .chain(header.lines().filter(|line| line.starts_with("const char *")))
        .filter_map(|line| line.split('(').next()?.rsplit([' ', '*']).next())
        .collect();
    assert!(functions.len() >= 58, "{functions:?}");
    for function in &functions {
        // The single precision has its functions by another name: a `use` that is not used is a warning.
        let call = match function.strip_suffix("_f32") {
            Some(name) => format!("{function} as {name}"),
            None => format!("{function}("),
        };
        assert!(LISTS.iter().any(|list| list.contains(&call)), "{function} is not called");
    }
    let chosen: BTreeSet<(&str, bool)> =
        (0..=255).map(|choice| (entries::chosen(choice).0, choice < 128)).collect();
    let written: usize = LISTS.iter().map(|list| list.matches("    (\"").count()).sum();
    println!("{} functions by {} checks", functions.len(), chosen.len());
    assert!(chosen.len() >= 2 * written && written > 20, "{} of {written}", chosen.len());
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

/// A profile 1e40 m wide had an approach of -3e-24 m; the bytes choose the function and its arguments.
#[test]
fn approach_is_not_below_zero() {
    entries::any_entry(&[
        14, 16, 47, 1, 116, 86, 179, 249, 38, 6, 48, 72, 107, 82, 41, 238, 68, 170, 176, 172, 242,
        145, 252, 207, 239, 153, 226, 101, 49, 32, 148, 7, 226, 186, 91, 39, 96, 150, 107, 136,
        100, 230, 167, 64, 182, 242, 163, 27, 23, 161, 254, 141, 216, 238, 195, 86, 84, 218, 248,
        109, 26, 143, 119, 101, 113, 229, 156, 8, 43, 120, 138, 108, 175, 89, 198, 125, 53, 7, 222,
        1, 207, 254, 237, 248,
    ]);
}

/// What fuzzing found, with the status that each has since.
#[test]
fn what_was_found_stays_repaired() {
    use kstrip::contact::Contact;
    use kstrip::contact::creepage::Creepage;
    use kstrip::contact::forces::StripCount;
    use kstrip::solve::model::{Field, Model, Options, solve, solve_jacobian};
    use kstrip::status::Error;

    let contact = |a, b, normal_force, shear_modulus, friction| Contact {
        a,
        b,
        normal_force,
        shear_modulus,
        poisson_ratio: 0.25,
        friction,
        mismatch: 0.0,
    };
    let creepage = |longitudinal, lateral, spin| Creepage { longitudinal, lateral, spin };
    let options = |model| Options { model, strips: StripCount::Sixteen };

    // The moment overflowed on its way to a number.
    let needle = contact(1.0, f64::MAX, 0.5, 0.5, 1.0);
    let turning = creepage(0.0, 0.0, -0.09);
    assert_eq!(solve(&needle, &turning, &options(Model::Strip1967)), Err(Error::Overflow));
    // Power below zero, where the creepages have no digits left and the slopes of a needle make much of them.
    let (a, b) = (21263.795_f32, 0.006376877);
    let soft = Contact {
        a,
        b,
        normal_force: 3909.4688,
        shear_modulus: f32::MIN_POSITIVE,
        poisson_ratio: 2.355e-5,
        friction: 3.58,
        mismatch: 0.0,
    };
    let slow = Creepage { longitudinal: 7.0525406e-5, lateral: 1.6691238e-5, spin: -3.728531 };
    assert!(solve(&soft, &slow, &options(Model::Total)).unwrap().power >= 0.0);
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
        mismatch: 0.0,
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

/// What fuzzing of every function found, on 21 November 2026.
#[test]
fn what_every_function_found_stays_repaired() {
    use kstrip::contact::Contact;
    use kstrip::contact::creepage::Creepage;
    use kstrip::contact::forces::StripCount;
    use kstrip::patch::field::PatchField;
    use kstrip::patch::{Patch, PatchStrip, PatchView, QuadratureScale};
    use kstrip::rig::{Measured, estimate_friction};
    use kstrip::solve::model::{Model, Options, Solution, solve, solve_jacobian, strips};
    use kstrip::status::Error;

    let wheel = Contact {
        a: 3.6e-3,
        b: 3.8e-2,
        normal_force: 23e3,
        shear_modulus: 63.5e9,
        poisson_ratio: 0.03,
        friction: 0.11,
        mismatch: 0.0,
    };
    let single = Contact::<f32> {
        a: 6e-3,
        b: 5e-3,
        normal_force: 8e4,
        shear_modulus: 82e9,
        poisson_ratio: 0.28,
        friction: 0.3,
        mismatch: 0.0,
    };
    let options = |model, strips| Options { model, strips };
    let reference = options(Model::Strip1967, StripCount::SixtyFour);

    // A spin below the smallest normal number: derivatives of where panels meet were infinite.
    let fading = |spin| Creepage { longitudinal: 0.0, lateral: 2.4e-6, spin };
    let (_, slopes) = solve_jacobian(&wheel, &fading(1.265e-321), &reference).unwrap();
    let (_, without) = solve_jacobian(&wheel, &fading(0.0), &reference).unwrap();
    assert!((slopes - without).norm() <= 1e-10 * without.norm(), "{slopes} {without}");
    // In single precision no creepage below 1e-19 had derivatives.
    for size in [1e-16_f32, 1e-19, 1e-22, 1e-30, 1e-38, 1e-44] {
        let motion = Creepage { longitudinal: size, lateral: 0.1 * size, spin: 3.0 * size };
        let small = Creepage { longitudinal: 1e-9, lateral: 1e-10, spin: 3e-9 };
        for model in [Model::Strip1967, Model::Strip1967Continuous] {
            let o = options(model, StripCount::Sixteen);
            let (_, slopes) = solve_jacobian(&single, &motion, &o).unwrap();
            let (_, wanted) = solve_jacobian(&single, &small, &o).unwrap();
            assert!((slopes - wanted).norm() <= 1e-4 * wanted.norm(), "{size}: {slopes} {wanted}");
        }
    }
    // Nothing carried, and slopes of f beyond the number range
    let needle = Contact { a: 0.04_f32, b: 1.2e-6, normal_force: 0.0, ..single };
    let motion = Creepage { longitudinal: -2e-3, lateral: -0.015, spin: -9e-4 };
    for model in Model::ALL.into_iter().filter(|model| *model != Model::Linear) {
        let o = options(model, StripCount::Sixteen);
        let (result, slopes) = solve_jacobian(&needle, &motion, &o).unwrap();
        assert!(result.fx == 0.0 && result.mz == 0.0 && slopes.iter().all(|s| *s == 0.0));
    }
    // Unit spin on a needle across: squares below a root were no numbers any more, and forces neither.
    let across = Contact { a: 1.25e-3, b: 5.6e-101, friction: 5.6e-4, ..wheel };
    let thinner = Contact { a: 2e-5, b: 1.4e-99, normal_force: 3.9e3, friction: 0.25, ..wheel };
    let turning = |longitudinal, lateral, spin| Creepage { longitudinal, lateral, spin };
    for (needle, motion) in
        [(across, turning(1.2e-3, -8.2e-3, f64::MAX)), (thinner, turning(4e-4, 0.0, 2e120))]
    {
        let r = solve(&needle, &motion, &reference).unwrap();
        let finite = [r.fx, r.fy, r.mz, r.power].iter().all(|x| x.is_finite());
        assert!(finite && r.adhesion == 0.0, "{r:?}");
    }
    // With derivatives a moment that underflows had another sign of zero.
    let light = Contact {
        a: 2.4414062e-6_f32,
        b: 7.1780203e-4,
        normal_force: 28033.732,
        shear_modulus: 3.1061554e11,
        poisson_ratio: 8.197403e-3,
        friction: 7.785678e-3,
        mismatch: 0.0,
    };
    let faint = Creepage { longitudinal: -3.463707e-3, lateral: 1e-45, spin: 1e-45 };
    let o = options(Model::Strip, StripCount::Four);
    let (with, _) = solve_jacobian(&light, &faint, &o).unwrap();
    let bits = |r: Solution<f32>| [r.fx, r.fy, r.mz].map(f32::to_bits);
    assert_eq!(bits(with), bits(solve(&light, &faint, &o).unwrap()));
    // Creepages whose digits are lost made power negative (a/b does not matter).
    let soft = Contact {
        a: 0.5_f32,
        b: 3.9e-5,
        normal_force: 2.3362423e16,
        shear_modulus: 8.737095e-24,
        poisson_ratio: 1.17e-4,
        friction: 0.125,
        mismatch: 0.0,
    };
    let motion = Creepage { longitudinal: 0.000625, lateral: -0.04046875, spin: 3.800583 };
    let total = options(Model::Total, StripCount::Sixteen);
    assert!(solve(&soft, &motion, &total).unwrap().power >= 0.0);
    // The semi-axis was cut at 1e100 m where it met the spin.
    let vast = Contact {
        a: 2.1245519712670684e183,
        b: 1.0457106187057722e181,
        normal_force: 72203.6361694336,
        shear_modulus: 56934452056.884766,
        poisson_ratio: 0.0037428188323974606,
        friction: 0.0016288906335830688,
        mismatch: 0.0,
    };
    let motion = Creepage {
        longitudinal: 3.5e25,
        lateral: -5.778533613654189e115,
        spin: -0.0012683495879173279,
    };
    assert!(solve(&vast, &motion, &total).unwrap().power >= 0.0);
    // Stiffness times lever overflows before a small creepage makes it small again.
    let hard = Contact { a: 0.05_f32, b: 1600.0, shear_modulus: 4.4e35, ..single };
    let motion = Creepage { longitudinal: 1e-38, lateral: 5e-15, spin: 0.0 };
    let linear = options(Model::Linear, StripCount::Sixteen);
    assert_eq!(solve(&hard, &motion, &linear), Err(Error::Overflow));
    // The strips of a needle beyond the theory's spin added up to more than friction allows.
    let needle = Contact {
        a: 0.04,
        b: 1.220703125e-6,
        normal_force: 122.0703125,
        shear_modulus: 18167724609.375,
        poisson_ratio: 0.24,
        friction: 0.03125,
        mismatch: 0.0,
    };
    let motion = Creepage { longitudinal: 0.000634765625, lateral: 1.0, spin: -42.9525146484375 };
    for count in [StripCount::Four, StripCount::SixtyFour] {
        let o = options(Model::Strip1967Continuous, count);
        let [mut fy, mut size, mut mz] = [0.0_f64; 3];
        strips(&needle, &motion, &o, &mut |strip| {
            fy += strip.fy;
            mz += strip.mz;
            size += strip.fy.abs();
        })
        .unwrap();
        let whole = solve(&needle, &motion, &o).unwrap();
        assert!((fy - whole.fy).abs() <= 1e-12 * size, "{fy} {whole:?}");
        assert!((mz - whole.mz).abs() <= 1e-12 * size * needle.a, "{mz} {whole:?}");
    }
    // A patch of an ellipse at the end of the number range was one that no function accepts.
    let wide = Contact { a: 1e34_f32, b: 3.4e38, normal_force: 0.0, ..single };
    let built = Patch::<f32, 64>::from_ellipse(&wide, StripCount::SixtyFour);
    assert_eq!(built.err(), Some(Error::Overflow));
    // Factors of a quadrature are near one.
    let patch = Patch::<f64, 64>::from_ellipse(&wheel, StripCount::Four).unwrap();
    let scale = QuadratureScale { area: f64::MAX, lever: 1.0 };
    let view = PatchView::new(&patch.strips, 82e9, 0.28, scale);
    assert_eq!(view.err(), Some(Error::Overflow));
    // A sensitivity that is no number is none.
    let light = Contact { normal_force: 1.1754944e-38_f32, shear_modulus: f32::MAX, ..single };
    let motion = Creepage { longitudinal: 2.3e-3, lateral: 0.146, spin: -0.124 };
    let found =
        estimate_friction(&light, &motion, &Options::default(), Measured::Fx, [0.0, 0.0]).unwrap();
    assert!(found.sensitivity.is_finite(), "{found:?}");
    // At rest, derivatives or not: no force, and adhesion everywhere.
    for model in Model::ALL {
        for (zero, count) in [(0.0, StripCount::Four), (-0.0, StripCount::SixtyFour)] {
            let (o, rest) = (options(model, count), fading(zero));
            let rest = Creepage { lateral: zero, ..rest };
            let (found, _) = solve_jacobian(&wheel, &rest, &o).unwrap();
            let bits = |r: kstrip::solve::model::Solution<f64>| {
                [r.fx, r.fy, r.mz, r.power, r.adhesion].map(f64::to_bits)
            };
            assert_eq!(bits(found), bits(solve(&wheel, &rest, &o).unwrap()), "{model:?}");
        }
    }
    // A patch of an ellipse whose load is below the smallest normal number was one that no function accepts.
    // What a point of a patch dissipates was beyond the number range.
    let rough = PatchStrip {
        y: 0.0_f32,
        width: 2.5e-6,
        half_length: 2.4e-2,
        centre_x: 0.0,
        peak_pressure: 3.8e7,
        friction: 3.8e30,
    };
    let patch = Patch::<f32, 4>::from_strips(&[rough], 5e37, 0.01).unwrap();
    let (view, motion) =
        (patch.view().unwrap(), Creepage { longitudinal: 1e-3, lateral: 0.1, spin: 48.0 });
    let field = PatchField::new(&view, &motion, Model::Strip1967Continuous);
    assert!(field.is_err_and(|error| error == Error::Overflow));
    // At the end of the range of axis ratios the ellipse of the strips was beyond it, that of their contact not.
    for hair in 0..200 {
        let b = 1.6593862e7 * (1.0 - 1e-4 * hair as f32);
        let needle = Contact { a: 1.6593862e-5_f32, b, ..single };
        match Patch::<f32, 64>::from_ellipse(&needle, StripCount::Four) {
            Ok(built) => assert!(built.view().is_ok(), "{needle:?}"),
            Err(error) => assert_eq!(error, Error::Overflow),
        }
    }
    for normal_force in [2.4e-44_f32, 1e-40, 1e-38, 1e-35, 1e-32, 1e-30] {
        let light = Contact { a: 9.7e-3, normal_force, ..single };
        for count in [StripCount::Four, StripCount::SixtyFour] {
            let built = Patch::<f32, 64>::from_ellipse(&light, count).unwrap();
            assert!(built.view().is_ok(), "{normal_force}");
        }
    }
    let small = Contact { a: 6.6e-39_f32, b: 1.2e-38, normal_force: 1.2e-38, ..single };
    let built = Patch::<f32, 64>::from_ellipse(&small, StripCount::Four);
    assert!(built.is_err() || built.unwrap().view().is_ok());
}
