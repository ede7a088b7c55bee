//! From a requested force to the creepage.
//!
//! Newton's method on what the force would be without saturation: with `t = |F|/(μ N)`
//!
//! ```text
//! L(F) = 3 (1 − ∛(1 − t)) F/|F|
//! ```
//!
//! is proportional to the creepage in the theory of Vermeulen and Johnson (J. Appl. Mech. 31 (1964)
//! 338), and nearly so here. From the second step on the model of the force is not only its slopes
//! but the cubics through the last two places, as a tensor method has it (Schnabel and Frank, SIAM
//! J. Numer. Anal. 21 (1984) 815), because the slopes alone are nearly singular where spin and
//! creepage make the force turn back: its folds. A step leads closer if the error falls, or if the
//! next step is shorter: near folds and jumps the error measures the direction of the force alone,
//! and a step that brings the creepage nearer may make it grow (natural monotonicity: Deuflhard,
//! Newton Methods for Nonlinear Problems, Springer 2004). A step that leads no closer is shortened
//! to where the cubic through both ends crosses zero, or damped; one that leads beyond a fold is
//! halved, because the requested force is mostly found before the force falls again. If the search
//! makes no progress, or no step leads closer to a force that is almost reached, it starts again
//! elsewhere along the requested force.

use crate::contact::Contact;
use crate::contact::creepage::Creepage;
use crate::forces::{Model, Options};
use crate::friction::derivatives::{Differentiated, differentiate_with_law};
use crate::friction::{InMotion, SlipFriction};
use crate::number::{Float, are_finite, length};
use crate::numerics::bracket::root;
use crate::numerics::{Bracket, Cubic};
use crate::status::{Error, Warning};

/// Relative distance from `μ N` up to which a force counts as full sliding.
const FULL_SLIDING: f64 = 1e-3;
/// Largest number of solutions.
const MOST_CREEPAGES: usize = 40;
/// Number of solutions in a row that do not halve the error, after which the search starts again:
/// along the requested force, at `START_CREEPAGES` times the creepage where the first start ended,
/// which counts at least as `NEAREST` units of slip.
const IDLE: usize = 6;
const START_CREEPAGES: [f64; 7] = [1.15, 1.5, 2.0, 0.6, 4.0, 0.3, 8.0];
const NEAREST: f64 = 0.3;
/// Largest ratio of the next step to this one with which this one is accepted.
const STEP_RATIO: f64 = 0.8;
/// Error below which no step is damped: the force falls again, and the root lies beyond.
const CLOSE: f64 = 0.1;
/// Damping, divided by the sum of the squares of the slopes, if the plain step leads no closer, and
/// the factor by which the damping grows.
const DAMPING: f64 = 0.03;
const DAMPING_GROWTH: f64 = 10.0;
/// Least slope of the cubic that gives the length of a step along the cubics through the last two
/// places; with less the plain step is taken.
const LEAST_CUBIC_SLOPE: f64 = 0.1;
/// Distances from the requested force divided by `μ N`, in roundings: the search ends; a place is
/// left to rounding; a place is still accepted.
const REACHED: f64 = 16.0;
const ROUNDING: f64 = 5e3;
const TAKEN: f64 = 1e4;

