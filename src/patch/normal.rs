//! The normal problem on strips of one width: pressure and outline of a patch under a load or an approach.
//!
//! The bodies are half-spaces that are `h(y) + x²/(2 R)` apart. A strip's pressure is a half-ellipse over its length
//! `2 a_i`, its peak `p_i`; both are found from two conditions on its middle line, with the sums of `influence` over
//! all strips of all zones:
//!
//! ```text
//! u_i = Σ_j A_ij a_j p_j/(π E*) = δ − h_i        the bodies touch               (linear in p, p ≥ 0)
//! −∂²u_i/∂x² = Σ_j C_ij p_j/(a_j π E*) = 1/R     and keep touching along x      (gives a)
//! ```
//!
//! The first is solved directly for given lengths. Strips that would pull leave, strips whose bodies would
//! overlap enter, until none does either. The second then corrects the lengths: on a long strip its left-hand side goes with
//! `1/a²`, so that a step takes the root of what is wrong with it, or a little less where its neighbours move as well.
//! A strip at the rim ends with `p → 0` and `a → 0` together; so zones appear, grow, touch and merge without a jump. Nothing
//! else distinguishes them.

use crate::number::Float;
use crate::patch::influence::{self, Edge};
use core::f64::consts::{FRAC_PI_2, PI};
use heapless::Vec;

/// Strips of the normal problem at most; on a microcontroller fewer, which patches of 32 and 64 strips notice.
pub const CELLS: usize = if cfg!(target_os = "none") { 28 } else { 48 };
/// Rounds in which strips leave and enter, at most; one or two are usual.
const ROUNDS: usize = 12;
/// Share of `√(2 R δ)` squared that a strip's length squared begins with at least.
const LEAST_SQUARE: f64 = 0.02;

/// What is given of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Given<F> {
    /// Normal force \[N\], not negative.
    Load(F),
    /// Approach of distant points of the two bodies \[m\]; none or a negative one is no contact.
    Approach(F),
}

/// A number and its derivative by what is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Moving<F> {
    pub value: F,
    pub slope: F,
}

/// A strip of the normal problem.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cell<F> {
    /// Its number on the lattice: neighbours have neighbouring ones.
    pub place: i32,
    /// Undeformed distance on its middle line \[m\].
    pub distance: F,
    /// Half length \[m\].
    pub half_length: Moving<F>,
    /// Peak pressure \[Pa\]; zero where the bodies do not touch.
    pub pressure: Moving<F>,
    /// Whether the bodies touch.
    pub touches: bool,
}

impl<F: Float> Cell<F> {
    pub(crate) fn new(place: i32, distance: F) -> Self {
        let zero = Moving { value: F::zero(), slope: F::zero() };
        Self { place, distance, half_length: zero, pressure: zero, touches: true }
    }
}

/// Strips of one width, ascending.
#[derive(Clone, Debug)]
pub(crate) struct Cells<F> {
    pub list: Vec<Cell<F>, CELLS>,
    /// Width of a strip \[m\].
    pub width: F,
    /// `R` \[m\]
    pub rolling_radius: F,
    /// `E* = G/(1 − ν)` \[Pa\]
    pub modulus: F,
}

/// A power `q` that lengths are corrected with.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Power<F> {
    /// `1 − q`
    less: F,
    /// `1 + q`
    more: F,
    /// `4 q`
    fourfold: F,
}

impl<F: Float> Power<F> {
    /// (A literal is converted by the compiler.)
    #[inline(always)]
    pub(crate) fn new(power: f64) -> Self {
        let [less, more, fourfold] = [1.0 - power, 1.0 + power, 4.0 * power].map(F::of);
        Self { less, more, fourfold }
    }
}

/// What one strip does to another, per unit of its pressure: `a A/(π E*)` and `C/(a π E*)`, and the derivatives of both by
/// `a`.
#[derive(Clone, Copy)]
struct Influence<F> {
    deflection: F,
    curvature: F,
    deflection_slope: F,
    curvature_slope: F,
}

