//! The linear equations of the normal problem: how far the pressures deflect the cells, and the
//! pressures that deflect the touching ones as far as they should.
//!
//! Rows are padded with zeros to fours, which fill a register.

use crate::normal::cell::CELLS;
use crate::number::avx::with_avx;
use crate::number::{Dual, Float, add_at, at, set_at};
use core::ops::Range;
use heapless::Vec;

const _: () = assert!(CELLS.is_multiple_of(4));

/// One number for each cell; zero past the last.
pub(super) type Column<F> = [F; CELLS];

/// The equation of a cell.
struct Row<F, const N: usize> {
    /// `∂u_i/∂p_j`; at last four sums for each direction whose slopes have no room.
    influence: Column<F>,
    /// Their derivatives in the directions that have room.
    slopes: [Column<F>; N],
    /// What is added to the cell's influence on itself in the equations that are solved.
    softer: F,
    /// Of Gauss's elimination: what is left of the row from its diagonal on, and before it the
    /// factors of the rows above.
    factors: Column<F>,
    /// One over the diagonal; zero of a cell that does not touch.
    inverse: F,
}

impl<F: Float, const N: usize> Row<F, N> {
    fn nothing() -> Self {
        let none = [F::zero(); CELLS];
        Self {
            influence: none,
            slopes: [none; N],
            softer: F::zero(),
            factors: none,
            inverse: F::zero(),
        }
    }

    /// Its numbers from one four on, before another.
    fn fours(&self, range: Range<usize>) -> &[[F; 4]] {
        self.factors.as_chunks::<4>().0.get(range).unwrap_or(&[])
    }

    /// Subtracts multiples of four successive rows above, whose diagonals stand in one four. In the
    /// columns of these diagonals zeros would be left; there the factors are written:
    ///
    /// ```text
    /// f_k = a_ik/u_kk,   a_ij ← a_ij − f_k u_kj   (j > k)
    /// ```
    #[inline(always)]
    fn eliminate(&mut self, range: Range<usize>, above: &[Self; 4]) {
        let list = self.factors.as_chunks_mut::<4>().0.get_mut(range.clone());
        let fours = above.each_ref().map(|row| row.fours(range.clone()).split_first());
        let Some((own, beyond)) = list.and_then(|list| list.split_first_mut()) else { return };
        let [Some((a, a_beyond)), Some((b, b_beyond)), Some((c, c_beyond)), Some((_, d_beyond))] =
            fours
        else {
            return;
        };
        let [inverse_a, inverse_b, inverse_c, inverse_d] = above.each_ref().map(|row| row.inverse);
        let ([_, a1, a2, a3], [_, _, b2, b3], [_, _, _, c3]) = (*a, *b, *c);
        let [own_a, own_b, own_c, own_d] = *own;
        let f_a = own_a * inverse_a;
        let f_b = (own_b - f_a * a1) * inverse_b;
        let f_c = (own_c - f_a * a2 - f_b * b2) * inverse_c;
        let f_d = (own_d - f_a * a3 - f_b * b3 - f_c * c3) * inverse_d;
        *own = [f_a, f_b, f_c, f_d];
        let rows = a_beyond.iter().zip(b_beyond).zip(c_beyond.iter().zip(d_beyond));
        for (own, ((a, b), (c, d))) in beyond.iter_mut().zip(rows) {
            let mut left = *own;
            subtract(&mut left, f_a, a);
            subtract(&mut left, f_b, b);
            subtract(&mut left, f_c, c);
            subtract(&mut left, f_d, d);
            *own = left;
        }
    }

    /// The same of one row, whose diagonal is number `k` of its four.
    #[inline]
    fn eliminate_one(&mut self, range: Range<usize>, k: usize, above: &Self) {
        let list = self.factors.as_chunks_mut::<4>().0.get_mut(range.clone());
        let rows = (list.and_then(|list| list.split_first_mut()), above.fours(range).split_first());
        let (Some((own, beyond)), Some((first, rest))) = rows else { return };
        let Some(entry) = own.get_mut(k) else { return };
        let factor = *entry * above.inverse;
        *entry = factor;
        for (own, above) in own.iter_mut().zip(first).skip(k + 1) {
            *own -= factor * *above;
        }
        for (own, above) in beyond.iter_mut().zip(rest) {
            subtract(own, factor, above);
        }
    }
}

/// `own ← own − f above`
#[inline]
fn subtract<F: Float>(own: &mut [F; 4], factor: F, above: &[F; 4]) {
    for (own, above) in own.iter_mut().zip(above) {
        *own -= factor * *above;
    }
}

/// The equations of as many cells as there are, with room for so many.
pub(crate) struct Equations<F, const N: usize> {
    rows: Vec<Row<F, N>, CELLS>,
}

impl<F: Float, const N: usize> Equations<F, N> {
    #[inline]
    pub(super) fn new() -> Self {
        Self { rows: Vec::new() }
    }

    /// Makes room for so many cells, in place.
    pub(super) fn make_room(&mut self, count: usize) {
        while self.rows.len() < count && self.rows.push(Row::nothing()).is_ok() {}
    }

    /// Sets how far the pressure of cell `j` deflects each cell.
    #[inline]
    pub(super) fn set_column(&mut self, j: usize, entries: impl Iterator<Item = Dual<F, N>>) {
        for (row, entry) in self.rows.iter_mut().zip(entries) {
            set_at(&mut row.influence, j, entry.value);
            for (own, slope) in row.slopes.iter_mut().zip(entry.gradient) {
                set_at(own, j, slope);
            }
        }
    }

