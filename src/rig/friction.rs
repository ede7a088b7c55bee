//! From a measured force to the coefficient of friction.

use super::search::{Interval, STEEPEST, Sample, Search};
use super::{FrictionEstimate, Measured};
use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::forces::{Model, Options, Solution};
use crate::friction::{InMotion, SlipFriction};
use crate::number::{Float, are_finite};
use crate::numerics::Bracket;
use crate::status::{Error, Warning};

/// Ratio of friction to used friction beyond which the contact is taken to stick: the force differs
/// by about one per cent from that of linear theory there.
const STICKING: f64 = 20.0;
/// Largest friction that is tried, divided by the friction that adhesion needs.
const RANGE: f64 = 1e4;
/// Largest friction that adhesion may need, divided by the used one. Beyond it only full sliding
/// can be told.
const LARGEST_ADHESION: f64 = 1e5;
/// The way up from the used friction: the largest number of steps; limits of the ratio that tells
/// how far in sliding the contact is; and the growth of `x` in a step, for a ratio above all
/// limits, below one, below two and below three of them.
const WALK: usize = 46;
const LIMITS: [f64; 3] = [0.1, 1.0 / 30.0, 0.01];
const WALK_GROWTH: [f64; 4] = [1.0 + 0.1, 1.0 + 0.1 * 2.0, 1.0 + 0.1 * 4.0, 1.0 + 0.1 * 6.0];
/// Number of solutions up to which intervals are divided, and the largest number of all solutions
/// with that of the answer.
const DIVIDED: usize = 64;
const MOST_FRICTIONS: usize = 90;
/// Width below which, and height above which, a crossing is a jump.
const NARROW: f64 = 1e-9;
const HIGH: f64 = 1e-6;
/// Number of roundings up to which a force counts as zero.
const ZERO_ROUNDINGS: f64 = 32.0;

/// The coefficient of friction that explains a measured force at a known creepage.
///
/// The contact's own friction is ignored. Forces act on the lower body. Under a law the result is
/// the coefficient of friction without slip, and the law's own coefficient is ignored.
///
/// The comment of `kstrip_estimate_friction` tells what the warnings mean, which solution is found
/// where there are several, and how many solutions the search needs.
///
/// # Errors
/// Those of [`forces_of_contact`](crate::forces::forces_of_contact), [`Error::NotInModel`] for
/// [`Model::Linear`], [`Error::Unexplained`], and those of [`SlipFriction::check`].
///
/// # Example
/// ```
/// use kstrip::contact::{Contact, creepage::Creepage};
/// use kstrip::{forces::{Options, forces_of_contact}, rig::*};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, friction: 0.22,
///     shear_modulus: 82e9, poisson_ratio: 0.28, mismatch: 0.0,
/// };
/// let creepage = Creepage { longitudinal: 2e-3, lateral: 0.0, spin: 0.1 };
/// let options = Options::default();
/// let measured = forces_of_contact(&contact, &creepage, &options)?.fx;
/// let force = [measured, 0.0];
/// let found = estimate_friction(&contact, &creepage, None, &options, Measured::Fx, force)?;
/// assert!((found.friction - 0.22_f64).abs() < 1e-12);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn estimate_friction<F: Float>(
    contact: &Contact<F>, creepage: &Creepage<F>, law: Option<&SlipFriction<F>>, options: &Options,
    measured: Measured, force: [F; 2],
) -> Result<FrictionEstimate<F>, Error> {
    Rig::new(contact, creepage, law, options, measured, force)?.estimate(force)
}

/// A contact on a rig, and what was measured.
pub(crate) struct Rig<'a, F> {
    /// The contact; its friction is ignored.
    contact: Contact<F>,
    creepage: &'a Creepage<F>,
    law: Option<&'a SlipFriction<F>>,
    options: &'a Options,
    measured: Measured,
    /// The force that was measured \[N\].
    target: F,
    /// `|F|/N`
    pub(crate) used: F,
    /// Friction about which the contact begins to stick; `x = μ/(μ + unit)`
    unit: F,
    /// Solutions so far.
    pub(crate) solved: usize,
}

