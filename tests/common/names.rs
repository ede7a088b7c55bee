//! The structures and functions of the C interface under their names in C.

pub use crate::places::*;
pub use crate::structures::double::*;
pub use crate::structures::single;
pub use kstrip::ffi::double::*;
pub use kstrip::ffi::single::{
    kstrip_evaluate as kstrip_evaluate_f32, kstrip_evaluate_batch as kstrip_evaluate_batch_f32,
    kstrip_prepare as kstrip_prepare_f32, kstrip_solve as kstrip_solve_f32,
    kstrip_solve_prepared as kstrip_solve_prepared_f32,
};
pub use kstrip::ffi::types::{kstrip_options, kstrip_table};
pub use kstrip::ffi::*;