/// The creepage `(υx, υy)` at which a contact with a given spin carries a requested force
/// `(F_x, F_y)` on the lower body.
///
/// Under a law the contact's own coefficient of friction is ignored. Where friction falls with the
/// slip, a force that is too large is not reached: [`Warning::NotConverged`].
///
/// The comment of `kstrip_creepage_for_force` explains the warnings, and which of several creepages
/// is found. The search takes at most 40 solutions.
///
/// # Errors
/// Those of [`forces_of_contact`](crate::forces::forces_of_contact) and [`SlipFriction::check`],
/// [`Error::ForceBeyondFriction`].
///
/// # Example
/// ```
/// use kstrip::forces::{Options, forces_of_contact};
/// use kstrip::{contact::Contact, rig::creepage_for_force};
/// let contact = Contact {
///     a: 6e-3, b: 4e-3, normal_force: 80e3, friction: 0.3,
///     shear_modulus: 82e9, poisson_ratio: 0.28, mismatch: 0.0,
/// };
/// let options = Options::default();
/// let (creepage, _) = creepage_for_force(&contact, [15e3, -2e3], 0.1_f64, None, &options)?;
/// let forces = forces_of_contact(&contact, &creepage, &options)?;
/// assert!((forces.fx - 15e3).abs() < 1e-6 && (forces.fy + 2e3).abs() < 1e-6);
/// # Ok::<(), kstrip::status::Error>(())
/// ```
pub fn creepage_for_force<F: Float>(
    contact: &Contact<F>, force: [F; 2], spin: F, law: Option<&SlipFriction<F>>, options: &Options,
) -> Result<(Creepage<F>, Warning), Error> {
    let none = Creepage { spin, ..Creepage::default() };
    InMotion { creepage: &none, law, options }.check(contact)?;
    let contact = &law.map_or(*contact, |law| Contact { friction: law.friction, ..*contact });
    let [fx, fy] = force;
    Error::NotFinite.unless(are_finite(&force))?;
    let size = length(fx, fy);
    if contact.is_lost() {
        return Error::ForceBeyondFriction
            .unless(size <= F::zero())
            .map(|()| (none, Warning::None));
    }
    let (bound, saturates) = (contact.friction_bound(), options.model != Model::Linear);
    let (largest, most) =
        (bound * F::EPSILON.times(4.0).plus(1.0), bound.times(1.0 - FULL_SLIDING));
    Error::ForceBeyondFriction.unless(!saturates || size <= largest)?;
    let falls = law.is_some_and(SlipFriction::falls);
    let sliding = saturates && !falls && size >= most;
    if sliding && bound <= F::zero() {
        return Ok((none, Warning::CreepageAtLeast));
    }
    let target = if sliding { force.map(|part| part / size * most) } else { force };
    let mut aim = Aim::new(contact, target, spin, law, options);
    let found = aim.find()?;
    let settled = found.distance <= F::EPSILON.times(TAKEN);
    let warnings = [(!settled, Warning::NotConverged), (sliding, Warning::CreepageAtLeast)];
    let warning = Warning::first(&warnings);
    Ok((aim.creepage(found.at), warning.worse(found.warning)))
}

/// A contact and the force that is requested of it.
pub(crate) struct Aim<'a, F> {
    contact: &'a Contact<F>,
    law: Option<&'a SlipFriction<F>>,
    options: &'a Options,
    spin: F,
    /// Over the unit.
    target: [F; 2],
    /// `μ N`; of the linear theory the size of the forces.
    unit: F,
    /// The unit divided by `G a b`.
    slip: F,
    saturates: bool,
    /// Solutions so far.
    pub(crate) solved: usize,
}

/// A creepage with its error and the derivatives of this.
#[derive(Clone, Copy)]
pub(crate) struct Iterate<F> {
    /// `(υx, υy)` divided by the unit of slip
    pub(crate) at: [F; 2],
    /// `L(F) − L(target)`
    error: [F; 2],
    /// Its derivatives, row by row.
    slopes: [[F; 2]; 2],
    /// The size of the error.
    off: F,
    /// `|F − target|` divided by the unit
    pub(crate) distance: F,
    warning: Warning,
}

/// `L(F)` of a force divided by `μ N`, and its derivatives.
fn unsaturated<F: Float>([x, y]: [F; 2]) -> ([F; 2], [[F; 2]; 2]) {
    let t = length(x, y);
    // c³ = 1 − t, L = k F with k = 3 (1 − c)/t = 3/(1 + c + c²), d|L|/dt = 1/c²
    let c = (F::one() - t).max(F::EPSILON).cube_root();
    let k = F::constant(3.0) / (F::one() + c + c * c);
    let stretch = F::one() / (c * c) - k;
    let over = t + F::TINY;
    let (x, y) = (x / over, y / over);
    let mixed = stretch * x * y;
    let slopes = [[k + stretch * x * x, mixed], [mixed, k + stretch * y * y]];
    ([x * t * k, y * t * k], slopes)
}

impl<F: Float> Iterate<F> {
    fn determinant(&self) -> F {
        let [[xx, xy], [yx, yy]] = self.slopes;
        xx * yy - xy * yx
    }

    /// Whether the next step, `J⁻¹ error`, is shorter than the one that has led here.
    fn contracts(&self, step: [F; 2]) -> bool {
        let ([x, y], [[xx, xy], [yx, yy]]) = (self.error, self.slopes);
        let size = length(yy * x - xy * y, xx * y - yx * x);
        size < self.determinant() * length(step[0], step[1]).times(STEP_RATIO)
    }

    /// Whether the force falls again on the way: the derivatives have another orientation than at
    /// rest and at the place before.
    fn is_beyond_a_fold_from(&self, before: &Self) -> bool {
        self.determinant() <= F::zero() && before.determinant() > F::zero()
    }
}

fn rows_times<F: Float>(rows: &[[F; 2]; 2], [x, y]: [F; 2]) -> [F; 2] {
    rows.map(|[by_x, by_y]| by_x * x + by_y * y)
}

