//! The fitted corrections: thirteen features, one layer of units `h/√(1 + h²)`, eight corrections.

use super::constants::{FIXED, INPUT, OFFSET, OUTPUT};
use crate::number::tables::{add_rows, add_rows_to, row, table, widen};
use crate::number::{Number, Real, Strips, add};

pub(super) const CORRECTIONS: usize = OFFSET.len();
const UNITS: usize = OUTPUT.len();
/// Features that depend on the motion; two others depend on the contact alone.
pub(super) const INPUTS: usize = INPUT.len();

#[derive(Clone, Copy, Debug)]
pub(super) struct StripNetwork<F> {
    /// Sums of the units over the features of the contact.
    start: [F; UNITS],
}

impl<F: Real> StripNetwork<F> {
    /// From `2(√g − 1)/(√g + 1)` and `4ν − 1`.
    #[inline(always)]
    pub fn new(ratio: F, poisson: F) -> Self {
        let [offset, weights @ ..] = table!(F, widen(&FIXED));
        let fixed = [ratio, poisson];
        Self { start: add_rows_to::<F, F::Four, _, _>(offset, fixed.iter().copied(), weights) }
    }

    /// The network with its weights.
    #[inline(always)]
    pub fn layers(&self) -> Layers<'_, F, INPUTS, UNITS> {
        let [offset] = table!(F, widen(&[OFFSET]));
        let (input, output) = (table!(F, widen(&INPUT)), table!(F, widen(&OUTPUT)));
        Layers { start: &self.start, input, offset, output }
    }
}

/// One layer of units, and corrections.
pub(super) struct Layers<'a, F: Real, const INPUTS: usize, const UNITS: usize> {
    /// Sums of the units over the features of the contact.
    pub start: &'a [F; UNITS],
    /// Weights of the other inputs, offsets of the corrections, and weights of the units.
    pub input: &'static [[F::Stored; UNITS]; INPUTS],
    pub offset: &'static [F::Stored; CORRECTIONS],
    pub output: &'static [[F::Stored; CORRECTIONS]; UNITS],
}

impl<F: Real, const INPUTS: usize, const UNITS: usize> Layers<'_, F, INPUTS, UNITS> {
    /// The corrections, with the sums side by side in `P`. Out of line where code must be small; in
    /// wide registers it is inlined, because only the caller's code is compiled for them.
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline(never))]
    pub fn strip_corrections<T: Number<Base = F>, P: Strips<F>>(
        &self, inputs: [T; INPUTS],
    ) -> [T; CORRECTIONS] {
        let values = inputs.iter().map(|x| x.value());
        let mut units = add_rows::<F, P, _, _>(self.start, values, self.input);
        let mut slopes = F::inverse_roots(F::each(&units, |h| h.squared().plus(1.0)));
        // x = h/√(1 + h²) and dx/dh = (1 + h²)^{−3/2}
        for (h, root) in units.iter_mut().zip(&mut slopes) {
            *h = *h * *root;
            *root = *root * root.squared();
        }
        let mut outputs = last(&units, row(self.offset), self.output).map(T::from_base);
        // Derivatives of the corrections, one input after the other.
        for direction in 0..T::DIRECTIONS {
            let moved = self.moved::<P>(&slopes, &F::each(&inputs, |x| x.derivative(direction)));
            for (output, moves) in outputs.iter_mut().zip(moved) {
                output.set_derivative(direction, moves);
            }
        }
        outputs
    }

    /// Derivative of the corrections along a change of the inputs. Out of line for the same reason.
    #[cfg_attr(target_arch = "x86_64", inline(always))]
    #[cfg_attr(not(target_arch = "x86_64"), inline(never))]
    fn moved<P: Strips<F>>(&self, slopes: &[F; UNITS], moves: &[F; INPUTS]) -> [F; CORRECTIONS] {
        let mut units =
            add_rows::<F, P, _, _>(&[F::zero(); UNITS], moves.iter().copied(), self.input);
        for (h, slope) in units.iter_mut().zip(slopes) {
            *h = *h * *slope;
        }
        last(&units, [F::zero(); CORRECTIONS], self.output)
    }
}

/// The last layer, in two chains of additions, one for each half of the units.
#[inline(always)]
fn last<F: Real, const UNITS: usize>(
    units: &[F; UNITS], start: [F; CORRECTIONS], weights: &[[F::Stored; CORRECTIONS]; UNITS],
) -> [F; CORRECTIONS] {
    let (mut sums, mut others) = (start, [F::zero(); CORRECTIONS]);
    let units = units.iter().zip(units.iter().skip(UNITS / 2));
    let weights = weights.iter().zip(weights.iter().skip(UNITS / 2));
    for ((a, b), (of_a, of_b)) in units.zip(weights) {
        for ((sum, other), (p, q)) in sums.iter_mut().zip(&mut others).zip(of_a.iter().zip(of_b)) {
            *sum += *a * F::stored(*p);
            *other += *b * F::stored(*q);
        }
    }
    add(&mut sums, others);
    sums
}
