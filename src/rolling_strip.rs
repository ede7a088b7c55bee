//! Strips that follow the slip: the corrected strip theory, with fields.
//!
//! The strip theory of 1967 knows two states of a strip, one separatrix, and one direction of sliding. Here
//! each strip is marched from its leading to its trailing edge, so that stick may begin anywhere and
//! the sliding direction turns with the rigid slip, and the linear slopes are those of Kalker's
//! coefficients. Two ideas carry it.
//!
//! **The march.** With `x̂ = x/c` and the parabola `B = 1 − x̂²` as the bound, the simplified theory
//! (Kalker 1982) integrates `dp = (A_x, A_y + 2 σ x̂) (−dx̂)` and cuts `p` back to `B` where it is larger.
//! In a sticking strip `p/B = A/(1 + x̂) + (0, σ)`, and for spin alone or creepage alone its separatrix
//! `1 + x̂ = A` is that of the strip theory: `A = 2κ/c`, `σ = ψ`.
//!
//! **The half-ellipses.** The strip theory's traction over the friction bound, `α (1 − R)` and
//! `β (1 − R) + ψ` with `R = √(h² − x'²)/√(c² − x²) = √(1 − 2κ/(c + x))` (5.1), is a function of the same
//! quotient: with `w = |p|/B`, `R = √(1 − w)`,
//!
//! ```text
//! traction/(μ Z) = r + (p/B − r)/(1 + R),   r = (0, σ) squashed to |r| < 1.
//! ```
//!
//! So the march decides on stick and slip, and the tractions are Kalker's half-ellipses: exactly for
//! creepage without spin. The result lies between `r` and `p/B`, hence within the friction bound. `R` is
//! approximated by a polynomial in `w` with a finite slope at the separatrix, and the cut at the bound
//! is rounded over `±4 %`, so that forces are once continuously differentiable.
//!
//! **The patch.** `A_x = (a_x − ρ Y (1 + ε (0.4 − Y²)))/Π`, `A_y = a_y/Π`, `σ C/Π` with `Y = y/b`,
//! `C = c/a` and the strip's share `Π` of the friction bound's peak (`Π = C` on an ellipse). `a_x, a_y, ρ, σ`
//! follow from the linear coefficients `C11, C22, C23, C33`, multiplied by factors near one that
//! a small network computes from squashed dimensionless numbers; its constants are fitted to
//! 16 000 cases computed with CONTACT by `fit/fit_strip.py`.
//!
//! What holds whatever the constants: `|traction| ≤ μ Z` and `|F| ≤ μ N`; the forces of the linear theory for small
//! creepage (corrections carry the weight `n²/(0.05 + n²)`, `n` the linear force); for large creepage the
//! local rigid slip directs the traction; the symmetries of the contact; continuity in all inputs.
//! Nothing but `+ − × ÷ √`.

mod constants;
mod nodes;

pub use self::nodes::Placed;

use self::constants::{HIDDEN, HIDDEN_OFFSET, OUTPUT, OUTPUT_OFFSET, ROUNDING, SHAPE};
use crate::coefficients::LinearCoefficients;
use crate::real::{Arithmetic, Float, Real};
use core::f64::consts::{FRAC_1_SQRT_2, PI};

/// Steps of the march along a strip.
pub const STEPS: usize = 10;
const FEATURES: usize = 13;
const UNITS: usize = 20;
const CORRECTIONS: usize = 8;

/// Creepages beyond this are scaled down together: full sliding. Fourth powers still fit an `f32`.
const CREEPAGE_LIMIT: f64 = 1e4;
/// Axis ratios the model is evaluated with; fitted are 0.07 to 14.
const RATIO_LIMIT: f64 = 1e3;
/// Linear force in `μ N` where the flexibilities have become those of the rigid slip, half and half.
const SATURATION: f64 = 12.0;
/// Keeps the derivative of the root finite where no traction acts.
const NO_TRACTION: f64 = 1e-30;

