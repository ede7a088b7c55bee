//! Solve: forces, derivatives, strips of one contact.

use super::F;
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::ffi::support::{
    Output, for_forces, for_strips, given, given_by, output, place, put, status_of, strip_count,
    write_result, write_solution,
};
use crate::ffi::types::{MotionOutputs, Outputs, kstrip_options};
use crate::forces::derivatives::Derivatives;
use crate::forces::prepared::Prepared;
use crate::forces::theory::{
    EllipseStrips, Linear, Strip1967, Theory, Total, solution_of, write_forces,
};
use crate::forces::{self, Options, Solution, StripResult};
use crate::friction::derivatives::{LawDerivatives, differentiate_with_law};
use crate::friction::{self, SlipFriction};
use crate::motion::{self, Motion};
use crate::status::{Error, Warning, kstrip_status};
use core::mem::MaybeUninit;

/// Forces of a contact in motion, on the lower body: the fast path.
///
/// The forces are continuous in all inputs, and |F| <= mu N. They are zero where creepage and spin
/// are zero, and where the contact is lost (normal_force <= 0), with adhesion 0. The forces of
/// KSTRIP_MODEL_LINEAR have no such bound, and for given semi-axes do not change with the load
/// until the contact is lost. The time is bounded: every iteration has a largest number of steps.
///
/// @param contact         ellipse, load, material, friction.
/// @param creepage        motion.
/// @param options         model and strip count; NULL for the defaults.
/// @param[out] result     receives forces, moment, power and adhesion.
/// @return usual statuses; statuses of kstrip_contact, kstrip_creepage and kstrip_options.
#[unsafe(export_name = symbol!("kstrip_solve"))]
pub extern "C" fn kstrip_solve(
    contact: Option<&Contact<F>>, creepage: Option<&Creepage<F>>, options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<Solution<F>>>,
) -> kstrip_status {
    status_of(|| {
        let place = given(result)?;
        let (contact, creepage) = (given(contact)?, given(creepage)?);
        Ok(write_forces(contact, creepage, &for_forces(options)?, place)?.warning)
    })
}

/// Computes, for a contact in motion, every output that is not NULL.
///
/// If friction is given, the coefficient of friction falls with the slip and agrees with it; the
/// contact's own coefficient is ignored. All derivatives include that dependence. If more than one
/// coefficient agrees with its slip, the result has the largest. The two models of 1967 may miss
/// it under steeply falling friction, because their forces jump, or nearly jump, when a first
/// strip begins to adhere. With KSTRIP_MODEL_DEFAULT strips are those of KSTRIP_MODEL_STRIP.
///
/// @param contact, creepage, options  as in kstrip_solve().
/// @param friction        falling friction; NULL: constant.
/// @param outputs         where the outputs go.
/// @return as kstrip_solve(); statuses of kstrip_friction; KSTRIP_WARNING_SEVERAL_FRICTIONS (more
///         than one coefficient agrees with its slip); KSTRIP_WARNING_NOT_CONVERGED (the search for
///         the coefficient ended early); KSTRIP_ERROR_CAPACITY (outputs->capacity is below the
///         strip count); KSTRIP_ERROR_NOT_IN_MODEL (strips of KSTRIP_MODEL_TOTAL or
///         KSTRIP_MODEL_LINEAR).
#[unsafe(export_name = symbol!("kstrip_evaluate"))]
pub unsafe extern "C" fn kstrip_evaluate(
    contact: Option<&Contact<F>>, creepage: Option<&Creepage<F>>,
    friction: Option<&SlipFriction<F>>, options: Option<&kstrip_options>,
    outputs: Option<&Outputs<F>>,
) -> kstrip_status {
    // SAFETY: every pointer is NULL or valid, says the header.
    status_of(|| unsafe {
        evaluate(given(contact)?, given(creepage)?, friction, options, given(outputs)?)
    })
}

/// Prepares a contact with its options for kstrip_solve_prepared().
///
/// Use this for rigs whose contact is constant, and for iterations on the creepage.
///
/// @param contact, options  as in kstrip_solve().
/// @param[out] prepared   receives the prepared contact.
/// @return usual statuses; errors of kstrip_contact and kstrip_options.
#[unsafe(export_name = symbol!("kstrip_prepare"))]
pub extern "C" fn kstrip_prepare(
    contact: Option<&Contact<F>>, options: Option<&kstrip_options>,
    prepared: Option<&mut MaybeUninit<Prepared<F>>>,
) -> kstrip_status {
    write_result(prepared, || Prepared::new(given(contact)?, &for_forces(options)?))
}

