//! A contact patch from profiles: the distance of two bodies across the rolling direction, and what presses them together.
//!
//! 1. **First guess** of the approach `δ`: where the bodies would overlap if they were shifted by `0.55 δ` only, the section has
//!    a volume and a width; the ellipse of both carries about the load.
//! 2. **Smoothing.** Around each strip a parabola is fitted to the profile, points weighted with `(1 − (d/s)²)³` up
//!    to the smoothing length `s` away: measured points have noise that the bodies' elasticity would take for asperities.
//! 3. **Coarse, then fine**: the [normal problem](super::normal) on half as many strips gives the approach, and with it the width
//!    of the strips; on these it is solved again, lengths interpolated from the first.
//!
//! The lattice of strips stands on the middle of the load and stretches with it; strips that may touch are more than
//! those that do. Everything is a continuous function of load and distances.

use crate::contact::forces::StripCount;
use crate::contact::material::{check_modulus, check_poisson_ratio};
use crate::number::Float;
use crate::patch::normal::{CELLS, Cells, Given};
pub use crate::patch::section::Profile;
use crate::patch::section::SECTION;
use crate::patch::smooth::Lattice;
use crate::patch::{Patch, PatchStrip};
use crate::solve::model::Precision;
use crate::status::Error;

/// Share of the approach below which bodies so far apart may touch: 0.5 for a circle, 0.74 in a long flat tail.
const REACH: f64 = 0.85;
/// Smoothing length by default, over the half length of the section.
const SMOOTHING: f64 = 0.6;
/// Share of the first guess that the approach may reach.
const GUESS: f64 = 1.6;
/// Strips of the coarse lattice.
const COARSE: u32 = 15;
/// Powers that correct the lengths of strips on the coarse lattice and on the fine one.
const COARSE_POWER: f64 = 0.5;
const FINE_POWER: f64 = 0.42;

/// Pressure over length, over the mean of the patch, below which a strip is shortened, and to what share at most.
const LEAST_SLOPE: f64 = 0.25;
const LEAST_LENGTH: f64 = 1e-3;

/// What presses two profiles together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileContact<F> {
    /// Rolling radius `R` \[m\], positive; of two rolling bodies `1/R = 1/R₁ + 1/R₂`.
    pub rolling_radius: F,
    /// The load or the approach.
    pub given: Given<F>,
    /// Combined shear modulus `G` \[Pa\], positive.
    pub shear_modulus: F,
    /// Combined Poisson's ratio `ν`, 0 to 1/2.
    pub poisson_ratio: F,
    /// Coefficient of friction `μ` of every strip, not negative.
    pub friction: F,
    /// Smoothing length `s` \[m\], not negative. Zero: 0.6 of the patch's approximate half length, 4 mm between a wheel and a
    /// rail, and at least two steps of the profile. Noise of 5 µm at points 0.05 mm apart then moves the force by 0.004 of `μ N`
    /// in the mean; what is narrower is rounded off.
    pub smoothing_length: F,
}