/// What one strip does to all.
struct Column<F> {
    on: [Influence<F>; CELLS],
    known: bool,
}

impl<F: Float> Column<F> {
    fn unknown() -> Self {
        let zero = F::zero();
        let none = Influence {
            deflection: zero,
            curvature: zero,
            deflection_slope: zero,
            curvature_slope: zero,
        };
        Self { on: [none; CELLS], known: false }
    }
}

type Columns<F> = Vec<Column<F>, CELLS>;

/// Equations for the pressures of the strips that touch.
type Rows<F> = Vec<[F; CELLS], CELLS>;

impl<F: Float> Cells<F> {
    /// Lengths to begin with: `known` squares, and at least a small share of `2 R δ`. They grow as Hertz's do.
    pub(crate) fn begin(&mut self, given: Given<F>, approach: F, known: impl Fn(&Cell<F>) -> F) {
        let growth = match given {
            Given::Load(load) => F::one() / load.times(3.0),
            Given::Approach(_) => F::one() / approach.times(2.0),
        };
        let least = (self.rolling_radius * approach).times(2.0 * LEAST_SQUARE);
        for cell in &mut self.list {
            let square = known(cell);
            cell.touches = square > F::zero();
            let a = square.max(least).sqrt();
            cell.half_length = Moving { value: a, slope: a * growth };
        }
    }

    /// The pressures after one correction of the lengths; the approach.
    pub(crate) fn solve(&mut self, given: Given<F>, power: Power<F>) -> Moving<F> {
        let mut columns: Columns<F> = Vec::new();
        for _ in &self.list {
            // (room for as many columns as cells)
            let _ = columns.push(Column::unknown());
        }
        self.press(given, &mut columns);
        self.correct(power, &columns);
        columns.iter_mut().for_each(|column| column.known = false);
        self.press(given, &mut columns)
    }

    /// `Σ (π/2) a w p`
    pub(crate) fn load(&self) -> Moving<F> {
        let unit = self.width.times(FRAC_PI_2);
        let mut sum = Moving { value: F::zero(), slope: F::zero() };
        for Cell { half_length: a, pressure: p, .. } in &self.list {
            sum.value += unit * a.value * p.value;
            sum.slope += unit * (a.slope * p.value + a.value * p.slope);
        }
        sum
    }

    /// Mean pressure over mean half length \[Pa/m\], weighted with the load.
    pub(crate) fn mean_slope(&self) -> F {
        let (mut sum, mut weight) = (F::zero(), F::TINY);
        for cell in self.list.iter().filter(|cell| cell.touches) {
            let (a, p) = (cell.half_length.value, cell.pressure.value);
            sum += a * p * p;
            weight += a * p * a;
        }
        sum / weight
    }

    /// Fills the columns of the strips that touch.
    #[inline(never)]
    fn know(&self, columns: &mut [Column<F>]) {
        let scale = F::one() / self.modulus.times(PI);
        let places = || self.list.iter().map(|cell| cell.place);
        let (first, last) = (places().next().unwrap_or(0), places().last().unwrap_or(0));
        for (cell, column) in self.list.iter().zip(columns) {
            if column.known || !cell.touches {
                continue;
            }
            column.known = true;
            let a = cell.half_length.value;
            let unit = self.width / a;
            let at = |distance: i32| influence::edge(unit * F::widened(distance as f32).plus(0.5));
            // edges at the distances that neighbours have
            let farthest = (cell.place - first).max(last - cell.place);
            let mut edges = [Edge::none(); CELLS];
            for (distance, edge) in (0..=farthest).zip(&mut edges) {
                *edge = at(distance);
            }
            let edge = |distance: i32| match usize::try_from(distance).map(|i| edges.get(i)) {
                Ok(Some(edge)) => *edge,
                _ => at(distance),
            };
            let (inverse, of_all) = (F::one() / a, self.list.iter());
            for (other, influence) in of_all.zip(&mut column.on) {
                let distance = (other.place - cell.place).abs();
                let far = edge(distance);
                let near = if distance == 0 { far.mirrored() } else { edge(distance - 1) };
                // a A(w/a): derivative A − t A';  C(w/a)/a: −(C + t C')/a²
                let deflected = (far.deflection - near.deflection) * scale;
                let curved = (far.curvature - near.curvature) * scale * inverse;
                let moved = (far.curvature_slope - near.curvature_slope) * scale * inverse;
                *influence = Influence {
                    deflection: deflected * a,
                    curvature: curved,
                    deflection_slope: deflected
                        - (far.deflection_slope - near.deflection_slope) * scale,
                    curvature_slope: -(curved + moved) * inverse,
                };
            }
        }
    }