/// kstrip_solve() for a prepared contact: the same result, bit for bit.
///
/// @param prepared        by kstrip_prepare().
/// @param creepage        motion.
/// @param[out] result     receives forces, moment, power and adhesion.
/// @return as kstrip_solve(); KSTRIP_ERROR_NOT_PREPARED (prepared is not from kstrip_prepare() of
///         this precision).
#[unsafe(export_name = symbol!("kstrip_solve_prepared"))]
pub extern "C" fn kstrip_solve_prepared(
    prepared: Option<&Prepared<F>>, creepage: Option<&Creepage<F>>,
    result: Option<&mut MaybeUninit<Solution<F>>>,
) -> kstrip_status {
    write_solution(result, || given(prepared)?.solve(given(creepage)?))
}

/// Forces of a contact that rolls forward, backward, or not at all, with derivatives with respect
/// to its motion: for wheels that stop, hold and reverse.
///
/// The creepages are slip divided by sqrt(rolling_speed^2 + floor_speed^2). Far from standstill the
/// leading edge of the patch lies ahead, in the direction of the motion. Near standstill the
/// results of both directions are blended, so that forces and derivatives are continuous. Friction
/// opposes the slip at every speed. The axis x keeps its direction when the motion reverses.
///
/// @param contact, options  as in kstrip_solve().
/// @param motion          slip, spin rate, signed rolling speed.
/// @param friction        falling friction; NULL: constant. Its rolling_speed is ignored.
/// @param outputs         where the outputs go.
/// @return usual statuses; statuses of kstrip_contact, kstrip_motion, kstrip_friction and
///         kstrip_options; warnings of kstrip_creepage (above 1 m/s);
///         KSTRIP_WARNING_SEVERAL_FRICTIONS and KSTRIP_WARNING_NOT_CONVERGED, as in
///         kstrip_evaluate().
#[unsafe(export_name = symbol!("kstrip_solve_motion"))]
pub unsafe extern "C" fn kstrip_solve_motion(
    contact: Option<&Contact<F>>, motion: Option<&Motion<F>>, friction: Option<&SlipFriction<F>>,
    options: Option<&kstrip_options>, outputs: Option<&MotionOutputs<F>>,
) -> kstrip_status {
    status_of(|| {
        let (contact, motion, outputs) = (given(contact)?, given(motion)?, given(outputs)?);
        let options = &for_forces(options)?;
        // SAFETY: every pointer is NULL or valid, says the header.
        let (result, used, derivatives) =
            unsafe { (place(outputs.result), place(outputs.friction), place(outputs.derivatives)) };
        let (solution, found) = if let Some(derivatives) = derivatives {
            let (solution, found, slopes) =
                motion::differentiate_motion(contact, motion, friction, options)?;
            derivatives.write(slopes);
            (solution, found)
        } else {
            motion::solve_motion(contact, motion, friction, options)?
        };
        put(result, solution);
        put(used, found);
        Ok(solution.warning)
    })
}

/// kstrip_solve() with KSTRIP_MODEL_TOTAL; a program that calls only this links no other model.
///
/// @param contact, creepage  as in kstrip_solve().
/// @param[out] result     receives forces, moment and power on the lower body.
/// @return usual statuses; statuses of kstrip_contact and kstrip_creepage;
///         KSTRIP_WARNING_AXIS_RATIO (a/b is outside 0.015 to 60).
#[unsafe(export_name = symbol!("kstrip_solve_total"))]
#[cfg(feature = "total")]
pub extern "C" fn kstrip_solve_total(
    contact: Option<&Contact<F>>, creepage: Option<&Creepage<F>>,
    result: Option<&mut MaybeUninit<Solution<F>>>,
) -> kstrip_status {
    solved_by::<Total<F>>(contact, creepage, 0, result)
}

