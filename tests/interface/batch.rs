//! Batches give the bits of single solves, whatever the layout of the arrays; bad input touches
//! nothing.
//!
//! Only builds without debug assertions solve contacts side by side in wide registers:
//! `cargo test --config tests/plain.toml --test interface batch`.

use kstrip::ffi::types::{BatchInputs, BatchOutputs, Outputs};
use kstrip_testing::in_c::{InC, bits_of};
use kstrip_testing::names::*;
use kstrip_testing::prelude::*;

const COUNT: usize = 203;

/// What a status that is no error tells.
fn told(status: i32) -> Warning {
    use Warning::*;
    let all = [
        SpinBeyondTheory,
        OutsideRange,
        BeyondFriction,
        SeveralFrictions,
        NotConverged,
        Pressure,
        Creepage,
        SemiAxis,
        Modulus,
        Young,
        Spin,
        Friction,
        AxisRatio,
        Mismatch,
        MismatchNeglected,
    ];
    all.into_iter().find(|warning| warning.code() == status).unwrap_or(None)
}

/// Inputs of contacts of all kinds, array by array, the mismatch last; the first is at rest, some
/// have extreme spin, and some no load and no spin.
fn inputs() -> [Vec<f64>; 10] {
    let mut random = Random::new(21);
    let mut arrays: [Vec<f64>; 10] = Default::default();
    for i in 0..COUNT {
        let b = 4e-3;
        let size = if i == 0 { 0.0 } else { random.log_between(1e-6, 0.1) };
        let values = [
            b * random.log_between(0.05, 20.0),
            b,
            if i == 1 || i % 17 == 9 { 0.0 } else { random.log_between(1e3, 2e5) },
            82e9,
            random.between(0.0, 0.5),
            random.between(0.05, 0.6),
            size * random.between(-1.0, 1.0),
            size * random.between(-1.0, 1.0),
            if i % 7 == 3 || i % 17 == 9 {
                0.0
            } else {
                random.between(-1.0, 1.0) * random.log_between(1e-3, 1e3)
            },
            if i % 11 == 5 { random.between(-0.3, 0.3) } else { 0.0 },
        ];
        for (array, value) in arrays.iter_mut().zip(values) {
            array.push(value);
        }
    }
    arrays
}

/// Numbers that are hard for some formula, or bad.
const HARD: [f64; 24] = [
    0.0, -0.0, 5e-324, 1e-310, 1e-45, 1e-30, 1e-12, 1e-6, 4e-3, 0.5, 1.0, 3.0, 1e4, 8e10, 1e16,
    1e30, 3e38, 1e100, 1e300, MOST, INFINITE, NAN, -1.0, -1e300,
];
const INFINITE: f64 = f64::INFINITY;
const MOST: f64 = f64::MAX;
const NAN: f64 = f64::NAN;

/// A contact with its creepage; usual, unusual, or with one to nine numbers that are hard.
fn any_kind(random: &mut Random, kind: usize) -> [f64; 10] {
    let size = random.log_between(1e-7, 1.0);
    let mut values = [
        4e-3 * random.log_between(0.02, 50.0),
        4e-3,
        random.log_between(1e2, 2e5),
        82e9,
        random.between(0.0, 0.5),
        random.between(0.05, 0.6),
        size * random.between(-1.0, 1.0),
        size * random.between(-1.0, 1.0),
        random.between(-1.0, 1.0) * random.log_between(1e-3, 1e4),
        if kind % 13 == 5 { random.between(-0.3, 0.3) } else { 0.0 },
    ];
    // motion without some of its parts, as on straight track or a roller
    for part in 0..3 {
        if kind & (1 << part) != 0 && random.between(0.0, 1.0) < 0.8 {
            values[6 + part] = 0.0;
        }
    }
    if kind % 11 == 2 {
        // a neighbour that needs another branch of the theory of 1967: no spin, little, near one,
        // beyond; some stick, some slide
        let [a, b, normal_force, shear_modulus, poisson_ratio, friction, ..] = values;
        let contact =
            Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch: 0.0 };
        let spins = [0.0, 1e-9, 0.3, 0.9, 0.99, 0.993, 0.9999, 1.0, 1.0001, 1.3];
        let parameters = Parameters {
            xi: random.between(-1.0, 1.0),
            eta: random.between(-1.0, 1.0),
            psi: spins[(kind / 11) % spins.len()] * if kind & 1 == 0 { 1.0 } else { -1.0 },
            poisson_ratio,
            axis_ratio: a / b,
        };
        let motion = parameters.creepage(&contact);
        [values[6], values[7], values[8]] = [motion.longitudinal, motion.lateral, motion.spin];
    }
    // neither load nor spin
    if kind % 17 == 9 {
        (values[2], values[8]) = (0.0, 0.0);
    }
    let hard = match kind % 11 {
        0 => 1 + (random.between(0.0, 3.0) as usize),
        1 => 9,
        _ => 0,
    };
    for _ in 0..hard {
        let place = random.between(0.0, 9.0) as usize;
        let number = HARD[random.between(0.0, HARD.len() as f64) as usize];
        values[place.min(8)] = if random.between(0.0, 1.0) < 0.3 { -number } else { number };
    }
    values
}

