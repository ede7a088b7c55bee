//! From a table and a position to the contacts of a wheel, and to force and moment.
//!
//! 1. The numbers of the position at the places of the wheel are [blended](super::blend).
//! 2. From them follow the [strips](super::strips) on the wheel.
//! 3. **Contacts** are groups of zones of strips, as in the direct computation.
//! 4. The pressures are multiplied by one factor, so that they support what the heights tell.

use super::blend::{AtPlaces, Blend};
use super::block::ContactTable;
use super::strips::{OnWheel, add_places};
use crate::forces::Model;
use crate::number::Float;
use crate::patch::{KSTRIP_PATCH_CAPACITY, Patch};
use crate::status::{Error, Warning};
use crate::wheel_rail::contacts::WheelContact;
use crate::wheel_rail::contacts::groups::{Groups, Overlaps};
use crate::wheel_rail::forces::wrench::{self, Law, Wrench, WrenchByPosition, WrenchDerivatives};
use crate::wheel_rail::scene::{TableSource, Workspace};
use crate::wheel_rail::touch::line_of_contact::Wheel;
use crate::wheel_rail::{BodyState, Position, Requested, WheelPair};
use heapless::Vec;

/// Largest factor of the pressures.
const MOST_SCALED: f64 = 2.0;
/// Step of differences \[m, rad\], in double and in single precision.
const STEPS: [f64; 2] = [1e-8, 5e-6];

/// A wheel over a table.
#[derive(Clone, Copy)]
pub struct TableScene<'a, F> {
    /// The table.
    pub table: ContactTable<'a>,
    /// Friction, side, damping, speeds; radius and materials are those of the table.
    pub pair: &'a WheelPair<F>,
    /// The law of the creep forces.
    pub law: Law<'a, F>,
}

/// What the strips on a wheel have in common.
struct Blended<F> {
    zones: Overlaps<F>,
    /// Number of places from one end of an interval to the other.
    stride: usize,
    /// Depth \[m\], and the derivative of the support \[N/m\].
    indented: [F; 2],
    /// Vertical support \[N\].
    support: F,
    warning: Warning,
}

/// The contacts of a position.
struct Placed<F> {
    count: usize,
    /// Factor of the pressures.
    factor: F,
    /// Vertical support with a factor of one \[N\].
    support: F,
    warning: Warning,
}

impl<F: Float> Placed<F> {
    fn nothing() -> Self {
        let zero = F::zero();
        Self { count: 0, factor: zero, support: zero, warning: Warning::None }
    }
}

/// A finished table as the source of the contacts of a [`Scene`](crate::wheel_rail::scene::Scene).
/// `only`: whether a position outside the table is [`Error::TableRange`]; else its contacts are
/// computed.
#[must_use]
pub fn source<F: Float>(bytes: &[u8], only: bool) -> TableSource<'_, F> {
    TableSource {
        bytes,
        only,
        find: |bytes, pair, position, memory| {
            let law = Law { model: Model::Strip, falling: None };
            TableScene { table: ContactTable::new(bytes)?, pair, law }.place(position, memory)
        },
        solve: |bytes, (pair, law), state, memory, requested| {
            let Requested { by_velocity, by_position } = requested;
            let requested = Requested {
                by_velocity: by_velocity.as_deref_mut(),
                by_position: by_position.as_deref_mut(),
            };
            let scene = TableScene { table: ContactTable::new(bytes)?, pair, law };
            scene.differentiate(state, Some(memory), requested)
        },
    }
}

