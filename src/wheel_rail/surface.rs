//! A profile at equal steps of its length, with its direction. It is cubic between the points, so that distances have continuous slopes.

use super::KSTRIP_SURFACE_CAPACITY;
use crate::number::{Arithmetic, Float, Strips, are_finite};
use crate::status::Error;

/// Least default of the step \[m\]; the default is the length over the capacity.
const LEAST_STEP: f64 = 0.2e-3;
/// Shortest and longest profile \[m\].
const SHORTEST: f64 = 1e-6;
const LONGEST: f64 = 1e3;
/// Points that are nearer to the last one than this share of the step are passed over, because they add only rounding.
const CROWDED: f64 = 0.02;

/// A profile, prepared by kstrip_prepare_profile(): points at equal steps of its length, toward larger y, and its direction.
/// It holds plain numbers and may be copied.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface<F> {
    /// y \[m\], to the right: of a rail from its origin, of a wheel from its running circle, with the flange at small y.
    pub y: [F; KSTRIP_SURFACE_CAPACITY],
    /// z \[m\], down; of a wheel its radius minus wheel_radius.
    pub z: [F; KSTRIP_SURFACE_CAPACITY],
    /// Derivative of y by the length: the cosine of the profile's angle.
    pub cosine: [F; KSTRIP_SURFACE_CAPACITY],
    /// Derivative of z by the length: the sine of the profile's angle.
    pub sine: [F; KSTRIP_SURFACE_CAPACITY],
    /// Length between two points \[m\].
    pub step: F,
    /// Number of points, 4 to KSTRIP_SURFACE_CAPACITY.
    pub count: u32,
    /// Reserved: zero.
    pub reserved: u32,
}

/// A point of a curve and its derivative by the length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place<F> {
    pub y: F,
    pub z: F,
    pub cosine: F,
    pub sine: F,
}

impl<F: Float> Surface<F> {
    /// Fills the surface. Points may turn back (those of a measured flange do), run either way along y, and lie at any distances;
    /// only their order counts. Smoothing replaces every point by that of the parabola through the points up to the smoothing length `s` away,
    /// weighted with `(1 − (d/s)²)³` and with their spacing. Straight lines and parabolas are not changed.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::Profile`] for fewer than four points, two that coincide, or a negative step;
    /// [`Error::SmoothingLength`]; [`Error::Capacity`] when the step needs more points than there is room for;
    /// [`Error::Overflow`] for a profile shorter than 1 µm or longer than 1 km.
    pub fn prepare(&mut self, y: &[F], z: &[F], step: F, smoothing_length: F) -> Result<(), Error> {
        if y.len() < 4 || y.len() != z.len() {
            return Err(Error::Profile);
        }
        let inputs = y.iter().chain(z).chain([&step, &smoothing_length]);
        if !inputs.into_iter().all(|x| x.is_finite_number()) {
            return Err(Error::NotFinite);
        }
        if smoothing_length < F::zero() {
            return Err(Error::SmoothingLength);
        }
        let points = || y.iter().zip(z).map(|(&y, &z)| [y, z]);
        let mut length = F::zero();
        for (point, next) in points().zip(points().skip(1)) {
            let chord = distance(point, next);
            if chord <= F::zero() {
                return Err(Error::Profile);
            }
            length += chord;
        }
        let room = F::constant(KSTRIP_SURFACE_CAPACITY as f64 - 1.0);
        if step < F::zero() {
            return Err(Error::Profile);
        }
        let farthest = y.iter().chain(z).fold(F::zero(), |most, x| most.max(x.abs()));
        if !(length >= F::of(SHORTEST) && farthest + length <= F::of(LONGEST)) {
            return Err(Error::Overflow);
        }
        let wanted = if step > F::zero() { step } else { (length / room).max(F::of(LEAST_STEP)) };
        if length > wanted * (room + F::of(0.5)) {
            return Err(Error::Capacity);
        }
        let wanted = wanted.min(length.times(1.0 / 3.0));
        let mut raw = Raw::new(y, z, smoothing_length, wanted.times(CROWDED));
        // the length of the smooth curve, which is shorter than that of noisy points
        let cells = 4 * KSTRIP_SURFACE_CAPACITY as i32;
        let (mut smooth, mut last) = (F::zero(), raw.at(F::zero()));
        for k in 1..=cells {
            let place = raw.at(length * (F::widened(k as f32) / F::widened(cells as f32)));
            smooth += distance(last, place);
            last = place;
        }
        let intervals =
            (smooth / wanted).plus(0.5).whole().clamp(3, KSTRIP_SURFACE_CAPACITY as i32 - 1);
        let step = smooth * (F::one() / F::widened(intervals as f32));
        // equal steps of the smooth curve, at its own speed
        raw.begin();
        let reversed = y.last() < y.first();
        let count = intervals as usize + 1;
        let (mut at, fine) = (F::zero(), F::of(1e-2));
        let mut here = raw.at(at);
        for k in 0..count {
            let place = if reversed { count - 1 - k } else { k };
            if let (Some(y), Some(z)) = (self.y.get_mut(place), self.z.get_mut(place)) {
                [*y, *z] = here;
            }
            // two secants to the point one step further on
            let mut advance = step;
            for _ in 0..3 {
                let to = raw.at((at + advance).min(length));
                let gone = distance(here, to);
                advance = advance * (step / gone.max(step * fine));
            }
            at = (at + advance).min(length);
            here = raw.at(at);
        }
        self.step = step;
        self.count = count as u32;
        self.reserved = 0;
        self.directions();
        Ok(())
    }

