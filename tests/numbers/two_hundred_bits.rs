//! Every model against its own formulas in 200 bits, by region, in double and single precision: what the arithmetic
//! loses, derivatives included. The limits are what docs/numerics.md explains.
//!
//! `KSTRIP_WRITE_PRECISE=120 cargo test --test numbers two_hundred_bits -- --nocapture` looks for worse cases, prints the table of
//! that page, and writes the worst inputs to `tests/data/precise.csv`. Without it those are computed again, and a few new ones.

use crate::precise;
use crate::random;

use kstrip::contact::Contact;
use kstrip::contact::creepage::{Creepage, Parameters};
use kstrip::contact::forces::StripCount;
use kstrip::contact::forces::Totals;
use kstrip::linear::LinearCoefficients;
use kstrip::number::dual::Dual;
use kstrip::number::{Arithmetic, Float, Real};
use kstrip::solve::model::{Model, Options, Precision, solve_jacobian};
use kstrip::strip::PreparedStrips;
use kstrip::strip_1967;
use kstrip::strip_1967::strip::{SlidingRule, adhesion_length};
use kstrip::total::Prepared;
use precise::Precise;
use random::Random;

/// `a, b, N, G, ν, μ, υx, υy, φ`: numbers of single precision, so that one reference serves both precisions.
type Inputs = [f32; 9];

fn contact<F: Float>(inputs: &Inputs) -> (Contact<F>, Creepage<F>) {
    let [a, b, normal_force, shear_modulus, poisson_ratio, friction, longitudinal, lateral, spin] =
        inputs.map(F::widened);
    (
        Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction },
        Creepage { longitudinal, lateral, spin },
    )
}

/// `F_x, F_y, M_z` and their derivatives.
fn exact<T: Real<Base = Precise>>(
    model: Model,
    contact: &Contact<Precise>,
    creepage: &Creepage<T>,
) -> [T; 3] {
    let parameters = Parameters::new(contact, creepage);
    let (g, nu, v) = (parameters.axis_ratio, parameters.poisson_ratio, parameters.normalised());
    let linear = LinearCoefficients::at(g, nu);
    let radius = (contact.a * contact.b).sqrt();
    let (unit, [fx, fy, mz]) = match model {
        Model::Linear => {
            let LinearCoefficients { c11, c22, c23, c33 } = linear;
            let Creepage { longitudinal, lateral, spin } = *creepage;
            let spin = spin.scale(radius);
            let fy = lateral.scale(c22) + spin.scale(c23);
            let mz = spin.scale(c33) - lateral.scale(c23);
            // G a b
            (contact.shear_modulus * radius * radius, [longitudinal.scale(c11), fy, mz])
        }
        Model::Total => {
            let Totals { fx, fy, mz, .. } = Prepared::new(g, nu, &linear).totals(v);
            (contact.friction_bound(), [fx, fy, mz])
        }
        Model::Strip => {
            let strips = PreparedStrips::new(g, nu, &linear, StripCount::Sixteen);
            let found = strips.totals(v);
            (contact.friction_bound(), [found.fx, found.fy, found.mz])
        }
        _ => {
            let continuous = model == Model::Strip1967Continuous;
            let rule = if continuous { SlidingRule::Continuous } else { SlidingRule::RigidSlip };
            let found = strip_1967::totals(&parameters, rule);
            (contact.friction_bound(), [found.fx, found.fy, found.mz])
        }
    };
    [fx.scale(unit), fy.scale(unit), mz.scale(unit * radius)]
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
    let Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction } = contact;
    [a, b, normal_force, shear_modulus, poisson_ratio, friction, longitudinal, lateral, spin]
        .map(|x| x as f32)
}

/// Largest errors of the force, of the moment and of the derivatives in units of the last place.
///
/// One unit is a rounding of the result or of a creepage: of the force vector, or of `Σ |∂F/∂cᵢ| |cᵢ|` where forces of
/// several creepages cancel. For the moment the force times the larger semi-axis counts as well. For derivatives it is that of the
/// column, or of the force over the rigid slip.
fn errors<F: Precision>(model: Model, inputs: &Inputs, exact: &[Dual<Precise, 3>; 3]) -> [f64; 3] {
    let (contact, creepage) = contact::<F>(inputs);
    let options = Options { model, strips: StripCount::Sixteen };
    let (r, jacobian) = solve_jacobian(&contact, &creepage, &options)
        .unwrap_or_else(|e| panic!("{e:?} {} {inputs:?}", size_of::<F>()));
    let found = [r.fx, r.fy, r.mz].map(Float::to_f64);
    let arm = contact.a.to_f64().max(contact.b.to_f64());
    let motion = [creepage.longitudinal, creepage.lateral, creepage.spin].map(|c| c.to_f64().abs());
    let rigid_slip = motion[0] + motion[1] + motion[2] * arm;

    let rows = exact.map(|x| x.value.to_f64());
    let columns: [[f64; 3]; 3] = std::array::from_fn(|i| exact.map(|x| x.gradient[i].to_f64()));
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
    let [of_force, of_moment] = distances(exact.map(|x| x.value), found, [size, moment]);
    let mut of_slopes = 0.0_f64;
    for (i, column) in columns.iter().enumerate() {
        let found = [0, 1, 2].map(|row| jacobian[(row, i)].to_f64());
        let slope = size / rigid_slip * [1.0, 1.0, arm][i];
        let unit = force(*column).max(slope);
        let units = [unit, column[2].abs().max(unit * arm)];
        let exact = exact.map(|x| x.gradient[i]);
        of_slopes = distances(exact, found, units).into_iter().fold(of_slopes, f64::max);
    }
    [of_force, of_moment, of_slopes]
}

