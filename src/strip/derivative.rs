//! A strip's derivatives by `A_x, A_y, σ` and what else it sees: the kernel's formulas differentiated from their results back to what
//! the strip sees. (Dual numbers through the kernel give the same and take longer.)

use super::constants::{AVERAGE, BLEND, EDGE, NODES, ROUND_SPIN};
use super::kernel::{
    Carried, Passed, Seen, Separatrix, Spin, Start, Traction, blending, forces, widest,
};
use super::tables::{Constants, Node};
use crate::number::Arithmetic;

/// How what follows from `σ` alone moves with it.
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

    /// Another kind of number for each of its own.
    pub fn map<U>(&self, all: impl Fn(T) -> U) -> SpinSlopes<U> {
        SpinSlopes { r: all(self.r), blend: all(self.blend), round: all(self.round) }
    }
}

/// Forces of strips side by side, and the derivatives of `f_x, f_y, m_x` by `A_x, A_y, σ`, the spread and the start.
#[inline(always)]
pub(super) fn forces_and_slopes<P: Arithmetic<Bare = P>>(
    seen: &Seen<P>,
    spin: &Spin<P>,
    constants: &impl Constants<P>,
    by_spin: &SpinSlopes<P>,
) -> (Carried<P>, [[P; 5]; 3]) {
    let zero = P::zero();
    let traction = Traction { x: zero, y: zero, offered: [zero; 3], tried: zero };
    let mut nodes = [Passed { inverse_bound: zero, weight: zero, traction, kept: zero }; NODES];
    let (carried, start) = forces(seen, spin, constants, |k, passed| {
        if let Some(node) = nodes.get_mut(k) {
            *node = passed;
        }
    });
    let back = Back::new(seen, spin, by_spin, constants, &start, &nodes);
    let slopes =
        [back.from(Force::Longitudinal), back.from(Force::Lateral), back.from(Force::Moment)];
    (carried, slopes)
}

/// Which of a strip's forces.
#[derive(Clone, Copy, PartialEq)]
enum Force {
    Longitudinal,
    Lateral,
    Moment,
}

/// What the ways back from the three forces share.
struct Back<'a, P> {
    seen: &'a Seen<P>,
    spin: &'a Spin<P>,
    by_spin: &'a SpinSlopes<P>,
    nodes: [Turned<P>; NODES],
    start: &'a Start<P>,
    /// The polynomials of the closed force and moment, and their slopes.
    closed: [[P; 2]; 2],
}

