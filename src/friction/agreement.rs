//! The scalar equation `μ = g(μ)` between friction and the slip that it leaves.

use crate::friction::law::SlipFriction;
use crate::number::Float;
use crate::numerics::Bracket;
use crate::status::{Error, Warning};

/// Largest number of steps of the monotone iteration.
const WALK_STEPS: usize = 100;
/// Largest number of steps of the secant method, which ends after four to six.
const SECANT_STEPS: usize = 60;
/// Number of steps after which every third one halves the bracket.
const PATIENCE: usize = 6;
/// The distance of the slope of `g` from 1 that is assumed at first in a walk, and the factor by
/// which it falls with each step.
const CAUTION: f64 = 0.25;
const LESS: f64 = 0.7;
/// Bound of `g'` below which there is one solution. (It holds for strips; what TOTAL loses of its
/// slip may fall a little faster.)
const ONE_SOLUTION_SLOPE: f64 = 0.75;

/// Where `g` rises by more than this at a solution that a plain step has passed, others are looked
/// for: at so many places before it, and by so many parabolas where `g(μ) − μ` is small between
/// two of them. Its slope is taken over this part of the way.
const RISES: f64 = 0.4;
const RISE_PLACES: usize = 24;
const PARABOLAS: usize = 3;
const ASIDE: f64 = 1e-2;
const RISE_STEP: f64 = (1.0 - ASIDE) / RISE_PLACES as f64;

/// The equation `μ = g(μ)` and the bounds of `g`.
pub(crate) struct FrictionEquation<'a, F, G> {
    pub law: &'a SlipFriction<F>,
    /// Upper bound of the slip of all points, divided by the rolling speed.
    pub rigid_slip: F,
    /// The friction bound at `μ = 1`.
    pub load: F,
    /// `g`: the friction that the slip at friction `μ` leaves.
    pub next: G,
}

