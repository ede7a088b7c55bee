//! The properties of the fuzz targets without a fuzzer: random bytes, and what the fuzzer once
//! found.
//!
//! `KSTRIP_FUZZ_CASES` sets the number of cases, 5000 otherwise (docs/maintain/runs.md has a
//! longer run); `PROPTEST_RNG_SEED` draws others. `KSTRIP_FUZZ_REPLAY` names a file or folder of
//! inputs to run instead, for example what libFuzzer left.

use kstrip_testing::entries;
use kstrip_testing::names::problem;
use kstrip_testing::prelude::*;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

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
        include_str!("../common/entries/tables.rs"),
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
        // The same lists call the functions of both precisions.
        let call = format!("{}(", function.strip_suffix("_f32").unwrap_or(function));
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

/// A profile 1e40 m wide had an approach of -3e-24 m; the bytes choose the function and its
/// arguments.
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

/// The steps of a curve's knots can be too many to be counted.
#[test]
fn knots_are_counted_without_overflow() {
    entries::any_entry(&[
        65, 10, 51, 13, 138, 49, 90, 107, 15, 15, 169, 245, 178, 138, 76, 198, 56, 152, 6, 195, 69,
        249, 197, 134, 59, 212, 163, 241, 236, 84, 202, 224, 190, 249, 2, 94, 88, 24, 13, 8, 171,
        231, 154, 245, 227, 245, 133, 243, 237, 222, 216, 144, 196, 131, 116, 135, 45, 30, 241,
        128, 205, 187, 197, 140, 3,
    ]);
}

/// In single precision shares of contacts may add up to more than one by rounding.
#[test]
fn shares_of_contacts_are_at_most_one() {
    entries::any_entry(&[
        200, 0, 32, 120, 125, 245, 31, 94, 207, 51, 233, 86, 23, 150, 28, 162, 133, 15, 36, 203,
        131, 157, 29, 136, 235, 147, 158, 204, 117, 41, 241, 116, 195, 245, 4, 226, 113, 193, 151,
        6, 55, 253, 112, 255, 61, 250, 85, 175, 212, 192, 205, 216, 150, 196, 244, 149, 32, 126,
        88, 210, 65, 41, 94, 28, 163, 148, 161, 126, 224, 136, 232, 242, 177, 243, 83, 240, 236,
        233, 228, 23,
    ]);
}

/// A strip that hardly carries, far away, behind a layer: its bristles slide more than any number.
#[test]
fn strips_behind_a_layer_are_finite() {
    entries::any_entry(&[
        17, 196, 3, 2, 50, 11, 227, 33, 228, 166, 189, 168, 68, 92, 44, 219, 133, 152, 196, 178,
        50, 27, 181, 139, 132, 38, 184, 162, 217, 105, 216, 101, 177, 145, 0, 164, 3, 230, 36, 48,
        41, 90, 91, 126, 21, 146, 68, 18, 168, 165, 143, 198, 131, 171, 106, 4, 16, 166, 174, 219,
        198, 44, 58, 3, 196, 166, 74, 163, 215, 100, 174, 137, 111, 116, 66, 143, 224, 72, 148, 44,
        33, 88, 62, 54, 120, 224, 147, 88, 28, 164, 13, 144, 21, 228, 84, 178, 195, 63, 1, 160,
        126, 194, 32, 176, 186, 47, 120, 9, 21, 86, 196, 201, 204, 128, 136, 54, 180, 242, 39, 230,
        224, 146, 174, 66, 107, 217, 93, 69, 107, 223, 81, 141, 238, 205, 47, 126, 33, 211, 188,
        73, 207, 136, 236, 218, 3, 104, 204, 209, 43, 133, 139, 244, 17, 27, 64, 78, 74, 112, 158,
        23, 72,
    ]);
}

