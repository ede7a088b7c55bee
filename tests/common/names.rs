//! The structures and functions of the C interface under their names in C.
#![allow(dead_code, unused_imports)]

#[path = "places.rs"]
mod places;
#[path = "structures.rs"]
mod structures;

pub use kstrip::ffi::batch::*;
pub use kstrip::ffi::bodies::*;
pub use kstrip::ffi::inside::*;
pub use kstrip::ffi::motion::*;
pub use kstrip::ffi::patch::*;
pub use kstrip::ffi::rig::*;
pub use kstrip::ffi::single::*;
pub use kstrip::ffi::solve::*;
pub use kstrip::ffi::types::kstrip_options;
pub use kstrip::ffi::wheel_rail::*;
pub use kstrip::ffi::*;
pub use places::*;
pub use structures::double::*;
pub use structures::single;
