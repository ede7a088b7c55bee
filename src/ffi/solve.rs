//! Solve: forces, derivatives, strips of one contact.

use super::support::*;

/// Forces of a contact in motion, on the lower body: the fast path.
///
/// The forces are continuous in all inputs, and |F| <= mu N. They are zero where creepage and spin are zero, and where the contact is
/// lost (normal_force <= 0), with adhesion 0. The time is bounded: every iteration has a largest number of steps.
///
/// @param contact         ellipse, load, material, friction.
/// @param creepage        motion.
/// @param options         model and strip count; NULL for the defaults.
/// @param[out] result     receives forces, moment, power and adhesion.
/// @return KSTRIP_OK; KSTRIP_WARNING_SPIN, KSTRIP_WARNING_RANGE, KSTRIP_WARNING_AXIS_RATIO, KSTRIP_WARNING_MISMATCH,
///         KSTRIP_WARNING_MISMATCH_NEGLECTED, KSTRIP_WARNING_BEYOND_FRICTION,
///         KSTRIP_WARNING_PRESSURE, KSTRIP_WARNING_CREEPAGE, KSTRIP_WARNING_SEMI_AXIS,
///         KSTRIP_WARNING_SPIN_UNIT, KSTRIP_WARNING_FRICTION;
///         KSTRIP_ERROR_NULL, KSTRIP_ERROR_NOT_FINITE, KSTRIP_ERROR_SEMI_AXIS, KSTRIP_ERROR_MODULUS,
///         KSTRIP_ERROR_POISSON_RATIO, KSTRIP_ERROR_FRICTION, KSTRIP_ERROR_MODEL,
///         KSTRIP_ERROR_STRIP_COUNT, KSTRIP_ERROR_OVERFLOW.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve(
    contact: Option<&Contact<f64>>,
    creepage: Option<&Creepage<f64>>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<Solution<f64>>>,
) -> kstrip_status {
    solved(result, || model::solve(given(contact)?, given(creepage)?, &for_forces(options)?))
}

/// Computes, for a contact in motion, every output that is not NULL.
///
/// If friction is given, the coefficient of friction falls with the slip and agrees with it; the contact's own coefficient is ignored. All
/// derivatives include that dependence. Where more than one friction agrees with its slip, the status is KSTRIP_WARNING_SEVERAL_FRICTIONS
/// and the result has the largest. The two models of 1967 are an exception under friction that falls very steeply: their forces jump, or
/// nearly jump, where a first strip begins to adhere, and in about one of a thousand such cases another friction, perhaps a larger one, is
/// not found.
/// With KSTRIP_MODEL_DEFAULT strips are those of KSTRIP_MODEL_STRIP.
///
/// @param contact         ellipse, load, material, friction.
/// @param creepage        motion.
/// @param friction        friction that falls with the slip; NULL: constant.
/// @param options         model and strip count; NULL for the defaults.
/// @param outputs         where the outputs go.
/// @return as kstrip_solve(); KSTRIP_WARNING_SEVERAL_FRICTIONS, KSTRIP_WARNING_NOT_CONVERGED; KSTRIP_ERROR_CAPACITY,
///         KSTRIP_ERROR_NOT_IN_MODEL (strips), KSTRIP_ERROR_FRICTION_RATIO, KSTRIP_ERROR_FRICTION_DECAY,
///         KSTRIP_ERROR_NEGATIVE_SPEED, KSTRIP_ERROR_SLOPE_FACTOR; KSTRIP_ERROR_OVERFLOW also when a
///         derivative is too large.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_evaluate(
    contact: Option<&Contact<f64>>,
    creepage: Option<&Creepage<f64>>,
    friction: Option<&SlipFriction<f64>>,
    options: Option<&kstrip_options>,
    outputs: Option<&Outputs<f64>>,
) -> kstrip_status {
    // SAFETY: every pointer is NULL or valid, says the header.
    let places = outputs.map(|outputs| unsafe { Places::of(outputs) });
    answer(|| evaluate(given(contact)?, given(creepage)?, friction, options, given(places)?))
}

/// Computes what depends on the contact and the options only, for kstrip_solve_prepared().
///
/// Use this for rigs whose contact is constant, and for iterations on the creepage. The structure contains a checksum of its numbers:
/// kstrip_solve_prepared() refuses a structure whose numbers have changed, or one of the other precision.
///
/// @param contact         ellipse, load, material, friction.
/// @param options         model and strip count; NULL for the defaults.
/// @param[out] prepared   receives the prepared contact.
/// @return as kstrip_solve().
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_prepare(
    contact: Option<&Contact<f64>>,
    options: Option<&kstrip_options>,
    prepared: Option<&mut MaybeUninit<PreparedNumbers<f64>>>,
) -> kstrip_status {
    fill(prepared, || {
        let prepared = Prepared::new(given(contact)?, &for_forces(options)?)?;
        Ok(PreparedNumbers::of(&prepared))
    })
}

