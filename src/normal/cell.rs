//! The cells of the normal problem: first their places, then what the solution makes of them.

use crate::number::{Arithmetic, Dual, Float};
use core::f64::consts::FRAC_PI_2;
use heapless::Vec;

/// Largest number of cells of the normal problem. On a microcontroller there are fewer, so that
/// a patch has 16 strips at most.
pub const CELLS: usize = if cfg!(target_os = "none") { 20 } else { 48 };

/// `c` over the width.
const COMPLIANCE: f64 = 6.0;

/// A cell of the normal problem, or a part of one, on the line `x = 0`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cell<F, const N: usize> {
    /// Middle line \[m\].
    pub y: Dual<F, N>,
    /// Width \[m\].
    pub width: Dual<F, N>,
    /// Where the conditions of contact hold \[m\]: at the middle; of two parts of one cell with
    /// hardly a gap between them, at the middle of both.
    pub(super) at: Dual<F, N>,
    /// Width over which the distance there is taken \[m\]: of such parts, that of both.
    pub(super) over: Dual<F, N>,
    /// Coupling `κ` of the pressure to that of the cell before and of the cell after \[m\].
    pub(super) coupling: [Dual<F, N>; 2],
    /// Coupling `κ` to a pressure of zero \[m\].
    pub(super) alone: Dual<F, N>,
    /// Share of a whole cell.
    pub(super) share: Dual<F, N>,
    /// Number of the cell that it is a part of.
    pub(super) number: i32,
    /// Number of its zone.
    pub(super) zone: u32,
    /// Undeformed distance on the middle line \[m\].
    pub distance: Dual<F, N>,
    /// Rolling radius `R` \[m\].
    pub rolling_radius: Dual<F, N>,
    /// Centre along `x` \[m\].
    pub centre_x: Dual<F, N>,
    /// Half length \[m\].
    pub half_length: Dual<F, N>,
    /// `p/(π E*)`; zero where the bodies do not touch.
    pub pressure: Dual<F, N>,
    /// Share of the cell in which the bodies touch, `S'`, from 0 to 1.
    pub touches: F,
}

impl<F: Float, const N: usize> Cell<F, N> {
    /// A cell of which no more than its place is known.
    #[inline]
    pub(super) fn at_place([y, width, share]: [Dual<F, N>; 3], number: i32, zone: u32) -> Self {
        let zero = Dual::zero();
        Self {
            y,
            width,
            at: y,
            over: width,
            coupling: [zero; 2],
            alone: zero,
            share,
            number,
            zone,
            distance: zero,
            rolling_radius: zero,
            centre_x: zero,
            half_length: zero,
            pressure: zero,
            touches: F::zero(),
        }
    }

    /// `c`: about the deflection of the cell per `p/(π E*)` of its own \[m\].
    pub(super) fn compliance(&self) -> Dual<F, N> {
        self.over.times(COMPLIANCE)
    }

    /// `1/S' − 1` of a cell that touches, in part or whole.
    pub(super) fn softness(&self) -> F {
        if self.touches > F::zero() { F::one() / self.touches - F::one() } else { F::zero() }
    }

    /// `(π/2) a w p/(π E*)`
    pub fn load(&self) -> Dual<F, N> {
        (self.half_length * self.width * self.pressure).times(FRAC_PI_2)
    }
}

/// Cells in ascending `y`.
pub(crate) struct Cells<F, const N: usize> {
    pub list: Vec<Cell<F, N>, CELLS>,
}

impl<F: Float, const N: usize> Cells<F, N> {
    pub(crate) fn nothing() -> Self {
        Self { list: Vec::new() }
    }

    /// `N/(π E*)`
    pub(crate) fn load(&self) -> Dual<F, N> {
        self.list.iter().fold(Dual::zero(), |sum, cell| sum + cell.load())
    }

    /// Mean pressure over mean half length, and mean width \[m\], weighted with the load.
    pub(crate) fn means(&self, of: impl Fn(Dual<F, N>) -> F) -> [F; 2] {
        let (mut sum, mut weight) = (F::zero(), F::TINY);
        let (mut widths, mut loads) = (F::zero(), F::TINY);
        for cell in self.list.iter() {
            let (a, p, width) = (of(cell.half_length), of(cell.pressure), of(cell.width));
            let load = p * width;
            sum += load * a * p;
            weight += load * a * a;
            widths += load * a * width;
            loads += load * a;
        }
        [sum / weight, widths / loads]
    }
}
