//! Patches: contacts of any shape, given by their strips.

use super::support::*;
use crate::normal::cells::{CELLS, Cells, Given};
use crate::normal::{Profile, ProfileContact};
use crate::patch::{self, KSTRIP_PATCH_CAPACITY, Patch, PatchView, QuadratureScale, solver};
use heapless::Vec;

impl<F: Float> StoredPatch<F> {
    /// A patch without strips, written in place because it is large.
    fn write_empty(
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

    fn write(view: &PatchView<F>, out: &mut MaybeUninit<Self>) {
        let (shear_modulus, poisson_ratio) = (view.shear_modulus(), view.poisson_ratio());
        let patch = Self::write_empty(out, shear_modulus, poisson_ratio, view.quadrature());
        for strip in view.strips() {
            patch.push(*strip);
        }
    }
}

impl<F: Float> PatchSummary<F> {
    pub(super) fn new(view: &PatchView<F>) -> Self {
        Self {
            normal_force: view.normal_force(),
            friction_bound: view.friction_bound(),
            area: view.area() * view.quadrature().area,
            lobes: view.lobes().count() as u32,
            reserved: 0,
        }
    }
}

pub(super) fn from_contact<F: Float>(
    contact: &Contact<F>,
    options: Option<&kstrip_options>,
    out: &mut MaybeUninit<StoredPatch<F>>,
) -> Result<(), Error> {
    let count = for_strips(options)?.strips;
    let Contact { shear_modulus, poisson_ratio, .. } = *contact;
    if contact.is_lost() {
        contact.check()?;
        let none = PatchView::new(&[], shear_modulus, poisson_ratio, QuadratureScale::default())?;
        StoredPatch::write(&none, out);
        return Ok(());
    }
    patch::check_ellipse(contact, count)?;
    let scale = QuadratureScale::default();
    let stored = StoredPatch::write_empty(out, shear_modulus, poisson_ratio, scale);
    stored.mismatch = contact.mismatch;
    let scale = patch::ellipse(contact, count, |strip| stored.push(strip))?;
    (stored.area_scale, stored.lever_scale) = (scale.area, scale.lever);
    Ok(())
}

pub(super) fn from_strips<F: Float>(
    strips: &[PatchStrip<F>],
    shear_modulus: F,
    poisson_ratio: F,
    out: &mut MaybeUninit<StoredPatch<F>>,
) -> Result<(), Error> {
    Error::PatchSize.unless(strips.len() <= KSTRIP_PATCH_CAPACITY)?;
    match PatchView::new(strips, shear_modulus, poisson_ratio, QuadratureScale::default()) {
        Ok(view) => StoredPatch::write(&view, out),
        Err(Error::StripOrder) => sorted(strips, shear_modulus, poisson_ratio, out)?,
        Err(error) => return Err(error),
    }
    Ok(())
}

/// Sorts strips of any order into a patch. Out of line, because it has a copy on the stack.
#[inline(never)]
fn sorted<F: Float>(
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

/// # Safety
/// Every pointer is NULL, or valid for as many elements as there are points while the profile
/// lives.
pub(super) unsafe fn profile_of<'a, F: Float>(
    points: &ProfilePoints<F>,
) -> Result<Profile<'a, F>, Error> {
    let ProfilePoints { y, distance, centre_x, rolling_radius, points, .. } = *points;
    // SAFETY: the caller's promise.
    let list = |pointer: *const F| unsafe { input(pointer, points) };
    let mut profile = Profile::new(list(y)?, list(distance)?)?;
    if !centre_x.is_null() {
        profile = profile.with_centre_x(list(centre_x)?)?;
    }
    if !rolling_radius.is_null() {
        profile = profile.with_rolling_radius(list(rolling_radius)?)?;
    }
    Ok(profile)
}

pub(super) fn from_profile<F: Float>(
    profile: &Profile<F>,
    options: &ProfileOptions<F>,
    out: &mut MaybeUninit<StoredPatch<F>>,
) -> Result<Indentation<F>, Error> {
    let ProfileOptions { rolling_radius, normal_force, shear_modulus, .. } = *options;
    let ProfileOptions { poisson_ratio, friction, approach, smoothing_length, .. } = *options;
    // (the approach counts only where there is no load)
    let by_load = normal_force != F::zero() || approach == F::zero();
    let given = if by_load { Given::Load(normal_force) } else { Given::Approach(approach) };
    let contact = ProfileContact {
        rolling_radius,
        given,
        shear_modulus,
        poisson_ratio,
        friction,
        smoothing_length,
    };
    let count = strip_count(options.strips)?;
    let mut list = Vec::<_, CELLS>::new();
    let mut cells = Cells { list: list.as_mut_view() };
    let mut found = Indentation::new(profile, &contact, count, &mut cells)?;
    of_cells(&contact, &cells, &mut found, out)?;
    Ok(found)
}

/// Writes the patch of cells. (Out of line, so that it takes room on the stack only when they are
/// solved.)
#[inline(never)]
fn of_cells<F: Float>(
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
