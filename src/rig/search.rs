//! The places where a function of one variable changes its sign, from values and exact derivatives.
//! The search does not step over two close roots.
//!
//! Between two places the function is taken for the cubic that has both values and both slopes
//! (Hermite). The error of this cubic is estimated from the distance of the slopes to those of a
//! parabola, from the change of the slopes, and from the width. An interval is finished if its
//! cubic stays away from zero by more than this error, or if the function changes its sign in it
//! and the slope does not. The worst of the other intervals is divided next: where the cubic turns,
//! where it crosses zero, or where it comes closest to zero.

use crate::number::Float;
use crate::numerics::Cubic;
use heapless::Vec;

/// Largest number of intervals that are kept: those with a change of sign, and those that may hide
/// two roots.
const KEPT_INTERVALS: usize = 64;
/// Weights of the three parts of the error estimate: the distance of the slopes from those of a
/// parabola, the change of the slopes, and the width of the interval divided by its place.
const NO_PARABOLA: f64 = 2.0;
const SLOPE_CHANGE: f64 = 0.3;
const INTERVAL_WIDTH: f64 = 4.0;
/// Error of the values, in roundings.
const VALUE_ROUNDINGS: f64 = 500.0;
/// Largest slope of the function divided by `x/(1 − x)`, in size.
pub(super) const STEEPEST: f64 = 1.5;

/// A place `0 < x < 1`, the function there, and its derivative.
#[derive(Clone, Copy)]
pub(super) struct Sample<F> {
    pub(super) x: F,
    pub(super) value: F,
    pub(super) slope: F,
}

impl<F: Float> Sample<F> {
    /// `x/(1 − x)`
    pub(super) fn ratio(&self) -> F {
        self.x / (F::one() - self.x)
    }

    pub(super) fn is_positive(&self) -> bool {
        self.value > F::zero()
    }
}

/// Two neighbouring places.
#[derive(Clone, Copy)]
pub(super) struct Interval<F> {
    pub(super) from: Sample<F>,
    pub(super) to: Sample<F>,
    /// A number above one means that the interval may hide roots.
    danger: F,
}

impl<F: Float> Interval<F> {
    pub(super) fn changes(&self) -> bool {
        self.from.is_positive() != self.to.is_positive()
    }

    /// Of an interval in which the sign changes: the end where the function is not positive, then
    /// the other one.
    pub(super) fn ends(&self) -> [Sample<F>; 2] {
        if self.from.is_positive() { [self.to, self.from] } else { [self.from, self.to] }
    }

    fn is_done(&self) -> bool {
        self.danger <= F::one() && !self.changes()
    }
}

/// The intervals that contain or may hide a root.
pub(super) struct Search<F> {
    kept: Vec<Interval<F>, KEPT_INTERVALS>,
    /// Whether the function jumps, so that nothing bounds its growth.
    pub(super) jumps: bool,
}

impl<F: Float> Search<F> {
    pub(super) fn new(jumps: bool) -> Self {
        Self { kept: Vec::new(), jumps }
    }

    /// Keeps the interval between two places if it contains or may hide a root.
    pub(super) fn add(&mut self, from: Sample<F>, to: Sample<F>) {
        let (danger, _) = self.error_between(&from, &to);
        let interval = Interval { from, to, danger };
        if interval.is_done() {
            return;
        }
        match self.kept.iter_mut().find(|kept| kept.is_done()) {
            Some(place) => *place = interval,
            // Without room it is not searched again.
            None => drop(self.kept.push(interval)),
        }
    }

    /// The interval that most probably hides a root, if any may hide one, and where to divide it.
    pub(super) fn next(&self) -> Option<(Interval<F>, F)> {
        let dangerous = self.kept.iter().filter(|kept| kept.danger > F::one());
        let worst = dangerous.reduce(|a, b| if b.danger > a.danger { b } else { a })?;
        Some((*worst, self.error_between(&worst.from, &worst.to).1))
    }

    /// Divides an interval that [`next`](Self::next) has returned.
    pub(super) fn divide(&mut self, interval: &Interval<F>, at: Sample<F>) {
        if let Some(divided) = self.kept.iter_mut().find(|kept| kept.from.x == interval.from.x) {
            (divided.danger, divided.to) = (F::zero(), divided.from);
        }
        self.add(interval.from, at);
        self.add(at, interval.to);
    }

    /// The number of changes of sign.
    pub(super) fn changes(&self) -> usize {
        self.kept.iter().filter(|interval| interval.changes()).count()
    }

    /// The first interval from here on in which the sign changes.
    pub(super) fn change_from(&self, x: F) -> Option<Interval<F>> {
        let changes = self.kept.iter().filter(|kept| kept.changes() && kept.from.x >= x);
        changes.copied().reduce(|a, b| if b.from.x < a.from.x { b } else { a })
    }

    /// The possible error between two places divided by the error that a root needs; and where to
    /// look for it.
    fn error_between(&self, from: &Sample<F>, to: &Sample<F>) -> (F, F) {
        let width = to.x - from.x;
        let root = F::EPSILON.cube_root();
        if width <= to.x * root * root {
            return (F::zero(), from.x);
        }
        let certain = F::constant(100.0);
        let chord = (to.value - from.value) / width;
        let changes = from.is_positive() != to.is_positive();
        let upward = if changes { chord > F::zero() } else { from.is_positive() };
        let sign = if upward { F::one() } else { -F::one() };
        let [a, b, p, q, chord] =
            [from.value, to.value, from.slope, to.slope, chord].map(|x| x * sign);
        let noise = to.x * F::EPSILON.times(VALUE_ROUNDINGS) / width;
        let hidden = (p + q - chord.times(2.0)).abs().times(NO_PARABOLA)
            + (p - q).abs().times(SLOPE_CHANGE)
            + (width / to.x).times(INTERVAL_WIDTH)
            + noise;
        if changes {
            // the slope at both ends and in the middle
            let least = p.min(q).min(chord.times(1.5) - (p + q).times(0.25));
            let crossing = (a / (a - b)).clamped(F::constant(0.1), F::constant(0.9));
            let danger = if least > F::zero() { hidden / least } else { certain };
            return (danger, from.x + width * crossing);
        }
        if !self.jumps && a + b > (to.ratio() - from.ratio()).times(STEEPEST) {
            return (F::zero(), from.x);
        }
        let (p, q) = (p * width, q * width);
        let cubic = Cubic::new([a, b], [p, q]);
        let (mut least, mut at) = (F::LARGEST, F::constant(0.5));
        for eighth in 1..8 {
            let t = F::widened(eighth as f32).times(0.125);
            let reach = cubic.value_at(t) / (t * (F::one() - t));
            if reach < least {
                (least, at) = (reach, t);
            }
        }
        if p < F::zero() && q > F::zero() {
            let Cubic([_, c1, c2, c3]) = cubic;
            let root = (c2 * c2 - (c1 * c3).times(3.0)).max(F::zero()).sqrt();
            let turn =
                if c2 >= F::zero() { -c1 / (c2 + root) } else { (root - c2) / c3.times(3.0) };
            at = turn.clamped(F::constant(0.02), F::constant(0.98));
        }
        let danger = if least > F::zero() { hidden * width / least } else { certain };
        (danger, from.x + width * at)
    }
}
