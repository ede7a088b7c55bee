//! Between C structures and the values of the core.

use super::{types, types_f32};
use crate::contact::Contact;
use crate::contact::creepage::{Creepage, SurfaceVelocity};
use crate::contact::hertz::{HertzContact, Radii};
use crate::contact::material::{CombinedMaterial, Material};
use crate::ffi::calls::UpperBody;
use crate::ffi::{KSTRIP_STATE_SLIP, KSTRIP_STATE_STICK};
use crate::solve::field::FieldPoint;
use crate::solve::model::{Solution, StripResult};

/// `From` in both directions (`<->`) or out of the core (`<-`) between structures with the same fields.
macro_rules! mirror {
    ($float:ident: $c:ty, <->, $core:ident { $($field:ident),* }) => {
        impl From<$c> for $core<$float> {
            #[inline(always)]
            fn from(c: $c) -> Self {
                Self { $($field: c.$field),* }
            }
        }
        mirror!($float: $c, <-, $core { $($field),* });
    };
    ($float:ident: $c:ty, <-, $core:ident { $($field:ident),* }) => {
        impl From<$core<$float>> for $c {
            #[inline(always)]
            fn from(core: $core<$float>) -> Self {
                Self { $($field: core.$field),* }
            }
        }
    };
}

macro_rules! conversions {
    (
        $float:ident, $material:ty, $combined:ty, $radii:ty, $hertz:ty, $contact:ty, $creepage:ty,
        $parameters:ty, $velocity:ty, $result:ty, $strip:ty, $point:ty
    ) => {
        mirror!($float: $material, <->, Material { shear_modulus, poisson_ratio });
        mirror!($float: $combined, <->, CombinedMaterial { shear_modulus, poisson_ratio, mismatch });
        mirror!($float: $radii, <->, Radii { lower_x, lower_y, upper_x, upper_y });
        mirror!($float: $hertz, <-, HertzContact {
            a, b, peak_pressure, approach, axis_ratio, hertz_angle, rho
        });
        mirror!($float: $contact, <->, Contact {
            a, b, normal_force, shear_modulus, poisson_ratio, friction
        });
        mirror!($float: $creepage, <->, Creepage { longitudinal, lateral, spin });
        mirror!($float: $velocity, <->, SurfaceVelocity { x, y, angular_z });

        impl From<[$float; 3]> for $parameters {
            fn from([xi, eta, psi]: [$float; 3]) -> Self {
                Self { xi, eta, psi }
            }
        }

        impl From<$parameters> for [$float; 3] {
            fn from(parameters: $parameters) -> Self {
                [parameters.xi, parameters.eta, parameters.psi]
            }
        }

        impl From<Solution<$float>> for $result {
            #[inline(always)]
            fn from(solution: Solution<$float>) -> Self {
                let Solution { fx, fy, mz, power, adhesion, notice } = solution;
                Self { fx, fy, mz, power, adhesion, status_detail: notice.code(), reserved: 0 }
            }
        }

        impl UpperBody for $result {
            fn on_upper_body(&self) -> Self {
                Self { fx: -self.fx, fy: -self.fy, mz: -self.mz, ..*self }
            }
        }

        impl From<StripResult<$float>> for $strip {
            fn from(strip: StripResult<$float>) -> Self {
                let StripResult { y, width, half_length, separatrix, fx, fy, mz, power, adheres } =
                    strip;
                let state = if adheres { KSTRIP_STATE_STICK } else { KSTRIP_STATE_SLIP };
                Self { y, width, half_length, separatrix, fx, fy, mz, power, state, reserved: 0 }
            }
        }

        impl From<FieldPoint<$float>> for $point {
            fn from(point: FieldPoint<$float>) -> Self {
                let FieldPoint {
                    pressure, traction_x, traction_y, slip_x, slip_y, dissipation, state,
                } = point;
                Self {
                    pressure, traction_x, traction_y, slip_x, slip_y, dissipation,
                    state: state as i32,
                    reserved: 0,
                }
            }
        }
    };
}

conversions!(
    f64,
    types::kstrip_material,
    types::kstrip_combined_material,
    types::kstrip_radii,
    types::kstrip_hertz_contact,
    types::kstrip_contact,
    types::kstrip_creepage,
    types::kstrip_parameters,
    types::kstrip_velocity,
    types::kstrip_result,
    types::kstrip_strip,
    types::kstrip_point
);
conversions!(
    f32,
    types_f32::kstrip_material_f32,
    types_f32::kstrip_combined_material_f32,
    types_f32::kstrip_radii_f32,
    types_f32::kstrip_hertz_contact_f32,
    types_f32::kstrip_contact_f32,
    types_f32::kstrip_creepage_f32,
    types_f32::kstrip_parameters_f32,
    types_f32::kstrip_velocity_f32,
    types_f32::kstrip_result_f32,
    types_f32::kstrip_strip_f32,
    types_f32::kstrip_point_f32
);