impl<F: Float> ProfileContact<F> {
    /// # Errors
    /// [`Error::NotFinite`], [`Error::RollingRadius`], [`Error::NormalForce`], [`Error::Modulus`],
    /// [`Error::PoissonRatio`], [`Error::Friction`], [`Error::SmoothingLength`].
    pub fn check(&self) -> Result<(), Error> {
        let (Given::Load(given) | Given::Approach(given)) = self.given;
        let inputs = [self.rolling_radius, given, self.friction, self.smoothing_length];
        if !inputs.iter().all(|input| input.is_finite_number()) {
            return Err(Error::NotFinite);
        }
        if self.rolling_radius <= F::zero() {
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

    /// `E* = G/(1 − ν)`
    pub(super) fn modulus(&self) -> F {
        self.shear_modulus / (F::one() - self.poisson_ratio)
    }
}

/// How two profiles meet.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Indentation<F> {
    /// Approach of distant points of the two bodies \[m\], from the smoothed profile's deepest point.
    pub approach: F,
    /// Normal force of the strips \[N\]; where a load is given, that to rounding.
    pub normal_force: F,
    /// Its derivative by the approach \[N/m\].
    pub stiffness: F,
    /// Largest pressure of a strip \[Pa\].
    pub peak_pressure: F,
    /// y of that strip \[m\].
    pub peak_y: F,
    /// Sections of the first guess, at most 40.
    pub iterations: u32,
    /// Zero.
    pub reserved: u32,
}

/// Strips of the lattice for about `count` strips that touch.
const fn lattice_strips(count: StripCount) -> u32 {
    let wanted = match count {
        StripCount::Four => 8,
        StripCount::Eight => 12,
        StripCount::Sixteen => 21,
        StripCount::ThirtyTwo | StripCount::SixtyFour => 36,
    };
    if wanted + 4 < CELLS as u32 { wanted } else { CELLS as u32 - 4 }
}

impl<F: Float> Indentation<F> {
    /// The strips that touch, handed to `take`, and what they carry.
    ///
    /// # Errors
    /// Those of [`Patch::from_profile`].
    pub(crate) fn new(
        profile: &Profile<F>,
        contact: &ProfileContact<F>,
        count: StripCount,
        mut take: impl FnMut(PatchStrip<F>) -> bool,
    ) -> Result<Self, Error> {
        let mut contact = *contact;
        if let Some(radius) = profile.mean_rolling_radius(F::of(1.5e-4)) {
            contact.rolling_radius = radius;
        }
        let contact = &contact;
        contact.check()?;
        if !(profile.depth() > F::zero()) {
            return Err(Error::ProfileEnd);
        }
        let (Given::Load(given) | Given::Approach(given)) = contact.given;
        if given <= F::zero() {
            let none = F::zero();
            return Ok(Self {
                approach: none,
                normal_force: none,
                stiffness: none,
                peak_pressure: none,
                peak_y: profile.deepest,
                iterations: 0,
                reserved: 0,
            });
        }
        let (first, iterations) = match contact.given {
            Given::Load(load) => profile.guess(contact, load)?,
            Given::Approach(approach) => (approach, 0),
        };
        let half_length = (contact.rolling_radius * first).times(2.0 * SECTION).sqrt();
        let length = if contact.smoothing_length > F::zero() {
            contact.smoothing_length
        } else {
            half_length.times(SMOOTHING).max(profile.step().times(2.0))
        };
        // Coarse
        let strips = lattice_strips(count);
        let level = first.times(GUESS * REACH);
        let none = || Cells::new(contact.rolling_radius, contact.modulus());
        let mut coarse = none();
        let lattice = Lattice::new(profile, level, length, strips.min(COARSE), None, &mut coarse)?;
        let above = |lowest: F| match contact.given {
            Given::Load(load) => Given::Load(load),
            Given::Approach(approach) => Given::Approach(approach + lowest),
        };
        let section = first.times(SECTION) + lattice.lowest;
        let double = contact.rolling_radius.times(2.0);
        coarse.begin(contact.given, first, |cell| (section - cell.distance) * double);
        let approach = coarse.solve(above(lattice.lowest), F::of(COARSE_POWER)).value;
        if !(approach.is_finite_number() && approach > F::zero()) {
            return Err(Error::Overflow);
        }
        // Fine, its squares of lengths between those of the coarse
        let level = approach.times(REACH);
        let (mut moment, mut sum) = (F::zero(), F::TINY);
        for cell in coarse.list.iter().filter(|cell| cell.touches) {
            let load = cell.half_length.value * (cell.pressure.value / contact.modulus());
            moment += load * (lattice.y(cell.place) - profile.deepest);
            sum += load;
        }
        let middle = Some(profile.deepest + moment / sum);
        let mut cells = none();
        let fine = Lattice::new(profile, level, length, strips, middle, &mut cells)?;
        // (a strip of the coarse lattice that hardly carries is as short as its pressure tells)
        let slope = coarse.mean_slope();
        cells.begin(contact.given, approach, |cell| {
            let between = (fine.y(cell.place) - lattice.y(0)) / lattice.width;
            let near = coarse.list.iter().filter(|cell| cell.touches);
            near.fold(F::zero(), |sum, cell| {
                let share = F::one() - (between - F::widened(cell.place as f32)).abs();
                let square = cell.half_length.value * (cell.pressure.value / slope);
                sum + square * share.max(F::zero())
            })
        });
        let given = above(fine.lowest);
        let approach = cells.solve(given, F::of(FINE_POWER));
        let load = cells.load();
        let stiffness = match given {
            Given::Load(_) => F::one() / approach.slope,
            Given::Approach(_) => load.slope,
        };
        let mut found = Self {
            approach: match contact.given {
                Given::Load(_) => (approach.value - fine.lowest).max(F::zero()),
                Given::Approach(approach) => approach,
            },
            normal_force: load.value,
            stiffness,
            peak_pressure: F::zero(),
            peak_y: profile.deepest,
            iterations,
            reserved: 0,
        };
        let [first, last] = profile.ends().ok_or(Error::Profile)?;
        let results = [found.approach, found.normal_force, found.stiffness];
        if !results.iter().all(|result| result.is_finite_number()) {
            return Err(Error::Overflow);
        }
        let slope = cells.mean_slope().times(LEAST_SLOPE);
        for cell in cells.list.iter().filter(|cell| cell.touches) {
            let y = fine.y(cell.place);
            if y - fine.width.times(1.5) < first || y + fine.width.times(1.5) > last {
                return Err(Error::ProfileEnd);
            }
            // the same load on less: the length of a strip that begins to touch vanishes with its pressure
            let (a, p) = (cell.half_length.value, cell.pressure.value);
            let share = (p / (slope * a)).min(F::one()).sqrt().max(F::of(LEAST_LENGTH));
            let strip = PatchStrip {
                y,
                width: fine.width,
                half_length: a * share,
                centre_x: profile.centre_x(y),
                peak_pressure: p / share,
                friction: contact.friction,
            };
            if strip.peak_pressure > found.peak_pressure {
                (found.peak_pressure, found.peak_y) = (strip.peak_pressure, y);
            }
            if !take(strip) {
                return Err(Error::PatchSize);
            }
        }
        Ok(found)
    }
}

impl<F: Precision, const CAPACITY: usize> Patch<F, CAPACITY> {
    /// The patch of two profiles in contact, in about `count` strips of one width, 32 at most.
    ///
    /// # Errors
    /// Those of [`ProfileContact::check`]; [`Error::ProfileEnd`] when the contact reaches an end of
    /// the profile; [`Error::PatchSize`] when its separate zones need more strips than there are, or the capacity is too
    /// small; [`Error::Overflow`].
    ///
    /// # Example
    /// A wheel of 0.46 m radius on a rail head of 0.30 m:
    /// ```
    /// use kstrip::contact::forces::StripCount;
    /// use kstrip::patch::{Patch, normal::Given, profile::{Profile, ProfileContact}};
    /// let y: [f64; 41] = core::array::from_fn(|i| (i as f64 - 20.0) * 0.5e-3);
    /// let distance = y.map(|y| y * y / (2.0 * 0.30));
    /// let contact = ProfileContact {
    ///     rolling_radius: 0.46, given: Given::Load(80e3), shear_modulus: 82e9, poisson_ratio: 0.28,
    ///     friction: 0.3, smoothing_length: 0.0,
    /// };
    /// let (patch, found) =
    ///     Patch::<f64, 32>::from_profile(&Profile::new(&y, &distance)?, &contact, StripCount::Sixteen)?;
    /// assert!((patch.view()?.normal_force() - 80e3).abs() < 1e-6);
    /// // Hertz: 90.5 µm; dN/dδ = 3 N/(2 δ)
    /// assert!((found.approach - 90.5e-6).abs() < 1e-6 && found.peak_y.abs() < 1e-12);
    /// assert!((found.stiffness * found.approach / 80e3 - 1.5).abs() < 0.05);
    /// # Ok::<(), kstrip::status::Error>(())
    /// ```
    pub fn from_profile(
        profile: &Profile<F>,
        contact: &ProfileContact<F>,
        count: StripCount,
    ) -> Result<(Self, Indentation<F>), Error> {
        let mut patch = Self::empty(contact.shear_modulus, contact.poisson_ratio);
        let found =
            Indentation::new(profile, contact, count, |strip| patch.strips.push(strip).is_ok())?;
        // Lengths and gaps at the ends of the number range have no digits left.
        let lost = (patch.view()?.normal_force() - found.normal_force).abs();
        if !(lost <= found.normal_force * F::constant(1e-3)) {
            return Err(Error::Overflow);
        }
        Ok((patch, found))
    }
}
