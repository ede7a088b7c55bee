//! Hand-written derivatives of the integrals, where dual numbers would cost more or fail at an
//! edge.

use crate::number::tables::{row, table};
use crate::number::{Arithmetic, Number, Pair, Real};
use crate::strip_1967::edge::Arc;
use crate::strip_1967::integrals::{Both, GAUSS_6, GaussNode, Pieces, Shares, moment};
use crate::strip_1967::reduced::ReducedCreepage;
use crate::strip_1967::strip::SlidingRule;

/// `∫ C K dY` with its derivatives. Those with respect to the ends correct the error of the nodes.
#[inline(always)]
pub(super) fn stretch_with_slopes<T: Number>(
    motion: &ReducedCreepage<T>, arc: &Arc<T>, [parting, level]: [T; 2], pieces: &Pieces<T::Base>,
    stretch: T::Base,
) -> T {
    let ReducedCreepage { eta, psi, slope: p, .. } = motion.values();
    let Arc { lower, upper, middle, .. } = arc.values();
    let (both, least) = (Both::<T>::both, pieces.least);
    let mut value = Both::<T>::zero();
    let mut sums = [Both::<T>::zero(); 8];
    for [node, weight] in table!(T::Base, GAUSS_6).iter().map(row::<T::Base, 2>) {
        let GaussNode { t, d, c, x, s, above, below, bound, share } = pieces.at(node, weight);
        value += share;
        // S dK = ξ̄ dξ̄ + (η + ψ K)(dη + K dψ)
        let (k, inverse) = (above / below, d.inverse());
        let (edge, is) = (bound * inverse * inverse, (s + Both::<T>::tiny()).inverse());
        let y = (both(middle.y) - t * (t.by(middle.y) - both(middle.c.times(2.0)))) * inverse;
        let (by_x, by_eta) = (edge * inverse * x * is, edge * (k.by(psi).more(eta)) * is);
        // along the edge C² (K − least) changes by −2 C Y (K − least) − C³ p ξ̄/S
        let c = c * inverse;
        let bend = (y * (k - both(least))).times(2.0) + c * c * (x * is).by(p);
        let bend = -(c.by(weight) * inverse * bend);
        let by_t = ((bend - share * t) * inverse).times(2.0);
        let flat = edge * inverse;
        let parts = [by_x, -(by_x * y), by_eta, by_eta * k, bend, by_t, by_t.by(node), flat];
        for (sum, part) in sums.iter_mut().zip(parts) {
            *sum += part;
        }
    }
    let [by_x, by_p, by_eta, by_psi, bend, by_t, by_node, flat] = sums;
    // dθ = 2 dt/(1 + t²)
    let whole = |sum: Both<T>| (sum * pieces.half).sum().times(2.0);
    // With respect to the tangents of the pieces' ends.
    let (by_centre, by_half) = (pieces.half * by_t, value + pieces.half * by_node);
    let ((first, before), (after, last)) =
        ((by_centre - by_half).parts(), (by_centre + by_half).parts());
    let slopes = [
        whole(by_x),
        whole(by_p),
        whole(by_eta),
        whole(by_psi),
        last - first,
        before + after,
        whole(bend) / middle.c,
        stretch - whole(flat),
        lower.c * (lower.c - least),
        upper.c * (least - upper.c),
    ];
    let ReducedCreepage { xi, eta, psi, slope: p, .. } = *motion;
    let ends = [arc.lower.y, arc.upper.y];
    let inputs = [xi, p, eta, psi, arc.tangent, parting, arc.middle.y, level, ends[0], ends[1]];
    T::composed(whole(value) + least * stretch, slopes, inputs)
}

/// With `w = (u, ε)/D`, `D = √(u² + ε²)`, and `J_n = ∫ uⁿ/D du`: the derivatives with respect to
/// `h` and `ε` of `∫ C² (w_x, w_y, Y w_x) dY`.
///
/// Those of `u/D` and `ε/D` are `(ε², −u ε)` and `(−u ε, u²)` over `D³`, with `N_n = ∫ uⁿ/D³ du`.
#[inline]
pub(super) fn slip_with_slopes<F: Real>(
    [h, e, e2]: [F; 3], [u1, u2, d1, d2]: [F::Pair; 4], [j0, j1, j2]: [F; 3], by: [F; 2],
) -> [[F; 2]; 3] {
    let e2n0 = (u1 / d1 - u2 / d2).sum();
    let n1 = (d2.inverse() - d1.inverse()).sum();
    let n2 = j0 - e2n0;
    let (n3, n4) = (j1 - e2 * n1, j2 - e2 * n2);
    let xx = moment(by, [e2n0, e2 * n1, e2 * n2]);
    let xy = -(e * moment(by, [n1, n2, n3]));
    let yy = moment(by, [n2, n3, n4]);
    [[xx, xy], [xy, yy], [h * xx + e * xy, h * xy + e * yy]]
}

/// Derivatives of integrals with respect to their ends, where the force jumps. The values are zero.
pub(super) fn jumps<T: Number>(motion: &ReducedCreepage<T>, moving: &Arc<T>) -> Shares<T> {
    let ReducedCreepage { xi, eta, psi, slope: p, compliance, rule, .. } = motion.values();
    let (Arc { lower, upper, .. }, both) = (moving.values(), Both::<T>::both);
    let (y, c) = (Both::<T>::couple(lower.y, upper.y), Both::<T>::couple(lower.c, upper.c));
    let x = both(xi) - y.by(p);
    let z = x.by(compliance);
    // C² divided by the slip of a strip that slides; the nodes of the continuous rule include it.
    let rigid = T::Base::constant(if rule == SlidingRule::RigidSlip { 1.0 } else { 0.0 });
    let slip = c.by(rigid) / (z * z).more(eta * eta + T::TINY).sqrt();
    let fx = (x - z * slip) * c;
    let fy = (c.by(psi).more(eta) - slip.by(eta)) * c;
    let along = |jump: Both<T>| {
        let (first, last) = jump.parts();
        let ends = [moving.lower.y, moving.upper.y];
        T::composed(T::Base::zero(), [-first, last], ends)
    };
    [along(fx), along(fy), T::zero(), along(fx * y), T::zero()]
}
