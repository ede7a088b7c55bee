//! One strip after the other, with the bits of strips side by side: for machines that have few registers and little flash, and
//! where single strips are wanted.

use super::any::{Forces, Slopes};
use super::creepage::{Law, Prepared};
use super::derivative::{SpinSlopes, forces_and_slopes};
use super::kernel::{Carried, Seen, Spin, forces};
use super::tables::{FourStrips, STRIP_FIELDS, Tables};
use super::totals::{Sums, Together, by_law, fields, shares};
use crate::number::{Plain, Stored};

/// Derivatives of `f_x, f_y, m_x` by what a strip sees.
type SlopesOf<F> = [[F; 5]; 3];

/// Constants for the inner or the outer kind of nodes.
fn constants<F: Plain>(inner: bool) -> Tables<F::Stored, impl Fn(&[F::Stored; 2]) -> F> {
    Tables::new(move |couple: &[F::Stored; 2]| of_kind(couple, inner))
}

fn of_kind<F: Plain>(couple: &[F::Stored; 2], inner: bool) -> F {
    F::stored(couple.get(usize::from(inner)).copied().unwrap_or(couple[0]))
}

/// What a strip carries.
#[inline(never)]
fn solved<F: Plain>(seen: &Seen<F>, spin: &Spin<F>, inner: bool) -> Carried<F> {
    forces(seen, spin, &constants(inner), |_, _| ()).0
}

/// What a strip carries, with derivatives.
#[inline(never)]
fn differentiated<F: Plain>(
    seen: &Seen<F>,
    spin: &Spin<F>,
    by_spin: &SpinSlopes<F>,
    inner: bool,
) -> (Carried<F>, SlopesOf<F>) {
    forces_and_slopes(seen, spin, &constants(inner), by_spin)
}

/// The fields of a strip of a four, `[Y₀, Y₁, −Y₀, −Y₁]`.
pub(super) fn fields_of<F: Plain>(four: &FourStrips<Stored<F>>, lane: usize) -> [F; STRIP_FIELDS] {
    let sign = if lane >= 2 { -F::one() } else { F::one() };
    fields(|of, odd| {
        let field = of_kind::<F>(of(four), is_inner(lane));
        if odd { field * sign } else { field }
    })
}

/// What a strip of a four carries.
pub(super) fn strip<F: Plain>(
    strips: &Together<F>,
    fields: &[F; STRIP_FIELDS],
    lane: usize,
) -> Carried<F> {
    solved(&strips.seen(fields), &strips.spin, is_inner(lane))
}

fn is_inner(lane: usize) -> bool {
    lane & 1 == 1
}

/// Sums over strips in the order of [`super::PreparedStrips::sums`]: chains of every fourth four, each lane apart, and of four
/// chains or lanes `(c₀ + c₂) + (c₁ + c₃)`.
fn added_up<F: Plain, const ROWS: usize>(
    fours: &[FourStrips<Stored<F>>],
    own: impl Fn(&FourStrips<Stored<F>>, usize) -> [[F; 6]; ROWS],
) -> [[F; 6]; ROWS] {
    let add = |sums: &mut [[F; 6]; ROWS], own: &[[F; 6]; ROWS]| {
        for (sum, own) in sums.as_flattened_mut().iter_mut().zip(own.as_flattened()) {
            *sum += *own;
        }
    };
    let nothing = [[F::zero(); 6]; ROWS];
    let (mut waiting, mut sum) = ([nothing; 4], nothing);
    for i in 0..16 {
        let [lane, chain] = [i >> 2, i & 3].map(|k| (k & 1) << 1 | k >> 1);
        sum = nothing;
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
pub(super) fn sums<F: Plain, const SLOPES: bool>(
    contact: &Prepared<F>,
    fours: &[FourStrips<Stored<F>>],
    law: &Law<F>,
) -> Sums<F> {
    let strips = Together::new(law, |x| x);
    let row = |carried: Carried<F>, fields: &[F; STRIP_FIELDS]| {
        let [fx, fy, by_x, by_y, stick] = shares(carried, fields);
        [fx, fy, by_x, by_y, stick, F::zero()]
    };
    let ([fx, fy, by_x, by_y, stick, _], slopes) = if SLOPES {
        let arms = [contact.root, contact.upright];
        let [values, x, y, z] = added_up(fours, |four, lane| {
            let (fields, inner) = (fields_of(four, lane), is_inner(lane));
            let seen = strips.seen(&fields);
            let (carried, own) = differentiated(&seen, &strips.spin, &strips.by_spin, inner);
            let [x, y, z] = by_law(own, &fields, arms);
            [row(carried, &fields), x, y, z]
        });
        (values, [x, y, z])
    } else {
        let [values] = added_up(fours, |four, lane| {
            let fields = fields_of(four, lane);
            [row(strip(&strips, &fields, lane), &fields)]
        });
        (values, [[F::zero(); 6]; 3])
    };
    Sums::of([fx, fy, by_x, by_y, stick], slopes, contact)
}

/// Eight strips that have nothing in common, each with its share of the inner strips' nodes.
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
