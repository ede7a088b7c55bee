//! Additional corrections for long contacts, `a ≫ b`.
//!
//! In a long contact each strip is deformed by the load of the whole cross-section, with `ln(a/b)`.
//! The corrections of `network` are fitted for axis ratios up to 14. From `√(a/b)` = 2.65 on, the
//! corrections of a second network are added, which was fitted to long contacts alone. Their weight
//! has two continuous derivatives and is one from 3.75 on. No paper has these corrections.

use super::long_constants::{FIXED, INPUT, OFFSET, OUTPUT};
use super::network::{CORRECTIONS, Layers};
use crate::number::tables::{add_rows_to, table, widen};
use crate::number::{Number, Real, Strips, inverses};
use crate::numerics::ramp;

const UNITS: usize = OUTPUT.len();
/// Number of features of `network` that are used here too: the last ones.
const SHARED: usize = 8;
const INPUTS: usize = INPUT.len();
/// `√(a/b)` where the corrections begin, and where their weight is one.
const LONG: [f64; 2] = [2.65, 3.75];
/// Axis ratio where the flexibilities of rigid slip take over at [`super::constants::SATURATION`].
const SATURATES_AT: f64 = 10.0;

/// The second network of one contact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LongContact<F> {
    /// Weight of its corrections, 0 to 1.
    pub share: F,
    /// `0.1 (b/a)²`: squares of creepages that count as small.
    small: F,
    /// Sums of the units over the features of the contact.
    start: [F; UNITS],
}

impl<F: Real> LongContact<F> {
    /// From `√(a/b)`, `2(√g − 1)/(√g + 1)` and `4ν − 1`.
    #[inline(always)]
    pub fn new(root: F, ratio: F, poisson: F) -> Self {
        // w = z³ (10 − 15 z + 6 z²)
        let z = ramp(root, LONG);
        let share = z * z.squared() * (z * (z.times(6.0).plus(-15.0))).plus(10.0);
        if !share.exceeds(F::zero()) {
            return Self { share, small: F::zero(), start: [F::zero(); UNITS] };
        }
        let length = ratio.times(2.0).plus(-2.4);
        let fixed = [length, length.squared(), poisson, poisson * length];
        let [offset, weights @ ..] = table!(F, widen(&FIXED));
        let start = add_rows_to::<F, F::Four, _, _>(offset, fixed.iter().copied(), weights);
        Self { share, small: root.squared().squared().inverse().times(0.1), start }
    }

    /// `(1 + w ((a/10 b)³ − 1))^(−1/2)`: the linear force of a spin grows with the contact's
    /// length, its slip does not, so that less of it counts toward rigid slip.
    #[inline(always)]
    pub fn of_spin(&self, root: F) -> F {
        let length = root.squared().times(1.0 / SATURATES_AT);
        (self.share * (length * length.squared()).plus(-1.0)).plus(1.0).sqrt().inverse()
    }

    /// The terms that are added to the corrections. `shared` are the last features of `network`,
    /// `forces` those of the linear theory, `squares` of `vx, vy` and `p = √(a/b) φ`, `turn` is `vy
    /// p` and `psi` is `|ψ|`, rounded.
    #[inline(always)]
    pub fn long_corrections<T: Number<Base = F>, P: Strips<F>>(
        &self, shared: [T; SHARED], [lx, ly, ls]: [T; 3], [x2, y2, p2]: [T; 3], turn: T, psi: T,
    ) -> [T; CORRECTIONS] {
        // Quotient of the rigid slip of creepage and of spin at the ends of the long axis.
        let [over_x, over_y] = inverses([(x2 + p2).shift(self.small), (y2 + p2).shift(self.small)]);
        // Quotients of the linear forces, their total, and |ψ|.
        let (lx2, ly2, ls2) = (lx * lx, ly * ly, ls * ls);
        let [by_ys, by_xs] = inverses([(ly2 + ls2).plus(0.01), (lx2 + ls2).plus(0.01)]);
        let [by_less, by_more] = inverses([psi.plus(0.3), psi.plus(1.0)]);
        let [by_xy, by_far] = inverses([(lx2 + ly2).plus(0.01), (lx2 + ly2 + ls2).plus(300.0)]);
        let [x, y, spin, couple, few, less, more, all] = shared;
        let inputs: [T; INPUTS] = [
            (x2 - p2) * over_x,
            turn.times(2.0) * over_y,
            (y2 - p2) * over_y,
            (ls * ly) * by_ys,
            (ly2 - ls2) * by_ys,
            (lx2 - ls2) * by_xs,
            (lx2 - ly2) * by_xy,
            by_less.times(-0.6).plus(1.0),
            by_more.times(-2.0).plus(1.0),
            by_far.times(-600.0).plus(1.0),
            x,
            y,
            spin,
            couple,
            few,
            less,
            more,
            all,
        ];
        let [offset] = table!(F, widen(&[OFFSET]));
        let (input, output) = (table!(F, widen(&INPUT)), table!(F, widen(&OUTPUT)));
        let layers = Layers { start: &self.start, input, offset, output };
        let corrections = layers.strip_corrections::<T, P>(inputs);
        T::each(&corrections, |correction| correction.scale(self.share))
    }
}
