//! The curvatures of two bodies where they touch.

/// Radii of curvature of two bodies at the contact \[m\]: convex positive, flat infinite
/// (INFINITY), concave negative. Zero and NaN are errors.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Radii<F> {
    /// Lower body in the plane of x and z (a straight rail: INFINITY).
    pub lower_x: F,
    /// Lower body in the plane of y and z (a rail: radius of the head).
    pub lower_y: F,
    /// Upper body in the plane of x and z (a wheel: rolling radius).
    pub upper_x: F,
    /// Upper body in the plane of y and z (a wheel: radius of the profile, INFINITY if conical).
    pub upper_y: F,
}
