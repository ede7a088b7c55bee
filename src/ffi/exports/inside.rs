//! Inside the contact: pressure, traction, slip at points.

use super::F;
use crate::ffi::inside::*;
use crate::ffi::support::*;

/// Pressure, traction, slip and state over a grid; one point is a grid of one.
///
/// Under falling friction set the contact's friction to that of kstrip_evaluate(), and multiply its
/// shear_modulus by the law's slope_factor.
///
/// @param contact         ellipse, load, material, friction.
/// @param creepage        motion.
/// @param options         a model with strips; NULL and KSTRIP_MODEL_DEFAULT: KSTRIP_MODEL_STRIP.
/// @param x, columns      array of x [m] from the centre of the ellipse, and its size; outside is
///                        allowed.
/// @param y, rows         array of y [m] and its size.
/// @param[out] points     array of rows * columns elements; the point (x[i], y[j]) is
///                        points[j * columns + i].
/// @param capacity        size of points, at least rows * columns.
/// @return as kstrip_solve(); KSTRIP_ERROR_CAPACITY, KSTRIP_ERROR_NOT_IN_MODEL.
#[unsafe(export_name = symbol!("kstrip_field"))]
pub unsafe extern "C" fn kstrip_field(
    contact: Option<&Contact<F>>,
    creepage: Option<&Creepage<F>>,
    options: Option<&kstrip_options>,
    x: *const F,
    columns: u32,
    y: *const F,
    rows: u32,
    points: *mut FieldPoint<F>,
    capacity: u32,
) -> kstrip_status {
    // SAFETY: NULL or as many elements as the counts say, says the header.
    let (x, y, points) = unsafe { (input(x, columns), input(y, rows), output(points, capacity)) };
    answer(|| {
        let (contact, creepage, options) =
            (given(contact)?, given(creepage)?, for_strips(options)?);
        let field = Field::new(contact, creepage, &options)?;
        let along = |strip: &Option<_>, x| field.along(strip.as_ref(), x);
        write_grid(x?, y?, points?, |y| field.strip_at(y), along)?;
        Ok(field.warning)
    })
}
