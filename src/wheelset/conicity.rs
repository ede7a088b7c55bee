//! Difference of the rolling radii against the lateral shift, and equivalent conicity after EN
//! 15302.
//!
//! A free wheelset on straight track follows `y'' = −Δr(y)/(e r₀)`, with the difference `Δr` of the
//! rolling radii and the distance `e` of the running circles. Between the extremes of its motion,
//! `m − a` and `m + a`,
//!
//! ```text
//! λ = 2 ∫ dy √(e r₀/(2 W)),   W(y) = ∫ Δr from y to m + a,   tan γ = (π/λ)² 2 e r₀
//! ```
//!
//! and a cone with this conicity has the same wave length. With `y = m + a cos θ` the integrand is
//! smooth at the ends.

use super::forces::{Wheelset, WheelsetWorkspace};
use super::kinematics::{Kinematics, Side};
use crate::number::{Float, are_finite, ascend, at, length, pairs};
use crate::status::Error;
use crate::wheel_rail::scene::{Scene, Workspace};
use crate::wheel_rail::{Position, sine_cosine};

/// Number of places in half a wave.
const WAVE_PLACES: i32 = 128;
const EACH: f64 = core::f64::consts::PI / WAVE_PLACES as f64;
/// Steps of the search for the middle of the motion.
const BISECTIONS: usize = 60;
/// Roundings of the largest possible work that a work of zero may have.
const WORK_ROUNDING: f64 = 64.0;
/// How often a wheel is lowered onto its rail, and how often the roll follows the wheels.
const LOWERINGS: usize = 24;
const ROLLS: usize = 6;
/// Distance at which a wheel touches \[m\].
const TOUCHES: f64 = 1e-9;

impl<F: Float> Wheelset<'_, F> {
    /// Difference of the rolling radii of both wheels, right minus left \[m\], where the rigid
    /// wheelset touches both rails without yaw; with the roll that it has there, or without any.
    ///
    /// # Errors
    /// Those of [`GapSearch::gap`](crate::wheel_rail::touch::GapSearch::gap).
    pub fn rolling_radius_difference(
        &self, lateral: F, with_roll: bool, memory: &mut WheelsetWorkspace<F>,
    ) -> Result<F, Error> {
        Error::NotFinite.unless(lateral.is_finite_number())?;
        let mut here = Position { lateral, ..Position::default() };
        let mut radii = [F::zero(); 2];
        for _ in 0..if with_roll { ROLLS } else { 1 } {
            let mut sinks = [F::zero(); 2];
            let sides = self.scenes.iter().zip(&self.sides).zip(&mut memory.wheel);
            for (((scene, side), memory), (radius, sink)) in
                sides.zip(radii.iter_mut().zip(&mut sinks))
            {
                (*radius, *sink) = rolling_radius(scene, side, &here, memory)?;
            }
            let ([right, left], [side, _]) = (sinks, self.sides);
            if with_roll {
                here.vertical += (right + left).times(0.5);
                here.roll += (right - left) / side.arm.times(2.0);
            }
        }
        let [right, left] = radii;
        Ok(right - left)
    }
}

/// Rolling radius where a wheel touches its rail, and how far it has been lowered.
fn rolling_radius<F: Float>(
    scene: &Scene<'_, F>, side: &Side<F>, position: &Position<F>, memory: &mut Workspace<F>,
) -> Result<(F, F), Error> {
    let first = Kinematics::new(*side, position).position();
    let mut here = first.mirrored(scene.pair.left != 0);
    let gap = &mut memory.gap;
    for _ in 0..LOWERINGS {
        let found = scene.search_at(&here)?.gap(F::zero(), gap);
        let left = found.map_err(|error| scene.cause().named(error, &here))?;
        here.vertical += left;
        if left.abs() < F::of(TOUCHES) {
            break;
        }
    }
    let count = gap.count as usize;
    let nearest = (0..count)
        .fold(0, |best, k| if at(&gap.distance, k) < at(&gap.distance, best) { k } else { best });
    let (sine, cosine) = sine_cosine(here.roll);
    let radius = |k: usize| length(at(&gap.x, k), cosine * at(&gap.z, k) - sine * at(&gap.y, k));
    // the lowest place of a parabola through the nearest point and its neighbours
    let (before, after) = (nearest.saturating_sub(1), (nearest + 1).min(count.saturating_sub(1)));
    let place = |k: usize| [&gap.along, &gap.distance].map(|list| at(list, k) - at(list, nearest));
    let ([from, high], [to, higher]) = (place(before), place(after));
    let bend = (higher / to - high / from) / (to - from);
    let lowest = (high / from - bend * from) / bend.times(-2.0);
    let own = radius(nearest);
    let (end, span) = if lowest < F::zero() { (before, from) } else { (after, to) };
    let share = (lowest / span).clamped(F::zero(), F::one());
    let between = own + (radius(end) - own) * share;
    let radius = if between.is_finite_number() { between } else { own };
    Ok((radius, here.vertical - first.vertical))
}

/// A difference of rolling radii, straight between given shifts.
#[derive(Clone, Copy, Debug)]
pub struct RadiusDifference<'a, F> {
    shifts: &'a [F],
    differences: &'a [F],
}

