//! Derivatives of a strip's forces with respect to `A_x, A_y, σ`, the spread and the start. The
//! kernel's formulas are differentiated in reverse, from the results back to the inputs. Dual
//! numbers give the same results and cost 63 % more instructions.

use super::constants::{AVERAGE, BLEND, EDGE, NODES, ROUND_SPIN};
use super::kernel::{
    NodeState, Separatrix, Spin, Start, StripCreepage, Traction, WIDEST, blending, forces,
};
use super::tables::{Constants, TableNode, Tables};
use crate::contact::totals::StripForces;
use crate::number::{Arithmetic, Real, Strips};

/// Derivatives with respect to `σ` of the numbers that depend on `σ` alone.
#[derive(Clone, Copy, Debug)]
pub(super) struct SpinSlopes<T> {
    r: T,
    blend: T,
    round: T,
}

impl<T: Arithmetic> SpinSlopes<T> {
    pub fn new(spin: &Spin<T>) -> Self {
        // dr = (1 + σ⁴)^{−5/4} dσ
        let root = spin.sigma.squared().squared().plus(1.0).inverse_root();
        let r = root.squared() * (root * root.inverse_root());
        let z = blending(spin.sigma);
        let sign = spin.sigma.choose(T::one(), -T::one());
        let blend = sign * (z * (T::one() - z)).times(6.0 / (BLEND[1] - BLEND[0]));
        let round = (spin.r.squared() * spin.r * r).times(4.0 * ROUND_SPIN);
        Self { r, blend, round }
    }

    /// These derivatives in another kind of number.
    pub fn map<U>(&self, all: impl Fn(T) -> U) -> SpinSlopes<U> {
        SpinSlopes { r: all(self.r), blend: all(self.blend), round: all(self.round) }
    }
}

/// Forces of strips side by side, and the derivatives of `f_x, f_y, m_x` with respect to `A_x, A_y,
/// σ`, the spread and the start.
#[inline(always)]
pub(super) fn forces_and_slopes<P: Arithmetic<Value = P>>(
    seen: &StripCreepage<P>, spin: &Spin<P>, constants: &impl Constants<P>, by_spin: &SpinSlopes<P>,
) -> (StripForces<P>, [[P; 5]; 3]) {
    // Placeholders, overwritten when the nodes are recorded.
    let any = seen.x;
    let traction = Traction { x: any, y: any, offered: [any; 3], tried: any };
    let mut nodes = [NodeState { inverse_bound: any, weight: any, traction, kept: any }; NODES];
    let (carried, start) = forces(seen, spin, constants, |k, passed| {
        if let Some(node) = nodes.get_mut(k) {
            *node = passed;
        }
    });
    let s = start.separatrix.s;
    let turning = spin.sigma * s;
    let [mut x, mut y, mut m] = [Adjoint::new(); 3];
    for k in (0..NODES).rev() {
        let Some(own) = nodes.get(k) else { continue };
        let before = nodes.get(k.wrapping_sub(1)).map_or(seen.start, |before| before.kept);
        let node = NodeAdjoint::new(&constants.node(k), own, before, s, spin);
        x.pass(Force::Longitudinal, &node, spin.r, turning);
        y.pass(Force::Lateral, &node, spin.r, turning);
        m.pass(Force::Moment, &node, spin.r, turning);
    }
    let (u, closed) = (s.times(0.5), constants.closed());
    let closed =
        [polynomial_with_slope(&closed.force, u), polynomial_with_slope(&closed.moment, u)];
    let spin = (spin, by_spin);
    let slopes = [
        x.end(Force::Longitudinal, seen, spin, &start, closed),
        y.end(Force::Lateral, seen, spin, &start, closed),
        m.end(Force::Moment, seen, spin, &start, closed),
    ];
    (carried, slopes)
}

/// The same of one strip, of the outer or the inner kind: one function for all callers, where code
/// must be small.
#[inline(never)]
pub(super) fn alone_with_slopes<F: Real, P: Strips<F>>(
    seen: &StripCreepage<P>, spin: &Spin<P>, inner: bool, by_spin: &SpinSlopes<P>,
) -> (StripForces<P>, [[P; 5]; 3]) {
    let constants = Tables::<F::Stored, _>::new(|couple: &[_; 2]| {
        let [outer, own] = *couple;
        P::all(F::stored(if inner { own } else { outer }))
    });
    forces_and_slopes(seen, spin, &constants, by_spin)
}

/// One of the forces of a strip.
#[derive(Clone, Copy, PartialEq)]
enum Force {
    Longitudinal,
    Lateral,
    Moment,
}

