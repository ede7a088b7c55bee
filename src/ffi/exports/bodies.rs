//! Bodies: materials, Hertz's ellipse and its inverse, Kalker's coefficients.

use super::F;
use crate::contact::hertz::{HertzContact, Radii};
use crate::contact::material::{self, CombinedMaterial, Material};
use crate::contact::{Contact, from_approach, from_hertz};
use crate::ffi::support::{given, place, put, write_result, write_warned};
use crate::linear::LinearCoefficients;
use crate::status::{Error, kstrip_status};
use core::mem::MaybeUninit;

/// Combine the elastic constants of two bodies. From Young's modulus: shear_modulus = E/(2 (1 +
/// poisson_ratio)).
///
/// @param lower, upper    the two bodies.
/// @param[out] combined   receives the constants that kstrip_contact_from_hertz() and
///                        kstrip_contact take.
/// @return usual statuses; statuses of kstrip_material.
#[unsafe(export_name = symbol!("kstrip_material_combine"))]
pub extern "C" fn kstrip_material_combine(
    lower: Option<&Material<F>>, upper: Option<&Material<F>>,
    combined: Option<&mut MaybeUninit<CombinedMaterial<F>>>,
) -> kstrip_status {
    write_result(combined, || material::combine(given(lower)?, given(upper)?))
}

/// The contact of two bodies that a load presses together (Hertz).
///
/// @param radii           curvatures of both bodies.
/// @param pair            combined constants.
/// @param load            N [N]; not positive: the contact is lost, a = b = normal_force = 0.
/// @param friction        coefficient of friction [-], >= 0.
/// @param[out] contact    receives the contact.
/// @param[out] ellipse    receives pressure, approach and shape; NULL: not needed.
/// @return usual statuses; statuses of kstrip_radii; KSTRIP_ERROR_MODULUS and
///         KSTRIP_ERROR_POISSON_RATIO (pair is outside the ranges of kstrip_material);
///         KSTRIP_ERROR_FRICTION (friction < 0); warnings of kstrip_contact (about the contact that
///         is found); KSTRIP_WARNING_CONFORMAL (a semi-axis is above 0.3 of the smaller radius in
///         its direction).
#[unsafe(export_name = symbol!("kstrip_contact_from_hertz"))]
pub extern "C" fn kstrip_contact_from_hertz(
    radii: Option<&Radii<F>>, pair: Option<&CombinedMaterial<F>>, load: F, friction: F,
    contact: Option<&mut MaybeUninit<Contact<F>>>,
    ellipse: Option<&mut MaybeUninit<HertzContact<F>>>,
) -> kstrip_status {
    write_warned(contact, || {
        let (found, hertz, warning) = from_hertz(given(radii)?, given(pair)?, load, friction)?;
        put(ellipse, hertz);
        Ok((found, warning))
    })
}

/// The contact of two bodies that have approached each other: the exact inverse of Hertz, for
/// penalty contact.
///
/// @param radii           curvatures of both bodies.
/// @param pair            combined constants.
/// @param approach        of distant points of the bodies [m]; not positive: the contact is lost.
/// @param friction        coefficient of friction [-], >= 0.
/// @param[out] contact    receives the contact, with its load.
/// @param[out] dload_dapproach  receives the contact stiffness dN/d(approach) [N/m]; NULL: not
///                              needed.
/// @return as kstrip_contact_from_hertz().
#[unsafe(export_name = symbol!("kstrip_contact_from_approach"))]
pub extern "C" fn kstrip_contact_from_approach(
    radii: Option<&Radii<F>>, pair: Option<&CombinedMaterial<F>>, approach: F, friction: F,
    contact: Option<&mut MaybeUninit<Contact<F>>>, dload_dapproach: Option<&mut MaybeUninit<F>>,
) -> kstrip_status {
    write_warned(contact, || {
        let (found, slope, warning) =
            from_approach(given(radii)?, given(pair)?, approach, friction)?;
        put(dload_dapproach, slope);
        Ok((found, warning))
    })
}

/// Kalker's coefficients C11, C22, C23, C33 of the linear theory.
///
/// For vanishing creepage fx = G a b C11 longitudinal, fy = G a b (C22 lateral + sqrt(ab) C23
/// spin), mz = G (ab)^(3/2) (sqrt(ab) C33 spin - C23 lateral). Beyond axis ratios of 0.1 to 10 they
/// follow the asymptotes of slender ellipses.
///
/// @param axis_ratio      a/b [-], > 0; a along the rolling direction.
/// @param poisson_ratio   combined Poisson's ratio [-], 0 to 0.5.
/// @param[out] coefficients  receives four numbers: C11, C22, C23, C33.
/// @return KSTRIP_OK; KSTRIP_ERROR_NULL (coefficients), KSTRIP_ERROR_NOT_FINITE (an argument is
///         infinite or NaN), KSTRIP_ERROR_SEMI_AXIS (axis_ratio <= 0), KSTRIP_ERROR_POISSON_RATIO
///         (outside 0 to 0.5).
#[unsafe(export_name = symbol!("kstrip_linear_coefficients"))]
pub unsafe extern "C" fn kstrip_linear_coefficients(
    axis_ratio: F, poisson_ratio: F, coefficients: *mut F,
) -> kstrip_status {
    // SAFETY: NULL or four writable numbers, says the header.
    let coefficients = unsafe { place(coefficients.cast::<[F; 4]>()) };
    write_result(coefficients, || {
        Error::NotFinite.unless(axis_ratio.is_finite())?;
        Error::SemiAxis.unless(axis_ratio > 0.0)?;
        material::check_poisson_ratio(poisson_ratio)?;
        let found = LinearCoefficients::at(axis_ratio, poisson_ratio);
        Ok([found.c11, found.c22, found.c23, found.c33])
    })
}
