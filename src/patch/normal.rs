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
use crate::patch::influence::{CURVATURE, DEFLECTION};
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
    rolling_radius: F,
    /// `1/(π E*)`, `E* = G/(1 − ν)` \[1/Pa\]
    scale: F,
    /// `ln (d + 1/2)`
    logs: [F; CELLS],
}

/// Equations for the pressures of the strips that touch.
type Rows<'a, F> = Vec<&'a mut [F; CELLS], CELLS>;

impl<F: Float> Cells<F> {
    /// No strips yet; `R` \[m\], `E*` \[Pa\].
    pub(crate) fn new(rolling_radius: F, modulus: F) -> Self {
        let mut logs = [F::zero(); CELLS];
        for (distance, log) in (0_u16..).zip(&mut logs) {
            *log = F::widened(f32::from(distance)).plus(0.5).ln();
        }
        let scale = F::one() / modulus.times(PI);
        Self { list: Vec::new(), width: F::one(), rolling_radius, scale, logs }
    }

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

    /// The pressures after one correction of the lengths by a power `q` of what is wrong with them; the approach.
    pub(crate) fn solve(&mut self, given: Given<F>, power: F) -> Moving<F> {
        self.press(given);
        self.correct(power);
        self.press(given)
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

    /// What every strip that touches does to each strip: the differences of `of` between its edges, handed to `take` with the
    /// number of the strip, the number among those that touch of the one that acts, and that one.
    fn around<const N: usize>(
        &self,
        of: impl Fn(F, F) -> [F; N],
        mut take: impl FnMut(usize, usize, &Cell<F>, [F; N]),
    ) {
        for (j, cell) in self.touching().enumerate() {
            let unit = self.width / cell.half_length.value;
            let log = unit.ln();
            let at = |distance: u32| {
                let edge = F::widened(distance as f32).plus(0.5);
                let known = self.logs.get(distance as usize).copied();
                of(unit * edge, log + known.unwrap_or_else(|| edge.ln()))
            };
            // edges at the distances that neighbours have
            let ends = [self.list.first(), self.list.last()].into_iter().flatten();
            let farthest = ends.fold(0, |most, end| most.max(end.place.abs_diff(cell.place)));
            let mut edges = [[F::zero(); N]; CELLS];
            for (distance, edge) in (0..=farthest).zip(&mut edges) {
                *edge = at(distance);
            }
            let edge = |distance: u32| match edges.get(distance as usize) {
                Some(edge) => *edge,
                None => at(distance),
            };
            for (i, other) in self.list.iter().enumerate() {
                let distance = other.place.abs_diff(cell.place);
                let far = edge(distance);
                // all are odd
                let near = distance.checked_sub(1).map_or(far.map(|far| -far), edge);
                let mut found = far;
                each(&mut found, near, |far, near| far - near);
                take(i, j, cell, found);
            }
        }
    }

    /// Pressures for the lengths as they are; the approach.
    #[inline(never)]
    fn press(&mut self, given: Given<F>) -> Moving<F> {
        let unit = self.width.times(FRAC_PI_2);
        let mut approach = Moving { value: F::zero(), slope: F::zero() };
        for _ in 0..ROUNDS {
            // a_j A_ij/(π E*)
            let mut all = [[F::zero(); CELLS]; CELLS];
            self.around(
                |t, log| {
                    let [deflection, _] = DEFLECTION.at(t, log);
                    [deflection]
                },
                |i, j, cell, [deflection]| {
                    if let Some(factor) = all.get_mut(i).and_then(|row| row.get_mut(j)) {
                        *factor = deflection * self.scale * cell.half_length.value;
                    }
                },
            );
            let (mut rows, mut apart) = (Rows::new(), Rows::new());
            let (mut one, mut distance) = ([F::zero(); CELLS], [F::zero(); CELLS]);
            let mut sides = one.iter_mut().zip(&mut distance);
            for (row, cell) in all.iter_mut().zip(&self.list) {
                if !cell.touches {
                    let _ = apart.push(row);
                } else if let Some((one, distance)) = sides.next() {
                    (*one, *distance) = (F::one(), cell.distance);
                    let _ = rows.push(row);
                }
            }
            factorise(&mut rows);
            substitute(&rows, &mut one);
            substitute(&rows, &mut distance);
            // p = δ X − Y
            let (mut by_approach, mut without) = (F::zero(), F::zero());
            for ((cell, one), distance) in self.touching().zip(one).zip(distance) {
                by_approach += unit * cell.half_length.value * one;
                without += unit * cell.half_length.value * distance;
            }
            approach.value = match given {
                Given::Load(load) => (load + without) / by_approach,
                Given::Approach(approach) => approach,
            };
            let mut pressures = [F::zero(); CELLS];
            each(&mut pressures, one, |_, one| approach.value * one);
            each(&mut pressures, distance, |pressed, distance| pressed - distance);
            let (mut solved, mut apart) = (pressures.iter(), apart.iter());
            let mut changed = false;
            for cell in &mut self.list {
                let pressure = if cell.touches { solved.next() } else { None };
                cell.pressure.value = pressure.copied().unwrap_or(F::zero());
                let stays = match pressure {
                    Some(pressure) => *pressure > F::zero(),
                    // the bodies would overlap
                    None => apart.next().is_some_and(|row| {
                        approach.value - cell.distance > product(row.as_slice(), &pressures)
                    }),
                };
                changed |= stays != cell.touches;
                cell.touches = stays;
            }
            if changed {
                continue;
            }
            // K dp = dδ − dK p, d(a A)/da = A − t A'
            let mut moved = [F::zero(); CELLS];
            self.around(
                |t, log| {
                    let [deflection, slope] = DEFLECTION.at(t, log);
                    [deflection - slope]
                },
                |i, _, cell, [change]| {
                    if let Some(moved) = moved.get_mut(i) {
                        *moved +=
                            change * self.scale * (cell.half_length.slope * cell.pressure.value);
                    }
                },
            );
            let mut change = [F::zero(); CELLS];
            let of_touching = moved.iter().zip(&self.list).filter(|(_, cell)| cell.touches);
            for ((moved, _), change) in of_touching.zip(&mut change) {
                *change = -*moved;
            }
            substitute(&rows, &mut change);
            let mut rest = F::zero();
            for (cell, change) in self.touching().zip(change) {
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

    fn touching(&self) -> impl Iterator<Item = &Cell<F>> {
        self.list.iter().filter(|cell| cell.touches)
    }

    /// Lengths for the pressures as they are; also of strips that do not touch, as if they were about to.
    fn correct(&mut self, power: F) {
        let (less, more) = (F::one() - power, F::one() + power);
        let radius = self.rolling_radius;
        // Σ C_ij p_j/(a_j π E*) and what it moves with the approach
        let mut curvatures = [Moving { value: F::zero(), slope: F::zero() }; CELLS];
        self.around(
            |t, log| CURVATURE.at(t, log),
            |i, _, cell, [curvature, change]| {
                let inverse = self.scale / cell.half_length.value;
                let (p, slope) = (cell.pressure, cell.half_length.slope / cell.half_length.value);
                if let Some(sum) = curvatures.get_mut(i) {
                    sum.value += curvature * (p.value * inverse);
                    sum.slope += (curvature * (p.slope - p.value * slope)
                        - change * (p.value * slope))
                        * inverse;
                }
            },
        );
        for (cell, curvature) in self.list.iter_mut().zip(curvatures) {
            // the power of c as its Padé approximant: within a factor of 3 whatever c is
            let c = (curvature.value * radius).max(F::zero());
            let below = c * less + more;
            let factor = (c * more + less) / below;
            let slope = curvature.slope * radius * power.times(4.0) / (below * below);
            let Moving { value: a, slope: da } = cell.half_length;
            cell.half_length = Moving { value: a * factor, slope: da * factor + a * slope };
        }
    }
}

/// `by` of each and its partner.
fn each<F: Float, const N: usize>(list: &mut [F; N], other: [F; N], by: impl Fn(F, F) -> F) {
    for (own, other) in list.iter_mut().zip(other) {
        *own = by(*own, other);
    }
}

/// `Σ x_i y_i`
fn product<F: Float>(x: &[F], y: &[F]) -> F {
    x.iter().zip(y).fold(F::zero(), |sum, (x, y)| sum + *x * *y)
}

/// Gauss's elimination without pivots: the diagonal is the largest of its row. Below it stand the factors.
fn factorise<F: Float>(rows: &mut Rows<'_, F>) {
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
fn substitute<F: Float>(rows: &Rows<'_, F>, side: &mut [F; CELLS]) {
    for (k, row) in rows.iter().enumerate() {
        if let Some((before, [own, ..])) = side.split_at_mut_checked(k) {
            *own -= product(row.as_slice(), before);
        }
    }
    let count = rows.len();
    for (k, row) in rows.iter().enumerate().rev() {
        if let Some(([own, after @ ..], [diagonal, factors @ ..])) =
            side.get_mut(k..count).zip(row.get(k..count))
        {
            let sum = product(factors, after);
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
