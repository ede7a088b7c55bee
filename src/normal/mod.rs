//! A contact patch from profiles: the distance of two bodies across the rolling direction, and what
//! presses them together.
//!
//! 1. **Approach**: a first guess of the approach `δ` and of the contact's width, from the overlap
//!    of the undeformed bodies when they are shifted by `0.55 δ` ([`Profile`]).
//! 2. **Smoothing** over a length that follows from this width. Without smoothing the noise of
//!    measured points would act like asperities (`SmoothedProfile`).
//! 3. **Estimate** of load and deflection by the least energy (`Estimate`), which gives `δ` again.
//! 4. **Zones** where `h + 0.73 u < δ`, laid end to end, and cells on them (`layout`).
//! 5. The [normal problem](cells) on the cells. The pressures are solved for, then the lengths are
//!    corrected; this is done twice, and the pressures are solved for once more.
//! 6. **Skew** of a contact whose distance is least along `x` at places that change across it.
//!
//! Every number carries its derivative with respect to the given load or approach, and no branch
//! changes a value where it switches. Therefore load, approach and strips are continuous functions
//! of load, approach and distances, and the stiffness is the derivative of the computed load.

pub(crate) mod cell;
mod cell_edges;
pub mod cells;
pub(crate) mod crossings;
mod density;
mod equations;
mod estimate;
mod extremes;
mod influence;
mod knot_grid;
mod layout;
pub(crate) mod moving;
pub(crate) mod outline;
pub(crate) mod parabola;
pub mod profile;
mod profile_contact;
mod skew;
pub(crate) mod smooth;

use crate::contact::totals::StripCount;
use crate::normal::cells::{Cells, Given};
use crate::normal::equations::Equations;
use crate::normal::outline::Outline;
pub use crate::normal::profile::Profile;
pub use crate::normal::profile_contact::ProfileContact;
use crate::normal::smooth::SmoothedProfile;
use crate::number::{Arithmetic, Dual, Float, Number};
use crate::patch::{Patch, PatchStrip};
use crate::status::{Error, Warning};
use core::f64::consts::PI;

/// Number of corrections of the lengths.
const LENGTH_CORRECTIONS: usize = 2;
/// Pressure over length, by the patch's mean, below which strips are shortened; least share left.
const LEAST_SLOPE: f64 = 0.28;
const LEAST_LENGTH: f64 = 1e-3;

/// Approach, load and pressure of two profiles in contact.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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
    /// Sum of the steps of the two searches for the approach, at most 60 for each search. It is 0
    /// if the approach is given.
    pub iterations: u32,
    /// The status of this result: 0, or KSTRIP_WARNING_PROFILE_END if a contact region ends
    /// with the profile.
    pub warning: Warning,
    /// Distance at that lowest point \[m\], or of the given points without contact: the bodies have
    /// moved by approach + lowest.
    pub lowest: F,
}

impl<F: Float> Indentation<F> {
    /// The result without contact.
    fn none(profile: &Profile<F>) -> Self {
        let [first, last] = profile.ends;
        let peak_y = first.times(0.5) + last.times(0.5);
        Self { peak_y, lowest: profile.lowest, ..Self::default() }
    }

    /// Solves the contact; `cells` receives what strips are made of, nothing without contact.
    pub(crate) fn new(
        profile: &Profile<F>, contact: &ProfileContact<F>, count: StripCount,
        cells: &mut Cells<F, 1>,
    ) -> Result<Self, Error> {
        // the first guess of the approach requires a radius
        let radii = profile.rolling_radius;
        let rolling_radius = radii.first().copied().unwrap_or(contact.rolling_radius);
        let contact = &ProfileContact { rolling_radius, ..*contact };
        contact.check(!radii.is_empty())?;
        cells.list.clear();
        let value = contact.given.number();
        if value <= F::zero() {
            return Ok(Self::none(profile));
        }
        // N/(π E*), or the approach
        let unit = F::one() / contact.modulus().times(PI);
        let input = Dual::<F, 1>::input(value, 0);
        let given = match contact.given {
            Given::Load(_) => Given::Load(input.scale(unit)),
            Given::Approach(_) => Given::Approach(input),
        };
        let Some(outline) = Outline::new(profile, contact, given, count, cells)? else {
            return Ok(Self::none(profile));
        };
        Self::pressed(profile, contact, cells, outline)
    }

    /// The same of a part of the curve of two surfaces, for a given approach, whose derivatives
    /// are those that are requested; `cells` receives what strips are made of, nothing without
    /// contact.
    pub(crate) fn of_surfaces<const N: usize>(
        profile: &Profile<F>, curve: &SmoothedProfile<F, N>, contact: &ProfileContact<F>,
        approach: Dual<F, N>, count: StripCount, cells: &mut Cells<F, N>,
    ) -> Result<Self, Error> {
        contact.check(true)?;
        cells.list.clear();
        if approach.value <= F::zero() {
            return Ok(Self::none(profile));
        }
        let radius = |loads: &mut dyn Iterator<Item = [Dual<F, N>; 2]>| {
            // without load the radius is that of the contact
            let tiny = Dual::from_base(F::TINY);
            let (mut sum, mut moment) = (tiny, tiny * Dual::from_base(contact.rolling_radius));
            for [y, load] in loads {
                sum += load;
                moment += load * profile.rolling_radius(y, contact.rolling_radius);
            }
            moment / sum
        };
        let given = Given::Approach(approach);
        let outline =
            Outline::with_cells(profile, contact, curve, (given, approach), radius, count, cells);
        // an overlap of a few roundings may have no width
        if cells.list.is_empty() {
            return Ok(Self::none(profile));
        }
        Self::pressed(profile, contact, cells, outline)
    }

