//! The numbers that all strips of an ellipse share.

use crate::contact::creepage::Parameters;
use crate::number::{Arithmetic, Number, Stored, branch_or_blend};
use crate::strip_1967::strip::SlidingRule;

/// The numbers that all strips share, with creepages mirrored so that `ξ ≥ 0` and `0 ≤ ψ ≤ 1`.
#[derive(Clone, Copy, Debug)]
pub struct ReducedCreepage<T: Number> {
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
    /// The signs that `F_x` and `Y` have been multiplied with: 1 or −1.
    pub(super) turned_x: T::Base,
    pub(super) turned_y: T::Base,
}

/// Largest sum of creepages whose eighth power is finite.
#[inline]
fn largest_sum<T: Number>() -> f64 {
    if size_of::<Stored<T>>() == 4 { 1e4 } else { 1e30 }
}

impl<T: Number> ReducedCreepage<T> {
    /// Mirrored by the symmetries of the theory: `(ξ, η, ψ) → (−ξ, η, ψ)` gives `(−F_x, F_y, M_z)`,
    /// strips in the opposite order; all three reversed gives all forces reversed.
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
        // Within a strip spin counts as at most one.
        let within = psi.min(T::one());
        // Far beyond any adhesion creepages are scaled down in the same direction, so that powers
        // are finite.
        let far = (xi + eta.abs() + slope).times(1.0 / largest_sum::<T>());
        let [xi, eta, slope, psi] = branch_or_blend!(
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
    pub fn values(&self) -> ReducedCreepage<T::Base> {
        let Self { compliance, axis_ratio, rule, turned_x, turned_y, .. } = *self;
        let (xi, eta, psi) = (self.xi.value(), self.eta.value(), self.psi.value());
        let (slope, q, eta_psi) = (self.slope.value(), self.q.value(), self.eta_psi.value());
        ReducedCreepage {
            xi,
            eta,
            psi,
            slope,
            q,
            eta_psi,
            compliance,
            axis_ratio,
            rule,
            turned_x,
            turned_y,
        }
    }
}
