//! The inverse, for test rigs: from a measured force to friction, from a wanted force to creepage.
//!
//! **Friction.** By homogeneity (see [`derivatives`]) the force at known creepage depends on `M = μ N` as
//! `F = M f(c/M)`. It grows with `M` from full sliding, `|F| = M`, to adhesion, where it is the force of linear theory
//! whatever `M`. So `M` lies between `|F|` and, unless the contact sticks, `20 |F|`: a root in a known
//! interval, found by false position (Anderson and Björck, BIT 13 (1973) 253), guarded by bisection.
//! Where spin and lateral creepage oppose each other the force may fall again and meet the measured one more than once. So the
//! search goes up from `|F|` in steps that cannot pass a root, because the force changes with `M` no faster than 1.5, and where
//! it turns close to the measured one it looks at the turn: the first root is the smallest. The sensitivity to the force, which grows without bound towards adhesion,
//! is part of the answer.
//!
//! **Creepage.** `(F_x, F_y)` is a monotone function of `(υx, υy)`. Newton's method from the linear answer with the
//! exact derivatives; steps that do not come closer are damped (Levenberg and Marquardt). Where that gets stuck the
//! wanted force is approached in stages.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::number::{Float, length};
use crate::solve::derivatives;
use crate::solve::model::{self, Model, Options, Precision, Solution};
use crate::status::{Error, Notice};

/// Which forces were measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measured {
    /// The longitudinal force only.
    Fx,
    /// The lateral force only.
    Fy,
    /// Both: their resultant counts.
    Both,
}

/// A coefficient of friction from a measured force.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionEstimate<F> {
    /// Coefficient of friction \[-\]; a lower bound with KSTRIP_WARNING_FRICTION_AT_LEAST.
    pub friction: F,
    /// d(friction)/d(force) \[1/N\]: what an error of the measured force does to it; 0 for a lower bound.
    pub sensitivity: F,
    /// Distance between the measured and the computed force \[N\], of the components that were measured:
    /// rounding for one component, for both what their direction is off.
    pub residual: F,
    /// The status of this result: 0 or one of the KSTRIP_WARNING constants.
    pub notice: Notice,
    /// Zero.
    pub reserved: i32,
}

/// Friction over used friction beyond which the contact is taken to stick: the force differs by about one per cent
/// from that of linear theory there.
const STICKING: f64 = 20.0;
/// The force grows with `μ N` by less than this, and falls by less: so far a search for the force may go without passing it.
const STEEPEST: f64 = 1.5;
/// Share of friction by which the search goes on at least, where all friction is used: with the square of friction over used
/// friction it grows, as the force comes to rest, up to a limit.
const FINEST: f64 = 0.005;
const COARSEST: f64 = 0.4;
/// Places of the search at most.
const PLACES: usize = 400;
/// Parabolas that look for a turn of the force beyond the measured one.
const PARABOLAS: usize = 4;
/// Steps of false position at most.
const ROOT_STEPS: usize = 100;
/// Forces this near to `μ N`, relatively, are taken for full sliding.
const SLIDING: f64 = 1e-3;
/// Steps of Newton's method at most, each with as many trials at most.
const NEWTON_STEPS: usize = 60;
const TRIALS: usize = 8;
/// Stages towards a force that Newton's method does not reach at once.
const STAGES: usize = 24;

