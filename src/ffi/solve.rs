//! Solve: forces, derivatives, strips of one contact.

use super::support::*;

/// The array for the strips, and the place for their number.
type StripOutputs<'a, F> = (&'a mut [MaybeUninit<StripResult<F>>], Output<'a, u32>);

/// The requested outputs.
pub(super) struct OutputPlaces<'a, F: Float> {
    pub(super) result: Output<'a, Solution<F>>,
    pub(super) derivatives: Output<'a, Derivatives<F>>,
    pub(super) law_derivatives: Output<'a, LawDerivatives<F>>,
    pub(super) friction: Output<'a, F>,
    pub(super) strips: Option<StripOutputs<'a, F>>,
}

impl<F: Float> OutputPlaces<'_, F> {
    /// # Safety
    /// Every pointer is NULL, or valid and aligned for one write, that of the strips for
    /// `capacity`; no two overlap.
    pub(super) unsafe fn new(outputs: &Outputs<F>) -> Self {
        // SAFETY: the caller's promise.
        unsafe {
            Self {
                result: place(outputs.result),
                derivatives: place(outputs.derivatives),
                law_derivatives: place(outputs.law_derivatives),
                friction: place(outputs.friction),
                strips: if outputs.strips.is_null() {
                    None
                } else {
                    let strips = output(outputs.strips, outputs.capacity).unwrap_or(&mut []);
                    Some((strips, place(outputs.count)))
                },
            }
        }
    }

    /// Whether an output is requested that needs derivatives.
    pub(super) fn differentiates(&self) -> bool {
        self.derivatives.is_some() || self.law_derivatives.is_some()
    }
}

pub(super) fn evaluate<F: Float>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    law: Option<&SlipFriction<F>>,
    options: Option<&kstrip_options>,
    places: OutputPlaces<F>,
) -> Result<Warning, Error> {
    let forces = for_forces(options)?;
    // By reference: avoids a copy of 200 bytes on the stack.
    let (differentiated, under_law, nothing, alone);
    let (solution, friction, slopes) = if places.differentiates() {
        differentiated = differentiate_with_law(contact, creepage, law, &forces);
        let found = given_by(&differentiated)?;
        (&found.solution, found.friction, Some((&found.derivatives, &found.law)))
    } else if let Some(law) = law {
        under_law = friction::solve_with_law(contact, creepage, law, &forces);
        let found = given_by(&under_law)?;
        (&found.solution, found.friction, None)
    } else if places.result.is_none() && places.strips.is_some() {
        // The strips have the errors and the warnings of the forces.
        nothing = Solution::nothing();
        (&nothing, contact.friction, None)
    } else {
        alone = forces::forces_of_contact(contact, creepage, &forces);
        (given_by(&alone)?, contact.friction, None)
    };
    let mut warning = solution.warning;
    if let Some(strips) = places.strips {
        let stiffness = law.map_or(F::one(), SlipFriction::slope_or_one);
        let shear_modulus = contact.shear_modulus * stiffness;
        let contact = Contact { friction, shear_modulus, ..*contact };
        let inside = for_strips(options)?;
        warning = warning.worse(write_strips(&contact, creepage, law, &inside, strips)?);
    }
    put(places.result, *solution);
    put(places.friction, friction);
    if let Some((derivatives, law)) = slopes {
        put_by_halves(places.derivatives, derivatives);
        put_by_halves(places.law_derivatives, law);
    }
    Ok(warning)
}

/// Writes the strips and their number, if there is room for all.
#[inline(never)]
fn write_strips<F: Float>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    law: Option<&SlipFriction<F>>,
    options: &Options,
    (strips, count): StripOutputs<F>,
) -> Result<Warning, Error> {
    let count = given(count)?;
    // Without load there are fewer strips.
    if options.strips as usize > strips.len() {
        Error::Capacity.unless(forces::strips_of(contact, creepage, options)? <= strips.len())?;
    }
    let mut places = strips.iter_mut();
    let mut written = 0_u32;
    let warning = friction::strips_with_law(contact, creepage, law, options, &mut |strip| {
        if let Some(place) = places.next() {
            place.write(strip);
            written += 1;
        }
    })?;
    count.write(written);
    Ok(warning)
}

/// # Safety
/// Every pointer of the outputs is NULL, or valid and aligned for one write; no two overlap.
pub(super) unsafe fn write_motion<F: Float>(
    contact: &Contact<F>,
    motion: &Motion<F>,
    law: Option<&SlipFriction<F>>,
    options: Option<&kstrip_options>,
    outputs: &MotionOutputs<F>,
) -> Result<Warning, Error> {
    let options = for_forces(options)?;
    // SAFETY: the caller's promise.
    let (result, used) = unsafe { (place(outputs.result), place(outputs.friction)) };
    // SAFETY: as before.
    let derivatives = unsafe { place(outputs.derivatives) };
    let (solution, friction) = if let Some(place) = derivatives {
        let (solution, friction, slopes) =
            motion::differentiate_motion(contact, motion, law, &options)?;
        place.write(slopes);
        (solution, friction)
    } else {
        motion::solve_motion(contact, motion, law, &options)?
    };
    put(result, solution);
    put(used, friction);
    Ok(solution.warning)
}
