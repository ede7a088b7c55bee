//! What the exported functions of both precisions do, once, generic over the precision.

use super::{answer, checked_options, kstrip_status, types::kstrip_options};
use crate::batch::{self, Problems, Solutions};
use crate::contact::Contact;
use crate::contact::creepage::{Creepage, Parameters, SurfaceVelocity};
use crate::contact::forces::StripCount;
use crate::contact::hertz::{self, HertzContact, Radii};
use crate::contact::material::{self, CombinedMaterial, Material};
use crate::number::Float;
use crate::solve::field::FieldPoint;
use crate::solve::model::{
    self, Field, Jacobian, Model, Options, Precision, Solution, StripResult,
};
use crate::status::{Error, Notice};
use core::mem::MaybeUninit;

pub(super) type Out<'a, T> = Option<&'a mut MaybeUninit<T>>;
pub(super) type OutArray<'a, T> = Result<&'a mut [MaybeUninit<T>], Error>;

/// A required argument.
pub(super) fn given<T>(argument: Option<T>) -> Result<T, Error> {
    argument.ok_or(Error::NullPointer)
}

pub(super) fn material_from_youngs_modulus<F: Float, M: From<Material<F>>>(
    youngs_modulus: F,
    poisson_ratio: F,
    out: Out<M>,
) -> kstrip_status {
    answer(|| {
        let out = given(out)?;
        material::check_modulus(youngs_modulus)?;
        material::check_poisson_ratio(poisson_ratio)?;
        let material = Material::from_youngs_modulus(youngs_modulus, poisson_ratio);
        // A modulus may be so small that nothing is left of its third.
        material::check_modulus(material.shear_modulus)?;
        out.write(material.into());
        Ok(Notice::None)
    })
}

pub(super) fn material_combine<F: Float, M: Copy, C: From<CombinedMaterial<F>>>(
    lower: Option<&M>,
    upper: Option<&M>,
    out: Out<C>,
) -> kstrip_status
where
    Material<F>: From<M>,
{
    answer(|| {
        let (lower, upper, out) = (given(lower)?, given(upper)?, given(out)?);
        out.write(material::combine(&(*lower).into(), &(*upper).into())?.into());
        Ok(Notice::None)
    })
}

pub(super) fn hertz<F: Float, R: Copy, C: Copy, H: From<HertzContact<F>>>(
    radii: Option<&R>,
    normal_force: F,
    material: Option<&C>,
    out: Out<H>,
) -> kstrip_status
where
    Radii<F>: From<R>,
    CombinedMaterial<F>: From<C>,
{
    answer(|| {
        let (radii, out) = (given(radii)?, given(out)?);
        let material = CombinedMaterial::from(*given(material)?);
        let ellipse = hertz::hertz(
            &(*radii).into(),
            normal_force,
            material.shear_modulus,
            material.poisson_ratio,
        )?;
        out.write(ellipse.into());
        Ok(Notice::None)
    })
}

pub(super) fn creepage_from_velocities<F: Float, V: Copy, C: From<Creepage<F>>>(
    lower: Option<&V>,
    upper: Option<&V>,
    rolling_speed: F,
    out: Out<C>,
) -> kstrip_status
where
    SurfaceVelocity<F>: From<V>,
{
    answer(|| {
        let (lower, upper, out) = (given(lower)?, given(upper)?, given(out)?);
        let creepage =
            Creepage::from_velocities(&(*lower).into(), &(*upper).into(), rolling_speed)?;
        out.write(creepage.into());
        Ok(Notice::None)
    })
}

pub(super) fn parameters_from_creepage<F: Float, C: Copy, K: Copy, P: From<[F; 3]>>(
    contact: Option<&C>,
    creepage: Option<&K>,
    out: Out<P>,
) -> kstrip_status
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
{
    answer(|| {
        let (contact, creepage, out) = (given(contact)?, given(creepage)?, given(out)?);
        let (contact, creepage) = (Contact::from(*contact), Creepage::from(*creepage));
        contact.check()?;
        creepage.check()?;
        let Parameters { xi, eta, psi, .. } = Parameters::new(&contact, &creepage);
        if ![xi, eta, psi].iter().all(|parameter| parameter.is_finite_number()) {
            return Err(Error::Overflow);
        }
        out.write([xi, eta, psi].into());
        Ok(Notice::None)
    })
}

pub(super) fn creepage_from_parameters<F: Float, C: Copy, P: Copy, K: From<Creepage<F>>>(
    contact: Option<&C>,
    parameters: Option<&P>,
    out: Out<K>,
) -> kstrip_status
where
    Contact<F>: From<C>,
    [F; 3]: From<P>,
{
    answer(|| {
        let (contact, parameters, out) = (given(contact)?, given(parameters)?, given(out)?);
        let contact = Contact::from(*contact);
        contact.check()?;
        let [xi, eta, psi] = <[F; 3]>::from(*parameters);
        if ![xi, eta, psi].iter().all(|parameter| parameter.is_finite_number()) {
            return Err(Error::NotFinite);
        }
        let parameters = Parameters {
            xi,
            eta,
            psi,
            poisson_ratio: contact.poisson_ratio,
            axis_ratio: contact.a / contact.b,
        };
        let creepage = parameters.creepage(&contact);
        creepage.check().map_err(|_| Error::Overflow)?;
        out.write(creepage.into());
        Ok(Notice::None)
    })
}

