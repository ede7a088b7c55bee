//! Height, roll and pitch rate of a wheelset under given loads.
//!
//! The heights of both wheels, which are vertical position and roll, follow from vertical force and
//! roll moment at any pitch rate: the file `balance`. The moment about the axle falls with the
//! pitch rate from the one at which all wheels drive to the one at which all wheels brake, and a
//! bracket contains the root. The search begins at the pitch rate of pure rolling on the mean
//! radius, and goes on by Newton's method. If the heights find no balance on the way, it begins
//! again at the pitch rate at which one of the contacts rolls purely. If no search ends with both
//! wheels on the rails, all begin again, and one wheel may lift: the other one then balances the
//! loads by the roll.

use super::balance::{Balance, Loaded};
use super::forces::{Wheelset, WheelsetForces, WheelsetWorkspace};
use super::kinematics::Kinematics;
use crate::number::{Float, are_finite, at};
use crate::numerics::Bracket;
use crate::status::{Error, Warning};
use crate::wheel_rail::scene::Scene;
use crate::wheel_rail::{BodyState, KSTRIP_CONTACTS_CAPACITY, Position, Velocity};
use heapless::Vec;

/// Largest number of pitch rates at which the wheelset is balanced.
const RATES: usize = 100;
/// Largest first change of the rim's speed, over the rolling speed, and at standstill \[m/s\].
const FIRST_SLIP: f64 = 0.02;
const SLOW_SLIP: f64 = 0.02;
/// Speed of the rim over the rolling speed and 1 m/s up to which the moment is searched.
const FASTEST: f64 = 1e3;
/// Steps in which the largest moment of falling friction is searched.
const CRESTS: usize = 24;
/// Moment over its scale that is left where the pitch rates of a bracket are neighbours.
const MOMENT_LEFT: f64 = 0.01;
/// Least share of the load that a wheel is taken to carry at the beginning.
const LEAST_SHARE: f64 = 0.02;
/// How often both heights are found for the wheels' loads, and the change that ends this \[m\].
const PASSES: usize = 16;
const STAYS: f64 = 1e-6;
/// Pitch rates at which a search begins: that of the mean radius, and those of all contacts.
const FIRST_RATES: usize = 1 + 2 * KSTRIP_CONTACTS_CAPACITY;

