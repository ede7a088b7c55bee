//! The functions in double precision.

use kstrip::ffi::batch::*;
use kstrip::ffi::derivatives::*;
use kstrip::ffi::double::*;
use kstrip::ffi::evaluate::*;
use kstrip::ffi::friction::*;
use kstrip::ffi::patch::*;
use kstrip::ffi::patch_friction::*;
use kstrip::ffi::patch_types::*;
use kstrip::ffi::per_model::*;
use kstrip::ffi::rig::*;
use kstrip::ffi::types::*;

pub type Float = f64;

#[path = "arguments.rs"]
pub mod arguments;
#[path = "arrays.rs"]
pub mod arrays;
#[path = "contacts.rs"]
pub mod contacts;
#[path = "patches.rs"]
pub mod patches;