/// One step of the march, from `x̂₀` down to `x̂₁`.
#[derive(Clone, Copy, Debug)]
pub struct Step<F> {
    /// `x̂₁ = cos((j − ½) π/10)`; the leading edge is `x̂ = 1`.
    pub x: F,
    /// `x̂₀ − x̂₁`
    pub length: F,
    /// Its square.
    pub square: F,
    /// `x̂₀² − x̂₁²`
    pub turn: F,
    /// `B = 1 − x̂₁²`
    pub bound: F,
    /// `1/B`
    pub inverse: F,
}

/// Constants in the precision of the caller, so that single-precision firmware carries no others.
pub trait Marched: Float {
    /// The steps from the leading edge on.
    const STEPS: [Step<Self>; STEPS];
    /// First layer of the fitted network.
    const HIDDEN: [[Self; UNITS]; FEATURES];
    /// Offsets of its units.
    const HIDDEN_OFFSET: [Self; UNITS];
    /// Second layer.
    const OUTPUT: [[Self; CORRECTIONS]; UNITS];
    /// Offsets of the corrections.
    const OUTPUT_OFFSET: [Self; CORRECTIONS];
}

macro_rules! marched {
    ($float:ident) => {
        #[allow(clippy::unnecessary_cast, clippy::indexing_slicing)]
        impl Marched for $float {
            const STEPS: [Step<Self>; STEPS] = {
                let mut steps = [Step {
                    x: 0.0,
                    length: 0.0,
                    square: 0.0,
                    turn: 0.0,
                    bound: 0.0,
                    inverse: 0.0,
                }; STEPS];
                let mut before = 1.0;
                let mut j = 0;
                while j < STEPS {
                    let x: f64 = if j < 5 { COSINES[j] } else { -COSINES[STEPS - 1 - j] };
                    let bound = 1.0 - x * x;
                    steps[j] = Step {
                        x: x as $float,
                        length: (before - x) as $float,
                        square: ((before - x) * (before - x)) as $float,
                        turn: (before * before - x * x) as $float,
                        bound: bound as $float,
                        inverse: (1.0 / bound) as $float,
                    };
                    before = x;
                    j += 1;
                }
                steps
            };
            const HIDDEN: [[Self; UNITS]; FEATURES] = narrow!($float, HIDDEN, FEATURES, UNITS);
            const HIDDEN_OFFSET: [Self; UNITS] = narrow!($float, [HIDDEN_OFFSET], 1, UNITS)[0];
            const OUTPUT: [[Self; CORRECTIONS]; UNITS] =
                narrow!($float, OUTPUT, UNITS, CORRECTIONS);
            const OUTPUT_OFFSET: [Self; CORRECTIONS] =
                narrow!($float, [OUTPUT_OFFSET], 1, CORRECTIONS)[0];
        }
    };
}

macro_rules! narrow {
    ($float:ident, $table:expr, $rows:expr, $columns:expr) => {{
        let table = $table;
        let mut copy = [[0.0; $columns]; $rows];
        let mut i = 0;
        while i < $rows {
            let mut j = 0;
            while j < $columns {
                copy[i][j] = table[i][j] as $float;
                j += 1;
            }
            i += 1;
        }
        copy
    }};
}

/// `cos((j − ½) π/10)`, `j = 1 … 5`.
const COSINES: [f64; 5] = [
    0.9876883405951378,
    0.8910065241883679,
    FRAC_1_SQRT_2,
    0.4539904997395468,
    0.15643446504023087,
];

marched!(f64);
marched!(f32);

/// Geometry of one strip, dimensionless.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripGeometry<F> {
    /// `Y = y/b` of its centre line, −1 to 1.
    pub y: F,
    /// Half length over the patch's, `C = c/a`, positive.
    pub half_length: F,
    /// Peak of the strip's friction bound over that of the patch: `Π = (μ p₀)_strip/(μ p₀)`, positive. On
    /// an ellipse with one coefficient of friction `Π = C`.
    pub bound: F,
}

/// Creepages that a strip sees, in units of its own bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripCreepage<T> {
    /// `A_x = 2κ/c` of longitudinal creepage and spin.
    pub longitudinal: T,
    /// `A_y` of lateral creepage.
    pub lateral: T,
    /// Spin `σ`, the strip theory's `ψ`.
    pub spin: T,
}

