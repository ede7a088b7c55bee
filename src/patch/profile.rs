//! A contact patch from profiles: the distance of two bodies across the rolling direction, and what presses them together.
//!
//! 1. **First guess** of the approach `δ`: where the bodies would overlap if they were shifted by `0.55 δ` only, the section has
//!    a volume and a width; the ellipse of both carries about the load.
//! 2. **Smoothing.** Around each strip a parabola is fitted to the profile, points weighted with `(1 − (d/s)²)³` up
//!    to the smoothing length `s` away: measured points have noise that the bodies' elasticity would take for asperities.
//! 3. **Coarse, then fine**: the [normal problem](super::normal) on half as many strips gives the approach, and with it the width
//!    of the strips; on these it is solved again, lengths interpolated from the first.
//!
//! The lattice of strips stands on the middle of the load and stretches with it; strips that may touch are more than
//! those that do. Everything is a continuous function of load and distances.

use crate::contact::forces::StripCount;
use crate::contact::material::{check_modulus, check_poisson_ratio};
use crate::number::Float;
use crate::patch::normal::{CELLS, Cell, Cells, Given, elliptic_load};
use crate::patch::{Patch, PatchStrip};
use crate::solve::model::Precision;
use crate::status::Error;
use heapless::Vec;

/// Share of the approach by which the section of the undeformed bodies is about the patch.
const SECTION: f64 = 0.55;
/// Share of the approach below which bodies so far apart may touch: 0.5 for a circle, 0.74 in a long flat tail.
const REACH: f64 = 0.85;
/// Sections at most in search of the first guess; five are usual.
const GUESSES: u32 = 40;
/// Smoothing length by default, over the half length of the section.
const SMOOTHING: f64 = 0.6;
/// Points that the profile is averaged at for the smoothing, at most.
const BINS: usize = 256;
/// Share of the first guess that the approach may reach.
const GUESS: f64 = 1.6;
/// Strips of the coarse lattice.
const COARSE: u32 = 15;
/// Powers that correct the lengths of strips on the coarse lattice and on the fine one.
const COARSE_POWER: f64 = 0.5;
const FINE_POWER: f64 = 0.4;
/// Places of the lattice on either side of its middle at most.
const PLACES: i32 = 1000;

/// What presses two profiles together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileContact<F> {
    /// Rolling radius `R` \[m\], positive; of two rolling bodies `1/R = 1/R₁ + 1/R₂`.
    pub rolling_radius: F,
    /// The load or the approach.
    pub given: Given<F>,
    /// Combined shear modulus `G` \[Pa\], positive.
    pub shear_modulus: F,
    /// Combined Poisson's ratio `ν`, 0 to 1/2.
    pub poisson_ratio: F,
    /// Coefficient of friction `μ` of every strip, not negative.
    pub friction: F,
    /// Smoothing length `s` \[m\], not negative. Zero: 0.6 of the patch's approximate half length, 4 mm between a wheel and a
    /// rail, and at least two steps of the profile. Noise of 5 µm at points 0.05 mm apart then moves the force by 0.004 of `μ N`
    /// in the mean; what is narrower is rounded off.
    pub smoothing_length: F,
}

impl<F: Float> ProfileContact<F> {
    /// # Errors
    /// [`Error::NotFinite`], [`Error::RollingRadius`], [`Error::NormalForce`], [`Error::Modulus`],
    /// [`Error::PoissonRatio`], [`Error::Friction`], [`Error::SmoothingLength`].
    pub fn check(&self) -> Result<(), Error> {
        let (Given::Load(given) | Given::Approach(given)) = self.given;
        let inputs = [self.rolling_radius, given, self.friction, self.smoothing_length];
        if !inputs.iter().all(|input| input.is_finite_number()) {
            return Err(Error::NotFinite);
        }
        if self.rolling_radius <= F::zero() {
            return Err(Error::RollingRadius);
        }
        if matches!(self.given, Given::Load(load) if load < F::zero()) {
            return Err(Error::NormalForce);
        }
        check_modulus(self.shear_modulus)?;
        check_poisson_ratio(self.poisson_ratio)?;
        if self.friction < F::zero() {
            return Err(Error::Friction);
        }
        if self.smoothing_length < F::zero() {
            return Err(Error::SmoothingLength);
        }
        Ok(())
    }