fn solved<F: Float>(model: Model, numbers: [F; 10]) -> Result<Solution<F>, Error> {
    let (contact, creepage) = problem(numbers);
    forces_of_contact(&contact, &creepage, &sixteen(model))
}

/// Contacts and creepages that fuzzing found: numbers on the way were beyond the range, power was
/// negative, a moment or a sum of strips passed its bound.
#[test]
fn numbers_at_the_ends_of_their_range() {
    const MOST: f64 = f64::MAX;
    // the moment; moment times spin; spin times semi-axis, where nothing is carried; traction times
    // slip
    let needle = [1.0, MOST, 0.5, 0.5, 0.25, 1.0, 0.0, 0.0, -0.09, 0.0];
    assert_eq!(solved(Model::Strip1967, needle), Err(Error::Overflow));
    let round = [0.01, 0.01, 1e300, 1e300, 0.25, 1.0, 0.0, 0.0, 1e12, 0.0];
    assert_eq!(solved(Model::Strip, round), Err(Error::Overflow));
    let light = [1e150, 1e150, 1e5, 1e38, 0.25, 5e-324, 0.0, -1e-4, MOST, 0.0];
    assert_eq!(solved(Model::Strip, light), Err(Error::Overflow));
    let (tiny, rushing) =
        problem([2e-168, 1e-45, 3e38, 1e150, 0.25, 0.002, 1e150, 1e150, 0.0, 0.0]);
    let field = Field::new(&tiny, &rushing, &sixteen(Model::Strip));
    assert_eq!(field.err(), Some(Error::Overflow));
    // linear theory: an infinite creepage force times a stiffness of zero, stiffness times lever
    // before a small creepage
    let most = f32::MAX;
    for numbers in [
        [3e-5, 0.016, 5700.0, 1e-45, 1e-4, 1e-3, most, -3e-6, -0.04, 0.0_f32],
        [0.5, 3e-4, 5700.0, 1e-41, 0.0, 1e-3, 0.0, 4e34, 0.0, 0.0],
        [0.05, 1600.0, 8e4, 4.4e35, 0.28, 0.3, 1e-38, 5e-15, 0.0, 0.0],
    ] {
        assert_eq!(solved(Model::Linear, numbers), Err(Error::Overflow), "{numbers:?}");
    }
    // creepages whose digits are lost, and a semi-axis that was cut at 1e100 m
    let (soft, slow) = (f32::MIN_POSITIVE, [7.0525406e-5, 1.6691238e-5, -3.728531]);
    let [x, y, s] = slow;
    for numbers in [
        [21263.795, 0.006376877, 3909.4688, soft, 2.355e-5, 3.58, x, y, s, 0.0_f32],
        [
            0.5,
            3.9e-5,
            2.3362423e16,
            8.737095e-24,
            1.17e-4,
            0.125,
            6.25e-4,
            -0.04046875,
            3.800583,
            0.0,
        ],
    ] {
        assert!(solved(Model::Total, numbers).unwrap().power >= 0.0, "{numbers:?}");
    }
    let [nu, mu] = [0.0037428188323974606, 0.0016288906335830688];
    let [x, y, s] = [3.5e25, -5.778533613654189e115, -0.0012683495879173279];
    let (a, b) = (2.1245519712670684e183, 1.0457106187057722e181);
    let vast = [a, b, 72203.6361694336, 56934452056.884766, nu, mu, x, y, s, 0.0];
    assert!(solved(Model::Total, vast).unwrap().power >= 0.0);
    // a moment of a needle far beyond the longer semi-axis
    let needle = [9.9e-84, 0.0127, 5231.0, 3.7e-37, 0.25, 0.94, 1e-5, 1.2e-4, -6.95e300, 0.0_f64];
    let found = solved(Model::Strip1967, needle).unwrap();
    assert!(found.mz.abs() <= 0.94 * 5231.0 * 0.0127 * (1.0 + 1e-12), "{found:?}");
    // unit spin on a needle across: squares below a root
    for numbers in [
        [1.25e-3, 5.6e-101, 23e3, 63.5e9, 0.03, 5.6e-4, 1.2e-3, -8.2e-3, MOST, 0.0],
        [2e-5, 1.4e-99, 3.9e3, 63.5e9, 0.03, 0.25, 4e-4, 0.0, 2e120, 0.0],
    ] {
        let r = solved(Model::Strip1967, numbers).unwrap();
        let finite = [r.fx, r.fy, r.mz, r.power].iter().all(|x| x.is_finite());
        assert!(finite && r.adhesion == 0.0, "{r:?}");
    }
    // weights of the strips add up to 1 + 2e-16
    for i in 0..1000 {
        let a = 1e-3 * (1.0 + 0.01 * f64::from(i));
        let (shape, slow) = problem([a, 5e-3, 8e4, 82e9, 0.25, 0.3, 1e-30, 0.0, 0.0, 0.0]);
        let (found, _) = solve_jacobian(&shape, &slow, &Options::default()).unwrap();
        assert!(found.adhesion <= 1.0, "{}", found.adhesion);
    }
    // the strips of a needle beyond the theory's spin
    let numbers = [0.04, 1.220703125e-6, 122.0703125, 18167724609.375, 0.24, 0.03125];
    let [a, b, n, g, nu, mu] = numbers;
    let (needle, motion) =
        problem([a, b, n, g, nu, mu, 0.000634765625, 1.0, -42.9525146484375, 0.0]);
    for count in [StripCount::Four, StripCount::SixtyFour] {
        let o = options(Model::Strip1967Continuous, count);
        let [mut fy, mut size, mut mz] = [0.0_f64; 3];
        let mut add =
            |s: StripResult<f64>| (fy, mz, size) = (fy + s.fy, mz + s.mz, size + s.fy.abs());
        strips(&needle, &motion, &o, &mut add).unwrap();
        let whole = forces_of_contact(&needle, &motion, &o).unwrap();
        assert!((fy - whole.fy).abs() <= 1e-12 * size, "{fy} {whole:?}");
        assert!((mz - whole.mz).abs() <= 1e-12 * size * needle.a, "{mz} {whole:?}");
    }
}

