//! The normal problem on strips of one width: pressure and outline of a patch under a load or an approach.
//!
//! The bodies are half-spaces that are `h(y) + x²/(2 R)` apart. A strip's pressure is a half-ellipse over its length
//! `2 a_i`, its peak `p_i`; both are found from two conditions on its middle line, with the sums of [`influence`] over
//! all strips of all zones:
//!
//! ```text
//! u_i = Σ_j A_ij a_j p_j/(π E*) = δ − h_i        the bodies touch               (linear in p, p ≥ 0)
//! −∂²u_i/∂x² = Σ_j C_ij p_j/(a_j π E*) = 1/R     and keep touching along x      (gives a)
//! ```
//!
//! The first is solved directly for given lengths. Strips that would pull leave, strips whose bodies would
//! overlap enter, until none does either. The second then corrects the lengths: on a long strip its left-hand side goes with
//! `1/a²`, so that a step takes the root of what is wrong with it. A strip at the rim ends with `p → 0` and `a → 0`
//! together; so zones appear, grow, touch and merge without a jump. Nothing else distinguishes them.

use crate::number::{Arithmetic, Float, Plain, Real};
use crate::patch::influence;
use core::f64::consts::{FRAC_PI_2, PI};
use heapless::Vec;

/// Strips of the normal problem at most.
pub const CELLS: usize = if cfg!(target_os = "none") { 24 } else { 48 };
/// Rounds in which strips leave and enter, at most; two to four are usual.
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

/// A strip of the normal problem.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cell<T: Real> {
    /// Its number on the lattice: neighbours have neighbouring ones.
    pub place: i32,
    /// Undeformed distance on its middle line \[m\].
    pub distance: T::Base,
    /// Half length \[m\].
    pub half_length: T,
    /// Peak pressure \[Pa\]; zero where the bodies do not touch.
    pub pressure: T,
}

impl<T: Real> Cell<T> {
    pub(crate) fn new(place: i32, distance: T::Base) -> Self {
        Self { place, distance, half_length: T::zero(), pressure: T::zero() }
    }

    pub(crate) fn is_loaded(&self) -> bool {
        self.pressure > T::zero()
    }
}

/// Strips of one width, ascending.
#[derive(Clone, Debug)]
pub(crate) struct Cells<T: Real> {
    pub list: Vec<Cell<T>, CELLS>,
    /// Width of a strip \[m\].
    pub width: T::Base,
    /// `R` \[m\]
    pub rolling_radius: T::Base,
    /// `E* = G/(1 − ν)` \[Pa\]
    pub modulus: T::Base,
}

/// A row of the equations for the pressures, with two right-hand sides: one, and the distance.
struct Row<T> {
    factors: [T; CELLS],
    one: T,
    distance: T,
}

/// Influence of one strip on all: `a A_ij/(π E*)` and `C_ij/(a π E*)`.
struct Column<T> {
    deflection: [T; CELLS],
    curvature: [T; CELLS],
}

impl<T: Real> Cells<T> {
    /// Lengths to begin with: sections of the undeformed bodies at a share of the approach, where `known` tells nothing
    /// better (squares of half lengths at the strips' places).
    pub(crate) fn begin(&mut self, approach: T, known: impl Fn(i32, T::Base) -> T) {
        let double = self.rolling_radius.times(2.0);
        for cell in &mut self.list {
            let least = approach.scale(double).times(LEAST_SQUARE);
            cell.half_length = known(cell.place, cell.distance).max(least).sqrt();
        }
    }

    /// The pressures after so many corrections of the lengths; the approach.
    pub(crate) fn solve(&mut self, given: Given<T>, steps: usize) -> T {
        for _ in 0..steps {
            let columns = self.columns();
            self.press(given, &columns);
            self.correct(&columns);
        }
        let columns = self.columns();
        self.press(given, &columns)
    }

    /// `(π/2) a w`: load of a strip over its peak pressure.
    fn share(&self, cell: &Cell<T>) -> T {
        cell.half_length.scale(self.width).times(FRAC_PI_2)
    }

    pub(crate) fn load(&self) -> T {
        self.list.iter().fold(T::zero(), |sum, cell| sum + self.share(cell) * cell.pressure)
    }

    #[inline(never)]
    fn columns(&self) -> Vec<Column<T>, CELLS> {
        let mut columns = Vec::new();
        let scale = T::Base::one() / self.modulus.times(PI);
        let places = || self.list.iter().map(|cell| cell.place);
        let (first, last) = (places().next().unwrap_or(0), places().last().unwrap_or(0));
        for cell in &self.list {
            let unit = T::from_base(self.width) / cell.half_length;
            let at = |distance: i32| {
                influence::edge(unit.scale(T::Base::of(f64::from(distance) + 0.5)))
            };
            // edges at the distances that neighbours have
            let farthest = (cell.place - first).max(last - cell.place);
            let mut edges = [[T::zero(); 2]; CELLS];
            for (distance, edge) in (0..=farthest).zip(&mut edges) {
                *edge = at(distance);
            }
            let edge = |distance: i32| match usize::try_from(distance).map(|i| edges.get(i)) {
                Ok(Some(edge)) => *edge,
                _ => at(distance),
            };
            let mut column = Column { deflection: [T::zero(); CELLS], curvature: [T::zero(); CELLS] };
            let both = column.deflection.iter_mut().zip(&mut column.curvature);
            for (other, (deflection, curvature)) in self.list.iter().zip(both) {
                let distance = (other.place - cell.place).abs();
                let [[near_a, near_c], [far_a, far_c]] = if distance == 0 {
                    let [a, c] = edge(0);
                    [[-a, -c], [a, c]]
                } else {
                    [edge(distance - 1), edge(distance)]
                };
                *deflection = (far_a - near_a).scale(scale) * cell.half_length;
                *curvature = (far_c - near_c).scale(scale) / cell.half_length;
            }
            // (as many columns as cells)
            let _ = columns.push(column);
        }
        columns
    }

