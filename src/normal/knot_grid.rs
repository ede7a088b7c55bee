//! Where the knots of a smoothed profile lie.

use crate::normal::profile::Profile;
use crate::number::{Arithmetic, Dual, Float};

/// Where the last piece is shorter than this share of the others, the one before ends the profile.
const STUB: f64 = 1e-3;

/// The places of knots: at equal steps to both sides of a profile's middle, and at its ends.
pub(super) struct Grid<F, const N: usize> {
    ends: [F; 2],
    middle: F,
    step: Dual<F, N>,
    /// Numbers of the knots at the ends.
    pub numbers: [i32; 2],
}

impl<F: Float, const N: usize> Grid<F, N> {
    pub fn new(profile: &Profile<F>, step: Dual<F, N>) -> Self {
        let (ends, middle) = (profile.ends, profile.middle);
        let number = |end: F, outward: f64| {
            let steps = (end - middle) / step.value;
            let inside = steps.plus(-STUB * outward);
            let whole = F::widened(inside.whole() as f32);
            // the whole part is rounded toward zero
            let short = (inside - whole).times(outward) < F::zero();
            inside.whole() + if short { 0 } else { outward as i32 }
        };
        let numbers = [number(ends[0], -1.0), number(ends[1], 1.0)];
        Self { ends, middle, step, numbers }
    }

    pub fn knot_at(&self, knot: i32) -> Dual<F, N> {
        if knot <= self.numbers[0] {
            Dual::from_base(self.ends[0])
        } else if knot >= self.numbers[1] {
            Dual::from_base(self.ends[1])
        } else {
            self.step.scale(F::widened(knot as f32)).shift(self.middle)
        }
    }
}
