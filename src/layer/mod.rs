//! What lies between the bodies: a layer that shears, and that sliding softens.
//!
//! **The layer** of thickness `h` and shear modulus `G₃` gives way by `h/G₃` \[m/Pa\] times the
//! traction. It adds to the flexibility of the half-spaces, which Kalker's simplified theory
//! measures by the linear theory:
//!
//! ```text
//! L₁ = 8 a/(3 C₁₁ G),   L₂ = 8 a/(3 C₂₂ G),   L_s = π a √(a/b)/(4 C₂₃ G),   k = L/(L + h/G₃)
//! ```
//!
//! A stiff layer leaves half-spaces, which have the creepages `k₁ υx, k₂ υy, k_s φ`. A soft one is
//! a brush of [bristles](bristles) with the flexibilities `L + h/G₃`. The contact is the mean of
//! both, weighted with their flexibilities:
//!
//! ```text
//! F = (1 − w) F_half-spaces(k υ) + w F_bristles(υ/(L + h/G₃)),   w = h/G₃/(L₁ + h/G₃)
//! ```
//!
//! At rest both have the slopes of springs in series. Far in sliding the direction of the rigid
//! slip must come out, so that the three factors fade to the first one, with `n` the linear force
//! divided by `μ N`: `f = n²/(64 + n²)`.
//!
//! **Sliding** softens the layer: measured curves bend less than clean ones. With `s` the linear
//! force divided by `μ N` that the creepages would make without saturation, all of them are
//! multiplied by
//!
//! ```text
//! k₁ + (1 − k₁)/(1 + (0.6 s)^{3/2})
//! ```
//!
//! Both leave forces homogeneous in creepage and friction, `F(c; λ μ) = λ F(c/λ; μ)`.

pub(crate) mod bristles;

use self::bristles::{BristleState, Rates, STEP_ROWS};
use crate::contact::creepage::Creepage;
use crate::contact::totals::{StripForces, Totals};
use crate::linear::LinearCoefficients;
use crate::number::avx::with_avx;
use crate::number::dual::Dual;
use crate::number::lanes::Lanes;
use crate::number::tables::table;
use crate::number::{Arithmetic, Float, Number, Real, Strips, add, scaled_down};

/// Linear force divided by `μ N` half way from the factors of rest to the one of full sliding.
const HALF_WAY: f64 = 8.0;
/// Linear force divided by `μ N` half way to what sliding leaves of the factor, as `1/s`.
const SOFTENED: f64 = 0.6;
/// `9π/32`, the mean of `C` weighted with the load, over its sum over the strips: the linear slope
/// of the lateral force by spin is exact.
const LEVER: f64 = 1.002_169_638_402_630_8;
/// Rates of bristles beyond this slide, and are scaled down together.
#[inline]
fn largest_rate<T: Number>() -> f64 {
    if size_of::<T::Base>() / T::LANES == 4 { 1e4 } else { 1e8 }
}

/// `Y`, `C = √(1 − Y²)` and share of the load of twelve strips of one width, four at a time.
const TWELVE_STRIPS: [[f64; 12]; 3] = {
    const C: [f64; 6] = [
        0.996_521_728_591_783_2,
        0.968_245_836_551_854_2,
        0.909_059_342_863_096_2,
        0.812_232_861_867_781_4,
        0.661_437_827_766_147_7,
        0.399_652_626_942_726_8,
    ];
    let mut fours = [[0.0; 12]; 3];
    let mut i = 0;
    while i < 12 {
        let strip = i / 4 * 2 + i % 4 / 2;
        let (y, c) = ((2 * strip + 1) as f64 / 12.0, C[strip]);
        // ¾ ∫ C² dY
        let load = (1.0 - y * y - 1.0 / 432.0) / 8.0;
        let four = &mut fours[i / 4];
        four[i % 4] = if i % 2 == 0 { y } else { -y };
        (four[4 + i % 4], four[8 + i % 4]) = (c, load);
        i += 1;
    }
    fours
};

/// Sums over the strips with their derivatives with respect to the rates.
type RateSlopes<F> = [Dual<F, 3>; 4];

/// A layer, and what sliding leaves of its stiffness, as numbers that may be variables.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Interface<T> {
    /// `h G/(G₃ a)`, zero without a layer.
    pub layer: T,
    /// `k₁`, one where sliding does nothing.
    pub slide: T,
}

