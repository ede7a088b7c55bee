//! What the caller should know about a valid result.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::contact::warning;
use crate::number::{Float, length};
use crate::solve::options::Model;
use crate::status::Notice;

/// A bound whose square has all its digits \[N\].
const TOLD_BY_SQUARES: f64 = 1e-12;

/// [`linear_notice`] of a force, without its root and quotient where the squares tell.
#[inline(always)]
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

/// Or that an input is implausible.
#[cold]
#[inline(never)]
pub(crate) fn warned<F: Float>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    notice: Notice,
) -> Notice {
    notice.worse(warning(contact, creepage))
}

/// What the theory of 1967 neglects.
#[inline(always)]
pub(crate) fn neglected<F: Float>(model: Model, mismatch: F) -> Notice {
    let neglects = model.is_of_1967() && mismatch != F::zero();
    if neglects { Notice::MismatchNeglected } else { Notice::None }
}

/// What the caller of the linear theory should know.
#[inline(always)]
pub(crate) fn linear_notice<F: Float>(size: F, friction_bound: F) -> Notice {
    if size > friction_bound { Notice::BeyondFriction } else { Notice::None }
}

/// Axis ratios that [`Model::Strip`] and [`Model::Total`] are made for, a hair more.
pub(crate) const RATIOS: [f64; 2] = [0.014_999_9, 60.000_1];
/// Spins `|ψ|` that it is made for.
pub(crate) const LARGEST_SPIN: f64 = 3.0;

/// What the caller of a model with a friction bound should know.
#[inline(always)]
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
