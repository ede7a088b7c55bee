//! The creepages of the strips of a contact: from `vx, vy, φ` to `a_x, a_y, ρ, σ` and the bend `ε`.
//!
//! The flexibilities are those of Kalker's linear theory, multiplied by fitted factors that are 1
//! at rest. Where the linear force is far beyond the friction bound they become that of the rigid
//! slip.

use super::constants::{SATURATION, WIDTH, WIDTH2};
use super::kernel::StripCreepage;
use super::long::LongContact;
use super::network::{INPUTS, StripNetwork};
use crate::linear::LinearCoefficients;
use crate::number::avx::with_avx;
use crate::number::{Arithmetic, Number, Pair, Real, Strips, add, inverses, scaled_down};
use core::f64::consts::PI;

/// Creepages beyond this are scaled down together, because the contact slides fully. Their fourth
/// powers fit an `f32`.
const CREEPAGE_LIMIT: f64 = 1e4;
/// The creepages of strips are scaled down together beyond this, so that their fourth powers fit an
/// `f32`.
const SEEN_LIMIT: f64 = 1e5;
/// Largest creepage of one strip.
const STRIP_LIMIT: f64 = 1e6;
/// Limits of the axis ratio with which the model is evaluated. It is fitted for 0.015 to 60.
const RATIO_LIMIT: f64 = 1e3;

/// `40⁴`
const LIMIT: f64 = SATURATION * SATURATION * SATURATION * SATURATION;

/// Everything that depends on the contact alone.
#[derive(Clone, Copy, Debug)]
pub struct Flexibilities<F: Real> {
    pub(super) linear: LinearCoefficients<F>,
    /// `√(a/b)` within the limits of the model, and its inverse.
    pub(super) root: F,
    pub(super) upright: F,
    /// `(4/3π)(C11 + C22)`, the common flexibility of full sliding.
    rigid: F,
    /// `C23/(k_m C22) − 1` with `k_m = (4/3π) √(a/b)`. With it the moment of a small lateral
    /// creepage has Kalker's slope.
    lateral_at_rest: F,
    /// Factors of creepage and of `ρ` that make sums over strips exact at rest.
    factors: [F; 2],
    network: StripNetwork<F>,
    long: LongContact<F>,
    /// Share of the square of a spin's linear force that counts toward rigid slip: 1, less in long
    /// contacts.
    of_spin: F,
}

/// The creepages of the strips of a contact.
#[derive(Clone, Copy, Debug)]
pub struct Distribution<T: Number> {
    /// `a_x`: longitudinal creepage in the middle strip.
    pub longitudinal: T,
    /// `a_y`: lateral creepage.
    pub lateral: T,
    /// `ρ`: decrease of the longitudinal creepage per unit of `Y`.
    pub slope: T,
    /// `ε`: curvature of that decrease.
    pub bend: T,
    /// `σ`: spin.
    pub spin: T,
    /// Distance from full sliding: 1 at rest, 0 in full sliding.
    pub start: T,
    /// The creepages `vx, vy, φ` that these belong to, scaled down where they are very large.
    pub creepage: [T; 3],
    /// `√(a/b)`
    pub root: T::Base,
}

/// Geometry of one strip, dimensionless.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripGeometry<F> {
    /// `Y = y/b` of its centre line, −1 to 1.
    pub y: F,
    /// Half length divided by that of the patch, `C = c/a`, positive.
    pub half_length: F,
    /// `Π L_x` and `Π L_y`, positive. `Π = (μ p₀)_strip/(μ p₀)` is the peak of the strip's friction
    /// bound divided by that of the patch. `L_x` and `L_y` are the flexibilities of the strip
    /// along `x` and `y` divided by those of a strip of the ellipse. On an ellipse with one
    /// coefficient of friction both numbers are `C`.
    pub bound: [F; 2],
    /// Width in `Y`, over which slip is averaged: that of one of sixteen strips at this place; 0
    /// for a line.
    pub width: F,
}

impl<F: Real> Flexibilities<F> {
    /// `axis_ratio` is `a/b`, `linear` the coefficients for it, `factors` those of [`super::Rule`],
    /// or 1.
    #[inline(always)]
    pub fn new(
        axis_ratio: F, poisson_ratio: F, linear: &LinearCoefficients<F>, factors: [F; 2],
    ) -> Self {
        with_avx!(if F::LANES => <F: Real>(axis_ratio: F, poisson_ratio: F,
            linear: &LinearCoefficients<F>, factors: [F; 2]) -> Flexibilities<F> {
            Flexibilities::for_ellipse(axis_ratio, poisson_ratio, linear, factors)
        })
    }

