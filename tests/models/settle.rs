//! Every wheelset that has a balance settles: at any friction from 0 on, at any speed through 0, on
//! rails and on rollers.

use crate::prelude::*;
use crate::wheelset::{HALF, HALF_GAUGE, NOTHING, RADIUS, ROLLS, Stand, at};
use kstrip::wheelset::settle::Settled;
use kstrip::wheelset::track::gauge_face;
use kstrip_testing::manchester::{points, profile};

/// S1002 on 60E1 that is inclined by 1:40.
fn inclined() -> Stand {
    let (sine, cosine) = 0.025_f64.sin_cos();
    let [y, z] = points("uic60");
    let turned = y.iter().zip(&z);
    let (y, z): (Vec<f64>, Vec<f64>) =
        turned.map(|(y, z)| (y * cosine - z * sine, y * sine + z * cosine)).unzip();
    let mut rail = zeroed::<PreparedProfile<f64>>();
    rail.prepare(&y, &z, 0.0, 0.0).unwrap();
    let (face, _) = gauge_face(&rail, 0.0).unwrap();
    Stand::new(rail, profile("s1002"), HALF_GAUGE - face)
}

impl Stand {
    fn with_friction(mut self, friction: f64) -> Self {
        self.pairs.iter_mut().for_each(|pair| pair.friction = friction);
        self
    }

    /// On rollers of a radius that turn with a speed.
    fn on_rollers(mut self, rail_radius: f64, rail_speed: f64) -> Self {
        for pair in &mut self.pairs {
            *pair = WheelPair { rail_radius, rail_speed, ..*pair };
        }
        self
    }

    /// The balance, which is one but for rounding.
    #[track_caller]
    fn balance(
        &mut self, start: &Position<f64>, velocity: &Velocity<f64>, loads: &WheelsetLoads<f64>,
    ) -> Settled<f64> {
        let settled = self.settle(start, velocity, loads).unwrap();
        assert!(settled.warning != Warning::NotConverged);
        let WheelsetLoads { vertical, roll, pitch } = *loads;
        let wrench = settled.forces.wrench;
        assert_relative_eq!(wrench.force[2], -vertical, max_relative = 1e-9);
        assert_relative_eq!(wrench.moment[0], -roll, epsilon = 1e-9 * vertical);
        // without friction nothing balances what the pressure's directions are rounded by
        let rounding = if self.pairs[0].friction < 1e-3 { 1e-4 } else { 1e-9 };
        assert_relative_eq!(wrench.moment[1], -pitch, epsilon = rounding * vertical);
        settled
    }
}

/// Without friction a wheelset settles with the pitch rate of pure rolling.
#[test]
fn a_wheelset_without_friction_settles() {
    for (friction, forward, lateral, yaw, roll) in [
        (0.0, 20.0, 1e-3, 0.0, 5e3),
        (0.0, 0.0, 1e-3, 0.0, 0.0),
        (1e-9, 20.0, 1e-3, 0.0, 5e3),
        (0.0, -3.0, -4e-3, 5e-3, -30e3),
        (0.0, 1e-3, 5.8e-3, -2e-3, 10e3),
        (1e-7, 5.0, 3e-3, 0.02, 0.0),
    ] {
        let loads = WheelsetLoads { vertical: 100e3, roll, pitch: 0.0 };
        let mut stand = inclined().with_friction(friction);
        let velocity = Velocity { forward, ..ROLLS };
        let found = stand.balance(&at(lateral, yaw), &velocity, &loads);
        let pitch = found.state.velocity.pitch;
        assert_relative_eq!(pitch, -forward / RADIUS, max_relative = 0.02);
        let still = Velocity { forward: 0.0, ..velocity };
        let mut rollers = inclined().with_friction(friction).on_rollers(0.5, forward);
        let rolls = rollers.balance(&at(lateral, 0.0), &still, &loads).state.velocity.pitch;
        assert_relative_eq!(rolls, -forward / RADIUS, max_relative = 0.02);
        let torque = WheelsetLoads { pitch: 10.0, ..loads };
        let refused = stand.settle(&at(lateral, yaw), &velocity, &torque).unwrap_err();
        assert_eq!(refused, Error::ForceBeyondFriction);
    }
}

/// A wheelset that hardly rolls and turns on the spot.
#[test]
fn a_wheelset_nearly_at_rest_settles() {
    for (friction, forward, yaw) in [
        (0.3, 0.0, 0.01),
        (0.3, 0.0, 0.02),
        (0.1, 0.005, 0.02),
        (0.1, 0.05, 0.02),
        (0.3, 0.1, 0.05),
        (0.3, -0.1, 0.5),
        (0.3, 1.0, 0.5),
        (0.5, 1e-4, -0.1),
    ] {
        let loads = WheelsetLoads { vertical: 100e3, roll: 5e3, pitch: 0.0 };
        let velocity = Velocity { forward, yaw, ..ROLLS };
        inclined().with_friction(friction).balance(&at(1e-3, 0.0), &velocity, &loads);
        let still = Velocity { forward: 0.0, ..velocity };
        let mut rollers = inclined().with_friction(friction).on_rollers(0.5, forward);
        rollers.balance(&at(1e-3, 0.0), &still, &loads);
    }
}

