//! An estimate of load and deflection for an approach, made before the normal problem is solved.
//! The overlap of the undeformed bodies gives the shape of the load, and the least energy its size.
//!
//! The load per width is `f q`, `q = (0.6 δ − h)₊`. With line loads that act at the distance
//! `√(d² + ε²)`, `ε` about a third of the half length, the deflection is `u = Σ f q w K/(π E*)`,
//! `K = [arsinh((d ± w/2)/ε)]/w`, and of all sizes
//!
//! ```text
//! N = f Σ q w,   f = π E* Σ q w (δ − h)/Σ q w K q w
//! ```
//!
//! has the least energy. This load is within 3 % of Hertz's for axis ratios of 0.13 to 8.

use crate::normal::cell::Cells;
use crate::normal::density::{MOST_ZONES, Zones};
use crate::normal::layout::{couple_parts, layout};
use crate::normal::smooth::SmoothedProfile;
use crate::number::avx::with_avx;
use crate::number::{Arithmetic, Dual, Float, Number, Strips};
use heapless::Vec;

/// Share of the approach by which shifted undeformed bodies overlap about where they touch.
pub(super) const OVERLAP: f64 = 0.6;
/// `ε/√(1.1 R δ)`
const BREADTH: f64 = 0.22;
/// Number of cells of the estimate of an ordinary contact, and of one with many lobes.
const LOADS: usize = 10;
const MOST_LOADS: usize = if cfg!(target_os = "none") { LOADS } else { 16 };

/// The load of an approach and its distribution.
#[derive(Clone, Debug)]
pub(super) struct Estimate<F, const N: usize> {
    /// `N/(π E*)` \[m²\]
    pub load: Dual<F, N>,
    /// Edges of the places, in fours.
    fours: Vec<FourEdges<F, N>, LOAD_FOURS>,
    breadth: Dual<F, N>,
}

/// The place of an edge, and what the load per width grows by there.
type LoadEdge<F, const N: usize> = (Dual<F, N>, Dual<F, N>);

/// Four edges of places side by side.
#[derive(Clone, Debug)]
struct FourEdges<F, const N: usize> {
    /// Where they are, and its derivatives \[m\].
    places: Dual<[F; 4], N>,
    /// What the load per width grows by there, `f q/(π E*)`, and its derivatives \[m\].
    growth: Dual<[F; 4], N>,
}

const LOAD_EDGES: usize = 2 * (MOST_LOADS + MOST_ZONES);
const LOAD_FOURS: usize = LOAD_EDGES.div_ceil(4);

impl<F: Float, const N: usize> Estimate<F, N> {
    /// The load alone. It stays out of line, so that the edges take room on the stack only here.
    #[inline(never)]
    pub fn load(
        curve: &SmoothedProfile<F, N>, approach: Dual<F, N>, radius: Dual<F, N>,
        cells: &mut Cells<F, N>,
    ) -> Dual<F, N> {
        let mut estimate = Self::nothing();
        estimate.solve_for(curve, approach, cells, |_| radius);
        estimate.load
    }

    /// No load.
    pub fn nothing() -> Self {
        let zero = Dual::zero();
        Self { load: zero, fours: Vec::new(), breadth: zero }
    }

    /// The estimate for an approach, from none; `radius` gives the rolling radius of places with
    /// their depths, and `cells` is memory. It is written in place, because a copy would take room
    /// on the stack.
    #[inline(never)]
    pub fn solve_for(
        &mut self, curve: &SmoothedProfile<F, N>, approach: Dual<F, N>, cells: &mut Cells<F, N>,
        radius: impl FnOnce(&mut dyn Iterator<Item = [Dual<F, N>; 2]>) -> Dual<F, N>,
    ) {
        let level = approach.times(OVERLAP);
        place_loads(curve, (approach, level), cells);
        couple_parts(cells);
        let (zero, places) = (Dual::zero(), cells.list.as_slice());
        let (mut work, mut load) = (zero, zero);
        let mut depths: Vec<Dual<F, N>, LOAD_EDGES> = Vec::new();
        let mut edges: Vec<LoadEdge<F, N>, LOAD_EDGES> = Vec::new();
        for place in places {
            let q = (level - curve.over(place.at, place.over)).max(zero);
            let half = place.width.times(0.5);
            let (lower, upper) = (place.y - half, place.y + half);
            let close = half.value.times(1e-4);
            // neighbours share an edge
            match edges.last_mut() {
                Some((edge, growth)) if (edge.value - lower.value).abs() <= close => *growth += q,
                _ => {
                    let _ = edges.push((lower, q));
                }
            }
            let _ = edges.push((upper, -q));
            load += q * place.width;
            work += q * place.width * (approach - level + q);
            let _ = depths.push(q);
        }
        self.keep(&edges);
        let loads = places.iter().zip(&depths).map(|(place, q)| [place.at, *q * place.width]);
        self.breadth = (radius(&mut { loads }) * approach).times(1.1).sqrt().times(BREADTH);
        let energy = places.iter().zip(&depths).fold(zero, |sum, (place, q)| {
            let [deflection, _] = self.deflection(place.at);
            sum + *q * place.width * deflection
        });
        let size = work / energy.shift(F::TINY);
        self.load = load * size;
        edges.iter_mut().for_each(|(_, growth)| *growth = *growth * size);
        self.keep(&edges);
    }

