//! Bristles in a strip: points of the layer that do not act on their neighbours (Kalker's
//! simplified theory, with an elliptic bound).
//!
//! Lengths count in half lengths of the strip, tractions in its largest bound. A bristle enters at
//! the leading edge and bends with the rigid slip, `dt/du = s(x)`, `s = (s_x, s_y + q x)`, where `u
//! = 1 − x` is its way from the edge. It sticks until `|t| = g(x) = √(1 − x²)`, and then slides:
//!
//! ```text
//! dt/du = s − λ t,   |t| = g
//! ```
//!
//! **Steps.** The strip is cut at `x = cos(j π/5)`. In adhesion a step is exact: `t` is a parabola.
//! Where it ends beyond the bound, the place where sliding begins is found inside of it, from `D =
//! |t|²/u − (2 − u)`, which is a straight line in `u` in pure creepage from the leading edge. A
//! place that is wrong by `δ` changes the force by `δ²`, so that forces and their derivatives do
//! not ripple as it passes from step to step. From there on the direction follows from one implicit
//! step of second order:
//!
//! ```text
//! z = |t + s l|/g − 1,   t' ∥ t + s(l (3 + z)/(6 + z)) l (1 + z/2)
//! ```
//!
//! For `z → 0` this is adhesion, for `z → ∞` the direction of the rigid slip at the end of the
//! step. The traction is added up in `u` in adhesion and, where it slides, in the angle `α` of `x =
//! cos α`, in which the bound is smooth, both by Simpson's rule. A bristle sticks again where the
//! tractions on its way keep the bound by themselves.
//!
//! **Derivatives** follow by hand from the way in adhesion and from the tractions at the places of
//! the step ([`composed`](Arithmetic::composed)): only these pass from formula to formula with all
//! their derivatives.

use crate::contact::totals::StripForces;
use crate::number::{Arithmetic, Float, length};

/// Steps along a strip.
const STRIP_STEPS: usize = 5;
/// `x = cos α`, `u = 1 − x` and `g = sin α` at the ends of the steps, `α = j π/5`.
const X: [f64; STRIP_STEPS + 1] = [1.0, COS_36, COS_72, -COS_72, -COS_36, -1.0];
const BOUND: [f64; STRIP_STEPS + 1] = [0.0, SIN_36, SIN_72, SIN_72, SIN_36, 0.0];
const COS_36: f64 = 0.809_016_994_374_947_5;
const COS_72: f64 = 0.309_016_994_374_947_45;
const SIN_36: f64 = 0.587_785_252_292_473_1;
const SIN_72: f64 = 0.951_056_516_295_153_5;
/// `arcsin s = s + s³/6 + 3 s⁵/40 + A s⁷`, exact at 18 degrees.
const ARCSIN: f64 = 0.047_764_448_950_518_4;
/// How much before the bound, as `D`, the formulas of sliding begin.
const EARLY: f64 = 0.02;
/// Least bound, near the trailing edge.
const LEAST_TRACTION_BOUND: f64 = 1e-6;
/// Added to numbers that are divided by, and the square of the least bound on the way.
const DIVISOR_FLOOR: f64 = 1e-20;

/// A step, in numbers without derivatives: `u` and `x` where it begins, `x` of its end, its length,
/// and of its end `1/u`, `2 − u`, `g`, `g` again that is not zero, and its reciprocal.
pub(crate) const STEP_ROWS: [[f64; 9]; STRIP_STEPS] = {
    let mut rows = [[0.0; 9]; STRIP_STEPS];
    let mut j = 0;
    while j < STRIP_STEPS {
        let (x, end, bound) = (X[j], X[j + 1], BOUND[j + 1]);
        let least = if bound > LEAST_TRACTION_BOUND { bound } else { LEAST_TRACTION_BOUND };
        let (u, end_u) = (1.0 - x, 1.0 - end);
        rows[j] = [u, x, end, x - end, 1.0 / end_u, 1.0 + end, bound, least, 1.0 / least];
        j += 1;
    }
    rows
};

/// Rigid slip over flexibility along a strip, `(s_x, s_y + q x)`, in units of the bound per half
/// length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rates<T> {
    pub x: T,
    pub y: T,
    pub spin: T,
}

