//! A smoothed profile, and the strips that stand on it.

use crate::number::Float;
use crate::patch::normal::{Cell, Cells};
use crate::patch::section::Profile;
use crate::status::Error;
use heapless::Vec;

/// Points that the profile is averaged at for the smoothing, at most.
const BINS: usize = 256;
/// Places of the lattice on either side of its middle at most.
const PLACES: i32 = 1000;

/// A profile averaged over bins of one width, and the parabolas through them.
struct Smooth<F> {
    heights: Vec<F, BINS>,
    /// What the profile covers of each bin.
    shares: Vec<F, BINS>,
    start: F,
    step: F,
    length: F,
}

/// `c₀ + c₁ x + c₂ x²` with `x` in smoothing lengths from a place.
#[derive(Clone, Copy)]
struct Parabola<F> {
    height: F,
    slope: F,
    bend: F,
}

impl<F: Float> Smooth<F> {
    fn new() -> Self {
        let zero = F::zero();
        let (heights, shares) = (Vec::new(), Vec::new());
        Self { heights, shares, start: zero, step: zero, length: zero }
    }

    /// Between two places of the profile, and as far beyond as a parabola looks. Edges of bins stand on `middle`.
    fn fill(
        &mut self,
        profile: &Profile<F>,
        middle: F,
        [lower, upper]: [F; 2],
        length: F,
    ) -> Result<(), Error> {
        let [first, last] = profile.ends().ok_or(Error::Profile)?;
        let (lower, upper) = ((lower - length).max(first), (upper + length).min(last));
        let step = length.times(0.125).max((upper - lower) / F::of((BINS - 2) as f64));
        // (a parabola needs three bins)
        self.length = length.max(step.times(3.0));
        let before = ((middle - lower) / step).max(F::zero()).whole().saturating_add(1);
        let start = middle - step * F::widened(before as f32);
        let edge = |bins: i32| start + step * F::widened(bins as f32);
        let (heights, shares) = (&mut self.heights, &mut self.shares);
        let (mut sum, mut covered, mut bins) = (F::zero(), F::zero(), 1);
        let mut close = |sum: &mut F, covered: &mut F| {
            let height = if *covered > F::zero() { *sum / *covered } else { F::zero() };
            let _ = heights.push(height);
            let _ = shares.push(*covered / step);
            (*sum, *covered) = (F::zero(), F::zero());
            heights.is_full()
        };
        // integrals of the straight pieces between the edges of the bins
        'pieces: for ([from, to], [h_from, h_to]) in profile.pieces() {
            let slope = (h_to - h_from) / (to - from);
            let at = |y: F| h_from - profile.lowest + (y - from) * slope;
            let mut begin = from.max(start);
            while begin < to {
                let until = to.min(edge(bins)).max(begin);
                let width = until - begin;
                sum += width * (at(begin) + at(until)).times(0.5);
                covered += width;
                begin = until;
                if edge(bins) > to {
                    break;
                }
                bins += 1;
                if close(&mut sum, &mut covered) || edge(bins - 1) > upper {
                    break 'pieces;
                }
            }
        }
        if covered > F::zero() && bins <= BINS as i32 {
            close(&mut sum, &mut covered);
        }
        (self.start, self.step) = (start, step);
        Ok(())
    }

    /// About `y`, heights above the lowest point of the profile.
    fn at(&self, y: F) -> Option<Parabola<F>> {
        let reach = self.length / self.step;
        let place = (y - self.start) / self.step;
        let near = (place - reach).max(F::zero()).whole() as usize;
        let width = reach.times(2.0).max(F::zero()).whole() as usize + 2;
        let mut moments = [F::zero(); 5];
        let mut sums = [F::zero(); 3];
        let inverse = F::one() / reach;
        let bins = self.heights.iter().zip(&self.shares).enumerate();
        for (i, (height, share)) in bins.skip(near).take(width) {
            let x = (F::widened(i as f32).plus(0.5) - place) * inverse;
            let rest = (F::one() - x * x).max(F::zero());
            let mut power = rest * rest * rest * *share;
            let mut sums = sums.iter_mut();
            for moment in &mut moments {
                *moment += power;
                if let Some(sum) = sums.next() {
                    *sum += power * *height;
                }
                power = power * x;
            }
        }
        // Least squares by Cramer's rule
        let [m0, m1, m2, m3, m4] = moments;
        let [s0, s1, s2] = sums;
        let [c00, c01, c02] = [m2 * m4 - m3 * m3, m2 * m3 - m1 * m4, m1 * m3 - m2 * m2];
        let [c11, c12, c22] = [m0 * m4 - m2 * m2, m1 * m2 - m0 * m3, m0 * m2 - m1 * m1];
        let inverse = F::one() / (m0 * c00 + m1 * c01 + m2 * c02);
        let found = Parabola {
            height: (s0 * c00 + s1 * c01 + s2 * c02) * inverse,
            slope: (s0 * c01 + s1 * c11 + s2 * c12) * inverse,
            bend: (s0 * c02 + s1 * c12 + s2 * c22) * inverse,
        };
        let Parabola { height, slope, bend } = found;
        [height, slope, bend].iter().all(|x| x.is_finite_number()).then_some(found)
    }
}

