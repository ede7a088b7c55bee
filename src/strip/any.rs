//! Strips of any shape side by side: those of a patch, which do not belong to one ellipse.
//!
//! Strips are of two kinds, whose nodes along the length are staggered. This module evaluates both
//! kinds side by side and mixes them; forces of strips that are wholly of one kind or the other are
//! evaluated with their own nodes.

use super::derivative::{SpinSlopes, alone_with_slopes, forces_and_slopes};
use super::kernel::{Spin, StripCreepage, forces};
use super::tables::Tables;
use crate::contact::totals::StripForces;
use crate::number::avx::with_avx;
use crate::number::lanes::Lanes;
use crate::number::{Arithmetic, Number, Real, Strips};

/// Eight strips: `A_x, A_y, σ`, the spread and the start of each, and the weight of the inner
/// strips' nodes in each, 0 to 1.
type StripColumns<F> = [[F; 8]; 6];
/// The forces `f_x, f_y, m_x` of eight strips and the share in adhesion, and the derivatives of the
/// first three with respect to the creepages.
type ForcesAndSlopes<F, const ROWS: usize> = ([[F; 8]; 4], [[[F; 8]; 5]; ROWS]);

/// Number of rows of derivatives: none, or that of the forces and the moment.
const NO_ROWS: usize = 0;
const FORCE_ROWS: usize = 3;

/// The forces of eight strips. Each has a weight of the inner strips' nodes, 0 to 1.
#[inline(never)]
pub fn eight_strips<T: Number>(
    seen: &[(StripCreepage<T>, T); 8], inner: [T::Base; 8],
) -> [StripForces<T>; 8] {
    // One function serves all numbers of derivatives, which keeps the code small.
    if T::HAS_DERIVATIVES {
        carried(seen, inner, both_kinds::<T::Base, FORCE_ROWS>)
    } else {
        carried(seen, inner, both_kinds::<T::Base, NO_ROWS>)
    }
}

/// The forces of eight strips, computed one after the other: the reference for the tests.
pub fn eight_one_by_one<T: Number>(
    seen: &[(StripCreepage<T>, T); 8], inner: [T::Base; 8],
) -> [StripForces<T>; 8] {
    if T::HAS_DERIVATIVES {
        carried(seen, inner, of_kinds::<T::Base, Lanes<T::Base, 1>, FORCE_ROWS>)
    } else {
        carried(seen, inner, of_kinds::<T::Base, Lanes<T::Base, 1>, NO_ROWS>)
    }
}

fn carried<T: Number, const ROWS: usize>(
    seen: &[(StripCreepage<T>, T); 8], inner: [T::Base; 8],
    forces: impl Fn(&StripColumns<T::Base>, &mut ForcesAndSlopes<T::Base, ROWS>),
) -> [StripForces<T>; 8] {
    let all = |of: fn(&(StripCreepage<T>, T)) -> T| seen.each_ref().map(|own| of(own).value());
    let eight = [
        all(|(seen, _)| seen.x),
        all(|(seen, _)| seen.y),
        all(|(_, spin)| *spin),
        all(|(seen, _)| seen.spread),
        all(|(seen, _)| seen.start),
        inner,
    ];
    let zero = T::Base::zero();
    // Written in place: a copy would take room on the stack.
    let mut found = ([[zero; 8]; 4], [[[zero; 8]; 5]; ROWS]);
    forces(&eight, &mut found);
    let ([fx, fy, mx, stick], slopes) = &found;
    let mut lane = 0;
    seen.each_ref().map(|(seen, spin)| {
        let of = |all: &[T::Base; 8]| all.get(lane).copied().unwrap_or(T::Base::zero());
        let by = [seen.x, seen.y, *spin, seen.spread, seen.start];
        let composed = |value: &[T::Base; 8], row: usize| {
            let slopes = slopes.get(row).map_or([zero; 5], |slopes| slopes.each_ref().map(of));
            T::composed(of(value), slopes, by)
        };
        let carried = StripForces {
            fx: composed(fx, 0),
            fy: composed(fy, 1),
            mx: composed(mx, 2),
            stick: T::from_base(of(stick)),
        };
        lane += 1;
        carried
    })
}

/// Whether code is small rather than fast: on a microcontroller and in a browser nodes of both
/// kinds are computed where one kind would do.
const IS_SMALL: bool = cfg!(any(target_os = "none", target_family = "wasm"));