/// One bristle: its traction divided by the largest bound, its slip in units of the [`Rates`], and
/// whether it slides.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BristleState<F> {
    pub traction: [F; 2],
    pub slip: [F; 2],
    pub slides: bool,
}

/// A place on the way that follows from that where sliding begins.
#[derive(Clone, Copy)]
struct SlidingPoint<B> {
    x: B,
    /// `g`, its reciprocal, and `dg/dw` over it, where `w` is the way in adhesion.
    bound: B,
    per_bound: B,
    widens: B,
    /// `dx/dw`
    moves: B,
}

impl<T: Arithmetic> Rates<T> {
    /// Forces of the strip, from the [`STEP_ROWS`].
    #[inline(always)]
    pub fn forces_of_strip(&self, rows: impl Iterator<Item = [T::Value; 9]>) -> StripForces<T> {
        let zero = T::zero();
        let mut carried = StripForces { fx: zero, fy: zero, mx: zero, stick: zero };
        let mut t = [zero; 2];
        // D at the beginning of the step, zero where it slides
        let mut inside = T::constant(-2.0);
        for row in rows {
            (t, inside) = self.advance(row, t, inside, &mut carried);
        }
        // ∫ g du = π/2
        let unit = 2.0 / core::f64::consts::PI;
        let StripForces { fx, fy, mx, stick } = carried;
        let [fx, fy, mx] = [fx, fy, mx].map(|sum| sum.times(unit));
        StripForces { fx, fy, mx, stick: stick.times(0.5) }
    }

    /// The traction and `D` at the end of a step.
    #[inline(always)]
    fn advance(
        &self, [u, x, end, l, per_u, over, bound, least, per_least]: [T::Value; 9], t: [T; 2],
        inside: T, carried: &mut StripForces<T>,
    ) -> ([T; 2], T) {
        let (zero, one) = (T::Value::constant(0.0), T::Value::constant(1.0));
        let [sx, sy, q] = [self.x, self.y, self.spin].map(T::value);
        let [tx, ty] = t.map(T::value);
        // to the end in adhesion, and D there
        let a = self.stuck(t, x, end, zero, inside);
        let [ax, ay] = a.map(T::value);
        let a2 = ax.squared() + ay.squared();
        let twice = per_u + per_u;
        let outside = T::composed(a2 * per_u - over, [ax * twice, ay * twice], a);
        // the way in adhesion, nearly to where D = 0
        let (d, e) = (inside.value(), outside.value());
        let per = one / (d - e.max(zero)).plus(-EARLY);
        let share = d * per;
        let by = l * per;
        let by_outside = e.choose(by * share, zero);
        let way = T::composed(l * share, [by * (one - share), by_outside], [inside, outside]);
        let w = way.value();
        let onset = SlidingPoint::onset(u + w, x - w);
        let p = self.stuck(t, x, onset.x, onset.moves, way);
        let [px, py] = p.map(T::value);
        // the middle of the rest in α, and the sine and cosine of half its angle
        let (cosine, sine) = (onset.x + end, onset.bound + bound);
        let per = one / (cosine.squared() + sine.squared()).sqrt();
        let (cosine, sine) = (cosine * per, sine * per);
        let rate = onset.per_bound.times(0.5);
        let middle = SlidingPoint::new(cosine, sine, cosine * rate, -(sine * rate));
        let half = onset.x * sine - onset.bound * cosine;
        let half2 = half.squared();
        let series = half2.times(ARCSIN).plus(3.0 / 40.0);
        let angle = half * (half2 * (half2 * series).plus(1.0 / 6.0)).plus(1.0);
        let slope = half2.times(7.0 * ARCSIN).plus(3.0 / 8.0) * half2;
        let turns =
            -(rate * (onset.x * cosine + onset.bound * sine)) * (half2 * slope.plus(0.5)).plus(1.0);
        let m = {
            let a = self.stuck(t, x, middle.x, middle.moves, way);
            self.sliding_traction(p, a, &onset, &middle, way)
        };
        let [mx, my] = m.map(T::value);
        let at_end =
            SlidingPoint { x: end, bound: least, per_bound: per_least, widens: zero, moves: zero };
        let next = self.sliding_traction(p, a, &onset, &at_end, way);
        let [nx, ny] = next.map(T::value);
        // ∫ t du over the way in adhesion, exactly
        let w2 = w.squared().times(0.5);
        let w3 = w * w2;
        let of_q = x * w2 - w3.times(1.0 / 3.0);
        let arm = x * w - w2;
        let arm_s = x * w2 - w3.times(2.0 / 3.0);
        let arm_q = x * (x * w2 - w3) + w * w3.times(0.25);
        // ∫ t sin α dα over the rest, by Simpson's rule with 2/6 of half the angle
        let third = angle.times(1.0 / 3.0);
        let [at_p, at_m, at_n] =
            [onset.bound * third, (middle.bound * third).times(4.0), bound * third];
        let turns = turns.times(1.0 / 3.0);
        let by_p = onset.bound * turns + onset.x * onset.per_bound * third;
        let by_m = (middle.bound * (turns + middle.widens * third)).times(4.0);
        let by_n = bound * turns;
        let value = tx * w + sx * w2 + (at_p * px + at_m * mx + at_n * nx);
        let moves = px + (by_p * px + by_m * mx + by_n * nx);
        carried.fx += T::composed(
            value,
            [w, w2, at_p, at_m, at_n, moves],
            [t[0], self.x, p[0], m[0], next[0], way],
        );
        let value = ty * w + sy * w2 + q * of_q + (at_p * py + at_m * my + at_n * ny);
        let moves = py + (by_p * py + by_m * my + by_n * ny);
        carried.fy += T::composed(
            value,
            [w, w2, of_q, at_p, at_m, at_n, moves],
            [t[1], self.y, self.spin, p[1], m[1], next[1], way],
        );
        let (arm_p, arm_m, arm_n) = (at_p * onset.x, at_m * middle.x, at_n * end);
        let value = ty * arm + sy * arm_s + q * arm_q + (arm_p * py + arm_m * my + arm_n * ny);
        let moves = (onset.x * (py + by_p * py) - at_p * py)
            + ((by_m * middle.x + at_m * middle.moves) * my + by_n * end * ny);
        carried.mx += T::composed(
            value,
            [arm, arm_s, arm_q, arm_p, arm_m, arm_n, moves],
            [t[1], self.y, self.spin, p[1], m[1], next[1], way],
        );
        carried.stick += T::from_base(w);
        (next, outside.min(T::zero()))
    }

