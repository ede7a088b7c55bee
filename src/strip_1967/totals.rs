//! Total force, moment and stick area by the primitives of Section 7.1.
//!
//! With `u = h − Y`, `h = ξ/p` both square roots of the theory have one form, `√(u² + ε²)`: the adhesion length's
//! `S = p √q √(u² + ε²)` with `ε = η/(p √q)`, and the slip of a strip that slides by the rule of the rigid slip with `ε = η/(p (1 − ν))`.
//! Their moments are powers and `asinh(u/ε)`. Where a root hardly bends over its piece the primitives would cancel, and four nodes
//! of Gauss give all digits.
//!
//! Two integrals are not elementary: `∫ C S dY` of the moment `m_x`, and the continuous sliding rule. They are summed over nodes of the
//! angle, so that the edges of the contact are smooth, from the known points where they bend.

use crate::contact::creepage::Parameters;
use crate::contact::forces::Totals;
use crate::number::registers::compiled_twice;
use crate::number::tables::{row, table};
use crate::number::{Arithmetic, Number, Pair, Plain, Stored, chosen, either};
use crate::strip_1967::Motion;
use crate::strip_1967::edge::{self, Arc, Edge};
use crate::strip_1967::sliding::{arcsinh, rounded, sliding};
use crate::strip_1967::slopes;
use crate::strip_1967::strip::SlidingRule;
use core::f64::consts::PI;

/// The positive two of the four nodes of Gauss on `[-1, 1]`, with their weights.
pub(super) const GAUSS_4: [[f64; 2]; 2] =
    [[0.33998104358485626, 0.6521451548625461], [0.8611363115940526, 0.34785484513745385]];
/// Six nodes of Gauss, for `∫ C K dY` on either side of the strip with `ξ̄ = 0`.
pub(super) const GAUSS_6: [[f64; 2]; 6] = [
    [-0.932469514203152, 0.17132449237917036],
    [-0.6612093864662645, 0.3607615730481386],
    [-0.2386191860831969, 0.46791393457269104],
    [0.2386191860831969, 0.46791393457269104],
    [0.6612093864662645, 0.3607615730481386],
    [0.932469514203152, 0.17132449237917036],
];
/// Distance of the zero of the square root from the middle of a piece, in half lengths, beyond which four nodes give all digits.
#[inline]
pub(super) fn far<T: Number>() -> f64 {
    if size_of::<Stored<T>>() == 4 { 3.5 } else { 16.0 }
}

/// Square root of the distance between 1 and the next number.
#[inline]
fn root_epsilon<T: Number>() -> f64 {
    if size_of::<Stored<T>>() == 4 { 3.5e-4 } else { 1.5e-8 }
}

/// Two plain numbers side by side.
pub(super) type Both<T> = <<T as Number>::Base as Number>::Pair;

/// Integrals over strips: `∫ f_x dY`, `∫ f_y dY`, `∫ m_x dY`, `∫ Y f_x dY`, `∫ (C − K) dY`.
pub(super) type Shares<T> = [T; 5];

/// The sums of the integrals of two sets of strips.
#[inline(always)]
pub(super) fn sum<T: Number>(mut shares: Shares<T>, others: Shares<T>) -> Shares<T> {
    for (share, other) in shares.iter_mut().zip(others) {
        *share += other;
    }
    shares
}

/// Forces and moment in units of `μ N` and `μ N √(ab)`, turned back.
#[inline(always)]
pub(super) fn turned_back<T: Number>(motion: &Motion<T>, shares: Shares<T>) -> Totals<T> {
    let [fx, fy, mx, lever, stick] = shares;
    let Motion { axis_ratio, turned_x, turned_y, .. } = *motion;
    let root = axis_ratio.sqrt();
    let mz = mx.scale(root) - lever.scale(T::Base::one() / root);
    let (fx, fy) = (fx.scale(turned_x.times(0.75)), fy.scale(turned_y.times(0.75)));
    // the mirror image of itself
    let fx = motion.xi.choose(fx, fx - T::from_base(fx.value()));
    // (differences of primitives may pass the bound by their rounding)
    let square = fx * fx + fy * fy;
    let [fx, fy] = either!(
        square - T::one(),
        {
            let inverse = square.sqrt().inverse();
            [fx * inverse, fy * inverse]
        },
        { [fx, fy] }
    );
    Totals {
        fx,
        fy,
        mz: mz.scale(turned_y.times(0.75)),
        stick: stick.times(2.0 / PI).clamped(T::zero(), T::one()),
    }
}