/// kstrip_solve() for a prepared contact: the same result, bit for bit.
///
/// @param prepared        by kstrip_prepare().
/// @param creepage        motion.
/// @param[out] result     receives forces, moment, power and adhesion.
/// @return as kstrip_solve(); KSTRIP_ERROR_NOT_PREPARED.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_prepared(
    prepared: Option<&PreparedNumbers<f64>>,
    creepage: Option<&Creepage<f64>>,
    result: Option<&mut MaybeUninit<Solution<f64>>>,
) -> kstrip_status {
    solved(result, || given(prepared)?.solve(given(creepage)?))
}

/// Forces of a contact that rolls forward, backward, or not at all, with derivatives by its motion: for wheels that stop,
/// hold and reverse.
///
/// The creepages are slip over sqrt(rolling_speed^2 + floor_speed^2). Far from standstill the leading edge of the patch lies ahead, in the
/// direction of the motion. Near standstill the results of both directions are blended, so that forces and derivatives are continuous.
/// Friction opposes the slip at every speed. The axis x keeps its direction when the motion reverses.
///
/// @param contact         ellipse, load, material, friction.
/// @param motion          slip, spin rate, signed rolling speed.
/// @param friction        friction that falls with the slip; NULL: constant. Its rolling_speed does not count.
/// @param options         model and strip count; NULL for the defaults.
/// @param outputs         where the outputs go.
/// @return as kstrip_evaluate(); KSTRIP_ERROR_FLOOR_SPEED.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_solve_motion(
    contact: Option<&Contact<f64>>,
    motion: Option<&Motion<f64>>,
    friction: Option<&SlipFriction<f64>>,
    options: Option<&kstrip_options>,
    outputs: Option<&MotionOutputs<f64>>,
) -> kstrip_status {
    // SAFETY: every pointer is NULL or valid, says the header.
    answer(|| unsafe {
        solve_motion(given(contact)?, given(motion)?, friction, options, given(outputs)?)
    })
}

/// kstrip_solve() with KSTRIP_MODEL_TOTAL; a program that calls only this links no other model.
///
/// @return as kstrip_solve().
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_total(
    contact: Option<&Contact<f64>>,
    creepage: Option<&Creepage<f64>>,
    result: Option<&mut MaybeUninit<Solution<f64>>>,
) -> kstrip_status {
    solved(result, || Total::solve(given(contact)?, given(creepage)?, &Options::default()))
}

/// kstrip_solve() with KSTRIP_MODEL_STRIP; a program that calls only this links no other model.
///
/// @param strips          4, 8, 16, 32 or 64; 0: 16.
/// @return as kstrip_solve().
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_strip(
    contact: Option<&Contact<f64>>,
    creepage: Option<&Creepage<f64>>,
    strips: i32,
    result: Option<&mut MaybeUninit<Solution<f64>>>,
) -> kstrip_status {
    solved(result, || {
        let options = Options { strips: strip_count(strips)?, ..Options::default() };
        Strip::solve(given(contact)?, given(creepage)?, &options)
    })
}

/// kstrip_solve() with KSTRIP_MODEL_STRIP_1967; a program that calls only this links no other model.
///
/// @param strips          4, 8, 16, 32 or 64; 0: 16.
/// @return as kstrip_solve().
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_strip_1967(
    contact: Option<&Contact<f64>>,
    creepage: Option<&Creepage<f64>>,
    strips: i32,
    result: Option<&mut MaybeUninit<Solution<f64>>>,
) -> kstrip_status {
    solved(result, || {
        let options = Options { strips: strip_count(strips)?, ..Options::default() };
        Strip1967::<false>::solve(given(contact)?, given(creepage)?, &options)
    })
}

/// kstrip_solve() with KSTRIP_MODEL_LINEAR; a program that calls only this links no other model.
///
/// @return as kstrip_solve().
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_linear(
    contact: Option<&Contact<f64>>,
    creepage: Option<&Creepage<f64>>,
    result: Option<&mut MaybeUninit<Solution<f64>>>,
) -> kstrip_status {
    solved(result, || Linear::solve(given(contact)?, given(creepage)?, &Options::default()))
}

