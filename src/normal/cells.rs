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
//! The first condition is solved by Newton's method for given lengths, with `p ≥ 0`. With the
//! compliance `c_i` of about a cell alone, `e_i = δ − h_i − u_i + c_i p_i/(π E*)` is about the
//! overlap without the cell's own pressure, and the condition is
//!
//! ```text
//! c_i p_i/(π E*) = S(e_i),   S(e) = 0 (e ≤ −t),   (e + t)²/(4 t),   e (e ≥ t)
//! ```
//!
//! `S` is the mean overlap of a cell over which the overlap varies by `±t`: the share
//! `S' = (e + t)/(2 t)` of it touches. So a cell begins to touch without a step in the stiffness.
//! Where every share is 0 or 1, Newton's method removes the cells that would pull and adds those
//! whose bodies would overlap, until neither happens. The second condition then corrects the
//! lengths. On a long cell its left-hand side goes with `1/a²`, so that a step
//! multiplies `a` by the root of the quotient of both sides, or by a little less where the
//! neighbours move as well.
//!
//! `h_i` is the mean of the distance over the inner part of the cell. The pressure of
//! a cell that the end of a zone cuts is coupled to that of its neighbour,
//! `u_i + κ (p_i − p_k) = δ − h_i` (`layout`).

pub use crate::normal::cell::CELLS;
pub(crate) use crate::normal::cell::Cells;
use crate::normal::cell_edges::{Across, CellEdges, stored};
use crate::normal::equations::Equations;
use crate::normal::influence::{Curvature, Deflection};
use crate::number::{Arithmetic, Dual, Float, Number, add, set_at};
use core::f64::consts::FRAC_PI_2;
use heapless::Vec;

/// Rounds that change all cells that should be; usually one or two. Later ones change the first.
const ROUNDS_FOR_ALL: usize = 12;
const SHARE_ROUNDS: usize = ROUNDS_FOR_ALL + 2 * CELLS;

/// What is given of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Given<F> {
    /// Normal force \[N\], not negative.
    Load(F),
    /// Approach of distant points of the two bodies \[m\]; none or a negative one is no contact.
    Approach(F),
}

impl<F> Given<F> {
    pub(crate) fn number(self) -> F {
        let (Self::Load(value) | Self::Approach(value)) = self;
        value
    }
}

/// Pressures `p/(π E*)` for given shares of the cells that touch.
struct Pressures<F> {
    /// Numbers of the cells that touch.
    touching: Vec<usize, CELLS>,
    /// Of all cells; zero where they do not touch.
    values: [F; CELLS],
    /// Approach `δ` \[m\].
    approach: F,
    /// Derivatives of the pressures with respect to the approach \[1/m\].
    by_approach: [F; CELLS],
    /// `Σ a w dp/dδ/(π E*)` \[m\].
    load_by_approach: F,
}

impl<F: Float, const N: usize> Cells<F, N> {
    /// Fills in what follows from the places; `of` gives distance, rolling radius and half length
    /// of each, and whether it may touch, and `centre_x` the centre.
    pub(super) fn set_gaps(
        &mut self, of: impl Fn([Dual<F, N>; 2]) -> ([Dual<F, N>; 3], F),
        centre_x: impl Fn(Dual<F, N>) -> Dual<F, N>,
    ) {
        for cell in self.list.iter_mut() {
            let ([distance, rolling_radius, half_length], touches) = of([cell.at, cell.over]);
            (cell.distance, cell.rolling_radius) = (distance, rolling_radius);
            (cell.half_length, cell.touches) = (half_length, touches);
            cell.centre_x = centre_x(cell.y);
        }
    }

    /// Finds the pressures for the present lengths and a given load `N/(π E*)` or approach; returns
    /// the approach. Where there is room for the derivatives of the influence in no direction, they
    /// are computed when the pressures are known: four directions would take most of the stack.
    /// `partly` is the `t` within which a cell touches in part \[m\].
    #[inline(never)]
    pub(crate) fn press<const STORED: usize>(
        &mut self, equations: &mut Equations<F, STORED>, partly: Dual<F, N>,
        given: Given<Dual<F, N>>,
    ) -> Dual<F, N> {
        self.set_influence(equations);
        self.begin_touching();
        let mut round = 0;
        let solved = loop {
            let solved = self.solve_touching(equations, partly.value, given);
            if !self.correct_shares(equations, &solved, partly.value, round) {
                break solved;
            }
            round += 1;
        };
        if STORED < N {
            self.add_slopes(equations, &solved.values);
        }
        let approach = self.follow_slopes(equations, &solved, partly, given);
        if STORED < N {
            // past the last cell the influence is zero
            equations.clear_influence();
        }
        for cell in self.list.iter_mut() {
            if !(cell.touches > F::zero() && cell.pressure.value > F::zero()) {
                cell.pressure = Dual::zero();
            }
        }
        approach
    }

