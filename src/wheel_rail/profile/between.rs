//! The profile at a place between two slices of a surface that varies along the track or around a
//! wheel.
//!
//! Points at the same share `u` of the length of both profiles belong together, and their
//! coordinates are interpolated: `r(u) = (1 − s) r_a(u) + s r_b(u)`.

use super::PreparedProfile;
use crate::number::Float;
use crate::status::{Error, Warning};
use crate::wheel_rail::KSTRIP_SURFACE_CAPACITY;

/// The points of a profile between two others, before it is prepared.
pub(crate) struct LineBetween<F> {
    y: [F; KSTRIP_SURFACE_CAPACITY],
    z: [F; KSTRIP_SURFACE_CAPACITY],
    spacing: F,
    form: u32,
}

impl<F: Float> PreparedProfile<F> {
    /// The line at a share between two profiles, 0 at the first to 1 at the second.
    ///
    /// # Errors
    /// [`Error::NotPrepared`]; [`Error::NotFinite`] and [`Error::SliceShare`] of the share.
    pub(crate) fn line_between(a: &Self, b: &Self, share: F) -> Result<LineBetween<F>, Error> {
        a.check()?;
        b.check()?;
        Error::NotFinite.unless(share.is_finite_number())?;
        Error::SliceShare.unless(share >= F::zero() && share <= F::one())?;
        let rest = F::one() - share;
        let [mut y, mut z] = [[F::zero(); KSTRIP_SURFACE_CAPACITY]; 2];
        let last = F::widened((KSTRIP_SURFACE_CAPACITY - 1) as f32);
        for (k, (y, z)) in y.iter_mut().zip(&mut z).enumerate() {
            let part = F::widened(k as f32) / last;
            let [first, second] = [a, b].map(|profile| {
                profile.along(part * profile.step * F::widened((profile.count - 1) as f32))
            });
            *y = rest * first[0].value + share * second[0].value;
            *z = rest * first[1].value + share * second[1].value;
        }
        let spacing = rest * a.spacing + share * b.spacing;
        Ok(LineBetween { y, z, spacing, form: a.form | b.form })
    }
}

impl<F: Float> LineBetween<F> {
    /// Prepares the line.
    ///
    /// # Errors
    /// Those of [`PreparedProfile::prepare`].
    pub(crate) fn prepare(&self, profile: &mut PreparedProfile<F>) -> Result<Warning, Error> {
        let warning = profile.prepare(&self.y, &self.z, F::zero(), F::zero())?;
        profile.spacing = self.spacing;
        profile.form |= self.form & super::plausibility::ROUGH_AND_COARSE;
        Ok(warning)
    }
}
