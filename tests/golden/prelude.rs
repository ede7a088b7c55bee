//! What most files of this program use.

#[path = "../common/prelude.rs"]
mod shared;

pub(crate) use crate::bits::{Bits, Hash, compare};
pub(crate) use crate::manchester::zeroed;
pub(crate) use shared::*;
