//! What is measured: calls of every model through the C interface, and of every other method, on
//! the same inputs.

use crate::peer_methods::*;
use crate::peers::fastsim::{Bound, Flexibility, Grid, Layout, solve as fastsim};
use crate::peers::{Input, Output, polach, shen_hedrick_elkins, vermeulen_johnson};
use kstrip::contact::Contact;
use kstrip::contact::creepage::Creepage;
use kstrip::contact::totals::StripCount;
use kstrip::ffi::types::{BatchInputs, BatchOutputs, Outputs};
use kstrip::forces::derivatives::Derivatives;
use kstrip::forces::prepared::Prepared;
use kstrip::forces::{Model, Solution};
use kstrip::friction::SlipFriction;
use kstrip::number::Float;
use kstrip_testing::names::*;
use kstrip_testing::random::Random;
use kstrip_testing::reference::*;
use kstrip_testing::slopes::{SlopeCase, linear_steps, slope_cases};
use std::cell::RefCell;
use std::f64::consts::{PI, TAU};
use std::hint::black_box;
use std::mem::MaybeUninit;
use std::ptr::null;
use std::rc::Rc;

/// Inputs of a set.
pub const CALLS: usize = 512;
/// Contacts of a batch.
pub const BATCHES: [usize; 3] = [1, 100, 1000];

/// Inputs that are measured together.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Set {
    /// One contact, creepages from partial slip to sliding.
    One,
    /// Random contacts with spin below 0.95.
    Spin,
    /// Random contacts without spin.
    NoSpin,
    /// Neighbours of all kinds: with and without spin, along one axis, spin alone, beyond unit
    /// spin.
    Mixed,
}
pub const SETS: [Set; 4] = [Set::One, Set::Spin, Set::NoSpin, Set::Mixed];

/// How a model is called.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum How {
    /// `kstrip_solve`, and other methods.
    Solve,
    /// `kstrip_evaluate` for the result alone.
    Forces,
    /// `kstrip_evaluate` for result and derivatives.
    Derivatives,
    /// `kstrip_solve_prepared`, every contact prepared beforehand.
    Prepared,
    /// `kstrip_evaluate_batch` of so many, one array for each quantity.
    Batch(usize),
}

/// Errors of a method: of the force on `open.csv`, of the worst derivative on `jacobians.csv`.
#[derive(Clone, Copy)]
pub struct Wrong {
    pub force: Figures,
    pub slope: Figures,
}

/// Calls, and their times.
pub struct Row {
    pub name: String,
    pub precision: &'static str,
    pub how: How,
    pub set: Set,
    pub wrong: Wrong,
    pub calls: Box<dyn Fn()>,
    /// How many contacts these calls solve.
    pub count: usize,
    /// Nanoseconds of a contact, round by round.
    pub times: Vec<f64>,
}

impl Row {
    /// Nanoseconds of a contact: the round in the middle.
    pub fn time(&self) -> f64 {
        let mut sorted = self.times.clone();
        sorted.sort_by(f64::total_cmp);
        sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN)
    }
}

type State<F> = (Contact<F>, Creepage<F>);

