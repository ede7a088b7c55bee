//! Cube root in single precision without double-precision arithmetic, which a Cortex-M4F does in
//! software: libm's `cbrtf` computes in double.

/// Relative error below the distance from 1 to the next number; zero, infinities and NaN stay what
/// they are.
pub(super) fn of_f32(x: f32) -> f32 {
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