    /// The traction in adhesion at `end`, from `t` at `x`: `t + (s_x, s_y + q (x + end)/2) (x −
    /// end)`. The end moves with a way.
    #[inline(always)]
    fn stuck(&self, t: [T; 2], x: T::Value, end: T::Value, moves: T::Value, way: T) -> [T; 2] {
        let one = T::Value::constant(1.0);
        let [sx, sy, q] = [self.x, self.y, self.spin].map(T::value);
        let [tx, ty] = t.map(T::value);
        let l = x - end;
        let arm = ((x + end) * l).times(0.5);
        let speed_y = sy + q * end;
        [
            T::composed(tx + sx * l, [one, l, -(sx * moves)], [t[0], self.x, way]),
            T::composed(
                ty + sy * l + q * arm,
                [one, l, arm, -(speed_y * moves)],
                [t[1], self.y, self.spin, way],
            ),
        ]
    }

    /// The traction at a place, from `p` where sliding begins, and that in adhesion there.
    #[inline(always)]
    fn sliding_traction(
        &self, p: [T; 2], a: [T; 2], onset: &SlidingPoint<T::Value>, end: &SlidingPoint<T::Value>,
        way: T,
    ) -> [T; 2] {
        let (zero, one) = (T::Value::constant(0.0), T::Value::constant(1.0));
        let [sx, sy, q] = [self.x, self.y, self.spin].map(T::value);
        let ([px, py], [ax, ay]) = (p.map(T::value), a.map(T::value));
        // ρ = 1 + z, at least one
        let size = (ax.squared() + ay.squared()).sqrt();
        let ratio = size * end.per_bound;
        let slips = ratio - one;
        let per = slips.choose(end.per_bound / (size.plus(DIVISOR_FLOOR)), zero);
        let rho = T::composed(
            ratio.max(one),
            [ax * per, ay * per, slips.choose(-(ratio * end.widens), zero)],
            [a[0], a[1], way],
        );
        let r = rho.value();
        // l (3 + z)/(6 + z),  l (1 + z/2)
        let (l, shrinks) = (onset.x - end.x, onset.moves - end.moves);
        let per = one / r.plus(5.0);
        let share = one - per.times(3.0);
        let (place, weight) = (onset.x - l * share, (l * r.plus(1.0)).times(0.5));
        let speed_y = sy + q * place;
        let (by_rho, by_way) = (l.times(0.5), (r.plus(1.0) * shrinks).times(0.5));
        let place_by_rho = -(l * per.squared().times(3.0));
        let place_by_way = onset.moves - shrinks * share;
        let turn = q * weight;
        let e = [
            T::composed(
                px + sx * weight,
                [one, weight, sx * by_rho, sx * by_way],
                [p[0], self.x, rho, way],
            ),
            T::composed(
                py + speed_y * weight,
                [
                    one,
                    weight,
                    place * weight,
                    speed_y * by_rho + turn * place_by_rho,
                    speed_y * by_way + turn * place_by_way,
                ],
                [p[1], self.y, self.spin, rho, way],
            ),
        ];
        Self::within_bound(e, end, way)
    }