    /// Pressures for the lengths as they are; the approach.
    #[inline(never)]
    fn press(&mut self, given: Given<T>, columns: &[Column<T>]) -> T {
        let mut loaded = [true; CELLS];
        let mut approach = T::zero();
        for _ in 0..ROUNDS {
            let mut rows: Vec<Row<T>, CELLS> = Vec::new();
            for (i, cell) in self.list.iter().enumerate().filter(|(i, _)| is(&loaded, *i)) {
                let mut factors = [T::zero(); CELLS];
                let active = columns.iter().enumerate().filter(|(j, _)| is(&loaded, *j));
                for (factor, (_, column)) in factors.iter_mut().zip(active) {
                    *factor = column.deflection.get(i).copied().unwrap_or(T::zero());
                }
                let distance = T::from_base(cell.distance);
                let _ = rows.push(Row { factors, one: T::one(), distance });
            }
            solve(&mut rows);
            // p = δ X − Y
            let mut found = rows.iter();
            let (mut by_approach, mut without) = (T::zero(), T::zero());
            let mut solved = [[T::zero(); 2]; CELLS];
            for ((i, cell), solved) in self.list.iter().enumerate().zip(&mut solved) {
                if is(&loaded, i)
                    && let Some(row) = found.next()
                {
                    let share = self.share(cell);
                    by_approach += share * row.one;
                    without += share * row.distance;
                    *solved = [row.one, row.distance];
                }
            }
            approach = match given {
                Given::Load(load) => (load + without) / by_approach,
                Given::Approach(approach) => approach,
            };
            for (cell, [one, distance]) in self.list.iter_mut().zip(solved) {
                cell.pressure = approach * one - distance;
            }
            let mut deflection = [T::zero(); CELLS];
            for (column, cell) in columns.iter().zip(&self.list) {
                for (sum, part) in deflection.iter_mut().zip(&column.deflection) {
                    *sum += *part * cell.pressure;
                }
            }
            let mut changed = false;
            for ((cell, sum), loaded) in self.list.iter().zip(deflection).zip(&mut loaded) {
                let stays = if *loaded {
                    cell.is_loaded()
                } else {
                    // the bodies would overlap
                    approach.shift(-cell.distance) > sum
                };
                changed |= stays != *loaded;
                *loaded = stays;
            }
            if !changed {
                break;
            }
        }
        for cell in &mut self.list {
            cell.pressure = cell.pressure.max(T::zero());
        }
        approach
    }

    /// Lengths for the pressures as they are.
    fn correct(&mut self, columns: &[Column<T>]) {
        let mut curvature = [T::zero(); CELLS];
        for (column, cell) in columns.iter().zip(&self.list) {
            for (sum, part) in curvature.iter_mut().zip(&column.curvature) {
                *sum += *part * cell.pressure;
            }
        }
        for (cell, curvature) in self.list.iter_mut().zip(curvature) {
            if cell.is_loaded() {
                // √c as its Padé approximant: within a factor of 3 whatever c is
                let c = curvature.scale(self.rolling_radius).max(T::zero());
                cell.half_length = cell.half_length * (c.times(3.0).plus(1.0) / c.plus(3.0));
            }
        }
    }
}

fn is(flags: &[bool; CELLS], i: usize) -> bool {
    flags.get(i).copied().unwrap_or(false)
}

/// Gauss's elimination without pivots: the diagonal is the largest of its row. The right-hand sides become the solutions.
fn solve<T: Real>(rows: &mut [Row<T>]) {
    let count = rows.len();
    let mut rest = &mut *rows;
    let mut k = 0;
    while let Some((pivot, below)) = rest.split_first_mut() {
        let inverse = pivot.factors.get(k).copied().unwrap_or(T::one()).inverse();
        for row in below.iter_mut() {
            let active = row.factors.iter_mut().zip(&pivot.factors).take(count).skip(k);
            let mut factor = None;
            for (own, above) in active {
                match factor {
                    None => factor = Some(*own * inverse),
                    Some(factor) => *own -= factor * *above,
                }
            }
            let factor = factor.unwrap_or(T::zero());
            row.one -= factor * pivot.one;
            row.distance -= factor * pivot.distance;
        }
        rest = below;
        k += 1;
    }
    let mut end = count;
    while let Some((last, above)) =
        rows.get_mut(..end).and_then(|rows| rows.split_last_mut())
    {
        end -= 1;
        let inverse = last.factors.get(end).copied().unwrap_or(T::one()).inverse();
        last.one = last.one * inverse;
        last.distance = last.distance * inverse;
        for row in above {
            let factor = row.factors.get(end).copied().unwrap_or(T::zero());
            row.one -= factor * last.one;
            row.distance -= factor * last.distance;
        }
    }
}

/// `(2/3) π p₀ a b` of an ellipse whose deflection at its centre is `δ = (p₀/E*) s K`.
pub(crate) fn elliptic_load<F: Float>(a: F, b: F, modulus: F, approach: F) -> F {
    let (short, long) = (a.min(b), a.max(b));
    let k = crate::contact::elliptic::Integrals::at(short / long).k();
    (modulus * approach / k * long).times(2.0 / 3.0 * PI)
}
