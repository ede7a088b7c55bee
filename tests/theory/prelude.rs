//! What most files of this program use.

#[path = "../common/prelude.rs"]
mod shared;

pub(crate) use crate::random::Random;
pub(crate) use crate::theory;
pub(crate) use crate::theory::{MODELS, contact, creepage, options};
pub(crate) use shared::*;