    /// Derivatives by the length from five points, exact for polynomials of degree four; from three at the ends.
    fn directions(&mut self) {
        let count = self.count as usize;
        for k in 0..count {
            let lines = [(&self.y, &mut self.cosine), (&self.z, &mut self.sine)];
            for (list, slopes) in lines {
                let at = |i: usize| list.get(i).copied().unwrap_or(F::zero());
                let slope = if k >= 2 && k + 2 < count {
                    ((at(k + 1) - at(k - 1)).times(8.0) - (at(k + 2) - at(k - 2))).times(1.0 / 12.0)
                } else if k >= 1 && k + 1 < count {
                    (at(k + 1) - at(k - 1)).times(0.5)
                } else if k == 0 {
                    (at(1) - at(0)).times(2.0) - (at(2) - at(0)).times(0.5)
                } else {
                    (at(k) - at(k - 1)).times(2.0) - (at(k) - at(k - 2)).times(0.5)
                };
                if let Some(place) = slopes.get_mut(k) {
                    *place = slope / self.step;
                }
            }
        }
    }

    /// # Errors
    /// [`Error::NotPrepared`].
    pub(crate) fn check(&self) -> Result<(), Error> {
        let count = self.count as usize;
        let sound = (4..=KSTRIP_SURFACE_CAPACITY).contains(&count)
            && self.step.is_finite_number()
            && self.step > F::zero();
        let lists = [&self.y, &self.z, &self.cosine, &self.sine];
        let finite = lists.iter().all(|list| list.get(..count).is_some_and(are_finite));
        if sound && finite { Ok(()) } else { Err(Error::NotPrepared) }
    }

    /// A point by its number.
    #[inline(always)]
    pub(crate) fn point(&self, k: usize) -> Option<Place<F>> {
        Some(Place {
            y: *self.y.get(k)?,
            z: *self.z.get(k)?,
            cosine: *self.cosine.get(k)?,
            sine: *self.sine.get(k)?,
        })
    }

    /// Points side by side, by their numbers.
    #[inline(always)]
    pub(crate) fn points<P: Strips<F>>(&self, numbers: impl Fn(usize) -> usize) -> Place<P> {
        let of = |list: &[F; KSTRIP_SURFACE_CAPACITY]| {
            P::gather(|i| list.get(numbers(i)).copied().unwrap_or(F::zero()))
        };
        Place { y: of(&self.y), z: of(&self.z), cosine: of(&self.cosine), sine: of(&self.sine) }
    }