/// Both precisions.
fn both(model: Model, inputs: &Inputs) -> [[f64; 3]; 2] {
    Precise::forget();
    let (contact, creepage) = contact::<Precise>(inputs);
    let exact = exact(model, &contact, &creepage.inputs());
    [errors::<f64>(model, inputs, &exact), errors::<f32>(model, inputs, &exact)]
}

const MODELS: [(Model, &str); 5] = [
    (Model::Strip1967, "STRIP_1967"),
    (Model::Strip1967Continuous, "STRIP_1967_CONTINUOUS"),
    (Model::Strip, "STRIP"),
    (Model::Total, "TOTAL"),
    (Model::Linear, "LINEAR"),
];

/// Errors of some cases, of both precisions: sums, and the largest with the inputs that have it.
#[derive(Default)]
struct Survey {
    cases: u32,
    sums: [[f64; 3]; 2],
    worst: [[(f64, Inputs); 3]; 2],
}

impl Survey {
    fn add(&mut self, model: Model, inputs: &Inputs) {
        let found = both(model, inputs);
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

/// Largest errors in units of the last place: force, moment and derivatives in double precision, then in single. Four
/// times the worst of 120 cases: another order of the same sums finds others.
#[rustfmt::skip]
const ALLOWED: &[(&str, &str, [f64; 6])] = &[
    ("STRIP_1967", "ordinary", [900.0, 8100.0, 93000.0, 130.0, 23.0, 260.0]),
    ("STRIP_1967", "small", [10.0, 12.0, 13.0, 7.6, 12.0, 11.0]),
    ("STRIP_1967", "tiny", [10.0, 12.0, 12.0, 6.8, 9.2, 9.2]),
    ("STRIP_1967", "sliding", [5.2, 1.0, 3100.0, 5.2, 1.2, 3000.0]),
    ("STRIP_1967", "spin", [13000.0, 680.0, 110000.0, 12000.0, 70.0, 12000.0]),
    ("STRIP_1967", "pure spin", [6.4, 54.0, 190.0, 9.2, 14.0, 66.0]),
    ("STRIP_1967", "opposed", [38.0, 13.0, 230.0, 61.0, 12.0, 110.0]),
    ("STRIP_1967", "slender", [360000.0, 1100.0, 360000.0, 350000.0, 570.0, 350000.0]),
    ("STRIP_1967_CONTINUOUS", "ordinary", [58.0, 66.0, 360.0, 70.0, 8.0, 320.0]),
    ("STRIP_1967_CONTINUOUS", "small", [10.0, 12.0, 13.0, 7.6, 12.0, 11.0]),
    ("STRIP_1967_CONTINUOUS", "tiny", [10.0, 12.0, 12.0, 6.8, 9.2, 9.2]),
    ("STRIP_1967_CONTINUOUS", "sliding", [8.0, 3.6, 7800.0, 8.8, 3.6, 4200.0]),
    ("STRIP_1967_CONTINUOUS", "spin", [480.0, 670.0, 91000.0, 410.0, 43.0, 440.0]),
    ("STRIP_1967_CONTINUOUS", "pure spin", [14.0, 63.0, 70.0, 11.0, 11.0, 34.0]),
    ("STRIP_1967_CONTINUOUS", "opposed", [26.0, 12.0, 230.0, 43.0, 12.0, 94.0]),
    ("STRIP_1967_CONTINUOUS", "slender", [81000.0, 1000.0, 81000.0, 85000.0, 560.0, 85000.0]),
    ("STRIP", "ordinary", [210.0, 130.0, 690.0, 16.0, 8.0, 33.0]),
    ("STRIP", "small", [10.0, 8.0, 12.0, 12.0, 9.6, 19.0]),
    ("STRIP", "tiny", [8.8, 12.0, 16.0, 12.0, 8.0, 14.0]),
    ("STRIP", "sliding", [1700.0, 1900.0, 260000.0, 6.8, 1.6, 1300.0]),
    ("STRIP", "spin", [480.0, 130.0, 980.0, 22.0, 14.0, 49.0]),
    ("STRIP", "pure spin", [190.0, 130.0, 2300.0, 16.0, 11.0, 81.0]),
    ("STRIP", "opposed", [130.0, 110.0, 2700.0, 11.0, 6.4, 150.0]),
    ("STRIP", "slender", [13000.0, 130.0, 43000.0, 470.0, 10.0, 410.0]),
    ("TOTAL", "ordinary", [37.0, 34.0, 250.0, 64.0, 35.0, 82.0]),
    ("TOTAL", "small", [10.0, 8.8, 14.0, 15.0, 8.4, 14.0]),
    ("TOTAL", "tiny", [9.6, 11.0, 13.0, 12.0, 8.0, 14.0]),
    ("TOTAL", "sliding", [6.4, 1.0, 27.0, 6.4, 1.0, 22.0]),
    ("TOTAL", "spin", [99.0, 56.0, 73.0, 92.0, 69.0, 170.0]),
    ("TOTAL", "pure spin", [88.0, 55.0, 110.0, 85.0, 54.0, 73.0]),
    ("TOTAL", "opposed", [25.0, 46.0, 58.0, 46.0, 56.0, 70.0]),
    ("TOTAL", "slender", [53.0, 64.0, 5200.0, 200.0, 51.0, 2400.0]),
    ("LINEAR", "ordinary", [7.6, 12.0, 11.0, 8.0, 7.2, 12.0]),
    ("LINEAR", "small", [7.2, 10.0, 11.0, 8.4, 8.8, 12.0]),
    ("LINEAR", "tiny", [8.8, 11.0, 11.0, 8.0, 8.4, 12.0]),
    ("LINEAR", "sliding", [8.4, 4.0, 10.0, 8.4, 2.4, 10.0]),
    ("LINEAR", "spin", [12.0, 11.0, 12.0, 13.0, 13.0, 13.0]),
    ("LINEAR", "pure spin", [12.0, 13.0, 12.0, 14.0, 12.0, 14.0]),
    ("LINEAR", "opposed", [6.8, 11.0, 11.0, 7.2, 9.6, 11.0]),
    ("LINEAR", "slender", [8.0, 9.6, 14.0, 9.2, 11.0, 13.0]),
];

#[test]
fn errors_are_the_known_ones() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/precise.csv");
    let search = std::env::var("KSTRIP_WRITE_PRECISE");
    let search: Option<u32> = search.ok().map(|cases| cases.parse().expect("a number of cases"));
    let known = if search.is_some() { String::new() } else { read(path) };
    let mut text = String::new();
    println!(
        "| model | region | f64: force | moment | derivatives | f32: force | moment | derivatives |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for (model, name) in MODELS {
        for region in REGIONS {
            let mut survey = Survey::default();
            let start = format!("{name},{region},");
            for line in known.lines().filter_map(|line| line.strip_prefix(&start)) {
                let mut numbers = line.split(',').map(|x| x.parse().expect("a number"));
                survey.add(model, &[(); 9].map(|()| numbers.next().expect("nine numbers")));
            }
            assert!(search.is_some() || survey.cases > 0, "no known cases of {name}, {region}");
            let mut random = Random::new(if search.is_some() { 200 } else { 53 });
            for _ in 0..search.unwrap_or(2) {
                survey.add(model, &draw(region, &mut random));
            }
            println!("| {name} | {region} |{}", survey.row());
            let found = survey.worst.as_flattened();
            let mut inputs: Vec<Inputs> = found.iter().map(|(_, inputs)| *inputs).collect();
            inputs.sort_by(|p, q| p.partial_cmp(q).expect("numbers"));
            inputs.dedup();
            for inputs in inputs {
                let numbers = inputs.map(|x| format!("{x:e}")).join(",");
                text += &format!("{start}{numbers}\n");
            }
            let allowed = ALLOWED.iter().find(|row| (row.0, row.1) == (name, region));
            let none = [f64::INFINITY; 6];
            let allowed = if search.is_some() { &none } else { &allowed.expect("a limit").2 };
            for ((error, inputs), allowed) in found.iter().zip(allowed) {
                assert!(
                    error <= allowed,
                    "{name}, {region}: {error} units of the last place, allowed {allowed}: {inputs:?}"
                );
            }
        }
    }
    if search.is_some() {
        std::fs::write(path, text).expect("tests/data is writable");
    }
}

/// The numbers of 200 bits against references that mpmath computed by another formula (`make_numerics.py`).
#[test]
fn adhesion_lengths_agree_with_mpmath() {
    let rows = read(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/numerics.csv"));
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

fn read(path: &str) -> String {
    std::fs::read_to_string(path).expect("the known cases")
}
