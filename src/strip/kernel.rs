//! One strip, with Kalker's half-ellipses ahead of its separatrix and a few nodes in the slip
//! behind the separatrix.
//!
//! `τ = 1 + x̂` runs from 2 at the leading edge to 0, `B = τ (2 − τ)` is the square of the bound's
//! shape, forces are weighted with `(2/π) √B`. Tractions and forces are divided by the strip's own
//! friction bound.

use super::constants::{AVERAGE, BLEND, EDGE, NODES, ROUND, ROUND_SPIN};
use super::tables::{Closed, Constants, TableNode};
use crate::contact::totals::StripForces;
use crate::number::Arithmetic;

/// Least distance of the separatrix from the trailing edge.
const LEAST_SEPARATRIX: f64 = 1e-12;
/// Limit of the variation of slip over a strip's width, divided by the slip behind the separatrix.
pub(super) const WIDEST: f64 = 1e3;
/// Keeps roots of squares away from zero.
const TINY: f64 = 1e-24;
/// Spin beyond this is indistinguishable from sliding by spin alone.
const SPIN_LIMIT: f64 = 1e5;

/// Creepage and spin of a strip, in units of its own friction bound.
#[derive(Clone, Copy, Debug)]
pub struct StripCreepage<T> {
    /// `A_x` of longitudinal creepage and spin.
    pub x: T,
    /// `A_y` of lateral creepage.
    pub y: T,
    /// Variation of `A_x` over the width of one of sixteen strips.
    pub spread: T,
    /// Distance from full sliding, 1 to 0: the share of its turn that the first step behind the
    /// separatrix keeps.
    pub start: T,
}

/// Spin `σ` of a strip, and the numbers that depend on it alone.
#[derive(Clone, Copy, Debug)]
pub struct Spin<T> {
    /// `σ`
    pub sigma: T,
    /// `r`, the lateral traction of spin in adhesion, divided by the bound; `|r| < 1`
    pub r: T,
    /// `σ − r`
    pub excess: T,
    /// `1 − r²`
    pub one_minus_r2: T,
    /// `1/(1 − r²)`
    pub inverse_room: T,
    /// Share of the adhesion part that the nodes sum: 0 at small spin, 1 at large spin.
    pub blend: T,
    /// Half width `d` of the rounded cut.
    pub round: T,
    /// `1/(4 d)`
    pub inverse_round: T,
    /// The factor `m` of the cut where `q` is at most `1 − d`.
    pub uncut: T,
}

impl<T: Arithmetic> Spin<T> {
    /// Computes all members from `σ`.
    #[inline(always)]
    pub fn new(sigma: T) -> Self {
        let sigma = sigma.within(SPIN_LIMIT);
        let square = sigma.squared();
        // r = σ/(1 + σ⁴)^{1/4}
        let root = square.squared().plus(1.0).inverse_root();
        let factor = root * root.inverse_root();
        let r = sigma * factor;
        // 1 − r² = i²/(1 + i σ²), i = (1 + σ⁴)^{−1/2}
        let over = square * root + T::one();
        let (one_minus_r2, inverse_room) = (root.squared() / over, over / root.squared());
        // w = z² (3 − 2 z)
        let z = blending(sigma);
        let blend = z.squared() * (z.times(-2.0).plus(3.0));
        // d = d₀ + d₁ r⁴
        let round = r.squared().squared().times(ROUND_SPIN).plus(ROUND);
        let inverse_round = round.times(4.0).inverse();
        let [low, high] = [T::one() - round, T::one() + round];
        let uncut = rounded_inverse_root(low, high, inverse_round);
        Self {
            sigma,
            r,
            excess: sigma - r,
            one_minus_r2,
            inverse_room,
            blend,
            round,
            inverse_round,
            uncut,
        }
    }

    /// `m = 1/√(max(1, q))`, with a parabola between 1 − d and 1 + d
    #[inline(always)]
    fn cut(&self, q: T) -> T {
        let [low, high] = [T::one() - self.round, T::one() + self.round];
        if T::BRANCHES && q.is_above(high) {
            return q.inverse_root();
        }
        if T::BRANCHES && low.is_above(q) {
            return self.uncut;
        }
        rounded_inverse_root(q.max(low), high, self.inverse_round)
    }

    /// These numbers in another kind of number.
    #[inline(always)]
    pub fn map<U>(&self, all: impl Fn(T) -> U) -> Spin<U> {
        let Self { sigma, r, excess, one_minus_r2, inverse_room, blend, .. } = *self;
        let Self { round, inverse_round, uncut, .. } = *self;
        Spin {
            sigma: all(sigma),
            r: all(r),
            excess: all(excess),
            one_minus_r2: all(one_minus_r2),
            inverse_room: all(inverse_room),
            blend: all(blend),
            round: all(round),
            inverse_round: all(inverse_round),
            uncut: all(uncut),
        }
    }
}

