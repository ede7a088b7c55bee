//! The cube root in single precision against libm's in double.

use super::of_f32;

#[test]
fn agrees_with_double_precision() {
    for bits in (1..0x7f80_0000_u32).step_by(9973) {
        let x = f32::from_bits(bits);
        let exact = libm::cbrt(f64::from(x));
        let error = (f64::from(of_f32(x)) / exact - 1.0).abs();
        assert!(error < f64::from(f32::EPSILON), "{x:e}: {error:e}");
        assert_eq!(of_f32(-x), -of_f32(x));
    }
    for x in [0.0, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(of_f32(x), x);
    }
    assert!(of_f32(f32::NAN).is_nan());
}