/// `F/(μ N)`, `M_z/(μ N √(ab))` and the stick area of a contact.
///
/// # Example
/// Pure longitudinal creepage, Section 8.15:
/// ```
/// use kstrip::{strip_1967, strip_1967::strip::SlidingRule, contact::creepage::Parameters};
/// let parameters = Parameters { xi: 0.5, eta: 0.0, psi: 0.0, poisson_ratio: 0.28, axis_ratio: 1.0 };
/// let totals = strip_1967::totals(&parameters, SlidingRule::RigidSlip);
/// let exact = 1.0 - (2.25 * 0.75_f64.sqrt() - 1.5 * 0.5_f64.acos()) / 2.0;
/// assert!((totals.fx - exact).abs() < 1e-15 && totals.fy == 0.0);
/// ```
#[must_use]
#[inline(always)]
pub fn totals<T: Number>(parameters: &Parameters<T>, rule: SlidingRule) -> Totals<T> {
    // (the code of one rule alone is half as large; with derivatives it is one for both)
    if rule == SlidingRule::RigidSlip && !T::HAS_DERIVATIVES {
        compiled_twice!(if T::LANES => <T: Number>(parameters: &Parameters<T> = parameters) -> Totals<T> {
            integrals(parameters, SlidingRule::RigidSlip)
        })
    } else {
        compiled_twice!(if T::LANES => <T: Number>(parameters: &Parameters<T> = parameters, rule: SlidingRule = rule) -> Totals<T> {
            integrals(parameters, rule)
        })
    }
}

#[inline(always)]
fn integrals<T: Number>(parameters: &Parameters<T>, rule: SlidingRule) -> Totals<T> {
    let motion = Motion::new(parameters, rule);
    let short = || without_spin(&motion.values());
    let shares = if T::HAS_DERIVATIVES {
        // (the formulas without spin have no derivative by the spin)
        let slopes = with_spin(&motion);
        if motion.psi.exceeds(T::zero()) { slopes } else { valued(slopes, short()) }
    } else {
        either!(motion.psi, { with_spin(&motion) }, { valued([T::zero(); 5], short()) })
    };
    turned_back(&motion, shares)
}

/// Replaces the values of numbers and keeps their derivatives.
#[inline(always)]
fn valued<T: Number>(mut numbers: Shares<T>, values: Shares<T::Base>) -> Shares<T> {
    for (number, value) in numbers.iter_mut().zip(values) {
        *number = T::composed(value, [T::Base::one()], [*number]);
    }
    numbers
}

/// Without spin `K = τ = √(ξ² + η²)` in every strip, and strips with `C > τ` adhere (Section 8.15).
#[inline(always)]
fn without_spin<F: Plain>(motion: &Motion<F>) -> Shares<F> {
    let Motion { xi, eta, compliance, rule, .. } = *motion;
    let (one, none) = (F::one(), F::zero());
    let (tau2, eta2) = (xi * xi + eta * eta, eta * eta);
    let tau = tau2.sqrt();
    let inside = one - tau;
    // those from −Y to Y
    let y = (inside * (one + tau)).max(none).sqrt();
    // ∫ (2C − K) dY = 2 asin Y
    let angle = inside.choose((y / (one + tau)).atan_of_unit().times(4.0), none);
    let cc = (y - y * (y * y).times(1.0 / 3.0)).times(2.0);
    let stick = inside.choose(angle.times(0.5) - y * tau, none);
    // ∫ C² dY of those that slide, over their slip
    let beside = tau2.min(one) / (one + y);
    let z = if rule == SlidingRule::RigidSlip { xi * compliance } else { xi };
    let slip = (z * z + (eta2 + F::EPSILON * F::EPSILON)).sqrt();
    let slides = (beside * beside * y.plus(2.0)).times(2.0 / 3.0) / slip;
    [xi * angle + z * slides, eta * (angle + slides), -(eta * (cc - tau * angle)), none, stick]
}

#[inline(always)]
fn with_spin<T: Number>(motion: &Motion<T>) -> Shares<T> {
    let (arc, some) = edge::adhesion(motion);
    let slide = outside(motion, &arc);
    if !some.exceeds(T::zero()) {
        return slide;
    }
    let mut all = sum(slide, adhering(motion, &arc));
    if T::HAS_DERIVATIVES {
        all = sum(all, slopes::jumps(motion, &arc));
    }
    chosen(some, all, slide)
}

/// All strips.
pub(super) fn whole<F: Plain>(motion: &Motion<F>, arc: &Arc<F>, adheres: bool) -> Shares<F> {
    let slide = outside(motion, arc);
    if adheres { sum(slide, adhering(motion, arc)) } else { slide }
}

/// Strips that slide on both sides of an arc.
#[inline(always)]
fn outside<T: Number>(motion: &Motion<T>, arc: &Arc<T>) -> Shares<T> {
    let (one, none) = (T::one(), T::zero());
    let (first, last) = (Edge { y: -one, c: none }, Edge { y: one, c: none });
    sliding(motion, [first, arc.lower], [arc.upper, last])
}

