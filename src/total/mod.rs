//! Total forces of a contact, without strips: the most accurate model where only `Fx, Fy, Mz` are
//! needed.
//!
//! The result is a weighted mean of two formulas. Near rest it is the linear theory with the
//! saturation curve of strip theory, and with factors of a small network that is fitted to cases
//! computed with CONTACT. Far beyond saturation it is rigid slip, where elasticity no longer
//! matters and only the ratio of creepage to spin counts.
//!
//! These properties hold for any constants:
//! * `|F| ≤ μ N`, `Mz` bounded.
//! * Linear theory for small creepage: every correction carries the weight `w = n²/(ONSET + n²)`,
//!   `n` the size of the linear force.
//! * Rigid slip for large creepage, spin or both, in force and moment.
//! * Symmetry: only signs change with the sign of `vx`, or with the signs of `vy` and spin
//!   together.
//! * Power `fx vx + fy vy + mz φ ≥ 0`: both formulas have this property, hence their mean has it.
//! * Continuously differentiable in creepage and spin everywhere.
//!
//! The only operations are `+ − × ÷ √`. `fit/fit_total.py` fits the network and the other
//! constants, and contains the same formulas.

mod constants;
mod network;
mod rigid_slip;

use self::constants::{
    BRAKE, END_X, END_Y, LOSS, ONSET, REACH_X, REACH_Y, SEEN_E, SEEN_ES, SEEN_S, SEEN_S4, SEEN_U,
    SEEN_Y, SEEN_YS, SHEAR, TURN,
};
use self::network::TotalNetwork;
use self::rigid_slip::RigidSlip;
use crate::contact::totals::Totals;
use crate::linear::LinearCoefficients;
use crate::number::avx::with_avx;
use crate::number::{Arithmetic, Number, Pair, Real, Stored, Strips, inverses};

/// Limits of the axis ratio with which the formulas are evaluated. They are fitted for 0.015 to 60,
/// rigid slip for 1/70 to 70.
const RATIO_LIMIT: f64 = 1e3;
/// Root of the largest axis ratio that is passed to the network. Beyond it the other formulas have
/// the right limits.
const LARGEST_ROOT: f64 = 8.0;
/// Creepages whose linear force is beyond this are rigid slip, and scaled down together.
fn largest_linear_force<T: Number>() -> f64 {
    if size_of::<Stored<T>>() == 4 { 1e4 } else { 1e8 }
}
/// Creepages below this multiple of the smallest normal number have lost digits, or their products
/// would.
const LOST: f64 = 1e6;

/// `|q|` of full sliding (Section 8.15).
const FULL: f64 = 3.0 * core::f64::consts::PI / 4.0;
/// Growth of the slopes with `e⁶` in translation, which keeps `|q|` above that of full sliding
/// beyond saturation.
const GROWTH: f64 = 0.0003;
/// `1/n⁴` where half of the result is rigid slip: `n = 20` in translation, 150 where there is much
/// spin.
const TRANSLATION: f64 = 1.0 / (20.0 * 20.0 * 20.0 * 20.0);
const SPIN: f64 = 1.0 / (150.0 * 150.0 * 150.0 * 150.0);

/// `S/|q|` in powers of `|q|` up to full sliding, lowest first. Printed by `fit/fit_total.py`:
/// least maximum error of `S`, 1.5e-4, with the exact slope at 0 and slope zero at full sliding.
const SATURATION_SERIES: [f64; 6] = [
    1.0,
    -0.26497443542200877,
    -0.016982827409411667,
    0.023171947269272353,
    -0.009070529546294396,
    0.0016453016098987088,
];

/// The numbers of TOTAL that depend on the contact alone.
#[derive(Clone, Copy, Debug)]
pub struct Total<F> {
    linear: LinearCoefficients<F>,
    /// `g = a/b`
    ratio: F,
    /// `1/M₀²`, `M₀ = √(0.1406 (g + 1/g + 0.467))` the moment of sliding by spin alone
    moment: F,
    /// The larger of the derivatives of the force, and of the moment divided by `M₀`, with respect
    /// to spin.
    spin_slope: F,
    /// Linear force of the slip that spin makes at the ends of the axes.
    ends: [F; 2],
    /// `√g` within `1/8 … 8` as `(√g − 1)/(√g + 1)`
    slender: F,
    rigid: RigidSlip<F>,
    network: TotalNetwork<F>,
}

impl<F: Real> Total<F> {
    /// For the axis ratio `g = a/b`, Poisson's ratio, and the coefficients of the linear theory for
    /// them.
    ///
    /// Made for `a/b` 0.015 to 60 and `ν` 0 to 1/2; finite and with the right limits beyond.
    #[must_use]
    #[inline(always)]
    pub fn new(axis_ratio: F, poisson_ratio: F, linear: &LinearCoefficients<F>) -> Self {
        with_avx!(if F::LANES => <F: Real>(
            axis_ratio: F,
            poisson_ratio: F,
            linear: &LinearCoefficients<F>
        ) -> Total<F> {
            Total::with_ratio(axis_ratio, poisson_ratio, linear)
        })
    }

