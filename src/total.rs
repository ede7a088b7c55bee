//! Total forces of a contact, without strips: the recommended model when only `Fx, Fy, Mz` are wanted.
//!
//! An equivalent creep force `q` is put through the saturation curve of strip theory, which is
//! exact for pure creepage in slender contacts (8.15): `F = h S(|q|) q/|q|`. For vanishing
//! creepage `q` is the force of the linear theory. What lies in between, above all the
//! interplay of spin and creepage, is corrected by factors that a small network computes from a
//! few squashed dimensionless numbers; its constants are fitted to about 16 000 cases computed
//! with CONTACT by `fit/fit_total.py`.
//!
//! What holds by construction, whatever the constants:
//! * `|F| ≤ μ N`, `Mz` bounded.
//! * Linear theory for small creepage: every correction carries the weight
//!   `w = n²/(0.05 + n²)`, `n` the size of the linear force.
//! * Saturation: `|F| → μ N` along the rigid slip when translation dominates, and `Mz → 0`.
//! * Symmetry: the network sees only combinations that do not change when the sign of `vx`
//!   changes, or the signs of `vy` and spin together.
//! * Dissipation: `fx vx + fy vy + mz φ ≥ 0`. The spin part of `fy` returns in `mz` with the opposite
//!   sign (as `C23` does in the linear theory), what remains is a positive quadratic form.
//! * Once continuously differentiable in creepage and spin, everywhere.
//!
//! Nothing but `+ − × ÷ √`: activations are `x/√(1 + x²)`, positive factors `o + √(1 + o²)`.

mod constants;

use self::constants::{HIDDEN_1, HIDDEN_2, OUTPUT};
use crate::coefficients::LinearCoefficients;
use crate::real::{Float, Real};
use core::any::Any;

/// Forces of a whole contact, dimensionless, on the lower body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TotalForce<T> {
    /// `Fx/(μ N)`
    pub fx: T,
    /// `Fy/(μ N)`
    pub fy: T,
    /// `Mz/(μ N √(a b))`, about the centre of the contact.
    pub mz: T,
}

/// Axis ratios the network is evaluated with; fitted are 0.1 to 10.
const RATIO_LIMIT: f64 = 1e3;
/// Creepages beyond this, or beyond what the floating-point type allows, are scaled down together:
/// sliding, to rounding.
const CREEPAGE_LIMIT: f64 = 1e16;

/// What the network is told, in the order of the rows of [`HIDDEN_1`].
const FEATURES: usize = 18;
const WIDTH_1: usize = 20;
const WIDTH_2: usize = 16;
/// Six corrections and two columns of padding.
const WIDTH_OUT: usize = 8;

/// `K(t)` in `S(d)/d = 1 + t² + t⁴ + t⁵ K(t)`, `t = √(1 − d)`: least squares on Chebyshev points, error
/// 1.5e-10. Without a seam and without cancellation for small `d`.
const SATURATION: [f64; 9] = [
    -1.1312896073646717,
    0.9984629408539217,
    -0.9974467549758047,
    0.938856527893881,
    -0.8090303732439167,
    0.5740919662018433,
    -0.3033984351630218,
    0.10264497435340292,
    -0.016696748304402126,
];

