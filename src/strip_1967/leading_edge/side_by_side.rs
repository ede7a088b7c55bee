//! The adhesion intervals of several contacts at once, each in its lane, with the bits of one by one.

use super::{AdhesionInterval, AdhesionLength, CLOSE, EdgePoint, StripFamily, TANGENT_STEPS};
use crate::number::lanes::Lanes;
use crate::number::{Arithmetic, Choice, Pair, Stored};

impl<T: Copy> AdhesionInterval<T> {
    /// Without a length.
    #[inline(always)]
    fn of(point: EdgePoint<T>) -> Self {
        Self { lower: point, upper: point }
    }
}

/// Adhesion intervals, each in its lane. Without one, both ends are the strip nearest to adhesion if there is spin.
pub(crate) struct Intervals<L> {
    /// Positive where there is one.
    pub adheres: L,
    /// Their ends.
    pub ends: AdhesionInterval<L>,
}

impl<L> StripFamily<L> {
    /// The families one by one.
    fn one_by_one<const N: usize>(&self) -> impl Iterator<Item = StripFamily<Stored<L>>>
    where
        L: Lanes<N>,
    {
        let Self { xi, slope, eta, psi } = *self;
        let mut each = [xi, slope, eta, psi].map(|lanes| lanes.array().into_iter());
        core::iter::from_fn(move || {
            let [xi, slope, eta, psi] = each.each_mut().map(Iterator::next);
            Some(StripFamily { xi: xi?, slope: slope?, eta: eta?, psi: psi? })
        })
    }

    /// The families without spin where it reaches one, or comes so near to it that (5.41) needs its other form; and a
    /// number that is positive elsewhere.
    #[inline(always)]
    pub(crate) fn within_unit_spin<const N: usize>(&self) -> (Self, L)
    where
        L: Lanes<N>,
    {
        let q = (L::one() - self.psi) * (L::one() + self.psi);
        let near = L::constant(Self::CANCELLING) - q;
        let psi = near.choose(L::zero(), self.psi);
        (Self { psi, ..*self }, near.choose(-L::one(), L::one()))
    }

    /// [`StripFamily::adhesion_interval`] of all of them, within unit spin.
    #[inline(always)]
    pub(crate) fn adhesion_intervals<const N: usize>(&self) -> Intervals<L>
    where
        L: Lanes<N>,
    {
        let (no, zero) = (-L::one(), L::zero());
        let spin = self.psi.abs();
        let nowhere = EdgePoint { y: zero, c: L::one() };
        let mut found = Intervals { adheres: no, ends: AdhesionInterval::of(nowhere) };
        if spin.exceeds(zero) {
            let open = self.search(&mut found);
            if open.exceeds(zero) {
                self.search_apart(open, &mut found);
            }
        }
        let mut missing = -found.adheres;
        if !spin.is_positive_number() {
            let (rest, interval) = self.without_spin();
            found.adheres = spin.choose(found.adheres, rest);
            found.ends = AdhesionInterval::chosen(spin, found.ends, interval);
            missing = spin.choose(missing, no);
        }
        if missing.exceeds(zero) {
            let nearest = AdhesionInterval::of(self.nearest());
            found.ends = AdhesionInterval::chosen(missing, nearest, found.ends);
        }
        found
    }

    /// The tangents of `by_tangents`, for the lanes with spin. Gives a number that is positive where the steps did
    /// not suffice.
    #[inline(always)]
    fn search<const N: usize>(&self, found: &mut Intervals<L>) -> L
    where
        L: Lanes<N>,
    {
        let (yes, no, zero) = (L::one(), -L::one(), L::zero());
        let sides = self.both_sides();
        let length = AdhesionLength::of(&sides, false);

        // The first chord: of the level tangent at ξ̄ = 0, or of that at the edge nearest to it
        let kappa = self.shortest_kappa();
        let mut meets = (L::one() - kappa) * (L::one() + kappa);
        let mut to = meets.sqrt();
        let mut from = -to;
        let level = self.slope.abs() - self.xi.abs();
        if !level.is_positive_number() {
            let start = (-(self.xi * self.slope)).choose(no, yes);
            let tangent = AdhesionLength::of(self, false).tangent(self, start);
            let (norm, square) = tangent.squares();
            let (root, inverse) = (square.sqrt(), L::one() / norm);
            meets = level.choose(meets, square);
            from = level.choose(from, tangent.on_edge(-root, inverse).y);
            to = level.choose(to, tangent.on_edge(root, inverse).y);
        }
        // The steps of `ends_from`; lanes that come to an end are no longer open.
        let mut open = self.psi.abs().choose(meets.choose(yes, no), no);
        let mut y = L::Pair::of(-from, to);
        for _ in 0..TANGENT_STEPS {
            if !open.exceeds(zero) {
                break;
            }
            let tangent = length.tangent(&sides, y);
            let squares = tangent.squares();
            let (first, second) = squares.1.parts();
            let closer = tangent.closer(squares);
            let [near_lower, near_upper, far_lower, far_upper] = closer.chords();
            let span = near_upper - near_lower;
            let apart = (near_lower - far_upper).max(far_lower - near_upper);
            let overlap = span.choose(apart.choose(no, open), no);
            open = first.choose(second.choose(overlap, no), no);
            let close = open.choose(span.times(CLOSE) - closer.change(y), no);
            if close.exceeds(zero) {
                let (lower, upper) = closer.ends(&sides, y);
                let fits = close.choose(upper.y - lower.y, no);
                found.adheres = fits.choose(yes, found.adheres);
                found.ends =
                    AdhesionInterval::chosen(fits, AdhesionInterval { lower, upper }, found.ends);
                open = close.choose(no, open);
            }
            y = closer.outer;
        }
        open
    }

    /// The intervals of lanes that are still open, one by one: short intervals.
    #[cold]
    #[inline(never)]
    fn search_apart<const N: usize>(&self, open: L, found: &mut Intervals<L>)
    where
        L: Lanes<N>,
    {
        let AdhesionInterval { lower, upper } = found.ends;
        let mut lanes = [found.adheres, lower.y, lower.c, upper.y, upper.c].map(L::array);
        for (i, (family, open)) in self.one_by_one().zip(open.array()).enumerate() {
            if open > Stored::<L>::zero()
                && let Ok(AdhesionInterval { lower, upper }) = family.adhesion_interval()
            {
                let numbers = [Stored::<L>::one(), lower.y, lower.c, upper.y, upper.c];
                for (lanes, number) in lanes.iter_mut().zip(numbers) {
                    if let Some(lane) = lanes.get_mut(i) {
                        *lane = number;
                    }
                }
            }
        }
        let [adheres, lower_y, lower_c, upper_y, upper_c] = lanes.map(L::of_array);
        found.adheres = adheres;
        found.ends = AdhesionInterval {
            lower: EdgePoint { y: lower_y, c: lower_c },
            upper: EdgePoint { y: upper_y, c: upper_c },
        };
    }
}
