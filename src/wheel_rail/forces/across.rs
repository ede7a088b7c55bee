//! Load, slip and frictional power of each strip of a contact, for the wear of profiles.
//!
//! ```text
//! P_i = w(V) P_i₊ + w(−V) P_i₋,   slip_i = P_i/(μ_i N_i)
//! ```
//!
//! The power is that of each strip in its own frame. Where a strip slides, its traction is `μ p`:
//! the integral of pressure times sliding velocity over a strip, which a law of Archard needs, is
//! the load times this slip.

use super::curved::{self, SlidStrip};
use super::ends::{Law, Pressed};
use crate::forces::Model;
use crate::motion::Rolling;
use crate::number::{Float, are_finite, at};
use crate::patch::{Patch, PatchStrip};
use crate::status::{Error, Warning};
use crate::wheel_rail::Velocity;
use crate::wheel_rail::contacts::WheelContact;

/// One strip of a contact of a wheel: its load, and the power that friction dissipates in it.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StripPower<F> {
    /// y on the wheel's profile \[m\], in the axes of the profile.
    pub wheel_y: F,
    /// Width along the surface \[m\].
    pub width: F,
    /// Load \[N\], with the share of the contact and the factor of the damping.
    pub normal_force: F,
    /// Longitudinal force on the rail \[N\], with the share of the contact.
    pub fx: F,
    /// Force on the rail along its surface across the rolling direction \[N\], with the share of
    /// the contact; of a left wheel that of the mirrored right wheel.
    pub fy: F,
    /// Mean sliding velocity \[m/s\]: power divided by the coefficient of friction and the load,
    /// and below zero together with it.
    pub slip: F,
    /// Frictional power \[W\], with the share of the contact. That of a strip that hardly slides
    /// may be a little below zero: -0.06 % of the power of the wheel if it rolls, -0.4 % if it
    /// stands.
    pub power: F,
}

impl<F: Float> StripPower<F> {
    fn fits(&self) -> bool {
        let Self { wheel_y, width, normal_force, fx, fy, slip, power } = *self;
        are_finite(&[wheel_y, width, normal_force, fx, fy, slip, power])
    }
}

/// Passes every strip of a contact to `visit`. [`Model::Total`], which has no strips, is replaced
/// by [`Model::Strip`].
///
/// # Errors
/// Those of [`of_contacts`](super::wrench::of_contacts).
pub fn power_across<F: Float>(
    contact: &WheelContact<F>, velocity: &Velocity<F>, law: Law<F>,
    visit: &mut dyn FnMut(StripPower<F>),
) -> Result<Warning, Error> {
    let model = if law.model == Model::Total { Model::Strip } else { law.model };
    let velocity = velocity.members();
    Error::NotFinite.unless(are_finite(&velocity))?;
    contact.check()?;
    let rolling = Rolling::new(&contact.motion(&velocity))?;
    let factor = contact.damping_factor(&velocity)?;
    let mut room = Patch::nothing();
    let pressed = Pressed { patch: &contact.patch, factor, room: &mut room };
    let law = Law { model, ..law };
    let (slid, warning) = curved::across(contact, pressed, &velocity, &rolling, law)?;
    let (turn, share, [x, ..]) = (contact.axes().turn, contact.share, contact.origin);
    let strips = contact.patch.strips.iter().zip(&slid).take(contact.patch.count as usize);
    let found = |(k, (strip, own)): (usize, (&PatchStrip<F>, &SlidStrip<F>))| {
        let place = [x + strip.centre_x, at(&contact.strip_y, k), at(&contact.strip_z, k)];
        let [_, wheel_y, _] = turn.to_wheelset(place);
        let [fx, fy] = own.force.map(|force| force * share);
        let normal_force = strip.load() * factor * share;
        let (width, slip, power) = (strip.width, own.slip, own.power * share);
        StripPower { wheel_y, width, normal_force, fx, fy, slip, power }
    };
    let strips = strips.enumerate().map(found);
    Error::Overflow.unless(strips.clone().all(|strip| strip.fits()))?;
    strips.for_each(visit);
    Ok(if contact.is_conformal() { warning.worse(Warning::AngleRange) } else { warning })
}
