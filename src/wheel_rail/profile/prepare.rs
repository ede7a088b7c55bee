//! From the points of a profile to points at equal steps of its length.
//!
//! 1. [A coarse line](CoarseLine::follow), of few pieces, gives each point its length along the
//!    profile. Points are not assumed to ascend along it.
//! 2. [Averaged points](AveragedPoints) are the points in ascending order of this length, averaged
//!    where they are crowded or scatter, and smoothed where this is asked for.
//! 3. A [curve](Points) leads through the averages, cubic between them.
//! 4. The prepared points are points of the curve at equal chords.

use super::averaged_points::{AveragedPoints, SINGLE};
use super::coarse_line::CoarseLine;
use super::curve::{Chords, Points, distance};
use super::plausibility::ROUGH_AND_COARSE;
use super::{CurvePoint, PreparedProfile};
use crate::number::{Float, are_finite};
use crate::numerics::ramp;
use crate::status::{Error, Warning};
use crate::wheel_rail::KSTRIP_SURFACE_CAPACITY;

/// Shortest extent of a profile, and largest coordinate \[m\].
const SHORTEST_EXTENT: f64 = 1e-6;
const LARGEST_COORDINATE: f64 = 1e3;
/// Attempts with more and more smoothing until chords are equal.
const SMOOTHINGS: i32 = 12;
/// Distance of given points over that of as many points as there is room for, from which a profile
/// may be smoothed by default, and from which it is smoothed over six distances.
const FAR_APART: [f64; 2] = [1.6, 2.2];
const DISTANCES: f64 = 6.0;
/// Distances of points over which a profile is smoothed to tell how rough it is.
const TRIED: f64 = 4.0;
/// Mean distance of the points from that line, over their distance from each other, up to which a
/// profile is as drawn, and from which it is rough: of S1002 and UIC60 drawn with 1 mm between the
/// points 0.0003 to 0.0005, of a wheel with 0.1 mm of shape 0.0023.
const DRAWN: [f64; 2] = [6e-4, 2e-3];
/// Distance from the smoothed line, over the points' distance, above which points are too few.
const ROUGH: f64 = 1e-3;

impl<F: Float> PreparedProfile<F> {
    /// Fills the surface. Points may turn back (those of a measured flange do), run either way
    /// along y, lie at any distances, be scanned twice and scatter; only their order along the
    /// profile counts, and only over distances larger than their scatter. Smoothing replaces every
    /// point by that of the parabola through the points up to the smoothing length `s` away,
    /// weighted with `(1 − (d/s)²)³` and with their spacing. Straight lines and parabolas are not
    /// changed. Without a smoothing length a profile of more than 319 points is not smoothed. One
    /// of fewer than 234 is smoothed over six distances of its points if they are rough: if on
    /// average they lie 0.2 % of their distance or more beside the line that is smoothed over four.
    /// Up to 0.06 % it is not smoothed, and between these numbers over less.
    ///
    /// Returns a warning for a profile that is longer than 1 m, stands upside down or runs the
    /// wrong way.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::Profile`] for fewer than four points, or a
    /// negative step; [`Error::SmoothingLength`]; [`Error::Capacity`] when the step needs more
    /// points than there is room for; [`Error::Overflow`] for a profile smaller than 1 µm or larger
    /// than 1 km; [`Error::Scatter`] for points that no line follows.
    pub fn prepare(
        &mut self, y: &[F], z: &[F], step: F, smoothing_length: F,
    ) -> Result<Warning, Error> {
        check_points(y, z, [step, smoothing_length])?;
        let mut line = CoarseLine::new();
        let radius = line.follow(y, z, extent(y, z)?)?;
        let most = KSTRIP_SURFACE_CAPACITY as i32 - 1;
        let room = F::widened(most as f32);
        let length = line.length();
        let wanted = if step > F::zero() { step } else { length / room };
        Error::Capacity.when(length > wanted * room.plus(0.5))?;
        // From here on nothing fails, and the surface is written.
        let is_reversed = line.is_reversed();
        let given = F::widened((y.len() - 1) as f32);
        let mut averages = AveragedPoints::new(self);
        let (mut smoothing, mut is_rough) = (smoothing_length, false);
        let coarse = ramp(room / given, FAR_APART);
        let is_tried = smoothing <= F::zero() && coarse > F::zero();
        if is_tried {
            averages.collect_points(true, &line, radius, y, z);
            (smoothing, is_rough) = default_smoothing(&averages, &mut line, length / given, coarse);
        }
        let mut chords = Chords { length: wanted, count: 3, are_equal: false };
        if !is_tried && smoothing <= F::zero() && y.len() + 2 <= SINGLE {
            averages.collect_points(false, &line, radius, y, z);
            chords = averages.equal_chords(wanted, most);
        }
        if chords.are_equal {
            // the averages stand where the points go
            line.count = 0;
            averages.walk_in_chords(chords.length, |k, point| {
                line.count = line.count.min(k);
                line.push(F::zero(), point);
            });
            let points = line.points.iter().take(line.count).enumerate();
            points.for_each(|(k, point)| self.set_chord_end(chords.count, is_reversed, k, *point));
        } else {
            if !is_tried {
                averages.collect_points(true, &line, radius, y, z);
            }
            for _ in 0..SMOOTHINGS {
                averages.smooth(smoothing, &mut line);
                chords = line.equal_chords(wanted, most);
                if chords.are_equal {
                    break;
                }
                smoothing = wanted.times(2.0).max(smoothing.times(1.5));
            }
            let put = |k, point| self.set_chord_end(chords.count, is_reversed, k, point);
            line.walk_in_chords(chords.length, put);
        }
        self.step = chords.length;
        self.count = chords.count as u32 + 1;
        self.spacing = chords.length * F::widened(chords.count as f32) / given;
        self.directions();
        self.form = self.what_it_is() + if is_rough { ROUGH_AND_COARSE } else { 0 };
        Ok(self.plausibility())
    }