/// Total force for creepages `vx, vy = G a b (υx, υy)/(μ N)` and spin `φ = G (a b)^{3/2} ϕ/(μ N)`.
///
/// `axis_ratio` is `a/b`, `linear` the coefficients for it. Fitted for `a/b` 0.1 to 10, `ν` 0 to 1/2 and
/// `|ψ| = (π/3) √(a/b) |φ| ≤ 3`; beyond that finite, bounded and with the right limits, but not accurate.
#[must_use]
pub fn total<T: Real>(
    axis_ratio: T::Base,
    poisson_ratio: T::Base,
    linear: &LinearCoefficients<T::Base>,
    creepage: [T; 3],
) -> TotalForce<T> {
    let one = T::one();
    let [vx, vy, phi] = within_range(creepage);
    let g = axis_ratio.clamped(T::Base::of(1.0 / RATIO_LIMIT), T::Base::of(RATIO_LIMIT));
    let LinearCoefficients { c11, c22, c23, c33 } = *linear;
    let root = g.sqrt();
    let [inverse, slender] = divide([root, root.plus(-1.0)], [g, root.plus(1.0)]);
    let inverse2 = inverse * inverse;
    let both = g + inverse2;

    // the force of the linear theory, lateral force with and without spin
    let lx = vx.scale(c11);
    let ly = vy.scale(c22);
    let ls = phi.scale(c23);
    let lys = ly + ls;
    let lx2 = lx * lx;
    let ly2 = ly * ly;
    let u2 = lx2 + ly2;
    let s2 = ls * ls;
    // spin against the size of the patch: slip at the ends of the axes, moment over its sliding limit
    let tx = phi.scale(c11 * (inverse + root.times(0.27)).times(1.0 / 1.5));
    let ty = phi.scale(c22 * (root + inverse.times(0.27)).times(1.0 / 1.5));
    let tm = phi.scale(c33);
    let tm2 = (tm * tm).scale(T::Base::of(1.0) / both.plus(0.467).times(0.1406));
    let n2 = u2 + s2 + tm2;
    // the same in terms of rigid slip: creepage against spin at the ends of the axes
    let vx2 = vx * vx;
    let vy2 = vy * vy;
    let phi2 = phi * phi;
    let px2 = phi2.scale(inverse2);
    let py2 = phi2.scale(g);
    let p2 = phi2.scale(both);
    let [f_s, f_s4, f_u, f_4u, kappa, f_n, f_px, f_py, f_ys, d_s, w, ix, iy, im] = divide(
        [one, one, one, one, p2, lx2, vx2, one, lys * ls, one, n2, one, one, one],
        [
            s2.plus(1.0),
            (s2 * s2).plus(1.0),
            u2.times(0.5).plus(1.0),
            u2.times(4.0).plus(1.0),
            (vx2 + vy2 + p2).plus(1e-12),
            (u2 + s2).plus(0.02),
            (vx2 + px2).plus(0.002),
            (vy2 + py2).plus(0.002),
            (lys * lys + s2).plus(1.0),
            (s2 + u2.times(0.3)).plus(1.0),
            n2.plus(0.05),
            (tx * tx).plus(1.0),
            (ty * ty).plus(1.0),
            (tm2 + u2).plus(1.0),
        ],
    );
    // how spin brakes the two slopes and the spin moment
    let [dx, dy, dm, _] = [ix, iy, im, im].map(T::sqrt);
    // size of the creep force so braked
    let ex2 = lx2 * ix;
    let e2 = ex2 + ly2 * iy;
    let [d_e, f_e, f_es, _] = divide(
        [one, one, ly * dy * ls, one],
        [(e2 * e2).times(0.1).plus(1.0), e2.plus(1.0), (e2 + s2).plus(1.0), one],
    );

    let o = network([
        T::from_base(slender),
        T::from_base(poisson_ratio.times(4.0).plus(-1.0)),
        signed(f_s),
        signed(f_s4),
        signed(f_u),
        signed(f_4u),
        signed(kappa),
        signed(f_n),
        signed(f_px),
        signed(py2 * f_py),
        twice(vy * phi.scale(root) * f_py),
        twice(f_ys),
        signed(dx),
        signed(dy),
        signed(dm),
        signed(f_e),
        signed(ex2 * f_e),
        twice(f_es),
    ])
    .map(|o| o * w);
    let [k1, k2, k3, k4, _, k6, ..] = o.map(|o| (o * o.times(1.01).plus(2.0)).plus(1.0));
    let [_, _, _, _, rho, ..] = o;
    let rho = twice(rho) / (rho * rho).plus(1.0) * d_e;

    // q: linear theory with spin braking its slopes; the direction turns to that of the rigid slip
    // as sliding spreads
    let by = dy.scale(c22);
    let bx = by * (T::one() - d_e) + (dx * k1 * d_e).scale(c11);
    let spin = (k3 * d_s).scale(c23);
    let qx = k2 * bx * vx;
    let qy = k2 * by * vy + spin * phi;
    // h: spin keeps |F| below μ N in full sliding
    let h = (kappa * w * k6).times(0.3).plus(1.0);
    let sigma = saturation(qx * qx + qy * qy) / h;
    // mz = ε φ − (σ q)-coupling vy + 2 ρ √(β ε) vy, |ρ| < 1: with fy = β vy + γ φ the dissipation
    // β vy² + 2 ρ √(β ε) vy φ + ε φ² is never negative
    let epsilon = (k4 * dm).scale(c33);
    let beta = sigma * k2 * by;
    let coupling = twice(rho * (beta * epsilon).sqrt()) - sigma * spin;
    TotalForce { fx: sigma * qx, fy: sigma * qy, mz: epsilon * phi + coupling * vy }
}

/// The six corrections, and two zeros.
#[inline(always)]
pub fn network<T: Real>(features: [T; FEATURES]) -> [T; WIDTH_OUT] {
    let hidden: [T; WIDTH_1] = activation(layer(&features, table(&HIDDEN_1, &WIDE_1)));
    let hidden: [T; WIDTH_2] = activation(layer(&hidden, table(&HIDDEN_2, &WIDE_2)));
    layer(&hidden, table(&OUTPUT, &WIDE_OUTPUT))
}

/// The constants in double precision: converted once by the compiler, not in every call.
static WIDE_1: [[f64; WIDTH_1]; FEATURES + 1] = widen(&HIDDEN_1);
static WIDE_2: [[f64; WIDTH_2]; WIDTH_1 + 1] = widen(&HIDDEN_2);
static WIDE_OUTPUT: [[f64; WIDTH_OUT]; WIDTH_2 + 1] = widen(&OUTPUT);

