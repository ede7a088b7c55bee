//! Solve: forces, derivatives, strips of one contact.

use super::support::*;

impl<F: Float> Outputs<F> {
    /// Whether an output is requested that needs derivatives.
    pub(super) fn differentiates(&self) -> bool {
        !(self.derivatives.is_null() && self.law_derivatives.is_null())
    }

    /// Writes all requested outputs but the strips.
    ///
    /// # Safety
    /// Every pointer is NULL, or valid and aligned for one write; no two overlap.
    pub(super) unsafe fn write(
        &self,
        solution: &Solution<F>,
        friction: F,
        slopes: Option<(&Derivatives<F>, &LawDerivatives<F>)>,
    ) {
        // SAFETY: the caller's promise.
        unsafe {
            put(place(self.result), *solution);
            put(place(self.friction), friction);
            if let Some((derivatives, law)) = slopes {
                put_by_halves(place(self.derivatives), derivatives);
                put_by_halves(place(self.law_derivatives), law);
            }
        }
    }

    /// Writes the strips and their number, if they are requested and there is room for `most`.
    ///
    /// # Safety
    /// The pointers are NULL, or valid and aligned, that of the strips for `capacity` writes.
    pub(super) unsafe fn write_strips(
        &self,
        most: usize,
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
pub(super) unsafe fn evaluate<F: Float>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    law: Option<&SlipFriction<F>>,
    options: Option<&kstrip_options>,
    outputs: &Outputs<F>,
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
        let stiffness = law.map_or(F::one(), SlipFriction::slope_or_one);
        let shear_modulus = contact.shear_modulus * stiffness;
        let contact = &Contact { friction, shear_modulus, ..*contact };
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
unsafe fn evaluate_strips<F: Float>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    law: Option<&SlipFriction<F>>,
    options: Option<&kstrip_options>,
    outputs: &Outputs<F>,
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