/// The layer of one ellipse.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Layer<F> {
    linear: LinearCoefficients<F>,
    /// `√(a/b)`
    root: F,
    /// `a/L` of the half-spaces over `G`.
    stiffness: [F; 3],
    /// Rates of bristles alone, at rest and far in sliding, divided by the creepages `vx, vy, φ`.
    rates: [[F; 3]; 2],
}

/// The creepages of half-spaces and bristles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Split<T> {
    /// Factors of the creepages of the half-spaces.
    pub factors: [T; 3],
    /// Rates of the bristles: of `υx`, of `υy`, of spin at the half length `a`.
    pub rates: [T; 3],
    /// Weight of the bristles.
    pub weight: T,
}

impl<T: Number> Split<T> {
    /// The creepages of the half-spaces.
    pub fn half_spaces(&self, creepage: &Creepage<T>) -> Creepage<T> {
        let [x, y, z] = self.factors;
        let Creepage { longitudinal, lateral, spin } = *creepage;
        Creepage { longitudinal: longitudinal * x, lateral: lateral * y, spin: spin * z }
    }
}

impl<F: Real> Layer<F> {
    /// Of the ellipse of an axis ratio `a/b` with its coefficients.
    #[inline]
    pub fn new(axis_ratio: F, linear: &LinearCoefficients<F>) -> Self {
        let LinearCoefficients { c11, c22, c23, .. } = *linear;
        let root = axis_ratio.sqrt();
        let pi = core::f64::consts::PI;
        let stiffness = [c11.times(3.0 / 8.0), c22.times(3.0 / 8.0), (c23 / root).times(4.0 / pi)];
        let translation = c11.times(pi / 4.0);
        let rest = [translation, c22.times(pi / 4.0), c23.times(8.0 / 3.0 * LEVER)];
        let sliding = [translation, translation, translation * root];
        Self { linear: *linear, root, stiffness, rates: [rest, sliding] }
    }

    /// `k = L/(L + h/G₃)`
    #[inline]
    pub fn series<T: Number<Base = F>>(&self, layer: T) -> [T; 3] {
        T::each(&self.stiffness, |of| (layer.scale(*of) + T::one()).inverse())
    }

    /// Moments of bristles at rest over those of half-spaces, by lateral creepage and by spin.
    #[inline]
    pub fn moments(&self) -> [F; 2] {
        let LinearCoefficients { c22, c23, c33, .. } = self.linear;
        let root = self.root;
        let pi = core::f64::consts::PI;
        // 3π/32 √(a/b) C₂₂/C₂₃,  32/(15π) (b/a)^{3/2} C₂₃/C₃₃
        let upright = F::one() / (root * root * root);
        [
            (root * (c22 / c23)).times(3.0 * pi / 32.0),
            (upright * (c23 / c33)).times(32.0 / (15.0 * pi)),
        ]
    }

