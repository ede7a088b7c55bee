//! Polynomials in x = 1/(1 + a/b) that join the slender asymptotes of the linear coefficients.
//!
//! Written by `fit/fit_coefficients.py` from `fit/data/kalker_coefficients.csv` (computed with
//! CONTACT, Vollebregt, Vtech CMCC, Apache-2.0). Two polynomials side by side, lowest power of x
//! first: for each power both constant parts, then both factors of ν.
// Generated: change the script, not this file.

/// Denominators of C11 and C22.
#[rustfmt::skip]
pub(crate) const E11_E22: [[f32; 4]; 4] = [
    [-3.0882108, -3.1412237, 0.17009117, 3.0078583],
    [-0.10024424, 0.16130966, 2.675368, -2.7426069],
    [2.3177168, 1.9147437, 4.6957784, -6.864879],
    [0.54676336, 0.7260834, -6.787332, 6.8274145],
];
/// Denominators of C23 and C33.
#[rustfmt::skip]
pub(crate) const E23_E33: [[f32; 4]; 4] = [
    [-4.6166406, 0.0, 3.725146, 0.0],
    [4.9424853, 1162.7085, -5.4695745, -1862.3059],
    [3.5989974, -2267.154, 16.948256, 3583.5676],
    [-2.5680182, 1879.0844, -15.652917, -2546.4253],
];
/// Numerators of C23 and C33.
#[rustfmt::skip]
pub(crate) const N23_N33: [[f32; 4]; 4] = [
    [-0.13863719, 0.0, -0.32885286, 0.0],
    [-0.7453778, 809.3589, 0.95718044, -1051.694],
    [4.720215, -1344.3595, 10.992623, 2015.8491],
    [-3.1020348, 1010.814, -11.310822, -1004.464],
];
/// Factors of x (1 - x) m in the denominator and in the numerator of C33.
#[rustfmt::skip]
pub(crate) const M33: [f32; 4] = [-260.54227, 804.9805, -166.42874, 221.45018];
