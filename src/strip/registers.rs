//! Strips in registers of 256 bits, where the processor has such registers: the same bits in half the instructions.

#![allow(unsafe_code)]

use super::any::{Forces, both_kinds, of_eight, parts_of_eight};
use super::tables::FourStrips;
use super::totals::{Group, PreparedStrips, StripTotals, both_sides};
use crate::batch::side_by_side::available;
use crate::contact::forces::Totals;
use crate::number::lanes::{F64x4, Lanes};
use crate::number::pairs::Two;
use crate::number::{Number, Plain};

type Four = FourStrips<f64>;

/// Four strips.
struct One;
/// Twice as many: they do not wait for each other.
struct Twice<R>(core::marker::PhantomData<R>);

impl Group<f64> for One {
    type Strips = F64x4;
    type Places = Four;
    const FOURS: usize = 1;
    #[inline(always)]
    fn groups(fours: &'static [Four]) -> &'static [Four] {
        fours
    }
    #[inline(always)]
    fn all(x: f64) -> F64x4 {
        F64x4::stored(x)
    }
    #[inline(always)]
    fn couple(couple: &[f64; 2]) -> F64x4 {
        F64x4::of_array(both_sides(couple, false))
    }
    #[inline(always)]
    fn field(four: &Four, of: fn(&Four) -> &[f64; 2], odd: bool) -> F64x4 {
        F64x4::of_array(both_sides(of(four), odd))
    }
    #[inline(always)]
    fn sum([a, b, c, d]: &[F64x4; 4]) -> f64 {
        let [a, b, c, d] = ((*a + *c) + (*b + *d)).array();
        (a + c) + (b + d)
    }
}

impl<R: Group<f64>> Group<f64> for Twice<R> {
    type Strips = Two<R::Strips>;
    type Places = [R::Places; 2];
    const FOURS: usize = 2 * R::FOURS;
    #[inline(always)]
    fn groups(fours: &'static [Four]) -> &'static [Self::Places] {
        R::groups(fours).as_chunks().0
    }
    #[inline(always)]
    fn all(x: f64) -> Self::Strips {
        Two::side_by_side(R::all(x), R::all(x))
    }
    #[inline(always)]
    fn couple(couple: &[f64; 2]) -> Self::Strips {
        Two::side_by_side(R::couple(couple), R::couple(couple))
    }
    #[inline(always)]
    fn field(
        [first, second]: &Self::Places,
        of: fn(&Four) -> &[f64; 2],
        odd: bool,
    ) -> Self::Strips {
        Two::side_by_side(R::field(first, of, odd), R::field(second, of, odd))
    }
    #[inline(always)]
    fn sum([first, second, ..]: &[Self::Strips; 4]) -> f64 {
        let ([a, b], [c, d]) = (first.apart(), second.apart());
        R::sum(&[a, b, c, d])
    }
}

impl StripTotals for f64 {
    #[inline(always)]
    fn strip_totals<T: Number<Base = f64>>(
        strips: &PreparedStrips<f64>,
        creepage: [T; 3],
    ) -> Totals<T> {
        totals(strips, creepage)
    }
    #[inline(always)]
    fn eight_forces(seen: [[f64; 8]; 5], inner: [f64; 8]) -> Forces<f64, 8> {
        #[target_feature(enable = "avx")]
        fn wide(seen: [[f64; 8]; 5], inner: [f64; 8]) -> Forces<f64, 8> {
            both_kinds::<_, _, 8, false>(seen, inner, of_registers, registers).0
        }
        #[inline(never)]
        fn narrow(seen: [[f64; 8]; 5], inner: [f64; 8]) -> Forces<f64, 8> {
            both_kinds::<_, _, 8, false>(seen, inner, of_eight, parts_of_eight).0
        }
        if available() {
            // SAFETY: the processor was asked.
            unsafe { wide(seen, inner) }
        } else {
            narrow(seen, inner)
        }
    }
}

#[inline(always)]
fn of_registers([a, b, c, d, e, f, g, h]: [f64; 8]) -> Two<F64x4> {
    Two::side_by_side(F64x4::of_array([a, b, c, d]), F64x4::of_array([e, f, g, h]))
}

#[inline(always)]
fn registers(eight: Two<F64x4>) -> [f64; 8] {
    let [[a, b, c, d], [e, f, g, h]] = eight.apart().map(F64x4::array);
    [a, b, c, d, e, f, g, h]
}

#[inline]
fn totals<T: Number<Base = f64>>(strips: &PreparedStrips<f64>, creepage: [T; 3]) -> Totals<T> {
    #[target_feature(enable = "avx")]
    fn wide<T: Number<Base = f64>>(strips: &PreparedStrips<f64>, creepage: [T; 3]) -> Totals<T> {
        let law = strips.contact.seen(creepage);
        let seen = law.value();
        let sums = if T::HAS_DERIVATIVES {
            strips.sums::<One, true>(&seen)
        } else {
            match strips.fours() {
                1 => strips.sums::<One, false>(&seen),
                2 => strips.sums::<Twice<One>, false>(&seen),
                _ => strips.sums::<Twice<Twice<One>>, false>(&seen),
            }
        };
        strips.totals_of(&law, sums)
    }
    #[inline(never)]
    fn narrow<T: Number<Base = f64>>(strips: &PreparedStrips<f64>, creepage: [T; 3]) -> Totals<T> {
        strips.totals(creepage)
    }
    if available() {
        // SAFETY: the processor was asked.
        unsafe { wide(strips, creepage) }
    } else {
        narrow(strips, creepage)
    }
}