/// The coefficient of friction that explains a measured force at a known creepage.
///
/// The contact's own friction is ignored. Forces act on the lower body.
///
/// With [`Notice::FrictionAtLeast`] the contact sticks (it uses less than a twentieth of its friction, or the force is
/// larger than that of linear theory): the result is the used friction `|F|/N`, a lower bound. With
/// [`Notice::SeveralFrictions`] more than one friction explains the force, which may be where spin opposes the
/// creepage: the result is the smallest.
///
/// # Errors
/// Those of [`solve`](model::solve), [`Error::NotInModel`] for [`Model::Linear`], [`Error::Unexplained`].
///
/// # Example
/// ```
/// use kstrip::{contact::Contact, contact::creepage::Creepage, solve::model::{solve, Options}, rig::*};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, shear_modulus: 82e9, poisson_ratio: 0.28, friction: 0.22,
/// };
/// let creepage = Creepage { longitudinal: 2e-3, lateral: 0.0, spin: 0.1 };
/// let options = Options::default();
/// let measured = solve(&contact, &creepage, &options)?.fx;
/// let found = estimate_friction(&contact, &creepage, &options, Measured::Fx, [measured, 0.0])?;
/// assert!((found.friction - 0.22_f64).abs() < 1e-12);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn estimate_friction<F: Precision>(
    contact: &Contact<F>,
    creepage: &Creepage<F>,
    options: &Options,
    measured: Measured,
    [fx, fy]: [F; 2],
) -> Result<FrictionEstimate<F>, Error> {
    if options.model == Model::Linear {
        return Err(Error::NotInModel);
    }
    if !fx.is_finite_number() || !fy.is_finite_number() {
        return Err(Error::NotFinite);
    }
    let rest = Contact { friction: F::zero(), ..*contact };
    model::check(&rest, creepage, options)?;
    if contact.is_lost() {
        return Err(Error::Unexplained);
    }
    let rig = Rig { contact: rest, creepage, options, measured };
    let target = match measured {
        Measured::Fx => fx,
        Measured::Fy => fy,
        Measured::Both => length(fx, fy),
    };
    let load = contact.normal_force;
    let at_least = |friction| FrictionEstimate {
        friction,
        sensitivity: F::zero(),
        residual: F::zero(),
        notice: Notice::FrictionAtLeast,
        reserved: 0,
    };
    // What a little friction gives, in units of itself: the direction of full sliding
    let (_, slopes) = derivatives::solve(&rig.contact, creepage, options)?;
    let direction = match measured {
        Measured::Fx => slopes.friction[0],
        Measured::Fy => slopes.friction[1],
        Measured::Both => length(slopes.friction[0], slopes.friction[1]),
    };
    if target == F::zero() {
        // Friction is zero, unless there is no slip to show it.
        let found = FrictionEstimate { notice: Notice::None, ..at_least(F::zero()) };
        let shown = direction != F::zero();
        let sensitivity = finite_or_none(F::one() / direction);
        return Ok(if shown {
            FrictionEstimate { sensitivity, ..found }
        } else {
            at_least(F::zero())
        });
    }
    let used = target.abs() / load;
    if !used.is_finite_number() {
        return Err(Error::Unexplained);
    }
    let most = used.times(1000.0);
    model::check(&Contact { friction: most, ..rest }, creepage, options)?;
    let sign = if target > F::zero() { F::one() } else { -F::one() };
    // How much more than measured, in the sense of what was measured
    let excess = |friction: F| Ok(sign * (rig.force(friction)? - target));
    let mut brackets = 0;
    let mut bracket = None;
    let mut found = |low: [F; 2], high: [F; 2]| {
        if bracket.is_none() && low[1] <= F::zero() {
            bracket = Some(([low[0], high[0]], [low[1], high[1]]));
        }
        brackets += 1;
    };
    let mut low = [used, excess(used)?];
    let mut before = low;
    let mut best = low[1];
    for _ in 0..PLACES {
        let [at, off] = low;
        let times = at / used;
        let share = (times * times).times(FINEST).min(F::constant(COARSEST));
        let step = (off.abs() / load).times(1.0 / STEEPEST).max(at * share);
        let next = (at + step).min(most);
        let high = [next, excess(next)?];
        if (high[1] > F::zero()) != (off > F::zero()) {
            found(low, high);
        } else if let Some(turn) = turn_beyond(before, low, high, &excess)? {
            // two roots, one on either side of the turn
            let ends = if turn[0] < at { [before, low] } else { [low, high] };
            found(ends[0], turn);
            found(turn, ends[1]);
        }
        best = best.max(high[1]);
        (before, low) = (low, high);
        if next >= most {
            break;
        }
    }
    if best + target.abs() <= F::zero() {
        return Err(Error::Unexplained);
    }
    let slides = excess(used)? >= -(used * load) * F::EPSILON.times(8.0);
    let first = bracket.filter(|([low, _], _)| *low <= used.times(STICKING));
    let (friction, settled) = match first {
        _ if slides => (used, true),
        Some((ends, excesses)) => root(ends, excesses, excess)?,
        None => return Ok(at_least(used)),
    };
    let notice = if brackets > 1 {
        Notice::SeveralFrictions
    } else if !settled {
        Notice::NotConverged
    } else {
        Notice::None
    };
    let contact = Contact { friction, ..rest };
    let (solution, slopes) = derivatives::solve(&contact, creepage, options)?;
    let Solution { fx: x, fy: y, .. } = solution;
    let slope = match measured {
        Measured::Fx => slopes.friction[0],
        Measured::Fy => slopes.friction[1],
        Measured::Both => {
            let size = length(x, y) + F::TINY;
            (x / size) * slopes.friction[0] + (y / size) * slopes.friction[1]
        }
    };
    let residual = match measured {
        Measured::Fx => (x - fx).abs(),
        Measured::Fy => (y - fy).abs(),
        Measured::Both => length(x - fx, y - fy),
    };
    let sensitivity = finite_or_none(F::one() / slope);
    let own = solution.notice;
    let notice = if own.code() > notice.code() { own } else { notice };
    Ok(FrictionEstimate { friction, sensitivity, residual, notice, reserved: 0 })
}

