//! `f32` and `f64` as numbers of the theory.

use super::arithmetic::Arithmetic;
use super::elementary::{self, ARCTAN_DOUBLE, ARCTAN_SINGLE, ARTANH_DOUBLE, ARTANH_SINGLE};
use super::lanes::{F32Pair, Lanes, Wide};
use super::root;
use super::traits::{Float, Number, Real, Strips};

macro_rules! plain {
    ($float:ident, $integer:ident, $mantissa:literal, |$single:ident, $double:ident| $table:expr,
        Float { $($float_items:tt)* } Real { $($plain_items:tt)* } Number { $($number_items:tt)* }
        $($elementary:ident = $elementary_of:path),*; $($root:ident = $root_of:path),*) => {
        impl Float for $float {
            const ZERO: $float = 0.0;
            $($float_items)*

            fn widened(x: f32) -> Self {
                $float::from(x)
            }
            fn whole(self) -> i32 {
                self as i32
            }
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            fn is_finite_number(self) -> bool {
                self.is_finite()
            }
            $(#[inline]
            fn $elementary(self) -> Self {
                $elementary_of(self)
            })*
            #[inline]
            fn inverse_of_normal(
                matrix: nalgebra::Matrix6<Self>,
            ) -> Option<nalgebra::Matrix6<Self>> {
                matrix.cholesky().map(|factor| factor.inverse())
            }
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

            fn stored(x: $float) -> Self {
                x
            }
            #[inline]
            fn binary_quotient(self, divisor: Self) -> (Self, Self) {
                // the bits of a floating-point number, read as an integer, are its binary logarithm
                // to 0.043
                let (p, q) = (self.to_bits() as $integer, divisor.to_bits() as $integer);
                // Wraps: lanes evaluate both branches, so that an input may be negative.
                let k = p.wrapping_sub(q).wrapping_add(1 << ($mantissa - 1)) >> $mantissa;
                (k as $float, $float::from_bits(q.wrapping_add(k << $mantissa) as _))
            }
            fn ln_quotient(self, divisor: Self) -> Self {
                elementary::ln_quotient(self, divisor)
            }
            #[inline(always)]
            fn ln_quotients<P: Strips<Self>>(x: P, divisor: Self) -> P {
                elementary::ln_quotients(x, divisor)
            }
            fn atan_of_unit(self) -> Self {
                elementary::atan_of_unit(self)
            }
            #[inline]
            fn lies_between(self, low: Self, high: Self) -> bool {
                self >= low && self <= high
            }
            fn lies_within(self, limit: Self) -> bool {
                self.to_bits() <= limit.to_bits()
            }
        }

        impl Arithmetic for $float {
            type Value = $float;
            const BRANCHES: bool = cfg!(target_os = "none");

            fn is_above(self, other: Self) -> bool {
                self > other
            }
            fn constant(x: f64) -> Self {
                x as $float
            }
            fn tiny() -> Self {
                $float::MIN_POSITIVE
            }

            fn from_base(x: $float) -> Self {
                x
            }
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

plain!(
    f64, i64, 52, |single, double| double,
    Float {
        type Contacts = Lanes<f64, 4>;
        type WideContacts = Lanes<f64, 8>;
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
    sqrt = root::of_f64, inverse_root = elementary::inverse_root_f64, abs = f64::abs
);
plain!(
    f32, i32, 23, |single, double| single,
    Float {
        type Contacts = Lanes<f32, 8>;
        type WideContacts = Lanes<f32, 16>;
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
    cube_root = elementary::cube_root, exp = libm::expf, atan = libm::atanf, ln = libm::logf;
    sqrt = root::of_f32, inverse_root = elementary::inverse_root_f32, abs = f32::abs
);
