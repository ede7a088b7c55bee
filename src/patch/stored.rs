//! A patch as a C structure: room for a fixed number of strips, and the number of those that are
//! used.

use super::{PatchStrip, PatchView, QuadratureScale, check_ellipse, ellipse};
use crate::contact::Contact;
use crate::contact::totals::StripCount;
use crate::number::{Float, sort};
use crate::status::Error;

/// Maximum number of strips in a kstrip_patch.
pub const KSTRIP_PATCH_CAPACITY: usize = 64;

/// A contact patch of any shape: its strips, in ascending y. Filled by kstrip_patch_from_contact(),
/// kstrip_patch_from_strips() or kstrip_patch_from_profile(); the members may then be changed. All
/// functions check it again. A patch whose members are all zero, except shear_modulus, carries no
/// load.
///
/// If the distance of two neighbours is more than one and a half times the distance at which they
/// touch, there is a gap, and the strips on either side are separate contact regions (lobes).
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patch<F> {
    /// The strips; the first count are used. KSTRIP_ERROR_STRIP_ORDER if their y do not ascend, or
    /// if they overlap by more than half of the distance at which they touch.
    pub strips: [PatchStrip<F>; KSTRIP_PATCH_CAPACITY],
    /// Combined shear modulus G \[Pa\], > 0, else KSTRIP_ERROR_MODULUS.
    pub shear_modulus: F,
    /// Combined Poisson's ratio \[-\], 0 to 0.5, else KSTRIP_ERROR_POISSON_RATIO.
    pub poisson_ratio: F,
    /// Factor \[-\], > 0, else KSTRIP_ERROR_NOT_FINITE, that makes the sum of the strips' areas the
    /// patch's area: 1 unless the strips are the quadrature rule of kstrip_patch_from_contact(); 0
    /// stands for 1. KSTRIP_ERROR_OVERFLOW if it is outside 1e-6 to 1e6.
    pub area_scale: F,
    /// The same for the moment of the area about x, the sum of y^2 times area.
    pub lever_scale: F,
    /// Number of strips, 0 to KSTRIP_PATCH_CAPACITY, else KSTRIP_ERROR_PATCH_SIZE. None: no load.
    pub count: u32,
    /// Reserved: zero.
    pub reserved: u32,
    /// Mismatch kappa \[-\] of the two materials, as in kstrip_contact: KSTRIP_WARNING_MISMATCH if
    /// its size is above 0.25. Only kstrip_patch_from_contact() sets it; the caller may set it.
    pub mismatch: F,
}

impl<F: Float> Patch<F> {
    /// A patch without strips and material.
    pub(crate) const fn nothing() -> Self {
        let zero = F::ZERO;
        Self {
            strips: [PatchStrip::EMPTY; KSTRIP_PATCH_CAPACITY],
            shear_modulus: zero,
            poisson_ratio: zero,
            area_scale: zero,
            lever_scale: zero,
            count: 0,
            reserved: 0,
            mismatch: zero,
        }
    }

    /// A patch without strips, of this combined shear modulus \[Pa\] and Poisson's ratio.
    pub(crate) fn empty(shear_modulus: F, poisson_ratio: F) -> Self {
        let mut patch = Self::nothing();
        patch.clear(shear_modulus, poisson_ratio);
        patch
    }

    /// The patch of a Hertz ellipse, with strips at the places of
    /// [`Model::Strip`](crate::forces::Model::Strip). A lost contact has no strips.
    ///
    /// # Errors
    /// Those of [`Contact::check`]; [`Error::Overflow`] when its strips do not fit the
    /// floating-point type.
    pub fn from_ellipse(contact: &Contact<F>, count: StripCount) -> Result<Self, Error> {
        let mut patch = Self::empty(contact.shear_modulus, contact.poisson_ratio);
        if contact.is_lost() {
            contact.check()?;
            patch.view()?;
            return Ok(patch);
        }
        check_ellipse(contact, count)?;
        patch.mismatch = contact.mismatch;
        let scale = ellipse(contact, count, |strip| patch.push(strip))?;
        (patch.area_scale, patch.lever_scale) = (scale.area, scale.lever);
        Ok(patch)
    }

    /// A patch of strips in any order.
    ///
    /// # Errors
    /// [`Error::PatchSize`] when there are more than [`KSTRIP_PATCH_CAPACITY`], else those of
    /// [`PatchView::new`].
    pub fn from_strips(
        strips: &[PatchStrip<F>], shear_modulus: F, poisson_ratio: F,
    ) -> Result<Self, Error> {
        let mut patch = Self::empty(shear_modulus, poisson_ratio);
        Error::PatchSize.unless(strips.iter().all(|strip| patch.push(*strip)))?;
        sort(patch.used_mut(), |strip, next| strip.y < next.y);
        patch.view()?;
        Ok(patch)
    }

    /// The strips that are used.
    #[must_use]
    pub fn used(&self) -> &[PatchStrip<F>] {
        self.strips.get(..self.count as usize).unwrap_or(&[])
    }

    /// The strips that are used, to be changed.
    pub fn used_mut(&mut self) -> &mut [PatchStrip<F>] {
        self.strips.get_mut(..self.count as usize).unwrap_or(&mut [])
    }

    /// Removes all strips.
    pub(crate) fn clear(&mut self, shear_modulus: F, poisson_ratio: F) {
        (self.shear_modulus, self.poisson_ratio) = (shear_modulus, poisson_ratio);
        (self.area_scale, self.lever_scale) = (F::one(), F::one());
        (self.count, self.reserved, self.mismatch) = (0, 0, F::zero());
    }

    /// Adds a strip; returns whether there was room.
    pub(crate) fn push(&mut self, strip: PatchStrip<F>) -> bool {
        let place = self.strips.get_mut(self.count as usize);
        let room = place.is_some();
        if let Some(place) = place {
            *place = strip;
            self.count = self.count.saturating_add(1);
        }
        room
    }

    /// The checked patch.
    ///
    /// # Errors
    /// [`Error::PatchSize`]; those of [`PatchView::new`].
    pub fn view(&self) -> Result<PatchView<'_, F>, Error> {
        let strips = self.strips.get(..self.count as usize).ok_or(Error::PatchSize)?;
        let or_one = |factor: F| if factor == F::zero() { F::one() } else { factor };
        let scale =
            QuadratureScale { area: or_one(self.area_scale), lever: or_one(self.lever_scale) };
        PatchView::new(strips, self.shear_modulus, self.poisson_ratio, scale)?
            .with_mismatch(self.mismatch)
    }
}
