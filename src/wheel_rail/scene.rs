//! Force and moment for a position, and the height of a wheel that carries a load.

use super::contacts::{self, WheelContact};
use super::plausibility;
use super::surface::Surface;
use super::touch::{Gap, REACH, touch_of_pair};
use super::wrench::{self, Law, Wrench, WrenchByPosition, WrenchDerivatives};
use super::{KSTRIP_CONTACTS_CAPACITY, Position, Velocity, WheelPair};
use crate::contact::totals::StripCount;
use crate::number::Float;
use crate::patch::StoredPatch;
use crate::status::{Error, Warning};

/// Steps of the differences to one side with respect to the members of a position \[m, rad\].
const STEPS: [f64; 4] = [1e-9, 3e-10, 1e-8, 1e-9];
/// Largest step of the central differences of single precision, and the largest share of the
/// overlap.
const SINGLE_STEP: f64 = 15e-6;
const SINGLE_SHARE: f64 = 0.5;

/// The members of a position.
const fn members<F>() -> [fn(&mut Position<F>) -> &mut F; 4] {
    [|at| &mut at.lateral, |at| &mut at.vertical, |at| &mut at.yaw, |at| &mut at.roll]
}

fn is_single<F: Float>() -> bool {
    F::EPSILON > F::of(1e-10)
}

/// Memory of the caller for the computation of one wheel. It may hold anything before a call. After
/// KSTRIP_OK or a warning it holds the gap and the contacts of the position; after an error its
/// contents have no meaning.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Workspace<F> {
    /// The gap between the surfaces.
    pub gap: Gap<F>,
    /// Memory in which the normal problem of a contact is solved.
    pub strips: StoredPatch<F>,
    /// The contacts, in ascending y of a right wheel; the first count are used.
    pub contacts: [WheelContact<F>; KSTRIP_CONTACTS_CAPACITY],
    /// Number of contacts.
    pub count: u32,
    /// Number of contacts that are more than 4 mm apart from each other.
    pub apart: u32,
}

/// Two surfaces, their materials, and the options of the computation.
#[derive(Clone, Copy)]
pub struct Scene<'a, F> {
    /// The rail.
    pub rail: &'a Surface<F>,
    /// The wheel.
    pub wheel: &'a Surface<F>,
    /// Materials, friction, side.
    pub pair: &'a WheelPair<F>,
    /// Number of strips.
    pub strips: StripCount,
    /// The law of the creep forces.
    pub law: Law<'a, F>,
}