    /// What the creepages `vx, vy = G a b (υx, υy)/(μ N)`, `φ = G (a b)^{3/2} ϕ/(μ N)` are for
    /// half-spaces and bristles. (Out of line where code must be small.)
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline(never))]
    pub fn split<T: Number<Base = F>>(
        &self, [vx, vy, phi]: [T; 3], interface: &Interface<T>,
    ) -> Split<T> {
        let LinearCoefficients { c11, c22, c23, .. } = self.linear;
        let one = T::one();
        let forces = [vx.scale(c11), vy.scale(c22), phi.scale(c23)];
        let [lx, ly, ls] = scaled_down(forces, F::of(largest_rate::<T>()));
        // what sliding leaves: k₁ + (1 − k₁)/(1 + (0.6 s)^{3/2})
        let s = (lx.squared() + (ly + ls).squared()).sqrt().times(SOFTENED);
        let slide = interface.slide + (one - interface.slide) / (s * s.sqrt()).plus(1.0);
        let [k1, k2, ks] = self.series(interface.layer);
        // f = n²/(64 + n²)
        let seen = [k1 * lx, k2 * ly, ks * ls];
        let n2 = seen[0].squared() + seen[1].squared() + seen[2].squared();
        let n2 = n2 * slide.squared();
        let fade = n2 / n2.plus(HALF_WAY * HALF_WAY);
        let factors = T::each(&[k1, k2, ks], |k| slide * (*k + (k1 - *k) * fade));
        let [[x, y, z], [far_x, far_y, far_z]] = self.rates;
        let (bent, slid) = ([k1.scale(x), k2.scale(y), ks.scale(z)], [far_x, far_y, far_z]);
        let mut rates = [vx, vy, phi];
        for ((rate, bent), slid) in rates.iter_mut().zip(bent).zip(slid) {
            *rate = *rate * (slide * (bent + (k1.scale(slid) - bent) * fade));
        }
        Split { factors, rates, weight: one - k1 }
    }

    /// The mean of half-spaces and bristles. (Out of line for the same reason.)
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline(never))]
    pub fn with_bristles<T: Number<Base = F>>(
        &self, half_spaces: &Totals<T>, split: &Split<T>,
    ) -> Totals<T> {
        let Totals { fx, fy, mz, stick } = *half_spaces;
        let bristles = self.bristles(split.rates);
        let mean = |of: T, bristles: T| of + (bristles - of) * split.weight;
        let (fx, fy) = (mean(fx, bristles.fx), mean(fy, bristles.fy));
        Totals { fx, fy, mz: mean(mz, bristles.mz), stick: mean(stick, bristles.stick) }
    }

    /// Forces of the bristles divided by `μ N`, and their moment divided by `μ N √(ab)`.
    #[inline(always)]
    pub fn bristles<T: Number<Base = F>>(&self, [x, y, spin]: [T; 3]) -> Totals<T> {
        // Spin at the half length `b` may be much larger.
        let across = spin.scale(F::one() / (self.root * self.root));
        let [x, y, spin, _] = scaled_down([x, y, spin, across], F::of(largest_rate::<T>()));
        let (inputs, values) = ([x, y, spin], [x, y, spin].map(T::value));
        let sums = if T::HAS_DERIVATIVES {
            self.slopes(values).map(|sum| T::composed(sum.value, sum.gradient, inputs))
        } else {
            self.forces_of_rates(values).map(T::from_base)
        };
        let [fx, fy, mz, stick] = sums;
        // The quadrature may give a little more than the bound.
        let kept = (fx.squared() + fy.squared()).max(T::one()).sqrt().inverse();
        let stick = T::from_base(stick.value());
        Totals { fx: fx * kept, fy: fy * kept, mz: mz * kept, stick }
    }

    /// Rates of the bristles of the strip at `Y` of half length `C`.
    pub fn rates_at(&self, [x, y, spin]: [F; 3], place: F, c: F) -> Rates<F> {
        let upright = F::one() / self.root;
        Rates { x: x - spin * (place * upright * upright), y, spin: spin * c }
    }

    /// Forces of the bristles of the strip at `Y` of half length `C`, its moment and its share in
    /// adhesion, each over its share of `μ N`.
    pub fn strip(&self, rates: [F; 3], place: F, c: F) -> [F; 4] {
        let upright = F::one() / self.root;
        let StripForces { fx, fy, mx, stick } = self.rates_at(rates, place, c).of_strip();
        [fx, fy, mx * (c * self.root) - fx * (place * upright), stick]
    }

    #[inline]
    fn forces_of_rates(&self, rates: [F; 3]) -> [F; 4] {
        with_avx!(if F::LANES => <F: Real>(layer: &Layer<F> = self, rates: [F; 3]) -> [F; 4] {
            if cfg!(target_os = "none") {
                layer.values_of::<Lanes<F, 1>>(rates)
            } else {
                layer.values_of::<F::Four>(rates)
            }
        } {
            layer.values_of::<F::WideFour>(rates)
        })
    }

    #[inline]
    fn slopes(&self, rates: [F; 3]) -> RateSlopes<F> {
        with_avx!(if F::LANES => <F: Real>(
            layer: &Layer<F> = self, rates: [F; 3]
        ) -> RateSlopes<F> {
            if cfg!(target_os = "none") {
                layer.slopes_of::<Lanes<F, 1>>(rates)
            } else {
                layer.slopes_of::<F::Four>(rates)
            }
        } {
            layer.slopes_of::<F::WideFour>(rates)
        })
    }

    #[inline]
    fn values_of<P: Strips<F>>(&self, rates: [F; 3]) -> [F; 4] {
        self.sums(rates, [P::zero(); 3]).map(Strips::total)
    }

    #[inline(always)]
    fn slopes_of<P: Strips<F>>(&self, rates: [F; 3]) -> RateSlopes<F> {
        let one = |at: usize| {
            let gradient = [0, 1, 2].map(|i| if i == at { P::constant(1.0) } else { P::zero() });
            Dual { value: P::zero(), gradient }
        };
        let sums: [Dual<P, 3>; 4] = self.sums(rates, [one(0), one(1), one(2)]);
        let total = |sum: Dual<P, 3>| Dual {
            value: sum.value.total(),
            gradient: sum.gradient.map(Strips::total),
        };
        sums.map(total)
    }

    /// Sums over the strips: forces, moment, share in adhesion. `by` are the variables that the
    /// rates stand for.
    #[inline(always)]
    fn sums<P: Strips<F>, T: Arithmetic<Value = P>>(&self, rates: [F; 3], by: [T; 3]) -> [T; 4] {
        if P::COUNT == 4 {
            return self.sums_from(rates, by, 0);
        }
        // One strip after the other, which needs less flash: in the order of [`Strips::total`].
        let mut halves = [[T::zero(); 4]; 2];
        for lane in [0, 2, 1, 3] {
            if let Some(half) = halves.get_mut(lane & 1) {
                add(half, self.sums_from(rates, by, lane));
            }
        }
        let [mut first, second] = halves;
        add(&mut first, second);
        first
    }

    /// The sums over the strips of every four from `lane` on, as many side by side as `P` has.
    #[inline(always)]
    fn sums_from<P: Strips<F>, T: Arithmetic<Value = P>>(
        &self, rates: [F; 3], by: [T; 3], lane: usize,
    ) -> [T; 4] {
        let [x, y, spin] = rates.map(P::all);
        let (one, zero) = (P::constant(1.0), P::zero());
        let (root, upright) = (P::all(self.root), P::all(F::one() / self.root));
        let mut sums = [T::zero(); 4];
        for four in table!(F, TWELVE_STRIPS) {
            let field = |from: usize| P::of_list(four.get(from + lane..).unwrap_or_default());
            let [place, c, load] = [field(0), field(4), field(8)];
            // (υx − φ y, υy + φ x): over the bound of the strip per half length, x in half lengths
            let arm = -(place * upright * upright);
            let strip = Rates {
                x: T::composed(x + spin * arm, [one, zero, arm], by),
                y: T::composed(y, [zero, one, zero], by),
                spin: T::composed(spin * c, [zero, zero, c], by),
            };
            let rows = table!(F, STEP_ROWS)
                .iter()
                .map(|row| row.each_ref().map(|x| P::all(F::stored(*x))));
            let StripForces { fx, fy, mx, stick } = strip.forces_of_strip(rows);
            // Mz = ∫ (x Y − y X)
            let mz = mx.scale(load * c * root) - fx.scale(load * place * upright);
            add(&mut sums, [fx.scale(load), fy.scale(load), mz, stick.scale(load)]);
        }
        sums
    }
}