    /// The point of the curve at a share of the way from a point to the next.
    pub(crate) fn at(&self, k: usize, share: F) -> Option<Place<F>> {
        let [y, z] = Piece::new(self.point(k)?, self.point(k + 1)?, self.step).at(share);
        let per_step = F::one() / self.step;
        Some(Place { y: y.value, z: z.value, cosine: y.slope * per_step, sine: z.slope * per_step })
    }
}

/// The curve between two points: cubics with the directions of both. The place on it is the share of the way.
pub(crate) struct Piece<T> {
    y: Cubic<T>,
    z: Cubic<T>,
}

/// The coefficients of a cubic, the constant first.
struct Cubic<T>([T; 4]);

/// A number along a piece, with its derivatives.
pub(crate) struct Along<T> {
    pub value: T,
    pub slope: T,
    pub bend: T,
}

impl<T: Arithmetic> Piece<T> {
    #[inline(always)]
    pub(crate) fn new(from: Place<T>, to: Place<T>, step: T) -> Self {
        Self {
            y: Cubic::new([from.y, to.y], [from.cosine * step, to.cosine * step]),
            z: Cubic::new([from.z, to.z], [from.sine * step, to.sine * step]),
        }
    }

    /// y and z at a share of the way.
    #[inline(always)]
    pub(crate) fn at(&self, u: T) -> [Along<T>; 2] {
        [self.y.at(u), self.z.at(u)]
    }
}

impl<T: Arithmetic> Cubic<T> {
    /// From the values and the slopes at 0 and 1.
    #[inline(always)]
    fn new([from, to]: [T; 2], [slope, last]: [T; 2]) -> Self {
        let rise = to - from;
        let cubic = slope + last - (rise + rise);
        Self([from, slope, rise - slope - cubic, cubic])
    }

    #[inline(always)]
    fn at(&self, u: T) -> Along<T> {
        let [value, slope, square, cubic] = self.0;
        let (once, thrice) = (u * cubic, (u * cubic).times(3.0));
        Along {
            value: value + u * (slope + u * (square + once)),
            slope: slope + u * (square + square + thrice),
            bend: (square + thrice) + (square + thrice),
        }
    }
}

fn distance<F: Float>([y, z]: [F; 2], [v, w]: [F; 2]) -> F {
    ((v - y).squared() + (w - z).squared()).sqrt()
}

/// The points as they were given, as a curve over their chord length, read in ascending order.
struct Raw<'a, F> {
    y: &'a [F],
    z: &'a [F],
    smoothing: F,
    /// Points nearer to the last than this are passed over.
    crowded: F,
    /// Where the window begins: a point's number and its chord length.
    first: usize,
    from: F,
}

impl<'a, F: Float> Raw<'a, F> {
    fn new(y: &'a [F], z: &'a [F], smoothing: F, crowded: F) -> Self {
        Self { y, z, smoothing, crowded, first: 0, from: F::zero() }
    }

    fn begin(&mut self) {
        (self.first, self.from) = (0, F::zero());
    }

    /// The points from the window's first one on, with their chord lengths.
    fn points(&self) -> impl Iterator<Item = (usize, F, [F; 2])> + use<'_, 'a, F> {
        let mut last: Option<[F; 2]> = None;
        let mut length = self.from;
        let list = self.y.iter().zip(self.z).enumerate().skip(self.first);
        let end = self.y.len() - 1;
        list.filter_map(move |(i, (&y, &z))| {
            let point = [y, z];
            if let Some(last) = last {
                let chord = distance(last, point);
                if chord < self.crowded && i != end {
                    return None;
                }
                length += chord;
            }
            last = Some(point);
            Some((i, length, point))
        })
    }