/// The inputs of a set.
fn inputs(set: Set) -> Vec<State<f64>> {
    let mut random = Random::new(1967);
    let spread = |i: usize, step: f64| (i as f64 * step).fract() - 0.5;
    let input = |i: usize| {
        if set == Set::One {
            let contact = Contact {
                a: 6e-3,
                b: 4e-3,
                normal_force: 80e3,
                shear_modulus: 82e9,
                poisson_ratio: 0.28,
                friction: 0.3,
                mismatch: 0.0,
            };
            // by the golden ratio and its relatives
            let longitudinal = spread(i, 0.618_034) * 8e-3;
            let lateral = spread(i, 0.381_966) * 8e-3;
            return (contact, Creepage { longitudinal, lateral, spin: spread(i, 0.271_828) * 1.5 });
        }
        let (g, nu) = (random.log_between(0.1, 10.0), random.between(0.0, 0.5));
        let (size, turn) = (random.between(0.0, 3.0), random.between(0.0, TAU));
        let (small, large) = (random.between(-0.95, 0.95), random.between(1.0, 3.0));
        // creepages as the linear force, and ψ
        let (along, across) = (size * turn.cos(), size * turn.sin());
        let [x, y, psi] = match (set, i % 6) {
            (Set::NoSpin, _) | (Set::Mixed, 1) => [along, across, 0.0],
            (Set::Mixed, 2) => [along, 0.0, 0.0],
            (Set::Mixed, 3) => [0.0, across, small],
            (Set::Mixed, 4) => [0.0, 0.0, small],
            (Set::Mixed, 5) => [along, across, large],
            _ => [along, across, small],
        };
        let [unit_x, unit_y, _] = linear_steps(g, nu);
        let creepage = [x * unit_x, y * unit_y, 3.0 * psi / (PI * g.sqrt())];
        let case = case_without_reference(g, nu, creepage);
        (case.contact(), case.motion())
    };
    (0..CALLS).map(input).collect()
}

fn case_without_reference(axis_ratio: f64, poisson_ratio: f64, creepage: [f64; 3]) -> Case {
    Case { axis_ratio, poisson_ratio, creepage, force: [0.0; 2], moment: 0.0, stick: 0.0 }
}

// --- the models ------------------------------------------------------------------------------

type Place<'a, T> = Option<&'a mut MaybeUninit<T>>;
type Settings<'a> = Option<&'a kstrip_options>;
type Solve<F> =
    extern "C" fn(Option<&Contact<F>>, Option<&Creepage<F>>, Settings, Place<Solution<F>>) -> i32;
type Evaluate<F> = unsafe extern "C" fn(
    Option<&Contact<F>>,
    Option<&Creepage<F>>,
    Option<&SlipFriction<F>>,
    Settings,
    Option<&Outputs<F>>,
) -> i32;
type Prepare<F> = extern "C" fn(Option<&Contact<F>>, Settings, Place<Prepared<F>>) -> i32;
type SolvePrepared<F> =
    extern "C" fn(Option<&Prepared<F>>, Option<&Creepage<F>>, Place<Solution<F>>) -> i32;
type Batch<F> = unsafe extern "C" fn(
    Option<&BatchInputs<F>>,
    u32,
    Settings,
    Option<&BatchOutputs<F>>,
    Place<u32>,
) -> i32;

/// The functions of the C interface in this precision.
trait Called: Float {
    const NAME: &'static str;
    const SOLVE: Solve<Self>;
    const EVALUATE: Evaluate<Self>;
    const PREPARE: Prepare<Self>;
    const SOLVE_PREPARED: SolvePrepared<Self>;
    const BATCH: Batch<Self>;
}

impl Called for f64 {
    const NAME: &'static str = "f64";
    const SOLVE: Solve<f64> = kstrip_solve;
    const EVALUATE: Evaluate<f64> = kstrip_evaluate;
    const PREPARE: Prepare<f64> = kstrip_prepare;
    const SOLVE_PREPARED: SolvePrepared<f64> = kstrip_solve_prepared;
    const BATCH: Batch<f64> = kstrip_evaluate_batch;
}

impl Called for f32 {
    const NAME: &'static str = "f32";
    const SOLVE: Solve<f32> = kstrip_solve_f32;
    const EVALUATE: Evaluate<f32> = kstrip_evaluate_f32;
    const PREPARE: Prepare<f32> = kstrip_prepare_f32;
    const SOLVE_PREPARED: SolvePrepared<f32> = kstrip_solve_prepared_f32;
    const BATCH: Batch<f32> = kstrip_evaluate_batch_f32;
}

fn in_precision<F: Called>(set: Set) -> Vec<State<F>> {
    let of = |(c, k): State<f64>| {
        let [a, b, normal_force, shear_modulus, poisson_ratio, friction] =
            [c.a, c.b, c.normal_force, c.shear_modulus, c.poisson_ratio, c.friction].map(F::of);
        let [longitudinal, lateral, spin] = [k.longitudinal, k.lateral, k.spin].map(F::of);
        let contact = Contact {
            a,
            b,
            normal_force,
            shear_modulus,
            poisson_ratio,
            friction,
            mismatch: F::zero(),
        };
        (contact, Creepage { longitudinal, lateral, spin })
    };
    inputs(set).into_iter().map(of).collect()
}