/// Derivatives that were infinite, or that changed the forces beside them.
#[test]
fn derivatives_at_the_ends_of_the_range() {
    let wheel = [3.6e-3, 3.8e-2, 23e3, 63.5e9, 0.03, 0.11, 0.0, 2.4e-6, 0.0, 0.0];
    let (wheel, fading) = problem(wheel);
    // a spin below the smallest normal number
    let reference = options(Model::Strip1967, StripCount::SixtyFour);
    let faded = Creepage { spin: 1.265e-321, ..fading };
    let (_, slopes) = solve_jacobian(&wheel, &faded, &reference).unwrap();
    let (_, without) = solve_jacobian(&wheel, &fading, &reference).unwrap();
    assert!((slopes - without).norm() <= 1e-10 * without.norm(), "{slopes} {without}");
    // in single precision creepages below 1e-19
    for size in [1e-16_f32, 1e-19, 1e-22, 1e-30, 1e-38, 1e-44] {
        for model in [Model::Strip1967, Model::Strip1967Continuous] {
            let [slopes, wanted] = [size, 1e-9].map(|x| {
                let numbers = [6e-3, 5e-3, 8e4, 82e9, 0.28, 0.3, x, 0.1 * x, 3.0 * x, 0.0];
                let (contact, motion) = problem(numbers);
                solve_jacobian(&contact, &motion, &sixteen(model)).unwrap().1
            });
            assert!((slopes - wanted).norm() <= 1e-4 * wanted.norm(), "{size}: {slopes} {wanted}");
        }
    }
    // nothing carried, and slopes of f beyond the number range
    let needle = [0.04, 1.2e-6, 0.0, 82e9, 0.28, 0.3, -2e-3, -0.015, -9e-4, 0.0_f32];
    let (needle, motion) = problem(needle);
    for model in Model::ALL.into_iter().filter(|model| *model != Model::Linear) {
        let o = sixteen(model);
        let (result, slopes) = solve_jacobian(&needle, &motion, &o).unwrap();
        assert!(result.fx == 0.0 && result.mz == 0.0 && slopes.iter().all(|s| *s == 0.0));
    }
    // a moment that underflows had another sign of zero with derivatives
    let [a, b, g, nu, mu] = [2.4414062e-6, 7.1780203e-4, 3.1061554e11, 8.197403e-3, 7.785678e-3];
    let light = [a, b, 28033.732, g, nu, mu, -3.463707e-3, 1e-45, 1e-45, 0.0_f32];
    let ((light, faint), o) = (problem(light), options(Model::Strip, StripCount::Four));
    let (with, _) = solve_jacobian(&light, &faint, &o).unwrap();
    let bits = |r: Solution<f32>| [r.fx, r.fy, r.mz].map(f32::to_bits);
    assert_eq!(bits(with), bits(forces_of_contact(&light, &faint, &o).unwrap()));
    // at rest, derivatives or not: no force, and adhesion everywhere
    for model in Model::ALL {
        for (zero, count) in [(0.0, StripCount::Four), (-0.0, StripCount::SixtyFour)] {
            let rest = creep(0.0, zero, zero);
            let (found, _) = solve_jacobian(&wheel, &rest, &options(model, count)).unwrap();
            let bits = |r: Solution<f64>| [r.fx, r.fy, r.mz, r.power, r.adhesion].map(f64::to_bits);
            let plain = forces_of_contact(&wheel, &rest, &options(model, count)).unwrap();
            assert_eq!(bits(found), bits(plain), "{model:?}");
        }
    }
    // a sensitivity that is no number is none
    let light = [6e-3, 5e-3, 1.1754944e-38, f32::MAX, 0.28, 0.3, 2.3e-3, 0.146, -0.124, 0.0];
    let (light, motion) = problem(light);
    let found =
        estimate_friction(&light, &motion, None, &Options::default(), Measured::Fx, [0.0; 2]);
    assert!(found.unwrap().sensitivity.is_finite());
}