    /// `E* = G/(1 − ν)`
    fn modulus(&self) -> F {
        self.shear_modulus / (F::one() - self.poisson_ratio)
    }
}

/// Two profiles in contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Indentation<F> {
    /// Approach of distant points `δ` \[m\], from the smoothed profile's deepest point.
    pub approach: F,
    /// Normal force of the strips \[N\]; where a load is given, that to rounding.
    pub normal_force: F,
    /// `dN/dδ` \[N/m\].
    pub stiffness: F,
    /// Largest pressure of a strip \[Pa\].
    pub peak_pressure: F,
    /// `y` of that strip \[m\].
    pub peak_y: F,
    /// Sections of the first guess.
    pub iterations: u32,
}

/// The undeformed distance of two bodies along `y`, straight between its points.
#[derive(Clone, Copy, Debug)]
pub struct Profile<'a, F> {
    y: &'a [F],
    distance: &'a [F],
    /// Smallest distance, and where it is.
    lowest: F,
    deepest: F,
}

/// Where the bodies would overlap: `∫ (h₀ − h) dy`, its width, and its ends.
#[derive(Clone, Copy, Debug)]
struct Section<F> {
    volume: F,
    width: F,
    /// `∫ (h₀ − h) (y − y₀) dy` about the deepest point.
    moment: F,
    lower: F,
    upper: F,
}

impl<'a, F: Float> Profile<'a, F> {
    /// Points `y` \[m\], strictly ascending, and the distance of the bodies there \[m\]; what is added to all
    /// distances does not matter.
    ///
    /// # Errors
    /// [`Error::Profile`] for fewer than three points, arrays of different length or `y` that does not ascend;
    /// [`Error::NotFinite`].
    pub fn new(y: &'a [F], distance: &'a [F]) -> Result<Self, Error> {
        let (Some(first), true) = (distance.first(), y.len() >= 3 && y.len() == distance.len())
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
        let mut bottom = medians().filter(|(_, h)| *h <= lowest).map(|(y, _)| *y);
        let (start, finish) = match bottom.next() {
            Some(start) => (start, bottom.last().unwrap_or(start)),
            None => (end(y.first()), end(y.last())),
        };
        Ok(Self { y, distance, lowest, deepest: start.times(0.5) + finish.times(0.5) })
    }

    fn ends(&self) -> Option<[F; 2]> {
        Some([*self.y.first()?, *self.y.last()?])
    }

    /// Largest height above the deepest point that both ends have.
    fn depth(&self) -> F {
        let ends = [self.distance.first(), self.distance.last()];
        ends.into_iter()
            .flatten()
            .map(|end| *end - self.lowest)
            .reduce(|a, b| a.min(b))
            .unwrap_or(F::zero())
    }

    /// Mean distance of neighbouring points.
    fn step(&self) -> F {
        let length = self.ends().map_or(F::zero(), |[first, last]| last - first);
        length / F::of(self.y.len().saturating_sub(1).max(1) as f64)
    }

