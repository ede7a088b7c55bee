//! A loaded contact ellipse with friction: the input of every model.

pub mod creepage;
pub(crate) mod elliptic;
pub mod hertz;
pub mod material;
pub(crate) mod mismatch;
pub(crate) mod plausibility;
pub mod totals;

pub use self::hertz::{from_approach, from_hertz};
pub use self::plausibility::implausibility;

use crate::contact::material::{check_modulus, check_poisson_ratio};
use crate::number::{Float, Real, are_finite};
use crate::status::Error;

/// A loaded elliptic contact with combined elastic constants and Coulomb friction.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact<F> {
    /// Semi-axis a along the rolling direction x \[m\], > 0, else KSTRIP_ERROR_SEMI_AXIS.
    pub a: F,
    /// Semi-axis b along y \[m\], likewise; KSTRIP_WARNING_SEMI_AXIS if one is above 1 m.
    pub b: F,
    /// Normal force N \[N\]. If it is <= 0 the contact is lost, and the other members only need to
    /// be finite. KSTRIP_WARNING_PRESSURE if the peak pressure is above a tenth of shear_modulus.
    pub normal_force: F,
    /// Combined shear modulus G \[Pa\] (2.6), > 0, else KSTRIP_ERROR_MODULUS; above 150 GPa
    /// KSTRIP_WARNING_YOUNG, above 10 TPa KSTRIP_WARNING_MODULUS.
    pub shear_modulus: F,
    /// Combined Poisson's ratio nu \[-\], 0 to 0.5, else KSTRIP_ERROR_POISSON_RATIO.
    pub poisson_ratio: F,
    /// Friction mu \[-\], >= 0, else KSTRIP_ERROR_FRICTION; above 5 KSTRIP_WARNING_FRICTION.
    pub friction: F,
    /// Mismatch kappa \[-\] of the two materials (4.3), from kstrip_material_combine(). It is 0
    /// for similar materials and positive if the lower body is softer. Its sign changes if the
    /// bodies are exchanged. In dissimilar bodies pressure makes a longitudinal creepage, so that
    /// there is a force without creepage. KSTRIP_WARNING_MISMATCH if its size is above 0.25.
    pub mismatch: F,
}

impl<F: Float> Contact<F> {
    /// # Errors
    /// [`Error::NotFinite`], [`Error::SemiAxis`], [`Error::Modulus`], [`Error::PoissonRatio`],
    /// [`Error::Friction`]; [`Error::Overflow`] when `a/b` or `b/a` exceeds
    /// [`Number::HUGE`](crate::number::Number::HUGE), or `μ N` or the pressure does not fit the
    /// floating-point type.
    #[inline(never)]
    pub fn check(&self) -> Result<(), Error> {
        let Self { a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch } = *self;
        let inputs = [a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch];
        Error::NotFinite.unless(are_finite(&inputs))?;
        if self.is_lost() {
            return Ok(());
        }
        Error::SemiAxis.unless(a > F::zero() && b > F::zero())?;
        check_modulus(shear_modulus)?;
        check_poisson_ratio(poisson_ratio)?;
        Error::Friction.unless(friction >= F::zero())?;
        let (bound, pressure) = (self.friction_bound(), self.peak_pressure());
        let results = [bound, pressure, friction * pressure, self.strain()];
        // So that products of the axis ratio with numbers of order one stay finite.
        let slender = (a / b).max(b / a) > F::HUGE;
        Error::Overflow.unless(!slender && are_finite(&results))
    }
}

impl<F: Real> Contact<F> {
    /// Whether there is no contact: `N ≤ 0`. The other members then only need to be finite.
    #[must_use]
    #[inline]
    pub fn is_lost(&self) -> bool {
        !self.normal_force.exceeds(F::zero())
    }

    /// `μ N` \[N\]: no tangential force exceeds it.
    #[must_use]
    #[inline]
    pub fn friction_bound(&self) -> F {
        self.friction * self.normal_force
    }

    /// Pressure at the centre `p₀ = 3N/(2π a b)` \[Pa\].
    #[must_use]
    #[inline]
    pub fn peak_pressure(&self) -> F {
        self.normal_force.times(1.5 / core::f64::consts::PI) / self.a / self.b
    }

    /// `G/(2 μ p₀)`, the factor of (5.13); at most [`Number::HUGE`](crate::number::Number::HUGE),
    /// this largest number without friction or load.
    #[inline]
    pub(crate) fn stiffness_ratio(&self) -> F {
        // G/(2 μ p₀) = (π/3) G a b/(μ N)
        let stiffness = (self.shear_modulus * self.a) * self.b.times(core::f64::consts::PI / 3.0);
        (stiffness / (self.friction_bound() + F::TINY)).min(F::HUGE)
    }

    /// The inverse of [`Contact::stiffness_ratio`]: without friction the slip is then the rigid
    /// slip.
    pub(crate) fn slip_scale(&self) -> F {
        (F::one() / (self.stiffness_ratio() + F::TINY)).min(F::HUGE)
    }

    /// `2 μ p₀/G` \[–\]: the unit of slip.
    #[must_use]
    pub fn slip_unit(&self) -> F {
        (self.friction * (self.peak_pressure() / self.shear_modulus)).times(2.0)
    }
}