/// The inputs that every solver shares.
pub(super) fn inputs<F: Float, C: Copy, K: Copy>(
    contact: Option<&C>,
    creepage: Option<&K>,
) -> Result<(Contact<F>, Creepage<F>), Error>
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
{
    Ok(((*given(contact)?).into(), (*given(creepage)?).into()))
}

#[inline]
pub(super) fn solve<F: Precision, C: Copy, K: Copy, R: From<Solution<F>>>(
    contact: Option<&C>,
    creepage: Option<&K>,
    options: Option<&kstrip_options>,
    out: Out<R>,
) -> kstrip_status
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
{
    answer(|| {
        let (contact, creepage) = inputs(contact, creepage)?;
        let (options, out) = (checked_options(options)?, given(out)?);
        // (on a microcontroller one piece of code serves every function that solves)
        let solution = if cfg!(target_os = "none") {
            model::solve(&contact, &creepage, &options)?
        } else {
            model::solve_inline(&contact, &creepage, &options)?
        };
        let notice = solution.notice;
        out.write(solution.into());
        Ok(notice)
    })
}

/// One model: `solver` is a function of [`model`] that needs no options.
#[inline(always)]
pub(super) fn solve_by<F: Precision, C: Copy, K: Copy, R: From<Solution<F>>>(
    contact: Option<&C>,
    creepage: Option<&K>,
    out: Out<R>,
    solver: impl FnOnce(&Contact<F>, &Creepage<F>) -> Result<Solution<F>, Error>,
) -> kstrip_status
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
{
    answer(|| {
        let (contact, creepage) = inputs(contact, creepage)?;
        let out = given(out)?;
        let solution = solver(&contact, &creepage)?;
        let notice = solution.notice;
        out.write(solution.into());
        Ok(notice)
    })
}

/// The same for a model with strips.
#[inline(always)]
pub(super) fn solve_by_strips<F: Precision, C: Copy, K: Copy, R: From<Solution<F>>>(
    contact: Option<&C>,
    creepage: Option<&K>,
    strips: i32,
    out: Out<R>,
    solver: impl FnOnce(&Contact<F>, &Creepage<F>, StripCount) -> Result<Solution<F>, Error>,
) -> kstrip_status
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
{
    solve_by(contact, creepage, out, |contact, creepage| {
        let count = StripCount::from_number(strips).ok_or(Error::StripCount)?;
        solver(contact, creepage, count)
    })
}

pub(super) fn solve_jacobian<F: Precision, C: Copy, K: Copy, R: From<Solution<F>>>(
    contact: Option<&C>,
    creepage: Option<&K>,
    options: Option<&kstrip_options>,
    out: Out<R>,
    entries: OutArray<F>,
) -> kstrip_status
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
{
    answer(|| {
        let (contact, creepage) = inputs(contact, creepage)?;
        let (options, out, entries) = (checked_options(options)?, given(out)?, entries?);
        let (solution, jacobian) = model::solve_jacobian(&contact, &creepage, &options)?;
        let notice = solution.notice;
        out.write(solution.into());
        write_rows(&jacobian, entries);
        Ok(notice)
    })
}

/// The nine numbers of a Jacobian: nalgebra stores columns; C wants rows.
pub(super) fn write_rows<F: Float>(jacobian: &Jacobian<F>, entries: &mut [MaybeUninit<F>]) {
    for (entry, value) in entries.iter_mut().zip(jacobian.transpose().iter()) {
        entry.write(*value);
    }
}

pub(super) fn solve_batch<F: Precision, C: Copy, K: Copy, R: From<Solution<F>>>(
    contacts: Result<&[C], Error>,
    creepages: Result<&[K], Error>,
    options: Option<&kstrip_options>,
    results: OutArray<R>,
) -> kstrip_status
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
{
    answer(|| {
        let (contacts, creepages, results) = (contacts?, creepages?, results?);
        let options = checked_options(options)?;
        batch::solve_batch(&Structures { contacts, creepages }, &options, &mut Results(results))
    })
}

/// Problems as C structures.
struct Structures<'a, C, K> {
    contacts: &'a [C],
    creepages: &'a [K],
}

impl<F: Float, C: Copy, K: Copy> Problems<F> for Structures<'_, C, K>
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
{
    #[inline(always)]
    fn count(&self) -> usize {
        self.contacts.len()
    }
    #[inline(always)]
    fn get(&self, i: usize) -> Option<(Contact<F>, Creepage<F>)> {
        Some(((*self.contacts.get(i)?).into(), (*self.creepages.get(i)?).into()))
    }
}

