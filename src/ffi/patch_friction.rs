//! Falling friction and reduced initial slope on patches, for C.

use super::calls::{Out, OutArray, given, write_rows};
use super::friction::{kstrip_friction, kstrip_friction_f32};
use super::patch_calls::Stored;
use super::patch_types::{kstrip_patch, kstrip_patch_f32};
use super::types::{kstrip_creepage, kstrip_options, kstrip_result};
use super::types_f32::{kstrip_creepage_f32, kstrip_result_f32};
use super::{answer, arrays, checked_options, kstrip_status};
use crate::contact::creepage::Creepage;
use crate::friction::SlipFriction;
use crate::patch::friction;
use crate::solve::model::Solution;
use core::mem::MaybeUninit;

fn solve<P: Stored, K: Copy, L: Copy, R: From<Solution<P::Float>>>(
    patch: Option<&P>,
    creepage: Option<&K>,
    friction: Option<&L>,
    options: Option<&kstrip_options>,
    out: Out<R>,
    share: Out<P::Float>,
) -> kstrip_status
where
    Creepage<P::Float>: From<K>,
    SlipFriction<P::Float>: From<L>,
{
    answer(|| {
        let (patch, creepage) = (given(patch)?, Creepage::from(*given(creepage)?));
        let law = SlipFriction::from(*given(friction)?);
        let (options, out) = (checked_options(options)?, given(out)?);
        let found = friction::solve(&patch.view()?, &creepage, &law, options.model)?;
        out.write(found.solution.into());
        if let Some(share) = share {
            share.write(found.share);
        }
        Ok(found.solution.notice)
    })
}

fn jacobian<P: Stored, K: Copy, L: Copy, R: From<Solution<P::Float>>>(
    patch: Option<&P>,
    creepage: Option<&K>,
    friction: Option<&L>,
    options: Option<&kstrip_options>,
    out: Out<R>,
    entries: OutArray<P::Float>,
    share: Out<P::Float>,
) -> kstrip_status
where
    Creepage<P::Float>: From<K>,
    SlipFriction<P::Float>: From<L>,
{
    answer(|| {
        let (patch, creepage) = (given(patch)?, Creepage::from(*given(creepage)?));
        let law = SlipFriction::from(*given(friction)?);
        let (options, out, entries) = (checked_options(options)?, given(out)?, entries?);
        let (found, jacobian) =
            friction::solve_jacobian(&patch.view()?, &creepage, &law, options.model)?;
        out.write(found.solution.into());
        write_rows(&jacobian, entries);
        if let Some(share) = share {
            share.write(found.share);
        }
        Ok(found.solution.notice)
    })
}

fn under<P: Stored, K: Copy, L: Copy>(
    patch: Option<&P>,
    creepage: Option<&K>,
    friction: Option<&L>,
    options: Option<&kstrip_options>,
    out: Out<P>,
    share: Out<P::Float>,
) -> kstrip_status
where
    Creepage<P::Float>: From<K>,
    SlipFriction<P::Float>: From<L>,
{
    answer(|| {
        let (patch, creepage) = (given(patch)?, Creepage::from(*given(creepage)?));
        let law = SlipFriction::from(*given(friction)?);
        let (options, out) = (checked_options(options)?, given(out)?);
        let (found, notice) =
            friction::friction_share(&patch.view()?, &creepage, &law, options.model)?;
        out.write(*patch).soften(found, law.slope_factor);
        if let Some(share) = share {
            share.write(found);
        }
        Ok(notice)
    })
}