    #[inline(always)]
    fn for_ellipse(
        axis_ratio: F, poisson_ratio: F, linear: &LinearCoefficients<F>, factors: [F; 2],
    ) -> Self {
        let root = axis_ratio.clamped(F::of(1.0 / RATIO_LIMIT), F::of(RATIO_LIMIT)).sqrt();
        let [stretch, _] = factors;
        let moment = (root * stretch * linear.c22).times(4.0 / (3.0 * PI));
        let (upright, inverse) = F::Pair::couple(root, moment).inverse().parts();
        let ratio = (root.plus(-1.0) / root.plus(1.0)).times(2.0);
        let poisson = poisson_ratio.times(4.0).plus(-1.0);
        let long = LongContact::new(root, ratio, poisson);
        Self {
            linear: *linear,
            root,
            upright,
            rigid: (linear.c11 + linear.c22).times(4.0 / (3.0 * PI)),
            lateral_at_rest: (linear.c23 * inverse).plus(-1.0),
            factors,
            network: StripNetwork::new(ratio, poisson),
            of_spin: long.of_spin(root),
            long,
        }
    }

    /// The creepages of the strips, from `vx, vy = G a b (υx, υy)/(μ N)` and
    /// `φ = G (a b)^{3/2} ϕ/(μ N)`.
    ///
    /// The factors are fitted for `a/b` 0.015 to 60, `ν` 0 to 1/2 and `|ψ| = (π/3) √(a/b) |φ| ≤ 3`.
    /// Beyond that range the results are finite and bounded and have the right limits.
    #[inline(always)]
    pub fn see<T: Number<Base = F>>(&self, creepage: [T; 3]) -> Distribution<T> {
        with_avx!(if T::LANES => <F: Real, T: Number<Base = F>>(
            contact: &Flexibilities<F> = self,
            creepage: [T; 3]
        ) -> Distribution<T> {
            contact.seen::<T, F::Four>(creepage)
        } {
            contact.seen::<T, F::WideRow>(creepage)
        })
    }

    #[inline(always)]
    pub(super) fn seen<T: Number<Base = F>, P: Strips<F>>(
        &self, creepage: [T; 3],
    ) -> Distribution<T> {
        const K: f64 = 8.0 / (3.0 * PI);
        let creepage = scaled_down(creepage, F::of(CREEPAGE_LIMIT));
        let [vx, vy, phi] = creepage;
        let LinearCoefficients { c11, c22, c23, c33 } = self.linear;
        let one = T::one();

        // forces of the linear theory
        let [lx, ly, ls] = [vx.scale(c11), vy.scale(c22), phi.scale(c23)];
        let size = magnitude(T::Pair::couple(lx, ly));
        let ss = magnitude(ls);
        let t2 = lx * lx + ly * ly;
        let s2 = ls * ls;
        let q2 = t2 + s2;

        // Rigid slip: quotient of translation and spin at the ends of the axes.
        let (px, py) = (phi.scale(self.upright), phi.scale(self.root));
        let (x2, px2, y2, py2) = (vx * vx, px * px, vy * vy, py * py);

        // Every quotient (s − c)/(s + c) is computed as 1 − 2 c/(s + c), two divisions at a time.
        let (by_x, by_y) = size.plus(1.0).inverse().parts();
        let [over_x, over_y] = inverses([(x2 + px2).plus(0.02), (y2 + py2).plus(0.02)]);
        let [by_s, by_few] = inverses([ss.plus(1.0), ss.plus(0.1)]);
        let [by_less, by_more] = inverses([ss.plus(0.3), ss.plus(2.0)]);
        let [by_t, by_q] = inverses([t2.plus(0.1), q2.plus(1.0)]);
        let [by_n, by_n2] = inverses([q2.plus(WIDTH), q2.plus(WIDTH2)]);
        let features: [T; INPUTS] = [
            (x2 - px2) * over_x,
            (vy * py).times(2.0) * over_y,
            (y2 - py2) * over_y,
            less(by_x, 2.0),
            less(by_y, 2.0),
            less(by_s, 2.0),
            (ls * ly) * (by_few * by_y),
            less(by_t, 0.2),
            less(by_less, 0.6),
            less(by_more, 4.0),
            less(by_q, 2.0),
        ];
        let mut corrections = self.network.layers().strip_corrections::<T, P>(features);
        if self.long.share.exceeds(F::zero()) {
            let [_, _, _, shared @ ..] = features;
            let psi = magnitude(py.times(PI / 3.0));
            let more = self.long.long_corrections::<T, P>(
                shared,
                [lx, ly, ls],
                [x2, y2, py2],
                vy * py,
                psi,
            );
            add(&mut corrections, more);
        }
        let [o_x, o_y, o_slope, o_spin, o_share, o_spin_share, o_lateral, o_bend] = corrections;

        // w = n²/(c + n²): no correction at rest
        let (w, w2) = (less(by_n, WIDTH), less(by_n2, WIDTH2));
        // χ = m⁴/(m⁴ + 40⁴), m² that of the creepages and a share of that of the spin: from the
        // contact's own flexibilities to that of the rigid slip
        let m2 = t2 + s2.scale(self.of_spin);
        let elastic = (m2 * m2).plus(LIMIT).inverse().times(LIMIT);
        let rigid = (one - elastic).scale(self.rigid);

        let (e_x, e_y) = positive(w * o_x, w * o_y);
        let (e_spin, e_share) = positive(w * o_spin, w * o_share);
        let bend_square = o_bend.squared();
        let slope_square = (w2 * o_slope).squared();
        let (slope_root, bend_root) =
            T::Pair::couple(slope_square, bend_square).plus(1.0).sqrt().parts();
        // β and τ: how spin and lateral creepage share A_y and σ
        let spin_share = w2 * o_spin_share;
        let lateral_share = w2 * o_lateral + (one - w2).scale(self.lateral_at_rest);
        let lateral = ly * e_y;
        // a_x = (8/3π) C11 vx e_x
        let longitudinal = elastic * (lx * e_x).times(K) + rigid * vx;
        // a_y = (8/3π) (C22 vy e_y (1 + τ) + C23 φ e_s β/(1 + |C23 φ|))
        let lateral_creepage = elastic
            * (lateral * lateral_share.plus(1.0) + spin_share * e_share * (ls * by_s)).times(K)
            + rigid * vy;
        // σ = C23 φ e_σ (1 − β) − C22 vy e_y τ
        let spin = elastic * (ls * (one - spin_share) * e_spin - lateral_share * lateral)
            + (rigid * py).times(0.5);
        // ρ = (32/3π) √(a/b) C33 φ e_ρ
        let slope = elastic
            * (py.scale(c33) * (w2 * o_slope + slope_root)).times(32.0 / (3.0 * PI))
            + rigid * px;
        let bend = elastic * w2 * o_bend / bend_root;
        let [stretch, lever] = self.factors;
        let [longitudinal, lateral, slope, spin] = scaled_down(
            [
                longitudinal.scale(stretch),
                lateral_creepage.scale(stretch),
                slope.scale(lever),
                spin,
            ],
            F::of(SEEN_LIMIT),
        );
        Distribution {
            longitudinal,
            lateral,
            slope,
            bend,
            spin,
            start: elastic,
            creepage,
            root: self.root,
        }
    }
}

