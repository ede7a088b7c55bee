//! Height, roll and pitch rate of a wheelset under given loads.
//!
//! Three equations for the vertical places `h` of both wheels and the pitch rate: vertical force,
//! roll moment and moment about the axle balance the loads. The search begins where pressure alone
//! carries the loads, and goes on by Newton's method with the derivatives of the forces, with
//! bounded steps that must lessen the rest. Where it finds no balance, a wheel lifts if the roll
//! moment turns the wheelset onto the other one that carries all.

use super::KSTRIP_WHEELSET_FREEDOMS;
use super::forces::{
    Wheelset, WheelsetByPosition, WheelsetDerivatives, WheelsetForces, WheelsetWorkspace,
};
use super::kinematics::Kinematics;
use crate::number::{Float, are_finite, at};
use crate::status::{Error, Warning};
use crate::wheel_rail::scene::Scene;
use crate::wheel_rail::{BodyState, Position, Requested, Velocity, cross, dot};

/// Newton's steps, and halvings of a step.
const STEPS: usize = 40;
const HALVINGS: usize = 8;
/// Largest change of a wheel's height in a step \[m\].
const FARTHEST: f64 = 1e-4;
/// Largest change of the rim's speed in a step, over the rolling speed, and at standstill \[m/s\].
const SLIP: f64 = 0.02;
const SLOW_SLIP: f64 = 0.02;
/// Steps below these roundings of radius and speed end, if the rest is below this share.
const ROUNDING: f64 = 64.0;
const NEARLY: f64 = 0.01;
/// Least share of the load that a wheel is taken to carry at the beginning.
const LEAST: f64 = 0.02;
/// Share of the load that a wheel carries which is about to lift.
const BARELY: f64 = 1e-6;
/// How often both heights are found for the wheels' loads, and the change that ends this \[m\].
const PASSES: usize = 16;
const STAYS: f64 = 1e-6;

/// Loads of the vehicle and of gravity on a wheelset that does not accelerate.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WheelsetLoads<F> {
    /// Downward force at the wheelset's centre \[N\], its weight included, > 0.
    pub vertical: F,
    /// Moment about the wheelset's x axis \[N m\]: positive from y to z, onto the right rail.
    pub roll: F,
    /// Torque about the axle \[N m\], in the sense of the pitch rate: negative where it drives
    /// forward.
    pub pitch: F,
}

/// A wheelset in balance.
#[derive(Clone, Copy, Debug)]
pub struct Settled<F> {
    /// Vertical, roll and the pitch rate have been found.
    pub state: BodyState<F>,
    /// The forces there.
    pub forces: WheelsetForces<F>,
    /// The warning, if there is one.
    pub warning: Warning,
}