/// The calls, through a pointer that the compiler cannot resolve, as from C; and how many
/// contacts they solve.
fn calls<F: Called>(how: How, set: Set, options: kstrip_options) -> (Box<dyn Fn()>, usize) {
    let inputs = in_precision::<F>(set);
    let result = RefCell::new(MaybeUninit::uninit());
    let run: Box<dyn Fn()> = match how {
        How::Solve => {
            let solve = black_box(F::SOLVE);
            Box::new(move || {
                let mut result = result.borrow_mut();
                for (contact, creepage) in &inputs {
                    solve(Some(contact), Some(creepage), Some(&options), Some(&mut result));
                }
            })
        }
        How::Forces | How::Derivatives => {
            let evaluate = black_box(F::EVALUATE);
            let slopes = RefCell::new(MaybeUninit::<Derivatives<F>>::uninit());
            Box::new(move || {
                let mut outputs = Outputs { result: result.borrow_mut().as_mut_ptr(), ..nowhere() };
                if how == How::Derivatives {
                    outputs.derivatives = slopes.borrow_mut().as_mut_ptr();
                }
                let to = Some(&outputs);
                for (contact, creepage) in &inputs {
                    // SAFETY: both places are there.
                    unsafe { evaluate(Some(contact), Some(creepage), None, Some(&options), to) };
                }
            })
        }
        How::Prepared => {
            let prepare = |contact: &Contact<F>| {
                let mut prepared = MaybeUninit::uninit();
                let status = F::PREPARE(Some(contact), Some(&options), Some(&mut prepared));
                assert_eq!(status, 0, "prepared");
                // SAFETY: it was filled.
                unsafe { prepared.assume_init() }
            };
            let contacts = if set == Set::One { 1 } else { CALLS };
            let prepared: Vec<_> =
                inputs.iter().take(contacts).map(|(contact, _)| prepare(contact)).collect();
            let solve = black_box(F::SOLVE_PREPARED);
            Box::new(move || {
                let mut result = result.borrow_mut();
                for ((_, creepage), prepared) in inputs.iter().zip(prepared.iter().cycle()) {
                    solve(Some(prepared), Some(creepage), Some(&mut result));
                }
            })
        }
        How::Batch(each) => return batch(&inputs, each, options),
    };
    (run, CALLS)
}

/// Batches of this size, one after the other, a thousand contacts in all.
fn batch<F: Called>(
    inputs: &[State<F>], each: usize, options: kstrip_options,
) -> (Box<dyn Fn()>, usize) {
    const COUNT: usize = 1000;
    let of =
        |of: fn(&State<F>) -> F| -> Vec<F> { inputs.iter().cycle().take(COUNT).map(of).collect() };
    let quantities = [
        of(|(c, _)| c.a),
        of(|(c, _)| c.b),
        of(|(c, _)| c.normal_force),
        of(|(c, _)| c.shear_modulus),
        of(|(c, _)| c.poisson_ratio),
        of(|(c, _)| c.friction),
        of(|(_, k)| k.longitudinal),
        of(|(_, k)| k.lateral),
        of(|(_, k)| k.spin),
    ];
    let found = RefCell::new([(); 5].map(|()| vec![F::zero(); COUNT]));
    let notices = RefCell::new(vec![0; COUNT]);
    let stride = size_of::<F>() as isize;
    let solve = black_box(F::BATCH);
    let run = move || {
        let (mut found, mut notices) = (found.borrow_mut(), notices.borrow_mut());
        for first in (0..COUNT).step_by(each) {
            let [a, b, load, modulus, poisson, friction, longitudinal, lateral, spin] =
                quantities.each_ref().map(|numbers| numbers[first..].as_ptr());
            let [fx, fy, mz, power, adhesion] =
                found.each_mut().map(|numbers| numbers[first..].as_mut_ptr());
            let inputs = BatchInputs {
                a,
                a_stride: stride,
                b,
                b_stride: stride,
                normal_force: load,
                normal_force_stride: stride,
                shear_modulus: modulus,
                shear_modulus_stride: stride,
                poisson_ratio: poisson,
                poisson_ratio_stride: stride,
                friction,
                friction_stride: stride,
                mismatch: null(),
                mismatch_stride: 0,
                longitudinal,
                longitudinal_stride: stride,
                lateral,
                lateral_stride: stride,
                spin,
                spin_stride: stride,
                law: null(),
                law_stride: 0,
            };
            let outputs = BatchOutputs {
                fx,
                fx_stride: stride,
                fy,
                fy_stride: stride,
                mz,
                mz_stride: stride,
                power,
                power_stride: stride,
                adhesion,
                adhesion_stride: stride,
                status_detail: notices[first..].as_mut_ptr(),
                status_detail_stride: size_of::<i32>() as isize,
                ..no_batch()
            };
            let (inputs, outputs) = (Some(&inputs), Some(&outputs));
            // SAFETY: every array has at least `each` elements from `first` on.
            let status = unsafe { solve(inputs, each as u32, Some(&options), outputs, None) };
            assert!(status >= 0, "{status}");
        }
    };
    (Box::new(run), COUNT)
}

