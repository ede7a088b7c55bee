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
use crate::number::{
    Arithmetic, Nodes, Number, Pair, Stored, atan_of_unit, either, ln_of_quotient,
};
use crate::strip_1967::Motion;
use crate::strip_1967::edge::{self, Arc, Edge};
use crate::strip_1967::strip::SlidingRule;
use core::f64::consts::PI;

/// Four nodes of Gauss on `[-1, 1]` and their weights, those that are positive.
static GAUSS_4: Nodes<2> = Nodes::new([
    [0.33998104358485626, 0.6521451548625461],
    [0.8611363115940526, 0.34785484513745385],
]);
/// Six nodes: `∫ C K dY`, on either side of the strip with `ξ̄ = 0`.
static GAUSS_6: Nodes<6> = Nodes::new([
    [-0.932469514203152, 0.17132449237917036],
    [-0.6612093864662645, 0.3607615730481386],
    [-0.2386191860831969, 0.46791393457269104],
    [0.2386191860831969, 0.46791393457269104],
    [0.6612093864662645, 0.3607615730481386],
    [0.932469514203152, 0.17132449237917036],
]);
/// Sixteen nodes, those that are positive: the continuous rule.
static GAUSS_16: Nodes<8> = Nodes::new([
    [0.09501250983763744, 0.1894506104550685],
    [0.2816035507792589, 0.18260341504492358],
    [0.45801677765722737, 0.16915651939500254],
    [0.6178762444026438, 0.14959598881657674],
    [0.755404408355003, 0.12462897125553388],
    [0.8656312023878318, 0.09515851168249279],
    [0.9445750230732326, 0.062253523938647894],
    [0.9894009349916499, 0.027152459411754096],
]);

/// How many half lengths of a piece its square root's zero is away where four nodes give all digits.
#[inline(always)]
fn far<T: Number>() -> f64 {
    if size_of::<Stored<T>>() == 4 { 3.5 } else { 16.0 }
}

/// Root of the distance of numbers near one.
#[inline(always)]
fn root_epsilon<T: Number>() -> f64 {
    if size_of::<Stored<T>>() == 4 { 3.5e-4 } else { 1.5e-8 }
}

/// Integrals over strips.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shares<T> {
    /// `∫ f_x dY`
    pub(super) fx: T,
    /// `∫ f_y dY`
    pub(super) fy: T,
    /// `∫ m_x dY`
    pub(super) mx: T,
    /// `∫ Y f_x dY`
    pub(super) lever: T,
    /// `∫ (C − K) dY`
    pub(super) stick: T,
}

impl<T: Number> Shares<T> {
    /// These, and others with them where a number is positive.
    #[inline(always)]
    fn with(&self, others: &Self, by: T) -> Self {
        let mut both = *self;
        both.add(others);
        Self {
            fx: by.choose(both.fx, self.fx),
            fy: by.choose(both.fy, self.fy),
            mx: by.choose(both.mx, self.mx),
            lever: by.choose(both.lever, self.lever),
            stick: by.choose(both.stick, self.stick),
        }
    }

    /// Multiplied: forces and their lever, `m_x`, stick area.
    pub(super) fn times(&self, [force, moment, stick]: [T; 3]) -> Self {
        Self {
            fx: self.fx * force,
            fy: self.fy * force,
            mx: self.mx * moment,
            lever: self.lever * force,
            stick: self.stick * stick,
        }
    }

    /// Forces and moment in units of `μ N` and `μ N √(ab)`, turned back.
    #[inline(always)]
    pub(super) fn totals(&self, motion: &Motion<T>) -> Totals<T> {
        let Motion { axis_ratio, turned_x, turned_y, .. } = *motion;
        let root = axis_ratio.sqrt();
        let inverse = T::Base::one() / root;
        let mz = self.mx.scale(root) - self.lever.scale(inverse);
        let (fx, fy) = (self.fx.scale(turned_x.times(0.75)), self.fy.scale(turned_y.times(0.75)));
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
            stick: self.stick.times(2.0 / PI).clamped(T::zero(), T::one()),
        }
    }

    #[inline(always)]
    pub(super) fn add(&mut self, other: &Self) {
        self.fx += other.fx;
        self.fy += other.fy;
        self.mx += other.mx;
        self.lever += other.lever;
        self.stick += other.stick;
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
    let motion = Motion::new(parameters, rule);
    let (arc, some) = edge::adhesion(&motion);
    let mut shares = outside(&motion, &arc);
    if some.exceeds(T::zero()) {
        shares = shares.with(&adhering(&motion, &arc), some);
    }
    shares.totals(&motion)
}