/// What `N` strips carry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripForces<T, const N: usize> {
    /// Longitudinal force over the strip's friction bound `μ N_strip`.
    pub fx: [T; N],
    /// Lateral force over the strip's friction bound.
    pub fy: [T; N],
    /// `∫ x̂ Y dx̂` over the friction bound: moment of the lateral traction in half lengths.
    pub mx: [T; N],
    /// Share of the strip's length in adhesion, 0 to 1; zero when not asked for.
    pub stick: [T; N],
}

/// Totals of the contact, dimensionless, on the lower body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StripTotals<T> {
    /// `Fx/(μ N)`
    pub fx: T,
    /// `Fy/(μ N)`
    pub fy: T,
    /// `Mz/(μ N √(a b))`, about the centre of the contact.
    pub mz: T,
    /// Share of the contact area in adhesion, 0 to 1; zero when not asked for.
    pub stick: T,
}

/// The tangential state of a point of a strip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripTraction<T> {
    /// Traction on the lower body along `x` over the local friction bound `μ Z`.
    pub x: T,
    /// Traction along `y` over `μ Z`; the length of the vector is at most 1.
    pub y: T,
    /// Slip of the upper over the lower body along `x`, in the units of the creepages given.
    pub slip_x: T,
    /// Slip along `y`.
    pub slip_y: T,
    /// Whether the point slips.
    pub slips: bool,
}

/// The strips of one contact under given creepages.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingStrips<T: Real> {
    /// `a_x`: longitudinal creepage in the middle strip.
    pub longitudinal: T,
    /// `a_y`: lateral creepage.
    pub lateral: T,
    /// `ρ`: how the longitudinal creepage falls over `Y`.
    pub slope: T,
    /// `ε`: profile of that slope.
    pub profile: T,
    /// `σ`: spin.
    pub spin: T,
    /// The creepages `vx, vy, φ` that these belong to.
    pub creepage: [T; 3],
    /// `√(a/b)`
    root: T::Base,
}

