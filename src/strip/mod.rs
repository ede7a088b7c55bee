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
//! So the march decides on stick and slip, and the tractions are Kalker's half-ellipses for creepage
//! without spin. The result lies between `r` and `p/B`, hence within the friction bound. `1/(1 + R)` is
//! replaced by `(1 + w⁴)/2`, within 0.09, which has a finite slope at the separatrix, and the cut at the bound
//! is rounded over `±8 %` of `w²`, so that forces are once continuously differentiable. Both need `w²` only:
//! one inverse root per step, and no other.
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
use self::nodes::Rule;

use self::constants::{HIDDEN, HIDDEN_OFFSET, OUTPUT, OUTPUT_OFFSET, ROUNDING};
use crate::linear::LinearCoefficients;
use crate::number::dual::Dual;
use crate::number::{Arithmetic, Float, Number, Pair, Plain, Quad, Real, Stored};
use core::f64::consts::PI;

/// Steps of the march along a strip.
pub const STEPS: usize = 7;
const FEATURES: usize = 13;
const UNITS: usize = 20;
const CORRECTIONS: usize = 8;

/// Creepages beyond this are scaled down together: full sliding. Fourth powers still fit an `f32`.
const CREEPAGE_LIMIT: f64 = 1e4;
/// Creepages of a strip in units of its own bound: beyond this it slides, and their squares fit an `f32`.
const STRIP_LIMIT: f64 = 1e9;
/// Axis ratios the model is evaluated with; fitted are 0.07 to 14.
const RATIO_LIMIT: f64 = 1e3;
/// Linear force in `μ N` where the flexibilities have become those of the rigid slip, half and half.
const SATURATION: f64 = 12.0;
/// Keeps the derivative of the root finite where no traction acts.
const NO_TRACTION: f64 = 1e-30;

/// One step of the march, from `x̂₀` down to `x̂₁`.
#[derive(Clone, Copy, Debug)]
pub struct Step<F> {
    /// `x̂₁ = cos((j − ½) π/7)`; the leading edge is `x̂ = 1`.
    pub x: F,
    /// `x̂₀ − x̂₁`
    pub length: F,
    /// Its square.
    pub square: F,
    /// `x̂₀² − x̂₁²` less the square of the length: what spin adds if the step slips.
    pub turn: F,
    /// `B = 1 − x̂₁²`
    pub bound: F,
    /// `1/B`
    pub inverse: F,
    /// `1/B²`
    pub inverse_square: F,
}

/// Constants in the precision of the caller, so that single-precision firmware carries no others.
pub trait Marched: Plain {
    /// The steps from the leading edge on.
    const STEPS: [Step<Self::Stored>; STEPS];
    /// First layer of the fitted network.
    const HIDDEN: [[Self::Stored; UNITS]; FEATURES];
    /// Offsets of its units.
    const HIDDEN_OFFSET: [Self::Stored; UNITS];
    /// Second layer.
    const OUTPUT: [[Self::Stored; CORRECTIONS]; UNITS];
    /// Offsets of the corrections.
    const OUTPUT_OFFSET: [Self::Stored; CORRECTIONS];
}

impl<F: Float> Step<F> {
    /// The same for the contacts of a number that may stand for several.
    #[inline(always)]
    fn of<T: Plain<Stored = F>>(&self) -> Step<T> {
        let Self { x, length, square, turn, bound, inverse, inverse_square } = *self;
        Step {
            x: T::stored(x),
            length: T::stored(length),
            square: T::stored(square),
            turn: T::stored(turn),
            bound: T::stored(bound),
            inverse: T::stored(inverse),
            inverse_square: T::stored(inverse_square),
        }
    }
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
                    inverse_square: 0.0,
                }; STEPS];
                let mut before = 1.0;
                let mut j = 0;
                while j < STEPS {
                    let x: f64 = if j <= STEPS / 2 { COSINES[j] } else { -COSINES[STEPS - 1 - j] };
                    let bound = 1.0 - x * x;
                    steps[j] = Step {
                        x: x as $float,
                        length: (before - x) as $float,
                        square: ((before - x) * (before - x)) as $float,
                        turn: (2.0 * x * (before - x)) as $float,
                        bound: bound as $float,
                        inverse: (1.0 / bound) as $float,
                        inverse_square: (1.0 / (bound * bound)) as $float,
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

/// A table in the caller's precision.
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

/// `cos((j − ½) π/7)`, `j = 1 … 4`.
const COSINES: [f64; STEPS.div_ceil(2)] =
    [0.9749279121818236, 0.7818314824680298, 0.4338837391175582, 0.0];

marched!(f64);
marched!(f32);

/// Of several contacts side by side: the tables of one.
#[cfg(target_arch = "x86_64")]
macro_rules! side_by_side {
    ($lanes:ident, $float:ident) => {
        impl Marched for crate::number::lanes::$lanes {
            const STEPS: [Step<$float>; STEPS] = <$float as Marched>::STEPS;
            const HIDDEN: [[$float; UNITS]; FEATURES] = <$float as Marched>::HIDDEN;
            const HIDDEN_OFFSET: [$float; UNITS] = <$float as Marched>::HIDDEN_OFFSET;
            const OUTPUT: [[$float; CORRECTIONS]; UNITS] = <$float as Marched>::OUTPUT;
            const OUTPUT_OFFSET: [$float; CORRECTIONS] = <$float as Marched>::OUTPUT_OFFSET;
        }
    };
}

#[cfg(target_arch = "x86_64")]
side_by_side!(F64x4, f64);
#[cfg(target_arch = "x86_64")]
side_by_side!(F32x8, f32);

/// The strips of a `Rule`, whatever their number: one piece of code serves every count.
#[derive(Clone, Copy, Debug)]
pub struct Strips<'a, F> {
    pub(crate) y: &'a [F],
    pub(crate) load: &'a [F],
    pub(crate) moment_x: &'a [F],
    pub(crate) area: &'a [F],
    inverse: &'a [F],
    bend: &'a [F],
    moment_y: &'a [F],
    stretch: F,
    lever: F,
    /// Of all strips, in a part of them too: forces do not need it.
    pub(crate) half_length: &'a [F],
    /// The same.
    pub(crate) width: &'a [F],
}

impl<'a, F: Copy> Strips<'a, F> {
    /// `G` strips from `first` on: the compiler knows how many.
    #[inline(always)]
    fn group<const G: usize>(&self, first: usize) -> Option<Self> {
        let group = |table: &'a [F]| -> Option<&'a [F]> {
            Some(table.get(first..)?.first_chunk::<G>()?.as_slice())
        };
        Some(Self {
            y: group(self.y)?,
            inverse: group(self.inverse)?,
            bend: group(self.bend)?,
            load: group(self.load)?,
            moment_y: group(self.moment_y)?,
            moment_x: group(self.moment_x)?,
            area: group(self.area)?,
            ..*self
        })
    }

    /// Groups of `G` strips, each with the number of its first.
    #[inline(always)]
    fn groups<const G: usize>(self) -> impl Iterator<Item = (usize, Self)> {
        let starts = (0..self.y.len()).step_by(G);
        starts.filter_map(move |first| Some((first, self.group::<G>(first)?)))
    }
}

impl<F: Copy> Strips<'_, F> {
    /// Those with `Y > 0` if they are enough.
    #[inline(always)]
    fn half(&self, symmetry: Symmetry) -> Self {
        if symmetry == Symmetry::None {
            return *self;
        }
        Self {
            y: upper_half(self.y),
            inverse: upper_half(self.inverse),
            bend: upper_half(self.bend),
            load: upper_half(self.load),
            moment_y: upper_half(self.moment_y),
            moment_x: upper_half(self.moment_x),
            area: upper_half(self.area),
            ..*self
        }
    }
}

