//! Errors in units of the last place against 200-bit arithmetic (`tests/data/make_numerics.py`), by
//! region, for double and single precision; the limits are what docs/evidence/rounding.md
//! explains.
//!
//! `cargo test --config tests/plain.toml --test numbers numerics -- --nocapture` prints the table
//! of that page.

use kstrip::strip_1967;
use kstrip::strip_1967::strip::adhesion_length;
use kstrip_testing::prelude::*;

struct Row {
    what: String,
    region: String,
    inputs: [f64; 6],
    /// High and low part: 106 bits.
    results: [(f64, f64); 4],
}

fn rows() -> Vec<Row> {
    let text = read("tests/data/numerics.csv");
    text.lines()
        .map(|line| {
            let mut words = line.split(',');
            let mut word = || words.next().expect("sixteen columns");
            let (what, region) = (word().to_owned(), word().to_owned());
            let mut number = || word().parse().expect("a number");
            let inputs = std::array::from_fn(|_| number());
            let results = std::array::from_fn(|_| (number(), number()));
            Row { what, region, inputs, results }
        })
        .collect()
}

/// Error in units of the last place of a type with this `epsilon`, at the size of `scale`.
fn ulps(value: f64, exact: (f64, f64), scale: f64, epsilon: f64) -> f64 {
    assert!(value.is_finite());
    ((value - exact.0) - exact.1).abs() / (scale.abs() * epsilon)
}

/// Errors of one row in one precision.
fn errors<F: Float>(row: &Row) -> Vec<f64> {
    let input = |i: usize| F::of(row.inputs[i]);
    let epsilon = F::EPSILON.to_f64();
    let [r0, r1, r2, _] = row.results;
    match row.what.as_str() {
        "kappa" => {
            let kappa = adhesion_length(input(0), input(1), input(2)).expect("a length");
            vec![ulps(kappa.to_f64(), r0, r0.0, epsilon)]
        }
        "hertz" => {
            // Curvatures as radii of the lower body, the upper one flat, twice as curved: A = 1/(2
            // R)
            let radius = |curvature: F| F::one() / curvature.times(2.0);
            let flat = F::of(f64::INFINITY);
            let radii = radii([radius(input(0)), radius(input(1)), flat, flat]);
            let h = hertz(&radii, input(2), input(3), input(4)).expect("an ellipse");
            let major = h.a.max(h.b);
            [h.axis_ratio, major, h.peak_pressure, h.approach]
                .iter()
                .zip(row.results)
                .map(|(value, exact)| ulps(value.to_f64(), exact, exact.0, epsilon))
                .collect()
        }
        "force" => {
            let [xi, eta, psi, poisson_ratio, axis_ratio] = [0, 1, 2, 3, 4].map(input);
            let parameters = Parameters { xi, eta, psi, poisson_ratio, axis_ratio };
            let Totals { fx, fy, .. } = strip_1967::totals(&parameters, SlidingRule::RigidSlip);
            let size = r0.0.hypot(r1.0);
            vec![ulps(fx.to_f64(), r0, size, epsilon), ulps(fy.to_f64(), r1, size, epsilon)]
        }
        "slope" => {
            // A contact with slip unit 1 and (1 − ν), so that creepages are the parameters
            let (nu, g) = (row.inputs[3], row.inputs[4]);
            let contact = Contact {
                a: F::of(g.sqrt()),
                b: F::of(1.0 / g.sqrt()),
                normal_force: F::of(2.0 * PI / 3.0),
                shear_modulus: F::of(2.0),
                poisson_ratio: input(3),
                friction: F::one(),
                mismatch: F::zero(),
            };
            let [xi, eta, psi, poisson_ratio] = [0, 1, 2, 3].map(input);
            let parameters = Parameters { xi, eta, psi, poisson_ratio, axis_ratio: F::of(g) };
            let creepage = parameters.creepage(&contact);
            let options = Options { model: Model::Strip1967, strips: StripCount::SixtyFour };
            let (_, j) = solve_jacobian(&contact, &creepage, &options).expect("derivatives");
            // dF/dξ = dF/dυx · (1 − ν) slip unit; μ N is the normal force here
            let bound = contact.normal_force.to_f64();
            let found = [
                j[(0, 0)].to_f64() * (1.0 - nu) / bound,
                j[(1, 1)].to_f64() / bound,
                j[(0, 1)].to_f64() / bound,
            ];
            let size = r0.0.abs().max(r1.0.abs());
            found.iter().zip([r0, r1, r2]).map(|(v, e)| ulps(*v, e, size, epsilon)).collect()
        }
        other => panic!("{other}"),
    }
}

