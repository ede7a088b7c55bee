//! The kernel's tables in the precision of the caller, which the compiler computes from the
//! constants.

use super::constants::{CELLS, NODE, NODES, PLACES, WEIGHTS};
use super::nodes::{HALF_OF_4, HALF_OF_8, HALF_OF_16, HALF_OF_32, HALF_OF_64};
use crate::contact::totals::StripCount;
use crate::number::tables::table;
use crate::number::{Arithmetic, Float};

/// A node of the slip part, for both kinds of strips side by side.
#[derive(Clone, Copy, Debug)]
pub(super) struct TableNode<B> {
    /// `t = τ/s`
    pub place: B,
    /// `t₀ − t`, with `t₀` of the node before it.
    pub length: B,
    /// `1/t`
    pub inverse_place: B,
    /// Softening, divided by `(σ s)²`.
    pub soft: B,
    /// Weight, divided by `u²`: a cubic in `u`.
    pub weight: [B; 4],
}

/// Share of the integrals over a strip that the nodes do not sum: polynomials in `u`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Closed<B> {
    /// `(1 − s/4 − Σ W/s)/(1 − u)`
    pub force: [B; 4],
    /// `(Σ W x̂/s)/(1 − u)`
    pub moment: [B; 5],
}

const NODE_FIELDS: usize = 8;
const CLOSED_FIELDS: usize = 9;
/// A number for the outermost strip and every second one, and one for the others.
type Couple<F> = [F; 2];

/// The kernel's constants for strips side by side.
pub(super) trait Constants<B> {
    /// Node `k`, counted from the separatrix.
    fn node(&self, k: usize) -> TableNode<B>;
    fn closed(&self) -> Closed<B>;
}

/// The tables; `read` converts their numbers to those of the strips.
#[derive(Clone, Copy)]
pub(super) struct Tables<F: 'static, R> {
    nodes: &'static [[Couple<F>; NODE_FIELDS]],
    closed: &'static [Couple<F>; CLOSED_FIELDS],
    read: R,
}

impl<F: Float, R> Tables<F, R> {
    pub fn new(read: R) -> Self {
        let nodes = table!(F, NODE_TABLE).as_chunks().0;
        Self { nodes, closed: table!(F, closed_table()), read }
    }
}

impl<F: Float, B: Arithmetic, R: Fn(&Couple<F>) -> B> Constants<B> for Tables<F, R> {
    #[inline(always)]
    fn node(&self, k: usize) -> TableNode<B> {
        let Self { nodes, read, .. } = self;
        let zero = B::zero();
        let Some([place, length, inverse_place, soft, a, b, c, d]) = nodes.get(k) else {
            return TableNode {
                place: zero,
                length: zero,
                inverse_place: zero,
                soft: zero,
                weight: [zero; 4],
            };
        };
        TableNode {
            place: read(place),
            length: read(length),
            inverse_place: read(inverse_place),
            soft: read(soft),
            weight: [read(a), read(b), read(c), read(d)],
        }
    }
    #[inline(always)]
    fn closed(&self) -> Closed<B> {
        let Self { closed: [a, b, c, d, e, f, g, h, i], read, .. } = self;
        let force = [read(a), read(b), read(c), read(d)];
        Closed { force, moment: [read(e), read(f), read(g), read(h), read(i)] }
    }
}

#[allow(clippy::indexing_slicing)]
const NODE_TABLE: [Couple<f64>; NODE_FIELDS * NODES] = {
    let mut table = [[0.0; 2]; NODE_FIELDS * NODES];
    let mut kind = 0;
    while kind < 2 {
        let mut before = 1.0;
        let mut k = 0;
        while k < NODES {
            let place = PLACES[kind][k];
            let cell = CELLS[kind][k] * (before - place);
            table[NODE_FIELDS * k][kind] = place;
            table[NODE_FIELDS * k + 1][kind] = before - place;
            table[NODE_FIELDS * k + 2][kind] = 1.0 / place;
            table[NODE_FIELDS * k + 3][kind] = 4.0 * NODE * cell * cell;
            let mut p = 0;
            while p < 4 {
                table[NODE_FIELDS * k + 4 + p][kind] = WEIGHTS[kind][k][p];
                p += 1;
            }
            before = place;
            k += 1;
        }
        kind += 1;
    }
    table
};

/// Both polynomials have the factor `1 − u`, of which the quotient's coefficients are the partial
/// sums.
#[allow(clippy::indexing_slicing)]
const fn closed_table() -> [Couple<f64>; CLOSED_FIELDS] {
    let mut table = [[0.0; 2]; CLOSED_FIELDS];
    let mut kind = 0;
    while kind < 2 {
        // 1 − u/2 − Σ W/(2 u) and Σ W (2 u t − 1)/(2 u), W = u² (c₀ + c₁ u + …)
        let mut force = [1.0, -0.5, 0.0, 0.0, 0.0];
        let mut moment = [0.0; 6];
        let mut k = 0;
        while k < NODES {
            let mut p = 0;
            while p < 4 {
                let c = WEIGHTS[kind][k][p] / 2.0;
                force[p + 1] -= c;
                moment[p + 1] -= c;
                moment[p + 2] += 2.0 * PLACES[kind][k] * c;
                p += 1;
            }
            k += 1;
        }
        let (mut sum, mut i) = (0.0, 0);
        while i < 4 {
            sum += force[i];
            table[i][kind] = sum;
            i += 1;
        }
        (sum, i) = (0.0, 0);
        while i < 5 {
            sum += moment[i];
            table[4 + i][kind] = sum;
            i += 1;
        }
        kind += 1;
    }
    table
}

