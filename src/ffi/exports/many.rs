//! Many wheels and many wheelsets in one call, for sweeps and tables.

use super::scene::{WheelOutputs, scene_of, state_of, with_table};
use super::{F, kstrip_height_for_load, kstrip_wheelset_on_track, kstrip_wheelset_settle};
use crate::ffi::support::{Strided, each_element, element, given, status_of};
use crate::ffi::types::{Track, WheelsetParts, kstrip_table};
use crate::friction::SlipFriction;
use crate::patch::PatchStrip;
use crate::status::{Error, kstrip_status};
use crate::wheel_rail::contacts::WheelContact;
use crate::wheel_rail::forces::wrench::{Wrench, WrenchByPosition, WrenchDerivatives};
use crate::wheel_rail::profile::PreparedProfile;
use crate::wheel_rail::scene::Workspace;
use crate::wheel_rail::{KSTRIP_CONTACTS_CAPACITY, Position, Velocity, WheelPair};
use crate::wheelset::forces::{
    WheelsetByPosition, WheelsetDerivatives, WheelsetForces, WheelsetWorkspace,
};
use crate::wheelset::settle::WheelsetLoads;

/// kstrip_wheel_on_rail() for many wheels with the same profiles: the same results, bit for bit.
/// Several threads may each compute a part, with a workspace of their own.
///
/// Pairs, positions, velocities and friction are arrays, in which the next element is a stride
/// away; with a stride of 0 all wheels have the same one. A wheel without a result does not stop
/// the others; its status has the reason, and its other outputs are untouched.
///
/// @param rail, wheel, workspace  as in kstrip_wheel_on_rail(), one for all wheels.
/// @param count           number of wheels; 0 is allowed.
/// @param pairs, pair_stride  kstrip_wheel_pair of each, and the distance from one to the next
///                            [bytes]: 0 or another multiple of the alignment. The other strides
///                            have the same rule.
/// @param positions, position_stride  position of each wheel, and its stride [bytes].
/// @param velocities, velocity_stride  velocity of each wheel, and its stride [bytes].
/// @param friction, friction_stride  as in kstrip_wheel_on_rail(), with its stride [bytes]; NULL:
///                            constant.
/// @param table           a contact table of all pairs, whose results are those of
///                        kstrip_wheel_on_table(); NULL: contacts are computed.
/// @param[out] wrenches   array of count elements; receives force and moment, and with them the
///                        number of contacts.
/// @param[out] derivatives, by_position  arrays of count elements, as in kstrip_wheel_on_rail();
///                        NULL: not needed.
/// @param[out] contacts   array of count times room elements; receives the first room contacts of
///                        each wheel, their unused strips zero; NULL: not needed. A wheel of fewer
///                        contacts leaves the rest untouched. Those of wheel i begin at i room.
/// @param room            contacts of each wheel for which there is room, at most
///                        KSTRIP_CONTACTS_CAPACITY.
/// @param[out] statuses   array of count elements; receives those of kstrip_wheel_on_rail();
///                        NULL: not needed.
/// @return as kstrip_wheel_on_rail(), with a table as kstrip_wheel_on_table() too: the first error
///         of a wheel, or the most serious warning; before any wheel KSTRIP_ERROR_NULL (a required
///         array), KSTRIP_ERROR_STRIDE (no multiple of the alignment), KSTRIP_ERROR_CAPACITY (room
///         is above KSTRIP_CONTACTS_CAPACITY).
#[unsafe(export_name = symbol!("kstrip_wheels_on_rails"))]
pub unsafe extern "C" fn kstrip_wheels_on_rails(
    rail: Option<&PreparedProfile<F>>, wheel: Option<&PreparedProfile<F>>, count: u32,
    pairs: *const WheelPair<F>, pair_stride: u32, positions: *const Position<F>,
    position_stride: u32, velocities: *const Velocity<F>, velocity_stride: u32,
    friction: *const SlipFriction<F>, friction_stride: u32, table: Option<&kstrip_table>,
    workspace: Option<&mut Workspace<F>>, wrenches: *mut Wrench<F>,
    derivatives: *mut WrenchDerivatives<F>, by_position: *mut WrenchByPosition<F>,
    contacts: *mut WheelContact<F>, room: u32, statuses: *mut kstrip_status,
) -> kstrip_status {
    status_of(|| {
        let (rail, wheel, memory) = (given(rail)?, given(wheel)?, given(workspace)?);
        let pairs = Strided::required(pairs, pair_stride, count)?;
        let positions = Strided::required(positions, position_stride, count)?;
        let velocities = Strided::required(velocities, velocity_stride, count)?;
        let friction = Strided::new(friction, friction_stride, count)?;
        Error::NullPointer.unless(count == 0 || !wrenches.is_null())?;
        let room = room as usize;
        Error::Capacity.unless(contacts.is_null() || room <= KSTRIP_CONTACTS_CAPACITY)?;
        // SAFETY: arrays are NULL or valid for count elements at their distances, says the header.
        unsafe {
            each_element(count, statuses, |i| {
                let (pair, law) = (pairs.at(i), friction.at(i));
                let outputs = WheelOutputs {
                    wrench: element(wrenches, i),
                    derivatives: element(derivatives, i),
                    by_position: element(by_position, i),
                };
                let status = status_of(|| {
                    let scene = scene_of(Some(rail), Some(wheel), pair.as_ref(), law.as_ref())?;
                    let scene = with_table(scene, table)?;
                    let state = state_of(positions.at(i).as_ref(), velocities.at(i).as_ref())?;
                    outputs.write(|requested| scene.differentiate(&state, memory, requested))
                });
                if status >= 0 && !contacts.is_null() {
                    let first = contacts.wrapping_add(i.wrapping_mul(room));
                    let found = memory.contacts.iter_mut().take(room.min(memory.count as usize));
                    for (k, contact) in found.enumerate() {
                        clear_unused(contact);
                        first.wrapping_add(k).copy_from_nonoverlapping(contact, 1);
                    }
                }
                status
            })
        }
    })
}

