//! Skewed contacts: under a body that yaws, the distance is least along `x` at a place that changes
//! by `m` for each length across.
//!
//! The cells are solved as if it did not change. What the skew makes of their pressure and load is
//! what it makes of those of Hertz's contact. Of `A (x − m y)²/2 + B y²/2` the product `AB` of the
//! principal curvatures is that of the contact without skew, and half their sum over its root is
//!
//! ```text
//! C = C₀ + t,   C₀ = (A + B)/(2√(AB)),   t = m² √(A/B)/2
//! ```
//!
//! Under the same load a contact of larger `C` has more pressure on less area, and less approach.
//! Both are smooth functions of `C`, whichever axis is the longer one. `A/B` is that of Hertz's
//! contact whose axes the cells have, and `m` is that within a zone: zones do not skew each other.
//! Widths and centres of the strips stay. Without skew every factor is exactly one.

use crate::normal::cells::{Cells, Given};
use crate::number::{Arithmetic, Dual, Float};

/// Distance of cells that hardly count in `m`, over the half length.
const HARDLY: f64 = 0.3;
/// `x (s + x (a + x b))/(1 + x (d + x e))`, fitted by `fit/fit_skew.py` up to axes of 1 to 3000;
/// `s` is exact for a circle. The logarithm of the approach under a load, over `ln C`.
const APPROACH_BY_AXES: [f64; 5] = [-1.0 / 9.0, -0.07839468, -0.02163195, 0.49003075, 0.07187667];
/// That of the pressure.
const PRESSURE_BY_AXES: [f64; 5] = [2.0 / 9.0, 0.20185655, 0.05583529, 0.79983055, 0.17243379];
/// That of `9/16 (c − 1)/(C − 1)` over `ln c`, where `2c` is the ratio of the axes and its inverse.
const AXES: [f64; 5] = [1.0 / 32.0, 0.00877391, 0.00136164, -0.05536114, 0.03584116];

/// The fitted function of the logarithm of a number.
#[inline(always)]
fn by_constants<F: Float, const N: usize>(x: Dual<F, N>, [s, a, b, d, e]: [f64; 5]) -> Dual<F, N> {
    let x = Dual::composed(x.value.ln(), [F::one() / x.value], [x]);
    x * ((x.times(b).plus(a) * x).plus(s) / (x * x.times(e).plus(d)).plus(1.0))
}

fn exponential<F: Float, const N: usize>(x: Dual<F, N>) -> Dual<F, N> {
    let value = x.value.exp();
    Dual::composed(value, [value], [x])
}

/// `C₀` and `√(A/B)` of a contact whose semi-axes along `x` and across have this ratio.
fn curvatures<F: Float, const N: usize>(ratio: Dual<F, N>) -> [Dual<F, N>; 2] {
    let inverse = ratio.inverse();
    let (sum, difference) = ((ratio + inverse).times(0.5), (ratio - inverse).times(0.5));
    let axes = exponential(by_constants(sum, AXES)).times(16.0 / 9.0);
    let curvatures = (sum.plus(-1.0) / axes).plus(1.0);
    // (B − A)/(2√(AB)), whose square is C² − 1
    let factor = (axes * sum.plus(1.0) / curvatures.plus(1.0)).sqrt();
    let difference = difference / factor;
    // of a contact along x, where these cancel, by their sum
    let root = if difference.value > F::zero() {
        (curvatures + difference).inverse()
    } else {
        curvatures - difference
    };
    [curvatures, root]
}

/// Half length over half width of the ellipse that has the load's distribution, and `m`.
fn shape<F: Float, const N: usize>(cells: &Cells<F, N>) -> [Dual<F, N>; 2] {
    let per_load = cells.load().shift(F::TINY).inverse();
    // of an ellipse Σ N a² = (4/5) a² Σ N and Σ N²/w = (3/5) (Σ N)²/b
    let (mut length, mut crowded) = (Dual::zero(), Dual::zero());
    for cell in cells.list.iter() {
        let load = cell.load() * per_load;
        length += load * cell.half_length.squared();
        crowded += load.squared() / cell.width;
    }
    let square = length.times(1.25);
    let per_reach = square.times(HARDLY * HARDLY).inverse();
    let (mut products, mut squares) = (Dual::zero(), Dual::from_base(F::TINY));
    let touching = || cells.list.iter().filter(|cell| cell.pressure.value > F::zero());
    for (i, cell) in touching().enumerate() {
        let load = cell.load() * per_load;
        for other in touching().take(i) {
            let apart = cell.y - other.y;
            let near = (apart.squared() * per_reach).plus(1.0).inverse();
            let weight = load * (other.load() * per_load) * near.squared() * near * apart;
            products += weight * (cell.centre_x - other.centre_x);
            squares += weight * apart;
        }
    }
    [square.sqrt() * crowded.times(1.0 / 0.6), products / squares]
}

impl<F: Float, const N: usize> Cells<F, N> {
    /// Skews the cells; returns the factor of the approach, one where the approach is given.
    #[inline(never)]
    pub(super) fn skew(&mut self, given: Given<Dual<F, N>>) -> Dual<F, N> {
        let [zero, one] = [Dual::zero(), Dual::one()];
        // without skew all factors are one, and they grow with its square
        if self.list.iter().all(|cell| cell.centre_x.value == F::zero()) {
            return one;
        }
        let [ratio, slope] = shape(self);
        let [straight, root] = curvatures(ratio);
        let skewed = straight + slope.squared() * root.times(0.5);
        let approach =
            by_constants(skewed, APPROACH_BY_AXES) - by_constants(straight, APPROACH_BY_AXES);
        let pressure =
            by_constants(skewed, PRESSURE_BY_AXES) - by_constants(straight, PRESSURE_BY_AXES);
        // N ~ δ^(3/2), p ~ N^(1/3), and the area is N/p
        let (load, approach) = match given {
            Given::Load(_) => (zero, exponential(approach)),
            Given::Approach(_) => (approach.times(-1.5), one),
        };
        let shorter = exponential(load.times(2.0 / 3.0) - pressure);
        let pressure = exponential(load.times(1.0 / 3.0) + pressure);
        for cell in self.list.iter_mut() {
            cell.half_length = cell.half_length * shorter;
            cell.pressure = cell.pressure * pressure;
        }
        approach
    }
}
