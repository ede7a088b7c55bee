//! A contact patch from profiles: the distance of two bodies across the rolling direction, and what
//! presses them together.
//!
//! 1. **Approach**: a first guess of the approach `δ` and of the contact's width, from the overlap
//!    of the undeformed bodies when they are shifted by `0.55 δ` ([`Profile`]).
//! 2. **Smoothing** over a length that follows from this width. Without smoothing the noise of
//!    measured points would act like asperities (`Curve`).
//! 3. **Estimate** of load and deflection by the least energy (`Estimate`), which gives `δ` again.
//! 4. **Zones** where `h + 0.73 u < δ`, laid end to end, and cells on them (`layout`).
//! 5. The [normal problem](cells) on the cells. The pressures are solved for, then the lengths are
//!    corrected; this is done twice, and the pressures are solved for once more.
//!
//! Every number carries its derivative by the given load or approach, and no branch changes a value
//! where it switches. Therefore load, approach and strips are continuous functions of load,
//! approach and distances, and the stiffness is the derivative of the computed load.

pub mod cells;
mod density;
mod equations;
mod estimate;
mod influence;
mod layout;
pub(crate) mod parabola;
pub mod profile;
pub(crate) mod smooth;

use crate::contact::material::{check_modulus, check_poisson_ratio};
use crate::contact::totals::StripCount;
use crate::normal::cells::{Cells, Given};
use crate::normal::density::Zones;
use crate::normal::equations::Equations;
use crate::normal::estimate::{Estimate, OVERLAP};
use crate::normal::layout::{layout, lean};
pub use crate::normal::profile::Profile;
use crate::normal::profile::{WithSlope, invert};
use crate::normal::smooth::{Curve, length_for};
use crate::number::{Arithmetic, Float};
use crate::patch::{Patch, PatchStrip};
use crate::status::{Error, Warning};
use core::f64::consts::PI;
use heapless::Vec;

/// Share of the estimated deflection that lies between the undeformed bodies at the edge of the
/// contact.
const DEFLECTED: f64 = 0.73;
/// Largest height above the lowest point, over the first guess of the approach, at which the curve
/// has knots.
const REACH: f64 = 1.6;
/// Number of corrections of the lengths.
const PASSES: usize = 2;
/// Power of a correction times the number of lengths that it moves.
const POWER: f64 = 0.94;
/// Least square of a half length, over `R δ`.
const LEAST_SQUARE: f64 = 0.06;

/// Pressure over length, in units of the mean of the patch, below which a strip is shortened, and
/// the least share that is left of its length.
const LEAST_SLOPE: f64 = 0.25;
const LEAST_LENGTH: f64 = 1e-3;

/// What presses two profiles together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileContact<F> {
    /// Rolling radius `R` \[m\], positive; of two rolling bodies `1/R = 1/R₁ + 1/R₂`.
    pub rolling_radius: F,
    /// The load, the approach or the overlap.
    pub given: Given<F>,
    /// Combined shear modulus `G` \[Pa\], positive.
    pub shear_modulus: F,
    /// Combined Poisson's ratio `ν`, 0 to 1/2.
    pub poisson_ratio: F,
    /// Coefficient of friction `μ` of every strip, not negative.
    pub friction: F,
    /// Smoothing length `s` \[m\], not negative. Zero: half the width of the contact and at most 2
    /// mm. It is always at least 2.5 steps of the profile. Narrower details are rounded off. Twice
    /// the length halves the effect of a noise of 3 µm on the peak pressure.
    pub smoothing_length: F,
}

impl<F: Float> ProfileContact<F> {
    /// Checks the members; a rolling radius of its own is needed unless the profile has radii.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::RollingRadius`], [`Error::NormalForce`], [`Error::Modulus`],
    /// [`Error::PoissonRatio`], [`Error::Friction`], [`Error::SmoothingLength`].
    pub fn check(&self, has_radii: bool) -> Result<(), Error> {
        let given = self.given.value();
        let radius = if has_radii { F::one() } else { self.rolling_radius };
        let inputs = [radius, given, self.friction, self.smoothing_length];
        if !inputs.iter().all(|input| input.is_finite_number()) {
            return Err(Error::NotFinite);
        }
        if radius <= F::zero() {
            return Err(Error::RollingRadius);
        }
        if matches!(self.given, Given::Load(load) if load < F::zero()) {
            return Err(Error::NormalForce);
        }
        check_modulus(self.shear_modulus)?;
        check_poisson_ratio(self.poisson_ratio)?;
        if self.friction < F::zero() {
            return Err(Error::Friction);
        }
        if self.smoothing_length < F::zero() {
            return Err(Error::SmoothingLength);
        }
        Ok(())
    }

