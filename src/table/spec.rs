//! What a table spans, and how many nodes it has.

use super::block::Counts;
use crate::number::{Float, are_finite};
use crate::status::Error;
use crate::wheel_rail::profile::PreparedProfile;

/// Distance of the nodes of roll \[rad\].
const ROLL_NODES: f64 = 2.5e-3;

/// Width of a contact that has the number of strips of a table \[m\].
const STRIPS_WIDTH: f64 = 8e-3;

/// Ranges of a contact table, and how many nodes it has.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TableSpec<F> {
    /// Range of the lateral position without yaw and roll \[m\]. With them the range has the same
    /// places of contact, and is shifted by about roll times wheel_radius.
    pub lateral_from: F,
    /// End of this range \[m\].
    pub lateral_to: F,
    /// Largest yaw to both sides \[rad\], >= 0; 0: no yaw.
    pub yaw: F,
    /// Largest roll to both sides \[rad\], >= 0; 0: no roll.
    pub roll: F,
    /// Largest vertical support of the wheel \[N\], > 0.
    pub load: F,
    /// Lateral nodes, 9 to 256; 0: 99.
    pub lateral_nodes: u32,
    /// Levels of the load, 3 to 64; 0: 20.
    pub levels: u32,
    /// Nodes of yaw; 0: 3, without yaw 1.
    pub yaw_nodes: u32,
    /// Nodes of roll, an odd number; 0: one every 2.5 mrad or less, without roll 1.
    pub roll_nodes: u32,
    /// Number of strips in 8 mm of a contact, 12 to 32; 0: 16. It is that of the places on the
    /// wheel at which the table has numbers.
    pub strips: u32,
    /// Reserved: zero.
    pub reserved: u32,
}

impl<F: Float> TableSpec<F> {
    /// How many nodes there are.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::TableSpec`], [`Error::Capacity`], [`Error::NotPrepared`].
    pub(super) fn counts(&self, wheel: &PreparedProfile<F>) -> Result<Counts, Error> {
        let Self { lateral_from, lateral_to, yaw, roll, load, .. } = *self;
        wheel.check()?;
        Error::NotFinite.unless(are_finite(&[lateral_from, lateral_to, yaw, roll, load]))?;
        let (zero, one) = (F::zero(), F::one());
        let in_range = yaw >= zero && yaw < one && roll >= zero && roll < one;
        Error::TableSpec.unless(in_range && lateral_to > lateral_from && load > zero)?;
        let or = |count: u32, default: u32| if count == 0 { default } else { count };
        let rolls = 1 + 2 * ((roll.times(1.0 / ROLL_NODES).whole() as u32) + 1);
        let rolls = or(self.roll_nodes, if roll > zero { rolls } else { 1 });
        let yaws = or(self.yaw_nodes, if yaw > zero { 3 } else { 1 });
        let [yaws, rolls] =
            [(yaw, yaws), (roll, rolls)].map(|(range, nodes)| if range > zero { nodes } else { 1 });
        let lateral = or(self.lateral_nodes, 99);
        Error::TableSpec.unless(rolls % 2 == 1 && lateral >= 9)?;
        Error::TableSpec.when((yaw > zero && yaws < 2) || (roll > zero && rolls < 3))?;
        let length = wheel.step * F::widened(wheel.count.saturating_sub(1) as f32);
        let places = ((length / self.place_spacing()?).whole() as u32).saturating_add(1);
        Counts::checked([lateral, or(self.levels, 20), yaws, rolls, places])
    }

    /// How far apart the places on the wheel are \[m\].
    ///
    /// # Errors
    /// [`Error::TableSpec`]
    pub(super) fn place_spacing(&self) -> Result<F, Error> {
        let strips = if self.strips == 0 { 16 } else { self.strips };
        Error::TableSpec.unless((12..=32).contains(&strips))?;
        Ok(F::constant(STRIPS_WIDTH) / F::widened(strips as f32))
    }

    /// Bytes that a block must have to be filled, and number of its parts.
    ///
    /// # Errors
    /// Those of the ranges and counts; [`Error::Capacity`] for more than 4 GB.
    pub fn size(&self, wheel: &PreparedProfile<F>) -> Result<[u32; 2], Error> {
        let counts = self.counts(wheel)?;
        Ok([counts.most_bytes()? as u32, counts.all_parts() as u32])
    }
}
