//! Test rigs: friction from a measured force, creepage for a requested one.

use super::constants::{
    KSTRIP_FIT_DECAY, KSTRIP_FIT_FRICTION, KSTRIP_FIT_LAYER, KSTRIP_FIT_RATIO,
    KSTRIP_FIT_SLIDE_FACTOR, KSTRIP_FIT_SLOPE_FACTOR,
};
use super::support::*;

/// Both force components were measured.
pub(super) const BOTH: u32 = KSTRIP_MEASURED_FX | KSTRIP_MEASURED_FY;

/// Which parameters are fitted.
pub(super) fn fitted(parameters: u32) -> Result<Fitted, Error> {
    Error::FitParameters.unless(parameters < 2 * KSTRIP_FIT_LAYER)?;
    let parts = [
        KSTRIP_FIT_FRICTION,
        KSTRIP_FIT_RATIO,
        KSTRIP_FIT_DECAY,
        KSTRIP_FIT_SLOPE_FACTOR,
        KSTRIP_FIT_SLIDE_FACTOR,
        KSTRIP_FIT_LAYER,
    ];
    Ok(parts.map(|part| parameters & part != 0))
}