    /// Sets how far the pressure of each cell deflects all cells, and the couplings.
    fn set_influence<const STORED: usize>(&self, equations: &mut Equations<F, STORED>) {
        equations.make_room(self.list.len());
        let mut across = Across::<F, STORED>::new();
        for (j, cell) in self.list.iter().enumerate() {
            across.measure::<Deflection, N>(&CellEdges::new(cell), &self.list);
            let half_length = stored(cell.half_length);
            let entries = across.differences().map(|difference| difference * half_length);
            equations.set_column(j, entries);
        }
        for (i, cell) in self.list.iter().enumerate() {
            let [before, after] = cell.coupling;
            for (kappa, k) in [(before, i.wrapping_sub(1)), (after, i + 1), (cell.alone, CELLS)] {
                equations.add_coupling(i, k, stored(kappa));
            }
        }
    }

    /// Lets the cell of the least distance touch if none does: coarse cells may all begin beyond
    /// the reach of their zone.
    fn begin_touching(&mut self) {
        if self.list.iter().any(|cell| cell.touches > F::zero()) {
            return;
        }
        let least = self.list.iter_mut().reduce(|least, cell| {
            if cell.distance.value < least.distance.value { cell } else { least }
        });
        if let Some(cell) = least {
            cell.touches = F::one();
        }
    }

    /// Solves for the pressures of the cells that touch, for their present shares.
    fn solve_touching<const STORED: usize>(
        &self, equations: &mut Equations<F, STORED>, partly: F, given: Given<Dual<F, N>>,
    ) -> Pressures<F> {
        let mut touching = Vec::new();
        let mut sides = [[F::zero(); CELLS]; 2];
        let [one, distance] = &mut sides;
        for (i, cell) in self.list.iter().enumerate() {
            if cell.touches > F::zero() {
                let _ = touching.push(i);
                equations.soften(i, cell.compliance().value * cell.softness());
                set_at(one, i, F::one());
                let rest = partly * (F::one() - cell.touches);
                set_at(distance, i, cell.distance.value - rest);
            }
        }
        equations.solve(&touching, &mut sides);
        let [by_approach, without] = sides;
        // p = δ X − Y
        let (mut load_by_approach, mut missing) = (F::zero(), F::zero());
        for ((cell, one), distance) in self.list.iter().zip(by_approach).zip(without) {
            let area = cell.half_length.value * cell.width.value;
            load_by_approach += area * one;
            missing += area * distance;
        }
        let approach = match given {
            Given::Load(load) => (load.value.times(1.0 / FRAC_PI_2) + missing) / load_by_approach,
            Given::Approach(approach) => approach.value,
        };
        let mut values = [F::zero(); CELLS];
        for ((p, one), distance) in values.iter_mut().zip(by_approach).zip(without) {
            *p = approach * one - distance;
        }
        Pressures { touching, values, approach, by_approach, load_by_approach }
    }

    /// Sets the pressures and corrects the shares of cells that touch, all at once in early rounds,
    /// and then the first that is wrong. Returns whether the pressures must be solved for again.
    fn correct_shares<const STORED: usize>(
        &mut self, equations: &Equations<F, STORED>, solved: &Pressures<F>, partly: F, round: usize,
    ) -> bool {
        let Pressures { values, approach, .. } = solved;
        let is_last = round + 1 >= SHARE_ROUNDS;
        let mut changed = false;
        for (i, (cell, p)) in self.list.iter_mut().zip(values).enumerate() {
            cell.pressure.value = *p;
            let overlap = if cell.touches > F::zero() {
                let rest = partly * (F::one() - cell.touches);
                cell.compliance().value / cell.touches * *p - rest
            } else {
                *approach - cell.distance.value - equations.deflection(i, values)
            };
            let touches = share_that_touches(overlap, partly);
            // an error of a share has its square as an error of the pressure
            let differs = (touches - cell.touches).abs() > F::EPSILON.sqrt();
            if differs && !is_last && (round < ROUNDS_FOR_ALL || !changed) {
                changed = true;
                cell.touches = touches;
            }
        }
        changed
    }