impl<'a, F: Float> Rig<'a, F> {
    /// Checks all inputs.
    pub(crate) fn new(
        contact: &Contact<F>, creepage: &'a Creepage<F>, law: Option<&'a SlipFriction<F>>,
        options: &'a Options, measured: Measured, [fx, fy]: [F; 2],
    ) -> Result<Self, Error> {
        Error::NotInModel.unless(options.model != Model::Linear)?;
        Error::NotFinite.unless(are_finite(&[fx, fy]))?;
        let contact = Contact { friction: F::zero(), ..*contact };
        let check = |contact: &Contact<F>| {
            let law = law.map(|law| SlipFriction { friction: contact.friction, ..*law });
            InMotion { creepage, law: law.as_ref(), options }.check(contact)
        };
        check(&contact)?;
        let target = measured.component([fx, fy]);
        let used = target.abs() / contact.normal_force;
        Error::Unexplained.unless(!contact.is_lost() && used.is_finite_number())?;
        // 4 (G a b (|υx| + |υy| + √(ab) |φ|)/N + |κ|), about the force of linear theory
        let stiff = law.map_or(contact, |law| law.contact(&contact));
        let Contact { a, b, shear_modulus, normal_force, mismatch, .. } = stiff;
        let size = creepage.fastest_within((a * b).sqrt());
        let unit = (shear_modulus * a * b * size / normal_force + mismatch.abs()).times(4.0);
        let most = used.times(LARGEST_ADHESION);
        let unit = if unit < most { unit } else { most };
        // for any friction that is tried
        let friction = unit.max(used).times(RANGE * 1.01);
        check(&Contact { friction, ..contact })?;
        Ok(Self { contact, creepage, law, options, measured, target, used, unit, solved: 0 })
    }

    /// No force: friction is zero, unless there is no slip to show it.
    fn without_force(&self) -> Result<FrictionEstimate<F>, Error> {
        // The force per unit of a small friction: the direction of full sliding
        let (_, [x, y, _], _) = self.solve(F::zero())?;
        let direction = self.measured.component([x, y]);
        let mut found = self.at_least();
        if direction != F::zero() {
            found.warning = Warning::None;
            found.sensitivity = finite_or_none(F::one() / direction);
        }
        Ok(found)
    }

    /// The contact sticks.
    fn at_least(&self) -> FrictionEstimate<F> {
        let (friction, none, warning) = (self.used, F::zero(), Warning::FrictionAtLeast);
        FrictionEstimate { friction, sensitivity: none, residual: none, warning, reserved: 0 }
    }

    /// `μ`
    fn friction(&self, x: F) -> F {
        self.unit * (x / (F::one() - x))
    }

    /// Forces at a friction without slip, their derivatives with respect to it, and the actual
    /// friction.
    fn solve(&self, friction: F) -> Result<(Solution<F>, [F; 3], F), Error> {
        let contact = Contact { friction, ..self.contact };
        let law = self.law.map(|law| SlipFriction { friction, ..*law });
        let motion = InMotion { creepage: self.creepage, law: law.as_ref(), options: self.options };
        let found = motion.differentiate(&contact)?;
        Ok((found.solution, found.derivatives.friction, found.friction))
    }

    /// Force and its derivative with respect to friction at a friction, in the sense of the
    /// measured force.
    fn force(&mut self, friction: F) -> Result<(Solution<F>, [F; 2]), Error> {
        self.solved += 1;
        let (solution, [by_x, by_y, _], _) = self.solve(friction)?;
        let Solution { fx: x, fy: y, .. } = solution;
        let force = self.measured.component([x, y]);
        let over = force + F::TINY;
        let slope = match self.measured {
            Measured::Fx => by_x,
            Measured::Fy => by_y,
            Measured::Both => (x / over) * by_x + (y / over) * by_y,
        };
        Ok((solution, [force, slope]))
    }

    /// The excess over the measured force, divided by `N` and the unit, at `x`.
    fn excess(&mut self, x: F, friction: F) -> Result<Sample<F>, Error> {
        let (_, [force, slope]) = self.force(friction)?;
        let over = self.contact.normal_force * self.unit;
        let over = if self.target > F::zero() { over } else { -over };
        let value = (force - self.target) / over;
        // dμ/dx = unit/(1 − x)²
        let stretch = F::one() / (F::one() - x);
        let slope = slope * self.unit / over * stretch * stretch;
        let rounding = self.used / self.unit * F::EPSILON.times(ZERO_ROUNDINGS);
        let value = if value.abs() <= rounding { F::zero() } else { value };
        Ok(Sample { x, value, slope })
    }

