//! The height of a wheel that carries a load.
//!
//! The search begins above the rail, wherever the wheel was, so that of several heights it finds
//! the first. It lowers the wheel until the surfaces touch, and then follows the force to the power
//! 2/3, which is nearly linear for Hertz's contacts: by Newton's steps with the stiffness at first,
//! then by secants, always between a height with less than the requested force and one with more.
//! It ends where the force is accurate to rounding: to that of the force, or to that of the points
//! of the profiles.
//!
//! A height at which a profile ends in the contact is too low. If nothing touches above it, the
//! wheel passes an edge of the rail there, and the search goes on below.

use super::scene::{Scene, Workspace};
use super::touch::Gap;
use super::{BodyState, Position, Velocity};
use crate::contact::material::{check_modulus, check_poisson_ratio};
use crate::number::Float;
use crate::status::{Error, Warning};

/// Largest number of heights that are tried.
const HEIGHTS: u32 = 100;
/// Largest factor by which the depth below the first touch grows in a step.
const DEPTH_GROWTH: f64 = 4.0;
/// Peak pressure over the shear modulus from which no wheel is supported: flanges have 0.05.
const CRUSHED: f64 = 0.05;
/// Hertz's approach over the wheel's radius from which no force is looked for.
const DEEPEST: f64 = 1e3;
/// Length of the wheel's profile times this has the rounding of a height.
const COORDINATES: f64 = 0.1;
/// Roundings of a height by which the force may jump between neighbouring heights.
const JUMP: f64 = 10.0;
/// How many heights without a force are tried above one at which a profile ends.
const EMPTY: u32 = 3;

/// A tried height, and by how much the straightened force there exceeds the requested one.
type Tried<F> = (F, F);

/// The heights that were tried.
struct Heights<F> {
    /// The lowest with too little force, and the highest with too much.
    above: Option<Tried<F>>,
    below: Option<Tried<F>>,
    /// One at which the wheel is too deep in the rail to have a force, and the first error there.
    deep: Option<(F, Error)>,
    /// The last one with a force.
    last: Option<Tried<F>>,
    /// How many have no force above a height that is too deep.
    empty: u32,
    /// The lowest height that is too deep.
    lowest: Option<F>,
}

/// Whether the wheel is too deep in the rail to have a force, or beside it.
const fn is_too_deep(error: Error) -> bool {
    matches!(error, Error::ProfileEnd | Error::Overflow | Error::PatchSize)
}

impl<F: Float> Heights<F> {
    const fn new() -> Self {
        Self { above: None, below: None, deep: None, last: None, empty: 0, lowest: None }
    }

    fn note_deep(&mut self, height: F, error: Error) {
        let first = self.deep.map_or(error, |(_, first)| first);
        self.deep = Some((height, first));
        self.lowest = Some(self.lowest.map_or(height, |lowest| lowest.max(height)));
    }

    /// Notes a height without a force. Returns whether the wheel may touch below an edge only.
    fn is_above_edge(&mut self) -> bool {
        self.empty += u32::from(self.deep.is_some() && self.below.is_none());
        self.empty >= EMPTY
    }

    /// Notes a height, by how much the straightened force there exceeds the requested one, and the
    /// slope of that force as Hertz says, if there is a force. Returns the place of the next step.
    fn note(&mut self, height: F, excess: F, by_hertz: Option<F>) -> Option<F> {
        let side = if excess < F::zero() { &mut self.above } else { &mut self.below };
        *side = Some((height, excess));
        let secant = self.last.map(|(place, more)| (excess - more) / (height - place));
        self.last = by_hertz.map(|_| (height, excess));
        let slope = secant.or(by_hertz).filter(|slope| *slope > F::zero());
        slope.map(|slope| height - excess / slope)
    }

    /// The highest place that is known to be too low, with an error where it is too deep.
    fn too_low(&self) -> Option<(F, Option<Error>)> {
        match (self.below, self.deep) {
            (Some((low, _)), Some((deep, error))) if deep < low => Some((deep, Some(error))),
            (Some((low, _)), _) => Some((low, None)),
            (None, deep) => deep.map(|(deep, error)| (deep, Some(error))),
        }
    }
}

/// How the support varies over the heights that were tried.
struct Trend<F> {
    /// Depth of the deepest place with too little support, and its support.
    least: Option<(F, F)>,
    /// Whether the support falls with depth somewhere, by more than its rounding.
    falls: bool,
    rounding: F,
}

impl<F: Float> Trend<F> {
    /// Notes the support at a height. At the first touch it is zero.
    fn note(&mut self, height: F, support: F, has_too_little: bool) {
        let (_, before) =
            self.least.filter(|(above, _)| *above < height).unwrap_or((height, F::zero()));
        self.falls |= support < before - self.rounding;
        if has_too_little {
            self.least = Some((height, support));
        }
    }
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
        let mut here = touches + expected * per_normal;
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
                    None
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
                        touches = nearest(&memory.gap).map_or(touches, |distance| here + distance);
                        if heights.is_above_edge() {
                            let from = heights.lowest.unwrap_or(here);
                            here = self.below_edge(from, expected, length, position, memory)?;
                            (heights, touches) = (Heights::new(), here);
                            continue;
                        }
                    }
                    next
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
                    // a secant that does not close in is followed by halvings
                    let inside = next.filter(|next| *next > high && *next < low);
                    if tried % 8 == 7 { middle } else { inside.unwrap_or(middle) }
                }
                (Some((high, _)), None) => {
                    let from = high.max(touches);
                    let farthest = from + (high - touches).max(expected) * F::of(DEPTH_GROWTH);
                    let next = next.or(Some(touches + expected * per_normal));
                    next.filter(|next| *next > high).map_or(farthest, |next| next.min(farthest))
                }
                (None, Some((low, _))) => {
                    let farthest = low - (touches - low).max(expected) * F::of(DEPTH_GROWTH);
                    next.filter(|next| *next < low).map_or(farthest, |next| next.max(farthest))
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

    /// The first height below an edge at which the wheel touches and is not too deep: by steps that
    /// grow.
    ///
    /// # Errors
    /// [`Error::ProfileEnd`] if there is none within a length; those of [`Scene::place`].
    fn below_edge(
        &self, from: F, mut step: F, length: F, position: &Position<F>, memory: &mut Workspace<F>,
    ) -> Result<F, Error> {
        let mut here = from;
        while here < from + length {
            here += step;
            step = step.times(2.0);
            match self.place(&Position { vertical: here, ..*position }, memory) {
                Err(error) if !is_too_deep(error) => return Err(error),
                Ok(_) if memory.count > 0 => return Ok(here),
                _ => {}
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

    /// The upward force of the rail on the wheel, without a velocity that of the pressure alone;
    /// and the derivative of the latter with respect to the vertical position.
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
        Ok([force.unwrap_or(pressure), stiffness])
    }

    /// About the vertical position at which the wheel touches first on its way down, and by how
    /// much it moves down for a unit of approach there.
    fn first_touch(&self, position: &Position<F>) -> Result<[F; 2], Error> {
        let right = position.mirrored(self.pair.left != 0);
        let found = self.search_at(&right)?.lowered();
        let [touches, cosine] = found.ok_or(Error::ProfileEnd)?;
        Ok([touches, F::one() / cosine.abs().max(F::of(0.1))])
    }
}

/// The least distance of the points of a gap; none where all points are farther than it reaches.
fn nearest<F: Float>(gap: &Gap<F>) -> Option<F> {
    let distances = gap.distance.iter().take(gap.count as usize).copied();
    distances.reduce(F::min).map(|least| least.max(F::zero()))
}