/// What the strips at `−Y` carry.
#[derive(Clone, Copy, PartialEq)]
enum Symmetry {
    /// Something of their own.
    None,
    /// The same as those at `Y`.
    Same,
    /// The same but for the sign of `f_x`.
    Opposite,
}

impl Symmetry {
    /// Without slope the strips at `Y` and `−Y` carry the same forces; without longitudinal creepage `f_x` has the
    /// opposite sign. (Worth it, and done, from eight strips on.)
    #[inline(always)]
    fn of<F: Float>(slope: F, longitudinal: F, strips: usize) -> Self {
        if strips < 8 {
            Self::None
        } else if slope == F::zero() {
            Self::Same
        } else if longitudinal == F::zero() {
            Self::Opposite
        } else {
            Self::None
        }
    }
}

#[inline(always)]
fn upper_half<F>(table: &[F]) -> &[F] {
    table.get(table.len() / 2..).unwrap_or(&[])
}

impl<F: Copy, const N: usize> Rule<F, N> {
    pub(crate) const fn strips(&self) -> Strips<'_, F> {
        Strips {
            y: &self.y,
            half_length: &self.half_length,
            width: &self.width,
            inverse: &self.inverse,
            bend: &self.bend,
            load: &self.load,
            moment_y: &self.moment_y,
            moment_x: &self.moment_x,
            area: &self.area,
            stretch: self.stretch,
            lever: self.lever,
        }
    }
}

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

impl<T: Real> StripCreepage<T> {
    /// The same direction, no component beyond a limit.
    pub(crate) fn bounded(self) -> Self {
        let Self { longitudinal, lateral, spin } = self;
        let size = longitudinal.value().abs().max(lateral.value().abs()).max(spin.value().abs());
        let limit = T::Base::of(STRIP_LIMIT);
        if size <= limit {
            return self;
        }
        let factor = limit / size;
        Self {
            longitudinal: longitudinal.scale(factor),
            lateral: lateral.scale(factor),
            spin: spin.scale(factor),
        }
    }
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
pub struct RollingStrips<T: Number> {
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
        if !T::HAS_DERIVATIVES {
            return Self::without_derivatives(axis_ratio, poisson_ratio, linear, creepage);
        }
        let creepage = within_range(creepage);
        let root = limited_root(axis_ratio);
        // differentiated by the three creepages, then by whatever these depend on
        let values = creepage.map(T::value);
        let [vx, vy, phi] = values;
        let inputs = [Dual::input(vx, 0), Dual::input(vy, 1), Dual::input(phi, 2)];
        let contact = (root, poisson_ratio, linear);
        let [longitudinal, lateral, slope, profile, spin] =
            parameters::<_, WithSlopes>(contact, inputs)
                .map(|x| follow(x.value, &x.gradient, &creepage));
        Self { longitudinal, lateral, slope, profile, spin, creepage, root }
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

    /// Forces of the strips of the Hertz ellipse, `N` = 4, 8, 16, 32 or 64, ascending in `y`: each is
    /// handed to `take` with its number, `fx, fy, mx` and the share in adhesion of [`StripForces`].
    pub fn each_strip<const N: usize>(&self, mut take: impl FnMut(usize, [T; 4]))
    where
        T::Base: Placed<N>,
    {
        self.each(<T::Base as Placed<N>>::STRIPS, &mut take);
    }

    /// The same for the strips of any rule.
    #[inline(never)]
    pub(crate) fn each(&self, strips: &Strips<T::Base>, take: &mut dyn FnMut(usize, [T; 4])) {
        for (first, group) in strips.groups::<4>() {
            let mut apart = |_, found: [T::Quad; 4]| {
                let [fx, fy, mx, stick] = found.map(T::Quad::parts);
                let strips = fx.into_iter().zip(fy).zip(mx).zip(stick).enumerate();
                for (i, (((fx, fy), mx), stick)) in strips {
                    take(first + i, [fx, fy, mx, stick]);
                }
            };
            if Self::IN_QUADS {
                self.group::<true, 4, 1>(&group, &mut apart);
            } else {
                self.group::<true, 4, 0>(&group, &mut apart);
            }
        }
    }

    /// Totals of the Hertz ellipse.
    #[must_use]
    #[inline]
    pub fn totals<const N: usize, const STICK: bool>(&self) -> StripTotals<T>
    where
        T::Base: Placed<N>,
    {
        self.wanted_totals::<STICK, true>(<T::Base as Placed<N>>::STRIPS)
    }

    /// Totals of the strips of any rule; without `MOMENT` the moment is not computed, and zero.
    #[inline(always)]
    pub(crate) fn wanted_totals<const STICK: bool, const MOMENT: bool>(
        &self,
        strips: &Strips<T::Base>,
    ) -> StripTotals<T> {
        if T::HAS_DERIVATIVES {
            self.totals_by_slopes::<STICK>(strips)
        } else {
            self.sum::<STICK, MOMENT>(strips)
        }
    }

    /// The same, whatever the number of strips. Where they are symmetric only one half is marched: the same numbers
    /// to rounding.
    #[inline(always)]
    fn sum<const STICK: bool, const MOMENT: bool>(
        &self,
        strips: &Strips<T::Base>,
    ) -> StripTotals<T> {
        // (derivatives need not have the symmetry)
        let symmetry = if T::HAS_DERIVATIVES {
            Symmetry::None
        } else {
            Symmetry::of(self.slope.value(), self.longitudinal.value(), strips.y.len())
        };
        let half = strips.half(symmetry);
        if !Self::IN_QUADS {
            return self.sum_apart::<STICK, MOMENT, 4, 0>(&half, symmetry);
        }
        match half.y.len() {
            4 => self.sum_apart::<STICK, MOMENT, 4, 1>(&half, symmetry),
            8 => self.sum_apart::<STICK, MOMENT, 8, 2>(&half, symmetry),
            _ => self.sum_apart::<STICK, MOMENT, 16, 4>(&half, symmetry),
        }
    }

    /// (One piece of code for each size of groups.)
    #[inline(never)]
    fn sum_apart<const STICK: bool, const MOMENT: bool, const G: usize, const H: usize>(
        &self,
        strips: &Strips<T::Base>,
        symmetry: Symmetry,
    ) -> StripTotals<T> {
        self.sum_of_groups::<STICK, MOMENT, G, H>(strips, symmetry)
    }

