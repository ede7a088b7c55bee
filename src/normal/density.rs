//! How closely the cells of the normal problem lie along the zones of contact.
//!
//! The depth `d` of a place is by how much a function that is negative in a zone is less than zero
//! there. The **density** of cells is
//!
//! ```text
//! ρ = min(1, d/d₀ + (l dd/dy/d₀)²)      d₀ = 0.03 δ, l = s/10
//! ```
//!
//! with the approach `δ` and the smoothing length `s`. Cells of a contact of ordinary shape are
//! therefore of one width. A zone that has just appeared, or a wide margin where the bodies hardly
//! touch, takes few cells from the others, and zones part and merge where there are hardly any. So
//! no cell moves as fast as the end of a zone does that appears or merges.

use crate::number::{Arithmetic, Dual, Float, pairs};
use heapless::Vec;

/// Largest number of zones of contact; further zones are joined with the last.
pub(super) const MOST_ZONES: usize = if cfg!(target_os = "none") { 4 } else { 8 };
/// Largest number of places where the density is kept.
const DENSITY_PLACES: usize = if cfg!(target_os = "none") { 40 } else { 160 };
/// `d₀` over the approach.
const DEEP: f64 = 0.03;
/// `l` over the smoothing length.
const SLOPE_LENGTH: f64 = 0.1;
/// Variation of the depth that hardly counts, over `d₀`.
const SLIGHT: f64 = 0.02;

/// A place in a zone or at its end.
#[derive(Clone, Copy, Debug)]
struct DensityPoint<F, const N: usize> {
    /// \[m\]
    y: Dual<F, N>,
    /// `d/d₀ + (l dd/dy/d₀)²`, which may be more than 1.
    density: Dual<F, N>,
}

/// Zones in ascending `y`, with their densities.
pub(super) struct Zones<F, const N: usize> {
    /// How many places each has.
    list: Vec<usize, MOST_ZONES>,
    /// Of all zones; between them the density is linear.
    places: Vec<DensityPoint<F, N>, DENSITY_PLACES>,
    /// One over `d₀` \[1/m\].
    per_deep: Dual<F, N>,
    /// `l` \[m\]
    reach: Dual<F, N>,
    /// Variation of `min(1, d/d₀)` along all zones, and its value at the last place.
    variation: Dual<F, N>,
    last: Dual<F, N>,
    /// Number of places before the zone that has begun.
    pub begun: Option<usize>,
    /// Whether there were more zones than there is room for.
    pub joined: bool,
}

/// A part of a zone along which the density is linear.
pub(super) struct Stretch<F, const N: usize> {
    /// Where it begins \[m\].
    pub from: Dual<F, N>,
    /// Where it ends \[m\].
    pub to: Dual<F, N>,
    /// Density at both ends, from 0 to 1.
    pub densities: [Dual<F, N>; 2],
}

impl<F: Float, const N: usize> Stretch<F, N> {
    /// The integral of the density \[m\].
    pub fn integral(&self) -> Dual<F, N> {
        let [one, two] = self.densities;
        (one + two).times(0.5) * (self.to - self.from)
    }

    /// Where the integral of the density from the beginning has a value \[m\].
    pub fn place_of(&self, part: Dual<F, N>) -> Dual<F, N> {
        // ρ₀ t + (ρ₁ − ρ₀) t²/(2 L) = part, without cancellation
        let [one, two] = self.densities;
        let bend = (two - one) * part / (self.to - self.from);
        let square = one.squared() + bend.times(2.0);
        let root = square.max(Dual::from_base(F::TINY)).sqrt();
        (self.from + part.times(2.0) / (one + root)).min(self.to)
    }
}