    /// Puts a point at the end of `k` chords, counted from the beginning or the end.
    fn set_chord_end(&mut self, chords: usize, is_reversed: bool, k: usize, [y, z]: [F; 2]) {
        let k = k.min(chords);
        let k = if is_reversed { chords - k } else { k };
        self.set_point(k, CurvePoint { y, z, cosine: F::zero(), sine: F::zero() });
    }
}

/// # Errors
/// [`Error::Profile`], [`Error::NotFinite`], [`Error::SmoothingLength`].
fn check_points<F: Float>(y: &[F], z: &[F], [step, smoothing]: [F; 2]) -> Result<(), Error> {
    Error::Profile.when(y.len() < 4 || y.len() != z.len())?;
    Error::NotFinite.unless([y, z, &[step, smoothing]].into_iter().all(are_finite))?;
    Error::SmoothingLength.when(smoothing < F::zero())?;
    Error::Profile.when(step < F::zero())
}

/// The distance between the corners of the rectangle around a profile.
fn extent<F: Float>(y: &[F], z: &[F]) -> Result<F, Error> {
    let extents = [y, z].map(|list| {
        let least = list.iter().fold(F::LARGEST, |least, x| least.min(*x));
        let most = list.iter().fold(-F::LARGEST, |most, x| most.max(*x));
        [least, most]
    });
    let [[left, right], [top, bottom]] = extents;
    let farthest = extents.iter().flatten().fold(F::zero(), |most, x| most.max(x.abs()));
    Error::Overflow.when(farthest > F::of(LARGEST_COORDINATE))?;
    let extent = distance([left, top], [right, bottom]);
    Error::Overflow.when(extent < F::of(SHORTEST_EXTENT)).map(|()| extent)
}

/// The smoothing length of a profile of few points, so far apart, and whether between them lies
/// what nobody measured; `coarse` is 0 to 1. The line is overwritten.
fn default_smoothing<F: Float>(
    averages: &AveragedPoints<F>, line: &mut CoarseLine<F>, apart: F, coarse: F,
) -> (F, bool) {
    averages.smooth(apart.times(TRIED), line);
    let [mean, farthest] = averages.distances(line);
    let smoothing = apart.times(DISTANCES) * coarse * ramp(mean / apart, DRAWN);
    (smoothing, farthest > apart.times(ROUGH))
}