    /// The same where derivatives are wanted: the march is differentiated by what the strips see, and that
    /// by the five numbers of the patch. The share in adhesion has no derivatives.
    #[inline(never)]
    fn totals_by_slopes<const STICK: bool>(&self, strips: &Strips<T::Base>) -> StripTotals<T> {
        let plain = RollingStrips::<T::Base> {
            longitudinal: self.longitudinal.value(),
            lateral: self.lateral.value(),
            slope: self.slope.value(),
            profile: self.profile.value(),
            spin: self.spin.value(),
            creepage: self.creepage.map(T::value),
            root: self.root,
        };
        let mut sums = SlopeSums::<<T::Base as Number>::Pair>::start();
        let (bias, bias_slope) = squashed_slope(plain.spin);
        let biases =
            (<T::Base as Number>::Pair::both(bias), <T::Base as Number>::Pair::both(bias_slope));
        let steps = SlopeStep::all(<T::Base as Number>::Pair::both(plain.spin), biases.0, biases.1);
        if !Self::IN_QUADS || strips.y.len() == 4 {
            for (_, group) in strips.groups::<4>() {
                plain.slopes::<1, 2, STICK>(&group, biases, &steps, &mut sums);
            }
        } else {
            for (_, group) in strips.groups::<8>() {
                plain.slopes::<2, 4, STICK>(&group, biases, &steps, &mut sums);
            }
        }
        let by =
            [self.longitudinal, self.slope, self.slope * self.profile, self.lateral, self.spin];
        let [fx, fy, mz] = [sums.fx, sums.fy, sums.mz].map(|sum| sum.follow(&by));
        StripTotals { fx, fy, mz, stick: T::from_base(sums.stick.sum()) }
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
        let creepage = self.strip(strip).bounded();
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
        let bound = (T::Base::one() - place * place).max(T::Base::of(1e-9));
        let step = Step {
            x: place,
            length,
            square: length * length,
            turn: (length * place) * T::Base::of(2.0),
            bound,
            inverse: T::Base::one() / bound,
            inverse_square: T::Base::one() / (bound * bound),
        };
        let (next, cut) = state.step(&creepage, &step);
        let half = (cut.reached * cut.reached).plus(1.0).times(0.5);
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
        let onset = cut.trial.plus(-1.0).times(0.25 / f64::from(ROUNDING));
        let onset = onset.max(T::zero()).min(T::one());
        let size = (x * x + y * y).plus(NO_TRACTION).sqrt();
        let slip = share * onset * rigid / size;
        StripTraction { x, y, slip_x: slip * x, slip_y: slip * y, slips: cut.trial > T::one() }
    }
}

impl<T: Number> RollingStrips<T>
where
    T::Base: Marched,
{
    /// [`RollingStrips::new`] for numbers without derivatives.
    #[inline(always)]
    pub(crate) fn without_derivatives(
        axis_ratio: T::Base,
        poisson_ratio: T::Base,
        linear: &LinearCoefficients<T::Base>,
        creepage: [T; 3],
    ) -> Self {
        let creepage = within_range(creepage);
        let root = limited_root(axis_ratio);
        let [longitudinal, lateral, slope, profile, spin] =
            parameters::<T, Forward>((root, poisson_ratio, linear), creepage);
        Self { longitudinal, lateral, slope, profile, spin, creepage, root }
    }

    /// Whether four strips are one number. Single-precision numbers on machines without registers for several of them
    /// are left to the compiler.
    const IN_QUADS: bool = cfg!(target_arch = "x86_64") || size_of::<Stored<T>>() >= 8;

    /// A group of `G` strips, in `H` quads, or with `H = 0` one by one, 4 or 8; `take` is given the number in the group
    /// of the first of each four strips, and `fx, fy, mx, stick` of the four.
    #[inline(always)]
    fn group<const STICK: bool, const G: usize, const H: usize>(
        &self,
        strips: &Strips<Stored<T>>,
        take: &mut impl Take<T::Quad>,
    ) {
        match (H, G) {
            (0, 8) => self.apart::<2, 8, STICK>(strips, take),
            (0, _) => self.apart::<1, 4, STICK>(strips, take),
            _ => self.quads::<H, STICK>(strips, take),
        }
    }

    /// What the `4 H` strips of a group see of the creepages: `A_x` and `A_y`.
    #[inline(always)]
    fn seen<const H: usize>(&self, strips: &Strips<Stored<T>>) -> ([T::Quad; H], [T::Quad; H]) {
        // creepages scaled so that the quadrature gives the linear forces exactly
        let longitudinal = T::Quad::all(self.longitudinal.scale(T::Base::stored(strips.stretch)));
        let lateral = T::Quad::all(self.lateral.scale(T::Base::stored(strips.stretch)));
        let slope = T::Quad::all(self.slope.scale(T::Base::stored(strips.lever)));
        let profile = T::Quad::all(self.profile);
        let (mut ax, mut ay) = ([T::Quad::zero(); H], [T::Quad::zero(); H]);
        let places = fours(strips.y).iter().zip(fours(strips.bend)).zip(fours(strips.inverse));
        for ((ax, ay), ((y, bend), inverse)) in ax.iter_mut().zip(&mut ay).zip(places) {
            let inverse = quad_of::<T>(inverse);
            *ax =
                (longitudinal - slope * (profile * quad_of::<T>(bend) + quad_of::<T>(y))) * inverse;
            *ay = lateral * inverse;
        }
        (ax, ay)
    }

    /// `N = 4 Q` strips side by side.
    #[inline(always)]
    fn apart<const Q: usize, const N: usize, const STICK: bool>(
        &self,
        strips: &Strips<Stored<T>>,
        take: &mut impl Take<T::Quad>,
    ) {
        let (ax, ay) = self.seen::<Q>(strips);
        let (mut x, mut y) = ([T::zero(); N], [T::zero(); N]);
        for ((x, y), (ax, ay)) in fours_mut(&mut x).zip(fours_mut(&mut y)).zip(ax.iter().zip(&ay)) {
            (*x, *y) = (ax.parts(), ay.parts());
        }
        let found = march::<T, N, STICK>(&x, &y, Uniform(self.spin));
        let forces = fours(&found.fx).iter().zip(fours(&found.fy));
        let forces = forces.zip(fours(&found.mx)).zip(fours(&found.stick));
        let mut i = 0;
        for (((fx, fy), mx), stick) in forces {
            take.take(i, T::Quad::each(&[fx, fy, mx, stick], |four| T::Quad::of(**four)));
            i += 4;
        }
    }

    /// `4 H` strips in quads.
    #[inline(always)]
    fn quads<const H: usize, const STICK: bool>(
        &self,
        strips: &Strips<Stored<T>>,
        take: &mut impl Take<T::Quad>,
    ) {
        let (ax, ay) = self.seen::<H>(strips);
        let found = march::<_, H, STICK>(&ax, &ay, Uniform(T::Quad::all(self.spin)));
        let forces = found.fx.iter().zip(&found.fy).zip(&found.mx).zip(&found.stick);
        let mut i = 0;
        for (((fx, fy), mx), stick) in forces {
            take.take(i, [*fx, *fy, *mx, *stick]);
            i += 4;
        }
    }

    /// Groups of `G` strips, as [`RollingStrips::group`] has them.
    #[inline(always)]
    fn sum_of_groups<const STICK: bool, const MOMENT: bool, const G: usize, const H: usize>(
        &self,
        strips: &Strips<Stored<T>>,
        symmetry: Symmetry,
    ) -> StripTotals<T> {
        let zero = T::Quad::zero();
        let mut sums = Sums::<T, STICK, MOMENT> { group: *strips, sums: [zero; 5] };
        for (_, group) in strips.groups::<G>() {
            sums.group = group;
            self.group::<STICK, G, H>(&group, &mut sums);
        }
        let [mut fx, mut fy, mut by_y, mut by_x, mut stick] = sums.sums;
        if symmetry != Symmetry::None {
            for sum in [&mut fx, &mut fy, &mut by_y, &mut by_x, &mut stick] {
                *sum += *sum;
            }
            if symmetry == Symmetry::Same { by_y = zero } else { fx = zero }
        }
        // Mz = ∫ (x Y − y X): lever arms √(a/b) C x̂ and √(b/a) Y
        let mz = by_x.sum().scale(self.root) - by_y.sum().scale(T::Base::one() / self.root);
        StripTotals { fx: fx.sum(), fy: fy.sum(), mz, stick: stick.sum() }
    }
}

/// Who is given what quads of strips carry: the number in the group of a quad's first strip, and `fx, fy, mx, stick` of
/// the quad.
trait Take<Q> {
    fn take(&mut self, i: usize, found: [Q; 4]);
}

impl<Q, C: FnMut(usize, [Q; 4])> Take<Q> for C {
    #[inline(always)]
    fn take(&mut self, i: usize, found: [Q; 4]) {
        self(i, found);
    }
}

/// Adds the strips of a group up: `f_x`, `f_y`, the lever arms' `Y f_x` and `C m_x`, the share in adhesion.
struct Sums<'a, T: Number, const STICK: bool, const MOMENT: bool> {
    group: Strips<'a, Stored<T>>,
    sums: [T::Quad; 5],
}

