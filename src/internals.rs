//! Functions of the inside that `tests/units` call. They are no part of the interface. (As unit
//! tests of the library the tests would compile every formula twice.)

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::contact::totals::StripForces;
use crate::forces::{Model, Options};
use crate::number::{Arithmetic, Float, Real};
use crate::rig::creepage::Aim;
use crate::rig::friction::Rig;
use crate::rig::{FrictionEstimate, Measured};
use crate::status::Error;
use crate::strip::long::LongContact;
use crate::strip::{Spin, StripCreepage, totals};

pub use crate::number::avx::{has_avx, has_avx512};
pub use crate::strip::any::{eight_one_by_one, eight_strips};
pub use crate::strip::power::power_projected;

/// Whether the quick check accepts the sizes of a contact, and those of a creepage where the
/// contact is so small that nothing is implausible about them; and what the complete check finds.
pub fn quick_and_full_check<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, model: Model,
) -> (bool, Result<(), Error>) {
    let found = crate::forces::check::find_fault(contact, creepage, model);
    let least = F::of(1e-6);
    let small = Contact { a: least, b: least, normal_force: F::zero(), ..*contact };
    (contact.is_usual() && small.is_ordinary(creepage), found)
}

/// The estimate of friction, its quotient by the used friction, and the number of solutions.
///
/// # Errors
/// Those of [`estimate_friction`](crate::rig::estimate_friction).
pub fn estimate_counted<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, options: &Options, measured: Measured,
    force: [F; 2],
) -> Result<(F, FrictionEstimate<F>, usize), Error> {
    let mut rig = Rig::new(contact, creepage, None, options, measured, force)?;
    let estimate = rig.estimate(force)?;
    Ok((rig.used, estimate, rig.solved))
}

/// The creepage for a force, the distance of its force from the requested one divided by `μ N`, and
/// the number of solutions.
///
/// # Errors
/// Those of [`creepage_for_force`](crate::rig::creepage_for_force).
pub fn creepage_counted<F: Float>(
    contact: &Contact<F>, force: [F; 2], spin: F, options: &Options,
) -> Result<(Creepage<F>, F, usize), Error> {
    let mut aim = Aim::new(contact, force, spin, None, options);
    let found = aim.find()?;
    Ok((aim.creepage(found.at), found.distance, aim.solved))
}

/// The weight of the network for long contacts and what is left of the spin's linear force, by
/// `√(a/b)`.
pub fn long_contact<F: Real>(root: F) -> [F; 2] {
    let long = LongContact::new(root, F::zero(), F::zero());
    [long.share, long.of_spin(root)]
}

/// Forces of one strip, outer or inner, by the formulas as they stand.
pub fn strip_forces<T: Arithmetic<Value: Real>>(
    seen: &StripCreepage<T>, spin: T, inner: bool,
) -> StripForces<T> {
    totals::alone(seen, &Spin::new(spin), inner)
}
