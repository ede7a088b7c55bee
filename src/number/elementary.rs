//! Elementary functions from the four operations and the square root: the same bits everywhere.

use super::arithmetic::Arithmetic;
use super::traits::{Float, Real, Strips};

/// `2^(−1/3)`, to single precision.
pub(super) const NEWTON_START: f32 = 0.793_700_5;
/// `3 · 2^(−2/3)`
pub(super) const NEWTON: f64 = 1.889_881_574_842_309_7;

/// Even powers of `artanh(s)/s` for `s² ≤ 0.0403`, least on Chebyshev points: within 2e-15.
pub(super) const ARTANH_DOUBLE: [f64; 7] = [
    1.0000000000000016,
    0.33333333332951415,
    0.20000000151707314,
    0.14285691729279248,
    0.11112703668482331,
    0.09033493024410533,
    0.08705642548611439,
];
/// The same, within 3e-9.
pub(super) const ARTANH_SINGLE: [f32; 4] = [1.0, 0.333_335_26, 0.199_761_59, 0.152_212_55];

/// Even powers of `arctan(u)/u` for `u² ≤ 0.0396`, exact on Chebyshev points: within 2e-15.
pub(super) const ARCTAN_DOUBLE: [f64; 7] = [
    0.9999999999999989,
    -0.3333333333306184,
    0.19999999890021358,
    -0.1428569754907035,
    0.11109894899408448,
    -0.09045305142970592,
    0.06833645556811507,
];
/// The same, within 2e-9.
pub(super) const ARCTAN_SINGLE: [f32; 4] = [1.0, -0.333_331_72, 0.199_794_67, -0.134_440_3];

/// `y ≈ 2^(−1/3)/√x` comes from single precision; `y (3 · 2^(−2/3) − x y²)` is then Newton's
/// iteration for `1/√x`, never above it but by rounding.
#[inline]
pub(super) fn inverse_root_f64(x: f64) -> f64 {
    let y = f64::from(NEWTON_START / Arithmetic::sqrt(x as f32));
    y * (NEWTON - x * (y * y))
}

#[inline]
pub(super) fn inverse_root_f32(x: f32) -> f32 {
    1.0 / Arithmetic::sqrt(x)
}

/// `Σ cᵢ zⁱ` of four or seven terms, in a tree of products that do not wait for each other.
#[inline(always)]
fn even_polynomial<F: Real>(c: &[F::Stored], z: F) -> F {
    // No closure: the code of numbers side by side must stand inside that of their caller.
    #[inline]
    fn line<F: Real>(p: F::Stored, q: F::Stored, z: F) -> F {
        F::stored(p) + F::stored(q) * z
    }
    let z2 = z * z;
    match *c {
        [p, q, r, s] => line(p, q, z) + line(r, s, z) * z2,
        [p, q, r, s, t, u, v] => {
            (line(p, q, z) + line(r, s, z) * z2) + (line(t, u, z) + F::stored(v) * z2) * (z2 * z2)
        }
        _ => F::zero(),
    }
}

/// `ln(x/divisor)` of two positive normal numbers, to rounding, without a branch.
#[inline(always)]
pub(super) fn ln_quotient<F: Real>(x: F, divisor: F) -> F {
    let (k, divisor) = x.binary_quotient(divisor);
    // ln m = 2 artanh((m − 1)/(m + 1))
    let s = (x - divisor) / (x + divisor);
    let s2 = s * s;
    k.times(core::f64::consts::LN_2) + (s + s) * even_polynomial(F::Stored::ARTANH, s2)
}

/// The same of numbers side by side.
#[inline(always)]
pub(super) fn ln_quotients<F: Real, P: Strips<F>>(x: P, divisor: F) -> P {
    let k = P::gather(|i| x.lane(i).binary_quotient(divisor).0);
    let divisors = P::gather(|i| x.lane(i).binary_quotient(divisor).1);
    let s = (x - divisors) / (x + divisors);
    let s2 = s.squared();
    let mut sum = P::zero();
    for coefficient in F::Stored::ARTANH.iter().rev() {
        sum = sum * s2 + P::all(F::stored(*coefficient));
    }
    k.times(core::f64::consts::LN_2) + (s + s) * sum
}

/// `arctan x` of a number between 0 and 1, to rounding, without a branch.
#[inline(always)]
pub(super) fn atan_of_unit<F: Real>(x: F) -> F {
    const EIGHTH: f64 = core::f64::consts::FRAC_PI_8;
    // from the nearer of π/16 and 3π/16, |u| ≤ tan(π/16)
    let upper = x.plus(-0.414_213_562_373_095_05);
    let tangent = upper.choose(F::of(0.668_178_637_919_298_9), F::of(0.198_912_367_379_658));
    let angle = upper.choose(F::of(1.5 * EIGHTH), F::of(0.5 * EIGHTH));
    let u = (x - tangent) / (x * tangent).plus(1.0);
    angle + u * even_polynomial(F::Stored::ARCTAN, u * u)
}

/// Cube root in single precision without double-precision arithmetic, which a Cortex-M4F does in
/// software: libm's `cbrtf` computes in double.
///
/// Relative error below the distance from 1 to the next number; zero, infinities and NaN stay what
/// they are.
pub(super) fn cube_root(x: f32) -> f32 {
    if x == 0.0 || !x.is_finite() {
        return x;
    }
    // 2²⁴ = (2⁸)³ lifts subnormal numbers.
    let tiny = x.abs() < f32::MIN_POSITIVE;
    let (size, scale) = if tiny { (x.abs() * 16_777_216.0, 1.0 / 256.0) } else { (x.abs(), 1.0) };
    // A third of the exponent, and the mantissa as it falls: within 6 %
    let mut root = f32::from_bits(size.to_bits() / 3 + 709_958_130);
    for _ in 0..2 {
        // Halley: r + r (t − 1)/(2 + t) with t = x/r³; the relative error e becomes 2e³/3
        let t = size / (root * root) / root;
        root += root * ((t - 1.0) / (2.0 + t));
    }
    (root * scale).copysign(x)
}