/// Patches that were built and that no function accepted, and points of one beyond the number
/// range.
#[test]
fn patches_at_the_ends_of_the_range() {
    type Single = Patch<f32>;
    let single = |a: f32, b: f32, normal_force: f32| {
        problem([a, b, normal_force, 82e9, 0.28, 0.3, 0.0, 0.0, 0.0, 0.0]).0
    };
    let accepted = |contact: &Contact<f32>, count| match Single::from_ellipse(contact, count) {
        Ok(built) => built.view().is_ok(),
        Err(error) => error == Error::Overflow,
    };
    let wide = Single::from_ellipse(&single(1e34, 3.4e38, 1.0), StripCount::SixtyFour);
    assert_eq!(wide.err(), Some(Error::Overflow));
    // at the end of the range of axis ratios the ellipse of the strips was beyond it, that of their
    // contact not
    for hair in 0..200 {
        let needle = single(1.6593862e-5, 1.6593862e7 * (1.0 - 1e-4 * hair as f32), 8e4);
        assert!(accepted(&needle, StripCount::Four), "{needle:?}");
    }
    assert!(accepted(&single(6.6e-39, 1.2e-38, 1.2e-38), StripCount::Four));
    // a load below the smallest normal number
    for normal_force in [2.4e-44, 1e-40, 1e-38, 1e-35, 1e-32, 1e-30] {
        for count in [StripCount::Four, StripCount::SixtyFour] {
            let built = Single::from_ellipse(&single(9.7e-3, 5e-3, normal_force), count).unwrap();
            assert!(built.view().is_ok(), "{normal_force}");
        }
    }
    // factors of a quadrature are near one
    let (wheel, _) = problem([3.6e-3, 3.8e-2, 23e3, 63.5e9, 0.03, 0.11, 0.0, 0.0, 0.0, 0.0]);
    let patch = Patch::<f64>::from_ellipse(&wheel, StripCount::Four).unwrap();
    let scale = QuadratureScale { area: f64::MAX, lever: 1.0 };
    let view = PatchView::new(patch.used(), 82e9, 0.28, scale);
    assert_eq!(view.err(), Some(Error::Overflow));
    // a lobe whose pressure has no square beside that of the other
    for model in [Model::Strip, Model::Total, Model::Strip1967] {
        for faint in [1e-6, 1e-9, 1e-14, 1e-20, 1e-30, 1e-100, 1e-150, 1e-200, 0.0] {
            let double = forces_with_a_faint_lobe::<f64>(faint, model);
            let single = forces_with_a_faint_lobe::<f32>(faint as f32, model);
            for (one, other) in double.into_iter().zip(single) {
                assert!(one.is_finite() && (f64::from(other) / one - 1.0).abs() < 1e-4);
            }
        }
    }
    // what a point dissipates
    let (y, width, half_length, centre_x) = (0.0_f32, 2.5e-6, 2.4e-2, 0.0);
    let (peak_pressure, friction) = (3.8e7, 3.8e30);
    let rough = PatchStrip { y, width, half_length, centre_x, peak_pressure, friction };
    let patch = Patch::<f32>::from_strips(&[rough], 5e37, 0.01).unwrap();
    let (view, motion) = (patch.view().unwrap(), creep(1e-3, 0.1, 48.0));
    let field = PatchField::new(&view, &motion, None, Model::Strip1967Continuous);
    assert!(field.is_err_and(|error| error == Error::Overflow));
}

