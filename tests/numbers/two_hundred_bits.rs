//! Every model, patches of strips, falling friction and layers against their own formulas in 200
//! bits, by region, in double and single precision: what the arithmetic loses, derivatives
//! included. docs/evidence/rounding.md states and explains the errors; four times as much is too
//! much.
//!
//! `KSTRIP_WRITE_PRECISE=120 cargo test --config tests/plain.toml --test numbers two_hundred_bits
//! -- --nocapture` looks for worse cases, prints the table of that page, and writes the worst
//! inputs to `tests/data/precise.csv`. Without it those are computed again, and a few new ones.

use crate::precise::Precise;
use kstrip::forces::derivatives::solve_jacobian;
use kstrip::patch::friction;
use kstrip::strip_1967::strip::adhesion_length;
use kstrip_testing::names::problem;
use kstrip_testing::prelude::*;

/// `a, b, N, G, ν, μ, υx, υy, φ, V`: numbers of single precision, so that one reference serves both
/// precisions.
type Inputs = [f32; 10];

fn contact<F: Float>(inputs: &Inputs) -> (Contact<F>, Creepage<F>) {
    let mut numbers = inputs.map(F::widened);
    numbers[9] = F::zero();
    problem(numbers)
}

/// What is asked about the inputs.
#[derive(Clone, Copy, PartialEq)]
enum Road {
    /// Forces of the contact.
    Contact,
    /// The same by the strips of a patch.
    Patch(Strips),
    /// Friction that falls with the slip.
    Falling,
    /// Friction that falls, on a patch.
    FallingPatch(Strips),
    /// Constant friction behind a layer that sliding softens.
    Layer,
    /// The same on a patch.
    LayerPatch(Strips),
}

/// Strips of a patch.
#[derive(Clone, Copy, PartialEq)]
enum Strips {
    /// Those of the ellipse.
    Ellipse,
    /// The same with three coefficients of friction side by side.
    Banded,
    /// Of four widths, their centres on an arc.
    Unequal,
}

/// Strips but those of the ellipse are numbers of single precision, as all inputs.
fn patch<F: Float>(strips: Strips, inputs: &Inputs) -> Patch<F> {
    let (contact, _) = contact::<F>(inputs);
    let exact = |contact: &Contact<f32>| Patch::from_ellipse(contact, StripCount::Sixteen);
    let single = self::contact::<f32>(inputs).0;
    let Contact { a, b, friction, .. } = single;
    let (strips, scale): (Vec<PatchStrip<f32>>, _) = match strips {
        Strips::Ellipse => {
            return Patch::from_ellipse(&contact, StripCount::Sixteen).expect("a patch");
        }
        Strips::Banded => {
            let patch = exact(&single).expect("a patch");
            let bands = [1.0, 0.25, 0.5].map(|share| share * friction);
            let banded = |(i, strip): (usize, &PatchStrip<f32>)| PatchStrip {
                friction: bands[i / 6],
                ..*strip
            };
            let scale = [patch.area_scale, patch.lever_scale];
            (patch.used().iter().enumerate().map(banded).collect(), scale)
        }
        Strips::Unequal => {
            let mut edge = -b;
            let strip = |i: usize| {
                let width = [1.0, 2.0, 0.5, 1.5][i % 4] * b / 10.0;
                let y = edge + width / 2.0;
                edge += width;
                let chord = (1.0 - (y / b).powi(2)).sqrt();
                let (half_length, peak_pressure) = (a * chord, single.peak_pressure() * chord);
                PatchStrip {
                    y,
                    width,
                    half_length,
                    centre_x: 0.2 * y / b * (y * a / b),
                    peak_pressure,
                    friction,
                }
            };
            ((0..16).map(strip).collect(), [1.0, 1.0])
        }
    };
    let widened = |strip: PatchStrip<f32>| {
        let PatchStrip { y, width, half_length, centre_x, peak_pressure, friction } = strip;
        let [y, width, half_length, centre_x, peak_pressure, friction] =
            [y, width, half_length, centre_x, peak_pressure, friction].map(F::widened);
        PatchStrip { y, width, half_length, centre_x, peak_pressure, friction }
    };
    let strips: Vec<_> = strips.into_iter().map(widened).collect();
    let [area_scale, lever_scale] = scale.map(F::widened);
    let patch = Patch::from_strips(&strips, contact.shear_modulus, contact.poisson_ratio);
    Patch { area_scale, lever_scale, ..patch.expect("a patch") }
}

/// What the library answers in numbers of a kind: `F_x, F_y, M_z` and their derivatives with
/// respect to the creepages.
type Answer<F> = ([F; 3], [[F; 3]; 3]);