/// The same result seen from the upper body: opposite forces and moment, same power and adhesion.
///
/// @param lower           result on the lower body.
/// @param[out] upper      receives the result on the upper body.
/// @return KSTRIP_OK or KSTRIP_ERROR_NULL.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_result_on_upper_body(
    lower: Option<&MaybeUninit<Solution<f64>>>,
    upper: Option<&mut MaybeUninit<Solution<f64>>>,
) -> kstrip_status {
    answer(|| {
        let (lower, upper) = (given(lower)?, given(upper)?);
        *upper = *lower;
        let upper = upper.as_mut_ptr();
        // SAFETY: the three numbers are there, whatever bits they have; the rest is only copied.
        let forces = unsafe { [&mut (*upper).fx, &mut (*upper).fy, &mut (*upper).mz] };
        for force in forces {
            *force = -*force;
        }
        Ok(Notice::None)
    })
}

/// Strips, and a place for their number.
type StripPlaces<'a, F> = (&'a mut [MaybeUninit<StripResult<F>>], Place<'a, u32>);

/// The wanted outputs.
pub(super) struct Places<'a, F: Precision> {
    pub(super) result: Place<'a, Solution<F>>,
    pub(super) derivatives: Place<'a, Derivatives<F>>,
    pub(super) law_derivatives: Place<'a, LawDerivatives<F>>,
    pub(super) friction: Place<'a, F>,
    pub(super) strips: Option<StripPlaces<'a, F>>,
}

impl<F: Precision> Places<'_, F> {
    /// # Safety
    /// Every pointer is NULL, or valid and aligned for one write, that of the strips for `capacity`; no two overlap.
    pub(super) unsafe fn of(outputs: &Outputs<F>) -> Self {
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

    /// Whether anything is wanted that needs derivatives.
    pub(super) fn differentiates(&self) -> bool {
        self.derivatives.is_some() || self.law_derivatives.is_some()
    }
}

pub(super) fn evaluate<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    law: Option<&SlipFriction<F>>,
    options: Option<&kstrip_options>,
    places: Places<F>,
) -> Result<Notice, Error> {
    let (forces, inside) = (for_forces(options)?, for_strips(options)?);
    // (what was found is read where it stands)
    let (differentiated, under_law, alone);
    let (solution, friction, slopes) = if places.differentiates() {
        differentiated = differentiate(contact, creepage, law, &forces);
        let found = given_by(&differentiated)?;
        (&found.solution, found.friction, Some((&found.derivatives, &found.law)))
    } else if let Some(law) = law {
        under_law = friction::solve(contact, creepage, law, &forces);
        let found = given_by(&under_law)?;
        (&found.solution, found.friction, None)
    } else {
        alone = model::solve(contact, creepage, &forces);
        (given_by(&alone)?, contact.friction, None)
    };
    let mut notice = solution.notice;
    if let Some(strips) = places.strips {
        let stiffness = law.map_or(F::one(), SlipFriction::stiffness);
        let shear_modulus = contact.shear_modulus * stiffness;
        let contact = Contact { friction, shear_modulus, ..*contact };
        notice = notice.worse(write_strips(&contact, creepage, &inside, strips)?);
    }
    put(places.result, *solution);
    put(places.friction, friction);
    if let Some((derivatives, law)) = slopes {
        put(places.derivatives, *derivatives);
        put(places.law_derivatives, *law);
    }
    Ok(notice)
}

/// Writes the strips and how many they are, if there is room for all.
#[inline(never)]
fn write_strips<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
    (strips, count): StripPlaces<F>,
) -> Result<Notice, Error> {
    let count = given(count)?;
    Error::Capacity.unless(model::strips_of(contact, creepage, options)? <= strips.len())?;
    let mut places = strips.iter_mut();
    let mut written = 0_u32;
    let notice = model::strips(contact, creepage, options, &mut |strip| {
        if let Some(place) = places.next() {
            place.write(strip);
            written += 1;
        }
    })?;
    count.write(written);
    Ok(notice)
}

/// # Safety
/// Every pointer of the outputs is NULL, or valid and aligned for one write; no two overlap.
pub(super) unsafe fn solve_motion<F: Precision>(
    contact: &Contact<F>,
    motion: &Motion<F>,
    law: Option<&SlipFriction<F>>,
    options: Option<&kstrip_options>,
    outputs: &MotionOutputs<F>,
) -> Result<Notice, Error> {
    let options = for_forces(options)?;
    // SAFETY: the caller's promise.
    let (result, used) = unsafe { (place(outputs.result), place(outputs.friction)) };
    // SAFETY: as before.
    let derivatives = unsafe { place(outputs.derivatives) };
    let (solution, friction) = if let Some(place) = derivatives {
        let (solution, friction, slopes) = motion::differentiate(contact, motion, law, &options)?;
        place.write(slopes);
        (solution, friction)
    } else {
        motion::solve(contact, motion, law, &options)?
    };
    put(result, solution);
    put(used, friction);
    Ok(solution.notice)
}
