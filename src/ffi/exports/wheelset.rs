//! The wheelset: two wheels on two rails.

use super::F;
use super::scene::{scene_of, with_table};
use crate::ffi::support::{
    each_element, element, given, input, place, put, status_of, with_requested, write_result,
    write_warned,
};
use crate::ffi::types::{Track, WheelsetParts};
use crate::number::{Float, are_finite};
use crate::status::{Error, Warning, kstrip_status};
use crate::wheel_rail::profile::PreparedProfile;
use crate::wheel_rail::{BodyState, Position, Velocity, WheelPair};
use crate::wheelset::conicity::{RadiusDifference, check_circles};
use crate::wheelset::forces::{
    Wheelset, WheelsetByPosition, WheelsetDerivatives, WheelsetForces, WheelsetWorkspace,
};
use crate::wheelset::kinematics::Side;
use crate::wheelset::settle::WheelsetLoads;
use crate::wheelset::track::{Curve, RailMotion, gauge_face};
use core::mem::MaybeUninit;

/// From the back of a flange to the running circle of its wheel \[m\].
const CIRCLE_FROM_BACK: F = 70e-3;

/// The gauge face of a rail: the least y of its profile down to a depth below its top. kstrip_track
/// uses it to find the rail's origin, which lies half the gauge minus this y from the middle of the
/// track.
///
/// @param rail            prepared profile of a rail.
/// @param depth           depth below the top of the rail [m], >= 0; 0: 14 mm.
/// @param[out] face       receives y of the gauge face from the rail's origin [m]; negative.
/// @return KSTRIP_OK; KSTRIP_WARNING_PROFILE_END (the profile ends above the depth);
///         KSTRIP_ERROR_NULL (rail or face), KSTRIP_ERROR_NOT_FINITE (depth is infinite or NaN),
///         KSTRIP_ERROR_NOT_PREPARED (rail), KSTRIP_ERROR_GAUGE (depth < 0).
#[unsafe(export_name = symbol!("kstrip_gauge_face"))]
pub extern "C" fn kstrip_gauge_face(
    rail: Option<&PreparedProfile<F>>, depth: F, face: Option<&mut MaybeUninit<F>>,
) -> kstrip_status {
    write_warned(face, || gauge_face(given(rail)?, depth))
}

/// Motion and weight in a curve. The axes of the track run along the curve with its speed, and turn
/// with it; relative to the momentary track, which is at rest, a body therefore has this motion in
/// addition to its own. Use it before kstrip_wheelset_on_track() and for the weight of every body.
///
/// @param curve           speed, curvature, cant.
/// @param position        where the body is in the axes of the track; vertical is not used.
/// @param relative        how the body moves in these axes; forward is the velocity in
///                        addition to the speed of the curve.
/// @param[out] velocity   receives the velocity relative to the momentary track.
/// @param[out] weight     receives three numbers: weight per mass, the centrifugal part included,
///                        forward, lateral, vertical [m/s^2]. At balance speed its lateral part is
///                        zero. NULL: not needed.
/// @return usual statuses; statuses of kstrip_curve and kstrip_wheel_position.
#[unsafe(export_name = symbol!("kstrip_curve_motion"))]
pub unsafe extern "C" fn kstrip_curve_motion(
    curve: Option<&Curve<F>>, position: Option<&Position<F>>, relative: Option<&Velocity<F>>,
    velocity: Option<&mut MaybeUninit<Velocity<F>>>, weight: *mut F,
) -> kstrip_status {
    // SAFETY: NULL or three writable numbers, says the header.
    let weight = unsafe { place(weight.cast::<[F; 3]>()) };
    status_of(|| {
        let out = given(velocity)?;
        let (position, relative) = (given(position)?, given(relative)?);
        let (found, acceleration, warning) = given(curve)?.motion(position, relative)?;
        out.write(found);
        put(weight, acceleration);
        Ok(warning)
    })
}

