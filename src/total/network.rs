//! The network of corrections, its units side by side in pairs, and how they move when its inputs do.

use super::constants::{FIRST, FIXED, LAST, LAST_BIAS, SECOND};
use crate::linear::widen;
use crate::number::{Arithmetic, Float, Map, Number, Pair, Plain, Quad};

/// What the network is told that depends on the contact only, and the rest.
const FIXED_INPUTS: usize = FIXED.len() - 1;
const INPUTS: usize = FIRST.len();
/// Units of the two hidden layers, in pairs.
const PAIRS_1: usize = SECOND.len() / 2;
const UNITS_1: usize = 2 * PAIRS_1;
const PAIRS_2: usize = LAST[0].len();

/// Six corrections for one contact: sums of the first layer over what depends on the contact only.
#[derive(Clone, Copy, Debug)]
pub(super) struct Network<F> {
    sums: [[F; 2]; PAIRS_1],
}

impl<F: Plain> Network<F> {
    #[inline(always)]
    pub(super) fn of_contact(fixed: [F; FIXED_INPUTS]) -> Self {
        let sums = from_bias::<F, PAIRS_1>(&fixed, F::Stored::table(&FIXED, &FIXED_WIDE.0));
        Self { sums: sums.map(|pair| pair.parts().into()) }
    }

    /// The corrections for the other inputs.
    #[inline(always)]
    pub(super) fn corrections<T: Number<Base = F>>(&self, inputs: [T; INPUTS]) -> [T; 6] {
        T::map(self, inputs)
    }
}

/// The constants in double precision: converted by the compiler, and where registers of two doubles
/// can be read from.
#[repr(align(16))]
struct Wide<T>(T);

static FIXED_WIDE: Wide<[[[f64; 2]; PAIRS_1]; FIXED.len()]> = Wide(widen(&FIXED));
static FIRST_WIDE: Wide<[[[f64; 2]; PAIRS_1]; INPUTS]> = Wide(widen(&FIRST));
static SECOND_WIDE: Wide<[[[f64; 2]; PAIRS_2]; SECOND.len()]> = Wide(widen(&SECOND));
static LAST_WIDE: Wide<[[[f64; 2]; PAIRS_2]; 6]> = Wide(widen(&LAST));

impl<F: Plain> Map<F, INPUTS, 6> for Network<F> {
    type Place = ([F::Pair; PAIRS_1], [F::Pair; PAIRS_2]);

    #[inline(always)]
    fn value(&self, inputs: [F; INPUTS]) -> ([F; 6], Self::Place) {
        let sums = <F::Pair as Arithmetic>::each(&self.sums, |[p, q]| F::Pair::of(*p, *q));
        let sums = add_rows::<F, PAIRS_1>(sums, &inputs, F::Stored::table(&FIRST, &FIRST_WIDE.0));
        let (units, slope_1) = activation(sums);
        let units = apart::<F, PAIRS_1, UNITS_1>(units);
        let sums = from_bias::<F, PAIRS_2>(&units, F::Stored::table(&SECOND, &SECOND_WIDE.0));
        let (units, slope_2) = activation(sums);
        (last_layer::<F>(units, LAST_BIAS), (slope_1, slope_2))
    }

    #[inline(always)]
    fn tangent(&self, (slope_1, slope_2): &Self::Place, inputs: [F; INPUTS]) -> [F; 6] {
        let zero = <F::Pair as Arithmetic>::zero();
        let rows = F::Stored::table(&FIRST, &FIRST_WIDE.0);
        let units = times(add_rows::<F, PAIRS_1>([zero; PAIRS_1], &inputs, rows), slope_1);
        let units = apart::<F, PAIRS_1, UNITS_1>(units);
        let [_, rows @ ..] = F::Stored::table(&SECOND, &SECOND_WIDE.0);
        let units = times(add_rows::<F, PAIRS_2>([zero; PAIRS_2], &units, rows), slope_2);
        last_layer::<F>(units, [0.0; 6])
    }
}

/// `bias + Σ xᵢ rowᵢ`: the first row of `weights` is the bias.
#[inline(always)]
fn from_bias<F: Plain, const P: usize>(
    inputs: &[F],
    weights: &[[[F::Stored; 2]; P]],
) -> [F::Pair; P] {
    match weights {
        [bias, rows @ ..] => {
            let plain = |two: &[F::Stored; 2]| <F::Pair as Pair<F>>::plain(F::both_stored(*two));
            let bias = <F::Pair as Arithmetic>::each(bias, plain);
            add_rows::<F, P>(bias, inputs, rows)
        }
        [] => [<F::Pair as Arithmetic>::zero(); P],
    }
}

