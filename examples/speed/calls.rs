//! What is measured: 512 calls of every model through the C interface, and of every other method.

use crate::names::*;
use crate::peer_methods::*;
use crate::peers::fastsim::{Bound, Flexibility, Layout};
use crate::peers::{self, polach, shen_hedrick_elkins, vermeulen_johnson};
use crate::reference::*;
use kstrip::contact::Contact;
use kstrip::contact::creepage::Creepage;
use kstrip::contact::forces::StripCount;
use kstrip::ffi::types::Outputs;
use kstrip::friction::SlipFriction;
use kstrip::linear::LinearCoefficients;
use kstrip::solve::model::{Model, Solution};
use std::hint::black_box;
use std::mem::MaybeUninit;

/// Calls per measurement.
pub const CALLS: usize = 512;

/// What a row of the report belongs to.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// A model in double precision.
    Double(Model),
    /// A model in single precision.
    Single(Model),
    /// A model with its derivatives in double precision; their errors are those of the forces.
    Jacobian(Model),
    /// The same in single precision.
    JacobianSingle(Model),
    /// A model in double precision through `kstrip_evaluate`, forces alone.
    Forces(Model),
    /// The same in single precision.
    ForcesSingle(Model),
    /// A contact of a batch of [`CALLS`], as structures, in double precision.
    Batch(Model),
    /// The same in single precision.
    BatchSingle(Model),
    /// A contact of a batch as arrays, in double precision.
    Arrays(Model),
    /// The same in single precision.
    ArraysSingle(Model),
    /// The classical loop of FASTSIM, one strip after the other.
    FastsimScalar,
    /// FASTSIM, ten strips side by side.
    FastsimLanes,
    /// The same with the elliptic bound.
    FastsimElliptic,
    /// The same with the one flexibility of 1982.
    FastsimSingle,
    /// The same as CONTACT has it.
    FastsimBlended,
    /// FaStrip, ten strips side by side.
    Fastrip,
    /// The same as CONTACT has it.
    FastripBlended,
    /// Closed forms.
    ClosedForm,
}

/// A method with one setting, and what was found about it.
pub struct Row {
    pub family: Family,
    pub name: String,
    /// Strips of a model that has them.
    pub strips: Option<i32>,
    pub calls: Box<dyn Fn() -> f64>,
    /// Errors of the force on `open.csv`.
    pub errors: Figures,
    /// Nanoseconds per call, round by round.
    pub times: Vec<f64>,
    /// Instructions per call.
    pub instructions: Option<f64>,
}

impl Row {
    fn new(family: Family, name: String, calls: Box<dyn Fn() -> f64>, errors: &Errors) -> Self {
        let errors = figures(&errors.force);
        Self { family, name, strips: None, calls, errors, times: vec![], instructions: None }
    }

    /// Whether the short report needs it.
    pub fn is_short(&self) -> bool {
        use Family::*;
        match self.family {
            FastsimScalar | FastsimLanes => self.name.contains(" 10x10"),
            FastsimElliptic | FastsimSingle | FastsimBlended | Fastrip | FastripBlended
            | ClosedForm => false,
            _ => matches!(self.strips, None | Some(8 | 16)),
        }
    }

    /// Nanoseconds per call: the round in the middle.
    pub fn time(&self) -> f64 {
        median(&self.times)
    }

    /// The quickest round.
    pub fn least(&self) -> f64 {
        self.times.iter().copied().fold(f64::INFINITY, f64::min)
    }
}