/// On wet rails, near the flange, without any torque.
#[test]
fn a_wheelset_on_wet_rails_settles() {
    let loads = WheelsetLoads { vertical: 26_338.0, roll: 9_579.0, pitch: 0.0 };
    let velocity = Velocity { forward: 7.4, lateral: -9e-3, ..ROLLS };
    let mut pitch = None;
    for k in 0..12 {
        let mut stand = inclined().with_friction(0.3 - 0.02 * f64::from(k));
        let found = stand.balance(&at(4.72e-3, -2.93e-3), &velocity, &loads).state.velocity.pitch;
        let before = pitch.replace(found).unwrap_or(found);
        assert_relative_eq!(found, before, max_relative = 1e-3);
    }
}

/// States of any kind.
#[test]
fn any_state_settles() {
    let mut random = Random::new(67);
    for k in 0..24 {
        let friction = if k % 4 == 0 { 0.0 } else { random.log_between(0.03, 0.5) };
        let speed =
            if k % 4 == 1 { random.log_between(1e-4, 0.2) } else { random.between(0.5, 60.0) };
        let yaw_rate = if k % 4 == 1 { random.between(-0.1, 0.1) } else { 0.0 };
        let place = at(random.between(-6e-3, 6e-3), random.between(-5e-3, 5e-3));
        let vertical = random.log_between(20e3, 200e3);
        let roll = random.between(-0.6, 0.6) * vertical * HALF;
        let share = if k % 4 == 3 { random.between(-0.9, 0.9) } else { 0.0 };
        let pitch = share * friction * vertical * RADIUS;
        let loads = WheelsetLoads { vertical, roll, pitch };
        let velocity = Velocity { forward: speed, yaw: yaw_rate, ..ROLLS };
        let stand = inclined().with_friction(friction);
        println!("{k} {place:?} {speed} {friction} {loads:?}");
        if random.unit() < 0.3 {
            let still = Velocity { forward: 0.0, ..velocity };
            stand.on_rollers(random.between(0.3, 2.0), speed).balance(&place, &still, &loads);
        } else {
            { stand }.balance(&place, &velocity, &loads);
        }
    }
}

/// Friction that falls carries its largest torque near pure rolling only. A torque a little below
/// it is balanced, and one a little above it is not.
#[test]
fn falling_friction_carries_a_torque_up_to_its_crest() {
    let law = SlipFriction {
        friction: 0.4,
        ratio: 0.3,
        decay: 1.5,
        rolling_speed: 1.0,
        ..SlipFriction::default()
    };
    let (mut stand, mut driven) = (inclined(), inclined());
    (stand.law, driven.law) = (Some(law), Some(law));
    let velocity = Velocity { forward: 15.0, ..ROLLS };
    let mut carried = |pitch: f64| {
        let loads = WheelsetLoads { vertical: 100e3, roll: 0.0, pitch };
        stand.settle(&at(1e-3, 0.0), &velocity, &loads)
    };
    // the largest torque, where the loads are balanced at any pitch rate
    let rolling = carried(0.0).unwrap().state;
    let rates = (0..400).map(|k| rolling.velocity.pitch * (1.0 + 1e-4 * f64::from(k)));
    let moments = rates.map(|pitch| {
        let velocity = Velocity { pitch, ..velocity };
        driven.solve(&rolling.position, &velocity, [NOTHING; 2]).wrench.moment[1]
    });
    let most = moments.fold(0.0_f64, |most, moment| most.max(moment));
    assert!((0.6..0.8).contains(&(most / (100e3 * RADIUS * 0.4))), "{most}");
    for k in 1..=40 {
        let torque = most * 0.9995 * f64::from(k) / 40.0;
        let found = carried(-torque).unwrap();
        assert_relative_eq!(found.forces.wrench.moment[1], torque, max_relative = 1e-8);
    }
    assert_eq!(carried(-most * 1.02).unwrap_err(), Error::ForceBeyondFriction);
}

/// Where the flange climbs, one wheel carries all, and the other one is lifted. The carrying wheel
/// rolls with the wheelset until its force passes the wheelset's centre.
#[test]
fn a_wheelset_that_climbs_settles() {
    let loads = WheelsetLoads { vertical: 100e3, roll: 0.0, pitch: 0.0 };
    let mut lifted = 0;
    for k in 0..30 {
        let place = at(6.0e-3 + 5e-5 * f64::from(k), 0.0);
        let found = inclined().balance(&place, &ROLLS, &loads);
        let contacts = found.forces.wheel.map(|wheel| wheel.contacts);
        lifted += u32::from(contacts.contains(&0));
        // a left wheel on the mirror image does the same
        let mirrored = at(-place.lateral, 0.0);
        let other = inclined().balance(&mirrored, &ROLLS, &loads);
        assert_relative_eq!(other.state.position.roll, -found.state.position.roll, epsilon = 1e-9);
    }
    assert!((5..12).contains(&lifted), "{lifted}");
    // next to the shift at which both wheels touch again
    for k in 0..12 {
        inclined().balance(&at(6.69e-3 + 1e-5 * f64::from(k), 0.0), &ROLLS, &loads);
    }
}