fn options() -> impl Iterator<Item = kstrip_options> {
    (1..=5).flat_map(|model| [4, 16].map(|strips| kstrip_options { model, strips }))
}

/// Thousands of contacts of all kinds: the bits of single solves in any company, whatever the
/// count's remainder; the first error wherever it stands, with nothing written.
fn any_company<F: InC>() {
    let mut random = Random::new(5);
    let all: Vec<[F; 10]> = (0..4000).map(|kind| any_kind(&mut random, kind).map(F::of)).collect();
    for options in options() {
        let single = |values: &[F; 10]| {
            let (contact, creepage) = problem(*values);
            let mut result = MaybeUninit::uninit();
            let status = F::solve((&contact, &creepage, &options), &mut result);
            if status < 0 {
                return Err(status);
            }
            let r: Solution<F> = unsafe { result.assume_init() };
            Ok((status, bits_of(&r), r.warning.code()))
        };
        let (good, bad): (Vec<_>, Vec<_>) = all
            .iter()
            .map(|values| (*values, single(values)))
            .partition(|(_, found)| found.is_ok());
        assert!(good.len() > 3000 && bad.len() > 100, "{} {}", good.len(), bad.len());

        let together = |problems: &[[F; 10]]| {
            let count = problems.len();
            let (contacts, creepages): (Vec<_>, Vec<_>) =
                problems.iter().map(|p| problem(*p)).unzip();
            let [fx, fy, mz, power, adhesion] = [F::of(7.0); 5];
            let warning = Warning::NotConverged;
            let untouched = Solution { fx, fy, mz, power, adhesion, warning, reserved: 0 };
            let mut results = vec![untouched; count];
            let status = unsafe {
                let from = batch_inputs(contacts.as_ptr(), creepages.as_ptr());
                let to = batch_results(results.as_mut_ptr());
                let mut bad = MaybeUninit::uninit();
                let status = F::batch(&from, count, &options, &to, Some(&mut bad));
                let bad = bad.assume_init() as usize;
                let first = problems.iter().position(|values| single(values).is_err());
                assert_eq!(bad, first.unwrap_or(problems.len()));
                status
            };
            let arrays: [Vec<F>; 10] =
                std::array::from_fn(|k| problems.iter().map(|p| p[k]).collect());
            let from = batch_arrays(arrays.each_ref().map(|array| array.as_ptr()));
            let mut found: [Vec<F>; 5] = std::array::from_fn(|_| vec![F::of(7.0); count]);
            let mut details = vec![Warning::NotConverged.code(); count];
            let places = found.each_mut().map(|array| array.as_mut_ptr());
            let to = batch_results_arrays(places, details.as_mut_ptr());
            let other = unsafe { F::batch(&from, count, &options, &to, None) };
            assert_eq!(status, other);
            for (i, r) in results.iter().enumerate() {
                assert_eq!(bits_of(r), found.each_ref().map(|array| array[i].bits()));
                assert_eq!(r.warning.code(), details[i]);
            }
            (status, results)
        };
        let inputs: Vec<_> = good.iter().map(|(values, _)| *values).collect();
        for (first, count) in
            (0..17).flat_map(|k| [(37 * k, 160 + k), (41 * k, k)]).chain([(0, inputs.len())])
        {
            let (status, results) = together(&inputs[first..first + count]);
            let mut worst = Warning::None;
            for (r, (values, expected)) in results.iter().zip(&good[first..]) {
                let (status, bits, detail) = expected.unwrap();
                worst = worst.worse(told(status));
                let is = (bits_of(r), r.warning.code());
                assert_eq!(is, (bits, detail), "{options:?} {values:?}");
            }
            assert_eq!(status, worst.code());
        }
        for (k, pair) in bad.chunks(2).enumerate().take(150) {
            let mut inputs = inputs[..203].to_vec();
            inputs[k % 203] = pair[0].0;
            if let Some((values, _)) = pair.get(1) {
                // a later one, also in the same register
                let later = (k % 203 + 1 + k % 9).min(202);
                if later > k % 203 {
                    inputs[later] = *values;
                }
            }
            let (status, results) = together(&inputs);
            assert_eq!(Err(status), pair[0].1, "{options:?} {:?}", pair[0].0);
            assert!(
                results.iter().all(|r| r.fx == F::of(7.0) && r.warning == Warning::NotConverged)
            );
        }
    }
}

