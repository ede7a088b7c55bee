//! The height of a wheel that carries a load.
//!
//! The search begins above the rail, wherever the wheel was, so that of several heights it finds
//! the first. It lowers the wheel until the surfaces touch, and then follows the force to the power
//! 2/3, which is nearly linear for Hertz's contacts: by secants between heights of like stiffness,
//! corrected as the stiffness changes, else by Newton's steps, always between a height with less
//! than the requested force and one with more; by halvings after steps that do not lead closer.
//! It ends where the force is accurate to rounding: to that of the force, or to that of the points
//! of the profiles.
//!
//! A height at which a profile ends in the contact is too low. If nothing touches above it, the
//! wheel passes an edge of the rail there, and the search goes on below. This is also tried if a
//! profile ends in the contact as soon as the wheel touches.

use super::contacts::view;
use super::scene::{Scene, Workspace};
use super::touch::{self, Gap};
use super::tried_heights::{Heights, Trend};
use super::{BodyState, Position, Velocity, sine_cosine};
use crate::contact::material::{check_modulus, check_poisson_ratio};
use crate::number::Float;
use crate::status::{Error, Warning};

/// Largest number of heights that are tried.
const HEIGHTS: u32 = 100;
/// Largest factor by which the depth below the first touch grows in a step.
const DEPTH_GROWTH: f64 = 4.0;
/// Share of a step below which no load is looked for between a height and a profile's end.
const NEAR_END: f64 = 0.01;
/// Peak pressure over the shear modulus from which no wheel is supported: flanges have 0.05.
const CRUSHED: f64 = 0.05;
/// Hertz's approach over the wheel's radius from which no force is looked for.
const DEEPEST: f64 = 1e3;
/// Length of the wheel's profile times this has the rounding of a height.
const COORDINATES: f64 = 0.1;
/// Roundings of a height by which the force may jump between neighbouring heights.
const JUMP: f64 = 10.0;
/// Least cosine of an angle by which a distance along a normal becomes a vertical one.
const STEEP: f64 = 0.1;

/// Whether the wheel is too deep in the rail to have a force, or beside it.
const fn is_too_deep(error: Error) -> bool {
    matches!(error, Error::ProfileEnd | Error::Overflow | Error::PatchSize | Error::TableRange)
}

