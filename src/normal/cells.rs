//! The normal problem on cells: pressure and outline of a patch under a load or an approach.
//!
//! The bodies are half-spaces that are `h(y) + x²/(2 R)` apart. The pressure of a cell is a
//! half-ellipse over its length `2 a_i` with the peak `p_i`. Length and peak follow from two
//! conditions on the cell's middle line, with the sums of `influence` over all cells of all zones:
//!
//! ```text
//! u_i = Σ_j A_ij a_j p_j/(π E*) = δ − h_i        the bodies touch (linear in p, p ≥ 0)
//! −∂²u_i/∂x² = Σ_j C_ij p_j/(a_j π E*) = 1/R_i   and keep touching along x (gives a)
//! ```
//!
//! The first condition is solved directly for given lengths. Cells that would pull are removed and
//! cells whose bodies would overlap are added, until neither happens. The second condition then
//! corrects the lengths. On a long cell its left-hand side goes with `1/a²`, so that a step
//! multiplies `a` by the root of the quotient of both sides, or by a little less where the
//! neighbours move as well.
//!
//! The end of a zone may cut a cell to the share `r`. The pressure of such a cell is coupled to
//! that of its neighbour in the zone, `u_i + κ (p_i − p_k) = δ − h_i` with `κ = 0.3 w (1 − r)²/r`,
//! and takes the neighbour's value as its width vanishes.

use crate::normal::influence::{Curvature, Deflection, StripEdge};
pub use crate::normal::layout::CELLS;
use crate::normal::layout::CellPlaces;
use crate::normal::profile::{WithSlope, side_by_side};
use crate::number::avx::with_avx;
use crate::number::{Arithmetic, Float, Strips};
use core::f64::consts::FRAC_PI_2;
use core::marker::PhantomData;
use heapless::Vec;

/// Rounds in which all cells are removed and added that should be; one or two are usual. In later
/// rounds only the first of them is.
const TOGETHER: usize = 12;
const ROUNDS: usize = TOGETHER + 2 * CELLS;

/// What is given of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Given<F> {
    /// Normal force \[N\], not negative.
    Load(F),
    /// Approach of distant points of the two bodies \[m\]; none or a negative one is no contact.
    Approach(F),
}

impl<F> Given<F> {
    pub(crate) fn value(self) -> F {
        let (Self::Load(value) | Self::Approach(value)) = self;
        value
    }
}

/// A cell of the normal problem.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cell<F> {
    /// Middle line \[m\].
    pub y: WithSlope<F>,
    /// Width \[m\].
    pub width: WithSlope<F>,
    /// Undeformed distance on the middle line \[m\].
    pub distance: WithSlope<F>,
    /// Rolling radius `R` \[m\].
    pub rolling_radius: WithSlope<F>,
    /// Half length \[m\].
    pub half_length: WithSlope<F>,
    /// `p/(π E*)`; zero where the bodies do not touch.
    pub pressure: WithSlope<F>,
    /// Whether the bodies touch.
    pub touches: bool,
    /// Where the conditions of contact hold \[m\].
    at: WithSlope<F>,
    /// `κ` to the cell before and to the cell after.
    coupling: [WithSlope<F>; 2],
    /// `κ` to a pressure of zero.
    alone: WithSlope<F>,
}

/// Largest number of edges whose distances from a cell are needed.
const EDGES: usize = 2 * CELLS;

type Matrix<F> = Vec<[F; CELLS], CELLS>;

/// Room for the equations of as many cells as there are.
pub(crate) struct Equations<F> {
    /// `∂u_i/∂p_j`
    influence: Matrix<F>,
    /// Their derivatives.
    slopes: Matrix<F>,
    factors: Matrix<F>,
}

impl<F: Float> Equations<F> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self { influence: Vec::new(), slopes: Vec::new(), factors: Vec::new() }
    }

    /// Makes room for so many cells, in place.
    fn make_room(&mut self, count: usize) {
        for rows in [&mut self.influence, &mut self.slopes, &mut self.factors] {
            while rows.len() < count && rows.push([F::zero(); CELLS]).is_ok() {}
        }
    }

    fn copy_to_factors(&mut self, count: usize) {
        for (row, from) in self.factors.iter_mut().zip(&self.influence).take(count) {
            for (factor, entry) in row.iter_mut().zip(from).take(count) {
                *factor = *entry;
            }
        }
    }
}

/// Cells in ascending `y`.
#[derive(Clone, Debug)]
pub(crate) struct Cells<F> {
    pub list: Vec<Cell<F>, CELLS>,
}