    fn smoothing(&self, half_width: WithSlope<F>) -> WithSlope<F> {
        if self.smoothing_length > F::zero() {
            WithSlope::from_base(self.smoothing_length)
        } else {
            length_for(half_width)
        }
    }

    /// `E* = G/(1 − ν)`
    pub(super) fn modulus(&self) -> F {
        self.shear_modulus / (F::one() - self.poisson_ratio)
    }
}

/// Approach, load and pressure of two profiles in contact.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Indentation<F> {
    /// Approach of distant points of the two bodies \[m\] from where they touch: at the lowest
    /// point of the smoothed profile.
    pub approach: F,
    /// Normal force of the strips \[N\]. If a load is given, it is that load to rounding.
    pub normal_force: F,
    /// Derivative of the normal force with respect to the approach \[N/m\].
    pub stiffness: F,
    /// Largest pressure of a strip \[Pa\].
    pub peak_pressure: F,
    /// y of the strip with the largest pressure \[m\].
    pub peak_y: F,
    /// Steps of the two searches for the approach, at most 60 each.
    pub iterations: u32,
    /// The status of this result: 0, or KSTRIP_WARNING_PROFILE_END where a zone of contact ends
    /// with the profile.
    pub warning: Warning,
    /// Distance at that lowest point \[m\], or of the given points without contact: the bodies have
    /// moved by approach + lowest.
    pub lowest: F,
}

/// Cells of the normal problem for about `count` strips.
const fn number_of_cells(count: StripCount) -> usize {
    match count {
        StripCount::Four => 8,
        StripCount::Eight => 12,
        StripCount::Sixteen => 18,
        StripCount::ThirtyTwo => 36,
        StripCount::SixtyFour => 40,
    }
}

impl<F: Float> Indentation<F> {
    /// The result without contact.
    fn none(profile: &Profile<F>) -> Self {
        let [first, last] = profile.ends;
        let none = F::zero();
        Self {
            approach: none,
            normal_force: none,
            stiffness: none,
            peak_pressure: none,
            peak_y: first.times(0.5) + last.times(0.5),
            iterations: 0,
            warning: Warning::None,
            lowest: profile.lowest,
        }
    }

    /// Solves the contact, and hands the strips that touch to `take`.
    ///
    /// # Errors
    /// Those of [`Patch::from_profile`].
    pub(crate) fn new(
        profile: &Profile<F>,
        contact: &ProfileContact<F>,
        count: StripCount,
        take: impl FnMut(PatchStrip<F>) -> bool,
    ) -> Result<Self, Error> {
        contact.check(profile.has_radii())?;
        let value = contact.given.value();
        if value <= F::zero() {
            return Ok(Self::none(profile));
        }
        // N/(π E*), or the approach
        let unit = F::one() / contact.modulus().times(PI);
        let input = WithSlope::input(value, 0);
        let given = match contact.given {
            Given::Load(_) => Given::Load(input.scale(unit)),
            Given::Approach(_) => Given::Approach(input),
        };
        let mut cells = Cells { list: Vec::new() };
        match Outline::new(profile, contact, given, count, &mut cells)? {
            Some(outline) => Self::pressed(profile, contact, &mut cells, outline, take),
            None => Ok(Self::none(profile)),
        }
    }

    /// The same of a part of the curve of two surfaces, for a given approach.
    ///
    /// # Errors
    /// Those of [`Patch::from_profile`].
    pub(crate) fn of_surfaces(
        profile: &Profile<F>,
        curve: &Curve<F>,
        contact: &ProfileContact<F>,
        count: StripCount,
        take: impl FnMut(PatchStrip<F>) -> bool,
    ) -> Result<Self, Error> {
        contact.check(true)?;
        let approach = WithSlope::input(contact.given.value(), 0);
        if approach.value <= F::zero() {
            return Ok(Self::none(profile));
        }
        let mut cells = Cells { list: Vec::new() };
        let radius = |loads: &mut dyn Iterator<Item = [WithSlope<F>; 2]>| {
            // (of nothing that of the contact)
            let tiny = WithSlope::from_base(F::TINY);
            let (mut sum, mut moment) = (tiny, tiny * WithSlope::from_base(contact.rolling_radius));
            for [y, load] in loads {
                sum += load;
                moment += load * profile.rolling_radius(y, contact.rolling_radius);
            }
            moment / sum
        };
        let given = Given::Approach(approach);
        let outline = Outline::with_cells(
            profile,
            contact,
            curve,
            (given, approach),
            radius,
            count,
            &mut cells,
        );
        // (an overlap of a few roundings may be narrower than rounding)
        if cells.list.is_empty() {
            return Ok(Self::none(profile));
        }
        Self::pressed(profile, contact, &mut cells, outline, take)
    }

