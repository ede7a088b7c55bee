//! One strip after the other, with the bits of strips side by side: for machines that have few registers and little flash, and
//! where single strips are wanted.

use super::any::{Forces, Slopes};
use super::creepage::{Law, Prepared};
use super::derivative::{SpinSlopes, forces_and_slopes};
use super::kernel::{Carried, Seen, Spin, forces};
use super::tables::{FourStrips, STRIP_FIELDS, Tables};
use super::totals::Sums;
use crate::number::{Plain, Stored};

/// Derivatives of `f_x, f_y, m_x` by what a strip sees.
type SlopesOf<F> = [[F; 5]; 3];

/// Constants for the inner or the outer kind of nodes.
#[inline(always)]
fn constants<F: Plain>(inner: bool) -> Tables<F::Stored, impl Fn(&[F::Stored; 2]) -> F> {
    Tables::new(move |couple: &[F::Stored; 2]| of_kind(couple, inner))
}

#[inline(always)]
fn of_kind<F: Plain>(couple: &[F::Stored; 2], inner: bool) -> F {
    F::stored(couple.get(usize::from(inner)).copied().unwrap_or(couple[0]))
}

/// What a strip carries.
#[cfg_attr(target_os = "none", inline(never))]
fn solved<F: Plain>(seen: &Seen<F>, spin: &Spin<F>, inner: bool) -> Carried<F> {
    forces(seen, spin, &constants(inner), |_, _| ()).0
}

/// What a strip carries, with derivatives.
#[cfg_attr(target_os = "none", inline(never))]
fn differentiated<F: Plain>(
    seen: &Seen<F>,
    spin: &Spin<F>,
    by_spin: &SpinSlopes<F>,
    inner: bool,
) -> (Carried<F>, SlopesOf<F>) {
    forces_and_slopes(seen, spin, &constants(inner), by_spin)
}

/// The strips of an ellipse.
pub(super) struct Apart<F: Plain> {
    law: Law<F>,
    spin: Spin<F>,
    by_spin: SpinSlopes<F>,
}

impl<F: Plain> Apart<F> {
    #[inline(always)]
    pub(super) fn new(law: &Law<F>) -> Self {
        let spin = Spin::new(law.spin);
        Self { law: *law, by_spin: SpinSlopes::new(&spin), spin }
    }

    /// The fields of a strip of a four, `[Y₀, Y₁, −Y₀, −Y₁]`, and what it sees.
    #[inline(always)]
    fn seen(&self, four: &FourStrips<Stored<F>>, lane: usize) -> ([F; STRIP_FIELDS], Seen<F>) {
        let read = |couple| of_kind::<F>(couple, is_inner(lane));
        let sign = if lane >= 2 { -F::one() } else { F::one() };
        let odd = |couple| read(couple) * sign;
        let [y, inverse, bend_y, load, load_c, load_y, area, width] = four;
        let (y, inverse, bend_y, width) = (odd(y), read(inverse), odd(bend_y), read(width));
        let fields = [y, inverse, bend_y, read(load), read(load_c), odd(load_y), read(area), width];
        let Law { longitudinal, lateral, slope, bend, start, .. } = self.law;
        // A_x = (a_x − ρ Y (1 + ε (0.4 − Y²)))/C,  A_y = a_y/C
        let seen = Seen {
            x: (longitudinal - slope * (bend * bend_y + y)) * inverse,
            y: lateral * inverse,
            spread: slope * width,
            start,
        };
        (fields, seen)
    }

    /// What a strip of a four carries, and its fields.
    #[inline(always)]
    pub(super) fn strip(
        &self,
        four: &FourStrips<Stored<F>>,
        lane: usize,
    ) -> (Carried<F>, [F; STRIP_FIELDS]) {
        let (fields, seen) = self.seen(four, lane);
        (solved(&seen, &self.spin, is_inner(lane)), fields)
    }

    /// Its shares of `f_x, f_y`, the two parts of the moment, and the stick area.
    #[inline(always)]
    fn shares(carried: Carried<F>, fields: &[F; STRIP_FIELDS]) -> [F; 5] {
        let [.., load, load_c, load_y, area, _] = *fields;
        let Carried { fx, fy, mx, stick } = carried;
        [fx * load, fy * load, mx * load_c, fx * load_y, stick * area]
    }