impl<F: Float> Cells<F> {
    /// Cells at their places; `of` gives distance, rolling radius and half length of each, and
    /// whether it may touch.
    pub(super) fn place(
        &mut self,
        places: &CellPlaces<F>,
        of: impl Fn(WithSlope<F>) -> ([WithSlope<F>; 3], bool),
    ) {
        let list = &mut self.list;
        list.clear();
        for place in places {
            let ([distance, rolling_radius, half_length], touches) = of(place.at);
            let _ = list.push(Cell {
                y: place.y,
                width: place.width,
                distance,
                rolling_radius,
                half_length,
                pressure: WithSlope::zero(),
                touches,
                at: place.at,
                coupling: place.coupling,
                alone: place.alone,
            });
        }
    }

    /// `N/(π E*) = Σ (π/2) a w p/(π E*)`
    pub(crate) fn load(&self) -> WithSlope<F> {
        self.list.iter().fold(WithSlope::zero(), |sum, cell| {
            sum + (cell.half_length * cell.width * cell.pressure).times(FRAC_PI_2)
        })
    }

    /// Mean pressure over mean half length, and mean width \[m\], weighted with the load.
    pub(crate) fn means(&self) -> [F; 2] {
        let (mut sum, mut weight) = (F::zero(), F::TINY);
        let (mut widths, mut loads) = (F::zero(), F::TINY);
        for cell in &self.list {
            let (a, p) = (cell.half_length.value, cell.pressure.value);
            let load = p * cell.width.value;
            sum += load * a * p;
            weight += load * a * a;
            widths += load * a * cell.width.value;
            loads += load * a;
        }
        [sum / weight, widths / loads]
    }

    /// Finds the pressures for the present lengths and a given load `N/(π E*)` or approach; returns
    /// the approach.
    #[inline(never)]
    pub(crate) fn press(
        &mut self,
        equations: &mut Equations<F>,
        given: Given<WithSlope<F>>,
    ) -> WithSlope<F> {
        equations.make_room(self.list.len());
        for (j, cell) in self.list.iter().enumerate() {
            let mut rows = equations.influence.iter_mut().zip(&mut equations.slopes);
            Edges::new(cell).across::<Deflection>(&self.list, |difference| {
                let found = difference * cell.half_length;
                let Some((row, slope)) = rows.next() else { return };
                if let (Some(entry), Some(slope)) = (row.get_mut(j), slope.get_mut(j)) {
                    (*entry, [*slope]) = (found.value, found.gradient);
                }
            });
        }
        for (i, (cell, (row, slope))) in self
            .list
            .iter()
            .zip(equations.influence.iter_mut().zip(&mut equations.slopes))
            .enumerate()
        {
            let [before, after] = cell.coupling;
            // (past the last cell there is nothing, whose pressure is zero)
            let beside = [(before, i.wrapping_sub(1)), (after, i + 1), (cell.alone, CELLS)];
            for (kappa, k) in beside {
                let [change] = kappa.gradient;
                for (k, sign) in [(i, F::one()), (k, -F::one())] {
                    if let (Some(entry), Some(slope)) = (row.get_mut(k), slope.get_mut(k)) {
                        *entry += sign * kappa.value;
                        *slope += sign * change;
                    }
                }
            }
        }
        // (coarse cells may all begin beyond the reach of their zone)
        if !self.list.iter().any(|cell| cell.touches) {
            let least = self.list.iter_mut().reduce(|least, cell| {
                if cell.distance.value < least.distance.value { cell } else { least }
            });
            if let Some(cell) = least {
                cell.touches = true;
            }
        }
        let count = self.list.len();
        let mut approach = WithSlope::zero();
        for round in 0..ROUNDS {
            equations.copy_to_factors(count);
            let Equations { influence, slopes, factors } = equations;
            let mut active: Vec<usize, CELLS> = Vec::new();
            for (i, cell) in self.list.iter().enumerate() {
                if cell.touches {
                    let _ = active.push(i);
                }
            }
            let mut one = [F::zero(); CELLS];
            let mut distance = [F::zero(); CELLS];
            for ((cell, one), distance) in self.list.iter().zip(&mut one).zip(&mut distance) {
                if cell.touches {
                    (*one, *distance) = (F::one(), cell.distance.value);
                }
            }
            factorise(factors, &active, count);
            substitute(factors, &active, &mut one, count);
            substitute(factors, &active, &mut distance, count);
            // p = δ X − Y
            let (mut by_approach, mut without) = (F::zero(), F::zero());
            for ((cell, one), distance) in self.list.iter().zip(one).zip(distance) {
                let area = cell.half_length.value * cell.width.value;
                by_approach += area * one;
                without += area * distance;
            }
            approach.value = match given {
                Given::Load(load) => (load.value.times(1.0 / FRAC_PI_2) + without) / by_approach,
                Given::Approach(approach) => approach.value,
            };
            let mut pressures = [F::zero(); CELLS];
            for ((p, one), distance) in pressures.iter_mut().zip(one).zip(distance) {
                *p = approach.value * one - distance;
            }
            let mut changed = false;
            for ((cell, p), row) in self.list.iter_mut().zip(&pressures).zip(influence.iter()) {
                cell.pressure.value = *p;
                let stays = if cell.touches {
                    *p > F::zero()
                } else {
                    // the bodies would overlap
                    let pushed = product(row.get(..count).unwrap_or(row), &pressures);
                    approach.value - cell.distance.value > pushed
                };
                // many at once at first, then the first of them in each round
                if stays != cell.touches && (round < TOGETHER || !changed) {
                    changed = true;
                    if round + 1 < ROUNDS {
                        cell.touches = stays;
                    }
                }
            }
            if changed && round + 1 < ROUNDS {
                continue;
            }
            // A dp = dδ − dh − dA p
            let mut rest = [F::zero(); CELLS];
            for ((rest, cell), row) in rest.iter_mut().zip(&self.list).zip(slopes.iter()) {
                let [moved] = cell.distance.gradient;
                *rest = -(moved + product(row.get(..count).unwrap_or(row), &pressures));
            }
            for (rest, cell) in rest.iter_mut().zip(&self.list) {
                if !cell.touches {
                    *rest = F::zero();
                }
            }
            substitute(factors, &active, &mut rest, count);
            let mut carried = F::zero();
            for (cell, rest) in self.list.iter().zip(rest) {
                let area = cell.half_length * cell.width;
                let [widened] = area.gradient;
                carried += widened * cell.pressure.value + area.value * rest;
            }
            approach.gradient = match given {
                Given::Load(load) => {
                    load.gradient.map(|d| (d.times(1.0 / FRAC_PI_2) - carried) / by_approach)
                }
                Given::Approach(approach) => approach.gradient,
            };
            let [slope] = approach.gradient;
            for ((cell, one), rest) in self.list.iter_mut().zip(one).zip(rest) {
                cell.pressure.gradient = [slope * one + rest];
            }
            break;
        }
        for cell in &mut self.list {
            if !(cell.touches && cell.pressure.value > F::zero()) {
                cell.pressure = WithSlope::zero();
            }
        }
        approach
    }

