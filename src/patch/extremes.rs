//! Least and largest numbers of the strips of a patch.

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
