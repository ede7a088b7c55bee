//! Force and moment for a position, and the height of a wheel that carries a load.

use super::contacts::view;
use super::contacts::{self, WheelContact};
use super::forces::wrench::{self, Law, Wrench, WrenchByPosition, WrenchDerivatives};
use super::profile::PreparedProfile;
use super::touch::{Gap, GapSearch};
use super::{BodyState, KSTRIP_CONTACTS_CAPACITY, Position, Requested, WheelPair};
use crate::contact::totals::StripCount;
use crate::number::Float;
use crate::patch::Patch;
use crate::status::{Error, Warning};

pub(super) fn is_single<F: Float>() -> bool {
    F::EPSILON > F::of(1e-10)
}

/// Central differences of a wrench over a step.
fn differences<F: Float>(
    step: F, mut at: impl FnMut(F) -> Result<Wrench<F>, Error>,
) -> Result<[F; 6], Error> {
    let mut slopes = at(step)?.members();
    for (slope, behind) in slopes.iter_mut().zip(at(-step)?.members()) {
        *slope = (*slope - behind) / step.times(2.0);
    }
    Ok(slopes)
}

/// Caller-provided memory for the computation of one wheel. It may hold anything before a call.
/// After KSTRIP_OK or a warning it holds the gap and the contacts of the position; after an error
/// its contents have no meaning.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Workspace<F> {
    /// The gap between the surfaces.
    pub gap: Gap<F>,
    /// Memory in which the normal problem of a contact is solved.
    pub strips: Patch<F>,
    /// The contacts, in ascending y of a right wheel; the first count are used.
    pub contacts: [WheelContact<F>; KSTRIP_CONTACTS_CAPACITY],
    /// Number of contacts.
    pub count: u32,
    /// Reserved: zero.
    pub reserved: u32,
}

/// Finds the contacts of a position in the bytes of a table.
pub type FindInTable<F> =
    fn(&[u8], &WheelPair<F>, &Position<F>, &mut Workspace<F>) -> Result<Warning, Error>;
/// Computes the wrench, and the derivatives that are requested, from the bytes of a table.
pub type SolveInTable<F> = fn(
    &[u8],
    (&WheelPair<F>, Law<'_, F>),
    &BodyState<F>,
    &mut Workspace<F>,
    &mut Requested<WrenchDerivatives<F>, WrenchByPosition<F>>,
) -> Result<Wrench<F>, Error>;

/// A contact table in place of the normal problem. `kstrip::table` makes it from bytes.
#[derive(Clone, Copy)]
pub struct TableSource<'a, F> {
    /// The bytes of a finished table.
    pub bytes: &'a [u8],
    /// Whether a position outside the table is [`Error::TableRange`]; else its contacts are
    /// computed from the profiles.
    pub only: bool,
    /// The functions that read it.
    pub find: FindInTable<F>,
    /// The same.
    pub solve: SolveInTable<F>,
}

/// Two surfaces, their materials, and the options of the computation.
#[derive(Clone, Copy)]
pub struct Scene<'a, F> {
    /// The rail.
    pub rail: &'a PreparedProfile<F>,
    /// The wheel.
    pub wheel: &'a PreparedProfile<F>,
    /// Materials, friction, side.
    pub pair: &'a WheelPair<F>,
    /// Number of strips.
    pub strips: StripCount,
    /// The law of the creep forces.
    pub law: Law<'a, F>,
    /// Where the contacts come from, if not from the profiles.
    pub table: Option<TableSource<'a, F>>,
}

