//! The strips with adhesion when `|ψ| > 1` (8.26).
//!
//! A root of (5.41) then exists only with `ηψ < 0` and where `S² = η² − (ψ² − 1) ξ̄²` is not negative. With
//! `P = −ηψ` the adhesion length is `κ = (P − S)/(ψ² − 1)`, still a convex function of `Y` because `S` is
//! concave: the strips with `κ < C` form one interval, bounded by the leading edge or by `S = 0`. The
//! traction on their adhesion interval exceeds the friction bound where
//! `C > (P + S)²/((ψ² − 1)(P + 3 S))`; these strips slide after all.

use super::{AdhesionInterval, EdgePoint, StripFamily};
use crate::number::{Arithmetic, Float, Plain, Real};
use crate::strip_1967::strip::{bounded_half_length, root_s};

/// Cells of the adhesion interval in the search for strips that slide.
const CELLS: usize = 16;
/// Refinements of a peak between three samples.
const PEAK_STEPS: usize = 40;
/// Steps that exhaust the digits of a double by bisection; the usual number is eight.
const ROOT_STEPS: usize = 64;

/// What a strip is longer than, or shorter where it is negative.
#[derive(Clone, Copy, PartialEq)]
enum Margin {
    /// Than its slip area, `C − κ`: positive where it adheres.
    Slip,
    /// Than the bound on its traction allows: positive where it slides after all.
    Bound,
}

/// The leading edge in a variable in which nothing is singular.
///
/// Where the domain `S² ≥ 0` may end inside the contact: by the angle `τ` with `ξ̄ = R sin τ`,
/// `S = |η| cos τ`, `R = |η|/√(ψ² − 1)`; elsewhere by the angle `θ` of the contact, `Y = sin θ`. The variable is
/// the tangent of half of it.
struct Edge<T> {
    family: StripFamily<T>,
    /// `|η|`
    eta: T,
    /// `R`
    radius: T,
    /// `P = −ηψ = |η| |ψ|`
    p: T,
    /// `ψ² − 1`
    q: T,
    by_slip: bool,
}

impl<T: Real> Edge<T> {
    fn new(family: &StripFamily<T>) -> Self {
        let size = family.psi.abs();
        let q = (size - T::one()) * (size + T::one());
        let eta = family.eta.abs();
        let radius = eta / q.sqrt();
        let by_slip = radius < family.slope.abs().times(4.0);
        Self { family: *family, eta, radius, p: eta * size, q, by_slip }
    }

    /// The same without derivatives.
    #[inline(always)]
    fn plain(&self) -> Edge<T::Base> {
        Edge {
            family: self.family.plain(),
            eta: self.eta.value(),
            radius: self.radius.value(),
            p: self.p.value(),
            q: self.q.value(),
            by_slip: self.by_slip,
        }
    }

    /// The point of the leading edge, `ξ̄` and `S`.
    #[inline(never)]
    fn at(&self, w: T) -> (EdgePoint<T>, T, T) {
        if !self.by_slip {
            let point = EdgePoint::at_half_tangent(w);
            let xi_bar = self.family.xi_bar(point.y);
            return (point, xi_bar, root_s(xi_bar, self.eta, self.family.psi));
        }
        let scale = T::one() / (T::one() + w * w);
        let xi_bar = self.radius * (w * scale).times(2.0);
        let y = (self.family.xi - xi_bar) / self.family.slope;
        let c = ((T::one() - y) * (T::one() + y)).max(T::zero()).sqrt();
        (EdgePoint { y, c }, xi_bar, self.eta * ((T::one() - w) * (T::one() + w) * scale))
    }

    /// The variable at a point of the edge, or at the end of the domain next to it.
    #[inline(never)]
    fn place(&self, point: EdgePoint<T>) -> T {
        if !self.by_slip {
            return point.y / (T::one() + point.c);
        }
        let z = self.family.xi_bar(point.y) / self.radius;
        if !(z.abs() < T::one()) {
            return if z > T::zero() { T::one() } else { -T::one() };
        }
        z / (T::one() + ((T::one() - z) * (T::one() + z)).sqrt())
    }
}

impl<F: Float> Edge<F> {
    /// A function of the strips and its value at a place.
    #[inline(never)]
    fn margin(&self, of: Margin, w: F) -> F {
        let (point, xi_bar, s) = self.at(w);
        let sum = self.p + s;
        point.c
            - match of {
                Margin::Bound => sum * sum / (self.q * (self.p + s.times(3.0))),
                // κ by the second form of (5.41)
                Margin::Slip => (xi_bar * xi_bar + self.eta * self.eta) / sum,
            }
    }