/// A node on the way back.
#[derive(Clone, Copy)]
struct Turned<P> {
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
    /// `p*`, and half of what `q` moves with it twice over: `2 p*/B²`
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

impl<P: Arithmetic<Bare = P>> Turned<P> {
    #[inline(always)]
    fn new(node: &Node<P>, own: &Passed<P>, before: P, s: P, spin: &Spin<P>) -> Self {
        let one = P::one();
        let (b, m, q) = (own.inverse_bound, own.kept, own.traction.tried);
        let [x, y, wide] = own.traction.offered;
        let half = (q * (m * m)).plus(1.0).times(0.5);
        // rounded(q): by q 1 − y, by d y (1 − y), y = z/(2 d)
        let z = (one + spin.round - q.max(one - spin.round)).max(P::zero());
        let z = z * (spin.inverse_round + spin.inverse_round);
        let cut = (m * m * m).times(-0.5) * (one - z);
        let twice = b * b + b * b;
        let bound = node.place * node.place * b;
        let [c0, c1, c2, c3] = node.weight;
        let u = s.times(0.5);
        let slope = [c0.times(2.0), c1.times(3.0), c2.times(4.0), c3.times(5.0)];
        let [slope, _] = with_slope(&slope, u);
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

impl<'a, P: Arithmetic<Bare = P>> Back<'a, P> {
    #[inline(always)]
    fn new(
        seen: &'a Seen<P>,
        spin: &'a Spin<P>,
        by_spin: &'a SpinSlopes<P>,
        constants: &impl Constants<P>,
        start: &'a Start<P>,
        passed: &[Passed<P>; NODES],
    ) -> Self {
        let s = start.separatrix.s;
        let mut before = seen.start;
        let mut nodes = [Turned::new(&constants.node(0), &passed[0], before, s, spin); NODES];
        for (k, (turned, own)) in nodes.iter_mut().zip(passed).enumerate() {
            *turned = Turned::new(&constants.node(k), own, before, s, spin);
            before = own.kept;
        }
        let (u, closed) = (s.times(0.5), constants.closed());
        let closed = [with_slope(&closed.force, u), with_slope(&closed.moment, u)];
        Self { seen, spin, by_spin, nodes, start, closed }
    }

    /// The derivatives of a force by `A_x, A_y, σ`, the spread and the start.
    #[inline(always)]
    fn from(&self, force: Force) -> [P; 5] {
        let Self { seen, spin, start, .. } = self;
        let Separatrix { y, s, .. } = start.separatrix;
        let (zero, one, r) = (P::zero(), P::one(), spin.r);
        let turning = spin.sigma * s;
        // by the state ahead of a node, and sums over the nodes
        let (mut by_px, mut by_py, mut by_wide, mut by_kept) = (zero, zero, zero, zero);
        let (mut by_x, mut by_y, mut by_s, mut by_u) = (zero, zero, zero, zero);
        let (mut by_r, mut by_round) = (zero, zero);
        let (mut by_turning, mut by_square, mut by_spread) = (zero, zero, zero);
        for turned in self.nodes.iter().rev() {
            let Turned { weight, weight_slope, half, offered: [x, y, wide], .. } = *turned;
            let ([tx, ty], [px, py]) = (turned.traction, turned.p);
            // t = r e_y + (p/B − r e_y) e
            let through = match force {
                Force::Longitudinal => {
                    by_px += weight * turned.outer;
                    by_u += weight_slope * tx;
                    let through = weight * px;
                    by_s += through * half * turned.bound;
                    through
                }
                _ => {
                    let moment = force == Force::Moment;
                    let seed = if moment { weight * turned.x } else { weight };
                    by_py += seed * turned.outer;
                    by_r += seed * (one - half);
                    let slope = weight_slope * ty;
                    by_u += if moment { slope * turned.x } else { slope };
                    let through = seed * py;
                    by_s += (through + seed * r) * half * turned.bound;
                    if moment {
                        by_s += weight * ty * turned.place;
                    }
                    through
                }
            };
            // m and q
            let by_m = by_kept + x * by_px + y * by_py + wide * by_wide + through * turned.turned;
            let by_q = through * turned.half_square + by_m * turned.cut;
            by_round += by_m * turned.round;
            by_square += turned.soft * by_q;
            by_s += turned.stretched * by_q;
            // p* = p + λ (A + σ (2 x̂ + m λ s) e_y)
            by_px = turned.kept * by_px + turned.doubled[0] * by_q;
            by_py = turned.kept * by_py + turned.doubled[1] * by_q;
            by_wide = turned.kept * by_wide + turned.doubled[2] * by_q;
            by_spread += turned.length * by_wide;
            let step = turned.length * by_py;
            by_x += turned.length * by_px;
            by_y += step;
            by_turning += step * turned.turn;
            by_kept = step * turning * turned.length;
        }
        by_turning += by_square * (turning + turning);
        let mut by_sigma = by_turning * s - (by_y + by_y);
        by_s += by_turning * spin.sigma;
        // p = (2 − s) n, n = A'/s + r e_y
        let ahead = one - s.times(0.5);
        let [nx, ny] = start.n;
        let mut by_ahead = (nx * by_px + ny * by_py).times(2.0);
        let (by_nx, by_ny) = (by_px * (ahead + ahead), by_py * (ahead + ahead));
        by_x += by_nx * start.inverse_s;
        let mut by_prime = by_ny * start.inverse_s;
        by_r += by_ny;
        by_s -= start.inverse_s * (by_nx * nx + by_ny * (ny - r));
        // wide = (2 − s) spread/(2 s)
        let ratio = seen.spread * start.inverse_s;
        by_ahead += widest(ratio) * by_wide;
        let free = (ratio - widest(ratio)).abs().choose(zero, ahead * by_wide * start.inverse_s);
        by_spread = by_spread.times(0.5) + free;
        by_s -= free * ratio;
        // the closed part
        let [[k, k_slope], [l, l_slope]] = self.closed;
        let (c, whole) = (ahead * k, y + s * r);
        match force {
            Force::Longitudinal => {
                by_x += c;
                by_ahead += seen.x * k;
                by_u += ahead * k_slope * seen.x;
            }
            Force::Lateral => {
                by_prime += c;
                by_r += ahead.squared() + s * c;
                by_s += r * c;
                by_ahead += (r * ahead).times(2.0) + whole * k;
                by_u += ahead * k_slope * whole;
            }
            Force::Moment => {
                by_prime -= ahead * (ahead.times(0.5) + l);
                by_r -= ahead * s * l;
                by_s -= ahead * r * l;
                by_ahead -= y * ahead + whole * l;
                by_u -= ahead * whole * l_slope;
            }
        }
        by_s += (by_u - by_ahead).times(0.5);
        let [separatrix_x, separatrix_y, separatrix_r, by_blend] = self.separatrix(by_s);
        by_x += separatrix_x;
        by_prime += separatrix_y;
        by_r += separatrix_r;
        // A_y' = A_y + σ − r
        by_sigma += by_prime + (by_r - by_prime) * self.by_spin.r;
        by_sigma += by_blend * self.by_spin.blend + by_round * self.by_spin.round;
        [by_x, by_y + by_prime, by_sigma, by_spread, by_kept]
    }

    /// From `s` back to `A_x, A_y', r` and the share of blending:
    /// `s = s₁ + w (2 − s₁)`, `d root = (A_x dA_x + g (dA_y' + root dr))/S`, `g = A_y' + root r`.
    #[inline(always)]
    fn separatrix(&self, by_s: P) -> [P; 4] {
        let Self { seen, spin, start, .. } = self;
        let Separatrix { y, root, inverse_size, .. } = start.separatrix;
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
}

/// `Σ cᵢ uⁱ` and its derivative.
#[inline(always)]
fn with_slope<P: Arithmetic<Bare = P>, const N: usize>(c: &[P; N], u: P) -> [P; 2] {
    let (mut sum, mut slope) = (P::zero(), P::zero());
    for c in c.iter().rev() {
        slope = slope * u + sum;
        sum = sum * u + *c;
    }
    [sum, slope]
}