    /// Corrects the lengths for the present pressures, by a power of the quotient of both sides of
    /// the second condition; also those of cells that do not touch, as if they were about to.
    #[inline(never)]
    pub(crate) fn correct(&mut self, power: WithSlope<F>) {
        let (less, more) = (WithSlope::one() - power, WithSlope::one() + power);
        let mut curvatures = [WithSlope::zero(); CELLS];
        for cell in self.list.iter().filter(|cell| cell.touches) {
            let share = cell.pressure / cell.half_length;
            let mut sums = curvatures.iter_mut();
            Edges::new(cell).across::<Curvature>(&self.list, |difference| {
                if let Some(sum) = sums.next() {
                    *sum += difference * share;
                }
            });
        }
        for (cell, curvature) in self.list.iter_mut().zip(curvatures) {
            // the power of c as its Padé approximant, which keeps the correction within a factor of
            // 4 for every c
            let c = (curvature * cell.rolling_radius).max(WithSlope::zero());
            cell.half_length = cell.half_length * ((c * more + less) / (c * less + more));
        }
    }
}

/// The edges of a cell.
struct Edges<F> {
    lower: WithSlope<F>,
    upper: WithSlope<F>,
    half_length: F,
    /// `da/a`
    growth: F,
    scale: F,
}

impl<F: Float> Edges<F> {
    fn new(cell: &Cell<F>) -> Self {
        let half = cell.width.times(0.5);
        let a = cell.half_length;
        let scale = F::one() / a.value;
        let [growth] = a.gradient;
        Self {
            lower: cell.y - half,
            upper: cell.y + half,
            half_length: a.value,
            growth: growth * scale,
            scale,
        }
    }

