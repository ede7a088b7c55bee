//! Load, slip and frictional power of each strip of a contact, for the wear of profiles.
//!
//! ```text
//! P_i = w(V) P_i₊ + w(−V) P_i₋,   slip_i = P_i/(μ_i N_i)
//! ```
//!
//! The power is that of each strip in its own frame. Where a strip slides, its traction is `μ p`:
//! the integral of pressure times sliding velocity over a strip, which a law of Archard needs, is
//! the load times this slip.

use super::curved::{End, Frames, OwnFrames};
use super::ends::{Law, Pressed, at_speed};
use crate::forces::Model;
use crate::motion::Rolling;
use crate::number::{Float, are_finite, at, set_at};
use crate::patch::each_strip::each_strip;
use crate::patch::{KSTRIP_PATCH_CAPACITY, Patch, PatchStrip};
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
    let (slid, warning) = slid_strips(contact, pressed, &velocity, &rolling, law)?;
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

/// Strips by their number.
type Slid<F> = [SlidStrip<F>; KSTRIP_PATCH_CAPACITY];

/// Force and power of a strip in its own frame.
#[derive(Clone, Copy, Default)]
struct SlidStrip<F> {
    /// Along x and across \[N\], on the rail.
    force: [F; 2],
    /// \[W\]
    power: F,
    /// Power divided by the friction bound \[m/s\].
    slip: F,
}

/// Forces and power of each strip, and the warning of the model.
fn slid_strips<F: Float>(
    contact: &WheelContact<F>, mut pressed: Pressed<F>, velocity: &[F; 6], rolling: &Rolling<F>,
    law: Law<F>,
) -> Result<(Slid<F>, Warning), Error> {
    let Law { model, .. } = law;
    let (falling, speed) = (at_speed(law, rolling.speed), rolling.speed);
    let end = End::<_, false> { velocity, speed, falling: falling.as_ref(), model };
    let frames = Frames { contact, axes: contact.axes() };
    let (count, factor) = (contact.patch.count as usize, pressed.factor);
    let ends =
        pressed.each_end(rolling, rolling.speed_by_rolling, |view, creepage, is_turned| {
            let mut own = OwnFrames::new();
            frames.add_frames(is_turned, &mut own);
            let own = end.own_creepages(view, creepage, &own);
            let view = view.with_own_creepages(&own)?;
            let mut slid = [SlidStrip::default(); KSTRIP_PATCH_CAPACITY];
            let sign = if is_turned { -F::one() } else { F::one() };
            let law = end.falling;
            let found = each_strip::<_, false>(
                &view,
                creepage,
                law,
                (model, None),
                &mut |k, (forces, power)| {
                    let number = if is_turned { count.saturating_sub(k + 1) } else { k };
                    let ([x, y, _], power) = (forces.map(|force| force.value), power.value * speed);
                    let strip = SlidStrip { force: [x * sign, y * sign], power, slip: F::zero() };
                    set_at(&mut slid, number, strip);
                },
            )?;
            for (strip, of) in slid.iter_mut().zip(&contact.patch.strips) {
                // λ μ₀ N
                let bound = found.share * factor * of.friction_bound();
                strip.slip = if bound > F::zero() { strip.power / bound } else { F::zero() };
            }
            Ok((slid, found.warning))
        })?;
    let [(mut slid, ahead), (behind_slid, behind)] = ends;
    for (strip, behind) in slid.iter_mut().zip(&behind_slid) {
        let mean = |p: F, q: F| rolling.mean(p, q);
        let ([x, y], [u, v]) = (strip.force, behind.force);
        strip.force = [mean(x, u), mean(y, v)];
        strip.power = mean(strip.power, behind.power);
        strip.slip = mean(strip.slip, behind.slip);
    }
    Ok((slid, ahead.worse(behind)))
}
