//! The strips of a solution: pieces of equal width that are the same for every motion.
//!
//! The parts of a strip that adhere and slide end where those of the contact do ([`edge`]), so that
//! strips vary continuously with the motion. Each part is computed in closed form from its two ends
//! and the adhesion length in its middle, to the square of its width. The difference between the
//! sum and the [`totals`](crate::strip_1967::totals()) is distributed, so that the strips add up to
//! the totals, whatever their number.

use crate::contact::creepage::Parameters;
use crate::contact::totals::{StripCount, Totals};
use crate::number::{Float, add};
use crate::strip_1967::edge::{self, Arc, Edge};
use crate::strip_1967::integrals::Shares;
use crate::strip_1967::reduced::ReducedCreepage;
use crate::strip_1967::strip::{SlidingRule, adhesion_length, adhesion_regime, spin_within};
use crate::strip_1967::totals;
use heapless::Vec;

/// Largest number of strips.
const CAPACITY: usize = 64;

/// One strip of a solution, dimensionless.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedStrip<T> {
    /// `Y = y/b` of the centre line.
    pub y: T,
    /// Half length `C = c/a` of the centre line.
    pub half_length: T,
    /// Width in `Y`.
    pub width: T,
    /// Half the length from the trailing edge to the separatrix on the centre line, `κ/a`; `C` when
    /// the strip slides.
    pub kappa: T,
    /// Whether its centre line has an adhesion area.
    pub adheres: bool,
    /// Its share of `F_x/(μ N)`.
    pub fx: T,
    /// Its share of `F_y/(μ N)`.
    pub fy: T,
    /// Its share of `M_z/(μ N √(ab))`, about the centre of the contact.
    pub mz: T,
}

/// Every strip, handed to `visit`, ascending in `y`.
pub fn visit_strips<F: Float>(
    parameters: &Parameters<F>, rule: SlidingRule, count: StripCount,
    visit: &mut dyn FnMut(PlacedStrip<F>),
) {
    let Parameters { xi, eta, psi, axis_ratio, .. } = *parameters;
    let motion = ReducedCreepage::new(parameters, rule);
    let (arc, _) = edge::adhesion(&motion);
    let (count, zero) = (count as usize, F::zero());
    let width = F::of(2.0) / F::widened(count as f32);
    let Totals { fx, fy, mz, .. } = totals(parameters, rule);
    let mut rest = [fx, fy, mz];
    let arm = axis_ratio.sqrt();
    let arms = [arm * motion.turned_y, motion.turned_y / arm];
    let mut pieces: Vec<[F; 3], CAPACITY> = Vec::new();
    let mut from = Edge { y: -F::one(), c: zero };
    let mut next = F::zero();
    for _ in 0..count {
        next += F::one();
        let to = Edge::at(width * next - F::one());
        let [fx, fy, mx, lever, _] = forces_between(&motion, &arc, from, to);
        let mz = mx * arms[0] - lever * arms[1];
        let piece = [fx * motion.turned_x, fy * motion.turned_y, mz].map(|share| share.times(0.75));
        add(&mut rest, piece.map(|share| -share));
        // There is room for the largest count.
        let _ = pieces.push(piece);
        from = to;
    }
    // The strips of a mirrored motion come in the opposite order.
    let mirrored = motion.turned_x * motion.turned_y < zero;
    // The difference is distributed in proportion to ∫ C² dY.
    let [more_x, more_y, more_z] = rest;
    let (slope, spin) = (parameters.spin_slope(), spin_within(psi));
    let curved = F::one() - (width * width).times(1.0 / 12.0);
    let mut middle = F::of(0.5);
    for i in 0..count {
        let place = if mirrored { count - 1 - i } else { i };
        let Some([fx, fy, mz]) = pieces.get(place) else { return };
        let y = width * middle - F::one();
        middle += F::one();
        // ∫ C² dY, divided by its total 4/3.
        let load = width * (curved - y * y).times(0.75);
        let c = Edge::at(y).c;
        let found = adhesion_regime(c, xi - slope * y, eta, spin);
        // This gives the same bits as the separatrix, −C + 2κ.
        let kappa = found.map(|[kappa, ..]| (kappa + kappa - c + c).times(0.5));
        visit(PlacedStrip {
            y,
            half_length: c,
            width,
            kappa: kappa.unwrap_or(c),
            adheres: kappa.is_some(),
            fx: *fx + more_x * load,
            fy: *fy + more_y * load,
            mz: *mz + more_z * load,
        });
    }
}

/// The forces of the strips between two edges: those that slide below and above the arc, and those
/// on the arc.
fn forces_between<F: Float>(
    motion: &ReducedCreepage<F>, arc: &Arc<F>, from: Edge<F>, to: Edge<F>,
) -> Shares<F> {
    let (lower, upper) = if arc.lower.y > to.y || arc.upper.y < from.y {
        (to, to)
    } else {
        let later = |edge: Edge<F>| if edge.y < from.y { from } else { edge };
        let earlier = |edge: Edge<F>| if edge.y > to.y { to } else { edge };
        (later(arc.lower), earlier(arc.upper))
    };
    let mut shares = [F::zero(); 5];
    let (mut first, mut last) = (from, lower);
    for _ in 0..2 {
        if last.y > first.y {
            add(&mut shares, sliding_between(motion, first, last));
        }
        if upper.y >= to.y {
            break;
        }
        (first, last) = (upper, to);
    }
    if upper.y > lower.y {
        add(&mut shares, adhering_between(motion, lower, upper));
    }
    shares
}

