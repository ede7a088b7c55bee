//! The same contact in single precision.

use kstrip::contact::Contact;

pub fn single(c: &Contact<f64>) -> Contact<f32> {
    Contact {
        a: c.a as f32,
        b: c.b as f32,
        normal_force: c.normal_force as f32,
        shear_modulus: c.shear_modulus as f32,
        poisson_ratio: c.poisson_ratio as f32,
        friction: c.friction as f32,
    }
}