    /// Pressures for the lengths as they are; the approach.
    #[inline(never)]
    fn press(&mut self, given: Given<F>, columns: &mut [Column<F>]) -> Moving<F> {
        let unit = self.width.times(FRAC_PI_2);
        let mut approach = Moving { value: F::zero(), slope: F::zero() };
        for _ in 0..ROUNDS {
            self.know(columns);
            let mut rows: Rows<F> = Vec::new();
            let (mut one, mut distance) = ([F::zero(); CELLS], [F::zero(); CELLS]);
            for ((i, cell), (one, distance)) in
                self.touching().zip(one.iter_mut().zip(&mut distance))
            {
                let mut factors = [F::zero(); CELLS];
                for ((j, _), factor) in self.touching().zip(&mut factors) {
                    let on = columns.get(j).and_then(|column| column.on.get(i));
                    *factor = on.map_or(F::zero(), |on| on.deflection);
                }
                (*one, *distance) = (F::one(), cell.distance);
                let _ = rows.push(factors);
            }
            factorise(&mut rows);
            substitute(&rows, &mut one);
            substitute(&rows, &mut distance);
            // p = δ X − Y
            let (mut by_approach, mut without) = (F::zero(), F::zero());
            for (((_, cell), one), distance) in self.touching().zip(one).zip(distance) {
                by_approach += unit * cell.half_length.value * one;
                without += unit * cell.half_length.value * distance;
            }
            approach.value = match given {
                Given::Load(load) => (load + without) / by_approach,
                Given::Approach(approach) => approach,
            };
            let mut solved = one.iter().zip(distance);
            for cell in &mut self.list {
                cell.pressure.value = F::zero();
                if cell.touches
                    && let Some((one, distance)) = solved.next()
                {
                    cell.pressure.value = approach.value * *one - distance;
                }
            }
            let deflection = self.sum(columns, |on, cell| on.deflection * cell.pressure.value);
            let mut changed = false;
            for (cell, deflection) in self.list.iter_mut().zip(deflection) {
                let stays = if cell.touches {
                    cell.pressure.value > F::zero()
                } else {
                    // the bodies would overlap
                    approach.value - cell.distance > deflection
                };
                changed |= stays != cell.touches;
                cell.touches = stays;
            }
            if changed {
                continue;
            }
            // K dp = dδ − dK p
            let moved = self.sum(columns, |on, cell| {
                on.deflection_slope * (cell.half_length.slope * cell.pressure.value)
            });
            let mut change = [F::zero(); CELLS];
            for ((i, _), change) in self.touching().zip(&mut change) {
                *change = -at(Some(&moved), i);
            }
            substitute(&rows, &mut change);
            let mut rest = F::zero();
            for ((_, cell), change) in self.touching().zip(change) {
                rest += unit
                    * (cell.half_length.value * change
                        + cell.half_length.slope * cell.pressure.value);
            }
            approach.slope = match given {
                Given::Load(_) => (F::one() - rest) / by_approach,
                Given::Approach(_) => F::one(),
            };
            let mut solved = one.iter().zip(change);
            for cell in &mut self.list {
                cell.pressure.slope = F::zero();
                if cell.touches
                    && let Some((one, change)) = solved.next()
                {
                    cell.pressure.slope = approach.slope * *one + change;
                }
            }
            break;
        }
        for cell in &mut self.list {
            cell.pressure.value = cell.pressure.value.max(F::zero());
        }
        approach
    }

