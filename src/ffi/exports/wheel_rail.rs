//! Wheel on rail: from two profiles and a position to the forces on the wheel.

use super::F;
use super::scene::{WheelOutputs, law_of, scene_of, state_of, with_table};
use crate::ffi::support::{given, input, output, put, status_of, strip_count, write_result};
use crate::ffi::types::kstrip_table;
use crate::friction::SlipFriction;
use crate::motion::Motion;
use crate::number::Float;
use crate::patch::{KSTRIP_PATCH_CAPACITY, Patch};
use crate::status::{Error, Warning, kstrip_status};
use crate::wheel_rail::contacts::{self, WheelContact};
use crate::wheel_rail::forces::across::{self, StripPower};
use crate::wheel_rail::forces::wrench::{self, Wrench, WrenchByPosition, WrenchDerivatives};
use crate::wheel_rail::profile::PreparedProfile;
use crate::wheel_rail::profile::plausibility::Cause;
use crate::wheel_rail::scene::Workspace;
use crate::wheel_rail::touch::{Gap, GapSearch};
use crate::wheel_rail::{KSTRIP_CONTACTS_CAPACITY, Position, Velocity, WheelPair};
use core::mem::MaybeUninit;

/// Prepares a profile of a rail or a wheel from its points. Do this once for each profile.
///
/// The points are in their order along the profile. They may run either way along y, turn back (as
/// those of a measured flange do), lie at any distances, coincide, be scanned twice and scatter:
/// parts of the profile that are scanned again, single points in the wrong order, and points nearer
/// to each other than their scatter are averaged. Single strays, one of 128 points, are left out.
/// The flange of a wheel and the gauge side of a rail are at small y (profiles of a right wheel),
/// and z points down. The prepared points are one step apart.
///
/// @param y, z, points    the points [m], at least 4. Those of a rail are measured from its origin,
///                        those of a wheel from its running circle; the z of a wheel is its radius
///                        minus wheel_radius.
/// @param step            length between prepared points [m]; 0: the length of the profile divided
///                        by the capacity less one.
/// @param smoothing_length  each point is replaced by that of a parabola fitted to the points up to
///                        this distance [m], >= 0: at least four point spacings, 2 to 4 mm for
///                        measured profiles; below two spacings it has no effect. 0: a profile of
///                        many points, or of smooth ones as in drawings, goes through all of them,
///                        and one of fewer, rough points is smoothed over at most six spacings.
/// @param[out] surface    receives the profile.
/// @return usual statuses, KSTRIP_ERROR_OVERFLOW if the profile is smaller than 1 um or a
///         coordinate is above 1 km; KSTRIP_WARNING_ORIENTATION (the shape stands upside down or
///         the wrong way round); KSTRIP_WARNING_PROFILE_SIZE (longer than 1 m);
///         KSTRIP_ERROR_PROFILE (fewer than four points, or step < 0);
///         KSTRIP_ERROR_SMOOTHING_LENGTH (smoothing_length < 0); KSTRIP_ERROR_CAPACITY (the step
///         needs too many points); KSTRIP_ERROR_SCATTER (no line follows the points).
#[unsafe(export_name = symbol!("kstrip_prepare_profile"))]
pub unsafe extern "C" fn kstrip_prepare_profile(
    y: *const F, z: *const F, points: u32, step: F, smoothing_length: F,
    surface: Option<&mut PreparedProfile<F>>,
) -> kstrip_status {
    // SAFETY: NULL or as many elements as points says, says the header.
    let (y, z) = unsafe { (input(y, points), input(z, points)) };
    status_of(|| given(surface)?.prepare(y?, z?, step, smoothing_length))
}

