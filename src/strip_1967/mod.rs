//! The strip theory of 1967 in closed form.
//!
//! Every strip `y = const` is a plane problem along `x` and an anti-plane problem along `y`
//! (Section 4). In units of the ellipse, `Y = y/b` and `C = c/a = √(1 − Y²)`, a strip has the
//! creepages of (5.13),
//!
//! ```text
//! ξ̄ = ξ − p Y,   p = ψ (b/a)/(1 − ν),   η,   ψ,
//! ```
//!
//! and sticks from its leading edge to the separatrix, `κ/a = K` before the middle of the slipping
//! part behind it (5.41):
//!
//! ```text
//! K = (S + η ψ)/(1 − ψ²),   S = √(η² + (1 − ψ²) ξ̄²).
//! ```
//!
//! Where `K < C` it adheres and carries the forces (Section 7)
//!
//! ```text
//! f_x = ξ̄ (2C − K),   f_y = ψ C² + η (2C − K),   m_x = −η (C − K)²;
//! ```
//!
//! elsewhere it slides and carries `C²` along one direction, that of a [`SlidingRule`] (Section 6).
//! The strips that adhere are one interval of `Y`, whose ends are roots of a cubic ([`edge`]). So
//! the totals
//!
//! ```text
//! (F_x, F_y)/(μ N) = ¾ ∫ (f_x, f_y) dY,   M_z/(μ N) = ¾ ∫ (a m_x − b Y f_x) dY
//! ```
//!
//! are differences of primitives ([`totals()`]). The shares of [`strips`] add up to them, whatever
//! their number. A single strip with its traction and slip is in [`strip`].
//!
//! **Primitives** (Section 7.1). With `u = h − Y`, `h = ξ/p` both square roots of the theory have
//! one form, `√(u² + ε²)`: the adhesion length's `S = p √q √(u² + ε²)` with `ε = η/(p √q)`, and the
//! slip of a strip that slides by the rule of the rigid slip with `ε = η/(p (1 − ν))`. Their
//! moments are powers and `asinh(u/ε)`. Where a root is nearly straight over its piece the
//! primitives would cancel; there four nodes of Gauss give all digits.
//!
//! Two integrals are not elementary: `∫ C S dY` of the moment `m_x`, and the continuous sliding
//! rule. They are summed over nodes of the angle, so that the edges of the contact are smooth, from
//! the known points where they bend.
//!
//! **Beyond unit spin** the theory ends. There the spin `ψ` within a strip counts as `±1`, while
//! `ξ̄` keeps all of it: strips with `η ψ < 0` still adhere (Section 8.26), ever fewer of them, and
//! at large slip none. The forces are continuous at `|ψ| = 1` and cost the same. Every strip
//! dissipates for `|ψ| ≤ 1` under either rule, and `ψ m_x ≥ 0` where one adheres beyond: the power
//! is never negative.

mod adhesion;
pub mod edge;
mod integrals;
pub mod reduced;
mod sliding;
mod slopes;
pub mod strip;
pub mod strips;

use crate::contact::creepage::Parameters;
use crate::contact::totals::Totals;
use crate::number::avx::with_avx;
use crate::number::{Arithmetic, Number, Real, add, branch_or_blend, choose_each};
use crate::strip_1967::adhesion::adhering;
use crate::strip_1967::edge::Edge;
use crate::strip_1967::integrals::Shares;
use crate::strip_1967::reduced::ReducedCreepage;
use crate::strip_1967::sliding::sliding;
use crate::strip_1967::strip::SlidingRule;
use core::f64::consts::PI;

