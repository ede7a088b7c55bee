//! Strips that adhere, by the primitives of Section 7.1; `∫ C K dY`, which is not elementary, by
//! nodes.

use crate::number::tables::{row, table};
use crate::number::{Arithmetic, Number, Pair, Real, Stored, branch_or_blend};
use crate::strip_1967::edge::{Arc, Edge};
use crate::strip_1967::integrals::{Both, GAUSS_4, GAUSS_6, Pieces, Shares, arcsinh, far, rounded};
use crate::strip_1967::reduced::ReducedCreepage;
use crate::strip_1967::slopes;

/// Square root of the distance between 1 and the next number.
#[inline]
fn root_epsilon<T: Number>() -> f64 {
    if size_of::<Stored<T>>() == 4 { 3.5e-4 } else { 1.5e-8 }
}

/// Strips with adhesion: `f_x = ξ̄ (2C − K)`, `f_y = ψ C² + η (2C − K)`, `m_x = −η (C − K)²`. The
/// ends count as fixed, so that derivatives are those of the integrands.
#[inline(always)]
pub(super) fn adhering<T: Number>(motion: &ReducedCreepage<T>, moving: &Arc<T>) -> Shares<T> {
    let ReducedCreepage { xi, eta, psi, slope: p, q, eta_psi: m, .. } = *motion;
    let values = motion.values();
    let arc = moving.values();
    let (Edge { y: y1, c: c1 }, Edge { y: y2, c: c2 }) = (arc.lower, arc.upper);
    let (width, sum) = (y2 - y1, y1 + y2);
    // ∫ C dY = (asin Y + Y C)/2, ∫ Y C dY = −C³/3, ∫ Y² C dY = (asin Y − Y C (1 − 2Y²))/8, ∫ C² dY
    // = Y − Y³/3
    let angle = arc.tangent.atan_of_unit().times(4.0);
    let (yc1, yc2) = (y1 * c1, y2 * c2);
    let c = (angle + (yc2 - yc1)).times(0.5);
    let yc = (c1 * c1 * c1 - c2 * c2 * c2).times(1.0 / 3.0);
    let bent = |y: T::Base, yc: T::Base| yc * (T::Base::one() - (y * y).times(2.0));
    // On a narrow arc this difference has only the rounding of the angle, so that it is limited to
    // the range of the integrand.
    let most = (y1 * y1).max(y2 * y2) * width;
    let yyc = (angle - (bent(y2, yc2) - bent(y1, yc1))).times(0.125);
    let yyc = yyc.min(most).max(T::Base::zero());
    let yy = (y1 * y1 + y1 * y2 + y2 * y2).times(1.0 / 3.0);
    let cc = width * (T::Base::one() - yy);
    // S is nearly straight where the zero of S² is far from the interval.
    let (middle, half) = (sum.times(0.5), width.times(0.5));
    let (x, bend) = (values.xi_bar(middle), values.slope * half);
    let smooth = values.eta * values.eta
        + values.q * (x * x - (bend * bend).times(far::<T>() * far::<T>()))
        + T::TINY;
    let [k, xk, yxk, kk] = branch_or_blend!(
        T::from_base(smooth),
        {
            // ∫ (K, ξ̄ K, Y ξ̄ K, K²) dY by nodes
            let mut sums = [T::Pair::zero(); 4];
            for [node, weight] in table!(T::Base, GAUSS_4).iter().map(row::<T::Base, 2>) {
                let y = Both::<T>::both(middle) + Both::<T>::couple(half, -half).by(node);
                let x = T::Pair::both(xi) - T::Pair::both(p).scale(y);
                let k = adhesion_on_arc(motion, x);
                let (share, xk) = (k.by(weight), (x * k).by(weight));
                for (sum, part) in sums.iter_mut().zip([share, xk, xk.scale(y), share * k]) {
                    *sum += part;
                }
            }
            T::each(&sums, |sum| sum.sum().scale(half))
        },
        {
            // S = σ D with D = √(u² + ε²)
            let (root, inverse) = (q.sqrt(), p.inverse());
            let (h, e) = (xi * inverse, eta * inverse / root);
            let sigma = p * root;
            let (h0, e0) = (h.value(), e.value());
            let e2 = rounded(e0);
            let (u1, u2) = (h0 - y1, h0 - y2);
            let (d1, d2) = ((u1 * u1 + e2).sqrt(), (u2 * u2 + e2).sqrt());
            let (above, below) = arcsinh(u1, u2, d1, d2, e2);
            // ∫ D du = (u D + ε² asinh(u/ε))/2,  ∫ u D du = D³/3,  ∫ u² D du = (u D³ − ε² ∫ D du)/4
            let (ud1, ud2, j0) = (u1 * d1, u2 * d2, above.ln_quotient(below));
            let (j1, ud) = (d1 - d2, ud1 - ud2);
            let i0 = (ud + e2 * j0).times(0.5);
            let (cube1, cube2) = (d1 * d1 * d1, d2 * d2 * d2);
            let i1 = (cube1 - cube2).times(1.0 / 3.0);
            let i2 = (u1 * cube1 - u2 * cube2 - e2 * i0).times(0.25);
            // d/dh ∫ uⁿ D du = uⁿ D,  d/dε ∫ uⁿ D du = ε ∫ uⁿ/D du
            let j2 = (ud - e2 * j0).times(0.5);
            let moment =
                |i: T::Base, by_h: T::Base, j: T::Base| T::composed(i, [by_h, e0 * j], [h, e]);
            let i0 = moment(i0, j1, j0);
            let i1 = moment(i1, ud, j1);
            let i2 = moment(i2, u1 * ud1 - u2 * ud2, j2);
            // K = (S + m)/q
            let iq = q.inverse();
            let (s, xs, yxs) = (sigma * i0, p * sigma * i1, p * sigma * (h * i1 - i2));
            let (x_mean, yx) =
                (motion.xi_bar(middle).scale(width), (xi.scale(middle) - p.scale(yy)).scale(width));
            let xx = (xi * (xi - p.scale(sum)) + (p * p).scale(yy)).scale(width);
            let kk = (eta * eta + m * m).scale(width) + q * xx + (m * s).times(2.0);
            [(s + m.scale(width)) * iq, (xs + m * x_mean) * iq, (yxs + m * yx) * iq, kk * iq * iq]
        }
    );
    // ∫ ξ̄ (2C − K) dY, ∫ (ψ C² + η (2C − K)) dY, ∫ Y ξ̄ (2C − K) dY, ∫ (C − K) dY, −η ∫ (C − K)²
    // dY
    let fx = (xi.scale(c) - p.scale(yc)).times(2.0) - xk;
    let fy = psi.scale(cc) + eta * (T::from_base(c.times(2.0)) - k);
    let lever = (xi.scale(yc) - p.scale(yyc)).times(2.0) - yxk;
    let stick = T::from_base(c) - k;
    let ck = stretch_and_length(motion, moving, c);
    let mx = -(eta * (T::from_base(cc) - ck.times(2.0) + kk));
    [fx, fy, mx, lever, stick]
}