    /// Adds `κ (p_i − p_k)` to the deflection of cell `i`; past the last cell the pressure is zero.
    pub(super) fn add_coupling(&mut self, i: usize, k: usize, kappa: Dual<F, N>) {
        let Some(row) = self.rows.get_mut(i) else { return };
        for (k, sign) in [(i, F::one()), (k, -F::one())] {
            add_at(&mut row.influence, k, sign * kappa.value);
            for (slopes, change) in row.slopes.iter_mut().zip(kappa.gradient) {
                add_at(slopes, k, sign * change);
            }
        }
    }

    /// Sets what is added to the influence of cell `i` on itself, at first nothing.
    pub(super) fn soften(&mut self, i: usize, by: F) {
        if let Some(row) = self.rows.get_mut(i) {
            row.softer = by;
        }
    }

    /// Solves the equations of touching cells for two right-hand sides, in place; others are zero.
    pub(super) fn solve(&mut self, touching: &[usize], sides: &mut [Column<F>; 2]) {
        with_avx!(if 1 => <F: Float; N>(
            equations: &mut Equations<F, N> = self,
            touching: &[usize],
            sides: &mut [Column<F>; 2]
        ) -> () {
            equations.factorise(touching);
            for side in sides {
                equations.substitute(touching, side);
            }
        });
    }

    /// Solves the equations of the touching cells once more, for what the derivatives of the
    /// influence in a direction deflect: `side − dA p`, in place.
    pub(super) fn solve_for_slopes(
        &self, direction: usize, touching: &[usize], pressures: &Column<F>, side: &mut Column<F>,
    ) {
        with_avx!(if 1 => <F: Float; N>(
            equations: &Equations<F, N> = self,
            direction: usize,
            touching: &[usize],
            pressures: &Column<F>,
            side: &mut Column<F>
        ) -> () {
            let fours = 0..equations.fours();
            for (own, row) in side.iter_mut().zip(&equations.rows) {
                if let Some(slopes) = row.slopes.get(direction) {
                    *own -= product(slopes, pressures, fours.clone());
                } else if let Some(sums) = row.influence.as_chunks::<4>().0.get(direction) {
                    *own -= total(sums);
                }
            }
            equations.substitute(touching, side);
        });
    }

    /// Makes the influence zero, in whose place sums stand after that.
    pub(super) fn clear_influence(&mut self) {
        for row in &mut self.rows {
            row.influence = [F::zero(); CELLS];
        }
    }

    /// Adds what the derivatives of the influence of cell `j` on cell `i` deflect.
    #[inline]
    pub(super) fn add_slopes(&mut self, i: usize, j: usize, slopes: &[F], pressure: F) {
        let Some(row) = self.rows.get_mut(i) else { return };
        for (sums, slope) in row.influence.as_chunks_mut::<4>().0.iter_mut().zip(slopes) {
            add_at(sums, j % 4, *slope * pressure);
        }
    }

    /// How far the pressures deflect a cell.
    pub(super) fn deflection(&self, i: usize, pressures: &Column<F>) -> F {
        let row = self.rows.get(i);
        row.map_or(F::zero(), |row| product(&row.influence, pressures, 0..self.fours()))
    }

    fn fours(&self) -> usize {
        self.rows.len().div_ceil(4)
    }

    /// Gauss's elimination without pivots of the rows and columns of touching cells: the diagonal
    /// is the largest of its row. From each row those above are subtracted, four at once.
    #[inline(always)]
    fn factorise(&mut self, touching: &[usize]) {
        let fours = self.fours();
        for row in &mut self.rows {
            row.inverse = F::zero();
        }
        for &i in touching {
            let Some((above, [row, ..])) = self.rows.split_at_mut_checked(i) else { return };
            let Row { influence, softer, factors, .. } = row;
            let influence = influence.as_chunks::<4>().0.iter().take(fours);
            for (own, influence) in factors.as_chunks_mut::<4>().0.iter_mut().zip(influence) {
                *own = *influence;
            }
            add_at(factors, i, *softer);
            let (blocks, rest) = above.as_chunks::<4>();
            for (block, above) in blocks.iter().enumerate() {
                row.eliminate(block..fours, above);
            }
            for (k, above) in rest.iter().enumerate() {
                row.eliminate_one(blocks.len()..fours, k, above);
            }
            row.inverse = F::one() / at(&row.factors, i);
        }
    }

    /// Solves for a right-hand side, in place; zero for cells that do not touch.
    #[inline(always)]
    fn substitute(&self, touching: &[usize], side: &mut Column<F>) {
        let fours = self.fours();
        let mut half = [F::zero(); CELLS];
        for &k in touching {
            let (Some(row), Some(own)) = (self.rows.get(k), side.get(k)) else { return };
            let own = *own - product(&row.factors, &half, 0..k / 4 + 1);
            set_at(&mut half, k, own);
        }
        *side = [F::zero(); CELLS];
        for &k in touching.iter().rev() {
            let (Some(row), Some(own)) = (self.rows.get(k), half.get(k)) else { return };
            let own = *own - product(&row.factors, side, k / 4..fours);
            if let (Some(place), Some(diagonal)) = (side.get_mut(k), row.factors.get(k)) {
                *place = own / *diagonal;
            }
        }
    }
}

/// `Σ x_i y_i` over some of the fours, in four sums.
#[inline]
fn product<F: Float>(x: &[F], y: &[F], fours: Range<usize>) -> F {
    let [x, y] = [x, y].map(|list| list.as_chunks::<4>().0.get(fours.clone()).unwrap_or(&[]));
    let mut sums = [F::zero(); 4];
    for (x, y) in x.iter().zip(y) {
        for ((sum, x), y) in sums.iter_mut().zip(x).zip(y) {
            *sum += *x * *y;
        }
    }
    total(&sums)
}

#[inline]
fn total<F: Float>([a, b, c, d]: &[F; 4]) -> F {
    (*a + *c) + (*b + *d)
}
