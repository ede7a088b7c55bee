//! Many contacts for C: a pointer and a distance in bytes for each quantity.

use super::F;
use crate::ffi::batch::*;
use crate::ffi::support::*;

/// kstrip_evaluate() for many contacts: the same results, bit for bit.
///
/// Where the processor has AVX several contacts are solved side by side. All inputs are checked
/// before anything is written: if one is bad its status is returned, no output is touched, and
/// first_bad receives its index. A lost contact is not bad: its results are zero.
///
/// With more than one contact an output's stride is at least the size of the output, forward or
/// backward, and every stride is a multiple of the alignment of its type: anything else is
/// KSTRIP_ERROR_STRIDE. Whether the pointers themselves are aligned is not checked: misaligned ones
/// are undefined behaviour, as in C.
///
/// @param inputs          contacts, creepages, falling friction.
/// @param count           how many; 0 is allowed.
/// @param options         for all contacts; NULL for the defaults.
/// @param outputs         where the outputs go; they must not overlap the inputs or each other.
/// @param[out] first_bad  receives the index of the first bad contact, or count where none is bad;
///                        NULL: not needed.
/// @return KSTRIP_OK, the most serious warning, or the first error, as kstrip_evaluate();
///         KSTRIP_ERROR_STRIDE.
#[unsafe(export_name = symbol!("kstrip_evaluate_batch"))]
pub unsafe extern "C" fn kstrip_evaluate_batch(
    inputs: Option<&BatchInputs<F>>,
    count: u32,
    options: Option<&kstrip_options>,
    outputs: Option<&BatchOutputs<F>>,
    first_bad: Option<&mut MaybeUninit<u32>>,
) -> kstrip_status {
    // SAFETY: every pointer is NULL, or valid for count elements at its distances, says the header.
    answer(|| unsafe {
        Batch {
            inputs: given(inputs)?,
            count,
            outputs: given(outputs)?,
            options: for_forces(options)?,
        }
        .solve(first_bad)
    })
}