impl<F: Float> Scene<'_, F> {
    /// Finds the contacts of a position.
    ///
    /// # Errors
    /// Those of [`touch`](super::touch::touch) and [`contacts::from_gap`].
    pub fn place(
        &self,
        position: &Position<F>,
        memory: &mut Workspace<F>,
    ) -> Result<Warning, Error> {
        let Self { pair, strips, .. } = *self;
        let Workspace { gap, strips: whole, contacts, count, apart } = memory;
        self.touch(position, gap)?;
        let found = contacts::from_gap(gap, pair, position, strips, whole, contacts)?;
        (*count, *apart) = (found.written as u32, found.apart);
        Ok(found.warning)
    }

    fn touch(&self, position: &Position<F>, gap: &mut Gap<F>) -> Result<F, Error> {
        let Self { rail, wheel, pair, .. } = *self;
        pair.check()?;
        let right = position.mirrored(pair.left != 0);
        let reach = contacts::reach(wheel.step, pair.smoothing_length).min(F::of(REACH));
        touch_of_pair(rail, wheel, pair, &right, reach, gap)
    }

    pub(super) fn wrench(
        &self,
        position: &Position<F>,
        velocity: &Velocity<F>,
        memory: &mut Workspace<F>,
        derivatives: Option<&mut WrenchDerivatives<F>>,
    ) -> Result<Wrench<F>, Error> {
        self.place(position, memory)?;
        let wrench = wrench::of_contacts(memory.found(), velocity, self.law, derivatives)?;
        Ok(Wrench { contacts: memory.apart, ..wrench })
    }

    /// Computes the wrench of a position and a velocity.
    ///
    /// # Errors
    /// Those of [`Scene::place`] and [`wrench::of_contacts`].
    pub fn solve(
        &self,
        position: &Position<F>,
        velocity: &Velocity<F>,
        memory: &mut Workspace<F>,
        derivatives: Option<&mut WrenchDerivatives<F>>,
        by_position: Option<&mut WrenchByPosition<F>>,
    ) -> Result<Wrench<F>, Error> {
        let found = self.with_slopes(position, velocity, memory, derivatives, by_position)?;
        Ok(Wrench { warning: found.warning.worse(self.plausibility(memory)), ..found })
    }

    /// What is implausible about the scene and the contacts that were found.
    pub(super) fn plausibility(&self, memory: &Workspace<F>) -> Warning {
        plausibility::implausibility_of_wheel(self.rail, self.wheel, self.pair, memory.found())
    }

    fn with_slopes(
        &self,
        position: &Position<F>,
        velocity: &Velocity<F>,
        memory: &mut Workspace<F>,
        derivatives: Option<&mut WrenchDerivatives<F>>,
        by_position: Option<&mut WrenchByPosition<F>>,
    ) -> Result<Wrench<F>, Error> {
        let Some(slopes) = by_position else {
            return self.wrench(position, velocity, memory, derivatives);
        };
        let steps = self.steps_of_differences(position, memory)?;
        for ((column, member), step) in slopes.columns().into_iter().zip(members()).zip(steps) {
            let mut at = |step: F| {
                let mut moved = *position;
                *member(&mut moved) += step;
                self.wrench(&moved, velocity, memory, None).map(|found| found.members())
            };
            *column = at(step)?;
            if is_single::<F>() {
                for (above, below) in column.iter_mut().zip(at(-step)?) {
                    *above = (*above - below).times(0.5);
                }
            }
        }
        let found = self.wrench(position, velocity, memory, derivatives)?;
        for (column, step) in slopes.columns().into_iter().zip(steps) {
            for (slope, here) in column.iter_mut().zip(found.members()) {
                let rise = if is_single::<F>() { *slope } else { *slope - here };
                *slope = rise / step;
            }
        }
        Ok(found)
    }

    /// Derivatives with respect to the place of a roller's axis, by central differences; zero where
    /// the rail is straight.
    pub(crate) fn by_rail_ahead(
        &self,
        position: &Position<F>,
        velocity: &Velocity<F>,
        memory: &mut Workspace<F>,
    ) -> Result<[F; 6], Error> {
        let mut slopes = [F::zero(); 6];
        if self.pair.rail_radius > F::zero() {
            let step = F::of(if is_single::<F>() { 1e-4 } else { 1e-5 });
            for sign in [F::one(), -F::one()] {
                let rail_ahead = self.pair.rail_ahead + sign * step;
                let pair = WheelPair { rail_ahead, ..*self.pair };
                let moved = Scene { pair: &pair, ..*self };
                let found = moved.wrench(position, velocity, memory, None)?;
                for (slope, force) in slopes.iter_mut().zip(found.members()) {
                    *slope += sign * force / step.times(2.0);
                }
            }
        }
        Ok(slopes)
    }

    /// The steps of the differences. A load grows with the overlap `δ` to the power 3/2, so that
    /// central differences with the step `d` are off by `d²/(24 δ²)`, and those to one side by
    /// `d/(4 δ)`.
    fn steps_of_differences(
        &self,
        position: &Position<F>,
        memory: &mut Workspace<F>,
    ) -> Result<[F; 4], Error> {
        if !is_single::<F>() {
            // (those of a left wheel are mirrored)
            let [lateral, vertical, yaw, roll] = STEPS.map(F::of);
            let side = if self.pair.left != 0 { -F::one() } else { F::one() };
            return Ok([side * lateral, vertical, side * yaw, side * roll]);
        }
        let least = self.touch(position, &mut memory.gap)?;
        let largest = F::of(SINGLE_STEP);
        let of_overlap = (-least).times(SINGLE_SHARE).max(largest.times(1e-3));
        Ok([if least < F::zero() { of_overlap.min(largest) } else { largest }; 4])
    }
}

impl<F> Workspace<F> {
    /// The contacts.
    #[must_use]
    pub fn found(&self) -> &[WheelContact<F>] {
        self.contacts.get(..self.count as usize).unwrap_or(&[])
    }
}