    /// Solves for the pressures of cells.
    fn pressed<const N: usize>(
        profile: &Profile<F>, contact: &ProfileContact<F>, cells: &mut Cells<F, N>,
        outline: Outline<F, N>,
    ) -> Result<Self, Error> {
        let Outline { given, power, partly, iterations, warning, lowest } = outline;
        let pressed = solve_pressures(cells, [power, partly], given) * cells.skew(given);
        let load = cells.load();
        let (by_load, by_approach) = (pressed.derivative(0), load.derivative(0));
        let modulus = contact.modulus().times(PI);
        let found = Self {
            // for a profile at the ends of the number range rounding may make this negative
            approach: pressed.value.max(F::zero()),
            normal_force: load.value * modulus,
            stiffness: match given {
                Given::Load(_) => F::one() / by_load,
                _ => by_approach * modulus,
            },
            iterations,
            warning,
            lowest: profile.lowest + lowest,
            ..Self::none(profile)
        };
        let results = [found.approach, found.normal_force, found.stiffness, found.lowest];
        Error::Overflow.unless(results.iter().all(|result| result.is_finite_number()))?;
        Ok(found)
    }

    /// Hands the strips that touch to `take`, made of the numbers that `of` makes of those of
    /// cells.
    pub(crate) fn strips<const N: usize>(
        &mut self, contact: &ProfileContact<F>, cells: &Cells<F, N>, of: impl Fn(Dual<F, N>) -> F,
        mut take: impl FnMut(PatchStrip<F>) -> bool,
    ) -> Result<(), Error> {
        let modulus = contact.modulus().times(PI);
        let [slope, usual] = cells.means(&of);
        let slope = slope.times(LEAST_SLOPE);
        for cell in cells.list.iter().filter(|cell| cell.pressure.value > F::zero()) {
            // the same load on less: where a strip begins to touch, length and pressure vanish
            let (a, p) = (of(cell.half_length), of(cell.pressure));
            let share = (p / (slope * a)).min(F::one()).sqrt().max(F::of(LEAST_LENGTH));
            // and on the usual width: what is wider carries little
            let width = of(cell.width).min(usual);
            let p = p * (of(cell.width) / width);
            let strip = PatchStrip {
                y: of(cell.y),
                width,
                half_length: a * share,
                centre_x: of(cell.centre_x),
                peak_pressure: p / share * modulus,
                friction: contact.friction,
            };
            if strip.peak_pressure > self.peak_pressure {
                (self.peak_pressure, self.peak_y) = (strip.peak_pressure, strip.y);
            }
            Error::PatchSize.unless(take(strip))?;
        }
        Ok(())
    }
}

/// Pressures and corrected lengths of the cells; the approach.
fn solve_pressures<F: Float, const N: usize>(
    cells: &mut Cells<F, N>, by: [Dual<F, N>; 2], given: Given<Dual<F, N>>,
) -> Dual<F, N> {
    if N == 1 {
        press_and_correct::<F, N, 1>(cells, by, given)
    } else {
        press_and_correct::<F, N, 0>(cells, by, given)
    }
}

/// The same with room for derivatives of the influence in so many directions. It stays out of line,
/// so that only here the equations take room on the stack.
#[inline(never)]
fn press_and_correct<F: Float, const N: usize, const STORED: usize>(
    cells: &mut Cells<F, N>, [power, partly]: [Dual<F, N>; 2], given: Given<Dual<F, N>>,
) -> Dual<F, N> {
    let mut equations = Equations::<F, STORED>::new();
    let mut pressed = cells.press(&mut equations, partly, given);
    for _ in 0..LENGTH_CORRECTIONS {
        cells.correct(power);
        pressed = cells.press(&mut equations, partly, given);
    }
    pressed
}

impl<F: Float> Patch<F> {
    /// The patch of two profiles in contact, in about `count` strips, 40 at most, 16 on a
    /// microcontroller, and one more for each further zone.
    ///
    /// # Errors
    /// Those of [`ProfileContact::check`]; [`Error::Overflow`].
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
    /// let (patch, found) = Patch::from_profile(&profile, &contact, StripCount::Sixteen)?;
    /// assert!((patch.view()?.normal_force() - 80e3).abs() < 1e-6);
    /// // Hertz: 90.5 µm; the highest pressure within a strip of the middle; dN/dδ = 3 N/(2 δ)
    /// assert!((found.approach - 90.5e-6).abs() < 1e-6, "{}", found.approach);
    /// assert!(found.peak_y.abs() < 0.5e-3, "{}", found.peak_y);
    /// assert!((found.stiffness * found.approach / 80e3 - 1.5).abs() < 0.05);
    /// # Ok::<(), kstrip::status::Error>(())
    /// ```
    pub fn from_profile(
        profile: &Profile<F>, contact: &ProfileContact<F>, count: StripCount,
    ) -> Result<(Self, Indentation<F>), Error> {
        let mut cells = Cells::nothing();
        let mut found = Indentation::new(profile, contact, count, &mut cells)?;
        let mut patch = Self::empty(contact.shear_modulus, contact.poisson_ratio);
        found.strips(contact, &cells, |number| number.value, |strip| patch.push(strip))?;
        // At the ends of the number range the strips may lack the digits to carry the load.
        let lost = (patch.view()?.normal_force() - found.normal_force).abs();
        Error::Overflow.unless(lost <= found.normal_force * F::constant(1e-3))?;
        Ok((patch, found))
    }
}
