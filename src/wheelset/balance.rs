//! How far a wheelset is from balance under its loads, and the heights of its wheels that balance
//! all but the moment about the axle.
//!
//! The rest `r` has three members: vertical force, roll moment and moment about the axle, each with
//! its load and divided by its scale. It depends on the heights `h` of both wheels, which point
//! down, and on the pitch rate `ω`. Newton's step of the first two members gives the heights. With
//! it the third member is, up to the square of the step, the moment about the axle of balanced
//! heights:
//!
//! ```text
//! A = ∂(r₁, r₂)/∂h,   b = ∂(r₁, r₂)/∂ω,   c = ∂r₃/∂h
//! δh = −A⁻¹ (r₁, r₂),   dh/dω = −A⁻¹ b,   m = r₃ + c·δh,   dm/dω = ∂r₃/∂ω + c·dh/dω
//! ```

use super::KSTRIP_WHEELSET_FREEDOMS;
use super::forces::{
    Wheelset, WheelsetByPosition, WheelsetDerivatives, WheelsetForces, WheelsetWorkspace,
};
use crate::number::{Float, are_finite, at, length};
use crate::status::Error;
use crate::wheel_rail::{BodyState, Requested, dot};

/// Newton's steps of the heights, and halvings of a step.
const HEIGHT_STEPS: usize = 40;
const HALVINGS: usize = 8;
/// Halvings of a change of the pitch rate, and the rest from which heights do not follow it.
const RATE_HALVINGS: usize = 12;
const FAR: f64 = 0.3;
/// Largest change of a wheel's height in a step \[m\].
const LARGEST_HEIGHT_STEP: f64 = 1e-4;
/// Rest of force and roll moment up to which the moment about the axle is that of balanced heights:
/// the first bound, and the second times the root of the moment.
const LOOSE: f64 = 0.05;
const BY_ROOT: f64 = 0.1;
/// Steps of the heights below these roundings of the radius end, if the rest is below these
/// roundings of the load, and below this share of it.
const HEIGHT_ROUNDINGS: f64 = 64.0;
const LOAD_ROUNDINGS: f64 = 1e7;
const REST_LEFT: f64 = 0.01;

/// A wheelset under loads.
pub(super) struct Loaded<'s, 'a, F> {
    pub wheelset: &'s Wheelset<'a, F>,
    /// Vertical force, roll moment and torque about the axle.
    pub loads: [F; 3],
    pub memory: &'s mut WheelsetWorkspace<F>,
    /// Distance of the wheels from the middle of the wheelset \[m\].
    pub width: F,
    /// Mean rolling radius \[m\].
    pub radius: F,
    /// Whether one of the wheels may have no contact.
    pub may_lift: bool,
}

/// A state of the wheelset, its forces, and the way to balance.
#[derive(Clone, Copy)]
pub(super) struct Balance<F> {
    pub state: BodyState<F>,
    pub forces: WheelsetForces<F>,
    /// Size of the rest of vertical force and roll moment.
    pub rest: F,
    /// `δh` \[m\].
    step: [F; 2],
    /// `dh/dω` \[m s\].
    step_by_rate: [F; 2],
    /// `m`.
    pub moment: F,
    /// `dm/dω` \[s\].
    pub slope: F,
}

impl<F: Float> Balance<F> {
    /// The pitch rate \[rad/s\].
    pub fn rate(&self) -> F {
        self.state.velocity.pitch
    }

    /// The larger of both steps, in size.
    fn farthest(&self) -> F {
        let [right, left] = self.step.map(F::abs);
        right.max(left)
    }
}

impl<F: Float> Loaded<'_, '_, F> {
    /// The rest that is balance.
    pub fn balanced_rest() -> F {
        F::EPSILON.cube_root().squared()
    }

    /// Whether the steps of the heights are a few roundings of the radius.
    pub fn is_rounding(&self, here: &Balance<F>, roundings: f64) -> bool {
        here.farthest() <= self.radius * F::EPSILON.times(roundings)
    }

    fn scales(&self) -> [F; 3] {
        let [load, _, _] = self.loads;
        [load, load * self.width, load * self.radius]
    }

    /// `r`.
    pub(super) fn rest_of(&self, forces: &WheelsetForces<F>) -> [F; 3] {
        let [vertical, roll, pitch] = self.loads;
        let [_, _, down, over, about, _] = forces.wrench.members();
        let [by_down, by_over, by_about] = self.scales();
        [(down + vertical) / by_down, (over + roll) / by_over, (about + pitch) / by_about]
    }

    /// Derivatives of the rest, row by row: with respect to the height of the right wheel, that of
    /// the left wheel, and the pitch rate.
    fn slopes_of_rest(
        &self, by_velocity: &WheelsetDerivatives<F>, by_position: &WheelsetByPosition<F>,
    ) -> [[F; 3]; 3] {
        let scale = self.scales();
        core::array::from_fn(|i| {
            let entry = |matrix: &[[F; KSTRIP_WHEELSET_FREEDOMS]], k: usize| {
                matrix.get(i + 2).map_or(F::zero(), |row| at(row, k)) / at(&scale, i)
            };
            let sinks = entry(&by_position.position, 2).times(0.5);
            let rolls = entry(&by_position.position, 3) / self.width.times(2.0);
            [sinks + rolls, sinks - rolls, entry(&by_velocity.velocity, 4)]
        })
    }

