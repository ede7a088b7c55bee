//! Traction and slip at a point of a strip, by the same law from which the forces are summed.

use super::constants::{EDGE, NODES};
use super::creepage::{Distribution, StripGeometry};
use super::kernel::{Separatrix, SlipState, Spin, Step, StripCreepage};
use super::tables::{Constants, Tables};
use crate::number::Float;

/// Least distance from the trailing edge; a point that is nearer counts as being there.
const LEAST: f64 = 1e-9;
/// Keeps quotients finite where no traction acts.
const NO_TRACTION: f64 = 1e-30;

/// The tangential state of a point of a strip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripTraction<T> {
    /// Traction on the lower body along `x`, divided by the local friction bound `μ Z`.
    pub x: T,
    /// Traction along `y`, divided by `μ Z`. The magnitude of both is at most 1.
    pub y: T,
    /// Slip of the upper over the lower body along `x`, in the units of the given creepages.
    pub slip_x: T,
    /// Slip along `y`.
    pub slip_y: T,
    /// Whether the point slips.
    pub slips: bool,
}

impl<F: Float> Distribution<F> {
    /// Traction, state and slip at `x̂ = x/c` of a strip, −1 to 1.
    ///
    /// The step from one node to the next ends at the point, so that at a node the values are those
    /// from which the forces are summed.
    #[must_use]
    pub fn traction(&self, strip: &StripGeometry<F>, place: F) -> StripTraction<F> {
        let (zero, one, two) = (F::zero(), F::one(), F::of(2.0));
        let (seen, sigma) = self.strip(strip);
        let spin = Spin::new(sigma);
        let Separatrix { y, s, .. } = Separatrix::new(&seen, &spin);
        let tau = (place + one).clamped(F::of(LEAST), two);
        let inverse = one / s;
        let n = [seen.x * inverse, y * inverse + spin.r];
        if tau >= s && s < two {
            // t = r e_y + (A'/s)(1 − R), R = √(1 − s/τ)
            let share = one - (one - s / tau).max(zero).sqrt();
            let (x, y) = (n[0] * share, spin.r + (n[1] - spin.r) * share);
            return StripTraction { x, y, slip_x: zero, slip_y: zero, slips: false };
        }
        let constants = Tables::new(|[first, _]: &[F; 2]| *first);
        let t = tau * inverse;
        let mut slip = SlipState::start(n, two - s, inverse, &seen);
        let (mut before, mut from) = (one, None);
        let mut here = None;
        for k in 0..NODES {
            let node = constants.node(k);
            let whole = step_to(s, before, node.place);
            let (next, traction) = slip.step(&seen, &spin, s, &whole);
            let to = slip_share(&seen, &spin, s, &whole, traction.tried);
            // Slip divided by rigid slip: zero at the separatrix; at the leading edge that of the
            // first step.
            let at_start = from.unwrap_or(to * s.plus(EDGE - 2.0).max(zero).times(1.0 / EDGE));
            here = Some((slip, node, before, at_start, to));
            if t >= node.place {
                break;
            }
            (slip, before, from) = (next, node.place, Some(to));
            here = Some((slip, node, before, to, to));
        }
        let Some((slip, node, before, from, to)) = here else {
            return StripTraction { x: zero, y: zero, slip_x: zero, slip_y: zero, slips: false };
        };
        let (_, point) = slip.step(&seen, &spin, s, &step_to(s, before, t));
        let part = ((before - t) / node.length).clamped(zero, one);
        // With much spin the traction may reach the bound anywhere behind the leading edge.
        let excess = (point.tried - one).times(5.0).clamped(zero, one);
        let share = (from + (to - from) * part) * (one - spin.blend * (one - excess));
        let slips = spin.blend == zero || point.tried > one;
        self.slipping(strip, place, [point.x, point.y], share, slips)
    }

    /// A point whose slip is this share of the rigid slip, along the traction.
    fn slipping(
        &self,
        strip: &StripGeometry<F>,
        place: F,
        [x, y]: [F; 2],
        share: F,
        slips: bool,
    ) -> StripTraction<F> {
        let [vx, vy, phi] = self.creepage;
        let rigid_x = vx - phi * (strip.y / self.root);
        let rigid_y = vy + phi * (self.root * strip.half_length * place);
        let rigid = (rigid_x * rigid_x + rigid_y * rigid_y).sqrt();
        let size = (x * x + y * y).plus(NO_TRACTION).sqrt();
        let slip = share * rigid / size;
        StripTraction { x, y, slip_x: slip * x, slip_y: slip * y, slips }
    }
}

/// A step to `t`. At a point there is no cell to average over.
fn step_to<F: Float>(s: F, before: F, t: F) -> Step<F> {
    let bound = t * (F::of(2.0) - s * t);
    Step {
        length: before - t,
        place: t,
        inverse_bound: F::one() / bound.max(F::of(LEAST)),
        soft: F::zero(),
    }
}

/// Slip divided by rigid slip on a step: the part of the traction's growth that the bound cuts off,
/// divided by the whole growth.
fn slip_share<F: Float>(
    seen: &StripCreepage<F>,
    spin: &Spin<F>,
    s: F,
    step: &Step<F>,
    tried: F,
) -> F {
    let turn = spin.sigma * (s * step.place).plus(-1.0).times(2.0);
    let (x, y) = (seen.x, seen.y + turn);
    let offered = (x * x + y * y).plus(NO_TRACTION).sqrt();
    let excess = tried.sqrt().plus(-1.0).max(F::zero());
    (excess / (offered * step.length * step.inverse_bound)).min(F::one())
}
