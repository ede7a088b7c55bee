//! The functions in double precision.

use kstrip::ffi::double::*;

pub type Float = f64;

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
use super::structures::double::*;