/// The reference.
struct Cases {
    open: Vec<Case>,
    slopes: Vec<SlopeCase>,
}

impl Cases {
    fn wrong(&self, force: &Errors, answer: &dyn Fn(&Case) -> Answer) -> Wrong {
        let slopes: Vec<f64> = self.slopes.iter().map(|case| case.error(answer).0).collect();
        Wrong { force: figures(&force.force), slope: figures(&slopes) }
    }
}

fn model_rows<F: Called>(model: Model, strips: StripCount, cases: &Cases, rows: &mut Vec<Row>) {
    let settings = options(model, strips);
    let errors = Errors::of_model::<F>(&cases.open, &settings);
    // (differences of numbers in single precision are too coarse for slopes; its derivatives are
    // not)
    let wrong = cases.wrong(&errors, &|case| answer::<f64>(case, &settings));
    let mut name = name(model).to_owned();
    if model == Model::Strip {
        name += &format!(", {} strips", strips as i32);
    }
    let hows = [How::Solve, How::Forces, How::Derivatives, How::Prepared];
    for how in hows.into_iter().chain(BATCHES.map(How::Batch)) {
        for set in SETS {
            let options = kstrip_options { model: model as i32, strips: strips as i32 };
            let (calls, count) = calls::<F>(how, set, options);
            let (name, precision) = (name.clone(), F::NAME);
            rows.push(Row { name, precision, how, set, wrong, calls, count, times: vec![] });
        }
    }
}

// --- the other methods -----------------------------------------------------------------------

/// FASTSIM compiled for AVX2: twelve lanes fill three registers of 256 bits (the last two are
/// idle). Only for processors that have them.
#[cfg(target_arch = "x86_64")]
fn fastsim_avx2<const M: usize>() -> Solver {
    #[target_feature(enable = "avx2")]
    fn wide<const M: usize>(grid: &Grid<M, M>, input: &Input) -> Output {
        fastsim::<M, M, 12>(grid, input, Flexibility::Three, Bound::Parabolic)
    }
    let grid = Grid::<M, M>::new(Layout::StripCentres);
    // SAFETY: the processor was asked.
    Box::new(move |input| unsafe { wide(&grid, input) })
}

/// Whether the processor has AVX2.
pub fn has_avx2() -> bool {
    #[cfg(target_arch = "x86_64")]
    return std::arch::is_x86_feature_detected!("avx2");
    #[cfg(not(target_arch = "x86_64"))]
    false
}

/// The method in whose time all others are told.
pub const SCALAR: &str = "FASTSIM 10x10, scalar";
/// The same, ten strips side by side.
pub const LANES: &str = "FASTSIM 10x10, ten lanes";
/// The same in registers of 256 bits.
pub const AVX2: &str = "FASTSIM 10x10, lanes of AVX2";