/// The gap between a wheel and a straight rail: the line on the wheel along which its normal is
/// perpendicular to x, and its distance from the rail.
///
/// @param rail, wheel     prepared profiles.
/// @param wheel_radius    radius of the wheel at z = 0 of its profile [m], > 0.
/// @param position        where the right wheel is. For a left wheel pass lateral, yaw and roll
///                        with the opposite signs.
/// @param reach           distance from the rail above which points are left out [m]; 0: 2 mm.
///                        For kstrip_contacts_from_gap() it must be at least 3 d + min(1 mm,
///                        sqrt(s^2 + 6.25 d^2)/2), or 2 mm if that is less, with the step d of the
///                        wheel and smoothing_length s: nearer points enter the smoothing.
/// @param[out] gap        receives the points.
/// @param[out] least      receives their least distance [m]: negative where the surfaces overlap,
///                        and reach where no point is nearer; NULL: not needed.
/// @return usual statuses; statuses of kstrip_wheel_position; KSTRIP_ERROR_NOT_PREPARED (rail or
///         wheel); KSTRIP_ERROR_ROLLING_RADIUS (wheel_radius <= 0); KSTRIP_ERROR_PROFILE_END (the
///         wheel is beside the rail) or its likely cause: KSTRIP_ERROR_ANGLE (yaw or roll is above
///         0.2 in size), KSTRIP_ERROR_LENGTH_UNIT (the wheel is 0.7 m beside the rail, or 5 m above
///         or below it; wheel_radius is above 5 m, or a profile is longer than 1 m),
///         KSTRIP_ERROR_SWAPPED (rail has a flange, and wheel the head of a rail),
///         KSTRIP_ERROR_ORIENTATION (a profile is not that of a rail or a wheel).
#[unsafe(export_name = symbol!("kstrip_touch"))]
pub extern "C" fn kstrip_touch(
    rail: Option<&PreparedProfile<F>>, wheel: Option<&PreparedProfile<F>>, wheel_radius: F,
    position: Option<&Position<F>>, reach: F, gap: Option<&mut Gap<F>>,
    least: Option<&mut MaybeUninit<F>>,
) -> kstrip_status {
    status_of(|| {
        let (rail, wheel, position) = (given(rail)?, given(wheel)?, given(position)?);
        let gap = given(gap)?;
        let search = GapSearch::new(rail, wheel, wheel_radius, position)?;
        let found = search.gap(reach, gap);
        let cause = Cause { rail, wheel, wheel_radius, shear_modulus: None };
        put(least, found.map_err(|error| cause.named(error, position))?);
        Ok(Warning::None)
    })
}

/// The contacts of a gap, in ascending y of a right wheel.
///
/// Overlaps less than 5 mm apart are one contact and one normal problem; overlaps more than 7 mm
/// apart are separate contacts. Between these distances the result blends the separate contacts
/// with the merged one; share has the weights. Of more than four contacts the nearest are merged,
/// with KSTRIP_WARNING_ROUGH.
///
/// @param gap             the gap between the surfaces, from kstrip_touch() or a host's own search.
/// @param pair            materials, friction, side.
/// @param position        where the wheel is.
/// @param workspace       memory for the strips of a contact; it may hold anything.
/// @param[out] contacts   array of KSTRIP_CONTACTS_CAPACITY elements; receives the contacts. It is
///                        memory of the computation too: after an error it may have changed.
/// @param[out] count      receives their number; 0: the wheel is lifted.
/// @return usual statuses; statuses of kstrip_gap, kstrip_wheel_pair and kstrip_wheel_position;
///         KSTRIP_WARNING_ANGLE_RANGE (the normal turns by more than 30 degrees over a contact);
///         KSTRIP_WARNING_ROUGH (also a contact with more local minima than its strips resolve);
///         KSTRIP_ERROR_PROFILE_END (a contact reaches an end of the gap); KSTRIP_ERROR_PATCH_SIZE
///         (more contacts than fit).
#[unsafe(export_name = symbol!("kstrip_contacts_from_gap"))]
pub unsafe extern "C" fn kstrip_contacts_from_gap(
    gap: Option<&Gap<F>>, pair: Option<&WheelPair<F>>, position: Option<&Position<F>>,
    workspace: Option<&mut Patch<F>>, contacts: *mut WheelContact<F>,
    count: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    // SAFETY: NULL or KSTRIP_CONTACTS_CAPACITY elements, says the header.
    let contacts =
        unsafe { contacts.cast::<[WheelContact<F>; KSTRIP_CONTACTS_CAPACITY]>().as_mut() };
    status_of(|| {
        let (gap, pair, position, whole) =
            (given(gap)?, given(pair)?, given(position)?, given(workspace)?);
        let (contacts, count) = (given(contacts)?, given(count)?);
        let strips = strip_count(pair.strips)?;
        let found = contacts::from_gap(gap, pair, position, strips, whole, contacts)?;
        count.write(found.written as u32);
        Ok(found.warning)
    })
}

