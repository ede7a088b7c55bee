//! Dissimilar materials: the creepage that pressure makes (Section 4.1 neglects it).
//!
//! Pressure moves the surfaces of dissimilar half-spaces tangentially by different amounts, lower
//! minus upper `u = −(κ/(π G)) ∫ p (x − x')/r²`, hence `div u = −(2κ/G) p`. A semi-ellipsoid of
//! pressure is a pile of uniform ellipses, and inside each of them `∂u/∂x = −(2κ/G) p b/(a + b)`.
//! Rolling through it is a creepage, to be added to the longitudinal one:
//!
//! ```text
//! Δυx = −c' κ N/(G a (a + b))
//! c' = 16/π³ − 0.057 g/(g + 0.45)   in full adhesion, g = a/b: derived for g → 0,
//!                                   the rest computed with CONTACT
//! c' = 9/(4π)                       in full slip: the mean weighted with pressure
//! ```
//!
//! `∂v/∂x` is odd in `x` and `y`: no lateral part, no moment. Between adhesion and slip `c'` is a
//! quotient of squares of linear forces (`share`) fitted to cases of CONTACT by
//! `fit/fit_mismatch.py`: it is smaller where the pressure's own slip saturates the rear of the
//! contact.
//!
//! **Power.** Friction does its work on the whole slip: `P = F_x (υx + Δυx) + F_y υy + M_z φ ≥ 0`.
//! The load supplies the part `F_x Δυx`: in dissimilar bodies tangential traction tilts the
//! pressure, and the rolling motion works against the tilted pressure.

use crate::contact::Contact;
use crate::contact::creepage::{Creepage, Units};
use crate::linear::LinearCoefficients;
use crate::number::dual::Dual;
use crate::number::{Arithmetic, Float, Number, Real};
use core::f64::consts::PI;

/// `c'` of full adhesion for `a ≪ b`, and of full slip.
const FULL_ADHESION: f64 = 16.0 / (PI * PI * PI);
const FULL_SLIP: f64 = 9.0 / (4.0 * PI);
/// Decrease of the `c'` of full adhesion with the axis ratio, and the axis ratio where half of it
/// is reached.
const WIDE: [f64; 2] = [0.057, 0.45];
/// Linear forces beyond which nothing changes.
const LARGEST_LINEAR: f64 = 1e4;

mod fitted {
    //! Fitted by `fit/fit_mismatch.py`, which prints them.

    /// Linear force half way between adhesion and slip.
    pub(super) const HALF: f64 = 4.535;
    /// Weights of the force of the pressure itself and of that of spin there.
    pub(super) const PRESSURE: f64 = 2.7;
    pub(super) const SPIN: f64 = 6.692;
    /// Saturated rear: weights of the forces of pressure, creepage and spin.
    pub(super) const REAR: [f64; 3] = [1.192, 0.707, 2.379];
    /// `c'` of a saturated rear.
    pub(super) const SATURATED: f64 = 0.307;
}

impl<F: Real> Contact<F> {
    /// `κ N/(G a (a + b))` \[–\], which [`shift`] multiplies by `−c'`.
    #[inline]
    pub(crate) fn strain(&self) -> F {
        let Self { a, b, normal_force, shear_modulus, mismatch, .. } = *self;
        mismatch * normal_force / a / (a + b) / shear_modulus
    }

    /// `|υx| + |s| + |υy| + (a + b) |φ|` with the strain `s`: no point of the contact slips faster,
    /// over rolling speed.
    #[inline(always)]
    pub(crate) fn fastest_slip(&self, creepage: &Creepage<F>) -> F {
        creepage.longitudinal.abs()
            + self.strain().abs()
            + creepage.lateral.abs()
            + (self.a + self.b) * creepage.spin.abs()
    }
}

/// `Δυx` for a creepage and [`Contact::strain`].
#[inline]
pub(crate) fn shift<T: Number>(
    units: &Units<T::Base>, linear: &LinearCoefficients<T::Base>, creepage: &Creepage<T>, strain: T,
) -> T {
    let zero = T::zero();
    let of_pressure = Creepage { longitudinal: strain, lateral: zero, spin: zero };
    let [vx, vy, phi] = units.normalised(&units.parameters(creepage));
    let [d, ..] = units.normalised(&units.parameters(&of_pressure));
    let LinearCoefficients { c11, c22, c23, .. } = *linear;
    let adhesion = full_adhesion(units.axis_ratio);
    let forces = [vx.scale(c11), vy.scale(c22), phi.scale(c23), d.scale(c11 * adhesion)];
    -(share(forces.map(|force| force.within(LARGEST_LINEAR)), adhesion) * strain)
}

/// The creepage of an ellipse with that of the pressure, which has a factor of one that may be a
/// variable of derivatives.
#[inline]
pub(crate) fn with_pressure<T: Number>(
    contact: &Contact<T::Base>, linear: &LinearCoefficients<T::Base>, creepage: &Creepage<T>,
    pressure: T,
) -> Creepage<T> {
    if !contact.mismatch.abs().exceeds(T::Base::zero()) {
        return *creepage;
    }
    let strain = pressure.scale(contact.strain());
    let longitudinal =
        creepage.longitudinal + shift(&Units::new(contact), linear, creepage, strain);
    Creepage { longitudinal, ..*creepage }
}

/// `c'` of full adhesion.
#[inline]
fn full_adhesion<F: Real>(axis_ratio: F) -> F {
    let [height, half] = WIDE;
    F::of(FULL_ADHESION) - axis_ratio.times(height) / axis_ratio.plus(half)
}

/// `c'` between adhesion and slip, from the linear forces of longitudinal and lateral creepage, of
/// spin, and of the pressure, against which a creepage of the same sign acts.
#[inline]
fn share<T: Number>([lx, ly, ls, d]: [T; 4], adhesion: T::Base) -> T {
    let translation = lx.squared() + ly.squared();
    let others = ls.times(fitted::SPIN).squared() + d.times(fitted::PRESSURE).squared();
    let slip = (translation + others).times(1.0 / (fitted::HALF * fitted::HALF)).squared();
    let [of_pressure, of_creepage, of_spin] = fitted::REAR;
    let along = d.times(of_pressure) - lx.times(of_creepage);
    let rear = along.squared() + ls.times(of_spin).squared();
    let sum = slip.times(FULL_SLIP) + rear.times(fitted::SATURATED) + T::from_base(adhesion);
    sum / (slip + rear).plus(1.0)
}

/// `Δυx` with its derivatives with respect to the creepages, and `κ ∂Δυx/∂κ`.
#[inline(never)]
pub(crate) fn shift_with_slopes<F: Float>(
    contact: &Contact<F>, units: &Units<F>, creepage: &Creepage<F>,
) -> Dual<F, 4> {
    let linear = LinearCoefficients::at(units.axis_ratio, contact.poisson_ratio);
    let strain = contact.strain();
    let mut found = shift(units, &linear, &creepage.inputs(), Dual::<F, 4>::input(strain, 3));
    let [.., by_strain] = &mut found.gradient;
    *by_strain = *by_strain * strain;
    found
}

/// The same of the linear theory, which has adhesion everywhere.
pub(crate) fn linear_shift<F: Float>(contact: &Contact<F>) -> Dual<F, 4> {
    let value = -(full_adhesion(contact.a / contact.b) * contact.strain());
    Dual { value, gradient: [F::zero(), F::zero(), F::zero(), value] }
}