impl<T: Real> RollingStrips<T>
where
    T::Base: Marched,
{
    /// From creepages `vx, vy = G a b (υx, υy)/(μ N)` and spin `φ = G (a b)^{3/2} ϕ/(μ N)`.
    ///
    /// `axis_ratio` is `a/b`, `linear` the coefficients for it. Fitted for `a/b` 0.1 to 10, `ν` 0 to 1/2 and
    /// `|ψ| = (π/3) √(a/b) |φ| ≤ 3`; beyond that finite, bounded and with the right limits.
    #[must_use]
    #[inline]
    pub fn new(
        axis_ratio: T::Base,
        poisson_ratio: T::Base,
        linear: &LinearCoefficients<T::Base>,
        creepage: [T; 3],
    ) -> Self {
        const K: f64 = 8.0 / (3.0 * PI);
        let one = T::one();
        let g = axis_ratio.clamped(T::Base::of(1.0 / RATIO_LIMIT), T::Base::of(RATIO_LIMIT));
        let root = g.sqrt();
        let upright = T::Base::one() / root;
        let LinearCoefficients { c11, c22, c23, c33 } = *linear;
        let [vx, vy, phi] = within_range(creepage);

        // forces of the linear theory
        let [lx, ly, ls] = [vx.scale(c11), vy.scale(c22), phi.scale(c23)];
        let [sx, sy, ss] = [lx, ly, ls].map(magnitude);
        let t2 = lx * lx + ly * ly;
        let q2 = t2 + ls * ls;

        // rigid slip: translation against spin at the ends of the axes
        let (px, py) = (phi.scale(upright), phi.scale(root));
        let (x2, px2, y2, py2) = (vx * vx, px * px, vy * vy, py * py);
        let inverse_y = one / (y2 + py2).plus(0.02);
        let features = [
            (x2 - px2) / (x2 + px2).plus(0.02),
            (vy * py).times(2.0) * inverse_y,
            (y2 - py2) * inverse_y,
            T::from_base((root.plus(-1.0) / root.plus(1.0)).times(2.0)),
            T::from_base(poisson_ratio.times(4.0).plus(-1.0)),
            sx.plus(-1.0) / sx.plus(1.0),
            sy.plus(-1.0) / sy.plus(1.0),
            ss.plus(-1.0) / ss.plus(1.0),
            ls * ly / (ss.plus(0.1) * sy.plus(1.0)),
            t2.plus(-0.1) / t2.plus(0.1),
            ss.plus(-0.3) / ss.plus(0.3),
            ss.plus(-2.0) / ss.plus(2.0),
            q2.plus(-1.0) / q2.plus(1.0),
        ];
        let [o_x, o_y, o_slope, o_spin, o_share, spin_share, lateral_share, o_profile] =
            network(&features);

        // w = n²/(0.05 + n²): no correction of the linear forces
        let w = q2 / q2.plus(0.05);
        // χ = n⁴/(n⁴ + 12⁴): from the contact's own flexibilities to those that follow the rigid slip
        let q4 = q2 * q2;
        let chi = q4 / q4.plus(SATURATION * SATURATION * SATURATION * SATURATION);
        let elastic = one - chi;
        let rigid = chi.scale((c11 + c22).times(4.0 / (3.0 * PI)));

        let [e_x, e_y, e_spin, e_share] = [o_x * w, o_y * w, o_spin * w, o_share * w].map(positive);
        let lateral = ly * e_y;
        // a_x = (8/3π) C11 vx e_x
        let longitudinal = elastic * (lx * e_x).times(K) + rigid * vx;
        // a_y = (8/3π) (C22 vy e_y (1 + τ) + C23 φ e_s β/(1 + |C23 φ|))
        let lateral_creepage = elastic
            * (lateral * lateral_share.plus(1.0) + spin_share * e_share * ls / ss.plus(1.0))
                .times(K)
            + rigid * vy;
        // σ = C23 φ e_σ (1 − β) − C22 vy e_y τ
        let spin = elastic * (ls * (one - spin_share) * e_spin - lateral_share * lateral)
            + (rigid * py).times(0.5);
        // ρ = (32/3π) √(a/b) C33 φ e_ρ
        let slope =
            elastic * (py.scale(c33) * positive(o_slope)).times(32.0 / (3.0 * PI)) + rigid * px;
        let profile = elastic * o_profile / o_profile.squared().plus(1.0).sqrt();
        Self {
            longitudinal,
            lateral: lateral_creepage,
            slope,
            profile,
            spin,
            creepage: [vx, vy, phi],
            root,
        }
    }

    /// `a/b`, within the limits of the model.
    #[must_use]
    pub fn axis_ratio(&self) -> T::Base {
        self.root * self.root
    }

    /// What a strip sees of the creepages.
    #[must_use]
    #[inline(always)]
    pub fn strip(&self, strip: &StripGeometry<T::Base>) -> StripCreepage<T> {
        let inverse = T::Base::one() / strip.bound;
        let y = strip.y;
        // A_x = (a_x − ρ Y (1 + ε (0.4 − Y²)))/Π
        let profile = self.profile.scale((T::Base::of(0.4) - y * y) * y).shift(y);
        StripCreepage {
            longitudinal: (self.longitudinal - self.slope * profile).scale(inverse),
            lateral: self.lateral.scale(inverse),
            spin: self.spin.scale(strip.half_length * inverse),
        }
    }

    /// Forces of the strips of the Hertz ellipse, `N` = 4, 8, 16, 32 or 64, ascending in `y`.
    ///
    /// `STICK` tells whether to compute the share in adhesion (about a tenth of the time).
    #[must_use]
    #[inline]
    pub fn ellipse<const N: usize, const STICK: bool>(&self) -> StripForces<T, N>
    where
        T::Base: Placed<N>,
    {
        let rule = &<T::Base as Placed<N>>::RULE;
        let mut ax = [T::zero(); N];
        let mut ay = [T::zero(); N];
        // creepages scaled so that the quadrature gives the linear forces exactly
        let longitudinal = self.longitudinal.scale(rule.stretch);
        let lateral = self.lateral.scale(rule.stretch);
        let slope = self.slope.scale(rule.lever);
        let strips = rule.y.iter().zip(&rule.inverse).zip(&rule.bend);
        for ((ax, ay), ((y, inverse), bend)) in ax.iter_mut().zip(&mut ay).zip(strips) {
            let profile = self.profile.scale(*bend).shift(*y);
            *ax = (longitudinal - slope * profile).scale(*inverse);
            *ay = lateral.scale(*inverse);
        }
        march::<T, N, STICK>(&ax, &ay, Uniform(self.spin))
    }

    /// Totals of the Hertz ellipse.
    #[must_use]
    #[inline]
    pub fn totals<const N: usize, const STICK: bool>(&self) -> StripTotals<T>
    where
        T::Base: Placed<N>,
    {
        let forces = self.ellipse::<N, STICK>();
        self.sum::<N, STICK>(&forces)
    }

    /// Totals from the forces of the strips of the Hertz ellipse.
    #[must_use]
    #[inline]
    pub fn sum<const N: usize, const STICK: bool>(
        &self,
        forces: &StripForces<T, N>,
    ) -> StripTotals<T>
    where
        T::Base: Placed<N>,
    {
        let rule = &<T::Base as Placed<N>>::RULE;
        let fx = weighted(&forces.fx, &rule.load);
        let fy = weighted(&forces.fy, &rule.load);
        let by_y = weighted(&forces.fx, &rule.moment_y);
        let by_x = weighted(&forces.mx, &rule.moment_x);
        let stick = if STICK { weighted(&forces.stick, &rule.area) } else { T::zero() };
        // Mz = ∫ (x Y − y X): lever arms √(a/b) C x̂ and √(b/a) Y
        let mz = by_x.scale(self.root) - by_y.scale(T::Base::one() / self.root);
        StripTotals { fx, fy, mz, stick }
    }

    /// Frictional power of a strip of the ellipse per unit of its friction bound and of the creepages: force
    /// times rigid slip. The strips' sum, weighted with their bounds, is `fx vx + fy vy + mz φ`.
    #[must_use]
    #[inline]
    pub fn power(&self, strip: &StripGeometry<T::Base>, fx: T, fy: T, mx: T) -> T {
        let [vx, vy, phi] = self.creepage;
        let across = strip.y / self.root;
        fx * (vx - phi.scale(across)) + fy * vy + mx * phi.scale(self.root * strip.half_length)
    }

    /// Traction, state and slip at `x̂ = x/c` of a strip, −1 to 1.
    ///
    /// The same march, its last step cut short at the point: the values at the steps' ends are those that
    /// the forces are summed from.
    #[must_use]
    pub fn traction(&self, strip: &StripGeometry<T::Base>, place: T::Base) -> StripTraction<T> {
        let creepage = self.strip(strip);
        let bias = squashed(creepage.spin);
        let place = place.clamped(-T::Base::one(), T::Base::one());
        let mut state = March::start();
        let mut before = T::Base::one();
        // slip over rigid slip at the end of the last whole step; the first step's at the leading edge
        let mut behind: Option<T> = None;
        let mut ahead = T::zero();
        let mut after = -T::Base::one();
        let mut here = None;
        for step in &T::Base::STEPS {
            let (next, cut) = state.step(&creepage, step);
            ahead = slip_share(&creepage, step, cut);
            after = step.x;
            if place >= step.x {
                here = Some(state);
                break;
            }
            behind = Some(ahead);
            before = step.x;
            state = next;
        }
        let state = here.unwrap_or(state);
        let length = before - place;
        let bound = (T::Base::one() - place * place).max(T::Base::of(1e-12));
        let step = Step {
            x: place,
            length,
            square: length * length,
            turn: (before - place) * (before + place),
            bound,
            inverse: T::Base::one() / bound,
        };
        let (next, cut) = state.step(&creepage, &step);
        let half = half_ellipses(cut.reached);
        let x = (next.px * half).scale(step.inverse);
        let y = bias + (next.py.scale(step.inverse) - bias) * half;

        let behind = behind.unwrap_or(ahead);
        let share = if here.is_some() {
            let part = (before - place) / (before - after);
            behind + (ahead - behind).scale(part)
        } else {
            behind
        };
        let [vx, vy, phi] = self.creepage;
        let rigid_x = vx - phi.scale(strip.y / self.root);
        let rigid_y = vy + phi.scale(self.root * strip.half_length * place);
        let rigid = (rigid_x.squared() + rigid_y.squared()).plus(NO_TRACTION).sqrt();
        // no slip at the separatrix, whatever the step says
        let onset = cut.trial.plus(-1.0).scale(T::Base::one() / T::Base::of_f32(ROUNDING));
        let onset = onset.max(T::zero()).min(T::one());
        let size = (x * x + y * y).plus(NO_TRACTION).sqrt();
        let slip = share * onset * rigid / size;
        StripTraction { x, y, slip_x: slip * x, slip_y: slip * y, slips: cut.trial > T::one() }
    }
}

