//! Implausible inputs: numbers that no contact of two bodies has. Their usual cause is a wrong
//! unit.
//!
//! The result is valid and comes with a warning that names the quantity. These quantities are
//! tested:
//!
//! | quantity | implausible | typical cause | ordinary contacts |
//! |---|---|---|---|
//! | pressure | `p₀ > 0.1 G` | `G` in MPa or GPa | wheel on rail 0.02 to 0.04, bearings 0.06 |
//! | shear modulus | `G > 150 GPa` | Young's modulus; above 10 TPa another unit | 82 GPa |
//! | creepage | `\|υx\|` or `\|υy\| > 10` | per cent | a locked wheel has 1 |
//! | semi-axis | `a` or `b > 1 m` | mm | 0.1 mm to 30 mm |
//! | spin | `\|φ\| √(ab) > 0.05` and `\|φ\| a > 5 p₀/G` | degrees per metre | see below |
//! | friction | `μ > 5` | per cent | up to 2 |
//! | radius | both summed curvatures below 0.2/m | mm | a wheel has 2/m, the roll of a mill 1/m |
//! | mismatch | `\|κ\| > 0.25` | no reference there | steel on a polymer has -0.15 |
//! | conformity | `a` or `b` above 0.3 of its smaller radius | no half-spaces there | 0.05 |
//!
//! **Spin.** A body of radius `R` that rolls with the contact inclined by `γ` to its axis spins
//! with `φ = tan γ/R`, and Hertz has `a/R = (π/2)(1 − ν) p₀/G` (a circle). So `φ a G/p₀` is about
//! `tan γ`: 3 on a wheel flange of 70 degrees, 1 in a ball bearing, and 57 times as much in degrees
//! per metre, which is detected from `γ = 5°` on. Where the ellipse does not follow the load, a
//! small load raises that quotient. For this reason `|φ| √(ab)` is tested as well: it is the slip
//! by spin at the edge of the contact divided by the rolling speed, 0.01 on the flange and 0.05 to
//! 0.1 in a ball bearing.
//!
//! Two cases cannot be detected. A creepage of 0.1 to 10 is sliding, whether or not it was meant as
//! per cent; creep curves in per cent are detected at their end. The spin of a tread contact, 0.1
//! rad/m, looks in degrees like that of a flange.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::number::{Float, Real};
use crate::status::Warning;
use core::f64::consts::PI;

/// Largest plausible `p₀/G`.
pub(crate) const LARGEST_PRESSURE: f64 = 0.1;
/// Largest plausible `|υ|`.
pub(crate) const LARGEST_CREEPAGE: f64 = 10.0;
/// Spin up to which contacts are of the usual sizes \[1/m\].
const USUAL_SPIN: f64 = 1e4;
/// Largest plausible `a`, `b` \[m\].
const LARGEST_SEMI_AXIS: f64 = 1.0;
/// Largest plausible `μ`.
pub(crate) const LARGEST_FRICTION: f64 = 5.0;
/// Largest plausible shear modulus \[Pa\], and that of any unit; hard metal has 1.5e11 to 2.7e11.
pub(crate) const LARGEST_MODULUS: f64 = 1.5e11;
pub(crate) const LARGEST_MODULUS_OF_ANY_UNIT: f64 = 1e13;
/// Largest plausible radius \[m\].
pub(crate) const LARGEST_RADIUS: f64 = 5.0;
/// Largest `|κ|` that was compared with the reference.
pub(crate) const LARGEST_MISMATCH: f64 = 0.25;
/// `|φ| √(ab)` up to which every spin is plausible.
const EDGE_SLIP: f64 = 0.05;
/// `|φ| a G/p₀` up to which a larger spin is plausible.
const LARGEST_INCLINATION: f64 = 5.0;
/// Half of the least plausible value of the larger summed curvature \[1/m\].
pub(super) const SMALLEST_CURVATURE: f64 = 0.5 / LARGEST_RADIUS;

/// What is implausible about a contact and its creepage, if anything; the contact is examined
/// first. Nothing is implausible about a lost contact.
#[must_use]
pub fn implausibility<F: Float>(contact: &Contact<F>, creepage: &Creepage<F>) -> Warning {
    let of_contact = contact.plausibility();
    if of_contact != Warning::None || contact.is_lost() {
        return of_contact;
    }
    let Creepage { longitudinal, lateral, spin } = *creepage;
    let Contact { a, b, normal_force, .. } = *contact;
    let largest = F::constant(LARGEST_CREEPAGE);
    if longitudinal.abs() > largest || lateral.abs() > largest {
        return Warning::Creepage;
    }
    // φ √(ab) > 0.05, squared;  φ a > 5 p₀/G with p₀ = 3N/(2π a b)
    let size = spin.abs() * a;
    let at_the_edge = size * (spin.abs() * b);
    if at_the_edge > F::constant(EDGE_SLIP * EDGE_SLIP)
        && size * contact.tangential_stiffness()
            > normal_force.times(LARGEST_INCLINATION * 1.5 / PI)
    {
        return Warning::Spin;
    }
    Warning::None
}