/// Forces on a wheelset and its rails: two wheels, two rails, one call.
///
/// The position is that of the wheelset's centre, in the axes of the track: lateral from the middle
/// of the track, vertical below the place where the centre is the mean of both wheel radii above
/// the rails' origins. The velocity is that of the centre relative to the momentary track, with
/// rates about the wheelset's own axes; in a curve kstrip_curve_motion() computes it. Forces are
/// continuous as in kstrip_wheel_on_rail(). The forces times the ten velocities are minus the
/// dissipation and minus the power that goes into the pressure.
///
/// @param set             wheels, materials, friction, distance of the wheels.
/// @param track           rails, gauge, displacements and velocities of the rails.
/// @param position        where the wheelset's centre is, its yaw and its roll.
/// @param velocity        how it moves.
/// @param workspace       memory that may hold anything; receives gap and contacts of both wheels.
/// @param[out] forces     receives the wrench on the wheelset and on each wheel, and the force on
///                        each rail.
/// @param[out] derivatives  receives exact derivatives with respect to the ten velocities and to
///                        friction; NULL: not needed.
/// @param[out] by_position  receives derivatives with respect to the ten positions, as exact as
///                        those of kstrip_wheel_on_rail(); NULL: not needed.
/// @return statuses of kstrip_wheelset and kstrip_track; as kstrip_wheel_on_rail() for each wheel,
///         of two warnings the more serious; with tables those of kstrip_wheel_on_table().
#[unsafe(export_name = symbol!("kstrip_wheelset_on_track"))]
pub unsafe extern "C" fn kstrip_wheelset_on_track(
    set: Option<&WheelsetParts<F>>, track: Option<&Track<F>>, position: Option<&Position<F>>,
    velocity: Option<&Velocity<F>>, workspace: Option<&mut WheelsetWorkspace<F>>,
    forces: Option<&mut MaybeUninit<WheelsetForces<F>>>,
    derivatives: Option<&mut MaybeUninit<WheelsetDerivatives<F>>>,
    by_position: Option<&mut MaybeUninit<WheelsetByPosition<F>>>,
) -> kstrip_status {
    // SAFETY: the pointers in the structures are NULL or valid, says the header.
    unsafe {
        on_track(set, track, |wheelset| {
            let (position, velocity) = (given(position)?, given(velocity)?);
            let (memory, out) = (given(workspace)?, given(forces)?);
            let state = BodyState { position: *position, velocity: *velocity };
            let found = with_requested(
                derivatives,
                by_position,
                |_| true,
                |requested| wheelset.differentiate(&state, memory, requested),
            )?;
            out.write(found);
            Ok(found.wrench.warning)
        })
    }
}

/// A wheelset in balance: height, roll and pitch rate at which its rails carry given loads, at
/// given lateral position, yaw and speed. Use it to begin a run, and for tables. Any friction from
/// 0 on, any speed and rollers are possible. Without friction the pitch rate is that of pure
/// rolling on the mean radius. A wheel is lifted in the result only if no balance is found with
/// both wheels on the rails.
///
/// @param set, track      as in kstrip_wheelset_on_track().
/// @param start           lateral and yaw; vertical and roll are where the search begins.
/// @param velocity        how the wheelset moves; its pitch is not used.
/// @param loads           downward force, roll moment and torque about the axle that act on the
///                        wheelset.
/// @param workspace       memory that may hold anything; receives gap and contacts of both wheels.
/// @param[out] position   receives the position.
/// @param[out] moves      receives the velocity, with the pitch rate.
/// @param[out] forces     receives the forces there; NULL: not needed.
/// @return as kstrip_wheelset_on_track(); statuses of kstrip_wheelset_loads;
///         KSTRIP_WARNING_NOT_CONVERGED (the balance is not exact to rounding);
///         KSTRIP_ERROR_WHEEL_LIFTED (no heights carry the loads);
///         KSTRIP_ERROR_FORCE_BEYOND_FRICTION (friction does not carry the torque).
#[unsafe(export_name = symbol!("kstrip_wheelset_settle"))]
pub unsafe extern "C" fn kstrip_wheelset_settle(
    set: Option<&WheelsetParts<F>>, track: Option<&Track<F>>, start: Option<&Position<F>>,
    velocity: Option<&Velocity<F>>, loads: Option<&WheelsetLoads<F>>,
    workspace: Option<&mut WheelsetWorkspace<F>>, position: Option<&mut MaybeUninit<Position<F>>>,
    moves: Option<&mut MaybeUninit<Velocity<F>>>,
    forces: Option<&mut MaybeUninit<WheelsetForces<F>>>,
) -> kstrip_status {
    // SAFETY: the pointers in the structures are NULL or valid, says the header.
    unsafe {
        on_track(set, track, |wheelset| {
            let start = BodyState { position: *given(start)?, velocity: *given(velocity)? };
            let (loads, memory) = (given(loads)?, given(workspace)?);
            let (position, moves) = (given(position)?, given(moves)?);
            let found = wheelset.settle(&start, loads, memory)?;
            position.write(found.state.position);
            moves.write(found.state.velocity);
            put(forces, found.forces);
            Ok(found.warning)
        })
    }
}

