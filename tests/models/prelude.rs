//! What most files of this program use.

#[path = "../common/prelude.rs"]
mod shared;

pub(crate) use crate::differences::{Comparison, trusted_differences};
pub(crate) use crate::manchester::{self, points, prepared, steel, zeroed};
pub(crate) use crate::patch_reference::{profiles, statistics};
pub(crate) use crate::patches::{Full, irregular};
pub(crate) use crate::random::Random;
pub(crate) use crate::single::single_motion;
pub(crate) use crate::theory;
pub(crate) use crate::theory::{MODELS, contact, creepage, options};
pub(crate) use crate::wheel_rail::{ROLLING, Stand, difference, profile};
pub(crate) use shared::*;