/// All strips.
pub(super) fn whole<T: Number>(motion: &Motion<T>, arc: &Arc<T>, adheres: bool) -> Shares<T> {
    let mut shares = outside(motion, arc);
    if adheres {
        shares.add(&adhering(motion, arc));
    }
    shares
}

/// Strips that slide on both sides of an arc.
#[inline(always)]
fn outside<T: Number>(motion: &Motion<T>, arc: &Arc<T>) -> Shares<T> {
    let [first, last] = [-T::one(), T::one()].map(|y| Edge { y, c: T::zero() });
    sliding(motion, [first, arc.lower], [arc.upper, last])
}

/// Strips with adhesion: `f_x = ξ̄ (2C − K)`, `f_y = ψ C² + η (2C − K)`, `m_x = −η (C − K)²`.
#[inline(always)]
pub(super) fn adhering<T: Number>(motion: &Motion<T>, arc: &Arc<T>) -> Shares<T> {
    let Motion { xi, eta, psi, slope: p, q, eta_psi: m, .. } = *motion;
    let both = T::Pair::both;
    let (Edge { y: y1, c: c1 }, Edge { y: y2, c: c2 }) = (arc.lower, arc.upper);
    let (width, sum) = (y2 - y1, y1 + y2);
    // ∫ C dY = (asin Y + Y C)/2,  ∫ Y C dY = −C³/3,  ∫ Y² C dY = (asin Y − Y C (1 − 2Y²))/8,  ∫ C² dY = Y − Y³/3
    let angle = atan_of_unit(arc.tangent).times(4.0);
    let (yc1, yc2) = (y1 * c1, y2 * c2);
    let c = (angle + (yc2 - yc1)).times(0.5);
    let yc = (c1 * c1 * c1 - c2 * c2 * c2).times(1.0 / 3.0);
    let bent = |y: T, yc: T| yc * (T::one() - (y * y).times(2.0));
    let yyc = (angle - (bent(y2, yc2) - bent(y1, yc1))).times(0.125);
    let yy = (y1 * y1 + y1 * y2 + y2 * y2).times(1.0 / 3.0);
    let cc = width * (T::one() - yy);
    // S hardly bends where the zero of S² is far from the interval.
    let (middle, half) = (sum.times(0.5), width.times(0.5));
    let (x, bend) = (motion.xi_bar(middle), p * half);
    let smooth = eta * eta + q * (x * x - (bend * bend).times(far::<T>() * far::<T>())) + T::tiny();
    let [k, xk, yxk, kk] = either!(
        smooth,
        {
            // ∫ (K, ξ̄ K, Y ξ̄ K, K²) dY by nodes
            let mut sums = [T::Pair::zero(); 4];
            for [node, weight] in GAUSS_4.of::<T>() {
                let y = both(middle) + T::Pair::of(half, -half).scale(node);
                let x = both(xi) - both(p) * y;
                let k = length(motion, x);
                let share = k.scale(weight);
                for (sum, factor) in sums.iter_mut().zip([T::Pair::one(), x, y * x, k]) {
                    *sum += share * factor;
                }
            }
            T::each(&sums, |sum| sum.sum() * half)
        },
        {
            // S = σ D with D = √(u² + ε²)
            let (root, inverse) = (q.sqrt(), p.inverse());
            let (h, e) = (xi * inverse, eta * inverse / root);
            let (sigma, e2) = (p * root, rounded(e));
            let (u1, u2) = (h - y1, h - y2);
            let (d1, d2) = ((u1 * u1 + e2).sqrt(), (u2 * u2 + e2).sqrt());
            let (above, below) = arcsinh(u1, u2, d1, d2, e2);
            // ∫ D du = (u D + ε² asinh(u/ε))/2,  ∫ u D du = D³/3,  ∫ u² D du = (u D³ − ε² ∫ D du)/4
            let i0 = (u1 * d1 - u2 * d2 + e2 * ln_of_quotient(above, below)).times(0.5);
            let (cube1, cube2) = (d1 * d1 * d1, d2 * d2 * d2);
            let i1 = (cube1 - cube2).times(1.0 / 3.0);
            let i2 = (u1 * cube1 - u2 * cube2 - e2 * i0).times(0.25);
            // K = (S + m)/q
            let iq = q.inverse();
            let (s, xs, yxs) = (sigma * i0, p * sigma * i1, p * sigma * (h * i1 - i2));
            let (x_mean, yx) = (x * width, xi * width * middle - p * (width * yy));
            let xx = xi * xi * width - (xi * p * width * sum) + p * p * (width * yy);
            let kk = eta * eta * width + q * xx + (m * s).times(2.0) + m * m * width;
            [(s + m * width) * iq, (xs + m * x_mean) * iq, (yxs + m * yx) * iq, kk * iq * iq]
        }
    );
    let ck = stretch_and_length(motion, arc);
    Shares {
        fx: (xi * c - p * yc).times(2.0) - xk,
        fy: psi * cc + eta * (c.times(2.0) - k),
        mx: -(eta * (cc - ck.times(2.0) + kk)),
        lever: (xi * yc - p * yyc).times(2.0) - yxk,
        stick: c - k,
    }
}

