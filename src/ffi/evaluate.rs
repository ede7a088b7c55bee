//! Only what is wanted, for C.

use super::calls::{Out, OutArray, check_room, given, inputs, write_strips};
use super::types::{kstrip_contact, kstrip_creepage, kstrip_options, kstrip_result, kstrip_strip};
use super::types_f32::{
    kstrip_contact_f32, kstrip_creepage_f32, kstrip_result_f32, kstrip_strip_f32,
};
use super::{
    KSTRIP_WANT_ADHESION, KSTRIP_WANT_FORCES, KSTRIP_WANT_JACOBIAN, KSTRIP_WANT_MOMENT,
    KSTRIP_WANT_STRIPS, answer, arrays, checked_options, kstrip_status,
};
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::solve::evaluate::{self, Wanted};
use crate::solve::model::{Precision, Solution, StripResult};
use crate::status::Error;
use core::mem::MaybeUninit;

/// Where the results of an evaluation go.
struct Outputs<'a, F, R, S> {
    result: Out<'a, R>,
    jacobian: OutArray<'a, [F; 9]>,
    strips: OutArray<'a, S>,
    count: Out<'a, u32>,
}

fn evaluate<F: Precision, C: Copy, K: Copy, R: From<Solution<F>>, S: From<StripResult<F>>>(
    contact: Option<&C>,
    creepage: Option<&K>,
    options: Option<&kstrip_options>,
    wanted: u32,
    outputs: Outputs<F, R, S>,
) -> kstrip_status
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
{
    const ALL: u32 = KSTRIP_WANT_FORCES
        | KSTRIP_WANT_MOMENT
        | KSTRIP_WANT_ADHESION
        | KSTRIP_WANT_JACOBIAN
        | KSTRIP_WANT_STRIPS;
    answer(|| {
        let (contact, creepage) = inputs(contact, creepage)?;
        let options = checked_options(options)?;
        if wanted & !ALL != 0 {
            return Err(Error::Wanted);
        }
        let wants = |flag| wanted & flag != 0;
        // Everything that can fail comes before the first output.
        let result = given(outputs.result)?;
        let jacobian = if wants(KSTRIP_WANT_JACOBIAN) { Some(outputs.jacobian?) } else { None };
        let strips = if wants(KSTRIP_WANT_STRIPS) {
            Some((outputs.strips?, given(outputs.count)?))
        } else {
            None
        };
        if let Some((strips, _)) = &strips {
            check_room(&contact, &creepage, &options, strips.len())?;
        }
        let flags =
            Wanted { moment: wants(KSTRIP_WANT_MOMENT), adhesion: wants(KSTRIP_WANT_ADHESION) };
        let solution = if let Some(entries) = jacobian {
            let (solution, j) = evaluate::evaluate_jacobian(&contact, &creepage, &options, flags)?;
            for entry in entries {
                entry.write([j.m11, j.m12, j.m13, j.m21, j.m22, j.m23, j.m31, j.m32, j.m33]);
            }
            solution
        } else {
            evaluate::evaluate_inline(&contact, &creepage, &options, flags)?
        };
        let notice = solution.notice;
        result.write(solution.into());
        if let Some((strips, count)) = strips {
            count.write(write_strips(&contact, &creepage, &options, strips)?.1);
        }
        Ok(notice)
    })
}

/// Only what is wanted of a contact in motion: what is not wanted is not computed.
///
/// What is wanted is that of kstrip_solve(), kstrip_solve_jacobian() and kstrip_strips(), bit for bit. What is not
/// wanted is reported as mz = power = 0 and adhesion = -1. KSTRIP_MODEL_STRIP saves most without adhesion; all derivatives
/// come together. The README has the instructions of each combination. Under falling friction:
/// kstrip_contact_under_friction() first, except for derivatives, which are kstrip_solve_friction_jacobian()'s.
///
/// @param contact         ellipse, load, material, friction.
/// @param creepage        motion.
/// @param options         model and strip count; NULL for the defaults.
/// @param wanted          KSTRIP_WANT constants, added up; the forces are always computed.
/// @param[out] result     receives the forces.
/// @param[out] jacobian   nine numbers as kstrip_solve_jacobian(); with KSTRIP_WANT_JACOBIAN only, else may be NULL.
/// @param[out] strips     array as kstrip_strips(); with KSTRIP_WANT_STRIPS only, else may be NULL.
/// @param capacity        its size.
/// @param[out] count      receives how many were written; with KSTRIP_WANT_STRIPS only, else may be NULL.
/// @return as kstrip_solve(), kstrip_solve_jacobian() and kstrip_strips(); KSTRIP_ERROR_WANTED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_evaluate(
    contact: Option<&kstrip_contact>,
    creepage: Option<&kstrip_creepage>,
    options: Option<&kstrip_options>,
    wanted: u32,
    result: Option<&mut MaybeUninit<kstrip_result>>,
    jacobian: *mut f64,
    strips: *mut kstrip_strip,
    capacity: u32,
    count: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    // SAFETY: NULL, or nine writable numbers and capacity elements, says the header.
    let (jacobian, strips) = unsafe {
        (arrays::output(jacobian.cast::<[f64; 9]>(), 1), arrays::output(strips, capacity))
    };
    evaluate(contact, creepage, options, wanted, Outputs { result, jacobian, strips, count })
}

/// kstrip_evaluate() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_evaluate_f32(
    contact: Option<&kstrip_contact_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    options: Option<&kstrip_options>,
    wanted: u32,
    result: Option<&mut MaybeUninit<kstrip_result_f32>>,
    jacobian: *mut f32,
    strips: *mut kstrip_strip_f32,
    capacity: u32,
    count: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    // SAFETY: NULL, or nine writable numbers and capacity elements, says the header.
    let (jacobian, strips) = unsafe {
        (arrays::output(jacobian.cast::<[f32; 9]>(), 1), arrays::output(strips, capacity))
    };
    evaluate(contact, creepage, options, wanted, Outputs { result, jacobian, strips, count })
}
