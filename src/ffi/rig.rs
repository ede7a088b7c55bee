//! Test rigs: friction from a measured force, creepage for a requested one.

use super::support::*;

/// Both force components were measured.
pub(super) const BOTH: u32 = KSTRIP_MEASURED_FX | KSTRIP_MEASURED_FY;