impl<T: Number, const STICK: bool, const MOMENT: bool> Sums<'_, T, STICK, MOMENT> {
    #[inline(always)]
    fn weight(table: &[Stored<T>], i: usize) -> T::Quad {
        match fours(table).get(i / 4) {
            Some(four) => quad_of::<T>(four),
            None => T::Quad::zero(),
        }
    }
}

impl<T: Number, const STICK: bool, const MOMENT: bool> Take<T::Quad>
    for Sums<'_, T, STICK, MOMENT>
{
    #[inline(always)]
    fn take(&mut self, i: usize, [x, y, m, share]: [T::Quad; 4]) {
        let [fx, fy, by_y, by_x, stick] = &mut self.sums;
        let load = Self::weight(self.group.load, i);
        *fx += x * load;
        *fy += y * load;
        if MOMENT {
            *by_y += x * Self::weight(self.group.moment_y, i);
            *by_x += m * Self::weight(self.group.moment_x, i);
        }
        if STICK {
            *stick += share * Self::weight(self.group.area, i);
        }
    }
}

/// Contacts side by side.
#[cfg(target_arch = "x86_64")]
impl<L: Marched> RollingStrips<L> {
    /// Totals as [`RollingStrips::totals`] has them, bit for bit; `None` when the contacts are not of one symmetry.
    #[inline(always)]
    pub(crate) fn totals_side_by_side<const N: usize>(
        &self,
        strips: &Strips<L::Stored>,
    ) -> Option<StripTotals<L>>
    where
        L: crate::number::lanes::Lanes<N>,
    {
        let mut kinds = self
            .slope
            .array()
            .into_iter()
            .zip(self.longitudinal.array())
            .map(|(slope, longitudinal)| Symmetry::of(slope, longitudinal, strips.y.len()));
        let symmetry = kinds.next()?;
        if !kinds.all(|kind| kind == symmetry) {
            return None;
        }
        let half = strips.half(symmetry);
        Some(if half.y.len() == 4 {
            self.sum_of_groups::<true, true, 4, 0>(&half, symmetry)
        } else {
            self.sum_of_groups::<true, true, 8, 0>(&half, symmetry)
        })
    }
}

/// `√(a/b)` within the limits of the model.
#[inline(always)]
fn limited_root<F: Plain>(axis_ratio: F) -> F {
    axis_ratio.clamped(F::of(1.0 / RATIO_LIMIT), F::of(RATIO_LIMIT)).sqrt()
}

impl<F: Float + Marched> RollingStrips<F> {
    /// Adds a group of `Q` quads of strips, `H` pairs, to the sums, with their derivatives.
    #[inline(always)]
    fn slopes<const Q: usize, const H: usize, const STICK: bool>(
        &self,
        rule: &Strips<F>,
        (bias, bias_slope): (F::Pair, F::Pair),
        steps: &[SlopeStep<F::Pair>; STEPS],
        sums: &mut SlopeSums<F::Pair>,
    ) {
        let (ax, ay) = self.seen::<Q>(rule);
        let (ax, ay) = (halves_of::<F, Q, H>(&ax), halves_of::<F, Q, H>(&ay));
        let mut strips = Together::start(&ax, &ay);
        let (spin, bias) = (Uniform(F::Pair::both(self.spin)), Uniform(bias));
        let mut cuts = [[Tried::start(); STEPS]; H];
        for (j, step) in F::STEPS.iter().enumerate() {
            let turn = Turn::new(&spin, &bias, step);
            strips.offer(&turn, step);
            strips.cut();
            if STICK {
                strips.adhere(step);
            }
            strips.note(cuts.iter_mut().filter_map(|cuts| cuts.get_mut(j)));
        }
        let mut forces = [Slopes::<F::Pair>::start(); H];
        for (forces, cuts) in forces.iter_mut().zip(&cuts) {
            forces.add(cuts, steps);
        }
        let found = strips.end::<STICK>(&bias);
        let tables =
            [rule.load, rule.moment_y, rule.moment_x, rule.area, rule.inverse, rule.y, rule.bend];
        for (i, forces) in forces.iter().enumerate() {
            let [load, by_y, by_x, area, inverse, y, bend] =
                tables.map(|table| pairs_of::<F>(table, 2 * i).next().unwrap_or(F::Pair::zero()));
            let Slopes { fx, fy, mx, .. } = forces;
            let [[x0, x1, x2, fx], [y0, y1, y2, fy], [m0, m1, m2, mx]] =
                [fx, fy, mx].map(|sums| sums.map(|sum| sum.times(WEIGHT)));
            let (x, y_slopes, m, fy) = ([x0, x1, x2], [y0, y1, y2], [m0, m1, m2], fy + bias.0);
            let by_y = by_y.scale(F::one() / self.root);
            let by_x = by_x.scale(self.root);
            // A_x = (a_x − ρ (Y + ε (0.4 − Y²) Y))/C, A_y = a_y/C
            let lever = inverse.scale(rule.lever);
            let places = [inverse.scale(rule.stretch), y * lever, bend * lever];
            let three = |slopes: [F::Pair; 3], factor: F::Pair| slopes.map(|slope| slope * factor);
            sums.fx.add(fx * load, three(x, load), places);
            sums.fy.add(fy * load, three(y_slopes, load), places);
            let [x, m] = [three(x, by_y), three(m, by_x)];
            let mut slopes = m;
            for (slope, x) in slopes.iter_mut().zip(x) {
                *slope -= x;
            }
            sums.mz.add(mx * by_x - fx * by_y, slopes, places);
            // d(r B) over the steps: Σ B = STEPS/2, Σ B x̂ = 0
            sums.fy.by_spin += load * bias_slope;
            if STICK {
                let share = found.stick.get(i).copied().unwrap_or(F::Pair::zero());
                sums.stick += share * area;
            }
        }
    }
}

/// Totals in pairs of strips, with their derivatives.
struct SlopeSums<P> {
    fx: SlopeSum<P>,
    fy: SlopeSum<P>,
    mz: SlopeSum<P>,
    stick: P,
}

