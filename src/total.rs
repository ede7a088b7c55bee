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
//! Nothing but `+ − × ÷ √`: activations are `2x/(1 + x²)`, positive factors `1 + 2o + 1.01 o²`.

mod constants;

use self::constants::{HIDDEN_1, HIDDEN_2, OUTPUT};
use crate::coefficients::LinearCoefficients;
use crate::real::{Arithmetic, Float, Real};
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

/// Spin force of the linear theory beyond which creepage and spin are scaled down together.
const SPIN_LIMIT: f64 = 16.0;

/// What the network is told, in the order of the rows of [`HIDDEN_1`].
const FEATURES: usize = 18;
const WIDTH_1: usize = 20;
const WIDTH_2: usize = 16;
const WIDTH_OUT: usize = 6;

/// `K(t)` in `S(d)/d = 1 + t² + t⁴ + t⁵ K(t)`, `t = √(1 − d)`: least squares on Chebyshev points, error
/// below 2e-10, exact slope at `d = 0`. Without a seam and without cancellation for small `d`.
const SATURATION: [f64; 9] = [
    -1.1312896073646717,
    0.9984629408539217,
    -0.9974467549758047,
    0.938856527893881,
    -0.8090303732439167,
    0.5740919662018433,
    -0.3033984351630218,
    0.10264497435340292,
    -0.016696748363289243,
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
    let g = axis_ratio.clamped(T::Base::of(1.0 / RATIO_LIMIT), T::Base::of(RATIO_LIMIT));
    let LinearCoefficients { c11, c22, c23, c33 } = *linear;
    let [vx, vy, phi] = within_range(creepage, c23);
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
    let [k1, k2, k3, k4, _, k6] = o.map(|o| (o * o.times(1.01).plus(2.0)).plus(1.0));
    let [_, _, _, _, rho, _] = o;
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

/// The six corrections.
#[inline(always)]
fn network<T: Real>(features: [T; FEATURES]) -> [T; WIDTH_OUT] {
    let hidden: [T; WIDTH_1] = activation(layer(&features, table(&HIDDEN_1, &WIDE_1)));
    let hidden: [T; WIDTH_2] = activation(layer(&hidden, table(&HIDDEN_2, &WIDE_2)));
    narrow_layer(&hidden, table(&OUTPUT, &WIDE_OUTPUT))
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
        accumulate(&mut sums, inputs, rows);
    }
    sums
}

/// The same for few outputs: the inputs in two halves, because one chain of additions would be waited for.
#[inline(always)]
fn narrow_layer<T: Real, const N: usize>(inputs: &[T], weights: &[[T::Base; N]]) -> [T; N] {
    let mut sums = [T::zero(); N];
    if let Some((bias, rows)) = weights.split_first() {
        sums = bias.map(T::from_base);
        let mut others = [T::zero(); N];
        for (pair, rows) in inputs.chunks_exact(2).zip(rows.chunks_exact(2)) {
            if let (&[x, y], [p, q]) = (pair, rows) {
                for ((sum, other), (p, q)) in sums.iter_mut().zip(&mut others).zip(p.iter().zip(q))
                {
                    *sum += x.scale(*p);
                    *other += y.scale(*q);
                }
            }
        }
        for (sum, other) in sums.iter_mut().zip(others) {
            *sum += other;
        }
    }
    sums
}

