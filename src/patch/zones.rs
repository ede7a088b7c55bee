//! The equivalent ellipse of a strip and of the strips that it is connected with.
//!
//! The model STRIP needs an axis ratio. The zone of a strip has all strips that are reached from it
//! without passing a neck. Strips beyond a neck count with a weight, which is 1 where the neck is
//! at least 0.85 of the smaller of the two parts that it connects, and 0 below 0.55. A patch that
//! is pinched therefore separates without a jump, and a strip in the neck belongs to both sides.
//!
//! The **equivalent ellipse** has the load and the friction of the zone and follows from means
//! weighted with load. On an ellipse `∫ C² l² dY/∫ C² dY = (4/5) a²` and likewise for the peak
//! pressure, therefore
//!
//! ```text
//! a² = (5/4) Σ N l²/Σ N,   p₀² = (5/4) Σ N p²/Σ N,   N = (2/3) π a b p₀
//! (x₀, y₀) = Σ N (x, y)/Σ N,   μ = Σ μ N/Σ N
//! ```
//!
//! Every strip counts by its load, so that a strip that begins to touch changes nothing at first.
//!
//! The **flexibility of a strip** is that of a strip of the ellipse if `l/p₀` is the same for all
//! strips, as on an ellipse. Otherwise its neighbours load it more or less than those of a strip of
//! the ellipse, in the tangential problem as in the normal one, whose kernels are alike:
//!
//! ```text
//! s = l/p₀,  s̄ = Σ N s/Σ N,  w = 1/(1 + (a/(5 b))²)
//! L_y = 1 + w (s/s̄ − 1),  L_x = (1 + L_y)/2
//! ```
//!
//! Solutions of the linear problem on half-spaces (Boussinesq and Cerruti) on the strips of the
//! patches of `tests/data/real` and `tests/data/patches` have flexibilities `∝ s^0.6` along `x`,
//! and along `y` `∝ s^1.1` if `a/b` is 0.7, falling to `s^0.6` if it is 6. The mean of each over
//! the zone, weighted with load, is 1.

use crate::contact::Contact;
use crate::number::{Float, pairs};
use crate::numerics::smooth_step;
use crate::patch::sizes::Sizes;
use crate::patch::{PatchStrip, PatchView};
use core::f64::consts::PI;

/// Width of a neck over the smaller part: no connection below, full connection above.
const NECK_WIDTH: f64 = 0.55;
const WHOLE: f64 = 0.85;
/// Gap between neighbours over a strip's width where the connection weakens, and where it ends.
const TOUCHING: f64 = 0.5;
const GAP: f64 = 1.0;

/// The equivalent ellipse of a strip's zone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Zone<F> {
    /// `x` \[m\] of its centre.
    pub x: F,
    /// `y` \[m\].
    pub y: F,
    /// The ellipse.
    pub contact: Contact<F>,
    /// Half length divided by peak pressure, the mean of the strips weighted with load \[m/Pa\];
    /// zero without load.
    pub length_by_pressure: F,
}

/// Sums over connected strips.
#[derive(Clone, Copy, Default)]
struct ZoneSums<F> {
    load: F,
    bound: F,
    square: F,
    /// `x` and `y`
    centre: [F; 2],
    /// `N p²`
    pressure: F,
    /// `w l p`
    volume: F,
    /// `w l²`
    length: F,
}

impl<F: Float> ZoneSums<F> {
    /// Adds a strip; lengths and widths in the units of the patch, places from its middle.
    fn add(&mut self, strip: &PatchStrip<F>, units: &Sizes<F>, centre_x: F, weight: F) {
        let load = strip.load() * weight;
        let x = (strip.centre_x - centre_x) * units.per_length;
        let length = strip.half_length * units.per_length;
        let y = (strip.y - units.y) * units.per_width;
        let pressure = strip.peak_pressure * units.per_pressure;
        self.load += load;
        self.bound += load * strip.friction;
        self.square += load * length * length;
        let [sum_x, sum_y] = &mut self.centre;
        *sum_x += load * x;
        *sum_y += load * y;
        self.pressure += load * pressure * pressure;
        let area = weight * (strip.width * units.per_width) * length;
        self.volume += area * pressure;
        self.length += area * length;
    }
}

