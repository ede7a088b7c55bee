//! What the caller should know about a valid result.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::contact::warning;
use crate::number::{Float, length};
use crate::solve::options::Model;
use crate::status::Notice;

/// Friction bound above which its square has all digits \[N\].
const TOLD_BY_SQUARES: f64 = 1e-12;

/// [`linear_notice`] of a force. Where the squares of force and bound are far enough apart, no root is needed.
#[inline]
pub(crate) fn linear_notice_of<F: Float>(fx: F, fy: F, bound: F) -> Notice {
    let (square, limit) = (fx * fx + fy * fy, bound * bound);
    if bound > F::constant(TOLD_BY_SQUARES) {
        if square < limit.times(0.9999) {
            return Notice::None;
        }
        if square > limit.times(1.0001) {
            return Notice::BeyondFriction;
        }
    }
    linear_notice(length(fx, fy), bound)
}

/// What the caller of a model with a friction bound should know, and whether an input is implausible.
pub(crate) fn notice_of<F: Float>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    model: Model,
    psi: F,
) -> Notice {
    let of_model = notice(model, contact.friction_bound(), contact.a / contact.b, psi)
        .worse(neglected(model, contact.mismatch));
    warned(contact, creepage, of_model)
}

/// The graver of a notice of the model and of a warning that an input is implausible.
#[cold]
#[inline(never)]
pub(crate) fn warned<F: Float>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    notice: Notice,
) -> Notice {
    notice.worse(warning(contact, creepage))
}

/// The notice that the theory of 1967 neglects the mismatch of the materials.
#[inline]
pub(crate) fn neglected<F: Float>(model: Model, mismatch: F) -> Notice {
    let neglects = model.is_of_1967() && mismatch != F::zero();
    if neglects { Notice::MismatchNeglected } else { Notice::None }
}

/// What the caller of the linear theory should know.
#[inline]
pub(crate) fn linear_notice<F: Float>(size: F, friction_bound: F) -> Notice {
    if size > friction_bound { Notice::BeyondFriction } else { Notice::None }
}

/// Range of the axis ratio for which [`Model::Strip`] and [`Model::Total`] are made, slightly widened because quotients round.
pub(crate) const RATIOS: [f64; 2] = [0.014_999_9, 60.000_1];
/// Largest spin `|ψ|` for which [`Model::Strip`] is made.
pub(crate) const LARGEST_SPIN: f64 = 3.0;

/// What the caller of a model with a friction bound should know.
#[inline]
pub(crate) fn notice<F: Float>(model: Model, friction_bound: F, ratio: F, psi: F) -> Notice {
    if friction_bound <= F::zero() {
        // Nothing to carry: zero forces are right in every model with a friction bound.
        return Notice::None;
    }
    match model {
        Model::Strip1967 | Model::Strip1967Continuous if psi.abs() >= F::one() => {
            Notice::SpinBeyondTheory
        }
        Model::Total | Model::Strip
            if ratio < F::constant(RATIOS[0]) || ratio > F::constant(RATIOS[1]) =>
        {
            Notice::AxisRatio
        }
        // (TOTAL knows the limit of large spin)
        Model::Strip if psi.abs() > F::constant(LARGEST_SPIN) => Notice::OutsideRange,
        _ => Notice::None,
    }
}