/// The numbers of a node that the reverse pass uses.
#[derive(Clone, Copy)]
struct NodeAdjoint<P> {
    /// `t` and `λ`
    place: P,
    length: P,
    /// `x̂`
    x: P,
    weight: P,
    /// `dW/du`
    weight_slope: P,
    traction: [P; 2],
    /// `p_x/B` and `p_y/B − r`
    p: [P; 2],
    /// `e = (1 + q m²)/2` and `e/B`
    half: P,
    outer: P,
    /// `p*`, and the derivative of `q` with respect to it, `2 p*/B²`
    offered: [P; 3],
    doubled: [P; 3],
    /// `m`, `q m`, `m²/2`
    kept: P,
    turned: P,
    half_square: P,
    /// `dm/dq` and `dm/dd`
    cut: P,
    round: P,
    /// `dq/d(σ s)²`, `B d(1/B)/ds` and `dq/ds`
    soft: P,
    bound: P,
    stretched: P,
    /// `2 t + m λ` with `m` of the node before.
    turn: P,
}

impl<P: Arithmetic<Value = P>> NodeAdjoint<P> {
    #[inline(always)]
    fn new(node: &TableNode<P>, own: &NodeState<P>, before: P, s: P, spin: &Spin<P>) -> Self {
        let one = P::one();
        let (b, m, q) = (own.inverse_bound, own.kept, own.traction.tried);
        let [x, y, wide] = own.traction.offered;
        let half = (q * (m * m)).plus(1.0).times(0.5);
        // Smoothed max(1, q): derivative with respect to q 1 − y, to d y (1 − y), y = z/(2 d).
        let z = (one + spin.round - q.max(one - spin.round)).max(P::zero());
        let z = z * (spin.inverse_round + spin.inverse_round);
        let cut = (m * m * m).times(-0.5) * (one - z);
        let twice = b * b + b * b;
        let bound = node.place * node.place * b;
        let [c0, c1, c2, c3] = node.weight;
        let u = s.times(0.5);
        let slope = [c0.times(2.0), c1.times(3.0), c2.times(4.0), c3.times(5.0)];
        let [slope, _] = polynomial_with_slope(&slope, u);
        Self {
            place: node.place,
            length: node.length,
            x: s * node.place - one,
            weight: own.weight,
            weight_slope: u * slope,
            traction: [own.traction.x, own.traction.y],
            p: [x * (m * b), y * (m * b) - spin.r],
            half,
            outer: half * b,
            offered: [x, y, wide],
            doubled: [twice * x, twice * y, (twice * wide).times(AVERAGE)],
            kept: m,
            turned: q * m,
            half_square: (m * m).times(0.5),
            cut,
            round: cut * z,
            soft: b * b * node.soft,
            bound,
            stretched: bound * (q + q),
            turn: node.place + node.place + before * node.length,
        }
    }
}

/// The derivatives of a force in the reverse pass: with respect to the state ahead of a node, and
/// the sums over the nodes that have been passed.
#[derive(Clone, Copy)]
struct Adjoint<P> {
    by_px: P,
    by_py: P,
    by_wide: P,
    by_kept: P,
    by_x: P,
    by_y: P,
    by_s: P,
    by_u: P,
    by_r: P,
    by_round: P,
    by_turning: P,
    by_square: P,
    by_spread: P,
}

impl<P: Arithmetic<Value = P>> Adjoint<P> {
    #[inline(always)]
    fn new() -> Self {
        let zero = P::zero();
        Self {
            by_px: zero,
            by_py: zero,
            by_wide: zero,
            by_kept: zero,
            by_x: zero,
            by_y: zero,
            by_s: zero,
            by_u: zero,
            by_r: zero,
            by_round: zero,
            by_turning: zero,
            by_square: zero,
            by_spread: zero,
        }
    }

    /// Goes back over one node.
    #[inline(always)]
    fn pass(&mut self, force: Force, node: &NodeAdjoint<P>, r: P, turning: P) {
        let one = P::one();
        let NodeAdjoint { weight, weight_slope, half, offered: [x, y, wide], .. } = *node;
        let ([tx, ty], [px, py]) = (node.traction, node.p);
        // t = r e_y + (p/B − r e_y) e
        let through = match force {
            Force::Longitudinal => {
                self.by_px += weight * node.outer;
                self.by_u += weight_slope * tx;
                let through = weight * px;
                self.by_s += through * half * node.bound;
                through
            }
            _ => {
                let moment = force == Force::Moment;
                let seed = if moment { weight * node.x } else { weight };
                self.by_py += seed * node.outer;
                self.by_r += seed * (one - half);
                let slope = weight_slope * ty;
                self.by_u += if moment { slope * node.x } else { slope };
                let through = seed * py;
                self.by_s += (through + seed * r) * half * node.bound;
                if moment {
                    self.by_s += weight * ty * node.place;
                }
                through
            }
        };
        // m and q
        let by_m = self.by_kept
            + x * self.by_px
            + y * self.by_py
            + wide * self.by_wide
            + through * node.turned;
        let by_q = through * node.half_square + by_m * node.cut;
        self.by_round += by_m * node.round;
        self.by_square += node.soft * by_q;
        self.by_s += node.stretched * by_q;
        // p* = p + λ (A + σ (2 x̂ + m λ s) e_y)
        self.by_px = node.kept * self.by_px + node.doubled[0] * by_q;
        self.by_py = node.kept * self.by_py + node.doubled[1] * by_q;
        self.by_wide = node.kept * self.by_wide + node.doubled[2] * by_q;
        self.by_spread += node.length * self.by_wide;
        let step = node.length * self.by_py;
        self.by_x += node.length * self.by_px;
        self.by_y += step;
        self.by_turning += step * node.turn;
        self.by_kept = step * turning * node.length;
    }

