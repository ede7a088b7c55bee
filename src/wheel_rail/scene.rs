//! Force and moment for a position, and the height of a wheel that carries a load.

use super::contacts::{self, WheelContact};
use super::surface::Surface;
use super::touch::{Gap, touch};
use super::wrench::{self, Law, Wrench, WrenchByPosition, WrenchDerivatives};
use super::{KSTRIP_CONTACTS_CAPACITY, Position, Velocity, WheelPair};
use crate::contact::totals::StripCount;
use crate::number::Float;
use crate::patch::StoredPatch;
use crate::status::{Error, Warning};

/// Largest steps of the differences with respect to the position in double and in single precision
/// \[m, rad\], and the largest share of the overlap.
const STEPS: [(f64, f64); 2] = [(1e-6, 0.05), (15e-6, 0.5)];

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
    /// Those of [`touch`] and [`contacts::from_gap`].
    pub fn place(
        &self,
        position: &Position<F>,
        memory: &mut Workspace<F>,
    ) -> Result<Warning, Error> {
        let Self { pair, strips, .. } = *self;
        pair.check()?;
        let Workspace { gap, strips: whole, contacts, count, apart } = memory;
        self.touch(position, gap)?;
        let found = contacts::from_gap(gap, pair, position, strips, whole, contacts)?;
        (*count, *apart) = (found.written as u32, found.apart);
        Ok(found.warning)
    }

    fn touch(&self, position: &Position<F>, gap: &mut Gap<F>) -> Result<F, Error> {
        let Self { rail, wheel, pair, .. } = *self;
        let right = position.mirrored(pair.left != 0);
        touch(rail, wheel, pair.wheel_radius, &right, F::zero(), gap)
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
        if let Some(slopes) = by_position {
            *slopes = self.differences(position, velocity, memory)?;
        }
        self.wrench(position, velocity, memory, derivatives)
    }

    /// The step of the differences. A load grows with the overlap `δ` to the power 3/2, so that
    /// steps `d` make an error of `d²/(24 δ²)`.
    fn step_of_differences(
        &self,
        position: &Position<F>,
        memory: &mut Workspace<F>,
    ) -> Result<F, Error> {
        let right = position.mirrored(self.pair.left != 0);
        let Scene { rail, wheel, pair, .. } = *self;
        let least = touch(rail, wheel, pair.wheel_radius, &right, F::zero(), &mut memory.gap)?;
        let [double, single] = STEPS;
        let (largest, share) = if F::EPSILON > F::of(1e-10) { single } else { double };
        let largest = F::of(largest);
        let of_overlap = (-least).times(share).max(largest.times(1e-3));
        Ok(if least < F::zero() { of_overlap.min(largest) } else { largest })
    }

    /// Derivatives by the position, by central differences.
    fn differences(
        &self,
        position: &Position<F>,
        velocity: &Velocity<F>,
        memory: &mut Workspace<F>,
    ) -> Result<WrenchByPosition<F>, Error> {
        let step = self.step_of_differences(position, memory)?;
        let mut by = |member: fn(&mut Position<F>) -> &mut F| {
            let mut at = |step: F| {
                let mut moved = *position;
                *member(&mut moved) += step;
                self.wrench(&moved, velocity, memory, None).map(|found| found.members())
            };
            let (above, mut slopes) = (at(step)?, at(-step)?);
            for (slope, above) in slopes.iter_mut().zip(above) {
                *slope = (above - *slope) / step.times(2.0);
            }
            Ok(slopes)
        };
        Ok(WrenchByPosition {
            lateral: by(|position| &mut position.lateral)?,
            vertical: by(|position| &mut position.vertical)?,
            yaw: by(|position| &mut position.yaw)?,
            roll: by(|position| &mut position.roll)?,
        })
    }
}

impl<F> Workspace<F> {
    /// The contacts.
    #[must_use]
    pub fn found(&self) -> &[WheelContact<F>] {
        self.contacts.get(..self.count as usize).unwrap_or(&[])
    }
}