/// kstrip_solve() with KSTRIP_MODEL_STRIP; a program that calls only this links no other model.
///
/// @param contact, creepage  as in kstrip_solve().
/// @param strips          4, 8, 16, 32 or 64; 0: 16.
/// @param[out] result     receives forces, moment, power and adhesion.
/// @return as kstrip_solve_total(); KSTRIP_WARNING_RANGE (|psi| is above 3);
///         KSTRIP_ERROR_STRIP_COUNT (strips is another number).
#[unsafe(export_name = symbol!("kstrip_solve_strip"))]
#[cfg(feature = "strip")]
pub extern "C" fn kstrip_solve_strip(
    contact: Option<&Contact<F>>, creepage: Option<&Creepage<F>>, strips: i32,
    result: Option<&mut MaybeUninit<Solution<F>>>,
) -> kstrip_status {
    solved_by::<EllipseStrips<F>>(contact, creepage, strips, result)
}

/// kstrip_solve() with KSTRIP_MODEL_STRIP_1967; a program that calls only this links no other
/// model.
///
/// @param contact, creepage  as in kstrip_solve().
/// @param strips          4, 8, 16, 32 or 64; 0: 16.
/// @param[out] result     receives forces, moment, power and adhesion.
/// @return usual statuses; statuses of kstrip_contact and kstrip_creepage; KSTRIP_WARNING_SPIN
///         (|psi| is 1 or more); KSTRIP_WARNING_MISMATCH_NEGLECTED (the mismatch is not 0);
///         KSTRIP_ERROR_STRIP_COUNT (strips is another number).
#[unsafe(export_name = symbol!("kstrip_solve_strip_1967"))]
#[cfg(feature = "strip-1967")]
pub extern "C" fn kstrip_solve_strip_1967(
    contact: Option<&Contact<F>>, creepage: Option<&Creepage<F>>, strips: i32,
    result: Option<&mut MaybeUninit<Solution<F>>>,
) -> kstrip_status {
    solved_by::<Strip1967>(contact, creepage, strips, result)
}

/// kstrip_solve() with KSTRIP_MODEL_LINEAR; a program that calls only this links no other model.
///
/// @param contact, creepage  as in kstrip_solve().
/// @param[out] result     receives forces, moment and power on the lower body.
/// @return usual statuses; statuses of kstrip_contact and kstrip_creepage;
///         KSTRIP_WARNING_BEYOND_FRICTION (the force exceeds mu N).
#[unsafe(export_name = symbol!("kstrip_solve_linear"))]
#[cfg(feature = "linear")]
pub extern "C" fn kstrip_solve_linear(
    contact: Option<&Contact<F>>, creepage: Option<&Creepage<F>>,
    result: Option<&mut MaybeUninit<Solution<F>>>,
) -> kstrip_status {
    solved_by::<Linear<F>>(contact, creepage, 0, result)
}

/// The result on the upper body: opposite forces and moment, same power and adhesion.
///
/// @param lower           result on the lower body.
/// @param[out] upper      receives the result on the upper body.
/// @return KSTRIP_OK, or KSTRIP_ERROR_NULL if lower or upper is NULL.
#[unsafe(export_name = symbol!("kstrip_result_on_upper_body"))]
pub extern "C" fn kstrip_result_on_upper_body(
    lower: Option<&MaybeUninit<Solution<F>>>, upper: Option<&mut MaybeUninit<Solution<F>>>,
) -> kstrip_status {
    status_of(|| {
        let (lower, upper) = (given(lower)?, given(upper)?);
        *upper = *lower;
        let upper = upper.as_mut_ptr();
        // SAFETY: the three numbers are there, whatever bits they have; the rest is only copied.
        let forces = unsafe { [&mut (*upper).fx, &mut (*upper).fy, &mut (*upper).mz] };
        for force in forces {
            *force = -*force;
        }
        Ok(Warning::None)
    })
}

/// kstrip_solve() with one model. (Without any model the library has no such function.)
#[allow(dead_code)]
fn solved_by<M: Theory<F>>(
    contact: Option<&Contact<F>>, creepage: Option<&Creepage<F>>, strips: i32,
    result: Output<Solution<F>>,
) -> kstrip_status {
    write_solution(result, || {
        let options = Options { strips: strip_count(strips)?, ..Options::default() };
        solution_of::<_, M>(given(contact)?, given(creepage)?, &options)
    })
}

