//! Creep forces of a contact on curved surfaces: each strip has its own slip.
//!
//! With the strip's place `p` on the wheel's undeformed surface, its tangent `t` and normal `n`,
//!
//! ```text
//! c_i = ((v + ω×p)·e_x, (v + ω×p)·t, ω·n)/V = B_i u/V,   Q = Σ B_iᵀ F_i
//! ```
//!
//! for the wheel's six velocities `u`, and `Q` is the wrench. A rail that moves adds its speed at
//! the strip to the first, and the rate of a roller about the strip's normal to the last. The
//! derivatives of a strip's forces with respect to its own creepages, `J_i`, give
//! `∂Q/∂u = Σ B_iᵀ J_i B_i/V`. Falling friction has one share
//! `λ = g(P/(λ Σ μ₀ N), V)` for all strips, and forces are homogeneous in creepages, mismatch and
//! `λ`:
//!
//! ```text
//! λ ∂Q/∂λ = Q − (∂Q/∂c) c − κ ∂Q/∂κ,   λ ∂P/∂λ = 2 P − (∂P/∂c) c − κ ∂P/∂κ
//! ```

use super::ends::{Law, Pressed, at_speed};
use crate::contact::creepage::Creepage;
use crate::forces::Model;
use crate::friction::SlipFriction;
use crate::motion::Rolling;
use crate::number::{Float, Number, add, at};
use crate::patch::each_strip::{AtStrip, By, Visited, creepage_at, each_strip};
use crate::patch::{KSTRIP_PATCH_CAPACITY, PatchView};
use crate::status::{Error, Warning};
use crate::wheel_rail::contacts::WheelContact;
use crate::wheel_rail::touch::line_of_contact::Axes;
use crate::wheel_rail::{dot, sine_cosine};
use heapless::Vec;

/// Creep forces of a contact on the rail, conjugate to the six velocities.
#[derive(Clone, Copy, Default)]
pub(super) struct Creep<F> {
    pub wrench: [F; 6],
    /// Power divided by the speed.
    pub power: F,
    /// Row by row.
    pub by_velocity: [[F; 6]; 6],
    /// By a factor of all coefficients of friction.
    pub by_friction: [F; 6],
    pub warning: Warning,
    /// By the speed `V_f` at constant velocities.
    by_speed: [F; 6],
    /// `κ dQ/dκ`
    by_mismatch: [F; 6],
}

/// The creep forces, without `SLOPES` all derivatives of which are zero.
#[inline(never)]
pub(super) fn creep<F: Float, const SLOPES: bool>(
    contact: &WheelContact<F>, mut pressed: Pressed<F>, velocity: &[F; 6], rolling: &Rolling<F>,
    law: Law<F>,
) -> Result<Creep<F>, Error> {
    let Law { model, .. } = law;
    let falling = at_speed(law, rolling.speed);
    let end = End::<_, SLOPES> { velocity, speed: rolling.speed, falling: falling.as_ref(), model };
    let frames = Frames { contact, axes: contact.axes() };
    let mut ends = |ratio: F| {
        pressed.each_end(rolling, ratio, |view, creepage, is_turned| {
            let mut own = OwnFrames::new();
            frames.add_frames(is_turned, &mut own);
            end.creep(view, creepage, &own)
        })
    };
    let [ahead, behind] = ends(rolling.speed_by_rolling)?;
    let mean = |p: [F; 6], q: [F; 6]| {
        let mut mean = p;
        mean.iter_mut().zip(q).for_each(|(p, q)| *p = rolling.mean(*p, q));
        mean
    };
    let mut found = Creep {
        wrench: mean(ahead.wrench, behind.wrench),
        power: rolling.mean(ahead.power, behind.power),
        by_friction: mean(ahead.by_friction, behind.by_friction),
        by_speed: mean(ahead.by_speed, behind.by_speed),
        warning: ahead.warning.worse(behind.warning),
        ..ahead
    };
    if !SLOPES {
        return Ok(found);
    }
    // dQ/dV = w' (Q₊ − Q₋) + ∂Q/∂V_f ∂V_f/∂V, and through the mismatch
    for ((by, p), q) in found.by_speed.iter_mut().zip(ahead.wrench).zip(behind.wrench) {
        *by = *by * rolling.speed_by_rolling + (p - q) * rolling.share_slope;
    }
    if contact.patch.mismatch != F::zero() {
        let (near, rate) = rolling.through_ratio();
        let [ahead, behind] = ends(near)?;
        let moves = mean(ahead.by_mismatch, behind.by_mismatch);
        add(&mut found.by_speed, moves.map(|moves| moves * rate));
    }
    let rows = found.by_velocity.iter_mut().zip(behind.by_velocity).zip(found.by_speed);
    for ((row, behind), by_speed) in rows {
        *row = mean(*row, behind);
        add(row, contact.rolling_speed.map(|speed| by_speed * speed));
    }
    Ok(found)
}

/// The motion of a strip in its own frame.
pub(super) struct OwnFrame<F> {
    /// `B`: slip and spin rate by the wheel's velocities.
    rows: [[F; 6]; 3],
    /// Slip and spin rate of a wheel at rest \[m/s, rad/s\]: those of a rail that moves.
    at_rest: [F; 3],
}