/// Motion of the wheel relative to the rail at a contact: slip, spin rate and rolling speed. They
/// are the input of kstrip_solve_motion(). Slip and spin rate divided by the rolling speed are the
/// creepages of kstrip_patch_evaluate(). The motion is linear in the velocity.
///
/// @param contact         a contact.
/// @param velocity        how the wheel moves.
/// @param[out] motion     receives the motion, that of a roller included.
/// @return usual statuses.
#[unsafe(export_name = symbol!("kstrip_wheel_motion"))]
pub extern "C" fn kstrip_wheel_motion(
    contact: Option<&WheelContact<F>>, velocity: Option<&Velocity<F>>,
    motion: Option<&mut MaybeUninit<Motion<F>>>,
) -> kstrip_status {
    write_result(motion, || given(contact)?.checked_motion(given(velocity)?))
}

/// Force and moment on the wheel from its contacts. The contacts may come from
/// kstrip_contacts_from_gap() or from a table.
///
/// The wheel may roll forward or backward, or stand still, as in kstrip_solve_motion(): forces are
/// continuous through rest. They are continuous where damping reduces the pressure to zero, and
/// have a kink there.
///
/// @param contacts, count  the contacts, at most KSTRIP_CONTACTS_CAPACITY; a wheel without contacts
///                         is lifted, and its forces are zero.
/// @param velocity        how the wheel moves.
/// @param model           KSTRIP_MODEL_STRIP (the default here), KSTRIP_MODEL_TOTAL or one of the
///                        models of 1967.
/// @param friction        falling friction (not its friction and rolling_speed); NULL: constant.
/// @param[out] wrench     receives force and moment.
/// @param[out] derivatives  receives their derivatives with respect to velocity and friction; NULL:
///                          not needed.
/// @return usual statuses; statuses of kstrip_wheel_contact and kstrip_friction; warnings of
///         kstrip_options; KSTRIP_WARNING_DAMPING (it more than doubles the pressure);
///         KSTRIP_WARNING_SEVERAL_FRICTIONS and KSTRIP_WARNING_NOT_CONVERGED, as in
///         kstrip_evaluate(); KSTRIP_ERROR_PATCH_SIZE (too many contacts or strips);
///         KSTRIP_ERROR_MODEL (model is another number); KSTRIP_ERROR_NOT_IN_MODEL
///         (KSTRIP_MODEL_LINEAR); KSTRIP_ERROR_MODEL_LEFT_OUT (this build has no such model).
#[unsafe(export_name = symbol!("kstrip_wrench_from_contacts"))]
pub unsafe extern "C" fn kstrip_wrench_from_contacts(
    contacts: *const WheelContact<F>, count: u32, velocity: Option<&Velocity<F>>, model: i32,
    friction: Option<&SlipFriction<F>>, wrench: Option<&mut MaybeUninit<Wrench<F>>>,
    derivatives: Option<&mut MaybeUninit<WrenchDerivatives<F>>>,
) -> kstrip_status {
    // SAFETY: NULL or count elements, says the header.
    let contacts = unsafe { input(contacts, count) };
    status_of(|| {
        let (contacts, velocity, out) = (contacts?, given(velocity)?, given(wrench)?);
        Error::PatchSize.unless(contacts.len() <= KSTRIP_CONTACTS_CAPACITY)?;
        let law = law_of(model, friction)?;
        let mut slopes = WrenchDerivatives::default();
        let wanted = derivatives.is_some().then_some(&mut slopes);
        let found = wrench::of_contacts(contacts, velocity, law, wanted)?;
        put(derivatives, slopes);
        out.write(found);
        Ok(found.warning)
    })
}