/// A walk away from a strip: the longest on the way, the shortest since, the weight that is left.
struct Walk<F> {
    peak: F,
    neck: F,
    weight: F,
    /// One over the width of a strip of the patch.
    per_width: F,
}

impl<F: Float> Walk<F> {
    fn new(strip: &PatchStrip<F>, per_width: F) -> Self {
        Self { peak: strip.half_length, neck: strip.half_length, weight: F::one(), per_width }
    }

    fn weight_of(&mut self, last: &PatchStrip<F>, next: &PatchStrip<F>) -> F {
        let l = next.half_length;
        self.neck = self.neck.min(l);
        let smaller = self.peak.min(l);
        // The gap counts, not the distance of the middles, which depends on the strips' width.
        let gap = (next.y - last.y).abs() - (next.width + last.width).times(0.5);
        let gap = gap * self.per_width;
        if self.neck < smaller.times(WHOLE) || gap > F::of(TOUCHING) {
            let share = (self.neck / smaller).plus(-NECK_WIDTH).times(1.0 / (WHOLE - NECK_WIDTH));
            let near = (F::of(GAP) - gap).times(1.0 / (GAP - TOUCHING));
            let share = share.min(near).clamped(F::zero(), F::one());
            self.weight = self.weight.min(smooth_step(share));
        }
        if l > self.peak {
            (self.peak, self.neck) = (l, l);
        }
        self.weight
    }
}

impl<F: Float> Zone<F> {
    /// Whether two zones are equal up to rounding.
    pub(crate) fn nearly_equals(&self, other: &Self) -> bool {
        let near = |x: F, y: F, size: F| (x - y).abs() <= size * F::EPSILON.times(32.0);
        let (one, two) = (&self.contact, &other.contact);
        near(one.a, two.a, one.a)
            && near(one.b, two.b, one.b)
            && near(one.normal_force, two.normal_force, one.normal_force)
            && near(one.friction, two.friction, one.friction)
            && near(self.x, other.x, self.x.abs() + one.a)
            && near(self.y, other.y, self.y.abs() + one.b)
            && near(self.length_by_pressure, other.length_by_pressure, self.length_by_pressure)
    }
}

