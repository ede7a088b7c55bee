//! The sizes of a patch: the extremes of its strips, and their widths.

use crate::number::Float;
use crate::patch::PatchStrip;

/// The least and the largest of each number of the strips, and their sum.
pub(super) struct Extremes<F> {
    pub(super) least: [F; 6],
    pub(super) most: [F; 6],
    pub(super) sum: [F; 6],
}

impl<F: Float> Extremes<F> {
    pub(super) fn new(strips: &[PatchStrip<F>]) -> Self {
        let (least, most) = ([F::LARGEST; 6], [-F::LARGEST; 6]);
        let mut own = Self { least, most, sum: [F::zero(); 6] };
        for strip in strips {
            let numbers = strip.numbers();
            let places = own.least.iter_mut().zip(&mut own.most).zip(&mut own.sum);
            for (((least, most), sum), number) in places.zip(numbers) {
                *least = number.min(*least);
                *most = number.max(*most);
                *sum += number;
            }
        }
        own
    }

    /// Whether the sizes are usual, 1 nm to 1 m and up to TPa: then no check can fail.
    pub(super) fn are_usual(&self) -> bool {
        let (zero, one, small) = (F::zero(), F::one(), F::of(1e-9));
        let nearest = [-one, small, small, -one, zero, zero];
        let farthest = [one, one, one, one, F::of(1e12), F::of(5.0)];
        let within = |numbers: &[F; 6]| {
            let bounds = nearest.iter().zip(&farthest);
            numbers.iter().zip(bounds).all(|(x, (low, high))| x.lies_between(*low, *high))
        };
        // NaN is neither the least nor the largest.
        within(&self.least)
            && within(&self.most)
            && self.sum.iter().all(|sum| sum.is_finite_number())
    }
}

/// The sizes of a patch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sizes<F> {
    /// The longest half length \[m\].
    pub length: F,
    /// The whole width \[m\].
    pub width: F,
    /// One over the longest half length, the largest pressure and the whole width.
    pub per_length: F,
    pub per_pressure: F,
    pub per_width: F,
    /// The middle \[m\].
    pub y: F,
    /// Upper bound of the distance of the points from the origin \[m\].
    pub reach: F,
    /// Numbers from the widths of all strips.
    pub widths: Widths<F>,
}

impl<F: Float> Sizes<F> {
    /// `is_rule`: whether the strips are a rule of Gauss.
    pub fn new(strips: &[PatchStrip<F>], extremes: &Extremes<F>, is_rule: bool) -> Self {
        let [leftmost, .., rearmost, _, _] = extremes.least;
        let [rightmost, widest, length, foremost, pressure, _] = extremes.most;
        let [widest, length, pressure] = [widest, length, pressure].map(|most| most.max(F::TINY));
        let [low, high] = match (strips.first(), strips.last()) {
            (Some(first), Some(last)) => {
                [first.y - first.width.times(0.5), last.y + last.width.times(0.5)]
            }
            _ => [F::zero(), F::one()],
        };
        let width = high - low;
        let [per_length, per_pressure, per_width] =
            [length, pressure, width].map(|unit| F::one() / unit);
        let y = low.times(0.5) + high.times(0.5);
        let farthest = |least: F, most: F| most.max(-least).max(F::zero());
        let reach = farthest(leftmost, rightmost) + farthest(rearmost, foremost) + length;
        let widths = Widths::new(strips, widest, is_rule);
        Self { length, width, per_length, per_pressure, per_width, y, reach, widths }
    }
}

/// Widths of the strips of a lobe or a patch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Widths<F> {
    /// Reciprocal of the width of a strip: the mean weighted with width, which very narrow strips
    /// do not change \[1/m\].
    pub per_width: F,
    /// The same number; for a rule of Gauss the reciprocal of the mean of the strips \[1/m\].
    pub per_mean: F,
    /// Whether the strips are a rule of Gauss, in which they alternate between two kinds of nodes
    /// along their lengths. Other strips each have half of both kinds, so that a strip added at the
    /// rim does not swap the kinds of all others.
    pub alternate: bool,
}

impl<F: Float> Widths<F> {
    /// Those of a lobe of a rule of Gauss.
    pub(crate) fn of_rule(strips: &[PatchStrip<F>]) -> Self {
        let widest = strips.iter().fold(F::TINY, |widest, strip| widest.max(strip.width));
        Self::new(strips, widest, true)
    }

    /// `widest` is the largest width.
    fn new(strips: &[PatchStrip<F>], widest: F, is_rule: bool) -> Self {
        let (mut count, mut sum, mut squares) = (F::zero(), F::TINY, F::TINY);
        let per_widest = F::one() / widest;
        for strip in strips {
            let width = strip.width * per_widest;
            count += F::one();
            sum += width;
            squares += width * width;
        }
        let per_width = sum / squares * per_widest;
        let per_mean = if is_rule { count / sum * per_widest } else { per_width };
        Self { per_width, per_mean, alternate: is_rule }
    }
}
