//! The same contact and motion in another precision.

use kstrip::contact::Contact;
use kstrip::contact::creepage::Creepage;
use kstrip::number::Float;

/// Without a mismatch.
pub fn converted<F: Float, G: Float>(c: &Contact<F>) -> Contact<G> {
    let Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, .. } = *c;
    let [a, b, normal_force, shear_modulus, poisson_ratio, friction] =
        [a, b, normal_force, shear_modulus, poisson_ratio, friction].map(|x| G::of(x.to_f64()));
    Contact { a, b, normal_force, shear_modulus, poisson_ratio, friction, mismatch: G::zero() }
}

pub fn converted_motion<F: Float, G: Float>(m: &Creepage<F>) -> Creepage<G> {
    let [longitudinal, lateral, spin] =
        [m.longitudinal, m.lateral, m.spin].map(|x| G::of(x.to_f64()));
    Creepage { longitudinal, lateral, spin }
}

pub fn single(c: &Contact<f64>) -> Contact<f32> {
    converted(c)
}

pub fn single_motion(m: &Creepage<f64>) -> Creepage<f32> {
    converted_motion(m)
}

/// A contact of single precision, exactly.
pub fn double(c: &Contact<f32>) -> Contact<f64> {
    converted(c)
}

pub fn double_motion(m: &Creepage<f32>) -> Creepage<f64> {
    converted_motion(m)
}