impl<F: Real> Contact<F> {
    /// Whether the numbers are of the usual sizes, 1 µm to 1 m, up to GN and 150 GPa; of several
    /// contacts side by side, whether all are. With creepages of such sizes no check can fail in
    /// either precision, because all products and quotients lie below 1e36. This takes a few
    /// comparisons instead of five divisions.
    #[inline(always)]
    pub(crate) fn is_usual(&self) -> bool {
        let Self { a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch } = *self;
        let (shortest, longest) = (F::of(1e-6), F::of(LARGEST_SEMI_AXIS));
        a.lies_between(shortest, longest)
            && b.lies_between(shortest, longest)
            && normal_force.lies_within(F::of(1e9))
            && shear_modulus.lies_between(F::of(1.0), F::of(LARGEST_MODULUS))
            && poisson_ratio.lies_within(F::of(0.5))
            && friction.lies_within(F::of(LARGEST_FRICTION))
            && mismatch.abs().lies_within(F::of(LARGEST_MISMATCH))
    }

    /// Whether the numbers and those of the creepage are of the usual sizes, so that no check can
    /// fail and [`warning`] returns nothing; for several contacts side by side, whether this holds
    /// for all of them. The test takes a few comparisons, and refuses a few contacts that would
    /// pass every check.
    #[inline(always)]
    pub(crate) fn is_ordinary(&self, creepage: &Creepage<F>) -> bool {
        let Creepage { longitudinal, lateral, spin } = *creepage;
        let load = self.normal_force.times(1.5 / PI);
        let size = spin.abs() * self.a;
        let edge = size * (spin.abs() * self.b);
        self.is_usual()
            && longitudinal.abs().lies_within(F::of(LARGEST_CREEPAGE))
            && lateral.abs().lies_within(F::of(LARGEST_CREEPAGE))
            && spin.abs().lies_within(F::of(USUAL_SPIN))
            && !load.exceeds(self.tangential_stiffness().times(LARGEST_PRESSURE))
            && (!edge.exceeds(F::of(EDGE_SLIP * EDGE_SLIP))
                || !(size * self.tangential_stiffness()).exceeds(load.times(LARGEST_INCLINATION)))
    }

    /// `G a b` \[N\]
    #[inline]
    pub(crate) fn tangential_stiffness(&self) -> F {
        (self.shear_modulus * self.a) * self.b
    }
}

impl<F: Float> Contact<F> {
    /// A spin up to which the contact [is ordinary](Contact::is_ordinary) with any `|υ|` up to 10
    /// \[1/m\]: slightly less than the largest such spin, or zero for a contact that is not
    /// ordinary.
    pub(crate) fn ordinary_spin(&self) -> F {
        let load = self.normal_force.times(1.5 / PI);
        if !self.is_usual() || load > self.tangential_stiffness().times(LARGEST_PRESSURE) {
            return F::zero();
        }
        let at_the_edge = F::constant(EDGE_SLIP) / (self.a * self.b).sqrt();
        let inclined = load.times(LARGEST_INCLINATION) / (self.tangential_stiffness() * self.a);
        at_the_edge.max(inclined).min(F::constant(USUAL_SPIN)).times(0.999_99)
    }

    /// What is implausible about the contact alone, if anything; nothing about a lost contact.
    #[must_use]
    pub fn plausibility(&self) -> Warning {
        let Self { a, b, normal_force, shear_modulus, friction, mismatch, .. } = *self;
        // p₀ = 3N/(2π a b) > 0.1 G
        let pressed = self.tangential_stiffness().times(LARGEST_PRESSURE);
        if self.is_lost() {
            return Warning::None;
        }
        Warning::first(&[
            (a.max(b) > F::constant(LARGEST_SEMI_AXIS), Warning::SemiAxis),
            (normal_force.times(1.5 / PI) > pressed, Warning::Pressure),
            (shear_modulus > F::constant(LARGEST_MODULUS_OF_ANY_UNIT), Warning::Modulus),
            (shear_modulus > F::constant(LARGEST_MODULUS), Warning::Young),
            (friction > F::constant(LARGEST_FRICTION), Warning::Friction),
            (mismatch.abs() > F::constant(LARGEST_MISMATCH), Warning::Mismatch),
        ])
    }
}
