//! The functions in single precision.

use kstrip::ffi::single::*;

pub type Float = f32;

#[path = "arguments.rs"]
pub mod arguments;
#[path = "arrays.rs"]
pub mod arrays;
#[path = "contacts.rs"]
pub mod contacts;
#[path = "patches.rs"]
pub mod patches;
#[path = "tables.rs"]
pub mod tables;
#[path = "wheels.rs"]
pub mod wheels;
use super::structures::single::*;