fn answer<F: Float>(road: Road, model: Model, inputs: &Inputs) -> Result<Answer<F>, Error> {
    let (contact, creepage) = contact::<F>(inputs);
    let options = Options { model, strips: StripCount::Sixteen };
    let law = SlipFriction {
        friction: contact.friction,
        ratio: F::of(0.25),
        decay: F::of(0.5),
        rolling_speed: F::widened(inputs[9]),
        slope_factor: F::of(0.5),
        slide_factor: F::zero(),
        layer: F::zero(),
    };
    // (as flexible as the bodies, about)
    let layer = SlipFriction {
        decay: F::zero(),
        slide_factor: F::of(0.5),
        layer: F::widened(inputs[0] * 0.5 / inputs[3]),
        ..law
    };
    // (nalgebra counts columns first)
    let rows = |by: Matrix3<F>| -> [[F; 3]; 3] { by.transpose().into() };
    let (found, slopes) = match road {
        Road::Contact => {
            let (found, slopes) = solve_jacobian(&contact, &creepage, &options)?;
            (found, rows(slopes))
        }
        Road::Patch(strips) => {
            let patch = patch(strips, inputs);
            let found = friction::differentiate_patch(&patch.view()?, &creepage, None, model)?;
            (found.solution, found.derivatives.jacobian)
        }
        Road::Falling => {
            let found = differentiate_with_law(&contact, &creepage, Some(&law), &options)?;
            (found.solution, found.derivatives.jacobian)
        }
        Road::Layer => {
            let found = differentiate_with_law(&contact, &creepage, Some(&layer), &options)?;
            (found.solution, found.derivatives.jacobian)
        }
        Road::FallingPatch(strips) | Road::LayerPatch(strips) => {
            let law = if matches!(road, Road::LayerPatch(_)) { layer } else { law };
            let patch = patch(strips, inputs);
            let found =
                friction::differentiate_patch(&patch.view()?, &creepage, Some(&law), model)?;
            (found.solution, found.derivatives.jacobian)
        }
    };
    Ok(([found.fx, found.fy, found.mz], slopes))
}

/// Where inputs come from.
const REGIONS: [&str; 8] =
    ["ordinary", "small", "tiny", "sliding", "spin", "pure spin", "opposed", "slender"];

/// A case of a region: Kalker's parameters first, then the creepages that they are on the contact.
fn draw(region: &str, random: &mut Random) -> Inputs {
    let ratio = match region {
        "slender" => random.log_between(1e-3, 1e3),
        _ => random.log_between(0.1, 10.0),
    };
    let b = random.log_between(1e-3, 1e-2);
    let contact = Contact {
        a: b * ratio,
        b,
        normal_force: b * b * ratio * random.log_between(5e8, 5e9),
        shear_modulus: 82e9 * random.log_between(0.1, 2.0),
        poisson_ratio: random.between(0.0, 0.5),
        friction: random.between(0.05, 0.8),
        mismatch: 0.0,
    };
    let linear = LinearCoefficients::at(ratio, contact.poisson_ratio);
    let mut signed = |low, high| random.sign() * random.log_between(low, high);
    let [mut xi, mut eta, mut psi] = [signed(1e-2, 2.0), signed(1e-2, 2.0), signed(1e-2, 0.9)];
    match region {
        "small" => (xi, eta, psi) = (xi * 1e-6, eta * 1e-6, psi * 1e-6),
        "tiny" => (xi, eta, psi) = (xi * 1e-15, eta * 1e-15, psi * 1e-15),
        "sliding" => (xi, eta) = (signed(10.0, 1e3), signed(10.0, 1e3)),
        "spin" => psi = signed(0.9, 3.0),
        // (from unit spin on the theory of 1967 has an infinite derivative by η there)
        "pure spin" => (xi, eta, psi) = (0.0, 0.0, signed(1e-2, 0.99)),
        // C22 vy + C23 φ cancels to 1e-5, with vy = 3η/π and φ = (3/π) √(b/a) ψ
        "opposed" => {
            xi *= 1e-3;
            eta = -psi * linear.c23 / (linear.c22 * ratio.sqrt()) * (1.0 + signed(1e-6, 1e-4));
        }
        _ => {}
    }
    let parameters =
        Parameters { xi, eta, psi, poisson_ratio: contact.poisson_ratio, axis_ratio: ratio };
    let Creepage { longitudinal, lateral, spin } = parameters.creepage(&contact);
    let Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, .. } = contact;
    let speed = random.log_between(1.0, 100.0);
    [a, b, normal_force, shear_modulus, poisson_ratio, friction, longitudinal, lateral, spin, speed]
        .map(|x| x as f32)
}