    #[inline(always)]
    fn with_ratio(axis_ratio: F, poisson_ratio: F, linear: &LinearCoefficients<F>) -> Self {
        let g = axis_ratio.clamped(F::of(1.0 / RATIO_LIMIT), F::of(RATIO_LIMIT));
        let inverse = F::one() / g;
        let (root, both) = (g.sqrt(), g + inverse);
        let inverse_root = root * inverse;
        let end_x = linear.c11 * (inverse_root + root.times(END_X)).times(REACH_X);
        let end_y = linear.c22 * (root + inverse_root.times(END_Y)).times(REACH_Y);
        let shape = root.clamped(F::of(1.0 / LARGEST_ROOT), F::of(LARGEST_ROOT));
        let slender = shape.plus(-1.0) / shape.plus(1.0);
        let moment = F::one() / both.plus(0.467).times(0.1406);
        let poisson = poisson_ratio.times(4.0).plus(-1.0);
        Self {
            linear: *linear,
            ratio: g,
            moment,
            spin_slope: linear.c23.max(linear.c33 * moment.sqrt()),
            ends: [end_x, end_y],
            slender,
            rigid: RigidSlip::new(g, both),
            network: TotalNetwork::for_fixed_inputs([
                slender,
                poisson,
                slender * slender,
                slender * slender * slender,
                slender * poisson,
            ]),
        }
    }

    /// Totals for creepages `vx, vy = G a b (υx, υy)/(μ N)` and spin `φ = G (a b)^{3/2} ϕ/(μ N)`.
    /// The model does not give the stick area.
    #[must_use]
    #[inline(always)]
    pub fn mean_totals<T: Number<Base = F>>(&self, creepage: [T; 3]) -> Totals<T> {
        with_avx!(if T::LANES => <F: Real, T: Number<Base = F>>(
            contact: &Total<F> = self,
            creepage: [T; 3]
        ) -> Totals<T> {
            contact.totals_in_registers::<T, F::Four>(creepage)
        } {
            contact.totals_in_registers::<T, F::WideRow>(creepage)
        })
    }

    #[inline(always)]
    fn totals_in_registers<T: Number<Base = F>, P: Strips<F>>(
        &self, creepage: [T; 3],
    ) -> Totals<T> {
        let one = T::one();
        let LinearCoefficients { c11, c22, c23, c33 } = self.linear;
        let [vx, vy, phi] = within_range(creepage, [c11, c22, self.spin_slope]);
        let (vx2, vy2, phi2) = (vx.squared(), vy.squared(), phi.squared());

        // Force of the linear theory: u² of translation, s² of spin, m² its moment divided by M₀,
        // n² their sum.
        let (lx, ly, ls) = (vx.scale(c11), vy.scale(c22), phi.scale(c23));
        let (lx2, ly2, s2) = (lx.squared(), ly.squared(), ls.squared());
        let u2 = lx2 + ly2;
        let m2 = phi2.scale(c33 * c33 * self.moment);
        let n2 = u2 + s2 + m2;

        // rigid slip, κ the share of spin in it
        let (rigid, kappa) = self.rigid.at([vx, vy, phi], [vx2, vy2, phi2]);

        // spin brakes the slopes: ix = 1/(1 + tx²), iy, im;  e² = lx² ix + ly² iy
        let [end_x, end_y] = self.ends;
        let [ix, iy, im, f_u] = inverses([
            phi2.scale(end_x * end_x).plus(1.0),
            phi2.scale(end_y * end_y).plus(1.0),
            (m2 + u2).plus(1.0),
            u2.times(SEEN_U).plus(1.0),
        ]);
        let ex2 = lx2 * ix;
        let e2 = ex2 + ly2 * iy;
        let e4 = e2.squared();

        // corrections k₁ … k₄, k₆ > 0 and ρ within ±1: 1 and 0 at rest
        let lys = ly + ls;
        let py2 = phi2.scale(self.ratio);
        let pole = (one - kappa).squared().squared().squared();
        // Reciprocals of x for the final mean, of dₑ and of the share of γ.
        let x = n2.squared() * pole.times(TRANSLATION).plus(SPIN);
        let [f_s, f_s4, f_e, f_es, f_ys, f_y, w, d, spin, near] = inverses([
            s2.plus(SEEN_S),
            s2.squared().plus(SEEN_S4),
            e2.plus(SEEN_E),
            (e2 + s2).plus(SEEN_ES),
            (lys.squared() + s2).plus(SEEN_YS),
            (vy2 + py2).plus(SEEN_Y),
            n2.plus(ONSET),
            e4.times(TURN).plus(1.0),
            (s2 + u2.times(BRAKE)).plus(1.0),
            x.plus(1.0),
        ]);
        let w = n2 * w;
        let corrections = self.network.total_corrections::<T, P>([
            kappa,
            kappa.scale(self.slender),
            py2 * f_y,
            f_s,
            f_s4,
            f_u,
            f_s.scale(self.slender),
            lys * ls * f_ys,
            f_e,
            ex2 * f_e,
            ly * ls * f_es,
            f_e.scale(self.slender),
            f_e * kappa,
            f_e * f_s,
            ix,
            im,
        ]);
        let [o1, o2, o3, o4, o5, o6] = T::each(&corrections, |o| *o * w);
        // k = 1 + 2o + 1.01 o²: 1 at 0, never below 1/101
        let [k1, k2, k3, k4, k6] =
            T::each(&[o1, o2, o3, o4, o6], |o| (*o * o.times(1.01).plus(2.0)).plus(1.0));

        // elastic slopes and those of sliding: dₑ = 1/(1 + TURN e⁴) of the first
        let (root_x, root_y) = T::Pair::couple(ix, iy).sqrt().parts();
        let braked = root_y.scale(c22);
        // Limited, so that q² stays finite in single precision; only the direction counts there.
        let growth = ((e4 * e2).min(T::from_base(T::HUGE)) * pole).scale(c22.times(GROWTH));
        let beta_x = k2 * (braked * (one - d) + k1 * (root_x * d).scale(c11)) + growth;
        let elastic_y = k2 * braked;
        let beta_y = elastic_y + growth;
        // q = (βx vx, βy vy + γ φ), γ = k₃ C23/(1 + s² + BRAKE u²)
        let spin = spin.scale(c23);
        let gamma = k3 * spin;
        let (qx, qy) = (beta_x * vx, beta_y * vy + gamma * phi);
        let q2 = qx.squared() + qy.squared() + (spin * phi).squared().times(SHEAR);
        // F = σ q, σ = S(|q|)/(h |q|): spin keeps |F| below μ N in full sliding
        let sigma = saturation(q2, (kappa * w * k6).times(LOSS).plus(1.0));
        let (fx, fy) = (sigma * qx, sigma * qy);
        // spin's own moment ε φ, at most 1.14 M₀
        let epsilon = (k4 * im.sqrt()).scale(c33);
        let excess = (epsilon * phi).squared().scale(self.moment);
        let [kept, share] =
            inverses([excess.squared().times(1.0 / 16.0).plus(1.0), o5.squared().plus(1.0)]);
        let epsilon = epsilon * kept;
        // M = ε φ − σ γ vy + 2 σ ρ √(β ε) vy, β ≤ βy without growth. With σ ≤ 1 and |ρ| ≤ 1 the
        // power σ βx vx² + σ βy vy² + 2 σ ρ √(β ε) vy φ + ε φ² is never negative
        let rho = (o5 + o5) * d * share;
        let coupling = rho * (elastic_y * epsilon).sqrt();
        let mz = epsilon * phi + sigma * ((coupling + coupling) - gamma) * vy;

        // (elastic + x rigid)/(1 + x), x = n⁴ ((1 − κ)⁸/20⁴ + 1/150⁴)
        let far = x * near;
        let [rx, ry, rm] = rigid;
        Totals {
            fx: near * fx + far * rx,
            fy: near * fy + far * ry,
            mz: near * mz + far * rm,
            stick: -one,
        }
    }
}