/// `K`, by the form of (5.41) that does not cancel.
#[inline(always)]
fn length<T: Number>(motion: &Motion<T>, x: T::Pair) -> T::Pair {
    let both = T::Pair::both;
    let Motion { eta, q, eta_psi: m, .. } = *motion;
    let (eta2, x2) = (both(eta * eta), x * x);
    let s = (eta2 + both(q) * x2).sqrt();
    let m = both(m);
    let k = m.choose(s + m, x2 + eta2) / m.choose(both(q), s - m + T::Pair::tiny());
    // (where strips adhere K < C ≤ 1)
    k.min(T::Pair::one())
}

/// `∫ C K dY = ∫ C² K dθ`: nodes from the strip with `ξ̄ = 0`, where `S` may have a kink, to both ends of the arc.
#[inline(always)]
fn stretch_and_length<T: Number>(motion: &Motion<T>, arc: &Arc<T>) -> T {
    let Motion { xi, eta, slope: p, .. } = *motion;
    let both = T::Pair::both;
    // Y = sin(θ + φ), with the tangent of φ/2 from −t to t
    let Arc { lower, upper, middle, tangent } = *arc;
    // (with hardly any spin there is no kink, and nothing may hang on where the middle is)
    let hardly = (xi + eta.choose(eta, -eta)).times(root_epsilon::<T>());
    let h = xi / (p + hardly + T::from_base(T::ROOT_TINY));
    let turn = Edge::chosen(h - lower.y, Edge::chosen(upper.y - h, Edge::at(h), upper), lower);
    let cosine = turn.c * middle.c + turn.y * middle.y;
    let split = (turn.y * middle.c - turn.c * middle.y) / (T::one() + cosine);
    let (from, to) = (T::Pair::of(-tangent, split), T::Pair::of(split, tangent));
    let (centre, half) = ((from + to).times(0.5), (to - from).times(0.5));
    let mut sum = T::Pair::zero();
    for [node, weight] in GAUSS_6.of::<T>() {
        let t = centre + half.scale(node);
        let t2 = t * t;
        let scale = (t2.plus(1.0)).inverse();
        let (cosine, sine) = ((T::Pair::one() - t2) * scale, t.times(2.0) * scale);
        let y = both(middle.y) * cosine + both(middle.c) * sine;
        let c = both(middle.c) * cosine - both(middle.y) * sine;
        let x = both(xi) - both(p) * y;
        sum += c * c * length(motion, x) * scale.scale(weight);
    }
    // dθ = 2 dt/(1 + t²)
    (sum * half).sum().times(2.0)
}