/// `sums + Σ xᵢ rowᵢ`, row by row: the sums stay in registers and do not wait for each other.
///
/// (Numbers of several contacts side by side fill whole registers: six sums at a time, then the rows again.)
#[inline(always)]
fn add_rows<F: Plain, const P: usize>(
    mut sums: [F::Pair; P],
    inputs: &[F],
    rows: &[[[F::Stored; 2]; P]],
) -> [F::Pair; P] {
    if F::LANES == 1 {
        let (pairs, rest) = sums.as_chunks_mut::<2>();
        let mut quads = [<F::Quad as Arithmetic>::zero(); P];
        for (quad, [first, second]) in quads.iter_mut().zip(&*pairs) {
            *quad = F::Quad::of_halves(*first, *second);
        }
        for (input, row) in inputs.iter().zip(rows) {
            let (weights, last) = row.as_chunks::<2>();
            let x = <F::Quad as Quad<F>>::all(*input);
            for (sum, weights) in quads.iter_mut().zip(weights) {
                *sum += x * quad_of::<F>(weights);
            }
            add_row::<F>(rest, *input, last);
        }
        for (pairs, quad) in pairs.iter_mut().zip(quads) {
            *pairs = quad.halves();
        }
        return sums;
    }
    let (blocks, rest) = sums.as_chunks_mut::<3>();
    for (k, block) in blocks.iter_mut().enumerate() {
        for (input, row) in inputs.iter().zip(rows) {
            if let Some(row) = row.as_chunks::<3>().0.get(k) {
                add_row::<F>(block, *input, row);
            }
        }
    }
    for (input, row) in inputs.iter().zip(rows) {
        add_row::<F>(rest, *input, row.as_chunks::<3>().1);
    }
    sums
}

#[inline(always)]
fn add_row<F: Plain>(sums: &mut [F::Pair], input: F, row: &[[F::Stored; 2]]) {
    let x = <F::Pair as Pair<F>>::both(input);
    for (sum, weights) in sums.iter_mut().zip(row) {
        *sum += x.scale_each(F::both_stored(*weights));
    }
}

/// Two pairs of constants side by side.
#[inline(always)]
fn quad_of<F: Plain>([first, second]: &[[F::Stored; 2]; 2]) -> F::Quad {
    let ([a, b], [c, d]) = (F::both_stored(*first), F::both_stored(*second));
    F::Quad::plain([a, b, c, d])
}

/// The last layer: products of pairs of units, two chains of sums for each output.
#[inline(always)]
fn last_layer<F: Plain>(units: [F::Pair; PAIRS_2], bias: [f32; 6]) -> [F; 6] {
    let mut outputs = F::each(&bias, |x| F::of_f32(*x));
    for (output, weights) in outputs.iter_mut().zip(F::Stored::table(&LAST, &LAST_WIDE.0)) {
        let mut first = <F::Pair as Pair<F>>::of(*output, F::zero());
        let mut second = <F::Pair as Arithmetic>::zero();
        let (mut both, mut factors) = (units.chunks_exact(2), weights.chunks_exact(2));
        for (both, factors) in (&mut both).zip(&mut factors) {
            if let ([x, y], [p, q]) = (both, factors) {
                first += x.scale_each(F::both_stored(*p));
                second += y.scale_each(F::both_stored(*q));
            }
        }
        if let ([x], [p]) = (both.remainder(), factors.remainder()) {
            first += x.scale_each(F::both_stored(*p));
        }
        *output = (first + second).sum();
    }
    outputs
}

/// Pairs, one number after the other.
#[inline(always)]
fn apart<F: Plain, const N: usize, const M: usize>(pairs: [F::Pair; N]) -> [F; M] {
    let mut numbers = [F::zero(); M];
    for (two, pair) in numbers.chunks_exact_mut(2).zip(pairs) {
        let (first, second) = pair.parts();
        if let [p, q] = two {
            *p = first;
            *q = second;
        }
    }
    numbers
}

#[inline(always)]
fn times<P: Arithmetic, const N: usize>(mut x: [P; N], y: &[P; N]) -> [P; N] {
    for (x, y) in x.iter_mut().zip(y) {
        *x = *x * *y;
    }
    x
}

/// `2x/(1 + x²)` and its slope `2/(1 + x²) − (2x/(1 + x²))²`, with one division for two pairs.
#[inline(always)]
fn activation<P: Arithmetic, const N: usize>(x: [P; N]) -> ([P; N], [P; N]) {
    let mut y = x;
    let mut slope = x;
    let (mut units, mut slopes) = (y.chunks_exact_mut(2), slope.chunks_exact_mut(2));
    for (units, slopes) in (&mut units).zip(&mut slopes) {
        if let ([y, z], [s, t]) = (units, slopes) {
            let (p, q) = (y.squared().plus(1.0), z.squared().plus(1.0));
            let r = P::constant(2.0) / (p * q);
            let (p, q) = (r * q, r * p);
            *y = *y * p;
            *z = *z * q;
            *s = p - y.squared();
            *t = q - z.squared();
        }
    }
    if let ([y], [s]) = (units.into_remainder(), slopes.into_remainder()) {
        let p = P::constant(2.0) / y.squared().plus(1.0);
        *y = *y * p;
        *s = p - y.squared();
    }
    (y, slope)
}