    /// The strips of cells, and the result.
    fn pressed(
        profile: &Profile<F>,
        contact: &ProfileContact<F>,
        cells: &mut Cells<F>,
        outline: Outline<F>,
        mut take: impl FnMut(PatchStrip<F>) -> bool,
    ) -> Result<Self, Error> {
        let Outline { given, power, iterations, at_end, lowest } = outline;
        let pressed = solved(cells, power, given);
        let load = cells.load();
        let ([by_load], [by_approach]) = (pressed.gradient, load.gradient);
        let modulus = contact.modulus().times(PI);
        let mut found = Self {
            // (of a profile at the ends of the number range rounding leaves less than nothing)
            approach: pressed.value.max(F::zero()),
            normal_force: load.value * modulus,
            stiffness: match given {
                Given::Load(_) => F::one() / by_load,
                _ => by_approach * modulus,
            },
            iterations,
            warning: if at_end { Warning::ProfileEnd } else { Warning::None },
            lowest: profile.lowest + lowest,
            ..Self::none(profile)
        };
        let results = [found.approach, found.normal_force, found.stiffness, found.lowest];
        if !results.iter().all(|result| result.is_finite_number()) {
            return Err(Error::Overflow);
        }
        let [slope, usual] = cells.means();
        let slope = slope.times(LEAST_SLOPE);
        for cell in cells.list.iter().filter(|cell| cell.pressure.value > F::zero()) {
            // the same load on less: the length of a strip that begins to touch vanishes with its
            // pressure
            let (a, p) = (cell.half_length.value, cell.pressure.value);
            let share = (p / (slope * a)).min(F::one()).sqrt().max(F::of(LEAST_LENGTH));
            // and on the usual width: what is wider carries little
            let width = cell.width.value.min(usual);
            let p = p * (cell.width.value / width);
            let strip = PatchStrip {
                y: cell.y.value,
                width,
                half_length: a * share,
                centre_x: profile.centre_x(cell.y.value),
                peak_pressure: p / share * modulus,
                friction: contact.friction,
            };
            if strip.peak_pressure > found.peak_pressure {
                (found.peak_pressure, found.peak_y) = (strip.peak_pressure, strip.y);
            }
            if !take(strip) {
                return Err(Error::PatchSize);
            }
        }
        Ok(found)
    }
}

/// Pressures and corrected lengths of the cells; the approach. (Out of line, lest the equations
/// take room while the outline is made.)
#[inline(never)]
fn solved<F: Float>(
    cells: &mut Cells<F>,
    power: WithSlope<F>,
    given: Given<WithSlope<F>>,
) -> WithSlope<F> {
    let mut equations = Equations::new();
    let mut pressed = cells.press(&mut equations, given);
    for _ in 0..PASSES {
        cells.correct(power);
        pressed = cells.press(&mut equations, given);
    }
    pressed
}

/// What is known of the cells besides.
struct Outline<F> {
    /// The load or the approach.
    given: Given<WithSlope<F>>,
    /// Of a correction of the lengths.
    power: WithSlope<F>,
    iterations: u32,
    /// Whether a zone ends with the profile.
    at_end: bool,
    /// Lowest point of the smoothed profile above that of the given points.
    lowest: F,
}