/// `1/√` of the parabola that leads to the straight line at `high`.
#[inline(always)]
fn rounded_inverse_root<T: Arithmetic>(q: T, high: T, inverse_round: T) -> T {
    let z = (high - q).max(T::zero());
    (q + z.squared() * inverse_round).inverse_root()
}

/// Where `|σ|` stands between the spins of [`BLEND`], 0 to 1.
#[inline(always)]
pub(super) fn blending<T: Arithmetic>(sigma: T) -> T {
    let z = sigma.abs().plus(-BLEND[0]).times(1.0 / (BLEND[1] - BLEND[0]));
    z.max(T::zero()).min(T::one())
}

/// The place where adhesion ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Separatrix<T> {
    /// `A_y' = A_y + σ − r`
    pub y: T,
    /// `τ = s`: slip behind, adhesion ahead.
    pub s: T,
    /// The root, before it is limited.
    pub root: T,
    /// `1/S`
    pub inverse_size: T,
}

impl<T: Arithmetic> Separatrix<T> {
    /// `|A'/s + r e_y| = 1`, Kalker's (5.41): `s = (S + r A_y')/(1 − r²)`,
    /// `S² = A_y'² + (1 − r²) A_x²`.
    #[inline(always)]
    pub fn new(seen: &StripCreepage<T>, spin: &Spin<T>) -> Self {
        let y = seen.y + spin.excess;
        let (x2, y2) = (seen.x.squared(), y.squared());
        let square = (spin.one_minus_r2 * x2 + y2).plus(TINY);
        let inverse_size = square.inverse_root();
        let turned = spin.r * y;
        // Where r A_y' < 0 the root is computed as |A'|²/(S − r A_y').
        let sum = square * inverse_size + turned.choose(turned, -turned);
        let root = if !T::BRANCHES {
            turned.choose(sum * spin.inverse_room, (x2 + y2) / sum)
        } else if turned.is_above(T::zero()) {
            sum * spin.inverse_room
        } else {
            (x2 + y2) / sum
        };
        let s = root.max(T::constant(LEAST_SEPARATRIX)).min(T::constant(2.0));
        // At the leading edge the derivative becomes zero.
        let z = s.plus(EDGE - 2.0);
        let s = if T::BRANCHES && !z.is_above(T::zero()) {
            s
        } else {
            let z = z.max(T::zero()).times(1.0 / EDGE);
            s + z.squared() * (T::one() - z).times(EDGE)
        };
        Self { y, s: s + spin.blend * (T::constant(2.0) - s), root, inverse_size }
    }
}

/// `p/s` of the simplified theory, from node to node through the slip.
#[derive(Clone, Copy, Debug)]
pub(super) struct SlipState<T> {
    pub px: T,
    pub py: T,
    /// Half of the variation of `p_x` over the strip's width.
    pub wide: T,
    /// The factor `m` of the last cut.
    pub kept: T,
}

/// A node: traction divided by the bound, and the other summands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Traction<T> {
    pub x: T,
    pub y: T,
    /// `p_x*, p_y*` and `wide` over `s`, before the cut.
    pub offered: [T; 3],
    /// `q` before the cut.
    pub tried: T,
}

/// A step that leads to `τ`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step<T> {
    /// `λ = (τ₀ − τ)/s`
    pub length: T,
    /// `t = τ/s`
    pub place: T,
    /// `s/B`
    pub inverse_bound: T,
    /// `ε²`: square of the variation of `p` within the node's cell, as spin turns `p`.
    pub soft: T,
}

impl<T: Arithmetic> SlipState<T> {
    /// At the separatrix, `p = B n`.
    #[inline(always)]
    pub fn start([nx, ny]: [T; 2], ahead: T, inverse_s: T, seen: &StripCreepage<T>) -> Self {
        let wide = (seen.spread * inverse_s).within(WIDEST).times(0.5);
        Self { px: ahead * nx, py: ahead * ny, wide: ahead * wide, kept: seen.start }
    }

    /// Goes to the next node: `p` grows with the rigid slip and is cut back to the bound.
    #[inline(always)]
    pub fn step(
        self, seen: &StripCreepage<T>, spin: &Spin<T>, s: T, step: &Step<T>,
    ) -> (Self, Traction<T>) {
        let Step { length, place, inverse_bound, soft } = *step;
        // p* = p + λ (A + σ (2 x̂ + m λ s) e_y), x̂ = s t − 1
        let turned = spin.sigma * s * (place + place + self.kept * length);
        let px = self.px + length * seen.x;
        let py = self.py + length * (seen.y - (spin.sigma + spin.sigma) + turned);
        let wide = self.wide + length * seen.spread.times(0.5);
        // q = |p*|²/B², a mean over the strip's width and the node's cell
        let square = px * px + py * py + wide.squared().times(AVERAGE) + soft;
        let tried = square * inverse_bound.squared();
        let kept = spin.cut(tried);
        let reached = tried * kept.squared();
        let offered = [px, py, wide];
        let (px, py, wide) = (px * kept, py * kept, wide * kept);
        // t = r e_y + (p/B − r e_y)(1 + q m²)/2
        let half = reached.plus(1.0).times(0.5);
        let (tx, ty) = (px * inverse_bound, py * inverse_bound);
        let y = spin.r + (ty - spin.r) * half;
        let traction = Traction { x: tx * half, y, offered, tried };
        (Self { px, py, wide, kept }, traction)
    }
}