    /// Sets the derivatives of the pressures; returns the approach with its own.
    ///
    /// ```text
    /// (A + c (1/S' − 1)) dp = dδ − dh − dA p + (1 − S') dt − dc (1/S' − 1) p
    /// ```
    fn follow_slopes<const STORED: usize>(
        &mut self, equations: &Equations<F, STORED>, solved: &Pressures<F>, partly: Dual<F, N>,
        given: Given<Dual<F, N>>,
    ) -> Dual<F, N> {
        let mut slopes = [F::zero(); N];
        for (d, slope) in slopes.iter_mut().enumerate() {
            let of = |number: &Dual<F, N>| number.derivative(d);
            let mut rest = [F::zero(); CELLS];
            for (rest, cell) in rest.iter_mut().zip(self.list.iter()) {
                let gap = of(&partly) * (F::one() - cell.touches);
                let softer = cell.pressure.value * cell.softness() * of(&cell.compliance());
                *rest = gap - softer - of(&cell.distance);
            }
            equations.solve_for_slopes(d, &solved.touching, &solved.values, &mut rest);
            let mut carried = F::zero();
            for (cell, rest) in self.list.iter().zip(rest) {
                let area = cell.half_length * cell.width;
                carried += of(&area) * cell.pressure.value + area.value * rest;
            }
            *slope = match given {
                Given::Load(load) => {
                    (of(&load).times(1.0 / FRAC_PI_2) - carried) / solved.load_by_approach
                }
                Given::Approach(approach) => of(&approach),
            };
            for ((cell, one), rest) in self.list.iter_mut().zip(solved.by_approach).zip(rest) {
                cell.pressure.set_derivative(d, *slope * one + rest);
            }
        }
        Dual { value: solved.approach, gradient: slopes }
    }

    /// Computes `dA p` of all directions. Its sums replace the influence.
    #[inline(never)]
    fn add_slopes<const STORED: usize>(
        &self, equations: &mut Equations<F, STORED>, pressures: &[F; CELLS],
    ) {
        const { assert!(4 * N <= CELLS) };
        equations.clear_influence();
        let mut across = Across::<F, N>::new();
        let pressed = self.list.iter().zip(pressures).enumerate();
        for (j, (cell, pressure)) in pressed.filter(|(_, (_, p))| **p != F::zero()) {
            across.measure::<Deflection, N>(&CellEdges::new(cell), &self.list);
            for ((i, own), difference) in self.list.iter().enumerate().zip(across.differences()) {
                let mut entry = difference * cell.half_length;
                let [before, after] = own.coupling;
                if i == j {
                    entry = entry + before + after + own.alone;
                } else if i == j + 1 {
                    entry -= before;
                } else if i + 1 == j {
                    entry -= after;
                }
                equations.add_slopes(i, j, &entry.gradient, *pressure);
            }
        }
    }

    /// Corrects the lengths for the present pressures, by a power of the quotient of both sides of
    /// the second condition; also those of cells that do not touch, as if they were about to.
    #[inline(never)]
    pub(crate) fn correct(&mut self, power: Dual<F, N>) {
        let (less, more) = (Dual::one() - power, Dual::one() + power);
        let mut curvatures = [Dual::zero(); CELLS];
        let mut across = Across::new();
        for cell in self.list.iter().filter(|cell| cell.touches > F::zero()) {
            let share = cell.pressure / cell.half_length;
            across.measure::<Curvature, N>(&CellEdges::new(cell), &self.list);
            add(&mut curvatures, across.differences().map(|difference| difference * share));
        }
        for (cell, curvature) in self.list.iter_mut().zip(curvatures) {
            // the Padé approximant of the power of c keeps the correction within a factor of 4
            let c = (curvature * cell.rolling_radius).max(Dual::zero());
            cell.half_length = cell.half_length * ((c * more + less) / (c * less + more));
        }
    }
}

/// The share `S'` of a cell in which the bodies touch.
fn share_that_touches<F: Float>(overlap: F, partly: F) -> F {
    let share = (overlap / partly + F::one()).times(0.5).min(F::one());
    if share > F::EPSILON.sqrt() { share } else { F::zero() }
}