#[test]
fn any_company_gives_the_same_bits() {
    any_company::<f64>();
}

#[test]
fn any_company_gives_the_same_bits_in_single_precision() {
    any_company::<f32>();
}

#[test]
fn only_what_is_wanted_is_written_and_nothing_on_errors() {
    let mut arrays = inputs();
    let from =
        |arrays: &[Vec<f64>; 10]| batch_arrays(arrays.each_ref().map(|array| array.as_ptr()));
    let nothing = no_batch();
    const EACH: isize = size_of::<f64>() as isize;
    let count = COUNT as u32;
    let mut fy = vec![7.0; COUNT];
    let wanted = kstrip_batch_outputs { fy: fy.as_mut_ptr(), fy_stride: EACH, ..nothing };
    let evaluate = |from: &kstrip_batch_inputs,
                    count,
                    options: Option<&kstrip_options>,
                    to: &kstrip_batch_outputs| unsafe {
        kstrip_evaluate_batch(Some(from), count, options, Some(to), None)
    };
    for to in [&wanted, &nothing] {
        assert!(evaluate(&from(&arrays), count, None, to) >= 0);
    }
    assert!(fy.iter().all(|fy| *fy != 7.0));
    // Whatever else is wanted, a quantity has the same bits
    let mut found: [Vec<f64>; 5] = std::array::from_fn(|_| vec![7.0; COUNT]);
    for options in options() {
        let mut whole: Option<[Vec<f64>; 5]> = None;
        for mask in (0..32_u32).rev() {
            let place = |i: usize, array: &mut Vec<f64>| {
                if mask >> i & 1 == 1 { array.as_mut_ptr() } else { null_mut() }
            };
            let [fx, fy, mz, power, adhesion] = &mut found;
            let places =
                [place(0, fx), place(1, fy), place(2, mz), place(3, power), place(4, adhesion)];
            let wanted = batch_results_arrays(places, null_mut());
            assert!(evaluate(&from(&arrays), count, Some(&options), &wanted) >= 0);
            let whole = whole.get_or_insert_with(|| found.clone());
            assert!(found == *whole, "{mask} {options:?}");
        }
    }

    arrays[5][COUNT - 1] = -0.1;
    fy.fill(7.0);
    let wanted = kstrip_batch_outputs { fy: fy.as_mut_ptr(), fy_stride: EACH, ..nothing };
    let solve = |from: Option<&kstrip_batch_inputs>, to: Option<&kstrip_batch_outputs>| unsafe {
        kstrip_evaluate_batch(from, count, None, to, None)
    };
    assert_eq!(solve(Some(&from(&arrays)), Some(&wanted)), KSTRIP_ERROR_FRICTION);
    let missing = kstrip_batch_inputs { spin: std::ptr::null(), ..from(&arrays) };
    assert_eq!(solve(Some(&missing), Some(&wanted)), KSTRIP_ERROR_NULL);
    assert_eq!(solve(None, Some(&wanted)), KSTRIP_ERROR_NULL);
    assert_eq!(solve(Some(&from(&arrays)), None), KSTRIP_ERROR_NULL);
    // under friction that falls with the slip, of two contacts as of many
    (arrays[0][1], arrays[2][1]) = (-4e-3, 1e4);
    let law = falling(0.3, 0.4, 0.6, 20.0, 1.0);
    let falling = kstrip_batch_inputs { law: &law, law_stride: 0, ..from(&arrays) };
    for count in [2, count] {
        assert_eq!(evaluate(&falling, count, None, &wanted), KSTRIP_ERROR_SEMI_AXIS);
    }
    assert!(fy.iter().all(|fy| *fy == 7.0));
    let empty = kstrip_batch_inputs { a: std::ptr::null(), ..missing };
    assert_eq!(evaluate(&empty, 0, None, &wanted), KSTRIP_OK);
}

