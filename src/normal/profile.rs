//! The given distance of two bodies, and the section in which they would overlap if they were
//! shifted into each other.

use crate::number::{Arithmetic, Dual, Float, are_finite, ascend, at, pairs};
use crate::numerics::Bracket;
use crate::status::Error;
use core::fmt::{self, Debug, Formatter};

/// Share of the approach by which shifted undeformed bodies overlap about over the patch's width.
const SECTION: f64 = 0.55;
/// `(3/4) V/(0.55 δ)` is half the width of a parabola's section.
const HALF_WIDTH: f64 = 0.75;
/// Halvings and Newton steps of a search at most; five are usual.
const INVERSION_STEPS: u32 = 60;

pub(crate) const DIRECTIONS: usize = 4;
/// Number of directions of the derivatives that numbers carry at once: on a microcontroller and in
/// a browser one, which takes the least memory and code.
pub(crate) const TOGETHER: usize =
    if cfg!(any(target_os = "none", target_family = "wasm")) { 1 } else { DIRECTIONS };

/// How points move.
pub(crate) trait Moves<F> {
    /// Derivatives of place, distance, centre along `x` and rolling radius of a point.
    fn moves_of_point(&self, k: usize) -> [[F; TOGETHER]; 4];
}

// Derived, it would be part of every table of methods, with what can panic in it.
impl<F> Debug for dyn Moves<F> + '_ {
    fn fmt(&self, to: &mut Formatter<'_>) -> fmt::Result {
        to.write_str("Moves")
    }
}

/// The undeformed distance of two bodies along `y`, linear between its points.
#[derive(Clone, Copy, Debug)]
pub struct Profile<'a, F> {
    pub(super) y: &'a [F],
    pub(super) distance: &'a [F],
    /// Where the distance is least along `x`; empty: at 0.
    centre_x: &'a [F],
    /// Empty: that of the contact.
    pub(super) rolling_radius: &'a [F],
    /// Smallest distance.
    pub(super) lowest: F,
    pub(super) ends: [F; 2],
    /// Where knots are counted from, y \[m\].
    pub(super) middle: F,
    /// Mean distance of the points \[m\].
    pub(super) step: F,
    /// Distances up to which a point counts fully in smoothing, and from which it does not \[m\].
    pub(super) fade: Option<[F; 2]>,
    /// How the points move, if they do.
    pub(crate) motion: Option<&'a dyn Moves<F>>,
}

impl<'a, F: Float> Profile<'a, F> {
    /// A profile from points `y` \[m\], strictly ascending, and the distance of the bodies there
    /// \[m\]. A constant added to all distances changes nothing.
    ///
    /// # Errors
    /// [`Error::Profile`] for fewer than two points, arrays of different length or `y` that does
    /// not ascend; [`Error::NotFinite`].
    pub fn new(y: &'a [F], distance: &'a [F]) -> Result<Self, Error> {
        let (Some(first), true) = (distance.first(), y.len() >= 2 && y.len() == distance.len())
        else {
            return Err(Error::Profile);
        };
        Error::NotFinite.unless(are_finite(y) && are_finite(distance))?;
        Error::Profile.unless(ascend(y))?;
        let lowest = distance.iter().fold(*first, |lowest, h| lowest.min(*h));
        let [from, to] = [at(y, 0), at(y, y.len() - 1)];
        let middle = from.times(0.5) + to.times(0.5);
        let step = (to - from) / F::widened((y.len() - 1) as f32);
        let (centre_x, rolling_radius, ends): (&[F], &[F], _) = (&[], &[], [from, to]);
        let (fade, motion) = (None, None);
        Ok(Self { y, distance, centre_x, rolling_radius, lowest, ends, middle, step, fade, motion })
    }

    /// The same of two surfaces whose points may come and go far from the contact without any
    /// effect: the caller says how far apart the points are, and points count less from the first
    /// of two distances on, and not at all from the second. Knots are counted from the origin of
    /// `y`, so that they stand still while a wheel sinks into two contacts far from each other.
    pub(crate) fn of_surfaces(mut self, step: F, fade: [F; 2]) -> Self {
        (self.step, self.fade) = (step, Some(fade));
        // knots beyond 1e6 steps would have no exact number
        if self.middle.abs() < step.times(1e6) {
            self.middle = F::zero();
        }
        self
    }