/// A total with its derivatives by the numbers of the patch.
#[derive(Clone, Copy)]
struct SlopeSum<P> {
    value: P,
    by_longitudinal: P,
    by_slope: P,
    /// By `ρ ε`.
    by_bend: P,
    by_lateral: P,
    by_spin: P,
}

impl<P: Arithmetic> SlopeSums<P> {
    fn start() -> Self {
        let zero = P::zero();
        let sum = SlopeSum {
            value: zero,
            by_longitudinal: zero,
            by_slope: zero,
            by_bend: zero,
            by_lateral: zero,
            by_spin: zero,
        };
        Self { fx: sum, fy: sum, mz: sum, stick: zero }
    }
}

impl<P: Arithmetic> SlopeSum<P> {
    /// Adds strips: a value, its derivatives by `A_x, A_y, σ`, and those of `A_x` by `a_x, −ρ, −ρ ε`.
    #[inline(always)]
    fn add(&mut self, value: P, [by_x, by_y, by_spin]: [P; 3], [one, y, bend]: [P; 3]) {
        self.value += value;
        self.by_longitudinal += by_x * one;
        self.by_slope -= by_x * y;
        self.by_bend -= by_x * bend;
        self.by_lateral += by_y * one;
        self.by_spin += by_spin;
    }

    /// The total as a function of `a_x, ρ, ρ ε, a_y, σ`.
    #[inline(always)]
    fn follow<T: Real>(self, by: &[T; 5]) -> T
    where
        T::Base: Real<Pair = P, Base = T::Base>,
        P: Pair<T::Base>,
    {
        let slopes =
            [self.by_longitudinal, self.by_slope, self.by_bend, self.by_lateral, self.by_spin];
        follow(self.value.sum(), &slopes.map(Pair::sum), by)
    }
}

/// A step of a strip's march before its cut.
#[derive(Clone, Copy)]
struct Tried<T> {
    /// `p_x` and `p_y`
    p: [T; 2],
    /// The factor of the cut.
    kept: T,
    /// `(|p|/B)²`
    trial: T,
}

impl<T: Arithmetic> Tried<T> {
    #[inline(always)]
    fn start() -> Self {
        let zero = T::zero();
        Self { p: [zero; 2], kept: zero, trial: zero }
    }
}

/// The sums of a strip's march, and their derivatives by `A_x, A_y, σ` before them.
#[derive(Clone, Copy)]
struct Slopes<T> {
    fx: [T; 4],
    fy: [T; 4],
    mx: [T; 4],
}

impl<T: Arithmetic> Slopes<T> {
    #[inline(always)]
    fn start() -> Self {
        let four = [T::zero(); 4];
        Self { fx: four, fy: four, mx: four }
    }

    /// Adds the steps of a strip. Not inlined: the pairs of strips share one piece of code.
    #[inline(never)]
    fn add(&mut self, cuts: &[Tried<T>; STEPS], steps: &[SlopeStep<T>; STEPS]) {
        const D: f64 = ROUNDING as f64;
        let (mut all, zero) = (*self, T::zero());
        let (mut dx, mut dy) = ([zero; 3], [zero; 3]);
        let mut before = T::one();
        for (tried, step) in cuts.iter().zip(steps) {
            let Tried { p: [x, y], kept: m, trial: q } = *tried;
            // s'(q) = 1 − z/(2 d)
            let z = (T::constant(1.0 + D) - q.max(T::constant(1.0 - D))).max(T::zero());
            let ds = T::one() - z.times(0.5 / D);
            let m2 = m * m;
            // m = s^{−1/2}: dm = −c r, r = x dx + y dy
            let c = (m2 * m) * ds * step.inverse_square;
            let w = q * m2;
            let half = (w * w).plus(1.0);
            // dh = e r
            let dw = m2 * step.inverse_square - q * m * c;
            let e = (w * dw).times(4.0);
            let (cut_x, cut_y) = (x * m, y * m - step.floor);
            let sum = cut_y * half;
            all.fx[3] += cut_x * half;
            all.fy[3] += sum;
            all.mx[3] += sum * step.x;
            // d(h p_x) = h m dx + (e p_x − h c x) r
            let (whole, turn) = (half * m, half * c);
            let (by_x, by_y) = (e * cut_x - turn * x, e * cut_y - turn * y);
            let by_spin = before * step.square + step.turn;
            // dp = m dp − (p + what the next step turns with m) c r
            let (pull_x, pull_y) = (c * x, c * (y + step.turned));
            for i in 0..3 {
                let (mut ex, mut ey) = (dx[i], dy[i]);
                match i {
                    0 => ex += step.length,
                    1 => ey += step.length,
                    _ => ey += by_spin,
                }
                let r = x * ex + y * ey;
                dx[i] = m * ex - pull_x * r;
                dy[i] = m * ey - pull_y * r;
                all.fx[i] += whole * ex + by_x * r;
                let mut sum = whole * ey + by_y * r;
                if i == 2 {
                    sum -= half * step.floor_slope;
                }
                all.fy[i] += sum;
                all.mx[i] += sum * step.x;
            }
            before = m;
        }
        *self = all;
    }
}

/// A step of the march, for pairs of strips with one spin: read, not computed again for each of them.
#[derive(Clone, Copy)]
struct SlopeStep<T> {
    x: T,
    length: T,
    square: T,
    turn: T,
    inverse_square: T,
    /// What the next step adds to `p_y` for the share that was kept.
    turned: T,
    /// `r B` and its derivative by `σ`.
    floor: T,
    floor_slope: T,
}

impl<T: Arithmetic> SlopeStep<T>
where
    T::Base: Marched,
{
    #[inline(always)]
    fn all(spin: T, bias: T, bias_slope: T) -> [Self; STEPS] {
        let table = &T::Base::STEPS;
        let mut following = table.iter().skip(1);
        T::Base::STEPS.map(|step| {
            let next =
                following.next().map_or(T::zero(), |next| spin.scale(T::Base::stored(next.square)));
            let Step { x, length, square, turn, bound, inverse_square, .. } = step;
            let [x, length, square, turn, inverse_square] =
                [x, length, square, turn, inverse_square].map(|x| T::from_base(T::Base::stored(x)));
            let bound = T::Base::stored(bound);
            let (floor, floor_slope) = (bias.scale(bound), bias_slope.scale(bound));
            Self { x, length, square, turn, inverse_square, turned: next, floor, floor_slope }
        })
    }
}

/// `s/(1 + s⁴)^{1/4}` and its derivative `(1 + s⁴)^{−5/4}`
#[inline(always)]
fn squashed_slope<T: Arithmetic>(s: T) -> (T, T) {
    let s = limited(s);
    let inverse = T::one() / s.squared().squared().plus(1.0).sqrt().sqrt();
    let square = inverse * inverse;
    (s * inverse, square * square * inverse)
}