impl<F: Float> Wheelset<'_, F> {
    /// Finds the vertical position, the roll and the pitch rate at which the rails balance the
    /// loads, at given lateral position, yaw and other velocities.
    ///
    /// # Errors [`Error::NotFinite`]; [`Error::Support`] for a vertical load that is not
    /// positive; [`Error::WheelLifted`] where a wheel would lift; [`Error::ForceBeyondFriction`]
    /// for a torque that friction does not carry; those of [`Wheelset::solve`].
    pub fn settle(
        &self,
        start: &BodyState<F>,
        loads: &WheelsetLoads<F>,
        memory: &mut WheelsetWorkspace<F>,
    ) -> Result<Settled<F>, Error> {
        let WheelsetLoads { vertical, roll, pitch } = *loads;
        Error::NotFinite.unless(are_finite(&[vertical, roll, pitch]))?;
        Error::Support.unless(vertical > F::zero())?;
        let [width, _] = self.sides.map(|side| side.arm.abs());
        let [right, _] = self.scenes;
        let supports = self.sides.map(|side| {
            let carried = vertical.times(0.5) + roll / side.arm.times(2.0);
            carried.max(vertical.times(LEAST))
        });
        let (position, radii) = self.carried(&start.position, supports, None, memory)?;
        let radius = radii.into_iter().fold(F::zero(), |sum, own| sum + own.times(0.5));
        let speed = start.velocity.forward + right.pair.rail_speed;
        let velocity = Velocity { pitch: -speed / radius, ..start.velocity };
        let mut here = BodyState { position, velocity };
        let settled = |state: BodyState<F>, forces: WheelsetForces<F>| {
            let warning = forces.wrench.warning;
            Settled { state, forces, warning }
        };
        let scale = [vertical, vertical * width, vertical * radius];
        let rest_of = |forces: &WheelsetForces<F>| {
            let [_, _, down, over, about, _] = forces.wrench.members();
            let [by_down, by_over, by_about] = scale;
            [(down + vertical) / by_down, (over + roll) / by_over, (about + pitch) / by_about]
        };
        let size = |rest: &[F; 3]| dot(rest, rest).sqrt();
        let least = F::EPSILON.cube_root().squared();
        let (slow, fast) = (F::of(SLOW_SLIP), speed.abs().times(SLIP));
        let (farthest, quickest) = (F::of(FARTHEST), (slow + fast) / radius);
        let (mut slopes, mut moved) =
            (WheelsetDerivatives::default(), WheelsetByPosition::default());
        let mut rest = [F::zero(); 3];
        'steps: for _ in 0..STEPS {
            let (by_velocity, by_position) = (Some(&mut slopes), Some(&mut moved));
            let requested = Requested { by_velocity, by_position };
            let forces = self.differentiate(&here, memory, requested)?;
            rest = rest_of(&forces);
            if size(&rest) <= least {
                return Ok(settled(here, forces));
            }
            let columns = columns_of_rest(&slopes, &moved, &scale, width);
            let Some([right, left, pitch]) = by_cramers_rule(columns, rest) else { break };
            // both heights keep their ratio
            let most = right.abs().max(left.abs());
            let rim = pitch.abs() * radius;
            let is_rounding = most <= radius * F::EPSILON.times(ROUNDING)
                && rim <= start.velocity.forward.abs().plus(1.0) * F::EPSILON.times(ROUNDING);
            let part = if most > farthest { farthest / most } else { F::one() };
            let (right, left) = (right * part, left * part);
            let pitch = pitch.clamped(-quickest, quickest);
            let mut share = F::one();
            for _ in 0..HALVINGS {
                let mut next = here;
                next.position.vertical -= share * (right + left).times(0.5);
                next.position.roll -= share * (right - left) / width.times(2.0);
                next.velocity.pitch -= share * pitch;
                // (a step beyond the profiles is too long as well)
                let tried = self.solve(&next, memory);
                if tried.is_ok_and(|forces| size(&rest_of(&forces)) < size(&rest)) {
                    here = next;
                    continue 'steps;
                }
                share = share.times(0.5);
            }
            if is_rounding && size(&rest) < F::of(NEARLY) {
                return Ok(settled(here, self.solve(&here, memory)?));
            }
            break;
        }
        let lifts = (0..2).any(|other| self.lifts(other, start, loads, memory));
        let forces = self.solve(&here, memory)?;
        let [down, over, about] = rest.map(F::abs);
        Error::WheelLifted.when(lifts || forces.wheel.iter().any(|wheel| wheel.contacts == 0))?;
        Error::ForceBeyondFriction.when(about > down.max(over) && about > F::of(1e-3))?;
        let warning = forces.wrench.warning.worse(Warning::NotConverged);
        Ok(Settled { warning, ..settled(here, forces) })
    }

    /// Whether a wheel lifts where the other one carries the whole load: the roll moment turns the
    /// wheelset onto that one. (Where there is no such place it does not.)
    fn lifts(
        &self,
        lifted: usize,
        start: &BodyState<F>,
        loads: &WheelsetLoads<F>,
        memory: &mut WheelsetWorkspace<F>,
    ) -> bool {
        let mut at = || {
            let of = |k| loads.vertical.times(if k == lifted { BARELY } else { 1.0 });
            let supports = [of(0), of(1)];
            let [right, _] = self.scenes;
            let (_, radii) = self.carried(&start.position, supports, None, memory)?;
            let [one, other] = radii;
            let radius = if lifted == 0 { other } else { one };
            let pitch = -(start.velocity.forward + right.pair.rail_speed) / radius;
            let velocity = Velocity { pitch, ..start.velocity };
            let (position, _) = self.carried(&start.position, supports, Some(&velocity), memory)?;
            self.solve(&BodyState { position, velocity }, memory)
        };
        let arm = self.sides.get(lifted).map_or(F::zero(), |side| side.arm);
        at().is_ok_and(|forces: WheelsetForces<F>| {
            let [_, _, _, over, ..] = forces.wrench.members();
            (over + loads.roll) * arm < F::zero()
        })
    }

    /// Where each wheel carries a load, by pressure alone or at a velocity, and the radii there.
    fn carried(
        &self,
        start: &Position<F>,
        supports: [F; 2],
        velocity: Option<&Velocity<F>>,
        memory: &mut WheelsetWorkspace<F>,
    ) -> Result<(Position<F>, [F; 2]), Error> {
        let mut here = *start;
        let mut radii = [F::zero(); 2];
        for _ in 0..PASSES {
            let mut sinks = [F::zero(); 2];
            let sides = self.scenes.iter().zip(&self.sides).zip(&mut memory.wheel);
            let found = sinks.iter_mut().zip(&mut radii).zip(supports);
            for (((scene, side), memory), ((sink, radius), support)) in sides.zip(found) {
                let kinematics = Kinematics::new(*side, &here);
                let position = kinematics.position();
                let pair = kinematics.pair(scene.pair);
                let scene = Scene { pair: &pair, ..*scene };
                let velocity = velocity.map(|own| kinematics.velocity(&own.members()));
                let (height, _) =
                    scene.height_for_load(&position, support, velocity.as_ref(), memory)?;
                *sink = height - position.vertical;
                let (mut sum, mut load) = (F::zero(), F::TINY);
                for contact in memory.found() {
                    let weight = contact.share * contact.normal_force;
                    sum += weight * contact.radius;
                    load += weight;
                }
                *radius = sum / load;
            }
            let ([right, left], [side, _]) = (sinks, self.sides);
            here.vertical += (right + left).times(0.5);
            here.roll += (right - left) / side.arm.times(2.0);
            if right.abs().max(left.abs()) < F::of(STAYS) {
                break;
            }
        }
        Ok((here, radii))
    }
}

