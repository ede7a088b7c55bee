//! `f32` and `f64` as numbers of the theory.

use super::lanes::{F32Pair, Lanes, Wide};
use super::registers::{NEWTON, NEWTON_START};
use super::{Arithmetic, Float, Number, Real, cube_root, registers};

macro_rules! plain {
    ($float:ident, $integer:ident, $mantissa:literal, |$single:ident, $double:ident| $table:expr,
        Float { $($float_items:tt)* } Real { $($plain_items:tt)* } Number { $($number_items:tt)* }
        $($elementary:ident = $elementary_of:path),*; $($root:ident = $root_of:path),*) => {
        impl Float for $float {
            $($float_items)*

            #[inline]
            fn widened(x: f32) -> Self {
                $float::from(x)
            }
            #[inline]
            fn whole(self) -> i32 {
                self as i32
            }
            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline]
            fn is_finite_number(self) -> bool {
                self.is_finite()
            }
            $(#[inline]
            fn $elementary(self) -> Self {
                $elementary_of(self)
            })*
            #[inline]
            fn table<const R: usize, const C: usize>(
                $single: &'static [[f32; C]; R],
                $double: &'static [[f64; C]; R],
            ) -> &'static [[Self; C]; R] {
                let _ = ($single, $double);
                $table
            }
        }

        impl Real for $float {
            $($plain_items)*
            type Stored = $float;

            #[inline]
            fn stored(x: $float) -> Self {
                x
            }
            #[inline]
            fn binary_quotient(self, divisor: Self) -> (Self, Self) {
                // the bits of a floating-point number, read as an integer, are its binary logarithm
                // to 0.043
                let (p, q) = (self.to_bits() as $integer, divisor.to_bits() as $integer);
                // (whoever computes both sides of a branch may ask for those of any sign)
                let k = p.wrapping_sub(q).wrapping_add(1 << ($mantissa - 1)) >> $mantissa;
                (k as $float, $float::from_bits(q.wrapping_add(k << $mantissa) as _))
            }
            #[inline]
            fn lies_between(self, low: Self, high: Self) -> bool {
                self >= low && self <= high
            }
            #[inline]
            fn lies_within(self, limit: Self) -> bool {
                self.to_bits() <= limit.to_bits()
            }
        }

        impl Arithmetic for $float {
            type Value = $float;

            #[inline]
            fn constant(x: f64) -> Self {
                x as $float
            }
            #[inline]
            fn tiny() -> Self {
                $float::MIN_POSITIVE
            }

            #[inline]
            fn from_base(x: $float) -> Self {
                x
            }
            #[inline]
            fn value(self) -> Self {
                self
            }
            $(#[inline]
            fn $root(self) -> Self {
                $root_of(self)
            })*
            #[inline]
            fn max(self, other: Self) -> Self {
                if self > other { self } else { other }
            }
            #[inline]
            fn min(self, other: Self) -> Self {
                if self < other { self } else { other }
            }
            #[inline]
            fn choose(self, yes: Self, no: Self) -> Self {
                if self > 0.0 { yes } else { no }
            }
        }

        impl Number for $float {
            type Base = Self;
            $($number_items)*
            const LARGEST: $float = $float::MAX;
            const TINY: $float = $float::MIN_POSITIVE;
            const EPSILON: $float = $float::EPSILON;

            #[inline]
            fn exceeds(self, other: Self) -> bool {
                self > other
            }
        }
    };
}

/// Even powers of `artanh(s)/s` for `s² ≤ 0.0403`, least on Chebyshev points: within 2e-15.
const ARTANH_DOUBLE: [f64; 7] = [
    1.0000000000000016,
    0.33333333332951415,
    0.20000000151707314,
    0.14285691729279248,
    0.11112703668482331,
    0.09033493024410533,
    0.08705642548611439,
];
/// The same, within 3e-9.
const ARTANH_SINGLE: [f32; 4] = [1.0, 0.333_335_26, 0.199_761_59, 0.152_212_55];

/// Even powers of `arctan(u)/u` for `u² ≤ 0.0396`, exact on Chebyshev points: within 2e-15.
const ARCTAN_DOUBLE: [f64; 7] = [
    0.9999999999999989,
    -0.3333333333306184,
    0.19999999890021358,
    -0.1428569754907035,
    0.11109894899408448,
    -0.09045305142970592,
    0.06833645556811507,
];
/// The same, within 2e-9.
const ARCTAN_SINGLE: [f32; 4] = [1.0, -0.333_331_72, 0.199_794_67, -0.134_440_3];

/// `y ≈ 2^(−1/3)/√x` comes from single precision; `y (3 · 2^(−2/3) − x y²)` is then Newton's
/// iteration for `1/√x`, never above it but by rounding.
#[inline]
fn inverse_root_f64(x: f64) -> f64 {
    let y = f64::from(NEWTON_START / Arithmetic::sqrt(x as f32));
    y * (NEWTON - x * (y * y))
}

#[inline]
fn inverse_root_f32(x: f32) -> f32 {
    1.0 / Arithmetic::sqrt(x)
}

/// `Σ cᵢ zⁱ` of four or seven terms, in a tree of products that do not wait for each other.
#[inline(always)]
pub(super) fn even_polynomial<F: Real>(c: &[F::Stored], z: F) -> F {
    // (no closure: the code of numbers side by side must stand inside that of their caller)
    #[inline(always)]
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

plain!(
    f64, i64, 52, |single, double| double,
    Float {
        type Contacts = Lanes<f64, 4>;
        const ARTANH: &'static [f64] = &ARTANH_DOUBLE;
        const ARCTAN: &'static [f64] = &ARCTAN_DOUBLE;
    }
    Real {
        type Four = Lanes<Lanes<f64, 2>, 2>;
        type Eight = Lanes<Self::Four, 2>;
        type WideRow = Lanes<f64, 4, Wide>;
        type WideFour = Self::WideRow;
        type WideEight = Lanes<Self::WideRow, 2>;
        type WideSixteen = Lanes<Self::WideEight, 2>;
    }
    Number {
        type Pair = Lanes<f64, 2>;
        const ROOT_TINY: f64 = 1.491_668_146_240_041_3e-154;
        const HUGE: f64 = 1e100;
    }
    cube_root = libm::cbrt, exp = libm::exp, atan = libm::atan, ln = libm::log;
    sqrt = registers::of_f64, inverse_root = inverse_root_f64, abs = f64::abs
);
plain!(
    f32, i32, 23, |single, double| single,
    Float {
        type Contacts = Lanes<f32, 8>;
        const ARTANH: &'static [f32] = &ARTANH_SINGLE;
        const ARCTAN: &'static [f32] = &ARCTAN_SINGLE;
    }
    Real {
        type Four = Lanes<f32, 4>;
        type Eight = Lanes<Self::Four, 2>;
        type WideRow = Lanes<f32, 8, Wide>;
        type WideFour = Self::Four;
        type WideEight = Self::WideRow;
        type WideSixteen = Lanes<Self::WideRow, 2>;
    }
    Number {
        type Pair = F32Pair;
        const ROOT_TINY: f32 = 1.084_202_2e-19;
        const HUGE: f32 = 1e12;
    }
    cube_root = cube_root::of_f32, exp = libm::expf, atan = libm::atanf, ln = libm::logf;
    sqrt = registers::of_f32, inverse_root = inverse_root_f32, abs = f32::abs
);
