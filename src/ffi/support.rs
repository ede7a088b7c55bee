//! Shared helpers of the exported functions, and the names that these use.

pub(super) use super::arrays::{
    Strided, each_element, element, input, is_aligned, output, place, read,
};
use super::constants::KSTRIP_MODEL_DEFAULT;
pub(super) use super::constants::{
    KSTRIP_FIT_DECAY, KSTRIP_FIT_FRICTION, KSTRIP_FIT_LAYER, KSTRIP_FIT_RATIO,
    KSTRIP_FIT_SLIDE_FACTOR, KSTRIP_FIT_SLOPE_FACTOR,
};
pub(super) use super::constants::{KSTRIP_MEASURED_FX, KSTRIP_MEASURED_FY};
pub(super) use super::types::*;
pub(super) use crate::contact::creepage::{Creepage, Parameters, SurfaceVelocity};
pub(super) use crate::contact::hertz::{HertzContact, Radii};
pub(super) use crate::contact::material::{self, CombinedMaterial, Material};
pub(super) use crate::contact::totals::StripCount;
pub(super) use crate::contact::{Contact, from_approach, from_hertz};
pub(super) use crate::forces::derivatives::Derivatives;
pub(super) use crate::forces::field::FieldPoint;
pub(super) use crate::forces::prepared::Prepared;
pub(super) use crate::forces::theory::{
    EllipseStrips, Linear, Strip1967, Total, solution_of, write_forces,
};
pub(super) use crate::forces::{self, Model, Options, Solution, StripResult};
pub(super) use crate::friction::derivatives::{LawDerivatives, differentiate_with_law};
pub(super) use crate::friction::field::LawField;
pub(super) use crate::friction::{self, SlipFriction};
pub(super) use crate::linear::LinearCoefficients;
pub(super) use crate::motion::{self, Motion};
pub(super) use crate::normal::Indentation;
pub(super) use crate::number::{Float, are_finite};
pub(super) use crate::patch::PatchStrip;
pub(super) use crate::patch::field::PatchField;
pub(super) use crate::rig::fit::{Fitted, FrictionFit, MeasuredForce};
pub(super) use crate::rig::{self, FrictionEstimate, Measured};
pub(super) use crate::status::{Error, Warning, kstrip_status};
pub(super) use crate::wheel_rail::contacts::{self, WheelContact};
pub(super) use crate::wheel_rail::scene::Workspace;
pub(super) use crate::wheel_rail::surface::Surface;
pub(super) use crate::wheel_rail::touch::{self, Gap};
pub(super) use crate::wheel_rail::wrench::{self, Wrench, WrenchByPosition, WrenchDerivatives};
pub(super) use crate::wheel_rail::{KSTRIP_CONTACTS_CAPACITY, Position, Velocity, WheelPair};
pub(super) use crate::wheelset::forces::{
    WheelsetByPosition, WheelsetDerivatives, WheelsetForces, WheelsetWorkspace,
};
pub(super) use crate::wheelset::settle::WheelsetLoads;
pub(super) use crate::wheelset::track::Curve;
pub(super) use core::mem::MaybeUninit;

/// Runs a function that may fail, and returns its status.
#[inline]
pub(super) fn answer(body: impl FnOnce() -> Result<Warning, Error>) -> kstrip_status {
    match body() {
        Ok(warning) => warning.code(),
        Err(error) => error.code(),
    }
}

/// Writes the result of a function to its one output, which is required.
#[inline]
pub(super) fn fill<T>(place: Output<T>, find: impl FnOnce() -> Result<T, Error>) -> kstrip_status {
    answer(|| {
        given(place)?.write(find()?);
        Ok(Warning::None)
    })
}

/// The same for a solution, whose warning is the status.
#[inline]
pub(super) fn solved<F: Float>(
    place: Output<Solution<F>>,
    solve: impl FnOnce() -> Result<Solution<F>, Error>,
) -> kstrip_status {
    answer(|| {
        let place = given(place)?;
        // By reference: avoids a copy of 200 bytes on the stack.
        let found = solve();
        Ok(place.write(*given_by(&found)?).warning)
    })
}

/// A required argument.
#[inline]
pub(super) fn given<T>(argument: Option<T>) -> Result<T, Error> {
    argument.ok_or(Error::NullPointer)
}

/// The caller's options for forces; NULL and zero mean the defaults.
#[inline]
pub(super) fn for_forces(options: Option<&kstrip_options>) -> Result<Options, Error> {
    with_default(options, Model::Total)
}

/// The caller's options for strips or fields.
#[inline]
pub(super) fn for_strips(options: Option<&kstrip_options>) -> Result<Options, Error> {
    with_default(options, Model::Strip)
}

#[inline]
fn with_default(options: Option<&kstrip_options>, default: Model) -> Result<Options, Error> {
    let kstrip_options { model, strips } = options.copied().unwrap_or_default();
    let is_default = model == KSTRIP_MODEL_DEFAULT;
    let model = if is_default { default as i32 } else { model };
    let model = Model::from_number(model).ok_or(Error::Model)?;
    Ok(Options { model, strips: strip_count(strips)? })
}

/// A number of strips; 0: the default.
#[inline]
pub(super) fn strip_count(strips: i32) -> Result<StripCount, Error> {
    if strips == 0 {
        Ok(StripCount::default())
    } else {
        StripCount::from_number(strips).ok_or(Error::StripCount)
    }
}

/// A result by reference.
#[inline]
pub(super) fn given_by<T>(found: &Result<T, Error>) -> Result<&T, Error> {
    found.as_ref().map_err(|error| *error)
}

/// A requested output.
pub(super) type Output<'a, T> = Option<&'a mut MaybeUninit<T>>;

/// Writes an output if it is requested.
#[inline]
pub(super) fn put<T>(place: Output<T>, value: T) {
    if let Some(place) = place {
        place.write(value);
    }
}

/// The same for many numbers. On a microcontroller a copy of more than 64 bytes is a call.
#[inline]
pub(super) fn put_by_halves<T: Copy>(place: Output<T>, value: &T) {
    let Some(place) = place else { return };
    let (from, to) = (core::ptr::from_ref(value).cast::<u8>(), place.as_mut_ptr().cast::<u8>());
    let half = size_of::<T>() / 8 * 4;
    // SAFETY: both halves lie within the value and the place, which do not overlap.
    unsafe {
        core::ptr::copy_nonoverlapping(from, to, half);
        core::ptr::copy_nonoverlapping(from.add(half), to.add(half), size_of::<T>() - half);
    }
}