/// Where between three places the excess turns over to the other sign, if it does: the vertices of parabolas tell.
fn turn_beyond<F: Float>(
    mut a: [F; 2],
    mut b: [F; 2],
    mut c: [F; 2],
    excess: &impl Fn(F) -> Result<F, Error>,
) -> Result<Option<[F; 2]>, Error> {
    let positive = b[1] > F::zero();
    for _ in 0..PARABOLAS {
        if a[0] >= b[0] || (a[1] > F::zero()) != positive {
            break;
        }
        let (first, second) = ((b[1] - a[1]) / (b[0] - a[0]), (c[1] - b[1]) / (c[0] - b[0]));
        let bend = (second - first) / (c[0] - a[0]);
        let slope = first + bend * (b[0] - a[0]);
        let vertex = b[0] - slope / bend.times(2.0);
        // how far it is bent away from zero, or stays on this side by as much as it has come nearer
        let value = b[1] - slope * slope / bend.times(4.0);
        let nearer = (b[1] - value).abs();
        let passes = if positive { value < nearer } else { value > -nearer };
        if (bend > F::zero()) != positive || !(vertex > a[0] && vertex < c[0]) || !passes {
            break;
        }
        let turn = [vertex, excess(vertex)?];
        if (turn[1] > F::zero()) != positive {
            return Ok(Some(turn));
        }
        if vertex == b[0] {
            break;
        }
        (a, b, c) = if vertex < b[0] { (a, turn, b) } else { (b, turn, c) };
    }
    Ok(None)
}

/// A sensitivity; zero where there is no number for it.
fn finite_or_none<F: Float>(sensitivity: F) -> F {
    if sensitivity.is_finite_number() { sensitivity } else { F::zero() }
}

struct Rig<'a, F> {
    contact: Contact<F>,
    creepage: &'a Creepage<F>,
    options: &'a Options,
    measured: Measured,
}

impl<F: Precision> Rig<'_, F> {
    /// What would be measured at a coefficient of friction.
    fn force(&self, friction: F) -> Result<F, Error> {
        let contact = Contact { friction, ..self.contact };
        let Solution { fx, fy, .. } = model::solve(&contact, self.creepage, self.options)?;
        Ok(match self.measured {
            Measured::Fx => fx,
            Measured::Fy => fy,
            Measured::Both => length(fx, fy),
        })
    }
}

