//! The strips with adhesion when `|ψ| > 1` (8.26).
//!
//! A root of (5.41) then exists only with `ηψ < 0` and where `S² = η² − (ψ² − 1) ξ̄²` is not negative. With
//! `P = −ηψ` the adhesion length is `κ = (P − S)/(ψ² − 1)`, still a convex function of `Y` because `S` is
//! concave: the strips with `κ < C` form one interval, bounded by the leading edge or by `S = 0`. The
//! traction on their adhesion interval exceeds the friction bound where
//! `C > (P + S)²/((ψ² − 1)(P + 3 S))`; these strips slide after all.

use super::{AdhesionInterval, EdgePoint, StripFamily};
use crate::real::{Arithmetic, Float, Real};
use crate::strip::{bounded_half_length, root_s};

/// Cells of the adhesion interval in the search for strips that slide.
const CELLS: usize = 16;
/// Refinements of a peak between three samples.
const PEAK_STEPS: usize = 40;
/// Steps that exhaust the digits of a double by bisection; the usual number is eight.
const ROOT_STEPS: usize = 64;

/// Where `f`, of opposite signs at `a` and `b`, vanishes: regula falsi by the rule of Anderson and
/// Björck (1973), with bisection where it does not shrink the interval.
fn root<F: Float>(f: impl Fn(F) -> F, (mut a, mut fa): (F, F), (mut b, mut fb): (F, F)) -> F {
    let mut width = (b - a).abs();
    for step in 0..ROOT_STEPS {
        if (b - a).abs() <= (a.abs() + b.abs()) * F::EPSILON {
            break;
        }
        let middle = (a + b).times(0.5);
        let mut x = b - fb * (b - a) / (fb - fa);
        if step % 3 == 2 {
            if (b - a).abs() > width.times(0.125) {
                x = middle;
            }
            width = (b - a).abs();
        }
        if !((x > a && x < b) || (x > b && x < a)) {
            x = middle;
        }
        let fx = f(x);
        if fx.abs() <= F::TINY {
            return x;
        }
        if (fx > F::zero()) == (fb > F::zero()) {
            let shrink = F::one() - fx / fb;
            fa = if shrink > F::zero() { fa * shrink } else { fa.times(0.5) };
        } else {
            (a, fa) = (b, fb);
        }
        (b, fb) = (x, fx);
    }
    b
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

    /// The point of the leading edge, `ξ̄` and `S`.
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
    /// How much longer the strip is than the bound on its traction allows; negative where it sticks.
    fn excess(&self, w: F) -> F {
        let (point, _, s) = self.at(w);
        let sum = self.p + s;
        point.c - sum * sum / (self.q * (self.p + s.times(3.0)))
    }

    /// `C − κ`, by the second form of (5.41).
    fn room(&self, w: F) -> F {
        let (point, xi_bar, s) = self.at(w);
        point.c - (xi_bar * xi_bar + self.eta * self.eta) / (s + self.p)
    }

    /// A place between `low` and `high` where the excess times `sign` is positive, if there is one
    /// (golden section).
    fn peak(&self, mut low: F, mut high: F, sign: F) -> Option<F> {
        const GOLDEN: f64 = 0.618_033_988_749_895;
        for _ in 0..PEAK_STEPS {
            let span = (high - low).times(GOLDEN);
            let (left, right) = (high - span, low + span);
            let (at_left, at_right) = (self.excess(left) * sign, self.excess(right) * sign);
            if at_left > F::zero() {
                return Some(left);
            }
            if at_right > F::zero() {
                return Some(right);
            }
            if (high - low).abs() <= F::ROOT_TINY.max((low.abs() + high.abs()) * F::EPSILON) {
                break;
            }
            if at_left > at_right { high = right } else { low = left }
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
        let at_middle = edge.room(middle);
        if !(at_middle > F::zero()) {
            return None;
        }
        let end = |y: F| {
            let limit = edge.place(EdgePoint { y, c: F::zero() });
            let room = edge.room(limit);
            let found = if room >= F::zero() {
                limit
            } else {
                root(|w| edge.room(w), (middle, at_middle), (limit, room))
            };
            edge.at(found).0
        };
        Some((end(-F::one()), end(F::one())))
    }
}

impl<T: Real> StripFamily<T> {
    /// For `|ψ| > 1`: hands the pieces of the adhesion interval to `take` whose strips slide after all,
    /// because the traction on their adhesion interval would exceed the bound.
    ///
    /// The interval is looked at cell by cell, and no piece is longer than a cell: sums over pieces then
    /// hardly change where two of them join.
    pub(crate) fn released(
        &self,
        interval: &AdhesionInterval<T>,
        mut take: impl FnMut(EdgePoint<T>, EdgePoint<T>),
    ) {
        let (edge, moving) = (Edge::new(&self.plain()), Edge::new(self));
        let zero = <T::Base as Arithmetic>::zero();
        // (P + S)²/(P + 3 S) is smallest at S = P/3: no strip is longer than that allows.
        if edge.p.times(8.0 / 9.0) >= edge.q {
            return;
        }
        // `moving` carries derivatives: the cells move with the ends of the interval.
        let first = moving.place(interval.lower);
        let step = (moving.place(interval.upper) - first).times(1.0 / CELLS as f64);
        let end = |k: usize| first + step.times(k.min(CELLS) as f64);
        let place = |k: usize| end(k).value();
        // the excess before the cell, at its ends, and after it
        let mut excess = [edge.excess(place(0)); 4];
        excess[2] = edge.excess(place(1));
        let mut lower = interval.lower;
        for k in 0..CELLS {
            let (from, to) = (place(k), place(k + 1));
            excess[3] = edge.excess(place(k + 2));
            let [before, at_from, at_to, after] = excess;
            let upper = if k + 1 < CELLS { moving.at(end(k + 1)).0 } else { interval.upper };
            let positive = at_from > zero;
            if (at_to > zero) == positive {
                // A peak below zero or a trough above it may hide two changes of sign.
                let sign = if positive { -T::Base::one() } else { T::Base::one() };
                let hidden = (at_from - before) * sign >= zero && (at_to - after) * sign >= zero;
                let peak = if hidden { edge.peak(from, to, sign) } else { None };
                if let Some(peak) = peak {
                    let changes = (self.change(&edge, from, peak), self.change(&edge, peak, to));
                    if positive {
                        take(lower, changes.0);
                        take(changes.1, upper);
                    } else {
                        take(changes.0, changes.1);
                    }
                } else if positive {
                    take(lower, upper);
                }
            } else {
                let change = self.change(&edge, from, to);
                if positive { take(lower, change) } else { take(change, upper) }
            }
            lower = upper;
            excess = [at_from, at_to, after, after];
        }
    }

    /// Where the excess changes sign between two places, with derivatives.
    fn change(&self, edge: &Edge<T::Base>, from: T::Base, to: T::Base) -> EdgePoint<T> {
        let ends = (edge.excess(from), edge.excess(to));
        let place = root(|w| edge.excess(w), (from, ends.0), (to, ends.1));
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
        if turn.value().is_finite_number() && turn.value().abs() < T::Base::of(1e-6) {
            EdgePoint { y: lifted.y + lifted.c * turn, c: lifted.c - lifted.y * turn }
        } else {
            lifted
        }
    }
}
