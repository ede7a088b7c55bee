//! One exported function per model, so that firmware links only the model that it calls.
//!
//! Same arguments as `kstrip_solve` without the model; same checks, same numbers.

use super::types::{kstrip_contact, kstrip_creepage, kstrip_result};
use super::types_f32::{kstrip_contact_f32, kstrip_creepage_f32, kstrip_result_f32};
use super::{calls, kstrip_status};
use crate::solve::model;
use core::mem::MaybeUninit;

/// kstrip_solve() with KSTRIP_MODEL_TOTAL without linking any other model.
///
/// The same result, to the bit, as kstrip_solve() with that model in its options. kstrip_solve() learns
/// its model when it runs and therefore brings every model into the program; a program that calls
/// only the functions of this group contains only the models that they name.
///
/// @param[in]  contact   the loaded contact.
/// @param[in]  creepage  creepage and spin.
/// @param[out] result    receives the forces on the lower body; adhesion is -1 (unknown).
/// @return KSTRIP_OK, KSTRIP_WARNING_RANGE, or one of the errors of kstrip_solve().
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_total(
    contact: Option<&kstrip_contact>,
    creepage: Option<&kstrip_creepage>,
    result: Option<&mut MaybeUninit<kstrip_result>>,
) -> kstrip_status {
    calls::solve_by(contact, creepage, result, model::solve_total)
}

/// kstrip_solve() with KSTRIP_MODEL_LINEAR without linking any other model.
///
/// @param[in]  contact   the loaded contact.
/// @param[in]  creepage  creepage and spin.
/// @param[out] result    receives the forces on the lower body; adhesion is 1.
/// @return KSTRIP_OK, KSTRIP_WARNING_BEYOND_FRICTION, or one of the errors of kstrip_solve().
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_linear(
    contact: Option<&kstrip_contact>,
    creepage: Option<&kstrip_creepage>,
    result: Option<&mut MaybeUninit<kstrip_result>>,
) -> kstrip_status {
    calls::solve_by(contact, creepage, result, model::solve_linear)
}

/// kstrip_solve() with KSTRIP_MODEL_STRIP_1967 without linking any other model.
///
/// @param[in]  contact   the loaded contact.
/// @param[in]  creepage  creepage and spin.
/// @param[in]  strips    number of strips: 4, 8, 16, 32 or 64.
/// @param[out] result    receives the forces on the lower body.
/// @return KSTRIP_OK, KSTRIP_WARNING_SPIN, or one of the errors of kstrip_solve().
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_strip_1967(
    contact: Option<&kstrip_contact>,
    creepage: Option<&kstrip_creepage>,
    strips: i32,
    result: Option<&mut MaybeUninit<kstrip_result>>,
) -> kstrip_status {
    calls::solve_by_strips(contact, creepage, strips, result, model::solve_strip_1967)
}

/// kstrip_solve() with KSTRIP_MODEL_STRIP without linking any other model.
///
/// @param[in]  contact   the loaded contact.
/// @param[in]  creepage  creepage and spin.
/// @param[in]  strips    number of strips: 4, 8, 16, 32 or 64.
/// @param[out] result    receives the forces on the lower body.
/// @return KSTRIP_OK, KSTRIP_WARNING_RANGE, or one of the errors of kstrip_solve().
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_strip(
    contact: Option<&kstrip_contact>,
    creepage: Option<&kstrip_creepage>,
    strips: i32,
    result: Option<&mut MaybeUninit<kstrip_result>>,
) -> kstrip_status {
    calls::solve_by_strips(contact, creepage, strips, result, model::solve_strip)
}

/// kstrip_solve_total() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_total_f32(
    contact: Option<&kstrip_contact_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    result: Option<&mut MaybeUninit<kstrip_result_f32>>,
) -> kstrip_status {
    calls::solve_by(contact, creepage, result, model::solve_total)
}

/// kstrip_solve_linear() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_linear_f32(
    contact: Option<&kstrip_contact_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    result: Option<&mut MaybeUninit<kstrip_result_f32>>,
) -> kstrip_status {
    calls::solve_by(contact, creepage, result, model::solve_linear)
}

/// kstrip_solve_strip_1967() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_strip_1967_f32(
    contact: Option<&kstrip_contact_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    strips: i32,
    result: Option<&mut MaybeUninit<kstrip_result_f32>>,
) -> kstrip_status {
    calls::solve_by_strips(contact, creepage, strips, result, model::solve_strip_1967)
}

/// kstrip_solve_strip() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_strip_f32(
    contact: Option<&kstrip_contact_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    strips: i32,
    result: Option<&mut MaybeUninit<kstrip_result_f32>>,
) -> kstrip_status {
    calls::solve_by_strips(contact, creepage, strips, result, model::solve_strip)
}
