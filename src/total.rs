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
    let [inverse, slender] = divide(
        [root, root.plus(-1.0)],
        [g, root.plus(1.0)],
    );
    let both = g + inverse * inverse;

    // forces of the linear theory
    let lx = vx.scale(c11);
    let ly = vy.scale(c22);
    let ls = phi.scale(c23);
    let lx2 = lx * lx;
    let u2 = lx2 + ly * ly;
    let s2 = ls * ls;
    let p2 = phi * phi;
    // spin against the size of the patch: slip at the ends of the axes, and moment over the sliding moment
    let tx = phi.scale(c11 * (inverse + root.times(0.27)).times(1.0 / 1.5));
    let ty = phi.scale(c22 * (root + inverse.times(0.27)).times(1.0 / 1.5));
    let tm = phi.scale(c33);
    let tm2 = tm * tm.scale(T::Base::of(1.0) / both.plus(0.467).times(0.1406));
    let [rx, ry, rm, ru] = [tx * tx, ty * ty, tm2 + u2, u2.times(4.0)].map(|x| x.plus(1.0).sqrt());
    let n2 = u2 + s2 + tm2;
    let px = vx * vx;
    let py = vy * vy;
    let p2g = p2.scale(g);
    let p2i = p2.scale(inverse * inverse);
    let lys = ly + ls;
    let spin_slip = p2.scale(both);
    let [dx, dy, dm, du, f_s, f_u, d_s, f_s4, f_ys, f_n, f_px, f_py, kappa, w] = divide(
        [one, one, one, one, one, one, one, one, lys * ls, lx2, one, one, spin_slip, n2],
        [
            rx,
            ry,
            rm,
            ru,
            s2.plus(1.0),
            u2.times(0.5).plus(1.0),
            (s2 + u2.times(0.3)).plus(1.0),
            (s2 * s2).plus(1.0),
            (lys * lys + s2).plus(1.0),
            (u2 + s2).plus(0.02),
            (px + p2i).plus(0.002),
            (py + p2g).plus(0.002),
            (px + py + spin_slip).plus(1e-12),
            n2.plus(0.05),
        ],
    );
    let ex = lx * dx;
    let ex2 = ex * ex;
    let ey = ly * dy;
    let e2 = ex2 + ey * ey;
    let [d_e, f_e, f_es] = divide(
        [one, one, ey * ls],
        [(e2 * e2).times(0.1).plus(1.0), e2.plus(1.0), (e2 + s2).plus(1.0)],
    );

    let o = network([
        T::from_base(slender),
        T::from_base(poisson_ratio.times(4.0).plus(-1.0)),
        signed(dx),
        signed(dy),
        signed(f_s),
        signed(dm),
        signed(du),
        signed(f_u),
        signed(f_n),
        twice(vy * phi.scale(root) * f_py),
        signed(kappa),
        signed(px * f_px),
        signed(f_e),
        signed(f_s4),
        twice(f_ys),
        signed(ex2 * f_e),
        twice(f_es),
        signed(p2g * f_py),
    ])
    .map(|o| o * w);
    let [k1, k2, k3, k4, _, k6, ..] = o.map(|o| o + (o * o).plus(1.0).sqrt());
    let [_, _, _, _, rho, ..] = o;
    let rho = rho / (rho * rho).plus(1.0).sqrt() * d_e;

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
fn network<T: Real>(features: [T; FEATURES]) -> [T; WIDTH_OUT] {
    let hidden: [T; WIDTH_1] = activation(layer(&features, &HIDDEN_1));
    let hidden: [T; WIDTH_2] = activation(layer(&hidden, &HIDDEN_2));
    layer(&hidden, &OUTPUT)
}

/// `bias + Σ xᵢ rowᵢ`: the first row of `weights` is the bias.
#[inline(always)]
fn layer<T: Real, const N: usize>(inputs: &[T], weights: &[[f32; N]]) -> [T; N] {
    let mut sums = [T::zero(); N];
    if let Some((bias, rows)) = weights.split_first() {
        sums = bias.map(|b| T::from_base(T::Base::of_f32(b)));
        for (input, row) in inputs.iter().zip(rows) {
            for (sum, weight) in sums.iter_mut().zip(row) {
                *sum += input.scale(T::Base::of_f32(*weight));
            }
        }
    }
    sums
}

/// `x/√(1 + x²)`.
#[inline(always)]
fn activation<T: Real, const N: usize>(x: [T; N]) -> [T; N] {
    x.map(|x| x / (x * x).plus(1.0).sqrt())
}

/// `S(|q|)/|q|` from `|q|²`, with `S = 1 − ((2 + d²) √(1 − d²) − 3 d acos d)/2`, `d = 4|q|/(3π)`, and 1 for
/// `d ≥ 1` (8.15).
#[inline(always)]
fn saturation<T: Real>(q2: T) -> T {
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