impl<T: Number> Distribution<T> {
    /// Without derivatives.
    pub(super) fn without_derivatives(&self) -> Distribution<T::Base> {
        Distribution {
            longitudinal: self.longitudinal.value(),
            lateral: self.lateral.value(),
            slope: self.slope.value(),
            bend: self.bend.value(),
            spin: self.spin.value(),
            start: self.start.value(),
            creepage: self.creepage.map(T::value),
            root: self.root,
        }
    }

    /// `a_x, a_y, ρ, ρ ε, σ` and the start. The creepages of strips are linear in the first four.
    pub(super) fn numbers(&self) -> [T; 6] {
        let bent = self.slope * self.bend;
        [self.longitudinal, self.lateral, self.slope, bent, self.spin, self.start]
    }

    /// The creepages of one strip, and `σ`.
    pub fn strip(&self, strip: &StripGeometry<T::Base>) -> (StripCreepage<T>, T) {
        let [inverse_x, inverse_y] = inverses(strip.bound);
        let y = strip.y;
        // A_x = (a_x − ρ Y (1 + ε (0.4 − Y²)))/(Π L_x), A_y = a_y/(Π L_y)
        let profile = self.bend.scale((T::Base::of(0.4) - y * y) * y).shift(y);
        let [x, y, spread, spin] = scaled_down(
            [
                (self.longitudinal - self.slope * profile).scale(inverse_x),
                self.lateral.scale(inverse_y),
                self.slope.scale(strip.width * inverse_x),
                self.spin.scale(strip.half_length * inverse_y),
            ],
            T::Base::of(STRIP_LIMIT),
        );
        (StripCreepage { x, y, spread, start: self.start }, spin)
    }
}

/// `1 − q c`
#[inline(always)]
fn less<T: Number>(quotient: T, twice: f64) -> T {
    quotient.times(-twice).plus(1.0)
}

/// `o + √(1 + o²)` of both: positive, 1 at 0.
#[inline(always)]
fn positive<T: Number>(first: T, second: T) -> (T, T) {
    let o = T::Pair::couple(first, second);
    (o + o.squared().plus(1.0).sqrt()).parts()
}

/// `√(x² + 0.03²) − 0.03`
#[inline(always)]
fn magnitude<T: Arithmetic>(x: T) -> T {
    x.squared().plus(0.0009).sqrt().plus(-0.03)
}