#[allow(clippy::indexing_slicing)]
const fn widen<const N: usize, const M: usize>(narrow: &[[f32; N]; M]) -> [[f64; N]; M] {
    let mut wide = [[0.0; N]; M];
    let mut i = 0;
    while i < M {
        let mut j = 0;
        while j < N {
            wide[i][j] = narrow[i][j] as f64;
            j += 1;
        }
        i += 1;
    }
    wide
}

/// The table in the precision asked for; the other one is not even linked.
#[inline(always)]
fn table<F: Float, const N: usize, const M: usize>(
    narrow: &'static [[f32; N]; M],
    wide: &'static [[f64; N]; M],
) -> &'static [[F; N]] {
    if let Some(table) = (narrow as &dyn Any).downcast_ref::<[[F; N]; M]>() {
        table
    } else if let Some(table) = (wide as &dyn Any).downcast_ref::<[[F; N]; M]>() {
        table
    } else {
        &[]
    }
}

/// `bias + Σ xᵢ rowᵢ`: the first row of `weights` is the bias.
#[inline(always)]
fn layer<T: Real, const N: usize>(inputs: &[T], weights: &[[T::Base; N]]) -> [T; N] {
    let mut sums = [T::zero(); N];
    if let Some((bias, rows)) = weights.split_first() {
        sums = bias.map(T::from_base);
        for (input, row) in inputs.iter().zip(rows) {
            for (sum, weight) in sums.iter_mut().zip(row) {
                *sum += input.scale(*weight);
            }
        }
    }
    sums
}

/// `2x/(1 + x²)`, with one division for two units.
#[inline(always)]
fn activation<T: Real, const N: usize>(x: [T; N]) -> [T; N] {
    let p = x.map(|x| (x * x).plus(1.0));
    let mut y = x.map(twice);
    let (low, high) = y.split_at_mut(N / 2);
    let (p, q) = p.split_at(N / 2);
    for (((low, high), p), q) in low.iter_mut().zip(high).zip(p).zip(q) {
        let r = T::one() / (*p * *q);
        *low = *low * (*q * r);
        *high = *high * (*p * r);
    }
    y
}

/// `S(|q|)/|q|` from `|q|²`, with `S = 1 − ((2 + d²) √(1 − d²) − 3 d acos d)/2`, `d = 4|q|/(3π)`, and 1 for
/// `d ≥ 1` (8.15).
#[inline(always)]
pub fn saturation<T: Real>(q2: T) -> T {
    const SLOPE: f64 = 4.0 / (3.0 * core::f64::consts::PI);
    // the small terms keep the derivatives of the roots finite at 0
    let d = q2.plus(1e-30).sqrt().times(SLOPE);
    let t2 = (T::one() - d).max(T::constant(1e-30));
    let t = t2.sqrt();
    let [k0, k1, k2, k3, k4, k5, k6, k7, k8] = SATURATION.map(T::Base::of);
    let t4 = t2 * t2;
    let low = (t.scale(k1).shift(k0)) + t2 * t.scale(k3).shift(k2);
    let high = (t.scale(k5).shift(k4)) + t2 * t.scale(k7).shift(k6);
    let k = low + t4 * (high + t4.scale(k8));
    // S(d)/d = 1 + t² + t⁴ + t⁵ K(t)
    let s_over_d = (t2 + t4 * (t * k).plus(1.0)).plus(1.0);
    s_over_d.times(SLOPE) / d.max(T::one())
}

/// The creepages, scaled down together where their squares would overflow.
#[inline(always)]
fn within_range<T: Real>([vx, vy, phi]: [T; 3]) -> [T; 3] {
    // 1e8, in single precision 1e6
    let limit = T::Base::HUGE.min(T::Base::of(CREEPAGE_LIMIT)).sqrt();
    let size = vx.value().abs().max(vy.value().abs()).max(phi.value().abs());
    if size > limit {
        let factor = limit / size;
        [vx.scale(factor), vy.scale(factor), phi.scale(factor)]
    } else {
        [vx, vy, phi]
    }
}

/// Element by element.
#[inline(always)]
fn divide<T: Real, const N: usize>(numerators: [T; N], denominators: [T; N]) -> [T; N] {
    let mut quotients = numerators;
    for (quotient, denominator) in quotients.iter_mut().zip(denominators) {
        *quotient = *quotient / denominator;
    }
    quotients
}

#[inline(always)]
fn twice<T: Real>(x: T) -> T {
    x + x
}

/// From 0 … 1 to −1 … 1.
#[inline(always)]
fn signed<T: Real>(x: T) -> T {
    twice(x).plus(-1.0)
}