    /// A traction, or the part of it that is on the bound.
    #[inline(always)]
    fn within_bound(e: [T; 2], end: &SlidingPoint<T::Value>, way: T) -> [T; 2] {
        let (zero, one) = (T::Value::constant(0.0), T::Value::constant(1.0));
        let [ex, ey] = e.map(T::value);
        let e2 = ex.squared() + ey.squared();
        let kept = end.bound / (e2.sqrt().plus(DIVISOR_FLOOR));
        let slides = one - kept;
        let kept = kept.min(one);
        let per = slides.choose(kept / e2.plus(DIVISOR_FLOOR), zero);
        let widens = slides.choose(end.widens, zero);
        let (x, y) = (ex * kept, ey * kept);
        let mixed = -(ex * ey * per);
        [
            T::composed(x, [kept - ex * ex * per, mixed, x * widens], [e[0], e[1], way]),
            T::composed(y, [mixed, kept - ey * ey * per, y * widens], [e[0], e[1], way]),
        ]
    }
}

impl<F: Float> Rates<F> {
    /// Their size at `x`.
    pub fn size_at(&self, x: F) -> F {
        length(self.x, self.y + self.spin * x)
    }

    /// The traction at `x`, from the [`STEP_ROWS`], and whether the bristle sticks there.
    pub fn traction(&self, rows: impl Iterator<Item = [F; 9]>, x: F) -> ([F; 2], bool) {
        let (zero, one) = (F::zero(), F::one());
        let mut carried = StripForces { fx: zero, fy: zero, mx: zero, stick: zero };
        let (mut t, mut inside) = ([zero; 2], F::of(-2.0));
        for [u, from, end, ..] in rows {
            let end = end.max(x);
            let (way, over) = ((one - end).max(F::of(DIVISOR_FLOOR)), one + end);
            let bound = (way * over).max(zero).sqrt();
            let least = bound.max(F::of(LEAST_TRACTION_BOUND));
            let row = [u, from, end, from - end, one / way, over, bound, least, one / least];
            (t, inside) = self.advance(row, t, inside, &mut carried);
            if end <= x {
                break;
            }
        }
        (t, inside < zero)
    }
}

impl<B: Arithmetic<Value = B>> SlidingPoint<B> {
    #[inline]
    fn new(x: B, bound: B, grows: B, moves: B) -> Self {
        let bound = bound.max(B::constant(LEAST_TRACTION_BOUND));
        let per_bound = B::constant(1.0) / bound;
        Self { x, bound, per_bound, widens: grows * per_bound, moves }
    }

    /// Where sliding begins, a way `w` behind a fixed place: `g = √(u (2 − u))`.
    #[inline]
    fn onset(u: B, x: B) -> Self {
        let square = (u * (B::constant(2.0) - u)).max(B::constant(DIVISOR_FLOOR));
        let bound = square.sqrt();
        let per_bound = B::constant(1.0) / bound;
        Self { x, bound, per_bound, widens: x * per_bound.squared(), moves: B::constant(-1.0) }
    }
}