impl<F: Float> Outline<F> {
    /// Where cells lie, with their first lengths. None where the smoothed profile does not reach
    /// the other body. (Out of line: what leads to the cells need not be kept while they are
    /// solved.)
    #[inline(never)]
    fn new(
        profile: &Profile<F>,
        contact: &ProfileContact<F>,
        given: Given<WithSlope<F>>,
        count: StripCount,
        cells: &mut Cells<F>,
    ) -> Result<Option<Self>, Error> {
        let radius = contact.rolling_radius;
        // about the approach, and the curve that its width asks for
        let (first, mut iterations) = match given {
            Given::Approach(approach) => (approach, 0),
            Given::Load(load) => {
                let load = load.times(PI);
                // of a sphere: N = (4/3) E* √R δ^(3/2)
                let like_sphere = (load.value.times(0.75) / radius.sqrt()).cube_root();
                let start = like_sphere * like_sphere;
                invert(load, start, |approach| profile.load(approach, radius))
                    .ok_or(Error::Overflow)?
            }
        };
        let section = profile.section(first, radius);
        let length = contact.smoothing(section.half_width);
        let mut curve = Curve::new(profile, length, first.times(REACH));
        let radius_there = section.rolling_radius;
        // load and deflection before the normal problem
        let approach = match given {
            Given::Approach(approach) => approach,
            Given::Load(load) => {
                curve.still = true;
                let still_radius = WithSlope::from_base(radius_there.value);
                let load_at = |approach| Estimate::load(&curve, approach, still_radius);
                let (found, steps) = invert(load, first.value, load_at).ok_or(Error::Overflow)?;
                curve.still = false;
                iterations += steps;
                // f(δ, c) = N, the curve c depending on N: dδ/dN = (1 − ∂f/∂c dc/dN)/(∂f/∂δ)
                let here = WithSlope::from_base(found.value);
                let [by_curve] = Estimate::load(&curve, here, radius_there).gradient;
                let ([by_load], [unit]) = (found.gradient, load.gradient);
                let rest = F::one() - by_curve / unit;
                WithSlope { value: found.value, gradient: [by_load * rest] }
            }
        };
        if approach.value <= F::zero() {
            return Ok(None);
        }
        let outline = Self::with_cells(
            profile,
            contact,
            &curve,
            (given, approach),
            |_| radius_there,
            count,
            cells,
        );
        Ok(Some(Self { iterations, lowest: curve.lowest.value, ..outline }))
    }

    /// The cells of a curve for an approach.
    fn with_cells(
        profile: &Profile<F>,
        contact: &ProfileContact<F>,
        curve: &Curve<F>,
        (given, approach): (Given<WithSlope<F>>, WithSlope<F>),
        radius: impl FnOnce(&mut dyn Iterator<Item = [WithSlope<F>; 2]>) -> WithSlope<F>,
        count: StripCount,
        cells: &mut Cells<F>,
    ) -> Self {
        let mut zones = Zones::new(approach, curve.smoothing());
        let (at_end, mean_radius) = touching(curve, approach, radius, &mut zones);
        let mut places = Vec::new();
        let width = layout(&zones, number_of_cells(count), &mut places);
        lean(&mut places);
        let first_lengths = Lengths::new(width, mean_radius, approach);
        cells.place(&places, |y| {
            let height = curve.at(y);
            let radius = profile.rolling_radius(y, contact.rolling_radius);
            let touches = approach.value.times(OVERLAP) > height.value;
            ([height, radius, first_lengths.at(height, radius)], touches)
        });
        let power = first_lengths.power(given);
        Self { given, power, iterations: 0, at_end, lowest: F::zero() }
    }
}

/// Zones where the bodies touch by the estimate; returns whether one of them ends with the profile,
/// and the rolling radius. (Out of line: the estimate need not be kept while the cells are made.)
#[inline(never)]
fn touching<F: Float>(
    curve: &Curve<F>,
    approach: WithSlope<F>,
    radius: impl FnOnce(&mut dyn Iterator<Item = [WithSlope<F>; 2]>) -> WithSlope<F>,
    zones: &mut Zones<F>,
) -> (bool, WithSlope<F>) {
    let mut estimate = Estimate::nothing();
    let mut mean_radius = WithSlope::zero();
    estimate.fill(curve, approach, |loads| {
        mean_radius = radius(loads);
        mean_radius
    });
    let at_end = curve.zones(zones, |y, height, slope| {
        let [deflection, bend] = estimate.deflection(y);
        let height = height - approach + deflection.times(DEFLECTED);
        [height, slope + bend.times(DEFLECTED)]
    });
    (at_end, mean_radius)
}

/// First half lengths: those of an ellipse at whose rim the undeformed bodies are `λ δ` apart when
/// they approach by `δ`.
struct Lengths<F> {
    rim: WithSlope<F>,
    /// About the logarithm of the axis ratio, times 1.13.
    slenderness: WithSlope<F>,
    approach: WithSlope<F>,
}

