//! Motion: creepages from velocities, Kalker's parameters.

use super::F;
use crate::contact::Contact;
use crate::contact::creepage::{Creepage, Parameters, SurfaceVelocity};
use crate::ffi::support::{given, write_result};
use crate::ffi::types::KalkerParameters;
use crate::number::are_finite;
use crate::status::{Error, kstrip_status};
use core::mem::MaybeUninit;

/// Creepages from the velocities of both bodies: (upper - lower)/rolling_speed.
///
/// For forward rolling at some speed; kstrip_solve_motion() takes velocities through standstill and
/// reversal.
///
/// @param lower, upper    surface velocities at the centre of the contact, in one frame.
/// @param rolling_speed   V [m/s], > 0; x points in the rolling direction.
/// @param[out] creepage   receives the creepages.
/// @return usual statuses; KSTRIP_ERROR_ROLLING_SPEED (rolling_speed <= 0).
#[unsafe(export_name = symbol!("kstrip_creepage_from_velocities"))]
pub extern "C" fn kstrip_creepage_from_velocities(
    lower: Option<&SurfaceVelocity<F>>, upper: Option<&SurfaceVelocity<F>>, rolling_speed: F,
    creepage: Option<&mut MaybeUninit<Creepage<F>>>,
) -> kstrip_status {
    write_result(creepage, || {
        Creepage::from_velocities(given(lower)?, given(upper)?, rolling_speed)
    })
}

/// Kalker's dimensionless parameters xi, eta, psi (5.13) of a contact in motion; zero where it is
/// lost.
///
/// @param contact         ellipse, load, material, friction.
/// @param creepage        its motion.
/// @param[out] parameters  receives xi, eta and psi [-].
/// @return usual statuses; errors of kstrip_contact.
#[unsafe(export_name = symbol!("kstrip_parameters_from_creepage"))]
pub extern "C" fn kstrip_parameters_from_creepage(
    contact: Option<&Contact<F>>, creepage: Option<&Creepage<F>>,
    parameters: Option<&mut MaybeUninit<KalkerParameters<F>>>,
) -> kstrip_status {
    write_result(parameters, || {
        let (contact, creepage) = (given(contact)?, given(creepage)?);
        contact.check()?;
        creepage.check()?;
        if contact.is_lost() {
            return Ok(KalkerParameters::default());
        }
        let Parameters { xi, eta, psi, .. } = Parameters::new(contact, creepage);
        Error::Overflow.unless(are_finite(&[xi, eta, psi]))?;
        Ok(KalkerParameters { xi, eta, psi })
    })
}

/// The creepage that has the given parameters xi, eta, psi on a contact: the inverse of
/// kstrip_parameters_from_creepage(); zero where it is lost.
///
/// @param contact         ellipse, load, material, friction.
/// @param parameters      xi, eta and psi [-].
/// @param[out] creepage   receives the creepage.
/// @return usual statuses; errors of kstrip_contact.
#[unsafe(export_name = symbol!("kstrip_creepage_from_parameters"))]
pub extern "C" fn kstrip_creepage_from_parameters(
    contact: Option<&Contact<F>>, parameters: Option<&KalkerParameters<F>>,
    creepage: Option<&mut MaybeUninit<Creepage<F>>>,
) -> kstrip_status {
    write_result(creepage, || {
        let contact = given(contact)?;
        contact.check()?;
        let KalkerParameters { xi, eta, psi } = *given(parameters)?;
        Error::NotFinite.unless(are_finite(&[xi, eta, psi]))?;
        if contact.is_lost() {
            return Ok(Creepage::default());
        }
        let (poisson_ratio, axis_ratio) = (contact.poisson_ratio, contact.a / contact.b);
        let found = Parameters { xi, eta, psi, poisson_ratio, axis_ratio }.creepage(contact);
        found.check().map_err(|_| Error::Overflow)?;
        Ok(found)
    })
}