/// Loads of the vehicle and of gravity on a wheelset that does not accelerate.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WheelsetLoads<F> {
    /// Downward force at the centre \[N\], weight included, > 0, else KSTRIP_ERROR_SUPPORT.
    pub vertical: F,
    /// Moment about the wheelset's x axis \[N m\]: positive from y to z, onto the right rail.
    pub roll: F,
    /// Torque about the axle \[N m\], in the sense of the pitch rate: negative drives forward.
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
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::Support`] for a vertical load that is not positive;
    /// [`Error::WheelLifted`] if no heights balance force and roll moment, not even with one of the
    /// wheels lifted, or the error that names an implausible input then;
    /// [`Error::ForceBeyondFriction`] for a torque that friction does not carry; those of
    /// [`Wheelset::solve`].
    pub fn settle(
        &self, start: &BodyState<F>, loads: &WheelsetLoads<F>, memory: &mut WheelsetWorkspace<F>,
    ) -> Result<Settled<F>, Error> {
        let WheelsetLoads { vertical, roll, pitch } = *loads;
        Error::NotFinite.unless(are_finite(&[vertical, roll, pitch]))?;
        Error::Support.unless(vertical > F::zero())?;
        let [width, _] = self.sides.map(|side| side.arm.abs());
        let [right, _] = self.scenes;
        let supports = self.sides.map(|side| {
            let carried = vertical.times(0.5) + roll / side.arm.times(2.0);
            carried.max(vertical.times(LEAST_SHARE))
        });
        let (position, radii) = self.carried(&start.position, supports, memory)?;
        let radius = radii.into_iter().fold(F::zero(), |sum, own| sum + own.times(0.5));
        let speed = start.velocity.forward + right.pair.rail_speed;
        let mut rates = Vec::<F, FIRST_RATES>::new();
        let own = Velocity { pitch: F::zero(), ..start.velocity }.members();
        let first = -speed / radius;
        let of_contacts = self.sides.iter().zip(&memory.wheel).flat_map(|(side, memory)| {
            let velocity = Kinematics::new(*side, &position).velocity(&own).members();
            memory.found().iter().map(move |contact| {
                let slip = contact.motion(&velocity).slip_x;
                -slip / at(&contact.slip_x, 4)
            })
        });
        rates.extend(core::iter::once(first).chain(of_contacts).take(FIRST_RATES));
        let loads = [vertical, roll, pitch];
        let loaded = Loaded { wheelset: self, loads, memory, width, radius, may_lift: false };
        let mut search = PitchSearch { loaded, speed: speed.abs() };
        let start = BodyState { position, velocity: start.velocity };
        let found = search.balance_from_any(&start, &rates);
        match found {
            Ok(_) | Err(Error::ForceBeyondFriction) => found,
            Err(error) => {
                // an implausible input is named before a wheel is lifted because of it
                let named = right.cause().named(error, &position);
                named.unless(named == error)?;
                search.loaded.may_lift = true;
                search.balance_from_any(&start, &rates).map_err(|_| error)
            }
        }
    }

    /// The heights at which the pressure of each wheel carries a load, and the radii there.
    fn carried(
        &self, start: &Position<F>, supports: [F; 2], memory: &mut WheelsetWorkspace<F>,
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
                let (height, _) = scene.height_for_load(&position, support, None, memory)?;
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

/// The search for the pitch rate of a wheelset under loads.
struct PitchSearch<'s, 'a, F> {
    loaded: Loaded<'s, 'a, F>,
    /// Rolling speed \[m/s\].
    speed: F,
}

/// The pitch rates at which a search has been.
struct PitchRates<F> {
    /// The last one at which the moment is positive, so that the root is larger.
    below: Option<F>,
    /// The last one at which it is not.
    above: Option<F>,
    /// Sizes of the last step and of the one before.
    last: [F; 2],
    /// Largest next step away from where it began.
    outward: F,
    /// Where the moment falls with the pitch rate, and where it rises: its maximum lies between.
    crest: Option<Bracket<F>>,
    /// Rate of the last balance at which the moment falls.
    falls: Option<F>,
    /// How many steps the search for a maximum has left.
    crests: usize,
}

impl<F: Float> PitchSearch<'_, '_, F> {
    /// The balance that is found from the first pitch rate that leads to one.
    fn balance_from_any(&mut self, start: &BodyState<F>, rates: &[F]) -> Result<Settled<F>, Error> {
        let mut failed = Error::WheelLifted;
        for (k, rate) in rates.iter().enumerate() {
            let velocity = Velocity { pitch: *rate, ..start.velocity };
            match self.balance_from(&BodyState { velocity, ..*start }) {
                Ok(settled) => return Ok(settled),
                Err(error) if k == 0 || error == Error::ForceBeyondFriction => failed = error,
                Err(_) => {}
            }
        }
        Err(failed)
    }

    /// The balance that is found from a pitch rate.
    fn balance_from(&mut self, start: &BodyState<F>) -> Result<Settled<F>, Error> {
        let radius = self.loaded.radius;
        let mut here = self.loaded.balanced_at(start, false)?;
        let first = here.state;
        let pressed = self.loaded.moment_of_pressure().times(2.0) + Loaded::<F>::balanced_rest();
        let is_balanced_by_pressure = here.moment.abs() <= pressed;
        let farthest = self.speed.plus(1.0).times(FASTEST) / radius;
        let first_step = self.speed.times(FIRST_SLIP).plus(SLOW_SLIP) / radius;
        let mut visited = PitchRates {
            below: None,
            above: None,
            last: [F::LARGEST; 2],
            outward: first_step,
            crest: None,
            falls: None,
            crests: CRESTS,
        };
        for _ in 0..RATES {
            if self.is_settled(&here) {
                return Ok(settled(&here, Warning::None));
            }
            let Some(step) = visited.next_step(&here) else {
                let is_close = here.moment.abs() < F::of(MOMENT_LEFT);
                let warning = if is_close { Warning::None } else { Warning::NotConverged };
                return Ok(settled(&here, warning));
            };
            let next = here.rate() + step;
            if (next - first.velocity.pitch).abs() > farthest {
                // without friction any pitch rate is as good
                Error::ForceBeyondFriction.unless(is_balanced_by_pressure)?;
                return Ok(settled(&self.loaded.balanced_at(&first, true)?, Warning::None));
            }
            let before = here.rate();
            here = self.loaded.followed(&here, step)?;
            let moved = (here.rate() - before).abs();
            // a step below the rounding of the rate does not grow
            visited.outward = if moved > F::zero() { moved.times(2.0) } else { first_step };
        }
        Ok(settled(&here, Warning::NotConverged))
    }

    /// Whether the rest is none, or the next steps are roundings.
    fn is_settled(&self, here: &Balance<F>) -> bool {
        let least = Loaded::<F>::balanced_rest();
        let rim = (here.moment / here.slope).abs() * self.loaded.radius;
        let is_rounding = rim <= self.speed.plus(SLOW_SLIP) * F::EPSILON;
        (here.rest <= least || self.loaded.is_rounding(here, 1.0))
            && (here.moment.abs() <= least || is_rounding)
    }
}

impl<F: Float> PitchRates<F> {
    /// Notes a balance, and returns the next change of the pitch rate; none if the root lies
    /// between neighbouring numbers.
    fn next_step(&mut self, here: &Balance<F>) -> Option<F> {
        let rate = here.rate();
        let is_below = here.moment > F::zero();
        if is_below {
            self.below = Some(rate)
        } else {
            self.above = Some(rate)
        }
        let newton = -here.moment / here.slope;
        let falls = here.slope < F::zero();
        let step = if let (Some(positive), Some(negative)) = (self.below, self.above) {
            let bracket = Bracket { negative, positive };
            let [_, before] = self.last;
            let middle = bracket.middle();
            if middle == negative || middle == positive {
                return None;
            }
            // a step must be less than half of the one before the last
            let is_slow = newton.abs() > before.times(0.5);
            let next = if is_slow { middle } else { bracket.guarded(rate + newton) };
            next - rate
        } else if let Some(crest) = self.crest_at(rate, falls) {
            crest - rate
        } else if falls && newton.abs() <= self.outward {
            newton
        } else if is_below {
            self.outward
        } else {
            -self.outward
        };
        let [last, _] = self.last;
        self.last = [step.abs(), last];
        Some(step)
    }

    /// Where to look for the largest moment, if it is between the last places: falling friction
    /// carries it near pure rolling only.
    fn crest_at(&mut self, rate: F, falls: bool) -> Option<F> {
        match (&mut self.crest, self.falls) {
            (Some(crest), _) if falls => crest.negative = rate,
            (Some(crest), _) => crest.positive = rate,
            (None, Some(negative)) if !falls => {
                self.crest = Some(Bracket { negative, positive: rate });
            }
            (None, _) => {}
        }
        if falls {
            self.falls = Some(rate);
        }
        let crest = self.crest?;
        match self.crests.checked_sub(1) {
            Some(left) => {
                self.crests = left;
                Some(crest.middle())
            }
            None => {
                (self.crest, self.falls) = (None, None);
                None
            }
        }
    }
}

fn settled<F: Float>(found: &Balance<F>, warning: Warning) -> Settled<F> {
    let Balance { state, forces, .. } = *found;
    Settled { state, forces, warning: forces.wrench.warning.worse(warning) }
}
