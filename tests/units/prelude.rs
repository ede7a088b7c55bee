//! What most files of this program use.

#[path = "../common/prelude.rs"]
mod shared;

pub(crate) use crate::random::Random;
pub(crate) use shared::*;