impl<'a, F: Float> Aim<'a, F> {
    /// Of a contact with load and, unless the theory is linear, friction.
    pub(crate) fn new(
        contact: &'a Contact<F>, target: [F; 2], spin: F, law: Option<&'a SlipFriction<F>>,
        options: &'a Options,
    ) -> Self {
        let saturates = options.model != Model::Linear;
        let Contact { a, b, shear_modulus, .. } = *contact;
        // about as flexible as the law makes it
        let factor = law.map_or(F::one(), |law| {
            let layer = law.interface(shear_modulus, a).layer;
            law.slope_or_one() / layer.times(1.6).plus(1.0)
        });
        let stiffness = shear_modulus * a * b * factor;
        let unit = if saturates {
            contact.friction_bound()
        } else {
            length(target[0], target[1]) + stiffness * (a * b).sqrt() * spin.abs() + F::TINY
        };
        let slip = unit / stiffness;
        let slip = if slip.is_finite_number() && slip > F::zero() { slip } else { F::one() };
        let target = target.map(|part| part / unit);
        Self { contact, law, options, spin, target, unit, slip, saturates, solved: 0 }
    }

    pub(crate) fn creepage(&self, [x, y]: [F; 2]) -> Creepage<F> {
        Creepage { longitudinal: x * self.slip, lateral: y * self.slip, spin: self.spin }
    }

    fn iterate_at(&mut self, at: [F; 2]) -> Result<Iterate<F>, Error> {
        self.solved += 1;
        let creepage = self.creepage(at);
        let Differentiated { solution, derivatives, .. } =
            differentiate_with_law(self.contact, &creepage, self.law, self.options)?;
        let [[xx, xy, _], [yx, yy, _], _] = derivatives.jacobian;
        let force = [solution.fx / self.unit, solution.fy / self.unit];
        let rows = [[xx, xy], [yx, yy]].map(|row| row.map(|slope| slope / self.unit * self.slip));
        let [to_x, to_y] = self.target;
        let distance = length(force[0] - to_x, force[1] - to_y);
        let (error, slopes) = if self.saturates {
            let ([x, y], [of_x, of_y]) = unsaturated(force);
            let ([wanted_x, wanted_y], _) = unsaturated(self.target);
            let [[xx, xy], [yx, yy]] = rows;
            let columns = [[xx, yx], [xy, yy]];
            ([x - wanted_x, y - wanted_y], [rows_times(&columns, of_x), rows_times(&columns, of_y)])
        } else {
            ([force[0] - to_x, force[1] - to_y], rows)
        };
        let off = length(error[0], error[1]);
        Ok(Iterate { at, error, slopes, off, distance, warning: solution.warning })
    }

    /// The creepage of the requested force, or the nearest one that was found.
    pub(crate) fn find(&mut self) -> Result<Iterate<F>, Error> {
        let start = self.iterate_at([F::zero(); 2])?;
        let mut best = self.follow(start);
        let reach = length(best.at[0], best.at[1]).max(F::constant(NEAREST));
        let size = length(self.target[0], self.target[1]) + F::TINY;
        let direction = self.target.map(|part| part / size);
        for larger in START_CREEPAGES.map(F::constant) {
            if best.distance <= F::EPSILON.times(TAKEN) || self.solved >= MOST_CREEPAGES {
                break;
            }
            let Ok(start) = self.iterate_at(direction.map(|part| part * (reach * larger))) else {
                break;
            };
            if start.determinant() <= F::zero() {
                continue;
            }
            let found = self.follow(start);
            if found.distance < best.distance {
                best = found;
            }
        }
        Ok(best)
    }

