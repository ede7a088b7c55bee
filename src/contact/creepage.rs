//! Creepage, spin, and the parameters of the strip theory (3.2)–(3.4), (5.13).

use crate::contact::Contact;
use crate::number::dual::Dual;
use crate::number::{Arithmetic, Float, Number, Real, are_finite, scaled_down};
use crate::status::Error;

/// Rigid slip of the upper relative to the lower body, divided by the rolling speed (3.3).
/// KSTRIP_WARNING_CREEPAGE if longitudinal or lateral is above 10 in size; KSTRIP_WARNING_SPIN_UNIT
/// if the spin is larger than bodies that roll on such a contact can have.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Creepage<T> {
    /// Longitudinal creepage \[-\], positive when the upper body slides in the rolling direction.
    pub longitudinal: T,
    /// Lateral creepage \[-\], positive along y.
    pub lateral: T,
    /// Spin \[1/m\], positive from x to y, that is about z into the lower body.
    pub spin: T,
}

/// Velocity of one body's material at the centre of the contact, relative to the contact.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SurfaceVelocity<F> {
    /// Along the rolling direction x \[m/s\]: about minus the rolling speed for both bodies.
    pub x: F,
    /// Lateral, along y \[m/s\].
    pub y: F,
    /// Angular velocity about the normal z into the lower body \[rad/s\].
    pub angular_z: F,
}

impl<F: Float> Creepage<F> {
    /// From the velocities of both bodies and the rolling speed `V > 0` \[m/s\].
    ///
    /// Only differences count: any frame that does not rotate relative to the contact is suitable.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::RollingSpeed`]; [`Error::Overflow`] when a quotient does not
    /// fit the floating-point type.
    ///
    /// # Example
    /// A wheel of 0.46 m turning at 21.8 rad/s while its axle moves at 10 m/s:
    /// ```
    /// use kstrip::contact::creepage::{Creepage, SurfaceVelocity};
    /// let rail = SurfaceVelocity { x: -10.0, y: 0.0, angular_z: 0.0 };
    /// let wheel = SurfaceVelocity { x: -21.8 * 0.46, y: 0.01, angular_z: 0.5 };
    /// let creepage = Creepage::from_velocities(&rail, &wheel, 10.0)?;
    /// assert!((creepage.longitudinal + 0.0028_f64).abs() < 1e-12 && creepage.spin == 0.05);
    /// # Ok::<(), kstrip::status::Error>(())
    /// ```
    pub fn from_velocities(
        lower: &SurfaceVelocity<F>, upper: &SurfaceVelocity<F>, rolling_speed: F,
    ) -> Result<Self, Error> {
        let inputs =
            [lower.x, lower.y, lower.angular_z, upper.x, upper.y, upper.angular_z, rolling_speed];
        Error::NotFinite.unless(are_finite(&inputs))?;
        Error::RollingSpeed.unless(rolling_speed > F::zero())?;
        // s = (V⁻ − V⁺)/V   (3.3)
        let creepage = Self {
            longitudinal: (upper.x - lower.x) / rolling_speed,
            lateral: (upper.y - lower.y) / rolling_speed,
            spin: (upper.angular_z - lower.angular_z) / rolling_speed,
        };
        creepage.check().map_err(|_| Error::Overflow)?;
        Ok(creepage)
    }

    /// # Errors
    /// [`Error::NotFinite`].
    pub fn check(&self) -> Result<(), Error> {
        Error::NotFinite.unless(are_finite(&[self.longitudinal, self.lateral, self.spin]))
    }
}

impl<F: Real> Creepage<F> {
    /// The three creepages as the first variables of the derivatives.
    #[must_use]
    #[inline]
    pub fn inputs<const VARIABLES: usize>(&self) -> Creepage<Dual<F, VARIABLES>> {
        Creepage {
            longitudinal: Dual::input(self.longitudinal, 0),
            lateral: Dual::input(self.lateral, 1),
            spin: Dual::input(self.spin, 2),
        }
    }

    pub(crate) fn scaled(&self, factor: F) -> Self {
        let Self { longitudinal, lateral, spin } = *self;
        Self { longitudinal: longitudinal * factor, lateral: lateral * factor, spin: spin * factor }
    }

    /// `F_x υx + F_y υy + M_z φ` \[N\]: the power of forces `[F_x, F_y, M_z]` \[N, N, N m\] divided
    /// by the rolling speed; positive where they follow the slip.
    #[inline]
    pub(crate) fn power(&self, [fx, fy, mz]: [F; 3]) -> F {
        fx * self.longitudinal + fy * self.lateral + mz * self.spin
    }

    /// `|υx| + |υy| + r |φ|`: no point within `r` of the centre slips faster, over rolling speed.
    #[inline]
    pub(crate) fn fastest_within(&self, reach: F) -> F {
        self.longitudinal.abs() + self.lateral.abs() + reach * self.spin.abs()
    }
}

/// Kalker's parameters of a rolling contact (5.13), with Poisson's ratio and the axis ratio.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<T: Number> {
    /// `ξ = υx G/(2 (1 − ν) μ p₀)`
    pub xi: T,
    /// `η = υy G/(2 μ p₀)`
    pub eta: T,
    /// `ψ = a φ G/(2 μ p₀)`
    pub psi: T,
    /// Poisson's ratio `ν`.
    pub poisson_ratio: T::Base,
    /// `a/b`, the semi-axis along the rolling direction divided by the one across.
    pub axis_ratio: T::Base,
}

