//! The fitted corrections: thirteen features, one layer of units `h/√(1 + h²)`, eight corrections.

use super::constants::{HIDDEN, HIDDEN_OFFSET, OUTPUT, OUTPUT_OFFSET};
use crate::linear::widen;
use crate::number::{Arithmetic, Float, Map, Number, Plain, Quad, Stored};

pub(super) const CORRECTIONS: usize = OUTPUT_OFFSET.len();
const UNITS: usize = HIDDEN_OFFSET.len();
const FEATURES: usize = HIDDEN.len();
/// Features that the contact alone decides: the axis ratio and Poisson's ratio.
const FIXED: [usize; 2] = [3, 4];
/// The others.
pub(super) const INPUTS: usize = FEATURES - FIXED.len();

type Row<F, const P: usize> = [[F; 2]; P];

/// Rows of a table with their numbers in couples.
#[allow(clippy::indexing_slicing)]
const fn couples<const N: usize, const M: usize, const P: usize>(
    table: &[[f32; M]; N],
) -> [Row<f32, P>; N] {
    let mut rows = [[[0.0; 2]; P]; N];
    let mut i = 0;
    while i < N {
        let mut j = 0;
        while j < M {
            rows[i][j / 2][j % 2] = table[i][j];
            j += 1;
        }
        i += 1;
    }
    rows
}

/// The tables in both precisions.
#[repr(align(16))]
struct Aligned<T>(T);

macro_rules! table {
    ($single:ident, $double:ident: [$rows:expr; $count:expr] of $columns:expr) => {
        static $single: Aligned<[Row<f32, { $columns / 2 }>; $count]> = Aligned($rows);
        static $double: Aligned<[Row<f64, { $columns / 2 }>; $count]> = Aligned(widen(&$single.0));
    };
}

const OFFSETS: [[f32; UNITS]; 3] = [HIDDEN_OFFSET, HIDDEN[FIXED[0]], HIDDEN[FIXED[1]]];
const LAST_OFFSET: [[f32; CORRECTIONS]; 1] = [OUTPUT_OFFSET];
const MOVING: [[f32; UNITS]; INPUTS] = {
    let mut rows = [[0.0; UNITS]; INPUTS];
    let (mut i, mut k) = (0, 0);
    while i < FEATURES {
        if i != FIXED[0] && i != FIXED[1] {
            rows[k] = HIDDEN[i];
            k += 1;
        }
        i += 1;
    }
    rows
};
table!(FIRST_OFFSET, FIRST_OFFSET_WIDE: [couples(&OFFSETS); 3] of UNITS);
table!(FIRST, FIRST_WIDE: [couples(&MOVING); INPUTS] of UNITS);
table!(LAST_START, LAST_START_WIDE: [couples(&LAST_OFFSET); 1] of CORRECTIONS);
table!(LAST, LAST_WIDE: [couples(&OUTPUT); UNITS] of CORRECTIONS);

type Units<F> = [<F as Number>::Quad; UNITS / 4];
type Outputs<F> = [<F as Number>::Quad; CORRECTIONS / 4];

/// The network of one contact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Network<F: Plain> {
    /// Sums of the units over the features that the contact decides.
    start: Units<F>,
}

impl<F: Plain> Network<F> {
    #[inline(always)]
    pub fn new(root: F, poisson_ratio: F) -> Self {
        let [offset, by_root, by_poisson] = F::Stored::table(&FIRST_OFFSET.0, &FIRST_OFFSET_WIDE.0);
        let mut start = quads::<F, { UNITS / 2 }, { UNITS / 4 }>(offset);
        let ratio = ((root.plus(-1.0)) / root.plus(1.0)).times(2.0);
        add_row::<F>(&mut start, ratio, by_root);
        add_row::<F>(&mut start, poisson_ratio.times(4.0).plus(-1.0), by_poisson);
        Self { start }
    }
}

impl<F: Plain> Map<F, INPUTS, CORRECTIONS> for Network<F> {
    /// `dx/dh` of the units `x = h/√(1 + h²)`
    type Place = Units<F>;

    #[inline(always)]
    fn value(&self, inputs: [F; INPUTS]) -> ([F; CORRECTIONS], Units<F>) {
        let mut units = self.start;
        for (input, row) in inputs.iter().zip(F::Stored::table(&FIRST.0, &FIRST_WIDE.0)) {
            add_row::<F>(&mut units, *input, row);
        }
        let mut roots = units;
        for h in &mut roots {
            *h = h.squared().plus(1.0);
        }
        let mut slopes = F::Quad::inverse_roots(roots);
        for (h, root) in units.iter_mut().zip(&mut slopes) {
            *h = *h * *root;
            // (1 + h²)^{−3/2}
            *root = *root * root.squared();
        }
        let [start] = F::Stored::table(&LAST_START.0, &LAST_START_WIDE.0);
        (last::<F>(&units, quads::<F, { CORRECTIONS / 2 }, { CORRECTIONS / 4 }>(start)), slopes)
    }

    #[inline(always)]
    fn tangent(&self, slopes: &Units<F>, inputs: [F; INPUTS]) -> [F; CORRECTIONS] {
        let mut units = [F::Quad::zero(); UNITS / 4];
        for (input, row) in inputs.iter().zip(F::Stored::table(&FIRST.0, &FIRST_WIDE.0)) {
            add_row::<F>(&mut units, *input, row);
        }
        for (h, slope) in units.iter_mut().zip(slopes) {
            *h = *h * *slope;
        }
        last::<F>(&units, [F::Quad::zero(); CORRECTIONS / 4])
    }
}

/// The last layer, in two chains of additions.
#[inline(always)]
fn last<F: Plain>(units: &Units<F>, start: Outputs<F>) -> [F; CORRECTIONS] {
    let rows = F::Stored::table(&LAST.0, &LAST_WIDE.0);
    let (mut sums, mut others) = (start, [F::Quad::zero(); CORRECTIONS / 4]);
    for (quad, [row_a, row_b, row_c, row_d]) in units.iter().zip(rows.as_chunks::<4>().0) {
        let [a, b, c, d] = quad.parts();
        add_row::<F>(&mut sums, a, row_a);
        add_row::<F>(&mut others, b, row_b);
        add_row::<F>(&mut sums, c, row_c);
        add_row::<F>(&mut others, d, row_d);
    }
    let mut outputs = [F::zero(); CORRECTIONS];
    for (four, (sum, other)) in
        outputs.as_chunks_mut::<4>().0.iter_mut().zip(sums.iter().zip(&others))
    {
        *four = (*sum + *other).parts();
    }
    outputs
}

/// `sums + x row`
#[inline(always)]
fn add_row<F: Plain>(sums: &mut [F::Quad], x: F, row: &[[Stored<F>; 2]]) {
    let x = F::Quad::all(x);
    for (sum, weights) in sums.iter_mut().zip(row.as_chunks::<2>().0) {
        *sum += x * quad::<F>(weights);
    }
}

#[inline(always)]
fn quads<F: Plain, const P: usize, const Q: usize>(row: &Row<Stored<F>, P>) -> [F::Quad; Q] {
    let mut quads = [F::Quad::zero(); Q];
    for (place, couples) in quads.iter_mut().zip(row.as_chunks::<2>().0) {
        *place = quad::<F>(couples);
    }
    quads
}

#[inline(always)]
fn quad<F: Plain>([first, second]: &[[Stored<F>; 2]; 2]) -> F::Quad {
    let ([a, b], [c, d]) = (F::both_stored(*first), F::both_stored(*second));
    F::Quad::plain([a, b, c, d])
}