/// Load, sliding velocity and frictional power of each strip of a contact, to compute wear.
///
/// Add the strips of all contacts at their wheel_y; y on the rail is that of the position plus
/// strip_y of the contact. The powers add up to the dissipation of kstrip_wrench_from_contacts()
/// with the model KSTRIP_MODEL_STRIP, and the loads to its normal_force.
///
/// @param contact         a contact.
/// @param velocity        how the wheel moves.
/// @param model, friction  as in kstrip_wrench_from_contacts(). KSTRIP_MODEL_TOTAL has no strips:
///                        KSTRIP_MODEL_STRIP takes its place.
/// @param[out] strips     array of capacity elements, at least contact->patch.count, for which
///                        KSTRIP_PATCH_CAPACITY is always enough.
/// @param capacity        size of strips.
/// @param[out] count      receives the number of strips.
/// @return as kstrip_wrench_from_contacts(); KSTRIP_ERROR_CAPACITY (capacity is below
///         contact->patch.count).
#[unsafe(export_name = symbol!("kstrip_contact_power_across"))]
pub unsafe extern "C" fn kstrip_contact_power_across(
    contact: Option<&WheelContact<F>>, velocity: Option<&Velocity<F>>, model: i32,
    friction: Option<&SlipFriction<F>>, strips: *mut StripPower<F>, capacity: u32,
    count: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    status_of(|| {
        let (contact, velocity, count) = (given(contact)?, given(velocity)?, given(count)?);
        // SAFETY: NULL or valid for capacity elements, says the header.
        let places = unsafe { output(strips, capacity)? };
        let law = law_of(model, friction)?;
        let most = contact.patch.count as usize;
        Error::PatchSize.unless(most <= KSTRIP_PATCH_CAPACITY)?;
        Error::Capacity.unless(most <= places.len())?;
        let mut places = places.iter_mut();
        let warning = across::power_across(contact, velocity, law, &mut |strip| {
            if let Some(place) = places.next() {
                place.write(strip);
            }
        })?;
        count.write(contact.patch.count);
        Ok(warning)
    })
}

