//! The distance of two bodies as it was given, and where they would overlap if they were shifted into each other.

use crate::number::Float;
use crate::patch::normal::elliptic_load;
use crate::patch::profile::ProfileContact;
use crate::status::Error;

/// Share of the approach by which the section of the undeformed bodies is about the patch.
pub(super) const SECTION: f64 = 0.55;
/// Sections at most in search of the first guess; five are usual.
const GUESSES: u32 = 40;

/// The undeformed distance of two bodies along `y`, straight between its points.
#[derive(Clone, Copy, Debug)]
pub struct Profile<'a, F> {
    y: &'a [F],
    distance: &'a [F],
    /// Where the distance is least along `x`; empty: at 0.
    centre_x: &'a [F],
    /// Empty: that of the contact.
    rolling_radius: &'a [F],
    /// Smallest distance, and where it is.
    pub(super) lowest: F,
    pub(super) deepest: F,
}

/// Where the bodies would overlap: `∫ (h₀ − h) dy`, its width, and its ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Section<F> {
    pub volume: F,
    width: F,
    /// `∫ (h₀ − h) (y − y₀) dy` about the deepest point.
    pub moment: F,
    pub lower: F,
    pub upper: F,
}

impl<'a, F: Float> Profile<'a, F> {
    /// Points `y` \[m\], strictly ascending, and the distance of the bodies there \[m\]; what is added to all
    /// distances does not matter.
    ///
    /// # Errors
    /// [`Error::Profile`] for fewer than two points, arrays of different length or `y` that does not ascend;
    /// [`Error::NotFinite`].
    pub fn new(y: &'a [F], distance: &'a [F]) -> Result<Self, Error> {
        let (Some(first), true) = (distance.first(), y.len() >= 2 && y.len() == distance.len())
        else {
            return Err(Error::Profile);
        };
        if !y.iter().chain(distance).all(|x| x.is_finite_number()) {
            return Err(Error::NotFinite);
        }
        if !y.iter().zip(y.iter().skip(1)).all(|(y, next)| y < next) {
            return Err(Error::Profile);
        }
        // The middle of the flat bottom of the medians of three neighbours: a single bad point is none
        let medians = || {
            let (before, after) = (distance.iter(), distance.iter().skip(2));
            let middle = before.zip(distance.iter().skip(1)).zip(after);
            let medians = middle.map(|((a, b), c)| a.min(*b).max(a.max(*b).min(*c)));
            y.iter().skip(1).zip(medians)
        };
        let end = |h: Option<&F>| h.copied().unwrap_or(*first);
        let ends = end(distance.first()).min(end(distance.last()));
        let lowest = medians().fold(ends, |lowest, (_, h)| lowest.min(h));
        // (of two bottoms as low the first)
        let mut bottom =
            medians().skip_while(|(_, h)| *h > lowest).take_while(|(_, h)| *h <= lowest);
        let (start, finish) = match bottom.next() {
            Some((start, _)) => (*start, bottom.last().map_or(*start, |(y, _)| *y)),
            None => (end(y.first()), end(y.last())),
        };
        let deepest = start.times(0.5) + finish.times(0.5);
        Ok(Self { y, distance, centre_x: &[], rolling_radius: &[], lowest, deepest })
    }

    /// The same with the place along `x` \[m\] where the distance is least, for each point: of bodies that yaw.
    ///
    /// # Errors
    /// [`Error::Profile`] for another number of points; [`Error::NotFinite`].
    pub fn with_centre_x(mut self, centre_x: &'a [F]) -> Result<Self, Error> {
        self.centre_x = self.of_each_point(centre_x)?;
        Ok(self)
    }

    /// The same with a rolling radius \[m\] for each point; that of the contact does not count then.
    ///
    /// # Errors
    /// [`Error::Profile`] for another number of points; [`Error::NotFinite`]; [`Error::RollingRadius`].
    pub fn with_rolling_radius(mut self, rolling_radius: &'a [F]) -> Result<Self, Error> {
        self.rolling_radius = self.of_each_point(rolling_radius)?;
        if self.rolling_radius.iter().any(|radius| *radius <= F::zero()) {
            return Err(Error::RollingRadius);
        }
        Ok(self)
    }