/// Strips that a contact does not use become zero.
fn clear_unused(contact: &mut WheelContact<F>) {
    let WheelContact { patch, strip_rail_speed, strip_y, strip_z, strip_angle, strip_lean, .. } =
        contact;
    let used = patch.count as usize;
    patch.strips.iter_mut().skip(used).for_each(|strip| *strip = PatchStrip::default());
    for list in [strip_rail_speed, strip_y, strip_z, strip_angle, strip_lean] {
        list.iter_mut().skip(used).for_each(|place| *place = 0.0);
    }
}

/// kstrip_height_for_load() for many wheels with the same profiles: the same results, bit for bit.
///
/// @param rail, wheel, count, workspace  as in kstrip_wheels_on_rails().
/// @param pairs, pair_stride  kstrip_wheel_pair of each, and its stride [bytes].
/// @param positions, position_stride  position of each wheel, and its stride [bytes]; each search
///                        begins at the vertical member of its position.
/// @param supports, support_stride  requested upward force of the rail on each wheel [N], > 0, and
///                        its stride [bytes].
/// @param velocities, velocity_stride  velocity of each wheel, and its stride [bytes]; NULL: the
///                        pressure carries the load.
/// @param friction, friction_stride  as in kstrip_wheel_on_rail(), with its stride [bytes]; NULL:
///                        constant.
/// @param table           a contact table of all pairs; NULL: contacts are computed.
/// @param[out] verticals  array of count elements; receives the vertical positions [m].
/// @param[out] statuses   array of count elements; receives those of kstrip_height_for_load();
///                        NULL: not needed.
/// @return as kstrip_height_for_load(): the first error of a wheel, or the most serious warning;
///         before any wheel KSTRIP_ERROR_NULL (a required array), KSTRIP_ERROR_STRIDE (no multiple
///         of the alignment).
#[unsafe(export_name = symbol!("kstrip_heights_for_loads"))]
pub unsafe extern "C" fn kstrip_heights_for_loads(
    rail: Option<&PreparedProfile<F>>, wheel: Option<&PreparedProfile<F>>, count: u32,
    pairs: *const WheelPair<F>, pair_stride: u32, positions: *const Position<F>,
    position_stride: u32, supports: *const F, support_stride: u32, velocities: *const Velocity<F>,
    velocity_stride: u32, friction: *const SlipFriction<F>, friction_stride: u32,
    table: Option<&kstrip_table>, workspace: Option<&mut Workspace<F>>, verticals: *mut F,
    statuses: *mut kstrip_status,
) -> kstrip_status {
    status_of(|| {
        let (rail, wheel, memory) = (given(rail)?, given(wheel)?, given(workspace)?);
        let pairs = Strided::required(pairs, pair_stride, count)?;
        let positions = Strided::required(positions, position_stride, count)?;
        let supports = Strided::required(supports, support_stride, count)?;
        let velocities = Strided::new(velocities, velocity_stride, count)?;
        let friction = Strided::new(friction, friction_stride, count)?;
        Error::NullPointer.unless(count == 0 || !verticals.is_null())?;
        // SAFETY: arrays are NULL or valid for count elements at their distances, says the header.
        unsafe {
            each_element(count, statuses, |i| {
                kstrip_height_for_load(
                    Some(rail),
                    Some(wheel),
                    pairs.at(i).as_ref(),
                    positions.at(i).as_ref(),
                    supports.at(i).unwrap_or(0.0),
                    velocities.at(i).as_ref(),
                    friction.at(i).as_ref(),
                    table,
                    Some(memory),
                    element(verticals, i),
                )
            })
        }
    })
}