impl<F: Float, const N: usize> Zones<F, N> {
    /// No zones; depths are measured with the approach \[m\], slopes with the smoothing length.
    #[inline]
    pub fn new(approach: Dual<F, N>, smoothing: Dual<F, N>) -> Self {
        let (per_deep, reach) = (approach.times(DEEP).inverse(), smoothing.times(SLOPE_LENGTH));
        let (list, places, variation) = (Vec::new(), Vec::new(), Dual::zero());
        let (last, begun, joined) = (variation, None, false);
        Self { list, places, per_deep, reach, variation, last, begun, joined }
    }

    /// Number of lobes: half the variation of the depth. A zone may end with the
    /// profile while it is deep.
    pub fn lobes(&self) -> Dual<F, N> {
        (self.variation + size(self.last)).times(0.5)
    }

    /// Hands every stretch to `take`, with the number of its zone.
    #[inline(never)]
    pub fn stretches(&self, take: &mut dyn FnMut(usize, &Stretch<F, N>)) {
        let one = Dual::one();
        let mut rest = self.places.as_slice();
        for (number, count) in self.list.iter().enumerate() {
            let Some((own, after)) = rest.split_at_checked(*count) else { return };
            rest = after;
            for (before, next) in pairs(own) {
                let [low, high] = [before, next].map(|place| place.density.min(one));
                let apart = [before, next].map(|place| place.density.value - F::one());
                let (middle, between) = if apart[0] * apart[1] < F::zero() {
                    // where it is 1
                    let share = (one - before.density) / (next.density - before.density);
                    (before.y + share * (next.y - before.y), one)
                } else {
                    (next.y, high)
                };
                for (from, to, densities) in
                    [(before.y, middle, [low, between]), (middle, next.y, [between, high])]
                {
                    if to.value > from.value {
                        take(number, &Stretch { from, to, densities });
                    }
                }
            }
        }
    }

    /// A zone begins at `y` with this value and slope. Without room the last zone goes on instead.
    pub fn begin(&mut self, y: Dual<F, N>, of: [Dual<F, N>; 2]) {
        let known = self.places.len();
        let room = !self.list.is_full() && known + 3 <= DENSITY_PLACES;
        let last = if room { None } else { self.list.pop() };
        self.joined |= !room;
        self.begun = Some(known - last.unwrap_or(0).min(known));
        self.pass(y, of);
    }

    /// The function has this value and slope at `y`, in the zone that has begun or at its end. Of
    /// places where cells are as narrow as anywhere only the first and the last are kept.
    #[inline(never)]
    pub fn pass(&mut self, y: Dual<F, N>, [value, slope]: [Dual<F, N>; 2]) {
        let Some(begun) = self.begun else { return };
        let depth = (-value).max(Dual::zero()) * self.per_deep;
        let steepness = self.reach * slope * self.per_deep;
        let place = DensityPoint { y, density: depth + steepness.squared() };
        let depth = depth.min(Dual::one());
        self.variation += size(depth - self.last);
        self.last = depth;
        let deep = |place: &DensityPoint<F, N>| place.density.value >= F::one();
        let full = self.places.is_full();
        match self.places.get_mut(begun..) {
            Some([.., before, last]) if full || (deep(before) && deep(last) && deep(&place)) => {
                *last = place;
            }
            _ => {
                let _ = self.places.push(place);
            }
        }
    }

    /// Whether cells are as narrow as anywhere where the function has this value, and well beyond.
    pub fn are_deep(&self, value: F) -> bool {
        -value * self.per_deep.value >= F::of(2.0)
    }

    /// The zone that has begun, if one has, ends with the last place.
    pub fn end(&mut self) {
        let Some(begun) = self.begun.take() else { return };
        let own = self.places.get(begun..).unwrap_or(&[]);
        let (Some(first), Some(last)) = (own.first(), own.last()) else { return };
        if last.y.value > first.y.value {
            let _ = self.list.push(own.len());
        } else {
            self.places.truncate(begun);
        }
    }
}

/// `x²/(|x| + c)`, about the size of a number, without a kink.
fn size<F: Float, const N: usize>(x: Dual<F, N>) -> Dual<F, N> {
    x.squared() / x.abs().plus(SLIGHT)
}
