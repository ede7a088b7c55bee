//! Tables of constants in both precisions: no number is converted at run time, and a program in one
//! precision has none of the other.

use super::traits::{Real, Strips};

/// `table!(F, constants)`: a constant table `[[f64; C]; R]` or `[[f32; C]; R]`, in the precision
/// that numbers `F` are stored in.
macro_rules! table {
    ($F:ty, $constants:expr) => {
        <<$F as crate::number::Real>::Stored as crate::number::Float>::table(
            const { &crate::number::tables::to_single(&$constants) },
            const { &$constants },
        )
    };
}
pub(crate) use table;

/// In single precision.
pub(crate) const fn to_single<const R: usize, const C: usize>(
    table: &[[f64; C]; R],
) -> [[f32; C]; R] {
    let mut narrow = [[0.0; C]; R];
    let mut i = 0;
    while i < R * C {
        narrow[i / C][i % C] = table[i / C][i % C] as f32;
        i += 1;
    }
    narrow
}

/// In double precision, exactly.
pub(crate) const fn widen<const R: usize, const C: usize>(table: &[[f32; C]; R]) -> [[f64; C]; R] {
    let mut wide = [[0.0; C]; R];
    let mut i = 0;
    while i < R * C {
        wide[i / C][i % C] = table[i / C][i % C] as f64;
        i += 1;
    }
    wide
}

/// A row of numbers.
pub(crate) fn row<F: Real, const C: usize>(stored: &[F::Stored; C]) -> [F; C] {
    F::each(stored, |x| F::stored(*x))
}

/// Registers of sums at a time: they do not wait for each other.
const BLOCK: usize = 6;
/// The same of contacts side by side: a register is left for the input and one for the weight.
const CONTACTS_BLOCK: usize = 12;

/// `start + Σ xᵢ rowᵢ`, columns side by side in `P`, then in fours, and the rest one by one.
///
/// Numbers of several contacts side by side fill whole registers: some of them, then the rows
/// again.
#[inline(always)]
pub(crate) fn add_rows<F: Real, P: Strips<F>, const C: usize, const R: usize>(
    start: &[F; C], inputs: impl Iterator<Item = F> + Clone, rows: &[[F::Stored; C]; R],
) -> [F; C] {
    let mut sums = *start;
    if const { F::LANES > 1 || P::COUNT == 1 } {
        add_in_blocks(&mut sums, inputs, rows);
        return sums;
    }
    const { assert!(P::COUNT == 1 || C <= BLOCK * P::COUNT) };
    let next = add_columns::<F, P, C>(&mut sums, inputs.clone(), rows, 0);
    if const { P::COUNT > 4 } {
        add_columns::<F, F::WideFour, C>(&mut sums, inputs, rows, next);
    }
    sums
}

/// [`add_rows`] to a row of a table.
#[inline(always)]
pub(crate) fn add_rows_to<F: Real, P: Strips<F>, const C: usize, const R: usize>(
    start: &[F::Stored; C], inputs: impl Iterator<Item = F> + Clone, rows: &[[F::Stored; C]; R],
) -> [F; C] {
    add_rows::<F, P, C, R>(&row(start), inputs, rows)
}

/// Columns from `first` on, as many as fill several `P`; the rest too where these are fours. The
/// first one that is left.
#[inline(always)]
fn add_columns<F: Real, P: Strips<F>, const C: usize>(
    sums: &mut [F; C], inputs: impl Iterator<Item = F>, rows: &[[F::Stored; C]], first: usize,
) -> usize {
    let columns = sums.get_mut(first..).unwrap_or_default();
    let next = first + columns.len() / P::COUNT * P::COUNT;
    let (mut found, mut rest) = ([P::zero(); BLOCK], [F::zero(); 3]);
    for (found, columns) in found.iter_mut().zip(columns.chunks_exact(P::COUNT)) {
        *found = P::gather(|i| columns.get(i).copied().unwrap_or(F::zero()));
    }
    let (in_groups, others) = columns.split_at_mut(next - first);
    let others = if P::COUNT == 4 { others } else { &mut [] };
    for (rest, sum) in rest.iter_mut().zip(&mut *others) {
        *rest = *sum;
    }
    for (x, row) in inputs.zip(rows) {
        let all = P::all(x);
        let mut weights = row.get(first..).unwrap_or_default().chunks_exact(P::COUNT);
        for (found, weights) in found.iter_mut().zip(&mut weights) {
            *found += all * P::of_list(weights);
        }
        if P::COUNT == 4 {
            for (rest, weight) in rest.iter_mut().zip(weights.remainder()) {
                *rest += x * F::stored(*weight);
            }
        }
    }
    for (columns, found) in in_groups.chunks_exact_mut(P::COUNT).zip(found) {
        for (i, sum) in columns.iter_mut().enumerate() {
            *sum = found.lane(i);
        }
    }
    for (sum, rest) in others.iter_mut().zip(rest) {
        *sum = rest;
    }
    next
}

/// [`add_rows`] in place, of numbers that stand side by side.
#[inline(always)]
fn add_in_blocks<F: Real, const C: usize>(
    sums: &mut [F; C], inputs: impl Iterator<Item = F> + Clone, rows: &[[F::Stored; C]],
) {
    let (blocks, rest) = sums.as_chunks_mut::<CONTACTS_BLOCK>();
    for (k, block) in blocks.iter_mut().enumerate() {
        for (x, row) in inputs.clone().zip(rows) {
            let weights = row.as_chunks::<CONTACTS_BLOCK>().0.get(k).into_iter().flatten();
            for (sum, weight) in block.iter_mut().zip(weights) {
                *sum += x * F::stored(*weight);
            }
        }
    }
    for (x, row) in inputs.zip(rows) {
        for (sum, weight) in rest.iter_mut().zip(row.as_chunks::<CONTACTS_BLOCK>().1) {
            *sum += x * F::stored(*weight);
        }
    }
}
