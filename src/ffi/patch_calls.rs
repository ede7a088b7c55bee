//! What the exported functions of patches do, generic over the precision.

use super::calls::{Out, OutArray, given, write_grid, write_rows};
use super::patch_types::*;
use super::{KSTRIP_PATCH_CAPACITY, answer, checked_options, kstrip_status, types::kstrip_options};
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::contact::forces::StripCount;
use crate::number::Float;
use crate::patch::kik_piotrowski::{Indentation, ProfileContact};
use crate::patch::solver::{self, PatchField};
use crate::patch::{self, Patch, PatchStrip, PatchView, QuadratureScale};
use crate::solve::field::FieldPoint;
use crate::solve::model::{Precision, Solution, StripResult};
use crate::status::{Error, Notice};
use core::mem::{MaybeUninit, offset_of};

/// A patch that C stores.
pub(super) trait Stored: Copy {
    /// The precision.
    type Float: Precision;
    /// A strip as C stores it.
    type Strip: Copy;

    /// Without strips: all bits zero, so that it takes no place in the program.
    const ZERO: Self;

    /// Its strips as those of the core.
    fn strips(strips: &[Self::Strip]) -> &[PatchStrip<Self::Float>];

    /// The places of all strips, and of their number.
    fn places(&mut self) -> (&mut [Self::Strip], &mut u32);

    /// The places of `G`, `ν` and the factors of the quadrature.
    fn constants(&mut self) -> [&mut Self::Float; 4];

    /// From the core.
    fn strip(strip: PatchStrip<Self::Float>) -> Self::Strip;

    /// Checked.
    fn view(&self) -> Result<PatchView<'_, Self::Float>, Error>;

    /// Adds a strip, and tells whether there was room.
    fn push(&mut self, strip: PatchStrip<Self::Float>) -> bool {
        let (places, count) = self.places();
        match places.get_mut(*count as usize) {
            Some(place) => {
                *place = Self::strip(strip);
                *count = count.saturating_add(1);
                true
            }
            None => false,
        }
    }

    /// Multiplies the friction of all strips, and the shear modulus.
    fn soften(&mut self, friction: Self::Float, stiffness: Self::Float) {
        let [shear_modulus, ..] = self.constants();
        *shear_modulus = *shear_modulus * stiffness;
        let (strips, count) = self.places();
        for strip in strips.iter_mut().take(*count as usize) {
            let own = Self::strips(core::slice::from_ref(strip)).first();
            if let Some(&own) = own {
                *strip = Self::strip(PatchStrip { friction: own.friction * friction, ..own });
            }
        }
    }

    /// Sets the material and the factors.
    fn set(&mut self, shear_modulus: Self::Float, poisson_ratio: Self::Float, scale: Scale<Self>) {
        let values = [shear_modulus, poisson_ratio, scale.area, scale.lever];
        for (place, value) in self.constants().into_iter().zip(values) {
            *place = value;
        }
    }
}

type Scale<P> = QuadratureScale<<P as Stored>::Float>;

macro_rules! stored {
    ($float:ident, $patch:ident, $strip:ident, $summary:ident, $contact:ident, $result:ident) => {
        const _: () = {
            assert!(size_of::<$strip>() == size_of::<PatchStrip<$float>>());
            assert!(align_of::<$strip>() == align_of::<PatchStrip<$float>>());
            assert!(offset_of!($strip, y) == offset_of!(PatchStrip<$float>, y));
            assert!(offset_of!($strip, width) == offset_of!(PatchStrip<$float>, width));
            assert!(offset_of!($strip, half_length) == offset_of!(PatchStrip<$float>, half_length));
            assert!(offset_of!($strip, centre_x) == offset_of!(PatchStrip<$float>, centre_x));
            assert!(
                offset_of!($strip, peak_pressure) == offset_of!(PatchStrip<$float>, peak_pressure)
            );
            assert!(offset_of!($strip, friction) == offset_of!(PatchStrip<$float>, friction));
        };

        impl Stored for $patch {
            type Float = $float;
            type Strip = $strip;

            const ZERO: Self = {
                let strip = $strip {
                    y: 0.0,
                    width: 0.0,
                    half_length: 0.0,
                    centre_x: 0.0,
                    peak_pressure: 0.0,
                    friction: 0.0,
                };
                Self {
                    strips: [strip; KSTRIP_PATCH_CAPACITY],
                    shear_modulus: 0.0,
                    poisson_ratio: 0.0,
                    area_scale: 0.0,
                    lever_scale: 0.0,
                    count: 0,
                    reserved: 0,
                }
            };

            fn strips(strips: &[$strip]) -> &[PatchStrip<$float>] {
                // SAFETY: the same members at the same places, as asserted above.
                unsafe { core::slice::from_raw_parts(strips.as_ptr().cast(), strips.len()) }
            }

            fn places(&mut self) -> (&mut [$strip], &mut u32) {
                (&mut self.strips, &mut self.count)
            }

            fn constants(&mut self) -> [&mut $float; 4] {
                let Self { shear_modulus, poisson_ratio, area_scale, lever_scale, .. } = self;
                [shear_modulus, poisson_ratio, area_scale, lever_scale]
            }

            fn strip(strip: PatchStrip<$float>) -> $strip {
                let PatchStrip { y, width, half_length, centre_x, peak_pressure, friction } = strip;
                $strip { y, width, half_length, centre_x, peak_pressure, friction }
            }

            fn view(&self) -> Result<PatchView<'_, $float>, Error> {
                let strips = self.strips.get(..self.count as usize).ok_or(Error::PatchSize)?;
                let scale = QuadratureScale { area: self.area_scale, lever: self.lever_scale };
                PatchView::new(Self::strips(strips), self.shear_modulus, self.poisson_ratio, scale)
            }
        }

        impl From<$contact> for ProfileContact<$float> {
            fn from(contact: $contact) -> Self {
                let $contact {
                    rolling_radius,
                    normal_force,
                    shear_modulus,
                    poisson_ratio,
                    friction,
                } = contact;
                Self { rolling_radius, normal_force, shear_modulus, poisson_ratio, friction }
            }
        }

        impl From<Indentation<$float>> for $result {
            fn from(found: Indentation<$float>) -> Self {
                let Indentation {
                    penetration,
                    peak_pressure,
                    normal_force,
                    deepest_y,
                    iterations,
                    ..
                } = found;
                Self {
                    penetration,
                    peak_pressure,
                    normal_force,
                    deepest_y,
                    iterations,
                    reserved: 0,
                }
            }
        }

        impl From<PatchView<'_, $float>> for $summary {
            fn from(view: PatchView<$float>) -> Self {
                Self {
                    normal_force: view.normal_force(),
                    friction_bound: view.friction_bound(),
                    area: view.area() * view.scale().area,
                    lobes: view.lobes().count() as u32,
                    reserved: 0,
                }
            }
        }
    };
}

