//! Patches from profiles, the normal problem of strips: against the same formulas in 200 bits, by
//! shape, in double and single precision. The limits are what docs/evidence/rounding.md explains.
//!
//! `cargo test --config tests/plain.toml --test numbers profiles -- --nocapture` prints the table
//! of that page.

use crate::precise::Precise;
use crate::two_hundred_bits::{is_known, stated};
use kstrip_testing::prelude::*;

/// Distance \[m\] over `y` \[m\].
type Shape = fn(f64) -> f64;

const SHAPES: [(&str, Shape); 5] = [
    ("parabola", |y| y * y / 0.6),
    // a flat crest that ends in a small radius
    ("worn", |y| y * y / 4.0 + (y.abs() - 4e-3).max(0.0).powi(2) / 0.04),
    // lower on one side
    ("two zones", |y| ((y * y - 25e-6) / 10e-3).powi(2) / 0.2 + 1e-3 * y),
    ("inclined", |y| y * y / 0.2 + 4e-3 * y),
    ("rough", |y| y * y / 0.6 + 1e-6 * (9e3 * y).sin()),
];
/// Forces \[N\].
const LOADS: [f32; 2] = [4e3, 8e4];

/// Points and the load are numbers of single precision: one reference serves both precisions.
fn solved<F: Float>(shape: Shape, load: f32) -> (Vec<PatchStrip<F>>, Indentation<F>) {
    let y: Vec<f32> = (-60..=60_i16).map(|i| f32::from(i) * 2.5e-4).collect();
    let distance: Vec<F> = y.iter().map(|y| F::widened(shape((*y).into()) as f32)).collect();
    let y: Vec<F> = y.into_iter().map(F::widened).collect();
    let contact = ProfileContact {
        rolling_radius: F::widened(0.46),
        given: Given::Load(F::widened(load)),
        shear_modulus: F::widened(82e9),
        poisson_ratio: F::widened(0.28),
        friction: F::widened(0.3),
        smoothing_length: F::zero(),
    };
    let found = Patch::<F>::from_profile(
        &Profile::new(&y, &distance).unwrap(),
        &contact,
        StripCount::Sixteen,
    );
    let (patch, found) = found.unwrap_or_else(|error| panic!("{error:?} {load}"));
    (patch.used().to_vec(), found)
}

/// Errors in units of the last place: approach, stiffness, half lengths (of the longest), pressures
/// (of the largest).
fn errors<F: Float>(
    shape: Shape, load: f32, (strips, wanted): &(Vec<PatchStrip<Precise>>, Indentation<Precise>),
) -> [f64; 4] {
    let (found_strips, found) = solved::<F>(shape, load);
    let epsilon = F::EPSILON.to_f64();
    let error = |found: F, exact: Precise, unit: Precise| {
        exact.distance(found.to_f64(), unit.to_f64() * epsilon).abs()
    };
    let longest =
        strips.iter().map(|strip| strip.half_length).reduce(|x, y| if x > y { x } else { y });
    let longest = longest.expect("strips");
    assert_eq!(found_strips.len(), strips.len(), "{load}");
    let mut all = [
        error(found.approach, wanted.approach, wanted.approach),
        error(found.stiffness, wanted.stiffness, wanted.stiffness),
        0.0,
        0.0,
    ];
    for (strip, exact) in found_strips.iter().zip(strips) {
        all[2] = error(strip.half_length, exact.half_length, longest).max(all[2]);
        all[3] = error(strip.peak_pressure, exact.peak_pressure, wanted.peak_pressure).max(all[3]);
    }
    all
}

#[test]
fn errors_of_patches_from_profiles_are_the_known_ones() {
    println!(
        "| shape | f64: approach | stiffness | half lengths | pressures | f32: approach | \
         stiffness | half lengths | pressures |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    let mut unknown = Vec::new();
    for (name, shape) in SHAPES {
        let mut worst = [0.0_f64; 8];
        for load in LOADS {
            Precise::forget();
            let exact = solved::<Precise>(shape, load);
            let both = [errors::<f64>(shape, load, &exact), errors::<f32>(shape, load, &exact)];
            for (worst, error) in worst.iter_mut().zip(both.as_flattened()) {
                *worst = worst.max(*error);
            }
        }
        let cells: String = worst.iter().map(|error| format!(" {error:.1} |")).collect();
        println!("| {name} |{cells}");
        let known = stated(&format!("| {name} |"));
        let all = worst.iter().zip(&known).all(|(error, known)| is_known(*error, *known));
        if !(all && known.len() == worst.len()) {
            unknown
                .push(format!("{name}: {worst:?} units of the last place, {known:?} are stated"));
        }
    }
    assert!(unknown.is_empty(), "{unknown:#?}");
}