impl<F: Float> Scene<'_, F> {
    /// The vertical position at which the rail supports the wheel with a force: of several the
    /// highest that the search meets from above. Creep forces carry as well if there is a
    /// `velocity`. The vertical position of the wheel does not matter.
    ///
    /// # Errors
    /// Those of [`Scene::solve`]; [`Error::Support`] for a force that is not positive;
    /// [`Error::ProfileEnd`] where the contact reaches the end of a profile with less force.
    pub fn height_for_load(
        &self, position: &Position<F>, support: F, velocity: Option<&Velocity<F>>,
        memory: &mut Workspace<F>,
    ) -> Result<(F, Warning), Error> {
        let found = self.find_height(position, support, velocity, memory);
        // the search does not depend on its start
        let anywhere = Position { vertical: F::zero(), ..*position };
        found.map_err(|error| self.cause().named(error, &anywhere))
    }

    fn find_height(
        &self, position: &Position<F>, support: F, velocity: Option<&Velocity<F>>,
        memory: &mut Workspace<F>,
    ) -> Result<(F, Warning), Error> {
        Error::NotFinite.unless(support.is_finite_number())?;
        Error::Support.when(support <= F::zero())?;
        self.pair.check()?;
        check_modulus(self.pair.shear_modulus)?;
        check_poisson_ratio(self.pair.poisson_ratio)?;
        let straight = |force: F| force.max(F::zero()).squared().cube_root();
        let wanted = straight(support);
        // of a sphere with the wheel's radius: N = (4/3) E* √R δ^(3/2)
        let modulus = self.pair.shear_modulus / (F::one() - self.pair.poisson_ratio);
        let expected = straight(support.times(0.75) / (modulus * self.pair.wheel_radius.sqrt()));
        // NaN compares as not below
        let is_possible = expected < self.pair.wheel_radius.times(DEEPEST);
        Error::Overflow.unless(is_possible && wanted.is_finite_number())?;
        let [mut touches, per_normal] = self.first_touch(position)?;
        Error::Overflow.unless(touches.is_finite_number())?;
        let length = self.wheel.step * F::widened(self.wheel.count as f32);
        let rounding = (length * F::EPSILON).times(COORDINATES);
        let mut heights = Heights::new();
        // N = F/cos a, and along the normal the surfaces approach by the cosine
        let sink = expected * per_normal.squared().cube_root() * per_normal;
        let mut here = touches + sink;
        let mut trend = Trend { least: None, falls: false, rounding: support * F::EPSILON.sqrt() };
        // by how much the straightened force grows over a rounding of the height
        let mut unsure = F::zero();
        let mut end = None;
        for tried in 0..HEIGHTS {
            let found = self.support(&Position { vertical: here, ..*position }, velocity, memory);
            let next = match found {
                Err(error) if is_too_deep(error) => {
                    heights.note_deep(here, error);
                    end = end.or(Some(error));
                    // a profile ends as soon as the wheel touches
                    if tried == 1
                        && here <= touches
                        && error != Error::TableRange
                        && let Some(touch) = self.below_edge(here, true, position, memory)?
                    {
                        (heights, touches, here) = (Heights::new(), touch, touch + expected);
                        continue;
                    }
                    // the first touch itself is tried next
                    (tried == 0).then_some(touches)
                }
                Err(error) => return Err(error),
                Ok([force, stiffness]) => {
                    let own = straight(force);
                    let rest = own - wanted;
                    trend.note(here, force, rest < F::zero());
                    // d(F^(2/3)) = (2/3) F^(2/3)/F dF
                    let by_hertz =
                        (force > F::zero()).then(|| (own / force) * stiffness.times(2.0 / 3.0));
                    unsure = by_hertz.unwrap_or(F::zero()) * rounding;
                    let accurate = wanted * F::EPSILON.cube_root().squared();
                    if rest.abs() <= accurate.max(unsure) {
                        return Ok((here, self.supported(&trend, memory)));
                    }
                    let next = heights.note(here, rest, by_hertz);
                    if memory.count == 0 {
                        let from = heights.lowest.unwrap_or(here);
                        if heights.is_above_edge()
                            && let Some(touch) = self.below_edge(from, false, position, memory)?
                        {
                            (heights, touches, here) = (Heights::new(), touch, touch + expected);
                            continue;
                        }
                        let next = self.next_touch(here, position, memory)?;
                        touches = next.unwrap_or(here.plus(touch::DEFAULT_REACH));
                        heights.deep.is_none().then_some(touches + expected)
                    } else {
                        next
                    }
                }
            };
            here = match (heights.above, heights.too_low()) {
                (Some((high, less)), Some((low, error))) => {
                    let middle = high + (low - high).times(0.5);
                    if !(middle > high && middle < low) || low - high <= rounding {
                        if let Some(error) = error {
                            return Err(error);
                        }
                        let more = heights.below.map_or(-less, |(_, more)| more);
                        let is_close = more.min(-less) <= wanted * F::EPSILON.sqrt()
                            || more - less <= unsure.times(JUMP);
                        let warning = self.supported(&trend, memory);
                        let warning = if is_close { warning } else { Warning::NotConverged };
                        return Ok((here, warning));
                    }
                    let is_far = |next: F| low - high < (next - high).times(NEAR_END);
                    if let Some(error) = error.filter(|_| next.is_some_and(is_far)) {
                        return Err(error);
                    }
                    next.filter(|next| *next > high && *next < low).unwrap_or(middle)
                }
                (Some((high, _)), None) => {
                    let from = high.max(touches);
                    let farthest = from + (high - touches).max(expected) * F::of(DEPTH_GROWTH);
                    let next = next.or(Some(touches + sink));
                    next.filter(|next| *next > high).map_or(farthest, |next| next.min(farthest))
                }
                (None, Some((low, _))) => {
                    let farther = low - (touches - low).max(expected) * F::of(DEPTH_GROWTH);
                    next.filter(|next| *next < low).unwrap_or(farther)
                }
                (None, None) => return Ok((here, Warning::NotConverged)),
            };
        }
        // where no height has enough force, a profile ends
        match end {
            Some(error) if heights.below.is_none() => Err(error),
            _ => Ok((here, Warning::NotConverged)),
        }
    }

    /// About the height at which the wheel touches next, at a height without a contact; none if
    /// that is farther than gaps reach.
    ///
    /// # Errors
    /// Those of [`Scene::place`] that do not mean that the wheel is too deep.
    fn next_touch(
        &self, here: F, position: &Position<F>, memory: &mut Workspace<F>,
    ) -> Result<Option<F>, Error> {
        let mut distance = nearest(&memory.gap);
        if distance.is_none() {
            let right = Position { vertical: here, ..*position }.mirrored(self.pair.left != 0);
            let found = self.search_at(&right)?.gap(F::of(touch::DEFAULT_REACH), &mut memory.gap);
            distance = match found {
                Err(error) if !is_too_deep(error) => return Err(error),
                Err(_) => None,
                Ok(_) => nearest(&memory.gap),
            };
        }
        Ok(distance.map(|distance| here + distance))
    }

    /// About the first height below an edge at which the wheel touches: by steps that grow, the
    /// first as long as gaps reach. None if the first step does not pass the edge but `must_pass`.
    ///
    /// # Errors
    /// [`Error::ProfileEnd`] if there is none within a length; those of [`Scene::place`].
    fn below_edge(
        &self, from: F, must_pass: bool, position: &Position<F>, memory: &mut Workspace<F>,
    ) -> Result<Option<F>, Error> {
        let length = self.wheel.step * F::widened(self.wheel.count as f32);
        let mut step = view::reach(self.wheel.step, self.pair.smoothing_length);
        let (mut here, mut passed) = (from, !must_pass);
        while here < from + length {
            here += step;
            step = step.times(2.0);
            let touch = match self.place(&Position { vertical: here, ..*position }, memory) {
                Err(error) if !is_too_deep(error) => return Err(error),
                Err(_) => None,
                Ok(_) if memory.count > 0 => Some(here),
                Ok(_) => {
                    passed = true;
                    self.next_touch(here, position, memory)?
                }
            };
            if !passed {
                return Ok(None);
            }
            if touch.is_some() {
                return Ok(touch);
            }
        }
        Err(Error::ProfileEnd)
    }

    /// What is implausible about the scene and its contacts, and whether they support the wheel.
    fn supported(&self, trend: &Trend<F>, memory: &Workspace<F>) -> Warning {
        let bound = self.pair.shear_modulus.times(CRUSHED);
        let crushed = memory.found().iter().any(|contact| contact.peak_pressure() > bound);
        let support = if trend.falls || crushed { Warning::Support } else { Warning::None };
        support.worse(self.plausibility(memory.found()))
    }

    /// The upward force of the rail on the wheel, without a velocity the vertical component of the
    /// pressure alone; and its derivative with respect to the vertical position if creep forces
    /// grow like the pressure.
    fn support(
        &self, position: &Position<F>, velocity: Option<&Velocity<F>>, memory: &mut Workspace<F>,
    ) -> Result<[F; 2], Error> {
        let force = match velocity {
            Some(velocity) => {
                let state = BodyState { position: *position, velocity: *velocity };
                let [_, _, vertical] = self.wrench(&state, memory, None)?.force;
                Some(-vertical)
            }
            None => {
                self.place(position, memory)?;
                None
            }
        };
        let (mut pressure, mut stiffness) = (F::zero(), F::zero());
        for contact in memory.found() {
            let [_, _, vertical, ..] = contact.normal;
            pressure += contact.share * contact.normal_force * vertical;
            stiffness += contact.share * contact.stiffness * vertical * vertical;
        }
        let force = force.unwrap_or(pressure);
        let share = if pressure > F::zero() { force / pressure } else { F::zero() };
        Ok([force, stiffness * share])
    }

    /// About the vertical position at which the wheel touches first on its way down, and by how
    /// much it moves down for a unit of approach there.
    fn first_touch(&self, position: &Position<F>) -> Result<[F; 2], Error> {
        let right = position.mirrored(self.pair.left != 0);
        let found = self.search_at(&right)?.lowered();
        let [touches, cosine] = found.ok_or(Error::ProfileEnd)?;
        Ok([touches, F::one() / cosine.abs().max(F::of(STEEP))])
    }
}

/// About how far the wheel moves down until it touches, 0 if it does; none if all points are
/// farther than the gap reaches.
fn nearest<F: Float>(gap: &Gap<F>) -> Option<F> {
    let points = gap.distance.iter().zip(&gap.angle).take(gap.count as usize);
    // along the normal the surfaces approach by the cosine
    let vertical = points.map(|(distance, angle)| {
        let (_, cosine) = sine_cosine(*angle);
        *distance / cosine.max(F::of(STEEP))
    });
    vertical.reduce(F::min).map(|least| least.max(F::zero()))
}