/// `a_x, a_y, ρ, ε, σ` from `√(a/b)`, `ν`, the linear coefficients and the creepages.
#[inline(always)]
fn parameters<T: Number, C: Corrections<T>>(
    (root, poisson_ratio, linear): (T::Base, T::Base, &LinearCoefficients<T::Base>),
    [vx, vy, phi]: [T; 3],
) -> [T; 5] {
    const K: f64 = 8.0 / (3.0 * PI);
    let one = T::one();
    let upright = T::Base::one() / root;
    let LinearCoefficients { c11, c22, c23, c33 } = *linear;

    // forces of the linear theory
    let [lx, ly, ls] = [vx.scale(c11), vy.scale(c22), phi.scale(c23)];
    let size = magnitude(T::Pair::of(lx, ly));
    let ss = magnitude(ls);
    let t2 = lx * lx + ly * ly;
    let q2 = t2 + ls * ls;
    let q4 = q2 * q2;

    // rigid slip: translation against spin at the ends of the axes
    let (px, py) = (phi.scale(upright), phi.scale(root));
    let (x2, px2, y2, py2) = (vx * vx, px * px, vy * vy, py * py);

    // every quotient (s − c)/(s + c) as 1 − 2 c/(s + c), the divisions in pairs
    let inverse = |first: T, second: T| T::Pair::of(first, second).inverse().parts();
    let (by_x, by_y) = size.plus(1.0).inverse().parts();
    let (over_x, over_y) = inverse((x2 + px2).plus(0.02), (y2 + py2).plus(0.02));
    let (by_s, by_few) = inverse(ss.plus(1.0), ss.plus(0.1));
    let (by_less, by_more) = inverse(ss.plus(0.3), ss.plus(2.0));
    let (by_t, by_q) = inverse(t2.plus(0.1), q2.plus(1.0));
    let (by_n, by_q4) = inverse(q2.plus(0.05), q4.plus(LIMIT));
    let less = |quotient: T, twice: f64| quotient.times(-twice).plus(1.0);
    let features = [
        (x2 - px2) * over_x,
        (vy * py).times(2.0) * over_y,
        (y2 - py2) * over_y,
        T::from_base((root.plus(-1.0) / root.plus(1.0)).times(2.0)),
        T::from_base(poisson_ratio.times(4.0).plus(-1.0)),
        less(by_x, 2.0),
        less(by_y, 2.0),
        less(by_s, 2.0),
        (ls * ly) * (by_few * by_y),
        less(by_t, 0.2),
        less(by_less, 0.6),
        less(by_more, 4.0),
        less(by_q, 2.0),
    ];
    let [a, b, c, d] = C::of(&features);
    let ((o_slope, o_spin), (o_share, spin_share)) = (b.parts(), c.parts());
    let (lateral_share, o_profile) = d.parts();

    // w = n²/(0.05 + n²): no correction of the linear forces
    let w = less(by_n, 0.05);
    // χ = n⁴/(n⁴ + 12⁴): from the contact's own flexibilities to those that follow the rigid slip
    const LIMIT: f64 = SATURATION * SATURATION * SATURATION * SATURATION;
    let elastic = by_q4.times(LIMIT);
    let rigid = (one - elastic).scale((c11 + c22).times(4.0 / (3.0 * PI)));

    let (e_x, e_y) = positive(a * T::Pair::both(w)).parts();
    let (e_spin, e_share) = positive(T::Pair::of(o_spin * w, o_share * w)).parts();
    let roots = T::Pair::of(o_slope, o_profile).squared().plus(1.0).sqrt();
    let (slope_root, profile_root) = roots.parts();
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
    let slope =
        elastic * (py.scale(c33) * (o_slope + slope_root)).times(32.0 / (3.0 * PI)) + rigid * px;
    let profile = elastic * o_profile / profile_root;
    [longitudinal, lateral_creepage, slope, profile, spin]
}

/// A function of some numbers, from its value and its derivatives by them, with their own derivatives.
#[inline(always)]
fn follow<T: Real, const M: usize>(value: T::Base, slopes: &[T::Base; M], by: &[T; M]) -> T {
    let mut sum = T::from_base(value);
    for (slope, x) in slopes.iter().zip(by) {
        sum += x.shift(-x.value()).scale(*slope);
    }
    sum
}

/// Slip over rigid slip on a step: what was cut off over what was offered.
#[inline]
fn slip_share<T: Arithmetic>(creepage: &StripCreepage<T>, step: &Step<T::Base>, cut: Cut<T>) -> T {
    let offered_x = creepage.longitudinal;
    let offered_y = creepage.lateral + (creepage.spin + creepage.spin).scale(step.x);
    let offered = (offered_x * offered_x + offered_y * offered_y).plus(NO_TRACTION).sqrt();
    let trial = cut.trial.plus(NO_TRACTION).sqrt();
    let excess = trial.plus(-1.0).max(T::zero()).scale(step.bound);
    (excess / offered.scale(step.length)).min(T::one())
}

/// A number of every strip.
pub trait PerStrip<T>: Copy {
    /// The same for a function of the numbers.
    type Mapped: PerStrip<T, Mapped = Self::Mapped>;
    /// Of strip `i`.
    fn of(&self, i: usize) -> T;
    /// A function of the numbers.
    fn mapped(&self, function: impl Fn(T) -> T) -> Self::Mapped;
    /// `s/(1 + s⁴)^{1/4}` of the numbers.
    fn squashed(&self) -> Self::Mapped;
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
    #[inline(always)]
    fn squashed(&self) -> Self {
        Self(squashed(self.0))
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
        T::each(self, |x| function(*x))
    }
    #[inline(always)]
    fn squashed(&self) -> Self {
        T::each(self, |x| squashed(*x))
    }
}

/// Marches `N` strips from the leading edge together.
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
    let bias = spin.squashed();
    let mut strips = Together::start(ax, ay);
    for step in &T::Base::STEPS {
        let step = &step.of::<T::Base>();
        let spin = Turn::new(&spin, &bias, step);
        strips.offer(&spin, step);
        strips.cut();
        if STICK {
            strips.adhere(step);
        }
        strips.add(&spin, step);
    }
    strips.end::<STICK>(&bias)
}

/// `(2/π) ∫ √(1 − x̂²) f dx̂` by the midpoint rule in the angle, and the half of the half-ellipses' factor.
const WEIGHT: f64 = 0.5 * (2.0 / STEPS as f64);

/// What spin does in one step.
#[derive(Clone, Copy)]
struct Turn<S> {
    /// Increment of `p_y` that does not depend on the state.
    fixed: S,
    /// Increment for the share that was kept.
    turned: S,
    /// `r B`
    floor: S,
}

impl<S> Turn<S> {
    #[inline(always)]
    fn new<T: Arithmetic>(
        spin: &impl PerStrip<T, Mapped = S>,
        bias: &impl PerStrip<T, Mapped = S>,
        step: &Step<T::Base>,
    ) -> Self {
        Self {
            fixed: spin.mapped(|spin| spin.scale(step.turn)),
            turned: spin.mapped(|spin| spin.scale(step.square)),
            floor: bias.mapped(|bias| bias.scale(step.bound)),
        }
    }
}

/// Strips side by side in their march.
#[derive(Clone, Copy)]
struct Together<'a, T, const N: usize> {
    ax: &'a [T; N],
    ay: &'a [T; N],
    px: [T; N],
    py: [T; N],
    /// Share of the last increment that was kept.
    kept: [T; N],
    /// `(|p|/B)²` before the cut.
    trial: [T; N],
    /// After the cut.
    reached: [T; N],
    fx: [T; N],
    fy: [T; N],
    mx: [T; N],
    stick: [T; N],
    last: [T; N],
}

