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
        [-3.088172, -3.1411836], [0.16998173, 3.0077727],
    ],
    [
        [-0.100492716, 0.16104902], [2.676082, -2.7420444],
    ],
    [
        [2.318171, 1.9152194], [4.6944666, -6.8659205],
    ],
    [
        [0.54651165, 0.7258206], [-6.7866054, 6.827995],
    ],
];
/// Denominators of C23 and C33.
#[rustfmt::skip]
pub(crate) const E23_E33: [[[f32; 2]; 2]; 4] = [
    [
        [-4.6321306, 0.0], [3.7323174, 0.0],
    ],
    [
        [4.972975, 674.87286], [-5.4833927, -835.6442],
    ],
    [
        [3.5838752, -1252.0132], [16.954012, 1142.1038],
    ],
    [
        [-2.5688944, 1157.9304], [-15.651771, -890.18427],
    ],
];
/// Numerators of C23 and C33.
#[rustfmt::skip]
pub(crate) const N23_N33: [[[f32; 2]; 2]; 4] = [
    [
        [-0.14036761, 0.0], [-0.3300831, 0.0],
    ],
    [
        [-0.75409317, 574.34546], [0.96428657, -266.2663],
    ],
    [
        [4.7440767, -819.38293], [10.982811, 849.4942],
    ],
    [
        [-3.1159494, 587.10846], [-11.308254, -468.97086],
    ],
];
/// Factors of x (1 - x) m in the denominator and in the numerator of C33.
#[rustfmt::skip]
pub(crate) const M33: [f32; 4] = [
    167.8646, 363.98032, 113.598724, -374.73813,
];
