//! An estimate of load and deflection for an approach, made before the normal problem is solved. The overlap of the undeformed bodies
//! gives the shape of the load, and the least energy its size.
//!
//! The load per width is `f q`, `q = (0.6 δ − h)₊`. With line loads that act at the distance `√(d² + ε²)`, `ε` about a third of the
//! half length, the deflection is `u = Σ f q w K/(π E*)`, `K = [arsinh((d ± w/2)/ε)]/w`, and of all sizes
//!
//! ```text
//! N = f Σ q w,   f = π E* Σ q w (δ − h)/Σ q w K q w
//! ```
//!
//! has the least energy. This load is within 3 % of Hertz's for axis ratios of 0.13 to 8.

use crate::number::{Arithmetic, Float};
use crate::patch::lattice::{Places, lattice};
use crate::patch::section::Moving;
use crate::patch::smooth::Curve;
use heapless::Vec;

/// Share of the approach: undeformed bodies that are shifted by so much overlap about where they touch.
pub(super) const OVERLAP: f64 = 0.6;
/// `ε/√(1.1 R δ)`
const BREADTH: f64 = 0.22;
/// Depth of a zone over the approach, from which its cells are as narrow as those of other zones.
pub(super) const DEEP: f64 = 0.03;
/// Number of cells of the estimate.
const COUNT: usize = 10;

/// The load of an approach and its distribution.
#[derive(Clone, Debug)]
pub(super) struct Estimate<F> {
    /// `N/(π E*)` \[m²\]
    pub load: Moving<F>,
    places: Places<F>,
    /// `f q w/(π E*)` of each place.
    shares: [Moving<F>; SHARES],
    breadth: Moving<F>,
}

/// Places of the estimate at most.
const SHARES: usize = COUNT + crate::patch::smooth::ZONES;

/// `arsinh x`, odd, and its slope `1/√(1 + x²)`.
#[inline(always)]
fn arsinh<F: Float>(x: Moving<F>) -> [Moving<F>; 2] {
    let t = x.value.abs();
    let root = (t * t + F::one()).sqrt();
    let inverse = F::one() / root;
    // (only differences of this value are used, so that the rounding of 1 is small enough)
    let sum = t + root;
    let value = sum.ln_quotient(F::one());
    let value = x.value.choose(value, -value);
    let slope = -(x.value * inverse * inverse * inverse);
    [Moving::composed(value, [inverse], [x]), Moving::composed(inverse, [slope], [x])]
}

impl<F: Float> Estimate<F> {
    /// The load alone. (Out of line, so that only this function keeps the places.)
    #[inline(never)]
    pub fn load(curve: &Curve<F>, approach: Moving<F>, radius: Moving<F>) -> Moving<F> {
        Self::new(curve, approach, radius).load
    }

    #[inline(never)]
    pub fn new(curve: &Curve<F>, approach: Moving<F>, radius: Moving<F>) -> Self {
        let level = approach.times(OVERLAP);
        let (zones, _) = curve.zones(|_, height, slope| [height - level, slope]);
        let breadth = (radius * approach).times(1.1).sqrt().times(BREADTH);
        let zero = Moving::zero();
        let mut shares = [zero; SHARES];
        let mut estimate = Self { load: zero, places: Vec::new(), shares, breadth };
        lattice(&zones, COUNT, approach.times(DEEP), &mut estimate.places);
        let (mut work, mut load) = (zero, zero);
        for (share, place) in shares.iter_mut().zip(&estimate.places) {
            let height = curve.at(place.y);
            let q = (level - height).max(zero) * place.width;
            *share = q;
            load += q;
            work += q * (approach - height);
        }
        estimate.shares = shares;
        let energy = estimate.places.iter().zip(&shares).fold(zero, |sum, (place, share)| {
            let [deflection, _] = estimate.deflection(place.y);
            sum + *share * deflection
        });
        let size = work / energy.shift(F::TINY);
        estimate.load = load * size;
        for share in &mut estimate.shares {
            *share = *share * size;
        }
        estimate
    }

    /// The deflection at `y`, and its slope along `y`.
    pub fn deflection(&self, y: Moving<F>) -> [Moving<F>; 2] {
        let zero = Moving::zero();
        let (mut sum, mut slope) = (zero, zero);
        let inverse = self.breadth.inverse();
        // neighbours share an edge
        let mut last: Option<(Moving<F>, [Moving<F>; 2])> = None;
        for (place, share) in self.places.iter().zip(&self.shares) {
            let at = |edge: Moving<F>| arsinh((y - edge) * inverse);
            let half = place.width.times(0.5);
            let (lower, upper) = (place.y - half, place.y + half);
            let known =
                last.filter(|(edge, _)| (edge.value - lower.value).abs() <= half.value.times(1e-4));
            let far = known.map_or_else(|| at(lower), |(_, found)| found);
            let near = at(upper);
            last = Some((upper, near));
            let density = *share / place.width;
            let ([far, far_slope], [near, near_slope]) = (far, near);
            sum += (far - near) * density;
            slope += (far_slope - near_slope) * density;
        }
        [sum, slope * inverse]
    }
}
