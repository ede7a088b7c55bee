//! A contact patch of any shape as a list of strips. Pressure and friction may differ from strip to
//! strip.
//!
//! A strip runs along the rolling direction. It has a centre line `y`, a width, a half length `l`,
//! a centre `x_c`, a friction coefficient, and a pressure that is a half-ellipse in `x`,
//! `Z = p₀ √(1 − (x − x_c)²/l²)`, so that it carries the load `(π/2) p₀ l · width`. Where the
//! strips come from does not matter: from a Hertz ellipse ([`Patch::from_ellipse`]), from a profile
//! ([`normal`](crate::normal)), or from any other solver ([`Patch::from_strips`]).
//!
//! Strips lie side by side in ascending `y`. Where the distance of two neighbours is more than one
//! and a half times that at which they touch, there is a gap, and the strips on either side of it
//! are a lobe of their own.
//!
//! The model STRIP needs an axis ratio. It uses that of an equivalent ellipse of the strips around
//! ([`zones`]).

pub(crate) mod each_strip;
pub mod field;
pub mod friction;
mod shares;
mod sizes;
mod slip;
pub mod solver;
mod stored;
mod sums;
mod view;
pub mod zones;

pub use self::stored::{KSTRIP_PATCH_CAPACITY, Patch};
pub use self::view::PatchView;

use crate::contact::Contact;
use crate::contact::totals::StripCount;
use crate::number::Float;
use crate::status::Error;
use crate::strip::Rule;
use core::f64::consts::{FRAC_PI_2, PI};

/// One strip of a patch, along the rolling direction. Its pressure is a half-ellipse in x,
/// peak_pressure sqrt(1 - (x - centre_x)^2/half_length^2), and does not vary over its width.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PatchStrip<F> {
    /// Centre line y \[m\].
    pub y: F,
    /// Width \[m\], > 0, else KSTRIP_ERROR_STRIP_SIZE.
    pub width: F,
    /// Half length along x \[m\], > 0, else KSTRIP_ERROR_STRIP_SIZE.
    pub half_length: F,
    /// Centre along x \[m\]; 0 for most contacts.
    pub centre_x: F,
    /// Pressure at the centre \[Pa\], >= 0, else KSTRIP_ERROR_PRESSURE.
    pub peak_pressure: F,
    /// Coefficient of friction \[-\] of this strip, >= 0, else KSTRIP_ERROR_FRICTION.
    pub friction: F,
}

impl<F: Float> PatchStrip<F> {
    const EMPTY: Self = Self {
        y: F::ZERO,
        width: F::ZERO,
        half_length: F::ZERO,
        centre_x: F::ZERO,
        peak_pressure: F::ZERO,
        friction: F::ZERO,
    };

    /// Load `(π/2) p₀ l · width` \[N\].
    #[must_use]
    pub fn load(&self) -> F {
        (self.peak_pressure * self.half_length).times(FRAC_PI_2) * self.width
    }

    /// Coefficient of friction times the load \[N\].
    #[must_use]
    pub fn friction_bound(&self) -> F {
        self.friction * self.load()
    }

    /// `y`, width, half length, `x_c`, pressure and friction.
    pub(crate) fn numbers(&self) -> [F; 6] {
        let Self { y, width, half_length, centre_x, peak_pressure, friction } = *self;
        [y, width, half_length, centre_x, peak_pressure, friction]
    }

    /// The circle with the strip's length, peak pressure and friction: its parameters `ξ, η, ψ` are
    /// the strip's.
    #[must_use]
    pub fn circle(&self, shear_modulus: F, poisson_ratio: F) -> Contact<F> {
        let Self { half_length, peak_pressure, friction, .. } = *self;
        Contact {
            a: half_length,
            b: half_length,
            // p₀ = 3N/(2π a b)
            normal_force: (peak_pressure * half_length).times(2.0 * PI / 3.0) * half_length,
            shear_modulus,
            poisson_ratio,
            friction,
            mismatch: F::zero(),
        }
    }