impl<'a, T: Arithmetic, const N: usize> Together<'a, T, N>
where
    T::Base: Marched,
{
    #[inline(always)]
    fn start(ax: &'a [T; N], ay: &'a [T; N]) -> Self {
        let zero = [T::zero(); N];
        Self {
            ax,
            ay,
            px: zero,
            py: zero,
            kept: [T::one(); N],
            trial: zero,
            reached: zero,
            fx: zero,
            fy: zero,
            mx: zero,
            stick: zero,
            last: zero,
        }
    }

    /// `p` after the increment of a step: exact while it sticks; where it slips, the rigid slip at the
    /// step's end gives the direction.
    #[inline(always)]
    fn offer(&mut self, spin: &Turn<impl PerStrip<T>>, step: &Step<T::Base>) {
        let strips = self.ax.iter().zip(self.ay).enumerate();
        let states = self.px.iter_mut().zip(&mut self.py).zip(&mut self.kept).zip(&mut self.trial);
        for ((i, (ax, ay)), (((px, py), kept), trial)) in strips.zip(states) {
            *px += ax.scale(step.length);
            *py += (ay.scale(step.length) + spin.fixed.of(i)) + *kept * spin.turned.of(i);
            *trial = (*px * *px + *py * *py).scale(step.inverse_square);
            *kept = rounded(*trial);
        }
    }

    /// Notes the step, and brings `p` back to the bound.
    #[inline(always)]
    fn note<'b>(&mut self, cuts: impl Iterator<Item = &'b mut Tried<T>>) {
        let states = self.px.iter_mut().zip(&mut self.py).zip(self.kept.iter().zip(&self.trial));
        for ((((px, py), (m, q)), reached), cut) in states.zip(&mut self.reached).zip(cuts) {
            *cut = Tried { p: [*px, *py], kept: *m, trial: *q };
            (*px, *py) = (*px * *m, *py * *m);
            *reached = *q * (*m * *m);
        }
    }

    /// The factors that bring `p` back to the bound.
    #[inline(always)]
    fn cut(&mut self) {
        self.kept = T::inverse_roots(self.kept);
    }

    /// The state after the cut, and its tractions.
    #[inline(always)]
    fn add(&mut self, spin: &Turn<impl PerStrip<T>>, step: &Step<T::Base>) {
        let states = self.px.iter_mut().zip(&mut self.py).zip(&self.kept).zip(&self.trial);
        let states = states.zip(&mut self.reached).enumerate();
        let forces = self.fx.iter_mut().zip(&mut self.fy).zip(&mut self.mx);
        for ((i, ((((px, py), m), q), reached)), ((fx, fy), mx)) in states.zip(forces) {
            let w = *q * (*m * *m);
            *reached = w;
            (*px, *py) = (*px * *m, *py * *m);
            // twice B times traction/(μ Z) = r B + (p − r B)/(1 + R), without r B
            let half = (w * w).plus(1.0);
            let y = (*py - spin.floor.of(i)) * half;
            *fx += *px * half;
            *fy += y;
            *mx += y.scale(step.x);
        }
    }

    /// Share of the step that sticks: the bound is met between its ends. (Before the state after the cut is there.)
    #[inline(always)]
    fn adhere(&mut self, step: &Step<T::Base>) {
        let cuts = self.reached.iter().zip(&self.trial);
        let sticks = self.stick.iter_mut().zip(&mut self.last);
        for ((stick, last), (reached, q)) in sticks.zip(cuts) {
            let span = q.max(T::one()) - *reached;
            *last = (T::constant(1.04) - *reached) / span.plus(0.04);
            *stick += last.scale(step.length.times(0.5));
        }
    }

    /// `(2/π) ∫ √(1 − x̂²) f dx̂` by the midpoint rule in the angle.
    #[inline(always)]
    fn end<const STICK: bool>(mut self, bias: &impl PerStrip<T>) -> StripForces<T, N> {
        if STICK {
            let before = T::Base::stored(T::Base::STEPS[STEPS - 1].x);
            for (stick, last) in self.stick.iter_mut().zip(&self.last) {
                *stick += last.scale(before.plus(1.0).times(0.5));
            }
        }
        let fx = T::each(&self.fx, |x| x.times(WEIGHT));
        let mut fy = T::each(&self.fy, |x| x.times(WEIGHT));
        let mx = T::each(&self.mx, |x| x.times(WEIGHT));
        // Σ B = STEPS/2, Σ B x̂ = 0
        for (i, fy) in fy.iter_mut().enumerate() {
            *fy += bias.of(i);
        }
        StripForces { fx, fy, mx, stick: self.stick }
    }
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
    /// `(|p|/B)²` before it.
    trial: T,
    /// The same after it.
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
        let turn = self.kept.scale(step.square).shift(step.turn);
        let px = self.px + creepage.longitudinal.scale(step.length);
        let py = self.py + creepage.lateral.scale(step.length) + creepage.spin * turn;
        let trial = (px * px + py * py).scale(step.inverse_square);
        let m = T::one() / rounded(trial).sqrt();
        (Self { px: px * m, py: py * m, kept: m }, Cut { trial, reached: trial * (m * m) })
    }
}

/// `max(1, q)`, with a parabola between `1 − d` and `1 + d`.
#[inline(always)]
fn rounded<T: Arithmetic>(q: T) -> T {
    const D: f64 = ROUNDING as f64;
    let a = q.max(T::constant(1.0 - D));
    let z = (T::constant(1.0 + D) - a).max(T::zero());
    a + (z * z).times(0.25 / D)
}

/// `s/(1 + s⁴)^{1/4}`, inside (−1, 1).
#[inline(always)]
fn squashed<T: Arithmetic>(s: T) -> T {
    let s = limited(s);
    s / s.squared().squared().plus(1.0).sqrt().sqrt()
}

