//! Functions of the distances between the edges of one cell and the places of all cells: the
//! deflection and the curvature that its pressure causes there.

use crate::normal::cell::{CELLS, Cell};
use crate::normal::influence::StripEdge;
use crate::number::avx::with_avx;
use crate::number::{Arithmetic, Dual, Float, Number, Strips, set_at};
use core::marker::PhantomData;

pub(super) struct CellEdges<F, const N: usize> {
    lower: Dual<F, N>,
    upper: Dual<F, N>,
    half_length: F,
    /// `da/a`
    growth: [F; N],
    scale: F,
}

/// A number with the first of its derivatives.
#[inline]
pub(super) fn stored<F: Float, const N: usize, const STORED: usize>(
    x: Dual<F, N>,
) -> Dual<F, STORED> {
    Dual { value: x.value, gradient: core::array::from_fn(|k| x.derivative(k)) }
}

impl<F: Float, const N: usize> CellEdges<F, N> {
    #[inline]
    pub(super) fn new<const ALL: usize>(cell: &Cell<F, ALL>) -> Self {
        let (y, a): (Dual<F, N>, Dual<F, N>) = (stored(cell.y), stored(cell.half_length));
        let half = stored::<_, ALL, N>(cell.width).times(0.5);
        let scale = F::one() / a.value;
        Self {
            lower: y - half,
            upper: y + half,
            half_length: a.value,
            growth: a.gradient.map(|growth| growth * scale),
            scale,
        }
    }

    /// Replaces each distance by the value of the function.
    fn all_at<E: StripEdge>(&self, values: &mut [F], slopes: &mut [[F; N]]) {
        with_avx!(if 1 => <F: Float, E: StripEdge; N>(
            edges: &CellEdges<F, N> = self,
            _of: PhantomData<E> = PhantomData::<E>,
            values: &mut [F],
            slopes: &mut [[F; N]]
        ) -> () {
            edges.in_fours::<E, F::Four>(values, slopes)
        } {
            edges.in_fours::<E, F::WideFour>(values, slopes)
        })
    }

    /// The same, four side by side.
    #[inline(always)]
    fn in_fours<E: StripEdge, P: Strips<F>>(&self, values: &mut [F], slopes: &mut [[F; N]]) {
        let one = P::one();
        let four = |four: &[F; 4]| P::gather(|k| four.get(k).copied().unwrap_or(F::one()));
        let slopes = slopes.as_chunks_mut::<4>().0.iter_mut();
        for (values, slopes) in values.as_chunks_mut::<4>().0.iter_mut().zip(slopes) {
            let distance = four(values);
            let size = distance.abs();
            let t = size * P::all(self.scale);
            // one division for 1/(1 + t) and 1/d
            let both = one / (size * (t + one));
            let (w, inverse) = (size * both, (t + one) * both);
            let log = F::ln_quotients(size, self.half_length);
            let [value, slope] = E::kernel(t, w, log);
            let sign = distance.choose(one, -one);
            let value = sign * value;
            *values = core::array::from_fn(|k| value.lane(k));
            for (d, growth) in self.growth.into_iter().enumerate() {
                let moved = P::gather(|k| {
                    slopes.get(k).and_then(|slopes| slopes.get(d)).copied().unwrap_or(F::one())
                });
                // d ln t = d(distance)/distance − da/a
                let relative = sign * moved * inverse - P::all(growth);
                let slope = sign * slope * relative;
                for (k, slopes) in slopes.iter_mut().enumerate() {
                    set_at(slopes, d, slope.lane(k));
                }
            }
        }
    }
}

/// Largest number of edges whose distances from a cell are needed.
const CELL_EDGES: usize = 2 * CELLS;

/// A function of the distances of a cell's edges from the places of all cells.
pub(super) struct Across<F, const N: usize> {
    values: [F; CELL_EDGES],
    slopes: [[F; N]; CELL_EDGES],
    /// Whether it is the lower edge. Before each is the upper edge.
    is_lower: [bool; CELL_EDGES],
    count: usize,
}

impl<F: Float, const N: usize> Across<F, N> {
    pub(super) fn new() -> Self {
        let none = [F::one(); CELL_EDGES];
        Self {
            values: none,
            slopes: [[F::one(); N]; CELL_EDGES],
            is_lower: [false; CELL_EDGES],
            count: 0,
        }
    }

    /// An odd function of `t = d/a`. Where cells as wide as this one are neighbours, one's lower
    /// edge is as far as the other's upper edge.
    #[inline]
    pub(super) fn measure<E: StripEdge, const ALL: usize>(
        &mut self, edges: &CellEdges<F, N>, cells: &[Cell<F, ALL>],
    ) {
        let Self { values, slopes, is_lower, count } = self;
        let width = (edges.upper - edges.lower).value;
        let close = width * F::EPSILON.times(256.0);
        let mut places = values.iter_mut().zip(slopes.iter_mut()).zip(is_lower.iter_mut());
        let mut add = |distance: Dual<F, N>, lower: bool| {
            if let Some(((value, slope), is_lower)) = places.next() {
                (*value, *slope, *is_lower) = (distance.value, distance.gradient, lower);
            }
        };
        let mut last: Option<F> = None;
        for cell in cells {
            let (place, at) = (cell.at.value, stored(cell.at));
            if !last.is_some_and(|before| (place - before - width).abs() <= close) {
                add(at - edges.upper, false);
            }
            add(at - edges.lower, true);
            last = Some(place);
        }
        *count = CELL_EDGES - places.len();
        let fours = count.next_multiple_of(4);
        if let (Some(values), Some(slopes)) = (values.get_mut(..fours), slopes.get_mut(..fours)) {
            edges.all_at::<E>(values, slopes);
        }
    }

    /// The value at the lower edge less that at the upper one, for each cell.
    #[inline]
    pub(super) fn differences(&self) -> impl Iterator<Item = Dual<F, N>> {
        let Self { values, slopes, is_lower, count } = self;
        let pairs = values.windows(2).zip(slopes.windows(2)).zip(is_lower.iter().skip(1));
        pairs.take(count.saturating_sub(1)).filter(|(_, is_lower)| **is_lower).map(|(pair, _)| {
            match pair {
                ([upper, lower], [upper_moved, lower_moved]) => {
                    let upper = Dual { value: *upper, gradient: *upper_moved };
                    Dual { value: *lower, gradient: *lower_moved } - upper
                }
                _ => Dual::zero(),
            }
        })
    }
}