    /// The same with the place along `x` \[m\] where the distance is least, for each point: of
    /// bodies that yaw.
    ///
    /// # Errors
    /// [`Error::Profile`] for another number of points; [`Error::NotFinite`].
    pub fn with_centre_x(mut self, centre_x: &'a [F]) -> Result<Self, Error> {
        self.centre_x = self.of_each_point(centre_x)?;
        Ok(self)
    }

    /// The same with a rolling radius \[m\] for each point, which replaces that of the contact.
    ///
    /// # Errors
    /// [`Error::Profile`] for another number of points; [`Error::NotFinite`];
    /// [`Error::RollingRadius`].
    pub fn with_rolling_radius(mut self, rolling_radius: &'a [F]) -> Result<Self, Error> {
        self.rolling_radius = self.of_each_point(rolling_radius)?;
        Error::RollingRadius.when(self.rolling_radius.iter().any(|radius| *radius <= F::zero()))?;
        Ok(self)
    }

    fn of_each_point(&self, values: &'a [F]) -> Result<&'a [F], Error> {
        Error::Profile.unless(values.len() == self.y.len())?;
        Error::NotFinite.unless(are_finite(values))?;
        Ok(values)
    }

    /// Where the distance is least along `x`.
    pub(super) fn centre_x<const N: usize>(&self, y: Dual<F, N>) -> Dual<F, N> {
        if self.centre_x.is_empty() {
            return Dual::zero();
        }
        self.interpolated(self.centre_x, 2, y)
    }

    /// The rolling radius at a place; `otherwise` is that of the contact.
    pub(super) fn rolling_radius<const N: usize>(&self, y: Dual<F, N>, otherwise: F) -> Dual<F, N> {
        if self.rolling_radius.is_empty() {
            return Dual::from_base(otherwise);
        }
        self.interpolated(self.rolling_radius, 3, y)
    }

    /// The distance of the bodies, straight between the points.
    pub(super) fn distance_at(&self, y: F) -> F {
        self.interpolated(self.distance, 1, Dual::<F, 0>::from_base(y)).value
    }

    /// The least and the largest distance of the points that are nearer to a place than a reach.
    /// The largest is at most `none`. `from` is the number of the first point that is not before
    /// the place.
    pub(super) fn range_near(&self, [place, reach, none]: [F; 3], from: usize) -> [F; 2] {
        let point = |k: usize| Some((*self.y.get(k)?, *self.distance.get(k)?));
        let (mut low, mut high) = (F::LARGEST, -F::LARGEST);
        let mut add = |k: usize| match point(k) {
            Some((y, distance)) if (y - place).abs() < reach => {
                (low, high) = (low.min(distance), high.max(distance.min(none)));
                true
            }
            _ => false,
        };
        let (mut ahead, mut behind) = (from, from);
        while add(ahead) {
            ahead += 1;
        }
        while behind > 0 && add(behind - 1) {
            behind -= 1;
        }
        [low, high]
    }

    /// Interpolates linearly between the points of a list, which is this one of those that move.
    fn interpolated<const N: usize>(&self, list: &[F], number: usize, y: Dual<F, N>) -> Dual<F, N> {
        let next = self.y.partition_point(|place| *place < y.value);
        let next = next.min(self.y.len().saturating_sub(1)).max(1);
        let (from, to) = (at(self.y, next - 1), at(self.y, next));
        let (before, after) = (at(list, next - 1), at(list, next));
        let slope = (after - before) / (to - from);
        let mut found = (y - Dual::from_base(from)).scale(slope).shift(before);
        if let Some(motion) = self.motion {
            let share = (y.value - from) / (to - from);
            let points = [next - 1, next].map(|k| motion.moves_of_point(k));
            for (point, weight) in points.into_iter().zip([F::one() - share, share]) {
                let [places, ..] = point;
                let moved = point.get(number).copied().unwrap_or([F::zero(); TOGETHER]);
                for ((sum, moved), place) in found.gradient.iter_mut().zip(moved).zip(places) {
                    *sum += weight * (moved - slope * place);
                }
            }
        }
        found
    }

    /// Length with less distance than a level above `from`, fading from once to twice the level.
    pub(super) fn low_length<const N: usize>(&self, level: Dual<F, N>, from: F) -> Dual<F, N> {
        let inverse = level.shift(F::TINY).inverse();
        let one = Dual::one();
        let mut length = Dual::zero();
        for ((y, next), (here, there)) in pairs(self.y).zip(pairs(self.distance)) {
            let height = here.times(0.5) + there.times(0.5) - from;
            let share = Dual::constant(2.0) - inverse.scale(height);
            length += share.max(Dual::zero()).min(one).scale(*next - *y);
        }
        length
    }

    /// `V = ∫ (h₀ − h) dy` over the overlap at `h₀ = 0.55 δ`; `radius` for a profile without radii.
    /// Returns half the width of the parabola of this volume, and the mean rolling radius \[m\].
    pub(super) fn section<const N: usize>(
        &self, approach: Dual<F, N>, radius: F,
    ) -> [Dual<F, N>; 2] {
        let level = approach.times(SECTION);
        let mut volume = Dual::from_base(F::TINY);
        let mut moment = Dual::from_base(radius * F::TINY);
        // straight pieces between the points
        for (k, (from, to)) in pairs(self.distance).enumerate() {
            let (low, high) = (from.min(*to) - self.lowest, from.max(*to) - self.lowest);
            if level.value <= low {
                continue;
            }
            let of = |list: &[F], k: usize| list.get(k).copied().unwrap_or(radius);
            let (from, to) = (of(self.y, k), of(self.y, k + 1));
            let radii = [k, k + 1].map(|k| of(self.rolling_radius, k).times(0.5));
            let (depth, least) = (level.shift(-low), level.shift(-high));
            // the part of the piece where the bodies overlap
            let part = if least.value < F::zero() {
                depth.squared().scale((to - from).times(0.5) / (high - low))
            } else {
                (depth + least).scale((to - from).times(0.5))
            };
            volume += part;
            moment += part.scale(radii[0] + radii[1]);
        }
        [(volume / level).times(HALF_WIDTH), moment / volume]
    }

    /// About the load over `E*`: of the ellipse with `a² = 1.1 R δ` and the width of the section,
    /// `N = (4/3) E* δ M(a, b)` with Gauss's mean `M`.
    pub(super) fn load<const N: usize>(&self, approach: Dual<F, N>, radius: F) -> Dual<F, N> {
        let [mut b, rolling_radius] = self.section(approach, radius);
        let mut a = (rolling_radius * approach).times(2.0 * SECTION).sqrt();
        for _ in 0..12 {
            (a, b) = ((a + b).times(0.5), (a * b).sqrt());
            if (a.value - b.value).abs() <= F::EPSILON * a.value {
                break;
            }
        }
        (approach * a).times(4.0 / 3.0)
    }
}

/// Where a function that rises with its argument has the value `target`: Newton's steps in
/// logarithms between brackets, the last without a test, so that derivatives are those of the
/// inverse function. `None` beyond the range of the numbers.
pub(super) fn invert<F: Float>(
    target: Dual<F, 1>, start: F, mut function: impl FnMut(Dual<F, 1>) -> Dual<F, 1>,
) -> Option<(Dual<F, 1>, u32)> {
    let mut bracket = Bracket { negative: F::TINY, positive: F::LARGEST };
    let mut x = start;
    let close = F::EPSILON.sqrt().max(F::of(1e-5));
    for step in 1..=INVERSION_STEPS {
        let found = function(Dual::input(x, 0));
        let [slope] = found.gradient;
        if !(found.value > F::zero()) || !found.value.is_finite_number() {
            return None;
        }
        let excess = found.value.ln_quotient(target.value);
        // the bracket closes around a step of the function
        let closed = bracket.width() <= x * F::EPSILON.times(8.0);
        if excess.abs() <= close || closed || step == INVERSION_STEPS {
            let inverse = F::one() / slope;
            let better = x + (target.value - found.value) * inverse;
            let value = if bracket.holds(better) { better } else { x };
            let gradient = target.gradient.map(|d| d * inverse);
            return Some((Dual { value, gradient }, step));
        }
        bracket.narrow(x, excess);
        // the exponent p of a function like x^p lies between 1/2 and 8
        let power = (slope * x / found.value).max(F::of(0.5)).min(F::of(8.0));
        let next = x * (-excess / power).max(F::of(-3.0)).min(F::of(3.0)).exp();
        x = if bracket.holds(next) { next } else { bracket.ratio_middle() };
    }
    None
}
