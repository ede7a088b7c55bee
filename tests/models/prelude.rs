//! What most files of this program use.

pub(crate) use crate::differences::{Comparison, trusted_differences};
pub(crate) use crate::patches::{Full, irregular};
pub(crate) use crate::wheel_rail::{ROLLING, Stand, difference, profile};
pub(crate) use kstrip_testing::patch_reference::{profiles, statistics};
pub(crate) use kstrip_testing::prelude::*;
