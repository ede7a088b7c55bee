//! Derivatives for C: with respect to load and friction as well, and of many contacts.

use super::calls::{Out, OutArray, given, inputs};
use super::types::{kstrip_contact, kstrip_creepage, kstrip_options, kstrip_result};
use super::types_f32::{kstrip_contact_f32, kstrip_creepage_f32, kstrip_result_f32};
use super::{answer, arrays, checked_options, kstrip_status};
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::solve::derivatives::{self, Derivatives};
use crate::solve::model::{self, Precision, Solution};
use crate::status::{Error, Notice};
use core::mem::MaybeUninit;
use nalgebra::Vector3;

/// Derivatives of fx, fy, mz with respect to creepages, load and friction.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_derivatives {
    /// d(fx, fy, mz)/d(longitudinal, lateral, spin), row by row [N, N, N m over 1, 1, 1/m].
    pub jacobian: [f64; 9],
    /// d(fx, fy, mz)/d(normal_force) at fixed a and b [-, -, m].
    pub normal_force: [f64; 3],
    /// d(fx, fy, mz)/d(friction) [N, N, N m].
    pub friction: [f64; 3],
    /// d(fx, fy, mz)/d(normal_force) while a and b follow the load as Hertz says: both grow like its
    /// cube root in a contact of given curvatures [-, -, m].
    pub load_through_hertz: [f64; 3],
}

/// Derivatives of fx, fy, mz with respect to creepages, load and friction, single precision.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct kstrip_derivatives_f32 {
    /// d(fx, fy, mz)/d(longitudinal, lateral, spin), row by row [N, N, N m over 1, 1, 1/m].
    pub jacobian: [f32; 9],
    /// d(fx, fy, mz)/d(normal_force) at fixed a and b [-, -, m].
    pub normal_force: [f32; 3],
    /// d(fx, fy, mz)/d(friction) [N, N, N m].
    pub friction: [f32; 3],
    /// d(fx, fy, mz)/d(normal_force) while a and b follow the load as Hertz says: both grow like its
    /// cube root in a contact of given curvatures [-, -, m].
    pub load_through_hertz: [f32; 3],
}

macro_rules! conversion {
    ($float:ident, $c:ty) => {
        impl From<Derivatives<$float>> for $c {
            fn from(core: Derivatives<$float>) -> Self {
                let three = |vector: Vector3<$float>| [vector.x, vector.y, vector.z];
                let Derivatives { jacobian: j, normal_force, friction, load_through_hertz } = core;
                Self {
                    jacobian: [j.m11, j.m12, j.m13, j.m21, j.m22, j.m23, j.m31, j.m32, j.m33],
                    normal_force: three(normal_force),
                    friction: three(friction),
                    load_through_hertz: three(load_through_hertz),
                }
            }
        }
    };
}

conversion!(f64, kstrip_derivatives);
conversion!(f32, kstrip_derivatives_f32);

fn solve_derivatives<F, C: Copy, K: Copy, R: From<Solution<F>>, D: From<Derivatives<F>>>(
    contact: Option<&C>,
    creepage: Option<&K>,
    options: Option<&kstrip_options>,
    out: Out<R>,
    derivatives: Out<D>,
) -> kstrip_status
where
    F: Precision,
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
{
    answer(|| {
        let (contact, creepage) = inputs(contact, creepage)?;
        let options = checked_options(options)?;
        let (out, derivatives) = (given(out)?, given(derivatives)?);
        let (solution, found) = derivatives::solve(&contact, &creepage, &options)?;
        let notice = solution.notice;
        out.write(solution.into());
        derivatives.write(found.into());
        Ok(notice)
    })
}

fn solve_jacobian_batch<F: Precision, C: Copy, K: Copy, R: From<Solution<F>>>(
    contacts: Result<&[C], Error>,
    creepages: Result<&[K], Error>,
    options: Option<&kstrip_options>,
    results: OutArray<R>,
    jacobians: OutArray<[F; 9]>,
) -> kstrip_status
where
    Contact<F>: From<C>,
    Creepage<F>: From<K>,
{
    answer(|| {
        let (contacts, creepages) = (contacts?, creepages?);
        let (results, jacobians) = (results?, jacobians?);
        let options = checked_options(options)?;
        for (contact, creepage) in contacts.iter().zip(creepages) {
            derivatives::check_jacobian(&(*contact).into(), &(*creepage).into(), &options)?;
        }
        let mut worst = Notice::None;
        let outputs = results.iter_mut().zip(jacobians);
        for ((contact, creepage), (out, entries)) in contacts.iter().zip(creepages).zip(outputs) {
            let (solution, j) =
                model::solve_jacobian(&(*contact).into(), &(*creepage).into(), &options)?;
            if solution.notice.code() > worst.code() {
                worst = solution.notice;
            }
            out.write(solution.into());
            entries.write([j.m11, j.m12, j.m13, j.m21, j.m22, j.m23, j.m31, j.m32, j.m33]);
        }
        Ok(worst)
    })
}