/// A wave of the free wheelset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave<F> {
    /// Equivalent conicity `tan γ` \[-\], >= 0.
    pub conicity: F,
    /// Wave length \[m\]; infinite where the conicity is 0.
    pub length: F,
}

/// Checks the distance of the running circles and the radius of the wheels \[m\].
pub(crate) fn check_circles<F: Float>(distance: F, radius: F) -> Result<(), Error> {
    Error::NotFinite.unless(are_finite(&[distance, radius]))?;
    Error::Gauge.unless(distance > F::zero())?;
    Error::RollingRadius.unless(radius > F::zero())
}

impl<'a, F: Float> RadiusDifference<'a, F> {
    /// Differences \[m\] at ascending shifts \[m\].
    ///
    /// # Errors [`Error::Profile`] for fewer than two shifts, or shifts that do not ascend;
    /// [`Error::NotFinite`].
    pub fn new(shifts: &'a [F], differences: &'a [F]) -> Result<Self, Error> {
        Error::Profile.unless(shifts.len() >= 2 && shifts.len() == differences.len())?;
        Error::NotFinite.unless(are_finite(shifts) && are_finite(differences))?;
        Error::Profile.unless(ascend(shifts))?;
        Ok(Self { shifts, differences })
    }

    /// `∫ Δr dy` from one place to another, exact.
    fn integral(&self, from: F, to: F) -> F {
        let mut sum = F::zero();
        let pieces = pairs(self.shifts).zip(pairs(self.differences));
        for ((&start, &end), (&low, &high)) in pieces {
            let (a, b) = (from.max(start), to.min(end));
            if a < b {
                let slope = (high - low) / (end - start);
                sum += (b - a) * (low + slope * ((a + b).times(0.5) - start));
            }
        }
        sum
    }

    /// The wave of an amplitude \[m\], with the distance of the running circles \[m\] and the
    /// radius of the wheels \[m\].
    ///
    /// The conicity is 0 where the radii do not differ over a part of the motion, so that the
    /// wheelset keeps its direction there.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::Conicity`] for an amplitude that is not positive or beyond
    /// the shifts, or where the radii turn the wheelset away from the middle; [`Error::Gauge`] for
    /// the distance; [`Error::RollingRadius`].
    pub fn wave(&self, amplitude: F, distance: F, radius: F) -> Result<Wave<F>, Error> {
        Error::NotFinite.unless(amplitude.is_finite_number())?;
        Error::Conicity.unless(amplitude > F::zero())?;
        check_circles(distance, radius)?;
        let (Some(&first), Some(&last)) = (self.shifts.first(), self.shifts.last()) else {
            return Err(Error::Profile);
        };
        let middle = self.middle(amplitude, first, last).ok_or(Error::Conicity)?;
        let [left, right] = [middle - amplitude, middle + amplitude];
        let rounding = self.rounding(amplitude);
        let mut sum = F::zero();
        for k in 0..WAVE_PLACES {
            let angle = F::widened(k as f32).plus(0.5).times(EACH);
            // the angle is at most 1.6
            let (sine, cosine) = sine_cosine(angle.plus(-core::f64::consts::FRAC_PI_2));
            let (sine, cosine) = (cosine, -sine);
            let place = middle + amplitude * cosine;
            let work = if cosine > F::zero() {
                self.integral(place, right)
            } else {
                -self.integral(left, place)
            };
            Error::Conicity.unless(work >= -rounding)?;
            sum += amplitude * sine / work.max(F::zero()).sqrt();
        }
        // S = ∫ a sin θ/√W dθ,   λ = √(2 e r₀) S,   tan γ = (π/λ)² 2 e r₀ = (π/S)²
        let sum = sum.times(EACH);
        let length = distance.times(2.0).sqrt() * radius.sqrt() * sum;
        let root = F::constant(core::f64::consts::PI) / sum;
        let conicity = root * root;
        Error::Overflow.unless(conicity.is_finite_number())?;
        if conicity > F::zero() && length.is_finite_number() {
            return Ok(Wave { conicity, length });
        }
        Ok(Wave { conicity: F::zero(), length: F::one() / F::zero() })
    }

    /// By how much rounding may change the work of a motion.
    fn rounding(&self, amplitude: F) -> F {
        let largest = self.differences.iter().fold(F::zero(), |most, own| most.max(own.abs()));
        amplitude * largest * F::EPSILON.times(WORK_ROUNDING)
    }

    /// The middle of the motion: as much work from there to one end as to the other.
    fn middle(&self, amplitude: F, first: F, last: F) -> Option<F> {
        let tolerance = amplitude * F::EPSILON.times(64.0);
        let (mut low, mut high) = (first + amplitude, last - amplitude);
        if low > high + tolerance {
            return None;
        }
        if low >= high - tolerance {
            return Some((low + high).times(0.5));
        }
        let work = |middle: F| self.integral(middle - amplitude, middle + amplitude);
        if !(work(low) <= F::zero() && work(high) >= F::zero()) {
            return None;
        }
        for _ in 0..BISECTIONS {
            let middle = (low + high).times(0.5);
            if work(middle) < F::zero() { low = middle } else { high = middle }
        }
        Some((low + high).times(0.5))
    }
}
