//! The kernel's tables in the precision of the caller, worked out by the compiler from the constants.

use super::constants::{CELLS, NODE, NODES, PLACES, WEIGHTS};
use super::nodes::{HALF_OF_4, HALF_OF_8, HALF_OF_16, HALF_OF_32, HALF_OF_64};
use crate::contact::forces::StripCount;
use crate::number::{Float, Nodes};

/// A node of the slip part for the kinds of strips side by side.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node<B> {
    /// `t = τ/s`
    pub place: B,
    /// `t₀ − t`, with `t₀` of the node before it.
    pub length: B,
    /// `1/t`
    pub inverse_place: B,
    /// Softening over `(σ s)²`.
    pub soft: B,
    /// Weight over `u²`: a cubic in `u`.
    pub weight: [B; 4],
}

/// What the closed part of a strip leaves to the nodes: polynomials in `u`.
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
    /// Node `k` from the separatrix on.
    fn node(&self, k: usize) -> Node<B>;
    fn closed(&self) -> Closed<B>;
}

/// Those of the tables, of which `read` makes numbers for the strips.
#[derive(Clone, Copy)]
pub(super) struct Tables<F: 'static, R> {
    nodes: &'static [[Couple<F>; NODE_FIELDS]; NODES],
    closed: &'static [[Couple<F>; CLOSED_FIELDS]; 1],
    read: R,
}

impl<F: Float, R> Tables<F, R> {
    #[inline(always)]
    pub fn new(read: R) -> Self {
        Self {
            nodes: F::table(&NARROW_NODES, &NODE_TABLE),
            closed: F::table(&NARROW_CLOSED, &CLOSED_TABLE),
            read,
        }
    }
}

impl<F: Float, B, R: Fn(&Couple<F>) -> B> Constants<B> for Tables<F, R> {
    #[inline(always)]
    fn node(&self, k: usize) -> Node<B> {
        let Self { nodes, read, .. } = self;
        let [place, length, inverse_place, soft, a, b, c, d] = nodes.get(k).unwrap_or(&nodes[0]);
        Node {
            place: read(place),
            length: read(length),
            inverse_place: read(inverse_place),
            soft: read(soft),
            weight: [read(a), read(b), read(c), read(d)],
        }
    }
    #[inline(always)]
    fn closed(&self) -> Closed<B> {
        let Self { closed: [[a, b, c, d, e, f, g, h, i]], read, .. } = self;
        let force = [read(a), read(b), read(c), read(d)];
        Closed { force, moment: [read(e), read(f), read(g), read(h), read(i)] }
    }
}

#[allow(clippy::indexing_slicing)]
const fn node_table() -> [[Couple<f64>; NODE_FIELDS]; NODES] {
    let mut table = [[[0.0; 2]; NODE_FIELDS]; NODES];
    let mut kind = 0;
    while kind < 2 {
        let mut before = 1.0;
        let mut k = 0;
        while k < NODES {
            let place = PLACES[kind][k];
            let cell = CELLS[kind][k] * (before - place);
            table[k][0][kind] = place;
            table[k][1][kind] = before - place;
            table[k][2][kind] = 1.0 / place;
            table[k][3][kind] = 4.0 * NODE * cell * cell;
            let mut p = 0;
            while p < 4 {
                table[k][4 + p][kind] = WEIGHTS[kind][k][p];
                p += 1;
            }
            before = place;
            k += 1;
        }
        kind += 1;
    }
    table
}

/// Both polynomials have the factor `1 − u`, of which the quotient's coefficients are the partial sums.
#[allow(clippy::indexing_slicing)]
const fn closed_table() -> [[Couple<f64>; CLOSED_FIELDS]; 1] {
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
    [table]
}

static NODE_TABLE: [[Couple<f64>; NODE_FIELDS]; NODES] = node_table();
static NARROW_NODES: [[Couple<f32>; NODE_FIELDS]; NODES] = narrow(&NODE_TABLE);
static CLOSED_TABLE: [[Couple<f64>; CLOSED_FIELDS]; 1] = closed_table();
static NARROW_CLOSED: [[Couple<f32>; CLOSED_FIELDS]; 1] = narrow(&CLOSED_TABLE);

/// Four strips of the Hertz ellipse: numbers for the outer and the inner one of two neighbours at `Y > 0`. Those
/// at `−Y` have the same, but for the sign of `y`, `bend` and `load_y`.
pub(super) const STRIP_FIELDS: usize = 8;
pub(super) type FourStrips<F> = [Couple<F>; STRIP_FIELDS];

/// The half of a rule with `Y > 0`, ascending: `Y`, `C`, width.
pub(super) type Half = [[f64; 3]];

type Place<F> = [Couple<F>; 2];

/// Strips of the Hertz ellipse.
#[derive(Clone, Copy, Debug)]
pub struct Rule<F: 'static> {
    /// In fours; fields: `Y`, `1/C`, `(0.4 − Y²) Y`, the share of the friction bound `(3/4) C² ΔY`, share times `C`,
    /// share times `Y`, share of the area, `ΔY/C` of one of sixteen strips.
    pub(super) fours: &'static [FourStrips<F>],
    /// `(π/2)/Σ C ΔY`: makes the linear forces exact.
    pub stretch: F,
    /// `(π/8)/Σ C Y² ΔY`: makes the linear moment of spin exact.
    pub lever: F,
    /// Of those at `Y > 0`, ascending: `Y` and `C`, width and nothing.
    half: &'static [Place<F>],
}