/// kstrip_wheelset_on_track() for many positions and velocities: the same results, bit for bit.
///
/// @param set, track, workspace  as in kstrip_wheelset_on_track().
/// @param count           number of positions; 0 is allowed.
/// @param positions, position_stride  positions of the wheelset, and the distance from one to the
///                        next [bytes], as in kstrip_wheels_on_rails().
/// @param velocities, velocity_stride  velocities of the wheelset, and their stride [bytes].
/// @param[out] forces     array of count elements; receives the forces.
/// @param[out] derivatives, by_position  arrays of count elements; NULL: not needed.
/// @param[out] statuses   array of count elements; receives those of kstrip_wheelset_on_track();
///                        NULL: not needed.
/// @return as kstrip_wheelset_on_track(): the first error of an element, or the most serious
///         warning; before any element KSTRIP_ERROR_NULL (a required array), KSTRIP_ERROR_STRIDE
///         (no multiple of the alignment).
#[unsafe(export_name = symbol!("kstrip_wheelsets_on_track"))]
pub unsafe extern "C" fn kstrip_wheelsets_on_track(
    set: Option<&WheelsetParts<F>>, track: Option<&Track<F>>, count: u32,
    positions: *const Position<F>, position_stride: u32, velocities: *const Velocity<F>,
    velocity_stride: u32, workspace: Option<&mut WheelsetWorkspace<F>>,
    forces: *mut WheelsetForces<F>, derivatives: *mut WheelsetDerivatives<F>,
    by_position: *mut WheelsetByPosition<F>, statuses: *mut kstrip_status,
) -> kstrip_status {
    status_of(|| {
        let (set, track, memory) = (given(set)?, given(track)?, given(workspace)?);
        let positions = Strided::required(positions, position_stride, count)?;
        let velocities = Strided::required(velocities, velocity_stride, count)?;
        Error::NullPointer.unless(count == 0 || !forces.is_null())?;
        // SAFETY: arrays are NULL or valid for count elements at their distances, and the pointers
        // in the structures are NULL or valid, says the header.
        unsafe {
            each_element(count, statuses, |i| {
                kstrip_wheelset_on_track(
                    Some(set),
                    Some(track),
                    positions.at(i).as_ref(),
                    velocities.at(i).as_ref(),
                    Some(memory),
                    element(forces, i),
                    element(derivatives, i),
                    element(by_position, i),
                )
            })
        }
    })
}

/// kstrip_wheelset_settle() for many starts, velocities and loads: the same results, bit for bit.
///
/// @param set, track, count, workspace  as in kstrip_wheelsets_on_track().
/// @param starts, start_stride  as in kstrip_wheelset_settle(), and the distance from one to the
///                        next [bytes], as in kstrip_wheels_on_rails().
/// @param velocities, velocity_stride  as in kstrip_wheelset_settle(), with their stride [bytes].
/// @param loads, load_stride  as in kstrip_wheelset_settle(), with their stride [bytes].
/// @param[out] positions, moves  arrays of count elements.
/// @param[out] forces     array of count elements; NULL: not needed.
/// @param[out] statuses   array of count elements; receives those of kstrip_wheelset_settle();
///                        NULL: not needed.
/// @return as kstrip_wheelset_settle(), and before any element as kstrip_wheelsets_on_track().
#[unsafe(export_name = symbol!("kstrip_wheelsets_settle"))]
pub unsafe extern "C" fn kstrip_wheelsets_settle(
    set: Option<&WheelsetParts<F>>, track: Option<&Track<F>>, count: u32,
    starts: *const Position<F>, start_stride: u32, velocities: *const Velocity<F>,
    velocity_stride: u32, loads: *const WheelsetLoads<F>, load_stride: u32,
    workspace: Option<&mut WheelsetWorkspace<F>>, positions: *mut Position<F>,
    moves: *mut Velocity<F>, forces: *mut WheelsetForces<F>, statuses: *mut kstrip_status,
) -> kstrip_status {
    status_of(|| {
        let (set, track, memory) = (given(set)?, given(track)?, given(workspace)?);
        let starts = Strided::required(starts, start_stride, count)?;
        let velocities = Strided::required(velocities, velocity_stride, count)?;
        let loads = Strided::required(loads, load_stride, count)?;
        let outputs = !(positions.is_null() || moves.is_null());
        Error::NullPointer.unless(count == 0 || outputs)?;
        // SAFETY: arrays are NULL or valid for count elements at their distances, and the pointers
        // in the structures are NULL or valid, says the header.
        unsafe {
            each_element(count, statuses, |i| {
                kstrip_wheelset_settle(
                    Some(set),
                    Some(track),
                    starts.at(i).as_ref(),
                    velocities.at(i).as_ref(),
                    loads.at(i).as_ref(),
                    Some(memory),
                    element(positions, i),
                    element(moves, i),
                    element(forces, i),
                )
            })
        }
    })
}
