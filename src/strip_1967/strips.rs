//! The strips of a solution: pieces of equal width that are the same for every motion.
//!
//! A strip carries the difference of the primitives of [`totals`](crate::strip_1967::totals())
//! between its edges, so the strips add up to the totals, whatever their number and wherever
//! adhesion ends.

use crate::contact::creepage::Parameters;
use crate::contact::totals::StripCount;
use crate::number::{Float, add};
use crate::strip_1967::adhesion::adhering;
use crate::strip_1967::edge::{self, Arc, Edge};
use crate::strip_1967::integrals::Shares;
use crate::strip_1967::reduced::ReducedCreepage;
use crate::strip_1967::sliding::sliding;
use crate::strip_1967::strip::{SlidingRule, Strip};
use crate::strip_1967::{turned_back, with_spin};

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
    /// Its share of the stick area.
    pub stick: T,
}

/// Every strip, handed to `visit`, ascending in `y`.
pub fn strips<F: Float>(
    parameters: &Parameters<F>,
    rule: SlidingRule,
    count: StripCount,
    visit: &mut dyn FnMut(PlacedStrip<F>),
) {
    let motion = ReducedCreepage::new(parameters, rule);
    let (arc, some) = edge::adhesion(&motion);
    let adheres = some > F::zero();
    let number = |i: i32| F::widened(i as f32);
    let width = number(2) / number(count as i32);
    let piece = |i: i32| {
        // The strips of a mirrored motion come in the opposite order.
        let i =
            if motion.turned_x * motion.turned_y < F::zero() { count as i32 - 1 - i } else { i };
        let edges = [i, i + 1].map(|i| Edge::at(width * number(i) - F::one()));
        share(&motion, &arc, adheres, edges)
    };
    // Nodes lie at other places in a strip than in the whole interval. The difference is
    // distributed in proportion to ∫ C² dY, that of m_x in proportion to the stick area.
    let mut rest = with_spin(&motion);
    let mut stick = F::TINY;
    (0..count as i32).for_each(|i| {
        let piece = piece(i);
        stick += piece[4];
        add(&mut rest, piece.map(|share| -share));
    });
    let [fx, fy, mx, lever, _] = rest;
    for i in 0..count as i32 {
        let mut piece = piece(i);
        let y = width * number(i).plus(0.5) - F::one();
        // ∫ C² dY, divided by its total 4/3.
        let load = width * (F::one() - y * y - (width * width).times(1.0 / 12.0)).times(0.75);
        let sticks = piece[4] / stick;
        let more = [fx * load, fy * load, mx * sticks, lever * load, F::zero()];
        add(&mut piece, more);
        let totals = turned_back(&motion, piece);
        let Parameters { xi, eta, psi, poisson_ratio, .. } = *parameters;
        let c = Edge::at(y).c;
        let strip =
            Strip::solve(c, xi - parameters.spin_slope() * y, eta, psi, poisson_ratio, rule);
        visit(PlacedStrip {
            y,
            half_length: c,
            width,
            kappa: (strip.separatrix() + c).times(0.5),
            adheres: strip.adheres(),
            fx: totals.fx,
            fy: totals.fy,
            mz: totals.mz,
            stick: totals.stick,
        });
    }
}

/// The forces of the strips between two edges.
fn share<F: Float>(
    motion: &ReducedCreepage<F>,
    arc: &Arc<F>,
    adheres: bool,
    [from, to]: [Edge<F>; 2],
) -> Shares<F> {
    let (lower, upper) = (arc.lower, arc.upper);
    let below = |edge: Edge<F>| Edge::chosen(edge.y - lower.y, lower, edge);
    let above = |edge: Edge<F>| Edge::chosen(upper.y - edge.y, upper, edge);
    let mut shares = sliding(motion, [below(from), below(to)], [above(from), above(to)]);
    let inside = |edge: Edge<F>| {
        Edge::chosen(edge.y - upper.y, upper, Edge::chosen(lower.y - edge.y, lower, edge))
    };
    let (first, last) = (inside(from), inside(to));
    if adheres && last.y > first.y {
        add(&mut shares, adhering(motion, &Arc::between(first, last)));
    }
    shares
}