    /// Keeps edges, four side by side.
    fn keep(&mut self, edges: &[LoadEdge<F, N>]) {
        self.fours.clear();
        for four in edges.chunks(4) {
            let places = side_by_side(four, |(place, _)| *place);
            let growth = side_by_side(four, |(_, growth)| *growth);
            let _ = self.fours.push(FourEdges { places, growth });
        }
    }

    /// The deflection at `y`, and its slope along `y`.
    pub fn deflection(&self, y: Dual<F, N>) -> [Dual<F, N>; 2] {
        with_avx!(if 1 => <F: Float; N>(
            estimate: &Estimate<F, N> = self,
            y: Dual<F, N> = y
        ) -> [Dual<F, N>; 2] {
            estimate.in_fours::<F::Four>(y)
        } {
            estimate.in_fours::<F::WideFour>(y)
        })
    }

    /// `Σ growth arsinh((y − edge)/ε)`, four edges side by side, and its slope.
    #[inline(always)]
    fn in_fours<P: Strips<F>>(&self, y: Dual<F, N>) -> [Dual<F, N>; 2] {
        let one = P::one();
        let inverse = self.breadth.inverse();
        let all =
            |own: Dual<F, N>| Dual { value: P::all(own.value), gradient: own.gradient.map(P::all) };
        let four = |list: &[F; 4]| P::gather(|k| list.get(k).copied().unwrap_or(F::zero()));
        let fours = |own: &Dual<[F; 4], N>| Dual {
            value: four(&own.value),
            gradient: own.gradient.each_ref().map(four),
        };
        let (y, per_breadth) = (all(y), all(inverse));
        let mut sums = [Dual::<P, N>::zero(); 2];
        for FourEdges { places, growth } in &self.fours {
            let size = fours(growth);
            let x = (y - fours(places)) * per_breadth;
            // arsinh x = ln(|x| + √(1 + x²)) with the sign of x, its slope 1/√(1 + x²), and the
            // slope of that
            let root = (x.value.squared() + one).sqrt();
            let slope = one / root;
            let bend = -(x.value * slope * slope.squared());
            let logarithm = F::ln_quotients(x.value.abs() + root, F::one());
            let value = x.value.choose(logarithm, -logarithm);
            let [sum, slopes] = &mut sums;
            *sum += size * Dual::composed(value, [slope], [x]);
            *slopes += size * Dual::composed(slope, [bend], [x]);
        }
        let [sum, slopes] =
            sums.map(|own| Dual { value: own.value.total(), gradient: own.gradient.map(P::total) });
        [sum, slopes * inverse]
    }
}

/// Lays cells out where the curve is below a level. It stays out of line, because the
/// zones are not needed afterwards.
#[inline(never)]
fn place_loads<F: Float, const N: usize>(
    curve: &SmoothedProfile<F, N>, (approach, level): (Dual<F, N>, Dual<F, N>),
    cells: &mut Cells<F, N>,
) {
    let mut zones = Zones::new(approach, curve.smoothing());
    curve.zones(&mut zones, |_, height, slope| [height - level, slope]);
    layout(&zones, [LOADS, MOST_LOADS], cells);
}

/// Numbers of up to four edges side by side.
fn side_by_side<F: Float, const N: usize>(
    edges: &[LoadEdge<F, N>], number: impl Fn(&LoadEdge<F, N>) -> Dual<F, N>,
) -> Dual<[F; 4], N> {
    let number = |k: usize| edges.get(k).map_or(Dual::zero(), &number);
    let four = |of: &dyn Fn(Dual<F, N>) -> F| [0, 1, 2, 3].map(|k| of(number(k)));
    Dual {
        value: four(&|own| own.value),
        gradient: core::array::from_fn(|d| four(&|own| own.derivative(d))),
    }
}