/// `ε²`, and the square of some roundings of `Y`: where `η = 0` the direction of the slip turns at once in the strip `ξ̄ = 0`,
/// and a derivative by `η` would be infinite.
#[inline(always)]
fn rounded<T: Number>(e: T) -> T {
    let rounding = T::EPSILON.times(4.0);
    e * e + T::from_base(rounding * rounding)
}

/// `asinh(u₁/ε) − asinh(u₂/ε)` for `u₁ ≥ u₂` is the logarithm of this quotient; `d = √(u² + ε²)`.
#[inline(always)]
fn arcsinh<A: Arithmetic>(u1: A, u2: A, d1: A, d2: A, e2: A) -> (A, A) {
    let (a1, a2) = (u1.choose(u1, -u1) + d1 + A::tiny(), u2.choose(u2, -u2) + d2 + A::tiny());
    let above = u1.choose(u2.choose(a1, a1 * a2), a2);
    let below = u2.choose(a2, u1.choose(e2 + A::tiny(), a1));
    (above, below)
}

/// Strips that slide, below and above those that adhere.
#[inline(always)]
pub(super) fn sliding<T: Number>(
    motion: &Motion<T>,
    lower: [Edge<T>; 2],
    upper: [Edge<T>; 2],
) -> Shares<T> {
    let [fx, fy, lever] = match motion.rule {
        SlidingRule::RigidSlip => rigid_slip(
            motion,
            T::Pair::of(lower[0].y, upper[0].y),
            T::Pair::of(lower[1].y, upper[1].y),
        ),
        SlidingRule::Continuous => continuous(motion, lower, upper),
    };
    Shares { fx, fy, mx: T::zero(), lever, stick: T::zero() }
}

/// `∫ C² (w_x, w_y, Y w_x) dY` with `w ~ ((1 − ν) ξ̄, η)`.
#[inline(always)]
fn rigid_slip<T: Number>(motion: &Motion<T>, from: T::Pair, to: T::Pair) -> [T; 3] {
    let Motion { xi, eta, slope, compliance, .. } = *motion;
    let both = T::Pair::both;
    let (z0, p) = (xi.scale(compliance), slope.scale(compliance));
    let (middle, half) = ((from + to).times(0.5), (to - from).times(0.5));
    let z = both(z0) - both(p) * middle;
    let bend = both(p) * half;
    let smooth = both(eta * eta) + z * z - (bend * bend).times(far::<T>() * far::<T>());
    let (first, second) = smooth.parts();
    either!(
        first.min(second) + T::tiny(),
        {
            let mut sums = [T::Pair::zero(); 3];
            // (at rest no strip slides, and has no direction)
            let eta2 = both(eta * eta + T::from_base(T::EPSILON * T::EPSILON));
            for [node, weight] in GAUSS_4.of::<T>().flat_map(|[u, w]| [[-u, w], [u, w]]) {
                let y = middle + half.scale(node);
                let z = both(z0) - both(p) * y;
                let share = (T::Pair::one() - y * y) * half.scale(weight) / (z * z + eta2).sqrt();
                let fx = share * z;
                let [x, w, lever] = &mut sums;
                *x += fx;
                *w += share;
                *lever += y * fx;
            }
            let [fx, w, lever] = sums.map(T::Pair::sum);
            [fx, w * eta, lever]
        },
        {
            // in units of p: w = (u, ε)/D with D = √(u² + ε²)
            let inverse = p.inverse();
            let (h, e) = (z0 * inverse, eta * inverse);
            let e2 = rounded(e);
            let (u1, u2) = (both(h) - from, both(h) - to);
            let (d1, d2) = ((u1 * u1 + both(e2)).sqrt(), (u2 * u2 + both(e2)).sqrt());
            let (above, below) = arcsinh(u1, u2, d1, d2, both(e2));
            let ((above1, above2), (below1, below2)) = (above.parts(), below.parts());
            // J_n = ∫ uⁿ/D du
            let j0 = ln_of_quotient(above1 * above2, below1 * below2);
            let j1 = (d1 - d2).sum();
            let (ud1, ud2) = (u1 * d1, u2 * d2);
            let j2 = ((ud1 - ud2).sum() - e2 * j0).times(0.5);
            let j3 = (d1 * d1 * d1 - d2 * d2 * d2).sum().times(1.0 / 3.0) - e2 * j1;
            let j4 = ((u1 * u1 * ud1 - u2 * u2 * ud2).sum() - (e2 * j2).times(3.0)).times(0.25);
            // C² = 1 − (h − u)²
            let (k0, k1) = (T::one() - h * h, h.times(2.0));
            let moments = [(j0, j1, j2), (j1, j2, j3), (j2, j3, j4)];
            let [i0, i1, i2] = T::each(&moments, |(one, u, uu)| k0 * *one + k1 * *u - *uu);
            [i1, e * i0, h * i1 - i2]
        }
    )
}

