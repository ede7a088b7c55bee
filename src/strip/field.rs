//! Traction and slip at a point of a strip, by the same law from which the forces are summed.

use super::constants::NODES;
use super::creepage::{Distribution, StripGeometry};
use super::kernel::{Separatrix, SlipState, Spin, Step};
use super::tables::{Constants, Tables};
use crate::number::Float;

/// Least distance from the trailing edge; a point that is nearer counts as being there.
const LEAST_DISTANCE: f64 = 1e-9;
/// Keeps quotients finite where no traction acts.
const NO_TRACTION: f64 = 1e-30;

/// The tangential state of a point of a strip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripTraction<T> {
    /// Traction on the lower body along `x`, divided by the local friction bound `μ Z`.
    pub x: T,
    /// Traction along `y`, divided by `μ Z`. The magnitude of both is at most 1.
    pub y: T,
    /// Slip of the upper body relative to the lower body along `x`, in the units of the given
    /// creepages.
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
        let Separatrix { y, s, root, .. } = Separatrix::new(&seen, &spin);
        let tau = (place + one).clamped(F::of(LEAST_DISTANCE), two);
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
        let mut before = one;
        for place in (0..NODES).map(|k| constants.node(k).place) {
            if t >= place {
                break;
            }
            (slip, before) = (slip.step(&seen, &spin, s, &step_to(s, before, place)).0, place);
        }
        let (_, point) = slip.step(&seen, &spin, s, &step_to(s, before, t));
        // With much spin the traction may reach the bound anywhere behind the leading edge.
        let excess = (point.tried - one).times(5.0).clamped(zero, one);
        let share = slip_share(root.max(s), tau) * (one - spin.blend * (one - excess));
        let slips = spin.blend == zero || point.tried > one;
        let [x, y] = [point.x, point.y];
        let size = (x * x + y * y).plus(NO_TRACTION).sqrt();
        let slip = share * self.unrelieved(strip, place, &spin) / size;
        StripTraction { x, y, slip_x: slip * x, slip_y: slip * y, slips }
    }

    /// The rigid slip that the traction of spin in adhesion leaves: without `φ x r/σ`, except where
    /// spin is large.
    fn unrelieved(&self, strip: &StripGeometry<F>, place: F, spin: &Spin<F>) -> F {
        let [vx, vy, phi] = self.creepage;
        let rigid_x = vx - phi * (strip.y / self.root);
        let by_spin = phi * (self.root * strip.half_length * place);
        let relieved = if spin.sigma == F::zero() { F::one() } else { spin.r / spin.sigma };
        let of = |rigid_y: F| (rigid_x * rigid_x + rigid_y * rigid_y).sqrt();
        let left = of(vy + by_spin * (F::one() - relieved));
        left + (of(vy + by_spin) - left) * spin.blend
    }
}

/// Slip divided by rigid slip a way `τ` from the trailing edge, as Carter has it for a strip of
/// creepage alone: `2 √((2 − τ)(s − τ))/s` behind the separatrix `s`, `1 + 2 (1 − τ)/s` where all
/// slides, `s ≥ 2`. The power of the creepage is then what friction dissipates.
fn slip_share<F: Float>(s: F, tau: F) -> F {
    let two = F::of(2.0);
    if s < two {
        ((two - tau) * (s - tau).max(F::zero())).sqrt() * (two / s)
    } else {
        F::one() + (F::one() - tau).times(2.0) / s
    }
}

/// A step to `t`. At a point there is no cell to average over.
fn step_to<F: Float>(s: F, before: F, t: F) -> Step<F> {
    let bound = t * (F::of(2.0) - s * t);
    Step {
        length: before - t,
        place: t,
        inverse_bound: F::one() / bound.max(F::of(LEAST_DISTANCE)),
        soft: F::zero(),
    }
}
