//! Inside the contact: pressure, traction, slip at points.

use super::support::*;

/// Pressure, traction, slip and state over a grid; one point is a grid of one.
///
/// Under falling friction set the contact's friction to that of kstrip_evaluate(), and multiply its shear_modulus by the law's
/// slope_factor.
///
/// @param contact         ellipse, load, material, friction.
/// @param creepage        motion.
/// @param options         a model with strips; NULL and KSTRIP_MODEL_DEFAULT: KSTRIP_MODEL_STRIP.
/// @param x, columns      array of x [m] from the centre of the ellipse, and its size; outside is allowed.
/// @param y, rows         array of y [m] and its size.
/// @param[out] points     array of rows * columns elements; the point (x[i], y[j]) is
///                        points[j * columns + i].
/// @param capacity        size of points, at least rows * columns.
/// @return as kstrip_solve(); KSTRIP_ERROR_CAPACITY, KSTRIP_ERROR_NOT_IN_MODEL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_field(
    contact: Option<&Contact<f64>>,
    creepage: Option<&Creepage<f64>>,
    options: Option<&kstrip_options>,
    x: *const f64,
    columns: u32,
    y: *const f64,
    rows: u32,
    points: *mut FieldPoint<f64>,
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
        Ok(field.notice)
    })
}

/// The points of a grid, strip by strip.
pub(super) fn write_grid<F: Float, S>(
    x: &[F],
    y: &[F],
    out: &mut [MaybeUninit<FieldPoint<F>>],
    strip_at: impl Fn(F) -> S,
    along: impl Fn(&S, F) -> FieldPoint<F>,
) -> Result<(), Error> {
    Error::NotFinite.unless(are_finite(x) && are_finite(y))?;
    let points = x.len().checked_mul(y.len());
    Error::Capacity.unless(points.is_some_and(|points| points <= out.len()))?;
    let mut places = out.iter_mut();
    for &y in y {
        let strip = strip_at(y);
        for (&x, place) in x.iter().zip(&mut places) {
            place.write(along(&strip, x));
        }
    }
    Ok(())
}