stored!(
    f64,
    kstrip_patch,
    kstrip_patch_strip,
    kstrip_patch_summary,
    kstrip_profile_contact,
    kstrip_profile_result
);
stored!(
    f32,
    kstrip_patch_f32,
    kstrip_patch_strip_f32,
    kstrip_patch_summary_f32,
    kstrip_profile_contact_f32,
    kstrip_profile_result_f32
);

pub(super) fn from_ellipse<P: Stored, C: Copy>(
    contact: Option<&C>,
    strips: i32,
    out: Out<P>,
) -> kstrip_status
where
    Contact<P::Float>: From<C>,
{
    answer(|| {
        let (contact, out) = (Contact::from(*given(contact)?), given(out)?);
        let count = StripCount::from_number(strips).ok_or(Error::StripCount)?;
        patch::check_ellipse(&contact, count)?;
        let patch = out.write(P::ZERO);
        let scale = patch::ellipse(&contact, count, |strip| patch.push(strip))?;
        patch.set(contact.shear_modulus, contact.poisson_ratio, scale);
        Ok(Notice::None)
    })
}

pub(super) fn from_strips<P: Stored>(
    strips: Result<&[P::Strip], Error>,
    shear_modulus: P::Float,
    poisson_ratio: P::Float,
    out: Out<P>,
) -> kstrip_status {
    answer(|| {
        let (strips, out) = (P::strips(strips?), given(out)?);
        if strips.len() > KSTRIP_PATCH_CAPACITY {
            return Err(Error::PatchSize);
        }
        match PatchView::new(strips, shear_modulus, poisson_ratio, QuadratureScale::default()) {
            Ok(view) => write_patch(&view, out),
            Err(Error::StripOrder) => sorted(strips, shear_modulus, poisson_ratio, out)?,
            Err(error) => return Err(error),
        }
        Ok(Notice::None)
    })
}

fn write_patch<P: Stored>(view: &PatchView<P::Float>, out: &mut MaybeUninit<P>) {
    let patch = out.write(P::ZERO);
    for strip in view.strips() {
        patch.push(*strip);
    }
    patch.set(view.shear_modulus(), view.poisson_ratio(), view.scale());
}

/// Strips in any order. Out of line, because of the copy on the stack.
#[inline(never)]
fn sorted<P: Stored>(
    strips: &[PatchStrip<P::Float>],
    shear_modulus: P::Float,
    poisson_ratio: P::Float,
    out: &mut MaybeUninit<P>,
) -> Result<(), Error> {
    let patch =
        Patch::<_, KSTRIP_PATCH_CAPACITY>::from_strips(strips, shear_modulus, poisson_ratio)?;
    write_patch(&patch.view()?, out);
    Ok(())
}

