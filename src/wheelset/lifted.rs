//! The balance of a wheelset one of whose wheels is lifted.
//!
//! The other wheel carries the vertical load at any roll, and its contact moves over the profiles
//! with the roll. Newton's method for both heights hardly moves along that line, because both
//! members of the rest depend on one force. So the vertical position is eliminated: what is left of
//! the roll moment is a function of the roll, which is followed in the sense of that moment until
//! it changes its sign.

use super::balance::Loaded;
use crate::number::Float;
use crate::status::Error;
use crate::wheel_rail::BodyState;

/// First steps of the roll \[rad\] and of the vertical position \[m\], which are doubled.
const ROLL_STEP: f64 = 1e-4;
const VERTICAL_STEP: f64 = 1e-5;
/// Largest number of steps that are doubled, and of those of false position.
const DOUBLINGS: usize = 11;
const NARROWINGS: usize = 40;

/// About the root to which a function leads from a place if it is followed upward while it is
/// positive, and downward while it is negative: by steps that are doubled, then by false position.
///
/// # Errors
/// [`Error::WheelLifted`] if it keeps its sign; those of the function.
fn followed_root<F: Float>(
    start: F, step: f64, mut of: impl FnMut(F) -> Result<F, Error>,
) -> Result<F, Error> {
    let (mut place, mut value) = (start, of(start)?);
    let mut step = if value > F::zero() { F::of(step) } else { -F::of(step) };
    let mut before = None;
    for _ in 0..DOUBLINGS {
        let last = (place, value);
        place += step;
        value = of(place)?;
        step = step.times(2.0);
        if value * last.1 <= F::zero() {
            before = Some(last);
            break;
        }
    }
    let (mut opposite, mut of_opposite) = before.ok_or(Error::WheelLifted)?;
    for _ in 0..NARROWINGS {
        if value.abs() <= F::EPSILON.sqrt() {
            break;
        }
        let next = place + (opposite - place) * (value / (value - of_opposite));
        let last = (place, value);
        (place, value) = (next, of(next)?);
        if value * last.1 < F::zero() {
            (opposite, of_opposite) = last;
        } else {
            // the end that stays counts half: the Illinois algorithm
            of_opposite = of_opposite.times(0.5);
        }
    }
    Ok(place)
}

impl<F: Float> Loaded<'_, '_, F> {
    /// About the state in which vertical force and roll moment are balanced at the pitch rate of a
    /// state, and to which the moment rolls the wheelset from there.
    ///
    /// # Errors
    /// [`Error::WheelLifted`] if there is none; those of
    /// [`Wheelset::solve`](super::forces::Wheelset::solve).
    pub(super) fn rolled(&mut self, start: &BodyState<F>) -> Result<BodyState<F>, Error> {
        let mut here = *start;
        let mut arm = F::zero();
        followed_root(start.position.roll, ROLL_STEP, |roll| {
            // the wheel that carries more keeps its height
            here.position.vertical -= arm * (roll - here.position.roll);
            here.position.roll = roll;
            Error::WheelLifted.unless(roll.abs() < F::one())?;
            let mut roll_moment = F::zero();
            let vertical = here.position.vertical;
            here.position.vertical = followed_root(vertical, VERTICAL_STEP, |vertical| {
                let mut state = here;
                state.position.vertical = vertical;
                let Ok(forces) = self.wheelset.solve(&state, self.memory) else {
                    // too deep
                    return Ok(-F::one());
                };
                let [right_force, left_force] = forces.wheel.map(|wheel| wheel.normal_force);
                arm = if right_force >= left_force { self.width } else { -self.width };
                let [down, over, _] = self.rest_of(&forces);
                roll_moment = over;
                Ok(down)
            })?;
            Ok(roll_moment)
        })?;
        Ok(here)
    }
}
