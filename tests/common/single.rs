//! The same contact and motion in single precision.

#![allow(dead_code)]

use kstrip::contact::Contact;
use kstrip::contact::creepage::Creepage;

pub fn single(c: &Contact<f64>) -> Contact<f32> {
    Contact {
        a: c.a as f32,
        b: c.b as f32,
        normal_force: c.normal_force as f32,
        shear_modulus: c.shear_modulus as f32,
        poisson_ratio: c.poisson_ratio as f32,
        friction: c.friction as f32,
        mismatch: 0.0,
    }
}

pub fn single_motion(m: &Creepage<f64>) -> Creepage<f32> {
    Creepage { longitudinal: m.longitudinal as f32, lateral: m.lateral as f32, spin: m.spin as f32 }
}

/// A contact of single precision, exactly.
pub fn double(c: &Contact<f32>) -> Contact<f64> {
    Contact {
        a: c.a.into(),
        b: c.b.into(),
        normal_force: c.normal_force.into(),
        shear_modulus: c.shear_modulus.into(),
        poisson_ratio: c.poisson_ratio.into(),
        friction: c.friction.into(),
        mismatch: 0.0,
    }
}

pub fn double_motion(m: &Creepage<f32>) -> Creepage<f64> {
    let Creepage { longitudinal, lateral, spin } = *m;
    Creepage { longitudinal: longitudinal.into(), lateral: lateral.into(), spin: spin.into() }
}