    /// Takes steps from a creepage, as long as they lead closer.
    fn follow(&mut self, start: Iterate<F>) -> Iterate<F> {
        let (mut place, mut before) = (start, None);
        let (mut share, mut damping) = (F::one(), F::zero());
        let (mut mark, mut idle) = (start.off, 0);
        while self.solved < MOST_CREEPAGES
            && idle < IDLE
            && place.distance > F::EPSILON.times(REACHED)
        {
            let Iterate { at, error, off, distance, .. } = place;
            let step = self.newton_step(&place, before.as_ref(), damping).map(|part| part * share);
            let Ok(next) = self.iterate_at([at[0] + step[0], at[1] + step[1]]) else { break };
            let halves = next.off < mark.times(0.5);
            (mark, idle) = if halves { (next.off, 0) } else { (mark, idle + 1) };
            let near = distance <= F::EPSILON.times(ROUNDING);
            let contracts = !near && next.contracts(step);
            let closer = next.off < off || contracts || next.distance <= F::EPSILON.times(REACHED);
            if closer && (near || !next.is_beyond_a_fold_from(&place)) {
                (before, place, share, damping) = (Some(place), next, F::one(), F::zero());
                if near && next.distance > distance.times(0.1) {
                    break;
                }
            } else if near {
                break;
            } else {
                // along the error, which the step is to make zero
                let along = |[x, y]: [F; 2]| (x * error[0] + y * error[1]) / off;
                let beyond = along(next.error);
                if beyond < F::zero() {
                    let slopes =
                        [place.slopes, next.slopes].map(|rows| along(rows_times(&rows, step)));
                    let cubic = Cubic::new([off, beyond], slopes);
                    let between = Bracket { negative: F::one(), positive: F::zero() };
                    let shorter = root(between, |t| [cubic.value_at(t), cubic.slope(t)]);
                    share = share * shorter.clamped(F::constant(0.05), F::constant(0.95));
                } else if closer {
                    share = share.times(0.5);
                } else if off < F::constant(CLOSE) {
                    break;
                } else {
                    (before, share) = (None, F::one());
                    damping = damping.times(DAMPING_GROWTH).max(F::constant(DAMPING));
                }
            }
        }
        place
    }

    /// One step of Newton's method, `(Jᵀ J + λ) Δ = −Jᵀ error`; with a place before this one along
    /// the cubics through both.
    fn newton_step(&self, place: &Iterate<F>, before: Option<&Iterate<F>>, damping: F) -> [F; 2] {
        let Iterate { at, error, slopes: [[xx, xy], [yx, yy]], .. } = *place;
        let (p, q, r) = (xx * xx + yx * yx, xx * xy + yx * yy, xy * xy + yy * yy);
        let added = damping * (p + r);
        let plain = place.determinant();
        // det(Jᵀ J + λ) without cancellation
        let determinant = plain * plain + added * (p + r + added) + F::TINY;
        let solve = |[x, y]: [F; 2]| {
            let (x, y) = (xx * x + yx * y, xy * x + yy * y);
            [((r + added) * x - q * y) / determinant, ((p + added) * y - q * x) / determinant]
        };
        let mut step = solve(error.map(|part| -part));
        if let Some(bent) = before.and_then(|before| bent(place, before, step, solve)) {
            step = bent;
        }
        if self.saturates {
            // A step longer than what it starts from leaves the range of the derivatives.
            let (size, longest) =
                (length(step[0], step[1]), length(at[0], at[1]).plus(1.0).times(2.0));
            if !(size <= longest) {
                step = step.map(|part| part / size * longest);
            }
        }
        step
    }
}

/// The step `Δ` that takes `error + J Δ + τ² c₂ + τ³ c₃` to zero, where `τ` is the part of `Δ`
/// along the way back to the place before: the cubics along this way have the errors and the slopes
/// of both places. None where it is far from the plain step.
fn bent<F: Float>(
    place: &Iterate<F>, before: &Iterate<F>, plain: [F; 2], solve: impl Fn([F; 2]) -> [F; 2],
) -> Option<[F; 2]> {
    let less = |[a, b]: [F; 2], [c, d]: [F; 2]| [a - c, b - d];
    let back = less(before.at, place.at);
    let grown = less(before.error, place.error);
    let here = less(rows_times(&place.slopes, back), grown);
    let there = less(rows_times(&before.slopes, back), grown);
    // J⁻¹ c₂ and J⁻¹ c₃
    let second = solve([-here[0].times(2.0) - there[0], -here[1].times(2.0) - there[1]]);
    let third = solve([here[0] + there[0], here[1] + there[1]]);
    let squared = back[0] * back[0] + back[1] * back[1] + F::TINY;
    let share = |[x, y]: [F; 2]| (x * back[0] + y * back[1]) / squared;
    // τ + c τ² + d τ³ = e, by Newton's method from the plain step
    let (c, d, e) = (share(second), share(third), share(plain));
    let mut t = e;
    for _ in 0..4 {
        let slope = F::one() + t * (c.times(2.0) + t * d.times(3.0));
        if !(slope > F::constant(LEAST_CUBIC_SLOPE)) {
            return None;
        }
        t = t - (t * (F::one() + t * (c + t * d)) - e) / slope;
    }
    let change = [t * t * (second[0] + t * third[0]), t * t * (second[1] + t * third[1])];
    let near = length(change[0], change[1]) < length(plain[0], plain[1]);
    (near && t.abs() < F::one()).then(|| less(plain, change))
}