    /// How much longer the strip is than the bound on its traction allows.
    fn excess(&self, w: F) -> F {
        self.margin(Margin::Bound, w)
    }

    /// Where a margin, of opposite signs at `a` and `b`, vanishes: regula falsi by the rule of Anderson
    /// and Björck (1973), with bisection where it does not shrink the interval.
    #[inline(never)]
    fn root(&self, of: Margin, mut a: F, mut b: F) -> F {
        let (mut at_a, mut at_b) = (self.margin(of, a), self.margin(of, b));
        let mut width = (b - a).abs();
        for step in 0..ROOT_STEPS {
            if (b - a).abs() <= (a.abs() + b.abs()) * F::EPSILON {
                break;
            }
            let middle = (a + b).times(0.5);
            let mut x = b - at_b * (b - a) / (at_b - at_a);
            if step % 3 == 2 {
                if (b - a).abs() > width.times(0.125) {
                    x = middle;
                }
                width = (b - a).abs();
            }
            if !((x > a && x < b) || (x > b && x < a)) {
                x = middle;
            }
            let at_x = self.margin(of, x);
            if at_x.abs() <= F::TINY {
                return x;
            }
            if (at_x > F::zero()) == (at_b > F::zero()) {
                let shrink = F::one() - at_x / at_b;
                at_a = if shrink > F::zero() { at_a * shrink } else { at_a.times(0.5) };
            } else {
                (a, at_a) = (b, at_b);
            }
            (b, at_b) = (x, at_x);
        }
        b
    }

    /// A place between `low` and `high` where the excess times `sign` is positive, if there is one
    /// (golden section). At the ends it is not, and `at_low` and `at_high`.
    ///
    /// Of a concave function the peak rises above the best of the four points by less than twice what the worst
    /// of them lies below it: mostly the first step tells that there is none.
    #[inline(never)]
    fn peak(&self, (mut low, at_low): (F, F), (mut high, at_high): (F, F), sign: F) -> Option<F> {
        const GOLDEN: f64 = 0.618_033_988_749_895;
        let excess = |w: F| self.excess(w) * sign;
        let (mut at_low, mut at_high) = (at_low * sign, at_high * sign);
        let span = (high - low).times(GOLDEN);
        let (mut left, mut right) = (high - span, low + span);
        let (mut at_left, mut at_right) = (excess(left), excess(right));
        for _ in 0..PEAK_STEPS {
            if at_left > F::zero() {
                return Some(left);
            }
            if at_right > F::zero() {
                return Some(right);
            }
            let best = at_left.max(at_right);
            let worst = at_low.min(at_high).min(at_left).min(at_right);
            if best + (best - worst).times(2.0) < F::zero()
                || (high - low).abs() <= F::ROOT_TINY.max((low.abs() + high.abs()) * F::EPSILON)
            {
                break;
            }
            if at_left > at_right {
                (high, at_high, right, at_right) = (right, at_right, left, at_left);
                left = high - (high - low).times(GOLDEN);
                at_left = excess(left);
            } else {
                (low, at_low, left, at_left) = (left, at_left, right, at_right);
                right = low + (high - low).times(GOLDEN);
                at_right = excess(right);
            }
        }
        None
    }
}

impl<F: Float> StripFamily<F> {
    /// Ends of the interval with `κ < C`, outwards from the strip nearest to adhesion; for `|ψ| > 1`.
    pub(super) fn beyond_unit_spin(&self) -> Option<(EdgePoint<F>, EdgePoint<F>)> {
        if !(self.eta * self.psi < F::zero()) {
            return None;
        }
        let edge = Edge::new(self);
        let middle = edge.place(self.nearest());
        if !(edge.margin(Margin::Slip, middle) > F::zero()) {
            return None;
        }
        let end = |y: F| {
            let mut limit = edge.place(EdgePoint { y, c: F::zero() });
            if edge.margin(Margin::Slip, limit) < F::zero() {
                limit = edge.root(Margin::Slip, middle, limit);
            }
            edge.at(limit).0
        };
        Some((end(-F::one()), end(F::one())))
    }
}

/// A piece of the leading edge, from its lower to its upper end.
pub(crate) type Piece<T> = (EdgePoint<T>, EdgePoint<T>);

/// For `|ψ| > 1`: the pieces of the adhesion interval whose strips slide after all, because the traction on
/// their adhesion interval would exceed the bound.
///
/// The interval is looked at cell by cell, and no piece is longer than a cell: sums over pieces then
/// hardly change where two of them join.
pub(crate) struct Released<T: Real> {
    /// With derivatives: the cells move with the ends of the interval.
    moving: Edge<T>,
    first: T,
    step: T,
    /// Number of the next cell.
    cell: usize,
    /// Its lower end.
    lower: EdgePoint<T>,
    upper: EdgePoint<T>,
    /// The excess before the cell and at its ends.
    excess: [T::Base; 3],
    /// The pieces of the last cell.
    pub pieces: [Option<Piece<T>>; 2],
}