/// A root of `f` between two numbers where its signs differ (the first not positive, the second not negative);
/// and whether it was found to rounding.
fn root<F: Float>(
    [mut a, mut b]: [F; 2],
    [mut f_a, mut f_b]: [F; 2],
    f: impl Fn(F) -> Result<F, Error>,
) -> Result<(F, bool), Error> {
    let mut width = (b - a).abs();
    for step in 0..ROOT_STEPS {
        if f_b == F::zero() || (b - a).abs() <= b.abs() * F::EPSILON.times(4.0) {
            return Ok((b, true));
        }
        let mut c = b - f_b * ((b - a) / (f_b - f_a));
        let (low, high) = (a.min(b), a.max(b));
        // Halve the interval where three steps did not.
        let slow = step % 3 == 2 && (b - a).abs() > width.times(0.5);
        if slow || !(c > low && c < high) {
            c = (a + b).times(0.5);
        }
        if step % 3 == 2 {
            width = (b - a).abs();
        }
        if c == a || c == b {
            return Ok((b, true));
        }
        let f_c = f(c)?;
        if (f_c > F::zero()) == (f_b > F::zero()) {
            // The other end stays, with less weight.
            let weight = F::one() - f_c / f_b;
            f_a = f_a * if weight > F::zero() { weight } else { F::constant(0.5) };
        } else {
            (a, f_a) = (b, f_b);
        }
        (b, f_b) = (c, f_c);
    }
    Ok((b, false))
}

/// The creepage `(υx, υy)` at which a contact with a given spin carries a wanted force `(F_x, F_y)` on the lower body.
///
/// With [`Notice::CreepageAtLeast`] the force is within 0.1 % of `μ N`: the result is where it comes as near as that,
/// and larger creepages do as well.
///
/// # Errors
/// Those of [`solve`](model::solve), [`Error::ForceBeyondFriction`].
///
/// # Example
/// ```
/// use kstrip::{contact::Contact, solve::model::{solve, Options}, rig::creepage_for_force};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, shear_modulus: 82e9, poisson_ratio: 0.28, friction: 0.3,
/// };
/// let options = Options::default();
/// let (creepage, _) = creepage_for_force(&contact, [15e3, -2e3], 0.1_f64, &options)?;
/// let forces = solve(&contact, &creepage, &options)?;
/// assert!((forces.fx - 15e3).abs() < 1e-6 && (forces.fy + 2e3).abs() < 1e-6);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn creepage_for_force<F: Precision>(
    contact: &Contact<F>,
    force: [F; 2],
    spin: F,
    options: &Options,
) -> Result<(Creepage<F>, Notice), Error> {
    let none = Creepage { longitudinal: F::zero(), lateral: F::zero(), spin };
    model::check(contact, &none, options)?;
    let [fx, fy] = force;
    if !fx.is_finite_number() || !fy.is_finite_number() {
        return Err(Error::NotFinite);
    }
    let size = length(fx, fy);
    if contact.is_lost() {
        let fits = size <= F::zero();
        return if fits { Ok((none, Notice::None)) } else { Err(Error::ForceBeyondFriction) };
    }
    let bound = contact.friction_bound();
    let mut target = force;
    let mut sliding = false;
    if options.model != Model::Linear {
        if size > bound * (F::one() + F::EPSILON.times(4.0)) {
            return Err(Error::ForceBeyondFriction);
        }
        let most = bound.times(1.0 - SLIDING);
        sliding = size >= most;
        if sliding {
            if bound <= F::zero() {
                return Ok((none, Notice::CreepageAtLeast));
            }
            target = force.map(|part| part / size * most);
        }
    }
    let (mut creepage, mut settled) = newton(contact, target, none, options)?;
    if !settled {
        let at_rest = model::solve(contact, &none, options)?;
        let [to_x, to_y] = target;
        let mut stage = none;
        for i in 1..=STAGES {
            let share = F::of_f32(i as f32) / F::constant(STAGES as f64);
            let on_the_way = [
                at_rest.fx + (to_x - at_rest.fx) * share,
                at_rest.fy + (to_y - at_rest.fy) * share,
            ];
            (stage, settled) = newton(contact, on_the_way, stage, options)?;
        }
        if settled {
            creepage = stage;
        }
    }
    let own = model::solve(contact, &creepage, options)?.notice;
    Ok((
        creepage,
        if !settled {
            Notice::NotConverged
        } else if sliding {
            Notice::CreepageAtLeast
        } else {
            own
        },
    ))
}