/// Contacts of all kinds with derivatives, every second time under falling friction, every fourth
/// time behind a layer that sliding softens too: bits and
/// statuses of kstrip_evaluate(), and nothing is written where one has an error, also one that only
/// its derivatives tell.
fn derivatives_in_any_company<F: InC>() {
    let [friction, ratio, decay, rolling_speed, slope_factor] =
        [0.3, 0.4, 0.6, 20.0, 0.5].map(F::of);
    let constant = SlipFriction::of_constant(friction);
    let law = SlipFriction { ratio, decay, rolling_speed, slope_factor, ..constant };
    let entries = |d: &Derivatives<F>| {
        let [x, y, z] = d.jacobian;
        [x, y, z, d.normal_force, d.load_through_hertz, d.friction].map(|row| row.map(F::bits))
    };
    let untouched = Derivatives::default();
    let mut random = Random::new(8);
    let mut errors = 0;
    let rounds = (0..12).flat_map(|round| options().map(move |options| (round, options)));
    for (round, options) in rounds {
        let cases: Vec<_> = (0..17)
            .map(|kind| {
                // an error in every third round
                let kind = if round % 3 == 0 { kind } else { 11 * kind + 2 + kind % 9 };
                problem(any_kind(&mut random, kind).map(F::of))
            })
            .collect();
        let soft = SlipFriction { slide_factor: F::of(0.4), layer: F::of(3e-14), ..law };
        let law = (round % 2 == 1).then_some(if round % 4 == 1 { &law } else { &soft });
        let single = |k: usize| {
            let mut found = untouched;
            let outputs = Outputs { derivatives: &mut found, ..nowhere() };
            let asked = (&cases[k].0, &cases[k].1, &options);
            let status = unsafe { F::evaluate(asked, law, &outputs) };
            (status, entries(&found))
        };
        let (contacts, creepages): (Vec<_>, Vec<_>) = cases.iter().copied().unzip();
        let mut found = vec![untouched; cases.len()];
        let from = BatchInputs {
            law: law.map_or(std::ptr::null(), |law| law),
            ..batch_inputs(contacts.as_ptr(), creepages.as_ptr())
        };
        let to = BatchOutputs {
            derivatives: found.as_mut_ptr(),
            derivatives_stride: size_of::<Derivatives<F>>() as isize,
            ..no_batch()
        };
        let status = unsafe { F::batch(&from, cases.len(), &options, &to, None) };
        let alone: Vec<_> = (0..cases.len()).map(single).collect();
        let first = alone.iter().find(|(status, _)| *status < 0);
        errors += usize::from(first.is_some());
        let told = alone.iter().map(|(status, _)| told(*status));
        let worst = told.fold(Warning::None, Warning::worse).code();
        assert_eq!(status, first.map_or(worst, |(status, _)| *status), "{options:?}");
        for (k, (found, (_, alone))) in found.iter().zip(&alone).enumerate() {
            let expected = if first.is_some() { entries(&untouched) } else { *alone };
            assert_eq!(entries(found), expected, "{options:?} {:?}", cases[k]);
        }
        // aligned, and smaller than what it steps over
        let packed = BatchOutputs {
            derivatives: found.as_mut_ptr(),
            derivatives_stride: align_of::<Derivatives<F>>() as isize,
            ..no_batch()
        };
        let status = unsafe { F::batch(&from, cases.len(), &options, &packed, None) };
        assert_eq!(status, Error::Stride.code(), "{options:?}");
    }
    assert!((10..110).contains(&errors), "{errors}");
}

#[test]
fn derivatives_in_any_company_are_those_of_single_calls() {
    derivatives_in_any_company::<f64>();
}

#[test]
fn derivatives_in_any_company_too_in_single_precision() {
    derivatives_in_any_company::<f32>();
}
