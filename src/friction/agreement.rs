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

/// Roundings of `μ` within which `g(μ) − μ` is zero, and within which it may be noise.
const SETTLED_ROUNDINGS: f64 = 8.0;
const NOISE: f64 = 64.0;
/// Share of a solution by which another one must differ.
const SAME: f64 = 1e-3;
/// Share of the way to a solution by which two plain steps may miss it where no other one is
/// expected between.
const LEVEL: f64 = 0.2;
/// Largest share of the way to a solution that a step goes where `g` falls, as that of TOTAL may.
const CAREFUL: f64 = 0.25;

/// How far a walk along `μ ← g(μ)` goes: steps fall like a geometric series.
struct Pace<F> {
    /// `g'` as far as it was seen, three quarters at most, later more.
    ratio: F,
    caution: F,
    /// Whether `g` falls between the last two places.
    falls: bool,
}

impl<F: Float> Pace<F> {
    fn new() -> Self {
        Self { ratio: F::zero(), caution: F::of(CAUTION), falls: false }
    }

    /// Whether the next step is `g(μ) − μ` alone.
    fn is_plain(&self) -> bool {
        self.ratio == F::zero()
    }

    /// The next place after one with its `g(μ) − μ`.
    fn far(&self, friction: F, step: F) -> F {
        friction + step / (F::one() - self.ratio)
    }

    fn adapt(&mut self, [from, before]: [F; 2], [to, now]: [F; 2]) {
        let slope = (now - before) / (to - from);
        self.falls = slope < -F::one();
        self.ratio = slope.plus(1.0).clamped(F::zero(), F::one() - self.caution);
        self.caution = self.caution.times(LESS);
    }
}

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
        let high = next(largest)?;
        let end = [largest, high - largest];
        if least * *load <= F::zero() {
            // Without any friction the bodies do not resist each other.
            return Ok((self.walk(end, least)?.0, Warning::None));
        }
        if high >= largest {
            return Ok((largest, Warning::None));
        }
        // g' ≤ B V s_max (g − A μ₀)/μ
        let steepness =
            (law.decay * (law.rolling_speed * *rigid)) * ((high - law.ratio * largest) / least);
        if steepness < F::of(ONE_SOLUTION_SLOPE) {
            let between = Bracket { positive: least, negative: largest };
            let (friction, settled) = self.solve_between(between, end, high)?;
            return Ok((friction, if settled { Warning::None } else { Warning::NotConverged }));
        }
        let (upper, settled) = self.walk(end, least)?;
        let several = !self.is_alone(upper, least)?;
        let warnings = [(!settled, Warning::NotConverged), (several, Warning::SeveralFrictions)];
        Ok((upper, Warning::first(&warnings)))
    }

    /// The only solution in a bracket of `g(μ) − μ`, from a place with its value and from a first
    /// guess, by the secant method. The second result is whether the method reached rounding. It
    /// does not where the forces jump (strips of 1967 that do not move with the solution).
    fn solve_between(
        &self, mut bracket: Bracket<F>, [place, value]: [F; 2], first: F,
    ) -> Result<(F, bool), Error> {
        let (mut before, mut error_before, mut friction) = (place, value, first);
        let (mut best, mut least_error) = (before, value.abs());
        for step in 0..SECANT_STEPS {
            let error = (self.next)(friction)? - friction;
            let is_within = |roundings| error.abs() <= friction * F::EPSILON.times(roundings);
            if error.abs() < least_error {
                (best, least_error) = (friction, error.abs());
            } else if is_within(NOISE) {
                break;
            }
            if is_within(SETTLED_ROUNDINGS) {
                break;
            }
            bracket.narrow(friction, error);
            let secant = friction + error * ((friction - before) / (error_before - error));
            // Among rounding errors the secant means nothing.
            if is_within(NOISE) && !bracket.holds(secant) {
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

    /// Along `μ ← g(μ)` down to the nearest solution, monotonically, with longer steps where these
    /// do not pass it; and whether it was reached. Starts from a place with its `g(μ) − μ`.
    fn walk(&self, start: [F; 2], least: F) -> Result<(F, bool), Error> {
        let [mut friction, mut step] = start;
        let mut pace = Pace::new();
        for _ in 0..WALK_STEPS {
            if step.abs() <= friction * F::EPSILON.times(SETTLED_ROUNDINGS) {
                return Ok((friction, true));
            }
            let far = pace.far(friction, step).clamped(least, self.law.friction);
            let far_step = (self.next)(far)? - far;
            if far_step * step <= F::zero() {
                // Passed it, or rounding turned round what is monotone: it lies between.
                let found = self.solution_between([friction, step], [far, far_step])?;
                let plain = pace.is_plain() && (far - friction).abs() > friction.times(1e-3);
                return if plain { self.nearest([friction, step], found) } else { Ok(found) };
            }
            pace.adapt([friction, step], [far, far_step]);
            (friction, step) = (far, far_step);
        }
        Ok((friction, false))
    }

    /// Whether there is no solution below one: along `μ ← g(μ)` up from the smallest possible `μ`.
    fn is_alone(&self, upper: F, least: F) -> Result<bool, Error> {
        let mut friction = least;
        let mut step = (self.next)(least)? - least;
        let mut pace = Pace::new();
        for _ in 0..WALK_STEPS {
            if upper - friction <= upper.times(SAME) {
                return Ok(true);
            }
            if step.abs() <= friction * F::EPSILON.times(SETTLED_ROUNDINGS) {
                return Ok(false);
            }
            let far = pace.far(friction, step);
            // forces that jump may leave more than the rigid slip
            let passes = upper - far <= upper.times(SAME) || step < F::zero();
            let far = if passes { friction.times(0.5) + upper.times(0.5) } else { far };
            let careful = friction + (upper - friction).times(CAREFUL);
            let far = if pace.falls { far.min(careful) } else { far };
            let far_step = (self.next)(far)? - far;
            if far_step <= F::zero() {
                return Ok(false);
            }
            // whether g is nearly flat up to the solution
            let is_flat = |from: F, step: F| {
                let way = upper - from;
                (step - way).abs() <= way.times(LEVEL)
            };
            if passes && is_flat(friction, step) && is_flat(far, far_step) {
                return Ok(true);
            }
            pace.adapt([friction, step], [far, far_step]);
            (friction, step) = (far, far_step);
        }
        Ok(true)
    }

    /// A solution between two places, each with its `g(μ) − μ`.
    fn solution_between(&self, from: [F; 2], to: [F; 2]) -> Result<(F, bool), Error> {
        let [low, high] = if to[0] > from[0] { [from, to] } else { [to, from] };
        let between = Bracket { positive: low[0], negative: high[0] };
        let (near, far) = if low[1].abs() < high[1].abs() { (low, high) } else { (high, low) };
        let secant = near[0] + near[1] * ((near[0] - far[0]) / (far[1] - near[1]));
        self.solve_between(between, near, between.guarded(secant))
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