/// Four strips of the Hertz ellipse: numbers for the outer and the inner one of two neighbours at
/// `Y > 0`. Those at `−Y` have the same, but for the sign of `y`, `bend` and `load_y`.
pub(super) const STRIP_FIELDS: usize = 8;
pub(super) type FourStrips<F> = [Couple<F>; STRIP_FIELDS];

/// The half of a rule with `Y > 0`, ascending: `Y`, `C`, width.
pub(super) type HalfRule = [[f64; 3]];

/// Strips of the Hertz ellipse.
#[derive(Clone, Copy, Debug)]
pub struct Rule<F: 'static> {
    /// In fours; fields: `Y`, `1/C`, `(0.4 − Y²) Y`, the share of the friction bound `(3/4) C² ΔY`,
    /// share times `C`, share times `Y`, share of the area, `ΔY/C` of one of sixteen strips.
    pub(super) fours: &'static [FourStrips<F>],
    /// `(π/2)/Σ C ΔY`: makes the linear forces exact.
    pub stretch: F,
    /// `(π/8)/Σ C Y² ΔY`: makes the linear moment of spin exact.
    pub lever: F,
    count: StripCount,
}

impl<F: Float> Rule<F> {
    /// Where the strips lie.
    #[must_use]
    pub fn new(count: StripCount) -> Self {
        // All rules stand in one table: n/4 − 1 fours come before the n/4 of this rule.
        let fours = table!(F, FOURS).as_chunks().0;
        let factors = table!(F, FACTORS).get((count as usize).ilog2() as usize - 2);
        let [stretch, lever] = *factors.unwrap_or(&[F::one(); 2]);
        let n = count as usize / 4;
        Self { fours: fours.get(n - 1..2 * n - 1).unwrap_or_default(), stretch, lever, count }
    }

    /// `Y`, `C` and width of the strips, ascending in `Y`.
    pub fn places(&self) -> impl Iterator<Item = [F; 3]> {
        let n = self.count as usize / 2;
        let half = table!(F, HALVES).get(n - 2..2 * n - 2).unwrap_or_default();
        let lower = half.iter().rev().map(|[y, c, width]| [-*y, *c, *width]);
        lower.chain(half.iter().copied())
    }
}

/// The strips at `Y > 0` of all rules together.
const STRIPS: usize = 2 + 4 + 8 + 16 + 32;
const RULES: [&HalfRule; 5] = [&HALF_OF_4, &HALF_OF_8, &HALF_OF_16, &HALF_OF_32, &HALF_OF_64];

/// The halves of all rules, one after the other.
#[allow(clippy::indexing_slicing)]
const HALVES: [[f64; 3]; STRIPS] = {
    let mut halves = [[0.0; 3]; STRIPS];
    let (mut rule, mut i) = (0, 0);
    while i < STRIPS {
        rule += (i == 2 * RULES[rule].len() - 2) as usize;
        halves[i] = RULES[rule][i + 2 - RULES[rule].len()];
        i += 1;
    }
    halves
};

/// `[π/2/Σ C ΔY, π/8/Σ C Y² ΔY]` of all rules.
#[allow(clippy::indexing_slicing)]
const FACTORS: [[f64; 2]; RULES.len()] = {
    let mut factors = [[0.0; 2]; RULES.len()];
    let mut rule = 0;
    while rule < RULES.len() {
        let (mut area, mut lever, mut i) = (0.0, 0.0, 0);
        while i < RULES[rule].len() {
            let [y, c, width] = RULES[rule][i];
            area += 2.0 * width * c;
            lever += 2.0 * width * c * (y * y);
            i += 1;
        }
        factors[rule] = [core::f64::consts::FRAC_PI_2 / area, core::f64::consts::FRAC_PI_8 / lever];
        rule += 1;
    }
    factors
};

/// The fours of all rules, one after the other.
#[allow(clippy::indexing_slicing)]
const FOURS: [Couple<f64>; STRIP_FIELDS * STRIPS / 2] = {
    let mut fours = [[0.0; 2]; STRIP_FIELDS * STRIPS / 2];
    let (mut rule, mut i) = (0, 0);
    while i < STRIPS {
        rule += (i == 2 * RULES[rule].len() - 2) as usize;
        let [y, c, width] = HALVES[i];
        let area = core::f64::consts::FRAC_PI_2 / FACTORS[rule][0];
        let load = 0.75 * width * (c * c);
        let fields = [
            y,
            1.0 / c,
            (0.4 - y * y) * y,
            load,
            load * c,
            load * y,
            width * c / area,
            width / c * (RULES[rule].len() as f64 / 8.0),
        ];
        let mut k = 0;
        while k < STRIP_FIELDS {
            // The outermost strip is of the first kind.
            fours[STRIP_FIELDS * (i / 2) + k][1 - i % 2] = fields[k];
            k += 1;
        }
        i += 1;
    }
    fours
};
