//! Strips of any shape, side by side, that are not those of one ellipse.
//!
//! Strips are of two kinds, whose nodes along the length are staggered. Here both kinds are evaluated side by side, and mixed.

use super::derivative::{SpinSlopes, forces_and_slopes};
use super::kernel::{Carried, Seen, Spin, forces};
use super::tables::Tables;
use super::totals::StripTotals;
use crate::number::pairs::Two;
use crate::number::{Arithmetic, Number, Plain, Quad};

/// What strips carry, `F_x, F_y`, the moment and the share in adhesion.
pub type Forces<F, const N: usize> = [[F; N]; 4];

/// Derivatives of the first three by what the strips see: `A_x, A_y, σ`, the spread and the start.
pub type Slopes<F, const N: usize> = [[[F; N]; 5]; 3];

/// What eight strips carry. Each has its share of the inner strips' nodes, 0 to 1.
#[inline(never)]
pub(crate) fn eight_strips<T: Number<Base: StripTotals>>(
    seen: &[(Seen<T>, T); 8],
    inner: [T::Base; 8],
) -> [Carried<T>; 8] {
    let all = |of: fn(&(Seen<T>, T)) -> T| seen.each_ref().map(|own| of(own).value());
    let plain = [
        all(|(seen, _)| seen.x),
        all(|(seen, _)| seen.y),
        all(|(_, spin)| *spin),
        all(|(seen, _)| seen.spread),
        all(|(seen, _)| seen.start),
    ];
    let ([fx, fy, mx, stick], [by_x, by_y, by_m]) = if T::HAS_DERIVATIVES {
        T::Base::eight_slopes(plain, inner)
    } else {
        (T::Base::eight_forces(plain, inner), [[[T::Base::zero(); 8]; 5]; 3])
    };
    let mut lane = 0;
    seen.each_ref().map(|(seen, spin)| {
        let of = |all: &[T::Base; 8]| all.get(lane).copied().unwrap_or(T::Base::zero());
        let by = [seen.x, seen.y, *spin, seen.spread, seen.start];
        let follow = |value: &[T::Base; 8], slopes: &[[T::Base; 8]; 5]| {
            T::follow(of(value), slopes.each_ref().map(of), by)
        };
        let carried = Carried {
            fx: follow(&fx, &by_x),
            fy: follow(&fy, &by_y),
            mx: follow(&mx, &by_m),
            stick: T::from_base(of(&stick)),
        };
        lane += 1;
        carried
    })
}

/// Eight in [`Number::Quad`].
#[inline(always)]
pub(super) fn of_eight<F: Plain>([a, b, c, d, e, f, g, h]: [F; 8]) -> Two<F::Quad> {
    Two::side_by_side(F::Quad::plain([a, b, c, d]), F::Quad::plain([e, f, g, h]))
}

#[inline(always)]
pub(super) fn parts_of_eight<F: Plain>(eight: Two<F::Quad>) -> [F; 8] {
    let [[a, b, c, d], [e, f, g, h]] = eight.apart().map(Quad::parts);
    [a, b, c, d, e, f, g, h]
}

/// Both kinds of `N` strips in numbers `P` of so many, mixed by the share of the inner kind.
#[inline(always)]
pub(super) fn both_kinds<F: Plain, P: Arithmetic<Bare = P>, const N: usize, const SLOPES: bool>(
    seen: [[F; N]; 5],
    inner: [F; N],
    of: impl Fn([F; N]) -> P + Copy,
    parts: impl Fn(P) -> [F; N] + Copy,
) -> (Forces<F, N>, Slopes<F, N>) {
    let twice = |strips: [F; N]| Two::side_by_side(of(strips), of(strips));
    let [x, y, spin, spread, start] = seen.map(twice);
    let (seen, spin) = (Seen { x, y, spread, start }, Spin::new(spin));
    let constants = Tables::<F::Stored, _>::new(|[outer, inner]: &[F::Stored; 2]| {
        let all = |constant: &F::Stored| of([F::stored(*constant); N]);
        Two::side_by_side(all(outer), all(inner))
    });
    let share = of(inner);
    let mixed = |both: Two<P>| {
        let [outer, inner] = both.apart();
        parts(outer + (inner - outer) * share)
    };
    let none = [[[F::zero(); N]; 5]; 3];
    let (Carried { fx, fy, mx, stick }, slopes) = if SLOPES {
        let (carried, slopes) =
            forces_and_slopes(&seen, &spin, &constants, &SpinSlopes::new(&spin));
        (carried, slopes.map(|slopes| slopes.map(mixed)))
    } else {
        (forces(&seen, &spin, &constants, |_, _| ()).0, none)
    };
    ([fx, fy, mx, stick].map(mixed), slopes)
}