/// Derivatives of vertical force, roll moment and moment about the axle, divided by their scale:
/// with respect to the heights of the right and of the left wheel, and to the pitch rate.
fn columns_of_rest<F: Float>(
    slopes: &WheelsetDerivatives<F>,
    moved: &WheelsetByPosition<F>,
    scale: &[F; 3],
    width: F,
) -> [[F; 3]; 3] {
    let column = |matrix: &[[F; KSTRIP_WHEELSET_FREEDOMS]], k: usize| -> [F; 3] {
        let entry = |i: usize| matrix.get(i + 2).map_or(F::zero(), |row| at(row, k));
        core::array::from_fn(|i| entry(i) / at(scale, i))
    };
    let [sinks, rolls] = [2, 3].map(|k| column(&moved.position, k));
    let by_height = |arm: F| {
        core::array::from_fn(|i| at(&sinks, i).times(0.5) + at(&rolls, i) / arm.times(2.0))
    };
    [by_height(width), by_height(-width), column(&slopes.velocity, 4)]
}

/// Cramer's rule for the columns of a matrix; none where they have no volume.
fn by_cramers_rule<F: Float>([a, b, c]: [[F; 3]; 3], right: [F; 3]) -> Option<[F; 3]> {
    let volume = dot(&a, &cross(b, c));
    let found = [dot(&right, &cross(b, c)), dot(&a, &cross(right, c)), dot(&a, &cross(b, right))]
        .map(|part| part / volume);
    are_finite(&found).then_some(found)
}