impl<T: Number> Parameters<T> {
    /// The parameters of a checked contact and creepage.
    ///
    /// Values beyond [`Number::HUGE`], where every theory slides, are scaled back together so that
    /// their direction stays and their squares remain finite.
    #[must_use]
    pub fn new(contact: &Contact<T::Base>, creepage: &Creepage<T>) -> Self {
        Units::new(contact).parameters(creepage)
    }

    /// The creepage that has these parameters on a contact: the inverse of
    /// [`Parameters::new`].
    #[must_use]
    pub fn creepage(&self, contact: &Contact<T::Base>) -> Creepage<T> {
        let unit = contact.slip_unit();
        Creepage {
            longitudinal: self.xi.scale(unit * (T::Base::one() - self.poisson_ratio)),
            lateral: self.eta.scale(unit),
            spin: self.psi.scale(unit / contact.a),
        }
    }

    /// `p`, by which the effective longitudinal creepage falls per unit of `Y = y/b`: `ξ̄ = ξ − ψ
    /// (y/a)/(1 − ν) = ξ − p Y`.
    #[inline]
    #[must_use]
    pub fn spin_slope(&self) -> T {
        let width = (T::Base::one() - self.poisson_ratio) * self.axis_ratio;
        let huge = T::from_base(T::HUGE);
        self.psi.scale(T::Base::one() / width).clamped(-huge, huge)
    }
}

const THREE_OVER_PI: f64 = 3.0 / core::f64::consts::PI;

/// Factors that convert the creepages of one contact to Kalker's parameters (5.13).
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Units<F> {
    /// Semi-axis `a`
    a: F,
    /// `ξ/υx`, `η/υy`, which is also `ψ/(a φ)`
    longitudinal: F,
    lateral: F,
    poisson_ratio: F,
    /// `a/b`
    pub(crate) axis_ratio: F,
    /// `vx/ξ` and `φ/ψ`
    back: [F; 2],
}

impl<F: Real> Units<F> {
    #[inline(always)]
    pub(crate) fn new(contact: &Contact<F>) -> Self {
        let Contact { a, b, poisson_ratio, .. } = *contact;
        let (lateral, axis_ratio, one) = (contact.stiffness_ratio(), a / b, F::one());
        let longitudinal = lateral * (one / (one - poisson_ratio));
        let back = [one - poisson_ratio, one / axis_ratio.sqrt()].map(|of| of.times(THREE_OVER_PI));
        Self { a, longitudinal, lateral, poisson_ratio, axis_ratio, back }
    }

    #[inline(always)]
    pub(crate) fn parameters<T: Number<Base = F>>(&self, creepage: &Creepage<T>) -> Parameters<T> {
        let Self { a, longitudinal, lateral, poisson_ratio, axis_ratio, .. } = *self;
        let [vx, vy, a_phi] =
            scaled_down([creepage.longitudinal, creepage.lateral, creepage.spin.scale(a)], F::HUGE);
        let [xi, eta, psi] =
            scaled_down([vx.scale(longitudinal), vy.scale(lateral), a_phi.scale(lateral)], F::HUGE);
        Parameters { xi, eta, psi, poisson_ratio, axis_ratio }
    }

    /// `vx, vy = G a b (υx, υy)/(μ N)` and `φ = G (ab)^{3/2} ϕ/(μ N)`, the creepages in the units
    /// of the linear theory: `ξ = π vx/(3 (1 − ν))`, `η = π vy/3`, `ψ = (π/3) √(a/b) φ`.
    #[inline(always)]
    pub(crate) fn normalised<T: Number<Base = F>>(&self, parameters: &Parameters<T>) -> [T; 3] {
        let Parameters { xi, eta, psi, .. } = *parameters;
        let [by_xi, by_psi] = self.back;
        [xi.scale(by_xi), eta.times(THREE_OVER_PI), psi.scale(by_psi)]
    }
}

/// [`Units::normalised`] of a contact and its creepage.
#[inline]
pub(crate) fn normalised<T: Number>(contact: &Contact<T::Base>, creepage: &Creepage<T>) -> [T; 3] {
    let units = Units::new(contact);
    units.normalised(&units.parameters(creepage))
}

impl<F: Float> Parameters<F> {
    /// The limit of [`Parameters::new`] for vanishing friction or load: the same direction, its
    /// largest component at [`Number::HUGE`]; zero without creepage.
    #[must_use]
    pub fn sliding(contact: &Contact<F>, creepage: &Creepage<F>) -> Self {
        let direction = [
            creepage.longitudinal / (F::one() - contact.poisson_ratio),
            creepage.lateral,
            creepage.spin * contact.a,
        ];
        let [x, y, z] = direction.map(Arithmetic::abs);
        let largest = x.max(y).max(z);
        // Divide first: the quotients are at most 1.
        let [xi, eta, psi] = direction
            .map(|part| if largest > F::zero() { part / largest * F::HUGE } else { F::zero() });
        let (poisson_ratio, axis_ratio) = (contact.poisson_ratio, contact.a / contact.b);
        Self { xi, eta, psi, poisson_ratio, axis_ratio }
    }
}
