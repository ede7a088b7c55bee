//! Total force, moment and stick area by the primitives of Section 7.1.
//!
//! With `u = h − Y`, `h = ξ/p` both square roots of the theory have one form, `√(u² + ε²)`: the adhesion length's
//! `S = p √q √(u² + ε²)` with `ε = η/(p √q)`, and the slip of a strip that slides by the rule of the rigid slip with `ε = η/(p (1 − ν))`.
//! Their moments are powers and `asinh(u/ε)`. Where a root hardly bends over its piece the primitives would cancel, and four nodes
//! of Gauss give all digits.
//!
//! Two integrals are not elementary: `∫ C S dY` of the moment `m_x`, and the continuous sliding rule. They are summed over nodes of the
//! angle, so that the edges of the contact are smooth, from the known points where they bend.

use crate::contact::creepage::Parameters;
use crate::contact::forces::Totals;
use crate::number::registers::compiled_twice;
use crate::number::{Arithmetic, Number, Plain, chosen, either};
use crate::strip_1967::Motion;
use crate::strip_1967::adhesion::adhering;
use crate::strip_1967::edge::{self, Arc, Edge};
use crate::strip_1967::integrals::{Shares, sum};
use crate::strip_1967::sliding::sliding;
use crate::strip_1967::slopes;
use crate::strip_1967::strip::SlidingRule;
use core::f64::consts::PI;

/// `F/(μ N)`, `M_z/(μ N √(ab))` and the stick area of a contact.
///
/// # Example
/// Pure longitudinal creepage, Section 8.15:
/// ```
/// use kstrip::{strip_1967, strip_1967::strip::SlidingRule, contact::creepage::Parameters};
/// let parameters = Parameters { xi: 0.5, eta: 0.0, psi: 0.0, poisson_ratio: 0.28, axis_ratio: 1.0 };
/// let totals = strip_1967::totals(&parameters, SlidingRule::RigidSlip);
/// let exact = 1.0 - (2.25 * 0.75_f64.sqrt() - 1.5 * 0.5_f64.acos()) / 2.0;
/// assert!((totals.fx - exact).abs() < 1e-15 && totals.fy == 0.0);
/// ```
#[must_use]
#[inline(always)]
pub fn totals<T: Number>(parameters: &Parameters<T>, rule: SlidingRule) -> Totals<T> {
    // (the code of one rule alone is half as large; with derivatives it is one for both)
    if rule == SlidingRule::RigidSlip && !T::HAS_DERIVATIVES {
        compiled_twice!(if T::LANES => <T: Number>(parameters: &Parameters<T>) -> Totals<T> {
            integrals(parameters, SlidingRule::RigidSlip)
        })
    } else {
        compiled_twice!(if T::LANES => <T: Number>(parameters: &Parameters<T>, rule: SlidingRule) -> Totals<T> {
            integrals(parameters, rule)
        })
    }
}

#[inline(always)]
fn integrals<T: Number>(parameters: &Parameters<T>, rule: SlidingRule) -> Totals<T> {
    let motion = Motion::new(parameters, rule);
    let short = || without_spin(&motion.values());
    let shares = if T::HAS_DERIVATIVES {
        // (the formulas without spin have no derivative by the spin)
        let slopes = with_spin(&motion);
        if motion.psi.exceeds(T::zero()) { slopes } else { valued(slopes, short()) }
    } else {
        either!(motion.psi, { with_spin(&motion) }, { valued([T::zero(); 5], short()) })
    };
    turned_back(&motion, shares)
}

/// Replaces the values of numbers and keeps their derivatives.
#[inline]
fn valued<T: Number>(mut numbers: Shares<T>, values: Shares<T::Base>) -> Shares<T> {
    for (number, value) in numbers.iter_mut().zip(values) {
        *number = T::composed(value, [T::Base::one()], [*number]);
    }
    numbers
}

/// Forces and moment in units of `μ N` and `μ N √(ab)`, turned back.
#[inline(always)]
pub(super) fn turned_back<T: Number>(motion: &Motion<T>, shares: Shares<T>) -> Totals<T> {
    let [fx, fy, mx, lever, stick] = shares;
    let Motion { axis_ratio, turned_x, turned_y, .. } = *motion;
    let root = axis_ratio.sqrt();
    let mz = mx.scale(root) - lever.scale(T::Base::one() / root);
    let (fx, fy) = (fx.scale(turned_x.times(0.75)), fy.scale(turned_y.times(0.75)));
    // the mirror image of itself
    let fx = motion.xi.choose(fx, fx - T::from_base(fx.value()));
    // (differences of primitives may pass the bound by their rounding)
    let square = fx * fx + fy * fy;
    let [fx, fy] = either!(
        square - T::one(),
        {
            let inverse = square.sqrt().inverse();
            [fx * inverse, fy * inverse]
        },
        { [fx, fy] }
    );
    Totals {
        fx,
        fy,
        mz: mz.scale(turned_y.times(0.75)),
        stick: stick.times(2.0 / PI).clamped(T::zero(), T::one()),
    }
}

/// Without spin `K = τ = √(ξ² + η²)` in every strip, and strips with `C > τ` adhere (Section 8.15).
#[inline(always)]
fn without_spin<F: Plain>(motion: &Motion<F>) -> Shares<F> {
    let Motion { xi, eta, compliance, rule, .. } = *motion;
    let (one, none) = (F::one(), F::zero());
    let (tau2, eta2) = (xi * xi + eta * eta, eta * eta);
    let tau = tau2.sqrt();
    let inside = one - tau;
    // those from −Y to Y
    let y = (inside * (one + tau)).max(none).sqrt();
    // ∫ (2C − K) dY = 2 asin Y
    let angle = inside.choose((y / (one + tau)).atan_of_unit().times(4.0), none);
    let cc = (y - y * (y * y).times(1.0 / 3.0)).times(2.0);
    let stick = inside.choose(angle.times(0.5) - y * tau, none);
    // ∫ C² dY of those that slide, over their slip
    let beside = tau2.min(one) / (one + y);
    let z = if rule == SlidingRule::RigidSlip { xi * compliance } else { xi };
    let slip = (z * z + (eta2 + F::EPSILON * F::EPSILON)).sqrt();
    let slides = (beside * beside * y.plus(2.0)).times(2.0 / 3.0) / slip;
    [xi * angle + z * slides, eta * (angle + slides), -(eta * (cc - tau * angle)), none, stick]
}

#[inline(always)]
fn with_spin<T: Number>(motion: &Motion<T>) -> Shares<T> {
    let (arc, some) = edge::adhesion(motion);
    let slide = outside(motion, &arc);
    if !some.exceeds(T::zero()) {
        return slide;
    }
    let mut all = sum(slide, adhering(motion, &arc));
    if T::HAS_DERIVATIVES {
        all = sum(all, slopes::jumps(motion, &arc));
    }
    chosen(some, all, slide)
}

/// All strips.
pub(super) fn whole<F: Plain>(motion: &Motion<F>, arc: &Arc<F>, adheres: bool) -> Shares<F> {
    let slide = outside(motion, arc);
    if adheres { sum(slide, adhering(motion, arc)) } else { slide }
}

/// Strips that slide on both sides of an arc.
#[inline(always)]
fn outside<T: Number>(motion: &Motion<T>, arc: &Arc<T>) -> Shares<T> {
    let (one, none) = (T::one(), T::zero());
    let (first, last) = (Edge { y: -one, c: none }, Edge { y: one, c: none });
    sliding(motion, [first, arc.lower], [arc.upper, last])
}