impl<F: Float> TableScene<'_, F> {
    /// Finds the contacts of a position.
    ///
    /// # Errors
    /// [`Error::TableRange`] outside the table; [`Error::TablePair`]; those of the pair and the
    /// position.
    pub fn place(
        &self, position: &Position<F>, memory: &mut Workspace<F>,
    ) -> Result<Warning, Error> {
        position.check()?;
        self.table.check_pair(self.pair)?;
        self.place_checked(position, false, memory)
    }

    /// Finds the strips at a position of a right wheel; none where nothing touches. The lists of
    /// the blend leave the stack with it.
    #[inline(never)]
    fn strips_at(
        &self, right: &Position<F>, is_beyond: bool, strips: &mut OnWheel<F>,
    ) -> Result<Option<Blended<F>>, Error> {
        let Self { table, pair, .. } = self;
        let (mut square, mut pressure, mut half_angle) =
            (AtPlaces::new(), AtPlaces::new(), AtPlaces::new());
        let mut blend = Blend::in_lists([&mut square, &mut pressure, &mut half_angle]);
        if !blend.find(table, right, is_beyond)? {
            return Ok(None);
        }
        let (mut stride, mut warning) = (1, Warning::None);
        let mut zones = blend.strips_on_wheel(table, (stride, pair.wheel_radius), strips);
        while strips.len() > KSTRIP_PATCH_CAPACITY {
            (stride, warning) = (2 * stride, Warning::Rough);
            zones = blend.strips_on_wheel(table, (stride, pair.wheel_radius), strips);
        }
        let Blend { depth, stiffness, support, .. } = blend;
        Ok(Some(Blended { zones, stride, indented: [depth, stiffness], support, warning }))
    }

    fn place_checked(
        &self, position: &Position<F>, is_beyond: bool, memory: &mut Workspace<F>,
    ) -> Result<Warning, Error> {
        (memory.count, memory.gap.count) = (0, 0);
        let Workspace { strips, contacts, count, .. } = memory;
        let placed = self.fill_contacts(position, is_beyond, (usize::MAX, strips), contacts)?;
        *count = placed.count as u32;
        let listed = contacts.iter_mut().take(placed.count);
        listed.for_each(|contact| contact.scale_pressure(placed.factor, placed.support));
        Ok(placed.warning)
    }

    /// Fills the contacts of a position up to a number, with pressures that do not support yet what
    /// the heights tell. Those for which the list is too short take its last place in turn.
    fn fill_contacts(
        &self, position: &Position<F>, is_beyond: bool, (up_to, strips): (usize, &mut Patch<F>),
        contacts: &mut [WheelContact<F>],
    ) -> Result<Placed<F>, Error> {
        let Self { table, pair, .. } = self;
        let right = position.mirrored(pair.left != 0);
        let mut own = OnWheel::new();
        let Some(blended) = self.strips_at(&right, is_beyond, &mut own)? else {
            return Ok(Placed::nothing());
        };
        let Blended { zones, stride, indented, support: wanted, mut warning } = blended;
        let wheel = Wheel::new(pair.wheel_radius, &right);
        let mut places = Vec::new();
        add_places(table, &wheel, &own, (stride, pair.rail_speed), &mut places);
        let mut groups = Groups::new();
        if !zones.group(&mut groups) {
            warning = Warning::Rough;
        }
        let (mut support, mut count) = (F::zero(), 0);
        let most = contacts.len().saturating_sub(1);
        for group in groups.iter() {
            let [first, last] = group.zones;
            let begin = own.partition_point(|strip| strip.zone < first);
            let end = own.partition_point(|strip| strip.zone <= last);
            let of_group = (own.get(begin..end)).zip(places.get(begin..end));
            let Some((inside, of_strips)) = of_group else { continue };
            let Some(first) = of_strips.first() else { continue };
            let Some(contact) = contacts.get_mut(count.min(most)) else { break };
            strips.clear(pair.shear_modulus, pair.poisson_ratio);
            for (strip, place) in inside.iter().zip(of_strips) {
                strips.push(strip.of_patch(place));
            }
            contact.fill(pair, &right, strips, indented, |k, _| *of_strips.get(k).unwrap_or(first));
            contact.share = group.share.clamped(F::zero(), F::one());
            let [_, _, vertical, ..] = contact.normal;
            support += contact.share * contact.normal_force * vertical;
            if contact.is_conformal() {
                warning = warning.worse(Warning::AngleRange);
            }
            count += 1;
            if count > up_to {
                break;
            }
        }
        if !(support > F::zero()) {
            return Ok(Placed::nothing());
        }
        let factor = (wanted / support).min(F::of(MOST_SCALED));
        Ok(Placed { count, factor, support, warning })
    }

    /// The wrench of the contacts of a position, which are found one after the other: memory for
    /// one is enough.
    #[inline(never)]
    fn wrench_in_turn(
        &self, state: &BodyState<F>, is_beyond: bool,
        mut by_velocity: Option<&mut WrenchDerivatives<F>>,
    ) -> Result<Wrench<F>, Error> {
        let (mut strips, mut contact) = (Patch::nothing(), WheelContact::nothing());
        let BodyState { position, velocity } = state;
        let nothing = by_velocity.as_deref_mut();
        let mut sum = wrench::of_contacts_in(&mut strips, &[], velocity, self.law, nothing)?;
        let fill = |up_to: usize, strips: &mut Patch<F>, contact: &mut WheelContact<F>| {
            let alone = core::slice::from_mut(contact);
            self.fill_contacts(position, is_beyond, (up_to, strips), alone)
        };
        let placed = fill(usize::MAX, &mut strips, &mut contact)?;
        for k in 0..placed.count {
            if placed.count > 1 {
                fill(k, &mut strips, &mut contact)?;
            }
            contact.scale_pressure(placed.factor, placed.support);
            let alone = core::slice::from_ref(&contact);
            let mut own = by_velocity.is_some().then(WrenchDerivatives::default);
            let slopes = own.as_mut();
            let found = wrench::of_contacts_in(&mut strips, alone, velocity, self.law, slopes)?;
            sum.add(&found);
            if let (Some(sums), Some(own)) = (&mut by_velocity, &own) {
                sums.add_other(own);
            }
        }
        sum.check(by_velocity.as_deref())?;
        sum.warning = sum.warning.worse(placed.warning);
        Ok(sum)
    }

    fn wrench_at(
        &self, state: &BodyState<F>, is_beyond: bool, memory: Option<&mut Workspace<F>>,
        by_velocity: Option<&mut WrenchDerivatives<F>>,
    ) -> Result<Wrench<F>, Error> {
        let Some(memory) = memory else {
            return self.wrench_in_turn(state, is_beyond, by_velocity);
        };
        let placed = self.place_checked(&state.position, is_beyond, memory)?;
        let Workspace { strips, contacts, count, .. } = memory;
        let found = contacts.get(..*count as usize).unwrap_or(&[]);
        let wrench = wrench::of_contacts_in(strips, found, &state.velocity, self.law, by_velocity)?;
        Ok(Wrench { warning: wrench.warning.worse(placed), ..wrench })
    }

    /// The wrench of a position and a velocity, with the derivatives that are requested. Those with
    /// respect to the position are differences of the interpolated wrench. Without memory the
    /// contacts are not listed.
    ///
    /// # Errors
    /// Those of [`TableScene::place`] and of
    /// [`of_contacts`](crate::wheel_rail::forces::wrench::of_contacts).
    pub fn differentiate(
        &self, state: &BodyState<F>, mut memory: Option<&mut Workspace<F>>,
        requested: Requested<WrenchDerivatives<F>, WrenchByPosition<F>>,
    ) -> Result<Wrench<F>, Error> {
        state.position.check()?;
        self.table.check_pair(self.pair)?;
        let Requested { by_velocity, by_position } = requested;
        let found = self.wrench_at(state, false, memory.as_deref_mut(), by_velocity)?;
        let Some(slopes) = by_position else { return Ok(found) };
        let [double, single] = STEPS.map(F::of);
        let step = if F::EPSILON > F::of(1e-10) { single } else { double };
        for (k, column) in slopes.columns().into_iter().enumerate() {
            let mut moved = *state;
            let members = moved.position.members_mut();
            members.into_iter().skip(k).take(1).for_each(|own| *own += step);
            *column = self.wrench_at(&moved, true, memory.as_deref_mut(), None)?.members();
            for (slope, own) in column.iter_mut().zip(found.members()) {
                *slope = (*slope - own) / step;
            }
        }
        if let Some(memory) = memory {
            self.place_checked(&state.position, false, memory)?;
        }
        Ok(found)
    }
}

impl<F: Float> WheelContact<F> {
    /// Multiplies the pressures by a factor. The stiffness is that of all contacts before, and each
    /// has a part of it by its share of their support.
    fn scale_pressure(&mut self, factor: F, support: F) {
        for strip in self.patch.used_mut() {
            strip.peak_pressure = strip.peak_pressure * factor;
        }
        let [_, _, vertical, ..] = self.normal;
        let part = self.normal_force / support;
        // upward by downward: N n_z by δ/n_z
        self.stiffness = self.stiffness * part / (vertical + F::TINY);
        self.approach = self.approach * vertical;
        self.normal_force = self.normal_force * factor;
    }
}
