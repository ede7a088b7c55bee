//! Warnings about a valid result.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::contact::implausibility;
use crate::forces::options::Model;
use crate::number::Float;
use crate::status::Warning;

/// The warning of a model with a friction bound, or that an input is implausible.
pub(crate) fn warning_of<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, model: Model, psi: F,
) -> Warning {
    warned(contact, creepage, saturating_warning(model, contact, contact.a / contact.b, psi))
}

/// The more serious of a warning of the model and a warning that an input is implausible.
#[cold]
#[inline(never)]
pub(crate) fn warned<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, warning: Warning,
) -> Warning {
    warning.worse(implausibility(contact, creepage))
}

/// [`model_warning`], or that the theory of 1967 neglects the mismatch of the materials.
#[inline]
pub(crate) fn saturating_warning<F: Float>(
    model: Model, contact: &Contact<F>, ratio: F, psi: F,
) -> Warning {
    let neglects = model.is_of_1967() && contact.mismatch != F::zero();
    let of_mismatch = if neglects { Warning::MismatchNeglected } else { Warning::None };
    model_warning(model, contact.friction_bound(), ratio, psi).worse(of_mismatch)
}

/// The warning of the linear theory.
#[inline]
pub(crate) fn linear_warning<F: Float>(size: F, friction_bound: F) -> Warning {
    if size > friction_bound { Warning::BeyondFriction } else { Warning::None }
}

/// Range of the axis ratio for which [`Model::Strip`] and [`Model::Total`] are made, slightly
/// widened because quotients are rounded.
pub(crate) const RATIOS: [f64; 2] = [0.014_999_9, 60.000_1];
/// Largest spin `|ψ|` for which [`Model::Strip`] is made.
pub(crate) const LARGEST_SPIN: f64 = 3.0;

#[inline]
pub(crate) fn model_warning<F: Float>(
    model: Model, friction_bound: F, ratio: F, psi: F,
) -> Warning {
    if friction_bound <= F::zero() {
        // Without load or friction zero forces are right in every model with a friction bound.
        return Warning::None;
    }
    match model {
        Model::Strip1967 | Model::Strip1967Continuous if psi.abs() >= F::one() => {
            Warning::SpinBeyondTheory
        }
        Model::Total | Model::Strip
            if ratio < F::constant(RATIOS[0]) || ratio > F::constant(RATIOS[1]) =>
        {
            Warning::AxisRatio
        }
        // TOTAL has the right limit for large spin.
        Model::Strip if psi.abs() > F::constant(LARGEST_SPIN) => Warning::OutsideRange,
        _ => Warning::None,
    }
}