impl<F: Float> Rule<F> {
    /// Where the strips lie.
    #[must_use]
    pub fn new(count: StripCount) -> Self {
        let (fours, factors): (&[FourStrips<F>], _) = match count {
            StripCount::Four => (F::table(&NARROW_4, &TABLE_4), &FACTORS_4),
            StripCount::Eight => (F::table(&NARROW_8, &TABLE_8), &FACTORS_8),
            StripCount::Sixteen => (F::table(&NARROW_16, &TABLE_16), &FACTORS_16),
            StripCount::ThirtyTwo => (F::table(&NARROW_32, &TABLE_32), &FACTORS_32),
            StripCount::SixtyFour => (F::table(&NARROW_64, &TABLE_64), &FACTORS_64),
        };
        let half: &[Place<F>] = match count {
            StripCount::Four => F::table(&NARROW_PLACES_4, &PLACES_4),
            StripCount::Eight => F::table(&NARROW_PLACES_8, &PLACES_8),
            StripCount::Sixteen => F::table(&NARROW_PLACES_16, &PLACES_16),
            StripCount::ThirtyTwo => F::table(&NARROW_PLACES_32, &PLACES_32),
            StripCount::SixtyFour => F::table(&NARROW_PLACES_64, &PLACES_64),
        };
        let [stretch, lever] = factors.of::<F>().next().unwrap_or([F::one(); 2]);
        Self { fours, stretch, lever, half }
    }

    /// `Y`, `C` and width of the strips, ascending in `Y`.
    pub fn places(&self) -> impl Iterator<Item = [F; 3]> {
        let lower = self.half.iter().rev().map(|[[y, c], [width, _]]| [-*y, *c, *width]);
        lower.chain(self.half.iter().map(|[[y, c], [width, _]]| [*y, *c, *width]))
    }
}

#[allow(clippy::indexing_slicing)]
const fn places<const H: usize>(half: &Half) -> [Place<f64>; H] {
    let mut places = [[[0.0; 2]; 2]; H];
    let mut i = 0;
    while i < H {
        let [y, c, width] = half[i];
        places[i] = [[y, c], [width, 0.0]];
        i += 1;
    }
    places
}

/// `[π/2/Σ C ΔY, π/8/Σ C Y² ΔY]`
#[allow(clippy::indexing_slicing)]
const fn factors(half: &Half) -> [f64; 2] {
    let (mut area, mut lever, mut i) = (0.0, 0.0, 0);
    while i < half.len() {
        let [y, c, width] = half[i];
        area += 2.0 * width * c;
        lever += 2.0 * width * c * (y * y);
        i += 1;
    }
    [core::f64::consts::FRAC_PI_2 / area, core::f64::consts::FRAC_PI_8 / lever]
}

#[allow(clippy::indexing_slicing)]
const fn fours<const N: usize>(half: &Half) -> [FourStrips<f64>; N] {
    let mut fours = [[[0.0; 2]; STRIP_FIELDS]; N];
    let area = core::f64::consts::FRAC_PI_2 / factors(half)[0];
    let mut i = 0;
    while i < half.len() {
        let [y, c, width] = half[i];
        let load = 0.75 * width * (c * c);
        // the outermost strip is of the first kind
        let (four, kind) = (i / 2, 1 - i % 2);
        let fields = [
            y,
            1.0 / c,
            (0.4 - y * y) * y,
            load,
            load * c,
            load * y,
            width * c / area,
            width / c * (half.len() as f64 / 8.0),
        ];
        let mut k = 0;
        while k < STRIP_FIELDS {
            fours[four][k][kind] = fields[k];
            k += 1;
        }
        i += 1;
    }
    fours
}

macro_rules! rule {
    ($count:literal, $table:ident, $narrow:ident, $factors:ident, $half:ident, $places:ident, $narrow_places:ident) => {
        static $table: [FourStrips<f64>; $count / 4] = fours(&$half);
        static $narrow: [FourStrips<f32>; $count / 4] = narrow(&$table);
        static $factors: Nodes<1> = Nodes::new([factors(&$half)]);
        static $places: [Place<f64>; $count / 2] = places(&$half);
        static $narrow_places: [Place<f32>; $count / 2] = narrow(&$places);
    };
}

rule!(4, TABLE_4, NARROW_4, FACTORS_4, HALF_OF_4, PLACES_4, NARROW_PLACES_4);
rule!(8, TABLE_8, NARROW_8, FACTORS_8, HALF_OF_8, PLACES_8, NARROW_PLACES_8);
rule!(16, TABLE_16, NARROW_16, FACTORS_16, HALF_OF_16, PLACES_16, NARROW_PLACES_16);
rule!(32, TABLE_32, NARROW_32, FACTORS_32, HALF_OF_32, PLACES_32, NARROW_PLACES_32);
rule!(64, TABLE_64, NARROW_64, FACTORS_64, HALF_OF_64, PLACES_64, NARROW_PLACES_64);

/// In single precision.
#[allow(clippy::indexing_slicing)]
pub(super) const fn narrow<const N: usize, const P: usize>(
    wide: &[[[f64; 2]; P]; N],
) -> [[[f32; 2]; P]; N] {
    let mut table = [[[0.0; 2]; P]; N];
    let mut i = 0;
    while i < N {
        let mut j = 0;
        while j < P {
            table[i][j] = [wide[i][j][0] as f32, wide[i][j][1] as f32];
            j += 1;
        }
        i += 1;
    }
    table
}
