//! One strip `y = const` of the contact (Sections 4 to 6).
//!
//! Lengths are in units of the semi-axis `a`, tractions in units of `μ p₀`, slip in units of
//! `2 μ p₀/G`, forces per unit of `Y = y/b` such that `F/(μ N) = (3/4) ∫ f dY`.
//!
//! A strip of half width `C` has the effective longitudinal creepage `ξ̄`, the lateral creepage `η`
//! and the spin `ψ`. If its adhesion length allows (`κ < C`) it sticks next to the leading edge,
//! else it slides as a whole.

use crate::number::{Arithmetic, Float, Number};

/// Direction of the traction in a strip without adhesion area (Section 6).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SlidingRule {
    /// The direction of the rigid slip on the strip's centre line, `((1 − ν) ξ̄, η)`: the rule that
    /// the paper keeps for forces. The traction jumps where a strip loses its adhesion area.
    #[default]
    RigidSlip,
    /// `(ξ̄, η + ψ C)`, which joins the strips with adhesion without a jump.
    Continuous,
}

/// The state of a point of the plane of contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum State {
    /// Outside the contact area; pressure and traction are zero.
    Outside = 0,
    /// Adhesion: no slip, traction below the friction bound.
    Stick = 1,
    /// Slip that dissipates.
    Slip = 2,
    /// Slip against the traction: an error of the strip theory near the leading edge of sliding
    /// strips (8.39), where the local dissipation is negative.
    SlipNegativeDissipation = 3,
}

/// The tangential state of a point of a strip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripPoint<T> {
    /// Pressure, units of `p₀`.
    pub pressure: T,
    /// Traction on the lower body along `x`, units of `μ p₀`.
    pub traction_x: T,
    /// Traction on the lower body along `y`, units of `μ p₀`.
    pub traction_y: T,
    /// Slip of the upper body relative to the lower body along `x`, units of `2 μ p₀/G`.
    pub slip_x: T,
    /// Slip along `y`, units of `2 μ p₀/G`.
    pub slip_y: T,
    /// Stick, slip, or outside.
    pub state: State,
}

impl<F: Float> StripPoint<F> {
    /// `P = X s_x + Y s_y`, units of `2 (μ p₀)²/G`.
    #[must_use]
    pub fn dissipation(&self) -> F {
        self.traction_x * self.slip_x + self.traction_y * self.slip_y
    }

    /// A point with no pressure on it.
    #[must_use]
    pub fn outside() -> Self {
        Self {
            pressure: F::zero(),
            traction_x: F::zero(),
            traction_y: F::zero(),
            slip_x: F::zero(),
            slip_y: F::zero(),
            state: State::Outside,
        }
    }
}

/// The two regimes of a strip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Regime<T> {
    /// The strip sticks over `−C + 2κ < x < C` and slips behind it.
    Adhesion {
        /// `κ/a`: half the distance from the trailing edge to the separatrix, `0 ≤ κ < C`.
        kappa: T,
        /// `α = ξ̄/κ`: longitudinal amplitude of the half-ellipses, (5.5) and (5.40).
        alpha: T,
        /// `β + ψ = η/κ + ψ`: lateral amplitude; `α² + (β + ψ)² = 1`.
        beta_plus_psi: T,
    },
    /// The strip slides; its traction is `μ Z` along a unit vector.
    Sliding {
        /// `w_x`
        direction_x: T,
        /// `w_y`
        direction_y: T,
    },
}

/// The solution of one strip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strip<T: Number> {
    /// Half width `C = c/a`.
    pub half_length: T,
    /// Effective longitudinal creepage `ξ̄ = ξ − ψ (y/a)/(1 − ν)`.
    pub xi_bar: T,
    /// Lateral creepage parameter `η`.
    pub eta: T,
    /// Spin parameter `ψ`; in tractions it counts as at most ±1.
    pub psi: T,
    /// Poisson's ratio `ν`.
    pub poisson_ratio: T::Base,
    /// Adhesion or sliding.
    pub regime: Regime<T>,
}