/// Solutions as C structures.
struct Results<'a, R>(&'a mut [MaybeUninit<R>]);

impl<F: Float, R: From<Solution<F>>> Solutions<F> for Results<'_, R> {
    #[inline(always)]
    fn put(&mut self, i: usize, solution: Solution<F>) {
        if let Some(place) = self.0.get_mut(i) {
            place.write(solution.into());
        }
    }
}

pub(super) fn strips<F: Precision, C: Copy, K: Copy, S: From<StripResult<F>>>(
    contact: Option<&C>,
    creepage: Option<&K>,
    options: Option<&kstrip_options>,
    out: OutArray<S>,
    count: Out<u32>,
) -> kstrip_status
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
{
    answer(|| {
        let (contact, creepage) = inputs(contact, creepage)?;
        let (options, out, count) = (checked_options(options)?, out?, given(count)?);
        check_room(&contact, &creepage, &options, out.len())?;
        let (notice, written) = write_strips(&contact, &creepage, &options, out)?;
        count.write(written);
        Ok(notice)
    })
}

const _: () = assert!(super::KSTRIP_STRIPS_CAPACITY as usize == model::MOST_STRIPS_1967);

/// Whether all strips fit; counts them where that is not clear beforehand, so that an array that is too small stays
/// untouched.
pub(super) fn check_room<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
    room: usize,
) -> Result<(), Error> {
    let mut needed = model::most_strips(contact, creepage, options)?;
    if needed > room && options.model != Model::Strip {
        needed = 0;
        model::strips(contact, creepage, options, &mut |_| needed += 1)?;
    }
    if needed <= room { Ok(()) } else { Err(Error::Capacity) }
}

/// Writes the strips, as many as there is room for; and how many these are.
pub(super) fn write_strips<F: Precision, S: From<StripResult<F>>>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
    out: &mut [MaybeUninit<S>],
) -> Result<(Notice, u32), Error> {
    let mut places = out.iter_mut();
    let mut written = 0_u32;
    let notice = model::strips(contact, creepage, options, &mut |strip| {
        if let Some(place) = places.next() {
            place.write(strip.into());
            written += 1;
        }
    })?;
    Ok((notice, written))
}

pub(super) fn traction_at<F: Precision, C: Copy, K: Copy, P: From<FieldPoint<F>>>(
    contact: Option<&C>,
    creepage: Option<&K>,
    options: Option<&kstrip_options>,
    x: F,
    y: F,
    out: Out<P>,
) -> kstrip_status
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
{
    answer(|| {
        let (contact, creepage) = inputs(contact, creepage)?;
        let (options, out) = (checked_options(options)?, given(out)?);
        let field = Field::new(&contact, &creepage, &options)?;
        if !x.is_finite_number() || !y.is_finite_number() {
            return Err(Error::NotFinite);
        }
        out.write(field.at(x, y).into());
        Ok(field.notice)
    })
}

pub(super) fn field<F: Precision, C: Copy, K: Copy, P: From<FieldPoint<F>>>(
    contact: Option<&C>,
    creepage: Option<&K>,
    options: Option<&kstrip_options>,
    x: Result<&[F], Error>,
    y: Result<&[F], Error>,
    out: OutArray<P>,
) -> kstrip_status
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
{
    answer(|| {
        let (contact, creepage) = inputs(contact, creepage)?;
        let options = checked_options(options)?;
        let (x, y, out) = (x?, y?, out?);
        let field = Field::new(&contact, &creepage, &options)?;
        write_grid(x, y, out, |y| field.strip_at(y), |strip, x| field.along(strip.as_ref(), x))?;
        Ok(field.notice)
    })
}

/// The points of a grid, strip by strip.
pub(super) fn write_grid<F: Float, S, P: From<FieldPoint<F>>>(
    x: &[F],
    y: &[F],
    out: &mut [MaybeUninit<P>],
    strip_at: impl Fn(F) -> S,
    along: impl Fn(&S, F) -> FieldPoint<F>,
) -> Result<(), Error> {
    if !x.iter().chain(y).all(|coordinate| coordinate.is_finite_number()) {
        return Err(Error::NotFinite);
    }
    if x.len().checked_mul(y.len()).is_none_or(|points| points > out.len()) {
        return Err(Error::Capacity);
    }
    let mut places = out.iter_mut();
    for &y in y {
        let strip = strip_at(y);
        for (&x, place) in x.iter().zip(&mut places) {
            place.write(along(&strip, x).into());
        }
    }
    Ok(())
}

pub(super) fn result_on_upper_body<R: Copy + UpperBody>(
    lower: Option<&R>,
    out: Out<R>,
) -> kstrip_status {
    answer(|| {
        let (lower, out) = (given(lower)?, given(out)?);
        out.write(lower.on_upper_body());
        Ok(Notice::None)
    })
}

/// A C result that can change sides.
pub(super) trait UpperBody {
    fn on_upper_body(&self) -> Self;
}