/// `S(|q|)/(h |q|)` from `|q|²` and `h`, with `S = 1 − ((2 + d²) √(1 − d²) − 3 d acos d)/2`,
/// `d = 4|q|/(3π)`, and 1 for `d ≥ 1` (Section 8.15).
#[inline(always)]
fn saturation<T: Number>(q2: T, h: T) -> T {
    // the small term keeps the derivative of the root finite at 0
    let q = q2.plus(1e-30).sqrt();
    let e = q.min(T::constant(FULL));
    let e2 = e.squared();
    let [k0, k1, k2, k3, k4, k5] = SATURATION_SERIES;
    let low = e.times(k1).plus(k0) + e2 * e.times(k3).plus(k2);
    let s_over_q = low + e2.squared() * e.times(k5).plus(k4);
    s_over_q * (T::constant(FULL) / (q.max(T::constant(FULL)) * h))
}

/// Equivalent creepages and spin whose powers are finite. The linear forces are these times the
/// slopes.
#[inline(always)]
fn within_range<T: Number>(mut creepage: [T; 3], slopes: [T::Base; 3]) -> [T; 3] {
    let ([vx, vy, phi], [x, y, spin]) = (creepage, slopes);
    let [vx, vy, phi] = [vx.value().abs(), vy.value().abs(), phi.value().abs()];
    let size = (vx * x).max(vy * y).max(phi * spin);
    let lost = T::TINY.times(LOST);
    // The creepages of a needle may underflow although its slopes are steep.
    let least = vx.max(vy).max(phi).min(size);
    // Of several contacts side by side one may be too small and another too large.
    if lost.exceeds(least) {
        // Such creepages have few digits, so that the sign of the power would be arbitrary. Their
        // forces are below 1e-24 of `μ N`, except for needles below 1e-32, and count as zero; the
        // slopes stay.
        let gone = |v: &T| *v - T::from_base((lost - least).choose(v.value(), T::Base::zero()));
        creepage = T::each(&creepage, gone);
    }
    let limit = T::Base::of(largest_linear_force::<T>());
    if size.exceeds(limit) {
        let factor = (size - limit).choose(limit / size, T::Base::one());
        creepage = T::each(&creepage, |v| v.scale(factor));
    }
    creepage
}