/// `Σ wᵢ xᵢ`, in four chains of additions that a vector unit takes together.
#[inline(always)]
fn weighted<T: Arithmetic, const N: usize>(values: &[T; N], weights: &[T::Base; N]) -> T {
    let mut sums = [T::zero(); 4];
    for (values, weights) in values.chunks(4).zip(weights.chunks(4)) {
        for ((sum, value), weight) in sums.iter_mut().zip(values).zip(weights) {
            *sum += value.scale(*weight);
        }
    }
    let [a, b, c, d] = sums;
    (a + c) + (b + d)
}

/// Slip over rigid slip on a step: what was cut off over what was offered.
#[inline]
fn slip_share<T: Arithmetic>(creepage: &StripCreepage<T>, step: &Step<T::Base>, cut: Cut<T>) -> T {
    let offered_x = creepage.longitudinal;
    let offered_y = creepage.lateral + (creepage.spin + creepage.spin).scale(step.x);
    let offered = (offered_x * offered_x + offered_y * offered_y).plus(NO_TRACTION).sqrt();
    let excess = (cut.trial.plus(-1.0)).max(T::zero()).scale(step.bound);
    (excess / offered.scale(step.length)).min(T::one())
}

/// A number of every strip.
pub trait PerStrip<T>: Copy {
    /// The same for a function of the numbers.
    type Mapped: PerStrip<T>;
    /// Of strip `i`.
    fn of(&self, i: usize) -> T;
    /// A function of the numbers.
    fn mapped(&self, function: impl Fn(T) -> T) -> Self::Mapped;
}