fn both_kinds<F: Real, const ROWS: usize>(
    eight: &StripColumns<F>, found: &mut ForcesAndSlopes<F, ROWS>,
) {
    with_avx!(if 1 => <F: Real; ROWS>(
        eight: &StripColumns<F>,
        found: &mut ForcesAndSlopes<F, ROWS>
    ) -> () {
        if cfg!(target_os = "none") {
            // Machines without wide registers compute one strip after the other, which needs less
            // flash.
            of_kinds::<F, Lanes<F, 1>, ROWS>(eight, found)
        } else {
            of_kinds::<F, F::Eight, ROWS>(eight, found)
        }
    } {
        of_kinds::<F, F::WideEight, ROWS>(eight, found)
    })
}

/// Computes as many strips at a time as `P` holds side by side.
#[inline(always)]
fn of_kinds<F: Real, P: Strips<F>, const ROWS: usize>(
    eight: &StripColumns<F>, found: &mut ForcesAndSlopes<F, ROWS>,
) {
    let zero = F::zero();
    let (carried, slopes) = found;
    for first in (0..8).step_by(P::COUNT) {
        let gather = |of: &[F; 8]| P::gather(|k| of.get(first + k).copied().unwrap_or(zero));
        let [x, y, spin, spread, start, inner] = eight.each_ref().map(gather);
        let are_mixed = P::any_exceeds([inner * (P::one() - inner)], [P::zero()]);
        if !are_mixed && !IS_SMALL {
            let constants = Tables::<F::Stored, _>::new(|kinds: &[_; 2]| {
                let [outer, own] = kinds.map(|constant| P::all(F::stored(constant)));
                inner.choose(own, outer)
            });
            let (seen, spin) = (StripCreepage { x, y, spread, start }, Spin::new(spin));
            let (StripForces { fx, fy, mx, stick }, own) = if ROWS == FORCE_ROWS {
                forces_and_slopes(&seen, &spin, &constants, &SpinSlopes::new(&spin))
            } else {
                (forces(&seen, &spin, &constants, |_, _| ()).0, [[P::zero(); 5]; 3])
            };
            let numbers = [fx, fy, mx, stick].into_iter().chain(own.into_iter().flatten());
            let columns = carried.iter_mut().chain(slopes.as_flattened_mut());
            for (column, own) in columns.zip(numbers) {
                for (k, place) in column.iter_mut().skip(first).take(P::COUNT).enumerate() {
                    *place = own.lane(k);
                }
            }
            continue;
        }
        let put = |places: &mut [F; 8], kinds: Lanes<P, 2>| {
            let [outer, own] = kinds.numbers();
            let mixed = outer * (P::one() - inner) + own * inner;
            for (k, place) in places.iter_mut().skip(first).take(P::COUNT).enumerate() {
                *place = mixed.lane(k);
            }
        };
        if cfg!(target_os = "none") && ROWS == FORCE_ROWS {
            // One kind after the other, by the function of all strips.
            let (seen, spin) = (StripCreepage { x, y, spread, start }, Spin::new(spin));
            let by_spin = SpinSlopes::new(&spin);
            let [(outer, of_outer), (own, of_own)] =
                [false, true].map(|kind| alone_with_slopes(&seen, &spin, kind, &by_spin));
            let own_slopes = of_outer.as_flattened().iter().zip(of_own.as_flattened());
            for (slopes, (outer, own)) in slopes.as_flattened_mut().iter_mut().zip(own_slopes) {
                put(slopes, Lanes::new([*outer, *own]));
            }
            let outer = [outer.fx, outer.fy, outer.mx, outer.stick];
            let both = outer.into_iter().zip([own.fx, own.fy, own.mx, own.stick]);
            for (carried, (outer, own)) in carried.iter_mut().zip(both) {
                put(carried, Lanes::new([outer, own]));
            }
            continue;
        }
        // First with the nodes of one kind of strip, then with those of the other.
        let [x, y, spin, spread, start] =
            [x, y, spin, spread, start].map(|strips| Lanes::new([strips; 2]));
        let (seen, spin) = (StripCreepage { x, y, spread, start }, Spin::new(spin));
        let constants = Tables::<F::Stored, _>::new(|kinds: &[_; 2]| {
            Lanes::new(kinds.map(|constant| P::all(F::stored(constant))))
        });
        let StripForces { fx, fy, mx, stick } = if ROWS == FORCE_ROWS {
            let by_spin = SpinSlopes::new(&spin);
            let (carried, own) = forces_and_slopes(&seen, &spin, &constants, &by_spin);
            for (slopes, own) in slopes.as_flattened_mut().iter_mut().zip(own.as_flattened()) {
                put(slopes, *own);
            }
            carried
        } else {
            forces(&seen, &spin, &constants, |_, _| ()).0
        };
        for (carried, own) in carried.iter_mut().zip([fx, fy, mx, stick]) {
            put(carried, own);
        }
    }
}
