//! A strip of half-spaces and its bristles at a point, behind a layer.
//!
//! Traction and dissipation are the means of those of half-spaces and bristles, weighted as their
//! forces are, so that dissipation adds up to the power. The slip is the mean of theirs, with what
//! it lacks for that dissipation added along the traction:
//!
//! ```text
//! t = (1 − w) t_h + w t_b,   D = (1 − w) t_h·s_h + w t_b·s_b
//! m = (1 − w) s_h + w s_b,   s = m + t (D − t·m)/|t|²,   t·s = D
//! ```
//!
//! Half-spaces slip by that share of the rigid slip which they have at their own creepages, and
//! bristles likewise.

use crate::layer::bristles::Rates;
use crate::number::{Float, length};
use crate::strip_1967::strip::{State, StripPoint};

/// The rigid slip of a strip, and what half-spaces and bristles have of it: at `x` half lengths
/// from the centre `(x, y + spin x)`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StripBehind<F> {
    pub rigid: Rates<F>,
    /// That of the half-spaces.
    pub half_spaces: Rates<F>,
    /// Bristles, unless there is no layer, in their own units.
    pub bristles: Option<Rates<F>>,
    /// Weight of the bristles.
    pub weight: F,
}

impl<F: Float> StripBehind<F> {
    /// The mean at `place` \[half lengths\]. Tractions count in units of which the strip has
    /// `bound` at its peak, slip in `unit`, at most [`Number::HUGE`](crate::number::Number::HUGE).
    pub fn mean(&self, point: &StripPoint<F>, place: F, [bound, unit]: [F; 2]) -> StripPoint<F> {
        if point.state == State::Outside {
            return *point;
        }
        let rigid = self.rigid.size_at(place);
        let of = |slip: [F; 2], stretch: F| {
            let stretch = stretch.min(F::LARGEST);
            slip.map(|slip| (slip * stretch).clamped(-F::HUGE, F::HUGE))
        };
        let stretch = rigid / (self.half_spaces.size_at(place) + F::TINY);
        let [slip_x, slip_y] = of([point.slip_x, point.slip_y], stretch);
        let of_half_spaces = StripPoint { slip_x, slip_y, ..*point };
        let Some(bristles) = &self.bristles else { return of_half_spaces };
        let found = bristles.at(place);
        let stretch = rigid / (bristles.size_at(place) + F::TINY) / (unit + F::TINY);
        let [traction_x, traction_y] = found.traction.map(|traction| traction * bound);
        let [slip_x, slip_y] = of(found.slip, stretch);
        let of_bristles = StripPoint { traction_x, traction_y, slip_x, slip_y, ..*point };
        self.between(&of_half_spaces, &of_bristles, found.slides)
    }

    fn between(
        &self,
        half: &StripPoint<F>,
        bristles: &StripPoint<F>,
        slides: bool,
    ) -> StripPoint<F> {
        let mean = |of: F, bristles: F| of + (bristles - of) * self.weight;
        let (x, y) = (
            mean(half.traction_x, bristles.traction_x),
            mean(half.traction_y, bristles.traction_y),
        );
        let (slip_x, slip_y) =
            (mean(half.slip_x, bristles.slip_x), mean(half.slip_y, bristles.slip_y));
        let dissipation = mean(half.dissipation(), bristles.dissipation());
        let size = length(x, y) + F::TINY;
        let (along_x, along_y) = (x / size, y / size);
        let [of_half, of_bristles] =
            [half, bristles].map(|point| length(point.slip_x, point.slip_y));
        // (where their tractions cancel no slip is large enough)
        let fastest = of_half.max(of_bristles);
        let lacking = dissipation / size - (along_x * slip_x + along_y * slip_y);
        let lacking = lacking.clamped(-fastest, fastest);
        let state = if slides && half.state == State::Stick { State::Slip } else { half.state };
        StripPoint {
            pressure: half.pressure,
            traction_x: x,
            traction_y: y,
            slip_x: slip_x + along_x * lacking,
            slip_y: slip_y + along_y * lacking,
            state,
        }
    }
}
