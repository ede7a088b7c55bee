//! The functions of C in either precision, under one name each.

use kstrip::contact::Contact;
use kstrip::contact::creepage::Creepage;
use kstrip::ffi::types::{BatchInputs, BatchOutputs, Outputs, kstrip_options};
use kstrip::ffi::{double, single};
use kstrip::forces::Solution;
use kstrip::forces::field::FieldPoint;
use kstrip::forces::prepared::Prepared;
use kstrip::friction::SlipFriction;
use kstrip::number::Float;
use std::mem::MaybeUninit;

/// A contact, its creepage, and options.
pub type Asked<'a, F> = (&'a Contact<F>, &'a Creepage<F>, &'a kstrip_options);

/// A precision. The functions return statuses; what they take is there.
pub trait InC: Float + Default {
    fn bits(self) -> u64;
    fn solve(asked: Asked<Self>, out: &mut MaybeUninit<Solution<Self>>) -> i32;
    fn prepare(
        contact: &Contact<Self>, options: &kstrip_options, out: &mut MaybeUninit<Prepared<Self>>,
    ) -> i32;
    fn solve_prepared(
        prepared: &Prepared<Self>, creepage: &Creepage<Self>, out: &mut MaybeUninit<Solution<Self>>,
    ) -> i32;
    /// # Safety
    /// Outputs are NULL or places.
    unsafe fn evaluate(
        asked: Asked<Self>, law: Option<&SlipFriction<Self>>, to: &Outputs<Self>,
    ) -> i32;
    /// # Safety
    /// Inputs and outputs are NULL or have so many elements.
    unsafe fn batch(
        from: &BatchInputs<Self>, count: usize, options: &kstrip_options, to: &BatchOutputs<Self>,
        bad: Option<&mut MaybeUninit<u32>>,
    ) -> i32;
    /// # Safety
    /// There is a place for each point.
    unsafe fn field(asked: Asked<Self>, x: &[Self], y: &[Self], to: *mut FieldPoint<Self>) -> i32;
}

/// Forces, moment, power and stick area.
pub fn bits_of<F: InC>(r: &Solution<F>) -> [u64; 5] {
    [r.fx, r.fy, r.mz, r.power, r.adhesion].map(F::bits)
}

macro_rules! in_c {
    ($float:ident, $functions:ident) => {
        impl InC for $float {
            fn bits(self) -> u64 {
                self.to_bits().into()
            }
            fn solve((c, m, o): Asked<Self>, out: &mut MaybeUninit<Solution<Self>>) -> i32 {
                $functions::kstrip_solve(Some(c), Some(m), Some(o), Some(out))
            }
            fn prepare(
                contact: &Contact<Self>, options: &kstrip_options,
                out: &mut MaybeUninit<Prepared<Self>>,
            ) -> i32 {
                $functions::kstrip_prepare(Some(contact), Some(options), Some(out))
            }
            fn solve_prepared(
                prepared: &Prepared<Self>, creepage: &Creepage<Self>,
                out: &mut MaybeUninit<Solution<Self>>,
            ) -> i32 {
                $functions::kstrip_solve_prepared(Some(prepared), Some(creepage), Some(out))
            }
            unsafe fn evaluate(
                (c, m, o): Asked<Self>, law: Option<&SlipFriction<Self>>, to: &Outputs<Self>,
            ) -> i32 {
                unsafe { $functions::kstrip_evaluate(Some(c), Some(m), law, Some(o), Some(to)) }
            }
            unsafe fn batch(
                from: &BatchInputs<Self>, count: usize, options: &kstrip_options,
                to: &BatchOutputs<Self>, bad: Option<&mut MaybeUninit<u32>>,
            ) -> i32 {
                let (from, options, to) = (Some(from), Some(options), Some(to));
                unsafe { $functions::kstrip_evaluate_batch(from, count as u32, options, to, bad) }
            }
            unsafe fn field(
                (c, m, o): Asked<Self>, x: &[Self], y: &[Self], to: *mut FieldPoint<Self>,
            ) -> i32 {
                let (c, m, o) = (Some(c), Some(m), Some(o));
                let (columns, rows) = (x.len() as u32, y.len() as u32);
                let (x, y, points) = (x.as_ptr(), y.as_ptr(), columns * rows);
                unsafe { $functions::kstrip_field(c, m, None, o, x, columns, y, rows, to, points) }
            }
        }
    };
}

in_c!(f64, double);
in_c!(f32, single);