pub(super) fn from_profile<P: Stored, C: Copy, R: From<Indentation<P::Float>>>(
    y: Result<&[P::Float], Error>,
    distance: Result<&[P::Float], Error>,
    contact: Option<&C>,
    strips: i32,
    out: Out<P>,
    result: Out<R>,
) -> kstrip_status
where
    ProfileContact<P::Float>: From<C>,
{
    answer(|| {
        let (y, distance, contact) = (y?, distance?, ProfileContact::from(*given(contact)?));
        let (out, result) = (given(out)?, given(result)?);
        let count = StripCount::from_number(strips).ok_or(Error::StripCount)?;
        let (patch, found) =
            Patch::<_, KSTRIP_PATCH_CAPACITY>::from_profile(y, distance, &contact, count)?;
        write_patch(&patch.view()?, out);
        result.write(found.into());
        Ok(Notice::None)
    })
}

pub(super) fn summary<'a, P: Stored, S: From<PatchView<'a, P::Float>>>(
    patch: Option<&'a P>,
    out: Out<S>,
) -> kstrip_status {
    answer(|| {
        let (view, out) = (given(patch)?.view()?, given(out)?);
        out.write(view.into());
        Ok(Notice::None)
    })
}

pub(super) fn solve<P: Stored, K: Copy, R: From<Solution<P::Float>>>(
    patch: Option<&P>,
    creepage: Option<&K>,
    options: Option<&kstrip_options>,
    out: Out<R>,
) -> kstrip_status
where
    Creepage<P::Float>: From<K>,
{
    answer(|| {
        let (patch, creepage) = (given(patch)?, Creepage::from(*given(creepage)?));
        let (options, out) = (checked_options(options)?, given(out)?);
        let solution = solver::solve(&patch.view()?, &creepage, options.model)?;
        let notice = solution.notice;
        out.write(solution.into());
        Ok(notice)
    })
}

pub(super) fn jacobian<P: Stored, K: Copy, R: From<Solution<P::Float>>>(
    patch: Option<&P>,
    creepage: Option<&K>,
    options: Option<&kstrip_options>,
    out: Out<R>,
    entries: OutArray<P::Float>,
) -> kstrip_status
where
    Creepage<P::Float>: From<K>,
{
    answer(|| {
        let (patch, creepage) = (given(patch)?, Creepage::from(*given(creepage)?));
        let (options, out, entries) = (checked_options(options)?, given(out)?, entries?);
        let (solution, jacobian) =
            solver::solve_jacobian(&patch.view()?, &creepage, options.model)?;
        let notice = solution.notice;
        out.write(solution.into());
        write_rows(&jacobian, entries);
        Ok(notice)
    })
}

pub(super) fn strips<P: Stored, K: Copy, S: From<StripResult<P::Float>>>(
    patch: Option<&P>,
    creepage: Option<&K>,
    options: Option<&kstrip_options>,
    out: OutArray<S>,
    count: Out<u32>,
) -> kstrip_status
where
    Creepage<P::Float>: From<K>,
{
    answer(|| {
        let (patch, creepage) = (given(patch)?, Creepage::from(*given(creepage)?));
        let (options, out, count) = (checked_options(options)?, out?, given(count)?);
        let view = patch.view()?;
        if view.strips().len() > out.len() {
            return Err(Error::Capacity);
        }
        let mut places = out.iter_mut();
        let notice = solver::strips(&view, &creepage, options.model, &mut |strip| {
            if let Some(place) = places.next() {
                place.write(strip.into());
            }
        })?;
        count.write(view.strips().len() as u32);
        Ok(notice)
    })
}

pub(super) fn traction_at<P: Stored, K: Copy, Q: From<FieldPoint<P::Float>>>(
    patch: Option<&P>,
    creepage: Option<&K>,
    options: Option<&kstrip_options>,
    x: P::Float,
    y: P::Float,
    out: Out<Q>,
) -> kstrip_status
where
    Creepage<P::Float>: From<K>,
{
    answer(|| {
        let (patch, creepage) = (given(patch)?, Creepage::from(*given(creepage)?));
        let (options, out) = (checked_options(options)?, given(out)?);
        let view = patch.view()?;
        let field = PatchField::new(&view, &creepage, options.model)?;
        if !x.is_finite_number() || !y.is_finite_number() {
            return Err(Error::NotFinite);
        }
        out.write(field.at(x, y).into());
        Ok(field.notice)
    })
}

pub(super) fn field<P: Stored, K: Copy, Q: From<FieldPoint<P::Float>>>(
    patch: Option<&P>,
    creepage: Option<&K>,
    options: Option<&kstrip_options>,
    x: Result<&[P::Float], Error>,
    y: Result<&[P::Float], Error>,
    out: OutArray<Q>,
) -> kstrip_status
where
    Creepage<P::Float>: From<K>,
{
    answer(|| {
        let (patch, creepage) = (given(patch)?, Creepage::from(*given(creepage)?));
        let options = checked_options(options)?;
        let (x, y, out) = (x?, y?, out?);
        let view = patch.view()?;
        let field = PatchField::new(&view, &creepage, options.model)?;
        let along = |strip: &Option<_>, x| PatchField::along(strip.as_ref(), x);
        write_grid(x, y, out, |y| field.strip_at(y), along)?;
        Ok(field.notice)
    })
}