impl<F: Float> PatchView<'_, F> {
    /// The zone of all strips, if no neck and no gap divides the patch.
    pub(crate) fn only_zone(&self) -> Option<Zone<F>> {
        let strips = self.strips();
        let units = &self.sizes;
        let first = strips.first()?;
        let mut walk = Walk::new(first, units.widths.per_width);
        let mut sums = ZoneSums::default();
        let mut last = first;
        for strip in strips {
            if walk.weight_of(last, strip) < F::one() {
                return None;
            }
            sums.add(strip, units, first.centre_x, F::one());
            last = strip;
        }
        Some(self.zone_of(&sums, first))
    }

    /// The first known zone of a list.
    pub(crate) fn find_zone<R>(&self, of: impl Fn(&Zone<F>) -> Option<R>) -> Option<R> {
        match &self.whole {
            Some(zone) => of(zone),
            None => self.zones().find_map(|zone| of(&zone)),
        }
    }

    /// The zones of all strips; the strips of a lobe that have the same zone share one.
    pub(crate) fn zones(&self) -> impl Iterator<Item = Zone<F>> {
        self.lobes_and_zones().flat_map(move |(first, lobe, of_lobe)| {
            let count = if of_lobe.is_some() { 1 } else { lobe.len() };
            (0..count).filter_map(move |i| of_lobe.or_else(|| self.zone(first + i)))
        })
    }

    /// The zone of the strip with this index; `None` beyond the last.
    #[must_use]
    pub fn zone(&self, number: usize) -> Option<Zone<F>> {
        match &self.whole {
            Some(zone) => (number < self.strips().len()).then_some(*zone),
            None => self.zone_around(number),
        }
    }

    /// The zone of the lobe from this index on, if no neck divides it and no other lobe is near.
    pub(crate) fn zone_of_lobe(&self, number: usize, lobe: &[PatchStrip<F>]) -> Option<Zone<F>> {
        let per_width = self.sizes.widths.per_width;
        let (first, last) = (lobe.first()?, lobe.last()?);
        let before = number.checked_sub(1).and_then(|i| self.strips().get(i));
        let after = self.strips().get(number + lobe.len());
        let near = |one: Option<&PatchStrip<F>>, two: &PatchStrip<F>| {
            one.is_some_and(|one| Walk::new(one, per_width).weight_of(one, two) > F::zero())
        };
        let mut walk = Walk::new(first, per_width);
        let mut pairs = pairs(lobe);
        let whole = pairs.all(|(last, next)| walk.weight_of(last, next) >= F::one());
        let alone = whole && !near(before, first) && !near(after, last);
        // Strips without load have no common ellipse.
        let zone = if alone { self.zone_around(number)? } else { return None };
        (zone.contact.normal_force > F::zero()).then_some(zone)
    }

    fn zone_around(&self, number: usize) -> Option<Zone<F>> {
        let strips = self.strips();
        let (before, rest) = strips.split_at_checked(number)?;
        let (own, after) = rest.split_first()?;
        let units = &self.sizes;
        let mut sums = ZoneSums::default();
        sums.add(own, units, own.centre_x, F::one());
        let mut add = |strips: &mut dyn Iterator<Item = &PatchStrip<F>>| {
            let (mut walk, mut last) = (Walk::new(own, units.widths.per_width), own);
            for strip in strips {
                let weight = walk.weight_of(last, strip);
                sums.add(strip, units, own.centre_x, weight);
                if !(weight > F::zero()) {
                    break;
                }
                last = strip;
            }
        };
        add(&mut before.iter().rev());
        add(&mut after.iter());
        Some(self.zone_of(&sums, own))
    }

    /// The zone of a strip from the sums over all that it is connected with.
    fn zone_of(&self, sums: &ZoneSums<F>, own: &PatchStrip<F>) -> Zone<F> {
        let zero = F::zero();
        let units = &self.sizes;
        let Sizes { per_length, per_width, .. } = *units;
        let ZoneSums { load, bound, square, centre: [x, y], pressure, .. } = *sums;
        let ZoneSums { volume, length: lengths, .. } = *sums;
        // Smaller products have no digits left; such a zone carries no load.
        let has_digits = |sum: F| sum.times(1e-6) > F::TINY;
        let loaded = has_digits(load) && has_digits(square) && has_digits(pressure);
        let load = if loaded { load } else { zero };
        let mean = |sum: F, own: F| if loaded { sum / load } else { own };
        let length = own.half_length * per_length;
        let y = mean(y, (own.y - units.y) * per_width);
        // a² = (5/4) Σ N l²/Σ N, p₀² = (5/4) Σ N p²/Σ N
        let a = mean(square, length * length).times(1.25).sqrt();
        let p0 = mean(pressure, F::zero()).times(1.25).sqrt();
        // b = 3 N/(2 π a p₀), the load being (π/2) Σ w l p
        let b = if loaded {
            (volume / (a * p0)).times(0.75)
        } else {
            (length * (own.width * per_width) / a).times(2.0 / PI)
        };
        let contact = Contact {
            a: units.length * a,
            b: units.width * b,
            normal_force: load,
            shear_modulus: self.shear_modulus(),
            poisson_ratio: self.poisson_ratio(),
            friction: mean(bound, own.friction),
            mismatch: self.mismatch(),
        };
        let (x, y) = (own.centre_x + units.length * mean(x, zero), units.y + units.width * y);
        // Σ N l/p / Σ N, N ∝ w l p
        let length_by_pressure =
            if loaded { units.length * (lengths / volume) * units.per_pressure } else { zero };
        Zone { x, y, contact, length_by_pressure }
    }
}