impl<T: Number> Rates<T> {
    /// Rates of any size, scaled down together where all slides.
    fn within_limit(&self) -> Self {
        let limit = T::Base::of(largest_rate::<T>());
        let [x, y, spin] = scaled_down([self.x, self.y, self.spin], limit);
        Self { x, y, spin }
    }

    /// Forces of one strip, for rates of any size.
    pub fn of_strip(&self) -> StripForces<T> {
        let rows = table!(T::Base, STEP_ROWS)
            .iter()
            .map(|row| row.each_ref().map(|x| T::Base::stored(*x)));
        let StripForces { fx, fy, mx, stick } = self.within_limit().forces_of_strip(rows);
        let kept = (fx.squared() + fy.squared()).max(T::one()).sqrt().inverse();
        StripForces { fx: fx * kept, fy: fy * kept, mx: mx * kept, stick }
    }
}

impl<F: Float> Rates<F> {
    /// The state of the bristle at `x`.
    pub fn at(&self, x: F) -> BristleState<F> {
        let place = x.clamped(-F::one(), F::one());
        let rows = table!(F, STEP_ROWS).iter().map(|row| row.each_ref().map(|x| F::stored(*x)));
        let (traction, sticks) = self.within_limit().traction(rows, place);
        let [tx, ty] = traction;
        let size = (tx * tx + ty * ty).sqrt();
        if sticks || size <= F::zero() {
            return BristleState { traction, slip: [F::zero(); 2], slides: false };
        }
        // n (s·n − dg/du)
        let (nx, ny) = (tx / size, ty / size);
        let slip = (self.x * nx + (self.y + self.spin * place) * ny - place / size).max(F::zero());
        BristleState { traction, slip: [nx * slip, ny * slip], slides: slip > F::zero() }
    }
}
