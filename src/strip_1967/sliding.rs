//! Strips that slide, by the primitives of Section 7.1 or, under the continuous rule, by nodes.

use crate::number::tables::{row, table};
use crate::number::{Arithmetic, Number, Pair, Real, branch_or_blend};
use crate::strip_1967::edge::Edge;
use crate::strip_1967::integrals::{Both, GAUSS_4, Shares, arcsinh, far, moment, rounded};
use crate::strip_1967::reduced::ReducedCreepage;
use crate::strip_1967::slopes;
use crate::strip_1967::strip::SlidingRule;

/// The positive eight of sixteen nodes, for the continuous rule.
const GAUSS_16: [[f64; 2]; 8] = [
    [0.09501250983763744, 0.1894506104550685],
    [0.2816035507792589, 0.18260341504492358],
    [0.45801677765722737, 0.16915651939500254],
    [0.6178762444026438, 0.14959598881657674],
    [0.755404408355003, 0.12462897125553388],
    [0.8656312023878318, 0.09515851168249279],
    [0.9445750230732326, 0.062253523938647894],
    [0.9894009349916499, 0.027152459411754096],
];

/// Strips that slide, below and above those that adhere.
#[inline(always)]
pub(super) fn sliding<T: Number>(
    motion: &ReducedCreepage<T>, lower: [Edge<T>; 2], upper: [Edge<T>; 2],
) -> Shares<T> {
    let [fx, fy, lever] = match motion.rule {
        SlidingRule::RigidSlip => forces_of_slip(
            motion,
            T::Pair::couple(lower[0].y, upper[0].y).value(),
            T::Pair::couple(lower[1].y, upper[1].y).value(),
        ),
        SlidingRule::Continuous => continuous(motion, lower, upper),
    };
    [fx, fy, T::zero(), lever, T::zero()]
}

/// `∫ C² (w_x, w_y, Y w_x) dY` with `w ~ ((1 − ν) ξ̄, η)`.
#[inline(always)]
fn forces_of_slip<T: Number>(motion: &ReducedCreepage<T>, from: Both<T>, to: Both<T>) -> [T; 3] {
    let ReducedCreepage { xi, eta, slope, compliance, .. } = *motion;
    let both = Both::<T>::both;
    let (z0, p) = (xi.scale(compliance), slope.scale(compliance));
    let (middle, half) = ((from + to).times(0.5), (to - from).times(0.5));
    let z = both(z0.value()) - middle.by(p.value());
    let bend = half.by(p.value());
    let eta0 = eta.value();
    let eta2 = eta0 * eta0;
    let smooth = both(eta2) + z * z - (bend * bend).times(far::<T>() * far::<T>());
    let (first, second) = smooth.parts();
    branch_or_blend!(
        T::from_base(first.min(second) + T::TINY),
        { slip_by_nodes([z0, p, eta], middle, half) },
        { slip_by_primitives([z0, p, eta], from, to) }
    )
}

/// [`forces_of_slip`] by four nodes, where the direction hardly changes over the strips, for the
/// direction `(z₀ − p Y, η)`.
#[inline(always)]
fn slip_by_nodes<T: Number>([z0, p, eta]: [T; 3], middle: Both<T>, half: Both<T>) -> [T; 3] {
    let both = Both::<T>::both;
    let eta0 = eta.value();
    let eta2 = eta0 * eta0;
    let mut sums = [T::Pair::zero(); 3];
    // At rest no strip slides, and none has a direction.
    let least = eta2 + T::EPSILON * T::EPSILON;
    for [node, weight] in table!(T::Base, GAUSS_4).iter().map(row::<T::Base, 2>) {
        for node in [-node, node] {
            let y = middle + half.by(node);
            let z = T::Pair::both(z0) - T::Pair::both(p).scale(y);
            let share = (Both::<T>::one() - y * y) * half.by(weight);
            // z/√(z² + η²) and 1/√(z² + η²)
            let z0 = z.value();
            let square = z0 * z0 + both(least);
            let fy = share / square.sqrt();
            let (by, fx) = (fy / square, fy * z0);
            let (bend, eta) = (-(by * z0), T::Pair::both(eta));
            let inputs = [z, eta];
            let fx = T::Pair::composed(fx, [by.by(eta2), bend.by(eta0)], inputs);
            let [x, w, lever] = &mut sums;
            *x += fx;
            *w += T::Pair::composed(fy, [bend, -(by.by(eta0))], inputs);
            *lever += fx.scale(y);
        }
    }
    let [fx, w, lever] = T::each(&sums, |sum| sum.sum());
    [fx, w * eta, lever]
}