impl<F: Float, G: Fn(F) -> Result<F, Error>> FrictionEquation<'_, F, G> {
    /// The largest `μ` that agrees with the slip that it causes.
    pub(crate) fn largest_solution(&self) -> Result<(F, Warning), Error> {
        let Self { law, rigid_slip: rigid, load, next } = self;
        let largest = law.friction;
        let least = law.at(*rigid);
        if least * *load <= F::zero() {
            // Without any friction the bodies do not resist each other.
            return Ok((self.walk(largest, [least, largest])?.0, Warning::None));
        }
        let high = next(largest)?;
        if high >= largest {
            return Ok((largest, Warning::None));
        }
        // g' ≤ B V s_max (g − A μ₀)/μ
        let steepness =
            (law.decay * (law.rolling_speed * *rigid)) * ((high - law.ratio * largest) / least);
        if steepness < F::of(ONE_SOLUTION_SLOPE) {
            let between = Bracket { positive: least, negative: largest };
            let (friction, settled) = self.solve_between(between, high - largest, high)?;
            return Ok((friction, if settled { Warning::None } else { Warning::NotConverged }));
        }
        let (upper, settled) = self.walk(largest, [least, largest])?;
        let (lower, _) = self.walk(least, [least, largest])?;
        let several = upper - lower > upper.times(1e-3);
        let warnings = [(!settled, Warning::NotConverged), (several, Warning::SeveralFrictions)];
        Ok((upper, Warning::first(&warnings)))
    }

    /// The only solution in a bracket of `g(μ) − μ`, from its value at the negative end and from a
    /// first guess, by the secant method. The second result is whether the method reached
    /// rounding. It does not where the forces jump (strips of 1967 that do not move with the
    /// solution).
    fn solve_between(
        &self, mut bracket: Bracket<F>, end_error: F, first: F,
    ) -> Result<(F, bool), Error> {
        let (mut before, mut error_before, mut friction) = (bracket.negative, end_error, first);
        let (mut best, mut least_error) = (before, end_error.abs());
        for step in 0..SECANT_STEPS {
            let error = (self.next)(friction)? - friction;
            let rounding = error.abs() <= friction * F::EPSILON.times(64.0);
            if error.abs() < least_error {
                (best, least_error) = (friction, error.abs());
            } else if rounding {
                break;
            }
            if error == F::zero() {
                break;
            }
            bracket.narrow(friction, error);
            let secant = friction + error * ((friction - before) / (error_before - error));
            // Among rounding errors the secant means nothing.
            if rounding && !bracket.holds(secant) {
                break;
            }
            (before, error_before) = (friction, error);
            let halves = step >= PATIENCE && step.is_multiple_of(3);
            friction =
                if bracket.holds(secant) && !halves { secant } else { bracket.ratio_middle() };
            if friction == before {
                break;
            }
        }
        Ok((best, least_error <= best * F::EPSILON.sqrt()))
    }

    /// Along `μ ← g(μ)` to the nearest solution, monotonically, with longer steps where these do
    /// not pass it; and whether it was reached.
    fn walk(&self, start: F, [least, largest]: [F; 2]) -> Result<(F, bool), Error> {
        let mut friction = start;
        let mut step = (self.next)(friction)? - friction;
        // g' as far as it was seen, three quarters at most, later more: steps fall like a geometric
        // series
        let (mut ratio, mut caution) = (F::zero(), F::of(CAUTION));
        for _ in 0..WALK_STEPS {
            if step.abs() <= friction * F::EPSILON.times(8.0) {
                return Ok((friction, true));
            }
            let far = (friction + step / (F::one() - ratio)).clamped(least, largest);
            let far_step = (self.next)(far)? - far;
            if far_step * step <= F::zero() {
                // Passed it, or rounding turned round what is monotone: it lies between.
                let found = self.solution_between([friction, step], [far, far_step])?;
                let plain = ratio == F::zero() && (far - friction).abs() > friction.times(1e-3);
                return if plain { self.nearest([friction, step], found) } else { Ok(found) };
            }
            let slope = (far_step - step) / (far - friction);
            ratio = slope.plus(1.0).clamped(F::zero(), F::one() - caution);
            caution = caution.times(LESS);
            (friction, step) = (far, far_step);
        }
        Ok((friction, false))
    }

    /// A solution between two places, each with its `g(μ) − μ`.
    fn solution_between(&self, from: [F; 2], to: [F; 2]) -> Result<(F, bool), Error> {
        let [low, high] = if to[0] > from[0] { [from, to] } else { [to, from] };
        let between = Bracket { positive: low[0], negative: high[0] };
        self.solve_between(between, high[1], between.ratio_middle())
    }

    /// The solution nearest to a place, with its `g(μ) − μ`, of which a plain step has passed one.
    ///
    /// Where `g` rises with the friction, as that of strips, such a step passes none. That of TOTAL
    /// may fall: one solution is passed. Where it falls and rises again up to that one, there may
    /// be two before.
    fn nearest(&self, from: [F; 2], passed: (F, bool)) -> Result<(F, bool), Error> {
        let at = |x: F| Ok([x, (self.next)(x)? - x]);
        let way = passed.0 - from[0];
        let end = at(passed.0 - way.times(ASIDE))?;
        // (1 − g' there)
        if end[1].abs() >= way.abs().times(ASIDE * (1.0 - RISES)) {
            return Ok(passed);
        }
        let is_before = |[_, error]: [F; 2]| error * from[1] <= F::zero();
        let [mut before, mut last] = [from; 2];
        for place in 1..=RISE_PLACES {
            let here = if place < RISE_PLACES { at(last[0] + way.times(RISE_STEP))? } else { end };
            if is_before(here) {
                return self.solution_between(last, here);
            }
            let [mut a, mut b, mut c] = [before, last, here];
            for _ in 0..PARABOLAS {
                if !(b[1].abs() < a[1].abs() && b[1].abs() <= c[1].abs()) {
                    break;
                }
                // The vertex of the parabola through three places
                let [to_a, to_c] = [b[0] - a[0], b[0] - c[0]];
                let [by_a, by_c] = [to_a * (b[1] - c[1]), to_c * (b[1] - a[1])];
                let least = at(b[0] - (to_a * by_a - to_c * by_c) / (by_a - by_c).times(2.0))?;
                if is_before(least) {
                    return self.solution_between(a, least);
                }
                let is_beyond = (least[0] - b[0]) * to_a > F::zero();
                [a, b, c] = match (is_beyond, least[1].abs() < b[1].abs()) {
                    (true, true) => [b, least, c],
                    (true, false) => [a, b, least],
                    (false, true) => [a, least, b],
                    (false, false) => [least, b, c],
                };
            }
            (before, last) = (last, here);
        }
        Ok(passed)
    }
}