/// `κ/a` by the form that does not cancel; `None` when no adhesion length exists at any width.
///
/// For `|ψ| < 1` always a number (possibly larger than the strip). For `|ψ| ≥ 1` only when
/// `η ψ < 0` and `η² ≥ (ψ² − 1) ξ̄²` (Section 8.26).
#[inline]
pub fn adhesion_length<T: Number>(xi_bar: T, eta: T, psi: T) -> Option<T> {
    let q = (T::one() - psi) * (T::one() + psi);
    let eta_psi = eta * psi;
    let s_squared = eta * eta + q * (xi_bar * xi_bar);
    if T::zero().exceeds(s_squared) {
        return None;
    }
    let s = s_squared.max(T::from_base(T::TINY)).sqrt();
    if T::zero().exceeds(eta_psi) {
        // κ/a = (ξ̄² + η²)/(S − η ψ)   (5.41)
        Some((xi_bar * xi_bar + eta * eta) / (s - eta_psi))
    } else if q.exceeds(T::zero()) {
        // κ/a = (S + η ψ)/(1 − ψ²)   (5.41)
        Some((s_squared.max(T::zero()).sqrt() + eta_psi) / q)
    } else {
        None
    }
}

/// `κ/a` of a strip of this half length that adheres, and the adhesion length for creepages of size
/// one, with these: `[κ/a, K, ξ̄, η]`. `None` for a strip that slides.
#[inline]
pub(super) fn adhesion_regime<T: Number>(
    half_length: T, xi_bar: T, eta: T, psi: T,
) -> Option<[T; 4]> {
    // α and β + ψ do not change when ξ̄ and η are scaled together; κ scales with them. Solving
    // at size one keeps squares of tiny creepages from underflowing.
    let size = xi_bar.value().abs().max(eta.value().abs());
    if !size.exceeds(T::TINY) {
        // No creepage at all: the strip sticks, with the spin's own traction ψ √(C² − x²).
        return Some([T::zero(), T::one(), T::zero(), T::zero()]);
    }
    let inverse = T::Base::one() / size;
    let (x, e) = (xi_bar.scale(inverse), eta.scale(inverse));
    let length = adhesion_length(x, e, psi)?;
    let kappa = length.scale(size);
    half_length.exceeds(kappa).then_some([kappa, length, x, e])
}

/// `ψ` as it counts in the tractions of a strip, limited to ±1.
pub(super) fn spin_within<T: Number>(psi: T) -> T {
    psi.clamped(-T::one(), T::one())
}

/// The unit vector along `(x, y)`, or zero for a vector below the smallest normal number.
#[inline]
pub(crate) fn unit_vector<T: Number>(x: T, y: T) -> (T, T) {
    let size = x.value().abs().max(y.value().abs());
    if !size.exceeds(T::TINY) {
        return (T::zero(), T::zero());
    }
    let (x, y) = (x.scale(T::Base::one() / size), y.scale(T::Base::one() / size));
    let length = (x * x + y * y).sqrt();
    (x / length, y / length)
}

impl<T: Number> Strip<T> {
    /// Solve a strip of half width `half_length > 0`.
    #[must_use]
    pub fn solve(
        half_length: T, xi_bar: T, eta: T, psi: T, poisson_ratio: T::Base, rule: SlidingRule,
    ) -> Self {
        let spin = spin_within(psi);
        let regime = Self::adhesion(half_length, xi_bar, eta, spin)
            .unwrap_or_else(|| Self::sliding(half_length, xi_bar, eta, spin, poisson_ratio, rule));
        Self { half_length, xi_bar, eta, psi, poisson_ratio, regime }
    }

    fn adhesion(half_length: T, xi_bar: T, eta: T, psi: T) -> Option<Regime<T>> {
        let [kappa, length, x, e] = adhesion_regime(half_length, xi_bar, eta, psi)?;
        // α = a ξ̄/κ,  β = a η/κ   (5.40)
        Some(Regime::Adhesion { kappa, alpha: x / length, beta_plus_psi: e / length + psi })
    }

    fn sliding(
        half_length: T, xi_bar: T, eta: T, psi: T, poisson_ratio: T::Base, rule: SlidingRule,
    ) -> Regime<T> {
        let (direction_x, direction_y) = match rule {
            SlidingRule::RigidSlip => {
                unit_vector(xi_bar.scale(T::Base::one() - poisson_ratio), eta)
            }
            SlidingRule::Continuous => unit_vector(xi_bar, eta + psi * half_length),
        };
        Regime::Sliding { direction_x, direction_y }
    }

    /// Whether the strip has an adhesion area.
    #[must_use]
    pub fn adheres(&self) -> bool {
        matches!(self.regime, Regime::Adhesion { .. })
    }

    /// `x` of the separatrix between slip and adhesion, `−C + 2κ`; the leading edge `C` for a
    /// sliding strip.
    #[must_use]
    pub fn separatrix(&self) -> T {
        match self.regime {
            Regime::Adhesion { kappa, .. } => kappa.times(2.0) - self.half_length,
            Regime::Sliding { .. } => self.half_length,
        }
    }