/// One number for all strips, as the spin on a Hertz ellipse.
#[derive(Clone, Copy, Debug)]
pub struct Uniform<T>(pub T);

impl<T: Arithmetic> PerStrip<T> for Uniform<T> {
    type Mapped = Self;
    #[inline(always)]
    fn of(&self, _: usize) -> T {
        self.0
    }
    #[inline(always)]
    fn mapped(&self, function: impl Fn(T) -> T) -> Self {
        Self(function(self.0))
    }
}

impl<T: Arithmetic, const N: usize> PerStrip<T> for [T; N] {
    type Mapped = Self;
    #[inline(always)]
    fn of(&self, i: usize) -> T {
        self.get(i).copied().unwrap_or(T::zero())
    }
    #[inline(always)]
    fn mapped(&self, function: impl Fn(T) -> T) -> Self {
        self.map(function)
    }
}

/// Marches `N` strips from the leading edge together: strips are the inner loop, for the vector units.
#[must_use]
#[inline(always)]
pub fn march<T: Arithmetic, const N: usize, const STICK: bool>(
    ax: &[T; N],
    ay: &[T; N],
    spin: impl PerStrip<T>,
) -> StripForces<T, N>
where
    T::Base: Marched,
{
    let zero = [T::zero(); N];
    let (mut px, mut py, mut kept) = (zero, zero, [T::one(); N]);
    let (mut fx, mut fy, mut mx, mut stick) = (zero, zero, zero, zero);
    let bias = spin.mapped(squashed);
    let mut reached = zero;
    let mut last = zero;
    let mut before = T::Base::one();
    let (mut t, mut w) = (zero, zero);
    for step in &T::Base::STEPS {
        // Three short loops over the strips instead of one: the root, the quotient and the polynomial of
        // one strip wait for each other, those of different strips do not.
        let strips = ax.iter().zip(ay).enumerate();
        let states = px.iter_mut().zip(&mut py).zip(&kept).zip(&mut t);
        for ((i, (ax, ay)), (((px, py), kept), t)) in strips.zip(states) {
            let creepage = StripCreepage { longitudinal: *ax, lateral: *ay, spin: spin.of(i) };
            (*px, *py, *t) = offer([*px, *py, *kept], &creepage, step);
        }
        for ((t, w), kept) in t.iter_mut().zip(&mut w).zip(&mut kept) {
            let cut;
            (cut, *kept) = cut_back(*t, step);
            *w = cut.reached;
            if STICK {
                *t = cut.trial;
            }
        }
        let states = px.iter_mut().zip(&mut py).zip(&kept).zip(&w).enumerate();
        let forces = fx.iter_mut().zip(&mut fy).zip(&mut mx);
        for ((i, (((px, py), kept), w)), ((fx, fy), mx)) in states.zip(forces) {
            *px = *px * *kept;
            *py = *py * *kept;
            // B times traction/(μ Z) = r B + (p − r B)/(1 + R)
            let half = half_ellipses(*w);
            let floor = bias.of(i).scale(step.bound);
            let y = floor + (*py - floor) * half;
            *fx += *px * half;
            *fy += y;
            *mx += y.scale(step.x);
        }
        if STICK {
            let sticks = stick.iter_mut().zip(&mut reached).zip(&mut last);
            for (((stick, reached), last), (trial, w)) in sticks.zip(t.iter().zip(&w)) {
                // share of the step that sticks: the bound is met between its ends
                let span = trial.max(T::one()) - *reached;
                *last = (T::constant(1.02) - *reached) / span.plus(0.02);
                *stick += last.scale(step.length.times(0.5));
                *reached = *w;
            }
        }
        before = step.x;
    }
    // (2/π) ∫ √(1 − x̂²) f dx̂ by the midpoint rule in the angle
    const WEIGHT: f64 = 2.0 / STEPS as f64;
    if STICK {
        for (stick, last) in stick.iter_mut().zip(&last) {
            *stick += last.scale(before.plus(1.0).times(0.5));
        }
    }
    let [fx, fy, mx] = [fx, fy, mx].map(|force| force.map(|x| x.times(WEIGHT)));
    StripForces { fx, fy, mx, stick }
}