    /// Checks the members.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::StripSize`], [`Error::Pressure`], [`Error::Friction`].
    pub fn check(&self) -> Result<(), Error> {
        let Self { width, half_length, peak_pressure, friction, .. } = *self;
        Error::NotFinite.unless(self.numbers().iter().all(|input| input.is_finite_number()))?;
        Error::StripSize.when(width <= F::zero() || half_length <= F::zero())?;
        Error::Pressure.when(peak_pressure < F::zero())?;
        Error::Friction.when(friction < F::zero())
    }

    /// Distance of the centre lines at which the strips touch.
    fn touching(&self, next: &Self) -> F {
        self.width.times(0.5) + next.width.times(0.5)
    }

    /// Whether there is a gap before the next strip.
    pub(crate) fn is_apart(&self, next: &Self) -> bool {
        next.y - self.y > self.touching(next).times(1.5)
    }

    /// Whether the next strip lies beside this one; widths of a Gauss rule overlap by a quarter.
    fn is_beside(&self, next: &Self) -> bool {
        next.y > self.y && next.y - self.y >= self.touching(next).times(0.5)
    }
}

/// Factors that turn a sum over the strips into the integral over the patch.
///
/// They are 1 if the strips are the patch itself. The strips of an ellipse are a rule of Gauss,
/// whose sums differ slightly from the integrals; these two factors make the slopes of the linear
/// theory exact. Strips with another factor than 1 are a rule of Gauss.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuadratureScale<F> {
    /// For the area `∫ 2 l dy`.
    pub area: F,
    /// For its moment `∫ 2 l y² dy`.
    pub lever: F,
}

impl<F: Float> Default for QuadratureScale<F> {
    fn default() -> Self {
        Self { area: F::one(), lever: F::one() }
    }
}

/// Checks that the strips of an ellipse make a patch that [`PatchView::new`] accepts.
fn check_ellipse<F: Float>(contact: &Contact<F>, count: StripCount) -> Result<(), Error> {
    contact.check()?;
    let Contact { shear_modulus, poisson_ratio, .. } = *contact;
    let [mut width, mut load, mut bound, mut area] = [F::zero(); 4];
    let mut last: Option<PatchStrip<F>> = None;
    let scale = ellipse(contact, count, |strip| {
        width += strip.width;
        load += strip.load();
        bound += strip.friction_bound();
        area += strip.half_length.times(2.0) * strip.width;
        let fits = strip.check().is_ok()
            && strip.circle(shear_modulus, poisson_ratio).check().is_ok()
            && last.is_none_or(|last| last.is_beside(&strip) && !last.is_apart(&strip));
        last = Some(strip);
        fits
    });
    // Strips of size zero and infinite sums occur only at the ends of the number range.
    let scale = scale.map_err(|_| Error::Overflow)?;
    let friction = if load > F::zero() { bound / load } else { contact.friction };
    // The equivalent ellipse of the strips differs slightly from the contact: both must fit.
    for b in [width.times(0.45), width.times(0.55)] {
        let lobe = Contact { b, normal_force: load, friction, ..*contact };
        lobe.check().map_err(|_| Error::Overflow)?;
    }
    Error::Overflow.unless((area * scale.area).is_finite_number())
}

/// Passes the strips of a checked ellipse to `take`, which returns whether there was room.
fn ellipse<F: Float>(
    contact: &Contact<F>, count: StripCount, mut take: impl FnMut(PatchStrip<F>) -> bool,
) -> Result<QuadratureScale<F>, Error> {
    let rule = Rule::<F>::new(count);
    for [y, half_length, width] in rule.places() {
        let strip = PatchStrip {
            y: contact.b * y,
            width: contact.b * width,
            half_length: contact.a * half_length,
            centre_x: F::zero(),
            peak_pressure: contact.peak_pressure() * half_length,
            friction: contact.friction,
        };
        Error::PatchSize.unless(take(strip))?;
    }
    Ok(QuadratureScale { area: rule.stretch, lever: rule.lever })
}