/// From the linear answer to the creepage of a force; and whether it was reached.
fn newton<F: Precision>(
    contact: &Contact<F>,
    [fx, fy]: [F; 2],
    start: Creepage<F>,
    options: &Options,
) -> Result<(Creepage<F>, bool), Error> {
    let mut creepage = start;
    let (mut solution, mut jacobian) = model::solve_jacobian(contact, &creepage, options)?;
    // Everything in units of the forces and of the slip that is typical for them
    let linear = options.model == Model::Linear;
    let unit = if linear {
        length(fx, fy) + length(solution.fx, solution.fy)
    } else {
        contact.friction_bound()
    } + F::TINY;
    let slip = unit / (contact.shear_modulus * contact.a * contact.b);
    let slip = if slip.is_finite_number() && slip > F::zero() { slip } else { F::one() };
    let error = |solution: &Solution<F>| [(solution.fx - fx) / unit, (solution.fy - fy) / unit];
    let mut off = error(&solution);
    // Levenberg and Marquardt: how much shorter than Newton's the step is where slopes are small
    let mut damping = F::zero();
    for _ in 0..NEWTON_STEPS {
        let distance = length(off[0], off[1]);
        if distance <= F::EPSILON.times(16.0) {
            return Ok((creepage, true));
        }
        let [xx, xy, yx, yy] = [jacobian.m11, jacobian.m12, jacobian.m21, jacobian.m22]
            .map(|slope| slope / unit * slip);
        // (Jᵀ J + λ) Δ = −Jᵀ off
        let size = xx * xx + xy * xy + yx * yx + yy * yy;
        let right = [-(xx * off[0] + yx * off[1]), -(xy * off[0] + yy * off[1])];
        let (p, q, r) = (xx * xx + yx * yx, xx * xy + yx * yy, xy * xy + yy * yy);
        // A step longer than what it starts from leaves what the slopes know.
        let now = length(creepage.longitudinal / slip, creepage.lateral / slip);
        let longest = if linear { F::HUGE } else { now.plus(1.0) };
        let mut closer = false;
        for _ in 0..TRIALS {
            let (p, r) = (p + damping * size, r + damping * size);
            let determinant = if damping > F::zero() {
                p * r - q * q
            } else {
                // det(Jᵀ J) without cancellation
                (xx * yy - xy * yx).squared()
            } + F::TINY;
            let mut step = [
                (r * right[0] - q * right[1]) / determinant,
                (p * right[1] - q * right[0]) / determinant,
            ];
            let size = length(step[0], step[1]);
            if !(size <= longest) {
                step = step.map(|part| part / size * longest);
            }
            let next = Creepage {
                longitudinal: creepage.longitudinal + step[0] * slip,
                lateral: creepage.lateral + step[1] * slip,
                spin: creepage.spin,
            };
            if next.check().is_err() {
                break;
            }
            let (next_solution, next_jacobian) = model::solve_jacobian(contact, &next, options)?;
            let next_off = error(&next_solution);
            if length(next_off[0], next_off[1]) < distance {
                (creepage, solution, jacobian) = (next, next_solution, next_jacobian);
                off = error(&solution);
                closer = true;
                damping = if damping > F::constant(1e-6) { damping.times(0.1) } else { F::zero() };
                break;
            }
            damping = damping.times(8.0).max(F::constant(1e-5));
        }
        if !closer {
            break;
        }
    }
    Ok((creepage, length(off[0], off[1]) <= F::EPSILON.times(1e4)))
}