pub fn median(times: &[f64]) -> f64 {
    let mut sorted = times.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Creepages from partial slip to sliding, by the golden ratio and its relatives.
pub fn creepages() -> Vec<[f64; 3]> {
    let spread = |i: usize, step: f64| (i as f64 * step).fract() - 0.5;
    (0..CALLS)
        .map(|i| {
            [spread(i, 0.618_034) * 8e-3, spread(i, 0.381_966) * 8e-3, spread(i, 0.271_828) * 1.5]
        })
        .collect()
}

/// Semi-axes \[m\], load \[N\], shear modulus \[Pa\], Poisson's ratio, friction.
pub const CONTACT: [f64; 6] = [6e-3, 4e-3, 80e3, 82e9, 0.28, 0.3];

/// Calls through a pointer that the compiler knows nothing of, as from C. The numbers of both precisions are
/// written once.
macro_rules! through_c {
    (
        $solve:ident, $jacobian:ident, $functions:ident, $float:ty, $contact:ident, $creepage:ident,
        $outputs:ident
    ) => {
        fn $solve(model: Model, strips: StripCount) -> Box<dyn Fn() -> f64> {
            let options = kstrip_options { model: model as i32, strips: strips as i32 };
            let (contact, creepages) = ($contact(), $creepage());
            let solve = black_box($functions.0);
            Box::new(move || {
                let mut result = MaybeUninit::uninit();
                let mut worst = 0;
                for creepage in &creepages {
                    let status =
                        solve(Some(&contact), Some(creepage), Some(&options), Some(&mut result));
                    worst = status.min(worst);
                }
                black_box(&result);
                f64::from(worst)
            })
        }

        fn $jacobian(model: Model, strips: StripCount) -> Box<dyn Fn() -> f64> {
            let options = kstrip_options { model: model as i32, strips: strips as i32 };
            let (contact, creepages) = ($contact(), $creepage());
            let solve = black_box($functions.1);
            Box::new(move || {
                let mut result = MaybeUninit::uninit();
                let mut slopes = MaybeUninit::uninit();
                let outputs = $outputs {
                    result: result.as_mut_ptr(),
                    derivatives: slopes.as_mut_ptr(),
                    ..nowhere()
                };
                let mut worst = 0;
                for creepage in &creepages {
                    // SAFETY: both places are there.
                    let status = unsafe {
                        solve(Some(&contact), Some(creepage), None, Some(&options), Some(&outputs))
                    };
                    worst = status.min(worst);
                }
                black_box((&result, &slopes));
                f64::from(worst)
            })
        }
    };
}

type Solve<C, K, R> = extern "C" fn(
    Option<&C>,
    Option<&K>,
    Option<&kstrip_options>,
    Option<&mut MaybeUninit<R>>,
) -> i32;
type Evaluate<C, K, L, O> = unsafe extern "C" fn(
    Option<&C>,
    Option<&K>,
    Option<&L>,
    Option<&kstrip_options>,
    Option<&O>,
) -> i32;

type Functions<F> = (
    Solve<Contact<F>, Creepage<F>, Solution<F>>,
    Evaluate<Contact<F>, Creepage<F>, SlipFriction<F>, Outputs<F>>,
);

const DOUBLE: Functions<f64> = (kstrip_solve, kstrip_evaluate);
const SINGLE: Functions<f32> = (kstrip_solve_f32, kstrip_evaluate_f32);

pub fn contact_f64() -> kstrip_contact {
    let [a, b, normal_force, shear_modulus, poisson_ratio, friction] = CONTACT;
    kstrip_contact { a, b, normal_force, shear_modulus, poisson_ratio, friction }
}

pub fn creepages_f64() -> Vec<kstrip_creepage> {
    let of =
        |[longitudinal, lateral, spin]: [f64; 3]| kstrip_creepage { longitudinal, lateral, spin };
    creepages().into_iter().map(of).collect()
}

fn contact_f32() -> kstrip_contact_f32 {
    let [a, b, normal_force, shear_modulus, poisson_ratio, friction] = CONTACT.map(|x| x as f32);
    kstrip_contact_f32 { a, b, normal_force, shear_modulus, poisson_ratio, friction }
}

fn creepages_f32() -> Vec<kstrip_creepage_f32> {
    let of = |[longitudinal, lateral, spin]: [f32; 3]| kstrip_creepage_f32 {
        longitudinal,
        lateral,
        spin,
    };
    creepages().into_iter().map(|k| of(k.map(|x| x as f32))).collect()
}

through_c!(solve_f64, jacobian_f64, DOUBLE, f64, contact_f64, creepages_f64, kstrip_outputs);
through_c!(solve_f32, jacobian_f32, SINGLE, f32, contact_f32, creepages_f32, kstrip_outputs_f32);

pub fn has_strips(model: Model) -> bool {
    !matches!(model, Model::Total | Model::Linear)
}

fn models(open: &[Case]) -> Vec<Row> {
    let mut rows = Vec::new();
    for model in Model::ALL {
        for strips in COUNTS {
            let sixteen = strips == StripCount::Sixteen;
            if !has_strips(model) && !sixteen {
                continue;
            }
            let options = options(model, strips);
            let count = has_strips(model).then_some(strips as i32);
            let (f64, f32) =
                (Errors::of_model::<f64>(open, &options), Errors::of_model::<f32>(open, &options));
            let mut add = |family, calls, errors: &Errors| {
                let what = match family {
                    Family::Forces(_) | Family::ForcesSingle(_) => ", forces alone",
                    Family::Batch(_) | Family::BatchSingle(_) => ", batch",
                    Family::Arrays(_) | Family::ArraysSingle(_) => ", batch of arrays",
                    _ => "",
                };
                let row = Row::new(family, name(model).to_owned() + what, calls, errors);
                rows.push(Row { strips: count, ..row });
            };
            add(Family::Double(model), solve_f64(model, strips), &f64);
            add(Family::Single(model), solve_f32(model, strips), &f32);
            if sixteen {
                use crate::together::{How, in_double, in_single};
                let hows = [
                    (How::ForcesAlone, Family::Forces(model), Family::ForcesSingle(model)),
                    (How::Structures, Family::Batch(model), Family::BatchSingle(model)),
                    (How::Arrays, Family::Arrays(model), Family::ArraysSingle(model)),
                ];
                for (how, in_f64, in_f32) in hows {
                    add(in_f64, in_double::calls(CALLS, model, how), &f64);
                    add(in_f32, in_single::calls(CALLS, model, how), &f32);
                }
                add(Family::Jacobian(model), jacobian_f64(model, strips), &f64);
                add(Family::JacobianSingle(model), jacobian_f32(model, strips), &f32);
            }
        }
    }
    rows
}

fn others(open: &[Case]) -> Vec<Row> {
    use Bound::{Elliptic, Parabolic};
    use Family::*;
    use Flexibility::{Blended, Energy, Kalker, Three};
    use Layout::{Rectangle, StripCentres};
    let methods: Vec<(Family, (String, Solver))> = vec![
        (FastsimScalar, fastsim_on::<10, 1>(StripCentres, Three, Parabolic)),
        (FastsimScalar, fastsim_on::<20, 1>(StripCentres, Three, Parabolic)),
        (FastsimScalar, fastsim_on::<50, 1>(StripCentres, Three, Parabolic)),
        (FastsimLanes, fastsim_on::<10, 10>(StripCentres, Three, Parabolic)),
        (FastsimLanes, fastsim_on::<20, 10>(StripCentres, Three, Parabolic)),
        (FastsimLanes, fastsim_on::<50, 10>(StripCentres, Three, Parabolic)),
        (FastsimElliptic, fastsim_on::<10, 10>(StripCentres, Three, Elliptic)),
        (FastsimElliptic, fastsim_on::<50, 10>(StripCentres, Three, Elliptic)),
        (FastsimSingle, fastsim_on::<10, 10>(StripCentres, Kalker, Parabolic)),
        (FastsimBlended, fastsim_on::<10, 10>(Rectangle, Blended, Parabolic)),
        (FastsimBlended, fastsim_on::<20, 10>(Rectangle, Blended, Parabolic)),
        (FastsimBlended, fastsim_on::<50, 10>(Rectangle, Blended, Parabolic)),
        (Fastrip, fastrip_on::<20, 20>(Energy)),
        (Fastrip, fastrip_on::<80, 50>(Energy)),
        (FastripBlended, fastrip_contact_on::<20>()),
        (FastripBlended, fastrip_contact_on::<50>()),
        (ClosedForm, ("Shen-Hedrick-Elkins".into(), Box::new(shen_hedrick_elkins::solve))),
        (ClosedForm, ("Polach".into(), Box::new(polach::solve))),
        (ClosedForm, ("Vermeulen-Johnson".into(), Box::new(vermeulen_johnson::solve))),
    ];
    let table = coefficient_cases();
    let [a, b, normal_force, shear_modulus, poisson_ratio, friction] = CONTACT;
    let LinearCoefficients { c11, c22, c23, .. } = LinearCoefficients::at(a / b, poisson_ratio);
    let inputs: Vec<peers::Input> = creepages()
        .into_iter()
        .map(|[longitudinal, lateral, spin]| peers::Input {
            a,
            b,
            normal_force,
            shear_modulus,
            poisson_ratio,
            friction,
            longitudinal,
            lateral,
            spin,
            c11,
            c22,
            c23,
        })
        .collect();
    methods
        .into_iter()
        .map(|(family, (name, solve))| {
            let errors = peer_errors(open, &table, &solve);
            let inputs = inputs.clone();
            let calls = move || {
                for input in &inputs {
                    black_box(solve(input));
                }
                0.0
            };
            let lanes = match family {
                FastsimScalar => ", scalar",
                FastsimLanes => ", ten lanes",
                _ => "",
            };
            Row::new(family, name + lanes, Box::new(calls), &errors)
        })
        .collect()
}

/// Every model and every other method, in the order of the report.
pub fn rows(open: &[Case]) -> Vec<Row> {
    let mut rows = models(open);
    rows.extend(others(open));
    rows
}