    /// The strips that touch, with their numbers.
    fn touching(&self) -> impl Iterator<Item = (usize, &Cell<F>)> {
        self.list.iter().enumerate().filter(|(_, cell)| cell.touches)
    }

    /// What all strips that touch do to each.
    fn sum(
        &self,
        columns: &[Column<F>],
        term: impl Fn(&Influence<F>, &Cell<F>) -> F,
    ) -> [F; CELLS] {
        let mut sums = [F::zero(); CELLS];
        for (column, cell) in columns.iter().zip(&self.list).filter(|(_, cell)| cell.touches) {
            for ((sum, on), _) in sums.iter_mut().zip(&column.on).zip(&self.list) {
                *sum += term(on, cell);
            }
        }
        sums
    }

    /// Lengths for the pressures as they are; also of strips that do not touch, as if they were about to.
    fn correct(&mut self, power: Power<F>, columns: &[Column<F>]) {
        let Power { less, more, fourfold } = power;
        let radius = self.rolling_radius;
        let curvature = self.sum(columns, |on, cell| on.curvature * cell.pressure.value);
        let change = self.sum(columns, |on, cell| {
            on.curvature * cell.pressure.slope
                + on.curvature_slope * (cell.half_length.slope * cell.pressure.value)
        });
        for ((cell, curvature), change) in self.list.iter_mut().zip(curvature).zip(change) {
            // the power of c as its Padé approximant: within a factor of 3 whatever c is
            let c = (curvature * radius).max(F::zero());
            let below = c * less + more;
            let factor = (c * more + less) / below;
            let slope = change * radius * fourfold / (below * below);
            let Moving { value: a, slope: da } = cell.half_length;
            cell.half_length = Moving { value: a * factor, slope: da * factor + a * slope };
        }
    }
}

fn at<F: Float>(list: Option<&[F; CELLS]>, i: usize) -> F {
    list.and_then(|list| list.get(i)).copied().unwrap_or(F::zero())
}

/// Gauss's elimination without pivots: the diagonal is the largest of its row. Below it stand the factors.
fn factorise<F: Float>(rows: &mut Rows<F>) {
    let count = rows.len();
    let mut rest = rows.as_mut_slice();
    let mut k = 0;
    while let Some((pivot, below)) = rest.split_first_mut() {
        let Some((diagonal, right)) = pivot.get(k..count).and_then(|row| row.split_first()) else {
            return;
        };
        let inverse = F::one() / *diagonal;
        for row in below.iter_mut() {
            if let Some((first, own)) = row.get_mut(k..count).and_then(|row| row.split_first_mut())
            {
                *first = *first * inverse;
                for (own, above) in own.iter_mut().zip(right) {
                    *own -= *first * *above;
                }
            }
        }
        rest = below;
        k += 1;
    }
}

/// The right-hand side becomes the solution.
fn substitute<F: Float>(rows: &Rows<F>, side: &mut [F; CELLS]) {
    for (k, row) in rows.iter().enumerate() {
        if let Some((before, [own, ..])) = side.split_at_mut_checked(k) {
            *own -= row.iter().zip(before).fold(F::zero(), |sum, (x, y)| sum + *x * *y);
        }
    }
    let count = rows.len();
    for (k, row) in rows.iter().enumerate().rev() {
        if let Some(([own, after @ ..], [diagonal, factors @ ..])) =
            side.get_mut(k..count).zip(row.get(k..count))
        {
            let sum = factors.iter().zip(after).fold(F::zero(), |sum, (x, y)| sum + *x * *y);
            *own = (*own - sum) / *diagonal;
        }
    }
}

/// `(2/3) π p₀ a b` of an ellipse whose deflection at its centre is `δ = (p₀/E*) s K`.
pub(crate) fn elliptic_load<F: Float>(a: F, b: F, modulus: F, approach: F) -> F {
    let (short, long) = (a.min(b), a.max(b));
    let k = crate::contact::elliptic::Integrals::at(short / long).k();
    (modulus * approach / k * long).times(2.0 / 3.0 * PI)
}