/// The frames of all strips, in the order of the patch that rolls.
pub(super) type OwnFrames<F> = Vec<OwnFrame<F>, KSTRIP_PATCH_CAPACITY>;

/// The frames of the strips of a contact.
pub(super) struct Frames<'a, F> {
    pub(super) contact: &'a WheelContact<F>,
    pub(super) axes: Axes<F>,
}

impl<F: Float> Frames<'_, F> {
    /// Appends the frames of all strips of a patch that may be turned by 180 degrees.
    pub(super) fn add_frames(&self, is_turned: bool, frames: &mut OwnFrames<F>) {
        let count = self.contact.patch.count as usize;
        for k in 0..count {
            let own =
                if is_turned { self.of_strip(count - 1 - k).turned() } else { self.of_strip(k) };
            let _ = frames.push(own);
        }
    }

    /// The frame of a strip by its number.
    fn of_strip(&self, number: usize) -> OwnFrame<F> {
        let Self { contact, axes } = self;
        let of = |list: &[F]| at(list, number);
        let strip = contact.patch.strips.get(number).copied().unwrap_or_default();
        let [origin, ..] = contact.origin;
        let [x, y, z] = [origin + strip.centre_x, of(&contact.strip_y), of(&contact.strip_z)];
        let (sine, cosine) = sine_cosine(of(&contact.strip_angle));
        // the normals of the wheel and of the rail
        let lean = of(&contact.strip_lean);
        let per_size = F::one() / lean.squared().plus(1.0).sqrt();
        let wheel = [(sine - cosine * lean) * per_size, (cosine + sine * lean) * per_size];
        let rail_sine = (sine + cosine * lean) * per_size;
        OwnFrame {
            rows: axes.rows([x, y, z], [sine, cosine], wheel, &contact.over(x, z)),
            at_rest: [of(&contact.strip_rail_speed), F::zero(), rail_sine * contact.rail_rate],
        }
    }
}

impl<F: Float> OwnFrame<F> {
    /// The same of a patch that is turned by 180 degrees.
    fn turned(self) -> Self {
        let ([x, y, spin], [slip_x, slip_y, spin_rate]) = (self.rows, self.at_rest);
        let rows = [x.map(|x| -x), y.map(|y| -y), spin];
        Self { rows, at_rest: [-slip_x, -slip_y, spin_rate] }
    }
}

/// The linear combination of three rows.
fn combined<F: Float>(rows: &[[F; 6]; 3], [a, b, c]: [F; 3]) -> [F; 6] {
    let [x, y, z] = rows;
    let mut sum = *x;
    for ((sum, y), z) in sum.iter_mut().zip(y).zip(z) {
        *sum = *sum * a + *y * b + *z * c;
    }
    sum
}

fn add_scaled<F: Float>(sums: &mut [F; 6], terms: [F; 6], factor: F) {
    add(sums, terms.map(|term| term * factor));
}

/// What the creep forces of one end of a contact follow from.
pub(super) struct End<'a, F, const SLOPES: bool> {
    pub(super) velocity: &'a [F; 6],
    pub(super) speed: F,
    pub(super) falling: Option<&'a SlipFriction<F>>,
    pub(super) model: Model,
}

/// Sums over the strips of an end at a constant share of friction.
#[derive(Clone, Copy)]
struct StripSums<F> {
    wrench: [F; 6],
    power: F,
    by_velocity: [[F; 6]; 6],
    power_by_velocity: [F; 6],
    /// Derivatives of wrench and power with respect to a factor of all creepages.
    along: [F; 6],
    power_along: F,
}

impl<F: Float> StripSums<F> {
    fn nothing() -> Self {
        let (zero, none) = (F::zero(), [F::zero(); 6]);
        let (wrench, power, by_velocity, power_by_velocity) = (none, zero, [none; 6], none);
        Self { wrench, power, by_velocity, power_by_velocity, along: none, power_along: zero }
    }

    /// Adds the derivatives of a strip with a creepage.
    fn add_slopes(
        &mut self, rows: &[[F; 6]; 3], (forces, power): &AtStrip<F>, creepage: &[F; 3],
        per_speed: F,
    ) {
        let (slopes, power_slopes) = (forces.map(|force| force.gradient), power.gradient);
        add_scaled(&mut self.power_by_velocity, combined(rows, power_slopes), per_speed);
        self.power_along += dot(&power_slopes, creepage);
        let along = slopes.map(|row| dot(&row, creepage));
        add_scaled(&mut self.along, combined(rows, along), F::one());
        for (row, slopes) in rows.iter().zip(slopes) {
            let by = combined(rows, slopes);
            for (sums, factor) in self.by_velocity.iter_mut().zip(row) {
                add_scaled(sums, by, *factor * per_speed);
            }
        }
    }
}

/// Creepages of strips.
type Creepages<F> = Vec<Creepage<F>, KSTRIP_PATCH_CAPACITY>;