    pub(crate) fn estimate(&mut self, force: [F; 2]) -> Result<FrictionEstimate<F>, Error> {
        let Self { used, unit, target, .. } = *self;
        if target == F::zero() {
            return self.without_force();
        }
        if used >= unit.times(RANGE) {
            // More than adhesion gives at any friction
            let (_, [found, _]) = self.force(used)?;
            let agrees = found * target > F::zero();
            return Error::Unexplained.unless(agrees).map(|()| self.at_least());
        }
        // The result is written in its place, because it would be copied otherwise.
        let mut search = Search::new(self.options.model == Model::Strip1967);
        let (first, most) = self.search(&mut search)?;
        Error::Unexplained.unless(most + used / unit > F::zero())?;
        let slides = first.value >= F::zero();
        let (friction, settled) = if slides { (used, true) } else { self.smallest(&search)? };
        // with respect to the actual friction
        let now = match self.law {
            Some(law) if law.falls() && friction < F::LARGEST => self.solve(friction)?.2,
            _ => friction,
        };
        if now > used.times(STICKING) {
            return Ok(self.at_least());
        }
        let several = search.changes() > 1;
        let warnings = [(!settled, Warning::NotConverged), (several, Warning::SeveralFrictions)];
        let [fx, fy] = force;
        let (solution, [_, slope]) = self.force(friction)?;
        let residual = self.measured.component([solution.fx - fx, solution.fy - fy]).abs();
        let sensitivity = finite_or_none(F::one() / slope);
        let warning = Warning::first(&warnings).worse(solution.warning);
        Ok(FrictionEstimate { friction, sensitivity, residual, warning, reserved: 0 })
    }

    /// Searches from the used friction upward, and then in the intervals that may hide roots.
    /// Returns the first place and the largest excess.
    fn search(&mut self, search: &mut Search<F>) -> Result<(Sample<F>, F), Error> {
        let one = F::one();
        let end = F::constant(1.0 - 1.0 / RANGE);
        let first = self.excess(self.used / (self.used + self.unit), self.used)?;
        let (mut last, mut most) = (first, first.value);
        for _ in 0..WALK {
            if last.x >= end {
                break;
            }
            // Far in sliding the force is friction times a direction, nearly.
            let ratio = last.ratio();
            let slides = LIMITS.map(F::constant).into_iter().filter(|limit| ratio < *limit);
            let growth = WALK_GROWTH.map(F::constant);
            let mut x = last.x * growth.get(slides.count()).copied().unwrap_or(one);
            if !search.jumps {
                let reach = ratio + last.value.abs().times(1.0 / STEEPEST);
                x = x.max(reach / (one + reach));
            }
            let x = x.min(end);
            let place = self.excess(x, self.friction(x))?;
            search.add(last, place);
            most = most.max(place.value);
            last = place;
        }
        while self.solved < DIVIDED {
            let Some((interval, x)) = search.next() else { break };
            let place = self.excess(x, self.friction(x))?;
            search.divide(&interval, place);
        }
        Ok((first, most))
    }

    /// The smallest friction that explains the force, infinite if there is none, and whether it is
    /// a root. A jump is taken if there is no root.
    fn smallest(&mut self, search: &Search<F>) -> Result<(F, bool), Error> {
        let (mut from, mut jump) = (F::zero(), None);
        while let Some(interval) = search.change_from(from) {
            from = interval.to.x;
            let (place, settled) = self.root(&interval)?;
            let friction = self.friction(place.x);
            if settled {
                return Ok((friction, true));
            }
            jump = jump.or(Some(friction));
        }
        Ok((jump.unwrap_or(F::LARGEST), false))
    }

    /// Newton's method, guarded by bisection. The second result is whether it ends in a root.
    fn root(&mut self, interval: &Interval<F>) -> Result<(Sample<F>, bool), Error> {
        let [mut below, mut above] = interval.ends();
        let mut bracket = Bracket { negative: below.x, positive: above.x };
        let mut place = if below.value.abs() < above.value.abs() { below } else { above };
        let mut width = bracket.width();
        for step in 0..MOST_FRICTIONS {
            if place.value == F::zero() || self.solved + 1 >= MOST_FRICTIONS {
                break;
            }
            let newton = place.x - place.value / place.slope;
            // Halve the interval where three steps did not.
            let third = step % 3 == 2;
            let is_slow = third && bracket.width() > width.times(0.5);
            let x = if is_slow { bracket.middle() } else { bracket.guarded(newton) };
            if third {
                width = bracket.width();
            }
            if x == place.x {
                break;
            }
            let moved = (x - place.x).abs();
            place = self.excess(x, self.friction(x))?;
            bracket.narrow(x, place.value);
            *(if place.is_positive() { &mut above } else { &mut below }) = place;
            let least = below.value.abs().min(above.value.abs());
            let jumps = bracket.width() < x.times(NARROW) && least > x.times(HIGH);
            if jumps || moved <= x.min(F::one() - x) * F::EPSILON.times(4.0) {
                break;
            }
        }
        Ok((place, place.value.abs() <= place.x * F::EPSILON.sqrt()))
    }
}

/// A sensitivity; zero where there is no number for it.
fn finite_or_none<F: Float>(sensitivity: F) -> F {
    if sensitivity.is_finite_number() { sensitivity } else { F::zero() }
}