    /// The differences of an odd function of `t = d/a` between the distances of the edges from each
    /// cell's place. Where cells as wide as this one are neighbours, one's lower edge is as far as
    /// the other's upper edge.
    fn across<E: StripEdge>(&self, cells: &[Cell<F>], mut take: impl FnMut(WithSlope<F>)) {
        let width = (self.upper - self.lower).value;
        let near =
            |place: F, before: F| (place - before - width).abs() <= width * F::EPSILON.times(256.0);
        let mut distances: Vec<WithSlope<F>, EDGES> = Vec::new();
        let mut last: Option<F> = None;
        for cell in cells {
            let place = cell.at.value;
            if !last.is_some_and(|before| near(place, before)) {
                let _ = distances.push(cell.at - self.upper);
            }
            let _ = distances.push(cell.at - self.lower);
            last = Some(place);
        }
        self.all_at::<E>(&mut distances);
        let mut found = distances.iter();
        let mut last: Option<(F, WithSlope<F>)> = None;
        for cell in cells {
            let place = cell.at.value;
            let upper = match last {
                Some((before, far)) if near(place, before) => Some(far),
                _ => found.next().copied(),
            };
            let (Some(upper), Some(lower)) = (upper, found.next().copied()) else { return };
            take(lower - upper);
            last = Some((place, lower));
        }
    }

    /// Replaces each distance by the value of the function.
    fn all_at<E: StripEdge>(&self, distances: &mut [WithSlope<F>]) {
        with_avx!(if 1 => <F: Float, E: StripEdge>(
            edges: &Edges<F> = self,
            _of: PhantomData<E> = PhantomData::<E>,
            distances: &mut [WithSlope<F>] = distances
        ) -> () {
            edges.in_fours::<E, F::Four>(distances)
        } {
            edges.in_fours::<E, F::WideFour>(distances)
        })
    }

    /// The same, four side by side.
    #[inline(always)]
    fn in_fours<E: StripEdge, P: Strips<F>>(&self, distances: &mut [WithSlope<F>]) {
        let one = P::one();
        for four in distances.chunks_mut(4) {
            let [distance, moved] = side_by_side::<F, P>(four, F::one());
            let size = distance.abs();
            let t = size * P::all(self.scale);
            // one division for 1/(1 + t) and 1/d
            let both = one / (size * (t + one));
            let (w, inverse) = (size * both, (t + one) * both);
            let log = F::ln_quotients(size, self.half_length);
            let [value, slope] = E::at(t, w, log);
            let sign = distance.choose(one, -one);
            // d ln t = d(distance)/distance − da/a
            let relative = sign * moved * inverse - P::all(self.growth);
            let (value, slope) = (sign * value, sign * slope * relative);
            for (k, distance) in four.iter_mut().enumerate() {
                *distance = WithSlope { value: value.lane(k), gradient: [slope.lane(k)] };
            }
        }
    }
}

/// `Σ x_i y_i`
fn product<F: Float>(x: &[F], y: &[F]) -> F {
    x.iter().zip(y).fold(F::zero(), |sum, (x, y)| sum + *x * *y)
}

/// Gauss's elimination without pivots of the rows and columns listed: the diagonal is the largest
/// of its row. Below it stand the factors.
fn factorise<F: Float>(matrix: &mut Matrix<F>, active: &[usize], count: usize) {
    let full = active.len();
    for (order, k) in active.iter().enumerate() {
        let rest = active.get(order + 1..full).unwrap_or(&[]);
        let Some(pivot) = matrix.get(*k).copied() else { return };
        let diagonal = pivot.get(*k).copied().unwrap_or(F::one());
        let inverse = F::one() / diagonal;
        for i in rest {
            let Some(row) = matrix.get_mut(*i) else { return };
            let Some(first) = row.get_mut(*k) else { return };
            let factor = *first * inverse;
            *first = factor;
            // (columns of cells apart are computed too and not looked at)
            let (Some(row), Some(pivot)) = (row.get_mut(k + 1..count), pivot.get(k + 1..count))
            else {
                return;
            };
            for (own, above) in row.iter_mut().zip(pivot) {
                *own -= factor * *above;
            }
        }
    }
}

/// Solves for a right-hand side, in place; zero for cells that do not touch.
fn substitute<F: Float>(matrix: &Matrix<F>, active: &[usize], side: &mut [F; CELLS], count: usize) {
    for k in active {
        let Some(row) = matrix.get(*k) else { return };
        if let Some((before, [own, ..])) = side.split_at_mut_checked(*k) {
            *own -= product(row, before);
        }
    }
    for k in active.iter().rev() {
        let Some((diagonal, factors)) =
            matrix.get(*k).and_then(|row| row.get(*k..count)?.split_first())
        else {
            return;
        };
        if let Some([own, after @ ..]) = side.get_mut(*k..count) {
            *own = (*own - product(factors, after)) / *diagonal;
        }
    }
}
