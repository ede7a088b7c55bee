//! Zones of contact in a gap, and the [contacts](WheelContact) that they are.
//!
//! **Zones** are where the undeformed surfaces overlap. One curve, the smoothed distance of the
//! surfaces, decides where zones are, how deep they are and what load they carry, so that a contact
//! begins without load. Zones less than 5 mm apart are one contact and one normal problem
//! (`groups`).

mod contact;
pub(crate) mod groups;
mod moves;
mod steps;
pub(crate) mod view;

pub use self::contact::WheelContact;

use self::groups::{Groups, Overlaps};
use self::view::View;
use crate::contact::totals::StripCount;
use crate::normal::cell::Cells;
use crate::normal::smooth::SmoothedProfile;
use crate::number::{Dual, Float};
use crate::patch::Patch;
use crate::status::{Error, Warning};
use crate::wheel_rail::touch::Gap;
use crate::wheel_rail::{KSTRIP_CONTACTS_CAPACITY, Position, WheelPair};

/// Groups the zones. (Out of line, to keep no zones.)
#[inline(never)]
fn group_zones<F: Float, const N: usize>(
    curve: &SmoothedProfile<F, N>, groups: &mut Groups<F>,
) -> bool {
    Overlaps::of_curve(curve, |own| own.value).group(groups)
}

/// The result of [`from_gap`].
#[derive(Clone, Copy, Debug)]
pub struct ContactCount {
    /// Contacts that were written.
    pub written: usize,
    /// The warning, if there is one.
    pub warning: Warning,
}

/// The contacts of a gap, in ascending y; none where the wheel is lifted. `strips` is memory for
/// the normal problem of each.
///
/// # Errors
/// [`Error::Profile`] for a gap that does not ascend, or an angle beyond 2.3; [`Error::Capacity`];
/// those of `WheelPair::check` and of [`Patch::from_profile`](crate::patch::Patch::from_profile).
pub fn from_gap<F: Float>(
    gap: &Gap<F>, pair: &WheelPair<F>, position: &Position<F>, count: StripCount,
    strips: &mut Patch<F>, contacts: &mut [WheelContact<F>; KSTRIP_CONTACTS_CAPACITY],
) -> Result<ContactCount, Error> {
    let view = View::new(gap, pair, position)?;
    let mut found = ContactCount { written: 0, warning: Warning::None };
    let Some(profile) = view.profile()? else { return Ok(found) };
    let mut cells = Cells::nothing();
    let mut curve = SmoothedProfile::<F, 1>::of_surfaces(&profile, pair.smoothing_length);
    let mut groups = Groups::new();
    if !group_zones(&curve, &mut groups) {
        found.warning = Warning::Rough;
    }
    for group in &groups {
        curve.restrict(&group.whole);
        let approach = Dual::input(group.whole.depth, 0);
        let mut pressed = view.press(&profile, &curve, approach, count, &mut cells)?;
        view.strips(&cells, |own| own.value, &mut pressed, strips)?;
        if strips.count == 0 {
            continue;
        }
        let contact = contacts.get_mut(found.written).ok_or(Error::PatchSize)?;
        let indented = [pressed.approach, pressed.stiffness];
        contact.fill(pair, &view.position, strips, indented, |_, along| view.place(along));
        contact.share = group.share.clamped(F::zero(), F::one());
        Error::Overflow.unless(contact.is_finite())?;
        found.written += 1;
        found.warning = found.warning.worse(pressed.warning);
        if contact.is_conformal() {
            found.warning = found.warning.worse(Warning::AngleRange);
        }
    }
    Ok(found)
}
