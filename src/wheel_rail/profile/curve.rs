//! A curve through points, and equal chords of it.

use crate::number::Float;
use crate::numerics::hermite::between_parabolas;
use crate::wheel_rail::KSTRIP_SURFACE_CAPACITY;

/// Places of the curve between which the ends of chords are looked for: four for each chord.
const CHORD_PLACES: i32 = 4 * KSTRIP_SURFACE_CAPACITY as i32;
/// Least number of chords.
const FEWEST: i32 = 3;
/// Rounds that find the end of a chord.
const CHORD_ROUNDS: i32 = 3;
/// Rounds that make the last chord as long as the others, and the largest difference of a chord, as
/// a share.
const ROUNDS_OF_ALL: i32 = 5;
const UNEQUAL: f64 = 0.1;
/// Difference from which the chords of the length that was found last are examined.
const UNEVEN: f64 = 1e-3;

/// Distance of two points.
pub(super) fn distance<F: Float>([y, z]: [F; 2], [v, w]: [F; 2]) -> F {
    ((v - y).squared() + (w - z).squared()).sqrt()
}

/// Equal chords of a curve.
#[derive(Clone, Copy)]
pub(super) struct Chords<F> {
    pub length: F,
    pub count: usize,
    /// Whether all of them are about as long. They are not where the curve runs to a point beside
    /// the others and back.
    pub are_equal: bool,
}

/// Points with lengths, which ascend, and the curve through them: cubics with the slopes of the
/// parabolas through three of them.
pub(super) trait Points<F: Float> {
    fn count(&self) -> usize;
    /// Length and point, by the number of the point.
    fn get(&self, k: usize) -> Option<(F, [F; 2])>;

    /// A point of the curve by its length, which lies between a point and the next or before.
    fn point_at(&self, mut k: usize, length: F) -> [F; 2] {
        let get = |k: usize| self.get(k);
        while k > 0 && get(k).is_some_and(|(from, _)| from > length) {
            k -= 1;
        }
        let (Some(from), Some(to)) = (get(k), get(k + 1)) else {
            return get(k).map_or([F::zero(); 2], |(_, point)| point);
        };
        let beside = [k.checked_sub(1), Some(k + 2)].map(|k| get(k?));
        let (point, _) = between_parabolas([from, to], beside, F::zero(), length);
        point
    }

    /// Places of the curve: length, number of the point before, place.
    fn places_along(&self) -> impl Iterator<Item = (F, usize, [F; 2])> {
        let end = |k: usize| self.get(k).map_or(F::zero(), |(length, _)| length);
        let count = self.count();
        let (from, to) = (end(0), end(count.saturating_sub(1)));
        let each = (to - from) / F::widened(CHORD_PLACES as f32);
        let mut k = 0;
        (0..=CHORD_PLACES).map(move |i| {
            let length = from + each * F::widened(i as f32);
            while k + 2 < count && self.get(k + 1).is_some_and(|(next, _)| next <= length) {
                k += 1;
            }
            (length, k, self.point_at(k, length))
        })
    }

    fn curve_length(&self) -> F {
        let mut last = None;
        self.places_along().fold(F::zero(), |sum, (_, _, place)| {
            sum + last.replace(place).map_or(F::zero(), |last| distance(last, place))
        })
    }

    /// At most so many equal chords, of the requested length or a little shorter.
    fn equal_chords(&self, wanted: F, most: i32) -> Chords<F> {
        let wanted = wanted.min(self.curve_length().times(1.0 / f64::from(FEWEST)));
        let chords = self.walk_in_chords(wanted, |_, _| ());
        let count = chords.plus(0.5).whole().clamp(FEWEST, most);
        let whole = F::widened(count as f32);
        let mut length = wanted * (chords / whole);
        // the largest difference of a chord from the others, the last excepted, as a share
        let walk = |length: F| {
            let (mut begin, mut unequal) = (None::<[F; 2]>, F::zero());
            let chords = self.walk_in_chords(length, |k, end| {
                let own = begin.replace(end).map_or(length, |begin| distance(begin, end));
                if k < count as usize {
                    unequal = unequal.max((own / length).plus(-1.0).abs());
                }
            });
            (chords, unequal.max((chords - whole).abs()))
        };
        let mut unequal = F::zero();
        for _ in 0..ROUNDS_OF_ALL {
            let chords;
            (chords, unequal) = walk(length);
            length = length * (chords / whole);
        }
        if unequal > F::of(UNEVEN) {
            // a slightly different length may lead to other chords
            (_, unequal) = walk(length);
        }
        let are_equal = unequal < F::of(UNEQUAL);
        Chords { length, count: count as usize, are_equal }
    }

    /// Goes along the curve in chords of one length, and returns how many there are, the last one
    /// in part. Passes on where they begin and where the curve ends, with the number of the chord.
    fn walk_in_chords(&self, chord: F, mut found: impl FnMut(usize, [F; 2])) -> F {
        let mut places = self.places_along();
        let Some((mut before, _, mut begin)) = places.next() else { return F::zero() };
        found(0, begin);
        let (mut count, mut end, mut gone) = (0, begin, F::zero());
        for (length, k, place) in places {
            let mut reached = distance(begin, place);
            if reached >= chord {
                // the chord ends between the last place and this one
                let (mut low, mut high, mut beyond) = ((before, gone), length, reached);
                let mut last = place;
                for _ in 0..CHORD_ROUNDS {
                    let (from, gone) = low;
                    let share = (chord - gone) / (beyond - gone).max(F::TINY);
                    let middle = from + (high - from) * share.clamped(F::zero(), F::one());
                    last = self.point_at(k, middle);
                    let reached = distance(begin, last);
                    if reached < chord {
                        low = (middle, reached);
                    } else {
                        (high, beyond) = (middle, reached);
                    }
                }
                count += 1;
                begin = last;
                found(count, begin);
                reached = distance(begin, place);
            }
            (before, gone, end) = (length, reached, place);
        }
        // the end of the curve is that of the last chord, or of one more that is nearly whole
        let rest = gone / chord;
        found(if rest.plus(-0.5) > F::zero() { count + 1 } else { count }, end);
        F::widened(count as f32) + rest
    }
}