/// State of a strip at the end of a step.
#[derive(Clone, Copy)]
struct March<T> {
    /// `p_x`, simplified theory, in units of the strip's parabola.
    px: T,
    /// `p_y`
    py: T,
    /// Share of the last increment that was kept: 1 in adhesion.
    kept: T,
}

/// The cut at the bound.
#[derive(Clone, Copy)]
struct Cut<T> {
    /// `|p|/B` before it.
    trial: T,
    /// `w = |p|/B` after it.
    reached: T,
}

impl<T: Arithmetic> March<T> {
    /// At the leading edge.
    fn start() -> Self {
        Self { px: T::zero(), py: T::zero(), kept: T::one() }
    }

    /// The next step: increment, then cut back to the bound.
    #[inline(always)]
    fn step(self, creepage: &StripCreepage<T>, step: &Step<T::Base>) -> (Self, Cut<T>) {
        let (px, py, t) = offer([self.px, self.py, self.kept], creepage, step);
        let (cut, m) = cut_back(t, step);
        (Self { px: px * m, py: py * m, kept: m }, cut)
    }
}

/// `p` after the increment of a step, and its size.
#[inline(always)]
fn offer<T: Arithmetic>(
    [px, py, kept]: [T; 3],
    creepage: &StripCreepage<T>,
    step: &Step<T::Base>,
) -> (T, T, T) {
    // exact while it sticks; where it slips, the rigid slip at the step's end gives the direction
    let turn = kept.scale(step.square).shift(step.turn - step.square);
    let px = px + creepage.longitudinal.scale(step.length);
    let py = py + creepage.lateral.scale(step.length) + creepage.spin * turn;
    (px, py, (px * px + py * py).plus(NO_TRACTION).sqrt())
}

