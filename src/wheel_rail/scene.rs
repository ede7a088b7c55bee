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
/// Largest number of heights that are tried for a load.
const HEIGHTS: u32 = 64;
/// Largest step from one height to the next \[m\], and the distance below which two heights are the
/// same \[m\].
const FARTHEST: f64 = 1e-4;
const NEAREST: f64 = 1e-14;

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

    fn wrench(
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

    /// The vertical position at which the rail supports the wheel with a force. Creep forces carry
    /// as well if there is a `velocity`.
    ///
    /// The support grows with the vertical position, from zero where the wheel is lifted. The
    /// search brackets the position and then uses the Illinois variant of false position on the
    /// force to the power 2/3, which is nearly linear for Hertz's contacts.
    ///
    /// # Errors
    /// Those of [`Scene::solve`]; [`Error::NormalForce`] for a force that is not positive.
    pub fn height_for_load(
        &self,
        position: &Position<F>,
        support: F,
        velocity: Option<&Velocity<F>>,
        memory: &mut Workspace<F>,
    ) -> Result<(F, Warning), Error> {
        if !support.is_finite_number() {
            return Err(Error::NotFinite);
        }
        if support <= F::zero() {
            return Err(Error::NormalForce);
        }
        let straight = |force: F| force.max(F::zero()).squared().cube_root();
        let (wanted, far) = (straight(support), F::of(FARTHEST));
        // a height with less than the wanted load, and one with more, with what the load exceeds
        // the wanted one by
        let mut above = (self.first_touch(position, memory)?, -wanted);
        let mut below: Option<(F, F)> = None;
        let (mut here, mut last) = (above.0 + far.times(0.5), F::zero());
        for _ in 0..HEIGHTS {
            let at = Position { vertical: here, ..*position };
            let rest = straight(self.support(&at, velocity, memory)?) - wanted;
            if rest.abs() <= wanted * F::EPSILON.times(64.0) {
                return Ok((here, Warning::None));
            }
            // an end that stays once more counts half
            if rest < F::zero() {
                above = (here, rest);
                below = below.map(|(low, more)| {
                    (low, if last < F::zero() { more.times(0.5) } else { more })
                });
            } else {
                below = Some((here, rest));
                above.1 = if last > F::zero() { above.1.times(0.5) } else { above.1 };
            }
            last = rest;
            let (high, less) = above;
            let next = match below {
                Some((low, more)) => {
                    if low - high <= F::of(NEAREST) {
                        return Ok((here, Warning::None));
                    }
                    let share = (less / (less - more)).clamped(F::of(0.02), F::of(0.98));
                    high + (low - high) * share
                }
                None => high + far,
            };
            if next == here {
                return Ok((here, Warning::None));
            }
            here = next;
        }
        Ok((here, Warning::NotConverged))
    }

    /// The upward force of the rail on the wheel; without a velocity that of the pressure alone.
    fn support(
        &self,
        position: &Position<F>,
        velocity: Option<&Velocity<F>>,
        memory: &mut Workspace<F>,
    ) -> Result<F, Error> {
        if let Some(velocity) = velocity {
            let [_, _, vertical] = self.wrench(position, velocity, memory, None)?.force;
            return Ok(-vertical);
        }
        self.place(position, memory)?;
        let pressures = memory.found().iter().map(|contact| {
            let [_, _, vertical, ..] = contact.normal;
            contact.share * contact.normal_force * vertical
        });
        Ok(pressures.fold(F::zero(), |sum, pressure| sum + pressure))
    }

    /// About the vertical position at which the wheel touches, by lowering the wheel a few times by
    /// the distance that is left.
    fn first_touch(&self, position: &Position<F>, memory: &mut Workspace<F>) -> Result<F, Error> {
        let mut here = *position;
        for _ in 0..HEIGHTS {
            let left = self.touch(&here, &mut memory.gap)?;
            here.vertical += left;
            if left.abs() < F::of(1e-6) {
                break;
            }
        }
        Ok(here.vertical)
    }
}

impl<F> Workspace<F> {
    /// The contacts.
    #[must_use]
    pub fn found(&self) -> &[WheelContact<F>] {
        self.contacts.get(..self.count as usize).unwrap_or(&[])
    }
}