/// The difference of the rolling radii, right minus left, against the lateral shift of a rigid
/// wheelset that touches both rails without yaw.
///
/// @param set, track      as in kstrip_wheelset_on_track(); of the motion of the rails only the
///                        displacements are used.
/// @param shifts, count   lateral positions of the wheelset [m].
/// @param with_roll       0: without roll, as in EN 15302; any other number: with the roll that
///                        the wheelset has on both rails.
/// @param workspace       memory that may hold anything.
/// @param[out] differences  array of count elements; receives the differences [m]. An element with
///                        an error is untouched and does not stop the others.
/// @param[out] statuses   array of count elements; receives the status of each shift; NULL: not
///                        needed.
/// @return as kstrip_wheelset_on_track() without velocities and contacts: the first error of a
///         shift; before any shift KSTRIP_ERROR_NULL (a required array or structure).
#[unsafe(export_name = symbol!("kstrip_rolling_radius_difference"))]
pub unsafe extern "C" fn kstrip_rolling_radius_difference(
    set: Option<&WheelsetParts<F>>, track: Option<&Track<F>>, shifts: *const F, count: u32,
    with_roll: i32, workspace: Option<&mut WheelsetWorkspace<F>>, differences: *mut F,
    statuses: *mut kstrip_status,
) -> kstrip_status {
    // SAFETY: the pointers in the structures are NULL or valid, arrays have count elements, says
    // the header.
    unsafe {
        on_track(set, track, |wheelset| {
            let (shifts, memory) = (input(shifts, count)?, given(workspace)?);
            Error::NullPointer.unless(count == 0 || !differences.is_null())?;
            each_element(count, statuses, |i| {
                write_result(element(differences, i), || {
                    let shift = *given(shifts.get(i))?;
                    wheelset.rolling_radius_difference(shift, with_roll != 0, memory)
                })
            })
        })
    }
}

/// Equivalent conicity after EN 15302: the conicity of the coned wheelset whose motion has the same
/// wave length. It comes from the motion of a free wheelset over half a wave, with differences of
/// the rolling radii that kstrip_rolling_radius_difference() or a measurement gives.
///
/// @param shifts, differences, count  lateral shifts [m], ascending, and differences of the rolling
///                        radii, right minus left [m]; at least 2, straight between them.
/// @param running_circles  distance of the running circles [m], > 0, about 1.5.
/// @param wheel_radius    radius of the wheels [m], > 0.
/// @param amplitudes, number  amplitudes of the motion [m], > 0.
/// @param[out] conicities   array of number elements; receives the conicities [-], >= 0: 0 where
///                        the radii do not differ over a part of the motion. An element with an
///                        error is untouched and does not stop the others.
/// @param[out] wave_lengths  array of number elements; receives the wave lengths [m], INFINITY
///                        where the conicity is 0; NULL: not needed.
/// @param[out] statuses   array of number elements; receives the status of each amplitude; NULL:
///                        not needed.
/// @return KSTRIP_OK, or the error of the first amplitude without a conicity: KSTRIP_ERROR_CONICITY
///         (it is not positive or beyond the shifts, or the radii turn the wheelset away from the
///         middle), KSTRIP_ERROR_NOT_FINITE (it is infinite or NaN), KSTRIP_ERROR_OVERFLOW (a
///         result is too large); before any amplitude KSTRIP_ERROR_NULL (a required array),
///         KSTRIP_ERROR_NOT_FINITE (another number), KSTRIP_ERROR_PROFILE (fewer than two shifts,
///         or they do not ascend), KSTRIP_ERROR_GAUGE (running_circles <= 0),
///         KSTRIP_ERROR_ROLLING_RADIUS (wheel_radius <= 0).
#[unsafe(export_name = symbol!("kstrip_equivalent_conicity"))]
pub unsafe extern "C" fn kstrip_equivalent_conicity(
    shifts: *const F, differences: *const F, count: u32, running_circles: F, wheel_radius: F,
    amplitudes: *const F, number: u32, conicities: *mut F, wave_lengths: *mut F,
    statuses: *mut kstrip_status,
) -> kstrip_status {
    // SAFETY: arrays are NULL or have as many elements as their counts say, says the header.
    let (shifts, differences, amplitudes) =
        unsafe { (input(shifts, count), input(differences, count), input(amplitudes, number)) };
    status_of(|| {
        let (radii, amplitudes) = (RadiusDifference::new(shifts?, differences?)?, amplitudes?);
        Error::NullPointer.unless(number == 0 || !conicities.is_null())?;
        check_circles(running_circles, wheel_radius)?;
        // SAFETY: the same.
        unsafe {
            each_element(number, statuses, |i| {
                status_of(|| {
                    let amplitude = *given(amplitudes.get(i))?;
                    let found = radii.wave(amplitude, running_circles, wheel_radius)?;
                    put(element(conicities, i), found.conicity);
                    put(element(wave_lengths, i), found.length);
                    Ok(Warning::None)
                })
            })
        }
    })
}

