//! What presses two profiles together, and their material.

use crate::contact::material::{check_modulus, check_poisson_ratio};
use crate::normal::cells::Given;
use crate::normal::smooth::length_for;
use crate::number::{Arithmetic, Dual, Float};
use crate::status::Error;

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
        let given = self.given.number();
        let radius = if has_radii { F::one() } else { self.rolling_radius };
        let inputs = [radius, given, self.friction, self.smoothing_length];
        Error::NotFinite.unless(inputs.iter().all(|input| input.is_finite_number()))?;
        Error::RollingRadius.when(radius <= F::zero())?;
        Error::NormalForce.when(matches!(self.given, Given::Load(load) if load < F::zero()))?;
        check_modulus(self.shear_modulus)?;
        check_poisson_ratio(self.poisson_ratio)?;
        Error::Friction.when(self.friction < F::zero())?;
        Error::SmoothingLength.when(self.smoothing_length < F::zero())
    }

    pub(super) fn smoothing<const N: usize>(&self, half_width: Dual<F, N>) -> Dual<F, N> {
        if self.smoothing_length > F::zero() {
            Dual::from_base(self.smoothing_length)
        } else {
            length_for(half_width)
        }
    }

    /// `E* = G/(1 − ν)`
    pub(super) fn modulus(&self) -> F {
        self.shear_modulus / (F::one() - self.poisson_ratio)
    }
}