/// Forces, moment and power of a lobe of 1 GPa with another of this pressure beside it.
fn forces_with_a_faint_lobe<F: Float>(faint: F, model: Model) -> [F; 4] {
    let [width, half_length, friction] = [1e-3, 5e-3, 0.3].map(F::of);
    let lobes = [(0.0, F::of(1e9)), (10e-3, faint)].map(|(y, peak_pressure)| {
        let (y, centre_x) = (F::of(y), F::zero());
        PatchStrip { y, width, half_length, centre_x, peak_pressure, friction }
    });
    let patch = Patch::from_strips(&lobes, F::of(82e9), F::of(0.28)).unwrap();
    let [longitudinal, lateral, spin] = [1e-3, 1e-3, 0.3].map(F::of);
    let motion = Creepage { longitudinal, lateral, spin };
    let found = kstrip::patch::solver::solve_patch(&patch.view().unwrap(), &motion, model);
    let Solution { fx, fy, mz, power, .. } = found.unwrap();
    [fx, fy, mz, power]
}

/// A wheel of a file of MiniProf is moved to its running circle, also where the product of the
/// width and the height of a chord has no number in single precision.
#[test]
fn wheels_of_any_size_are_moved_to_their_running_circle() {
    use kstrip::profile_file::{notes, orient_points, unit_of_points};
    let format = notes::KSTRIP_FORMAT_MINIPROF
        | notes::KSTRIP_FORMAT_WHEEL
        | notes::KSTRIP_FORMAT_Z_DOWN
        | notes::KSTRIP_FORMAT_SIDE;
    let given = [[0.0, 0.01, -1e12, 1e12], [0.0, 0.02, 0.0, -1e12_f32]];
    let points = given.each_ref().map(|list| &list[..]);
    let [mut y, mut z] = [[f32::NAN; 4]; 2];
    let mut unit = unit_of_points(points, &[4], format, 1e8).expect("valid points");
    orient_points(points, [&mut y, &mut z], &[4], format, &mut unit);
    assert!(y.iter().chain(&z).all(|number| number.is_finite()), "{y:?} {z:?}");
}