/// The beginning of a strip's slip part.
#[derive(Clone, Copy, Debug)]
pub(super) struct Start<T> {
    pub separatrix: Separatrix<T>,
    pub inverse_s: T,
    /// `A'/s + r e_y`
    pub n: [T; 2],
}

/// The numbers of a node that the reverse pass of the derivatives uses.
#[derive(Clone, Copy, Debug)]
pub(super) struct NodeState<T> {
    pub inverse_bound: T,
    pub weight: T,
    pub traction: Traction<T>,
    pub kept: T,
}

/// Forces of a strip; `note` receives each node.
#[inline(always)]
pub(super) fn forces<T: Arithmetic>(
    seen: &StripCreepage<T>, spin: &Spin<T>, constants: &impl Constants<T::Value>,
    mut note: impl FnMut(usize, NodeState<T>),
) -> (StripForces<T>, Start<T>) {
    let separatrix = Separatrix::new(seen, spin);
    let Separatrix { y, s, .. } = separatrix;
    let u = s.times(0.5);
    let ahead = T::one() - u;
    let (inverse_s, bounds) = node_inverses(s, constants);
    // n = A'/s + r e_y
    let n = [seen.x * inverse_s, y * inverse_s + spin.r];
    // t = r e_y + (A'/s)(1 − R), R = √(1 − s/τ), ahead of the separatrix; behind it less n, which
    // the nodes add
    let closed: Closed<T::Value> = constants.closed();
    let c = ahead * polynomial(&closed.force, u);
    let mut fx = seen.x * c;
    let mut fy = y * c + spin.r * (ahead.squared() + s * c);
    let closed_moment = (y + s * spin.r) * polynomial(&closed.moment, u);
    let mut mx = -(ahead * ((y * ahead).times(0.5) + closed_moment));
    let mut blended = T::zero();
    let mut slip = SlipState::start(n, ahead + ahead, inverse_s, seen);
    let soft = (spin.sigma * s).squared();
    let square = u.squared();
    for (k, inverse_bound) in bounds.iter().enumerate() {
        let node: TableNode<T::Value> = constants.node(k);
        let step = Step {
            length: T::from_base(node.length),
            place: T::from_base(node.place),
            inverse_bound: *inverse_bound,
            soft: soft.scale(node.soft),
        };
        let traction;
        (slip, traction) = slip.step(seen, spin, s, &step);
        let weight = square * polynomial(&node.weight, u);
        let lateral = weight * traction.y;
        fx += weight * traction.x;
        fy += lateral;
        mx += s.scale(node.place).plus(-1.0) * lateral;
        blended += slip.kept.squared().squared().squared().scale(node.length);
        note(k, NodeState { inverse_bound: *inverse_bound, weight, traction, kept: slip.kept });
    }
    // With much spin the nodes extend into the adhesion part.
    let stick = ahead + spin.blend * (u * blended);
    (StripForces { fx, fy, mx, stick }, Start { separatrix, inverse_s, n })
}

/// `1/s` and all `s/B = 1/(t (2 − s t))`, computed with one division.
#[inline(always)]
fn node_inverses<T: Arithmetic>(s: T, constants: &impl Constants<T::Value>) -> (T, [T; NODES]) {
    let mut inverses = [s; NODES];
    let mut product = s;
    for (k, place) in inverses.iter_mut().enumerate() {
        *place = product;
        product = product * (T::constant(2.0) - s.scale(constants.node(k).place));
    }
    let mut inverse = product.inverse();
    for (k, place) in inverses.iter_mut().enumerate().rev() {
        let node = constants.node(k);
        *place = (inverse * *place).scale(node.inverse_place);
        inverse = inverse * (T::constant(2.0) - s.scale(node.place));
    }
    (inverse, inverses)
}

/// `c₀ + c₁ u + c₂ u² …`
#[inline(always)]
pub(super) fn polynomial<T: Arithmetic, const N: usize>(c: &[T::Value; N], u: T) -> T {
    let mut sum = T::zero();
    for (i, c) in c.iter().rev().enumerate() {
        sum = if i == 0 { T::from_base(*c) } else { sum * u + T::from_base(*c) };
    }
    sum
}