/// `∫ C² (w_x, w_y, Y w_x) dY` with `w ~ (ξ̄, η + ψ C)`: nodes from the adhesion strips, next to which the direction turns, outwards.
#[inline(always)]
fn continuous<T: Number>(motion: &Motion<T>, lower: [Edge<T>; 2], upper: [Edge<T>; 2]) -> [T; 3] {
    let Motion { xi, eta, psi, slope: p, .. } = *motion;
    let both = T::Pair::both;
    let near =
        Edge { y: T::Pair::of(lower[1].y, upper[0].y), c: T::Pair::of(lower[1].c, upper[0].c) };
    let edge =
        Edge { y: T::Pair::of(lower[0].y, upper[1].y), c: T::Pair::of(lower[0].c, upper[1].c) };
    // tan(β/4) = sin(β/2)/(1 + cos(β/2)) of the angle β from the near to the far end
    let cosine = near.y * edge.y + near.c * edge.c;
    let [sine, cosine] = T::Pair::each(&[-cosine, cosine], |cosine| {
        cosine.plus(1.0).times(0.5).max(T::Pair::constant(1e-30)).sqrt()
    });
    let reach = sine / cosine.plus(1.0);
    // p C/|N|: how fast the direction of N = (ξ̄, η + ψ C) turns next to the near end
    let (nx, ny) = (both(xi) - both(p) * near.y, both(eta) + both(psi) * near.c);
    let turn = both(p) * near.c / (nx * nx + ny * ny + T::Pair::tiny()).sqrt();
    let grade = (reach * turn).times(4.0).plus(1.0).sqrt().min(T::Pair::constant(30.0));
    let outwards = T::Pair::of(-T::one(), T::one());
    // (at rest no strip slides, and has no direction)
    let rest = T::Pair::from_base(T::EPSILON * T::EPSILON);
    let mut sums = [T::Pair::zero(); 4];
    for [node, weight] in GAUSS_16.of::<T>() {
        for node in [-node, node] {
            // v = tan(φ/4) = V r/(r + g (1 − r)), r from 0 to 1
            let r = node.times(0.5).plus(0.5);
            let den = grade.scale(T::Base::one() - r).shift(r);
            let v = reach.scale(r);
            let (den2, v2) = (den * den, v * v);
            let scale = (den2 + v2).inverse();
            // dφ = 4 V g dr/(den² + v²)
            let step = (reach * grade * scale).scale(weight + weight);
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
    // By what the nodes miss of ∫ C² dY, so that a constant direction is exact and the force never beyond the bound
    let [fx, fy, lever, whole] = sums;
    let mean = (near.y * near.y + near.y * edge.y + edge.y * edge.y).times(1.0 / 3.0);
    let exact = (edge.y - near.y) * outwards * (T::Pair::one() - mean);
    let wide = reach.plus(-0.05);
    let scale = wide.choose(exact / (whole + T::Pair::tiny()), T::Pair::one());
    [fx * scale, fy * scale, lever * scale].map(T::Pair::sum)
}