/// Forces of a patch whose friction falls with the slip, solved consistently with the slip.
///
/// The friction of every strip is that without slip; the law multiplies all of them with one share,
/// (1 - ratio) exp(-decay w) + ratio, w the rolling speed times the mean slip of the patch, weighted with friction:
/// power over the sum of friction times load. The law's own friction is ignored, its slope_factor multiplies the shear
/// modulus. The strips of an ellipse give the answer of kstrip_solve_friction(). With constant friction and slope_factor
/// 1 the result is that of kstrip_patch_solve(), bit for bit and at its cost; otherwise some six solutions,
/// 260 at most.
///
/// @param patch           the patch.
/// @param creepage        motion at the origin.
/// @param friction        how friction falls; its member friction is not used.
/// @param options         as kstrip_patch_solve(); NULL for the default.
/// @param[out] result     receives what kstrip_patch_solve() gives.
/// @param[out] share      receives friction that agrees with the slip over friction without slip [-], the same for all
///                        strips; may be NULL.
/// @return as kstrip_patch_solve(); KSTRIP_WARNING_SEVERAL_FRICTIONS for friction that falls steeply,
///         KSTRIP_WARNING_NOT_CONVERGED for that and where forces jump over the slip (KSTRIP_MODEL_STRIP_1967 with
///         spin, see kstrip_patch_from_ellipse()); KSTRIP_ERROR_FRICTION_RATIO, KSTRIP_ERROR_FRICTION_DECAY,
///         KSTRIP_ERROR_NEGATIVE_SPEED, KSTRIP_ERROR_SLOPE_FACTOR.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_patch_solve_friction(
    patch: Option<&kstrip_patch>,
    creepage: Option<&kstrip_creepage>,
    friction: Option<&kstrip_friction>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result>>,
    share: Option<&mut MaybeUninit<f64>>,
) -> kstrip_status {
    solve(patch, creepage, friction, options, result, share)
}

/// kstrip_patch_solve_friction() with the exact derivatives with respect to the creepages.
///
/// @param[out] jacobian   receives d(fx, fy, mz)/d(longitudinal, lateral, spin), row by row, friction
///                        following the slip: nine numbers [N, N, N m over 1, 1, 1/m].
/// @return as kstrip_patch_solve_friction(); KSTRIP_ERROR_OVERFLOW also when a derivative is too large.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_patch_solve_friction_jacobian(
    patch: Option<&kstrip_patch>,
    creepage: Option<&kstrip_creepage>,
    friction: Option<&kstrip_friction>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result>>,
    jacobian: *mut f64,
    share: Option<&mut MaybeUninit<f64>>,
) -> kstrip_status {
    // SAFETY: NULL or nine writable numbers, says the header.
    let entries = unsafe { arrays::output(jacobian, 9) };
    self::jacobian(patch, creepage, friction, options, result, entries, share)
}

/// The patch as it is while it slips: friction that falls with the slip has become constant friction of its strips,
/// and the slope factor part of its shear modulus.
///
/// kstrip_patch_strips(), kstrip_patch_traction_at(), kstrip_patch_field() and kstrip_patch_solve() of that patch at the
/// same creepage are those under falling friction. (kstrip_patch_jacobian() is not: its friction stands still.)
///
/// @param patch, creepage, friction, options  as kstrip_patch_solve_friction().
/// @param[out] slipping   receives the patch; not the patch itself.
/// @param[out] share      receives friction that agrees with the slip over friction without slip [-]; may be NULL.
/// @return as kstrip_patch_solve_friction().
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_patch_under_friction(
    patch: Option<&kstrip_patch>,
    creepage: Option<&kstrip_creepage>,
    friction: Option<&kstrip_friction>,
    options: Option<&kstrip_options>,
    slipping: Option<&mut MaybeUninit<kstrip_patch>>,
    share: Option<&mut MaybeUninit<f64>>,
) -> kstrip_status {
    under(patch, creepage, friction, options, slipping, share)
}

/// kstrip_patch_solve_friction() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_patch_solve_friction_f32(
    patch: Option<&kstrip_patch_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    friction: Option<&kstrip_friction_f32>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result_f32>>,
    share: Option<&mut MaybeUninit<f32>>,
) -> kstrip_status {
    solve(patch, creepage, friction, options, result, share)
}

/// kstrip_patch_solve_friction_jacobian() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_patch_solve_friction_jacobian_f32(
    patch: Option<&kstrip_patch_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    friction: Option<&kstrip_friction_f32>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result_f32>>,
    jacobian: *mut f32,
    share: Option<&mut MaybeUninit<f32>>,
) -> kstrip_status {
    // SAFETY: NULL or nine writable numbers, says the header.
    let entries = unsafe { arrays::output(jacobian, 9) };
    self::jacobian(patch, creepage, friction, options, result, entries, share)
}

/// kstrip_patch_under_friction() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_patch_under_friction_f32(
    patch: Option<&kstrip_patch_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    friction: Option<&kstrip_friction_f32>,
    options: Option<&kstrip_options>,
    slipping: Option<&mut MaybeUninit<kstrip_patch_f32>>,
    share: Option<&mut MaybeUninit<f32>>,
) -> kstrip_status {
    under(patch, creepage, friction, options, slipping, share)
}