    /// Force on the lower body, `(f_x, f_y)`.
    #[must_use]
    pub fn force(&self) -> (T, T) {
        let c = self.half_length;
        match self.regime {
            Regime::Adhesion { kappa, .. } => {
                // f_x = ξ̄ (2C − K),  f_y = ψ C² + η (2C − K)
                let stretch = c.times(2.0) - kappa;
                (self.xi_bar * stretch, spin_within(self.psi) * (c * c) + self.eta * stretch)
            }
            // f = C² w
            Regime::Sliding { direction_x, direction_y } => {
                (c * c * direction_x, c * c * direction_y)
            }
        }
    }

    /// Moment about the strip's centre, `m_x = −η (C − K)²`, zero for a sliding strip; units of
    /// `a`.
    #[must_use]
    pub fn moment(&self) -> T {
        match self.regime {
            Regime::Adhesion { kappa, .. } => -(self.eta * (self.half_length - kappa).squared()),
            Regime::Sliding { .. } => T::zero(),
        }
    }

    /// Dissipation of the strip, units of `μ N · 2 μ p₀/G`: the power of its force and moment on
    /// the rigid slip, `(1 − ν) ξ̄ f_x + η f_y + ψ m_x`, with `ψ` at most ±1.
    #[must_use]
    pub fn dissipation(&self) -> T {
        let (fx, fy) = self.force();
        self.xi_bar.scale(T::Base::one() - self.poisson_ratio) * fx
            + self.eta * fy
            + spin_within(self.psi) * self.moment()
    }
}

impl<F: Float> Strip<F> {
    /// Pressure, traction and slip at `x` (units of `a`, leading edge at `+C`).
    #[must_use]
    pub fn at(&self, x: F) -> StripPoint<F> {
        let c = self.half_length;
        // C² − x² and C + x without cancellation at the edges
        let (ahead, behind) = (c - x, c + x);
        if !(ahead >= F::zero() && behind >= F::zero()) {
            return StripPoint::outside();
        }
        // Z/p₀ = √(C² − x²)   (2.7)
        let pressure = (ahead * behind).sqrt();
        let compliance = F::one() - self.poisson_ratio;
        match self.regime {
            Regime::Adhesion { kappa, alpha, beta_plus_psi } => {
                let past_separatrix = behind - kappa.times(2.0);
                if past_separatrix >= F::zero() {
                    // X = α [√(C² − x²) − √(h² − x'²)] with h² − x'² = (C − x)(C + x − 2κ), and
                    // α κ = ξ̄: X = 2 ξ̄ √(C − x)/(√(C + x) + √(C + x − 2κ)). Likewise Y.
                    let sum = behind.sqrt() + past_separatrix.sqrt();
                    let rise =
                        if sum > F::zero() { (ahead.sqrt() / sum).times(2.0) } else { F::zero() };
                    return StripPoint {
                        pressure,
                        traction_x: self.xi_bar * rise,
                        traction_y: spin_within(self.psi) * pressure + self.eta * rise,
                        slip_x: F::zero(),
                        slip_y: F::zero(),
                        state: State::Stick,
                    };
                }
                // s = √(x'² − h²) ((1 − ν) α, β),  x'² − h² = (C − x)(2κ − C − x)
                let growth = (ahead * (-past_separatrix)).sqrt();
                StripPoint {
                    pressure,
                    traction_x: alpha * pressure,
                    traction_y: beta_plus_psi * pressure,
                    slip_x: (alpha * growth).scale(compliance),
                    slip_y: (beta_plus_psi - spin_within(self.psi)) * growth,
                    state: State::Slip,
                }
                .classified()
            }
            Regime::Sliding { direction_x, direction_y } => StripPoint {
                pressure,
                traction_x: direction_x * pressure,
                traction_y: direction_y * pressure,
                // s = ((1 − ν)(ξ̄ − w_x x), η + ψ x − w_y x)
                slip_x: (self.xi_bar - direction_x * x).scale(compliance),
                slip_y: self.eta + self.psi * x - direction_y * x,
                state: State::Slip,
            }
            .classified(),
        }
    }
}

impl<F: Float> StripPoint<F> {
    /// Classifies slip: along the traction, or against it.
    pub(crate) fn classified(mut self) -> Self {
        if self.dissipation() < F::zero() {
            self.state = State::SlipNegativeDissipation;
        }
        self
    }
}
