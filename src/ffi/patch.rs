//! Patches: contacts of any shape, given by their strips.

use super::support::*;
use crate::normal::ProfileContact;
use crate::normal::cells::{CELLS, Cells};
use crate::patch::{self, KSTRIP_PATCH_CAPACITY, Patch, PatchView, QuadratureScale, solver};

impl<F: Float> StoredPatch<F> {
    /// A patch without strips, written in place because it is large.
    pub(super) fn write_empty(
        out: &mut MaybeUninit<Self>,
        shear_modulus: F,
        poisson_ratio: F,
        scale: QuadratureScale<F>,
    ) -> &mut Self {
        // SAFETY: all bits zero are a structure of numbers.
        let patch = unsafe {
            out.as_mut_ptr().write_bytes(0, 1);
            out.assume_init_mut()
        };
        (patch.shear_modulus, patch.poisson_ratio) = (shear_modulus, poisson_ratio);
        (patch.area_scale, patch.lever_scale) = (scale.area, scale.lever);
        patch
    }

    pub(super) fn write(view: &PatchView<F>, out: &mut MaybeUninit<Self>) {
        let (shear_modulus, poisson_ratio) = (view.shear_modulus(), view.poisson_ratio());
        let patch = Self::write_empty(out, shear_modulus, poisson_ratio, view.quadrature());
        for strip in view.strips() {
            patch.push(*strip);
        }
    }
}

/// Sorts strips of any order into a patch. Out of line, because it has a copy on the stack.
#[inline(never)]
pub(super) fn sorted<F: Float>(
    strips: &[PatchStrip<F>],
    shear_modulus: F,
    poisson_ratio: F,
    out: &mut MaybeUninit<StoredPatch<F>>,
) -> Result<(), Error> {
    let patch =
        Patch::<_, KSTRIP_PATCH_CAPACITY>::from_strips(strips, shear_modulus, poisson_ratio)?;
    StoredPatch::write(&patch.view()?, out);
    Ok(())
}

/// Writes the patch of cells. (Out of line, so that it takes room on the stack only when they are
/// solved.)
#[inline(never)]
pub(super) fn of_cells<F: Float>(
    contact: &ProfileContact<F>,
    cells: &Cells<F, 1>,
    found: &mut Indentation<F>,
    out: &mut MaybeUninit<StoredPatch<F>>,
) -> Result<(), Error> {
    // One strip for each cell in contact.
    let patch = Patch::<_, CELLS>::of_cells(contact, cells, found)?;
    StoredPatch::write(&patch.view()?, out);
    Ok(())
}

/// # Safety
/// Every pointer of the outputs is NULL, or valid and aligned for one write, that of the strips for
/// `capacity`; no two overlap.
pub(super) unsafe fn evaluate_patch<F: Float>(
    patch: &StoredPatch<F>,
    (creepage, own): (&Creepage<F>, &[Creepage<F>]),
    law: Option<&SlipFriction<F>>,
    options: Option<&kstrip_options>,
    outputs: &Outputs<F>,
) -> Result<Warning, Error> {
    let model = for_strips(options)?.model;
    let mut view = patch.view()?;
    if !own.is_empty() {
        view = view.with_own_creepages(own)?;
    }
    let differentiated;
    let (solution, share, slopes) = if outputs.differentiates() {
        differentiated = patch::friction::differentiate_patch(&view, creepage, law, model)?;
        let found = &differentiated;
        (found.solution, found.friction, Some((&found.derivatives, &found.law)))
    } else if let Some(law) = law {
        let found = patch::friction::solve_patch_with_law(&view, creepage, law, model)?;
        (found.solution, found.share, None)
    } else {
        (solver::solve_patch(&view, creepage, model)?, F::one(), None)
    };
    // SAFETY: the caller's promise.
    unsafe {
        if !outputs.strips.is_null() {
            outputs.write_strips(view.strips().len(), |mut visit| {
                patch::friction::patch_strips_with_law(
                    &view, creepage, law, share, model, &mut visit,
                )
            })?;
        }
        outputs.write(&solution, share, slopes);
    }
    Ok(solution.warning)
}