#[inline(always)]
fn accumulate<T: Real, const N: usize>(sums: &mut [T; N], inputs: &[T], rows: &[[T::Base; N]]) {
    for (input, row) in inputs.iter().zip(rows) {
        for (sum, weight) in sums.iter_mut().zip(row) {
            *sum += input.scale(*weight);
        }
    }
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

/// Creepages and spin that mean the same and that the network can be asked about.
///
/// Large spin slides everywhere, and then only the ratio of creepage to spin matters. So both are scaled
/// down together beyond `|Ls| = 16` (fitted is up to 13), smoothly, to `|Ls| = 32` at most.
#[inline(always)]
fn within_range<T: Real>([vx, vy, phi]: [T; 3], c23: T::Base) -> [T; 3] {
    let scaled = |factor: T| [vx * factor, vy * factor, phi * factor];
    // 1e8, in single precision 1e6
    let limit = T::Base::HUGE.min(T::Base::of(CREEPAGE_LIMIT)).sqrt();
    let size = vx.value().abs().max(vy.value().abs()).max(phi.value().abs());
    if size > limit {
        return within_spin(scaled(T::from_base(limit / size)), c23);
    }
    within_spin([vx, vy, phi], c23)
}

#[inline(always)]
fn within_spin<T: Real>([vx, vy, phi]: [T; 3], c23: T::Base) -> [T; 3] {
    let size = phi.abs().scale(c23);
    let excess = size.plus(-SPIN_LIMIT);
    if excess > T::zero() {
        // 16 + e/(1 + e/16), e = |Ls| − 16
        let allowed = (excess / excess.times(1.0 / SPIN_LIMIT).plus(1.0)).plus(SPIN_LIMIT);
        let factor = allowed / size;
        [vx * factor, vy * factor, phi * factor]
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

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn at(g: f64, nu: f64, v: [f64; 3]) -> [f64; 3] {
        let TotalForce { fx, fy, mz } = total(g, nu, &LinearCoefficients::at(g, nu), v);
        [fx, fy, mz]
    }

    /// Numbers between 0 and 1, the same in every run.
    struct Numbers(u64);

    impl Numbers {
        fn next(&mut self) -> f64 {
            self.0 = self
                .0
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 11) as f64 / (1_u64 << 53) as f64
        }

        /// Both signs, evenly spread over the logarithm between two powers of ten; one in eight is zero.
        fn spread(&mut self, low: f64, high: f64) -> f64 {
            let size = 10_f64.powf(low + (high - low) * self.next());
            match (self.next() * 8.0) as u32 {
                0 => 0.0,
                1..=3 => -size,
                _ => size,
            }
        }
    }

    /// Printed by `fit/fit_total.py`, which evaluates the same formulas in Python.
    #[test]
    fn agrees_with_the_fit() {
        for (g, nu, v, expected) in [
            (1.0, 0.28, [0.1, 0.0, 0.0], [0.36955997086433884, 0.0, 0.0]),
            (
                1.0,
                0.28,
                [0.1, -0.05, 0.2],
                [0.3118387160555689, 0.12344951975635982, 0.21200692334404184],
            ),
            (
                1.0,
                0.28,
                [-0.3, 0.2, 0.7],
                [-0.42631436112723514, 0.7014882805891998, 0.27978514126245363],
            ),
            (
                0.1,
                0.0,
                [0.05, 0.3, 0.1],
                [0.09004603794271983, 0.600841925355628, 0.39185552220614045],
            ),
            (0.1, 0.5, [0.0, -0.2, 2.0], [0.0, 0.03725943185779771, 1.2030349375893588]),
            (10.0, 0.28, [0.0, 0.0, 0.09], [0.0, 0.8878264824392748, 0.24781916681252655]),
            (
                10.0,
                0.28,
                [0.05, -0.22, 0.18],
                [0.2911203527720071, 0.14024163355662192, 1.0061653858433093],
            ),
            (5.0, 0.1, [0.0, 0.1, -0.2], [0.0, -0.517924697847013, -0.5038956303378328]),
            (
                0.3,
                0.4,
                [3.0, -2.0, 1.0],
                [0.8298118407833678, -0.5568108444907159, 0.05210596715604541],
            ),
            (
                2.0,
                0.25,
                [0.0001, 0.0002, -0.0001],
                [0.0005093557125276509, 0.0007181075192143907, -0.0006069511631880961],
            ),
            (
                0.02,
                0.3,
                [0.2, 0.2, 0.5],
                [0.07779967392775179, 0.23745534165113014, 2.4943500460650885],
            ),
            (
                60.0,
                0.3,
                [0.01, 0.02, 0.03],
                [0.16343668216247015, 0.6736673439685543, 0.3798208078321969],
            ),
            (1.0, 0.5, [0.0, 0.0, 40.0], [0.0, 0.05371985475082374, 0.5904888352708672]),
        ] {
            for (value, expected) in at(g, nu, v).into_iter().zip(expected) {
                assert_relative_eq!(value, expected, max_relative = 1e-12, epsilon = 1e-14);
            }
        }
    }

    /// Relative error against the linear theory vanishes with the creepage, for each of the three outputs.
    #[test]
    fn starts_as_the_linear_theory() {
        for g in [0.01, 0.1, 0.5, 1.0, 3.0, 10.0, 100.0] {
            for nu in [0.0, 0.28, 0.5] {
                let LinearCoefficients { c11, c22, c23, c33 } = LinearCoefficients::at(g, nu);
                for (vx, vy, phi) in
                    [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.3, -0.5, 0.7)]
                {
                    let [vx, vy, phi] = [vx, vy, phi].map(|v| 1e-9 * v);
                    let linear = [c11 * vx, c22 * vy + c23 * phi, c33 * phi - c23 * vy];
                    for (value, linear) in at(g, nu, [vx, vy, phi]).into_iter().zip(linear) {
                        assert_relative_eq!(value, linear, max_relative = 1e-4);
                    }
                }
            }
        }
    }

    /// `F → μ N` along the rigid slip, `Mz → 0`.
    #[test]
    fn ends_as_full_sliding() {
        for g in [0.01, 0.1, 1.0, 10.0, 100.0] {
            for nu in [0.0, 0.28, 0.5] {
                for angle in [0.0_f64, 0.4, 1.0, 1.57, 2.5] {
                    for phi in [0.0, 0.5, -3.0] {
                        let v = 1e7;
                        let [fx, fy, mz] = at(g, nu, [v * angle.cos(), v * angle.sin(), phi]);
                        assert_relative_eq!(fx, angle.cos(), epsilon = 1e-4);
                        assert_relative_eq!(fy, angle.sin(), epsilon = 1e-4);
                        assert!(mz.abs() < 1e-2, "{g} {nu} {angle} {phi}: {mz}");
                    }
                }
            }
        }
    }

    #[test]
    fn keeps_the_symmetries_bounds_and_dissipation() {
        let mut random = Numbers(7);
        for _ in 0..200_000 {
            let g = 10_f64.powf(6.0 * random.next() - 3.0);
            let nu = 0.5 * random.next();
            let v @ [vx, vy, phi] =
                [random.spread(-6.0, 6.0), random.spread(-6.0, 6.0), random.spread(-6.0, 6.0)];
            let [fx, fy, mz] = at(g, nu, v);
            assert!(fx.hypot(fy) <= 1.0 + 1e-9 && mz.is_finite(), "{g} {nu} {v:?}");
            let power = fx * vx + fy * vy + mz * phi;
            let size = (fx * vx).abs() + (fy * vy).abs() + (mz * phi).abs();
            assert!(power >= -1e-13 * size, "{g} {nu} {v:?}: {power} of {size}");
            assert_eq!(at(g, nu, [-vx, vy, phi]), [-fx, fy, mz]);
            assert_eq!(at(g, nu, [-vx, -vy, -phi]), [-fx, -fy, -mz]);
        }
    }

    /// The moment of the fitted range is below that of the largest arm; far outside it stays bounded.
    #[test]
    fn moment_is_bounded() {
        let mut random = Numbers(11);
        for _ in 0..200_000 {
            let g = 10_f64.powf(2.0 * random.next() - 1.0);
            let nu = 0.5 * random.next();
            let v = [random.spread(-3.0, 3.0), random.spread(-3.0, 3.0), random.spread(-3.0, 3.0)];
            let [.., mz] = at(g, nu, v);
            assert!(mz.abs() < 2.0 * g.sqrt().max(1.0 / g.sqrt()), "{g} {nu} {v:?}: {mz}");
        }
    }

    /// Central differences from both sides agree better and better with smaller steps: no kink where
    /// creepages or spin change sign, nor where the saturation curve ends.
    #[test]
    fn is_smooth() {
        let mut random = Numbers(3);
        for _ in 0..20_000 {
            let g = 10_f64.powf(2.0 * random.next() - 1.0);
            let nu = 0.5 * random.next();
            let v = [random.spread(-2.0, 0.5), random.spread(-2.0, 0.5), random.spread(-2.0, 0.5)];
            for axis in 0..3 {
                let bend = |h: f64| {
                    let shifted = |h: f64| {
                        let mut v = v;
                        v[axis] += h;
                        at(g, nu, v)
                    };
                    let (low, middle, high) = (shifted(-h), shifted(0.0), shifted(h));
                    (0..3)
                        .map(|i| (high[i] - 2.0 * middle[i] + low[i]).abs() / h)
                        .fold(0.0, f64::max)
                };
                // change of slope over h: proportional to h, up to rounding, unless there is a kink
                let (coarse, fine) = (bend(1e-4), bend(1e-6));
                assert!(fine < 0.05 * coarse + 1e-3, "{g} {nu} {v:?} {axis}: {coarse} {fine}");
            }
        }
    }

    #[test]
    fn holds_for_hard_inputs() {
        for g in [1e-300, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e300] {
            for v in [0.0, 5e-324, 1e-300, 1e-150, 1e-30, 1e30, 1e150, 1e300] {
                for [x, y, z] in
                    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, -1.0, 1.0]]
                {
                    let [fx, fy, mz] = at(g, 0.3, [v * x, v * y, v * z]);
                    assert!(fx.hypot(fy) <= 1.0 + 1e-9 && mz.is_finite(), "{g} {v} {fx} {fy} {mz}");
                }
            }
        }
        assert_eq!(at(1.0, 0.3, [0.0; 3]), [0.0; 3]);
    }

    #[test]
    fn single_precision_follows() {
        let mut random = Numbers(5);
        for _ in 0..100_000 {
            let g = 10_f64.powf(2.0 * random.next() - 1.0) as f32;
            let nu = 0.5 * random.next() as f32;
            let v = [0; 3].map(|_| random.spread(-3.0, 1.0) as f32);
            let single = total(g, nu, &LinearCoefficients::at(g, nu), v);
            let double = at(g.into(), nu.into(), v.map(f64::from));
            for (single, double) in [single.fx, single.fy, single.mz].into_iter().zip(double) {
                assert_relative_eq!(f64::from(single), double, epsilon = 2e-5);
            }
        }
        for v in [1e-38_f32, 1e-30, 1e12, 1e30, 3e38] {
            for g in [1e-30_f32, 0.1, 1.0, 10.0, 1e30] {
                let f = total(g, 0.5, &LinearCoefficients::at(g, 0.5), [v, -v, v]);
                assert!(f.fx.hypot(f.fy) <= 1.00001 && f.mz.is_finite(), "{g} {v} {f:?}");
            }
        }
    }
}