/// The factor that brings `|p| = t` back to the bound.
#[inline(always)]
fn cut_back<T: Arithmetic>(t: T, step: &Step<T::Base>) -> (Cut<T>, T) {
    let trial = t.scale(step.inverse);
    let reached = rounded(trial);
    // the division does not wait for the rounding
    (Cut { trial, reached }, (T::one() / t) * reached.scale(step.bound))
}

/// `min(1, t)`, with a parabola between `1 − d` and `1 + d`.
#[inline(always)]
fn rounded<T: Arithmetic>(t: T) -> T {
    let d = T::Base::of_f32(ROUNDING);
    let a = t.min(T::from_base(T::Base::one() + d));
    let z = a.shift(d - T::Base::one()).max(T::zero());
    a - (z * z).scale(T::Base::of(0.25) / d)
}

/// `1/(1 + √(1 − w))`, approximately: within 0.05 and once differentiable at `w = 1`.
#[inline(always)]
fn half_ellipses<T: Arithmetic>(w: T) -> T {
    let [k0, k1, k2] = SHAPE.map(T::Base::of_f32);
    let w2 = w * w;
    let w4 = w2 * w2;
    let w8 = w4 * w4;
    (w * w.scale(k1).shift(k0)).plus(0.5) + (w8 * w8).scale(k2)
}

/// `s/(1 + s⁴)^{1/4}`, inside (−1, 1).
#[inline(always)]
fn squashed<T: Arithmetic>(s: T) -> T {
    s / s.squared().squared().plus(1.0).sqrt().sqrt()
}

/// `√(x² + 0.03²) − 0.03`
#[inline(always)]
fn magnitude<T: Arithmetic>(x: T) -> T {
    x.squared().plus(0.0009).sqrt().plus(-0.03)
}

/// `o + √(1 + o²)`, positive, 1 at 0.
#[inline(always)]
fn positive<T: Arithmetic>(o: T) -> T {
    o + o.squared().plus(1.0).sqrt()
}

/// The corrections: one layer of units `h/√(1 + h²)`.
#[inline(always)]
fn network<T: Arithmetic>(features: &[T; FEATURES]) -> [T; CORRECTIONS]
where
    T::Base: Marched,
{
    let hidden = layer(features, &T::Base::HIDDEN, &T::Base::HIDDEN_OFFSET);
    let hidden = hidden.map(|h| h / h.squared().plus(1.0).sqrt());
    layer(&hidden, &T::Base::OUTPUT, &T::Base::OUTPUT_OFFSET)
}

#[inline(always)]
fn layer<T: Arithmetic, const M: usize, const N: usize>(
    inputs: &[T; M],
    weights: &[[T::Base; N]; M],
    offsets: &[T::Base; N],
) -> [T; N] {
    let mut sums = offsets.map(T::from_base);
    for (input, row) in inputs.iter().zip(weights) {
        for (sum, weight) in sums.iter_mut().zip(row) {
            *sum += input.scale(*weight);
        }
    }
    sums
}

/// The creepages, scaled down together where their fourth powers would overflow.
#[inline(always)]
fn within_range<T: Real>([vx, vy, phi]: [T; 3]) -> [T; 3] {
    let limit = T::Base::of(CREEPAGE_LIMIT);
    let size = vx.value().abs().max(vy.value().abs()).max(phi.value().abs());
    if size > limit {
        let factor = limit / size;
        [vx.scale(factor), vy.scale(factor), phi.scale(factor)]
    } else {
        [vx, vy, phi]
    }
}

#[cfg(test)]
mod tests;