/// Largest errors of the force, of the moment and of the derivatives in units of the last place.
///
/// One unit is a rounding of the result or of a creepage: of the force vector, or of
/// `Σ |∂F/∂cᵢ| |cᵢ|` where forces of several creepages cancel. For the moment the force times the
/// larger semi-axis counts as well. For derivatives it is that of the column, or of the force over
/// the rigid slip.
fn errors<F: Float>(inputs: &Inputs, found: Answer<F>, exact: &Answer<Precise>) -> [f64; 3] {
    let (contact, creepage) = contact::<F>(inputs);
    let (found, jacobian) = (found.0.map(Float::to_f64), found.1.map(|row| row.map(Float::to_f64)));
    let (exact, exact_slopes) = exact;
    let arm = contact.a.to_f64().max(contact.b.to_f64());
    let motion = [creepage.longitudinal, creepage.lateral, creepage.spin].map(|c| c.to_f64().abs());
    let rigid_slip = motion[0] + motion[1] + motion[2] * arm;

    let rows = exact.map(Float::to_f64);
    let columns: [[f64; 3]; 3] = std::array::from_fn(|i| exact_slopes.map(|row| row[i].to_f64()));
    let force = |[x, y, _]: [f64; 3]| x.hypot(y);
    // Σ |∂F/∂cᵢ| |cᵢ|
    let moved: f64 = columns.iter().zip(motion).map(|(column, c)| force(*column) * c).sum();
    let turned: f64 = columns.iter().zip(motion).map(|(column, c)| column[2].abs() * c).sum();
    let size = force(rows).max(moved);
    // (spin alone may carry nothing: then a rounding of the bound)
    let size = if size > 0.0 { size } else { contact.friction_bound().to_f64() };
    let moment = rows[2].abs().max(turned).max(size * arm);
    let epsilon = F::EPSILON.to_f64();
    let distances = |exact: [Precise; 3], found: [f64; 3], [x, m]: [f64; 2]| -> [f64; 2] {
        let error = |i: usize, unit: f64| exact[i].distance(found[i], unit * epsilon).abs();
        [error(0, x).max(error(1, x)), error(2, m)]
    };
    let [of_force, of_moment] = distances(*exact, found, [size, moment]);
    let mut of_slopes = 0.0_f64;
    for (i, column) in columns.iter().enumerate() {
        let found = jacobian.map(|row| row[i]);
        let slope = size / rigid_slip * [1.0, 1.0, arm][i];
        let unit = force(*column).max(slope);
        let units = [unit, column[2].abs().max(unit * arm)];
        let exact = exact_slopes.map(|row| row[i]);
        of_slopes = distances(exact, found, units).into_iter().fold(of_slopes, f64::max);
    }
    [of_force, of_moment, of_slopes]
}

fn both(road: Road, model: Model, inputs: &Inputs) -> [[f64; 3]; 2] {
    fn solved<F: Float>(road: Road, model: Model, inputs: &Inputs) -> Answer<F> {
        answer(road, model, inputs)
            .unwrap_or_else(|e| panic!("{e:?} {} {inputs:?}", size_of::<F>()))
    }
    Precise::forget();
    let exact = solved::<Precise>(road, model, inputs);
    [
        errors::<f64>(inputs, solved(road, model, inputs), &exact),
        errors::<f32>(inputs, solved(road, model, inputs), &exact),
    ]
}

const MODELS: [(Model, &str); 5] = [
    (Model::Strip1967, "STRIP_1967"),
    (Model::Strip1967Continuous, "STRIP_1967_CONTINUOUS"),
    (Model::Strip, "STRIP"),
    (Model::Total, "TOTAL"),
    (Model::Linear, "LINEAR"),
];
const ROADS: [(Road, &str); 8] = [
    (Road::Contact, ""),
    (Road::Patch(Strips::Ellipse), ": ellipse"),
    (Road::Patch(Strips::Banded), ": bands"),
    (Road::Patch(Strips::Unequal), ": unequal"),
    (Road::Falling, ": falling"),
    (Road::FallingPatch(Strips::Unequal), ": unequal and falling"),
    (Road::Layer, ": layer"),
    (Road::LayerPatch(Strips::Unequal), ": unequal behind a layer"),
];

/// Roads, models and regions that are checked.
fn surveyed() -> impl Iterator<Item = (Road, Model, &'static str, String)> {
    let all = ROADS.into_iter().flat_map(|(road, of)| {
        MODELS.into_iter().flat_map(move |(model, name)| {
            REGIONS.map(|region| (road, model, region, format!("{name}{of}")))
        })
    });
    all.filter(|(road, model, region, _)| {
        *road == Road::Contact
            || matches!(model, Model::Strip1967Continuous | Model::Strip | Model::Total)
                && matches!(*region, "ordinary" | "small" | "sliding" | "spin")
    })
}