    /// From the separatrix to `A_x, A_y, σ`, the spread and the start.
    #[inline(always)]
    fn end(
        mut self, force: Force, seen: &StripCreepage<P>,
        (spin, by_spin): (&Spin<P>, &SpinSlopes<P>), start: &Start<P>, closed: [[P; 2]; 2],
    ) -> [P; 5] {
        let Separatrix { y, s, .. } = start.separatrix;
        let (zero, one, r) = (P::zero(), P::one(), spin.r);
        let turning = spin.sigma * s;
        self.by_turning += self.by_square * (turning + turning);
        let mut by_sigma = self.by_turning * s - (self.by_y + self.by_y);
        self.by_s += self.by_turning * spin.sigma;
        // p = (2 − s) n, n = A'/s + r e_y
        let ahead = one - s.times(0.5);
        let [nx, ny] = start.n;
        let mut by_ahead = (nx * self.by_px + ny * self.by_py).times(2.0);
        let (by_nx, by_ny) = (self.by_px * (ahead + ahead), self.by_py * (ahead + ahead));
        self.by_x += by_nx * start.inverse_s;
        let mut by_prime = by_ny * start.inverse_s;
        self.by_r += by_ny;
        self.by_s -= start.inverse_s * (by_nx * nx + by_ny * (ny - r));
        // wide = (2 − s) spread/(2 s)
        let ratio = seen.spread * start.inverse_s;
        let within = ratio.within(WIDEST);
        by_ahead += within * self.by_wide;
        let free = (ratio - within).abs().choose(zero, ahead * self.by_wide * start.inverse_s);
        self.by_spread = self.by_spread.times(0.5) + free;
        self.by_s -= free * ratio;
        // The part in closed form, ahead of the separatrix.
        let [[k, k_slope], [l, l_slope]] = closed;
        let (c, whole) = (ahead * k, y + s * r);
        match force {
            Force::Longitudinal => {
                self.by_x += c;
                by_ahead += seen.x * k;
                self.by_u += ahead * k_slope * seen.x;
            }
            Force::Lateral => {
                by_prime += c;
                self.by_r += ahead.squared() + s * c;
                self.by_s += r * c;
                by_ahead += (r * ahead).times(2.0) + whole * k;
                self.by_u += ahead * k_slope * whole;
            }
            Force::Moment => {
                by_prime -= ahead * (ahead.times(0.5) + l);
                self.by_r -= ahead * s * l;
                self.by_s -= ahead * r * l;
                by_ahead -= y * ahead + whole * l;
                self.by_u -= ahead * whole * l_slope;
            }
        }
        self.by_s += (self.by_u - by_ahead).times(0.5);
        let [by_x, by_y, by_r, by_blend] = separatrix(seen, spin, &start.separatrix, self.by_s);
        self.by_x += by_x;
        by_prime += by_y;
        self.by_r += by_r;
        // A_y' = A_y + σ − r
        by_sigma += by_prime + (self.by_r - by_prime) * by_spin.r;
        by_sigma += by_blend * by_spin.blend + self.by_round * by_spin.round;
        [self.by_x, self.by_y + by_prime, by_sigma, self.by_spread, self.by_kept]
    }
}

/// From `s` back to `A_x, A_y', r` and the share of blending:
/// `s = s₁ + w (2 − s₁)`, `d root = (A_x dA_x + g (dA_y' + root dr))/S`, `g = A_y' + root r`.
#[inline(always)]
fn separatrix<P: Arithmetic>(
    seen: &StripCreepage<P>, spin: &Spin<P>, found: &Separatrix<P>, by_s: P,
) -> [P; 4] {
    let Separatrix { y, root, inverse_size, .. } = *found;
    let (zero, one, two) = (P::zero(), P::one(), P::constant(2.0));
    // s₁ = root + softening; beyond 2 it stays there
    let root = root.min(two);
    let z = root.plus(EDGE - 2.0).max(zero).times(1.0 / EDGE);
    let slope = (two - root).choose((one - z) * (one + z.times(3.0)), zero);
    let end = root + (z.squared() * (one - z)).times(EDGE);
    let by_root = by_s * (one - spin.blend) * slope * inverse_size;
    let by_prime = by_root * (y + root * spin.r);
    [by_root * seen.x, by_prime, by_prime * root, by_s * (two - end)]
}

/// `Σ cᵢ uⁱ` and its derivative.
#[inline(always)]
fn polynomial_with_slope<P: Arithmetic<Value = P>, const N: usize>(c: &[P; N], u: P) -> [P; 2] {
    let (mut sum, mut slope) = (P::zero(), P::zero());
    for c in c.iter().rev() {
        slope = slope * u + sum;
        sum = sum * u + *c;
    }
    [sum, slope]
}