/// Strips with adhesion: `f_x = ξ̄ (2C − K)`, `f_y = ψ C² + η (2C − K)`, `m_x = −η (C − K)²`. Ends are fixed: derivatives are those
/// of the integrands.
#[inline(always)]
pub(super) fn adhering<T: Number>(motion: &Motion<T>, moving: &Arc<T>) -> Shares<T> {
    let Motion { xi, eta, psi, slope: p, q, eta_psi: m, .. } = *motion;
    let values = motion.values();
    let arc = moving.values();
    let (Edge { y: y1, c: c1 }, Edge { y: y2, c: c2 }) = (arc.lower, arc.upper);
    let (width, sum) = (y2 - y1, y1 + y2);
    // ∫ C dY = (asin Y + Y C)/2,  ∫ Y C dY = −C³/3,  ∫ Y² C dY = (asin Y − Y C (1 − 2Y²))/8,  ∫ C² dY = Y − Y³/3
    let angle = arc.tangent.atan_of_unit().times(4.0);
    let (yc1, yc2) = (y1 * c1, y2 * c2);
    let c = (angle + (yc2 - yc1)).times(0.5);
    let yc = (c1 * c1 * c1 - c2 * c2 * c2).times(1.0 / 3.0);
    let bent = |y: T::Base, yc: T::Base| yc * (T::Base::one() - (y * y).times(2.0));
    // (of a narrow arc the angle has its digits behind the point only)
    let most = (y1 * y1).max(y2 * y2) * width;
    let yyc = (angle - (bent(y2, yc2) - bent(y1, yc1))).times(0.125);
    let yyc = yyc.min(most).max(T::Base::zero());
    let yy = (y1 * y1 + y1 * y2 + y2 * y2).times(1.0 / 3.0);
    let cc = width * (T::Base::one() - yy);
    // S hardly bends where the zero of S² is far from the interval.
    let (middle, half) = (sum.times(0.5), width.times(0.5));
    let (x, bend) = (values.xi_bar(middle), values.slope * half);
    let smooth = values.eta * values.eta
        + values.q * (x * x - (bend * bend).times(far::<T>() * far::<T>()))
        + T::TINY;
    let [k, xk, yxk, kk] = either!(
        T::from_base(smooth),
        {
            // ∫ (K, ξ̄ K, Y ξ̄ K, K²) dY by nodes
            let mut sums = [T::Pair::zero(); 4];
            for [node, weight] in table!(T::Base, GAUSS_4).iter().map(row::<T::Base, 2>) {
                let y = Both::<T>::both(middle) + Both::<T>::of(half, -half).by(node);
                let x = T::Pair::both(xi) - T::Pair::both(p).scale(y);
                let k = length(motion, x);
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
    let ck = stretch_and_length(motion, moving, c);
    [
        (xi.scale(c) - p.scale(yc)).times(2.0) - xk,
        psi.scale(cc) + eta * (T::from_base(c.times(2.0)) - k),
        -(eta * (T::from_base(cc) - ck.times(2.0) + kk)),
        (xi.scale(yc) - p.scale(yyc)).times(2.0) - yxk,
        T::from_base(c) - k,
    ]
}

/// `K`, by the form of (5.41) that does not cancel.
#[inline(always)]
fn length<T: Number>(motion: &Motion<T>, x: T::Pair) -> T::Pair {
    let Motion { eta, psi, q, eta_psi: m, .. } = motion.values();
    let both = Both::<T>::both;
    let x0 = x.value();
    let squares = x0 * x0;
    let s = (both(eta * eta) + squares.by(q)).sqrt();
    let big = s.more(m.abs());
    let positive = both(m);
    let above = positive.choose(big, squares.more(eta * eta));
    // (where strips adhere K < C ≤ 1)
    let k = (above / positive.choose(both(q), big + Both::<T>::tiny())).min(Both::<T>::one());
    // S dK = ξ̄ dξ̄ + (η + ψ K)(dη + K dψ)
    let inverse = (s + Both::<T>::tiny()).inverse();
    let turn = k.by(psi).more(eta) * inverse;
    let inputs = [x, T::Pair::both(motion.eta), T::Pair::both(motion.psi)];
    T::Pair::composed(k, [x0 * inverse, turn, turn * k], inputs)
}

/// `∫ C K dY = ∫ C² K dθ`: nodes for what `K` is more than its least, from the strip with `ξ̄ = 0`, where `S` may have
/// a kink, to both ends of the arc.
#[inline(always)]
fn stretch_and_length<T: Number>(motion: &Motion<T>, arc: &Arc<T>, stretch: T::Base) -> T {
    let split @ [parting, level] = parted(motion, arc);
    let pieces = Pieces::new(motion.values(), arc.values(), parting.value(), level.value());
    if T::HAS_DERIVATIVES {
        return slopes::stretch_and_length(motion, arc, split, &pieces, stretch);
    }
    let mut sum = Both::<T>::zero();
    for [node, weight] in table!(T::Base, GAUSS_6).iter().map(row::<T::Base, 2>) {
        sum += pieces.at(node, weight).share;
    }
    // dθ = 2 dt/(1 + t²)
    T::from_base(pieces.whole(sum) + pieces.least * stretch)
}

/// Where the arc is parted, as the tangent of half an angle, and `K` there: at the strip with `ξ̄ = 0`, or next to it.
#[inline(always)]
fn parted<T: Number>(motion: &Motion<T>, arc: &Arc<T>) -> [T; 2] {
    let Motion { xi, eta, psi, slope, .. } = *motion;
    let Arc { lower, upper, middle, .. } = *arc;
    // (with hardly any spin there is no kink, and nothing may hang on where the middle is)
    let hardly = (xi + eta.abs()).times(root_epsilon::<T>());
    let h = xi / (slope + hardly + T::from_base(T::ROOT_TINY));
    let turn = Edge::chosen(h - lower.y, Edge::chosen(upper.y - h, Edge::at(h), upper), lower);
    let cosine = turn.c * middle.c + turn.y * middle.y;
    let parting = (turn.y * middle.c - turn.c * middle.y) / (T::one() + cosine);
    let lowest = eta.abs() / (T::one() - eta.choose(psi, -psi) + T::tiny());
    let level = (h - lower.y).choose((upper.y - h).choose(lowest, upper.c), lower.c);
    [parting, level]
}

/// The two pieces of an arc side by side: `Y = sin(θ + φ)`, with the tangent `t` of `φ/2` from `−t₁` to the parting and on to `t₁`.
pub(super) struct Pieces<F: Plain> {
    motion: Motion<F>,
    middle: Edge<F>,
    /// Middle and half length of each in `t`.
    centre: F::Pair,
    pub half: F::Pair,
    /// `K` at the parting.
    pub least: F,
}

/// Of a node in each piece.
pub(super) struct Node<P> {
    pub t: P,
    /// `D = 1 + t²`
    pub d: P,
    /// `D C`, `D ξ̄`, `D S` and `K` as a quotient
    pub c: P,
    pub x: P,
    pub s: P,
    pub above: P,
    pub below: P,
    /// `C² D² w` and its share of the integral
    pub bound: P,
    pub share: P,
}

impl<F: Plain> Pieces<F> {
    #[inline(always)]
    fn new(motion: Motion<F>, arc: Arc<F>, parting: F, least: F) -> Self {
        let (from, to) = (F::Pair::of(-arc.tangent, parting), F::Pair::of(parting, arc.tangent));
        let (centre, half) = ((from + to).times(0.5), (to - from).times(0.5));
        Self { motion, middle: arc.middle, centre, half, least }
    }

    #[inline(always)]
    pub fn at(&self, node: F, weight: F) -> Node<F::Pair> {
        let Motion { xi, eta, slope: p, q, eta_psi: m, .. } = self.motion;
        let (Edge { y: y0, c: c0 }, both) = (self.middle, <F::Pair as Pair<F>>::both);
        let t = self.centre + self.half.by(node);
        let d = (t * t).plus(1.0);
        // D C = c₀ − t (2 y₀ + t c₀),  D ξ̄ = ξ − p y₀ − t (2 p c₀ − t (ξ + p y₀))
        let c = both(c0) - t * (t.by(c0) + both(y0.times(2.0)));
        let x = both(xi - p * y0) + t * (t.by(xi + p * y0) + both(-(p * c0).times(2.0)));
        let (square, flat) = (x * x, (d * d).by(eta * eta));
        let s = (flat + square.by(q)).sqrt();
        // (5.41) by the form that does not cancel
        let (big, positive) = (s + both(m.abs()) * d, both(m));
        let above = positive.choose(big, square + flat);
        let below = positive.choose(both(q), big + F::Pair::tiny()) * d;
        let bound = c * c.by(weight);
        let share = (above - below.by(self.least)) * bound / (below * (d * d * d));
        Node { t, d, c, x, s, above, below, bound, share }
    }

    /// Of both, from `dt` to `dθ = 2 dt/(1 + t²)`.
    #[inline(always)]
    pub fn whole(&self, sum: F::Pair) -> F {
        (sum * self.half).sum().times(2.0)
    }
}