/// Force and moment on a wheel on a rail in one call: kstrip_touch(), kstrip_contacts_from_gap(),
/// kstrip_wrench_from_contacts().
///
/// In a curve, pass the velocity relative to the momentary track, which is at rest; on a roller
/// that of the wheel's centre in the axes of the rig. Force and moment are continuous in position
/// and velocity, but where normals of a rail cross below the wheel: on a rough rail, and where the
/// bodies overlap by more than 3 mm on a flange. A contact appears and vanishes with zero load, and
/// two become one between 7 and 5 mm. Forces may also jump with KSTRIP_WARNING_ROUGH. The time is
/// bounded.
///
/// @param rail, wheel     prepared profiles.
/// @param pair            materials, friction, side, number of strips, model.
/// @param position        where the wheel is.
/// @param velocity        how it moves.
/// @param friction        falling friction (not its friction and rolling_speed); NULL: constant.
/// @param workspace       memory that may hold anything; receives gap and contacts.
/// @param[out] wrench     receives force and moment.
/// @param[out] derivatives  receives their exact derivatives with respect to velocity and friction;
///                          NULL: not needed.
/// @param[out] by_position  receives their derivatives with respect to position: exact but for one
///                        difference of creep forces, one-sided at kinks; for a roller central
///                        differences. NULL: not needed.
/// @return as kstrip_touch(), kstrip_contacts_from_gap() and kstrip_wrench_from_contacts().
///         KSTRIP_ERROR_MODULUS_UNIT is a likely cause too (shear_modulus below 0.1 MPa). Warnings
///         about implausible inputs: KSTRIP_WARNING_ORIENTATION (a profile is not that of a rail or
///         a wheel, or a contact is above 30 degrees), KSTRIP_WARNING_PROFILE_SIZE (a profile is
///         longer than 1 m), KSTRIP_WARNING_RADIUS (wheel_radius is above 5 m),
///         KSTRIP_WARNING_MODULUS (below 0.1 MPa or above 10 TPa), KSTRIP_WARNING_YOUNG (above 150
///         GPa), KSTRIP_WARNING_FRICTION (above 5), KSTRIP_WARNING_UNSET (friction and
///         poisson_ratio are 0), KSTRIP_WARNING_PRESSURE (above a tenth of shear_modulus).
///         KSTRIP_WARNING_PROFILE_COARSE: a contact is narrower than four point spacings.
#[unsafe(export_name = symbol!("kstrip_wheel_on_rail"))]
pub extern "C" fn kstrip_wheel_on_rail(
    rail: Option<&PreparedProfile<F>>, wheel: Option<&PreparedProfile<F>>,
    pair: Option<&WheelPair<F>>, position: Option<&Position<F>>, velocity: Option<&Velocity<F>>,
    friction: Option<&SlipFriction<F>>, workspace: Option<&mut Workspace<F>>,
    wrench: Option<&mut MaybeUninit<Wrench<F>>>,
    derivatives: Option<&mut MaybeUninit<WrenchDerivatives<F>>>,
    by_position: Option<&mut MaybeUninit<WrenchByPosition<F>>>,
) -> kstrip_status {
    status_of(|| {
        let scene = scene_of(rail, wheel, pair, friction)?;
        let (state, memory) = (state_of(position, velocity)?, given(workspace)?);
        WheelOutputs { wrench, derivatives, by_position }
            .write(|requested| scene.differentiate(&state, memory, requested))
    })
}

/// The vertical position at which the rail supports a wheel with a given force, to rounding. Use it
/// to begin a run, and for tables. Of several positions it is the highest.
///
/// @param rail, wheel, pair  as in kstrip_wheel_on_rail().
/// @param position        where the wheel is; its vertical member is where the search begins.
/// @param support         requested upward force of the rail on the wheel [N], > 0.
/// @param velocity        how the wheel moves; its creep forces carry a part of the load. NULL: the
///                        pressure carries all of it.
/// @param friction        as in kstrip_wheel_on_rail(); NULL: constant.
/// @param table           a contact table of the pair; NULL: contacts are computed.
/// @param workspace       memory that may hold anything; receives gap and contacts.
/// @param[out] vertical   receives the vertical position [m].
/// @return as kstrip_wheel_on_rail(); KSTRIP_WARNING_NOT_CONVERGED (no height carries the load to
///         rounding); KSTRIP_WARNING_SUPPORT (no ordinary contact supports the wheel at this
///         height); KSTRIP_ERROR_SUPPORT (support <= 0); with a table those of
///         kstrip_wheel_on_table().
#[unsafe(export_name = symbol!("kstrip_height_for_load"))]
pub unsafe extern "C" fn kstrip_height_for_load(
    rail: Option<&PreparedProfile<F>>, wheel: Option<&PreparedProfile<F>>,
    pair: Option<&WheelPair<F>>, position: Option<&Position<F>>, support: F,
    velocity: Option<&Velocity<F>>, friction: Option<&SlipFriction<F>>,
    table: Option<&kstrip_table>, workspace: Option<&mut Workspace<F>>,
    vertical: Option<&mut MaybeUninit<F>>,
) -> kstrip_status {
    status_of(|| {
        // SAFETY: the table is NULL or has as many bytes as it says, says the header.
        let scene = unsafe { with_table(scene_of(rail, wheel, pair, friction)?, table)? };
        let (position, memory, out) = (given(position)?, given(workspace)?, given(vertical)?);
        let (found, warning) = scene.height_for_load(position, support, velocity, memory)?;
        Error::Overflow.unless(found.is_finite_number())?;
        out.write(found);
        Ok(warning)
    })
}
