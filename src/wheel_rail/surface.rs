//! A profile at equal steps of its length, with its direction. It is cubic between the points, so
//! that distances have continuous slopes.

use super::KSTRIP_SURFACE_CAPACITY;
use crate::number::{Arithmetic, Float, Strips, are_finite};
use crate::status::Error;

/// Least default of the step \[m\]; the default is the length over the capacity.
const LEAST_STEP: f64 = 0.2e-3;
/// Shortest and longest profile \[m\].
const SHORTEST: f64 = 1e-6;
const LONGEST: f64 = 1e3;
/// Points that are nearer to the last one than this share of the step are passed over, because they
/// add only rounding.
const CROWDED: f64 = 0.02;

/// A profile, prepared by kstrip_prepare_profile(): points at equal steps of its length, toward
/// larger y, and its direction. It holds plain numbers and may be copied.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface<F> {
    /// y \[m\], to the right: of a rail from its origin, of a wheel from its running circle, with
    /// the flange at small y.
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
    /// Fills the surface. Points may turn back (those of a measured flange do), run either way
    /// along y, and lie at any distances; only their order counts. Smoothing replaces every point
    /// by that of the parabola through the points up to the smoothing length `s` away, weighted
    /// with `(1 − (d/s)²)³` and with their spacing. Straight lines and parabolas are not changed.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::Profile`] for fewer than four points, two that coincide, or a
    /// negative step; [`Error::SmoothingLength`]; [`Error::Capacity`] when the step needs more
    /// points than there is room for; [`Error::Overflow`] for a profile shorter than 1 µm or longer
    /// than 1 km.
    pub fn prepare(&mut self, y: &[F], z: &[F], step: F, smoothing_length: F) -> Result<(), Error> {
        if y.len() < 4 || y.len() != z.len() {
            return Err(Error::Profile);
        }
        if ![y, z, &[step, smoothing_length]].into_iter().all(are_finite) {
            return Err(Error::NotFinite);
        }
        if smoothing_length < F::zero() {
            return Err(Error::SmoothingLength);
        }
        let mut length = F::zero();
        let points = || y.iter().zip(z).map(|(&y, &z)| [y, z]);
        for (point, next) in points().zip(points().skip(1)) {
            let chord = distance(point, next);
            if chord <= F::zero() {
                return Err(Error::Profile);
            }
            length += chord;
        }
        if step < F::zero() {
            return Err(Error::Profile);
        }
        let farthest = y.iter().chain(z).fold(F::zero(), |most, x| most.max(x.abs()));
        if !(length >= F::of(SHORTEST) && farthest + length <= F::of(LONGEST)) {
            return Err(Error::Overflow);
        }
        let room = F::constant(KSTRIP_SURFACE_CAPACITY as f64 - 1.0);
        let wanted = if step > F::zero() { step } else { (length / room).max(F::of(LEAST_STEP)) };
        if length > wanted * (room + F::of(0.5)) {
            return Err(Error::Capacity);
        }
        let wanted = wanted.min(length.times(1.0 / 3.0));
        let crowded = wanted.times(CROWDED);
        let begin = Raw { y, z, smoothing: smoothing_length, crowded, first: 0, from: F::zero() };
        // the length of the smooth curve, which is shorter than that of noisy points
        let cells = 4 * KSTRIP_SURFACE_CAPACITY as i32;
        let mut raw = begin;
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
        let mut raw = begin;
        let reversed = y.last() < y.first();
        let count = intervals as usize + 1;
        let (mut at, fine) = (F::zero(), F::of(1e-2));
        for k in 0..count {
            let here = raw.at(at);
            let place = if reversed { count - 1 - k } else { k };
            if let (Some(y), Some(z)) = (self.y.get_mut(place), self.z.get_mut(place)) {
                [*y, *z] = here;
            }
            // three secants to the point one step further on
            let mut advance = step;
            for _ in 0..3 {
                let gone = distance(here, raw.at((at + advance).min(length)));
                advance = advance * (step / gone.max(step * fine));
            }
            at = (at + advance).min(length);
        }
        self.step = step;
        self.count = count as u32;
        self.reserved = 0;
        self.directions();
        Ok(())
    }

    /// Derivatives by the length from five points, exact for polynomials of degree four; from three
    /// at the ends.
    fn directions(&mut self) {
        let count = self.count as usize;
        for (list, slopes) in [(&self.y, &mut self.cosine), (&self.z, &mut self.sine)] {
            let at = |i: usize| list.get(i).copied().unwrap_or(F::zero());
            for (k, slope) in slopes.iter_mut().enumerate().take(count) {
                let rise = match (k, count - 1 - k) {
                    (0, _) => (at(1) - at(0)).times(2.0) - (at(2) - at(0)).times(0.5),
                    (_, 0) => (at(k) - at(k - 1)).times(2.0) - (at(k) - at(k - 2)).times(0.5),
                    (1, _) | (_, 1) => (at(k + 1) - at(k - 1)).times(0.5),
                    _ => {
                        let (near, far) = (at(k + 1) - at(k - 1), at(k + 2) - at(k - 2));
                        (near.times(8.0) - far).times(1.0 / 12.0)
                    }
                };
                *slope = rise / self.step;
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

/// The curve between two points: cubics with the directions of both. The place on it is the share
/// of the way.
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

/// A point of a list, and the length of the chords up to it.
type Knot<F> = (F, [F; 2]);

/// The points as they were given, as a curve over their chord length, read in ascending order.
#[derive(Clone, Copy)]
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
    /// The points from the window's first one on, with their numbers.
    fn points(&self) -> impl Iterator<Item = (usize, Knot<F>)> + use<'_, 'a, F> {
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
            Some((i, (length, point)))
        })
    }

    /// The same points in second place, each with the one before and the next two.
    fn fours(&self) -> impl Iterator<Item = [Option<Knot<F>>; 4]> + use<'_, 'a, F> {
        let mut four = [None; 4];
        let points = self.points().map(|(_, knot)| Some(knot)).chain([None; 2]);
        let moved = points.map(move |next| {
            let [_, b, c, d] = four;
            four = [b, c, d, next];
            four
        });
        moved.skip(2)
    }

    /// The curve at a chord length, not smaller than at the last call by more than the window.
    fn at(&mut self, s: F) -> [F; 2] {
        // the window keeps two points before what is needed
        let begin = s - self.smoothing - self.crowded.times(2.0 / CROWDED);
        let mut points = self.points();
        let (mut start, mut second) = (points.next(), points.next());
        for third in points.take_while(|(_, (length, _))| *length <= begin) {
            (start, second) = (second, Some(third));
        }
        if let Some((first, (from, _))) = start {
            (self.first, self.from) = (first, from);
        }
        let smooth = if self.smoothing > F::zero() { self.parabola(s) } else { None };
        smooth.unwrap_or_else(|| self.interpolated(s))
    }

    /// Least squares over the window.
    fn parabola(&self, s: F) -> Option<[F; 2]> {
        let mut m = [F::zero(); 5];
        let mut sums = [[F::zero(); 3]; 2];
        let mut count = 0;
        for [before, here, next, _] in self.fours() {
            let (length, point) = here?;
            let [from, to] = [before, next].map(|knot| knot.map_or(length, |(length, _)| length));
            let x = (length - s) / self.smoothing;
            let rest = (F::one() - x * x).max(F::zero());
            let mut weight = rest * rest * rest * (to - from);
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
            if x > F::one() {
                break;
            }
        }
        let [m0, m1, m2, m3, m4] = m;
        let (c0, c1, c2) = (m2 * m4 - m3 * m3, m2 * m3 - m1 * m4, m1 * m3 - m2 * m2);
        let determinant = m0 * c0 + m1 * c1 + m2 * c2;
        if count < 4 || !(determinant > m0 * m0 * m0.times(1e-6)) {
            return None;
        }
        Some(sums.map(|[s0, s1, s2]| (s0 * c0 + s1 * c1 + s2 * c2) / determinant))
    }

    /// A cubic between two points, with the slopes of parabolas through three; beyond the last
    /// point this point.
    fn interpolated(&self, s: F) -> [F; 2] {
        let mut end = [F::zero(); 2];
        for [before, from, to, after] in self.fours() {
            let Some(from) = from else { break };
            let Some(to) = to.filter(|(length, _)| s <= *length) else {
                end = from.1;
                continue;
            };
            let chord = |(from, [y, z]): Knot<F>, (to, [v, w]): Knot<F>| {
                [v - y, w - z].map(|rise| rise / (to - from))
            };
            let (middle, width) = (chord(from, to), to.0 - from.0);
            // slope of the parabola: chords weighted with each other's lengths
            let place = |(at, [y, z]): Knot<F>, other: Option<Knot<F>>| {
                let [cosine, sine] = other.map_or(middle, |other| {
                    let length = (other.0 - at).abs();
                    let [[a, b], [c, d]] = [middle, chord((at, [y, z]), other)];
                    [[a, c], [b, d]]
                        .map(|[own, other]| (own * length + other * width) / (length + width))
                });
                Place { y, z, cosine, sine }
            };
            let u = ((s - from.0) / width).clamped(F::zero(), F::one());
            return Piece::new(place(from, before), place(to, after), width)
                .at(u)
                .map(|along| along.value);
        }
        end
    }
}
