//! Kalker's coefficients: asymptotes, table, both precisions.

use core::f64::consts::LN_2;
use kstrip_testing::prelude::*;

/// `3 − 2 ln 2` of Kalker's slender contacts.
const K: f64 = 3.0 - 2.0 * LN_2;

fn at(g: f64, nu: f64) -> [f64; 4] {
    let c = LinearCoefficients::at(g, nu);
    [c.c11, c.c22, c.c23, c.c33]
}

/// C33 where `a ≪ b`: Kalker's limit, to which the difference dies out as `(a/b) ln(b/a)`.
#[test]
fn spin_coefficient_of_wide_contacts_is_near_its_limit() {
    for (g, allowed) in [(1e-3, 0.005), (1e-2, 0.01), (3e-2, 0.02)] {
        for nu in [0.0, 0.15, 0.28, 0.4, 0.5] {
            let limit = PI.powi(2) / (16.0 * (1.0 - nu) * g);
            assert_relative_eq!(at(g, nu)[3], limit, max_relative = allowed);
        }
    }
}

/// Values computed with CONTACT (`fit/data/kalker_coefficients.csv`): the two ends and the middle.
#[test]
fn agree_with_the_reference() {
    const ALLOWED: [f64; 4] = [0.0012, 0.0016, 0.0012, 0.005];
    for (g, nu, reference) in [
        (0.1, 0.0, [2.51148, 2.51149, 0.334836, 6.45256]),
        (0.1, 0.5, [4.85873, 2.53342, 0.719747, 11.7256]),
        (1.0, 0.25, [4.11253, 3.66683, 1.46424, 1.18736]),
        (2.0, 0.5, [6.09922, 5.58526, 2.97321, 0.645973]),
        (10.0, 0.0, [10.7729, 10.7729, 12.1854, 0.801311]),
        (10.0, 0.28, [11.8928, 13.23, 14.8448, 0.496317]),
        (10.0, 0.5, [12.9494, 16.1158, 17.9135, 0.231921]),
    ] {
        for ((value, reference), allowed) in at(g, nu).into_iter().zip(reference).zip(ALLOWED) {
            assert_relative_eq!(value, reference, max_relative = allowed);
        }
    }
}

/// Kalker 1990, Table E.3, slender ends; what is dropped there is of order `g² ln g`, and `b/a`
/// over the logarithm.
#[test]
fn reach_the_slender_limits() {
    for nu in [0.0, 0.28, 0.5] {
        let g: f64 = 1e-4;
        let limit = [
            PI * PI / 4.0 / (1.0 - nu),
            PI * PI / 4.0,
            PI / 3.0 * g.sqrt() * (1.0 + nu * ((16.0 / g).ln() - 5.0)) / (1.0 - nu),
            PI * PI / 16.0 / (1.0 - nu) / g,
        ];
        for (value, limit) in at(g, nu).into_iter().zip(limit) {
            assert_relative_eq!(value, limit, max_relative = 5e-3);
        }
        let g: f64 = 1e5;
        let lambda = (16.0 * g * g).ln();
        let e = (1.0 - nu) * lambda - 2.0 + 4.0 * nu;
        let limit = [
            2.0 * PI * g / (lambda - 2.0 * nu - K),
            2.0 * PI * g / ((1.0 - nu) * (lambda - K) + 2.0 * nu),
            2.0 * PI / 3.0 * g.powf(1.5) / e,
            PI / 4.0 * ((1.0 - 2.0 * nu) * lambda - 2.0 + 6.0 * nu) / e,
        ];
        for (value, limit) in at(g, nu).into_iter().zip(limit) {
            assert_relative_eq!(value, limit, max_relative = 5e-3);
        }
    }
}

/// No seam: over twelve decades the logarithmic slope changes by little between neighbours 0.5 %
/// apart.
#[test]
fn have_no_seam() {
    let ratios = 2f64.ln() / 128.0;
    for nu in [0.0, 0.1, 0.28, 0.4, 0.5] {
        let logarithms = |k: i32| {
            let value = at((f64::from(k) * ratios).exp(), nu);
            assert!(value.iter().all(|c| c.is_finite() && *c > 0.0));
            value.map(f64::ln)
        };
        let all: Vec<_> = (-2500..=2500).map(logarithms).collect();
        for (k, three) in all.windows(3).enumerate() {
            let changes: [f64; 4] =
                core::array::from_fn(|i| (three[2][i] - 2.0 * three[1][i] + three[0][i]) / ratios);
            assert!(changes.iter().all(|c| c.abs() < 6e-3), "{k} {nu}: {changes:?}");
        }
    }
}

#[test]
fn hold_in_single_precision_and_far_outside() {
    for g in [1e-30, 1e-4, 0.07, 0.9, 14.0, 1e4, 1e30] {
        for nu in [0.0, 0.3, 0.5] {
            let single = LinearCoefficients::at(g as f32, nu as f32);
            let double = at(g, nu);
            for (single, double) in
                [single.c11, single.c22, single.c23, single.c33].into_iter().zip(double)
            {
                assert!(double.is_finite() && double > 0.0);
                assert_relative_eq!(f64::from(single), double, max_relative = 1e-5);
            }
        }
    }
}