fn peers() -> Vec<(String, Solver)> {
    use Bound::Parabolic;
    use Flexibility::{Blended, Energy, Kalker, Three};
    use Layout::{Rectangle, StripCentres};
    let named = |text: &str, (_, solve): (String, Solver)| (text.to_owned(), solve);
    let mut peers = vec![
        named(SCALAR, fastsim_on::<10, 1>(StripCentres, Three, Parabolic)),
        named("FASTSIM 20x20, scalar", fastsim_on::<20, 1>(StripCentres, Three, Parabolic)),
        named("FASTSIM 50x50, scalar", fastsim_on::<50, 1>(StripCentres, Three, Parabolic)),
        named(LANES, fastsim_on::<10, 10>(StripCentres, Three, Parabolic)),
        named("FASTSIM 20x20, ten lanes", fastsim_on::<20, 10>(StripCentres, Three, Parabolic)),
        named("FASTSIM 50x50, ten lanes", fastsim_on::<50, 10>(StripCentres, Three, Parabolic)),
    ];
    #[cfg(target_arch = "x86_64")]
    if has_avx2() {
        peers.push((AVX2.to_owned(), fastsim_avx2::<10>()));
        peers.push(("FASTSIM 20x20, lanes of AVX2".to_owned(), fastsim_avx2::<20>()));
        peers.push(("FASTSIM 50x50, lanes of AVX2".to_owned(), fastsim_avx2::<50>()));
    }
    let blended = fastsim_on::<20, 10>(Rectangle, Blended, Parabolic);
    peers.extend([
        named("FASTSIM 20x20 as in CONTACT", blended),
        fastrip_on::<20, 20>(Kalker),
        fastrip_on::<80, 50>(Kalker),
        fastrip_on::<20, 20>(Energy),
        fastrip_on::<80, 50>(Energy),
        fastrip_contact_on::<20>(),
        fastrip_contact_on::<50>(),
        ("Shen-Hedrick-Elkins".to_owned(), Box::new(shen_hedrick_elkins::solve)),
        ("Polach".to_owned(), Box::new(polach::solve)),
        ("Vermeulen-Johnson (spin ignored)".to_owned(), Box::new(vermeulen_johnson::solve)),
    ]);
    peers
}

/// What the other methods are handed: their coefficients are ready-made.
fn peer_inputs(set: Set) -> Vec<Input> {
    inputs(set).iter().map(|(contact, creepage)| input_of(contact, creepage)).collect()
}

fn peer_rows(cases: &Cases, rows: &mut Vec<Row>) {
    let table = coefficient_cases();
    for (name, solve) in peers() {
        let solve = Rc::new(solve);
        let errors = peer_errors(&cases.open, &table, &solve);
        let wrong = cases.wrong(&errors, &|case| {
            let output = solve(&input(case, &[]));
            Answer { force: [output.fx, output.fy], moment: output.mz, stick: f64::NAN }
        });
        for set in SETS {
            let (name, inputs, solve) = (name.clone(), peer_inputs(set), solve.clone());
            let run = move || {
                for input in &inputs {
                    black_box(solve(input));
                }
            };
            let (how, calls) = (How::Solve, Box::new(run));
            let precision = "f64";
            let times = vec![];
            rows.push(Row { name, precision, how, set, wrong, calls, count: CALLS, times });
        }
    }
}

/// Every model and every other method, in the order of the report.
pub fn rows() -> Vec<Row> {
    let cases = Cases { open: open(), slopes: slope_cases() };
    let mut rows = Vec::new();
    for model in Model::ALL {
        let eight = (model == Model::Strip).then_some(StripCount::Eight);
        for strips in [StripCount::Sixteen].into_iter().chain(eight) {
            model_rows::<f64>(model, strips, &cases, &mut rows);
            model_rows::<f32>(model, strips, &cases, &mut rows);
        }
    }
    peer_rows(&cases, &mut rows);
    rows
}