/// Spin beyond which `squashed` is 1 to rounding: its fourth power fits an `f32`.
#[inline(always)]
fn limited<T: Arithmetic>(s: T) -> T {
    s.min(T::constant(1e6)).max(T::constant(-1e6))
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

/// How the corrections are found from the features.
trait Corrections<T: Number> {
    fn of(features: &[T; FEATURES]) -> [T::Pair; CORRECTIONS / 2];
}

/// The network in the numbers of the features.
struct Forward;
/// The network with its derivatives.
struct WithSlopes;

impl<T: Number> Corrections<T> for Forward
where
    T::Base: Marched,
{
    #[inline(always)]
    fn of(features: &[T; FEATURES]) -> [T::Pair; CORRECTIONS / 2] {
        network::<T>(features)
    }
}

impl<F: Float + Marched> Corrections<Dual<F, 3>> for WithSlopes {
    #[inline(always)]
    fn of(features: &[Dual<F, 3>; FEATURES]) -> [Dual<F::Pair, 3>; CORRECTIONS / 2] {
        network_slopes(features)
    }
}

/// The corrections: one layer of units `h/√(1 + h²)`, in pairs.
#[inline(always)]
fn network<T: Number>(features: &[T; FEATURES]) -> [T::Pair; CORRECTIONS / 2]
where
    T::Base: Marched,
{
    let mut hidden = [T::Quad::zero(); UNITS / 4];
    for (sum, offset) in hidden.iter_mut().zip(fours(&T::Base::HIDDEN_OFFSET)) {
        *sum = quad_of::<T>(offset);
    }
    for (feature, row) in features.iter().zip(&T::Base::HIDDEN) {
        add_row::<T>(&mut hidden, *feature, row);
    }
    let mut roots = hidden;
    for h in &mut roots {
        *h = h.squared().plus(1.0);
    }
    for (h, root) in hidden.iter_mut().zip(T::Quad::inverse_roots(roots)) {
        *h = *h * root;
    }
    // two chains of additions
    let mut corrections = [T::Quad::zero(); CORRECTIONS / 4];
    let mut others = corrections;
    for (sum, offset) in corrections.iter_mut().zip(fours(&T::Base::OUTPUT_OFFSET)) {
        *sum = quad_of::<T>(offset);
    }
    let table = &<T::Base as Marched>::OUTPUT;
    let (rows, _) = table.as_chunks::<4>();
    for (quad, [row_a, row_b, row_c, row_d]) in hidden.iter().zip(rows) {
        let [a, b, c, d] = quad.parts();
        add_row::<T>(&mut corrections, a, row_a);
        add_row::<T>(&mut others, b, row_b);
        add_row::<T>(&mut corrections, c, row_c);
        add_row::<T>(&mut others, d, row_d);
    }
    for (sum, other) in corrections.iter_mut().zip(others) {
        *sum += other;
    }
    halves_of::<T, { CORRECTIONS / 4 }, { CORRECTIONS / 2 }>(&corrections)
}

/// `sums + x row`
#[inline(always)]
fn add_row<T: Number>(sums: &mut [T::Quad], x: T, row: &[Stored<T>]) {
    let x = T::Quad::all(x);
    for (sum, weights) in sums.iter_mut().zip(fours(row)) {
        *sum += x * quad_of::<T>(weights);
    }
}

/// The corrections with their derivatives by the three creepages: the weights meet value and slopes
/// together, and the roots are shared.
#[inline(always)]
fn network_slopes<F: Float + Marched>(
    features: &[Dual<F, 3>; FEATURES],
) -> [Dual<F::Pair, 3>; CORRECTIONS / 2] {
    let none = [F::Pair::zero(); 3];
    let values = features.map(|feature| F::Pair::both(feature.value));
    let by_x = &features.map(|feature| F::Pair::both(feature.gradient[0]));
    let by_y = &features.map(|feature| F::Pair::both(feature.gradient[1]));
    let by_phi = &features.map(|feature| F::Pair::both(feature.gradient[2]));
    let table = &F::HIDDEN;
    let mut hidden = [(F::Pair::zero(), none); UNITS / 2];
    for ((sum, _), offset) in hidden.iter_mut().zip(pairs_of::<F>(&F::HIDDEN_OFFSET, 0)) {
        *sum = offset;
    }
    for (k, (sum, [sum_x, sum_y, sum_phi])) in hidden.iter_mut().enumerate() {
        // (without an index that could panic, at any optimisation level)
        let weight = |i: usize| {
            let two = table.get(i).and_then(|row| row.as_chunks::<2>().0.get(k));
            two.map_or(F::Pair::zero(), |two| pair_of::<F>(*two))
        };
        let part = |list: &[F::Pair; FEATURES], i: usize| {
            list.get(i).map_or(F::Pair::zero(), |slope| *slope * weight(i))
        };
        for (i, value) in values.iter().enumerate() {
            *sum += *value * weight(i);
        }
        // the features that depend on each creepage
        for i in [0, 5, 9, 12] {
            *sum_x += part(by_x, i);
        }
        for i in [1, 2, 6, 8, 9, 12] {
            *sum_y += part(by_y, i);
        }
        for i in [0, 1, 2, 7, 8, 10, 11, 12] {
            *sum_phi += part(by_phi, i);
        }
    }
    // d h/√(1 + h²) = dh/(1 + h²)^{3/2}
    let roots = F::Pair::inverse_roots(hidden.map(|(h, _)| h.squared().plus(1.0)));
    let mut corrections = [(F::Pair::zero(), none); CORRECTIONS / 2];
    for ((sum, _), offset) in corrections.iter_mut().zip(pairs_of::<F>(&F::OUTPUT_OFFSET, 0)) {
        *sum = offset;
    }
    let table = &F::OUTPUT;
    let (rows, _) = table.as_chunks::<2>();
    for (((h, slopes), root), rows) in hidden.into_iter().zip(roots).zip(rows) {
        let values = (h * root).parts();
        let cube = root * root * root;
        let slopes = slopes.map(|slope| (slope * cube).parts());
        let units =
            [(values.0, slopes.map(|slope| slope.0)), (values.1, slopes.map(|slope| slope.1))];
        for ((value, slopes), row) in units.into_iter().zip(rows) {
            let (value, slopes) = (F::Pair::both(value), slopes.map(F::Pair::both));
            for ((sum, sums), weights) in corrections.iter_mut().zip(pairs_of::<F>(row, 0)) {
                *sum += value * weights;
                for (sum, slope) in sums.iter_mut().zip(slopes) {
                    *sum += slope * weights;
                }
            }
        }
    }
    corrections.map(|(value, gradient)| Dual { value, gradient })
}

/// A table in pairs, from number `first` on.
#[inline(always)]
fn pairs_of<T: Number>(table: &[Stored<T>], first: usize) -> impl Iterator<Item = T::Pair> {
    let (pairs, _) = table.as_chunks::<2>();
    pairs.iter().skip(first / 2).map(|pair| pair_of::<T>(*pair))
}

/// Two plain numbers of a table side by side.
#[inline(always)]
fn pair_of<T: Number>(two: [Stored<T>; 2]) -> T::Pair {
    T::Pair::plain(T::Base::both_stored(two))
}

/// A table in fours.
#[inline(always)]
fn fours<F>(table: &[F]) -> &[[F; 4]] {
    table.as_chunks::<4>().0
}

#[inline(always)]
fn fours_mut<F>(table: &mut [F]) -> impl Iterator<Item = &mut [F; 4]> {
    table.as_chunks_mut::<4>().0.iter_mut()
}

/// Four plain numbers of a table side by side.
#[inline(always)]
fn quad_of<T: Number>([a, b, c, d]: &[Stored<T>; 4]) -> T::Quad {
    let ([a, b], [c, d]) = (T::Base::both_stored([*a, *b]), T::Base::both_stored([*c, *d]));
    T::Quad::plain([a, b, c, d])
}

/// Quads as pairs, twice as many.
#[inline(always)]
fn halves_of<T: Number, const Q: usize, const H: usize>(quads: &[T::Quad; Q]) -> [T::Pair; H] {
    let mut pairs = [T::Pair::zero(); H];
    for (pairs, quad) in pairs.as_chunks_mut::<2>().0.iter_mut().zip(quads) {
        *pairs = quad.halves();
    }
    pairs
}

/// The creepages, scaled down together where their fourth powers would overflow.
#[inline(always)]
fn within_range<T: Number>([vx, vy, phi]: [T; 3]) -> [T; 3] {
    let limit = T::Base::of(CREEPAGE_LIMIT);
    let size = vx.value().abs().max(vy.value().abs()).max(phi.value().abs());
    if size.exceeds(limit) {
        let factor = (size - limit).choose(limit / size, T::Base::one());
        [vx.scale(factor), vy.scale(factor), phi.scale(factor)]
    } else {
        [vx, vy, phi]
    }
}

#[cfg(test)]
mod tests;