/// Calls a function with the checked wheelset on its rails. A rail may warn that it ends above the
/// depth at which its gauge is measured.
///
/// # Safety
/// The pointers in both structures and in their tables are NULL or valid.
unsafe fn on_track(
    set: Option<&WheelsetParts<F>>, track: Option<&Track<F>>,
    solve: impl FnOnce(&Wheelset<'_, F>) -> Result<Warning, Error>,
) -> kstrip_status {
    status_of(|| {
        let (set, track) = (given(set)?, given(track)?);
        // SAFETY: the promise of this function.
        let ([rail, other_rail], [wheel, other_wheel], [law, other_law]) = unsafe {
            let both = |[right, left]: [*const PreparedProfile<F>; 2]| {
                let right = given(right.as_ref())?;
                Ok([right, left.as_ref().unwrap_or(right)])
            };
            (both(track.rail)?, both(set.wheel)?, set.friction.map(|law| law.as_ref()))
        };
        let [right, left] = set.pair;
        let left = if left.wheel_radius == 0.0 { right } else { left };
        let (right, left) = (WheelPair { left: 0, ..right }, WheelPair { left: 1, ..left });
        [right, left].iter().try_for_each(WheelPair::check)?;
        track.motion.iter().try_for_each(RailMotion::check)?;
        let arm = half_distance(set)?;
        let [motion, left_motion] = track.motion;
        let ([place, other_place], excess) =
            (track.origin, 0.5 * (right.wheel_radius - left.wheel_radius));
        let (origin, of_rail) = origin_of(track, place, rail)?;
        let (left_origin, of_other) = origin_of(track, other_place, other_rail)?;
        let sides = [
            Side { arm, origin, excess, rail: 6, motion },
            Side { arm: -arm, origin: -left_origin, excess: -excess, rail: 8, motion: left_motion },
        ];
        let scenes = [
            scene_of(Some(rail), Some(wheel), Some(&right), law)?,
            scene_of(Some(other_rail), Some(other_wheel), Some(&left), other_law)?,
        ];
        let ([right, left], [table, other_table]) = (scenes, set.table);
        // SAFETY: the promise of this function.
        let scenes = unsafe {
            [with_table(right, table.as_ref())?, with_table(left, other_table.as_ref())?]
        };
        Ok(solve(&Wheelset { scenes, sides })?.worse(of_rail.worse(of_other)))
    })
}

fn half_distance(set: &WheelsetParts<F>) -> Result<F, Error> {
    let WheelsetParts { back_to_back, running_circles, .. } = *set;
    Error::NotFinite.unless(are_finite(&[back_to_back, running_circles]))?;
    let known = running_circles > 0.0 && back_to_back >= 0.0;
    let from_backs = running_circles == 0.0 && back_to_back > 0.0;
    Error::Gauge.unless(known || from_backs)?;
    Ok(if known { 0.5 * running_circles } else { 0.5 * back_to_back + CIRCLE_FROM_BACK })
}

/// The distance of a rail's origin from the middle of the track.
fn origin_of(track: &Track<F>, given: F, rail: &PreparedProfile<F>) -> Result<(F, Warning), Error> {
    Error::NotFinite.unless(given.is_finite_number())?;
    if given > 0.0 {
        return Ok((given, Warning::None));
    }
    Error::NotFinite.unless(track.gauge.is_finite_number())?;
    Error::Gauge.unless(given == 0.0 && track.gauge > 0.0)?;
    let (face, warning) = gauge_face(rail, track.gauge_depth)?;
    Ok((0.5 * track.gauge - face, warning))
}
