//! What most files of this program use.

pub(crate) use crate::differences::Comparison;
pub(crate) use crate::patches::{Full, irregular, side_by_side, strips_of_patch};
pub(crate) use crate::wheel_rail::{ROLLING, Stand, difference, profile};
pub(crate) use kstrip_testing::patch_reference::{profiles, statistics};
pub(crate) use kstrip_testing::prelude::*;
