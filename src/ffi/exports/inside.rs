//! Inside the contact: pressure, traction, slip at points.

use super::F;
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::ffi::support::{for_strips, given, input, output, status_of};
use crate::ffi::types::kstrip_options;
use crate::forces::field::FieldPoint;
use crate::friction::SlipFriction;
use crate::friction::field::LawField;
use crate::number::are_finite;
use crate::status::{Error, kstrip_status};
use core::mem::MaybeUninit;

/// Pressure, traction, slip and state over a grid; one point is a grid of one. Integrals of
/// traction and dissipation are near the forces and the power of kstrip_evaluate().
///
/// @param contact, creepage, friction  as in kstrip_evaluate().
/// @param options         a model with strips; NULL and KSTRIP_MODEL_DEFAULT: KSTRIP_MODEL_STRIP.
/// @param x, columns      array of x [m] from the centre of the ellipse, and its size; outside is
///                        allowed.
/// @param y, rows         array of y [m] and its size.
/// @param[out] points     array of rows * columns elements; the point (x[i], y[j]) is
///                        points[j * columns + i].
/// @param capacity        size of points, at least rows * columns.
/// @return as kstrip_evaluate(); KSTRIP_ERROR_CAPACITY (capacity is below rows * columns);
///         KSTRIP_ERROR_NOT_IN_MODEL (KSTRIP_MODEL_TOTAL and KSTRIP_MODEL_LINEAR have no field).
#[unsafe(export_name = symbol!("kstrip_field"))]
pub unsafe extern "C" fn kstrip_field(
    contact: Option<&Contact<F>>, creepage: Option<&Creepage<F>>,
    friction: Option<&SlipFriction<F>>, options: Option<&kstrip_options>, x: *const F,
    columns: u32, y: *const F, rows: u32, points: *mut FieldPoint<F>, capacity: u32,
) -> kstrip_status {
    // SAFETY: NULL or as many elements as the counts say, says the header.
    let grid = unsafe { FieldGrid::new((x, columns), (y, rows), (points, capacity)) };
    status_of(|| {
        let (contact, creepage, options) =
            (given(contact)?, given(creepage)?, for_strips(options)?);
        let field = LawField::new(contact, creepage, friction, &options)?;
        grid?.write(|y| field.strip_at(y), |strip, x| field.along(strip, x))?;
        Ok(field.warning)
    })
}

/// The places of a grid, and where their points go.
pub(super) struct FieldGrid<'a> {
    x: &'a [F],
    y: &'a [F],
    points: &'a mut [MaybeUninit<FieldPoint<F>>],
}

impl FieldGrid<'_> {
    /// # Safety
    /// The arrays are NULL, or valid for as many elements as stand beside them.
    pub(super) unsafe fn new(
        (x, columns): (*const F, u32), (y, rows): (*const F, u32),
        (points, capacity): (*mut FieldPoint<F>, u32),
    ) -> Result<Self, Error> {
        // SAFETY: the caller's promise.
        unsafe {
            Ok(Self {
                x: input(x, columns)?,
                y: input(y, rows)?,
                points: output(points, capacity)?,
            })
        }
    }

    /// Writes the points, strip by strip.
    pub(super) fn write<S>(
        self, strip_at: impl Fn(F) -> S, along: impl Fn(&S, F) -> FieldPoint<F>,
    ) -> Result<(), Error> {
        let Self { x, y, points } = self;
        Error::NotFinite.unless(are_finite(x) && are_finite(y))?;
        let count = x.len().checked_mul(y.len());
        Error::Capacity.unless(count.is_some_and(|count| count <= points.len()))?;
        let mut places = points.iter_mut();
        for &y in y {
            let strip = strip_at(y);
            for (&x, place) in x.iter().zip(&mut places) {
                place.write(along(&strip, x));
            }
        }
        Ok(())
    }
}