/// Where the strips of the normal problem lie: on a lattice that stands on the middle of the load.
pub(super) struct Lattice<F> {
    /// The smoothed profile's lowest point above the profile's.
    pub lowest: F,
    middle: F,
    /// Of a strip \[m\].
    pub width: F,
}

impl<F: Float> Lattice<F> {
    /// About so many strips below a level, listed in `cells`. The first lattice has its middle from the section there, and its
    /// level is above the smoothed profile's lowest point.
    #[inline(never)]
    pub fn new(
        profile: &Profile<F>,
        level: F,
        length: F,
        count: u32,
        known: Option<F>,
        cells: &mut Cells<F>,
    ) -> Result<Self, Error> {
        let section = profile.section(level);
        let middle = known.unwrap_or(profile.deepest + section.moment / section.volume);
        // (at the ends of the number range it may be none)
        let inside = middle >= section.lower && middle <= section.upper;
        let middle = if inside { middle } else { profile.deepest };
        let mut smooth = Smooth::new();
        smooth.fill(profile, middle, [section.lower, section.upper], length)?;
        let Parabola { height, slope, bend } = smooth.at(profile.deepest).ok_or(Error::Overflow)?;
        // the vertex, and the half width of the parabola where it is narrower than the section's points tell
        let bend = bend.max(F::TINY);
        let lowest = height - (slope * (slope / bend)).times(0.25).min(height.abs());
        let half = ((level - lowest).max(F::zero()) / bend).sqrt().min(F::one()) * smooth.length;
        // (of a parabola the width, and smooth where a flat crest comes under the level)
        let width = (section.volume / level).times(1.5).max(half.times(2.0));
        let width = width / F::widened(count as f32);
        let [first, last] = profile.ends().ok_or(Error::Profile)?;
        let lattice = Self { lowest, middle, width };
        let from = section.lower.min(profile.deepest - half).max(first);
        let to = section.upper.max(profile.deepest + half).min(last);
        let most = F::widened(PLACES as f32);
        let places = |length: F| (length / width).min(most).whole().max(1) + 1;
        let level = if known.is_some() { level } else { level + lowest };
        cells.width = width;
        for place in -places(middle - from)..=places(to - middle) {
            let height = smooth.at(lattice.y(place)).ok_or(Error::Overflow)?.height;
            if height < level {
                cells.list.push(Cell::new(place, height)).map_err(|_| Error::PatchSize)?;
            }
        }
        Ok(lattice)
    }

    pub fn y(&self, place: i32) -> F {
        self.middle + self.width * F::widened(place as f32)
    }
}