    /// The curve at a chord length, not smaller than at the last call by more than the window.
    fn at(&mut self, s: F) -> [F; 2] {
        // the window keeps two points before what is needed
        let begin = s - self.smoothing - self.crowded.times(2.0 / CROWDED);
        let mut before: [Option<(usize, F)>; 2] = [None; 2];
        for (i, length, _) in self.points() {
            if length > begin {
                break;
            }
            let [_, last] = before;
            before = [last, Some((i, length))];
        }
        if let [Some(start), _] = before {
            (self.first, self.from) = start;
        }
        if self.smoothing > F::zero()
            && let Some(smooth) = self.parabola(s)
        {
            return smooth;
        }
        self.interpolated(s)
    }

    /// Least squares over the window.
    fn parabola(&self, s: F) -> Option<[F; 2]> {
        let mut m = [F::zero(); 5];
        let mut sums = [[F::zero(); 3]; 2];
        let mut count = 0;
        let mut add = |length: F, point: [F; 2], spacing: F| {
            let x = (length - s) / self.smoothing;
            let rest = (F::one() - x * x).max(F::zero());
            let mut weight = rest * rest * rest * spacing;
            count += i32::from(weight > F::zero());
            for (j, m) in m.iter_mut().enumerate() {
                *m += weight;
                for (sum, value) in sums.iter_mut().zip(point) {
                    if let Some(sum) = sum.get_mut(j) {
                        *sum += weight * value;
                    }
                }
                weight = weight * x;
            }
        };
        let mut points = self.points();
        let (_, mut before, _) = points.next()?;
        let mut held = self.points().next();
        for next in points {
            if let Some((_, length, point)) = held {
                add(length, point, next.1 - before);
                before = length;
                if length > s + self.smoothing {
                    held = None;
                    break;
                }
            }
            held = Some(next);
        }
        if let Some((_, length, point)) = held {
            add(length, point, length - before);
        }
        let [m0, m1, m2, m3, m4] = m;
        let (c0, c1, c2) = (m2 * m4 - m3 * m3, m2 * m3 - m1 * m4, m1 * m3 - m2 * m2);
        let determinant = m0 * c0 + m1 * c1 + m2 * c2;
        if count < 4 || !(determinant > m0 * m0 * m0.times(1e-6)) {
            return None;
        }
        Some(sums.map(|[s0, s1, s2]| (s0 * c0 + s1 * c1 + s2 * c2) / determinant))
    }

    /// A cubic between two points, with the slopes of parabolas through three.
    fn interpolated(&self, s: F) -> [F; 2] {
        // four points, the place between the middle ones
        let (mut a, mut b, mut c, mut d) = (None, None, None, None);
        let mut inside = false;
        for (_, length, point) in self.points() {
            (a, b, c, d) = (b, c, d, Some((length, point)));
            inside = b.is_some() && c.is_some_and(|(length, _): (F, [F; 2])| s <= length);
            if inside {
                break;
            }
        }
        if !inside {
            (a, b, c, d) = (b, c, d, None);
        }
        let (Some(b), Some(c)) = (b, c) else { return [F::zero(); 2] };
        let chord = |p: (F, [F; 2]), q: (F, [F; 2]), i: usize| {
            let value = |list: [F; 2]| list.get(i).copied().unwrap_or(F::zero());
            (value(q.1) - value(p.1)) / (q.0 - p.0)
        };
        let width = c.0 - b.0;
        let u = ((s - b.0) / width).clamped(F::zero(), F::one());
        let along = |i: usize, start: F| {
            let middle = chord(b, c, i);
            // slope of the parabola: chords weighted with each other's lengths
            let slope = |other: Option<(F, [F; 2])>| {
                other.map_or(middle, |other| {
                    let (chord, length) = if other.0 < b.0 {
                        (chord(other, b, i), b.0 - other.0)
                    } else {
                        (chord(c, other, i), other.0 - c.0)
                    };
                    (middle * length + chord * width) / (length + width)
                })
            };
            let (from, to) = (slope(a) * width, slope(d) * width);
            let rise = middle * width;
            let cubic = from + to - rise.times(2.0);
            start + u * (from + u * (rise - from - cubic + u * cubic))
        };
        let [y, z] = b.1;
        [along(0, y), along(1, z)]
    }
}