/// [`forces_of_slip`] by primitives, for the direction `(z₀ − p Y, η)`.
#[inline(always)]
fn slip_by_primitives<T: Number>([z0, p, eta]: [T; 3], from: Both<T>, to: Both<T>) -> [T; 3] {
    let both = Both::<T>::both;
    // in units of p: w = (u, ε)/D with D = √(u² + ε²)
    let inverse = p.inverse();
    let (h, e) = (z0 * inverse, eta * inverse);
    let (h0, e0) = (h.value(), e.value());
    let e2 = rounded(e0);
    let (u1, u2) = (both(h0) - from, both(h0) - to);
    let (d1, d2) = ((u1 * u1).more(e2).sqrt(), (u2 * u2).more(e2).sqrt());
    let (above, below) = arcsinh(u1, u2, d1, d2, both(e2));
    let ((above1, above2), (below1, below2)) = (above.parts(), below.parts());
    // J_n = ∫ uⁿ/D du
    let j0 = (above1 * above2).ln_quotient(below1 * below2);
    let j1 = (d1 - d2).sum();
    let (ud1, ud2) = (u1 * d1, u2 * d2);
    let j2 = ((ud1 - ud2).sum() - e2 * j0).times(0.5);
    let j3 = (d1 * d1 * d1 - d2 * d2 * d2).sum().times(1.0 / 3.0) - e2 * j1;
    let j4 = ((u1 * u1 * ud1 - u2 * u2 * ud2).sum() - (e2 * j2).times(3.0)).times(0.25);
    // C² = 1 − (h − u)²
    let (k0, k1) = (T::Base::one() - h0 * h0, h0.times(2.0));
    let by = [k0, k1];
    let (i0, i1, i2) =
        (moment(by, [j0, j1, j2]), moment(by, [j1, j2, j3]), moment(by, [j2, j3, j4]));
    let [by_x, by_w, by_lever] =
        slopes::slip_with_slopes([h0, e0, e2], [u1, u2, d1, d2], [j0, j1, j2], by);
    let of = |value: T::Base, slopes: [T::Base; 2]| T::composed(value, slopes, [h, e]);
    [of(i1, by_x), of(e0 * i0, by_w), of(h0 * i1 - i2, by_lever)]
}

/// `∫ C² (w_x, w_y, Y w_x) dY` with `w ~ (ξ̄, η + ψ C)`: the nodes are denser next to the strips
/// that adhere, where the direction turns.
#[inline(always)]
fn continuous<T: Number>(
    motion: &ReducedCreepage<T>, lower: [Edge<T>; 2], upper: [Edge<T>; 2],
) -> [T; 3] {
    let ReducedCreepage { xi, eta, psi, slope: p, .. } = *motion;
    let both = T::Pair::both;
    let near = Edge {
        y: T::Pair::couple(lower[1].y, upper[0].y),
        c: T::Pair::couple(lower[1].c, upper[0].c),
    };
    let edge = Edge {
        y: T::Pair::couple(lower[0].y, upper[1].y),
        c: T::Pair::couple(lower[0].c, upper[1].c),
    };
    // At rest no strip slides, and none has a direction.
    let rest = T::Pair::from_base(Both::<T>::both(T::EPSILON * T::EPSILON));
    let (reach, grade) = graded(motion, &near, &edge, rest);
    let outwards = T::Pair::couple(-T::one(), T::one());
    let mut sums = [T::Pair::zero(); 4];
    for [node, weight] in table!(T::Base, GAUSS_16).iter().map(row::<T::Base, 2>) {
        for node in [-node, node] {
            // v = tan(φ/4) = V r/(r + g (1 − r)), r from 0 to 1
            let r = node.times(0.5).plus(0.5);
            let den = grade.by(T::Base::one() - r).more(r);
            let v = reach.by(r);
            let (den2, v2) = (den * den, v * v);
            let scale = (den2 + v2).inverse();
            // dφ = 4 V g dr/(den² + v²)
            let step = (reach * grade * scale).by(weight + weight);
            let (cos2, sin2) = ((den2 - v2) * scale, (den * v * scale).times(2.0));
            let (cosine, sine) = (cos2 * cos2 - sin2 * sin2, (cos2 * sin2).times(2.0) * outwards);
            let y = near.y * cosine + near.c * sine;
            let c = near.c * cosine - near.y * sine;
            let (x, w) = (both(xi) - both(p) * y, both(eta) + both(psi) * c);
            let bound = c * c * c * step;
            let share = bound / (x * x + w * w + rest).sqrt();
            let fx = share * x;
            let [sx, sy, lever, whole] = &mut sums;
            *sx += fx;
            *sy += share * w;
            *lever += y * fx;
            *whole += bound;
        }
    }
    // Scaled so that ∫ C² dY is exact: a constant direction is then exact, and the force is never
    // beyond the bound.
    let [fx, fy, lever, whole] = sums;
    let mean = (near.y * near.y + near.y * edge.y + edge.y * edge.y).times(1.0 / 3.0);
    let exact = (edge.y - near.y) * outwards * (T::Pair::one() - mean);
    let wide = reach.plus(-0.05);
    let scale = wide.choose(exact / (whole + T::Pair::tiny()), T::Pair::one());
    T::each(&[fx * scale, fy * scale, lever * scale], |sum| sum.sum())
}

/// `tan(β/4)` of the angle from the near to the far end of the strips that slide, and how much
/// denser the nodes are next to the near end.
#[inline(always)]
fn graded<T: Number>(
    motion: &ReducedCreepage<T>, near: &Edge<T::Pair>, edge: &Edge<T::Pair>, rest: T::Pair,
) -> (T::Pair, T::Pair) {
    let ReducedCreepage { xi, eta, psi, slope: p, .. } = *motion;
    let both = T::Pair::both;
    // tan(β/4) = sin(β/2)/(1 + cos(β/2)) of the angle β from the near to the far end
    let cosine = near.y * edge.y + near.c * edge.c;
    let [sine, cosine] = T::Pair::each(&[-cosine, cosine], |cosine| {
        cosine.plus(1.0).times(0.5).max(T::Pair::constant(1e-30)).sqrt()
    });
    let reach = sine / cosine.plus(1.0);
    // p C/|N|: how fast the direction of N = (ξ̄, η + ψ C) turns next to the near end
    let (nx, ny) = (both(xi) - both(p) * near.y, both(eta) + both(psi) * near.c);
    let turn = reach * both(p) * near.c / (nx * nx + ny * ny + rest).sqrt();
    let grade = turn.times(4.0).plus(1.0).sqrt().min(T::Pair::constant(30.0));
    // A turn within less than rounding is ignored.
    (reach, grade.plus(-1.0) / turn.times(1e-6).plus(1.0) + T::Pair::one())
}