impl<T: Real> Released<T> {
    #[inline(never)]
    pub(crate) fn of(family: &StripFamily<T>, interval: &AdhesionInterval<T>) -> Self {
        let moving = Edge::new(family);
        let AdhesionInterval { lower, upper } = *interval;
        let first = moving.place(lower);
        let step = (moving.place(upper) - first).times(1.0 / CELLS as f64);
        let edge = moving.plain();
        // (P + S)²/(P + 3 S) is smallest at S = P/3: no strip is longer than that allows.
        let cell = if edge.p.times(8.0 / 9.0) >= edge.q { CELLS } else { 0 };
        let at_lower = edge.excess(first.value());
        let at_next = edge.excess((first + step).value());
        let excess = [at_lower, at_lower, at_next];
        Self { moving, first, step, cell, lower, upper, excess, pieces: [None; 2] }
    }

    fn end(&self, k: usize) -> T {
        self.first + self.step.times(k.min(CELLS) as f64)
    }

    /// Finds the pieces of the next cell; `false` after the last.
    #[inline(never)]
    pub(crate) fn next_cell(&mut self) -> bool {
        let k = self.cell;
        if k >= CELLS {
            return false;
        }
        let zero = <T::Base as Arithmetic>::zero();
        let (from, to) = (self.end(k).value(), self.end(k + 1).value());
        let edge = self.moving.plain();
        let after = edge.excess(self.end(k + 2).value());
        let [before, at_from, at_to] = self.excess;
        let lower = self.lower;
        let upper = if k + 1 < CELLS { self.moving.at(self.end(k + 1)).0 } else { self.upper };
        (self.cell, self.lower, self.excess) = (k + 1, upper, [at_from, at_to, after]);
        let positive = at_from > zero;
        // Where the sign changes, and changes back
        let (mut change, mut back) = (None, None);
        if (at_to > zero) == positive {
            // A peak below zero or a trough above it may hide two changes of sign.
            let sign = if positive { -T::Base::one() } else { T::Base::one() };
            if (at_from - before) * sign >= zero && (at_to - after) * sign >= zero {
                let peak = edge.peak((from, at_from), (to, at_to), sign);
                (change, back) = (peak.map(|w| (from, w)), peak.map(|w| (w, to)));
            }
        } else {
            change = Some((from, to));
        }
        let mut start = positive.then_some(lower);
        self.pieces = [None; 2];
        let mut places = self.pieces.iter_mut();
        let mut put = |piece| {
            if let Some(place) = places.next() {
                *place = Some(piece);
            }
        };
        for (from, to) in [change, back].into_iter().flatten() {
            let point = self.moving.family.change(&edge, from, to);
            match start.take() {
                Some(start) => put((start, point)),
                None => start = Some(point),
            }
        }
        if let Some(start) = start {
            put((start, upper));
        }
        true
    }
}

impl<T: Real> StripFamily<T> {
    /// Where the excess changes sign between two places, with derivatives.
    #[inline(never)]
    fn change(&self, edge: &Edge<T::Base>, from: T::Base, to: T::Base) -> EdgePoint<T> {
        let place = edge.root(Margin::Bound, from, to);
        let (point, xi_bar, s) = edge.at(place);
        let lifted = EdgePoint::lifted(point);
        if !T::HAS_DERIVATIVES {
            return lifted;
        }
        let Some(limit) = bounded_half_length(self.xi_bar(lifted.y), self.eta, self.psi) else {
            return lifted;
        };
        // d(C − limit)/dθ = −Y − C d(limit)/dY, with d(limit)/dS from the formula of the limit.
        let (p, s) = (edge.p, s + T::TINY);
        let denominator = p + s.times(3.0);
        let by_s = (p + s) * (s.times(3.0) - p) / (edge.q * denominator * denominator);
        let s_by_y = edge.q * edge.family.slope * xi_bar / s;
        let growth = -point.y - point.c * by_s * s_by_y;
        let turn = -((lifted.c - limit).scale(T::Base::one() / growth));
        let close = turn.value().abs() < T::Base::of(1e-6).max(T::EPSILON.times(1024.0));
        if turn.value().is_finite_number() && close {
            EdgePoint { y: lifted.y + lifted.c * turn, c: lifted.c - lifted.y * turn }
        } else {
            lifted
        }
    }
}
