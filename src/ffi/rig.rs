//! Test rigs: friction from a measured force, creepage from a wanted one.

use super::support::*;

/// Both components.
pub(super) const BOTH: u32 = KSTRIP_MEASURED_FX | KSTRIP_MEASURED_FY;
