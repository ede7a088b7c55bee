//! The functions in double precision.

use kstrip::ffi::batch::*;
use kstrip::ffi::bodies::*;
use kstrip::ffi::inside::*;
use kstrip::ffi::motion::*;
use kstrip::ffi::patch::*;
use kstrip::ffi::rig::*;
use kstrip::ffi::solve::*;
use kstrip::ffi::wheel_rail::*;

pub type Float = f64;

#[path = "arguments.rs"]
pub mod arguments;
#[path = "arrays.rs"]
pub mod arrays;
#[path = "contacts.rs"]
pub mod contacts;
#[path = "patches.rs"]
pub mod patches;
#[path = "wheels.rs"]
pub mod wheels;
use super::structures::double::*;