/// `K`, by the form of (5.41) that does not cancel.
#[inline(always)]
fn adhesion_on_arc<T: Number>(motion: &ReducedCreepage<T>, x: T::Pair) -> T::Pair {
    let ReducedCreepage { eta, psi, q, eta_psi: m, .. } = motion.values();
    let both = Both::<T>::both;
    let x0 = x.value();
    let squares = x0 * x0;
    let s = (both(eta * eta) + squares.by(q)).sqrt();
    let big = s.more(m.abs());
    let positive = both(m);
    let above = positive.choose(big, squares.more(eta * eta));
    // Where strips adhere, K < C ≤ 1.
    let k = (above / positive.choose(both(q), big + Both::<T>::tiny())).min(Both::<T>::one());
    // S dK = ξ̄ dξ̄ + (η + ψ K)(dη + K dψ)
    let inverse = (s + Both::<T>::tiny()).inverse();
    let turn = k.by(psi).more(eta) * inverse;
    let inputs = [x, T::Pair::both(motion.eta), T::Pair::both(motion.psi)];
    T::Pair::composed(k, [x0 * inverse, turn, turn * k], inputs)
}

/// `∫ C K dY = ∫ C² K dθ`: nodes for the excess of `K` over its least value, from the strip with
/// `ξ̄ = 0`, where `S` may have a kink, to both ends of the arc.
#[inline(always)]
fn stretch_and_length<T: Number>(motion: &ReducedCreepage<T>, arc: &Arc<T>, stretch: T::Base) -> T {
    let ReducedCreepage { xi, eta, psi, slope, .. } = *motion;
    let Arc { lower, upper, middle, .. } = *arc;
    // The strip with ξ̄ = 0, or the end of the arc nearest to it, as the tangent of half an angle,
    // and K there. With hardly any spin there is no kink, and the result must not depend on where
    // the middle is.
    let hardly = (xi + eta.abs()).times(root_epsilon::<T>());
    let h = xi / (slope + hardly + T::from_base(T::ROOT_TINY));
    let turn =
        Edge::chosen_edge(h - lower.y, Edge::chosen_edge(upper.y - h, Edge::at(h), upper), lower);
    let cosine = turn.c * middle.c + turn.y * middle.y;
    let parting = (turn.y * middle.c - turn.c * middle.y) / (T::one() + cosine);
    let lowest = eta.abs() / (T::one() - eta.choose(psi, -psi) + T::tiny());
    let level = (h - lower.y).choose((upper.y - h).choose(lowest, upper.c), lower.c);
    let pieces = Pieces::new(motion.values(), arc.values(), parting.value(), level.value());
    if T::HAS_DERIVATIVES {
        return slopes::stretch_with_slopes(motion, arc, [parting, level], &pieces, stretch);
    }
    let mut sum = Both::<T>::zero();
    for [node, weight] in table!(T::Base, GAUSS_6).iter().map(row::<T::Base, 2>) {
        sum += pieces.at(node, weight).share;
    }
    // dθ = 2 dt/(1 + t²)
    T::from_base((sum * pieces.half).sum().times(2.0) + pieces.least * stretch)
}