/// Largest error in units of the last place: what, region, double, single. Explained in
/// docs/evidence/rounding.md.
const ALLOWED: &[(&str, &str, f64, f64)] = &[
    // (four nodes on a smooth piece: up to 4e-12)
    ("force", "combined", 39.0, 0.9),
    ("force", "no spin", 1.3, 0.8),
    ("force", "sliding", 19345.9, 0.9),
    ("force", "small", 1.1, 1.3),
    ("hertz", "circle", 2.2, 2.1),
    ("hertz", "ellipse", 1.9, 2.4),
    ("hertz", "near circle", 2.0, 2.5),
    ("hertz", "needle", 2.3, 2.8),
    ("kappa", "eta >> xi", 1.1, 1.1),
    ("kappa", "ordinary", 1.0, 1.5),
    ("kappa", "psi beyond 1", 1.0, 1.2),
    ("kappa", "psi near 1", 1.1, 1.4),
    ("kappa", "tiny", 1.2, 1.2),
    ("kappa", "xi >> eta", 0.8, 1.0),
    ("slope", "combined", 434.0, 1.3),
    ("slope", "no spin", 1.8, 1.3),
];

/// Rows, largest error, and sum of errors in double and single precision.
type Found = (usize, [f64; 2], [f64; 2]);

#[test]
fn errors_against_200_bits_are_the_known_ones() {
    let mut worst: BTreeMap<(String, String), Found> = BTreeMap::new();
    for row in rows() {
        let largest = |errors: Vec<f64>| errors.into_iter().fold(0.0, f64::max);
        let found = [largest(errors::<f64>(&row)), largest(errors::<f32>(&row))];
        let entry = worst.entry((row.what, row.region)).or_default();
        entry.0 += 1;
        for (i, error) in found.into_iter().enumerate() {
            entry.1[i] = entry.1[i].max(error);
            entry.2[i] += error;
        }
    }
    println!("| what | region | cases | f64 mean | f64 worst | f32 mean | f32 worst |");
    println!("|---|---|---|---|---|---|---|");
    for ((what, region), (cases, largest, sum)) in &worst {
        let mean = sum.map(|sum| sum / *cases as f64);
        println!(
            "| {what} | {region} | {cases} | {:.2} | {:.1} | {:.2} | {:.1} |",
            mean[0], largest[0], mean[1], largest[1]
        );
    }
    assert_eq!(worst.len(), ALLOWED.len(), "a region without its limit");
    for (what, region, double, single) in ALLOWED {
        let (_, largest, _) = &worst[&((*what).to_owned(), (*region).to_owned())];
        assert!(
            largest[0] <= *double && largest[1] <= *single,
            "{what}, {region}: {largest:?} units of the last place, allowed {double} and {single}"
        );
    }
}

/// Of numbers side by side some have nothing to do with what is asked for: the integers that are
/// made of them do not overflow.
#[test]
fn the_binary_quotient_of_any_two_numbers_is_a_whole_number() {
    fn check<F: Float>(numbers: &[F]) {
        for p in numbers {
            for q in numbers {
                let (k, _) = p.binary_quotient(*q);
                assert!(k.is_finite_number() && k == F::of(f64::from(k.whole())), "{p:?} {q:?}");
            }
        }
    }
    check(&[1.0, -1.0, 0.0, -0.0, f64::MAX, -f64::MAX, f64::NAN, -f64::INFINITY, 5e-324]);
    check(&[1.0, -1.0, 0.0, -0.0, f32::MAX, -f32::MAX, f32::NAN, -f32::INFINITY, 1e-45]);
}