impl<'a, F: Float> Scene<'a, F> {
    /// The search for the gap at the position of a right wheel, or of the mirror image of a left
    /// one, between the surfaces of a pair that was checked.
    pub(crate) fn search_at(&self, right: &Position<F>) -> Result<GapSearch<'a, F>, Error> {
        GapSearch::of_pair(self.rail, self.wheel, self.pair, right)
    }

    /// What a table has for a position; none without a table, and outside one that is not the only
    /// source.
    fn of_table<T>(
        &self, read: impl FnOnce(TableSource<'a, F>) -> Result<T, Error>,
    ) -> Result<Option<T>, Error> {
        let Some(table) = self.table else { return Ok(None) };
        match read(table) {
            Err(Error::TableRange) if !table.only => Ok(None),
            found => found.map(Some),
        }
    }

    /// Finds the contacts of a position.
    ///
    /// # Errors
    /// Those of [`GapSearch::gap`](super::touch::GapSearch::gap) and [`contacts::from_gap`]; those
    /// of a table.
    pub fn place(
        &self, position: &Position<F>, memory: &mut Workspace<F>,
    ) -> Result<Warning, Error> {
        let Self { wheel, pair, strips, .. } = *self;
        let in_table = |table: TableSource<F>| (table.find)(table.bytes, pair, position, memory);
        if let Some(warning) = self.of_table(in_table)? {
            return Ok(warning);
        }
        let Workspace { gap, strips: whole, contacts, count, reserved } = memory;
        pair.check()?;
        let right = position.mirrored(pair.left != 0);
        let reach = view::reach(wheel.step, pair.smoothing_length);
        self.search_at(&right)?.gap(reach, gap)?;
        let found = contacts::from_gap(gap, pair, position, strips, whole, contacts)?;
        (*count, *reserved) = (found.written as u32, 0);
        Ok(found.warning)
    }

    pub(super) fn wrench(
        &self, state: &BodyState<F>, memory: &mut Workspace<F>,
        by_velocity: Option<&mut WrenchDerivatives<F>>,
    ) -> Result<Wrench<F>, Error> {
        let placed = self.place(&state.position, memory)?;
        let Workspace { strips, contacts, count, .. } = memory;
        let found = contacts.get(..*count as usize).unwrap_or(&[]);
        let velocity = &state.velocity;
        let wrench = wrench::of_contacts_in(strips, found, velocity, self.law, by_velocity)?;
        Ok(Wrench { warning: wrench.warning.worse(placed), ..wrench })
    }

    /// Computes the wrench of a position and a velocity.
    ///
    /// # Errors
    /// Those of [`Scene::place`] and [`wrench::of_contacts`].
    pub fn solve(
        &self, state: &BodyState<F>, memory: &mut Workspace<F>,
    ) -> Result<Wrench<F>, Error> {
        self.differentiate(state, memory, Requested { by_velocity: None, by_position: None })
    }

    /// [`Scene::solve`] with the derivatives that are requested.
    ///
    /// # Errors
    /// Those of [`Scene::solve`].
    pub fn differentiate(
        &self, state: &BodyState<F>, memory: &mut Workspace<F>,
        requested: Requested<WrenchDerivatives<F>, WrenchByPosition<F>>,
    ) -> Result<Wrench<F>, Error> {
        let found = self.differentiated(state, memory, requested);
        found.map_err(|error| self.cause().named(error, &state.position))
    }

    fn differentiated(
        &self, state: &BodyState<F>, memory: &mut Workspace<F>,
        requested: Requested<WrenchDerivatives<F>, WrenchByPosition<F>>,
    ) -> Result<Wrench<F>, Error> {
        let with_warning = |found: Wrench<F>, memory: &Workspace<F>| {
            let warning = found.warning.worse(self.plausibility(memory.found()));
            Wrench { warning, ..found }
        };
        let mut requested = requested;
        let in_table = |table: TableSource<F>| {
            (table.solve)(table.bytes, (self.pair, self.law), state, memory, &mut requested)
        };
        if let Some(found) = self.of_table(in_table)? {
            return Ok(with_warning(found, memory));
        }
        let Requested { by_velocity, by_position } = requested;
        let Some(slopes) = by_position else {
            let found = self.wrench(state, memory, by_velocity)?;
            return Ok(with_warning(found, memory));
        };
        *slopes = WrenchByPosition::default();
        let is_straight = self.pair.rail_radius <= F::zero();
        if !is_straight {
            let step = F::of(if is_single::<F>() { 15e-6 } else { 1e-7 });
            for (k, column) in slopes.columns().into_iter().enumerate() {
                *column = differences(step, |step| {
                    let mut moved = *state;
                    let members = moved.position.members_mut();
                    members.into_iter().skip(k).take(1).for_each(|own| *own += step);
                    self.wrench(&moved, memory, None)
                })?;
            }
        }
        let found = self.wrench(state, memory, by_velocity)?;
        if is_straight && found.contacts > 0 {
            self.add_slopes_by_position(state, memory, &found, slopes)?;
            if memory.count as usize == KSTRIP_CONTACTS_CAPACITY {
                // The last contact's memory was needed.
                self.place(&state.position, memory)?;
            }
        }
        Ok(with_warning(found, memory))
    }

    /// Central differences with respect to the place of a roller's axis; zero for a straight rail.
    pub(crate) fn by_rail_ahead(
        &self, state: &BodyState<F>, memory: &mut Workspace<F>,
    ) -> Result<[F; 6], Error> {
        if self.pair.rail_radius <= F::zero() {
            return Ok([F::zero(); 6]);
        }
        differences(F::of(if is_single::<F>() { 1e-4 } else { 1e-5 }), |step| {
            let pair = WheelPair { rail_ahead: self.pair.rail_ahead + step, ..*self.pair };
            Scene { pair: &pair, ..*self }.wrench(state, memory, None)
        })
    }
}

impl<F: Float> Workspace<F> {
    /// An empty workspace: for a static, for a field, or for the heap, as in
    /// `Box::new(Workspace::new())`.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            gap: Gap::nothing(),
            strips: Patch::nothing(),
            contacts: [WheelContact::nothing(); KSTRIP_CONTACTS_CAPACITY],
            count: 0,
            reserved: 0,
        }
    }
}

impl<F: Float> Default for Workspace<F> {
    fn default() -> Self {
        Self::new()
    }
}

impl<F> Workspace<F> {
    /// The contacts.
    #[must_use]
    pub fn found(&self) -> &[WheelContact<F>] {
        self.contacts.get(..self.count as usize).unwrap_or(&[])
    }
}