    fn of_each_point(&self, values: &'a [F]) -> Result<&'a [F], Error> {
        if values.len() != self.y.len() {
            Err(Error::Profile)
        } else if values.iter().all(|x| x.is_finite_number()) {
            Ok(values)
        } else {
            Err(Error::NotFinite)
        }
    }

    /// Where the distance is least along `x`, straight between the points.
    pub(super) fn centre_x(&self, y: F) -> F {
        let next = self.y.partition_point(|place| *place < y);
        let next = next.min(self.y.len().saturating_sub(1)).max(1);
        let at = |list: &[F], i: usize| list.get(i).copied().unwrap_or(F::zero());
        let (from, to) = (at(self.y, next - 1), at(self.y, next));
        let (before, after) = (at(self.centre_x, next - 1), at(self.centre_x, next));
        before + (after - before) * ((y - from) / (to - from))
    }

    /// The rolling radius of about the contact: the mean, weighted with how far points lie below a height over the deepest.
    pub(super) fn mean_rolling_radius(&self, height: F) -> Option<F> {
        let (mut sum, mut weight) = (F::zero(), F::TINY);
        for (radius, distance) in self.rolling_radius.iter().zip(self.distance) {
            let depth = (self.lowest + height - *distance).max(F::TINY);
            sum += *radius * depth;
            weight += depth;
        }
        (!self.rolling_radius.is_empty()).then(|| sum / weight)
    }

    pub(super) fn ends(&self) -> Option<[F; 2]> {
        Some([*self.y.first()?, *self.y.last()?])
    }

    /// Largest height above the deepest point that both ends have.
    pub(super) fn depth(&self) -> F {
        let ends = [self.distance.first(), self.distance.last()];
        ends.into_iter()
            .flatten()
            .map(|end| *end - self.lowest)
            .reduce(|a, b| a.min(b))
            .unwrap_or(F::zero())
    }

    /// Mean distance of neighbouring points.
    pub(super) fn step(&self) -> F {
        let length = self.ends().map_or(F::zero(), |[first, last]| last - first);
        length / F::widened(self.y.len().saturating_sub(1).max(1) as f32)
    }

    /// The straight pieces, each with its ends.
    pub(super) fn pieces(&self) -> impl Iterator<Item = ([F; 2], [F; 2])> + use<'a, F> {
        let points = self.y.iter().zip(self.distance);
        let next = points.clone().skip(1);
        points.zip(next).map(|((y, h), (next, above))| ([*y, *next], [*h, *above]))
    }

    pub(super) fn section(&self, level: F) -> Section<F> {
        let deepest = self.deepest;
        let mut section = Section {
            volume: F::zero(),
            width: F::zero(),
            moment: F::zero(),
            lower: deepest,
            upper: deepest,
        };
        let height = self.lowest + level;
        for ([from, to], [h_from, h_to]) in self.pieces() {
            let (g_from, g_to) = (height - h_from, height - h_to);
            let (low, high) = (g_from.min(g_to), g_from.max(g_to));
            if high <= F::zero() {
                continue;
            }
            // the part of the piece where g > 0
            let part = if low < F::zero() { high / (high - low) } else { F::one() };
            let length = (to - from) * part;
            section.width += length;
            let volume = length * (high + low.max(F::zero())).times(0.5);
            section.volume += volume;
            section.moment += volume * (from.times(0.5) + to.times(0.5) - deepest);
            section.lower = section.lower.min(if g_from >= g_to { from } else { to - length });
            section.upper = section.upper.max(if g_to >= g_from { to } else { from + length });
        }
        section
    }

    /// About the load at an approach.
    fn load(&self, contact: &ProfileContact<F>, approach: F) -> F {
        let Section { volume, width, .. } = self.section(approach.times(SECTION));
        // a² = (3/2) mean of 2 R g
        let a = (contact.rolling_radius.times(3.0) * (volume / (width + F::TINY))).sqrt();
        elliptic_load(a + F::TINY, width.times(0.5) + F::TINY, contact.modulus(), approach)
    }

    /// About the approach under a load, by secants through `N^{2/3}` between two brackets; the value at an end that stays
    /// twice is halved (the Illinois rule).
    pub(super) fn guess(&self, contact: &ProfileContact<F>, wanted: F) -> Result<(F, u32), Error> {
        let power = |load: F| load.cube_root() * load.cube_root();
        let target = power(wanted);
        let (mut low, mut high) = (F::zero(), self.depth().times(1.0 / SECTION));
        let largest = self.load(contact, high);
        if !largest.is_finite_number() {
            return Err(Error::Overflow);
        }
        if largest < wanted {
            return Err(Error::ProfileEnd);
        }
        let (mut below, mut above) = (target, power(largest) - target);
        let (mut moved, mut iterations) = (0_i32, 1);
        let mut tried = high;
        while iterations < GUESSES {
            let secant = low + (high - low) * (below / (below + above));
            let inside = secant > low && secant < high;
            tried = if inside { secant } else { low.times(0.5) + high.times(0.5) };
            iterations += 1;
            let excess = power(self.load(contact, tried)) - target;
            if excess.abs() <= target * F::of(1e-5) {
                break;
            }
            if excess < F::zero() {
                (low, below) = (tried, -excess);
                if moved < 0 {
                    above = above.times(0.5);
                }
                moved = -1;
            } else {
                (high, above) = (tried, excess);
                if moved > 0 {
                    below = below.times(0.5);
                }
                moved = 1;
            }
        }
        Ok((tried, iterations))
    }
}