impl Outputs<F> {
    /// Whether an output is requested that needs derivatives.
    pub(super) fn differentiates(&self) -> bool {
        !(self.derivatives.is_null() && self.law_derivatives.is_null())
    }

    /// Writes all requested outputs but the strips.
    ///
    /// # Safety
    /// Every pointer is NULL, or valid and aligned for one write; no two overlap.
    pub(super) unsafe fn write(
        &self, solution: &Solution<F>, friction: F,
        slopes: Option<(&Derivatives<F>, &LawDerivatives<F>)>,
    ) {
        // SAFETY: the caller's promise.
        unsafe {
            put(place(self.result), *solution);
            put(place(self.friction), friction);
            if let Some((derivatives, law)) = slopes {
                put(place(self.derivatives), *derivatives);
                put(place(self.law_derivatives), *law);
            }
        }
    }

    /// Writes the strips and their number, if they are requested and there is room for `most`.
    ///
    /// # Safety
    /// The pointers are NULL, or valid and aligned, that of the strips for `capacity` writes.
    pub(super) unsafe fn write_strips(
        &self, most: usize,
        visit_strips: impl FnOnce(&mut dyn FnMut(StripResult<F>)) -> Result<Warning, Error>,
    ) -> Result<Warning, Error> {
        // SAFETY: the caller's promise.
        let (places, count) = unsafe { (output(self.strips, self.capacity)?, place(self.count)) };
        let count = given(count)?;
        Error::Capacity.unless(most <= places.len())?;
        let mut written = 0;
        let warning = visit_strips(&mut |strip| {
            if let Some(place) = places.get_mut(written as usize) {
                place.write(strip);
                written += 1;
            }
        })?;
        count.write(written);
        Ok(warning)
    }
}

/// # Safety
/// Every pointer of the outputs is NULL, or valid and aligned for one write, that of the strips for
/// `capacity`; no two overlap.
unsafe fn evaluate(
    contact: &Contact<F>, creepage: &Creepage<F>, law: Option<&SlipFriction<F>>,
    options: Option<&kstrip_options>, outputs: &Outputs<F>,
) -> Result<Warning, Error> {
    let forces = for_forces(options)?;
    // By reference: avoids a copy of 200 bytes on the stack.
    let (differentiated, under_law, nothing, alone);
    let (solution, friction, slopes) = if outputs.differentiates() {
        differentiated = differentiate_with_law(contact, creepage, law, &forces);
        let found = given_by(&differentiated)?;
        (&found.solution, found.friction, Some((&found.derivatives, &found.law)))
    } else if let Some(law) = law {
        under_law = friction::solve_with_law(contact, creepage, law, &forces);
        let found = given_by(&under_law)?;
        (&found.solution, found.friction, None)
    } else if outputs.result.is_null() && !outputs.strips.is_null() {
        // The strips have the errors and the warnings of the forces.
        nothing = Solution::default();
        (&nothing, contact.friction, None)
    } else {
        alone = forces::forces_of_contact(contact, creepage, &forces);
        (given_by(&alone)?, contact.friction, None)
    };
    let mut warning = solution.warning;
    if !outputs.strips.is_null() {
        let contact = law.map_or(*contact, |law| law.contact(contact));
        let contact = &Contact { friction, ..contact };
        // SAFETY: the caller's promise.
        let of_strips = unsafe { evaluate_strips(contact, creepage, law, options, outputs) };
        warning = warning.worse(of_strips?);
    }
    // SAFETY: the same.
    unsafe { outputs.write(solution, friction, slopes) };
    Ok(warning)
}

/// The strips alone. (Out of line, because they take much stack.)
///
/// # Safety
/// As [`evaluate`].
#[inline(never)]
unsafe fn evaluate_strips(
    contact: &Contact<F>, creepage: &Creepage<F>, law: Option<&SlipFriction<F>>,
    options: Option<&kstrip_options>, outputs: &Outputs<F>,
) -> Result<Warning, Error> {
    let options = &for_strips(options)?;
    let most = forces::strips_of(contact, creepage, options)?;
    // SAFETY: the caller's promise.
    unsafe {
        outputs.write_strips(most, |visit| {
            friction::strips_with_law(contact, creepage, law, options, visit)
        })
    }
}
