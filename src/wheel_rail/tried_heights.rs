//! What is known of the heights that the search for a load has tried.

use crate::number::Float;
use crate::status::Error;

/// Largest share of the excess of the height before the last that is not slow.
const SLOW_SHARE: f64 = 0.5;
/// How many heights without a force are tried above one at which a profile ends.
const EMPTY: u32 = 2;
/// Quotient of two stiffnesses from which another contact begins between the heights.
const STIFFER: f64 = 2.0;
/// Largest change of a secant's slope as the stiffness changes, as a share of it.
const CORRECTION: f64 = 0.5;

/// A tried height, and by how much the straightened force there exceeds the requested one.
type Tried<F> = (F, F);

/// The heights that were tried.
pub(super) struct Heights<F> {
    /// The lowest with too little force, and the highest with too much.
    pub(super) above: Option<Tried<F>>,
    pub(super) below: Option<Tried<F>>,
    /// One at which the wheel is too deep in the rail to have a force, and the first error there.
    pub(super) deep: Option<(F, Error)>,
    /// The last one with a force, and the slope of the straightened force there.
    last: Option<(Tried<F>, F)>,
    /// How many have no force above a height that is too deep.
    empty: u32,
    /// The lowest height that is too deep.
    pub(super) lowest: Option<F>,
    /// Sizes of the last excess and of the one before.
    sizes: [F; 2],
}

impl<F: Float> Heights<F> {
    pub(super) const fn new() -> Self {
        let sizes = [F::LARGEST; 2];
        Self { above: None, below: None, deep: None, last: None, empty: 0, lowest: None, sizes }
    }

    pub(super) fn note_deep(&mut self, height: F, error: Error) {
        let first = self.deep.map_or(error, |(_, first)| first);
        self.deep = Some((height, first));
        self.lowest = Some(self.lowest.map_or(height, |lowest| lowest.max(height)));
    }

    /// Notes a height without a force. Returns whether the wheel may touch below an edge only.
    pub(super) fn is_above_edge(&mut self) -> bool {
        self.empty += u32::from(self.deep.is_some() && self.below.is_none());
        self.empty >= EMPTY
    }

    /// Notes a height, by how much the straightened force there exceeds the requested one, and the
    /// slope of that force as Hertz says, if there is a force. Returns the place of the next step;
    /// none after steps that do not lead closer.
    pub(super) fn note(&mut self, height: F, excess: F, by_hertz: Option<F>) -> Option<F> {
        let [last, earlier] = self.sizes;
        self.sizes = [excess.abs(), last];
        let side = if excess < F::zero() { &mut self.above } else { &mut self.below };
        *side = Some((height, excess));
        let before = self.last;
        self.last = by_hertz.map(|slope| ((height, excess), slope));
        let own = by_hertz.unwrap_or(F::zero());
        let is_alike = |(_, slope): &(Tried<F>, F)| {
            let [less, more] = [own.min(*slope), own.max(*slope)];
            more < less.times(STIFFER)
        };
        // f ≈ f₀ + (h − h₀) (f₀₁ + (h − h₁) f''/2): f₀₁ of the secant, f'' of Hertz's slopes
        let secant = before.filter(is_alike).map(|((place, more), other)| {
            let secant = (excess - more) / (height - place);
            let second = (own - other) / (height - place).times(2.0);
            let correction = second * (height - excess / secant - place);
            let is_small = correction.abs() < secant.abs().times(CORRECTION);
            if is_small { secant + correction } else { secant }
        });
        let slope = secant.or(by_hertz).filter(|slope| *slope > F::zero());
        let is_slow = excess.abs() > earlier.times(SLOW_SHARE);
        let is_between = self.above.is_some() && self.too_low().is_some();
        slope.filter(|_| !(is_slow && is_between)).map(|slope| height - excess / slope)
    }

    /// The highest place that is known to be too low, with an error where it is too deep.
    pub(super) fn too_low(&self) -> Option<(F, Option<Error>)> {
        match (self.below, self.deep) {
            (Some((low, _)), Some((deep, error))) if deep < low => Some((deep, Some(error))),
            (Some((low, _)), _) => Some((low, None)),
            (None, deep) => deep.map(|(deep, error)| (deep, Some(error))),
        }
    }
}

/// How the support varies over the heights that were tried.
pub(super) struct Trend<F> {
    /// Depth of the deepest place with too little support, and its support.
    pub(super) least: Option<(F, F)>,
    /// Whether the support falls with depth somewhere, by more than its rounding.
    pub(super) falls: bool,
    pub(super) rounding: F,
}

impl<F: Float> Trend<F> {
    /// Notes the support at a height. At the first touch it is zero.
    pub(super) fn note(&mut self, height: F, support: F, has_too_little: bool) {
        let (_, before) =
            self.least.filter(|(above, _)| *above < height).unwrap_or((height, F::zero()));
        self.falls |= support < before - self.rounding;
        if has_too_little {
            self.least = Some((height, support));
        }
    }
}