impl<F: Float> Lengths<F> {
    fn new(width: WithSlope<F>, radius: WithSlope<F>, approach: WithSlope<F>) -> Self {
        let ratio = width.times(1.0 / 2.1) / (radius * approach).sqrt();
        let logarithm = ratio.value.ln_quotient(F::one());
        let logarithm = WithSlope::composed(logarithm, [F::one() / ratio.value], [ratio]);
        let x = logarithm.times(1.13);
        let rim = (x / x.squared().times(1.53).plus(16.2).sqrt()).plus(1.0).times(0.5);
        Self { rim, slenderness: x, approach }
    }

    /// `a² = 2 R (1 − λ)(δ − h/λ)`, and at least about `0.06 R δ`.
    fn at(&self, height: WithSlope<F>, radius: WithSlope<F>) -> WithSlope<F> {
        let double = radius.times(2.0);
        let square = double * (WithSlope::one() - self.rim) * (self.approach - height / self.rim);
        let least = (radius * self.approach).times(LEAST_SQUARE);
        let apart = square - least;
        let root = (apart.squared() + least.squared()).sqrt();
        (square + least + root).times(0.5).sqrt()
    }

    /// The power of a correction of the lengths. A correction of one length changes the condition
    /// at its neighbours as well, less so in slender patches.
    fn power(&self, given: Given<WithSlope<F>>) -> WithSlope<F> {
        let more = match given {
            // 1.6/(1 + (g/0.6)^1.3)
            Given::Load(_) => {
                let logarithm = self.slenderness.plus(0.510_825_623_765_990_7).times(1.3);
                let power = logarithm.value.min(F::of(60.0)).exp();
                let power = WithSlope::composed(power, [power], [logarithm]);
                power.plus(1.0).inverse().times(1.6)
            }
            _ => WithSlope::constant(0.1),
        };
        more.plus(2.0).inverse().times(POWER)
    }
}

impl<F: Float, const CAPACITY: usize> Patch<F, CAPACITY> {
    /// The patch of two profiles in contact, in about `count` strips, 40 at most, and one more for
    /// each further zone.
    ///
    /// # Errors
    /// Those of [`ProfileContact::check`]; [`Error::PatchSize`] when the capacity is too small;
    /// [`Error::Overflow`].
    ///
    /// # Example
    /// A wheel of 0.46 m radius on a rail head of 0.30 m:
    /// ```
    /// use kstrip::contact::totals::StripCount;
    /// use kstrip::{patch::Patch, normal::{Profile, ProfileContact, cells::Given}};
    /// let y: [f64; 41] = core::array::from_fn(|i| (i as f64 - 20.0) * 0.5e-3);
    /// let distance = y.map(|y| y * y / (2.0 * 0.30));
    /// let contact = ProfileContact {
    ///     rolling_radius: 0.46, given: Given::Load(80e3), smoothing_length: 0.0,
    ///     shear_modulus: 82e9, poisson_ratio: 0.28, friction: 0.3,
    /// };
    /// let profile = Profile::new(&y, &distance)?;
    /// let (patch, found) =
    ///     Patch::<f64, 32>::from_profile(&profile, &contact, StripCount::Sixteen)?;
    /// assert!((patch.view()?.normal_force() - 80e3).abs() < 1e-6);
    /// // Hertz: 90.5 µm; the highest pressure within a strip of the middle; dN/dδ = 3 N/(2 δ)
    /// assert!((found.approach - 90.5e-6).abs() < 1e-6, "{}", found.approach);
    /// assert!(found.peak_y.abs() < 0.5e-3, "{}", found.peak_y);
    /// assert!((found.stiffness * found.approach / 80e3 - 1.5).abs() < 0.05);
    /// # Ok::<(), kstrip::status::Error>(())
    /// ```
    pub fn from_profile(
        profile: &Profile<F>,
        contact: &ProfileContact<F>,
        count: StripCount,
    ) -> Result<(Self, Indentation<F>), Error> {
        // (the first guess of the approach takes a radius)
        let rolling_radius = profile.first_radius(contact.rolling_radius);
        let contact = &ProfileContact { rolling_radius, ..*contact };
        let mut patch = Self::empty(contact.shear_modulus, contact.poisson_ratio);
        let found =
            Indentation::new(profile, contact, count, |strip| patch.strips.push(strip).is_ok())?;
        patch.check(found.normal_force)?;
        Ok((patch, found))
    }
}
