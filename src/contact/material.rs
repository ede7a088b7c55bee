//! Elastic constants of two bodies in contact (Section 2, Section 4.1).

use crate::number::Float;
use crate::status::Error;

/// An isotropic elastic body.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material<F> {
    /// Shear modulus G \[Pa\], > 0, else KSTRIP_ERROR_MODULUS. Steel: 82e9.
    pub shear_modulus: F,
    /// Poisson's ratio \[-\], 0 to 0.5, else KSTRIP_ERROR_POISSON_RATIO. Steel: 0.28.
    pub poisson_ratio: F,
}

/// The combined elastic constants of two bodies.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CombinedMaterial<F> {
    /// Combined shear modulus G \[Pa\], 1/G = (1/G_lower + 1/G_upper)/2 (2.6).
    pub shear_modulus: F,
    /// Combined Poisson's ratio nu \[-\], nu/G = (nu_lower/G_lower + nu_upper/G_upper)/2 (2.6).
    pub poisson_ratio: F,
    /// Mismatch kappa \[-\] (4.3) of the two materials, for kstrip_contact: 0 for like materials;
    /// -0.07 for steel (lower) on aluminium, -0.15 on a polymer.
    pub mismatch: F,
}

impl<F: Float> Material<F> {
    /// From Young's modulus `E` \[Pa\] and Poisson's ratio: `G = E / (2 (1 + ν))`.
    #[must_use]
    pub fn from_youngs_modulus(youngs_modulus: F, poisson_ratio: F) -> Self {
        Self {
            shear_modulus: youngs_modulus / (F::one() + poisson_ratio).times(2.0),
            poisson_ratio,
        }
    }

    fn check(&self) -> Result<(), Error> {
        check_modulus(self.shear_modulus)?;
        check_poisson_ratio(self.poisson_ratio)
    }
}

/// Combine a lower (`+`) and an upper (`−`) body.
///
/// # Errors
/// [`Error::NotFinite`], [`Error::Modulus`], [`Error::PoissonRatio`].
///
/// # Example
/// ```
/// use kstrip::contact::material::{combine, Material};
/// let steel = Material { shear_modulus: 82e9, poisson_ratio: 0.28 };
/// let pair = combine(&steel, &steel)?;
/// assert_eq!((pair.poisson_ratio, pair.mismatch), (0.28, 0.0));
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn combine<F: Float>(
    lower: &Material<F>, upper: &Material<F>,
) -> Result<CombinedMaterial<F>, Error> {
    lower.check()?;
    upper.check()?;
    let (g_lower, nu_lower) = (lower.shear_modulus, lower.poisson_ratio);
    let (g_upper, nu_upper) = (upper.shear_modulus, upper.poisson_ratio);
    // Shares of the compliance, which sum to one whatever the size of the moduli.
    let softer = g_lower.min(g_upper);
    let (lower_compliance, upper_compliance) = (softer / g_lower, softer / g_upper);
    let total = lower_compliance + upper_compliance;
    let (lower_share, upper_share) = (lower_compliance / total, upper_compliance / total);
    // 1/G = (1/G⁺ + 1/G⁻)/2   (2.6)
    let shear_modulus = softer * (F::constant(2.0) / total);
    // ν/G = (ν⁺/G⁺ + ν⁻/G⁻)/2   (2.6)
    let poisson_ratio = if nu_lower == nu_upper {
        nu_lower
    } else {
        nu_lower * lower_share + nu_upper * upper_share
    };
    // κ/G = ((1 − 2ν⁺)/G⁺ − (1 − 2ν⁻)/G⁻)/4   (4.3)
    let mismatch = ((F::one() - nu_lower.times(2.0)) * lower_share
        - (F::one() - nu_upper.times(2.0)) * upper_share)
        .times(0.5);
    Error::Overflow.unless(shear_modulus.is_finite_number())?;
    Ok(CombinedMaterial { shear_modulus, poisson_ratio, mismatch })
}

pub(crate) fn check_modulus<F: Float>(modulus: F) -> Result<(), Error> {
    Error::NotFinite.unless(modulus.is_finite_number())?;
    Error::Modulus.unless(modulus > F::zero())
}

pub(crate) fn check_poisson_ratio<F: Float>(poisson_ratio: F) -> Result<(), Error> {
    Error::NotFinite.unless(poisson_ratio.is_finite_number())?;
    Error::PoissonRatio.unless(poisson_ratio >= F::zero() && poisson_ratio <= F::constant(0.5))
}