/// `F/(μ N)`, `M_z/(μ N √(ab))` and the stick area of a contact.
///
/// # Example
/// Pure longitudinal creepage, Section 8.15:
/// ```
/// use kstrip::{strip_1967, strip_1967::strip::SlidingRule, contact::creepage::Parameters};
/// let (poisson_ratio, axis_ratio) = (0.28, 1.0);
/// let parameters = Parameters { xi: 0.5, eta: 0.0, psi: 0.0, poisson_ratio, axis_ratio };
/// let totals = strip_1967::totals(&parameters, SlidingRule::RigidSlip);
/// let exact = 1.0 - (2.25 * 0.75_f64.sqrt() - 1.5 * 0.5_f64.acos()) / 2.0;
/// assert!((totals.fx - exact).abs() < 1e-15 && totals.fy == 0.0);
/// ```
#[must_use]
#[inline(always)]
pub fn totals<T: Number>(parameters: &Parameters<T>, rule: SlidingRule) -> Totals<T> {
    // The code for one rule alone is half as large. With derivatives one function serves both
    // rules.
    if rule == SlidingRule::RigidSlip && !T::HAS_DERIVATIVES {
        with_avx!(if T::LANES => <T: Number>(parameters: &Parameters<T>) -> Totals<T> {
            integrals(parameters, SlidingRule::RigidSlip)
        })
    } else {
        with_avx!(if T::LANES => <T: Number>(
            parameters: &Parameters<T>,
            rule: SlidingRule
        ) -> Totals<T> {
            integrals(parameters, rule)
        })
    }
}

#[inline(always)]
fn integrals<T: Number>(parameters: &Parameters<T>, rule: SlidingRule) -> Totals<T> {
    let motion = ReducedCreepage::new(parameters, rule);
    let short = || without_spin(&motion.values());
    let shares = if T::HAS_DERIVATIVES {
        let mut shares = with_spin(&motion);
        if !motion.psi.value().lies_between(T::TINY, T::LARGEST) {
            // The formulas without spin have no derivative with respect to spin.
            for (share, value) in shares.iter_mut().zip(short()) {
                let own = T::composed(value, [T::Base::one()], [*share]);
                *share = motion.psi.choose(*share, own);
            }
        }
        shares
    } else {
        branch_or_blend!(motion.psi, { with_spin(&motion) }, {
            T::each(&short(), |x| T::from_base(*x))
        })
    };
    turned_back(&motion, shares)
}

/// Forces and moment in units of `μ N` and `μ N √(ab)`, signs restored.
#[inline(always)]
fn turned_back<T: Number>(motion: &ReducedCreepage<T>, shares: Shares<T>) -> Totals<T> {
    let [fx, fy, mx, lever, stick] = shares;
    let ReducedCreepage { axis_ratio, turned_x, turned_y, .. } = *motion;
    let root = axis_ratio.sqrt();
    let mz = mx.scale(root) - lever.scale(T::Base::one() / root);
    let (fx, fy) = (fx.scale(turned_x.times(0.75)), fy.scale(turned_y.times(0.75)));
    // A motion that is its own mirror image has no longitudinal force.
    let fx = motion.xi.choose(fx, fx - T::from_base(fx.value()));
    // Differences of primitives may exceed the bound by their rounding.
    let square = fx * fx + fy * fy;
    let [fx, fy] = branch_or_blend!(
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
fn without_spin<F: Real>(motion: &ReducedCreepage<F>) -> Shares<F> {
    let ReducedCreepage { xi, eta, compliance, rule, .. } = *motion;
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
    // ∫ C² dY of the strips that slide, divided by their slip.
    let beside = tau2.min(one) / (one + y);
    let z = if rule == SlidingRule::RigidSlip { xi * compliance } else { xi };
    let slip = (z * z + (eta2 + F::EPSILON * F::EPSILON)).sqrt();
    let slides = (beside * beside * y.plus(2.0)).times(2.0 / 3.0) / slip;
    [xi * angle + z * slides, eta * (angle + slides), -(eta * (cc - tau * angle)), none, stick]
}

/// Strips that adhere, and those that slide on both sides of them.
#[inline(always)]
fn with_spin<T: Number>(motion: &ReducedCreepage<T>) -> Shares<T> {
    let (arc, some) = edge::adhesion(motion);
    let (one, none) = (T::one(), T::zero());
    let (first, last) = (Edge { y: -one, c: none }, Edge { y: one, c: none });
    let slide = sliding(motion, [first, arc.lower], [arc.upper, last]);
    if !some.exceeds(none) {
        return slide;
    }
    let mut all = slide;
    add(&mut all, adhering(motion, &arc));
    if T::HAS_DERIVATIVES {
        add(&mut all, slopes::jumps(motion, &arc));
    }
    choose_each(some, all, slide)
}
