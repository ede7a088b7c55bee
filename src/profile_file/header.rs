//! The contents of a file's header, and the limits of its points.

use crate::number::Float;

/// Metres per mm.
pub(super) const MILLIMETRE: f64 = 1e-3;
pub(super) const FEWEST_POINTS: usize = 4;
/// Largest coordinate \[units of the file\].
pub(super) const LARGEST: f64 = 1e12;

/// The kind of a profile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Wheel,
    Rail,
}

/// The contents of a file's header.
pub(super) struct Header<F> {
    pub(super) kind: Option<Kind>,
    pub(super) units_per_metre: F,
    pub(super) units_per_radian: F,
    /// Metres per unit that a table names.
    pub(super) unit: Option<f64>,
    /// In units of the file.
    pub(super) shift: [F; 2],
    pub(super) turn: F,
    pub(super) mirror: [bool; 2],
    /// Least and largest y, and z, of points that count.
    pub(super) bounds: [[F; 2]; 2],
    pub(super) is_from_flange_back: bool,
    pub(super) is_left_out: bool,
    pub(super) has_ignored: bool,
    pub(super) has_several: bool,
    pub(super) has_other_count: bool,
}

impl<F: Float> Header<F> {
    pub(super) fn new() -> Self {
        let infinite = F::LARGEST.times(2.0);
        Self {
            kind: None,
            units_per_metre: F::one(),
            units_per_radian: F::one(),
            unit: None,
            shift: [F::zero(); 2],
            turn: F::zero(),
            mirror: [false; 2],
            bounds: [[-infinite, infinite]; 2],
            is_from_flange_back: true,
            is_left_out: false,
            has_ignored: false,
            has_several: false,
            has_other_count: false,
        }
    }
}
