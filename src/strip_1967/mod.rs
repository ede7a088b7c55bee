//! The strip theory of 1967 in closed form.
//!
//! Every strip `y = const` is a plane problem along `x` and an anti-plane problem along `y` (Section 4). In units of the
//! ellipse, `Y = y/b` and `C = c/a = √(1 − Y²)`, a strip sees the creepages of (5.13),
//!
//! ```text
//! ξ̄ = ξ − p Y,   p = ψ (b/a)/(1 − ν),   η,   ψ,
//! ```
//!
//! and sticks from its leading edge to the separatrix, `κ/a = K` before the middle of what slips behind it (5.41):
//!
//! ```text
//! K = (S + η ψ)/(1 − ψ²),   S = √(η² + (1 − ψ²) ξ̄²).
//! ```
//!
//! Where `K < C` it adheres and carries (Section 7)
//!
//! ```text
//! f_x = ξ̄ (2C − K),   f_y = ψ C² + η (2C − K),   m_x = −η (C − K)²;
//! ```
//!
//! elsewhere it slides and carries `C²` along one direction, that of a [`SlidingRule`] (Section 6). The strips that adhere are one
//! interval of `Y`, whose ends are roots of a cubic ([`edge`]). So the totals
//!
//! ```text
//! (F_x, F_y)/(μ N) = ¾ ∫ (f_x, f_y) dY,   M_z/(μ N) = ¾ ∫ (a m_x − b Y f_x) dY
//! ```
//!
//! are differences of primitives ([`totals()`]), and so is the share of any piece of the width ([`strips`]): shares add up to the
//! totals, whatever their number. A single strip with its traction and slip is in [`strip`].
//!
//! **Beyond unit spin** the theory ends. There the spin `ψ` within a strip counts as `±1`, while `ξ̄` keeps all of it: strips with
//! `η ψ < 0` still adhere (Section 8.26), ever fewer of them, and at large slip none. The forces are continuous at `|ψ| = 1` and cost the
//! same. Every strip dissipates for `|ψ| ≤ 1` under either rule, and `ψ m_x ≥ 0` where one adheres beyond: the power is
//! never negative.

mod adhesion;
pub mod edge;
mod integrals;
mod sliding;
mod slopes;
pub mod strip;
pub mod strips;
mod totals;

pub use self::totals::totals;

use crate::contact::creepage::Parameters;
use crate::number::{Arithmetic, Number, Stored, either};
use crate::strip_1967::strip::SlidingRule;

/// What all strips share: creepages turned so that `ξ ≥ 0` and `0 ≤ ψ ≤ 1`.
#[derive(Clone, Copy, Debug)]
pub struct Motion<T: Number> {
    /// `ξ ≥ 0`
    pub xi: T,
    /// `η`
    pub eta: T,
    /// `ψ`, 0 to 1.
    pub psi: T,
    /// `p = ψ (b/a)/(1 − ν) ≥ 0`
    pub slope: T,
    /// `1 − ψ²`
    pub q: T,
    /// `η ψ`
    pub eta_psi: T,
    /// `1 − ν`
    pub compliance: T::Base,
    /// `a/b`
    pub axis_ratio: T::Base,
    /// Direction of a strip that slides.
    pub rule: SlidingRule,
    /// By what `F_x` and `Y` have been turned: 1 or −1.
    turned_x: T::Base,
    turned_y: T::Base,
}

/// Sums of creepages up to which their eighth powers are numbers.
#[inline]
fn largest<T: Number>() -> f64 {
    if size_of::<Stored<T>>() == 4 { 1e4 } else { 1e30 }
}

impl<T: Number> Motion<T> {
    /// Turned by the symmetries of the theory: `(ξ, η, ψ) → (−ξ, η, ψ)` gives `(−F_x, F_y, M_z)`, strips in the opposite order;
    /// all three reversed gives all forces reversed.
    #[inline(always)]
    pub fn new(parameters: &Parameters<T>, rule: SlidingRule) -> Self {
        let Parameters { xi, eta, psi, poisson_ratio, axis_ratio } = *parameters;
        let one = T::Base::one();
        let compliance = one - poisson_ratio;
        let width = one / (compliance * axis_ratio);
        // all three reversed: all forces reversed (without spin by the sign of η)
        let by_eta = eta.value().choose(one, -one);
        let turned_all = psi.value().choose(one, (-psi.value()).choose(-one, by_eta));
        // ξ reversed: F_x and Y reversed
        let turned_xi = xi.value().scale(turned_all).choose(one, -one);
        let (xi, eta) = (xi.scale(turned_all * turned_xi), eta.scale(turned_all));
        let psi = psi.scale(turned_all);
        let slope = psi.scale(width);
        // within a strip spin counts as one at most
        let within = psi.min(T::one());
        // far beyond any adhesion the same direction, so that powers are numbers
        let far = (xi + eta.abs() + slope).times(1.0 / largest::<T>());
        let [xi, eta, slope, psi] = either!(
            far - T::one(),
            {
                let scale = far.inverse();
                [xi * scale, eta * scale, slope * scale, within * scale]
            },
            { [xi, eta, slope, within] }
        );
        Self {
            xi,
            eta,
            psi,
            slope,
            q: (T::one() - psi) * (T::one() + psi),
            eta_psi: eta * psi,
            compliance,
            axis_ratio,
            rule,
            turned_x: turned_all * turned_xi,
            turned_y: turned_all,
        }
    }

    /// `ξ̄ = ξ − p Y`
    #[inline]
    pub fn xi_bar(&self, y: T::Base) -> T {
        self.xi - self.slope.scale(y)
    }

    /// Without derivatives.
    #[inline]
    pub fn values(&self) -> Motion<T::Base> {
        let Self { compliance, axis_ratio, rule, turned_x, turned_y, .. } = *self;
        let (xi, eta, psi) = (self.xi.value(), self.eta.value(), self.psi.value());
        let (slope, q, eta_psi) = (self.slope.value(), self.q.value(), self.eta_psi.value());
        Motion { xi, eta, psi, slope, q, eta_psi, compliance, axis_ratio, rule, turned_x, turned_y }
    }
}
