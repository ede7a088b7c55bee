//! The network of corrections: two hidden layers of units `2x/(1 + x²)`, and their derivatives with
//! respect to its inputs.

use super::constants::{FIRST, FIXED, LAST, LAST_BIAS, SECOND};
use crate::number::tables::{add_rows, add_rows_to, row, table, widen};
use crate::number::{Number, Real, Strips};

/// What the network is told that depends on the contact only, and the rest.
const FIXED_INPUTS: usize = FIXED.len() - 1;
const INPUTS: usize = FIRST.len();
/// Units of the two hidden layers.
const UNITS_1: usize = SECOND.len() - 1;
const UNITS_2: usize = LAST[0].len();

/// Six corrections for one contact: sums of the first layer over what depends on the contact only.
#[derive(Clone, Copy, Debug)]
pub(super) struct TotalNetwork<F> {
    sums: [F; UNITS_1],
}

impl<F: Real> TotalNetwork<F> {
    #[inline(always)]
    pub(super) fn for_fixed_inputs(fixed: [F; FIXED_INPUTS]) -> Self {
        let [offset, weights @ ..] = table!(F, widen(&FIXED));
        Self { sums: add_rows_to::<F, F::Four, _, _>(offset, fixed.iter().copied(), weights) }
    }

    /// The corrections for the other inputs, sums side by side in `P`. (Out of line where code must
    /// be small; wide registers need it within its caller.)
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline(never))]
    pub(super) fn total_corrections<T: Number<Base = F>, P: Strips<F>>(
        &self, inputs: [T; INPUTS],
    ) -> [T; 6] {
        let first = table!(F, widen(&FIRST));
        let [second_offset, second @ ..] = table!(F, widen(&SECOND));
        let [last_offset] = table!(F, widen(&[LAST_BIAS]));
        let sums = add_rows::<F, P, _, _>(&self.sums, inputs.iter().map(|x| x.value()), first);
        let (units, slopes_1) = activation(sums);
        let (units, slopes_2) =
            activation(add_rows_to::<F, P, _, _>(second_offset, units.iter().copied(), second));
        let mut outputs = last_layer(&units, row(last_offset)).map(T::from_base);
        // how they move with the inputs, one derivative after the other
        for direction in 0..T::DIRECTIONS {
            let moves = F::each(&inputs, |x| x.derivative(direction));
            let moved = moved::<F, P>(&moves, &slopes_1, &slopes_2);
            for (output, moves) in outputs.iter_mut().zip(moved) {
                output.set_derivative(direction, moves);
            }
        }
        outputs
    }
}

/// How the corrections move when the inputs do. (Out of line for the same reason.)
#[cfg_attr(target_arch = "x86_64", inline(always))]
#[cfg_attr(not(target_arch = "x86_64"), inline(never))]
fn moved<F: Real, P: Strips<F>>(
    moves: &[F; INPUTS], slopes_1: &[F; UNITS_1], slopes_2: &[F; UNITS_2],
) -> [F; 6] {
    let first = table!(F, widen(&FIRST));
    let [_, second @ ..] = table!(F, widen(&SECOND));
    let units = times(
        add_rows::<F, P, _, _>(&[F::zero(); UNITS_1], moves.iter().copied(), first),
        slopes_1,
    );
    let units = add_rows::<F, P, _, _>(&[F::zero(); UNITS_2], units.iter().copied(), second);
    last_layer(&times(units, slopes_2), [F::zero(); 6])
}

/// The last layer: four chains of sums for each output.
#[inline(always)]
fn last_layer<F: Real>(units: &[F; UNITS_2], mut outputs: [F; 6]) -> [F; 6] {
    for (output, weights) in outputs.iter_mut().zip(table!(F, widen(&LAST))) {
        let mut sums = [*output, F::zero(), F::zero(), F::zero()];
        for (units, weights) in units.chunks(4).zip(weights.chunks(4)) {
            for ((sum, unit), weight) in sums.iter_mut().zip(units).zip(weights) {
                *sum += *unit * F::stored(*weight);
            }
        }
        let [a, b, c, d] = sums;
        *output = (a + c) + (b + d);
    }
    outputs
}

#[inline(always)]
fn times<F: Real, const N: usize>(mut x: [F; N], y: &[F; N]) -> [F; N] {
    for (x, y) in x.iter_mut().zip(y) {
        *x = *x * *y;
    }
    x
}

/// `2x/(1 + x²)` and its slope `2/(1 + x²) − (2x/(1 + x²))²`, with one division for two.
#[inline(always)]
fn activation<F: Real, const N: usize>(x: [F; N]) -> ([F; N], [F; N]) {
    // y = r x and its slope r − y², r = 2/(1 + x²)
    let from = |r: F, unit: &mut F, slope: &mut F| {
        *unit = *unit * r;
        *slope = r - unit.squared();
    };
    let (mut units, mut slopes) = (x, x);
    let ((fours, rest), (of_fours, of_rest)) =
        (units.as_chunks_mut::<4>(), slopes.as_chunks_mut::<4>());
    for ([x0, x1, y0, y1], [s0, s1, t0, t1]) in fours.iter_mut().zip(of_fours) {
        let [p0, p1, q0, q1] = F::each(&[*x0, *x1, *y0, *y1], |x| x.squared().plus(1.0));
        let (r0, r1) = (F::of(2.0) / (p0 * q0), F::of(2.0) / (p1 * q1));
        from(r0 * q0, x0, s0);
        from(r1 * q1, x1, s1);
        from(r0 * p0, y0, t0);
        from(r1 * p1, y1, t1);
    }
    for (unit, slope) in rest.iter_mut().zip(of_rest) {
        from(F::of(2.0) / unit.squared().plus(1.0), unit, slope);
    }
    (units, slopes)
}