    /// The rest at a state, and the way to balance.
    ///
    /// # Errors
    /// [`Error::WheelLifted`] where a wheel does not touch that must, or the heights do not
    /// determine the forces; those of [`Wheelset::solve`].
    fn at(&mut self, state: &BodyState<F>) -> Result<Balance<F>, Error> {
        let mut by_velocity = WheelsetDerivatives::default();
        let mut by_position = WheelsetByPosition::default();
        let requested =
            Requested { by_velocity: Some(&mut by_velocity), by_position: Some(&mut by_position) };
        let forces = self.wheelset.differentiate(state, self.memory, requested)?;
        let lifted = forces.wheel.iter().filter(|wheel| wheel.contacts == 0).count();
        Error::WheelLifted.when(lifted > usize::from(self.may_lift))?;
        let [down, over, about] = self.rest_of(&forces);
        let [[a11, a12, b1], [a21, a22, b2], [c1, c2, by_rate]] =
            self.slopes_of_rest(&by_velocity, &by_position);
        let determinant = a11 * a22 - a12 * a21;
        let minus_inverse_times =
            |x: F, y: F| [(a12 * y - a22 * x) / determinant, (a21 * x - a11 * y) / determinant];
        let (step, step_by_rate) = (minus_inverse_times(down, over), minus_inverse_times(b1, b2));
        let moment = about + dot(&[c1, c2], &step);
        let slope = by_rate + dot(&[c1, c2], &step_by_rate);
        Error::WheelLifted.unless(are_finite(&step) && are_finite(&[moment, slope]))?;
        let rest = length(down, over);
        Ok(Balance { state: *state, forces, rest, step, step_by_rate, moment, slope })
    }

    /// The size of the rest of force and roll moment; none where a profile ends.
    fn rest_at(&mut self, state: &BodyState<F>) -> Option<F> {
        let forces = self.wheelset.solve(state, self.memory).ok()?;
        let [down, over, _] = self.rest_of(&forces);
        Some(length(down, over))
    }

    /// The state with a share of the step of the heights, and with another pitch rate, which the
    /// heights follow.
    fn moved(&self, here: &Balance<F>, share: F, more: F) -> BodyState<F> {
        let [right, left] =
            [0, 1].map(|k| share * at(&here.step, k) + more * at(&here.step_by_rate, k));
        let mut state = here.state;
        state.position.vertical += (right + left).times(0.5);
        state.position.roll += (right - left) / self.width.times(2.0);
        state.velocity.pitch += more;
        state
    }

    /// The moment about the axle of the pressure alone, divided by its scale: a rounding of the
    /// geometry, which no friction balances.
    pub fn moment_of_pressure(&self) -> F {
        let contacts = self.memory.wheel.iter().flat_map(|memory| memory.found());
        let sum = contacts.fold(F::zero(), |sum, contact| {
            sum + contact.share * contact.normal_force * at(&contact.normal, 4)
        });
        let [.., by_about] = self.scales();
        (sum / by_about).abs()
    }

    /// Balances vertical force and roll moment at the pitch rate of a state: exactly, or as well as
    /// the moment about the axle needs it. If one wheel may be lifted, also far from the state.
    ///
    /// # Errors
    /// [`Error::WheelLifted`] where no heights balance them; those of [`Wheelset::solve`].
    pub fn balanced_at(
        &mut self, state: &BodyState<F>, is_exact: bool,
    ) -> Result<Balance<F>, Error> {
        let found = self.at(state).and_then(|first| self.balanced(first, is_exact));
        if found.is_ok() || !self.may_lift {
            return found;
        }
        let near = self.rolled(state)?;
        self.at(&near).and_then(|first| self.balanced(first, is_exact))
    }

    /// Changes the pitch rate of a balance and lets the heights follow; by less where they would
    /// have to go far or find no balance.
    pub fn followed(&mut self, here: &Balance<F>, mut more: F) -> Result<Balance<F>, Error> {
        for _ in 0..RATE_HALVINGS {
            let next = self.moved(here, F::one(), more);
            if let Ok(found) = self.at(&next)
                && found.rest < F::of(FAR)
                && let Ok(balance) = self.balanced(found, false)
            {
                return Ok(balance);
            }
            more = more.times(0.5);
        }
        Err(Error::WheelLifted)
    }

    /// Newton's method from a state, by steps that lessen the rest of force and roll moment.
    fn balanced(&mut self, mut here: Balance<F>, is_exact: bool) -> Result<Balance<F>, Error> {
        for _ in 0..HEIGHT_STEPS {
            let loose = here.moment.abs().sqrt().times(BY_ROOT).min(F::of(LOOSE));
            let enough = if is_exact { F::zero() } else { loose };
            if here.rest <= enough.max(Self::balanced_rest()) || self.is_rounding(&here, 1.0) {
                return Ok(here);
            }
            let Some(next) = self.closer(&here) else {
                let most = F::EPSILON.times(LOAD_ROUNDINGS).min(F::of(REST_LEFT));
                let is_close = here.rest < most && self.is_rounding(&here, HEIGHT_ROUNDINGS);
                Error::WheelLifted.unless(is_close)?;
                return self.at(&here.state);
            };
            here = next;
        }
        Err(Error::WheelLifted)
    }

    /// A state with less rest of force and roll moment.
    fn closer(&mut self, here: &Balance<F>) -> Option<Balance<F>> {
        let mut share = (F::of(LARGEST_HEIGHT_STEP) / here.farthest()).min(F::one());
        let whole = self.moved(here, share, F::zero());
        if let Ok(next) = self.at(&whole)
            && next.rest < here.rest
        {
            return Some(next);
        }
        for _ in 0..HALVINGS {
            share = share.times(0.5);
            let next = self.moved(here, share, F::zero());
            if self.rest_at(&next).is_some_and(|rest| rest < here.rest) {
                // a wheel that is lifted but must touch is too high
                if let Ok(found) = self.at(&next) {
                    return Some(found);
                }
            }
        }
        None
    }
}