impl<F: Float, const SLOPES: bool> End<'_, F, SLOPES> {
    /// What the strips have besides the creepages of the patch where they are.
    pub(super) fn own_creepages(
        &self, view: &PatchView<F>, creepage: &Creepage<F>, frames: &[OwnFrame<F>],
    ) -> Creepages<F> {
        let per_speed = F::one() / self.speed;
        let mut own = Creepages::new();
        for (place, OwnFrame { rows, at_rest }) in view.strips().iter().zip(frames) {
            let patch = creepage_at(creepage, place.centre_x, place.y);
            let [x, y, spin] = rows.each_ref().map(|row| dot(row, self.velocity));
            let [slip_x, slip_y, spin_rate] = *at_rest;
            let _ = own.push(Creepage {
                longitudinal: (x + slip_x) * per_speed - patch.longitudinal,
                lateral: (y + slip_y) * per_speed - patch.lateral,
                spin: (spin + spin_rate) * per_speed - patch.spin,
            });
        }
        own
    }

    fn creep(
        &self, view: &PatchView<F>, creepage: &Creepage<F>, frames: &[OwnFrame<F>],
    ) -> Result<Creep<F>, Error> {
        let Self { speed, falling, model, .. } = *self;
        let (zero, one) = (F::zero(), F::one());
        let per_speed = one / speed;
        let own = self.own_creepages(view, creepage, frames);
        let strips = view.strips();
        let whole = |k: usize| {
            let (Some(strip), Some(own)) = (strips.get(k), own.get(k)) else { return [zero; 3] };
            let patch = creepage_at(creepage, strip.centre_x, strip.y);
            let [x, y] = [patch.longitudinal + own.longitudinal, patch.lateral + own.lateral];
            [x, y, patch.spin + own.spin]
        };
        let view = view.with_own_creepages(&own)?;
        let mut sums = StripSums::nothing();
        let by = SLOPES.then_some(By::Creepages);
        let found =
            each_strip::<_, SLOPES>(&view, creepage, falling, (model, by), &mut |k, at| {
                let Some(OwnFrame { rows, .. }) = frames.get(k) else { return };
                let (forces, power) = at;
                sums.power += power.value;
                add_scaled(&mut sums.wrench, combined(rows, forces.map(|force| force.value)), one);
                if SLOPES {
                    sums.add_slopes(rows, at, &whole(k), per_speed);
                }
            })?;
        let StripSums { wrench, power, by_velocity, .. } = sums;
        let warning = found.warning;
        let mut creep = Creep { wrench, power, by_velocity, warning, ..Creep::default() };
        if !SLOPES {
            return Ok(creep);
        }
        let mut power_by_mismatch = zero;
        if view.mismatch() != zero {
            let by = Some(By::Mismatch);
            each_strip::<_, SLOPES>(&view, creepage, falling, (model, by), &mut |k, at| {
                let Some(OwnFrame { rows, .. }) = frames.get(k) else { return };
                let (forces, power) = at;
                let by = forces.map(|force| force.derivative(0));
                add_scaled(&mut creep.by_mismatch, combined(rows, by), one);
                power_by_mismatch += power.derivative(0);
            })?;
        }
        creep.follow_share(&sums, &found, power_by_mismatch, per_speed);
        Ok(creep)
    }
}

impl<F: Float> Creep<F> {
    /// Adds what the change of the share of friction does to the derivatives at a constant share.
    fn follow_share(
        &mut self, sums: &StripSums<F>, found: &Visited<F>, power_by_mismatch: F, per_speed: F,
    ) {
        let StripSums { wrench, power, power_by_velocity, along, power_along, .. } = *sums;
        let zero = F::zero();
        // λ ∂Q/∂λ and λ ∂P/∂λ; the derivatives at constant λ
        let mut by_share = wrench;
        for ((share, along), (speed, mismatch)) in
            by_share.iter_mut().zip(along).zip(self.by_speed.iter_mut().zip(self.by_mismatch))
        {
            *share = *share - along - mismatch;
            *speed = -(along * per_speed);
        }
        let power_by_share = power.times(2.0) - power_along - power_by_mismatch;
        // λ = g(s, V),  s = P/(λ Σ μ₀ N)
        let bound = found.share * found.bound;
        let slip = if bound > zero { (power / bound).max(zero) } else { zero };
        let over_bound = |power: F| if bound > zero { power / bound } else { zero };
        let of_share = (over_bound(power_by_share) - slip) / found.share;
        let friction = found.law.slopes(slip, found.falls, of_share);
        let through = |power: F| friction.along(zero, over_bound(power)) / found.share;
        for (row, share) in self.by_velocity.iter_mut().zip(by_share) {
            add_scaled(row, power_by_velocity.map(through), share);
        }
        let at_speed = if found.falls { friction.rolling_speed } else { zero };
        let by_slip = over_bound(-(power_along * per_speed));
        let by_speed = friction.along(at_speed, by_slip) / found.share;
        add_scaled(&mut self.by_speed, by_share, by_speed);
        add_scaled(&mut self.by_mismatch, by_share, through(power_by_mismatch));
        self.by_friction = by_share.map(|share| share * friction.feedback);
    }
}
