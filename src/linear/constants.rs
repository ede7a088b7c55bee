//! Polynomials in x = 1/(1 + a/b) that join the slender asymptotes of the linear coefficients.
//!
//! Written by `fit/fit_coefficients.py` from `fit/data/kalker_coefficients.csv` (computed with CONTACT,
//! Vollebregt, Vtech CMCC, Apache-2.0). Two polynomials side by side, lowest power of x first: for each power
//! the pair of constant parts, then the pair of factors of ν.
// Generated: change the script, not this file.

/// Denominators of C11 and C22.
#[rustfmt::skip]
pub(crate) const E11_E22: [[[f32; 2]; 2]; 4] = [
    [
        [-3.0881736, -3.1412013], [0.16998003, 3.007813],
    ],
    [
        [-0.10047681, 0.16116482], [2.676077, -2.7423108],
    ],
    [
        [2.3181357, 1.9150069], [4.694493, -6.865425],
    ],
    [
        [0.546534, 0.7259384], [-6.7866273, 6.8277173],
    ],
];
/// Denominators of C23 and C33.
#[rustfmt::skip]
pub(crate) const E23_E33: [[[f32; 2]; 2]; 4] = [
    [
        [-4.620647, 18.797358], [3.7267768, -37.52717],
    ],
    [
        [4.9501576, -39.052834], [-5.470458, 54.754864],
    ],
    [
        [3.6033113, 57.77935], [16.941742, -53.844025],
    ],
    [
        [-2.5755813, 0.0], [-15.648521, 0.0],
    ],
];
/// Numerators of C23 and C33.
#[rustfmt::skip]
pub(crate) const N23_N33: [[[f32; 2]; 2]; 4] = [
    [
        [-0.13899048, 16.700405], [-0.3293259, 14.348592],
    ],
    [
        [-0.7490048, -12.599831], [0.96091455, 0.6332125],
    ],
    [
        [4.7332067, 17.835766], [10.985676, -5.6299086],
    ],
    [
        [-3.1108365, 0.0], [-11.307634, 0.0],
    ],
];
/// Factors of (1 - x) m in the denominator and in the numerator of C33.
#[rustfmt::skip]
pub(crate) const M33: [f32; 4] = [
    18.843182, 16.862446, 13.560676, -33.568813,
];
