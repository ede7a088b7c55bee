//! The cube root in single precision against libm's in double.

use kstrip_testing::prelude::*;

#[test]
fn agrees_with_double_precision() {
    for bits in (1..0x7f80_0000_u32).step_by(9973) {
        let x = f32::from_bits(bits);
        let exact = libm::cbrt(f64::from(x));
        let error = (f64::from(x.cube_root()) / exact - 1.0).abs();
        assert!(error < f64::from(f32::EPSILON), "{x:e}: {error:e}");
        assert_eq!((-x).cube_root(), -(x.cube_root()));
    }
    for x in [0.0, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(x.cube_root(), x);
    }
    assert!(f32::NAN.cube_root().is_nan());
}
