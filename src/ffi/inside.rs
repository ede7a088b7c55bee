//! Inside the contact: pressure, traction, slip at points.

use super::support::*;

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
