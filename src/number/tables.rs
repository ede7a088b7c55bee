//! Tables of constants in both precisions: no number is converted at run time, and a program in one precision has none of the other.

use super::Plain;

/// `table!(F, constants)`: a constant table `[[f64; C]; R]` or `[[f32; C]; R]`, in the precision that numbers `F` are stored in.
macro_rules! table {
    ($F:ty, $constants:expr) => {
        <<$F as crate::number::Plain>::Stored as crate::number::Float>::table(
            const { &crate::number::tables::narrow(&$constants) },
            const { &$constants },
        )
    };
}
pub(crate) use table;

/// In single precision.
pub(crate) const fn narrow<const R: usize, const C: usize>(table: &[[f64; C]; R]) -> [[f32; C]; R] {
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

/// Rows of couples as rows of numbers, `C = 2 P` in each, in double precision.
pub(crate) const fn rows<const R: usize, const P: usize, const C: usize>(
    table: &[[[f32; 2]; P]; R],
) -> [[f64; C]; R] {
    let mut rows = [[0.0; C]; R];
    let mut i = 0;
    while i < R * C {
        rows[i / C][i % C] = table[i / C][i % C / 2][i % 2] as f64;
        i += 1;
    }
    rows
}

/// A row of numbers.
#[inline(always)]
pub(crate) fn row<F: Plain, const C: usize>(stored: &[F::Stored; C]) -> [F; C] {
    F::each(stored, |x| F::stored(*x))
}

/// `sums + Σ xᵢ rowᵢ`: a few sums at a time, which stay in registers and do not wait for each other, then the rows again.
///
/// (Numbers of several contacts side by side fill whole registers.)
#[inline(always)]
pub(crate) fn add_rows<F: Plain, const C: usize>(
    sums: [F; C],
    inputs: &[F],
    rows: &[[F::Stored; C]],
) -> [F; C] {
    if F::LANES == 1 {
        add_in_blocks::<F, C, 8>(sums, inputs, rows)
    } else {
        add_in_blocks::<F, C, 6>(sums, inputs, rows)
    }
}

#[inline(always)]
fn add_in_blocks<F: Plain, const C: usize, const BLOCK: usize>(
    mut sums: [F; C],
    inputs: &[F],
    rows: &[[F::Stored; C]],
) -> [F; C] {
    let (blocks, rest) = sums.as_chunks_mut::<BLOCK>();
    for (k, block) in blocks.iter_mut().enumerate() {
        for (x, row) in inputs.iter().zip(rows) {
            let weights = row.as_chunks::<BLOCK>().0.get(k).into_iter().flatten();
            for (sum, weight) in block.iter_mut().zip(weights) {
                *sum += *x * F::stored(*weight);
            }
        }
    }
    for (x, row) in inputs.iter().zip(rows) {
        for (sum, weight) in rest.iter_mut().zip(row.as_chunks::<BLOCK>().1) {
            *sum += *x * F::stored(*weight);
        }
    }
    sums
}
