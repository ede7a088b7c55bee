//! Polynomials in x = 1/(1 + a/b) that join the slender asymptotes of the linear coefficients.
//!
//! Written by `fit/fit_coefficients.py` from `fit/data/kalker_coefficients.csv` (computed with CONTACT,
//! Vollebregt, Vtech CMCC, Apache-2.0). Pairs (p, q) stand for p + q ν, lowest power of x first.
// Generated: change the script, not this file.

/// Denominator of C11.
#[rustfmt::skip]
pub(crate) const E11: [f32; 8] = [
    -3.0881736, 0.16998003, -0.10047681, 2.676077, 2.3181357, 4.694493, 0.546534, -6.7866273,
];
/// Denominator of C22.
#[rustfmt::skip]
pub(crate) const E22: [f32; 8] = [
    -3.1412013, 3.007813, 0.16116482, -2.7423108, 1.9150069, -6.865425, 0.7259384, 6.8277173,
];
/// Denominator of C23.
#[rustfmt::skip]
pub(crate) const E23: [f32; 8] = [
    -4.620647, 3.7267768, 4.9501576, -5.470458, 3.6033113, 16.941742, -2.5755813, -15.648521,
];
/// Numerator of C23.
#[rustfmt::skip]
pub(crate) const N23: [f32; 8] = [
    -0.13899048, -0.3293259, -0.7490048, 0.96091455, 4.7332067, 10.985676, -3.1108365, -11.307634,
];
/// Denominator of C33.
#[rustfmt::skip]
pub(crate) const E33: [f32; 6] = [
    18.797358, -37.52717, -39.052834, 54.754864, 57.77935, -53.844025,
];
/// Numerator of C33.
#[rustfmt::skip]
pub(crate) const N33: [f32; 6] = [
    16.700405, 14.348592, -12.599831, 0.6332125, 17.835766, -5.6299086,
];
/// Factors of (1 - x) m in the denominator and in the numerator of C33.
#[rustfmt::skip]
pub(crate) const M33: [f32; 4] = [
    18.843182, 16.862446, 13.560676, -33.568813,
];