/// Forces and their exact derivatives with respect to creepages, normal force and friction.
///
/// The first nine derivatives are those of kstrip_solve_jacobian(). Without load or friction those with
/// respect to them are one-sided, those of full sliding. KSTRIP_MODEL_LINEAR has no friction in it: its
/// derivatives with respect to friction and to the load at fixed a, b are zero, and
/// load_through_hertz is zero without load, where it has no bound.
///
/// @param contact              ellipse, load, material, friction.
/// @param creepage             motion.
/// @param options              model and strip count; NULL for the defaults.
/// @param[out] result          receives what kstrip_solve() gives.
/// @param[out] derivatives     receives the derivatives; at kinks of a model, one-sided values.
/// @return as kstrip_solve(); KSTRIP_ERROR_OVERFLOW also when a derivative is too large.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_derivatives(
    contact: Option<&kstrip_contact>,
    creepage: Option<&kstrip_creepage>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result>>,
    derivatives: Option<&mut MaybeUninit<kstrip_derivatives>>,
) -> kstrip_status {
    solve_derivatives(contact, creepage, options, result, derivatives)
}

/// Forces and derivatives of many contacts: the same as calling kstrip_solve_jacobian() for each, bit
/// for bit.
///
/// All inputs are checked before anything is written: if one is bad its status is returned and no
/// output is touched.
///
/// @param contacts, creepages  arrays of count elements.
/// @param count           number of contacts; 0 is allowed.
/// @param options         for all contacts; NULL for the defaults.
/// @param[out] results    array of count elements; status_detail tells each one's warning.
/// @param[out] jacobians  array of 9 count numbers: nine per contact, as kstrip_solve_jacobian().
/// @return KSTRIP_OK, the largest warning, or the first error, as kstrip_solve_jacobian().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_solve_jacobian_batch(
    contacts: *const kstrip_contact,
    creepages: *const kstrip_creepage,
    count: u32,
    options: Option<&kstrip_options>,
    results: *mut kstrip_result,
    jacobians: *mut f64,
) -> kstrip_status {
    // SAFETY: NULL or count elements each, nine times as many numbers, says the header.
    let (contacts, creepages, results, jacobians) = unsafe {
        (
            arrays::input(contacts, count),
            arrays::input(creepages, count),
            arrays::output(results, count),
            arrays::output(jacobians.cast::<[f64; 9]>(), count),
        )
    };
    solve_jacobian_batch(contacts, creepages, options, results, jacobians)
}

/// kstrip_solve_derivatives() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub extern "C" fn kstrip_solve_derivatives_f32(
    contact: Option<&kstrip_contact_f32>,
    creepage: Option<&kstrip_creepage_f32>,
    options: Option<&kstrip_options>,
    result: Option<&mut MaybeUninit<kstrip_result_f32>>,
    derivatives: Option<&mut MaybeUninit<kstrip_derivatives_f32>>,
) -> kstrip_status {
    solve_derivatives(contact, creepage, options, result, derivatives)
}

/// kstrip_solve_jacobian_batch() in single precision: same arguments, units, ranges and statuses.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kstrip_solve_jacobian_batch_f32(
    contacts: *const kstrip_contact_f32,
    creepages: *const kstrip_creepage_f32,
    count: u32,
    options: Option<&kstrip_options>,
    results: *mut kstrip_result_f32,
    jacobians: *mut f32,
) -> kstrip_status {
    // SAFETY: NULL or count elements each, nine times as many numbers, says the header.
    let (contacts, creepages, results, jacobians) = unsafe {
        (
            arrays::input(contacts, count),
            arrays::input(creepages, count),
            arrays::output(results, count),
            arrays::output(jacobians.cast::<[f32; 9]>(), count),
        )
    };
    solve_jacobian_batch(contacts, creepages, options, results, jacobians)
}