    /// Those, and the derivatives of force and moment by `Law::numbers`.
    #[inline(always)]
    fn with_slopes(
        &self,
        four: &FourStrips<Stored<F>>,
        lane: usize,
        [root, upright]: [F; 2],
    ) -> [F; 23] {
        let (fields, seen) = self.seen(four, lane);
        let (carried, [x, y, mut z]) =
            differentiated(&seen, &self.spin, &self.by_spin, is_inner(lane));
        let [at, inverse, bend, load, load_c, load_y, _, width] = fields;
        // Mz = ∫ (x Y − y X): lever arms √(a/b) C x̂ and √(b/a) Y
        let (arm_m, arm_x) = (load_c * root, load_y * upright);
        for (z, x) in z.iter_mut().zip(x) {
            *z = *z * arm_m - x * arm_x;
        }
        let mut all = [F::zero(); 23];
        let (values, slopes) = all.split_at_mut(5);
        for (value, own) in values.iter_mut().zip(Self::shares(carried, &fields)) {
            *value = own;
        }
        let of = [F::each(&x, |s| *s * load), F::each(&y, |s| *s * load), z];
        for (six, [by_x, by_y, by_spin, by_spread, by_start]) in
            slopes.as_chunks_mut::<6>().0.iter_mut().zip(of)
        {
            let scaled = by_x * inverse;
            let slope = by_spread * width - scaled * at;
            *six = [scaled, by_y * inverse, slope, -(scaled * bend), by_spin, by_start];
        }
        all
    }
}

fn is_inner(lane: usize) -> bool {
    lane & 1 == 1
}

/// Sums over strips in the order of [`super::PreparedStrips::sums`]: chains of every fourth four, each lane apart, and of four
/// chains or lanes `(c₀ + c₂) + (c₁ + c₃)`.
#[inline(always)]
fn added_up<F: Plain, const N: usize>(
    fours: &[FourStrips<Stored<F>>],
    own: impl Fn(&FourStrips<Stored<F>>, usize) -> [F; N],
) -> [F; N] {
    let add = |sums: &mut [F; N], own: &[F; N]| {
        for (sum, own) in sums.iter_mut().zip(own) {
            *sum += *own;
        }
    };
    let mut waiting = [[F::zero(); N]; 4];
    let mut sum = [F::zero(); N];
    for i in 0..16 {
        let [lane, chain] = [i >> 2, i & 3].map(|k| (k & 1) << 1 | k >> 1);
        sum = [F::zero(); N];
        for four in fours.iter().skip(chain).step_by(4) {
            add(&mut sum, &own(four, lane));
        }
        // like the digits of a binary counter
        for (k, before) in waiting.iter_mut().enumerate() {
            if i >> k & 1 == 0 {
                *before = sum;
                break;
            }
            add(&mut sum, before);
        }
    }
    sum
}

/// The sums over the strips of an ellipse.
#[inline(always)]
pub(super) fn sums<F: Plain, const SLOPES: bool>(
    contact: &Prepared<F>,
    fours: &[FourStrips<Stored<F>>],
    law: &Law<F>,
) -> Sums<F> {
    let strips = Apart::new(law);
    let mut slopes = [[F::zero(); 6]; 3];
    if !SLOPES {
        let values = added_up(fours, |four, lane| {
            let (carried, fields) = strips.strip(four, lane);
            Apart::shares(carried, &fields)
        });
        return Sums::of(values, slopes, contact);
    }
    let arms = [contact.root, contact.upright];
    let all = added_up(fours, |four, lane| strips.with_slopes(four, lane, arms));
    let [a, b, c, d, e, rest @ ..] = all;
    for (six, own) in slopes.iter_mut().zip(rest.as_chunks::<6>().0) {
        *six = *own;
    }
    Sums::of([a, b, c, d, e], slopes, contact)
}

/// Eight strips that have nothing in common, each with its share of the inner strips' nodes.
#[inline(always)]
pub(super) fn eight<F: Plain, const SLOPES: bool>(
    seen: [[F; 8]; 5],
    inner: [F; 8],
) -> (Forces<F, 8>, Slopes<F, 8>) {
    let mut found = [[F::zero(); 8]; 4];
    let mut slopes = [[[F::zero(); 8]; 5]; 3];
    for lane in 0..8 {
        let of = |all: &[F; 8]| all.get(lane).copied().unwrap_or(F::zero());
        let [x, y, sigma, spread, start] = F::each(&seen, of);
        let (seen, spin) = (Seen { x, y, spread, start }, Spin::new(sigma));
        let share = of(&inner);
        let put = |all: &mut [F; 8], outer: F, inner: F| {
            if let Some(place) = all.get_mut(lane) {
                *place = outer + (inner - outer) * share;
            }
        };
        let numbers = |carried: Carried<F>| [carried.fx, carried.fy, carried.mx, carried.stick];
        let (outer, inner) = if SLOPES {
            let by_spin = SpinSlopes::new(&spin);
            let (outer, by_outer) = differentiated(&seen, &spin, &by_spin, false);
            let (inner, by_inner) = differentiated(&seen, &spin, &by_spin, true);
            for ((all, outer), inner) in slopes.iter_mut().zip(by_outer).zip(by_inner) {
                for ((all, outer), inner) in all.iter_mut().zip(outer).zip(inner) {
                    put(all, outer, inner);
                }
            }
            (outer, inner)
        } else {
            (solved(&seen, &spin, false), solved(&seen, &spin, true))
        };
        for ((all, outer), inner) in found.iter_mut().zip(numbers(outer)).zip(numbers(inner)) {
            put(all, outer, inner);
        }
    }
    (found, slopes)
}