/// Errors of some cases, of both precisions: sums, and the largest with the inputs that have it.
#[derive(Default)]
struct Survey {
    cases: u32,
    sums: [[f64; 3]; 2],
    worst: [[(f64, Inputs); 3]; 2],
}

impl Survey {
    fn add(&mut self, road: Road, model: Model, inputs: &Inputs) {
        let found = both(road, model, inputs);
        self.cases += 1;
        for (i, errors) in found.iter().enumerate() {
            for (j, error) in errors.iter().enumerate() {
                self.sums[i][j] += error;
                if !(*error <= self.worst[i][j].0) {
                    self.worst[i][j] = (*error, *inputs);
                }
            }
        }
    }

    /// Mean and worst errors.
    fn row(&self) -> String {
        let text = |x: f64| if x < 99.95 { format!("{x:.1}") } else { format!("{x:.0}") };
        let pairs = self.sums.as_flattened().iter().zip(self.worst.as_flattened());
        let cells = pairs.map(|(sum, (worst, _))| {
            format!(" {} / {} |", text(sum / f64::from(self.cases)), text(*worst))
        });
        cells.collect()
    }
}

/// The worst errors that docs/evidence/rounding.md states in the row that begins so, none if there
/// is no such row.
pub fn stated(start: &str) -> Vec<f64> {
    let text = include_str!("../../docs/evidence/rounding.md");
    let row = text.lines().find_map(|row| row.strip_prefix(start));
    let cells = row.unwrap_or_default().split('|');
    cells.filter_map(|cell| cell.rsplit('/').next()?.trim().parse().ok()).collect()
}

/// Whether an error is no worse than four times what is stated: another order of the same sums
/// finds others.
pub fn is_known(error: f64, stated: f64) -> bool {
    error <= 4.0 * stated + 1.0
}

#[test]
fn errors_are_the_known_ones() {
    let path = root().join("tests/data/precise.csv");
    let search = std::env::var("KSTRIP_WRITE_PRECISE");
    let search: Option<u32> = search.ok().map(|cases| cases.parse().expect("a number of cases"));
    let known = if search.is_some() { String::new() } else { read(&path) };
    let mut text = String::new();
    println!(
        "| model | region | f64: force | moment | derivatives | f32: force | moment | derivatives |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for (road, model, region, name) in surveyed() {
        let mut survey = Survey::default();
        let start = format!("{name},{region},");
        for line in known.lines().filter_map(|line| line.strip_prefix(&start)) {
            let mut numbers = line.split(',').map(|x| x.parse().expect("a number"));
            survey.add(road, model, &[(); 10].map(|()| numbers.next().expect("ten numbers")));
        }
        assert!(search.is_some() || survey.cases > 0, "no known cases of {name}, {region}");
        let mut random = Random::new(if search.is_some() { 200 } else { 53 });
        for _ in 0..search.unwrap_or(2) {
            survey.add(road, model, &draw(region, &mut random));
        }
        let row = format!("| {name} | {region} |");
        println!("{row}{}", survey.row());
        let found = survey.worst.as_flattened();
        let mut inputs: Vec<Inputs> = found.iter().map(|(_, inputs)| *inputs).collect();
        inputs.sort_by(|p, q| p.partial_cmp(q).expect("numbers"));
        inputs.dedup();
        for inputs in inputs {
            let numbers = inputs.map(|x| format!("{x:e}")).join(",");
            text += &format!("{start}{numbers}\n");
        }
        let known = if search.is_none() { stated(&row) } else { vec![f64::INFINITY; 6] };
        assert_eq!(known.len(), found.len(), "{row}");
        for ((error, inputs), known) in found.iter().zip(known) {
            assert!(
                is_known(*error, known),
                "{row} {error} units of the last place, {known} is stated: {inputs:?}"
            );
        }
    }
    if search.is_some() {
        std::fs::write(path, text).expect("tests/data is writable");
    }
}

/// The numbers of 200 bits against references that mpmath computed by another formula
/// (`make_numerics.py`).
#[test]
fn adhesion_lengths_agree_with_mpmath() {
    let rows = read("tests/data/numerics.csv");
    let mut compared = 0;
    for row in rows.lines().filter(|row| row.starts_with("kappa,")) {
        let numbers: Vec<f64> = row.split(',').skip(2).map(|x| x.parse().expect("x")).collect();
        let [xi, eta, psi] = [0, 1, 2].map(|i| Precise::Double(numbers[i]));
        let [high, low] = [6, 7].map(|i| Precise::Double(numbers[i]));
        let kappa = adhesion_length(xi, eta, psi).expect("a length");
        let error = (kappa - high - low).distance(0.0, numbers[6]).abs();
        // the reference is the sum of two doubles
        assert!(error < 1e-31, "{row}: {error:e}");
        compared += 1;
    }
    assert_eq!(compared, 360);
    Precise::forget();
}