    /// The straight pieces, each with its ends.
    fn pieces(&self) -> impl Iterator<Item = ([F; 2], [F; 2])> + use<'a, F> {
        let points = self.y.iter().zip(self.distance);
        let next = points.clone().skip(1);
        points.zip(next).map(|((y, h), (next, above))| ([*y, *next], [*h, *above]))
    }

    fn section(&self, level: F) -> Section<F> {
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
    fn guess(&self, contact: &ProfileContact<F>, wanted: F) -> Result<(F, u32), Error> {
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
    /// Between two places of the profile, and as far beyond as a parabola looks. Edges of bins stand on `middle`.
    fn new(profile: &Profile<F>, middle: F, [lower, upper]: [F; 2], length: F) -> Option<Self> {
        let [first, last] = profile.ends()?;
        let (lower, upper) = ((lower - length).max(first), (upper + length).min(last));
        let step = length.times(0.125).max((upper - lower) / F::of((BINS - 2) as f64));
        // (a parabola needs three bins)
        let length = length.max(step.times(3.0));
        let before = ((middle - lower) / step).max(F::zero()).to_f64() as u32 + 1;
        let start = middle - step * F::of(f64::from(before));
        let edge = |bins: u32| start + step * F::of(f64::from(bins));
        let (mut heights, mut shares) = (Vec::new(), Vec::new());
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
        if covered > F::zero() && bins <= BINS as u32 {
            close(&mut sum, &mut covered);
        }
        Some(Self { heights, shares, start, step, length })
    }

    /// About `y`, heights above the lowest point of the profile.
    fn at(&self, y: F) -> Option<Parabola<F>> {
        let reach = self.length / self.step;
        let place = (y - self.start) / self.step;
        let near = (place - reach).max(F::zero()).to_f64() as usize;
        let width = reach.times(2.0).to_f64() as usize + 2;
        let mut moments = [F::zero(); 5];
        let mut sums = [F::zero(); 3];
        let inverse = F::one() / reach;
        let bins = self.heights.iter().zip(&self.shares).enumerate();
        for (i, (height, share)) in bins.skip(near).take(width) {
            let x = (F::of(i as f64 + 0.5) - place) * inverse;
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

/// The strips of the normal problem over a profile: on a lattice that stands on the middle of the load.
struct Lattice<F> {
    smooth: Smooth<F>,
    /// The smoothed profile's lowest point above the profile's.
    lowest: F,
    middle: F,
    width: F,
    from: F,
    to: F,
}

impl<F: Float> Lattice<F> {
    /// About so many strips below a level.
    fn new(
        profile: &Profile<F>,
        level: F,
        length: F,
        count: u32,
        middle: Option<F>,
    ) -> Option<Self> {
        let section = profile.section(level);
        let middle = middle.unwrap_or(profile.deepest + section.moment / section.volume);
        let smooth = Smooth::new(profile, middle, [section.lower, section.upper], length)?;
        let Parabola { height, slope, bend } = smooth.at(profile.deepest)?;
        // the vertex, and the half width of the parabola where it is narrower than the section's points tell
        let bend = bend.max(F::TINY);
        let lowest = height - (slope * (slope / bend)).times(0.25).min(height.abs());
        let half = ((level - lowest).max(F::zero()) / bend).sqrt().min(F::one()) * smooth.length;
        // (of a parabola the width, and smooth where a flat crest comes under the level)
        let width = (section.volume / level).times(1.5).max(half.times(2.0));
        let width = width / F::of(f64::from(count));
        let [first, last] = profile.ends()?;
        Some(Self {
            lowest,
            middle,
            width,
            from: section.lower.min(profile.deepest - half).max(first),
            to: section.upper.max(profile.deepest + half).min(last),
            smooth,
        })
    }

    fn y(&self, place: i32) -> F {
        self.middle + self.width * F::of(f64::from(place))
    }

    /// The strips below a level.
    fn cells(&self, contact: &ProfileContact<F>, level: F) -> Result<Cells<F>, Error> {
        let most = F::of(f64::from(PLACES));
        let places = |length: F| ((length / self.width).min(most).to_f64() as i32).max(1) + 1;
        let (before, after) = (places(self.middle - self.from), places(self.to - self.middle));
        let mut list = Vec::new();
        for place in -before..=after {
            let height = self.smooth.at(self.y(place)).ok_or(Error::Overflow)?.height;
            if height < level {
                list.push(Cell::new(place, height)).map_err(|_| Error::PatchSize)?;
            }
        }
        let (rolling_radius, modulus) = (contact.rolling_radius, contact.modulus());
        Ok(Cells { list, width: self.width, rolling_radius, modulus })
    }
}

/// Strips of the lattice for about `count` strips that touch.
const fn lattice_strips(count: StripCount) -> u32 {
    let wanted = match count {
        StripCount::Four => 8,
        StripCount::Eight => 12,
        StripCount::Sixteen => 21,
        StripCount::ThirtyTwo | StripCount::SixtyFour => 36,
    };
    if wanted + 4 < CELLS as u32 { wanted } else { CELLS as u32 - 4 }
}

impl<F: Float> Indentation<F> {
    /// The strips that touch, handed to `take`, and what they carry.
    ///
    /// # Errors
    /// Those of [`Patch::from_profile`].
    pub(crate) fn new(
        profile: &Profile<F>,
        contact: &ProfileContact<F>,
        count: StripCount,
        mut take: impl FnMut(PatchStrip<F>) -> bool,
    ) -> Result<Self, Error> {
        contact.check()?;
        if !(profile.depth() > F::zero()) {
            return Err(Error::ProfileEnd);
        }
        let (Given::Load(given) | Given::Approach(given)) = contact.given;
        if given <= F::zero() {
            let none = F::zero();
            return Ok(Self {
                approach: none,
                normal_force: none,
                stiffness: none,
                peak_pressure: none,
                peak_y: profile.deepest,
                iterations: 0,
            });
        }
        let (first, iterations) = match contact.given {
            Given::Load(load) => profile.guess(contact, load)?,
            Given::Approach(approach) => (approach, 0),
        };
        let half_length = (contact.rolling_radius * first).times(2.0 * SECTION).sqrt();
        let length = if contact.smoothing_length > F::zero() {
            contact.smoothing_length
        } else {
            half_length.times(SMOOTHING).max(profile.step().times(2.0))
        };
        // Coarse
        let strips = lattice_strips(count);
        let level = first.times(GUESS * REACH);
        let lattice = Lattice::new(profile, level, length, strips.min(COARSE), None)
            .ok_or(Error::Overflow)?;
        let above = |lowest: F| match contact.given {
            Given::Load(load) => Given::Load(load),
            Given::Approach(approach) => Given::Approach(approach + lowest),
        };
        let mut coarse = lattice.cells(contact, level + lattice.lowest)?;
        let section = first.times(SECTION) + lattice.lowest;
        let double = contact.rolling_radius.times(2.0);
        coarse.begin(contact.given, first, |cell| (section - cell.distance) * double);
        let approach = coarse.solve(above(lattice.lowest), COARSE_POWER).value;
        if !(approach.is_finite_number() && approach > F::zero()) {
            return Err(Error::Overflow);
        }
        // Fine, its squares of lengths between those of the coarse
        let level = approach.times(REACH);
        let (mut moment, mut sum) = (F::zero(), F::TINY);
        for cell in coarse.list.iter().filter(|cell| cell.touches) {
            let load = cell.half_length.value * (cell.pressure.value / contact.modulus());
            moment += load * (lattice.y(cell.place) - profile.deepest);
            sum += load;
        }
        let middle = Some(profile.deepest + moment / sum);
        let fine = Lattice::new(profile, level, length, strips, middle).ok_or(Error::Overflow)?;
        let mut cells = fine.cells(contact, level)?;
        // (a strip of the coarse lattice that hardly carries is as short as its pressure tells)
        let slope = coarse.mean_slope();
        cells.begin(contact.given, approach, |cell| {
            let between = (fine.y(cell.place) - lattice.y(0)) / lattice.width;
            let near = coarse.list.iter().filter(|cell| cell.touches);
            near.fold(F::zero(), |sum, cell| {
                let share = F::one() - (between - F::of(f64::from(cell.place))).abs();
                let square = cell.half_length.value * (cell.pressure.value / slope);
                sum + square * share.max(F::zero())
            })
        });
        let given = above(fine.lowest);
        let approach = cells.solve(given, FINE_POWER);
        let load = cells.load();
        let stiffness = match given {
            Given::Load(_) => F::one() / approach.slope,
            Given::Approach(_) => load.slope,
        };
        let mut found = Self {
            approach: match contact.given {
                Given::Load(_) => (approach.value - fine.lowest).max(F::zero()),
                Given::Approach(approach) => approach,
            },
            normal_force: load.value,
            stiffness,
            peak_pressure: F::zero(),
            peak_y: profile.deepest,
            iterations,
        };
        let [first, last] = profile.ends().ok_or(Error::Profile)?;
        let results = [found.approach, found.normal_force, found.stiffness];
        if !results.iter().all(|result| result.is_finite_number()) {
            return Err(Error::Overflow);
        }
        for cell in cells.list.iter().filter(|cell| cell.touches) {
            let y = fine.y(cell.place);
            if y - fine.width.times(1.5) < first || y + fine.width.times(1.5) > last {
                return Err(Error::ProfileEnd);
            }
            let strip = PatchStrip {
                y,
                width: fine.width,
                half_length: cell.half_length.value,
                centre_x: F::zero(),
                peak_pressure: cell.pressure.value,
                friction: contact.friction,
            };
            if strip.peak_pressure > found.peak_pressure {
                (found.peak_pressure, found.peak_y) = (strip.peak_pressure, y);
            }
            if !take(strip) {
                return Err(Error::PatchSize);
            }
        }
        Ok(found)
    }
}

impl<F: Precision, const CAPACITY: usize> Patch<F, CAPACITY> {
    /// The patch of two profiles in contact, in about `count` strips of one width, 32 at most.
    ///
    /// # Errors
    /// Those of [`Profile::new`] and [`ProfileContact::check`]; [`Error::ProfileEnd`] when the contact reaches an end of
    /// the profile; [`Error::PatchSize`] when its separate zones need more strips than there are, or the capacity is too
    /// small; [`Error::Overflow`].
    ///
    /// # Example
    /// A wheel of 0.46 m radius on a rail head of 0.30 m:
    /// ```
    /// use kstrip::contact::forces::StripCount;
    /// use kstrip::patch::{Patch, normal::Given, profile::ProfileContact};
    /// let y: [f64; 41] = core::array::from_fn(|i| (i as f64 - 20.0) * 0.5e-3);
    /// let distance = y.map(|y| y * y / (2.0 * 0.30));
    /// let contact = ProfileContact {
    ///     rolling_radius: 0.46, given: Given::Load(80e3), shear_modulus: 82e9, poisson_ratio: 0.28,
    ///     friction: 0.3, smoothing_length: 0.0,
    /// };
    /// let (patch, found) =
    ///     Patch::<f64, 32>::from_profile(&y, &distance, &contact, StripCount::Sixteen)?;
    /// assert!((patch.view()?.normal_force() - 80e3).abs() < 1e-6);
    /// // Hertz: 90.5 µm; dN/dδ = 3 N/(2 δ)
    /// assert!((found.approach - 90.5e-6).abs() < 1e-6 && found.peak_y == 0.0);
    /// assert!((found.stiffness * found.approach / 80e3 - 1.5).abs() < 0.05);
    /// # Ok::<(), kstrip::status::Error>(())
    /// ```
    pub fn from_profile(
        y: &[F],
        distance: &[F],
        contact: &ProfileContact<F>,
        count: StripCount,
    ) -> Result<(Self, Indentation<F>), Error> {
        let profile = Profile::new(y, distance)?;
        let mut patch = Self::empty(contact.shear_modulus, contact.poisson_ratio);
        let found =
            Indentation::new(&profile, contact, count, |strip| patch.strips.push(strip).is_ok())?;
        // Lengths and gaps at the ends of the number range have no digits left.
        let lost = (patch.view()?.normal_force() - found.normal_force).abs();
        if !(lost <= found.normal_force * F::constant(1e-3)) {
            return Err(Error::Overflow);
        }
        Ok((patch, found))
    }
}