/// `∫ C² dY`
fn load<F: Float>(from: Edge<F>, to: Edge<F>) -> F {
    let mean = from.y * from.y + from.y * to.y + to.y * to.y;
    (to.y - from.y) * (F::one() - mean.times(1.0 / 3.0))
}

/// `∫ C² w dY` with the mean direction of a slip `n` that is linear between both ends: in the parts
/// of `n` along `n₂ − n₁ = L e` and across,
/// `∫ n/|n| = (n₁ + n₂ + 2 (A − 1) n_across)/(|n₁| + |n₂|)`, `A = artanh t/t`,
/// `t = L/(|n₁| + |n₂|)`. The ends are moved together so that their middle has the means of `Y` and
/// `C` under the weight `C²`, taken as linear.
fn sliding_between<F: Float>(motion: &ReducedCreepage<F>, from: Edge<F>, to: Edge<F>) -> Shares<F> {
    let ReducedCreepage { eta, psi, compliance, rule, .. } = *motion;
    // C = a ± e at the ends
    let (a, e, width) = ((from.c + to.c).times(0.5), (to.c - from.c).times(0.5), to.y - from.y);
    let (a2, e2) = (a * a, e * e);
    let inverse = (a * (a2 + e2)).inverse();
    let moved_y = (width * a2 * e * inverse).times(1.0 / 3.0);
    let moved_c = e2 * (a2 + e2.times(0.2)) * inverse;
    let slip = |edge: Edge<F>| {
        let x = motion.xi_bar(edge.y + moved_y);
        let [x, y] = match rule {
            SlidingRule::RigidSlip => [x * compliance, eta],
            SlidingRule::Continuous => [x, eta + psi * (edge.c + moved_c)],
        };
        [x, y, (x * x + y * y).sqrt()]
    };
    let ([x1, y1, size1], [x2, y2, size2]) = (slip(from), slip(to));
    let inverse = (size1 + size2 + F::EPSILON * F::EPSILON).inverse();
    let (x, y) = (x1 + x2, y1 + y2);
    let (along_x, along_y) = ((x2 - x1) * inverse, (y2 - y1) * inverse);
    let t2 = along_x * along_x + along_y * along_y;
    let more = artanh_quotient(t2);
    // n_across = n − e (e · n), t² = L²/(|n₁| + |n₂|)²
    let part = (x * along_x + y * along_y) / (t2 + F::TINY);
    let (across_x, across_y) = (x - part * along_x, y - part * along_y);
    let scale = load(from, to) * inverse;
    let (fx, fy) = ((x + more * across_x) * scale, (y + more * across_y) * scale);
    let zero = F::zero();
    [fx, fy, zero, fx * ((from.y + to.y).times(0.5) + moved_y), zero]
}

/// `artanh t/t − 1` of `t²`, which rounding may take to 1.
fn artanh_quotient<F: Float>(t2: F) -> F {
    if t2 < F::of(0.04) {
        let [_, powers @ ..] = F::ARTANH else { return F::zero() };
        return powers.iter().rev().fold(F::zero(), |sum, c| (sum + *c) * t2);
    }
    let t = t2.min(F::one() - F::EPSILON).sqrt();
    (F::one() + t).ln_quotient(F::one() - t) / (t + t) - F::one()
}

/// `f_x = ξ̄ (2C − K)`, `f_y = ψ C² + η (2C − K)`, `m_x = −η (C − K)²` with `K` of the middle.
fn adhering_between<F: Float>(
    motion: &ReducedCreepage<F>, from: Edge<F>, to: Edge<F>,
) -> Shares<F> {
    let ReducedCreepage { xi, eta, psi, slope, .. } = *motion;
    let (width, drop) = (to.y - from.y, to.c - from.c);
    // ∫ C dY: the trapezium, and the segment of the circle over the chord h, h³/12 (1 + 3 h²/40 …)
    let chord2 = width * width + drop * drop;
    let segment = chord2 * chord2.sqrt() * chord2.times(0.00625).plus(1.0 / 12.0);
    let c = (from.c + to.c) * width.times(0.5) + segment;
    // ∫ Y C dY
    let yc = (from.c * from.c * from.c - to.c * to.c * to.c).times(1.0 / 3.0);
    let cc = load(from, to);
    let y = (from.y + to.y).times(0.5);
    let x = motion.xi_bar(y);
    let k = adhesion_length(x, eta, psi).map_or(c, |k| (k * width).min(c));
    let (xc, xk) = ((xi * c - slope * yc).times(2.0), x * k);
    let stretch = c + c - k;
    // ∫ (C − K)² dY with ∫ C² dY ≥ (∫ C dY)²/ΔY
    let mx = -(eta * (cc - (k * stretch) / width));
    [xc - xk, psi * cc + eta * stretch, mx, xc * (yc / c) - xk * y, c - k]
}
